/*
 * slots.h - chips and their slots. A chip is a struct of columns and registers, described by one table, and the code
 * that works on it; a slot is a numbered row of the columns.
 *
 * A chip's struct begins with a struct slots; its columns are pointers into RAM, its registers stand in the struct
 * itself. The column table lays the chip out, hashes it, saves and restores it; tests and docs walk the same table.
 *
 * A pool (`used` is not NULL): a live thing keeps its slot, a new one takes the lowest free slot, and a slot's
 * generation goes up when its tenant dies. A slot whose generation has reached the last one, after 2^30 - 2 tenants, is
 * retired: no tenant ever has that generation, so no handle can come to mean another thing, and the pool is full one
 * slot earlier. A list (`used` is NULL): entries [0, live) are in use, in the order they were added.
 *
 * Invariants of a pool: every live slot is below top; top and high are multiples of 64; gen and used hold below high,
 * and nothing at or beyond top is read, so a snapshot copies [0, top) of the columns and [0, high) of gen
 * and used.
 *
 * A held slot's tenant is not live any more, but its columns and generation stay, and no new tenant gets the slot: a
 * thing that leaves the field in the frame in which it touches something, until the events of that are applied.
 * Between frames nothing is held.
 */
#ifndef BASE_SLOTS_H
#define BASE_SLOTS_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include "bits.h"
#include "bytes.h"

enum column_kind {
    COL_GAME,    /* hashed */
    COL_DERIVED, /* follows from game columns or lasts less than a frame; `why` says which */
};

struct column {
    const char *name;
    uint16_t at;   /* offset in the chip's struct: of the pointer, or of the register itself */
    uint8_t width; /* bytes of one value: 1, 2, 4 or 8 */
    uint16_t n;    /* values a slot; a register's count of values */
    bool reg;      /* a register of the chip, not a column */
    bool block;    /* n values a block of SLOTS_BLOCK slots, not a slot */
    enum column_kind kind;
    const char *why; /* of a derived column */
    uint8_t group;   /* 0: always there; g: in chips laid out with SLOTS_GROUP(g) alone */
};

/* Some columns are there only where a game's manifest asks for their group; else their pointer is NULL, and they take
 * no bytes, no hash and no snapshot. */
#define SLOTS_GROUP(g) (1u << ((g)-1))

/* Entries of a column table, named as the fields of the chip's struct. */
/* clang-format off */
#define COLUMN_ENTRY(chip, name, width, n, reg, block, kind, why)                                                      \
    { #name, offsetof(struct chip, name), width, n, reg, block, kind, why, 0 }
#define COLUMN_FIELD(chip, name) (((struct chip *)0)->name)

/* A column, with one value a slot or n. */
#define COLUMN(chip, name)                                                                                             \
    COLUMNS(chip, name, 1)
#define COLUMNS(chip, name, n)                                                                                         \
    COLUMN_ENTRY(chip, name, sizeof *COLUMN_FIELD(chip, name), n, false, false, COL_GAME, NULL)
#define DERIVED(chip, name, why)                                                                                       \
    COLUMN_ENTRY(chip, name, sizeof *COLUMN_FIELD(chip, name), 1, false, false, COL_DERIVED, why)
#define DERIVED_COLUMNS(chip, name, n, why)                                                                            \
    COLUMN_ENTRY(chip, name, sizeof *COLUMN_FIELD(chip, name), n, false, false, COL_DERIVED, why)
#define DERIVED_BLOCKS(chip, name, n, why)                                                                             \
    COLUMN_ENTRY(chip, name, sizeof *COLUMN_FIELD(chip, name), n, false, true, COL_DERIVED, why)

/* A column of a group: there if the manifest asks for the group. */
#define GROUP_COLUMN(chip, name, group)                                                                                \
    { #name, offsetof(struct chip, name), sizeof *COLUMN_FIELD(chip, name), 1, false, false, COL_GAME, NULL, group }

/* The same with n values a slot. */
#define GROUP_COLUMNS(chip, name, n, group)                                                                            \
    { #name, offsetof(struct chip, name), sizeof *COLUMN_FIELD(chip, name), n, false, false, COL_GAME, NULL, group }

/* A derived column of a group, with a value a slot, and with one a block. */
#define GROUP_DERIVED(chip, name, group, why)                                                                          \
    { #name, offsetof(struct chip, name), sizeof *COLUMN_FIELD(chip, name), 1, false, false, COL_DERIVED, why, group }
#define GROUP_BLOCKS(chip, name, group, why)                                                                           \
    { #name, offsetof(struct chip, name), sizeof *COLUMN_FIELD(chip, name), 1, false, true, COL_DERIVED, why, group }

/* A register: one value, or an array. */
#define REGISTER(chip, name)                                                                                           \
    COLUMN_ENTRY(chip, name, sizeof COLUMN_FIELD(chip, name), 1, true, false, COL_GAME, NULL)
#define REGISTERS(chip, name)                                                                                          \
    COLUMN_ENTRY(chip, name, sizeof *COLUMN_FIELD(chip, name),                                                         \
                 sizeof COLUMN_FIELD(chip, name) / sizeof *COLUMN_FIELD(chip, name), true, false, COL_GAME, NULL)
#define DERIVED_REGISTERS(chip, name, why)                                                                             \
    COLUMN_ENTRY(chip, name, sizeof *COLUMN_FIELD(chip, name),                                                         \
                 sizeof COLUMN_FIELD(chip, name) / sizeof *COLUMN_FIELD(chip, name), true, false, COL_DERIVED, why)
#define DERIVED_REGISTER(chip, name, why)                                                                              \
    COLUMN_ENTRY(chip, name, sizeof COLUMN_FIELD(chip, name), 1, true, false, COL_DERIVED, why)

/* Registers of a group: they stand in the struct, but are hashed only where the manifest asks for the group. */
#define GROUP_REGISTER(chip, name, group)                                                                              \
    { #name, offsetof(struct chip, name), sizeof COLUMN_FIELD(chip, name), 1, true, false, COL_GAME, NULL, group }
#define GROUP_REGISTERS(chip, name, group)                                                                             \
    { #name, offsetof(struct chip, name), sizeof *COLUMN_FIELD(chip, name),                                            \
      sizeof COLUMN_FIELD(chip, name) / sizeof *COLUMN_FIELD(chip, name), true, false, COL_GAME, NULL, group }
/* clang-format on */

struct slots {
    uint32_t cap;  /* most that can live at once */
    uint32_t top;  /* every live slot is below */
    uint32_t high; /* slots ever used */
    uint32_t live;
    uint32_t refused;           /* how often there was no room; scripts can read it */
    uint32_t low;               /* no word of `used` before this one has a slot that slots_take can give */
    uint64_t *used;             /* a bit a slot; NULL: a list */
    uint32_t *gen;              /* 1 .. GENERATIONS; GENERATIONS: retired */
    uint64_t *held;             /* a bit a slot below held_top */
    uint32_t held_top, holding; /* 0, 0 when nothing is held */
    uint32_t groups;            /* SLOTS_GROUP bits: the groups of columns that are there */
};

/* What a chip is: its name in hashes and reports, and its columns. */
struct chip {
    const char *name;
    const struct column *columns;
    int count;
    bool list;
    bool unhashed; /* hashed for reports, but outside the combined hash: no script can read it */
};

enum { SLOTS_BLOCK = 64, GENERATIONS = (1 << 30) - 1, NO_SLOT = -1 };

/* Bytes of RAM a chip of this capacity, with these groups of columns, takes. */
uint64_t slots_size(const struct chip *chip, uint32_t cap, uint32_t groups);

/* Points the chip's columns into RAM from *next on and empties it; *next moves past them. `self` is the chip's struct.
 */
void slots_layout(const struct chip *chip, void *self, uint32_t cap, uint32_t groups, uint8_t **next);

/* Is this column in RAM, and this register in use? */
static inline bool slots_column_there(const struct column *c, uint32_t groups)
{
    return c->group == 0 || groups & SLOTS_GROUP(c->group);
}

/* The lowest free slot of a pool that is not retired, or NO_SLOT (refused counts up). If top grew, the caller
 * must park the new slots: set their columns so that loops over the chip pass them without effect. */
int32_t slots_take(struct slots *s);

/* The next entry of a list, or NO_SLOT. */
int32_t slots_append(struct slots *s);

/* The tenant of slot i dies. */
void slots_drop(struct slots *s, uint32_t i);

/* The tenant of slot i is not live any more, but keeps the slot until slots_release. `words` has room for a bit a slot
 * below top; the caller gives the same for all that are held at a time. */
void slots_hold(struct slots *s, uint64_t *words, uint32_t i);

/* The tenant of the held slot i dies. */
void slots_release(struct slots *s, uint32_t i);

/* Lowers top to the last block with a live slot, unless slots are held. */
void slots_trim(struct slots *s);

/* The first live slot at or after i, or top (a list: live) when there is none. */
uint32_t slots_next(const struct slots *s, uint32_t i);

static inline bool slots_has(const struct slots *s, uint32_t slot, uint32_t gen)
{
    return slot < s->top && (s->used[slot >> 6] >> (slot & 63) & 1) && s->gen[slot] == gen;
}

/* The same of a held slot. */
static inline bool slots_has_held(const struct slots *s, uint32_t slot, uint32_t gen)
{
    return slot < s->held_top && (s->held[slot >> 6] >> (slot & 63) & 1) && s->gen[slot] == gen;
}

/* The slots of a block that are live or held, a bit each. */
static inline uint64_t slots_live_or_held(const struct slots *s, uint32_t block)
{
    return s->used[block] | (block * SLOTS_BLOCK < s->held_top ? s->held[block] : 0);
}

/* The first held slot at or after i, or held_top when there is none. */
uint32_t slots_next_held(const struct slots *s, uint32_t i);

/* Visits the held slots of a pool in slot order; the body may release the one it is at. */
#define EACH_HELD(i, s) for (uint32_t i = slots_next_held(s, 0); i < (s)->held_top; i = slots_next_held(s, i + 1))

/* Visits the live slots of a pool in slot order; the body may drop the one it is at. */
#define EACH_LIVE(i, s) for (uint32_t i = slots_next(s, 0); i < (s)->top; i = slots_next(s, i + 1))

/* Are all registers that are hashed 0? */
bool slots_blank(const struct chip *chip, const void *self);

/* The state hash: registers, then for each live slot in slot order the slot, its generation and its game columns. */
uint64_t slots_hash(const struct chip *chip, const void *self);

/* One value that is hashed. */
struct slots_value {
    const char *column; /* or register; "live" and "refused" come first */
    int64_t slot;       /* NO_SLOT: a register */
    uint32_t gen;       /* of the slot's tenant; 0: a register, or an entry of a list */
    uint16_t i, n;      /* the i-th of n of this slot and column */
    uint8_t width;      /* bytes */
    uint64_t value;
};
typedef void slots_visit(void *context, const struct slots_value *v);

/* Visits all that slots_hash folds, in its order. */
void slots_values(const struct chip *chip, const void *self, slots_visit *visit, void *context);

/* Prefetches the cache line at p. */
static inline void slots_prefetch(const void *p)
{
#ifdef __GNUC__
    __builtin_prefetch(p);
#else
    (void)p;
#endif
}

/* A bit for each byte of a block, each of which is 0 or 1: a vectorised loop writes bytes. */
static inline uint64_t slots_gather(const uint8_t is[SLOTS_BLOCK])
{
    uint64_t m = 0;

    for (int i = 0; i < 8; i++)
        m |= (bytes_get64(is + 8 * i) * 0x0102040810204080u >> 56) << 8 * i;
    return m;
}

/* Snapshots of the columns (the struct itself is copied with the board). Returns bytes, a multiple of 64;
 * buf NULL only counts. */
size_t slots_save(const struct chip *chip, const void *self, uint8_t *buf);
size_t slots_restore(const struct chip *chip, void *self, const uint8_t *buf);

#endif
