/*
 * api_rng.c - the Lua tables rng and angle.
 */
#include <string.h>
#include "../../base/rng.h"
#include "../../base/trig.h"
#include "api.h"

enum { ARG_A = 0, ARG_B = 1, ARG_P = 0, ARG_LIST = 0, ARG_DX = 0, ARG_DY = 1, ARG_D = 0 };

static const struct api_param int_params[] = { PARAM("a", A_INT, REQ, -9e15, 9e15, NULL, NULL, "lowest result"),
                                               PARAM("b", A_INT, REQ, -9e15, 9e15, NULL, NULL, "highest result") };
static const struct api_param number_params[] = { PARAM("a", A_NUM, REQ, -1e15, 1e15, NULL, NULL, "lowest result"),
                                                  PARAM("b", A_NUM, REQ, -1e15, 1e15, NULL, NULL,
                                                        "upper limit, which is never returned unless it equals `a`") };
static const struct api_param chance_params[] = { PARAM("p", A_NUM, REQ, 0, 1, NULL, NULL, "probability") };
static const struct api_param pick_params[] = { REQUIRED("list", A_TABLE, "list to pick from, not empty") };

static int rng_int(lua_State *L, struct board *b, struct api_value *v)
{
    if (v[ARG_A].i > v[ARG_B].i)
        return api_error(L, "rng.int", "`a` is greater than `b`");
    lua_pushinteger(L, v[ARG_A].i + (int64_t)board_random(b, (uint64_t)(v[ARG_B].i - v[ARG_A].i) + 1));
    return 1;
}

/* Returns a random fraction, 0 <= f < 1, of 53 bits, which a double represents exactly. */
static double random_fraction(struct board *b)
{
    return (double)(board_random(b, 0) >> 11) / 9007199254740992.0;
}

static int rng_number(lua_State *L, struct board *b, struct api_value *v)
{
    double n = v[ARG_A].n + (v[ARG_B].n - v[ARG_A].n) * random_fraction(b);

    if (n >= v[ARG_B].n && v[ARG_B].n > v[ARG_A].n) /* the sum was rounded up to the bound */
        n = v[ARG_A].n;
    lua_pushnumber(L, n);
    return 1;
}

static int rng_chance(lua_State *L, struct board *b, struct api_value *v)
{
    lua_pushboolean(L, random_fraction(b) < v[ARG_P].n);
    return 1;
}

static int rng_pick(lua_State *L, struct board *b, struct api_value *v)
{
    uint64_t n = lua_rawlen(L, v[ARG_LIST].at);

    if (!n)
        return api_error(L, "rng.pick", "list: expected at least one element");
    lua_rawgeti(L, v[ARG_LIST].at, (lua_Integer)board_random(b, n) + 1);
    return 1;
}

static int rng_dir(lua_State *L, struct board *b, struct api_value *v)
{
    (void)v;
    lua_pushnumber(L, trig_to_degrees((ang)(board_random(b, 0) >> 32)));
    return 1;
}

/* ---- angle ---- */

static const struct api_param angle_to_params[] = { REQUIRED("a", A_ANY, "thing or { x = , y = } to start from"),
                                                    REQUIRED("b", A_ANY, "thing or { x = , y = } to point at") };
static const struct api_param vector_params[] = { COORDINATE("dx", A_FX, REQ, "distance to the right"),
                                                  COORDINATE("dy", A_FX, REQ, "distance down") };
static const struct api_param difference_params[] = { REQUIRED("a", A_DIR, "direction to start from"),
                                                      REQUIRED("b", A_DIR, "direction to arrive at") };
static const struct api_param angle_params[] = { REQUIRED("d", A_DIR, "angle") };

/* Reads the position of a thing or of a table with x and y. Returns false for a dead thing. */
static bool read_position(lua_State *L, struct board *b, const char *entry, const char *name, int at, fx *x, fx *y)
{
    struct api_param x_param = COORDINATE("x", A_FX, REQ, NULL), y_param = COORDINATE("y", A_FX, REQ, NULL),
                     thing_param = PARAM(name, A_THING, REQ, POSITION_HANDLE_KINDS, 0, NULL, NULL, NULL);
    struct api_value v = { 0 };

    if (lua_type(L, at) != LUA_TTABLE) {
        api_check(L, entry, &thing_param, at, &v);
        return board_get_position(b, v.i, x, y);
    }
    lua_getfield(L, at, "x");
    api_check(L, entry, &x_param, lua_gettop(L), &v);
    *x = v.f;
    lua_getfield(L, at, "y");
    api_check(L, entry, &y_param, lua_gettop(L), &v);
    *y = v.f;
    lua_pop(L, 2);
    return true;
}

static int angle_to(lua_State *L, struct board *b, struct api_value *v)
{
    fx ax, ay, bx, by;

    if (!read_position(L, b, "angle.to", "a", v[ARG_A].at, &ax, &ay) ||
        !read_position(L, b, "angle.to", "b", v[ARG_B].at, &bx, &by) || (ax == bx && ay == by))
        lua_pushnumber(L, 90); /* dead thing or same position: down, as for `aim` */
    else
        lua_pushnumber(L, trig_to_degrees(trig_atan2(fx_sub(by, ay), fx_sub(bx, ax))));
    return 1;
}

static int angle_of(lua_State *L, struct board *b, struct api_value *v)
{
    (void)b;
    lua_pushnumber(L, trig_to_degrees(trig_atan2(v[ARG_DY].f, v[ARG_DX].f)));
    return 1;
}

static int angle_difference(lua_State *L, struct board *b, struct api_value *v)
{
    (void)b;
    int32_t d = trig_difference(v[ARG_A].a, v[ARG_B].a);
    lua_pushnumber(L, (double)d * 360.0 / 4294967296.0);
    return 1;
}

static int angle_sin(lua_State *L, struct board *b, struct api_value *v)
{
    (void)b;
    lua_pushnumber(L, trig_sin30(v[ARG_D].a) / 1073741824.0);
    return 1;
}

static int angle_cos(lua_State *L, struct board *b, struct api_value *v)
{
    (void)b;
    lua_pushnumber(L, trig_cos30(v[ARG_D].a) / 1073741824.0);
    return 1;
}

static const struct api_entry entries[] = {
    { "rng.int", rng_int, PARAMS(int_params), 2, API_CHANGES, "integer",
      HELP("returns a random whole number from `a` to `b`, including both") },
    { "rng.number", rng_number, PARAMS(number_params), 2, API_CHANGES, "number",
      HELP("returns a random number from `a` to `b`") },
    { "rng.chance", rng_chance, PARAMS(chance_params), 1, API_CHANGES, "boolean",
      HELP("returns true with a given probability") },
    { "rng.pick", rng_pick, PARAMS(pick_params), 1, API_CHANGES, "value", HELP("returns a random entry of a list") },
    { "rng.dir", rng_dir, NO_PARAMS, 0, API_CHANGES, "degrees", HELP("returns a random direction") },
    { "angle.to", angle_to, PARAMS(angle_to_params), 2, 0, "degrees",
      HELP("returns the direction from one position to another; 90 if the positions are equal or a thing is dead") },
    { "angle.of", angle_of, PARAMS(vector_params), 2, 0, "degrees", HELP("returns the direction of a vector") },
    { "angle.difference", angle_difference, PARAMS(difference_params), 2, 0, "degrees",
      HELP("returns the shortest turn from one direction to another, from -180 to 180") },
    { "angle.sin", angle_sin, PARAMS(angle_params), 1, 0, "number",
      HELP("returns the sine of an angle in degrees, the same on every machine") },
    { "angle.cos", angle_cos, PARAMS(angle_params), 1, 0, "number",
      HELP("returns the cosine of an angle in degrees, the same on every machine") },
};
const struct api_module api_rng = { entries, sizeof entries / sizeof *entries };
