/*
 * registers.h - named counters of ships and of the run: power, bombs, a gauge, a chain, rank.
 *
 * A list of rows, which grows only while scripts load. The registers of a kind of ship are in consecutive rows; so are
 * the run's registers. A row has a rule and a value for each player; the run's registers use the value of player 0.
 */
#ifndef ENTITIES_REGISTERS_H
#define ENTITIES_REGISTERS_H

#include <stdbool.h>
#include <stdint.h>
#include "../base/pads.h"
#include "../base/slots.h"

enum {
    DRAIN_TO_START = INT32_MIN,     /* value of `drain`: the register returns to its start value at once */
    REGISTER_NO_MAX = INT32_MAX,    /* value of `max_value`: no maximum */
    DEFAULT_REGISTER_CAPACITY = 64, /* number of rows, unless rom.lua sets it */
    MAX_REGISTERS = 1024
};

/* Declared by a script. */
struct register_rule {
    int32_t start, min_value, max_value;
    int32_t drain; /* amount subtracted every `interval` frames (negative: added), or DRAIN_TO_START */
    int32_t interval;
    int32_t hold; /* frames without draining after a change in the opposite direction */
};

enum { RULE_START, RULE_MIN, RULE_MAX, RULE_DRAIN, RULE_INTERVAL, RULE_HOLD, RULE_FIELDS };

struct registers {
    struct slots s;
    int32_t *rule;                      /* RULE_FIELDS per row */
    int32_t *value;                     /* MAX_PLAYERS per row */
    int32_t *drain_wait;                /* MAX_PLAYERS per row: frames until the register drains again */
    uint32_t first_run_row, n_run_rows; /* the run's rows */
    uint32_t n_draining;                /* number of rows whose rule has a drain */
};

extern const struct chip registers_chip;

/* Appends a row with its start values; returns its index, or NO_SLOT when the list is full. */
int32_t registers_add(struct registers *r, const struct register_rule *rule);
struct register_rule registers_rule(const struct registers *r, uint32_t row);

static inline int32_t registers_get(const struct registers *r, uint32_t row, uint32_t p)
{
    return r->value[row * MAX_PLAYERS + p];
}

/* Sets a register to v, clamped to its range. A change against the drain starts the hold time. */
void registers_set(struct registers *r, uint32_t row, uint32_t p, int64_t v);

/* Returns whether a register is at its maximum; false if the register has no maximum. */
bool registers_is_full(const struct registers *r, uint32_t row, uint32_t p);

/* Resets player p's values of n rows, starting at row `first`, for a new game. */
void registers_reset(struct registers *r, uint32_t first, uint32_t n, uint32_t p);

/* Drains player p's values of n rows, starting at row `first`, by one frame. */
void registers_drain(struct registers *r, uint32_t first, uint32_t n, uint32_t p);

#endif
