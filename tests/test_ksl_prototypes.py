"""Every function shared with KSL (Kinematics Subroutine Library) has its parameters, in its order.

The table holds the prototypes of KSL's headers in short: `R(D, c)` style letters for types, outputs
behind the arrow.  A C compiler compares them with ours, in both precisions.
"""

import pytest

from coscrew_codegen.targets.c import c_name
from coscrew_codegen.targets.c_ksl import single_names
from coscrew_codegen.targets.precision import DOUBLE, PRECISIONS, Precision
from tests.c_harness import C11, COMPILERS, INCLUDE, STRICT, run

TYPES = {"V": "vec3", "M": "mat3x3", "D": "SE3", "S": "screw", "C": "coscrew",
         "Q": "quaternion"}

# What is passed → names.  A letter is a pointer to const, one with ! a pointer that is written,
# a the number, t its address, d the pair dc[2]; before the colon, what is returned.  KSL declares
# some of what it only reads without const: slerp's t, both factors of uqinverseq.
PROTOTYPES = {
    "a:V": "vec3_l2norm", "a:V,V": "dot_vv", "a:M": "mat3x3_determinant",
    "a:S": "screw_norm", "a:C": "coscrew_norm", "a:C,S": "dot_cs",
    "void:V!": "vec3_normalize vec3_invert", "void:V!,V!": "vec3_swap", "void:V!,a": "vec3_scale",
    "void:V,V!": "vec3_normalized vec3_copy vec3_inverted xpy_vv nxpy_vv",
    "void:V,a,V!": "vec3_scaled add_vvx add_vvxinv add_vvy add_vvyinv add_vvz add_vvzinv",
    "void:a,V,V!": "product_av product_avinv product_ainvv axpy_vv",
    "void:V,V,V!": "add_vv subtract_vv cross_vv cross_vvinv",
    "void:M!": "mat3x3_setIdentity mat3x3_transpose",
    "void:M!,V,V,V": "mat3x3_setFromVectors",
    "void:M,M!": "mat3x3_copy mat3x3_transposed",
    "void:D!": "SE3_setIdentity SE3_invert", "void:D,D!": "SE3_inverted SE3_copy",
    "void:D,V!": "SE3_getTranslation",
    "void:M,V,V!": "product_drv product_drvinv product_drinvv product_drinvvinv",
    "void:M,a,V!": "product_drvtx product_drvtxinv product_drvty product_drvtyinv product_drvtz "
                   "product_drvtzinv",
    "void:M,d,M!": "product_drdrx product_drdrxinv product_drdry product_drdryinv product_drdrz "
                   "product_drdrzinv",
    "void:M,M,M!": "product_drdr product_drdrinv product_drinvdr",
    "void:D,V,V!": "product_dv product_dinvv",
    "void:D,d,D!": "product_ddrx product_ddrxinv product_ddry product_ddryinv product_ddrz "
                   "product_ddrzinv",
    "void:D,V,D!": "product_ddt product_ddtinv product_dinvdt",
    "void:D,a,D!": "product_ddtx product_ddtxinv product_ddty product_ddtyinv product_ddtz "
                   "product_ddtzinv",
    "void:D,M,D!": "product_ddr product_ddrinv",
    "void:D,D,D!": "product_dd product_ddinv product_dinvd",
    "void:S!": "screw_normalize screw_invert", "void:S!,a": "screw_scale",
    "void:S,S!": "screw_normalized screw_copy screw_inverted xpy_ss nxpy_ss",
    "void:a,S,S!": "product_as axpy_ss",
    "void:S,S,S!": "add_ss subtract_ss add_sst cross_ss cross_sst",
    "void:D,S!": "hstx hsty hstz hsrx hsry hsrz hstxinv hstyinv hstzinv hsrxinv hsryinv hsrzinv",
    "void:M,S,S!": "product_Adrs product_Adrsinv product_Adrinvs",
    "void:V,S,S!": "product_Adts product_Adtinvs product_Adtsinv",
    "void:D,S,S!": "product_Ads product_Adsinv product_Adinvs",
    "void:C!": "coscrew_normalize coscrew_invert", "void:C!,a": "coscrew_scale",
    "void:C,C!": "coscrew_copy coscrew_inverted xpy_cc nxpy_cc",
    "void:a,C,C!": "product_ac axpy_cc", "void:C,C,C!": "add_cc subtract_cc add_cct",
    "void:D,C!": "hctx hcty hctz hcrx hcry hcrz hctxinv hctyinv hctzinv hcrxinv hcryinv hcrzinv",
    "void:S,C,C!": "cross_sc cross_sca",
    "void:V,C,C!": "product_CoAdtc product_CoAdtcinv product_CoAdtinvc",
    "void:M,C,C!": "product_CoAdrc product_CoAdrcinv product_CoAdrinvc",
    "void:D,C,C!": "product_CoAdc product_CoAdcinv product_CoAdinvc",
    "a:Q,Q": "dot_qq", "void:Q!": "quaternion_normalize", "void:a,Q,Q!": "axpy_qq",
    "void:M,Q!": "mat3x3_toQuaternion", "void:Q!,M!": "quaternion_toMat3x3",
    "void:Q,Q,t,Q!": "quaternion_slerp quaternion_nlerp", "void:Q,t,Q!": "quaternion_squad",
    "void:V,Q!": "add_dpiToq subtract_dpiFromq",
    "void:V,Q,Q!": "omega_to_dquaternion quaternion_product_vq quaternion_product_vqconj",
    "void:Q,Q,Q!": "quaternion_product_qq quaternion_product_qconjq quaternion_product_qqconj "
                   "quaternion_product_qconjqconj quaternion_product_uqinverseq",
    "void:Q,V,Q!": "quaternion_product_qv quaternion_product_qconjv",
    "void:d,Q,Q!": " ".join(f"quaternion_product_q{x}{a}q{b}" for x in "xyz"
                            for a in ("", "conj") for b in ("", "conj")),
    "void:Q,d,Q!": " ".join(f"quaternion_product_q{a}q{x}{b}" for x in "xyz"
                            for a in ("", "conj") for b in ("", "conj")),
}


def declaration(prototype: str, name: str, precision: Precision) -> str:
    """C: a pointer to a function of KSL's type, set to our function."""
    kind, _, passed = prototype.partition(":")
    real = precision.c_type
    spelled = {"a": real, "t": f"const {real} *", "d": f"const {real} [2]"} | {
        letter + mark: f"{const}ksl_{stem}{precision.suffix}_t *"
        for letter, stem in TYPES.items() for mark, const in (("", "const "), ("!", ""))}
    parameters = ", ".join(spelled[p] for p in passed.split(","))
    returned = real if kind == "a" else "void"
    return f"{returned} (*const is_{name})({parameters}) = {_function(name, precision)};"


def _function(name: str, precision: Precision) -> str:
    """Our function: of the table, or made of such."""
    others = single_names("quaternion")
    if f"ksl_{name}" in others:
        return f"ksl_{name}" if precision is DOUBLE else others[f"ksl_{name}"]
    return c_name(name, precision)


@pytest.mark.parametrize("compiler", COMPILERS)
@pytest.mark.parametrize("precision", PRECISIONS, ids=lambda p: p.name)
def test_prototypes_are_ksls(precision, compiler, tmp_path):
    lines = [f"extern {declaration(prototype, name, precision).split(' = ')[0]};\n"
             f"{declaration(prototype, name, precision)}"
             for prototype, names in PROTOTYPES.items() for name in names.split()]
    source = tmp_path / "prototypes.c"
    source.write_text("\n".join(["#include <ksl/ksl.h>", *lines, ""]))
    run((compiler, *C11, *STRICT, "-I", INCLUDE, "-c", source, "-o", tmp_path / "prototypes.o"))
