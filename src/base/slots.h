/*
 * slots.h - chips and their slots. A chip is a struct of columns and registers, described by one column table, together
 * with the code that works on the struct. A slot is a numbered row of the columns.
 *
 * A chip's struct begins with a struct slots; its columns are pointers into RAM, its registers are members of the
 * struct. The column table is used to lay the chip out, to hash it, and to save and restore it; tests and docs walk the
 * same table.
 *
 * In a pool (`live_bits` is not NULL) a live entity keeps its slot, a new one takes the lowest free slot, and a slot's
 * generation is incremented when its entity is dropped. A slot whose generation reaches RETIRED_GENERATION, after 2^30
 * - 2 entities, is retired: no entity ever has that generation, so no handle can ever name a second entity. Each
 * retired slot reduces the pool's capacity by one. In a list (`live_bits` is NULL) entries [0, live) are in use, in the
 * order in which they were added.
 *
 * Invariants of a pool: every live slot is below top; top and high are multiples of 64; gen and used are valid below
 * high, and columns are not read at or beyond top, so a snapshot copies [0, top) of the columns and [0, high) of gen
 * and used.
 *
 * The entity in a held slot is no longer live, but its columns and generation are preserved, and no new entity gets the
 * slot. If an entity leaves the field in the same frame in which it touches something, its slot is held until the
 * resulting events are applied. No slot is held between frames.
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
    COL_DERIVED, /* computed from game columns or used only within a frame; `reason` states which */
};

struct column {
    const char *name;
    uint16_t offset;   /* offset, in the chip's struct, of the column's pointer or of the register */
    uint8_t width;     /* bytes of one value: 1, 2, 4 or 8 */
    uint16_t n;        /* values per slot; for a register, the number of values */
    bool is_register;  /* a register of the chip, not a column */
    bool is_per_block; /* n values per block of SLOTS_BLOCK slots, not per slot */
    enum column_kind kind;
    const char *reason; /* reason that a column is derived */
    uint8_t group;      /* 0: always present; g: present only in chips laid out with SLOTS_GROUP(g) */
};

/* Some columns are present only if a game's manifest asks for their group. Otherwise their pointer is NULL, and they
 * take up no RAM, are not hashed and are not in snapshots. */
#define SLOTS_GROUP(g) (1u << ((g)-1))

/* Entries of a column table, named like the fields of the chip's struct. */
/* clang-format off */
#define COLUMN_ENTRY(chip, name, width, n, reg, block, kind, why)                                                      \
    { #name, offsetof(struct chip, name), width, n, reg, block, kind, why, 0 }
#define COLUMN_FIELD(chip, name) (((struct chip *)0)->name)

/* Columns with one value per slot, with n values per slot (COLUMNS), and with n values per block (BLOCKS). */
#define COLUMN(chip, name)                                                                                             \
    COLUMNS(chip, name, 1)
#define COLUMNS(chip, name, n)                                                                                         \
    COLUMN_ENTRY(chip, name, sizeof *COLUMN_FIELD(chip, name), n, false, false, COL_GAME, NULL)
#define DERIVED_COLUMN(chip, name, why)                                                                                \
    COLUMN_ENTRY(chip, name, sizeof *COLUMN_FIELD(chip, name), 1, false, false, COL_DERIVED, why)
#define DERIVED_COLUMNS(chip, name, n, why)                                                                            \
    COLUMN_ENTRY(chip, name, sizeof *COLUMN_FIELD(chip, name), n, false, false, COL_DERIVED, why)
#define DERIVED_BLOCKS(chip, name, n, why)                                                                             \
    COLUMN_ENTRY(chip, name, sizeof *COLUMN_FIELD(chip, name), n, false, true, COL_DERIVED, why)

/* A column of a group: present if the manifest asks for the group. */
#define GROUP_COLUMN(chip, name, group)                                                                                \
    { #name, offsetof(struct chip, name), sizeof *COLUMN_FIELD(chip, name), 1, false, false, COL_GAME, NULL, group }

/* A column of a group with n values per slot. */
#define GROUP_COLUMNS(chip, name, n, group)                                                                            \
    { #name, offsetof(struct chip, name), sizeof *COLUMN_FIELD(chip, name), n, false, false, COL_GAME, NULL, group }

/* Derived columns of a group, with one value per slot, and with one value per block. */
#define GROUP_DERIVED_COLUMN(chip, name, group, why)                                                                   \
    { #name, offsetof(struct chip, name), sizeof *COLUMN_FIELD(chip, name), 1, false, false, COL_DERIVED, why, group }
#define GROUP_DERIVED_BLOCKS(chip, name, group, why)                                                                   \
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

/* Registers of a group: always in the struct, but hashed only if the manifest asks for the group. */
#define GROUP_REGISTER(chip, name, group)                                                                              \
    { #name, offsetof(struct chip, name), sizeof COLUMN_FIELD(chip, name), 1, true, false, COL_GAME, NULL, group }
#define GROUP_REGISTERS(chip, name, group)                                                                             \
    { #name, offsetof(struct chip, name), sizeof *COLUMN_FIELD(chip, name),                                            \
      sizeof COLUMN_FIELD(chip, name) / sizeof *COLUMN_FIELD(chip, name), true, false, COL_GAME, NULL, group }
/* clang-format on */

struct slots {
    uint32_t cap;        /* most slots that can be live at once */
    uint32_t top;        /* every live slot is below this */
    uint32_t high_water; /* slots ever used, in whole blocks */
    uint32_t live;
    uint32_t refused;              /* additions refused because the chip was full; scripts can read it */
    uint32_t first_free_word;      /* no word of `live_bits` before this one has a slot that slots_take can return */
    uint64_t *live_bits;           /* a bit per slot, 1: live; NULL: the chip is a list */
    uint32_t *gen;                 /* generation of each slot, 1 to RETIRED_GENERATION (retired) */
    uint64_t *held;                /* a bit per slot below held_top */
    uint32_t held_top, held_count; /* end of `held`, number of held slots; 0 if none is held */
    uint32_t groups;               /* SLOTS_GROUP bits of the groups of columns that are present */
    uint32_t reserved;             /* slots that the columns have space for; in a list that grows, up to `cap` */
};

/* A chip's description: its name in hashes and reports, and its columns. */
struct chip {
    const char *name;
    const struct column *columns;
    int count;
    bool is_list;
    bool unhashed; /* hashed in reports but not in the combined hash, as no script can read the chip */
};

#define CHIP_COLUMNS(table) .columns = (table), .count = (int)(sizeof(table) / sizeof *(table))

enum { SLOTS_BLOCK = 64, RETIRED_GENERATION = (1 << 30) - 1, NO_SLOT = -1 };

/* Returns the bytes of RAM that a chip of this capacity with these groups of columns occupies. */
uint64_t slots_size(const struct chip *chip, uint32_t cap, uint32_t groups);

/* Points the chip's columns into RAM starting at *next, advances *next past them, and empties the chip. `self` is the
 * chip's struct. */
void slots_layout(const struct chip *chip, void *self, uint32_t cap, uint32_t groups, uint8_t **next);

/* Moves a list's columns to `memory`, slots_size(chip, reserved, groups) bytes, zeroed and aligned for int64_t. They
 * then have space for `reserved` entries, at least as many as there are. */
void slots_move(const struct chip *chip, void *self, uint32_t reserved, uint8_t *memory);

/* Returns whether the group of this column or register is present. */
static inline bool slots_has_column(const struct column *c, uint32_t groups)
{
    return c->group == 0 || groups & SLOTS_GROUP(c->group);
}

/* In a pool, takes and returns the lowest slot that is not live, held or retired. If there is none, increments
 * `refused` and returns NO_SLOT. If top grew, the caller must park the new slots: set their columns so that loops over
 * the whole chip have no effect on them. */
int32_t slots_take(struct slots *s);

/* Appends an entry to a list and returns its index. If the list is full, increments `refused` and returns NO_SLOT. In a
 * list that grows, the caller has made space for the entry (slots_move). */
int32_t slots_append(struct slots *s);

/* Drops the entity in slot i; the slot is free again. */
void slots_drop(struct slots *s, uint32_t i);

/* Drops all live slots for which the column has this value, and trims the pool. */
void slots_drop_where(struct slots *s, const int64_t *column, int64_t value);

/* Makes the entity in slot i no longer live, but holds the slot until slots_release. `words` needs a bit per slot below
 * top; the caller passes the same array for all slots held at the same time. */
void slots_hold(struct slots *s, uint64_t *words, uint32_t i);

/* Drops the entity in the held slot i; the slot is free again. */
void slots_release(struct slots *s, uint32_t i);

/* Lowers top to the end of the last block with a live slot. Does nothing while slots are held. */
void slots_trim(struct slots *s);

/* Returns the first live slot at or after i, or, if there is none, top (for a list: live). */
uint32_t slots_next(const struct slots *s, uint32_t i);

/* Copies all columns of n slots, from slot `from` on, to those from slot `to` on; the two ranges may overlap. Registers
 * and columns with values per block are not copied. */
void slots_copy_rows(const struct chip *chip, void *self, uint32_t to, uint32_t from, uint32_t n);

static inline bool slots_has(const struct slots *s, uint32_t slot, uint32_t gen)
{
    return slot < s->top && (s->live_bits[slot >> 6] >> (slot & 63) & 1) && s->gen[slot] == gen;
}

/* Like slots_has, but for a held slot. */
static inline bool slots_has_held(const struct slots *s, uint32_t slot, uint32_t gen)
{
    return slot < s->held_top && (s->held[slot >> 6] >> (slot & 63) & 1) && s->gen[slot] == gen;
}

/* Returns a mask of the slots in a block that are live or held. */
static inline uint64_t slots_live_or_held_mask(const struct slots *s, uint32_t block)
{
    return s->live_bits[block] | (block * SLOTS_BLOCK < s->held_top ? s->held[block] : 0);
}

/* Returns the first held slot at or after i, or held_top if there is none. */
uint32_t slots_next_held(const struct slots *s, uint32_t i);

/* Visits the held slots of a pool in slot order; the body may release the current one. */
#define EACH_HELD(i, s) for (uint32_t i = slots_next_held(s, 0); i < (s)->held_top; i = slots_next_held(s, i + 1))

/* Visits the live slots of a pool in slot order; the body may drop the current one. */
#define EACH_LIVE(i, s) for (uint32_t i = slots_next(s, 0); i < (s)->top; i = slots_next(s, i + 1))

/* Returns whether all hashed registers are 0. */
bool slots_registers_are_zero(const struct chip *chip, const void *self);

/* Returns the state hash. Folds the live and refused counts and the game registers, then for each live slot, in slot
 * order, the slot number and generation (pools only) and the game columns. */
uint64_t slots_hash(const struct chip *chip, const void *self);

/* One hashed value. */
struct slots_value {
    const char *column; /* name of the column or register; "live" and "refused" come first */
    int64_t slot;       /* slot number; NO_SLOT: a register */
    uint32_t gen;       /* generation of the slot's entity; 0: a register, or an entry of a list */
    uint16_t i, n;      /* value i, counted from 0, of the n in this slot and column */
    uint8_t width;      /* bytes */
    uint64_t value;
};
typedef void slots_visitor(void *context, const struct slots_value *v);

/* Visits all values that slots_hash folds, in the same order. */
void slots_visit_values(const struct chip *chip, const void *self, slots_visitor *visit, void *context);

/* Prefetches the cache line at p. */
static inline void slots_prefetch(const void *p)
{
#ifdef __GNUC__
    __builtin_prefetch(p);
#else
    (void)p;
#endif
}

/* Packs the flags of a block, one byte each, 0 or 1, into a mask. Vectorised loops write flags as bytes. */
static inline uint64_t slots_pack_flags(const uint8_t flags[SLOTS_BLOCK])
{
    uint64_t m = 0;

    for (int i = 0; i < 8; i++)
        m |= (bytes_get64(flags + 8 * i) * 0x0102040810204080u >> 56) << 8 * i;
    return m;
}

/* Save and restore snapshots of the columns (the struct itself is copied with the board). Return the snapshot's bytes,
 * a multiple of 64. With buf NULL, slots_save only counts them. */
size_t slots_save(const struct chip *chip, const void *self, uint8_t *buf);
size_t slots_restore(const struct chip *chip, void *self, const uint8_t *buf);

#endif
