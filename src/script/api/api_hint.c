/*
 * api_hint.c - errors about unknown names, and reading tables of settings. An error suggests the nearest known name or,
 * if none is near, lists the known names if the list is short.
 */
#include <stdio.h>
#include <string.h>
#include "api_parts.h"

enum { MAX_LIST_LENGTH = 100 }; /* characters of the longest list worth printing */

void api_hint_begin(struct api_hint *h, const char *word)
{
    *h = (struct api_hint){ .suggestion.word = word };
}

void api_hint_add(struct api_hint *h, const char *name)
{
    const size_t n = strlen(h->list);

    api_consider(&h->suggestion, name);
    h->n++;
    if (n + strlen(name) + 2 < MAX_LIST_LENGTH)
        snprintf(h->list + n, sizeof h->list - n, "%s%s", n ? ", " : "", name);
    else
        h->is_list_long = true;
}

const char *api_push_did_you_mean(lua_State *L, const struct api_suggestion *s, const char *otherwise)
{
    return s->nearest ? lua_pushfstring(L, " (did you mean \"%s\"?)", s->nearest) : lua_pushstring(L, otherwise);
}

const char *api_hint_push(lua_State *L, const struct api_hint *h, const char *label)
{
    if (h->suggestion.nearest)
        return api_push_did_you_mean(L, &h->suggestion, "");
    if (h->n == 0)
        return lua_pushfstring(L, " (%s: none)", label);
    return h->is_list_long ? lua_pushliteral(L, "") : lua_pushfstring(L, " (%s: %s)", label, h->list);
}

/* ---- suggestions for unknown globals ---- */

enum { SHORT_NAME_LENGTH = 2 /* bytes; a name this short resembles too many others */ };

/* Suggests the nearest local or upvalue visible to the code at level 1. */
static void suggest_local(lua_State *L, struct api_suggestion *s)
{
    const char *local;
    lua_Debug ar;

    if (!lua_getstack(L, 1, &ar))
        return;
    for (int i = 1; (local = lua_getlocal(L, &ar, i)) != NULL; i++, lua_pop(L, 1))
        if (strlen(local) >= SHORT_NAME_LENGTH && local[0] != '(')
            api_consider(s, local);
    lua_getinfo(L, "f", &ar);
    for (int i = 1; (local = lua_getupvalue(L, -1, i)) != NULL; i++, lua_pop(L, 1))
        if (strlen(local) >= SHORT_NAME_LENGTH && strcmp(local, "_ENV"))
            api_consider(s, local);
    lua_pop(L, 1);
}

const char *api_push_suggestion(lua_State *L, const char *name, bool is_read)
{
    struct api_suggestion local = { .word = name }, global = { .word = name };

    if (strlen(name) > SHORT_NAME_LENGTH)
        suggest_local(L, &local);
    if (strlen(name) > SHORT_NAME_LENGTH && is_read) {
        lua_pushglobaltable(L);
        for (lua_pushnil(L); lua_next(L, -2); lua_pop(L, 1))
            if (lua_type(L, -2) == LUA_TSTRING)
                api_consider(&global, lua_tostring(L, -2));
        lua_pop(L, 1);
    }
    const bool is_global = global.nearest && (!local.nearest || global.distance < local.distance);
    return api_push_did_you_mean(L, is_global ? &global : &local, "");
}

/* ---- tables of settings ---- */

static const char *get_field_key(const struct api_param *p)
{
    const char *dot = strrchr(p->name, '.');

    return dot ? dot + 1 : p->name;
}

bool api_is_known_field(lua_State *L, const char *key, const void *fields)
{
    const struct api_fields *f = fields;

    vm_charge(L, 1);
    for (int i = 0; key && i < f->n; i++)
        if (!strcmp(key, get_field_key(&f->params[i])))
            return true;
    return key && f->value_names != NAME_LISTS && api_names_find(L, f->value_names, key) != NO_SLOT;
}

void api_raise_unknown_key(lua_State *L, const char *entry, const struct api_fields *f)
{
    struct api_hint hint;

    if (lua_type(L, -1) != LUA_TSTRING)
        api_error(L, entry, "expected named arguments ({ name = value }), got key %s", api_push_description(L, -1));
    const char *key = lua_tostring(L, -1);
    api_hint_begin(&hint, key);
    for (int i = 0; i < f->n; i++)
        api_hint_add(&hint, get_field_key(&f->params[i]));
    for (int k = 0; f->value_names != NAME_LISTS && k < api_value_count(vm_board(L), f->value_names); k++)
        api_hint_add(&hint, board_name(vm_board(L), f->value_names, k));
    api_error(L, entry, "unknown argument \"%s\"%s", key, api_hint_push(L, &hint, "arguments"));
}

void api_read_fields(lua_State *L, const char *entry, const char *prefix, const struct api_fields *f, int at,
                     struct api_value *v)
{
    char full_name[80];

    luaL_checkstack(L, f->n + 8, NULL);
    if (luakeys_push_unknown(L, at, api_is_known_field, f)) {
        lua_pushfstring(L, "%s: %s", entry, prefix);
        lua_insert(L, -2);
        api_raise_unknown_key(L, prefix ? lua_tostring(L, -2) : entry, f);
    }
    for (int i = 0; i < f->n; i++) {
        struct api_param p = f->params[i];
        if (prefix) {
            snprintf(full_name, sizeof full_name, "%s.%s", prefix, get_field_key(&p));
            p.name = full_name;
        }
        v[i] = (struct api_value){ 0 };
        lua_getfield(L, at, get_field_key(&f->params[i]));
        api_check(L, entry, &p, lua_gettop(L), &v[i]);
    }
}

int api_read_sorted_keys(lua_State *L, const char *entry, const char *param_name, const char *expected, int at,
                         const char **names, int max)
{
    bool is_list = false;
    int n = 0;

    for (lua_pushnil(L); lua_next(L, at); lua_pop(L, 1)) {
        const char *name = luakeys_text(L, -2);
        vm_charge(L, 1);
        is_list |= !name;
        if (n++ >= max || is_list)
            continue;
        int i = n - 1;
        for (; i > 0 && strcmp(names[i - 1], name) > 0; i--)
            names[i] = names[i - 1];
        names[i] = name;
    }
    if (is_list)
        api_error(L, entry, "%s: expected %s, got a list", param_name, expected);
    if (n > max)
        api_error(L, entry, "%s: expected at most %d names, got %d", param_name, max, n);
    return n;
}
