/*
 * test_follow.c - where sparks start, and how they change their colours. tests/scripts/follow.lua has the rest.
 */
#include <math.h>
#include "rig.h"

static struct rig_game g;
static struct rig r;

static const char kinds[] = "spark.def('k', { sprite = 'dot', life = 12, bank = 3 })\n"
                            "spark.def('ramp', { sprite = 'dot', life = 10, banks = { 1, 5, 2 } })\n"
                            "spark.def('z', { sprite = 'dot', life = 500, bank = 4 })\n";

static void open_with(const char *text)
{
    static char full[8192];

    snprintf(full, sizeof full, "%s%s", kinds, text);
    rig_script(&g, NULL, full);
    rig_power(&r, &g, NULL);
}

/* The picture after some frames. */
static uint64_t picture(const char *text, int frames)
{
    open_with(text);
    rig_run(&r, frames);
    const uint64_t h = rig_picture(&r);
    rig_close(&r);
    return h;
}

static void spark_at(int i, double x, double y, double vx, double vy)
{
    const struct sparks *s = &r.b->sparks;
    double off = fabs(fx_to_double(s->x[i]) - x) + fabs(fx_to_double(s->y[i]) - y) + fabs(fx_to_double(s->vx[i]) - vx) +
                 fabs(fx_to_double(s->vy[i]) - vy);

    if (off > 0.001)
        fail_msg("spark %d is at %f, %f with %f, %f", i, fx_to_double(s->x[i]), fx_to_double(s->y[i]),
                 fx_to_double(s->vx[i]), fx_to_double(s->vy[i]));
}

TEST(shapes)
{
    open_with("spark.burst { kind = 'z', x = 100, y = 100, n = 4, radius = 20, speed = 0 }");
    spark_at(0, 120, 100, 0, 0);
    spark_at(1, 100, 120, 0, 0);
    spark_at(2, 80, 100, 0, 0);
    spark_at(3, 100, 80, 0, 0);
    rig_close(&r);
    open_with("spark.burst { kind = 'z', x = 100, y = 100, n = 4, radius = 20, dir = 90, speed = 2 }");
    for (int i = 0; i < 4; i++) { /* turned by dir: along the ring, at 1 to 2 px a frame */
        const struct sparks *s = &r.b->sparks;
        double speed = hypot(fx_to_double(s->vx[i]), fx_to_double(s->vy[i]));
        assert_true(speed >= 0.999 && speed <= 2.001);
        double way[4][2] = { { 0, 1 }, { -1, 0 }, { 0, -1 }, { 1, 0 } };
        assert_true(fabs(fx_to_double(s->vx[i]) - speed * way[i][0]) < 0.001);
        assert_true(fabs(fx_to_double(s->vy[i]) - speed * way[i][1]) < 0.001);
    }
    rig_close(&r);
    open_with("spark.burst { kind = 'z', x = 10, y = 20, to_x = 40, to_y = 26, n = 4, speed = 0 }\n"
              "spark.burst { kind = 'z', x = 10, y = 20, to_x = 40, to_y = 26, speed = 0 }");
    spark_at(0, 10, 20, 0, 0);
    spark_at(1, 20, 22, 0, 0);
    spark_at(2, 30, 24, 0, 0);
    spark_at(3, 40, 26, 0, 0);
    spark_at(4, 10, 20, 0, 0);
    rig_close(&r);
}

static uint16_t spark_kind(const char *name)
{
    for (int i = 0; i < (int)r.b->names[N_SPARK].n; i++)
        if (board_name(r.b, N_SPARK, i) && strcmp(board_name(r.b, N_SPARK, i), name) == 0)
            return (uint16_t)i;
    fail_msg("no spark kind \"%s\"", name);
    return 0;
}

/* Three banks in ten frames: from 0, 4 and 7 on. The kinds next to it are not touched. */
TEST(ramp)
{
    const uint8_t want[10] = { 1, 1, 1, 1, 5, 5, 5, 2, 2, 2 };

    open_with("");
    for (uint16_t age = 0; age < 10; age++) {
        assert_int_equal(sparks_bank(&r.b->spark_kinds, spark_kind("k"), age), 3);
        assert_int_equal(sparks_bank(&r.b->spark_kinds, spark_kind("ramp"), age), want[age]);
        assert_int_equal(sparks_bank(&r.b->spark_kinds, spark_kind("z"), age), 4);
    }
    rig_close(&r);
    assert_true(picture("spark.burst { kind = 'ramp', x = 50, y = 50, speed = 0 }", 5) ==
                picture("spark.def('five', { sprite = 'dot', life = 99, bank = 5 })\n"
                        "spark.burst { kind = 'five', x = 50, y = 50, speed = 0 }",
                        5));
}

/* A spark without a sprite is a cross of 5 px in the brightest shade of its bank. */
TEST(dot)
{
    uint32_t rgb[256];
    int seen = 0;

    open_with("spark.def('dot', { life = 9, bank = 3 })\n"
              "spark.burst { kind = 'dot', x = 50, y = 40, speed = 0 }");
    rig_run(&r, 1);
    board_draw(r.b, NULL, &r.fb, rgb, r.scratch);
    for (int y = 0; y < 320; y++)
        for (int x = 0; x < 240; x++)
            seen += r.fb.pix[y * r.fb.pitch + x] != 0;
    assert_int_equal(seen, 5);
    for (int k = -1; k <= 1; k++) {
        assert_int_equal(r.fb.pix[40 * r.fb.pitch + 50 + k], 3 * 16 + 15);
        assert_int_equal(r.fb.pix[(40 + k) * r.fb.pitch + 50], 3 * 16 + 15);
    }
    rig_close(&r);
}

RUN_TESTS(NULL, NULL)
