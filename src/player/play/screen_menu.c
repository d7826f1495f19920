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
    static const char *const labels[] = { "Resume",   "Play from Here", "Quit Replay", "Replays",
                                          "Settings", "Key Bindings",   "Controllers", "Practice",
                                          "Log",      "Quit to Title",  "Quit" };
    static const char *const helps[] = {
        "",
        "Take over: practise from this frame, or record a new demo.",
        "End the replay and return to the title.",
        "Watch or save recent runs, or practise from any frame.",
        "Picture, sound and gameplay.",
        "Change what each key and button does.",
        "Choose which player uses which controller.",
        "Practise any stage, mark or boss phase.",
        "Script output and errors.",
        "End this run and return to the title.",
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
                        cab->keep.on && cab->config.replays > 0 ? "Quit to the title? This run is saved as a replay."
                                                                : "Quit to the title and lose this run?",
                        "Quit to Title", begin_anew, cab);
        else
            begin_anew(cab);
        break;
    default:
        if (cab_run_is_on(cab))
            screens_ask(&cab->screens,
                        cab->keep.on && cab->keep.spare ? "Quit? You can resume this run next time."
                                                        : "Quit and lose this run?",
                        "Quit", leave, cab);
        else
            leave(cab);
    }
}

static const struct screen_def menu = { .title = "Menu", .small = true, .rows = rows, .row = row, .accept = accept };

void cab_open_menu(struct cab *cab)
{
    if (cab->attracting)
        cab_attract_end(cab);
    screens_open(&cab->screens, &menu, cab);
}

bool cab_run_is_on(const struct cab *cab)
{
    const bool in_menu = board_last_output(cab_live(cab))->menu_shown && !cab->keep.on;

    return !cab->session.demo && !cab_fault(cab) && board_frame(cab_live(cab)) > 0 && !in_menu;
}

void cab_open_log(struct cab *cab)
{
    if (cab->attracting)
        cab_attract_end(cab);
    log_open(&cab->log, &cab->screens);
}
