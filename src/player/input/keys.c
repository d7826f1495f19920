/*
 * keys.c - key bindings (keys.h).
 *
 * One table of actions defines the default bindings, the names in the settings file and the help. Default bindings and
 * one-handed layouts are strings, parsed like the user's own bindings.
 */
#include "keys.h"

#include <stdio.h>
#include <string.h>
#include "../../base/err.h"

enum { WORD_SIZE = 32 };

static const struct action {
    const char *name, *label, *inputs, *help;
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
    { "p1.select", "Select Button", "tab pad.select", "depends on the game" },
    { "p2.up", "Up", "w kp8 pad.up pad.lup", "player 2" },
    { "p2.down", "Down", "s kp5 kp2 pad.down pad.ldown", "" },
    { "p2.left", "Left", "a kp4 pad.left pad.lleft", "" },
    { "p2.right", "Right", "d kp6 pad.right pad.lright", "" },
    { "p2.fire", "Fire", "j kp0 pad.south", "" },
    { "p2.bomb", "Bomb", "k kp. pad.east", "" },
    { "p2.focus", "Focus", "i kpenter pad.r1 pad.r2", "" },
    { "p2.special", "Special", "l kp+ pad.west pad.l1", "" },
    { "p2.start", "Start", "2 kp* pad.start", "" },
    { "p2.select", "Select Button", "3 kp- pad.select", "" },
    { "pause", "Pause", "p pause", "pause or resume" },
    { "step", "Frame Advance", "period", "go one frame forward and pause" },
    { "slow", "Slow Motion", "comma", "halve the game speed, or return to full speed" },
    { "turbo", "Fast-Forward", "slash", "run as fast as possible while held" },
    { "rewind", "Rewind", "backspace", "go back in time while held" },
    { "back", "Frame Back", "b", "go one frame back and pause" },
    { "before", "Previous Event", "lbracket", "jump to the previous stage, boss, phase or death" },
    { "after", "Next Event", "rbracket", "jump to the next stage, boss, phase or death" },
    { "goto", "Go to Frame", "home", "enter a frame number and jump there" },
    { "takeover", "Take Over", "t", "play on from this frame of a replay" },
    { "reload", "Reload", "f5", "reload the game's folder now" },
    { "practice", "Practice", "f2", "choose a section to practise" },
    { "retry", "Retry Practice", "r", "restart the section that you practise" },
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
    { "shapes", "Show Hitbox", "h", "show hitboxes and graze rings over the picture" },
    { "gauges", "Pool Usage", "g", "show how full each pool is and how much Lua memory is used" },
    { "split", "Frame Times", "v", "show how each frame's time is spent" },
    { "tasks", "Tasks", "n", "show tasks, their current lines and random numbers drawn" },
    { "mixer", "Mixer", "f3", "show voices, levels and the position in the music" },
    { "console", "Console", "backquote", "run a line of Lua while the game is paused" },
};

/* One-handed layouts, in the order of the pad's buttons: one side of the keyboard, and one stick of the controller with
 * the buttons around it. These are fewer than a player's buttons, but fire is held automatically (pad_modes.h), so
 * special shares its button. */
static const char *const hands[][PAD_BUTTON_COUNT] = {
    [HAND_LEFT] = { "w pad.up pad.lup", "s pad.down pad.ldown", "a pad.left pad.lleft", "d pad.right pad.lright",
                    "space pad.l1", "q pad.l3", "lshift pad.l2", "e pad.l1", "1 pad.select", "tab" },
    [HAND_RIGHT] = { "up pad.rup", "down pad.rdown", "left pad.rleft", "right pad.rright", "pagedown kp0 pad.r1",
                     "delete kp1 pad.r3", "rshift rctrl pad.r2", "end kp. pad.r1", "enter pad.start", "insert" },
};

/* ---- bindings ---- */

static int find_action(const char *action)
{
    for (int i = 0; i < KEYS_ACTIONS; i++)
        if (strcmp(action, actions[i].name) == 0)
            return i;
    return -1;
}

bool keys_is_action(const char *action)
{
    return find_action(action) >= 0;
}

/* Reads the next word of a list, truncated to fit. Returns false at the end. */
static bool next_word(const char **s, char word[WORD_SIZE])
{
    *s += strspn(*s, " \t");
    size_t n = strcspn(*s, " \t");
    snprintf(word, WORD_SIZE, "%.*s", (int)(n < WORD_SIZE ? n : WORD_SIZE), *s);
    *s += n;
    return n > 0;
}

/* Parses a list of inputs. On failure, returns false and sets err. */
static bool parse_list(const char *action, const char *list, uint16_t *code, int most, char *err, size_t err_size)
{
    char word[WORD_SIZE];
    int n = 0;

    for (const char *s = strcmp(list, "none") == 0 ? "" : list; next_word(&s, word);) {
        uint16_t c = input_code_parse(word);
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
    uint16_t code[KEYS_PER_ACTION] = { 0 };
    int at = find_action(action);

    if (at < 0)
        return err_set(err, err_size, "unknown action \"%s\"", action);
    if (!parse_list(action, list, code, KEYS_PER_ACTION, err, err_size))
        return false;
    memcpy(k->code[at], code, sizeof code);
    return true;
}

void keys_set_hand(struct keys *k, int player, enum keys_hand hand)
{
    char err[128];

    memset(k->hand[player], 0, sizeof k->hand[player]);
    for (int i = 0; i < PAD_BUTTON_COUNT && hand != HAND_BOTH; i++)
        parse_list(actions[i].name, hands[hand][i], k->hand[player][i], KEYS_PER_HAND, err, sizeof err);
}

void keys_set_defaults(struct keys *k)
{
    char err[128];
    memset(k, 0, sizeof *k);
    for (int i = 0; i < KEYS_ACTIONS; i++)
        keys_bind(k, actions[i].name, actions[i].inputs, err, sizeof err);
}

/* ---- names ---- */

/* Returns the player of an action, from 0, or -1 for a hotkey. */
static int player_of(int action)
{
    return action < MAX_PLAYERS * PAD_BUTTON_COUNT ? action / PAD_BUTTON_COUNT : -1;
}

/* Returns input i of an action, starting with those of a one-handed layout; 0: none. */
static unsigned nth_code(const struct keys *k, int action, int i)
{
    int player = player_of(action);

    if (i >= KEYS_PER_HAND)
        return k->code[action][i - KEYS_PER_HAND];
    return player < 0 ? 0 : k->hand[player][action % PAD_BUTTON_COUNT][i];
}

/* Returns an action's first input on a controller or on the keyboard; 0: none. */
static unsigned first_code(const struct keys *k, int action, bool controller)
{
    for (int i = 0; i < KEYS_PER_HAND + KEYS_PER_ACTION; i++) {
        unsigned code = nth_code(k, action, i);
        if (code && !(code & INPUT_CODE_CONTROLLER) == !controller)
            return code;
    }
    return 0;
}

void keys_hint(const struct keys *k, const char *action, char *out, size_t size)
{
    int at = find_action(action), player = player_of(at);
    const struct keys_device *last = player < 0 ? &k->latest : &k->device[player];
    unsigned code = first_code(k, at, last->is_controller);

    if (!code)
        code = first_code(k, at, !last->is_controller);
    if (code & INPUT_CODE_CONTROLLER && !last->is_controller)
        input_code_name(code, out, size);
    else
        input_code_label(code, last->kind, out, size);
}

const char *keys_action_name(int i)
{
    return actions[i].name;
}

const char *keys_action_label(int i)
{
    return actions[i].label;
}

const char *keys_action_help(int i)
{
    return actions[i].help;
}

void keys_write_list(const struct keys *k, const char *action, char *out, size_t size)
{
    const uint16_t *code = k->code[find_action(action)];
    char word[INPUT_CODE_NAME_SIZE];
    size_t n = 0;

    snprintf(out, size, "none");
    for (int i = 0; i < KEYS_PER_ACTION && code[i] && n < size; i++) {
        input_code_name(code[i], word, sizeof word);
        n += (size_t)snprintf(out + n, size - n, "%s%s", i ? " " : "", word);
    }
}

/* ---- binding by pressing ---- */

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
    unsigned with = c->modifier == KEY_LEFT_ALT || c->modifier == KEY_RIGHT_ALT ? INPUT_CODE_ALT : INPUT_CODE_CTRL;

    for (unsigned u = 4; u < PLAT_KEYS; u++) {
        if (!plat_is_key_held(in, u) || c->keys[u >> 3] >> (u & 7) & 1)
            continue;
        if (!is_modifier(u))
            return c->modifier ? u | with : u;
        c->modifier = u;
    }
    return c->modifier && !plat_is_key_held(in, c->modifier) ? c->modifier : 0;
}

uint16_t keys_capture_poll(struct keys_capture *c, const struct plat_input *in)
{
    unsigned code = captured_key(c, in);

    for (int i = 0; i < PLAT_MAX_CONTROLLERS && !code; i++)
        for (unsigned bit = 0; bit < PLAT_BUTTONS && !code; bit++)
            if ((in->controllers[i] & ~c->controllers[i]) >> bit & 1)
                code = INPUT_CODE_CONTROLLER | bit;
    memcpy(c->keys, in->keys, sizeof c->keys);
    memcpy(c->controllers, in->controllers, sizeof c->controllers);
    return (uint16_t)code;
}

bool keys_add(struct keys *k, const char *action, uint16_t code)
{
    uint16_t *list = k->code[find_action(action)];
    int n = 0;

    while (n < KEYS_PER_ACTION && list[n] && list[n] != code)
        n++;
    if (n == KEYS_PER_ACTION)
        return false;
    list[n] = code;
    return true;
}

void keys_remove(struct keys *k, const char *action, uint16_t code)
{
    uint16_t *list = k->code[find_action(action)];
    int to = 0;

    for (int i = 0; i < KEYS_PER_ACTION; i++)
        if (list[i] != code)
            list[to++] = list[i];
    while (to < KEYS_PER_ACTION)
        list[to++] = 0;
}

/* Returns whether one press can be both inputs. pad.south is a different controller for each player, and any controller
 * for hotkeys. */
static bool can_be_one_press(unsigned a, int player_a, unsigned b, int player_b)
{
    if (!(a & b & INPUT_CODE_CONTROLLER))
        return a == b;
    if (input_code_button(a) != input_code_button(b))
        return false;
    if (input_code_controller(a) && input_code_controller(b))
        return input_code_controller(a) == input_code_controller(b);
    return input_code_controller(a) || input_code_controller(b) || player_a == player_b || player_a < 0 || player_b < 0;
}

const char *keys_conflict(const struct keys *k, const char *action, uint16_t code)
{
    int at = find_action(action);

    for (int i = 0; i < KEYS_ACTIONS; i++)
        for (int n = 0; i != at && n < KEYS_PER_ACTION; n++)
            if (k->code[i][n] && can_be_one_press(code, player_of(at), k->code[i][n], player_of(i)))
                return actions[i].name;
    return NULL;
}

bool keys_reserved(uint16_t code)
{
    return code == KEY_ESCAPE || (code & INPUT_CODE_CONTROLLER && input_code_button(code) == PLAT_GUIDE);
}

/* ---- reading ---- */

/* A modifier counts for one more poll after its release, because it may be released before a quick chord's other key is
 * read. */
static void update_modifiers(struct keys *k, const struct plat_input *in)
{
    const bool alt = plat_is_key_held(in, KEY_LEFT_ALT) || plat_is_key_held(in, KEY_RIGHT_ALT);
    const bool ctrl = plat_is_key_held(in, KEY_LEFT_CTRL) || plat_is_key_held(in, KEY_RIGHT_CTRL);

    k->alt = alt || k->had_alt;
    k->ctrl = ctrl || k->had_ctrl;
    k->had_alt = alt;
    k->had_ctrl = ctrl;
}

static bool modifiers_held(const struct keys *k, unsigned code)
{
    return !(code & INPUT_CODE_ALT && !k->alt) && !(code & INPUT_CODE_CTRL && !k->ctrl);
}

static void consume_chord_keys(struct keys *k, const struct plat_input *in)
{
    for (int i = 0; i < KEYS_ACTIONS * KEYS_PER_ACTION; i++) {
        unsigned code = k->code[i / KEYS_PER_ACTION][i % KEYS_PER_ACTION], usage = code & 255;
        if (input_code_is_chord(code) && modifiers_held(k, code))
            k->consumed[usage >> 3] = (uint8_t)(k->consumed[usage >> 3] | 1u << (usage & 7));
    }
    for (int i = 0; i < PLAT_KEYS / 8; i++)
        k->consumed[i] &= in->keys[i];
}

/* Returns the held buttons of a controller; which 0: of the player's own, or for hotkeys (player -1) of all. */
static uint32_t held_buttons(const struct controllers *controllers, unsigned which, int player)
{
    uint32_t all = 0;

    if (which)
        return which <= PLAT_MAX_CONTROLLERS ? controllers->buttons[which - 1] : 0;
    if (player >= 0)
        return controllers_buttons(controllers, player);
    for (int i = 0; i < PLAT_MAX_CONTROLLERS; i++)
        all |= controllers->buttons[i];
    return all;
}

static bool key_held(const struct keys *k, const struct plat_input *in, unsigned code)
{
    unsigned usage = code & 255;

    if (input_code_is_chord(code))
        return plat_is_key_held(in, usage) && modifiers_held(k, code);
    return plat_is_key_held(in, usage) && !(k->consumed[usage >> 3] >> (usage & 7) & 1);
}

/* Returns whether a one-handed layout uses an input: the player's own layout any input, the other player's layout a
 * key. */
static bool is_in_hand_layout(const struct keys *k, unsigned code, int player)
{
    const uint16_t *list = &k->hand[0][0][0];
    enum { EACH = PAD_BUTTON_COUNT * KEYS_PER_HAND };

    for (int i = 0; i < MAX_PLAYERS * EACH; i++)
        if (list[i] == code && (i / EACH == player || !(code & INPUT_CODE_CONTROLLER)))
            return true;
    return false;
}

struct held_by {
    bool key, controller;
};

static struct held_by action_held(const struct keys *k, const struct plat_input *in,
                                  const struct controllers *controllers, int action)
{
    struct held_by held_by = { false, false };
    int player = player_of(action);

    for (int i = 0; i < KEYS_PER_HAND + KEYS_PER_ACTION; i++) {
        unsigned code = nth_code(k, action, i);
        if (!code || (i >= KEYS_PER_HAND && player >= 0 && is_in_hand_layout(k, code, player)))
            continue;
        if (code & INPUT_CODE_CONTROLLER)
            held_by.controller =
                held_by.controller ||
                held_buttons(controllers, input_code_controller(code), player) >> input_code_button(code) & 1;
        else
            held_by.key = held_by.key || key_held(k, in, code);
    }
    return held_by;
}

/* pressed: where the player has just pressed something. */
static void update_device(struct keys *k, const struct controllers *controllers, int player, struct held_by pressed)
{
    int i = controllers->controller_of[player];

    if (!pressed.key && !pressed.controller)
        return;
    k->device[player].is_controller = !pressed.key;
    k->device[player].kind = i == CONTROLLERS_NONE ? PLAT_UNKNOWN_CONTROLLER : controllers->info[i].kind;
    k->latest = k->device[player];
}

static uint16_t read_pad(struct keys *k, const struct plat_input *in, const struct controllers *controllers, int player)
{
    unsigned keys = 0, buttons = 0;

    for (int i = 0; i < PAD_BUTTON_COUNT; i++) {
        struct held_by held_by = action_held(k, in, controllers, player * PAD_BUTTON_COUNT + i);
        keys |= (unsigned)held_by.key << i;
        buttons |= (unsigned)held_by.controller << i;
    }
    update_device(k, controllers, player,
                  (struct held_by){ keys & ~(unsigned)k->held_by_key[player],
                                    buttons & ~(unsigned)k->held_by_controller[player] });
    k->held_by_key[player] = (uint16_t)keys;
    k->held_by_controller[player] = (uint16_t)buttons;
    return (uint16_t)(keys | buttons);
}

void keys_read(struct keys *k, const struct plat_input *in, const struct controllers *controllers,
               struct keys_state *out)
{
    memset(out, 0, sizeof *out);
    update_modifiers(k, in);
    consume_chord_keys(k, in);
    for (int p = 0; p < MAX_PLAYERS; p++) {
        unsigned was = k->held_by_key[p] | k->held_by_controller[p];
        out->pads[p] = read_pad(k, in, controllers, p);
        out->pads_pressed[p] = (uint16_t)(out->pads[p] & ~was);
        out->any_pad_pressed = out->any_pad_pressed || out->pads_pressed[p];
    }
    for (int i = 0; i < HOTKEYS; i++) {
        struct held_by held_by = action_held(k, in, controllers, MAX_PLAYERS * PAD_BUTTON_COUNT + i);
        out->held |= (uint32_t)(held_by.key || held_by.controller) << i;
    }
    out->pressed = out->held & ~k->held;
    k->held = out->held;
}

void keys_print_help(uint32_t without, void (*line)(const char *))
{
    char text[128];
    for (int i = 0; i < KEYS_ACTIONS; i++) {
        if (player_of(i) < 0 && without >> (i - MAX_PLAYERS * PAD_BUTTON_COUNT) & 1)
            continue;
        int n = snprintf(text, sizeof text, "  %-11s %-30s %s", actions[i].name, actions[i].inputs, actions[i].help);
        while (n > 0 && text[n - 1] == ' ')
            text[--n] = 0;
        line(text);
    }
}
