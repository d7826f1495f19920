/*
 * api_boss.c - the C half of boss.lua and its modules: the checks of boss.def, and the counts of spells tried and
 * captured.
 */
#include <stdio.h>
#include <string.h>
#include "../../base/hash.h"
#include "api_parts.h"

/* ---- boss.def ---- */

/* State while reading a boss: stack indices, and whether a phase with `last = true` was found. */
struct boss_reader {
    lua_State *L;
    int boss_at, cast_names_at, ids_at; /* cast_names_at: set of the members' names; 0: no cast */
    bool has_last_phase;
};

/* Pushes a field of the table at `at` and returns the Lua type of the value. */
static int push_field(lua_State *L, int at, const char *name)
{
    lua_pushstring(L, name);
    return lua_rawget(L, at);
}

/* Replaces the table on top by the result of sys.check. */
static void check_table_on_top(lua_State *L, const char *entry)
{
    lua_pushcfunction(L, api_sys_check);
    lua_pushstring(L, entry);
    lua_pushvalue(L, -3);
    lua_call(L, 2, 1);
    lua_replace(L, -2);
}

/* Checks the arguments of a phase. Upvalue: the entry name for errors. */
static int check_phase(lua_State *L)
{
    struct api_entry e = *api_find_entry(api_get_table(L), "boss.def phase");

    e.name = lua_tostring(L, lua_upvalueindex(1));
    return api_push_checked_arguments(L, &e);
}

/* Replaces the phase on top by the result of sys.check; errors name the phase. */
static void check_phase_on_top(lua_State *L, int number)
{
    const int at = lua_gettop(L);
    const bool has_id = lua_istable(L, at) && push_field(L, at, "id") == LUA_TSTRING;

    if (has_id)
        lua_pushfstring(L, "boss.def phase \"%s\"", lua_tostring(L, -1));
    else
        lua_pushfstring(L, "boss.def phase \"#%d\"", number);
    lua_pushcclosure(L, check_phase, 1);
    lua_pushvalue(L, at);
    lua_call(L, 1, 1);
    lua_replace(L, at);
    lua_settop(L, at);
}

/* Raises an error unless the field of the table at `at` matches p. */
static void check_field(lua_State *L, const char *entry, int at, const struct api_param *p)
{
    struct api_value v;

    push_field(L, at, p->name);
    api_check(L, entry, p, lua_gettop(L), &v);
    lua_pop(L, 1);
}

/* Requires kind and position of a boss without a cast. With a cast, raises an error if the boss itself has them,
 * because each member has its own. */
static void check_kind_and_position(lua_State *L, int boss, bool is_single)
{
    static const struct api_param params[] = { REQUIRED("kind", A_ENEMY_KIND, ""), COORDINATE("x", A_NUM, REQ, ""),
                                               COORDINATE("y", A_NUM, REQ, "") };

    for (int i = 0; i < 3; i++)
        if (is_single)
            check_field(L, "boss.def", boss, &params[i]);
        else if (push_field(L, boss, params[i].name) != LUA_TNIL)
            api_error(L, "boss.def", "%s: set it on each member of the cast instead", params[i].name);
        else
            lua_pop(L, 1);
}

/* Replaces the boss's `cast` with the list of checked members. Pushes that list, then the set of the members' names
 * (r->cast_names_at). */
static void read_cast(struct boss_reader *r, int list)
{
    lua_State *L = r->L;
    const lua_Integer n = (lua_Integer)lua_rawlen(L, list);

    if (n < 2)
        api_error(L, "boss.def", "cast: expected at least two members, got %d", (int)n);
    lua_newtable(L);
    lua_newtable(L);
    r->cast_names_at = lua_gettop(L);
    for (lua_Integer i = 1; i <= n; i++) {
        lua_rawgeti(L, list, i);
        check_table_on_top(L, "boss.def cast");
        push_field(L, lua_gettop(L), "name");
        lua_pushvalue(L, -1);
        if (lua_rawget(L, r->cast_names_at) != LUA_TNIL)
            api_error(L, "boss.def", "cast: duplicate name \"%s\"", lua_tostring(L, -2));
        lua_pop(L, 1);
        lua_pushboolean(L, 1);
        lua_rawset(L, r->cast_names_at);
        lua_rawseti(L, r->cast_names_at - 1, i);
    }
    lua_pushvalue(L, r->cast_names_at - 1);
    lua_setfield(L, r->boss_at, "cast");
}

/* Raises the error for a word that is not the name of a cast member. */
static void raise_unknown_member(struct boss_reader *r, const char *phase, const char *field_name, const char *word)
{
    lua_State *L = r->L;
    struct api_suggestion s = { .word = word };

    lua_pushnil(L);
    while (lua_next(L, r->cast_names_at)) {
        api_consider(&s, lua_tostring(L, -2));
        lua_pop(L, 1);
    }
    api_error(L, "boss.def", "phase \"%s\": %s: no member of the cast is named \"%s\"%s", phase, field_name, word,
              api_push_did_you_mean(L, &s, ""));
}

static bool is_known_member(lua_State *L, const char *key, const void *reader)
{
    const struct boss_reader *r = reader;

    vm_charge(L, 1);
    if (!key)
        return false;
    lua_pushvalue(L, -1);
    const bool is_member = lua_rawget(L, r->cast_names_at) != LUA_TNIL;
    lua_pop(L, 1);
    return is_member;
}

/* Checks the field p of the phase at `at`: a value that matches p or, with a cast, a table of such values by member
 * name. Replaces the table with a copy. */
static void check_cast_field(struct boss_reader *r, int at, const char *phase, const struct api_param *p)
{
    lua_State *L = r->L;
    struct api_value v;
    char context[64];
    int n = 0;

    if (push_field(L, at, p->name) != LUA_TTABLE || !r->cast_names_at) {
        snprintf(context, sizeof context, "boss.def: phase \"%s\"", phase);
        api_check(L, context, p, lua_gettop(L), &v);
        lua_pop(L, 1);
        return;
    }
    const int given_at = lua_gettop(L), copy = given_at + 1;
    if (luakeys_push_unknown(L, given_at, is_known_member, r)) {
        if (!luakeys_text(L, -1))
            api_error(L, "boss.def", "phase \"%s\": %s: expected { NAME = value } with names from the cast", phase,
                      p->name);
        raise_unknown_member(r, phase, p->name, luakeys_text(L, -1));
    }
    lua_newtable(L);
    snprintf(context, sizeof context, "boss.def: phase \"%s\": %s", phase, p->name);
    for (lua_Integer i = 1; lua_rawgeti(L, r->cast_names_at - 1, i) == LUA_TTABLE; i++, lua_settop(L, copy)) {
        struct api_param member_param = *p;
        push_field(L, copy + 1, "name");
        member_param.name = lua_tostring(L, -1);
        if (push_field(L, given_at, member_param.name) == LUA_TNIL)
            continue;
        api_check(L, context, &member_param, lua_gettop(L), &v);
        lua_rawset(L, copy);
        n++;
    }
    lua_settop(L, copy);
    if (n == 0)
        api_error(L, "boss.def", "phase \"%s\": %s: expected { NAME = value }, got {}", phase, p->name);
    lua_setfield(L, at, p->name);
    lua_pop(L, 1);
}

static bool is_field_true(lua_State *L, int at, const char *name)
{
    push_field(L, at, name);
    bool value = lua_toboolean(L, -1);
    lua_pop(L, 1);
    return value;
}

static lua_Integer read_integer_field(lua_State *L, int at, const char *name)
{
    push_field(L, at, name);
    lua_Integer n = lua_tointeger(L, -1);
    lua_pop(L, 1);
    return n;
}

static void check_bonus(lua_State *L, int at, const char *id)
{
    if (push_field(L, at, "bonus_to") == LUA_TNIL) {
        lua_pop(L, 1);
        return;
    }
    if (lua_tointeger(L, -1) > read_integer_field(L, at, "bonus"))
        api_error(L, "boss.def", "phase \"%s\": bonus_to: %d is greater than `bonus` (%d)", id,
                  (int)lua_tointeger(L, -1), (int)read_integer_field(L, at, "bonus"));
    lua_pop(L, 1);
}

/* Pushes the leader of the phase at `at`: the first cast member with a bar in it or, if there is none, the first
 * member. */
static void push_leader(struct boss_reader *r, int at)
{
    lua_State *L = r->L;
    bool found = false;

    push_field(L, r->boss_at, "cast");
    const int list = lua_gettop(L);
    const bool has_bars = push_field(L, at, "hp") == LUA_TTABLE;
    for (lua_Integer i = 1; has_bars && !found && i <= (lua_Integer)lua_rawlen(L, list); i++) {
        lua_settop(L, list + 1);
        lua_rawgeti(L, list, i);
        push_field(L, list + 2, "name");
        found = lua_rawget(L, list + 1) != LUA_TNIL;
    }
    if (found)
        lua_settop(L, list + 2);
    else
        lua_rawgeti(L, list, 1);
    lua_replace(L, list);
    lua_settop(L, list);
}

/* Sets the portraits that the phase at `at` omits to those of the phase's leader or, failing that, of the boss. Returns
 * whether the phase then has a portrait. */
static bool set_default_portraits(struct boss_reader *r, int at)
{
    static const char *const names[] = { "portrait", "portrait_left" };
    lua_State *L = r->L;

    push_leader(r, at);
    const int leader = lua_gettop(L);
    for (int i = 0; i < 2; i++) {
        if (push_field(L, at, names[i]) == LUA_TNIL && push_field(L, leader, names[i]) == LUA_TNIL)
            push_field(L, r->boss_at, names[i]);
        lua_setfield(L, at, names[i]);
        lua_settop(L, leader);
    }
    lua_settop(L, leader - 1);
    return is_field_true(L, at, "portrait");
}

/* Sets `cut_in` in a spell with a portrait, unless the phase already has `cut_in`. */
static void set_default_cut_in(struct boss_reader *r, int at, const char *id)
{
    lua_State *L = r->L;
    const bool has_portrait = set_default_portraits(r, at), wants_cut_in = is_field_true(L, at, "cut_in");

    if (wants_cut_in && !has_portrait)
        api_error(L, "boss.def", "phase \"%s\": `cut_in` requires a portrait (`portrait = SPRITE`)", id);
    if (wants_cut_in && !is_field_true(L, at, "spell"))
        api_error(L, "boss.def", "phase \"%s\": `cut_in` requires a spell (it shows the spell's name)", id);
    if (has_portrait && is_field_true(L, at, "spell") && push_field(L, at, "cut_in") == LUA_TNIL) {
        lua_pushboolean(L, 1);
        lua_setfield(L, at, "cut_in");
    }
}

/* Replaces the phase on top of the stack, element i of `phases`, with the checked phase. */
static void read_phase(struct boss_reader *r, int i)
{
    static const struct api_param hp = PARAM("hp", A_INT, REQ, 1, INT32_MAX, NULL, NULL, NULL),
                                  run = REQUIRED("run", A_FUNC, NULL);
    lua_State *L = r->L;
    const int at = lua_gettop(L);

    check_phase_on_top(L, i);
    push_field(L, at, "id");
    const char *id = lua_tostring(L, -1);
    lua_pushvalue(L, -1);
    if (lua_rawget(L, r->ids_at) != LUA_TNIL)
        api_error(L, "boss.def", "duplicate phase \"%s\"", id);
    lua_pushvalue(L, -2);
    lua_pushboolean(L, 1);
    lua_rawset(L, r->ids_at);
    if (!is_field_true(L, at, "survive") || push_field(L, at, "hp") != LUA_TNIL)
        check_cast_field(r, at, id, &hp);
    check_cast_field(r, at, id, &run);
    check_bonus(L, at, id);
    if (push_field(L, at, "clear") != LUA_TNIL) {
        check_table_on_top(L, "boss.def clear");
        lua_setfield(L, at, "clear");
    }
    if (push_field(L, at, "drops") != LUA_TNIL) {
        api_push_folded_drops(L, "boss.def", lua_gettop(L));
        lua_setfield(L, at, "drops");
    }
    set_default_cut_in(r, at, id);
    if (read_integer_field(L, at, "armour") > 0)
        api_check_bodies(L, "boss.def", "armour");
    r->has_last_phase |= is_field_true(L, at, "last");
    lua_settop(L, at);
}

/* Pops the list of talks and stores it in the field `talk` of the table at `at`; stores nil if the list is empty. */
static void set_talks(lua_State *L, int at)
{
    if (lua_rawlen(L, -1) == 0) {
        lua_pop(L, 1);
        lua_pushnil(L);
    }
    lua_setfield(L, at, "talk");
}

/* Replaces the boss's list of phases with the checked phases. Talks are stored in the phase that follows them; talks
 * after the last phase are stored in the boss. */
static void read_phases(struct boss_reader *r)
{
    lua_State *L = r->L;
    lua_Integer n_phases = 0;

    push_field(L, r->boss_at, "phases");
    const int list = lua_gettop(L);
    lua_newtable(L);
    lua_newtable(L);
    r->ids_at = list + 2;
    lua_newtable(L);
    const int talks = list + 3;
    for (lua_Integer i = 1; i <= (lua_Integer)lua_rawlen(L, list); i++) {
        lua_rawgeti(L, list, i);
        if (lua_istable(L, -1) && is_field_true(L, talks + 1, "talk")) {
            check_table_on_top(L, "boss.def talk");
            push_field(L, talks + 1, "talk");
            lua_rawseti(L, talks, (lua_Integer)lua_rawlen(L, talks) + 1);
            lua_pop(L, 1);
            continue;
        }
        read_phase(r, (int)i);
        lua_pushvalue(L, talks);
        set_talks(L, talks + 1);
        lua_rawseti(L, list + 1, ++n_phases);
        lua_newtable(L);
        lua_replace(L, talks);
    }
    if (!n_phases)
        api_error(L, "boss.def", "phases: expected at least one phase");
    set_talks(L, r->boss_at);
    lua_pushvalue(L, list + 1);
    lua_setfield(L, r->boss_at, "phases");
}

static const struct api_param boss_table_params[] = { REQUIRED("boss", A_TABLE, "") };

/* Converts the table of checked boss.def arguments into the boss, in place. Returns whether the boss has a phase with
 * `last = true`. */
static int sys_boss(lua_State *L, struct board *b, struct api_value *v)
{
    struct boss_reader r = { .L = L, .boss_at = v[0].at };

    (void)b;
    luaL_checkstack(L, 32, NULL);
    const bool is_single = push_field(L, r.boss_at, "cast") == LUA_TNIL;
    check_kind_and_position(L, r.boss_at, is_single);
    if (!is_single)
        read_cast(&r, lua_gettop(L));
    else {
        lua_createtable(L, 1, 0);
        lua_pushvalue(L, r.boss_at);
        lua_rawseti(L, -2, 1);
        lua_setfield(L, r.boss_at, "cast");
    }
    read_phases(&r);
    lua_pushboolean(L, r.has_last_phase);
    return 1;
}

/* ---- the history of spells ---- */

enum { HISTORY_BOSS, HISTORY_ID, HISTORY_ADD, HISTORY_DIFFICULTY, HISTORY_SHIP };
enum { ADD_NOTHING, ADD_TRY, ADD_CAPTURE };

static const struct api_param history_params[] = { REQUIRED("boss", A_STR, ""), REQUIRED("id", A_STR, ""),
                                                   PARAM("add", A_INT, REQ, ADD_NOTHING, ADD_CAPTURE, NULL, NULL, ""),
                                                   OPTIONAL("difficulty", A_STR, ""),
                                                   OPTIONAL("ship", A_PLAYER_KIND, "") };

static uint64_t hash_name(uint64_t h, const char *name)
{
    return hash_bytes(h, name, strlen(name) + 1);
}

/* Builds the nvram key of a spell's history: a hash, because the names are too long for a key. Scripts are unlikely to
 * use the same key. */
static void format_history_key(char key[NV_MAX_KEY + 1], uint64_t spell_hash, const char *difficulty, const char *ship)
{
    snprintf(key, NV_MAX_KEY + 1, "spell %016llx",
             (unsigned long long)hash_name(hash_name(spell_hash, difficulty), ship));
}

/* Returns the history stored under the key: tries in the upper 32 bits, captures in the lower; 0 if there is none. */
static uint64_t read_history(const struct board *b, const char *key)
{
    struct nv_value value = nvram_get(&b->nvram, key);

    return value.type == NV_INT ? value.bits : 0;
}

static void increment_history(struct board *b, const char *key, int64_t counter)
{
    struct nv_value value = { .type = NV_INT, .bits = read_history(b, key) };
    const uint32_t tries = (uint32_t)(value.bits >> 32), captures = (uint32_t)value.bits;

    if ((counter == ADD_TRY ? tries : captures) == INT32_MAX)
        return;
    value.bits += counter == ADD_TRY ? 1ull << 32 : 1;
    nvram_set(&b->nvram, key, &value); /* if nvram is full, the old value remains */
}

/* Returns the ship of the first player in the game; without players, the first ship declared. */
static const char *find_first_ship(const struct board *b)
{
    uint16_t kind = 0;

    for (int p = MAX_PLAYERS; p-- > 0;)
        kind = b->player.in_game[p] ? b->player.kind[p] : kind;
    const char *name = board_name(b, N_PLAYER, kind);
    return name ? name : "";
}

/* Returns the tries and captures of a spell, after incrementing the counter that `add` selects, if any. In practice
 * nothing is incremented; the program counts practice tries. */
static int sys_history(lua_State *L, struct board *b, struct api_value *v)
{
    const struct manifest *m = &b->cart.manifest;
    const char *difficulty = v[HISTORY_DIFFICULTY].given ? lua_tostring(L, v[HISTORY_DIFFICULTY].at)
                             : m->n_difficulties         ? m->difficulties[b->core.difficulty]
                                                         : "";
    const uint64_t spell_hash =
        hash_name(hash_name(HASH_START, lua_tostring(L, v[HISTORY_BOSS].at)), lua_tostring(L, v[HISTORY_ID].at));
    lua_Integer tries = 0, captures = 0;
    char key[NV_MAX_KEY + 1];

    if (v[HISTORY_ADD].i && !b->start.practice.section[0]) {
        format_history_key(key, spell_hash, difficulty, find_first_ship(b));
        increment_history(b, key, v[HISTORY_ADD].i);
    }
    for (int k = 0; k < (int)b->player_kinds.s.live; k++) {
        const char *ship = board_name(b, N_PLAYER, k);
        if (!ship || (v[HISTORY_SHIP].given && k != v[HISTORY_SHIP].i))
            continue;
        format_history_key(key, spell_hash, difficulty, ship);
        vm_charge(L, b->nvram.s.live / NVRAM_BYTES_PER_WORK);
        tries += (lua_Integer)(read_history(b, key) >> 32);
        captures += (lua_Integer)(read_history(b, key) & UINT32_MAX);
    }
    lua_pushinteger(L, tries);
    lua_pushinteger(L, captures);
    return 2;
}

static const struct api_entry entries[] = {
    { "sys.boss", sys_boss, PARAMS(boss_table_params), 1, API_SYS, "boolean",
      HELP("checks a boss's cast and phases; returns true if a phase has `last = true`") },
    { "sys.history", sys_history, PARAMS(history_params), 5, API_SYS | API_CHANGES, "tries, captures",
      HELP("returns how often a spell was tried and captured; add = 1 adds a try, add = 2 a capture") },
};
const struct api_module api_boss = { entries, sizeof entries / sizeof *entries };
