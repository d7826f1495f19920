/*
 * motion.c - stores motion programs, and computes moves. Equal programs are stored once, so a script may build them in
 * a loop. Easing is quadratic, so that a share of a move is a fraction of integers and a position is rounded only once.
 */
#include "motion.h"
#include <string.h>
#include "../base/int.h"
#include "../base/trig.h"

#define AS_COLUMN(type, name) COLUMN(steps, name),
static const struct column step_columns[] = { STEP_FIELDS(AS_COLUMN) };

static const struct column motion_columns[] = { COLUMN(motions, first), COLUMN(motions, length),
                                                COLUMN(motions, is_fine) };

const struct chip steps_chip = { .name = "steps", CHIP_COLUMNS(step_columns), .is_list = true };
const struct chip motions_chip = { .name = "motions", CHIP_COLUMNS(motion_columns), .is_list = true };

void motion_get_step(const struct steps *s, uint32_t i, struct motion_step *out)
{
#define GET(type, name) out->name = s->name[i];
    STEP_FIELDS(GET)
}

/* A full turn is 360 * 2^16 units of fx, so one unit is 2^13 / 45 units of ang. 45 is odd, so there are no ties. */
ang motion_angle_from_degrees(fx degrees)
{
    const int64_t product = (int64_t)degrees * 8192;

    return (ang)((product + (product < 0 ? -22 : 22)) / 45);
}

static bool is_same_step(const struct steps *s, uint32_t i, const struct motion_step *p)
{
#define AND_SAME(type, name) &&s->name[i] == p->name
    return true STEP_FIELDS(AND_SAME);
}

static void store_step(struct steps *s, uint32_t i, const struct motion_step *p)
{
#define STORE(type, name) s->name[i] = p->name;
    STEP_FIELDS(STORE)
}

int32_t motion_define(struct motions *m, struct steps *s, const struct motion_step *steps, uint32_t n, bool fine)
{
    for (uint32_t k = 0; k < m->s.live; k++) {
        uint32_t i = 0;
        if (m->length[k] != n || m->is_fine[k] != fine)
            continue;
        while (i < n && is_same_step(s, m->first[k] + i, &steps[i]))
            i++;
        if (i == n)
            return (int32_t)k;
    }
    if (s->s.cap - s->s.live < n) {
        s->s.refused++;
        return NO_SLOT;
    }
    int32_t program = slots_append(&m->s);
    if (program == NO_SLOT)
        return NO_SLOT;
    m->first[program] = s->s.live;
    m->length[program] = (uint16_t)n;
    m->is_fine[program] = fine;
    for (uint32_t i = 0; i < n; i++)
        store_step(s, (uint32_t)slots_append(&s->s), &steps[i]);
    return program;
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

void motion_pack_emit(const struct motion_emit *e, struct motion_step out[EMIT_STEPS])
{
    out[0] = (struct motion_step){ .actions = DOES_EMIT,
                                   .duration = e->delay,
                                   .kind = e->kind,
                                   .count = e->n,
                                   .jump = e->tag,
                                   .bank = e->bank,
                                   .depth = e->pattern,
                                   .mode = e->flags,
                                   .x = e->value[0],
                                   .y = e->value[1],
                                   .size = e->value[2],
                                   .size_to = e->value[3],
                                   .dir = (ang)e->first,
                                   .home = (ang)e->skip_last,
                                   .turn = e->motion,
                                   .speed = bits_of(e->speed),
                                   .accel = bits_of(e->size),
                                   .named_values = e->named_values };
    out[1] = (struct motion_step){ .actions = DOES_EMIT, .speed = bits_of(e->dir), .accel = e->orbit_target };
}

void motion_unpack_emit(const struct steps *s, uint32_t i, struct motion_emit *out)
{
    *out = (struct motion_emit){ .pattern = s->depth[i],
                                 .flags = s->mode[i],
                                 .bank = s->bank[i],
                                 .kind = s->kind[i],
                                 .tag = s->jump[i],
                                 .motion = (uint16_t)s->turn[i],
                                 .n = s->count[i],
                                 .first = (int32_t)s->dir[i],
                                 .skip_last = (int32_t)s->home[i],
                                 .delay = s->duration[i],
                                 .dir = double_of(s->speed[i + 1]),
                                 .speed = double_of(s->speed[i]),
                                 .size = double_of(s->accel[i]),
                                 .value = { s->x[i], s->y[i], s->size[i], s->size_to[i] },
                                 .orbit_target = s->accel[i + 1],
                                 .named_values = s->named_values[i] };
}

struct motion_share motion_ease(enum ease ease, uint64_t k, uint64_t n)
{
    uint64_t remaining = n - k, whole = n * n;

    switch (ease) {
    case EASE_IN:
        return (struct motion_share){ k * k, whole };
    case EASE_OUT:
        return (struct motion_share){ whole - remaining * remaining, whole };
    case EASE_BOTH:
        return (struct motion_share){ 2 * k < n ? 2 * k * k : whole - 2 * remaining * remaining, whole };
    default:
        return (struct motion_share){ k, n };
    }
}

/* Returns d * s, truncated, and sets *remainder to the remainder, in units of 1 / s.whole. Works bit by bit, because
 * the product may not fit in 64 bits. */
static uint32_t multiply_share_bitwise(uint32_t d, struct motion_share s, uint64_t *remainder)
{
    uint32_t q = 0;

    *remainder = 0;
    for (int bit = 31; bit >= 0; bit--) {
        *remainder = 2 * *remainder + (d >> bit & 1 ? s.part : 0); /* below 3 * s.whole */
        q *= 2;
        for (; *remainder >= s.whole; *remainder -= s.whole)
            q++;
    }
    return q;
}

static uint32_t multiply_share(uint32_t d, struct motion_share s, uint64_t *remainder)
{
    if (s.whole >> 32)
        return multiply_share_bitwise(d, s, remainder);
    uint64_t product = d * s.part;
    *remainder = product % s.whole;
    return (uint32_t)(product / s.whole);
}

fx motion_lerp_share(fx a, fx b, struct motion_share s)
{
    uint32_t d = a < b ? (uint32_t)b - (uint32_t)a : (uint32_t)a - (uint32_t)b;
    uint64_t remainder;
    uint32_t q = multiply_share(d, s, &remainder);
    uint64_t to_next = s.whole - remainder;

    q += (remainder > to_next) | ((remainder == to_next) & ((uint32_t)a ^ q) & 1);
    return (fx)(a < b ? (uint32_t)a + q : (uint32_t)a - q);
}

int64_t motion_lerp(int64_t from, int64_t to, uint32_t k, uint32_t n)
{
    uint64_t d = (uint64_t)(to < from ? from - to : to - from), share = d % n * k;
    uint64_t q = d / n * k + share / n, twice = share % n * 2;

    q += (twice > n) | ((twice == n) & (q & 1));
    return to < from ? from - (int64_t)q : from + (int64_t)q;
}

/* Returns v * k, clamped to 2^bits either way. */
static int64_t multiply_clamped(int64_t v, int64_t k, int bits)
{
    const int64_t limit = (int64_t)1 << bits;

    if (k && int64_abs(v) > limit / k)
        return v < 0 ? -limit : limit;
    return v * k;
}

/* Returns the distance flown in k frames, in Q32, clamped to 2^47 (32768 px) either way, which is far outside the
 * world. */
static int64_t distance_flown(int64_t speed_q32, uint32_t k)
{
    return multiply_clamped(speed_q32, k, 47);
}

/* Adds (r cos dir, r sin dir) to (x, y), all in Q32. */
static void add_polar(int64_t r, ang dir, int64_t *x, int64_t *y)
{
    int64_t dx, dy;

    trig_stride(0, r, dir, &dx, &dy);
    *x += dx;
    *y += dy;
}

/* Returns a wave's lateral offset in frame k, relative to the wave's start, in Q32. */
static int64_t wave_offset(const struct steps *s, uint32_t st, uint32_t k)
{
    const uint32_t period = s->count[st];
    const int64_t size = (int64_t)s->size[st] * (1 << Q32_EXTRA_BITS);
    const ang phase = (ang)((((uint64_t)(k % period) << 32) + period / 2) / period);
    int64_t unused, from, to;

    trig_stride(0, size, s->dir[st], &unused, &from);
    trig_stride(0, size, s->dir[st] + phase, &unused, &to);
    return to - from;
}

/* Returns the fx nearest to a coordinate in Q32, clamped to the world. */
static fx round_to_world(int64_t v)
{
    return motion_clamp_to_world((v + 0x8000) >> Q32_EXTRA_BITS);
}

void motion_offset_polar(fx x, fx y, int64_t r, ang a, fx *to_x, fx *to_y)
{
    int64_t px = (int64_t)x * (1 << Q32_EXTRA_BITS), py = (int64_t)y * (1 << Q32_EXTRA_BITS);

    add_polar(r, a, &px, &py);
    *to_x = round_to_world(px);
    *to_y = round_to_world(py);
}

/* The speeds of an axis, in Q32: v at the start of the step, a is added in each frame until the limit is reached. */
static void accelerate(int64_t v, int64_t a, int64_t limit, uint32_t k, int64_t *velocity, int64_t *distance)
{
    const int64_t final = a < 0 ? int64_min(v, -limit) : int64_max(v, limit);
    const uint64_t frames_to_limit = a ? (uint64_t)int64_abs(final - v) / (uint64_t)int64_abs(a) : UINT64_MAX;
    const uint32_t grows = frames_to_limit < k ? (uint32_t)frames_to_limit : k;

    *velocity = grows < k ? final : v + multiply_clamped(a, k, 61);
    *distance = multiply_clamped(2 * v + multiply_clamped(a, (int64_t)grows + 1, 61), grows, 48) / 2 +
                distance_flown(final, k - grows);
}

/* Likewise, where the velocity goes evenly from v to `to` in n frames. Its mean in k frames differs from v by
 * (to - v) (k + 1) / 2n. */
static void approach(int64_t v, int64_t to, uint32_t k, uint32_t n, int64_t *velocity, int64_t *distance)
{
    const uint64_t d = (uint64_t)int64_abs(to - v), twice_n = 2 * (uint64_t)n, part = d % twice_n * (k + 1ull);
    const int64_t mean = (int64_t)(d / twice_n * (k + 1ull) + part / twice_n);
    const int64_t rest = (int64_t)(part % twice_n * k / twice_n);

    *velocity = motion_lerp(v, to, k, n);
    *distance = to < v ? multiply_clamped(v - mean, k, 48) - rest : multiply_clamped(v + mean, k, 48) + rest;
}

void motion_accelerate(const struct steps *s, uint32_t st, const struct motion_lead *l, uint32_t k, uint32_t n,
                       int64_t velocity[2], int64_t distance[2])
{
    for (int axis = 0; axis < 2; axis++) {
        const fx size = axis ? s->size_to[st] : s->size[st];
        const int64_t limit = s->mode[st] & MODE_HAS_LIMIT ? (int64_t)size * (1 << Q32_EXTRA_BITS) : (int64_t)1 << 60;
        const int64_t v = (int64_t)(axis ? l->vy : l->vx) * (1 << Q32_EXTRA_BITS);
        const int64_t number = axis ? s->accel[st] : s->speed[st];
        if (s->mode[st] & (axis ? MODE_TO_VY : MODE_TO_VX))
            approach(v, number, k, n, &velocity[axis], &distance[axis]);
        else
            accelerate(v, number, limit, k, &velocity[axis], &distance[axis]);
    }
}

void motion_lead_position(const struct steps *s, uint32_t st, const struct motion_lead *l, uint32_t k, uint32_t n,
                          fx *x, fx *y, int64_t velocity[2])
{
    const ang a = l->angle + (ang)s->turn[st] * k;
    int64_t px = (int64_t)l->x * (1 << Q32_EXTRA_BITS), py = (int64_t)l->y * (1 << Q32_EXTRA_BITS);

    if (s->actions[st] & DOES_GO_TO) {
        struct motion_share share = motion_ease((enum ease)(s->mode[st] & MODE_EASE), k, n);
        const bool is_relative = s->mode[st] & MODE_RELATIVE;
        *x = motion_lerp_share(l->x, is_relative ? motion_clamp_to_world((int64_t)l->x + s->x[st]) : s->x[st], share);
        *y = motion_lerp_share(l->y, is_relative ? motion_clamp_to_world((int64_t)l->y + s->y[st]) : s->y[st], share);
        return;
    }
    if (s->actions[st] & DOES_ACCEL_XY) {
        int64_t distance[2];
        motion_accelerate(s, st, l, k, n, velocity, distance);
        px += distance[0];
        py += distance[1];
    } else if (s->actions[st] & DOES_POLAR)
        add_polar((int64_t)l->radius * (1 << Q32_EXTRA_BITS) + distance_flown(s->speed[st], k), a, &px, &py);
    else if (s->actions[st] & DOES_ORBIT) {
        int64_t from = (int64_t)s->size[st] * (1 << Q32_EXTRA_BITS),
                to = (int64_t)s->size_to[st] * (1 << Q32_EXTRA_BITS);
        add_polar(s->mode[st] & MODE_HAS_SIZE_TO ? motion_lerp(from, to, k, n) : from, a, &px, &py);
    } else {
        add_polar(distance_flown((int64_t)l->speed * (1 << Q32_EXTRA_BITS), k), l->angle, &px, &py);
        add_polar(wave_offset(s, st, k), l->angle + ANG_QUARTER, &px, &py);
    }
    *x = round_to_world(px);
    *y = round_to_world(py);
}

/* ---- numbers replaced by a bullet's values ---- */

static fx clamp_to_range(fx v, int lo, int hi)
{
    return fx_clamp(v, lo * FX_ONE, hi * FX_ONE);
}

static void set_lead_number(struct motion_step *p, enum step_number number, fx v)
{
    switch (number) {
    case NUMBER_X:
        p->x = clamp_to_range(v, -WORLD_EDGE, WORLD_EDGE);
        break;
    case NUMBER_Y:
        p->y = clamp_to_range(v, -WORLD_EDGE, WORLD_EDGE);
        break;
    case NUMBER_SIZE:
        p->size = clamp_to_range(v, p->actions & DOES_WAVE ? -MAX_SPEED : 0, MAX_SPEED);
        break;
    case NUMBER_SIZE_TO:
        p->size_to = clamp_to_range(v, 0, MAX_SPEED);
        break;
    default:
        p->count = v < FX_ONE ? 1 : (uint16_t)(v / FX_ONE);
    }
}

void motion_set_number(struct motion_step *p, enum step_number number, fx v)
{
    const fx speed = clamp_to_range(v, -MAX_SPEED, MAX_SPEED);

    switch (number) {
    case NUMBER_DURATION:
        p->duration = v < FX_ONE ? 1 : (uint32_t)v / FX_ONE;
        break;
    case NUMBER_BANK:
        p->bank = (uint8_t)(v >> 16 & 15);
        break;
    case NUMBER_DIR:
        p->dir = motion_angle_from_degrees(v);
        break;
    case NUMBER_TURN:
        p->turn = (int32_t)motion_angle_from_degrees(v);
        break;
    case NUMBER_HOME:
        p->home = motion_angle_from_degrees(clamp_to_range(v, 0, 180));
        break;
    case NUMBER_SPEED:
        p->speed = (int64_t)speed * (1 << Q32_EXTRA_BITS);
        break;
    case NUMBER_ACCEL:
        p->accel = (int64_t)speed * (1 << Q32_EXTRA_BITS);
        break;
    default:
        set_lead_number(p, number, v);
    }
}
