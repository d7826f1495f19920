/*
 * play_keys.c - the effect of each hotkey, and the buttons that reach the game.
 */
#include <stdio.h>
#include <string.h>
#include "../../board/inspect.h"
#include "play_state.h"
#include "timebar.h"

enum { MIN_SPEED = 25, VOLUME_STEP = 10 /* percent */ };

/* ---- keys ---- */

/* The sound card is opened when there is something to hear. */
static void set_sound(struct play *play, bool muted, int volume)
{
    play->speaker.muted = muted;
    play->speaker.volume = volume < 0 ? 0 : volume > 100 ? 100 : volume;
    if (!board_has_sound(play_board(play)))
        play_show_message(play, MESSAGE_FRAMES / 2, "This game has no sound");
    else if (muted)
        play_show_message(play, MESSAGE_FRAMES / 2, "Sound off");
    else
        play_show_message(play, MESSAGE_FRAMES / 2, "Volume %d%%", play->speaker.volume);
    if (!muted && !play->window.config.sound_rate)
        play_update_window(play);
}

/* The keys that also work while a screen is open. */
static void global_keys(struct play *play, const struct keys_state *k)
{
    const struct speaker *s = &play->speaker;

    if (keys_pressed(k, HOTKEY_QUIT))
        play->quit = true;
    if (keys_pressed(k, HOTKEY_FULLSCREEN))
        play_toggle_fullscreen(play);
    if (keys_pressed(k, HOTKEY_SCREENSHOT))
        play_screenshot(play, &play->drawing.picture);
    if (keys_pressed(k, HOTKEY_SAVE_CLIP))
        play_request_clip(play);
    if (keys_pressed(k, HOTKEY_MUTE))
        set_sound(play, !s->muted, s->volume);
    if (keys_pressed(k, HOTKEY_QUIETER))
        set_sound(play, s->muted, s->volume - VOLUME_STEP);
    if (keys_pressed(k, HOTKEY_LOUDER))
        set_sound(play, false, s->volume + VOLUME_STEP);
}

static void speed_keys(struct play *play, const struct keys_state *k)
{
    struct play_time *time = &play->time;

    if (keys_pressed(k, HOTKEY_PAUSE))
        time->paused = !time->paused;
    if (keys_pressed(k, HOTKEY_FRAME_ADVANCE))
        time->paused = time->step = true;
    if (keys_pressed(k, HOTKEY_SLOW))
        play_set_speed(play, time->speed / 2 >= MIN_SPEED ? time->speed / 2 : PLAY_FULL_SPEED);
}

/* The keys that move in time. */
static void seek_keys(struct play *play, const struct plat_input *in, const struct keys_state *k)
{
    const struct session *s = &play->session;
    uint32_t now = s->state == SESSION_SEEKING
                       ? s->to
                       : board_frame(play_board(play)); /* a second press counts from the target of the first */

    if (play->attract.on)
        return;
    if (keys_pressed(k, HOTKEY_FRAME_BACK)) {
        play->time.paused = true;
        play_rewind(play, 1);
    }
    if (keys_pressed(k, HOTKEY_PREVIOUS_EVENT))
        play_seek(play, timebar_previous(s, now));
    if (keys_pressed(k, HOTKEY_NEXT_EVENT))
        play_seek(play, timebar_next(s, now));
    if (keys_pressed(k, HOTKEY_TAKE_OVER))
        play_take_over(play);
    if (keys_pressed(k, HOTKEY_RELOAD))
        play_reload(play);
    if (keys_pressed(k, HOTKEY_GOTO))
        prompt_open(&play->prompt, in);
}

/* In a playback, and while the time bar is shown, a click on it moves to that frame. */
static void time_bar_mouse(struct play *play, const struct plat_input *in)
{
    const struct fb *fb = &play->drawing.picture.fb;
    uint32_t frame;
    bool held = in->mouse_buttons & 1, pressed = held && !play->mouse.held;

    play->mouse.held = held;
    if (play->attract.on || play->console.open || !(play->session.demo || play_timebar_shown(play)) ||
        !timebar_frame_at(&play->session, fb->w, fb->h, in->mouse_x, in->mouse_y, &frame))
        return;
    play->seek.bar_frames = play->seek.bar_frames ? play->seek.bar_frames : 1;
    if (pressed || (held && play->session.state == SESSION_PLAYING && frame != board_frame(play_board(play))))
        play_seek(play, frame);
}

/* Returns true while the prompt is open: it gets all keys, and the board doesn't tick. */
static bool prompt_keys(struct play *play, const struct plat_input *in)
{
    uint32_t frame;

    if (!play->prompt.open)
        return false;
    if (prompt_poll(&play->prompt, in, &frame)) {
        play->time.paused = true;
        play_seek(play, frame);
    }
    return true;
}

/* An open console gets all keys. Scores are saved before a line can change them. */
static void console_keys(struct play *play, const struct plat_input *in, struct keys_state *k)
{
    bool usable = !play_fault(play) && !play->attract.on && play->session.state == SESSION_PLAYING;

    if (keys_pressed(k, HOTKEY_CONSOLE))
        play_save_nvram(play);
    console_poll(&play->console, in, k, usable ? play_board(play) : NULL, !play->session.demo);
    if (console_take_kept(&play->console)) {
        play_check_recording(play, session_mark_touched(&play->session));
        practice_stop_counting(&play->practice);
    }
    play_set_text_input(play, play->console.open || play_typist(play) >= 0);
}

/* ---- the frame's input ---- */

/* During a run, START of a player whose ship is in play opens the menu, and the game doesn't see it; in a playback,
 * that of any player. opens: false if the press has resumed a paused game. */
static void take_start(struct play *play, const struct keys_state *k, bool opens)
{
    const struct inspect_pause pause = inspect_pause(play_board(play));
    const bool playback = play->session.demo != NULL;
    bool pressed = false;

    if (!(playback || pause.is_listening) || play->attract.on || play_fault(play) || play->console.open)
        return;
    for (int p = 0; p < MAX_PLAYERS; p++) {
        if (!playback && !pause.in_play[p])
            continue;
        pressed = pressed || k->pads_pressed[p] & PAD_START & ~play->pads.ignored[p];
        play->pads.ignored[p] |= k->pads[p] & PAD_START;
    }
    if (pressed && opens)
        play_open_menu(play);
}

/* Buttons accumulate until a tick has seen them. */
static void accumulate_pads(struct play_pads *pads, const struct keys_state *k)
{
    for (int i = 0; i < MAX_PLAYERS; i++) {
        pads->ignored[i] &= k->pads[i];
        pads->held[i] |= (uint16_t)(k->pads[i] & ~pads->ignored[i]);
    }
}

void play_scroll(const struct play *play, int *top, int end, uint16_t pad, int wheel)
{
    static const uint64_t every = 3; /* frames a line, while held */
    bool step = play->time.frames % every == 0;

    *top += (step && pad & PAD_DOWN ? 1 : 0) - (step && pad & PAD_UP ? 1 : 0) - 3 * wheel;
    *top = *top > end ? end : *top;
    *top = *top < 0 ? 0 : *top;
}

static void ignore_keys(struct keys_state *k, uint32_t keys)
{
    k->held &= ~keys;
    k->pressed &= ~keys;
}

/* Input during play: no screen and no prompt is open. */
static void game_keys(struct play *play, const struct plat_input *in, struct keys_state *k)
{
    struct play_time *time = &play->time;
    const bool waited = time->waits_for_button;

    if (time->waits_for_button && (k->any_pad_pressed || !time->paused)) {
        time->waits_for_button = time->paused = false;
        play->message.frames = 0;
    }
    console_keys(play, in, k);
    overlay_toggle(&play->overlay, k->pressed);
    take_start(play, k, !waited);
    if (k->any_pad_pressed)
        play->replay.hint_frames = REPLAY_HINT_FRAMES;
    if (play_is_watching(play) && !screens_are_open(&play->screens) &&
        (k->pads_pressed[0] | k->pads_pressed[1]) & PAD_BOMB)
        play_quit_replay(play);
    accumulate_pads(&play->pads, k);
    if (play_fault(play))
        play_scroll(play, &play->report.page_top, play->report.page_max_top, k->pads[0], in->wheel);
    global_keys(play, k);
    speed_keys(play, k);
    play_practice_keys(play, k);
    if (screens_are_open(&play->screens))
        return;
    seek_keys(play, in, k);
    time_bar_mouse(play, in);
    if (play->attract.on && k->any_pad_pressed)
        attract_end(&play->attract);
}

void play_poll(struct play *play, struct keys_state *k)
{
    struct plat_input in;

    plat_poll(&in);
    play_window_mouse(&play->window, &in.mouse_x, &in.mouse_y);
    play->time.stopped = false;
    play->mouse.x = in.mouse_x;
    play->mouse.y = in.mouse_y;
    play->quit = play->quit || in.quit;
    play_poll_controllers(play, &in);
    play_type_name(play, &in);
    /* Also while the prompt is open: the key that closes it must not be read afterwards. */
    keys_read(&play->config.keys, &in, &play->pads.controllers, k);
    if (!play->options.open)
        ignore_keys(k, KEYS_FOR_AUTHORS | (play->options.sealed && !play->session.demo ? KEYS_FOR_SEEKING : 0));
    play_report_controllers(play, k);
    play_check_drop(play);
    if (play->replay.resuming) { /* only quitting is possible */
        play->quit = play->quit || keys_pressed(k, HOTKEY_QUIT);
        memset(k, 0, sizeof *k);
        return;
    }
    if (prompt_keys(play, &in)) {
        memset(k, 0, sizeof *k);
        return;
    }
    play->time.stopped = play_screen_keys(play, &in, k);
    if (play->time.stopped) {
        global_keys(play, k);
        memset(k->pads, 0, sizeof k->pads);
        k->held = k->pressed = 0;
    } else {
        game_keys(play, &in, k);
    }
}
