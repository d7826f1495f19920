/*
 * pieces.c - see pieces.h. Marks come after all stages and bosses were told (so that these are known whatever happens
 * when a stage is run through), and are put where they belong.
 */
#include "pieces.h"

#include <stdio.h>
#include <string.h>
#include "../host/report.h"
#include "guard.h"

enum { PATIENCE = 10000 /* frames */ };

/* Room for a piece at place i; NULL: the list is full. */
static struct piece *insert(struct pieces *p, int i)
{
    if (p->n == PIECES)
        return NULL;
    memmove(&p->piece[i + 1], &p->piece[i], (size_t)(p->n - i) * sizeof p->piece[0]);
    p->n++;
    p->piece[i] = (struct piece){ 0 };
    return &p->piece[i];
}

/* Where a new child of a parent goes: after its others. -1: there is no such parent. */
static int place_of(const struct pieces *p, enum piece_kind parent, const char *name)
{
    for (int i = 0; i < p->n; i++) {
        if (p->piece[i].kind != parent || strcmp(p->piece[i].name, name) != 0)
            continue;
        for (i++; i < p->n && (p->piece[i].kind == PIECE_POINT || p->piece[i].kind == PIECE_PHASE);)
            i++;
        return i;
    }
    return -1;
}

static bool has(const struct pieces *p, enum piece_kind kind, const char *mark)
{
    for (int i = 0; i < p->n; i++)
        if (p->piece[i].kind == kind && strcmp(p->piece[i].mark, mark) == 0)
            return true;
    return false;
}

static void add(struct pieces *p, enum piece_kind kind, const struct board_mark *m)
{
    bool child = kind == PIECE_POINT || kind == PIECE_PHASE;
    char mark[sizeof p->piece[0].mark];

    if (child)
        snprintf(mark, sizeof mark, "%s%c%s", m->of, kind == PIECE_POINT ? ':' : '/', m->name);
    else
        snprintf(mark, sizeof mark, "%s", m->name);
    if (has(p, kind, mark)) /* a game's own task may play a piece meanwhile */
        return;
    int i = child ? place_of(p, kind == PIECE_POINT ? PIECE_STAGE : PIECE_BOSS, m->of) : p->n;
    struct piece *at = i < 0 ? NULL : insert(p, i);
    if (!at)
        return;
    at->kind = kind;
    memcpy(at->mark, mark, sizeof at->mark);
    memcpy(at->name, m->name, sizeof at->name);
    memcpy(at->title, m->title, sizeof at->title);
}

static void add_register(struct pieces *p, const struct board_mark *m)
{
    if (p->registers == PRACTICE_REGISTERS)
        return;
    memcpy(p->reg[p->registers].name, m->name, sizeof m->name);
    p->reg[p->registers++].value = m->value;
}

/* True when it was the last. */
static bool hear(struct pieces *p, const struct board_mark *m)
{
    switch (m->kind) {
    case MARK_STAGE:
        add(p, PIECE_STAGE, m);
        break;
    case MARK_POINT:
        add(p, PIECE_POINT, m);
        break;
    case MARK_BOSS:
        add(p, PIECE_BOSS, m);
        break;
    case MARK_PHASE:
        add(p, PIECE_PHASE, m);
        break;
    case MARK_SHIP:
        memcpy(p->ship, m->name, sizeof p->ship);
        p->lives = m->value;
        break;
    case MARK_REGISTER:
        add_register(p, m);
        break;
    default:
        return m->kind == MARK_LISTED;
    }
    return false;
}

/* Ticks until all is told. */
static void listen(struct pieces *p, struct guard *g, bool log)
{
    const uint16_t none[PADS] = { 0 };
    const struct board_out *out = board_last(g->board);
    bool done = false;

    for (int f = 0; !out->fault && !done && f < PATIENCE; f++) {
        out = guard_tick(g, none);
        for (int i = 0; i < out->marks; i++)
            done |= hear(p, &out->mark[i]);
        if (log)
            report_log(out, "curtain: ");
    }
    if (out->fault)
        snprintf(p->why, sizeof p->why, "%s", out->fault->message);
    else if (!done)
        snprintf(p->why, sizeof p->why, "the game does not tell what can be practised");
}

void pieces_list(struct pieces *p, const struct rom *rom, const struct board_start *start, bool log)
{
    struct board_start ask = *start;
    struct guard g;

    memset(p, 0, sizeof *p);
    memset(&ask.practice, 0, sizeof ask.practice);
    snprintf(ask.practice.mark, sizeof ask.practice.mark, "%s", PRACTICE_LIST);
    if (!guard_power(&g, rom, &ask, p->why, sizeof p->why))
        return;
    listen(p, &g, log);
    guard_close(&g);
}
