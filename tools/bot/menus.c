/*
 * menus.c - see bot.h.
 *
 * A search in breadth. From each screen all moves are tried: some steps to the right, some down, then fire, for each
 * player; a move is MOVE frames, so that all places of one depth are of the same frame. What shows what another place
 * showed is that one. So it knows nothing of any menu, but that these are its keys.
 */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "../../src/board/api_table.h"
#include "../../src/board/machine.h"
#include "bot.h"

enum {
    MOVE = 84,    /* frames: a screen comes, and can be read */
    STEP = 6,     /* from one press to the next */
    HELD = 2,     /* frames of it */
    DEPTH = 24,   /* moves */
    PLACES = 512, /* of one depth */
    SHOWN = 1 << 14
};

const char *api_names_at(const struct board *b, enum api_names what, int index);

struct move {
    uint8_t right, down, fire;
};

struct place {
    struct trial_mark mark;
    uint64_t shown;
    struct move way[DEPTH][PADS];
};

struct menus {
    struct run *r;
    const struct menus_wish *wish;
    struct place *from, *to;
    int n_from, n_to, depth;
    uint64_t known[SHOWN]; /* what was shown, by its low bits */
    char stage[32];        /* the game that a move began: its first stage; "": it has none, or is a piece of one */
    bool began;
};

static uint16_t pressed(const struct move *m, int frame)
{
    const int n = frame / STEP;

    if (frame % STEP >= HELD || frame >= MOVE)
        return 0;
    if (n < m->right)
        return PAD_RIGHT;
    if (n < m->right + m->down)
        return PAD_DOWN;
    return n == m->right + m->down && m->fire ? PAD_FIRE : 0;
}

/* What is on the screen, as hashes. */
static uint64_t shown(const struct board *b)
{
    uint64_t hashes[MAX_PARTS], sum = 0;

    board_hashes(b, hashes);
    for (int i = 0; i < board_parts(b); i++) {
        const char *name = board_part(b, i);
        if (!strcmp(name, "fix") || !strcmp(name, "sprites") || !strcmp(name, "player"))
            sum = (sum ^ hashes[i]) * 0x9e3779b97f4a7c15u;
    }
    return sum;
}

static bool is_ship(const struct board *b, int p, const char *name)
{
    const char *is = api_names_at(b, N_PLAYER, b->player.kind[p]);

    return !name || (is && !strcmp(is, name));
}

static bool is_wished(const struct menus *m)
{
    const struct board *b = m->r->t.b;
    const struct menus_wish *w = m->wish;

    return m->stage[0] && (!w->first || !strcmp(m->stage, w->first)) && is_ship(b, 0, w->ship[0]) &&
           (w->difficulty < 0 || board_difficulty_now(b) == w->difficulty) && !!b->player.in[1] == (w->players > 1) &&
           (w->players < 2 || is_ship(b, 1, w->ship[1]));
}

static bool is_known(struct menus *m, uint64_t now)
{
    uint32_t i = (uint32_t)now % SHOWN;

    while (m->known[i] && m->known[i] != now)
        i = (i + 1) % SHOWN;
    const bool known = m->known[i] == now;
    m->known[i] = now;
    return known;
}

/* What the last tick said of a game. */
static void hear(struct menus *m)
{
    const struct board_out *out = board_last(m->r->t.b);

    for (int i = 0; i < out->markers; i++) {
        const struct board_marker *marker = &out->marker[i];
        if (marker->kind == MARKER_GAME || marker->kind == MARKER_START) {
            m->began = true;
            m->stage[0] = 0;
        }
        if (marker->kind == MARKER_STAGE && m->began)
            snprintf(m->stage, sizeof m->stage, "%s", marker->name);
    }
}

/* Presses a move; true: a game began in it. Then its stage is waited for. */
static bool make(struct menus *m, const struct move way[PADS], bool noted)
{
    struct run *r = m->r;

    m->began = false;
    for (int f = 0; f < MOVE || (m->began && !m->stage[0] && f < 3 * MOVE); f++) {
        const uint16_t pads[PADS] = { pressed(&way[0], f), pressed(&way[1], f) };
        const enum trial_end end = noted ? run_tick(r, pads) : trial_tick(&r->t, pads);
        if (end == TRIAL_FAULT)
            bot_fail(board_last(r->t.b)->fault->message);
        hear(m);
    }
    return m->began;
}

/* Tries a move from a place; true: it is what was wished. */
static bool try_move(struct menus *m, const struct place *at, const struct move way[PADS])
{
    trial_restore(&m->r->t, &at->mark);
    const bool began = make(m, way, false), found = began && is_wished(m);
    const uint64_t now = began ? 0 : shown(m->r->t.b);

    if ((began && !found) || (!found && is_known(m, now)) || m->n_to == PLACES)
        return false;
    struct place *to = &m->to[m->n_to++];
    to->shown = now;
    memcpy(to->way, at->way, sizeof to->way);
    memcpy(to->way[m->depth], way, sizeof to->way[0]);
    if (!found && !trial_save(&m->r->t, &to->mark))
        bot_fail("out of memory");
    return found;
}

static bool try_moves(struct menus *m, const struct place *at)
{
    const int others = m->wish->players > 1 ? 4 : 1;

    for (int i = 0; i < 13; i++)
        for (int k = 0; k < others; k++) {
            struct move way[PADS] = { { (uint8_t)(i / 4), (uint8_t)(i % 4), i < 12 }, { 0 } };
            if (i == 12)
                way[0].right = 0;
            if (k)
                way[1] = (struct move){ (uint8_t)(k - 1), 0, 1 };
            if (try_move(m, at, way))
                return true;
        }
    return false;
}

static void forget(struct place *list, int n)
{
    for (int i = 0; i < n; i++)
        trial_mark_free(&list[i].mark);
    memset(list, 0, (size_t)n * sizeof *list);
}

static bool search(struct menus *m)
{
    for (m->depth = 0; m->depth < DEPTH && m->n_from; m->depth++) {
        for (int i = 0; i < m->n_from; i++)
            if (try_moves(m, &m->from[i]))
                return true;
        struct place *was = m->from;
        forget(was, m->n_from);
        m->from = m->to;
        m->n_from = m->n_to;
        m->to = was;
        m->n_to = 0;
    }
    return false;
}

/* Is it a kind of player? All are declared before the title. */
static bool is_declared(const struct board *b, const char *name)
{
    const char *is;

    for (int i = 0; i < (int)b->names[N_PLAYER].n; i++)
        if ((is = api_names_at(b, N_PLAYER, i)) && !strcmp(is, name))
            return true;
    return false;
}

bool menus_enter(struct run *r, const struct menus_wish *wish)
{
    static struct menus m; /* large for a stack */
    struct trial_mark start = { 0 };

    for (int p = 0; p < wish->players; p++)
        if (wish->ship[p] && !is_declared(r->t.b, wish->ship[p]))
            return false;
    m = (struct menus){ .r = r, .wish = wish };
    m.from = calloc(PLACES, sizeof *m.from);
    m.to = calloc(PLACES, sizeof *m.to);
    if (!m.from || !m.to || !trial_save(&r->t, &start) || !trial_save(&r->t, &m.from[0].mark))
        bot_fail("out of memory");
    m.n_from = 1;
    const bool found = search(&m);
    trial_restore(&r->t, &start);
    for (int i = 0; found && i <= m.depth; i++)
        make(&m, m.to[m.n_to - 1].way[i], true);
    forget(m.from, m.n_from);
    forget(m.to, m.n_to);
    free(m.from);
    free(m.to);
    trial_mark_free(&start);
    return found;
}
