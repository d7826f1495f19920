/*
 * test_torture.c - snapshots. After every frame all of RAM is spoilt and put back, and the board goes on as one that
 * was never disturbed: same hashes, same pictures by whichever view, same samples. And: from any frame of a run, play
 * on with other pads, spoil, go back, and the run is the same as it was. CURTAIN_LONG=1: more frames.
 */
#include "../../src/player/picture/shade.h"
#include "rig.h"

static void *tables; /* of board_mix_sound */
static struct shade_cache shades;

/* The picture, by a view that the frame picks, and the samples of a game that has any, as one number. */
static uint64_t seen_and_heard(struct rig *r)
{
    const uint32_t any = board_frame(r->b) * 2654435769u >> 16;
    const struct view view = rig_view((int)(any % RIG_VIEWS), shade_get_tables(&shades, &r->game->cart));
    int16_t sound[2 * BOARD_SOUND_FRAMES];

    if (!tables) {
        tables = malloc(board_sound_tables_size());
        board_sound_init_tables(tables);
    }
    board_mix_sound(r->b, tables, sound);
    return hash_bytes(rig_picture_by(r, &view), sound, sizeof sound);
}

/* ---- games ---- */

/* All of its state is in Lua: tables, closures, strings, metatables, and tasks that sleep deep inside of calls. */
static const char lua_only[] =
    "local tree, log, live = {}, {}, 0\n"
    "local function counter(step)\n"
    "  local n = 0\n"
    "  return function() n = n + step return n end, function() return n end\n"
    "end\n"
    "local function insert(t, k)\n"
    "  if not t.k then t.k = k return end\n"
    "  local side = k < t.k and 'l' or 'r'\n"
    "  t[side] = t[side] or {}\n"
    "  insert(t[side], k)\n"
    "end\n"
    "local function walk(t, depth, f)\n"
    "  if not t.k then return end\n"
    "  if t.l then walk(t.l, depth + 1, f) end\n"
    "  f(t.k, depth)\n"
    "  if t.r then walk(t.r, depth + 1, f) end\n"
    "end\n"
    "local function nap(n) if n == 0 then wait(1) return 1 end local ok, v = pcall(nap, n - 1) return v + 1 end\n"
    "local function worker(id)\n"
    "  local bump, read = counter(id)\n"
    "  local keep <close> = setmetatable({}, { __close = function() live = live - 1 end })\n"
    "  live = live + 1\n"
    "  for round = 1, 20 + id do\n"
    "    bump()\n"
    "    log[#log + 1] = ('%d:%d:%s'):format(id, read(), ('x'):rep(id * round % 40))\n"
    "    board.note(nap(id % 7))\n"
    "    walk(tree, 0, function(k, d) if k % 7 == id % 7 and d > 3 then wait(1) end end)\n"
    "  end\n"
    "end\n"
    "task.go(function()\n"
    "  for i = 0, forever do\n"
    "    insert(tree, rng.int(1, 100000))\n"
    "    if i % 400 == 399 then tree = {} end\n"
    "    if i % 10 == 0 then task.go(worker, i // 10 % 30) end\n"
    "    if #log > 200 then log = { table.concat(log, ','):sub(-100) } end\n"
    "    board.note(#log) board.note(live) board.note(log[#log] or '')\n"
    "    wait(1)\n"
    "  end\n"
    "end)\n";

/* ---- every frame ---- */

static void same(const char *name, uint32_t frame, struct rig *a, struct rig *b)
{
    const char *part = rig_differs(a, b);

    if (part)
        fail_msg("%s: frame %u: part %s differs", name, frame, part);
    if (seen_and_heard(a) != seen_and_heard(b))
        fail_msg("%s: frame %u: the picture differs", name, frame);
}

/* calm is left alone; hurt is saved, spoilt and restored after each frame. d NULL: pads by hand, from start. */
static void every_frame(const char *name, const struct rig_game *g, const struct board_start *start,
                        const struct demo *d, uint32_t frames)
{
    struct rig calm, hurt;
    struct rng rng;
    uint16_t pads[MAX_PLAYERS] = { 0 };

    rig_power(&calm, g, d ? &d->start : start);
    rig_power(&hurt, g, d ? &d->start : start);
    rng_seed(&rng, 11);
    for (uint32_t f = 0; f < frames; f++) {
        rig_spoil(&hurt);
        same(name, f, &calm, &hurt);
        if (f % 64 == 0)
            assert_true(heap_check(hurt.b->vm.heap));
        if (d)
            demo_pads(d, f, pads);
        else
            rig_pads(&rng, pads);
        rig_tick(&calm, pads);
        rig_tick(&hurt, pads);
    }
    same(name, frames, &calm, &hurt);
    rig_free(&calm);
    rig_free(&hurt);
}

static uint32_t most(uint32_t brief, uint32_t full)
{
    return rig_long() ? full : brief;
}

/* Of a folder in roms/: its demos if it has any, and pads by hand. */
static void folder(const char *name, const char *const *demos, uint32_t brief, uint32_t full)
{
    struct rig_game g;
    struct demo d;

    rig_folder(&g, name);
    every_frame(name, &g, NULL, NULL, most(brief, full));
    for (; *demos; demos++) {
        memset(&d, 0, sizeof d);
        if (!rig_demo(&g, *demos, &d))
            continue;
        every_frame(*demos, &g, NULL, &d, d.frames < most(brief, full) ? d.frames : most(brief, full));
        demo_free(&d);
    }
    rig_game_free(&g);
}

TEST(torture)
{
    const char *const demos[] = { "torture", NULL };

    folder("torture", demos, 1000, 20000);
}

TEST(glasstide)
{
    const char *const demos[] = { "attract", "run", "whole", NULL };

    folder("glasstide", demos, 1000, 30000);
}

/* A game with all of the shell and the library: menus, talks, bombs, continues, several bosses, names and scores. */
TEST(whole)
{
    char path[64], err[512];
    struct rig_game g;
    struct demo d;

    snprintf(path, sizeof path, "tests/demos/whole%d-run.demo", CORE_VERSION);
    rig_folder(&g, "tests/demos/whole");
    assert_true(demo_load(&d, path, err, sizeof err));
    every_frame("whole", &g, NULL, &d, d.frames);
    demo_free(&d);
    rig_game_free(&g);
}

/* Documents of BulletML, one after the other as the pads by hand ask for them: titles, ranks and seeds change, too. */
TEST(gallery)
{
    struct board_start start = { .seed = 3, .dip = { 1, 70, 1, 100 }, .difficulty = -1 };
    struct rig_game g;

    snprintf(start.practice.section, sizeof start.practice.section, "gallery");
    rig_folder(&g, "examples/bulletml");
    for (int i = 1; i <= (int)most(3, 16); i++) {
        start.dip[0] = i;
        every_frame("gallery", &g, &start, NULL, most(200, 1500));
    }
    rig_game_free(&g);
}

TEST(lua_only)
{
    struct rig_game g;

    rig_script(&g, NULL, lua_only);
    every_frame("lua", &g, NULL, NULL, most(1200, 6000));
    rig_game_free(&g);
}

/* ---- any frame of a run ---- */

struct run {
    const struct rig_game *g;
    uint32_t frames;
    uint16_t (*pads)[MAX_PLAYERS];
    uint64_t *hash, *picture; /* of every frame, 0 .. frames */
};

/* The run as it is when nobody disturbs it. */
static void run_make(struct run *run, const struct rig_game *g, uint32_t frames, uint64_t seed)
{
    struct rig r;
    struct rng rng;
    uint16_t pads[MAX_PLAYERS] = { 0 };

    *run = (struct run){ .g = g, .frames = frames };
    run->pads = calloc(frames, sizeof *run->pads);
    run->hash = calloc(frames + 1, sizeof *run->hash);
    run->picture = calloc(frames + 1, sizeof *run->picture);
    rig_power(&r, g, NULL);
    rng_seed(&rng, seed);
    for (uint32_t f = 0;; f++) {
        run->hash[f] = board_hash(r.b);
        run->picture[f] = seen_and_heard(&r);
        if (f == frames)
            break;
        rig_pads(&rng, pads);
        memcpy(run->pads[f], pads, sizeof pads);
        rig_tick(&r, pads);
    }
    rig_free(&r);
}

static void run_free(struct run *run)
{
    free(run->pads);
    free(run->hash);
    free(run->picture);
}

enum { ASTRAY = 300, AGAIN = 600 };

/* From frame `from` on: the same n frames as the run's. */
static void again(const struct run *run, struct rig *r, uint32_t from, uint32_t n, bool pictures)
{
    for (uint32_t f = from; f < from + n; f++) {
        rig_tick(r, run->pads[f]);
        if (board_hash(r->b) != run->hash[f + 1])
            fail_msg("back to frame %u: the hash of frame %u differs", from, f + 1);
        if (pictures && seen_and_heard(r) != run->picture[f + 1])
            fail_msg("back to frame %u: the picture of frame %u differs", from, f + 1);
    }
}

/* Goes back to n frames of the run, which are drawn so that each frame has the same chance. */
static void go_back(const struct run *run, uint32_t n)
{
    struct rig r;
    struct rng rng;
    uint16_t astray[MAX_PLAYERS] = { 0 };
    uint32_t left = n;

    rng_seed(&rng, 21);
    rig_power(&r, run->g, NULL);
    for (uint32_t f = 0; f + AGAIN < run->frames; f++) {
        if (rng_below(&rng, run->frames - AGAIN - f) < left) {
            left--;
            rig_save(&r);
            for (int i = 0; i < ASTRAY; i++) {
                rig_pads(&rng, astray);
                rig_tick(&r, astray);
            }
            rig_restore(&r);
            if (board_hash(r.b) != run->hash[f] || seen_and_heard(&r) != run->picture[f])
                fail_msg("back to frame %u: not what was saved", f);
            again(run, &r, f, AGAIN, true);
            rig_restore(&r);
        }
        again(run, &r, f, 1, false);
    }
    assert_int_equal(left, 0);
    rig_free(&r);
}

TEST(back)
{
    static const char *const names[] = { "torture", "glasstide" };

    for (int i = 0; i < 2; i++) {
        struct rig_game g;
        struct run run;
        rig_folder(&g, names[i]);
        run_make(&run, &g, 6000, 5);
        go_back(&run, most(6, 1000));
        run_free(&run);
        rig_game_free(&g);
    }
}

RUN_TESTS(NULL, NULL)
