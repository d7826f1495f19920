/*
 * api_help.c - `curtain help lua`: the API table as text.
 */
#include <stdio.h>
#include <string.h>
#include "../../base/edit.h"
#include "api_parts.h"

static const char *type_words(const struct api_param *p)
{
    static const char *const words[] = {
        [A_INT] = "whole number",
        [A_COUNT] = "whole number or forever",
        [A_NUM] = "number",
        [A_FX] = "number",
        [A_DIR] = "degrees",
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
        [A_FACE] = "name of a font",
        [A_MAP] = "name of a map",
        [A_SOUND] = "name of a sound",
        [A_TUNE] = "name of a piece of music",
        [A_BUTTON] = "up, down, left, right, fire, bomb, focus, special, start or select",
        [A_PAD] = "1, 2 or a player",
        [A_EASE] = "linear, in, out or both",
        [A_LAYER] = "back, middle, front or over",
        [A_SPARK_LAYER] = "middle or front",
        [A_DEPTH] = "back or front",
        [A_ALIGN] = "left, center or right",
        [A_SHOOT] = "bullet or shot",
        [A_FIRE] = "bullet, shot, bolt, curve or beam",
        [A_MEET] = "none, first, second or both",
        [A_EMIT] = "one, ring, fan, arc, stack or line",
        [A_DOWN] = "all or any",
        [A_ASK] = "settings, replays, practice or keys",
    };

    if (p->type == A_ANY && p->unit) /* the entry checks the value itself */
        return p->unit;
    return p->type == A_HIT ? api_hit_forms[(int)p->lo] : words[p->type];
}

/* A mask of kinds in words: "player", or "thing: bullet, shot or enemy". */
static void thing_words(unsigned kinds, char *out, size_t size)
{
    size_t n = (size_t)snprintf(out, size, "thing");

    for (int k = 1; k < HANDLES; k++)
        if (kinds == 1u << k) {
            snprintf(out, size, "%s", api_things[k]->name);
            return;
        }

    for (int k = 1, left; k < HANDLES && n < size; k++) {
        if (!(kinds >> k & 1))
            continue;
        left = kinds >> (k + 1) != 0;
        n += (size_t)snprintf(out + n, size - n, "%s%s", n == 5 ? ": " : left ? ", " : " or ", api_things[k]->name);
    }
}

void api_param_words(const struct api_param *p, char *out, size_t size)
{
    char range[80] = "", def[80] = "", thing[160];
    const bool ranged =
        p->type == A_INT || p->type == A_COUNT || p->type == A_NUM || p->type == A_FX || p->type == A_SPAN;
    const bool colour = p->type == A_INT && p->hi == 0xffffff;
    const char *type = p->type == A_THING   ? thing
                       : colour             ? "colour"
                       : p->type == A_COUNT ? "whole number"
                                            : type_words(p);

    if (colour)
        snprintf(range, sizeof range, " from 0x%06x to 0x%06x", (unsigned)p->lo, (unsigned)p->hi);
    else if (ranged)
        snprintf(range, sizeof range, " from %.14g to %.14g%s%s%s", p->lo, p->hi, p->unit ? " " : "",
                 p->unit ? p->unit : "", p->type == A_COUNT ? ", or forever" : "");
    if (p->type == A_STR && p->hi > 0)
        snprintf(range, sizeof range, " of %d to %d bytes", (int)p->lo, (int)p->hi);
    if (p->def)
        snprintf(def, sizeof def, " (default %s)", p->def);
    else if (!p->optional)
        snprintf(def, sizeof def, " (required)");
    thing_words(p->type == A_THING ? (unsigned)p->lo : 0, thing, sizeof thing);
    snprintf(out, size, "%s%s%s", type, range, def);
}

enum { HELP_COLUMNS = 100 };

/* Words in brackets stay together if they fit. */
void api_help_wrapped(const char *text, int indent, void (*line)(const char *))
{
    char out[HELP_COLUMNS + 400];
    int n = snprintf(out, sizeof out, "%s", text), left = 0;

    for (const char *at = text; n > HELP_COLUMNS; n = snprintf(out, sizeof out, "%*s%s", left, "", at)) {
        const char *bracket = strstr(out + left, " [");
        int end = HELP_COLUMNS;
        while (end > indent && out[end] != ' ')
            end--;
        if (bracket && bracket - out > indent && bracket - out <= HELP_COLUMNS &&
            n - (bracket - out) <= HELP_COLUMNS - indent) /* it fits on a line */
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

void api_help_param(const struct api_param *p, void (*line)(const char *))
{
    char text[1024], words[280];

    api_param_words(p, words, sizeof words);
    snprintf(text, sizeof text, "    %-10s %s%s[%s]", p->name, p->help ? p->help : "", p->help && p->help[0] ? " " : "",
             words);
    api_help_wrapped(text, HELP_NAME, line);
}

static void help_signature(const struct api_entry *e, char *out, size_t size)
{
    int first = e->flags & API_METHOD ? 1 : 0;
    size_t n = (size_t)snprintf(out, size, "%s", e->name);
    bool table = e->count > e->plain || e->flags & API_FIRE;

    if (!table || e->plain > first)
        n += (size_t)snprintf(out + n, size - n, "(");
    for (int i = first; i < e->plain; i++)
        n += (size_t)snprintf(out + n, size - n, "%s%s%s", i > first ? ", " : "", e->params[i].name,
                              e->params[i].optional ? "?" : "");
    if (e->flags & API_MORE)
        n += (size_t)snprintf(out + n, size - n, "%s...", e->plain > first ? ", " : "");
    if (table)
        n += (size_t)snprintf(out + n, size - n, "%s{...}", e->plain > first ? ", " : "");
    if (!table || e->plain > first)
        n += (size_t)snprintf(out + n, size - n, ")");
    if (e->returns)
        snprintf(out + n, size - n, " -> %s", e->returns);
}

/* Tables inside an entry's arguments have entries of their own: "motion.def step", "path.def point". */
static void help_parts(const struct api_entry *e, void (*line)(const char *))
{
    size_t n = strlen(e->name);
    char text[1024];

    for (int i = 0; i < api_count(); i++) {
        const struct api_entry *part = api_entry(i);
        if (strncmp(part->name, e->name, n) || part->name[n] != ' ')
            continue;
        line("");
        snprintf(text, sizeof text, "  %s: %s", part->name + n + 1, part->help);
        api_help_wrapped(text, 6, line);
        for (int k = 0; k < part->count; k++)
            api_help_param(&part->params[k], line);
    }
}

void api_help_entry(const struct api_entry *e, bool whole, void (*line)(const char *))
{
    const int first = e->flags & API_METHOD ? 1 : 0;
    char text[800], signature[200];

    help_signature(e, signature, sizeof signature);
    if (!whole) {
        snprintf(text, sizeof text, "%-46s %s", signature, e->help);
        api_help_wrapped(text, HELP_LIST, line);
        return;
    }
    line(signature);
    snprintf(text, sizeof text, "  %s%s", e->help, e->flags & API_LOAD ? " (only while scripts load)" : "");
    api_help_wrapped(text, 2, line);
    if (e->count > first || e->flags & API_FIRE)
        line("");
    for (int i = first; i < e->count; i++)
        api_help_param(&e->params[i], line);
    if (e->flags & API_FIRE)
        line("    ...        all arguments of bullet.fire, shot.fire or laser.NAME, depending on `fire`");
    help_parts(e, line);
}

/* Names that are no functions of the API. */
static const struct {
    const char *name, *help;
} values[] = {
    { "forever", HELP("means \"without end\" where a number of frames or times is expected") },
    { "print(...)", HELP("writes its arguments to the log") },
    { "require(name)", HELP("runs a script of the game once and returns its result, as in require \"stages/one\"; only "
                            "while scripts load") },
    { "game.stage", HELP("name of the current stage, or nil") },
    { "game.mode", HELP("name of the current mode of boot.run, or nil") },
    { "game.continues", HELP("number of continues used in this game, by all players") },
    { "game.frames", HELP("frames since the game started") },
    { "hud.banks",
      HELP("palette banks of text in the HUD, menus and dialogue: plain, bright, faint, alarm; set them in main.lua") },
    { "hud.low",
      HELP("rows left free below the registers at the lower edge of the field; set it in main.lua; initially 1") },
    { "hud.shy", HELP("distance in px within which a ship hides the registers at the lower edge of the field; set it "
                      "in main.lua; initially 0") },
    { "hud.gone", HELP("list with an entry for each player: true while the player's registers at the lower edge of the "
                       "field are hidden; use it to hide the game's own displays, too") },
    { "hud.graze", HELP("word before the graze count; set it in main.lua; false shows a star") },
    { "hud.cols", HELP("width of the screen in cells of 8 px") },
    { "hud.rows", HELP("height of the screen in cells of 8 px") },
    { "hud.banner(lines?, frames?)",
      HELP("shows a banner, a list of texts in the middle of the field; without `lines`, removes the banner") },
    { "hud.centre(row, text, bank?, first?, cols?)",
      HELP("translates a text and centres it on the screen, or in `cols` cells from column `first`; wraps a text that "
           "is too long; returns the row below the text") },
    { "talk.look", HELP("look of dialogue: dim, bank, font; set them in main.lua") },
    { "rom.title", HELP("title of the game") },
    { "rom.field", HELP("playfield: x, y, w, h in px; x and y are its position on the screen") },
    { "rom.screen", HELP("screen: w, h in px") },
};

enum { VALUES = sizeof values / sizeof *values };

const char *api_plain(int i, const char **help)
{
    if (i >= VALUES)
        return NULL;
    *help = values[i].help;
    return values[i].name;
}

static bool help_values(const char *name, size_t n, void (*line)(const char *))
{
    char text[240];
    bool any = false;

    for (size_t i = 0; i < VALUES; i++) {
        if (n && strncmp(values[i].name, name, n))
            continue;
        snprintf(text, sizeof text, "%-46s %s", values[i].name, values[i].help);
        api_help_wrapped(text, HELP_LIST, line);
        any = true;
    }
    return any;
}

/* How long a name is up to its arguments. */
static size_t name_length(const char *name)
{
    const char *arguments = strchr(name, '(');

    return arguments ? (size_t)(arguments - name) : strlen(name);
}

enum { NEAR_CALLS = 3 };

/* The names that are as near to a word as any, up to NEAR_CALLS of them. */
struct near_calls {
    const char *word, *found[NEAR_CALLS];
    int best, n; /* n NEAR_CALLS + 1: there are more */
};

/* name: "bullet.fire", "say", or "hud.centre(row, ...)". */
static void near_call(struct near_calls *c, const char *name)
{
    char last[32];
    const char *dot = strchr(name, '.'), *from = dot ? dot + 1 : name;

    snprintf(last, sizeof last, "%.*s", (int)name_length(from), from);
    int d = edit_distance(c->word, last);
    if (d < c->best) {
        c->best = d;
        c->n = 0;
    }
    if (d != c->best || d == EDIT_FAR || c->n > NEAR_CALLS)
        return;
    if (c->n < NEAR_CALLS)
        c->found[c->n] = name;
    c->n++;
}

bool api_help_calls(const char *name, char *out, size_t size)
{
    struct near_calls c = { .word = name, .best = EDIT_FAR };
    size_t n = 0;

    for (int i = 0; i < api_count(); i++)
        if (!(api_entry(i)->flags & API_SYS))
            near_call(&c, api_entry(i)->name);
    for (size_t i = 0; i < VALUES; i++)
        if (strchr(values[i].name, '('))
            near_call(&c, values[i].name);
    for (int i = 0; i < c.n && c.n <= NEAR_CALLS && n < size; i++)
        n += (size_t)snprintf(out + n, size - n, "%s%.*s", i ? i == c.n - 1 ? " or " : ", " : "",
                              (int)name_length(c.found[i]), c.found[i]);
    return c.n > 0 && c.n <= NEAR_CALLS;
}

bool api_ends(enum handle_kind kind)
{
    return !handle_kind_group(kind) && kind != H_MOTION && kind != H_LAYER && kind != H_PLANE;
}

void api_property_words(const struct api_prop *p, char *out, size_t size)
{
    struct api_param value = p->value;

    value.optional = OPT;
    if (value.type == A_THING)
        thing_words((unsigned)value.lo, out, size);
    else if (p->write != PROP_WRITE) /* its range is what a write takes */
        snprintf(out, size, "%s", type_words(&value));
    else
        api_param_words(&value, out, size);
}

static bool help_thing(int kind, void (*line)(const char *))
{
    const struct api_thing *t = api_things[kind];
    char text[1024], words[200];

    snprintf(text, sizeof text, "properties of %s:", api_thing_names[kind]);
    line(text);
    if (api_ends((enum handle_kind)kind))
        line("    alive      read  true while it exists");
    for (int i = 0; i < t->n; i++) {
        const struct api_prop *p = &t->props[i];
        api_property_words(p, words, sizeof words);
        snprintf(text, sizeof text, "    %-10s %-5s %s [%s]", p->value.name, p->write == PROP_WRITE ? "write" : "read",
                 p->value.help, words);
        api_help_wrapped(text, HELP_PROPERTY, line);
    }
    return true;
}

const char *api_help_near(const char *name)
{
    const char *found = NULL;
    int best = EDIT_FAR;

    for (int i = 0; i < api_count(); i++)
        if (!(api_entry(i)->flags & API_SYS))
            api_suggest_nearer(name, api_entry(i)->name, &best, &found);
    for (size_t i = 0; i < VALUES; i++)
        if (!strchr(values[i].name, '('))
            api_suggest_nearer(name, values[i].name, &best, &found);
    return found;
}

/* Is it a table of the API, "bullet", or the beginning of a name in one, "bullet.f"? */
static bool is_table(const char *name)
{
    const size_t n = strlen(name);
    const char *help, *plain;

    for (int i = 0; i < api_count(); i++) {
        const struct api_entry *e = api_entry(i);
        if (!(e->flags & API_SYS) && !strncmp(e->name, name, n) && (strpbrk(name, ".:") || strchr(".:", e->name[n])))
            return true;
    }
    for (int i = 0; (plain = api_plain(i, &help)); i++)
        if (!strncmp(plain, name, n) && (strchr(name, '.') || plain[n] == '.' || !plain[n]))
            return true;
    return false;
}

static bool help_all(const char *name, bool exact, void (*line)(const char *))
{
    const size_t n = strlen(name);
    bool any = false;

    for (int i = 0; i < api_count(); i++) {
        const struct api_entry *e = api_entry(i);
        if (e->flags & API_SYS || (exact && strcmp(e->name, name)) || strncmp(e->name, name, n))
            continue;
        api_help_entry(e, exact, line);
        any = true;
    }
    if (!exact)
        any |= help_values(name, n, line);
    return any;
}

bool api_help(const char *name, void (*line)(const char *))
{
    const bool exact = name && api_find(name);
    bool any = false;

    if (!name) {
        api_help_tasks(line);
        return help_all("", false, line);
    }
    if (exact || is_table(name))
        any = help_all(name, exact, line);
    for (int k = 1; !exact && k < HANDLES; k++)
        if (api_things[k] && !strcmp(api_things[k]->name, name))
            any = help_thing(k, line);
    return any || api_help_search(name, line);
}
