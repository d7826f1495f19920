/*
 * fm.h - FM notes: operators, which are sines that modulate each other's phase, each with its own envelope.
 *
 * A block depends only on phases and gains, not on earlier samples. This includes feedback: y = sin(p + b y) is looked
 * up in a table, in which b selects the row and p the column. FM chips compute y from the last two samples instead; at
 * higher notes, their feedback sounds like a smaller b (fm_equivalent_feedback).
 */
#ifndef SOUND_FM_H
#define SOUND_FM_H

#include "wave.h"

enum { FM_BLOCK = SND_BLOCK };

/* An operator during a block. phase: at the block's first sample; step: phase per sample, both in 2^-32 turns. gain:
 * Q15; for a modulator, in units of 2^(scale - 2) turns. */
struct fm_op {
    uint32_t phase, step;
    int scale; /* 0 to 4 */
    int16_t gain[FM_BLOCK];
};

/* Computes a block of a note with `ops` operators, 2 or 4. feedback: the first operator's feedback at the start and end
 * of the block, FEEDBACK_ROW_UNITS units per row of the feedback table; 0: none. */
void fm_compute_block(const struct snd_tables *t, int ops, int algorithm, const struct fm_op *op,
                      const int32_t feedback[2], int16_t out[FM_BLOCK]);

/* Computes the sines, Q15, of phases in 2^-32 turns, to within two units. The lower 16 bits of a phase are ignored.
 * fm_sines_portable gives the same results without processor-specific instructions. */
void fm_sines(const uint32_t phase[FM_BLOCK], int16_t out[FM_BLOCK]);
void fm_sines_portable(const uint32_t phase[FM_BLOCK], int16_t out[FM_BLOCK]);

/* Returns the feedback, FEEDBACK_ROW_UNITS units per row of the feedback table, that sounds like an FM chip's feedback
 * of b (4096ths of a radian) at a phase step of `step` (2^-56 turns per sample). */
int32_t fm_equivalent_feedback(int32_t b, uint64_t step);

/* State of an FM note that is computed block by block. */
struct fm_note {
    int n_ops, algorithm,
        level_age; /* level_age: the age for which `level` was computed, which is the end of the last block */
    int32_t feedback;
    struct op op[FM_OPS];
    int32_t level[FM_OPS]; /* envelope levels at age `level_age`, Q15 */
};
void fm_begin(struct fm_note *f, const struct inst *inst, const uint8_t *bytes);

/* Computes the block that starts at `age` and `phase` (units as in struct wave_params). off: the age at which the note
 * is released. */
void fm_compute_note_block(struct fm_note *f, const struct snd_tables *t, int32_t age, int32_t off, uint64_t phase,
                           uint64_t step, int16_t out[FM_BLOCK]);

#endif
