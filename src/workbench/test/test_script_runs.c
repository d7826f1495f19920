/*
 * test_script_runs.c - the runs of a test script, and their functions and fields.
 *
 * A run is a userdata with an index and a serial number. Its board is in struct test_script until MAX_TEST_RUNS newer
 * runs have started. Printed lines, moments and sounds are recorded after each tick, because the next tick replaces
 * them.
 */
#include "test_script_parts.h"

#include <inttypes.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "../../base/err.h"
#include "../../common/result.h"
#include "../../demo/markers.h"
#include "../../script/api/eval.h"

static const char methods_key = 0, meta_key = 0;

struct run_handle {
    int index;
    lua_Integer serial;
};

/* The entries of the table `records`. */
enum { RECORD_LOG = 1, RECORD_MOMENTS, RECORD_HEARD };

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

static struct test_run *check_run(lua_State *L, int idx)
{
    const struct run_handle *h = to_handle(L, idx);

    if (!h)
        vm_fault(L, FAULT_SCRIPT, "expected a run from test.run (call run:step with a colon), got %s",
                 luaL_typename(L, idx));
    struct test_run *r = &test_script_of(L)->run[h->index];
    if (r->serial != h->serial)
        vm_fault(L, FAULT_SCRIPT, "the run has ended (only the last %d runs of a test stay open)", MAX_TEST_RUNS);
    return r;
}

struct test_run *test_script_newest(lua_State *L, int idx)
{
    struct test_script *s = test_script_of(L);

    if (!lua_isnoneornil(L, idx))
        return check_run(L, idx);
    struct test_run *r = &s->run[(s->runs + MAX_TEST_RUNS - 1) % MAX_TEST_RUNS];
    if (!r->b) /* none, or the last test.run failed */
        vm_fault(L, FAULT_SCRIPT, "no run yet (start one with test.run)");
    return r;
}

/* ---- records of a frame ---- */

static void push_record(lua_State *L, const struct test_run *r, int which)
{
    lua_rawgeti(L, LUA_REGISTRYINDEX, r->records);
    lua_rawgeti(L, -1, which);
    lua_remove(L, -2);
}

/* Pops a value and the table that it is added to. */
static void append(lua_State *L)
{
    lua_rawseti(L, -2, (lua_Integer)lua_rawlen(L, -2) + 1);
    lua_pop(L, 1);
}

static void record_log(lua_State *L, const struct test_run *r, const struct board_out *out)
{
    for (size_t at = 0, n; at < out->log_size; at += n + 1) {
        const char *line = out->log + at, *end = memchr(line, '\n', out->log_size - at);
        n = end ? (size_t)(end - line) : out->log_size - at;
        push_record(L, r, RECORD_LOG);
        lua_pushlstring(L, line, n);
        append(L);
    }
}

static void set_text(lua_State *L, const char *field, const char *text)
{
    if (!text[0])
        return;
    lua_pushstring(L, text);
    lua_setfield(L, -2, field);
}

static void record_moments(lua_State *L, const struct test_run *r, const struct board_out *out)
{
    for (int i = 0; i < out->marker_count; i++) {
        const struct board_marker *m = &out->marker[i];
        if (!markers_kind_name(m->kind))
            continue;
        push_record(L, r, RECORD_MOMENTS);
        lua_createtable(L, 0, 6);
        lua_pushinteger(L, board_frame(r->b));
        lua_setfield(L, -2, "frame");
        lua_pushinteger(L, m->value);
        lua_setfield(L, -2, "value");
        set_text(L, "kind", markers_kind_name(m->kind));
        set_text(L, "name", m->name);
        set_text(L, "of", m->parent);
        set_text(L, "title", m->title);
        append(L);
    }
}

static void count_sound(lua_State *L, const struct test_run *r, const char *name)
{
    push_record(L, r, RECORD_HEARD);
    lua_getfield(L, -1, name);
    lua_pushinteger(L, lua_tointeger(L, -1) + 1);
    lua_setfield(L, -3, name);
    lua_pop(L, 2);
}

static void record_sounds(lua_State *L, struct test_run *r)
{
    struct board_cue cue;

    for (int i = 0; i < CUE_SLOTS && board_get_cue(r->b, i, &cue); i++) {
        const uint32_t start = cue.name && cue.is_first_track ? cue.start_frame + 1 : 0;
        if (start && start != r->sound_start[i])
            count_sound(L, r, cue.name);
        r->sound_start[i] = start;
    }
}

static void record_frame(lua_State *L, struct test_run *r)
{
    const struct board_out *out = board_last_output(r->b);

    luaL_checkstack(L, 8, NULL);
    record_log(L, r, out);
    record_moments(L, r, out);
    record_sounds(L, r);
}

/* Makes a fault of the game a fault of the test, unless options.faults is true. */
static void check_fault(lua_State *L, const struct test_run *r)
{
    const struct board_fault *fault = board_last_output(r->b)->fault;

    if (fault && !r->may_fault)
        vm_fault(L, FAULT_SCRIPT, "the game stopped at frame %d: %s", (int)board_frame(r->b), fault->message);
}

/* ---- ticks ---- */

/* Holds these buttons ("fire,left@60:90") from the next tick on. */
static bool hold(struct test_run *r, const char *buttons, char *err, size_t err_size)
{
    char why[512];

    if (r->plays_demo && buttons[0])
        return err_set(err, err_size, "pads: not allowed with a demo, which contains its own input");
    r->held.n_presses = 0;
    if (!buttons[0] || args_presses(&r->held, buttons, why, sizeof why))
        return true;
    return err_set(err, err_size, "pads%s", strchr(why, ':')); /* "--press: ..." */
}

static void press(lua_State *L, struct test_run *r, const char *buttons)
{
    char err[TEST_ERR_SIZE];

    if (!hold(r, buttons, err, sizeof err))
        vm_fault(L, FAULT_SCRIPT, "%s", err);
}

/* Holds the buttons that the script's function returns. The run is at index 1. */
static void call_pads_function(lua_State *L, struct test_run *r)
{
    if (r->pads_function == LUA_NOREF)
        return;
    lua_rawgeti(L, LUA_REGISTRYINDEX, r->pads_function);
    lua_pushvalue(L, 1);
    lua_call(L, 1, 1);
    check_run(L, 1); /* the function may have started runs */
    if (!lua_isnoneornil(L, -1) && lua_type(L, -1) != LUA_TSTRING)
        vm_fault(L, FAULT_SCRIPT, "pads: expected the function to return buttons such as \"left,fire\", got %s",
                 luaL_typename(L, -1));
    press(L, r, lua_isnil(L, -1) ? "" : lua_tostring(L, -1));
    lua_pop(L, 1);
}

/* Runs a frame; false: the game has stopped. The run is at index 1. */
static bool tick(lua_State *L, struct test_run *r)
{
    struct test_script *s = test_script_of(L);
    uint16_t pads[MAX_PLAYERS];

    if (board_last_output(r->b)->fault)
        return false;
    if (s->frames == TEST_FRAMES)
        vm_fault(L, FAULT_LOOP, "more than %d frames (an hour of play) in one test (infinite loop?)", TEST_FRAMES);
    call_pads_function(L, r);
    if (board_last_output(r->b)->fault) /* the function called run:step or run:exec */
        return false;
    s->frames++;
    if (r->plays_demo)
        demo_pads(&r->demo, board_frame(r->b), pads);
    else
        args_held_pads(&r->held, board_frame(r->b), pads);
    guard_tick(&r->guard, pads);
    record_frame(L, r);
    check_fault(L, r);
    return true;
}

static uint32_t check_frames(lua_State *L, int idx, const char *what)
{
    int whole;
    const lua_Integer n = lua_tointegerx(L, idx, &whole);

    if (!whole || n < 0 || n > TEST_FRAMES)
        vm_fault(L, FAULT_SCRIPT, "%s: expected a whole number of frames from 0 to %d", what, TEST_FRAMES);
    return (uint32_t)n;
}

int test_run_step(lua_State *L)
{
    struct test_run *r = check_run(L, 1);
    const uint32_t n = lua_isnoneornil(L, 2) ? 1 : check_frames(L, 2, "run:step");

    lua_settop(L, 1);
    for (uint32_t i = 0; i < n && tick(L, r); i++)
        continue;
    return 0;
}

/* ---- starting a run ---- */

void test_run_close(struct test_run *r)
{
    free(r->snapshot);
    free(r->output);
    guard_close(&r->guard);
    demo_free(&r->demo);
    *r = (struct test_run){ 0 };
}

static bool load_demo(const struct test_script *s, struct test_run *r, const char *name, char *err, size_t err_size)
{
    char path[DEMO_PATH_SIZE], why[300];

    if (!manifest_path_ok(name))
        return err_set(err, err_size, "demo: expected a file of the game, as in \"demos/run.demo\", got \"%s\"", name);
    if (snprintf(path, sizeof path, "%s/%s", s->testing->dir, name) >= (int)sizeof path)
        return err_set(err, err_size, "demo: path too long");
    if (!demo_load(&r->demo, path, err, err_size))
        return false;
    if (!demo_check_cart(&r->demo, &s->testing->game->cart, why, sizeof why))
        return err_set(err, err_size, "%s: %s", name, why);
    r->plays_demo = true;
    return true;
}

/* Sets the start of a run. In errors, an option of the command line, "--stage", becomes the option "stage". */
static bool read_start(struct game *g, const struct args *start, char *err, size_t err_size)
{
    if (game_start(g, start, err, err_size))
        return true;
    if (strncmp(err, "--", 2) == 0)
        memmove(err, err + 2, strlen(err + 2) + 1);
    return false;
}

static bool power_on(const struct test_script *s, struct test_run *r, const struct test_options *o, char *err,
                     size_t err_size)
{
    struct game *g = s->testing->game;

    if (o->demo ? !load_demo(s, r, o->demo, err, err_size) : !read_start(g, &o->start, err, err_size))
        return false;
    if (!hold(r, o->pads ? o->pads : "", err, err_size) ||
        !guard_power(&r->guard, g->cart.rom, o->demo ? &r->demo.start : &g->start, err, err_size))
        return false;
    r->b = r->guard.board;
    r->output = malloc(board_output_size());
    return r->output || result_set_host_error(err, err_size, "out of memory");
}

/* Replaces a run, and pushes the handle of the new one. */
static void replace(lua_State *L, struct test_run *r, int index, lua_Integer serial)
{
    if (r->serial) {
        luaL_unref(L, LUA_REGISTRYINDEX, r->records);
        luaL_unref(L, LUA_REGISTRYINDEX, r->pads_function);
    }
    test_run_close(r);
    r->serial = serial;
    r->pads_function = LUA_NOREF;
    lua_newtable(L);
    for (int i = RECORD_LOG; i <= RECORD_HEARD; i++) {
        lua_newtable(L);
        lua_rawseti(L, -2, i);
    }
    r->records = luaL_ref(L, LUA_REGISTRYINDEX);
    struct run_handle *h = lua_newuserdatauv(L, sizeof *h, 0);
    *h = (struct run_handle){ index, serial };
    lua_rawgetp(L, LUA_REGISTRYINDEX, &meta_key);
    lua_setmetatable(L, -2);
}

int test_script_start_run(lua_State *L)
{
    struct test_script *s = test_script_of(L);
    struct test_options o;
    char err[TEST_ERR_SIZE];

    lua_settop(L, 1);
    test_options_read(L, &o);
    const int index = (int)(s->runs % MAX_TEST_RUNS);
    struct test_run *r = &s->run[index];
    replace(L, r, index, ++s->runs);
    r->may_fault = o.faults;
    if (!power_on(s, r, &o, err, sizeof err))
        vm_fault(L, FAULT_SCRIPT, "test.run: %s", err);
    if (o.pads_is_function) {
        lua_getfield(L, 1, "pads");
        r->pads_function = luaL_ref(L, LUA_REGISTRYINDEX);
    }
    lua_replace(L, 1); /* the handle */
    record_frame(L, r);
    check_fault(L, r);
    for (uint32_t i = 0; i < (o.has_frames ? o.frames : r->demo.frames) && tick(L, r); i++)
        continue;
    lua_settop(L, 1);
    return 1;
}

int test_run_press(lua_State *L)
{
    struct test_run *r = check_run(L, 1);

    luaL_unref(L, LUA_REGISTRYINDEX, r->pads_function);
    r->pads_function = LUA_NOREF;
    if (lua_isfunction(L, 2)) {
        lua_settop(L, 2);
        r->pads_function = luaL_ref(L, LUA_REGISTRYINDEX);
    } else if (lua_isnoneornil(L, 2) || lua_type(L, 2) == LUA_TSTRING) {
        press(L, r, lua_isnoneornil(L, 2) ? "" : lua_tostring(L, 2));
    } else {
        vm_fault(L, FAULT_SCRIPT, "run:press: expected buttons such as \"fire,left@60:90\" or a function, got %s",
                 luaL_typename(L, 2));
    }
    return 0;
}

/* ---- inspecting the game ---- */

static bool save(struct test_run *r)
{
    const size_t size = board_snapshot_size(r->b);

    if (size > r->snapshot_size) {
        free(r->snapshot);
        r->snapshot = malloc(size);
        r->snapshot_size = r->snapshot ? size : 0;
        if (!r->snapshot)
            return false;
    }
    board_save(r->b, r->snapshot);
    board_output_save(r->b, r->output);
    return true;
}

/* Runs the line at index 2 in the game, and pushes its values. keep: its changes are not undone. */
static int evaluate(lua_State *L, const char *what, bool keep)
{
    struct test_script *s = test_script_of(L);
    struct test_run *r = check_run(L, 1);
    char err[TEST_ERR_SIZE];

    if (lua_type(L, 2) != LUA_TSTRING)
        return vm_fault(L, FAULT_SCRIPT, "%s: expected a line of Lua as a string, got %s", what, luaL_typename(L, 2));
    if (board_last_output(r->b)->fault)
        return vm_fault(L, FAULT_SCRIPT, "%s: the game has stopped: %s", what, board_last_output(r->b)->fault->message);
    if (!save(r))
        return vm_fault(L, FAULT_SCRIPT, "%s: out of memory", what);
    const bool good = board_eval_values(r->b, lua_tostring(L, 2), &s->values, err, sizeof err);
    if (!good || !keep) {
        board_restore(r->b, r->snapshot);
        board_output_restore(r->b, r->output);
    }
    if (!good)
        return vm_fault(L, FAULT_SCRIPT, "%s: %s", what, err);
    return values_push(L, &s->values);
}

int test_run_eval(lua_State *L)
{
    return evaluate(L, "run:eval", false);
}

int test_run_exec(lua_State *L)
{
    return evaluate(L, "run:exec", true);
}

/* Returns whether the condition at index 2 is true. The run is at index 1. */
static bool holds(lua_State *L)
{
    const int top = lua_gettop(L);

    if (lua_isfunction(L, 2)) {
        lua_pushvalue(L, 2);
        lua_pushvalue(L, 1);
        lua_call(L, 1, 1);
        check_run(L, 1); /* as in call_pads_function */
    } else if (evaluate(L, "run:wait", false) == 0) {
        lua_pushnil(L);
    }
    const bool is = lua_toboolean(L, top + 1);
    lua_settop(L, top);
    return is;
}

int test_run_wait(lua_State *L)
{
    struct test_run *r = check_run(L, 1);
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

static const char *check_part(lua_State *L, const struct test_run *r, const char *what)
{
    const char *name = luaL_checkstring(L, 2);

    if (board_live_count(r->b, name) < 0)
        vm_fault(L, FAULT_SCRIPT, "%s: unknown part \"%s\" (curtain hash --parts lists them)", what, name);
    return name;
}

int test_run_live(lua_State *L)
{
    struct test_run *r = check_run(L, 1);

    lua_pushinteger(L, board_live_count(r->b, check_part(L, r, "run:live")));
    return 1;
}

int test_run_refused(lua_State *L)
{
    struct test_run *r = check_run(L, 1);

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

int test_run_heard(lua_State *L)
{
    struct test_run *r = check_run(L, 1);
    const char *name = luaL_checkstring(L, 2);

    if (!has_sound(r->b, name))
        return vm_fault(L, FAULT_SCRIPT, "run:heard: unknown sound \"%s\" (curtain sound lists them)", name);
    push_record(L, r, RECORD_HEARD);
    lua_getfield(L, -1, name);
    lua_pushinteger(L, lua_tointeger(L, -1));
    return 1;
}

int test_run_printed(lua_State *L)
{
    struct test_run *r = check_run(L, 1);
    const char *words = luaL_checkstring(L, 2);
    bool found = false;

    push_record(L, r, RECORD_LOG);
    for (lua_Integer i = 1; !found && lua_rawgeti(L, -1, i) == LUA_TSTRING; i++) {
        found = strstr(lua_tostring(L, -1), words) != NULL;
        lua_pop(L, 1);
    }
    lua_pushboolean(L, found);
    return 1;
}

static void check_kind(lua_State *L, const char *kind)
{
    for (int i = 0; i < MARKER_KINDS; i++) {
        const char *name = markers_kind_name((enum board_marker_kind)i);
        if (name && !strcmp(name, kind))
            return;
    }
    vm_fault(L, FAULT_SCRIPT,
             "run:moment: unknown kind \"%s\" (kinds: stage mark wave boss phase death clear won lost start "
             "game over row difficulty mission)",
             kind);
}

/* Returns whether the field of the moment on top of the stack has this text; NULL: any text. */
static bool field_is(lua_State *L, const char *field, const char *text)
{
    lua_getfield(L, -1, field);
    const bool is = !text || (lua_type(L, -1) == LUA_TSTRING && !strcmp(lua_tostring(L, -1), text));
    lua_pop(L, 1);
    return is;
}

int test_run_moment(lua_State *L)
{
    struct test_run *r = check_run(L, 1);
    const char *kind = luaL_checkstring(L, 2), *name = luaL_optstring(L, 3, NULL);

    check_kind(L, kind);
    push_record(L, r, RECORD_MOMENTS);
    for (lua_Integer i = 1; lua_rawgeti(L, -1, i) == LUA_TTABLE; i++) {
        if (field_is(L, "kind", kind) && field_is(L, "name", name))
            return 1;
        lua_pop(L, 1);
    }
    return 1;
}

/* ---- fields ---- */

static void push_hash(lua_State *L, const struct test_run *r)
{
    char text[20];

    snprintf(text, sizeof text, "%016" PRIx64, board_hash(r->b));
    lua_pushstring(L, text);
}

static void push_fault(lua_State *L, const struct test_run *r)
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
    const struct test_run *r = check_run(L, 1);
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
        push_record(L, r, RECORD_LOG);
    else if (!strcmp(name, "moments"))
        push_record(L, r, RECORD_MOMENTS);
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

void test_script_open_runs(lua_State *L)
{
    lua_newtable(L);
    test_script_set_functions(L, "run:");
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
