/*
 * screen_settings.c - the settings: a page for each group in the table of config.c, key bindings, controllers, and the
 * language. A change takes effect at once; the file is written when the page is closed.
 */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "play_state.h"
#include "../../../platform/platform.h"
#include "../../base/int.h"

static void save_on_close(void *context)
{
    play_save_settings(context);
}

/* ---- a page: the settings with the same `page` ---- */

enum { PAGE_ROWS = 32 };

/* Settings of player 2 have names that end with 2. They are shown in games for two players. */
static bool is_second(const struct config_setting *s)
{
    return s->name[strlen(s->name) - 1] == '2';
}

static bool is_shown(const struct play *play, const struct config_setting *s)
{
    return strcmp(s->page, play->settings_page) == 0 && (!is_second(s) || play_cart(play)->manifest.players > 1);
}

/* Returns whether players have this setting of their own. */
static bool is_of_player(const struct play *play, const struct config_setting *s)
{
    const size_t n = strlen(s->name);
    const struct config_setting *other;

    for (int i = 0; (other = config_setting(i)) != NULL && play_cart(play)->manifest.players > 1; i++)
        if (is_second(other) && strlen(other->name) == n + 1 && strncmp(other->name, s->name, n) == 0)
            return true;
    return is_second(s);
}

/* Lists the settings of the page, and NULL for the headings of players. Returns the number of rows. */
static int list_page(const struct play *play, const struct config_setting *out[PAGE_ROWS])
{
    const struct config_setting *s;
    int n = 0, player = 0; /* whose settings have begun; 0: nobody's */

    for (int i = 0; (s = config_setting(i)) != NULL && n + 2 <= PAGE_ROWS; i++) {
        if (!is_shown(play, s))
            continue;
        const int of = !is_of_player(play, s) ? 0 : is_second(s) ? 2 : 1;
        if (of != player)
            out[n++] = NULL;
        out[n++] = s;
        player = of;
    }
    return n;
}

static int page_rows(void *context)
{
    const struct config_setting *list[PAGE_ROWS];

    return list_page(context, list);
}

static void page_row(void *context, int at, struct screen_row *row)
{
    const struct play *play = context;
    const struct config_setting *list[PAGE_ROWS];

    list_page(play, list);
    const struct config_setting *s = list[at];
    row->heading = s == NULL;
    row->changes = s != NULL;
    snprintf(row->label, sizeof row->label, "%s", s ? s->label : is_second(list[at + 1]) ? "Player 2" : "Player 1");
    if (!s)
        return;
    config_label(&play->config, s, row->value, sizeof row->value);
    screen_sentence(row->help, sizeof row->help, s->help);
}

/* Words wrap around; numbers stop at the limits. */
static void page_change(void *context, int at, int by)
{
    struct play *play = context;
    const struct config_setting *list[PAGE_ROWS];

    list_page(play, list);
    const struct config_setting *s = list[at];
    const int v = config_value(&play->config, s), n = s->hi - s->lo + 1;

    config_put(&play->config, s, s->words ? s->lo + (v - s->lo + (by < 0 ? -1 : 1) + n) % n : v + by * s->step);
    config_put(&play->saved_config, s, config_value(&play->config, s));
    play_apply_settings(play);
}

#define PAGE(title_)                                                                                                   \
    {                                                                                                                  \
        .title = (title_), .rows = page_rows, .row = page_row, .change = page_change, .closed = save_on_close          \
    }
static const struct screen_def display_page = PAGE("Display"), sound_page = PAGE("Sound"),
                               accessibility_page = PAGE("Accessibility"), gameplay_page = PAGE("Gameplay");
#undef PAGE

/* ---- the game's DIP switches ---- */

int32_t play_dip_value(const struct play *play, int i)
{
    const struct manifest *m = &play_cart(play)->manifest;
    const struct dip *dip = &m->dips[i];
    const char *value = config_dip(&play->config, m->id, dip->name);

    for (int k = 0; value && k < dip->n_values; k++)
        if (strcmp(dip->value_name[k], value) == 0)
            return k;
    const long n = value && dip->is_number ? strtol(value, NULL, 10) : dip->default_value;
    return n < dip->lo || n > dip->hi ? dip->default_value : (int32_t)n;
}

/* Writes a name of the manifest as players read it: "free_play" as "Free Play". */
static void write_title(char *out, size_t size, const char *name)
{
    snprintf(out, size, "%s", name);
    for (char *s = out; *s; s++) {
        if (*s == '_')
            *s = ' ';
        if ((s == out || s[-1] == ' ') && *s >= 'a' && *s <= 'z')
            *s = (char)(*s - 'a' + 'A');
    }
}

static int dip_rows(void *context)
{
    return play_cart(context)->manifest.n_dips;
}

static void dip_row(void *context, int at, struct screen_row *row)
{
    const struct dip *dip = &play_cart(context)->manifest.dips[at];
    const int32_t value = play_dip_value(context, at);

    write_title(row->label, sizeof row->label, dip->name);
    if (dip->is_number)
        snprintf(row->value, sizeof row->value, "%d", value);
    else
        write_title(row->value, sizeof row->value, dip->value_name[value]);
    snprintf(row->help, sizeof row->help, "The game restarts with the new value.");
    row->changes = true;
}

/* Named values wrap around; numbers stop at the limits. */
static void change_dip(void *context, int at, int by)
{
    struct play *play = context;
    const struct manifest *m = &play_cart(play)->manifest;
    const struct dip *dip = &m->dips[at];
    const int32_t value = play_dip_value(play, at), n = dip->n_values;
    char text[MAX_SETTING_NAME];

    if (dip->is_number)
        snprintf(text, sizeof text, "%d", (int)int64_clamp((int64_t)value + by, dip->lo, dip->hi));
    else
        snprintf(text, sizeof text, "%s", dip->value_name[(value + (by < 0 ? -1 : 1) + n) % n]);
    config_put_dip(&play->config, m->id, dip->name, text);
    config_put_dip(&play->saved_config, m->id, dip->name, text);
}

static const struct screen_def game_page = {
    .title = "Game", .rows = dip_rows, .row = dip_row, .change = change_dip, .closed = save_on_close
};

/* ---- the language ---- */

/* Opens language i, from 1 on. Returns its own name: the line `name = ...` of its file, or else the file's name. */
static const char *open_lang(const struct cart *cart, int i, struct words *words)
{
    const char *id = cart_name(cart, CART_LANGS, i - 1);

    cart_open_lang(cart, id, words);
    const char *name = words_find(words, "name", 4);
    return name ? name : id;
}

/* A file that has only a name is about the language of the scripts. Returns its number, or 0 if there is none. */
static int scripts_lang(const struct cart *cart)
{
    struct words words;

    for (int i = 1; i <= cart->count[CART_LANGS]; i++)
        if (open_lang(cart, i, &words) && words.n == 1 && words_find(&words, "name", 4))
            return i;
    return 0;
}

/* Returns the number of the language with this id, from 1 on; otherwise that of the scripts' language. */
static int lang_number(const struct cart *cart, const char *id)
{
    for (int i = 1; i <= cart->count[CART_LANGS]; i++)
        if (strcmp(cart_name(cart, CART_LANGS, i - 1), id) == 0)
            return i;
    return scripts_lang(cart);
}

static void describe_lang(const struct play *play, struct screen_row *row)
{
    const struct cart *cart = play_cart(play);
    const int i = lang_number(cart, play->config.lang);
    struct words words;

    snprintf(row->label, sizeof row->label, "Language");
    snprintf(row->value, sizeof row->value, "%s", i ? open_lang(cart, i, &words) : "Default");
    snprintf(row->help, sizeof row->help, "Menus change at once, the game when it restarts.");
    row->changes = true;
}

/* Only the language's row changes. */
static void change_lang(void *context, int at, int by)
{
    struct play *play = context;
    const struct cart *cart = play_cart(play);
    struct config *c = &play->config;
    const int scripts = scripts_lang(cart), first = scripts ? 1 : 0, n = cart->count[CART_LANGS] + 1 - first,
              to = first + (lang_number(cart, c->lang) - first + (by < 0 ? -1 : 1) + n) % n;

    (void)at;
    snprintf(c->lang, sizeof c->lang, "%s", to != scripts ? cart_name(cart, CART_LANGS, to - 1) : "");
    memcpy(play->saved_config.lang, c->lang, sizeof c->lang);
}

void play_translate_screens(struct play *play)
{
    const char *given = play->options.start.lang;

    cart_open_lang(play_cart(play), given[0] ? given : play->config.lang, &play->screens.words);
}

/* ---- the list of pages ---- */

static const struct {
    const char *label, *help;
    const struct screen_def *page; /* of settings; otherwise: */
    void (*open)(struct play *play);
} entries[] = {
    /* see kind_of */
    { "Display", "How the picture and its window look.", &display_page, NULL },
    { "Sound", "How loud music and sound effects are.", &sound_page, NULL },
    { "Accessibility", "Make the game easier to see and to play.", &accessibility_page, NULL },
    { "Gameplay", "Pausing, replays and unfinished runs.", &gameplay_page, NULL },
    { "Game", "The game's own switches.", &game_page, NULL },
    { "Key Bindings", "Change what each key and button does.", NULL, play_open_keys },
    { "Controllers", "Choose which player uses each controller, and test its buttons.", NULL, play_open_controllers },
};

enum { GAME = 4 /* the entry of games with DIP switches */ };
enum { LANGUAGE = sizeof entries / sizeof *entries }; /* the last row, in games with more than one language */

/* Returns the entry in row `at`, or LANGUAGE. */
static int kind_of(const struct play *play, int at)
{
    return at + (at >= GAME && play_cart(play)->manifest.n_dips == 0);
}

static int rows(void *context)
{
    const struct cart *cart = play_cart(context);

    return LANGUAGE - (cart->manifest.n_dips == 0) + (cart->count[CART_LANGS] > 0);
}

static void describe(void *context, int at, struct screen_row *row)
{
    at = kind_of(context, at);
    if (at == LANGUAGE) {
        describe_lang(context, row);
        return;
    }
    snprintf(row->label, sizeof row->label, "%s", entries[at].label);
    snprintf(row->help, sizeof row->help, "%s", entries[at].help);
}

static void accept(void *context, int at)
{
    struct play *play = context;

    at = kind_of(play, at);
    if (!entries[at].page) {
        entries[at].open(play);
        return;
    }
    play->settings_page = entries[at].page->title;
    screens_open(&play->screens, entries[at].page, play);
}

static void closed(void *context)
{
    struct play *play = context;

    bool same = strcmp(play->config.lang, play->lang_before) == 0 && play->config.large_hud == play->large_hud_before;
    for (int i = 0; i < play_cart(play)->manifest.n_dips; i++)
        same = same && play_dip_value(play, i) == play->dips_before[i];
    if (same)
        return;
    play_save_settings(play);
    if (play->quit || play->session.demo)
        return;
    if (play_has_run(play))
        screens_ask(&play->screens, "Restart to apply this? This run ends.", "Restart", play_restart, play);
    else
        play_restart(play);
}

static const struct screen_def settings = {
    .title = "Settings", .rows = rows, .row = describe, .change = change_lang, .accept = accept, .closed = closed
};

/* ---- opening, saving, applying ---- */

void play_open_settings(struct play *play)
{
    play->config.volume = play->speaker.volume; /* keys may have changed these temporarily */
    play->config.mute = play->speaker.muted;
    play->config.speed = play->time.speed;
    memcpy(play->lang_before, play->config.lang, sizeof play->lang_before);
    play->large_hud_before = play->config.large_hud;
    for (int i = 0; i < play_cart(play)->manifest.n_dips; i++)
        play->dips_before[i] = play_dip_value(play, i);
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

    play_pads_apply(play);
    play->speaker.volume = c->volume;
    play->speaker.muted = c->mute;
    speaker_set_levels(&play->speaker, c->music, c->sounds);
    play_set_speed(play, c->speed);
    play_update_window(play);
}
