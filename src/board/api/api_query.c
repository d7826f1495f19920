/*
 * api_query.c - query; and api_place, which reads the place of every fire, spawn and burst.
 */
#include <string.h>
#include "../../base/geom.h"
#include "../api.h"

bool api_place(lua_State *L, struct board *b, const char *entry, const struct api_value *v, fx *x, fx *y)
{
    const struct api_value *from = &v[PLACE_FROM];

    if (from->given ? v[PLACE_X].given || v[PLACE_Y].given : !(v[PLACE_X].given && v[PLACE_Y].given)) {
        if (from->given || v[PLACE_X].given || v[PLACE_Y].given)
            return api_error(L, entry, "place: expected either x and y, or from");
        return api_error(L, entry, "place: expected x and y, or from (a thing), got neither");
    }
    if (!from->given) {
        *x = fx_add(v[PLACE_X].f, v[PLACE_DX].f);
        *y = fx_add(v[PLACE_Y].f, v[PLACE_DY].f);
    } else if (board_where(b, from->i, x, y)) {
        *x = fx_add(*x, v[PLACE_DX].f);
        *y = fx_add(*y, v[PLACE_DY].f);
    } else
        return false;
    const fx edge = (fx)WORLD << 16;
    *x = *x > edge ? edge : *x < -edge ? -edge : *x;
    *y = *y > edge ? edge : *y < -edge ? -edge : *y;
    return true;
}

enum { NEAR_WHAT, NEAR_X, NEAR_Y, NEAR_RADIUS, NEAR_TAG };

static const struct api_param near[] = {
    { "what", A_STR, REQ, 0, 0, NULL, NULL },      { "x", A_FX, REQ, -WORLD, WORLD, "px", NULL },
    { "y", A_FX, REQ, -WORLD, WORLD, "px", NULL }, { "radius", A_FX, REQ, 0, 32767, "px", NULL },
    { "tag", A_STR, OPT, 0, 0, NULL, NULL },
};

/* A pool to ask: its places and tags. */
struct field {
    enum handle_kind kind;
    const struct slots *s;
    const fx *x, *y;
    const uint16_t *tag;
    const uint8_t *in;
};

static struct field field_named(lua_State *L, struct board *b, const char *what)
{
    if (!strcmp(what, "bullet"))
        return (struct field){ H_BULLET, &b->bullets.s, b->bullets.x, b->bullets.y, b->bullets.tag, NULL };
    if (!strcmp(what, "shot"))
        return (struct field){ H_SHOT, &b->shots.s, b->shots.x, b->shots.y, b->shots.tag, NULL };
    if (!strcmp(what, "enemy"))
        return (struct field){ H_ENEMY, &b->enemies.s, b->enemies.x, b->enemies.y, b->enemies.tag, NULL };
    if (strcmp(what, "player"))
        api_error(L, "query.near", "what: expected bullet, enemy, shot or player, got \"%s\"", what);
    return (struct field){ H_PLAYER, &b->player.s, b->player.x, b->player.y, NULL, b->player.in };
}

static uint64_t distance_squared(const struct field *f, uint32_t i, fx x, fx y)
{
    int64_t dx = (int64_t)f->x[i] - x, dy = (int64_t)f->y[i] - y;

    return (uint64_t)(dx * dx) + (uint64_t)(dy * dy);
}

/* Sorts the list of slots at `list` (1..n) by distance, then slot: heapsort in place, so no worst case. */
static void sift(lua_State *L, int list, lua_Integer i, lua_Integer n, const struct field *f, fx x, fx y)
{
    for (;;) {
        lua_Integer far = i;
        for (lua_Integer c = 2 * i; c <= 2 * i + 1 && c <= n; c++) {
            lua_rawgeti(L, list, far);
            lua_rawgeti(L, list, c);
            uint32_t s = (uint32_t)lua_tointeger(L, -2), t = (uint32_t)lua_tointeger(L, -1);
            uint64_t ds = distance_squared(f, s, x, y), dt = distance_squared(f, t, x, y);
            lua_pop(L, 2);
            if (dt > ds || (dt == ds && t > s))
                far = c;
        }
        if (far == i)
            return;
        lua_rawgeti(L, list, i);
        lua_rawgeti(L, list, far);
        lua_rawseti(L, list, i);
        lua_rawseti(L, list, far);
        i = far;
    }
}

static void sort_near(lua_State *L, int list, lua_Integer n, const struct field *f, fx x, fx y)
{
    for (lua_Integer i = n / 2; i >= 1; i--)
        sift(L, list, i, n, f, x, y);
    for (lua_Integer end = n; end > 1; end--) {
        lua_rawgeti(L, list, 1);
        lua_rawgeti(L, list, end);
        lua_rawseti(L, list, 1);
        lua_rawseti(L, list, end);
        sift(L, list, 1, end - 1, f, x, y);
    }
}

static int query_near(lua_State *L, struct board *b, struct api_value *v)
{
    struct field f = field_named(L, b, lua_tostring(L, v[NEAR_WHAT].at));
    uint32_t tag = v[NEAR_TAG].given ? api_tag(L, "query.near", v[NEAR_TAG].at) : 0;
    uint32_t end = f.s->used ? f.s->top : f.s->live;
    lua_Integer n = 0;

    lua_newtable(L);
    int list = lua_gettop(L);
    for (uint32_t i = slots_next(f.s, 0); i < end; i = slots_next(f.s, i + 1)) {
        if ((f.in && !f.in[i]) || !board_alive(b, board_handle(b, f.kind, (int32_t)i)) ||
            (tag && (!f.tag || f.tag[i] != tag)) ||
            !geom_circles(f.x[i], f.y[i], v[NEAR_X].f, v[NEAR_Y].f, v[NEAR_RADIUS].f))
            continue;
        lua_pushinteger(L, i);
        lua_rawseti(L, list, ++n);
    }
    vm_charge(L, f.s->live + 20 * (uint64_t)n);
    sort_near(L, list, n, &f, v[NEAR_X].f, v[NEAR_Y].f);
    for (lua_Integer i = 1; i <= n; i++) {
        lua_rawgeti(L, list, i);
        lua_pushinteger(L, board_handle(b, f.kind, (int32_t)lua_tointeger(L, -1)));
        lua_rawseti(L, list, i);
        lua_pop(L, 1);
    }
    return 1;
}

static const struct api_entry entries[] = {
    { "query.near", query_near, PARAMS(near), 0, API_CHANGES, "list", "things within radius of x, y, nearest first" },
};
const struct api_module api_query = { entries, sizeof entries / sizeof *entries };
