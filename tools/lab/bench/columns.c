/*
 * columns.c - the crowd as columns of int32, with masked words: see reference.h.
 *
 * What somebody writes who knows how compilers and stores work and has an hour. The loop that looks at every bullet
 * runs over 64 of them with restrict parameters, a constant trip count and no branch, so that it is vectorised without
 * flags; what it found is looked at one by one. A picture is 8 words of what to keep and 8 of what to add, made once.
 */
#include <stdlib.h>
#include <string.h>
#include "reference.h"

__extension__ typedef __int128 wide;

enum { BLOCK = 64, MOVED_OUT = 1, NEAR = 2, FAR_AWAY = INT32_MIN / 2 };

struct stamp {
    uint64_t keep[CROWD_SIDE], colour[CROWD_SIDE];
};

struct columns {
    struct crowd c;
    int32_t *x, *y, *vx, *vy; /* up to a whole block */
    uint16_t *due;            /* the frame in which it turns, modulo 65536 */
    uint8_t *grazed;
    uint32_t *slot;
    int first[CROWD_KINDS + 1];
    struct stamp stamps[CROWD_KINDS], ship;
    uint16_t frame;
    int pitch;
    uint8_t *mem, *pix;
    struct crowd_player player;
    int32_t fastest; /* no speed along an axis is above it */
};

/* What the loop over a block asks, as unsigned comparisons. */
struct asks {
    uint32_t x0, y0, wide, high; /* the field and its margin */
    uint32_t left, top, reach;   /* twice the reach, from there */
};

static int32_t size(int32_t v)
{
    return v < 0 ? -v : v;
}

static int32_t larger(int32_t a, int32_t b)
{
    return a > b ? a : b;
}

static struct stamp stamp_of(const uint8_t *pix)
{
    struct stamp s;

    for (int y = 0; y < CROWD_SIDE; y++) {
        uint8_t keep[CROWD_SIDE];
        for (int x = 0; x < CROWD_SIDE; x++)
            keep[x] = pix[y * CROWD_SIDE + x] ? 0 : 255;
        memcpy(&s.keep[y], keep, sizeof keep);
        memcpy(&s.colour[y], pix + y * CROWD_SIDE, sizeof keep);
    }
    return s;
}

static void columns_close(void *data)
{
    struct columns *s = data;

    free(s->x);
    free(s->y);
    free(s->vx);
    free(s->vy);
    free(s->due);
    free(s->grazed);
    free(s->slot);
    free(s->mem);
    free(s);
}

static bool make_room(struct columns *s, size_t n)
{
    s->x = malloc(n * sizeof *s->x);
    s->y = malloc(n * sizeof *s->y);
    s->vx = calloc(n, sizeof *s->vx);
    s->vy = calloc(n, sizeof *s->vy);
    s->due = calloc(n, sizeof *s->due);
    s->grazed = calloc(n, 1);
    s->slot = calloc(n, sizeof *s->slot);
    s->mem = calloc((size_t)s->pitch, (size_t)(s->c.h + 2 * CROWD_GUARD));
    return s->x && s->y && s->vx && s->vy && s->due && s->grazed && s->slot && s->mem;
}

static void fill(struct columns *s, const uint32_t *order, int room)
{
    for (int i = 0; i < s->c.n; i++) {
        const struct crowd_bullet *b = &s->c.bullets[order[i]];
        s->x[i] = b->x;
        s->y[i] = b->y;
        s->vx[i] = b->vx;
        s->vy[i] = b->vy;
        s->due[i] = (uint16_t)(b->turn + 1);
        s->grazed[i] = b->grazed;
        s->slot[i] = b->slot;
        s->first[b->kind + 1] = i + 1;
    }
    for (int i = s->c.n; i < room; i++)
        s->x[i] = s->y[i] = FAR_AWAY;
    for (int k = 1; k <= CROWD_KINDS; k++) /* of a kind without bullets */
        s->first[k] = s->first[k] > s->first[k - 1] ? s->first[k] : s->first[k - 1];
}

static void *columns_open(const struct crowd *c)
{
    struct columns *s = calloc(1, sizeof *s);
    uint32_t *order = malloc((size_t)c->n * sizeof *order);
    int room = (c->n + BLOCK - 1) / BLOCK * BLOCK;

    if (!s || !order) {
        free(order);
        free(s);
        return NULL;
    }
    s->c = *c;
    s->pitch = c->w + 2 * CROWD_GUARD;
    if (!make_room(s, (size_t)room)) {
        free(order);
        columns_close(s);
        return NULL;
    }
    s->pix = s->mem + CROWD_GUARD * s->pitch + CROWD_GUARD;
    for (int k = 0; k < CROWD_KINDS; k++)
        s->stamps[k] = stamp_of(c->pix[k]);
    s->ship = stamp_of(c->ship);
    reference_order(c, order);
    fill(s, order, room);
    for (int i = 0; i < c->n; i++)
        s->fastest = larger(s->fastest, larger(size(s->vx[i]), size(s->vy[i])));
    free(order);
    return s;
}

/* Does any of a block turn now? */
static bool due_block(const uint16_t *restrict due, uint16_t now)
{
    uint16_t any = 0;

    for (int i = 0; i < BLOCK; i++)
        any |= due[i] == now;
    return any;
}

/* Turns those of a block that are due: v becomes (v ^ -1) + 1. */
static void turn_block(int32_t *restrict vx, int32_t *restrict vy, uint16_t *restrict due, uint16_t now)
{
    for (int i = 0; i < BLOCK; i++) {
        int32_t turns = -(due[i] == now);
        vx[i] = (vx[i] ^ turns) - turns;
        vy[i] = (vy[i] ^ turns) - turns;
        due[i] = (uint16_t)(due[i] + (turns & CROWD_LEG));
    }
}

/* Moves a block and says of each what has to be looked at; 0: nothing. */
static int32_t move_block(int32_t *restrict x, int32_t *restrict y, const int32_t *restrict vx,
                          const int32_t *restrict vy, uint8_t *restrict found, const struct asks *asks)
{
    const struct asks a = *asks;
    int32_t any = 0;

    for (int i = 0; i < BLOCK; i++) {
        uint32_t nx = (uint32_t)x[i] + (uint32_t)vx[i], ny = (uint32_t)y[i] + (uint32_t)vy[i];
        uint32_t ax = (uint32_t)(vx[i] < 0 ? -vx[i] : vx[i]), ay = (uint32_t)(vy[i] < 0 ? -vy[i] : vy[i]);
        int32_t out = (nx - a.x0 > a.wide) | (ny - a.y0 > a.high);
        int32_t near = (nx - a.left + ax <= a.reach + 2 * ax) & (ny - a.top + ay <= a.reach + 2 * ay);
        x[i] = (int32_t)nx;
        y[i] = (int32_t)ny;
        found[i] = (uint8_t)(out | near << 1);
        any |= near << 1 | out;
    }
    return any;
}

/* Does the point that goes from d to d + w come within r of the origin? All are less than 2^31. */
static bool passes(int64_t dx, int64_t dy, int64_t wx, int64_t wy, int64_t r)
{
    int64_t along = -(dx * wx + dy * wy), way = wx * wx + wy * wy;

    if (along <= 0)
        return dx * dx + dy * dy <= r * r;
    if (along >= way)
        return (dx + wx) * (dx + wx) + (dy + wy) * (dy + wy) <= r * r;
    wide cross = dx * wy - dy * wx;
    return cross * cross <= (wide)(r * r) * way;
}

static void against(struct columns *s, const struct crowd_player *p, int i, struct crowd_counts *counts)
{
    int64_t mx = p->x - p->was_x, my = p->y - p->was_y, wx = s->vx[i] - mx, wy = s->vy[i] - my;
    int64_t dx = (int64_t)s->x[i] - p->x - wx, dy = (int64_t)s->y[i] - p->y - wy;

    counts->tested++;
    if (passes(dx, dy, wx, wy, s->c.radius + s->c.player_radius)) {
        counts->hit++;
    } else if (!s->grazed[i] && passes(dx, dy, wx, wy, s->c.radius + s->c.player_graze)) {
        s->grazed[i] = 1;
        counts->grazed++;
    }
}

static struct asks asks_of(const struct columns *s, const struct crowd_player *p)
{
    int32_t reach = s->c.radius + larger(s->c.player_radius, s->c.player_graze) +
                    larger(size(p->x - p->was_x), size(p->y - p->was_y));
    uint32_t edge = (uint32_t)s->c.margin << 16;

    return (struct asks){ .x0 = 0u - edge,
                          .y0 = 0u - edge,
                          .wide = ((uint32_t)s->c.w << 16) + 2 * edge,
                          .high = ((uint32_t)s->c.h << 16) + 2 * edge,
                          .left = (uint32_t)p->x - (uint32_t)reach,
                          .top = (uint32_t)p->y - (uint32_t)reach,
                          .reach = 2 * (uint32_t)reach };
}

/* 8 bytes as a word, the first the lowest: compilers make one load of it where that is the order. */
static uint64_t word(const uint8_t *p)
{
    return (uint64_t)p[0] | (uint64_t)p[1] << 8 | (uint64_t)p[2] << 16 | (uint64_t)p[3] << 24 | (uint64_t)p[4] << 32 |
           (uint64_t)p[5] << 40 | (uint64_t)p[6] << 48 | (uint64_t)p[7] << 56;
}

/* The places of the bytes that are not 0, as bits; a byte is less than 128. */
static uint64_t marks(const uint8_t *bytes)
{
    uint64_t m = 0;

    for (int k = 0; k < BLOCK / 8; k++) {
        uint64_t w = (word(bytes + 8 * k) + 0x7f7f7f7f7f7f7f7fu) >> 7 & 0x0101010101010101u;
        m |= (w * 0x0102040810204080u >> 56) << 8 * k;
    }
    return m;
}

static int lowest(uint64_t m)
{
#ifdef __GNUC__
    return __builtin_ctzll(m);
#else
    int n = 0;
    for (; !(m >> n & 1); n++)
        ;
    return n;
#endif
}

static void columns_tick(void *data, const struct crowd_player *p, struct crowd_counts *counts)
{
    struct columns *s = data;
    const struct asks asks = asks_of(s, p);
    uint8_t found[BLOCK];

    s->player = *p;
    s->frame++;
    for (int i = 0; i < s->c.n; i += BLOCK) {
        if (due_block(s->due + i, s->frame))
            turn_block(s->vx + i, s->vy + i, s->due + i, s->frame);
        if (!move_block(s->x + i, s->y + i, s->vx + i, s->vy + i, found, &asks))
            continue;
        for (uint64_t m = marks(found); m; m &= m - 1) {
            int k = i + lowest(m);
            if (k >= s->c.n)
                break;
            counts->left += found[k - i] & MOVED_OUT;
            if (found[k - i] & NEAR)
                against(s, p, k, counts);
        }
    }
    counts->moved += (uint64_t)s->c.n;
}

static void put(const struct columns *s, const struct stamp *stamp, int32_t x, int32_t y)
{
    uint8_t *d = s->pix + ((y >> 16) - CROWD_SIDE / 2) * s->pitch + (x >> 16) - CROWD_SIDE / 2;

    for (int row = 0; row < CROWD_SIDE; row++, d += s->pitch) {
        uint64_t w;
        memcpy(&w, d, sizeof w);
        w = (w & stamp->keep[row]) | stamp->colour[row];
        memcpy(d, &w, sizeof w);
    }
}

static void columns_draw(void *data, struct crowd_counts *counts)
{
    struct columns *s = data;

    for (int y = 0; y < s->c.h; y++)
        memset(s->pix + y * s->pitch, 0, (size_t)s->c.w);
    put(s, &s->ship, s->player.x, s->player.y);
    for (int k = 0; k < CROWD_KINDS; k++) {
        const struct stamp stamp = s->stamps[k];
        for (int i = s->first[k]; i < s->first[k + 1]; i++)
            put(s, &stamp, s->x[i], s->y[i]);
    }
    counts->drawn += (uint64_t)s->c.n + 1;
}

static const uint8_t *columns_picture(const void *data, int *pitch)
{
    const struct columns *s = data;

    *pitch = s->pitch;
    return s->pix;
}

static uint32_t columns_where(const void *data, int i, int32_t *x, int32_t *y)
{
    const struct columns *s = data;

    *x = s->x[i];
    *y = s->y[i];
    return s->slot[i];
}

/* ---- the least ---- */

/*
 * The same columns, and no work that this one scene could do without: nothing is grazed, nothing can leave, one bound
 * on the speeds stands for each, and pictures are known to be 8x8 in one bank. Two rows are one vector, and a kind's
 * masks and colours stay in registers.
 */
typedef int8_t sixteen __attribute__((vector_size(16)));

enum { SIGN = INT32_MIN };

/* Moves a block; 0: none is near. near: the place from which they are, its sign turned over, and twice the reach. */
static int32_t least_block(int32_t *restrict x, int32_t *restrict y, const int32_t *restrict vx,
                           const int32_t *restrict vy, uint8_t *restrict found, const uint32_t near[3])
{
    const uint32_t left = near[0], top = near[1];
    const int32_t reach = (int32_t)near[2];
    int32_t away[BLOCK], any = 0;

    for (int i = 0; i < BLOCK; i++) {
        int32_t nx = x[i] + vx[i], ny = y[i] + vy[i];
        x[i] = nx;
        y[i] = ny;
        away[i] = -((int32_t)((uint32_t)nx - left) > reach) | -((int32_t)((uint32_t)ny - top) > reach);
        any |= ~away[i];
    }
    if (any)
        for (int i = 0; i < BLOCK; i++)
            found[i] = (uint8_t)(~away[i] & NEAR);
    return any;
}

static void least_against(struct columns *s, const struct crowd_player *p, int i, struct crowd_counts *counts)
{
    int64_t mx = p->x - p->was_x, my = p->y - p->was_y, wx = s->vx[i] - mx, wy = s->vy[i] - my;
    int64_t dx = (int64_t)s->x[i] - p->x - wx, dy = (int64_t)s->y[i] - p->y - wy;

    counts->hit += passes(dx, dy, wx, wy, s->c.radius + s->c.player_radius);
}

static void least_tick(void *data, const struct crowd_player *p, struct crowd_counts *counts)
{
    struct columns *s = data;
    const int32_t reach =
        s->c.radius + s->c.player_radius + s->fastest + larger(size(p->x - p->was_x), size(p->y - p->was_y));
    const uint32_t near[3] = { (uint32_t)(p->x - reach) ^ (uint32_t)SIGN, (uint32_t)(p->y - reach) ^ (uint32_t)SIGN,
                               2 * (uint32_t)reach ^ (uint32_t)SIGN };
    uint8_t found[BLOCK];

    s->player = *p;
    s->frame++;
    for (int i = 0; i < s->c.n; i += BLOCK) {
        if (due_block(s->due + i, s->frame))
            turn_block(s->vx + i, s->vy + i, s->due + i, s->frame);
        if (!least_block(s->x + i, s->y + i, s->vx + i, s->vy + i, found, near))
            continue;
        for (uint64_t m = marks(found); m; m &= m - 1)
            least_against(s, p, i + lowest(m), counts);
    }
    counts->moved += (uint64_t)s->c.n;
}

static inline void put_two(uint8_t *d, int pitch, sixteen keep, sixteen colour)
{
    uint64_t two[2];
    sixteen v;

    memcpy(&two[0], d, sizeof two[0]);
    memcpy(&two[1], d + pitch, sizeof two[1]);
    memcpy(&v, two, sizeof v);
    v = (v & keep) | colour;
    memcpy(two, &v, sizeof v);
    memcpy(d, &two[0], sizeof two[0]);
    memcpy(d + pitch, &two[1], sizeof two[1]);
}

static void least_kind(const struct columns *s, const struct stamp *stamp, int from, int to)
{
    const int pitch = s->pitch;
    const int32_t *x = s->x, *y = s->y;
    uint8_t *corner = s->pix - CROWD_SIDE / 2 * pitch - CROWD_SIDE / 2;
    sixteen keep[4], colour[4];

    memcpy(keep, stamp->keep, sizeof keep);
    memcpy(colour, stamp->colour, sizeof colour);
    for (int i = from; i < to; i++) {
        uint8_t *d = corner + (y[i] >> 16) * pitch + (x[i] >> 16);
        put_two(d, pitch, keep[0], colour[0]);
        put_two(d + 2 * pitch, pitch, keep[1], colour[1]);
        put_two(d + 4 * pitch, pitch, keep[2], colour[2]);
        put_two(d + 6 * pitch, pitch, keep[3], colour[3]);
    }
}

static void least_draw(void *data, struct crowd_counts *counts)
{
    struct columns *s = data;

    for (int y = 0; y < s->c.h; y++)
        memset(s->pix + y * s->pitch, 0, (size_t)s->c.w);
    put(s, &s->ship, s->player.x, s->player.y);
    for (int k = 0; k < CROWD_KINDS; k++)
        least_kind(s, &s->stamps[k], s->first[k], s->first[k + 1]);
    counts->drawn += (uint64_t)s->c.n + 1;
}

const struct reference reference_least = { "the least C", columns_open,    columns_close, least_tick,
                                           least_draw,    columns_picture, columns_where };

const struct reference reference_columns = {
    "columns, masked-word blit", columns_open, columns_close, columns_tick, columns_draw, columns_picture, columns_where
};
