/*
 * play_sound.c - the sound of a frame: the board's, and over it the sounds of screens. A jukebox plays these, because
 * the board doesn't tick while a screen is open, and must not change.
 */
#include <stdlib.h>
#include <string.h>
#include "play_state.h"

enum { RAM_ALIGN = 64 };

/* Returns whether the jukebox plays the present game. A reload or a replay's ROM may have replaced it. */
static bool is_of_game(const struct screen_sound *s, const struct rom *rom)
{
    return s->board && s->rom.data == rom->data && s->rom.crc == rom->crc;
}

static bool open_jukebox(struct screen_sound *s, const struct cart *cart)
{
    struct cart own = *cart;

    if (is_of_game(s, cart->rom))
        return true;
    if (!s->block)
        s->block = malloc(board_jukebox_size() + RAM_ALIGN - 1);
    if (!s->block)
        return false;
    s->rom = *cart->rom;
    own.rom = &s->rom;
    s->board = board_jukebox_open((void *)(((uintptr_t)s->block + RAM_ALIGN - 1) / RAM_ALIGN * RAM_ALIGN), &own);
    return true;
}

void play_start_screen_sounds(struct play *play)
{
    struct screen_sound *s = &play->screen_sound;
    struct theme theme;
    bool due[THEME_SOUNDS], any = false;

    memcpy(due, play->screens.sounded, sizeof due);
    memset(play->screens.sounded, 0, sizeof play->screens.sounded);
    for (int i = 0; i < THEME_SOUNDS; i++)
        any = any || due[i];
    if (!any || play->speaker.muted || play->speaker.state == SPEAKER_MISSING || !open_jukebox(s, play_cart(play)))
        return;
    theme_open(&theme, play_cart(play));
    for (int i = 0; i < THEME_SOUNDS; i++)
        if (due[i] && theme.sounds[i])
            s->playing = board_jukebox_play(s->board, theme.sounds[i]) || s->playing;
}

/* Advances the jukebox by a frame. Returns NULL if it is silent. */
static const struct board *tick_jukebox(struct play *play)
{
    struct screen_sound *s = &play->screen_sound;

    s->playing = s->playing && is_of_game(s, play_cart(play)->rom) && board_jukebox_tick(s->board);
    return s->playing ? s->board : NULL;
}

void play_queue_sound(struct play *play, enum speaker_mode mode)
{
    speaker_add_frame(&play->speaker, play_shown_board(play), tick_jukebox(play), mode);
}

void play_queue_screen_sound(struct play *play, int sixtieths)
{
    for (int i = 0; i < sixtieths; i++) {
        const struct board *b = tick_jukebox(play);
        if (b)
            speaker_add_frame(&play->speaker, b, NULL, SPEAKER_FORWARD);
    }
}
