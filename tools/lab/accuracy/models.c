/*
 * models.c - section 8: what a scene may choose, and what each choice costs, by the engine's own code: hits of a crowd
 * that stands close to a player, and frames of a crowd that flies.
 */
#include <math.h>
#include <string.h>
#include "engine.h"
#include "lab.h"

enum { CROWD = 16384, CLOSE = 4096, MANY = 1 << 18 };

/* ---- hits ---- */

/* A kind of bullet, close to the player: what is tried, and what a scene loses by it. */
struct choice {
    const char *name, *loses, *who;
    uint8_t shape, flags;
};

static const struct choice CHOICES[] = {
    { "`hit = { circle = 4 }`", "nothing, because it is exact along the whole path", "everything", SHAPE_CIRCLE,
      KIND_GRAZE | KIND_SWEPT },
    { "`swept = false`", "hits between two frames (section 2)",
      "dense clouds of bullets that move less than half the sum of both radii per frame", SHAPE_CIRCLE, KIND_GRAZE },
    { "`graze = false`", "grazing", "bullets that must not be grazed", SHAPE_CIRCLE, KIND_SWEPT },
    { "`hit = { box = { 8, 8 } }`", "nothing if the sprite is a box", "long and square objects", SHAPE_BOX,
      KIND_GRAZE | KIND_SWEPT },
    { "`hit = { box = { 8, 8 } }, swept = false`", "the same as above, and hits between two frames", "avoid", SHAPE_BOX,
      KIND_GRAZE },
    { "`hit = \"none\"`", "all hits", "decoration", SHAPE_NONE, 0 },
};
enum { N_CHOICES = sizeof CHOICES / sizeof *CHOICES, ROUND = 0, SQUARE = 3 };

/* A circle with the flags the API gives a kind that says nothing; a shape has to be said. */
static bool is_standard(const struct choice *c)
{
    int flags = (!strcmp(engine_default("bullet.def", "swept"), "true") ? KIND_SWEPT : 0) |
                (!strcmp(engine_default("bullet.def", "graze"), "true") ? KIND_GRAZE : 0);

    return c->shape == SHAPE_CIRCLE && c->flags == flags;
}

static void run_hits(void *data)
{
    lab_sink += engine_hits(data);
}

/* A board where n bullets of that kind fly within 24 px of the player, who has a graze ring of 16 px. */
static struct board *close_crowd(const struct choice *c, int n)
{
    struct board *b = engine_power((uint32_t)n, 0, 0);
    uint16_t kind = c->shape == SHAPE_CIRCLE ? engine_circle(&b->bullet_kinds, PX(4), true)
                                             : engine_box(&b->bullet_kinds, PX(4), PX(4), true);
    struct rng r;

    rng_seed(&r, 81);
    b->bullet_kinds.shape[kind] = c->shape;
    b->bullet_kinds.flags[kind] = c->flags;
    engine_player(b, PX(2), PX(160), PX(120), PX(1), 0);
    b->player_kinds.graze_radius[0] = PX(16);
    for (int i = 0; i < n; i++) {
        fx v[4];
        for (int k = 0; k < 4; k++)
            v[k] = (fx)rng_below(&r, (k < 2 ? 48 : 6) * FX_ONE) - PX(k < 2 ? 24 : 3);
        engine_bullet(&b->bullets, kind, PX(160) + v[0], PX(120) + v[1], v[2], v[3]);
    }
    return b;
}

static double hits_of_many(const struct choice *c)
{
    struct board *b = close_crowd(c, MANY);
    double hits;

    engine_hits(b);
    hits = (double)b->counts.hit;
    engine_free(b);
    return hits;
}

static void print_choices(void)
{
    struct lab_rival rivals[N_CHOICES];
    double corners = 1 - hits_of_many(&CHOICES[ROUND]) / hits_of_many(&CHOICES[SQUARE]);

    for (int i = 0; i < N_CHOICES; i++)
        rivals[i] = (struct lab_rival){ .run = run_hits, .data = close_crowd(&CHOICES[i], CLOSE), .ops = CLOSE };
    lab_time(rivals, N_CHOICES, 0);
    report_table("Options of `bullet.def`, `shot.def` and `enemy.def` (`enemy.def` has no `graze`)",
                 "choice | loss | time per bullet close to a player> | ratio> | use");
    for (int i = 0; i < N_CHOICES; i++) {
        const char *loses = i != SQUARE ? CHOICES[i].loses
                                        : report_string("%s; for a round bullet, %s of the hits are false",
                                                        CHOICES[i].loses, report_percent(corners));
        report_row(is_standard(&CHOICES[i]), CHOICES[i].name, loses, lab_ns(&rivals[i]), lab_ratio(&rivals[i]),
                   CHOICES[i].who, NULL);
        engine_free(rivals[i].data);
    }
    report_table_end();
    lab_claim(is_standard(&CHOICES[ROUND]), "a kind is swept and grazed unless it says otherwise");
    lab_claim(corners > 0.1 && corners < 0.3, "a box around a round bullet of r = 4 px has a fifth more hits");
}

/* ---- motion ---- */

struct flight {
    const char *name, *keeps, *who;
    struct motion_step steps[4];
    int n;
    bool program, fine;
};

#define LOOP(...)                                                                                                      \
    {                                                                                                                  \
        { .actions = DOES_LOOP, .count = MOTION_FOREVER, .jump = 3 }, __VA_ARGS__,                                     \
        {                                                                                                              \
            .actions = DOES_LOOP_END, .jump = 1                                                                        \
        }                                                                                                              \
    }

static const struct flight FLIGHTS[] = {
    { "straight", "position and velocity to 16 fractional bits", "nearly all bullets", { { 0 } }, 0, false, false },
    { "a program: `turn`, `speed`", "the same", "curves",
      LOOP({ .actions = DOES_TURN | DOES_SPEED, .duration = 60, .turn = 11930465, .speed = (int64_t)1 << 24 }), 3, true,
      false },
    { "`fine = true`, straight",
      "position, velocity and direction of travel to 32 fractional bits",
      "bullets that move slowly or live for minutes",
      { { 0 } },
      0,
      true,
      true },
    { "`fine = true`, `turn`, `speed`",
      "32 fractional bits; a speed change ends exactly where the closed form puts the bullet",
      "curves that last for minutes",
      LOOP({ .actions = DOES_TURN | DOES_SPEED, .duration = 60, .turn = 11930465, .speed = (int64_t)1 << 24 }), 3, true,
      true },
};
enum { N_FLIGHTS = sizeof FLIGHTS / sizeof *FLIGHTS };

/* The speed is rounded as the script border rounds it: to 2^-32 if fine, else to 2^-16. */
static struct board *flying_crowd(const struct flight *f, int n, double speed)
{
    struct board *b = engine_power((uint32_t)n, 0, 0);
    struct bullet_spec s = { .kind = engine_circle(&b->bullet_kinds, 0, true), .is_fine = f->fine };

    if (f->program)
        s.motion = (uint16_t)(motion_define(&b->motions, &b->steps, f->steps, (uint32_t)f->n, f->fine) + 1);
    for (int i = 0; i < n; i++) {
        s.dir = (ang)i * 2654435769u;
        uint32_t slot = (uint32_t)bullets_fire(&b->bullets, &s, 0);
        bullets_set_speed(&b->bullets, slot,
                          f->fine ? fx_nearest(speed * 4294967296.0) : fx_nearest(speed * 65536) * 65536);
    }
    return b;
}

static void run_frame(void *data)
{
    engine_move(data, &ENGINE_EVERYWHERE);
}

/* The largest drift of 32 headings at 0.002 px a frame. */
static double drift(const struct flight *f, int frames)
{
    const double speed = 0.002;
    struct board *b = flying_crowd(f, 32, speed);
    double worst = 0;

    for (int i = 0; i < frames; i++)
        engine_move(b, &ENGINE_EVERYWHERE);
    for (uint32_t i = 0; i < 32; i++) {
        double c, s;
        int64_t x, y;
        lab_direction(b->bullets.dir[i] / 4294967296.0, &c, &s);
        bullets_get_position(&b->bullets, i, &x, &y);
        double ex = (double)x / 4294967296.0 - speed * frames * c, ey = (double)y / 4294967296.0 - speed * frames * s;
        double e = sqrt(ex * ex + ey * ey);
        worst = e > worst ? e : worst;
    }
    engine_free(b);
    return worst;
}

static void print_flights(void)
{
    struct lab_rival rivals[N_FLIGHTS];
    double plain = drift(&FLIGHTS[0], 36000), fine = drift(&FLIGHTS[2], 36000);

    for (int i = 0; i < N_FLIGHTS; i++)
        rivals[i] =
            (struct lab_rival){ .run = run_frame, .data = flying_crowd(&FLIGHTS[i], CROWD, 0.001), .ops = CROWD };
    lab_time(rivals, N_FLIGHTS, 0);
    report_table("Ways to move a bullet", "choice | precision | drift at 0.002 px/frame after 600 frames> | after "
                                          "36,000> | time per bullet and frame> | ratio> | use");
    for (int i = 0; i < N_FLIGHTS; i++) {
        bool turns = FLIGHTS[i].n > 0;
        report_row(i == 0, FLIGHTS[i].name, FLIGHTS[i].keeps,
                   turns ? "-" : report_string("%s px", report_figure(drift(&FLIGHTS[i], 600))),
                   turns ? "-" : report_string("%s px", report_figure(i ? fine : plain)), lab_ns(&rivals[i]),
                   lab_ratio(&rivals[i]), FLIGHTS[i].who, NULL);
        engine_free(rivals[i].data);
    }
    report_table_end();
    lab_conclude("fine motion", "off",
                 report_string("`fine = true` drifts by %s px in 36,000 frames instead of %s px, but is slower",
                               report_figure(fine), report_figure(plain)),
                 "use `fine = true` for slow bullets that live for minutes",
                 fine < 1e-5 && plain > 0.1 && (lab_exact() || rivals[2].ratio > 2));
}

/* ---- chips ---- */

static void print_rooms(void)
{
    static const struct {
        const char *name;
        const struct chip *chip;
        uint32_t usual;
    } ROOMS[] = { { "bullets", &bullets_chip, 8192 },
                  { "shots", &shots_chip, 512 },
                  { "enemies", &enemies_chip, 256 },
                  { "sparks", &sparks_chip, 2048 },
                  { "sprites", &sprites_chip, 256 } };

    report_table("RAM of each chip; a chip whose capacity is 0 in rom.lua uses none",
                 "chip | bytes per slot> | default capacity> | KiB in total>");
    for (size_t i = 0; i < sizeof ROOMS / sizeof *ROOMS; i++)
        report_row(false, ROOMS[i].name,
                   report_count(
                       (int64_t)(slots_size(ROOMS[i].chip, 1 << 16, 0) - slots_size(ROOMS[i].chip, 1 << 15, 0)) >> 15),
                   report_count(ROOMS[i].usual),
                   report_count((int64_t)slots_size(ROOMS[i].chip, ROOMS[i].usual, 0) / 1024), NULL);
    report_table_end();
}

void section_models(void)
{
    report_section("8. Choices in a scene");
    report_text("The defaults are exact. Only bullets close to a player need a hit test. The motion pass finds these "
                "bullets, and takes\n"
                "the same time for every kind.");
    print_choices();
    print_flights();
    print_rooms();
}
