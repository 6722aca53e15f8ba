"""Checks the lengths of vectors in certificates of rounding errors, given the bounds of the values
that check_bounds.py checks, with fractions alone: python check_lengths.py < FILE"""
from fractions import Fraction as F

def check(lines):
    (digits, least, *_), *steps = (x.split() for x in lines if x[0] not in "# ")
    eta, known = F(2)**(int(least) - int(digits)), {frozenset([""]): (F(0), F(0))}
    made = {name: (op, x[:2], F(float.fromhex(r))) for op, name, *x, _, _, r in steps}
    assert len(made) == len(steps), "a name stands twice"

    def constant(x):  # its size, and what its rounding loses
        c = abs(F(x))
        unit = F(2)**(c.numerator.bit_length() - c.denominator.bit_length() - int(digits) - 1)
        while c / unit >= 2**int(digits):
            unit *= 2
        return c, abs(c - round(c / (unit := max(unit, 2 * eta))) * unit)

    for op, name, *x, s, e, _ in steps:
        s, e = F(float.fromhex(s)), F(float.fromhex(e))
        if op != "input_length":
            assert len(x) < 3 or op in ("input", "add", "sub") and x[2:] == [f"{name},"], name
            known[frozenset([name])] = s, e
            known |= {frozenset([y]): constant(y) for y in x[:2]
                      if op != "input" and y not in made and y[-1].isdigit()}
            continue
        v, a, b = (y.split(",") for y in [name.rstrip(","), *x[1:], "", ""][:3])
        (length, error), (by, moved) = (known[frozenset(y)] for y in (a, b))
        parts, rule = [known.get(frozenset([y]), (s + 1, e + 1)) for y in v], x[0]
        own, k, size = F(0), len(v) - len(b), F(1)
        sure = all(len({*y}) == len(y) for y in (v, a, b))
        if rule == "circle":  # sine and cosine of one angle
            error, sure = None, sorted(made[y][0] + made[y][1][0] for y in v) == [
                f"{y}{made[v[0]][1][0]}" for y in ("cos", "sin")]
        elif rule == "sum":
            size, error, own = length + by, error + moved, sum(made[y][2]**2 for y in v[k:])
            sure &= len(a) == len(v) and a[:k] == v[:k] and all(
                made[y][0] in ("add", "sub") and sorted(made[y][1]) == sorted(z)
                for y, *z in zip(v[k:], a[k:], b))
        elif rule == "multiple":
            size, error = by * length, by * error + moved * (length + error)
            own = sum(made[y][2]**2 for y in v)
            sure &= len(a) == len(v) and len(b) == 1 and all(
                made[y][0] == "mul" and sorted(made[y][1]) == sorted([z, *b]) for y, z in zip(v, a))
        elif rule in ("turn", "result"):  # of p and q by f and g: of a vector, of one component
            n = len(v) - len(a) + 2
            (p, q), (f, g), forms = a[:2], b, []
            for y in v[:n]:
                terms = [made[z] for z in made[y][1]]
                factors = sorted(sorted(z[1]) for z in terms)
                ways = [sorted(map(sorted, z)) for z in (((f, p), (g, q)), ((g, p), (f, q)))]
                sure &= {z[0] for z in terms} == {"mul"} and factors in ways
                forms.append((made[y][0], ways.index(factors) if sure else 2))
                own += (made[y][2] * (rule == "turn") + sum(z[2] for z in terms))**2
            sure &= n in (1, 2) and a[2:] == v[n:] and {z[0] for z in forms} <= {"add", "sub"} \
                and all(len({*z}) == n for z in zip(*forms)) and (len(v) == 1) == (rule != "turn")
            by = max(by, F(rule == "turn"))
            size, error = by * length, by * error + moved * (length + error)
        else:
            sure &= rule == "components"
            size = error = None
        assert sure, f"rule of {name}"
        assert s**2 >= sum(y[0]**2 for y in parts) or size is not None and s >= size, name
        assert e**2 >= sum(y[1]**2 for y in parts) or error is not None and e >= error and \
            (e - error)**2 >= own, f"error of {name}"
        if len(v) > 1:
            known[frozenset(v)] = s, e

print(check(open(0)) or "proved")
