# Made by `coscrew generate`; changes are overwritten.
# SPDX-License-Identifier: MIT
# coscrew 0.2.0.  Copyright (c) 2026 The coscrew authors.
"""Products between rotations, displacements and vectors.

In single precision, plain tier.  A twin(f, …) is f of double precision with these constants.
"""

from coscrew._twins import single_twins
from coscrew import double

twin = single_twins(__name__)

product_drv = twin(double.product_drv)
product_drvinv = twin(double.product_drvinv)
product_drinvv = twin(double.product_drinvv)
product_drinvvinv = twin(double.product_drinvvinv)
product_dv = twin(double.product_dv)
product_dinvv = twin(double.product_dinvv)
product_drdr = twin(double.product_drdr)
product_drdrinv = twin(double.product_drdrinv)
product_drinvdr = twin(double.product_drinvdr)
product_dd = twin(double.product_dd)
product_ddinv = twin(double.product_ddinv)
product_dinvd = twin(double.product_dinvd)
product_ddr = twin(double.product_ddr)
product_ddrinv = twin(double.product_ddrinv)
product_ddt = twin(double.product_ddt)
product_ddtinv = twin(double.product_ddtinv)
product_dinvdt = twin(double.product_dinvdt)
product_drvtx = twin(double.product_drvtx)
product_drdrx = twin(double.product_drdrx)
product_ddrx = twin(double.product_ddrx)
product_ddtx = twin(double.product_ddtx)
product_drvtxinv = twin(double.product_drvtxinv)
product_drdrxinv = twin(double.product_drdrxinv)
product_ddrxinv = twin(double.product_ddrxinv)
product_ddtxinv = twin(double.product_ddtxinv)
product_drvty = twin(double.product_drvty)
product_drdry = twin(double.product_drdry)
product_ddry = twin(double.product_ddry)
product_ddty = twin(double.product_ddty)
product_drvtyinv = twin(double.product_drvtyinv)
product_drdryinv = twin(double.product_drdryinv)
product_ddryinv = twin(double.product_ddryinv)
product_ddtyinv = twin(double.product_ddtyinv)
product_drvtz = twin(double.product_drvtz)
product_drdrz = twin(double.product_drdrz)
product_ddrz = twin(double.product_ddrz)
product_ddtz = twin(double.product_ddtz)
product_drvtzinv = twin(double.product_drvtzinv)
product_drdrzinv = twin(double.product_drdrzinv)
product_ddrzinv = twin(double.product_ddrzinv)
product_ddtzinv = twin(double.product_ddtzinv)
