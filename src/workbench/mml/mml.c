/*
 * mml.c - see mml.h: the lines of a file, macros, echoes. The lines of a track are joined and their macros expanded;
 * each character keeps its position in the file, for messages.
 */
#include "mml_parts.h"

#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "../../base/edit.h"
#include "../../base/err.h"
#include "../../common/array.h"
#include "../../common/result.h"
#include "../../sound/pitch.h"

/* Writes a position in the file as "FILE:LINE:COLUMN: ". */
static void write_position(const struct mml *m, uint32_t at, char *out, size_t size)
{
    int line = 1, column = 1;

    for (uint32_t i = 0; i < at && i < m->n; i++, column++)
        if (m->text[i] == '\n') {
            line++;
            column = 0;
        }
    snprintf(out, size, "%s:%d:%d: ", m->file, line, column);
}

void mml_fail(struct mml *m, uint32_t at, const char *format, ...)
{
    va_list args;

    write_position(m, at, m->err, m->err_size);
    const size_t n = strlen(m->err);
    va_start(args, format);
    vsnprintf(m->err + n, m->err_size - n, format, args);
    va_end(args);
    longjmp(m->on_error, 1);
}

void mml_add(struct mml *m, struct mml_track *t, uint32_t tick, enum tune_event event, int value, int more)
{
    if (!array_append(&t->events, t->n, sizeof *t->events)) {
        result_set_host_failed();
        mml_fail(m, m->position, "out of memory");
    }
    if (++m->events > MML_MAX_EVENTS)
        mml_fail(m, m->position, "more than %d notes and settings (with loops expanded)", (int)MML_MAX_EVENTS);
    t->events[t->n] = (struct mml_event){ tick, t->n, m->position, (uint8_t)event, (uint16_t)value, (uint16_t)more };
    t->n++;
}

/* ---- the lines of the file ---- */

#define NAME_FORM " of 1 to 31 letters, digits and _"
_Static_assert(MML_NAME == 32, "NAME_FORM says how long a name may be");

/* Returns the end of the line at `at`, before a comment. */
static uint32_t line_end(const struct mml *m, uint32_t at)
{
    bool quoted = false;

    for (; at < m->n && m->text[at] != '\n'; at++) {
        if (m->text[at] == '"')
            quoted = !quoted;
        if (m->text[at] == ';' && !quoted)
            break;
    }
    return at;
}

static uint32_t next_line(const struct mml *m, uint32_t at)
{
    while (at < m->n && m->text[at] != '\n')
        at++;
    return at + 1;
}

/* Returns whether the line belongs to tracks: letters A to P, then a space. A text of a single line without the letters
 * is track A. */
static bool parse_track_line(const struct mml *m, uint32_t at, uint32_t end, uint32_t *tracks, uint32_t *body)
{
    uint32_t p = at;

    *tracks = 0;
    while (p < end && m->text[p] >= 'A' && m->text[p] <= 'P')
        *tracks |= 1u << (m->text[p++] - 'A');
    *body = p;
    if (p > at && (p == end || mml_is_blank(m->text[p])))
        return true;
    *tracks = 1;
    *body = at;
    return memchr(m->text, '\n', m->n) == NULL && at < end && m->text[at] != '#' && m->text[at] != '!';
}

static void read_macro(struct mml *m, uint32_t at, uint32_t end)
{
    char name[MML_NAME];
    uint32_t p = at + 1;

    mml_parse_word(m, &p, end, name, "a macro name" NAME_FORM);
    for (int i = 0; i < m->n_macros; i++)
        if (strcmp(m->macros[i].name, name) == 0)
            mml_fail(m, at, "duplicate macro \"%s\"", name);
    if (m->n_macros == MML_MAX_NAMES)
        mml_fail(m, at, "more than %d macros", (int)MML_MAX_NAMES);
    memcpy(m->macros[m->n_macros].name, name, MML_NAME);
    m->macros[m->n_macros].from = p;
    m->macros[m->n_macros++].to = end;
}

static bool is_word(const struct mml *m, uint32_t at, uint32_t end, const char *word)
{
    const size_t n = strlen(word);

    return end - at >= n && memcmp(m->text + at, word, n) == 0 && (end - at == n || mml_is_blank(m->text[at + n]));
}

static void read_title(struct mml *m, uint32_t at, uint32_t end)
{
    while (end > at && mml_is_blank(m->text[end - 1]))
        end--;
    if (end - at >= TUNE_TITLE_SIZE)
        mml_fail(m, at, "expected a title of at most %d bytes", TUNE_TITLE_SIZE - 1);
    for (uint32_t i = at; i < end; i++)
        if ((unsigned char)m->text[i] < 32 || m->text[i] == 127)
            mml_fail(m, i, "control character in the title");
    memset(m->title, 0, sizeof m->title);
    memcpy(m->title, m->text + at, end - at);
}

/* Reads #swing 16,60: the first of every two sixteenths gets 60 percent of their time. */
static void read_swing(struct mml *m, uint32_t at, uint32_t p, uint32_t end)
{
    p = mml_skip_blanks(m, p, end);
    const int64_t n = mml_parse_decimal(m, &p, end, "a length", 2000, 64000) / 1000;
    if (p == end || m->text[p] != ',' || 4 * TUNE_QUARTER % n != 0)
        mml_fail(m, p < end ? p : at,
                 "expected #swing 16,60: the first of every two 16th notes gets 60 percent of their time");
    p++;
    m->swing = (uint32_t)(4 * TUNE_QUARTER / n);
    m->swing_percent = (uint32_t)(mml_parse_decimal(m, &p, end, "percent", 50000, 80000) / 1000);
    m->swing_from = at;
}

/* #echo and #mark are read after the tracks. */
static void read_directive(struct mml *m, uint32_t at, uint32_t end)
{
    uint32_t p = at + 1;

    if (is_word(m, p, end, "title")) {
        read_title(m, mml_skip_blanks(m, p + 5, end), end);
    } else if (is_word(m, p, end, "bar")) {
        p = mml_skip_blanks(m, p + 3, end);
        m->bar = (int)(mml_parse_decimal(m, &p, end, "beats per bar", 1000, 16000) / 1000);
    } else if (is_word(m, p, end, "swing")) {
        read_swing(m, at, p + 5, end);
    } else if (!is_word(m, p, end, "echo") && !is_word(m, p, end, "mark")) {
        mml_fail(m, at, "expected #title, #bar, #echo, #swing or #mark");
    }
}

/* Returns whether the line defines a curve: @E, @M or @P, then a space. */
static bool is_curve_line(const struct mml *m, uint32_t at, uint32_t end)
{
    return end - at > 2 && memchr("EMP", m->text[at + 1], 3) && mml_is_blank(m->text[at + 2]);
}

/* Reads all lines except those of tracks. */
static void read_lines(struct mml *m)
{
    uint32_t tracks, body;

    for (uint32_t at = 0; at < m->n; at = next_line(m, at)) {
        const uint32_t end = line_end(m, at), first = mml_skip_blanks(m, at, end);
        if (first == end || parse_track_line(m, first, end, &tracks, &body))
            continue;
        if (m->text[first] == '@' && is_curve_line(m, first, end))
            mml_read_curve_line(m, first, end);
        else if (m->text[first] == '@')
            mml_read_inst(m, first, end);
        else if (m->text[first] == '!')
            read_macro(m, first, end);
        else if (m->text[first] == '#')
            read_directive(m, first, end);
        else
            mml_fail(m, first, "expected a track (A to P and a space), @instrument, !macro, # or ;");
    }
}

/* ---- expanding a track ---- */

static void append_char(struct mml *m, char c, uint32_t from)
{
    if (m->line.n == MML_MAX_EXPANDED)
        mml_fail(m, from, "track longer than %d characters (with macros expanded)", (int)MML_MAX_EXPANDED);
    m->line.text[m->line.n] = c;
    m->line.from[m->line.n++] = from;
}

static void expand(struct mml *m, uint32_t at, uint32_t end, int depth);

static uint32_t expand_macro(struct mml *m, uint32_t at, uint32_t end, int depth)
{
    char name[MML_NAME];
    struct edit_nearest near = { .word = name };
    uint32_t p = at + 1;

    mml_parse_word(m, &p, end, name, "a macro name" NAME_FORM);
    if (depth == MML_MAX_DEPTH)
        mml_fail(m, at, "macros nested deeper than %d (does \"%s\" contain itself?)", (int)MML_MAX_DEPTH, name);
    for (int i = 0; i < m->n_macros; i++) {
        if (strcmp(m->macros[i].name, name) == 0) {
            expand(m, m->macros[i].from, m->macros[i].to, depth + 1);
            return p;
        }
        edit_consider(&near, m->macros[i].name);
    }
    if (near.found)
        mml_fail(m, at, "unknown macro \"%s\" (did you mean \"%s\"?)", name, near.found);
    mml_fail(m, at, "unknown macro \"%s\"", name);
}

static void expand(struct mml *m, uint32_t at, uint32_t end, int depth)
{
    bool quoted = false;

    while (at < end) {
        const char c = m->text[at];
        if (c == '!' && !quoted) {
            at = expand_macro(m, at, end, depth);
            continue;
        }
        quoted = quoted != (c == '"');
        append_char(m, c, at++);
    }
    append_char(m, ' ', end);
}

static void read_tracks(struct mml *m)
{
    uint32_t tracks, body;

    for (int i = 0; i < TUNE_MAX_TRACKS; i++) {
        m->line.n = 0;
        for (uint32_t at = 0; at < m->n; at = next_line(m, at)) {
            const uint32_t end = line_end(m, at), first = mml_skip_blanks(m, at, end);
            if (!parse_track_line(m, first, end, &tracks, &body) || !(tracks >> i & 1))
                continue;
            m->tracks[i].used = true;
            expand(m, body, end, 0);
        }
        if (m->tracks[i].used)
            mml_read_track(m, &m->tracks[i]);
    }
}

/* ---- echoes ---- */

/* Finds the next line from *at that starts with # and the word, and sets its start and end. False: none. */
static bool find_directive(const struct mml *m, const char *word, uint32_t *at, uint32_t *end)
{
    for (; *at < m->n; *at = next_line(m, *at)) {
        *end = line_end(m, *at);
        const uint32_t p = mml_skip_blanks(m, *at, *end);
        if (p < *end && m->text[p] == '#' && is_word(m, p + 1, *end, word)) {
            *at = p;
            return true;
        }
    }
    return false;
}

/* Copies a track, `later` ticks later and `louder` steps louder; pan: -1 for that of the track. */
static void copy_track(struct mml *m, struct mml_track *to, const struct mml_track *from, uint32_t later, int louder,
                       int pan)
{
    to->used = true;
    if (pan >= 0)
        mml_add(m, to, 0, TUNE_PANNING, pan, 0);
    for (uint32_t i = 0; i < from->n; i++) {
        const struct mml_event *e = &from->events[i];
        int value = e->value;
        if (e->event == TUNE_PANNING && pan >= 0)
            continue;
        if (e->event == TUNE_VOLUME) {
            value += louder * 8;
            value = value < 0 ? 0 : value > TUNE_MAX_VOLUME ? TUNE_MAX_VOLUME : value;
        }
        mml_add(m, to, e->tick + later, (enum tune_event)e->event, value, e->value2);
    }
    to->loop = from->loop < 0 ? -1 : from->loop + later;
    to->loop_from = from->loop_from;
    to->end = from->end + later;
}

static int parse_track_letter(struct mml *m, uint32_t *at, uint32_t end)
{
    if (*at >= end || m->text[*at] < 'A' || m->text[*at] > 'P')
        mml_fail(m, *at, "expected a track, A to P, as in #echo B=A,8,-3");
    return m->text[(*at)++] - 'A';
}

static void expect_char(struct mml *m, uint32_t *at, uint32_t end, char c)
{
    if (*at >= end || m->text[*at] != c)
        mml_fail(m, *at, "expected #echo B=A,8,-3: track B is track A an eighth note later and 3 steps softer");
    ++*at;
}

static void read_echoes(struct mml *m)
{
    for (uint32_t at = 0, end = 0; find_directive(m, "echo", &at, &end); at = next_line(m, at)) {
        uint32_t p = mml_skip_blanks(m, at + 5, end);
        const int to = parse_track_letter(m, &p, end);
        expect_char(m, &p, end, '=');
        const int from = parse_track_letter(m, &p, end);
        expect_char(m, &p, end, ',');
        const int64_t length = mml_parse_decimal(m, &p, end, "a note length", 1000, 64000) / 1000;
        expect_char(m, &p, end, ',');
        const int64_t louder = mml_parse_decimal(m, &p, end, "a volume change (of 16),", -15000, 15000) / 1000;
        int64_t pan = -1;
        if (p < end && m->text[p] == ',') {
            p++;
            pan = mml_parse_decimal(m, &p, end, "a pan", 0, 2000 * TUNE_PAN_CENTRE) / 1000;
        }
        if (m->tracks[to].used || !m->tracks[from].used || 4 * TUNE_QUARTER % length != 0)
            mml_fail(m, at,
                     m->tracks[to].used ? "track %c already has notes"
                                        : "track %c: no notes to echo, or a length that is not a whole number of ticks",
                     'A' + to);
        copy_track(m, &m->tracks[to], &m->tracks[from], (uint32_t)(4 * TUNE_QUARTER / length), (int)louder, (int)pan);
    }
}

/* ---- markers, swing, warnings ---- */

static uint32_t last_tick(const struct mml *m)
{
    uint32_t end = 0;

    for (int i = 0; i < TUNE_MAX_TRACKS; i++)
        if (m->tracks[i].used && m->tracks[i].end > end)
            end = m->tracks[i].end;
    return end;
}

/* Reads #mark drop 17,3: a marker at the third beat of bar 17. */
static void read_markers(struct mml *m)
{
    for (uint32_t at = 0, end = 0; find_directive(m, "mark", &at, &end); at = next_line(m, at)) {
        uint32_t p = mml_skip_blanks(m, at + 5, end);
        char name[TUNE_NAME_SIZE];
        int64_t beat = 1;
        mml_parse_word(m, &p, end, name, "a marker name, as in #mark drop 17" NAME_FORM);
        p = mml_skip_blanks(m, p, end);
        const int64_t bar = mml_parse_decimal(m, &p, end, "a bar", 1000, 4096000) / 1000;
        if (p < end && m->text[p] == ',') {
            p++;
            beat = mml_parse_decimal(m, &p, end, "a beat of the bar", 1000, m->bar * 1000) / 1000;
        }
        const uint32_t tick = (uint32_t)((bar - 1) * m->bar + beat - 1) * TUNE_QUARTER;
        const int mark = mml_marker(m, name);
        if (mark < 0)
            mml_fail(m, at, "more than %d markers", (int)TUNE_MAX_MARKERS);
        if (tick >= last_tick(m))
            mml_fail(m, at, "bar %d is after the end", (int)bar);
        m->position = at;
        mml_add(m, &m->conductor, tick, TUNE_MARKER, mark, 0);
    }
}

/* Applies swing to a tick. */
static uint32_t apply_swing(const struct mml *m, uint32_t tick)
{
    const uint32_t half = m->swing, pair = tick / (2 * half) * (2 * half), k = tick - pair;
    const uint32_t first = 2 * half * m->swing_percent / 100;

    return pair + (k < half ? k * first / half : first + (k - half) * (2 * half - first) / half);
}

static void swing_track(const struct mml *m, struct mml_track *t)
{
    for (uint32_t i = 0; i < t->n; i++) {
        struct mml_event *e = &t->events[i];
        if (e->event == TUNE_GLIDE)
            e->value2 = (uint16_t)(apply_swing(m, e->tick + e->value2) - apply_swing(m, e->tick));
        e->tick = apply_swing(m, e->tick);
    }
    t->end = apply_swing(m, t->end);
    if (t->loop >= 0)
        t->loop = apply_swing(m, (uint32_t)t->loop);
}

void mml_swing(struct mml *m)
{
    if (m->swing == 0)
        return;
    for (int i = 0; i < TUNE_MAX_TRACKS; i++) {
        struct mml_track *t = &m->tracks[i];
        if (t->loop >= 0 && (t->end - t->loop) % (2 * m->swing) != 0)
            mml_fail(m, t->loop_from,
                     "with #swing, the part that L repeats must be a multiple of %d ticks, got %u ticks",
                     (int)(2 * m->swing), (unsigned)(t->end - t->loop));
        swing_track(m, t);
    }
    swing_track(m, &m->conductor);
}

static void warn_cut_off(const struct mml *m, const struct mml_settings *settings, uint32_t from)
{
    char sentence[256];

    write_position(m, from, sentence, sizeof sentence);
    const size_t n = strlen(sentence);
    snprintf(sentence + n, sizeof sentence - n,
             "this note starts within one frame (1/60 s) of the previous note in its track and cuts that note off");
    settings->warn(settings->context, sentence);
}

/* Of three notes within a frame, the third cuts the second off. Each position is reported once. */
void mml_warn_notes(struct mml *m, const struct mml_settings *settings)
{
    for (int i = 0; settings->warn && i < TUNE_MAX_TRACKS; i++) {
        struct mml_track *t = &m->tracks[i];
        uint32_t last = 0, notes = 0, reported = UINT32_MAX;
        mml_sort(t);
        for (uint32_t k = 0; k < t->n; k++) {
            const struct mml_event *e = &t->events[k];
            if (e->event != TUNE_NOTE)
                continue;
            if (notes++ >= 2 && e->from != reported &&
                (uint64_t)(e->tick - last) * TUNE_TICK <
                    (uint64_t)SND_FRAME * (uint64_t)mml_tempo_at(&m->conductor, last)) {
                reported = e->from;
                warn_cut_off(m, settings, reported);
            }
            last = e->tick;
        }
    }
}

/* Checks that no two markers are in the same frame: scripts would only see the second. */
static void check_markers(struct mml *m)
{
    struct mml_track *c = &m->conductor;
    const struct mml_event *last = NULL;

    mml_sort(c);
    for (uint32_t i = 0; i < c->n; i++) {
        const struct mml_event *e = &c->events[i];
        if (e->event != TUNE_MARKER)
            continue;
        if (last && last->value != e->value &&
            (uint64_t)(e->tick - last->tick) * TUNE_TICK < (uint64_t)SND_FRAME * (uint64_t)mml_tempo_at(c, last->tick))
            mml_fail(m, e->from, "marker \"%s\" is within one frame (1/60 s) of \"%s\", so scripts would never see it",
                     m->markers[e->value], m->markers[last->value]);
        last = e;
    }
}

/* ---- all ---- */

static bool has_tracks(const struct mml *m)
{
    for (int i = 0; i < TUNE_MAX_TRACKS; i++)
        if (m->tracks[i].used)
            return true;
    return false;
}

static void compile(struct mml *m, const struct mml_settings *settings, uint8_t **out, size_t *size)
{
    for (uint32_t i = 0; i < m->n; i++)
        if (m->text[i] == '\0')
            mml_fail(m, i, "expected text, got a zero byte");
    read_lines(m);
    read_tracks(m);
    read_echoes(m);
    read_markers(m);
    mml_swing(m);
    if (!has_tracks(m))
        mml_fail(m, 0, "no track (a line that starts with A and a space)");
    check_markers(m);
    mml_warn_notes(m, settings);
    mml_make(m, settings, out, size);
}

static struct mml *mml_open(const char *file, char *err, size_t err_size)
{
    struct mml *m = calloc(1, sizeof *m);

    if (m == NULL)
        return NULL;
    m->file = file;
    m->err = err;
    m->err_size = err_size;
    m->bar = 4;
    m->conductor.loop = -1;
    for (int i = 0; i < TUNE_MAX_TRACKS; i++)
        m->tracks[i].loop = -1;
    m->line.text = malloc(MML_MAX_EXPANDED);
    m->line.from = malloc(MML_MAX_EXPANDED * sizeof *m->line.from);
    return m;
}

static void end(struct mml *m)
{
    for (int i = 0; i < TUNE_MAX_TRACKS; i++)
        free(m->tracks[i].events);
    for (uint32_t i = 0; i < m->n_tables; i++)
        free(m->tables[i].bytes);
    free(m->conductor.events);
    free(m->line.text);
    free(m->line.from);
    free(m);
}

bool mml_compile(const char *text, size_t n, const char *file, const struct mml_settings *settings, uint8_t **out,
                 size_t *size, char *err, size_t err_size)
{
    struct mml *m = mml_open(file, err, err_size);

    *out = NULL;
    if (m == NULL || m->line.text == NULL || m->line.from == NULL || n > MML_MAX_FILE) {
        if (m)
            end(m);
        return n > MML_MAX_FILE ? err_set(err, err_size, "%s: longer than %d bytes", file, MML_MAX_FILE)
                                : result_set_host_error(err, err_size, "out of memory");
    }
    m->text = text;
    m->n = n;
    if (setjmp(m->on_error) == 0)
        compile(m, settings, out, size);
    end(m);
    return *out != NULL;
}
