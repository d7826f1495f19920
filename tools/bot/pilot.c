/*
 * pilot.c - see bot.h.
 *
 * As `curtain survive` does where bullets depend on the ship: some frames are foreseen with ships that nothing hits, a
 * way is looked for in sets of cells, flown, and foreseen anew where bullets went elsewhere because of it. Two ships
 * plan in turn, each with what the other means to press. Of what was survived the first part is kept. In a dead end it
 * goes back, further each time, and prefers other ways; then it tries the special button and bombs where it went back
 * to; and when nothing helps it is hit.
 */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "../../src/machine/machine.h"
#include "../../src/workbench/survive/plan.h"
#include "bot.h"

enum {
    AHEAD = 96,         /* frames of a piece */
    LEAST = 8,          /* a way that is shorter is a dead end */
    TURNS = 3,          /* times a piece is foreseen anew */
    PLACES = 40,        /* to go back to */
    WAYS = 1 << 15,     /* a plan may look at */
    GO_BACK = 7,        /* dead ends without getting on, until buttons are tried */
    GIVE_UP = 22,       /* and until it is hit */
    CROWDED = 70,       /* bullets at once: is the special button worth it? */
    SPECIAL_EVERY = 240 /* frames */
};

struct mark {
    struct simulation_state mark;
    uint32_t frame;
};

/* A way of both ships through a piece. */
struct way {
    uint16_t pads[AHEAD][MAX_PLAYERS];
    uint32_t n;
    int64_t score;
};

struct work {
    struct pilot *p;
    struct simulation *t;
    struct mark place[PLACES];
    int places;
    struct forecast forecast;
    uint16_t guess[AHEAD][MAX_PLAYERS];
    bool eager; /* to be under what can be shot */
    uint32_t taste, back, tried, furthest, special;
};

static bool steers(const struct board *b, int p)
{
    struct danger_ship ship;

    danger_get_ship(b, p, &ship);
    return ship.in_game && ship.can_steer;
}

static int64_t score(const struct board *b)
{
    return b->player.score[0] + b->player.score[1];
}

/* Was one of them hit in the last tick? */
static bool was_hit(const struct board *b)
{
    const struct board_out *out = board_last_output(b);

    for (int i = 0; i < out->marker_count; i++)
        if (out->marker[i].kind == MARKER_DEATH)
            return true;
    return b->player.deathbomb_left[0] || b->player.deathbomb_left[1];
}

/* Of a player that is not steered: through talks, and menus. */
static uint16_t press(const struct work *w, int p)
{
    const struct board *b = w->t->b;
    const uint32_t frame = board_frame(b);

    if (b->player.in_game[p] && !b->core.frozen) /* it is talked; start would pause that */
        return frame % 75 == 60 ? PAD_FIRE : 0;
    if (w->p->lose) /* start would go on */
        return frame % 75 == 60 ? PAD_FIRE : 0;
    return frame % 75 == 60 ? PAD_FIRE : frame % 75 == 20 ? PAD_START : 0;
}

/* What both press in a frame of a piece: `steer`, with fire; extra buttons in its first two frames. */
static void held(const struct work *w, const uint16_t steer[MAX_PLAYERS], uint16_t extra, uint16_t pads[MAX_PLAYERS])
{
    const struct board *b = w->t->b;

    for (int p = 0; p < MAX_PLAYERS; p++) {
        pads[p] = steers(b, p) ? (uint16_t)(steer[p] | PAD_FIRE | extra) : press(w, p);
        if (p && !b->player.in_game[1] && !b->core.frozen)
            pads[p] = 0;
    }
}

static uint16_t extra_at(uint16_t extra, uint32_t f)
{
    return f < 2 ? extra : 0;
}

static void foresee(struct work *w, uint32_t frames, uint16_t extra)
{
    static const uint16_t none[MAX_PLAYERS];
    enum simulation_end end = SIMULATION_RUNNING;
    uint16_t pads[MAX_PLAYERS];

    forecast_clear(&w->forecast, board_frame(w->t->b));
    w->t->recording = &w->forecast;
    danger_set_invincible(w->t->b, true);
    for (uint32_t f = 0; f < frames && end != SIMULATION_FAULT && !w->forecast.full; f++) {
        held(w, f < AHEAD ? w->guess[f] : none, extra_at(extra, f), pads);
        end = simulation_tick(w->t, pads);
    }
    w->t->recording = NULL;
}

/* A plan for player p, into the guess. */
static void plan_for(struct work *w, int p, const struct simulation_state *at, uint32_t frames, uint16_t extra)
{
    struct danger_ship ship;
    struct reach r = { 0 };
    struct plan plan = { 0 };

    w->t->player = p;
    simulation_restore(w->t, at);
    danger_get_ship(w->t->b, p, &ship);
    w->t->ship = ship;
    foresee(w, frames, extra);
    for (uint32_t f = 0; f < AHEAD; f++)
        w->guess[f][p] = 0;
    if (reach_compute(&r, &w->forecast, 2 * FX_ONE, 0, ship.path.x, ship.path.y)) {
        reach_prune(&r);
        plan_make(&plan, &r, ship.path.x, ship.path.y, WAYS, w->taste, w->eager ? 2 : 1);
        for (uint32_t f = 0; f < plan.frames && f < AHEAD; f++)
            w->guess[f][p] = plan.pads[f];
    }
    plan_free(&plan);
    reach_free(&r);
    w->t->player = 0;
}

/* Flies the guess, as far as nobody is hit. */
static void fly(struct work *w, const struct simulation_state *at, uint32_t frames, uint16_t extra, struct way *out)
{
    simulation_restore(w->t, at);
    for (out->n = 0; out->n < frames; out->n++) {
        held(w, w->guess[out->n], extra_at(extra, out->n), out->pads[out->n]);
        const enum simulation_end end = simulation_tick(w->t, out->pads[out->n]);
        if (end == SIMULATION_FAULT)
            bot_fail(board_last_output(w->t->b)->fault->message);
        if (was_hit(w->t->b))
            return;
    }
    out->score = score(w->t->b);
}

/* The best way that some turns find from a place. */
static void look(struct work *w, const struct simulation_state *at, uint32_t frames, uint16_t extra, struct way *best)
{
    struct way now = { .n = 0 };

    best->n = 0;
    memset(w->guess, 0, sizeof w->guess);
    for (int k = 0; k < TURNS && best->n < frames; k++) {
        w->eager = k + 1 < TURNS && !w->tried;
        simulation_restore(w->t, at);
        const bool both[MAX_PLAYERS] = { steers(w->t->b, 0), steers(w->t->b, 1) };
        for (int p = 0; p < MAX_PLAYERS; p++)
            if (both[p])
                plan_for(w, p, at, frames, extra);
        fly(w, at, frames, extra, &now);
        if (now.n > best->n || k == 0)
            *best = now;
    }
}

/* ---- for good ---- */

static bool entered(const struct board *b)
{
    const struct board_out *out = board_last_output(b);

    for (int i = 0; i < out->marker_count; i++)
        if (out->marker[i].kind == MARKER_ROW)
            return true;
    return false;
}

static void go(struct work *w, const uint16_t pads[MAX_PLAYERS])
{
    struct run *r = w->p->r;

    if (run_tick(r, pads) == SIMULATION_FAULT)
        bot_fail(board_last_output(w->t->b)->fault->message);
    if (w->p->finish && entered(w->t->b) && board_frame(w->t->b) + 120 < r->limit)
        r->limit = board_frame(w->t->b) + 120;
    if (!r->quiet && board_frame(w->t->b) % 3600 == 0)
        fprintf(stderr, "%u s, %lld points, lives %d, %u hits, %u bombs, %u times back\n", board_frame(w->t->b) / 60,
                (long long)score(w->t->b), (int)w->t->b->player.lives[0], w->p->hits, w->p->bombs, w->p->backs);
}

static void put_place(struct work *w)
{
    const uint32_t now = board_frame(w->t->b);

    if (w->places && w->place[w->places - 1].frame >= now)
        return;
    if (w->places == PLACES) { /* the oldest goes */
        struct mark first = w->place[0];
        memmove(w->place, w->place + 1, (PLACES - 1) * sizeof *w->place);
        w->place[--w->places] = first;
    }
    if (!simulation_save(w->t, &w->place[w->places].mark))
        bot_fail("out of memory");
    w->place[w->places++].frame = now;
}

/* Further each time, but for the first place. */
static void go_back(struct work *w)
{
    w->back = w->back ? w->back * 2 : 1;
    for (uint32_t i = 0; i < w->back && w->places > 1; i++)
        w->places--;
    if (w->back >= 16)
        w->back = 0;
    w->taste++;
    w->p->backs++;
    simulation_restore(w->t, &w->place[w->places - 1].mark);
}

/* Takes the hit: on along the best way, and until the ship is there again. */
static void be_hit(struct work *w, const struct way *best)
{
    simulation_restore(w->t, &w->place[w->places - 1].mark);
    for (uint32_t f = 0; f < best->n; f++)
        go(w, best->pads[f]);
    for (int f = 0; f < 60 && !was_hit(w->t->b); f++)
        go(w, best->n ? best->pads[best->n - 1] : (const uint16_t[MAX_PLAYERS]){ 0 });
    w->p->hits++;
    w->places = 0;
    w->tried = w->back = 0;
    w->furthest = board_frame(w->t->b);
}

/* Bullets in plenty: is more gained with the special button? */
static void try_special(struct work *w, const struct simulation_state *at, uint32_t frames, struct way *best)
{
    const uint32_t now = board_frame(w->t->b);
    struct way with;

    simulation_restore(w->t, at);
    if (w->t->b->bullets.s.live < CROWDED || now < w->special)
        return;
    w->special = now + SPECIAL_EVERY / 4;
    look(w, at, frames, PAD_SPECIAL, &with);
    if (with.n < frames || with.score < best->score + best->score / 100 + 500)
        return;
    *best = with;
    w->special = now + SPECIAL_EVERY;
    w->p->specials++;
}

static void one_piece(struct work *w)
{
    const struct mark *at = &w->place[w->places - 1];
    const uint32_t left = w->p->r->limit - at->frame, frames = left < AHEAD ? left : AHEAD;
    struct way best, with;

    look(w, &at->mark, frames, 0, &best);
    if (best.n == frames)
        try_special(w, &at->mark, frames, &best);
    if (w->tried >= GO_BACK && best.n < frames) {
        static const uint16_t buttons[] = { PAD_SPECIAL, PAD_BOMB };
        for (int i = 0; i < 2 && best.n < frames; i++) {
            look(w, &at->mark, frames, buttons[i], &with);
            if (with.n > best.n + 8) {
                best = with;
                *(i ? &w->p->bombs : &w->p->specials) += 1;
            }
        }
    }
    if (best.n < (frames < LEAST ? frames : LEAST)) {
        if (++w->tried >= GIVE_UP)
            be_hit(w, &best);
        else
            go_back(w);
        return;
    }
    const uint32_t flown = best.n == frames ? (best.n + 1) / 2 : best.n / 3 + 1;
    simulation_restore(w->t, &at->mark);
    for (uint32_t f = 0; f < flown; f++)
        go(w, best.pads[f]);
}

/* It goes to meet what hits. */
static void go_to_be_hit(struct work *w)
{
    const struct board *b = w->t->b;
    uint16_t pads[MAX_PLAYERS] = { 0 };

    for (int p = 0; p < MAX_PLAYERS; p++) {
        const uint16_t up =
            board_frame(b) % 8 < 4 && b->player.y[p] > b->cart.manifest.field_h * (FX_ONE / 4) ? PAD_UP : 0;
        const uint16_t side = board_frame(b) / 90 % 2 ? PAD_LEFT : PAD_RIGHT;
        pads[p] = steers(b, p) ? (uint16_t)(PAD_FIRE | up | side) : b->player.in_game[p] || p == 0 ? press(w, p) : 0;
    }
    const uint32_t hits = (uint32_t)w->p->deaths;
    go(w, pads);
    for (int i = 0; i < board_last_output(w->t->b)->marker_count; i++)
        if (board_last_output(w->t->b)->marker[i].kind == MARKER_DEATH)
            w->p->hits++;
    w->p->deaths = hits > w->p->hits ? (int)hits : 0;
    w->places = 0;
    w->furthest = board_frame(b);
}

static bool is_busy(const struct board *b)
{
    return b->enemies.s.live || b->bullets.s.live || b->lasers.s.live;
}

/* A frame without a plan: nobody is there, or there is nothing to plan for. */
static void go_on(struct work *w)
{
    static const uint16_t none[MAX_PLAYERS];
    uint16_t pads[MAX_PLAYERS];

    held(w, none, 0, pads);
    go(w, pads);
    w->tried = w->back = 0;
    w->furthest = board_frame(w->t->b);
    w->places = 0;
}

bool pilot_play(struct pilot *p)
{
    struct work *w = calloc(1, sizeof *w);

    if (!w)
        bot_fail("out of memory");
    w->p = p;
    w->t = &p->r->t;
    const uint32_t lose = p->lose ? board_frame(w->t->b) + 60 * (uint32_t)p->lose : UINT32_MAX;
    while (board_frame(w->t->b) < p->r->limit) {
        const struct board *b = w->t->b;
        const uint32_t now = board_frame(b);
        if ((p->deaths > 0 && b->bullets.s.live > 30) || now >= lose) {
            go_to_be_hit(w);
            continue;
        }
        if ((!steers(b, 0) && !steers(b, 1)) || !is_busy(b)) {
            go_on(w);
            continue;
        }
        if (now > w->furthest + AHEAD) {
            w->furthest = now;
            w->tried = w->back = w->taste = 0; /* past the detour */
        }
        put_place(w);
        one_piece(w);
    }
    for (int i = 0; i < PLACES; i++)
        simulation_state_free(&w->place[i].mark);
    forecast_close(&w->forecast);
    free(w);
    return true;
}
