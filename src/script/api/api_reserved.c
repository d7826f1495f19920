/*
 * api_reserved.c - names reserved for later features; a script that uses one gets an error that the name is reserved.
 * Remove a name when its feature is added; a test checks that no listed name exists.
 */
#include <string.h>
#include "../std.h"
#include "api_parts.h"

static const struct {
    const char *of; /* a table of the API, a function, or a thing; "": the globals */
    char how;       /* '.' a field, '{' an argument, ':' a property or a verb */
    const char *names;
} reserved[] = {
    { "", '.', "test" },
};

static bool has_word(const char *words, const char *word)
{
    size_t n = strlen(word);

    for (const char *at = words; n && (at = strstr(at, word)) != NULL; at++)
        if ((at == words || at[-1] == ' ') && (at[n] == ' ' || !at[n]))
            return true;
    return false;
}

/* Returns whether `of` is the row's name. In `of`, a quoted detail may follow the name (api_checked). */
static bool is_of(const char *row, const char *of)
{
    size_t n = strlen(row);

    return !strncmp(row, of, n) && (!of[n] || !strncmp(of + n, " \"", 2));
}

bool api_reserved(const char *of, char how, const char *name)
{
    for (size_t i = 0; i < sizeof reserved / sizeof *reserved; i++)
        if (reserved[i].how == how && is_of(reserved[i].of, of))
            return has_word(reserved[i].names, name);
    return false;
}

const char *api_reserved_row(int i, const char **of, char *how)
{
    if (i >= (int)(sizeof reserved / sizeof *reserved))
        return NULL;
    *of = reserved[i].of;
    *how = reserved[i].how;
    return reserved[i].names;
}

/* Tables, things and fields that exist only if rom.lua enables them. */
static const struct {
    const char *names;
    size_t room; /* offset in struct manifest of an int32_t; 0: disabled */
    const char *line;
} optional[] = {
    { "item items on.take sys.drop", offsetof(struct manifest, items),
      "items are disabled; add `items = 512` to `board`" },
    { "text.line", offsetof(struct manifest, lines), "text lines are disabled; add `lines = 32` to `board`" },
    { "laser lasers", offsetof(struct manifest, lasers), "lasers are disabled; add `lasers = 64` to `board`" },
    { "laser.curve", offsetof(struct manifest, curve_points),
      "curved lasers are disabled; add `curve_points = 2048` to `board`" },
    { "option", offsetof(struct manifest, options), "options are disabled; add `options = 16` to `board`" },
    { "bullet.ml bullet.documents bulletml", offsetof(struct manifest, bulletml),
      "BulletML is disabled; add `bulletml = 1024` to `board`" },
    { "bg layer plane", offsetof(struct manifest, bg), "backgrounds are disabled; add `maps = { ... }`" },
    { "sound music", offsetof(struct manifest, sound),
      "sound is disabled; add `sounds = { ... }` or `music = { ... }`" },
};

const char *api_off(const struct manifest *m, const char *name)
{
    int32_t room;

    for (size_t i = 0; i < sizeof optional / sizeof *optional; i++) {
        memcpy(&room, (const char *)m + optional[i].room, sizeof room);
        if (!room && has_word(optional[i].names, name))
            return optional[i].line;
    }
    return NULL;
}

void api_fault_missing_field(lua_State *L, const char *of, const char *name)
{
    const char *full = lua_pushfstring(L, "%s.%s", of, name), *line = api_off(&vm_board(L)->cart.m, full);

    if (line)
        vm_fault(L, FAULT_SCRIPT, "%s: " API_OFF, full, line);
    lua_pop(L, 1);
    if (api_reserved(of, '.', name))
        vm_fault(L, FAULT_SCRIPT, "%s.%s %s", of, name, NOT_YET);
    if (std_module_of_field(of, name) >= 0)
        vm_fault(L, FAULT_SCRIPT, "%s.%s: %s", of, name, STD_NOT_HERE);
}

/* If the global `table` is a table without a metatable, makes reads of its missing fields raise an error that explains
 * why (api_fault_missing_field). */
static void explain_missing(lua_State *L, const char *table)
{
    int top = lua_gettop(L);

    if (lua_getglobal(L, table) == LUA_TTABLE && !lua_getmetatable(L, -1))
        api_add_space(L, table);
    lua_settop(L, top);
}

void api_reserved_install(lua_State *L)
{
    for (size_t i = 0; i < sizeof reserved / sizeof *reserved; i++)
        if (reserved[i].how == '.' && reserved[i].of[0])
            explain_missing(L, reserved[i].of);
    explain_missing(L, "text"); /* its fields that come late */
    for (int i = 0; i < STD_MODULES; i++)
        if (std_adds_to(i))
            explain_missing(L, std_adds_to(i));
}
