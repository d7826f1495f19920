/*
 * api_reserved.c - globals reserved for later features, and features that rom.lua must enable. A script that reads one
 * of these names gets an error that says so. Remove a reserved global when its feature is added; a test checks that no
 * reserved global exists.
 */
#include <string.h>
#include "../script.h"
#include "../std.h"
#include "api_parts.h"

const char api_reserved_globals[] = "test";

bool api_is_reserved(const char *global)
{
    return script_list_has(api_reserved_globals, global, strlen(global));
}

/* Tables, things and fields that exist only if rom.lua enables them. */
static const struct {
    const char *names;
    size_t capacity_offset; /* offset in struct manifest of an int32_t; 0: disabled */
    const char *reason;
} optional_features[] = {
    { "item items on.take sys.drop", offsetof(struct manifest, items),
      "items are disabled; add `items = 512` to `board`" },
    { "sparks", offsetof(struct manifest, sparks), "sparks are disabled; remove `sparks = 0` from `board`" },
    { "text.line", offsetof(struct manifest, lines), "text lines are disabled; add `lines = 32` to `board`" },
    { "laser lasers", offsetof(struct manifest, lasers), "lasers are disabled; add `lasers = 64` to `board`" },
    { "laser.curve", offsetof(struct manifest, curve_points),
      "curved lasers are disabled; add `curve_points = 2048` to `board`" },
    { "option", offsetof(struct manifest, options), "options are disabled; add `options = 16` to `board`" },
    { "bullet.ml bullet.documents bulletml", offsetof(struct manifest, bulletml_runners),
      "BulletML is disabled; add `bulletml = 1024` to `board`" },
    { "bg layer plane", offsetof(struct manifest, has_backgrounds), "backgrounds are disabled; add `maps = { ... }`" },
    { "camera", offsetof(struct manifest, view_w),
      "the view shows the whole field; add `view = { w = 240, h = 320 }` to `field`" },
    { "sound music", offsetof(struct manifest, has_sound),
      "sound is disabled; add `sounds = { ... }` or `music = { ... }`" },
};

const char *api_disabled_reason(const struct manifest *m, const char *name)
{
    int32_t capacity;

    for (size_t i = 0; i < sizeof optional_features / sizeof *optional_features; i++) {
        memcpy(&capacity, (const char *)m + optional_features[i].capacity_offset, sizeof capacity);
        if (!capacity && script_list_has(optional_features[i].names, name, strlen(name)))
            return optional_features[i].reason;
    }
    return NULL;
}

void api_fault_missing_field(lua_State *L, const char *owner, const char *name)
{
    const char *full_name = lua_pushfstring(L, "%s.%s", owner, name),
               *reason = api_disabled_reason(&vm_board(L)->cart.manifest, full_name);

    if (reason)
        vm_fault(L, FAULT_SCRIPT, "%s: " API_DISABLED_FORMAT, full_name, reason);
    lua_pop(L, 1);
    if (std_module_of_field(owner, name) >= 0)
        vm_fault(L, FAULT_SCRIPT, "%s.%s: %s", owner, name, STD_NOT_PACKED);
}

void api_explain_missing_fields(lua_State *L)
{
    const int top = lua_gettop(L);

    for (int i = 0; i < STD_MODULE_COUNT; i++) {
        const char *table = std_modules[i].extended_table;
        if (table && lua_getglobal(L, table) == LUA_TTABLE && !lua_getmetatable(L, -1))
            api_add_namespace(L, table);
        lua_settop(L, top);
    }
}
