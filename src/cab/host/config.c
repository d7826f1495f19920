/*
 * config.c - see config.h. One table is the parser, the ranges and the help.
 */
#include "config.h"
#include "../../board/rom/manifest.h"
#include "files.h"
#include "views.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static const char *const no_yes[] = { "no", "yes", NULL };
static const char *const aways[] = { "go-on", "stop", NULL };
static const char *const focus_words[] = { "hold", "toggle", NULL };
static const char *const hand_words[] = { "no", "left", "right", NULL }; /* enum keys_hand */
static const char *const turns[] = { "none", "left", "right", "over", NULL };
static const char *const scalings[] = { "whole", "smooth", NULL };
static const char *const places[] = { "over", "beside", NULL };
static const char *const speeds[] = { "full", "half", "quarter", NULL };

#define AT(field) offsetof(struct config, field)
static const struct config_setting settings[] = {
    { "scale", "window size", "picture", AT(scale), 0, 16, 0, NULL, 1, "window pixels a picture pixel; 0: what fits",
      "x", "what fits" },
    { "fullscreen", "full screen", "picture", AT(fullscreen), 0, 1, 0, no_yes, 1, "the picture fills the screen", NULL,
      NULL },
    { "turn", "turn the picture", "picture", AT(turn), 0, 3, 0, turns, 1, "for a monitor that stands upright", NULL,
      NULL },
    { "scaling", "scaling", "picture", AT(scaling), 0, 1, 0, scalings, 1, "smooth: as large as the window allows", NULL,
      NULL },
    { "crt", "tube look", "picture", AT(crt), 0, 1, 0, no_yes, 1, "the lines and the mask of a tube", NULL, NULL },
    { "border", "border", "picture", AT(border), 0, 1, 1, no_yes, 1, "art round the picture, of games that bring it",
      NULL, NULL },
    { "panels", "panels", "picture", AT(panels), 0, 1, 0, places, 1, "messages and panels, if the window is wide", NULL,
      NULL },
    { "vsync", "wait for the screen", "picture", AT(vsync), 0, 1, 1, no_yes, 1,
      "show pictures when the screen takes them", NULL, NULL },
    { "run_ahead", "run ahead", "picture", AT(run_ahead), 0, 1, 0, NULL, 1,
      "frames: 1 shows the frame after this, and answers sooner", " frame", "no" },
    { "dim", "dim backgrounds", "seeing", AT(dim), 0, 3, 0, views_dim, 1,
      "backgrounds darker, by a quarter to three quarters", NULL, NULL },
    { "flashes", "flashes", "seeing", AT(flashes), 0, 1, 0, views_flashes, 1, "of the screen; soft: at a quarter", NULL,
      NULL },
    { "colours", "colours for", "seeing", AT(colours), 0, 3, 0, views_colours, 1, "for eyes that tell fewer apart",
      NULL, NULL },
    { "hitbox", "show hit shapes", "seeing", AT(hitbox), 0, 1, 0, no_yes, 1, "the ship's hit shape, always", NULL,
      NULL },
    { "volume", "volume", "sound", AT(volume), 0, 100, 100, NULL, 10, "of everything, percent", " %", NULL },
    { "music", "music", "sound", AT(music), 0, 100, 100, NULL, 10, "of the music alone, percent", " %", NULL },
    { "sounds", "sounds", "sound", AT(sounds), 0, 100, 100, NULL, 10, "of all but the music, percent", " %", NULL },
    { "mute", "silent", "sound", AT(mute), 0, 1, 0, no_yes, 1, "no sound at all", NULL, NULL },
    { "resample", "follow our clock", "sound", AT(resample), 0, 1, 1, no_yes, 1,
      "no: sound to the bit, and the card's clock leads", NULL, NULL },
    { "away", "when you go away", "playing", AT(away), 0, 1, 1, aways, 1,
      "stop: the game waits when another window has the keys", NULL, NULL },
    { "keep_replays", "replays kept", "playing", AT(replays), 0, 1000, 50, NULL, 10,
      "the last runs of a game; what has a name is not counted", NULL, "none" },
    { "resume", "go on after leaving", "playing", AT(resume), 0, 1, 1, no_yes, 1,
      "a run you leave is kept, and you are asked next time", NULL, NULL },
    { "capture_seconds", "seconds filmed", "playing", AT(capture_seconds), 5, 60, 10, NULL, 5,
      "how much of the play the capture key makes a GIF of", " s", NULL },
    { "speed", "game speed", "playing", AT(speed), 0, 2, 0, speeds, 1, "other than full is marked in a recording", NULL,
      NULL },
    { "autofire", "autofire", "player 1", AT(autofire[0]), 0, 1, 0, no_yes, 1,
      "fire that is held fires 15 times a second", NULL, NULL },
    { "focus", "focus", "player 1", AT(focus[0]), 0, 1, 0, focus_words, 1,
      "toggle: a press of focus switches it, and it stays", NULL, NULL },
    { "one_hand", "one hand", "player 1", AT(one_hand[0]), 0, 2, 0, hand_words, 1,
      "that half of keyboard and controller; fire holds itself", NULL, NULL },
    { "autofire2", "autofire", "player 2", AT(autofire[1]), 0, 1, 0, no_yes, 1, "autofire of the second player", NULL,
      NULL },
    { "focus2", "focus", "player 2", AT(focus[1]), 0, 1, 0, focus_words, 1, "how the second player's focus does", NULL,
      NULL },
    { "one_hand2", "one hand", "player 2", AT(one_hand[1]), 0, 2, 0, hand_words, 1, "the second player's hand", NULL,
      NULL },
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

/* What a setting may be, for a sentence. */
static void list_values(const struct config_setting *s, char *out, size_t size)
{
    if (s->words == no_yes)
        snprintf(out, size, "yes or no");
    else if (s->words)
        views_list(s->words, out, size);
    else
        snprintf(out, size, "%d to %d", s->lo, s->hi);
}

static bool set_value(struct config *c, const struct config_setting *s, const char *value, char *err, size_t err_size)
{
    char values[128];
    int v;

    if (s->words ? (v = views_find(s->words, value)) >= 0 : number(value, s->lo, s->hi, &v)) {
        config_put(c, s, v);
        return true;
    }
    list_values(s, values, sizeof values);
    snprintf(err, err_size, "%s: expected %s%s, got \"%s\"", s->name, s->words ? "" : "a number from ", values, value);
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
    char shown[FILES_PATH];
    long size = plat_size(CONFIG_FILE);
    if (size < 0)
        return true;
    files_shown(CONFIG_FILE, shown);
    char *text = size <= CONFIG_BYTES ? malloc((size_t)size + 1) : 0;
    bool good = text && plat_load(CONFIG_FILE, text, (size_t)size) == size;
    if (!good)
        snprintf(err, err_size, "%s: cannot be read, or larger than %d bytes", shown, CONFIG_BYTES);
    if (good) {
        size_t n = (size_t)size;
        text[n] = 0;
        files_drop_mark(text, &n);
        good = config_read(c, shown, text, n, err, err_size);
    }
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
        list_values(s, words, sizeof words);
        snprintf(value, sizeof value, "%s (%s)", standard, words);
        snprintf(text, sizeof text, "  %-11s %-30s %s", s->name, value, s->help);
        line(text);
    }
    snprintf(text, sizeof text, "  %-11s %-30s %s", "lang", "(none)", "language, of the games that have it");
    line(text);
}
