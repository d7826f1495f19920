/*
 * registers.c - counters of ships and of the run (registers.h). Most games have no registers that drain; the board
 * then never calls registers_drain.
 */
#include "registers.h"
#include "../base/int.h"

static const struct column columns[] = {
    DERIVED_COLUMNS(registers, rule, RULE_FIELDS, "set only while scripts load, like names"),
    COLUMNS(registers, value, MAX_PLAYERS),
    COLUMNS(registers, drain_wait, MAX_PLAYERS),
    DERIVED_REGISTER(registers, first_run_row, "set while scripts load"),
    DERIVED_REGISTER(registers, n_run_rows, "set while scripts load"),
    DERIVED_REGISTER(registers, n_draining, "set while scripts load"),
};

const struct chip registers_chip = { .name = "registers", CHIP_COLUMNS(columns), .is_list = true };

int32_t registers_add(struct registers *r, const struct register_rule *rule)
{
    const int32_t i = slots_append(&r->s);

    if (i == NO_SLOT)
        return i;
    int32_t *to = r->rule + (uint32_t)i * RULE_FIELDS;
    to[RULE_START] = rule->start;
    to[RULE_MIN] = rule->min_value;
    to[RULE_MAX] = rule->max_value;
    to[RULE_DRAIN] = rule->drain;
    to[RULE_INTERVAL] = rule->interval;
    to[RULE_HOLD] = rule->hold;
    r->n_draining += rule->drain != 0;
    for (uint32_t p = 0; p < MAX_PLAYERS; p++)
        registers_reset(r, (uint32_t)i, 1, p);
    return i;
}

struct register_rule registers_rule(const struct registers *r, uint32_t row)
{
    const int32_t *at = r->rule + row * RULE_FIELDS;

    return (struct register_rule){ at[RULE_START], at[RULE_MIN],      at[RULE_MAX],
                                   at[RULE_DRAIN], at[RULE_INTERVAL], at[RULE_HOLD] };
}

/* Returns whether the change from `old_value` to `new_value` goes against the drain. */
static bool opposes_drain(int32_t drain, int32_t old_value, int32_t new_value)
{
    return drain < 0 && drain != DRAIN_TO_START ? new_value < old_value : new_value > old_value;
}

void registers_set(struct registers *r, uint32_t row, uint32_t p, int64_t v)
{
    const int32_t *rule = r->rule + row * RULE_FIELDS;
    int32_t *value = &r->value[row * MAX_PLAYERS + p], *wait = &r->drain_wait[row * MAX_PLAYERS + p],
            old_value = *value;

    *value = (int32_t)int64_clamp(v, rule[RULE_MIN], rule[RULE_MAX]);
    if (rule[RULE_DRAIN] && opposes_drain(rule[RULE_DRAIN], old_value, *value) && *wait < rule[RULE_HOLD])
        *wait = rule[RULE_HOLD];
}

bool registers_is_full(const struct registers *r, uint32_t row, uint32_t p)
{
    const int32_t max_value = r->rule[row * RULE_FIELDS + RULE_MAX];

    return max_value != REGISTER_NO_MAX && registers_get(r, row, p) == max_value;
}

void registers_reset(struct registers *r, uint32_t first, uint32_t n, uint32_t p)
{
    for (uint32_t row = first; row < first + n; row++) {
        const int32_t *rule = r->rule + row * RULE_FIELDS;
        r->value[row * MAX_PLAYERS + p] = rule[RULE_START];
        r->drain_wait[row * MAX_PLAYERS + p] = rule[RULE_DRAIN] ? rule[RULE_INTERVAL] : 0;
    }
}

void registers_drain(struct registers *r, uint32_t first, uint32_t n, uint32_t p)
{
    for (uint32_t row = first; row < first + n; row++) {
        const int32_t *rule = r->rule + row * RULE_FIELDS;
        int32_t *value = &r->value[row * MAX_PLAYERS + p], *wait = &r->drain_wait[row * MAX_PLAYERS + p];
        if (!rule[RULE_DRAIN] || --*wait > 0)
            continue;
        *wait = rule[RULE_INTERVAL];
        *value = rule[RULE_DRAIN] == DRAIN_TO_START
                     ? rule[RULE_START]
                     : (int32_t)int64_clamp((int64_t)*value - rule[RULE_DRAIN], rule[RULE_MIN], rule[RULE_MAX]);
    }
}
