/*
 * screen_resume.c - at the start of a game: resume the unfinished run, or start a new game? If the player answers
 * neither, the question is asked again the next time, unless another run has started by then. Enter resumes, but starts
 * a new game in a folder that has changed.
 */
#include <stdio.h>
#include <string.h>
#include "../replays/roms.h"
#include "play_state.h"

enum { RESUME, NEW_GAME, ROWS };

static int rows(void *context)
{
    (void)context;
    return ROWS;
}

static void row(void *context, int at, struct screen_row *row)
{
    struct play *play = context;

    snprintf(row->label, sizeof row->label, "%s", at == RESUME ? "Resume" : "New Game");
    snprintf(row->help, sizeof row->help, "%s",
             at == RESUME ? "Continue where you left off." : "The unfinished run stays as a replay.");
    row->disabled = at == RESUME && !play->resume_offer.possible;
}

static const char *text(void *context)
{
    return ((struct play *)context)->resume_offer.text;
}

static void accept(void *context, int at)
{
    struct play *play = context;

    screens_close_all(&play->screens);
    if (at == RESUME)
        play_resume(play);
    else
        play_archive_unfinished(play);
}

static const struct screen_def question = {
    .title = "Unfinished Run", .small = true, .rows = rows, .row = row, .text = text, .accept = accept
};

/* Adds a line to the text. format: as for screens_format. */
static void add_line(struct play *play, const char *format, const char *name)
{
    char *text = play->resume_offer.text;
    const size_t n = strlen(text), size = sizeof play->resume_offer.text;

    if (n + 2 < size) {
        text[n] = '\n';
        screens_format(&play->screens, text + n + 1, size - n - 1, format, name);
    }
}

/* The run's time, stage and ship, and whether it can be resumed. */
static void describe(struct play *play, const struct replay_meta *c)
{
    struct resume_offer *o = &play->resume_offer;
    const struct rom *rom = play_cart(play)->rom;
    const struct sections *s = practice_sections(&play->practice);
    const unsigned seconds = (c->last - c->first) / 60;
    const bool same = c->rom == rom_hash(rom) || c->game == rom_game_hash(rom);

    o->changed = !same;
    o->possible = c->core == CORE_VERSION && (same || roms_has(c->id, c->rom));
    snprintf(o->text, sizeof o->text, "Play time: %u:%02u", seconds / 60, seconds % 60);
    if (c->stage[0])
        add_line(play, "%s", sections_title(s, MARKER_STAGE, c->stage));
    if (c->ship[0])
        add_line(play, "Ship: %s", sections_title(s, MARKER_SHIP, c->ship));
    if (c->flags & DEMO_RESUMED)
        add_line(play, "%s", "Resumed before.");
    if (c->core != CORE_VERSION)
        add_line(play, "%s", "Cannot resume: the run needs another version of this program.");
    else if (!o->possible)
        add_line(play, "%s", "Cannot resume: the game has changed and its old version is not stored.");
    else if (!same)
        add_line(play, "%s", "The game has changed; the run resumes in the old version.");
}

void play_offer_resume(struct play *play)
{
    const struct play_options *o = &play->options;
    struct resume_offer *offer = &play->resume_offer;
    const bool resume = o->resume;
    struct replay_meta c;

    play->options.resume = false; /* only the first time */
    if (o->demo || o->record || o->no_resume || play->start.practice.section[0] || play_fault(play))
        return;
    if (!play_find_unfinished(play, &c)) {
        if (resume)
            play_log(play, "curtain: %s: --resume: no unfinished run", play_game_name(play));
        return;
    }
    if (resume) {
        play_resume(play);
        return;
    }
    if (!play->config.resume)
        return;
    play_translate_screens(play);
    describe(play, &c);
    screens_open(&play->screens, &question, play);
    /* an author who has changed the game's folder wants to see the change */
    const bool author = offer->changed && play->reload.folder.seen != 0;
    screens_choose(&play->screens, offer->possible && !author ? RESUME : NEW_GAME);
}
