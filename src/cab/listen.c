/*
 * listen.c - see listen.h. A box (board.h) plays without the game's scripts. What never ends is heard for two minutes.
 */
#include "listen.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include "../base/bytes.h"
#include "../base/edit.h"
#include "../board/board.h"
#include "host/report.h"
#include "host/tape.h"
#include "notes.h"
#include "pack/pack.h"

enum { MOST_FRAMES = 7200, HEADER = 44 };

static void list(const struct board *b)
{
    struct board_tune t;

    for (int i = 0; board_box_tune(b, i, &t); i++)
        printf("%s %s: %zu bytes, %s, tracks %d, %s %d%s%s%s\n", t.music ? "music" : "sound", t.name, t.bytes,
               t.recording ? "recording" : "MML", t.tracks, t.music ? "markers" : "limit", t.music ? t.marks : t.limit,
               t.endless ? ", endless" : "", t.title[0] ? ", " : "", t.title);
}

/* Decibels of full scale. */
static double decibels(double level)
{
    return level > 0 ? 20 * log10(level / 32768) : -120;
}

static void print_level(const char *name, const struct tape *t)
{
    int64_t peak = 0;
    double sum = 0;
    const uint32_t n = 2 * t->frames;

    for (uint32_t i = 0; i < n; i++) {
        const int64_t v = (int16_t)bytes_get16(t->bytes + HEADER + 2 * (size_t)i);
        peak = v > peak ? v : -v > peak ? -v : peak;
        sum += (double)(v * v);
    }
    printf("%s: %.2f s, peak %.1f dB, mean %.1f dB\n", name, t->frames / 48000.0, decibels((double)peak),
           decibels(sqrt(sum / (n ? n : 1))));
}

static enum result unknown(const struct board *b, const char *name)
{
    struct board_tune t;
    const char *near = NULL;
    int best = EDIT_FAR;

    for (int i = 0; board_box_tune(b, i, &t); i++)
        if (edit_distance(name, t.name) < best) {
            best = edit_distance(name, t.name);
            near = t.name;
        }
    if (near)
        return report_line(RESULT_REFUSED, "sound: the game has no \"%s\" (did you mean \"%s\"?)", name, near);
    return report_line(RESULT_REFUSED, "sound: the game has no \"%s\"", name);
}

/* The notes of the sound or, if there is none of that name, of the music. The ROM's tunes were checked with it. */
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
    return unknown(b, name);
}

static enum result play(struct board *b, const struct args *a)
{
    struct tape t;
    char err[1200];
    bool good = true;

    if (!board_box_play(b, a->words[1]))
        return unknown(b, a->words[1]);
    if (!tape_open(&t)) {
        tape_close(&t);
        return report_line(RESULT_HOST, "out of memory");
    }
    for (int i = 0; i < MOST_FRAMES && board_box_tick(b); i++)
        tape_add(&t, b);
    print_level(a->words[1], &t);
    if (a->out)
        good = tape_save(&t, a->out, err, sizeof err);
    tape_close(&t);
    return good ? RESULT_DONE : report_line(RESULT_HOST, "%s", err);
}

enum result listen_run(const struct args *a)
{
    struct rom_image image = { 0 };
    char err[1024];
    void *block = malloc(board_box_size() + 64);
    enum result result = RESULT_DONE;

    if (!block)
        return report_line(RESULT_HOST, "out of memory");
    if (!rom_image_load(a->words[0], a->nearest, &image, err, sizeof err)) {
        free(block);
        return report_line(RESULT_REFUSED, "%s", err);
    }
    struct board *b = board_box_open((void *)(((uintptr_t)block + 63) / 64 * 64), &image.rom, err, sizeof err);
    if (!b)
        result = report_line(RESULT_REFUSED, "%s", err);
    else if (a->n_words < 2)
        list(b);
    else if (a->notes)
        result = print_notes(b, &image.rom, a->words[1]);
    else
        result = play(b, a);
    rom_image_free(&image);
    free(block);
    return result == RESULT_DONE ? report_stdout(result) : result;
}
