/*
 * task_table.c - see task_table.h.
 */
#include "machine.h"

static const struct column columns[] = {
    COLUMN(tasks, serial),
    COLUMN(tasks, owner),
    COLUMN(tasks, scene),
    COLUMN(tasks, wait),
    COLUMN(tasks, flags),
    COLUMN(tasks, born),
    DERIVED(tasks, thread, "refers to a thread in the registry"),
    DERIVED(tasks, from, "refers to a string in the registry"),
    DERIVED(tasks, next, "links the live slots in the order of their serials"),
    DERIVED(tasks, prev, "links the live slots in the order of their serials"),
    DERIVED_REGISTER(tasks, first, "the live slot with the lowest serial"),
    DERIVED_REGISTER(tasks, last, "the live slot with the highest serial"),
    REGISTER(tasks, serials),
    DERIVED_REGISTER(tasks, current, "NO_SLOT between frames"),
    DERIVED_REGISTER(tasks, skipped, "0 when a turn begins"),
    DERIVED_REGISTER(tasks, now_owner, "0 between frames"),
    DERIVED_REGISTER(tasks, now_scene, "0 between frames"),
};

const struct chip tasks_chip = { "tasks", columns, sizeof columns / sizeof *columns, false, false };

bool tasks_owner_alive(const struct board *b, int64_t owner)
{
    return !owner || board_alive(b, owner);
}

/* A chain of owners can be as long as the pool is large: no recursion. */
bool tasks_alive(const struct board *b, uint32_t slot, uint32_t gen)
{
    const struct tasks *t = &b->tasks;

    while (slots_has(&t->s, slot, gen) && !(t->flags[slot] & TASK_STOP)) {
        int64_t owner = t->owner[slot];
        if (!owner || handle_kind(owner) != H_TASK)
            return tasks_owner_alive(b, owner);
        slot = handle_slot(owner);
        gen = handle_gen(owner);
    }
    return false;
}
