/*
 * tasks.c - see tasks.h. The slots are linked in order of serials, so starting or ending a task takes constant time.
 */
#include "tasks.h"
#include <lauxlib.h>
#include <string.h>
#include "../machine/machine.h"
#include "vm.h"

static const char threads_key = 0; /* registry: slot + 1 -> thread; -slot - 1 -> the string that `origin` points to */

static const uint32_t NO_TASK = UINT32_MAX;

/* Links the tasks i and k, which may be NO_TASK, as neighbours. */
static void link_tasks(struct tasks *t, uint32_t i, uint32_t k)
{
    *(i == NO_TASK ? &t->first : &t->next[i]) = k;
    *(k == NO_TASK ? &t->last : &t->prev[k]) = i;
}

void tasks_init(struct tasks *t)
{
    t->first = t->last = NO_TASK;
    t->current = NO_SLOT;
}

/* Limits a chain of owners to MAX_OWNER_DEPTH, because each turn of a task checks all its owners. */
static void check_depth(struct board *b, int64_t owner)
{
    int depth = 0;

    for (int64_t h = owner; h && handle_kind(h) == H_TASK; h = b->tasks.owner[handle_slot(h)]) {
        if (!slots_has(&b->tasks.s, handle_slot(h), handle_gen(h)))
            return;
        if (++depth > MAX_OWNER_DEPTH)
            vm_fault(b->vm.running, FAULT_SCRIPT, "tasks and scopes nested more than %d deep", MAX_OWNER_DEPTH);
    }
}

/* Returns the scene of a task with this owner. Bullets, shots and lasers belong to no scene, so their tasks get the
 * scene of the script that starts the task. */
static int64_t scene_for_owner(const struct board *b, int64_t owner)
{
    uint32_t i = handle_slot(owner);

    if (!owner || !board_is_readable(b, owner))
        return 0;
    switch (handle_kind(owner)) {
    case H_TASK:
        return b->tasks.flags[i] & TASK_SCENE ? owner : b->tasks.scene[i];
    case H_ENEMY:
        return b->enemies.owner[i];
    case H_SPRITE:
        return b->sprites.owner[i];
    case H_LINE:
        return b->lines.owner[i];
    case H_BULLET:
    case H_SHOT:
    case H_LASER:
        return b->tasks.current_scene;
    default:
        return 0;
    }
}

static int32_t take_task(struct board *b, int64_t owner, uint8_t flags)
{
    struct tasks *t = &b->tasks;

    check_depth(b, owner);
    const int32_t i = board_take_slot(b, &t->s);
    if (i == NO_SLOT)
        return i;
    t->serial[i] = ++t->serial_count;
    t->owner[i] = owner;
    t->scene[i] = scene_for_owner(b, owner);
    t->wait[i] = 0;
    t->flags[i] = flags;
    t->born[i] = b->core.clock;
    t->thread[i] = NULL;
    t->origin[i] = NULL;
    link_tasks(t, t->last, (uint32_t)i);
    link_tasks(t, (uint32_t)i, NO_TASK);
    script_update_digest(b, (uint64_t)t->serial[i] << 8 | 0x51);
    return i;
}

static void drop_task(struct board *b, lua_State *L, uint32_t i)
{
    vm_push_registry_table(L, &threads_key);
    lua_pushnil(L);
    lua_rawseti(L, -2, (lua_Integer)i + 1);
    if (b->tasks.origin[i]) {
        lua_pushnil(L);
        lua_rawseti(L, -2, -(lua_Integer)i - 1);
    }
    lua_pop(L, 1);
    script_update_digest(b, (uint64_t)b->tasks.serial[i] << 8 | 0x52);
    link_tasks(&b->tasks, b->tasks.prev[i], b->tasks.next[i]);
    player_end_task(&b->player, b->tasks.serial[i]);
    slots_drop(&b->tasks.s, i);
}

/* If the function at stack index `at` is from @std, stores the author's line that starts it as task i. The table of
 * threads is on top of the stack. */
static void store_origin(struct board *b, lua_State *L, int at, uint32_t i)
{
    char location[VM_LOCATION_SIZE];
    lua_Debug ar;

    lua_pushvalue(L, at);
    if (!lua_getinfo(L, ">S", &ar) || strncmp(ar.source, "@@std/", 6))
        return;
    vm_get_location(L, location, sizeof location);
    if (!location[0] || !strncmp(location, "@std/", 5))
        return;
    b->tasks.origin[i] = lua_pushstring(L, location);
    lua_rawseti(L, -2, -(lua_Integer)i - 1);
}

int64_t tasks_start(struct board *b, lua_State *L, int64_t owner, int n)
{
    vm_charge(L, WORK_TASK);
    int32_t i = take_task(b, owner, TASK_RUNS);
    if (i == NO_SLOT) {
        lua_pop(L, n + 1);
        return board_handle(b, H_TASK, NO_SLOT);
    }
    luaL_checkstack(L, 4, "too many arguments");
    int f = lua_gettop(L) - n;
    vm_push_registry_table(L, &threads_key);
    store_origin(b, L, f, (uint32_t)i);
    lua_State *co = lua_newthread(L);
    lua_rawseti(L, -2, (lua_Integer)i + 1);
    lua_pop(L, 1);
    if (!lua_checkstack(co, n + 1))
        vm_fault(L, FAULT_SCRIPT, "too many arguments");
    lua_xmove(L, co, n + 1);
    b->tasks.thread[i] = co;
    return board_handle(b, H_TASK, i);
}

/* A dead owner gets a dead scope: a new scope could reuse the owner's slot and generation, and would then own
 * itself. */
int64_t tasks_new_scope(struct board *b, int64_t owner, bool is_scene)
{
    if (!tasks_is_owner_alive(b, owner))
        return board_handle(b, H_TASK, NO_SLOT);
    return board_handle(b, H_TASK, take_task(b, owner, is_scene ? TASK_SCOPE | TASK_SCENE : TASK_SCOPE));
}

void tasks_stop(struct board *b, uint32_t slot)
{
    uint8_t old_flags = b->tasks.flags[slot];

    b->tasks.flags[slot] |= TASK_STOP;
    if (!(old_flags & TASK_SCENE) || old_flags & TASK_STOP)
        return;
    vm_charge(b->vm.running, b->enemies.s.live + b->sprites.s.live);
    int64_t h = board_handle(b, H_TASK, (int32_t)slot);
    enemies_drop_owned(&b->enemies, h);
    slots_drop_where(&b->sprites.s, b->sprites.owner, h);
    if (b->lines.s.live)
        slots_drop_where(&b->lines.s, b->lines.owner, h);
}

static bool is_owned_by(const struct board *b, uint32_t i, int64_t scope)
{
    for (int64_t h = board_handle(b, H_TASK, (int32_t)i); h; h = b->tasks.owner[handle_slot(h)]) {
        if (h == scope)
            return true;
        if (handle_kind(h) != H_TASK || !slots_has(&b->tasks.s, handle_slot(h), handle_gen(h)))
            return false;
    }
    return false;
}

bool tasks_is_frozen(const struct board *b, uint32_t slot)
{
    return b->core.frozen > 0 && !is_owned_by(b, slot, b->core.frozen);
}

/* Returns whether the task belongs, directly or through other tasks, to an entity that was frozen in the last move.
 * An entity's moves alternate with its tasks' turns, so each frozen move skips one turn, no matter what froze the
 * entity or when. All owners must be alive. */
static bool owner_was_frozen(const struct board *b, uint32_t slot)
{
    int64_t h = b->tasks.owner[slot];

    if (!(b->bullets.n_frozen | b->shots.n_frozen | b->enemies.n_frozen | b->laser_heads.n_frozen))
        return false;
    while (h && handle_kind(h) == H_TASK)
        h = b->tasks.owner[handle_slot(h)];
    switch (h ? handle_kind(h) : H_TASK) {
    case H_BULLET:
        return b->bullets.freeze_flags[handle_slot(h)] & FREEZE_LAST_MOVE;
    case H_SHOT:
        return b->shots.freeze_flags[handle_slot(h)] & FREEZE_LAST_MOVE;
    case H_ENEMY:
        return b->enemies.freeze_flags[handle_slot(h)] & FREEZE_LAST_MOVE;
    case H_LASER:
        return b->laser_heads.freeze_flags[handle_slot(h)] & FREEZE_LAST_MOVE;
    default:
        return false;
    }
}

/* Turns a task's error into the board's fault, which ends the run. */
static void raise_task_fault(struct board *b, lua_State *L, lua_State *co, int status)
{
    vm_report_fault(b, co, status);
    b->tasks.current = NO_SLOT;
    if (status != LUA_ERRMEM)
        vm_add_traceback(b, L, co);
    lua_pushliteral(L, "a task failed");
    lua_error(L);
}

/* Closes a task's to-be-closed variables. */
static void close_task(struct board *b, lua_State *L, uint32_t i)
{
    lua_State *co = b->tasks.thread[i];

    if (!co || !(b->tasks.flags[i] & TASK_BEGUN))
        return;
    tasks_set_task_context(b, i);
    const uint32_t until_check = vm_enter(b, co);
    int status = lua_resetthread(co);
    vm_leave(b, L, until_check);
    tasks_set_context(b, (struct tasks_context){ 0, 0 });
    if (status != LUA_OK)
        raise_task_fault(b, L, co, status);
}

/* Resumes a task. Returns whether it has ended. */
static bool resume_task(struct board *b, lua_State *L, uint32_t i)
{
    struct tasks *t = &b->tasks;
    lua_State *co = t->thread[i];
    int results, n = t->flags[i] & TASK_BEGUN ? 0 : lua_gettop(co) - 1;

    t->flags[i] |= TASK_BEGUN;
    t->current = (int32_t)i;
    t->skipped_waits = 0;
    tasks_set_task_context(b, i);
    const uint32_t until_check = vm_enter(b, co);
    int status = lua_resume(co, L, n, &results);
    vm_leave(b, L, until_check);
    tasks_set_context(b, (struct tasks_context){ 0, 0 });
    if (status != LUA_OK && status != LUA_YIELD)
        raise_task_fault(b, L, co, status); /* reads tasks.current */
    t->current = NO_SLOT;
    if (status == LUA_OK)
        return true;
    lua_pop(co, results);
    script_update_digest(b, (uint64_t)t->serial[i] << 8 | 0x53);
    script_update_digest(b, (uint64_t)t->wait[i]);
    return false;
}

/* Gives a task its turn. Returns whether it has ended. */
static bool run_task_turn(struct board *b, lua_State *L, uint32_t i)
{
    struct tasks *t = &b->tasks;

    if (!tasks_is_owner_alive(b, t->owner[i]))
        tasks_stop(b, i);
    if (t->flags[i] & TASK_STOP) {
        close_task(b, L, i);
        return true;
    }
    if (t->flags[i] & TASK_SCOPE || tasks_is_frozen(b, i) || owner_was_frozen(b, i))
        return false;
    if (t->wait[i] > 0 && --t->wait[i] > 0)
        return false;
    if (resume_task(b, L, i))
        return true;
    if (t->flags[i] & TASK_STOP) /* the task stopped itself: close it now */
        close_task(b, L, i);
    return t->flags[i] & TASK_STOP;
}

int tasks_run(lua_State *L)
{
    struct board *b = vm_board(L);
    uint32_t next;

    for (uint32_t i = b->tasks.first; i != NO_TASK; i = next) {
        bool ended = run_task_turn(b, L, i);
        next = b->tasks.next[i]; /* read after the turn, which may have started tasks */
        if (ended)
            drop_task(b, L, i);
    }
    slots_trim(&b->tasks.s);
    return 0;
}

void tasks_run_turn(struct board *b, lua_State *L, uint32_t slot)
{
    struct tasks *t = &b->tasks;
    const int32_t current = t->current;
    const uint32_t skipped = t->skipped_waits;
    const struct tasks_context saved = { t->current_owner, t->current_scene };
    lua_State *running = b->vm.running;

    if (run_task_turn(b, L, slot))
        drop_task(b, L, slot);
    t->current = current;
    t->skipped_waits = skipped;
    tasks_set_context(b, saved);
    b->vm.running = running;
}
