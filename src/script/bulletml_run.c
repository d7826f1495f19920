/*
 * bulletml_run.c - runs BulletML documents each tick: roots, runners and their bullets. bulletml_do.c executes the
 * commands.
 *
 * Runners get their turns in the order in which they were created, before bullets move. In its turn a runner reads what
 * scripts wrote to its bullet, applies the changes in progress, executes the due commands, and writes the bullet's
 * velocity. A runner that only waits costs one comparison with the clock; whether its bullet still exists is then
 * checked only every ALIVE_CHECK_FRAMES frames. A fired bullet spawns where its shooter was, after the hits; it first
 * moves, and its runner gets its first turn, in the next frame.
 *
 * A document's directions are degrees as written: 0 is up, clockwise. The root's rotation, mirroring and scale are
 * applied only when velocities are written to the board and when directions are read from it.
 */
#include <stdio.h>
#include <string.h>
#include "../base/int.h"
#include "api/api.h"
#include "bulletml_parts.h"

enum { ALIVE_CHECK_FRAMES = 16 };

static const int64_t NO_BULLET = (int64_t)H_BULLET << 24; /* the handle of a bullet that does not exist */

/* ---- parameter lists ---- */

void bulletml_retain_list(struct board *b, uint32_t list)
{
    if (list)
        b->ml_params.refs[list - 1]++;
}

void bulletml_release_list(struct board *b, uint32_t list)
{
    if (list && !--b->ml_params.refs[list - 1])
        slots_drop(&b->ml_params.s, list - 1);
}

uint32_t bulletml_new_list(struct board *b, const int64_t *value, int n)
{
    struct ml_params *p = &b->ml_params;
    const int32_t k = board_take_slot(b, &p->s);

    if (k == NO_SLOT)
        return 0;
    p->refs[k] = 1;
    p->n[k] = (uint8_t)n;
    memset(p->value + (size_t)k * ML_MAX_VALUES, 0, ML_MAX_VALUES * sizeof *p->value);
    memcpy(p->value + (size_t)k * ML_MAX_VALUES, value, (size_t)n * sizeof *value);
    return (uint32_t)k + 1;
}

/* ---- directions ---- */

static int64_t direction_from_board(const struct ml_roots *o, uint32_t root, ang dir)
{
    const ang a = dir - o->up_dir[root];

    return ml_angle_to_degrees(o->flags[root] & ROOT_MIRRORED ? 0 - a : a);
}

int64_t bulletml_aim_direction(const struct turn *t)
{
    const struct targets players = board_targets(t->b, false);
    const int32_t i = targets_find_nearest(&players, t->x, t->y);

    if (i != NO_SLOT && players.x[i] == t->x && players.y[i] == t->y)
        return 0;
    return direction_from_board(&t->b->ml_roots, t->root, targets_aim(&players, t->x, t->y, ANG_DOWN));
}

void bulletml_fault(const struct turn *t, uint32_t w, const char *message)
{
    vm_fault(t->b->vm.running, FAULT_SCRIPT, "bulletml/%s.xml:%d: %s",
             cart_name(&t->b->cart, CART_BULLETML, t->b->ml_roots.program[t->root]), (int)ML_LINE(w), message);
}

void bulletml_raise_overload(const struct turn *t, uint32_t w)
{
    const struct ml_runners *r = &t->b->ml_runners;

    board_raise_overload(
        t->b,
        "bulletml/%s.xml:%d: too much BulletML work in one frame (%u runners, %llu commands and expression "
        "steps so far); lower `board.bulletml` in rom.lua or add waits",
        cart_name(&t->b->cart, CART_BULLETML, t->b->ml_roots.program[t->root]), (int)ML_LINE(w), r->s.live,
        (unsigned long long)r->work_done);
}

/* ---- velocities ---- */

/* A document's polar speed and extra velocity, converted to the board: px a frame. */
struct flight {
    fx speed, vx, vy;
    int64_t vx_q32, vy_q32; /* vx, vy in Q31.32 */
};

/* A direction on the board, with its cosine and sine in Q30. */
struct heading {
    ang dir;
    int32_t cosine, sine;
};

static int64_t clamp_speed(int64_t v)
{
    const int64_t limit = (int64_t)MAX_SPEED << 32;

    return int64_clamp(v, -limit, limit);
}

/* Converts a document's speed to px a frame, Q31.32, clamped to MAX_SPEED in both directions. */
static inline int64_t scale_speed(int64_t v, int64_t speed_scale)
{
    const int64_t limit = (int64_t)1 << 46;

    return clamp_speed(speed_scale == ML_ONE ? v : ml_scale(int64_clamp(v, -limit, limit), speed_scale, 32));
}

/* Rounds v, Q31.32 and at most MAX_SPEED, to the nearest fx. */
static inline fx round_to_fx(int64_t v)
{
    return (fx)((v + (1 << 15)) >> 16);
}

static inline __attribute__((always_inline)) struct heading heading_of(const struct ml_roots *o, uint32_t root,
                                                                       int64_t direction)
{
    const ang a = ml_degrees_to_angle(direction);
    struct heading h = { .dir = o->up_dir[root] + (o->flags[root] & ROOT_MIRRORED ? 0 - a : a) };
    int64_t c, s;

    trig_cos_sin40(h.dir, &c, &s);
    h.cosine = (int32_t)((c + (1 << 9)) >> 10);
    h.sine = (int32_t)((s + (1 << 9)) >> 10);
    return h;
}

/* Sets a body's direction in the document and the values derived from it: the board's direction, its cosine and
 * sine. */
static inline __attribute__((always_inline)) void set_heading(struct ml_runners *r, const struct ml_roots *o,
                                                              uint32_t root, uint32_t body, int64_t direction)
{
    const struct heading h = heading_of(o, root, direction);

    r->direction[body] = direction;
    r->written_dir[body] = h.dir;
    r->cosine[body] = h.cosine;
    r->sine[body] = h.sine;
}

static inline __attribute__((always_inline)) struct flight polar_flight(const struct ml_roots *o, uint32_t root,
                                                                        int32_t cosine, int32_t sine, int64_t speed)
{
    const int64_t v = scale_speed(speed, o->speed_scale[root]);
    const int64_t x = ml_scale(v, cosine, 30), y = ml_scale(v, sine, 30);

    return (struct flight){ round_to_fx(v), round_to_fx(x), round_to_fx(y), x, y };
}

/* Converts (vx, vy) from the document's units and axes to the board's and adds it to f. Only the sum is rounded. */
static void add_velocity(struct flight *f, const struct ml_roots *o, uint32_t root, int64_t vx, int64_t vy)
{
    const ang rotation = o->up_dir[root] - ANG_UP;
    const int64_t unmirrored_x = scale_speed(vx, o->speed_scale[root]), y = scale_speed(vy, o->speed_scale[root]),
                  x = o->flags[root] & ROOT_MIRRORED ? -unmirrored_x : unmirrored_x;
    int64_t c, s, added_x = x, added_y = y;

    if (rotation) {
        trig_cos_sin40(rotation, &c, &s);
        added_x = ml_scale(x, c, 40) - ml_scale(y, s, 40);
        added_y = ml_scale(x, s, 40) + ml_scale(y, c, 40);
    }
    f->vx_q32 = clamp_speed(f->vx_q32 + added_x);
    f->vy_q32 = clamp_speed(f->vy_q32 + added_y);
    f->vx = round_to_fx(f->vx_q32);
    f->vy = round_to_fx(f->vy_q32);
}

/* Converts body i's speed, direction and velocity from the document's units and axes to the board's. */
static inline __attribute__((always_inline)) struct flight
flight_of(const struct ml_roots *o, const struct ml_runners *r, uint32_t root, uint32_t i)
{
    struct flight f = polar_flight(o, root, r->cosine[i], r->sine[i], r->speed[i]);

    if (r->vx[i] | r->vy[i])
        add_velocity(&f, o, root, r->vx[i], r->vy[i]);
    return f;
}

/* ---- runners ---- */

/* Creates a runner whose turn comes last. Returns NO_SLOT if the pool is full. */
static int32_t new_runner(struct board *b, uint32_t root, int64_t bullet, uint32_t at, uint32_t wake)
{
    struct ml_runners *r = &b->ml_runners;
    const int32_t i = board_take_slot(b, &r->s);

    if (i == NO_SLOT)
        return i;
    r->bullet[i] = bullet;
    r->serial[i] = ++r->last_serial;
    r->root[i] = root;
    r->body_runner[i] = (uint32_t)i;
    r->order[r->n++] = (uint32_t)i;
    r->pc[i] = at;
    r->wake_clock[i] = wake;
    r->frame[i] = r->params[i] = 0;
    r->depth[i] = 0;
    r->flags[i] = bullet ? 0 : RUNNER_TOP;
    r->last_direction[i] = r->last_speed[i] = 0;
    r->direction[i] = r->speed[i] = r->vx[i] = r->vy[i] = 0;
    for (size_t c = (size_t)i * CHANGE_COUNT; c < ((size_t)i + 1) * CHANGE_COUNT; c++) {
        r->change_from[c] = r->change_to[c] = r->change_step[c] = 0;
        r->change_start[c] = r->change_end[c] = 0;
    }
    r->written_dir[i] = 0;
    r->cosine[i] = r->sine[i] = 0;
    r->written_speed[i] = r->written_vx[i] = r->written_vy[i] = 0;
    b->ml_roots.n_runners[root]++;
    return i;
}

/* Releases a runner's frames and parameters. */
static void clear_runner(struct board *b, uint32_t i)
{
    struct ml_runners *r = &b->ml_runners;
    struct ml_frames *f = &b->ml_frames;

    while (r->frame[i]) {
        const uint32_t k = r->frame[i] - 1;
        bulletml_release_list(b, f->params[k]);
        r->frame[i] = f->parent[k];
        slots_drop(&f->s, k);
    }
    bulletml_release_list(b, r->params[i]);
    r->depth[i] = 0;
    r->params[i] = 0;
}

/* ---- firing ---- */

/* Creates the runner of a fired bullet, which spawns later. Returns its slot + 1, or 0 if a pool is full. */
static uint32_t create_fired_runner(const struct turn *t, const struct new_bullet *f, const struct flight *velocity,
                                    const struct heading *h, struct param_values *params)
{
    struct ml_runners *r = &t->b->ml_runners;

    if (params->n && !params->list)
        params->list = bulletml_new_list(t->b, params->value, params->n);
    else
        bulletml_retain_list(t->b, params->list);
    const int32_t i =
        params->n && !params->list ? NO_SLOT : new_runner(t->b, t->root, NO_BULLET, f->actions_position, t->now + 1);
    if (i == NO_SLOT) {
        bulletml_release_list(t->b, params->list);
        return 0;
    }
    r->params[i] = params->list;
    r->direction[i] = f->direction;
    r->speed[i] = f->speed;
    r->written_dir[i] = h->dir;
    r->cosine[i] = h->cosine;
    r->sine[i] = h->sine;
    r->written_speed[i] = velocity->speed;
    r->written_vx[i] = velocity->vx;
    r->written_vy[i] = velocity->vy;
    return (uint32_t)i + 1;
}

void bulletml_fire(const struct turn *t, const struct new_bullet *f, struct param_values *params)
{
    const struct ml_roots *o = &t->b->ml_roots;
    const bool has_kind = f->label && f->label <= ML_MAX_KINDS;
    struct ml_fired_list *fired = &t->b->ml_fired;

    if (fired->n == fired->cap) {
        emit_count_refused(t->b, false, 1);
        return;
    }
    const struct heading h = heading_of(o, t->root, f->direction);
    const struct flight velocity = polar_flight(o, t->root, h.cosine, h.sine, f->speed);
    fired->entries[fired->n++] = (struct ml_fired_bullet){
        .x = t->x,
        .y = t->y,
        .vx = velocity.vx,
        .vy = velocity.vy,
        .speed = velocity.speed,
        .dir = h.dir,
        .kind = has_kind ? o->label_kind[(size_t)t->root * ML_MAX_KINDS + f->label - 1] : o->kind[t->root],
        .root = t->root,
        .label = f->label,
        .runner = f->actions_position ? create_fired_runner(t, f, &velocity, &h, params) : 0,
    };
}

static int32_t spawn_fired_bullet(struct board *b, const struct ml_fired_bullet *f)
{
    const struct ml_roots *o = &b->ml_roots;
    struct bullet_spec s = { .x = f->x,
                             .y = f->y,
                             .speed = f->speed,
                             .dir = f->dir,
                             .kind = f->kind,
                             .bank =
                                 o->flags[f->root] & ROOT_HAS_BANK ? o->bank[f->root] : b->bullet_kinds.bank[f->kind],
                             .tag = o->tag[f->root],
                             .owner_task = o->owner_task[f->root] };
    const int32_t i = emit_fire(b, false, &s, 0, b->core.clock + 1);

    if (i != NO_SLOT)
        bullets_set_velocity_only(&b->bullets, (uint32_t)i, f->vx, f->vy);
    return i;
}

void bulletml_spawn_fired_bullets(struct board *b)
{
    struct ml_fired_list *fired = &b->ml_fired;

    for (uint32_t k = 0; k < fired->n; k++) {
        const struct ml_fired_bullet *f = &fired->entries[k];
        const int32_t i = spawn_fired_bullet(b, f);
        if (f->runner && i != NO_SLOT)
            b->ml_runners.bullet[f->runner - 1] = board_handle(b, H_BULLET, i);
        if (i != NO_SLOT && b->ml_roots.flags[f->root] & ROOT_HAS_HANDLER)
            board_raise_event(b, EV_FIRED, board_handle(b, H_BULLET, i), (int64_t)f->root << 32 | f->label);
    }
    vm_charge(b->vm.running, WORK_FIRE * (uint64_t)fired->n);
    fired->n = 0;
}

/* ---- turns ---- */

/* Returns the current value of a change in progress. */
static inline int64_t current_change_value(const struct ml_runners *r, size_t c, int change, uint32_t now)
{
    const int64_t k = now - r->change_start[c], term = r->change_end[c] - r->change_start[c];

    if (r->change_step[c])
        return r->change_from[c] +
               ml_scale(r->change_step[c], k, change == CHANGE_DIRECTION ? DIRECTION_STEP_BITS : STEP_BITS);
    return ml_add(r->change_from[c],
                  ml_multiply(ml_subtract(r->change_to[c], r->change_from[c]), ml_divide(k * ML_ONE, term * ML_ONE)));
}

/* Returns v, the current value of direction change c, wrapped to [0, 360). If wrapping alters v, shifts both ends of
 * the change by the same amount, so that they stay near the range even over many rounds. */
static inline int64_t wrap_direction_change(struct ml_runners *r, size_t c, int64_t v)
{
    const int64_t wrapped = ml_wrap(v);

    if (wrapped != v) {
        r->change_from[c] = ml_add(r->change_from[c], wrapped - v);
        r->change_to[c] = ml_add(r->change_to[c], wrapped - v);
    }
    return wrapped;
}

static inline void apply_change(struct ml_runners *r, const struct turn *t, int change, int64_t *values)
{
    const size_t c = (size_t)t->runner * CHANGE_COUNT + (size_t)change;
    const bool finished = (int32_t)(t->now - r->change_end[c]) >= 0;
    const int64_t v = finished ? r->change_to[c] : current_change_value(r, c, change, t->now);

    if (change == CHANGE_DIRECTION)
        set_heading(r, &t->b->ml_roots, t->root, t->body, wrap_direction_change(r, c, v));
    else
        values[t->body] = v;
    if (finished)
        r->flags[t->runner] &= (uint16_t) ~(1u << change);
}

static void apply_changes(struct turn *t)
{
    struct ml_runners *r = &t->b->ml_runners;
    int64_t *const values[CHANGE_COUNT] = {
        [CHANGE_DIRECTION] = r->direction, [CHANGE_SPEED] = r->speed, [CHANGE_X] = r->vx, [CHANGE_Y] = r->vy
    };

    for (int change = 0; change < CHANGE_COUNT; change++)
        if (r->flags[t->runner] & 1 << change)
            apply_change(r, t, change, values[change]);
    t->steered = true;
}

/* Updates the runner with what scripts wrote to its bullet since its last turn, and ends the changes in progress that
 * these writes override. */
static void read_back_bullet(const struct turn *t, uint32_t bullet)
{
    const struct bullets *s = &t->b->bullets;
    const struct ml_roots *o = &t->b->ml_roots;
    struct ml_runners *r = &t->b->ml_runners;
    const uint32_t i = t->runner;
    const bool is_frozen = s->freeze_flags && s->freeze_flags[bullet];
    const fx vx = (is_frozen ? s->saved_vx : s->vx)[bullet], vy = (is_frozen ? s->saved_vy : s->vy)[bullet];

    if (s->dir[bullet] == r->written_dir[i] && s->speed[bullet] == r->written_speed[i] && vx == r->written_vx[i] &&
        vy == r->written_vy[i])
        return;
    if (s->dir[bullet] != r->written_dir[i]) {
        set_heading(r, o, t->root, i, direction_from_board(o, t->root, s->dir[bullet]));
        r->flags[i] &= (uint16_t) ~(1u << CHANGE_DIRECTION);
    }
    if (s->speed[bullet] != r->written_speed[i]) {
        r->speed[i] = ml_divide((int64_t)s->speed[bullet] * (1 << 16), o->speed_scale[t->root]);
        r->flags[i] &= (uint16_t) ~(1u << CHANGE_SPEED);
    }
    r->vx[i] = r->vy[i] = 0;
    r->flags[i] &= (uint16_t) ~(1u << CHANGE_X | 1u << CHANGE_Y);
    r->written_speed[i] = s->speed[bullet];
    r->written_vx[i] = vx;
    r->written_vy[i] = vy;
}

/* Applies the changes in progress, then executes the due commands. */
static void run_runner(struct turn *t)
{
    struct ml_runners *r = &t->b->ml_runners;
    const uint32_t i = t->runner;

    if (r->flags[i] & RUNNER_CHANGES)
        apply_changes(t);
    if ((int32_t)(t->now - r->wake_clock[i]) < 0)
        return;
    if (!(r->flags[i] & RUNNER_ACTIONS_ENDED))
        bulletml_execute(t);
    else if (!(r->flags[i] & RUNNER_CHANGES))
        r->flags[i] |= RUNNER_ENDED;
}

static void steer_bullet(const struct turn *t, uint32_t bullet)
{
    struct bullets *s = &t->b->bullets;
    struct ml_runners *r = &t->b->ml_runners;
    const uint32_t i = t->runner;
    const struct flight f = flight_of(&t->b->ml_roots, r, t->root, i);

    s->dir[bullet] = r->written_dir[i];
    s->speed[bullet] = r->written_speed[i] = f.speed;
    r->written_vx[i] = f.vx;
    r->written_vy[i] = f.vy;
    bullets_set_velocity_only(s, bullet, f.vx, f.vy);
}

/* Runs the turn of a bullet's runner. Returns false if the runner is to be dropped. */
static bool run_bullet(struct turn *t)
{
    struct board *b = t->b;
    struct ml_runners *r = &b->ml_runners;
    const uint32_t i = t->runner, bullet = handle_slot(r->bullet[i]);

    if (!slots_has(&b->bullets.s, bullet, handle_gen(r->bullet[i])) || b->bullets.motion[bullet])
        return false;
    /* A frozen bullet delays its runner by a frame. With `frozen_left` 0 the bullet resumes in this frame's move. */
    if (b->bullets.freeze_flags && b->bullets.freeze_flags[bullet] && b->bullets.frozen_left[bullet]) {
        r->wake_clock[i]++;
        for (size_t c = (size_t)i * CHANGE_COUNT; c < ((size_t)i + 1) * CHANGE_COUNT; c++) {
            r->change_start[c]++;
            r->change_end[c]++;
        }
        return true;
    }
    if ((int32_t)(t->now - r->wake_clock[i]) < 0 && !(r->flags[i] & RUNNER_CHANGES))
        return true;
    t->x = b->bullets.x[bullet];
    t->y = b->bullets.y[bullet];
    read_back_bullet(t, bullet);
    run_runner(t);
    if (t->vanishes) {
        bullets_drop(&b->bullets, bullet);
        return false;
    }
    if (t->steered)
        steer_bullet(t, bullet);
    return !(r->flags[i] & RUNNER_ACTIONS_ENDED) || r->flags[i] & RUNNER_CHANGES;
}

/* Sets *v to the current value of change c. Returns false if the change ends in this frame or has no step. */
static inline bool get_unfinished_change(const struct ml_runners *r, size_t c, int shift, uint32_t now, int64_t *v)
{
    if ((int32_t)(now - r->change_end[c]) >= 0 || !r->change_step[c])
        return false;
    *v = r->change_from[c] + ml_scale(r->change_step[c], now - r->change_start[c], shift);
    return true;
}

/* Returns whether runner i's bullet, in slot k, still exists and has the speed and direction that the runner last
 * set. */
static inline bool is_unmodified(const struct ml_runners *r, const struct bullets *s, uint32_t i, uint32_t k)
{
    return slots_has(&s->s, k, handle_gen(r->bullet[i])) && !s->motion[k] &&
           !((s->dir[k] ^ r->written_dir[i]) | (ang)(s->speed[k] ^ r->written_speed[i]) |
             (ang)(s->vx[k] ^ r->written_vx[i]) | (ang)(s->vy[k] ^ r->written_vy[i]));
}

/*
 * The fast path for the most common turn: a bullet's runner with no command due and only changes in progress. Returns
 * false, with nothing changed, for any other turn.
 */
static inline bool run_fast_turn(struct board *b, uint32_t i, uint32_t now)
{
    struct ml_runners *r = &b->ml_runners;
    const struct ml_roots *o = &b->ml_roots;
    struct bullets *s = &b->bullets;
    const unsigned flags = r->flags[i];
    const uint32_t k = handle_slot(r->bullet[i]), root = r->root[i];
    const size_t c = (size_t)i * CHANGE_COUNT;
    int64_t direction = 0, speed = r->speed[i], vx = r->vx[i], vy = r->vy[i];

    if (flags & RUNNER_TOP || s->freeze_flags || !is_unmodified(r, s, i, k))
        return false;
    if ((flags & 1 << CHANGE_DIRECTION &&
         !get_unfinished_change(r, c + CHANGE_DIRECTION, DIRECTION_STEP_BITS, now, &direction)) ||
        (flags & 1 << CHANGE_SPEED && !get_unfinished_change(r, c + CHANGE_SPEED, STEP_BITS, now, &speed)) ||
        (flags & 1 << CHANGE_X && !get_unfinished_change(r, c + CHANGE_X, STEP_BITS, now, &vx)) ||
        (flags & 1 << CHANGE_Y && !get_unfinished_change(r, c + CHANGE_Y, STEP_BITS, now, &vy)))
        return false;
    if (flags & 1 << CHANGE_DIRECTION)
        set_heading(r, o, root, i, wrap_direction_change(r, c + CHANGE_DIRECTION, direction));
    r->speed[i] = speed;
    r->vx[i] = vx;
    r->vy[i] = vy;
    const struct flight f = flight_of(o, r, root, i);
    const fx max_component = fx_max(fx_abs(f.vx), fx_abs(f.vy));
    s->dir[k] = r->written_dir[i];
    s->speed[k] = r->written_speed[i] = f.speed;
    s->vx[k] = r->written_vx[i] = f.vx;
    s->vy[k] = r->written_vy[i] = f.vy;
    if (max_component > s->speed_bound)
        s->speed_bound = max_component;
    return true;
}

/* Charges the work of scanning all runners for those of one root. */
static void charge_search(struct board *b)
{
    const struct ml_runners *r = &b->ml_runners;

    if (!board_charge_work(b, r->n / 2))
        board_raise_overload(
            b,
            "bulletml: too much work in one frame (%u documents, %u runners); lower `board.bulletml` in "
            "rom.lua or run fewer documents at once",
            b->ml_roots.s.live, r->n);
}

/* Restarts all top-level runners of a root. */
static void restart_root(struct board *b, uint32_t root, const struct ml *ml, uint32_t now)
{
    struct ml_runners *r = &b->ml_runners;
    uint32_t top = 0;

    charge_search(b);
    for (uint32_t k = 0; k < r->n && top < ml->n_top_actions; k++) {
        const uint32_t i = r->order[k];
        if (r->root[i] != root || !(r->flags[i] & RUNNER_TOP))
            continue;
        clear_runner(b, i);
        r->flags[i] = RUNNER_TOP;
        r->pc[i] = ml_top_action(ml, top++);
        r->wake_clock[i] = now;
        r->params[i] = b->ml_roots.params[root];
        bulletml_retain_list(b, r->params[i]);
        memset(&r->change_from[(size_t)i * CHANGE_COUNT], 0, CHANGE_COUNT * sizeof *r->change_from);
    }
    b->ml_roots.flags[root] &= (uint8_t)~ROOT_TOP_ENDED;
}

/* Runs the turn of one of a root's top-level runners. Returns false if the root is over. */
static bool run_top_runner(struct turn *t)
{
    struct board *b = t->b;
    struct ml_roots *o = &b->ml_roots;
    struct ml_runners *r = &b->ml_runners;
    const uint32_t i = t->runner;

    if (o->flags[t->root] & ROOT_DESPAWNED)
        return false;
    if (i == o->body_runner[t->root] && o->flags[t->root] & ROOT_TOP_ENDED && o->flags[t->root] & ROOT_LOOPS)
        restart_root(b, t->root, t->ml, t->now);
    t->x = o->x[t->root];
    t->y = o->y[t->root];
    if (!(r->flags[i] & RUNNER_ENDED))
        run_runner(t);
    if (r->flags[i] & RUNNER_ENDED)
        o->flags[t->root] |= ROOT_TOP_ENDED;
    if (t->vanishes)
        o->flags[t->root] |= ROOT_VANISHES;
    return true;
}

/* ---- roots ---- */

void bulletml_stop(struct board *b, uint32_t i)
{
    b->ml_roots.flags[i] |= ROOT_DESPAWNED;
}

/* Called before the turns. Ends roots whose owner or followed entity no longer exists, moves roots that follow an
 * entity, and drops ended roots that have no runners left (top-level or of bullets). */
static void update_roots(struct board *b)
{
    struct ml_roots *o = &b->ml_roots;

    EACH_LIVE (i, &o->s) {
        if (o->flags[i] & ROOT_DESPAWNED && !o->n_runners[i]) {
            bulletml_release_list(b, o->params[i]);
            slots_drop(&o->s, i);
        } else if (!tasks_is_owner_alive(b, o->owner[i]) ||
                   (o->follow_target[i] && !board_is_alive(b, o->follow_target[i])))
            bulletml_stop(b, i);
        else if (o->follow_target[i]) {
            fx x = 0, y = 0;
            board_get_position(b, o->follow_target[i], &x, &y);
            o->x[i] = motion_clamp_to_world((int64_t)x + o->dx[i]);
            o->y[i] = motion_clamp_to_world((int64_t)y + o->dy[i]);
        }
    }
}

/* Moves a coordinate by `delta`, Q31.32; *fraction holds 16 more fraction bits of the coordinate. The precision matters
 * because some documents move a root during the whole game and aim from it. */
static void move_coordinate(fx *coordinate, int16_t *fraction, int64_t delta)
{
    const int64_t limit = (int64_t)WORLD_EDGE << 32;
    const int64_t target = int64_clamp((int64_t)*coordinate * (1 << 16) + *fraction + delta, -limit, limit),
                  rounded = (target + (1 << 15)) >> 16;

    *fraction = (int16_t)(target - rounded * (1 << 16));
    *coordinate = (fx)rounded;
}

/* Moves a root by its own velocity, together with the enemy it steers, if any. */
static void move_root(struct board *b, uint32_t i)
{
    struct ml_roots *o = &b->ml_roots;
    const struct ml_runners *r = &b->ml_runners;
    const uint32_t k = o->body_runner[i];

    if (o->follow_target[i] && !(o->flags[i] & ROOT_STEERS))
        return;
    if (!(r->speed[k] | r->vx[k] | r->vy[k]))
        return;
    const int64_t v = scale_speed(r->speed[k], o->speed_scale[i]);
    struct flight f = { .vx_q32 = ml_scale(v, trig_cos30(r->written_dir[k]), 30),
                        .vy_q32 = ml_scale(v, trig_sin30(r->written_dir[k]), 30) };
    add_velocity(&f, o, i, r->vx[k], r->vy[k]);
    move_coordinate(&o->x[i], &o->x_low[i], f.vx_q32);
    move_coordinate(&o->y[i], &o->y_low[i], f.vy_q32);
    if (o->follow_target[i]) {
        b->enemies.x[handle_slot(o->follow_target[i])] = motion_clamp_to_world((int64_t)o->x[i] - o->dx[i]);
        b->enemies.y[handle_slot(o->follow_target[i])] = motion_clamp_to_world((int64_t)o->y[i] - o->dy[i]);
    }
}

/* Returns whether all top-level runners of a root have ended. */
static bool have_all_top_runners_ended(struct board *b, uint32_t root)
{
    const struct ml_runners *r = &b->ml_runners;

    charge_search(b);
    for (uint32_t k = 0; k < r->n; k++)
        if (r->root[r->order[k]] == root && (r->flags[r->order[k]] & (RUNNER_TOP | RUNNER_ENDED)) == RUNNER_TOP)
            return false;
    return true;
}

/* Called after the turns. Ends roots that vanished or have finished, and moves the others. */
static void end_or_move_roots(struct board *b)
{
    struct ml_roots *o = &b->ml_roots;

    EACH_LIVE (i, &o->s) {
        if (o->flags[i] & ROOT_VANISHES)
            bulletml_stop(b, i);
        else if (!(o->flags[i] & ROOT_DESPAWNED))
            move_root(b, i);
        if (o->flags[i] & ROOT_TOP_ENDED && !(o->flags[i] & (ROOT_LOOPS | ROOT_DESPAWNED)) &&
            have_all_top_runners_ended(b, i))
            bulletml_stop(b, i);
    }
    slots_trim(&o->s);
}

/* The document opened for the previous runner's turn; the next runner usually has the same one. */
struct cached_document {
    uint32_t program; /* UINT32_MAX: none */
    struct ml ml;
};

/* Runs one turn. Returns false if the runner is to be dropped. */
static bool run_turn(struct board *b, uint32_t i, uint32_t now, struct cached_document *cache)
{
    struct turn t = { .b = b,
                      .ml = &cache->ml,
                      .runner = i,
                      .root = b->ml_runners.root[i],
                      .body = b->ml_runners.body_runner[i],
                      .now = now };

    if (cache->program != b->ml_roots.program[t.root]) {
        cache->program = b->ml_roots.program[t.root];
        cart_bulletml(&b->cart, (int)cache->program, &cache->ml);
    }
    return b->ml_runners.flags[i] & RUNNER_TOP ? run_top_runner(&t) : run_bullet(&t);
}

void bulletml_run(struct board *b)
{
    struct ml_runners *r = &b->ml_runners;
    const uint32_t now = b->core.clock, n = r->n;
    const bool any_frozen = b->bullets.freeze_flags;
    struct cached_document cache = { .program = UINT32_MAX };
    uint32_t live = 0;

    b->ml_fired.n = 0;
    r->work_done = 0;
    update_roots(b);
    for (uint32_t k = 0; k < n; k++) {
        const uint32_t i = r->order[k];
        const bool due = (int32_t)(now - r->wake_clock[i]) >= 0 && !(r->flags[i] & RUNNER_ACTIONS_ENDED);
        const bool is_waiting =
            !due && !(r->flags[i] & (RUNNER_CHANGES | RUNNER_TOP)) && !any_frozen && (k + now) % ALIVE_CHECK_FRAMES;
        if (is_waiting || (!due && run_fast_turn(b, i, now)) || run_turn(b, i, now, &cache))
            r->order[live++] = i;
        else {
            clear_runner(b, i);
            b->ml_roots.n_runners[r->root[i]]--;
            slots_drop(&r->s, i);
        }
    }
    memmove(r->order + live, r->order + n, (r->n - n) * sizeof *r->order);
    r->n -= n - live;
    end_or_move_roots(b);
    slots_trim(&r->s);
    slots_trim(&b->ml_frames.s);
    slots_trim(&b->ml_params.s);
}

int32_t bulletml_begin(struct board *b, const struct bulletml_start *start)
{
    struct ml_roots *o = &b->ml_roots;
    struct ml_runners *r = &b->ml_runners;
    struct ml ml;

    cart_bulletml(&b->cart, start->program, &ml);
    if (!ml.n_top_actions)
        return NO_SLOT;
    const int32_t i = board_take_slot(b, &o->s);
    if (i == NO_SLOT)
        return i;
    o->owner[i] = start->owner;
    o->follow_target[i] = start->follow;
    o->x[i] = start->x;
    o->y[i] = start->y;
    o->x_low[i] = o->y_low[i] = 0;
    o->dx[i] = start->dx;
    o->dy[i] = start->dy;
    o->program[i] = start->program;
    o->kind[i] = start->kind;
    o->tag[i] = start->tag;
    memcpy(o->label_kind + (size_t)i * ML_MAX_KINDS, start->kinds, ML_MAX_KINDS * sizeof *o->label_kind);
    o->bank[i] = start->bank;
    o->flags[i] = start->flags;
    o->n_runners[i] = 0;
    o->owner_task[i] = tasks_current_serial(b);
    o->stream[i] = start->seed;
    o->params[i] = start->param_count ? bulletml_new_list(b, start->param, start->param_count) : 0;
    o->rank[i] = start->rank;
    o->speed_scale[i] = start->speed_scale;
    o->up_dir[i] = ANG_UP + start->angle;
    for (uint32_t top = 0; top < ml.n_top_actions; top++) {
        const int32_t k = new_runner(b, (uint32_t)i, 0, ml_top_action(&ml, top), b->core.clock);
        if (k == NO_SLOT) {
            bulletml_stop(b, (uint32_t)i);
            return NO_SLOT;
        }
        if (!top) {
            o->body_runner[i] = (uint32_t)k;
            set_heading(r, o, (uint32_t)i, (uint32_t)k, 180 * ML_ONE);
        }
        r->body_runner[k] = o->body_runner[i];
        r->params[k] = o->params[i];
        bulletml_retain_list(b, o->params[i]);
    }
    return i;
}
