/*
 * emit.c - see emit.h. The patterns match those of scripts/pattern.lua bit for bit, because both use the same
 * operations on doubles, in the same order.
 */
#include "emit.h"
#include <assert.h>
#include <string.h>
#include "machine.h"

enum { FIRST_ROOM = 64, A_TARGET = 8 /* targets examined per unit of work */ };

void emit_none(struct board *b)
{
    b->output->emissions = (struct emissions){ 0 };
}

/* Grows the queue. The first block of a frame is the one that an earlier frame allocated, if any: emit_room finds it,
 * because a restore loses the pointer `list`. */
static void grow(const struct board *b, struct emissions *q)
{
    size_t size = (q->room ? 2 * q->room : FIRST_ROOM) * sizeof *q->list;
    struct emission *list = b->calls->emit_room(b, q->list, &size);

    if (q->n)
        memcpy(list, q->list, q->n * sizeof *list);
    q->list = list;
    q->room = (uint32_t)(size / sizeof *list);
}

/* Returns whether this number of the step refers to a named value; if so, stores the value in *v, or 0 if the bullet or
 * shot does not have it. */
static bool named(const struct motion_emit *e, const struct emission *m, int number, fx *v)
{
    bool is_named;
    const int k = motion_named(e->named, number, m->shot, &is_named);

    *v = k < 0 ? 0 : m->value[k];
    return is_named;
}

static int32_t whole(fx v)
{
    return v < 0 ? 0 : v / FX_ONE;
}

static double number(const struct motion_emit *e, const struct emission *m, int n, double plain, int most)
{
    fx v;

    return named(e, m, n, &v) ? fx_to_double(fx_clamp(v, -most * FX_ONE, most * FX_ONE)) : plain;
}

/* Loads the emit step of m, with references to named values replaced by the values of m's bullet or shot. */
static void emit_of(const struct board *b, const struct emission *m, struct motion_emit *e)
{
    fx v;

    motion_emit_at(&b->steps, m->step, e);
    if (!e->named)
        return;
    if (named(e, m, EMIT_NUMBER_N, &v))
        e->n = (uint16_t)whole(v);
    if (named(e, m, EMIT_NUMBER_BANK, &v))
        e->bank = (uint8_t)(v >> 16 & 15);
    if (named(e, m, EMIT_NUMBER_DELAY, &v))
        e->delay = (uint32_t)whole(v);
    if (named(e, m, EMIT_NUMBER_DIR, &v))
        e->dir = fx_to_double(v);
    e->speed = number(e, m, EMIT_NUMBER_SPEED, e->speed, MAX_SPEED);
    e->size = number(e, m, EMIT_NUMBER_SIZE, e->size,
                     e->pattern == EMIT_STACK  ? MAX_SPEED
                     : e->pattern == EMIT_LINE ? WORLD
                                               : 32767);
    for (int k = 0; k < MAX_VALUES; k++)
        if (named(e, m, EMIT_NUMBER_VALUE + k, &v))
            e->value[k] = v;
}

/* Returns how many bullets the step fires from bullet i on, i < n, not counting the skipped ones. */
static uint32_t left(const struct motion_emit *e, int32_t i)
{
    const int32_t first = e->first > i + 1 ? e->first : i + 1, last = e->last < e->n ? e->last : e->n;

    return (uint32_t)(e->n - i - (last >= first ? last - first + 1 : 0));
}

void emit_queue(const struct motion_world *w, const struct bullets *s, uint32_t i, uint32_t st)
{
    const struct board *b = w->context;
    struct emissions *q = &b->output->emissions;
    struct emission m = {
        .dir = s->dir[i], .step = st, .by = s->owner_task[i], .player = s->player[i], .shot = w->shots
    };
    struct motion_emit e;

    bullets_place(s, i, &m.x, &m.y);
    for (int k = 0; k < MAX_VALUES && bullets_value(s, k); k++)
        m.value[k] = bullets_value(s, k)[i];
    emit_of(b, &m, &e);
    const bool shots = e.flags & EMIT_SHOTS;
    const uint32_t n = left(&e, 0);
    if (!n)
        return;
    if (q->of[shots] == (shots ? &b->shots : &b->bullets)->s.cap) {
        q->dropped[shots] += n;
        return;
    }
    if (q->n == q->room)
        grow(b, q);
    q->of[shots]++;
    q->list[q->n++] = m;
}

int32_t emit_fire(struct board *b, bool shot, struct bullet_shape *s, int64_t pace, uint32_t clock)
{
    struct bullets *pool = shot ? &b->shots : &b->bullets;
    const struct bullet_kinds *kinds = shot ? &b->shot_kinds : &b->bullet_kinds;

    s->hp = kinds->hp ? kinds->hp[s->kind] : 0;
    s->pierce = kinds->pierce ? kinds->pierce[s->kind] : 0;
    s->clouded = s->delay && kinds->flags[s->kind] & KIND_CLOUDED;
    int32_t i = bullets_fire(pool, s, clock);
    if (i == NO_SLOT)
        board_full(b, &pool->s);
    else if (s->fine)
        bullets_set_speed(pool, (uint32_t)i, pace);
    return i;
}

void emit_refuse(struct board *b, bool shot, uint64_t n)
{
    struct slots *s = shot ? &b->shots.s : &b->bullets.s;

    if (!n)
        return;
    s->refused++;
    board_full(b, s);
    s->refused += (uint32_t)(n - 1);
}

void emit_turn(struct emit_figure *f)
{
    ang a = 0;

    trig_from_degrees(f->dir, &a);
    f->cos30 = trig_cos30(a);
    f->sin30 = trig_sin30(a);
}

void emit_way(const struct emit_figure *f, int32_t i, struct emit_way *out)
{
    const double part = f->n > 1 ? (double)i / (double)(f->n - 1) : 0;
    double aside;

    *out = (struct emit_way){ .dir = f->dir, .speed = f->speed };
    switch (f->pattern) {
    case EMIT_RING:
        out->dir = f->dir + (double)(360 * i) / (double)f->n;
        break;
    case EMIT_FAN:
        out->dir = (f->n > 1 ? f->dir - f->size / 2 : f->dir) + f->size * part;
        break;
    case EMIT_ARC:
        out->dir = f->dir + f->size * part;
        break;
    case EMIT_STACK:
        out->speed = f->speed + (f->size - f->speed) * part;
        break;
    case EMIT_LINE:
        aside = f->n > 1 ? f->size * (part - 0.5) : 0;
        out->dx = -(aside * (f->sin30 / 1073741824.0));
        out->dy = aside * (f->cos30 / 1073741824.0);
        break;
    default:
        break;
    }
}

/* The bullets of one emission: the data they share, and the shape of the next bullet. */
struct volley {
    struct motion_emit e;
    struct bullet_shape shape;
    struct emit_figure f;
    fx x, y;  /* origin */
    bool aim; /* aim each bullet at the nearest target */
};

static fx nearest(double v)
{
    fx out = 0;

    fx_from_double(v, &out);
    return out;
}

/* Prepares a line. If the line is aimed, all its bullets are aimed together, from the middle. */
static void settle_line(struct board *b, const struct emission *m, struct volley *v)
{
    const struct targets t = board_world(b, v->e.flags & EMIT_SHOTS).targets;
    const ang none = v->e.flags & EMIT_SHOTS ? 0xc0000000u : 0x40000000u;

    if (v->aim) {
        const fx x = nearest((double)m->x / 4294967296.0), y = nearest((double)m->y / 4294967296.0);
        v->f.dir = trig_to_degrees(targets_aim(&t, x, y, none)) + v->f.dir;
        v->aim = false;
    }
    emit_turn(&v->f);
}

static void load(struct board *b, const struct emission *m, struct volley *v)
{
    const struct motion_emit *e = &v->e;
    const bool shots = e->flags & EMIT_SHOTS;

    v->aim = e->flags & EMIT_AIM;
    v->f = (struct emit_figure){ .pattern = e->pattern,
                                 .n = e->n,
                                 .dir = e->flags & EMIT_DIR ? e->dir
                                        : v->aim            ? 0
                                                            : trig_to_degrees(m->dir),
                                 .speed = e->speed,
                                 .size = e->size };
    v->x = (fx)((m->x - (int16_t)m->x) >> PACE_BITS);
    v->y = (fx)((m->y - (int16_t)m->y) >> PACE_BITS);
    v->shape = (struct bullet_shape){ .kind = e->kind,
                                      .tag = e->tag,
                                      .motion = e->motion,
                                      .fine = e->motion && b->motions.fine[e->motion - 1],
                                      .player = (uint8_t)m->player,
                                      .delay = e->delay,
                                      .around = e->around,
                                      .by = m->by };
    v->shape.bank = e->flags & EMIT_BANK ? e->bank : (shots ? &b->shot_kinds : &b->bullet_kinds)->bank[e->kind];
    if (e->pattern == EMIT_LINE)
        settle_line(b, m, v);
}

static fx in_world(fx v)
{
    return fx_clamp(v, -WORLD * FX_ONE, WORLD * FX_ONE);
}

static bool fire_one(struct board *b, struct volley *v, int32_t i)
{
    const bool shots = v->e.flags & EMIT_SHOTS;
    struct bullet_shape *s = &v->shape;
    struct bullets *pool = shots ? &b->shots : &b->bullets;
    struct emit_way w;

    emit_way(&v->f, i, &w);
    s->x = in_world(fx_add(v->x, nearest(w.dx)));
    s->y = in_world(fx_add(v->y, nearest(w.dy)));
    s->speed = nearest(w.speed);
    trig_from_degrees(w.dir, &s->dir);
    if (v->aim) {
        const struct targets t = board_world(b, shots).targets;
        s->dir += targets_aim(&t, s->x, s->y, shots ? 0xc0000000u : 0x40000000u);
    }
    const int32_t at = emit_fire(b, shots, s, fx_nearest(w.speed * 4294967296.0), b->core.clock + 1);
    for (int k = 0; at != NO_SLOT && k < MAX_VALUES; k++)
        if (v->e.flags & EMIT_VALUES << k && bullets_value(pool, k))
            bullets_value(pool, k)[at] = v->e.value[k];
    return at != NO_SLOT;
}

static void count(struct board *b, const struct volley *v, uint32_t n)
{
    const uint32_t aims = v->aim && v->e.flags & EMIT_SHOTS ? b->enemies.s.top / A_TARGET : 0;

    if (!board_work(b, (WORK_FIRE + aims) * ((uint64_t)n + 1)))
        board_too_much(b,
                       "motions: too much work in one frame (%u emits); lower `board.bullets` or `board.shots` in "
                       "rom.lua or let fewer bullets emit",
                       b->output->emissions.n);
}

static void fire(struct board *b, const struct emission *m)
{
    struct volley v;
    uint32_t n = 0;

    emit_of(b, m, &v.e);
    load(b, m, &v);
    for (int32_t i = 0; i < v.e.n; i++) {
        if (i + 1 >= v.e.first && i + 1 <= v.e.last)
            continue;
        if (!fire_one(b, &v, i)) { /* the pool is full for the remaining bullets, too */
            emit_refuse(b, v.e.flags & EMIT_SHOTS, left(&v.e, i) - 1);
            break;
        }
        n++;
    }
    count(b, &v, n);
}

void emit_run(struct board *b)
{
    const struct emissions *q = &b->output->emissions;

    for (uint32_t k = 0; k < q->n; k++)
        fire(b, &q->list[k]);
    emit_refuse(b, false, q->dropped[0]);
    emit_refuse(b, true, q->dropped[1]);
    emit_none(b);
}
