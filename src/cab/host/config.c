/*
 * config.c - see config.h. One table is the parser, the ranges and the help.
 */
#include "config.h"
#include "../../board/rom/manifest.h"
#include "views.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static const struct setting {
    const char *name;
    size_t at; /* an int of struct config */
    int lo, hi, standard;
    bool yes_no;
    const char *const *words; /* not NULL: one of a list that ends with NULL, of which the value is the place */
    const char *help;
} settings[] = {
    { "scale", offsetof(struct config, scale), 0, 16, 0, false, NULL, "window pixels a picture pixel; 0: what fits" },
    { "volume", offsetof(struct config, volume), 0, 100, 100, false, NULL, "percent" },
    { "mute", offsetof(struct config, mute), 0, 1, 0, true, NULL, "start without sound" },
    { "resample", offsetof(struct config, resample), 0, 1, 1, true, NULL,
      "no: sound to the bit, and the card's clock leads" },
    { "fullscreen", offsetof(struct config, fullscreen), 0, 1, 0, true, NULL, "start in fullscreen" },
    { "dim", offsetof(struct config, dim), 0, 3, 0, false, views_dim,
      "backgrounds darker, by a quarter to three quarters" },
    { "flashes", offsetof(struct config, flashes), 0, 1, 0, false, views_flashes, "of the screen; soft: at a quarter" },
    { "colours", offsetof(struct config, colours), 0, 3, 0, false, views_colours, "for eyes that tell fewer apart" },
    { "hitbox", offsetof(struct config, hitbox), 0, 1, 0, true, NULL, "the ship's hit shape, always" },
};

enum { CONFIG_WORDS = 128 };
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

static bool word(const char *const *words, const char *s, int *v)
{
    const int i = views_find(words, s);

    *v = i < 0 ? *v : i;
    return i >= 0;
}

static void refuse_word(const struct setting *s, const char *value, char *err, size_t err_size)
{
    char list[CONFIG_WORDS];

    views_list(s->words, list, sizeof list);
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
        if (s->words    ? word(s->words, value, value_of(c, s))
            : s->yes_no ? yes_no(value, value_of(c, s))
                        : number(value, s->lo, s->hi, value_of(c, s)))
            return true;
        if (s->words)
            refuse_word(s, value, err, err_size);
        else if (s->yes_no)
            snprintf(err, err_size, "%s: expected yes or no, got \"%s\"", name, value);
        else
            snprintf(err, err_size, "%s: expected a number from %d to %d, got \"%s\"", name, s->lo, s->hi, value);
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
    char text[160], value[48], list[CONFIG_WORDS];
    for (int i = 0; i < SETTINGS; i++) {
        const struct setting *s = &settings[i];
        if (s->words) {
            views_list(s->words + 1, list, sizeof list);
            snprintf(value, sizeof value, "%s (or %.36s)", s->words[0], list);
        } else if (s->yes_no)
            snprintf(value, sizeof value, "%s", s->standard ? "yes (or no)" : "no (or yes)");
        else
            snprintf(value, sizeof value, "%d (%d to %d)", s->standard, s->lo, s->hi);
        snprintf(text, sizeof text, "  %-11s %-38s %s", s->name, value, s->help);
        line(text);
    }
    snprintf(text, sizeof text, "  %-11s %-38s %s", "lang", "(none)", "language, of the games that have it");
    line(text);
}
