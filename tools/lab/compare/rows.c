/*
 * rows.c - the scenes of the bench on this checkout's engine, one slice of frames at a time, for who runs two of these
 * in turns: rows BENCH GAME [START]
 *
 * BENCH is the folder roms/bench of either checkout, GAME a game's, START a practice start of it. Reads commands from
 * stdin and answers each with a line: "list", all rows, then an empty line; "open ROW", "fine" or why not; "slice N",
 * nanoseconds of a tick and of a picture, the medians of so many frames after one that warms up; "close". The rows are
 * the values of the ROM's DIP switches, so a scene that the ROM gains is a row. compare.sh builds this with another
 * commit's sources too, so it keeps to what board.h and tools/lab/bench/scene.h have had for long.
 */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>
#include "../../../platform/platform.h"
#include "../../../src/base/pads.h"
#include "../../../src/workbench/pack/pack.h"
#include "../bench/scene.h"
#include "../numbers.h"
#include "names.h"

enum { MOST_ROWS = 512, MOST_FRAMES = 256, NAME = 64 };

static struct row {
    char name[NAME];
    struct scene_want want;
    int warm; /* frames before the first slice */
    enum { SCENE, GAME, CLOCK } of;
} rows[MOST_ROWS];
static int n_rows;

/* What is measured now. */
static struct {
    const struct row *row;
    struct scene scene;
    uint32_t *shown;
} now;
static struct rom_image bench, game;
static const char *section = ""; /* of the game, a practice start */

static _Noreturn void fail(const char *what)
{
    fprintf(stderr, "rows: %s\n", what);
    exit(1);
}

/* The process's own time: what else the machine did is left out. */
static double clock_ns(void)
{
    struct timespec t;

    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &t);
    return (double)t.tv_sec * 1e9 + (double)t.tv_nsec;
}

/* ---- the rows ---- */

static struct row *add(const char *group, const char *name, struct scene_want want)
{
    struct row *r = &rows[n_rows];

    if (n_rows == MOST_ROWS)
        fail("there are too many");
    for (int i = 0; i < n_rows; i++)
        if (!strncmp(rows[i].name, group, strlen(group)) && !strcmp(rows[i].name + strlen(group) + 1, name))
            return &rows[i];
    n_rows++;
    *r = (struct row){ .want = want };
    snprintf(r->name, NAME, "%s %s", group, name);
    return r;
}

static const char *number(int n)
{
    static char text[16];

    snprintf(text, sizeof text, "%d", n);
    return text;
}

static void add_crowds(void)
{
    static const int crowds[] = { 1024, 4096, 16384, 262144 }, fights[] = { 3000, 10000, 30000 };

    for (size_t i = 0; i < sizeof fights / sizeof *fights; i++) {
        const int n = fights[i];
        add("boss", number(n),
            (struct scene_want){ .does = "boss", .n = n, .bullets = 2 * n, .sparks = 320, .scenery = true })
            ->warm = 400;
    }
    for (size_t i = 0; i < sizeof crowds / sizeof *crowds; i++)
        add("crowd", number(crowds[i]),
            (struct scene_want){ .does = "crowd", .n = crowds[i], .bullets = crowds[i], .seed = 1 });
    add("crowd", "straight", (struct scene_want){ .does = "creep", .n = 16384, .bullets = 16384, .seed = 5 });
    add("battle", "256", (struct scene_want){ .does = "battle", .n = 256, .bullets = 64 })->warm = 30;
}

static void add_pictures(const char *value)
{
    static const int sides[] = { 8, 12, 16, 32, 64 };
    char name[NAME];

    for (size_t i = 0; i < sizeof sides / sizeof *sides; i++) {
        const int side = sides[i];
        snprintf(name, sizeof name, "%s, %d px", value, side);
        add("picture", name,
            (struct scene_want){ .does = "pictures",
                                 .picture = value,
                                 .n = side > 16 ? 512 : 4096,
                                 .bullets = 4096,
                                 .side = side,
                                 .seed = 7 });
    }
    if (strcmp(value, "plain") == 0 || strcmp(value, "sprite") == 0 || strcmp(value, "blended") == 0)
        add("laser", value, (struct scene_want){ .does = "lasers", .picture = value, .n = 64, .bullets = 64 })->warm =
            70;
}

/* What a value of that switch stands for. */
static void add_value(const char *dip, const char *value)
{
    const char *part = dip + strlen("price");

    if (!strcmp(dip, "picture"))
        add_pictures(value);
    else if (strncmp(dip, "price", strlen("price")) || !strcmp(value, "none"))
        return;
    else if (!strcmp(part, "_look"))
        add("look", value,
            (struct scene_want){ .does = "looks", .price = value, .n = 512, .bullets = 512, .sparks = 512 });
    else if (!strcmp(part, "_part"))
        add("together", value,
            (struct scene_want){
                .does = "together", .price = value, .n = 8192, .bullets = 8192, .sparks = 2080, .scenery = true })
            ->warm = 70;
    else
        add("price", value, (struct scene_want){ .does = "prices", .price = value, .n = 4096, .bullets = 4096 });
}

static void add_all(void)
{
    static struct cart cart; /* rows name its words */
    char err[256];

    if (!cart_open(&cart, &bench.rom, err, sizeof err))
        fail(err);
    add("the clock", "alone", (struct scene_want){ 0 })->of = CLOCK;
    add("the game", section[0] ? section : "title", (struct scene_want){ 0 })->of = GAME;
    add_crowds();
    for (int i = 0; i < cart.manifest.n_dips; i++)
        for (int k = 0; k < cart.manifest.dips[i].n_values; k++)
            add_value(cart.manifest.dips[i].name, cart.manifest.dips[i].value_name[k]);
    add("item", "falls", (struct scene_want){ .does = "items", .price = "straight", .n = 512, .bullets = 64 });
    add("item", "home", (struct scene_want){ .does = "items", .price = "home", .n = 512, .bullets = 64 });
}

/* ---- one row ---- */

static void *room_for(size_t n)
{
    void *p = aligned_alloc(64, (n + 63) / 64 * 64);

    if (!p)
        fail("out of memory");
    return p;
}

/* The player cannot be hit. */
static bool open_game(struct scene *s, char *err, size_t err_size)
{
    struct board_start start = { .seed = 1, .difficulty = -1 };
    struct cart cart;
    int w, h;

    *s = (struct scene){ 0 };
    if (!cart_open(&cart, &game.rom, err, err_size) || !board_size(&game.rom, &s->ram_size, err, err_size))
        return false;
    for (int i = 0; i < cart.manifest.n_dips; i++)
        start.dip[i] = cart.manifest.dips[i].default_value;
    snprintf(start.practice.section, sizeof start.practice.section, "%s", section);
    start.practice.invincible = section[0] != 0;
    s->ram = room_for(s->ram_size);
    s->b = board_power_on(s->ram, s->ram_size, &game.rom, &start, err, err_size);
    if (!s->b)
        return false;
    board_screen_size(s->b, &w, &h);
    s->mem = room_for(fb_size(w, h));
    s->scratch = room_for(board_scratch_size(s->b));
    fb_init(&s->fb, s->mem, w, h);
    return true;
}

/* What needs room for groups of columns is opened with them. */
static bool open_scene(const struct row *r, char *err, size_t err_size)
{
    struct scene_want want = r->want;

    if (r->of == GAME)
        return open_game(&now.scene, err, err_size);
    for (int groups = 0; groups < 2; groups++) {
        want.groups = groups;
        if (scene_open(&now.scene, &bench.rom, &want, err, err_size))
            return true;
        scene_close(&now.scene);
    }
    return false;
}

static void check_fault(void)
{
    if (board_last_output(now.scene.b)->fault)
        fail(board_last_output(now.scene.b)->fault->message);
}

/* In the game fire is pressed now and then, which starts it, and then shoots. */
static void tick(void)
{
    const uint32_t f = now.row->of == GAME ? board_frame(now.scene.b) : 0;
    const uint16_t pads[MAX_PLAYERS] = { (uint16_t)((f % 64 < 40 ? PAD_FIRE : 0) | (f / 40 % 4 == 1 ? PAD_LEFT : 0) |
                                                    (f / 40 % 4 == 3 ? PAD_RIGHT : 0)),
                                         0 };

    if (now.row->of == GAME)
        board_tick(now.scene.b, pads);
    else
        scene_tick(&now.scene);
    check_fault();
}

/* Additions that wait for each other: as many clock cycles as there are. */
static void spin(void)
{
    volatile uint64_t sum = 1;

    for (int i = 0; i < 20000; i++)
        sum = sum + (sum >> 1);
}

static void one_frame(double *ticked, double *drawn)
{
    double from = clock_ns();

    if (now.row->of == CLOCK)
        spin();
    else
        tick();
    double then = clock_ns();
    if (now.row->of != CLOCK)
        scene_draw(&now.scene);
    *ticked = then - from;
    *drawn = clock_ns() - then;
}

static void open_row(const char *name)
{
    char err[256];

    now.row = NULL;
    for (int i = 0; i < n_rows; i++)
        if (!strcmp(rows[i].name, name))
            now.row = &rows[i];
    if (!now.row) {
        printf("this engine's ROM has no such scene\n");
        return;
    }
    if (now.row->of != CLOCK && !open_scene(now.row, err, sizeof err)) {
        printf("%s\n", err);
        now.row = NULL;
        return;
    }
    for (int i = 0; now.row->of != CLOCK && i < now.row->warm; i++)
        tick();
    printf("fine\n");
}

static void close_row(void)
{
    if (now.row && now.row->of != CLOCK) {
        now.scene.image = now.row->of == GAME ? (struct rom_image){ 0 } : now.scene.image;
        scene_close(&now.scene);
    }
    now.row = NULL;
    printf("fine\n");
}

static void slice(int frames)
{
    double ticked[MOST_FRAMES], drawn[MOST_FRAMES];

    if (!now.row || frames < 1 || frames > MOST_FRAMES)
        fail("open a row, then slice 1 to 256");
    one_frame(&ticked[0], &drawn[0]);
    for (int i = 0; i < frames; i++)
        one_frame(&ticked[i], &drawn[i]);
    numbers_sort(ticked, (size_t)frames);
    numbers_sort(drawn, (size_t)frames);
    printf("%.0f %.0f\n", ticked[frames / 2], drawn[frames / 2]);
}

int main(int argc, char **argv)
{
    char line[128], err[256];

    if (argc < 3 || argc > 4)
        fail("usage: rows BENCH GAME [START]");
    section = argc == 4 ? argv[3] : "";
    if (!pack_load_game(argv[1], false, &bench, err, sizeof err) ||
        !pack_load_game(argv[2], false, &game, err, sizeof err))
        fail(err);
    add_all();
    while (fgets(line, sizeof line, stdin)) {
        line[strcspn(line, "\n")] = 0;
        if (!strcmp(line, "list"))
            for (int i = 0; i <= n_rows; i++)
                printf("%s\n", i < n_rows ? rows[i].name : "");
        else if (!strncmp(line, "open ", 5))
            open_row(line + 5);
        else if (!strcmp(line, "close"))
            close_row();
        else if (!strncmp(line, "slice ", 6))
            slice(atoi(line + 6));
        else
            fail("expected list, open, slice or close");
        fflush(stdout);
    }
    return 0;
}
