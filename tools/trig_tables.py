#!/usr/bin/env python3
"""trig_tables.py - makes src/base/trig_tables.h: polynomials for the first guesses of sines, headings and arc tangents.

    tools/trig_tables.py >src/base/trig_tables.h

Each polynomial interpolates its function at the Chebyshev nodes of its cell. All is computed with 300-bit integers and
fractions, and rounded once. On stderr: how far each table is off at most, over 200 points a cell.
"""
import sys
from fractions import Fraction
from math import isqrt

BITS = 300
ONE = 1 << BITS


def times(a, b):
    return a * b >> BITS


def arc_of_inverse(n):
    """atan(1/n), scaled by ONE."""
    term = total = ONE // n
    k = 1
    while term:
        term = -(term // (n * n))
        k += 2
        total += term // k
    return total


PI = 4 * (4 * arc_of_inverse(5) - arc_of_inverse(239))


def circle(x):
    """cos x and sin x, x and both scaled by ONE."""
    parts, term, n = [ONE, 0], ONE, 0
    while term:
        n += 1
        term = times(term, x) // n
        parts[n & 1] += -term if n & 2 else term
    return parts


def arc(x):
    """atan x, scaled by ONE: halved six times, then the series."""
    for _ in range(6):
        x = (x << BITS) // (ONE + isqrt((ONE << BITS) + x * x))
    total, term, k = x, x, 1
    while abs(term) > 1:
        term = -times(term, times(x, x))
        k += 2
        total += term // k
    return total << 6


def rounded(v):
    """The whole number nearest to a fraction."""
    return (2 * v.numerator + v.denominator) // (2 * v.denominator)


def interpolate(f, degree, low, high):
    """The coefficients, lowest first, of the polynomial that meets f at the Chebyshev nodes of low..high."""
    n = degree + 1
    nodes = [Fraction(circle(PI * (2 * k + 1) // (2 * n))[0], ONE) for k in range(n)]
    nodes = [(low + high) / 2 + (high - low) / 2 * x for x in nodes]
    rows = [[x**c for c in range(n)] + [f(x)] for x in nodes]
    for i in range(n):
        rows[i] = [v / rows[i][i] for v in rows[i]]
        for j in range(n):
            if j != i:
                rows[j] = [a - rows[j][i] * b for a, b in zip(rows[j], rows[i])]
    return [Fraction(int(row[n] * ONE), ONE) for row in rows]


def fixed(x):
    return x.numerator * ONE // x.denominator


# ---- sines: 512 cells of a turn, f = 0 .. 2^23 - 1 within one: (base + slope f + bend (f f >> 23)) / 2^40 ----

CELLS, STEPS, SCALE = 512, 1 << 23, 1 << 40


def sine_cell(i):
    def f(x):
        return Fraction(65536 * circle(2 * PI * (i * x.denominator + x.numerator) // (CELLS * x.denominator))[1], ONE)

    c = interpolate(f, 2, Fraction(0), Fraction(1))
    return rounded(c[0] * SCALE) + SCALE // 2, rounded(c[1] * SCALE / STEPS), rounded(c[2] * SCALE / STEPS)


def sine_error(i, cell):
    worst = 0
    for k in range(201):
        f = min(k * STEPS // 200, STEPS - 1)
        v = cell[0] + cell[1] * f + cell[2] * (f * f >> 23) - SCALE // 2
        true = 65536 * circle(2 * PI * (i * STEPS + f) // (CELLS * STEPS))[1] * SCALE >> BITS
        worst = max(worst, abs(v - true))
    return worst


# ---- arcs: 65 cells of 0..1, h = -1/128 .. 1/128 about i/64: a polynomial of degree 4, in 2^-24 ang, plus 1/2 ang ----

HALF = 1 << 23


def arc_value(x):
    return Fraction((arc(fixed(x)) << 56) * ONE // (2 * PI), ONE)


def arc_cell(i):
    c = interpolate(lambda h: arc_value(Fraction(i, 64) + h), 4, Fraction(-1, 128), Fraction(1, 128))
    c[0] += HALF
    return [float(v) if abs(v) > 1 else 0.0 for v in c]


def arc_error(i, cell):
    worst = 0
    for k in range(-100, 101):
        h = Fraction(k, 12800)
        if 0 <= Fraction(i, 64) + h <= 1:
            v = sum(Fraction(c) * h**n for n, c in enumerate(cell)) - HALF
            worst = max(worst, abs(v - arc_value(Fraction(i, 64) + h)))
    return worst


# ---- headings: RAYS rays of a turn, and what lies between them, h = -1/2 .. 1/2 of their distance in 2^-40 turns ----

RAYS = 256
REACH = Fraction(1 << 40, 2 * RAYS)


def ray_parts(h):
    """Cosine and sine of h / 2^40 turns."""
    return [Fraction(v, ONE) for v in circle(2 * PI * h.numerator // (h.denominator << 40))]


def ray(i):
    return [float(v) if abs(v) > Fraction(1, 1 << 60) else 0.0 for v in ray_parts(Fraction(i << 40, RAYS))]


def ray_step():
    """The sine is odd: (s0 + s1 h^2) h. The cosine is even: 1 - (v0 + v1 h^2) h^2."""
    sine = interpolate(lambda h: ray_parts(h)[1], 4, -REACH, REACH)
    versine = interpolate(lambda h: (1 - ray_parts(h)[0]) / h**2, 3, -REACH, REACH)
    return [float(v) for v in (sine[1], sine[3], versine[0], versine[2])]


def ray_error(step):
    s0, s1, v0, v1 = map(Fraction, step)
    worst = 0
    for k in range(1, 201):
        h = REACH * k / 200
        c, s = ray_parts(h)
        c, s = 1 - (v0 + v1 * h**2) * h**2 - c, (s0 + s1 * h**2) * h - s
        worst = max(worst, c * c + s * s)
    return float(worst) ** 0.5


# ---- the header ----


# ---- strides: 513 directions of an eighth of a turn, in Q64 ----

WAYS = 512


def way(i):
    return [min(rounded(Fraction(v << 64, ONE)), (1 << 64) - 1) for v in circle(PI * i // (4 * WAYS))]


def column(values, suffix=""):
    line, lines = "   ", []
    for v in values:
        text = " %s%s," % (v, suffix)
        if len(line) + len(text) > 118:
            lines.append(line)
            line = "   "
        line += text
    return "\n".join(lines + [line])


def main():
    sines = [sine_cell(i) for i in range(CELLS)]
    arcs = [arc_cell(i) for i in range(65)]
    print("sines: off by at most %d / 2^40 of a unit" % max(map(sine_error, range(CELLS), sines)), file=sys.stderr)
    print("arcs: off by at most %.0f / 2^24 of an ang" % max(map(arc_error, range(65), arcs)), file=sys.stderr)
    step = ray_step()
    print("headings: off by at most %.4f / 2^44 of one" % (ray_error(step) * 2**44), file=sys.stderr)
    print("""/*
 * trig_tables.h - first guesses of sines, headings and arc tangents; made by tools/trig_tables.py.
 */
#ifndef BASE_TRIG_TABLES_H
#define BASE_TRIG_TABLES_H

#include <stdint.h>

/* clang-format off */
/* 512 cells of a turn, f = 0 .. 2^23 - 1 in each: 65536 sine + 1/2 is
 * (base + slope * f + bend * (f * f >> 23)) / 2^40. */
static const struct {
    int64_t base[512];
    int32_t slope[512], bend[512];
} SINE = {""")
    for k in range(3):
        print("    {\n%s\n    }," % column(c[k] for c in sines))
    print("""};

/* Cosine and sine, in Q64, of 513 directions of an eighth of a turn; one is 2^64 - 1. */
static const uint64_t WAY[513][2] = {""")
    print(column("{ 0x%016x, 0x%016x }" % tuple(way(i)) for i in range(WAYS + 1)))
    print("""};

#ifndef FX_INTEGER
/* 65 cells of 0..1: atan(i / 64 + h) in 2^-24 angs, plus half an ang, as a polynomial in h. */
static const double ARC[65][5] = {""")
    for c in arcs:
        print("    { %s,\n      %s }," % (", ".join(v.hex() for v in c[:3]), ", ".join(v.hex() for v in c[3:])))
    print("""};

/* Cosine and sine of each of 256 rays. */
static const double RAY[256][2] = {""")
    print(column(("{ %s, %s }" % tuple(v.hex() for v in ray(i)) for i in range(RAYS))))
    print("""};

/* The sine of h / 2^40 turns, |h| <= 2^31, is (a + b h^2) h; one less its cosine is (c + d h^2) h^2. */
static const struct {
    double a, b, c, d;
} RAY_STEP = { %s };
#endif
""" % ", ".join(v.hex() for v in step) + """/* clang-format on */

#endif""")


main()
