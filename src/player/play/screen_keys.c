/*
 * screen_keys.c - every key and button and its action; new ones are added by pressing them. A key added to an action is
 * removed from its other actions, after a question, except the same button of the other player's controller.
 */
#include <stdio.h>
#include <string.h>
#include "../input/input_code.h"
#include "../overlay/button_hints.h"
#include "play_state.h"

/* A row is an action, RESET, or the heading of a group: HEADING - group. */
enum {
    RESET = -1,
    HEADING = -2,
    MAX_ROWS = KEYS_ACTIONS + MAX_PLAYERS + 2,
    PLAYER_ACTIONS = MAX_PLAYERS * PAD_BUTTON_COUNT,
    TITLE = 64, /* bytes */
    INPUT = 64
};

/* The groups are the players, then the program's keys. Returns the number of rows. */
static int list_rows(const struct play *play, int list[MAX_ROWS])
{
    int n = 0;

    for (int action = 0; action < PLAYER_ACTIONS; action++) {
        if (action % PAD_BUTTON_COUNT == 0)
            list[n++] = HEADING - action / PAD_BUTTON_COUNT;
        list[n++] = action;
    }
    list[n++] = HEADING - MAX_PLAYERS;
    for (int key = 0; key < HOTKEYS; key++)
        if (play->options.open || !(KEYS_FOR_AUTHORS >> key & 1))
            list[n++] = PLAYER_ACTIONS + key;
    list[n++] = RESET;
    return n;
}

static int row_at(const struct play *play, int at)
{
    int list[MAX_ROWS];

    list_rows(play, list);
    return list[at];
}

static int rows(void *context)
{
    int list[MAX_ROWS];

    return list_rows(context, list);
}

/* Returns whether an action's row shows an input: keys, or buttons if a controller was used last. */
static bool is_listed(const struct play *play, uint16_t code)
{
    const bool is_button = code & INPUT_CODE_CONTROLLER;

    return code && is_button == play->config.keys.latest.is_controller;
}

/* Writes what is printed on a key or button; where nothing is, the button's translated place: "Bottom button". */
static void print_input(const struct play *play, int action, uint16_t code, char *out, size_t size)
{
    const struct keys *k = &play->config.keys;
    const struct keys_device *d = action < PLAYER_ACTIONS ? &k->device[action / PAD_BUTTON_COUNT] : &k->latest;
    const bool is_button = code & INPUT_CODE_CONTROLLER;
    char label[INPUT_CODE_NAME_SIZE], printed[INPUT_CODE_NAME_SIZE];

    input_code_label(code, d->kind, label, sizeof label);
    button_hints_print(label, is_button ? (int)d->kind : -1, printed);
    if (is_button && strchr(printed, ' '))
        screen_translate(&play->screens.words, printed, out, size);
    else
        snprintf(out, size, "%s", printed);
}

/* The listed inputs of an action: "Z", "\u2715,L1", or "None". */
static void labels_of(const struct play *play, int action, char *out, size_t size)
{
    const uint16_t *code = play->config.keys.code[action];
    char printed[INPUT];
    size_t n = 0;

    screen_translate(&play->screens.words, "None", out, size);
    for (int i = 0; i < KEYS_PER_ACTION && n < size; i++) {
        if (!is_listed(play, code[i]))
            continue;
        print_input(play, action, code[i], printed, sizeof printed);
        n += (size_t)snprintf(out + n, size - n, "%s%s", n ? "," : "", printed);
    }
}

/* Returns the last listed input of an action that can be removed; 0: none. */
static uint16_t last_removable(const struct play *play, int action)
{
    const uint16_t *code = play->config.keys.code[action];

    for (int i = KEYS_PER_ACTION - 1; i >= 0; i--)
        if (is_listed(play, code[i]) && !keys_reserved(code[i]))
            return code[i];
    return 0;
}

/* The translated title of the action with this name: "Player 2 Fire". */
static void title_of(const struct play *play, const char *name, char *out, size_t size)
{
    char label[TITLE];
    int action = 0;

    while (strcmp(keys_action_name(action), name) != 0)
        action++;
    screen_translate(&play->screens.words, keys_action_label(action), label, sizeof label);
    if (action < PLAYER_ACTIONS)
        screens_format(&play->screens, out, size, "Player %d %s", action / PAD_BUTTON_COUNT + 1, label);
    else
        snprintf(out, size, "%s", label);
}

static void describe(void *context, int at, struct screen_row *row)
{
    struct play *play = context;
    const struct key_capture *capture = &play->key_capture;
    const int action = row_at(play, at);

    if (action == RESET) {
        snprintf(row->label, sizeof row->label, "Reset All");
        snprintf(row->help, sizeof row->help, "Restore the default keys and buttons.");
        return;
    }
    if (action < 0) {
        row->heading = true;
        if (HEADING - action < MAX_PLAYERS)
            snprintf(row->label, sizeof row->label, "Player %d", HEADING - action + 1);
        else
            snprintf(row->label, sizeof row->label, "General");
        return;
    }
    snprintf(row->label, sizeof row->label, "%s", keys_action_label(action));
    row->removable = last_removable(play, action) != 0;
    row->action = "Add Key";
    row->verbatim = true;
    labels_of(play, action, row->value, sizeof row->value);
    if (capture->listening && capture->action == action)
        screen_translate(&play->screens.words, "Press a key...", row->value, sizeof row->value);
    /* both players' buttons mean the same */
    screen_sentence(row->help, sizeof row->help,
                    keys_action_help(action < PLAYER_ACTIONS ? action % PAD_BUTTON_COUNT : action));
}

/* ---- changes ---- */

/* Adds the input to the action, and removes it from all others. */
static void bind_input(void *context)
{
    struct play *play = context;
    struct keys *k = &play->config.keys;
    const uint16_t code = play->key_capture.asked;
    const char *name = keys_action_name(play->key_capture.action);
    char label[INPUT], title[TITLE];

    print_input(play, play->key_capture.action, code, label, sizeof label);
    title_of(play, name, title, sizeof title);
    if (!keys_add(k, name, code)) {
        screens_show_message(&play->screens, "%s already has %d keys, the maximum", title, KEYS_PER_ACTION);
        return;
    }
    for (const char *other; (other = keys_conflict(k, name, code));)
        keys_remove(k, other, code);
    screens_show_message(&play->screens, "%s: %s", title, label);
}

/* Asks first if the input has another action. */
static void choose_input(struct play *play, uint16_t code)
{
    const char *other = keys_conflict(&play->config.keys, keys_action_name(play->key_capture.action), code);
    char label[INPUT], before[TITLE], question[SCREEN_HELP];

    play->key_capture.asked = code;
    if (!other) {
        bind_input(play);
        return;
    }
    print_input(play, play->key_capture.action, code, label, sizeof label);
    title_of(play, other, before, sizeof before);
    screens_format(&play->screens, question, sizeof question, "%s is already used: %s", label, before);
    screens_ask(&play->screens, question, "Change", bind_input, play);
}

static bool listen(void *context, const struct plat_input *in)
{
    struct play *play = context;
    struct key_capture *c = &play->key_capture;

    if (!c->listening)
        return false;
    if (!c->started)
        keys_capture_begin(&c->capture, in);
    const uint16_t code = c->started ? keys_capture_poll(&c->capture, in) : 0;
    c->started = true;
    if (code) {
        c->listening = false;
        play->screens.message_frames = 0;
        if (!keys_reserved(code))
            choose_input(play, code);
    }
    return true;
}

static void reset_all(void *context)
{
    struct play *play = context;
    struct keys defaults;

    keys_set_defaults(&defaults);
    memcpy(play->config.keys.code, defaults.code, sizeof defaults.code);
    play_apply_settings(play);
}

static void accept(void *context, int at)
{
    struct play *play = context;
    const int action = row_at(play, at);
    char title[TITLE];

    if (action == RESET) {
        screens_ask(&play->screens, "Reset all key bindings?", "Reset", reset_all, play);
        return;
    }
    play->key_capture = (struct key_capture){ .listening = true, .action = action };
    title_of(play, keys_action_name(action), title, sizeof title);
    screens_show_message(&play->screens, "%s: press a key or button. Escape: cancel.", title);
}

static void remove_one(void *context, int at)
{
    struct play *play = context;
    const int action = row_at(play, at);
    const uint16_t code = last_removable(play, action);
    char label[INPUT], title[TITLE];

    print_input(play, action, code, label, sizeof label);
    title_of(play, keys_action_name(action), title, sizeof title);
    screens_show_message(&play->screens, "%s: removed %s", title, label);
    keys_remove(&play->config.keys, keys_action_name(action), code);
}

static void closed(void *context)
{
    struct play *play = context;

    play->key_capture.listening = false;
    memcpy(play->saved_config.keys.code, play->config.keys.code, sizeof play->saved_config.keys.code);
    play_save_settings(play);
}

const struct screen_def keys_screen = { .title = "Key Bindings",
                                        .rows = rows,
                                        .row = describe,
                                        .accept = accept,
                                        .remove = remove_one,
                                        .removal = "Remove Key",
                                        .listen = listen,
                                        .closed = closed };

void play_open_keys(struct play *play)
{
    attract_end(&play->attract);
    play->key_capture.listening = false;
    screens_open(&play->screens, &keys_screen, play);
}
