/*
 * menus.c - see bot.h.
 *
 * A search in breadth. From each screen all moves are tried: some steps to the right, some down, then fire, for each
 * player; a move is MOVE frames, so that all places of one depth are of the same frame. Two places that show the same
 * are one. So it knows nothing of any menu, but that these are its keys.
 */
#include <stdlib.h>
#include <string.h>
#include "../../src/board/api_table.h"
#include "../../src/board/machine.h"
#include "bot.h"

enum {
    MOVE = 84,   /* frames: a screen comes, and can be read */
    STEP = 6,    /* from one press to the next */
    HELD = 2,    /* frames of it */
    DEPTH = 9,   /* moves */
    PLACES = 512 /* of one depth */
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
};

static uint16_t pressed(const struct move *m, int frame)
{
    const int n = frame / STEP;

    if (frame % STEP >= HELD)
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

    return is_ship(b, 0, w->ship[0]) && (w->difficulty < 0 || board_difficulty_now(b) == w->difficulty) &&
           !!b->player.in[1] == (w->players > 1) && (w->players < 2 || is_ship(b, 1, w->ship[1]));
}

static bool is_known(const struct menus *m, uint64_t now)
{
    for (int i = 0; i < m->n_to; i++)
        if (m->to[i].shown == now)
            return true;
    return false;
}

/* Presses a move; true: a game began in it. */
static bool make(struct run *r, const struct move way[PADS], bool noted)
{
    for (int f = 0; f < MOVE; f++) {
        const uint16_t pads[PADS] = { pressed(&way[0], f), pressed(&way[1], f) };
        const enum trial_end end = noted ? run_tick(r, pads) : trial_tick(&r->t, pads);
        if (end == TRIAL_FAULT)
            bot_fail(board_last(r->t.b)->fault->message);
    }
    return r->t.b->player.in[0];
}

/* Tries a move from a place; true: it is what was wished. */
static bool try_move(struct menus *m, const struct place *at, const struct move way[PADS])
{
    trial_restore(&m->r->t, &at->mark);
    const bool began = make(m->r, way, false), found = began && is_wished(m);
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
    const int others = m->wish->players > 1 ? 7 : 1;

    for (int i = 0; i < 21; i++)
        for (int k = 0; k < others; k++) {
            struct move way[PADS] = { { (uint8_t)(i / 5), (uint8_t)(i % 5), i < 20 }, { 0 } };
            if (i == 20)
                way[0].right = 0;
            if (k)
                way[1] = (struct move){ (uint8_t)((k - 1) / 2), (uint8_t)((k - 1) % 2), 1 };
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

bool menus_enter(struct run *r, const struct menus_wish *wish)
{
    struct menus m = { .r = r, .wish = wish };
    struct trial_mark start = { 0 };

    m.from = calloc(PLACES, sizeof *m.from);
    m.to = calloc(PLACES, sizeof *m.to);
    if (!m.from || !m.to || !trial_save(&r->t, &start) || !trial_save(&r->t, &m.from[0].mark))
        bot_fail("out of memory");
    m.n_from = 1;
    const bool found = search(&m);
    trial_restore(&r->t, &start);
    for (int i = 0; found && i <= m.depth; i++)
        make(r, m.to[m.n_to - 1].way[i], true);
    forget(m.from, m.n_from);
    forget(m.to, m.n_to);
    free(m.from);
    free(m.to);
    trial_mark_free(&start);
    return found;
}
