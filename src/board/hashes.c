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

static const uint8_t *chip_at(const struct board *b, int i)
{
    return (const uint8_t *)b + machine_parts[i].at;
}

/* Returns whether part i has nothing to hash in slots and may be absent: it is one of the parts added after the first
 * PARTS_ALWAYS, it has no live slot, and it either has no capacity (the chip has only registers, or the game reserves
 * no slots) or is the list of registers that ships and the run declare. */
static bool is_roomless(const struct board *b, int i)
{
    const struct slots *s = (const struct slots *)chip_at(b, i);

    return i >= PARTS_ALWAYS && !s->live && (!s->cap || s == &b->registers.s);
}

/* Returns whether part i is absent: is_roomless, with all registers 0. The hash of an absent part is 0 and is left out
 * of the combined hash, so adding a chip to the board only changes the hashes of games that use it. */
static bool is_absent(const struct board *b, int i)
{
    const struct chip *chip = machine_parts[i].chip;

    return is_roomless(b, i) && (!chip->columns[0].reg || slots_blank(chip, chip_at(b, i)));
}

uint64_t board_part_hash(const struct board *b, int i)
{
    if (is_absent(b, i))
        return 0;
    return slots_hash(machine_parts[i].chip, chip_at(b, i));
}

void board_hashes(const struct board *b, uint64_t out[MAX_PARTS])
{
    for (int i = 0; i < PARTS; i++)
        out[i] = board_part_hash(b, i);
}

uint64_t board_hash_of(const uint64_t hashes[MAX_PARTS])
{
    uint64_t h = HASH_START;

    for (int i = 0; i < PARTS; i++)
        if (!machine_parts[i].chip->unhashed && !(i >= PARTS_ALWAYS && !hashes[i]))
            h = hash_fold(h, hashes[i]);
    return h;
}

uint64_t board_hash(const struct board *b)
{
    uint64_t hashes[MAX_PARTS];

    board_hashes(b, hashes);
    return board_hash_of(hashes);
}

/* The context of visit_renamed, which passes each value on to `visit`, replacing the names of value columns by those
 * that the game declared. */
struct renamed {
    const struct board *b;
    enum name_kind names;
    slots_visit *visit;
    void *context;
};

static void visit_renamed(void *context, const struct slots_value *v)
{
    const struct renamed *r = context;
    struct slots_value own = *v;
    const char *name = NULL;

    if (!strncmp(v->column, "value", 5) && v->column[5] >= '1' && v->column[5] < '1' + MAX_VALUES)
        name = board_name(r->b, r->names, v->column[5] - '1');
    own.column = name ? name : v->column;
    r->visit(r->context, &own);
}

void board_trace(const struct board *b, int i, slots_visit *visit, void *context)
{
    const struct chip *chip = machine_parts[i].chip;
    const enum name_kind names = chip == &bullets_chip ? N_BULLET_VALUE
                                 : chip == &shots_chip ? N_SHOT_VALUE
                                                       : N_ENEMY_VALUE;
    struct renamed r = { b, names, visit, context };

    if (is_absent(b, i))
        return;
    if (chip == &bullets_chip || chip == &shots_chip || chip == &enemies_chip)
        slots_values(chip, chip_at(b, i), visit_renamed, &r);
    else
        slots_values(chip, chip_at(b, i), visit, context);
}

/* Returns the bytes of part i's copy: its struct, and its columns at full capacity. 0: the part is not a list, or
 * is_roomless. */
static size_t copy_size(const struct board *b, int i)
{
    const struct slots *s = (const struct slots *)chip_at(b, i);

    return machine_parts[i].chip->list && !is_roomless(b, i)
               ? machine_parts[i].size + (size_t)slots_size(machine_parts[i].chip, s->cap, s->groups)
               : 0;
}

size_t board_hash_cache_size(const struct board *b)
{
    size_t sum = 0, most = 0;

    for (int i = 0; i < PARTS; i++) {
        size_t n = copy_size(b, i);
        sum += n;
        most = n > most ? n : most;
    }
    return sum + most;
}

/* Returns whether the bytes of list i equal its copy; if not, updates the copy. room: scratch of copy_size bytes. */
static bool same(const struct board *b, int i, uint8_t *copy, uint8_t *room)
{
    size_t n = machine_parts[i].size;

    memcpy(room, chip_at(b, i), n);
    n += slots_save(machine_parts[i].chip, chip_at(b, i), room + n);
    if (memcmp(room, copy, n) == 0)
        return true;
    memcpy(copy, room, n);
    return false;
}

void board_hashes_cached(const struct board *b, void *cache, uint64_t hashes[MAX_PARTS])
{
    uint8_t *copy = cache, *room = copy;

    for (int i = 0; i < PARTS; i++)
        room += copy_size(b, i);
    for (int i = 0; i < PARTS; i++) {
        if (is_absent(b, i))
            hashes[i] = 0;
        else if (!machine_parts[i].chip->list || is_roomless(b, i) || !same(b, i, copy, room))
            hashes[i] = board_part_hash(b, i);
        copy += copy_size(b, i);
    }
}
