/*
 * test_eval.c - lines of Lua between frames: what they say, what they change, and that a restored board is as it was.
 */
#include "rig.h"
#include "../../src/script/api/eval.h"

static const char scene[] =
    "bullet.def('dot', { sprite = 'dot', hit = { circle = 2 } })\n"
    "enemy.def('fly', { sprite = 'dot', hp = 5, hit = { circle = 8 } })\n"
    "player.def('ship', { sprite = 'dot', hit = { circle = 2 } })\n"
    "string.killed = 0\n"
    "on.kill(function(e) string.killed = string.killed + 1 print('killed', string.killed) end)\n"
    "task.go(function()\n"
    "  string.sys.join(1, 'ship')\n"
    "  enemy.spawn { kind = 'fly', x = 100, y = 50, tag = 'flies' }\n"
    "  while true do bullet.fire { kind = 'dot', x = rng.int(10, 90), y = 9, speed = 1 } wait(5) end\n"
    "end)\n";

struct bed {
    struct rig_game g;
    struct rig r;
    uint8_t *image, *again; /* of the board as it was, and as it is */
    size_t size, room;
    char out[EVAL_TEXT_SIZE];
};

static int bed_open(void **state)
{
    struct bed *t = calloc(1, sizeof *t);

    rig_with_sys(&t->g, NULL, scene);
    rig_power(&t->r, &t->g, NULL);
    rig_run(&t->r, 20);
    *state = t;
    return 0;
}

static int bed_close(void **state)
{
    struct bed *t = *state;

    free(t->image);
    free(t->again);
    rig_free(&t->r);
    rig_game_free(&t->g);
    free(t);
    return 0;
}

/* Snapshots have gaps, which nobody writes. */
static void image(const struct bed *t, uint8_t *to)
{
    memset(to, 0, t->size);
    board_save(t->r.b, to);
}

static void keep_image(struct bed *t)
{
    t->size = board_snapshot_size(t->r.b);
    if (t->size > t->room) {
        t->room = t->size + t->size / 4;
        t->image = realloc(t->image, t->room);
        t->again = realloc(t->again, t->room);
    }
    image(t, t->image);
}

static void check_image(struct bed *t, const char *line)
{
    if (board_snapshot_size(t->r.b) != t->size)
        fail_msg("RAM is larger than it was before: %s", line);
    image(t, t->again);
    if (memcmp(t->image, t->again, t->size))
        fail_msg("RAM is not what it was before: %s", line);
}

/* Runs a line and puts RAM back. */
static bool run(struct bed *t, const char *line)
{
    uint64_t hash = board_hash(t->r.b);

    keep_image(t);
    bool fine = board_eval(t->r.b, line, t->out, sizeof t->out);
    board_restore(t->r.b, t->image);
    check_image(t, line);
    assert_true(board_hash(t->r.b) == hash);
    return fine;
}

static void says(struct bed *t, const char *line, const char *want)
{
    bool fine = run(t, line);

    if (!fine || strcmp(t->out, want) != 0)
        fail_msg("%s: %s\"%s\", not \"%s\"", line, fine ? "" : "failed: ", t->out, want);
}

static void fails(struct bed *t, const char *line, const char *part)
{
    bool fine = run(t, line);

    if (fine || !strstr(t->out, part) || !t->out[0] || strchr(t->out, '\n'))
        fail_msg("%s: %s\"%s\", not \"%s\"", line, fine ? "worked: " : "", t->out, part);
}

TEST(values_are_shown)
{
    struct bed *t = *state;

    says(t, "1 + 1", "2\n");
    says(t, "1, 'two', nil, 3.5, true", "1\ttwo\tnil\t3.5\ttrue\n");
    says(t, "", "");
    says(t, "print('a', 1) print('b') return 'c'", "a\t1\nb\nc\n");
    says(t, "player.get(1)", "player 1\n");
    says(t, "string.killed", "0\n");
    says(t, "{ 10, 20, x = 'y' }", "{ 10, 20, x = y }\n");
    says(t, "{ { 1 } }", "{ table }\n");
    says(t, "{ z = 1, y = 2, x = 3, w = 4, v = 5, u = 6, t = 7, s = 8, [true] = 9, [2.5] = 10, 11, 12 }",
         "{ 11, 12, 2.5 = 10, true = 9, s = 8, t = 7, u = 6, v = 5, w = 4, x = 3, y = 2, z = 1 }\n");
    says(t, "{ [{}] = 1, [{}] = 2, [print] = 3, a = 4 }", "{ table = ..., function = 3, a = 4 }\n");
}

TEST(long_answers_are_cut)
{
    struct bed *t = *state;
    char small[8];

    assert_true(run(t, "string.rep('x', 65536)"));
    assert_int_equal(strlen(t->out), 4096);
    assert_true(run(t, "local a = {} for i = 1, 1000 do a[i] = i end return a"));
    assert_non_null(strstr(t->out, "23, 24, ... }"));
    keep_image(t);
    assert_true(board_eval(t->r.b, "'abcdefghijkl'", small, sizeof small));
    assert_string_equal(small, "abcdefg");
}

TEST(mistakes_are_told)
{
    struct bed *t = *state;

    fails(t, "1 +", "unexpected symbol");
    fails(t, "nothing_such", "undeclared global \"nothing_such\"");
    fails(t, "wait(1)", "only a task can wait");
    fails(t, "error('mine')", "mine");
    fails(t, "error({})", "expected a string as the error value");
    fails(t, "bullet.def('more', { sprite = 'dot', hit = 'none' })", "load");
    fails(t, "string.sys.join(9, 'ship')", "1, 2");
    assert_true(strncmp(t->out, "console", 7) != 0);
}

TEST(what_does_not_end_is_ended)
{
    struct bed *t = *state;

    fails(t, "while true do end", "infinite loop: more than 10000000 instructions in one line");
    fails(t, "local function f() return 1 + f() end return f()", "recursion");
    fails(t, "local a = {} while true do a[#a + 1] = string.rep('x', 1000) .. #a end", "out of Lua memory");
    fails(t, "setmetatable({}, { __tostring = function() while true do end end })", "infinite loop");
    fails(t, "local x <close> = setmetatable({}, { __close = function() while true do end end }) while true do end",
          "infinite loop");
    says(t, "1", "1\n");
}

/* What is not restored stays, and the game goes on with it. */
TEST(what_is_kept_stays)
{
    struct bed *t = *state;
    int64_t bullets = board_live_count(t->r.b, "bullets"), tasks = board_live_count(t->r.b, "tasks");
    uint64_t hash = board_hash(t->r.b);

    assert_true(
        board_eval(t->r.b, "bullet.fire { kind = 'dot', x = 50, y = 60, speed = 1, dir = 90 }", t->out, sizeof t->out));
    assert_true(strncmp(t->out, "bullet ", 7) == 0);
    assert_true(board_live_count(t->r.b, "bullets") == bullets + 1 && board_hash(t->r.b) != hash);
    assert_int_equal(t->r.b->events.n, 0);
    assert_true(board_eval(t->r.b, "task.go(function() wait(2) string.killed = 77 end)", t->out, sizeof t->out));
    assert_true(board_live_count(t->r.b, "tasks") == tasks + 1);
    rig_run(&t->r, 3);
    says(t, "string.killed", "77\n");
    assert_true(board_live_count(t->r.b, "tasks") == tasks);
    rig_spoil(&t->r);
    rig_run(&t->r, 100);
}

/* What a line raises is applied at once: no event waits between frames. */
TEST(events_are_applied)
{
    struct bed *t = *state;

    says(t, "enemy.each('flies', function(e) e:kill() end)", "killed\t1\n");
    assert_true(board_eval(t->r.b, "enemy.each('flies', function(e) e:kill() end)", t->out, sizeof t->out));
    assert_string_equal(t->out, "killed\t1\n");
    assert_int_equal(t->r.b->events.n, 0);
    assert_int_equal(board_live_count(t->r.b, "enemies"), 0);
    says(t, "string.killed", "1\n");
    rig_run(&t->r, 50);
}

/* A line cannot reach what a tick hands out, and the next tick knows nothing of it. */
TEST(what_a_tick_hands_out_stays)
{
    struct bed *t = *state;

    assert_true(board_eval(t->r.b, "print('x')", t->out, sizeof t->out));
    assert_int_equal(board_last_output(t->r.b)->log_size, 0);
    rig_run(&t->r, 1);
    assert_int_equal(board_last_output(t->r.b)->log_size, 0);
    assert_true(board_eval(t->r.b, "board.attract('no')", t->out, sizeof t->out));
    assert_int_equal(board_last_output(t->r.b)->request, REQUEST_NONE);
    assert_true(board_eval(t->r.b, "board.reset()", t->out, sizeof t->out));
    rig_run(&t->r, 1);
    assert_int_equal(board_live_count(t->r.b, "enemies"), 0);
    rig_run(&t->r, 50);
}

/* After a fault nothing happens any more, and the fault stays: a host that does not look ends no process. */
TEST(a_board_with_a_fault_stays)
{
    const uint16_t pads[MAX_PLAYERS] = { 0 };
    struct bed *t = *state;

    assert_false(board_eval(t->r.b, "error('boo')", t->out, sizeof t->out));
    const uint32_t frame = board_frame(t->r.b);
    for (int i = 0; i < 3; i++) {
        const struct board_out *out = board_tick(t->r.b, pads);
        assert_non_null(out->fault);
        assert_string_equal(out->fault->message, "console:1: boo");
        assert_int_equal(out->log_size, 0);
    }
    assert_int_equal(board_frame(t->r.b), frame);
    assert_false(board_eval(t->r.b, "board.note(1)", t->out, sizeof t->out));
    assert_string_equal(t->out, "console:1: boo");
}

/* ---- any line ---- */

static const char words[] =
    "return local x = ( ) { } 1 'a' nil .. + - # bullet enemy player . : fire each get , function end if "
    "then while do true for in pairs print error pcall task go rng int string rep on kill sys ~ // % [ ] "
    "tostring setmetatable load \" select table sort wait stage board reset note save set <close> score "
    "add 999999999 killed == or and not goto :: ;";

/* Words and other bytes. */
static void garbage(struct rng *r, char *line, size_t size)
{
    size_t n = 0, most = rng_below(r, size - 16);

    line[0] = 0;
    while (n < most) {
        const char *word = words + rng_below(r, sizeof words - 1);
        while (word > words && word[-1] != ' ')
            word--;
        if (rng_below(r, 20) == 0)
            line[n++] = (char)(1 + rng_below(r, 255));
        else
            n += (size_t)snprintf(line + n, size - n, "%.*s ", (int)strcspn(word, " "), word);
        line[n] = 0;
    }
}

/* Any line ends, and can be undone; those that work are kept now and then, and the board runs on. */
TEST(any_line)
{
    struct bed *t = *state;
    struct rng r;
    char line[120];
    int fine = 0, n = rig_long() ? 100000 : 10000;

    rng_seed(&r, 8);
    for (int i = 0; i < n && !rig_fault(&t->r); i++) {
        garbage(&r, line, i % 3 ? 24 : sizeof line);
        keep_image(t);
        const bool works = board_eval(t->r.b, line, t->out, sizeof t->out);
        fine += works;
        assert_true(!works || t->r.b->events.n == 0);
        if (works && i % 8 == 0) {
            rig_run(&t->r, 1);
            continue;
        }
        board_restore(t->r.b, t->image);
        if (i % 16 == 0)
            check_image(t, line);
    }
    assert_true(fine > n / 100 && fine < n / 2);
}

RUN_TESTS_EACH(bed_open, bed_close)
