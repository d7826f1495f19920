/*
 * manifest_text.c - manifest_read of manifest.h: rom.lua, read by Lua in a state that has no function to call.
 *
 * The state lives in the caller's block and dies with it. What bounds it: the block's size, the length of a string (so
 * that no one instruction is slow), the bytes ever allocated, and a count of instructions. Errors are Lua errors up to
 * the one pcall; none of the text's own code can catch one.
 */
#include "../../rom/manifest.h"

#include <inttypes.h>
#include <lauxlib.h>
#include <lua.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "../../../fb/utf8.h"
#include "../../base/heap.h"
#include "../../base/host.h"
#include "../../script/luakeys.h"

enum {
    MAX_FILE = 1 << 20,   /* bytes of rom.lua */
    MAX_STRING = 1 << 14, /* bytes of one string in it */
    MAX_WORK = 256 << 20, /* bytes ever allocated while it runs */
    MAX_STEPS = 1 << 20,  /* VM instructions */
    MAX_MARKERS = 64,     /* of a recording */
    MAX_PATH = 128        /* "sprites.orb.origin" */
};

struct reader {
    const char *text;
    size_t n;
    const char *file;
    struct manifest *m;
    struct art *art;
};

/* A table on the Lua stack and how messages call it. */
struct at {
    lua_State *lua;
    int index;
    char path[MAX_PATH]; /* "": the whole manifest */
};

static _Noreturn void bad(lua_State *lua, const char *path, const char *format, ...)
{
    va_list args;

    va_start(args, format);
    lua_pushfstring(lua, "%s: ", path);
    lua_pushvfstring(lua, format, args);
    va_end(args);
    lua_concat(lua, 2);
    lua_error(lua);
    abort(); /* lua_error does not return */
}

static void path_of(const struct at *a, const char *key, char out[MAX_PATH])
{
    snprintf(out, MAX_PATH, "%.80s%s%.40s", a->path, a->path[0] != '\0' ? "." : "", key);
}

/* Describes the value on top of the stack: nil, 2.5, "text", a table. */
static const char *got(lua_State *lua)
{
    switch (lua_type(lua, -1)) {
    case LUA_TNIL:
        return "nil";
    case LUA_TNUMBER:
        return lua_isinteger(lua, -1) ? lua_pushfstring(lua, "%I", lua_tointeger(lua, -1))
                                      : lua_pushfstring(lua, "%f", lua_tonumber(lua, -1));
    case LUA_TSTRING: {
        char cut[48];
        snprintf(cut, sizeof cut, "\"%.40s\"", lua_tostring(lua, -1));
        return lua_pushstring(lua, cut);
    }
    default:
        return lua_pushfstring(lua, "a %s", luaL_typename(lua, -1));
    }
}

/* Pushes a[key]; false, and nothing pushed, when it is nil. */
static bool get(const struct at *a, const char *key)
{
    luaL_checkstack(a->lua, 8, NULL);
    lua_pushstring(a->lua, key);
    if (lua_rawget(a->lua, a->index) != LUA_TNIL)
        return true;
    lua_pop(a->lua, 1);
    return false;
}

/* a[key] as a table, left on the stack; false when it is nil. */
static bool get_table(const struct at *a, const char *key, struct at *out)
{
    if (!get(a, key))
        return false;
    *out = (struct at){ a->lua, lua_gettop(a->lua), "" };
    path_of(a, key, out->path);
    if (!lua_istable(a->lua, -1))
        bad(a->lua, out->path, "expected a table, got %s", got(a->lua));
    return true;
}

/* The value on top as a whole number; popped. */
static int64_t to_whole(lua_State *lua, const char *path, int64_t lo, int64_t hi)
{
    int whole = 0;
    int64_t v = lua_type(lua, -1) == LUA_TNUMBER ? lua_tointegerx(lua, -1, &whole) : 0;

    if (!whole || v < lo || v > hi)
        bad(lua, path, "expected a whole number from %I to %I, got %s", (LUAI_UACINT)lo, (LUAI_UACINT)hi, got(lua));
    lua_pop(lua, 1);
    return v;
}

/* a[key] into *v, which stays when it is nil. */
static void get_whole(const struct at *a, const char *key, int32_t lo, int32_t hi, int32_t *v)
{
    char path[MAX_PATH];

    path_of(a, key, path);
    if (get(a, key))
        *v = (int32_t)to_whole(a->lua, path, lo, hi);
}

static void need_whole(const struct at *a, const char *key, int32_t lo, int32_t hi, int32_t *v)
{
    char path[MAX_PATH];

    path_of(a, key, path);
    if (!get(a, key))
        lua_pushnil(a->lua);
    *v = (int32_t)to_whole(a->lua, path, lo, hi);
}

/* The value on top as a string of at most size - 1 bytes into out, the rest of it zeroed; popped. what: "a file", "a
 * word". */
static void to_text(lua_State *lua, const char *path, const char *what, char *out, size_t size)
{
    size_t n = 0;
    const char *s = lua_type(lua, -1) == LUA_TSTRING ? lua_tolstring(lua, -1, &n) : NULL;

    if (s == NULL)
        bad(lua, path, "expected %s, got %s", what, got(lua));
    if (n >= size || strlen(s) != n)
        bad(lua, path, "expected %s of at most %d bytes, got %s", what, (int)size - 1, got(lua));
    memset(out, 0, size);
    memcpy(out, s, n);
    lua_pop(lua, 1);
}

static bool get_text(const struct at *a, const char *key, const char *what, char *out, size_t size)
{
    char path[MAX_PATH];

    path_of(a, key, path);
    if (!get(a, key))
        return false;
    to_text(a->lua, path, what, out, size);
    return true;
}

/* The value on top as the path of a file in the game's folder; popped. */
static void to_file(lua_State *lua, const char *path, char out[ART_FILE])
{
    to_text(lua, path, "a file", out, ART_FILE);
    if (!manifest_path_ok(out))
        bad(lua, path, "expected a file inside the folder (letters, digits, _ - . /), got \"%s\"", out);
}

static bool get_file(const struct at *a, const char *key, char out[ART_FILE])
{
    char path[MAX_PATH];

    path_of(a, key, path);
    if (!get(a, key))
        return false;
    to_file(a->lua, path, out);
    return true;
}

static size_t min_size(size_t a, size_t b)
{
    return a < b ? a : b;
}

/* Letters to change, add or drop to make b of a. Both shorter than 32. Unlike edit.h's distance: a swap counts two. */
static size_t distance(const char *a, const char *b)
{
    size_t row[32], n = strlen(b);

    for (size_t j = 0; j <= n; j++)
        row[j] = j;
    for (size_t i = 1; a[i - 1] != '\0'; i++) {
        size_t corner = row[0];
        row[0] = i;
        for (size_t j = 1; j <= n; j++) {
            size_t best = min_size(corner + (a[i - 1] != b[j - 1]), min_size(row[j], row[j - 1]) + 1);
            corner = row[j];
            row[j] = best;
        }
    }
    return row[n];
}

/* The name of the list nearest to word, or NULL: none is near. */
static const char *near(const char *word, const char *const *names)
{
    const char *best = NULL;
    size_t least = 3;

    for (; strlen(word) < 32 && *names != NULL; names++) {
        size_t d = distance(word, *names);
        if (d < least && d < strlen(word)) {
            least = d;
            best = *names;
        }
    }
    return best;
}

static _Noreturn void bad_name(const struct at *a, const char *key, const char *const *names)
{
    char path[MAX_PATH];
    const char *guess = near(key, names);

    path_of(a, key, path);
    if (guess == NULL)
        bad(a->lua, path, "unknown key");
    bad(a->lua, path, "unknown key (did you mean \"%s\"?)", guess);
}

static bool listed(const char *name, const char *const *names)
{
    while (*names != NULL && strcmp(*names, name) != 0)
        names++;
    return *names != NULL;
}

static bool is_listed(lua_State *lua, const char *key, const void *of)
{
    (void)lua;
    return key != NULL && listed(key, of);
}

/* Every key of a is one of names. */
static void only(const struct at *a, const char *const *names)
{
    if (!luakeys_push_stray(a->lua, a->index, is_listed, names))
        return;
    const char *key = luakeys_text(a->lua, -1);
    if (key == NULL)
        bad(a->lua, a->path[0] != '\0' ? a->path : "manifest", "expected only names as keys, got %s", got(a->lua));
    bad_name(a, key, names);
}

/* a is a list and nothing else; returns its length, at most max. */
static int list(const struct at *a, int max)
{
    lua_State *lua = a->lua;
    lua_Unsigned n = lua_rawlen(lua, a->index), keys = 0;

    for (lua_pushnil(lua); lua_next(lua, a->index) != 0; keys++)
        lua_pop(lua, 1);
    if (keys != n)
        bad(lua, a->path, "expected a list");
    if (n > (lua_Unsigned)max)
        bad(lua, a->path, "expected at most %d entries, got %d", max, (int)n);
    return (int)n;
}

/* Pushes a[i], i from 1; path gets "extends[2]". */
static void item(const struct at *a, int i, char path[MAX_PATH])
{
    snprintf(path, MAX_PATH, "%.100s[%d]", a->path, i);
    lua_rawgeti(a->lua, a->index, i);
}

/* The words of a list; returns how many. */
static int words(const struct at *a, char out[][MAX_WORD], int max)
{
    int n = list(a, max);

    for (int i = 0; i < n; i++) {
        char path[MAX_PATH];
        item(a, i + 1, path);
        to_text(a->lua, path, "a word", out[i], MAX_WORD);
        if (!manifest_word_ok(out[i]))
            bad(a->lua, path, "expected a word of letters, digits, _ and -, got \"%s\"", out[i]);
        for (int j = 0; j < i; j++)
            if (strcmp(out[i], out[j]) == 0)
                bad(a->lua, path, "duplicate \"%s\"", out[i]);
    }
    return n;
}

static bool is_name(lua_State *lua, const char *key, const void *size)
{
    (void)lua;
    return key != NULL && strlen(key) < *(const size_t *)size && manifest_path_ok(key);
}

static int by_name(const void *a, const void *b)
{
    return strcmp(a, b);
}

/* The keys of a, sorted, into the first bytes (a name) of an array of structs; returns how many. */
static int keys(const struct at *a, void *out, int max, size_t stride, size_t name_size)
{
    lua_State *lua = a->lua;
    char *name = out;
    int n = 0;

    if (luakeys_push_stray(lua, a->index, is_name, &name_size)) {
        if (luakeys_text(lua, -1) == NULL)
            bad(lua, a->path, "expected only names as keys, got %s", got(lua));
        to_text(lua, a->path, "a name", name, name_size);
        bad(lua, a->path, "\"%s\": expected a name of letters, digits, _ - . and /", name);
    }
    for (lua_pushnil(lua); lua_next(lua, a->index) != 0; n++, name += stride) {
        lua_pop(lua, 1);
        if (n == max)
            bad(lua, a->path, "expected at most %d entries", max);
        lua_pushvalue(lua, -1);
        to_text(lua, a->path, "a name", name, name_size);
    }
    qsort(out, (size_t)n, stride, by_name);
    return n;
}

static void read_texts(const struct at *root, struct manifest *m)
{
    get_text(root, "id", "a name", m->id, sizeof m->id);
    memset(m->title, 0, sizeof m->title);
    if (!get_text(root, "title", "a line", m->title, sizeof m->title))
        strcpy(m->title, m->id);
    get_text(root, "author", "a line", m->author, sizeof m->author);
    get_text(root, "entry", "a script's path", m->entry, sizeof m->entry);
}

/* a[key] as a number or a flag of the manifest into *v, which stays when it is nil. */
static void get_number(const struct at *a, const char *key, const struct manifest_number *f, int32_t *v)
{
    char path[MAX_PATH];

    if (!f->flag) {
        get_whole(a, key, f->lo, f->hi, v);
        return;
    }
    path_of(a, key, path);
    if (!get(a, key))
        return;
    if (!lua_isboolean(a->lua, -1))
        bad(a->lua, path, "expected true or false, got %s", got(a->lua));
    *v = lua_toboolean(a->lua, -1);
    lua_pop(a->lua, 1);
}

/* The numbers of one group ("board", "board.values", or "" for those of the whole manifest), and no other names in it
 * but `more` (may be NULL). parent: the table that the group's last word is a name of. */
static void read_numbers(const struct at *parent, const char *group, const char *more, struct manifest *m)
{
    const char *names[MANIFEST_NUMBERS + 2] = { NULL }, *last = strrchr(group, '.');
    size_t skip = strlen(group) + (group[0] != '\0');
    struct at a = *parent;
    int n = 0, top = lua_gettop(parent->lua);

    if (group[0] != '\0' && !get_table(parent, last != NULL ? last + 1 : group, &a))
        return;
    if (more != NULL)
        names[n++] = more;
    for (int i = 0; i < MANIFEST_NUMBERS; i++) {
        const struct manifest_number *f = &manifest_numbers[i];
        const char *dot = strrchr(f->name, '.');
        if ((dot != NULL ? (size_t)(dot - f->name) + 1 : 0) != skip || strncmp(f->name, group, strlen(group)) != 0)
            continue;
        names[n++] = f->name + skip;
        get_number(&a, f->name + skip, f, (int32_t *)(void *)((char *)m + f->offset));
    }
    if (group[0] != '\0')
        only(&a, names);
    lua_settop(parent->lua, top);
}

static void read_values(const struct at *root, struct manifest *m)
{
    struct at board;

    if (!get_table(root, "board", &board))
        return;
    read_numbers(&board, "board.values", NULL, m);
    lua_pop(root->lua, 1);
}

static void read_sizes(const struct at *root, struct manifest *m)
{
    read_numbers(root, "", NULL, m);
    read_numbers(root, "board", "values", m);
    read_values(root, m);
    read_numbers(root, "screen", NULL, m);
    m->field_w = m->field_h = 0; /* left out: to the screen's edge */
    read_numbers(root, "field", NULL, m);
    if (m->field_w == 0)
        m->field_w = m->screen_w - m->field_x;
    if (m->field_h == 0)
        m->field_h = m->screen_h - m->field_y;
}

static void read_extends(const struct at *root, struct manifest *m)
{
    struct at a;

    if (!get_table(root, "extends", &a))
        return;
    m->n_extends = list(&a, MAX_EXTENDS);
    for (int i = 0; i < m->n_extends; i++) {
        char path[MAX_PATH];
        item(&a, i + 1, path);
        m->extends[i] = to_whole(a.lua, path, i > 0 ? m->extends[i - 1] + 1 : 1, (int64_t)1 << 53);
    }
    lua_pop(a.lua, 1);
}

/* The index of a word, or -1. */
static int word_index(const char words_[][MAX_WORD], int n, const char *word)
{
    for (int i = 0; i < n; i++)
        if (strcmp(words_[i], word) == 0)
            return i;
    return -1;
}

static void read_difficulties(const struct at *root, struct manifest *m)
{
    struct at a;
    char word[MAX_WORD] = "normal";

    if (get_table(root, "difficulties", &a)) {
        memset(m->difficulties, 0, sizeof m->difficulties);
        m->n_difficulties = words(&a, m->difficulties, MAX_DIFFICULTIES);
        if (m->n_difficulties == 0)
            bad(a.lua, a.path, "expected at least one word");
        lua_pop(a.lua, 1);
    }
    bool given = get_text(root, "difficulty", "a word", word, sizeof word);
    m->difficulty = word_index((const char(*)[MAX_WORD])m->difficulties, m->n_difficulties, word);
    if (m->difficulty < 0 && given)
        bad(root->lua, "difficulty", "\"%s\" is not listed in difficulties", word);
    if (m->difficulty < 0)
        m->difficulty = 0;
}

static void read_dip(const struct at *a, struct dip *d)
{
    static const char *const names[] = { "min", "max", "default", NULL };

    if (lua_rawlen(a->lua, a->index) > 0) {
        d->values = words(a, d->value_name, MAX_DIP_VALUES);
        d->hi = d->values - 1;
        return;
    }
    only(a, names);
    d->number = true;
    need_whole(a, "min", INT32_MIN, INT32_MAX, &d->lo);
    need_whole(a, "max", d->lo, INT32_MAX, &d->hi);
    d->value = d->lo;
    get_whole(a, "default", d->lo, d->hi, &d->value);
}

static void read_dips(const struct at *root, struct manifest *m)
{
    struct at a, one;

    if (!get_table(root, "dip", &a))
        return;
    m->n_dips = keys(&a, m->dips, MAX_DIPS, sizeof m->dips[0], MAX_WORD);
    for (int i = 0; i < m->n_dips; i++) {
        get_table(&a, m->dips[i].name, &one);
        if (!manifest_word_ok(m->dips[i].name))
            bad(a.lua, one.path, "expected a name of letters, digits, _ and -");
        read_dip(&one, &m->dips[i]);
        lua_pop(a.lua, 1);
    }
    lua_pop(a.lua, 1);
}

static void read_palettes(const struct at *root, struct art *art)
{
    struct at a;

    get_file(root, "palette", art->palette);
    get_file(root, "font", art->font);
    get_file(root, "border", art->border);
    if (!get_table(root, "palettes", &a))
        return;
    art->n_palettes = keys(&a, art->palettes, MAX_ART_PALETTES, sizeof art->palettes[0], ART_NAME);
    for (int i = 0; i < art->n_palettes; i++) {
        get_file(&a, art->palettes[i].name, art->palettes[i].file);
        if (strcmp(art->palettes[i].name, "main") == 0)
            bad(a.lua, "palettes.main", "this name is already used by `palette`");
    }
    lua_pop(a.lua, 1);
}

/* The number of the rule for ramps that is on top; popped. */
static int32_t read_ramp(const struct at *a)
{
    static const char *const rules[] = { "add", "half", "max" };
    char path[MAX_PATH];

    path_of(a, "ramp", path);
    for (int32_t i = 0; i < 3; i++)
        if (lua_type(a->lua, -1) == LUA_TSTRING && strcmp(lua_tostring(a->lua, -1), rules[i]) == 0) {
            lua_pop(a->lua, 1);
            return -1 - i;
        }
    bad(a->lua, path, "expected \"add\", \"half\" or \"max\", got %s", got(a->lua));
    return 0;
}

/* "add", { mix = percent } or { ramp = rule }. */
static int32_t read_blend(const struct at *a, const char *name)
{
    static const char *const names[] = { "mix", "ramp", NULL };
    char path[MAX_PATH];
    struct at one;
    int32_t mix = 0;

    path_of(a, name, path);
    get(a, name);
    if (lua_type(a->lua, -1) == LUA_TSTRING && strcmp(lua_tostring(a->lua, -1), "add") == 0) {
        lua_pop(a->lua, 1);
        return 0;
    }
    if (!lua_istable(a->lua, -1))
        bad(a->lua, path, "expected \"add\", { mix = percent } or { ramp = rule }, got %s", got(a->lua));
    lua_pop(a->lua, 1);
    get_table(a, name, &one);
    only(&one, names);
    if (get(&one, "ramp")) {
        mix = read_ramp(&one);
        if (get(&one, "mix"))
            bad(a->lua, path, "expected mix or ramp, got both");
    } else
        need_whole(&one, "mix", 1, 99, &mix);
    lua_pop(a->lua, 1);
    return mix;
}

static void read_blends(const struct at *root, struct art *art)
{
    struct at a;

    if (!get_table(root, "blends", &a))
        return;
    art->n_blends = keys(&a, art->blends, MAX_ART_BLENDS, sizeof art->blends[0], ART_NAME);
    for (int i = 0; i < art->n_blends; i++)
        art->blends[i].mix = read_blend(&a, art->blends[i].name);
    lua_pop(a.lua, 1);
}

static bool get_flag(const struct at *a, const char *key)
{
    char path[MAX_PATH];
    bool v;

    path_of(a, key, path);
    if (!get(a, key))
        return false;
    if (!lua_isboolean(a->lua, -1))
        bad(a->lua, path, "expected true or false, got %s", got(a->lua));
    v = lua_toboolean(a->lua, -1);
    lua_pop(a->lua, 1);
    return v;
}

/* match = "index" or "colour"; where it says neither, as `usual`. */
static bool get_match(const struct at *a, bool usual)
{
    static const char *const ways[] = { "colour", "index" };
    char path[MAX_PATH];

    path_of(a, "match", path);
    if (!get(a, "match"))
        return usual;
    for (int i = 0; i < 2; i++)
        if (lua_type(a->lua, -1) == LUA_TSTRING && strcmp(lua_tostring(a->lua, -1), ways[i]) == 0) {
            lua_pop(a->lua, 1);
            return i == 1;
        }
    bad(a->lua, path, "expected \"colour\" or \"index\", got %s", got(a->lua));
}

/* palette = NAME: the picture is drawn in the colours of that one. */
static void get_palette(const struct at *a, const struct art *art, char name[ART_NAME])
{
    char path[MAX_PATH];

    path_of(a, "palette", path);
    if (!get_text(a, "palette", "a palette's name", name, ART_NAME) || strcmp(name, "main") == 0) {
        name[0] = '\0';
        return;
    }
    for (int i = 0; i < art->n_palettes; i++)
        if (strcmp(art->palettes[i].name, name) == 0)
            return;
    bad(a->lua, path, "\"%s\" is not listed in palettes", name);
}

/* cell = { w, h }, and what stands in the cells. */
static void read_cells(const struct at *a, struct art_font *f)
{
    struct at cell;
    char path[MAX_PATH];

    if (!get_table(a, "cell", &cell)) {
        if (get_text(a, "chars", "characters", f->chars, sizeof f->chars))
            bad(a->lua, a->path, "`chars` needs `cell = { w, h }`");
        return;
    }
    if (list(&cell, 2) != 2)
        bad(a->lua, cell.path, "expected { w, h }");
    item(&cell, 1, path);
    f->w = (int32_t)to_whole(a->lua, path, 1, 64);
    item(&cell, 2, path);
    f->h = (int32_t)to_whole(a->lua, path, 1, 64);
    lua_pop(a->lua, 1);
    if (!get_text(a, "chars", "characters", f->chars, sizeof f->chars))
        bad(a->lua, a->path, "expected `chars`, the characters of the cells from left to right and top to bottom");
}

static void read_fonts(const struct at *root, struct art *art)
{
    static const char *const names[] = { "file", "cell", "chars", "also", "fixed", "shadow", "match", NULL };
    struct at a, one;

    if (!get_table(root, "fonts", &a))
        return;
    art->n_fonts = keys(&a, art->fonts, MAX_ART_FONTS, sizeof art->fonts[0], ART_NAME);
    for (int i = 0; i < art->n_fonts; i++) {
        struct art_font *f = &art->fonts[i];
        get_table(&a, f->name, &one);
        only(&one, names);
        if (!get_file(&one, "file", f->file))
            bad(a.lua, one.path, "expected file=\"art/NAME.bdf\" or \"art/NAME.png\"");
        read_cells(&one, f);
        get_text(&one, "also", "characters", f->also, sizeof f->also);
        f->fixed = get_flag(&one, "fixed");
        f->shadow = get_flag(&one, "shadow");
        f->by_index = get_match(&one, art->by_index);
        lua_pop(a.lua, 1);
    }
    lua_pop(a.lua, 1);
}

static void read_sheets(const struct at *root, struct art *art)
{
    static const char *const names[] = { "file", "bank", "match", "palette", NULL };
    struct at a, one;

    if (!get_table(root, "sheets", &a))
        return;
    art->n_sheets = keys(&a, art->sheets, MAX_ART_SHEETS, sizeof art->sheets[0], ART_NAME);
    for (int i = 0; i < art->n_sheets; i++) {
        struct art_sheet *s = &art->sheets[i];
        get_table(&a, s->name, &one);
        only(&one, names);
        if (!get_file(&one, "file", s->file))
            bad(a.lua, one.path, "expected file=\"art/NAME.png\" (or .ase, .aseprite)");
        get_whole(&one, "bank", 0, 15, &s->bank);
        get_palette(&one, art, s->palette);
        s->by_index = get_match(&one, art->by_index);
        lua_pop(a.lua, 1);
    }
    lua_pop(a.lua, 1);
}

static int32_t sheet_index(const struct at *a, const struct art *art)
{
    char name[ART_NAME] = "", path[MAX_PATH];

    path_of(a, "sheet", path);
    if (!get_text(a, "sheet", "a sheet's name", name, sizeof name))
        bad(a->lua, path, "expected the name of a sheet, got nil");
    for (int i = 0; i < art->n_sheets; i++)
        if (strcmp(art->sheets[i].name, name) == 0)
            return i;
    bad(a->lua, path, "\"%s\" is not listed in sheets", name);
}

static void read_origin(const struct at *a, struct art_sprite *s)
{
    struct at o;
    char path[MAX_PATH];

    if (!get_table(a, "origin", &o))
        return;
    if (list(&o, 2) != 2)
        bad(a->lua, o.path, "expected { x, y }");
    item(&o, 1, path);
    s->ox = (int32_t)to_whole(a->lua, path, -1024, 1024);
    item(&o, 2, path);
    s->oy = (int32_t)to_whole(a->lua, path, -1024, 1024);
    s->origin = true;
    lua_pop(a->lua, 1);
}

bool art_is_ase(const char *file)
{
    const char *dot = strrchr(file, '.');

    return dot != NULL && (strcmp(dot, ".ase") == 0 || strcmp(dot, ".aseprite") == 0);
}

/* One whose sheet is a file of Aseprite's: what is not said here, its file says. */
static void read_tagged(const struct at *a, struct art_sprite *s)
{
    char path[MAX_PATH];

    get_text(a, "tag", "a tag's name", s->tag, sizeof s->tag);
    if (get(a, "frames")) {
        path_of(a, "frames", path);
        bad(a->lua, path, "sprites from an .ase file use all its frames; to choose some of them, use tag = \"NAME\"");
    }
    s->frames = s->every = 0;
    get_whole(a, "w", 1, 1024, &s->w);
    get_whole(a, "h", 1, 1024, &s->h);
    get_whole(a, "every", 1, 3600, &s->every);
}

static void read_cut(const struct at *a, struct art_sprite *s)
{
    char path[MAX_PATH];

    if (get(a, "tag")) {
        path_of(a, "tag", path);
        bad(a->lua, path, "only .ase and .aseprite files have tags");
    }
    need_whole(a, "w", 1, 1024, &s->w);
    need_whole(a, "h", 1, 1024, &s->h);
    get_whole(a, "frames", 1, 256, &s->frames);
    get_whole(a, "every", 1, 3600, &s->every);
}

static void read_sprite(const struct at *a, const struct art *art, struct art_sprite *s)
{
    static const char *const names[] = { "sheet", "x",         "y",      "w",     "h",   "frames",
                                         "every", "rotations", "origin", "sizes", "tag", NULL };

    only(a, names);
    s->sheet = sheet_index(a, art);
    s->frames = s->rotations = 1;
    s->every = 6;
    s->percent = 100;
    get_whole(a, "x", 0, 16383, &s->x);
    get_whole(a, "y", 0, 16383, &s->y);
    if (art_is_ase(art->sheets[s->sheet].file))
        read_tagged(a, s);
    else
        read_cut(a, s);
    get_whole(a, "rotations", 1, 256, &s->rotations);
    s->ox = s->w / 2;
    s->oy = s->h / 2;
    read_origin(a, s);
}

/* sizes = { 50, 150 }: sprites of their own, behind the others, named after it: orb_50, orb_150. */
static void read_sprite_sizes(const struct at *a, struct art *art, const struct art_sprite *s)
{
    struct at sizes;
    char path[MAX_PATH];

    if (!get_table(a, "sizes", &sizes))
        return;
    int n = list(&sizes, MAX_ART_SIZES);
    for (int i = 1; i <= n; i++) {
        item(&sizes, i, path);
        int percent = (int)to_whole(a->lua, path, 1, 1000);
        if (art->n_sprites == MAX_ART_SPRITES)
            bad(a->lua, path, "more than %d sprites", MAX_ART_SPRITES);
        struct art_sprite *more = &art->sprites[art->n_sprites++];
        *more = *s;
        more->percent = percent;
        if (snprintf(more->name, ART_NAME, "%s_%d", s->name, percent) >= ART_NAME)
            bad(a->lua, path, "sprite name %s_%d is longer than %d bytes", s->name, percent, ART_NAME - 1);
    }
    lua_pop(a->lua, 1);
}

/* Puts the sprites from `first` on among those before them, by name. */
static void sort_sprites(lua_State *lua, struct art *art, int first)
{
    struct art_sprite *s = art->sprites;

    for (int i = first; i < art->n_sprites; i++) {
        struct art_sprite one = s[i];
        int at = i;
        for (; at > 0 && strcmp(s[at - 1].name, one.name) > 0; at--)
            s[at] = s[at - 1];
        s[at] = one;
        if (at > 0 && strcmp(s[at - 1].name, one.name) == 0)
            bad(lua, "sprites", "two sprites are named %s; one of them gets this name from `sizes`", one.name);
    }
}

static void read_sprites(const struct at *root, struct art *art)
{
    struct at a, one;

    if (!get_table(root, "sprites", &a))
        return;
    art->n_sprites = keys(&a, art->sprites, MAX_ART_SPRITES, sizeof art->sprites[0], ART_NAME);
    const int n = art->n_sprites;
    for (int i = 0; i < n; i++) {
        get_table(&a, art->sprites[i].name, &one);
        read_sprite(&one, art, &art->sprites[i]);
        read_sprite_sizes(&one, art, &art->sprites[i]);
        lua_pop(a.lua, 1);
    }
    sort_sprites(a.lua, art, n);
    lua_pop(a.lua, 1);
}

/* One row of a map's numbers. */
static void read_row(const struct at *rows, int i, int first, struct art *art, struct art_map *map)
{
    struct at row = { rows->lua, 0, "" };
    char path[MAX_PATH];

    item(rows, i, row.path);
    if (!lua_istable(rows->lua, -1))
        bad(rows->lua, row.path, "expected a list of tiles, got %s", got(rows->lua));
    row.index = lua_gettop(rows->lua);
    const int n = list(&row, MAX_ART_CELLS);
    if (i == 1)
        map->cols = n;
    if (n != map->cols || n == 0)
        bad(rows->lua, row.path, "expected %d tiles, as in the first row, got %d", map->cols > 0 ? map->cols : 1, n);
    if (n > MAX_ART_CELLS - art->n_cells)
        bad(rows->lua, row.path, "more than %d tiles in rom.lua; use a map file instead", MAX_ART_CELLS);
    for (int k = 1; k <= n; k++) {
        item(&row, k, path);
        art->cells[art->n_cells++] = (uint16_t)(to_whole(rows->lua, path, first - 1, 65534) - first + 1);
    }
    lua_pop(rows->lua, 1);
}

static void read_rows(const struct at *a, struct art *art, struct art_map *map)
{
    struct at rows;

    if (!get_table(a, "rows", &rows))
        return;
    map->cells = art->n_cells;
    map->rows = list(&rows, MAX_ART_CELLS);
    for (int i = 1; i <= map->rows; i++)
        read_row(&rows, i, map->first, art, map);
    if (map->rows == 0)
        bad(a->lua, rows.path, "expected at least one row");
    lua_pop(a->lua, 1);
}

static bool ends(const char *s, const char *tail)
{
    size_t n = strlen(s), m = strlen(tail);

    return n > m && strcmp(s + n - m, tail) == 0;
}

/* A picture, or a list of them. */
static void read_tiles(const struct at *a, struct art_map *map)
{
    char path[MAX_PATH];
    struct at pictures;

    if (!get(a, "tiles"))
        bad(a->lua, a->path, "expected tiles=\"art/NAME.png\"");
    const bool several = lua_istable(a->lua, -1);
    lua_pop(a->lua, 1);
    if (!several) {
        get_file(a, "tiles", map->tiles[0]);
        map->n_tiles = 1;
        return;
    }
    get_table(a, "tiles", &pictures);
    map->n_tiles = list(&pictures, ART_TILES);
    for (int i = 0; i < map->n_tiles; i++) {
        item(&pictures, i + 1, path);
        to_file(a->lua, path, map->tiles[i]);
    }
    if (map->n_tiles == 0)
        bad(a->lua, pictures.path, "expected at least one picture");
    lua_pop(a->lua, 1);
}

static void read_map(const struct at *a, struct art *art, struct art_map *map)
{
    static const char *const names[] = { "tiles", "file",  "rows",  "layer",   "size",
                                         "bank",  "first", "match", "palette", NULL };
    char path[MAX_PATH];

    only(a, names);
    path_of(a, "size", path);
    map->first = 1;
    read_tiles(a, map);
    get_whole(a, "bank", 0, 15, &map->bank);
    get_palette(a, art, map->palette);
    map->by_index = get_match(a, art->by_index);
    get_whole(a, "size", 8, 32, &map->size);
    get_whole(a, "first", 0, 1, &map->first);
    get_text(a, "layer", "a layer's name", map->layer, sizeof map->layer);
    const bool file = get_file(a, "file", map->file), tmx = ends(map->file, ".tmx");
    if (file && !tmx && !ends(map->file, ".csv"))
        bad(a->lua, a->path, "file: expected a .csv or .tmx file, got \"%s\"", map->file);
    if (map->n_tiles > 1 && !tmx)
        bad(a->lua, a->path, "tiles: only a .tmx map can use tiles from several pictures");
    if (map->layer[0] != '\0' && !tmx)
        bad(a->lua, a->path, "layer: only a .tmx map has layers");
    if (map->size == 0 && !tmx)
        map->size = 16;
    if (map->size != 0 && map->size != 8 && map->size != 16 && map->size != 32)
        bad(a->lua, path, "expected 8, 16 or 32, got %d", (int)map->size);
    read_rows(a, art, map);
    if (file == (map->rows > 0))
        bad(a->lua, a->path, "expected either file=\"maps/NAME.tmx\" (or .csv) or rows={ { 1, 2, .. }, .. }");
}

/* A file, or one of the sprites. */
static void read_icon(const struct at *root, struct art *art)
{
    int i = 0;

    if (!get_text(root, "icon", "a file or a sprite's name", art->icon, sizeof art->icon))
        return;
    if (ends(art->icon, ".png")) {
        if (!manifest_path_ok(art->icon))
            bad(root->lua, "icon", "expected a file inside the folder (letters, digits, _ - . /), got \"%s\"",
                art->icon);
        return;
    }
    while (i < art->n_sprites && strcmp(art->sprites[i].name, art->icon) != 0)
        i++;
    if (i == art->n_sprites)
        bad(root->lua, "icon", "expected a .png file or the name of a sprite, got \"%s\"", art->icon);
}

/* Maps alone switch backgrounds on. */
static void read_maps(const struct at *root, struct manifest *m, struct art *art)
{
    struct at a, one;

    if (!get_table(root, "maps", &a))
        return;
    art->n_maps = keys(&a, art->maps, MAX_ART_MAPS, sizeof art->maps[0], ART_NAME);
    for (int i = 0; i < art->n_maps; i++) {
        get_table(&a, art->maps[i].name, &one);
        read_map(&one, art, &art->maps[i]);
        lua_pop(a.lua, 1);
    }
    m->bg = m->bg || art->n_maps > 0;
    lua_pop(a.lua, 1);
}

/* A part of one as a number from 0 to 255. */
/* A share, of 255. */
static int32_t get_share(const struct at *a, const char *key, int32_t usual)
{
    char path[MAX_PATH];

    path_of(a, key, path);
    if (!get(a, key))
        return usual;
    const lua_Number v = lua_type(a->lua, -1) == LUA_TNUMBER ? lua_tonumber(a->lua, -1) : -1;
    if (!(v >= 0 && v <= 1))
        bad(a->lua, path, "expected a number from 0 to 1, got %s", got(a->lua));
    lua_pop(a->lua, 1);
    return (int32_t)(v * 255 + 0.5);
}

/* The value on top as a number; popped. */
static double to_real(lua_State *lua, const char *path, double lo, double hi)
{
    const lua_Number v = lua_type(lua, -1) == LUA_TNUMBER ? lua_tonumber(lua, -1) : lo - 1;

    if (!(v >= lo && v <= hi))
        bad(lua, path, "expected a number from %d to %d, got %s", (int)lo, (int)hi, got(lua));
    lua_pop(lua, 1);
    return v;
}

static bool get_real(const struct at *a, const char *key, double lo, double hi, double *v)
{
    char path[MAX_PATH];

    path_of(a, key, path);
    if (!get(a, key))
        return false;
    *v = to_real(a->lua, path, lo, hi);
    return true;
}

enum { LONGEST = 1 << 30 /* frames */ };

static void read_loop_table(const struct at *a, struct art_loop *loop)
{
    static const char *const names[] = { "start", "length", "unit", NULL };
    char unit[16] = "frames";

    only(a, names);
    loop->kind = LOOP_GIVEN;
    get_text(a, "unit", "a word", unit, sizeof unit);
    loop->seconds = strcmp(unit, "seconds") == 0;
    if (!loop->seconds && strcmp(unit, "frames") != 0)
        bad(a->lua, a->path, "unit: expected \"frames\" or \"seconds\", got \"%s\"", unit);
    get_real(a, "start", 0, LONGEST, &loop->start);
    get_real(a, "length", 0, LONGEST, &loop->length);
    if (!loop->seconds && (loop->start != (int32_t)loop->start || loop->length != (int32_t)loop->length))
        bad(a->lua, a->path, "expected whole numbers of frames (or unit=\"seconds\")");
}

/* true: all of it; false: once; or where it begins and how long it is. */
static void read_loop(const struct at *a, struct art_loop *loop)
{
    struct at table;

    if (get(a, "loop") && lua_isboolean(a->lua, -1)) {
        loop->kind = lua_toboolean(a->lua, -1) ? LOOP_WHOLE : LOOP_NONE;
        lua_pop(a->lua, 1);
    } else if (get_table(a, "loop", &table)) {
        read_loop_table(&table, loop);
        lua_pop(a->lua, 2);
    }
}

static void read_markers(const struct at *a, struct art_sound *s, struct art *art)
{
    struct at table;
    const int room = MAX_ART_MARKERS - art->n_markers;

    if (!get_table(a, "markers", &table))
        return;
    s->first_marker = art->n_markers;
    s->n_markers = keys(&table, art->markers + art->n_markers, room < MAX_MARKERS ? room : MAX_MARKERS,
                        sizeof art->markers[0], ART_NAME);
    for (int i = 0; i < s->n_markers; i++)
        get_real(&table, art->markers[s->first_marker + i].name, 0, 1 << 20, &art->markers[s->first_marker + i].beat);
    art->n_markers += s->n_markers;
    lua_pop(a->lua, 1);
}

/* What is said of a recording's beat. */
static void read_beat(const struct at *a, struct art_sound *s, struct art *art)
{
    double tempo = 0;

    get_real(a, "tempo", 10, 600, &tempo);
    s->tempo = (int32_t)(tempo * 100 + 0.5);
    s->bar = 4;
    get_whole(a, "bar", 1, 64, &s->bar);
    get_real(a, "offset", 0, 300, &s->offset);
    read_markers(a, s, art);
}

bool art_is_recording(const char *file)
{
    static const char *const tails[] = { ".wav", ".ogg", ".oga", ".opus", ".flac", ".xm", ".it", ".s3m", ".mod", NULL };

    for (int i = 0; tails[i]; i++)
        if (ends(file, tails[i]))
            return true;
    return false;
}

/* What a recording alone has, given of something else. */
static void only_of_recordings(const struct at *a)
{
    static const char *const names[] = { "exact", "stereo", "loop", "tempo", "bar", "offset", "markers", NULL };

    for (int i = 0; names[i]; i++)
        if (get(a, names[i]))
            bad(a->lua, a->path, "%s: only for samples (.wav, .ogg, .flac); MML has its own commands for it", names[i]);
}

/* A sound's or a piece's file is a recording or MML. */
static void read_sound(const struct at *a, struct art_sound *s, bool music, struct art *art)
{
    static const char *const of_sound[] = { "file", "mml",   "volume", "priority", "limit",
                                            "duck", "exact", "stereo", "loop",     NULL };
    static const char *const of_music[] = { "file",  "volume", "title",  "exact",   "stereo", "loop",
                                            "tempo", "bar",    "offset", "markers", NULL };

    only(a, music ? of_music : of_sound);
    s->priority = 4;
    s->limit = 2;
    s->volume = get_share(a, "volume", 255);
    s->duck = get_share(a, "duck", 0);
    const bool file = get_file(a, "file", s->file), mml = get_text(a, "mml", "MML", s->mml, sizeof s->mml);
    const bool recording = file && art_is_recording(s->file);
    get_text(a, "title", "a line", s->title, sizeof s->title);
    get_whole(a, "priority", 0, 7, &s->priority);
    get_whole(a, "limit", 1, 8, &s->limit);
    if (music && !recording && !(file && ends(s->file, ".mml")))
        bad(a->lua, a->path, "expected file=\"music/NAME.mml\" (or .ogg, .flac, .wav)");
    if (file == mml || (file && !recording && !ends(s->file, ".mml")))
        bad(a->lua, a->path, "expected either file=\"sfx/NAME.wav\" (or .ogg, .flac, .mml) or mml=\"...\"");
    if (!recording)
        only_of_recordings(a);
    s->exact = get_flag(a, "exact");
    s->stereo = music;
    if (get(a, "stereo")) {
        lua_pop(a->lua, 1);
        s->stereo = get_flag(a, "stereo");
    }
    read_loop(a, &s->loop);
    read_beat(a, s, art);
}

/* Returns how many there are. */
static int read_sound_list(const struct at *root, const char *key, struct art_sound *list_, int most, struct art *art)
{
    struct at a, one;

    if (!get_table(root, key, &a))
        return 0;
    const int n = keys(&a, list_, most, sizeof *list_, ART_NAME);
    for (int i = 0; i < n; i++) {
        get_table(&a, list_[i].name, &one);
        read_sound(&one, &list_[i], strcmp(key, "music") == 0, art);
        lua_pop(a.lua, 1);
    }
    lua_pop(a.lua, 1);
    return n;
}

/* Sounds and music alone switch sound on. */
static void read_sounds(const struct at *root, struct manifest *m, struct art *art)
{
    art->n_sounds = read_sound_list(root, "sounds", art->sounds, MAX_ART_SOUNDS, art);
    art->n_tunes = read_sound_list(root, "music", art->tunes, MAX_ART_TUNES, art);
    m->sound = m->sound || art->n_sounds > 0 || art->n_tunes > 0;
}

static void read_root(const struct at *root, struct manifest *m, struct art *art)
{
    static const char *const names[] = { "id",           "title",      "author",  "version",  "entry",   "screen",
                                         "field",        "board",      "palette", "palettes", "blends",  "font",
                                         "fonts",        "sheets",     "sprites", "dip",      "players", "extends",
                                         "difficulties", "difficulty", "maps",    "sounds",   "music",   "border",
                                         "match",        "icon",       NULL };

    only(root, names);
    read_texts(root, m);
    read_sizes(root, m);
    read_extends(root, m);
    read_difficulties(root, m);
    read_dips(root, m);
    art->by_index = get_match(root, false);
    read_palettes(root, art);
    read_blends(root, art);
    read_fonts(root, art);
    read_sheets(root, art);
    read_sprites(root, art);
    read_icon(root, art);
    read_maps(root, m, art);
    read_sounds(root, m, art);
}

static void too_long(lua_State *lua, lua_Debug *ar)
{
    lua_getinfo(lua, "Sl", ar);
    lua_pushfstring(lua, "%s:%d: takes too long (an endless loop?)", ar->short_src, ar->currentline);
    lua_error(lua);
}

/* Runs the text and reads what it returns; the one function called from C, protected. */
static int run(lua_State *lua)
{
    struct reader *r = lua_touserdata(lua, 1);
    char chunk[64];

    snprintf(chunk, sizeof chunk, "@%s", r->file);
    if (luaL_loadbufferx(lua, r->text, r->n, chunk, "t") != LUA_OK)
        return lua_error(lua);
    lua_sethook(lua, too_long, LUA_MASKCOUNT, MAX_STEPS);
    lua_call(lua, 0, 1);
    lua_sethook(lua, NULL, 0, 0);
    struct at root = { lua, lua_gettop(lua), "" };
    if (!lua_istable(lua, -1))
        bad(lua, r->file, "expected `return { ... }`, got %s", got(lua));
    read_root(&root, r->m, r->art);
    return 0;
}

struct memory {
    struct heap *heap;
    lua_State *lua; /* NULL: not made yet */
    int line;       /* of the text, where memory last ran out; 0: elsewhere */
};

/* After running out, the stack is gone. */
static void note_line(struct memory *m)
{
    lua_Debug ar;

    m->line = 0;
    for (int level = 0; m->lua != NULL && m->line <= 0 && lua_getstack(m->lua, level, &ar); level++) {
        lua_getinfo(m->lua, "l", &ar);
        m->line = ar.currentline;
    }
}

/* lua_Alloc over the block. When p is NULL, old is the kind of thing to be made. */
static void *allocate(void *memory, void *p, size_t old, size_t size)
{
    struct memory *m = memory;
    bool more = (p == NULL || size > old) && size > 0;
    bool refused = p == NULL && old == LUA_TSTRING && size > MAX_STRING + 64;
    void *q = NULL;

    if (!refused && !(more && heap_work(m->heap) > MAX_WORK))
        q = heap_realloc(m->heap, p, p == NULL ? 0 : old, size);
    if (q == NULL && more)
        note_line(m);
    return q;
}

/* The message of a failed run, with the file's name in front where Lua has not put it. */
static void explain(lua_State *lua, int status, int line, const char *file, char *err, size_t err_size)
{
    const char *message = lua_tostring(lua, -1);
    size_t n = strlen(file);

    if (status == LUA_ERRMEM && line > 0)
        snprintf(err, err_size, "%s:%d: needs too much memory", file, line);
    else if (status == LUA_ERRMEM)
        snprintf(err, err_size, "%s: needs too much memory", file);
    else if (message == NULL)
        snprintf(err, err_size, "%s: cannot be read", file);
    else if (strncmp(message, file, n) == 0 && message[n] == ':')
        snprintf(err, err_size, "%s", message);
    else
        snprintf(err, err_size, "%s: %s", file, message);
    utf8_blank(err, false); /* a sentence stays one line, whatever the text quotes */
}

/* A folder's name as an id: lower case, _ for what an id may not hold. */
static void id_from(const char *folder, char id[32])
{
    size_t i = 0;

    for (; i < 31 && folder[i] != '\0'; i++) {
        char c = folder[i] >= 'A' && folder[i] <= 'Z' ? (char)(folder[i] + 32) : folder[i];
        id[i] = (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') ? c : '_';
    }
    memset(id + i, 0, 32 - i);
}

/* Runs the text; false and one sentence when it is no manifest. */
static bool read_text(struct reader *r, void *work, char *err, size_t err_size)
{
    struct memory memory = { heap_init(work, MANIFEST_WORK), NULL, 0 };
    lua_State *lua = lua_newstate(allocate, &memory);

    memory.lua = lua;
    lua_pushcfunction(lua, run);
    lua_pushlightuserdata(lua, r);
    int status = lua_pcall(lua, 1, 0, 0);
    if (status != LUA_OK)
        explain(lua, status, memory.line, r->file, err, err_size);
    lua_close(lua);
    return status == LUA_OK;
}

bool manifest_read(const char *text, size_t n, const char *file, const char *folder, struct manifest *m,
                   struct art *art, void *work, char *err, size_t err_size)
{
    struct reader r = { text, n, file, m, art };
    struct host host;
    char why[256];

    manifest_default(m);
    if (folder[0] != '\0')
        id_from(folder, m->id);
    memset(art, 0, sizeof *art);
    if (n > MAX_FILE) {
        snprintf(err, err_size, "%s: longer than %d bytes", file, MAX_FILE);
        return false;
    }
    host_enter(&host);
    bool good = read_text(&r, work, err, err_size);
    host_leave(&host);
    if (!good || manifest_check(m, why, sizeof why))
        return good;
    snprintf(err, err_size, "%s: %s", file, why);
    return false;
}
