/*
 * keys.c - see keys.h.
 *
 * One table of actions is the default map, the names of the settings file and the help text. Its switches are strings
 * that go through the same parser as the user's own; so does what a hand has.
 */
#include "keys.h"

#include <stdio.h>
#include <string.h>
#include "../../base/err.h"

enum { WORD = 32 };

static const struct action {
    const char *name, *label, *switches, *help;
} actions[KEYS_ACTIONS] = {
    { "p1.up", "Up", "up pad.up pad.lup", "move" },
    { "p1.down", "Down", "down pad.down pad.ldown", "move" },
    { "p1.left", "Left", "left pad.left pad.lleft", "move" },
    { "p1.right", "Right", "right pad.right pad.lright", "move" },
    { "p1.fire", "Fire", "z pad.south", "fire; confirm in menus" },
    { "p1.bomb", "Bomb", "x pad.east", "bomb; cancel in menus" },
    { "p1.focus", "Focus", "lshift pad.r1 pad.r2", "move slowly" },
    { "p1.special", "Special", "c pad.west pad.l1", "depends on the game" },
    { "p1.start", "Start", "enter 1 pad.start", "start; pause while playing" },
    { "p1.select", "Select", "tab pad.select", "depends on the game" },
    { "p2.up", "Up", "w kp8 pad.up pad.lup", "player 2" },
    { "p2.down", "Down", "s kp5 kp2 pad.down pad.ldown", "" },
    { "p2.left", "Left", "a kp4 pad.left pad.lleft", "" },
    { "p2.right", "Right", "d kp6 pad.right pad.lright", "" },
    { "p2.fire", "Fire", "j kp0 pad.south", "" },
    { "p2.bomb", "Bomb", "k kp. pad.east", "" },
    { "p2.focus", "Focus", "i kpenter pad.r1 pad.r2", "" },
    { "p2.special", "Special", "l kp+ pad.west pad.l1", "" },
    { "p2.start", "Start", "2 kp* pad.start", "" },
    { "p2.select", "Select", "3 kp- pad.select", "" },
    { "pause", "Pause", "p pause", "pause or resume" },
    { "step", "Frame Advance", "period", "go one frame forward and pause" },
    { "slow", "Slow Motion", "comma", "switch between half, quarter and full speed" },
    { "turbo", "Fast-Forward", "slash", "run as fast as possible while held" },
    { "rewind", "Rewind", "backspace", "go back in time while held" },
    { "back", "Frame Back", "b", "go one frame back and pause" },
    { "before", "Previous Event", "lbracket", "jump to the previous stage, boss, phase or death" },
    { "after", "Next Event", "rbracket", "jump to the next stage, boss, phase or death" },
    { "goto", "Go to Frame", "home", "enter a frame number and jump there" },
    { "takeover", "Take Over", "t", "in a demo: play from the current frame on" },
    { "reload", "Reload", "f5", "reload the game's folder now" },
    { "practice", "Practice", "f2", "choose a section to practise" },
    { "retry", "Retry", "r", "restart the section immediately" },
    { "silence", "Mute", "m", "turn sound off or on" },
    { "quieter", "Volume Down", "minus", "lower the volume by ten percent" },
    { "louder", "Volume Up", "equals", "raise the volume by ten percent" },
    { "screenshot", "Screenshot", "f12", "save a PNG in your pictures folder" },
    { "capture", "Save Clip", "f6", "save the last few seconds as a GIF in the same folder" },
    { "full", "Fullscreen", "f11 alt+enter", "switch between fullscreen and window" },
    { "quit", "Quit", "ctrl+q", "quit without asking" },
    { "menu", "Menu", "escape pad.guide", "open the menu" },
    { "help", "Key Bindings", "f1", "list all keys and what they do" },
    { "log", "Log", "f8", "show script output and errors" },
    { "shapes", "Show Hitboxes", "h", "show hitboxes and graze rings over the picture" },
    { "gauges", "Pool Usage", "g", "show how full each pool is and how much Lua memory is used" },
    { "split", "Frame Times", "v", "show how each frame's time is spent" },
    { "tasks", "Tasks", "n", "show tasks, their current lines, and how many random numbers were drawn" },
    { "mixer", "Mixer", "f3", "show voices, levels and the position in the music" },
    { "console", "Console", "backquote", "run a line of Lua while the game is paused" },
};

/* What one hand reaches, by the order of buttons: of a keyboard one side, of a controller one stick and what lies round
 * it. A controller has fewer switches there than a player has buttons, but fire is held by itself (press.h), so special
 * shares its switch. */
static const char *const hands[][PAD_BUTTON_COUNT] = {
    [HAND_LEFT] = { "w pad.up pad.lup", "s pad.down pad.ldown", "a pad.left pad.lleft", "d pad.right pad.lright",
                    "space pad.l1", "q pad.l3", "lshift pad.l2", "e pad.l1", "1 pad.select", "tab" },
    [HAND_RIGHT] = { "up pad.rup", "down pad.rdown", "left pad.rleft", "right pad.rright", "pagedown kp0 pad.r1",
                     "delete kp1 pad.r3", "rshift rctrl pad.r2", "end kp. pad.r1", "enter pad.start", "insert" },
};

/* ---- the map ---- */

static int find(const char *action)
{
    for (int i = 0; i < KEYS_ACTIONS; i++)
        if (strcmp(action, actions[i].name) == 0)
            return i;
    return -1;
}

bool keys_known(const char *action)
{
    return find(action) >= 0;
}

/* The next word of a list, cut to fit; false at the end. */
static bool next_word(const char **s, char word[WORD])
{
    *s += strspn(*s, " \t");
    size_t n = strcspn(*s, " \t");
    snprintf(word, WORD, "%.*s", (int)(n < WORD ? n : WORD), *s);
    *s += n;
    return n > 0;
}

/* The codes of a list; false and a sentence. */
static bool read_list(const char *action, const char *list, uint16_t *code, int most, char *err, size_t err_size)
{
    char word[WORD];
    int n = 0;

    for (const char *s = strcmp(list, "none") == 0 ? "" : list; next_word(&s, word);) {
        uint16_t c = switch_code(word);
        if (!c || n == most)
            return err_set(err, err_size,
                           c ? "%s: expected at most six keys and buttons; remove \"%s\""
                             : "%s: unknown key or button \"%s\"",
                           action, word);
        code[n++] = c;
    }
    return true;
}

bool keys_bind(struct keys *k, const char *action, const char *list, char *err, size_t err_size)
{
    uint16_t code[KEYS_EACH] = { 0 };
    int at = find(action);

    if (at < 0)
        return err_set(err, err_size, "unknown action \"%s\"", action);
    if (!read_list(action, list, code, KEYS_EACH, err, err_size))
        return false;
    memcpy(k->code[at], code, sizeof code);
    return true;
}

void keys_hand(struct keys *k, int player, enum keys_hand hand)
{
    char err[128];

    memset(k->hand[player], 0, sizeof k->hand[player]);
    for (int i = 0; i < PAD_BUTTON_COUNT && hand != HAND_BOTH; i++)
        read_list(actions[i].name, hands[hand][i], k->hand[player][i], KEYS_HAND, err, sizeof err);
}

void keys_defaults(struct keys *k)
{
    char err[128];
    memset(k, 0, sizeof *k);
    for (int i = 0; i < KEYS_ACTIONS; i++)
        keys_bind(k, actions[i].name, actions[i].switches, err, sizeof err);
}

/* ---- names ---- */

/* The player of an action, from 0; -1: it is the program's. */
static int player_of(int action)
{
    return action < MAX_PLAYERS * PAD_BUTTON_COUNT ? action / PAD_BUTTON_COUNT : -1;
}

/* Switch i of an action, those that a hand has first; 0: none. */
static unsigned nth_code(const struct keys *k, int action, int i)
{
    int player = player_of(action);

    if (i >= KEYS_HAND)
        return k->code[action][i - KEYS_HAND];
    return player < 0 ? 0 : k->hand[player][action % PAD_BUTTON_COUNT][i];
}

/* The first that is a controller's, or a key; 0: none. */
static unsigned first_code(const struct keys *k, int action, bool controller)
{
    for (int i = 0; i < KEYS_HAND + KEYS_EACH; i++) {
        unsigned code = nth_code(k, action, i);
        if (code && !(code & SWITCH_CONTROLLER) == !controller)
            return code;
    }
    return 0;
}

void keys_first(const struct keys *k, const char *action, char *out, size_t size)
{
    int at = find(action), player = player_of(at);
    const struct keys_device *last = player < 0 ? &k->latest : &k->player[player];
    unsigned code = first_code(k, at, last->controller);

    if (!code)
        code = first_code(k, at, !last->controller);
    if (code & SWITCH_CONTROLLER && !last->controller)
        switch_name(code, out, size);
    else
        switch_label(code, last->kind, out, size);
}

const char *keys_action(int i)
{
    return actions[i].name;
}

const char *keys_label(int i)
{
    return actions[i].label;
}

void keys_title(const char *action, char *out, size_t size)
{
    const int i = find(action), player = player_of(i);

    if (player < 0)
        snprintf(out, size, "%s", actions[i].label);
    else
        snprintf(out, size, "Player %d %s", player + 1, actions[i].label);
}

const char *keys_meaning(int i)
{
    return actions[i].help;
}

void keys_text(const struct keys *k, const char *action, char *out, size_t size)
{
    const uint16_t *code = k->code[find(action)];
    char word[SWITCH_NAME];
    size_t n = 0;

    snprintf(out, size, "none");
    for (int i = 0; i < KEYS_EACH && code[i] && n < size; i++) {
        switch_name(code[i], word, sizeof word);
        n += (size_t)snprintf(out + n, size - n, "%s%s", i ? " " : "", word);
    }
}

/* ---- changing it by pressing ---- */

static bool is_modifier(unsigned usage)
{
    return usage == KEY_LEFT_CTRL || usage == KEY_RIGHT_CTRL || usage == KEY_LEFT_ALT || usage == KEY_RIGHT_ALT;
}

void keys_capture_begin(struct keys_capture *c, const struct plat_input *in)
{
    memcpy(c->keys, in->keys, sizeof c->keys);
    memcpy(c->controllers, in->controllers, sizeof c->controllers);
    c->modifier = 0;
}

static unsigned captured_key(struct keys_capture *c, const struct plat_input *in)
{
    unsigned with = c->modifier == KEY_LEFT_ALT || c->modifier == KEY_RIGHT_ALT ? SWITCH_ALT : SWITCH_CTRL;

    for (unsigned u = 4; u < PLAT_KEYS; u++) {
        if (!plat_is_key_held(in, u) || c->keys[u >> 3] >> (u & 7) & 1)
            continue;
        if (!is_modifier(u))
            return c->modifier ? u | with : u;
        c->modifier = u;
    }
    return c->modifier && !plat_is_key_held(in, c->modifier) ? c->modifier : 0;
}

uint16_t keys_capture(struct keys_capture *c, const struct plat_input *in)
{
    unsigned code = captured_key(c, in);

    for (int i = 0; i < PLAT_MAX_CONTROLLERS && !code; i++)
        for (unsigned bit = 0; bit < PLAT_BUTTONS && !code; bit++)
            if ((in->controllers[i] & ~c->controllers[i]) >> bit & 1)
                code = SWITCH_CONTROLLER | bit;
    memcpy(c->keys, in->keys, sizeof c->keys);
    memcpy(c->controllers, in->controllers, sizeof c->controllers);
    return (uint16_t)code;
}

bool keys_add(struct keys *k, const char *action, uint16_t code, char *err, size_t err_size)
{
    uint16_t *list = k->code[find(action)];
    int n = 0;

    while (n < KEYS_EACH && list[n] && list[n] != code)
        n++;
    if (n == KEYS_EACH) {
        char title[KEYS_TITLE];
        keys_title(action, title, sizeof title);
        return err_set(err, err_size, "%s already has %d keys, the maximum", title, KEYS_EACH);
    }
    list[n] = code;
    return true;
}

void keys_drop(struct keys *k, const char *action, uint16_t code)
{
    uint16_t *list = k->code[find(action)];
    int to = 0;

    for (int i = 0; i < KEYS_EACH; i++)
        if (list[i] != code)
            list[to++] = list[i];
    while (to < KEYS_EACH)
        list[to++] = 0;
}

/* Could one press be both? A plain pad.south is another controller's for each player, and all of them's for the
 * program. */
static bool same_switch(unsigned a, int player_a, unsigned b, int player_b)
{
    if (!(a & b & SWITCH_CONTROLLER))
        return a == b;
    if (switch_bit(a) != switch_bit(b))
        return false;
    if (switch_which(a) && switch_which(b))
        return switch_which(a) == switch_which(b);
    return switch_which(a) || switch_which(b) || player_a == player_b || player_a < 0 || player_b < 0;
}

const char *keys_conflict(const struct keys *k, const char *action, uint16_t code)
{
    int at = find(action);

    for (int i = 0; i < KEYS_ACTIONS; i++)
        for (int n = 0; i != at && n < KEYS_EACH; n++)
            if (k->code[i][n] && same_switch(code, player_of(at), k->code[i][n], player_of(i)))
                return actions[i].name;
    return NULL;
}

bool keys_reserved(uint16_t code)
{
    return code == KEY_ESCAPE || (code & SWITCH_CONTROLLER && switch_bit(code) == PLAT_GUIDE);
}

/* ---- reading ---- */

/* A modifier counts for a poll longer than it is held: both keys of a quick chord may be up when the second is read. */
static void note_modifiers(struct keys *k, const struct plat_input *in)
{
    const bool alt = plat_is_key_held(in, KEY_LEFT_ALT) || plat_is_key_held(in, KEY_RIGHT_ALT);
    const bool ctrl = plat_is_key_held(in, KEY_LEFT_CTRL) || plat_is_key_held(in, KEY_RIGHT_CTRL);

    k->alt = alt || k->had_alt;
    k->ctrl = ctrl || k->had_ctrl;
    k->had_alt = alt;
    k->had_ctrl = ctrl;
}

static bool modifier(const struct keys *k, unsigned code)
{
    return !(code & SWITCH_ALT && !k->alt) && !(code & SWITCH_CTRL && !k->ctrl);
}

static void eat(struct keys *k, const struct plat_input *in)
{
    for (int i = 0; i < KEYS_ACTIONS * KEYS_EACH; i++) {
        unsigned code = k->code[i / KEYS_EACH][i % KEYS_EACH], usage = code & 255;
        if (switch_is_chord(code) && modifier(k, code))
            k->eaten[usage >> 3] = (uint8_t)(k->eaten[usage >> 3] | 1u << (usage & 7));
    }
    for (int i = 0; i < PLAT_KEYS / 8; i++)
        k->eaten[i] &= in->keys[i];
}

/* player: -1: the program, which has all controllers. */
static uint32_t controller(const struct seats *seats, unsigned which, int player)
{
    uint32_t all = 0;

    if (which)
        return which <= PLAT_MAX_CONTROLLERS ? seats->switches[which - 1] : 0;
    if (player >= 0)
        return seats_switches(seats, player);
    for (int i = 0; i < PLAT_MAX_CONTROLLERS; i++)
        all |= seats->switches[i];
    return all;
}

static bool key_held(const struct keys *k, const struct plat_input *in, unsigned code)
{
    unsigned usage = code & 255;

    if (switch_is_chord(code))
        return plat_is_key_held(in, usage) && modifier(k, code);
    return plat_is_key_held(in, usage) && !(k->eaten[usage >> 3] >> (usage & 7) & 1);
}

/* Does a hand's layout say what this switch is? To its own player of any switch, to the other of a key. */
static bool hand_has(const struct keys *k, unsigned code, int player)
{
    const uint16_t *list = &k->hand[0][0][0];
    enum { EACH = PAD_BUTTON_COUNT * KEYS_HAND };

    for (int i = 0; i < MAX_PLAYERS * EACH; i++)
        if (list[i] == code && (i / EACH == player || !(code & SWITCH_CONTROLLER)))
            return true;
    return false;
}

struct by {
    bool key, controller;
};

static struct by action_held(const struct keys *k, const struct plat_input *in, const struct seats *seats, int action)
{
    struct by by = { false, false };
    int player = player_of(action);

    for (int i = 0; i < KEYS_HAND + KEYS_EACH; i++) {
        unsigned code = nth_code(k, action, i);
        if (!code || (i >= KEYS_HAND && player >= 0 && hand_has(k, code, player)))
            continue;
        if (code & SWITCH_CONTROLLER)
            by.controller = by.controller || controller(seats, switch_which(code), player) >> switch_bit(code) & 1;
        else
            by.key = by.key || key_held(k, in, code);
    }
    return by;
}

/* What a player, or anybody, pressed last. */
static void note_device(struct keys *k, const struct seats *seats, int player, struct by fresh)
{
    int i = seats->seat[player];

    if (!fresh.key && !fresh.controller)
        return;
    k->player[player].controller = !fresh.key;
    k->player[player].kind = i == SEAT_EMPTY ? PLAT_UNKNOWN_CONTROLLER : seats->is[i].kind;
    k->latest = k->player[player];
}

static uint16_t read_pad(struct keys *k, const struct plat_input *in, const struct seats *seats, int player)
{
    unsigned keys = 0, switches = 0;

    for (int i = 0; i < PAD_BUTTON_COUNT; i++) {
        struct by by = action_held(k, in, seats, player * PAD_BUTTON_COUNT + i);
        keys |= (unsigned)by.key << i;
        switches |= (unsigned)by.controller << i;
    }
    note_device(k, seats, player,
                (struct by){ keys & ~(unsigned)k->by_key[player], switches & ~(unsigned)k->by_switch[player] });
    k->by_key[player] = (uint16_t)keys;
    k->by_switch[player] = (uint16_t)switches;
    return (uint16_t)(keys | switches);
}

void keys_read(struct keys *k, const struct plat_input *in, const struct seats *seats, struct keys_read *out)
{
    memset(out, 0, sizeof *out);
    note_modifiers(k, in);
    eat(k, in);
    for (int p = 0; p < MAX_PLAYERS; p++) {
        unsigned was = k->by_key[p] | k->by_switch[p];
        out->pads[p] = read_pad(k, in, seats, p);
        out->pads_fresh[p] = (uint16_t)(out->pads[p] & ~was);
        out->fresh = out->fresh || out->pads_fresh[p];
    }
    for (int i = 0; i < HOTKEYS; i++) {
        struct by by = action_held(k, in, seats, MAX_PLAYERS * PAD_BUTTON_COUNT + i);
        out->held |= (uint32_t)(by.key || by.controller) << i;
    }
    out->pressed = out->held & ~k->held;
    k->held = out->held;
}

void keys_help(uint32_t without, void (*line)(const char *))
{
    char text[128];
    for (int i = 0; i < KEYS_ACTIONS; i++) {
        if (player_of(i) < 0 && without >> (i - MAX_PLAYERS * PAD_BUTTON_COUNT) & 1)
            continue;
        int n = snprintf(text, sizeof text, "  %-11s %-30s %s", actions[i].name, actions[i].switches, actions[i].help);
        while (n > 0 && text[n - 1] == ' ')
            text[--n] = 0;
        line(text);
    }
}
