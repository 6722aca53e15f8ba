# Made by `coscrew generate`; changes are overwritten.
# SPDX-License-Identifier: MIT
# coscrew 0.2.0.  Copyright (c) 2026 The coscrew authors.
"""Detects a build of the extension, or a state of the process, that breaks the promised bits."""

import numpy as np

import coscrew


def selfcheck() -> list[str]:
    """Problems of floating-point arithmetic in this process, in words; empty if there are none.

    Tests for contraction (fused products and sums) and flush-to-zero (which a library compiled with
    -ffast-math sets for the whole process), and compares the bits of a kernel with its NumPy twin.
    """
    found = []
    for twin in (coscrew.double, coscrew.single, ):
        dtype = twin.product_CoAdc(np.eye(3, 4), np.zeros(6)).dtype
        limits = np.finfo(dtype)
        name = dtype.name
        x = dtype.type(1 + 2.0 ** -(limits.nmant // 2 + 1))  # its square is not representable
        ones = np.ones((64, 6), dtype)
        if coscrew.axpy_cc(x, ones * x, ones * -(x * x)).any():
            found.append(f"contraction: products and sums are fused in {name}")
        if not coscrew.product_ac(dtype.type(0.5), ones * limits.smallest_normal).all():
            found.append(f"flush-to-zero: subnormal results become zero in {name}")
        numbers = np.random.default_rng(1)
        D = numbers.normal(size=(64, 3, 4)).astype(dtype)
        c = numbers.normal(size=(64, 6)).astype(dtype)
        product = coscrew.unchecked(coscrew.product_CoAdc)  # of any matrices
        if product(D, c).tobytes() != twin.product_CoAdc(D, c).tobytes():
            found.append(f"product_CoAdc differs from its NumPy twin in {name}")
    return found
