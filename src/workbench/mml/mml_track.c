/*
 * mml_track.c - the commands of a track, read from its expanded text. Loops are unrolled here: the board reads events
 * in order, and only supports the endless loop.
 */
#include "mml_parts.h"

#include <string.h>
#include "../../base/edit.h"
#include "../../sound/pitch.h"

enum { WHOLE = 4 * TUNE_QUARTER, KEYS = 7, GRACES = 4, GRACE = WHOLE / 32 /* ticks, the default length */ };

struct loop {
    uint32_t begin, end, exit; /* end: after ]n, 0: not known yet */
    int left;                  /* passes, including this one; 0: first pass */
};

struct reader {
    struct mml *m;
    struct mml_track *t;
    uint32_t p; /* in m->line */
    uint32_t tick;
    struct mml_inst inst; /* the chosen one */
    int inst_now;         /* number of the one that the track plays, -1: none yet */
    int octave, transpose, volume, pan;
    int detune; /* cents */
    int accidental[KEYS];
    uint32_t length;
    int gate;                  /* eighths */
    uint32_t cut;              /* ticks */
    int last;                  /* pitch, -1: no note yet */
    bool slurred;              /* the previous note continues */
    uint32_t glide;            /* ticks of the slide from the previous note; 0: none */
    int from_below;            /* semitones below a note where its slide starts */
    uint32_t from_below_ticks; /* ticks of that slide; 0: none */
    uint32_t strike;           /* ticks between strokes of a note; 0: one stroke */
    int strike_louder;         /* steps of 8 of 127 */
    int graces, grace[GRACES]; /* their pitches */
    uint32_t grace_ticks[GRACES];
    struct loop loops[MML_DEPTH];
    int depth;
    uint32_t group_total, group_n, group_k; /* of {{ }}; n 0: none */
};

/* ---- characters ---- */

static char peek(const struct reader *r)
{
    return r->p < r->m->line.n ? r->m->line.text[r->p] : '\0';
}

static char peek_at(const struct reader *r, uint32_t k)
{
    return r->p + k < r->m->line.n ? r->m->line.text[r->p + k] : '\0';
}

static uint32_t place(const struct reader *r, uint32_t p)
{
    const struct mml_line *l = &r->m->line;

    return l->n == 0 ? 0 : l->from[p < l->n ? p : l->n - 1];
}

#define BAD(r, at, ...) mml_bad((r)->m, place(r, at), __VA_ARGS__)

static void skip(struct reader *r)
{
    while (peek(r) == ' ' || peek(r) == '\t' || peek(r) == '\r' || peek(r) == '|')
        r->p++;
}

static bool is_note(char c)
{
    return c >= 'a' && c <= 'g';
}

static bool digit(char c)
{
    return c >= '0' && c <= '9';
}

/* The next character in quotes, with all its bytes, for an error. */
enum { SEEN = 8 };

static const char *seen(const struct reader *r, char out[SEEN])
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

/* A whole number, with a sign if lo is below 0. */
static int number(struct reader *r, const char *what, int lo, int hi)
{
    char got[SEEN];
    const uint32_t from = r->p;
    const bool minus = lo < 0 && peek(r) == '-';
    int64_t v = 0;

    if (minus || (lo < 0 && peek(r) == '+'))
        r->p++;
    if (!digit(peek(r)))
        BAD(r, from, "expected %s, a number from %d to %d, got %s", what, lo, hi, seen(r, got));
    while (digit(peek(r))) {
        v = v > 1000000 ? v : v * 10 + (peek(r) - '0');
        r->p++;
    }
    v = minus ? -v : v;
    if (v < lo || v > hi)
        BAD(r, from, "expected %s, a number from %d to %d, got %lld", what, lo, hi, (long long)v);
    return (int)v;
}

/* A number with decimals, in hundredths. */
static int hundredths(struct reader *r, const char *what, int lo, int hi)
{
    const uint32_t from = r->p;
    int v = number(r, what, lo / 100, hi / 100) * 100;

    if (peek(r) == '.') {
        r->p++;
        for (int unit = 10; digit(peek(r)); unit /= 10, r->p++)
            v += (peek(r) - '0') * unit;
    }
    if (v < lo || v > hi)
        BAD(r, from, "expected %s from %g to %g, got %g", what, lo / 100.0, hi / 100.0, v / 100.0);
    return v;
}

/* ---- lengths ---- */

/* 4, 4., %120, or nothing: the default length. */
static uint32_t one_length(struct reader *r)
{
    const uint32_t from = r->p;
    uint32_t ticks = r->length;

    if (peek(r) == '%') {
        r->p++;
        ticks = (uint32_t)number(r, "ticks", 1, MML_TICKS);
    } else if (digit(peek(r))) {
        const int n = number(r, "a length", 1, WHOLE);
        if (WHOLE % n != 0)
            BAD(r, from,
                "a length of 1/%d is not a whole number of ticks (%d per whole note); {{ }} divides by any number", n,
                WHOLE);
        ticks = WHOLE / (uint32_t)n;
    }
    for (uint32_t dot = ticks; peek(r) == '.'; r->p++) {
        if (dot % 2 != 0)
            BAD(r, r->p, "the length cannot be dotted: half of %u ticks is not a whole number", (unsigned)dot);
        dot /= 2;
        ticks += dot;
    }
    return ticks;
}

/* With ties: 4^8 and 4&8. */
static uint32_t length(struct reader *r)
{
    uint32_t ticks = one_length(r);

    while (peek(r) == '^' || (peek(r) == '&' && (digit(peek_at(r, 1)) || peek_at(r, 1) == '%'))) {
        r->p++;
        ticks += one_length(r);
    }
    return ticks;
}

static void advance(struct reader *r, uint32_t ticks, uint32_t from)
{
    r->tick += ticks;
    if (r->tick > MML_TICKS)
        BAD(r, from, "longer than %d whole notes", MML_TICKS / WHOLE);
}

/* The length of a note or rest; in {{ }} its share. */
static uint32_t lasting(struct reader *r, uint32_t from)
{
    if (r->group_n == 0)
        return length(r);
    if (digit(peek(r)) || peek(r) == '%' || peek(r) == '.' || peek(r) == '^')
        BAD(r, from, "notes in {{ }} cannot have their own length");
    const uint32_t k = r->group_k++;
    return r->group_total * (k + 1) / r->group_n - r->group_total * k / r->group_n;
}

/* ---- notes ---- */

static void event(struct reader *r, uint32_t tick, enum tune_event e, int value, int more)
{
    mml_add(r->m, r->t, tick, e, value, more);
}

/* The track plays the instrument that was chosen. */
static void use_inst(struct reader *r, uint32_t from)
{
    const int i = mml_use_inst(r->m, &r->inst);

    if (i < 0)
        BAD(r, from, "more than %d instruments; each vibrato or envelope counts as another", (int)TUNE_MAX_INSTS);
    if (i != r->inst_now)
        event(r, r->tick, TUNE_INST, i, 0);
    r->inst_now = i;
}

/* Reads a note and its accidentals: its pitch in 256ths of a semitone. */
static int pitch(struct reader *r)
{
    static const int semitones[KEYS] = { 9, 11, 0, 2, 4, 5, 7 }; /* a to g */
    const uint32_t from = r->p;
    const int key = peek(r) - 'a';
    int v = semitones[key] + r->accidental[key];

    for (r->p++;; r->p++) {
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
        BAD(r, from, "the note is too %s", v < 0 ? "low" : "high");
    return v;
}

static bool ends_group(const struct reader *r)
{
    return r->group_n && peek(r) == '}' && peek_at(r, 1) == '}';
}

/* True if the note before p is slurred to the next one. After the last note of {{ }}, the & is after the group, and
 * end_group takes it. */
static bool slurs_on(struct reader *r)
{
    skip(r);
    if (ends_group(r)) {
        const uint32_t end = r->p;
        r->p += 2;
        length(r);
        skip(r);
        const bool on = peek(r) == '&';
        r->p = end;
        return on;
    }
    if (peek(r) != '&')
        return false;
    r->p++;
    return true;
}

/* Ticks until the release of a note. */
static uint32_t gated(const struct reader *r, uint32_t ticks)
{
    uint32_t n = ticks * (uint32_t)r->gate / 8;

    n = n > r->cut ? n - r->cut : 1;
    return n < ticks ? n : ticks;
}

/* Plays the grace notes before a note; returns the rest of its ticks. */
static uint32_t play_graces(struct reader *r, uint32_t ticks, uint32_t from)
{
    if (r->graces && r->slurred)
        BAD(r, from, "grace note inside a slur");
    for (int i = 0; i < r->graces; i++) {
        if (r->grace_ticks[i] >= ticks)
            BAD(r, from, "the grace notes leave no time for the note itself");
        event(r, r->tick, TUNE_NOTE, r->grace[i], 0);
        r->tick += r->grace_ticks[i];
        event(r, r->tick, TUNE_OFF, 0, 0);
        ticks -= r->grace_ticks[i];
    }
    r->graces = 0;
    return ticks;
}

/* Starts a note; with S and G it slides to its pitch. */
static void begin_note(struct reader *r, int v, uint32_t ticks)
{
    uint32_t over = r->from_below_ticks ? r->from_below_ticks : r->glide;
    int first = r->from_below_ticks ? v - 256 * r->from_below : r->glide && r->last >= 0 ? r->last : v;

    first = first < 0 ? 0 : first > PITCH_MAX / 256 ? PITCH_MAX / 256 : first;
    over = over < ticks ? over : ticks;
    event(r, r->tick, TUNE_NOTE, first, 0);
    if (first != v)
        event(r, r->tick, TUNE_GLIDE, v, (int)over);
}

/* W: repeats the strokes of a note until its release, with changing volume. */
static void strike_again(struct reader *r, int v, uint32_t until, uint32_t ticks)
{
    int volume = r->volume;
    uint32_t t = r->strike;

    for (; t < until && volume > 0; t += r->strike) {
        volume += 8 * r->strike_louder;
        volume = volume < 0 ? 0 : volume > TUNE_MAX_VOLUME ? TUNE_MAX_VOLUME : volume;
        event(r, r->tick + t, TUNE_VOLUME, volume, 0);
        event(r, r->tick + t, TUNE_NOTE, v, 0);
    }
    if (volume != r->volume)
        event(r, r->tick + ticks, TUNE_VOLUME, r->volume, 0);
}

/* Plays a note; to: the pitch it slides to after `delay` ticks, or -1. */
static void play(struct reader *r, int v, uint32_t ticks, int to, uint32_t delay, uint32_t from)
{
    use_inst(r, from);
    ticks = play_graces(r, ticks, from);
    if (delay >= ticks)
        BAD(r, from, "the slide ends after its note");
    if (r->slurred)
        event(r, r->tick, TUNE_SLUR, v, 0);
    else if (to >= 0)
        event(r, r->tick, TUNE_NOTE, v, 0);
    else
        begin_note(r, v, ticks);
    if (to >= 0)
        event(r, r->tick + delay, TUNE_GLIDE, to, (int)(ticks - delay > 65535 ? 65535 : ticks - delay));
    r->slurred = slurs_on(r);
    if (r->strike && !r->slurred && to < 0)
        strike_again(r, v, gated(r, ticks), ticks);
    if (!r->slurred)
        event(r, r->tick + gated(r, ticks), TUNE_OFF, 0, 0);
    r->last = v;
    advance(r, ticks, from);
}

/* ~c16: a grace note, whose time the next note loses. */
static void grace(struct reader *r)
{
    const uint32_t from = r->p++;

    if (!is_note(peek(r)))
        BAD(r, from, "expected a note after ~, as in ~c16 d4");
    if (r->graces == GRACES)
        BAD(r, from, "more than %d grace notes before a note", (int)GRACES);
    r->grace[r->graces] = pitch(r);
    r->grace_ticks[r->graces++] = digit(peek(r)) || peek(r) == '%' ? length(r) : GRACE;
}

static void note(struct reader *r)
{
    const uint32_t from = r->p;
    const int v = pitch(r);

    play(r, v, lasting(r, from), -1, 0, from);
}

static void again(struct reader *r)
{
    const uint32_t from = r->p++;

    if (r->last < 0)
        BAD(r, from, "x repeats the previous note, but there is none");
    play(r, r->last, lasting(r, from), -1, 0, from);
}

static void rest(struct reader *r)
{
    const uint32_t from = r->p++, ticks = lasting(r, from);

    if (r->graces)
        BAD(r, from, "grace note before a rest");
    if (r->slurred)
        event(r, r->tick, TUNE_OFF, 0, 0);
    r->slurred = false;
    advance(r, ticks, from);
}

static void step_octave(struct reader *r, int by)
{
    r->octave += by;
    if (r->octave < -1 || r->octave > 9)
        BAD(r, r->p, "the octave is too %s", by < 0 ? "low" : "high");
}

/* {c>g}4,8: c slides to g within a quarter, after an eighth. */
static void slide(struct reader *r)
{
    const uint32_t from = r->p++;
    int v[2], n = 0;

    for (skip(r); peek(r) != '}'; skip(r)) {
        if (is_note(peek(r)) && n < 2)
            v[n++] = pitch(r);
        else if (peek(r) == '>' || peek(r) == '<')
            step_octave(r, r->m->line.text[r->p++] == '>' ? 1 : -1);
        else if (peek(r) == 'o')
            r->p++, r->octave = number(r, "an octave", 0, 9);
        else
            BAD(r, from, "expected { and two notes }, as in {c>g}4");
    }
    r->p++;
    if (n < 2)
        BAD(r, from, "expected { and two notes }, as in {c>g}4");
    const uint32_t ticks = length(r);
    uint32_t delay = 0;
    if (peek(r) == ',') {
        r->p++;
        delay = one_length(r);
    }
    play(r, v[0], ticks, v[1], delay, from);
    r->last = v[1];
}

/* {{ceg}}4: the notes share the length. */
static void group(struct reader *r)
{
    const uint32_t from = r->p;
    uint32_t n = 0;

    if (r->group_n)
        BAD(r, from, "{{ inside {{");
    for (r->p += 2; peek(r) && !(peek(r) == '}' && peek_at(r, 1) == '}'); r->p++) {
        if (peek(r) == '[' || peek(r) == '{' || peek(r) == '"' || peek(r) == '@' || peek(r) == '~')
            BAD(r, r->p, "{{ }} can only contain notes, rests and octaves");
        n += is_note(peek(r)) || peek(r) == 'r' || peek(r) == 'x';
    }
    if (!peek(r) || n == 0)
        BAD(r, from, n ? "{{ without }}" : "{{ }} without a note");
    r->p += 2;
    r->group_total = length(r);
    if (r->group_total < n)
        BAD(r, from, "%u notes do not fit in %u ticks", (unsigned)n, (unsigned)r->group_total);
    r->group_n = n;
    r->group_k = 0;
    r->p = from + 2;
}

static void end_group(struct reader *r)
{
    if (!ends_group(r))
        BAD(r, r->p, "} without {");
    r->p += 2;
    r->group_n = 0;
    length(r);
    skip(r);
    if (peek(r) == '&' && r->slurred)
        r->p++;
}

/* ---- loops ---- */

static void begin_loop(struct reader *r)
{
    if (r->depth == MML_DEPTH)
        BAD(r, r->p, "loops nested deeper than %d", (int)MML_DEPTH);
    r->p++;
    r->loops[r->depth++] = (struct loop){ r->p, 0, 0, 0 };
}

static void end_loop(struct reader *r)
{
    const uint32_t from = r->p++;

    if (r->depth == 0)
        BAD(r, from, "] without [");
    struct loop *l = &r->loops[r->depth - 1];
    const int n = digit(peek(r)) ? number(r, "a repeat count", 2, 255) : 2;
    if (l->left == 0)
        l->left = n;
    l->end = r->p;
    if (--l->left > 0)
        r->p = l->begin;
    else
        r->depth--;
}

static void leave_loop(struct reader *r)
{
    const uint32_t from = r->p++;

    if (r->depth == 0)
        BAD(r, from, "/ without [");
    const struct loop *l = &r->loops[r->depth - 1];
    if (l->left == 1) {
        r->p = l->end;
        r->depth--;
    }
}

/* Each repeat starts with the settings of the first. */
static void endless(struct reader *r)
{
    if (r->t->loop >= 0)
        BAD(r, r->p, "L is already in this track");
    if (r->depth > 0)
        BAD(r, r->p, "L inside [ ]");
    if (r->slurred)
        BAD(r, r->p, "L inside a slur");
    r->t->loop = r->tick;
    r->t->loop_from = place(r, r->p);
    r->p++;
    if (r->inst_now >= 0)
        event(r, r->tick, TUNE_INST, r->inst_now, 0);
    event(r, r->tick, TUNE_VOLUME, r->volume, 0);
    event(r, r->tick, TUNE_PANNING, r->pan, 0);
}

/* ---- settings ---- */

static void set_volume(struct reader *r, int v)
{
    r->volume = v < 0 ? 0 : v > TUNE_MAX_VOLUME ? TUNE_MAX_VOLUME : v;
    event(r, r->tick, TUNE_VOLUME, r->volume, 0);
}

static void step_volume(struct reader *r, int by)
{
    r->p++;
    set_volume(r, r->volume + by * (digit(peek(r)) ? number(r, "steps", 1, TUNE_MAX_VOLUME) : 8));
}

static void set_pan(struct reader *r)
{
    r->p++;
    r->pan = number(r, "a pan (0 left, 64 centre, 128 right)", 0, 2 * TUNE_PAN_CENTRE);
    event(r, r->tick, TUNE_PANNING, r->pan, 0);
}

static void set_tempo(struct reader *r)
{
    r->p++;
    mml_add(r->m, &r->m->conductor, r->tick, TUNE_TEMPO,
            hundredths(r, "quarter notes per minute", TEMPO_MIN, TEMPO_MAX), 0);
}

static void read_name(struct reader *r, char name[MML_NAME])
{
    for (int n = 0; mml_name_char(peek(r)) && n < MML_NAME - 1; r->p++)
        name[n++] = peek(r);
}

static void set_inst(struct reader *r)
{
    const uint32_t from = r->p++;
    char name[MML_NAME] = "";
    struct edit_nearest near = { .word = name };

    read_name(r, name);
    if (mml_find_inst(r->m, name, &r->inst))
        return;
    for (int i = 0; i < r->m->n_named; i++)
        edit_consider(&near, r->m->named[i].name);
    if (near.found)
        BAD(r, from, "unknown instrument \"%s\" (did you mean \"%s\"?)", name, near.found);
    BAD(r, from, "unknown instrument \"%s\"", name);
}

static void comma(struct reader *r, const char *expected)
{
    if (peek(r) != ',')
        BAD(r, r->p, "expected %s", expected);
    r->p++;
}

/* Reads the name of a curve, or - for none: Eswell, Mdrop, Paround. False: no name. */
static bool set_curve(struct reader *r, char kind, uint32_t *piece)
{
    const uint32_t from = r->p;
    const char c = peek_at(r, 1);
    char name[MML_NAME] = "";

    if (c != '-' && (c < 'a' || c > 'z'))
        return false;
    r->p++;
    *piece = 0;
    if (c == '-') {
        r->p++;
        return true;
    }
    read_name(r, name);
    *piece = mml_find_curve(r->m, kind, name);
    if (*piece == 0)
        BAD(r, from, "unknown curve \"%s\": expected a line @%c %s FRAMES:VALUE,VALUE...", name, kind, name);
    return true;
}

/* Eattack,decay,sustain,release: milliseconds, milliseconds, percent, milliseconds. */
static void set_envelope(struct reader *r)
{
    static const char form[] = "E attack,decay,sustain,release: milliseconds, and percent for sustain";
    struct env *e = &r->inst.inst.env;

    if (set_curve(r, 'E', &r->inst.inst.volume_curve))
        return;
    r->p++;
    e->attack = mml_samples(1000 * (int64_t)number(r, form, 0, 60000));
    comma(r, form);
    e->decay = mml_samples(1000 * (int64_t)number(r, form, 0, 60000));
    comma(r, form);
    e->sustain = (uint16_t)(number(r, form, 0, 100) * 32767 / 100);
    comma(r, form);
    e->release = mml_samples(1000 * (int64_t)number(r, form, 0, 60000));
}

/* The rest of M and MA: ,hertz,milliseconds. */
static void read_lfo(struct reader *r, struct lfo *l, const char *form)
{
    comma(r, form);
    l->step = mml_hertz(10 * (int64_t)hundredths(r, form, 1, 2500));
    comma(r, form);
    l->delay = mml_samples(1000 * (int64_t)number(r, form, 0, 60000));
}

/* Mcents,hertz,milliseconds, MP the same, MApercent,hertz,milliseconds; M0, MA0: none. */
static void set_slow_wave(struct reader *r)
{
    static const char vibrato[] = "M cents,hertz,milliseconds of delay",
                      tremolo[] = "MA percent,hertz,milliseconds of delay";
    struct inst *i = &r->inst.inst;

    if (set_curve(r, 'M', &i->pitch_curve))
        return;
    r->p++;
    if (peek(r) == 'A') {
        r->p++;
        i->tremolo = (struct lfo){ .depth = (uint16_t)(number(r, tremolo, 0, 100) * 32767 / 100) };
        if (i->tremolo.depth)
            read_lfo(r, &i->tremolo, tremolo);
        return;
    }
    r->p += peek(r) == 'P';
    i->vibrato = (struct lfo){ .depth = (uint16_t)(number(r, vibrato, 0, 2400) * 256 / 100) };
    if (i->vibrato.depth)
        read_lfo(r, &i->vibrato, vibrato);
}

static void set_place_curve(struct reader *r)
{
    if (!set_curve(r, 'P', &r->inst.inst.pan_curve))
        BAD(r, r->p, "expected a curve name after P, or P- for none (p64 is a pan)");
}

/* A length, or 0 for none. */
static uint32_t length_or_none(struct reader *r, const char *form)
{
    if (peek(r) == '0' && !digit(peek_at(r, 1))) {
        r->p++;
        return 0;
    }
    if (!digit(peek(r)) && peek(r) != '%')
        BAD(r, r->p, "expected %s", form);
    return length(r);
}

/* G16: notes slide from the previous one within a 16th. */
static void set_glide(struct reader *r)
{
    r->p++;
    r->glide = length_or_none(r, "G and the slide's length, as in G16, or G0");
    if (r->glide > 65535)
        BAD(r, r->p, "slides are limited to 65535 ticks");
}

/* S2,16: notes slide up from 2 semitones below within a 16th. */
static void set_from_below(struct reader *r)
{
    static const char form[] = "S semitones,length, as in S2,16, or S0";

    r->p++;
    r->from_below = number(r, form, -48, 48);
    r->from_below_ticks = 0;
    if (r->from_below == 0)
        return;
    comma(r, form);
    const uint32_t from = r->p;
    r->from_below_ticks = length_or_none(r, form);
    if (r->from_below_ticks == 0 || r->from_below_ticks > 65535)
        BAD(r, from, "expected %s", form);
}

/* W8,-2: notes are repeated every 8th, each time 2 of 16 softer. */
static void set_strike(struct reader *r)
{
    static const char form[] = "W length,steps, as in W8,-2, or W0";

    r->p++;
    r->strike = length_or_none(r, form);
    r->strike_louder = 0;
    if (r->strike == 0)
        return;
    comma(r, form);
    r->strike_louder = number(r, "a volume change (of 16),", -15, 15);
}

/* D20: 20 cents higher; DD5: 5 cents more. */
static void set_detune(struct reader *r)
{
    const bool more = peek_at(r, 1) == 'D';

    r->p += more ? 2 : 1;
    r->detune = number(r, "cents", -1200, 1200) + (more ? r->detune : 0);
    if (r->detune < -1200 || r->detune > 1200)
        BAD(r, r->p, "detuned by %d cents; expected -1200 to 1200", r->detune);
}

/* K-12, _-12: 12 semitones lower; __2: 2 semitones more. */
static void set_transpose(struct reader *r)
{
    const bool more = peek(r) == '_' && peek_at(r, 1) == '_';

    if (peek(r) == '_' && peek_at(r, 1) == 'M')
        BAD(r, r->p, "unknown command \"_M\" (\"K\" transposes)");
    r->p += more ? 2 : 1;
    r->transpose = number(r, "semitones", -48, 48) + (more ? r->transpose : 0);
    if (r->transpose < -48 || r->transpose > 48)
        BAD(r, r->p, "transposed by %d semitones; expected -48 to 48", r->transpose);
}

/* _{+fc}: f and c become sharp; _{=}: no accidentals. */
static void set_key(struct reader *r)
{
    const uint32_t from = r->p;
    int by = 0;

    for (r->p += 2; peek(r) != '}'; r->p++) {
        const char c = peek(r);
        if (c == '+' || c == '-')
            by = c == '+' ? 1 : -1;
        else if (c == '=')
            memset(r->accidental, 0, sizeof r->accidental);
        else if (is_note(c) && by)
            r->accidental[c - 'a'] = by;
        else
            BAD(r, from, "expected _{+fc} for the sharps of a key, or _{-be} for its flats");
    }
    r->p++;
}

int mml_mark(struct mml *m, const char name[TUNE_NAME_SIZE])
{
    int i = 0;

    while (i < m->n_marks && strcmp(m->marks[i], name) != 0)
        i++;
    if (i == TUNE_MAX_MARKERS)
        return -1;
    if (i == m->n_marks)
        memcpy(m->marks[m->n_marks++], name, TUNE_NAME_SIZE);
    return i;
}

static void set_mark(struct reader *r)
{
    struct mml *m = r->m;
    const uint32_t from = r->p++;
    char name[TUNE_NAME_SIZE] = "";
    int n = 0, i = 0;

    for (; peek(r) && peek(r) != '"'; r->p++) {
        if (n == TUNE_NAME_SIZE - 1 || (unsigned char)peek(r) < 32)
            BAD(r, from, "expected a marker name of at most %d characters in \" \"", TUNE_NAME_SIZE - 1);
        name[n++] = peek(r);
    }
    if (!peek(r) || n == 0)
        BAD(r, from, n ? "\" without a closing \"" : "marker without a name");
    r->p++;
    i = mml_mark(m, name);
    if (i < 0)
        BAD(r, from, "more than %d markers", (int)TUNE_MAX_MARKERS);
    mml_add(m, &m->conductor, r->tick, TUNE_MARKER, i, 0);
}

/* Commands that set a number. */
static bool read_number(struct reader *r)
{
    switch (peek(r)) {
    case 'o':
        return r->p++, r->octave = number(r, "an octave", 0, 9), true;
    case 'v':
        return r->p++, set_volume(r, number(r, "a volume", 0, 15) * TUNE_MAX_VOLUME / 15), true;
    case 'V':
        return r->p++, set_volume(r, number(r, "a volume", 0, TUNE_MAX_VOLUME)), true;
    case 'Q':
        return r->p++, r->gate = number(r, "eighths of a note", 1, 8), true;
    case 'q':
        return r->p++, r->cut = (uint32_t)number(r, "ticks cut from the end of a note", 0, WHOLE), true;
    case 'D':
        return set_detune(r), true;
    case 'K':
        return set_transpose(r), true;
    case 'G':
        return set_glide(r), true;
    case 'S':
        return set_from_below(r), true;
    case 'W':
        return set_strike(r), true;
    case 'P':
        return set_place_curve(r), true;
    case 'l':
        return r->p++, r->length = one_length(r), true;
    case 'p':
        return set_pan(r), true;
    case 't':
        return set_tempo(r), true;
    case 'E':
        return set_envelope(r), true;
    case 'M':
        return set_slow_wave(r), true;
    default:
        return false;
    }
}

static void command(struct reader *r)
{
    char got[SEEN];

    if (is_note(peek(r))) {
        note(r);
        return;
    }
    if (read_number(r))
        return;
    switch (peek(r)) {
    case 'r':
        rest(r);
        break;
    case 'x':
        again(r);
        break;
    case '>':
    case '<':
        step_octave(r, r->m->line.text[r->p++] == '>' ? 1 : -1);
        break;
    case '(':
    case ')':
        step_volume(r, peek(r) == ')' ? 1 : -1);
        break;
    case '[':
        begin_loop(r);
        break;
    case ']':
        end_loop(r);
        break;
    case '/':
        leave_loop(r);
        break;
    case '{':
        peek_at(r, 1) == '{' ? group(r) : slide(r);
        break;
    case '}':
        end_group(r);
        break;
    case 'L':
        endless(r);
        break;
    case '@':
        set_inst(r);
        break;
    case '_':
        peek_at(r, 1) == '{' ? set_key(r) : set_transpose(r);
        break;
    case '~':
        grace(r);
        break;
    case '"':
        set_mark(r);
        break;
    case '^':
    case '&':
        BAD(r, r->p, "expected a note before %s", seen(r, got));
    case ':':
        BAD(r, r->p, "unknown command %s (\"/\" leaves a loop)", seen(r, got));
    case '`':
        BAD(r, r->p, "unknown command %s (\";\" starts a comment)", seen(r, got));
    default:
        BAD(r, r->p, "unknown command %s", seen(r, got));
    }
}

void mml_read_track(struct mml *m, struct mml_track *t)
{
    struct reader r = { .m = m,
                        .t = t,
                        .inst_now = -1,
                        .octave = 4,
                        .volume = 100,
                        .pan = TUNE_PAN_CENTRE,
                        .length = TUNE_QUARTER,
                        .gate = 8,
                        .last = -1 };

    mml_find_inst(m, "pulse", &r.inst);
    event(&r, 0, TUNE_VOLUME, r.volume, 0);
    for (skip(&r); r.p < m->line.n; skip(&r)) {
        m->now = place(&r, r.p);
        command(&r);
    }
    if (r.graces)
        BAD(&r, r.p, "grace note without a note after it");
    if (r.depth > 0)
        BAD(&r, r.loops[r.depth - 1].begin - 1, "[ without ]");
    if (r.group_n)
        BAD(&r, r.p, "{{ without }}");
    if (r.slurred)
        event(&r, r.tick, TUNE_OFF, 0, 0);
    t->end = r.tick;
    if (t->loop >= 0 && t->end == t->loop)
        mml_bad(m, t->loop_from, "nothing to repeat after L");
}
