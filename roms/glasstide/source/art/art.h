/*
 * art.h - draws the pictures of the built-in game: a small modeller that turns lit shapes into pixel art.
 *
 * Everything is made of + - * / and sqrt on doubles, so that every host writes the same bytes. Angles are turns (1 is a
 * whole turn), clockwise with y down; lengths are pixels. Light comes from the top left.
 */
#ifndef ART_H
#define ART_H

#include <stdbool.h>
#include <stdint.h>

/* -- pictures -- */

/* A sheet of shades 0..15, 0 transparent; bank gives them colour when it is written. */
struct sheet {
    int w, h, bank;
    uint8_t *px;
};

struct sheet sheet_new(int w, int h, int bank);
void sheet_free(struct sheet *s);
/* Sets one pixel; outside the sheet nothing happens. */
void sheet_set(struct sheet *s, int x, int y, int shade);
int sheet_get(const struct sheet *s, int x, int y);

/* The 256 colours as 0xRRGGBB; those of a stage of Glass Tide, which are others in banks 10 to 13 (ART_MAIN: the same;
 * ART_DEEP: the first stage below its wreck; ART_DARK: the third where no lamp shines), and of its story's pictures;
 * those of the night, whose banks 0 to 7 are the same. */
enum art_stage { ART_MAIN, ART_ONE, ART_DEEP, ART_TWO, ART_THREE, ART_MOON, ART_DARK, ART_STORY, ART_STAGES };
void art_palette(uint32_t rgb[256]);
void art_stage_palette(enum art_stage stage, uint32_t rgb[256]);
void art_night_palette(uint32_t rgb[256]);

/* -- numbers -- */

double art_sin(double turns);
double art_cos(double turns);
double art_clamp(double v, double lo, double hi);
/* A number that rises and falls once in four frames; a boss's frames are parts of those. */
double art_sway(double frame, double phase);
/* The next number of a seed's sequence: 0 to 1, and lo to hi. */
double art_random(uint32_t *seed);
double art_pick(uint32_t *seed, double lo, double hi);
/* The threshold of a pixel, 1/32 to 31/32: the 4 x 4 ordered matrix of Bayer, 1973. */
double art_dither(int x, int y);

/* -- the modeller -- */

/* How a surface takes the light. GLASS is dark where the light enters and bright where it leaves, with a hard
 * highlight; GLOW is brightest in its middle; FLAT has one shade, `level`; VEIL is thin glass that lets what lies under
 * it through. */
enum style { MATTE, GLASS, GLOW, FLAT, VEIL };

struct mat {
    enum style style;
    int lo, hi;   /* the shades it may use */
    double level; /* FLAT: 0..1; the others: added to the light */
};

struct paint;

/* A scene of w x h pixels with (0,0) in its middle. */
struct paint *paint_new(int w, int h);
/* From now on each shape is drawn twice, the second time with x negated. */
void paint_mirror(struct paint *p, bool on);
/* From now on only samples with y0 <= y <= y1 are drawn. */
void paint_band(struct paint *p, double y0, double y1);
void paint_ball(struct paint *p, struct mat m, double x, double y, double rx, double ry, double turn);
/* A tube from a to b whose radius goes from ra to rb. */
void paint_limb(struct paint *p, struct mat m, double ax, double ay, double ra, double bx, double by, double rb);
/* A tube along the curve a..b pulled towards c; a bow is the same with numbers. */
void paint_curve(struct paint *p, struct mat m, const double a[2], const double c[2], const double b[2], double ra,
                 double rb);
void paint_bow(struct paint *p, struct mat m, double ax, double ay, double cx, double cy, double bx, double by,
               double ra, double rb);
/* A plate with edges bevelled over `bevel` pixels; xy holds n points, clockwise. */
void paint_poly(struct paint *p, struct mat m, int n, const double *xy, double bevel);
/* A fin: a skin from the root to n tips, with a rib to each and an edge that hangs in by `sag` (0..1) between them. */
void paint_fin(struct paint *p, struct mat m, double x, double y, int n, const double *tips, double sag);
/* Pen strokes of radius r along n segments (ax ay bx by each), as one body with bevelled edges. */
void paint_stroke(struct paint *p, struct mat m, int n, const double *segs, double r, double bevel);
/* Three jagged cracks for each step of wounds; at[i] is x, y, direction and length. What glows in them is dull at the
 * first step, and a quarter wider at the second. */
void paint_cracks(struct paint *p, int wounds, struct mat glow, const double at[6][4], uint32_t seed);
/* Banks what is drawn so far to one side, as a craft does that flies there: -1 left to 1 right. The wing on that side
 * dips: it gets shorter and darker. */
void paint_roll(struct paint *p, double roll);
/* Turns the scene into pixels with its top left at (x, y) of the sheet and frees it. Shade `rim` outlines it where the
 * light does not fall, `lit` where it does; 0: no outline there. */
void paint_done(struct paint *p, struct sheet *s, int x, int y, int rim, int lit);

/* -- poses -- */

/* Draws a sheet of creatures in four poses, one below another: as they fly to the left, to the right, when they are hit,
 * and before they fire. */
struct sheet art_poses(struct sheet (*draw)(void));

/* -- cut-ins -- */

/* A band with slanted ends: what crosses the field as a spell is declared. */
enum { CUT_W = 176, CUT_H = 60 };

/* What is at (x, y) of the band's cell: 0 nothing, 1 its edge, 2 its inside. */
int art_band(double x, double y);
/* The shade of the band's ground at a pixel: dark, with streaks. */
int art_streak(int x, int y);
/* Draws a band at (0, y) that shows the surroundings of (cx, cy) in what draw paints, magnified. */
void art_cut_in(struct sheet *s, int y, void (*draw)(struct sheet *), double cx, double cy, double zoom);

/* What draw paints, turned and magnified about its middle, in a square picture. */
struct sheet art_turned(int side, void (*draw)(struct sheet *), double turn, double zoom);
/* Two craft, level: for the story's pictures. */
void art_level_heron(struct sheet *s);
void art_level_petrel(struct sheet *s);

/* -- bosses -- */

/* What a boss is doing: frame runs from 0 to 4; wounds is 0, 1 hurt, 2 broken. */
struct state {
    double frame;
    bool attack;
    int wounds;
};

enum { BOSS_FRAMES = 6, BOSS_ROWS = 4 };

/* Draws a boss's rows of w x h px from the top of the sheet: at rest, attacking, and what being hurt and being broken
 * change of it at rest, which the game draws over it. */
void art_boss(struct sheet *s, int w, int h, void (*draw)(struct sheet *, int x, int y, struct state));

/* -- letters -- */

enum { ART_LETTER = 8 }; /* px of a cell, each way */

/* Draws a letter of the cells' fonts, a byte a row whose highest bit is its leftmost pixel, with its shadow. */
void art_letter(struct sheet *s, int x, int y, const uint8_t rows[ART_LETTER]);

/* -- the pictures: each returns a whole sheet -- */

struct sheet art_bullets(void);
struct sheet art_shots(void);
struct sheet art_sparks(void);
struct sheet art_heron(void);
struct sheet art_petrel(void);
struct sheet art_tern(void);
struct sheet art_arms(void);
struct sheet art_enemies(void);
struct sheet art_enemies_poses(void);
struct sheet art_queen(void);
struct sheet art_iri(void);
struct sheet art_sen(void);
struct sheet art_ono(void);
struct sheet art_queen_face(void);
struct sheet art_fires(void);
struct sheet art_lights(void);
struct sheet art_sherds(void);
struct sheet art_logo_light(void);
struct sheet art_marker(void);
struct sheet art_gems(void);
struct sheet art_floor(void);
struct sheet art_reef(void);
struct sheet art_border(void);
struct sheet art_logo(void);
struct sheet art_font(void);
struct sheet art_card(void);
struct sheet art_bench(void);
struct sheet art_glow(void);
struct sheet art_items(void);
struct sheet art_tiles(void);
struct sheet art_seabed(void);
struct sheet art_abyss_life(void);
struct sheet art_abyss_life_poses(void);
struct sheet art_gulper(void);
struct sheet art_gulper_poses(void);
struct sheet art_angler(void);
struct sheet art_lamplight(void);
struct sheet art_queen_abyss(void);
struct sheet art_trench(void);
struct sheet art_quay(void);
struct sheet art_quay_lamps(void);
struct sheet art_abyss_tiles(void);
struct sheet art_finds(void);
struct sheet art_two_creatures(void);
struct sheet art_two_creatures_poses(void);
struct sheet art_two_bellows(void);
struct sheet art_two_cinder(void);
struct sheet art_two_quench(void);
struct sheet art_two_cinder_face(void);
struct sheet art_two_quench_face(void);
struct sheet art_two_bullets(void);
struct sheet art_two_works(void);
struct sheet art_two_stacks(void);
struct sheet art_two_street(void);
struct sheet art_two_skyline(void);
struct sheet art_two_yard(void);
struct sheet art_two_train(void);
struct sheet art_shoal(void);
struct sheet art_shoal_poses(void);
struct sheet art_lantern_nautilus(void);
struct sheet art_crab(void);
struct sheet art_crab_face(void);
struct sheet art_wreck(void);
struct sheet art_kelp(void);
struct sheet art_whale(void);
struct sheet art_bones(void);
struct sheet art_shafts(void);
struct sheet art_heron_gilt(void);
struct sheet art_petrel_gilt(void);
struct sheet art_tern_gilt(void);
struct sheet art_heron_ember(void);
struct sheet art_petrel_ember(void);
struct sheet art_tern_ember(void);
struct sheet art_last(void);
struct sheet art_last_face(void);
struct sheet art_water(void);
struct sheet art_dry(void);
struct sheet art_brink(void);
struct sheet art_wave(void);
struct sheet art_dive(void);
struct sheet art_flood(void);
struct sheet art_home(void);
struct sheet art_kite(void);
struct sheet art_lanterns(void);
struct sheet art_keeper(void);
struct sheet art_night(void);
struct sheet art_moon(void);
/* The program's icon, size x size pixels, 48 or 64. */
struct sheet art_icon(int size);

#endif
