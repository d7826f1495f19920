/*
 * play_autosave.c - saves runs: a replay of each finished run, and the run in progress.
 *
 * A run goes from boot.run's marker "game" to its marker "over". The markers are read from the recording, so they are
 * right however the player has moved in time. Not saved are runs shorter than three seconds, practice attempts,
 * playbacks and runs continued from one, and runs whose board was changed from outside, which no demo can repeat.
 *
 * The recording of the run in progress is also written to user:resume/ID.demo, a second at a time. If the program is
 * killed, less than a second is lost. The file is removed when the run is over.
 */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>
#include "../../../platform/platform.h"
#include "../../base/hash.h"
#include "../../common/files.h"
#include "../replays/roms.h"
#include "play_state.h"

enum {
    THUMB_EVERY = 256, /* frames: a thumbnail is of the last moments of a run, but not of its end, which flashes */
    SHORTEST = 3 * 60, /* frames of a saved run; a run that ends in a fault may be shorter */
    RETRY_EVERY = 60 * 60
};

void play_resume_path(struct play *play, char path[PLAY_NAME_SIZE])
{
    snprintf(path, PLAY_NAME_SIZE, "user:resume/%s.demo", play_cart(play)->manifest.id);
}

static struct demo_writer *writer(struct play *play)
{
    return &play->session.now->writer;
}

/* Returns whether runs of this window are saved. */
static bool saves_runs(struct play *play)
{
    return !play->session.demo && !play->options.demo && !play->replay.taken_over && !play->start.practice.section[0] &&
           !(writer(play)->demo.flags & DEMO_TOUCHED);
}

/* ---- files that can't be written ---- */

void play_save_failed(struct play *play, const char *err)
{
    play_log(play, "curtain: %s", err);
    if (!play->unsaved.shown) {
        play->unsaved.frames = RETRY_EVERY;
        play_show_message(play, MESSAGE_FRAMES, "Not saved; retrying every minute: %s", err);
    }
    play->unsaved.shown = true;
}

/* Takes the result of saving a file. known: it had failed before, and that was reported. */
static bool check_saved(struct play *play, bool saved, bool known, const char *err)
{
    if (!saved && !known)
        play_save_failed(play, err);
    return saved;
}

static bool is_unsaved(const struct play *play, const char *path)
{
    size_t size;

    return unsaved_bytes(play->unsaved.files, path, &size) != NULL;
}

bool play_save(struct play *play, const char *path, const void *bytes, size_t size)
{
    const bool known = is_unsaved(play, path);
    char err[FILES_ERR_SIZE];
    const bool saved = unsaved_save(&play->unsaved.files, path, bytes, size, err, sizeof err);

    return check_saved(play, saved, known, err);
}

/* Stores the running ROM, for recordings made on it. */
static bool save_rom(struct play *play)
{
    const struct cart *cart = play_cart(play);
    char path[ROMS_PATH], err[FILES_ERR_SIZE];

    roms_path(path, cart->manifest.id, rom_hash(cart->rom));
    const bool known = is_unsaved(play, path);
    const bool saved = roms_store(&play->unsaved.files, cart->manifest.id, cart->rom, err, sizeof err);
    return check_saved(play, saved, known, err);
}

/* ---- score tables ---- */

/* Reads the present rows of a table. Returns their number. */
static int table_rows(struct play *play, const char *table, const char *ship, struct nv_row rows[NV_MAX_ROWS])
{
    size_t size;
    uint32_t changed;
    const uint8_t *image = board_nvram(play_board(play), &size, &changed);
    const struct nvram nv = { .s.live = (uint32_t)size, .bytes = (uint8_t *)(uintptr_t)image }; /* only read */

    return nvram_get_rows(&nv, table, ship, rows);
}

static bool has_row(void *context, const struct replay_meta_row *row)
{
    struct nv_row rows[NV_MAX_ROWS];
    const int n = table_rows(context, row->table, row->row.ship, rows);

    for (int i = 0; i < n; i++)
        if (rows[i].score == row->row.score && strcmp(rows[i].name, row->row.name) == 0)
            return true;
    return false;
}

/* Finds the row that a marker reports. Returns false if there is none. */
static bool marker_row(struct play *play, const struct board_marker *m, struct replay_meta_row *row)
{
    struct nv_row rows[NV_MAX_ROWS];
    const int n = table_rows(play, m->name, m->parent, rows);

    if (m->value < 1 || m->value > n)
        return false;
    snprintf(row->table, sizeof row->table, "%s", m->name);
    row->row = rows[m->value - 1];
    return true;
}

static void add_row_to_replay(struct play *play, const struct replay_meta_row *row)
{
    struct replays list;
    char err[512];

    replays_open(&list, play_cart(play)->manifest.id);
    for (int i = 0; i < list.n; i++)
        if (strcmp(list.list[i].stem, play->autosave.stem) == 0 &&
            !replays_add_row(&list, i, row, &play->unsaved.files, err, sizeof err))
            play_save_failed(play, err);
    replays_close(&list);
}

/* A row entered after the end of a run, for example when a name is asked for, is added to the run's replay. */
static void take_row(struct play *play, const struct board_marker *m)
{
    struct autosave *a = &play->autosave;
    struct unsaved_run *run = play->unsaved.runs;
    struct replay_meta_row row;

    if (!marker_row(play, m, &row))
        return;
    if (!a->on && a->last_run_unsaved && run)
        run->meta.row[run->meta.rows < REPLAY_MAX_ROWS ? run->meta.rows++ : REPLAY_MAX_ROWS - 1] = row;
    else if (!a->on && a->stem[0])
        add_row_to_replay(play, &row);
    else if (a->rows < REPLAY_MAX_ROWS)
        a->row[a->rows++] = row;
}

/* ---- replays ---- */

/* Removes the replays of a run's earlier, unfinished parts when the whole run has been saved. */
static void remove_unfinished(struct replays *list, const struct replay_meta *whole)
{
    char err[256];

    for (int i = list->n - 1; i > 0; i--) {
        const struct replay_meta *c = &list->list[i].meta;
        if (whole->flags & DEMO_RESUMED && c->end == REPLAY_LEFT && !c->name[0] && c->seed == whole->seed &&
            c->first == whole->first && c->last <= whole->last)
            replays_delete(list, i, err, sizeof err);
    }
}

static bool add_replay(struct play *play, const uint8_t *bytes, size_t size, const struct replay_meta *c,
                       const struct thumb *t, char *err, size_t err_size)
{
    struct replays list;

    replays_open(&list, c->id);
    bool good = replays_add(&list, bytes, size, c, t, err, err_size);
    if (good) {
        snprintf(play->autosave.stem, sizeof play->autosave.stem, "%s", list.list[0].stem);
        remove_unfinished(&list, c);
        replays_prune(&list, play->config.replays, has_row, play);
        replays_collect_roms(&list, rom_hash(play_cart(play)->rom));
    }
    replays_close(&list);
    return good;
}

static void describe_run(struct play *play, struct replay_meta *c, enum replay_meta_end end)
{
    const struct manifest *m = &play_cart(play)->manifest;
    const int difficulty = board_current_difficulty(play_board(play));

    replay_meta_of_demo(c, &writer(play)->demo);
    c->end = end;
    c->date = (int64_t)time(NULL);
    snprintf(c->difficulty, sizeof c->difficulty, "%s",
             difficulty < m->n_difficulties ? m->difficulties[difficulty] : "");
    for (int p = 0; p < MAX_PLAYERS; p++)
        c->points[p] = board_points(play_board(play), p);
    c->rows = play->autosave.rows;
    memcpy(c->row, play->autosave.row, sizeof c->row);
}

/* Takes ownership of bytes. */
static void add_unsaved_run(struct play *play, uint8_t *bytes, size_t size, const struct replay_meta *c,
                            const struct thumb *t)
{
    struct unsaved_run *run = malloc(sizeof *run);

    if (!run) {
        free(bytes);
        return;
    }
    *run = (struct unsaved_run){ play->unsaved.runs, bytes, size, *c, *t };
    play->unsaved.runs = run;
    play->autosave.last_run_unsaved = true;
}

/* Saves the run in progress, which ends here. Returns false if its replay could not be written yet. */
static bool save_run(struct play *play, enum replay_meta_end end)
{
    struct replay_meta meta;
    struct thumb *thumb = &play->autosave.thumb;
    char err[FILES_ERR_SIZE];
    size_t size;
    const uint32_t frames = writer(play)->demo.frames - play->autosave.first;

    play->autosave.stem[0] = 0;
    play->autosave.last_run_unsaved = false;
    if (play->config.replays == 0 || (frames < SHORTEST && end != REPLAY_FAULT))
        return true;
    uint8_t *bytes = demo_encode_now(writer(play), play_board(play), &size);
    if (!bytes) {
        play_warn(play, "This run is not saved: out of memory");
        return false;
    }
    describe_run(play, &meta, end);
    if (!thumb->w)
        thumb_make(thumb, &play->drawing.picture.fb, play->drawing.picture.rgb);
    const bool rom = save_rom(play);
    if (rom && add_replay(play, bytes, size, &meta, thumb, err, sizeof err)) {
        free(bytes);
        return true;
    }
    if (rom)
        play_save_failed(play, err);
    add_unsaved_run(play, bytes, size, &meta, thumb);
    return false;
}

/* ---- the resume file ---- */

static void remove_resume_file(struct play *play)
{
    demo_remove_spare_file(writer(play));
    play->autosave.resumable = false;
}

/* Saves the run in progress; its resume file stays if there is no replay yet. */
static void finish_run(struct play *play, enum replay_meta_end end)
{
    if (save_run(play, end)) {
        remove_resume_file(play);
    } else {
        play->unsaved.unfinished_run = play->autosave.resumable;
        demo_record_to_spare_file(writer(play), NULL);
        play->autosave.resumable = false;
    }
    play->autosave.on = false;
    play->autosave.rows = 0;
}

static bool resume_file_failed(struct play *play)
{
    struct demo_writer *w = writer(play);

    if (!w->spare_err[0])
        return false;
    if (w->spare_file.write_failed)
        play_save_failed(play, w->spare_err);
    else /* another program writes it now */
        play_warn(play, "Progress is no longer being saved: %s", w->spare_err);
    play->unsaved.resume_file = w->spare_file.write_failed;
    w->spare_err[0] = 0;
    return true;
}

static bool has_replay(struct play *play, const struct replay_meta *meta)
{
    struct replays list;
    bool found = false;

    replays_open(&list, play_cart(play)->manifest.id);
    for (int i = 0; i < list.n; i++) {
        const struct replay_meta *c = &list.list[i].meta;
        found = found || (c->seed == meta->seed && c->first == meta->first && c->last >= meta->last);
    }
    replays_close(&list);
    return found;
}

/* Adds the replay of an unfinished run, unless it is damaged, too short, or saved already. */
static bool archive(struct play *play, const uint8_t *file, size_t size, char *err, size_t err_size)
{
    struct demo d;
    struct replay_meta meta;
    bool saved = true;

    if (demo_read(&d, file, size, err, err_size) && replay_meta_of_demo(&meta, &d) &&
        meta.last - meta.first >= SHORTEST && play->config.replays > 0 &&
        (d.complete || d.checksum_frames == d.frames) && !has_replay(play, &meta)) {
        d.complete = true; /* there is no more of it */
        meta.date = (int64_t)time(NULL);
        snprintf(err, err_size, "out of memory");
        uint8_t *bytes = demo_encode(&d, &size);
        saved = bytes && add_replay(play, bytes, size, &meta, NULL, err, err_size);
        free(bytes);
    }
    demo_free(&d);
    play->autosave.stem[0] = 0;
    return saved;
}

void play_archive_unfinished(struct play *play)
{
    char path[PLAY_NAME_SIZE], err[FILES_ERR_SIZE];
    uint8_t *bytes;
    size_t size;

    play_resume_path(play, path);
    play->unsaved.unfinished_run = plat_file_size(path) >= 0;
    if (!play->unsaved.unfinished_run)
        return;
    if (!files_read(path, path, DEMO_MAX_BYTES, &bytes, &size, err, sizeof err)) {
        play_save_failed(play, err);
        return;
    }
    if (archive(play, bytes, size, err, sizeof err)) {
        plat_remove(path);
        play->unsaved.unfinished_run = false;
    } else {
        play_save_failed(play, err);
    }
    free(bytes);
}

void play_autosave_start(struct play *play)
{
    char path[PLAY_NAME_SIZE];

    play_resume_path(play, path);
    if (!play->config.resume || play->unsaved.unfinished_run)
        return;
    play->unsaved.resume_file = !save_rom(play);
    if (!play->unsaved.resume_file)
        demo_record_to_spare_file(writer(play), path);
    play->autosave.resumable = writer(play)->spare_file.path[0] != 0 && !resume_file_failed(play);
}

/* ---- from tick to tick ---- */

static void start_run(struct play *play, uint32_t frame)
{
    struct autosave *a = &play->autosave;

    if (a->on)
        finish_run(play, REPLAY_LEFT);
    else
        remove_resume_file(play);
    a->on = true;
    a->first = frame;
    a->thumb.w = 0;
    a->rows = 0;
    play_archive_unfinished(play);
    play_autosave_start(play);
}

static enum replay_meta_end end_of(const char *marker)
{
    return strcmp(marker, "clear") == 0 ? REPLAY_CLEAR : strcmp(marker, "quit") == 0 ? REPLAY_QUIT : REPLAY_OVER;
}

/* Finds the run in progress before a frame in the recording. */
static void find_run(struct play *play, uint32_t before)
{
    const struct demo *d = &writer(play)->demo;

    play->autosave.on = false;
    for (uint32_t i = 0; i < d->n_markers && d->markers[i].frame < before; i++) {
        if (d->markers[i].marker.kind == MARKER_GAME) {
            play->autosave.on = true;
            play->autosave.first = d->markers[i].frame;
        } else if (d->markers[i].marker.kind == MARKER_OVER) {
            play->autosave.on = false;
        }
    }
}

/* Finds the run in progress after the recording was truncated, because the player went back, or replaced. */
static void sync_to(struct play *play, uint32_t frames)
{
    find_run(play, frames);
    play->autosave.rows = 0;
    if (!play->autosave.on)
        remove_resume_file(play);
    else if (!play->autosave.resumable)
        play_autosave_start(play);
}

void play_autosave_sync(struct play *play)
{
    play->autosave.frames = writer(play)->demo.frames;
    sync_to(play, play->autosave.frames + 1);
}

static void take_marker(struct play *play, const struct board_marker *m)
{
    practice_reach(&play->practice, m);
    if (m->kind == MARKER_GAME)
        start_run(play, writer(play)->demo.frames);
    else if (m->kind == MARKER_OVER && play->autosave.on)
        finish_run(play, end_of(m->name));
    else if (m->kind == MARKER_ROW)
        take_row(play, m);
}

void play_autosave_tick(struct play *play)
{
    struct autosave *a = &play->autosave;
    const struct board_out *out = board_last_output(play_board(play));
    const uint32_t frames = writer(play)->demo.frames;

    if (!saves_runs(play)) {
        a->on = false;
        remove_resume_file(play);
        return;
    }
    if (frames != a->frames + 1)
        sync_to(play, frames);
    a->frames = frames;
    if (a->on && (frames - a->first) % THUMB_EVERY == THUMB_EVERY - 1)
        thumb_make(&a->thumb, &play->drawing.picture.fb, play->drawing.picture.rgb);
    for (int i = 0; i < out->marker_count; i++)
        take_marker(play, &out->marker[i]);
    if (out->fault && a->on)
        finish_run(play, REPLAY_FAULT);
    if (a->resumable && resume_file_failed(play))
        a->resumable = false;
}

bool play_is_resumable(const struct play *play)
{
    return play->autosave.on && play->autosave.resumable &&
           board_frame(play_board(play)) >= play->autosave.first + SHORTEST;
}

void play_autosave_end(struct play *play)
{
    const uint32_t frame = board_frame(play_board(play));

    if (saves_runs(play) && !play_fault(play)) {
        if (frame < writer(play)->demo.frames)
            play_check_recording(play, demo_rewind(writer(play), frame));
        find_run(play, writer(play)->demo.frames + 1);
        if (!play->autosave.on || writer(play)->demo.frames - play->autosave.first < SHORTEST)
            remove_resume_file(play);
        if (play->autosave.on)
            save_run(play, REPLAY_LEFT);
    }
    memset(&play->autosave, 0, sizeof play->autosave); /* the recording finishes the resume file */
}

/* ---- trying again ---- */

static void log_lost(void *context, const char *err)
{
    play_log(context, "curtain: not saved: %s", err);
}

static void ignore(void *context, const char *err)
{
    (void)context;
    (void)err;
}

static void free_run(struct unsaved_run **at)
{
    struct unsaved_run *run = *at;

    *at = run->next;
    free(run->bytes);
    free(run);
}

/* Retries the oldest run first, because replays are listed by age. */
static bool retry_runs(struct play *play, struct unsaved_run **at, void (*failed)(void *context, const char *err))
{
    struct unsaved_run *run = *at;
    char err[FILES_ERR_SIZE];

    if (!run)
        return true;
    if (!retry_runs(play, &run->next, failed))
        return false;
    if (!roms_has(run->meta.id, run->meta.rom)) /* its error was reported */
        return false;
    if (!add_replay(play, run->bytes, run->size, &run->meta, &run->thumb, err, sizeof err)) {
        failed(play, err);
        return false;
    }
    if (play->autosave.last_run_unsaved && run == play->unsaved.runs)
        play->autosave.last_run_unsaved = false;
    else
        play->autosave.stem[0] = 0; /* not the last run's */
    free_run(at);
    return true;
}

static bool retry_settings(struct play *play, void (*failed)(void *context, const char *err))
{
    char err[FILES_ERR_SIZE + CONFIG_LINE];

    play->unsaved.settings = play->unsaved.settings && !config_save(&play->saved_config, err, sizeof err);
    if (play->unsaved.settings)
        failed(play, err);
    return !play->unsaved.settings;
}

/* Retries the unfinished run, then the resume file of the present one. */
static bool retry_resume_file(struct play *play)
{
    struct play_unsaved *u = &play->unsaved;

    if (u->unfinished_run)
        play_archive_unfinished(play);
    if (u->unfinished_run)
        return false;
    if (u->resume_file && play->autosave.on && saves_runs(play))
        play_autosave_start(play);
    else
        u->resume_file = false;
    return !u->resume_file;
}

static bool retry(struct play *play, void (*failed)(void *context, const char *err))
{
    const bool files = unsaved_retry(&play->unsaved.files, failed, play),
               runs = retry_runs(play, &play->unsaved.runs, failed), settings = retry_settings(play, failed);

    return files && runs && settings;
}

void play_retry_saves(struct play *play)
{
    struct play_unsaved *u = &play->unsaved;

    if (!u->shown || --u->frames > 0)
        return;
    u->frames = RETRY_EVERY;
    const bool all = retry(play, ignore), resume_file = retry_resume_file(play),
               recorded = demo_retry_write(writer(play));
    if (!all || !resume_file || !recorded)
        return;
    u->shown = false;
    play_show_message(play, MESSAGE_FRAMES, "All data has been saved");
    play_log(play, "curtain: all data has been saved");
}

void play_final_retry(struct play *play)
{
    struct play_unsaved *u = &play->unsaved;
    const bool all = retry(play, log_lost);

    if (u->unfinished_run && !u->runs && play->session.now)
        play_archive_unfinished(play);
    if ((!all || u->unfinished_run) && play->result == RESULT_DONE)
        play->result = RESULT_HOST_FAILED;
    unsaved_free(&u->files);
    while (u->runs)
        free_run(&u->runs);
}

void play_check_recording(struct play *play, bool good)
{
    if (good)
        return;
    if (writer(play)->file.write_failed) { /* it is tried again, the last time when the session closes */
        play_save_failed(play, play->session.err);
        return;
    }
    play_log(play, "curtain: %s", play->session.err);
    play->result = RESULT_HOST_FAILED;
}
