"""KSL's quaternion functions in C that are not in the table of operations: against their formulas
in 60 digits.

A program written for KSL calls them and prints the results, which are compared.
"""

from collections.abc import Callable, Sequence

import mpmath as mp
import numpy as np

from coscrew_codegen.program.values.formats import DOUBLE, Precision
from tests.support.compiled.c_harness import C11, COMPILERS, INCLUDE, STRICT, run
from tests.support.each import each_compiler, each_precision
from tests.support.truth.motions import DIGITS, Matrix, conjugate, matrix_of, norm, product

NUMBERS = ((0.1, -0.7, 0.3, 0.6), (0.5, 0.2, -0.4, 0.3), (-0.6, 0.1, 0.2, -0.5),
           (0.2, 0.8, 0.1, 0.4), (-0.1, 0.65, -0.35, -0.55))
FRACTIONS = (0.0, 0.25, 0.5, 0.75, 1.0)
SINGLE = {"ksl_quaternion_slerp": "ksl_slerpf", "ksl_quaternion_nlerp": "ksl_nlerpf",
          "ksl_quaternion_squad": "ksl_squadf",
          "ksl_mat3x3_toQuaternion": "ksl_mat3x3f_toQuaternion",
          "ksl_quaternion_toMat3x3": "ksl_quaternionf_toMat3x3f",
          "ksl_quaternion_product_uqinverseq": "ksl_product_uqinverseqf"}


def slerp(p: Matrix, q: Matrix, t: mp.mpf) -> Matrix:
    """Shoemake's: (p sin((1 - t) a) + q sin(t a)) / sin a, cos a = p·q."""
    a = mp.acos(mp.fdot(p, q))
    return (p * mp.sin((1 - t) * a) + q * mp.sin(t * a)) / mp.sin(a)


def nlerp(p: Matrix, q: Matrix, t: mp.mpf) -> Matrix:
    if t in (0, 1):
        return p if t == 0 else q
    r = (1 - t) * p + (t if mp.fdot(p, q) >= 0 else -t) * q
    return r / norm(r)


def squad(q: Sequence[Matrix], t: mp.mpf) -> Matrix:
    return slerp(slerp(q[0], q[3], t), slerp(q[1], q[2], t), 2 * t * (1 - t))


def program(precision: Precision) -> str:
    """A program that prints the results of CASES, a line each."""
    f, real = precision.suffix, precision.c_type
    name = {key: key if precision is DOUBLE else twin for key, twin in SINGLE.items()}
    numbers = ",\n".join("{{{" + ", ".join(f"{x}{f}" for x in row) + "}}}" for row in NUMBERS)
    pairs = "\n".join(
        f"    {name[f'ksl_quaternion_{what}']}(&q[0], &q[{k}], &t, &o); show(&o);"
        for what in ("slerp", "nlerp") for k in (1, 2, 4))
    times = ", ".join(f"{x}{f}" for x in FRACTIONS)
    return f"""#include <ksl/ksl.h>
#include <stdio.h>
static void show(const ksl_quaternion{f}_t *o) {{
  printf("%a %a %a %a\\n", (double)o->x, (double)o->y, (double)o->z, (double)o->w);
}}
int main(void) {{
  ksl_quaternion{f}_t q[5] = {{{numbers}}}, o, r;
  ksl_mat3x3{f}_t R;
  {real} times[] = {{{times}}};
  r = q[0];
  {name["ksl_quaternion_product_uqinverseq"]}(&q[0], &q[1], &o); show(&o);
  {name["ksl_quaternion_toMat3x3"]}(&r, &R); show(&r);
  for (int i = 0; i < 3; i++) {{
    printf("%a %a %a\\n", (double)R.at[0][i], (double)R.at[1][i], (double)R.at[2][i]);
  }}
  {name["ksl_mat3x3_toQuaternion"]}(&R, &o); show(&o);
  for (int i = 0; i < 5; i++) {{ ksl_quaternion{f}_normalize(&q[i]); }}
  for (int i = 0; i < 5; i++) {{
    {real} t = times[i];
{pairs}
    {name["ksl_quaternion_squad"]}(q, &t, &o); show(&o);
  }}
  return 0;
}}
"""


def wanted(rounded: Callable[[float], mp.mpf]) -> list[list[mp.mpf]]:
    q = [mp.matrix([rounded(x) for x in row]) for row in NUMBERS]
    R, unit = matrix_of(q[0]), [x / norm(x) for x in q]
    results = [product(conjugate(q[0]), q[1]) / mp.fdot(q[0], q[0]), unit[0],
               *([R[i, j] for j in range(3)] for i in range(3)), unit[0]]
    for t in map(mp.mpf, FRACTIONS):
        results += [way(unit[0], unit[k], t) for way in (slerp, nlerp) for k in (1, 2, 4)]
        results.append(squad(unit[:4], t))
    return [list(x) for x in results]


@each_compiler
@each_precision
def test_they_are_their_formulas(precision, compiler, tmp_path):
    """To 64 u; q[0]·q[2] and q[0]·q[4] are negative: slerp takes the long way, nlerp the short."""
    source = tmp_path / "program.c"
    source.write_text(program(precision))
    run((compiler, *C11, *STRICT, "-Wno-missing-braces", "-I", INCLUDE, source, "-o",
         tmp_path / "program", "-lm"))
    lines = [list(map(float.fromhex, line.split()))
             for line in run([tmp_path / "program"]).splitlines()]
    u = 2.0 ** (-53 if precision is DOUBLE else -24)
    with mp.workdps(DIGITS):
        exact = wanted(lambda x: mp.mpf(float(np.dtype(precision.numpy_type).type(x))))
        assert len(lines) == len(exact)
        for number, (result, right) in enumerate(zip(lines, exact, strict=True)):
            worst = max(abs(x - y) for x, y in zip(result, right, strict=True))
            assert worst <= 64 * u, (number, float(worst / u))


@each_precision
def test_slerp_goes_on_beyond_half_a_turn_up_to_the_opposite(precision, tmp_path):
    """From q to -q with an ever smaller perturbation, down to 64 u: at a quarter of the way the
    rotation has a quarter of its angle, never three quarters, about whichever axis rounding leaves.
    """
    f = precision.suffix
    slerp, product = (("ksl_quaternion_slerp", "ksl_quaternion_product_qq") if precision is DOUBLE
                      else ("ksl_slerpf", "ksl_product_qqf"))
    least = 64 * 2.0 ** (-53 if precision is DOUBLE else -24)
    (tmp_path / "program.c").write_text(f"""#include <ksl/ksl.h>
#include <stdio.h>
int main(void) {{
  const double pi = 3.14159265358979323846;
  int wrong = 0, tried = 0;
  for (double less = 1; less > {least}; less *= 0.97) {{
    for (int n = 0; n < 16; n++) {{
      const double a = n + 0.3, b = 2.7 * n, s = sin(pi - less), c = cos(pi - less);
      ksl_quaternion{f}_t q1 = ksl_quaternion{f}(({precision.c_type})(sin(a) * cos(b)),
          ({precision.c_type})(sin(a) * sin(b)), ({precision.c_type})(cos(a) * cos(2 * b)),
          ({precision.c_type})(cos(a) * sin(2 * b)));
      ksl_quaternion{f}_t turn = ksl_quaternion{f}(0, 0, ({precision.c_type})s,
          ({precision.c_type})c), q2, o;
      for (int k = 1; k < 4; k += 2) {{
        {precision.c_type} t = ({precision.c_type})k / 4;
        {product}(&q1, &turn, &q2);
        {slerp}(&q1, &q2, &t, &o);
        const double along = (double)ksl_dot_qq{f}(k == 1 ? &q1 : &q2, &o);
        wrong += !(fabs(along - cos((pi - less) / 4)) < 0.01);
        tried++;
      }}
    }}
  }}
  printf("%d %d\\n", wrong, tried);
  return 0;
}}
""")
    run((COMPILERS[0], *C11, "-Wno-missing-braces", "-I", INCLUDE, tmp_path / "program.c", "-o",
         tmp_path / "program", "-lm"))
    wrong, tried = map(int, run([tmp_path / "program"]).split())
    assert wrong == 0 and tried > 5000
