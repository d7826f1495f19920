/*
 * slots.c - see slots.h.
 */
#include "slots.h"
#include <assert.h>
#include <string.h>
#include "hash.h"
#include "int.h"

enum {
    MAX_COLUMNS = 64,   /* maximum number of columns of a chip */
    LONG_SECTION = 1024 /* sections of a snapshot with at least this many bytes are aligned */
};

static uint32_t round_to_blocks(uint32_t n)
{
    return (n + SLOTS_BLOCK - 1) / SLOTS_BLOCK * SLOTS_BLOCK;
}

/* Returns the number of values in a column with that many slots. If the column has values per block, `slots` must be a
 * multiple of SLOTS_BLOCK. */
static uint64_t value_count(const struct column *c, uint64_t slots)
{
    return (c->is_per_block ? slots / SLOTS_BLOCK : slots) * c->n;
}

/* Returns the number of slots that columns have space for: cap in a list, cap rounded up to whole blocks in a pool. */
static uint32_t slot_capacity(const struct chip *chip, uint32_t cap)
{
    return chip->is_list ? cap : round_to_blocks(cap);
}

uint64_t slots_size(const struct chip *chip, uint32_t cap, uint32_t groups)
{
    uint64_t capacity = slot_capacity(chip, cap), size = 0;

    if (!cap)
        return 0;
    if (!chip->is_list)
        size = int_align_cache_line(capacity / 8) + int_align_cache_line(capacity * 4);
    for (int i = 0; i < chip->count; i++)
        if (!chip->columns[i].is_register && slots_has_column(&chip->columns[i], groups))
            size += int_align_cache_line(value_count(&chip->columns[i], capacity) * chip->columns[i].width);
    return size;
}

static void *carve(uint8_t **next, uint64_t bytes)
{
    void *at = *next;

    *next += int_align_cache_line(bytes);
    return at;
}

void slots_layout(const struct chip *chip, void *self, uint32_t cap, uint32_t groups, uint8_t **next)
{
    struct slots *s = self;
    uint64_t capacity = slot_capacity(chip, cap);

    *s = (struct slots){ .cap = cap, .groups = groups, .reserved = cap };
    if (!chip->is_list) {
        s->live_bits = carve(next, capacity / 8);
        s->gen = carve(next, capacity * 4);
    }
    for (int i = 0; i < chip->count; i++) {
        const struct column *c = &chip->columns[i];
        void *at = (uint8_t *)self + c->offset;

        if (c->is_register)
            memset(at, 0, (size_t)c->width * c->n);
        else {
            void *column = slots_has_column(c, groups) ? carve(next, value_count(c, capacity) * c->width) : NULL;
            memcpy(at, &column, sizeof column);
        }
    }
}

static const uint8_t *column_at(const struct column *c, const void *self)
{
    const uint8_t *at;

    memcpy(&at, (const uint8_t *)self + c->offset, sizeof at);
    return at;
}

void slots_move(const struct chip *chip, void *self, uint32_t reserved, uint8_t *memory)
{
    struct slots *s = self;

    assert(chip->is_list && s->live <= reserved);
    for (int i = 0; i < chip->count; i++) {
        const struct column *c = &chip->columns[i];
        if (c->is_register || !slots_has_column(c, s->groups))
            continue;
        void *column = carve(&memory, value_count(c, reserved) * c->width);
        if (s->live)
            memcpy(column, column_at(c, self), (size_t)value_count(c, s->live) * c->width);
        memcpy((uint8_t *)self + c->offset, &column, sizeof column);
    }
    s->reserved = reserved;
}

void slots_copy_rows(const struct chip *chip, void *self, uint32_t to, uint32_t from, uint32_t n)
{
    const struct slots *s = self;
    uint8_t *column;

    for (int i = 0; i < chip->count; i++) {
        const struct column *c = &chip->columns[i];
        const size_t row_size = (size_t)c->n * c->width;
        if (c->is_register || c->is_per_block || !slots_has_column(c, s->groups))
            continue;
        memcpy(&column, (uint8_t *)self + c->offset, sizeof column);
        memmove(column + to * row_size, column + from * row_size, n * row_size);
    }
}

static bool raise_high_water(struct slots *s)
{
    if (s->high_water >= s->cap)
        return false;
    s->live_bits[s->high_water / 64] = 0;
    for (uint32_t i = s->high_water; i < s->high_water + SLOTS_BLOCK; i++)
        s->gen[i] = 1;
    s->high_water += SLOTS_BLOCK;
    return true;
}

/* Returns a mask of the slots in a block that are neither live nor held. The lowest one is never retired, but higher
 * ones may be. */
static uint64_t find_free_slots(const struct slots *s, uint32_t block)
{
    uint64_t free_slots = ~s->live_bits[block];

    if (block * 64 < s->held_top)
        free_slots &= ~s->held[block];
    while (free_slots && s->gen[block * 64 + bits_lowest(free_slots)] == RETIRED_GENERATION)
        free_slots &= free_slots - 1;
    return free_slots;
}

int32_t slots_take(struct slots *s)
{
    for (;; s->first_free_word++) {
        if (s->first_free_word * 64 == s->high_water && !raise_high_water(s))
            break;
        uint64_t free_slots = find_free_slots(s, s->first_free_word);
        if (!free_slots)
            continue;
        uint32_t i = s->first_free_word * 64 + bits_lowest(free_slots);
        if (i >= s->cap)
            break;
        s->live_bits[i / 64] |= 1ull << (i & 63);
        s->live++;
        if (i >= s->top)
            s->top = i / 64 * 64 + 64;
        return (int32_t)i;
    }
    s->refused++;
    return NO_SLOT;
}

int32_t slots_append(struct slots *s)
{
    if (s->live >= s->cap) {
        s->refused++;
        return NO_SLOT;
    }
    assert(s->live < s->reserved);
    return (int32_t)s->live++;
}

/* Makes slot i free for its next entity. */
static void vacate(struct slots *s, uint32_t i)
{
    s->gen[i]++;
    if (i / 64 < s->first_free_word)
        s->first_free_word = i / 64;
}

void slots_drop(struct slots *s, uint32_t i)
{
    assert(i < s->top && (s->live_bits[i / 64] >> (i & 63) & 1));
    s->live_bits[i / 64] &= ~(1ull << (i & 63));
    s->live--;
    vacate(s, i);
}

void slots_hold(struct slots *s, uint64_t *words, uint32_t i)
{
    assert(i < s->top && (s->live_bits[i / 64] >> (i & 63) & 1));
    if (!s->held_count) {
        s->held = words;
        s->held_top = s->top;
        memset(words, 0, s->top / 8);
    }
    s->live_bits[i / 64] &= ~(1ull << (i & 63));
    s->held[i / 64] |= 1ull << (i & 63);
    s->live--;
    s->held_count++;
}

void slots_release(struct slots *s, uint32_t i)
{
    assert(i < s->held_top && (s->held[i / 64] >> (i & 63) & 1));
    s->held[i / 64] &= ~(1ull << (i & 63));
    vacate(s, i);
    if (--s->held_count == 0) {
        s->held = NULL;
        s->held_top = 0;
    }
}

void slots_trim(struct slots *s)
{
    while (s->top && !s->held_count && !s->live_bits[s->top / 64 - 1])
        s->top -= SLOTS_BLOCK;
}

/* Returns the first slot at or after i whose bit is set, or top if there is none. */
static uint32_t next_bit(const uint64_t *words, uint32_t i, uint32_t top)
{
    while (i < top) {
        uint64_t bits = words[i / 64] >> (i & 63);
        if (bits)
            return i + bits_lowest(bits);
        i = i / 64 * 64 + 64;
    }
    return top;
}

uint32_t slots_next_held(const struct slots *s, uint32_t i)
{
    return next_bit(s->held, i, s->held_top);
}

uint32_t slots_next(const struct slots *s, uint32_t i)
{
    if (!s->live_bits)
        return i < s->live ? i : s->live;
    return next_bit(s->live_bits, i, s->top);
}

void slots_drop_where(struct slots *s, const int64_t *column, int64_t value)
{
    EACH_LIVE (i, s)
        if (column[i] == value)
            slots_drop(s, i);
    slots_trim(s);
}

static uint64_t value_at(const uint8_t *p, int width)
{
    uint16_t w2;
    uint32_t w4;
    uint64_t w8;

    switch (width) {
    case 1:
        return *p;
    case 2:
        memcpy(&w2, p, 2);
        return w2;
    case 4:
        memcpy(&w4, p, 4);
        return w4;
    default:
        memcpy(&w8, p, 8);
        return w8;
    }
}

static uint64_t fold_values(uint64_t h, const struct column *c, const uint8_t *p)
{
    for (int k = 0; k < c->n; k++)
        h = hash_fold(h, value_at(p + (size_t)k * c->width, c->width));
    return h;
}

static bool is_hashed_register(const struct column *c, uint32_t groups)
{
    return c->is_register && c->kind == COL_GAME && slots_has_column(c, groups);
}

/* The hashed columns, found once for all slots. */
struct hash_list {
    const struct column *column[MAX_COLUMNS];
    const uint8_t *values[MAX_COLUMNS];
    int n;
};

static void collect_hashed_columns(struct hash_list *h, const struct chip *chip, const void *self)
{
    const struct slots *s = self;

    assert(chip->count <= MAX_COLUMNS);
    h->n = 0;
    for (int c = 0; c < chip->count; c++) {
        const struct column *col = &chip->columns[c];
        if (col->is_register || col->kind != COL_GAME || !slots_has_column(col, s->groups))
            continue;
        h->column[h->n] = col;
        h->values[h->n++] = column_at(col, self);
    }
}

bool slots_registers_are_zero(const struct chip *chip, const void *self)
{
    const struct slots *s = self;

    for (int c = 0; c < chip->count; c++) {
        const struct column *col = &chip->columns[c];
        for (int k = 0; is_hashed_register(col, s->groups) && k < col->n; k++)
            if (value_at((const uint8_t *)self + col->offset + (size_t)k * col->width, col->width))
                return false;
    }
    return true;
}

uint64_t slots_hash(const struct chip *chip, const void *self)
{
    const struct slots *s = self;
    uint64_t h = hash_fold(hash_fold(HASH_START, s->live), s->refused);
    struct hash_list list;

    for (int c = 0; c < chip->count; c++)
        if (is_hashed_register(&chip->columns[c], s->groups))
            h = fold_values(h, &chip->columns[c], (const uint8_t *)self + chip->columns[c].offset);
    if (s->live == 0)
        return h;
    collect_hashed_columns(&list, chip, self);
    uint32_t end = s->live_bits ? s->top : s->live;
    for (uint32_t i = slots_next(s, 0); i < end; i = slots_next(s, i + 1)) {
        if (s->live_bits)
            h = hash_fold(h, (uint64_t)s->gen[i] << 32 | i);
        for (int c = 0; c < list.n; c++) {
            const struct column *col = list.column[c];
            h = fold_values(h, col, list.values[c] + (size_t)i * col->width * col->n);
        }
    }
    return h;
}

/* Visits the values of one column of a slot, or of one register, at p. */
static void visit_values(const struct column *c, const uint8_t *p, struct slots_value v, slots_visitor *visit,
                         void *context)
{
    v.column = c->name;
    v.width = c->width;
    v.n = c->n;
    for (v.i = 0; v.i < c->n; v.i++) {
        v.value = value_at(p + (size_t)v.i * c->width, c->width);
        visit(context, &v);
    }
}

static void visit_registers(const struct chip *chip, const void *self, slots_visitor *visit, void *context)
{
    const struct slots *s = self;
    struct slots_value v = { .slot = NO_SLOT, .n = 1, .width = sizeof s->live };

    v.column = "live";
    v.value = s->live;
    visit(context, &v);
    v.column = "refused";
    v.value = s->refused;
    visit(context, &v);
    for (int c = 0; c < chip->count; c++)
        if (is_hashed_register(&chip->columns[c], s->groups))
            visit_values(&chip->columns[c], (const uint8_t *)self + chip->columns[c].offset, v, visit, context);
}

void slots_visit_values(const struct chip *chip, const void *self, slots_visitor *visit, void *context)
{
    const struct slots *s = self;
    uint32_t end = s->live_bits ? s->top : s->live;

    visit_registers(chip, self, visit, context);
    for (uint32_t i = slots_next(s, 0); i < end; i = slots_next(s, i + 1)) {
        struct slots_value v = { .slot = i, .gen = s->live_bits ? s->gen[i] : 0 };
        for (int c = 0; c < chip->count; c++) {
            const struct column *col = &chip->columns[c];
            if (!col->is_register && col->kind == COL_GAME && slots_has_column(col, s->groups))
                visit_values(col, column_at(col, self) + (size_t)i * col->width * col->n, v, visit, context);
        }
    }
}

/* Copies the columns to `save` or from `restore`, or only counts if both are NULL. Returns the snapshot's bytes. Long
 * sections start at cache lines, as they do in RAM: copying between addresses that differ by a few bytes within the
 * page is up to 16 times slower on some processors. */
static size_t copy_columns(const struct chip *chip, const void *self, uint8_t *save, const uint8_t *restore)
{
    const struct slots *s = self;
    size_t at = 0;
    struct {
        uint8_t *p;
        size_t n;
    } section;

    if (!s->cap)
        return 0;
    for (int i = chip->is_list ? 0 : -2; i < chip->count; i++) {
        if (i == -2)
            section.p = (uint8_t *)s->live_bits, section.n = s->high_water / 8;
        else if (i == -1)
            section.p = (uint8_t *)s->gen, section.n = (size_t)s->high_water * 4;
        else if (chip->columns[i].is_register || !slots_has_column(&chip->columns[i], s->groups))
            continue;
        else {
            const struct column *c = &chip->columns[i];
            memcpy(&section.p, (const uint8_t *)self + c->offset, sizeof section.p);
            section.n = (size_t)value_count(c, chip->is_list ? s->live : s->top) * c->width;
        }
        if (section.n >= LONG_SECTION)
            at = (size_t)int_align_cache_line(at);
        if (save && section.n)
            memcpy(save + at, section.p, section.n);
        if (restore && section.n)
            memcpy(section.p, restore + at, section.n);
        at += section.n;
    }
    return (size_t)int_align_cache_line(at);
}

size_t slots_save(const struct chip *chip, const void *self, uint8_t *buf)
{
    return copy_columns(chip, self, buf, NULL);
}

size_t slots_restore(const struct chip *chip, void *self, const uint8_t *buf)
{
    return copy_columns(chip, self, NULL, buf);
}
