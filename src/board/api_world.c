/*
 * api_world.c - rng, angle, query, save, board, rom, and sys, which only @std sees; and how places are given.
 */
#include <math.h>
#include <string.h>
#include "../base/geom.h"
#include "../base/hash.h"
#include "../base/rng.h"
#include "../base/trig.h"
#include "api.h"
#include "events_run.h"

bool api_place(lua_State *L, struct board *b, const char *entry, const struct api_value *v, fx *x, fx *y)
{
    const struct api_value *from = &v[2];

    if (from->given ? v[0].given || v[1].given : !(v[0].given && v[1].given)) {
        if (from->given || v[0].given || v[1].given)
            return api_error(L, entry, "place: expected either x and y, or from");
        return api_error(L, entry, "place: expected x and y, or from (a thing), got neither");
    }
    if (!from->given) {
        *x = fx_add(v[0].f, v[3].f);
        *y = fx_add(v[1].f, v[4].f);
    } else if (board_where(b, from->i, x, y)) {
        *x = fx_add(*x, v[3].f);
        *y = fx_add(*y, v[4].f);
    } else
        return false;
    const fx edge = (fx)WORLD << 16;
    *x = *x > edge ? edge : *x < -edge ? -edge : *x;
    *y = *y > edge ? edge : *y < -edge ? -edge : *y;
    return true;
}

/* ---- rng ---- */

static uint64_t draw(struct board *b, uint64_t below)
{
    struct rng r;

    memcpy(r.s, b->core.random, sizeof r.s);
    uint64_t v = below ? rng_below(&r, below) : rng_next(&r);
    memcpy(b->core.random, r.s, sizeof r.s);
    return v;
}

static const struct api_param ab_int[] = { { "a", A_INT, REQ, -9e15, 9e15, NULL, NULL },
                                           { "b", A_INT, REQ, -9e15, 9e15, NULL, NULL } };
static const struct api_param ab_number[] = { { "a", A_NUM, REQ, -1e15, 1e15, NULL, NULL },
                                              { "b", A_NUM, REQ, -1e15, 1e15, NULL, NULL } };
static const struct api_param p_only[] = { { "p", A_NUM, REQ, 0, 1, NULL, NULL } };
static const struct api_param list_only[] = { { "list", A_TABLE, REQ, 0, 0, NULL, NULL } };

static int rng_int(lua_State *L, struct board *b, struct api_value *v)
{
    if (v[0].i > v[1].i)
        return api_error(L, "rng.int", "a is greater than b");
    lua_pushinteger(L, v[0].i + (int64_t)draw(b, (uint64_t)(v[1].i - v[0].i) + 1));
    return 1;
}

/* 53 random bits, so that the fraction is exact. */
static double fraction(struct board *b)
{
    return (double)(draw(b, 0) >> 11) / 9007199254740992.0;
}

static int rng_number(lua_State *L, struct board *b, struct api_value *v)
{
    double n = v[0].n + (v[1].n - v[0].n) * fraction(b);

    if (n >= v[1].n && v[1].n > v[0].n) /* the sum was rounded up */
        n = v[0].n;
    lua_pushnumber(L, n);
    return 1;
}

static int rng_chance(lua_State *L, struct board *b, struct api_value *v)
{
    lua_pushboolean(L, fraction(b) < v[0].n);
    return 1;
}

static int rng_pick(lua_State *L, struct board *b, struct api_value *v)
{
    uint64_t n = lua_rawlen(L, v[0].at);

    if (!n)
        return api_error(L, "rng.pick", "the list is empty");
    lua_rawgeti(L, v[0].at, (lua_Integer)draw(b, n) + 1);
    return 1;
}

static int rng_dir(lua_State *L, struct board *b, struct api_value *v)
{
    (void)v;
    lua_pushnumber(L, trig_to_degrees((ang)(draw(b, 0) >> 32)));
    return 1;
}

/* ---- angle ---- */

static const struct api_param two[] = { { "a", A_ANY, REQ, 0, 0, NULL, NULL }, { "b", A_ANY, REQ, 0, 0, NULL, NULL } };
static const struct api_param dxdy[] = { { "dx", A_FX, REQ, -WORLD, WORLD, "px", NULL },
                                         { "dy", A_FX, REQ, -WORLD, WORLD, "px", NULL } };
static const struct api_param two_dirs[] = { { "a", A_DIR, REQ, 0, 0, NULL, NULL },
                                             { "b", A_DIR, REQ, 0, 0, NULL, NULL } };
static const struct api_param one_dir[] = { { "d", A_DIR, REQ, 0, 0, NULL, NULL } };

/* A thing, or a table with x and y. False: a dead thing. */
static bool where(lua_State *L, struct board *b, const char *entry, const char *name, int at, fx *x, fx *y)
{
    struct api_param px = { "x", A_FX, REQ, -WORLD, WORLD, "px", NULL },
                     py = { "y", A_FX, REQ, -WORLD, WORLD, "px", NULL },
                     thing = { name, A_THING, REQ, PLACES, 0, NULL, NULL };
    struct api_value v = { 0 };

    if (lua_type(L, at) != LUA_TTABLE) {
        api_check(L, entry, &thing, at, &v);
        return board_where(b, v.i, x, y);
    }
    lua_getfield(L, at, "x");
    api_check(L, entry, &px, lua_gettop(L), &v);
    *x = v.f;
    lua_getfield(L, at, "y");
    api_check(L, entry, &py, lua_gettop(L), &v);
    *y = v.f;
    lua_pop(L, 2);
    return true;
}

static int angle_to(lua_State *L, struct board *b, struct api_value *v)
{
    fx ax, ay, bx, by;

    if (!where(L, b, "angle.to", "a", v[0].at, &ax, &ay) || !where(L, b, "angle.to", "b", v[1].at, &bx, &by) ||
        (ax == bx && ay == by))
        lua_pushnumber(L, 90); /* nowhere to point: down, as aim does */
    else
        lua_pushnumber(L, trig_to_degrees(trig_atan2(fx_sub(by, ay), fx_sub(bx, ax))));
    return 1;
}

static int angle_of(lua_State *L, struct board *b, struct api_value *v)
{
    (void)b;
    lua_pushnumber(L, trig_to_degrees(trig_atan2(v[1].f, v[0].f)));
    return 1;
}

static int angle_difference(lua_State *L, struct board *b, struct api_value *v)
{
    (void)b;
    int32_t d = trig_difference(v[0].a, v[1].a);
    lua_pushnumber(L, (double)d * 360.0 / 4294967296.0);
    return 1;
}

static int angle_sin(lua_State *L, struct board *b, struct api_value *v)
{
    (void)b;
    lua_pushnumber(L, trig_sin30(v[0].a) / 1073741824.0);
    return 1;
}

static int angle_cos(lua_State *L, struct board *b, struct api_value *v)
{
    (void)b;
    lua_pushnumber(L, trig_cos30(v[0].a) / 1073741824.0);
    return 1;
}

/* ---- query ---- */

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

static uint64_t apart(const struct field *f, uint32_t i, fx x, fx y)
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
            uint64_t ds = apart(f, s, x, y), dt = apart(f, t, x, y);
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
    struct field f = field_named(L, b, lua_tostring(L, v[0].at));
    uint32_t tag = v[4].given ? api_tag(L, "query.near", v[4].at) : 0;
    uint32_t end = f.s->used ? f.s->top : f.s->live;
    lua_Integer n = 0;

    lua_newtable(L);
    int list = lua_gettop(L);
    for (uint32_t i = slots_next(f.s, 0); i < end; i = slots_next(f.s, i + 1)) {
        if ((f.in && !f.in[i]) || (tag && (!f.tag || f.tag[i] != tag)) ||
            !geom_circles(f.x[i], f.y[i], v[1].f, v[2].f, v[3].f))
            continue;
        lua_pushinteger(L, i);
        lua_rawseti(L, list, ++n);
    }
    vm_charge(L, f.s->live + 20 * (uint64_t)n);
    sort_near(L, list, n, &f, v[1].f, v[2].f);
    for (lua_Integer i = 1; i <= n; i++) {
        lua_rawgeti(L, list, i);
        lua_pushinteger(L, board_handle(b, f.kind, (int32_t)lua_tointeger(L, -1)));
        lua_rawseti(L, list, i);
        lua_pop(L, 1);
    }
    return 1;
}

/* ---- save ---- */

static const struct api_param save_get[] = { { "key", A_STR, REQ, 1, NV_KEY, NULL, NULL },
                                             { "default", A_ANY, OPT, 0, 0, NULL, NULL } };
static const struct api_param save_set[] = { { "key", A_STR, REQ, 1, NV_KEY, NULL, NULL },
                                             { "value", A_ANY, OPT, 0, 0, NULL, NULL } };

static int save_get_run(lua_State *L, struct board *b, struct api_value *v)
{
    struct nv_value kept = nvram_get(&b->nvram, lua_tostring(L, v[0].at));
    double d;

    switch (kept.type) {
    case NV_NONE:
        lua_pushvalue(L, v[1].at);
        break;
    case NV_INT:
        lua_pushinteger(L, (lua_Integer)kept.bits);
        break;
    case NV_FLOAT:
        memcpy(&d, &kept.bits, sizeof d);
        lua_pushnumber(L, d);
        break;
    case NV_TEXT:
        lua_pushlstring(L, kept.text, kept.length);
        break;
    case NV_BOOL:
        lua_pushboolean(L, kept.bits != 0);
        break;
    }
    return 1;
}

static int save_set_run(lua_State *L, struct board *b, struct api_value *v)
{
    struct nv_value keep = { .type = NV_NONE };
    double d;
    const char *s;

    switch (lua_type(L, v[1].at)) {
    case LUA_TNIL:
        break;
    case LUA_TNUMBER:
        keep.type = lua_isinteger(L, v[1].at) ? NV_INT : NV_FLOAT;
        keep.bits = (uint64_t)lua_tointeger(L, v[1].at);
        d = lua_tonumber(L, v[1].at);
        if (!isfinite(d))
            return api_error(L, "save.set", "value: expected a finite number");
        if (keep.type == NV_FLOAT)
            memcpy(&keep.bits, &d, sizeof d);
        break;
    case LUA_TSTRING:
        keep.type = NV_TEXT;
        s = lua_tolstring(L, v[1].at, &keep.length);
        if (keep.length > NV_STRING)
            return api_error(L, "save.set", "value: a string of at most %d bytes, got %d", NV_STRING, (int)keep.length);
        memcpy(keep.text, s, keep.length);
        break;
    case LUA_TBOOLEAN:
        keep.type = NV_BOOL;
        keep.bits = (uint64_t)lua_toboolean(L, v[1].at);
        break;
    default:
        return api_error(L, "save.set", "value: expected a number, string, boolean or nil, got a %s",
                         luaL_typename(L, v[1].at));
    }
    if (!nvram_set(&b->nvram, lua_tostring(L, v[0].at), &keep))
        return api_error(L, "save.set", "all %d keys are taken", NV_SAVES);
    return 0;
}

/* ---- board ---- */

static const struct api_param name_opt[] = { { "name", A_STR, OPT, 0, 0, NULL, NULL } };
static const struct api_param name_req[] = { { "name", A_STR, REQ, 0, 0, NULL, NULL } };
static const struct api_param chip_req[] = { { "chip", A_STR, REQ, 0, 0, NULL, NULL } };
static const struct api_param demo_req[] = { { "demo", A_STR, REQ, 1, 63, NULL, NULL } };
static const struct api_param value_req[] = { { "v", A_ANY, REQ, 0, 0, NULL, NULL } };

static int board_frame_run(lua_State *L, struct board *b, struct api_value *v)
{
    (void)v;
    lua_pushinteger(L, b->core.frame);
    return 1;
}

static int board_difficulty(lua_State *L, struct board *b, struct api_value *v)
{
    const struct manifest *m = &b->cart.m;

    if (v[0].given) {
        int i = 0;
        while (i < m->n_difficulties && strcmp(m->difficulties[i], lua_tostring(L, v[0].at)))
            i++;
        if (i == m->n_difficulties)
            return api_error(L, "board.difficulty", "difficulty \"%s\" is not in rom.lua", lua_tostring(L, v[0].at));
        b->core.difficulty = (uint32_t)i;
    }
    lua_pushstring(L, m->difficulties[b->core.difficulty]);
    return 1;
}

static int board_dip(lua_State *L, struct board *b, struct api_value *v)
{
    const struct manifest *m = &b->cart.m;

    for (int i = 0; i < m->n_dips; i++) {
        if (strcmp(m->dips[i].name, lua_tostring(L, v[0].at)))
            continue;
        if (m->dips[i].number)
            lua_pushinteger(L, b->start.dip[i]);
        else
            lua_pushstring(L, m->dips[i].value_name[b->start.dip[i]]);
        return 1;
    }
    return api_error(L, "board.dip", "dip \"%s\" is not in rom.lua", lua_tostring(L, v[0].at));
}

static int board_reset_run(lua_State *L, struct board *b, struct api_value *v)
{
    (void)L, (void)v;
    b->reset = true;
    return 0;
}

static int count_of(lua_State *L, struct board *b, const char *entry, int at,
                    int64_t (*ask)(const struct board *, const char *))
{
    int64_t n = ask(b, lua_tostring(L, at));

    if (n < 0)
        return api_error(L, entry, "chip \"%s\" is not one of this board", lua_tostring(L, at));
    lua_pushinteger(L, n);
    return 1;
}

static int board_live_run(lua_State *L, struct board *b, struct api_value *v)
{
    return count_of(L, b, "board.live", v[0].at, board_live);
}

static int board_refused_run(lua_State *L, struct board *b, struct api_value *v)
{
    return count_of(L, b, "board.refused", v[0].at, board_refused);
}

static int board_attract(lua_State *L, struct board *b, struct api_value *v)
{
    b->hand->out.request = REQUEST_ATTRACT;
    strcpy(b->hand->out.attract, lua_tostring(L, v[0].at));
    return 0;
}

static int board_note(lua_State *L, struct board *b, struct api_value *v)
{
    double d = lua_tonumber(L, v[0].at);
    uint64_t bits;
    size_t n;
    const char *s;

    switch (lua_type(L, v[0].at)) {
    case LUA_TNUMBER:
        memcpy(&bits, &d, sizeof bits);
        if (isnan(d))
            return api_error(L, "board.note", "v: not a number");
        b->core.notes =
            hash_fold(b->core.notes, lua_isinteger(L, v[0].at) ? (uint64_t)lua_tointeger(L, v[0].at) : bits);
        return 0;
    case LUA_TSTRING:
        s = lua_tolstring(L, v[0].at, &n);
        b->core.notes = hash_bytes(b->core.notes, s, n);
        return 0;
    case LUA_TBOOLEAN:
        b->core.notes = hash_fold(b->core.notes, 2 + (uint64_t)lua_toboolean(L, v[0].at));
        return 0;
    default:
        return api_error(L, "board.note", "v: expected a number, string or boolean, got a %s",
                         luaL_typename(L, v[0].at));
    }
}

/* ---- rom ---- */

static int rom_has(lua_State *L, struct board *b, struct api_value *v)
{
    const char *name = lua_tostring(L, v[0].at), *text;
    size_t n;

    lua_pushboolean(L, cart_find_sprite(&b->cart, name) >= 0 || cart_text(&b->cart, name, &text, &n) ||
                           rom_find(b->cart.rom, name) >= 0);
    return 1;
}

static int rom_text(lua_State *L, struct board *b, struct api_value *v)
{
    const char *text;
    size_t n;

    if (!cart_text(&b->cart, lua_tostring(L, v[0].at), &text, &n))
        return api_error(L, "rom.text", "no text \"%s\" in the game", lua_tostring(L, v[0].at));
    lua_pushlstring(L, text, n);
    return 1;
}

static int read_only(lua_State *L)
{
    return vm_fault(L, FAULT_SCRIPT, "rom is read only");
}

/* Leaves a read-only view of the table on top of the stack in its place. */
static void seal(lua_State *L)
{
    lua_newtable(L);
    lua_createtable(L, 0, 3);
    lua_rotate(L, -3, -1);
    lua_setfield(L, -2, "__index");
    lua_pushcfunction(L, read_only);
    lua_setfield(L, -2, "__newindex");
    lua_pushboolean(L, 0);
    lua_setfield(L, -2, "__metatable");
    lua_setmetatable(L, -2);
}

static void rect(lua_State *L, const char *name, int x, int y, int w, int h)
{
    const char *const keys[] = { "x", "y", "w", "h" };
    const int values[] = { x, y, w, h };

    lua_createtable(L, 0, 4);
    for (int i = 0; i < 4; i++) {
        lua_pushinteger(L, values[i]);
        lua_setfield(L, -2, keys[i]);
    }
    seal(L);
    lua_setfield(L, -2, name);
}

void api_rom_open(lua_State *L)
{
    const struct manifest *m = &vm_board(L)->cart.m;

    lua_getglobal(L, "rom");
    lua_pushstring(L, m->title);
    lua_setfield(L, -2, "title");
    rect(L, "screen", 0, 0, m->screen_w, m->screen_h);
    rect(L, "field", m->field_x, m->field_y, m->field_w, m->field_h);
    seal(L);
    lua_setglobal(L, "rom");
}

/* ---- sys ---- */

int player_enter(lua_State *L, struct board *b, uint32_t i, uint16_t kind);

static const struct api_param fail[] = { { "name", A_STR, REQ, 0, 0, NULL, NULL },
                                         { "message", A_STR, REQ, 0, 0, NULL, NULL } };
static const struct api_param sys_near[] = { { "word", A_ANY, REQ, 0, 0, NULL, NULL },
                                             { "list", A_TABLE, REQ, 0, 0, NULL, NULL } };
static const struct api_param join[] = { { "i", A_PAD, REQ, 0, 0, NULL, NULL },
                                         { "kind", A_PLAYER_KIND, REQ, 0, 0, NULL, NULL } };
static const struct api_param pad_only[] = { { "i", A_PAD, REQ, 0, 0, NULL, NULL } };
static const struct api_param scope_opt[] = { { "scope", A_THING, OPT, 1 << H_TASK, 0, NULL, NULL } };
static const struct api_param hold[] = { { "e", A_THING, REQ, 1 << H_ENEMY, 0, NULL, NULL },
                                         { "on", A_BOOL, REQ, 0, 0, NULL, NULL } };

static int sys_fail(lua_State *L, struct board *b, struct api_value *v)
{
    (void)b;
    return api_error(L, lua_tostring(L, v[0].at), "%s", lua_tostring(L, v[1].at));
}

static int sys_near_run(lua_State *L, struct board *b, struct api_value *v)
{
    int best = 99;
    lua_Integer found = 0, n = (lua_Integer)lua_rawlen(L, v[1].at);

    (void)b;
    if (lua_type(L, v[0].at) != LUA_TSTRING)
        return lua_pushnil(L), 1;
    for (lua_Integer i = 1; i <= n; i++) {
        if (lua_rawgeti(L, v[1].at, i) == LUA_TSTRING) {
            int d = words_apart(lua_tostring(L, v[0].at), lua_tostring(L, -1));
            if (d < best)
                best = d, found = i;
        }
        lua_pop(L, 1);
    }
    if (!found)
        lua_pushnil(L);
    else
        lua_rawgeti(L, v[1].at, found);
    return 1;
}

static int sys_loading(lua_State *L, struct board *b, struct api_value *v)
{
    (void)v;
    lua_pushboolean(L, b->vm.loading);
    return 1;
}

static int sys_emit(lua_State *L, struct board *b, struct api_value *v)
{
    const char *name = lua_tostring(L, v[0].at);
    int n = lua_gettop(L) - 1;

    if (!events_emit(b, L, name, n))
        return api_error(L, "sys.emit", "no event \"%s\"", name);
    return 0;
}

static int sys_practice(lua_State *L, struct board *b, struct api_value *v)
{
    (void)v;
    b->vm.asked = true;
    lua_pushstring(L, b->start.stage);
    return 1;
}

static int sys_join(lua_State *L, struct board *b, struct api_value *v)
{
    return v[0].i ? player_enter(L, b, (uint32_t)v[0].i - 1, (uint16_t)v[1].i) : 0;
}

static int sys_leave(lua_State *L, struct board *b, struct api_value *v)
{
    (void)L;
    if (v[0].i)
        player_leave(&b->player, (uint32_t)v[0].i - 1);
    return 0;
}

static int sys_wipe(lua_State *L, struct board *b, struct api_value *v)
{
    const uint8_t *p = cart_palette(&b->cart, "main");

    (void)L, (void)v;
    EACH_LIVE (i, &b->bullets.s)
        bullets_drop(&b->bullets, i);
    EACH_LIVE (i, &b->shots.s)
        bullets_drop(&b->shots, i);
    EACH_LIVE (i, &b->enemies.s)
        enemies_drop(&b->enemies, i);
    EACH_LIVE (i, &b->sparks.s)
        slots_drop(&b->sparks.s, i);
    EACH_LIVE (i, &b->sprites.s)
        slots_drop(&b->sprites.s, i);
    pal_rest(&b->pal);
    for (int i = 0; i < COLOURS; i++, p += 3)
        pal_set(&b->pal, i, (uint32_t)p[0] << 16 | (uint32_t)p[1] << 8 | p[2]);
    fix_clear(&b->fix, 0, 0, (int)b->fix.cols, (int)b->fix.rows);
    return 0;
}

static int sys_freeze(lua_State *L, struct board *b, struct api_value *v)
{
    (void)L;
    b->core.frozen = v[0].given ? v[0].i : 0;
    return 0;
}

static int sys_hold(lua_State *L, struct board *b, struct api_value *v)
{
    uint32_t i = handle_slot(v[0].i);

    (void)L;
    if (board_alive(b, v[0].i))
        b->enemies.flags[i] = (uint8_t)(v[1].i ? b->enemies.flags[i] | ENEMY_HELD : b->enemies.flags[i] & ~ENEMY_HELD);
    return 0;
}

static int sys_kinds(lua_State *L, struct board *b, struct api_value *v)
{
    static const char *const words[] = { "bullet", "shot", "enemy", "player", "spark" };
    const struct slots *s[] = { &b->bullet_kinds.s, &b->shot_kinds.s, &b->enemy_kinds.s, &b->player_kinds.s,
                                &b->spark_kinds.s };

    for (int k = 0; k < 5; k++) {
        if (strcmp(words[k], lua_tostring(L, v[0].at)))
            continue;
        lua_newtable(L);
        for (uint32_t i = 0; i < s[k]->live; i++) {
            names_push(L, (enum api_names)k, (int)i);
            lua_rawseti(L, -2, (lua_Integer)i + 1);
        }
        return 1;
    }
    return api_error(L, "sys.kinds", "no kinds of \"%s\"", lua_tostring(L, v[0].at));
}

static int sys_players(lua_State *L, struct board *b, struct api_value *v)
{
    (void)v;
    lua_pushinteger(L, b->cart.m.players);
    return 1;
}

static int sys_difficulties(lua_State *L, struct board *b, struct api_value *v)
{
    (void)v;
    lua_newtable(L);
    for (int i = 0; i < b->cart.m.n_difficulties; i++) {
        lua_pushstring(L, b->cart.m.difficulties[i]);
        lua_rawseti(L, -2, i + 1);
    }
    return 1;
}

static int sys_glyphs(lua_State *L, struct board *b, struct api_value *v)
{
    (void)v;
    lua_pushinteger(L, b->cart.n_glyphs);
    return 1;
}

static int sys_clock(lua_State *L, struct board *b, struct api_value *v)
{
    (void)v;
    lua_pushinteger(L, b->core.clock);
    return 1;
}

#define NO_PARAMS NULL, 0
static const struct api_entry entries[] = {
    { "rng.int", rng_int, PARAMS(ab_int), 2, API_CHANGES, "integer", "a whole number from a to b, both included" },
    { "rng.number", rng_number, PARAMS(ab_number), 2, API_CHANGES, "number",
      "a number from a up to, not including, b" },
    { "rng.chance", rng_chance, PARAMS(p_only), 1, API_CHANGES, "boolean", "true with probability p" },
    { "rng.pick", rng_pick, PARAMS(list_only), 1, API_CHANGES, "value", "an entry of a list" },
    { "rng.dir", rng_dir, NO_PARAMS, 0, API_CHANGES, "degrees", "any direction" },
    { "angle.to", angle_to, PARAMS(two), 2, 0, "degrees", "the direction from a to b: things or { x=, y= }" },
    { "angle.of", angle_of, PARAMS(dxdy), 2, 0, "degrees", "the direction of (dx, dy)" },
    { "angle.difference", angle_difference, PARAMS(two_dirs), 2, 0, "degrees", "the turn from a to b, -180 to 180" },
    { "angle.sin", angle_sin, PARAMS(one_dir), 1, 0, "number", "the sine of d degrees" },
    { "angle.cos", angle_cos, PARAMS(one_dir), 1, 0, "number", "the cosine of d degrees" },
    { "query.near", query_near, PARAMS(near), 0, API_CHANGES, "list", "things within radius of x, y, nearest first" },
    { "save.get", save_get_run, PARAMS(save_get), 2, API_CHANGES, "value", "what is kept under key, or default" },
    { "save.set", save_set_run, PARAMS(save_set), 2, API_CHANGES, NULL,
      "keeps a number, string or boolean between runs; nil forgets" },
    { "board.frame", board_frame_run, NO_PARAMS, 0, 0, "frames", "ticks since power-on" },
    { "board.difficulty", board_difficulty, PARAMS(name_opt), 1, API_CHANGES, "name",
      "the difficulty being played; with a name, sets it first" },
    { "board.dip", board_dip, PARAMS(name_req), 1, 0, "value", "a DIP switch: a name's or a number's value" },
    { "board.reset", board_reset_run, NO_PARAMS, 0, API_CHANGES, NULL, "starts the game anew after this frame" },
    { "board.live", board_live_run, PARAMS(chip_req), 1, 0, "count", "live things of a chip (\"bullets\")" },
    { "board.refused", board_refused_run, PARAMS(chip_req), 1, 0, "count", "how often a chip had no room" },
    { "board.attract", board_attract, PARAMS(demo_req), 1, API_CHANGES, NULL, "asks the cabinet to show a demo" },
    { "board.note", board_note, PARAMS(value_req), 1, API_CHANGES, NULL, "folds a value into the state hash" },
    { "rom.has", rom_has, PARAMS(name_req), 1, 0, "boolean", "is there such a sprite or text?" },
    { "rom.text", rom_text, PARAMS(name_req), 1, 0, "string", "a text file of the game" },
    { "sys.fail", sys_fail, PARAMS(fail), 2, API_SYS, NULL, "raises an entry's error" },
    { "sys.near", sys_near_run, PARAMS(sys_near), 2, API_SYS, "word", "the nearest word of a list" },
    { "sys.loading", sys_loading, NO_PARAMS, 0, API_SYS, "boolean", "are scripts loading?" },
    { "sys.emit", sys_emit, PARAMS(name_req), 1, API_SYS | API_MORE | API_CHANGES, NULL, "queues an event" },
    { "sys.practice", sys_practice, NO_PARAMS, 0, API_SYS, "string", "the practice start" },
    { "sys.join", sys_join, PARAMS(join), 2, API_SYS | API_CHANGES, NULL, "player i enters the game" },
    { "sys.leave", sys_leave, PARAMS(pad_only), 1, API_SYS | API_CHANGES, NULL, "player i leaves" },
    { "sys.wipe", sys_wipe, NO_PARAMS, 0, API_SYS | API_CHANGES, NULL, "an empty field and screen" },
    { "sys.freeze", sys_freeze, PARAMS(scope_opt), 1, API_SYS | API_CHANGES, NULL, "only that scope's tasks go on" },
    { "sys.hold", sys_hold, PARAMS(hold), 2, API_SYS | API_CHANGES, NULL, "hp stops at 0 without death" },
    { "sys.kinds", sys_kinds, PARAMS(name_req), 1, API_SYS, "list", "declared names" },
    { "sys.players", sys_players, NO_PARAMS, 0, API_SYS, "count", "players the manifest allows" },
    { "sys.difficulties", sys_difficulties, NO_PARAMS, 0, API_SYS, "list", "names, easiest first" },
    { "sys.glyphs", sys_glyphs, NO_PARAMS, 0, API_SYS, "count", "characters of the font" },
    { "sys.clock", sys_clock, NO_PARAMS, 0, API_SYS, "frames", "game time" },
};
const struct api_module api_world = { entries, sizeof entries / sizeof *entries };
