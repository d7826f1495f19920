/*
 * api_save.c - the Lua table save.
 */
#include <math.h>
#include <string.h>
#include "api.h"

enum { ARG_KEY = 0, ARG_DEFAULT = 1, ARG_VALUE = 1 };

static const struct api_param save_get[] = {
    PARAM("key", A_STR, REQ, 1, NV_KEY, NULL, NULL, "name under which the value was saved"),
    PARAM("default", A_ANY, OPT, 0, 0, NULL, NULL, "value to return if nothing was saved under `key`; defaults to nil")
};
static const struct api_param save_set[] = {
    PARAM("key", A_STR, REQ, 1, NV_KEY, NULL, NULL, "name under which to save the value"),
    PARAM("value", A_ANY, OPT, 0, 0, NULL, NULL, "number, boolean or string of up to 60 bytes; nil deletes it")
};

static int save_get_run(lua_State *L, struct board *b, struct api_value *v)
{
    vm_charge(L, b->nvram.s.live / NVRAM_STEP);
    struct nv_value kept = nvram_get(&b->nvram, lua_tostring(L, v[ARG_KEY].at));
    double d;

    switch (kept.type) {
    case NV_NONE:
    case NV_TABLE:
        lua_pushvalue(L, v[ARG_DEFAULT].at);
        break;
    case NV_INT:
        lua_pushinteger(L, (lua_Integer)kept.bits);
        break;
    case NV_FLOAT:
        memcpy(&d, &kept.bits, sizeof d);
        lua_pushnumber(L, d);
        break;
    case NV_TEXT:
        lua_pushlstring(L, kept.text, kept.length);
        break;
    case NV_BOOL:
        lua_pushboolean(L, kept.bits != 0);
        break;
    }
    return 1;
}

static int save_set_run(lua_State *L, struct board *b, struct api_value *v)
{
    struct nv_value keep = { .type = NV_NONE };
    double d;
    const char *s;

    switch (lua_type(L, v[ARG_VALUE].at)) {
    case LUA_TNIL:
        break;
    case LUA_TNUMBER:
        keep.type = lua_isinteger(L, v[ARG_VALUE].at) ? NV_INT : NV_FLOAT;
        keep.bits = (uint64_t)lua_tointeger(L, v[ARG_VALUE].at);
        d = lua_tonumber(L, v[ARG_VALUE].at);
        if (!isfinite(d))
            return api_error(L, "save.set", "value: expected a finite number");
        if (keep.type == NV_FLOAT)
            memcpy(&keep.bits, &d, sizeof d);
        break;
    case LUA_TSTRING:
        keep.type = NV_TEXT;
        s = lua_tolstring(L, v[ARG_VALUE].at, &keep.length);
        if (keep.length > NV_STRING)
            return api_error(L, "save.set", "value: expected a string of at most %d bytes, got %d", NV_STRING,
                             (int)keep.length);
        memcpy(keep.text, s, keep.length);
        break;
    case LUA_TBOOLEAN:
        keep.type = NV_BOOL;
        keep.bits = (uint64_t)lua_toboolean(L, v[ARG_VALUE].at);
        break;
    default:
        return api_error(L, "save.set", "value: expected a number, string, boolean or nil, got a %s",
                         luaL_typename(L, v[ARG_VALUE].at));
    }
    vm_charge(L, b->nvram.s.live / NVRAM_STEP);
    if (!nvram_set(&b->nvram, lua_tostring(L, v[ARG_KEY].at), &keep))
        return api_error(L, "save.set", NO_NVRAM, b->cart.m.nvram_kib);
    return 0;
}

static const struct api_entry entries[] = {
    { "save.get", save_get_run, PARAMS(save_get), 2, API_CHANGES, "value",
      HELP("returns a value saved by this run or an earlier one") },
    { "save.set", save_set_run, PARAMS(save_set), 2, API_CHANGES, NULL,
      HELP("saves a value that later runs can read; practice, demos and runs without a window save nothing") },
};
const struct api_module api_save = { entries, sizeof entries / sizeof *entries };
