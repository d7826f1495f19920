/* test_keys.c - the key map, its names, chords, and the settings file that changes it. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <string.h>
#include <cmocka.h>
#include "../../src/cab/host/config.h"
#include "../../src/cab/picture/quarter.h"

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

/* The pads a single key makes, player 2 in the upper half. */
static uint32_t of_key(unsigned usage)
{
    struct keys k;
    struct keys_read r;
    struct plat_input in = { 0 };
    keys_defaults(&k);
    press(&in, usage);
    keys_read(&k, &in, &r);
    return r.pads[0] | (uint32_t)r.pads[1] << 16;
}

static void every_action_has_a_switch(void **state)
{
    struct keys k;
    (void)state;
    keys_defaults(&k);
    for (int i = 0; i < KEYS_ACTIONS; i++)
        assert_int_not_equal(k.code[i][0], 0);
}

static void no_key_means_two_things(void **state)
{
    (void)state;
    for (unsigned u = 4; u < 256; u++) {
        uint32_t pads = of_key(u);
        assert_true((pads & (pads - 1)) == 0);
    }
}

static void standard_keys(void **state)
{
    (void)state;
    assert_int_equal(of_key(82), PAD_UP);
    assert_int_equal(of_key(81), PAD_DOWN);
    assert_int_equal(of_key(80), PAD_LEFT);
    assert_int_equal(of_key(79), PAD_RIGHT);
    assert_int_equal(of_key(29), PAD_FIRE);
    assert_int_equal(of_key(27), PAD_BOMB);
    assert_int_equal(of_key(225), PAD_FOCUS);
    assert_int_equal(of_key(6), PAD_SPECIAL);
    assert_int_equal(of_key(40), PAD_START);
    assert_int_equal(of_key(42), 0); /* backspace: the cabinet's */
    assert_int_equal(of_key(43), PAD_SELECT);
    assert_int_equal(of_key(26), (uint32_t)PAD_UP << 16);
    assert_int_equal(of_key(98), (uint32_t)PAD_FIRE << 16);
    assert_int_equal(of_key(16), 0); /* m: the cabinet's */
}

static void controllers_are_the_players(void **state)
{
    struct keys k;
    struct keys_read r;
    struct plat_input in = { .controllers = { 1u << PLAT_SOUTH, 1u << PLAT_LEFT_UP } };
    (void)state;
    keys_defaults(&k);
    keys_read(&k, &in, &r);
    assert_int_equal(r.pads[0], PAD_FIRE);
    assert_int_equal(r.pads[1], PAD_UP);
    assert_true(keys_bind(&k, "p1.fire", "pad2.lup", err, sizeof err));
    assert_true(keys_bind(&k, "pause", "pad.south", err, sizeof err));
    keys_read(&k, &in, &r);
    assert_int_equal(r.pads[0], PAD_FIRE);
    assert_int_equal(r.held, 1u << CAB_PAUSE);
    in.controllers[1] = 0;
    keys_read(&k, &in, &r);
    assert_int_equal(r.pads[0], 0);
}

static void a_chord_eats_its_key(void **state)
{
    struct keys k;
    struct keys_read r;
    struct plat_input in = { 0 };
    (void)state;
    keys_defaults(&k);
    press(&in, 230);
    press(&in, 40);
    keys_read(&k, &in, &r);
    assert_int_equal(r.pressed, 1u << CAB_FULLSCREEN);
    assert_int_equal(r.pads[0], 0);
    release(&in, 230); /* Alt let go first: Enter is still not Start */
    keys_read(&k, &in, &r);
    assert_int_equal(r.held, 0);
    assert_int_equal(r.pads[0], 0);
    release(&in, 40);
    keys_read(&k, &in, &r);
    press(&in, 40);
    keys_read(&k, &in, &r);
    assert_int_equal(r.pads[0], PAD_START);
}

static void pressed_is_once(void **state)
{
    struct keys k;
    struct keys_read r;
    struct plat_input in = { 0 };
    (void)state;
    keys_defaults(&k);
    press(&in, 19);
    press(&in, 29);
    keys_read(&k, &in, &r);
    assert_int_equal(r.pressed, 1u << CAB_PAUSE);
    assert_true(r.fresh);
    keys_read(&k, &in, &r);
    assert_int_equal(r.held, 1u << CAB_PAUSE);
    assert_int_equal(r.pressed, 0);
    assert_false(r.fresh);
    press(&in, 80);
    keys_read(&k, &in, &r);
    assert_true(r.fresh);
}

static void bad_bindings_change_nothing(void **state)
{
    struct keys k, was;
    (void)state;
    keys_defaults(&k);
    was = k;
    assert_false(keys_bind(&k, "p3.fire", "z", err, sizeof err));
    assert_string_equal(err, "no action is called \"p3.fire\"");
    static const char *const bad[] = { "zz",
                                       "f13",
                                       "f0",
                                       "kp10",
                                       "key3",
                                       "key256",
                                       "pad.",
                                       "pad3.south",
                                       "pad",
                                       "alt+",
                                       "alt+pad.south",
                                       "Z",
                                       "f1x",
                                       "ctrl",
                                       "z,x",
                                       "none z",
                                       "averyveryveryveryveryverylongwordindeed" };
    for (size_t i = 0; i < sizeof bad / sizeof *bad; i++) {
        assert_false(keys_bind(&k, "p1.fire", bad[i], err, sizeof err));
        assert_memory_equal(&k, &was, sizeof k);
    }
    assert_true(keys_bind(&k, "p1.fire", "a b c d e f", err, sizeof err));
    assert_false(keys_bind(&k, "p1.fire", "a b c d e f g", err, sizeof err));
    assert_string_equal(err, "p1.fire: \"g\" is one switch too many");
    assert_true(keys_bind(&k, "p1.fire", "none", err, sizeof err));
    assert_int_equal(k.code[4][0], 0);
}

static void a_settings_file(void **state)
{
    static const char text[] =
        "# mine\n\n scale=3\r\nvolume = 40 # quiet\nmute = yes\np1.fire =  space\tpad.l2  \nscale = 5";
    struct config c;
    (void)state;
    config_defaults(&c);
    assert_int_equal(c.volume, 100);
    assert_true(config_read(&c, "x.conf", text, sizeof text - 1, err, sizeof err));
    assert_int_equal(c.scale, 5);
    assert_int_equal(c.volume, 40);
    assert_int_equal(c.mute, 1);
    assert_int_equal(c.fullscreen, 0);
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

static void settings_of_the_window(void **state)
{
    static const char text[] = "turn = over\nscaling = smooth\ncrt = yes\nborder = no\nvsync = no\nrun_ahead = 1\n"
                               "panels = beside\n";
    struct config c;
    (void)state;
    config_defaults(&c);
    assert_true(c.turn == QUARTER_NONE && c.scaling == SCALING_WHOLE && c.panels == PANELS_OVER);
    assert_true(!c.crt && c.border && c.vsync && !c.run_ahead);
    assert_true(config_read(&c, "x.conf", text, sizeof text - 1, err, sizeof err));
    assert_true(c.turn == QUARTER_OVER && c.scaling == SCALING_SMOOTH && c.panels == PANELS_BESIDE);
    assert_true(c.crt && !c.border && !c.vsync && c.run_ahead);
    assert_true(config_read(&c, "x.conf", "turn = left", 11, err, sizeof err));
    assert_int_equal(c.turn, QUARTER_LEFT);
    assert_true(config_read(&c, "x.conf", "turn = right", 12, err, sizeof err));
    assert_int_equal(c.turn, QUARTER_RIGHT);
}

static void bad_settings(void **state)
{
    char longline[CONFIG_LINE + 8];
    (void)state;
#define REFUSE(text, want) refuse(text, sizeof text - 1, want)
    REFUSE("volume = 5\nscael = 3\n", "x.conf:2: no setting is called \"scael\"");
    REFUSE("volume = 101", "x.conf:1: volume: expected a number from 0 to 100, got \"101\"");
    REFUSE("\n\nscale = 2x", "x.conf:3: scale: expected a number from 0 to 16, got \"2x\"");
    REFUSE("scale =", "x.conf:1: scale: expected a number from 0 to 16, got \"\"");
    REFUSE("mute = 1", "x.conf:1: mute: expected yes or no, got \"1\"");
    REFUSE("turn = up", "x.conf:1: turn: expected none, left, right or over, got \"up\"");
    REFUSE("panels = 1", "x.conf:1: panels: expected over or beside, got \"1\"");
    REFUSE("run_ahead = 2", "x.conf:1: run_ahead: expected a number from 0 to 1, got \"2\"");
    REFUSE("hello", "x.conf:1: expected name = value, got \"hello\"");
    REFUSE("= 4", "x.conf:1: no setting is called \"\"");
    REFUSE("p1.fire = q qq", "x.conf:1: p1.fire: no switch is called \"qq\"");
    REFUSE("mute = yes\nvol\0ume = 1", "x.conf:2: not a line of text");
    memset(longline, 'a', sizeof longline);
    refuse(longline, sizeof longline, "x.conf:1: not a line of text");
}

/* The first switch of an action, as it would be written. */
static void first_switch(void **state)
{
    static const char *const words[] = { "a",         "z",         "1",         "9",         "0",
                                         "f1",        "f12",       "kp1",       "kp5",       "kp9",
                                         "kp0",       "kp.",       "enter",     "rgui",      "up",
                                         "key4",      "pad.south", "pad.start", "pad1.east", "pad2.right",
                                         "alt+enter", "key100",    "ctrl+q",    "space",     "none" };
    struct keys k;
    char name[32];

    (void)state;
    keys_defaults(&k);
    keys_first(&k, "p1.start", name, sizeof name);
    assert_string_equal(name, "enter");
    for (size_t i = 0; i < sizeof words / sizeof *words; i++) {
        assert_true(keys_bind(&k, "p2.bomb", words[i], err, sizeof err));
        keys_first(&k, "p2.bomb", name, sizeof name);
        assert_string_equal(name, strcmp(words[i], "key4") ? words[i] : "a");
    }
    assert_true(keys_bind(&k, "p2.bomb", "kp3 x", err, sizeof err));
    keys_first(&k, "p2.bomb", name, 3);
    assert_string_equal(name, "kp");
}

static void count_line(const char *line)
{
    assert_true(strlen(line) < 120);
    lines++;
}

static void help_has_them_all(void **state)
{
    (void)state;
    lines = 0;
    keys_help(count_line);
    assert_int_equal(lines, KEYS_ACTIONS);
    config_help(count_line);
    assert_int_equal(lines, KEYS_ACTIONS + 13);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(every_action_has_a_switch),
        cmocka_unit_test(no_key_means_two_things),
        cmocka_unit_test(standard_keys),
        cmocka_unit_test(controllers_are_the_players),
        cmocka_unit_test(a_chord_eats_its_key),
        cmocka_unit_test(pressed_is_once),
        cmocka_unit_test(bad_bindings_change_nothing),
        cmocka_unit_test(a_settings_file),
        cmocka_unit_test(settings_of_the_window),
        cmocka_unit_test(bad_settings),
        cmocka_unit_test(help_has_them_all),
        cmocka_unit_test(first_switch),
    };
    return cmocka_run_group_tests(tests, 0, 0);
}
