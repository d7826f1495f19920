/*
 * api_time.c - the Lua globals wait, task and on.
 */
#include "api_parts.h"
#include <string.h>
#include "../events_run.h"
#include "../../machine/sound.h"

/* Parameter indices; ARG_: the only parameter of its entry. */
enum { ARG_FRAMES = 0, ARG_OWNER = 0, ARG_TASK = 0, ARG_F = 0 };
enum { OWN_OWNER, OWN_F };

static const struct api_param wait_params[] = { PARAM("n", A_COUNT, REQ, 0, 1e9, "frames", NULL,
                                                      "number of frames; 0 continues immediately") };

int api_count_skipped_wait(lua_State *L, struct board *b)
{
    const bool runs_through = board_runs_through_stages(b),
               is_work_spent = runs_through && b->vm.work > b->vm.limit / 2;
    const uint32_t max_skips = runs_through && !board_is_listing(b) ? MAX_SEARCH_SKIPS : MAX_SKIPS;

    if (!tasks_is_skipping(&b->tasks) || (++b->tasks.skipped_waits <= max_skips && !is_work_spent))
        return 0;
    if (!runs_through || !lua_isyieldable(L))
        return api_error(L, "wait",
                         "more than %d waits while skipping to a mark (waiting for something that is skipped?)",
                         MAX_SKIPS);
    tasks_stop(b, (uint32_t)b->tasks.current);
    return lua_yield(L, 0);
}

static int wait_frames(lua_State *L, struct board *b, struct api_value *v)
{
    if (b->tasks.current == NO_SLOT)
        return api_error(L, "wait", "only a task can wait; start one with task.go");
    if (!lua_isyieldable(L))
        return api_error(
            L, "wait",
            "cannot wait inside a callback from C (bullet.each, table.sort, string.gsub, <close> and the like)");
    if (b->tasks.flags[b->tasks.current] & TASK_SKIPS) {
        if (b->music.is_skipping)
            vm_charge(L, sound_skip_wait(b, v[ARG_FRAMES].i));
        return api_count_skipped_wait(L, b);
    }
    if (!v[ARG_FRAMES].i)
        return 0;
    b->tasks.wait[b->tasks.current] = v[ARG_FRAMES].i;
    return lua_yield(L, 0);
}

static const struct api_param go_params[] = { REQUIRED(
    "f", A_FUNC, "f(...): body of the task; called with the remaining arguments") };
static const struct api_param own_params[] = {
    THING("owner", REQ, OWNER_HANDLE_KINDS, "thing or task whose end also ends the new task"),
    REQUIRED("f", A_FUNC, "f(owner, ...): body of the task; called with the owner and the remaining arguments")
};
static const struct api_param scope_params[] = { THING(
    "owner", OPT, OWNER_HANDLE_KINDS,
    "thing or task whose end also ends the scope; defaults to the owner of the calling task") };
static const struct api_param task_params[] = { THING("t", REQ, 1 << H_TASK, "task or scope") };

static int task_go(lua_State *L, struct board *b, struct api_value *v)
{
    (void)v;
    lua_pushinteger(L, tasks_start(b, L, b->tasks.current_owner, lua_gettop(L) - 1));
    return 1;
}

static int task_own(lua_State *L, struct board *b, struct api_value *v)
{
    int64_t h = v[OWN_OWNER].i;

    if (!board_is_alive(b, h))
        return lua_pushinteger(L, board_handle(b, H_TASK, NO_SLOT)), 1;
    lua_pushvalue(L, 1); /* owner f ... -> f owner ... */
    lua_remove(L, 1);
    lua_insert(L, 2);
    lua_pushinteger(L, tasks_start(b, L, h, lua_gettop(L) - 1));
    return 1;
}

static int task_scope(lua_State *L, struct board *b, struct api_value *v)
{
    lua_pushinteger(L, tasks_new_scope(b, v[ARG_OWNER].given ? v[ARG_OWNER].i : b->tasks.current_owner, false));
    return 1;
}

static int task_stop(lua_State *L, struct board *b, struct api_value *v)
{
    uint32_t slot = handle_slot(v[ARG_TASK].i);

    if (!slots_has(&b->tasks.s, slot, handle_gen(v[ARG_TASK].i)))
        return 0;
    tasks_stop(b, slot);
    if ((int32_t)slot != b->tasks.current)
        return 0;
    if (!lua_isyieldable(L))
        return api_error(L, "task.stop", "cannot stop itself inside a callback from C");
    return lua_yield(L, 0);
}

static int task_alive(lua_State *L, struct board *b, struct api_value *v)
{
    lua_pushboolean(L, board_is_alive(b, v[ARG_TASK].i));
    return 1;
}

const struct api_thing api_task_thing = { .name = "task" };

static int add_handler(lua_State *L, struct board *b, struct api_value *v)
{
    (void)b;
    lua_pushvalue(L, v[ARG_F].at);
    events_add_handler(L, api_current_binding(L)->entry->name + strlen("on."));
    return 0;
}

/* The row of on.`event`; `f`: the function's arguments, and when it is called. */
#define ON(event, help, f)                                                                                             \
    {                                                                                                                  \
        "on." event, add_handler, (const struct api_param[]){ PARAM("f", A_FUNC, REQ, 0, 0, NULL, NULL, f) }, 1, 1,    \
            API_CHANGES | API_LOAD_ONLY, NULL, HELP(help)                                                              \
    }

static const struct api_entry entries[] = {
    { "wait", wait_frames, PARAMS(wait_params), 1, API_CHANGES | API_GLOBAL, NULL,
      HELP("pauses the task for a number of frames") },
    { "task.go", task_go, PARAMS(go_params), 1, API_CHANGES | API_VARARGS, "task",
      HELP("starts a task with the same owner as the calling task; both end with that owner") },
    { "task.own", task_own, PARAMS(own_params), 2, API_CHANGES | API_VARARGS, "task",
      HELP("starts a task that ends with the given owner") },
    { "task.scope", task_scope, PARAMS(scope_params), 1, API_CHANGES, "scope",
      HELP("creates a scope to own tasks; stopping the scope stops all of its tasks") },
    { "task.stop", task_stop, PARAMS(task_params), 1, API_CHANGES, NULL,
      HELP("stops a task or a scope, and everything it owns") },
    { "task.alive", task_alive, PARAMS(task_params), 1, 0, "boolean", HELP("returns true while the task runs") },
    ON("graze", "calls a function each time a player grazes a bullet",
       "f(player, bullet): called with the player and the grazed bullet"),
    ON("hit", "calls a function each time a bullet or an enemy hits a player who isn't safe",
       "f(player, by): called with the player and the bullet or enemy that hit the player; set player.safe here to "
       "cancel the hit"),
    ON("death", "calls a function each time a player loses a life",
       "f(player): called with the player, who is still at the position of the death"),
    ON("game_over", "calls a function when the last player is out", "f(): called without arguments"),
    ON("kill", "calls a function each time an enemy is killed",
       "f(enemy, player): called with the enemy, whose properties can still be read, and the player who killed it; "
       "player may be nil"),
    ON("leave", "calls a function each time an enemy leaves the field",
       "f(enemy): called with the enemy, whose properties can still be read"),
    ON("extend", "calls a function each time the score or an item gives a player an extra life",
       "f(player): called with the player"),
    ON("take", "calls a function each time a player takes an item",
       "f(player, item): called with the player and the item, whose properties can still be read"),
    ON("bomb", "calls a function each time a player bombs",
       "f(player, late): called with the player; late is true if the bomb saved the player from a hit"),
    ON("continue", "calls a function each time a player continues after losing the last life",
       "f(player): called with the player, whose score has just been reset to the number of continues used (at most "
       "9)"),
    ON("start", "calls a function when a game or a practice attempt starts; use it to reset script variables",
       "f(): called without arguments, before anything else in the game"),
    ON("phase", "calls a function at the end of each phase of a boss",
       "f(enemy, id, won, captured): called with the boss and the id of the phase; won is true if the phase was "
       "beaten, and captured is true if it was beaten without a death or a bomb"),
    ON("stage", "calls a function when a stage starts and when it is cleared",
       "f(name, state): called with the name of the stage; state is \"start\" or \"clear\""),
};
const struct api_module api_time = { entries, sizeof entries / sizeof *entries };
