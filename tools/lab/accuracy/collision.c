/*
 * collision.c - section 2: does a bullet touch the player? Shapes, and what lies between two frames.
 *
 * Two circles touch when their centres are at most r apart, r being the sum of their radii; so a player is a point
 * here, and r is the bullet's radius with the player's in it. Rivals are asked about two things: where a bullet stands
 * (areas), and whether it touched on its way past the player (crossings). The truth of a crossing is one exact test of
 * the whole way (touches.h).
 */
#include <math.h>
#include <string.h>
#include "../../../src/base/geom.h"
#include "engine.h"
#include "lab.h"
#include "leaving.h"
#include "touches.h"

enum { RADII = 7, SPEEDS = 7, TRIALS = 4096, NONE = -1 };

static const int RADIUS[RADII] = { 2, 4, 8, 16, 32, 64, 160 };
static const int SPEED[SPEEDS] = { 1, 2, 4, 8, 16, 32, 64 };
static const fx PLAYER_X = 192 * 65536 + 24001, PLAYER_Y = 352 * 65536 + 51007;

/* ---- the rivals: a bullet now at (x, y), that came by (vx, vy), and a circle of radius r around (px, py) ---- */

struct pair {
    fx x, y, vx, vy, px, py, r;
};

static bool swept_circle(const struct pair *p)
{
    return geom_swept_circles((int64_t)p->x - p->vx - p->px, (int64_t)p->y - p->vy - p->py, p->vx, p->vy, p->r);
}

static bool circle(const struct pair *p)
{
    return geom_circles(p->x, p->y, p->px, p->py, p->r);
}

/* At the end of each n-th part of the frame. */
static bool substeps(const struct pair *p, int n)
{
    bool any = false;

    for (int i = 0; i < n; i++)
        any |= geom_circles(p->x - p->vx / n * i, p->y - p->vy / n * i, p->px, p->py, p->r);
    return any;
}

static bool two_parts(const struct pair *p)
{
    return substeps(p, 2);
}

static bool four_parts(const struct pair *p)
{
    return substeps(p, 4);
}

static bool box(const struct pair *p, fx half)
{
    return geom_boxes(p->x, p->y, half, half, p->px, p->py, 0, 0);
}

static bool box_around(const struct pair *p)
{
    return box(p, p->r);
}

/* r / sqrt(2), and r * sqrt(pi) / 2, in 2^-16. */
static bool box_inside(const struct pair *p)
{
    return box(p, (fx)((int64_t)p->r * 46341 >> 16));
}

static bool box_equal(const struct pair *p)
{
    return box(p, (fx)((int64_t)p->r * 58081 >> 16));
}

/* Squares kept in Q15.16, as fast fixed-point code has them: from 181 px on they overflow. */
static bool fx_squares(const struct pair *p)
{
    int32_t dx = (int32_t)((uint32_t)p->x - (uint32_t)p->px), dy = (int32_t)((uint32_t)p->y - (uint32_t)p->py);
    uint32_t xx = (uint32_t)((int64_t)dx * dx >> 16), yy = (uint32_t)((int64_t)dy * dy >> 16);

    return (int32_t)(xx + yy) <= (int32_t)((int64_t)p->r * p->r >> 16);
}

/* The other shapes: a player of 2 px; a capsule as long as 16 frames. */

static const fx SHIP = 2 * 65536;

static bool circle_box(const struct pair *p)
{
    return geom_circle_box(p->px, p->py, SHIP, p->x, p->y, p->r, p->r);
}

static bool capsule(const struct pair *p)
{
    return geom_capsule_circle(p->x, p->y, p->x + 16 * p->vx, p->y + 16 * p->vy, p->r - SHIP, p->px, p->py, SHIP);
}

static bool swept_circle_box(const struct pair *p)
{
    return geom_swept_circle_box((int64_t)p->x - p->vx - p->px, (int64_t)p->y - p->vy - p->py, p->vx, p->vy, SHIP, p->r,
                                 p->r);
}

static bool swept_boxes(const struct pair *p)
{
    return geom_swept_boxes((int64_t)p->x - p->vx - p->px, (int64_t)p->y - p->vy - p->py, p->vx, p->vy, p->r, p->r);
}

static bool float_circle(const struct pair *p)
{
    float dx = (float)p->x / 65536 - (float)p->px / 65536, dy = (float)p->y / 65536 - (float)p->py / 65536;
    float r = (float)p->r / 65536;

    return dx * dx + dy * dy <= r * r;
}

static bool root_circle(const struct pair *p)
{
    float dx = (float)p->x / 65536 - (float)p->px / 65536, dy = (float)p->y / 65536 - (float)p->py / 65536;

    return sqrtf(dx * dx + dy * dy) <= (float)p->r / 65536;
}

static bool pixel_circle(const struct pair *p)
{
    int dx = (p->x >> 16) - (p->px >> 16), dy = (p->y >> 16) - (p->py >> 16), r = p->r >> 16;

    return dx * dx + dy * dy <= r * r;
}

/* ---- times: each rival in a loop of its own, so that its test is compiled into it ---- */

static struct pair pairs[LAB_VALUES];

#define LOOP(name)                                                                                                     \
    static void name##_loop(void *data)                                                                                \
    {                                                                                                                  \
        int64_t sum = 0;                                                                                               \
                                                                                                                       \
        (void)data;                                                                                                    \
        for (int i = 0; i < LAB_VALUES; i++)                                                                           \
            sum += name(&pairs[i]);                                                                                    \
        lab_sink = sum;                                                                                                \
    }
LOOP(swept_circle)
LOOP(circle)
LOOP(two_parts)
LOOP(four_parts)
LOOP(box_around)
LOOP(box_inside)
LOOP(box_equal)
LOOP(fx_squares)
LOOP(float_circle)
LOOP(root_circle)
LOOP(pixel_circle)
LOOP(circle_box)
LOOP(capsule)
LOOP(swept_circle_box)
LOOP(swept_boxes)

/* The engine's shapes. */
static const struct {
    const char *name;
    void (*loop)(void *data);
} SHAPES[] = {
    { "circle and circle", circle_loop },           { "box and box", box_around_loop },
    { "circle and box", circle_box_loop },          { "circle and circle, swept", swept_circle_loop },
    { "box and box, swept", swept_boxes_loop },     { "circle and box, swept", swept_circle_box_loop },
    { "capsule (laser) and circle", capsule_loop },
};
enum { N_SHAPES = sizeof SHAPES / sizeof *SHAPES };

static const struct rival {
    const char *name, *trade;
    bool (*touch)(const struct pair *p);
    void (*loop)(void *data);
    const char *who;
} RIVALS[] = {
    { "circle, swept", "nothing, because it is exact along the whole path", swept_circle, swept_circle_loop,
      "everything" },
    { "circle", "hits between two frames", circle, circle_loop, "bullets that move less than r/2 per frame" },
    { "circle, 2 substeps", "hits between two substeps", two_parts, two_parts_loop,
      "avoid: misses hits, and is slower than the swept test for distant bullets" },
    { "circle, 4 substeps", "hits between two substeps", four_parts, four_parts_loop,
      "avoid: misses hits, and is slower than the swept test for distant bullets" },
    { "box around the circle", "false hits in the corners", box_around, box_around_loop, "objects drawn as boxes" },
    { "box inside the circle", "hits at the rim", box_inside, box_inside_loop, "a lenient game" },
    { "box of equal area", "hits at the rim; false hits in the corners", box_equal, box_equal_loop, "avoid" },
    { "circle, Q15.16 squares", "distances beyond 181 px", fx_squares, fx_squares_loop, "avoid" },
    { "circle, float32", "accuracy at the rim", float_circle, float_circle_loop, "a game without replays" },
    { "circle, float32 and a root", "accuracy at the rim; the time for a root", root_circle, root_circle_loop,
      "avoid" },
    { "circle, whole pixels", "subpixels", pixel_circle, pixel_circle_loop, "8-bit processors" },
};
enum {
    COUNT = sizeof RIVALS / sizeof *RIVALS,
    SWEPT = 0,
    CIRCLE = 1,
    TWO = 2,
    FOUR = 3,
    AROUND = 4,
    INSIDE = 5,
    SQUARES = 7,
    ROOT = 9
};

/* ---- crossings ---- */

/* Bullets that fly past the player: where they are before the first frame, and their velocity. */
struct crossing {
    fx x[TRIALS], y[TRIALS], vx[TRIALS], vy[TRIALS];
    bool hits[TRIALS]; /* the truth */
    int n_hits, frames;
};
static struct crossing crossing;

/* Aimed at up to 1.5 r + 1 px beside the player, from every direction, at every fraction of a step. */
static void set_crossing(int radius, int speed)
{
    struct crossing *c = &crossing;
    double reach = 1.5 * radius + 1;
    struct rng r;

    rng_seed(&r, (uint64_t)(radius * 100 + speed));
    c->n_hits = 0;
    c->frames = (int)(2 * reach / speed) + 3;
    for (int i = 0; i < TRIALS; i++) {
        double cos_a, sin_a, beside = lab_random(&r, -reach, reach);
        double back = reach + speed * (1 + lab_random(&r, 0, 1));
        lab_direction(lab_random(&r, 0, 1), &cos_a, &sin_a);
        c->vx[i] = (fx)floor(speed * cos_a * 65536);
        c->vy[i] = (fx)floor(speed * sin_a * 65536);
        c->x[i] = PLAYER_X + (fx)floor((-back * cos_a - beside * sin_a) * 65536);
        c->y[i] = PLAYER_Y + (fx)floor((-back * sin_a + beside * cos_a) * 65536);
        c->hits[i] = touches_truly((int64_t)c->x[i] - PLAYER_X, (int64_t)c->y[i] - PLAYER_Y,
                                   (int64_t)c->vx[i] * c->frames, (int64_t)c->vy[i] * c->frames, (int64_t)radius << 16);
        c->n_hits += c->hits[i];
    }
}

static bool meets(bool (*touch)(const struct pair *), int i, int radius)
{
    const struct crossing *c = &crossing;
    struct pair p = { c->x[i], c->y[i], c->vx[i], c->vy[i], PLAYER_X, PLAYER_Y, radius << 16 };

    for (int f = 0; f < c->frames; f++) {
        p.x += p.vx;
        p.y += p.vy;
        if (touch(&p))
            return true;
    }
    return false;
}

/* Both as shares of the true crossings. */
struct wrong {
    double missed, false_hits;
};
static struct wrong wrong[COUNT][RADII][SPEEDS];

static void count(struct wrong *w, bool met, bool truly)
{
    w->missed += (truly && !met) / (double)crossing.n_hits;
    w->false_hits += (met && !truly) / (double)crossing.n_hits;
}

/* The engine's row: a board with all of them flies, and its hits are read from its events. */
static void engine_crossing(struct wrong *w, int radius, bool swept)
{
    static bool met[TRIALS];
    struct board *b = engine_power(TRIALS, 0, 0);
    uint16_t kind = engine_circle(&b->bullet_kinds, PX(radius) - PX(1), swept);

    memset(met, 0, sizeof met);
    engine_player(b, PX(1), PLAYER_X, PLAYER_Y, 0, 0);
    for (int i = 0; i < TRIALS; i++)
        engine_bullet(&b->bullets, kind, crossing.x[i], crossing.y[i], crossing.vx[i], crossing.vy[i]);
    for (int f = 0; f < crossing.frames; f++) {
        engine_board_frame(b, &ENGINE_EVERYWHERE);
        for (uint32_t k = 0; k < b->events.n; k++)
            met[handle_slot(b->events.b[k])] = true;
    }
    for (int i = 0; i < TRIALS; i++)
        count(w, met[i], crossing.hits[i]);
    engine_free(b);
}

static void cross_all(void)
{
    for (int r = 0; r < RADII; r++)
        for (int s = 0; s < SPEEDS; s++) {
            set_crossing(RADIUS[r], SPEED[s]);
            for (int k = 0; k < COUNT; k++) {
                if (k == SWEPT || k == CIRCLE) {
                    engine_crossing(&wrong[k][r][s], RADIUS[r], k == SWEPT);
                    continue;
                }
                for (int i = 0; i < TRIALS; i++)
                    count(&wrong[k][r][s], meets(RIVALS[k].touch, i, RADIUS[r]), crossing.hits[i]);
            }
        }
}

/* ---- areas ---- */

/* In px^2, over places within 384 px and 448 px of the player on the axes: a field, seen from its corner. */
struct area {
    double false_hits, missed, of;
};

/* A lattice of cells, a place in each; those for which `skip` is set leave out the middle. */
static void add_lattice(struct area *a, bool (*touch)(const struct pair *), int radius, double half_x, double half_y,
                        double middle)
{
    enum { CELLS = 256 };
    struct rng r;
    double w = 2 * half_x / CELLS, h = 2 * half_y / CELLS;

    rng_seed(&r, (uint64_t)radius);
    for (int i = 0; i < CELLS * CELLS; i++) {
        double dx = (i % CELLS + lab_random(&r, 0, 1)) * w - half_x;
        double dy = ((double)(i / CELLS) + lab_random(&r, 0, 1)) * h - half_y;
        if (fabs(dx) < middle && fabs(dy) < middle)
            continue;
        struct pair p = {
            PLAYER_X + (fx)floor(dx * 65536), PLAYER_Y + (fx)floor(dy * 65536), 0, 0, PLAYER_X, PLAYER_Y, radius << 16
        };
        bool truly = touches_truly((int64_t)p.x - PLAYER_X, (int64_t)p.y - PLAYER_Y, 0, 0, p.r), met = touch(&p);
        a->false_hits += met && !truly ? w * h : 0;
        a->missed += truly && !met ? w * h : 0;
        a->of += truly ? w * h : 0;
    }
}

static struct area areas[COUNT][RADII];

static void measure_areas(void)
{
    for (int k = 0; k < COUNT; k++)
        for (int r = 0; r < RADII; r++) {
            double near = 1.1 * RADIUS[r] + 1;
            add_lattice(&areas[k][r], RIVALS[k].touch, RADIUS[r], near, near, 0);
            add_lattice(&areas[k][r], RIVALS[k].touch, RADIUS[r], 384, 448, near);
        }
}

/* The share of places within 2 ulp of the rim that are judged wrong. */
static double rim(bool (*touch)(const struct pair *), int radius)
{
    enum { PLACES = 16384 };
    struct rng r;
    int bad = 0;

    rng_seed(&r, 9);
    for (int i = 0; i < PLACES; i++) {
        double c, s, far = radius * 65536.0 + lab_random(&r, -2, 2);
        lab_direction(lab_random(&r, 0, 1), &c, &s);
        struct pair p = { PLAYER_X + (fx)floor(far * c + 0.5),
                          PLAYER_Y + (fx)floor(far * s + 0.5),
                          0,
                          0,
                          PLAYER_X,
                          PLAYER_Y,
                          radius << 16 };
        bad += touch(&p) != touches_truly((int64_t)p.x - PLAYER_X, (int64_t)p.y - PLAYER_Y, 0, 0, p.r);
    }
    return (double)bad / PLACES;
}

/* ---- the page ---- */

/* Pairs all over a field, or all within 1.5 r: r = 8 px, 4 px/frame. */
static void set_pairs(bool near)
{
    struct rng r;

    rng_seed(&r, near);
    for (int i = 0; i < LAB_VALUES; i++) {
        double c, s;
        lab_direction(lab_random(&r, 0, 1), &c, &s);
        pairs[i] = (struct pair){ PLAYER_X + (fx)(65536 * (near ? lab_random(&r, -12, 12) : lab_random(&r, -192, 192))),
                                  PLAYER_Y + (fx)(65536 * (near ? lab_random(&r, -12, 12) : lab_random(&r, -352, 96))),
                                  (fx)(4 * 65536 * c),
                                  (fx)(4 * 65536 * s),
                                  PLAYER_X,
                                  PLAYER_Y,
                                  PX(8) };
    }
}

/* Fills in what to run before. */
static void time_both(struct lab_rival *far, struct lab_rival *near, int n)
{
    memcpy(near, far, (size_t)n * sizeof *near);
    set_pairs(false);
    lab_time(far, n, 0);
    set_pairs(true);
    lab_time(near, n, 0);
}

static void time_rivals(struct lab_rival *far, struct lab_rival *near)
{
    for (int i = 0; i < COUNT; i++)
        far[i] = (struct lab_rival){ .run = RIVALS[i].loop, .ops = LAB_VALUES };
    time_both(far, near, COUNT);
}

static void print_shapes(void)
{
    struct lab_rival far[N_SHAPES], near[N_SHAPES];

    for (int i = 0; i < N_SHAPES; i++)
        far[i] = (struct lab_rival){ .run = SHAPES[i].loop, .ops = LAB_VALUES };
    time_both(far, near, N_SHAPES);
    report_table("Cost per pair for the engine's shapes", "shapes | time, near> | ratio> | time, far> | ratio>");
    for (int i = 0; i < N_SHAPES; i++)
        report_row(false, SHAPES[i].name, lab_ns(&near[i]), lab_ratio(&near[i]), lab_ns(&far[i]), lab_ratio(&far[i]),
                   NULL);
    report_table_end();
}

static int radius_index(int radius)
{
    int i = 0;

    while (RADIUS[i] != radius)
        i++;
    return i;
}

static int speed_index(int speed)
{
    int i = 0;

    while (SPEED[i] != speed)
        i++;
    return i;
}

/* As the API has it: a circle, swept or not. */
static bool is_standard(int rival)
{
    return rival == (strcmp(engine_default("bullet.def", "swept"), "true") ? CIRCLE : SWEPT);
}

static void print_rivals(const struct lab_rival *far, const struct lab_rival *near)
{
    const int r4 = radius_index(4), r160 = radius_index(160), s16 = speed_index(16);

    report_table(NULL, "test | gives up | false area, r = 160 px> | missed area> | wrong results within 2 ulp of the "
                       "rim> | use");
    for (int i = 0; i < COUNT; i++) {
        const struct area *a = &areas[i][r160];
        report_row(is_standard(i), RIVALS[i].name, RIVALS[i].trade,
                   report_string("%s px²", report_figure(a->false_hits)),
                   report_string("%s px²", report_figure(a->missed)), report_percent(rim(RIVALS[i].touch, 160)),
                   RIVALS[i].who, NULL);
    }
    report_table_end();
    report_table(NULL,
                 "test | crossings missed at r = 4 px and 16 px/frame> | false hits> | time per pair, near> | time, "
                 "far> | ratio, far>");
    for (int i = 0; i < COUNT; i++)
        report_row(is_standard(i), RIVALS[i].name, report_percent(wrong[i][r4][s16].missed),
                   report_percent(wrong[i][r4][s16].false_hits), lab_ns(&near[i]), lab_ns(&far[i]), lab_ratio(&far[i]),
                   NULL);
    report_table_end();
}

/* Crossings missed without a sweep at half_contacts / 2 contacts a frame, over all radii that were flown past so. */
static double missed_at(int half_contacts)
{
    double sum = 0;
    int n = 0;

    for (int r = 0; r < RADII; r++)
        for (int s = 0; s < SPEEDS; s++)
            if (2 * SPEED[s] == half_contacts * RADIUS[r]) {
                sum += wrong[CIRCLE][r][s].missed;
                n++;
            }
    return sum / n;
}

static const char *triple(int r, int s)
{
    return report_string("%s / %s / %s", report_percent(wrong[CIRCLE][r][s].missed),
                         report_percent(wrong[TWO][r][s].missed), report_percent(wrong[FOUR][r][s].missed));
}

static const char *twin(int r, int s)
{
    return report_string("%s / %s", report_percent(wrong[AROUND][r][s].missed),
                         report_percent(wrong[AROUND][r][s].false_hits));
}

/* Rows are radii, columns are speeds. */
static void print_grid(const char *title, const char *(*cell)(int r, int s))
{
    report_table(title, "r> | 1 px/frame> | 2> | 4> | 8> | 16> | 32> | 64>");
    for (int r = 0; r < RADII; r++)
        report_row(false, report_string("%d px", RADIUS[r]), cell(r, 0), cell(r, 1), cell(r, 2), cell(r, 3), cell(r, 4),
                   cell(r, 5), cell(r, 6), NULL);
    report_table_end();
}

static void plot_misses(void)
{
    double x[SPEEDS], y[SPEEDS];

    report_plot(&(struct report_plot){
        .file = "misses",
        .title = "Tunnelling: a circle tested at the end of each frame",
        .x_name = "speed, px/frame",
        .y_name = "crossings missed",
        .y_linear = true,
        .y_percent = true,
        .described = "Missed crossings by speed for radii from 2 to 160 px: a swept circle misses none; a circle "
                     "tested once per frame misses more crossings when bullets are faster or smaller",
    });
    for (int s = 0; s < SPEEDS; s++)
        x[s] = SPEED[s];
    for (int r = 0; r < RADII; r++) {
        for (int s = 0; s < SPEEDS; s++)
            y[s] = 100 * wrong[CIRCLE][r][s].missed;
        report_plot_line(report_string("r = %d px", RADIUS[r]), false, x, y, SPEEDS);
    }
    for (int s = 0; s < SPEEDS; s++) {
        y[s] = 0;
        for (int r = 0; r < RADII; r++)
            y[s] = y[s] > 100 * wrong[SWEPT][r][s].missed ? y[s] : 100 * wrong[SWEPT][r][s].missed;
    }
    report_plot_line("swept, every r", true, x, y, SPEEDS);
    report_plot_end();
}

static void plot_areas(void)
{
    static const int SHOWN[] = { SWEPT, 4, 5, 6, 7, 10 };
    double x[RADII], y[RADII];

    report_plot(&(struct report_plot){
        .file = "areas",
        .title = "Errors of a single-frame test",
        .x_name = "radius, px",
        .y_name = "area of false hits and misses, px²",
        .described =
            "Area of false hits and misses by radius: for boxes, it grows with the square of the radius; for whole "
            "pixels, it grows with the radius; squares in Q15.16 also fail at long distances; the engine has no errors",
    });
    for (int r = 0; r < RADII; r++)
        x[r] = RADIUS[r];
    for (int k = 0; k < (int)(sizeof SHOWN / sizeof *SHOWN); k++) {
        for (int r = 0; r < RADII; r++)
            y[r] = areas[SHOWN[k]][r].false_hits + areas[SHOWN[k]][r].missed;
        report_plot_line(RIVALS[SHOWN[k]].name, SHOWN[k] == SWEPT, x, y, RADII);
    }
    report_plot_end();
}

/* Nothing wrong anywhere? */
static bool exact(int rival)
{
    bool good = true;

    for (int r = 0; r < RADII; r++) {
        good &= areas[rival][r].false_hits + areas[rival][r].missed == 0;
        for (int s = 0; s < SPEEDS; s++)
            good &= wrong[rival][r][s].missed + wrong[rival][r][s].false_hits == 0;
    }
    return good;
}

void section_collision(void)
{
    struct lab_rival far[COUNT], near[COUNT];
    const int r4 = radius_index(4), r160 = radius_index(160), s16 = speed_index(16);

    cross_all();
    measure_areas();
    time_rivals(far, near);

    report_section("2. Collision");
    report_text("Two circles touch when their centres are at most *r* apart, where r is the sum of both radii.\n"
                "\n"
                "* *False area* is the area in which a stationary bullet is wrongly reported as a hit; *missed area* "
                "is the area in which\n"
                "  a hit is not reported. Both areas are measured up to 384 px to the left and right of the player and "
                "up to 448 px above\n"
                "  and below. A circle of r = 160 px has an area of %s px².\n"
                "* A *crossing* is the path of a bullet that passes the player in any direction, at most 1.5 r + 1 px "
                "away. There are\n"
                "  %s crossings for each radius and speed. A crossing is *missed* if the bullet touches the player but "
                "no frame\n"
                "  detects the touch. A *false hit* is a touch that a frame detects although it never happened. Missed "
                "crossings and\n"
                "  false hits are given as percentages of the crossings that touch the player.\n"
                "* Times are for pairs at most 12 px apart (near) and for pairs anywhere in the field (far), with r = "
                "8 px and 4\n"
                "  px/frame.",
                report_figure(areas[SWEPT][r160].of), report_count(TRIALS));
    print_rivals(far, near);
    print_shapes();
    plot_misses();
    print_grid("Crossings missed by a circle tested once per frame, with 2 substeps, and with 4 substeps", triple);
    report_text(
        "The miss rate depends on how far the bullet moves per frame, compared with r. A circle tested at the end of "
        "each frame\n"
        "misses %s of the crossings if the bullet moves r/2 per frame, %s at r, %s at 2 r and %s at 4 r. Doubling\n"
        "the number of substeps helps only as much as halving the speed.",
        report_percent(missed_at(1)), report_percent(missed_at(2)), report_percent(missed_at(4)),
        report_percent(missed_at(8)));
    lab_claim(missed_at(1) < 0.02 && missed_at(2) < 0.06 && missed_at(4) > 0.2, "misses follow the speed in contacts");
    leaving_report();
    plot_areas();
    print_grid("Missed crossings and false hits of the box around the circle", twin);
    report_text("At every size, the corners of the box add %s to the area of the circle. These corners cover %s px² at "
                "r = 8 px and\n"
                "%s px² at r = 160 px. The exact circle test needs no square root, because it compares dx² + dy² with "
                "r² in 64 bits.",
                report_percent(areas[AROUND][r160].false_hits / areas[AROUND][r160].of),
                report_figure(areas[AROUND][radius_index(8)].false_hits),
                report_figure(areas[AROUND][r160].false_hits));

    lab_claim(areas[SQUARES][r160].false_hits > 100, "squares in Q15.16 hit what is far away");
    lab_claim(lab_exact() || near[CIRCLE].ns < 1.2 * near[ROOT].ns, "the exact circle costs no more than a root");
    lab_claim(wrong[TWO][r4][s16].missed > 0.04 && wrong[FOUR][r4][s16].missed > 0, "substeps miss crossings");
    lab_conclude("hit test", "exact swept circles",
                 report_string("no misses and no false hits in %s paths past the player; a circle tested only at the "
                               "end of each frame misses %s of the hits at r = 4 px and 16 px/frame",
                               report_count((int64_t)RADII * SPEEDS * TRIALS),
                               report_percent(wrong[CIRCLE][r4][s16].missed)),
                 "use `hit = { box = ... }` for objects drawn as boxes; use `swept = false` where missed hits do "
                 "not matter, or for bullets that move less than half the sum of both radii per frame",
                 is_standard(SWEPT) && exact(SWEPT) &&
                     (lab_exact() || (far[SWEPT].ns < far[TWO].ns && far[SWEPT].ns < 3 * far[CIRCLE].ns)));
}
