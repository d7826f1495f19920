/* test_keys.c - the key map, its names, chords, and the settings file that changes it. */
#include "../test.h"
#include "../../src/board/board.h"
#include "../../src/player/settings/config.h"
#include "../../src/player/picture/rotation.h"

static struct keys k;
static struct keys_state r;
static struct plat_input in;
static char err[256];

static int setup(void **state)
{
    (void)state;
    keys_set_defaults(&k);
    memset(&r, 0, sizeof r);
    memset(&in, 0, sizeof in);
    return 0;
}

static void press(unsigned usage)
{
    in.keys[usage >> 3] = (uint8_t)(in.keys[usage >> 3] | 1u << (usage & 7));
}

static void release(unsigned usage)
{
    in.keys[usage >> 3] = (uint8_t)(in.keys[usage >> 3] & ~(1u << (usage & 7)));
}

/* A poll with the first controller player 1's and the second player 2's. */
static void poll(void)
{
    struct controllers controllers;

    controllers_open(&controllers);
    memcpy(controllers.buttons, in.controllers, sizeof controllers.buttons);
    for (int p = 0; p < MAX_PLAYERS; p++)
        controllers.controller_of[p] = p;
    controllers.info[0].kind = PLAT_PS4;
    controllers.info[1].kind = PLAT_NINTENDO;
    keys_read(&k, &in, &controllers, &r);
}

/* The pads a single key makes, player 2 in the upper half. */
static uint32_t pads_of(unsigned usage)
{
    setup(NULL);
    press(usage);
    poll();
    return r.pads[0] | (uint32_t)r.pads[1] << 16;
}

static void bind(const char *action, const char *list)
{
    assert_true(keys_bind(&k, action, list, err, sizeof err));
}

static void hint_is(const char *action, const char *want)
{
    char name[INPUT_CODE_NAME_SIZE];

    keys_hint(&k, action, name, sizeof name);
    assert_string_equal(name, want);
}

static void list_is(const char *action, const char *want)
{
    char list[KEYS_PER_ACTION * INPUT_CODE_NAME_SIZE];

    keys_write_list(&k, action, list, sizeof list);
    assert_string_equal(list, want);
}

/* ---- what is held ---- */

TEST(standard_keys)
{
    static const struct {
        unsigned usage;
        uint32_t pads;
    } rows[] = {
        { 82, PAD_UP },
        { 29, PAD_FIRE },
        { 225, PAD_FOCUS },
        { 40, PAD_START },
        { 43, PAD_SELECT },
        { 26, (uint32_t)PAD_UP << 16 },
        { 98, (uint32_t)PAD_FIRE << 16 },
        { 42, 0 }, /* backspace and m are the program's */
        { 16, 0 },
    };

    for (int i = 0; i < KEYS_ACTIONS; i++)
        assert_int_not_equal(k.code[i][0], 0);
    for (size_t i = 0; i < sizeof rows / sizeof *rows; i++)
        assert_int_equal(pads_of(rows[i].usage), rows[i].pads);
    for (unsigned usage = 4; usage < 256; usage++) { /* no key means two things */
        const uint32_t pads = pads_of(usage);
        assert_true((pads & (pads - 1)) == 0);
    }
}

TEST(controllers_are_the_players)
{
    in.controllers[0] = 1u << PLAT_SOUTH;
    in.controllers[1] = 1u << PLAT_LEFT_STICK_UP;
    poll();
    assert_int_equal(r.pads[0], PAD_FIRE);
    assert_int_equal(r.pads[1], PAD_UP);
    bind("p1.fire", "pad2.lup");
    bind("pause", "pad.south");
    poll();
    assert_int_equal(r.pads[0], PAD_FIRE);
    assert_int_equal(r.held, 1u << HOTKEY_PAUSE);
    in.controllers[1] = 0;
    poll();
    assert_int_equal(r.pads[0], 0);
}

TEST(a_chord_eats_its_key)
{
    press(230);
    press(40);
    poll();
    assert_int_equal(r.pressed, 1u << HOTKEY_FULLSCREEN);
    assert_int_equal(r.pads[0], 0);
    release(230); /* Alt let go first: Enter is still not Start */
    poll();
    poll();
    assert_int_equal(r.held, 0);
    assert_int_equal(r.pads[0], 0);
    release(40);
    poll();
    press(40);
    poll();
    assert_int_equal(r.pads[0], PAD_START);
}

/* Ctrl is read at one poll, q and its release at the next, when both are up. */
TEST(a_quick_chord)
{
    press(224);
    poll();
    release(224);
    press(20);
    poll();
    assert_true(r.pressed & (uint32_t)1 << HOTKEY_QUIT);
    release(20);
    poll();
    press(20);
    poll();
    assert_false(r.pressed & (uint32_t)1 << HOTKEY_QUIT);
}

TEST(pressed_is_once)
{
    press(19);
    press(29);
    poll();
    assert_int_equal(r.pressed, 1u << HOTKEY_PAUSE);
    assert_true(r.any_pad_pressed);
    poll();
    assert_int_equal(r.held, 1u << HOTKEY_PAUSE);
    assert_int_equal(r.pressed, 0);
    assert_false(r.any_pad_pressed);
}

/* ---- one hand ---- */

/* One hand: its inputs mean what its layout says, and the other player's keys among them nothing to them. */
TEST(a_hand_has_its_half)
{
    keys_set_hand(&k, 0, HAND_LEFT);
    press(26); /* w, player 2's up */
    press(44); /* space */
    in.controllers[0] = 1u << PLAT_SELECT;
    poll();
    assert_int_equal(r.pads[0], PAD_UP | PAD_FIRE | PAD_START);
    assert_int_equal(r.pads[1], 0);
    hint_is("p1.up", "w");
    memset(&in, 0, sizeof in);
    press(29); /* z is still there */
    in.controllers[0] = 1u << PLAT_LEFT_STICK_PRESS | 1u << PLAT_TRIGGER_LEFT;
    in.controllers[1] = 1u << PLAT_SELECT; /* player 2 has two hands */
    poll();
    assert_int_equal(r.pads[0], PAD_FIRE | PAD_BOMB | PAD_FOCUS);
    assert_int_equal(r.pads[1], PAD_SELECT);
    keys_set_hand(&k, 0, HAND_RIGHT);
    memset(&in, 0, sizeof in);
    in.controllers[0] = 1u << PLAT_SHOULDER_RIGHT | 1u << PLAT_RIGHT_STICK_LEFT;
    press(98); /* kp0, player 2's fire */
    poll();
    assert_int_equal(r.pads[0], PAD_FIRE | PAD_SPECIAL | PAD_LEFT);
    assert_int_equal(r.pads[1], 0);
    keys_set_hand(&k, 0, HAND_BOTH);
    poll();
    assert_int_equal(r.pads[0], PAD_FOCUS);
    assert_int_equal(r.pads[1], PAD_FIRE);
}

/* Either hand reaches each button, on the keyboard and on a controller; select alone is missing on a controller. */
TEST(each_hand_reaches_everything)
{
    for (int hand = HAND_LEFT; hand <= HAND_RIGHT; hand++) {
        keys_set_hand(&k, 0, (enum keys_hand)hand);
        for (int i = 0; i < PAD_BUTTON_COUNT; i++) {
            bool key = false, pad = false;
            for (int n = 0; n < KEYS_PER_HAND; n++) {
                pad = pad || k.hand[0][i][n] & INPUT_CODE_CONTROLLER;
                key = key || (k.hand[0][i][n] && !(k.hand[0][i][n] & INPUT_CODE_CONTROLLER));
            }
            assert_true(key);
            assert_true(pad || 1 << i == PAD_SELECT);
        }
    }
}

/* ---- names ---- */

/* What a hint names follows what its player pressed last. */
TEST(hints_name_what_is_used)
{
    in.controllers[0] = 1u << PLAT_LEFT_STICK_UP;
    poll();
    hint_is("p1.fire", "\u2715");
    hint_is("p2.fire", "j");
    in.controllers[1] = 1u << PLAT_EAST;
    poll();
    hint_is("p2.bomb", "A");
    bind("silence", "m pad.north");
    hint_is("silence", "X");
    press(29); /* the controllers are still held: what is new counts */
    poll();
    hint_is("p1.fire", "z");
    hint_is("silence", "m");
    hint_is("p2.fire", "B");
    in.controllers[0] = 1u << PLAT_SOUTH; /* and it is used again */
    poll();
    assert_int_equal(r.pads_pressed[0], 0); /* z holds fire already */
    hint_is("p1.focus", "R1");
    bind("p1.focus", "q");
    hint_is("p1.focus", "q");
}

/* A layout for the tests: what keys print, by usage. */
static const char *layout[PLAT_KEYS];

bool plat_key_label(unsigned usage, char *text, size_t size)
{
    if (layout[usage])
        snprintf(text, size, "%s", layout[usage]);
    return layout[usage] != NULL;
}

/* A key is called by what is printed on it, where that can be drawn; the settings go on calling it by its place. */
TEST(keys_are_called_as_printed)
{
    layout[29] = "W";
    layout[54] = ";";
    layout[31] = "\u00e9";
    layout[27] = "\u0447";
    layout[20] = "A";
    hint_is("p1.fire", "w");
    hint_is("slow", "semicolon"); /* ; is where a US keyboard has the comma */
    hint_is("p2.start", "\u00e9");
    hint_is("p1.bomb", "x"); /* no picture of this letter */
    hint_is("quit", "ctrl+a");
    hint_is("p1.start", "enter");
    list_is("p1.fire", "z pad.south");
    memset(layout, 0, sizeof layout);
    hint_is("p1.fire", "z");
}

TEST(labels)
{
    static const struct {
        const char *name, *label[PLAT_CONTROLLER_KINDS];
    } rows[] = {
        { "pad.south", { "Bottom button", "A", "A", "\u2715", "\u2715", "\u2715", "B" } },
        { "pad.l2", { "L2", "LT", "LT", "L2", "L2", "L2", "ZL" } },
        { "pad.select", { "Select", "View", "Back", "Select", "Share", "Create", "-" } },
        { "pad.lup", { "Stick up", "Stick up", "Stick up", "Stick up", "Stick up", "Stick up", "Stick up" } },
        { "alt+enter", { "alt+enter", "alt+enter", "alt+enter", "alt+enter", "alt+enter", "alt+enter", "alt+enter" } },
    };
    char name[INPUT_CODE_NAME_SIZE];

    for (size_t i = 0; i < sizeof rows / sizeof *rows; i++)
        for (int kind = 0; kind < PLAT_CONTROLLER_KINDS; kind++) {
            input_code_label(input_code_parse(rows[i].name), (enum plat_controller_kind)kind, name, sizeof name);
            assert_string_equal(name, rows[i].label[kind]);
        }
    for (unsigned bit = 0; bit < PLAT_BUTTONS; bit++)
        for (int kind = 0; kind < PLAT_CONTROLLER_KINDS; kind++) {
            input_code_label(INPUT_CODE_CONTROLLER | bit, (enum plat_controller_kind)kind, name, sizeof name);
            assert_true(name[0]);
        }
}

/* ---- lists ---- */

TEST(bad_bindings_change_nothing)
{
    static const char *const bad[] = { "zz",         "f13",  "kp10",          "key3", "key256", "pad.",
                                       "pad5.south", "alt+", "alt+pad.south", "Z",    "z,x",    "none z" };
    const struct keys before = k;

    assert_false(keys_bind(&k, "p3.fire", "z", err, sizeof err));
    assert_string_equal(err, "unknown action \"p3.fire\"");
    for (size_t i = 0; i < sizeof bad / sizeof *bad; i++) {
        assert_false(keys_bind(&k, "p1.fire", bad[i], err, sizeof err));
        assert_memory_equal(&k, &before, sizeof k);
    }
    assert_false(keys_bind(&k, "p1.fire", "averyveryveryveryveryverylongword", err, sizeof err));
    assert_false(keys_bind(&k, "p1.fire", "a b c d e f g", err, sizeof err));
    assert_string_equal(err, "p1.fire: expected at most six keys and buttons; remove \"g\"");
}

/* All lists, as text, give the same codes again. */
TEST(lists_are_written_and_read)
{
    char text[KEYS_PER_ACTION * INPUT_CODE_NAME_SIZE];
    struct keys again;

    bind("step", "alt+kp. ctrl+key100 kp5 pad4.rright f12 0");
    bind("slow", "none");
    bind("p2.bomb", "key4");
    list_is("step", "alt+kp. ctrl+key100 kp5 pad4.rright f12 0");
    list_is("p2.bomb", "a");
    list_is("slow", "none");
    memset(&again, 0, sizeof again);
    for (int i = 0; i < KEYS_ACTIONS; i++) {
        keys_write_list(&k, keys_action_name(i), text, sizeof text);
        assert_true(keys_bind(&again, keys_action_name(i), text, err, sizeof err));
    }
    assert_memory_equal(k.code, again.code, sizeof k.code);
    keys_write_list(&k, "step", text, 6);
    assert_string_equal(text, "alt+k");
}

TEST(inputs_are_added_and_removed)
{
    assert_true(keys_add(&k, "p1.bomb", input_code_parse("q")));
    assert_true(keys_add(&k, "p1.bomb", input_code_parse("q")));
    list_is("p1.bomb", "x pad.east q");
    keys_remove(&k, "p1.bomb", input_code_parse("pad.east"));
    keys_remove(&k, "p1.bomb", input_code_parse("f1"));
    list_is("p1.bomb", "x q");
    bind("p1.bomb", "1 2 3 4 5 6");
    assert_true(keys_add(&k, "p1.bomb", input_code_parse("6")));
    assert_false(keys_add(&k, "p1.bomb", input_code_parse("7")));
}

/* What is captured of a key, or of two that are pressed one after the other. */
static uint16_t captured(unsigned first, unsigned second)
{
    struct keys_capture c;

    memset(&in, 0, sizeof in);
    keys_capture_begin(&c, &in);
    press(first);
    const uint16_t code = keys_capture_poll(&c, &in);
    if (code)
        return code;
    if (second)
        press(second);
    else
        release(first);
    return keys_capture_poll(&c, &in);
}

TEST(an_input_is_captured)
{
    struct keys_capture c;

    press(40); /* the enter that chose the row */
    keys_capture_begin(&c, &in);
    assert_int_equal(keys_capture_poll(&c, &in), 0);
    release(40);
    assert_int_equal(keys_capture_poll(&c, &in), 0);
    press(40);
    assert_int_equal(keys_capture_poll(&c, &in), 40);
    assert_int_equal(captured(225, 0), 225); /* shift is a key as any other */
    assert_int_equal(captured(226, 40), input_code_parse("alt+enter"));
    assert_int_equal(captured(228, 20), input_code_parse("ctrl+q"));
    assert_int_equal(captured(230, 0), 230); /* alt is itself when nothing comes with it */
    keys_capture_begin(&c, &in);
    in.controllers[3] = 1u << PLAT_LEFT_STICK_PRESS;
    assert_int_equal(keys_capture_poll(&c, &in), input_code_parse("pad.l3"));
    assert_int_equal(keys_capture_poll(&c, &in), 0);
}

static void conflict(const char *action, const char *name, const char *want)
{
    const char *got = keys_conflict(&k, action, input_code_parse(name));

    assert_string_equal(got ? got : "", want);
}

TEST(conflicts_are_named)
{
    conflict("p1.bomb", "z", "p1.fire");
    conflict("p1.bomb", "x", ""); /* its own */
    conflict("pause", "d", "p2.right");
    conflict("pause", "alt+d", ""); /* a chord is another input */
    conflict("p1.bomb", "pad.south", "p1.fire");
    conflict("pause", "pad.south", "p1.fire");    /* the program hears every controller */
    conflict("p1.bomb", "pad2.south", "p1.fire"); /* which may be player 1's */
    bind("p1.fire", "pad1.south");
    bind("p2.fire", "none");
    conflict("p1.bomb", "pad2.south", "");
    conflict("p2.bomb", "pad1.south", "p1.fire");
    bind("p2.fire", "pad.north");
    conflict("p1.bomb", "pad.north", ""); /* each of them has a controller */
    assert_true(keys_reserved(input_code_parse("escape")));
    assert_true(keys_reserved(input_code_parse("pad2.guide")));
    assert_false(keys_reserved(input_code_parse("pad.start")));
    assert_false(keys_reserved(input_code_parse("alt+escape")));
}

/* ---- the settings file ---- */

TEST(a_settings_file)
{
    static const char text[] =
        "# mine\n\n scale=3\r\nvolume = 40 # quiet\nmute = yes\np1.fire =  space\tpad.l2  \nscale = 5\n"
        "dim = half\nflashes = soft\ncolours = tritan\nhitbox = yes\nautofire = yes\nfocus2 = toggle\n"
        "one_hand = right\none_hand2 = left\nturn = over\nscaling = smooth\nborder = no\npanels = beside";
    struct config c;

    config_defaults(&c);
    assert_true(c.rotation == ROTATION_NONE && c.scaling == SCALING_INTEGER && c.panels == PANELS_OVER);
    assert_true(!c.crt && c.border && c.vsync && !c.run_ahead && c.volume == 100);
    assert_true(config_read(&c, "x.conf", text, sizeof text - 1, err, sizeof err));
    assert_true(c.scale == 5 && c.volume == 40 && c.mute == 1 && c.fullscreen == 0);
    assert_true(c.autofire[0] && !c.autofire[1] && !c.focus[0] && c.focus[1]);
    assert_true(c.one_hand[0] == HAND_RIGHT && c.one_hand[1] == HAND_LEFT);
    assert_true(c.dim == VIEW_DIM_HALF && c.flashes == 1 && c.colours == COLOUR_BLIND_TRITAN && c.hitbox == 1);
    assert_true(c.rotation == ROTATION_180 && c.scaling == SCALING_SMOOTH && c.panels == PANELS_BESIDE && !c.border);
    k = c.keys;
    list_is("p1.fire", "space pad.l2");
}

static void refuse(const char *text, size_t n, const char *want)
{
    struct config c, before;

    config_defaults(&c);
    before = c;
    assert_false(config_read(&c, "x.conf", text, n, err, sizeof err));
    assert_string_equal(err, want);
    assert_memory_equal(&c, &before, sizeof c);
}

TEST(bad_settings)
{
    static const struct {
        const char *text, *want;
    } rows[] = {
        { "volume = 5\nscael = 3\n", "x.conf:2: unknown setting \"scael\"" },
        { "volume = 101", "x.conf:1: volume: expected a number from 0 to 100, got \"101\"" },
        { "\n\nscale = 2x", "x.conf:3: scale: expected a number from 0 to 16, got \"2x\"" },
        { "scale =", "x.conf:1: scale: expected a number from 0 to 16, got \"\"" },
        { "dim = 2", "x.conf:1: dim: expected none, quarter, half or most, got \"2\"" },
        { "colours = Protan", "x.conf:1: colours: expected normal, protan, deutan or tritan, got \"Protan\"" },
        { "mute = 1", "x.conf:1: mute: expected yes or no, got \"1\"" },
        { "hello", "x.conf:1: expected name = value, got \"hello\"" },
        { "= 4", "x.conf:1: unknown setting \"\"" },
        { "p1.fire = q qq", "x.conf:1: p1.fire: unknown key or button \"qq\"" },
    };
    char longline[CONFIG_LINE + 8];

    for (size_t i = 0; i < sizeof rows / sizeof *rows; i++)
        refuse(rows[i].text, strlen(rows[i].text), rows[i].want);
    refuse("mute = yes\nvol\0ume = 1", 22, "x.conf:2: expected a line of text");
    memset(longline, 'a', sizeof longline);
    refuse(longline, sizeof longline, "x.conf:1: expected a line of text");
}

static int lines;

static void count_line(const char *line)
{
    assert_true(strlen(line) < 120);
    lines++;
}

TEST(help_has_them_all)
{
    int settings = 0;

    while (config_setting(settings))
        settings++;
    keys_print_help(0, count_line);
    config_help(count_line);
    assert_int_equal(lines, KEYS_ACTIONS + settings + 2); /* and the language and the switches */
}

RUN_TESTS_EACH(setup, NULL)
