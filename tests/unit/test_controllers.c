/* test_controllers.c - the assignment of controllers to players: plugging in, unplugging, START, reconnecting. */
#include "../test.h"
#include "../../src/player/input/controllers.h"

enum { START = 1 << PLAT_START, SOUTH = 1 << PLAT_SOUTH, UP = 1 << PLAT_DPAD_UP };

static struct controllers s;
static struct plat_controller in_it[PLAT_MAX_CONTROLLERS];
static const struct plat_controller *plugged[PLAT_MAX_CONTROLLERS];
static uint32_t held[PLAT_MAX_CONTROLLERS];
static int players;
static uint32_t next_id;

static void poll(void)
{
    controllers_poll(&s, players, held, plugged);
}

static void plug(int i, const char *name)
{
    in_it[i] = (struct plat_controller){ .id = ++next_id, .kind = PLAT_XBOX };
    strcpy(in_it[i].name, name);
    plugged[i] = &in_it[i];
    poll();
}

static void unplug(int i)
{
    plugged[i] = NULL;
    poll();
}

static void hold(int i, uint32_t buttons)
{
    held[i] = buttons;
    poll();
}

/* A game for n players, with a controller of each of these models, NULL for none; all have been polled once. */
static void begin(int n, const char *first, const char *second)
{
    const char *const models[] = { first, second };

    controllers_open(&s);
    memset(plugged, 0, sizeof plugged);
    memset(held, 0, sizeof held);
    players = n;
    for (int i = 0; i < 2; i++)
        if (models[i])
            plug(i, models[i]);
}

static void expect_event(int i, enum controllers_event_kind kind, int player)
{
    assert_true(i < s.event_count);
    assert_int_equal(s.event[i].kind, kind);
    assert_int_equal(s.event[i].player, player);
}

static void expect_none(void)
{
    assert_int_equal(s.event_count, 0);
}

static void expect_held(int player, uint32_t buttons)
{
    assert_int_equal(controllers_buttons(&s, player), buttons);
}

static void expect_player_of(int controller, int player)
{
    assert_int_equal(controllers_find_player(&s, controller), player);
}

/* Two players with a controller each; nothing is held. */
static void begin_with_both(void)
{
    begin(2, "one", "two");
    hold(0, SOUTH);
    hold(1, START);
    hold(0, 0);
    hold(1, 0);
}

/* The one that is used plays, not the one that is first: some machines have a controller that nobody holds. */
TEST(the_first_used_is_player_1s)
{
    begin(2, NULL, "pad");
    held[0] = UP; /* which stands askew: it was so when it came */
    plug(0, "a thing with axes");
    expect_none();
    hold(1, SOUTH);
    expect_event(0, CONTROLLERS_ASSIGNED, 0);
    assert_true(s.event[0].first);
    expect_held(0, SOUTH); /* the press that took the place counts */
    expect_held(1, 0);
    assert_int_equal(s.buttons[0], 0);
    hold(0, 0);
    hold(0, UP); /* pressed now, but it is no START */
    expect_none();
    expect_player_of(0, -1);
}

TEST(start_joins)
{
    begin(2, "pad", "pad");
    plug(2, "other");
    hold(0, SOUTH);
    hold(1, SOUTH);
    expect_held(1, 0);
    hold(1, SOUTH | START);
    expect_event(0, CONTROLLERS_ASSIGNED, 1);
    assert_true(!s.event[0].first && s.event[0].start);
    expect_held(1, SOUTH); /* START was for the place */
    hold(1, START);
    expect_held(1, 0);
    hold(1, 0);
    hold(1, START); /* and the next one is for the game */
    expect_held(1, START);
    expect_none();
    hold(2, START);
    expect_event(0, CONTROLLERS_REFUSED, 0);
    expect_player_of(2, -1);
}

TEST(in_a_game_for_one_start_hands_over)
{
    begin(1, "pad", "other");
    hold(0, UP);
    hold(1, SOUTH);
    expect_player_of(1, -1);
    hold(1, START);
    expect_event(0, CONTROLLERS_ASSIGNED, 0);
    expect_player_of(1, 0);
    expect_player_of(0, -1);
    expect_held(0, 0);
    begin(0, "pad", NULL); /* a manifest that says nothing */
    hold(0, UP);
    expect_held(0, UP);
}

TEST(what_goes_lets_go_and_comes_back)
{
    begin_with_both();
    hold(1, UP);
    held[0] = SOUTH; /* the port may still say that something is held */
    unplug(0);
    expect_event(0, CONTROLLERS_UNPLUGGED, 0);
    assert_string_equal(s.event[0].controller.name, "one");
    assert_int_equal(s.buttons[0], 0);
    expect_held(0, 0);
    expect_held(1, UP);
    held[0] = 0;
    hold(1, UP | SOUTH); /* player 2's stays player 2's */
    expect_player_of(1, 1);
    held[2] = SOUTH;
    plug(2, "one"); /* another socket */
    expect_event(0, CONTROLLERS_RECONNECTED, 0);
    assert_int_equal(s.event_count, 1);
    expect_held(0, 0); /* held since it came: not pressed */
    hold(2, 0);
    hold(2, SOUTH);
    expect_held(0, SOUTH);
}

TEST(another_may_take_the_place)
{
    begin_with_both();
    unplug(1);
    expect_event(0, CONTROLLERS_UNPLUGGED, 1);
    plug(1, "three"); /* no model that was there */
    expect_none();
    expect_player_of(1, -1);
    hold(1, START);
    expect_event(0, CONTROLLERS_ASSIGNED, 1);
    unplug(0);
    plug(0, "four");
    hold(0, SOUTH);
    expect_event(0, CONTROLLERS_ASSIGNED, 0);
    assert_true(!s.event[0].start && !s.event[0].first); /* the place was somebody's */
    plug(2, "two");                                      /* too late */
    expect_none();
}

/* Between two polls one goes and another comes under the same number. */
TEST(an_exchange_is_seen)
{
    begin(1, "one", NULL);
    hold(0, UP);
    plug(0, "other");
    expect_event(0, CONTROLLERS_UNPLUGGED, 0);
    assert_int_equal(s.event_count, 1);
    expect_held(0, 0);
    hold(0, 0);
    hold(0, UP);
    expect_event(0, CONTROLLERS_ASSIGNED, 0);
    plug(0, "other"); /* a plug that is loose */
    expect_event(0, CONTROLLERS_UNPLUGGED, 0);
    expect_event(1, CONTROLLERS_RECONNECTED, 0);
}

TEST(given_on_a_screen)
{
    begin_with_both();
    hold(0, SOUTH);
    controllers_assign(&s, 1, 0); /* player 1's goes to player 2, who gives theirs up */
    expect_player_of(0, 1);
    expect_player_of(1, -1);
    expect_held(0, 0);
    poll();
    expect_held(1, 0); /* the button that chose it on the screen */
    hold(0, 0);
    hold(0, UP);
    expect_held(1, UP);
    controllers_assign(&s, 1, CONTROLLERS_NONE);
    expect_player_of(0, -1);
    unplug(0);
    expect_none(); /* nobody's */
    plug(0, "one");
    expect_none();
}

/* A port that knows no controllers by name has them all there, always. */
TEST(a_port_that_knows_nothing)
{
    begin(2, NULL, NULL);
    for (int i = 0; i < PLAT_MAX_CONTROLLERS; i++) {
        assert_true(plat_get_controller(i, &in_it[i]));
        plugged[i] = &in_it[i];
    }
    assert_false(plat_get_controller(PLAT_MAX_CONTROLLERS, &in_it[0]));
    poll();
    expect_none();
    hold(0, SOUTH);
    expect_held(0, SOUTH);
    hold(1, START);
    expect_event(0, CONTROLLERS_ASSIGNED, 1);
}

RUN_TESTS(NULL, NULL)
