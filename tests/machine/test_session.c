/*
 * test_session.c - a run gone to and fro in, taken over, begun anew, and played again on a changed ROM. What a
 * session's board is at a frame is compared with a board that went there straight, with the same inputs.
 */
#define _POSIX_C_SOURCE 200809L /* mkdtemp */
#include "../../platform/platform.h"
#include "../../src/script/api/eval.h"
#include "../../src/workbench/pack/pack.h"
#include "../../src/player/play/folder.h"
#include "../../src/player/play/session.h"
#include "rig.h"
#include "../temp.h"

enum { FRAMES = 3600, NAME = 600 };

static char dir[256]; /* a copy of the built-in game's folder */
static struct rom_image image;
static struct cart cart;
static struct demo demo; /* its whole run */
static uint64_t plain[FRAMES + 1];
static char err[1200];

static void shell(const char *format, const char *a, const char *b)
{
    char command[2 * NAME];

    snprintf(command, sizeof command, format, a, b);
    assert_int_equal(system(command), 0);
}

static int open_game(void **state)
{
    struct rig_game g = { 0 };
    struct rig r;

    (void)state;
    assert_true(temp_folder(dir, sizeof dir, "curtain-session"));
    shell("cp -R '%s/.' '%s'", "roms/glasstide", dir);
    assert_true(pack_load_game(dir, false, &image, err, sizeof err));
    assert_true(cart_open(&cart, &image.rom, err, sizeof err));
    rig_folder(&g, "glasstide");
    assert_true(rig_demo(&g, "run", &demo));
    rig_power(&r, &g, &demo.start);
    for (uint32_t f = 0; f <= FRAMES; f++) {
        plain[f] = board_hash(r.b);
        rig_tick(&r, demo.pads[f]);
    }
    rig_close(&r);
    return 0;
}

static int close_game(void **state)
{
    (void)state;
    shell("rm -rf '%s'%s", dir, "");
    demo_free(&demo);
    rom_image_free(&image);
    return 0;
}

static void open_session(struct session *s, bool playback, const char *record)
{
    if (!session_open(s, &cart, &demo.start, playback ? &demo : NULL, record))
        fail_msg("%s", s->err);
}

/* On to a frame by the run's inputs. */
static void play_to(struct session *s, uint32_t frame)
{
    while (board_frame(session_board(s)) < frame)
        assert_true(session_tick(s, demo.pads[board_frame(session_board(s))]));
}

static void at(const struct session *s, uint32_t frame)
{
    assert_int_equal(board_frame(session_board(s)), frame);
    if (board_hash(session_board(s)) != plain[frame])
        fail_msg("frame %u is not the frame it was", frame);
}

static void get_there(struct session *s)
{
    if (!session_work(s, UINT64_MAX))
        fail_msg("%s", s->err);
    assert_int_equal(s->state, SESSION_PLAYING);
}

/* Far ahead in pieces: each does some of the way, and progress grows. */
TEST(seeks)
{
    struct session s;
    int pieces = 0, before = 0;

    open_session(&s, true, NULL);
    session_goto(&s, FRAMES);
    assert_int_equal(s.state, SESSION_SEEKING);
    for (; s.state != SESSION_PLAYING; pieces++) {
        assert_true(session_work(&s, 0));
        assert_in_range(session_progress(&s), before, 1000);
        before = session_progress(&s);
    }
    assert_true(pieces > 100);
    at(&s, FRAMES);
    session_goto(&s, 10);
    at(&s, 10);
    session_goto(&s, FRAMES); /* it was there: at once */
    assert_int_equal(s.state, SESSION_PLAYING);
    at(&s, FRAMES);
    session_goto(&s, UINT32_MAX);
    assert_int_equal(s.to, demo.frames);
    session_stop(&s);
    assert_int_equal(s.state, SESSION_PLAYING);
    assert_true(session_close(&s));
}

/* A live run: back, forward as it was, and on by other inputs, which makes it another run. */
TEST(branches)
{
    static const uint16_t other[MAX_PLAYERS] = { PAD_START };
    char path[NAME];
    struct session s;
    struct demo d;
    struct rig_game g = { 0 };
    struct rig r;

    snprintf(path, sizeof path, "%s/branch.demo", dir);
    open_session(&s, false, path);
    play_to(&s, 800);
    at(&s, 800);
    session_goto(&s, 500);
    at(&s, 500);
    assert_int_equal(session_last(&s), 800);
    for (int i = 0; i < 100; i++)
        assert_true(session_replay_tick(&s));
    at(&s, 600);
    assert_int_equal(s.now->writer.demo.frames, 800); /* what was is still known */
    for (int i = 0; i < 65; i++)
        assert_true(session_tick(&s, other));
    assert_int_equal(session_last(&s), 665);
    uint64_t hash = board_hash(session_board(&s));
    assert_true(hash != plain[665]);
    assert_true(session_replay_tick(&s)); /* there is nothing to go on to */
    assert_int_equal(board_frame(session_board(&s)), 665);
    assert_true(s.rewound);
    assert_true(session_close(&s));

    assert_true(demo_load(&d, path, err, sizeof err));
    assert_int_equal(d.frames, 665);
    assert_int_equal(d.flags, DEMO_BRANCHED);
    assert_true(d.complete);
    rig_folder(&g, "glasstide");
    rig_power(&r, &g, &d.start);
    for (uint32_t f = 0; f < d.frames; f++)
        rig_tick(&r, d.pads[f]);
    assert_true(board_hash(r.b) == hash);
    rig_close(&r);
    demo_free(&d);
}

/* A board that was changed from outside has no past, and its recording says so; from there on it is a run like any. */
TEST(touched)
{
    char out[EVAL_TEXT_SIZE];
    uint64_t changed, later;
    struct session s;

    open_session(&s, false, NULL);
    play_to(&s, 1500);
    session_goto(&s, 1300);
    at(&s, 1300);
    assert_true(board_eval(session_board(&s), "score.add(10)", out, sizeof out));
    changed = board_hash(session_board(&s));
    assert_true(changed != plain[1300]);
    assert_true(session_mark_touched(&s));
    assert_true(s.now->writer.demo.frames == 1300 && s.now->writer.demo.flags & DEMO_TOUCHED);
    assert_true(session_first(&s) == 1300 && session_last(&s) == 1300);
    session_goto(&s, 100);
    assert_true(s.state == SESSION_PLAYING && board_hash(session_board(&s)) == changed);
    play_to(&s, 1600);
    later = board_hash(session_board(&s));
    session_goto(&s, 100);
    assert_true(board_frame(session_board(&s)) == 1300 && board_hash(session_board(&s)) == changed);
    session_goto(&s, 1600);
    get_there(&s);
    assert_true(board_hash(session_board(&s)) == later && session_first(&s) == 1300);
    assert_true(session_close(&s));
}

TEST(starts_anew)
{
    struct board_start start = demo.start;
    struct session s;

    open_session(&s, true, NULL);
    session_goto(&s, 100);
    get_there(&s);
    snprintf(start.practice.section, sizeof start.practice.section, "one");
    assert_true(session_restart(&s, &start));
    assert_null(s.demo);
    assert_int_equal(board_frame(session_board(&s)), 0);
    play_to(&s, 200);
    uint64_t hash = board_hash(session_board(&s));
    assert_true(hash != plain[200]);
    assert_true(session_restart(&s, &start));
    play_to(&s, 200);
    assert_true(board_hash(session_board(&s)) == hash);
    start.difficulty = 99;
    assert_false(session_restart(&s, &start));
    assert_true(board_hash(session_board(&s)) == hash); /* as it was */
    assert_true(session_close(&s));
}

/* ---- reload ---- */

/* Replaces a text in a file of the game. */
static void edit(const char *file, const char *from, const char *to)
{
    static char text[1 << 16];
    char name[NAME];

    snprintf(name, sizeof name, "%s/%s", dir, file);
    long n = plat_load(name, text, sizeof text - 1);
    assert_in_range(n, 1, sizeof text - 2);
    text[n] = 0;
    char *where = strstr(text, from);
    assert_non_null(where);
    size_t rest = strlen(where + strlen(from));
    static char out[1 << 16];
    int size = snprintf(out, sizeof out, "%.*s%s%.*s", (int)(where - text), text, to, (int)rest, where + strlen(from));
    assert_in_range(size, 1, sizeof out - 1);
    assert_true(plat_save(name, out, (size_t)size));
}

/* A fresh board of the folder as it is now, by the run's inputs. */
static uint64_t fresh_hash(uint32_t frame)
{
    struct rig_game g = { 0 };
    struct rig r;

    assert_true(pack_load_game(dir, false, &g.image, err, sizeof err));
    assert_true(cart_open(&g.cart, &g.image.rom, err, sizeof err));
    rig_power(&r, &g, &demo.start);
    for (uint32_t f = 0; f < frame; f++)
        rig_tick(&r, demo.pads[f]);
    const uint64_t hash = board_hash(r.b);
    rig_close(&r);
    return hash;
}

static const char habit[] = "n = 8, every = 14, path = swoop, run";
static const char faster[] = "n = 5, every = 14, path = swoop, run";

static void reload_at(struct session *s, uint32_t frame)
{
    assert_true(session_reload(s, pack_load_game, dir, false));
    assert_int_equal(s->state, SESSION_RELOADING);
    get_there(s);
    assert_int_equal(board_frame(session_board(s)), frame);
    assert_true(board_hash(session_board(s)) == fresh_hash(frame));
}

TEST(reloads)
{
    char path[NAME];
    struct session s;
    struct demo d;

    snprintf(path, sizeof path, "%s/reload.demo", dir);
    open_session(&s, false, path);
    play_to(&s, 2800);
    assert_true(session_reload(&s, pack_load_game, dir, false)); /* the same ROM */
    assert_int_equal(s.state, SESSION_PLAYING);
    edit("stages/one.lua", habit, faster);
    reload_at(&s, 2800);
    session_goto(&s, 1800); /* its past is of the new script */
    assert_true(board_hash(session_board(&s)) == fresh_hash(1800));
    play_to(&s, 2500);
    edit("stages/one.lua", faster, habit);
    reload_at(&s, 2500);
    at(&s, 2500);
    edit("rom.lua", "version = 1", "version = 1, id = 'other'");
    assert_false(session_reload(&s, pack_load_game, dir, false));
    assert_non_null(strstr(s.err, "folder now contains another game"));
    edit("rom.lua", "version = 1, id = 'other'", "version = 1");
    at(&s, 2500);
    assert_true(session_close(&s));
    assert_true(demo_load(&d, path, err, sizeof err));
    assert_int_equal(d.frames, 2500);
    assert_int_equal(d.flags & DEMO_TOUCHED, DEMO_TOUCHED);
    assert_true(d.game_hash == rom_game_hash(&image.rom));
    demo_free(&d);
}

/* A run that ended in a fault is put right by putting the script right. */
TEST(mends_a_fault)
{
    struct session s;
    struct rom_image broken;
    struct cart its;

    edit("stages/one.lua", habit, "n = 'two', every = 14, path = swoop, run");
    assert_true(pack_load_game(dir, false, &broken, err, sizeof err) && cart_open(&its, &broken.rom, err, sizeof err));
    assert_true(session_open(&s, &its, &demo.start, NULL, NULL));
    while (!board_last_output(session_board(&s))->fault)
        assert_true(session_tick(&s, demo.pads[board_frame(session_board(&s))]));
    uint32_t frame = board_frame(session_board(&s));
    assert_true(session_tick(&s, demo.pads[frame])); /* dead: nothing happens */
    assert_int_equal(session_last(&s), frame);
    session_goto(&s, frame - 10); /* but it can be gone back */
    assert_null(board_last_output(session_board(&s))->fault);
    at(&s, frame - 10);
    session_goto(&s, frame);
    edit("stages/one.lua", "n = 'two', every = 14, path = swoop, run", habit);
    assert_true(session_reload(&s, pack_load_game, dir, false));
    get_there(&s);
    at(&s, frame);
    play_to(&s, frame + 100);
    at(&s, frame + 100);
    assert_true(session_close(&s));
    rom_image_free(&broken);
}

static void write_file(const char *file)
{
    char name[NAME];

    snprintf(name, sizeof name, "%s/%s", dir, file);
    assert_true(plat_save(name, "x", 1));
}

/* A change is told once, and only when it has settled; hidden files and demos are none. */
TEST(watches)
{
    struct folder f;

    assert_false(folder_open(&f, "/nowhere/at/all"));
    assert_true(folder_open(&f, dir));
    assert_false(folder_changed(&f) || folder_changed(&f));
    edit("stages/one.lua", habit, faster);
    assert_false(folder_changed(&f)); /* seen once */
    assert_true(folder_changed(&f));
    assert_false(folder_changed(&f));
    edit("stages/one.lua", faster, habit);
    assert_false(folder_changed(&f));
    write_file("art/new.png");
    assert_false(folder_changed(&f)); /* still changing */
    assert_true(folder_changed(&f));
    write_file(".hidden");
    write_file("demos/new.demo");
    assert_false(folder_changed(&f) || folder_changed(&f));
}

RUN_TESTS(open_game, close_game)
