"""Checks certificates of rounding errors, with fractions alone: python check_bounds.py < FILE"""
from fractions import Fraction as F

VALUES = {"input": 0, "add": 2, "sub": 2, "mul": 2, "div": 2, "neg": 1, "sin": 1, "cos": 1}
PLAIN, PAIRS = {"input_length": 1, "single": 1, **VALUES}, {"copy": 1, **VALUES}  # operands of each
NUMBERS = {"add": 2, "sub": 2, "mul": 2, "div": 2, "neg": 1, "sin": 1, "cos": 1, "sin_rest": 2,
           "cos_rest": 2, "error": 3, "rest": 4}  # those of instructions on pairs, indented

def read(lines):  # the first line; and of each: whether indented, operation, name, words, figures
    (_, *head), *steps = ([x[0] == " ", *x.split()] for x in lines if x[0] != "#")
    names, table = set(), PAIRS if len(head) == 4 else PLAIN
    for n, (inner, op, name, *x) in enumerate(steps):
        whole, count = (NUMBERS[op], 2) if inner and op != "is" else (len(x), 0) if inner else (
            table[op], 3)
        x, figures = x[:len(x) - count], [F(float.fromhex(y)) for y in x[len(x) - count:]]
        more = x[whole:]  # a quaternion; vectors; the length that bounds a turn; the least divisor
        most = {"input": 1, "input_length": 2, "add": 1, "sub": 1, "div": len(head) - 3}
        assert len(x) >= whole and len(more) <= most.get(op, 0) * (not inner), f"words of {name}"
        assert op not in ("add", "sub") or more in ([], [f"{name},"]), f"words of {name}"
        assert len(figures) == count and (not inner or len(head) == 4), f"words of {name}"
        single = name[0] not in "-.'0123456789" and "," not in name + "".join(x[:whole])
        assert "," in name if op == "input_length" else single, f"words of {name}"
        assert min(figures, default=0) >= 0, f"figures of {name}"
        assert op == "is" or (inner, name) not in names, f"{name} stands twice"
        names.add((inner, name))
        steps[n] = inner, op, name, x, figures
    return head, steps

def below(x):  # the largest power of two below x
    return y if (y := F(2)**(x.numerator.bit_length() - x.denominator.bit_length())) < x else y / 2

def rounding(x, u, eta):  # the most that rounding a number up to x loses
    return max(u * below(x), eta) if x else F(0)

def near(x, u, eta, of=round):  # the number of the format that is near x
    return of(x / (unit := 2 * rounding(abs(x), u, eta) or 1)) * unit

def scales(*x):  # whether one of these is a power of two
    return any(y[0].isdigit() and F(y) == below(2 * F(y)) for y in x)

def units(digits, least):  # half the distance from 1 to the next number, and half the least number
    return F(1, 2**int(digits)), F(2)**(int(least) - int(digits))

def values(head, steps):  # of a value: size, error, size as computed, least size, turn, form
    (*whole, sine), pairs, known = head[:3], len(head) == 4, {}
    for _, op, name, x, (s, e, r) in (y for y in steps if not y[0]):  # pairs() finds r of pairs
        u, eta = units(*whole)
        for y, c in ((z, abs(F(z))) for z in x if z not in known and op[:5] != "input"):
            d = c - near(c, u, eta)
            known[y] = c, abs(d - near(d, u, eta) * pairs), c - d, c, (), ()
        u, eta = units(24, -126) if op == "single" else (u, eta)
        given = [(s, F(0), s, F(0), (), (*x, name))] if op[:5] == "input" else [known[y] for y in x]
        a, b = given[0], given[:2][-1]
        size, moved, top = {  # bounds of size, of error before rounding, of the size as computed
            "add": [y + z for y, z in zip(a[:3], b)],
            "mul": (a[0] * b[0], a[0] * b[1] + a[1] * b[0] + a[1] * b[1], a[2] * b[2]),
            "div": (a[0] / b[3] if b[3] - b[1] >= (sum(y[0] for y in given[2:]) or eta) else s + 1,
                    (a[1] + s * b[1]) / (b[3] - b[1] or 1), 1 / eta),
            "sin": (min(a[0], 1), a[1], 1), "cos": (1, a[1], 1)}.get(
                op.replace("sub", "add"), a[:3])
        size, moved = map(min, (size, moved), (given[2:] * (op != "div") or [(size, moved)])[0])
        before, (p, f), (q, g), gap = min(s + e - r, F(top)), a[4:], b[4:], F(-1)
        own, form = rounding(before, u, eta), f * (op in ("input", "copy"))
        turn = (*p[:4], *(y + r for y in p[4:])) * (op in ("neg", "copy"))
        if op in ("sin", "cos"):
            before, turn = F(1), (op, x[0])
            own = F(sine) * max(u * min(1, 2 * (s + a[1])), 2 * eta)
        elif op == "mul":
            turn = next(((*y[4], z[0], z[1], y[1] * z[0] + a[1] * b[1] + r)
                         for y, z in ((a, b), (b, a)) if len(y[4]) == 2), ())
            form = (f[0], {f[1], g[1]}, f == g, True) if len(f) == 2 and f[::2] == g[::2] else ()
            own = eta if scales(*x) else own
        elif op in ("add", "sub") and len(f) == 4 and f[::2] == g[::2] and not f[1] & g[1]:
            form = f[0], f[1] | g[1], f[2], op == "add" and f[3] and g[3]
        elif op in ("add", "sub") and len(p) == len(q) == 5 and p[1] == q[1] and p[0] != q[0]:
            gap, size = e - r - p[4] - q[4], min(size, s if s * s >= p[2]**2 + q[2]**2 else size)
        elif op[:5] in ("input", "neg"):
            own = F(0)
        least = F(999, 1000) * (form[2:] == (True, True) and len(form[1]) == 4)
        full = near(before, u, eta, F.__ceil__)
        assert r >= own * (not pairs) and full * eta < 2 * u * (1 - u), f"rounding of {name}"
        assert e - r >= moved or gap >= 0 and gap**2 >= p[3]**2 + q[3]**2, f"error of {name}"
        assert s >= min([size] + [F(1001, 2000) * (1 + x) for x in form[2:3]]), f"size of {name}"
        known[name] = s, e, full, least, turn, form

def lengths(head, steps):  # of vectors, given the bounds of their components
    (u, eta), known = units(*head[:2]), {frozenset([""]): (F(0), F(0))}
    made = {name: (op, x[:2], figures[2]) for _, op, name, x, figures in steps}
    for _, op, name, x, (s, e, r) in steps:
        if op != "input_length":
            known[frozenset([name])] = s, e
            known |= {frozenset([y]): (abs(F(y)), abs(F(y) - near(F(y), u, eta))) for y in x[:2]
                      if op != "input" and y not in made and y[-1].isdigit()}
            continue
        v, a, b = (y.split(",") for y in [name.rstrip(","), *x[1:], "", ""][:3])
        (length, error), (by, moved) = (known[frozenset(y)] for y in (a, b))
        parts, rule = [known.get(frozenset([y]), (s + 1, e + 1)) for y in v], x[0]
        own, k, size = F(0), len(v) - len(b), F(1)
        sure = all(len({*y}) == len(y) for y in (v, a, b)) and (
            len(x) == 1 if rule in ("circle", "components") else len(x) == 3)
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

def plus(f, g, c=1):  # f + c g of polynomials, dicts from sorted names to factors
    return {k: z for k in {**f, **g} if (z := f.get(k, 0) + c * g.get(k, 0))}

def pairs(head, steps):  # of a number x: size, polynomial; 'x is what rounding loses: exact less x
    *whole, sine, rest = head
    (u, eta), size, form, equal, value, sums, exact = units(*whole), {}, {}, {}, {}, {}, set()
    products, truth, last, one = set(), None, (), {(): 1}
    product = lambda k: size[k[0]] * product(k[1:]) if k else F(1)
    most = lambda f: sum((abs(c) * product(k) for k, c in f.items()), F(0))
    def times(f, g, h={}):
        for n, c in [(tuple(sorted(k + m)), f[k] * g[m]) for k in f for m in g]:
            h = plus(h, equal.get(n, {n: 1}), c)
        return h
    def turned(op, a, b=None):  # of the sum of one or two numbers
        if b is None:
            return {(f"{op} {a}",): 1}
        x, y = ({(f"{z} {a}",): 1} for z in (("sin", "cos") if op == "sin" else ("cos", "sin")))
        return plus(times(x, turned("cos", b)), times(y, turned("sin", b)), 1 - 2 * (op == "cos"))
    apply = {"add": plus, "sub": lambda f, g: plus(f, g, -1), "neg": lambda f, _: plus({}, f, -1),
             "mul": times, "div": lambda f, _: f, "copy": lambda f, _: f}
    for inner, op, name, x, figures in [*steps, (False, "end", "", [], [])]:
        for y in (y for y in x if y[0] in "-0123456789"):  # a constant, as hi + lo or a number
            hi = near(F(y), u, eta)
            lo = near(F(y) - hi, u, eta)
            size |= {str(z): abs(z) for z in (hi, lo)}
            form |= {str(z): {(str(z),): 1} for z in (hi, lo)}
            value[y if not inner else ""] = {(str(z),): 1 for z in (hi, lo)}
            assert not inner or hi == F(y), f"{y} is no number of the format"
        if not inner:  # a value: its numbers' sum times the divisor is the truth, nearly
            assert truth is None or last[0] == "neg", f"no numbers stand for {last[1]}"
            last, truth, divisor, left = (op, name), None, one, F(1)
            if op == "input":
                size[name], form[name], value[name] = figures[0], {(name,): 1}, {(name,): 1}
            elif op != "end":
                g, reach, own = value[x[:2][-1]], figures[0] + figures[1] - figures[2], figures[2]
                truth = value[name] = apply[op](value[x[0]], g) if op in apply else turned(
                    op, *(y for y, in value[x[0]]))
            if op == "div":
                divisor, left = g, F(x[2])
        elif op == "is":  # the numbers whose sum stands for the value
            f = {}
            for y in x:
                f = plus(f, form.get(y, {(y,): 1}))
            off = plus(times(f, divisor), times(truth, one), -1)
            assert name == last[1] and most(off) <= own * left, f"error of {name}"
            size[x[0]] = min(size[x[0]], reach + own + sum(size[y] for y in x[1:]))
            form, value[name], truth = form | {y: {(y,): 1} for y in x}, {(y,): 1 for y in x}, None
        else:
            a, b, c, kind, (e, q) = x[0], (2 * x)[1], x[-1], f"{op[:3]} {x[0]}", figures
            size[kind] = min(size[a], F(1)) if op[0] == "s" else F(1)
            limit = {"add": size[a] + size[c], "sub": size[a] + size[c], "mul": size[a] * size[c]}
            if op in ("error", "rest"):
                f, loss = (plus(times(form[a], form[b]), form[y], -1) for y in (c, x[2]))
                assert [*map(abs, loss.values())] == [1] and products.issuperset(loss), \
                    f"{x[2]} is no product of {a} and {b}"
                apart = frozenset(plus(form[x[2]], form[c], -1).items())
                assert op == "error" or apart in exact, f"{x[2]} less {c} is rounded"
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
                    }.get(op.replace("cos", "sin"), rounding(top, u, eta))
            if op == "mul" and scales(a, c):
                lost = eta
            if op in ("add", "sub"):  # of numbers, so that one of them is as near
                lost = min(lost, size[a], size[c]) * (frozenset(f.items()) not in exact)
            need = F(1) if op in ("sin", "cos") else near(top, u, eta, F.__ceil__)
            need = top + lost if "_" in op else min(top + lost, need)
            assert q >= lost and e >= need and e * eta < 2 * u * (1 - u), name
            size[name], size["'" + name], r, sign = e, q, {("'" + name,): 1}, 1 - 2 * (op == "sub")
            form[name] = plus(f, r, -1 if q else 0)
            products |= {("'" + name,)} if op == "mul" else set()
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

def check(lines):
    head, steps = read(lines)
    values(head, steps)
    (pairs if len(head) == 4 else lengths)(head, steps)

print(check(open(0)) or "proved")
