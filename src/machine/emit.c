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
    const struct volley v = { .n = e.n, .skip_first = e.first, .skip_last = e.skip_last };
    const bool fires_shots = e.flags & EMIT_SHOTS;
    const uint32_t n = emit_count_left(&v, 0);
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

uint32_t emit_aim_work(const struct board *b, bool is_shot)
{
    return is_shot ? b->enemies.s.top / TARGETS_PER_WORK : 0;
}

static fx to_fx(double v)
{
    fx out = 0;

    fx_from_double(v, &out);
    return out;
}

void emit_aim_volley(const struct board *b, struct volley *v)
{
    v->aim_dir = 0;
    if (v->is_aimed) {
        const struct targets t = board_targets(b, v->fires_shots);
        v->aim_dir = targets_aim(&t, v->aim_x, v->aim_y, v->fires_shots ? ANG_UP : ANG_DOWN);
    }
    if (v->pattern != EMIT_LINE)
        return;
    if (v->is_aimed)
        v->dir = trig_to_degrees(v->aim_dir) + v->dir;
    v->aim_dir = 0;
    ang a = 0;
    trig_from_degrees(v->dir, &a);
    v->cos30 = trig_cos30(a);
    v->sin30 = trig_sin30(a);
}

void emit_compute_bullet(const struct volley *v, int32_t i, struct volley_bullet *out)
{
    const double fraction = v->n > 1 ? (double)i / (double)(v->n - 1) : 0;
    double offset;

    *out = (struct volley_bullet){ .dir = v->dir, .speed = v->speed };
    switch (v->pattern) {
    case EMIT_RING:
        out->dir = v->dir + (double)(360 * i) / (double)v->n;
        break;
    case EMIT_FAN:
        out->dir = (v->n > 1 ? v->dir - v->size / 2 : v->dir) + v->size * fraction;
        break;
    case EMIT_ARC:
        out->dir = v->dir + v->size * fraction;
        break;
    case EMIT_STACK:
        out->speed = v->speed + (v->size - v->speed) * fraction;
        break;
    case EMIT_LINE:
        offset = v->n > 1 ? v->size * (fraction - 0.5) : 0;
        out->dx = -(offset * (v->sin30 / 1073741824.0));
        out->dy = offset * (v->cos30 / 1073741824.0);
        break;
    default:
        break;
    }
}

uint32_t emit_count_left(const struct volley *v, int32_t i)
{
    const int64_t first = int64_max(v->skip_first, i + 1), last = int64_min(v->skip_last, v->n);

    return (uint32_t)(v->n - i - (last >= first ? last - first + 1 : 0));
}

/* Fires bullet i; returns false if the pool is full. */
static bool fire_one(struct board *b, struct volley *v, int32_t i, uint32_t clock)
{
    struct bullets *pool = v->fires_shots ? &b->shots : &b->bullets;
    struct bullet_spec *s = &v->spec;
    struct volley_bullet w;

    emit_compute_bullet(v, i, &w);
    s->x = v->x;
    s->y = v->y;
    if (v->pattern == EMIT_LINE) {
        s->x = motion_shift(v->x, to_fx(v->dx + w.dx));
        s->y = motion_shift(v->y, to_fx(v->dy + w.dy));
    }
    s->speed = to_fx(w.speed);
    trig_from_degrees(w.dir, &s->dir);
    s->dir += v->aim_dir;
    const int32_t slot = emit_fire(b, v->fires_shots, s, fx_nearest(w.speed * 4294967296.0), clock);
    for (int k = 0; slot != NO_SLOT && k < MAX_VALUES; k++)
        if (v->has_values >> k & 1 && bullets_value_column(pool, k))
            bullets_value_column(pool, k)[slot] = v->value[k];
    return slot != NO_SLOT;
}

uint32_t emit_fire_volley(struct board *b, struct volley *v, uint32_t clock)
{
    uint32_t fired = 0;

    for (int32_t i = 0; i < v->n; i++) {
        if (i + 1 >= v->skip_first && i + 1 <= v->skip_last)
            continue;
        if (!fire_one(b, v, i, clock)) { /* the pool is full for the remaining bullets, too */
            emit_count_refused(b, v->fires_shots, emit_count_left(v, i) - 1);
            break;
        }
        fired++;
    }
    return fired;
}

/* ---- the queue ---- */

/* Sets *v to the bullets that emission m fires. */
static void read_volley(const struct board *b, const struct emission *m, struct volley *v)
{
    struct motion_emit e;

    load_emit(b, m, &e);
    const bool fires_shots = e.flags & EMIT_SHOTS, is_aimed = e.flags & EMIT_AIM;
    *v = (struct volley){ .pattern = e.pattern,
                          .fires_shots = fires_shots,
                          .is_aimed = is_aimed,
                          .n = e.n,
                          .skip_first = e.first,
                          .skip_last = e.skip_last,
                          .dir = e.flags & EMIT_DIR ? e.dir
                                 : is_aimed         ? 0
                                                    : trig_to_degrees(m->dir),
                          .speed = e.speed,
                          .size = e.size,
                          .x = (fx)((m->x - (int16_t)m->x) >> Q32_EXTRA_BITS),
                          .y = (fx)((m->y - (int16_t)m->y) >> Q32_EXTRA_BITS),
                          .has_values = e.flags / EMIT_VALUE };
    memcpy(v->value, e.value, sizeof v->value);
    v->aim_x = e.pattern == EMIT_LINE ? to_fx((double)m->x / 4294967296.0) : v->x;
    v->aim_y = e.pattern == EMIT_LINE ? to_fx((double)m->y / 4294967296.0) : v->y;
    v->spec = (struct bullet_spec){ .kind = e.kind,
                                    .tag = e.tag,
                                    .motion = e.motion,
                                    .is_fine = e.motion && b->motions.is_fine[e.motion - 1],
                                    .player = (uint8_t)m->player,
                                    .delay = e.delay,
                                    .orbit_target = e.orbit_target,
                                    .owner_task = m->owner_task };
    v->spec.bank = e.flags & EMIT_BANK ? e.bank : (fires_shots ? &b->shot_kinds : &b->bullet_kinds)->bank[e.kind];
}

static void fire_emission(struct board *b, const struct emission *m)
{
    struct volley v;

    read_volley(b, m, &v);
    emit_aim_volley(b, &v);
    const uint64_t fired = emit_fire_volley(b, &v, b->core.clock + 1);
    const uint32_t aim_work = v.is_aimed && v.pattern != EMIT_LINE ? emit_aim_work(b, v.fires_shots) : 0;
    if (!board_charge_work(b, (WORK_FIRE + aim_work) * (fired + 1)))
        board_raise_overload(
            b,
            "motions: too much work in one frame (%u emits); lower `board.bullets` or `board.shots` in "
            "rom.lua or let fewer bullets emit",
            b->output->emissions.n);
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
