/*
 * trial_run.c - the runs of a test script: what is done with them, and what is seen in them.
 *
 * A run is a userdata with its number and serial; the board stands in struct trial until TRIAL_RUNS newer ones have
 * been begun. What a frame printed, told and sounded is gathered after each tick, for it is gone with the next.
 */
#include "trial_parts.h"

#include <inttypes.h>
#include <stdio.h>
#include <string.h>
#include "../../script/api/eval.h"

static const char methods_key = 0, meta_key = 0;

struct run_handle {
    int number;
    lua_Integer serial;
};

/* The kept table's entries. */
enum { KEPT_LOG = 1, KEPT_MOMENTS, KEPT_HEARD };

/* ---- handles ---- */

static struct run_handle *to_handle(lua_State *L, int idx)
{
    struct run_handle *h = lua_touserdata(L, idx);

    if (!h || lua_type(L, idx) != LUA_TUSERDATA || !lua_getmetatable(L, idx))
        return NULL;
    lua_rawgetp(L, LUA_REGISTRYINDEX, &meta_key);
    const bool same = lua_rawequal(L, -1, -2);
    lua_pop(L, 2);
    return same ? h : NULL;
}

static struct trial_run *check_run(lua_State *L, int idx)
{
    const struct run_handle *h = to_handle(L, idx);

    if (!h)
        vm_fault(L, FAULT_SCRIPT, "expected a run from test.run (call run:step with a colon), got %s",
                 luaL_typename(L, idx));
    struct trial_run *r = &trial_of(L)->run[h->number];
    if (r->serial != h->serial)
        vm_fault(L, FAULT_SCRIPT, "the run has ended (only the last %d runs of a test stay open)", TRIAL_RUNS);
    return r;
}

static int number_of(lua_State *L, const struct trial_run *r)
{
    return (int)(r - trial_of(L)->run);
}

int trial_newest(lua_State *L, int idx)
{
    const struct trial *t = trial_of(L);

    if (!lua_isnoneornil(L, idx))
        return number_of(L, check_run(L, idx));
    if (t->runs == 0)
        vm_fault(L, FAULT_SCRIPT, "no run yet (start one with test.run)");
    return (int)((t->runs - 1) % TRIAL_RUNS);
}

/* ---- what a frame leaves ---- */

/* Pushes the table of what is kept of a run. */
static void push_kept(lua_State *L, const struct trial_run *r, int which)
{
    lua_rawgeti(L, LUA_REGISTRYINDEX, r->kept);
    lua_rawgeti(L, -1, which);
    lua_remove(L, -2);
}

static void append(lua_State *L) /* TABLE VALUE: both go */
{
    lua_rawseti(L, -2, (lua_Integer)lua_rawlen(L, -2) + 1);
    lua_pop(L, 1);
}

static void gather_log(lua_State *L, const struct trial_run *r, const struct board_out *out)
{
    for (size_t at = 0, n; at < out->log_size; at += n + 1) {
        const char *line = out->log + at, *end = memchr(line, '\n', out->log_size - at);
        n = end ? (size_t)(end - line) : out->log_size - at;
        push_kept(L, r, KEPT_LOG);
        lua_pushlstring(L, line, n);
        append(L);
    }
}

static const char *const kinds[MARKER_KINDS] = {
    [MARKER_STAGE] = "stage", [MARKER_MARK] = "mark",   [MARKER_WAVE] = "wave",   [MARKER_BOSS] = "boss",
    [MARKER_PHASE] = "phase", [MARKER_DEATH] = "death", [MARKER_CLEAR] = "clear", [MARKER_WON] = "won",
    [MARKER_LOST] = "lost",   [MARKER_START] = "start", [MARKER_GAME] = "game",   [MARKER_OVER] = "over",
    [MARKER_ROW] = "row",
};

static void set_text(lua_State *L, const char *field, const char *text)
{
    if (!text[0])
        return;
    lua_pushstring(L, text);
    lua_setfield(L, -2, field);
}

static void gather_moments(lua_State *L, const struct trial_run *r, const struct board_out *out)
{
    for (int i = 0; i < out->marker_count; i++) {
        const struct board_marker *m = &out->marker[i];
        if (!kinds[m->kind])
            continue;
        push_kept(L, r, KEPT_MOMENTS);
        lua_createtable(L, 0, 6);
        lua_pushinteger(L, board_frame(r->b));
        lua_setfield(L, -2, "frame");
        lua_pushinteger(L, m->value);
        lua_setfield(L, -2, "value");
        set_text(L, "kind", kinds[m->kind]);
        set_text(L, "name", m->name);
        set_text(L, "of", m->parent);
        set_text(L, "title", m->title);
        append(L);
    }
}

static void count_sound(lua_State *L, const struct trial_run *r, const char *name)
{
    push_kept(L, r, KEPT_HEARD);
    lua_getfield(L, -1, name);
    lua_pushinteger(L, lua_tointeger(L, -1) + 1);
    lua_setfield(L, -3, name);
    lua_pop(L, 2);
}

static void gather_sounds(lua_State *L, struct trial_run *r)
{
    struct board_cue cue;

    for (int i = 0; i < TRIAL_CUES && board_get_cue(r->b, i, &cue); i++) {
        const uint32_t began = cue.name && cue.is_first_track ? cue.start_frame + 1 : 0;
        if (began && began != r->began[i])
            count_sound(L, r, cue.name);
        r->began[i] = began;
    }
}

static void gather(lua_State *L, struct trial_run *r)
{
    const struct board_out *out = board_last_output(r->b);

    luaL_checkstack(L, 8, NULL);
    gather_log(L, r, out);
    gather_moments(L, r, out);
    gather_sounds(L, r);
}

/* A fault of the game is one of the test, unless that is what it wants to see. */
static void look_for_fault(lua_State *L, const struct trial_run *r)
{
    const struct board_fault *fault = board_last_output(r->b)->fault;

    if (fault && !r->may_fault)
        vm_fault(L, FAULT_SCRIPT, "the game stopped at frame %d: %s", (int)board_frame(r->b), fault->message);
}

/* ---- ticks ---- */

static void press(lua_State *L, int number, const char *list)
{
    const struct trial_host *host = trial_of(L)->host;
    char err[TRIAL_ERR];

    if (!host->press(host->context, number, list, err, sizeof err))
        vm_fault(L, FAULT_SCRIPT, "%s", err);
}

/* Asks the script's function what is held. The run is at index 1. */
static void ask_held(lua_State *L, const struct trial_run *r)
{
    if (r->held == LUA_NOREF)
        return;
    lua_rawgeti(L, LUA_REGISTRYINDEX, r->held);
    lua_pushvalue(L, 1);
    lua_call(L, 1, 1);
    check_run(L, 1); /* the function may have begun others */
    if (!lua_isnoneornil(L, -1) && lua_type(L, -1) != LUA_TSTRING)
        vm_fault(L, FAULT_SCRIPT, "pads: expected the function to return buttons such as \"left,fire\", got %s",
                 luaL_typename(L, -1));
    press(L, number_of(L, r), lua_isnil(L, -1) ? "" : lua_tostring(L, -1));
    lua_pop(L, 1);
}

/* One frame; false: the game has stopped. The run is at index 1. */
static bool tick(lua_State *L, struct trial_run *r)
{
    struct trial *t = trial_of(L);

    if (board_last_output(r->b)->fault)
        return false;
    if (t->frames == TRIAL_FRAMES)
        vm_fault(L, FAULT_LOOP, "more than %d frames (an hour of play) in one test (infinite loop?)", TRIAL_FRAMES);
    ask_held(L, r);
    if (board_last_output(r->b)->fault) /* by the function's own doing */
        return false;
    t->frames++;
    t->host->tick(t->host->context, number_of(L, r));
    gather(L, r);
    look_for_fault(L, r);
    return true;
}

static uint32_t check_frames(lua_State *L, int idx, const char *what)
{
    int whole;
    const lua_Integer n = lua_tointegerx(L, idx, &whole);

    if (!whole || n < 0 || n > TRIAL_FRAMES)
        vm_fault(L, FAULT_SCRIPT, "%s: expected a whole number of frames from 0 to %d", what, TRIAL_FRAMES);
    return (uint32_t)n;
}

int trial_run_step(lua_State *L)
{
    struct trial_run *r = check_run(L, 1);
    const uint32_t n = lua_isnoneornil(L, 2) ? 1 : check_frames(L, 2, "run:step");

    lua_settop(L, 1);
    for (uint32_t i = 0; i < n && tick(L, r); i++)
        continue;
    return 0;
}

static void begin(lua_State *L, struct trial_run *r, int number, lua_Integer serial)
{
    if (r->serial) {
        luaL_unref(L, LUA_REGISTRYINDEX, r->kept);
        luaL_unref(L, LUA_REGISTRYINDEX, r->held);
    }
    *r = (struct trial_run){ .serial = serial, .held = LUA_NOREF };
    lua_newtable(L);
    for (int i = KEPT_LOG; i <= KEPT_HEARD; i++) {
        lua_newtable(L);
        lua_rawseti(L, -2, i);
    }
    r->kept = luaL_ref(L, LUA_REGISTRYINDEX);
    struct run_handle *h = lua_newuserdatauv(L, sizeof *h, 0);
    *h = (struct run_handle){ number, serial };
    lua_rawgetp(L, LUA_REGISTRYINDEX, &meta_key);
    lua_setmetatable(L, -2);
}

int trial_test_run(lua_State *L)
{
    struct trial *t = trial_of(L);
    struct trial_options o;
    uint32_t frames = 0;
    char err[TRIAL_ERR];

    lua_settop(L, 1);
    trial_read_options(L, &o);
    const int number = (int)(t->runs % TRIAL_RUNS);
    struct trial_run *r = &t->run[number];
    begin(L, r, number, ++t->runs); /* leaves the handle */
    r->may_fault = o.faults;
    r->b = t->host->power(t->host->context, number, &o.start, &frames, err, sizeof err);
    if (!r->b)
        vm_fault(L, FAULT_SCRIPT, "test.run: %s", err);
    if (o.function) {
        lua_getfield(L, 1, "pads");
        r->held = luaL_ref(L, LUA_REGISTRYINDEX);
    }
    lua_replace(L, 1); /* the handle */
    gather(L, r);
    look_for_fault(L, r);
    for (uint32_t i = 0; i < (o.framed ? o.frames : frames) && tick(L, r); i++)
        continue;
    lua_settop(L, 1);
    return 1;
}

int trial_run_press(lua_State *L)
{
    struct trial_run *r = check_run(L, 1);

    luaL_unref(L, LUA_REGISTRYINDEX, r->held);
    r->held = LUA_NOREF;
    if (lua_isfunction(L, 2)) {
        lua_settop(L, 2);
        r->held = luaL_ref(L, LUA_REGISTRYINDEX);
    } else if (lua_isnoneornil(L, 2) || lua_type(L, 2) == LUA_TSTRING) {
        press(L, number_of(L, r), lua_isnoneornil(L, 2) ? "" : lua_tostring(L, 2));
    } else {
        vm_fault(L, FAULT_SCRIPT, "run:press: expected buttons such as \"fire,left@60:90\" or a function, got %s",
                 luaL_typename(L, 2));
    }
    return 0;
}

/* ---- looking into the game ---- */

/* Runs `line` in the game; its values are pushed. changes: what it does stays. */
static int evaluate(lua_State *L, const char *what, bool changes)
{
    struct trial *t = trial_of(L);
    struct trial_run *r = check_run(L, 1);
    const int number = number_of(L, r);
    char err[TRIAL_ERR];

    if (lua_type(L, 2) != LUA_TSTRING)
        return vm_fault(L, FAULT_SCRIPT, "%s: expected a line of Lua as a string, got %s", what, luaL_typename(L, 2));
    if (board_last_output(r->b)->fault)
        return vm_fault(L, FAULT_SCRIPT, "%s: the game has stopped: %s", what, board_last_output(r->b)->fault->message);
    if (!t->host->keep(t->host->context, number))
        return vm_fault(L, FAULT_SCRIPT, "%s: out of memory", what);
    const bool good = board_eval_values(r->b, lua_tostring(L, 2), &t->values, err, sizeof err);
    if (!good || !changes)
        t->host->back(t->host->context, number);
    if (!good)
        return vm_fault(L, FAULT_SCRIPT, "%s: %s", what, err);
    return values_push(L, &t->values);
}

int trial_run_eval(lua_State *L)
{
    return evaluate(L, "run:eval", false);
}

int trial_run_exec(lua_State *L)
{
    return evaluate(L, "run:exec", true);
}

/* Is the condition at index 2 true now? The run is at index 1. */
static bool holds(lua_State *L)
{
    const int top = lua_gettop(L);

    if (lua_isfunction(L, 2)) {
        lua_pushvalue(L, 2);
        lua_pushvalue(L, 1);
        lua_call(L, 1, 1);
        check_run(L, 1); /* as in ask_held */
    } else if (evaluate(L, "run:wait", false) == 0) {
        lua_pushnil(L);
    }
    const bool is = lua_toboolean(L, top + 1);
    lua_settop(L, top);
    return is;
}

int trial_run_wait(lua_State *L)
{
    struct trial_run *r = check_run(L, 1);
    const uint32_t most = check_frames(L, 3, "run:wait");

    lua_settop(L, 2);
    for (uint32_t i = 0;; i++) {
        const bool is = !board_last_output(r->b)->fault && holds(L);
        if (is || i == most || !tick(L, r)) {
            lua_pushboolean(L, is);
            return 1;
        }
    }
}

static const char *check_part(lua_State *L, const struct trial_run *r, const char *what)
{
    const char *name = luaL_checkstring(L, 2);

    if (board_live_count(r->b, name) < 0)
        vm_fault(L, FAULT_SCRIPT, "%s: unknown part \"%s\" (curtain hash --parts lists them)", what, name);
    return name;
}

int trial_run_live(lua_State *L)
{
    struct trial_run *r = check_run(L, 1);

    lua_pushinteger(L, board_live_count(r->b, check_part(L, r, "run:live")));
    return 1;
}

int trial_run_refused(lua_State *L)
{
    struct trial_run *r = check_run(L, 1);

    lua_pushinteger(L, board_refused_count(r->b, check_part(L, r, "run:refused")));
    return 1;
}

static bool has_sound(const struct board *b, const char *name)
{
    for (int i = 0; i < b->cart.count[CART_SOUNDS]; i++)
        if (!strcmp(cart_name(&b->cart, CART_SOUNDS, i), name))
            return true;
    return false;
}

int trial_run_heard(lua_State *L)
{
    struct trial_run *r = check_run(L, 1);
    const char *name = luaL_checkstring(L, 2);

    if (!has_sound(r->b, name))
        return vm_fault(L, FAULT_SCRIPT, "run:heard: unknown sound \"%s\" (curtain sound lists them)", name);
    push_kept(L, r, KEPT_HEARD);
    lua_getfield(L, -1, name);
    lua_pushinteger(L, lua_tointeger(L, -1));
    return 1;
}

int trial_run_printed(lua_State *L)
{
    struct trial_run *r = check_run(L, 1);
    const char *words = luaL_checkstring(L, 2);
    bool found = false;

    push_kept(L, r, KEPT_LOG);
    for (lua_Integer i = 1; !found && lua_rawgeti(L, -1, i) == LUA_TSTRING; i++) {
        found = strstr(lua_tostring(L, -1), words) != NULL;
        lua_pop(L, 1);
    }
    lua_pushboolean(L, found);
    return 1;
}

static void check_kind(lua_State *L, const char *kind)
{
    for (int i = 0; i < MARKER_KINDS; i++)
        if (kinds[i] && !strcmp(kinds[i], kind))
            return;
    vm_fault(L, FAULT_SCRIPT,
             "run:moment: unknown kind \"%s\" (kinds: stage mark wave boss phase death clear won lost start "
             "game over row)",
             kind);
}

/* Has the moment on top of the stack that text in that field? */
static bool field_is(lua_State *L, const char *field, const char *text)
{
    lua_getfield(L, -1, field);
    const bool is = !text || (lua_type(L, -1) == LUA_TSTRING && !strcmp(lua_tostring(L, -1), text));
    lua_pop(L, 1);
    return is;
}

int trial_run_moment(lua_State *L)
{
    struct trial_run *r = check_run(L, 1);
    const char *kind = luaL_checkstring(L, 2), *name = luaL_optstring(L, 3, NULL);

    check_kind(L, kind);
    push_kept(L, r, KEPT_MOMENTS);
    for (lua_Integer i = 1; lua_rawgeti(L, -1, i) == LUA_TTABLE; i++) {
        if (field_is(L, "kind", kind) && field_is(L, "name", name))
            return 1;
        lua_pop(L, 1);
    }
    return 1;
}

/* ---- fields ---- */

static void push_hash(lua_State *L, const struct trial_run *r)
{
    char text[20];

    snprintf(text, sizeof text, "%016" PRIx64, board_hash(r->b));
    lua_pushstring(L, text);
}

static void push_fault(lua_State *L, const struct trial_run *r)
{
    const struct board_fault *fault = board_last_output(r->b)->fault;

    if (fault)
        lua_pushstring(L, fault->message);
    else
        lua_pushnil(L);
}

static void push_name(lua_State *L, const char *name)
{
    if (name[0])
        lua_pushstring(L, name);
    else
        lua_pushnil(L);
}

static int field(lua_State *L)
{
    const struct trial_run *r = check_run(L, 1);
    const char *name = lua_type(L, 2) == LUA_TSTRING ? lua_tostring(L, 2) : "";

    if (!strcmp(name, "frame"))
        lua_pushinteger(L, board_frame(r->b));
    else if (!strcmp(name, "score"))
        lua_pushinteger(L, board_points(r->b, 0));
    else if (!strcmp(name, "score2"))
        lua_pushinteger(L, board_points(r->b, 1));
    else if (!strcmp(name, "hash"))
        push_hash(L, r);
    else if (!strcmp(name, "fault"))
        push_fault(L, r);
    else if (!strcmp(name, "music"))
        push_name(L, board_music_name(r->b));
    else if (!strcmp(name, "difficulty"))
        push_name(L, r->b->cart.manifest.difficulties[board_current_difficulty(r->b)]);
    else if (!strcmp(name, "log"))
        push_kept(L, r, KEPT_LOG);
    else if (!strcmp(name, "moments"))
        push_kept(L, r, KEPT_MOMENTS);
    else {
        lua_rawgetp(L, LUA_REGISTRYINDEX, &methods_key);
        lua_pushvalue(L, 2);
        if (lua_rawget(L, -2) == LUA_TNIL)
            vm_fault(L, FAULT_SCRIPT, "a run has no field \"%s\" (curtain help test lists them)",
                     lua_type(L, 2) == LUA_TSTRING ? name : luaL_typename(L, 2));
    }
    return 1;
}

static int no_field(lua_State *L)
{
    return vm_fault(L, FAULT_SCRIPT, "the fields of a run are read-only; change the game with run:exec \"...\"");
}

void trial_open_runs(lua_State *L)
{
    lua_newtable(L);
    trial_set_functions(L, "run:");
    lua_rawsetp(L, LUA_REGISTRYINDEX, &methods_key);
    lua_newtable(L);
    lua_pushcfunction(L, field);
    lua_setfield(L, -2, "__index");
    lua_pushcfunction(L, no_field);
    lua_setfield(L, -2, "__newindex");
    lua_pushliteral(L, "run");
    lua_setfield(L, -2, "__name");
    lua_pushboolean(L, 0);
    lua_setfield(L, -2, "__metatable");
    lua_rawsetp(L, LUA_REGISTRYINDEX, &meta_key);
}
