/* test_pad_modes.c - sequences of held buttons, and the pads computed from them. */
#include "../test.h"
#include "../../src/base/rng.h"
#include "../../src/player/input/pad_modes.h"

static const struct pad_modes off, autofire = { .autofire = true }, toggle = { .toggle_focus = true },
                                   one_hand = { .one_hand = true };
static const struct pad_modes_control flies = { true, true };
static struct pad_mode_state p;

/* What is held and what comes out, a letter a tick: F fire, f focus, L left, . nothing, * fire and left, + fire and
 * focus. Before a tick: a blank, when the buttons are a menu's, or _, when fire is a talk's. */
static const char letters[] = "FfL*+.";
static const uint16_t pads[] = { PAD_FIRE, PAD_FOCUS, PAD_LEFT, PAD_FIRE | PAD_LEFT, PAD_FIRE | PAD_FOCUS, 0 };

static void ticks(const struct pad_modes *modes, const char *held, const char *want)
{
    char got[128] = "";

    for (size_t n = 0; *held; held++, n++) {
        const struct pad_modes_control control = { *held != ' ', *held != ' ' && *held != '_' };
        held += !control.can_fire;
        const uint16_t out = pad_modes_tick(&p, modes, control, pads[strchr(letters, *held) - letters]);
        for (size_t k = 0; k < sizeof pads / sizeof *pads; k++)
            if (pads[k] == out)
                got[n] = letters[k];
    }
    assert_string_equal(got, want);
}

static void power(void)
{
    pad_modes_resume(&p, 0);
    pad_modes_tick(&p, &off, flies, 0);
}

/* With everything off the pads are what is held, whatever went before. */
TEST(off_is_off)
{
    struct rng r;

    rng_seed(&r, 7);
    for (int i = 0; i < 20000; i++) {
        uint64_t n = rng_next(&r);
        uint16_t held = (uint16_t)(n & PAD_ALL);
        if (n >> 20 & 1)
            pad_modes_resume(&p, (uint16_t)(n >> 32 & PAD_ALL));
        assert_int_equal(pad_modes_tick(&p, &off, (struct pad_modes_control){ n >> 21 & 1, n >> 22 & 1 }, held), held);
    }
}

/* A mode touches its own button alone, and nothing when the player does not play. */
TEST(no_other_button_changes)
{
    struct rng r;

    rng_seed(&r, 8);
    power();
    for (int i = 0; i < 20000; i++) {
        uint64_t n = rng_next(&r);
        uint16_t held = (uint16_t)(n & PAD_ALL);
        const struct pad_modes_control control = { n >> 25 & 3, n >> 20 & 3 };
        struct pad_modes modes = { n >> 22 & 1, n >> 23 & 1, n >> 24 & 1 };
        unsigned may = (control.can_fire && (modes.autofire || modes.one_hand) ? PAD_FIRE : 0u) |
                       (control.can_steer && modes.toggle_focus ? PAD_FOCUS : 0u);
        uint16_t got = pad_modes_tick(&p, &modes, control, held);
        assert_int_equal((unsigned)(got ^ held) & ~may, 0);
    }
}

TEST(fire_in_bursts)
{
    power();
    ticks(&autofire, "..FFFFFFFFFF..F..FFFFF", "..FF..FF..FF..F..FF..F");
    /* Focus comes and goes meanwhile. */
    ticks(&autofire, ".FF++++FF", ".FFff++..");
    /* A tick that the game stands for is not counted; its menu sees what is held. */
    ticks(&autofire, ".FFF F F F F FFF", ".FF.FFFFFFF");
}

TEST(focus_is_switched)
{
    power();
    ticks(&toggle, ".f..f..f.F.fff.", ".fff...ff+f....");
    /* A pause menu has focus as a button, and afterwards it is as it was: a press there is no switch. */
    ticks(&toggle, ".f. f . f . .", ".fff.f..");
    ticks(&toggle, "..f.", "ff..");
    /* In a talk the ship steers on. */
    ticks(&toggle, ".f._._._f_._F..", ".ffff..F..");
}

TEST(focus_over_a_power_on)
{
    power();
    ticks(&toggle, ".f..", ".fff");
    pad_modes_resume(&p, 0); /* focus held through it: neither on nor a press */
    ticks(&toggle, "fff..f..", ".....fff");
}

/* Time is turned to where focus was on, or off. */
TEST(focus_over_a_rewind)
{
    power();
    ticks(&toggle, ".f..f..", ".fff...");
    pad_modes_resume(&p, PAD_FOCUS);
    ticks(&toggle, "...f.", "fff..");
    pad_modes_resume(&p, PAD_FIRE);
    ticks(&toggle, "..f", "..f");
}

TEST(fire_holds_itself)
{
    power();
    /* From the first move on, also standing; a press of fire lets it go for a tick, and is then a press. */
    ticks(&one_hand, "..LL...FFF...L.", "..**FFF.FF...*F");
    /* Moving on while fire is held: when it is let go, fire holds itself again. */
    ticks(&one_hand, "..**LL..", "FFL***FF");
    /* In a menu nothing is held; the first move after it holds again. */
    ticks(&one_hand, ". L . L..L", "FL.L..*");
    ticks(&one_hand, "._L_._F_._L.L", "FL.F.L.*");
}

TEST(one_hand_in_bursts)
{
    const struct pad_modes both = { .autofire = true, .one_hand = true };

    power();
    ticks(&both, ".L......", ".*F..FF.");
}

/* A late frame gives the same buttons to several ticks: nothing is switched twice, and bursts go on in ticks. */
TEST(several_ticks_a_poll)
{
    static const struct pad_modes all = { true, true, true };
    uint16_t got[6];

    power();
    for (int i = 0; i < 6; i++)
        got[i] = pad_modes_tick(&p, &all, flies, PAD_FOCUS | PAD_FIRE);
    for (int i = 0; i < 6; i++)
        assert_int_equal(got[i], i % 4 < 2 ? PAD_FOCUS | PAD_FIRE : PAD_FOCUS);
}

RUN_TESTS(NULL, NULL)
