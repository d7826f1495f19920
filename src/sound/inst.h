/*
 * inst.h - instruments: what makes a note's wave, and what bends its level, pitch and place in time.
 *
 * In a tune an instrument is INST_BYTES bytes, little-endian, INST_OP bytes for each operator at their end. Its curves
 * and its wave are elsewhere in the tune, so many bytes behind its own first one; 0: it has none.
 *
 * A curve: u8 values, 1 to CURVE_MOST; u8 the one to go on from behind the last, or CURVE_STAYS; u16 frames from one to
 * the next; i16 each. Between two values it is a straight line.
 *
 * A wave: u8 versions, 1 to WAVE_VERSIONS; a zero byte; then each, i16, INST_WAVE_LONG(v) of them and the first again.
 * Version v has the harmonics that snd_tables has in its own.
 */
#ifndef SOUND_INST_H
#define SOUND_INST_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include "../base/bytes.h"
#include "pitch.h"

enum {
    INST_NAME = 32, /* of a sample, with its NUL */
    INST_BYTES = 212,
    INST_WAVE_AT = 48, /* where it says where its wave is, and its curves of volume, pitch and place */
    INST_CURVES_AT = 52,
    INST_OPS = 116, /* where operators begin */
    INST_OP = 24,
    FM_OPS = 4,
    FM_ALGORITHMS = 8,
    FM_FEEDBACK = 6144, /* 1.5 radians, the most */
    FM_DEEPEST = 15646, /* 24 radians in 4096ths of a turn */
    CURVE_MOST = 64,
    CURVE_STAYS = 255,
    CURVE_FRAMES = 3600,
    ARPEGGIO_MOST = 16,
    WAVE_VERSIONS = 10, /* 32 harmonics */
    WAVE_HARMONICS = 32
};

enum inst_kind {
    INST_PULSE,
    INST_TRIANGLE,
    INST_SAW,
    INST_SINE,
    INST_FM, /* of two operators, of which the first bends the second */
    INST_NOISE,
    INST_SAMPLE,
    INST_FM4,
    INST_WAVE,
    INST_KINDS
};

/* Times are in samples. A level that falls halves in that time; 0: it does not fall. */
struct env {
    uint16_t sustain;                      /* of 32767 */
    uint32_t attack, decay, fade, release; /* from silence, to sustain, on from there, when it is let go */
};

/* A slow wave: its depth is in the unit of what it bends; 2^-32 turns a sample; samples until it begins. */
struct lfo {
    uint16_t depth;
    uint32_t step, delay;
};

struct inst {
    uint8_t kind, algorithm;
    uint16_t duty;     /* of 65536: how long a pulse is high */
    uint16_t feedback; /* of the first operator, 4096ths of a radian */
    struct env env;
    struct lfo vibrato, tremolo; /* 256ths of a semitone; of 32767 */
    int32_t root;                /* pitch at which a sample is as recorded, 65536ths of a semitone */
    uint32_t wave, volume_curve, pitch_curve, pan_curve;
    uint16_t arpeggio_frames; /* from one of its pitches to the next */
    uint8_t arpeggio_n;       /* 0: it has none */
    const uint8_t *arpeggio;  /* semitones, as int8_t */
};

/* An operator: ratio to the note's pitch in 256ths, and so much faster, 2^-32 turns a sample. level: of 32767, if it is
 * heard; how far it bends others, 4096ths of a turn. env: fade is 0; release 0: it stays as it is when let go. */
struct op {
    uint16_t ratio, level;
    int32_t detune;
    struct env env;
};

static inline struct lfo inst_lfo(const uint8_t *depth, const uint8_t *times)
{
    return (struct lfo){ bytes_get16(depth), bytes_get32(times), bytes_get32(times + 4) };
}

/* From the bytes of a tune. Inline, so that who needs three fields reads three. */
static inline struct inst inst_of(const uint8_t *p)
{
    return (struct inst){ .kind = p[0],
                          .algorithm = p[1],
                          .duty = bytes_get16(p + 2),
                          .feedback = bytes_get16(p + 6),
                          .env = { bytes_get16(p + 4), bytes_get32(p + 8), bytes_get32(p + 12), bytes_get32(p + 16),
                                   bytes_get32(p + 20) },
                          .vibrato = inst_lfo(p + 32, p + 24),
                          .tremolo = inst_lfo(p + 34, p + 36),
                          .root = (int32_t)bytes_get32(p + 44),
                          .wave = bytes_get32(p + 48),
                          .volume_curve = bytes_get32(p + 52),
                          .pitch_curve = bytes_get32(p + 56),
                          .pan_curve = bytes_get32(p + 60),
                          .arpeggio_frames = bytes_get16(p + 64),
                          .arpeggio_n = p[66],
                          .arpeggio = p + 68 };
}

struct op inst_op(const uint8_t *bytes, int k);

/* The recording's name: a sound of rom.lua; "": the tune's own. */
static inline const char *inst_sample(const uint8_t *bytes)
{
    return (const char *)bytes + 84;
}

void inst_write(uint8_t bytes[INST_BYTES], const struct inst *i, const struct op ops[FM_OPS], const char *sample);

/* Operators of a kind: 0, 2 or 4. */
static inline int inst_ops(int kind)
{
    return kind == INST_FM4 ? 4 : kind == INST_FM ? 2 : 0;
}

/* Which operators are heard (bit k), and which ones operator k bends. */
unsigned inst_heard(int ops, int algorithm);
unsigned inst_bends(int ops, int algorithm, int k);

/* A curve's bytes. */
static inline size_t inst_curve_size(const uint8_t *curve)
{
    return 4 + 2 * (size_t)curve[0];
}

/* Its value at an age in samples. */
int32_t inst_curve(const uint8_t *curve, int32_t age);

/* Has it a corner between two ages? */
bool inst_curve_corner(const uint8_t *curve, int32_t from, int32_t to);

/* The length of version v of a wave, a power of two; where it begins in the wave; the bytes of a wave of n versions. */
enum { WAVE_SHORTEST = 8 /* bits: 256 of one harmonic */ };
int inst_wave_bits(int version);
size_t inst_wave_at(int version);
static inline size_t inst_wave_size(int versions)
{
    return inst_wave_at(versions);
}

/* Are all fields in range? end: bytes from the instrument's first one to where its curves and its wave may end;
 * own_sample: its tune has one. */
bool inst_ok(const uint8_t *bytes, size_t end, bool own_sample);

#endif
