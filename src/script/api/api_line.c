/*
 * api_line.c - text.line: text positioned to the pixel.
 */
#include <math.h>
#include "../../../fb/utf8.h"
#include "api_parts.h"
#include "../lua/lualib.h"

enum {
    L_POSITION,
    L_TEXT = L_POSITION + POSITION_PARAM_COUNT,
    L_FOLLOW,
    L_FONT,
    L_WIDTH,
    L_ALIGN,
    L_BANK,
    L_SCREEN,
    L_LETTER,
    L_BOX,
    L_HIDDEN,
    L_STAY,
    L_FULL_WIDTH
};

static const struct api_param line_params[] = {
    POSITION_PARAMS,
    REQUIRED("text", A_ANY, "string or number to write, up to 240 characters; \\n starts a new row"),
    THING("follow", OPT, POSITION_HANDLE_KINDS,
          "thing to follow, at a distance of `dx` and `dy`; the line is removed when the thing is; not with `x`, `y` "
          "or `from`"),
    OPTIONAL("font", A_FONT, "font from rom.lua; defaults to the font of the cells"),
    PARAM("width", A_INT, OPT, 8, 1024, "px", NULL, "width at which rows wrap; if omitted, only \\n ends a row"),
    DEFAULT("align", A_ALIGN, "left", "put the start, the middle or the end of each row at `x`"),
    BANK(OPT, "0", "number added to the palette bank of the font"),
    DEFAULT("screen", A_BOOL, "false",
            "measure `x` and `y` from the top left of the screen instead of the field; not with `follow`"),
    PARAM("letter", A_INT, OPT, 0, 600, "frames", "0",
          "frames from one letter to the next; 0 shows all letters immediately"),
    DEFAULT("box", A_BOOL, "false", "draw a box behind the text in the darkest colour of the bank"),
    DEFAULT("hidden", A_BOOL, "false", "create the line without drawing it"),
    DEFAULT("stay", A_BOOL, "false", "keep the line when the boss phase that created it ends"),
    DEFAULT("full_width", A_BOOL, "false",
            "write full-width letters, such as Japanese ones, `screen.full_width` px wide (rom.lua)"),
};

const char *api_check_text(lua_State *L, const char *entry, int at, size_t *n)
{
    if (lua_type(L, at) != LUA_TSTRING && lua_type(L, at) != LUA_TNUMBER)
        api_error(L, entry, "text: expected a string or a number, got a %s", luaL_typename(L, at));
    if (lua_type(L, at) == LUA_TNUMBER && !isfinite(lua_tonumber(L, at)))
        api_error(L, entry, "text: expected a finite number");
    return lualib_tolstring(L, at, n);
}

/* Returns the text of a line; raises an error if the text is invalid or too long. */
static const char *check_text(lua_State *L, const char *entry, int at, size_t *n)
{
    const char *s = api_check_text(L, entry, at, n);
    size_t count = utf8_count(s, *n, MAX_TEXT, NULL);

    if (count > LINE_MAX_TEXT)
        api_error(L, entry, "text: expected at most %d characters, got %d", LINE_MAX_TEXT, (int)count);
    vm_charge(L, LINE_MAX_TEXT / 8);
    return s;
}

_Static_assert((int)ALIGN_CENTER == LINE_CENTER && (int)ALIGN_RIGHT == LINE_RIGHT,
               "the words of `align` have the values of LINE_CENTER and LINE_RIGHT");

static void fill_line(struct lines *l, uint32_t i, const struct api_value *v, fx x, fx y)
{
    const bool follows = v[L_FOLLOW].given;

    l->x[i] = follows ? 0 : x;
    l->y[i] = follows ? 0 : y;
    l->dx[i] = follows ? v[L_POSITION + 3].f : 0;
    l->dy[i] = follows ? v[L_POSITION + 4].f : 0;
    l->follow_target[i] = follows ? v[L_FOLLOW].i : 0;
    l->font[i] = (uint8_t)v[L_FONT].i;
    l->wrap_width[i] = (uint16_t)(v[L_WIDTH].given ? v[L_WIDTH].i : 0);
    l->align[i] = (uint8_t)v[L_ALIGN].i;
    l->bank[i] = (uint8_t)v[L_BANK].i;
    l->letter_frames[i] = (uint16_t)v[L_LETTER].i;
    l->flags[i] = (uint8_t)((v[L_SCREEN].i ? LINE_SCREEN : 0) | (v[L_HIDDEN].i ? LINE_HIDDEN : 0) |
                            (v[L_BOX].i ? LINE_BOX : 0) | (v[L_FULL_WIDTH].i ? LINE_FULL_WIDTH : 0));
}

/* Reads the position of a line. Returns false if the thing `from` or `follow` is dead. */
static bool read_line_position(lua_State *L, struct board *b, struct api_value *v, fx *x, fx *y)
{
    *x = *y = 0;
    if (!v[L_FOLLOW].given)
        return api_read_position(L, b, "text.line", v + L_POSITION, x, y);
    if (v[L_POSITION].given || v[L_POSITION + 1].given || v[L_POSITION + 2].given)
        api_error(L, "text.line", "`follow` cannot be combined with `x`, `y` or `from`");
    if (v[L_SCREEN].i)
        api_error(L, "text.line", "`screen` cannot be combined with `follow`");
    return board_is_alive(b, v[L_FOLLOW].i);
}

static int text_line(lua_State *L, struct board *b, struct api_value *v)
{
    struct lines *l = &b->lines;
    size_t n;
    const char *s = check_text(L, "text.line", v[L_TEXT].at, &n);
    int64_t owner;
    fx x, y;
    bool can_create = read_line_position(L, b, v, &x, &y) && tasks_get_spawn_owner(b, v[L_STAY].i, &owner);
    int32_t i = can_create ? board_take_slot(b, &l->s) : NO_SLOT;
    if (i != NO_SLOT) {
        fill_line(l, (uint32_t)i, v, x, y);
        l->owner[i] = owner;
        lines_set_text(l, (uint32_t)i, s, n, b->core.clock);
    }
    lua_pushinteger(L, board_handle(b, H_LINE, i));
    return 1;
}

enum { P_X, P_Y, P_DX, P_DY, P_TEXT, P_BANK, P_HIDDEN, P_DONE, PROPS };

static const struct api_param props[PROPS] = {
    COORDINATE(
        "x", A_FX, REQ,
        "horizontal position; while the line follows a thing, this is the thing's position, and writes are ignored",
        SETTER),
    COORDINATE(
        "y", A_FX, REQ,
        "vertical position; while the line follows a thing, this is the thing's position, and writes are ignored",
        SETTER),
    COORDINATE("dx", A_FX, REQ, "distance to the right of `x` at which it is drawn", STORED(lines.dx), WRITABLE),
    COORDINATE("dy", A_FX, REQ, "distance below `y` at which it is drawn", STORED(lines.dy), WRITABLE),
    REQUIRED("text", A_STR, "text of the line; after a write, the letters appear one by one again", SETTER),
    BANK(REQ, NULL, "number added to the palette bank of the font", STORED(lines.bank), WRITABLE),
    REQUIRED("hidden", A_BOOL, "true if not drawn", BITS_OF(lines.flags, LINE_HIDDEN), WRITABLE),
    REQUIRED("done", A_BOOL, "true once all letters have appeared"),
};

static void push_text(lua_State *L, const struct lines *l, uint32_t i)
{
    char text[LINE_MAX_TEXT * UTF8_MAX_BYTES];
    size_t n = 0;

    for (uint32_t k = 0; k < l->length[i]; k++)
        n += utf8_put(text + n, l->code[(size_t)i * LINE_MAX_TEXT + k]);
    lua_pushlstring(L, text, n);
}

static void get_line(lua_State *L, struct board *b, uint32_t i, int p)
{
    const struct lines *l = &b->lines;
    fx x = l->x[i], y = l->y[i];

    if (p == P_TEXT)
        push_text(L, l, i);
    else if (p == P_DONE)
        lua_pushboolean(L, lines_visible_letters(l, i, b->core.clock) == l->length[i]);
    else {
        if (l->follow_target[i])
            board_get_position(b, l->follow_target[i], &x, &y);
        lua_pushnumber(L, fx_to_double(p == P_X ? x : y));
    }
}

static void set_line(lua_State *L, struct board *b, uint32_t i, int p, const struct api_value *v)
{
    struct lines *l = &b->lines;
    size_t n;

    if (p == P_TEXT) {
        const char *s = check_text(L, "line.text", v->at, &n);
        lines_set_text(l, i, s, n, b->core.clock);
    } else if (!l->follow_target[i])
        (p == P_X ? l->x : l->y)[i] = v->f;
}

const struct api_thing api_line_thing = { "line", props, PROPS, .get = get_line, .set = set_line };

enum { ARG_SELF };

static const struct api_param self_params[] = { THING("self", REQ, 1 << H_LINE, "") };

static int line_remove(lua_State *L, struct board *b, struct api_value *v)
{
    (void)L;
    slots_drop(&b->lines.s, handle_slot(v[ARG_SELF].i));
    slots_trim(&b->lines.s);
    return 0;
}

static const struct api_entry entries[] = {
    { "text.line", text_line, PARAMS(line_params), 0, API_CHANGES, "line",
      HELP("writes a line of text at any pixel in the field or on the screen, or attached to a thing; needs `board = { "
           "lines = n }`") },
    API_EACH_VERB("line:remove", line_remove, self_params, 1, "removes the line"),
};
const struct api_module api_line = { entries, sizeof entries / sizeof *entries };
