/*
 * test_midway.c - a run of two players that is gone back in, taken over, begun anew and played again on a changed ROM
 * while something is going on that takes many frames: a line of a talk, a choice, a bomb, a pause, a fight with two
 * bosses, a talk among their phases, a continue. From the title, and as practice of a mark and of a phase.
 */
#define _POSIX_C_SOURCE 200809L /* mkdtemp */
#include "../../platform/platform.h"
#include "../../src/workbench/pack/pack.h"
#include "../../src/player/play/session.h"
#include "rig.h"
#include "../temp.h"

enum { FRAMES = 2000, MOMENTS = 24, LATER = 9 }; /* LATER: frames after something began, so that it is going on */

static const char manifest[] =
    "return { id = 'midway', title = 'Midway', author = 'Curtain', version = 1, players = 2,\n"
    "  screen = { w = 160, h = 160 }, field = { x = 8, y = 16, w = 144, h = 136, margin = 16 },\n"
    "  board = { bullets = 512, shots = 64, enemies = 16, sprites = 24, tasks = 96, lua_kib = 768, items = 128,\n"
    "    lasers = 8, options = 8, registers = 16, bodies = true },\n"
    "  sheets = { all = { file = 'art/all.png' } }, sprites = { dot = { sheet = 'all', x = 0, y = 0, w = 8, h = 8 },\n"
    "    dart = { sheet = 'all', x = 0, y = 0, w = 8, h = 4, rotations = 8 } } }\n";

static const char game[] =
    "bullet.def('orb', { sprite = 'dot', hit = { circle = 2 } })\n"
    "shot.def('bolt', { sprite = 'dart', hit = { box = { 3, 5 } }, damage = 2 })\n"
    "item.def('gem', { sprite = 'dot', radius = 6, gives = { score = 10 } })\n"
    "laser.def('torch', { strip = 'dart', width = 6, hit = { share = 1 }, damage = 1, every = 6 })\n"
    "option.def('bead', { sprite = 'dot' })\n"
    "bomb.def('wave', { over = 70, safe = 80, run = function(p)\n"
    "  print 'a bomb'\n"
    "  bullet.sweep { follow = p, radius_to = 120, over = 60, items = 'gem', hurt = 1, by = p }\n"
    "  laser.beam { kind = 'torch', follow = p, dir = 270, length = 90, hold = 40, warn = 0 }\n"
    "  wait(20) board.stop(4)\n"
    "end })\n"
    "game.def { registers = { rank = { start = 1, max = 9, drain = -1, every = 60 } } }\n"
    "player.def('ship', { sprite = 'dart', hit = { circle = 2 }, lives = 3, safe = 60, bomb = 'wave', deathbomb = 8,\n"
    "  registers = { bombs = { start = 3, max = 9, show = 'icons' }, heat = { max = 60, drain = 1, every = 4 } },\n"
    "  options = { kind = 'bead', style = 'trail', apart = 8, levels = { { n = 2 } } },\n"
    "  run = function(p) while true do\n"
    "    if pad.down('fire', p) then shot.fire { kind = 'bolt', from = p, dir = 270, speed = 6, by = p } end\n"
    "    p.heat = p.heat + rng.int(0, 2) wait(4) end end })\n"
    "enemy.def('king', { sprite = 'dot', hit = { box = { 8, 8 } } })\n"
    "enemy.def('fly', { sprite = 'dot', hit = { circle = 4 }, hp = 6, score = 100, drops = { gem = 2 },\n"
    "  run = function(e) while true do bullet.fire { from = e, kind = 'orb', aim = true, speed = 1.5 } wait(25) end "
    "end "
    "})\n"
    "local function rings(e) while true do\n"
    "  pattern.ring { from = e, kind = 'orb', n = 9, dir = rng.dir(), speed = 1.2 } wait(22) end end\n"
    "boss.def('twins', { title = 'Two', portrait = 'dart', warning = 40,\n"
    "  cast = { { name = 'left', title = 'L', kind = 'king', x = 40, y = 30 },\n"
    "           { name = 'right', title = 'R', kind = 'king', x = 104, y = 30 } }, phases = {\n"
    "  { id = 'one', hp = { left = 30, right = 60 }, time = 240, rest = 10, run = {\n"
    "      left = function(e) print 'two bosses' rings(e) end,\n"
    "      right = function(e) e:wander { w = 30, h = 20, every = 25, over = 20 } rings(e) end } },\n"
    "  { talk = function() print 'among phases' say('king', 'Not bad, for a lamp.', { limit = 60 }) end },\n"
    "  { id = 'two', spell = 'Both of them', hp = 400, time = 500, bonus = 900, bonus_to = 0, run = function(l, r)\n"
    "      print 'a spell' task.go(rings, l) rings(r) end } } })\n"
    "talk.def('ana', { name = 'Ana', faces = { calm = 'dart' } })\n"
    "talk.def('king', { name = 'King', faces = { calm = 'dot' }, side = 'right' })\n"
    "local way = path.def { { x = 20, y = -4 }, { x = 30, y = 40, over = 60 }, { x = 60, y = 170, over = 120 } }\n"
    "stage.def('all', function()\n"
    "  stage.mark 'talk'\n"
    "  talk.run(function()\n"
    "    print 'a line' say('ana', 'These are words that come one by one.', { letter = 3, limit = 30 })\n"
    "    print 'a choice' board.note(choose({ 'GO', 'STAY', 'SING' }, { limit = 80, back = 2 }))\n"
    "    say('king', 'So be it.', { limit = 40 })\n"
    "  end)\n"
    "  stage.mark 'wave'\n"
    "  stage.wave { kind = 'fly', n = 6, every = 12, path = way, dx = 14 }\n"
    "  stage.clear(160)\n"
    "  boss.fight 'twins'\n"
    "end)\n"
    "on.continue(function() print 'a continue' end)\n"
    "boot.run { stages = { 'all' }, players = { 'ship' }, continues = 2 }\n"
    "-- the words of a comment\n";

/* How a run begins, and what it was like when nothing disturbed it. */
static struct run {
    const char *section; /* "": from the title */
    const char *wanted;  /* the moments it must have */
    struct board_start start;
    uint16_t pads[FRAMES][MAX_PLAYERS];
    uint64_t plain[FRAMES + 1];
    uint32_t moments;
    struct moment {
        uint32_t frame;
        char name[16];
    } moment[MOMENTS];
} runs[] = {
    { .section = "", .wanted = "a line, a choice, a bomb, two bosses, among phases, a spell, a pause, a continue" },
    { .section = "all:talk", .wanted = "a line, a choice, a bomb, two bosses, among phases, a spell" },
    { .section = "twins/two", .wanted = "a bomb, a spell" },
};

enum { RUNS = sizeof runs / sizeof *runs };

static char dir[256];
static struct rom_image image;
static struct cart cart;
static char err[1200];

static void put(const char *name, const char *text)
{
    char path[300];

    snprintf(path, sizeof path, "%s/%s", dir, name);
    assert_true(plat_save(path, text, strlen(text)));
}

/* By hand: the way through the title for two, then anything, and START now and then, once for a pause. */
static void press(struct run *run)
{
    const bool title = !*run->section;
    struct rng rng;

    rng_seed(&rng, 11);
    for (uint32_t f = 0; f < FRAMES; f++) {
        for (uint32_t p = 0; p < MAX_PLAYERS; p++) {
            uint16_t *pads = &run->pads[f][p];
            rig_pads(&rng, run->pads[f]);
            *pads &= PAD_LEFT | PAD_RIGHT | PAD_UP | PAD_DOWN;
            *pads |= f / 6 % 2 ? PAD_FIRE : 0;
            *pads |= (f + 70 * p) % 390 == 350 ? PAD_BOMB : 0;
            *pads |= f > 1200 && f % 240 < 2 ? PAD_START : 0;
            if (title && f < 80)
                *pads = p ? 0 : f == 20 || f == 50 ? PAD_FIRE : f == 35 ? PAD_DOWN : 0;
        }
        if (title && f >= 700 && f < 740)
            run->pads[f][0] = f == 700 ? PAD_START : f == 730 ? PAD_FIRE : 0, run->pads[f][1] = 0;
    }
}

static void note(struct run *run, uint32_t frame, const char *name, size_t n)
{
    struct moment *m = &run->moment[run->moments];

    for (uint32_t i = 0; i < run->moments; i++)
        if (!strncmp(run->moment[i].name, name, n))
            return; /* the first of them is enough */
    if (run->moments == MOMENTS || n >= sizeof m->name)
        fail_msg("frame %u: \"%.*s\"", frame, (int)n, name);
    m->frame = frame + LATER;
    memcpy(m->name, name, n);
    run->moments++;
}

static void straight(struct run *run, const struct rom_image *rom, const struct cart *its)
{
    const struct rig_game g = { .image = *rom, .cart = *its };
    struct rig r;

    rig_power(&r, &g, &run->start);
    for (uint32_t f = 0; f < FRAMES; f++) {
        run->plain[f] = board_hash(r.b);
        rig_tick(&r, run->pads[f]);
        const struct board_out *out = board_last_output(r.b);
        if (out->fault)
            fail_msg("%s", out->fault->message);
        for (size_t at = 0, n; at < out->log_size; at += n + 1) {
            n = strcspn(out->log + at, "\n");
            note(run, f + 1, out->log + at, n);
        }
        if (r.b->core.frozen > 0 && f < 740)
            note(run, f + 1, "a pause", 7);
    }
    run->plain[FRAMES] = board_hash(r.b);
    rig_free(&r);
}

static int open_game(void **state)
{
    char command[600];

    (void)state;
    assert_true(temp_folder(dir, sizeof dir, "curtain-midway"));
    snprintf(command, sizeof command, "mkdir '%s/art' && cp tests/demos/whole/art/all.png '%s/art'", dir, dir);
    assert_int_equal(system(command), 0);
    put("rom.lua", manifest);
    put("main.lua", game);
    if (!pack_load_game(dir, false, &image, err, sizeof err) || !cart_open(&cart, &image.rom, err, sizeof err))
        fail_msg("%s", err);
    for (int i = 0; i < RUNS; i++) {
        struct board_start start = { .seed = 3, .difficulty = -1 };
        runs[i].start = start;
        snprintf(runs[i].start.practice.section, sizeof start.practice.section, "%s", runs[i].section);
        press(&runs[i]);
        straight(&runs[i], &image, &cart);
    }
    return 0;
}

static int close_game(void **state)
{
    char command[300];

    (void)state;
    rom_image_free(&image);
    snprintf(command, sizeof command, "rm -rf '%s'", dir);
    return system(command);
}

/* Each run comes by all that it is made for. */
TEST(comes_by)
{
    for (int i = 0; i < RUNS; i++) {
        char all[400] = "";
        for (uint32_t k = 0; k < runs[i].moments; k++)
            snprintf(all + strlen(all), sizeof all - strlen(all), "%s%s", k ? ", " : "", runs[i].moment[k].name);
        for (const char *w = runs[i].wanted; *w; w += strspn(w, ", ")) {
            const size_t n = strcspn(w, ",");
            char one[20];
            snprintf(one, sizeof one, "%.*s", (int)n, w);
            if (!strstr(all, one))
                fail_msg("\"%s\": no %s: %s", runs[i].section, one, all);
            w += n;
        }
    }
}

/* ---- a session in the middle of it ---- */

static const struct run *now; /* and the moment, for messages */
static const struct moment *when;

static void opened(struct session *s, const struct demo *d, const char *record)
{
    if (!session_open(s, &cart, &now->start, d, record))
        fail_msg("%s", s->err);
}

static void as_it_was(const struct session *s, const char *what)
{
    const uint32_t frame = board_frame(session_board(s));

    if (board_hash(session_board(s)) != now->plain[frame])
        fail_msg("\"%s\", %s (frame %u), %s: frame %u is not as it was", now->section, when->name, when->frame, what,
                 frame);
}

static void play_to(struct session *s, uint32_t frame)
{
    while (board_frame(session_board(s)) < frame)
        assert_true(session_tick(s, now->pads[board_frame(session_board(s))]));
}

static void work(struct session *s)
{
    if (!session_work(s, UINT64_MAX))
        fail_msg("%s", s->err);
    assert_int_equal(s->state, SESSION_PLAYING);
}

static uint32_t soon(void)
{
    return when->frame + 60 < FRAMES ? when->frame + 60 : FRAMES;
}

/* Goes on, and to the end now and then. */
static void goes_on(struct session *s, const char *what)
{
    play_to(s, when == &now->moment[1] ? FRAMES : soon());
    as_it_was(s, what);
}

static void each_moment(void (*f)(void))
{
    for (int i = 0; i < RUNS; i++)
        for (uint32_t k = 0; k < runs[i].moments; k++) {
            now = &runs[i];
            when = &now->moment[k];
            f();
        }
}

/* Into the middle of it, out of it backwards, and into it with other hands: then all as it was. */
static void back(void)
{
    static const uint16_t other[MAX_PLAYERS] = { PAD_FIRE | PAD_BOMB | PAD_DOWN, PAD_UP };
    struct session s;

    opened(&s, NULL, NULL);
    play_to(&s, soon());
    session_goto(&s, when->frame);
    work(&s);
    as_it_was(&s, "gone back into");
    for (int i = 0; i < 15; i++)
        assert_true(session_tick(&s, other));
    session_goto(&s, when->frame > LATER + 2 ? when->frame - LATER - 2 : 0);
    work(&s);
    as_it_was(&s, "gone back before");
    goes_on(&s, "played on");
    assert_true(session_close(&s));
}

TEST(rewinds)
{
    each_moment(back);
}

static struct demo recorded(void)
{
    char path[300];
    struct session s;
    struct demo d;

    snprintf(path, sizeof path, "%s/run.demo", dir);
    opened(&s, NULL, path);
    play_to(&s, FRAMES);
    as_it_was(&s, "recorded");
    assert_true(session_close(&s));
    if (!demo_load(&d, path, err, sizeof err))
        fail_msg("%s", err);
    assert_int_equal(remove(path), 0);
    return d;
}

static struct demo d;

/* A playback taken over in the middle of it is the run that it was. */
static void over(void)
{
    struct session s;

    opened(&s, &d, NULL);
    session_goto(&s, when->frame);
    work(&s);
    as_it_was(&s, "played back");
    assert_true(session_take_over(&s, NULL));
    goes_on(&s, "taken over");
    session_goto(&s, when->frame - LATER);
    work(&s);
    as_it_was(&s, "taken over and gone back");
    assert_true(session_close(&s));
}

TEST(takes_over)
{
    for (int i = 0; i < RUNS; i++) {
        now = &runs[i];
        when = &now->moment[0];
        d = recorded();
        for (uint32_t k = 0; k < now->moments; k++, when++)
            over();
        demo_free(&d);
    }
}

/* Begun anew in the middle of it, as R in practice: the same again, and nothing of the try before is left. */
static void anew(void)
{
    struct session s;

    opened(&s, NULL, NULL);
    play_to(&s, when->frame);
    assert_true(session_restart(&s, &now->start));
    play_to(&s, when->frame);
    as_it_was(&s, "begun anew");
    goes_on(&s, "begun anew");
    assert_true(session_close(&s));
}

TEST(restarts)
{
    each_moment(anew);
}

/* A file saved in the middle of it: words that no run comes by change nothing; what is said is another run from its
 * beginning on, and with the old words it is the old one. */
static void edited(void)
{
    static char text[sizeof game];
    static struct run other;
    struct rom_image changed;
    struct cart its;
    struct session s;

    opened(&s, NULL, NULL);
    play_to(&s, when->frame);
    memcpy(text, game, sizeof game);
    memcpy(strstr(text, "-- the words"), "-- THE", 6);
    put("main.lua", text);
    assert_true(session_reload(&s, pack_load_game, dir, false));
    assert_int_equal(s.state, SESSION_RELOADING);
    work(&s);
    as_it_was(&s, "reloaded");
    memcpy(strstr(text, "words that come"), "WORDS", 5);
    memcpy(strstr(text, "Both of them"), "BOTH", 4);
    put("main.lua", text);
    assert_true(session_reload(&s, pack_load_game, dir, false));
    work(&s);
    assert_true(pack_load_game(dir, false, &changed, err, sizeof err));
    assert_true(cart_open(&its, &changed.rom, err, sizeof err));
    other = *now;
    straight(&other, &changed, &its);
    rom_image_free(&changed);
    assert_true(board_hash(session_board(&s)) == other.plain[when->frame]);
    play_to(&s, soon());
    assert_true(board_hash(session_board(&s)) == other.plain[soon()]);
    assert_true(other.plain[FRAMES] != now->plain[FRAMES]);
    put("main.lua", game);
    assert_true(session_reload(&s, pack_load_game, dir, false));
    work(&s);
    as_it_was(&s, "reloaded as it was");
    goes_on(&s, "reloaded as it was");
    assert_true(session_close(&s));
}

TEST(reloads)
{
    each_moment(edited);
}

RUN_TESTS(open_game, close_game)
