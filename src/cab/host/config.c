/*
 * config.c - see config.h. One table is the parser, the ranges and the help.
 */
#include "config.h"
#include "../../board/rom/manifest.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static const char *const no_yes[] = { "no", "yes", NULL };
static const char *const aways[] = { "go-on", "stop", NULL };
static const char *const speeds[] = { "full", "half", "quarter", NULL };

#define AT(field) offsetof(struct config, field)
static const struct config_setting settings[] = {
    { "scale", "window size", "picture", AT(scale), 0, 16, 0, NULL, 1, "window pixels a picture pixel; 0: what fits" },
    { "fullscreen", "full screen", "picture", AT(fullscreen), 0, 1, 0, no_yes, 1, "start in full screen" },
    { "volume", "volume", "sound", AT(volume), 0, 100, 100, NULL, 10, "of everything, percent" },
    { "music", "music", "sound", AT(music), 0, 100, 100, NULL, 10, "of the music alone, percent" },
    { "sounds", "sounds", "sound", AT(sounds), 0, 100, 100, NULL, 10, "of all but the music, percent" },
    { "mute", "silent", "sound", AT(mute), 0, 1, 0, no_yes, 1, "start without sound" },
    { "resample", "follow our clock", "sound", AT(resample), 0, 1, 1, no_yes, 1,
      "no: sound to the bit, and the card's clock leads" },
    { "away", "when you go away", "playing", AT(away), 0, 1, 1, aways, 1,
      "stop: the game waits when another window has the keys" },
    { "keep_replays", "replays kept", "playing", AT(replays), 0, 1000, 50, NULL, 10,
      "so many last runs of a game are kept; those saved under a name are not counted" },
    { "resume", "go on after leaving", "playing", AT(resume), 0, 1, 1, no_yes, 1,
      "a run you leave is kept, and you are asked next time" },
    { "speed", "game speed", "playing", AT(speed), 0, 2, 0, speeds, 1, "other than full is marked in a recording" },
};
#undef AT

enum { SETTINGS = sizeof settings / sizeof *settings };

const struct config_setting *config_setting(int i)
{
    return i >= 0 && i < SETTINGS ? &settings[i] : NULL;
}

int config_value(const struct config *c, const struct config_setting *s)
{
    return *(const int *)(const void *)((const char *)c + s->at);
}

void config_put(struct config *c, const struct config_setting *s, int value)
{
    *(int *)(void *)((char *)c + s->at) = value < s->lo ? s->lo : value > s->hi ? s->hi : value;
}

void config_text(const struct config *c, const struct config_setting *s, char *out, size_t size)
{
    const int v = config_value(c, s);

    if (s->words)
        snprintf(out, size, "%s", s->words[v]);
    else
        snprintf(out, size, "%d", v);
}

void config_defaults(struct config *c)
{
    keys_defaults(&c->keys);
    memset(c->lang, 0, sizeof c->lang);
    for (int i = 0; i < SETTINGS; i++)
        config_put(c, &settings[i], settings[i].standard);
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

static bool word(const char *s, const char *const *words, int *v)
{
    for (*v = 0; words[*v]; ++*v)
        if (strcmp(s, words[*v]) == 0)
            return true;
    return false;
}

/* "yes or no", "whole, smooth or none" */
static void list_words(const char *const *words, char *out, size_t size)
{
    size_t n = 0;

    for (int i = 0; words[i] && n < size; i++)
        n += (size_t)snprintf(out + n, size - n, "%s%s", i == 0 ? "" : words[i + 1] ? ", " : " or ", words[i]);
}

static bool set_value(struct config *c, const struct config_setting *s, const char *value, char *err, size_t err_size)
{
    char words[128];
    int v;

    if (s->words ? word(value, s->words, &v) : number(value, s->lo, s->hi, &v)) {
        config_put(c, s, v);
        return true;
    }
    if (s->words) {
        list_words(s->words, words, sizeof words);
        snprintf(err, err_size, "%s: expected %s, got \"%s\"", s->name, words, value);
    } else {
        snprintf(err, err_size, "%s: expected a number from %d to %d, got \"%s\"", s->name, s->lo, s->hi, value);
    }
    return false;
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
    for (int i = 0; i < SETTINGS; i++)
        if (strcmp(name, settings[i].name) == 0)
            return set_value(c, &settings[i], value, err, err_size);
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
    char text[320], value[192], words[128], standard[32];
    struct config c;

    config_defaults(&c);
    for (int i = 0; i < SETTINGS; i++) {
        const struct config_setting *s = &settings[i];
        config_text(&c, s, standard, sizeof standard);
        if (s->words)
            list_words(s->words, words, sizeof words);
        else
            snprintf(words, sizeof words, "%d to %d", s->lo, s->hi);
        snprintf(value, sizeof value, "%s (%s)", standard, words);
        snprintf(text, sizeof text, "  %-11s %-30s %s", s->name, value, s->help);
        line(text);
    }
    snprintf(text, sizeof text, "  %-11s %-30s %s", "lang", "(none)", "language, of the games that have it");
    line(text);
}
