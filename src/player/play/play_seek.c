/*
 * play_seek.c - moving in time, and taking over a playback.
 */
#include <stdio.h>
#include "../../../platform/platform.h"
#include "../../common/files.h"
#include "play_state.h"

enum { BAR_FRAMES = 120 /* that the time bar is shown after its last use */ };

void play_seek(struct play *play, uint32_t frame)
{
    const uint32_t first = session_first(&play->session);

    if (!play->session.demo && !play->session.rewound)
        play_save_nvram(play);
    if (frame < first)
        play_show_message(play, BAR_FRAMES, "Cannot go back before frame %d", (int)first);
    session_goto(&play->session, frame);
    practice_stop_counting(&play->practice);
    play->seek.used = true;
    play->report.fault_reported = play->report.fault_reported && play_fault(play);
    play->seek.bar_frames = BAR_FRAMES;
}

void play_rewind(struct play *play, uint32_t frames)
{
    uint32_t now = board_frame(play_board(play));
    play_seek(play, now > frames ? now - frames : 0);
}

/* Records from here in the file of --record, or in a new one. */
static void take_over_and_record(struct play *play)
{
    char shown[FILES_PATH_SIZE], *new_name = play->seek.recording;
    const char *given = play->options.record;

    play_unused_name(play, new_name, "", "demo");
    play_check_recording(play, session_take_over(&play->session, given ? given : new_name));
    if (given || !plat_path(new_name, shown, sizeof shown))
        snprintf(shown, sizeof shown, "%s", given ? given : new_name);
    play_show_message(play, MESSAGE_FRAMES, "You are playing from here. Recording: %s", shown);
    play_log(play, "curtain: %s: You are playing from here. Recording: %s", play_game_name(play), shown);
}

void play_take_over(struct play *play)
{
    if (!play->session.demo) {
        play_show_message(play, MESSAGE_FRAMES, "Nothing to take over: you are already playing");
        return;
    }
    play->replay.taken_over = true;
    if (play->replay.watching) {
        play_check_recording(play, session_take_over(&play->session, NULL));
        play_show_message(play, MESSAGE_FRAMES, "Practice: nothing is saved");
    } else {
        take_over_and_record(play);
    }
    play->time.paused = false;
    play->seek.bar_frames = 0;
}
