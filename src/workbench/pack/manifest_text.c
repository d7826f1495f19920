/*
 * manifest_text.c - manifest_read of manifest.h: runs rom.lua in a Lua state without any functions.
 *
 * The state uses the caller's block of memory. Four limits bound it: the size of the block, the length of a string (so
 * that no single instruction is slow), the total of allocated bytes, and the number of instructions. Errors are Lua
 * errors up to a single pcall; code in rom.lua cannot catch them.
 */
#include "manifest_parts.h"

#include <lauxlib.h>
#include <stdio.h>
#include <string.h>
#include "../../../fb/utf8.h"
#include "../../base/heap.h"
#include "../../base/host.h"

enum {
    MAX_FILE = 1 << 20,   /* bytes of rom.lua */
    MAX_STRING = 1 << 14, /* bytes of a string */
    MAX_WORK = 256 << 20, /* total of bytes allocated while it runs */
    MAX_STEPS = 1 << 20   /* VM instructions */
};

struct reader {
    const char *text;
    size_t n;
    const char *file;
    struct manifest *m;
    struct art *art;
};

/* Reads the numbers of a table: those of "board" are "board.bullets" and so on, but not "board.values.shot". table_key:
 * a key whose value is a table; NULL: none. */
static void read_numbers(const struct manifest_value *table, const char *table_key, struct manifest *m)
{
    const char *const others[] = { table_key, NULL };
    struct manifest_field fields[MANIFEST_NUMBERS];
    const bool is_root = table->path[0] == '\0';
    const size_t skip = is_root ? 0 : strlen(table->path) + 1;
    size_t n = 0;

    for (int i = 0; i < MANIFEST_NUMBERS; i++) {
        const struct manifest_number *f = &manifest_numbers[i];
        const char *dot = strrchr(f->name, '.'), *key = dot != NULL ? dot + 1 : f->name;
        if (key == f->name + skip && strncmp(f->name, table->path, strlen(table->path)) == 0)
            fields[n++] = (struct manifest_field){
                key, f->is_flag ? FIELD_FLAG : FIELD_WHOLE, f->offset, sizeof(int32_t), f->lo, f->hi, NULL
            };
    }
    if (!is_root)
        value_check_keys(table, fields, n, others);
    value_read_fields(table, fields, n, m);
}

/* Reads the numbers of the table `key` of rom.lua, and those of its table `inner`. */
static void read_table(const struct manifest_value *root, const char *key, const char *inner, struct manifest *m)
{
    struct manifest_value table, inner_table;

    if (!value_get_table(root, key, &table))
        return;
    read_numbers(&table, inner, m);
    if (value_get_table(&table, inner, &inner_table))
        read_numbers(&inner_table, NULL, m);
}

static void read_sizes(const struct manifest_value *root, struct manifest *m)
{
    struct manifest_value table;

    read_numbers(root, NULL, m);
    read_table(root, "board", "values", m);
    if (value_get_table(root, "screen", &table))
        read_numbers(&table, NULL, m);
    m->field_w = m->field_h = 0; /* omitted: up to the screen's edge */
    read_table(root, "field", "view", m);
    if (m->field_w == 0)
        m->field_w = (m->screen_w - m->field_x) / m->zoom;
    if (m->field_h == 0)
        m->field_h = (m->screen_h - m->field_y) / m->zoom;
    const int32_t w = m->view_w ? m->view_w : m->field_w, h = m->view_h ? m->view_h : m->field_h;
    const bool is_whole = w == m->field_w && h == m->field_h;
    m->view_w = is_whole ? 0 : w;
    m->view_h = is_whole ? 0 : h;
}

static void read_extends(const struct manifest_value *root, struct manifest *m)
{
    struct manifest_value list, v;

    if (!value_get_table(root, "extends", &list))
        return;
    m->n_extends = value_to_length(&list, MAX_EXTENDS);
    for (int i = 0; i < m->n_extends; i++) {
        value_get_item(&list, i + 1, &v);
        m->extends[i] = value_to_whole(&v, i > 0 ? m->extends[i - 1] + 1 : 1, (int64_t)1 << 53);
    }
}

static void read_difficulties(const struct manifest_value *root, struct manifest *m)
{
    struct manifest_value v;
    char word[MAX_SETTING_NAME] = "normal";

    if (value_get_table(root, "difficulties", &v)) {
        memset(m->difficulties, 0, sizeof m->difficulties);
        m->n_difficulties = value_to_words(&v, m->difficulties, MAX_DIFFICULTIES);
        if (m->n_difficulties == 0)
            value_fail(&v, "expected at least one word");
    }
    const bool is_given = value_get(root, "difficulty", &v);
    if (is_given)
        value_to_text(&v, "a word", word, sizeof word);
    while (m->difficulty < m->n_difficulties && strcmp(m->difficulties[m->difficulty], word) != 0)
        m->difficulty++;
    if (m->difficulty < m->n_difficulties)
        return;
    if (is_given)
        value_fail(&v, "\"%s\" is not listed in difficulties", word);
    m->difficulty = 0;
}

static void read_dip(const struct manifest_value *v, struct dip *d)
{
    static const char *const others[] = { "min", "max", "default", NULL };
    struct manifest_value usual;

    value_check_table(v);
    if (!manifest_setting_name_ok(d->name))
        value_fail(v, "expected a name of letters, digits, _ and -");
    if (lua_rawlen(v->lua, v->index) > 0) {
        d->n_values = value_to_words(v, d->value_name, MAX_DIP_VALUES);
        d->hi = d->n_values - 1;
        return;
    }
    value_check_keys(v, NULL, 0, others);
    d->is_number = true;
    d->lo = value_get_whole(v, "min", INT32_MIN, INT32_MAX);
    d->hi = value_get_whole(v, "max", d->lo, INT32_MAX);
    d->default_value = value_get(v, "default", &usual) ? (int32_t)value_to_whole(&usual, d->lo, d->hi) : d->lo;
}

static void read_dips(const struct manifest_value *root, struct manifest *m)
{
    struct manifest_value table, v;

    if (!value_get_table(root, "dip", &table))
        return;
    m->n_dips = value_to_names(&table, m->dips, MAX_DIPS, sizeof m->dips[0], MAX_SETTING_NAME);
    for (int i = 0; i < m->n_dips; i++) {
        value_get(&table, m->dips[i].name, &v);
        read_dip(&v, &m->dips[i]);
    }
}

static void read_root(const struct manifest_value *root, struct manifest *m, struct art *art)
{
    static const struct manifest_field fields[] = {
        TEXT("id", manifest, id, "a name"),
        TEXT("title", manifest, title, "a line"),
        TEXT("author", manifest, author, "a line"),
        TEXT("entry", manifest, entry, "a script's path"),
    };
    static const char *const others[] = { "version",    "players",  "screen", "field",    "board",
                                          "palette",    "palettes", "blends", "font",     "fonts",
                                          "sheets",     "sprites",  "dip",    "extends",  "difficulties",
                                          "difficulty", "maps",     "sounds", "music",    "border",
                                          "match",      "icon",     "theme",  "practice", NULL };
    struct manifest_value v;

    READ_TABLE(root, fields, others, m);
    if (!value_get(root, "title", &v)) {
        memset(m->title, 0, sizeof m->title);
        strcpy(m->title, m->id);
    }
    read_sizes(root, m);
    read_extends(root, m);
    read_difficulties(root, m);
    read_dips(root, m);
    manifest_read_art(root, art);
    m->has_backgrounds |= art->n_maps > 0;
    m->has_sound |= art->n_sounds + art->n_tunes > 0;
}

static void fail_too_long(lua_State *lua, lua_Debug *ar)
{
    lua_getinfo(lua, "Sl", ar);
    lua_pushfstring(lua, "%s:%d: takes too long (an endless loop?)", ar->short_src, ar->currentline);
    lua_error(lua);
}

/* Runs the text and reads the table it returns. Called with lua_pcall. */
static int run(lua_State *lua)
{
    struct reader *r = lua_touserdata(lua, 1);
    char chunk[64];

    snprintf(chunk, sizeof chunk, "@%s", r->file);
    if (luaL_loadbufferx(lua, r->text, r->n, chunk, "t") != LUA_OK)
        return lua_error(lua);
    lua_sethook(lua, fail_too_long, LUA_MASKCOUNT, MAX_STEPS);
    lua_call(lua, 0, 1);
    lua_sethook(lua, NULL, 0, 0);
    struct manifest_value root = { lua, lua_gettop(lua), "" };
    if (!lua_istable(lua, root.index)) {
        snprintf(root.path, sizeof root.path, "%s", r->file);
        value_fail(&root, "expected `return { ... }`, got %s", value_describe(&root));
    }
    read_root(&root, r->m, r->art);
    return 0;
}

struct memory {
    struct heap *heap;
    lua_State *lua; /* NULL: not made yet */
    int line;       /* of the text at which memory last ran out; 0: elsewhere */
};

/* Notes the current line now, because after the error the stack has been unwound. */
static void note_line(struct memory *m)
{
    lua_Debug ar;

    m->line = 0;
    for (int level = 0; m->lua != NULL && m->line <= 0 && lua_getstack(m->lua, level, &ar); level++) {
        lua_getinfo(m->lua, "l", &ar);
        m->line = ar.currentline;
    }
}

/* A lua_Alloc that uses the block. If p is NULL, `old` is the type of the new object. */
static void *allocate(void *memory, void *p, size_t old, size_t size)
{
    struct memory *m = memory;
    bool grows = (p == NULL || size > old) && size > 0;
    bool refused = p == NULL && old == LUA_TSTRING && size > MAX_STRING + 64;
    void *q = NULL;

    if (!refused && !(grows && heap_work(m->heap) > MAX_WORK))
        q = heap_realloc(m->heap, p, p == NULL ? 0 : old, size);
    if (q == NULL && grows)
        note_line(m);
    return q;
}

/* Writes the message of a failed run, and adds the file's name unless Lua has added it. */
static void write_error(lua_State *lua, int status, int line, const char *file, char *err, size_t err_size)
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
    utf8_replace_hidden(err, false); /* a message is one line, whatever it quotes */
}

/* Converts a folder's name to an id: lower case, with _ for characters that are not allowed. */
static void make_id(const char *folder, char id[32])
{
    size_t i = 0;

    for (; i < 31 && folder[i] != '\0'; i++) {
        char c = folder[i] >= 'A' && folder[i] <= 'Z' ? (char)(folder[i] + 32) : folder[i];
        id[i] = (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') ? c : '_';
    }
    memset(id + i, 0, 32 - i);
}

static bool read_text(struct reader *r, void *work, char *err, size_t err_size)
{
    struct memory memory = { heap_init(work, MANIFEST_SCRATCH_SIZE), NULL, 0 };
    lua_State *lua = lua_newstate(allocate, &memory);

    memory.lua = lua;
    lua_pushcfunction(lua, run);
    lua_pushlightuserdata(lua, r);
    int status = lua_pcall(lua, 1, 0, 0);
    if (status != LUA_OK)
        write_error(lua, status, memory.line, r->file, err, err_size);
    lua_close(lua);
    return status == LUA_OK;
}

bool manifest_read(const char *text, size_t n, const char *file, const char *folder, struct manifest *m,
                   struct art *art, void *work, char *err, size_t err_size)
{
    struct reader r = { text, n, file, m, art };
    struct host host;
    char why[256];

    manifest_set_defaults(m);
    if (folder[0] != '\0')
        make_id(folder, m->id);
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
