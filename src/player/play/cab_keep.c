/*
 * cab_keep.c - what is kept of runs by itself: a replay of each, and of one that is left where it stands.
 *
 * A run is what boot.run tells: from its marker "game" to its marker "over". That is read off the recording, so it
 * holds however the player went to and fro in time. Not kept are runs shorter than three seconds, tries of practice,
 * playbacks and what was played on from one, and runs whose board was changed from outside, which no demo can repeat.
 *
 * While a run is on, its recording is also written to user:resume/ID.demo, which grows by a second a second; so what a
 * kill leaves lacks less than one. A run that is over removes it.
 */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>
#include "../../../platform/platform.h"
#include "../../base/hash.h"
#include "../../common/files.h"
#include "../replays/roms.h"
#include "cab_parts.h"

enum {
    SHORTEST = 3 * 60, /* frames of a run that is kept; one that ends in a fault may be shorter */
    RETRY_EVERY = 60 * 60
};

void cab_resume_path(struct cab *cab, char path[CAB_NAME])
{
    snprintf(path, CAB_NAME, "user:resume/%s.demo", cab_cart(cab)->manifest.id);
}

static struct demo_writer *writer(struct cab *cab)
{
    return &cab->session.now->writer;
}

/* Is this a session whose runs are kept? */
static bool keeps(struct cab *cab)
{
    return !cab->session.demo && !cab->options.demo && !cab->taken && !cab->start.practice.section[0] &&
           !(writer(cab)->demo.flags & DEMO_TOUCHED);
}

/* One sentence, in the log and over the picture; the run goes on. */
static void complain(struct cab *cab, const char *err, const char *what)
{
    cab_notice(cab, CAB_NOTICE_FRAMES, "%s: %s", what, err);
    cab_say(cab, "curtain: %s: %s", what, err);
}

/* ---- what cannot be written ---- */

void cab_save_failed(struct cab *cab, const char *err)
{
    cab_say(cab, "curtain: %s", err);
    if (!cab->unsaved.shown) {
        cab->unsaved.wait = RETRY_EVERY;
        cab_notice(cab, CAB_NOTICE_FRAMES, "Not saved; retrying every minute: %s", err);
    }
    cab->unsaved.shown = true;
}

bool cab_save(struct cab *cab, const char *path, const void *bytes, size_t size)
{
    size_t waits;
    const bool known = unsaved_bytes(cab->unsaved.files, path, &waits) != NULL;
    char err[FILES_ERR_SIZE];

    if (unsaved_save(&cab->unsaved.files, path, bytes, size, err, sizeof err))
        return true;
    if (!known)
        cab_save_failed(cab, err);
    return false;
}

/* Keeps the ROM that runs, for what is recorded on it. */
static bool keep_rom(struct cab *cab)
{
    const struct cart *cart = cab_cart(cab);
    char path[ROMS_PATH], err[FILES_ERR_SIZE];
    size_t waits;

    roms_path(path, cart->manifest.id, rom_hash(cart->rom));
    const bool known = unsaved_bytes(cab->unsaved.files, path, &waits) != NULL;
    if (roms_keep(&cab->unsaved.files, cart->manifest.id, cart->rom, err, sizeof err))
        return true;
    if (!known)
        cab_save_failed(cab, err);
    return false;
}

/* ---- score tables ---- */

/* The rows of a table as they stand now. */
static int rows_now(struct cab *cab, const char *table, const char *ship, struct nv_row rows[NV_MAX_ROWS])
{
    size_t size;
    uint32_t changed;
    const uint8_t *image = board_nvram(cab_live(cab), &size, &changed);
    const struct nvram nv = { .s.live = (uint32_t)size, .bytes = (uint8_t *)(uintptr_t)image }; /* is only read */

    return nvram_get_rows(&nv, table, ship, rows);
}

static bool row_stands(void *of, const struct replay_meta_row *row)
{
    struct cab *cab = of;
    struct nv_row rows[NV_MAX_ROWS];
    const int n = rows_now(cab, row->table, row->row.ship, rows);

    for (int i = 0; i < n; i++)
        if (rows[i].score == row->row.score && strcmp(rows[i].name, row->row.name) == 0)
            return true;
    return false;
}

/* The row that a marker tells of. */
static bool row_of(struct cab *cab, const struct board_marker *m, struct replay_meta_row *row)
{
    struct nv_row rows[NV_MAX_ROWS];
    const int n = rows_now(cab, m->name, m->parent, rows);

    if (m->value < 1 || m->value > n)
        return false;
    snprintf(row->table, sizeof row->table, "%s", m->name);
    row->row = rows[m->value - 1];
    return true;
}

/* A row that is entered after the run's end, as after a name is asked for, goes to its replay. */
static void take_row(struct cab *cab, const struct board_marker *m)
{
    struct cab_keep *k = &cab->keep;
    struct cab_run *waiting = cab->unsaved.runs;
    struct replays list;
    struct replay_meta_row row;
    char err[512];

    if (!row_of(cab, m, &row))
        return;
    if (!k->on && k->waits && waiting) {
        waiting->meta.row[waiting->meta.rows < REPLAY_MAX_ROWS ? waiting->meta.rows++ : REPLAY_MAX_ROWS - 1] = row;
        return;
    }
    if (k->on || !k->stem[0]) {
        if (k->rows < REPLAY_MAX_ROWS)
            k->row[k->rows++] = row;
        return;
    }
    replays_open(&list, cab_cart(cab)->manifest.id);
    for (int i = 0; i < list.n; i++)
        if (strcmp(list.list[i].stem, k->stem) == 0 &&
            !replays_add_row(&list, i, &row, &cab->unsaved.files, err, sizeof err))
            cab_save_failed(cab, err);
    replays_close(&list);
}

/* ---- replays ---- */

/* What was kept of a run when it was left goes when the run has been played to its end. */
static void remove_left(struct replays *list, const struct replay_meta *whole)
{
    char err[256];

    for (int i = list->n - 1; i > 0; i--) {
        const struct replay_meta *c = &list->list[i].meta;
        if (whole->flags & DEMO_RESUMED && c->end == REPLAY_LEFT && !c->name[0] && c->seed == whole->seed &&
            c->first == whole->first && c->last <= whole->last)
            replays_delete(list, i, err, sizeof err);
    }
}

static bool add(struct cab *cab, const uint8_t *bytes, size_t size, const struct replay_meta *c, const struct thumb *t,
                char *err, size_t err_size)
{
    struct replays list;

    replays_open(&list, c->id);
    bool good = replays_add(&list, bytes, size, c, t, err, err_size);
    if (good) {
        snprintf(cab->keep.stem, sizeof cab->keep.stem, "%s", list.list[0].stem);
        remove_left(&list, c);
        replays_prune(&list, cab->config.replays, row_stands, cab);
        replays_collect_roms(&list, rom_hash(cab_cart(cab)->rom));
    }
    replays_close(&list);
    return good;
}

static void describe(struct cab *cab, struct replay_meta *c, enum replay_meta_end end)
{
    const struct manifest *m = &cab_cart(cab)->manifest;
    const int difficulty = board_current_difficulty(cab_live(cab));

    replay_meta_of_demo(c, &writer(cab)->demo);
    c->end = end;
    c->date = (int64_t)time(NULL);
    snprintf(c->difficulty, sizeof c->difficulty, "%s",
             difficulty < m->n_difficulties ? m->difficulties[difficulty] : "");
    for (int p = 0; p < MAX_PLAYERS; p++)
        c->points[p] = board_points(cab_live(cab), p);
    c->rows = cab->keep.rows;
    memcpy(c->row, cab->keep.row, sizeof c->row);
}

/* Takes bytes, which it frees in the end. */
static void wait_with(struct cab *cab, uint8_t *bytes, size_t size, const struct replay_meta *c, const struct thumb *t)
{
    struct cab_run *run = malloc(sizeof *run);

    if (!run) {
        free(bytes);
        return;
    }
    *run = (struct cab_run){ cab->unsaved.runs, bytes, size, *c, *t };
    cab->unsaved.runs = run;
    cab->keep.waits = true;
}

/* The run that is on ends here, and is kept. False: there is no replay of it yet. */
static bool keep_run(struct cab *cab, enum replay_meta_end end)
{
    struct replay_meta meta;
    struct thumb thumb;
    char err[FILES_ERR_SIZE];
    size_t size;
    const uint32_t frames = writer(cab)->demo.frames - cab->keep.first;

    cab->keep.stem[0] = 0;
    cab->keep.waits = false;
    if (cab->config.replays == 0 || (frames < SHORTEST && end != REPLAY_FAULT))
        return true;
    uint8_t *bytes = demo_encode_now(writer(cab), cab_live(cab), &size);
    if (!bytes) {
        complain(cab, "out of memory", "This run is not saved");
        return false;
    }
    describe(cab, &meta, end);
    thumb_make(&thumb, &cab->picture.fb, cab->picture.rgb);
    const bool rom = keep_rom(cab);
    if (rom && add(cab, bytes, size, &meta, &thumb, err, sizeof err)) {
        free(bytes);
        return true;
    }
    if (rom)
        cab_save_failed(cab, err);
    wait_with(cab, bytes, size, &meta, &thumb);
    return false;
}

/* ---- where one stands ---- */

static void drop_spare(struct cab *cab)
{
    demo_remove_spare_file(writer(cab));
    cab->keep.spare = false;
}

/* The file stays, for there is nothing else yet of a run that is over. */
static void leave_spare(struct cab *cab)
{
    cab->unsaved.left_run = cab->keep.spare;
    demo_record_to_spare_file(writer(cab), NULL);
    cab->keep.spare = false;
}

static bool spare_failed(struct cab *cab)
{
    struct demo_writer *w = writer(cab);

    if (!w->spare_err[0])
        return false;
    if (w->spare_file.write_failed)
        cab_save_failed(cab, w->spare_err);
    else /* it is another program's now */
        complain(cab, w->spare_err, "Progress is no longer being saved");
    cab->unsaved.spare = w->spare_file.write_failed;
    w->spare_err[0] = 0;
    return true;
}

void cab_keep_left(struct cab *cab)
{
    struct replays list;
    struct demo d;
    struct replay_meta meta;
    char path[CAB_NAME], err[FILES_ERR_SIZE] = "out of memory";
    uint8_t *bytes;
    size_t size;
    bool there = false;

    cab_resume_path(cab, path);
    cab->unsaved.left_run = plat_file_size(path) >= 0;
    if (!cab->unsaved.left_run)
        return;
    if (!files_read(path, path, DEMO_MAX_BYTES, &bytes, &size, err, sizeof err)) {
        cab_save_failed(cab, err);
        return;
    }
    bool good = demo_read(&d, bytes, size, err, sizeof err) && replay_meta_of_demo(&meta, &d) &&
                meta.last - meta.first >= SHORTEST && cab->config.replays > 0 &&
                (d.complete || d.checksum_frames == d.frames);
    free(bytes);
    if (good && replays_open(&list, cab_cart(cab)->manifest.id)) {
        for (int i = 0; i < list.n; i++)
            there = there || (list.list[i].meta.seed == meta.seed && list.list[i].meta.first == meta.first &&
                              list.list[i].meta.last >= meta.last);
        replays_close(&list);
    }
    d.complete = true; /* what is there is all of it */
    bytes = good && !there ? demo_encode(&d, &size) : NULL;
    meta.date = (int64_t)time(NULL);
    const bool saved = !good || there || (bytes && add(cab, bytes, size, &meta, NULL, err, sizeof err));
    cab->keep.stem[0] = 0;
    free(bytes);
    demo_free(&d);
    if (saved)
        plat_remove(path);
    else
        cab_save_failed(cab, err);
    cab->unsaved.left_run = !saved;
}

void cab_keep_here(struct cab *cab)
{
    char path[CAB_NAME];

    cab_resume_path(cab, path);
    if (!cab->config.resume || cab->unsaved.left_run)
        return;
    cab->unsaved.spare = !keep_rom(cab);
    if (!cab->unsaved.spare)
        demo_record_to_spare_file(writer(cab), path);
    cab->keep.spare = writer(cab)->spare_file.path[0] != 0 && !spare_failed(cab);
}

static void begin(struct cab *cab, uint32_t frame)
{
    struct cab_keep *k = &cab->keep;

    if (k->on && !keep_run(cab, REPLAY_LEFT))
        leave_spare(cab);
    else
        drop_spare(cab);
    k->on = true;
    k->first = frame;
    k->rows = 0;
    cab_keep_left(cab);
    cab_keep_here(cab);
}

static void end_run(struct cab *cab, enum replay_meta_end end)
{
    if (keep_run(cab, end))
        drop_spare(cab);
    else
        leave_spare(cab);
    cab->keep.on = false;
    cab->keep.rows = 0;
}

static void end(struct cab *cab, const char *how)
{
    if (!cab->keep.on)
        return;
    end_run(cab, strcmp(how, "clear") == 0 ? REPLAY_CLEAR : strcmp(how, "quit") == 0 ? REPLAY_QUIT : REPLAY_OVER);
}

/* ---- from tick to tick ---- */

/* The run that is on before a frame, by the recording. */
static void find_run(struct cab *cab, uint32_t before)
{
    const struct demo *d = &writer(cab)->demo;

    cab->keep.on = false;
    for (uint32_t i = 0; i < d->n_markers && d->markers[i].frame < before; i++) {
        if (d->markers[i].marker.kind == MARKER_GAME) {
            cab->keep.on = true;
            cab->keep.first = d->markers[i].frame;
        } else if (d->markers[i].marker.kind == MARKER_OVER) {
            cab->keep.on = false;
        }
    }
}

/* The recording was cut, because the player went back, or is another one. */
static void follow(struct cab *cab, uint32_t frames)
{
    find_run(cab, frames);
    cab->keep.rows = 0;
    if (!cab->keep.on)
        drop_spare(cab);
    else if (!cab->keep.spare)
        cab_keep_here(cab);
}

void cab_keep_follow(struct cab *cab)
{
    cab->keep.frames = writer(cab)->demo.frames;
    follow(cab, cab->keep.frames + 1);
}

static void take_marker(struct cab *cab, const struct board_marker *m)
{
    if (m->kind == MARKER_GAME)
        begin(cab, writer(cab)->demo.frames);
    else if (m->kind == MARKER_OVER)
        end(cab, m->name);
    else if (m->kind == MARKER_ROW)
        take_row(cab, m);
}

void cab_keep_tick(struct cab *cab)
{
    const struct board_out *out = board_last_output(cab_live(cab));
    const uint32_t frames = writer(cab)->demo.frames;

    if (!keeps(cab)) {
        cab->keep.on = false;
        drop_spare(cab);
        return;
    }
    if (frames != cab->keep.frames + 1)
        follow(cab, frames);
    cab->keep.frames = frames;
    for (int i = 0; i < out->marker_count; i++)
        take_marker(cab, &out->marker[i]);
    if (out->fault && cab->keep.on)
        end_run(cab, REPLAY_FAULT);
    if (cab->keep.spare && spare_failed(cab))
        cab->keep.spare = false;
}

void cab_keep_leave(struct cab *cab)
{
    const struct board *b = cab_live(cab);

    if (keeps(cab) && !cab_fault(cab)) {
        if (board_frame(b) < writer(cab)->demo.frames)
            cab_check_recording(cab, demo_rewind(writer(cab), board_frame(b)));
        find_run(cab, writer(cab)->demo.frames + 1);
        if (!cab->keep.on || writer(cab)->demo.frames - cab->keep.first < SHORTEST)
            drop_spare(cab);
        if (cab->keep.on)
            keep_run(cab, REPLAY_LEFT);
    }
    memset(&cab->keep, 0, sizeof cab->keep); /* the spare is finished with the recording */
}

/* ---- another try ---- */

static void say_lost(void *of, const char *err)
{
    cab_say(of, "curtain: not saved: %s", err);
}

static void say_nothing(void *of, const char *err)
{
    (void)of;
    (void)err;
}

/* The oldest first, as replays are listed by their age. */
static bool retry_runs(struct cab *cab, struct cab_run **at, void (*failed)(void *of, const char *err))
{
    struct cab_run *run = *at;
    char err[FILES_ERR_SIZE];

    if (!run)
        return true;
    if (!retry_runs(cab, &run->next, failed))
        return false;
    if (!roms_has(run->meta.id, run->meta.rom)) /* that it is not there was said */
        return false;
    if (!add(cab, run->bytes, run->size, &run->meta, &run->thumb, err, sizeof err)) {
        failed(cab, err);
        return false;
    }
    if (cab->keep.waits && run == cab->unsaved.runs)
        cab->keep.waits = false;
    else
        cab->keep.stem[0] = 0; /* of another run than the last */
    *at = run->next;
    free(run->bytes);
    free(run);
    return true;
}

static bool retry_settings(struct cab *cab, void (*failed)(void *of, const char *err))
{
    char err[FILES_ERR_SIZE + CONFIG_LINE];

    if (!cab->unsaved.settings || config_save(&cab->kept, err, sizeof err)) {
        cab->unsaved.settings = false;
        return true;
    }
    failed(cab, err);
    return false;
}

/* The run that was left, then where the present one is. */
static bool retry_spare(struct cab *cab)
{
    if (cab->unsaved.left_run)
        cab_keep_left(cab);
    if (cab->unsaved.left_run)
        return false;
    if (cab->unsaved.spare && cab->keep.on && keeps(cab))
        cab_keep_here(cab);
    else
        cab->unsaved.spare = false;
    return !cab->unsaved.spare;
}

static bool retry(struct cab *cab, void (*failed)(void *of, const char *err))
{
    const bool files = unsaved_retry(&cab->unsaved.files, failed, cab),
               runs = retry_runs(cab, &cab->unsaved.runs, failed), settings = retry_settings(cab, failed);

    return files && runs && settings;
}

void cab_retry(struct cab *cab)
{
    struct cab_unsaved *u = &cab->unsaved;

    if (!u->shown || --u->wait > 0)
        return;
    u->wait = RETRY_EVERY;
    const bool all = retry(cab, say_nothing), spare = retry_spare(cab), recorded = demo_retry_write(writer(cab));
    if (!all || !spare || !recorded)
        return;
    u->shown = false;
    cab_notice(cab, CAB_NOTICE_FRAMES, "All data has been saved");
    cab_say(cab, "curtain: all data has been saved");
}

void cab_retry_last(struct cab *cab)
{
    struct cab_unsaved *u = &cab->unsaved;
    const bool all = retry(cab, say_lost);

    if (u->left_run && !u->runs && cab->session.now)
        cab_keep_left(cab);
    if ((!all || u->left_run) && cab->result == RESULT_DONE)
        cab->result = RESULT_HOST_FAILED;
    unsaved_free(&u->files);
    while (u->runs) {
        struct cab_run *run = u->runs;
        u->runs = run->next;
        free(run->bytes);
        free(run);
    }
}

void cab_check_recording(struct cab *cab, bool good)
{
    const struct demo_writer *writer = &cab->session.now->writer;

    if (good)
        return;
    if (writer->file.write_failed) { /* it is tried again, and the last time when the session closes */
        cab_save_failed(cab, cab->session.err);
        return;
    }
    cab_say(cab, "curtain: %s", cab->session.err);
    cab->result = RESULT_HOST_FAILED;
}
