/*
 * manifest_text.c - manifest_read of manifest.h: rom.lua, read by Lua in a state that has no function to call.
 *
 * The state lives in the caller's block and dies with it. What bounds it: the block's size, the length of a string (so
 * that no one instruction is slow), the bytes ever allocated, and a count of instructions. Errors are Lua errors up to
 * the one pcall; none of the text's own code can catch one.
 */
#include "manifest_at.h"

#include <lauxlib.h>
#include <stdio.h>
#include <string.h>
#include "../../../fb/utf8.h"
#include "../../base/heap.h"
#include "../../base/host.h"
#include "../../common/files.h"

enum {
    MAX_FILE = 1 << 20,   /* bytes of rom.lua */
    MAX_STRING = 1 << 14, /* bytes of one string in it */
    MAX_WORK = 256 << 20, /* bytes ever allocated while it runs */
    MAX_STEPS = 1 << 20,  /* VM instructions */
    MAX_MARKERS = 64      /* of a recording */
};

struct reader {
    const char *text;
    size_t n;
    const char *file;
    struct manifest *m;
    struct art *art;
};

static void read_texts(const struct at *root, struct manifest *m)
{
    at_text(root, "id", "a name", m->id, sizeof m->id);
    memset(m->title, 0, sizeof m->title);
    if (!at_text(root, "title", "a line", m->title, sizeof m->title))
        strcpy(m->title, m->id);
    at_text(root, "author", "a line", m->author, sizeof m->author);
    at_text(root, "entry", "a script's path", m->entry, sizeof m->entry);
}

/* a[key] as a number or a flag of the manifest into *v, which stays when it is nil. */
static void get_number(const struct at *a, const char *key, const struct manifest_number *f, int32_t *v)
{
    char path[MAX_PATH];

    if (!f->is_flag) {
        at_whole(a, key, f->lo, f->hi, v);
        return;
    }
    at_path(a, key, path);
    if (!at_get(a, key))
        return;
    if (!lua_isboolean(a->lua, -1))
        at_bad(a->lua, path, "expected true or false, got %s", at_got(a->lua));
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

    if (group[0] != '\0' && !at_table(parent, last != NULL ? last + 1 : group, &a))
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
        at_only(&a, names);
    lua_settop(parent->lua, top);
}

static void read_values(const struct at *root, struct manifest *m)
{
    struct at board;

    if (!at_table(root, "board", &board))
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

    if (!at_table(root, "extends", &a))
        return;
    m->n_extends = at_list(&a, MAX_EXTENDS);
    for (int i = 0; i < m->n_extends; i++) {
        char path[MAX_PATH];
        at_item(&a, i + 1, path);
        m->extends[i] = at_to_whole(a.lua, path, i > 0 ? m->extends[i - 1] + 1 : 1, (int64_t)1 << 53);
    }
    lua_pop(a.lua, 1);
}

/* The index of a word, or -1. */
static int word_index(const char words_[][MAX_SETTING_NAME], int n, const char *word)
{
    for (int i = 0; i < n; i++)
        if (strcmp(words_[i], word) == 0)
            return i;
    return -1;
}

static void read_difficulties(const struct at *root, struct manifest *m)
{
    struct at a;
    char word[MAX_SETTING_NAME] = "normal";

    if (at_table(root, "difficulties", &a)) {
        memset(m->difficulties, 0, sizeof m->difficulties);
        m->n_difficulties = at_words(&a, m->difficulties, MAX_DIFFICULTIES);
        if (m->n_difficulties == 0)
            at_bad(a.lua, a.path, "expected at least one word");
        lua_pop(a.lua, 1);
    }
    bool given = at_text(root, "difficulty", "a word", word, sizeof word);
    m->difficulty = word_index((const char(*)[MAX_SETTING_NAME])m->difficulties, m->n_difficulties, word);
    if (m->difficulty < 0 && given)
        at_bad(root->lua, "difficulty", "\"%s\" is not listed in difficulties", word);
    if (m->difficulty < 0)
        m->difficulty = 0;
}

static void read_dip(const struct at *a, struct dip *d)
{
    static const char *const names[] = { "min", "max", "default", NULL };

    if (lua_rawlen(a->lua, a->index) > 0) {
        d->n_values = at_words(a, d->value_name, MAX_DIP_VALUES);
        d->hi = d->n_values - 1;
        return;
    }
    at_only(a, names);
    d->is_number = true;
    at_need_whole(a, "min", INT32_MIN, INT32_MAX, &d->lo);
    at_need_whole(a, "max", d->lo, INT32_MAX, &d->hi);
    d->default_value = d->lo;
    at_whole(a, "default", d->lo, d->hi, &d->default_value);
}

static void read_dips(const struct at *root, struct manifest *m)
{
    struct at a, one;

    if (!at_table(root, "dip", &a))
        return;
    m->n_dips = at_keys(&a, m->dips, MAX_DIPS, sizeof m->dips[0], MAX_SETTING_NAME);
    for (int i = 0; i < m->n_dips; i++) {
        at_table(&a, m->dips[i].name, &one);
        if (!manifest_setting_name_ok(m->dips[i].name))
            at_bad(a.lua, one.path, "expected a name of letters, digits, _ and -");
        read_dip(&one, &m->dips[i]);
        lua_pop(a.lua, 1);
    }
    lua_pop(a.lua, 1);
}

enum { LONGEST = 1 << 30 /* frames */ };

static void read_loop_table(const struct at *a, struct art_loop *loop)
{
    static const char *const names[] = { "start", "length", "unit", NULL };
    char unit[16] = "frames";

    at_only(a, names);
    loop->kind = LOOP_RANGE;
    at_text(a, "unit", "a word", unit, sizeof unit);
    loop->in_seconds = strcmp(unit, "seconds") == 0;
    if (!loop->in_seconds && strcmp(unit, "frames") != 0)
        at_bad(a->lua, a->path, "unit: expected \"frames\" or \"seconds\", got \"%s\"", unit);
    at_real(a, "start", 0, LONGEST, &loop->start);
    at_real(a, "length", 0, LONGEST, &loop->length);
    if (!loop->in_seconds && (loop->start != (int32_t)loop->start || loop->length != (int32_t)loop->length))
        at_bad(a->lua, a->path, "expected whole numbers of frames (or unit=\"seconds\")");
}

/* true: all of it; false: once; or where it begins and how long it is. */
static void read_loop(const struct at *a, struct art_loop *loop)
{
    struct at table;

    if (at_get(a, "loop") && lua_isboolean(a->lua, -1)) {
        loop->kind = lua_toboolean(a->lua, -1) ? LOOP_WHOLE : LOOP_NONE;
        lua_pop(a->lua, 1);
    } else if (at_table(a, "loop", &table)) {
        read_loop_table(&table, loop);
        lua_pop(a->lua, 2);
    }
}

static void read_markers(const struct at *a, struct art_sound *s, struct art *art)
{
    struct at table;
    const int room = MAX_ART_MARKERS - art->n_markers;

    if (!at_table(a, "markers", &table))
        return;
    s->first_marker = art->n_markers;
    s->n_markers = at_keys(&table, art->markers + art->n_markers, room < MAX_MARKERS ? room : MAX_MARKERS,
                           sizeof art->markers[0], ART_NAME_SIZE);
    for (int i = 0; i < s->n_markers; i++)
        at_real(&table, art->markers[s->first_marker + i].name, 0, 1 << 20, &art->markers[s->first_marker + i].beat);
    art->n_markers += s->n_markers;
    lua_pop(a->lua, 1);
}

/* What is said of a recording's beat. */
static void read_beat(const struct at *a, struct art_sound *s, struct art *art)
{
    double tempo = 0;

    at_real(a, "tempo", 10, 600, &tempo);
    s->tempo = (int32_t)(tempo * 100 + 0.5);
    s->beats_per_bar = 4;
    at_whole(a, "bar", 1, 64, &s->beats_per_bar);
    at_real(a, "offset", 0, 300, &s->offset);
    read_markers(a, s, art);
}

bool art_is_recording(const char *file)
{
    static const char *const tails[] = { ".wav", ".ogg", ".oga", ".opus", ".flac", ".xm", ".it", ".s3m", ".mod", NULL };

    for (int i = 0; tails[i]; i++)
        if (files_has_suffix(file, tails[i]))
            return true;
    return false;
}

/* What a recording alone has, given of something else. */
static void only_of_recordings(const struct at *a)
{
    static const char *const names[] = { "exact", "stereo", "loop", "tempo", "bar", "offset", "markers", NULL };

    for (int i = 0; names[i]; i++)
        if (at_get(a, names[i]))
            at_bad(a->lua, a->path, "%s: only for samples (.wav, .ogg, .flac); MML has its own commands for it",
                   names[i]);
}

/* A sound's or a piece's file is a recording or MML. */
static void read_sound(const struct at *a, struct art_sound *s, bool music, struct art *art)
{
    static const char *const of_sound[] = { "file", "mml",   "volume", "priority", "limit",
                                            "duck", "exact", "stereo", "loop",     NULL };
    static const char *const of_music[] = { "file",  "volume", "title",  "exact",   "stereo", "loop",
                                            "tempo", "bar",    "offset", "markers", NULL };

    at_only(a, music ? of_music : of_sound);
    s->priority = 4;
    s->limit = 2;
    s->volume = at_share(a, "volume", 255);
    s->duck = at_share(a, "duck", 0);
    const bool file = at_file(a, "file", s->file), mml = at_text(a, "mml", "MML", s->mml, sizeof s->mml);
    const bool recording = file && art_is_recording(s->file);
    at_text(a, "title", "a line", s->title, sizeof s->title);
    at_whole(a, "priority", 0, 7, &s->priority);
    at_whole(a, "limit", 1, 8, &s->limit);
    if (music && !recording && !(file && files_has_suffix(s->file, ".mml")))
        at_bad(a->lua, a->path, "expected file=\"music/NAME.mml\" (or .ogg, .flac, .wav)");
    if (file == mml || (file && !recording && !files_has_suffix(s->file, ".mml")))
        at_bad(a->lua, a->path, "expected either file=\"sfx/NAME.wav\" (or .ogg, .flac, .mml) or mml=\"...\"");
    if (!recording)
        only_of_recordings(a);
    s->exact = at_flag(a, "exact");
    s->stereo = music;
    if (at_get(a, "stereo")) {
        lua_pop(a->lua, 1);
        s->stereo = at_flag(a, "stereo");
    }
    read_loop(a, &s->loop);
    read_beat(a, s, art);
}

/* Returns how many there are. */
static int read_sound_list(const struct at *root, const char *key, struct art_sound *list_, int most, struct art *art)
{
    struct at a, one;

    if (!at_table(root, key, &a))
        return 0;
    const int n = at_keys(&a, list_, most, sizeof *list_, ART_NAME_SIZE);
    for (int i = 0; i < n; i++) {
        at_table(&a, list_[i].name, &one);
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
    m->has_sound = m->has_sound || art->n_sounds > 0 || art->n_tunes > 0;
}

static void read_root(const struct at *root, struct manifest *m, struct art *art)
{
    static const char *const names[] = { "id",           "title",      "author",  "version",  "entry",   "screen",
                                         "field",        "board",      "palette", "palettes", "blends",  "font",
                                         "fonts",        "sheets",     "sprites", "dip",      "players", "extends",
                                         "difficulties", "difficulty", "maps",    "sounds",   "music",   "border",
                                         "match",        "icon",       NULL };

    at_only(root, names);
    read_texts(root, m);
    read_sizes(root, m);
    read_extends(root, m);
    read_difficulties(root, m);
    read_dips(root, m);
    manifest_read_art(root, m, art);
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
        at_bad(lua, r->file, "expected `return { ... }`, got %s", at_got(lua));
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
    utf8_replace_hidden(err, false); /* a sentence stays one line, whatever the text quotes */
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
    struct memory memory = { heap_init(work, MANIFEST_SCRATCH_SIZE), NULL, 0 };
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

    manifest_set_defaults(m);
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
