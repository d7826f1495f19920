/*
 * api_time.c - wait, task, on.
 */
#include "api_parts.h"
#include "../events_run.h"
#include "../sound.h"

/* Parameters by place; ARG_: the only one of its entry. */
enum { ARG_FRAMES = 0, ARG_OWNER = 0, ARG_TASK = 0, ARG_F = 0 };
enum { OWN_OWNER, OWN_F };

static const struct api_param frames[] = { PARAM("n", A_COUNT, REQ, 0, 1e9, "frames", NULL, "") };

int api_pass_wait(lua_State *L, struct board *b)
{
    const bool lists = board_lists(b), spent = lists && b->vm.work > b->vm.limit / 2;

    if (!tasks_skipping(&b->tasks) || (++b->tasks.skipped <= MAX_SKIPS && !spent))
        return 0;
    if (!lists || !lua_isyieldable(L))
        return api_error(L, "wait",
                         "more than %d waits on the way to a mark: does it wait for what is passed over there?",
                         MAX_SKIPS);
    tasks_stop(b, (uint32_t)b->tasks.current);
    return lua_yield(L, 0);
}

static int wait_run(lua_State *L, struct board *b, struct api_value *v)
{
    if (b->tasks.current == NO_SLOT)
        return api_error(L, "wait", "only a task can wait; start one with task.go");
    if (!lua_isyieldable(L))
        return api_error(
            L, "wait",
            "cannot wait inside a function that C calls (bullet.each and its like, a sort, a gsub, a <close>)");
    if (b->tasks.flags[b->tasks.current] & TASK_SKIPS) {
        if (b->music.passes)
            vm_charge(L, sound_pass_wait(b, v[ARG_FRAMES].i));
        return api_pass_wait(L, b);
    }
    if (!v[ARG_FRAMES].i)
        return 0;
    b->tasks.wait[b->tasks.current] = v[ARG_FRAMES].i;
    return lua_yield(L, 0);
}

static const struct api_param go[] = { PARAM("f", A_FUNC, REQ, 0, 0, NULL, NULL, "") };
static const struct api_param own[] = { PARAM("owner", A_THING, REQ, OWNERS, 0, NULL, NULL, ""),
                                        PARAM("f", A_FUNC, REQ, 0, 0, NULL, NULL, "") };
static const struct api_param owner[] = { PARAM("owner", A_THING, OPT, OWNERS, 0, NULL, NULL, "") };
static const struct api_param task[] = { PARAM("t", A_THING, REQ, 1 << H_TASK, 0, NULL, NULL, "") };

static int task_go(lua_State *L, struct board *b, struct api_value *v)
{
    (void)v;
    lua_pushinteger(L, tasks_start(b, L, tasks_owner(b), lua_gettop(L) - 1));
    return 1;
}

static int task_own(lua_State *L, struct board *b, struct api_value *v)
{
    int64_t h = v[OWN_OWNER].i;

    if (!board_alive(b, h))
        return lua_pushinteger(L, board_handle(b, H_TASK, NO_SLOT)), 1;
    lua_pushvalue(L, 1); /* owner f ... -> f owner ... */
    lua_remove(L, 1);
    lua_insert(L, 2);
    lua_pushinteger(L, tasks_start(b, L, h, lua_gettop(L) - 1));
    return 1;
}

static int task_scope(lua_State *L, struct board *b, struct api_value *v)
{
    lua_pushinteger(L, tasks_scope(b, v[ARG_OWNER].given ? v[ARG_OWNER].i : tasks_owner(b), false));
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
        return api_error(L, "task.stop", "cannot stop itself inside a function that C calls");
    return lua_yield(L, 0);
}

static int task_alive(lua_State *L, struct board *b, struct api_value *v)
{
    lua_pushboolean(L, board_alive(b, v[ARG_TASK].i));
    return 1;
}

static void get_none(lua_State *L, struct board *b, uint32_t slot, int p)
{
    (void)b, (void)slot, (void)p;
    lua_pushnil(L);
}

const struct api_thing api_task_thing = { "task", NULL, 0, get_none, NULL };

static const struct api_param handler[] = { PARAM("f", A_FUNC, REQ, 0, 0, NULL, NULL, "") };

#define ON(name, index)                                                                                                \
    static int on_##name(lua_State *L, struct board *b, struct api_value *v)                                           \
    {                                                                                                                  \
        (void)b;                                                                                                       \
        lua_pushvalue(L, v[ARG_F].at);                                                                                 \
        events_on(L, index);                                                                                           \
        return 0;                                                                                                      \
    }
ON(graze, EV_GRAZE)
ON(hit, EV_HIT)
ON(death, EV_DEATH)
ON(game_over, EV_GAME_OVER)
ON(kill, EV_KILL)
ON(leave, EV_LEAVE)
ON(extend, EV_EXTEND)
ON(take, EV_TAKE)
ON(bomb, EV_BOMB)
ON(continue, EV_CONTINUE)
ON(phase, EV_PHASE)
ON(stage, EV_STAGE)
ON(start, EV_START)

#define ON_FLAGS (API_CHANGES | API_LOAD)
static const struct api_entry entries[] = {
    { "wait", wait_run, PARAMS(frames), 1, API_CHANGES | API_GLOBAL, NULL,
      HELP("this task goes on n frames later; wait(0) goes on at once") },
    { "task.go", task_go, PARAMS(go), 1, API_CHANGES | API_MORE, "task",
      HELP("starts f(...) with the owner of the calling task") },
    { "task.own", task_own, PARAMS(own), 2, API_CHANGES | API_MORE, "task",
      HELP("starts f(owner, ...), which stops at the owner's end") },
    { "task.scope", task_scope, PARAMS(owner), 1, API_CHANGES, "scope",
      HELP("an owner with no body, itself owned by owner, or by the owner of the calling task") },
    { "task.stop", task_stop, PARAMS(task), 1, API_CHANGES, NULL, HELP("stops a task or scope and all it owns") },
    { "task.alive", task_alive, PARAMS(task), 1, 0, "boolean", HELP("is the task still there?") },
    { "on.graze", on_graze, PARAMS(handler), 1, ON_FLAGS, NULL, HELP("f(player, bullet): it passed close") },
    { "on.hit", on_hit, PARAMS(handler), 1, ON_FLAGS, NULL,
      HELP("f(player, by): a bullet or an enemy hits it; making it safe here saves it") },
    { "on.death", on_death, PARAMS(handler), 1, ON_FLAGS, NULL,
      HELP("f(player): it lost a life, and is still where it died") },
    { "on.game_over", on_game_over, PARAMS(handler), 1, ON_FLAGS, NULL, HELP("f(): the last player is out") },
    { "on.kill", on_kill, PARAMS(handler), 1, ON_FLAGS, NULL,
      HELP("f(enemy, player): an enemy died (player may be nil)") },
    { "on.leave", on_leave, PARAMS(handler), 1, ON_FLAGS, NULL, HELP("f(enemy): an enemy left the field") },
    { "on.extend", on_extend, PARAMS(handler), 1, ON_FLAGS, NULL,
      HELP("f(player): the score, or an item, brought a life") },
    { "on.take", on_take, PARAMS(handler), 1, ON_FLAGS, NULL,
      HELP("f(player, item): it was taken, and can still be read") },
    { "on.bomb", on_bomb, PARAMS(handler), 1, ON_FLAGS, NULL,
      HELP("f(player, late): its bomb began; late: and saves it from a hit") },
    { "on.continue", on_continue, PARAMS(handler), 1, ON_FLAGS, NULL,
      HELP("f(player): it lost its last life and goes on; its score is as many points as it went on so far") },
    { "on.start", on_start, PARAMS(handler), 1, ON_FLAGS, NULL,
      HELP("f(): a game begins, or a try of practice; what was kept of the last one is set anew here") },
    { "on.phase", on_phase, PARAMS(handler), 1, ON_FLAGS, NULL,
      HELP("f(enemy, id, won, captured): a boss's phase is over; captured: beaten without a death or a bomb") },
    { "on.stage", on_stage, PARAMS(handler), 1, ON_FLAGS, NULL,
      HELP("f(name, state): state is \"start\" or \"clear\"") },
};
const struct api_module api_time = { entries, sizeof entries / sizeof *entries };
