/*
 * screen_settings.c - the settings: the table of config.c, the language, and a row that opens the key bindings. A
 * change takes effect at once; the file is written when the screen is closed.
 */
#include <stdio.h>
#include <string.h>
#include "play_state.h"
#include "../../../platform/platform.h"

static void add(struct settings_list *l, enum settings_row kind, const struct config_setting *s)
{
    if (l->rows == SETTINGS_ROWS)
        return;
    l->row[l->rows].kind = kind;
    l->row[l->rows++].setting = s;
}

static void make_list(struct settings_list *l, const struct cart *cart)
{
    const struct config_setting *s, *before = NULL;

    l->rows = 0;
    for (int i = 0; (s = config_setting(i)) != NULL; i++, before = s) {
        if (!before || strcmp(before->group, s->group) != 0)
            add(l, SETTINGS_GROUP, s);
        add(l, SETTINGS_VALUE, s);
    }
    if (cart->count[CART_LANGS] > 0)
        add(l, SETTINGS_LANGUAGE, NULL);
    add(l, SETTINGS_TO_KEYS, NULL);
}

/* ---- language ---- */

/* The language's number, from 1 on; 0: the strings in the scripts. */
static int lang_number(const struct cart *cart, const char *name)
{
    for (int i = 0; i < cart->count[CART_LANGS]; i++)
        if (strcmp(cart_name(cart, CART_LANGS, i), name) == 0)
            return i + 1;
    return 0;
}

static void change_lang(struct play *play, int by)
{
    const struct cart *cart = play_cart(play);
    struct config *c = &play->config;
    const int n = cart->count[CART_LANGS] + 1, to = (lang_number(cart, c->lang) + (by < 0 ? -1 : 1) + n) % n;

    snprintf(c->lang, sizeof c->lang, "%s", to ? cart_name(cart, CART_LANGS, to - 1) : "");
    memcpy(play->saved_config.lang, c->lang, sizeof c->lang);
}

/* ---- rows ---- */

static int rows(void *context)
{
    return ((struct play *)context)->settings_list.rows;
}

static void describe_value(struct play *play, const struct config_setting *s, struct screen_row *row)
{
    config_label(&play->config, s, row->value, sizeof row->value);
    snprintf(row->label, sizeof row->label, "%s", s->label);
    screen_sentence(row->help, sizeof row->help, s->help);
    row->changes = true;
}

static void describe(void *context, int at, struct screen_row *row)
{
    struct play *play = context;

    switch (play->settings_list.row[at].kind) {
    case SETTINGS_GROUP:
        snprintf(row->label, sizeof row->label, "%s", play->settings_list.row[at].setting->group);
        row->heading = true;
        break;
    case SETTINGS_VALUE:
        describe_value(play, play->settings_list.row[at].setting, row);
        break;
    case SETTINGS_LANGUAGE:
        snprintf(row->label, sizeof row->label, "Language");
        snprintf(row->value, sizeof row->value, "%s", play->config.lang[0] ? play->config.lang : "Default");
        snprintf(row->help, sizeof row->help, "Takes effect when the game restarts.");
        row->changes = true;
        break;
    case SETTINGS_TO_KEYS:
        snprintf(row->label, sizeof row->label, "Key Bindings");
        snprintf(row->help, sizeof row->help, "Change what each key and button does.");
        break;
    }
}

/* The next value. Words wrap around; numbers stop at the limits. */
static void change_value(struct play *play, const struct config_setting *s, int by)
{
    const int v = config_value(&play->config, s), n = s->hi - s->lo + 1;

    config_put(&play->config, s, s->words ? s->lo + (v - s->lo + (by < 0 ? -1 : 1) + n) % n : v + by * s->step);
    config_put(&play->saved_config, s, config_value(&play->config, s));
    play_apply_settings(play);
}

static void change(void *context, int at, int by)
{
    struct play *play = context;

    if (play->settings_list.row[at].kind == SETTINGS_VALUE)
        change_value(play, play->settings_list.row[at].setting, by);
    else if (play->settings_list.row[at].kind == SETTINGS_LANGUAGE)
        change_lang(play, by);
}

static void accept(void *context, int at)
{
    struct play *play = context;

    if (play->settings_list.row[at].kind == SETTINGS_TO_KEYS)
        play_open_keys(play);
}

static void closed(void *context)
{
    struct play *play = context;
    const bool changed = strcmp(play->config.lang, play->settings_list.lang) != 0;

    play_save_settings(play);
    if (play->quit || play->session.demo || !changed)
        return;
    screens_ask(&play->screens, "Restart now to change the language? The current run ends.", "Restart", play_restart,
                play);
}

static const struct screen_def settings = {
    .title = "Settings", .rows = rows, .row = describe, .change = change, .accept = accept, .closed = closed
};

/* ---- opening, saving, applying ---- */

void play_open_settings(struct play *play)
{
    play->config.volume = play->speaker.volume; /* keys may have changed these temporarily */
    play->config.mute = play->speaker.muted;
    play->config.speed = play->time.slow == 4 ? 2 : play->time.slow - 1;
    memcpy(play->settings_list.lang, play->config.lang, sizeof play->settings_list.lang);
    make_list(&play->settings_list, play_cart(play));
    screens_open(&play->screens, &settings, play);
}

void play_save_settings(struct play *play)
{
    char err[FILES_ERR_SIZE + CONFIG_LINE], path[FILES_PATH_SIZE];
    size_t folder = strlen(files_display_name(CONFIG_FILE, path));

    play->unsaved.settings = !config_save(&play->saved_config, err, sizeof err);
    if (!play->unsaved.settings)
        return;
    while (folder > 0 && path[folder - 1] != '/')
        folder--;
    play_save_failed(play, err);
    /* a small menu has three lines: leave out the folder, which the message and the log contain */
    screens_show_message(&play->screens, "Not saved: %s", strncmp(err, path, folder) == 0 ? err + folder : err);
}

/* All other settings are read where they are used. */
void play_apply_settings(struct play *play)
{
    const struct config *c = &play->config;
    const int slow = 1 << c->speed;

    play_pads_apply(play);
    play->speaker.volume = c->volume;
    play->speaker.muted = c->mute;
    speaker_set_levels(&play->speaker, c->music, c->sounds);
    if (slow != play->time.slow)
        play_mark_assisted(play);
    play->time.slow = slow;
    play_update_window(play);
}
