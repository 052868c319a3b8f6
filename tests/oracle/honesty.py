"""Reference values of tests/values/honesty.rs: g(x) = x * int f'(x sin t) dt, with every kink told, at 50 digits.

Run: python3 tests/oracle/honesty.py > tests/oracle/honesty.csv   (needs mpmath)
Columns: profile, quantity, at, value. Points are exact f64 values.
"""
from mpmath import mp, mpf, quad, asin, sin, sqrt, exp, pi, diff, findroot, besselj, cos

mp.dps = 50


def g(slope, x, kinks=()):
    """x * integral of slope(x sin t) over t, split at the kinks."""
    x = mpf(x)
    places = [mpf(0)] + [asin(mpf(k) / x) for k in kinks if 0 < k < x] + [pi / 2]
    return x * quad(lambda t: slope(x * sin(t)), places)


def row(profile, quantity, at, value):
    print(f"{profile};{quantity};{at!r};{mp.nstr(value, 40)}")


two = mp.log(2)
sign = lambda k: lambda r: -1 if r < k else 1
for at in (0.6931471805599455, 0.69314718056, 1.0, 2.5):
    row("abs(exp(r)-2)", "g", at, g(lambda r: sign(two)(r) * exp(r), at, [two]))
far = two * mpf(10) ** 5
for at in (1e5,):
    row("abs(exp(r/100000)-2)", "g", at, g(lambda r: sign(far)(r) * exp(r / 10**5) / 10**5, at, [far]))
root = sqrt(mpf(44) / 100)
cap = lambda r: (0 if r < root else r / sqrt(mpf(144) / 100 - r**2)) + 2 * r / 5
for at in (0.6633249580710802, 0.7, 1.1):
    row("max(0,1-sqrt(1.44-r^2))+r^2/5", "g", at, g(cap, at, [root]))
golden = (1 + sqrt(mpf(5))) / 2
for at in (1.0, 1.618033988749895, 3.0):
    row("abs(r^2-r-1)", "g", at, g(lambda r: -(2 * r - 1) if r < golden else 2 * r - 1, at, [golden]))
for at in (1.0, 2.9):
    row("r^2/(r-3)", "g", at, g(lambda r: (r**2 - 6 * r) / (r - 3) ** 2, at))
row("piecewise(sqrt(2)-sqrt(2-r^2), r<1, sqrt(2)-1)", "g", 1.5,
    g(lambda r: r / sqrt(2 - r**2) if r < 1 else 0, 1.5, [1]))
wavy = lambda a: g(lambda r: r + mpf("2.7") * besselj(1, 9 * r), a) - mpf(0.6)
row("r^2/2+0.3*(1-besselj(0,9*r))", "a", 0.6, findroot(wavy, (mpf("0.26"), mpf("0.28")), solver="anderson"))
row("1-besselj(0,7*r)", "a", 1.5, mp.acos(-mpf(1) / 2) / 7)
