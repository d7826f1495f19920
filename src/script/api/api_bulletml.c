/*
 * api_bulletml.c - bullet.ml: the BulletML documents of the ROM. bullet.ml is missing from a game with no capacity for
 * them (api_reserved.c).
 */
#include <string.h>
#include "../bulletml_run.h"
#include "../events_run.h"
#include "api_parts.h"

enum {
    P_NAME,
    P_KIND,
    P_POSITION,
    P_KINDS = P_POSITION + POSITION_PARAM_COUNT,
    P_RANK,
    P_SEED,
    P_SPEED,
    P_ANGLE,
    P_MIRROR,
    P_PARAMS,
    P_LOOP,
    P_STEER,
    P_BANK,
    P_TAG,
    P_ON_FIRE
};

static const char entry_name[] = "bullet.ml";

enum { MAX_UNIT_SPEED = 64 /* px per frame for speed 1 */ };

static const struct api_param params[] = {
    REQUIRED("name", A_STR, "name of the document; NAME runs bulletml/NAME.xml"),
    REQUIRED("kind", A_BULLET_KIND, "declared kind of its bullets"),
    POSITION_PARAMS,
    OPTIONAL("kinds", A_TABLE, "kinds for bullets with a label, { LABEL = kind }"),
    PARAM("rank", A_NUM, OPT, 0, 1, NULL, "0.5", "value of $rank in the document"),
    PARAM("seed", A_INT, OPT, 0, UINT32_MAX, NULL, "0",
          "seed of $rand; the same seed gives the same numbers; 0 draws a seed from the game's random numbers"),
    PARAM("speed", A_NUM, OPT, 0.01, MAX_UNIT_SPEED, "px/frame", "1",
          "pixels per frame for a speed of 1 in the document"),
    DEFAULT("angle", A_DIR, "0", "degrees to rotate the document's pattern, clockwise"),
    DEFAULT("mirror", A_BOOL, "false", "mirror the document's pattern left to right"),
    OPTIONAL("params", A_TABLE, "list of up to 9 numbers, the values of $1 to $9 in the actions that run first"),
    DEFAULT("loop", A_BOOL, "false", "restart the document when it ends"),
    DEFAULT("steer", A_BOOL, "false", "let the document move the enemy given as `from`"),
    BANK(OPT, NULL, "number added to the palette bank of its bullets; overrides their kind's"),
    LABEL("tag", OPT, "name of a group to put the bullets in"),
    OPTIONAL("on_fire", A_FUNC,
             "on_fire(b, label): called with each bullet and the label of its element; label may be nil"),
};

static uint16_t find_program(lua_State *L, const struct board *b, const char *name)
{
    const int i = cart_find(&b->cart, CART_BULLETML, name);
    struct api_hint hint;

    if (i >= 0)
        return (uint16_t)i;
    api_hint_begin(&hint, name);
    for (int k = 0; k < b->cart.count[CART_BULLETML]; k++)
        api_hint_add(&hint, cart_name(&b->cart, CART_BULLETML, k));
    api_error(L, entry_name, "name: no bulletml/%s.xml in the game%s", name, api_hint_push(L, &hint, "documents"));
    return 0;
}

static bool is_known_label(lua_State *L, const char *key, const void *context)
{
    const struct ml *ml = context;

    vm_charge(L, 1);
    for (uint32_t i = 0; key && i < ml->n_labels && i < ML_MAX_KINDS; i++)
        if (!strcmp(ml_label(ml, i), key))
            return true;
    return false;
}

/* Raises the error for the key on top of the stack, a label in `kinds` that cannot be used. */
static void raise_bad_label(lua_State *L, const struct ml *ml)
{
    const char *label = luakeys_text(L, -1);
    struct api_hint hint;

    if (!label)
        api_error(L, entry_name, "kinds: expected { label = kind }, got key %s", api_push_description(L, -1));
    api_hint_begin(&hint, label);
    for (uint32_t i = 0; i < ml->n_labels; i++) {
        api_hint_add(&hint, ml_label(ml, i));
        if (!strcmp(ml_label(ml, i), label))
            api_error(L, entry_name, "kinds: label \"%s\" is not one of the first %d labels of the document", label,
                      ML_MAX_KINDS);
    }
    api_error(L, entry_name, "kinds: unknown label \"%s\"%s", label, api_hint_push(L, &hint, "labels"));
}

/* Reads kinds = { label = kind } into out, indexed by label. */
static void read_kinds(lua_State *L, const struct ml *ml, int at, uint16_t out[ML_MAX_KINDS])
{
    static const struct api_param kind = REQUIRED("kinds", A_BULLET_KIND, NULL);
    struct api_value v = { 0 };

    if (luakeys_push_unknown(L, at, is_known_label, ml))
        raise_bad_label(L, ml);
    for (uint32_t i = 0; i < ml->n_labels && i < ML_MAX_KINDS; i++, lua_pop(L, 1)) {
        if (lua_getfield(L, at, ml_label(ml, i)) == LUA_TNIL)
            continue;
        api_check(L, entry_name, &kind, lua_gettop(L), &v);
        out[i] = (uint16_t)v.i;
    }
}

/* Reads params = { $1, $2, .. } into out; returns how many there are. */
static int read_params(lua_State *L, struct board *b, int at, int64_t out[ML_PARAMS])
{
    static const struct api_param param = PARAM("params", A_NUM, REQ, -1e9, 1e9, NULL, NULL, NULL);
    const lua_Unsigned n = lua_rawlen(L, at);
    struct api_value v = { 0 };

    if (n > ML_PARAMS)
        api_error(L, entry_name, "params: expected at most %d numbers, got %d", ML_PARAMS, (int)n);
    for (lua_pushnil(L); lua_next(L, at); lua_pop(L, 1))
        if (!lua_isinteger(L, -2) || lua_tointeger(L, -2) < 1 || lua_tointeger(L, -2) > (lua_Integer)n)
            api_error(L, entry_name, "params: expected a list of numbers");
    for (lua_Unsigned i = 0; i < n; i++, lua_pop(L, 1)) {
        lua_rawgeti(L, at, (lua_Integer)i + 1);
        api_fold_stack_value(L, b, -1);
        api_check(L, entry_name, &param, lua_gettop(L), &v);
        const int64_t whole = (int64_t)v.n; /* the whole part is converted separately: api_to_q32 requires |v| < 2^19 */
        out[i] = whole * ML_ONE + api_to_q32(v.n - (double)whole);
    }
    return (int)n;
}

/* Returns the seed given as argument or, if it is 0, a random seed other than 0. */
static uint32_t pick_seed(struct board *b, const struct api_value *v)
{
    return v->i ? (uint32_t)v->i : 1 + (uint32_t)board_random(b, UINT32_MAX);
}

static uint8_t make_root_flags(const struct api_value *v)
{
    return (uint8_t)((v[P_LOOP].i ? ROOT_LOOPS : 0) | (v[P_STEER].i ? ROOT_STEERS : 0) |
                     (v[P_MIRROR].i ? ROOT_MIRRORED : 0) | (v[P_ON_FIRE].given ? ROOT_HAS_HANDLER : 0) |
                     (v[P_BANK].given ? ROOT_HAS_BANK : 0));
}

static int start_document(lua_State *L, struct board *b, struct api_value *v)
{
    const struct api_value *from = &v[P_POSITION + POSITION_FROM];
    struct bulletml_start s = { .program = find_program(L, b, lua_tostring(L, v[P_NAME].at)),
                                .owner = b->tasks.current_owner,
                                .follow = from->given ? from->i : 0,
                                .dx = from->given ? v[P_POSITION + POSITION_DX].f : 0,
                                .dy = from->given ? v[P_POSITION + POSITION_DY].f : 0,
                                .kind = (uint16_t)v[P_KIND].i,
                                .flags = make_root_flags(v),
                                .rank = api_to_q32(v[P_RANK].n),
                                .speed_scale = api_to_q32(v[P_SPEED].n),
                                .angle = v[P_ANGLE].a };
    uint16_t kinds[ML_MAX_KINDS];
    int64_t param[ML_PARAMS];
    struct ml ml;

    for (int i = 0; i < ML_MAX_KINDS; i++)
        kinds[i] = s.kind;
    cart_bulletml(&b->cart, s.program, &ml);
    if (v[P_KINDS].given)
        read_kinds(L, &ml, v[P_KINDS].at, kinds);
    if (v[P_PARAMS].given)
        s.param_count = read_params(L, b, v[P_PARAMS].at, param);
    if (v[P_STEER].i && !(from->given && handle_kind(from->i) == H_ENEMY))
        api_error(L, entry_name, "steer: requires `from` (an enemy)");
    s.kinds = kinds;
    s.param = param;
    s.bank = v[P_BANK].given ? (uint8_t)v[P_BANK].i : 0;
    s.tag = api_read_tag(L, entry_name, &v[P_TAG]);
    int32_t i = NO_SLOT;
    if (api_read_position(L, b, entry_name, v + P_POSITION, &s.x, &s.y) && tasks_is_owner_alive(b, s.owner)) {
        s.seed = pick_seed(b, &v[P_SEED]);
        i = bulletml_begin(b, &s);
    }
    if (i != NO_SLOT && v[P_ON_FIRE].given) {
        lua_pushvalue(L, v[P_ON_FIRE].at);
        events_set_property(L, (uint16_t)i, "document's on_fire");
    }
    if (i != NO_SLOT)
        for (int k = 0; k < ML_MAX_KINDS; k++)
            script_update_digest(b, kinds[k]);
    lua_pushinteger(L, board_handle(b, H_BULLETML, i));
    return 1;
}

/* Returns { name =, labels = { .. } } for each document, in byte order of the names. */
static int list_documents(lua_State *L, struct board *b, struct api_value *v)
{
    struct ml ml;

    (void)v;
    lua_createtable(L, b->cart.count[CART_BULLETML], 0);
    for (int i = 0; i < b->cart.count[CART_BULLETML]; i++) {
        cart_bulletml(&b->cart, i, &ml);
        lua_createtable(L, 0, 2);
        api_set_string(L, "name", cart_name(&b->cart, CART_BULLETML, i));
        lua_createtable(L, (int)ml.n_labels, 0);
        for (uint32_t k = 0; k < ml.n_labels; k++) {
            lua_pushstring(L, ml_label(&ml, k));
            lua_rawseti(L, -2, (lua_Integer)k + 1);
        }
        lua_setfield(L, -2, "labels");
        lua_rawseti(L, -2, i + 1);
    }
    return 1;
}

enum { R_X, R_Y, R_RANK, R_NAME, PROPS };

static const struct api_param props[PROPS] = {
    COORDINATE(
        "x", A_FX, REQ,
        "horizontal position from which the document fires; if the document follows a thing (`from`), the thing's "
        "position",
        STORED(ml_roots.x), WRITABLE),
    COORDINATE("y", A_FX, REQ,
               "vertical position from which the document fires; if the document follows a thing (`from`), the thing's "
               "position",
               STORED(ml_roots.y), WRITABLE),
    PARAM("rank", A_NUM, REQ, 0, 1, NULL, NULL, "value of $rank in the document", SETTER),
    REQUIRED("name", A_STR, "name of the document"),
};

static void get_bulletml(lua_State *L, struct board *b, uint32_t i, int p)
{
    const struct ml_roots *o = &b->ml_roots;

    if (p == R_NAME)
        lua_pushstring(L, cart_name(&b->cart, CART_BULLETML, o->program[i]));
    else
        lua_pushnumber(L, (double)o->rank[i] / 4294967296.0);
}

static void set_rank(lua_State *L, struct board *b, uint32_t i, int p, const struct api_value *v)
{
    (void)L, (void)p;
    b->ml_roots.rank[i] = api_to_q32(v->n);
}

const struct api_thing api_bulletml_thing = { "bulletml", props, PROPS, .get = get_bulletml, .set = set_rank };

static const struct api_param self_params[] = { THING("self", REQ, 1 << H_BULLETML, "the thing itself") };

static int stop_document(lua_State *L, struct board *b, struct api_value *v)
{
    (void)L;
    bulletml_stop(b, handle_slot(v[0].i));
    return 0;
}

static const struct api_entry entries[] = {
    { "bullet.ml", start_document, PARAMS(params), 0, API_CHANGES, "bulletml",
      HELP("runs a BulletML document until the document or its owner ends; needs `board = { bulletml = n }`") },
    PARAM("bullet.documents", list_documents, NULL, 0, 0, 0, "list",
          "returns a list of the game's BulletML documents, { name = NAME, labels = { LABEL, .. } }, sorted by name"),
    API_EACH_VERB("bulletml:stop", stop_document, self_params, 1,
                  "stops the document; its bullets keep flying and finish their actions"),
};
const struct api_module api_bulletml = { entries, sizeof entries / sizeof *entries };
