/*
 * screen_keys.c - every key and button and what it does; another one by pressing it. What a new switch did before it
 * does no more, but for the same button of the other player's controller.
 */
#include <stdio.h>
#include <string.h>
#include "../input/switch.h"
#include "cab_parts.h"

enum { GROUPS = MAX_PLAYERS + 1 };

/* Has the program this key of the cabinet? */
static bool has_key(struct cab *cab, int key)
{
    return !(cab->options.sealed && KEYS_INSIDE >> key & 1);
}

/* How many of the cabinet's keys there are; number n of them. */
static int cabinet_keys(struct cab *cab)
{
    int n = 0;

    for (int key = 0; key < CAB_KEYS; key++)
        n += has_key(cab, key);
    return n;
}

static int cabinet_key(struct cab *cab, int n)
{
    int key = 0;

    while (n > 0 || !has_key(cab, key))
        n -= has_key(cab, key++);
    return key;
}

/* The last row, which makes all as it was. */
static int standard_row(struct cab *cab)
{
    return MAX_PLAYERS * (PAD_BUTTON_COUNT + 1) + 1 + cabinet_keys(cab);
}

/* The action of a row; -1: a heading, or the last row. Each group has a heading: the players, then the cabinet. */
static int action_at(struct cab *cab, int at)
{
    const int group = at / (PAD_BUTTON_COUNT + 1), row = at % (PAD_BUTTON_COUNT + 1);
    const int cabinet = at - MAX_PLAYERS * (PAD_BUTTON_COUNT + 1);

    if (group < MAX_PLAYERS)
        return row == 0 ? -1 : group * PAD_BUTTON_COUNT + row - 1;
    return cabinet == 0 || at >= standard_row(cab) ? -1
                                                   : MAX_PLAYERS * PAD_BUTTON_COUNT + cabinet_key(cab, cabinet - 1);
}

static int rows(void *of)
{
    struct cab *cab = of;

    return standard_row(cab) + 1;
}

/* All switches of an action as they are printed: "z, cross". */
static void labels_of(struct cab *cab, int action, char *out, size_t size)
{
    const struct keys *k = &cab->config.keys;
    const struct keys_device *d =
        action < MAX_PLAYERS * PAD_BUTTON_COUNT ? &k->player[action / PAD_BUTTON_COUNT] : &k->cabinet;
    char label[SWITCH_NAME];
    size_t n = 0;

    snprintf(out, size, "-");
    for (int i = 0; i < KEYS_EACH && n < size; i++) {
        if (!k->code[action][i])
            continue;
        switch_label(k->code[action][i], d->kind, label, sizeof label);
        n += (size_t)snprintf(out + n, size - n, "%s%s", n ? ", " : "", label);
    }
}

static void describe_heading(struct cab *cab, int at, struct screen_row *row)
{
    row->heading = at != standard_row(cab);
    if (!row->heading) {
        snprintf(row->label, sizeof row->label, "Reset All");
        snprintf(row->help, sizeof row->help, "Restore the default keys and buttons.");
    } else if (at < MAX_PLAYERS * (PAD_BUTTON_COUNT + 1)) {
        snprintf(row->label, sizeof row->label, "Player %d", at / (PAD_BUTTON_COUNT + 1) + 1);
    } else {
        snprintf(row->label, sizeof row->label, "General");
    }
}

/* What it is for, and what to press here, on what was used last. */
static void describe_how(struct cab *cab, const char *meaning, struct screen_row *row)
{
    const struct keys_device *d = &cab->config.keys.cabinet;
    char more[SWITCH_NAME] = "Enter", less[SWITCH_NAME] = "Delete";

    if (d->controller) {
        switch_label(SWITCH_CONTROLLER | PLAT_SOUTH, d->kind, more, sizeof more);
        switch_label(SWITCH_CONTROLLER | PLAT_NORTH, d->kind, less, sizeof less);
    }
    char sentence[SCREEN_HELP / 2] = "";
    if (meaning[0])
        screen_sentence(sentence, sizeof sentence, meaning);
    snprintf(row->help, sizeof row->help, "%s\n%s: add a key. %s: remove one.", sentence, more, less);
}

static void describe(void *of, int at, struct screen_row *row)
{
    struct cab *cab = of;
    const int action = action_at(cab, at);

    if (action < 0) {
        describe_heading(cab, at, row);
        return;
    }
    const int same = action < MAX_PLAYERS * PAD_BUTTON_COUNT ? action % PAD_BUTTON_COUNT
                                                             : action; /* both players' buttons mean the same */
    snprintf(row->label, sizeof row->label, "%s", keys_label(action));
    labels_of(cab, action, row->value, sizeof row->value);
    if (cab->wait.listening && cab->wait.action == action)
        snprintf(row->value, sizeof row->value, "Press a key...");
    describe_how(cab, keys_meaning(same), row);
}

/* ---- changes ---- */

static void take(struct cab *cab, uint16_t code)
{
    struct keys *k = &cab->config.keys;
    const char *name = keys_action(cab->wait.action), *other = keys_conflict(k, name, code);
    char err[160], label[SWITCH_NAME], title[KEYS_TITLE], before[KEYS_TITLE];

    switch_label(code, k->cabinet.kind, label, sizeof label);
    keys_title(name, title, sizeof title);
    if (!keys_add(k, name, code, err, sizeof err)) {
        screens_say(&cab->screens, "%s", err);
        return;
    }
    if (!other) {
        screens_say(&cab->screens, "%s: %s", title, label);
        return;
    }
    keys_title(other, before, sizeof before);
    screens_say(&cab->screens, "%s: %s (was %s)", title, label, before);
    for (; other; other = keys_conflict(k, name, code))
        keys_drop(k, other, code);
}

static bool listen(void *of, const struct plat_input *in)
{
    struct cab *cab = of;

    if (!cab->wait.listening)
        return false;
    if (!cab->wait.began)
        keys_capture_begin(&cab->wait.capture, in);
    const uint16_t code = cab->wait.began ? keys_capture(&cab->wait.capture, in) : 0;
    cab->wait.began = true;
    if (code) {
        cab->wait.listening = false;
        if (!keys_reserved(code))
            take(cab, code);
    }
    return true;
}

static void all_as_they_were(void *of)
{
    struct cab *cab = of;
    struct keys standard;

    keys_defaults(&standard);
    memcpy(cab->config.keys.code, standard.code, sizeof standard.code);
    cab_apply_settings(cab);
}

static void accept(void *of, int at)
{
    struct cab *cab = of;
    char title[KEYS_TITLE];

    if (at == standard_row(cab)) {
        screens_ask(&cab->screens, "Reset all key bindings?", "Reset", all_as_they_were, cab);
        return;
    }
    cab->wait.listening = true;
    cab->wait.began = false;
    cab->wait.action = action_at(cab, at);
    keys_title(keys_action(cab->wait.action), title, sizeof title);
    screens_say(&cab->screens, "%s: press a key or button. Escape: cancel.", title);
}

/* The last switch that may be taken away. */
static void drop_one(void *of, int at)
{
    struct cab *cab = of;
    const int action = action_at(cab, at);

    for (int i = KEYS_EACH - 1; action >= 0 && i >= 0; i--) {
        const uint16_t code = cab->config.keys.code[action][i];
        if (code && !keys_reserved(code)) {
            char label[SWITCH_NAME], title[KEYS_TITLE];
            switch_label(code, cab->config.keys.cabinet.kind, label, sizeof label);
            keys_title(keys_action(action), title, sizeof title);
            screens_say(&cab->screens, "%s: removed %s", title, label);
            keys_drop(&cab->config.keys, keys_action(action), code);
            return;
        }
    }
}

static void closed(void *of)
{
    struct cab *cab = of;

    cab->wait.listening = false;
    memcpy(cab->kept.keys.code, cab->config.keys.code, sizeof cab->kept.keys.code);
    cab_save_settings(cab);
}

const struct screen_def keys_screen = { .title = "Key Bindings",
                                        .rows = rows,
                                        .row = describe,
                                        .accept = accept,
                                        .remove = drop_one,
                                        .listen = listen,
                                        .closed = closed };

void cab_open_keys(struct cab *cab)
{
    if (cab->attracting)
        cab_attract_end(cab);
    cab->wait.listening = false;
    screens_open(&cab->screens, &keys_screen, cab);
}
