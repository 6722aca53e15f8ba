# Made by `coscrew generate`; changes are overwritten.
# SPDX-License-Identifier: MIT
# coscrew 0.2.0.  Copyright (c) 2026 The coscrew authors.
"""Products between rotations, displacements and vectors.

In single precision, certified tier.  A twin(f, …) is f of double precision with these constants.
"""

from coscrew._twins import single_twins
from coscrew.certified import double

twin = single_twins(__name__, quiet=True)

product_drv = twin(double.product_drv, c1=1.9721522630525295e-31, c2=1.7881396e-07)
product_drvinv = twin(double.product_drvinv, c1=1.9721522630525295e-31, c2=1.7881396e-07)
product_drinvv = twin(double.product_drinvv, c1=1.9721522630525295e-31, c2=1.7881396e-07)
product_drinvvinv = twin(double.product_drinvvinv, c1=1.9721522630525295e-31, c2=1.7881396e-07)
product_dv = twin(double.product_dv, c1=1.9721522630525295e-31, c2=2.3841864e-07)
product_dinvv = twin(double.product_dinvv, c1=1.9721522630525295e-31, c2=2.3841864e-07)
product_drdr = twin(double.product_drdr, c1=1.9721522630525295e-31, c2=1.7881396e-07)
product_drdrinv = twin(double.product_drdrinv, c1=1.9721522630525295e-31, c2=1.7881396e-07)
product_drinvdr = twin(double.product_drinvdr, c1=1.9721522630525295e-31, c2=1.7881396e-07)
product_dd = twin(double.product_dd, c1=1.9721522630525295e-31, c2=1.7881396e-07, c3=2.3841864e-07)
product_ddinv = twin(double.product_ddinv, c1=1.9721522630525295e-31, c2=1.7881396e-07,
    c3=4.1723263e-07)
product_dinvd = twin(double.product_dinvd, c1=1.9721522630525295e-31, c2=1.7881396e-07,
    c3=2.3841864e-07)
product_ddr = twin(double.product_ddr, c1=1.9721522630525295e-31, c2=1.7881396e-07)
product_ddrinv = twin(double.product_ddrinv, c1=1.9721522630525295e-31, c2=1.7881396e-07)
product_ddt = twin(double.product_ddt, c1=1.9721522630525295e-31, c2=2.3841864e-07)
product_ddtinv = twin(double.product_ddtinv, c1=1.9721522630525295e-31, c2=2.3841864e-07)
product_dinvdt = twin(double.product_dinvdt, c1=1.9721522630525295e-31, c2=2.3841864e-07)
product_drvtx = twin(double.product_drvtx, c1=1.9721522630525295e-31, c2=5.960465e-08)
product_drdrx = twin(double.product_drdrx, c1=1.9721522630525295e-31, c2=1.192093e-07)
product_ddrx = twin(double.product_ddrx, c1=1.9721522630525295e-31, c2=1.192093e-07)
product_ddtx = twin(double.product_ddtx, c1=1.9721522630525295e-31, c2=1.192093e-07)
product_drvtxinv = twin(double.product_drvtxinv, c1=1.9721522630525295e-31, c2=5.960465e-08)
product_drdrxinv = twin(double.product_drdrxinv, c1=1.9721522630525295e-31, c2=1.192093e-07)
product_ddrxinv = twin(double.product_ddrxinv, c1=1.9721522630525295e-31, c2=1.192093e-07)
product_ddtxinv = twin(double.product_ddtxinv, c1=1.9721522630525295e-31, c2=1.192093e-07)
product_drvty = twin(double.product_drvty, c1=1.9721522630525295e-31, c2=5.960465e-08)
product_drdry = twin(double.product_drdry, c1=1.9721522630525295e-31, c2=1.192093e-07)
product_ddry = twin(double.product_ddry, c1=1.9721522630525295e-31, c2=1.192093e-07)
product_ddty = twin(double.product_ddty, c1=1.9721522630525295e-31, c2=1.192093e-07)
product_drvtyinv = twin(double.product_drvtyinv, c1=1.9721522630525295e-31, c2=5.960465e-08)
product_drdryinv = twin(double.product_drdryinv, c1=1.9721522630525295e-31, c2=1.192093e-07)
product_ddryinv = twin(double.product_ddryinv, c1=1.9721522630525295e-31, c2=1.192093e-07)
product_ddtyinv = twin(double.product_ddtyinv, c1=1.9721522630525295e-31, c2=1.192093e-07)
product_drvtz = twin(double.product_drvtz, c1=1.9721522630525295e-31, c2=5.960465e-08)
product_drdrz = twin(double.product_drdrz, c1=1.9721522630525295e-31, c2=1.192093e-07)
product_ddrz = twin(double.product_ddrz, c1=1.9721522630525295e-31, c2=1.192093e-07)
product_ddtz = twin(double.product_ddtz, c1=1.9721522630525295e-31, c2=1.192093e-07)
product_drvtzinv = twin(double.product_drvtzinv, c1=1.9721522630525295e-31, c2=5.960465e-08)
product_drdrzinv = twin(double.product_drdrzinv, c1=1.9721522630525295e-31, c2=1.192093e-07)
product_ddrzinv = twin(double.product_ddrzinv, c1=1.9721522630525295e-31, c2=1.192093e-07)
product_ddtzinv = twin(double.product_ddtzinv, c1=1.9721522630525295e-31, c2=1.192093e-07)
