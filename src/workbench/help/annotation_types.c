/*
 * annotation_types.c - see annotation_types.h. A word list becomes an alias of its own, so that completion offers the
 * words; a name that a game declares (a kind, a sprite) is an alias of string, so that an editor shows its purpose.
 */
#include "annotation_types.h"

#include <ctype.h>
#include <stdio.h>
#include <string.h>
#include "../../base/int.h"
#include "help_lua.h"

/* Indexed by type. NULL: more than one word. */
static const char *const types[] = {
    [A_INT] = "integer",
    [A_COUNT] = "integer",
    [A_NUM] = "number",
    [A_FX] = "number",
    [A_DIR] = "number",
    [A_SCALE] = "number",
    [A_STR] = "string",
    [A_BOOL] = "boolean",
    [A_FUNC] = "function",
    [A_TABLE] = "table",
    [A_ANY] = "any",
    [A_SPAN] = "integer[]",
    [A_ROUTE] = "route",
    [A_THING] = NULL,
    [A_HIT_SHAPE] = NULL,
    [A_MOTION] = "motion|motion_name",
    [A_BULLET_KIND] = "bullet_kind",
    [A_SHOT_KIND] = "shot_kind",
    [A_ENEMY_KIND] = "enemy_kind",
    [A_PLAYER_KIND] = "player_kind",
    [A_SPARK_KIND] = "spark_kind",
    [A_ITEM_KIND] = "item_kind",
    [A_LASER_KIND] = "laser_kind",
    [A_OPTION_KIND] = "option_kind",
    [A_SPRITE] = "sprite_name",
    [A_BLEND] = "blend_name",
    [A_FONT] = "font_name",
    [A_MAP] = "map_name",
    [A_SOUND] = "sound_name",
    [A_TUNE] = "music_name",
    [A_BUTTON] = "button_word",
    [A_PLAYER] = "player|1|2",
    [A_EASE] = "ease_word",
    [A_LAYER] = "layer_word",
    [A_SPARK_LAYER] = "spark_layer_word",
    [A_DEPTH] = "depth_word",
    [A_ALIGN] = "align_word",
    [A_FIRE] = "fire_word",
    [A_EMIT_FIRE] = "shoot_word",
    [A_MEET] = "meet_word",
    [A_EMIT_PATTERN] = "emit_word",
    [A_BARS_DOWN] = "down_word",
    [A_HOST_SCREEN] = "ask_word",
};

void annotation_aliases(struct byte_buffer *to)
{
    const char *const *words;
    int n;

    for (size_t t = 0; t < COUNT(types); t++) {
        words = api_get_type_words((enum api_type)t, &n);
        if (words) {
            byte_buffer_print(to, "---@alias %s ", types[t]);
            for (int i = 0; i < n; i++)
                byte_buffer_print(to, "%s\"%s\"", i ? "|" : "", words[i]);
            byte_buffer_print(to, "\n");
        } else if (t >= A_BULLET_KIND) {
            if (!strchr(types[t], '|'))
                byte_buffer_print(to, "---@alias %s string\n", types[t]);
        }
    }
    byte_buffer_print(to, "---@alias motion_name string\n");
    byte_buffer_print(to, "\n---a path that path.def returned\n---@class route\n");
}

/* Appends text to the n characters of out. Returns the new number of characters. */
static size_t add(char *out, size_t size, size_t n, const char *text)
{
    return n >= size ? n : n + (size_t)snprintf(out + n, size - n, "%s%s", n ? "|" : "", text);
}

/* Writes the types in a mask of handle kinds. 0: all kinds. */
static void write_handle_types(unsigned kinds, char *out, size_t size)
{
    size_t n = 0;

    out[0] = 0;
    for (int k = 1; k < HANDLE_KINDS; k++)
        if (!kinds || kinds >> k & 1)
            n = add(out, size, n, api_table.things[k]->name);
}

/* Writes the type of a hit shape: the forms that the API table allows. */
static void write_shape_type(const struct api_param *p, char *out, size_t size)
{
    static const struct {
        const char *form, *type;
    } forms[] = { { "{ circle =", "{ circle: number }" },
                  { "{ box =", "{ box: number[] }" },
                  { "{ capsule =", "{ capsule: number[] }" },
                  { "{ circles =", "{ circles: number[][] }" },
                  { "{ share =", "{ share: number }" },
                  { "{ sprite =", "{ sprite: sprite_name }" },
                  { "\"none\"", "\"none\"" } };
    char words[320];
    size_t n = 0;

    help_argument_words(p, words, sizeof words);
    for (size_t i = 0; i < COUNT(forms); i++)
        if (strstr(words, forms[i].form))
            n = add(out, size, n, forms[i].type);
}

/* Parentheses after NAME in a help text ("f(player, by): it was hit") contain the names of a function's arguments, from
 * which their types follow. */
static const struct {
    const char *name, *type;
} given[] = {
    { "player", "player" }, { "bullet", "bullet" },    { "enemy", "enemy" },  { "item", "item" },
    { "laser", "laser" },   { "a", "bullet" },         { "b", "bullet" },     { "e", "enemy" },
    { "p", "player" },      { "by", "bullet|enemy" },  { "late", "boolean" }, { "id", "string" },
    { "won", "boolean" },   { "captured", "boolean" }, { "name", "string" },  { "state", "\"start\"|\"clear\"" },
    { "shot", "shot" },     { "o", "option" },         { "owner", "any" },    { "args", "table" },
    { "i", "integer" },     { "run", "table" },        { "stage", "string" }, { "row", "integer" },
    { "rows", "integer" },  { "damage", "integer" },   { "label", "string" },
};

static const char *given_type(const char *name, size_t n)
{
    for (size_t i = 0; i < COUNT(given); i++)
        if (strlen(given[i].name) == n && !memcmp(given[i].name, name, n))
            return given[i].type;
    return "any";
}

/* Returns the text after NAME( in the help. NULL: there is none. */
static const char *find_call(const char *help, const char *name)
{
    const size_t n = strlen(name);

    for (const char *at = help; (at = strstr(at, name)); at++)
        if (at[n] == '(' && (at == help || !isalnum((unsigned char)at[-1])))
            return at + n + 1;
    return NULL;
}

static void functions(const struct api_entry *e, const struct api_param *p, char *out, size_t size)
{
    const char *own = p->help ? find_call(p->help, p->name) : NULL, *at = own ? own : find_call(e->help, p->name);
    const char *help = own ? p->help : e->help;
    size_t n = (size_t)snprintf(out, size, "function");

    if (!at || *at == '.')
        return;
    n = (size_t)snprintf(out, size, "fun(");
    while (*at != ')' && n < size) {
        const size_t word = strcspn(at, ",)");
        char may[48];
        snprintf(may, sizeof may, "%.*s may be nil", (int)word, at);
        n += (size_t)snprintf(out + n, size - n, "%s%.*s: %s%s", out[n - 1] == '(' ? "" : ", ", (int)word, at,
                              given_type(at, word), strstr(help, may) ? "?" : "");
        at += word;
        at += strspn(at, ", ");
    }
    if (n < size)
        snprintf(out + n, size - n, ")");
}

/* Writes the type of a parameter whose contents have an entry. The `steps` of motion.def are a list of "motion.def
 * step"; the `cast` of boss.def is a list of the entry with the help "one of the cast"; a `list` contains the entry's
 * only part; `emit` of a step is a "motion.def emit". If the help of a part begins with "each ", the type is a table by
 * name, { NAME = part }. Some parameters also accept another table. */
static bool write_part_type(const struct api_entry *e, const struct api_param *p, char *out, size_t size)
{
    const size_t n = strcspn(e->name, " ");

    for (int i = 0; i < api_count_entries(&api_table); i++) {
        const struct api_entry *part = api_get_entry(&api_table, i);
        const char *word = part->name + n + 1;
        if (strncmp(part->name, e->name, n) || part->name[n] != ' ')
            continue;
        const size_t k = strlen(word);
        const bool listed = !strcmp(p->name, "list") || (!strncmp(word, p->name, k) && !strcmp(p->name + k, "s"));
        if (!listed && strcmp(word, p->name) != 0)
            continue;
        const bool list = listed || !strncmp(part->help, "one ", 4), named = !strncmp(part->help, "each ", 5);
        snprintf(out, size,
                 named  ? "table<string, %.*s.%s>|table"
                 : list ? "%.*s.%s[]|table"
                        : "%.*s.%s|table",
                 (int)n, e->name, word);
        return true;
    }
    return false;
}

void annotation_type(const struct api_entry *e, const struct api_param *p, char *out, size_t size)
{
    if (p->type == A_THING)
        write_handle_types((unsigned)p->lo, out, size);
    else if (p->type == A_HIT_SHAPE)
        write_shape_type(p, out, size);
    else if (p->type == A_FUNC)
        functions(e, p, out, size);
    else if (p->type != A_TABLE || !write_part_type(e, p, out, size))
        snprintf(out, size, "%s", types[p->type]);
}

/* Writes the quoted words of a text, each once. False: there are none. */
static bool write_quoted_words(const char *text, char *out, size_t size)
{
    size_t n = 0;

    out[0] = 0;
    for (const char *from = strchr(text, '"'), *to; from && (to = strchr(from + 1, '"')); from = strchr(to + 1, '"')) {
        char word[40];
        snprintf(word, sizeof word, "%.*s", (int)(to + 1 - from), from);
        if (!strstr(out, word))
            n = add(out, size, n, word);
    }
    return n > 0;
}

void annotation_property(const struct api_param *p, char *out, size_t size)
{
    const struct api_entry none = { .name = "", .help = "" };

    if (p->type != A_STR || p->access & PROP_WRITE || !write_quoted_words(p->help, out, size))
        annotation_type(&none, p, out, size);
}

/* ---- what functions return ---- */

static const char *return_type(const char *word)
{
    static const struct {
        const char *word, *type;
    } list[] = { { "boolean", "boolean" }, { "count", "integer" },       { "integer", "integer" },
                 { "frames", "integer" },  { "row", "integer" },         { "degrees", "number" },
                 { "number", "number" },   { "share", "number" },        { "list", "any[]" },
                 { "name", "string" },     { "name or nil", "string?" }, { "string", "string" },
                 { "value", "any" },       { "tries", "integer" },       { "boss", "string" },
                 { "id", "string" },       { "stars", "integer" },       { "ship", "string" },
                 { "got", "integer" },     { "most", "integer" },        { "captures", "integer" },
                 { "scope", "task" },      { "route", "route" } };

    for (size_t i = 0; i < COUNT(list); i++)
        if (!strcmp(list[i].word, word))
            return list[i].type;
    for (int k = 1; k < HANDLE_KINDS; k++)
        if (!strcmp(api_table.things[k]->name, word))
            return word;
    return "any";
}

void annotation_returns(struct byte_buffer *to, const char *words)
{
    while (words && *words) {
        char word[32];
        const size_t n = strcspn(words, ",");
        snprintf(word, sizeof word, "%.*s", (int)n, words);
        byte_buffer_print(to, "---@return %s # %s\n", return_type(word), word);
        words += n;
        words += strspn(words, ", ");
    }
}

const char *annotation_plain(const char *name)
{
    static const struct {
        const char *name, *type;
    } list[] = { { "forever", "integer" },
                 { "game.stage", "string?" },
                 { "game.mode", "string?" },
                 { "game.continues", "integer" },
                 { "game.frames", "integer" },
                 { "hud.banks", "{ plain: integer, bright: integer, faint: integer, alarm: integer }" },
                 { "hud.low", "integer" },
                 { "hud.shy", "integer" },
                 { "hud.gone", "boolean[]" },
                 { "hud.large", "boolean" },
                 { "hud.graze", "string" },
                 { "hud.cols", "integer" },
                 { "hud.rows", "integer" },
                 { "talk.look", "{ dim: number, bank: integer, font?: font_name }" },
                 { "rom.title", "string" },
                 { "rom.field", "{ x: integer, y: integer, w: integer, h: integer }" },
                 { "rom.view", "{ x: integer, y: integer, w: integer, h: integer }" },
                 { "camera", "camera" },
                 { "rom.screen", "{ w: integer, h: integer }" },
                 { "lines", "string[]" },
                 { "frames", "integer" },
                 { "row", "integer" },
                 { "text", "string" },
                 { "bank", "integer" },
                 { "first", "integer" },
                 { "cols", "integer" } };

    for (size_t i = 0; i < COUNT(list); i++)
        if (!strcmp(list[i].name, name))
            return list[i].type;
    return NULL;
}
