"""Checks certificates of fixed point, with fractions alone: python check_fixed.py < FILE"""
from fractions import Fraction as F

fits = lambda size, bits, wide: size * F(2)**bits <= 2**(63 if wide else 31) - 1

def check(lines):  # of a value: size, error, bits, whether it has 64 bits, turn
    (sine, quarter), *steps, values = *(x.split() for x in lines if x[0] != "#"), {}
    for op, name, *x, f, s, e, r in steps:
        f, (s, e, r), turn, own = int(f), (F(float.fromhex(y)) for y in (s, e, r)), (), F(0)
        count = {"input": 0, "sin": 1, "cos": 1, "neg": 1, "shift": 1}.get(op, 2) - len(x)
        assert count == 0 <= min(s, e, r) and name not in values and "@" not in name, name
        for y in (z for z in x if z not in values):
            word, at = y.split("@")  # a constant, or an integer with other bits, thus a multiple
            c, k = 0 if word in values else abs(F(word)), F(2)**int(at)
            z = values.get(word, (c, abs(c - round(c * k) / k), int(at), False))
            values[y] = *(w * F(2)**z[2] / k for w in z[:2]), int(at), z[3], ()
            assert fits(sum(values[y][:2]), int(at), z[3]), f"{y} overflows"
        a, *_, b = [values[y] for y in 2 * x] or 2 * [(s, F(0), f, False, ())]
        (size, moved, exact), total, last = a[:3], op in ("add", "sub"), F(2)**-f
        if op in ("mul", "high"):
            size, moved, exact = a[0] * b[0], a[0] * b[1] + a[1] * b[0] + a[1] * b[1], a[2] + b[2]
            own = last / 2 if op == "high" else last if f < exact else own
            turn = next(((*y[4], z[0], z[1], y[1] * z[0] + a[1] * b[1] + r)
                         for y, z in ((a, b), (b, a)) if len(y[4]) == 2), ())
        elif op in ("sin", "cos"):
            size, turn = min(a[0], 1) if op == "sin" else 1, (op, x[0])
            own = F(sine) + F(quarter) * ((sum(a[:2]) * F(6366198, 10**7) + F(51, 100)) // 1)
        elif op in ("shift", "neg"):
            turn, own = (*a[4][:4], *(y + r for y in a[4][4:])), last / 2 if f < exact else own
        elif total:
            size, moved, (p, q) = a[0] + b[0], a[1] + b[1], (a[4], b[4])
            if len(p) == len(q) == 5 and p[1] == q[1] and p[0] != q[0]:
                left = e - r - p[4] - q[4]
                size = s if s * s >= p[2]**2 + q[2]**2 else size
                moved = e - r if left >= 0 and left**2 >= p[3]**2 + q[3]**2 else moved
        bits = {"add": b[2], "sub": b[2], "neg": a[2], "high": exact - 32, "mul": f, "shift": f,
                "input": f, **dict.fromkeys(("sin", "cos"), 30 if 17 < exact < 31 else None)}
        long, n, wide = a[3] or b[3], a[2] - f, op == "mul" or op != "shift" and (a[3] or b[3])
        assert f == bits[op] and (n == 0 if total else op in ("neg", "shift") or not long), name
        half = sum(a[:2]) + last / 2 if op == "shift" and n > 0 and (n < 32 or long) else F(0)
        assert fits(s + e, f, wide) and fits(half, a[2], long), f"{name} overflows"
        assert s >= size and r >= own and e - r >= moved, f"size or error of {name}"
        values[name] = s, e, f, wide, turn

print(check(open(0)) or "proved")
