/*
 * api_save.c - the Lua table save.
 */
#include <math.h>
#include <string.h>
#include "api.h"

enum { ARG_KEY = 0, ARG_DEFAULT = 1, ARG_VALUE = 1 };

static const struct api_param save_get_params[] = {
    PARAM("key", A_STR, REQ, 1, NV_MAX_KEY, NULL, NULL, "name under which the value was saved"),
    OPTIONAL("default", A_ANY, "value to return if nothing was saved under `key`; defaults to nil")
};
static const struct api_param save_set_params[] = {
    PARAM("key", A_STR, REQ, 1, NV_MAX_KEY, NULL, NULL, "name under which to save the value"),
    OPTIONAL("value", A_ANY, "number, boolean or string of up to 60 bytes; nil deletes it")
};

static int save_get(lua_State *L, struct board *b, struct api_value *v)
{
    vm_charge(L, b->nvram.s.live / NVRAM_BYTES_PER_WORK);
    struct nv_value value = nvram_get(&b->nvram, lua_tostring(L, v[ARG_KEY].at));
    double d;

    switch (value.type) {
    case NV_NONE:
    case NV_TABLE:
        lua_pushvalue(L, v[ARG_DEFAULT].at);
        break;
    case NV_INT:
        lua_pushinteger(L, (lua_Integer)value.bits);
        break;
    case NV_FLOAT:
        memcpy(&d, &value.bits, sizeof d);
        lua_pushnumber(L, d);
        break;
    case NV_TEXT:
        lua_pushlstring(L, value.text, value.length);
        break;
    case NV_BOOL:
        lua_pushboolean(L, value.bits != 0);
        break;
    }
    return 1;
}

static int save_set(lua_State *L, struct board *b, struct api_value *v)
{
    struct nv_value value = { .type = NV_NONE };
    double d;
    const char *s;

    switch (lua_type(L, v[ARG_VALUE].at)) {
    case LUA_TNIL:
        break;
    case LUA_TNUMBER:
        value.type = lua_isinteger(L, v[ARG_VALUE].at) ? NV_INT : NV_FLOAT;
        value.bits = (uint64_t)lua_tointeger(L, v[ARG_VALUE].at);
        d = lua_tonumber(L, v[ARG_VALUE].at);
        if (!isfinite(d))
            return api_error(L, "save.set", "value: expected a finite number");
        if (value.type == NV_FLOAT)
            memcpy(&value.bits, &d, sizeof d);
        break;
    case LUA_TSTRING:
        value.type = NV_TEXT;
        s = lua_tolstring(L, v[ARG_VALUE].at, &value.length);
        if (value.length > NV_MAX_STRING)
            return api_error(L, "save.set", "value: expected a string of at most %d bytes, got %d", NV_MAX_STRING,
                             (int)value.length);
        memcpy(value.text, s, value.length);
        break;
    case LUA_TBOOLEAN:
        value.type = NV_BOOL;
        value.bits = (uint64_t)lua_toboolean(L, v[ARG_VALUE].at);
        break;
    default:
        return api_error(L, "save.set", "value: expected a number, string, boolean or nil, got a %s",
                         luaL_typename(L, v[ARG_VALUE].at));
    }
    vm_charge(L, b->nvram.s.live / NVRAM_BYTES_PER_WORK);
    if (!nvram_set(&b->nvram, lua_tostring(L, v[ARG_KEY].at), &value))
        return api_error(L, "save.set", NVRAM_FULL_MESSAGE, b->cart.manifest.nvram_kib);
    return 0;
}

static const struct api_entry entries[] = {
    { "save.get", save_get, PARAMS(save_get_params), 2, API_CHANGES, "value",
      HELP("returns a value saved by this run or an earlier one") },
    { "save.set", save_set, PARAMS(save_set_params), 2, API_CHANGES, NULL,
      HELP("saves a value that later runs can read; practice, demos and runs without a window save nothing") },
};
const struct api_module api_save = { entries, sizeof entries / sizeof *entries };
