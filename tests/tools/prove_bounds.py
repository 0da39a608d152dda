#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Error bounds by gappa: prove_bounds.py [fixed.c]. Of fx_recip_norm() and fx_rsqrt_norm() entry by entry of the tables
in firmware/fixed/fixed.c, and of a polynomial's steps from what its coefficients err by.

Each goal names what is rounded off as variables: of a floor, a number of [0, 1). What the true values are is in the
comments beside them; gappa shows that the rest stays within the bound."""
import concurrent.futures
import os
import re
import subprocess
import sys
from fractions import Fraction

SOURCE = open(sys.argv[1] if len(sys.argv) > 1 else "firmware/fixed/fixed.c").read()


def table(name):
    text = re.search(rf"{name}\[\w+\] = {{(.*?)}}", SOURCE, re.S).group(1)
    return [int(v) for v in re.findall(r"\d+", text)]


def number(x):
    """A fraction as gappa reads it: all of them are whole numbers times powers of 2, or bounds to be rounded outwards."""
    x = Fraction(x)
    up = max(0, x.denominator.bit_length() + 60)
    return f"{x.numerator * 2 ** up // x.denominator}b-{up}"


def interval(low, high):
    return f"[{number(low)}, {number(high + Fraction(1, 2 ** 200))}]"


def holds(text):
    return subprocess.run(["gappa"], input=text, text=True, capture_output=True).returncode == 0


def recip(i, x0):
    """r = x0 2^23 + floor(x0 e' / 2^16), e' = e + floor(s^2 / 2^9) + floor(s3 / 2^16), s = floor(e / 2^15 + 1/2), s3 =
    floor(s^2 / 2^17) s and e = 2^39 - x0 floor(m / 2). With eps = 1 - x0 m / 2^40, s / 2^24 = eps + g and
    (1 - eps) (1 + eps + eps^2 + eps^3) = 1 - eps^4, r m / 2^63 - 1 is what is called off."""
    first, last = 2 ** 31 + (i << 23), 2 ** 31 + (i + 1 << 23) - 1
    return f"""
g = odd * 1b-39 + half * 1b-24;
h = eps + g;
more = odd * 1b-39 + g * (eps + h) + g * (h * h + h * eps + eps * eps) - a * 1b-31 * h - (b + c) * 1b-39;
off = (1 - eps) * more - eps * eps * eps * eps - d * m;
{{ eps in {interval(1 - Fraction(x0 * last, 2 ** 40), 1 - Fraction(x0 * first, 2 ** 40))}
/\\ odd in [0, {number(Fraction(x0, 2))}] /\\ half in [-1b-1, 1b-1] /\\ a in [0, 1] /\\ b in [0, 1] /\\ c in [0, 1]
/\\ d in [0, 1] /\\ m in {interval(Fraction(first, 2 ** 63), Fraction(last, 2 ** 63))}
-> off in [-{RECIP_LOW}, {RECIP_HIGH}] }}"""


def rsqrt(i, y0):
    """r = y0 2^23 + floor(y0 floor(h' / 2^8) / 2^7), h' = h + floor(3 s^2 / 2^7), s = floor(h / 2^16), h = 2^37 - y0^2
    floor(m / 2^9). With eta = 1 - y0^2 m / 2^46, h / 2^37 = eta + cut 2^-37 and
    (1 - eta) (1 + eta / 2 + 3 eta^2 / 8)^2 = 1 - q: r sqrt(m) / 2^46 - 1 is what is called off. `size` is sqrt(1 - eta) =
    y0 2^23 sqrt(m) / 2^46, and r's own unit is sqrt(m) / 2^46."""
    first, last = 2 ** 30 + (i << 24), 2 ** 30 + (i + 1 << 24) - 1
    return f"""
q = eta * eta * eta * (5b-3 + eta * (15b-6 + eta * 9b-6));
g = cut * 1b-37;
k = g - a * 1b-21;
more = g * 1b-1 + 3b-3 * k * (2 * eta + k) - b * 1b-38;
size = sqrt(1 - eta);
off = -q / (1 + sqrt(1 - q)) + size * more - (c * {y0} * 1b-7 + d) * unit;
{{ eta in {interval(1 - Fraction(y0 * y0 * last, 2 ** 46), 1 - Fraction(y0 * y0 * first, 2 ** 46))}
/\\ cut in [0, {number(Fraction(y0 * y0 * 511, 512))}] /\\ a in [0, 1] /\\ b in [0, 1] /\\ c in [0, 1] /\\ d in [0, 1]
/\\ unit in [1b-31, 1b-30] -> off in [-{RSQRT}, {RSQRT}] }}"""


def sine(coefficients):
    """What the polynomial's roundings leave, in 2^-30: z falls short of x^2 by dz, each product by its floor. P is the
    polynomial from term k on, dk what p in its place is off by."""
    last = len(coefficients) - 1
    lines, given = [f"d{last} = 0;"], ["x in [0, 1b-1]", "z in [0, 1b-1]", "dz in [0, 2b-32]"]
    for k in range(last - 1, -1, -1):
        lines.append(f"d{k} = r{k} - d{k + 1} * z + P{k + 1} * dz;")
        given += [f"r{k} in [0, 1]", f"P{k + 1} in [0, {coefficients[k + 1]}]"]
    known = " /\\ ".join(given)
    return "\n".join(lines) + f"""
off = d0 * x - r;
{{ {known} /\\ r in [0, 1] -> off in [-{SINE}, {SINE}] }}"""


def steps(x, y, bound):
    """Coefficients that err by half a unit each, 2^-23 display units, X and Y steps from the exact start."""
    return f"""
off = f + d * x + e * y + a * x * x + b * y * y + c * x * y;
{{ f in [-1b-23, 1b-23] /\\ d in [-1b-23, 1b-23] /\\ e in [-1b-23, 1b-23] /\\ a in [-1b-23, 1b-23]
/\\ b in [-1b-23, 1b-23] /\\ c in [-1b-23, 1b-23] /\\ x in [-{x}, {x}] /\\ y in [-{y}, {y}]
-> off in [-{bound}, {bound}] }}"""


# What is proven; make test-exhaustive finds what is reached, 2^-30.46, 2^-30.72, 2^-20.64 and 1.19.
RECIP_LOW, RECIP_HIGH, RSQRT = (number(Fraction(2 ** (bits % 1)).limit_denominator(10 ** 6) * Fraction(2) ** int(bits // 1))
                                for bits in (-30.44, -30.66, -20.63))
SINE = 1.42


def main():
    goals = [("fx_recip_norm: within 2^-30.44, above by 2^-30.66 at most", [recip(i, 256 + v) for i, v in
                                                                           enumerate(table("recip_table"))]),
             ("fx_rsqrt_norm: within 2^-20.63", [rsqrt(i, v) for i, v in enumerate(table("rsqrt_table"))]),
             (f"fx_sin: roundings within {SINE} * 2^-30 of the polynomial", [sine(table("sin_coefficient"))]),
             ("a quadratic in Q22, 320 x 240 steps: within epsilon (X^2 + Y^2 + |XY| + |X| + |Y| + 1)",
              [steps(320, 240, f"{320 ** 2 + 240 ** 2 + 320 * 240 + 320 + 240 + 1}b-23")]),
             ("the same, 2048 x 2048", [steps(2048, 2048, f"{3 * 2048 ** 2 + 2 * 2048 + 1}b-23")])]
    failed = 0
    with concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as pool:
        for name, texts in goals:
            bad = [i for i, good in enumerate(pool.map(holds, texts)) if not good]
            print(f"{'FAIL' if bad else 'ok'} gappa {name}: {len(texts) - len(bad)} of {len(texts)} cases"
                  + (f", not {bad[:8]}" if bad else ""), flush=True)
            failed += bool(bad)
    sys.exit(failed != 0)


main()
