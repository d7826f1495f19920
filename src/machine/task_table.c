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
    DERIVED_COLUMN(tasks, thread, "refers to a thread in the registry"),
    DERIVED_COLUMN(tasks, origin, "refers to a string in the registry"),
    DERIVED_COLUMN(tasks, next, "links the live slots in the order of their serials"),
    DERIVED_COLUMN(tasks, prev, "links the live slots in the order of their serials"),
    DERIVED_REGISTER(tasks, first, "the live slot with the lowest serial"),
    DERIVED_REGISTER(tasks, last, "the live slot with the highest serial"),
    REGISTER(tasks, serial_count),
    DERIVED_REGISTER(tasks, current, "NO_SLOT between frames"),
    DERIVED_REGISTER(tasks, skipped_waits, "0 when a turn begins"),
    DERIVED_REGISTER(tasks, current_owner, "0 between frames"),
    DERIVED_REGISTER(tasks, current_scene, "0 between frames"),
};

const struct chip tasks_chip = { .name = "tasks", CHIP_COLUMNS(columns) };

bool tasks_is_owner_alive(const struct board *b, int64_t owner)
{
    return !owner || board_is_alive(b, owner);
}

/* A loop rather than recursion: a chain of owners may contain MAX_OWNER_DEPTH tasks. */
bool tasks_is_alive(const struct board *b, uint32_t slot, uint32_t gen)
{
    const struct tasks *t = &b->tasks;

    while (slots_has(&t->s, slot, gen) && !(t->flags[slot] & TASK_STOP)) {
        int64_t owner = t->owner[slot];
        if (!owner || handle_kind(owner) != H_TASK)
            return tasks_is_owner_alive(b, owner);
        slot = handle_slot(owner);
        gen = handle_gen(owner);
    }
    return false;
}

const char *tasks_origin(const struct board *b, const struct lua_State *L)
{
    const struct tasks *t = &b->tasks;

    return t->current != NO_SLOT && t->thread[t->current] == L ? t->origin[t->current] : NULL;
}

bool tasks_get_spawn_owner(const struct board *b, bool outlives_scene, int64_t *owner)
{
    *owner = outlives_scene ? 0 : b->tasks.current_scene;
    return tasks_is_owner_alive(b, *owner);
}

struct tasks_context tasks_enter_scene(struct board *b, int64_t scene)
{
    struct tasks_context was = { b->tasks.current_owner, b->tasks.current_scene };

    /* entities spawned by an enemy without a scene must not end with the scene of its killer */
    tasks_set_context(b, (struct tasks_context){ scene ? scene : was.scene ? 0 : was.owner, scene });
    return was;
}

void tasks_set_context(struct board *b, struct tasks_context context)
{
    b->tasks.current_owner = context.owner;
    b->tasks.current_scene = context.scene;
}

void tasks_set_task_context(struct board *b, uint32_t i)
{
    tasks_set_context(b, (struct tasks_context){ b->tasks.owner[i], b->tasks.scene[i] });
}

void tasks_restore_context(struct board *b)
{
    if (b->tasks.current == NO_SLOT)
        tasks_set_context(b, (struct tasks_context){ 0, 0 });
    else
        tasks_set_task_context(b, (uint32_t)b->tasks.current);
}

uint32_t tasks_current_serial(const struct board *b)
{
    return b->tasks.current == NO_SLOT ? 0 : b->tasks.serial[b->tasks.current];
}
