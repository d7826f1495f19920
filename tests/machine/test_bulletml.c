/*
 * test_bulletml.c - bullet.ml and its arguments, scripts that write to bullets of documents, and harmful documents.
 * test_answers.c compares what documents do.
 */
#include "rig.h"

static const char definitions[] = "bullet.def('orb', { sprite = 'dot', hit = 'none' })\n"
                                  "bullet.def('gem', { sprite = 'wink', hit = 'none', bank = 3 })\n"
                                  "enemy.def('foe', { sprite = 'wink', hit = { box = { 4, 4 } }, hp = 9 })\n"
                                  "local function ml(t)\n"
                                  "  t.name, t.kind = t.name or 'doc', t.kind or 'orb'\n"
                                  "  if not t.from then t.x, t.y = t.x or 100, t.y or 50 end\n"
                                  "  return bullet.ml(t)\n"
                                  "end\n";

static struct rig_game g;
static struct rig r;

static int end(void **state __attribute__((unused)))
{
    rig_close(&r);
    return 0;
}

/* A game of a script, to which a document must be added. */
static void write_game(const char *script)
{
    static char text[1 << 13];
    struct manifest m = rig_manifest();

    m.bullets = 512;
    m.bulletml_runners = 512;
    m.has_freeze = 1;
    snprintf(text, sizeof text, "%s%s", definitions, script);
    rig_script(&g, &m, text);
}

/* What a game prints in that many frames, and its fault. */
static void expect_output(const char *document, const char *script, int frames, const char *want)
{
    static const uint16_t none[MAX_PLAYERS];
    char got[1024] = "";

    write_game(script);
    rig_document(&g, "doc", document);
    rig_power_any(&r, &g, NULL);
    for (int f = 0; f < frames && !rig_fault(&r); f++) {
        const struct board_out *out = board_tick(r.b, none);
        strncat(got, out->log, out->log_size);
    }
    if (rig_fault(&r))
        strcat(got, rig_fault(&r)->message);
    if (strcmp(got, want))
        fail_msg("%s\nexpected\n%s\ngot\n%s", script, want, got);
}

#define FAN                                                                                                            \
    "<bulletml><action label='top'><fire><direction type='absolute'>90</direction><speed>2</speed><bulletRef "         \
    "label='a'/></fire><fire label='f'><direction type='absolute'>180</direction><bullet/></fire><fire><direction "    \
    "type='absolute'>0</direction><bullet/></fire><wait>5</wait><fire><direction>0</direction><speed>$rank</speed>"    \
    "<bullet label='late'/></fire></action><bullet label='a'><action><wait>3</wait><vanish/></action></bullet>"        \
    "</bulletml>"

/* Labels choose kinds, and are passed to on_fire; the rank can be written; it ends when nothing is left to do. */
TEST(labels)
{
    expect_output(FAN,
                  "local d = ml { kinds = { a = 'gem' }, tag = 't', on_fire = function(b, label)\n"
                  "  print(b.kind, b.bank, label, b.speed) end }\n"
                  "task.go(function()\n"
                  "  wait(2) d.rank = 0.25 print(d.name, d.rank, d.x, d.y)\n"
                  "  wait(5) print(d.alive, bullet.group('t').count)\n"
                  "end)\n",
                  8,
                  "gem\t3\ta\t2.0\norb\t0\tf\t1.0\norb\t0\tnil\t1.0\n"
                  "doc\t0.25\t100.0\t50.0\norb\t0\tlate\t0.25\nfalse\t3\n");
}

/* A bullet that flies to the right, and by accel down from the move after the next. */
static void check_turned(const char *arguments, const char *want)
{
    char script[512];

    snprintf(
        script, sizeof script,
        "local e = enemy.spawn { kind = 'foe', x = 100, y = 50 }\n"
        "ml { %s }\n"
        "task.go(function() wait(11) bullet.each(nil, function(b) print(('%%.2f %%.2f'):format(b.x, b.y)) end) end)",
        arguments);
    expect_output("<bulletml><action label='top'><fire><direction type='absolute'>90</direction><bullet><action><accel>"
                  "<vertical>1</vertical><term>1</term></accel></action></bullet></fire></action></bulletml>",
                  script, 12, want);
    end(NULL);
}

TEST(turned)
{
    check_turned("", "110.00 59.00\n");
    check_turned("speed = 2", "120.00 68.00\n");
    check_turned("mirror = true", "90.00 59.00\n");
    check_turned("angle = 90", "91.00 60.00\n");
    check_turned("angle = 90, mirror = true", "91.00 40.00\n");
    check_turned("from = e, dx = 9", "119.00 59.00\n");
}

/* A document fires from where its thing is, or leads the thing; it ends with the thing. */
TEST(follows)
{
    expect_output("<bulletml><action label='top'><changeSpeed><speed>1</speed><term>1</term></changeSpeed>"
                  "<changeDirection><direction type='absolute'>90</direction><term>1</term>"
                  "</changeDirection><wait>6</wait><fire><speed>0</speed><bullet/></fire><wait>9</wait>"
                  "</action></bulletml>",
                  "local e = enemy.spawn { kind = 'foe', x = 100, y = 50 }\n"
                  "local f = enemy.spawn { kind = 'foe', x = 100, y = 90 }\n"
                  "local d, s = ml { from = e }, ml { kind = 'gem', from = f, steer = true }\n"
                  "e:move { x = 130, y = 50, over = 3 }\n"
                  "task.go(function()\n"
                  "  wait(8) print(e.x, f.x, d.x) e:remove()\n"
                  "  wait(1) print(d.alive, s.alive)\n"
                  "  bullet.each(nil, function(b) print(b.kind, b.x) end)\n"
                  "end)\n",
                  10, "130.0\t107.0\t130.0\nfalse\ttrue\norb\t130.0\ngem\t105.0\n");
}

#define STREAM                                                                                                         \
    "<bulletml><action label='top'><repeat><times>1000</times><action><fire><speed>$1</speed><bullet/></fire>"         \
    "<wait>1</wait></action></repeat></action></bulletml>"

/* It ends with its owner, or by stop. */
TEST(owner)
{
    expect_output(STREAM,
                  "local e, d = enemy.spawn { kind = 'foe', x = 100, y = 50 }, nil\n"
                  "task.own(e, function() d = ml { params = { 0.25 } } end)\n"
                  "task.go(function()\n"
                  "  wait(4) e:remove()\n"
                  "  wait(4) print(d.alive, bullet.group().count) bullet.each(nil, function(b) print(b.speed) end)\n"
                  "  d = ml {} wait(2) d:stop()\n"
                  "  wait(4) print(d.alive, bullet.group().count) d:stop() d.rank = 1 print(d.rank)\n"
                  "end)\n",
                  16, "false\t4\n0.25\n0.25\n0.25\n0.25\nfalse\t6\nnil\n");
    assert_int_equal(r.b->ml_roots.s.live, 0);
    assert_int_equal(r.b->ml_runners.s.live, 0);
}

/* With loop, it starts again when its shortest top action ends. */
TEST(loop)
{
    expect_output("<bulletml><action label='top'><fire><bullet/></fire><wait>1</wait></action><action label='top2'>"
                  "<wait>9</wait><fire><bullet/></fire></action></bulletml>",
                  "ml { loop = true } task.go(function() wait(10) print(bullet.group().count) end)", 11, "5\n");
}

TEST(arguments)
{
    static const struct {
        const char *arguments, *message;
    } rows[] = {
        { "name = 'dok'", "name: no bulletml/dok.xml in the game (did you mean \"doc\"?)" },
        { "kinds = { b = 'gem' }", "kinds: unknown label \"b\" (labels: f, late, a)" },
        { "kinds = { a = 'gam' }", "unknown bullet kind \"gam\" (did you mean \"gem\"?)" },
        { "kinds = { 'gem' }", "kinds: expected { label = kind }, got key 1" },
        { "params = { 1, 2, 3, 4, 5, 6, 7, 8, 9, 10 }", "params: expected at most 9 numbers, got 10" },
        { "params = { a = 1 }", "params: expected a list of numbers" },
        { "params = { 'a' }", "params: expected a number from -1000000000 to 1000000000, got \"a\"" },
        { "steer = true", "steer: requires `from` (an enemy)" },
    };
    char script[256], want[256];

    for (size_t i = 0; i < sizeof rows / sizeof *rows; i++) {
        snprintf(script, sizeof script, "ml { %s }", rows[i].arguments);
        snprintf(want, sizeof want, "main.lua:7: bullet.ml: %s", rows[i].message);
        expect_output(FAN, script, 1, want);
        end(NULL);
    }
}

/* ---- scripts and documents ---- */

/* A script does something to the bullet b in frame 5. Alone, b has speed 1 up to then, 1.25, 1.5, 1.75, and then 2. */
static void check_written(const char *what, const char *want, uint32_t runners)
{
    char script[512];

    snprintf(script, sizeof script,
             "local b ml { on_fire = function(c) b = b or c end }\n"
             "task.go(function()\n"
             "  wait(5) %s\n"
             "  wait(15) print(b.alive and ('%%.2f %%.2f'):format(b.x, b.y))\n"
             "end)\n",
             what);
    expect_output("<bulletml><action label='top'><fire><direction type='absolute'>90</direction><bullet><action>"
                  "<wait>4</wait><changeSpeed><speed type='relative'>1</speed><term>4</term></changeSpeed>"
                  "<wait>20</wait><fire><speed>0</speed><bullet/></fire></action></bullet></fire></action></bulletml>",
                  script, 22, want);
    assert_int_equal(r.b->ml_runners.s.live, runners);
    end(NULL);
}

TEST(written)
{
    check_written("", "131.50 50.00\n", 1);
    check_written("b.x = 50", "77.50 50.00\n", 1);
    check_written("b.dir = 90", "104.00 77.50\n", 1);
    check_written("b.speed = 3", "161.50 50.00\n", 1);
    check_written("b.vx = 0 b.vy = -2", "104.00 7.50\n", 1);
    check_written("b.frozen = 6", "119.50 50.00\n", 1);
    check_written("b:remove()", "false\n", 0);
    check_written("b.motion = motion.def { { wait = 1 } }", "119.00 50.00\n", 0);
}

/* ---- harm ---- */

/* What a document of these actions leads to: a fault, or what is printed. */
static void expect_end(const char *actions, int frames, const char *want)
{
    char xml[2048];

    snprintf(xml, sizeof xml, "<bulletml>\n%s</bulletml>", actions);
    write_game("ml {}");
    rig_document(&g, "doc", xml);
    assert_string_equal(rig_said(&g, frames, true), want);
    rig_game_free(&g);
}

TEST(harm)
{
    expect_end("<action label='top'><repeat><times>1000000000</times>\n"
               "<action><fire><bullet/></fire></action></repeat></action>",
               3, "bulletml/doc.xml:3: more than 100000 commands in one frame (repeat without a wait?)");
    expect_end("<action label='top'><actionRef label='top'/></action>", 3,
               "bulletml/doc.xml:2: more than 100000 commands in one frame (repeat without a wait?)");
    /* a bullet that fires itself twice a frame */
    expect_end("<action label='top'><fire><bulletRef label='b'/></fire></action><bullet label='b'><speed>0</speed>"
               "<action><repeat><times>99999</times><action><fire><bulletRef label='b'/></fire><fire>"
               "<bulletRef label='b'/></fire><wait>1</wait></action></repeat></action></bullet>",
               60,
               "BulletML runner pool full (512): new bullets fly straight; raise `board.bulletml` in rom.lua\n"
               "bullet pool full (512): new bullets are dropped; raise `board.bullets` in rom.lua\n");
    expect_end("<action label='top'><wait>99999999999</wait><fire><direction>1/0</direction><speed>-1/0</speed>"
               "<bullet><action><changeSpeed><speed type='sequence'>9999999999</speed><term>9999999999</term>"
               "</changeSpeed><changeDirection><direction type='sequence'>1/0</direction><term>3</term>"
               "</changeDirection><accel><horizontal>-1/0</horizontal><vertical type='sequence'>1/0</vertical>"
               "<term>-1/0</term></accel></action></bullet></fire></action>",
               20, "");
}

/* A byte of a program set to anything: refused, or it runs to some end. */
TEST(mutations)
{
    static const uint16_t none[MAX_PLAYERS];
    char err[256];
    uint8_t *out;
    size_t size;
    struct rng rng;
    int good = 0, bad = 0;

    assert_true(rig_compile(
        "<bulletml><action label='top'><actionRef label='a'><param>$rand*3</param></actionRef><repeat><times>2</times>"
        "<action><fire><speed>$1+2</speed><bulletRef label='b'><param>$rank-3</param></bulletRef></fire><wait>2</wait>"
        "<fireRef label='f'/></action></repeat></action><action label='a'><accel><horizontal>$1</horizontal>"
        "<term>4</term></accel><wait>1</wait></action><fire label='f'><bullet/></fire><bullet label='b'><action>"
        "<changeDirection><direction>3</direction><term>$1</term></changeDirection><vanish/></action></bullet>"
        "</bulletml>",
        &out, &size, err, sizeof err));
    rng_seed(&rng, 5);
    for (size_t at = 0; at < size; at++)
        for (int k = 0; k < 3; k++) {
            const uint8_t was = out[at];
            out[at] = (uint8_t)(k == 2 ? rng_next(&rng) : was ^ 1u << rng_below(&rng, 8));
            if (ml_check(out, size, err, sizeof err)) {
                good++;
                write_game("ml {}");
                rig_lump(&g, "bulletml/doc", out, size);
                rig_power(&r, &g, NULL);
                for (int f = 0; f < 12 && !rig_fault(&r); f++)
                    board_tick(r.b, none);
                end(NULL);
            } else
                bad++;
            out[at] = was;
        }
    assert_true(ml_check(out, size, err, sizeof err));
    assert_true(good > 100 && bad > 300);
    for (size_t n = 0; n < size; n++)
        assert_false(ml_check(out, n, err, sizeof err));
    free(out);
}

RUN_TESTS_EACH(NULL, end)
