/*
 * inst.c - see inst.h. The algorithms are those of four-operator FM chips; each operator has a bit set of the operators
 * that it modulates.
 */
#include "inst.h"

#include <string.h>

/* ---- reading and writing ---- */

struct op inst_read_op(const uint8_t *bytes, int k)
{
    const uint8_t *p = bytes + INST_OPS_AT + INST_OP_BYTES * (size_t)k;

    return (struct op){ .ratio = bytes_get16(p),
                        .level = bytes_get16(p + 2),
                        .detune = (int32_t)bytes_get32(p + 4),
                        .env = { .sustain = bytes_get16(p + 16),
                                 .attack = bytes_get32(p + 8),
                                 .decay = bytes_get32(p + 12),
                                 .release = bytes_get32(p + 20) } };
}

static void write_op(uint8_t *p, const struct op *o)
{
    bytes_put16(p, o->ratio);
    bytes_put16(p + 2, o->level);
    bytes_put32(p + 4, (uint32_t)o->detune);
    bytes_put32(p + 8, o->env.attack);
    bytes_put32(p + 12, o->env.decay);
    bytes_put16(p + 16, o->env.sustain);
    bytes_put32(p + 20, o->env.release);
}

static void write_lfo(uint8_t *depth, uint8_t *times, const struct lfo *l)
{
    bytes_put16(depth, l->depth);
    bytes_put32(times, l->step);
    bytes_put32(times + 4, l->delay);
}

void inst_write(uint8_t p[INST_BYTES], const struct inst *i, const struct op ops[FM_OPS], const char *sample)
{
    const uint32_t times[] = { i->env.attack, i->env.decay, i->env.fade, i->env.release },
                   offsets[] = { (uint32_t)i->root, i->wave, i->volume_curve, i->pitch_curve, i->pan_curve };

    memset(p, 0, INST_BYTES);
    p[0] = i->kind;
    p[1] = i->algorithm;
    bytes_put16(p + 2, i->duty);
    bytes_put16(p + 4, i->env.sustain);
    bytes_put16(p + 6, i->feedback);
    for (int k = 0; k < 4; k++)
        bytes_put32(p + 8 + 4 * k, times[k]);
    write_lfo(p + 32, p + 24, &i->vibrato);
    write_lfo(p + 34, p + 36, &i->tremolo);
    for (int k = 0; k < 5; k++)
        bytes_put32(p + 44 + 4 * k, offsets[k]);
    bytes_put16(p + 64, i->arpeggio_frames);
    p[66] = i->arpeggio_count;
    for (int k = 0; k < i->arpeggio_count; k++)
        p[68 + k] = i->arpeggio[k];
    for (int k = 0; k < INST_NAME_SIZE - 1 && sample[k]; k++)
        p[84 + k] = (uint8_t)sample[k];
    for (int k = 0; k < inst_op_count(i->kind); k++)
        write_op(p + INST_OPS_AT + INST_OP_BYTES * k, &ops[k]);
}

/* ---- operators ---- */

static const uint8_t audible_ops[FM_ALGORITHMS] = { 8, 8, 8, 8, 10, 14, 14, 15 };
static const uint8_t modulated_ops[FM_ALGORITHMS][FM_OPS] = {
    { 2, 4, 8, 0 },  /* 1 modulates 2, which modulates 3, which modulates 4 */
    { 4, 4, 8, 0 },  /* 1 and 2 modulate 3, which modulates 4 */
    { 8, 4, 8, 0 },  /* 2 modulates 3; 1 and 3 modulate 4 */
    { 2, 8, 8, 0 },  /* 1 modulates 2; 2 and 3 modulate 4 */
    { 2, 0, 8, 0 },  /* 1 modulates 2, 3 modulates 4 */
    { 14, 0, 0, 0 }, /* 1 modulates 2, 3 and 4 */
    { 2, 0, 0, 0 },  /* 1 modulates 2; 3 and 4 are unmodulated */
    { 0, 0, 0, 0 },  /* no modulation */
};

unsigned inst_audible_ops(int ops, int algorithm)
{
    return ops == 2 ? 2 : audible_ops[algorithm];
}

unsigned inst_modulated_ops(int ops, int algorithm, int k)
{
    return ops == 2 ? (k == 0 ? 2 : 0) : modulated_ops[algorithm][k];
}

/* ---- curves and waves ---- */

static int32_t curve_value(const uint8_t *curve, uint32_t k)
{
    const uint32_t n = curve[0], loop = curve[1];

    if (k >= n)
        k = loop == CURVE_NO_LOOP ? n - 1 : loop + (k - loop) % (n - loop);
    return (int16_t)bytes_get16(curve + 4 + 2 * k);
}

int32_t inst_curve_value(const uint8_t *curve, int32_t age)
{
    const uint32_t t = age > 0 ? (uint32_t)age : 0, span = (uint32_t)bytes_get16(curve + 2) * SND_FRAME, k = t / span;
    const int32_t v = curve_value(curve, k), next = curve_value(curve, k + 1);

    return v + (int32_t)((int64_t)(next - v) * (t - k * span) / span);
}

bool inst_curve_has_corner(const uint8_t *curve, int32_t from, int32_t to)
{
    const int32_t span = bytes_get16(curve + 2) * SND_FRAME;

    return to > 0 && (from < 0 || from / span != (to - 1) / span);
}

/* A period of the highest harmonic has at least 128 samples, so the error of linear interpolation is below -84 dB. */
int inst_wave_bits(int version)
{
    static const uint8_t bits[WAVE_MAX_VERSIONS] = { 8, 8, 9, 9, 10, 10, 11, 11, 12, 12 };

    return bits[version];
}

size_t inst_wave_offset(int version)
{
    size_t at = 2;

    for (int v = 0; v < version; v++)
        at += 2 * (((size_t)1 << inst_wave_bits(v)) + 1);
    return at;
}

/* ---- checks ---- */

enum { MAX_TIME = 1 << 24 };

static bool env_ok(const struct env *e)
{
    return e->sustain <= 32767 && e->attack <= MAX_TIME && e->decay <= MAX_TIME && e->fade <= MAX_TIME &&
           e->release <= MAX_TIME;
}

static bool curve_ok(const uint8_t *p, uint32_t at, size_t end, int lo, int hi)
{
    if (at == 0)
        return true;
    if (at < INST_BYTES || end < 6 || at > end - 6 || p[at] < 1 || p[at] > CURVE_MAX_VALUES ||
        inst_curve_size(p + at) > end - at || (p[at + 1] >= p[at] && p[at + 1] != CURVE_NO_LOOP))
        return false;
    for (int k = 0; k < p[at]; k++) {
        const int v = (int16_t)bytes_get16(p + at + 4 + 2 * k);
        if (v < lo || v > hi)
            return false;
    }
    return bytes_get16(p + at + 2) >= 1 && bytes_get16(p + at + 2) <= CURVE_MAX_FRAMES;
}

static bool wave_ok(const uint8_t *p, const struct inst *i, size_t end)
{
    if (i->kind != INST_WAVE)
        return i->wave == 0;
    return i->wave >= INST_BYTES && end >= 2 && i->wave <= end - 2 && p[i->wave] >= 1 &&
           p[i->wave] <= WAVE_MAX_VERSIONS && p[i->wave + 1] == 0 && inst_wave_offset(p[i->wave]) <= end - i->wave;
}

static bool ops_ok(const uint8_t *p, const struct inst *i)
{
    const int n = inst_op_count(i->kind);
    uint32_t total_level = 0;

    for (int k = 0; k < n; k++) {
        const struct op o = inst_read_op(p, k);
        const bool is_audible = inst_audible_ops(n, i->algorithm) >> k & 1;
        total_level += is_audible ? o.level : 0;
        if (!env_ok(&o.env) || o.level > (is_audible ? 32767 : FM_MAX_MODULATION))
            return false;
    }
    return total_level <= 32767;
}

static bool round_trips(const uint8_t *p, const struct inst *i)
{
    struct op ops[FM_OPS];
    uint8_t encoded[INST_BYTES];

    for (int k = 0; k < FM_OPS; k++)
        ops[k] = inst_read_op(p, k);
    inst_write(encoded, i, ops, inst_sample_name(p));
    return memcmp(encoded, p, INST_BYTES) == 0;
}

bool inst_is_valid(const uint8_t *p, size_t end, bool has_own_sample)
{
    const struct inst i = inst_read(p);

    if (i.kind >= INST_KINDS || i.algorithm >= FM_ALGORITHMS || i.arpeggio_count > ARPEGGIO_MAX_NOTES ||
        memchr(inst_sample_name(p), 0, INST_NAME_SIZE) == NULL || !round_trips(p, &i) || !env_ok(&i.env))
        return false;
    if (i.kind == INST_SAMPLE && !inst_sample_name(p)[0] && !has_own_sample)
        return false;
    if (i.arpeggio_count && (i.arpeggio_frames < 1 || i.arpeggio_frames > CURVE_MAX_FRAMES))
        return false;
    return i.root >= 0 && i.root <= PITCH_MAX && i.vibrato.depth <= 24 * 256 && i.vibrato.delay <= MAX_TIME &&
           i.tremolo.depth <= 32767 && i.tremolo.delay <= MAX_TIME && i.feedback <= FM_MAX_FEEDBACK &&
           curve_ok(p, i.volume_curve, end, 0, 32767) && curve_ok(p, i.pitch_curve, end, -48 * 256, 48 * 256) &&
           curve_ok(p, i.pan_curve, end, -128, 128) && wave_ok(p, &i, end) && ops_ok(p, &i);
}
