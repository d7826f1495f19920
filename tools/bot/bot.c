/*
 * bot.c - plays a game by looking ahead, and records a demo of it: `bot ROM DEMO [option...]`.
 *
 *     --difficulty D  through the menus to a game of that difficulty, by its name,
 *     --ship NAME     with that kind of player; a second one is player 2's,
 *     --players 2     in two
 *     --form WORD     the ship is NAME_WORD
 *     --first STAGE   which begins with that stage
 *     --wait N        frames until the title is there (150), before anything is pressed
 *     --stage S       practice start instead of the title
 *     --frames N      stop after N frames (default 20000)
 *     --finish        stop two seconds after a score was entered into a table
 *     --seed N        seed
 *     --deaths N      let the first N bullets that come hit (a run with deaths in it)
 *     --lose SECONDS  dodge for so long, then no more, and do not continue
 *     --after DEMO    with the scores and what is unlocked at the end of that demo
 *     --prints WORD   auto, every, seconds: as curtain's option
 *     --quiet         no report
 *
 * What to press in menus is searched for (menus.c); in the game it looks ahead (pilot.c). So it sees what will happen,
 * but knows nothing of any particular game.
 */
#include "bot.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "../../platform/platform.h"
#include "../../src/machine/machine.h"
#include "../../src/demo/demo.h"
#include "../../src/workbench/pack/pack.h"
#include "../tally.h"

struct wanted {
    struct menus_wish wish;
    struct pilot pilot;
    const char *stage, *difficulty, *form, *after;
    uint32_t frames, wait;
    uint64_t seed;
    int prints, ships;
    bool quiet;
    char ship[MAX_PLAYERS][64];
};

void bot_fail(const char *what)
{
    fprintf(stderr, "bot: %s\n", what);
    exit(2);
}

enum simulation_end run_tick(struct run *r, const uint16_t pads[MAX_PLAYERS])
{
    const uint32_t frame = board_frame(r->t.b);

    if (frame < r->limit)
        memcpy(r->pads[frame], pads, sizeof r->pads[0]);
    return simulation_tick(&r->t, pads);
}

static int index_of(const char *word, const char *const *list)
{
    for (int i = 0; list[i]; i++)
        if (!strcmp(word, list[i]))
            return i;
    bot_fail(word);
}

/* Takes an option; returns how many words it is. */
static int take(struct wanted *w, char **argv, const char *more)
{
    const char *word = argv[0];

    if (!strcmp(word, "--finish"))
        return w->pilot.finish = true;
    if (!strcmp(word, "--quiet"))
        return w->quiet = true;
    if (!more)
        bot_fail(word);
    if (!strcmp(word, "--frames"))
        w->frames = (uint32_t)atoi(more);
    else if (!strcmp(word, "--stage"))
        w->stage = more;
    else if (!strcmp(word, "--first"))
        w->wish.first = more;
    else if (!strcmp(word, "--wait"))
        w->wait = (uint32_t)atoi(more);
    else if (!strcmp(word, "--seed"))
        w->seed = (uint64_t)atoll(more);
    else if (!strcmp(word, "--lose"))
        w->pilot.lose = atoi(more);
    else if (!strcmp(word, "--after"))
        w->after = more;
    else if (!strcmp(word, "--deaths"))
        w->pilot.deaths = atoi(more);
    else if (!strcmp(word, "--difficulty"))
        w->difficulty = more;
    else if (!strcmp(word, "--form"))
        w->form = more;
    else if (!strcmp(word, "--players"))
        w->wish.players = atoi(more);
    else if (!strcmp(word, "--prints"))
        w->prints = index_of(more, demo_checksum_rate_names);
    else if (!strcmp(word, "--ship") && w->ships < MAX_PLAYERS)
        snprintf(w->ship[w->ships++], sizeof w->ship[0], "%s", more);
    else
        bot_fail(word);
    return 2;
}

static void wish(struct wanted *w, const struct manifest *m)
{
    w->wish.difficulty = -1;
    for (int i = 0; w->difficulty && i < m->n_difficulties; i++)
        if (!strcmp(m->difficulties[i], w->difficulty))
            w->wish.difficulty = i;
    if (w->difficulty && w->wish.difficulty < 0)
        bot_fail("the game has no such difficulty");
    for (int p = 0; p < w->ships; p++) {
        const size_t n = strlen(w->ship[p]);
        if (w->form)
            snprintf(w->ship[p] + n, sizeof w->ship[p] - n, "_%s", w->form);
        w->wish.ship[p] = w->ship[p];
    }
}

/* What a demo leaves in nvram becomes that of the start. */
static void take_nvram(struct run *r, const struct rom *rom, const char *path)
{
    struct simulation t;
    struct demo d;
    char err[512];
    size_t size;

    if (!demo_load(&d, path, err, sizeof err) || !demo_check_cart(&d, r->cart, err, sizeof err) ||
        !simulation_open(&t, rom, &d.start, err, sizeof err))
        bot_fail(err);
    for (uint32_t f = 0; f < d.frames; f++)
        simulation_tick(&t, d.pads[f]);
    const uint8_t *nvram = board_nvram(t.b, &size, &(uint32_t){ 0 });
    uint8_t *copy = malloc(size + 1);
    if (!copy)
        bot_fail("out of memory");
    memcpy(copy, nvram, size);
    r->start.nvram = copy;
    r->start.nvram_size = size;
    simulation_close(&t);
    demo_free(&d);
}

/* From power-on once more, into the demo; and what happens in it. */
static void record(struct run *r, const char *path, int prints, struct tally *t)
{
    struct demo_writer w = { 0 };
    char err[256];

    if (!simulation_restart(&r->t, err, sizeof err))
        bot_fail(err);
    struct board *b = r->t.b;
    if (!demo_begin(&w, path, r->cart, b, &r->start, 0) || !demo_set_checksum_rate(&w, (enum demo_checksum_rate)prints))
        bot_fail(w.err);
    while (board_frame(b) < r->limit) {
        const uint16_t *pads = r->pads[board_frame(b)];
        tally_before(t, b);
        const struct board_out *out = board_tick(b, pads);
        if (!demo_record_frame(&w, b, pads))
            bot_fail(w.err);
        if (out->log_size && !r->quiet)
            printf("%6u  %.*s", board_frame(b), (int)out->log_size, out->log);
        if (out->fault)
            bot_fail(out->fault->message);
        tally_after(t, b);
    }
    if (!demo_end(&w, b))
        bot_fail(w.err);
    demo_free(&w.demo);
}

static void play(struct run *r, struct wanted *w)
{
    const bool wished = w->wish.difficulty >= 0 || w->ships || w->wish.players > 1;

    w->pilot.r = r;
    if (wished && !w->stage) {
        for (uint32_t f = 0; f < w->wait; f++)
            run_tick(r, (const uint16_t[MAX_PLAYERS]){ 0 });
        if (!menus_enter(r, &w->wish))
            bot_fail("no way through the menus was found to such a game");
    }
    pilot_play(&w->pilot);
}

int main(int argc, char **argv)
{
    struct wanted w = { .frames = 20000, .wait = 150, .seed = 1, .wish.players = 1 };
    struct run r = { .quiet = false };
    struct tally t = { 0 };
    struct rom_image image;
    struct cart cart;
    char err[256];

    if (argc < 3)
        bot_fail("usage: bot ROM DEMO [option...]");
    for (int i = 3; i < argc;)
        i += take(&w, argv + i, i + 1 < argc ? argv[i + 1] : NULL);
    if (!pack_load_game(argv[1], false, &image, err, sizeof err) || !cart_open(&cart, &image.rom, err, sizeof err))
        bot_fail(err);
    wish(&w, &cart.manifest);
    r.start = (struct board_start){ .difficulty = w.stage ? w.wish.difficulty : -1, .seed = w.seed };
    if (w.stage)
        snprintf(r.start.practice.section, sizeof r.start.practice.section, "%s", w.stage);
    for (int i = 0; i < cart.manifest.n_dips; i++)
        r.start.dip[i] = cart.manifest.dips[i].default_value;
    r.cart = &cart;
    if (w.after)
        take_nvram(&r, &image.rom, w.after);
    r.limit = w.frames;
    r.quiet = w.quiet;
    r.pads = calloc(w.frames + 1, sizeof *r.pads);
    if (!r.pads || !simulation_open(&r.t, &image.rom, &r.start, err, sizeof err))
        bot_fail(r.pads ? err : "out of memory");
    play(&r, &w);
    record(&r, argv[2], w.prints, &t);
    printf("%u frames, %llu bullets fired, at most %u at once, %llu kills, %llu grazes, %llu deaths; %u bombs, %u "
           "specials, %u times back\n",
           r.limit, (unsigned long long)t.fired, t.most, (unsigned long long)t.kills, (unsigned long long)t.grazes,
           (unsigned long long)t.deaths, w.pilot.bombs, w.pilot.specials, w.pilot.backs);
    return 0;
}
