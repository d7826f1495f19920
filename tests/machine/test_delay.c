/*
 * test_delay.c - bullets with a delay: still and harmless while it lasts, and from its end on as one that was fired
 * then.
 */
#include "rig.h"

static const char kinds[] = "bullet.def('orb', { sprite = 'dot', hit = { circle = 4 }, cloud = 'wink' })\n"
                            "bullet.def('bar', { sprite = 'arrow', hit = { box = { 9, 5 } }, bank = 3 })\n"
                            "bullet.def('star', { sprite = 'dot', hit = { circle = 2 }, bank = 5, cloud = 'arrow' })\n"
                            "player.def('ship', { sprite = 'dot', hit = { circle = 2 }, graze = 16, lives = 9 })\n"
                            "motion.def { name = 'turn', { turn = 3, over = 40 }, { speed = 0.5, over = 30 } }\n"
                            "motion.def { name = 'late', { wait = 7 }, { kind = 'bar', aim = true }, { die = true } }\n"
                            "motion.def { name = 'fine', fine = true, { accel = 0.01, over = 50 } }\n"
                            "motion.def { name = 'creep', fine = true }\n"
                            "string.sys.join(1, 'ship')\n";

static void power(struct rig_game *g, struct rig *r, const char *format, ...)
{
    static char text[4096];
    va_list args;
    size_t n = sizeof kinds - 1;

    memcpy(text, kinds, n);
    va_start(args, format);
    vsnprintf(text + n, sizeof text - n, format, args);
    va_end(args);
    rig_with_sys(g, NULL, text);
    rig_power(r, g, NULL);
}

static uint64_t bullets_hash(const struct rig *r)
{
    uint64_t part[MAX_PARTS];

    board_hashes(r->b, part);
    for (int i = 0; i < board_part_count(r->b); i++)
        if (!strcmp(board_part_name(r->b, i), "bullets"))
            return part[i];
    return 0;
}

/* One is fired with a delay of n, another n frames later: from then on their boards' bullets are equal, in every
 * column, also after a snapshot in the middle. */
static void same(const char *args, const char *writes, int n)
{
    const char *fire = "task.go(function() wait(%d) local b = bullet.fire { %s, delay = %d }\n"
                       "  wait(%d) %s end)\n";
    struct rig_game g, h;
    struct rig a, b;

    power(&g, &a, fire, 3, args, n, n / 2, writes);
    power(&h, &b, fire, 3 + n, args, 0, 0, writes);
    rig_run(&b, 3 + n + 1);
    for (int f = 0; f < 3 + n + 1; f++) {
        if (f == 3 + n / 2)
            rig_spoil(&a);
        rig_run(&a, 1);
        if (f < 3 + n && a.b->bullets.s.live)
            assert_true(a.b->bullets.vx[0] == 0 && a.b->bullets.vy[0] == 0);
    }
    for (int f = 0; f < 120; f++) {
        if (bullets_hash(&a) != bullets_hash(&b))
            fail_msg("{ %s } %s, delay %d: frame %d after it differs", args, writes, n, f);
        rig_run(&a, 1);
        rig_run(&b, 1);
    }
    rig_close(&a);
    rig_close(&b);
}

TEST(same)
{
    static const char *const args[] = {
        "kind = 'orb', x = 60, y = 40, speed = 1.5, dir = 33",
        "kind = 'bar', x = 60, y = 40, speed = 0.5, dir = 200, motion = 'turn', bank = 2",
        "kind = 'orb', x = 60, y = 40, speed = 2, motion = 'late', tag = 't'",
        "kind = 'star', x = 60, y = 40, speed = 0.001, motion = 'fine'",
        "kind = 'star', x = 60, y = 40, speed = 0.3, dir = 11, motion = 'creep'",
    };
    static const char *const writes[] = {
        "",
        "b.speed = 0.75",
        "b.dir = 77",
        "b.kind = 'star'",
        "b.kind = 'bar' b.bank = 9",
        "b.motion = 'late'",
        "b.motion = 'creep'",
        "b.motion = nil",
        "b.x, b.y = 99.5, 12.25",
        "b:turn(20)",
        "b:aim(3)",
        "local g = bullet.group() g.speed = 1.25 g:turn(7)",
    };
    static const int delays[] = { 1, 2, 40, 255, 256, 257, 600 };

    for (size_t i = 0; i < sizeof args / sizeof *args; i++) {
        for (size_t k = 0; k < sizeof delays / sizeof *delays; k++)
            same(args[i], "", delays[k]);
        for (size_t k = 0; k < sizeof writes / sizeof *writes; k++)
            same(args[i], writes[k], 20);
    }
}

RUN_TESTS(NULL, NULL)
