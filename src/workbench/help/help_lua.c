/*
 * help_lua.c - `curtain help lua`: the API table as text.
 */
#include <stdio.h>
#include <string.h>
#include "help_lua.h"

static const char *type_words(const struct api_param *p)
{
    static const char *const words[] = {
        [A_INT] = "whole number",
        [A_COUNT] = "whole number or forever",
        [A_NUM] = "number",
        [A_FX] = "number",
        [A_DIR] = "degrees",
        [A_SCALE] = "number",
        [A_STR] = "string",
        [A_BOOL] = "true or false",
        [A_FUNC] = "function",
        [A_TABLE] = "table",
        [A_ANY] = "any value",
        [A_SPAN] = "{ first, last }, whole numbers",
        [A_ROUTE] = "route",
        [A_THING] = "thing",
        [A_MOTION] = "motion or its name",
        [A_BULLET_KIND] = "name of a bullet kind",
        [A_SHOT_KIND] = "name of a shot kind",
        [A_ENEMY_KIND] = "name of an enemy kind",
        [A_PLAYER_KIND] = "name of a player kind",
        [A_SPARK_KIND] = "name of a spark kind",
        [A_ITEM_KIND] = "name of an item kind",
        [A_LASER_KIND] = "name of a laser kind",
        [A_OPTION_KIND] = "name of an option kind",
        [A_SPRITE] = "name of a sprite",
        [A_BLEND] = "name of a blend",
        [A_FONT] = "name of a font",
        [A_MAP] = "name of a map",
        [A_SOUND] = "name of a sound",
        [A_TUNE] = "name of a piece of music",
        [A_BUTTON] = "up, down, left, right, fire, bomb, focus, special, start or select",
        [A_PLAYER] = "1, 2 or a player",
        [A_EASE] = "linear, in, out or both",
        [A_LAYER] = "back, middle, front or over",
        [A_SPARK_LAYER] = "middle or front",
        [A_DEPTH] = "back or front",
        [A_ALIGN] = "left, center or right",
        [A_EMIT_FIRE] = "bullet or shot",
        [A_FIRE] = "bullet, shot, bolt, curve or beam",
        [A_MEET] = "none, first, second or both",
        [A_EMIT_PATTERN] = "one, ring, fan, arc, stack or line",
        [A_BARS_DOWN] = "all or any",
        [A_HOST_SCREEN] = "settings, replays, practice, keys or quit",
    };

    if (p->type == A_ANY && p->unit) /* the entry checks the value itself */
        return p->unit;
    return p->type == A_HIT_SHAPE ? api_hit_forms[(int)p->lo] : words[p->type];
}

/* Writes a mask of kinds: "player", or "thing: bullet, shot or enemy". */
static void thing_words(unsigned kinds, char *out, size_t size)
{
    size_t n = (size_t)snprintf(out, size, "thing");

    for (int k = 1; k < HANDLE_KINDS; k++)
        if (kinds == 1u << k) {
            snprintf(out, size, "%s", api_table.things[k]->name);
            return;
        }

    for (int k = 1, left; k < HANDLE_KINDS && n < size; k++) {
        if (!(kinds >> k & 1))
            continue;
        left = kinds >> (k + 1) != 0;
        n += (size_t)snprintf(out + n, size - n, "%s%s",
                              n == 5 ? ": "
                              : left ? ", "
                                     : " or ",
                              api_table.things[k]->name);
    }
}

void help_argument_words(const struct api_param *p, char *out, size_t size)
{
    char range[80] = "", def[80] = "", thing[160];
    const bool ranged = p->type == A_INT || p->type == A_COUNT || p->type == A_NUM || p->type == A_FX ||
                        p->type == A_SCALE || p->type == A_SPAN;
    const bool colour = p->type == A_INT && p->hi == 0xffffff;
    const char *type = p->type == A_THING   ? thing
                       : colour             ? "colour"
                       : p->type == A_COUNT ? "whole number"
                                            : type_words(p);

    if (colour)
        snprintf(range, sizeof range, " from 0x%06x to 0x%06x", (unsigned)p->lo, (unsigned)p->hi);
    else if (ranged)
        snprintf(range, sizeof range, " from %.14g to %.14g%s%s%s", p->lo, p->hi, p->unit ? " " : "",
                 p->unit ? p->unit : "",
                 p->type == A_COUNT   ? ", or forever"
                 : p->type == A_SCALE ? " in steps of 1/8"
                                      : "");
    if (p->type == A_STR && p->hi > 0)
        snprintf(range, sizeof range, " of %d to %d bytes", (int)p->lo, (int)p->hi);
    if (p->def)
        snprintf(def, sizeof def, " (default %s)", p->def);
    else if (!p->optional)
        snprintf(def, sizeof def, " (required)");
    else if (p->optional == UNLESS_VXY)
        snprintf(def, sizeof def, " (required unless `vx` or `vy` is given)");
    thing_words(p->type == A_THING ? (unsigned)p->lo : 0, thing, sizeof thing);
    snprintf(out, size, "%s%s%s", type, range, def);
}

enum { HELP_COLUMNS = 100 };

/* Words in brackets stay together if they fit. */
void help_wrapped(const char *text, int indent, void (*line)(const char *))
{
    char out[HELP_COLUMNS + 400];
    int n = snprintf(out, sizeof out, "%s", text), left = 0;

    for (const char *at = text; n > HELP_COLUMNS; n = snprintf(out, sizeof out, "%*s%s", left, "", at)) {
        const char *bracket = strstr(out + left, " [");
        int end = HELP_COLUMNS;
        while (end > indent && out[end] != ' ')
            end--;
        if (bracket && bracket - out > indent && bracket - out <= HELP_COLUMNS &&
            n - (bracket - out) <= HELP_COLUMNS - indent) /* the brackets fit on a line */
            end = (int)(bracket - out);
        if (end <= indent) /* one long word */
            break;
        at += end + 1 - left;
        left = indent;
        while (out[end - 1] == ' ')
            end--;
        out[end] = '\0';
        line(out);
    }
    line(out);
}

enum {
    HELP_NAME = 15 /* columns up to the meaning of an argument, HELP_PROPERTY of a property */,
    HELP_PROPERTY = 21,
    HELP_LIST = 47
};

void help_param(const struct api_param *p, void (*line)(const char *))
{
    char text[1024], words[280];

    help_argument_words(p, words, sizeof words);
    snprintf(text, sizeof text, "    %-10s %s%s[%s]", p->name, p->help ? p->help : "", p->help && p->help[0] ? " " : "",
             words);
    help_wrapped(text, HELP_NAME, line);
}

static void help_signature(const struct api_entry *e, char *out, size_t size)
{
    int first = e->flags & API_METHOD ? 1 : 0;
    size_t n = (size_t)snprintf(out, size, "%s", e->name);
    bool table = e->count > e->positional_count || e->flags & API_PATTERN;

    if (!table || e->positional_count > first)
        n += (size_t)snprintf(out + n, size - n, "(");
    for (int i = first; i < e->positional_count; i++)
        n += (size_t)snprintf(out + n, size - n, "%s%s%s", i > first ? ", " : "", e->params[i].name,
                              e->params[i].optional ? "?" : "");
    if (e->flags & API_VARARGS)
        n += (size_t)snprintf(out + n, size - n, "%s...", e->positional_count > first ? ", " : "");
    if (table)
        n += (size_t)snprintf(out + n, size - n, "%s{...}", e->positional_count > first ? ", " : "");
    if (!table || e->positional_count > first)
        n += (size_t)snprintf(out + n, size - n, ")");
    if (e->returns)
        snprintf(out + n, size - n, " -> %s", e->returns);
}

/* Tables inside an entry's arguments have entries of their own: "motion.def step", "path.def point". */
static void help_parts(const struct api_entry *e, void (*line)(const char *))
{
    size_t n = strlen(e->name);
    char text[1024];

    for (int i = 0; i < api_count_entries(&api_table); i++) {
        const struct api_entry *part = api_get_entry(&api_table, i);
        if (strncmp(part->name, e->name, n) || part->name[n] != ' ')
            continue;
        line("");
        snprintf(text, sizeof text, "  %s: %s", part->name + n + 1, part->help);
        help_wrapped(text, 6, line);
        for (int k = 0; k < part->count; k++)
            help_param(&part->params[k], line);
    }
}

void help_entry(const struct api_entry *e, bool whole, void (*line)(const char *))
{
    const int first = e->flags & API_METHOD ? 1 : 0;
    char text[800], signature[200];

    help_signature(e, signature, sizeof signature);
    if (!whole) {
        snprintf(text, sizeof text, "%-46s %s", signature, e->help);
        help_wrapped(text, HELP_LIST, line);
        return;
    }
    line(signature);
    snprintf(text, sizeof text, "  %s%s", e->help, e->flags & API_LOAD_ONLY ? " (only while scripts load)" : "");
    help_wrapped(text, 2, line);
    if (e->count > first || e->flags & API_PATTERN)
        line("");
    for (int i = first; i < e->count; i++)
        help_param(&e->params[i], line);
    if (e->flags & API_PATTERN)
        line("    ...        all arguments of bullet.fire, shot.fire or laser.NAME, depending on `fire`");
    help_parts(e, line);
}

static bool help_values(const char *name, size_t n, void (*line)(const char *))
{
    char text[240];
    bool any = false;

    for (int i = 0; i < api_table.doc_name_count; i++) {
        const struct api_doc_name *p = &api_table.doc_names[i];
        if (n && strncmp(p->name, name, n))
            continue;
        snprintf(text, sizeof text, "%-46s %s", p->name, p->help);
        help_wrapped(text, HELP_LIST, line);
        any = true;
    }
    return any;
}

void help_property_words(const struct api_param *p, char *out, size_t size)
{
    struct api_param value = *p;

    value.optional = OPT;
    if (value.type == A_THING)
        thing_words((unsigned)value.lo, out, size);
    else if (!(p->access & PROP_WRITE)) /* the range is that of writes */
        snprintf(out, size, "%s", type_words(&value));
    else
        help_argument_words(&value, out, size);
}

static bool help_thing(int kind, void (*line)(const char *))
{
    const struct api_thing *t = api_table.things[kind];
    char text[1024], words[200];

    snprintf(text, sizeof text, "properties of %s:", api_thing_names[kind]);
    line(text);
    if (api_can_die((enum handle_kind)kind))
        line("    alive      read  true while it exists");
    for (int i = 0; i < t->n; i++) {
        const struct api_param *p = &t->props[i];
        help_property_words(p, words, sizeof words);
        snprintf(text, sizeof text, "    %-10s %-5s %s [%s]", p->name, p->access & PROP_WRITE ? "write" : "read",
                 p->help, words);
        help_wrapped(text, HELP_PROPERTY, line);
    }
    return true;
}

const char *help_nearest(const char *name)
{
    struct api_suggestion s = { .word = name };

    for (int i = 0; i < api_count_entries(&api_table); i++)
        if (!(api_get_entry(&api_table, i)->flags & API_SYS))
            api_consider(&s, api_get_entry(&api_table, i)->name);
    for (int i = 0; i < api_table.doc_name_count; i++)
        if (!strchr(api_table.doc_names[i].name, '('))
            api_consider(&s, api_table.doc_names[i].name);
    return s.nearest;
}

/* Returns whether it is a table of the API, "bullet", or the start of a name in one, "bullet.f". */
static bool is_table(const char *name)
{
    const size_t n = strlen(name);

    for (int i = 0; i < api_count_entries(&api_table); i++) {
        const struct api_entry *e = api_get_entry(&api_table, i);
        if (!(e->flags & API_SYS) && !strncmp(e->name, name, n) && (strpbrk(name, ".:") || strchr(".:", e->name[n])))
            return true;
    }
    for (int i = 0; i < api_table.doc_name_count; i++) {
        const char *plain = api_table.doc_names[i].name;
        if (!strncmp(plain, name, n) && (strchr(name, '.') || plain[n] == '.' || !plain[n]))
            return true;
    }
    return false;
}

static bool help_all(const char *name, bool exact, void (*line)(const char *))
{
    const size_t n = strlen(name);
    bool any = false;

    for (int i = 0; i < api_count_entries(&api_table); i++) {
        const struct api_entry *e = api_get_entry(&api_table, i);
        if (e->flags & API_SYS || (exact && strcmp(e->name, name)) || strncmp(e->name, name, n))
            continue;
        help_entry(e, exact, line);
        any = true;
    }
    if (!exact)
        any |= help_values(name, n, line);
    return any;
}

/* Explains the method in a call of a variable, such as "p:push", for each kind of thing that has it. */
static bool help_method(const char *name, void (*line)(const char *))
{
    const char *method = strchr(name, ':');
    bool any = false;

    for (int i = 0; method && i < api_count_entries(&api_table); i++) {
        const char *own = strchr(api_get_entry(&api_table, i)->name, ':');
        if (own && !strcmp(own, method))
            any |= help_all(api_get_entry(&api_table, i)->name, true, line);
    }
    return any;
}

bool help_write(const char *name, void (*line)(const char *))
{
    const bool exact = name && api_find_entry(&api_table, name);
    bool any = false;

    if (!name) {
        help_tasks(line);
        return help_all("", false, line);
    }
    if (exact || is_table(name))
        any = help_all(name, exact, line);
    for (int k = 1; !exact && k < HANDLE_KINDS; k++)
        if (api_table.things[k] && !strcmp(api_table.things[k]->name, name))
            any = help_thing(k, line);
    return any || help_method(name, line) || help_search(name, line);
}
