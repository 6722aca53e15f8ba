# Made by `coscrew generate`; changes are overwritten.
# SPDX-License-Identifier: MIT
# coscrew 0.2.0.  Copyright (c) 2026 The coscrew authors.
"""Screws: twists, spatial velocities and accelerations, s = (v; ω).

In single precision, certified tier.  A twin(f, …) is f of double precision with these constants.
"""

from coscrew._twins import single_twins
from coscrew.certified import double

twin = single_twins(__name__, quiet=True)

screw_scale = twin(double.screw_scale, c1=1.9721522630525295e-31, c2=5.960465e-08)
axpy_ss = twin(double.axpy_ss, c1=1.9721522630525295e-31, c2=1.192093e-07)
xpy_ss = twin(double.xpy_ss, c1=5.960465e-08)
nxpy_ss = twin(double.nxpy_ss, c1=5.960465e-08)
product_as = twin(double.product_as, c1=1.9721522630525295e-31, c2=5.960465e-08)
add_ss = twin(double.add_ss, c1=5.960465e-08)
subtract_ss = twin(double.subtract_ss, c1=5.960465e-08)
add_sst = twin(double.add_sst, c1=5.960465e-08)
product_Adts = twin(double.product_Adts, c1=1.9721522630525295e-31, c2=1.7881396e-07)
product_Adtinvs = twin(double.product_Adtinvs, c1=1.9721522630525295e-31, c2=1.7881396e-07)
product_Adtsinv = twin(double.product_Adtsinv, c1=1.9721522630525295e-31, c2=1.7881396e-07)
product_Adrs = twin(double.product_Adrs, c1=1.9721522630525295e-31, c2=1.7881396e-07)
product_Adrinvs = twin(double.product_Adrinvs, c1=1.9721522630525295e-31, c2=1.7881396e-07)
product_Adrsinv = twin(double.product_Adrsinv, c1=1.9721522630525295e-31, c2=1.7881396e-07)
product_Ads = twin(double.product_Ads, c1=1.9721522630525295e-31, c2=3.5762795e-07,
    c3=1.7881396e-07)
product_Adinvs = twin(double.product_Adinvs, c1=1.9721522630525295e-31, c2=3.5762795e-07,
    c3=1.7881396e-07)
product_Adsinv = twin(double.product_Adsinv, c1=1.9721522630525295e-31, c2=3.5762795e-07,
    c3=1.7881396e-07)
hsrx = twin(double.hsrx, c1=1.9721522630525295e-31, c2=1.192093e-07)
hsry = twin(double.hsry, c1=1.9721522630525295e-31, c2=1.192093e-07)
hsrz = twin(double.hsrz, c1=1.9721522630525295e-31, c2=1.192093e-07)
hsrxinv = twin(double.hsrxinv, c1=1.9721522630525295e-31, c2=1.192093e-07)
hsryinv = twin(double.hsryinv, c1=1.9721522630525295e-31, c2=1.192093e-07)
hsrzinv = twin(double.hsrzinv, c1=1.9721522630525295e-31, c2=1.192093e-07)
Ad = twin(double.Ad, c1=1.9721522630525295e-31, c2=1.192093e-07)
dot_cs = twin(double.dot_cs, c1=1.9721522630525295e-31, c2=2.3841864e-07)
cross_ss = twin(double.cross_ss, c1=1.9721522630525295e-31, c2=1.7881396e-07, c3=1.192093e-07)
cross_sst = twin(double.cross_sst, c1=1.9721522630525295e-31, c2=1.192093e-07)
hsra = twin(double.hsra, c1=1.9721522630525295e-31, c2=2.9802328e-07, c3=1.7881396e-07)
hsta = twin(double.hsta, c1=1.9721522630525295e-31, c2=1.7881396e-07)
hsrainv = twin(double.hsrainv, c1=1.9721522630525295e-31, c2=2.9802328e-07, c3=1.7881396e-07)
hstainv = twin(double.hstainv, c1=1.9721522630525295e-31, c2=1.7881396e-07)
