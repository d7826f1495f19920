/*
 * test_patterns.c - patterns put every bullet where a formula says: directions and speeds of figures, places of points
 * and pictures, what is left out, what is drawn by chance, and what else than bullets they fire. What is refused is in
 * tests/scripts/patterns.lua.
 *
 * The formulas are written anew here, in doubles and with the C library, from what the guide says.
 */
#include <math.h>
#include "rig.h"

static const char kinds[] = "bullet.def('dot', { sprite = 'dot', hit = { circle = 3 } })\n"
                            "shot.def('bolt', { sprite = 'dot', hit = { circle = 3 } })\n"
                            "enemy.def('foe', { sprite = 'dot', hit = 'none', hp = 9 })\n"
                            "player.def('ship', { sprite = 'dot', hit = { circle = 2 } })\n"
                            "local sys = string.sys\n";

static struct rig_game g;
static struct rig rig;
static struct rng rng;

/* A board that has loaded this script and run some frames. */
static void begin(int frames, const char *format, ...)
{
    char text[3000];
    va_list args;
    size_t n = (size_t)snprintf(text, sizeof text, "%s", kinds);

    va_start(args, format);
    vsnprintf(text + n, sizeof text - n, format, args);
    va_end(args);
    rig_with_sys(&g, NULL, text);
    rig_power_any(&rig, &g, NULL);
    const uint16_t none[MAX_PLAYERS] = { 0 };
    for (int f = 0; f < frames && !rig_fault(&rig); f++)
        board_tick(rig.b, none);
}

/* ---- directions and speeds ---- */

enum { MOST = 256 };

/* What a bullet should be: degrees and px a frame; the place, px. */
struct want {
    double dir, speed, x, y;
};

static double turns(double degrees)
{
    double t = degrees / 360;

    return t - floor(t);
}

/* Directions are right to so many units of an angle, speeds and places to one of 1/65536. */
static void same_bullet(const struct bullets *p, uint32_t i, const struct want *w, double units)
{
    int32_t off = (int32_t)(p->dir[i] - (ang)(int64_t)llround(turns(w->dir) * 4294967296.0));

    if (fabs(w->speed) > 1e-9 && labs(off) > units)
        fail_msg("bullet %u: %d units of an angle beside %.9g degrees", i + 1, off, w->dir);
    if (fabs(p->speed[i] - w->speed * 65536) > 1.001)
        fail_msg("bullet %u: speed %d, expected %.9g", i + 1, p->speed[i], w->speed * 65536);
    if (fabs(p->x[i] - w->x * 65536) > 1.001 || fabs(p->y[i] - w->y * 65536) > 1.001)
        fail_msg("bullet %u: at %d, %d, expected %.9g, %.9g", i + 1, p->x[i], p->y[i], w->x * 65536, w->y * 65536);
}

static void same_within(double units, const struct want *w, uint32_t n)
{
    rig_sound(&rig);
    assert_int_equal(rig.b->bullets.s.live, n);
    for (uint32_t i = 0; i < n; i++)
        same_bullet(&rig.b->bullets, i, &w[i], units);
}

static void same_bullets(const struct want *w, uint32_t n)
{
    same_within(8, w, n);
}

/* The direction and the distance of (x, y), which is a point of a figure turned by dir. */
static struct want point(double dir, double x, double y)
{
    return (struct want){ dir + atan2(y, x) * 180 / M_PI, sqrt(x * x + y * y), 100, 50 };
}

static double degrees(double d)
{
    return d * M_PI / 180;
}

static double between(double lo, double hi)
{
    return lo + (hi - lo) * (double)rng_below(&rng, 1 << 20) / (1 << 20);
}

static int whole(int lo, int hi)
{
    return lo + (int)rng_below(&rng, (uint64_t)(hi - lo) + 1);
}

#define AT "kind = 'dot', x = 100, y = 50, dir = %.17g, speed = %.17g, "

/* A closed line through corners (cx, cy), m bullets a side from each corner on. */
static void outline(struct want *w, double dir, const double *cx, const double *cy, int corners, int m)
{
    for (int i = 0; i < corners * m; i++) {
        int from = i / m, to = (from + 1) % corners;
        double part = (double)(i % m) / m;
        w[i] = point(dir, cx[from] + (cx[to] - cx[from]) * part, cy[from] + (cy[to] - cy[from]) * part);
    }
}

TEST(polygon)
{
    for (int k = 0; k < 60; k++) {
        struct want w[MOST];
        double cx[20], cy[20], dir = between(-720, 720), speed = between(0.01, 9);
        int sides = whole(3, 12), m = whole(1, 12);
        for (int i = 0; i < sides; i++) {
            cx[i] = speed * cos(2 * M_PI * i / sides);
            cy[i] = speed * sin(2 * M_PI * i / sides);
        }
        outline(w, dir, cx, cy, sides, m);
        begin(0, "pattern.polygon { " AT "n = %d, sides = %d }", dir, speed, sides * m, sides);
        same_bullets(w, (uint32_t)(sides * m));
        for (int i = 0; i < sides; i++) { /* corners have the speed and the direction that bullet.fire would give */
            fx f;
            ang a;
            assert_true(fx_from_double(speed, &f) && trig_from_degrees(dir + 360.0 * i / sides, &a));
            assert_int_equal(rig.b->bullets.speed[i * m], f);
            assert_int_equal(rig.b->bullets.dir[i * m], a);
        }
        rig_close(&rig);
    }
}

TEST(star)
{
    for (int k = 0; k < 60; k++) {
        struct want w[MOST];
        double cx[32], cy[32], dir = between(-720, 720), speed = between(0.01, 9), inner = between(0.01, 1);
        int points = whole(2, 10), m = whole(1, 10);
        for (int i = 0; i < 2 * points; i++) {
            cx[i] = speed * (i % 2 ? inner : 1) * cos(M_PI * i / points);
            cy[i] = speed * (i % 2 ? inner : 1) * sin(M_PI * i / points);
        }
        outline(w, dir, cx, cy, 2 * points, m);
        begin(0, "pattern.star { " AT "n = %d, points = %d, inner = %.17g }", dir, speed, 2 * points * m, points,
              inner);
        same_bullets(w, (uint32_t)(2 * points * m));
        rig_close(&rig);
    }
}

/* The first flies along dir; the others stand at equal steps of the circle that was stretched. Stretching makes the
 * rounding of an angle as many times larger. */
TEST(ellipse)
{
    for (int k = 0; k < 60; k++) {
        struct want w[MOST];
        double dir = between(-720, 720), a = between(0.1, 9), b = between(0.1, 9),
               tilt = k % 3 ? between(-400, 400) : 0;
        int n = whole(1, 60);
        double first = atan2(sin(degrees(-tilt)) / b, cos(degrees(-tilt)) / a);
        for (int i = 0; i < n; i++) {
            double t = first + 2 * M_PI * i / n;
            w[i] = point(dir + tilt, a * cos(t), b * sin(t));
        }
        assert_true(fabs(remainder(w[0].dir - dir, 360)) < 1e-6);
        begin(0, "pattern.ellipse { " AT "n = %d, speed_to = %.17g, tilt = %.17g }", dir, a, n, b, tilt);
        same_within(8 + 2 * fmax(a / b, b / a), w, (uint32_t)n);
        rig_close(&rig);
    }
}

TEST(rose)
{
    for (int k = 0; k < 60; k++) {
        struct want w[MOST];
        double dir = between(-720, 720), speed = between(-3, 9), low = between(-3, 9);
        int n = whole(1, 200), petals = whole(1, 40);
        for (int i = 0; i < n; i++)
            w[i] = (struct want){ dir + 360.0 * i / n, low + (speed - low) * (1 + cos(2 * M_PI * petals * i / n)) / 2,
                                  100, 50 };
        begin(0, "pattern.rose { " AT "n = %d, petals = %d, speed_to = %.17g }", dir, speed, n, petals, low);
        same_bullets(w, (uint32_t)n);
        rig_close(&rig);
    }
}

TEST(whip)
{
    for (int k = 0; k < 60; k++) {
        struct want w[MOST];
        double dir = between(-720, 720), speed = between(-3, 9), to = between(-3, 9), bend = between(-400, 400);
        int n = whole(1, 60);
        for (int i = 0; i < n; i++) {
            double part = n > 1 ? (double)i / (n - 1) : 0;
            w[i] = (struct want){ dir + bend * part, speed + (to - speed) * part, 100, 50 };
        }
        begin(0, "pattern.whip { " AT "n = %d, bend = %.17g, speed_to = %.17g }", dir, speed, n, bend, to);
        same_bullets(w, (uint32_t)n);
        rig_close(&rig);
    }
}

/* Two numbers a bullet from the game's own stream: direction, then speed. */
TEST(scatter)
{
    for (int k = 0; k < 20; k++) {
        struct want w[MOST];
        double dir = between(-720, 720), speed = between(-3, 9), to = between(-3, 9), spread = between(-400, 400);
        int n = whole(0, 60);
        struct rng r;
        begin(0, "pattern.scatter { " AT "n = 0, spread = 1, speed_to = 1 }", dir, speed);
        memcpy(r.s, rig.b->core.random, sizeof r.s);
        rig_close(&rig);
        for (int i = 0; i < n; i++) {
            double a = (double)(rng_next(&r) >> 11) / 9007199254740992.0;
            double b = (double)(rng_next(&r) >> 11) / 9007199254740992.0;
            w[i] = (struct want){ dir + spread * (a - 0.5), speed + (to - speed) * b, 100, 50 };
        }
        begin(0, "pattern.scatter { " AT "n = %d, spread = %.17g, speed_to = %.17g }", dir, speed, n, spread, to);
        same_bullets(w, (uint32_t)n);
        assert_memory_equal(rig.b->core.random, r.s, sizeof r.s);
        rig_close(&rig);
    }
}

/* ---- places ---- */

TEST(points)
{
    for (int k = 0; k < 60; k++) {
        struct want w[MOST];
        char list[1500] = "";
        size_t used = 0;
        double dir = between(-720, 720), scale = between(-3, 3);
        int n = whole(0, 20), turned = k % 2;
        double c = turned ? cos(degrees(dir)) : 1, s = turned ? sin(degrees(dir)) : 0;
        for (int i = 0; i < n; i++) {
            double x = between(-90, 90), y = between(-90, 90);
            used += (size_t)snprintf(list + used, sizeof list - used, "{ %.17g, %.17g }, ", x, y);
            w[i] = (struct want){ dir, 2, 100 + scale * (x * c - y * s), 50 + scale * (x * s + y * c) };
        }
        begin(0, "pattern.points { " AT "list = { %s }, scale = %.17g, turns = %s }", dir, 2.0, list, scale,
              turned ? "true" : "false");
        same_bullets(w, (uint32_t)n);
        rig_close(&rig);
    }
}

/* Blanks round a picture are none of it, dots are; a bullet is numbered as it is read. */
TEST(picture)
{
    static const struct {
        const char *dots;
        double turned, x[4], y[4];
    } of[] = {
        { "x", 0, { 0 }, { 0 } },
        { "##\\n##", 0, { -5, 5, -5, 5 }, { -5, -5, 5, 5 } },
        { "\\n   #.#\\n    #\\n  \\n", 0, { -10, 10, 0 }, { -5, -5, 5 } },
        { "#..", 0, { -10 }, { 0 } },
        { "...\\n..~\\n...", 0, { 10 }, { 0 } },
        { "ab", 1, { 0, 0 }, { -5, 5 } }, /* dir = 90: what was to the right is below */
    };

    for (size_t i = 0; i < sizeof of / sizeof *of; i++) {
        struct want w[4];
        uint32_t n = 0;
        for (const char *c = of[i].dots; *c; c++)
            if (c[0] == '\\' && c[1] == 'n')
                c++;
            else if (*c != ' ' && *c != '.')
                w[n] = (struct want){ 90, 1, 100 + of[i].x[n], 50 + of[i].y[n] }, n++;
        begin(0, "pattern.picture { kind = 'dot', x = 100, y = 50, speed = 1, gap = 10, dots = \"%s\", turns = %s }",
              of[i].dots, of[i].turned != 0 ? "true" : "false");
        same_bullets(w, n);
        rig_close(&rig);
    }
}

/* ---- what all of them do ---- */

/* Each fires 12 by a call that lacks its end. */
static const char *const twelve[] = {
    "ring { n = 12,",
    "fan { n = 12, spread = 30,",
    "arc { n = 12, sweep = 30,",
    "stack { n = 12, speed_to = 2,",
    "line { n = 12, width = 30,",
    "spiral { n = 4, arms = 3, step = 9, every = 1,",
    "aimed { n = 12, every = 1,",
    "polygon { n = 12, sides = 4,",
    "star { n = 12, points = 3,",
    "ellipse { n = 12, speed_to = 2,",
    "rose { n = 12, petals = 3, speed_to = 2,",
    "whip { n = 12, speed_to = 2, bend = 30,",
    "scatter { n = 12, spread = 90, speed_to = 2,",
    "points { list = { {1,1},{2,2},{3,3},{4,4},{5,5},{6,6},{7,7},{8,8},{9,9},{10,10},{11,11},{12,12} },",
    "picture { dots = 'xxxx\\nxxxx\\nxxxx',",
};
enum { PATTERNS = sizeof twelve / sizeof *twelve };

static void fire_twelve(int which, const char *more)
{
    begin(20,
          "task.go(function() pattern.%s kind = 'dot', x = 50, y = 50, speed = 1, motion = motion.def { { speed = 0 "
          "} }, %s } end)",
          twelve[which], more);
    rig_sound(&rig);
}

/* A gap leaves out what it names, from `first` to `last`, and changes nothing else; chance is drawn all the same. */
TEST(skip)
{
    static const int gaps[][2] = { { 1, 1 }, { 5, 8 }, { -3, 2 }, { 11, 99 } };

    for (int k = 0; k < PATTERNS; k++) {
        fx x[12], y[12];
        ang dir[12];
        uint64_t random[4];
        fire_twelve(k, "");
        const struct bullets *p = &rig.b->bullets;
        assert_int_equal(p->s.live, 12);
        memcpy(x, p->x, sizeof x), memcpy(y, p->y, sizeof y), memcpy(dir, p->dir, sizeof dir);
        memcpy(random, rig.b->core.random, sizeof random);
        rig_close(&rig);
        for (size_t q = 0; q < sizeof gaps / sizeof *gaps; q++) {
            char more[60];
            uint32_t n = 0;
            snprintf(more, sizeof more, "skip = { %d, %d }", gaps[q][0], gaps[q][1]);
            fire_twelve(k, more);
            p = &rig.b->bullets;
            for (int i = 0; i < 12; i++) {
                if (i + 1 >= gaps[q][0] && i + 1 <= gaps[q][1])
                    continue;
                assert_true(dir[i] == p->dir[n]);
                if (k != 5 && k != 6) /* those that take time have flown less far */
                    assert_true(x[i] == p->x[n] && y[i] == p->y[n]);
                n++;
            }
            assert_int_equal(p->s.live, n);
            assert_memory_equal(random, rig.b->core.random, sizeof random);
            rig_close(&rig);
        }
    }
}

/* `each` gets numbers that count from 1, in order, and arguments that bullet.fire takes; skipped ones are not asked. */
TEST(each)
{
    for (int k = 0; k < PATTERNS; k++) {
        fire_twelve(k, "skip = { 4, 6 }, each = function(a, i) board.note(i) string.all = (string.all or '') .. i .. "
                       "' ' if i == 12 then assert(string.all == '1 2 3 7 8 9 10 11 12 ', string.all) end "
                       "a.n, a.spread = 3, 9 pattern.fan(a) end");
        assert_int_equal(rig.b->bullets.s.live, 27);
        rig_close(&rig);
    }
}

/* The same directions, speeds and places from the pool of shots; up where nothing else is said; a shot of player 1. */
TEST(shots)
{
    for (int k = 0; k < PATTERNS; k++) {
        fx x[12], y[12];
        ang dir[12];
        fire_twelve(k, "dir = -90");
        memcpy(x, rig.b->bullets.x, sizeof x), memcpy(y, rig.b->bullets.y, sizeof y);
        memcpy(dir, rig.b->bullets.dir, sizeof dir);
        bool aims = !strncmp(twelve[k], "aimed", 5);
        rig_close(&rig);
        begin(20,
              "sys.join(1, 'ship') task.go(function() pattern.%s kind = 'bolt', x = 50, y = 50, speed = 1, motion = "
              "motion.def { { speed = 0 } }, fire = 'shot', by = player.get(1) } end)",
              twelve[k]);
        rig_sound(&rig);
        assert_int_equal(rig.b->bullets.s.live, 0);
        assert_int_equal(rig.b->shots.s.live, 12);
        for (int i = 0; i < 12; i++) {
            assert_true(rig.b->shots.dir[i] == (aims ? 0xc0000000u : dir[i]) && rig.b->shots.player[i] == 1);
            assert_true(aims || (x[i] == rig.b->shots.x[i] && y[i] == rig.b->shots.y[i]));
        }
        rig_close(&rig);
    }
}

/* Aimed figures point at the player, of shots at the enemy; side by side, from their middle. */
TEST(aim)
{
    for (int shots = 0; shots < 2; shots++) {
        for (int k = 0; k < PATTERNS; k++) {
            if (!strncmp(twelve[k], "scatter", 7) || !strncmp(twelve[k], "fan", 3))
                continue; /* none of their bullets need fly along dir */
            begin(20,
                  "sys.join(1, 'ship') task.go(function() local p, e = player.get(1), enemy.spawn { kind = 'foe', x = "
                  "90, y = 20 } p.x, p.y = 90, 20 pattern.%s kind = '%s', x = 50, y = 50, speed = 1, motion = "
                  "motion.def { { speed = 0 } }, aim = true, fire = '%s' } end)",
                  twelve[k], shots ? "bolt" : "dot", shots ? "shot" : "bullet");
            rig_sound(&rig);
            const struct bullets *p = shots ? &rig.b->shots : &rig.b->bullets;
            assert_int_equal(p->s.live, 12);
            if (labs((int32_t)(p->dir[0] - trig_atan2(-30 * 65536, 40 * 65536))) > 8)
                fail_msg("%s does not aim", twelve[k]);
            rig_close(&rig);
        }
    }
}

/* The message is longer than a line of tests/scripts. */
TEST(owner_in_place_of_arguments)
{
    begin(2, "task.own(enemy.spawn { kind = 'foe', x = 9, y = 9 }, pattern.ring, { kind = 'dot', n = 3 })");
    assert_non_null(rig_fault(&rig));
    assert_string_equal(rig_fault(&rig)->message,
                        "main.lua:6: pattern.ring: expected a table of named arguments, got an enemy (a task passes "
                        "its owner as the first argument: write `function(e) ... end`)");
    rig_close(&rig);
}

int main(void)
{
    rng_seed(&rng, 20);
    return run_all_tests(NULL, NULL);
}
