/*
 * screen_menu.c - the small menu that Escape opens: the way to all other screens, and out. It never throws a run away
 * unasked.
 */
#include <stdio.h>
#include <string.h>
#include "cab_parts.h"

enum entry { GO_ON, PLAY_ON, BACK, REPLAYS, SETTINGS, KEYS, CONTROLLERS, PRACTICE, LOG, ANEW, LEAVE, ENTRIES };

/* The entries that there are, in their order; returns how many. */
static int entries(struct cab *cab, enum entry list[ENTRIES])
{
    int n = 0;

    for (int e = 0; e < ENTRIES; e++) {
        const bool playback = cab->session.demo != NULL;
        const bool watched = cab->guest.watching, bound = cab->options.demo || cab->options.record;
        if (e == PLAY_ON                 ? playback
            : e == BACK                  ? watched
            : e == REPLAYS               ? !bound
            : e == PRACTICE || e == ANEW ? !playback && !watched
                                         : true)
            list[n++] = (enum entry)e;
    }
    return n;
}

static enum entry entry_at(struct cab *cab, int at)
{
    enum entry list[ENTRIES];

    entries(cab, list);
    return list[at];
}

static int rows(void *of)
{
    struct cab *cab = of;
    enum entry list[ENTRIES];

    return entries(cab, list);
}

static void row(void *of, int at, struct screen_row *row)
{
    struct cab *cab = of;
    static const char *const labels[] = { "go on", "play on from here", "back to the game", "replays", "settings",
                                          "keys",  "controllers",       "practice",         "log",     "begin anew",
                                          "leave" };
    static const char *const helps[] = {
        "",
        "from this frame on it is you who plays: for practice, or with a recording of your own",
        "the replay ends, and the game begins at its title",
        "the last runs: to watch, to save, to practise from any moment",
        "picture, sound, how you play",
        "every key and button, and what it does",
        "who plays with which, and what is pressed on it",
        "any stage, mark or phase by itself, as often as you like",
        "what the game's scripts printed, and what went wrong",
        "this run ends, and the game begins at its title",
        "",
    };
    const enum entry e = entry_at(cab, at);

    snprintf(row->label, sizeof row->label, "%s", labels[e]);
    snprintf(row->help, sizeof row->help, "%s", helps[e]);
}

static void leave(void *of)
{
    struct cab *cab = of;

    cab->quit = true;
}

static void begin_anew(void *of)
{
    struct cab *cab = of;

    screens_close_all(&cab->screens);
    cab_begin_anew(cab);
}

static void accept(void *of, int at)
{
    struct cab *cab = of;

    switch (entry_at(cab, at)) {
    case GO_ON:
        screens_close_all(&cab->screens);
        break;
    case PLAY_ON:
        screens_close_all(&cab->screens);
        cab_take_over(cab);
        break;
    case BACK:
        screens_close_all(&cab->screens);
        cab_home(cab);
        break;
    case REPLAYS:
        cab_open_replays(cab);
        break;
    case SETTINGS:
        cab_open_settings(cab);
        break;
    case KEYS:
        cab_open_keys(cab);
        break;
    case CONTROLLERS:
        cab_open_controllers(cab);
        break;
    case PRACTICE:
        screens_close_all(&cab->screens);
        cab_open_practice(cab);
        break;
    case LOG:
        cab_open_log(cab);
        break;
    case ANEW:
        if (cab_run_is_on(cab))
            screens_ask(&cab->screens,
                        cab->keep.on && cab->config.replays > 0
                            ? "The run that is on ends here. It stays among the replays."
                            : "The run that is on ends, and is lost.",
                        "begin anew", begin_anew, cab);
        else
            begin_anew(cab);
        break;
    default:
        if (cab_run_is_on(cab))
            screens_ask(&cab->screens,
                        cab->keep.on && cab->keep.spare ? "A run is on. It is kept: next time you can go on with it."
                                                        : "A run is on. Leave it, and lose it?",
                        "leave", leave, cab);
        else
            leave(cab);
    }
}

static const struct screen_def menu = { .title = "menu", .small = true, .rows = rows, .row = row, .accept = accept };

void cab_open_menu(struct cab *cab)
{
    if (cab->attracting)
        cab_attract_end(cab);
    screens_open(&cab->screens, &menu, cab);
}
