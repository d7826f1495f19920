/*
 * art_items.c - items to collect, as they fall: tokens with a bevelled rim and a sign, and a splinter. All on bank 0,
 * so that adding a bank recolours them.
 */
#include "art.h"

enum { TOKEN = 14, SHARD = 10, SIGN_W = 6, SIGN_H = 8 };

static const char *const SIGNS[][SIGN_H] = {
    { "XXXXX.", "XX.XXX", "XX..XX", "XX.XXX", "XXXXX.", "XX....", "XX....", "XX...." }, /* power */
    { "..XX..", ".XXXX.", "XX..XX", "XX..XX", "XX..XX", "XX..XX", ".XXXX.", "..XX.." }, /* points */
    { "......", "XX..XX", "XXXXXX", "XXXXXX", "XXXXXX", ".XXXX.", "..XX..", "......" }, /* a life */
    { "..XX..", "..XX..", "XXXXXX", "XXXXXX", "..XX..", "..XX..", "..XX..", "......" }, /* a bomb */
};

/* Light from the upper left; the corners are cut. */
static void token(struct sheet *s, int x0, const char *const sign[SIGN_H])
{
    const int last = TOKEN - 1, dx = (TOKEN - SIGN_W) / 2, dy = (TOKEN - SIGN_H) / 2;

    for (int y = 0; y < TOKEN; y++)
        for (int x = 0; x < TOKEN; x++) {
            int near = x < y ? x : y, far = last - (x > y ? x : y);
            if ((x == 0 || x == last) && (y == 0 || y == last))
                continue;
            int c = near == 0 || far == 0 ? 2 : near == 1 ? 12 : far == 1 ? 4 : 7;
            int u = x - dx, v = y - dy;
            if (u >= 0 && u < SIGN_W && v >= 0 && v < SIGN_H && sign[v][u] == 'X')
                c = 15;
            else if (u > 0 && u <= SIGN_W && v > 0 && v <= SIGN_H && sign[v - 1][u - 1] == 'X')
                c = 3;
            sheet_set(s, x0 + x, y, c);
        }
}

static void shard(struct sheet *s, int x0)
{
    for (int y = 0; y < SHARD; y++)
        for (int x = 0; x < SHARD; x++) {
            int u = 2 * x - SHARD + 1, v = 2 * y - SHARD + 1, a = u < 0 ? -u : u, b = v < 0 ? -v : v;
            int rim = SHARD - a - b;
            if (rim >= 0)
                sheet_set(s, x0 + x, y, rim < 2 ? 5 : u + v < -1 ? 15 : u < v ? 11 : 8);
        }
}

struct sheet art_items(void)
{
    struct sheet s = sheet_new(128, 16, 0);

    for (int i = 0; i < (int)(sizeof SIGNS / sizeof *SIGNS); i++)
        token(&s, 16 * i, SIGNS[i]);
    shard(&s, 64);
    return s;
}
