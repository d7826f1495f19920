/*
 * test_profile.c - lines of Lua, counted: every instruction and every call for the line that it stands in, the
 * library's for the author's line; and the run is the same one.
 */
#include "rig.h"
#include "../../src/script/api/eval.h"
#include "../../src/script/profile.h"

enum { FRAMES = 20, STACK = 200 /* work of growing a stack */ };

static struct profile profile;
static struct rig_game g;
static struct rig r;

static const struct profile_line *line_of(const char *place)
{
    static const struct profile_line none = { .location = "" };

    for (int i = 0; i < PROFILE_CAPACITY; i++)
        if (strcmp(profile.line[i].location, place) == 0)
            return &profile.line[i];
    return &none;
}

static uint64_t sum(void)
{
    uint64_t n = profile_work(&profile.overflow);

    for (int i = 0; i < PROFILE_CAPACITY; i++)
        n += profile_work(&profile.line[i]);
    return n;
}

static void begin(const char *script)
{
    memset(&profile, 0, sizeof profile);
    rig_script(&g, NULL, script);
    rig_power(&r, &g, NULL);
}

static const char counts[] = "task.go(function()\n"
                             "  while true do\n"
                             "    local n = 0\n"
                             "    for i = 1, 100 do n = n + i end\n"
                             "    for i = 1, 200 do n = n + i end\n"
                             "    board.note(n)\n"
                             "    board.note(n) board.note(n)\n"
                             "    wait(1)\n"
                             "  end\n"
                             "end)\n";

TEST(exact)
{
    begin(counts);
    rig_run(&r, 1);
    board_set_profile(r.b, &profile);
    rig_run(&r, FRAMES);
    board_set_profile(r.b, NULL);
    rig_run(&r, FRAMES); /* after the end no line is counted */
    const uint64_t once = line_of("main.lua:4")->instructions, twice = line_of("main.lua:5")->instructions;
    assert_int_equal(twice - once, FRAMES * 100 * 2); /* an addition and the loop's own instruction */
    assert_in_range(once, FRAMES * 200, FRAMES * 210);
    assert_int_equal(line_of("main.lua:4")->call_work, 0);
    assert_int_equal(line_of("main.lua:3")->instructions, FRAMES);
    assert_in_range(line_of("main.lua:6")->call_work, FRAMES * WORK_CALL, FRAMES * (WORK_CALL + 10));
    assert_int_equal(line_of("main.lua:7")->call_work, 2 * line_of("main.lua:6")->call_work);
    assert_true(line_of("main.lua:8")->call_work >= FRAMES * WORK_CALL);
    assert_int_equal(line_of("main.lua:1")->instructions, 0);
    assert_int_equal(sum(), profile_work(&profile.total));
    assert_int_equal(profile_work(&profile.overflow), 0);
    rig_close(&r);
}

static const char library[] =
    "bullet.def('orb', { sprite = 'dot', hit = { circle = 3 } })\n"
    "task.go(function()\n"
    "  while true do\n"
    "    pattern.fan { kind = 'orb', x = 100, y = 80, n = 6, spread = 60, dir = 90, speed = 2 }\n"
    "    wait(10)\n"
    "  end\n"
    "end)\n"
    "task.go(pattern.spiral, { kind = 'orb', x = 100, y = 90, n = 400, every = 1, step = 7, speed = 1 })\n";

/* What the library does at once is its caller's, what it does in a task of its own is the line's that started that. */
TEST(of_author)
{
    begin(library);
    board_set_profile(r.b, &profile);
    rig_run(&r, 4 * FRAMES);
    board_set_profile(r.b, NULL);
    assert_true(r.b->bullets.s.live > 40);
    assert_true(line_of("main.lua:4")->library_instructions >= 8 * 2);
    assert_true(line_of("main.lua:8")->library_instructions > (4 * FRAMES - 1) * 3);
    assert_int_equal(line_of("main.lua:5")->library_instructions, 0);
    for (int i = 0; i < PROFILE_CAPACITY; i++)
        assert_true(strncmp(profile.line[i].location, "@std/", 5) != 0);
    assert_int_equal(profile.total.library_instructions,
                     line_of("main.lua:4")->library_instructions + line_of("main.lua:8")->library_instructions);
    rig_close(&r);
}

/* A handler that a line between frames calls is the last to run before the next tick, whose work begins at 0 again. */
TEST(between_frames)
{
    static const char script[] = "enemy.def('fly', { sprite = 'dot', hp = 5, hit = { circle = 8 } })\n"
                                 "on.kill(function()\n"
                                 "  local n = 0\n"
                                 "  for i = 1, 100 do n = n + i end\n"
                                 "end)\n"
                                 "task.go(function() wait(forever) end)\n";
    char out[EVAL_TEXT_SIZE];

    begin(script);
    rig_run(&r, 1);
    board_set_profile(r.b, &profile);
    assert_true(board_eval(r.b, "enemy.spawn({ kind = 'fly', x = 100, y = 50 }):kill()", out, sizeof out));
    rig_run(&r, 2);
    assert_in_range(line_of("main.lua:4")->instructions, 200, 210);
    assert_in_range(profile_work(&profile.total), 200 + WORK_CALL, 200 + 10 * WORK_CALL);
    assert_int_equal(sum(), profile_work(&profile.total));
    rig_close(&r);
}

/* Every frame's hash is the one without, and so is its work, but for where Lua's stacks grow; also through a reset,
 * which gives the board another heap, and with turns inside of turns. */
TEST(changes_nothing)
{
    static const char script[] =
        "bullet.def('orb', { sprite = 'dot', hit = { circle = 3 } })\n"
        "task.go(function()\n"
        "  for i = 1, forever do\n"
        "    local t = { a = i, b = { i }, [i] = tostring(i) }\n"
        "    bullet.fire { kind = 'orb', x = rng.int(10, 200), y = 20, dir = 90, speed = #t.b }\n"
        "    for k in pairs(t) do board.note(#tostring(k)) end\n"
        "    local s = task.go(function() for k = 1, 700 do if k == 300 then wait(1) end end end)\n"
        "    for k = 1, 900 do if k == 400 then task.stop(s) end end\n"
        "    if board.frame() == 60 then board.reset() end\n"
        "    wait(1)\n"
        "  end\n"
        "end)\n";
    struct rig other;

    begin(script);
    rig_power(&other, &g, NULL);
    board_set_profile(r.b, &profile);
    for (int f = 0; f < 120; f++) {
        rig_run(&r, 1);
        rig_run(&other, 1);
        assert_true(board_hash(r.b) == board_hash(other.b));
        assert_in_range(r.b->vm.work + STACK, other.b->vm.work, other.b->vm.work + 2 * STACK);
    }
    assert_true(line_of("main.lua:5")->call_work >= 119 * WORK_CALL);
    assert_true(line_of("main.lua:4")->allocated_bytes > 119 * 100 &&
                line_of("main.lua:4")->allocated_bytes < 119 * 4000);
    assert_int_equal(sum(), profile_work(&profile.total));
    assert_in_range(profile_work(&profile.total), 119 * 500, 119 * 9000);
    rig_free(&other);
    rig_close(&r);
}

/* Powers a board with `pad` more bytes on the C stack: Lua draws the seed of its tables from the address of a local. */
static void power_at(struct rig *at, int pad)
{
    volatile char bytes[16];

    bytes[0] = (char)pad;
    if (pad > 0)
        power_at(at, pad - 1);
    else
        rig_power(at, &g, NULL);
    (void)bytes[0];
}

/* Whether a script is stopped must not depend on the order that Lua's tables have: work is the same for every seed, but
 * for strings that are made again because the collector has freed them: it traverses tables in their order. */
TEST(work_is_the_same_for_every_seed)
{
    static const char script[] =
        "bullet.def('orb', { sprite = 'dot', hit = { circle = 3 } })\n"
        "local heart = '.##...##.\\n####.####\\n#########\\n#########\\n.#######.\\n..#####..\\n...###...'\n"
        "local function make(a, b, c, d, e, f) return { kind = a, x = b, y = c, dir = d, speed = e, tag = f } end\n"
        "local function three(a, b, c) local t = { a, b, c } return #t end\n"
        "-- Their unused registers hold what earlier calls left.\n"
        "local function few() local n = 0 for i = 1, 3000 do n = n + 1 end return three(n, n, n) end\n"
        "local function more()\n"
        "  local n = 0\n"
        "  for i = 1, 3000 do n = n + 1 end\n"
        "  return { n, n, n, n, n, n, n, n }\n"
        "end\n"
        "task.go(function()\n"
        "  for i = 1, forever do\n"
        "    bullet.fire(make('orb', 20, 30, 45, 1.25, 'low'))\n"
        "    few() more()\n"
        "    pattern.picture { x = 100, y = 100, kind = 'orb', gap = 11, dots = heart, aim = true, speed = 1.3,\n"
        "      tag = 'heart' .. i % 4 }\n"
        "    for k in pairs { one = 1, two = 2.5, three = 3, four = 4.5, five = 5, six = 6, seven = 7.5 } do\n"
        "      three(k, k, k)\n"
        "    end\n"
        "    wait(1)\n"
        "  end\n"
        "end)\n";
    enum { SEEDS = 12, STRINGS = 200 /* of about 50,000 */ };
    struct rig seed[SEEDS];

    rig_script(&g, NULL, script);
    for (int i = 0; i < SEEDS; i++)
        power_at(&seed[i], i);
    for (int f = 0; f < 200; f++)
        for (int i = 0; i < SEEDS; i++) {
            rig_run(&seed[i], 1);
            assert_in_range(seed[i].b->vm.work + STRINGS, seed[0].b->vm.work, seed[0].b->vm.work + 2 * STRINGS);
        }
    for (int i = 0; i < SEEDS; i++)
        rig_free(&seed[i]);
    rig_game_free(&g);
}

RUN_TESTS(NULL, NULL)
