/*
 * check_forced.c - runs of rarely played parts: each ship at each difficulty loses lives, bombs and pauses; every
 * section is played at the lowest and the highest difficulty; whole games are played from the title, by one and two
 * players, with continues, to a game over and to the end, in each language and with each DIP switch; each entry of the
 * title menu is opened.
 *
 * The buttons depend only on the frame and the board, so runs are reproducible. force_run causes events that buttons
 * cannot cause reliably. Fire is enough for menus like those of the library. If a game's own menus need other buttons,
 * the game doesn't start, which is not reported.
 */
#include "check_run.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "../bench/sweep.h"

enum {
    SHIP_FRAMES = 1000,   /* per ship and difficulty */
    STAGE_FRAMES = 480,   /* of a stage at another difficulty */
    PHASE_FRAMES = 180,   /* of a phase */
    BEFORE_FRAMES = 1800, /* in menus, until a game begins */
    GAME_FRAMES = 4000,   /* of a game that is lost */
    CLEAR_FRAMES = 30000, /* of one that is won */
    AFTER_FRAMES = 1500,  /* after a game: the ending, name entry and scores */
    START_FRAMES = 900,   /* of a game in another language, or with another switch */
    MENU_FRAMES = 2400,   /* of a run with pseudo-random buttons */
    ENTRIES = 12,         /* of the title menu */
    ENTRY_FRAMES = 900,   /* in an entry: a third without buttons, a third with fire, a third pseudo-random */
    TAP = 2,              /* frames for which a button is held */
    EVERY = 24            /* frames from one press to the next; menus need a pause between presses */
};

enum tour_kind { TOUR_LOST, TOUR_TWO, TOUR_WON, TOUR_START, TOUR_MENUS, TOUR_ENTRY };

/* A run of the game from its title. */
struct tour {
    enum tour_kind kind;
    struct board_start start;
    int entry; /* of TOUR_ENTRY, from 0 */
    bool playing, over;
    uint32_t since;      /* the frame in which the game started or ended */
    uint32_t frames_out; /* frames since the last player lost the last life */
    int continues;
};

static uint16_t tap(uint32_t frame, uint32_t every, uint16_t button)
{
    return frame % every < TAP ? button : 0;
}

static bool is_faulty(const struct run *r)
{
    return board_last_output(r->guard.board)->fault != NULL;
}

/* ---- forced events ---- */

struct forced_event {
    uint32_t frame; /* of the game */
    enum force_kind kind;
};

/* In the second life, the bomb is a deathbomb if the kind has frames for it. */
static const struct forced_event events[] = {
    { 60, FORCE_TAKE },   { 90, FORCE_GRAZE }, { 100, FORCE_EXTEND }, { 120, FORCE_BOMB },
    { 360, FORCE_GRAZE }, { 361, FORCE_HIT },  { 480, FORCE_HIT },    { 480, FORCE_BOMB },
    { 600, FORCE_BOMB },  { 700, FORCE_HIT },  { 780, FORCE_DEATH },
};

enum { CHOOSES_AT = 200, DIES_FROM = 820, DIES_EVERY = 16, FOCUS_FROM = 560 };

/* Forces an event, unless it has caused a fault before: then the run is repeated without the event. */
static void force(struct run *r, enum force_kind kind, int player)
{
    const struct force f = { kind, player };

    if (is_faulty(r) || r->faulting_forces >> kind & 1)
        return;
    force_run(r->guard.board, &f);
    r->forced = true;
    if (is_faulty(r))
        r->faulting_forces |= 1u << kind;
}

/* Forces the events of a frame in a game that ends in game over. */
static void force_loss(struct run *r, uint32_t frame, int players)
{
    for (int p = 0; p < players; p++) {
        for (size_t i = 0; i < sizeof events / sizeof *events; i++)
            if (events[i].frame == frame)
                force(r, events[i].kind, p);
        if (frame >= DIES_FROM && frame % DIES_EVERY == 0)
            force(r, FORCE_DEATH, p);
    }
}

/* Sets the buttons of a ship in a frame of a game: it moves and fires, sometimes focused, and chooses each of the
 * game's entries in the pause menu. Fire is released regularly, for dialogues. */
static void ship_pads(struct run *r, uint32_t frame, uint16_t pads[MAX_PLAYERS])
{
    const uint32_t entry = (frame - CHOOSES_AT) / EVERY;

    sweep_pads(frame, pads);
    if (frame % 30 < TAP)
        pads[0] = (uint16_t)(pads[0] & ~PAD_FIRE);
    pads[0] |= (uint16_t)(tap(frame, 90, PAD_SPECIAL) | tap(frame, 150, PAD_SELECT));
    if (frame >= FOCUS_FROM && frame % 200 < 100)
        pads[0] |= PAD_FOCUS;
    if (frame % 320 == 250 && !(r->faulting_forces >> FORCE_BOMB & 1))
        pads[0] |= PAD_BOMB;
    if (frame >= CHOOSES_AT && entry < PAUSE_ENTRIES && (frame - CHOOSES_AT) % EVERY == 0)
        pads[0] |= (uint16_t)((CODE_ENTRY + entry) << PAD_CODE_SHIFT);
    pads[1] = pads[0];
}

/* ---- sections ---- */

static void play_practice(struct run *r, const char *what, const char *section, int difficulty, uint32_t frames,
                          bool loses)
{
    struct board_start start = check_run_start(r);
    uint16_t pads[MAX_PLAYERS];

    start.difficulty = difficulty;
    start.practice.invincible = !loses;
    snprintf(start.practice.section, sizeof start.practice.section, "%s", section);
    if (!check_run_power_on(r, what, &start))
        return;
    for (uint32_t f = 0; f < frames && !is_faulty(r); f++) {
        check_run_show_progress(r, f, frames);
        ship_pads(r, f, pads);
        check_run_tick(r, pads);
        if (loses)
            force_loss(r, f, 1);
    }
    check_run_finish(r);
}

/* Writes the section with a ship, "one@petrel". False: too long. */
static bool append_ship(const struct sections *s, const char *section, int ship, char out[64])
{
    if (s->ships < 2)
        return snprintf(out, 64, "%s", section) < 64;
    return snprintf(out, 64, "%s@%s", section, s->ship[ship].name) < 64;
}

static const char *first_stage(const struct sections *s)
{
    for (int i = 0; i < s->n; i++)
        if (s->section[i].kind == SECTION_STAGE)
            return s->section[i].id;
    return NULL;
}

/* Returns the number of difficulties, at least 1. */
static int count_difficulties(const struct run *r)
{
    const int n = r->cart.manifest.n_difficulties;

    return n > 0 ? n : 1;
}

static const char *difficulty_name(const struct run *r, int i)
{
    const struct manifest *m = &r->cart.manifest;

    return i < m->n_difficulties ? m->difficulties[i] : "";
}

static void play_ship(struct run *r, int ship, int difficulty)
{
    const struct sections *s = r->sections;
    char section[64], what[128];

    if (!append_ship(s, first_stage(s), ship, section))
        return;
    snprintf(what, sizeof what, "%s %s", section, difficulty_name(r, difficulty));
    unsigned before;
    do {
        before = r->faulting_forces;
        play_practice(r, what, section, difficulty, SHIP_FRAMES, true);
    } while (r->faulting_forces != before);
}

/* Plays a section at a difficulty; ships alternate. check_run.c plays the default difficulty. */
static void play_section(struct run *r, int i, int difficulty)
{
    const struct sections *s = r->sections;
    char section[64], what[128];

    if (!append_ship(s, s->section[i].id, s->ships ? (i + difficulty) % s->ships : 0, section))
        return;
    snprintf(what, sizeof what, "%s %s", section, difficulty_name(r, difficulty));
    play_practice(r, what, section, difficulty, s->section[i].kind == SECTION_STAGE ? STAGE_FRAMES : PHASE_FRAMES,
                  false);
}

/* ---- games ---- */

/* Fire goes through menus; fire and down, alternately, choose "2 PLAYERS", other modes and other ships. */
static uint16_t menu_pads(const struct tour *t, uint32_t frame)
{
    if (t->kind == TOUR_TWO && frame / EVERY % 2)
        return tap(frame, EVERY, PAD_DOWN);
    return tap(frame, EVERY, PAD_FIRE);
}

static uint16_t random_pads(uint32_t frame)
{
    static const uint16_t buttons[] = {
        PAD_FIRE, PAD_DOWN, PAD_FIRE, PAD_RIGHT, PAD_DOWN, PAD_BOMB, PAD_UP, PAD_START
    };
    uint32_t n = frame / EVERY * 2654435761u;

    return tap(frame, EVERY, buttons[(n ^ n >> 15) >> 7 & 7]);
}

static uint32_t opening_frame(const struct tour *t)
{
    return (uint32_t)(t->entry + 2) * EVERY;
}

/* Moves down to the entry of the title menu and opens it. */
static uint16_t entry_pads(const struct tour *t, uint32_t frame)
{
    const uint32_t opened = opening_frame(t);

    if (frame < EVERY)
        return 0;
    if (frame < opened)
        return tap(frame, EVERY, frame < 2 * EVERY ? PAD_START : PAD_DOWN);
    if (frame < opened + ENTRY_FRAMES / 3)
        return frame < opened + TAP ? PAD_FIRE : 0;
    return frame < opened + 2 * ENTRY_FRAMES / 3 ? tap(frame, EVERY, PAD_FIRE) : random_pads(frame);
}

static bool any_player_in_game(const struct run *r)
{
    return force_player_in_game(r->guard.board, 0) || force_player_in_game(r->guard.board, 1);
}

/* Accepts the first continue and refuses the second. */
static uint16_t continue_pads(const struct tour *t)
{
    return t->continues == 0 ? tap(t->frames_out, EVERY, PAD_START) : tap(t->frames_out, EVERY, PAD_BOMB);
}

static void tour_pads(struct run *r, const struct tour *t, uint32_t frame, uint16_t pads[MAX_PLAYERS])
{
    const uint32_t age = frame - t->since;

    memset(pads, 0, MAX_PLAYERS * sizeof *pads);
    if (t->kind == TOUR_MENUS)
        pads[0] = random_pads(frame);
    else if (t->kind == TOUR_ENTRY)
        pads[0] = entry_pads(t, frame);
    else if (t->over)
        pads[0] = age / EVERY % 4 == 3 ? tap(age, EVERY, PAD_START) : tap(age, EVERY, PAD_FIRE);
    else if (!t->playing)
        pads[0] = menu_pads(t, frame);
    else if (!any_player_in_game(r))
        pads[0] = continue_pads(t);
    else
        ship_pads(r, age, pads);
    if (!t->playing || t->over || !any_player_in_game(r))
        pads[1] = t->kind == TOUR_TWO ? pads[0] : 0;
    else if (!force_player_in_game(r->guard.board, 1))
        pads[1] = tap(age, EVERY, PAD_START); /* rejoin while the other player plays */
}

/* Forces the events of a frame in a game. With two players, the second loses all lives first. */
static void tour_force(struct run *r, struct tour *t, uint32_t age)
{
    switch (t->kind) {
    case TOUR_LOST:
        force_loss(r, age, 1);
        break;
    case TOUR_TWO:
        force_loss(r, age, 2);
        if (age >= 400 && age < 560 && age % DIES_EVERY == 0)
            force(r, FORCE_DEATH, 1);
        break;
    case TOUR_WON:
        for (int p = 0; p < 2 && age % 600 == 0; p++)
            force(r, FORCE_SAFE, p);
        if (age % 60 == 0)
            force(r, FORCE_DAMAGE, 0);
        break;
    case TOUR_ENTRY:
        if (age % 60 == 59) /* ends a mission soon */
            force(r, FORCE_DEATH, 0);
        break;
    case TOUR_START:
    case TOUR_MENUS:
        break;
    }
}

static void update_tour(struct run *r, struct tour *t, const struct board_out *out, uint32_t frame)
{
    const bool in = any_player_in_game(r);

    for (int i = 0; i < out->marker_count; i++) {
        const enum board_marker_kind kind = out->marker[i].kind;
        if (t->over || (kind != MARKER_GAME && kind != MARKER_OVER))
            continue;
        t->playing = true;
        t->over = kind == MARKER_OVER;
        t->since = frame;
    }
    if (in && t->frames_out > 0 && t->playing && !t->over)
        t->continues++;
    t->frames_out = in ? 0 : t->frames_out + 1;
    if (!t->playing)
        t->frames_out = 0;
}

static uint32_t game_frames(enum tour_kind kind)
{
    return kind == TOUR_WON ? CLEAR_FRAMES : kind == TOUR_START ? START_FRAMES : GAME_FRAMES;
}

static bool is_over(const struct tour *t, uint32_t frame)
{
    const uint32_t age = frame - t->since, most = game_frames(t->kind);

    if (t->kind == TOUR_MENUS)
        return frame >= MENU_FRAMES;
    if (t->kind == TOUR_ENTRY)
        return frame >= opening_frame(t) + ENTRY_FRAMES;
    if (!t->playing)
        return frame >= BEFORE_FRAMES;
    if (frame >= BEFORE_FRAMES + most + AFTER_FRAMES) /* a game may restart forever */
        return true;
    return age >= (t->over ? AFTER_FRAMES : most);
}

/* nvram: receives the nvram at the end (malloc); may be NULL. */
static void play_tour(struct run *r, const char *what, struct tour *t, uint8_t **nvram, size_t *size)
{
    uint16_t pads[MAX_PLAYERS];

    if (!check_run_power_on(r, what, &t->start))
        return;
    for (uint32_t f = 0; !is_over(t, f) && !is_faulty(r); f++) {
        check_run_show_progress(r, f, CLEAR_FRAMES);
        tour_pads(r, t, f, pads);
        update_tour(r, t, check_run_tick(r, pads), f);
        if (t->playing && !t->over)
            tour_force(r, t, f - t->since);
    }
    if (nvram != NULL && !is_faulty(r)) {
        uint32_t changed;
        const uint8_t *image = board_nvram(r->guard.board, size, &changed);
        *nvram = malloc(*size + 1);
        if (*nvram != NULL)
            memcpy(*nvram, image, *size);
    }
    check_run_finish(r);
}

static void tour(struct run *r, const char *what, enum tour_kind kind, const struct board_start *start)
{
    unsigned before;

    do {
        struct tour t = { .kind = kind, .start = *start };
        before = r->faulting_forces;
        play_tour(r, what, &t, NULL, NULL);
    } while (r->faulting_forces != before);
}

/* Opens each entry of the title menu, for the game's own screens. A menu wraps around, so entries of a short menu are
 * opened more than once. */
static void open_entries(struct run *r, const struct board_start *start)
{
    char what[32];

    for (int i = 1; i <= ENTRIES; i++) {
        struct tour t = { .kind = TOUR_ENTRY, .start = *start, .entry = i };
        snprintf(what, sizeof what, "menu entry %d", i + 1);
        play_tour(r, what, &t, NULL, NULL);
    }
}

/* Wins a game, and then plays its menus with the nvram of that game: scores, spells, unlocks. */
static void play_won_game(struct run *r)
{
    struct tour won = { .kind = TOUR_WON, .start = check_run_start(r) };
    uint8_t *nvram = NULL;
    size_t size = 0;

    play_tour(r, "a won game", &won, &nvram, &size);
    struct board_start start = check_run_start(r);
    start.nvram = nvram;
    start.nvram_size = nvram != NULL ? size : 0;
    tour(r, "the menus after a game", TOUR_MENUS, &start);
    open_entries(r, &start);
    free(nvram);
}

/* ---- all ---- */

/* An iteration over all runs. */
struct run_iterator {
    struct run *r;
    int n;     /* runs so far */
    bool play; /* play them; otherwise only count */
};

/* Counts a run; returns whether to play it. */
static bool count_run(struct run_iterator *e)
{
    e->n++;
    return e->play;
}

static void each_ship(struct run_iterator *e)
{
    const struct sections *s = e->r->sections;
    const int ships = s->ships > 0 ? s->ships : 1;

    for (int d = 0; d < count_difficulties(e->r) && first_stage(s) != NULL; d++)
        for (int k = 0; k < ships; k++)
            if (count_run(e))
                play_ship(e->r, k, d);
}

/* Plays sections at the first and the last difficulty, which differ most from the default. */
static void each_section(struct run_iterator *e)
{
    const struct sections *s = e->r->sections;
    const int last = count_difficulties(e->r) - 1;

    for (int d = 0; d <= last; d += last > 0 ? last : 1)
        for (int i = 0; i < s->n; i++)
            if (d != e->r->cart.manifest.difficulty && check_run_plays(&s->section[i]) && count_run(e))
                play_section(e->r, i, d);
}

static void each_game(struct run_iterator *e)
{
    char what[128];

    for (int d = 0; d < count_difficulties(e->r); d++) {
        struct board_start start = check_run_start(e->r);
        start.difficulty = e->r->cart.manifest.n_difficulties > 0 ? d : -1;
        const char *name = difficulty_name(e->r, d);
        snprintf(what, sizeof what, "a lost game%s%s", name[0] ? ", " : "", name);
        if (count_run(e))
            tour(e->r, what, TOUR_LOST, &start);
    }
    const struct board_start start = check_run_start(e->r);
    if (e->r->cart.manifest.players > 1 && count_run(e))
        tour(e->r, "a two-player game", TOUR_TWO, &start);
    if (count_run(e))
        play_won_game(e->r);
}

static void each_language(struct run_iterator *e)
{
    const struct cart *cart = &e->r->cart;
    char what[128];

    for (int i = 0; i < cart->count[CART_LANGS]; i++) {
        struct board_start start = check_run_start(e->r);
        snprintf(start.lang, sizeof start.lang, "%s", cart_name(cart, CART_LANGS, i));
        snprintf(what, sizeof what, "a game in language %s", start.lang);
        if (count_run(e))
            tour(e->r, what, TOUR_START, &start);
    }
}

/* Plays each value of a DIP switch; of a number, the minimum and the maximum. */
static void each_switch(struct run_iterator *e)
{
    const struct manifest *m = &e->r->cart.manifest;
    char what[128];

    for (int i = 0; i < m->n_dips; i++) {
        const struct dip *dip = &m->dips[i];
        for (int k = 0; k < (dip->is_number ? 2 : dip->n_values); k++) {
            struct board_start start = check_run_start(e->r);
            start.dip[i] = dip->is_number ? (k ? dip->hi : dip->lo) : k;
            snprintf(what, sizeof what, "a game with switch %s", dip->name);
            if (start.dip[i] != dip->default_value && count_run(e))
                tour(e->r, what, TOUR_START, &start);
        }
    }
}

static int visit_runs(struct run *r, bool go)
{
    struct run_iterator e = { r, 0, go };

    each_ship(&e);
    each_game(&e);
    each_language(&e);
    each_switch(&e);
    each_section(&e);
    return e.n;
}

int check_forced_count(struct run *r)
{
    return visit_runs(r, false);
}

int check_forced_play(struct run *r)
{
    return visit_runs(r, true);
}
