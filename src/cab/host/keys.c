/*
 * keys.c - see keys.h.
 *
 * One table of actions is the default map, the names of the settings file and the help text. Its switches are strings
 * that go through the same parser as the user's own. A switch is 16 bits: a HID usage, or CONTROLLER | which << 5 |
 * switch.
 */
#include "keys.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { CONTROLLER = 0x100, WITH_ALT = 0x1000, WITH_CTRL = 0x2000, WORD = 32 };

enum { KEY_LEFT_CTRL = 224, KEY_LEFT_ALT = 226, KEY_RIGHT_CTRL = 228, KEY_RIGHT_ALT = 230 };

static const struct action {
    const char *name, *switches, *help;
} actions[KEYS_ACTIONS] = {
    { "p1.up", "up pad.up pad.lup", "move" },
    { "p1.down", "down pad.down pad.ldown", "move" },
    { "p1.left", "left pad.left pad.lleft", "move" },
    { "p1.right", "right pad.right pad.lright", "move" },
    { "p1.fire", "z pad.south", "fire; yes in menus" },
    { "p1.bomb", "x pad.east", "bomb; no in menus" },
    { "p1.focus", "lshift pad.r1 pad.r2", "move slowly" },
    { "p1.special", "c pad.west pad.l1", "whatever the game makes of it" },
    { "p1.start", "enter 1 pad.start", "start, the game's own pause" },
    { "p1.select", "tab pad.select", "select" },
    { "p2.up", "w kp8 pad.up pad.lup", "the second player" },
    { "p2.down", "s kp5 kp2 pad.down pad.ldown", "" },
    { "p2.left", "a kp4 pad.left pad.lleft", "" },
    { "p2.right", "d kp6 pad.right pad.lright", "" },
    { "p2.fire", "j kp0 pad.south", "" },
    { "p2.bomb", "k kp. pad.east", "" },
    { "p2.focus", "i kpenter pad.r1 pad.r2", "" },
    { "p2.special", "l kp+ pad.west pad.l1", "" },
    { "p2.start", "2 kp* pad.start", "" },
    { "p2.select", "3 kp- pad.select", "" },
    { "pause", "p pause", "stop the clock, and go on" },
    { "step", "period", "one frame, then pause" },
    { "slow", "comma", "half, a quarter, full speed" },
    { "turbo", "slash", "as fast as it goes, while held" },
    { "rewind", "backspace", "back in time, while held" },
    { "back", "b", "one frame back, then pause" },
    { "before", "lbracket", "to the moment before: a stage, a boss, a phase, a death" },
    { "after", "rbracket", "to the moment after" },
    { "goto", "home", "asks for a frame, and goes there" },
    { "takeover", "t", "play on from here in a demo, as a demo of your own" },
    { "reload", "f5", "take in what changed in the game's folder now" },
    { "practice", "f2", "choose a piece to practise" },
    { "retry", "r", "the same piece again, at once" },
    { "mute", "m", "sound off, on" },
    { "quieter", "minus", "volume, ten percent less" },
    { "louder", "equals", "and more" },
    { "screenshot", "f12", "a PNG into the current folder" },
    { "fullscreen", "f11 alt+enter", "fullscreen, window" },
    { "quit", "ctrl+q", "leave at once" },
    { "menu", "escape pad.guide", "the cabinet's menu" },
    { "help", "f1", "all keys, and what they do" },
    { "shapes", "h", "hit shapes and graze rings, over the picture" },
    { "gauges", "g", "how full every part is, and Lua's memory" },
    { "split", "v", "where the time of a frame goes" },
    { "tasks", "n", "tasks and their lines, random numbers drawn" },
    { "mixer", "f3", "voices, levels, and where the music is" },
    { "console", "backquote", "a line of Lua; the board stands still" },
};

/* Keys by HID usage, from 4 on; letters, digits and F keys are worked out. */
static const struct key {
    uint8_t usage;
    const char *name;
} keys[] = {
    { 40, "enter" },     { 41, "escape" },   { 42, "backspace" },   { 43, "tab" },        { 44, "space" },
    { 45, "minus" },     { 46, "equals" },   { 47, "lbracket" },    { 48, "rbracket" },   { 49, "backslash" },
    { 51, "semicolon" }, { 52, "quote" },    { 53, "backquote" },   { 54, "comma" },      { 55, "period" },
    { 56, "slash" },     { 57, "capslock" }, { 70, "printscreen" }, { 71, "scrolllock" }, { 72, "pause" },
    { 73, "insert" },    { 74, "home" },     { 75, "pageup" },      { 76, "delete" },     { 77, "end" },
    { 78, "pagedown" },  { 79, "right" },    { 80, "left" },        { 81, "down" },       { 82, "up" },
    { 83, "numlock" },   { 84, "kp/" },      { 85, "kp*" },         { 86, "kp-" },        { 87, "kp+" },
    { 88, "kpenter" },   { 98, "kp0" },      { 99, "kp." },         { 224, "lctrl" },     { 225, "lshift" },
    { 226, "lalt" },     { 227, "lgui" },    { 228, "rctrl" },      { 229, "rshift" },    { 230, "ralt" },
    { 231, "rgui" },
};

/* Switches of a controller, in the order of enum plat_switch. */
static const char *const switches[PLAT_SWITCHES] = {
    "up",     "down",  "left", "right", "south", "east",  "west",  "north",  "l1",  "r1",    "l2",    "r2",     "start",
    "select", "guide", "l3",   "r3",    "lup",   "ldown", "lleft", "lright", "rup", "rdown", "rleft", "rright",
};

enum { COUNT_KEYS = sizeof keys / sizeof *keys };

/* ---- names to codes; 0: no such switch ---- */

static unsigned number_after(const char *s, const char *prefix, unsigned lo, unsigned hi)
{
    size_t n = strlen(prefix);
    if (strncmp(s, prefix, n) != 0 || s[n] < '0' || s[n] > '9')
        return 0;
    char *end;
    unsigned long v = strtoul(s + n, &end, 10);
    return *end || v < lo || v > hi ? 0 : (unsigned)v;
}

static unsigned key_code(const char *s)
{
    if (s[0] >= 'a' && s[0] <= 'z' && !s[1])
        return 4u + (unsigned)(s[0] - 'a');
    if (s[0] >= '1' && s[0] <= '9' && !s[1])
        return 30u + (unsigned)(s[0] - '1');
    if (strcmp(s, "0") == 0)
        return 39;
    unsigned n;
    if ((n = number_after(s, "f", 1, 12)) != 0)
        return 57 + n;
    if ((n = number_after(s, "kp", 1, 9)) != 0)
        return 88 + n;
    for (int i = 0; i < COUNT_KEYS; i++)
        if (strcmp(s, keys[i].name) == 0)
            return keys[i].usage;
    return number_after(s, "key", 4, 255);
}

static unsigned switch_code(const char *s)
{
    unsigned which = s[3] == '1' || s[3] == '2' ? (unsigned)(s[3] - '0') : 0;
    s += which ? 4 : 3;
    if (*s++ != '.')
        return 0;
    for (unsigned i = 0; i < PLAT_SWITCHES; i++)
        if (strcmp(s, switches[i]) == 0)
            return CONTROLLER | which << 5 | i;
    return 0;
}

static unsigned chord_code(const char *s, unsigned with)
{
    unsigned code = key_code(strchr(s, '+') + 1);
    return code ? code | with : 0;
}

static unsigned code_of(const char *s)
{
    if (strncmp(s, "pad", 3) == 0)
        return switch_code(s);
    if (strncmp(s, "alt+", 4) == 0)
        return chord_code(s, WITH_ALT);
    if (strncmp(s, "ctrl+", 5) == 0)
        return chord_code(s, WITH_CTRL);
    return key_code(s);
}

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

bool keys_bind(struct keys *k, const char *action, const char *list, char *err, size_t err_size)
{
    uint16_t code[KEYS_EACH] = { 0 };
    char word[WORD];
    int at = find(action), n = 0;
    if (at < 0) {
        snprintf(err, err_size, "no action is called \"%s\"", action);
        return false;
    }
    for (const char *s = strcmp(list, "none") == 0 ? "" : list; next_word(&s, word);) {
        unsigned c = code_of(word);
        if (!c || n == KEYS_EACH) {
            snprintf(err, err_size, c ? "%s: \"%s\" is one switch too many" : "%s: no switch is called \"%s\"", action,
                     word);
            return false;
        }
        code[n++] = (uint16_t)c;
    }
    memcpy(k->code[at], code, sizeof code);
    return true;
}

/* The name that key_code or switch_code reads as that code. */
static void name_of(unsigned code, char *out, size_t size)
{
    unsigned which = code >> 5 & 3;

    for (int i = 0; i < COUNT_KEYS; i++) {
        if (code == keys[i].usage) {
            snprintf(out, size, "%s", keys[i].name);
            return;
        }
    }
    if (code & CONTROLLER)
        snprintf(out, size, which ? "pad%u.%s" : "pad%.0u.%s", which, switches[code & 31]);
    else if (code < 30)
        snprintf(out, size, "%c", 'a' + (int)code - 4);
    else if (code < 40)
        snprintf(out, size, "%u", (code - 29) % 10);
    else if (code >= 58 && code <= 69)
        snprintf(out, size, "f%u", code - 57);
    else if (code >= 89 && code <= 97)
        snprintf(out, size, "kp%u", code - 88);
    else
        snprintf(out, size, "key%u", code);
}

/* The same of any code; "none" for 0. */
static void chord_name(unsigned code, char *out, size_t size)
{
    const char *with = code & WITH_ALT ? "alt+" : code & WITH_CTRL ? "ctrl+" : "";

    snprintf(out, size, "%s", code ? with : "none");
    if (code && size > strlen(with))
        name_of(code & ~(unsigned)(WITH_ALT | WITH_CTRL), out + strlen(with), size - strlen(with));
}

void keys_first(const struct keys *k, const char *action, char *out, size_t size)
{
    chord_name(k->code[find(action)][0], out, size);
}

void keys_list(const struct keys *k, int action, char *out, size_t size)
{
    char name[WORD + 8];
    size_t n = 0;

    snprintf(out, size, "none");
    for (int i = 0; i < KEYS_EACH && n < size; i++)
        if (k->code[action][i]) {
            chord_name(k->code[action][i], name, sizeof name);
            n += (size_t)snprintf(out + n, size - n, "%s%s", n ? " " : "", name);
        }
}

const char *keys_action(int action)
{
    return actions[action].name;
}

const char *keys_does(int action)
{
    return actions[action].help;
}

void keys_defaults(struct keys *k)
{
    char err[128];
    memset(k, 0, sizeof *k);
    for (int i = 0; i < KEYS_ACTIONS; i++)
        keys_bind(k, actions[i].name, actions[i].switches, err, sizeof err);
}

/* ---- reading ---- */

static bool modifier(const struct plat_input *in, unsigned code)
{
    if (code & WITH_ALT && !plat_key(in, KEY_LEFT_ALT) && !plat_key(in, KEY_RIGHT_ALT))
        return false;
    return !(code & WITH_CTRL) || plat_key(in, KEY_LEFT_CTRL) || plat_key(in, KEY_RIGHT_CTRL);
}

static bool is_chord(unsigned code)
{
    return code & (WITH_ALT | WITH_CTRL);
}

static void eat(struct keys *k, const struct plat_input *in)
{
    for (int i = 0; i < KEYS_ACTIONS * KEYS_EACH; i++) {
        unsigned code = k->code[i / KEYS_EACH][i % KEYS_EACH], usage = code & 255;
        if (is_chord(code) && modifier(in, code))
            k->eaten[usage >> 3] = (uint8_t)(k->eaten[usage >> 3] | 1u << (usage & 7));
    }
    for (int i = 0; i < PLAT_KEYS / 8; i++)
        k->eaten[i] &= in->keys[i];
}

/* player: 1 or 2; 0: the cabinet, which has both controllers. */
static uint32_t controller(const struct plat_input *in, unsigned which, unsigned player)
{
    which = which ? which : player;
    return which ? in->controllers[which - 1] : in->controllers[0] | in->controllers[1];
}

static bool code_held(const struct keys *k, const struct plat_input *in, unsigned code, unsigned player)
{
    unsigned usage = code & 255;
    if (!code)
        return false;
    if (code & CONTROLLER)
        return controller(in, code >> 5 & 3, player) >> (code & 31) & 1;
    if (is_chord(code))
        return plat_key(in, usage) && modifier(in, code);
    return plat_key(in, usage) && !(k->eaten[usage >> 3] >> (usage & 7) & 1);
}

static bool action_held(const struct keys *k, const struct plat_input *in, int action)
{
    unsigned player = action < PAD_BUTTONS ? 1 : action < PADS * PAD_BUTTONS ? 2 : 0;
    for (int i = 0; i < KEYS_EACH; i++)
        if (code_held(k, in, k->code[action][i], player))
            return true;
    return false;
}

void keys_read(struct keys *k, const struct plat_input *in, struct keys_read *out)
{
    memset(out, 0, sizeof *out);
    eat(k, in);
    for (int i = 0; i < PADS * PAD_BUTTONS; i++)
        if (action_held(k, in, i))
            out->pads[i / PAD_BUTTONS] = (uint16_t)(out->pads[i / PAD_BUTTONS] | 1u << i % PAD_BUTTONS);
    for (int i = 0; i < CAB_KEYS; i++)
        if (action_held(k, in, PADS * PAD_BUTTONS + i))
            out->held |= 1u << i;
    out->pressed = out->held & ~k->held;
    out->fresh = (out->pads[0] & ~k->pads[0]) || (out->pads[1] & ~k->pads[1]);
    memcpy(k->pads, out->pads, sizeof k->pads);
    k->held = out->held;
}

void keys_help(void (*line)(const char *))
{
    char text[128];
    for (int i = 0; i < KEYS_ACTIONS; i++) {
        int n = snprintf(text, sizeof text, "  %-11s %-30s %s", actions[i].name, actions[i].switches, actions[i].help);
        while (n > 0 && text[n - 1] == ' ')
            text[--n] = 0;
        line(text);
    }
}
