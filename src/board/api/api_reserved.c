/*
 * api_reserved.c - names that are kept for later features: a script that uses one gets an error that says so. A feature
 * that is added leaves the list; a test checks that no name of the list exists.
 */
#include <string.h>
#include "../std.h"
#include "api_parts.h"

static const struct {
    const char *of; /* a table of the API, a function, or a thing; "": the globals */
    char how;       /* '.' a field, '{' an argument, ':' a property or a verb */
    const char *names;
} reserved[] = {
    { "", '.', "item option bomb game talk say choose bg screen sound music unlock test" },
    { "board", '.', "stop ask" },
    { "boss", '.', "history" },
    { "on", '.', "start take bomb continue" },
    { "text", '.', "line lang" },
    { "enemy", ':', "orbit wander" },
    { "player", ':', "bomb state" },
    { "boot.run", '{', "continues modes screens" },
    { "boss.def", '{', "cast music portrait warning" },
    { "boss.def phase", '{', "armour bg bonus_to clear cut_in down drops last music safe talk" },
    { "bullet.clear", '{', "items" },
    { "bullet.def", '{', "drops" },
    { "enemy.def", '{', "parts rate" },
    { "enemy.spawn", '{', "follow parts rate" },
    { "motion.def step", '{', "emit path wait_for" },
    { "player.def", '{', "bomb bomb_focus collect_full collect_line deathbomb magnet needs options pull" },
    { "shot.def", '{', "every pierce" },
    { "sprite.put", '{', "follow" },
    { "text.put", '{', "font" },
};

static bool has_word(const char *words, const char *word)
{
    size_t n = strlen(word);

    for (const char *at = words; n && (at = strstr(at, word)) != NULL; at++)
        if ((at == words || at[-1] == ' ') && (at[n] == ' ' || !at[n]))
            return true;
    return false;
}

bool api_reserved(const char *of, char how, const char *name)
{
    for (size_t i = 0; i < sizeof reserved / sizeof *reserved; i++)
        if (reserved[i].how == how && !strcmp(reserved[i].of, of))
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

/* The __index of a table of the API; upvalue 1: its name. A field a game has put there is found before. */
static int missing_field(lua_State *L)
{
    const char *of = lua_tostring(L, lua_upvalueindex(1));

    if (lua_type(L, 2) == LUA_TSTRING && api_reserved(of, '.', lua_tostring(L, 2)))
        return vm_fault(L, FAULT_SCRIPT, "%s.%s %s", of, lua_tostring(L, 2), NOT_YET);
    if (lua_type(L, 2) == LUA_TSTRING && std_of_field(of, lua_tostring(L, 2)) >= 0)
        return vm_fault(L, FAULT_SCRIPT, "%s.%s: %s", of, lua_tostring(L, 2), STD_NOT_HERE);
    lua_pushnil(L);
    return 1;
}

/* Explains what is missing in the table of that name, if there is one. */
static void explain_missing(lua_State *L, const char *table)
{
    int top = lua_gettop(L);

    if (lua_getglobal(L, table) == LUA_TTABLE && !lua_getmetatable(L, -1)) {
        lua_createtable(L, 0, 1);
        lua_pushstring(L, table);
        lua_pushcclosure(L, missing_field, 1);
        lua_setfield(L, -2, "__index");
        lua_setmetatable(L, -2);
    }
    lua_settop(L, top);
}

void api_reserved_install(lua_State *L)
{
    for (size_t i = 0; i < sizeof reserved / sizeof *reserved; i++)
        if (reserved[i].how == '.' && reserved[i].of[0])
            explain_missing(L, reserved[i].of);
    for (int i = 0; i < STD_MODULES; i++)
        if (std_adds_to(i))
            explain_missing(L, std_adds_to(i));
}
