/*
 * bulletml.h - a BulletML document as it stands in a ROM, lump bulletml/NAME: a program for bullets, and its
 * arithmetic.
 *
 * Little endian:
 *
 *   u32 magic, u32 horizontal (1: it is), u32 tops, u32 labels, u32 numbers, u32 words, u32 steps, u32 bytes of text
 *   i64 number[numbers]    Q31.32: those that the program names
 *   u32 top[tops]          where the actions begin that run by themselves, in the order of the document
 *   u32 label[labels]      of bullets that are fired: where its text begins, each ends with a NUL
 *   u32 word[words]        the commands
 *   u32 step[steps]        how values are worked out
 *   text
 *
 * A command is a word, ML_COMMAND and ML_OP and ML_TYPE and ML_LINE, and the words without ML_COMMAND that its
 * operation says: v a value, p a place, n a count of values, l a label + 1 or 0. The first and the last are ML_END. A
 * value is the index of a number, or ML_WORKED_OUT and the index of a step: those from there on, ML_STEP and
 * ML_ARGUMENT, up to STEP_DONE. Of a program that ml_check has passed every place is that of a command, and every value
 * is one, with at most ML_STACK numbers at once; that repeats and calls fit each other is the compiler's word, and what
 * runs it stays in bounds without.
 */
#ifndef ROM_BULLETML_H
#define ROM_BULLETML_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include "../base/bytes.h"
#include "../base/fx.h"

#define ML_MAGIC      0x314c4d42u /* "BML1" */
#define ML_COMMAND    0x80000000u
#define ML_WORKED_OUT 0x40000000u

enum {
    ML_HEADER = 32,      /* bytes */
    ML_STACK = 16,       /* numbers that a value takes at once */
    ML_PARAMS = 9,       /* $1 to $9 */
    ML_MOST_PARAMS = 64, /* that a reference may give: all are worked out */
    ML_MAX_TOPS = 64,
    ML_MAX_LABELS = 4096,
    ML_MAX_NUMBERS = 1 << 20,
    ML_MAX_WORDS = 1 << 20,
    ML_MAX_TEXT = 1 << 20
};

/* How a direction, speed or component is meant. */
enum ml_type { ML_NONE, ML_AIM, ML_ABSOLUTE, ML_RELATIVE, ML_SEQUENCE, ML_TYPES };

enum ml_op {
    ML_END,              /* no more actions */
    ML_NEXT,             /* a bullet's next action follows, and begins in the next frame */
    ML_AGAIN,            /* p: the end of a repeat's body */
    ML_RETURN,           /* with nothing to go back to it is ML_END */
    ML_ENDS = ML_RETURN, /* up to this one no command is an element: they are done with the element before them */
    ML_WAIT,             /* v */
    ML_REPEAT,           /* v: what follows is done so often, up to its ML_AGAIN; at least once */
    ML_CALL,             /* p n v..: n values are $1 to $n there, up to ML_RETURN */
    ML_GO,               /* p n v..: the same, at the end of an action: nothing is left to come back to */
    ML_LEAVE,            /* p n v..: the same, and nothing that was begun is gone back to: of an action that is a top */
    ML_FIRE,             /* a shot is prepared: neither speed nor direction are set */
    ML_FIRE_REF,         /* p n v..: as ML_CALL, of a fire */
    ML_FIRED,            /* the end of a fire that has a label: back to where ML_FIRE_REF stood, if one led here */
    ML_SHOT_SPEED,       /* v, ML_TYPE of it */
    ML_SHOT_DIRECTION,   /* v, ML_TYPE of it */
    ML_BULLET_REF,       /* p n v..: as ML_CALL, of a bullet */
    ML_BULLET, /* l p: it is fired; p where its actions begin, 0: it has none. After it what followed ML_BULLET_REF */
    ML_VANISH,
    ML_TURN,  /* v v: term, direction, ML_TYPE of it */
    ML_SPEED, /* v v: term, speed, ML_TYPE of it */
    ML_ACCEL, /* v v v: term, x, y; ML_TYPE: that of x, and ML_TYPE_Y times that of y; ML_NONE: no such part */
    ML_OPS
};
enum { ML_TYPE_Y = 8 };

/* Of a command: its operation, its type, and the line of its element (ML_LINES: that one or a later one). */
#define ML_OP(word)   ((word)&0xff)
#define ML_TYPE(word) ((word) >> 8 & 0xff)
#define ML_LINE(word) ((word) >> 16 & 0x7fff)
enum { ML_LINES = 0x7fff };

static inline uint32_t ml_command(enum ml_op op, unsigned type, int line)
{
    return ML_COMMAND | (uint32_t)op | type << 8 | (uint32_t)(line > ML_LINES ? ML_LINES : line) << 16;
}

/* The steps of a value. */
enum ml_step {
    STEP_DONE,
    STEP_NUMBER, /* argument: the index of a number */
    STEP_RAND,
    STEP_RANK,
    STEP_PARAM, /* argument: 0 to 9; $0, and what was not given, is 1; $0 is 0 where any was given */
    STEP_ADD,
    STEP_SUBTRACT,
    STEP_MULTIPLY,
    STEP_DIVIDE,
    STEP_NEGATE,
    ML_STEP_KINDS
};
#define ML_STEP(word)     ((word)&0xff)
#define ML_ARGUMENT(word) ((word) >> 8)

/* Where the pieces of a program are. */
struct ml {
    const uint8_t *number, *top, *label, *word, *step, *text;
    uint32_t tops, labels, numbers, words, steps, bytes;
    bool horizontal;
};

/* The words behind a command: v, p, n and l as above, '*' n values. */
extern const char *const ml_operands[ML_OPS];

/* Is that a program, to the last byte? False and one sentence else. */
bool ml_check(const uint8_t *data, size_t size, char *err, size_t err_size);

/* Of a program that was checked. */
void ml_open(struct ml *m, const uint8_t *data);

static inline uint32_t ml_word(const struct ml *m, uint32_t at)
{
    return bytes_get32(m->word + 4 * (size_t)at);
}

static inline uint32_t ml_step(const struct ml *m, uint32_t at)
{
    return bytes_get32(m->step + 4 * (size_t)at);
}

static inline uint32_t ml_top(const struct ml *m, uint32_t i)
{
    return bytes_get32(m->top + 4 * (size_t)i);
}

static inline int64_t ml_number(const struct ml *m, uint32_t at)
{
    return (int64_t)bytes_get64(m->number + 8 * (size_t)at);
}

static inline const char *ml_label(const struct ml *m, uint32_t at)
{
    return (const char *)m->text + bytes_get32(m->label + 4 * (size_t)at);
}

/*
 * Arithmetic in Q31.32. Sums and products that do not fit are the greatest or least number there is; products and
 * quotients are rounded to the nearest, halves away from 0. x / 0 is the greatest or least number by the sign of x, and
 * 0 / 0 is 0.
 */
#define ML_ONE ((int64_t)1 << 32)

int64_t ml_multiply(int64_t a, int64_t b);
int64_t ml_divide(int64_t a, int64_t b);

static inline int64_t ml_add(int64_t a, int64_t b)
{
    const int64_t sum = (int64_t)((uint64_t)a + (uint64_t)b);

    return ((a ^ sum) & (b ^ sum)) < 0 ? (a >> 63) ^ INT64_MAX : sum;
}

static inline int64_t ml_negate(int64_t a)
{
    return a == INT64_MIN ? INT64_MAX : -a;
}

static inline int64_t ml_subtract(int64_t a, int64_t b)
{
    const int64_t less = (int64_t)((uint64_t)a - (uint64_t)b);

    return ((a ^ b) & (a ^ less)) < 0 ? (a >> 63) ^ INT64_MAX : less;
}

/* A count of frames or rounds: cut to a whole number, and what is below one by less than 2^-20 is one. What is too
 * large for a number of documents counts as none, as it does there. */
static inline int32_t ml_whole(int64_t v)
{
    const int64_t hair = 1 << 12;

    if (v == INT64_MAX)
        return 0;
    return (int32_t)(v < 0 ? -(ml_add(ml_negate(v), hair) >> 32) : ml_add(v, hair) >> 32);
}

/* a * b / 2^shift, to the nearest, |it| < 2^63, 1 <= shift <= 63. */
static inline int64_t ml_scale(int64_t a, int64_t b, int shift)
{
#if defined(__SIZEOF_INT128__) && !defined(FX_NO_INT128)
    return (int64_t)((__extension__(__int128) a * b + ((int64_t)1 << (shift - 1))) >> shift);
#else
    /* two's complement: the high half of the unsigned product is too large by b where a < 0, and by a where b < 0 */
    const uint64_t low = (uint64_t)a * (uint64_t)b, sum = low + ((uint64_t)1 << (shift - 1));
    const uint64_t high =
        fx_mul_high((uint64_t)a, (uint64_t)b) - (a < 0 ? (uint64_t)b : 0) - (b < 0 ? (uint64_t)a : 0) + (sum < low);

    return (int64_t)(high << (64 - shift) | sum >> shift);
#endif
}

/* The next of the stream that $rand draws from, 0 <= it < 1; *state is never 0. Marsaglia's xorshift, 13 17 5. */
static inline int64_t ml_rand(uint32_t *state)
{
    uint32_t s = *state;

    s ^= s << 13;
    s ^= s >> 17;
    s ^= s << 5;
    *state = s;
    return (int64_t)(s >> 8) << 8;
}

/* Directions are degrees in Q31.32, from 0 up to and without 360 (a turn as documents write it: 0 up, clockwise). */
#define ML_TURN_ROUND (360 * ML_ONE)

/* Brought into that range. */
static inline int64_t ml_wrap(int64_t d)
{
    if ((uint64_t)d < (uint64_t)ML_TURN_ROUND)
        return d;
    if (d >= -ML_TURN_ROUND && d < 2 * ML_TURN_ROUND)
        return d < 0 ? d + ML_TURN_ROUND : d - ML_TURN_ROUND;
    d %= ML_TURN_ROUND;
    return d < 0 ? d + ML_TURN_ROUND : d;
}

/* The nearest angle (2^32 a turn) of degrees in that range; and degrees of an angle, exactly. */
static inline ang ml_angle(int64_t d)
{
    return (ang)(((uint64_t)d + 180) / 360);
}

static inline int64_t ml_degrees(ang a)
{
    return (int64_t)((uint64_t)a * 360);
}

#endif
