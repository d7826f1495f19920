/*
 * menus.c - see bot.h.
 *
 * A search in breadth. From each screen all moves are tried: some steps to the right, some down, then fire, for each
 * player; a move is MOVE frames, and fire is pressed in the same one of them in all, so that what moves by itself makes
 * no two places of one. Two ways to a place are one when on each screen the same was chosen: a choice is known by what
 * stood there when fire was pressed, for the next screen may not show it. A way never comes back to a screen, which is
 * told by its text; and where nothing leads on, it waits. So it knows nothing of any menu, but that these are its keys
 * and that what it leads to is written there.
 */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "../../src/script/api/api_table.h"
#include "../../src/machine/machine.h"
#include "bot.h"

enum {
    MOVE = 120,   /* frames: a screen opens, and can be read */
    STEP = 6,     /* from one press to the next */
    HELD = 2,     /* frames of it */
    RIGHT = 4,    /* a move has fewer steps to the right, */
    DOWN = 4,     /* and down */
    STEPS = 9,    /* at most that many of both players; then fire */
    DEPTH = 24,   /* moves */
    PLACES = 512, /* of one depth */
    KNOWN = 1 << 14,
    OTHER = 8 /* cells that are others on another screen: where an arrow stands, or a number, makes none */
};

struct move {
    uint8_t right, down, fire;
    uint8_t after; /* steps of the other player that come between these and fire */
};

/* The text on a screen, a code point a cell; the board's lines are written into it where they stand. */
struct page {
    uint32_t *cell;
};

struct place {
    struct simulation_state mark;
    uint64_t chosen; /* what was, on the way there */
    struct move way[DEPTH][MAX_PLAYERS];
    uint32_t page[DEPTH + 1]; /* of the way's screens: numbers */
};

struct menus {
    struct run *r;
    const struct menus_wish *wish;
    struct place *from, *to;
    int n_from, n_to, depth;
    uint64_t known[KNOWN]; /* what was chosen, by its low bits */
    uint64_t asked;        /* what stood there when fire was pressed */
    struct page *page;     /* of all places there were */
    uint32_t pages, room;
    uint32_t *now;  /* the text of now */
    char stage[32]; /* the game that a move began: its first stage; "": it has none, or is a piece of one */
    bool began, piece;
};

static uint16_t pressed(const struct move *m, int frame)
{
    const int n = frame / STEP, first = STEPS - m->right - m->down - m->after; /* fire is never earlier */

    if (frame % STEP >= HELD || n < first)
        return 0;
    if (n < first + m->right)
        return PAD_RIGHT;
    if (n < first + m->right + m->down)
        return PAD_DOWN;
    return n == STEPS && m->fire ? PAD_FIRE : 0;
}

/* What is on the screen, as hashes. */
static uint64_t shown(const struct board *b)
{
    static const char *const parts[] = { "fix", "lines", "sprites", "player" };
    uint64_t hashes[MAX_PARTS], sum = 0;

    board_hashes(b, hashes);
    for (int i = 0; i < board_part_count(b); i++)
        for (size_t k = 0; k < sizeof parts / sizeof *parts; k++)
            if (!strcmp(board_part_name(b, i), parts[k]))
                sum = (sum ^ hashes[i]) * 0x9e3779b97f4a7c15u;
    return sum;
}

/* ---- what is written on a screen ---- */

static uint32_t cells(const struct board *b)
{
    return b->fix.cols * b->fix.rows;
}

static void read_page(const struct board *b, uint32_t *cell)
{
    for (uint32_t i = 0; i < cells(b); i++)
        cell[i] = fix_code(&b->fix, i);
    EACH_LIVE (i, &b->lines.s) {
        const int64_t col = (b->lines.x[i] + b->lines.dx[i]) / (8 * FX_ONE);
        const int64_t row = (b->lines.y[i] + b->lines.dy[i]) / (8 * FX_ONE);
        for (int64_t n = 0; n < b->lines.length[i]; n++)
            if (row >= 0 && row < b->fix.rows && col + n >= 0 && col + n < b->fix.cols)
                cell[row * b->fix.cols + col + n] = b->lines.code[i * LINE_MAX_TEXT + n];
    }
}

/* Is what is written now what stood on a screen of the way? */
static bool was_there(struct menus *m, const struct place *at)
{
    const struct board *b = m->r->t.b;

    read_page(b, m->now);
    for (int d = 0; d <= m->depth; d++) {
        const uint32_t *then = m->page[at->page[d]].cell;
        int others = 0;
        for (uint32_t i = 0; i < cells(b) && others < OTHER; i++)
            others += then[i] != m->now[i];
        if (others < OTHER)
            return true;
    }
    return false;
}

/* Keeps the text of now; its number. */
static uint32_t keep_page(struct menus *m)
{
    const size_t n = cells(m->r->t.b);

    if (m->pages == m->room) {
        m->room = m->room ? 2 * m->room : 256;
        m->page = realloc(m->page, m->room * sizeof *m->page);
    }
    uint32_t *cell = m->page ? malloc(n * sizeof *cell) : NULL;
    if (!cell)
        bot_fail("out of memory");
    read_page(m->r->t.b, cell);
    m->page[m->pages].cell = cell;
    return m->pages++;
}

/* ---- moves ---- */

static bool is_ship(const struct board *b, int p, const char *name)
{
    const char *is = board_name(b, N_PLAYER, b->player.kind[p]);

    return !name || (is && !strcmp(is, name));
}

static bool is_wished(const struct menus *m)
{
    const struct board *b = m->r->t.b;
    const struct menus_wish *w = m->wish;

    return m->stage[0] && (!w->first || !strcmp(m->stage, w->first)) && is_ship(b, 0, w->ship[0]) &&
           (w->difficulty < 0 || board_current_difficulty(b) == w->difficulty) &&
           !!b->player.in_game[1] == (w->players > 1) && (w->players < 2 || is_ship(b, 1, w->ship[1]));
}

static bool is_known(struct menus *m, uint64_t now)
{
    uint32_t i = (uint32_t)now % KNOWN;

    while (m->known[i] && m->known[i] != now)
        i = (i + 1) % KNOWN;
    const bool known = m->known[i] == now;
    m->known[i] = now;
    return known;
}

/* What the last tick said of a game. */
static void hear(struct menus *m)
{
    const struct board_out *out = board_last_output(m->r->t.b);

    for (int i = 0; i < out->marker_count; i++) {
        const struct board_marker *marker = &out->marker[i];
        if (marker->kind == MARKER_GAME || marker->kind == MARKER_START) {
            m->began = true;
            m->piece = marker->kind == MARKER_START;
            m->stage[0] = 0;
        }
        if (marker->kind == MARKER_STAGE && m->began && !m->piece)
            snprintf(m->stage, sizeof m->stage, "%s", marker->name);
    }
}

/* Presses a move; true: a game began in it. Then its stage is waited for. */
static bool make(struct menus *m, const struct move way[MAX_PLAYERS], bool noted)
{
    struct run *r = m->r;

    m->began = false;
    m->asked = 0;
    for (int f = 0; f < MOVE || (m->began && !m->stage[0] && f < 3 * MOVE); f++) {
        const uint16_t pads[MAX_PLAYERS] = { pressed(&way[0], f), pressed(&way[1], f) };
        if (f == STEPS * STEP && !noted)
            m->asked = shown(r->t.b);
        const enum simulation_end end = noted ? run_tick(r, pads) : simulation_tick(&r->t, pads);
        if (end == SIMULATION_FAULT)
            bot_fail(board_last_output(r->t.b)->fault->message);
        hear(m);
    }
    return m->began;
}

/* What became of a move. */
enum led { NOWHERE, ELSEWHERE, THERE };

/* Tries a move from a place: to another one, to a game that was not wished (which is ELSEWHERE, too), or to that. */
static enum led try_move(struct menus *m, const struct place *at, const struct move way[MAX_PLAYERS], bool waits)
{
    simulation_restore(&m->r->t, &at->mark);
    const bool began = make(m, way, false), found = began && is_wished(m);
    const uint64_t chosen = ((at->chosen ^ m->asked) * 0x9e3779b97f4a7c15u ^ shown(m->r->t.b)) * 0x2545f4914f6cdd1du;

    if (began && !found)
        return ELSEWHERE;
    if (!found && !waits && was_there(m, at))
        return NOWHERE;
    if (m->n_to == PLACES || (!found && is_known(m, chosen)))
        return ELSEWHERE;
    struct place *to = &m->to[m->n_to++];
    to->chosen = chosen;
    memcpy(to->way, at->way, sizeof to->way);
    memcpy(to->way[m->depth], way, sizeof to->way[0]);
    memcpy(to->page, at->page, sizeof to->page);
    if (found)
        return THERE;
    to->page[m->depth + 1] = keep_page(m);
    if (!simulation_save(&m->r->t, &to->mark))
        bot_fail("out of memory");
    return ELSEWHERE;
}

/* On the page with a ship, a move may set one row and go down to the next without fire. */
static void try_rows(struct menus *m, const struct place *at)
{
    for (int i = 0; i < RIGHT && m->wish->players < 2; i++) {
        const struct move way[MAX_PLAYERS] = { { .right = (uint8_t)i, .down = 1 }, { 0 } };
        simulation_restore(&m->r->t, &at->mark);
        if (!m->r->t.b->player.in_game[0])
            return;
        try_move(m, at, way, true);
    }
}

static bool try_moves(struct menus *m, const struct place *at)
{
    const int others = m->wish->players > 1 ? RIGHT + 1 : 1;
    bool on = false;

    for (int i = 0; i < RIGHT * DOWN; i++)
        for (int k = 0; k < others; k++) {
            struct move way[MAX_PLAYERS] = { { (uint8_t)(i / DOWN), (uint8_t)(i % DOWN), 1, 0 }, { 0 } };
            if (k) {
                way[1] = (struct move){ (uint8_t)(k - 1), 0, 1, 0 };
                way[0].after = way[1].right;
            }
            const enum led led = try_move(m, at, way, false);
            if (led == THERE)
                return true;
            on = on || led == ELSEWHERE;
        }
    try_rows(m, at);
    if (!on)
        try_move(m, at, (const struct move[MAX_PLAYERS]){ { 0 } }, true);
    return false;
}

static void forget(struct place *list, int n)
{
    for (int i = 0; i < n; i++)
        simulation_state_free(&list[i].mark);
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
        if ((is = board_name(b, N_PLAYER, i)) && !strcmp(is, name))
            return true;
    return false;
}

bool menus_enter(struct run *r, const struct menus_wish *wish)
{
    static struct menus m; /* large for a stack */
    struct simulation_state start = { 0 };

    for (int p = 0; p < wish->players; p++)
        if (wish->ship[p] && !is_declared(r->t.b, wish->ship[p]))
            return false;
    m = (struct menus){ .r = r, .wish = wish };
    m.from = calloc(PLACES, sizeof *m.from);
    m.to = calloc(PLACES, sizeof *m.to);
    if (!m.from || !m.to || !simulation_save(&r->t, &start) || !simulation_save(&r->t, &m.from[0].mark))
        bot_fail("out of memory");
    m.n_from = 1;
    m.now = calloc(cells(r->t.b), sizeof *m.now);
    if (!m.now)
        bot_fail("out of memory");
    m.from[0].page[0] = keep_page(&m);
    const bool found = search(&m);
    simulation_restore(&r->t, &start);
    for (int i = 0; found && i <= m.depth; i++)
        make(&m, m.to[m.n_to - 1].way[i], true);
    forget(m.from, m.n_from);
    forget(m.to, m.n_to);
    for (uint32_t i = 0; i < m.pages; i++)
        free(m.page[i].cell);
    free(m.page);
    free(m.now);
    free(m.from);
    free(m.to);
    simulation_state_free(&start);
    return found;
}
