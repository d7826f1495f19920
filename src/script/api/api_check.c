/*
 * api_check.c - checks arguments against the API table and writes the error messages.
 */
#include <assert.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "../../base/trig.h"
#include "api_parts.h"

#define HIT_COMPOUND_FORMS "{ circles = { { x, y, r }, .. } }, { sprite = name }"
const char *const api_hit_forms[] = {
    [HIT_PLAYERS] = "{ circle = r } or { sprite = name }",
    [HIT_ENEMIES] =
        "{ circle = r }, { box = { w, h } }, { capsule = { length, radius, dir } }, " HIT_COMPOUND_FORMS " or \"none\"",
    [HIT_LASERS] = "{ share = s }, s from 0 to 1, or \"none\"",
    [HIT_BULLETS] =
        "{ circle = r }, { box = { w, h } }, { capsule = { length, radius } }, " HIT_COMPOUND_FORMS " or \"none\"",
};

const char *const api_thing_names[HANDLE_KINDS] = {
    [H_BULLET] = "a bullet",
    [H_SHOT] = "a shot",
    [H_ENEMY] = "an enemy",
    [H_PLAYER] = "a player",
    [H_SPRITE] = "a sprite",
    [H_TASK] = "a task",
    [H_MOTION] = "a motion",
    [H_GROUP] = "a group",
    [H_SHOTS] = "a group of shots",
    [H_ENEMIES] = "a group of enemies",
    [H_ITEM] = "an item",
    [H_ITEMS] = "a group of items",
    [H_LINE] = "a line of text",
    [H_LAYER] = "a layer",
    [H_PLANE] = "a plane",
    [H_LASER] = "a laser",
    [H_LASERS] = "a group of lasers",
    [H_OPTION] = "an option",
    [H_BULLETML] = "a document",
    [H_MOVE] = "a move",
    [H_CAMERA] = "the camera",
};

/* Returns whether v is probably the result of arithmetic on a handle. Handles are integers (handle.h), so Lua cannot
 * reject arithmetic on them. A handle plus a fraction is a double in the range of handles; no valid argument is that
 * large. */
static bool is_handle_arithmetic(double v)
{
    return v >= 0x1p62 && v < 0x1p63;
}

const char *api_push_description(lua_State *L, int at)
{
    switch (lua_type(L, at)) {
    case LUA_TNIL:
    case LUA_TNONE:
        return lua_pushliteral(L, "nil");
    case LUA_TNUMBER:
        if (lua_isinteger(L, at) && handle_is_well_formed(lua_tointeger(L, at)))
            return lua_pushstring(L, api_thing_names[handle_kind(lua_tointeger(L, at))]);
        if (lua_isinteger(L, at))
            return lua_pushfstring(L, "%I", (LUAI_UACINT)lua_tointeger(L, at));
        if (isnan(lua_tonumber(L, at)))
            return lua_pushliteral(L, "nan");
        if (is_handle_arithmetic(lua_tonumber(L, at)))
            return lua_pushfstring(L, "%f (arithmetic on a thing? use one of its properties, such as x)",
                                   lua_tonumber(L, at));
        return lua_pushfstring(L, "%f", lua_tonumber(L, at));
    case LUA_TSTRING:
        return lua_pushfstring(L, "\"%s\"", lua_tostring(L, at));
    case LUA_TBOOLEAN:
        return lua_pushstring(L, lua_toboolean(L, at) ? "true" : "false");
    default:
        return lua_pushfstring(L, "a %s", luaL_typename(L, at));
    }
}

static void format_number(char *out, size_t size, double v)
{
    snprintf(out, size, "%.14g", v);
}

static void raise_expected(lua_State *L, const char *entry, const struct api_param *p, int at, const char *form)
{
    const char *got = api_push_description(L, at);

    api_error(L, entry, "%s: expected %s, got %s", p->name, form, got);
}

static void raise_expected_number(lua_State *L, const char *entry, const struct api_param *p, int at, const char *noun)
{
    char lo[32], hi[32], form[160];

    format_number(lo, sizeof lo, p->lo);
    format_number(hi, sizeof hi, p->hi);
    snprintf(form, sizeof form, "%s from %s to %s%s%s", noun, lo, hi, p->unit ? " " : "", p->unit ? p->unit : "");
    raise_expected(L, entry, p, at, form);
}

static void check_int(lua_State *L, const char *entry, const struct api_param *p, int at, struct api_value *v)
{
    int is_integer = v->is_integer;

    v->i = is_integer ? v->bits : v->type == LUA_TNUMBER ? lua_tointegerx(L, at, &is_integer) : 0;
    if (p->type == A_COUNT && is_integer && v->i == LUA_MAXINTEGER)
        return;
    if (is_integer && (double)v->i >= p->lo && (double)v->i <= p->hi)
        return;
    if (p->hi == 0xffffff)
        raise_expected(L, entry, p, at, "a colour from 0x000000 to 0xffffff");
    else
        raise_expected_number(L, entry, p, at, p->type == A_COUNT ? "forever or a whole number" : "a whole number");
}

/* Returns the number in v; 0 if it is not a number. */
static double get_number(const struct api_value *v)
{
    double d;

    if (v->is_integer || v->type != LUA_TNUMBER)
        return v->is_integer ? (double)v->bits : 0;
    memcpy(&d, &v->bits, sizeof d);
    return d;
}

static void check_number(lua_State *L, const char *entry, const struct api_param *p, int at, struct api_value *v)
{
    bool is_number = v->type == LUA_TNUMBER;

    v->n = get_number(v);
    if (!is_number || !(v->n >= p->lo && v->n <= p->hi))
        raise_expected_number(L, entry, p, at, "a number");
    if (p->type == A_FX && !fx_from_double(v->n, &v->f))
        raise_expected_number(L, entry, p, at, "a number");
}

/* Checks and returns one end of the span at `at`: the first (i = 1) or the last (i = 2). `form` is the expected form in
 * the error. */
static lua_Integer check_span_end(lua_State *L, const char *entry, const struct api_param *p, int at, int i,
                                  const char *form)
{
    int is_integer = 0;
    lua_Integer end = lua_rawgeti(L, at, i) == LUA_TNUMBER ? lua_tointegerx(L, -1, &is_integer) : 0;

    if (!is_integer || (double)end < p->lo || (double)end > p->hi) {
        const char *got = api_push_description(L, lua_gettop(L));
        api_error(L, entry, "%s: expected %s, got %s as the %s", p->name, form, got, i == 1 ? "first" : "last");
    }
    lua_pop(L, 1);
    return end;
}

static void check_span(lua_State *L, const char *entry, const struct api_param *p, int at, struct api_value *v)
{
    char form[160];

    (void)v;
    snprintf(form, sizeof form, "{ first, last }, whole numbers from %.14g to %.14g", p->lo, p->hi);
    if (lua_type(L, at) != LUA_TTABLE)
        raise_expected(L, entry, p, at, form);
    if (lua_rawlen(L, at) > 2)
        api_error(L, entry, "%s: expected %s, got %d values", p->name, form, (int)lua_rawlen(L, at));
    lua_Integer first = check_span_end(L, entry, p, at, 1, form), last = check_span_end(L, entry, p, at, 2, form);
    if (first > last)
        api_error(L, entry, "%s: first %d is greater than last %d (did you mean { %d, %d }?)", p->name, (int)first,
                  (int)last, (int)last, (int)first);
}

static void check_dir(lua_State *L, const char *entry, const struct api_param *p, int at, struct api_value *v)
{
    bool is_number = v->type == LUA_TNUMBER;

    v->n = get_number(v);
    if (!is_number || !trig_from_degrees(v->n, &v->a))
        raise_expected(L, entry, p, at, "a number of degrees");
}

static void check_scale(lua_State *L, const char *entry, const struct api_param *p, int at, struct api_value *v)
{
    const double steps = get_number(v) * SCALE_ONE;
    const bool in_range = v->type == LUA_TNUMBER && steps >= p->lo * SCALE_ONE && steps <= p->hi * SCALE_ONE;

    v->i = in_range ? (int64_t)steps : 0;
    if (!in_range || (double)v->i != steps)
        raise_expected(L, entry, p, at, "a number from 0.25 to 4 in steps of 1/8");
}

static void check_type(lua_State *L, const char *entry, const struct api_param *p, int at, int type, const char *form)
{
    if (lua_type(L, at) != type)
        raise_expected(L, entry, p, at, form);
}

/* Checks a string. lo and hi bound its length in bytes; hi 0: no bound. */
static void check_string(lua_State *L, const char *entry, const struct api_param *p, int at, struct api_value *v)
{
    char form[64];
    size_t bytes;

    (void)v;
    check_type(L, entry, p, at, LUA_TSTRING, "a string");
    const char *s = lua_tolstring(L, at, &bytes);
    double n = (double)bytes;
    if (strlen(s) != bytes)
        raise_expected(L, entry, p, at, "a string without \\0");
    if (p->hi > 0 && (n < p->lo || n > p->hi)) {
        snprintf(form, sizeof form, "a string of %d to %d bytes", (int)p->lo, (int)p->hi);
        raise_expected(L, entry, p, at, form);
    }
}

static void check_thing(lua_State *L, const char *entry, const struct api_param *p, int at, struct api_value *v)
{
    unsigned mask = (unsigned)p->lo;

    v->i = v->is_integer ? v->bits : 0;
    if (handle_is_well_formed(v->i) && mask >> handle_kind(v->i) & 1)
        return;
    if (!strcmp(p->name, "self")) {
        const char *colon = strchr(entry, ':');
        const char *type = lua_pushlstring(L, entry, colon ? (size_t)(colon - entry) : strlen(entry));
        api_error(L, entry, "self: expected %s, got %s (call it with a colon)", type, api_push_description(L, at));
    }
    for (int k = 1; k < HANDLE_KINDS; k++)
        if (mask == 1u << k)
            raise_expected(L, entry, p, at, api_thing_names[k]);
    raise_expected(L, entry, p, at, mask & 1 << H_TASK ? "a thing, a task or a scope" : "a thing with a position");
}

static const char *const kind_nouns[] = { "bullet kind", "shot kind", "enemy kind", "player kind",
                                          "spark kind",  "item kind", "laser kind", "option kind" };
enum { KIND_NOUN_COUNT = sizeof kind_nouns / sizeof *kind_nouns };

/* Returns the noun ("bullet kind") of the sort of kind that is declared under that name, or NULL. */
static const char *find_kind_noun(lua_State *L, const char *name)
{
    for (int k = 0; k < KIND_NOUN_COUNT; k++)
        if (api_names_find(L, (enum name_kind)k, name) != NO_SLOT)
            return kind_nouns[k];
    return NULL;
}

/* Sets v->i to the index of a declared name; raises an error with the nearest one if it is unknown. */
static void check_name(lua_State *L, const char *entry, const struct api_param *p, int at, struct api_value *v,
                       enum name_kind kind, const char *noun)
{
    check_type(L, entry, p, at, LUA_TSTRING, "a name");
    v->i = api_names_find(L, kind, lua_tostring(L, at));
    if (v->i != NO_SLOT)
        return;
    const char *disabled_reason = api_names_disabled_reason(L, kind);
    if (disabled_reason)
        api_error(L, entry, "%s: " API_DISABLED_FORMAT, p->name, disabled_reason);
    const char *other_noun = (int)kind < KIND_NOUN_COUNT ? find_kind_noun(L, lua_tostring(L, at)) : NULL;
    if (other_noun)
        api_error(L, entry, "unknown %s \"%s\" (found %s \"%s\")", noun, lua_tostring(L, at), other_noun,
                  lua_tostring(L, at));
    struct api_hint hint;
    api_hint_begin(&hint, lua_tostring(L, at));
    for (uint32_t i = 0; i < vm_board(L)->names[kind].n; i++) {
        const char *known = board_name(vm_board(L), kind, (int)i);
        if (known) /* NULL: an extra row of another kind, such as a cloud or a picture */
            api_hint_add(&hint, known);
    }
    api_error(L, entry, "unknown %s \"%s\"%s", noun, lua_tostring(L, at), api_hint_push(L, &hint, "declared"));
}

/* The types that are names declared in rom.lua: the list in the ROM, and the words of error messages. */
static const struct cart_type {
    enum cart_folder folder;
    const char *noun, *form;
    bool is_listed; /* a message lists the declared names, which are few */
} cart_types[] = {
    [A_SPRITE] = { CART_SPRITES, "sprite", "a sprite name", false },
    [A_BLEND] = { CART_BLENDS, "blend", "a blend name", true },
    [A_FONT] = { CART_FACES, "font", "a font name", true },
    [A_MAP] = { CART_MAPS, "map", "a map name", true },
    [A_SOUND] = { CART_SOUNDS, "sound", "a sound name", false },
    [A_TUNE] = { CART_TUNES, "music", "a music name", false },
};

/* Sets v->i to the index of a name declared in rom.lua; except for sprites, to that index + 1. */
static void check_cart_name(lua_State *L, const char *entry, const struct api_param *p, int at, struct api_value *v)
{
    const struct cart *cart = &vm_board(L)->cart;
    const struct cart_type *type = &cart_types[p->type];
    struct api_hint hint;

    check_type(L, entry, p, at, LUA_TSTRING, type->form);
    const char *name = lua_tostring(L, at);
    const int found = cart_find(cart, type->folder, name);
    v->i = found + (p->type != A_SPRITE);
    if (found >= 0)
        return;
    const enum api_type other = p->type == A_SOUND ? A_TUNE : A_SOUND;
    if ((p->type == A_SOUND || p->type == A_TUNE) && cart_find(cart, cart_types[other].folder, name) >= 0)
        api_error(L, entry, "unknown %s \"%s\" (rom.lua declares it in `%s`)", type->noun, name,
                  other == A_TUNE ? "music" : "sounds");
    api_hint_begin(&hint, name);
    for (int i = 0; i < cart->count[type->folder]; i++)
        api_hint_add(&hint, cart_name(cart, type->folder, i));
    if (!type->is_listed && !hint.suggestion.nearest)
        api_error(L, entry, "unknown %s \"%s\" (declare it in rom.lua)", type->noun, name);
    api_error(L, entry, "unknown %s \"%s\"%s", type->noun, name, api_hint_push(L, &hint, "in rom.lua"));
}

const char *const api_layer_names[SPRITE_LAYER_COUNT] = { "back", "middle", "front", "over" };
static const char *const button_words[] = PAD_BUTTON_NAMES, *const ease_words[] = { "linear", "in", "out", "both" },
                         *const depth_words[] = { "back", "front" },
                         *const align_words[] = { "left", "center", "right" },
                         *const fire_words[FIRE_ENTRY_COUNT] = { "bullet", "shot", "bolt", "curve", "beam" },
                         *const meet_words[] = { "none", "first", "second", "both" },
                         *const emit_words[] = { "one", "ring", "fan", "arc", "stack", "line" },
                         *const bars_down_words[] = { "all", "any" },
                         *const host_screen_words[] = { "settings", "replays", "practice", "keys", "quit" };

/* Word lists, indexed by enum api_type. fire_words is indexed by FIRES_. */

static const struct word_list {
    const char *const *words;
    int n;
} word_lists[] = { [A_BUTTON] = { button_words, PAD_BUTTON_COUNT },
                   [A_EASE] = { ease_words, 4 },
                   [A_LAYER] = { api_layer_names, SPRITE_LAYER_COUNT },
                   [A_SPARK_LAYER] = { api_layer_names + LAYER_MIDDLE, 2 },
                   [A_DEPTH] = { depth_words, 2 },
                   [A_ALIGN] = { align_words, 3 },
                   [A_FIRE] = { fire_words, FIRE_ENTRY_COUNT },
                   [A_EMIT_FIRE] = { fire_words, FIRES_SHOTS + 1 },
                   [A_MEET] = { meet_words, 4 },
                   [A_EMIT_PATTERN] = { emit_words, EMIT_PATTERNS },
                   [A_BARS_DOWN] = { bars_down_words, 2 },
                   [A_HOST_SCREEN] = { host_screen_words, HOST_SCREENS } };

const char *const *api_get_type_words(enum api_type type, int *n)
{
    const bool is_listed = (size_t)type < sizeof word_lists / sizeof *word_lists && word_lists[type].n > 0;

    *n = is_listed ? word_lists[type].n : 0;
    return is_listed ? word_lists[type].words : NULL;
}

/* Sets v->i to the index of the word in the type's list. */
static void check_word(lua_State *L, const char *entry, const struct api_param *p, int at, struct api_value *v)
{
    const struct word_list *w = &word_lists[p->type];
    luaL_Buffer list;

    for (v->i = 0; v->i < w->n; v->i++)
        if (lua_type(L, at) == LUA_TSTRING && !strcmp(lua_tostring(L, at), w->words[v->i]))
            return;
    luaL_buffinit(L, &list);
    for (int i = 0; i < w->n; i++) {
        luaL_addstring(&list, i ? (i == w->n - 1 ? " or " : ", ") : "");
        luaL_addstring(&list, w->words[i]);
    }
    luaL_pushresult(&list);
    raise_expected(L, entry, p, at, lua_tostring(L, -1));
}

static void check_player(lua_State *L, const char *entry, const struct api_param *p, int at, struct api_value *v)
{
    v->i = v->is_integer ? v->bits : 0;
    if (handle_is_well_formed(v->i) && handle_kind(v->i) == H_PLAYER) {
        if (!handle_gen(v->i)) {
            v->i = 0;
            return;
        }
        v->i = handle_slot(v->i) + 1;
    }
    if (v->i < 1 || v->i > MAX_PLAYERS)
        raise_expected(L, entry, p, at, "1, 2 or a player");
}

static void check_motion(lua_State *L, const char *entry, const struct api_param *p, int at, struct api_value *v)
{
    int64_t h = v->is_integer ? v->bits : 0;

    if (handle_is_well_formed(h) && handle_kind(h) == H_MOTION) {
        v->i = handle_gen(h) ? handle_slot(h) + 1 : 0;
        if (v->i > vm_board(L)->motions.s.live)
            raise_expected(L, entry, p, at, "a motion from motion.def");
        return;
    }
    if (lua_type(L, at) != LUA_TSTRING)
        raise_expected(L, entry, p, at,
                       lua_istable(L, at) ? "a motion (motion.def { ... }) or a motion name"
                                          : "a motion or a motion name");
    check_name(L, entry, p, at, v, N_MOTION, "motion");
    v->i = v->i == NO_MOTION ? 0 : v->i + 1;
}

static void check_declared(lua_State *L, const char *entry, const struct api_param *p, int at, struct api_value *v)
{
    int k = (int)p->type - A_BULLET_KIND;

    check_name(L, entry, p, at, v, (enum name_kind)k, kind_nouns[k]);
}

/* Checks types that correspond to a Lua type. */
static void check_lua_type(lua_State *L, const char *entry, const struct api_param *p, int at, struct api_value *v)
{
    static const struct {
        int type;
        const char *form;
    } types[] = { [A_FUNC] = { LUA_TFUNCTION, "a function" },
                  [A_TABLE] = { LUA_TTABLE, "a table" },
                  [A_ROUTE] = { LUA_TTABLE, "a route (from path.def)" } };

    (void)v;
    check_type(L, entry, p, at, types[p->type].type, types[p->type].form);
}

static void check_bool(lua_State *L, const char *entry, const struct api_param *p, int at, struct api_value *v)
{
    check_type(L, entry, p, at, LUA_TBOOLEAN, "true or false");
    v->i = lua_toboolean(L, at);
}

static void check_any(lua_State *L, const char *entry, const struct api_param *p, int at, struct api_value *v)
{
    if (!v->given)
        raise_expected(L, entry, p, at, "a value");
}

/* Accepts a table or a string; api_read_hit_shape checks the contents. */
static void check_hit_shape(lua_State *L, const char *entry, const struct api_param *p, int at, struct api_value *v)
{
    (void)v;
    if (lua_type(L, at) != LUA_TTABLE && lua_type(L, at) != LUA_TSTRING)
        raise_expected(L, entry, p, at, api_hit_forms[(int)p->lo]);
}

typedef void check_function(lua_State *L, const char *entry, const struct api_param *p, int at, struct api_value *v);

/* The check of each type. A new type needs a row here, and in word_lists if it is a word list. */
static check_function *const checks[] = {
    [A_INT] = check_int,
    [A_COUNT] = check_int,
    [A_NUM] = check_number,
    [A_FX] = check_number,
    [A_DIR] = check_dir,
    [A_SCALE] = check_scale,
    [A_STR] = check_string,
    [A_BOOL] = check_bool,
    [A_FUNC] = check_lua_type,
    [A_TABLE] = check_lua_type,
    [A_ANY] = check_any,
    [A_SPAN] = check_span,
    [A_ROUTE] = check_lua_type,
    [A_THING] = check_thing,
    [A_HIT_SHAPE] = check_hit_shape,
    [A_MOTION] = check_motion,
    [A_BULLET_KIND] = check_declared,
    [A_SHOT_KIND] = check_declared,
    [A_ENEMY_KIND] = check_declared,
    [A_PLAYER_KIND] = check_declared,
    [A_SPARK_KIND] = check_declared,
    [A_ITEM_KIND] = check_declared,
    [A_LASER_KIND] = check_declared,
    [A_OPTION_KIND] = check_declared,
    [A_SPRITE] = check_cart_name,
    [A_BLEND] = check_cart_name,
    [A_FONT] = check_cart_name,
    [A_MAP] = check_cart_name,
    [A_SOUND] = check_cart_name,
    [A_TUNE] = check_cart_name,
    [A_BUTTON] = check_word,
    [A_PLAYER] = check_player,
    [A_EASE] = check_word,
    [A_LAYER] = check_word,
    [A_SPARK_LAYER] = check_word,
    [A_DEPTH] = check_word,
    [A_ALIGN] = check_word,
    [A_FIRE] = check_word,
    [A_EMIT_FIRE] = check_word,
    [A_MEET] = check_word,
    [A_EMIT_PATTERN] = check_word,
    [A_BARS_DOWN] = check_word,
    [A_HOST_SCREEN] = check_word,
};

void api_check_value(lua_State *L, const char *entry, const struct api_param *p, struct api_value *v)
{
    assert(p->type < sizeof checks / sizeof *checks && checks[p->type]);
    checks[p->type](L, entry, p, v->at, v);
}

void api_check(lua_State *L, const char *entry, const struct api_param *p, int at, struct api_value *v)
{
    api_read_value(L, at, at, v);
    if (v->given || !p->optional)
        api_check_value(L, entry, p, v);
}

static double parse_default(const struct api_param *p)
{
    const char *s = p->def;
    double n = 0;

    if (!s)
        return 0;
    while (*s >= '0' && *s <= '9') /* nearly all defaults; strtod takes several times as long */
        n = 10 * n + (*s++ - '0');
    return *s ? strtod(p->def, NULL) : n;
}

/* Sets v to the default, which is stored as text in Lua syntax. */
void api_fill_default(const struct api_param *p, struct api_value *v)
{
    if (!p->def || (p->def[0] == '0' && !p->def[1]) || (p->type == A_BOOL && p->def[0] == 'f'))
        return; /* most defaults: v is already 0 or false */
    v->n = parse_default(p);
    v->i = (int64_t)v->n;
    if (p->type == A_FX)
        fx_from_double(v->n, &v->f);
    else if (p->type == A_DIR)
        trig_from_degrees(v->n, &v->a);
    else if (p->type == A_SCALE)
        v->i *= SCALE_ONE;
    else if (p->type == A_BOOL)
        v->i = !strcmp(p->def, "true");
    else if ((size_t)p->type < sizeof word_lists / sizeof *word_lists && word_lists[p->type].n)
        while (strcmp(word_lists[p->type].words[v->i], p->def) != 0)
            v->i++;
    else if (p->type == A_COUNT && !strcmp(p->def, "forever"))
        v->i = LUA_MAXINTEGER;
}

int api_param_count(const struct api_entry *e, const struct api_entry *fired_entry)
{
    return e->count + (fired_entry ? fired_entry->count : 0);
}

const struct api_param *api_param_at(const struct api_entry *e, const struct api_entry *fired_entry, int i)
{
    return i < e->count ? &e->params[i] : &fired_entry->params[i - e->count];
}

/* If e is a pattern, returns the entry selected by the field `fire` of the table at `at`. An unknown word selects
 * bullet.fire here and is reported when the argument `fire` is checked. */
const struct api_entry *api_find_fired_entry(lua_State *L, const struct api_entry *e, int at)
{
    if (!(e->flags & API_PATTERN))
        return NULL;
    if (lua_type(L, at) != LUA_TTABLE)
        return api_get_table(L)->fire_entries[FIRES_BULLETS];
    lua_pushliteral(L, "fire");
    const char *word = lua_rawget(L, at) == LUA_TSTRING ? lua_tostring(L, -1) : "";
    int found = FIRES_BULLETS;
    for (int k = 0; k < FIRE_ENTRY_COUNT; k++)
        if (!strcmp(word, fire_words[k]))
            found = k;
    lua_pop(L, 1);
    const struct manifest *m = &vm_board(L)->cart.manifest;
    const char *disabled_reason = found < FIRES_BOLTS ? NULL : api_disabled_reason(m, "laser");
    if (!disabled_reason)
        disabled_reason = api_disabled_reason(m, api_get_table(L)->fire_entries[found]->name);
    if (disabled_reason)
        api_error(L, e->name, "fire: " API_DISABLED_FORMAT, disabled_reason);
    return api_get_table(L)->fire_entries[found];
}

/* Searches e's own parameters first, so they take precedence over parameters of `fired_entry` with the same name. */
int api_search_param(const struct api_entry *e, const struct api_entry *fired_entry, const char *name)
{
    int n = api_param_count(e, fired_entry);

    for (int i = e->positional_count; i < n; i++) {
        const char *p = api_param_at(e, fired_entry, i)->name;
        if (p[0] == name[0] && !strcmp(p, name))
            return i;
    }
    return -1;
}

bool api_is_step_key(lua_State *L, const char *name)
{
    return api_search_param(api_find_entry(api_get_table(L), "motion.def step"), NULL, name) >= 0;
}

/* Raises the error for the unknown key on top of the stack. */
static void raise_unknown_argument(lua_State *L, const struct api_entry *e, const struct api_entry *fired_entry)
{
    const struct board *b = vm_board(L);
    enum name_kind value_names = api_entry_value_names(fired_entry ? fired_entry : e);
    struct api_hint hint;

    if (lua_type(L, -1) != LUA_TSTRING)
        api_error(L, e->name, "expected named arguments ({ name = value }), got key %s", api_push_description(L, -1));
    const char *name = lua_tostring(L, -1);
    if (fired_entry == api_get_table(L)->fire_entries[FIRES_BULLETS] &&
        api_search_param(api_get_table(L)->fire_entries[FIRES_SHOTS], NULL, name) >= 0)
        api_error(L, e->name, "`%s` requires a shot (did you forget `fire = \"shot\"`?)", name);
    if (api_is_step_key(L, name) && api_search_param(e, fired_entry, "motion") >= 0)
        api_error(L, e->name,
                  "unknown argument \"%s\" (it is a step of a motion: motion = motion.def { { %s = ... } })", name,
                  name);
    api_hint_begin(&hint, name);
    for (int i = e->positional_count; i < api_param_count(e, fired_entry); i++)
        api_hint_add(&hint, api_param_at(e, fired_entry, i)->name);
    for (int k = 0; k < api_value_count(b, value_names); k++)
        api_hint_add(&hint, board_name(b, value_names, k));
    api_error(L, e->name, "unknown argument \"%s\"%s", name, api_hint_push(L, &hint, "arguments"));
}

/* The arguments that a call accepts: the parameters of e and fired_entry, and the declared values of list
 * `value_names`. */
struct accepted_arguments {
    const struct api_entry *e, *fired_entry;
    enum name_kind value_names;
};

/* Returns the index of the argument named `key`: parameters are counted first, then declared values; -1: unknown. */
static int find_argument(lua_State *L, const struct accepted_arguments *t, const char *key)
{
    const int i = key ? api_search_param(t->e, t->fired_entry, key) : -1;

    if (i >= 0 || !key || !api_value_count(vm_board(L), t->value_names))
        return i;
    const int k = api_names_find(L, t->value_names, key);
    return k == NO_SLOT ? -1 : api_param_count(t->e, t->fired_entry) + k;
}

static bool is_known_argument(lua_State *L, const char *key, const void *context)
{
    vm_charge(L, 1);
    return find_argument(L, context, key) >= 0;
}

/* Spreads the table of named arguments at `at` over the stack above it, one slot per parameter, and reads the
 * parameters into v. */
static void spread_arguments(lua_State *L, const struct api_entry *e, const struct api_entry *fired_entry, int at,
                             struct api_value *v)
{
    const struct accepted_arguments accepted = { e, fired_entry, api_entry_value_names(fired_entry ? fired_entry : e) };
    const int n = api_param_count(e, fired_entry), first = at + 1;
    bool has_unknown_key = false;

    lua_pushnil(L);
    while (lua_next(L, at)) {
        const int i = find_argument(L, &accepted, luakeys_text(L, -2));
        if (i >= 0 && i < n)
            api_read_value(L, first + i - e->positional_count, -1, &v[i]);
        has_unknown_key |= i < 0;
        if (i >= 0)
            lua_replace(L, first + i - e->positional_count);
        else
            lua_pop(L, 1);
    }
    if (has_unknown_key && luakeys_push_unknown(L, at, is_known_argument, &accepted))
        raise_unknown_argument(L, e, fired_entry);
}

/* Checks the declared values among the arguments, from stack index `at` on. */
static void check_values(lua_State *L, const struct api_entry *e, enum name_kind names, int at, struct api_value *v)
{
    for (int k = 0; k < api_value_count(vm_board(L), names); k++) {
        struct api_param p = api_value_param(board_name(vm_board(L), names, k));
        p.optional = OPT;
        v[k] = (struct api_value){ 0 };
        api_check(L, e->name, &p, at + k, &v[k]);
    }
}

/* Returns whether a task runs the library function directly: no game function is on the stack. */
static bool is_called_by_task(lua_State *L)
{
    lua_Debug ar;

    for (int level = 1; lua_getstack(L, level, &ar); level++) {
        lua_getinfo(L, "S", &ar);
        if (strncmp(ar.short_src, "@std/", 5) != 0)
            return false;
    }
    return true;
}

bool api_resolve_velocity(lua_State *L, const char *entry, struct api_velocity w)
{
    if (!w.vx->given && !w.vy->given)
        return false;
    if (w.speed->given || w.dir->given || w.aim->i)
        api_error(L, entry, "`%s` cannot be combined with `%s`", w.vx->given ? "vx" : "vy",
                  w.speed->given ? "speed"
                  : w.dir->given ? "dir"
                                 : "aim");
    w.speed->f = fx_min(fx_hypot(w.vx->f, w.vy->f), MAX_SPEED << 16);
    w.speed->n = fx_to_double(w.speed->f);
    if (w.speed->f) { /* at rest, it keeps the default direction */
        w.dir->a = trig_atan2(w.vy->f, w.vx->f);
        w.dir->n = trig_to_degrees(w.dir->a);
        w.dir->given = true;
    }
    w.speed->given = true;
    w.vx->given = w.vy->given = false;
    return true;
}

/* Replaces `vx` and `vy` by `speed` and `dir`, also in the arguments on the stack. */
static void resolve_fired_velocity(lua_State *L, const struct api_entry *e, const struct api_entry *fired_entry,
                                   struct api_value *v)
{
    static const char *const names[] = { "speed", "dir", "aim", "vx", "vy" };
    struct api_value *a[5];

    for (int i = 0; i < 5; i++)
        a[i] = &v[api_search_param(e, fired_entry, names[i])];
    api_resolve_velocity(L, e->name, (struct api_velocity){ a[0], a[1], a[2], a[3], a[4] });
    for (int i = 0; i < 2; i++)
        if (a[i]->given) {
            lua_pushnumber(L, a[i]->n);
            lua_replace(L, a[i]->at);
        }
}

enum {
    MAX_ARGS_WITHOUT_CHECKSTACK = LUA_MINSTACK - 17
}; /* arguments that leave enough free slots in a C function's guaranteed stack */

int api_read_arguments(lua_State *L, const struct api_entry *e, struct api_value *v,
                       const struct api_entry **fired_entry_out)
{
    const struct api_entry *fired_entry = *fired_entry_out = api_find_fired_entry(L, e, e->positional_count + 1);
    const enum name_kind names = api_entry_value_names(fired_entry ? fired_entry : e);
    int n = api_param_count(e, fired_entry), top = lua_gettop(L), n_values = api_value_count(vm_board(L), names);
    int n_named = n - e->positional_count;

    if (!(e->flags & API_VARARGS) && top > e->positional_count + (n_named > 0)) {
        const int n_self = (e->flags & API_METHOD) != 0, max = e->positional_count + (n_named > 0) - n_self,
                  got = top - n_self;
        if (n_named > 0 && e->positional_count == n_self && lua_type(L, n_self + 1) != LUA_TTABLE)
            api_error(L, e->name, "expected a table of named arguments (%s { ... }), got %d arguments", e->name, got);
        if (max == 0)
            api_error(L, e->name, "expected no arguments, got %d", got);
        api_error(L, e->name, "expected at most %d argument%s, got %d", max, max == 1 ? "" : "s", got);
    }
    if (n + n_values > MAX_ARGS_WITHOUT_CHECKSTACK)
        luaL_checkstack(L, n + 16, NULL);
    memset(v, 0, (size_t)n * sizeof *v);
    if (n_named > 0) {
        int at = e->positional_count + 1;
        lua_settop(L, at + n_named + n_values);
        if (lua_type(L, at) == LUA_TTABLE)
            spread_arguments(L, e, fired_entry, at, v);
        else if (!lua_isnil(L, at)) {
            const char *got = api_push_description(L, at);
            api_error(L, e->name, "expected a table of named arguments, got %s%s", got,
                      is_called_by_task(L)
                          ? " (a task passes its owner as the first argument: write `function(e) ... end`)"
                          : "");
        }
    } else if (top < e->positional_count)
        lua_settop(L, e->positional_count);
    bool is_lenient = false; /* set once `each` is given: its function need not use the arguments of `fire` */
    bool has_velocity = false;
    for (int i = n; i-- > e->positional_count && !has_velocity;)
        has_velocity = v[i].given && api_param_at(e, fired_entry, i)->optional == VXY;
    for (int i = 0; i < n; i++) {
        const struct api_param *p = api_param_at(e, fired_entry, i);
        if (i < e->positional_count)
            api_read_value(L, i + 1, i + 1, &v[i]);
        else
            v[i].at = i + 2;
        if (v[i].given && i < e->count && e->flags & API_PATTERN && !strcmp(p->name, "each"))
            is_lenient = true;
        const bool is_required = p->optional == REQ || (p->optional == UNLESS_VXY && !has_velocity);
        if (v[i].given || (is_required && !(is_lenient && i >= e->count)))
            api_check_value(L, e->name, p, &v[i]);
        else
            api_fill_default(p, &v[i]);
    }
    if (has_velocity)
        resolve_fired_velocity(L, e, fired_entry, v);
    check_values(L, e, names, n + 2, v + n);
    return n + n_values;
}
