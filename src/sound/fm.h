/*
 * fm.h - notes of FM: sines, operators, that bend each other's phase, each with an envelope of its own.
 *
 * A block is a function of phases and gains. So is feedback: y = sin(p + b y) is a row of a table, p its place, b the
 * row; chips take y from the last two samples, which at higher notes is as if b were less (fm_strength).
 */
#ifndef SOUND_FM_H
#define SOUND_FM_H

#include "wave.h"

enum { FM_BLOCK = SND_BLOCK };

/* phase: of the block's first sample, step: from one to the next, 2^-32 turns. gain: of one that is heard Q15; of one
 * that bends others, of 2^(scale - 2) turns, Q15. */
struct fm_op {
    uint32_t phase, step;
    int scale; /* 0 to 4 */
    int16_t gain[FM_BLOCK];
};

/* ops: 2 or 4. rows: of the first operator's feedback at the block's beginning and end, FEEDBACK_ROW a row; 0: none. */
void fm_block(const struct snd_tables *t, int ops, int algorithm, const struct fm_op *op, const int32_t rows[2],
              int16_t out[FM_BLOCK]);

/* The sine of 2^-16 turns; good to two units. The second is the first without instructions of one processor. */
void fm_sines(const uint32_t phase[FM_BLOCK], int16_t out[FM_BLOCK]);
void fm_sines_plain(const uint32_t phase[FM_BLOCK], int16_t out[FM_BLOCK]);

/* The row, FEEDBACK_ROW each, that at so many 2^-56 turns a sample is as a chip's feedback of b 4096ths of a radian. */
int32_t fm_strength(int32_t b, uint64_t step);

/* A note of FM, block by block. */
struct fm_note {
    int ops, algorithm, at; /* at: the age of what is kept of the last block's end */
    int32_t feedback;
    struct op op[FM_OPS];
    int32_t level[FM_OPS]; /* at that age, Q15 */
};
void fm_begin(struct fm_note *f, const struct inst *inst, const uint8_t *bytes);

/* The block that begins at that age and phase (wave_at); the note was let go at age `off`. */
void fm_play(struct fm_note *f, const struct snd_tables *t, int32_t age, int32_t off, uint64_t phase, uint64_t step,
             int16_t out[FM_BLOCK]);

#endif
