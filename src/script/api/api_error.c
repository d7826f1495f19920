/*
 * api_error.c - API errors, and the script digest of the arguments and results of calls.
 */
#include <math.h>
#include <stdarg.h>
#include <string.h>
#include "../../base/hash.h"
#include "api_parts.h"

int api_error(lua_State *L, const char *entry, const char *format, ...)
{
    va_list args;

    va_start(args, format);
    const char *message = lua_pushvfstring(L, format, args);
    va_end(args);
    return vm_fault(L, FAULT_SCRIPT, "%s: %s", entry, message);
}

/* ---- locations of declarations, for errors found later ---- */

static const char locations_key = 0; /* registry: "ENTRY NAME" -> "FILE:LINE: " */

void api_record_location(lua_State *L, const char *entry, const char *name)
{
    const int top = lua_gettop(L);
    char location[VM_LOCATION_SIZE];

    vm_push_registry_table(L, &locations_key);
    vm_get_location(L, location, sizeof location);
    lua_pushfstring(L, "%s %s", entry, name);
    lua_pushstring(L, location);
    lua_rawset(L, -3);
    lua_settop(L, top);
}

int api_error_at(lua_State *L, const char *entry, const char *name, const char *format, ...)
{
    va_list args;

    va_start(args, format);
    const char *message = lua_pushvfstring(L, format, args);
    va_end(args);
    vm_push_registry_table(L, &locations_key);
    lua_pushfstring(L, "%s %s", entry, name);
    lua_rawget(L, -2);
    const char *location = lua_tostring(L, -1);
    return location ? vm_fault_at(L, location, "%s: %s", entry, message) : api_error(L, entry, "%s", message);
}

/* ---- the script digest ---- */

enum { FOLD_BYTES_PER_WORK = 8 /* bytes of text charged as one VM instruction */ };

void api_fold_bytes(lua_State *L, struct board *b, const char *s, size_t n)
{
    if (n >= FOLD_BYTES_PER_WORK)
        vm_charge(L, n / FOLD_BYTES_PER_WORK);
    b->script.digest = hash_bytes(b->script.digest, s, n);
}

void api_fold_value(lua_State *L, struct board *b, const struct api_value *v)
{
    const char *s;
    size_t n;
    double d;

    switch (v->type) {
    case LUA_TNUMBER:
        memcpy(&d, &v->bits, sizeof d);
        script_update_digest(b, !v->is_integer && isnan(d) ? 0x7ff8000000000000u : (uint64_t)v->bits);
        break;
    case LUA_TSTRING:
        s = lua_tolstring(L, v->at, &n);
        api_fold_bytes(L, b, s, n);
        break;
    case LUA_TBOOLEAN:
        script_update_digest(b, lua_toboolean(L, v->at) ? 3 : 2);
        break;
    default:
        script_update_digest(b, 16 + (uint64_t)v->type);
    }
}

void api_fold_stack_value(lua_State *L, struct board *b, int at)
{
    struct api_value v;

    api_read_value(L, at, at, &v);
    api_fold_value(L, b, &v);
}

void api_fold_call(lua_State *L, struct board *b, uint64_t entry_hash, const struct api_value *v, int n)
{
    b->script.calls++;
    script_update_digest(b, entry_hash);
    for (int i = 0; i < n; i++)
        if (v[i].given) {
            script_update_digest(b, (uint64_t)i);
            api_fold_value(L, b, &v[i]);
        }
}
