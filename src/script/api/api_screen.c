/*
 * api_screen.c - the Lua tables sprite, spark, text, palette and screen.
 */
#include <string.h>
#include "../../base/bytes.h"
#include "../../../fb/fb.h"
#include "../../../fb/utf8.h"
#include "api.h"
#include "api_parts.h"

/* ---- sprite ---- */

enum {
    PUT_SPRITE,
    PUT_X,
    PUT_Y,
    PUT_BANK,
    PUT_LAYER,
    PUT_SCREEN,
    PUT_FLIP_X,
    PUT_FLIP_Y,
    PUT_HIDDEN,
    PUT_BLEND,
    PUT_STAY,
    PUT_FOLLOW,
    PUT_DX,
    PUT_DY,
    PUT_DIR,
    PUT_TURNS,
    PUT_SCALE,
    PUT_ALPHA
};

enum { FOLLOWABLE_HANDLE_KINDS = 1 << H_BULLET | 1 << H_SHOT | 1 << H_ENEMY | 1 << H_PLAYER | 1 << H_OPTION };

static const struct api_param put_params[] = {
    REQUIRED("sprite", A_SPRITE, "picture to show"),
    COORDINATE("x", A_FX, OPT, "horizontal position; give `x` and `y`, or `follow`"),
    COORDINATE("y", A_FX, OPT, "vertical position"),
    BANK(OPT, "0", "number added to the palette bank of the picture"),
    DEFAULT("layer", A_LAYER, "front",
            "drawing order; `over` is above everything that screen.dim darkens, and cannot be combined with `blend`"),
    DEFAULT("screen", A_BOOL, "false",
            "measure `x` and `y` from the top left of the screen instead of the field; not with `follow`"),
    DEFAULT("flip_x", A_BOOL, "false", "mirror the picture left to right"),
    DEFAULT("flip_y", A_BOOL, "false", "mirror the picture top to bottom"),
    DEFAULT("hidden", A_BOOL, "false", "create the sprite without drawing it"),
    OPTIONAL("blend", A_BLEND, "blend to draw it with, from `blends` in rom.lua; nil draws it opaque"),
    DEFAULT("stay", A_BOOL, "false", "keep the sprite when the boss phase that created it ends"),
    THING("follow", OPT, FOLLOWABLE_HANDLE_KINDS, "thing to follow; the sprite is removed together with it"),
    OFFSET("dx", A_FX, "distance to the right of the followed thing; needs `follow`"),
    OFFSET("dy", A_FX, "distance below the followed thing; needs `follow`"),
    DEFAULT("dir", A_DIR, "0",
            "direction to which the picture is turned; the picture needs `rotations` in rom.lua; needs `board = { "
            "transforms = true }`"),
    DEFAULT("turns", A_BOOL, "false",
            "turn the picture to the direction in which the sprite moves; needs `board = { transforms = true }`"),
    SCALE(OPT, "1", "factor on the size of the picture; needs `board = { transforms = true }`"),
    ALPHA(OPT, "8", "opacity; only 8 in layer `over`; needs `board = { transforms = true }`"),
};

#define OVER_BLEND_ERROR "sprites in layer \"over\" cannot blend"

/* Raises an error unless the position is given either by x and y or by follow, or if arguments cannot be combined. */
static void check_put(lua_State *L, const struct api_value *v)
{
    const bool has_xy = v[PUT_X].given && v[PUT_Y].given;

    if (v[PUT_FOLLOW].given ? v[PUT_X].given || v[PUT_Y].given : !has_xy)
        api_error(L, "sprite.put", "place: expected `x` and `y`, or `follow` (a thing), got %s",
                  v[PUT_FOLLOW].given                ? "both"
                  : v[PUT_X].given || v[PUT_Y].given ? "only one of `x` and `y`"
                                                     : "neither");
    if (!v[PUT_FOLLOW].given && (v[PUT_DX].given || v[PUT_DY].given))
        api_error(L, "sprite.put", "dx, dy: require `follow`");
    if (v[PUT_FOLLOW].given && v[PUT_SCREEN].i)
        api_error(L, "sprite.put", "`screen` cannot be combined with `follow`");
    if (v[PUT_BLEND].given && v[PUT_LAYER].i == LAYER_OVER)
        api_error(L, "sprite.put", "blend: " OVER_BLEND_ERROR);
    if (v[PUT_ALPHA].i != ALPHA_OPAQUE && v[PUT_LAYER].i == LAYER_OVER)
        api_error(L, "sprite.put", "alpha: " OVER_BLEND_ERROR);
    api_check_transforms(L, v, PUT_DIR, 4);
}

/* Sets how the picture of sprite i is drawn. Call it after the sprite's position is set. */
static void set_transform(struct board *b, uint32_t i, ang dir, int64_t scale, int64_t alpha)
{
    struct sprites *s = &b->sprites;

    if (!s->dir)
        return;
    s->dir[i] = dir;
    s->scale[i] = (uint8_t)scale;
    s->alpha[i] = (uint8_t)alpha;
    board_get_position(b, board_handle(b, H_SPRITE, (int32_t)i), &s->prev_x[i], &s->prev_y[i]);
    s->n_turning += alpha & SPRITE_TURNS ? 1 : 0;
}

/* Makes sprite i follow the given thing. A player outlives the scene that owns the sprite, so the sprite keeps its
 * owner; any other thing becomes the owner. */
static void set_follow(struct board *b, uint32_t i, const struct api_value *v)
{
    struct sprites *s = &b->sprites;
    int64_t h = v[PUT_FOLLOW].i;
    unsigned follow_mode = handle_kind(h) == H_PLAYER ? FOLLOW_PLAYER + handle_slot(h) : FOLLOW_OWNER;

    s->x[i] = v[PUT_DX].f;
    s->y[i] = v[PUT_DY].f;
    s->flags[i] |= (uint8_t)(follow_mode * SPRITE_FOLLOW_ONE);
    if (follow_mode == FOLLOW_OWNER)
        s->owner[i] = h;
    s->n_following++;
}

static int sprite_put(lua_State *L, struct board *b, struct api_value *v)
{
    struct sprites *s = &b->sprites;
    int64_t owner;

    check_put(L, v);
    bool can_spawn =
        tasks_get_spawn_owner(b, v[PUT_STAY].i, &owner) && (!v[PUT_FOLLOW].given || board_is_alive(b, v[PUT_FOLLOW].i));
    int32_t i = can_spawn ? board_take_slot(b, &s->s) : NO_SLOT;
    if (i != NO_SLOT) {
        s->sprite[i] = (uint16_t)v[PUT_SPRITE].i;
        s->x[i] = v[PUT_X].f;
        s->y[i] = v[PUT_Y].f;
        s->bank[i] = (uint8_t)v[PUT_BANK].i;
        s->layer[i] = (uint8_t)v[PUT_LAYER].i;
        s->flags[i] = (uint8_t)((v[PUT_SCREEN].i ? SPRITE_SCREEN : 0) | (v[PUT_FLIP_X].i ? SPRITE_FLIP_X : 0) |
                                (v[PUT_FLIP_Y].i ? SPRITE_FLIP_Y : 0) | (v[PUT_HIDDEN].i ? SPRITE_HIDDEN : 0) |
                                v[PUT_BLEND].i * SPRITE_BLEND_ONE);
        s->born[i] = b->core.clock;
        s->owner[i] = owner;
        if (v[PUT_FOLLOW].given)
            set_follow(b, (uint32_t)i, v);
        set_transform(b, (uint32_t)i, v[PUT_DIR].a, v[PUT_SCALE].i,
                      v[PUT_ALPHA].i | (v[PUT_TURNS].i ? SPRITE_TURNS : 0));
    }
    lua_pushinteger(L, board_handle(b, H_SPRITE, i));
    return 1;
}

enum { PLATE_X, PLATE_Y, PLATE_W, PLATE_H, PLATE_BANK, PLATE_HIDDEN, PLATE_FRONT, PLATE_STAY };

static const struct api_param plate_params[] = {
    COORDINATE("x", A_FX, REQ, "left edge on the screen"),
    COORDINATE("y", A_FX, REQ, "top edge on the screen"),
    PARAM("w", A_INT, REQ, 8, FB_MAX_SIDE, "px", NULL, "width"),
    PARAM("h", A_INT, REQ, 8, FB_MAX_SIDE, "px", NULL, "height"),
    BANK(OPT, "0", "palette bank; the plate is drawn in its colours 1 and 10"),
    DEFAULT("hidden", A_BOOL, "false", "create the sprite without drawing it"),
    DEFAULT("front", A_BOOL, "false", "draw the plate above sprites in layer `over`, too"),
    DEFAULT("stay", A_BOOL, "false", "keep the sprite when the boss phase that created it ends"),
};

static bool is_plate(const struct sprites *s, uint32_t i)
{
    return s->layer[i] >= LAYER_PLATE;
}

static int sprite_plate(lua_State *L, struct board *b, struct api_value *v)
{
    struct sprites *s = &b->sprites;
    int64_t owner;
    bool can_spawn = tasks_get_spawn_owner(b, v[PLATE_STAY].i, &owner);
    int32_t i = can_spawn ? board_take_slot(b, &s->s) : NO_SLOT;
    if (i != NO_SLOT) {
        s->sprite[i] = (uint16_t)v[PLATE_W].i;
        s->x[i] = v[PLATE_X].f;
        s->y[i] = v[PLATE_Y].f;
        s->bank[i] = (uint8_t)v[PLATE_BANK].i;
        s->layer[i] = v[PLATE_FRONT].i ? LAYER_PLATE_FRONT : LAYER_PLATE;
        s->flags[i] = (uint8_t)(SPRITE_SCREEN | (v[PLATE_HIDDEN].i ? SPRITE_HIDDEN : 0));
        s->born[i] = (uint32_t)v[PLATE_H].i;
        s->owner[i] = owner;
        set_transform(b, (uint32_t)i, 0, SCALE_ONE, ALPHA_OPAQUE);
    }
    lua_pushinteger(L, board_handle(b, H_SPRITE, i));
    return 1;
}

enum {
    P_X,
    P_Y,
    P_SPRITE,
    P_BANK,
    P_FLIP_X,
    P_FLIP_Y,
    P_HIDDEN,
    P_BLEND,
    P_DX,
    P_DY,
    P_W,
    P_H,
    P_LAYER,
    P_DIR,
    P_SCALE,
    P_ALPHA,
    PROPS
};

static const struct api_param props[PROPS] = {
    COORDINATE("x", A_FX, REQ, "horizontal position; read-only while the sprite follows a thing", SETTER),
    COORDINATE("y", A_FX, REQ, "vertical position; read-only while the sprite follows a thing", SETTER),
    REQUIRED("sprite", A_SPRITE,
             "name of the picture; writing a different name restarts the animation; nil for a plate", SETTER),
    BANK(REQ, NULL, "number added to the palette bank of the picture", STORED(sprites.bank), WRITABLE),
    REQUIRED("flip_x", A_BOOL, "true if mirrored left to right", BITS_OF(sprites.flags, SPRITE_FLIP_X), SETTER),
    REQUIRED("flip_y", A_BOOL, "true if mirrored top to bottom", BITS_OF(sprites.flags, SPRITE_FLIP_Y), SETTER),
    REQUIRED("hidden", A_BOOL, "true if not drawn", BITS_OF(sprites.flags, SPRITE_HIDDEN), WRITABLE),
    OPTIONAL("blend", A_BLEND, "blend it is drawn with, or nil", BITS_OF(sprites.flags, SPRITE_BLEND), SETTER),
    COORDINATE("dx", A_FX, REQ, "distance to the right of the followed thing; nil if the sprite follows nothing",
               SETTER),
    COORDINATE("dy", A_FX, REQ, "distance below the followed thing; nil if the sprite follows nothing", SETTER),
    PARAM("w", A_INT, REQ, 8, FB_MAX_SIDE, "px", NULL, "width of a plate; nil for other sprites", SETTER),
    PARAM("h", A_INT, REQ, 8, FB_MAX_SIDE, "px", NULL, "height of a plate; nil for other sprites", SETTER),
    REQUIRED("layer", A_LAYER, "drawing order; nil for a plate", SETTER),
    REQUIRED("dir", A_DIR, "direction to which the picture is turned, 0 to 360", STORED(sprites.dir), SETTER),
    SCALE(REQ, NULL, "factor on the size of the picture", STORED(sprites.scale), SETTER),
    ALPHA(REQ, NULL, "opacity; only 8 in layer `over`", BITS_OF(sprites.alpha, SPRITE_ALPHA), SETTER),
};

static void get_sprite(lua_State *L, struct board *b, uint32_t i, int p)
{
    const struct sprites *s = &b->sprites;
    fx x, y;

    switch (p) { /* a NULL string is pushed as nil */
    case P_X:
    case P_Y:
        board_get_position(b, board_handle(b, H_SPRITE, (int32_t)i), &x, &y);
        lua_pushnumber(L, fx_to_double(p == P_X ? x : y));
        break;
    case P_DX:
    case P_DY:
        if (s->flags[i] & SPRITE_FOLLOW)
            lua_pushnumber(L, fx_to_double(p == P_DX ? s->x[i] : s->y[i]));
        else
            lua_pushnil(L);
        break;
    case P_SPRITE:
        lua_pushstring(L, is_plate(s, i) ? NULL : cart_name(&b->cart, CART_SPRITES, s->sprite[i]));
        break;
    case P_W:
    case P_H:
        if (is_plate(s, i))
            lua_pushinteger(L, p == P_W ? s->sprite[i] : (lua_Integer)s->born[i]);
        else
            lua_pushnil(L);
        break;
    default: /* P_LAYER */
        lua_pushstring(L, is_plate(s, i) ? NULL : api_layer_names[s->layer[i]]);
    }
}

static bool is_blended(const struct sprites *s, uint32_t i)
{
    return s->flags[i] & SPRITE_BLEND || (s->alpha && (s->alpha[i] & SPRITE_ALPHA) != ALPHA_OPAQUE);
}

/* Raises an error if property p cannot be set on sprite i. */
static void check_property_write(lua_State *L, const struct sprites *s, uint32_t i, int p, const struct api_value *v)
{
    const bool drawn_as_plate = is_plate(s, i);

    if (s->flags[i] & SPRITE_FOLLOW ? p == P_X || p == P_Y : p == P_DX || p == P_DY)
        api_error(L, "sprite",
                  s->flags[i] & SPRITE_FOLLOW ? "%s: the sprite follows a thing; set `dx` and `dy` instead"
                                              : "%s: the sprite follows nothing; set `x` and `y` instead",
                  props[p].name);
    if (!drawn_as_plate && (p == P_W || p == P_H))
        api_error(L, "sprite", "%s: can only be written on a plate; a sprite's size comes from rom.lua", props[p].name);
    if (drawn_as_plate &&
        (p == P_LAYER || p == P_SPRITE || p == P_FLIP_X || p == P_FLIP_Y || p == P_BLEND || p >= P_DIR))
        api_error(L, "sprite", "%s: a plate has no picture", props[p].name);
    if ((p == P_BLEND && v->i && s->layer[i] == LAYER_OVER) ||
        (p == P_ALPHA && v->i != ALPHA_OPAQUE && s->layer[i] == LAYER_OVER) ||
        (p == P_LAYER && v->i == LAYER_OVER && is_blended(s, i)))
        api_error(L, "sprite", "%s: " OVER_BLEND_ERROR, props[p].name);
}

static void set_sprite(lua_State *L, struct board *b, uint32_t i, int p, const struct api_value *v)
{
    struct sprites *s = &b->sprites;

    check_property_write(L, s, i, p, v);
    switch (p) {
    case P_W:
        s->sprite[i] = (uint16_t)v->i;
        break;
    case P_H:
        s->born[i] = (uint32_t)v->i;
        break;
    case P_LAYER:
        s->layer[i] = (uint8_t)v->i;
        break;
    case P_X:
    case P_DX:
        s->x[i] = v->f;
        break;
    case P_Y:
    case P_DY:
        s->y[i] = v->f;
        break;
    case P_SPRITE:
        if (s->sprite[i] != v->i)
            s->born[i] = b->core.clock;
        s->sprite[i] = (uint16_t)v->i;
        break;
    default:
        api_store_value(L, b, &props[p], i, v);
    }
}

const struct api_thing api_sprite_thing = {
    "sprite", props, PROPS, .get = get_sprite, .set = set_sprite, .slots_offset = offsetof(struct board, sprites.s)
};

enum { ARG_SELF };

static const struct api_param self_params[] = { THING("self", REQ, 1 << H_SPRITE, "") };

static int sprite_remove(lua_State *L, struct board *b, struct api_value *v)
{
    (void)L;
    slots_drop(&b->sprites.s, handle_slot(v[ARG_SELF].i));
    slots_trim(&b->sprites.s);
    return 0;
}

/* ---- spark ---- */

enum { D_NAME, D_SPRITE, D_BANK = 5, D_BANKS = 7, D_LAYER };

static const struct api_param spark_def_params[] = {
    REQUIRED("name", A_STR, "name of the kind, used as `kind = NAME`"),
    OPTIONAL("sprite", A_SPRITE, "picture to show; nil shows a dot of 3 px in the brightest shade of its bank"),
    PARAM("life", A_INT, REQ, 1, 65535, "frames", NULL, "frames until a spark disappears",
          STORED(spark_kinds.lifetime)),
    PARAM("gravity", A_FX, OPT, -MAX_SPEED, MAX_SPEED, "px/frame per frame", "0", "downward acceleration",
          STORED(spark_kinds.gravity)),
    PARAM("drag", A_FX, OPT, 0, 1, "per frame", "0", "fraction of its speed that a spark loses each frame",
          STORED(spark_kinds.drag)),
    [D_BANK] = BANK(OPT, "0", "number added to the palette bank of the picture; give `bank` or `banks`",
                    BITS_OF(spark_kinds.bank, SPARK_BANK)),
    BLEND_PARAM(spark_kinds.bank, SPARK_BLEND),
    [D_BANKS] = OPTIONAL("banks", A_TABLE,
                         "list of up to eight banks that a spark goes through, each for an equal part of its life"),
    DEFAULT("layer", A_SPARK_LAYER, "front",
            "`middle` draws the sparks below players and bullets; `front` draws them above"),
};

static const char no_free_kind[] =
    "no free kind: `board.sparks` in rom.lua is 0, or all %d kinds are declared (each bank "
    "after the first counts as one)";

/* Reads the list `banks`: the first element is the kind's own bank, each further one adds a row. */
static void define_banks(lua_State *L, struct spark_kinds *k, int32_t i, int at)
{
    const struct api_param bank = PARAM("banks", A_INT, REQ, 0, 15, NULL, NULL, NULL);
    lua_Unsigned n = lua_rawlen(L, at);

    if (n < 1 || n > SPARK_MAX_BANKS)
        api_error(L, "spark.def", "banks: expected a list of 1 to %d banks", SPARK_MAX_BANKS);
    for (lua_Unsigned b = 0; b < n; b++) {
        struct api_value v = { 0 };
        int32_t row = b ? slots_append(&k->s) : i;
        if (row == NO_SLOT)
            api_error(L, "spark.def", no_free_kind, MAX_KINDS);
        lua_rawgeti(L, at, (lua_Integer)b + 1);
        api_check(L, "spark.def", &bank, lua_gettop(L), &v);
        lua_pop(L, 1);
        k->sprite[row] = k->sprite[i];
        k->bank[row] = (uint8_t)((k->bank[i] & ~SPARK_BANK) | v.i);
    }
}

static int spark_define(lua_State *L, struct board *b, struct api_value *v)
{
    struct spark_kinds *k = &b->spark_kinds;

    vm_reserve(L, &k->s, MAX_KIND_ROWS);
    int32_t i = slots_append(&k->s);
    if (i == NO_SLOT)
        return api_error(L, "spark.def", no_free_kind, MAX_KINDS);
    if (v[D_BANKS].given && v[D_BANK].given)
        return api_error(L, "spark.def", "expected either `bank` or `banks`, got both");
    api_names_declare(L, N_SPARK, "spark.def", lua_tostring(L, v[D_NAME].at), i);
    api_store_arguments(L, b, i, v);
    k->sprite[i] = v[D_SPRITE].given ? (uint16_t)v[D_SPRITE].i : SPARK_DOT;
    if (LAYER_MIDDLE + v[D_LAYER].i == LAYER_MIDDLE)
        k->bank[i] |= SPARK_UNDER_PLAYERS;
    if (v[D_BANKS].given)
        define_banks(L, k, i, v[D_BANKS].at);
    return 0;
}

enum { SPARK_WORK = 6 /* work per spark */ };
enum { B_KIND, B_POSITION, B_N = B_POSITION + 5, B_DIR, B_SPREAD, B_SPEED, B_RADIUS, B_TO_X, B_TO_Y };

static const struct api_param burst_params[] = {
    REQUIRED("kind", A_SPARK_KIND, "declared kind to create"),
    POSITION_PARAMS,
    PARAM("n", A_INT, OPT, 0, 65535, "sparks", "1", "number of sparks to create"),
    DEFAULT("dir", A_DIR, "0",
            "middle of the range of directions; with `radius`, an angle added to the outward direction"),
    PARAM("spread", A_NUM, OPT, 0, 360, "degrees", "360",
          "width of the range of directions; with `radius`, the default is 0"),
    PARAM("speed", A_FX, OPT, 0, MAX_SPEED, "px/frame", "1", "highest speed; each spark gets at least half of it"),
    LENGTH("radius", OPT, NULL, "radius of a ring from which the sparks fly outwards, evenly spaced; not with `to_x`"),
    COORDINATE(
        "to_x", A_FX, OPT,
        "x of the end of a line that starts at the position; the sparks start evenly spaced along it; needs `to_y`"),
    COORDINATE("to_y", A_FX, OPT, "y of the end of the line; needs `to_x`"),
};

static int spark_burst(lua_State *L, struct board *b, struct api_value *v)
{
    struct spark_burst s = { .kind = (uint16_t)v[B_KIND].i,
                             .n = (uint32_t)v[B_N].i,
                             .dir = v[B_DIR].a,
                             .speed = v[B_SPEED].f,
                             .spread = (ang)(v[B_SPREAD].n / 360 * 4294967295.0),
                             .radius = v[B_RADIUS].f };

    if (v[B_TO_X].given != v[B_TO_Y].given || (v[B_TO_X].given && v[B_RADIUS].given))
        return api_error(L, "spark.burst", "shape: expected `radius`, or `to_x` and `to_y`, or neither");
    if (s.radius && !v[B_SPREAD].given)
        s.spread = 0;
    if (!api_read_position(L, b, "spark.burst", v + B_POSITION, &s.x, &s.y))
        return 0;
    if (v[B_TO_X].given) {
        s.line_dx = v[B_TO_X].f - s.x;
        s.line_dy = v[B_TO_Y].f - s.y;
    }
    vm_charge(L, SPARK_WORK * (uint64_t)s.n);
    board_burst_sparks(b, &s);
    return 0;
}

/* ---- text ---- */

enum { TEXT_COL, TEXT_ROW, TEXT_TEXT, TEXT_BANK, TEXT_ALIGN, TEXT_FONT, TEXT_RIM, TEXT_SIZE, TEXT_FULL_WIDTH };

static const struct api_param text_put_params[] = {
    PARAM("col", A_FX, REQ, -1000, 1000, "cells", NULL, "column, from 0 at the left; a fraction moves the text by px"),
    PARAM("row", A_FX, REQ, -1000, 1000, "cells", NULL, "row, from 0 at the top; 1.25 is 10 px from the top"),
    REQUIRED("text", A_ANY, "string or number to write"),
    BANK(OPT, "0", "number added to the palette bank of the font"),
    DEFAULT("align", A_ALIGN, "left", "put the start, the middle or the end of the text at `col`"),
    OPTIONAL("font", A_FONT, "font from rom.lua; defaults to the font of the cells; needs `board = { wide = true }`"),
    DEFAULT("rim", A_BOOL, "false", "outline the letters in the darkest colour of the bank"),
    PARAM("size", A_INT, OPT, 1, FIX_MAX_SIZE, NULL, "1",
          "size of the letters; at 2, each letter is two cells wide and two cells high"),
    DEFAULT("full_width", A_BOOL, "false",
            "write full-width letters of size 1, such as Japanese ones, `screen.full_width` px wide (rom.lua)"),
};

enum { CLEAR_COL, CLEAR_ROW, CLEAR_W, CLEAR_H };

static const struct api_param text_clear_params[] = {
    PARAM("col", A_FX, OPT, -1000, 1000, "cells", "0", "leftmost column; a fraction is ignored"),
    PARAM("row", A_FX, OPT, -1000, 1000, "cells", "0", "top row; a fraction is ignored"),
    PARAM("w", A_INT, OPT, 0, 1000, "cells", "1000", "width"),
    PARAM("h", A_INT, OPT, 0, 1000, "cells", "1000", "height"),
};

static int text_put(lua_State *L, struct board *b, struct api_value *v)
{
    size_t n;
    int x = fx_floor(v[TEXT_COL].f * FIX_CELL_SIZE);

    if (v[TEXT_FONT].given && !b->cart.manifest.has_wide_text)
        return api_error(L, "text.put",
                         "font: fonts in text cells are disabled; add `wide = true` to `board` in rom.lua");
    const char *s = api_check_text(L, "text.put", v[TEXT_TEXT].at, &n);
    const int size = (int)v[TEXT_SIZE].i;
    const int full_width = v[TEXT_FULL_WIDTH].i && size == 1 ? b->cart.manifest.full_width : FIX_CELL_SIZE;
    utf8_count(s, n, FIX_MAX_TEXT, &n);
    const int width = (int)fix_text_width(s, n, full_width) * size;
    const int half = full_width > FIX_CELL_SIZE ? width / 2 : width / FIX_CELL_SIZE / 2 * FIX_CELL_SIZE;
    x -= v[TEXT_ALIGN].i == ALIGN_CENTER ? half : v[TEXT_ALIGN].i == ALIGN_RIGHT ? width : 0;
    fix_write(&b->fix, x, fx_floor(v[TEXT_ROW].f * FIX_CELL_SIZE), s, n, size, full_width,
              (unsigned)v[TEXT_BANK].i | (v[TEXT_RIM].i ? FIX_RIM : 0u), (uint8_t)v[TEXT_FONT].i);
    return 0;
}

static int text_clear(lua_State *L, struct board *b, struct api_value *v)
{
    (void)L;
    fix_clear(&b->fix, fx_floor(v[CLEAR_COL].f), fx_floor(v[CLEAR_ROW].f), (int)v[CLEAR_W].i, (int)v[CLEAR_H].i);
    return 0;
}

static const struct api_param text_lang_params[] = { REQUIRED("text", A_STR,
                                                              "text in the language the game is written in") };

static int translate_text(lua_State *L, struct board *b, struct api_value *v)
{
    size_t n;
    const char *text = lua_tolstring(L, v[0].at, &n), *translation = words_find(&b->words, text, n);

    if (translation)
        lua_pushstring(L, translation);
    else
        lua_pushvalue(L, v[0].at);
    return 1;
}

/* ---- palette ---- */

enum { SET_INDEX, SET_RGB };

static const struct api_param set_params[] = {
    PARAM("i", A_INT, REQ, 0, 255, NULL, NULL, "palette entry; bank n starts at 16 * n, and entry 0 is the background"),
    PARAM("rgb", A_INT, REQ, 0, 0xffffff, NULL, NULL, "colour as 0xRRGGBB")
};

enum { ARG_NAME };

static const struct api_param load_params[] = { REQUIRED(
    "name", A_STR, "palette from rom.lua; the game starts with the palette `main`") };

enum { FADE_TARGET, FADE_OVER, FADE_FIRST, FADE_LAST };

static const struct api_param fade_params[] = {
    PARAM("to", A_ANY, REQ, 0, 0, "colour 0xRRGGBB, or a palette", NULL,
          "colour to fade to, or the name of a palette from rom.lua; the game starts with the palette `main`"),
    PARAM("over", A_INT, REQ, 0, 65535, "frames", NULL, "frames the fade takes"),
    PARAM("first", A_INT, OPT, 0, 255, NULL, "0", "first palette entry to fade"),
    PARAM("last", A_INT, OPT, 0, 255, NULL, "255", "last palette entry to fade"),
};

enum { CYCLE_FIRST, CYCLE_LAST, CYCLE_EVERY };

static const struct api_param cycle_params[] = {
    PARAM("first", A_INT, REQ, 0, 255, NULL, NULL, "first palette entry of the range"),
    PARAM("last", A_INT, REQ, 0, 255, NULL, NULL, "last palette entry of the range"),
    PARAM("every", A_INT, REQ, 0, 65535, "frames", NULL, "frames from one step to the next; 0 stops the cycle"),
};

static int palette_set(lua_State *L, struct board *b, struct api_value *v)
{
    (void)L;
    pal_set(&b->pal, (int)v[SET_INDEX].i, (uint32_t)v[SET_RGB].i);
    return 0;
}

static const uint8_t *find_palette(lua_State *L, struct board *b, const char *entry, int at)
{
    const uint8_t *p = cart_palette(&b->cart, lua_tostring(L, at));

    if (p)
        return p;
    struct api_hint hint;
    api_hint_begin(&hint, lua_tostring(L, at));
    for (int i = 0; i < b->cart.count[CART_PALETTES]; i++)
        api_hint_add(&hint, cart_name(&b->cart, CART_PALETTES, i));
    api_error(L, entry, "unknown palette \"%s\"%s", hint.suggestion.word, api_hint_push(L, &hint, "in rom.lua"));
    return NULL;
}

static uint32_t read_colour(const uint8_t *p, int i)
{
    return (uint32_t)p[3 * i] << 16 | (uint32_t)p[3 * i + 1] << 8 | p[3 * i + 2];
}

/* Returns the loaded palette if the cart has looks, otherwise 0. */
static int get_loaded_palette(const struct board *b)
{
    return b->cart.has_palette_tables ? board_loaded_palette(b) : 0;
}

static int palette_load(lua_State *L, struct board *b, struct api_value *v)
{
    const uint8_t *p = find_palette(L, b, "palette.load", v[ARG_NAME].at);
    const int old_palette = get_loaded_palette(b);

    for (int i = 0; i < COLOURS; i++)
        pal_set(&b->pal, i, read_colour(p, i));
    api_bg_rebuild_shades(L, b, get_loaded_palette(b) != old_palette);
    return 0;
}

static int palette_fade(lua_State *L, struct board *b, struct api_value *v)
{
    struct api_param number_param = PARAM("to", A_INT, REQ, 0, 0xffffff, NULL, NULL, NULL);
    struct api_value target = { 0 };
    const uint8_t *p = NULL;
    const int old_palette = get_loaded_palette(b);

    if (lua_type(L, v[FADE_TARGET].at) == LUA_TSTRING)
        p = find_palette(L, b, "palette.fade", v[FADE_TARGET].at);
    else
        api_check(L, "palette.fade", &number_param, v[FADE_TARGET].at, &target);
    for (int i = (int)v[FADE_FIRST].i; i <= (int)v[FADE_LAST].i; i++)
        pal_fade(&b->pal, i, p ? read_colour(p, i) : (uint32_t)target.i, (uint16_t)v[FADE_OVER].i);
    if (p)
        api_bg_rebuild_shades(L, b, get_loaded_palette(b) != old_palette);
    return 0;
}

static int palette_cycle(lua_State *L, struct board *b, struct api_value *v)
{
    if (v[CYCLE_FIRST].i > v[CYCLE_LAST].i)
        return api_error(L, "palette.cycle", "first %d is greater than last %d", (int)v[CYCLE_FIRST].i,
                         (int)v[CYCLE_LAST].i);
    if (!pal_cycle(&b->pal, (uint8_t)v[CYCLE_FIRST].i, (uint8_t)v[CYCLE_LAST].i, (uint16_t)v[CYCLE_EVERY].i))
        return api_error(L, "palette.cycle", "all %d cycles are running (`every = 0` stops one)", CYCLES);
    return 0;
}

/* ---- screen ---- */

enum { SHAKE_SIZE, SHAKE_OVER, SHAKE_DIR };

static const struct api_param shake_params[] = {
    PARAM("size", A_INT, REQ, 0, MAX_SHAKE, "px", NULL,
          "distance the picture moves at first; the distance shrinks to 0"),
    PARAM("over", A_INT, REQ, 1, MAX_EFFECT_FRAMES, "frames", NULL, "duration of the shake"),
    OPTIONAL("dir", A_DIR, "direction of the axis to shake along; all directions if omitted"),
};

enum { FLASH_COLOUR, FLASH_OVER, FLASH_SHARE };

static const struct api_param flash_params[] = {
    PARAM("to", A_INT, OPT, 0, 0xffffff, NULL, "0xffffff", "colour as 0xRRGGBB"),
    PARAM("over", A_INT, REQ, 1, MAX_EFFECT_FRAMES, "frames", NULL, "frames the tint takes to fade out"),
    PARAM("share", A_FX, OPT, 0, 1, NULL, "1", "initial strength; 1 is the pure colour"),
};

enum { BARS_H, BARS_OVER };

static const struct api_param bars_params[] = {
    PARAM("h", A_INT, REQ, 0, MAX_BAR_HEIGHT, "px", NULL, "height of each bar; 0 removes them"),
    PARAM("over", A_INT, OPT, 0, MAX_EFFECT_FRAMES, "frames", "20", "frames the change takes"),
};

enum { DIM_SHARE, DIM_OVER };

static const struct api_param dim_params[] = {
    PARAM("share", A_FX, OPT, 0, 1, NULL, "0.5", "darkness: 0 is none, 1 is black"),
    PARAM("over", A_INT, OPT, 0, MAX_EFFECT_FRAMES, "frames", "0", "frames the change takes"),
};

static int shake_screen(lua_State *L, struct board *b, struct api_value *v)
{
    struct screen *s = &b->screen;

    (void)L;
    s->shake = (int32_t)v[SHAKE_SIZE].i;
    s->shake_frames = (uint32_t)v[SHAKE_OVER].i;
    s->shake_start = b->core.clock;
    s->shake_dir = v[SHAKE_DIR].a;
    s->shake_aimed = v[SHAKE_DIR].given;
    return 0;
}

static int flash_screen(lua_State *L, struct board *b, struct api_value *v)
{
    struct screen *s = &b->screen;

    (void)L;
    s->flash_colour = (uint32_t)v[FLASH_COLOUR].i;
    s->flash_share = v[FLASH_SHARE].f;
    s->flash_frames = (uint32_t)v[FLASH_OVER].i;
    s->flash_start = b->core.clock;
    return 0;
}

static int screen_letterbox(lua_State *L, struct board *b, struct api_value *v)
{
    (void)L;
    screen_move_bars(&b->screen, b->core.clock, (int32_t)v[BARS_H].i, (uint32_t)v[BARS_OVER].i);
    return 0;
}

static int dim_screen(lua_State *L, struct board *b, struct api_value *v)
{
    lua_pushnumber(L, fx_to_double(b->screen.dim));
    screen_set_dim(&b->screen, b->core.frame, v[DIM_SHARE].f, (uint32_t)v[DIM_OVER].i);
    return 1;
}

static const struct api_entry entries[] = {
    { "sprite.put", sprite_put, PARAMS(put_params), 0, API_CHANGES, "sprite",
      HELP("places a sprite in the field or on the screen, or attaches it to a thing") },
    { "sprite.plate", sprite_plate, PARAMS(plate_params), 0, API_CHANGES, "sprite",
      HELP("places a dark plate with a light rim on the screen, above the picture that screen.dim darkens and below "
           "the text") },
    API_EACH_VERB("sprite:remove", sprite_remove, self_params, 1, "removes the sprite"),
    { "spark.def", spark_define, PARAMS(spark_def_params), 1, API_CHANGES | API_LOAD_ONLY, NULL,
      HELP("declares a kind of spark: a purely visual particle that never hits and that scripts can't read") },
    { "spark.burst", spark_burst, PARAMS(burst_params), 0, API_CHANGES, NULL,
      HELP("creates sparks that scatter from a point, a ring or a line") },
    { "text.put", text_put, PARAMS(text_put_params), 0, API_CHANGES, NULL,
      HELP("writes text into the grid of 8x8 cells on the screen; the text stays until it is overwritten or cleared") },
    { "text.clear", text_clear, PARAMS(text_clear_params), 0, API_CHANGES, NULL,
      HELP("clears a rectangle of text cells; without arguments, all of them") },
    { "text.lang", translate_text, PARAMS(text_lang_params), 1, 0, "string",
      HELP("translates a text into the language of the run, using lang/NAME.txt; a text that has no translation is "
           "returned unchanged") },
    { "palette.set", palette_set, PARAMS(set_params), 2, API_CHANGES, NULL, HELP("sets one colour of the palette") },
    { "palette.load", palette_load, PARAMS(load_params), 1, API_CHANGES, NULL,
      HELP("sets all 256 colours to a palette from rom.lua") },
    { "palette.fade", palette_fade, PARAMS(fade_params), 0, API_CHANGES, NULL,
      HELP("fades colours to one colour or to a palette from rom.lua") },
    { "palette.cycle", palette_cycle, PARAMS(cycle_params), 0, API_CHANGES, NULL,
      HELP("rotates a range of colours by one entry every few frames; up to 8 ranges can rotate at the same time") },
    { "screen.shake", shake_screen, PARAMS(shake_params), 0, API_CHANGES, NULL,
      HELP("shakes the picture of the field; nothing really moves, so hits aren't affected") },
    { "screen.flash", flash_screen, PARAMS(flash_params), 0, API_CHANGES, NULL,
      HELP("tints the entire picture and fades the tint out") },
    { "screen.letterbox", screen_letterbox, PARAMS(bars_params), 0, API_CHANGES, NULL,
      HELP("slides in black bars at the top and the bottom of the field, under the text") },
    { "screen.dim", dim_screen, PARAMS(dim_params), 0, API_CHANGES, "share",
      HELP("darkens everything except plates, text and sprites in layer `over`, even while the game is paused; returns "
           "the previous `share`") },
};
const struct api_module api_screen = { entries, sizeof entries / sizeof *entries };
