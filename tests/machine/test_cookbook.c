/*
 * test_cookbook.c - the pages of roms/cookbook are turned by the buttons: while the list is open by the arrows, while
 * it is closed by special and select; every page tells its name, and all of them can be practised.
 */
#include "rig.h"

static struct rig_game game;

/* The stage that began last in so many frames, of which the first has these buttons down; "": none did. */
static const char *turned(struct rig *r, uint16_t buttons, int frames)
{
    static char name[32];

    name[0] = '\0';
    for (int f = 0; f < frames; f++) {
        const uint16_t pads[MAX_PLAYERS] = { f ? 0 : buttons };
        rig_tick(r, pads);
        const struct board_out *out = board_last_output(r->b);
        for (int i = 0; i < out->marker_count; i++)
            if (out->marker[i].kind == MARKER_STAGE)
                snprintf(name, sizeof name, "%s", out->marker[i].name);
    }
    return name;
}

TEST(turning)
{
    struct rig r;

    rig_power(&r, &game, NULL);
    assert_string_equal(turned(&r, 0, 2), "spiral");
    assert_string_equal(turned(&r, PAD_RIGHT, 5), "counter");
    assert_string_equal(turned(&r, PAD_FIRE, 5), "counter"); /* again */
    assert_string_equal(turned(&r, PAD_LEFT, 5), "spiral");
    assert_string_equal(turned(&r, PAD_DOWN, 5), "crossfire"); /* ten on */
    assert_string_equal(turned(&r, PAD_UP, 5), "spiral");
    assert_string_equal(turned(&r, PAD_SPECIAL, 5), ""); /* only while the list is closed */
    assert_string_equal(turned(&r, PAD_START, 5), "");
    assert_string_equal(turned(&r, PAD_RIGHT, 5), "");
    assert_string_equal(turned(&r, PAD_SPECIAL, 5), "counter");
    assert_string_equal(turned(&r, PAD_SELECT, 5), "spiral");
    rig_free(&r);
}

/* The ship flies while the list is closed, and stands while it is open. */
TEST(flying)
{
    struct rig r;

    rig_power(&r, &game, NULL);
    rig_run(&r, 5);
    fx x = r.b->player.x[0];
    turned(&r, PAD_UP, 5);
    assert_int_equal(r.b->player.x[0], x);
    turned(&r, PAD_START, 5);
    turned(&r, PAD_LEFT, 5);
    assert_true(r.b->player.x[0] < x);
    rig_free(&r);
}

/* Left alone, a page begins anew. */
TEST(again)
{
    struct rig r;

    rig_power(&r, &game, NULL);
    assert_string_equal(turned(&r, 0, 5), "spiral");
    assert_string_equal(turned(&r, 0, 880), "");
    assert_string_equal(turned(&r, 0, 30), "spiral");
    rig_free(&r);
}

TEST(practice)
{
    struct board_start start = { .seed = 1, .difficulty = -1, .practice = { .section = PRACTICE_LIST } };
    struct rig r;
    int pages = 0;
    bool listed = false;

    rig_power(&r, &game, &start);
    for (int f = 0; f < 200 && !listed; f++) {
        rig_run(&r, 1);
        const struct board_out *out = board_last_output(r.b);
        for (int i = 0; i < out->marker_count; i++) {
            if (out->marker[i].kind == MARKER_STAGE && !pages++)
                assert_string_equal(out->marker[i].name, "spiral");
            listed |= out->marker[i].kind == MARKER_LISTED;
        }
    }
    assert_true(listed);
    assert_true(pages >= 60);
    rig_free(&r);
    snprintf(start.practice.section, sizeof start.practice.section, "snow");
    rig_power(&r, &game, &start);
    assert_string_equal(turned(&r, 0, 2), "snow");
    rig_free(&r);
}

int main(void)
{
    rig_folder(&game, "cookbook");
    int failed = run_all_tests(NULL, NULL);
    rig_game_free(&game);
    return failed;
}
