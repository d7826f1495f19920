/*
 * emit.c - see emit.h. The patterns match those of scripts/pattern.lua bit for bit, because both use the same
 * operations on doubles, in the same order.
 */
#include "emit.h"
#include <assert.h>
#include <string.h>
#include "machine.h"

enum { INITIAL_CAPACITY = 64, TARGETS_PER_WORK = 8 /* targets examined per unit of work */ };

void emit_clear(struct board *b)
{
    b->output->emissions = (struct emissions){ 0 };
}

/* Grows the queue. The first block of a frame is the one that an earlier frame allocated, if any:
 * vm_calls.alloc_emissions finds it, because a restore loses the pointer `list`. */
static void grow_queue(const struct board *b, struct emissions *q)
{
    size_t size = (q->cap ? 2 * q->cap : INITIAL_CAPACITY) * sizeof *q->list;
    struct emission *list = b->calls->alloc_emissions(b, q->list, &size);

    if (q->n)
        memcpy(list, q->list, q->n * sizeof *list);
    q->list = list;
    q->cap = (uint32_t)(size / sizeof *list);
}

/* Returns whether this number of the step refers to a named value; if so, stores the value in *v, or 0 if the bullet or
 * shot does not have it. */
static bool get_named_value(const struct motion_emit *e, const struct emission *m, int number, fx *v)
{
    bool is_named;
    const int k = motion_value_column(e->named_values, number, m->is_shot, &is_named);

    *v = k < 0 ? 0 : m->value[k];
    return is_named;
}

static int32_t to_count(fx v)
{
    return v < 0 ? 0 : v / FX_ONE;
}

static double resolve_number(const struct motion_emit *e, const struct emission *m, int n, double literal, int limit)
{
    fx v;

    return get_named_value(e, m, n, &v) ? fx_to_double(fx_clamp(v, -limit * FX_ONE, limit * FX_ONE)) : literal;
}

/* Loads the emit step of m, with references to named values replaced by the values of m's bullet or shot. */
static void load_emit(const struct board *b, const struct emission *m, struct motion_emit *e)
{
    fx v;

    motion_unpack_emit(&b->steps, m->step, e);
    if (!e->named_values)
        return;
    if (get_named_value(e, m, EMIT_NUMBER_N, &v))
        e->n = (uint16_t)to_count(v);
    if (get_named_value(e, m, EMIT_NUMBER_BANK, &v))
        e->bank = (uint8_t)(v >> 16 & 15);
    if (get_named_value(e, m, EMIT_NUMBER_DELAY, &v))
        e->delay = (uint32_t)to_count(v);
    if (get_named_value(e, m, EMIT_NUMBER_DIR, &v))
        e->dir = fx_to_double(v);
    e->speed = resolve_number(e, m, EMIT_NUMBER_SPEED, e->speed, MAX_SPEED);
    e->size = resolve_number(e, m, EMIT_NUMBER_SIZE, e->size,
                             e->pattern == EMIT_STACK  ? MAX_SPEED
                             : e->pattern == EMIT_LINE ? WORLD_EDGE
                                                       : 32767);
    for (int k = 0; k < MAX_VALUES; k++)
        if (get_named_value(e, m, EMIT_NUMBER_VALUE + k, &v))
            e->value[k] = v;
}

/* Returns how many bullets the step fires from bullet i on, i < n, not counting the skipped ones. */
static uint32_t count_bullets_left(const struct motion_emit *e, int32_t i)
{
    const int32_t first = e->first > i + 1 ? e->first : i + 1, last = e->skip_last < e->n ? e->skip_last : e->n;

    return (uint32_t)(e->n - i - (last >= first ? last - first + 1 : 0));
}

void emit_queue(const struct motion_world *w, const struct bullets *s, uint32_t i, uint32_t step)
{
    const struct board *b = w->context;
    struct emissions *q = &b->output->emissions;
    struct emission m = {
        .dir = s->dir[i], .step = step, .owner_task = s->owner_task[i], .player = s->player[i], .is_shot = w->is_shots
    };
    struct motion_emit e;

    bullets_get_position(s, i, &m.x, &m.y);
    for (int k = 0; k < MAX_VALUES && bullets_value_column(s, k); k++)
        m.value[k] = bullets_value_column(s, k)[i];
    load_emit(b, &m, &e);
    const bool fires_shots = e.flags & EMIT_SHOTS;
    const uint32_t n = count_bullets_left(&e, 0);
    if (!n)
        return;
    if (q->queued_count[fires_shots] == (fires_shots ? &b->shots : &b->bullets)->s.cap) {
        q->dropped_count[fires_shots] += n;
        return;
    }
    if (q->n == q->cap)
        grow_queue(b, q);
    q->queued_count[fires_shots]++;
    q->list[q->n++] = m;
}

int32_t emit_fire(struct board *b, bool is_shot, struct bullet_spec *s, int64_t speed_q32, uint32_t clock)
{
    struct bullets *pool = is_shot ? &b->shots : &b->bullets;
    const struct bullet_kinds *kinds = is_shot ? &b->shot_kinds : &b->bullet_kinds;

    s->hp = kinds->hp ? kinds->hp[s->kind] : 0;
    s->pierce_hits = kinds->pierce_hits ? kinds->pierce_hits[s->kind] : 0;
    s->is_clouded = s->delay && kinds->flags[s->kind] & KIND_HAS_CLOUD;
    int32_t i = bullets_fire(pool, s, clock);
    if (i == NO_SLOT)
        board_report_full(b, &pool->s);
    else if (s->is_fine)
        bullets_set_speed(pool, (uint32_t)i, speed_q32);
    return i;
}

void emit_count_refused(struct board *b, bool is_shot, uint64_t n)
{
    struct slots *s = is_shot ? &b->shots.s : &b->bullets.s;

    if (!n)
        return;
    s->refused++;
    board_report_full(b, s);
    s->refused += (uint32_t)(n - 1);
}

void emit_set_direction(struct emit_pattern_params *f)
{
    ang a = 0;

    trig_from_degrees(f->dir, &a);
    f->cos30 = trig_cos30(a);
    f->sin30 = trig_sin30(a);
}

void emit_compute_bullet(const struct emit_pattern_params *f, int32_t i, struct emit_bullet *out)
{
    const double fraction = f->n > 1 ? (double)i / (double)(f->n - 1) : 0;
    double offset;

    *out = (struct emit_bullet){ .dir = f->dir, .speed = f->speed };
    switch (f->pattern) {
    case EMIT_RING:
        out->dir = f->dir + (double)(360 * i) / (double)f->n;
        break;
    case EMIT_FAN:
        out->dir = (f->n > 1 ? f->dir - f->size / 2 : f->dir) + f->size * fraction;
        break;
    case EMIT_ARC:
        out->dir = f->dir + f->size * fraction;
        break;
    case EMIT_STACK:
        out->speed = f->speed + (f->size - f->speed) * fraction;
        break;
    case EMIT_LINE:
        offset = f->n > 1 ? f->size * (fraction - 0.5) : 0;
        out->dx = -(offset * (f->sin30 / 1073741824.0));
        out->dy = offset * (f->cos30 / 1073741824.0);
        break;
    default:
        break;
    }
}

/* The bullets of one emission: the data they share, and the shape of the next bullet. */
struct volley {
    struct motion_emit e;
    struct bullet_spec spec;
    struct emit_pattern_params f;
    fx x, y;       /* origin */
    bool is_aimed; /* aim each bullet at the nearest target */
};

static fx to_fx(double v)
{
    fx out = 0;

    fx_from_double(v, &out);
    return out;
}

/* Prepares a line. If the line is aimed, all its bullets are aimed together, from the middle. */
static void prepare_line(struct board *b, const struct emission *m, struct volley *v)
{
    const struct targets t = board_motion_world(b, v->e.flags & EMIT_SHOTS).targets;
    const ang default_dir = v->e.flags & EMIT_SHOTS ? ANG_UP : ANG_DOWN;

    if (v->is_aimed) {
        const fx x = to_fx((double)m->x / 4294967296.0), y = to_fx((double)m->y / 4294967296.0);
        v->f.dir = trig_to_degrees(targets_aim(&t, x, y, default_dir)) + v->f.dir;
        v->is_aimed = false;
    }
    emit_set_direction(&v->f);
}

static void init_volley(struct board *b, const struct emission *m, struct volley *v)
{
    const struct motion_emit *e = &v->e;
    const bool fires_shots = e->flags & EMIT_SHOTS;

    v->is_aimed = e->flags & EMIT_AIM;
    v->f = (struct emit_pattern_params){ .pattern = e->pattern,
                                         .n = e->n,
                                         .dir = e->flags & EMIT_DIR ? e->dir
                                                : v->is_aimed       ? 0
                                                                    : trig_to_degrees(m->dir),
                                         .speed = e->speed,
                                         .size = e->size };
    v->x = (fx)((m->x - (int16_t)m->x) >> Q32_EXTRA_BITS);
    v->y = (fx)((m->y - (int16_t)m->y) >> Q32_EXTRA_BITS);
    v->spec = (struct bullet_spec){ .kind = e->kind,
                                    .tag = e->tag,
                                    .motion = e->motion,
                                    .is_fine = e->motion && b->motions.is_fine[e->motion - 1],
                                    .player = (uint8_t)m->player,
                                    .delay = e->delay,
                                    .orbit_target = e->orbit_target,
                                    .owner_task = m->owner_task };
    v->spec.bank = e->flags & EMIT_BANK ? e->bank : (fires_shots ? &b->shot_kinds : &b->bullet_kinds)->bank[e->kind];
    if (e->pattern == EMIT_LINE)
        prepare_line(b, m, v);
}

static bool fire_one(struct board *b, struct volley *v, int32_t i)
{
    const bool fires_shots = v->e.flags & EMIT_SHOTS;
    struct bullet_spec *s = &v->spec;
    struct bullets *pool = fires_shots ? &b->shots : &b->bullets;
    struct emit_bullet w;

    emit_compute_bullet(&v->f, i, &w);
    s->x = motion_shift(v->x, to_fx(w.dx));
    s->y = motion_shift(v->y, to_fx(w.dy));
    s->speed = to_fx(w.speed);
    trig_from_degrees(w.dir, &s->dir);
    if (v->is_aimed) {
        const struct targets t = board_motion_world(b, fires_shots).targets;
        s->dir += targets_aim(&t, s->x, s->y, fires_shots ? ANG_UP : ANG_DOWN);
    }
    const int32_t at = emit_fire(b, fires_shots, s, fx_nearest(w.speed * 4294967296.0), b->core.clock + 1);
    for (int k = 0; at != NO_SLOT && k < MAX_VALUES; k++)
        if (v->e.flags & EMIT_VALUE << k && bullets_value_column(pool, k))
            bullets_value_column(pool, k)[at] = v->e.value[k];
    return at != NO_SLOT;
}

static void charge_work(struct board *b, const struct volley *v, uint32_t n)
{
    const uint32_t aim_work = v->is_aimed && v->e.flags & EMIT_SHOTS ? b->enemies.s.top / TARGETS_PER_WORK : 0;

    if (!board_charge_work(b, (WORK_FIRE + aim_work) * ((uint64_t)n + 1)))
        board_raise_overload(
            b,
            "motions: too much work in one frame (%u emits); lower `board.bullets` or `board.shots` in "
            "rom.lua or let fewer bullets emit",
            b->output->emissions.n);
}

static void fire_emission(struct board *b, const struct emission *m)
{
    struct volley v;
    uint32_t n = 0;

    load_emit(b, m, &v.e);
    init_volley(b, m, &v);
    for (int32_t i = 0; i < v.e.n; i++) {
        if (i + 1 >= v.e.first && i + 1 <= v.e.skip_last)
            continue;
        if (!fire_one(b, &v, i)) { /* the pool is full for the remaining bullets, too */
            emit_count_refused(b, v.e.flags & EMIT_SHOTS, count_bullets_left(&v.e, i) - 1);
            break;
        }
        n++;
    }
    charge_work(b, &v, n);
}

void emit_run(struct board *b)
{
    const struct emissions *q = &b->output->emissions;

    for (uint32_t k = 0; k < q->n; k++)
        fire_emission(b, &q->list[k]);
    emit_count_refused(b, false, q->dropped_count[0]);
    emit_count_refused(b, true, q->dropped_count[1]);
    emit_clear(b);
}
