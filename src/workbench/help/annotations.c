/*
 * annotations.c - see annotations.h. All annotations are made from the API table.
 *
 * A table of the API, `bullet`, is a global of the class "bulletlib". A kind of handle is the class "bullet", whose
 * methods are in a local of the file. Named arguments have the class "bullet.fire.args", those of methods
 * "bullet.clear.self.args", and tables inside arguments "motion.def.step". A game that declares fields adds them by
 * reopening the class (docs/guide/26-editors.md).
 */
#include "annotations.h"

#include <stdbool.h>
#include <stdio.h>
#include <string.h>
#include "help_lua.h"
#include "../../player/game/version.h"
#include "annotation_types.h"

enum { NAME_SIZE = 80, TYPE_SIZE = 240, WORDS_SIZE = 800 };

/* Functions whose arguments a pattern accepts too, depending on `fire`. */
static const char *const makers[] = { "bullet.fire", "shot.fire", "laser.bolt", "laser.curve", "laser.beam" };
enum { MAKERS = sizeof makers / sizeof *makers };

static bool is_part(const struct api_entry *e)
{
    return strchr(e->name, ' ') != NULL;
}

/* Returns whether games use the entry, also as a table inside arguments. */
static bool is_public(const struct api_entry *e)
{
    return !(e->flags & API_SYS) || is_part(e);
}

static const struct api_param *find_param(const struct api_entry *e, const char *name)
{
    for (int i = e->positional_count; i < e->count; i++)
        if (!strcmp(e->params[i].name, name))
            return &e->params[i];
    return NULL;
}

/* Writes the class of an entry's named arguments. */
static void class_name(const struct api_entry *e, char out[NAME_SIZE])
{
    const bool part = is_part(e), method = e->flags & API_METHOD;

    snprintf(out, NAME_SIZE, "%s%s%s", e->name, method ? ".self" : "", part ? "" : ".args");
    for (char *c = out; *c; c++)
        if (*c == ':' || *c == ' ')
            *c = '.';
}

/* Writes the meaning and, in brackets, the type, range and default. */
static void comment(const struct api_param *p, char out[WORDS_SIZE])
{
    char words[WORDS_SIZE / 2];

    help_argument_words(p, words, sizeof words);
    snprintf(out, WORDS_SIZE, "%s%s[%s]", p->help ? p->help : "", p->help && p->help[0] ? " " : "", words);
}

static void field(struct byte_buffer *to, const struct api_entry *e, const struct api_param *p, bool optional)
{
    char type[TYPE_SIZE], words[WORDS_SIZE];

    annotation_type(e, p, type, sizeof type);
    comment(p, words);
    byte_buffer_print(to, "---@field %s%s %s # %s\n", p->name, optional ? "?" : "", type, words);
}

/* ---- classes of arguments ---- */

/* Returns whether an earlier maker has the parameter. */
static bool is_earlier_argument(int maker, const char *name)
{
    for (int i = 0; i < maker; i++)
        if (find_param(api_find_entry(&api_table, makers[i]), name))
            return true;
    return false;
}

/* Adds a field, whose comment names the first maker that has it. */
static void add_pattern_argument(struct byte_buffer *to, const struct api_entry *e, const struct api_param *p)
{
    struct api_param any = *p;
    char type[TYPE_SIZE], words[WORDS_SIZE];

    any.optional = 1;
    comment(&any, words);
    if (any.type >= A_BULLET_KIND && any.type <= A_OPTION_KIND)
        any.type = A_STR; /* of whatever is fired */
    annotation_type(e, &any, type, sizeof type);
    byte_buffer_print(to, "---@field %s? %s # %s: %s\n", p->name, type, e->name, words);
}

/* Adds the arguments that a pattern passes on. All are optional, because not every maker has them, and functions of
 * `each` may need none. */
static void add_pattern_arguments(struct byte_buffer *to)
{
    byte_buffer_print(to, "\n---arguments that a pattern passes on to each bullet, shot or laser\n---@class fired\n");
    for (int m = 0; m < MAKERS; m++) {
        const struct api_entry *e = api_find_entry(&api_table, makers[m]);
        for (int i = e->positional_count; i < e->count; i++)
            if (!is_earlier_argument(m, e->params[i].name))
                add_pattern_argument(to, e, &e->params[i]);
    }
}

static bool has_table(const struct api_entry *e)
{
    return e->count > e->positional_count || e->flags & API_PATTERN;
}

static void arguments_class(struct byte_buffer *to, const struct api_entry *e)
{
    char name[NAME_SIZE];

    class_name(e, name);
    byte_buffer_print(to, "\n---%s%s\n---@class %s%s\n", is_part(e) ? e->help : "arguments of ",
                      is_part(e) ? "" : e->name, name, e->flags & API_PATTERN ? ": fired" : "");
    for (int i = is_part(e) ? 0 : e->positional_count; i < e->count; i++)
        field(to, e, &e->params[i], e->params[i].optional);
}

static void argument_classes(struct byte_buffer *to)
{
    add_pattern_arguments(to);
    for (int i = 0; i < api_count_entries(&api_table); i++) {
        const struct api_entry *e = api_get_entry(&api_table, i);
        if (is_public(e) && (is_part(e) || has_table(e)))
            arguments_class(to, e);
    }
}

/* ---- functions ---- */

static void function_params(struct byte_buffer *to, const struct api_entry *e)
{
    char type[TYPE_SIZE], words[WORDS_SIZE], name[NAME_SIZE];

    for (int i = e->flags & API_METHOD ? 1 : 0; i < e->positional_count; i++) {
        const struct api_param *p = &e->params[i];
        annotation_type(e, p, type, sizeof type);
        comment(p, words);
        byte_buffer_print(to, "---@param %s%s %s # %s\n", p->name, p->optional ? "?" : "", type, words);
    }
    if (e->flags & API_VARARGS)
        byte_buffer_print(to, "---@param ... any\n");
    if (!has_table(e))
        return;
    class_name(e, name);
    bool must = false;
    for (int i = e->positional_count; i < e->count; i++)
        must = must || !e->params[i].optional;
    byte_buffer_print(to, "---@param args%s %s\n", must || e->flags & API_PATTERN ? "" : "?", name);
}

/* owner: the local that contains the methods of a kind of handle; NULL: the entry's own name is used. */
static void function(struct byte_buffer *to, const struct api_entry *e, const char *owner)
{
    const int first = e->flags & API_METHOD ? 1 : 0;
    const char *comma = "";

    byte_buffer_print(to, "\n---%s%s\n", e->help, e->flags & API_LOAD_ONLY ? " (only while scripts load)" : "");
    function_params(to, e);
    annotation_returns(to, e->returns);
    byte_buffer_print(to, "function %s%s(", owner ? owner : "", owner ? strchr(e->name, ':') : e->name);
    for (int i = first; i < e->positional_count; i++, comma = ", ")
        byte_buffer_print(to, "%s%s", comma, e->params[i].name);
    if (e->flags & API_VARARGS)
        byte_buffer_print(to, "%s...", comma), comma = ", ";
    if (has_table(e))
        byte_buffer_print(to, "%sargs", comma);
    byte_buffer_print(to, ") end\n");
}

/* ---- handles ---- */

static void property(struct byte_buffer *to, const struct api_param *p)
{
    char type[TYPE_SIZE], words[WORDS_SIZE];
    const bool nil = strstr(p->help, "nil") != NULL, read = !(p->access & PROP_WRITE);

    annotation_property(p, type, sizeof type);
    help_property_words(p, words, sizeof words);
    byte_buffer_print(to, "---@field %s%s %s # %s%s [%s]\n", p->name, nil ? "?" : "", type, read ? "read-only: " : "",
                      p->help, words);
}

static void handle(struct byte_buffer *to, enum handle_kind kind)
{
    const struct api_thing *t = api_table.things[kind];
    const size_t n = strlen(t->name);
    char owner[NAME_SIZE];

    byte_buffer_print(to, "\n---@class %s\n", t->name);
    if (api_can_die(kind))
        byte_buffer_print(to, "---@field alive boolean # read-only: true while it exists\n");
    for (int i = 0; i < t->n; i++)
        property(to, &t->props[i]);
    snprintf(owner, sizeof owner, "a_%s", t->name);
    byte_buffer_print(to, "local %s = {}\n", owner);
    for (int i = 0; i < api_count_entries(&api_table); i++) {
        const struct api_entry *e = api_get_entry(&api_table, i);
        if (!strncmp(e->name, t->name, n) && e->name[n] == ':' && is_public(e))
            function(to, e, owner);
    }
}

/* ---- globals ---- */

/* Writes the table of a name, "bullet" of "bullet.fire"; "": a global. */
static void get_namespace(const char *name, char out[NAME_SIZE])
{
    const size_t n = strcspn(name, ".(");

    snprintf(out, NAME_SIZE, "%.*s", name[n] == '.' ? (int)n : 0, name);
}

/* Returns the i-th name of all entries, followed by all values; "": a private entry; NULL: the end. */
static const char *any_name(int i)
{
    const int k = i - api_count_entries(&api_table);

    if (k >= 0)
        return k < api_table.doc_name_count ? api_table.doc_names[k].name : NULL;
    const struct api_entry *e = api_get_entry(&api_table, i);
    return is_public(e) && !strpbrk(e->name, ": ") ? e->name : "";
}

static bool space_before(int i, const char *space)
{
    char other[NAME_SIZE];

    for (int k = 0; k < i; k++) {
        get_namespace(any_name(k), other);
        if (!strcmp(other, space))
            return true;
    }
    return false;
}

static void space_fields(struct byte_buffer *to, const char *space)
{
    char of[NAME_SIZE];

    for (int i = 0; i < api_table.doc_name_count; i++) {
        const char *name = api_table.doc_names[i].name, *help = api_table.doc_names[i].help;
        get_namespace(name, of);
        if (strcmp(of, space) || strchr(name, '('))
            continue;
        const char *type = annotation_plain(name);
        byte_buffer_print(to, "---@field %s %s # %s\n", name + strlen(of) + 1, type ? type : "any", help);
    }
}

static void spaces(struct byte_buffer *to)
{
    char space[NAME_SIZE];

    for (int i = 0; any_name(i); i++) {
        get_namespace(any_name(i), space);
        if (!space[0] || space_before(i, space))
            continue;
        byte_buffer_print(to, "\n---@class %slib\n", space);
        space_fields(to, space);
        byte_buffer_print(to, "%s = {}\n", space);
    }
}

/* Adds a function without an entry: "hud.banner(lines?, frames?)". */
static void plain_function(struct byte_buffer *to, const char *name, const char *help)
{
    char list[160] = "";
    size_t n = 0;
    const char *at = strchr(name, '(') + 1, *returns = strstr(help, "returns the row");

    byte_buffer_print(to, "\n---%s\n", help);
    while (*at != ')') {
        char word[32];
        const size_t length = strcspn(at, "?,)");
        snprintf(word, sizeof word, "%.*s", (int)length, at);
        const char *type = annotation_plain(word);
        byte_buffer_print(to, "---@param %s%s %s\n", word, at[length] == '?' ? "?" : "", type ? type : "any");
        n += (size_t)snprintf(list + n, sizeof list - n, "%s%s", n ? ", " : "", word);
        at += length;
        at += strspn(at, "?, ");
    }
    if (returns)
        annotation_returns(to, "row");
    byte_buffer_print(to, "function %.*s(%s) end\n", (int)strcspn(name, "("), name, list);
}

/* Leaves out print and require, which the language server knows. */
static void plain_names(struct byte_buffer *to)
{
    for (int i = 0; i < api_table.doc_name_count; i++) {
        const char *name = api_table.doc_names[i].name, *help = api_table.doc_names[i].help;
        const char *type = annotation_plain(name);
        if (strchr(name, '(') && strcspn(name, ".") < strcspn(name, "("))
            plain_function(to, name, help);
        else if (!strpbrk(name, ".("))
            byte_buffer_print(to, "\n---%s\n---@type %s\n%s = nil\n", help, type ? type : "any", name);
    }
}

void annotations_write(struct byte_buffer *to)
{
    byte_buffer_print(to, "---@meta curtain\n");
    byte_buffer_print(to,
                      "-- Curtain %s: the API for games, for the Lua language server. Generated by curtain help lua "
                      "--annotations.\n\n",
                      CURTAIN_VERSION);
    byte_buffer_print(to, "-- luacheck: ignore\n");
    annotation_aliases(to);
    argument_classes(to);
    for (int k = 1; k < HANDLE_KINDS; k++)
        handle(to, (enum handle_kind)k);
    spaces(to);
    for (int i = 0; i < api_count_entries(&api_table); i++)
        if (any_name(i)[0])
            function(to, api_get_entry(&api_table, i), NULL);
    plain_names(to);
}
