/*
 * mml_inst.c - instruments of MML: those built in, and lines like
 *     @bell fm ratio=3.5 depth=2 dull=300 attack=2 decay=400 sustain=0 release=300 vibrato=20,5.5,200
 */
#include "mml_parts.h"

#include <string.h>
#include "../../base/edit.h"
#include "../../snd/pitch.h"

static const char *const kinds[INST_KINDS] = { "pulse", "triangle", "saw", "sine", "fm", "noise", "sample" };

/* Times in samples: 48 a millisecond. */
static const struct inst plain = {
    .duty = 32768, .sustain = 24000, .attack = 96, .decay = 4800, .release = 1920, .ratio = 256, .root = 60 * PITCH_ONE
};

uint32_t mml_samples(int64_t thousandths)
{
    return (uint32_t)(thousandths * (SND_RATE / 1000) / 1000);
}

uint32_t mml_hertz(int64_t thousandths)
{
    return (uint32_t)((thousandths << 32) / (1000 * SND_RATE));
}

int64_t mml_decimal(struct mml *m, uint32_t *at, uint32_t end, const char *what, int64_t lo, int64_t hi)
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
        mml_bad(m, from, "expected %s from %g to %g, got \"%.*s\"", what, (double)lo / 1000, (double)hi / 1000,
                (int)(*at > from ? *at - from : *at < end), m->text + from);
    return v;
}

static int kind_named(const char *name)
{
    for (int k = 0; k < INST_KINDS; k++)
        if (strcmp(kinds[k], name) == 0)
            return k;
    return -1;
}

/* Every kind but a sample is an instrument without being declared. */
bool mml_find_inst(const struct mml *m, const char *name, struct inst *out)
{
    const int kind = kind_named(name);

    for (int i = 0; i < m->n_named; i++)
        if (strcmp(m->named[i].name, name) == 0) {
            *out = m->named[i].inst;
            return true;
        }
    if (kind < 0 || kind == INST_SAMPLE)
        return false;
    *out = plain;
    out->kind = (uint8_t)kind;
    out->depth = kind == INST_FM ? 1304 : 0; /* 2 radians */
    return true;
}

/* The word at *at: letters, digits and _. */
static void read_word(struct mml *m, uint32_t *at, uint32_t end, char out[MML_NAME], const char *what)
{
    const uint32_t from = *at;

    while (*at < end && mml_name_char(m->text[*at]))
        ++*at;
    if (*at == from || *at - from >= MML_NAME)
        mml_bad(m, from, "expected %s", what);
    memset(out, 0, MML_NAME);
    memcpy(out, m->text + from, *at - from);
}

static void comma(struct mml *m, uint32_t *at, uint32_t end)
{
    if (*at == end || m->text[*at] != ',')
        mml_bad(m, *at, "expected vibrato=CENTS,HERTZ,MILLISECONDS");
    ++*at;
}

enum { LONG = 60000000 /* a minute in thousandths of a millisecond: the longest time */ };

static void read_vibrato(struct mml *m, struct inst *i, uint32_t *at, uint32_t end)
{
    i->vibrato = (uint16_t)(mml_decimal(m, at, end, "cents", 0, 2400000) * 256 / 100000);
    comma(m, at, end);
    i->vibrato_step = mml_hertz(mml_decimal(m, at, end, "hertz", 10, 25000));
    comma(m, at, end);
    i->vibrato_delay = mml_samples(mml_decimal(m, at, end, "milliseconds", 0, LONG));
}

/* One key=value. */
static void read_setting(struct mml *m, struct inst *i, const char *key, uint32_t key_at, uint32_t *at, uint32_t end)
{
    static const char *const names[] = { "duty",    "attack", "decay", "sustain", "fade", "release",
                                         "vibrato", "ratio",  "depth", "dull",    "root" };
    const struct {
        const char *name;
        uint32_t *samples;
    } times[] = { { "attack", &i->attack },
                  { "decay", &i->decay },
                  { "fade", &i->fade },
                  { "release", &i->release },
                  { "dull", &i->dulling } };

    for (size_t k = 0; k < sizeof times / sizeof *times; k++)
        if (strcmp(key, times[k].name) == 0) {
            *times[k].samples = mml_samples(mml_decimal(m, at, end, "milliseconds", 0, LONG));
            return;
        }
    if (strcmp(key, "duty") == 0)
        i->duty = (uint16_t)(mml_decimal(m, at, end, "percent", 1000, 99000) * 65536 / 100000);
    else if (strcmp(key, "sustain") == 0)
        i->sustain = (uint16_t)(mml_decimal(m, at, end, "percent", 0, 100000) * 32767 / 100000);
    else if (strcmp(key, "vibrato") == 0)
        read_vibrato(m, i, at, end);
    else if (strcmp(key, "ratio") == 0)
        i->ratio = (uint16_t)(mml_decimal(m, at, end, "times the note's pitch", 10, 32000) * 256 / 1000);
    else if (strcmp(key, "depth") == 0)
        i->depth = (uint16_t)(mml_decimal(m, at, end, "radians", 0, 24000) * 652 / 1000);
    else if (strcmp(key, "root") == 0)
        i->root = (int32_t)(mml_decimal(m, at, end, "a note's number (60 is o4c)", 0, 127000) / 1000) * PITCH_ONE;
    else {
        const char *near = NULL;
        int best = EDIT_FAR;
        for (size_t k = 0; k < sizeof names / sizeof *names; k++)
            if (edit_distance(key, names[k]) < best) {
                best = edit_distance(key, names[k]);
                near = names[k];
            }
        mml_bad(m, key_at, near ? "unknown setting \"%s\" (did you mean \"%s\"?)" : "unknown setting \"%s\"", key,
                near);
    }
}

static uint32_t skip(const struct mml *m, uint32_t at, uint32_t end)
{
    while (at < end && (m->text[at] == ' ' || m->text[at] == '\t' || m->text[at] == '\r'))
        at++;
    return at;
}

void mml_read_inst(struct mml *m, uint32_t at, uint32_t end)
{
    char name[MML_NAME], word[MML_NAME];
    struct inst inst;
    uint32_t p = at + 1;

    read_word(m, &p, end, name, "an instrument's name");
    if (m->n_named == MML_NAMES)
        mml_bad(m, at, "more than %d instruments", (int)MML_NAMES);
    for (int i = 0; i < m->n_named; i++)
        if (strcmp(m->named[i].name, name) == 0)
            mml_bad(m, at, "the instrument \"%s\" is there twice", name);
    p = skip(m, p, end);
    const uint32_t kind_at = p;
    read_word(m, &p, end, word, "pulse, triangle, saw, sine, fm, noise, sample, or an instrument to start from");
    if (strcmp(word, "sample") == 0) {
        inst = plain;
        inst.kind = INST_SAMPLE;
        inst.sustain = 32767;
        p = skip(m, p, end);
        read_word(m, &p, end, inst.sample, "sample NAME, a sound of rom.lua that is a recording");
    } else if (!mml_find_inst(m, word, &inst)) {
        mml_bad(
            m, kind_at,
            "expected pulse, triangle, saw, sine, fm, noise, sample, or an instrument that stands above, got \"%s\"",
            word);
    }
    while ((p = skip(m, p, end)) < end) {
        const uint32_t key_at = p;
        read_word(m, &p, end, word, "a setting, as attack=5");
        if (p == end || m->text[p] != '=')
            mml_bad(m, key_at, "expected %s=a number", word);
        p++;
        read_setting(m, &inst, word, key_at, &p, end);
    }
    memcpy(m->named[m->n_named].name, name, MML_NAME);
    m->named[m->n_named++].inst = inst;
}
