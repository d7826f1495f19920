/*
 * cab_keys.c - the switches: what each of the cabinet's keys does, and which buttons go to the game.
 */
#include <stdio.h>
#include <string.h>
#include "cab_parts.h"
#include "timebar.h"

enum { MAX_SLOW = 4, LOUDER = 10 /* percent, a press */ };

static void reopen(struct cab *cab)
{
    cab->config.fullscreen = !cab->config.fullscreen;
    cab->quit = !cab_open_window(cab) || cab->quit;
}

/* A speaker is opened when something is to be heard. */
static void set_sound(struct cab *cab, bool muted, int volume)
{
    cab->speaker.muted = muted;
    cab->speaker.volume = volume < 0 ? 0 : volume > 100 ? 100 : volume;
    if (!board_has_sound(cab_live(cab)))
        cab_notice(cab, CAB_NOTICE_FRAMES / 2, "This game has no sound");
    else if (muted)
        cab_notice(cab, CAB_NOTICE_FRAMES / 2, "Sound off");
    else
        cab_notice(cab, CAB_NOTICE_FRAMES / 2, "Volume %d%%", cab->speaker.volume);
    if (!muted && !cab->want.sound_rate)
        cab->quit = !cab_open_window(cab) || cab->quit;
}

static void sound_keys(struct cab *cab, const struct keys_read *k)
{
    if (k->pressed & 1 << CAB_MUTE)
        set_sound(cab, !cab->speaker.muted, cab->speaker.volume);
    if (k->pressed & 1 << CAB_QUIETER)
        set_sound(cab, cab->speaker.muted, cab->speaker.volume - LOUDER);
    if (k->pressed & 1 << CAB_LOUDER)
        set_sound(cab, false, cab->speaker.volume + LOUDER);
}

/* The keys that work over a screen, too. */
static void host_keys(struct cab *cab, const struct keys_read *k)
{
    if (k->pressed & 1 << CAB_QUIT)
        cab->quit = true;
    if (k->pressed & 1 << CAB_FULLSCREEN)
        reopen(cab);
    if (k->pressed & 1 << CAB_SCREENSHOT)
        cab_screenshot(cab, &cab->picture);
    if (k->pressed & 1 << CAB_CAPTURE)
        cab_film_ask(cab);
    sound_keys(cab, k);
}

static void clock_keys(struct cab *cab, const struct keys_read *k)
{
    if (k->pressed & 1 << CAB_PAUSE)
        cab->paused = !cab->paused;
    if (k->pressed & 1 << CAB_STEP)
        cab->paused = cab->step = true;
    if (k->pressed & 1 << CAB_SLOW) {
        cab_mark_assisted(cab);
        cab->slow = cab->slow == MAX_SLOW ? 1 : cab->slow * 2;
    }
}

/* The keys that move in time. */
static void time_keys(struct cab *cab, const struct keys_read *k)
{
    const struct session *s = &cab->session;
    uint32_t now = s->state == SESSION_SEEKING
                       ? s->to
                       : board_frame(cab_live(cab)); /* a second press counts from the target of the first */

    if (cab->attracting)
        return;
    if (k->pressed & 1 << CAB_BACK) {
        cab->paused = true;
        cab_rewind(cab, 1);
    }
    if (k->pressed & 1 << CAB_BEFORE)
        cab_goto(cab, timebar_previous(&cab->session, now));
    if (k->pressed & 1 << CAB_AFTER)
        cab_goto(cab, timebar_next(&cab->session, now));
    if (k->pressed & 1 << CAB_TAKE_OVER)
        cab_take_over(cab);
    if (k->pressed & 1 << CAB_RELOAD)
        cab_reload(cab);
}

/* In a playback, and whenever the time bar is shown, a click on it moves to that frame. */
static void mouse(struct cab *cab, const struct plat_input *in)
{
    uint32_t frame;
    bool held = in->mouse_buttons & 1, pressed = held && !cab->mouse;

    cab->mouse = held;
    if (cab->attracting || cab->console.open || !(cab->session.demo || cab_timebar_shown(cab)) ||
        !timebar_at(&cab->session, cab->picture.fb.w, cab->picture.fb.h, in->mouse_x, in->mouse_y, &frame))
        return;
    cab->timebar_left = cab->timebar_left ? cab->timebar_left : 1;
    if (pressed || (held && cab->session.state == SESSION_PLAYING && frame != board_frame(cab_live(cab))))
        cab_goto(cab, frame);
}

/* True while the prompt is open: the keys are its own, and time stands still. */
static bool prompt_keys(struct cab *cab, const struct plat_input *in)
{
    uint32_t frame;

    if (!cab->prompt.open)
        return false;
    if (prompt_poll(&cab->prompt, in, &frame)) {
        cab->paused = true;
        cab_goto(cab, frame);
    }
    return true;
}

/* Collects buttons until a tick has seen them. */
static void take_pads(struct cab *cab, const struct keys_read *k)
{
    for (int i = 0; i < MAX_PLAYERS; i++) {
        cab->stale[i] &= k->pads[i];
        cab->pads[i] |= (uint16_t)(k->pads[i] & ~cab->stale[i]);
    }
}

void cab_scroll(struct cab *cab, int *top, int most, uint16_t pad, int wheel)
{
    static const uint64_t every = 3; /* frames a line, while held */
    bool step = cab->frames % every == 0;

    *top += (step && pad & PAD_DOWN ? 1 : 0) - (step && pad & PAD_UP ? 1 : 0) - 3 * wheel;
    *top = *top > most ? most : *top;
    *top = *top < 0 ? 0 : *top;
}

/* While the console is open it has all keys. Scores are saved before a line can touch them. */
static void console_keys(struct cab *cab, const struct plat_input *in, struct keys_read *k)
{
    bool stands = !cab_fault(cab) && !cab->attracting && cab->session.state == SESSION_PLAYING;
    if (k->pressed & 1 << CAB_CONSOLE)
        cab_save_nvram(cab);
    console_poll(&cab->console, in, k, stands ? cab_live(cab) : NULL, !cab->session.demo);
    if (console_kept(&cab->console)) {
        cab_check_recording(cab, session_mark_touched(&cab->session));
        practice_stop_counting(&cab->practice);
    }
    if (cab->want.text_input == cab->console.open)
        return;
    cab->want.text_input = cab->console.open;
    cab->quit = !cab_open_window(cab) || cab->quit;
}

static void take_away(struct keys_read *k, uint32_t keys)
{
    k->held &= ~keys;
    k->pressed &= ~keys;
}

void cab_poll(struct cab *cab, struct keys_read *k)
{
    struct plat_input in;
    plat_poll(&in);
    cab_window_mouse(cab, &in.mouse_x, &in.mouse_y);
    cab->stands = false;
    cab->mouse_x = in.mouse_x;
    cab->mouse_y = in.mouse_y;
    cab->quit = cab->quit || in.quit;
    cab_seats_poll(cab, &in);
    /* Also while the prompt is open: the key that closes it must not be read afterwards. */
    keys_read(&cab->config.keys, &in, &cab->seats, k);
    if (cab->options.sealed)
        take_away(k, KEYS_INSIDE | (cab->session.demo ? 0 : KEYS_IN_TIME));
    cab_seats_told(cab, k);
    cab_drop(cab);
    if (cab->guest.resuming) { /* what was left is played again: nothing but leaving */
        cab->quit = cab->quit || k->pressed & 1 << CAB_QUIT;
        memset(k, 0, sizeof *k);
        return;
    }
    if (prompt_keys(cab, &in)) {
        memset(k, 0, sizeof *k);
        return;
    }
    cab->stands = cab_screen_keys(cab, &in, k);
    if (cab->stands) {
        host_keys(cab, k);
        memset(k->pads, 0, sizeof k->pads);
        k->held = k->pressed = 0;
        return;
    }
    if (cab->awaits && (k->fresh || !cab->paused)) {
        cab->awaits = cab->paused = false;
        cab->notice_left = 0;
    }
    console_keys(cab, &in, k);
    overlay_keys(&cab->overlay, k->pressed);
    take_pads(cab, k);
    if (cab_fault(cab))
        cab_scroll(cab, &cab->fault_top, cab->fault_most, k->pads[0], in.wheel);
    host_keys(cab, k);
    clock_keys(cab, k);
    cab_practice_keys(cab, k);
    if (screens_are_open(&cab->screens))
        return;
    time_keys(cab, k);
    if (k->pressed & 1 << CAB_GOTO && !cab->attracting)
        prompt_open(&cab->prompt, &in);
    mouse(cab, &in);
    if (cab->attracting && k->fresh)
        cab_attract_end(cab);
}
