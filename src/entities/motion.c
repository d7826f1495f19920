/*
 * motion.c - stores motion programs, and computes moves. Equal programs are stored once, so a script may build them in
 * a loop. Easing is quadratic, so that a share of a move is a fraction of integers and a position is rounded only once.
 */
#include "motion.h"
#include <string.h>
#include "../base/int.h"
#include "../base/trig.h"

static const struct column step_columns[] = {
    COLUMN(steps, does),    COLUMN(steps, over),  COLUMN(steps, kind),  COLUMN(steps, bank),  COLUMN(steps, dir),
    COLUMN(steps, turn),    COLUMN(steps, home),  COLUMN(steps, speed), COLUMN(steps, accel), COLUMN(steps, count),
    COLUMN(steps, jump),    COLUMN(steps, depth), COLUMN(steps, x),     COLUMN(steps, y),     COLUMN(steps, size),
    COLUMN(steps, size_to), COLUMN(steps, how),   COLUMN(steps, named),
};

static const struct column motion_columns[] = { COLUMN(motions, first), COLUMN(motions, length),
                                                COLUMN(motions, fine) };

const struct chip steps_chip = { "steps", step_columns, sizeof step_columns / sizeof *step_columns, true, false };
const struct chip motions_chip = { "motions", motion_columns, sizeof motion_columns / sizeof *motion_columns, true,
                                   false };

void motion_step_at(const struct steps *s, uint32_t i, struct motion_step *out)
{
    *out = (struct motion_step){ .does = s->does[i],
                                 .kind = s->kind[i],
                                 .count = s->count[i],
                                 .jump = s->jump[i],
                                 .over = s->over[i],
                                 .bank = s->bank[i],
                                 .depth = s->depth[i],
                                 .dir = s->dir[i],
                                 .home = s->home[i],
                                 .turn = s->turn[i],
                                 .speed = s->speed[i],
                                 .accel = s->accel[i],
                                 .named = s->named[i],
                                 .x = s->x[i],
                                 .y = s->y[i],
                                 .size = s->size[i],
                                 .size_to = s->size_to[i],
                                 .how = s->how[i] };
}

/* A full turn is 360 * 2^16 units of fx, so one unit is 2^13 / 45 units of ang. 45 is odd, so there are no ties. */
ang motion_angle(fx degrees)
{
    const int64_t product = (int64_t)degrees * 8192;

    return (ang)((product + (product < 0 ? -22 : 22)) / 45);
}

static bool same(const struct steps *s, uint32_t i, const struct motion_step *p)
{
    return s->does[i] == p->does && s->over[i] == p->over && s->kind[i] == p->kind && s->bank[i] == p->bank &&
           s->dir[i] == p->dir && s->turn[i] == p->turn && s->home[i] == p->home && s->speed[i] == p->speed &&
           s->accel[i] == p->accel && s->count[i] == p->count && s->jump[i] == p->jump && s->depth[i] == p->depth &&
           s->named[i] == p->named && s->x[i] == p->x && s->y[i] == p->y && s->size[i] == p->size &&
           s->size_to[i] == p->size_to && s->how[i] == p->how;
}

static void store(struct steps *s, uint32_t i, const struct motion_step *p)
{
    s->does[i] = p->does;
    s->over[i] = p->over;
    s->kind[i] = p->kind;
    s->bank[i] = p->bank;
    s->dir[i] = p->dir;
    s->turn[i] = p->turn;
    s->home[i] = p->home;
    s->speed[i] = p->speed;
    s->accel[i] = p->accel;
    s->count[i] = p->count;
    s->jump[i] = p->jump;
    s->depth[i] = p->depth;
    s->named[i] = p->named;
    s->x[i] = p->x;
    s->y[i] = p->y;
    s->size[i] = p->size;
    s->size_to[i] = p->size_to;
    s->how[i] = p->how;
}

int32_t motion_define(struct motions *m, struct steps *s, const struct motion_step *steps, uint32_t n, bool fine)
{
    for (uint32_t k = 0; k < m->s.live; k++) {
        uint32_t i = 0;
        if (m->length[k] != n || m->fine[k] != fine)
            continue;
        while (i < n && same(s, m->first[k] + i, &steps[i]))
            i++;
        if (i == n)
            return (int32_t)k;
    }
    if (s->s.cap - s->s.live < n) {
        s->s.refused++;
        return NO_SLOT;
    }
    int32_t made = slots_append(&m->s);
    if (made == NO_SLOT)
        return NO_SLOT;
    m->first[made] = s->s.live;
    m->length[made] = (uint16_t)n;
    m->fine[made] = fine;
    for (uint32_t i = 0; i < n; i++)
        store(s, (uint32_t)slots_append(&s->s), &steps[i]);
    return made;
}

static int64_t bits_of(double v)
{
    int64_t bits;

    memcpy(&bits, &v, sizeof bits);
    return bits;
}

static double double_of(int64_t bits)
{
    double v;

    memcpy(&v, &bits, sizeof v);
    return v;
}

void motion_emit_steps(const struct motion_emit *e, struct motion_step out[EMIT_ROWS])
{
    out[0] = (struct motion_step){ .does = DOES_EMIT,
                                   .over = e->delay,
                                   .kind = e->kind,
                                   .count = e->n,
                                   .jump = e->tag,
                                   .bank = e->bank,
                                   .depth = e->pattern,
                                   .how = e->flags,
                                   .x = e->value[0],
                                   .y = e->value[1],
                                   .size = e->value[2],
                                   .size_to = e->value[3],
                                   .dir = (ang)e->first,
                                   .home = (ang)e->last,
                                   .turn = e->motion,
                                   .speed = bits_of(e->speed),
                                   .accel = bits_of(e->size),
                                   .named = e->named };
    out[1] = (struct motion_step){ .does = DOES_EMIT, .speed = bits_of(e->dir), .accel = e->around };
}

void motion_emit_at(const struct steps *s, uint32_t i, struct motion_emit *out)
{
    *out = (struct motion_emit){ .pattern = s->depth[i],
                                 .flags = s->how[i],
                                 .bank = s->bank[i],
                                 .kind = s->kind[i],
                                 .tag = s->jump[i],
                                 .motion = (uint16_t)s->turn[i],
                                 .n = s->count[i],
                                 .first = (int32_t)s->dir[i],
                                 .last = (int32_t)s->home[i],
                                 .delay = s->over[i],
                                 .dir = double_of(s->speed[i + 1]),
                                 .speed = double_of(s->speed[i]),
                                 .size = double_of(s->accel[i]),
                                 .value = { s->x[i], s->y[i], s->size[i], s->size_to[i] },
                                 .around = s->accel[i + 1],
                                 .named = s->named[i] };
}

struct motion_share motion_eased(enum ease ease, uint64_t k, uint64_t n)
{
    uint64_t rest = n - k, whole = n * n;

    switch (ease) {
    case EASE_IN:
        return (struct motion_share){ k * k, whole };
    case EASE_OUT:
        return (struct motion_share){ whole - rest * rest, whole };
    case EASE_BOTH:
        return (struct motion_share){ 2 * k < n ? 2 * k * k : whole - 2 * rest * rest, whole };
    default:
        return (struct motion_share){ k, n };
    }
}

/* Returns d * s, truncated, and sets *left to the remainder, in units of 1 / s.whole. Works bit by bit, because the
 * product may not fit in 64 bits. */
static uint32_t share_bits(uint32_t d, struct motion_share s, uint64_t *left)
{
    uint32_t q = 0;

    *left = 0;
    for (int bit = 31; bit >= 0; bit--) {
        *left = 2 * *left + (d >> bit & 1 ? s.part : 0); /* below 3 * s.whole */
        q *= 2;
        for (; *left >= s.whole; *left -= s.whole)
            q++;
    }
    return q;
}

static uint32_t share_of(uint32_t d, struct motion_share s, uint64_t *left)
{
    if (s.whole >> 32)
        return share_bits(d, s, left);
    uint64_t product = d * s.part;
    *left = product % s.whole;
    return (uint32_t)(product / s.whole);
}

fx motion_between(fx a, fx b, struct motion_share s)
{
    uint32_t d = a < b ? (uint32_t)b - (uint32_t)a : (uint32_t)a - (uint32_t)b;
    uint64_t left;
    uint32_t q = share_of(d, s, &left);
    uint64_t to_next = s.whole - left;

    q += (left > to_next) | ((left == to_next) & ((uint32_t)a ^ q) & 1);
    return (fx)(a < b ? (uint32_t)a + q : (uint32_t)a - q);
}

int64_t motion_part_way(int64_t from, int64_t to, uint32_t k, uint32_t n)
{
    uint64_t d = (uint64_t)(to < from ? from - to : to - from), part = d % n * k;
    uint64_t q = d / n * k + part / n, twice = part % n * 2;

    q += (twice > n) | ((twice == n) & (q & 1));
    return to < from ? from - (int64_t)q : from + (int64_t)q;
}

/* Returns the distance flown in k frames, in Q32, clamped to 2^47 (32768 px) either way, which is far outside the
 * world. */
static int64_t flown(int64_t speed_q32, uint32_t k)
{
    const int64_t far = (int64_t)1 << 47;

    if (int64_abs(speed_q32) > far / (k ? k : 1))
        return speed_q32 < 0 ? -far : far;
    return speed_q32 * k;
}

/* Adds (r cos dir, r sin dir) to (x, y), all in Q32. */
static void add_polar(int64_t r, ang dir, int64_t *x, int64_t *y)
{
    int64_t dx, dy;

    trig_stride(0, r, dir, &dx, &dy);
    *x += dx;
    *y += dy;
}

/* Returns a wave's distance to the side in frame k, relative to the wave's start, in Q32. */
static int64_t aside(const struct steps *s, uint32_t st, uint32_t k)
{
    const uint32_t every = s->count[st];
    const int64_t size = (int64_t)s->size[st] * (1 << PACE_BITS);
    const ang along = (ang)((((uint64_t)(k % every) << 32) + every / 2) / every);
    int64_t unused, from, to;

    trig_stride(0, size, s->dir[st], &unused, &from);
    trig_stride(0, size, s->dir[st] + along, &unused, &to);
    return to - from;
}

/* Clamps a coordinate in fx to the world. */
static fx in_world(int64_t v)
{
    const int64_t most = (int64_t)WORLD << 16;

    return (fx)int64_clamp(v, -most, most);
}

/* Returns the fx nearest to a coordinate in Q32, clamped to the world. */
static fx place_fx(int64_t v)
{
    return in_world((v + 0x8000) >> PACE_BITS);
}

void motion_round(fx x, fx y, int64_t r, ang a, fx *to_x, fx *to_y)
{
    int64_t px = (int64_t)x * (1 << PACE_BITS), py = (int64_t)y * (1 << PACE_BITS);

    add_polar(r, a, &px, &py);
    *to_x = place_fx(px);
    *to_y = place_fx(py);
}

void motion_lead_place(const struct steps *s, uint32_t st, const struct motion_lead *l, uint32_t k, uint32_t n, fx *x,
                       fx *y)
{
    const ang a = l->angle + (ang)s->turn[st] * k;
    int64_t px = (int64_t)l->x * (1 << PACE_BITS), py = (int64_t)l->y * (1 << PACE_BITS);

    if (s->does[st] & DOES_GO_TO) {
        struct motion_share part = motion_eased((enum ease)(s->how[st] & HOW_EASE), k, n);
        const bool by = s->how[st] & HOW_BY;
        *x = motion_between(l->x, by ? in_world((int64_t)l->x + s->x[st]) : s->x[st], part);
        *y = motion_between(l->y, by ? in_world((int64_t)l->y + s->y[st]) : s->y[st], part);
        return;
    }
    if (s->does[st] & DOES_POLAR)
        add_polar((int64_t)l->radius * (1 << PACE_BITS) + flown(s->speed[st], k), a, &px, &py);
    else if (s->does[st] & DOES_ORBIT) {
        int64_t from = (int64_t)s->size[st] * (1 << PACE_BITS), to = (int64_t)s->size_to[st] * (1 << PACE_BITS);
        add_polar(s->how[st] & HOW_TO ? motion_part_way(from, to, k, n) : from, a, &px, &py);
    } else {
        add_polar(flown((int64_t)l->speed * (1 << PACE_BITS), k), l->angle, &px, &py);
        add_polar(aside(s, st, k), l->angle + 0x40000000u, &px, &py);
    }
    *x = place_fx(px);
    *y = place_fx(py);
}

/* ---- numbers replaced by a bullet's values ---- */

static fx in_range(fx v, int lo, int hi)
{
    return fx_clamp(v, lo * FX_ONE, hi * FX_ONE);
}

static void set_lead_number(struct motion_step *p, enum step_number number, fx v)
{
    switch (number) {
    case NUMBER_X:
        p->x = in_range(v, -WORLD, WORLD);
        break;
    case NUMBER_Y:
        p->y = in_range(v, -WORLD, WORLD);
        break;
    case NUMBER_SIZE:
        p->size = in_range(v, p->does & DOES_WAVE ? -MAX_SPEED : 0, MAX_SPEED);
        break;
    case NUMBER_SIZE_TO:
        p->size_to = in_range(v, 0, MAX_SPEED);
        break;
    default:
        p->count = v < FX_ONE ? 1 : (uint16_t)(v / FX_ONE);
    }
}

void motion_set_number(struct motion_step *p, enum step_number number, fx v)
{
    const fx pace = in_range(v, -MAX_SPEED, MAX_SPEED);

    switch (number) {
    case NUMBER_OVER:
        p->over = v < FX_ONE ? 1 : (uint32_t)v / FX_ONE;
        break;
    case NUMBER_BANK:
        p->bank = (uint8_t)(v >> 16 & 15);
        break;
    case NUMBER_DIR:
        p->dir = motion_angle(v);
        break;
    case NUMBER_TURN:
        p->turn = (int32_t)motion_angle(v);
        break;
    case NUMBER_HOME:
        p->home = motion_angle(in_range(v, 0, 180));
        break;
    case NUMBER_SPEED:
        p->speed = (int64_t)pace * (1 << PACE_BITS);
        break;
    case NUMBER_ACCEL:
        p->accel = (int64_t)pace * (1 << PACE_BITS);
        break;
    default:
        set_lead_number(p, number, v);
    }
}
