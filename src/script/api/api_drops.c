/*
 * api_drops.c - lists of items dropped by enemies, bullets and boss phases.
 */
#include <stdio.h>
#include "../../base/bytes.h"
#include "api_parts.h"

int64_t api_read_named_number(lua_State *L, const char *entry, const char *param_name, int at, const char *name,
                              double lo, double hi)
{
    char full_name[64];
    struct api_param p = PARAM(full_name, A_INT, REQ, lo, hi, NULL, NULL, NULL);
    struct api_value v = { 0 };

    snprintf(full_name, sizeof full_name, "%s.%s", param_name, name);
    lua_getfield(L, at, name);
    api_check(L, entry, &p, lua_gettop(L), &v);
    lua_pop(L, 1);
    return v.i;
}

enum { DROP_BYTES = 4 /* bytes per list entry: kind and number, 16 bits each */ };

/* Returns whether a string of `size` bytes (NULL: none) has the format of a list made by api_push_drops. */
static bool is_packed_drops(const struct board *b, const uint8_t *list, size_t size)
{
    if (!list || size % DROP_BYTES || size > MAX_ITEM_NAMES * DROP_BYTES)
        return false;
    for (size_t i = 0; i < size; i += DROP_BYTES)
        if (bytes_get16(list + i) >= b->item_kinds.s.live)
            return false;
    return true;
}

/* How the drops of enemies, bullets and boss phases fly. */
static const struct item_drop default_drop = { .dir = ANG_UP, .spread = (1ull << 32) / 6, .speed = 3 << 15 };

void api_push_drops(lua_State *L, const char *entry, int at)
{
    const struct api_param kind = REQUIRED("drops", A_ITEM_KIND, NULL);
    const char *disabled_reason = api_disabled_reason(&vm_board(L)->cart.manifest, "item"), *names[MAX_ITEM_NAMES];
    uint8_t list[MAX_ITEM_NAMES * DROP_BYTES];
    struct api_value v;

    if (disabled_reason)
        api_error(L, entry, "drops: " API_DISABLED_FORMAT, disabled_reason);
    int n = api_read_sorted_keys(L, entry, "drops", ITEM_TABLE_FORM, at, names, MAX_ITEM_NAMES);
    for (int i = 0; i < n; i++) {
        lua_pushstring(L, names[i]);
        api_check(L, entry, &kind, lua_gettop(L), &v);
        lua_pop(L, 1);
        bytes_put16(list + i * DROP_BYTES, (uint16_t)v.i);
        bytes_put16(list + i * DROP_BYTES + 2,
                    (uint16_t)api_read_named_number(L, entry, "drops", at, names[i], 0, UINT16_MAX));
    }
    lua_pushlstring(L, (const char *)list, (size_t)n * DROP_BYTES);
}

void api_push_folded_drops(lua_State *L, const char *entry, int at)
{
    api_push_drops(L, entry, at);
    api_fold_stack_value(L, vm_board(L), lua_gettop(L));
}

void api_drop_items(lua_State *L, struct board *b, fx x, fx y)
{
    size_t size = 0;
    const uint8_t *list = (const uint8_t *)lua_tolstring(L, -1, &size);
    uint16_t kind[MAX_ITEM_NAMES], n[MAX_ITEM_NAMES];
    struct item_drop d = default_drop;
    int n_kinds = is_packed_drops(b, list, size) ? (int)size / DROP_BYTES : 0;

    for (int i = 0; i < n_kinds; i++) {
        kind[i] = bytes_get16(list + i * DROP_BYTES);
        n[i] = bytes_get16(list + i * DROP_BYTES + 2);
        vm_charge(L, DROP_WORK * (uint64_t)n[i]);
    }
    d.x = x;
    d.y = y;
    board_drop_items(b, &d, kind, n, n_kinds);
    lua_pop(L, 1);
}
