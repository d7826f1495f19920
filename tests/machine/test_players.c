/*
 * test_players.c - what ships have and do: registers against plain arithmetic, options where they should be, bombs and
 * the frames in which one saves, continues; with one player and two.
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

static void done(void)
{
    rig_free(&rig);
    rig_game_free(&g);
}

static void hold(uint16_t first, uint16_t second, int frames)
{
    const uint16_t pads[MAX_PLAYERS] = { first, second };

    while (frames-- > 0)
        rig_tick(&rig, pads);
}

/* ---- registers ---- */

/* Drains every 5 frames by 2 down to 3; a rise stands 7 frames. */
TEST(drain)
{
    power(
        "player.def('ship', { sprite = 'dot', hit = { circle = 2 }, registers = {\n"
        "  a = { start = 10, min = 3, max = 20, drain = 2, every = 5, hold = 7 },\n"
        "  b = { start = 5, drain = forever, hold = 3 }, c = { max = 9, drain = -1, every = 2, hold = 4 } } })\n"
        "player.def('tug', { sprite = 'dot', hit = { circle = 2 }, registers = { z = 7 } })\n"
        "task.go(function() sys.join(1, 'ship') sys.join(2, 'ship')\n"
        "  local p = player.get(1) wait(20) p.a, p.b = 99, 8 wait(30) p.c = 2 wait(9) p.a, p.b, p.c = -50, 1, 99 end)");
    hold(0, 0, 1);
    for (int f = 1; f < 80; f++) { /* in frame f, before its scripts */
        const int start = 10 - 2 * (f / 5), low = start < 3 ? 3 : start;
        int a = f <= 20 ? low : 20 - 2 * ((f - 27) >= 0 ? (f - 27) / 5 + 1 : 0), c = f / 2 > 9 ? 9 : f / 2;
        a = a < 3 ? 3 : a;
        if (f > 50)
            c = f < 54 ? 2 : 3 + (f - 54) / 2;
        c = c > 9 ? 9 : c;
        if (f > 59) {
            a = 3;
            c = 9;
        }
        const int seen_b = f > 20 && f < 23 ? 8 : 5;
        hold(0, 0, 1); /* after frame f: the scripts wrote in 20, 50 and 59 */
        if (f == 20)
            a = 20;
        if (f == 50)
            c = 2;
        if (f == 59)
            a = 3, c = 9;
        assert_int_equal(board_get_register(b, 0, 0), a);
        assert_int_equal(board_get_register(b, 0, 1), f == 20 ? 8 : f == 59 ? 1 : seen_b);
        assert_int_equal(board_get_register(b, 0, 2), c);
        assert_int_equal(board_get_register(b, 1, 0), low); /* the second player's own */
    }
    done();
}

/* What is full, what is kept, and what begins anew. */
TEST(fresh)
{
    power("player.def('ship', { sprite = 'dot', hit = { circle = 2 }, registers = { a = { start = 1, max = 3 } } })\n"
          "game.def { registers = { rank = { start = 50, min = -10, max = 100, drain = 1, every = 60 }, luck = 3 } }\n"
          "on.start(function() say('start', game.rank, game.frames, game.continues) task.go(function() while true do "
          "wait(1) say('t') end end) end)\n"
          "task.go(function() local s = sys.scope() sys.join(1, 'ship') sys.start(s)\n"
          "  game.rank, game.luck, player.get(1).a = 999, game.luck - 9, 9 wait(2)\n"
          "  say(game.rank, game.luck, player.get(1).a, game.frames) task.stop(s) sys.leave(1) wait(1)\n"
          "  sys.join(1, 'ship') sys.start(sys.scope()) say(game.rank, player.get(1).a) end)");
    hold(0, 0, 3);
    assert_string_equal(rig_told(&rig), "start 50 0 0 t 100 0 3 2");
    hold(0, 0, 1);
    assert_string_equal(rig_told(&rig), "start 50 0 0 50 1");
    done();
}

/* An item gives a register of the ship that takes it, or else one of the run. */
TEST(gives_run)
{
    power("game.def { registers = { rank = { max = 9 }, power = 50 } }\n"
          "player.def('ship', { sprite = 'dot', hit = { circle = 2 }, registers = { power = 1 } })\n"
          "item.def('gem', { sprite = 'dot', radius = 9, gives = { rank = 7, power = 3 } })\n"
          "task.go(function() sys.join(1, 'ship') sys.start(sys.scope()) local p = player.get(1)\n"
          "for i = 1, 2 do item.drop { kind = 'gem', from = p } end wait(2) say(game.rank, game.power, p.power) end)");
    hold(0, 0, 3);
    assert_string_equal(rig_told(&rig), "9 50 7");
    done();
}

/* At the most of a run's register an item gives its points alone, and all come to a ship that says so; a register of
 * the ship of that name goes first. */
TEST(full_run)
{
    power("game.def { registers = { heat = { max = 2 }, power = { max = 1 } } }\n"
          "player.def('ship', { sprite = 'dot', hit = { circle = 2 }, collect_full = 'heat', magnet = 0,\n"
          "  registers = { power = { max = 2 }, luck = 0 } })\n"
          "item.def('a', { sprite = 'dot', radius = 9, gives = { score = 10, heat = 1, luck = 1 }, full = 'heat' })\n"
          "item.def('b', { sprite = 'dot', radius = 9, gives = { score = 10, power = 1 }, full = 'power' })\n"
          "task.go(function() sys.join(1, 'ship') sys.start(sys.scope()) local p = player.get(1)\n"
          "  local far item.drop { kind = 'a', x = p.x, y = 40, speed = 0 }\n"
          "  item.each(nil, function(i) far = i end)\n"
          "  for i = 1, 3 do item.drop { kind = 'a', from = p } item.drop { kind = 'b', from = p } wait(2)\n"
          "    say(game.heat, p.luck, p.power, p.score, far.vy > 3) end end)");
    hold(0, 0, 7);
    assert_string_equal(rig_told(&rig), "1 1 1 20 false 2 2 2 40 true 2 2 2 60 true");
    done();
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
    done();
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
    done();
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
    done();
}

/* Shots, beams, sprites and lines come from an option and go with it; its player gets the points. */
TEST(options_serve)
{
    power("laser.def('ray', { strip = 'dot', width = 8, hit = { share = 1 }, damage = 1 })\n"
          "shot.def('bolt', { sprite = 'dot', hit = { circle = 3 } })\n"
          "option.def('bead', { sprite = 'dot', run = function(o)\n"
          "  laser.beam { kind = 'ray', follow = o, dir = 270, length = 50, hold = forever }\n"
          "  sprite.put { sprite = 'dot', follow = o, dy = 9 }\n"
          "  shot.fire { kind = 'bolt', from = o, speed = 1 } shot.fire { kind = 'bolt', by = o.by, x = o.x, y = o.y, "
          "speed = 2 }\n"
          "  say(query.near { what = 'enemy', from = o, radius = 9 } == nil) end })\n"
          "player.def('ship', { sprite = 'dot', hit = { circle = 2 }, registers = { n = 0 },\n"
          "  options = { kind = 'bead', by = 'n', over = 0, levels = { { at = 1, wide = { { 20, 0 } } } } } })\n"
          "task.go(function() sys.join(2, 'ship') wait(1) player.get(2).n = 1 wait(30) player.get(2).n = 0 end)");
    hold(0, 0, 3);
    assert_int_equal(b->shots.player[0], 2);
    assert_int_equal(b->shots.player[1], 2);
    assert_int_equal(b->laser_heads.player[0], 2);
    assert_int_equal(b->sprites.s.live, 1);
    fx x, y;
    for (int f = 0; f < 20; f++) {
        hold(0, PAD_LEFT, 1);
        assert_int_equal(b->laser_heads.x[0], b->options.x[0]);
        board_get_position(b, board_handle(b, H_SPRITE, 0), &x, &y);
        assert_int_equal(y, b->options.y[0] + px(9));
    }
    hold(0, 0, 12);
    assert_int_equal(b->options.s.live + b->sprites.s.live + b->lasers.s.live, 0);
    done();
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
    done();
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
    done();
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
    done();
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
        done();
    }
}

/* It stands, fires nothing, and nothing else hits it; a bomb of a script saves too. */
TEST(hit_state)
{
    power_bombs("shot.group():remove() end)\n"
                "shot.def('ball', { sprite = 'dot', hit = { circle = 1 } })\n"
                "local function ball(p)\n"
                "  pattern.ring { fire = 'shot', kind = 'ball', from = p, speed = 0, n = 3 }\n"
                "  return shot.fire { kind = 'ball', from = p, speed = 0 }.alive end\n"
                "task.go(function() sys.join(2, 'ship') local p = player.get(2) p.bombs = 0 wait(3)\n"
                "bullet.fire { kind = 'orb', from = p, speed = 0 } wait(2)\n"
                "say(p.state, ball(p), p:bomb()) p.bombs = 1 wait(1) say(p:bomb(), p.state, ball(p))");
    hold(0, 0, 12);
    assert_string_equal(rig_told(&rig), "hit fly hit false false true fly true run 2 bomb 2 true");
    assert_int_equal(b->player.lives[1], 2);
    assert_int_equal(b->shots.s.live, 4);
    done();
}

/* A hit ends the beams of that ship alone, with a window or without one; in the window it fires none. */
TEST(hit_beams)
{
    static const char *const window[2] = { "deathbomb = 6, bomb = 'wave'", "lives = 3" };
    char text[2048];

    for (int i = 0; i < 2; i++) {
        snprintf(
            text, sizeof text,
            "bullet.def('orb', { sprite = 'dot', hit = { circle = 3 } })\n"
            "bomb.def('wave', { over = 30, cost = 0, run = function() end })\n"
            "laser.def('lance', { strip = 'dot', width = 4, hit = { share = 1 }, damage = 1 })\n"
            "laser.def('ray', { strip = 'dot', width = 4, hit = 'none' })\n"
            "player.def('ship', { sprite = 'dot', hit = { circle = 2 }, safe = 0, %s })\n"
            "task.go(function() sys.join(1, 'ship') sys.join(2, 'ship') wait(2) local p = player.get(1)\n"
            "  local function beam(k, p) return laser.beam { kind = k, follow = p, dir = 270, length = 90,\n"
            "    hold = forever, warn = 0, grow = 2, fade = 9 } end\n"
            "  local function bolt(p) return laser.bolt { kind = 'lance', from = p, speed = 9, length = 9 } end\n"
            "  local mine, far, other, evil = beam('lance', p), bolt(p), beam('lance', player.get(2)), beam('ray', p)\n"
            "  wait(5) say(mine.state, other.state)\n"
            "  bullet.fire { kind = 'orb', from = p, speed = 0 } wait(1) bullet.group():remove() wait(1)\n"
            "  say(mine.state, far.state, other.state, evil.state, p.state)\n"
            "  say(beam('lance', p).alive, bolt(p).alive, beam('ray', p).alive)\n"
            "  say(p.state == 'hit' and p:bomb(), beam('lance', p).alive, bolt(p).alive)\n"
            "  wait(8) say(mine.alive) end)",
            window[i]);
        power(text);
        hold(0, 0, 20);
        assert_string_equal(rig_told(&rig), i == 0 ? "on on fade on on on hit false false true true true true false"
                                                   : "on on fade on on on fly true true true false true true false");
        done();
    }
}

/* ---- continues ---- */

static const char arcade[] =
    "bullet.def('orb', { sprite = 'dot', hit = { circle = 3 } })\n"
    "player.def('ship', { sprite = 'dot', hit = { circle = 2 }, safe = 0, lives = 1, registers = { power = 3 } })\n"
    "on.continue(function(p) say('on', p.index, p.score, p.lives, p.power) end) on.game_over(function() say('over') "
    "end)\n"
    "local function ask(p, left) say('ask', p, left) wait(1) return table.remove(answer, 1) end\n";

static void power_arcade(const char *answers, const char *task)
{
    char text[4096];

    snprintf(text, sizeof text,
             "local answer = { %s }\n%slocal function die(i) local p = player.get(i) p.safe = 0\n"
             "  bullet.fire { kind = 'orb', from = p, speed = 0 } wait(1) bullet.clear() end\n"
             "task.go(function() local s = sys.scope() sys.join(1, 'ship') sys.join(2, 'ship') sys.start(s)\n"
             "sys.read('boot/continue')(s, 2, 2, function(f) f() end, ask) wait(2) %s end)",
             answers, arcade, task);
    power(text);
}

TEST(continues)
{
    /* both fly; 1 dies and comes back by START; then both die, 2 says no, 1 yes; at the end none is left */
    power_arcade("true, false, false",
                 "score.add(777, 1) player.get(1).power = 9 die(1) say(player.get(1).alive) wait(5)\n"
                 "die(2) die(1) wait(8) say(game.continues, player.get(1).alive, player.get(2).alive)\n"
                 "die(1) wait(8) say(player.get(1).alive)");
    hold(0, 0, 5);
    assert_string_equal(rig_told(&rig), "false");
    hold(PAD_START, 0, 1);
    hold(0, 0, 40);
    assert_string_equal(rig_told(&rig), "on 1 1 0 3 ask 1 1 on 1 2 0 3 2 true false ask 2 2 over false");
    done();
}

/* Through boot.run: the board stands while it asks; START goes on, a bomb shortens, and silence is a no. */
TEST(asks)
{
    power(
        "bullet.def('orb', { sprite = 'dot', hit = { circle = 3 } })\n"
        "player.def('ship', { sprite = 'dot', hit = { circle = 2 }, safe = 9, lives = 1 })\n"
        "on.continue(function(p) say('on', p.score, game.continues, game.stage) end)\n"
        "on.game_over(function() say('over') end) on.start(function() say('start') end)\n"
        "stage.def('s', function() local p = player.get(1) while true do wait(30) say('.') if p.alive then\n"
        "bullet.fire { kind = 'orb', from = p, speed = 0 } wait(1) bullet.clear() else p = player.get(1) end end end)\n"
        "boot.run { stages = { 's' }, players = { 'ship' }, continues = 2 }");
    b->cart.manifest.players = 1;
    hold(0, 0, 2);
    hold(PAD_START, 0, 1);
    hold(0, 0, 2);
    hold(PAD_START, 0, 1);
    hold(0, 0, 34);
    assert_string_equal(rig_told(&rig), "start .");
    assert_true(b->core.frozen && !b->player.in_game[0] && !b->core.game_over);
    hold(0, 0, 500); /* it stands and counts */
    assert_string_equal(rig_told(&rig), "");
    hold(PAD_START, 0, 1);
    hold(0, 0, 2);
    assert_string_equal(rig_told(&rig), "on 1 1 s");
    assert_true(!b->core.frozen && b->player.in_game[0]);
    hold(0, 0, 70);
    assert_true(b->core.frozen);
    rig_told(&rig);
    hold(0, 0, 550);
    assert_true(b->core.frozen);
    hold(0, 0, 60);
    assert_string_equal(rig_told(&rig), "over");
    assert_true(!b->core.frozen && b->core.game_over);
    done();
}

/* A practice start sets registers of the ship, and of the run, in each try; F2 is told of both. */
TEST(practised)
{
    struct board_start start = { .seed = 1, .difficulty = -1, .practice = { .section = "s", .register_count = 2 } };
    const uint16_t none[MAX_PLAYERS] = { 0 };
    char names[64] = "";

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
    hold(0, 0, 8);
    assert_string_equal(rig_told(&rig), "5 -7 4");
    rig_free(&rig);
    start.practice = (struct practice){ .section = PRACTICE_LIST };
    rig_power(&rig, &g, &start);
    for (int f = 0; f < 30; f++) {
        const struct board_out *out = board_tick(rig.b, none);
        for (int i = 0; i < out->marker_count; i++)
            if (out->marker[i].kind == MARKER_REGISTER)
                snprintf(names + strlen(names), sizeof names - strlen(names), "%s=%d ", out->marker[i].name,
                         (int)out->marker[i].value);
    }
    assert_string_equal(names, "power=0 rank=5 ");
    done();
}

RUN_TESTS(NULL, NULL)
