/*
 * screen_settings.c - the settings: a page for each group in the table of config.c, key bindings, controllers, and the
 * language. A change takes effect at once; the file is written when the page is closed.
 */
#include <stdio.h>
#include <string.h>
#include "play_state.h"
#include "../../../platform/platform.h"

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
    { "Display", "How the picture and its window look.", &display_page, NULL },
    { "Sound", "How loud music and sound effects are.", &sound_page, NULL },
    { "Accessibility", "Make the game easier to see and to play.", &accessibility_page, NULL },
    { "Gameplay", "Pausing, replays and unfinished runs.", &gameplay_page, NULL },
    { "Key Bindings", "Change what each key and button does.", NULL, play_open_keys },
    { "Controllers", "Choose which player uses each controller, and test its buttons.", NULL, play_open_controllers },
};

enum { LANGUAGE = sizeof entries / sizeof *entries }; /* the last row, in games with more than one language */

static int rows(void *context)
{
    return LANGUAGE + (play_cart(context)->count[CART_LANGS] > 0);
}

static void describe(void *context, int at, struct screen_row *row)
{
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

    if (strcmp(play->config.lang, play->lang_before) == 0 && play->config.large_hud == play->large_hud_before)
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
