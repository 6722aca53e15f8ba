"""Checks the instructions of pairs, which are indented, beside check_bounds.py, which checks their
values: python check_pairs.py < FILE"""
from fractions import Fraction as F

def plus(f, g, c=1):  # f + c g of polynomials, dicts from sorted names to factors
    return {k: z for k in {**f, **g} if (z := f.get(k, 0) + c * g.get(k, 0))}

def below(x):  # the largest power of two below x
    return y if (y := F(2)**(x.numerator.bit_length() - x.denominator.bit_length())) < x else y / 2

def check(lines):  # of a number x: size, polynomial; 'x is what its rounding loses: exact less x
    (digits, least, sine, rest), *steps = (x.rstrip().split(" ") for x in lines if x[0] != "#")
    u, eta, size, form = F(1, 2**int(digits)), F(2)**(int(least) - int(digits)), {}, {}
    equal, value, sums, exact, one, truth = {}, {}, {}, set(), {(): 1}, None
    rounding = lambda x: max(u * below(x), eta) if x else F(0)
    near = lambda x, of=round: of(x / (unit := 2 * rounding(abs(x)) or 1)) * unit
    product = lambda k: size[k[0]] * product(k[1:]) if k else F(1)
    most = lambda f: sum((abs(c) * product(k) for k, c in f.items()), F(0))
    def times(f, g, h={}):
        for n, c in [(tuple(sorted(k + m)), f[k] * g[m]) for k in f for m in g]:
            h = plus(h, equal.get(n, {n: 1}), c)
        return h
    def turned(op, a, b=None, *_):  # of the sum of one or two numbers
        if b is None:
            return {(f"{op} {a}",): 1}
        x, y = ({(f"{z} {a}",): 1} for z in (("sin", "cos") if op == "sin" else ("cos", "sin")))
        return plus(times(x, turned("cos", b)), times(y, turned("sin", b)), 1 - 2 * (op == "cos"))
    apply = {"add": plus, "sub": lambda f, g: plus(f, g, -1), "neg": lambda f, _: plus({}, f, -1),
             "mul": times, "div": lambda f, _: f, "copy": lambda f, _: f}
    for op, name, *x in steps:
        *_, p, e, q = 0, 0, 0, *(F(float.fromhex(y)) for y in x if y[:2] == "0x")
        a, *b = x = [y for y in x if y[:2] != "0x"] or [name]
        for y in (y for y in x if y[0] in "-0123456789"):  # a constant, as hi + lo or a number
            hi, lo = near(F(y)), near(F(y) - near(F(y)))
            size |= {str(z): abs(z) for z in (hi, lo)}
            form |= {str(z): {(str(z),): 1} for z in (hi, lo)}
            value[y if op else ""] = {(str(z),): 1 for z in (hi, lo)}
            assert op or hi == F(y), f"{y} is no number of the format"
        if op == "input":
            size[name], form[name], value[name] = p, {(name,): 1}, {(name,): 1}
        elif op:  # a value: its numbers' sum times the divisor is the truth, nearly
            g, reach, own = value[(b or x)[0]], p + e - q, q
            truth = apply[op](value[a], g) if op in apply else turned(op, *(y for y, in value[a]))
            divisor, left = (g, F(b[1])) if op == "div" else (one, F(1))
            value[name] = truth
        elif name == "is":  # the numbers whose sum stands for the value
            f = {}
            for y in b:
                f = plus(f, form.get(y, {(y,): 1}))
            off = plus(times(f, divisor), times(truth, one), -1)
            assert most(off) <= own * left, f"error of {a}"
            size[b[0]] = min(size[b[0]], reach + own + sum(size[y] for y in b[1:]))
            form, value[a], truth = form | {y: {(y,): 1} for y in b}, {(y,): 1 for y in b}, None
        else:
            op, name, a, b, c, kind = name, a, *(2 * b)[:2], b[-1], f"{name[:3]} {b[0]}"
            size[kind], lost = min(size[a], F(1)) if op[0] == "s" else F(1), None
            limit = {"add": size[a] + size[c], "sub": size[a] + size[c], "mul": size[a] * size[c]}
            assert op in {*apply, "error", "rest", "sin", "cos", "sin_rest", "cos_rest"}, op
            if op in ("error", "rest"):
                f = plus(times(form[a], form[b]), form[c], -1)
            else:
                f = apply[op](form[a], form[c]) if op in apply else plus(
                    turned(op[:3], a), form[c] if "_" in op else {}, -1)
            if op == "div":
                limit[op] = size[a] / (left - most({k: 1 for k in [*divisor][1:]}))
                f, size[name] = {(name,): 1}, limit[op]
                assert [(c,)] == [*divisor][:1] and form[c] == {(c,): 1} and limit[op] >= 0, name
            top = min(most(f), limit.get(op, most(f)))
            if truth and divisor == one:
                top = min(top, reach + most(plus(f, times(truth, one), -1)))
            lost = {"sin": F(sine) * max(u * min(1, 2 * size[kind]), 2 * eta), "error": eta,
                    "sin_rest": F(float.fromhex(rest)) * size[kind] + 2 * eta, "neg": F(0),
                    }.get(op.replace("cos", "sin"), rounding(top))
            if op == "mul" and any(y[0].isdigit() and F(y) == below(2 * F(y)) for y in (a, c)):
                lost = eta
            if op in ("add", "sub"):  # of numbers, so that one of them is as near
                lost = min(lost, size[a], size[c]) * (frozenset(f.items()) not in exact)
            need = F(1) if op in ("sin", "cos") else near(top, F.__ceil__)
            need = top + lost if "_" in op else min(top + lost, need)
            assert q >= lost and e >= need and e * eta < 2 * u * (1 - u), name
            size[name], size["'" + name], r, sign = e, q, {("'" + name,): 1}, 1 - 2 * (op == "sub")
            form[name] = plus(f, r, -1 if q else 0)
            if op == "mul" and len(f) == 1 and {*f.values()} <= {1, -1}:
                (k, s), = f.items()
                equal[k], form[name] = {(name,): s, ("'" + name,): s}, {(name,): 1}
            if op == "div":
                form[name], equal[tuple(sorted((name, c)))] = f, plus(
                    form[a], times(r, form[c]), -1)
            if op in ("add", "sub"):  # what Two-Sum finds without a loss
                for s, y, z, d in [(s, *sums[s]) for s in (a, c) if s in sums]:
                    if op == "sub" and [a, c] == [s, y][::d]:
                        found = plus(form[s], form[name], -d), plus(form[z], form[name], -1)
                        exact |= {frozenset(plus({}, w, m).items()) for w in found for m in (1, -1)}
                sums[name] = a, c, sign
                exact |= {frozenset({("'" + name,): m}.items()) for m in (1, -1)}

print(check(open(0)) or "proved")
