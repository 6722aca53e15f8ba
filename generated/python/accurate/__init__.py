# Made by `coscrew generate`; changes are overwritten.
"""The accurate tier: float64 compensated, intermediate results carried as hi + lo; float32 computed
in float64 and rounded once.  In pure NumPy; the same bits as the C kernels while nothing over- or
underflows.  Operations that round nothing, or are not polynomials, are those of `coscrew` itself.
"""

from coscrew._kernel import dispatch
from coscrew.accurate import double, single

vec3_scale = dispatch(__name__, double.vec3_scale, single.vec3_scale)
axpy_vv = dispatch(__name__, double.axpy_vv, single.axpy_vv)
xpy_vv = dispatch(__name__, double.xpy_vv, single.xpy_vv)
nxpy_vv = dispatch(__name__, double.nxpy_vv, single.nxpy_vv)
product_av = dispatch(__name__, double.product_av, single.product_av)
add_vv = dispatch(__name__, double.add_vv, single.add_vv)
subtract_vv = dispatch(__name__, double.subtract_vv, single.subtract_vv)
vec3_scaled = dispatch(__name__, double.vec3_scaled, single.vec3_scaled)
vec3_l2norm = dispatch(__name__, double.vec3_l2norm, single.vec3_l2norm)
vec3_normalize = dispatch(__name__, double.vec3_normalize, single.vec3_normalize)
vec3_normalized = dispatch(__name__, double.vec3_normalized, single.vec3_normalized)
angle_vv = dispatch(__name__, double.angle_vv, single.angle_vv)
dot_vv = dispatch(__name__, double.dot_vv, single.dot_vv)
product_avinv = dispatch(__name__, double.product_avinv, single.product_avinv)
product_ainvv = dispatch(__name__, double.product_ainvv, single.product_ainvv)
cross_vv = dispatch(__name__, double.cross_vv, single.cross_vv)
cross_vvinv = dispatch(__name__, double.cross_vvinv, single.cross_vvinv)
add_vvx = dispatch(__name__, double.add_vvx, single.add_vvx)
add_vvxinv = dispatch(__name__, double.add_vvxinv, single.add_vvxinv)
add_vvy = dispatch(__name__, double.add_vvy, single.add_vvy)
add_vvyinv = dispatch(__name__, double.add_vvyinv, single.add_vvyinv)
add_vvz = dispatch(__name__, double.add_vvz, single.add_vvz)
add_vvzinv = dispatch(__name__, double.add_vvzinv, single.add_vvzinv)
mat3x3_determinant = dispatch(__name__, double.mat3x3_determinant, single.mat3x3_determinant)
SE3_invert = dispatch(__name__, double.SE3_invert, single.SE3_invert)
SE3_inverted = dispatch(__name__, double.SE3_inverted, single.SE3_inverted)
product_drv = dispatch(__name__, double.product_drv, single.product_drv)
product_drvinv = dispatch(__name__, double.product_drvinv, single.product_drvinv)
product_drinvv = dispatch(__name__, double.product_drinvv, single.product_drinvv)
product_drinvvinv = dispatch(__name__, double.product_drinvvinv, single.product_drinvvinv)
product_dv = dispatch(__name__, double.product_dv, single.product_dv)
product_dinvv = dispatch(__name__, double.product_dinvv, single.product_dinvv)
product_drdr = dispatch(__name__, double.product_drdr, single.product_drdr)
product_drdrinv = dispatch(__name__, double.product_drdrinv, single.product_drdrinv)
product_drinvdr = dispatch(__name__, double.product_drinvdr, single.product_drinvdr)
product_dd = dispatch(__name__, double.product_dd, single.product_dd)
product_ddinv = dispatch(__name__, double.product_ddinv, single.product_ddinv)
product_dinvd = dispatch(__name__, double.product_dinvd, single.product_dinvd)
product_ddr = dispatch(__name__, double.product_ddr, single.product_ddr)
product_ddrinv = dispatch(__name__, double.product_ddrinv, single.product_ddrinv)
product_ddt = dispatch(__name__, double.product_ddt, single.product_ddt)
product_ddtinv = dispatch(__name__, double.product_ddtinv, single.product_ddtinv)
product_dinvdt = dispatch(__name__, double.product_dinvdt, single.product_dinvdt)
product_drvtx = dispatch(__name__, double.product_drvtx, single.product_drvtx)
product_drdrx = dispatch(__name__, double.product_drdrx, single.product_drdrx)
product_ddrx = dispatch(__name__, double.product_ddrx, single.product_ddrx)
product_ddtx = dispatch(__name__, double.product_ddtx, single.product_ddtx)
product_drvtxinv = dispatch(__name__, double.product_drvtxinv, single.product_drvtxinv)
product_drdrxinv = dispatch(__name__, double.product_drdrxinv, single.product_drdrxinv)
product_ddrxinv = dispatch(__name__, double.product_ddrxinv, single.product_ddrxinv)
product_ddtxinv = dispatch(__name__, double.product_ddtxinv, single.product_ddtxinv)
product_drvty = dispatch(__name__, double.product_drvty, single.product_drvty)
product_drdry = dispatch(__name__, double.product_drdry, single.product_drdry)
product_ddry = dispatch(__name__, double.product_ddry, single.product_ddry)
product_ddty = dispatch(__name__, double.product_ddty, single.product_ddty)
product_drvtyinv = dispatch(__name__, double.product_drvtyinv, single.product_drvtyinv)
product_drdryinv = dispatch(__name__, double.product_drdryinv, single.product_drdryinv)
product_ddryinv = dispatch(__name__, double.product_ddryinv, single.product_ddryinv)
product_ddtyinv = dispatch(__name__, double.product_ddtyinv, single.product_ddtyinv)
product_drvtz = dispatch(__name__, double.product_drvtz, single.product_drvtz)
product_drdrz = dispatch(__name__, double.product_drdrz, single.product_drdrz)
product_ddrz = dispatch(__name__, double.product_ddrz, single.product_ddrz)
product_ddtz = dispatch(__name__, double.product_ddtz, single.product_ddtz)
product_drvtzinv = dispatch(__name__, double.product_drvtzinv, single.product_drvtzinv)
product_drdrzinv = dispatch(__name__, double.product_drdrzinv, single.product_drdrzinv)
product_ddrzinv = dispatch(__name__, double.product_ddrzinv, single.product_ddrzinv)
product_ddtzinv = dispatch(__name__, double.product_ddtzinv, single.product_ddtzinv)
screw_scale = dispatch(__name__, double.screw_scale, single.screw_scale)
axpy_ss = dispatch(__name__, double.axpy_ss, single.axpy_ss)
xpy_ss = dispatch(__name__, double.xpy_ss, single.xpy_ss)
nxpy_ss = dispatch(__name__, double.nxpy_ss, single.nxpy_ss)
product_as = dispatch(__name__, double.product_as, single.product_as)
add_ss = dispatch(__name__, double.add_ss, single.add_ss)
subtract_ss = dispatch(__name__, double.subtract_ss, single.subtract_ss)
screw_norm = dispatch(__name__, double.screw_norm, single.screw_norm)
screw_normalize = dispatch(__name__, double.screw_normalize, single.screw_normalize)
screw_normalized = dispatch(__name__, double.screw_normalized, single.screw_normalized)
add_sst = dispatch(__name__, double.add_sst, single.add_sst)
product_Adts = dispatch(__name__, double.product_Adts, single.product_Adts)
product_Adtinvs = dispatch(__name__, double.product_Adtinvs, single.product_Adtinvs)
product_Adtsinv = dispatch(__name__, double.product_Adtsinv, single.product_Adtsinv)
product_Adrs = dispatch(__name__, double.product_Adrs, single.product_Adrs)
product_Adrinvs = dispatch(__name__, double.product_Adrinvs, single.product_Adrinvs)
product_Adrsinv = dispatch(__name__, double.product_Adrsinv, single.product_Adrsinv)
product_Ads = dispatch(__name__, double.product_Ads, single.product_Ads)
product_Adinvs = dispatch(__name__, double.product_Adinvs, single.product_Adinvs)
product_Adsinv = dispatch(__name__, double.product_Adsinv, single.product_Adsinv)
hsrx = dispatch(__name__, double.hsrx, single.hsrx)
hsry = dispatch(__name__, double.hsry, single.hsry)
hsrz = dispatch(__name__, double.hsrz, single.hsrz)
hsrxinv = dispatch(__name__, double.hsrxinv, single.hsrxinv)
hsryinv = dispatch(__name__, double.hsryinv, single.hsryinv)
hsrzinv = dispatch(__name__, double.hsrzinv, single.hsrzinv)
Ad = dispatch(__name__, double.Ad, single.Ad)
dot_cs = dispatch(__name__, double.dot_cs, single.dot_cs)
cross_ss = dispatch(__name__, double.cross_ss, single.cross_ss)
cross_sst = dispatch(__name__, double.cross_sst, single.cross_sst)
hsra = dispatch(__name__, double.hsra, single.hsra)
hsta = dispatch(__name__, double.hsta, single.hsta)
coscrew_scale = dispatch(__name__, double.coscrew_scale, single.coscrew_scale)
axpy_cc = dispatch(__name__, double.axpy_cc, single.axpy_cc)
xpy_cc = dispatch(__name__, double.xpy_cc, single.xpy_cc)
nxpy_cc = dispatch(__name__, double.nxpy_cc, single.nxpy_cc)
product_ac = dispatch(__name__, double.product_ac, single.product_ac)
add_cc = dispatch(__name__, double.add_cc, single.add_cc)
subtract_cc = dispatch(__name__, double.subtract_cc, single.subtract_cc)
coscrew_norm = dispatch(__name__, double.coscrew_norm, single.coscrew_norm)
coscrew_normalize = dispatch(__name__, double.coscrew_normalize, single.coscrew_normalize)
coscrew_normalized = dispatch(__name__, double.coscrew_normalized, single.coscrew_normalized)
add_cct = dispatch(__name__, double.add_cct, single.add_cct)
product_CoAdtc = dispatch(__name__, double.product_CoAdtc, single.product_CoAdtc)
product_CoAdtinvc = dispatch(__name__, double.product_CoAdtinvc, single.product_CoAdtinvc)
product_CoAdtcinv = dispatch(__name__, double.product_CoAdtcinv, single.product_CoAdtcinv)
product_CoAdrc = dispatch(__name__, double.product_CoAdrc, single.product_CoAdrc)
product_CoAdrinvc = dispatch(__name__, double.product_CoAdrinvc, single.product_CoAdrinvc)
product_CoAdrcinv = dispatch(__name__, double.product_CoAdrcinv, single.product_CoAdrcinv)
product_CoAdc = dispatch(__name__, double.product_CoAdc, single.product_CoAdc)
product_CoAdinvc = dispatch(__name__, double.product_CoAdinvc, single.product_CoAdinvc)
product_CoAdcinv = dispatch(__name__, double.product_CoAdcinv, single.product_CoAdcinv)
hctx = dispatch(__name__, double.hctx, single.hctx)
hcty = dispatch(__name__, double.hcty, single.hcty)
hctz = dispatch(__name__, double.hctz, single.hctz)
hctxinv = dispatch(__name__, double.hctxinv, single.hctxinv)
hctyinv = dispatch(__name__, double.hctyinv, single.hctyinv)
hctzinv = dispatch(__name__, double.hctzinv, single.hctzinv)
CoAd = dispatch(__name__, double.CoAd, single.CoAd)
reciprocal_product = dispatch(__name__, double.reciprocal_product, single.reciprocal_product)
cross_sc = dispatch(__name__, double.cross_sc, single.cross_sc)
cross_sca = dispatch(__name__, double.cross_sca, single.cross_sca)
constraint_ctx = dispatch(__name__, double.constraint_ctx, single.constraint_ctx)
constraint_cty = dispatch(__name__, double.constraint_cty, single.constraint_cty)
constraint_ctz = dispatch(__name__, double.constraint_ctz, single.constraint_ctz)
constraint_crx = dispatch(__name__, double.constraint_crx, single.constraint_crx)
constraint_cry = dispatch(__name__, double.constraint_cry, single.constraint_cry)
constraint_crz = dispatch(__name__, double.constraint_crz, single.constraint_crz)
working_ctx = dispatch(__name__, double.working_ctx, single.working_ctx)
working_cty = dispatch(__name__, double.working_cty, single.working_cty)
working_ctz = dispatch(__name__, double.working_ctz, single.working_ctz)
working_crx = dispatch(__name__, double.working_crx, single.working_crx)
working_cry = dispatch(__name__, double.working_cry, single.working_cry)
working_crz = dispatch(__name__, double.working_crz, single.working_crz)
quaternion_scale = dispatch(__name__, double.quaternion_scale, single.quaternion_scale)
quaternion_norm = dispatch(__name__, double.quaternion_norm, single.quaternion_norm)
quaternion_normalize = dispatch(__name__, double.quaternion_normalize, single.quaternion_normalize)
quaternion_normalized = dispatch(__name__, double.quaternion_normalized, single.quaternion_normalized)
product_qq = dispatch(__name__, double.product_qq, single.product_qq)
product_qconjq = dispatch(__name__, double.product_qconjq, single.product_qconjq)
product_qqconj = dispatch(__name__, double.product_qqconj, single.product_qqconj)
product_qv = dispatch(__name__, double.product_qv, single.product_qv)
product_qconjv = dispatch(__name__, double.product_qconjv, single.product_qconjv)
mat3x3_from_quaternion = dispatch(__name__, double.mat3x3_from_quaternion, single.mat3x3_from_quaternion)
quaternion_from_mat3x3 = dispatch(__name__, double.quaternion_from_mat3x3, single.quaternion_from_mat3x3)
axis_angle_from_quaternion = dispatch(__name__, double.axis_angle_from_quaternion, single.axis_angle_from_quaternion)
quaternion_log = dispatch(__name__, double.quaternion_log, single.quaternion_log)
SO3_log = dispatch(__name__, double.SO3_log, single.SO3_log)
axis_angle_from_mat3x3 = dispatch(__name__, double.axis_angle_from_mat3x3, single.axis_angle_from_mat3x3)
mat3x3_orthonormalize = dispatch(__name__, double.mat3x3_orthonormalize, single.mat3x3_orthonormalize)
mat3x3_orthonormalized = dispatch(__name__, double.mat3x3_orthonormalized, single.mat3x3_orthonormalized)
mat3x3_ldl = dispatch(__name__, double.mat3x3_ldl, single.mat3x3_ldl)
mat3x3_ldl_solve = dispatch(__name__, double.mat3x3_ldl_solve, single.mat3x3_ldl_solve)
mat3x3_solve = dispatch(__name__, double.mat3x3_solve, single.mat3x3_solve)
mat6x6_ldl = dispatch(__name__, double.mat6x6_ldl, single.mat6x6_ldl)
mat6x6_ldl_solve = dispatch(__name__, double.mat6x6_ldl_solve, single.mat6x6_ldl_solve)
mat6x6_solve = dispatch(__name__, double.mat6x6_solve, single.mat6x6_solve)
inertia_scale = dispatch(__name__, double.inertia_scale, single.inertia_scale)
add_BB = dispatch(__name__, double.add_BB, single.add_BB)
subtract_BB = dispatch(__name__, double.subtract_BB, single.subtract_BB)
inertia_from_com = dispatch(__name__, double.inertia_from_com, single.inertia_from_com)
inertia_com = dispatch(__name__, double.inertia_com, single.inertia_com)
inertia_about_com = dispatch(__name__, double.inertia_about_com, single.inertia_about_com)
product_Bs = dispatch(__name__, double.product_Bs, single.product_Bs)
inertia_energy = dispatch(__name__, double.inertia_energy, single.inertia_energy)
inertia_shifted = dispatch(__name__, double.inertia_shifted, single.inertia_shifted)
inertia_transformed = dispatch(__name__, double.inertia_transformed, single.inertia_transformed)
inertia_consistency = dispatch(__name__, double.inertia_consistency, single.inertia_consistency)

__all__ = [
    "double", "single", 
    "vec3_scale",
    "axpy_vv",
    "xpy_vv",
    "nxpy_vv",
    "product_av",
    "add_vv",
    "subtract_vv",
    "vec3_scaled",
    "vec3_l2norm",
    "vec3_normalize",
    "vec3_normalized",
    "angle_vv",
    "dot_vv",
    "product_avinv",
    "product_ainvv",
    "cross_vv",
    "cross_vvinv",
    "add_vvx",
    "add_vvxinv",
    "add_vvy",
    "add_vvyinv",
    "add_vvz",
    "add_vvzinv",
    "mat3x3_determinant",
    "SE3_invert",
    "SE3_inverted",
    "product_drv",
    "product_drvinv",
    "product_drinvv",
    "product_drinvvinv",
    "product_dv",
    "product_dinvv",
    "product_drdr",
    "product_drdrinv",
    "product_drinvdr",
    "product_dd",
    "product_ddinv",
    "product_dinvd",
    "product_ddr",
    "product_ddrinv",
    "product_ddt",
    "product_ddtinv",
    "product_dinvdt",
    "product_drvtx",
    "product_drdrx",
    "product_ddrx",
    "product_ddtx",
    "product_drvtxinv",
    "product_drdrxinv",
    "product_ddrxinv",
    "product_ddtxinv",
    "product_drvty",
    "product_drdry",
    "product_ddry",
    "product_ddty",
    "product_drvtyinv",
    "product_drdryinv",
    "product_ddryinv",
    "product_ddtyinv",
    "product_drvtz",
    "product_drdrz",
    "product_ddrz",
    "product_ddtz",
    "product_drvtzinv",
    "product_drdrzinv",
    "product_ddrzinv",
    "product_ddtzinv",
    "screw_scale",
    "axpy_ss",
    "xpy_ss",
    "nxpy_ss",
    "product_as",
    "add_ss",
    "subtract_ss",
    "screw_norm",
    "screw_normalize",
    "screw_normalized",
    "add_sst",
    "product_Adts",
    "product_Adtinvs",
    "product_Adtsinv",
    "product_Adrs",
    "product_Adrinvs",
    "product_Adrsinv",
    "product_Ads",
    "product_Adinvs",
    "product_Adsinv",
    "hsrx",
    "hsry",
    "hsrz",
    "hsrxinv",
    "hsryinv",
    "hsrzinv",
    "Ad",
    "dot_cs",
    "cross_ss",
    "cross_sst",
    "hsra",
    "hsta",
    "coscrew_scale",
    "axpy_cc",
    "xpy_cc",
    "nxpy_cc",
    "product_ac",
    "add_cc",
    "subtract_cc",
    "coscrew_norm",
    "coscrew_normalize",
    "coscrew_normalized",
    "add_cct",
    "product_CoAdtc",
    "product_CoAdtinvc",
    "product_CoAdtcinv",
    "product_CoAdrc",
    "product_CoAdrinvc",
    "product_CoAdrcinv",
    "product_CoAdc",
    "product_CoAdinvc",
    "product_CoAdcinv",
    "hctx",
    "hcty",
    "hctz",
    "hctxinv",
    "hctyinv",
    "hctzinv",
    "CoAd",
    "reciprocal_product",
    "cross_sc",
    "cross_sca",
    "constraint_ctx",
    "constraint_cty",
    "constraint_ctz",
    "constraint_crx",
    "constraint_cry",
    "constraint_crz",
    "working_ctx",
    "working_cty",
    "working_ctz",
    "working_crx",
    "working_cry",
    "working_crz",
    "quaternion_scale",
    "quaternion_norm",
    "quaternion_normalize",
    "quaternion_normalized",
    "product_qq",
    "product_qconjq",
    "product_qqconj",
    "product_qv",
    "product_qconjv",
    "mat3x3_from_quaternion",
    "quaternion_from_mat3x3",
    "axis_angle_from_quaternion",
    "quaternion_log",
    "SO3_log",
    "axis_angle_from_mat3x3",
    "mat3x3_orthonormalize",
    "mat3x3_orthonormalized",
    "mat3x3_ldl",
    "mat3x3_ldl_solve",
    "mat3x3_solve",
    "mat6x6_ldl",
    "mat6x6_ldl_solve",
    "mat6x6_solve",
    "inertia_scale",
    "add_BB",
    "subtract_BB",
    "inertia_from_com",
    "inertia_com",
    "inertia_about_com",
    "product_Bs",
    "inertia_energy",
    "inertia_shifted",
    "inertia_transformed",
    "inertia_consistency",
]
