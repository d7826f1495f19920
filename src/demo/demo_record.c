/*
 * demo_record.c - records demos (demo.h).
 *
 * The writer holds the whole recording in memory (about two kilobytes a second for a short one, three hundred bytes a
 * second for a long one), so a rewind truncates it and rewrites the file.
 */
#include <inttypes.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "../../platform/platform.h"
#include "demo_parts.h"
#include "../common/files.h"

static void stop_recording(struct demo_writer *w)
{
    w->recording = false;
    free(w->hash_cache);
    w->hash_cache = NULL;
}

static bool stop_out_of_memory(struct demo_writer *w)
{
    snprintf(w->err, sizeof w->err, "out of memory: recording stopped");
    stop_recording(w);
    return false;
}

/* Returns whether the file is as this writer left it, judging by its size. Two processes that play the same game use
 * the same spare file. */
static bool is_ours(const struct demo_file *f)
{
    return f->size == 0 || plat_file_size(f->path) == (long)f->size;
}

/* Records a failed write, which may have written some of the bytes. */
static void mark_failed(struct demo_file *f)
{
    const long size = plat_file_size(f->path);

    f->write_failed = true;
    f->size = size > 0 ? (size_t)size : 0;
}

/* Writes bytes to a file; overwrite: replaces its content, otherwise appends. */
static bool write_to_file(struct demo_file *f, const struct demo_sink *s, bool overwrite, char *err)
{
    char shown[FILES_PATH_SIZE];
    const bool ours = is_ours(f);
    bool good = ours;

    if (good)
        good = (overwrite ? files_save : files_append)(f->path, s->p, s->n, err, DEMO_ERR_SIZE);
    else
        snprintf(err, DEMO_ERR_SIZE, "%s: another program has changed the file", files_display_name(f->path, shown));
    if (good)
        f->size = (overwrite ? 0 : f->size) + s->n;
    else if (ours)
        mark_failed(f);
    else
        f->path[0] = 0;
    return good;
}

/* Puts the bytes to write to file f into the sink, and updates f's counts and CRC. */
typedef void put_bytes(struct demo_writer *w, struct demo_file *f, struct demo_sink *s);

/* Puts the whole recording, which replaces the file; the other functions' bytes are appended. */
static void put_all(struct demo_writer *w, struct demo_file *f, struct demo_sink *s)
{
    demo_put_until_last_row(s, &w->demo, &f->frames_written, &f->markers_written, &f->crc);
}

/* Makes the bytes for one file and writes them. */
static bool write_one(struct demo_writer *w, struct demo_file *f, put_bytes *put, char *err)
{
    struct demo_sink s = { 0 };

    if (!f->path[0] || f->write_failed)
        return true;
    put(w, f, &s);
    bool bad = s.failed, good = !bad && write_to_file(f, &s, put == put_all, err);
    free(s.p);
    return bad ? stop_out_of_memory(w) : good;
}

/* Makes the bytes for the file and for the spare file, and writes them. Failing to write the spare file does not fail
 * the recording. */
static bool write_both(struct demo_writer *w, put_bytes *put)
{
    bool good = write_one(w, &w->file, put, w->err);

    write_one(w, &w->spare_file, put, w->spare_err);
    return good;
}

/* Puts the frames that are not in the file yet, and the newest row if it is of the last frame. */
static void put_second(struct demo_writer *w, struct demo_file *f, struct demo_sink *s)
{
    struct demo *d = &w->demo;
    bool hashed = d->n_rows > 0 && demo_row_frame(d, d->n_rows - 1) == d->frames;

    demo_put_second(s, d, f->frames_written, d->frames - f->frames_written, hashed ? demo_row(d, d->n_rows - 1) : NULL,
                    &f->crc);
    f->frames_written = d->frames;
    demo_put_markers(s, d, &f->markers_written, d->frames, &f->crc);
}

static void put_flags(struct demo_writer *w, struct demo_file *f, struct demo_sink *s)
{
    demo_put_flags(s, w->demo.flags, &f->crc);
}

static void put_end(struct demo_writer *w, struct demo_file *f, struct demo_sink *s)
{
    demo_put_markers(s, &w->demo, &f->markers_written, w->demo.frames, &f->crc);
    demo_put_end(s, &w->demo, &f->crc);
}

static bool add_row(struct demo *d, const uint64_t hashes[MAX_PARTS])
{
    if (!demo_reserve_row(d))
        return false;
    memcpy(demo_row(d, d->n_rows++), hashes, sizeof hashes[0] * (size_t)d->n_parts);
    return true;
}

static void set_parts(struct demo *d, const struct board *b)
{
    d->n_parts = board_part_count(b);
    for (int i = 0; i < d->n_parts; i++)
        snprintf(d->part_name[i], sizeof d->part_name[i], "%s", board_part_name(b, i));
    d->checksum_parts = UINT64_MAX;
}

static void set_identity(struct demo *d, const struct cart *cart)
{
    d->core_version = CORE_VERSION;
    d->game_hash = rom_game_hash(cart->rom);
    d->rom_hash = rom_hash(cart->rom);
    snprintf(d->id, sizeof d->id, "%s", cart->manifest.id);
    snprintf(d->lua_release, sizeof d->lua_release, "%s", board_lua_release());
}

/* Adds the markers of the last tick. */
static bool add_markers(struct demo *d, const struct board *b)
{
    const struct board_out *out = board_last_output(b);

    for (int i = 0; i < out->marker_count; i++) {
        if (!demo_reserve_marker(d))
            return false;
        d->markers[d->n_markers++] = (struct demo_marker){ d->frames, out->marker[i] };
    }
    return true;
}

static bool copy_start(struct demo *d, const struct board_start *start)
{
    size_t n = start->nvram ? start->nvram_size : 0;

    d->start = *start;
    d->start.nvram_size = n;
    d->nvram = malloc(n + 1);
    d->start.nvram = n ? d->nvram : NULL;
    if (d->nvram && n)
        memcpy(d->nvram, start->nvram, n);
    return d->nvram != NULL;
}

bool demo_record_to_file(struct demo_writer *w, const char *path)
{
    if (snprintf(w->file.path, sizeof w->file.path, "%s", path) < (int)sizeof w->file.path)
        return write_one(w, &w->file, put_all, w->err);
    snprintf(w->err, sizeof w->err, "the demo's path is too long");
    w->file.path[0] = 0;
    return false;
}

bool demo_retry_write(struct demo_writer *w)
{
    struct demo_file *f = &w->file;

    if (!f->write_failed)
        return true;
    if (plat_file_size(f->path) == 0)
        return false;
    f->write_failed = false;
    f->size = 0;
    return write_one(w, f, put_all, w->err);
}

void demo_record_to_spare_file(struct demo_writer *w, const char *path)
{
    w->spare_err[0] = 0;
    w->spare_file.write_failed = false;
    snprintf(w->spare_file.path, sizeof w->spare_file.path, "%s", path && w->recording ? path : "");
    w->spare_file.size = 0;
    write_one(w, &w->spare_file, put_all, w->spare_err);
}

void demo_remove_spare_file(struct demo_writer *w)
{
    if (w->spare_file.path[0] && is_ours(&w->spare_file))
        plat_remove(w->spare_file.path);
    demo_record_to_spare_file(w, NULL);
}

bool demo_begin(struct demo_writer *w, const char *path, const struct cart *cart, const struct board *b,
                const struct board_start *start, unsigned flags)
{
    struct demo *d = &w->demo;

    demo_free(d);
    memset(w, 0, sizeof *w);
    w->recording = true;
    d->format = DEMO_FORMAT;
    set_identity(d, cart);
    if (!copy_start(d, start))
        return stop_out_of_memory(w);
    set_parts(d, b);
    d->flags = flags;
    w->hash_cache = calloc(1, board_hash_cache_size(b));
    if (!w->hash_cache)
        return stop_out_of_memory(w);
    if (!board_last_output(b)->fault) {
        board_hashes_cached(b, w->hash_cache, w->hashes);
        if (!add_row(d, w->hashes) || !add_markers(d, b))
            return stop_out_of_memory(w);
    }
    return !path || demo_record_to_file(w, path);
}

/* Adds the checksums of the newest frame, unless it faulted. */
static void add_checksums(struct demo_writer *w, const struct board *b)
{
    struct demo *d = &w->demo;
    uint16_t *checksums = d->sparse ? NULL : d->checksums + (size_t)(d->frames - 1) * (size_t)d->n_parts;

    if (board_last_output(b)->fault)
        return;
    board_hashes_cached(b, w->hash_cache, w->hashes);
    for (int i = 0; i < d->n_parts && !d->sparse; i++)
        checksums[i] = (uint16_t)w->hashes[i];
    d->checksum_frames = d->frames;
}

static void make_sparse(struct demo *d)
{
    free(d->checksums);
    d->checksums = NULL;
    d->sparse = true;
}

bool demo_set_checksum_rate(struct demo_writer *w, enum demo_checksum_rate rate)
{
    w->checksum_rate = rate;
    if (!w->recording || rate != DEMO_CHECKSUMS_EVERY_SECOND || w->demo.sparse)
        return true;
    make_sparse(&w->demo);
    return write_both(w, put_all);
}

/* Returns whether the recording has just become too long to have checksums of every frame. */
static bool is_too_long(const struct demo_writer *w)
{
    return w->checksum_rate == DEMO_CHECKSUMS_AUTO && !w->demo.sparse && w->demo.frames > DEMO_DENSE_FRAMES;
}

bool demo_record_frame(struct demo_writer *w, const struct board *b, const uint16_t pads[MAX_PLAYERS])
{
    struct demo *d = &w->demo;

    if (!w->recording)
        return true;
    if (d->frames >= DEMO_MAX_FRAMES) {
        snprintf(w->err, sizeof w->err, "recording stopped: a demo can have at most %d frames", DEMO_MAX_FRAMES);
        stop_recording(w);
        return false;
    }
    if (!demo_reserve_frames(d, 1))
        return stop_out_of_memory(w);
    memcpy(d->pads[d->frames++], pads, sizeof d->pads[0]);
    add_checksums(w, b);
    if (!add_markers(d, b))
        return stop_out_of_memory(w);
    if (d->frames % DEMO_SECOND_FRAMES != 0 || board_last_output(b)->fault)
        return true;
    if (!add_row(d, w->hashes))
        return stop_out_of_memory(w);
    if (!is_too_long(w))
        return write_both(w, put_second);
    make_sparse(d);
    return write_both(w, put_all);
}

bool demo_add_flags(struct demo_writer *w, unsigned flags)
{
    if (!w->recording || (w->demo.flags | flags) == w->demo.flags)
        return true;
    w->demo.flags |= flags;
    return write_both(w, put_flags);
}

bool demo_rewind(struct demo_writer *w, uint32_t frame)
{
    struct demo *d = &w->demo;

    if (!w->recording)
        return true;
    d->frames = frame < d->frames ? frame : d->frames;
    d->checksum_frames = d->checksum_frames < d->frames ? d->checksum_frames : d->frames;
    while (d->n_markers && d->markers[d->n_markers - 1].frame > d->frames)
        d->n_markers--;
    uint32_t rows = d->frames / DEMO_SECOND_FRAMES + 1;
    d->n_rows = rows < d->n_rows ? rows : d->n_rows;
    d->flags |= DEMO_BRANCHED;
    return write_both(w, put_all);
}

/* Adds all players' final points as markers, so that they are known even where another core version replays the run
 * differently. */
static bool add_points(struct demo *d, const struct board *b)
{
    for (int p = 0; p < MAX_PLAYERS && d->n_rows; p++) {
        struct demo_marker m = { .frame = d->frames, .marker.kind = MARKER_LISTED };
        if (!demo_reserve_marker(d))
            return false;
        snprintf(m.marker.name, sizeof m.marker.name, DEMO_POINTS_FORMAT "%" PRId64, p + 1, board_points(b, p));
        d->markers[d->n_markers++] = m;
    }
    return true;
}

/* Ends a demo at the board's current frame, which has these hashes unless it ended in a fault. */
static bool end_at(struct demo *d, const struct board *b, const uint64_t hashes[MAX_PARTS])
{
    const struct board_fault *fault = board_last_output(b)->fault;

    if (!add_points(d, b))
        return false;
    if (!fault && d->frames > demo_row_frame(d, d->n_rows ? d->n_rows - 1 : 0) && !add_row(d, hashes))
        return false;
    d->complete = true;
    d->fault = fault ? fault->kind : FAULT_NONE;
    return true;
}

bool demo_end(struct demo_writer *w, const struct board *b)
{
    struct demo *d = &w->demo;

    if (!w->recording)
        return true;
    const bool good = demo_retry_write(w);
    if (!board_last_output(b)->fault)
        board_hashes_cached(b, w->hash_cache, w->hashes);
    stop_recording(w);
    const bool has_more = d->frames > demo_row_frame(d, d->n_rows ? d->n_rows - 1 : 0);
    if (!end_at(d, b, w->hashes))
        return stop_out_of_memory(w);
    return (!has_more || write_both(w, put_second)) && write_both(w, put_end) && good;
}

uint8_t *demo_encode_now(struct demo_writer *w, const struct board *b, size_t *size)
{
    struct demo *d = &w->demo;
    const uint32_t n_rows = d->n_rows, n_markers = d->n_markers;
    uint64_t hashes[MAX_PARTS];

    if (!w->recording)
        return NULL;
    if (!board_last_output(b)->fault)
        board_hashes(b, hashes);
    uint8_t *bytes = end_at(d, b, hashes) ? demo_encode(d, size) : NULL;
    d->n_rows = n_rows;
    d->n_markers = n_markers;
    d->complete = false;
    d->fault = FAULT_NONE;
    return bytes;
}

void demo_writer_free(struct demo_writer *w)
{
    stop_recording(w);
    demo_free(&w->demo);
}
