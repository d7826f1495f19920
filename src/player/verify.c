/*
 * verify.c - the command `verify` (verify.h). The game is loaded once, and all demos use the same block of RAM. Nothing
 * else is retained between demos, so a list of names can have any length.
 */
#include "verify.h"

#include <inttypes.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "../../platform/platform.h"
#include "../common/byte_buffer.h"
#include "../common/clean.h"
#include "../common/files.h"
#include "../common/progress.h"
#include "game/game.h"
#include "../common/report.h"
#include "../demo/markers.h"
#include "replay.h"
#include "verify_json.h"

struct verify {
    const struct args *a;
    struct game game;
    struct replay replay;
    struct demo demo;
    struct demo_writer again; /* for --restamp and --rerecord */
    char doubt[160];          /* " (recorded with another game version)", or "" */
    const char *path;         /* of the current demo */
    bool batch;               /* names come from standard input */
    uint64_t done, all;       /* number of demos replayed, and of all; 0: unknown */
};

/* ---- lines ---- */

static enum result refuse(const struct verify *v, enum result result, const char *format, ...)
    __attribute__((format(printf, 3, 4)));
static void print_result(const struct verify *v, const char *path, const char *format, ...)
    __attribute__((format(printf, 3, 4)));

/* Prints a file name or another untrusted text. */
static void print_clean(const char *text)
{
    char line[2 * DEMO_PATH_SIZE];

    snprintf(line, sizeof line, "%s", text);
    clean_line(line);
    fputs(line, stdout);
}

/* Prints why a demo cannot be replayed; the message contains its name. Returns result. */
static enum result refuse(const struct verify *v, enum result result, const char *format, ...)
{
    char line[2048];
    va_list args;

    va_start(args, format);
    vsnprintf(line, sizeof line, format, args);
    va_end(args);
    if (v->a->json) {
        verify_json_refused(v->path, result == RESULT_HOST_FAILED, line);
        return result;
    }
    if (!v->batch)
        return report_line(result, "%s", line);
    print_clean(line);
    putchar('\n');
    return result;
}

static void print_result(const struct verify *v, const char *path, const char *format, ...)
{
    char line[2048];
    va_list args;

    va_start(args, format);
    vsnprintf(line, sizeof line, format, args);
    va_end(args);
    print_clean(path);
    fputs(": ", stdout);
    print_clean(line);
    print_clean(v->doubt);
    putchar('\n');
}

static void print_verdict(const struct verify *v, const char *path, const struct verdict *w)
{
    char text[1400];

    replay_text(&v->replay, &v->demo, w, text, sizeof text);
    print_result(v, path, "%s%s", text, w->kind == VERDICT_HOLDS && v->a->restamp ? ", restamped" : "");
}

/* ---- --verbose ---- */

static void print_hashes(const struct verify *v, const struct verdict *w)
{
    const uint64_t *row = demo_hashes(&v->demo, w->frame);
    uint16_t checksum = 0;

    for (int i = 0; i < v->demo.n_parts; i++) {
        unsigned long long here = v->replay.hashes[i];
        if (!(w->parts >> i & 1))
            continue;
        if (w->missing >> i & 1)
            report_print("  %s: this build does not have this part\n", v->demo.part_name[i]);
        else if (row)
            report_print("  %s: recorded %016llx, replayed %016llx\n", v->demo.part_name[i], (unsigned long long)row[i],
                         here);
        else if (demo_get_checksum(&v->demo, w->frame, i, &checksum))
            report_print("  %s: recorded checksum %04x, replayed %04x\n", v->demo.part_name[i], (unsigned)checksum,
                         (unsigned)(here & 0xffff));
    }
}

/* Finds the sections that contain a frame: the last marker of each kind, or NULL if a later marker ended it. */
static void markers_at(const struct demo *d, uint32_t frame, const struct demo_marker *in[MARKER_KINDS])
{
    enum { RUN = (1 << (MARKER_DEATH + 1)) - 1 };
    static const unsigned ends[MARKER_KINDS] = {
        [MARKER_STAGE] = 1 << MARKER_MARK | 1 << MARKER_WAVE | 1 << MARKER_BOSS | 1 << MARKER_PHASE,
        [MARKER_MARK] = 1 << MARKER_WAVE | 1 << MARKER_BOSS | 1 << MARKER_PHASE,
        [MARKER_WAVE] = 1 << MARKER_BOSS | 1 << MARKER_PHASE,
        [MARKER_BOSS] = 1 << MARKER_WAVE | 1 << MARKER_PHASE,
        [MARKER_WON] = 1 << MARKER_PHASE,
        [MARKER_LOST] = 1 << MARKER_PHASE,
        [MARKER_CLEAR] = 1 << MARKER_STAGE | 1 << MARKER_MARK | 1 << MARKER_WAVE | 1 << MARKER_BOSS | 1 << MARKER_PHASE,
        [MARKER_START] = RUN,
        [MARKER_GAME] = RUN,
        [MARKER_OVER] = RUN,
    };

    memset(in, 0, sizeof in[0] * MARKER_KINDS);
    for (uint32_t i = 0; i < d->n_markers && d->markers[i].frame <= frame; i++) {
        enum board_marker_kind kind = d->markers[i].marker.kind;
        in[kind] = &d->markers[i];
        for (int k = 0; k < MARKER_KINDS; k++)
            in[k] = ends[kind] >> k & 1 ? NULL : in[k];
    }
}

/* "in stage one, boss queen, phase bloom, 12.3 s after its start; player 1 died 2.0 s earlier" */
static void print_place_in_game(const struct demo *d, uint32_t frame)
{
    static const char *const kinds[MARKER_DEATH] = { "stage", "mark", "wave", "boss", "phase" };
    const struct demo_marker *in[MARKER_KINDS], *last = NULL, *death;

    markers_at(d, frame, in);
    for (int k = 0; k < MARKER_DEATH; k++) {
        if (!in[k])
            continue;
        report_print("%s %s %s", last ? "," : "  in", kinds[k], in[k]->marker.name);
        last = !last || in[k]->frame > last->frame ? in[k] : last;
    }
    if (last)
        report_print(", %.1f s after its start", (frame - last->frame) / 60.0);
    else
        report_print("  %.1f s after power-on", frame / 60.0);
    death = in[MARKER_DEATH];
    if (death)
        report_print("; player %s died %.1f s earlier", death->marker.name, (frame - death->frame) / 60.0);
    putchar('\n');
}

static void print_pads(const struct demo *d, uint32_t frame)
{
    static const char *const names[PAD_BUTTON_COUNT] = PAD_BUTTON_NAMES;
    uint16_t pads[MAX_PLAYERS];

    if (frame == 0)
        return;
    demo_pads(d, frame - 1, pads);
    report_print("  held:");
    for (int p = 0; p < MAX_PLAYERS; p++) {
        report_print("%s player %d", p ? ";" : "", p + 1);
        for (int i = 0; i < PAD_BUTTON_COUNT; i++)
            if (pads[p] >> i & 1)
                report_print(" %s", names[i]);
        if (pad_code(pads[p]))
            report_print(" code %u", pad_code(pads[p]));
        if (!pads[p])
            report_print(" nothing");
    }
    putchar('\n');
}

static void print_trace(const char *text)
{
    for (size_t n; *text; text += n + (text[n] == '\n')) {
        n = strcspn(text, "\n");
        report_print("  %.*s\n", (int)n, text);
    }
}

static void print_header(const struct demo *d)
{
    report_print("  format %u, core version %u, Lua %s, game %016llx, ROM %016llx\n", (unsigned)d->format,
                 (unsigned)d->core_version, d->lua_release, (unsigned long long)d->game_hash,
                 (unsigned long long)d->rom_hash);
    report_print("  seed %llu, difficulty %d, %s%s", (unsigned long long)d->start.seed, (int)d->start.difficulty,
                 d->start.practice.section[0] ? "from " : "from power-on", d->start.practice.section);
    if (d->start.lang[0])
        report_print(", language %s", d->start.lang);
    if (d->start.large_hud)
        report_print(", larger HUD");
    for (int i = 0; demo_flag_name(i); i++)
        report_print("%s%s", d->flags >> i & 1 ? ", " : "", d->flags >> i & 1 ? demo_flag_name(i) : "");
    report_print("\n  %d parts, %u rows, %u markers\n", d->n_parts, (unsigned)d->n_rows, (unsigned)d->n_markers);
}

static void print_details(const struct verify *v, const struct verdict *w)
{
    const struct board_fault *fault = replay_fault(&v->replay);

    print_header(&v->demo);
    if (w->kind == VERDICT_HOLDS)
        return;
    if (w->kind == VERDICT_DIFFERS)
        print_hashes(v, w);
    print_place_in_game(&v->demo, w->frame);
    print_pads(&v->demo, w->frame);
    if (fault && fault->trace[0])
        print_trace(fault->trace);
}

/* ---- demos ---- */

/* Progress counts all demos as equally long. */
static void show_progress(void *context, uint32_t frame)
{
    enum { WHOLE = 1000 };
    struct verify *v = context;
    const uint64_t done = v->done * WHOLE + (uint64_t)frame * WHOLE / v->demo.frames;
    char of[32] = "";

    if (v->all)
        snprintf(of, sizeof of, " of %llu", (unsigned long long)v->all);
    progress_update(done, v->all * WHOLE, "demo %llu%s, frame %u of %u", (unsigned long long)v->done + 1, of,
                    (unsigned)frame, (unsigned)v->demo.frames);
}

/* Saves the recording of the replay as the demo, in the newest format and with this ROM and core version. */
static enum result save_rerecorded(struct verify *v, const char *path)
{
    char err[1200];

    if (demo_save(&v->again.demo, path, err, sizeof err))
        return RESULT_DONE;
    return refuse(v, RESULT_HOST_FAILED, "%s", err);
}

static enum result print_json(const struct verify *v, const char *path, const struct verdict *w)
{
    char doubt[128];
    const struct verify_result replayed = {
        .path = path,
        .doubt = demo_replay_warning(&v->demo, &v->game.cart, doubt, sizeof doubt),
        .cart = &v->game.cart,
        .demo = &v->demo,
        .again = &v->again.demo,
        .replay = &v->replay,
        .verdict = w,
    };

    verify_json_replayed(&replayed);
    return w->kind == VERDICT_HOLDS ? RESULT_DONE : RESULT_DIFFERS;
}

static enum result verify_recording(struct verify *v, const char *path)
{
    struct verdict w;
    char err[512];
    v->replay.checksum_rate = (enum demo_checksum_rate)v->a->prints;
    bool records = v->a->restamp || v->a->json;
    enum result result =
        replay_run(&v->replay, &v->game.cart, &v->demo, records ? &v->again : NULL, &w, err, sizeof err);

    progress_clear();
    if (result != RESULT_DONE)
        return refuse(v, result, "%s: %s", path, err);
    if (w.kind == VERDICT_HOLDS && v->a->restamp)
        result = save_rerecorded(v, path);
    if (result != RESULT_DONE)
        return result;
    if (v->a->json)
        return print_json(v, path, &w);
    print_verdict(v, path, &w);
    if (v->a->verbose)
        print_details(v, &w);
    return w.kind == VERDICT_HOLDS ? RESULT_DONE : RESULT_DIFFERS;
}

/* ---- --rerecord: demos of another core version or build ---- */

/* The line about a rerecorded demo. */
struct summary {
    struct byte_buffer text;
    bool same; /* the rerecorded demo is known to be the same run */
};

/* Writes "1200", or "1200 and 300" if the second player has any points. */
static void points_text(const int64_t points[MAX_PLAYERS], char *out, size_t size)
{
    int n = snprintf(out, size, "%" PRId64, points[0]);

    if (points[1])
        snprintf(out + n, size - (size_t)n, " and %" PRId64, points[1]);
}

static bool points_of(const struct demo *d, int64_t points[MAX_PLAYERS])
{
    return demo_points(d, 0, &points[0]) && demo_points(d, 1, &points[1]);
}

/* Compares the final scores. Old demos don't contain the score. It is then known up to the last frame in which the
 * hashes of the part with the score match. */
static void add_points(const struct verify *v, const struct rerun *o, struct summary *t)
{
    uint32_t last = v->demo.frames - (v->demo.fault && v->demo.frames);
    int64_t was[MAX_PLAYERS], is[MAX_PLAYERS];
    char before[48], now[48];

    for (int p = 0; p < MAX_PLAYERS; p++)
        is[p] = board_points(v->replay.guard.board, p);
    points_text(is, now, sizeof now);
    bool known = points_of(&v->demo, was);
    if (known ? memcmp(was, is, sizeof was) == 0 : o->held && o->held_until >= last) {
        byte_buffer_print(&t->text, "; score %s unchanged", now);
        return;
    }
    t->same = false;
    points_text(known ? was : o->points, before, sizeof before);
    if (known)
        byte_buffer_print(&t->text, "; score %s -> %s", before, now);
    else if (o->held)
        byte_buffer_print(&t->text, "; recorded score unknown -> %s (known up to frame %u: %s)", now,
                          (unsigned)o->held_until, before);
    else
        byte_buffer_print(&t->text, "; recorded score unknown -> %s", now);
}

enum { MAX_LISTED_MARKERS = 4 }; /* --verbose prints all */

static void add_markers(const struct verify *v, const struct marker_changes *c, struct summary *t)
{
    char text[96];

    if (v->demo.format < 3) {
        byte_buffer_print(&t->text, "; recorded markers unknown");
        t->same = false;
        return;
    }
    t->same &= c->n == 0;
    byte_buffer_print(&t->text, c->n ? "; markers: " : "; markers unchanged");
    for (uint32_t i = 0; i < c->n && i < MAX_LISTED_MARKERS; i++) {
        markers_format_change(&c->list[i], text, sizeof text);
        byte_buffer_print(&t->text, "%s%s", i ? ", " : "", text);
    }
    if (c->n > MAX_LISTED_MARKERS)
        byte_buffer_print(&t->text, " and %u more", (unsigned)c->n - MAX_LISTED_MARKERS);
}

static void add_end(const struct verify *v, const struct rerun *o, struct summary *t)
{
    if (o->end.kind == VERDICT_NO_FAULT) {
        t->same = false;
        if (o->first.kind != VERDICT_NO_FAULT) /* otherwise the line starts with this */
            byte_buffer_print(&t->text, "; the recorded fault does not occur");
    }
    byte_buffer_print(&t->text, "; length %u unchanged", (unsigned)v->demo.frames);
}

/* Prints the line about a demo that was rerecorded. */
static enum result print_rerecorded(const struct verify *v, const char *path, const struct rerun *o)
{
    struct summary t = { .same = true };
    struct marker_changes c;
    char text[1400];

    if (!markers_compare(&c, &v->demo, &v->again.demo)) {
        free(c.list);
        return refuse(v, RESULT_HOST_FAILED, "%s: out of memory", path);
    }
    replay_text(&v->replay, &v->demo, &o->first, text, sizeof text);
    byte_buffer_print(&t.text, "rerecorded: %s", text);
    if (o->first.kind != VERDICT_HOLDS) {
        add_points(v, o, &t);
        add_markers(v, &c, &t);
        add_end(v, o, &t);
    }
    if (!t.text.failed)
        print_result(v, path, "%s", (const char *)t.text.bytes);
    byte_buffer_close(&t.text);
    for (uint32_t i = 0; v->a->verbose && v->demo.format >= 3 && i < c.n; i++) {
        markers_format_change(&c.list[i], text, sizeof text);
        report_print("  %s\n", text);
    }
    free(c.list);
    return t.same ? RESULT_DONE : RESULT_DIFFERS;
}

/* Returns why a replay that differs must not replace the demo, or NULL if it may. */
static const char *reason_to_keep(const struct verify *v, const struct rerun *o)
{
    if (!v->doubt[0])
        return "it was recorded with this build";
    if (v->demo.flags & DEMO_TOUCHED)
        return "the board was changed from outside, which a demo does not record";
    return o->end.kind == VERDICT_FAULT ? "the rest of the run would be lost" : NULL;
}

static enum result keep_demo(const struct verify *v, const char *path, const struct rerun *o, const char *why)
{
    char text[1400];

    replay_text(&v->replay, &v->demo, o->end.kind == VERDICT_FAULT ? &o->end : &o->first, text, sizeof text);
    if (o->end.frame != v->demo.frames)
        print_result(v, path, "%s; length %u -> %u; not rerecorded: %s", text, (unsigned)v->demo.frames,
                     (unsigned)o->end.frame, why);
    else
        print_result(v, path, "%s; not rerecorded: %s", text, why);
    return RESULT_REFUSED;
}

static enum result rerecord(struct verify *v, const char *path)
{
    struct rerun o;
    char err[512];

    v->replay.checksum_rate = (enum demo_checksum_rate)v->a->prints;
    enum result result = replay_whole(&v->replay, &v->game.cart, &v->demo, &v->again, &o, err, sizeof err);

    progress_clear();
    if (result != RESULT_DONE)
        return refuse(v, result, "%s: %s", path, err);
    const char *why = o.first.kind == VERDICT_HOLDS ? NULL : reason_to_keep(v, &o);
    if (why)
        return keep_demo(v, path, &o, why);
    result = save_rerecorded(v, path);
    return result == RESULT_DONE ? print_rerecorded(v, path, &o) : result;
}

static enum result verify_loaded(struct verify *v, const char *path)
{
    char err[512], doubt[128];

    if (!demo_check_cart(&v->demo, &v->game.cart, err, sizeof err))
        return refuse(v, RESULT_REFUSED, "%s: %s", path, err);
    if (!v->demo.complete)
        return refuse(v, RESULT_REFUSED, "%s: truncated: %u frames and no end mark", path, (unsigned)v->demo.frames);
    v->doubt[0] = 0;
    if (demo_replay_warning(&v->demo, &v->game.cart, doubt, sizeof doubt))
        snprintf(v->doubt, sizeof v->doubt, " (%s)", doubt);
    return v->a->rerecord ? rerecord(v, path) : verify_recording(v, path);
}

static enum result verify_demo(struct verify *v, const char *path)
{
    char err[1200];
    enum result result;

    v->path = path;
    if (demo_load(&v->demo, path, err, sizeof err))
        result = verify_loaded(v, path);
    else
        result = refuse(v, result_take_cause(), "%s", err);
    demo_free(&v->again.demo);
    demo_free(&v->demo);
    fflush(stdout);
    v->done++;
    return result;
}

/* ---- names ---- */

/* Reads the next name from standard input, up to a newline (and a carriage return before it), or with --null up to a
 * NUL. Skips empty names. Returns false at the end. A name too long for a path is truncated, and *whole is false. */
static bool next_name(char name[DEMO_PATH_SIZE], bool null, bool *whole)
{
    int end = null ? 0 : '\n', c = 0;
    size_t n = 0;

    *whole = true;
    while (n == 0 && c != EOF) {
        for (c = getchar(); c != EOF && c != end; c = getchar()) {
            if (n < DEMO_PATH_SIZE - 1)
                name[n++] = (char)c;
            else
                *whole = false;
        }
        if (!null && n && name[n - 1] == '\r')
            n--;
    }
    name[n] = 0;
    return n > 0;
}

static enum result verify_stdin(struct verify *v)
{
    char name[DEMO_PATH_SIZE];
    enum result worst = RESULT_DONE;
    bool whole, first = true;

    v->batch = true;
    while (next_name(name, v->a->null, &whole)) {
        size_t n = strlen(name);
        if (first)
            files_strip_bom(name, &n);
        first = false;
        plat_normalize_slashes(name);
        v->path = name;
        enum result result = whole ? verify_demo(v, name) : refuse(v, RESULT_REFUSED, "%s: name too long", name);
        worst = result > worst ? result : worst;
    }
    return worst;
}

static enum result verify_words(struct verify *v)
{
    enum result worst = RESULT_DONE;

    for (int i = 1; i < v->a->n_words; i++) {
        enum result result = verify_demo(v, v->a->words[i]);
        worst = result > worst ? result : worst;
    }
    return worst;
}

static enum result verify_all(struct verify *v, const struct args *a)
{
    char err[1024];
    bool listed = a->n_words == 2 && strcmp(a->words[1], "-") == 0;

    v->a = a;
    v->all = listed ? 0 : (uint64_t)a->n_words - 1;
    v->replay.ticked = show_progress;
    v->replay.context = v;
    if (a->null && !listed)
        return report_line(RESULT_REFUSED, "--null works only with names from standard input: verify ROM -");
    if (!game_open(&v->game, a->words[0], a, err, sizeof err))
        return report_error(err);
    progress_begin();
    enum result result = listed ? verify_stdin(v) : verify_words(v);
    progress_end();
    replay_close(&v->replay);
    game_close(&v->game);
    return report_stdout(result);
}

enum result verify_run(const struct args *a)
{
    if (a->bisect)
        return report_line(RESULT_REFUSED, "verify: --bisect is not available in curtain-player; use curtain");
    struct verify *v = calloc(1, sizeof *v); /* large for a stack */
    enum result result = v ? verify_all(v, a) : report_line(RESULT_HOST_FAILED, "out of memory");
    free(v);
    return result;
}
