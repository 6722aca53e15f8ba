"""C functions of KSL that are made of the library's: other names, arguments and side effects.

They exist in C alone: Python has the functions that they call.
"""

from coscrew_codegen.targets.c import CFunction
from coscrew_codegen.targets.c_statements import WIDTH, comment_of, listed
from coscrew_codegen.targets.precision import DOUBLE, Precision

# family → (name in double, name in single, comment, parameters, body)
_FUNCTIONS: dict[str, tuple[tuple[str, str, str, str, str], ...]] = {"quaternion": (
    ("mat3x3_toQuaternion", "mat3x3f_toQuaternion", "The same as ksl_quaternion{f}_from_mat3x3.",
     "const ksl_mat3x3{f}_t *ri, ksl_quaternion{f}_t *qo",
     "  ksl_quaternion{f}_from_mat3x3(ri, qo);"),
    ("quaternion_toMat3x3", "quaternionf_toMat3x3f",
     "Normalizes qi, and sets ro to its rotation: ro = R(qi / |qi|), qi = qi / |qi|.",
     "ksl_quaternion{f}_t *qi, ksl_mat3x3{f}_t *ro",
     "  ksl_quaternion{f}_normalize(qi);\n  ksl_mat3x3{f}_from_quaternion(qi, ro);"),
    ("quaternion_slerp", "slerpf",
     "qo = q1i (q1i* q2i)^t along the arc from q1i to q2i, which is the longer one where "
     "q1i·q2i < 0: q1i at t = 0, q2i at t = 1; |q1i| = |q2i| = 1; not defined where q2i = -q1i. "
     "ksl_quaternion{f}_interpolated goes the shorter way.",
     "const ksl_quaternion{f}_t *q1i, const ksl_quaternion{f}_t *q2i, const {real} *t, "
     "ksl_quaternion{f}_t *qo",
     """\
  const {real} k = *t;
  if (ksl_dot_qq{f}(q1i, q2i) >= 0) {{
    ksl_quaternion{f}_interpolated(q1i, q2i, k, qo);
  }} else {{ /* by way of the middle: either half is the shorter arc */
    ksl_quaternion{f}_t middle = *q2i;
    ksl_axpy_qq{f}(1, q1i, &middle);
    ksl_quaternion{f}_normalize(&middle);
    if (2 * k <= 1) {{
      ksl_quaternion{f}_interpolated(q1i, &middle, 2 * k, qo);
    }} else {{
      ksl_quaternion{f}_interpolated(&middle, q2i, 2 * k - 1, qo);
    }}
  }}"""),
    ("quaternion_squad", "squadf",
     "qo = slerp(slerp(qi[0], qi[3], t), slerp(qi[1], qi[2], t), 2 t (1 - t)), Shoemake's curve "
     "from qi[0] to qi[3] with the inner control points qi[1], qi[2]; all of norm 1.",
     "const ksl_quaternion{f}_t qi[4], const {real} *t, ksl_quaternion{f}_t *qo",
     """\
  ksl_quaternion{f}_t ends, inner;
  const {real} k = 2 * *t * (1 - *t);
  {slerp}(&qi[0], &qi[3], t, &ends);
  {slerp}(&qi[1], &qi[2], t, &inner);
  {slerp}(&ends, &inner, &k, qo);"""),
    ("quaternion_nlerp", "nlerpf",
     "qo = (1 - t) q1i ± t q2i along the shorter arc, normalized; q1i where t < 1e-9, q2i where "
     "t >= 1.",
     "const ksl_quaternion{f}_t *q1i, const ksl_quaternion{f}_t *q2i, const {real} *t, "
     "ksl_quaternion{f}_t *qo",
     """\
  const {real} k = *t, signed_k = ksl_dot_qq{f}(q1i, q2i) < 0 ? -k : k;
  ksl_quaternion{f}_t o = k >= 1 ? *q2i : *q1i;
  if (k >= 1e-9{f} && k < 1) {{
    ksl_quaternion{f}_scale(&o, 1 - k);
    ksl_axpy_qq{f}(signed_k, q2i, &o);
    ksl_quaternion{f}_normalize(&o);
  }}
  *qo = o;"""),
    ("quaternion_product_uqinverseq", "product_uqinverseqf",
     "qo = q1i^-1 q2i, q1i^-1 = q1i* / q1i·q1i: q1i of any norm but zero whose square neither "
     "over- nor underflows.",
     "const ksl_quaternion{f}_t *q1i, const ksl_quaternion{f}_t *q2i, ksl_quaternion{f}_t *qo",
     """\
  const {real} square = ksl_dot_qq{f}(q1i, q1i);
  {qconjq}(q1i, q2i, qo);
  ksl_quaternion{f}_scale(qo, 1 / square);"""),
)}


def ksl_functions(family: str, precision: Precision) -> tuple[CFunction, ...]:
    """KSL's functions of this family that the table does not hold."""
    double = precision is DOUBLE
    words = {"f": precision.suffix, "real": precision.c_type,
             "slerp": "ksl_quaternion_slerp" if double else "ksl_slerpf",
             "qconjq": "ksl_quaternion_product_qconjq" if double else "ksl_product_qconjqf"}
    made = []
    for name, single, comment, parameters, body in _FUNCTIONS.get(family, ()):
        stem = f"ksl_{name if double else single}"
        made.append(CFunction(stem, comment_of([comment.format(**words)]),
                              listed(f"void {stem}(", parameters.format(**words).split(", "), ")",
                                     WIDTH - 16), body.format(**words)))
    return tuple(made)


def single_names(family: str) -> dict[str, str]:
    """Name in double → name in single, for the functions here."""
    return {f"ksl_{name}": f"ksl_{single}" for name, single, *_ in _FUNCTIONS.get(family, ())}
