/*
 * api_bg.c - the Lua table bg: background layers and the plane.
 */
#include <stdio.h>
#include <string.h>
#include "../../base/trig.h"
#include "api_parts.h"

enum {
    MAX_LINES = 1024,   /* height of the tallest field, in lines */
    SHADE_WORK = 500000 /* work of building one table of shades, in VM instructions */
};

static const char lines_entry[] = "bg.lines", fog_entry[] = "plane: fog";

/* ---- shared by layers and the plane ---- */

#define SHARED_PROPS                                                                                                   \
    OPTIONAL("map", A_MAP, "name of its map in rom.lua; nil turns it off", STORED(bg.map), WRITABLE),                  \
        COORDINATE("x", A_FX, REQ,                                                                                     \
                   "left edge of a layer's map in the field, or position of a plane's eye over the map; increases by " \
                   "`vx` every frame",                                                                                 \
                   STORED(bg.x), WRITABLE),                                                                            \
        COORDINATE("y", A_FX, REQ,                                                                                     \
                   "top edge of a layer's map in the field, or position of a plane's eye over the map; increases by "  \
                   "`vy` every frame",                                                                                 \
                   STORED(bg.y), WRITABLE),                                                                            \
        SPEED("vx", A_FX, REQ, "speed to the right", STORED(bg.vx), WRITABLE),                                         \
        SPEED("vy", A_FX, REQ, "speed down", STORED(bg.vy), WRITABLE),                                                 \
        REQUIRED("layer", A_DEPTH,                                                                                     \
                 "drawing order; `back` is behind all things, and `front` is in front of all sprites",                 \
                 BITS_OF(bg.flags, BG_FRONT), WRITABLE),                                                               \
        BANK(REQ, NULL, "number added to the palette bank of the tiles", STORED(bg.bank), WRITABLE),                   \
        OPTIONAL("blend", A_BLEND, "blend it is drawn with, or nil", BITS_OF(bg.flags, BG_BLEND), WRITABLE),           \
        REQUIRED("hidden", A_BOOL, "true if not drawn; it still moves", BITS_OF(bg.flags, BG_HIDDEN), WRITABLE)

/* ---- layers ---- */

static const struct api_param layer_props[] = {
    SHARED_PROPS,
    REQUIRED("wrap", A_BOOL, "true if its map repeats in all directions", BITS_OF(bg.flags, BG_WRAP), WRITABLE),
    PARAM("follow", A_FX, REQ, 0, 4, NULL, NULL,
          "distance it moves when the camera moves by 1 px: 1 moves it with the field, and less makes it look further "
          "away; needs `view` in rom.lua",
          STORED(bg.follow), WRITABLE),
};

const struct api_thing api_layer_thing = { "layer", PARAMS(layer_props), .slots_offset = offsetof(struct board, bg.s) };

/* ---- the plane ---- */

enum { FOG_COLOUR, FOG_END, FOG_PARAM_COUNT };

static const struct api_param plane_props[] = {
    SHARED_PROPS,
    PARAM("horizon", A_INT, REQ, -1024, 1024, "px", NULL, "distance of the horizon from the top of the field",
          STORED(bg.horizon), WRITABLE),
    PARAM("height", A_FX, REQ, 1, 1024, "px", NULL, "height of the eye above the plane", STORED(bg.height), WRITABLE),
    REQUIRED("dir", A_DIR, "direction in which the eye looks; 270 is up the map", STORED(bg.dir), WRITABLE),
    REQUIRED("ceiling", A_BOOL, "true for a ceiling above the horizon instead of a floor below it",
             BITS_OF(bg.flags, BG_CEILING), WRITABLE),
    OPTIONAL(
        "fog", A_TABLE,
        "{ to = 0xRRGGBB, far = px }: colour that the plane fades to with distance, and the distance at which only "
        "that colour is left; nil for no fog",
        SETTER),
};

static const struct api_param fog_params[FOG_PARAM_COUNT] = {
    PARAM("to", A_INT, REQ, 0, 0xffffff, NULL, NULL, ""),
    PARAM("far", A_FX, REQ, 1, WORLD_EDGE, "px", NULL, ""),
};

static void push_fog(lua_State *L, struct board *b, uint32_t i, int p)
{
    const struct bg *g = &b->bg;

    (void)i, (void)p;
    if (g->fog[BG_PLANE] == BG_NO_FOG) {
        lua_pushnil(L);
        return;
    }
    lua_createtable(L, 0, FOG_PARAM_COUNT);
    api_set_integer(L, "to", g->fog[BG_PLANE]);
    lua_pushnumber(L, fx_to_double(g->fog_end[BG_PLANE]));
    lua_setfield(L, -2, "far");
}

/* Builds the tables of shades at offset `at` for a fade to the colour `colour`. */
static void build_shades(struct board *b, int at, uint32_t colour)
{
    if (!b->bg_shades.s.live)
        memset(b->bg_shades.table, 0, BG_TABLES_SIZE);
    b->bg_shades.s.live = b->bg_shades.s.cap;
    bg_fill_shades(b->bg_shades.table + at,
                   b->cart.has_palette_tables ? cart_palette_at(&b->cart, board_loaded_palette(b))
                                              : cart_palette(&b->cart, "main"),
                   colour);
}

void api_bg_rebuild_shades(lua_State *L, struct board *b, bool changed)
{
    const bool has_fog = b->bg.fog[BG_PLANE] != BG_NO_FOG, is_fading = b->bg.fade_length[0];

    if (has_fog) /* charged even if no table is built, because the palette is not part of the tick's result */
        vm_charge(L, SHADE_WORK);
    if (is_fading)
        vm_charge(L, SHADE_WORK);
    if (changed && has_fog)
        build_shades(b, BG_FOG_OFFSET, b->bg.fog[BG_PLANE]);
    if (changed && is_fading)
        build_shades(b, BG_BLACK_OFFSET, 0);
}

static void set_fog(lua_State *L, struct board *b, uint32_t i, int p, const struct api_value *v)
{
    struct api_value f[FOG_PARAM_COUNT];

    (void)i, (void)p;
    if (!v->given) {
        b->bg.fog[BG_PLANE] = BG_NO_FOG;
        return;
    }
    api_read_fields(L, fog_entry, NULL, &(struct api_fields){ fog_params, FOG_PARAM_COUNT, NAME_LISTS }, v->at, f);
    if ((uint32_t)f[FOG_COLOUR].i != b->bg.fog[BG_PLANE]) {
        vm_charge(L, SHADE_WORK);
        build_shades(b, BG_FOG_OFFSET, (uint32_t)f[FOG_COLOUR].i);
    }
    b->bg.fog[BG_PLANE] = (uint32_t)f[FOG_COLOUR].i;
    b->bg.fog_end[BG_PLANE] = f[FOG_END].f;
}

const struct api_thing api_plane_thing = { "plane", PARAMS(plane_props), .get = push_fog, .set = set_fog };

/* ---- bg.layer, bg.plane, bg.lines ---- */

enum { ARG_I, ARG_LINES };

static const struct api_param layer_params[] = { PARAM("i", A_INT, REQ, 1, BG_LAYERS, NULL, NULL,
                                                       "number of the layer, from back to front") };
static const struct api_param lines_params[] = {
    PARAM("i", A_INT, REQ, 1, BG_LAYERS, NULL, NULL, "number of the layer"),
    OPTIONAL("lines", A_TABLE,
             "a wave, or a list of shifts in px, one for each line from the top of the field, repeated as needed; if "
             "omitted, the layer becomes straight again")
};

enum { WAVE_WIDTH, WAVE_EVERY, WAVE_SPEED, WAVE_PARAM_COUNT };

static const struct api_param wave_params[WAVE_PARAM_COUNT] = {
    PARAM("wave", A_FX, REQ, -1024, 1024, "px", NULL, "distance the lines sway to each side"),
    PARAM("every", A_FX, REQ, 1, WORLD_EDGE, "px", NULL, "distance from one crest to the next"),
    PARAM("speed", A_FX, OPT, -MAX_SPEED, MAX_SPEED, "px/frame", "0", "speed at which the wave moves down"),
};

static int bg_layer(lua_State *L, struct board *b, struct api_value *v)
{
    (void)b;
    lua_pushinteger(L, handle_make(H_LAYER, 1, (uint32_t)v[ARG_I].i - 1));
    return 1;
}

static int bg_plane(lua_State *L, struct board *b, struct api_value *v)
{
    (void)b, (void)v;
    lua_pushinteger(L, handle_make(H_PLANE, 1, BG_PLANE));
    return 1;
}

/* Reads the list of distances at stack index `at` into `offsets`. Returns the number of elements; raises an error if it
 * exceeds `capacity`. */
static uint32_t read_line_offsets(lua_State *L, int at, fx *offsets, uint32_t capacity)
{
    const lua_Unsigned n = lua_rawlen(L, at);
    char name[32];

    if (n > capacity)
        api_error(L, lines_entry, "expected at most %d lines (the height of the field), got %d", (int)capacity, (int)n);
    vm_charge(L, n);
    for (uint32_t k = 0; k < n; k++) {
        struct api_param p = COORDINATE(name, A_FX, REQ, NULL);
        struct api_value v = { 0 };
        lua_rawgeti(L, at, (lua_Integer)k + 1);
        snprintf(name, sizeof name, "line %d", (int)k + 1);
        api_check(L, lines_entry, &p, lua_gettop(L), &v);
        offsets[k] = v.f;
        lua_pop(L, 1);
    }
    return (uint32_t)n;
}

/* Sets the line offsets of layer i from the list at `at`. Folds the numbers, because the call itself does not fold the
 * contents of a table. */
static void set_line_offsets(lua_State *L, struct board *b, uint32_t i, int at)
{
    fx offsets[MAX_LINES];
    const uint32_t n = read_line_offsets(L, at, offsets, b->bg_lines.s.cap / BG_LAYERS);

    for (uint32_t k = 0; k < n; k++)
        script_update_digest(b, (uint32_t)offsets[k]);
    bg_set_lines(&b->bg, &b->bg_lines, i, offsets, n);
}

static void set_wave(struct board *b, uint32_t i, const struct api_value *v)
{
    struct bg *g = &b->bg;

    g->wave_amplitude[i] = v[WAVE_WIDTH].f;
    g->wave_period[i] = v[WAVE_EVERY].f;
    g->wave_speed[i] = v[WAVE_SPEED].f;
    for (int k = 0; k < WAVE_PARAM_COUNT; k++)
        script_update_digest(b, (uint32_t)v[k].f);
}

static int bg_lines(lua_State *L, struct board *b, struct api_value *v)
{
    const uint32_t i = (uint32_t)v[ARG_I].i - 1;
    struct api_value wave[WAVE_PARAM_COUNT] = { { 0 } };

    if (v[ARG_LINES].given && lua_rawlen(L, v[ARG_LINES].at)) {
        set_wave(b, i, wave);
        set_line_offsets(L, b, i, v[ARG_LINES].at);
        return 0;
    }
    if (v[ARG_LINES].given)
        api_read_fields(L, lines_entry, NULL, &(struct api_fields){ wave_params, WAVE_PARAM_COUNT, NAME_LISTS },
                        v[ARG_LINES].at, wave);
    bg_set_lines(&b->bg, &b->bg_lines, i, NULL, 0);
    set_wave(b, i, wave);
    if (!v[ARG_LINES].given)
        b->bg.phase[i] = 0;
    return 0;
}

/* ---- sys: called by bg.lua ---- */

static const struct api_param fade_params[] = { PARAM("n", A_INT, REQ, 0, UINT16_MAX, "frames", NULL, "") };
static const struct api_param shown_params[] = { PARAM("n", A_INT, OPT, 0, UINT16_MAX, NULL, NULL, "") };

/* Starts a fade of n frames, to black and back; 0 ends it. Returns the frames until the screen is black. */
static int sys_bg_fade(lua_State *L, struct board *b, struct api_value *v)
{
    if (v[ARG_I].i && !b->bg.fade_length[0]) {
        vm_charge(L, SHADE_WORK);
        build_shades(b, BG_BLACK_OFFSET, 0);
    }
    lua_pushinteger(L, bg_fade(&b->bg, (uint32_t)v[ARG_I].i));
    return 1;
}

static int sys_bg_shown(lua_State *L, struct board *b, struct api_value *v)
{
    if (v[ARG_I].given)
        b->bg.shown_id[0] = (uint16_t)v[ARG_I].i;
    lua_pushinteger(L, b->bg.shown_id[0]);
    return 1;
}

static int sys_bg_clear(lua_State *L, struct board *b, struct api_value *v)
{
    (void)L, (void)v;
    bg_clear(&b->bg, &b->bg_lines);
    return 0;
}

static const struct api_entry entries[] = {
    { "bg.layer", bg_layer, PARAMS(layer_params), 1, 0, "layer",
      HELP("returns one of the four tile layers of the background") },
    PARAM("bg.plane", bg_plane, NULL, 0, 0, 0, "plane",
          "returns the plane of the background, a floor or a ceiling in perspective"),
    { "bg.lines", bg_lines, PARAMS(lines_params), 2, API_CHANGES, NULL, HELP("shifts each line of a layer sideways") },
#ifndef WITHOUT_HELP
    { "bg.lines lines", NULL, PARAMS(wave_params), 0, API_LUA | API_SYS, NULL,
      HELP("a wave, given instead of a list") },
#endif
    { "sys.bg_fade", sys_bg_fade, PARAMS(fade_params), 1, API_SYS | API_CHANGES, "frames",
      HELP("fades the background to black and back; returns the frames until it is black") },
    { "sys.bg_shown", sys_bg_shown, PARAMS(shown_params), 1, API_SYS | API_CHANGES, "number",
      HELP("returns the number of the background shown; n sets it") },
    { "sys.bg_clear", sys_bg_clear, NULL, 0, 0, API_SYS | API_CHANGES, NULL,
      HELP("turns the background off; a fade continues") },
};
const struct api_module api_bg = { entries, sizeof entries / sizeof *entries };
