/*
 * input_code.c - names and labels of keys and buttons (input_code.h).
 */
#include "input_code.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "../../../fb/utf8.h"

/* Keys by HID usage. Letters, digits and F keys are computed. */
static const struct key {
    uint8_t usage;
    const char *name;
} key_names[] = {
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

/* Buttons of a controller. */
static const char *const button_names[PLAT_BUTTONS] = {
    "up",     "down",  "left", "right", "south", "east",  "west",  "north",  "l1",  "r1",    "l2",    "r2",     "start",
    "select", "guide", "l3",   "r3",    "lup",   "ldown", "lleft", "lright", "rup", "rdown", "rleft", "rright",
};

enum { KEY_NAMES = sizeof key_names / sizeof *key_names };

/* ---- names to codes; 0: unknown ---- */

static unsigned parse_number(const char *s, const char *prefix, unsigned lo, unsigned hi)
{
    size_t n = strlen(prefix);
    if (strncmp(s, prefix, n) != 0 || s[n] < '0' || s[n] > '9')
        return 0;
    char *end;
    unsigned long v = strtoul(s + n, &end, 10);
    return *end || v < lo || v > hi ? 0 : (unsigned)v;
}

static unsigned parse_key(const char *s)
{
    if (s[0] >= 'a' && s[0] <= 'z' && !s[1])
        return 4u + (unsigned)(s[0] - 'a');
    if (s[0] >= '1' && s[0] <= '9' && !s[1])
        return 30u + (unsigned)(s[0] - '1');
    if (strcmp(s, "0") == 0)
        return 39;
    unsigned n;
    if ((n = parse_number(s, "f", 1, 12)) != 0)
        return 57 + n;
    if ((n = parse_number(s, "kp", 1, 9)) != 0)
        return 88 + n;
    for (int i = 0; i < KEY_NAMES; i++)
        if (strcmp(s, key_names[i].name) == 0)
            return key_names[i].usage;
    return parse_number(s, "key", 4, 255);
}

static unsigned parse_button(const char *s)
{
    unsigned controller = s[3] >= '1' && s[3] < '1' + PLAT_MAX_CONTROLLERS ? (unsigned)(s[3] - '0') : 0;
    s += controller ? 4 : 3;
    if (*s++ != '.')
        return 0;
    for (unsigned i = 0; i < PLAT_BUTTONS; i++)
        if (strcmp(s, button_names[i]) == 0)
            return INPUT_CODE_CONTROLLER | controller << 5 | i;
    return 0;
}

static unsigned parse_chord(const char *s, unsigned prefix)
{
    unsigned code = parse_key(strchr(s, '+') + 1);
    return code ? code | prefix : 0;
}

uint16_t input_code_parse(const char *s)
{
    if (strncmp(s, "pad", 3) == 0)
        return (uint16_t)parse_button(s);
    if (strncmp(s, "alt+", 4) == 0)
        return (uint16_t)parse_chord(s, INPUT_CODE_ALT);
    if (strncmp(s, "ctrl+", 5) == 0)
        return (uint16_t)parse_chord(s, INPUT_CODE_CTRL);
    return (uint16_t)parse_key(s);
}

/* Writes the name of a key or button. */
static void write_name(unsigned code, char *out, size_t size)
{
    unsigned controller = input_code_controller(code);

    for (int i = 0; i < KEY_NAMES; i++) {
        if (code == key_names[i].usage) {
            snprintf(out, size, "%s", key_names[i].name);
            return;
        }
    }
    if (code & INPUT_CODE_CONTROLLER)
        snprintf(out, size, controller ? "pad%u.%s" : "pad%.0u.%s", controller, button_names[code & 31]);
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

void input_code_name(unsigned code, char *out, size_t size)
{
    const char *prefix = code & INPUT_CODE_ALT ? "alt+" : code & INPUT_CODE_CTRL ? "ctrl+" : "";

    snprintf(out, size, "%s", code ? prefix : "none");
    if (code && size > strlen(prefix))
        write_name(code & ~(unsigned)(INPUT_CODE_ALT | INPUT_CODE_CTRL), out + strlen(prefix), size - strlen(prefix));
}

/* ---- labels of keys ---- */

/* Returns the name of the key with a punctuation mark on a US keyboard, or NULL: "comma" is easier to read than ",". */
static const char *punctuation_name(char sign)
{
    static const char signs[] = "-=[]\\;'`,./";
    static const uint8_t usages[] = { 45, 46, 47, 48, 49, 51, 52, 53, 54, 55, 56 };
    const char *at = sign ? strchr(signs, sign) : NULL;

    for (int i = 0; at && i < KEY_NAMES; i++)
        if (key_names[i].usage == usages[at - signs])
            return key_names[i].name;
    return NULL;
}

enum { DRAWABLE_END = 0x180 /* code points below this can be drawn by the canvas: Latin */ };

static bool can_be_drawn(const char *text)
{
    const char *end = text + strlen(text);

    while (text < end)
        if (utf8_next(&text, end) >= DRAWABLE_END)
            return false;
    return true;
}

/* Letters are lower case, as in the settings. */
static void key_label(unsigned code, char *out, size_t size)
{
    const unsigned chord = code & (INPUT_CODE_ALT | INPUT_CODE_CTRL);
    char text[INPUT_CODE_NAME_SIZE];

    if (!code || !plat_key_label(code & 255, text, sizeof text) || !can_be_drawn(text)) {
        input_code_name(code, out, size);
        return;
    }
    if (text[0] >= 'A' && text[0] <= 'Z' && !text[1])
        text[0] = (char)(text[0] - 'A' + 'a');
    const char *name = text[1] ? NULL : punctuation_name(text[0]);
    snprintf(out, size, "%s%s", chord == INPUT_CODE_ALT ? "alt+" : chord ? "ctrl+" : "", name ? name : text);
}

/* ---- labels of buttons ---- */

/* The labels for unknown controllers, and for directions on all. */
static const char *const common_labels[PLAT_BUTTONS] = {
    [PLAT_DPAD_UP] = "D-pad up",
    [PLAT_DPAD_DOWN] = "D-pad down",
    [PLAT_DPAD_LEFT] = "D-pad left",
    [PLAT_DPAD_RIGHT] = "D-pad right",
    [PLAT_SOUTH] = "Bottom button",
    [PLAT_EAST] = "Right button",
    [PLAT_WEST] = "Left button",
    [PLAT_NORTH] = "Top button",
    [PLAT_SHOULDER_LEFT] = "L1",
    [PLAT_SHOULDER_RIGHT] = "R1",
    [PLAT_TRIGGER_LEFT] = "L2",
    [PLAT_TRIGGER_RIGHT] = "R2",
    [PLAT_START] = "Start",
    [PLAT_SELECT] = "Select",
    [PLAT_GUIDE] = "Guide",
    [PLAT_LEFT_STICK_PRESS] = "L3",
    [PLAT_RIGHT_STICK_PRESS] = "R3",
    [PLAT_LEFT_STICK_UP] = "Stick up",
    [PLAT_LEFT_STICK_DOWN] = "Stick down",
    [PLAT_LEFT_STICK_LEFT] = "Stick left",
    [PLAT_LEFT_STICK_RIGHT] = "Stick right",
    [PLAT_RIGHT_STICK_UP] = "Right stick up",
    [PLAT_RIGHT_STICK_DOWN] = "Right stick down",
    [PLAT_RIGHT_STICK_LEFT] = "Right stick left",
    [PLAT_RIGHT_STICK_RIGHT] = "Right stick right",
};

/* The labels that differ for a kind of controller; NULL: as above. */
enum { BUTTONS = PLAT_RIGHT_STICK_PRESS + 1 };
#define XBOX                                                                                                           \
    [PLAT_SOUTH] = "A", [PLAT_EAST] = "B", [PLAT_WEST] = "X", [PLAT_NORTH] = "Y", [PLAT_SHOULDER_LEFT] = "LB",         \
    [PLAT_SHOULDER_RIGHT] = "RB", [PLAT_TRIGGER_LEFT] = "LT", [PLAT_TRIGGER_RIGHT] = "RT",                             \
    [PLAT_LEFT_STICK_PRESS] = "LS", [PLAT_RIGHT_STICK_PRESS] = "RS"
#define PLAYSTATION                                                                                                    \
    [PLAT_SOUTH] = "\u2715", [PLAT_EAST] = "\u25CB", [PLAT_WEST] = "\u25A1", [PLAT_NORTH] = "\u25B3",                  \
    [PLAT_GUIDE] = "PS"
static const char *const labels[PLAT_CONTROLLER_KINDS][BUTTONS] = {
    [PLAT_XBOX] = { XBOX, [PLAT_START] = "Menu", [PLAT_SELECT] = "View", [PLAT_GUIDE] = "Xbox" },
    [PLAT_XBOX_360] = { XBOX, [PLAT_SELECT] = "Back" },
    [PLAT_PS3] = { PLAYSTATION },
    [PLAT_PS4] = { PLAYSTATION, [PLAT_START] = "Options", [PLAT_SELECT] = "Share" },
    [PLAT_PS5] = { PLAYSTATION, [PLAT_START] = "Options", [PLAT_SELECT] = "Create" },
    [PLAT_NINTENDO] = { [PLAT_SOUTH] = "B",
                        [PLAT_EAST] = "A",
                        [PLAT_WEST] = "Y",
                        [PLAT_NORTH] = "X",
                        [PLAT_SHOULDER_LEFT] = "L",
                        [PLAT_SHOULDER_RIGHT] = "R",
                        [PLAT_TRIGGER_LEFT] = "ZL",
                        [PLAT_TRIGGER_RIGHT] = "ZR",
                        [PLAT_START] = "+",
                        [PLAT_SELECT] = "-",
                        [PLAT_GUIDE] = "HOME" },
};

void input_code_label(unsigned code, enum plat_controller_kind kind, char *out, size_t size)
{
    unsigned bit = input_code_button(code);

    if (!(code & INPUT_CODE_CONTROLLER))
        key_label(code, out, size);
    else if (bit >= PLAT_BUTTONS)
        input_code_name(code, out, size);
    else
        snprintf(out, size, "%s", bit < BUTTONS && labels[kind][bit] ? labels[kind][bit] : common_labels[bit]);
}

const char *input_code_controller_name(enum plat_controller_kind kind)
{
    static const char *const names[PLAT_CONTROLLER_KINDS] = {
        [PLAT_UNKNOWN_CONTROLLER] = "Controller",
        [PLAT_XBOX] = "Xbox",
        [PLAT_XBOX_360] = "Xbox 360",
        [PLAT_PS3] = "PlayStation 3",
        [PLAT_PS4] = "PlayStation 4",
        [PLAT_PS5] = "PlayStation 5",
        [PLAT_NINTENDO] = "Nintendo",
    };

    return names[kind];
}
