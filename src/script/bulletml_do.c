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
struct shot {
    bool sped, turned;
    int64_t speed, direction;
    uint32_t after_fire, after_bullet; /* program positions; 0: inline, nowhere to return to */
};

/* The working state of one turn. */
struct work {
    struct turn *t;
    struct ml_runners *r;
    uint32_t at;
    struct shot shot;
    struct given own, fire, bullet; /* parameters of the action, the fireRef and the bulletRef */
    struct given *given;            /* the parameters that expressions use now: own, fire or bullet */
    int64_t fire_value[ML_PARAMS], bullet_value[ML_PARAMS];
    bool yields;    /* the remaining commands run in the next frame */
    uint64_t steps; /* expression steps not charged yet */
};

static uint32_t next_word(struct work *w)
{
    return ml_word(w->t->ml, w->at++);
}

static int64_t param(const struct given *g, uint32_t i)
{
    if (i == 0)
        return g->n ? 0 : ML_ONE;
    return i <= (uint32_t)g->n ? g->value[i - 1] : ML_ONE;
}

/* Evaluates the expression whose steps start at `at`. */
static int64_t work_out(struct work *w, uint32_t at)
{
    struct ml_roots *o = &w->t->b->ml_roots;
    int64_t stack[ML_STACK + 1], *top = stack; /* top: the topmost number; stack[0] is unused */
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
            *++top = param(w->given, argument);
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

static int64_t value(struct work *w, uint32_t v)
{
    return v & ML_WORKED_OUT ? work_out(w, v & ~ML_WORKED_OUT) : ml_number(w->t->ml, v);
}

static int64_t next_value(struct work *w)
{
    return value(w, next_word(w));
}

/* Evaluates n values and stores the first ML_PARAMS of them. Returns how many it stored. */
static int next_values(struct work *w, uint32_t n, int64_t out[ML_PARAMS])
{
    for (uint32_t i = 0; i < n; i++) {
        const int64_t v = next_value(w);
        if (i < ML_PARAMS)
            out[i] = v;
    }
    return (int)(n < ML_PARAMS ? n : ML_PARAMS);
}

/* Resolves a direction to degrees in [0, 360]; a positive multiple of 360 becomes 360, not 0. */
static int64_t resolve_direction(const struct work *w, enum ml_type type, int64_t v)
{
    struct ml_runners *r = w->r;
    const uint32_t i = w->t->runner;

    if (type == ML_ABSOLUTE)
        v = w->t->ml->horizontal ? ml_subtract(v, 90 * ML_ONE) : v;
    else if (type == ML_RELATIVE)
        v = ml_add(v, r->direction[w->t->body]);
    else if (type == ML_SEQUENCE)
        v = r->flags[i] & RUNNER_TURNED ? ml_add(v, r->last_direction[i]) : bulletml_aim(w->t);
    else
        v = ml_add(v, bulletml_aim(w->t));
    if (v < 0 || v > ML_TURN_ROUND) {
        const bool over = v > 0;
        v = ml_wrap(v);
        v = over && v == 0 ? ML_TURN_ROUND : v;
    }
    r->last_direction[i] = v;
    r->flags[i] |= RUNNER_TURNED;
    return v;
}

static int64_t resolve_speed(const struct work *w, enum ml_type type, int64_t v)
{
    struct ml_runners *r = w->r;
    const uint32_t i = w->t->runner;

    if (type == ML_RELATIVE)
        v = ml_add(v, r->speed[w->t->body]);
    else if (type == ML_SEQUENCE)
        v = r->flags[i] & RUNNER_SPED ? ml_add(v, r->last_speed[i]) : ML_ONE;
    r->last_speed[i] = v;
    r->flags[i] |= RUNNER_SPED;
    return v;
}

/* Starts a timed change from `from` to `to` that takes `term` frames, at least 1. each: the change per frame, or 0 to
 * divide the difference by `term`. */
static void begin_change(const struct work *w, int change, int64_t from, int64_t to, int32_t term, int64_t each)
{
    struct ml_runners *r = w->r;
    const uint32_t i = w->t->runner;
    const size_t c = (size_t)i * CHANGES + (size_t)change;
    const int64_t one = bulletml_fine(change), most = ((int64_t)1 << 62) / one, way = ml_subtract(to, from);
    const uint32_t frames = term > LONGEST ? LONGEST : term > 1 ? (uint32_t)term : 1;

    r->from[c] = from;
    r->to[c] = to;
    r->step[c] = way > -most && way < most ? way * one / (int64_t)frames : 0;
    if (each && each > -most && each < most)
        r->step[c] = each * one;
    r->begun[c] = r->wake[i];
    r->over[c] = r->wake[i] + frames;
    r->flags[i] |= (uint16_t)(1u << change);
}

/* Starts a change of direction. A sequence turns by its value per frame. Other types turn the shorter way round; for
 * exactly half a turn, the side is opposite in sign to the plain difference. */
static void turn(struct work *w, enum ml_type type)
{
    const int32_t term = ml_whole(next_value(w));
    const int64_t v = next_value(w), now = w->r->direction[w->t->body];

    if (type == ML_SEQUENCE) {
        begin_change(w, CHANGE_DIRECTION, now, ml_add(now, ml_multiply(v, term * ML_ONE)), term, term > 1 ? v : 0);
        return;
    }
    const int64_t way = resolve_direction(w, type, v) - now,
                  other = way > 0 ? way - ML_TURN_ROUND : way + ML_TURN_ROUND;
    begin_change(w, CHANGE_DIRECTION, now, now + (int64_abs(way) < int64_abs(other) ? way : other), term, 0);
}

static void change_speed(struct work *w, enum ml_type type)
{
    const int32_t term = ml_whole(next_value(w));
    const int64_t v = next_value(w), now = w->r->speed[w->t->body];

    begin_change(w, CHANGE_SPEED, now,
                 type == ML_SEQUENCE ? ml_add(now, ml_multiply(v, term * ML_ONE)) : resolve_speed(w, type, v), term, 0);
}

static void accelerate(struct work *w, int change, enum ml_type type, int32_t term, int64_t v)
{
    const int64_t now = (change == CHANGE_X ? w->r->vx : w->r->vy)[w->t->body];

    if (type == ML_SEQUENCE)
        v = ml_multiply(v, term * ML_ONE);
    begin_change(w, change, now, type == ML_SEQUENCE || type == ML_RELATIVE ? ml_add(now, v) : v, term, 0);
}

static void accel(struct work *w, uint32_t types)
{
    const uint32_t x = types % ML_TYPE_Y, y = types / ML_TYPE_Y;
    const int32_t term = ml_whole(next_value(w));

    for (int change = CHANGE_X; change <= CHANGE_Y; change++) {
        const uint32_t type = change == CHANGE_X ? x : y, v = next_word(w);
        if (type != ML_NONE)
            accelerate(w, change, (enum ml_type)type, term, value(w, v));
    }
}

/* ---- repeats and calls ---- */

/* Pushes a new innermost call frame. If the pool is full, ends the runner's actions and returns false. */
static bool push(struct work *w, uint32_t command, int32_t left, uint32_t back, uint32_t given)
{
    struct ml_frames *f = &w->t->b->ml_frames;
    const uint32_t i = w->t->runner;

    if (w->r->depth[i] == MOST_DEPTH)
        bulletml_fault(w->t, command, "repeats and calls nested more than 4096 deep");
    const int32_t k = slots_take(&f->s);
    if (k == NO_SLOT) {
        board_full(w->t->b, &f->s);
        w->r->flags[i] |= RUNNER_OVER;
        return false;
    }
    f->up[k] = w->r->frame[i];
    f->back[k] = back;
    f->given[k] = given;
    f->left[k] = left;
    w->r->frame[i] = (uint32_t)k + 1;
    w->r->depth[i]++;
    return true;
}

static void pop(struct work *w)
{
    struct ml_frames *f = &w->t->b->ml_frames;
    const uint32_t i = w->t->runner, k = w->r->frame[i] - 1;

    w->r->frame[i] = f->up[k];
    w->r->depth[i]--;
    slots_drop(&f->s, k);
}

/* Makes `list` (slot + 1; 0: none) the runner's own parameters. Takes over the caller's reference to the list. */
static void set_given(struct work *w, uint32_t list)
{
    const struct ml_params *p = &w->t->b->ml_params;

    w->r->given[w->t->runner] = list;
    w->own = (struct given){ list ? p->n[list - 1] : 0, list ? p->value + (size_t)(list - 1) * ML_VALUES : NULL, list };
}

/* Evaluates the n parameters of a call and sets *list to a new list of them (slot + 1; 0: no parameters). If the pool
 * is full, ends the runner's actions and returns false. */
static bool call_list(struct work *w, uint32_t n, uint32_t *list)
{
    int64_t out[ML_PARAMS];
    const int k = next_values(w, n, out);

    *list = k ? bulletml_list(w->t->b, out, k) : 0;
    if (k && !*list)
        w->r->flags[w->t->runner] |= RUNNER_OVER;
    return !k || *list;
}

static void call(struct work *w, uint32_t command)
{
    const uint32_t i = w->t->runner, to = next_word(w), n = next_word(w), was = w->r->given[i];
    uint32_t list;

    if (!call_list(w, n, &list))
        return;
    if (ML_OP(command) == ML_CALL) {
        if (!push(w, command, 0, w->at, was)) {
            bulletml_let_list(w->t->b, list);
            return;
        }
    } else
        bulletml_let_list(w->t->b, was);
    while (ML_OP(command) == ML_LEAVE && w->r->frame[i]) {
        bulletml_let_list(w->t->b, w->t->b->ml_frames.given[w->r->frame[i] - 1]);
        pop(w);
    }
    set_given(w, list);
    w->at = to;
}

static void go_back(struct work *w)
{
    const struct ml_frames *f = &w->t->b->ml_frames;
    const uint32_t frame = w->r->frame[w->t->runner];

    if (!frame) {
        w->r->flags[w->t->runner] |= RUNNER_OVER;
        return;
    }
    w->at = f->back[frame - 1];
    bulletml_let_list(w->t->b, w->r->given[w->t->runner]);
    set_given(w, f->given[frame - 1]);
    pop(w);
}

static void repeat(struct work *w, uint32_t command)
{
    const int32_t times = ml_whole(next_value(w));

    push(w, command, times, 0, 0);
}

static void again(struct work *w)
{
    const struct ml_frames *f = &w->t->b->ml_frames;
    const uint32_t frame = w->r->frame[w->t->runner], to = next_word(w);

    if (frame && --f->left[frame - 1] > 0)
        w->at = to;
    else if (frame)
        pop(w);
}

/* ---- fires ---- */

static void fire_ref(struct work *w)
{
    const uint32_t to = next_word(w), n = next_word(w);

    w->fire = (struct given){ next_values(w, n, w->fire_value), w->fire_value, 0 };
    w->shot.after_fire = w->at;
    w->given = &w->fire;
    w->at = to;
}

static void bullet_ref(struct work *w)
{
    const uint32_t to = next_word(w), n = next_word(w);

    w->bullet = (struct given){ next_values(w, n, w->bullet_value), w->bullet_value, 0 };
    w->shot.after_bullet = w->at;
    w->given = &w->bullet;
    w->at = to;
}

static void fire(struct work *w)
{
    w->shot.sped = w->shot.turned = false;
}

/* Fires the bullet. Unset speed and direction get their defaults: speed 1, aimed at the player. */
static void bullet(struct work *w)
{
    struct shot *s = &w->shot;
    const uint32_t label = next_word(w), at = next_word(w);

    if (!s->sped)
        s->speed = resolve_speed(w, ML_ABSOLUTE, ML_ONE);
    if (!s->turned)
        s->direction = resolve_direction(w, ML_AIM, 0);
    const struct fired f = { ml_wrap(s->direction), s->speed, label, at };
    bulletml_fire(w->t, &f, w->given);
    if (s->after_bullet) {
        w->at = s->after_bullet;
        s->after_bullet = 0;
        w->given = s->after_fire ? &w->fire : &w->own;
    }
}

static void fired(struct work *w)
{
    if (w->shot.after_fire) {
        w->at = w->shot.after_fire;
        w->shot.after_fire = 0;
        w->given = &w->own;
    }
}

static void wait_for(struct work *w)
{
    const int32_t n = ml_whole(next_value(w));

    if (n > 0)
        w->r->wake[w->t->runner] += (uint32_t)(n > LONGEST ? LONGEST : n);
}

static void command(struct work *w, uint32_t c)
{
    const enum ml_type type = (enum ml_type)(ML_TYPE(c) % ML_TYPE_Y);

    switch ((enum ml_op)ML_OP(c)) {
    case ML_NEXT:
        w->yields = true;
        break;
    case ML_WAIT:
        wait_for(w);
        break;
    case ML_REPEAT:
        repeat(w, c);
        break;
    case ML_AGAIN:
        again(w);
        break;
    case ML_CALL:
    case ML_GO:
    case ML_LEAVE:
        call(w, c);
        break;
    case ML_RETURN:
        go_back(w);
        break;
    case ML_FIRE:
        fire(w);
        break;
    case ML_FIRE_REF:
        fire_ref(w);
        break;
    case ML_FIRED:
        fired(w);
        break;
    case ML_SHOT_SPEED:
        w->shot.speed = resolve_speed(w, type, next_value(w));
        w->shot.sped = true;
        break;
    case ML_SHOT_DIRECTION:
        w->shot.direction = resolve_direction(w, type, next_value(w));
        w->shot.turned = true;
        break;
    case ML_BULLET_REF:
        bullet_ref(w);
        break;
    case ML_BULLET:
        bullet(w);
        break;
    case ML_VANISH:
        w->t->vanishes = true;
        break;
    case ML_TURN:
        turn(w, type);
        break;
    case ML_SPEED:
        change_speed(w, type);
        break;
    case ML_ACCEL:
        accel(w, ML_TYPE(c));
        break;
    default: /* ML_END */
        w->r->flags[w->t->runner] |= RUNNER_OVER;
        break;
    }
}

enum { A_COMMAND = 8, A_STEP = 1 /* work per command and per expression step */ };

/* Charges for the executed command c and its expression steps. */
static void count(struct work *w, uint32_t c)
{
    struct ml_runners *r = w->r;

    r->ran += 1 + w->steps;
    if (!board_work(w->t->b, A_COMMAND + A_STEP * w->steps))
        bulletml_too_much(w->t, c);
    w->steps = 0;
}

void bulletml_do(struct turn *t)
{
    struct ml_runners *r = &t->b->ml_runners;
    struct work w = { .t = t, .r = r, .at = r->at[t->runner] };
    int n = 0;

    w.given = &w.own;
    set_given(&w, r->given[t->runner]);
    while (!w.yields && !(r->flags[t->runner] & RUNNER_OVER)) {
        const uint32_t c = ml_word(t->ml, w.at);
        if ((int32_t)(t->now - r->wake[t->runner]) < 0 && ML_OP(c) > ML_ENDS)
            break;
        w.at++;
        if (++n > MOST_COMMANDS)
            bulletml_fault(t, c, "more than 100000 commands in one frame (repeat without a wait?)");
        command(&w, c);
        count(&w, c);
    }
    r->at[t->runner] = w.at;
}
