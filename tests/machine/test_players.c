/*
 * test_players.c - what buttons do with ships: options where they should be, bombs and the frames in which one saves,
 * continues; with one player and two. tests/scripts/players.lua has registers and what a hit ends.
 */
#include "../../src/base/trig.h"
#include "rig.h"

static struct rig_game g;
static struct rig rig;
static struct board *b;

static fx px(double v)
{
    return (fx)(v * 65536);
}

static const char head[] =
    "local sys = string.sys\nlocal list = {}\n"
    "local function say(...) for _, v in ipairs { ... } do list[#list + 1] = tostring(v) end end\n"
    "function string.told() local s = table.concat(list, ' ') list = {} return s end\n";

/* A game whose frames the test counts: main.lua runs at power, its tasks from frame 0 on. */
static void power(const char *text)
{
    struct manifest m = rig_manifest();
    static char script[8192];

    m.options = 32;
    m.lasers = 16;
    m.items = 16;
    m.players = 2;
    snprintf(script, sizeof script, "%s%s", head, text);
    rig_with_sys(&g, &m, script);
    rig_power(&rig, &g, NULL);
    b = rig.b;
}

static void hold(uint16_t first, uint16_t second, int frames)
{
    const uint16_t pads[MAX_PLAYERS] = { first, second };

    while (frames-- > 0)
        rig_tick(&rig, pads);
}

/* ---- options ---- */

static const char fixed[] =
    "option.def('bead', { sprite = 'dot', run = function(o) while true do say(o.index .. o.by.index) wait(100) end end "
    "})\n"
    "player.def('ship', { sprite = 'dot', hit = { circle = 2 }, speed = 4, focus = 1, registers = { power = 0 },\n"
    "  options = { kind = 'bead', by = 'power', over = 4, levels = {\n"
    "    { at = 2, wide = { { 0, -16 } } },\n"
    "    { at = 5, wide = { { -20, 4 }, { 20, 4 } }, close = { { -8, -12 }, { 8, -12 } } } } } })\n";

static int options_of(uint32_t p)
{
    int n = 0;

    EACH_LIVE (i, &b->options.s)
        n += b->options.player[i] == p;
    return n;
}

static void beside(uint32_t i, double dx, double dy)
{
    const uint32_t p = b->options.player[i];

    assert_int_equal(b->options.x[i], b->player.x[p] + px(dx));
    assert_int_equal(b->options.y[i], b->player.y[p] + px(dy));
}

TEST(fixed)
{
    char text[4096];

    snprintf(text, sizeof text,
             "%stask.go(function() sys.join(1, 'ship') sys.join(2, 'ship') local p, q = player.get(1), player.get(2)\n"
             "wait(2) p.power = 3 wait(10) p.power = 5 q.power = 2 wait(20) p.power = 1 wait(5) sys.leave(2) end)",
             fixed);
    power(text);
    hold(0, 0, 2);
    assert_int_equal(b->options.s.live, 0);
    hold(PAD_RIGHT, 0, 1); /* the level follows at once */
    assert_int_equal(options_of(0), 1);
    beside(0, 0, -4);
    hold(PAD_RIGHT, 0, 1);
    beside(0, 0, -8);
    hold(0, 0, 2);
    beside(0, 0, -16);
    hold(PAD_UP, 0, 6);
    beside(0, 0, -16);
    hold(0, 0, 1); /* frame 12: two, and one */
    assert_int_equal(options_of(0), 2);
    assert_int_equal(options_of(1), 1);
    beside(0, -5, -11);
    beside(1, 5, 1);
    hold(0, 0, 3);
    beside(0, -20, 4);
    beside(1, 20, 4);
    beside(2, 0, -16);
    hold(PAD_FOCUS, 0, 2);
    beside(0, -14, -4);
    hold(PAD_FOCUS, 0, 2);
    beside(0, -8, -12);
    beside(1, 8, -12);
    hold(0, 0, 4);
    beside(1, 20, 4);
    assert_string_equal(rig_told(&rig), "11 21 12");
    hold(0, 0, 9);
    assert_int_equal(options_of(0), 0); /* frame 32 */
    assert_int_equal(options_of(1), 1);
    hold(0, 0, 5);
    assert_int_equal(b->options.s.live, 0);
    rig_close(&rig);
}

TEST(trail)
{
    power("option.def('bead', { sprite = 'dot' })\n"
          "player.def('ship', { sprite = 'dot', hit = { circle = 2 }, speed = 2,\n"
          "  options = { kind = 'bead', style = 'trail', apart = 5, levels = { { n = 3 } } } })\n"
          "task.go(function() sys.join(1, 'ship') player.get(1).x = 30 wait(40) player.get(1).x = 100 end)");
    hold(0, 0, 1);
    assert_int_equal(b->options.s.live, 3);
    for (uint32_t i = 0; i < 3; i++)
        beside(i, 0, 0);
    hold(PAD_RIGHT, 0, 8);
    beside(0, -10, 0);
    beside(1, -16, 0);
    hold(0, 0, 10); /* it stands, and so do they */
    beside(0, -10, 0);
    hold(PAD_UP, 0, 6);
    beside(0, 0, 10);
    beside(1, -8, 12);
    hold(0, 0, 14);
    beside(2, -16, 12);
    hold(0, 0, 2); /* frame 40: a jump gathers them */
    for (uint32_t i = 0; i < 3; i++)
        beside(i, 0, 0);
    rig_close(&rig);
}

TEST(orbit)
{
    fx dx, dy;
    ang step;

    power("option.def('bead', { sprite = 'dot' })\n"
          "player.def('ship', { sprite = 'dot', hit = { circle = 2 }, registers = { n = 4 },\n"
          "  options = { kind = 'bead', by = 'n', style = 'orbit', radius = 30, close = 10, spin = 3, over = 10,\n"
          "    levels = { { n = 2 }, { at = 4, n = 4 } } } })\n"
          "task.go(function() sys.join(1, 'ship') wait(60) player.get(1).n = 2 end)");
    trig_from_degrees(3, &step);
    hold(0, 0, 50);
    for (uint32_t i = 0; i < 4; i++) {
        trig_polar(px(30), 50 * step + (i << 30), &dx, &dy);
        assert_int_equal(b->options.x[i], b->player.x[0] + dx);
        assert_int_equal(b->options.y[i], b->player.y[0] + dy);
    }
    hold(PAD_FOCUS, 0, 10);
    trig_polar(px(10), 60 * step + (3u << 30), &dx, &dy);
    assert_int_equal(b->options.x[3], b->player.x[0] + dx);
    hold(0, 0, 12);
    assert_int_equal(b->options.s.live, 2);
    trig_polar(px(30), 72 * step + (2u << 30), &dx, &dy);
    assert_int_equal(b->options.x[1], b->player.x[0] + dx);
    assert_int_equal(b->options.y[1], b->player.y[0] + dy);
    rig_close(&rig);
}

/* What finds no room is not there, and comes when there is. */
TEST(options_full)
{
    struct manifest m = rig_manifest();
    char text[4096];

    m.options = 3;
    snprintf(text, sizeof text,
             "%s%stask.go(function() for i = 1, 2 do sys.join(i, 'ship') player.get(i).power = 5 end wait(9)\n"
             "player.get(1).power = 0 end)",
             head, fixed);
    rig_with_sys(&g, &m, text);
    rig_power(&rig, &g, NULL);
    b = rig.b;
    hold(0, 0, 1);
    assert_string_equal(board_last_output(b)->log,
                        "option pool full (3): new options are dropped; raise `board.options` in rom.lua\n");
    assert_int_equal(options_of(0), 2);
    assert_int_equal(options_of(1), 1);
    hold(0, 0, 12);
    assert_int_equal(options_of(0), 0);
    assert_int_equal(options_of(1), 2);
    rig_close(&rig);
}

/* ---- bombs, and what saves ---- */

static const char bombs[] =
    "bullet.def('orb', { sprite = 'dot', hit = { circle = 3 } })\n"
    "bomb.def('wave', { over = 30, safe = 40, run = function(p) say('run', p.index)\n"
    "  sprite.put { sprite = 'dot', x = 9, y = 9 }\n"
    "  bullet.sweep { follow = p, radius_to = 400, over = 20 }\n"
    "  task.go(function() while true do wait(10) say('k') end end) wait(forever) end })\n"
    "bomb.def('spark', { over = 5, cost = 2, safe = 0, run = function(p) say('spark') end })\n"
    "player.def('ship', { sprite = 'dot', hit = { circle = 2 }, safe = 0, registers = { bombs = 3 },\n"
    "  bomb = 'wave', bomb_focus = 'spark', deathbomb = 6 })\n"
    "on.bomb(function(p, late) say('bomb', p.index, late) end)\n"
    "on.hit(function(p) say('hit', p.state) end) on.death(function(p) say('death', p.lives) bullet.clear() end)\n";

static void power_bombs(const char *task)
{
    char text[4096];

    snprintf(text, sizeof text, "%stask.go(function() local p, q = player.get(1), player.get(2) %s end)", bombs, task);
    power(text);
}

TEST(bomb)
{
    power_bombs("sys.join(1, 'ship') sys.join(2, 'ship') wait(2)\n"
                "for i = 1, 20 do bullet.fire { kind = 'orb', x = 9 * i, y = 50, speed = 0 } end wait(100) "
                "say(p:bomb(), p.bombs)\n"
                "say(p:bomb(), p.bombs) wait(40) say(p:bomb(), p.bombs)");
    hold(0, 0, 5);
    assert_int_equal(b->bullets.s.live, 20);
    hold(PAD_BOMB, 0, 1); /* held: one press */
    assert_string_equal(rig_told(&rig), "bomb 1 false");
    assert_int_equal(b->player.safe_left[0], 40);
    hold(PAD_BOMB, 0, 30);
    assert_string_equal(rig_told(&rig), "run 1 k k");
    assert_int_equal(b->bullets.s.live, 0);
    assert_int_equal(b->sprites.s.live, 0); /* what the bomb put ends with it */
    hold(0, 0, 30);
    assert_string_equal(rig_told(&rig), "");
    hold(0, PAD_FOCUS | PAD_BOMB, 2); /* cost 2 */
    assert_string_equal(rig_told(&rig), "bomb 2 false spark");
    hold(0, 0, 8);
    hold(0, PAD_FOCUS | PAD_BOMB, 2); /* 1 is not enough */
    hold(0, 0, 2);
    hold(0, PAD_BOMB, 2);
    assert_string_equal(rig_told(&rig), "bomb 2 false run 2");
    hold(0, 0, 20);
    rig_told(&rig);
    hold(0, 0, 1); /* frame 102 */
    assert_string_equal(rig_told(&rig), "true 1 false 1 run 1 bomb 1 false");
    hold(0, 0, 41);
    assert_string_equal(rig_told(&rig), "k k true 0 run 1 bomb 1 false");
    rig_close(&rig);
}

/* A press that a screen answered to, over a game that stands, is no bomb; one that a script took is none either. */
TEST(bomb_press)
{
    power_bombs("sys.join(1, 'ship') wait(5) local s = sys.scope()\n"
                "task.own(s, function() wait_until(function() return pad.pressed('bomb', 1) end) sys.freeze() end)\n"
                "sys.freeze(s) wait(1) say('on') wait(4) say(pad.take('bomb', 0, 1)) end) task.go(function()");
    hold(0, 0, 10);
    hold(PAD_BOMB, 0, 1);
    hold(0, 0, 3);
    assert_string_equal(rig_told(&rig), "on");
    hold(0, 0, 1);
    hold(PAD_BOMB, 0, 1);
    hold(0, 0, 4);
    assert_string_equal(rig_told(&rig), "true");
    hold(PAD_BOMB, 0, 1);
    assert_string_equal(rig_told(&rig), "bomb 1 false");
    rig_close(&rig);
}

static const char hit_at_10[] =
    "sys.join(1, 'ship') sys.join(2, 'ship') wait(10)\n"
    "bullet.fire { kind = 'orb', from = p, speed = 0 } bullet.fire { kind = 'orb', from = q, speed = 0 }";

/* A press in the n frames of the window saves; one frame later it is too late. */
TEST(deathbomb)
{
    for (int n = 1; n <= 7; n++) {
        power_bombs(hit_at_10);
        hold(0, 0, 11);
        assert_string_equal(rig_told(&rig), "hit fly hit fly");
        const fx x = b->player.x[0];
        hold(PAD_LEFT, 0, n - 1); /* it stands */
        assert_true(n > 6 || b->player.x[0] == x);
        hold(PAD_BOMB, 0, 1);
        assert_string_equal(rig_told(&rig), n == 7   ? "death 1 death 1 bomb 1 false"
                                            : n == 6 ? "bomb 1 true death 1"
                                                     : "bomb 1 true");
        hold(0, 0, 8);
        assert_int_equal(b->player.lives[0], n == 7 ? 1 : 2);
        assert_int_equal(b->player.lives[1], 1);
        rig_close(&rig);
    }
}

/* ---- continues ---- */

/* Both fly; 1 dies and comes back by START; then both die, 2 declines and 1 does not; at the end none is left. */
TEST(continues)
{
    power("bullet.def('orb', { sprite = 'dot', hit = { circle = 3 } })\n"
          "player.def('ship', { sprite = 'dot', hit = { circle = 2 }, lives = 1, registers = { power = 3 } })\n"
          "on.continue(function(p) say('on', p.index, p.score, p.lives, p.power) end)\n"
          "on.game_over(function() say('over') end)\n"
          "local answers = { true, false, false }\n"
          "local function ask(p, left)\n"
          "  say('ask', p, left)\n"
          "  wait(1)\n"
          "  return table.remove(answers, 1)\n"
          "end\n"
          "local function die(i)\n"
          "  local p = player.get(i)\n"
          "  p.safe = 0\n"
          "  bullet.fire { kind = 'orb', from = p, speed = 0 }\n"
          "  wait(1)\n"
          "  bullet.clear()\n"
          "end\n"
          "task.go(function()\n"
          "  local scope = sys.scope()\n"
          "  sys.join(1, 'ship') sys.join(2, 'ship') sys.start(scope)\n"
          "  sys.read('boot/continue')(scope, 2, 2, function(f) f() end, ask)\n"
          "  wait(2) score.add(777, 1) player.get(1).power = 9\n"
          "  die(1) say(player.get(1).alive)\n"
          "  wait(5) die(2) die(1)\n"
          "  wait(8) say(game.continues, player.get(1).alive, player.get(2).alive)\n"
          "  die(1) wait(8) say(player.get(1).alive)\n"
          "end)");
    hold(0, 0, 5);
    assert_string_equal(rig_told(&rig), "false");
    hold(PAD_START, 0, 1);
    hold(0, 0, 40);
    assert_string_equal(rig_told(&rig), "on 1 1 0 3 ask 1 1 on 1 2 0 3 2 true false ask 2 2 over false");
    rig_close(&rig);
}

/* A practice start sets registers of the ship, and of the run, in each try. */
TEST(practised)
{
    struct board_start start = { .seed = 1, .difficulty = -1, .practice = { .section = "s", .register_count = 2 } };

    power(
        "game.def { registers = { rank = { start = 5, min = -9, max = 50, show = 'number' } } }\n"
        "player.def('ship', { sprite = 'dot', hit = { circle = 2 }, lives = 1, registers = { power = { max = 4 } } })\n"
        "on.start(function() say(game.rank) game.rank = 20 end)\n"
        "stage.def('s', function() say(game.rank, player.get(1).power) wait(5) end)\n"
        "boot.run { stages = { 's' }, players = { 'ship' } }");
    rig_free(&rig);
    strcpy(start.practice.reg[0].name, "rank");
    strcpy(start.practice.reg[1].name, "power");
    start.practice.reg[0].value = -7;
    start.practice.reg[1].value = 99;
    rig_power(&rig, &g, &start);
    b = rig.b;
    hold(0, 0, 1);
    assert_string_equal(rig_told(&rig), "5 -7 4");
    hold(0, 0, 84); /* also while the result is shown */
    assert_string_equal(rig_told(&rig), "5 -7 4");
    rig_close(&rig);
}

/* ---- what scripts do to a ship's motion ---- */

static const char moving[] = "player.def('ship', { sprite = 'dot', hit = { circle = 2 }, speed = 4, focus = 1 })\n"
                             "bullet.def('wall', { sprite = 'dot', hit = { box = { 2, 90 } } })\n"
                             "local function fly(f) task.go(function() sys.join(1, 'ship') local p = player.get(1) "
                             "p.x, p.y, p.safe = 50, 50, 0\n"
                             "  f(p) end) end\n";

/* Runs a script with the ship p at (50, 50), before the frames that the test counts. */
static void fly(const char *script)
{
    char text[4096];

    snprintf(text, sizeof text, "%sfly(function(p) %s end)", moving, script);
    power(text);
}

static void check_ship(double x, double y)
{
    if (b->player.x[0] != px(x) || b->player.y[0] != px(y))
        fail_msg("the ship is at %.5f %.5f instead of %.5f %.5f", b->player.x[0] / 65536.0, b->player.y[0] / 65536.0, x,
                 y);
}

TEST(scaled_speed)
{
    fly("task.go(function() p.speed_scale = 0.5 wait(2) end) wait(3) p.speed_scale = 4 say(p.speed_scale)");
    hold(PAD_RIGHT, 0, 2); /* the task's two frames */
    check_ship(54, 50);
    hold(PAD_RIGHT, 0, 1);
    check_ship(58, 50);
    hold(PAD_RIGHT | PAD_FOCUS, 0, 1); /* this task ends at once, and so does its factor */
    check_ship(59, 50);
    rig_close(&rig);
    fly("task.go(function() p.speed_scale = 4 wait(1) end) task.go(function() p.speed_scale = 0 wait(1) end)");
    hold(PAD_LEFT, 0, 1); /* the later write holds until its task ends; then the factor is 1 */
    check_ship(50, 50);
    hold(PAD_LEFT, 0, 1);
    check_ship(46, 50);
    rig_close(&rig);
    power("player.def('ship', { sprite = 'dot', hit = { circle = 2 }, speed = 4, focus = 1 })\n"
          "shot.def('bolt', { sprite = 'dot', hit = { circle = 3 }, damage = 9 })\n"
          "enemy.def('foe', { sprite = 'wink', hit = { circle = 9 }, hp = 5,\n"
          "  on_death = function() player.get(1).speed_scale = 2 end })\n"
          "task.go(function() sys.join(1, 'ship') player.get(1).x = 50 enemy.spawn { kind = 'foe', x = 9, y = 9 }\n"
          "  shot.fire { kind = 'bolt', x = 9, y = 20, speed = 1 } end)");
    hold(0, 0, 3);
    hold(PAD_RIGHT, 0, 40); /* a handler wrote it: until changed */
    assert_int_equal(b->player.speed_scale[0], px(2));
    rig_close(&rig);
}

TEST(forced_focus)
{
    fly("task.go(function() p.focus = true wait(2) p.focus = false wait(1) p.focus = nil wait(1) p.focus = true "
        "wait(1) "
        "end)");
    hold(PAD_RIGHT, 0, 2);
    check_ship(52, 50);
    assert_true(b->player.flags[0] & PLAYER_FOCUS);
    hold(PAD_RIGHT | PAD_FOCUS, 0, 1);
    check_ship(56, 50);
    hold(PAD_RIGHT | PAD_FOCUS, 0, 1);
    check_ship(57, 50);
    hold(PAD_RIGHT, 0, 1);
    check_ship(58, 50);
    hold(PAD_RIGHT, 0, 1);
    check_ship(62, 50);
    rig_close(&rig);
}

TEST(pushed)
{
    fly("p:push(1.5, 0) p:push(1, -2) wait(2) p:push(-8000, 8191) wait(1) p:shift(10, -9) p:shift(0, -1)");
    hold(PAD_RIGHT, 0, 1);
    check_ship(56.5, 48);
    hold(0, 0, 1); /* a push is for one move */
    check_ship(56.5, 48);
    hold(0, 0, 1);
    assert_true(b->player.x[0] == b->player_area.x0 && b->player.y[0] == b->player_area.y1);
    hold(0, 0, 1);
    assert_true(b->player.x[0] == b->player_area.x0 + px(10) && b->player.y[0] == b->player_area.y1 - px(10));
    rig_close(&rig);
}

/* A push through a bullet hits it, a shift past it does not. */
TEST(push_is_swept)
{
    for (int push = 0; push < 2; push++) {
        char text[256];
        snprintf(text, sizeof text,
                 "bullet.fire { kind = 'wall', x = 80, y = 50, dir = 90, speed = 0 } wait(1) p:%s(60, 0)",
                 push ? "push" : "shift");
        fly(text);
        hold(0, 0, 3);
        assert_int_equal(b->player.lives[0], push ? 1 : 2);
        rig_close(&rig);
    }
}

RUN_TESTS(NULL, NULL)
