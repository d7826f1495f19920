/*
 * screen_menu.c - the menu that Escape and START open: leaving a run, and all other screens. It asks before a run is
 * lost.
 */
#include <stdio.h>
#include <string.h>
#include "../../board/inspect.h"
#include "play_state.h"

enum entry {
    RESUME,
    WATCH_AGAIN,
    TAKE_OVER,
    QUIT_REPLAY,
    GAME, /* the game's own entries, a row each */
    RESTART_STAGE,
    RESTART,
    SETTINGS,
    PRACTICE,
    REPLAYS,
    LOG,
    TITLE,
    QUIT,
    ENTRIES
};

/* ---- leaving a run ---- */

/* Returns whether a run is in progress that restarts and ends by codes. */
static bool is_in_run(const struct play *play)
{
    return !play->session.demo && !play_fault(play) && inspect_pause(play_board(play)).is_listening;
}

/* Returns whether a page before or after a run is shown: the title, name entry. */
static bool is_on_page(const struct play *play)
{
    return !play->session.demo && !play_fault(play) && !play->autosave.on && !is_in_run(play) &&
           board_last_output(play_board(play))->key_hint_count > 0;
}

static bool is_practice(const struct play *play)
{
    return play->start.practice.section[0] != 0;
}

/* Returns whether the game that started last is a mission. */
static bool is_mission(const struct play *play)
{
    uint32_t n;
    const struct demo_marker *m = session_markers(&play->session, &n);
    bool is_mission = false;

    for (uint32_t i = 0; i < n && m[i].frame <= board_frame(play_board(play)); i++)
        if (m[i].marker.kind == MARKER_GAME || m[i].marker.kind == MARKER_MISSION)
            is_mission = m[i].marker.kind == MARKER_MISSION;
    return is_mission;
}

/* What leaving the run is called. */
static const char *quit_label(const struct play *play)
{
    return is_in_run(play) && is_mission(play) ? "Back to Missions" : "Quit to Title";
}

static void leave_run(void *context)
{
    struct play *play = context;

    if (!is_in_run(play) || is_practice(play)) {
        play_restart(play);
        return;
    }
    screens_close_all(&play->screens);
    play_send_code(play, 0, CODE_QUIT);
}

/* Asks first if a run would be lost. */
static void quit_to_title(struct play *play)
{
    const bool is_saved = play->autosave.on && play->config.replays > 0;

    if (play_has_run(play))
        screens_ask(&play->screens, is_saved ? "Quit? A replay of this run is saved." : "Quit and lose this run?",
                    quit_label(play), leave_run, play);
    else
        leave_run(play);
}

static void quit_now(void *context)
{
    ((struct play *)context)->quit = true;
}

void play_quit(struct play *play)
{
    screens_ask(&play->screens,
                !play_has_run(play)       ? "Quit the game?"
                : play_is_resumable(play) ? "Quit? You can resume this run next time."
                                          : "Quit and lose this run?",
                "Quit Game", quit_now, play);
}

/* ---- restarting ---- */

/* Returns the frame in which the present stage started, if that is not the run's first stage and can be reached;
 * otherwise 0. */
static uint32_t stage_start(const struct play *play)
{
    const uint32_t now = board_frame(play_board(play));
    uint32_t n, stages = 0, frame = 0;
    const struct demo_marker *m = session_markers(&play->session, &n);

    for (uint32_t i = 0; i < n && m[i].frame <= now; i++) {
        if (m[i].marker.kind == MARKER_GAME)
            stages = 0;
        else if (m[i].marker.kind == MARKER_STAGE && ++stages)
            frame = m[i].frame;
    }
    return stages > 1 && frame >= session_first(&play->session) ? frame : 0;
}

static void restart_stage(struct play *play)
{
    play_seek(play, stage_start(play));
    play->seek.bar_frames = 0;
}

static void restart(struct play *play)
{
    if (is_practice(play))
        play_retry_practice(play);
    else
        play_send_code(play, 0, CODE_RESTART);
}

/* ---- replays ---- */

/* Returns whether a replay that was opened from the list has been shown to its end. */
static bool has_replay_ended(const struct play *play)
{
    return play->replay.watching && play_is_at_end(play);
}

static void watch_again(struct play *play)
{
    play->time.paused = false;
    session_goto(&play->session, play->replay.first);
}

/* Goes back to the list, which is then over the title. */
void play_quit_replay(void *context)
{
    struct play *play = context;

    screens_close_all(&play->screens);
    play_return_to_title(play);
    play_open_replays(play);
}

static void quit_replay(struct play *play)
{
    play_quit_replay(play);
}

/* ---- entries ---- */

static const struct {
    const char *label, *help;
    bool closes; /* the menu, before the action */
    void (*action)(struct play *play);
} entries[ENTRIES] = {
    [RESUME] = { "Resume", "Continue from here.", true, NULL },
    [WATCH_AGAIN] = { "Watch Again", "Show the replay from its start.", true, watch_again },
    [TAKE_OVER] = { "Play from Here", "Play on from this frame.", true, play_take_over },
    [QUIT_REPLAY] = { "Quit Replay", "End the replay and return to the list.", true, quit_replay },
    [GAME] = { "", "An action of this game.", true, NULL },
    [RESTART_STAGE] = { "Restart Stage", "The run then no longer counts for scores.", true, restart_stage },
    [RESTART] = { "Restart", "Start again with the same choices.", true, restart },
    [SETTINGS] = { "Settings", "Picture, sound, keys and more.", false, play_open_settings },
    [PRACTICE] = { "Practice", "Practise any part that you have reached.", false, play_open_practice },
    [REPLAYS] = { "Replays", "Watch your recent runs.", false, play_open_replays },
    [LOG] = { "Log", "Script output and errors.", false, play_open_log },
    [TITLE] = { "", "End this run.", false, quit_to_title },
    [QUIT] = { "Quit Game", "Close the game.", false, play_quit },
};

/* Returns the number of rows that an entry has now. */
static int row_count(const struct play *play, enum entry e)
{
    const bool playback = play->session.demo != NULL, watching = play->replay.watching, in_run = is_in_run(play);

    switch (e) {
    case RESUME:
        return !has_replay_ended(play);
    case WATCH_AGAIN:
        return has_replay_ended(play);
    case TAKE_OVER:
        return playback && !has_replay_ended(play);
    case QUIT_REPLAY:
        return watching;
    case GAME:
        return in_run ? inspect_pause(play_board(play)).entry_count : 0;
    case RESTART_STAGE:
        return in_run && !is_practice(play) && stage_start(play) > 0;
    case RESTART:
        return in_run;
    case PRACTICE:
        return !playback && !is_on_page(play);
    case REPLAYS:
        return !playback && !is_on_page(play) && !play->options.demo && !play->options.record;
    case LOG:
        return !playback && !in_run && play->options.open;
    case TITLE:
        return !playback && !watching && (play_fault(play) || play_has_run(play));
    default:
        return 1;
    }
}

/* Returns the entry of a row, and the row's number within it in *i; ENTRIES: there are fewer rows. */
static enum entry entry_at(const struct play *play, int at, int *i)
{
    enum entry e = RESUME;

    for (int n; e < ENTRIES && at >= (n = row_count(play, e)); e++)
        at -= n;
    *i = at;
    return e;
}

static int rows(void *context)
{
    int n = 0;

    for (enum entry e = RESUME; e < ENTRIES; e++)
        n += row_count(context, e);
    return n;
}

static void row(void *context, int at, struct screen_row *row)
{
    const struct play *play = context;
    int i;
    const enum entry e = entry_at(play, at, &i);
    const char *label = entries[e].label, *help = entries[e].help;

    if (e == RESUME && is_on_page(play)) {
        label = "Back";
        help = "Close this menu.";
    } else if (e == RESTART && is_practice(play)) {
        label = "Restart Section";
        help = "Start this section again.";
    } else if (e == TITLE) {
        label = quit_label(play);
    } else if (e == GAME) {
        label = inspect_pause(play_board(play)).entries[i];
    }
    snprintf(row->label, sizeof row->label, "%s", label);
    snprintf(row->help, sizeof row->help, "%s", help);
}

static void accept(void *context, int at)
{
    struct play *play = context;
    int i;
    const enum entry e = entry_at(play, at, &i);

    if (entries[e].closes)
        screens_close_all(&play->screens);
    if (e == GAME)
        play_send_code(play, 0, CODE_ENTRY + (unsigned)i);
    else if (entries[e].action)
        entries[e].action(play);
}

#define MENU(title_, back_)                                                                                            \
    {                                                                                                                  \
        .title = (title_), .small = true, .rows = rows, .row = row, .accept = accept, .back = (back_)                  \
    }
static const struct screen_def pause_menu = MENU("Paused", NULL), page_menu = MENU("Menu", NULL),
                               end_menu = MENU("Replay Ended", play_quit_replay);
#undef MENU

void play_open_menu(struct play *play)
{
    attract_end(&play->attract);
    if (has_replay_ended(play))
        screens_open(&play->screens, &end_menu, play);
    else
        screens_open(&play->screens, is_on_page(play) ? &page_menu : &pause_menu, play);
}

bool play_page_leads_back(const struct play *play)
{
    return board_last_output(play_board(play))->back && !play->session.demo && !play->attract.on;
}

bool play_has_run(const struct play *play)
{
    return !play->session.demo && !play_fault(play) && board_frame(play_board(play)) > 0 && !is_on_page(play);
}

void play_open_log(struct play *play)
{
    attract_end(&play->attract);
    log_open(&play->log, &play->screens);
}
