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
static const char names_key[NAME_LISTS] = { 0 }, strings_key[NAME_LISTS] = { 0 };

static const char *const name_list_nouns[NAME_LISTS] = { "bullet", "shot",  "enemy",  "player", "spark",
                                                         "item",   "laser", "option", "motion", "tag",
                                                         "value",  "value", "value",  "item" };

const char *api_names_disabled_reason(lua_State *L, enum name_kind kind)
{
    return api_disabled_reason(&vm_board(L)->cart.manifest, name_list_nouns[kind]);
}

/* Creates a table for each sort of name, except those that rom.lua disables. */
void api_open_names(lua_State *L)
{
    struct board *b = vm_board(L);

    memset(b->names, 0, sizeof b->names);
    for (int i = 0; i < NAME_LISTS; i++) {
        if (api_disabled_reason(&b->cart.manifest, name_list_nouns[i]))
            continue;
        lua_newtable(L);
        lua_rawsetp(L, LUA_REGISTRYINDEX, &names_key[i]);
    }
}

/* Makes the list at least n names long; doubles its capacity as needed. */
static void reserve_names(lua_State *L, enum name_kind kind, uint32_t n)
{
    struct name_list *t = &vm_board(L)->names[kind];
    uint32_t capacity = t->cap ? t->cap : 16;

    while (capacity < n)
        capacity *= 2;
    if (capacity > t->cap) {
        const char **strings = lua_newuserdatauv(L, capacity * sizeof *strings, 0);
        memset(strings, 0, capacity * sizeof *strings);
        if (t->cap)
            memcpy(strings, t->name, t->cap * sizeof *strings);
        lua_rawsetp(L, LUA_REGISTRYINDEX, &strings_key[kind]);
        t->name = strings;
        t->cap = capacity;
    }
    t->n = n > t->n ? n : t->n;
}

void api_names_declare(lua_State *L, enum name_kind kind, const char *entry, const char *name, int index)
{
    if (api_names_find(L, kind, name) != NO_SLOT)
        api_error(L, entry, "%s%s \"%s\" is already declared", name_list_nouns[kind], kind < N_MOTION ? " kind" : "",
                  name);
    if (index != NO_MOTION)
        reserve_names(L, kind, (uint32_t)index + 1);
    lua_rawgetp(L, LUA_REGISTRYINDEX, &names_key[kind]);
    name = lua_pushstring(L, name);
    lua_pushinteger(L, index);
    lua_rawset(L, -3);
    lua_pop(L, 1);
    if (index != NO_MOTION)
        vm_board(L)->names[kind].name[index] = name;
}

static int find_in_table(lua_State *L, enum name_kind kind, const char *name)
{
    if (lua_rawgetp(L, LUA_REGISTRYINDEX, &names_key[kind]) == LUA_TNIL)
        return lua_pop(L, 1), NO_SLOT;
    int index = lua_getfield(L, -1, name) == LUA_TNUMBER ? (int)lua_tointeger(L, -1) : NO_SLOT;
    lua_pop(L, 2);
    return index;
}

int api_names_find(lua_State *L, enum name_kind kind, const char *name)
{
    struct board *b = vm_board(L);
    uint16_t *guess = &b->vm.guesses.names[api_guess_index(name, strlen(name), (unsigned)kind)];
    const char *guessed = board_name(b, kind, *guess);

    if (guessed && (guessed == name || !strcmp(guessed, name)))
        return *guess;
    int index = find_in_table(L, kind, name);
    if (index >= 0 && index <= UINT16_MAX)
        *guess = (uint16_t)index;
    return index;
}

void api_names_push(lua_State *L, enum name_kind kind, int index)
{
    lua_pushstring(L, board_name(vm_board(L), kind, index)); /* NULL becomes nil */
}

/* Words used by other engines, and the names used here. */
static const char *const synonyms[][2] = {
    { "angle", "dir" },     { "direction", "dir" }, { "heading", "dir" },        { "velocity", "speed" },
    { "color", "bank" },    { "colour", "bank" },   { "palette", "bank" },       { "health", "hp" },
    { "life", "hp" },       { "image", "sprite" },  { "texture", "sprite" },     { "hitbox", "hit" },
    { "duration", "over" }, { "count", "n" },       { "acceleration", "accel" }, { "type", "kind" },
    { "rotation", "dir" },  { "max", "limit" },     { "maxv", "limit" },         { "speed", "speed_scale" },
};

static int word_distance(const char *word, const char *candidate)
{
    for (size_t i = 0; i < sizeof synonyms / sizeof *synonyms; i++)
        if (!strcmp(synonyms[i][0], word) && !strcmp(synonyms[i][1], candidate))
            return 0;
    return edit_distance(word, candidate);
}

void api_consider(struct api_suggestion *s, const char *candidate)
{
    const int distance = word_distance(s->word, candidate), best = s->nearest ? s->distance : EDIT_TOO_FAR;

    if (distance < best || (distance == best && s->nearest && strcmp(candidate, s->nearest) < 0)) {
        s->distance = distance;
        s->nearest = candidate;
    }
}

uint16_t api_intern_tag(lua_State *L, const char *entry, int at)
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
    return lualib_retained_names(library);
}

/* ---- declared values ---- */

enum name_kind api_kind_value_names(enum handle_kind kind)
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

enum name_kind api_entry_value_names(const struct api_entry *e)
{
    switch (e->flags & API_TAKES_VALUES ? e->name[0] : '\0') {
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

int api_value_count(const struct board *b, enum name_kind names)
{
    return names == NAME_LISTS ? 0 : (int)b->names[names].n;
}

struct api_param api_value_param(const char *name)
{
    return (struct api_param)PARAM(name, A_FX, REQ, -32768, 32767, NULL, NULL, NULL);
}

fx *api_value_column(struct board *b, enum name_kind names, int k)
{
    if (names == N_ENEMY_VALUE)
        return enemies_value_column(&b->enemies, k);
    return bullets_value_column(names == N_SHOT_VALUE ? &b->shots : &b->bullets, k);
}

void api_set_values(struct board *b, enum name_kind names, uint32_t i, const struct api_value *v)
{
    for (int k = 0; k < api_value_count(b, names); k++)
        if (v[k].given)
            api_value_column(b, names, k)[i] = v[k].f;
}
