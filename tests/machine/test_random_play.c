/*
 * test_random_play.c - a game in a window with random input and settings: a port without a machine presses keys,
 * controllers and the mouse, types, takes the focus away, plugs controllers in and out, resizes the window and changes
 * the game's files, over many frames. Nothing may crash or hang, and every recording and autosaved replay must verify,
 * whatever was rewound, reloaded, practised or looked at.
 *
 * A second test walks the screens: it presses one menu key at a time, so that it reaches every row of every screen and
 * answers every question, drops files on the window, in several games, with a second window on the same home.
 */
#define _POSIX_C_SOURCE 200809L
#include <string.h>
#include <unistd.h>
#include "rig.h"
#include "../temp.h"
#include "../../src/player/replay.h"
#include "../../src/player/settings/config.h"
#include "../../src/common/files.h"
#include "../../src/player/play/play.h"
#include "../../src/player/replays/replays.h"
#include "../../src/player/replays/roms.h"
#include "../../platform/platform.h"

enum { SECOND = 1000000, KEYS_AT_ONCE = 4, ROOM_MOST = 700 /* window pixels a side, but for one of a set scale */ };

static char root[256], repo[1024];

/* ---- the port ---- */

static struct {
    uint64_t now;
    struct rng rng;
    int polls, left; /* polls until it asks to quit */
    uint8_t held[KEYS_AT_ONCE];
    uint32_t pad[PLAT_MAX_CONTROLLERS];
    struct plat_controller plugged[PLAT_MAX_CONTROLLERS]; /* id 0: nothing is */
    uint32_t ids;                                         /* that were given */
    int hold;                                             /* polls that these stay held */
    bool console, files, text, focus, hidden;
    bool walks; /* presses the keys of the screens, one at a time: those of step */
    uint8_t step[16];
    int steps, next_step;
    int drop;                   /* a file is dropped every so many polls; 0: never */
    uint32_t calm;              /* one key in this many is the program's */
    bool window, paints, waits; /* the window is known; it takes full colours; it waits for the screen */
    struct plat_config want;
    char folder[256];
    int shown, painted;
    int w, h;           /* the window's */
    int last_w, last_h; /* of what was shown last */
} port;

static uint32_t below(uint32_t n)
{
    return (uint32_t)(rng_next(&port.rng) % n);
}

/* A window of another size: as a player draws it, from nothing to wider and higher than the picture. */
static void resize(void)
{
    port.w = 1 + (int)below(ROOM_MOST);
    port.h = 1 + (int)below(ROOM_MOST);
    if (below(4) == 0)
        plat_fit_window(&port.want, (int)below(ROOM_MOST), (int)below(ROOM_MOST), &port.w, &port.h);
}

bool plat_open(const struct plat_config *want)
{
    assert_true(want->w > 0 && want->h > 0 && want->scale >= 0);
    port.want = *want;
    port.want.scale %= 3; /* 16 would be gigabytes of pixels */
    port.text = want->text_input;
    if (want->fullscreen)
        resize();
    else
        plat_fit_window(&port.want, ROOM_MOST, ROOM_MOST, &port.w, &port.h);
    return true;
}

bool plat_get_window(struct plat_window *out)
{
    static const int rates[] = { 0, 50000, 59940, 60000, 75000, 144000 };

    *out = (struct plat_window){ port.w, port.h, rates[port.w % 6], port.waits };
    return port.window;
}

bool plat_paint(const uint32_t *rgb, int pitch, int w, int h)
{
    uint32_t sum = 0;

    assert_true(w > 0 && h > 0 && pitch >= w);
    for (int y = 0; y < h; y++)
        for (int x = 0; x < w; x++)
            sum |= rgb[(size_t)y * (size_t)pitch + (size_t)x];
    assert_true(sum <= 0xFFFFFF);
    if (!port.paints)
        return false;
    port.last_w = w;
    port.last_h = h;
    port.painted++;
    return true;
}

bool plat_get_controller(int i, struct plat_controller *controller)
{
    memset(controller, 0, sizeof *controller);
    if (i < 0 || i >= PLAT_MAX_CONTROLLERS || !port.plugged[i].id)
        return false;
    *controller = port.plugged[i];
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
    port.last_w = w;
    port.last_h = h;
}

void plat_log(const char *line)
{
    (void)line;
}

/* What hands press: mostly the game's buttons, often the program's keys. Never what leaves at once. */
static uint8_t any_key(void)
{
    static const uint8_t game[] = { 79, 80, 81, 82, 29, 27, 225, 6, 40, 43, 4, 7, 22, 26, 13, 14, 31 };
    static const uint8_t program[] = { 19, 55, 54, 56, 42, 5,  47, 48, 74, 23, 62, 59, 21, 16, 45, 46, 68,
                                       41, 58, 11, 10, 25, 17, 60, 41, 40, 81, 79, 30, 39, 78, 75, 76 };

    if (port.console && below(40) == 0)
        return 53;
    return below(port.calm) ? game[below(sizeof game)] : program[below(sizeof program)];
}

/* What a walk in the screens is made of: to a row and into it, the last row and yes to its question, a value, away, and
 * now and then any key. */
static void choose_steps(void)
{
    enum { DELETE = 76, RIGHT = 79, LEFT, DOWN, UP, ENTER = 40, ESCAPE };
    static const uint8_t last_and_yes[] = { UP, ENTER, DOWN, ENTER };
    const uint32_t what = below(16), often = below(14);

    port.steps = 0;
    if (what < 8) {
        for (; port.steps < (int)often; port.steps++)
            port.step[port.steps] = DOWN;
        port.step[port.steps++] = ENTER;
    } else if (what < 11) {
        memcpy(port.step, last_and_yes, sizeof last_and_yes);
        port.steps = sizeof last_and_yes;
    } else if (what < 14) {
        port.step[port.steps++] = what == 11 ? DELETE : what == 12 ? LEFT : RIGHT;
    } else {
        port.step[port.steps++] = what == 14 ? ESCAPE : any_key();
    }
    port.next_step = 0;
}

/* A controller comes or goes, or another takes its place between two polls; the same model may come back. */
static void plug(void)
{
    const uint32_t i = below(PLAT_MAX_CONTROLLERS);
    struct plat_controller *c = &port.plugged[i];

    port.pad[i] = 0;
    if (c->id && below(3)) {
        c->id = 0;
        return;
    }
    c->id = ++port.ids;
    if (below(2) == 0) {
        c->kind = (enum plat_controller_kind)below(PLAT_CONTROLLER_KINDS);
        snprintf(c->name, sizeof c->name, "%s",
                 below(3) ? "Pad of a very long name, with \xC3\xA9 and \x01 in it" : "");
    }
}

static void choose_hands(void)
{
    memset(port.held, 0, sizeof port.held);
    memset(port.pad, 0, sizeof port.pad);
    port.hold = 1 + (int)below(below(8) ? 6 : 60);
    if (port.walks) {
        port.hold = 1;
        if (port.next_step == port.steps)
            choose_steps();
        if (port.polls & 1)
            port.held[0] = port.step[port.next_step++];
        port.focus = true;
        return;
    }
    for (uint32_t i = 0, n = below(KEYS_AT_ONCE); i < n; i++)
        port.held[i] = any_key();
    if (below(30) == 0)
        plug();
    for (int i = 0; i < PLAT_MAX_CONTROLLERS; i++)
        if (port.plugged[i].id && below(4) == 0)
            port.pad[i] = (uint32_t)1 << below(PLAT_BUTTONS);
    port.focus = below(port.focus ? 50 : 3) != 0; /* a game waits for who is away: seldom, and not for long */
    port.hidden = below(80) == 0;
    if (below(25) == 0)
        resize();
    if (below(200) == 0)
        port.paints = !port.paints;
}

/* The game in the folder becomes another, or wrong, or right again. */
static void touch_files(void)
{
    static const char *const ends[] = { "\n", "\n-- another\n", "\nbullet.nothing()\n", "\nlocal = 3\n",
                                        "\nboard.note(1)\n" };
    char name[1400], text[16384];
    FILE *f;

    snprintf(name, sizeof name, "%s/examples/%s/main.lua", repo, port.folder);
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
    in->has_focus = port.focus;
    in->hidden = port.hidden;
    in->mouse_x = in->mouse_y = -1;
    if (port.last_w && below(3) == 0) {
        in->mouse_x = (int)below((uint32_t)port.last_w);
        in->mouse_y = (int)below((uint32_t)port.last_h);
        in->mouse_buttons = (uint8_t)(below(12) == 0 ? 1 + below(7) : 0);
        in->wheel = below(20) == 0 ? (int)below(3) - 1 : 0;
    }
    if (port.text && below(4) == 0)
        snprintf(in->text, sizeof in->text, "%s", typed[below(sizeof typed / sizeof *typed)]);
    if (port.files && below(400) == 0)
        touch_files();
}

/* A game, one that is not there, no game, a demo of another game. */
bool plat_take_dropped_file(char *path, size_t size)
{
    static const char *const names[] = { "pattern", "first", "none.rom", "first/main.lua", "first/art", "other.demo" };

    if (!port.drop || below((uint32_t)port.drop) != 0)
        return false;
    snprintf(path, size, "%s", names[below(sizeof names / sizeof *names)]);
    return true;
}

/* ---- runs ---- */

static void shell(const char *format, const char *a, const char *b)
{
    char command[2048];

    snprintf(command, sizeof command, format, a, b);
    assert_int_equal(system(command), 0);
}

/* A settings file in which each may say anything it can. */
static void choose_settings(void)
{
    static const char *const binds[] = { "p1.fire = x pad.south pad.r2\n", "p1.focus = z\np1.bomb = none\n",
                                         "p2.fire = z\n", "p2.left = h pad.west\n" };
    const struct config_setting *s;
    struct config c;
    char text[64];

    shell("mkdir -p '%s%s'", root, "/curtain");
    FILE *f = fopen("curtain/curtain.conf", "wb");
    assert_non_null(f);
    for (int i = 0; (s = config_setting(i)) != NULL; i++)
        if (below(3) == 0) {
            config_put(&c, s, s->lo + (int)below((uint32_t)(s->hi - s->lo + 1)));
            config_text(&c, s, text, sizeof text);
            fprintf(f, "%s = %s\n", s->name, text);
        }
    for (size_t i = 0; i < sizeof binds / sizeof *binds; i++)
        if (below(4) == 0)
            fputs(binds[i], f);
    fclose(f);
}

/* With the art of another example round its picture, so that there is a border. */
static void choose_border(void)
{
    if (below(2))
        shell("sed -i '1s|{|{ border = \"art/font.png\"%s|' '%s'/rom.lua", ",", port.folder);
}

static void choose_port(void)
{
    port.window = below(4) != 0;
    port.paints = below(8) != 0;
    port.waits = below(2) == 0;
    port.calm = below(2) ? 3 : 60;
    for (uint32_t i = 0, n = below(PLAT_MAX_CONTROLLERS); i < n; i++)
        plug();
}

static void begin(const char *game, uint64_t seed, int polls)
{
    memset(&port, 0, sizeof port);
    port.now = SECOND;
    port.left = polls;
    port.focus = true;
    rng_seed(&port.rng, seed);
    snprintf(port.folder, sizeof port.folder, "%s", game);
    shell("rm -rf '%s'/* && cp -r '%s'/examples/* .", root, repo);
    setenv("XDG_DATA_HOME", root, 1);
    setenv("XDG_CONFIG_HOME", root, 1);
    setenv("HOME", root, 1);
    choose_port();
    choose_settings();
    choose_border();
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
    if (!demo_check_cart(d, cart, err, sizeof err))
        fail_msg("%s", err);
    assert_int_equal(replay_run(&replay, cart, d, NULL, &v, err, sizeof err), RESULT_DONE);
    if (v.kind != VERDICT_HOLDS)
        fail_msg("differs in frame %u", v.frame);
    replay_close(&replay);
}

enum {
    CONSOLE = 1,
    FILES = 2,
    FREE = 4, /* nothing is recorded: there is practice */
    WALK = 8  /* through the screens */
};

static struct rom_image image;
static struct cart cart;
static int kept, painted, dropped; /* replays; pictures of full colours; games dropped and played: of all runs */

static void load(void)
{
    char err[1024];

    if (!pack_load_game(port.folder, false, &image, err, sizeof err) || !cart_open(&cart, &image.rom, err, sizeof err))
        fail_msg("%s", err);
}

static void play_until_quit(const struct play_options *o)
{
    struct play *play = play_open(o);

    assert_non_null(play);
    while (play_frame(play))
        ;
    const enum result result = play_close(play);
    if (result != RESULT_DONE && result != RESULT_REFUSED) /* refused: a script that was made wrong has faulted */
        fail_msg("result %d", (int)result);
    assert_true(port.shown + port.painted > 0);
    painted += port.painted;
}

/* Each of the runs that the program kept holds, on the ROM that it was played with. */
static void expect_replays_hold(void)
{
    struct replays list;
    struct rom_image its;
    struct cart its_cart;
    char path[ROMS_PATH], real[512], err[1024];

    assert_true(replays_open(&list, cart.manifest.id));
    for (int i = 0; i < list.n; i++) {
        struct demo d;
        roms_path(path, cart.manifest.id, list.list[i].meta.rom);
        assert_true(plat_path(path, real, sizeof real));
        if (!pack_load_game(real, false, &its, err, sizeof err) || !cart_open(&its_cart, &its.rom, err, sizeof err))
            fail_msg("%s", err);
        replays_path(&list, i, path);
        assert_true(plat_path(path, real, sizeof real));
        read_demo(real, &d);
        assert_false(d.flags & DEMO_TOUCHED);
        expect_holds(&d, &its_cart);
        demo_free(&d);
        rom_image_free(&its);
        kept++;
    }
    replays_close(&list);
}

/* So many polls of random hands on a run from power-on that is recorded, then as many on its playback. */
static void recorded(struct play_options *o, unsigned mode, int polls)
{
    char record[300];
    struct demo d;

    snprintf(record, sizeof record, "%s/run.demo", root);
    o->record = record;
    play_until_quit(o);
    read_demo(record, &d);
    if (!(mode & FILES)) {
        expect_holds(&d, &cart);
        port.left += polls;
        o->record = NULL;
        o->start = d.start;
        o->demo = &d;
        play_until_quit(o);
    }
    demo_free(&d);
}

/* The same without a recording, so there is practice; what was left of it is then gone on with, or asked for. */
static void left(struct play_options *o, int polls)
{
    play_until_quit(o);
    port.left += polls;
    o->resume = below(2) == 0;
    play_until_quit(o);
}

/* A monkey in the screens, with a second window on the same home that nobody looks at. What has ended is opened again,
 * until all polls are used. */
static void walk(struct play_options *o)
{
    struct play_options other = *o;
    struct play *play = NULL, *second = play_open(&other);
    char next[FILES_PATH_SIZE];

    assert_non_null(second);
    while (port.polls < port.left) {
        o->resume = below(2) == 0;
        play = play_open(o);
        assert_non_null(play);
        while (play_frame(play))
            if (second && below(8) == 0 && !play_frame(second)) {
                play_close(second);
                second = NULL;
            }
        dropped += play_dropped_game(play, next, sizeof next);
        play_close(play);
    }
    if (second)
        play_close(second);
    painted += port.painted;
}

static void one_run(const char *game, uint64_t seed, unsigned mode, int polls)
{
    struct play_options o = { .cart = &cart, .path = game, .load = pack_load_game, .seeded = true };

    begin(game, seed, polls);
    port.console = mode & CONSOLE;
    port.files = mode & FILES;
    port.walks = mode & WALK;
    port.drop = mode & WALK ? 300 : 0;
    load();
    o.start = (struct board_start){ .difficulty = -1, .seed = seed };
    for (int i = 0; i < cart.manifest.n_dips; i++)
        o.start.dip[i] = cart.manifest.dips[i].default_value;
    if (mode & WALK)
        walk(&o);
    else if (mode & FREE)
        left(&o, polls);
    else
        recorded(&o, mode, polls);
    expect_replays_hold();
    rom_image_free(&image);
}

static void many(unsigned mode)
{
    static const char *const games[] = { "first", "shooter", "pattern", "bulletml" };
    const int n = rig_long() ? 40 : 2;

    for (int i = 0; i < n; i++)
        one_run(mode & WALK ? games[i % 4] : "first", (uint64_t)i * 16 + mode, mode, 2500);
}

TEST(hands)
{
    many(0);
}

TEST(console)
{
    many(CONSOLE);
}

TEST(practice)
{
    many(FREE);
    many(FREE | CONSOLE | FILES);
}

TEST(files)
{
    many(FILES);
    many(CONSOLE | FILES);
}

TEST(screens)
{
    many(WALK);
    many(WALK | FILES);
}

/* The hands got that far. */
TEST(seen)
{
    assert_true(kept > 0 && painted > 0 && dropped > 0);
}

int main(void)
{
    if (!getcwd(repo, sizeof repo) || !temp_folder(root, sizeof root, "program") || chdir(root) != 0)
        return 2;
    const int failed = run_all_tests(NULL, NULL);
    if (chdir(repo) != 0)
        return 2;
    shell("rm -rf '%s%s'", root, "");
    return failed;
}
