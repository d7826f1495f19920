/*
 * api_names.c - declared names, tags, suggestions for misspelt names, and the declared values of things, which are
 * stored as fx.
 */
#include <string.h>
#include "../../base/edit.h"
#include "../lua/lualib.h"
#include "api_parts.h"

/* Registry, by enum name_kind: a table name -> index; and the array of the struct name_list, which points to the
 * strings of that table. */
static const char names_key[NAME_LISTS] = { 0 }, back_key[NAME_LISTS] = { 0 };

static const char *const nouns[NAME_LISTS] = { "bullet", "shot",   "enemy", "player", "spark", "item",  "laser",
                                               "option", "motion", "tag",   "value",  "value", "value", "item" };

const char *api_names_off(lua_State *L, enum name_kind what)
{
    return api_off(&vm_board(L)->cart.m, nouns[what]);
}

/* Creates a table for each sort of name, except those that rom.lua disables. */
void api_open_names(lua_State *L)
{
    struct board *b = vm_board(L);

    memset(b->names, 0, sizeof b->names);
    for (int i = 0; i < NAME_LISTS; i++) {
        if (api_off(&b->cart.m, nouns[i]))
            continue;
        lua_newtable(L);
        lua_rawsetp(L, LUA_REGISTRYINDEX, &names_key[i]);
    }
}

/* Makes room for n names; the capacity doubles. */
static void make_room(lua_State *L, enum name_kind what, uint32_t n)
{
    struct name_list *t = &vm_board(L)->names[what];
    uint32_t room = t->room ? t->room : 16;

    while (room < n)
        room *= 2;
    if (room > t->room) {
        const char **at = lua_newuserdatauv(L, room * sizeof *at, 0);
        memset(at, 0, room * sizeof *at);
        if (t->room)
            memcpy(at, t->at, t->room * sizeof *at);
        lua_rawsetp(L, LUA_REGISTRYINDEX, &back_key[what]);
        t->at = at;
        t->room = room;
    }
    t->n = n > t->n ? n : t->n;
}

void api_names_declare(lua_State *L, enum name_kind what, const char *entry, const char *name, int index)
{
    if (api_names_find(L, what, name) != NO_SLOT)
        api_error(L, entry, "%s%s \"%s\" is already declared", nouns[what], what < N_MOTION ? " kind" : "", name);
    if (index != NO_MOTION)
        make_room(L, what, (uint32_t)index + 1);
    lua_rawgetp(L, LUA_REGISTRYINDEX, &names_key[what]);
    name = lua_pushstring(L, name);
    lua_pushinteger(L, index);
    lua_rawset(L, -3);
    lua_pop(L, 1);
    if (index != NO_MOTION)
        vm_board(L)->names[what].at[index] = name;
}

static int find_in_table(lua_State *L, enum name_kind what, const char *name)
{
    if (lua_rawgetp(L, LUA_REGISTRYINDEX, &names_key[what]) == LUA_TNIL)
        return lua_pop(L, 1), NO_SLOT;
    int index = lua_getfield(L, -1, name) == LUA_TNUMBER ? (int)lua_tointeger(L, -1) : NO_SLOT;
    lua_pop(L, 2);
    return index;
}

int api_names_find(lua_State *L, enum name_kind what, const char *name)
{
    struct board *b = vm_board(L);
    uint16_t *guess = &b->vm.guesses.names[api_guess(name, strlen(name), (unsigned)what)];
    const char *there = board_name(b, what, *guess);

    if (there && (there == name || !strcmp(there, name)))
        return *guess;
    int index = find_in_table(L, what, name);
    if (index >= 0 && index <= UINT16_MAX)
        *guess = (uint16_t)index;
    return index;
}

void api_names_push(lua_State *L, enum name_kind what, int index)
{
    const char *name = board_name(vm_board(L), what, index);

    if (name)
        lua_pushstring(L, name);
    else
        lua_pushnil(L);
}

/* Words used by other engines, and the names used here. */
static const char *const meanings[][2] = {
    { "angle", "dir" },     { "direction", "dir" }, { "heading", "dir" },        { "velocity", "speed" },
    { "color", "bank" },    { "colour", "bank" },   { "palette", "bank" },       { "health", "hp" },
    { "life", "hp" },       { "image", "sprite" },  { "texture", "sprite" },     { "hitbox", "hit" },
    { "duration", "over" }, { "count", "n" },       { "acceleration", "accel" }, { "type", "kind" },
    { "rotation", "dir" },
};

static int distance(const char *word, const char *candidate)
{
    for (size_t i = 0; i < sizeof meanings / sizeof *meanings; i++)
        if (!strcmp(meanings[i][0], word) && !strcmp(meanings[i][1], candidate))
            return 1;
    return edit_distance(word, candidate);
}

void api_suggest_nearer(const char *word, const char *candidate, int *best, const char **found)
{
    int d = distance(word, candidate);

    if (d < *best || (d == *best && *found && d < EDIT_FAR && strcmp(candidate, *found) < 0)) {
        *best = d;
        *found = candidate;
    }
}

void api_names_suggest(lua_State *L, enum name_kind what, const char *name)
{
    const char *found = NULL;
    int best = EDIT_FAR;

    lua_rawgetp(L, LUA_REGISTRYINDEX, &names_key[what]);
    lua_pushnil(L);
    while (lua_next(L, -2)) {
        lua_pop(L, 1);
        api_suggest_nearer(name, lua_tostring(L, -1), &best, &found);
    }
    lua_pop(L, 1);
    if (found)
        lua_pushstring(L, found);
    else
        lua_pushnil(L);
}

uint16_t api_tag(lua_State *L, const char *entry, int at)
{
    size_t n;
    const char *tag = lua_tolstring(L, at, &n);

    if (n > 31 || n == 0 || strlen(tag) != n)
        api_error(L, entry, "tag: expected a string of 1 to 31 bytes, got %d", (int)n);
    int i = api_names_find(L, N_TAG, tag);
    if (i != NO_SLOT)
        return (uint16_t)i;
    i = (int)vm_board(L)->names[N_TAG].n;
    i = i ? i : 1; /* tag 0 means no tag */
    if (i > 4095)
        api_error(L, entry, "tag: too many tags (at most 4095 in a run), got \"%s\"", tag);
    api_names_declare(L, N_TAG, entry, tag, i);
    return (uint16_t)i;
}

void api_push_tag(lua_State *L, uint16_t tag)
{
    if (tag)
        api_names_push(L, N_TAG, tag);
    else
        lua_pushnil(L);
}

const char *api_library_names(const char *library)
{
    return lualib_names(library);
}

/* ---- declared values ---- */

enum name_kind api_value_names_of(enum handle_kind kind)
{
    switch (kind) {
    case H_BULLET:
    case H_GROUP:
        return N_BULLET_VALUE;
    case H_SHOT:
    case H_SHOTS:
        return N_SHOT_VALUE;
    case H_ENEMY:
    case H_ENEMIES:
        return N_ENEMY_VALUE;
    default:
        return NAME_LISTS;
    }
}

enum name_kind api_value_names(const struct api_entry *e)
{
    switch (e->flags & API_VALUES ? e->name[0] : '\0') {
    case 'b':
        return N_BULLET_VALUE;
    case 's':
        return N_SHOT_VALUE;
    case 'e':
        return N_ENEMY_VALUE;
    default:
        return NAME_LISTS;
    }
}

int api_values(const struct board *b, enum name_kind names)
{
    return names == NAME_LISTS ? 0 : (int)b->names[names].n;
}

struct api_param api_value_param(const char *name)
{
    return (struct api_param){ name, A_FX, REQ, -32768, 32767, NULL, NULL, NULL };
}

fx *api_value_column(struct board *b, enum name_kind names, int k)
{
    if (names == N_ENEMY_VALUE)
        return enemies_value(&b->enemies, k);
    return bullets_value(names == N_SHOT_VALUE ? &b->shots : &b->bullets, k);
}

void api_value_set(struct board *b, enum name_kind names, uint32_t i, const struct api_value *v)
{
    for (int k = 0; k < api_values(b, names); k++)
        if (v[k].given)
            api_value_column(b, names, k)[i] = v[k].f;
}
