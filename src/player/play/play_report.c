/*
 * play_report.c - reports of a game's faults for its author: a text, and next to it a demo of the run up to the fault.
 */
#include <inttypes.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>
#include "../../../platform/platform.h"
#include "play_state.h"
#include "../../common/clean.h"

#define REPORTS "user:reports"

enum { MAX_REPORTS = 20 };

/* ---- older reports ---- */

struct oldest {
    int reports;
    int64_t time;
    char stem[256]; /* "ID-DATE-N" */
};

static void find_oldest(void *user, const struct plat_folder_entry *file)
{
    struct oldest *o = user;
    const size_t n = strlen(file->name);

    if (file->is_folder || n < 4 || n >= sizeof o->stem || strcmp(file->name + n - 4, ".txt") != 0)
        return;
    if (o->reports++ > 0 &&
        (file->time > o->time || (file->time == o->time && strncmp(file->name, o->stem, n - 4) > 0)))
        return;
    o->time = file->time;
    snprintf(o->stem, sizeof o->stem, "%.*s", (int)n - 4, file->name);
}

/* Makes room for another report. */
static void remove_oldest(void)
{
    char path[sizeof REPORTS + 256 + 8];

    for (;;) {
        struct oldest o = { 0 };
        plat_list(REPORTS, find_oldest, &o);
        if (o.reports < MAX_REPORTS)
            return;
        snprintf(path, sizeof path, REPORTS "/%s.demo", o.stem);
        plat_remove(path);
        snprintf(path, sizeof path, REPORTS "/%s.txt", o.stem);
        if (!plat_remove(path))
            return;
    }
}

/* ---- the text ---- */

static void add_settings(const struct play *play, struct byte_buffer *text)
{
    const struct config_setting *s;
    char value[64];

    byte_buffer_print(text, "settings  ");
    for (int i = 0; (s = config_setting(i)) != NULL; i++) {
        config_text(&play->config, s, value, sizeof value);
        byte_buffer_print(text, "%s%s = %s", i == 0 ? "" : i % 5 == 0 ? ",\n          " : ", ", s->name, value);
    }
    byte_buffer_print(text, "%s%s\n", play->config.lang[0] ? ", lang = " : "", play->config.lang);
}

static void date(char *out, size_t size, const char *format)
{
    time_t now = time(NULL);
    struct tm *local = localtime(&now);

    if (!local || strftime(out, size, format, local) == 0)
        snprintf(out, size, "undated");
}

static void add_versions(const struct play *play, struct byte_buffer *text)
{
    char line[256];

    byte_buffer_print(text, "curtain   %s, core version %d, Lua %s\n", play->options.version, CORE_VERSION,
                      board_lua_release());
    plat_describe_build(line, sizeof line);
    byte_buffer_print(text, "port      %s\n", line);
    plat_describe_system(line, sizeof line);
    byte_buffer_print(text, "system    %s\n", line);
    date(line, sizeof line, "%Y-%m-%d %H:%M:%S %z");
    byte_buffer_print(text, "written   %s\n", line);
}

static void add_game(struct play *play, struct byte_buffer *text)
{
    const struct cart *cart = play_cart(play);

    byte_buffer_print(text, "game      %s, \"%s\", game hash %016" PRIx64 ", ROM hash %016" PRIx64 "\n",
                      cart->manifest.id, cart->manifest.title, rom_game_hash(cart->rom), rom_hash(cart->rom));
    byte_buffer_print(text, "from      %s\n", play->options.path ? play->options.path : "built into the program");
}

/* stem: the files' name in the folder of reports. */
static void write_text(struct play *play, struct byte_buffer *text, const char *stem, const struct board_fault *fault)
{
    byte_buffer_print(text,
                      "Curtain report. %s.demo contains the run up to the fault. To watch it:\n"
                      "    curtain play GAME --demo %s.demo\n\nfault     in frame %u\n",
                      stem, stem, (unsigned)play->session.now->writer.demo.frames);
    add_game(play, text);
    add_versions(play, text);
    add_settings(play, text);
    byte_buffer_print(text, "\n%s\n%s\n", fault->message, fault->trace);
    if (!text->failed)
        clean_lines((char *)text->bytes);
}

/* ---- the files ---- */

static bool is_taken(const struct play *play, const char *path)
{
    size_t size;

    return plat_file_size(path) >= 0 || unsaved_bytes(play->unsaved.files, path, &size);
}

/* Chooses the first free name. */
static void choose_stem(struct play *play, char *stem, size_t size)
{
    char day[32], path[FILES_PATH_SIZE];
    int n = 0;

    date(day, sizeof day, "%Y-%m-%d");
    do {
        snprintf(stem, size, "%s-%s-%d", play_cart(play)->manifest.id, day, ++n);
        snprintf(path, sizeof path, REPORTS "/%s.txt", stem);
    } while (is_taken(play, path));
}

static bool save(struct play *play, const struct board_fault *fault)
{
    char stem[128], path[FILES_PATH_SIZE];
    struct byte_buffer text = { 0 };
    size_t size;
    uint8_t *demo = demo_encode_now(&play->session.now->writer, play_board(play), &size);

    remove_oldest();
    choose_stem(play, stem, sizeof stem);
    write_text(play, &text, stem, fault);
    bool good = demo && !text.failed;
    if (good) {
        snprintf(path, sizeof path, REPORTS "/%s.demo", stem);
        good = play_save(play, path, demo, size);
        snprintf(path, sizeof path, REPORTS "/%s.txt", stem);
        good = play_save(play, path, text.bytes, text.n) && good;
        files_display_name(path, play->report.where);
    } else {
        play_log(play, "curtain: cannot write a report: out of memory, or the run is too long to be recorded");
    }
    byte_buffer_close(&text);
    free(demo);
    return good;
}

/* Writes a report, unless there is one of this fault. */
static void write_report(struct play *play, const struct board_fault *fault)
{
    struct report *r = &play->report;
    const uint32_t frame = play->session.now->writer.demo.frames;

    if (play->session.demo)
        return;
    if (!r->where[0] || r->frame != frame || strcmp(r->message, fault->message) != 0) {
        r->frame = frame;
        snprintf(r->message, sizeof r->message, "%s", fault->message);
        if (!save(play, fault))
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
    write_report(play, play_fault(play));
    play->report.fault_reported = true;
}
