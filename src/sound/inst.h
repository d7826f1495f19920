/*
 * inst.h - instruments: the source of a note's wave, and how its level, pitch and pan change over time.
 *
 * In a tune, an instrument is INST_BYTES bytes, little-endian; the operators, INST_OP_BYTES bytes each, are at its end.
 * Its curves and its wave are elsewhere in the tune; their places are byte offsets from the instrument's first byte, 0:
 * none.
 *
 * A curve: u8 number of values, 1 to CURVE_MAX_VALUES; u8 index of the value that follows the last one, or
 * CURVE_NO_LOOP; u16 frames from one value to the next; then the values, i16 each. Values are interpolated linearly.
 *
 * A wave: u8 number of versions, 1 to WAVE_MAX_VERSIONS; a zero byte; then the versions. Version v is
 * 2^inst_wave_bits(v) samples, i16 each, followed by a copy of its first sample; it has as many harmonics as version v
 * in snd_tables.
 */
#ifndef SOUND_INST_H
#define SOUND_INST_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include "../base/bytes.h"
#include "pitch.h"

enum {
    INST_NAME_SIZE = 32, /* bytes of a sample's name, with its NUL */
    INST_BYTES = 212,
    INST_WAVE_AT = 48,   /* offset of the field with the wave's offset */
    INST_CURVES_AT = 52, /* offset of the fields with the offsets of the curves: volume, pitch, pan */
    INST_OPS_AT = 116,   /* offset of the operators */
    INST_OP_BYTES = 24,
    FM_OPS = 4,
    FM_ALGORITHMS = 8,
    FM_MAX_FEEDBACK = 6144,    /* maximum: 1.5 radians, in 4096ths of a radian */
    FM_MAX_MODULATION = 15646, /* maximum modulation: 24 radians, in 4096ths of a turn */
    CURVE_MAX_VALUES = 64,
    CURVE_NO_LOOP = 255,
    CURVE_MAX_FRAMES = 3600,
    ARPEGGIO_MAX_NOTES = 16,
    WAVE_MAX_VERSIONS = 10, /* the last one has 32 harmonics */
    WAVE_MAX_HARMONICS = 32
};

enum inst_kind {
    INST_PULSE,
    INST_TRIANGLE,
    INST_SAW,
    INST_SINE,
    INST_FM, /* two operators; the first modulates the second */
    INST_NOISE,
    INST_SAMPLE,
    INST_FM4,
    INST_WAVE,
    INST_KINDS
};

/* An envelope. Times are in samples: attack is the length of a linear rise, the other times are half-lives of the
 * level. decay 0 or fade 0: the level does not fall; release 0: the shortest release (wave.c). */
struct env {
    uint16_t sustain;                      /* sustain level, 0 to 32767 */
    uint32_t attack, decay, fade, release; /* rise from silence, fall to sustain, fall after that, fall once released */
};

/* A low-frequency oscillator. depth: in the unit of the value that it modulates; step: 2^-32 turns per sample;
 * delay: samples until it starts. */
struct lfo {
    uint16_t depth;
    uint32_t step, delay;
};

struct inst {
    uint8_t kind, algorithm;
    uint16_t duty;     /* fraction of a pulse's period that is high, of 65536 */
    uint16_t feedback; /* of the first operator, in 4096ths of a radian */
    struct env env;
    struct lfo vibrato, tremolo; /* depth of vibrato: 256ths of a semitone; of tremolo: of 32767 */
    int32_t root;                /* pitch at which a sample plays as recorded, 65536ths of a semitone */
    uint32_t wave, volume_curve, pitch_curve, pan_curve; /* places; 0: none */
    uint16_t arpeggio_frames;                            /* frames per pitch */
    uint8_t arpeggio_count;                              /* number of pitches; 0: no arpeggio */
    const uint8_t *arpeggio;                             /* semitones, as int8_t */
};

/* An operator. ratio: frequency relative to the note's, in 256ths; detune: added to the phase step, 2^-32 turns per
 * sample. level: of 32767 if the operator is audible; otherwise its modulation depth, 4096ths of a turn. env: fade is
 * 0; release 0: the operator ignores the note's release. */
struct op {
    uint16_t ratio, level;
    int32_t detune;
    struct env env;
};

static inline struct lfo inst_read_lfo(const uint8_t *depth, const uint8_t *times)
{
    return (struct lfo){ bytes_get16(depth), bytes_get32(times), bytes_get32(times + 4) };
}

/* Reads an instrument from a tune's bytes. Inline, so that a caller that needs three fields reads only those three. */
static inline struct inst inst_read(const uint8_t *p)
{
    return (struct inst){ .kind = p[0],
                          .algorithm = p[1],
                          .duty = bytes_get16(p + 2),
                          .feedback = bytes_get16(p + 6),
                          .env = { bytes_get16(p + 4), bytes_get32(p + 8), bytes_get32(p + 12), bytes_get32(p + 16),
                                   bytes_get32(p + 20) },
                          .vibrato = inst_read_lfo(p + 32, p + 24),
                          .tremolo = inst_read_lfo(p + 34, p + 36),
                          .root = (int32_t)bytes_get32(p + 44),
                          .wave = bytes_get32(p + 48),
                          .volume_curve = bytes_get32(p + 52),
                          .pitch_curve = bytes_get32(p + 56),
                          .pan_curve = bytes_get32(p + 60),
                          .arpeggio_frames = bytes_get16(p + 64),
                          .arpeggio_count = p[66],
                          .arpeggio = p + 68 };
}

struct op inst_read_op(const uint8_t *bytes, int k);

/* Returns the name of the sound in rom.lua whose recording the instrument plays; "": the tune's own recording. */
static inline const char *inst_sample_name(const uint8_t *bytes)
{
    return (const char *)bytes + 84;
}

void inst_write(uint8_t bytes[INST_BYTES], const struct inst *i, const struct op ops[FM_OPS], const char *sample);

/* Returns the number of operators of an instrument of that kind: 0, 2 or 4. */
static inline int inst_op_count(int kind)
{
    return kind == INST_FM4 ? 4 : kind == INST_FM ? 2 : 0;
}

/* inst_audible_ops returns the set of audible operators, inst_modulated_ops the set of operators that operator k
 * modulates. Bit i of a set is operator i. */
unsigned inst_audible_ops(int ops, int algorithm);
unsigned inst_modulated_ops(int ops, int algorithm, int k);

/* Returns the size of a curve in bytes. */
static inline size_t inst_curve_size(const uint8_t *curve)
{
    return 4 + 2 * (size_t)curve[0];
}

/* Returns a curve's value at an age in samples. */
int32_t inst_curve_value(const uint8_t *curve, int32_t age);

/* Returns whether a curve's slope can change between two ages. */
bool inst_curve_has_corner(const uint8_t *curve, int32_t from, int32_t to);

/* inst_wave_bits returns the binary logarithm of the number of samples in a version of a wave; inst_wave_offset the
 * version's byte offset in the wave, which is also the size of a wave of the versions before it. */
enum { WAVE_MIN_BITS = 8 /* minimum bits: 256 samples */ };
int inst_wave_bits(int version);
size_t inst_wave_offset(int version);

/* Returns whether all fields are in range. end: bytes from the instrument's first byte to the end of the area that can
 * contain its curves and its wave; has_own_sample: whether the tune is a recording. */
bool inst_is_valid(const uint8_t *bytes, size_t end, bool has_own_sample);

#endif
