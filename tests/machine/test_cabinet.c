/*
 * test_cabinet.c - the whole cabinet under random hands: a port without a machine presses keys, controllers and the
 * mouse, types, takes the focus away, changes the game's files, over many frames. Nothing may crash or hang, and
 * whatever was recorded meanwhile must hold, however it was gone to and fro, reloaded, practised and looked at.
 */
#define _POSIX_C_SOURCE 200809L
#include <string.h>
#include <unistd.h>
#include "rig.h"
#include "../temp.h"
#include "../../src/cab/demo/replay.h"
#include "../../src/cab/play/cab.h"
#include "../../platform/platform.h"

enum { SECOND = 1000000, KEYS_AT_ONCE = 4, PADS_MOST = 2 };

static char root[256], repo[1024];

/* ---- the port ---- */

static struct {
    uint64_t now;
    struct rng rng;
    int polls, left; /* polls until it asks to quit */
    uint8_t held[KEYS_AT_ONCE];
    uint32_t pad[PADS_MOST];
    int hold; /* polls that these stay held */
    bool console, files, text, focus;
    char folder[256];
    int shown, w, h;
} port;

static uint32_t below(uint32_t n)
{
    return (uint32_t)(rng_next(&port.rng) % n);
}

bool plat_open(const struct plat_want *want)
{
    port.w = want->w;
    port.h = want->h;
    port.text = want->text;
    return true;
}

void plat_close(void)
{
}

uint64_t plat_usec(void)
{
    return port.now += 3;
}

void plat_wait(uint64_t until)
{
    if (until > port.now)
        port.now = until;
}

void plat_show(const uint8_t *pix, int pitch, int w, int h, const uint32_t rgb[256])
{
    uint32_t sum = 0;

    for (int y = 0; y < h; y++) /* all of it is there to be read, and every colour */
        for (int x = 0; x < w; x++)
            sum += rgb[pix[y * pitch + x]];
    port.shown += sum != 0;
}

void plat_log(const char *line)
{
    (void)line;
}

/* What hands press: mostly the game's buttons, often the cabinet's keys. Never what leaves at once. */
static uint8_t any_key(void)
{
    static const uint8_t game[] = { 79, 80, 81, 82, 29, 27, 225, 6, 40, 43, 4, 7, 22, 26, 13, 14, 31 };
    static const uint8_t cabinet[] = { 19, 55, 54, 56, 42, 5,  47, 48, 74, 23, 62, 59, 21, 16, 45, 46, 68,
                                       41, 58, 11, 10, 25, 17, 60, 41, 40, 81, 79, 30, 39, 78, 75, 76 };

    if (port.console && below(40) == 0)
        return 53;
    return below(3) ? game[below(sizeof game)] : cabinet[below(sizeof cabinet)];
}

static void choose_hands(void)
{
    memset(port.held, 0, sizeof port.held);
    memset(port.pad, 0, sizeof port.pad);
    port.hold = 1 + (int)below(below(8) ? 6 : 60);
    for (uint32_t i = 0, n = below(KEYS_AT_ONCE); i < n; i++)
        port.held[i] = any_key();
    for (int i = 0; i < PADS_MOST; i++)
        if (below(4) == 0)
            port.pad[i] = (uint32_t)1 << below(PLAT_SWITCHES);
    if (below(50) == 0)
        port.focus = !port.focus;
}

/* The game in the folder becomes another, or wrong, or right again. */
static void touch_files(void)
{
    static const char *const ends[] = { "\n", "\n-- another\n", "\nbullet.nothing()\n", "\nlocal = 3\n",
                                        "\nboard.note(1)\n" };
    char name[1200], text[16384];
    FILE *f;

    snprintf(name, sizeof name, "%s/examples/first/main.lua", repo);
    f = fopen(name, "rb");
    assert_non_null(f);
    const size_t n = fread(text, 1, sizeof text - 64, f);
    fclose(f);
    strcpy(text + n, ends[below(sizeof ends / sizeof *ends)]);
    snprintf(name, sizeof name, "%s/main.lua", port.folder);
    f = fopen(name, "wb");
    assert_non_null(f);
    fputs(text, f);
    fclose(f);
}

void plat_poll(struct plat_input *in)
{
    static const char *const typed[] = { "1+1",          "keep ",    "bullet.clear{}", "x",
                                         "player.lives", "\xC3\xA9", "board.note(1)" };

    memset(in, 0, sizeof *in);
    port.polls++;
    port.now += SECOND / 60;
    if (port.hold-- <= 0)
        choose_hands();
    for (int i = 0; i < KEYS_AT_ONCE; i++)
        if (port.held[i])
            in->keys[port.held[i] >> 3] |= (uint8_t)(1u << (port.held[i] & 7));
    memcpy(in->controllers, port.pad, sizeof port.pad);
    in->quit = port.polls > port.left;
    in->focus = port.focus;
    in->mouse_x = in->mouse_y = -1;
    if (below(3) == 0) {
        in->mouse_x = (int)below((uint32_t)port.w);
        in->mouse_y = (int)below((uint32_t)port.h);
        in->mouse = (uint8_t)(below(12) == 0 ? 1 + below(7) : 0);
        in->wheel = below(20) == 0 ? (int)below(3) - 1 : 0;
    }
    if (port.text && below(4) == 0)
        snprintf(in->text, sizeof in->text, "%s", typed[below(sizeof typed / sizeof *typed)]);
    if (port.files && below(400) == 0)
        touch_files();
}

/* ---- runs ---- */

static void shell(const char *format, const char *a, const char *b)
{
    char command[2048];

    snprintf(command, sizeof command, format, a, b);
    assert_int_equal(system(command), 0);
}

static void begin(uint64_t seed, int polls)
{
    memset(&port, 0, sizeof port);
    port.now = SECOND;
    port.left = polls;
    port.focus = true;
    rng_seed(&port.rng, seed);
    snprintf(port.folder, sizeof port.folder, "first");
    shell("rm -rf '%s'/* && cp -r '%s'/examples/first .", root, repo);
    setenv("XDG_DATA_HOME", root, 1);
    setenv("XDG_CONFIG_HOME", root, 1);
    setenv("HOME", root, 1);
}

static uint8_t bytes[16 << 20];

static void read_demo(const char *file, struct demo *d)
{
    char err[512];
    FILE *f = fopen(file, "rb");

    assert_non_null(f);
    const size_t n = fread(bytes, 1, sizeof bytes, f);
    fclose(f);
    if (!demo_read(d, bytes, n, err, sizeof err))
        fail_msg("%s: %s", file, err);
}

/* A recorded run holds, but for one that the console has touched. */
static void expect_holds(const struct demo *d, const struct cart *cart)
{
    struct replay replay = { 0 };
    struct verdict v;
    char err[512];

    assert_true(d->complete);
    if (d->flags & DEMO_TOUCHED)
        return;
    if (!demo_fits(d, cart, err, sizeof err))
        fail_msg("%s", err);
    assert_int_equal(replay_run(&replay, cart, d, NULL, &v, err, sizeof err), RESULT_DONE);
    if (v.kind != VERDICT_HOLDS)
        fail_msg("differs in frame %u", v.frame);
    replay_close(&replay);
}

enum { CONSOLE = 1, FILES = 2, FREE = 4 /* nothing is recorded: there is practice */ };

static struct rom_image image;
static struct cart cart;

static void load(void)
{
    char err[1024];

    if (!rom_image_load(port.folder, false, &image, err, sizeof err) || !cart_open(&cart, &image.rom, err, sizeof err))
        fail_msg("%s", err);
}

static void play(const struct cab_options *o)
{
    const enum result result = cab_play(o);

    if (result != RESULT_DONE && result != RESULT_REFUSED) /* refused: a script that was made wrong has faulted */
        fail_msg("result %d", (int)result);
    assert_true(port.shown > 0);
}

/* So many polls of random hands on a run from power-on, then as many on its playback. */
static void one_run(uint64_t seed, unsigned mode, int polls)
{
    struct cab_options o = { .cart = &cart, .path = "first", .seeded = true };
    char record[300];
    struct demo d;

    begin(seed, polls);
    port.console = mode & CONSOLE;
    port.files = mode & FILES;
    load();
    o.start = (struct board_start){ .difficulty = -1, .seed = seed };
    for (int i = 0; i < cart.m.n_dips; i++)
        o.start.dip[i] = cart.m.dips[i].value;
    snprintf(record, sizeof record, "%s/run.demo", root);
    if (mode & FREE) {
        play(&o);
        rom_image_free(&image);
        return;
    }
    o.record = record;
    play(&o);
    read_demo(record, &d);
    if (!(mode & FILES)) {
        expect_holds(&d, &cart);
        port.left += polls;
        o.record = NULL;
        o.start = d.start;
        o.demo = &d;
        play(&o);
    }
    demo_free(&d);
    rom_image_free(&image);
}

static void many(unsigned mode)
{
    const int n = rig_long() ? 40 : 4;

    for (int i = 0; i < n; i++)
        one_run((uint64_t)i * 8 + mode, mode, 2500);
}

static void test_hands(void **state)
{
    (void)state;
    many(0);
}

static void test_console(void **state)
{
    (void)state;
    many(CONSOLE);
}

static void test_practice(void **state)
{
    (void)state;
    many(FREE);
    many(FREE | CONSOLE | FILES);
}

static void test_files(void **state)
{
    (void)state;
    many(FILES);
    many(CONSOLE | FILES);
}

int main(void)
{
    const struct CMUnitTest tests[] = { cmocka_unit_test(test_hands), cmocka_unit_test(test_console),
                                        cmocka_unit_test(test_files), cmocka_unit_test(test_practice) };

    if (!getcwd(repo, sizeof repo) || !temp_folder(root, sizeof root, "cabinet") || chdir(root) != 0)
        return 2;
    const int failed = cmocka_run_group_tests(tests, NULL, NULL);
    if (chdir(repo) != 0)
        return 2;
    shell("rm -rf '%s%s'", root, "");
    return failed;
}
