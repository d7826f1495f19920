/*
 * bulletml.h - a BulletML document in a ROM, lump bulletml/NAME: a compiled program for bullets, and its arithmetic.
 *
 * Little-endian:
 *
 *   u32 magic, u32 horizontal (0 or 1), u32 tops, u32 labels, u32 numbers, u32 words, u32 steps, u32 bytes of text
 *   i64 number[numbers]    the program's constants, Q31.32
 *   u32 top[tops]          places of the top actions, which run by themselves; in the document's order
 *   u32 label[labels]      labels of fired bullets: offsets in the text of NUL-terminated strings
 *   u32 word[words]        the commands
 *   u32 step[steps]        the steps that compute values
 *   text
 *
 * A command is a word with ML_COMMAND set, which contains ML_OP, ML_TYPE and ML_LINE, followed by the operands of its
 * operation, which are words without ML_COMMAND: v is a value, p the place of a command (its index in word), n a count
 * of values, l the index of a label + 1, or 0. The first and the last command are ML_END.
 *
 * A value is the index of a constant, or ML_COMPUTED and the index of the first step that computes it; its steps run
 * up to STEP_DONE. A step contains ML_STEP and ML_ARGUMENT. In a program that passed ml_check, every place is that of a
 * command, and every value is valid and needs at most ML_STACK_SIZE numbers on the stack. ml_check does not verify that
 * repeats and calls are properly nested; the interpreter stays in bounds even if they are not.
 */
#ifndef ROM_BULLETML_H
#define ROM_BULLETML_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include "../base/bytes.h"
#include "../base/fx.h"

#define ML_MAGIC    0x314c4d42u /* "BML1" */
#define ML_COMMAND  0x80000000u
#define ML_COMPUTED 0x40000000u

enum {
    ML_HEADER_SIZE = 32, /* bytes */
    ML_STACK_SIZE = 16,  /* maximum numbers on the stack while a value is computed */
    ML_PARAMS = 9,       /* $1 to $9 */
    ML_MAX_PARAMS = 64,  /* maximum parameters that a reference can give; all are computed */
    ML_MAX_TOP_ACTIONS = 64,
    ML_MAX_LABELS = 4096,
    ML_MAX_NUMBERS = 1 << 20,
    ML_MAX_WORDS = 1 << 20,
    ML_MAX_TEXT = 1 << 20
};

/* The reference to which a direction, speed or component of an acceleration is relative. */
enum ml_type { ML_NONE, ML_AIM, ML_ABSOLUTE, ML_RELATIVE, ML_SEQUENCE, ML_TYPES };

enum ml_op {
    ML_END,                      /* no more actions */
    ML_NEXT,                     /* the bullet's next action follows; it starts in the next frame */
    ML_END_REPEAT,               /* p: end of a repeat's body, which starts at p */
    ML_RETURN,                   /* return from ML_CALL; ML_END if there is nothing to return to */
    ML_LAST_CONTROL = ML_RETURN, /* the commands up to here are not elements; they run even while a wait lasts */
    ML_WAIT,                     /* v: frames */
    ML_REPEAT,                   /* v: runs the commands up to its ML_END_REPEAT v times, at least once */
    ML_CALL,                     /* p n v..: runs p up to ML_RETURN, with the n values as $1 to $n */
    ML_TAIL_CALL,                /* p n v..: ML_CALL at the end of an action, as a tail call: does not return */
    ML_LEAVE,          /* p n v..: like ML_TAIL_CALL, but also drops all open calls and repeats; for top actions */
    ML_FIRE,           /* starts to prepare a shot: speed and direction are unset */
    ML_FIRE_REF,       /* p n v..: like ML_CALL, for a fire */
    ML_FIRE_RETURN,    /* end of a labelled fire: returns to the ML_FIRE_REF that led here, if any */
    ML_SHOT_SPEED,     /* v, with its ML_TYPE */
    ML_SHOT_DIRECTION, /* v, with its ML_TYPE */
    ML_BULLET_REF,     /* p n v..: like ML_CALL, for a bullet */
    ML_BULLET, /* l p: fires the shot; p: its actions, 0: none. Returns to the ML_BULLET_REF that led here, if any */
    ML_VANISH,
    ML_TURN,  /* v v: term, direction, with its ML_TYPE */
    ML_SPEED, /* v v: term, speed, with its ML_TYPE */
    ML_ACCEL, /* v v v: term, x, y; ML_TYPE: x's type + ML_Y_TYPE_FACTOR * y's type; ML_NONE: component absent */
    ML_OPS
};
enum { ML_Y_TYPE_FACTOR = 8 };

/* ML_OP is a command's operation, ML_TYPE its enum ml_type, ML_LINE the line of its element in the document
 * (ML_MAX_LINE: that line or a later one). */
#define ML_OP(word)   ((word)&0xff)
#define ML_TYPE(word) ((word) >> 8 & 0xff)
#define ML_LINE(word) ((word) >> 16 & 0x7fff)
enum { ML_MAX_LINE = 0x7fff };

static inline uint32_t ml_make_command(enum ml_op op, unsigned type, int line)
{
    return ML_COMMAND | (uint32_t)op | type << 8 | (uint32_t)(line > ML_MAX_LINE ? ML_MAX_LINE : line) << 16;
}

/* The steps that compute a value, on a stack. */
enum ml_step {
    STEP_DONE,
    STEP_NUMBER, /* argument: the index of a constant */
    STEP_RAND,
    STEP_RANK,
    STEP_PARAM, /* argument: 0 to 9. A missing parameter is 1; $0 is 1 without parameters, otherwise 0 */
    STEP_ADD,
    STEP_SUBTRACT,
    STEP_MULTIPLY,
    STEP_DIVIDE,
    STEP_NEGATE,
    ML_STEP_KINDS
};
#define ML_STEP(word)     ((word)&0xff)
#define ML_ARGUMENT(word) ((word) >> 8)

/* The sections of a program. */
struct ml {
    const uint8_t *number, *top_action, *label, *word, *step, *text;
    uint32_t n_top_actions, n_labels, n_numbers, n_words, n_steps, text_size;
    bool horizontal;
};

/* The operands of each operation: v, p, n and l as in the format at the top of this file; '*': n values. */
extern const char *const ml_operands[ML_OPS];

/* Returns whether data is exactly one valid program. If it is not, stores one sentence in err. */
bool ml_check(const uint8_t *data, size_t size, char *err, size_t err_size);

/* Finds the sections of a program, without checking them. Returns the size that its header implies. */
uint64_t ml_open(struct ml *m, const uint8_t *data);

static inline uint32_t ml_word(const struct ml *m, uint32_t at)
{
    return bytes_get32(m->word + 4 * (size_t)at);
}

static inline uint32_t ml_step(const struct ml *m, uint32_t at)
{
    return bytes_get32(m->step + 4 * (size_t)at);
}

static inline uint32_t ml_top_action(const struct ml *m, uint32_t i)
{
    return bytes_get32(m->top_action + 4 * (size_t)i);
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
 * Arithmetic in Q31.32. Results out of range saturate to INT64_MAX or INT64_MIN; products and quotients are rounded
 * to nearest, halves away from 0. x / 0 saturates according to the sign of x; 0 / 0 is 0.
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
    const int64_t difference = (int64_t)((uint64_t)a - (uint64_t)b);

    return ((a ^ b) & (a ^ difference)) < 0 ? (a >> 63) ^ INT64_MAX : difference;
}

/* Converts a count of frames or repeats to a whole number by truncation, except that a value at most 2^-20 short of a
 * whole number is rounded to it. INT64_MAX, the result of an overflow, becomes 0, as documents expect. */
static inline int32_t ml_to_whole(int64_t v)
{
    const int64_t tolerance = 1 << 12;

    if (v == INT64_MAX)
        return 0;
    return (int32_t)(v < 0 ? -(ml_add(ml_negate(v), tolerance) >> 32) : ml_add(v, tolerance) >> 32);
}

/* Returns a * b / 2^shift, rounded to nearest, for 1 <= shift <= 63. The result's magnitude must be below 2^63. */
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

/* Returns the next value of $rand, 0 <= value < 1, Q31.32. *state must not be 0. The generator is Marsaglia's 32-bit
 * xorshift with shifts 13, 17 and 5. */
static inline int64_t ml_rand(uint32_t *state)
{
    uint32_t s = *state;

    s ^= s << 13;
    s ^= s >> 17;
    s ^= s << 5;
    *state = s;
    return (int64_t)(s >> 8) << 8;
}

/* Directions are degrees in Q31.32, 0 <= d < 360; as in documents, 0 is up and angles grow clockwise. */
#define ML_FULL_TURN (360 * ML_ONE)

/* Returns d wrapped to 0 <= d < 360 degrees. */
static inline int64_t ml_wrap(int64_t d)
{
    if ((uint64_t)d < (uint64_t)ML_FULL_TURN)
        return d;
    if (d >= -ML_FULL_TURN && d < 2 * ML_FULL_TURN)
        return d < 0 ? d + ML_FULL_TURN : d - ML_FULL_TURN;
    d %= ML_FULL_TURN;
    return d < 0 ? d + ML_FULL_TURN : d;
}

/* ml_degrees_to_angle converts degrees, 0 <= d < 360, to the nearest angle (2^32 per turn). ml_angle_to_degrees
 * converts an angle to degrees exactly. */
static inline ang ml_degrees_to_angle(int64_t d)
{
    return (ang)(((uint64_t)d + 180) / 360);
}

static inline int64_t ml_angle_to_degrees(ang a)
{
    return (int64_t)((uint64_t)a * 360);
}

#endif
