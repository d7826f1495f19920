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

static void begin(int n)
{
    controllers_open(&s);
    memset(plugged, 0, sizeof plugged);
    memset(held, 0, sizeof held);
    players = n;
}

static void plug(int i, const char *name)
{
    in_it[i] = (struct plat_controller){ .id = ++next_id, .kind = PLAT_XBOX };
    strcpy(in_it[i].name, name);
    plugged[i] = &in_it[i];
}

static void unplug(int i)
{
    plugged[i] = NULL;
    held[i] = 0;
}

static void poll(void)
{
    controllers_poll(&s, players, held, plugged);
}

static void hold(int i, uint32_t buttons)
{
    held[i] = buttons;
    poll();
}

static void told(int i, enum controllers_event_kind kind, int player)
{
    assert_true(i < s.event_count);
    assert_int_equal(s.event[i].kind, kind);
    assert_int_equal(s.event[i].player, player);
}

static void nothing_is_told(void)
{
    assert_int_equal(s.event_count, 0);
}

/* The one that is used plays, not the one that is first: some machines have a controller that nobody holds. */
TEST(the_first_used_is_player_1s)
{
    begin(2);
    plug(0, "a thing with axes");
    plug(1, "pad");
    held[0] = UP; /* which stands askew: it was so when it came */
    poll();
    nothing_is_told();
    hold(1, SOUTH);
    told(0, CONTROLLERS_ASSIGNED, 0);
    assert_true(s.event[0].first);
    assert_int_equal(controllers_buttons(&s, 0), SOUTH); /* the press that took the place counts */
    assert_int_equal(controllers_buttons(&s, 1), 0);
    assert_int_equal(s.buttons[0], 0);
    poll();
    nothing_is_told();
    hold(0, 0);
    hold(0, UP); /* pressed now, but it is no START */
    nothing_is_told();
    assert_int_equal(controllers_find_player(&s, 0), -1);
}

TEST(start_joins)
{
    begin(2);
    plug(0, "pad");
    plug(1, "pad");
    plug(2, "other");
    poll();
    hold(0, SOUTH);
    hold(1, SOUTH);
    assert_int_equal(controllers_buttons(&s, 1), 0);
    hold(1, SOUTH | START);
    told(0, CONTROLLERS_ASSIGNED, 1);
    assert_false(s.event[0].first);
    assert_true(s.event[0].start);
    assert_int_equal(controllers_buttons(&s, 1), SOUTH); /* START was for the place */
    hold(1, START);
    assert_int_equal(controllers_buttons(&s, 1), 0);
    hold(1, 0);
    hold(1, START); /* and the next one is for the game */
    assert_int_equal(controllers_buttons(&s, 1), START);
    nothing_is_told();
    hold(2, START);
    told(0, CONTROLLERS_REFUSED, 0);
    assert_int_equal(controllers_find_player(&s, 2), -1);
    assert_int_equal(controllers_find_player(&s, 0), 0);
}

TEST(in_a_game_for_one_start_hands_over)
{
    begin(1);
    plug(0, "pad");
    plug(3, "other");
    poll();
    hold(0, UP);
    hold(3, SOUTH);
    assert_int_equal(controllers_find_player(&s, 3), -1);
    hold(3, START);
    told(0, CONTROLLERS_ASSIGNED, 0);
    assert_int_equal(controllers_find_player(&s, 3), 0);
    assert_int_equal(controllers_find_player(&s, 0), -1);
    assert_int_equal(controllers_buttons(&s, 0), 0);
    begin(0); /* a manifest that says nothing */
    plug(0, "pad");
    poll();
    hold(0, UP);
    assert_int_equal(controllers_buttons(&s, 0), UP);
}

TEST(what_goes_lets_go_and_comes_back)
{
    begin(2);
    plug(0, "one");
    plug(1, "two");
    poll();
    hold(0, SOUTH);
    hold(1, START);
    hold(1, UP);
    plugged[0] = NULL; /* the port may still say that something is held */
    poll();
    told(0, CONTROLLERS_UNPLUGGED, 0);
    assert_string_equal(s.event[0].controller.name, "one");
    assert_int_equal(controllers_buttons(&s, 0), 0);
    assert_int_equal(s.buttons[0], 0);
    assert_int_equal(controllers_buttons(&s, 1), UP);
    held[0] = 0;
    poll();
    nothing_is_told();
    hold(1, UP | SOUTH); /* player 2's stays player 2's */
    assert_int_equal(controllers_find_player(&s, 1), 1);
    plug(2, "one"); /* another socket */
    held[2] = SOUTH;
    poll();
    told(0, CONTROLLERS_RECONNECTED, 0);
    assert_int_equal(s.event_count, 1);
    assert_int_equal(controllers_buttons(&s, 0), 0); /* held since it came: not pressed */
    hold(2, 0);
    hold(2, SOUTH);
    assert_int_equal(controllers_buttons(&s, 0), SOUTH);
}

TEST(another_may_take_the_place)
{
    begin(2);
    plug(0, "one");
    plug(1, "two");
    poll();
    hold(0, SOUTH);
    hold(1, START);
    hold(1, 0);
    unplug(1);
    poll();
    told(0, CONTROLLERS_UNPLUGGED, 1);
    plug(1, "three"); /* no model that was there */
    poll();
    nothing_is_told();
    assert_int_equal(controllers_find_player(&s, 1), -1);
    hold(1, START);
    told(0, CONTROLLERS_ASSIGNED, 1);
    unplug(0);
    poll();
    told(0, CONTROLLERS_UNPLUGGED, 0);
    plug(0, "four");
    poll();
    hold(0, SOUTH);
    told(0, CONTROLLERS_ASSIGNED, 0);
    assert_false(s.event[0].start);
    assert_false(s.event[0].first); /* the place was somebody's */
    plug(2, "two");                 /* too late */
    poll();
    nothing_is_told();
}

/* Between two polls one goes and another comes under the same number. */
TEST(an_exchange_is_seen)
{
    begin(1);
    plug(0, "one");
    poll();
    hold(0, UP);
    plug(0, "other");
    poll();
    told(0, CONTROLLERS_UNPLUGGED, 0);
    assert_int_equal(s.event_count, 1);
    assert_int_equal(controllers_buttons(&s, 0), 0);
    hold(0, 0);
    hold(0, UP);
    told(0, CONTROLLERS_ASSIGNED, 0);
    plug(0, "other"); /* a plug that is loose */
    held[0] = 0;
    poll();
    told(0, CONTROLLERS_UNPLUGGED, 0);
    told(1, CONTROLLERS_RECONNECTED, 0);
}

TEST(given_on_a_screen)
{
    begin(2);
    plug(0, "one");
    plug(1, "two");
    poll();
    hold(0, SOUTH);
    hold(1, START);
    hold(0, SOUTH);
    controllers_assign(&s, 1, 0); /* player 1's goes to player 2, who gives theirs up */
    assert_int_equal(controllers_find_player(&s, 0), 1);
    assert_int_equal(controllers_find_player(&s, 1), -1);
    assert_int_equal(controllers_buttons(&s, 0), 0);
    assert_int_equal(controllers_buttons(&s, 1), 0); /* the button that chose it on the screen */
    poll();
    assert_int_equal(controllers_buttons(&s, 1), 0);
    hold(0, 0);
    hold(0, UP);
    assert_int_equal(controllers_buttons(&s, 1), UP);
    controllers_assign(&s, 1, CONTROLLERS_NONE);
    assert_int_equal(controllers_find_player(&s, 0), -1);
    unplug(0);
    poll();
    nothing_is_told(); /* nobody's */
    plug(0, "one");
    poll();
    nothing_is_told();
}

/* A port that knows no controllers by name has them all there, always. */
TEST(a_port_that_knows_nothing)
{
    begin(2);
    for (int i = 0; i < PLAT_MAX_CONTROLLERS; i++) {
        assert_true(plat_get_controller(i, &in_it[i]));
        plugged[i] = &in_it[i];
    }
    assert_false(plat_get_controller(PLAT_MAX_CONTROLLERS, &in_it[0]));
    assert_true(plat_get_controller(0, &in_it[0]));
    poll();
    nothing_is_told();
    hold(0, SOUTH);
    assert_int_equal(controllers_buttons(&s, 0), SOUTH);
    hold(1, START);
    told(0, CONTROLLERS_ASSIGNED, 1);
}

RUN_TESTS(NULL, NULL)
