/*
 * api_sys_text.c - sys: text on the screen, for the screens and dialogue of the library.
 */
#include <string.h>
#include "../../../fb/line_break.h"
#include "../../../fb/text.h"
#include "../../../fb/utf8.h"
#include "../../base/bytes.h"
#include "../../machine/video/video.h"
#include "../../machine/window.h"
#include "api_parts.h"

static const struct api_param sys_glyph_params[] = { PARAM("code", A_INT, REQ, 0, 255, NULL, NULL, "") };

static int sys_has_glyph(lua_State *L, struct board *b, struct api_value *v)
{
    lua_pushboolean(L, text_has_glyph(&(struct font){ b->cart.glyphs, 32, b->cart.n_glyphs }, (uint32_t)v[0].i));
    return 1;
}

/* For old ROMs; the library no longer calls it. */
static int sys_glyphs(lua_State *L, struct board *b, struct api_value *v)
{
    (void)v;
    lua_pushinteger(L, b->cart.n_glyphs);
    return 1;
}

/* Returns the size in bytes of the saved text: the columns of the cells, one after the other, little-endian. */
static size_t compute_saved_text_size(const struct fix *f)
{
    return (size_t)f->cols * f->rows * (f->page ? 6 : 3);
}

static int sys_save_text(lua_State *L, struct board *b, struct api_value *v)
{
    const struct fix *f = &b->fix;
    const size_t cells = (size_t)f->cols * f->rows;
    luaL_Buffer out;
    char *dst = luaL_buffinitsize(L, &out, compute_saved_text_size(f));

    (void)v;
    vm_charge(L, compute_saved_text_size(f) / 64);
    memcpy(dst, f->code, cells);
    for (size_t i = 0; i < cells; i++)
        bytes_put16((uint8_t *)dst + cells + 2 * i, f->style[i]);
    for (size_t i = 0; f->page && i < cells; i++) {
        dst[3 * cells + i] = (char)f->font[i];
        bytes_put16((uint8_t *)dst + 4 * cells + 2 * i, f->page[i]);
    }
    luaL_pushresultsize(&out, compute_saved_text_size(f));
    return 1;
}

static const struct api_param saved_text_params[] = { PARAM("kept", A_ANY, REQ, 0, 0, "what sys.keep_text returned",
                                                            NULL, "") };

static int sys_restore_text(lua_State *L, struct board *b, struct api_value *v)
{
    struct fix *f = &b->fix;
    const size_t cells = (size_t)f->cols * f->rows;
    size_t n = 0;
    const char *src = lua_type(L, v[0].at) == LUA_TSTRING ? lua_tolstring(L, v[0].at, &n) : NULL;

    if (!src || n != compute_saved_text_size(f))
        return api_error(L, "sys.text_back", "expected a value from sys.keep_text");
    vm_charge(L, n / 64);
    memcpy(f->code, src, cells);
    for (size_t i = 0; i < cells; i++)
        f->style[i] = bytes_get16((const uint8_t *)src + cells + 2 * i);
    for (size_t i = 0; f->page && i < cells; i++) {
        f->font[i] = (uint8_t)src[3 * cells + i];
        f->page[i] = bytes_get16((const uint8_t *)src + 4 * cells + 2 * i);
    }
    return 0;
}

/* Returns whether a rectangle of the screen, in px, overlaps the window. */
static bool overlaps_field(const struct board *b, fx x, fx y, int w, int h)
{
    const struct window view = window_of(b);
    const int left = fx_floor(x) - view.x, top = fx_floor(y) - view.y;

    return left < view.w && left + w > 0 && top < view.h && top + h > 0;
}

static bool sprite_covers_field(const struct board *b, uint32_t i)
{
    const struct sprites *s = &b->sprites;
    const struct sprite p = video_scale_sprite(&b->sprite_images[s->layer[i] < LAYER_PLATE ? s->sprite[i] : 0],
                                               s->scale ? s->scale[i] : SCALE_ONE);

    if (s->layer[i] < LAYER_OVER || s->flags[i] & SPRITE_HIDDEN)
        return false;
    if (s->layer[i] >= LAYER_PLATE)
        return overlaps_field(b, s->x[i], s->y[i], s->sprite[i], (int)s->born[i]);
    return !(s->flags[i] & SPRITE_SCREEN) ||
           overlaps_field(b, s->x[i] - p.ox * FX_ONE, s->y[i] - p.oy * FX_ONE, p.w, p.h);
}

/* Returns whether a text line covers the field. A visible line does, unless it is positioned on the screen and outside
 * the field. */
static bool line_covers_field(const struct lines *l, const struct board *b, uint32_t i)
{
    return !(l->flags[i] & LINE_HIDDEN) &&
           (!(l->flags[i] & LINE_SCREEN) || overlaps_field(b, l->dx[i], l->dy[i], 1, 1));
}

/* Appends a handle to the list at stack index `list`. */
static void append_handle(lua_State *L, int list, int64_t handle)
{
    lua_pushinteger(L, handle);
    lua_rawseti(L, list, (lua_Integer)lua_rawlen(L, list) + 1);
}

static int sys_covers(lua_State *L, struct board *b, struct api_value *v)
{
    (void)v;
    vm_charge(L, (b->sprites.s.live + b->lines.s.live) / 8);
    lua_newtable(L);
    lua_newtable(L);
    const int others = lua_gettop(L), plates = others - 1;
    EACH_LIVE (i, &b->sprites.s)
        if (sprite_covers_field(b, i))
            append_handle(L, b->sprites.layer[i] < LAYER_PLATE ? others : plates,
                          board_handle(b, H_SPRITE, (int32_t)i));
    EACH_LIVE (i, &b->lines.s)
        if (line_covers_field(&b->lines, b, i))
            append_handle(L, others, board_handle(b, H_LINE, (int32_t)i));
    return 2;
}

/* Of the letters, in sys.cells and sys.wrap. text.put writes only those of size 1 `screen.full_width` px wide. */
#define SIZE_PARAM PARAM("size", A_INT, OPT, 1, 3, "cells", "1", "of the letters")

static int full_width_of(const struct board *b, const struct api_value *size)
{
    return size->i > 1 ? FIX_CELL_SIZE : b->cart.manifest.full_width;
}

enum { CELLS_TEXT, CELLS_SIZE };
static const struct api_param sys_cells_params[] = { REQUIRED("text", A_STR, ""), SIZE_PARAM };

static int sys_count_cells(lua_State *L, struct board *b, struct api_value *v)
{
    size_t n;
    const char *s = lua_tolstring(L, v[CELLS_TEXT].at, &n);

    vm_charge(L, n / 8);
    const size_t width = fix_text_width(s, n, full_width_of(b, &v[CELLS_SIZE])) * (size_t)v[CELLS_SIZE].i;
    if (width % FIX_CELL_SIZE)
        lua_pushnumber(L, (lua_Number)width / FIX_CELL_SIZE);
    else
        lua_pushinteger(L, (lua_Integer)width / FIX_CELL_SIZE);
    return 1;
}

enum { WRAP_TEXT, WRAP_WIDTH, WRAP_SIZE };
static const struct api_param sys_wrap_params[] = { REQUIRED("text", A_STR, ""),
                                                    PARAM("width", A_NUM, REQ, 1, MAX_TEXT, "cells", NULL, ""),
                                                    SIZE_PARAM };

/* The width of a row and of its full-width letters, px. */
struct measure {
    size_t width;
    int full_width;
};

/* Appends a word that fits in a row to the row on top of the stack. If the word does not fit, appends the row to the
 * list at `list` and starts the next row with the word. */
static void wrap_word(lua_State *L, int list, const char *word, size_t n, struct measure m)
{
    size_t row_bytes;
    const char *row = lua_tolstring(L, -1, &row_bytes);

    if (row_bytes &&
        fix_text_width(row, row_bytes, m.full_width) + FIX_CELL_SIZE + fix_text_width(word, n, m.full_width) <=
            m.width) {
        lua_pushliteral(L, " ");
        lua_pushlstring(L, word, n);
        lua_concat(L, 3);
        return;
    }
    if (row_bytes)
        lua_rawseti(L, list, (lua_Integer)lua_rawlen(L, list) + 1);
    else
        lua_pop(L, 1);
    lua_pushlstring(L, word, n);
}

static int advance_of(const void *font, uint32_t code)
{
    const struct measure *m = font;

    return utf8_is_full_width(code) ? m->full_width : FIX_CELL_SIZE;
}

static int sys_wrap_text(lua_State *L, struct board *b, struct api_value *v)
{
    static const char blanks[] = " \t\n\v\f\r";
    const struct measure m = { (size_t)(v[WRAP_WIDTH].n * FIX_CELL_SIZE / (lua_Number)v[WRAP_SIZE].i),
                               full_width_of(b, &v[WRAP_SIZE]) };
    size_t n, bytes, fitting;
    lua_Integer broken = 0;
    const char *s = lua_tolstring(L, v[WRAP_TEXT].at, &n), *end = s + n;

    vm_charge(L, n);
    lua_newtable(L);
    int list = lua_gettop(L);
    if (fix_text_width(s, n, m.full_width) <= m.width) {
        lua_pushvalue(L, v[WRAP_TEXT].at);
        lua_rawseti(L, list, 1);
        lua_pushinteger(L, 0);
        return 2;
    }
    lua_pushliteral(L, "");
    for (; s < end; s++) {
        size_t word_length = 0;
        while (s + word_length < end && (s[word_length] == '\0' || strchr(blanks, s[word_length]) == NULL))
            word_length++;
        for (; word_length > 0; s += bytes, word_length -= bytes) {
            const size_t at = line_break_find(s, word_length, (int)m.width, advance_of, &m, &fitting);
            bytes = at ? at : fitting;
            broken += bytes < word_length && line_break_before(s, word_length, bytes) != LINE_BREAK_WORD;
            wrap_word(L, list, s, bytes, m);
        }
    }
    lua_rawseti(L, list, (lua_Integer)lua_rawlen(L, list) + 1);
    lua_pushinteger(L, broken);
    return 2;
}

static const struct api_entry entries[] = {
    { "sys.glyph", sys_has_glyph, PARAMS(sys_glyph_params), 1, API_SYS, "boolean",
      HELP("returns true if the cells' font has a glyph for a character") },
    { "sys.glyphs", sys_glyphs, NO_PARAMS, 0, API_SYS, "count", HELP("returns the number of characters in the font") },
    { "sys.keep_text", sys_save_text, NO_PARAMS, 0, API_SYS, "string", HELP("returns the contents of all cells") },
    { "sys.text_back", sys_restore_text, PARAMS(saved_text_params), 1, API_SYS | API_CHANGES, NULL,
      HELP("restores the contents of the cells") },
    { "sys.covers", sys_covers, NO_PARAMS, 0, API_SYS, "plates, others",
      HELP("returns two lists of what would be drawn over a window in the field: plates; and lines with the sprites in "
           "layer `over`") },
    { "sys.cells", sys_count_cells, PARAMS(sys_cells_params), 2, API_SYS, "count",
      HELP("returns the number of cells a text takes") },
    { "sys.wrap", sys_wrap_text, PARAMS(sys_wrap_params), 3, API_SYS, "list, broken",
      HELP("breaks a text into rows of at most n cells; breaks only words that are longer than a row; returns how "
           "many rows end inside a word, too") },
};
const struct api_module api_sys_text = { entries, sizeof entries / sizeof *entries };
