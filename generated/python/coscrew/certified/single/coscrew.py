# Made by `coscrew generate`; changes are overwritten.
# SPDX-License-Identifier: MIT
# coscrew 0.2.0.  Copyright (c) 2026 The coscrew authors.
"""Coscrews: wrenches and momenta, c = (f; τ).

In single precision, certified tier.  A twin(f, …) is f of double precision with these constants.
"""

from coscrew._twins import single_twins
from coscrew.certified import double

twin = single_twins(__name__, quiet=True)

coscrew_scale = twin(double.coscrew_scale, c1=1.9721522630525295e-31, c2=5.960465e-08)
axpy_cc = twin(double.axpy_cc, c1=1.9721522630525295e-31, c2=1.192093e-07)
xpy_cc = twin(double.xpy_cc, c1=5.960465e-08)
nxpy_cc = twin(double.nxpy_cc, c1=5.960465e-08)
product_ac = twin(double.product_ac, c1=1.9721522630525295e-31, c2=5.960465e-08)
add_cc = twin(double.add_cc, c3=5.960465e-08)
subtract_cc = twin(double.subtract_cc, c3=5.960465e-08)
add_cct = twin(double.add_cct, c3=5.960465e-08)
product_CoAdtc = twin(double.product_CoAdtc, c1=1.9721522630525295e-31, c2=1.7881396e-07)
product_CoAdtinvc = twin(double.product_CoAdtinvc, c1=1.9721522630525295e-31, c2=1.7881396e-07)
product_CoAdtcinv = twin(double.product_CoAdtcinv, c1=1.9721522630525295e-31, c2=1.7881396e-07)
product_CoAdrc = twin(double.product_CoAdrc, c1=1.9721522630525295e-31, c2=1.7881396e-07)
product_CoAdrinvc = twin(double.product_CoAdrinvc, c1=1.9721522630525295e-31, c2=1.7881396e-07)
product_CoAdrcinv = twin(double.product_CoAdrcinv, c1=1.9721522630525295e-31, c2=1.7881396e-07)
product_CoAdc = twin(double.product_CoAdc, c1=1.9721522630525295e-31, c2=1.7881396e-07,
    c3=3.5762795e-07)
product_CoAdinvc = twin(double.product_CoAdinvc, c1=1.9721522630525295e-31, c2=1.7881396e-07,
    c3=3.5762795e-07)
product_CoAdcinv = twin(double.product_CoAdcinv, c1=1.9721522630525295e-31, c2=1.7881396e-07,
    c3=3.5762795e-07)
hctx = twin(double.hctx, c1=1.9721522630525295e-31, c2=1.192093e-07)
hcty = twin(double.hcty, c1=1.9721522630525295e-31, c2=1.192093e-07)
hctz = twin(double.hctz, c1=1.9721522630525295e-31, c2=1.192093e-07)
hctxinv = twin(double.hctxinv, c1=1.9721522630525295e-31, c2=1.192093e-07)
hctyinv = twin(double.hctyinv, c1=1.9721522630525295e-31, c2=1.192093e-07)
hctzinv = twin(double.hctzinv, c1=1.9721522630525295e-31, c2=1.192093e-07)
CoAd = twin(double.CoAd, c1=1.9721522630525295e-31, c2=1.192093e-07)
reciprocal_product = twin(double.reciprocal_product, c1=1.9721522630525295e-31, c2=2.3841864e-07)
cross_sc = twin(double.cross_sc, c1=1.9721522630525295e-31, c2=1.192093e-07, c3=1.7881396e-07)
cross_sca = twin(double.cross_sca, c1=1.9721522630525295e-31, c2=1.192093e-07)
constraint_ctx = twin(double.constraint_ctx, c1=1.9721522630525295e-31, c2=1.192093e-07,
    c3=2.9802328e-07)
constraint_cty = twin(double.constraint_cty, c1=1.9721522630525295e-31, c2=1.192093e-07,
    c3=2.9802328e-07)
constraint_ctz = twin(double.constraint_ctz, c1=1.9721522630525295e-31, c2=1.192093e-07,
    c3=2.9802328e-07)
constraint_crx = twin(double.constraint_crx, c1=1.9721522630525295e-31, c2=1.7881396e-07,
    c3=3.5762795e-07)
constraint_cry = twin(double.constraint_cry, c1=1.9721522630525295e-31, c2=1.7881396e-07,
    c3=3.5762795e-07)
constraint_crz = twin(double.constraint_crz, c1=1.9721522630525295e-31, c2=1.7881396e-07,
    c3=3.5762795e-07)
working_ctx = twin(double.working_ctx, c1=1.9721522630525295e-31, c2=5.960465e-08, c3=1.7881396e-07)
working_cty = twin(double.working_cty, c1=1.9721522630525295e-31, c2=5.960465e-08, c3=1.7881396e-07)
working_ctz = twin(double.working_ctz, c1=1.9721522630525295e-31, c2=5.960465e-08, c3=1.7881396e-07)
working_crx = twin(double.working_crx, c1=1.9721522630525295e-31, c2=5.960465e-08)
working_cry = twin(double.working_cry, c1=1.9721522630525295e-31, c2=5.960465e-08)
working_crz = twin(double.working_crz, c1=1.9721522630525295e-31, c2=5.960465e-08)
