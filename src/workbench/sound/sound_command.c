/*
 * sound_command.c - see sound_command.h. The board's jukebox (board.h) plays without the game's scripts. Looping sounds
 * are played for two minutes.
 */
#include "sound_command.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "../../base/bytes.h"
#include "../../base/edit.h"
#include "../../base/err.h"
#include "../../common/result.h"
#include "../../board/board.h"
#include "../../rom/cart.h"
#include "jukebox.h"
#include "../../common/report.h"
#include "../../player/speaker/wav_writer.h"
#include "notes.h"
#include "../pack/pack.h"
#include "loudness.h"
#include "../samples/tune_time.h"

enum { MAX_FRAMES = 7200, WAV_HEADER_SIZE = 44 };

/* Returns the recorded samples (malloc); NULL: out of memory. */
static int16_t *copy_samples(const struct wav_writer *t)
{
    int16_t *lr = malloc((size_t)t->frames * 4 + 1);

    for (size_t i = 0; lr && i < 2 * (size_t)t->frames; i++)
        lr[i] = (int16_t)bytes_get16(t->file.bytes + WAV_HEADER_SIZE + 2 * i);
    return lr;
}

/* Records at most `max_frames` frames. */
static void record(struct board *b, struct wav_writer *t, const char *name, int max_frames)
{
    board_jukebox_play(b, name);
    for (int i = 0; i < max_frames && board_jukebox_tick(b); i++)
        wav_writer_add(t, b);
}

/* Prints the length and loudness; looping music is played until it has looped once. */
static bool print_measurements(struct board *b, const struct board_tune *t)
{
    const struct tune tune = tune_of(t->data);
    const struct tune_time time = tune_time(&tune);
    const int max_frames = time.loop > 0 ? (int)(time.all * 60) + 1 : MAX_FRAMES;
    struct wav_writer wav;
    int16_t *lr = NULL;

    if (wav_writer_open(&wav)) {
        record(b, &wav, t->name, max_frames < MAX_FRAMES ? max_frames : MAX_FRAMES);
        lr = copy_samples(&wav);
    }
    if (lr) {
        report_print("%.2f s", time.loop > 0 ? time.all : wav.frames / 48000.0);
        if (time.loop > 0)
            report_print(", loop %.2f s", time.loop);
        report_print(", peak %.1f dB, %.1f LUFS", loudness_peak(lr, wav.frames), loudness(lr, wav.frames));
    }
    free(lr);
    wav_writer_close(&wav);
    return lr != NULL;
}

static enum result list(void *block, const struct cart *cart)
{
    struct board_tune t;
    struct board *b = board_jukebox_open(block, cart);

    for (int i = 0; board_jukebox_get_tune(b, i, &t); i++) {
        report_print("%s %s: ", t.is_music ? "music" : "sound", t.name);
        if (!print_measurements(b, &t))
            return report_line(RESULT_HOST_FAILED, "out of memory");
        report_print(", %zu bytes, %s, tracks %d, %s %d%s%s\n", t.bytes, t.is_recording ? "recording" : "MML",
                     t.track_count, t.is_music ? "markers" : "limit", t.is_music ? t.mark_count : t.limit,
                     t.title[0] ? ", " : "", t.title);
        b = board_jukebox_open(block, cart);
    }
    return RESULT_DONE;
}

static bool print_level(const char *name, const struct wav_writer *t)
{
    int16_t *lr = copy_samples(t);

    if (lr)
        report_print("%s: %.2f s, peak %.1f dB, mean %.1f dB, %.1f LUFS\n", name, t->frames / 48000.0,
                     loudness_peak(lr, t->frames), loudness_mean(lr, t->frames), loudness(lr, t->frames));
    free(lr);
    return lr != NULL;
}

static enum result report_unknown(const struct board *b, const char *name)
{
    struct edit_nearest near = { .word = name };
    struct board_tune t;

    for (int i = 0; board_jukebox_get_tune(b, i, &t); i++)
        edit_consider(&near, t.name);
    if (near.found)
        return report_line(RESULT_REFUSED, "sound: no \"%s\" in this game (did you mean \"%s\"?)", name, near.found);
    return report_line(RESULT_REFUSED, "sound: no \"%s\" in this game", name);
}

/* Prints the notes of the sound or, if no sound has the name, of the music. Tunes in a valid ROM are valid. */
static enum result print_notes(const struct board *b, const struct rom *rom, const char *name)
{
    static const char *const folders[] = { "sound/", "tune/" };
    char path[64];

    for (int i = 0; i < 2; i++) {
        const int n = snprintf(path, sizeof path, "%s%s", folders[i], name);
        const int at = n < (int)sizeof path ? rom_find(rom, path) : -1;
        struct lump l;
        if (at < 0)
            continue;
        rom_lump(rom, at, &l);
        const struct tune t = tune_of(l.data);
        notes_print(name, &t);
        return RESULT_DONE;
    }
    return report_unknown(b, name);
}

static enum result measure(struct board *b, const struct args *a)
{
    const char *out = a->out ? a->out : a->wav;
    struct wav_writer t;
    char err[1200];
    bool good = true;

    if (!wav_writer_open(&t)) {
        wav_writer_close(&t);
        return report_line(RESULT_HOST_FAILED, "out of memory");
    }
    record(b, &t, a->words[1], MAX_FRAMES);
    if (!print_level(a->words[1], &t))
        good = result_set_host_error(err, sizeof err, "out of memory");
    if (good && out)
        good = wav_writer_save(&t, out, err, sizeof err);
    wav_writer_close(&t);
    return good ? RESULT_DONE : report_line(RESULT_HOST_FAILED, "%s", err);
}

/* Returns whether a sound or a piece of music has the name. */
static bool has(const struct board *b, const char *name)
{
    struct board_tune t;

    for (int i = 0; board_jukebox_get_tune(b, i, &t); i++)
        if (strcmp(t.name, name) == 0)
            return true;
    return false;
}

static enum result play_or_measure(struct board *b, const struct args *a, struct jukebox **j)
{
    if (!has(b, a->words[1]))
        return report_unknown(b, a->words[1]);
    return a->play ? jukebox_open(j, b, a->words[1]) : measure(b, a);
}

struct sound_command {
    struct rom_image image;
    struct cart cart;
    void *block; /* malloc; the board is its 64-byte aligned part */
    struct jukebox *jukebox;
};

static bool frame(void *context)
{
    return jukebox_frame(((struct sound_command *)context)->jukebox);
}

static enum result close(void *context)
{
    struct sound_command *c = context;

    if (c->jukebox)
        jukebox_close(c->jukebox);
    rom_image_free(&c->image);
    free(c->block);
    free(c);
    return RESULT_DONE;
}

static enum result run(struct sound_command *c, const struct args *a)
{
    char err[1024];

    if (!c->block)
        return report_line(RESULT_HOST_FAILED, "out of memory");
    if (!pack_load_game(a->words[0], a->nearest, &c->image, err, sizeof err))
        return report_line(RESULT_REFUSED, "%s", err);
    if (!cart_open(&c->cart, &c->image.rom, err, sizeof err))
        return report_line(RESULT_REFUSED, "%s", err);
    struct board *b = board_jukebox_open((void *)(((uintptr_t)c->block + 63) / 64 * 64), &c->cart);
    if (a->n_words < 2)
        return list(b, &c->cart);
    return a->notes ? print_notes(b, &c->image.rom, a->words[1]) : play_or_measure(b, a, &c->jukebox);
}

enum result sound_command(const struct args *a, struct frame_command *running)
{
    struct sound_command *c = calloc(1, sizeof *c);

    if (!c)
        return report_line(RESULT_HOST_FAILED, "out of memory");
    c->block = malloc(board_jukebox_size() + 64);
    const enum result result = run(c, a);
    if (c->jukebox) {
        *running = (struct frame_command){ frame, close, c };
        return RESULT_DONE;
    }
    close(c);
    return result == RESULT_DONE ? report_stdout(result) : result;
}
