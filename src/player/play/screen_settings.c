/*
 * screen_settings.c - the settings on the screen: the table of config.c, the language, and the way to the keys. A
 * change takes effect at once; the file is written when the screen is left.
 */
#include <stdio.h>
#include <string.h>
#include "cab_parts.h"
#include "../../../platform/platform.h"

static void add(struct cab *cab, enum settings_row kind, const struct config_setting *s)
{
    if (cab->list.rows == SETTINGS_ROWS)
        return;
    cab->list.row[cab->list.rows].kind = kind;
    cab->list.row[cab->list.rows++].setting = s;
}

static void make_list(struct cab *cab)
{
    const struct config_setting *s, *before = NULL;

    cab->list.rows = 0;
    for (int i = 0; (s = config_setting(i)) != NULL; i++, before = s) {
        if (!before || strcmp(before->group, s->group) != 0)
            add(cab, SETTINGS_GROUP, s);
        add(cab, SETTINGS_VALUE, s);
    }
    if (cab_cart(cab)->count[CART_LANGS] > 0)
        add(cab, SETTINGS_LANGUAGE, NULL);
    add(cab, SETTINGS_TO_KEYS, NULL);
}

/* ---- language ---- */

/* The language's number, from 1 on; 0: the words that scripts have. */
static int lang_number(struct cab *cab, const char *name)
{
    for (int i = 0; i < cab_cart(cab)->count[CART_LANGS]; i++)
        if (strcmp(cart_name(cab_cart(cab), CART_LANGS, i), name) == 0)
            return i + 1;
    return 0;
}

static void change_lang(struct cab *cab, int by)
{
    const int n = cab_cart(cab)->count[CART_LANGS] + 1,
              to = (lang_number(cab, cab->config.lang) + (by < 0 ? -1 : 1) + n) % n;

    snprintf(cab->config.lang, sizeof cab->config.lang, "%s", to ? cart_name(cab_cart(cab), CART_LANGS, to - 1) : "");
    memcpy(cab->kept.lang, cab->config.lang, sizeof cab->kept.lang);
}

/* ---- rows ---- */

static int rows(void *of)
{
    struct cab *cab = of;

    return cab->list.rows;
}

static void describe_value(struct cab *cab, const struct config_setting *s, struct screen_row *row)
{
    config_label(&cab->config, s, row->value, sizeof row->value);
    snprintf(row->label, sizeof row->label, "%s", s->label);
    screen_sentence(row->help, sizeof row->help, s->help);
    row->changes = true;
}

static void describe(void *of, int at, struct screen_row *row)
{
    struct cab *cab = of;

    switch (cab->list.row[at].kind) {
    case SETTINGS_GROUP:
        snprintf(row->label, sizeof row->label, "%s", cab->list.row[at].setting->group);
        row->heading = true;
        break;
    case SETTINGS_VALUE:
        describe_value(cab, cab->list.row[at].setting, row);
        break;
    case SETTINGS_LANGUAGE:
        snprintf(row->label, sizeof row->label, "Language");
        snprintf(row->value, sizeof row->value, "%s", cab->config.lang[0] ? cab->config.lang : "Default");
        snprintf(row->help, sizeof row->help, "Takes effect when the game restarts.");
        row->changes = true;
        break;
    case SETTINGS_TO_KEYS:
        snprintf(row->label, sizeof row->label, "Key Bindings");
        snprintf(row->help, sizeof row->help, "Change what each key and button does.");
        break;
    }
}

/* The next value, round the ends for words; numbers stop there. */
static void change_value(struct cab *cab, const struct config_setting *s, int by)
{
    const int v = config_value(&cab->config, s), n = s->hi - s->lo + 1;

    config_put(&cab->config, s, s->words ? s->lo + (v - s->lo + (by < 0 ? -1 : 1) + n) % n : v + by * s->step);
    config_put(&cab->kept, s, config_value(&cab->config, s));
    cab_apply_settings(cab);
}

static void change(void *of, int at, int by)
{
    struct cab *cab = of;

    if (cab->list.row[at].kind == SETTINGS_VALUE)
        change_value(cab, cab->list.row[at].setting, by);
    else if (cab->list.row[at].kind == SETTINGS_LANGUAGE)
        change_lang(cab, by);
}

static void accept(void *of, int at)
{
    struct cab *cab = of;

    if (cab->list.row[at].kind == SETTINGS_TO_KEYS)
        cab_open_keys(cab);
}

static void begin_anew(void *of)
{
    struct cab *cab = of;

    screens_close_all(&cab->screens);
    cab_begin_anew(cab);
}

static void closed(void *of)
{
    struct cab *cab = of;
    const bool other = strcmp(cab->config.lang, cab->list.lang) != 0;

    cab_save_settings(cab);
    if (cab->quit || cab->session.demo || !other)
        return;
    screens_ask(&cab->screens, "Restart now to change the language? The current run ends.", "Restart", begin_anew, cab);
}

static const struct screen_def settings = {
    .title = "Settings", .rows = rows, .row = describe, .change = change, .accept = accept, .closed = closed
};

/* ---- what others call ---- */

void cab_open_settings(struct cab *cab)
{
    cab->config.volume = cab->speaker.volume; /* keys may have changed these for now */
    cab->config.mute = cab->speaker.muted;
    cab->config.speed = cab->slow == 4 ? 2 : cab->slow - 1;
    memcpy(cab->list.lang, cab->config.lang, sizeof cab->list.lang);
    make_list(cab);
    screens_open(&cab->screens, &settings, cab);
}

void cab_save_settings(struct cab *cab)
{
    char err[FILES_ERR_SIZE + CONFIG_LINE], path[FILES_PATH_SIZE];
    size_t folder = strlen(files_display_name(CONFIG_FILE, path));

    cab->unsaved.settings = !config_save(&cab->kept, err, sizeof err);
    if (!cab->unsaved.settings)
        return;
    while (folder > 0 && path[folder - 1] != '/')
        folder--;
    cab_save_failed(cab, err);
    /* a small menu has three lines: the why matters, the folder stands in the notice and the log */
    screens_say(&cab->screens, "Not saved: %s", strncmp(err, path, folder) == 0 ? err + folder : err);
}

/* Other settings than these are read where they are used. */
void cab_apply_settings(struct cab *cab)
{
    const struct config *c = &cab->config;
    const int slow = 1 << c->speed;

    cab_pads_apply(cab);
    cab->speaker.volume = c->volume;
    cab->speaker.muted = c->mute;
    speaker_levels(&cab->speaker, c->music, c->sounds);
    if (slow != cab->slow)
        cab_mark_assisted(cab);
    cab->slow = slow;
    cab->quit = !cab_open_window(cab) || cab->quit;
}
