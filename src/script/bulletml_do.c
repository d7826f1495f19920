/*
 * bulletml_do.c - executes the commands of BulletML documents, one runner at a time, and evaluates their expressions.
 *
 * A list of actions ends with its last element, even if that element is a wait. A runner with no command after the wait
 * is over immediately, and a bullet's next action starts in the frame in which the wait ends, not one frame later.
 *
 * A fire completes within one turn, so its state is in C variables and not in RAM. A repeat or an action call can last
 * many turns, so each has an entry (a frame of the call stack) in a pool.
 */
#include <assert.h>
#include <string.h>
#include "bulletml_parts.h"

/* A fire being prepared: its speed and direction so far, and where execution continues after a fireRef or bulletRef. */
struct pending_fire {
    bool has_speed, has_direction;
    int64_t speed, direction;
    uint32_t after_fire, after_bullet; /* program positions; 0: inline, nowhere to return to */
};

/* The working state of one turn. */
struct work_state {
    struct turn *t;
    struct ml_runners *r;
    uint32_t at;
    struct pending_fire pending_fire;
    struct param_values action_params, fire_params,
        bullet_params;           /* parameters of the action, the fireRef and the bulletRef */
    struct param_values *params; /* the parameters that expressions use now: one of the three above */
    int64_t fire_value[ML_PARAMS], bullet_value[ML_PARAMS];
    bool yields;    /* the remaining commands run in the next frame */
    uint64_t steps; /* expression steps not charged yet */
};

static uint32_t next_word(struct work_state *w)
{
    return ml_word(w->t->ml, w->at++);
}

static int64_t get_param(const struct param_values *g, uint32_t i)
{
    if (i == 0)
        return g->n ? 0 : ML_ONE;
    return i <= (uint32_t)g->n ? g->value[i - 1] : ML_ONE;
}

/* Evaluates the expression whose steps start at `at`. */
static int64_t evaluate(struct work_state *w, uint32_t at)
{
    struct ml_roots *o = &w->t->b->ml_roots;
    int64_t stack[ML_STACK_SIZE + 1], *top = stack; /* top: the topmost number; stack[0] is unused */
    const uint32_t first = at;

    for (;; at++) {
        const uint32_t step = ml_step(w->t->ml, at), argument = ML_ARGUMENT(step);
        switch ((enum ml_step)ML_STEP(step)) {
        case STEP_NUMBER:
            *++top = ml_number(w->t->ml, argument);
            break;
        case STEP_RAND:
            *++top = ml_rand(&o->stream[w->t->root]);
            break;
        case STEP_RANK:
            *++top = o->rank[w->t->root];
            break;
        case STEP_PARAM:
            *++top = get_param(w->params, argument);
            break;
        case STEP_ADD:
            top--;
            *top = ml_add(top[0], top[1]);
            break;
        case STEP_SUBTRACT:
            top--;
            *top = ml_subtract(top[0], top[1]);
            break;
        case STEP_MULTIPLY:
            top--;
            *top = ml_multiply(top[0], top[1]);
            break;
        case STEP_DIVIDE:
            top--;
            *top = ml_divide(top[0], top[1]);
            break;
        case STEP_NEGATE:
            *top = ml_negate(*top);
            break;
        default:
            w->steps += at - first;
            return *top;
        }
    }
}

static int64_t resolve_value(struct work_state *w, uint32_t v)
{
    return v & ML_COMPUTED ? evaluate(w, v & ~ML_COMPUTED) : ml_number(w->t->ml, v);
}

static int64_t next_value(struct work_state *w)
{
    return resolve_value(w, next_word(w));
}

/* Evaluates n values and stores the first ML_PARAMS of them. Returns how many it stored. */
static int next_values(struct work_state *w, uint32_t n, int64_t out[ML_PARAMS])
{
    for (uint32_t i = 0; i < n; i++) {
        const int64_t v = next_value(w);
        if (i < ML_PARAMS)
            out[i] = v;
    }
    return (int)(n < ML_PARAMS ? n : ML_PARAMS);
}

/* Resolves a direction to degrees in [0, 360]; a positive multiple of 360 becomes 360, not 0. */
static int64_t resolve_direction(const struct work_state *w, enum ml_type type, int64_t v)
{
    struct ml_runners *r = w->r;
    const uint32_t i = w->t->runner;

    if (type == ML_ABSOLUTE)
        v = w->t->ml->horizontal ? ml_subtract(v, 90 * ML_ONE) : v;
    else if (type == ML_RELATIVE)
        v = ml_add(v, r->direction[w->t->body]);
    else if (type == ML_SEQUENCE)
        v = r->flags[i] & RUNNER_HAS_LAST_DIRECTION ? ml_add(v, r->last_direction[i]) : bulletml_aim_direction(w->t);
    else
        v = ml_add(v, bulletml_aim_direction(w->t));
    if (v < 0 || v > ML_FULL_TURN) {
        const bool positive = v > 0;
        v = ml_wrap(v);
        v = positive && v == 0 ? ML_FULL_TURN : v;
    }
    r->last_direction[i] = v;
    r->flags[i] |= RUNNER_HAS_LAST_DIRECTION;
    return v;
}

static int64_t resolve_speed(const struct work_state *w, enum ml_type type, int64_t v)
{
    struct ml_runners *r = w->r;
    const uint32_t i = w->t->runner;

    if (type == ML_RELATIVE)
        v = ml_add(v, r->speed[w->t->body]);
    else if (type == ML_SEQUENCE)
        v = r->flags[i] & RUNNER_HAS_LAST_SPEED ? ml_add(v, r->last_speed[i]) : ML_ONE;
    r->last_speed[i] = v;
    r->flags[i] |= RUNNER_HAS_LAST_SPEED;
    return v;
}

/* Starts a timed change from `from` to `to` that takes `term` frames, at least 1. per_frame: the change per frame, or 0
 * to divide the difference by `term`. */
static void begin_change(const struct work_state *w, int change, int64_t from, int64_t to, int32_t term,
                         int64_t per_frame)
{
    struct ml_runners *r = w->r;
    const uint32_t i = w->t->runner;
    const size_t c = (size_t)i * CHANGE_COUNT + (size_t)change;
    const int64_t scale = (int64_t)1 << (change == CHANGE_DIRECTION ? DIRECTION_STEP_BITS : STEP_BITS),
                  limit = ((int64_t)1 << 62) / scale, difference = ml_subtract(to, from);
    const uint32_t frames = term > MAX_DURATION ? MAX_DURATION : term > 1 ? (uint32_t)term : 1;

    r->change_from[c] = from;
    r->change_to[c] = to;
    r->change_step[c] = difference > -limit && difference < limit ? difference * scale / (int64_t)frames : 0;
    if (per_frame && per_frame > -limit && per_frame < limit)
        r->change_step[c] = per_frame * scale;
    r->change_start[c] = r->wake_clock[i];
    r->change_end[c] = r->wake_clock[i] + frames;
    r->flags[i] |= (uint16_t)(1u << change);
}

/* Starts a change of direction. A sequence turns by its value per frame. Other types turn the shorter way round; for
 * exactly half a turn, the side is opposite in sign to the plain difference. */
static void begin_direction_change(struct work_state *w, enum ml_type type)
{
    const int32_t term = ml_to_whole(next_value(w));
    const int64_t v = next_value(w), current = w->r->direction[w->t->body];

    if (type == ML_SEQUENCE) {
        begin_change(w, CHANGE_DIRECTION, current, ml_add(current, ml_multiply(v, term * ML_ONE)), term,
                     term > 1 ? v : 0);
        return;
    }
    const int64_t delta = resolve_direction(w, type, v) - current,
                  opposite_delta = delta > 0 ? delta - ML_FULL_TURN : delta + ML_FULL_TURN;
    begin_change(w, CHANGE_DIRECTION, current,
                 current + (int64_abs(delta) < int64_abs(opposite_delta) ? delta : opposite_delta), term, 0);
}

static void begin_speed_change(struct work_state *w, enum ml_type type)
{
    const int32_t term = ml_to_whole(next_value(w));
    const int64_t v = next_value(w), current = w->r->speed[w->t->body];

    begin_change(w, CHANGE_SPEED, current,
                 type == ML_SEQUENCE ? ml_add(current, ml_multiply(v, term * ML_ONE)) : resolve_speed(w, type, v), term,
                 0);
}

static void begin_accelerations(struct work_state *w, uint32_t types)
{
    const uint32_t x = types % ML_Y_TYPE_FACTOR, y = types / ML_Y_TYPE_FACTOR;
    const int32_t term = ml_to_whole(next_value(w));

    for (int change = CHANGE_X; change <= CHANGE_Y; change++) {
        const uint32_t type = change == CHANGE_X ? x : y, operand = next_word(w);
        if (type == ML_NONE)
            continue;
        const int64_t current = (change == CHANGE_X ? w->r->vx : w->r->vy)[w->t->body];
        int64_t v = resolve_value(w, operand);
        if (type == ML_SEQUENCE)
            v = ml_multiply(v, term * ML_ONE);
        begin_change(w, change, current, type == ML_SEQUENCE || type == ML_RELATIVE ? ml_add(current, v) : v, term, 0);
    }
}

/* ---- repeats and calls ---- */

/* Pushes a new innermost call frame. If the pool is full, ends the runner's actions and returns false. */
static bool push_frame(struct work_state *w, uint32_t command, int32_t repeats_left, uint32_t return_at, uint32_t list)
{
    struct ml_frames *f = &w->t->b->ml_frames;
    const uint32_t i = w->t->runner;

    if (w->r->depth[i] == MAX_CALL_DEPTH)
        bulletml_fault(w->t, command, "repeats and calls nested more than 4096 deep");
    const int32_t k = board_take_slot(w->t->b, &f->s);
    if (k == NO_SLOT) {
        w->r->flags[i] |= RUNNER_ACTIONS_ENDED;
        return false;
    }
    f->parent[k] = w->r->frame[i];
    f->return_pc[k] = return_at;
    f->params[k] = list;
    f->rounds_left[k] = repeats_left;
    w->r->frame[i] = (uint32_t)k + 1;
    w->r->depth[i]++;
    return true;
}

static void pop_frame(struct work_state *w)
{
    struct ml_frames *f = &w->t->b->ml_frames;
    const uint32_t i = w->t->runner, k = w->r->frame[i] - 1;

    w->r->frame[i] = f->parent[k];
    w->r->depth[i]--;
    slots_drop(&f->s, k);
}

/* Makes `list` (slot + 1; 0: none) the runner's own parameters. Takes over the caller's reference to the list. */
static void set_params(struct work_state *w, uint32_t list)
{
    const struct ml_params *p = &w->t->b->ml_params;

    w->r->params[w->t->runner] = list;
    w->action_params = (struct param_values){ list ? p->n[list - 1] : 0,
                                              list ? p->value + (size_t)(list - 1) * ML_MAX_VALUES : NULL, list };
}

/* Calls an action with its own parameters. If a pool is full, ends the runner's actions. */
static void call_action(struct work_state *w, uint32_t command)
{
    const uint32_t i = w->t->runner, target = next_word(w), n = next_word(w), old_list = w->r->params[i];
    int64_t values[ML_PARAMS];
    const int n_values = next_values(w, n, values);
    const uint32_t list = n_values ? bulletml_new_list(w->t->b, values, n_values) : 0;

    if (n_values && !list) {
        w->r->flags[i] |= RUNNER_ACTIONS_ENDED;
        return;
    }
    if (ML_OP(command) == ML_CALL) {
        if (!push_frame(w, command, 0, w->at, old_list)) {
            bulletml_release_list(w->t->b, list);
            return;
        }
    } else
        bulletml_release_list(w->t->b, old_list);
    while (ML_OP(command) == ML_LEAVE && w->r->frame[i]) {
        bulletml_release_list(w->t->b, w->t->b->ml_frames.params[w->r->frame[i] - 1]);
        pop_frame(w);
    }
    set_params(w, list);
    w->at = target;
}

static void return_from_call(struct work_state *w)
{
    const struct ml_frames *f = &w->t->b->ml_frames;
    const uint32_t frame = w->r->frame[w->t->runner];

    if (!frame) {
        w->r->flags[w->t->runner] |= RUNNER_ACTIONS_ENDED;
        return;
    }
    w->at = f->return_pc[frame - 1];
    bulletml_release_list(w->t->b, w->r->params[w->t->runner]);
    set_params(w, f->params[frame - 1]);
    pop_frame(w);
}

static void end_repeat(struct work_state *w)
{
    const struct ml_frames *f = &w->t->b->ml_frames;
    const uint32_t frame = w->r->frame[w->t->runner], target = next_word(w);

    if (frame && --f->rounds_left[frame - 1] > 0)
        w->at = target;
    else if (frame)
        pop_frame(w);
}

/* ---- fires ---- */

/* Calls a fireRef or bulletRef with its own parameters, stored in `params` and `values`; *after receives the position
 * after the call. */
static void call_ref(struct work_state *w, struct param_values *params, int64_t values[ML_PARAMS], uint32_t *after)
{
    const uint32_t target = next_word(w), n = next_word(w);

    *params = (struct param_values){ next_values(w, n, values), values, 0 };
    *after = w->at;
    w->params = params;
    w->at = target;
}

/* Fires the bullet. Unset speed and direction get their defaults: speed 1, aimed at the player. */
static void fire_bullet(struct work_state *w)
{
    struct pending_fire *s = &w->pending_fire;
    const uint32_t label = next_word(w), at = next_word(w);

    if (!s->has_speed)
        s->speed = resolve_speed(w, ML_ABSOLUTE, ML_ONE);
    if (!s->has_direction)
        s->direction = resolve_direction(w, ML_AIM, 0);
    const struct new_bullet f = { ml_wrap(s->direction), s->speed, label, at };
    bulletml_fire(w->t, &f, w->params);
    if (s->after_bullet) {
        w->at = s->after_bullet;
        s->after_bullet = 0;
        w->params = s->after_fire ? &w->fire_params : &w->action_params;
    }
}

static void end_fire(struct work_state *w)
{
    if (w->pending_fire.after_fire) {
        w->at = w->pending_fire.after_fire;
        w->pending_fire.after_fire = 0;
        w->params = &w->action_params;
    }
}

static void begin_wait(struct work_state *w)
{
    const int32_t n = ml_to_whole(next_value(w));

    if (n > 0)
        w->r->wake_clock[w->t->runner] += (uint32_t)(n > MAX_DURATION ? MAX_DURATION : n);
}

static void execute_command(struct work_state *w, uint32_t c)
{
    const enum ml_type type = (enum ml_type)(ML_TYPE(c) % ML_Y_TYPE_FACTOR);

    switch ((enum ml_op)ML_OP(c)) {
    case ML_NEXT:
        w->yields = true;
        break;
    case ML_WAIT:
        begin_wait(w);
        break;
    case ML_REPEAT:
        push_frame(w, c, ml_to_whole(next_value(w)), 0, 0);
        break;
    case ML_END_REPEAT:
        end_repeat(w);
        break;
    case ML_CALL:
    case ML_TAIL_CALL:
    case ML_LEAVE:
        call_action(w, c);
        break;
    case ML_RETURN:
        return_from_call(w);
        break;
    case ML_FIRE:
        w->pending_fire.has_speed = w->pending_fire.has_direction = false;
        break;
    case ML_FIRE_REF:
        call_ref(w, &w->fire_params, w->fire_value, &w->pending_fire.after_fire);
        break;
    case ML_FIRE_RETURN:
        end_fire(w);
        break;
    case ML_SHOT_SPEED:
        w->pending_fire.speed = resolve_speed(w, type, next_value(w));
        w->pending_fire.has_speed = true;
        break;
    case ML_SHOT_DIRECTION:
        w->pending_fire.direction = resolve_direction(w, type, next_value(w));
        w->pending_fire.has_direction = true;
        break;
    case ML_BULLET_REF:
        call_ref(w, &w->bullet_params, w->bullet_value, &w->pending_fire.after_bullet);
        break;
    case ML_BULLET:
        fire_bullet(w);
        break;
    case ML_VANISH:
        w->t->vanishes = true;
        break;
    case ML_TURN:
        begin_direction_change(w, type);
        break;
    case ML_SPEED:
        begin_speed_change(w, type);
        break;
    case ML_ACCEL:
        begin_accelerations(w, ML_TYPE(c));
        break;
    default: /* ML_END */
        w->r->flags[w->t->runner] |= RUNNER_ACTIONS_ENDED;
        break;
    }
}

enum { COMMAND_WORK = 8, STEP_WORK = 1 /* work per command and per expression step */ };

void bulletml_execute(struct turn *t)
{
    struct ml_runners *r = &t->b->ml_runners;
    struct work_state w = { .t = t, .r = r, .at = r->pc[t->runner] };
    int n = 0;

    w.params = &w.action_params;
    set_params(&w, r->params[t->runner]);
    while (!w.yields && !(r->flags[t->runner] & RUNNER_ACTIONS_ENDED)) {
        const uint32_t c = ml_word(t->ml, w.at);
        if ((int32_t)(t->now - r->wake_clock[t->runner]) < 0 && ML_OP(c) > ML_LAST_CONTROL)
            break;
        w.at++;
        if (++n > MAX_COMMANDS)
            bulletml_fault(t, c, "more than 100000 commands in one frame (repeat without a wait?)");
        execute_command(&w, c);
        r->work_done += 1 + w.steps;
        if (!board_charge_work(t->b, COMMAND_WORK + STEP_WORK * w.steps))
            bulletml_raise_overload(t, c);
        w.steps = 0;
    }
    r->pc[t->runner] = w.at;
}
