/* test_keys.c - the key map, its names, chords, and the settings file that changes it. */
#include "../test.h"
#include "../../src/board/board.h"
#include "../../src/player/settings/config.h"
#include "../../src/player/picture/rotation.h"

static char err[256];
static int lines;

static void press(struct plat_input *in, unsigned usage)
{
    in->keys[usage >> 3] = (uint8_t)(in->keys[usage >> 3] | 1u << (usage & 7));
}

static void release(struct plat_input *in, unsigned usage)
{
    in->keys[usage >> 3] = (uint8_t)(in->keys[usage >> 3] & ~(1u << (usage & 7)));
}

/* A poll with the first controller player 1's and the second player 2's. */
static void read_keys(struct keys *k, const struct plat_input *in, struct keys_state *out)
{
    struct controllers controllers;

    controllers_open(&controllers);
    memcpy(controllers.buttons, in->controllers, sizeof controllers.buttons);
    for (int p = 0; p < MAX_PLAYERS; p++)
        controllers.controller_of[p] = p;
    controllers.info[0].kind = PLAT_PS4;
    controllers.info[1].kind = PLAT_NINTENDO;
    keys_read(k, in, &controllers, out);
}

/* The pads a single key makes, player 2 in the upper half. */
static uint32_t of_key(unsigned usage)
{
    struct keys k;
    struct keys_state r;
    struct plat_input in = { 0 };
    keys_set_defaults(&k);
    press(&in, usage);
    read_keys(&k, &in, &r);
    return r.pads[0] | (uint32_t)r.pads[1] << 16;
}

TEST(every_action_has_an_input)
{
    struct keys k;
    keys_set_defaults(&k);
    for (int i = 0; i < KEYS_ACTIONS; i++)
        assert_int_not_equal(k.code[i][0], 0);
}

TEST(no_key_means_two_things)
{
    for (unsigned u = 4; u < 256; u++) {
        uint32_t pads = of_key(u);
        assert_true((pads & (pads - 1)) == 0);
    }
}

TEST(standard_keys)
{
    assert_int_equal(of_key(82), PAD_UP);
    assert_int_equal(of_key(81), PAD_DOWN);
    assert_int_equal(of_key(80), PAD_LEFT);
    assert_int_equal(of_key(79), PAD_RIGHT);
    assert_int_equal(of_key(29), PAD_FIRE);
    assert_int_equal(of_key(27), PAD_BOMB);
    assert_int_equal(of_key(225), PAD_FOCUS);
    assert_int_equal(of_key(6), PAD_SPECIAL);
    assert_int_equal(of_key(40), PAD_START);
    assert_int_equal(of_key(42), 0); /* backspace: the program's */
    assert_int_equal(of_key(43), PAD_SELECT);
    assert_int_equal(of_key(26), (uint32_t)PAD_UP << 16);
    assert_int_equal(of_key(98), (uint32_t)PAD_FIRE << 16);
    assert_int_equal(of_key(16), 0); /* m: the program's */
}

TEST(controllers_are_the_players)
{
    struct keys k;
    struct keys_state r;
    struct plat_input in = { .controllers = { 1u << PLAT_SOUTH, 1u << PLAT_LEFT_STICK_UP } };
    keys_set_defaults(&k);
    read_keys(&k, &in, &r);
    assert_int_equal(r.pads[0], PAD_FIRE);
    assert_int_equal(r.pads[1], PAD_UP);
    assert_true(keys_bind(&k, "p1.fire", "pad2.lup", err, sizeof err));
    assert_true(keys_bind(&k, "pause", "pad.south", err, sizeof err));
    read_keys(&k, &in, &r);
    assert_int_equal(r.pads[0], PAD_FIRE);
    assert_int_equal(r.held, 1u << HOTKEY_PAUSE);
    in.controllers[1] = 0;
    read_keys(&k, &in, &r);
    assert_int_equal(r.pads[0], 0);
}

TEST(a_chord_eats_its_key)
{
    struct keys k;
    struct keys_state r;
    struct plat_input in = { 0 };
    keys_set_defaults(&k);
    press(&in, 230);
    press(&in, 40);
    read_keys(&k, &in, &r);
    assert_int_equal(r.pressed, 1u << HOTKEY_FULLSCREEN);
    assert_int_equal(r.pads[0], 0);
    release(&in, 230); /* Alt let go first: Enter is still not Start */
    read_keys(&k, &in, &r);
    assert_int_equal(r.pressed, 0);
    assert_int_equal(r.pads[0], 0);
    read_keys(&k, &in, &r);
    assert_int_equal(r.held, 0);
    assert_int_equal(r.pads[0], 0);
    release(&in, 40);
    read_keys(&k, &in, &r);
    press(&in, 40);
    read_keys(&k, &in, &r);
    assert_int_equal(r.pads[0], PAD_START);
}

TEST(pressed_is_once)
{
    struct keys k;
    struct keys_state r;
    struct plat_input in = { 0 };
    keys_set_defaults(&k);
    press(&in, 19);
    press(&in, 29);
    read_keys(&k, &in, &r);
    assert_int_equal(r.pressed, 1u << HOTKEY_PAUSE);
    assert_true(r.any_pad_pressed);
    read_keys(&k, &in, &r);
    assert_int_equal(r.held, 1u << HOTKEY_PAUSE);
    assert_int_equal(r.pressed, 0);
    assert_false(r.any_pad_pressed);
    press(&in, 80);
    read_keys(&k, &in, &r);
    assert_true(r.any_pad_pressed);
}

TEST(bad_bindings_change_nothing)
{
    struct keys k, was;
    keys_set_defaults(&k);
    was = k;
    assert_false(keys_bind(&k, "p3.fire", "z", err, sizeof err));
    assert_string_equal(err, "unknown action \"p3.fire\"");
    static const char *const bad[] = {
        "zz",   "f13",        "f0",         "kp10", "key3",   "key256",
        "pad.", "pad5.south", "pad0.south", "pad",  "alt+",   "alt+pad.south",
        "Z",    "f1x",        "ctrl",       "z,x",  "none z", "averyveryveryveryveryverylongwordindeed"
    };
    for (size_t i = 0; i < sizeof bad / sizeof *bad; i++) {
        assert_false(keys_bind(&k, "p1.fire", bad[i], err, sizeof err));
        assert_memory_equal(&k, &was, sizeof k);
    }
    assert_true(keys_bind(&k, "p1.fire", "a b c d e f", err, sizeof err));
    assert_false(keys_bind(&k, "p1.fire", "a b c d e f g", err, sizeof err));
    assert_string_equal(err, "p1.fire: expected at most six keys and buttons; remove \"g\"");
    assert_true(keys_bind(&k, "p1.fire", "none", err, sizeof err));
    assert_int_equal(k.code[4][0], 0);
}

TEST(a_settings_file)
{
    static const char text[] =
        "# mine\n\n scale=3\r\nvolume = 40 # quiet\nmute = yes\np1.fire =  space\tpad.l2  \nscale = 5\n"
        "dim = half\nflashes = soft\ncolours = tritan\nhitbox = yes";
    struct config c;
    config_defaults(&c);
    assert_int_equal(c.volume, 100);
    assert_true(config_read(&c, "x.conf", text, sizeof text - 1, err, sizeof err));
    assert_int_equal(c.scale, 5);
    assert_int_equal(c.volume, 40);
    assert_int_equal(c.mute, 1);
    assert_int_equal(c.fullscreen, 0);
    static const char pressing[] = "autofire = yes\nfocus2 = toggle\none_hand = right\none_hand2 = left";
    assert_true(config_read(&c, "x.conf", pressing, sizeof pressing - 1, err, sizeof err));
    assert_int_equal(c.autofire[0], 1);
    assert_int_equal(c.autofire[1], 0);
    assert_int_equal(c.focus[0], 0);
    assert_int_equal(c.focus[1], 1);
    assert_int_equal(c.one_hand[0], HAND_RIGHT);
    assert_int_equal(c.one_hand[1], HAND_LEFT);
    assert_int_equal(c.dim, VIEW_DIM_HALF);
    assert_int_equal(c.flashes, 1);
    assert_int_equal(c.colours, COLOUR_BLIND_TRITAN);
    assert_int_equal(c.hitbox, 1);
    assert_int_equal(c.keys.code[4][0], 44);
    assert_int_equal(c.keys.code[4][1], 0x100 | PLAT_TRIGGER_LEFT);
    assert_int_equal(c.keys.code[4][2], 0);
}

static void refuse(const char *text, size_t n, const char *want)
{
    struct config c, was;
    config_defaults(&c);
    was = c;
    assert_false(config_read(&c, "x.conf", text, n, err, sizeof err));
    assert_string_equal(err, want);
    assert_memory_equal(&c, &was, sizeof c);
}

TEST(settings_of_the_window)
{
    static const char text[] = "turn = over\nscaling = smooth\ncrt = yes\nborder = no\nvsync = no\nrun_ahead = 1\n"
                               "panels = beside\n";
    struct config c;
    config_defaults(&c);
    assert_true(c.rotation == ROTATION_NONE && c.scaling == SCALING_INTEGER && c.panels == PANELS_OVER);
    assert_true(!c.crt && c.border && c.vsync && !c.run_ahead);
    assert_true(config_read(&c, "x.conf", text, sizeof text - 1, err, sizeof err));
    assert_true(c.rotation == ROTATION_180 && c.scaling == SCALING_SMOOTH && c.panels == PANELS_BESIDE);
    assert_true(c.crt && !c.border && !c.vsync && c.run_ahead);
    assert_true(config_read(&c, "x.conf", "turn = left", 11, err, sizeof err));
    assert_int_equal(c.rotation, ROTATION_LEFT);
    assert_true(config_read(&c, "x.conf", "turn = right", 12, err, sizeof err));
    assert_int_equal(c.rotation, ROTATION_RIGHT);
}

TEST(bad_settings)
{
    char longline[CONFIG_LINE + 8];
#define REFUSE(text, want) refuse(text, sizeof text - 1, want)
    REFUSE("volume = 5\nscael = 3\n", "x.conf:2: unknown setting \"scael\"");
    REFUSE("volume = 101", "x.conf:1: volume: expected a number from 0 to 100, got \"101\"");
    REFUSE("\n\nscale = 2x", "x.conf:3: scale: expected a number from 0 to 16, got \"2x\"");
    REFUSE("scale =", "x.conf:1: scale: expected a number from 0 to 16, got \"\"");
    REFUSE("dim = 2", "x.conf:1: dim: expected none, quarter, half or most, got \"2\"");
    REFUSE("dim = half\nflashes =", "x.conf:2: flashes: expected full or soft, got \"\"");
    REFUSE("colours = Protan", "x.conf:1: colours: expected normal, protan, deutan or tritan, got \"Protan\"");
    REFUSE("hitbox = always", "x.conf:1: hitbox: expected yes or no, got \"always\"");
    REFUSE("mute = 1", "x.conf:1: mute: expected yes or no, got \"1\"");
    REFUSE("focus = held", "x.conf:1: focus: expected hold or toggle, got \"held\"");
    REFUSE("one_hand2 = yes", "x.conf:1: one_hand2: expected no, left or right, got \"yes\"");
    REFUSE("turn = up", "x.conf:1: turn: expected none, left, right or over, got \"up\"");
    REFUSE("panels = 1", "x.conf:1: panels: expected over or beside, got \"1\"");
    REFUSE("run_ahead = 2", "x.conf:1: run_ahead: expected a number from 0 to 1, got \"2\"");
    REFUSE("hello", "x.conf:1: expected name = value, got \"hello\"");
    REFUSE("= 4", "x.conf:1: unknown setting \"\"");
    REFUSE("p1.fire = q qq", "x.conf:1: p1.fire: unknown key or button \"qq\"");
    REFUSE("mute = yes\nvol\0ume = 1", "x.conf:2: expected a line of text");
    memset(longline, 'a', sizeof longline);
    refuse(longline, sizeof longline, "x.conf:1: expected a line of text");
}

/* The first input of an action, as it would be written. */
TEST(first_input)
{
    static const char *const words[] = { "a",         "z",         "1",         "9",         "0",
                                         "f1",        "f12",       "kp1",       "kp5",       "kp9",
                                         "kp0",       "kp.",       "enter",     "rgui",      "up",
                                         "key4",      "pad.south", "pad.start", "pad1.east", "pad4.right",
                                         "alt+enter", "key100",    "ctrl+q",    "space",     "none" };
    struct keys k;
    char name[32];

    keys_set_defaults(&k);
    keys_hint(&k, "p1.start", name, sizeof name);
    assert_string_equal(name, "enter");
    for (size_t i = 0; i < sizeof words / sizeof *words; i++) {
        assert_true(keys_bind(&k, "p2.bomb", words[i], err, sizeof err));
        keys_hint(&k, "p2.bomb", name, sizeof name);
        assert_string_equal(name, strcmp(words[i], "key4") ? words[i] : "a");
    }
    assert_true(keys_bind(&k, "p2.bomb", "kp3 x", err, sizeof err));
    keys_hint(&k, "p2.bomb", name, 3);
    assert_string_equal(name, "kp");
}

/* What a hint names follows what its player pressed last. */
TEST(hints_name_what_is_used)
{
    struct keys k;
    struct keys_state r;
    struct plat_input in = { 0 };
    char name[INPUT_CODE_NAME_SIZE];

    keys_set_defaults(&k);
    in.controllers[0] = 1u << PLAT_LEFT_STICK_UP;
    read_keys(&k, &in, &r);
    keys_hint(&k, "p1.fire", name, sizeof name);
    assert_string_equal(name, "cross");
    keys_hint(&k, "p1.start", name, sizeof name);
    assert_string_equal(name, "Options");
    keys_hint(&k, "p2.fire", name, sizeof name);
    assert_string_equal(name, "j");
    in.controllers[1] = 1u << PLAT_EAST;
    read_keys(&k, &in, &r);
    keys_hint(&k, "p2.bomb", name, sizeof name);
    assert_string_equal(name, "A");
    keys_bind(&k, "silence", "m pad.north", err, sizeof err);
    keys_hint(&k, "silence", name, sizeof name);
    assert_string_equal(name, "X");
    press(&in, 29); /* the controllers are still held: what is new counts */
    read_keys(&k, &in, &r);
    keys_hint(&k, "p1.fire", name, sizeof name);
    assert_string_equal(name, "z");
    keys_hint(&k, "silence", name, sizeof name);
    assert_string_equal(name, "m");
    keys_hint(&k, "p2.fire", name, sizeof name);
    assert_string_equal(name, "B");
    in.controllers[0] = 1u << PLAT_SOUTH; /* and it is used again */
    read_keys(&k, &in, &r);
    assert_int_equal(r.pads_pressed[0], 0); /* z holds fire already */
    keys_hint(&k, "p1.focus", name, sizeof name);
    assert_string_equal(name, "R1");
    keys_bind(&k, "p1.focus", "q", err, sizeof err);
    keys_hint(&k, "p1.focus", name, sizeof name);
    assert_string_equal(name, "q");
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
    struct keys k;
    char name[INPUT_CODE_NAME_SIZE];

    keys_set_defaults(&k);
    layout[29] = "W", layout[54] = ";", layout[31] = "\u00e9", layout[27] = "\u0447", layout[20] = "A";
    keys_hint(&k, "p1.fire", name, sizeof name);
    assert_string_equal(name, "w");
    keys_hint(&k, "slow", name, sizeof name); /* ; is where a US keyboard has the comma */
    assert_string_equal(name, "semicolon");
    keys_hint(&k, "p2.start", name, sizeof name);
    assert_string_equal(name, "\u00e9");
    keys_hint(&k, "p1.bomb", name, sizeof name); /* no picture of this letter */
    assert_string_equal(name, "x");
    keys_hint(&k, "quit", name, sizeof name);
    assert_string_equal(name, "ctrl+a");
    keys_hint(&k, "p1.start", name, sizeof name);
    assert_string_equal(name, "enter");
    keys_write_list(&k, "p1.fire", name, sizeof name);
    assert_string_equal(name, "z pad.south");
    memset(layout, 0, sizeof layout);
    keys_hint(&k, "p1.fire", name, sizeof name);
    assert_string_equal(name, "z");
}

/* All lists, as text, give the same codes again. */
TEST(lists_are_written_and_read)
{
    struct keys k, again;
    char text[KEYS_PER_ACTION * INPUT_CODE_NAME_SIZE];

    keys_set_defaults(&k);
    assert_true(keys_bind(&k, "step", "alt+kp. ctrl+key100 pad.lup pad4.rright f12 0", err, sizeof err));
    assert_true(keys_bind(&k, "slow", "none", err, sizeof err));
    keys_write_list(&k, "step", text, sizeof text);
    assert_string_equal(text, "alt+kp. ctrl+key100 pad.lup pad4.rright f12 0");
    keys_write_list(&k, "slow", text, sizeof text);
    assert_string_equal(text, "none");
    memset(&again, 0, sizeof again);
    for (int i = 0; i < KEYS_ACTIONS; i++) {
        keys_write_list(&k, keys_action_name(i), text, sizeof text);
        assert_true(keys_bind(&again, keys_action_name(i), text, err, sizeof err));
        assert_non_null(keys_action_help(i));
    }
    assert_memory_equal(k.code, again.code, sizeof k.code);
    keys_write_list(&k, "step", text, 6);
    assert_string_equal(text, "alt+k");
}

TEST(an_input_is_captured)
{
    struct keys_capture c;
    struct plat_input in = { 0 };

    press(&in, 40); /* the enter that chose the row */
    keys_capture_begin(&c, &in);
    assert_int_equal(keys_capture_poll(&c, &in), 0);
    release(&in, 40);
    assert_int_equal(keys_capture_poll(&c, &in), 0);
    press(&in, 40);
    assert_int_equal(keys_capture_poll(&c, &in), 40);
    release(&in, 40);
    keys_capture_poll(&c, &in);
    press(&in, 225); /* shift is a key as any other */
    assert_int_equal(keys_capture_poll(&c, &in), 225);
    release(&in, 225);
    press(&in, 226); /* alt waits for what comes with it */
    assert_int_equal(keys_capture_poll(&c, &in), 0);
    press(&in, 40);
    assert_int_equal(keys_capture_poll(&c, &in), input_code_parse("alt+enter"));
    keys_capture_begin(&c, &in);
    release(&in, 226);
    release(&in, 40);
    press(&in, 228);
    assert_int_equal(keys_capture_poll(&c, &in), 0);
    press(&in, 20);
    assert_int_equal(keys_capture_poll(&c, &in), input_code_parse("ctrl+q"));
    release(&in, 228);
    release(&in, 20);
    keys_capture_begin(&c, &in);
    press(&in, 230);
    assert_int_equal(keys_capture_poll(&c, &in), 0);
    release(&in, 230); /* and is itself when nothing does */
    assert_int_equal(keys_capture_poll(&c, &in), 230);
    keys_capture_begin(&c, &in);
    in.controllers[3] = 1u << PLAT_LEFT_STICK_PRESS;
    assert_int_equal(keys_capture_poll(&c, &in), input_code_parse("pad.l3"));
    assert_int_equal(keys_capture_poll(&c, &in), 0);
}

TEST(inputs_are_added_and_removed)
{
    struct keys k;
    char text[KEYS_PER_ACTION * INPUT_CODE_NAME_SIZE];

    keys_set_defaults(&k);
    assert_true(keys_add(&k, "p1.bomb", input_code_parse("q"), err, sizeof err));
    assert_true(keys_add(&k, "p1.bomb", input_code_parse("q"), err, sizeof err));
    keys_write_list(&k, "p1.bomb", text, sizeof text);
    assert_string_equal(text, "x pad.east q");
    keys_remove(&k, "p1.bomb", input_code_parse("pad.east"));
    keys_remove(&k, "p1.bomb", input_code_parse("f1"));
    keys_write_list(&k, "p1.bomb", text, sizeof text);
    assert_string_equal(text, "x q");
    assert_true(keys_bind(&k, "p1.bomb", "1 2 3 4 5 6", err, sizeof err));
    assert_true(keys_add(&k, "p1.bomb", input_code_parse("6"), err, sizeof err));
    assert_false(keys_add(&k, "p1.bomb", input_code_parse("7"), err, sizeof err));
    assert_string_equal(err, "Player 1 Bomb already has 6 keys, the maximum");
    for (int i = 1; i < 7; i++)
        keys_remove(&k, "p1.bomb", (uint16_t)(29 + i));
    keys_write_list(&k, "p1.bomb", text, sizeof text);
    assert_string_equal(text, "none");
}

static void conflict(const struct keys *k, const char *action, const char *name, const char *want)
{
    const char *got = keys_conflict(k, action, input_code_parse(name));

    if (!want)
        assert_null(got);
    else
        assert_string_equal(got, want);
}

TEST(conflicts_are_named)
{
    struct keys k;

    keys_set_defaults(&k);
    conflict(&k, "p1.bomb", "z", "p1.fire");
    conflict(&k, "p1.bomb", "x", NULL); /* its own */
    conflict(&k, "p1.bomb", "p", "pause");
    conflict(&k, "pause", "d", "p2.right");
    conflict(&k, "pause", "alt+d", NULL); /* a chord is another input */
    conflict(&k, "p1.bomb", "pad.south", "p1.fire");
    conflict(&k, "p1.bomb", "pad.north", NULL);
    conflict(&k, "pause", "pad.south", "p1.fire");    /* the program hears every controller */
    conflict(&k, "p1.bomb", "pad2.south", "p1.fire"); /* which may be player 1's */
    assert_true(keys_bind(&k, "p1.fire", "pad1.south", err, sizeof err));
    assert_true(keys_bind(&k, "p2.fire", "none", err, sizeof err));
    conflict(&k, "p1.bomb", "pad2.south", NULL);
    conflict(&k, "p2.bomb", "pad1.south", "p1.fire");
    keys_bind(&k, "p2.fire", "pad.north", err, sizeof err);
    conflict(&k, "p1.bomb", "pad.north", NULL); /* each of them has a controller */
    assert_true(keys_reserved(input_code_parse("escape")));
    assert_true(keys_reserved(input_code_parse("pad.guide")));
    assert_true(keys_reserved(input_code_parse("pad2.guide")));
    assert_false(keys_reserved(input_code_parse("pad.start")));
    assert_false(keys_reserved(input_code_parse("alt+escape")));
}

/* One hand: its inputs mean what its layout says, and the other player's keys among them nothing to them. */
TEST(a_hand_has_its_half)
{
    struct keys k;
    struct keys_state r;
    struct plat_input in = { 0 };
    char name[INPUT_CODE_NAME_SIZE];

    keys_set_defaults(&k);
    keys_set_hand(&k, 0, HAND_LEFT);
    press(&in, 26); /* w, player 2's up */
    press(&in, 44); /* space */
    in.controllers[0] = 1u << PLAT_SELECT;
    read_keys(&k, &in, &r);
    assert_int_equal(r.pads[0], PAD_UP | PAD_FIRE | PAD_START);
    assert_int_equal(r.pads[1], 0);
    keys_hint(&k, "p1.up", name, sizeof name);
    assert_string_equal(name, "w");
    memset(&in, 0, sizeof in);
    press(&in, 29); /* z is still there */
    in.controllers[0] = 1u << PLAT_LEFT_STICK_PRESS | 1u << PLAT_TRIGGER_LEFT;
    in.controllers[1] = 1u << PLAT_SELECT; /* player 2 has two hands */
    read_keys(&k, &in, &r);
    assert_int_equal(r.pads[0], PAD_FIRE | PAD_BOMB | PAD_FOCUS);
    assert_int_equal(r.pads[1], PAD_SELECT);
    keys_set_hand(&k, 0, HAND_RIGHT);
    memset(&in, 0, sizeof in);
    in.controllers[0] = 1u << PLAT_SHOULDER_RIGHT | 1u << PLAT_RIGHT_STICK_LEFT;
    press(&in, 98); /* kp0, player 2's fire */
    read_keys(&k, &in, &r);
    assert_int_equal(r.pads[0], PAD_FIRE | PAD_SPECIAL | PAD_LEFT);
    assert_int_equal(r.pads[1], 0);
    keys_set_hand(&k, 0, HAND_BOTH);
    read_keys(&k, &in, &r);
    assert_int_equal(r.pads[0], PAD_FOCUS);
    assert_int_equal(r.pads[1], PAD_FIRE);
}

/* Either hand reaches each button, on the keyboard and on a controller; select alone is missing on a controller. */
TEST(each_hand_reaches_everything)
{
    for (int hand = HAND_LEFT; hand <= HAND_RIGHT; hand++) {
        struct keys k;
        keys_set_defaults(&k);
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

TEST(labels)
{
    static const struct {
        const char *name, *label[PLAT_CONTROLLER_KINDS];
    } rows[] = {
        { "pad.south", { "bottom button", "A", "A", "cross", "cross", "cross", "B" } },
        { "pad2.east", { "right button", "B", "B", "circle", "circle", "circle", "A" } },
        { "pad.west", { "left button", "X", "X", "square", "square", "square", "Y" } },
        { "pad.north", { "top button", "Y", "Y", "triangle", "triangle", "triangle", "X" } },
        { "pad.r1", { "R1", "RB", "RB", "R1", "R1", "R1", "R" } },
        { "pad.l2", { "L2", "LT", "LT", "L2", "L2", "L2", "ZL" } },
        { "pad.start", { "Start", "Menu", "Start", "Start", "Options", "Options", "+" } },
        { "pad.select", { "Select", "View", "Back", "Select", "Share", "Create", "-" } },
        { "pad.guide", { "Guide", "Xbox", "Guide", "PS", "PS", "PS", "HOME" } },
        { "pad.lup", { "stick up", "stick up", "stick up", "stick up", "stick up", "stick up", "stick up" } },
        { "alt+enter", { "alt+enter", "alt+enter", "alt+enter", "alt+enter", "alt+enter", "alt+enter", "alt+enter" } },
    };
    char name[INPUT_CODE_NAME_SIZE];

    for (size_t i = 0; i < sizeof rows / sizeof *rows; i++) {
        for (int kind = 0; kind < PLAT_CONTROLLER_KINDS; kind++) {
            input_code_label(input_code_parse(rows[i].name), (enum plat_controller_kind)kind, name, sizeof name);
            assert_string_equal(name, rows[i].label[kind]);
        }
    }
    for (unsigned bit = 0; bit < PLAT_BUTTONS; bit++)
        for (int kind = 0; kind < PLAT_CONTROLLER_KINDS; kind++) {
            input_code_label(INPUT_CODE_CONTROLLER | bit, (enum plat_controller_kind)kind, name, sizeof name);
            assert_true(name[0]);
        }
}

static void count_line(const char *line)
{
    assert_true(strlen(line) < 120);
    lines++;
}

TEST(help_has_them_all)
{
    lines = 0;
    keys_print_help(0, count_line);
    assert_int_equal(lines, KEYS_ACTIONS);
    config_help(count_line);
    int settings = 0;
    while (config_setting(settings))
        settings++;
    assert_int_equal(lines, KEYS_ACTIONS + settings + 1); /* and the language */
}

/* Ctrl is read at one poll, q and its release at the next, when both are up. */
TEST(a_quick_chord)
{
    struct keys k;
    struct keys_state r;
    struct plat_input in = { 0 };

    keys_set_defaults(&k);
    press(&in, 224);
    read_keys(&k, &in, &r);
    release(&in, 224);
    press(&in, 20);
    read_keys(&k, &in, &r);
    assert_true(r.pressed & (uint32_t)1 << HOTKEY_QUIT);
    release(&in, 20);
    read_keys(&k, &in, &r);
    press(&in, 20);
    read_keys(&k, &in, &r);
    assert_false(r.pressed & (uint32_t)1 << HOTKEY_QUIT);
}

RUN_TESTS(NULL, NULL)
