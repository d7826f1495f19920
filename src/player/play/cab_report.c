/*
 * cab_report.c - what a fault or a crash leaves behind: a text that can be mailed, with the run up to there in it.
 *
 * A crash is told from a signal handler, which may allocate nothing and ask nobody. So what is known before, and the
 * memory that the demo's records are put together in, are made ready at each power-on; the handler copies the one and
 * reads the recording with the other.
 */
#include <inttypes.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>
#include "../../../platform/platform.h"
#include "cab_parts.h"
#include "../../demo/demo_dump.h"
#include "../../demo/demo_text.h"
#include "../../common/clean.h"

#define REPORTS "user:reports"
#define TOLD    REPORTS "/told" /* has the name of the last crash's report that a player was told of */

enum { MOST_REPORTS = 20, CRASH_NOTICE = 600 /* frames */ };

/* ---- old ones ---- */

/* The oldest of the reports there are, or the newest. */
struct found {
    bool newest;
    int n;
    int64_t time;
    char name[256];
};

static bool comes_before(const struct found *f, const struct plat_folder_entry *file)
{
    if (file->time != f->time)
        return file->time < f->time;
    return strcmp(file->name, f->name) < 0;
}

static void look_at(void *user, const struct plat_folder_entry *file)
{
    struct found *f = user;
    size_t n = strlen(file->name);

    if (file->is_folder || n < 4 || n >= sizeof f->name || strcmp(file->name + n - 4, ".txt") != 0)
        return;
    f->n++;
    if (f->n > 1 && comes_before(f, file) == f->newest)
        return;
    f->time = file->time;
    memcpy(f->name, file->name, n + 1);
}

/* Makes room for one more. */
static void remove_oldest(void)
{
    char path[sizeof REPORTS + 256];

    for (;;) {
        struct found f = { 0 };
        plat_list(REPORTS, look_at, &f);
        if (f.n < MOST_REPORTS)
            return;
        snprintf(path, sizeof path, "%s/%s", REPORTS, f.name);
        if (!plat_remove(path))
            return;
    }
}

/* ---- what is known before ---- */

static void add(struct report *r, const char *format, ...) __attribute__((format(printf, 2, 3)));

static void add(struct report *r, const char *format, ...)
{
    va_list args;

    va_start(args, format);
    int n = vsnprintf(r->known + r->n, sizeof r->known - r->n, format, args);
    va_end(args);
    if (n > 0)
        r->n = r->n + (size_t)n < sizeof r->known ? r->n + (size_t)n : sizeof r->known - 1;
}

static void add_settings(struct cab *cab, struct report *r)
{
    const struct config_setting *s;
    char value[64];

    add(r, "settings  ");
    for (int i = 0; (s = config_setting(i)) != NULL; i++) {
        config_text(&cab->config, s, value, sizeof value);
        add(r, "%s%s = %s", i == 0 ? "" : i % 5 == 0 ? ",\n          " : ", ", s->name, value);
    }
    add(r, "%s%s\n", cab->config.lang[0] ? ", lang = " : "", cab->config.lang);
}

static void date(char *out, size_t size, const char *format)
{
    time_t now = time(NULL);
    struct tm *local = localtime(&now);

    if (!local || strftime(out, size, format, local) == 0)
        snprintf(out, size, "undated");
}

/* when: what the date is of. */
static void add_versions(struct cab *cab, struct report *r, const char *when)
{
    char text[256];

    add(r, "curtain   %s, core version %d, Lua %s\n", cab->options.version, CORE_VERSION, board_lua_release());
    plat_describe_build(text, sizeof text);
    add(r, "port      %s\n", text);
    plat_describe_system(text, sizeof text);
    add(r, "system    %s\n", text);
    date(text, sizeof text, "%Y-%m-%d %H:%M:%S %z");
    add(r, "%-9s %s\n", when, text);
}

static void add_game(struct cab *cab, struct report *r)
{
    const struct cart *cart = cab_cart(cab);

    add(r, "game      %s, \"%s\", game hash %016" PRIx64 ", ROM hash %016" PRIx64 "\n", cart->manifest.id,
        cart->manifest.title, rom_game_hash(cart->rom), rom_hash(cart->rom));
    add(r, "from      %s\n", cab->options.path ? cab->options.path : "built into the program");
}

/* Without a number, which is the first that is free. */
static void make_stem(struct cab *cab, struct report *r)
{
    char day[32];

    date(day, sizeof day, "%Y-%m-%d");
    snprintf(r->stem, sizeof r->stem, "%s/%s-%s", REPORTS, cab_cart(cab)->manifest.id, day);
}

/* ---- the text ---- */

/* Where it goes. */
struct sink {
    void (*out)(void *to, const void *bytes, size_t n);
    void *to;
};

static void put(const struct sink *s, const char *text)
{
    s->out(s->to, text, strlen(text));
}

static void put_number(const struct sink *s, uint32_t v)
{
    char digits[10];
    int n = 0;

    do
        digits[9 - n++] = (char)('0' + v % 10);
    while ((v /= 10) > 0);
    s->out(s->to, digits + 10 - n, (size_t)n);
}

static void to_text(void *user, const uint8_t *bytes, size_t n)
{
    demo_text_add(user, bytes, n);
}

static void put_demo(struct cab *cab, const struct sink *out, const struct board_fault *fault)
{
    const struct session *s = &cab->session;
    const struct demo_writer *w = &s->now->writer;
    struct demo_text text;
    struct demo_dump_request how = {
        .memory = cab->report.memory, .size = cab->report.size, .write = to_text, .user = &text
    };

    how.ticking = s->ticking;
    how.frames = s->ticking ? s->at : fault ? w->demo.frames : board_frame(s->now->guard.board);
    how.fault = fault ? fault->kind : FAULT_NONE;
    demo_text_begin(&text, out->out, out->to);
    demo_dump(w, &how);
    demo_text_end(&text);
}

/* All of it; no allocation, no file. what: "a fault", "a crash"; which: more of that. */
static void write_report(struct cab *cab, const struct sink *out, const char *what, const char *which,
                         const struct board_fault *fault)
{
    const struct session *s = &cab->session;

    put(out, "Curtain report. It contains the run up to the failure. To replay the run:\n    curtain verify GAME "
             "THIS-FILE\nTo watch it:\n    curtain play GAME --demo THIS-FILE\n\nreason    ");
    put(out, what);
    put(out, which);
    if (s->now) {
        put(out, s->ticking ? ", in the tick after frame " : ", in frame ");
        put_number(out, s->ticking ? s->at : fault ? s->now->writer.demo.frames : board_frame(s->now->guard.board));
    }
    put(out, "\n");
    out->out(out->to, cab->report.known, cab->report.n);
    if (fault) {
        put(out, "\n");
        put(out, fault->message);
        put(out, "\n");
        put(out, fault->trace);
        put(out, "\n");
    }
    put(out, "\n");
    if (s->now && cab->report.memory)
        put_demo(cab, out, fault);
}

/* ---- crashes ---- */

/* What the port gives to write with. */
struct crash_out {
    void (*out)(const void *bytes, size_t n);
};

static void hand_on(void *to, const void *bytes, size_t n)
{
    ((const struct crash_out *)to)->out(bytes, n);
}

static void crashed(void *context, const char *what, void (*out)(const void *bytes, size_t n))
{
    struct crash_out to = { out };

    write_report(context, &(struct sink){ hand_on, &to }, "a crash: ", what, NULL);
}

static void make_ready(struct cab *cab, const char *when)
{
    struct report *r = &cab->report;
    size_t size = demo_dump_size(&cab->session.now->writer);
    uint8_t *memory = size > r->size ? realloc(r->memory, size) : r->memory;

    plat_set_crash_handler("", NULL, NULL); /* while this changes */
    r->memory = memory;
    r->size = memory ? (size > r->size ? size : r->size) : 0;
    r->n = 0;
    add_game(cab, r);
    add_versions(cab, r, when);
    add_settings(cab, r);
    clean_lines(r->known);
    r->n = strlen(r->known);
    make_stem(cab, r);
    remove_oldest();
    cab_report_arm(cab);
}

void cab_report_arm(struct cab *cab)
{
    if (cab->report.stem[0])
        plat_set_crash_handler(cab->report.stem, crashed, cab);
}

void cab_report_ready(struct cab *cab)
{
    make_ready(cab, "started");
}

/* Is it a report of a crash? */
static bool is_of_crash(const char *name)
{
    char path[sizeof REPORTS + 256], text[512];

    snprintf(path, sizeof path, "%s/%s", REPORTS, name);
    long n = plat_load(path, text, sizeof text - 1);
    text[n > 0 ? n : 0] = 0;
    return strstr(text, "\nreason    a crash") != NULL;
}

void cab_report_last_crash(struct cab *cab)
{
    struct found f = { .newest = true };
    char told[sizeof f.name] = "", path[sizeof REPORTS + sizeof f.name], shown[FILES_PATH_SIZE];

    plat_list(REPORTS, look_at, &f);
    plat_load(TOLD, told, sizeof told - 1);
    if (!f.name[0] || strcmp(told, f.name) == 0 || !is_of_crash(f.name))
        return;
    plat_save(TOLD, f.name, strlen(f.name));
    snprintf(path, sizeof path, "%s/%s", REPORTS, f.name);
    cab_notice(cab, CRASH_NOTICE, "Curtain crashed last time. Report: %s", files_display_name(path, shown));
    cab_say(cab, "curtain: %s", cab->notice);
}

void cab_report_close(struct cab *cab)
{
    plat_set_crash_handler("", NULL, NULL);
    free(cab->report.memory);
    byte_buffer_close(&cab->report.text);
    cab->report.memory = NULL;
    cab->report.stem[0] = 0;
}

/* ---- faults ---- */

static void collect(void *to, const void *bytes, size_t n)
{
    byte_buffer_put(to, bytes, n);
}

static bool save(struct cab *cab, struct report *r, const struct board_fault *fault)
{
    char name[sizeof r->stem + 16];
    size_t waits;
    int i = 1;

    byte_buffer_close(&r->text);
    write_report(cab, &(struct sink){ collect, &r->text }, "a fault", "", fault);
    remove_oldest();
    do
        snprintf(name, sizeof name, "%s-%d.txt", r->stem, i++);
    while (plat_file_size(name) >= 0 || unsaved_bytes(cab->unsaved.files, name, &waits));
    if (r->text.failed) {
        cab_say(cab, "curtain: cannot write a report: out of memory");
        return false;
    }
    files_display_name(name, r->where);
    return cab_save(cab, name, r->text.bytes, r->text.n);
}

static void write_fault_report(struct cab *cab, const struct board_fault *fault)
{
    struct report *r = &cab->report;
    const uint32_t frame = cab->session.now->writer.demo.frames;

    if (cab->session.demo || !r->memory)
        return;
    make_ready(cab, "written"); /* the settings may be others by now */
    if (!r->where[0] || r->frame != frame || strcmp(r->message, fault->message) != 0) {
        r->frame = frame;
        snprintf(r->message, sizeof r->message, "%s", fault->message);
        if (!save(cab, r, fault))
            return;
    }
    cab_say(cab, "curtain: report: %s", r->where);
}

void cab_report_fault(struct cab *cab)
{
    char line[FILES_PATH_SIZE + sizeof((struct board_fault *)0)->message];

    if (!cab->fault_reported) {
        struct board_fault fault = *cab_fault(cab);
        snprintf(line, sizeof line, "curtain: %s: %s", cab_game(cab), fault.message);
        clean_line(line);
        plat_log(line);
        cab_note(cab, LOG_WRONG, fault.message);
        clean_lines(fault.trace);
        if (fault.trace[0])
            plat_log(fault.trace);
        cab_note(cab, LOG_WRONG, fault.trace);
        cab->fault_top = 0;
        write_fault_report(cab, cab_fault(cab));
    }
    cab->fault_reported = true;
}
