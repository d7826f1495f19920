/*
 * heap.c - see heap.h. There are two layers. Small allocations (up to 512 bytes) are served by size class from 4 KiB
 * slabs: such a block has no header, its slab is found from its offset, and a bitmap of pages marks the slabs. All
 * other memory, including the slabs themselves, is blocks of 16-byte units with an 8-byte header, coalesced immediately
 * and found by two-level segregated fit (Masmano, Ripoll, Crespo, Real: TLSF, 2004), so every call is O(1) except for
 * copying. If no free block fits, a new one is cut from untouched memory above `top`.
 *
 * Positions are unit numbers (byte offset / 16), not pointers: they are half the size and do not depend on the heap's
 * address. A block is identified by the unit of its payload; its header is the 8 bytes before the payload. So payloads
 * are aligned, a block of n units has 16n-8 bytes, and slabs, whose payloads start at multiples of 4096, lie back to
 * back.
 */
#include "heap.h"

#include <assert.h>
#include <string.h>
#include "bits.h"

enum {
    UNIT_BYTES = HEAP_ALIGN,
    MAX_SMALL_BYTES = 512, /* the largest size that is allocated from a slab */
    CLASS_COUNT = 16,
    PAGE_BYTES = 4096,
    PAGE_UNITS = PAGE_BYTES / UNIT_BYTES,
    SLAB_BYTES = PAGE_BYTES - 8, /* the last 8 bytes are the next block's header */
    ROW_COUNT = 26,              /* row 0: sizes 0..15 units; row r: 2^(r+3) <= size < 2^(r+4), in 16 steps */
    COLUMNS_PER_ROW = 16
};

struct heap {
    size_t size; /* of the heap's memory, in bytes */
    size_t used;
    uint64_t work;
    uint32_t first;      /* the first block */
    uint32_t top;        /* where the next block would be */
    uint32_t limit;      /* top's highest value */
    uint32_t last_units; /* units of the block just below top; 0: none */
    uint32_t row_bits;   /* bit r: row r has a free block */
    uint16_t column_bits[ROW_COUNT];
    uint16_t pad;
    uint32_t partial_slabs[CLASS_COUNT]; /* slabs with free blocks, a list per class; 0: none */
    uint32_t bins[ROW_COUNT][COLUMNS_PER_ROW];
    uint32_t peak;        /* highest value of used; always below 2^32 */
    uint64_t slab_bits[]; /* bit p: page p is a slab */
};

struct block_header {
    uint32_t prev; /* units of the block below; 0: this is the first */
    uint32_t size; /* units << 1 | free */
};

/* At the start of a free block's payload. */
struct free_link {
    uint32_t next, prev;
};

/* At the start of a slab. Offsets are in bytes from the start of the slab. */
struct slab {
    uint32_t next, prev;
    uint16_t first_free;  /* first free block, 0: none; blocks are linked through their first two bytes */
    uint16_t unused_from; /* offset of the first block that was never used */
    uint16_t used;        /* live blocks */
    uint16_t class;
};

static const uint16_t class_bytes[CLASS_COUNT] = { 16,  32,  48,  64,  80,  96,  112, 128,
                                                   160, 192, 224, 256, 320, 384, 448, 512 };

/* Class by size in units, rounded up. */
static const uint8_t class_of[MAX_SMALL_BYTES / UNIT_BYTES + 1] = { 0,  0,  1,  2,  3,  4,  5,  6,  7,  8,  8,
                                                                    9,  9,  10, 10, 11, 11, 12, 12, 12, 12, 13,
                                                                    13, 13, 13, 14, 14, 14, 14, 15, 15, 15, 15 };

static void *unit_address(const struct heap *h, uint32_t unit)
{
    return (char *)(uintptr_t)h + (size_t)unit * UNIT_BYTES;
}

static struct block_header *block_header(const struct heap *h, uint32_t b)
{
    return (struct block_header *)unit_address(h, b) - 1;
}

static uint32_t units_of(const struct heap *h, uint32_t b)
{
    return block_header(h, b)->size >> 1;
}

static bool is_free(const struct heap *h, uint32_t b)
{
    return block_header(h, b)->size & 1;
}

static size_t offset_of(const struct heap *h, const void *p)
{
    return (size_t)((const char *)p - (const char *)h);
}

static bool is_in_slab(const struct heap *h, const void *p)
{
    size_t page = offset_of(h, p) / PAGE_BYTES;

    return h->slab_bits[page >> 6] >> (page & 63) & 1;
}

/* ---- blocks ---- */

struct bin_index {
    uint32_t row, column;
};

static struct bin_index bin_of(uint32_t units)
{
    if (units < COLUMNS_PER_ROW)
        return (struct bin_index){ 0, units };
    uint32_t log = bits_highest(units);
    return (struct bin_index){ log - 3, units >> (log - 4) & (COLUMNS_PER_ROW - 1) };
}

static void unlink_free(struct heap *h, uint32_t b)
{
    const struct free_link *l = unit_address(h, b);

    if (l->next)
        ((struct free_link *)unit_address(h, l->next))->prev = l->prev;
    if (l->prev) {
        ((struct free_link *)unit_address(h, l->prev))->next = l->next;
        return;
    }
    struct bin_index at_bin = bin_of(units_of(h, b));
    h->bins[at_bin.row][at_bin.column] = l->next;
    if (l->next)
        return;
    h->column_bits[at_bin.row] &= (uint16_t) ~(1u << at_bin.column);
    if (!h->column_bits[at_bin.row])
        h->row_bits &= ~(1u << at_bin.row);
}

static void link_free(struct heap *h, uint32_t b)
{
    struct bin_index p = bin_of(units_of(h, b));
    uint32_t *bin = &h->bins[p.row][p.column];
    struct free_link *l = unit_address(h, b);

    *l = (struct free_link){ *bin, 0 };
    if (*bin)
        ((struct free_link *)unit_address(h, *bin))->prev = b;
    *bin = b;
    h->column_bits[p.row] |= (uint16_t)(1u << p.column);
    h->row_bits |= 1u << p.row;
}

/* Sets b's size, and updates the copy of it in the block above or, if b is topmost, in h->last_units. */
static void set_size(struct heap *h, uint32_t b, uint32_t units, bool free)
{
    block_header(h, b)->size = units << 1 | free;
    if (b + units == h->top)
        h->last_units = units;
    else
        block_header(h, b + units)->prev = units;
}

/* Frees a block that is in no bin, and merges it with its free neighbours. */
static void free_block(struct heap *h, uint32_t b)
{
    uint32_t units = units_of(h, b), below = block_header(h, b)->prev;

    if (b + units != h->top && is_free(h, b + units)) {
        unlink_free(h, b + units);
        units += units_of(h, b + units);
    }
    if (below && is_free(h, b - below)) {
        b -= below;
        unlink_free(h, b);
        units += below;
    }
    set_size(h, b, units, true);
    link_free(h, b);
}

/* Shrinks b, which is in no bin, to `units`; frees the rest. */
static void trim(struct heap *h, uint32_t b, uint32_t units)
{
    uint32_t old_units = units_of(h, b);

    if (old_units == units) {
        block_header(h, b)->size = units << 1;
        return;
    }
    block_header(h, b)->size = units << 1;
    block_header(h, b + units)->prev = units;
    set_size(h, b + units, old_units - units, false);
    free_block(h, b + units);
}

/* Returns a free block of at least `units`, or 0. Every block in a bin above the bin for `units` fits; if all of these
 * are empty, only the first block of the bin for `units` is tried. */
static uint32_t find_free(const struct heap *h, uint32_t units)
{
    struct bin_index exact = bin_of(units), p = exact;
    uint32_t bits;

    if (units >= COLUMNS_PER_ROW && units & ((1u << (bits_highest(units) - 4)) - 1))
        p.column++;
    bits = p.column < COLUMNS_PER_ROW ? (uint32_t)h->column_bits[p.row] >> p.column << p.column : 0;
    if (!bits) {
        bits = h->row_bits & ~((2u << p.row) - 1);
        if (bits) {
            p.row = bits_lowest(bits);
            bits = h->column_bits[p.row];
        }
    }
    if (bits)
        return h->bins[p.row][bits_lowest(bits)];
    uint32_t b = h->bins[exact.row][exact.column];
    return b && units_of(h, b) >= units ? b : 0;
}

/* Moves top up by `units` and returns the new block, which is in no bin. The caller has checked the limit. */
static uint32_t extend_top(struct heap *h, uint32_t units)
{
    uint32_t b = h->top;

    block_header(h, b)->prev = h->last_units;
    h->top += units;
    set_size(h, b, units, false);
    return b;
}

/* Resizes the topmost block, which is in no bin, to `units`. Returns false if there is not enough memory. */
static bool resize_topmost(struct heap *h, uint32_t b, uint32_t units)
{
    if (units > h->limit - b)
        return false;
    h->top = b + units;
    set_size(h, b, units, false);
    return true;
}

static uint32_t alloc_block(struct heap *h, uint32_t units)
{
    uint32_t b = units < h->limit ? find_free(h, units) : 0;

    if (b) {
        unlink_free(h, b);
        trim(h, b, units);
        return b;
    }
    b = h->top - h->last_units;
    if (h->last_units && is_free(h, b)) {
        if (units > h->limit - b)
            return 0;
        unlink_free(h, b);
        resize_topmost(h, b, units);
        return b;
    }
    return units <= h->limit - h->top ? extend_top(h, units) : 0;
}

static bool holds_page(const struct heap *h, uint32_t b)
{
    uint32_t page = (b + PAGE_UNITS - 1) / PAGE_UNITS * PAGE_UNITS;

    return b && page + PAGE_UNITS <= b + units_of(h, b);
}

/* Returns a block of exactly one page, aligned to a page, or 0. */
static uint32_t alloc_page(struct heap *h)
{
    uint32_t b = find_free(h, PAGE_UNITS);

    if (!holds_page(h, b))
        b = find_free(h, 2 * PAGE_UNITS - 1);
    if (holds_page(h, b)) {
        unlink_free(h, b);
    } else {
        uint32_t padding = (0u - h->top) & (PAGE_UNITS - 1);
        if (padding + PAGE_UNITS > h->limit - h->top)
            return 0;
        b = extend_top(h, padding + PAGE_UNITS);
    }
    uint32_t padding = (0u - b) & (PAGE_UNITS - 1), total = units_of(h, b);
    if (padding) {
        block_header(h, b)->size = padding << 1;
        block_header(h, b + padding)->prev = padding;
        set_size(h, b + padding, total - padding, false);
        free_block(h, b);
        b += padding;
    }
    trim(h, b, PAGE_UNITS);
    return b;
}

/* ---- slabs ---- */

static void link_slab(struct heap *h, uint32_t page, struct slab *s)
{
    uint32_t *list = &h->partial_slabs[s->class];

    s->prev = 0;
    s->next = *list;
    if (*list)
        ((struct slab *)unit_address(h, *list))->prev = page;
    *list = page;
}

static void unlink_slab(struct heap *h, const struct slab *s)
{
    if (s->next)
        ((struct slab *)unit_address(h, s->next))->prev = s->prev;
    if (s->prev)
        ((struct slab *)unit_address(h, s->prev))->next = s->next;
    else
        h->partial_slabs[s->class] = s->next;
}

static void toggle_slab_bit(struct heap *h, uint32_t page)
{
    h->slab_bits[page / PAGE_UNITS >> 6] ^= (uint64_t)1 << (page / PAGE_UNITS & 63);
}

static struct slab *new_slab(struct heap *h, unsigned class)
{
    uint32_t page = alloc_page(h);

    if (!page)
        return NULL;
    struct slab *s = unit_address(h, page);
    *s = (struct slab){ .unused_from = sizeof *s, .class = (uint16_t) class };
    toggle_slab_bit(h, page);
    link_slab(h, page, s);
    return s;
}

static bool is_slab_full(const struct slab *s)
{
    return !s->first_free && s->unused_from + class_bytes[s->class] > SLAB_BYTES;
}

static void *alloc_small(struct heap *h, size_t size)
{
    unsigned class = class_of[(size + UNIT_BYTES - 1) / UNIT_BYTES];
    uint32_t page = h->partial_slabs[class];
    struct slab *s = page ? unit_address(h, page) : new_slab(h, class);

    if (!s)
        return NULL;
    char *p = (char *)s;
    if (s->first_free) {
        p += s->first_free;
        memcpy(&s->first_free, p, sizeof s->first_free);
    } else {
        p += s->unused_from;
        s->unused_from = (uint16_t)(s->unused_from + class_bytes[class]);
    }
    s->used++;
    if (is_slab_full(s))
        unlink_slab(h, s);
    return p;
}

static void free_slab(struct heap *h, uint32_t page)
{
    unlink_slab(h, unit_address(h, page));
    toggle_slab_bit(h, page);
    free_block(h, page);
}

static bool is_empty_slab(const struct heap *h, uint32_t page)
{
    return page && !((const struct slab *)unit_address(h, page))->used;
}

/* Frees a block in a slab. If a slab becomes empty and is the only one of its class with free blocks, it is kept, so
 * that allocating and freeing one block repeatedly does not make a new slab each time. So an empty slab is alone in its
 * list. */
static void free_small(struct heap *h, char *p)
{
    uint32_t page = (uint32_t)(offset_of(h, p) / PAGE_BYTES * PAGE_UNITS);
    struct slab *s = unit_address(h, page);
    bool was_full = is_slab_full(s);

    memcpy(p, &s->first_free, sizeof s->first_free);
    s->first_free = (uint16_t)(p - (char *)s);
    s->used--;
    if (was_full) {
        if (is_empty_slab(h, h->partial_slabs[s->class]))
            free_slab(h, h->partial_slabs[s->class]);
        link_slab(h, page, s);
    }
    if (!s->used && (s->next || s->prev))
        free_slab(h, page);
}

/* Frees the empty slabs that were kept (free_small); called when memory runs out. Returns whether there were any. */
static bool free_empty_slabs(struct heap *h)
{
    bool dropped = false;

    for (int c = 0; c < CLASS_COUNT; c++) {
        if (!is_empty_slab(h, h->partial_slabs[c]))
            continue;
        free_slab(h, h->partial_slabs[c]);
        dropped = true;
    }
    return dropped;
}

/* ---- Lua's allocator ---- */

static uint32_t units_for(size_t size)
{
    return (uint32_t)((size + sizeof(struct block_header) + UNIT_BYTES - 1) / UNIT_BYTES);
}

static void *try_alloc(struct heap *h, size_t size)
{
    if (size <= MAX_SMALL_BYTES)
        return alloc_small(h, size);
    uint32_t b = size < h->size ? alloc_block(h, units_for(size)) : 0;
    return b ? unit_address(h, b) : NULL;
}

static void update_peak(struct heap *h)
{
    if (h->used > h->peak)
        h->peak = (uint32_t)h->used;
}

static void *alloc(struct heap *h, size_t size)
{
    void *p = try_alloc(h, size);

    if (!p && free_empty_slabs(h))
        p = try_alloc(h, size);
    if (p) {
        h->used += size;
        h->work += size;
        update_peak(h);
    }
    return p;
}

static void release(struct heap *h, void *p, size_t old_size)
{
    h->used -= old_size;
    if (old_size <= MAX_SMALL_BYTES && is_in_slab(h, p))
        free_small(h, p);
    else
        free_block(h, (uint32_t)(offset_of(h, p) / UNIT_BYTES));
}

/* Resizes block b to `units` in place. Returns whether that was possible. */
static bool resize_block(struct heap *h, uint32_t b, uint32_t units)
{
    uint32_t old_units = units_of(h, b), above = b + old_units;

    if (units > old_units && above == h->top)
        return resize_topmost(h, b, units);
    if (units > old_units) {
        if (!is_free(h, above))
            return false;
        uint32_t above_units = units_of(h, above);
        bool is_topmost = above + above_units == h->top;
        if (old_units + above_units < units && (!is_topmost || units > h->limit - b))
            return false;
        unlink_free(h, above);
        set_size(h, b, old_units + above_units, false);
        if (old_units + above_units < units)
            return resize_topmost(h, b, units);
    }
    trim(h, b, units);
    return true;
}

/* Returns the capacity in bytes of the block p, or 0 if p is not in a slab. */
static size_t slab_block_size(const struct heap *h, const void *p, size_t old_size)
{
    if (old_size > MAX_SMALL_BYTES || !is_in_slab(h, p))
        return 0;
    const struct slab *s = unit_address(h, (uint32_t)(offset_of(h, p) / PAGE_BYTES * PAGE_UNITS));
    return class_bytes[s->class];
}

/* Resizes p in place and returns whether that was possible. A block in a slab that would be at most half full is not
 * resized in place, because it should move to a smaller class (if there is one). capacity: from slab_block_size. */
static bool resize_in_place(struct heap *h, void *p, size_t capacity, size_t size)
{
    if (capacity)
        return size <= capacity && (size > capacity / 2 || capacity == UNIT_BYTES);
    return size < h->size && resize_block(h, (uint32_t)(offset_of(h, p) / UNIT_BYTES), units_for(size));
}

static void *resize(struct heap *h, void *p, size_t old_size, size_t size)
{
    size_t capacity = slab_block_size(h, p, old_size);

    if (!resize_in_place(h, p, capacity, size)) {
        void *moved = alloc(h, size);
        if (moved) {
            memcpy(moved, p, old_size < size ? old_size : size);
            release(h, p, old_size);
            return moved;
        }
        if (size > capacity)
            return NULL;
    }
    h->used += size - old_size;
    h->work += size >= old_size ? size : 0;
    update_peak(h);
    return p;
}

void *heap_realloc(struct heap *h, void *p, size_t old_size, size_t size)
{
    if (!p)
        return size ? alloc(h, size) : NULL;
    if (size)
        return resize(h, p, old_size, size);
    release(h, p, old_size);
    return NULL;
}

struct heap *heap_init(void *block, size_t size)
{
    struct heap *h = block;
    size_t words = (size / PAGE_BYTES + 64) / 64, header = sizeof *h + words * sizeof h->slab_bits[0];

    assert((uintptr_t)block % HEAP_ALIGN == 0 && size >= HEAP_MIN && size - 1 <= UINT32_MAX);
    memset(h, 0, header);
    h->size = size;
    h->first = h->top = units_for(header);
    h->limit = (uint32_t)((size + sizeof(struct block_header)) / UNIT_BYTES);
    return h;
}

size_t heap_used(const struct heap *h)
{
    return h->used;
}

size_t heap_peak(const struct heap *h)
{
    return h->peak;
}

uint64_t heap_work(const struct heap *h)
{
    return h->work;
}

size_t heap_extent(const struct heap *h)
{
    return (size_t)h->top * UNIT_BYTES - sizeof(struct block_header);
}

/* ---- snapshots ---- */

/* The header of a section in a snapshot, followed by the section's bytes. bytes 0: the end of the snapshot. */
struct section {
    size_t offset, bytes;
};

enum { MIN_HOLE = 512 /* smallest free block, in bytes, that is left out of a snapshot */ };

/* Returns the next offset at or after `at` that equals `from` modulo 64: copying between addresses that
 * differ by a few bytes within the page is up to 16 times slower on some processors. */
static size_t match_alignment(size_t at, size_t from)
{
    return at + ((from - at) & 63);
}

static size_t save_section(const struct heap *h, char *buf, size_t at, size_t from, size_t to)
{
    struct section section = { from, to - from };
    size_t data = match_alignment(at + sizeof section, from);

    if (buf) {
        memcpy(buf + at, &section, sizeof section);
        memcpy(buf + data, (const char *)h + from, section.bytes);
    }
    return data + section.bytes;
}

/* Saves only the header and link of a free block of MIN_HOLE bytes or more. */
size_t heap_save(const struct heap *h, void *buf)
{
    const struct section end = { 0, 0 };
    size_t at = 0, from = 0;

    for (uint32_t b = h->first; b != h->top; b += units_of(h, b)) {
        size_t start = (size_t)b * UNIT_BYTES, size = (size_t)units_of(h, b) * UNIT_BYTES;
        if (!is_free(h, b) || size < MIN_HOLE)
            continue;
        at = save_section(h, buf, at, from, start + sizeof(struct free_link));
        from = start + size - sizeof(struct block_header);
    }
    if (from < heap_extent(h))
        at = save_section(h, buf, at, from, heap_extent(h));
    if (buf)
        memcpy((char *)buf + at, &end, sizeof end);
    return at + sizeof end;
}

size_t heap_restore(struct heap *h, const void *buf)
{
    const char *p = buf;
    struct section section;
    size_t at = 0;

    for (;;) {
        memcpy(&section, p + at, sizeof section);
        at += sizeof section;
        if (section.bytes == 0)
            return at;
        at = match_alignment(at, section.offset);
        memcpy((char *)h + section.offset, p + at, section.bytes);
        at += section.bytes;
    }
}

/* ---- checking ---- */

static bool check_slab(const struct heap *h, uint32_t page, size_t *capacity)
{
    const struct slab *s = unit_address(h, page);
    unsigned bytes = class_bytes[s->class], count = 0, listed = 0;

    for (uint16_t f = s->first_free; f; count++) {
        if (f >= s->unused_from || (f - sizeof *s) % bytes || count > SLAB_BYTES / UNIT_BYTES)
            return false;
        memcpy(&f, (const char *)s + f, sizeof f);
    }
    for (uint32_t p = h->partial_slabs[s->class]; p; p = ((const struct slab *)unit_address(h, p))->next)
        listed += p == page;
    *capacity += (size_t)s->used * bytes;
    if (!s->used && (s->next || s->prev))
        return false;
    return s->used + count == (s->unused_from - sizeof *s) / bytes && listed == !is_slab_full(s);
}

static bool is_listed(const struct heap *h, uint32_t b)
{
    struct bin_index p = bin_of(units_of(h, b));
    uint32_t before = 0;

    if (!(h->row_bits >> p.row & 1) || !(h->column_bits[p.row] >> p.column & 1))
        return false;
    for (uint32_t i = h->bins[p.row][p.column]; i;
         before = i, i = ((const struct free_link *)unit_address(h, i))->next) {
        if (((const struct free_link *)unit_address(h, i))->prev != before)
            return false;
        if (i == b)
            return true;
    }
    return false;
}

static bool check_bins(const struct heap *h, uint32_t free_blocks)
{
    uint32_t n = 0;

    for (uint32_t r = 0; r < ROW_COUNT; r++) {
        if (!h->column_bits[r] != !(h->row_bits >> r & 1))
            return false;
        for (uint32_t c = 0; c < COLUMNS_PER_ROW; c++) {
            if (!h->bins[r][c] != !(h->column_bits[r] >> c & 1))
                return false;
            for (uint32_t i = h->bins[r][c]; i; i = ((const struct free_link *)unit_address(h, i))->next)
                n++;
        }
    }
    return n == free_blocks;
}

bool heap_check(const struct heap *h)
{
    uint32_t prev = 0, free_blocks = 0, slabs = 0, marked = 0;
    size_t capacity = 0;
    bool was_free = false;

    if (h->top > h->limit)
        return false;
    for (uint32_t b = h->first; b != h->top; b += prev) {
        if (b > h->top || block_header(h, b)->prev != prev || !units_of(h, b) || (was_free && is_free(h, b)))
            return false;
        prev = units_of(h, b);
        was_free = is_free(h, b);
        free_blocks += was_free;
        if (was_free && !is_listed(h, b))
            return false;
        if (!was_free && b % PAGE_UNITS == 0 && is_in_slab(h, unit_address(h, b))) {
            if (prev != PAGE_UNITS || !check_slab(h, b, &capacity))
                return false;
            slabs++;
        } else if (!was_free) {
            capacity += (size_t)prev * UNIT_BYTES - sizeof(struct block_header);
        }
    }
    for (size_t w = 0; w < (h->size / PAGE_BYTES + 64) / 64; w++)
        for (uint64_t bits = h->slab_bits[w]; bits; bits &= bits - 1)
            marked++;
    return h->last_units == prev && marked == slabs && h->used <= capacity && check_bins(h, free_blocks);
}
