/*
 * bulletml_run.c - runs BulletML documents each tick: roots, runners and their bullets. bulletml_do.c executes the
 * commands.
 *
 * Runners get their turns in the order in which they were created, before bullets move. In its turn a runner reads what
 * scripts wrote to its bullet, applies the changes in progress, executes the due commands, and writes the bullet's
 * velocity. A runner that only waits costs one comparison with the clock; whether its bullet still exists is then
 * checked only every WAITING frames. A fired bullet spawns where its shooter was, after the hits; it first moves, and
 * its runner gets its first turn, in the next frame.
 *
 * A document's directions are degrees as written: 0 is up, clockwise. The root's rotation, mirroring and scale are
 * applied only when velocities are written to the board and when directions are read from it.
 */
#include <stdio.h>
#include <string.h>
#include "../base/int.h"
#include "api/api.h"
#include "bulletml_parts.h"

enum { WAITING = 16 };

static const ang UP = 0xc0000000u;
static const int64_t NOBODY = (int64_t)H_BULLET << 24; /* the handle of a bullet that does not exist */

/* ---- parameter lists ---- */

void bulletml_keep(struct board *b, uint32_t list)
{
    if (list)
        b->ml_params.users[list - 1]++;
}

void bulletml_let_list(struct board *b, uint32_t list)
{
    if (list && !--b->ml_params.users[list - 1])
        slots_drop(&b->ml_params.s, list - 1);
}

uint32_t bulletml_list(struct board *b, const int64_t *value, int n)
{
    struct ml_params *p = &b->ml_params;
    const int32_t k = slots_take(&p->s);

    if (k == NO_SLOT) {
        board_full(b, &p->s);
        return 0;
    }
    p->users[k] = 1;
    p->n[k] = (uint8_t)n;
    memset(p->value + (size_t)k * ML_VALUES, 0, ML_VALUES * sizeof *p->value);
    memcpy(p->value + (size_t)k * ML_VALUES, value, (size_t)n * sizeof *value);
    return (uint32_t)k + 1;
}

/* ---- directions ---- */

static ang to_board(const struct ml_roots *o, uint32_t root, int64_t direction)
{
    const ang a = ml_angle(direction);

    return o->turned[root] + (o->flags[root] & ROOT_MIRRORED ? 0 - a : a);
}

static int64_t from_board(const struct ml_roots *o, uint32_t root, ang dir)
{
    const ang a = dir - o->turned[root];

    return ml_degrees(o->flags[root] & ROOT_MIRRORED ? 0 - a : a);
}

int64_t bulletml_aim(const struct turn *t)
{
    const struct targets players = board_players(t->b);
    const int32_t i = targets_nearest(&players, t->x, t->y);

    if (i != NO_SLOT && players.x[i] == t->x && players.y[i] == t->y)
        return 0;
    return from_board(&t->b->ml_roots, t->root, targets_aim(&players, t->x, t->y, 0x40000000u));
}

void bulletml_fault(const struct turn *t, uint32_t w, const char *what)
{
    vm_fault(t->b->vm.running, FAULT_SCRIPT, "bulletml/%s.xml:%d: %s",
             cart_bulletml_name(&t->b->cart, t->b->ml_roots.program[t->root]), (int)ML_LINE(w), what);
}

void bulletml_too_much(const struct turn *t, uint32_t w)
{
    const struct ml_runners *r = &t->b->ml_runners;

    board_too_much(t->b,
                   "bulletml/%s.xml:%d: too much BulletML work in one frame (%u runners, %llu commands and expression "
                   "steps so far); lower `board.bulletml` in rom.lua or add waits",
                   cart_bulletml_name(&t->b->cart, t->b->ml_roots.program[t->root]), (int)ML_LINE(w), r->s.live,
                   (unsigned long long)r->ran);
}

/* ---- velocities ---- */

/* A document's polar speed and extra velocity, converted to the board: px a frame. */
struct flight {
    fx speed, vx, vy;
    int64_t fine_x, fine_y; /* vx, vy in Q31.32 */
};

/* A direction on the board, with its cosine and sine in Q30. */
struct heading {
    ang dir;
    int32_t cosine, sine;
};

static int64_t in_speed(int64_t v)
{
    const int64_t most = (int64_t)MAX_SPEED << 32;

    return int64_clamp(v, -most, most);
}

/* Converts a document's speed to px a frame, Q31.32, clamped to MAX_SPEED in both directions. */
static inline int64_t scaled(int64_t v, int64_t pace)
{
    const int64_t most = (int64_t)1 << 46;

    return in_speed(pace == ML_ONE ? v : ml_scale(int64_clamp(v, -most, most), pace, 32));
}

/* Rounds v, Q31.32 and at most MAX_SPEED, to the nearest fx. */
static inline fx nearest(int64_t v)
{
    return (fx)((v + (1 << 15)) >> 16);
}

static inline __attribute__((always_inline)) struct heading heading_of(const struct ml_roots *o, uint32_t root,
                                                                       int64_t direction)
{
    struct heading h = { .dir = to_board(o, root, direction) };
    int64_t c, s;

    trig_direction(h.dir, &c, &s);
    h.cosine = (int32_t)((c + (1 << 9)) >> 10);
    h.sine = (int32_t)((s + (1 << 9)) >> 10);
    return h;
}

/* Sets a body's direction in the document and the values derived from it: the board's direction, its cosine and
 * sine. */
static inline __attribute__((always_inline)) void head_for(struct ml_runners *r, const struct ml_roots *o,
                                                           uint32_t root, uint32_t body, int64_t direction)
{
    const struct heading h = heading_of(o, root, direction);

    r->direction[body] = direction;
    r->written_dir[body] = h.dir;
    r->cosine[body] = h.cosine;
    r->sine[body] = h.sine;
}

static inline __attribute__((always_inline)) struct flight flight(const struct ml_roots *o, uint32_t root,
                                                                  int32_t cosine, int32_t sine, int64_t speed)
{
    const int64_t v = scaled(speed, o->pace[root]);
    const int64_t x = ml_scale(v, cosine, 30), y = ml_scale(v, sine, 30);

    return (struct flight){ nearest(v), nearest(x), nearest(y), x, y };
}

/* Converts (vx, vy) from the document's units and axes to the board's and adds it to f. Only the sum is rounded. */
static void fly_beside(struct flight *f, const struct ml_roots *o, uint32_t root, int64_t vx, int64_t vy)
{
    const ang turned = o->turned[root] - UP;
    const int64_t across = scaled(vx, o->pace[root]), y = scaled(vy, o->pace[root]),
                  x = o->flags[root] & ROOT_MIRRORED ? -across : across;
    int64_t c, s, more_x = x, more_y = y;

    if (turned) {
        trig_direction(turned, &c, &s);
        more_x = ml_scale(x, c, 40) - ml_scale(y, s, 40);
        more_y = ml_scale(x, s, 40) + ml_scale(y, c, 40);
    }
    f->fine_x = in_speed(f->fine_x + more_x);
    f->fine_y = in_speed(f->fine_y + more_y);
    f->vx = nearest(f->fine_x);
    f->vy = nearest(f->fine_y);
}

/* Converts body i's speed, direction and velocity from the document's units and axes to the board's. */
static inline __attribute__((always_inline)) struct flight
flight_of(const struct ml_roots *o, const struct ml_runners *r, uint32_t root, uint32_t i)
{
    struct flight f = flight(o, root, r->cosine[i], r->sine[i], r->speed[i]);

    if (r->vx[i] | r->vy[i])
        fly_beside(&f, o, root, r->vx[i], r->vy[i]);
    return f;
}

/* ---- runners ---- */

/* Creates a runner whose turn comes last. Returns NO_SLOT if the pool is full. */
static int32_t new_runner(struct board *b, uint32_t root, int64_t bullet, uint32_t at, uint32_t wake)
{
    struct ml_runners *r = &b->ml_runners;
    const int32_t i = slots_take(&r->s);

    if (i == NO_SLOT) {
        board_full(b, &r->s);
        return i;
    }
    r->bullet[i] = bullet;
    r->serial[i] = ++r->serials;
    r->root[i] = root;
    r->body[i] = (uint32_t)i;
    r->order[r->n++] = (uint32_t)i;
    r->at[i] = at;
    r->wake[i] = wake;
    r->frame[i] = r->given[i] = 0;
    r->depth[i] = 0;
    r->flags[i] = bullet ? 0 : RUNNER_TOP;
    r->last_direction[i] = r->last_speed[i] = 0;
    r->direction[i] = r->speed[i] = r->vx[i] = r->vy[i] = 0;
    for (size_t c = (size_t)i * CHANGES; c < ((size_t)i + 1) * CHANGES; c++) {
        r->from[c] = r->to[c] = r->step[c] = 0;
        r->begun[c] = r->over[c] = 0;
    }
    r->written_dir[i] = 0;
    r->cosine[i] = r->sine[i] = 0;
    r->written_speed[i] = r->written_vx[i] = r->written_vy[i] = 0;
    b->ml_roots.runners[root]++;
    return i;
}

/* Releases a runner's frames and parameters. */
static void clear_runner(struct board *b, uint32_t i)
{
    struct ml_runners *r = &b->ml_runners;
    struct ml_frames *f = &b->ml_frames;

    while (r->frame[i]) {
        const uint32_t k = r->frame[i] - 1;
        bulletml_let_list(b, f->given[k]);
        r->frame[i] = f->up[k];
        slots_drop(&f->s, k);
    }
    bulletml_let_list(b, r->given[i]);
    r->depth[i] = 0;
    r->given[i] = 0;
}

static void drop_runner(struct board *b, uint32_t i)
{
    clear_runner(b, i);
    b->ml_roots.runners[b->ml_runners.root[i]]--;
    slots_drop(&b->ml_runners.s, i);
}

/* ---- firing ---- */

/* Creates the runner of a fired bullet, which spawns later. Returns its slot + 1, or 0 if a pool is full. */
static uint32_t equip(const struct turn *t, const struct fired *f, const struct flight *way, const struct heading *h,
                      struct given *given)
{
    struct ml_runners *r = &t->b->ml_runners;

    if (given->n && !given->list)
        given->list = bulletml_list(t->b, given->value, given->n);
    else
        bulletml_keep(t->b, given->list);
    const int32_t i = given->n && !given->list ? NO_SLOT : new_runner(t->b, t->root, NOBODY, f->at, t->now + 1);
    if (i == NO_SLOT) {
        bulletml_let_list(t->b, given->list);
        return 0;
    }
    r->given[i] = given->list;
    r->direction[i] = f->direction;
    r->speed[i] = f->speed;
    r->written_dir[i] = h->dir;
    r->cosine[i] = h->cosine;
    r->sine[i] = h->sine;
    r->written_speed[i] = way->speed;
    r->written_vx[i] = way->vx;
    r->written_vy[i] = way->vy;
    return (uint32_t)i + 1;
}

void bulletml_fire(const struct turn *t, const struct fired *f, struct given *given)
{
    const struct ml_roots *o = &t->b->ml_roots;
    const bool known = f->label && f->label <= ML_KINDS;
    struct ml_fresh *fresh = &t->b->ml_fresh;

    if (fresh->n == fresh->cap) {
        emit_refuse(t->b, false, 1);
        return;
    }
    const struct heading h = heading_of(o, t->root, f->direction);
    const struct flight way = flight(o, t->root, h.cosine, h.sine, f->speed);
    fresh->at[fresh->n++] = (struct ml_fired){
        .x = t->x,
        .y = t->y,
        .vx = way.vx,
        .vy = way.vy,
        .speed = way.speed,
        .dir = h.dir,
        .kind = known ? o->kinds[(size_t)t->root * ML_KINDS + f->label - 1] : o->kind[t->root],
        .root = t->root,
        .label = f->label,
        .runner = f->at ? equip(t, f, &way, &h, given) : 0,
    };
}

static int32_t appear(struct board *b, const struct ml_fired *f)
{
    const struct ml_roots *o = &b->ml_roots;
    struct bullet_shape s = { .x = f->x,
                              .y = f->y,
                              .speed = f->speed,
                              .dir = f->dir,
                              .kind = f->kind,
                              .bank = o->flags[f->root] & ROOT_BANK ? o->bank[f->root] : b->bullet_kinds.bank[f->kind],
                              .tag = o->tag[f->root],
                              .by = o->by[f->root] };
    const int32_t i = emit_fire(b, false, &s, 0, b->core.clock + 1);

    if (i != NO_SLOT)
        bullets_set_flight(&b->bullets, (uint32_t)i, f->vx, f->vy);
    return i;
}

void bulletml_let_go(struct board *b)
{
    struct ml_fresh *fresh = &b->ml_fresh;

    for (uint32_t k = 0; k < fresh->n; k++) {
        const struct ml_fired *f = &fresh->at[k];
        const int32_t i = appear(b, f);
        if (f->runner && i != NO_SLOT)
            b->ml_runners.bullet[f->runner - 1] = board_handle(b, H_BULLET, i);
        if (i != NO_SLOT && b->ml_roots.flags[f->root] & ROOT_TELLS)
            board_event(b, EV_FIRED, board_handle(b, H_BULLET, i), (int64_t)f->root << 32 | f->label);
    }
    vm_charge(b->vm.running, WORK_FIRE * (uint64_t)fresh->n);
    fresh->n = 0;
}

/* ---- turns ---- */

/* Returns the current value of a change in progress. */
static inline int64_t changed(const struct ml_runners *r, size_t c, int change, uint32_t now)
{
    const int64_t k = now - r->begun[c], term = r->over[c] - r->begun[c];

    if (r->step[c])
        return r->from[c] + ml_scale(r->step[c], k, change == CHANGE_DIRECTION ? 12 : 20);
    return ml_add(r->from[c], ml_multiply(ml_subtract(r->to[c], r->from[c]), ml_divide(k * ML_ONE, term * ML_ONE)));
}

/* Returns v, the current value of direction change c, wrapped to [0, 360). If wrapping alters v, shifts both ends of
 * the change by the same amount, so that they stay near the range even over many rounds. */
static inline int64_t wrap_turn(struct ml_runners *r, size_t c, int64_t v)
{
    const int64_t in = ml_wrap(v);

    if (in != v) {
        r->from[c] = ml_add(r->from[c], in - v);
        r->to[c] = ml_add(r->to[c], in - v);
    }
    return in;
}

static inline void apply_change(struct ml_runners *r, const struct turn *t, int change, int64_t *of)
{
    const size_t c = (size_t)t->runner * CHANGES + (size_t)change;
    const bool over = (int32_t)(t->now - r->over[c]) >= 0;
    const int64_t v = over ? r->to[c] : changed(r, c, change, t->now);

    if (change == CHANGE_DIRECTION)
        head_for(r, &t->b->ml_roots, t->root, t->body, wrap_turn(r, c, v));
    else
        of[t->body] = v;
    if (over)
        r->flags[t->runner] &= (uint16_t) ~(1u << change);
}

static void apply_changes(struct turn *t)
{
    struct ml_runners *r = &t->b->ml_runners;
    const unsigned flags = r->flags[t->runner];

    if (flags & 1 << CHANGE_DIRECTION)
        apply_change(r, t, CHANGE_DIRECTION, r->direction);
    if (flags & 1 << CHANGE_SPEED)
        apply_change(r, t, CHANGE_SPEED, r->speed);
    if (flags & 1 << CHANGE_X)
        apply_change(r, t, CHANGE_X, r->vx);
    if (flags & 1 << CHANGE_Y)
        apply_change(r, t, CHANGE_Y, r->vy);
    t->steers = true;
}

/* Updates the runner with what scripts wrote to its bullet since its last turn, and ends the changes in progress that
 * these writes override. */
static void read_back(const struct turn *t, uint32_t bullet)
{
    const struct bullets *s = &t->b->bullets;
    const struct ml_roots *o = &t->b->ml_roots;
    struct ml_runners *r = &t->b->ml_runners;
    const uint32_t i = t->runner;
    const bool stands = s->stands && s->stands[bullet];
    const fx vx = (stands ? s->kept_vx : s->vx)[bullet], vy = (stands ? s->kept_vy : s->vy)[bullet];

    if (s->dir[bullet] == r->written_dir[i] && s->speed[bullet] == r->written_speed[i] && vx == r->written_vx[i] &&
        vy == r->written_vy[i])
        return;
    if (s->dir[bullet] != r->written_dir[i]) {
        head_for(r, o, t->root, i, from_board(o, t->root, s->dir[bullet]));
        r->flags[i] &= (uint16_t) ~(1u << CHANGE_DIRECTION);
    }
    if (s->speed[bullet] != r->written_speed[i]) {
        r->speed[i] = ml_divide((int64_t)s->speed[bullet] * (1 << 16), o->pace[t->root]);
        r->flags[i] &= (uint16_t) ~(1u << CHANGE_SPEED);
    }
    r->vx[i] = r->vy[i] = 0;
    r->flags[i] &= (uint16_t) ~(1u << CHANGE_X | 1u << CHANGE_Y);
    r->written_speed[i] = s->speed[bullet];
    r->written_vx[i] = vx;
    r->written_vy[i] = vy;
}

/* Applies the changes in progress, then executes the due commands. */
static void run_one(struct turn *t)
{
    struct ml_runners *r = &t->b->ml_runners;
    const uint32_t i = t->runner;

    if (r->flags[i] & RUNNER_CHANGES)
        apply_changes(t);
    if ((int32_t)(t->now - r->wake[i]) < 0)
        return;
    if (!(r->flags[i] & RUNNER_OVER))
        bulletml_do(t);
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
    bullets_set_flight(s, bullet, f.vx, f.vy);
}

/* Delays runner i by a frame, because its bullet is frozen. */
static void stay(struct ml_runners *r, uint32_t i)
{
    r->wake[i]++;
    for (size_t c = (size_t)i * CHANGES; c < ((size_t)i + 1) * CHANGES; c++) {
        r->begun[c]++;
        r->over[c]++;
    }
}

/* Runs the turn of a bullet's runner. Returns false if the runner is to be dropped. */
static bool run_bullet(struct turn *t)
{
    struct board *b = t->b;
    struct ml_runners *r = &b->ml_runners;
    const uint32_t i = t->runner, bullet = handle_slot(r->bullet[i]);

    if (!slots_has(&b->bullets.s, bullet, handle_gen(r->bullet[i])) || b->bullets.motion[bullet])
        return false;
    /* With `frozen` 0 the bullet resumes in this frame's move. */
    if (b->bullets.stands && b->bullets.stands[bullet] && b->bullets.frozen[bullet]) {
        stay(r, i);
        return true;
    }
    if ((int32_t)(t->now - r->wake[i]) < 0 && !(r->flags[i] & RUNNER_CHANGES))
        return true;
    t->x = b->bullets.x[bullet];
    t->y = b->bullets.y[bullet];
    read_back(t, bullet);
    run_one(t);
    if (t->vanishes) {
        bullets_drop(&b->bullets, bullet);
        return false;
    }
    if (t->steers)
        steer_bullet(t, bullet);
    return !(r->flags[i] & RUNNER_OVER) || r->flags[i] & RUNNER_CHANGES;
}

/* Sets *v to the current value of change c. Returns false if the change ends in this frame or has no step. */
static inline bool goes_on(const struct ml_runners *r, size_t c, int shift, uint32_t now, int64_t *v)
{
    if ((int32_t)(now - r->over[c]) >= 0 || !r->step[c])
        return false;
    *v = r->from[c] + ml_scale(r->step[c], now - r->begun[c], shift);
    return true;
}

/* Returns whether runner i's bullet, in slot k, still exists and has the speed and direction that the runner last
 * set. */
static inline bool untouched(const struct ml_runners *r, const struct bullets *s, uint32_t i, uint32_t k)
{
    return slots_has(&s->s, k, handle_gen(r->bullet[i])) && !s->motion[k] &&
           !((s->dir[k] ^ r->written_dir[i]) | (ang)(s->speed[k] ^ r->written_speed[i]) |
             (ang)(s->vx[k] ^ r->written_vx[i]) | (ang)(s->vy[k] ^ r->written_vy[i]));
}

/*
 * The fast path for the most common turn: a bullet's runner with no command due and only changes in progress. Returns
 * false, with nothing changed, for any other turn.
 */
static inline bool glide(struct board *b, uint32_t i, uint32_t now)
{
    struct ml_runners *r = &b->ml_runners;
    const struct ml_roots *o = &b->ml_roots;
    struct bullets *s = &b->bullets;
    const unsigned flags = r->flags[i];
    const uint32_t k = handle_slot(r->bullet[i]), root = r->root[i];
    const size_t c = (size_t)i * CHANGES;
    int64_t direction = 0, speed = r->speed[i], vx = r->vx[i], vy = r->vy[i];

    if (flags & RUNNER_TOP || s->stands || !untouched(r, s, i, k))
        return false;
    if ((flags & 1 << CHANGE_DIRECTION && !goes_on(r, c + CHANGE_DIRECTION, 12, now, &direction)) ||
        (flags & 1 << CHANGE_SPEED && !goes_on(r, c + CHANGE_SPEED, 20, now, &speed)) ||
        (flags & 1 << CHANGE_X && !goes_on(r, c + CHANGE_X, 20, now, &vx)) ||
        (flags & 1 << CHANGE_Y && !goes_on(r, c + CHANGE_Y, 20, now, &vy)))
        return false;
    if (flags & 1 << CHANGE_DIRECTION)
        head_for(r, o, root, i, wrap_turn(r, c + CHANGE_DIRECTION, direction));
    r->speed[i] = speed;
    r->vx[i] = vx;
    r->vy[i] = vy;
    const struct flight f = flight_of(o, r, root, i);
    const fx fast = fx_max(fx_abs(f.vx), fx_abs(f.vy));
    s->dir[k] = r->written_dir[i];
    s->speed[k] = r->written_speed[i] = f.speed;
    s->vx[k] = r->written_vx[i] = f.vx;
    s->vy[k] = r->written_vy[i] = f.vy;
    if (fast > s->fastest)
        s->fastest = fast;
    return true;
}

/* Charges the work of scanning all runners for those of one root. */
static void count_search(struct board *b)
{
    const struct ml_runners *r = &b->ml_runners;

    if (!board_work(b, r->n / 2))
        board_too_much(b,
                       "bulletml: too much work in one frame (%u documents, %u runners); lower `board.bulletml` in "
                       "rom.lua or run fewer documents at once",
                       b->ml_roots.s.live, r->n);
}

/* Restarts all top-level runners of a root. */
static void restart(struct board *b, uint32_t root, const struct ml *ml, uint32_t now)
{
    struct ml_runners *r = &b->ml_runners;
    uint32_t top = 0;

    count_search(b);
    for (uint32_t k = 0; k < r->n && top < ml->tops; k++) {
        const uint32_t i = r->order[k];
        if (r->root[i] != root || !(r->flags[i] & RUNNER_TOP))
            continue;
        clear_runner(b, i);
        r->flags[i] = RUNNER_TOP;
        r->at[i] = ml_top(ml, top++);
        r->wake[i] = now;
        r->given[i] = b->ml_roots.given[root];
        bulletml_keep(b, r->given[i]);
        memset(&r->from[(size_t)i * CHANGES], 0, CHANGES * sizeof *r->from);
    }
    b->ml_roots.flags[root] &= (uint8_t)~ROOT_ENDED;
}

/* Runs the turn of one of a root's top-level runners. Returns false if the root is over. */
static bool run_top(struct turn *t)
{
    struct board *b = t->b;
    struct ml_roots *o = &b->ml_roots;
    struct ml_runners *r = &b->ml_runners;
    const uint32_t i = t->runner;

    if (o->flags[t->root] & ROOT_OVER)
        return false;
    if (i == o->body[t->root] && o->flags[t->root] & ROOT_ENDED && o->flags[t->root] & ROOT_LOOPS)
        restart(b, t->root, t->ml, t->now);
    t->x = o->x[t->root];
    t->y = o->y[t->root];
    if (!(r->flags[i] & RUNNER_ENDED))
        run_one(t);
    if (r->flags[i] & RUNNER_ENDED)
        o->flags[t->root] |= ROOT_ENDED;
    if (t->vanishes)
        o->flags[t->root] |= ROOT_VANISHES;
    return true;
}

/* ---- roots ---- */

void bulletml_stop(struct board *b, uint32_t i)
{
    b->ml_roots.flags[i] |= ROOT_OVER;
}

static const char handlers_key = 0; /* registry: slot + 1 -> on_fire */

void bulletml_set_handler(lua_State *L, uint32_t i)
{
    if (lua_rawgetp(L, LUA_REGISTRYINDEX, &handlers_key) != LUA_TTABLE) {
        lua_pop(L, 1);
        lua_newtable(L);
        lua_pushvalue(L, -1);
        lua_rawsetp(L, LUA_REGISTRYINDEX, &handlers_key);
    }
    lua_insert(L, -2);
    lua_rawseti(L, -2, (lua_Integer)i + 1);
    lua_pop(L, 1);
}

void bulletml_tell(lua_State *L, struct board *b, int64_t bullet, uint32_t i, uint32_t label)
{
    struct ml ml;

    cart_bulletml(&b->cart, b->ml_roots.program[i], &ml);
    lua_rawgetp(L, LUA_REGISTRYINDEX, &handlers_key);
    lua_rawgeti(L, -1, (lua_Integer)i + 1);
    lua_pushinteger(L, bullet);
    if (label)
        lua_pushstring(L, ml_label(&ml, label - 1));
    else
        lua_pushnil(L);
    lua_call(L, 2, 0);
    lua_pop(L, 1);
}

static void drop_root(struct board *b, uint32_t i)
{
    if (b->ml_roots.flags[i] & ROOT_TELLS) {
        lua_pushnil(b->vm.running);
        bulletml_set_handler(b->vm.running, i);
    }
    bulletml_let_list(b, b->ml_roots.given[i]);
    slots_drop(&b->ml_roots.s, i);
}

static fx in_world(int64_t v)
{
    return (fx)int64_clamp(v, -WORLD * FX_ONE, WORLD * FX_ONE);
}

/* Moves a root to its offset from the entity it follows. */
static void find_place(struct board *b, uint32_t i)
{
    struct ml_roots *o = &b->ml_roots;
    fx x = 0, y = 0;

    board_where(b, o->follow[i], &x, &y);
    o->x[i] = in_world((int64_t)x + o->dx[i]);
    o->y[i] = in_world((int64_t)y + o->dy[i]);
}

/* Called before the turns. Ends roots whose owner or followed entity no longer exists, moves roots that follow an
 * entity, and drops ended roots that have no runners left (top-level or of bullets). */
static void find_roots(struct board *b)
{
    struct ml_roots *o = &b->ml_roots;

    EACH_LIVE (i, &o->s) {
        if (o->flags[i] & ROOT_OVER && !o->runners[i])
            drop_root(b, i);
        else if (!tasks_owner_alive(b, o->owner[i]) || (o->follow[i] && !board_alive(b, o->follow[i])))
            bulletml_stop(b, i);
        else if (o->follow[i])
            find_place(b, i);
    }
}

/* Moves a coordinate by `by`, Q31.32; *more holds 16 more fraction bits of the coordinate. The precision matters
 * because some documents move a root during the whole game and aim from it. */
static void move_fine(fx *at, int16_t *more, int64_t by)
{
    const int64_t most = (int64_t)WORLD << 32;
    const int64_t to = int64_clamp((int64_t)*at * (1 << 16) + *more + by, -most, most), whole = (to + (1 << 15)) >> 16;

    *more = (int16_t)(to - whole * (1 << 16));
    *at = (fx)whole;
}

/* Moves a root by its own velocity, together with the enemy it steers, if any. */
static void move_root(struct board *b, uint32_t i)
{
    struct ml_roots *o = &b->ml_roots;
    const struct ml_runners *r = &b->ml_runners;
    const uint32_t k = o->body[i];

    if (o->follow[i] && !(o->flags[i] & ROOT_STEERS))
        return;
    if (!(r->speed[k] | r->vx[k] | r->vy[k]))
        return;
    const int64_t v = scaled(r->speed[k], o->pace[i]);
    struct flight f = { .fine_x = ml_scale(v, trig_cos30(r->written_dir[k]), 30),
                        .fine_y = ml_scale(v, trig_sin30(r->written_dir[k]), 30) };
    fly_beside(&f, o, i, r->vx[k], r->vy[k]);
    move_fine(&o->x[i], &o->x_more[i], f.fine_x);
    move_fine(&o->y[i], &o->y_more[i], f.fine_y);
    if (o->follow[i]) {
        b->enemies.x[handle_slot(o->follow[i])] = in_world((int64_t)o->x[i] - o->dx[i]);
        b->enemies.y[handle_slot(o->follow[i])] = in_world((int64_t)o->y[i] - o->dy[i]);
    }
}

/* Returns whether all top-level runners of a root have ended. */
static bool all_ended(struct board *b, uint32_t root)
{
    const struct ml_runners *r = &b->ml_runners;

    count_search(b);
    for (uint32_t k = 0; k < r->n; k++)
        if (r->root[r->order[k]] == root && (r->flags[r->order[k]] & (RUNNER_TOP | RUNNER_ENDED)) == RUNNER_TOP)
            return false;
    return true;
}

/* Called after the turns. Ends roots that vanished or have finished, and moves the others. */
static void end_roots(struct board *b)
{
    struct ml_roots *o = &b->ml_roots;

    EACH_LIVE (i, &o->s) {
        if (o->flags[i] & ROOT_VANISHES)
            bulletml_stop(b, i);
        else if (!(o->flags[i] & ROOT_OVER))
            move_root(b, i);
        if (o->flags[i] & ROOT_ENDED && !(o->flags[i] & (ROOT_LOOPS | ROOT_OVER)) && all_ended(b, i))
            bulletml_stop(b, i);
    }
    slots_trim(&o->s);
}

/* The document opened for the previous runner's turn; the next runner usually has the same one. */
struct opened {
    uint32_t program; /* UINT32_MAX: none */
    struct ml ml;
};

/* Runs one turn. Returns false if the runner is to be dropped. */
static bool run_turn(struct board *b, uint32_t i, uint32_t now, struct opened *o)
{
    struct turn t = {
        .b = b, .ml = &o->ml, .runner = i, .root = b->ml_runners.root[i], .body = b->ml_runners.body[i], .now = now
    };

    if (o->program != b->ml_roots.program[t.root]) {
        o->program = b->ml_roots.program[t.root];
        cart_bulletml(&b->cart, (int)o->program, &o->ml);
    }
    return b->ml_runners.flags[i] & RUNNER_TOP ? run_top(&t) : run_bullet(&t);
}

void bulletml_run(struct board *b)
{
    struct ml_runners *r = &b->ml_runners;
    const uint32_t now = b->core.clock, n = r->n;
    const bool some_stand = b->bullets.stands;
    struct opened opened = { .program = UINT32_MAX };
    uint32_t kept = 0;

    b->ml_fresh.n = 0;
    r->ran = 0;
    find_roots(b);
    for (uint32_t k = 0; k < n; k++) {
        const uint32_t i = r->order[k];
        const bool due = (int32_t)(now - r->wake[i]) >= 0 && !(r->flags[i] & RUNNER_OVER);
        const bool waits = !due && !(r->flags[i] & (RUNNER_CHANGES | RUNNER_TOP)) && !some_stand && (k + now) % WAITING;
        if (waits || (!due && glide(b, i, now)) || run_turn(b, i, now, &opened))
            r->order[kept++] = i;
        else
            drop_runner(b, i);
    }
    memmove(r->order + kept, r->order + n, (r->n - n) * sizeof *r->order);
    r->n -= n - kept;
    end_roots(b);
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
    if (!ml.tops)
        return NO_SLOT;
    const int32_t i = slots_take(&o->s);
    if (i == NO_SLOT) {
        board_full(b, &o->s);
        return i;
    }
    o->owner[i] = start->owner;
    o->follow[i] = start->follow;
    o->x[i] = start->x;
    o->y[i] = start->y;
    o->x_more[i] = o->y_more[i] = 0;
    o->dx[i] = start->dx;
    o->dy[i] = start->dy;
    o->program[i] = start->program;
    o->kind[i] = start->kind;
    o->tag[i] = start->tag;
    memcpy(o->kinds + (size_t)i * ML_KINDS, start->kinds, ML_KINDS * sizeof *o->kinds);
    o->bank[i] = start->bank;
    o->flags[i] = start->flags;
    o->runners[i] = 0;
    o->by[i] = tasks_serial(b);
    o->stream[i] = start->seed;
    o->given[i] = start->params ? bulletml_list(b, start->param, start->params) : 0;
    o->rank[i] = start->rank;
    o->pace[i] = start->pace;
    o->turned[i] = UP + start->angle;
    for (uint32_t top = 0; top < ml.tops; top++) {
        const int32_t k = new_runner(b, (uint32_t)i, 0, ml_top(&ml, top), b->core.clock);
        if (k == NO_SLOT) {
            bulletml_stop(b, (uint32_t)i);
            return NO_SLOT;
        }
        if (!top) {
            o->body[i] = (uint32_t)k;
            head_for(r, o, (uint32_t)i, (uint32_t)k, 180 * ML_ONE);
        }
        r->body[k] = o->body[i];
        r->given[k] = o->given[i];
        bulletml_keep(b, o->given[i]);
    }
    return i;
}
