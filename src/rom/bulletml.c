/*
 * bulletml.c - see bulletml.h. Only the first word of a command has ML_COMMAND set, so the word at a place shows
 * whether a command starts there. The steps of a value start at step 0 or after a STEP_DONE.
 */
#include "bulletml.h"
#include <inttypes.h>
#include "../base/err.h"

const char *const ml_operands[ML_OPS] = {
    [ML_END] = "",           [ML_NEXT] = "",
    [ML_WAIT] = "v",         [ML_REPEAT] = "v",
    [ML_END_REPEAT] = "p",   [ML_CALL] = "pn*",
    [ML_TAIL_CALL] = "pn*",  [ML_LEAVE] = "pn*",
    [ML_RETURN] = "",        [ML_FIRE] = "",
    [ML_FIRE_REF] = "pn*",   [ML_FIRE_RETURN] = "",
    [ML_SHOT_SPEED] = "v",   [ML_SHOT_DIRECTION] = "v",
    [ML_BULLET_REF] = "pn*", [ML_BULLET] = "lp",
    [ML_VANISH] = "",        [ML_TURN] = "vv",
    [ML_SPEED] = "vv",       [ML_ACCEL] = "vvv",
};

uint64_t ml_open(struct ml *m, const uint8_t *data)
{
    const uint64_t counts[] = { bytes_get32(data + 8),  bytes_get32(data + 12), bytes_get32(data + 16),
                                bytes_get32(data + 20), bytes_get32(data + 24), bytes_get32(data + 28) };
    const uint64_t number = ML_HEADER_SIZE, top = number + 8 * counts[2], label = top + 4 * counts[0],
                   word = label + 4 * counts[1], step = word + 4 * counts[3], text = step + 4 * counts[4];

    *m = (struct ml){ .n_top_actions = (uint32_t)counts[0],
                      .n_labels = (uint32_t)counts[1],
                      .n_numbers = (uint32_t)counts[2],
                      .n_words = (uint32_t)counts[3],
                      .n_steps = (uint32_t)counts[4],
                      .text_size = (uint32_t)counts[5],
                      .horizontal = bytes_get32(data + 4) };
    m->number = data + number;
    m->top_action = data + top;
    m->label = data + label;
    m->word = data + word;
    m->step = data + step;
    m->text = data + text;
    return text + counts[5];
}

static bool is_command_at(const struct ml *m, uint32_t at)
{
    return at < m->n_words && ml_word(m, at) & ML_COMMAND;
}

static bool value_ok(const struct ml *m, uint32_t v)
{
    if (!(v & ML_COMPUTED))
        return v < m->n_numbers;
    v &= ~ML_COMPUTED;
    return v < m->n_steps && (v == 0 || ml_step(m, v - 1) == STEP_DONE);
}

/* Checks one operand, whose type is `type` (see ml_operands). If the operand is a count, stores it in *n. */
static bool operand_ok(const struct ml *m, char type, uint32_t v, uint32_t *n)
{
    switch (type) {
    case 'v':
        return value_ok(m, v);
    case 'p':
        return is_command_at(m, v);
    case 'l':
        return v <= m->n_labels;
    default:
        *n = v;
        return v <= ML_MAX_PARAMS;
    }
}

/* Checks the command at *at and advances *at to the next one. */
static bool command_ok(const struct ml *m, uint32_t *at)
{
    const uint32_t w = ml_word(m, *at);
    uint32_t n = 0;

    if (!(w & ML_COMMAND) || ML_OP(w) >= ML_OPS || ML_TYPE(w) >= ML_TYPES * ML_Y_TYPE_FACTOR ||
        ML_TYPE(w) % ML_Y_TYPE_FACTOR >= ML_TYPES)
        return false;
    ++*at;
    for (const char *type = ml_operands[ML_OP(w)]; *type && *type != '*'; type++, ++*at)
        if (*at == m->n_words || ml_word(m, *at) & ML_COMMAND || !operand_ok(m, *type, ml_word(m, *at), &n))
            return false;
    for (; n; n--, ++*at)
        if (*at == m->n_words || ml_word(m, *at) & ML_COMMAND || !value_ok(m, ml_word(m, *at)))
            return false;
    return true;
}

static bool is_end(const struct ml *m, uint32_t at)
{
    return ml_word(m, at) & ML_COMMAND && ML_OP(ml_word(m, at)) == ML_END;
}

static bool commands_ok(const struct ml *m)
{
    uint32_t at = 0;

    while (at < m->n_words)
        if (!command_ok(m, &at))
            return false;
    return m->n_words && is_end(m, 0) && is_end(m, m->n_words - 1);
}

/* Checks a step. *stack: the number of values on the stack, which the step updates. */
static bool step_ok(const struct ml *m, uint32_t w, int *stack)
{
    const uint32_t argument = ML_ARGUMENT(w);

    switch ((enum ml_step)ML_STEP(w)) {
    case STEP_DONE:
        if (*stack != 1)
            return false;
        *stack = 0;
        return w == STEP_DONE;
    case STEP_NUMBER:
        return argument < m->n_numbers && ++*stack <= ML_STACK_SIZE;
    case STEP_PARAM:
        return argument <= ML_PARAMS && ++*stack <= ML_STACK_SIZE;
    case STEP_RAND:
    case STEP_RANK:
        return !argument && ++*stack <= ML_STACK_SIZE;
    case STEP_ADD:
    case STEP_SUBTRACT:
    case STEP_MULTIPLY:
    case STEP_DIVIDE:
        return !argument && --*stack >= 1;
    case STEP_NEGATE:
        return !argument && *stack >= 1;
    default:
        return false;
    }
}

static bool steps_ok(const struct ml *m)
{
    int stack = 0;

    for (uint32_t i = 0; i < m->n_steps; i++)
        if (!step_ok(m, ml_step(m, i), &stack))
            return false;
    return !m->n_steps || ml_step(m, m->n_steps - 1) == STEP_DONE;
}

static bool tables_ok(const struct ml *m)
{
    for (uint32_t i = 0; i < m->n_top_actions; i++)
        if (!is_command_at(m, ml_top_action(m, i)))
            return false;
    for (uint32_t i = 0; i < m->n_labels; i++)
        if (bytes_get32(m->label + 4 * (size_t)i) >= m->text_size)
            return false;
    return !m->text_size || m->text[m->text_size - 1] == 0;
}

bool ml_check(const uint8_t *data, size_t size, char *err, size_t err_size)
{
    struct ml m;

    if (size < ML_HEADER_SIZE || bytes_get32(data) != ML_MAGIC)
        return err_set(err, err_size, "not a BulletML program");
    if (bytes_get32(data + 4) > 1)
        return err_set(err, err_size, "unknown format");
    const uint64_t expected = ml_open(&m, data);
    if (m.n_top_actions > ML_MAX_TOP_ACTIONS || m.n_labels > ML_MAX_LABELS || m.n_numbers > ML_MAX_NUMBERS ||
        m.n_words > ML_MAX_WORDS || m.n_steps > ML_MAX_WORDS || m.text_size > ML_MAX_TEXT)
        return err_set(err, err_size, "too large for a BulletML program");
    if (expected != size)
        return err_set(err, err_size, "%zu bytes long, expected %" PRIu64, size, expected);
    if (!steps_ok(&m))
        return err_set(err, err_size, "an expression in its program is invalid");
    if (!commands_ok(&m))
        return err_set(err, err_size, "a command in its program is invalid");
    if (!tables_ok(&m))
        return err_set(err, err_size, "its top actions or labels are out of range");
    return true;
}

static uint64_t magnitude(int64_t v)
{
    return v < 0 ? 0 - (uint64_t)v : (uint64_t)v;
}

static int64_t apply_sign(uint64_t v, bool negative)
{
    if (v > INT64_MAX)
        return negative ? INT64_MIN : INT64_MAX;
    return negative ? -(int64_t)v : (int64_t)v;
}

int64_t ml_multiply(int64_t a, int64_t b)
{
    const uint64_t ua = magnitude(a), ub = magnitude(b), low = ua * ub, rounded = low + ((uint64_t)1 << 31);
    const uint64_t high = fx_mul_high(ua, ub) + (rounded < low);

    return apply_sign(high >> 32 ? UINT64_MAX : high << 32 | rounded >> 32, (a ^ b) < 0);
}

/* Computes 2^32 a / b: the integer part of a / b, then 32 fraction bits, then the rounding. */
int64_t ml_divide(int64_t a, int64_t b)
{
    const uint64_t ua = magnitude(a), ub = magnitude(b);

    if (!ub)
        return a > 0 ? INT64_MAX : a < 0 ? INT64_MIN : 0;
    uint64_t q = ua / ub, rem = ua % ub;
    if (q >> 31)
        return apply_sign(UINT64_MAX, (a ^ b) < 0);
    if (!(rem >> 32)) {
        q = q << 32 | (rem << 32) / ub;
        rem = (rem << 32) % ub;
    } else
        for (int i = 0; i < 32; i++) {
            const bool carry = rem >> 63;
            rem <<= 1;
            q <<= 1;
            if (carry || rem >= ub) {
                rem -= ub;
                q++;
            }
        }
    return apply_sign(q + (rem >= ub - rem), (a ^ b) < 0);
}
