/*
 * test_uses.c - roms/torture under its demo uses all there is: every API function, every property, every key of a
 * motion step, every pool to the brim, both players. And the demo holds.
 *
 * The game is loaded after its board was powered with an empty entry script: in between, each API function gets an
 * entry that counts, and those written in Lua, as well as the properties of things, a wrapper that does. Uses by @std
 * do not count. CURTAIN_UPDATE=1 records roms/torture/demos/torture.demo anew, which a change of the game makes
 * necessary.
 */
#include "rig.h"
#include "../../src/script/api/api_parts.h"

enum { MOST = 512, PROPS = 32 };

static struct api_entry copies[MOST];
static long uses[MOST], reads[HANDLE_KINDS][PROPS], writes[HANDLE_KINDS][PROPS];
static unsigned step_seen, step_timed; /* bits of step_keys */

static const char *const step_keys[] = { "wait",   "kind",  "bank", "dir",  "aim",    "turn",     "home",
                                         "speed",  "accel", "die",  "loop", "go_to",  "polar",    "wave",
                                         "orbit",  "ease",  "spin", "at",   "every",  "phase",    "radius_to",
                                         "bounce", "walls", "emit", "path", "mirror", "wait_for", "over" };
enum { STEP_KEYS = sizeof step_keys / sizeof *step_keys };

/* ---- counting ---- */

/* Is the function at that level of the stack one of @std's? */
static bool by_std(lua_State *L, int level)
{
    lua_Debug ar;

    return lua_getstack(L, level, &ar) && lua_getinfo(L, "S", &ar) && strstr(ar.source, "@std/") != NULL;
}

static void note_steps(lua_State *L, int at)
{
    unsigned here = 0;

    luaL_checkstack(L, 8, NULL);
    lua_pushnil(L);
    while (lua_next(L, at)) {
        if (lua_type(L, -2) == LUA_TSTRING)
            for (int k = 0; k < STEP_KEYS; k++)
                if (!strcmp(lua_tostring(L, -2), step_keys[k]))
                    here |= 1u << k;
        if (lua_istable(L, -1))
            note_steps(L, lua_gettop(L));
        lua_pop(L, 1);
    }
    step_seen |= here;
    if (here >> (STEP_KEYS - 1))
        step_timed |= here;
}

static int count_run(lua_State *L, struct board *b, struct api_value *v)
{
    const struct api_entry *e = api_current_binding(L)->entry;
    int i = (int)(e - copies);

    if (!by_std(L, 1)) {
        uses[i]++;
        if (!strcmp(e->name, "motion.def"))
            note_steps(L, v[0].at);
    }
    return api_get_entry(&api_table, i)->run(L, b, v);
}

/* Upvalue 1: the entry's number. Called by a wrapper. */
static int count_lua(lua_State *L)
{
    if (!by_std(L, 2))
        uses[lua_tointeger(L, lua_upvalueindex(1))]++;
    return 0;
}

/* Upvalue 1: 0 for a read, 1 for a write. */
static int count_property(lua_State *L)
{
    const int64_t h = lua_tointeger(L, 1);
    const char *name = lua_tostring(L, 2);
    long(*of)[PROPS] = lua_tointeger(L, lua_upvalueindex(1)) ? writes : reads;

    if (by_std(L, 2) || !handle_is_well_formed(h) || !name)
        return 0;
    const struct api_thing *t = api_table.things[handle_kind(h)];
    for (int i = 0; i < t->n && i < PROPS; i++)
        if (!strcmp(t->props[i].name, name))
            of[handle_kind(h)][i]++;
    return 0;
}

/* Replaces the function on top of the stack by one that calls `count` first, with the same arguments. */
static void wrap(lua_State *L, lua_CFunction count, int upvalue)
{
    static const char text[] = "local f, count = ... return function(...) count(...) return f(...) end";

    assert_int_equal(luaL_loadbufferx(L, text, sizeof text - 1, "=count", "t"), LUA_OK);
    lua_insert(L, -2);
    lua_pushinteger(L, upvalue);
    lua_pushcclosure(L, count, 1);
    lua_call(L, 2, 1);
}

static int number_of(const struct api_entry *e)
{
    int i = 0;

    while (i < api_count_entries(&api_table) && api_get_entry(&api_table, i) != e)
        i++;
    assert_true(i < api_count_entries(&api_table));
    return i;
}

/* Gives every API closure that can be reached from the table at `at` its counting entry. */
static void patch(lua_State *L, int at, lua_CFunction call, int seen)
{
    luaL_checkstack(L, 16, NULL);
    lua_pushvalue(L, at);
    if (lua_rawget(L, seen) != LUA_TNIL) {
        lua_pop(L, 1);
        return;
    }
    lua_pop(L, 1);
    lua_pushvalue(L, at);
    lua_pushboolean(L, 1);
    lua_rawset(L, seen);
    if (lua_getmetatable(L, at)) {
        patch(L, lua_gettop(L), call, seen);
        lua_pop(L, 1);
    }
    lua_pushnil(L);
    while (lua_next(L, at)) {
        if (lua_istable(L, -1))
            patch(L, lua_gettop(L), call, seen);
        else if (lua_tocfunction(L, -1) == call) {
            lua_getupvalue(L, -1, 1);
            struct api_binding *f = lua_touserdata(L, -1);
            f->entry = &copies[number_of(f->entry)];
            lua_pop(L, 1);
        }
        lua_pop(L, 1);
    }
}

/* Makes every function of the API: of tables, and verbs of things. */
static void make_all(lua_State *L)
{
    luaL_checkstack(L, 16, NULL);
    lua_getglobal(L, "bomb"); /* it is made when it is named */
    lua_pop(L, 1);
    for (lua_pushnil(L); lua_next(L, LUA_REGISTRYINDEX);) {
        if (lua_istable(L, -1)) /* of them, one has the API's tables as keys */
            for (lua_pushnil(L); lua_next(L, -2); lua_pop(L, 1))
                if (lua_istable(L, -2))
                    api_fill_table(L, lua_gettop(L) - 1);
        lua_pop(L, 1);
    }
    for (int i = 0; i < api_count_entries(&api_table); i++)
        for (int k = 1; k < HANDLE_KINDS; k++) {
            const char *name = api_get_entry(&api_table, i)->name, *verb = strchr(name, ':');
            if (!verb || (size_t)(verb - name) != strlen(api_table.things[k]->name) ||
                strncmp(name, api_table.things[k]->name, (size_t)(verb - name)) != 0)
                continue;
            lua_pushinteger(L, handle_make((enum handle_kind)k, 1, 0));
            lua_getfield(L, -1, verb + 1);
            assert_true(lua_isfunction(L, -1));
            lua_pop(L, 2);
        }
}

static void patch_all(lua_State *L)
{
    make_all(L);
    lua_getglobal(L, "wait");
    lua_CFunction call = lua_tocfunction(L, -1);
    lua_newtable(L);
    int seen = lua_gettop(L);
    lua_pushvalue(L, LUA_REGISTRYINDEX);
    patch(L, lua_gettop(L), call, seen);
    lua_settop(L, 0);
    for (int i = 0; i < api_count_entries(&api_table); i++) {
        const char *name = api_get_entry(&api_table, i)->name, *dot = strchr(name, '.');
        if (!(api_get_entry(&api_table, i)->flags & API_LUA) || strchr(name, ' '))
            continue;
        lua_pushglobaltable(L);
        if (dot) {
            lua_pushlstring(L, name, (size_t)(dot - name));
            lua_rawget(L, -2);
        }
        if (lua_isnil(L, -1)) { /* what the game never names is not there */
            lua_settop(L, 0);
            continue;
        }
        lua_pushstring(L, dot ? dot + 1 : name);
        lua_pushvalue(L, -1);
        lua_gettable(L, -3); /* not raw: figure.lua is run when the first of its functions is asked for */
        wrap(L, count_lua, i);
        lua_rawset(L, -3);
        lua_settop(L, 0);
    }
    lua_pushinteger(L, 0);
    lua_getmetatable(L, -1);
    for (int write = 0; write < 2; write++) {
        lua_getfield(L, -1, write ? "__newindex" : "__index");
        wrap(L, count_property, write);
        lua_setfield(L, -2, write ? "__newindex" : "__index");
    }
    lua_settop(L, 0);
}

static int start(lua_State *L)
{
    patch_all(L);
    vm_load_script(L, "main");
    lua_call(L, 0, 0);
    return 0;
}

/* The game with an empty entry script. */
static void without_entry(const struct rig_game *from, struct rig_game *to)
{
    static uint8_t manifest[MANIFEST_BYTES];
    struct manifest m = from->cart.manifest;
    struct lump lumps[RIG_LUMPS];
    int n = (int)from->image.rom.count;

    assert_true(n <= RIG_LUMPS);
    snprintf(m.entry, sizeof m.entry, "empty");
    const uint32_t size = manifest_pack(&m, manifest);
    for (int i = 0; i < n; i++) {
        rom_lump(&from->image.rom, i, &lumps[i]);
        if (!strcmp(lumps[i].name, "manifest"))
            lumps[i].data = manifest, lumps[i].size = size;
    }
    lumps[n++] = (struct lump){ "script/empty.lua", (const uint8_t *)"\n", 1 };
    rig_write(to, lumps, n);
}

/* ---- the demo ---- */

enum { FRAMES = 3600, RESET = FRAMES - 90 };

struct press {
    int frame, player;
    uint16_t pad;
};
/* Through the menus: two players, a ship for each, a difficulty. */
static const struct press presses[] = { { 20, 0, PAD_START }, { 40, 0, PAD_DOWN }, { 50, 0, PAD_FIRE },
                                        { 70, 0, PAD_FIRE },  { 90, 1, PAD_DOWN }, { 100, 1, PAD_FIRE },
                                        { 120, 0, PAD_FIRE } };

static void recipe(int f, struct rng *rng, uint16_t pads[MAX_PLAYERS])
{
    if (f > 140)
        rig_pads(rng, pads);
    for (int p = 0; p < MAX_PLAYERS; p++)
        pads[p] = (uint16_t)(f > 140 ? pads[p] & ~PAD_SELECT : 0);
    for (size_t i = 0; i < sizeof presses / sizeof *presses; i++)
        if (f == presses[i].frame)
            pads[presses[i].player] = presses[i].pad;
    if (f == RESET)
        pads[1] |= PAD_SELECT;
}

static void record(const struct rig_game *game, const char *to)
{
    struct board_start at = { .seed = 21, .difficulty = -1 };
    struct demo_writer w;
    struct rng rng;
    struct rig r;
    uint16_t pads[MAX_PLAYERS] = { 0 };

    memset(&w, 0, sizeof w);
    rig_power(&r, game, &at);
    rng_seed(&rng, 19);
    assert_true(demo_begin(&w, to, &game->cart, r.b, &at, 0));
    for (int f = 0; f < FRAMES; f++) {
        recipe(f, &rng, pads);
        rig_tick(&r, pads);
        assert_true(demo_record_frame(&w, r.b, pads));
    }
    assert_true(demo_end(&w, r.b));
    demo_free(&w.demo);
    rig_free(&r);
}

static const char path[] = "roms/torture/demos/torture.demo";
static struct rig_game g;
static struct demo d;

TEST(demo_holds)
{
    char err[512];
    uint64_t hashes[MAX_PARTS];
    uint16_t pads[MAX_PLAYERS];
    struct rig r;

    assert_true(d.complete && demo_check_cart(&d, &g.cart, err, sizeof err));
    const char *doubt = demo_replay_warning(&d, &g.cart, err, sizeof err);
    if (doubt)
        fail_msg("torture.demo: %s (CURTAIN_UPDATE=1 records it anew)", doubt);
    rig_power(&r, &g, &d.start);
    for (uint32_t f = 0; f <= d.frames; f++) {
        board_hashes(r.b, hashes);
        uint64_t differ = demo_differing_parts(&d, f, hashes);
        if (differ)
            fail_msg("frame %u: part %s differs (CURTAIN_UPDATE=1 records the demo anew)", f,
                     d.part_name[bits_lowest(differ)]);
        demo_pads(&d, f, pads);
        if (f < d.frames)
            rig_tick(&r, pads);
    }
    rig_free(&r);
}

/* ---- what the demo must reach ---- */

struct reached {
    uint32_t most[PART_COUNT], cap[PART_COUNT];
    int64_t refused[PART_COUNT];
    uint32_t does;
    bool in[MAX_PLAYERS], grazed[MAX_PLAYERS], scored[MAX_PLAYERS], hurt[MAX_PLAYERS], focused[MAX_PLAYERS];
    unsigned shapes[3],
        flags[3]; /* of the kinds of what lived: bits of SHAPE_, and of flags that were and were not set */
    bool fine;
};

static void look_at_kind(struct reached *at, int pool, uint8_t shape, uint16_t flags)
{
    at->shapes[pool] |= 1u << shape;
    at->flags[pool] |= flags | (unsigned)(uint16_t)~flags << 16;
}

static void look_at_bullets(struct reached *at, int pool, const struct bullets *s, const struct bullet_kinds *k)
{
    EACH_LIVE (i, &s->s) {
        look_at_kind(at, pool, k->shape[s->kind[i]], k->flags[s->kind[i]]);
        at->fine |= s->flags[i] & BULLET_FINE;
    }
}

static void look(const struct board *b, struct reached *at)
{
    for (int i = 0; i < PART_COUNT; i++) {
        const struct slots *s = (const struct slots *)((const uint8_t *)b + machine_parts[i].offset);
        at->most[i] = s->live > at->most[i] ? s->live : at->most[i];
        at->cap[i] = s->cap;
        at->refused[i] = s->refused > at->refused[i] ? s->refused : at->refused[i];
    }
    look_at_bullets(at, 0, &b->bullets, &b->bullet_kinds);
    look_at_bullets(at, 1, &b->shots, &b->shot_kinds);
    EACH_LIVE (i, &b->enemies.s) {
        uint16_t kind = b->enemies.kind[i];
        look_at_kind(at, 2, b->enemy_kinds.shape[kind], b->enemy_kinds.flags[kind]);
    }
    for (uint32_t i = 0; i < b->steps.s.live; i++)
        at->does |= b->steps.actions[i];
    for (int p = 0; p < MAX_PLAYERS; p++) {
        at->in[p] |= b->player.in_game[p];
        at->grazed[p] |= b->player.grazes[p] > 0;
        at->scored[p] |= b->player.score[p] > 0;
        at->hurt[p] |= b->player.in_game[p] && b->player.lives[p] < 2;
        at->focused[p] |= b->player.flags[p] & PLAYER_FOCUS;
    }
}

static struct reached at;

/* Plays the demo, up to the reset, on a board that counts. */
static void count_uses(void)
{
    struct rig_game counted;
    struct rig r;
    uint16_t pads[MAX_PLAYERS];

    assert_true(api_count_entries(&api_table) <= MOST);
    for (int i = 0; i < api_count_entries(&api_table); i++) {
        copies[i] = *api_get_entry(&api_table, i);
        if (copies[i].run)
            copies[i].run = count_run;
    }
    without_entry(&g, &counted);
    rig_power(&r, &counted, &d.start);
    r.b->vm.loading = true;
    bool fine = vm_call(r.b, start);
    r.b->vm.loading = false;
    if (!fine)
        fail_msg("%s %s", rig_fault(&r)->message, rig_fault(&r)->trace);
    for (uint32_t f = 0; f < d.frames && f <= RESET; f++) {
        demo_pads(&d, f, pads);
        rig_tick(&r, pads);
        look(r.b, &at);
    }
    rig_free(&r);
    rig_game_free(&counted);
}

static void append(char *to, size_t size, const char *a, const char *b)
{
    size_t n = strlen(to);

    snprintf(to + n, size - n, " %s%s", a, b);
}

TEST(functions)
{
    char missing[4096] = "";

    for (int i = 0; i < api_count_entries(&api_table); i++)
        /* missions are another way through the menus: test_missions.c; its ROM has no documents: test_bulletml.c */
        if (!(api_get_entry(&api_table, i)->flags & API_SYS) && !uses[i] &&
            strncmp(api_get_entry(&api_table, i)->name, "mission.", 8) != 0 &&
            strcmp(api_get_entry(&api_table, i)->name, "bullet.ml") &&
            strcmp(api_get_entry(&api_table, i)->name, "bullet.documents") &&
            strcmp(api_get_entry(&api_table, i)->name, "bulletml:stop"))
            append(missing, sizeof missing, api_get_entry(&api_table, i)->name, "");
    if (missing[0])
        fail_msg("roms/torture does not use:%s", missing);
}

TEST(properties)
{
    char missing[4096] = "", name[80];

    for (int k = 1; k < HANDLE_KINDS; k++)
        for (int i = 0; i < api_table.things[k]->n; i++) {
            const struct api_param *p = &api_table.things[k]->props[i];
            snprintf(name, sizeof name, "%s.%s", api_table.things[k]->name, p->name);
            if (!strcmp(name, "sprite.blend") || k == H_BULLETML) /* the ROM has none: test_blend.c, test_bulletml.c */
                continue;
            if (!reads[k][i] &&
                !(handle_kind_is_group((enum handle_kind)k) && strcmp(p->name, "count"))) /* groups are written */
                append(missing, sizeof missing, name, " (read)");
            if (!writes[k][i] && p->access & PROP_WRITE)
                append(missing, sizeof missing, name, " (write)");
        }
    if (missing[0])
        fail_msg("roms/torture does not use:%s", missing);
}

TEST(steps)
{
    const unsigned all = (1u << STEP_KEYS) - 1, never_timed = 1u << 0 | 1u << 3 | 1u << 9 | 1u << 10 | 15u << 23;

    for (int k = 0; k < STEP_KEYS; k++) {
        if (!(step_seen >> k & 1))
            fail_msg("no motion has the key %s", step_keys[k]);
        if (!((step_timed | never_timed) >> k & 1))
            fail_msg("no motion has the key %s with over", step_keys[k]);
    }
    assert_int_equal(step_seen, all);
    assert_int_equal(at.does, DOES_ALL); /* all there are */
}

TEST(pools)
{
    for (int i = 0; i < PART_COUNT; i++) {
        const char *name = machine_parts[i].chip->name;
        bool kinds = strstr(name, "_kinds") != NULL;
        if (!at.cap[i] || kinds || !strcmp(name, "steps") || !strcmp(name, "laser_heads")) /* are as many as lasers */
            continue;
        bool bytes = !strcmp(name, "nvram"); /* a script for which there is no room ends */
        if (bytes ? at.most[i] < 256 : 10 * at.most[i] < 9 * at.cap[i])
            fail_msg("%s: at most %u of %u live", name, at.most[i], at.cap[i]);
        if ((!machine_parts[i].chip->is_list || !strcmp(name, "motions")) && !at.refused[i])
            fail_msg("%s: never full", name);
    }
    for (int p = 0; p < MAX_PLAYERS; p++)
        if (!at.in[p] || !at.grazed[p] || !at.scored[p] || !at.hurt[p] || !at.focused[p])
            fail_msg("player %d: in %d, grazed %d, scored %d, hurt %d, focused %d", p + 1, at.in[p], at.grazed[p],
                     at.scored[p], at.hurt[p], at.focused[p]);
}

/* Every model a scene can choose: hit shapes, grazed or not, swept or not, fine. */
TEST(models)
{
    const unsigned plain = 1u << SHAPE_NONE | 1u << SHAPE_CIRCLE | 1u << SHAPE_BOX, bars = plain | 1u << SHAPE_CAPSULE,
                   all = bars | 1u << SHAPE_CIRCLES, shapes[] = { all, bars, all };
    static const unsigned choices[] = { KIND_GRAZE | KIND_SWEPT, KIND_SWEPT, ENEMY_TOUCH | ENEMY_SWEPT };

    for (int pool = 0; pool < 3; pool++) {
        assert_int_equal(at.shapes[pool] & shapes[pool], shapes[pool]);
        assert_int_equal(at.flags[pool] & choices[pool], choices[pool]);
        assert_int_equal(at.flags[pool] >> 16 & choices[pool], choices[pool]);
    }
    assert_true(at.fine);
}

static int setup(void **state)
{
    const char *update = getenv("CURTAIN_UPDATE");

    (void)state;
    if (update && *update == '1') {
        remove(path); /* the old one is a part of the ROM, whose hash is in the new one */
        rig_folder(&g, "torture");
        record(&g, path);
        rig_game_free(&g);
    }
    rig_folder(&g, "torture");
    if (!rig_demo(&g, "torture", &d)) {
        fprintf(stderr, "roms/torture has no demo: CURTAIN_UPDATE=1 records it\n");
        return -1;
    }
    count_uses();
    return 0;
}

static int teardown(void **state)
{
    (void)state;
    demo_free(&d);
    rig_game_free(&g);
    return 0;
}

RUN_TESTS(setup, teardown)
