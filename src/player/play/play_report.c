/*
 * play_report.c - fault and crash reports: text that a player can send, with the run up to the failure in it.
 *
 * A crash report is written by a signal handler, which must not allocate memory. So the text that is already known, and
 * the memory for the demo's records, are prepared at each power-on; the handler copies the text and reads the recording
 * with the help of that memory.
 */
#include <inttypes.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>
#include "../../../platform/platform.h"
#include "play_state.h"
#include "../../demo/demo_dump.h"
#include "../../demo/demo_text.h"
#include "../../common/clean.h"

#define REPORTS    "user:reports"
#define LAST_SHOWN REPORTS "/told" /* contains the name of the last crash report that was shown */

enum { MAX_REPORTS = 20, CRASH_MESSAGE = 600 /* frames */ };

/* ---- older reports ---- */

/* The oldest report, or the newest. */
struct found {
    bool newest;
    int n;
    int64_t time;
    char name[256];
};

static bool is_older(const struct found *f, const struct plat_folder_entry *file)
{
    if (file->time != f->time)
        return file->time < f->time;
    return strcmp(file->name, f->name) < 0;
}

static void find_report(void *user, const struct plat_folder_entry *file)
{
    struct found *f = user;
    size_t n = strlen(file->name);

    if (file->is_folder || n < 4 || n >= sizeof f->name || strcmp(file->name + n - 4, ".txt") != 0)
        return;
    f->n++;
    if (f->n > 1 && is_older(f, file) == f->newest)
        return;
    f->time = file->time;
    memcpy(f->name, file->name, n + 1);
}

/* Makes room for another report. */
static void remove_oldest(void)
{
    char path[sizeof REPORTS + 256];

    for (;;) {
        struct found f = { 0 };
        plat_list(REPORTS, find_report, &f);
        if (f.n < MAX_REPORTS)
            return;
        snprintf(path, sizeof path, "%s/%s", REPORTS, f.name);
        if (!plat_remove(path))
            return;
    }
}

/* ---- text prepared in advance ---- */

__attribute__((format(printf, 2, 3))) static void add(struct report *r, const char *format, ...)
{
    va_list args;

    va_start(args, format);
    int n = vsnprintf(r->known + r->n, sizeof r->known - r->n, format, args);
    va_end(args);
    if (n > 0)
        r->n = r->n + (size_t)n < sizeof r->known ? r->n + (size_t)n : sizeof r->known - 1;
}

static void add_settings(struct play *play, struct report *r)
{
    const struct config_setting *s;
    char value[64];

    add(r, "settings  ");
    for (int i = 0; (s = config_setting(i)) != NULL; i++) {
        config_text(&play->config, s, value, sizeof value);
        add(r, "%s%s = %s", i == 0 ? "" : i % 5 == 0 ? ",\n          " : ", ", s->name, value);
    }
    add(r, "%s%s\n", play->config.lang[0] ? ", lang = " : "", play->config.lang);
}

static void date(char *out, size_t size, const char *format)
{
    time_t now = time(NULL);
    struct tm *local = localtime(&now);

    if (!local || strftime(out, size, format, local) == 0)
        snprintf(out, size, "undated");
}

/* when: the date's label. */
static void add_versions(struct play *play, struct report *r, const char *when)
{
    char text[256];

    add(r, "curtain   %s, core version %d, Lua %s\n", play->options.version, CORE_VERSION, board_lua_release());
    plat_describe_build(text, sizeof text);
    add(r, "port      %s\n", text);
    plat_describe_system(text, sizeof text);
    add(r, "system    %s\n", text);
    date(text, sizeof text, "%Y-%m-%d %H:%M:%S %z");
    add(r, "%-9s %s\n", when, text);
}

static void add_game(struct play *play, struct report *r)
{
    const struct cart *cart = play_cart(play);

    add(r, "game      %s, \"%s\", game hash %016" PRIx64 ", ROM hash %016" PRIx64 "\n", cart->manifest.id,
        cart->manifest.title, rom_game_hash(cart->rom), rom_hash(cart->rom));
    add(r, "from      %s\n", play->options.path ? play->options.path : "built into the program");
}

/* The file name, to which the first free number is added. */
static void make_stem(struct play *play, struct report *r)
{
    char day[32];

    date(day, sizeof day, "%Y-%m-%d");
    snprintf(r->stem, sizeof r->stem, "%s/%s-%s", REPORTS, play_cart(play)->manifest.id, day);
}

/* ---- the text ---- */

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

static void put_demo(struct play *play, const struct sink *out, const struct board_fault *fault)
{
    const struct session *s = &play->session;
    const struct demo_writer *w = &s->now->writer;
    struct demo_text text;
    struct demo_dump_request how = {
        .memory = play->report.memory, .size = play->report.size, .write = to_text, .user = &text
    };

    how.ticking = s->ticking;
    how.frames = s->ticking ? s->at : fault ? w->demo.frames : board_frame(s->now->guard.board);
    how.fault = fault ? fault->kind : FAULT_NONE;
    demo_text_begin(&text, out->out, out->to);
    demo_dump(w, &how);
    demo_text_end(&text);
}

/* The whole report, without allocating memory. what: "a fault" or "a crash: "; which: the kind of crash. */
static void write_report(struct play *play, const struct sink *out, const char *what, const char *which,
                         const struct board_fault *fault)
{
    const struct session *s = &play->session;

    put(out, "Curtain report. It contains the run up to the failure. To replay the run:\n    curtain verify GAME "
             "THIS-FILE\nTo watch it:\n    curtain play GAME --demo THIS-FILE\n\nreason    ");
    put(out, what);
    put(out, which);
    if (s->now) {
        put(out, s->ticking ? ", in the tick after frame " : ", in frame ");
        put_number(out, s->ticking ? s->at : fault ? s->now->writer.demo.frames : board_frame(s->now->guard.board));
    }
    put(out, "\n");
    out->out(out->to, play->report.known, play->report.n);
    if (fault) {
        put(out, "\n");
        put(out, fault->message);
        put(out, "\n");
        put(out, fault->trace);
        put(out, "\n");
    }
    put(out, "\n");
    if (s->now && play->report.memory)
        put_demo(play, out, fault);
}

/* ---- crashes ---- */

/* The port's function, which has no context. */
struct crash_out {
    void (*out)(const void *bytes, size_t n);
};

static void to_port(void *to, const void *bytes, size_t n)
{
    ((const struct crash_out *)to)->out(bytes, n);
}

static void crashed(void *context, const char *what, void (*out)(const void *bytes, size_t n))
{
    struct crash_out to = { out };

    write_report(context, &(struct sink){ to_port, &to }, "a crash: ", what, NULL);
}

static void prepare(struct play *play, const char *when)
{
    struct report *r = &play->report;
    size_t size = demo_dump_size(&play->session.now->writer);
    uint8_t *memory = size > r->size ? realloc(r->memory, size) : r->memory;

    plat_set_crash_handler("", NULL, NULL); /* while the report changes */
    r->memory = memory;
    r->size = memory ? (size > r->size ? size : r->size) : 0;
    r->n = 0;
    add_game(play, r);
    add_versions(play, r, when);
    add_settings(play, r);
    clean_lines(r->known);
    r->n = strlen(r->known);
    make_stem(play, r);
    remove_oldest();
    play_report_arm(play);
}

void play_report_arm(struct play *play)
{
    if (play->report.stem[0])
        plat_set_crash_handler(play->report.stem, crashed, play);
}

void play_report_prepare(struct play *play)
{
    prepare(play, "started");
}

static bool is_crash_report(const char *name)
{
    char path[sizeof REPORTS + 256], text[512];

    snprintf(path, sizeof path, "%s/%s", REPORTS, name);
    long n = plat_load(path, text, sizeof text - 1);
    text[n > 0 ? n : 0] = 0;
    return strstr(text, "\nreason    a crash") != NULL;
}

void play_report_last_crash(struct play *play)
{
    struct found f = { .newest = true };
    char last[sizeof f.name] = "", path[sizeof REPORTS + sizeof f.name], shown[FILES_PATH_SIZE];

    plat_list(REPORTS, find_report, &f);
    plat_load(LAST_SHOWN, last, sizeof last - 1);
    if (!f.name[0] || strcmp(last, f.name) == 0 || !is_crash_report(f.name))
        return;
    plat_save(LAST_SHOWN, f.name, strlen(f.name));
    snprintf(path, sizeof path, "%s/%s", REPORTS, f.name);
    play_show_message(play, CRASH_MESSAGE, "Curtain crashed last time. Report: %s", files_display_name(path, shown));
    play_log(play, "curtain: %s", play->message.text);
}

void play_report_close(struct report *r)
{
    plat_set_crash_handler("", NULL, NULL);
    free(r->memory);
    byte_buffer_close(&r->text);
    r->memory = NULL;
    r->stem[0] = 0;
}

/* ---- faults ---- */

static void to_buffer(void *to, const void *bytes, size_t n)
{
    byte_buffer_put(to, bytes, n);
}

static bool save(struct play *play, struct report *r, const struct board_fault *fault)
{
    char name[sizeof r->stem + 16];
    size_t waits;
    int i = 1;

    r->text.n = 0;
    write_report(play, &(struct sink){ to_buffer, &r->text }, "a fault", "", fault);
    remove_oldest();
    do
        snprintf(name, sizeof name, "%s-%d.txt", r->stem, i++);
    while (plat_file_size(name) >= 0 || unsaved_bytes(play->unsaved.files, name, &waits));
    if (r->text.failed) {
        byte_buffer_close(&r->text);
        play_log(play, "curtain: cannot write a report: out of memory");
        return false;
    }
    files_display_name(name, r->where);
    return play_save(play, name, r->text.bytes, r->text.n);
}

static void write_fault_report(struct play *play, const struct board_fault *fault)
{
    struct report *r = &play->report;
    const uint32_t frame = play->session.now->writer.demo.frames;

    if (play->session.demo || !r->memory)
        return;
    prepare(play, "written"); /* the settings may have changed */
    if (!r->where[0] || r->frame != frame || strcmp(r->message, fault->message) != 0) {
        r->frame = frame;
        snprintf(r->message, sizeof r->message, "%s", fault->message);
        if (!save(play, r, fault))
            return;
    }
    play_log(play, "curtain: report: %s", r->where);
}

void play_report_fault(struct play *play)
{
    char line[FILES_PATH_SIZE + sizeof((struct board_fault *)0)->message];

    if (!play_fault(play) || play->report.fault_reported)
        return;
    struct board_fault fault = *play_fault(play);
    snprintf(line, sizeof line, "curtain: %s: %s", play_game_name(play), fault.message);
    clean_line(line);
    plat_log(line);
    play_log_add(play, LOG_FAULT, fault.message);
    clean_lines(fault.trace);
    if (fault.trace[0])
        plat_log(fault.trace);
    play_log_add(play, LOG_FAULT, fault.trace);
    play->report.page_top = 0;
    write_fault_report(play, play_fault(play));
    play->report.fault_reported = true;
}
