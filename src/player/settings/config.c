/*
 * config.c - reads settings (config.h). One table defines names, ranges, labels and help.
 */
#include "config.h"
#include "../../base/err.h"
#include "../../rom/manifest.h"
#include "../../common/files.h"
#include "views.h"

#include <limits.h>
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

/* The same values on the settings screen. */
static const char *const off_on[] = { "Off", "On" };
static const char *const away_labels[] = { "Run", "Pause" };
static const char *const focus_labels[] = { "Hold", "Toggle" };
static const char *const hand_labels[] = { "Off", "Left", "Right" };
static const char *const turn_labels[] = { "Off", "Left", "Right", "Upside Down" };
static const char *const scaling_labels[] = { "Sharp", "Smooth" };
static const char *const place_labels[] = { "Overlay", "Beside" };
static const char *const dim_labels[] = { "Off", "25%", "50%", "75%" };
static const char *const flash_labels[] = { "Full", "Soft" };
static const char *const colour_labels[] = { "Off", "Red", "Green", "Blue" };

#define DIP_PREFIX "dip."

#define AT(field) offsetof(struct config, field)
static const struct config_setting settings[] = {
    { "scale", "Window Size", "Display", AT(scale), 0, 16, 0, NULL, NULL, 1,
      "enlarge the picture this many times, or to fit the screen", "x", "Auto" },
    { "fullscreen", "Fullscreen", "Display", AT(fullscreen), 0, 1, 0, no_yes, off_on, 1, "fill the whole screen", NULL,
      NULL },
    { "turn", "Rotate", "Display", AT(rotation), 0, 3, 0, turns, turn_labels, 1,
      "rotate the picture for a monitor that is turned", NULL, NULL },
    { "scaling", "Scaling", "Display", AT(scaling), 0, 1, 0, scalings, scaling_labels, 1,
      "show sharp pixels of one size, or fill the whole window", NULL, NULL },
    { "crt", "CRT Filter", "Display", AT(crt), 0, 1, 0, no_yes, off_on, 1, "look like the screen of an old television",
      NULL, NULL },
    { "border", "Border", "Display", AT(border), 0, 1, 1, no_yes, off_on, 1, "show the game's art around the picture",
      NULL, NULL },
    { "panels", "Messages", "Display", AT(panels), 0, 1, 0, places, place_labels, 1,
      "messages over the picture, or beside it in a wide window", NULL, NULL },
    { "vsync", "VSync", "Display", AT(vsync), 0, 1, 1, no_yes, off_on, 1, "show each frame in step with the display",
      NULL, NULL },
    { "run_ahead", "Faster Response", "Display", AT(run_ahead), 0, 1, 0, NULL, NULL, 1,
      "react to a button a frame sooner; needs a fast computer", " frame", "Off" },
    { "volume", "Volume", "Sound", AT(volume), 0, 100, 100, NULL, NULL, 10, "overall volume in percent", "%", NULL },
    { "music", "Music", "Sound", AT(music), 0, 100, 100, NULL, NULL, 10, "volume of the music in percent", "%", NULL },
    { "sounds", "Sound Effects", "Sound", AT(sounds), 0, 100, 100, NULL, NULL, 10,
      "volume of everything but the music in percent", "%", NULL },
    { "mute", "Mute", "Sound", AT(mute), 0, 1, 0, no_yes, off_on, 1, "turn all sound off", NULL, NULL },
    { "resample", "Sync to Game", "Sound", AT(resample), 0, 1, 1, no_yes, off_on, 1,
      "stretch the sound slightly to keep time with the game", NULL, NULL },
    { "dim", "Dim Background", "Accessibility", AT(dim), 0, 3, 0, views_dim, dim_labels, 1,
      "darken the background so that bullets stand out", NULL, NULL },
    { "flashes", "Flashes", "Accessibility", AT(flashes), 0, 1, 0, views_flashes, flash_labels, 1,
      "weaken flashes of the screen", NULL, NULL },
    { "colours", "Colour-Blind", "Accessibility", AT(colours), 0, 3, 0, views_colours, colour_labels, 1,
      "help with red (protan), green (deutan) or blue (tritan)", NULL, NULL },
    { "hitbox", "Show Hitbox", "Accessibility", AT(hitbox), 0, 1, 0, no_yes, off_on, 1, "always show the ship's hitbox",
      NULL, NULL },
    { "large_hud", "Larger HUD", "Accessibility", AT(large_hud), 0, 1, 0, no_yes, off_on, 1,
      "show scores and lives in larger letters; restarts the game", NULL, NULL },
    { "speed", "Game Speed", "Accessibility", AT(speed), 25, 100, 100, NULL, NULL, 5,
      "slow the game down; the run is marked as assisted", "%", NULL },
    { "autofire", "Autofire", "Accessibility", AT(autofire[0]), 0, 1, 0, no_yes, off_on, 1,
      "shoot 15 times a second while fire is held", NULL, NULL },
    { "focus", "Focus", "Accessibility", AT(focus[0]), 0, 1, 0, focus_words, focus_labels, 1,
      "hold the focus button, or press it to switch focus", NULL, NULL },
    { "one_hand", "One Hand", "Accessibility", AT(one_hand[0]), 0, 2, 0, hand_words, hand_labels, 1,
      "use half of the keyboard or controller; fire is automatic", NULL, NULL },
    { "autofire2", "Autofire", "Accessibility", AT(autofire[1]), 0, 1, 0, no_yes, off_on, 1, "autofire for player 2",
      NULL, NULL },
    { "focus2", "Focus", "Accessibility", AT(focus[1]), 0, 1, 0, focus_words, focus_labels, 1,
      "focus mode for player 2", NULL, NULL },
    { "one_hand2", "One Hand", "Accessibility", AT(one_hand[1]), 0, 2, 0, hand_words, hand_labels, 1,
      "one-handed layout for player 2", NULL, NULL },
    { "away", "In Background", "Gameplay", AT(away), 0, 1, 1, aways, away_labels, 1,
      "what happens when you switch to another window", NULL, NULL },
    { "keep_replays", "Saved Replays", "Gameplay", AT(replays), 0, 1000, 50, NULL, NULL, 10,
      "how many recent runs are saved; named ones don't count", NULL, "None" },
    { "resume", "Resume Runs", "Gameplay", AT(resume), 0, 1, 1, no_yes, off_on, 1,
      "save an unfinished run and offer to resume it next time", NULL, NULL },
    { "hints", "Button Hints", "Gameplay", AT(hints), 0, 1, 1, no_yes, off_on, 1,
      "show what the buttons do during dialogue", NULL, NULL },
    { "capture_seconds", "Clip Length", "Gameplay", AT(capture_seconds), 5, 60, 10, NULL, NULL, 5,
      "how much of the run the clip key saves as a GIF", " s", NULL },
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

void config_label(const struct config *c, const struct config_setting *s, char *out, size_t size)
{
    const int v = config_value(c, s);

    if (s->labels)
        snprintf(out, size, "%s", s->labels[v]);
    else if (s->zero && v == 0)
        snprintf(out, size, "%s", s->zero);
    else
        snprintf(out, size, "%d%s", v, s->unit ? s->unit : "");
}

void config_defaults(struct config *c)
{
    keys_set_defaults(&c->keys);
    memset(c->lang, 0, sizeof c->lang);
    c->n_dips = 0;
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

/* Writes the values that a setting can have. */
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
    return err_set(err, err_size, "%s: expected %s%s, got \"%s\"", s->name, s->words ? "" : "a number from ", values,
                   value);
}

static bool set_lang(struct config *c, const char *value, char *err, size_t err_size)
{
    if (value[0] && !manifest_setting_name_ok(value))
        return err_set(err, err_size, "lang: expected a language name of letters, digits, _ and -, got \"%s\"", value);
    snprintf(c->lang, sizeof c->lang, "%s", value);
    return true;
}

/* Returns the index of the DIP switch with that full name, or n_dips. */
static int find_dip(const struct config *c, const char *full)
{
    int i = 0;

    while (i < c->n_dips && strcmp(c->dips[i].name, full) != 0)
        i++;
    return i;
}

/* Returns false if there is no room for it. */
static bool put_dip(struct config *c, const char *full, const char *value)
{
    const int i = find_dip(c, full);

    if (i == CONFIG_MAX_DIPS || strlen(full) >= sizeof c->dips[i].name)
        return false;
    snprintf(c->dips[i].name, sizeof c->dips[i].name, "%s", full);
    snprintf(c->dips[i].value, sizeof c->dips[i].value, "%s", value);
    c->n_dips += i == c->n_dips;
    return true;
}

const char *config_dip(const struct config *c, const char *id, const char *name)
{
    char full[sizeof c->dips[0].name];

    snprintf(full, sizeof full, DIP_PREFIX "%s.%s", id, name);
    const int i = find_dip(c, full);
    return i < c->n_dips ? c->dips[i].value : NULL;
}

void config_put_dip(struct config *c, const char *id, const char *name, const char *value)
{
    char full[sizeof c->dips[0].name];

    snprintf(full, sizeof full, DIP_PREFIX "%s.%s", id, name);
    put_dip(c, full, value);
}

static bool set_dip(struct config *c, const char *full, const char *value, char *err, size_t err_size)
{
    if (!manifest_setting_name_ok(value) && !number(value, INT_MIN, INT_MAX, &(int){ 0 }))
        return err_set(err, err_size, "%s: expected a name or a number, got \"%s\"", full, value);
    return put_dip(c, full, value) ||
           err_set(err, err_size, "%s: more than %d DIP switches, or the name is too long", full, CONFIG_MAX_DIPS);
}

static bool set(struct config *c, const char *name, const char *value, char *err, size_t err_size)
{
    for (int i = 0; i < SETTINGS; i++)
        if (strcmp(name, settings[i].name) == 0)
            return set_value(c, &settings[i], value, err, err_size);
    if (strcmp(name, "lang") == 0)
        return set_lang(c, value, err, err_size);
    if (strncmp(name, DIP_PREFIX, strlen(DIP_PREFIX)) == 0)
        return set_dip(c, name, value, err, err_size);
    if (keys_is_action(name))
        return keys_bind(&c->keys, name, value, err, err_size);
    return err_set(err, err_size, "unknown setting \"%s\"", name);
}

/* Removes blanks at both ends of s, in place. */
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
    if (!equals)
        return err_set(err, err_size, "expected name = value, got \"%s\"", name);
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
            snprintf(what, sizeof what, "expected a line of text");
        }
        if (!plain || !read_line(&new, line, what, sizeof what))
            return err_set(err, err_size, "%s:%d: %s", file, at, what);
        i += n + 1;
    }
    *c = new;
    return true;
}

bool config_load(struct config *c, char *err, size_t err_size)
{
    char shown[FILES_PATH_SIZE];
    uint8_t *text;
    size_t size;

    config_defaults(c);
    if (plat_file_size(CONFIG_FILE) < 0)
        return true;
    files_display_name(CONFIG_FILE, shown);
    if (!files_read_text(CONFIG_FILE, shown, CONFIG_BYTES, &text, &size, err, err_size))
        return err_set(err, err_size, "%s: cannot be read, or is larger than %d bytes", shown, CONFIG_BYTES);
    const bool good = config_read(c, shown, (const char *)text, size, err, err_size);
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
        snprintf(text, sizeof text, "  %-15s %-42s %s", s->name, value, s->help);
        line(text);
    }
    snprintf(text, sizeof text, "  %-15s %-42s %s", "lang", "(none)", "language, in games with more than one");
    line(text);
    snprintf(text, sizeof text, "  %-15s %-42s %s", "dip.GAME.NAME", "(the game's)", "one of the game's DIP switches");
    line(text);
}
