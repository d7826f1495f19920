/*
 * screen_menu.c - the menu that Escape opens: all other screens, and quitting. It asks before a run is lost.
 */
#include <stdio.h>
#include <string.h>
#include "play_state.h"

enum entry {
    RESUME,
    TAKE_OVER,
    QUIT_REPLAY,
    REPLAYS,
    SETTINGS,
    KEYS,
    CONTROLLERS,
    PRACTICE,
    LOG,
    TITLE,
    QUIT,
    ENTRIES
};

/* ---- leaving a run ---- */

/* Asks first if a run would be lost. */
static void end_run(struct play *play, const char *question, const char *yes, void (*then)(void *context))
{
    if (play_has_run(play))
        screens_ask(&play->screens, question, yes, then, play);
    else
        then(play);
}

static void quit_to_title(struct play *play)
{
    end_run(play,
            play->autosave.on && play->config.replays > 0 ? "Quit to the title? This run is saved as a replay."
                                                          : "Quit to the title and lose this run?",
            "Quit to Title", play_restart);
}

static void quit_now(void *context)
{
    ((struct play *)context)->quit = true;
}

void play_quit(struct play *play)
{
    end_run(play,
            play->autosave.on && play->autosave.resumable ? "Quit? You can resume this run next time."
                                                          : "Quit and lose this run?",
            "Quit", quit_now);
}

/* ---- entries ---- */

static const struct {
    const char *label, *help;
    bool closes; /* the menu, before the action */
    void (*action)(struct play *play);
} entries[ENTRIES] = {
    [RESUME] = { "Resume", "", true, NULL },
    [TAKE_OVER] = { "Play from Here", "Take over: practise from this frame, or record a new demo.", true,
                    play_take_over },
    [QUIT_REPLAY] = { "Quit Replay", "End the replay and return to the title.", true, play_return_to_title },
    [REPLAYS] = { "Replays", "Watch or save recent runs, or practise from any frame.", false, play_open_replays },
    [SETTINGS] = { "Settings", "Picture, sound and gameplay.", false, play_open_settings },
    [KEYS] = { "Key Bindings", "Change what each key and button does.", false, play_open_keys },
    [CONTROLLERS] = { "Controllers", "Choose which player uses which controller.", false, play_open_controllers },
    [PRACTICE] = { "Practice", "Practise any stage, mark or boss phase.", true, play_open_practice },
    [LOG] = { "Log", "Script output and errors.", false, play_open_log },
    [TITLE] = { "Quit to Title", "End this run and return to the title.", false, quit_to_title },
    [QUIT] = { "Quit", "", false, play_quit },
};

static bool is_shown(const struct play *play, enum entry e)
{
    const bool playback = play->session.demo != NULL, watching = play->replay.watching;

    switch (e) {
    case TAKE_OVER:
        return playback;
    case QUIT_REPLAY:
        return watching;
    case REPLAYS:
        return !play->options.demo && !play->options.record;
    case PRACTICE:
    case TITLE:
        return !playback && !watching;
    default:
        return true;
    }
}

/* The entry of a row; ENTRIES: there are fewer rows. */
static enum entry entry_at(const struct play *play, int at)
{
    enum entry e = RESUME;

    while (e < ENTRIES && (!is_shown(play, e) || at-- > 0))
        e++;
    return e;
}

static int rows(void *context)
{
    int n = 0;

    while (entry_at(context, n) < ENTRIES)
        n++;
    return n;
}

static void row(void *context, int at, struct screen_row *row)
{
    const enum entry e = entry_at(context, at);

    snprintf(row->label, sizeof row->label, "%s", entries[e].label);
    snprintf(row->help, sizeof row->help, "%s", entries[e].help);
}

static void accept(void *context, int at)
{
    struct play *play = context;
    const enum entry e = entry_at(play, at);

    if (entries[e].closes)
        screens_close_all(&play->screens);
    if (entries[e].action)
        entries[e].action(play);
}

static const struct screen_def menu = { .title = "Menu", .small = true, .rows = rows, .row = row, .accept = accept };

void play_open_menu(struct play *play)
{
    attract_end(&play->attract);
    screens_open(&play->screens, &menu, play);
}

bool play_has_run(const struct play *play)
{
    const bool in_menu = board_last_output(play_board(play))->menu_shown && !play->autosave.on;

    return !play->session.demo && !play_fault(play) && board_frame(play_board(play)) > 0 && !in_menu;
}

void play_open_log(struct play *play)
{
    attract_end(&play->attract);
    log_open(&play->log, &play->screens);
}
