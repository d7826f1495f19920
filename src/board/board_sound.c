/*
 * board_sound.c - a frame's samples, sound slots, and jukeboxes; see board.h.
 */
#include "board.h"

#include <string.h>
#include "../machine/sound.h"

/* ---- samples, sound slots and music ---- */

bool board_has_sound(const struct board *b)
{
    return b->voices.s.cap > 0;
}

size_t board_sound_tables_size(void)
{
    return sizeof(struct snd_tables);
}

void board_sound_init_tables(void *tables)
{
    snd_tables_make(tables);
}

void board_sound_set_levels(void *tables, int music, int sounds)
{
    struct snd_tables *t = tables;

    t->music_volume = music;
    t->sound_volume = sounds;
}

void board_mix_sound(const struct board *b, const void *tables, int16_t out[2 * BOARD_SOUND_FRAMES])
{
    if (board_has_sound(b))
        voices_mix(&b->voices, b->cart.tune_data, tables, out);
    else
        memset(out, 0, 2 * BOARD_SOUND_FRAMES * sizeof *out);
}

/* Returns whether the slot's track ends within the next frame. */
static bool track_ends_next_frame(const struct board *b, int slot)
{
    const struct cues *c = &b->cues;
    const struct tune t = tune_of(b->cart.tune_data + c->tune[slot]);
    struct tune_run run = { &t, c->track[slot], { c->at[slot], c->units_left[slot] }, t.tempo, 0, SND_FRAME, 0 };
    struct tune_played_event e;

    while (tune_next_event(&run, &e))
        ;
    return run.cursor.cursor == 0;
}

bool board_get_cue(const struct board *b, int slot, struct board_cue *out)
{
    const struct cues *c = &b->cues;
    int sound = 0;

    if (!board_has_sound(b) || slot >= CUE_SLOTS)
        return false;
    *out = (struct board_cue){ 0 };
    while (sound < b->cart.count[CART_SOUNDS] && cart_tune_offset(&b->cart, CART_SOUNDS, sound) != c->tune[slot])
        sound++;
    if (c->tune[slot] == 0 || sound == b->cart.count[CART_SOUNDS])
        return true;
    out->name = cart_name(&b->cart, CART_SOUNDS, sound);
    out->start_frame = c->start_frame[slot];
    out->is_first_track = c->track[slot] == 0;
    out->ends_next_frame = track_ends_next_frame(b, slot);
    return true;
}

const char *board_music_name(const struct board *b)
{
    return b->music.tune ? cart_name(&b->cart, CART_TUNES, b->music.tune - 1) : "";
}

/* ---- jukeboxes ---- */

static const struct {
    const struct chip *chip;
    size_t offset;
    uint32_t cap;
} jukebox_parts[] = { { &seq_chip, offsetof(struct board, music), SEQ_SLOTS },
                      { &cues_chip, offsetof(struct board, cues), CUE_SLOTS },
                      { &voices_chip, offsetof(struct board, voices), VOICE_CAPACITY } };

enum { JUKEBOX_PART_COUNT = sizeof jukebox_parts / sizeof *jukebox_parts };

size_t board_jukebox_size(void)
{
    size_t n = (size_t)int_align_cache_line(sizeof(struct board));

    for (int i = 0; i < JUKEBOX_PART_COUNT; i++)
        n += (size_t)slots_size(jukebox_parts[i].chip, jukebox_parts[i].cap, 0);
    return n;
}

struct board *board_jukebox_open(void *ram, const struct cart *cart)
{
    struct board *b = ram;
    uint8_t *next = (uint8_t *)ram + (size_t)int_align_cache_line(sizeof *b);

    memset(ram, 0, board_jukebox_size());
    b->cart = *cart;
    for (int i = 0; i < JUKEBOX_PART_COUNT; i++) {
        struct slots *s = (struct slots *)(void *)((uint8_t *)b + jukebox_parts[i].offset);
        slots_layout(jukebox_parts[i].chip, s, jukebox_parts[i].cap, 0, &next);
        s->live = s->cap;
    }
    sound_reset(b);
    return b;
}

bool board_jukebox_play(struct board *b, const char *name)
{
    const int sound = cart_find(&b->cart, CART_SOUNDS, name), tune = cart_find(&b->cart, CART_TUNES, name);

    if (sound >= 0)
        sound_play(b, &(struct cue){ cart_tune_offset(&b->cart, CART_SOUNDS, sound), 256, 0, 0 });
    else if (tune >= 0)
        sound_start_music(b, tune, &(struct music_options){ .restart = true });
    return sound >= 0 || tune >= 0;
}

bool board_jukebox_tick(struct board *b)
{
    bool busy = false;

    sound_begin_tick(b);
    sound_end_tick(b);
    b->core.frame++;
    for (int i = 0; i < VOICE_SLOTS; i++)
        busy = busy || voices_is_busy(&b->voices, i);
    for (int i = 0; i < CUE_SLOTS; i++)
        busy = busy || b->cues.tune[i];
    for (int i = 0; i < SEQ_SLOTS; i++)
        busy = busy || b->music.at[i];
    return busy;
}

bool board_jukebox_get_tune(const struct board *b, int n, struct board_tune *out)
{
    const bool is_music = n >= b->cart.count[CART_SOUNDS];
    const enum cart_folder folder = is_music ? CART_TUNES : CART_SOUNDS;
    const int i = is_music ? n - b->cart.count[CART_SOUNDS] : n;
    struct lump l;

    if (i >= b->cart.count[folder])
        return false;
    rom_lump(b->cart.rom, b->cart.first[folder] + i, &l);
    const struct tune t = tune_of(l.data);
    const size_t bytes = l.size + cart_wave_size(&b->cart, is_music ? i : -1);
    *out = (struct board_tune){ cart_name(&b->cart, folder, i),
                                tune_title(&t),
                                is_music,
                                tune_is_recording(&t),
                                tune_is_endless(&t),
                                t.n_tracks,
                                t.priority,
                                t.limit,
                                t.n_markers,
                                bytes,
                                l.data };
    return true;
}
