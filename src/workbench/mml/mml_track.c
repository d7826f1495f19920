/*
 * mml_track.c - the commands of a track, read from its expanded text. Loops are unrolled here: the board reads events
 * in order, and only supports the final loop of a track.
 */
#include "mml_parts.h"

#include <string.h>
#include "../../base/edit.h"
#include "../../sound/pitch.h"

enum { WHOLE = 4 * TUNE_QUARTER, KEYS = 7, MAX_GRACES = 4, DEFAULT_GRACE = WHOLE / 32 /* ticks, the default length */ };

struct loop {
    uint32_t begin, end, exit; /* end: after ]n; 0: not known yet */
    int left;                  /* passes, including this one; 0: first pass */
};

struct reader {
    struct mml *m;
    struct mml_track *t;
    uint32_t at; /* in m->line */
    uint32_t tick;
    struct mml_inst inst; /* selected */
    int current_inst;     /* number of the instrument that plays; -1: none yet */
    int octave, transpose, volume, pan;
    int detune; /* cents */
    int accidental[KEYS];
    uint32_t length;
    int gate;                        /* eighths */
    uint32_t cut;                    /* ticks */
    int last;                        /* pitch of the last note; -1: none yet */
    bool slurred;                    /* the previous note continues */
    uint32_t glide;                  /* ticks of the slide from the previous note; 0: none */
    int from_below;                  /* a note slides up from this many semitones below */
    uint32_t from_below_ticks;       /* length of this slide; 0: none */
    uint32_t repeat_ticks;           /* ticks between repetitions of a note; 0: none */
    int repeat_louder;               /* steps of 8 of 127 */
    int n_graces, grace[MAX_GRACES]; /* pitches of grace notes */
    uint32_t grace_ticks[MAX_GRACES];
    struct loop loops[MML_MAX_DEPTH];
    int depth;
    uint32_t group_total, group_n, group_k; /* ticks, notes and current note of {{ }}; n 0: none */
};

/* ---- characters ---- */

static char peek(const struct reader *r)
{
    return r->at < r->m->line.n ? r->m->line.text[r->at] : '\0';
}

static char peek_at(const struct reader *r, uint32_t k)
{
    return r->at + k < r->m->line.n ? r->m->line.text[r->at + k] : '\0';
}

static uint32_t file_offset(const struct reader *r, uint32_t p)
{
    const struct mml_line *l = &r->m->line;

    return l->n == 0 ? 0 : l->from[p < l->n ? p : l->n - 1];
}

#define FAIL(r, at, ...) mml_fail((r)->m, file_offset(r, at), __VA_ARGS__)

static void skip_blanks(struct reader *r)
{
    while (peek(r) == ' ' || peek(r) == '\t' || peek(r) == '\r' || peek(r) == '|')
        r->at++;
}

static bool is_note(char c)
{
    return c >= 'a' && c <= 'g';
}

static bool is_digit(char c)
{
    return c >= '0' && c <= '9';
}

/* Returns the next UTF-8 character in quotes, for an error. */
enum { QUOTED_SIZE = 8 };

static const char *quote_next(const struct reader *r, char out[QUOTED_SIZE])
{
    const unsigned char c = (unsigned char)peek(r);
    int n = 0;

    if (c == '\0' || c == ' ')
        return "nothing";
    out[n++] = '"';
    out[n++] = (char)c;
    for (uint32_t k = 1; c >= 0xC0 && k < 4 && ((unsigned char)peek_at(r, k) & 0xC0) == 0x80; k++)
        out[n++] = peek_at(r, k);
    if (c < 32 || (c >= 127 && n == 2))
        out[1] = '?';
    out[n++] = '"';
    out[n] = '\0';
    return out;
}

/* Parses an integer, with a sign if lo is below 0. */
static int parse_number(struct reader *r, const char *what, int lo, int hi)
{
    char got[QUOTED_SIZE];
    const uint32_t from = r->at;
    const bool minus = lo < 0 && peek(r) == '-';
    int64_t v = 0;

    if (minus || (lo < 0 && peek(r) == '+'))
        r->at++;
    if (!is_digit(peek(r)))
        FAIL(r, from, "expected %s, a number from %d to %d, got %s", what, lo, hi, quote_next(r, got));
    while (is_digit(peek(r))) {
        v = v > 1000000 ? v : v * 10 + (peek(r) - '0');
        r->at++;
    }
    v = minus ? -v : v;
    if (v < lo || v > hi)
        FAIL(r, from, "expected %s, a number from %d to %d, got %lld", what, lo, hi, (long long)v);
    return (int)v;
}

/* Parses a number with decimals, in hundredths. */
static int parse_hundredths(struct reader *r, const char *what, int lo, int hi)
{
    const uint32_t from = r->at;
    int v = parse_number(r, what, lo / 100, hi / 100) * 100;

    if (peek(r) == '.') {
        r->at++;
        for (int unit = 10; is_digit(peek(r)); unit /= 10, r->at++)
            v += (peek(r) - '0') * unit;
    }
    if (v < lo || v > hi)
        FAIL(r, from, "expected %s from %g to %g, got %g", what, lo / 100.0, hi / 100.0, v / 100.0);
    return v;
}

/* ---- lengths ---- */

/* Parses 4, 4., %120, or nothing for the default length. */
static uint32_t parse_single_length(struct reader *r)
{
    const uint32_t from = r->at;
    uint32_t ticks = r->length;

    if (peek(r) == '%') {
        r->at++;
        ticks = (uint32_t)parse_number(r, "ticks", 1, MML_MAX_TICKS);
    } else if (is_digit(peek(r))) {
        const int n = parse_number(r, "a length", 1, WHOLE);
        if (WHOLE % n != 0)
            FAIL(r, from,
                 "a length of 1/%d is not a whole number of ticks (%d per whole note); {{ }} divides by any number", n,
                 WHOLE);
        ticks = WHOLE / (uint32_t)n;
    }
    for (uint32_t dot = ticks; peek(r) == '.'; r->at++) {
        if (dot % 2 != 0)
            FAIL(r, r->at, "the length cannot be dotted: half of %u ticks is not a whole number", (unsigned)dot);
        dot /= 2;
        ticks += dot;
    }
    return ticks;
}

/* Parses a length with ties: 4^8 and 4&8. */
static uint32_t parse_length(struct reader *r)
{
    uint32_t ticks = parse_single_length(r);

    while (peek(r) == '^' || (peek(r) == '&' && (is_digit(peek_at(r, 1)) || peek_at(r, 1) == '%'))) {
        r->at++;
        ticks += parse_single_length(r);
    }
    return ticks;
}

static void advance(struct reader *r, uint32_t ticks, uint32_t from)
{
    r->tick += ticks;
    if (r->tick > MML_MAX_TICKS)
        FAIL(r, from, "longer than %d whole notes", MML_MAX_TICKS / WHOLE);
}

/* Returns the length of a note or rest; in {{ }} its share of the group's length. */
static uint32_t note_length(struct reader *r, uint32_t from)
{
    if (r->group_n == 0)
        return parse_length(r);
    if (is_digit(peek(r)) || peek(r) == '%' || peek(r) == '.' || peek(r) == '^')
        FAIL(r, from, "notes in {{ }} cannot have their own length");
    const uint32_t k = r->group_k++;
    return r->group_total * (k + 1) / r->group_n - r->group_total * k / r->group_n;
}

/* ---- notes ---- */

static void add_event(struct reader *r, uint32_t tick, enum tune_event e, int value, int more)
{
    mml_add(r->m, r->t, tick, e, value, more);
}

/* Switches the track to the selected instrument. */
static void switch_inst(struct reader *r, uint32_t from)
{
    const int i = mml_use_inst(r->m, &r->inst);

    if (i < 0)
        FAIL(r, from, "more than %d instruments; each vibrato or envelope counts as another", (int)TUNE_MAX_INSTS);
    if (i != r->current_inst)
        add_event(r, r->tick, TUNE_INST, i, 0);
    r->current_inst = i;
}

/* Parses a note and its accidentals; returns its pitch in 256ths of a semitone. */
static int parse_pitch(struct reader *r)
{
    static const int semitones[KEYS] = { 9, 11, 0, 2, 4, 5, 7 }; /* a to g */
    const uint32_t from = r->at;
    const int key = peek(r) - 'a';
    int v = semitones[key] + r->accidental[key];

    for (r->at++;; r->at++) {
        if (peek(r) == '+' || peek(r) == '#')
            v++;
        else if (peek(r) == '-')
            v--;
        else if (peek(r) == '=')
            v = semitones[key];
        else
            break;
    }
    v = (12 * (r->octave + 1) + v + r->transpose) * 256 + r->detune * 256 / 100;
    if (v < 0 || v > PITCH_MAX / 256)
        FAIL(r, from, "the note is too %s", v < 0 ? "low" : "high");
    return v;
}

static bool ends_group(const struct reader *r)
{
    return r->group_n && peek(r) == '}' && peek_at(r, 1) == '}';
}

/* Returns whether the last note is slurred to the next one, and consumes the &. After the last note of {{ }}, the &
 * follows the group, and end_group consumes it. */
static bool take_slur(struct reader *r)
{
    skip_blanks(r);
    if (ends_group(r)) {
        const uint32_t end = r->at;
        r->at += 2;
        parse_length(r);
        skip_blanks(r);
        const bool on = peek(r) == '&';
        r->at = end;
        return on;
    }
    if (peek(r) != '&')
        return false;
    r->at++;
    return true;
}

/* Returns the ticks until the release of a note. */
static uint32_t gate_ticks(const struct reader *r, uint32_t ticks)
{
    uint32_t n = ticks * (uint32_t)r->gate / 8;

    n = n > r->cut ? n - r->cut : 1;
    return n < ticks ? n : ticks;
}

/* Plays the grace notes before a note; returns the remaining ticks of the note. */
static uint32_t play_graces(struct reader *r, uint32_t ticks, uint32_t from)
{
    if (r->n_graces && r->slurred)
        FAIL(r, from, "grace note inside a slur");
    for (int i = 0; i < r->n_graces; i++) {
        if (r->grace_ticks[i] >= ticks)
            FAIL(r, from, "the grace notes leave no time for the note itself");
        add_event(r, r->tick, TUNE_NOTE, r->grace[i], 0);
        r->tick += r->grace_ticks[i];
        add_event(r, r->tick, TUNE_OFF, 0, 0);
        ticks -= r->grace_ticks[i];
    }
    r->n_graces = 0;
    return ticks;
}

/* Starts a note; after S or G, it slides to its pitch. */
static void start_note(struct reader *r, int v, uint32_t ticks)
{
    uint32_t over = r->from_below_ticks ? r->from_below_ticks : r->glide;
    int first = r->from_below_ticks ? v - 256 * r->from_below : r->glide && r->last >= 0 ? r->last : v;

    first = first < 0 ? 0 : first > PITCH_MAX / 256 ? PITCH_MAX / 256 : first;
    over = over < ticks ? over : ticks;
    add_event(r, r->tick, TUNE_NOTE, first, 0);
    if (first != v)
        add_event(r, r->tick, TUNE_GLIDE, v, (int)over);
}

/* Implements W: repeats a note until its release, with changing volume. */
static void repeat_note(struct reader *r, int v, uint32_t until, uint32_t ticks)
{
    int volume = r->volume;
    uint32_t t = r->repeat_ticks;

    for (; t < until && volume > 0; t += r->repeat_ticks) {
        volume += 8 * r->repeat_louder;
        volume = volume < 0 ? 0 : volume > TUNE_MAX_VOLUME ? TUNE_MAX_VOLUME : volume;
        add_event(r, r->tick + t, TUNE_VOLUME, volume, 0);
        add_event(r, r->tick + t, TUNE_NOTE, v, 0);
    }
    if (volume != r->volume)
        add_event(r, r->tick + ticks, TUNE_VOLUME, r->volume, 0);
}

/* Plays a note. to: the pitch to which it slides after `delay` ticks, or -1. */
static void play(struct reader *r, int v, uint32_t ticks, int to, uint32_t delay, uint32_t from)
{
    switch_inst(r, from);
    ticks = play_graces(r, ticks, from);
    if (delay >= ticks)
        FAIL(r, from, "the slide ends after its note");
    if (r->slurred)
        add_event(r, r->tick, TUNE_SLUR, v, 0);
    else if (to >= 0)
        add_event(r, r->tick, TUNE_NOTE, v, 0);
    else
        start_note(r, v, ticks);
    if (to >= 0)
        add_event(r, r->tick + delay, TUNE_GLIDE, to, (int)(ticks - delay > 65535 ? 65535 : ticks - delay));
    r->slurred = take_slur(r);
    if (r->repeat_ticks && !r->slurred && to < 0)
        repeat_note(r, v, gate_ticks(r, ticks), ticks);
    if (!r->slurred)
        add_event(r, r->tick + gate_ticks(r, ticks), TUNE_OFF, 0, 0);
    r->last = v;
    advance(r, ticks, from);
}

/* Reads ~c16: a grace note, which shortens the next note. */
static void read_grace(struct reader *r)
{
    const uint32_t from = r->at++;

    if (!is_note(peek(r)))
        FAIL(r, from, "expected a note after ~, as in ~c16 d4");
    if (r->n_graces == MAX_GRACES)
        FAIL(r, from, "more than %d grace notes before a note", (int)MAX_GRACES);
    r->grace[r->n_graces] = parse_pitch(r);
    r->grace_ticks[r->n_graces++] = is_digit(peek(r)) || peek(r) == '%' ? parse_length(r) : DEFAULT_GRACE;
}

static void read_note(struct reader *r)
{
    const uint32_t from = r->at;
    const int v = parse_pitch(r);

    play(r, v, note_length(r, from), -1, 0, from);
}

static void read_repeat(struct reader *r)
{
    const uint32_t from = r->at++;

    if (r->last < 0)
        FAIL(r, from, "x repeats the previous note, but there is none");
    play(r, r->last, note_length(r, from), -1, 0, from);
}

static void read_rest(struct reader *r)
{
    const uint32_t from = r->at++, ticks = note_length(r, from);

    if (r->n_graces)
        FAIL(r, from, "grace note before a rest");
    if (r->slurred)
        add_event(r, r->tick, TUNE_OFF, 0, 0);
    r->slurred = false;
    advance(r, ticks, from);
}

static void step_octave(struct reader *r, int by)
{
    r->octave += by;
    if (r->octave < -1 || r->octave > 9)
        FAIL(r, r->at, "the octave is too %s", by < 0 ? "low" : "high");
}

/* Reads {c>g}4,8: c slides to g within a quarter, after an eighth. */
static void read_slide(struct reader *r)
{
    const uint32_t from = r->at++;
    int v[2], n = 0;

    for (skip_blanks(r); peek(r) != '}'; skip_blanks(r)) {
        if (is_note(peek(r)) && n < 2)
            v[n++] = parse_pitch(r);
        else if (peek(r) == '>' || peek(r) == '<')
            step_octave(r, r->m->line.text[r->at++] == '>' ? 1 : -1);
        else if (peek(r) == 'o')
            r->at++, r->octave = parse_number(r, "an octave", 0, 9);
        else
            FAIL(r, from, "expected { and two notes }, as in {c>g}4");
    }
    r->at++;
    if (n < 2)
        FAIL(r, from, "expected { and two notes }, as in {c>g}4");
    const uint32_t ticks = parse_length(r);
    uint32_t delay = 0;
    if (peek(r) == ',') {
        r->at++;
        delay = parse_single_length(r);
    }
    play(r, v[0], ticks, v[1], delay, from);
    r->last = v[1];
}

/* Reads the start of {{ceg}}4: the notes share the length. */
static void begin_group(struct reader *r)
{
    const uint32_t from = r->at;
    uint32_t n = 0;

    if (r->group_n)
        FAIL(r, from, "{{ inside {{");
    for (r->at += 2; peek(r) && !(peek(r) == '}' && peek_at(r, 1) == '}'); r->at++) {
        if (peek(r) == '[' || peek(r) == '{' || peek(r) == '"' || peek(r) == '@' || peek(r) == '~')
            FAIL(r, r->at, "{{ }} can only contain notes, rests and octaves");
        n += is_note(peek(r)) || peek(r) == 'r' || peek(r) == 'x';
    }
    if (!peek(r) || n == 0)
        FAIL(r, from, n ? "{{ without }}" : "{{ }} without a note");
    r->at += 2;
    r->group_total = parse_length(r);
    if (r->group_total < n)
        FAIL(r, from, "%u notes do not fit in %u ticks", (unsigned)n, (unsigned)r->group_total);
    r->group_n = n;
    r->group_k = 0;
    r->at = from + 2;
}

static void end_group(struct reader *r)
{
    if (!ends_group(r))
        FAIL(r, r->at, "} without {");
    r->at += 2;
    r->group_n = 0;
    parse_length(r);
    skip_blanks(r);
    if (peek(r) == '&' && r->slurred)
        r->at++;
}

/* ---- loops ---- */

static void start_loop(struct reader *r)
{
    if (r->depth == MML_MAX_DEPTH)
        FAIL(r, r->at, "loops nested deeper than %d", (int)MML_MAX_DEPTH);
    r->at++;
    r->loops[r->depth++] = (struct loop){ r->at, 0, 0, 0 };
}

static void end_loop(struct reader *r)
{
    const uint32_t from = r->at++;

    if (r->depth == 0)
        FAIL(r, from, "] without [");
    struct loop *l = &r->loops[r->depth - 1];
    const int n = is_digit(peek(r)) ? parse_number(r, "a repeat count", 2, 255) : 2;
    if (l->left == 0)
        l->left = n;
    l->end = r->at;
    if (--l->left > 0)
        r->at = l->begin;
    else
        r->depth--;
}

static void leave_loop(struct reader *r)
{
    const uint32_t from = r->at++;

    if (r->depth == 0)
        FAIL(r, from, "/ without [");
    const struct loop *l = &r->loops[r->depth - 1];
    if (l->left == 1) {
        r->at = l->end;
        r->depth--;
    }
}

/* Reads L. Each repetition starts with the settings of the first pass. */
static void set_loop_point(struct reader *r)
{
    if (r->t->loop >= 0)
        FAIL(r, r->at, "L is already in this track");
    if (r->depth > 0)
        FAIL(r, r->at, "L inside [ ]");
    if (r->slurred)
        FAIL(r, r->at, "L inside a slur");
    r->t->loop = r->tick;
    r->t->loop_from = file_offset(r, r->at);
    r->at++;
    if (r->current_inst >= 0)
        add_event(r, r->tick, TUNE_INST, r->current_inst, 0);
    add_event(r, r->tick, TUNE_VOLUME, r->volume, 0);
    add_event(r, r->tick, TUNE_PANNING, r->pan, 0);
}

/* ---- settings ---- */

static void set_volume(struct reader *r, int v)
{
    r->volume = v < 0 ? 0 : v > TUNE_MAX_VOLUME ? TUNE_MAX_VOLUME : v;
    add_event(r, r->tick, TUNE_VOLUME, r->volume, 0);
}

static void step_volume(struct reader *r, int by)
{
    r->at++;
    set_volume(r, r->volume + by * (is_digit(peek(r)) ? parse_number(r, "steps", 1, TUNE_MAX_VOLUME) : 8));
}

static void set_pan(struct reader *r)
{
    r->at++;
    r->pan = parse_number(r, "a pan (0 left, 64 centre, 128 right)", 0, 2 * TUNE_PAN_CENTRE);
    add_event(r, r->tick, TUNE_PANNING, r->pan, 0);
}

static void set_tempo(struct reader *r)
{
    r->at++;
    mml_add(r->m, &r->m->conductor, r->tick, TUNE_TEMPO,
            parse_hundredths(r, "quarter notes per minute", TEMPO_MIN, TEMPO_MAX), 0);
}

static void read_name(struct reader *r, char name[MML_NAME])
{
    for (int n = 0; mml_name_char(peek(r)) && n < MML_NAME - 1; r->at++)
        name[n++] = peek(r);
}

static void set_inst(struct reader *r)
{
    const uint32_t from = r->at++;
    char name[MML_NAME] = "";
    struct edit_nearest near = { .word = name };

    read_name(r, name);
    if (mml_find_inst(r->m, name, &r->inst))
        return;
    for (int i = 0; i < r->m->n_named; i++)
        edit_consider(&near, r->m->named[i].name);
    if (near.found)
        FAIL(r, from, "unknown instrument \"%s\" (did you mean \"%s\"?)", name, near.found);
    FAIL(r, from, "unknown instrument \"%s\"", name);
}

static void need_comma(struct reader *r, const char *expected)
{
    if (peek(r) != ',')
        FAIL(r, r->at, "expected %s", expected);
    r->at++;
}

/* Reads the name of a curve, or - for none: Eswell, Mdrop, Paround. False: no name. */
static bool set_curve(struct reader *r, char kind, uint32_t *piece)
{
    const uint32_t from = r->at;
    const char c = peek_at(r, 1);
    char name[MML_NAME] = "";

    if (c != '-' && (c < 'a' || c > 'z'))
        return false;
    r->at++;
    *piece = 0;
    if (c == '-') {
        r->at++;
        return true;
    }
    read_name(r, name);
    *piece = mml_find_curve(r->m, kind, name);
    if (*piece == 0)
        FAIL(r, from, "unknown curve \"%s\": expected a line @%c %s FRAMES:VALUE,VALUE...", name, kind, name);
    return true;
}

/* Reads Eattack,decay,sustain,release: milliseconds, milliseconds, percent, milliseconds. */
static void set_envelope(struct reader *r)
{
    static const char form[] = "E attack,decay,sustain,release: milliseconds, and percent for sustain";
    struct env *e = &r->inst.inst.env;

    if (set_curve(r, 'E', &r->inst.inst.volume_curve))
        return;
    r->at++;
    e->attack = mml_to_samples(1000 * (int64_t)parse_number(r, form, 0, 60000));
    need_comma(r, form);
    e->decay = mml_to_samples(1000 * (int64_t)parse_number(r, form, 0, 60000));
    need_comma(r, form);
    e->sustain = (uint16_t)(parse_number(r, form, 0, 100) * 32767 / 100);
    need_comma(r, form);
    e->release = mml_to_samples(1000 * (int64_t)parse_number(r, form, 0, 60000));
}

/* Reads the rest of M and MA: ,hertz,milliseconds. */
static void read_lfo(struct reader *r, struct lfo *l, const char *form)
{
    need_comma(r, form);
    l->step = mml_to_step(10 * (int64_t)parse_hundredths(r, form, 1, 2500));
    need_comma(r, form);
    l->delay = mml_to_samples(1000 * (int64_t)parse_number(r, form, 0, 60000));
}

/* Reads Mcents,hertz,milliseconds (or MP), or MApercent,hertz,milliseconds; M0 and MA0: none. */
static void set_lfo(struct reader *r)
{
    static const char vibrato[] = "M cents,hertz,milliseconds of delay",
                      tremolo[] = "MA percent,hertz,milliseconds of delay";
    struct inst *i = &r->inst.inst;

    if (set_curve(r, 'M', &i->pitch_curve))
        return;
    r->at++;
    if (peek(r) == 'A') {
        r->at++;
        i->tremolo = (struct lfo){ .depth = (uint16_t)(parse_number(r, tremolo, 0, 100) * 32767 / 100) };
        if (i->tremolo.depth)
            read_lfo(r, &i->tremolo, tremolo);
        return;
    }
    r->at += peek(r) == 'P';
    i->vibrato = (struct lfo){ .depth = (uint16_t)(parse_number(r, vibrato, 0, 2400) * 256 / 100) };
    if (i->vibrato.depth)
        read_lfo(r, &i->vibrato, vibrato);
}

static void set_pan_curve(struct reader *r)
{
    if (!set_curve(r, 'P', &r->inst.inst.pan_curve))
        FAIL(r, r->at, "expected a curve name after P, or P- for none (p64 is a pan)");
}

/* Parses a length, or 0 for none. */
static uint32_t parse_length_or_none(struct reader *r, const char *form)
{
    if (peek(r) == '0' && !is_digit(peek_at(r, 1))) {
        r->at++;
        return 0;
    }
    if (!is_digit(peek(r)) && peek(r) != '%')
        FAIL(r, r->at, "expected %s", form);
    return parse_length(r);
}

/* Reads G16: notes slide from the previous note within a 16th. */
static void set_glide(struct reader *r)
{
    r->at++;
    r->glide = parse_length_or_none(r, "G and the slide's length, as in G16, or G0");
    if (r->glide > 65535)
        FAIL(r, r->at, "slides are limited to 65535 ticks");
}

/* Reads S2,16: notes slide up from 2 semitones below within a 16th. */
static void set_slide(struct reader *r)
{
    static const char form[] = "S semitones,length, as in S2,16, or S0";

    r->at++;
    r->from_below = parse_number(r, form, -48, 48);
    r->from_below_ticks = 0;
    if (r->from_below == 0)
        return;
    need_comma(r, form);
    const uint32_t from = r->at;
    r->from_below_ticks = parse_length_or_none(r, form);
    if (r->from_below_ticks == 0 || r->from_below_ticks > 65535)
        FAIL(r, from, "expected %s", form);
}

/* Reads W8,-2: notes are repeated every 8th, each time 2 of 16 steps softer. */
static void set_note_repeat(struct reader *r)
{
    static const char form[] = "W length,steps, as in W8,-2, or W0";

    r->at++;
    r->repeat_ticks = parse_length_or_none(r, form);
    r->repeat_louder = 0;
    if (r->repeat_ticks == 0)
        return;
    need_comma(r, form);
    r->repeat_louder = parse_number(r, "a volume change (of 16),", -15, 15);
}

/* Reads D20: 20 cents higher; DD5: 5 cents more. */
static void set_detune(struct reader *r)
{
    const bool relative = peek_at(r, 1) == 'D';

    r->at += relative ? 2 : 1;
    r->detune = parse_number(r, "cents", -1200, 1200) + (relative ? r->detune : 0);
    if (r->detune < -1200 || r->detune > 1200)
        FAIL(r, r->at, "detuned by %d cents; expected -1200 to 1200", r->detune);
}

/* Reads K-12 or _-12: 12 semitones lower; __2: 2 semitones more. */
static void set_transpose(struct reader *r)
{
    const bool relative = peek(r) == '_' && peek_at(r, 1) == '_';

    if (peek(r) == '_' && peek_at(r, 1) == 'M')
        FAIL(r, r->at, "unknown command \"_M\" (\"K\" transposes)");
    r->at += relative ? 2 : 1;
    r->transpose = parse_number(r, "semitones", -48, 48) + (relative ? r->transpose : 0);
    if (r->transpose < -48 || r->transpose > 48)
        FAIL(r, r->at, "transposed by %d semitones; expected -48 to 48", r->transpose);
}

/* Reads _{+fc}: f and c become sharp; _{=}: no accidentals. */
static void set_key(struct reader *r)
{
    const uint32_t from = r->at;
    int by = 0;

    for (r->at += 2; peek(r) != '}'; r->at++) {
        const char c = peek(r);
        if (c == '+' || c == '-')
            by = c == '+' ? 1 : -1;
        else if (c == '=')
            memset(r->accidental, 0, sizeof r->accidental);
        else if (is_note(c) && by)
            r->accidental[c - 'a'] = by;
        else
            FAIL(r, from, "expected _{+fc} for the sharps of a key, or _{-be} for its flats");
    }
    r->at++;
}

int mml_marker(struct mml *m, const char name[TUNE_NAME_SIZE])
{
    int i = 0;

    while (i < m->n_markers && strcmp(m->markers[i], name) != 0)
        i++;
    if (i == TUNE_MAX_MARKERS)
        return -1;
    if (i == m->n_markers)
        memcpy(m->markers[m->n_markers++], name, TUNE_NAME_SIZE);
    return i;
}

static void set_marker(struct reader *r)
{
    struct mml *m = r->m;
    const uint32_t from = r->at++;
    char name[TUNE_NAME_SIZE] = "";
    int n = 0, i = 0;

    for (; peek(r) && peek(r) != '"'; r->at++) {
        if (n == TUNE_NAME_SIZE - 1 || (unsigned char)peek(r) < 32)
            FAIL(r, from, "expected a marker name of at most %d characters in \" \"", TUNE_NAME_SIZE - 1);
        name[n++] = peek(r);
    }
    if (!peek(r) || n == 0)
        FAIL(r, from, n ? "\" without a closing \"" : "marker without a name");
    r->at++;
    i = mml_marker(m, name);
    if (i < 0)
        FAIL(r, from, "more than %d markers", (int)TUNE_MAX_MARKERS);
    mml_add(m, &m->conductor, r->tick, TUNE_MARKER, i, 0);
}

/* Reads a command that is a setting; false: another command. */
static bool read_setting(struct reader *r)
{
    switch (peek(r)) {
    case 'o':
        return r->at++, r->octave = parse_number(r, "an octave", 0, 9), true;
    case 'v':
        return r->at++, set_volume(r, parse_number(r, "a volume", 0, 15) * TUNE_MAX_VOLUME / 15), true;
    case 'V':
        return r->at++, set_volume(r, parse_number(r, "a volume", 0, TUNE_MAX_VOLUME)), true;
    case 'Q':
        return r->at++, r->gate = parse_number(r, "eighths of a note", 1, 8), true;
    case 'q':
        return r->at++, r->cut = (uint32_t)parse_number(r, "ticks cut from the end of a note", 0, WHOLE), true;
    case 'D':
        return set_detune(r), true;
    case 'K':
        return set_transpose(r), true;
    case 'G':
        return set_glide(r), true;
    case 'S':
        return set_slide(r), true;
    case 'W':
        return set_note_repeat(r), true;
    case 'P':
        return set_pan_curve(r), true;
    case 'l':
        return r->at++, r->length = parse_single_length(r), true;
    case 'p':
        return set_pan(r), true;
    case 't':
        return set_tempo(r), true;
    case 'E':
        return set_envelope(r), true;
    case 'M':
        return set_lfo(r), true;
    default:
        return false;
    }
}

static void read_command(struct reader *r)
{
    char got[QUOTED_SIZE];

    if (is_note(peek(r))) {
        read_note(r);
        return;
    }
    if (read_setting(r))
        return;
    switch (peek(r)) {
    case 'r':
        read_rest(r);
        break;
    case 'x':
        read_repeat(r);
        break;
    case '>':
    case '<':
        step_octave(r, r->m->line.text[r->at++] == '>' ? 1 : -1);
        break;
    case '(':
    case ')':
        step_volume(r, peek(r) == ')' ? 1 : -1);
        break;
    case '[':
        start_loop(r);
        break;
    case ']':
        end_loop(r);
        break;
    case '/':
        leave_loop(r);
        break;
    case '{':
        peek_at(r, 1) == '{' ? begin_group(r) : read_slide(r);
        break;
    case '}':
        end_group(r);
        break;
    case 'L':
        set_loop_point(r);
        break;
    case '@':
        set_inst(r);
        break;
    case '_':
        peek_at(r, 1) == '{' ? set_key(r) : set_transpose(r);
        break;
    case '~':
        read_grace(r);
        break;
    case '"':
        set_marker(r);
        break;
    case '^':
    case '&':
        FAIL(r, r->at, "expected a note before %s", quote_next(r, got));
    case ':':
        FAIL(r, r->at, "unknown command %s (\"/\" leaves a loop)", quote_next(r, got));
    case '`':
        FAIL(r, r->at, "unknown command %s (\";\" starts a comment)", quote_next(r, got));
    default:
        FAIL(r, r->at, "unknown command %s", quote_next(r, got));
    }
}

void mml_read_track(struct mml *m, struct mml_track *t)
{
    struct reader r = { .m = m,
                        .t = t,
                        .current_inst = -1,
                        .octave = 4,
                        .volume = 100,
                        .pan = TUNE_PAN_CENTRE,
                        .length = TUNE_QUARTER,
                        .gate = 8,
                        .last = -1 };

    mml_find_inst(m, "pulse", &r.inst);
    add_event(&r, 0, TUNE_VOLUME, r.volume, 0);
    for (skip_blanks(&r); r.at < m->line.n; skip_blanks(&r)) {
        m->position = file_offset(&r, r.at);
        read_command(&r);
    }
    if (r.n_graces)
        FAIL(&r, r.at, "grace note without a note after it");
    if (r.depth > 0)
        FAIL(&r, r.loops[r.depth - 1].begin - 1, "[ without ]");
    if (r.group_n)
        FAIL(&r, r.at, "{{ without }}");
    if (r.slurred)
        add_event(&r, r.tick, TUNE_OFF, 0, 0);
    t->end = r.tick;
    if (t->loop >= 0 && t->end == t->loop)
        mml_fail(m, t->loop_from, "nothing to repeat after L");
}
