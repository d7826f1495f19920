/*
 * screen_resume.c - the question when a game starts whose last run was left: to go on with it, or to begin anew. Who
 * answers neither is asked again the next time, unless another run has begun by then. Enter goes on, but begins anew in
 * a folder that was changed.
 */
#include <inttypes.h>
#include <stdio.h>
#include <string.h>
#include "../replays/roms.h"
#include "cab_parts.h"

enum { GO_ON, ANEW, ROWS };

static int rows(void *of)
{
    (void)of;
    return ROWS;
}

static void row(void *of, int at, struct screen_row *row)
{
    struct cab *cab = of;

    snprintf(row->label, sizeof row->label, "%s", at == GO_ON ? "Resume" : "New Game");
    snprintf(row->help, sizeof row->help, "%s",
             at == GO_ON ? "Replays the run to where you left off, then pauses."
                         : "Saves the unfinished run as a replay.");
    row->faint = at == GO_ON && !cab->left.can;
}

static const char *text(void *of)
{
    struct cab *cab = of;

    return cab->left.text;
}

static void accept(void *of, int at)
{
    struct cab *cab = of;

    screens_close_all(&cab->screens);
    if (at == GO_ON)
        cab_resume(cab);
    else
        cab_keep_left(cab);
}

static const struct screen_def question = {
    .title = "Unfinished Run", .small = true, .rows = rows, .row = row, .text = text, .accept = accept
};

/* "3:41, heron, 120300 points", and whether it can go on. */
static void describe(struct cab *cab, const struct replay_meta *c)
{
    const struct rom *rom = cab_cart(cab)->rom;
    const unsigned seconds = (c->last - c->first) / 60;
    const bool same = c->rom == rom_hash(rom) || c->game == rom_game_hash(rom);
    int n = snprintf(cab->left.text, sizeof cab->left.text, "Play time: %u:%02u%s%s%s. ", seconds / 60, seconds % 60,
                     c->ship[0] ? ", ship: " : "", c->ship, c->flags & DEMO_RESUMED ? ", previously resumed" : "");
    char *more = cab->left.text + n;
    const size_t room = sizeof cab->left.text - (size_t)n;

    cab->left.changed = !same;
    cab->left.can = c->core == CORE_VERSION && (same || roms_has(c->id, c->rom));
    if (c->core != CORE_VERSION)
        snprintf(more, room, "Cannot resume: the run needs core version %u, but this program has version %d.",
                 (unsigned)c->core, CORE_VERSION);
    else if (!cab->left.can)
        snprintf(more, room, "Cannot resume: the game has changed and its old version is not stored.");
    else if (!same)
        snprintf(more, room, "The game has changed; the run resumes in the old version.");
}

/* Who changes a game's folder and plays it wants to see the change, which the run that was left does not show. */
static bool is_being_made(struct cab *cab)
{
    return cab->left.changed && cab->folder.seen != 0;
}

void cab_open_resume(struct cab *cab)
{
    const struct cab_options *o = &cab->options;
    const bool unasked = o->resume;
    struct replay_meta c;

    cab->options.resume = false; /* this once */
    if (o->demo || o->record || o->no_resume || cab->start.practice.section[0] || cab_fault(cab))
        return;
    if (!cab_was_left(cab, &c)) {
        if (unasked)
            cab_say(cab, "curtain: %s: --resume: no unfinished run", cab_game(cab));
        return;
    }
    if (unasked) {
        cab_resume(cab);
        return;
    }
    if (!cab->config.resume)
        return;
    describe(cab, &c);
    screens_open(&cab->screens, &question, cab);
    screens_choose(&cab->screens, cab->left.can && !is_being_made(cab) ? GO_ON : ANEW);
}
