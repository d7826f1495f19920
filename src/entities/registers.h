/*
 * registers.h - what ships, and a run, count under a name: power, bombs, a gauge, a chain, rank.
 *
 * A list of rows, which only grows while scripts load. The registers of a kind of ship are rows one after the other,
 * and so are those of the run. A row has its rule and what it is for each player; of the run's, that of player 0
 * counts.
 */
#ifndef ENTITIES_REGISTERS_H
#define ENTITIES_REGISTERS_H

#include <stdbool.h>
#include <stdint.h>
#include "../base/pads.h"
#include "../base/slots.h"

enum {
    DRAIN_FOREVER = INT32_MIN, /* as `drain`: to start at once */
    REGISTER_MOST = INT32_MAX, /* as `most`: none */
    REGISTERS = 64,            /* rows, unless rom.lua says another number */
    MAX_REGISTERS = 1024
};

/* What a script declares. */
struct register_rule {
    int32_t start, least, most;
    int32_t drain; /* what it loses each `every` frames; below 0 it gains; or DRAIN_FOREVER */
    int32_t every;
    int32_t hold; /* frames it does not drain after a write against the drain */
};

enum { RULE_START, RULE_LEAST, RULE_MOST, RULE_DRAIN, RULE_EVERY, RULE_HOLD, RULE_FIELDS };

struct registers {
    struct slots s;
    int32_t *rule;         /* RULE_FIELDS a row */
    int32_t *value;        /* PADS a row */
    int32_t *wait;         /* PADS a row: frames until it drains again */
    uint32_t first, count; /* the run's rows */
    uint32_t drains;       /* so many rows drain */
};

extern const struct chip registers_chip;

/* A new row, or NO_SLOT. */
int32_t registers_add(struct registers *r, const struct register_rule *rule);
struct register_rule registers_rule(const struct registers *r, uint32_t row);

static inline int32_t registers_get(const struct registers *r, uint32_t row, uint32_t p)
{
    return r->value[row * PADS + p];
}

/* Sets it to v, or to the nearest that it may be. */
void registers_set(struct registers *r, uint32_t row, uint32_t p, int64_t v);

/* Is it at its most? False for one that has none. */
bool registers_full(const struct registers *r, uint32_t row, uint32_t p);

/* The rows from `first` on begin a game, for player p. */
void registers_start(struct registers *r, uint32_t first, uint32_t n, uint32_t p);

/* A frame of them. */
void registers_drain(struct registers *r, uint32_t first, uint32_t n, uint32_t p);

#endif
