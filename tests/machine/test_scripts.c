/*
 * test_scripts.c - the scripts of tests/scripts: what each case prints, or the fault that it ends with.
 *
 * A file begins with definitions that all its cases share. Its lines that start with these words are read here:
 *
 *     --board: NAME[=N] ...   settings of the board beyond those of rig_manifest, as in rom.lua's `board`, from here on
 *     --case: NAME            a script that runs as a task, one frame after power-on
 *     --each: NAME            several cases, each of which ends with its expectations
 *     --load: NAME            the same, but they run while scripts load
 *     --> TEXT                what is printed next; print's tabs are spaces here
 *     --! MESSAGE             the fault. One in this file must be at the line above, and is written without the place
 *
 * A script sees what @std sees as string.sys, and on a board with sound the sounds of rig_sounds. A case runs until its
 * task ends, and no longer than MAX_FRAMES. RAM is spoilt and put back after each frame, so what a script relies on
 * survives a snapshot.
 */
#define _POSIX_C_SOURCE 200809L /* dirent.h */
#include "rig.h"
#include "../../src/common/files.h"
#include <dirent.h>

#define FOLDER "tests/scripts"
enum { MAX_FRAMES = 400, MAX_FILES = 100, MAX_LINES = 4000, SCRIPT_ROOM = 1 << 17, TEXT_ROOM = 1 << 14 };

static const char ended[] = "-- ended\n"; /* printed after a case */

static const struct {
    const char *name;
    size_t offset;
} settings[] = {
#define SETTING(name, field)                                                                                           \
    {                                                                                                                  \
        name, offsetof(struct manifest, field)                                                                         \
    }
    SETTING("backgrounds", has_backgrounds),
    SETTING("bodies", has_bodies),
    SETTING("bullet_values", bullet_values),
    SETTING("bullets", bullets),
    SETTING("curve_points", curve_points),
    SETTING("enemies", enemies),
    SETTING("enemy_values", enemy_values),
    SETTING("field_h", field_h),
    SETTING("field_w", field_w),
    SETTING("freeze", has_freeze),
    SETTING("full_width", full_width),
    SETTING("hp", has_hp),
    SETTING("items", items),
    SETTING("lasers", lasers),
    SETTING("lines", lines),
    SETTING("margin", margin),
    SETTING("meet", bullets_can_meet),
    SETTING("motions", motions),
    SETTING("options", options),
    SETTING("orbit", has_orbit),
    SETTING("pierce", has_pierce),
    SETTING("shot_values", shot_values),
    SETTING("sound", has_sound),
    SETTING("sparks", sparks),
    SETTING("sprites", sprites),
    SETTING("transforms", has_transforms),
    SETTING("view_h", view_h),
    SETTING("view_w", view_w),
    SETTING("wide_text", has_wide_text),
};

struct case_file {
    const char *file;
    char *lines[MAX_LINES];
    int n, first_case;
    struct manifest manifest;
};

static bool starts(const char *line, const char *word)
{
    return strncmp(line, word, strlen(word)) == 0;
}

static bool is_expectation(const char *line)
{
    return starts(line, "-->") || starts(line, "--!");
}

static bool is_header(const char *line)
{
    return starts(line, "--board:") || starts(line, "--case:") || starts(line, "--each:") || starts(line, "--load:");
}

static void read_settings(struct case_file *s, char *line)
{
    for (char *word = strtok(line + strlen("--board:"), " "); word; word = strtok(NULL, " ")) {
        char *value = strchr(word, '=');
        size_t i = 0;
        if (value)
            *value++ = 0;
        while (i < sizeof settings / sizeof *settings && strcmp(settings[i].name, word))
            i++;
        if (i == sizeof settings / sizeof *settings)
            fail_msg("%s: no setting is called %s", s->file, word);
        *(int32_t *)((char *)&s->manifest + settings[i].offset) = value ? atoi(value) : 1;
    }
}

static uint8_t *read_cases(struct case_file *s, const char *file)
{
    char path[300], err[300];
    uint8_t *text;
    size_t size;

    s->file = file;
    s->n = 0;
    s->first_case = -1;
    s->manifest = rig_manifest();
    snprintf(path, sizeof path, FOLDER "/%s", file);
    if (!files_read_text(path, file, 1 << 20, &text, &size, err, sizeof err))
        fail_msg("%s", err);
    for (char *line = (char *)text, *end; line < (char *)text + size; line = end + 1) {
        end = memchr(line, '\n', size - (size_t)(line - (char *)text));
        assert_non_null(end);
        *end = 0;
        assert_true(s->n < MAX_LINES);
        if (s->first_case < 0 && is_header(line) && !starts(line, "--board:"))
            s->first_case = s->n;
        s->lines[s->n++] = line;
    }
    if (s->first_case < 0)
        fail_msg("%s: has no case", file);
    return text;
}

static void append(char *text, size_t room, const char *more)
{
    size_t n = strlen(text);

    if (n + strlen(more) >= room)
        fail_msg("too long");
    strcpy(text + n, more);
}

/* The definitions and the lines from..to, each at its place in the file, so that faults name the file's lines. */
static const char *compose(const struct case_file *s, int from, int to, bool loads)
{
    static char script[SCRIPT_ROOM];

    script[0] = 0;
    for (int i = 0; i < to; i++) {
        if (i == from && !loads)
            append(script, sizeof script, "task.go(function() wait(1) ");
        if (i < s->first_case || i >= from)
            append(script, sizeof script, s->lines[i]);
        append(script, sizeof script, "\n");
    }
    append(script, sizeof script, loads ? "print '-- ended'" : "print '-- ended' end)");
    return script;
}

/* Runs a script, and returns what it prints and its fault in the form of the expectations. */
static const char *outcome(const struct case_file *s, const char *script, int last)
{
    static char said[TEXT_ROOM], shown[TEXT_ROOM];
    static const uint16_t none[MAX_PLAYERS];
    struct rig_game game;
    struct rig r;

    rig_with_sys(&game, &s->manifest, script);
    if (s->manifest.has_sound)
        rig_sounds(&game);
    rig_power_any(&r, &game, NULL);
    said[0] = shown[0] = 0;
    for (int frame = 0;; frame++) {
        const struct board_out *out = board_last_output(r.b);
        snprintf(said + strlen(said), sizeof said - strlen(said), "%.*s", (int)out->log_size, out->log);
        if (rig_fault(&r) || strstr(said, ended) || frame == MAX_FRAMES)
            break;
        rig_spoil(&r);
        board_tick(r.b, none);
    }
    for (char *line = said, *end; (end = strchr(line, '\n')) && !starts(line, ended); line = end + 1) {
        *end = 0;
        for (char *tab = line; (tab = strchr(tab, '\t'));)
            *tab = ' ';
        append(shown, sizeof shown, "--> ");
        append(shown, sizeof shown, line);
        append(shown, sizeof shown, "\n");
    }
    if (rig_fault(&r)) {
        const char *message = rig_fault(&r)->message;
        char place[32];
        snprintf(place, sizeof place, "main.lua:%d: ", last);
        append(shown, sizeof shown, "--! ");
        append(shown, sizeof shown, message + (starts(message, place) ? strlen(place) : 0));
        append(shown, sizeof shown, "\n");
    }
    rig_close(&r);
    return shown;
}

/* Checks the lines from..to: scripts and what they are expected to say. */
static void check(const struct case_file *s, int from, int to, bool loads)
{
    char want[TEXT_ROOM] = "";
    int last = from; /* the line before the first expectation, counted from 1 */

    for (int i = from; i < to; i++)
        if (is_expectation(s->lines[i])) {
            append(want, sizeof want, s->lines[i]);
            append(want, sizeof want, "\n");
            last = starts(s->lines[i], "--!") && !is_expectation(s->lines[i - 1]) ? i : last;
        }
    const char *got = outcome(s, compose(s, from, to, loads), last);
    if (strcmp(got, want))
        fail_msg(FOLDER "/%s:%d: expected\n%sgot\n%s", s->file, from, want, got);
}

static void check_each(const struct case_file *s, int from, int to, bool loads)
{
    for (int begin = from, i = from; i < to; i++)
        if (is_expectation(s->lines[i]) && (i + 1 == to || !is_expectation(s->lines[i + 1]))) {
            check(s, begin, i + 1, loads);
            begin = i + 1;
        }
}

static void test_script(void **state)
{
    static struct case_file s;
    uint8_t *text = read_cases(&s, *state);

    for (int i = 0, end; i < s.n; i = end) {
        for (end = i + 1; end < s.n && !is_header(s.lines[end]);)
            end++;
        if (starts(s.lines[i], "--board:"))
            read_settings(&s, s.lines[i]);
        else if (starts(s.lines[i], "--case:"))
            check(&s, i + 1, end, false);
        else if (is_header(s.lines[i]))
            check_each(&s, i + 1, end, starts(s.lines[i], "--load:"));
    }
    free(text);
}

int main(int argc, char **argv)
{
    static struct CMUnitTest files[MAX_FILES];
    struct dirent *e;
    int n = 0;
    DIR *dir = opendir(FOLDER);

    while (dir && n < MAX_FILES && (e = readdir(dir)))
        if (strstr(e->d_name, ".lua") && (argc < 2 || strstr(e->d_name, argv[1]))) {
            files[n].name = files[n].initial_state = strdup(e->d_name);
            files[n++].test_func = test_script;
        }
    if (dir)
        closedir(dir);
    return n ? _cmocka_run_group_tests("scripts", files, (size_t)n, NULL, NULL) : 1;
}
