/*
 * test_calls.c - the window and the program by calls, for a host that has the loop: 40 windows opened and closed in
 * the middle leave nothing on the heap, two at once behave as each alone.
 *
 * Without arguments all of it; with a number only so many are opened and closed, for valgrind (calls.sh).
 */
#define _GNU_SOURCE
#include <sys/stat.h>
#include <malloc.h>
#include <string.h>
#include <unistd.h>
#include "rig.h"
#include "../temp.h"
#include "../../src/base/rng.h"
#include "../../src/player/play/play.h"
#include "../../platform/platform.h"

enum { SECOND = 1000000, MANY = 40, FRAMES = 150, FEW = 50 };

#define TUNABLES "GLIBC_TUNABLES"

static char root[256], repo[1024];

/* ---- the port: two windows, and the one whose call is running ---- */

static struct window {
    uint64_t now;
    struct rng rng;
    bool busy; /* keys are pressed, of all kinds */
    bool quit, open, text;
    uint8_t key;
    int hold, polls, shown, logged;
    char title[64];
    const char *drop; /* a path that is dropped on it */
} windows[2], *at = windows;

bool plat_open(const struct plat_config *want)
{
    at->open = true;
    at->text = want->text_input;
    snprintf(at->title, sizeof at->title, "%s", want->title);
    return true;
}

void plat_close(void)
{
    at->open = false;
}

void plat_poll(struct plat_input *in)
{
    /* arrows, fire, bomb, Enter, Escape, P, R, F1, M, the log, the console and what is typed there, quick turns */
    static const uint8_t keys[] = { 79, 80, 81, 82, 29, 27, 40, 40, 41, 19, 21, 58, 16, 45, 53, 42, 54, 55, 56, 20 };

    memset(in, 0, sizeof *in);
    at->polls++;
    in->has_focus = true;
    in->mouse_x = in->mouse_y = -1;
    in->quit = at->quit;
    if (at->busy && at->hold-- <= 0) {
        at->key = keys[rng_below(&at->rng, sizeof keys)];
        at->hold = 1 + (int)rng_below(&at->rng, 6);
    }
    if (at->busy)
        in->keys[at->key >> 3] |= (uint8_t)(1u << (at->key & 7));
    if (at->busy && at->text) /* the console runs a line */
        snprintf(in->text, sizeof in->text, "%d", 1);
}

void plat_show(const uint8_t *pix, int pitch, int w, int h, const uint32_t rgb[256])
{
    uint32_t sum = 0;

    for (int y = 0; y < h; y++)
        for (int x = 0; x < w; x++)
            sum += rgb[pix[y * pitch + x]];
    at->shown += sum != 0;
}

/* Each window has a clock, which its host moves by a sixtieth a call. */
uint64_t plat_usec(void)
{
    return at->now;
}

void plat_wait(uint64_t until)
{
    (void)until;
}

bool plat_take_dropped_file(char *path, size_t size)
{
    const bool is = at->drop != NULL;

    if (is)
        snprintf(path, size, "%s", at->drop);
    at->drop = NULL;
    return is;
}

void plat_log(const char *line)
{
    (void)line;
    at->logged++;
}

/* ---- windows ---- */

static struct rig_game games[2];
static const char *const names[] = { "examples/first", "roms/testcard" };

static struct play *open_play(int i, const char *record)
{
    struct play_options o = {
        .cart = &games[i].cart, .load = pack_load_game, .seeded = true, .record = record, .version = "test"
    };

    at = &windows[i];
    *at = (struct window){ .now = SECOND, .busy = true };
    rng_seed(&at->rng, (uint64_t)i + 1);
    o.start = (struct board_start){ .difficulty = -1, .seed = 7 };
    for (int k = 0; k < games[i].cart.manifest.n_dips; k++)
        o.start.dip[k] = games[i].cart.manifest.dips[k].default_value;
    struct play *play = play_open(&o);
    assert_non_null(play);
    return play;
}

static bool frame(int i, struct play *play)
{
    at = &windows[i];
    at->now += SECOND / 60 + 1;
    return play_frame(play);
}

static enum result close_play(int i, struct play *play)
{
    at = &windows[i];
    const enum result result = play_close(play);
    assert_false(at->open);
    return result;
}

/* Bytes of the heap that are somebody's. */
static size_t heap(void)
{
    const struct mallinfo2 m = mallinfo2();

    return m.uordblks + m.hblkhd;
}

static void open_and_close(int n, int frames)
{
    size_t before = 0;

    for (int i = 0; i < n; i++) {
        struct play *play = open_play(i & 1, NULL);
        windows[i & 1].rng.s[0] += (uint64_t)i; /* other hands each time */
        for (int k = 0; k < frames && frame(i & 1, play); k++)
            ;
        assert_true(windows[i & 1].shown > frames / 2);
        assert_int_equal(close_play(i & 1, play), RESULT_DONE);
        if (i < 8) /* the C library's own: time zones, buffers */
            before = heap();
        else if (heap() > before)
            fail_msg("after %d windows %zu bytes are kept, after 8 there were %zu", i + 1, heap(), before);
    }
}

TEST(nothing_is_kept)
{
    open_and_close(MANY, FRAMES);
}

static uint8_t *file_bytes(const char *name, size_t *size)
{
    const long n = plat_file_size(name);

    assert_true(n > 0);
    uint8_t *bytes = malloc((size_t)n);
    assert_int_equal(plat_load(name, bytes, (size_t)n), n);
    *size = (size_t)n;
    return bytes;
}

static void expect_same_file(const char *a, const char *b)
{
    size_t na, nb;
    uint8_t *pa = file_bytes(a, &na), *pb = file_bytes(b, &nb);

    assert_int_equal(na, nb);
    assert_memory_equal(pa, pb, na);
    free(pa);
    free(pb);
}

/* From now on, what programs keep is in a new folder. */
static void keep_in(const char *folder)
{
    char path[sizeof root + 16];

    snprintf(path, sizeof path, "%s/%s", root, folder);
    assert_int_equal(mkdir(path, 0700), 0);
    setenv("XDG_DATA_HOME", path, 1);
    setenv("XDG_CONFIG_HOME", path, 1);
}

TEST(two_at_once)
{
    static const char *const alone[] = { "alone-0.demo", "alone-1.demo" }, *const both[] = { "0.demo", "1.demo" };
    struct play *plays[2];
    int shown[2];

    keep_in("alone");
    for (int i = 0; i < 2; i++) {
        struct play *play = open_play(i, alone[i]);
        for (int k = 0; k < (4 + i) * FRAMES; k++)
            frame(i, play); /* hands may have left it */
        assert_int_equal(close_play(i, play), RESULT_DONE);
        shown[i] = windows[i].shown;
        assert_true(shown[i] > FRAMES);
    }
    keep_in("both");
    for (int i = 0; i < 2; i++)
        plays[i] = open_play(i, both[i]);
    for (int k = 0; k < 4 * FRAMES; k++)
        for (int i = 0; i < 2; i++)
            frame(i, plays[i]);
    assert_int_equal(close_play(0, plays[0]), RESULT_DONE);
    assert_true(windows[1].open); /* it goes on without the other */
    for (int k = 0; k < FRAMES; k++)
        frame(1, plays[1]);
    assert_int_equal(close_play(1, plays[1]), RESULT_DONE);
    expect_same_file(alone[0], both[0]);
    assert_int_equal(windows[0].shown, shown[0]);
    assert_int_equal(windows[1].shown, shown[1]);
    assert_string_equal(windows[1].title, "Test Card");
}

static void load_folder(struct rig_game *g, const char *folder)
{
    char err[1024];

    if (!pack_load_game(folder, false, &g->image, err, sizeof err) ||
        !cart_open(&g->cart, &g->image.rom, err, sizeof err))
        fail_msg("%s", err);
}

/* ---- the program ---- */

static struct program *open_program(char **words)
{
    static char *argv[8]; /* which it may put in another order */
    int argc = 0;

    for (; words[argc]; argc++)
        argv[argc] = words[argc];
    at = &windows[0];
    *at = (struct window){ .now = SECOND };
    struct program *p = program_open(argc, argv);
    assert_non_null(p);
    return p;
}

static bool program_goes(struct program *p)
{
    at->now += SECOND / 60 + 1;
    return program_run_frame(p);
}

TEST(the_program)
{
    char first[1200], card[1200];
    size_t before = 0;

    snprintf(first, sizeof first, "%s/%s", repo, names[0]);
    snprintf(card, sizeof card, "%s/%s", repo, names[1]);
    for (int i = 0; i < 6; i++) {
        char *play[] = { "curtain", "play", first, "--mute", NULL };
        struct program *p = open_program(play);
        for (int k = 0; k < 30; k++)
            assert_true(program_goes(p));
        assert_int_equal(at->shown, 30);
        if (i & 1) { /* left in the middle */
            assert_int_equal(program_close(p), 0);
            continue;
        }
        at->quit = true;
        assert_false(program_goes(p) || program_goes(p));
        assert_int_equal(program_close(p), 0);
        if (i < 4)
            before = heap();
        else
            assert_true(heap() <= before);
    }
    char *again[] = { "curtain", card, NULL };
    struct program *p = open_program(again);
    assert_string_equal(at->title, "Test Card");
    at->drop = first;
    for (int k = 0; k < 10; k++)
        assert_true(program_goes(p));
    assert_string_equal(at->title, "First Light");
    assert_int_equal(program_close(p), 0);
}

/* What has no window is done at once; what cannot be played is told. */
TEST(the_program_without_a_window)
{
    char *nothing[] = { "curtain", "play", "nothing", NULL }, *wrong[] = { "curtain", "play", "--scale", "-3", NULL };
    char *unheard[] = { "curtain", "sound", "nothing", "a", "--play", NULL };
    char **const words[] = { nothing, wrong, unheard };

    for (int i = 0; i < 3; i++) {
        struct program *p = open_program(words[i]);
        assert_int_equal(at->logged, 1);
        assert_false(program_goes(p) || program_goes(p));
        assert_int_equal(program_close(p), 2);
    }
}

TEST(a_sound_is_heard)
{
    char game[1200];
    char *words[] = { "curtain", "sound", game, "back", "--play", NULL };

    snprintf(game, sizeof game, "%s/roms/glasstide", repo);
    char *list[] = { "curtain", "sound", game, "no such sound", NULL };
    struct program *p = open_program(list);
    assert_false(program_goes(p));
    assert_int_equal(program_close(p), 2);
    p = open_program(words);
    assert_true(program_goes(p));
    assert_true(at->open && at->shown == 1);
    assert_int_equal(program_close(p), 0);
    assert_false(at->open);
    p = open_program(words);
    for (int k = 0; k < 1200 && program_goes(p); k++)
        ;
    assert_false(program_goes(p)); /* over by itself */
    assert_int_equal(program_close(p), 0);
}

int main(int argc, char **argv)
{
    int failed = 0;

    if (!getenv(TUNABLES)) { /* or what was freed would count as somebody's until it is used again */
        setenv(TUNABLES, "glibc.malloc.tcache_count=0", 1);
        execv(argv[0], argv);
    }
    if (!getcwd(repo, sizeof repo) || !temp_folder(root, sizeof root, "calls"))
        return 2;
    for (int i = 0; i < 2; i++)
        load_folder(&games[i], names[i]);
    if (chdir(root) != 0)
        return 2;
    setenv("XDG_DATA_HOME", root, 1);
    setenv("XDG_CONFIG_HOME", root, 1);
    setenv("HOME", root, 1);
    if (argc > 1)
        open_and_close(atoi(argv[1]), FEW);
    else
        failed = run_all_tests(NULL, NULL);
    for (int i = 0; i < 2; i++)
        rom_image_free(&games[i].image);
    char command[sizeof root + 16];
    snprintf(command, sizeof command, "rm -rf '%s'", root);
    return chdir(repo) != 0 || system(command) != 0 ? 2 : failed;
}
