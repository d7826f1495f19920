/*
 * art_icon.c - the program's icon: the heron below half rings of bullets.
 *
 * A pixel is a colour of the whole palette, bank included, so the sheet's own bank is 0.
 */
#include "art.h"

#include <math.h>

enum { SEA = 6, GOLD = 3, CYAN = 5, MAGENTA = 7 };

/* Copies w x h pixels at (sx, sy) of a sheet to (x, y), in the colours of a bank. */
static void copy(struct sheet *to, int x, int y, const struct sheet *from, int sx, int sy, int w, int h, int bank)
{
    for (int i = 0; i < w * h; i++) {
        int shade = sheet_get(from, sx + i % w, sy + i / w);

        if (shade)
            sheet_set(to, x + i % w, y + i / w, bank * 16 + shade);
    }
}

/* How far (x, y) is inside a square with round corners; below 0: outside. */
static double depth(double x, double y, double size)
{
    const double corner = size * 0.22, half = size / 2;
    double dx = x - half, dy = y - half;

    dx = (dx < 0 ? -dx : dx) - (half - corner);
    dy = (dy < 0 ? -dy : dy) - (half - corner);
    if (dx > 0 && dy > 0)
        return corner - sqrt(dx * dx + dy * dy);
    return corner - (dx > dy ? dx : dy);
}

/* The sea: lighter at the top, in bands that roll, with a rim around it. */
static void sea(struct sheet *s)
{
    for (int y = 0; y < s->h; y++) {
        for (int x = 0; x < s->w; x++) {
            double d = depth(x + 0.5, y + 0.5, s->w), u = (double)x / s->w, v = (double)y / s->h;
            double roll = 0.035 * art_sin(1.5 * u + 0.4 * v) + 0.02 * art_sin(3 * u - v);
            int shade = (int)art_clamp(4.9 - 3.9 * (v + roll), 1, 4);

            if (d >= 0)
                sheet_set(s, x, y, SEA * 16 + (d < 1.2 ? 1 : d < 2.2 ? shade + 2 : shade));
        }
    }
}

/* A bullet of radius r around (x, y): dark rim, bright body, white core. */
static void bullet(struct sheet *s, double x, double y, double r, int bank)
{
    for (int py = (int)(y - r); py <= (int)(y + r); py++) {
        for (int px = (int)(x - r); px <= (int)(x + r); px++) {
            double dx = px + 0.5 - x, dy = py + 0.5 - y, d = r - sqrt(dx * dx + dy * dy);

            if (d > 0)
                sheet_set(s, px, py, bank * 16 + (d < 0.9 ? 3 : d < 1.8 ? 8 : d < 2.4 ? 12 : 15));
        }
    }
}

/* Half a ring of n bullets around the top's middle; those that would touch the ship are left out. */
static void ring(struct sheet *s, double far, int n, double r, double top, int bank)
{
    for (int i = 0; i < n; i++) {
        double turn = (i + 0.5) / n * 0.5, dx = (int)(far * art_cos(turn)), x = s->w * 0.5 + dx;
        double y = (int)(r + 4 + far * art_sin(turn)), wide = 3 + 0.42 * (y - top);

        if (depth(x, y, s->w) > r + 2 && (y < top - r || (dx < 0 ? -dx : dx) > wide + r))
            bullet(s, x, y, r, bank);
    }
}

struct sheet art_icon(int size)
{
    struct sheet s = sheet_new(size, size, 0), heron = art_heron();
    static const int banks[] = { GOLD, MAGENTA, CYAN, MAGENTA, CYAN, MAGENTA, CYAN, MAGENTA };
    const int top = size - 36 - size / 16;
    const double r = 3, far = size / 8.0 + 0.4;

    sea(&s);
    bullet(&s, size * 0.5, r + 4, r + 1, GOLD);
    for (int i = 1; i < 8; i++)
        ring(&s, i * far, 3 * i + 1, r, top, banks[i]);
    copy(&s, (size - 28) / 2, top, &heron, 0, 0, 28, 36, heron.bank);
    sheet_free(&heron);
    return s;
}
