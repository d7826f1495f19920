/*
 * config.c - see config.h. One table is the parser, the ranges and the help.
 */
#include "config.h"
#include "../../board/rom/manifest.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static const char *const turns[] = { "none", "left", "right", "over", NULL };
static const char *const scalings[] = { "whole", "smooth", NULL };
static const char *const places[] = { "over", "beside", NULL };

static const struct setting {
    const char *name;
    size_t at; /* an int of struct config */
    int lo, hi, standard;
    bool yes_no;
    const char *help;
    const char *const *words; /* NULL, or what it is one of, up to a NULL: the value is the index */
} settings[] = {
    { "scale", offsetof(struct config, scale), 0, 16, 0, false, "window pixels a picture pixel; 0: what fits", NULL },
    { "volume", offsetof(struct config, volume), 0, 100, 100, false, "percent", NULL },
    { "mute", offsetof(struct config, mute), 0, 1, 0, true, "start without sound", NULL },
    { "resample", offsetof(struct config, resample), 0, 1, 1, true, "no: sound to the bit, and the card's clock leads",
      NULL },
    { "fullscreen", offsetof(struct config, fullscreen), 0, 1, 0, true, "start in fullscreen", NULL },
    { "turn", offsetof(struct config, turn), 0, 3, 0, false, "turn the picture, for an upright monitor", turns },
    { "scaling", offsetof(struct config, scaling), 0, 1, 0, false, "smooth: as large as the window allows", scalings },
    { "crt", offsetof(struct config, crt), 0, 1, 0, true, "the lines and the mask of a tube", NULL },
    { "border", offsetof(struct config, border), 0, 1, 1, true, "art round the picture, of games that bring it", NULL },
    { "vsync", offsetof(struct config, vsync), 0, 1, 1, true, "show pictures when the screen takes them", NULL },
    { "run_ahead", offsetof(struct config, run_ahead), 0, 1, 0, false, "show the frame after this: answers sooner",
      NULL },
    { "panels", offsetof(struct config, panels), 0, 1, 0, false, "messages and panels, if the window is wide", places },
};

enum { SETTINGS = sizeof settings / sizeof *settings };

static int *value_of(struct config *c, const struct setting *s)
{
    return (int *)(void *)((char *)c + s->at);
}

void config_defaults(struct config *c)
{
    keys_defaults(&c->keys);
    memset(c->lang, 0, sizeof c->lang);
    for (int i = 0; i < SETTINGS; i++)
        *value_of(c, &settings[i]) = settings[i].standard;
}

static bool number(const char *s, int lo, int hi, int *v)
{
    char *end;
    long n = strtol(s, &end, 10);
    if (end == s || *end || n < lo || n > hi)
        return false;
    *v = (int)n;
    return true;
}

static bool yes_no(const char *s, int *v)
{
    *v = strcmp(s, "yes") == 0;
    return *v || strcmp(s, "no") == 0;
}

static bool word(const char *s, const char *const *words, int *v)
{
    for (int i = 0; words[i]; i++)
        if (strcmp(s, words[i]) == 0) {
            *v = i;
            return true;
        }
    return false;
}

/* "none, left, right" with `and`, a word, before the last one. */
static void list_words(const char *const *words, const char *and, char *out, size_t size)
{
    size_t n = 0;

    out[0] = 0;
    for (int i = 0; words[i] && n < size; i++) {
        const char *between = i == 0 ? "" : words[i + 1] ? ", " : and;
        n += (size_t)snprintf(out + n, size - n, "%s%s", between, words[i]);
    }
}

static bool read_value(struct config *c, const struct setting *s, const char *value)
{
    int *v = value_of(c, s);

    return s->words ? word(value, s->words, v) : s->yes_no ? yes_no(value, v) : number(value, s->lo, s->hi, v);
}

static void expected(const struct setting *s, const char *value, char *err, size_t err_size)
{
    char list[128];

    if (s->words)
        list_words(s->words, " or ", list, sizeof list);
    else if (s->yes_no)
        snprintf(list, sizeof list, "yes or no");
    else
        snprintf(list, sizeof list, "a number from %d to %d", s->lo, s->hi);
    snprintf(err, err_size, "%s: expected %s, got \"%s\"", s->name, list, value);
}

static bool set_lang(struct config *c, const char *value, char *err, size_t err_size)
{
    if (value[0] && !manifest_word_ok(value)) {
        snprintf(err, err_size, "lang: expected a language's name of letters, digits, _ and -, got \"%s\"", value);
        return false;
    }
    snprintf(c->lang, sizeof c->lang, "%s", value);
    return true;
}

static bool set(struct config *c, const char *name, const char *value, char *err, size_t err_size)
{
    for (int i = 0; i < SETTINGS; i++) {
        const struct setting *s = &settings[i];
        if (strcmp(name, s->name) != 0)
            continue;
        if (read_value(c, s, value))
            return true;
        expected(s, value, err, err_size);
        return false;
    }
    if (strcmp(name, "lang") == 0)
        return set_lang(c, value, err, err_size);
    if (keys_known(name))
        return keys_bind(&c->keys, name, value, err, err_size);
    snprintf(err, err_size, "no setting is called \"%s\"", name);
    return false;
}

/* s without blanks at both ends, cut in place. */
static char *trim(char *s)
{
    s += strspn(s, " \t\r");
    size_t n = strlen(s);
    while (n && strchr(" \t\r", s[n - 1]))
        s[--n] = 0;
    return s;
}

static bool read_line(struct config *c, char *line, char *err, size_t err_size)
{
    line[strcspn(line, "#")] = 0;
    char *name = trim(line), *equals = strchr(name, '=');
    if (!*name)
        return true;
    if (!equals) {
        snprintf(err, err_size, "expected name = value, got \"%s\"", name);
        return false;
    }
    *equals = 0;
    return set(c, trim(name), trim(equals + 1), err, err_size);
}

bool config_read(struct config *c, const char *file, const char *text, size_t size, char *err, size_t err_size)
{
    struct config new = *c;
    char line[CONFIG_LINE], what[CONFIG_LINE + 128];
    int at = 1;
    for (size_t i = 0; i < size; at++) {
        const char *end = memchr(text + i, '\n', size - i);
        size_t n = end ? (size_t)(end - (text + i)) : size - i;
        bool plain = n < sizeof line && !memchr(text + i, 0, n);
        if (plain) {
            memcpy(line, text + i, n);
            line[n] = 0;
        } else {
            snprintf(what, sizeof what, "not a line of text");
        }
        if (!plain || !read_line(&new, line, what, sizeof what)) {
            snprintf(err, err_size, "%s:%d: %s", file, at, what);
            return false;
        }
        i += n + 1;
    }
    *c = new;
    return true;
}

bool config_load(struct config *c, char *err, size_t err_size)
{
    config_defaults(c);
    long size = plat_size(CONFIG_FILE);
    if (size < 0)
        return true;
    char *text = size <= CONFIG_BYTES ? malloc((size_t)size + 1) : 0;
    bool good = text && plat_load(CONFIG_FILE, text, (size_t)size) == size;
    if (!good)
        snprintf(err, err_size, "%s: cannot be read, or larger than %d bytes", CONFIG_FILE, CONFIG_BYTES);
    else
        good = config_read(c, CONFIG_FILE, text, (size_t)size, err, err_size);
    free(text);
    return good;
}

void config_help(void (*line)(const char *))
{
    char text[256], value[160];
    for (int i = 0; i < SETTINGS; i++) {
        const struct setting *s = &settings[i];
        if (s->words) {
            char list[128];
            list_words(s->words, ", ", list, sizeof list);
            snprintf(value, sizeof value, "%s (%s)", s->words[s->standard], list);
        } else if (s->yes_no)
            snprintf(value, sizeof value, "%s", s->standard ? "yes (or no)" : "no (or yes)");
        else
            snprintf(value, sizeof value, "%d (%d to %d)", s->standard, s->lo, s->hi);
        snprintf(text, sizeof text, "  %-11s %-30s %s", s->name, value, s->help);
        line(text);
    }
    snprintf(text, sizeof text, "  %-11s %-30s %s", "lang", "(none)", "language, of the games that have it");
    line(text);
}
