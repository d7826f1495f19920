/*
 * test_api.c - every function and property of the Lua API with arguments drawn by their types: in range, at and beyond
 * the ends, not numbers, of other types, handles that no one gave out. Whatever comes, the call returns or there is a
 * clean fault; a board that goes on can be ticked, drawn and hashed. Run under the sanitizers too.
 */
#include <math.h>
#include "rig.h"

/* Before the world: its lasers, options and bombs. */
static const char rays[] =
    "option.def('bead', { sprite = 'dot', run = function(o) string.chaos() end })\n"
    "option.def('moon', { sprite = 'wink', layer = 'front' })\n"
    "bomb.def('boom', { over = 9, stock = 'b', run = function(p) string.chaos() wait(99) end })\n"
    "spark.def('glow', { sprite = 'dot', life = 500 })\n"
    "laser.def('ray', { strip = 'dot', width = 8, hit = { share = 1 }, vanish = 'glow' })\n"
    "laser.def('lance', { strip = 'wink', width = 3, hit = { share = 0.5 }, damage = 2, head = 'arrow', blend = 'glow' "
    "})\n"
    "function string.rays(t, i)\n"
    "  t[#t + 1] = laser.beam { kind = i == 1 and 'lance' or 'ray', x = 9, y = 8 * i, length = 50, hold = 90, tag = "
    "'t' }\n"
    "  t[#t + 1] = laser.bolt { kind = 'ray', x = 90, y = 30 * i, speed = 0.25, length = 20, motion = 'm' }\n"
    "  t[#t + 1] = i == 2 and laser.curve { kind = 'ray', x = 90, y = 60, speed = 1, points = 6 } or laser.group('t')\n"
    "end\n"
    "function string.more_rays()\n"
    "  laser.each('t', function(l) l:clear { items = 'gem' } end)\n"
    "  for i = 1, 4 do laser.bolt { kind = 'lance', x = 9 * i, y = 9, speed = 1, length = 9, tag = 't' } end\n"
    "  laser.curve { kind = 'ray', x = 90, y = 60, aim = true, speed = 3, points = 200, tag = 't' }\n"
    "end\n";

static const char world[] =
    "bullet.def('dot', { sprite = 'dot', hit = { circle = 3 } })\n"
    "bullet.def('slab', { sprite = 'arrow', hit = { box = { 8191, 1 } }, turns = true })\n"
    "bullet.def('air', { sprite = 'wink', hit = 'none' })\n"
    "shot.def('bolt', { sprite = 'arrow', hit = { box = { 4, 8 } }, turns = true })\n"
    "item.def('gem', { sprite = 'dot', radius = 9, gives = { score = { 1, 9 }, lives = 1, a = 2 }, full = 'a',\n"
    "  on_take = function(p, i) string.chaos() i:remove() i:pull() item.group():remove() end })\n"
    "item.def('husk', { sprite = 'arrow', radius = 8191, gravity = 0, magnet = false })\n"
    "enemy.def('foe', { sprite = 'wink', hit = { box = { 9, 9 } }, hp = 50, spark = 'glow', blink = 9, pictures = { "
    "cast = 'dot' }, run = function(e) wait(9) end, drops = { gem = 2, husk = 1 } })\n"
    "enemy.def('brief', { sprite = 'wink', hit = { box = { 0, 0 } }, on_death = function(e) e:kill() e:hurt(1) "
    "e:remove() end })\n"
    "player.def('ship', { sprite = 'dot', hit = { circle = 2 }, registers = { a = { max = 9, drain = 1, hold = 5 }, b "
    "= "
    "2 }, bomb = 'boom', deathbomb = 4, options = { kind = 'bead', by = 'a', levels = { { at = 1, wide = { { 9, 9 } } "
    "}, { at = 5, wide = { { 9, 9 }, { -9, 0 } } } } }, collect_line = 60, pictures = { pose = 'dot' }, run = "
    "function(p) "
    "wait(9) end })\n"
    "unlock.def('s', { when = { clear = true } })\n"
    "value.def('heat', { start = 2 }) value.def('goal') value.def('mood', { of = 'enemy' })\n"
    "motion.def { name = 'm', { loop = forever, { turn = 1, over = 9 }, { loop = 2, { wait = 3 } } } }\n"
    "local sys = string.sys\n"
    "string.route = path.def { { x = 1, y = 2 }, { x = 100, y = 90, over = 2, ease = 'both' } }\n"
    "string.tables = { values = { normal = 1 }, list = { { x = 1, y = 2 }, { x = 9, y = 9, over = 3 } }, spots = { { "
    "1, "
    "2 }, { -9.5, 1e9 } }, stages = { 's' },\n"
    "  drops = { gem = 2, husk = 0 }, gives = { score = { 1, 2 }, b = -3 },\n"
    "  options = { kind = 'moon', style = 'orbit', radius = 9, levels = { { n = 3 } } },\n"
    "  tally = { { label = 'T', value = 'grazes', points = 9 } },\n"
    "  choices = { 'GO', 'STAY' }, faces = { calm = 'dot', cross = 'arrow' },\n"
    "  lines = { 1, -2.5, 9 }, fog = { to = 0x102030, far = 90 },\n"
    "  players = { 'ship' }, registers = { a = 3 }, phases = { { id = 'q', hp = 9, time = 5, run = function() end } "
    "},\n"
    "  cast = { { name = 'i', title = 'I', kind = 'foe', x = 9, y = 9 }, { name = 'o', title = 'O', kind = 'foe', x = "
    "9, y "
    "= 9 } },\n"
    "  boss = { phases = { { id = 'q', hp = 9, time = 5, run = function() end } }, kind = 'foe', x = 5, y = 5 } }\n"
    "stage.def('s', function() wait(forever) end)\n"
    "boss.def('b', { title = 'B', kind = 'foe', x = 50, y = 50, phases = {\n"
    "  { id = 'p', hp = 10, time = 20, run = function(e) e.hp = 0 end } } })\n"
    "local left = 6\n"
    "function string.chaos(...)\n" /* what a callback may do to those who iterate */
    "  if left == 0 then return end\n"
    "  left = left - 1\n"
    "  bullet.clear() string.more_rays()\n"
    "  for i = 1, 30 do bullet.fire { kind = 'dot', x = i, y = i, speed = 1, tag = 't' } end\n"
    "  enemy.each(nil, function(e) e:kill() end)\n"
    "  enemy.spawn { kind = 'foe', x = 5, y = 5, tag = 't' }\n"
    "  item.drop { kind = 'gem', x = 5, y = 5, n = 9, tag = 't' } item.group('t'):pull()\n"
    "  player.each(function(p) p.lives = 0 p.safe = 0 end)\n"
    "  return true, ...\n"
    "end\n"
    "function string.fails() error('fails') end\n"
    "on.graze(string.chaos) on.hit(string.chaos) on.kill(string.chaos) on.take(string.chaos)\n"
    "bullet.meet('t', 't', { clear = 'both', on_meet = string.chaos })\n"
    "sys.join(1, 'ship')\n"
    "if pad.down('fire') then sys.join(2, 'ship') end\n";

/* After it: things of each kind. */
static const char things[] =
    "local t = {}\n"
    "string.things = t\n"
    "for i = 1, 3 do\n"
    "  t[#t + 1] = bullet.fire { kind = 'slab', x = 60, y = 30 * i, speed = 0.25, motion = 'm', tag = 't' }\n"
    "  t[#t + 1] = shot.fire { kind = 'bolt', x = 50 + i, y = 200, speed = 0.5, from = nil, tag = 't' }\n"
    "  t[#t + 1] = enemy.spawn { kind = i == 1 and 'brief' or 'foe', x = 20 + 9 * i, y = 20, tag = 't' }\n"
    "  t[#t + 1] = sprite.put { sprite = 'wink', x = i, y = i }\n"
    "  t[#t + 1] = text.line { x = i, y = i, text = 'words', letter = i }\n"
    "  t[#t + 1] = task.go(function() wait(forever) end)\n"
    "  string.rays(t, i)\n"
    "  t[#t + 1] = player.get(i % 2 + 1)\n"
    "  t[#t + 1] = bullet.ml { name = 'main', kind = 'dot', x = 60, y = 30 * i, loop = i == 2 }\n"
    "  t[#t + 1] = motion.def { { wait = i } }\n"
    "  t[#t + 1] = bullet.group(i == 1 and 't' or nil)\n"
    "  item.drop { kind = i == 1 and 'husk' or 'gem', x = 30 * i, y = 100, tag = 't' }\n"
    "  t[#t + 1] = query.near { what = 'item', x = 30 * i, y = 100, radius = 1 }[1]\n"
    "  t[#t + 1] = item.group(i == 1 and 't' or nil)\n"
    "end\n"
    "t[#t + 1] = task.scope() t[#t + 1] = bg.layer(3) t[#t + 1] = bg.plane()\n"
    "bg.def('deep', function() bg.layer(1).map = 'sea' wait(5) bg.plane().map = 'reef' end)\n"
    "t[#t + 1] = bullet.fire { kind = 'dot', x = 1, y = 1, speed = 0 }\n"
    "t[#t]:remove()\n"
    "score.rule { name = 'chain', points = 3 }\n"
    "mission.def('left', { title = 'Left', stage = 's', goal = { score = 5 } })\n"
    "stage.play('s')\n";

static struct rig_game g;
static struct rig rig;
static struct rng rng;
static const struct api_entry *entry; /* being called */

static uint64_t below(uint64_t n)
{
    return rng_below(&rng, n);
}

static bool one_in(uint64_t n)
{
    return below(n) == 0;
}

/* ---- values ---- */

static void push_string_field(lua_State *L, const char *name)
{
    lua_getglobal(L, "string");
    lua_getfield(L, -1, name);
    lua_remove(L, -2);
}

/* A handle that no call returned: any kind, generation and slot. */
static int64_t forged(unsigned mask)
{
    static const uint32_t slots[] = { 0, 1, 2, 63, 64, 255, 256, 4095, 65534, 65535, 0x800000, 0xffffff };
    static const uint32_t gens[] = { 0, 1, 2, 3, RETIRED_GENERATION };
    enum handle_kind kind;

    do
        kind = (enum handle_kind)(1 + below(HANDLE_KINDS - 1));
    while (mask && !(mask >> kind & 1));
    return handle_make(kind, gens[below(5)], slots[below(sizeof slots / sizeof *slots)]);
}

static void push_thing(lua_State *L, unsigned mask)
{
    int64_t h = 0;

    if (one_in(4)) {
        lua_pushinteger(L, forged(mask));
        return;
    }
    push_string_field(L, "things");
    lua_Integer n = (lua_Integer)lua_rawlen(L, -1);
    for (int i = 0; i < 40; i++) {
        lua_rawgeti(L, -1, 1 + (lua_Integer)below((uint64_t)n));
        h = lua_tointeger(L, -1);
        lua_pop(L, 1);
        if (!mask || mask >> handle_kind(h) & 1)
            break;
    }
    lua_pop(L, 1);
    lua_pushinteger(L, h);
}

static void push_from(lua_State *L, const char *const *words, uint64_t n)
{
    lua_pushstring(L, words[below(n)]);
}

static void push_word(lua_State *L)
{
    static const char *const words[] = { "",      "a",      "main",  "bullets", "bullet", "enemy", "shot", "coins",
                                         "dot",   "foe",    "ship",  "m",       "t",      "s",     "b",    "p",
                                         "stage", "normal", "graze", "fire",    "left",   "%s%n",  "none", "\xff\xfe" };
    static const size_t lengths[] = { 15, 16, 31, 32, 60, 61, 63, 64, 127, 128, 399 };
    char s[400];

    if (one_in(20)) {
        lua_pushlstring(L, "a\0b", 3);
    } else if (!one_in(5)) {
        push_from(L, words, sizeof words / sizeof *words);
    } else {
        size_t n = lengths[below(sizeof lengths / sizeof *lengths)];
        for (size_t i = 0; i < n; i++)
            s[i] = (char)('a' + below(26));
        lua_pushlstring(L, s, n);
    }
}

static void push_any(lua_State *L, int depth);

static void push_table(lua_State *L, int depth)
{
    lua_newtable(L);
    for (uint64_t n = below(5); n--;) {
        push_any(L, depth + 1);
        lua_rawseti(L, -2, (lua_Integer)below(4) + (one_in(9) ? 1000000 : 1));
    }
    for (uint64_t n = below(3); n--;) {
        push_word(L);
        push_any(L, depth + 1);
        lua_rawset(L, -3);
    }
}

static void push_number(lua_State *L)
{
    static const double odd[] = { 0,        -0.0,  0.5,        -1,         1e308,        -1e308,
                                  4.9e-324, 2.5,   16383,      16383.0001, -16384,       8191.5,
                                  65535,    65536, 2147483647, 2147483648, 4294967296.0, 9007199254740993.0,
                                  180 };

    switch (below(6)) {
    case 0:
        lua_pushnumber(L, one_in(2) ? (double)NAN : one_in(2) ? (double)INFINITY : -(double)INFINITY);
        break;
    case 1:
        lua_pushinteger(L, one_in(2) ? LUA_MAXINTEGER : one_in(2) ? LUA_MININTEGER : (lua_Integer)rng_next(&rng));
        break;
    case 2:
        lua_pushinteger(L, (lua_Integer)below(300) - 100);
        break;
    default:
        lua_pushnumber(L, odd[below(sizeof odd / sizeof *odd)]);
    }
}

static void push_function(lua_State *L)
{
    push_string_field(L, one_in(4) ? "fails" : "chaos");
}

static void push_any(lua_State *L, int depth)
{
    switch (below(depth > 3 ? 6 : 8)) {
    case 0:
        lua_pushnil(L);
        break;
    case 1:
        lua_pushboolean(L, one_in(2));
        break;
    case 2:
        push_word(L);
        break;
    case 3:
        push_thing(L, 0);
        break;
    case 4:
        push_function(L);
        break;
    case 5:
        push_number(L);
        break;
    default:
        push_table(L, depth);
    }
}

/* A number in [lo, hi], its ends more often than by chance. Bursts of work stay small. */
static void push_ranged(lua_State *L, const struct api_param *p, bool whole)
{
    double lo = p->lo, hi = p->hi, v;
    bool many = !strcmp(p->name, "n") || !strcmp(p->name, "arms");

    if (hi <= lo)
        lo = -10, hi = 10;
    if (many && hi > 40)
        hi = 40;
    switch (below(6)) {
    case 0:
        v = lo;
        break;
    case 1:
        v = hi;
        break;
    case 2:
        v = many ? 3 : lo - 1;
        break;
    case 3:
        v = many ? 2 : hi + 1;
        break;
    default:
        v = lo + (hi - lo) * ((double)below(1 << 20) / (1 << 20));
        if (one_in(2) && lo <= 0 && hi >= 3)
            v = (double)below(4);
    }
    if (whole && v >= -9.2e18 && v <= 9.2e18)
        lua_pushinteger(L, (lua_Integer)v);
    else
        lua_pushnumber(L, v);
}

static void push_hit(lua_State *L, bool share)
{
    const struct api_param p = PARAM("hit", A_FX, REQ, 0, share ? 1 : MAX_SPEED, NULL, NULL, NULL);

    if (one_in(4)) {
        lua_pushliteral(L, "none");
        return;
    }
    lua_newtable(L);
    push_ranged(L, &p, false);
    if (share || one_in(2)) {
        lua_setfield(L, -2, share ? "share" : "circle");
        return;
    }
    lua_newtable(L);
    lua_insert(L, -2);
    lua_rawseti(L, -2, 1);
    push_ranged(L, &p, false);
    lua_rawseti(L, -2, 2);
    lua_setfield(L, -2, one_in(2) ? "box" : "capsule");
}

static void push_steps(lua_State *L, int depth);

/* Words for types of which only these are right. */
static const struct {
    enum api_type type;
    const char *words[8];
} choices[] = {
    { A_BULLET_KIND, { "dot", "slab", "air" } },
    { A_SHOT_KIND, { "bolt" } },
    { A_ENEMY_KIND, { "foe", "brief" } },
    { A_PLAYER_KIND, { "ship" } },
    { A_SPARK_KIND, { "glow" } },
    { A_ITEM_KIND, { "gem", "husk" } },
    { A_LASER_KIND, { "ray", "lance" } },
    { A_OPTION_KIND, { "bead", "moon" } },
    { A_SPRITE, { "dot", "arrow", "wink" } },
    { A_BLEND, { "glow", "ghost" } },
    { A_FONT, { "tiny" } },
    { A_EASE, { "linear", "in", "out", "both" } },
    { A_LAYER, { "back", "middle", "front" } },
    { A_SPARK_LAYER, { "middle", "front" } },
    { A_ALIGN, { "left", "center", "right" } },
    { A_MEET, { "none", "first", "second", "both" } },
    { A_HOST_SCREEN, { "settings", "replays", "practice", "keys" } },
    { A_BARS_DOWN, { "all", "any" } },
    { A_MAP, { "sea", "reef" } },
    { A_SOUND, { "hit", "boom" } },
    { A_TUNE, { "tide", "deep" } },
    { A_DEPTH, { "back", "front" } },
    { A_FIRE, { "bullet", "shot", "bolt", "curve", "beam" } },
    { A_EMIT_FIRE, { "bullet", "shot", "bolt", "curve", "beam" } },
    { A_EMIT_PATTERN, { "one", "ring", "fan", "arc", "stack", "line" } },
};

/* Words and tables of string.tables that random ones would hardly hit: for a parameter of an entry; NULL: of any. */
static const struct {
    const char *entry, *param, *words[4];
} likely[] = {
    { "rom.text", "name", { "words.txt" } },
    { "boss.history", "name", { "b" } },
    { "boss.history", "id", { "p" } },
    { "boss.history", "difficulty", { "normal" } },
    { "score.count", "name", { "chain" } },
    { "sys.volley", "name", { "pattern.ring" } },
    { "board.dip", "name", { "odd" } },
    { "player.def", "bomb", { "boom" } },
    { NULL, "of", { "bullet", "shot", "enemy" } },
    { NULL, "what", { "bullet", "player" } },
    { NULL, "to", { "main", "other" } },
    { "pattern.points", "list", { "spots" } },
    { "choose", "list", { "choices" } },
    { "score.tally", "list", { "tally" } },
};

static const char *pick(const char *const words[])
{
    uint64_t n = 0;

    while (words[n])
        n++;
    return words[below(n)];
}

/* NULL: there are none. */
static const char *likely_word(const struct api_param *p)
{
    for (size_t i = 0; i < sizeof likely / sizeof *likely; i++)
        if (!strcmp(p->name, likely[i].param) && (!likely[i].entry || (entry && !strcmp(entry->name, likely[i].entry))))
            return pick(likely[i].words);
    return NULL;
}

static void push_table_for(lua_State *L, const struct api_param *p)
{
    const char *name = likely_word(p);

    if (!strcmp(p->name, "steps"))
        push_steps(L, 0);
    else if (one_in(3))
        push_table(L, 0);
    else {
        push_string_field(L, "tables");
        lua_getfield(L, -1, name ? name : p->name);
        lua_remove(L, -2);
    }
}

/* A value for parameter p: one in six is anything at all. */
static void push_value(lua_State *L, const struct api_param *p)
{
    static const char *const buttons[] = PAD_BUTTON_NAMES;
    const char *word = likely_word(p);

    if (one_in(6)) {
        push_any(L, 0);
        return;
    }
    for (size_t i = 0; i < sizeof choices / sizeof *choices; i++)
        if (p->type == choices[i].type) {
            lua_pushstring(L, pick(choices[i].words));
            return;
        }
    switch (p->type) {
    case A_COUNT:
        if (one_in(8)) {
            lua_pushinteger(L, LUA_MAXINTEGER);
            break;
        }
        /* fall through */
    case A_INT:
        push_ranged(L, p, true);
        break;
    case A_NUM:
    case A_FX:
        push_ranged(L, p, false);
        break;
    case A_SCALE:
        lua_pushnumber(L, (double)(1 + below(34)) / 8);
        break;
    case A_DIR:
        lua_pushnumber(L, one_in(3) ? (double)(int64_t)rng_next(&rng) : (double)below(72000) / 100 - 360);
        break;
    case A_STR:
        if (word && !one_in(3))
            lua_pushstring(L, word);
        else
            push_word(L);
        break;
    case A_BOOL:
        lua_pushboolean(L, one_in(2));
        break;
    case A_FUNC:
        push_function(L);
        break;
    case A_TABLE:
        push_table_for(L, p);
        break;
    case A_ANY:
        if (one_in(2))
            push_any(L, 0);
        else if (word)
            lua_pushstring(L, word);
        else
            push_thing(L, POSITION_HANDLE_KINDS);
        break;
    case A_ROUTE:
        push_string_field(L, "route");
        break;
    case A_THING:
        push_thing(L, (unsigned)p->lo);
        break;
    case A_HIT_SHAPE:
        push_hit(L, entry && !strcmp(entry->name, "laser.def"));
        break;
    case A_MOTION:
        if (one_in(3))
            lua_pushliteral(L, "m");
        else
            push_thing(L, 1 << H_MOTION);
        break;
    case A_BUTTON:
        push_from(L, buttons, PAD_BUTTON_COUNT);
        break;
    case A_PLAYER:
        if (one_in(2))
            lua_pushinteger(L, 1 + (lua_Integer)below(2));
        else
            push_thing(L, 1 << H_PLAYER);
        break;
    case A_SPAN:
        lua_createtable(L, 2, 0);
        for (int i = 1; i <= 2; i++) {
            lua_pushinteger(L, (lua_Integer)below(12) - 1);
            lua_rawseti(L, -2, i);
        }
        break;
    default:
        fail_msg("%s: a type without values", p->name);
    }
}

/* { x, y } */
static void push_place(lua_State *L)
{
    static const struct api_param p = PARAM("x", A_FX, OPT, -WORLD_EDGE, WORLD_EDGE, NULL, NULL, NULL);

    lua_newtable(L);
    for (lua_Integer i = 1; i <= 2; i++) {
        if (one_in(5))
            lua_pushliteral(L, "goal");
        else
            push_value(L, &p);
        lua_rawseti(L, -2, i);
    }
}

static const struct api_entry *entry_named(const char *name)
{
    for (int i = 0; i < api_count_entries(&api_table); i++)
        if (!strcmp(api_get_entry(&api_table, i)->name, name))
            return api_get_entry(&api_table, i);
    return NULL;
}

/* Sets a field of the table on top, in one of nine to a value's name. */
static void set_field(lua_State *L, const struct api_param *p)
{
    if (p->type != A_BULLET_KIND && one_in(9))
        lua_pushstring(L, one_in(9) ? "mood" : one_in(2) ? "heat" : "goal");
    else
        push_value(L, p);
    lua_setfield(L, -2, p->name);
}

/* The table of emit: a pattern with what it needs, and some of the rest. */
static void push_emit(lua_State *L)
{
    static const char *const patterns[][2] = { { "one", "" },      { "ring", "" },          { "fan", "spread" },
                                               { "arc", "sweep" }, { "stack", "speed_to" }, { "line", "width" } };
    const struct api_entry *e = entry_named("motion.def emit");
    const uint64_t k = below(6);
    const bool wild = one_in(8);

    lua_newtable(L);
    for (int i = 0; i < e->count; i++) {
        const struct api_param *p = &e->params[i];
        const char *name = p->name;
        const bool size = strstr("spread sweep speed_to width", name) != NULL;
        const bool need = !p->optional || !strcmp(name, patterns[k][1]) || (k && !strcmp(name, "n"));
        if (wild ? one_in(2) : need || (!size && strcmp(name, "n") && one_in(4)))
            set_field(L, p);
    }
    lua_pushstring(L, patterns[k][0]);
    lua_setfield(L, -2, "pattern");
    if (one_in(4))
        set_field(L, &(struct api_param)PARAM("heat", A_FX, OPT, -32768, 32767, NULL, NULL, NULL));
}

static void push_await(lua_State *L)
{
    const struct api_entry *e = entry_named("motion.def wait_for");

    lua_newtable(L);
    set_field(L, &e->params[below(4)]);
    if (one_in(9))
        set_field(L, &e->params[below(4)]);
    lua_pushinteger(L, (lua_Integer)below(9));
    lua_setfield(L, -2, "limit");
}

/* A step whose word stands alone. */
static void push_alone(lua_State *L)
{
    static const struct api_param route = PARAM("path", A_ROUTE, OPT, 0, 0, NULL, NULL, NULL);

    lua_newtable(L);
    switch (below(3)) {
    case 0:
        push_emit(L);
        lua_setfield(L, -2, "emit");
        return;
    case 1:
        push_await(L);
        lua_setfield(L, -2, "wait_for");
        return;
    default:
        push_value(L, &route);
        lua_setfield(L, -2, "path");
        lua_pushboolean(L, one_in(2));
        lua_setfield(L, -2, "mirror");
    }
}

/* A key of a step that needs no table of its own, most often one that goes without others. */
static const struct api_param *any_step_key(void)
{
    static const char others[] = "over loop bounce walls emit wait_for path mirror",
                      dependent[] = "every phase radius_to spin at ease";
    const struct api_entry *e = entry_named("motion.def step");
    const struct api_param *p;

    do
        p = &e->params[below((uint64_t)e->count)];
    while (strstr(others, p->name) || (strstr(dependent, p->name) && !one_in(5)));
    return p;
}

static void push_step(lua_State *L)
{
    lua_newtable(L);
    for (uint64_t k = 1 + below(2); k--;) {
        const struct api_param *p = any_step_key();
        if (p->type == A_TABLE) {
            push_place(L);
            lua_setfield(L, -2, p->name);
        } else {
            set_field(L, p);
        }
    }
    if (one_in(2)) {
        lua_pushinteger(L, one_in(9) ? 1000000000 : (lua_Integer)below(6));
        lua_setfield(L, -2, "over");
    }
}

/* A motion program: most are good. */
static void push_steps(lua_State *L, int depth)
{
    lua_newtable(L);
    for (lua_Integer i = 1, n = 1 + (lua_Integer)below(4); i <= n; i++) {
        if (depth < 6 && one_in(5)) {
            push_steps(L, depth + 1);
            lua_pushinteger(L, one_in(4) ? LUA_MAXINTEGER : (lua_Integer)below(9));
            lua_setfield(L, -2, one_in(4) ? "bounce" : "loop");
        } else if (one_in(3)) {
            push_alone(L);
        } else {
            push_step(L);
        }
        lua_rawseti(L, -2, i);
    }
}

/* ---- calls ---- */

struct tally {
    int good, faults;
};

static const struct api_param *prop; /* or being read and written */
static enum handle_kind prop_kind;
static bool returned;

static bool wanted(const struct api_param *p)
{
    return p->optional ? one_in(2) : !one_in(16);
}

/* 1 to 3: the shape that the word is of (api_parts.h), where it may be left out; 0: none. */
static uint64_t shape_of(const struct api_param *p)
{
    static const char *const words[] = { "radius", "w h", "to_x to_y width" };

    for (uint64_t i = 0; p->optional && i < sizeof words / sizeof *words; i++)
        if (strstr(words[i], p->name))
            return i + 1;
    return 0;
}

/* Pushes the entry's arguments: those for plain ones, then one table. Returns how many. */
static int push_arguments(lua_State *L, const struct api_entry *e)
{
    const struct api_entry *fire = NULL;
    int n = e->positional_count;

    for (int i = 0; i < e->positional_count; i++)
        if (wanted(&e->params[i]))
            push_value(L, &e->params[i]);
        else
            lua_pushnil(L);
    if (e->flags & API_VARARGS)
        for (uint64_t k = below(4); k--; n++)
            push_any(L, 0);
    if (e->count == e->positional_count && !(e->flags & API_PATTERN))
        return n;
    if (one_in(20)) {
        push_any(L, 0);
        return n + 1;
    }
    lua_newtable(L);
    const char *of = one_in(3) ? "shot" : "bullet";
    for (int i = 0; e->flags & API_PATTERN && i < api_count_entries(&api_table); i++)
        if (!strncmp(api_get_entry(&api_table, i)->name, of, strlen(of)) &&
            !strcmp(strchr(api_get_entry(&api_table, i)->name, 0) - 5, ".fire"))
            fire = api_get_entry(&api_table, i);
    bool place = one_in(2);
    uint64_t shape = below(4);
    for (int i = e->positional_count; i < e->count + (fire ? fire->count : 0); i++) {
        const struct api_param *p = i < e->count ? &e->params[i] : &fire->params[i - e->count];
        bool xy = !strcmp(p->name, "x") || !strcmp(p->name, "y"), from = !strcmp(p->name, "from");
        if (xy && p->optional ? place : from ? !place : shape_of(p) && !one_in(9) ? shape == shape_of(p) : wanted(p)) {
            push_value(L, p);
            lua_setfield(L, -2, p->name);
        }
    }
    if (e->flags & (API_PATTERN | API_TAKES_VALUES) && one_in(6)) {
        static const struct api_param heat = PARAM("heat", A_FX, OPT, -32768, 32767, NULL, NULL, NULL);
        push_value(L, &heat);
        lua_setfield(L, -2, one_in(6) ? "mood" : one_in(2) ? "heat" : "goal");
    }
    if (fire && !one_in(8)) {
        lua_pushstring(L, of);
        lua_setfield(L, -2, "fire");
    }
    if (one_in(30)) {
        push_word(L);
        push_any(L, 0);
        lua_rawset(L, -3);
    }
    return n + 1;
}

/* Pushes the function of an entry. */
static void push_entry(lua_State *L, const char *name)
{
    const char *split = strpbrk(name, ".:");
    char space[40];

    if (!split) {
        lua_getglobal(L, name);
        return;
    }
    snprintf(space, sizeof space, "%.*s", (int)(split - name), name);
    if (*split == ':') {
        for (int k = 1; k < HANDLE_KINDS; k++)
            if (!strcmp(api_table.things[k]->name, space))
                lua_pushinteger(L, handle_make((enum handle_kind)k, 1, 0));
    } else if (!strcmp(space, "sys"))
        push_string_field(L, "sys");
    else
        lua_getglobal(L, space);
    lua_getfield(L, -1, split + 1);
    lua_remove(L, -2);
}

static int done(lua_State *L, int status, lua_KContext context)
{
    (void)L, (void)status, (void)context;
    returned = true;
    return 0;
}

static int call_entry(lua_State *L)
{
    luaL_checkstack(L, 100, NULL);
    push_entry(L, entry->name);
    if (!lua_isfunction(L, -1))
        fail_msg("%s is not there", entry->name);
    int n = push_arguments(L, entry);
    lua_callk(L, n, LUA_MULTRET, 0, done);
    return done(L, LUA_OK, 0);
}

static int use_property(lua_State *L)
{
    luaL_checkstack(L, 100, NULL);
    push_thing(L, 1u << prop_kind);
    if (one_in(3)) {
        lua_getfield(L, -1, prop->name);
        lua_pop(L, 1);
    } else {
        push_value(L, prop);
        lua_setfield(L, -2, prop->name);
    }
    lua_getfield(L, -1, prop->name);
    return done(L, LUA_OK, 0);
}

static int as_task(lua_State *L)
{
    lua_pushcfunction(L, entry ? call_entry : use_property);
    tasks_start(vm_board(L), L, 0, 0);
    return 0;
}

/* A fault says what the caller did wrong, and nothing of how the library works inside. */
static void clean_fault(const char *name)
{
    const struct board_fault *f = rig_fault(&rig);

    assert_non_null(f);
    const char *text = strstr(f->message, ": "); /* behind the place: the caller is C, so it may be the library's */
    text = text ? text : f->message;
    const bool shows_inside = strstr(text, "@std") || strstr(text, "attempt to") || strstr(text, "bad argument");
    if (f->kind == FAULT_NONE || !f->message[0] || (shows_inside && !(entry && entry->flags & API_SYS)))
        fail_msg("%s: fault %d \"%s\"", name, f->kind, f->message);
}

/* Goes on for some frames: what the call left behind is moved, hit, drawn and hashed. */
static void go_on(const char *name)
{
    uint16_t pads[MAX_PLAYERS];

    for (int f = 0; f < 6; f++) {
        for (int p = 0; p < MAX_PLAYERS; p++)
            pads[p] = (uint16_t)below(PAD_ALL + 1);
        if (board_tick(rig.b, pads)->fault) {
            clean_fault(name);
            return;
        }
    }
    rig_picture(&rig);
    board_hash(rig.b);
}

static void try_once(const char *name, bool loading, struct tally *t)
{
    rig_restore(&rig);
    returned = false;
    rig.b->vm.loading = loading;
    bool fine = vm_call(rig.b, loading || one_in(2) ? (entry ? call_entry : use_property) : as_task);
    rig.b->vm.loading = false;
    if (fine)
        go_on(name);
    else
        clean_fault(name);
    t->good += returned;
    t->faults += !fine || rig_fault(&rig);
    assert_true(heap_check(rig.b->vm.heap));
}

static int trials(int brief)
{
    return rig_long() ? 20 * brief : brief;
}

TEST(entries)
{
    prop = NULL;
    for (int i = 0; i < api_count_entries(&api_table); i++) {
        struct tally t = { 0 };
        entry = api_get_entry(&api_table, i);
        if (strchr(entry->name, ' ')) /* a part of another's arguments */
            continue;
        int n = trials(entry->flags & API_PATTERN ? 3000
                       : entry->count > 18        ? 9000
                       : entry->count > 16        ? 1500
                       : entry->count > 8         ? 600
                       : entry->count > 4         ? 260
                                                  : 240);
        bool never = !strcmp(entry->name, "sys.fail") || !strcmp(entry->name, "boss.fight") || /* too long */
                     !strcmp(entry->name, "sys.text_back"); /* takes what sys.keep_text returned alone */
        for (int k = 0; k < n || (!t.good && !never && k < 20 * n); k++)
            try_once(entry->name, entry->flags & API_LOAD_ONLY, &t);
        if (!t.good && !never)
            fail_msg("%s never returned, with any drawn arguments: %s", entry->name,
                     rig_fault(&rig) ? rig_fault(&rig)->message : "?");
        if (!t.faults && entry->count)
            fail_msg("%s never faulted", entry->name);
    }
}

TEST(properties)
{
    entry = NULL;
    for (int k = 1; k < HANDLE_KINDS; k++)
        for (int i = 0; i < api_table.things[k]->n; i++) {
            struct tally t = { 0 };
            prop = &api_table.things[k]->props[i];
            prop_kind = (enum handle_kind)k;
            for (int n = trials(60); n--;)
                try_once(prop->name, false, &t);
            if (!t.good && !handle_kind_is_group((enum handle_kind)k))
                fail_msg("%s.%s never worked", api_table.things[k]->name, prop->name);
        }
}

/* ---- cases that random calls miss ---- */

/* Functions of enemies that despawn without dying are garbage. */
TEST(no_leak)
{
    static const char text[] = "task.go(function() for i = 1, 3000 do\n"
                               "  local e = enemy.spawn { kind = 'foe', x = 9, y = 9, run = function() end,\n"
                               "                          on_death = function() return ('x'):rep(i % 100) end }\n"
                               "  e:remove()\n"
                               "  if i % 20 == 0 then wait(1) end\n"
                               "end end)\n";
    lua_State *L = rig.b->vm.L;

    rig_restore(&rig);
    assert_int_equal(luaL_loadbufferx(L, text, strlen(text), "@chunk", "t"), LUA_OK);
    lua_call(L, 0, 0);
    rig_run(&rig, 40);
    const size_t early = heap_used(rig.b->vm.heap);
    rig_run(&rig, 100);
    const size_t late = heap_used(rig.b->vm.heap);
    if (late > early + early / 3)
        fail_msg("the heap grew from %zu to %zu bytes", early, late);
}

/* An enemy that dies while scripts load is removed in the first frame, and its handlers run. */
TEST(killed_at_load)
{
    struct rig_game game;

    rig_script(&game, NULL,
               "enemy.def('foe', { sprite = 'dot', hit = 'none' })\n"
               "local kills = 0\n"
               "on.kill(function() kills = kills + 1 end)\n"
               "enemy.spawn { kind = 'foe', x = 9, y = 9 }:kill()\n"
               "task.go(function() wait(1) print(kills, board.live 'enemies') end)");
    assert_string_equal(rig_said(&game, 2, false), "1\t0\n");
    rig_game_free(&game);
}

/* A start that no manifest allows is refused. */
TEST(start)
{
    static const int32_t bad[] = { -1, 2, INT32_MIN };
    struct manifest m = rig_manifest();
    struct board_start start = { .difficulty = -1, .dip[0] = 1 };
    struct rig_game game;
    struct rig r;
    char err[512];

    m.n_dips = 1;
    m.dips[0] = (struct dip){ .name = "coins", .n_values = 2, .hi = 1, .value_name = { "free", "one" } };
    rig_script(&game, &m, "board.note(board.dip 'coins')");
    rig_power(&r, &game, &start);
    for (size_t i = 0; i < sizeof bad / sizeof *bad; i++) {
        start.dip[0] = bad[i];
        assert_null(board_power_on(r.ram, r.ram_size, &game.image.rom, &start, err, sizeof err));
        assert_non_null(strstr(err, "coins"));
    }
    start.dip[0] = 0;
    start.difficulty = m.n_difficulties;
    assert_null(board_power_on(r.ram, r.ram_size, &game.image.rom, &start, err, sizeof err));
    rig_close(&r);
}

static int setup(void **state)
{
    static char script[sizeof rays + sizeof world + sizeof things];
    struct manifest m = rig_manifest();

    m.bullet_values = m.shot_values = m.enemy_values = 4;
    m.has_orbit = m.has_wide_text = 1;
    m.lines = 16;

    (void)state;
    m.n_dips = 1;
    snprintf(m.dips[0].name, sizeof m.dips[0].name, "odd");
    m.dips[0].is_number = true;
    m.dips[0].hi = 9;
    m.lua_kib = 640;
    m.has_freeze = m.bullets_can_meet = m.has_backgrounds = m.has_bodies = m.has_pierce = m.has_sound =
        m.has_transforms = 1;
    m.items = 40;
    m.lasers = 12;
    m.curve_points = 512;
    m.options = 12;
    m.bulletml_runners = 24;
    m.view_w = 120;
    m.view_h = 200;
    snprintf(script, sizeof script, "%s%s%s", rays, world, things);
    rig_with_sys(&g, &m, script); /* the fuzz calls sys too */
    rig_blends(&g);
    rig_maps(&g);
    rig_sounds(&g);
    rig_document(&g, "main",
                 "<bulletml><action label='top'><repeat><times>9</times><action><fire><bullet label='a'><action>"
                 "<changeSpeed><speed>$1</speed><term>$rank*50</term></changeSpeed><wait>$rand*9</wait></action>"
                 "</bullet></fire><wait>4</wait></action></repeat></action></bulletml>");
    rig_power(&rig, &g, NULL);
    rig_run(&rig, 3);
    rig_save(&rig);
    rng_seed(&rng, 1234);
    return 0;
}

static int teardown(void **state)
{
    (void)state;
    rig_close(&rig);
    return 0;
}

RUN_TESTS(setup, teardown)
