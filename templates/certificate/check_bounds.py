"""Checks certificates of rounding errors, with fractions alone: python check_bounds.py < FILE"""
from fractions import Fraction as F

def below(x):  # the largest power of two below x
    return y if (y := F(2)**(x.numerator.bit_length() - x.denominator.bit_length())) < x else y / 2

def check(lines):  # of a value: size, error, size as computed, least size, turn, quadratic form
    (digits, least, sine, *pairs), *steps = (x.split() for x in lines if x[0] not in "# ")
    u, eta, sine, known = F(1, 2**int(digits)), F(2)**(int(least) - int(digits)), F(sine), {}
    rounding = lambda x: max(u * below(x), eta) if x else F(0)
    near = lambda x, of=round: of(x / (unit := 2 * rounding(abs(x)) or 1)) * unit
    for op, name, *x, s, e, r in steps:  # check_pairs.py finds r of pairs, check_lengths.py lengths
        s, e, r = (F(float.fromhex(y)) for y in (s, e, r))
        for y, c in ((z, abs(F(z))) for z in x if z not in known and op[:5] != "input"):
            known[y] = c, abs((d := c - near(c)) - near(d) * len(pairs)), c - d, c, (), ()
        given = [(s, F(0), s, F(0), (), (*x, name))] if op[:5] == "input" else [known[y] for y in x]
        a, b = given[0], given[:2][-1]
        size, moved, top = {  # bounds of size, of error before rounding, of the size as computed
            "add": [y + z for y, z in zip(a[:3], b)], "input": a[:3], "neg": a[:3], "copy": a[:3],
            "mul": (a[0] * b[0], a[0] * b[1] + a[1] * b[0] + a[1] * b[1], a[2] * b[2]),
            "div": (a[0] / b[3] if b[3] - b[1] >= (sum(y[0] for y in given[2:]) or eta) else s + 1,
                    (a[1] + s * b[1]) / (b[3] - b[1] or 1), 1 / eta),
            "sin": (min(a[0], 1), a[1], 1), "cos": (1, a[1], 1)}[op.replace("sub", "add")[:5]]
        size, moved = map(min, (size, moved), (given[2:] * (op != "div") or [(size, moved)])[0])
        before, (p, f), (q, g), gap = min(s + e - r, F(top)), a[4:], b[4:], F(-1)
        own, form = rounding(before) * (op[:3] not in ("inp", "neg")), f * (op in ("input", "copy"))
        turn = (*p[:4], *(y + r for y in p[4:])) * (op in ("neg", "copy"))
        if op in ("sin", "cos"):
            before, turn, own = F(1), (op, x[0]), sine * max(u * min(1, 2 * (s + a[1])), 2 * eta)
        elif op == "mul":
            turn = next(((*y[4], z[0], z[1], y[1] * z[0] + a[1] * b[1] + r)
                         for y, z in ((a, b), (b, a)) if len(y[4]) == 2), ())
            form = (f[0], {f[1], g[1]}, f == g, True) if len(f) == 2 and f[::2] == g[::2] else ()
            own = eta if any(y[0].isdigit() and F(y) == below(2 * F(y)) for y in x) else own
        elif op in ("add", "sub") and len(f) == 4 and f[::2] == g[::2] and not f[1] & g[1]:
            form = f[0], f[1] | g[1], f[2], op == "add" and f[3] and g[3]
        elif op in ("add", "sub") and len(p) == len(q) == 5 and p[1] == q[1] and p[0] != q[0]:
            gap, size = e - r - p[4] - q[4], min(size, s if s * s >= p[2]**2 + q[2]**2 else size)
        least_size = F(999, 1000) * (form[2:] == (True, True) and len(form[1]) == 4)
        assert r >= own * (not pairs) and near(before, F.__ceil__) * eta < 2 * u * (1 - u), name
        assert e - r >= moved or gap >= 0 and gap**2 >= p[3]**2 + q[3]**2, f"error of {name}"
        assert s >= min([size] + [F(1001, 2000) * (1 + x) for x in form[2:3]]), f"size of {name}"
        known[name] = s, e, near(before, F.__ceil__), least_size, turn, form

print(check(open(0)) or "proved")
