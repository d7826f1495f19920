/*
 * hashes.c - state hashes: of one part, of all parts combined, and cached for every frame.
 *
 * A part is hashed value by value. Most of a board's values are in lists that seldom change (nvram, kinds, motions,
 * text, colours). To hash every frame, a cache stores a copy of the lists' bytes: a list that equals its copy still has
 * the hash computed for the copy. If only padding differs, the list is rehashed needlessly, but correctly.
 */
#include <string.h>
#include "../base/hash.h"
#include "../machine/machine.h"

/* Returns whether part i has nothing to hash in slots and may be absent: it is one of the parts added after the first
 * FIRST_OPTIONAL_PART, it has no live slot, and it either has no capacity (the chip has only registers, or the game
 * reserves no slots) or is the list of registers that ships and the run declare. */
static bool may_be_absent(const struct board *b, int i)
{
    const struct slots *s = part_of(b, i);

    return i >= FIRST_OPTIONAL_PART && !s->live && (!s->cap || s == &b->registers.s);
}

/* Returns whether part i is absent: may_be_absent, with all registers 0. The hash of an absent part is 0 and is left
 * out of the combined hash, so adding a chip to the board only changes the hashes of games that use it. */
static bool is_absent(const struct board *b, int i)
{
    const struct chip *chip = machine_parts[i].chip;

    return may_be_absent(b, i) && (!chip->columns[0].is_register || slots_registers_are_zero(chip, part_of(b, i)));
}

uint64_t board_part_hash(const struct board *b, int i)
{
    if (is_absent(b, i))
        return 0;
    return slots_hash(machine_parts[i].chip, part_of(b, i));
}

void board_hashes(const struct board *b, uint64_t out[MAX_PARTS])
{
    for (int i = 0; i < PART_COUNT; i++)
        out[i] = board_part_hash(b, i);
}

uint64_t board_combine_hashes(const uint64_t hashes[MAX_PARTS])
{
    uint64_t h = HASH_START;

    for (int i = 0; i < PART_COUNT; i++)
        if (!machine_parts[i].chip->unhashed && !(i >= FIRST_OPTIONAL_PART && !hashes[i]))
            h = hash_fold(h, hashes[i]);
    return h;
}

uint64_t board_hash(const struct board *b)
{
    uint64_t hashes[MAX_PARTS];

    board_hashes(b, hashes);
    return board_combine_hashes(hashes);
}

/* The context of visit_renamed, which passes each value on to `visit`, replacing the names of value columns by those
 * that the game declared. */
struct rename_context {
    const struct board *b;
    enum name_kind name_kind;
    slots_visitor *visit;
    void *context;
};

static void visit_renamed(void *context, const struct slots_value *v)
{
    const struct rename_context *r = context;
    struct slots_value copy = *v;
    const char *name = NULL;

    if (!strncmp(v->column, "value", 5) && v->column[5] >= '1' && v->column[5] < '1' + MAX_VALUES)
        name = board_name(r->b, r->name_kind, v->column[5] - '1');
    copy.column = name ? name : v->column;
    r->visit(r->context, &copy);
}

void board_trace(const struct board *b, int i, slots_visitor *visit, void *context)
{
    const struct chip *chip = machine_parts[i].chip;
    const enum name_kind name_kind = chip == &bullets_chip ? N_BULLET_VALUE
                                     : chip == &shots_chip ? N_SHOT_VALUE
                                                           : N_ENEMY_VALUE;
    struct rename_context r = { b, name_kind, visit, context };

    if (is_absent(b, i))
        return;
    if (chip == &bullets_chip || chip == &shots_chip || chip == &enemies_chip)
        slots_visit_values(chip, part_of(b, i), visit_renamed, &r);
    else
        slots_visit_values(chip, part_of(b, i), visit, context);
}

/* Returns the bytes of part i's copy: its struct, and its columns at full capacity. 0: the part is not a list, or
 * may_be_absent. */
static size_t copy_size(const struct board *b, int i)
{
    const struct slots *s = part_of(b, i);

    return machine_parts[i].chip->is_list && !may_be_absent(b, i)
               ? machine_parts[i].size + (size_t)slots_size(machine_parts[i].chip, s->cap, s->groups)
               : 0;
}

size_t board_hash_cache_size(const struct board *b)
{
    size_t sum = 0, largest = 0;

    for (int i = 0; i < PART_COUNT; i++) {
        size_t n = copy_size(b, i);
        sum += n;
        largest = n > largest ? n : largest;
    }
    return sum + largest;
}

/* Returns whether the bytes of list i equal its copy; if not, updates the copy. scratch: copy_size bytes. */
static bool update_copy(const struct board *b, int i, uint8_t *copy, uint8_t *scratch)
{
    size_t n = machine_parts[i].size;

    memcpy(scratch, part_of(b, i), n);
    n += slots_save(machine_parts[i].chip, part_of(b, i), scratch + n);
    if (memcmp(scratch, copy, n) == 0)
        return true;
    memcpy(copy, scratch, n);
    return false;
}

void board_hashes_cached(const struct board *b, void *cache, uint64_t hashes[MAX_PARTS])
{
    uint8_t *copy = cache, *scratch = copy;

    for (int i = 0; i < PART_COUNT; i++)
        scratch += copy_size(b, i);
    for (int i = 0; i < PART_COUNT; i++) {
        if (is_absent(b, i))
            hashes[i] = 0;
        else if (!machine_parts[i].chip->is_list || may_be_absent(b, i) || !update_copy(b, i, copy, scratch))
            hashes[i] = board_part_hash(b, i);
        copy += copy_size(b, i);
    }
}
