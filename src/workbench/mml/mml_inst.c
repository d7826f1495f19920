/*
 * mml_inst.c - instruments of MML: built-in ones, and lines like
 *     @bell fm ratio=3.5 depth=2 dull=300 attack=2 decay=400 sustain=0 release=300 vibrato=20,5.5,200
 */
#include "mml_parts.h"

#include <string.h>
#include "../../base/edit.h"
#include "../../sound/pitch.h"

static const char *const kinds[INST_KINDS] = { "pulse", "triangle", "saw", "sine", "fm",
                                               "noise", "sample",   "fm4", "wave" };
static const char all_kinds[] =
    "pulse, triangle, saw, sine, fm, fm4, wave, noise, sample, or an instrument defined above";

/* Times are in samples: 48 per millisecond. An operator plays at the note's pitch. */
static const struct op default_op = { .ratio = 256, .env.sustain = 32767 };
static const struct mml_inst default_inst = {
    .inst = { .duty = 32768, .env = { 24000, 96, 4800, 0, 1920 }, .root = 60 * PITCH_ONE }
};

uint32_t mml_to_samples(int64_t thousandths)
{
    return (uint32_t)(thousandths * (SND_RATE / 1000) / 1000);
}

uint32_t mml_to_step(int64_t thousandths)
{
    return (uint32_t)((thousandths << 32) / (1000 * SND_RATE));
}

int64_t mml_parse_decimal(struct mml *m, uint32_t *at, uint32_t end, const char *what, int64_t lo, int64_t hi)
{
    const uint32_t from = *at;
    const bool minus = *at < end && m->text[*at] == '-';
    int64_t v = 0, place = 100;
    bool digits = false;

    *at += minus;
    for (; *at < end && m->text[*at] >= '0' && m->text[*at] <= '9'; ++*at, digits = true)
        v = v > 1 << 28 ? v : v * 10 + (m->text[*at] - '0');
    v *= 1000;
    if (*at < end && m->text[*at] == '.')
        for (++*at; *at < end && m->text[*at] >= '0' && m->text[*at] <= '9'; ++*at, place /= 10, digits = true)
            v += (m->text[*at] - '0') * place;
    v = minus ? -v : v;
    if (!digits || v < lo || v > hi)
        mml_fail(m, from, "expected %s from %g to %g, got \"%.*s\"", what, (double)lo / 1000, (double)hi / 1000,
                 (int)(*at > from ? *at - from : *at < end), m->text + from);
    return v;
}

static int find_kind(const char *name)
{
    for (int k = 0; k < INST_KINDS; k++)
        if (strcmp(kinds[k], name) == 0)
            return k;
    return -1;
}

/* Returns the default settings of a kind. With two operators, the first modulates by two radians; with four operators,
 * the default is algorithm 7, in which all are audible. */
static struct mml_inst make_default(int kind)
{
    struct mml_inst i = default_inst;

    i.inst.kind = (uint8_t)kind;
    if (kind == INST_SAMPLE)
        i.inst.env.sustain = 32767;
    if (kind == INST_FM4)
        i.inst.algorithm = FM_ALGORITHMS - 1;
    for (int k = 0; k < inst_op_count(kind); k++) {
        i.ops[k] = default_op;
        i.ops[k].level = kind == INST_FM && k == 0 ? 1304 : 32767;
    }
    return i;
}

/* Every kind except sample and wave is a built-in instrument. */
bool mml_find_inst(const struct mml *m, const char *name, struct mml_inst *out)
{
    const int kind = find_kind(name);

    for (int i = 0; i < m->n_named; i++)
        if (strcmp(m->named[i].name, name) == 0) {
            *out = m->named[i].inst;
            return true;
        }
    if (kind < 0 || kind == INST_SAMPLE || kind == INST_WAVE)
        return false;
    *out = make_default(kind);
    return true;
}

/* Scales audible operators so that together they are not louder than one. */
static void limit_loudness(struct mml_inst *i)
{
    const int n = inst_op_count(i->inst.kind);
    uint32_t loud = 0;

    for (int k = 0; k < n; k++)
        loud += inst_audible_ops(n, i->inst.algorithm) >> k & 1 ? i->ops[k].level : 0;
    for (int k = 0; k < n && loud > 32767; k++)
        if (inst_audible_ops(n, i->inst.algorithm) >> k & 1)
            i->ops[k].level = (uint16_t)((uint32_t)i->ops[k].level * 32767 / loud);
}

int mml_use_inst(struct mml *m, const struct mml_inst *inst)
{
    struct mml_inst balanced = *inst;
    uint8_t bytes[INST_BYTES];
    int i = 0;

    limit_loudness(&balanced);
    balanced.inst.arpeggio = balanced.arpeggio;
    inst_write(bytes, &balanced.inst, balanced.ops, balanced.sample);
    while (i < m->n_insts && memcmp(m->insts[i], bytes, INST_BYTES) != 0)
        i++;
    if (i == TUNE_MAX_INSTS)
        return -1;
    if (i == m->n_insts)
        memcpy(m->insts[m->n_insts++], bytes, INST_BYTES);
    return i;
}

void mml_parse_word(struct mml *m, uint32_t *at, uint32_t end, char out[MML_NAME], const char *what)
{
    const uint32_t from = *at;

    while (*at < end && mml_name_char(m->text[*at]))
        ++*at;
    if (*at == from || *at - from >= MML_NAME)
        mml_fail(m, from, "expected %s", what);
    memset(out, 0, MML_NAME);
    memcpy(out, m->text + from, *at - from);
}

uint32_t mml_skip_blanks(const struct mml *m, uint32_t at, uint32_t end)
{
    while (at < end && mml_is_blank(m->text[at]))
        at++;
    return at;
}

bool mml_take_comma(const struct mml *m, uint32_t *at, uint32_t end)
{
    const bool found = *at < end && m->text[*at] == ',';

    *at += found;
    return found;
}

/* ---- settings ---- */

enum { MAX_TIME = 60000000 /* a minute in thousandths of a millisecond: the longest time */ };

/* The setting being read: its instrument, name, offset of the name, offset of the value, and end of the line. */
struct setting {
    struct mml *m;
    struct mml_inst *i;
    const char *key;
    uint32_t key_at, at, end;
};

static int64_t parse_number(struct setting *s, const char *what, int64_t lo, int64_t hi)
{
    return mml_parse_decimal(s->m, &s->at, s->end, what, lo, hi);
}

static uint32_t parse_time(struct setting *s)
{
    return mml_to_samples(parse_number(s, "milliseconds", 0, MAX_TIME));
}

static uint16_t parse_percent(struct setting *s, const char *what)
{
    return (uint16_t)(parse_number(s, what, 0, 100000) * 32767 / 100000);
}

static uint16_t parse_ratio(struct setting *s)
{
    return (uint16_t)(parse_number(s, "a pitch ratio", 10, 32000) * 256 / 1000);
}

static uint16_t parse_radians(struct setting *s)
{
    return (uint16_t)(parse_number(s, "radians", 0, 24000) * 652 / 1000);
}

static bool take_comma(struct setting *s)
{
    return mml_take_comma(s->m, &s->at, s->end);
}

static void need_comma(struct setting *s, const char *form)
{
    if (!take_comma(s))
        mml_fail(s->m, s->at, "expected %s", form);
}

static void read_lfo(struct setting *s, struct lfo *l, const char *form)
{
    need_comma(s, form);
    l->step = mml_to_step(parse_number(s, "hertz", 10, 25000));
    need_comma(s, form);
    l->delay = parse_time(s);
}

/* Reads op2=RATIO,LEVEL,ATTACK,DECAY,SUSTAIN,RELEASE; trailing values may be missing. */
static void read_op(struct setting *s, int k)
{
    struct op *o = &s->i->ops[k];
    const int n = inst_op_count(s->i->inst.kind);

    if (k >= n)
        mml_fail(s->m, s->key_at, n ? "this instrument has %d operators" : "only fm and fm4 have operators", n);
    o->ratio = parse_ratio(s);
    if (!take_comma(s))
        return;
    o->level = inst_audible_ops(n, s->i->inst.algorithm) >> k & 1
                   ? parse_percent(s, "percent (for an audible operator)")
                   : parse_radians(s);
    if (!take_comma(s))
        return;
    o->env.attack = parse_time(s);
    if (!take_comma(s))
        return;
    o->env.decay = parse_time(s);
    o->env.sustain = 0;
    if (!take_comma(s))
        return;
    o->env.sustain = parse_percent(s, "percent");
    if (take_comma(s))
        o->env.release = parse_time(s);
}

/* The algorithm decides the meaning of levels, so it must be before them. */
static void read_algorithm(struct setting *s)
{
    const uint32_t from = s->at;

    if (s->i->inst.kind != INST_FM4)
        mml_fail(s->m, s->key_at, "only fm4 has an algorithm");
    s->i->inst.algorithm = (uint8_t)(parse_number(s, "an algorithm", 0, 7000) / 1000);
    for (int k = 0; k < FM_OPS; k++) {
        const bool audible = inst_audible_ops(FM_OPS, s->i->inst.algorithm) >> k & 1;
        const struct op *o = &s->i->ops[k];
        if (o->ratio != 256 || o->env.attack || o->env.decay)
            mml_fail(s->m, from, "expected the algorithm before the operators: it decides which of them are audible");
        s->i->ops[k].level = audible ? 32767 : 652;
    }
}

static void read_arpeggio(struct setting *s)
{
    struct inst *i = &s->i->inst;

    i->arpeggio_count = 0;
    i->arpeggio_frames = (uint16_t)(parse_number(s, "frames per note", 1000, 3600000) / 1000);
    if (s->at == s->end || s->m->text[s->at++] != ':')
        mml_fail(s->m, s->key_at, "expected arpeggio=FRAMES:SEMITONES,SEMITONES..., as in arpeggio=2:0,4,7");
    do {
        if (i->arpeggio_count == ARPEGGIO_MAX_NOTES)
            mml_fail(s->m, s->key_at, "expected at most %d pitches", (int)ARPEGGIO_MAX_NOTES);
        s->i->arpeggio[i->arpeggio_count++] = (uint8_t)(parse_number(s, "semitones", -48000, 48000) / 1000);
    } while (take_comma(s));
}

static bool read_time(struct setting *s)
{
    struct env *e = &s->i->inst.env;
    const struct {
        const char *name;
        uint32_t *samples;
    } times[] = { { "attack", &e->attack }, { "decay", &e->decay }, { "fade", &e->fade }, { "release", &e->release } };

    for (size_t k = 0; k < sizeof times / sizeof *times; k++)
        if (strcmp(s->key, times[k].name) == 0) {
            *times[k].samples = parse_time(s);
            return true;
        }
    return false;
}

/* Reads FM settings; `ratio`, `depth` and `dull` are those of the first operator. */
static bool read_fm(struct setting *s)
{
    struct op *o = s->i->ops;
    const size_t n = strlen(s->key);

    if (strcmp(s->key, "ratio") == 0) {
        o->ratio = parse_ratio(s);
    } else if (strcmp(s->key, "depth") == 0) {
        o->level = parse_radians(s);
    } else if (strcmp(s->key, "dull") == 0) {
        o->env.decay = parse_time(s);
        o->env.sustain = o->env.decay ? 0 : 32767;
    } else if (strcmp(s->key, "feedback") == 0) {
        s->i->inst.feedback = (uint16_t)(parse_number(s, "radians", 0, 1500) * FM_MAX_FEEDBACK / 1500);
    } else if (strcmp(s->key, "algorithm") == 0) {
        read_algorithm(s);
    } else if (n == 3 && memcmp(s->key, "op", 2) == 0 && s->key[2] >= '1' && s->key[2] <= '4') {
        read_op(s, s->key[2] - '1');
    } else if (n == 7 && memcmp(s->key, "detune", 6) == 0 && s->key[6] >= '1' && s->key[6] <= '4') {
        const int64_t hertz = parse_number(s, "hertz", -1000000, 1000000);
        o[s->key[6] - '1'].detune = (int32_t)(hertz * ((int64_t)1 << 32) / (1000 * SND_RATE));
    } else {
        return false;
    }
    return true;
}

static bool read_shape(struct setting *s)
{
    struct inst *i = &s->i->inst;

    if (strcmp(s->key, "volume") == 0)
        i->volume_curve = mml_read_curve(s->m, &s->at, s->end, 'E');
    else if (strcmp(s->key, "pitch") == 0)
        i->pitch_curve = mml_read_curve(s->m, &s->at, s->end, 'M');
    else if (strcmp(s->key, "pan") == 0)
        i->pan_curve = mml_read_curve(s->m, &s->at, s->end, 'P');
    else if (strcmp(s->key, "harmonics") == 0 && i->kind == INST_WAVE)
        i->wave = mml_read_harmonics(s->m, &s->at, s->end);
    else if (strcmp(s->key, "points") == 0 && i->kind == INST_WAVE)
        i->wave = mml_read_points(s->m, &s->at, s->end);
    else if (strcmp(s->key, "arpeggio") == 0)
        read_arpeggio(s);
    else
        return false;
    return true;
}

_Noreturn static void fail_unknown(const struct setting *s)
{
    static const char *const names[] = { "duty",     "attack",    "decay",  "sustain",  "fade",     "release",
                                         "vibrato",  "tremolo",   "ratio",  "depth",    "dull",     "root",
                                         "feedback", "algorithm", "op1",    "detune1",  "arpeggio", "volume",
                                         "pitch",    "pan",       "points", "harmonics" };
    struct edit_nearest near = { .word = s->key };

    if (strcmp(s->key, "harmonics") == 0 || strcmp(s->key, "points") == 0)
        mml_fail(s->m, s->key_at, "only wave instruments have %s", s->key);
    for (size_t k = 0; k < sizeof names / sizeof *names; k++)
        edit_consider(&near, names[k]);
    mml_fail(s->m, s->key_at, near.found ? "unknown setting \"%s\" (did you mean \"%s\"?)" : "unknown setting \"%s\"",
             s->key, near.found);
}

/* Reads a value, key=value. */
static void read_setting(struct setting *s)
{
    struct inst *i = &s->i->inst;

    if (read_time(s) || read_shape(s) || (inst_op_count(i->kind) && read_fm(s)))
        return;
    if (strcmp(s->key, "duty") == 0)
        i->duty = (uint16_t)(parse_number(s, "percent", 1000, 99000) * 65536 / 100000);
    else if (strcmp(s->key, "sustain") == 0)
        i->env.sustain = parse_percent(s, "percent");
    else if (strcmp(s->key, "vibrato") == 0) {
        i->vibrato.depth = (uint16_t)(parse_number(s, "cents", 0, 2400000) * 256 / 100000);
        read_lfo(s, &i->vibrato, "vibrato=CENTS,HERTZ,MILLISECONDS");
    } else if (strcmp(s->key, "tremolo") == 0) {
        i->tremolo.depth = parse_percent(s, "percent");
        read_lfo(s, &i->tremolo, "tremolo=PERCENT,HERTZ,MILLISECONDS");
    } else if (strcmp(s->key, "root") == 0)
        i->root = (int32_t)(parse_number(s, "a note number (60 is o4c)", 0, 127000) / 1000) * PITCH_ONE;
    else
        fail_unknown(s);
}

static void check_name(struct mml *m, uint32_t at, const char *name)
{
    if (m->n_named == MML_MAX_NAMES)
        mml_fail(m, at, "more than %d instruments", (int)MML_MAX_NAMES);
    for (int i = 0; i < m->n_named; i++)
        if (strcmp(m->named[i].name, name) == 0)
            mml_fail(m, at, "duplicate instrument \"%s\"", name);
}

/* Reads a kind, or the name of an instrument to start from. */
static struct mml_inst read_kind(struct mml *m, uint32_t *at, uint32_t end)
{
    const uint32_t from = *at;
    struct mml_inst inst;
    char word[MML_NAME];

    mml_parse_word(m, at, end, word, all_kinds);
    if (mml_find_inst(m, word, &inst))
        return inst;
    if (find_kind(word) < 0)
        mml_fail(m, from, "expected %s, got \"%s\"", all_kinds, word);
    inst = make_default(find_kind(word));
    if (inst.inst.kind == INST_SAMPLE) {
        *at = mml_skip_blanks(m, *at, end);
        mml_parse_word(m, at, end, inst.sample, "sample NAME, a sound from rom.lua that is a sample");
    }
    return inst;
}

void mml_read_inst(struct mml *m, uint32_t at, uint32_t end)
{
    char name[MML_NAME], word[MML_NAME];
    uint32_t p = at + 1;

    mml_parse_word(m, &p, end, name, "an instrument name");
    check_name(m, at, name);
    p = mml_skip_blanks(m, p, end);
    struct mml_inst inst = read_kind(m, &p, end);
    while ((p = mml_skip_blanks(m, p, end)) < end) {
        struct setting s = { m, &inst, word, p, 0, end };
        mml_parse_word(m, &p, end, word, "a setting, as in attack=5");
        if (p == end || m->text[p] != '=')
            mml_fail(m, s.key_at, "expected a value, %s=VALUE", word);
        s.at = p + 1;
        read_setting(&s);
        p = s.at;
        if (p < end && !mml_is_blank(m->text[p]))
            mml_fail(m, p, "expected a space after %s, got \"%c\"", word, m->text[p]);
    }
    if (inst.inst.kind == INST_WAVE && inst.inst.wave == 0)
        mml_fail(m, at, "expected harmonics= or points=: a wave needs a waveform");
    memcpy(m->named[m->n_named].name, name, MML_NAME);
    m->named[m->n_named++].inst = inst;
}
