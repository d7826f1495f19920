/*
 * test_order.c - what a game may rely on within a frame: when things first move, in which order tasks get their turns,
 * how they end, and in which order handlers are told. Every case is a script that writes a log of words; "/" ends a
 * frame.
 */
#include "rig.h"

static const char game[] =
    "bullet.def('dot', { sprite = 'dot', hit = { circle = 2 } })\n"
    "bullet.def('air', { sprite = 'dot', hit = 'none' })\n"
    "shot.def('bolt', { sprite = 'dot', hit = { box = { 4, 4 } } })\n"
    "enemy.def('foe', { sprite = 'dot', hit = { box = { 8, 8 } }, touch = false, score = 100 })\n"
    "player.def('ship', { sprite = 'dot', hit = { circle = 2 }, graze = 20, lives = 1, safe = 0 })\n"
    "local sys, log = string.sys, {}\n"
    "local function say(s) log[#log + 1] = s end\n"
    "function string.told() return table.concat(log, ' ') end\n"
    "local function join(i, x) sys.join(i, 'ship') local p = player.get(i) p.x, p.y, p.safe = x, 200, 0 return p end\n"
    "local function foe(x, t) local a = { kind = 'foe', x = x or 50, y = 50 } for k, v in pairs(t or {}) do a[k] = v "
    "end return enemy.spawn(a) end\n"
    "local function each_frame(f) task.go(function() while true do f() wait(1) end end) end\n"
    "local function closing(name) return setmetatable({}, { __close = function() say(name) end }) end\n";

struct order {
    const char *name, *code;
    int frames;
    const char *log; /* NULL: a fault that says `fault` */
    const char *fault;
};

static const struct order orders[] = {
    /* ---- when things first move ---- */
    { "a task's bullet moves in the same frame",
      "task.go(function()\n"
      "  local b = bullet.fire { kind = 'air', x = 50, y = 50, dir = 0, speed = 2 }\n"
      "  for i = 1, 3 do say(b.x) wait(1) end\n"
      "end)",
      3, "50.0 / 52.0 / 54.0 /", NULL },
    { "a handler's bullet, shot, enemy move and motion step first move in the next frame",
      "local b, c, s, e\n"
      "on.kill(function()\n"
      "  b = bullet.fire { kind = 'air', x = 50, y = 50, dir = 0, speed = 2 }\n"
      "  c = bullet.fire { kind = 'air', x = 50, y = 50, dir = 0, speed = 2, motion = motion.def { { speed = 4, over = "
      "2 } } }\n"
      "  s = shot.fire { kind = 'bolt', x = 50, y = 150, dir = 0, speed = 3 }\n"
      "  e = foe(50) e:move { x = 90, y = 50, over = 4 }\n"
      "end)\n"
      "task.go(function()\n"
      "  foe():kill() say('kill') wait(1)\n"
      "  for i = 1, 5 do say(('%d,%d,%d,%d'):format(b.x, c.x, s.x, e.x)) wait(1) end\n"
      "end)",
      6, "kill / 50,50,50,50 / 52,53,53,60 / 54,57,56,70 / 56,61,59,80 / 58,65,62,90 /", NULL },
    { "an enemy moves in the frame its task says so, and is there in time",
      "task.go(function()\n"
      "  local e = foe(10) e:move { x = 14, y = 50, over = 2 }\n"
      "  for i = 1, 4 do say(e.x) wait(1) end\n"
      "end)",
      4, "10.0 / 12.0 / 14.0 / 14.0 /", NULL },
    { "on_death called by a task belongs to that task's time",
      "task.go(function()\n"
      "  local b\n"
      "  foe(50, { on_death = function() b = bullet.fire { kind = 'air', x = 50, y = 50, dir = 0, speed = 2 } end "
      "}):kill()\n"
      "  say(b.x) wait(1) say(b.x)\n"
      "end)",
      2, "50.0 / 52.0 /", NULL },

    /* ---- tasks ---- */
    { "turns in the order of starting; those started meanwhile come last",
      "task.go(function() say('a') task.go(function() say('c') task.go(say, 'd') wait(1) say('g') end) wait(1) "
      "say('e') end)\n"
      "task.go(function() say('b') wait(1) say('f') end)",
      2, "a b c d / e f g /", NULL },
    { "a handler's task has its first turn in the next frame, after all before it",
      "on.kill(function() say('handler') task.go(say, 'new') end)\n"
      "task.go(function() foe():kill() wait(1) say('old') task.go(say, 'newer') end)",
      2, "handler / old new newer /", NULL },
    { "a freed slot does not change the order",
      "local x = task.go(function() wait(1) end)\n"
      "task.go(function() say('b') wait(1) say('b') wait(1) say('b') end)\n"
      "task.go(function() wait(2) task.go(say, 'new') say('c') end)",
      3, "b / b / b c new /", NULL },
    { "wait(0) goes on at once, wait(n) n frames later",
      "task.go(function() say(0) wait(0) say(0) wait(1) say(1) wait(2) say(3) wait(3.0) say(6) end)", 7,
      "0 0 / 1 / / 3 / / / 6 /", NULL },
    { "wait_until asks once a frame, first at once",
      "local n = 0\n"
      "task.go(function() wait_until(function() say('?') n = n + 1 return n == 3 end) say('yes')\n"
      "  say(wait_until(function() return true end, 0) and 'true' or 'false')\n"
      "  say(wait_until(function() return false end, 0) and 'true' or 'false')\n"
      "  say(wait_until(function() return false end, 2) and 'true' or 'false') end)",
      6, "? / ? / ? yes true false / / false / /", NULL },
    { "wait_for",
      "task.go(function()\n"
      "  local b = bullet.fire { kind = 'air', x = 50, y = 50, speed = 0 }\n"
      "  local t = task.go(function() wait(2) b:remove() say('removed') wait(1) say('end') end)\n"
      "  wait_for(b, t) say('both') wait_for() wait_for(b) say('at once') end)",
      5, "/ / removed / end / both at once /", NULL },
    { "arguments and results",
      "task.go(function(...) say(select('#', ...)) say((...)) end, 'x', nil, nil)\n"
      "task.go(function() local e = foe() task.own(e, function(o, n) say(o == e and n or 'no') end, 7) end)",
      1, "3 x 7 /", NULL },
    { "a thing's end closes what it owns, at its turn",
      "task.go(function()\n"
      "  local e = foe()\n"
      "  local t = task.own(e, function() local k <close> = closing('closed') while true do say('turn') wait(1) end "
      "end)\n"
      "  wait(1) e:remove() say(t.alive and 'alive' or 'dead') wait(1) say('next')\n"
      "end)",
      3, "turn / dead closed / next /", NULL },
    { "a task that ends takes what it owns along",
      "local t = task.go(function() wait(1) say('owner ends') end)\n"
      "task.own(t, function() local k <close> = closing('closed') wait(forever) end)\n"
      "each_frame(function() end)",
      3, "/ owner ends closed / /", NULL },
    { "a chain of owners ends in one frame when its links are younger",
      "local s = task.scope()\n"
      "local a = task.own(s, function() local k <close> = closing('a') wait(forever) end)\n"
      "local b = task.own(a, function() local k <close> = closing('b') wait(forever) end)\n"
      "local c = task.own(b, function() local k <close> = closing('c') wait(forever) end)\n"
      "task.go(function() wait(1) task.stop(s) say('stop') for _, t in ipairs { s, a, b, c } do say(t.alive and 1 or "
      "0) end end)",
      4, "/ stop 0 0 0 0 / a b c / /", NULL },
    { "task.go has the caller's owner",
      "task.go(function()\n"
      "  local e = foe()\n"
      "  task.own(e, function() task.go(function() local k <close> = closing('inner') wait(forever) end) end)\n"
      "  wait(1) e:kill()\n"
      "end)",
      3, "/ inner / /", NULL },
    { "task.stop of itself: nothing after it runs, closings do",
      "local me\n"
      "me = task.go(function() local k <close> = closing('closed') wait(1) say('stop') task.stop(me) say('never') "
      "end)\n"
      "each_frame(function() say(me.alive and 'alive' or 'dead') end)",
      3, "alive / stop closed dead / dead /", NULL },
    { "task.stop from deep inside",
      "local me\n"
      "me = task.go(function() local a <close> = closing('a') wait(1)\n"
      "  pcall(function() local b <close> = closing('b') task.stop(me) say('never') end) say('never') end)",
      3, "/ b a / /", NULL },
    { "task.stop of an older task closes it next frame, of a younger one in this",
      "local old = task.go(function() local k <close> = closing('old') while true do say('o') wait(1) end end)\n"
      "local young\n"
      "task.go(function() wait(1) task.stop(old) task.stop(young) say('stop') end)\n"
      "young = task.go(function() local k <close> = closing('young') while true do say('y') wait(1) end end)",
      4, "o y / o stop young / old / /", NULL },
    { "stopped before its first turn it never runs",
      "task.go(function() local t = task.go(say, 'never') task.stop(t) task.stop(t) say(t.alive and 1 or 0) end)", 2,
      "0 / /", NULL },
    { "a task owned by the dead is dead",
      "task.go(function() local e = foe() e:remove() local t = task.own(e, say, 'never') say(t.alive and 1 or 0) "
      "task.stop(t) end)",
      2, "0 / /", NULL },
    { "closings may raise and be caught, and start tasks",
      "local function careful() local k <close> = setmetatable({}, { __close = function() error('x') end }) end\n"
      "task.go(function() say(pcall(careful) and 1 or 0) end)\n"
      "local t = task.go(function() local k <close> = setmetatable({}, { __close = function() task.go(say, 'after') "
      "end }) wait(forever) end)\n"
      "task.go(function() wait(1) task.stop(t) end)",
      4, "0 / / after / /", NULL },

    /* ---- where waiting is not possible ---- */
    { "wait in a handler", "on.kill(function() wait(1) end) task.go(function() foe():kill() end)", 2, NULL, "task.go" },
    { "wait_until in a handler",
      "on.kill(function() wait_until(function() return true end) end) task.go(function() foe():kill() end)", 2, NULL,
      "task.go" },
    { "wait in an each", "task.go(function() foe() enemy.each(nil, function() wait(1) end) end)", 2, NULL,
      "callback from C" },
    { "wait in a closing of a stopped task",
      "local t = task.go(function() local k <close> = setmetatable({}, { __close = function() wait(1) end }) wait(9) "
      "end)\n"
      "task.go(function() wait(1) task.stop(t) end)",
      3, NULL, "only a task can wait" },
    { "a faulty closing",
      "task.go(function() local me <close> = setmetatable({}, { __close = function() error('x') end }) end)", 2, NULL,
      "x" },
    { "half a frame", "task.go(function() wait(2.5) end)", 1, NULL, "whole number" },

    /* ---- freezing ---- */
    { "a frozen board gives turns to one scope alone; nothing moves and no wait grows shorter",
      "local b = bullet.fire { kind = 'air', x = 50, y = 50, dir = 0, speed = 2 }\n"
      "task.go(function() wait(3) say('three') end)\n"
      "each_frame(function() say(b.x) end)\n"
      "task.go(function()\n"
      "  wait(1)\n"
      "  local s = task.scope()\n"
      "  task.own(s, function() for i = 1, 2 do say('menu') wait(1) end sys.freeze() say('on') task.stop(s) end)\n"
      "  sys.freeze(s)\n"
      "end)",
      6, "50.0 / 52.0 menu / menu / on / 54.0 / three 56.0 /", NULL },
    { "a frozen board goes on counting frames, not game time",
      "local s = task.scope()\n"
      "task.own(s, function() local f, c = board.frame(), sys.clock() wait(3) say(board.frame() - f) say(sys.clock() - "
      "c) end)\n"
      "task.go(function() sys.freeze(s) end)",
      5, "/ / / 3 0 / /", NULL },
    { "tasks whose owner died are closed on a frozen board too",
      "local s, e = task.scope(), foe()\n"
      "task.own(e, function() local k <close> = closing('closed') wait(forever) end)\n"
      "task.go(function() sys.freeze(s) end)\n"
      "task.own(s, function() wait(1) e:remove() end)",
      4, "/ / closed / /", NULL },

    /* ---- events ---- */
    { "handlers in the order they were given",
      "for i = 1, 3 do on.kill(function() say(i) end) end task.go(function() foe():kill() end)", 1, "1 2 3 /", NULL },
    { "what tasks raised comes before what hits raise, and what those raise after them, in its order",
      "on.graze(function(p) say('graze' .. p.index) end) on.hit(function(p) say('hit' .. p.index) end)\n"
      "on.death(function(p) say('death' .. p.index .. (p.alive and p.x == 60 * p.index and 'here' or '')) end)\n"
      "on.game_over(function() say('over') end) on.kill(function(_, p) say('kill' .. (p and p.index or 0)) end)\n"
      "on.extend(function(p) say('extend' .. p.index) end) on.leave(function() say('leave') end)\n"
      "on.phase(function(e, id, won) say('phase' .. id .. (won and 1 or 0)) end) on.stage(function(n, s) say(n .. s) "
      "end)\n"
      "local one, two = join(1, 60), join(2, 120)\n"
      "one.x, one.y = 60, 200\n" /* it stood aside for the other */
      "task.go(function()\n"
      "  one.lives, two.lives = 0, 0\n"
      "  sys.emit('stage', 's', 'start') sys.emit('phase', 1, 'p', true)\n"
      "  foe(200):kill()\n"
      "  foe(10):move { x = -200, y = 50, over = 1 }\n"
      "  bullet.fire { kind = 'dot', x = 120, y = 200, speed = 0 }\n"
      "  bullet.fire { kind = 'dot', x = 60, y = 215, speed = 0 }\n"
      "  bullet.fire { kind = 'dot', x = 60, y = 200, speed = 0 }\n"
      "  foe(150) shot.fire { kind = 'bolt', x = 150, y = 50, speed = 0, by = two }\n"
      "  wait(1) say(one.alive and 1 or 0) bullet.clear()\n"
      "end)",
      2, "sstart phasep1 kill2 graze1 hit1 hit2 leave death1here death2here kill2 over / 0 /", NULL },
    { "an extend in the frame of its score",
      "on.extend(function(p) say('extend' .. p.lives) end)\n"
      "local p = join(1, 60)\n"
      "task.go(function() score.add(999, p) wait(1) score.add(1, p) say(p.lives) wait(1) score.add(100000, p) "
      "say(p.lives) wait(1) say(p.lives) end)",
      4, "/ 1 extend1 / 2 extend2 / 2 /", NULL },
    { "on.hit may save; on.death sees the lives that are left and may bring one back",
      "local p = join(1, 60) p.lives = 1\n"
      "on.hit(function(q) say('hit') if not string.saved then string.saved = true q.safe = 1 end end)\n"
      "on.death(function(q) say('death' .. q.lives) if q.lives < 0 then q.lives = 1 end end)\n"
      "task.go(function() for i = 1, 6 do local b = bullet.fire { kind = 'dot', x = p.x, y = p.y, speed = 0 } wait(1) "
      "b:remove() end end)",
      6, "hit / hit death0 / hit death-1 / hit death0 / hit death-1 / hit death0 /", NULL },
    { "what a handler raises is told in the same frame, after the rest",
      "local a, b = foe(10), foe(20)\n"
      "on.kill(function(e) say(e == a and 'a' or 'b') if e == a then b:kill() end end) on.stage(function() say('s') "
      "end)\n"
      "task.go(function() a:kill() sys.emit('stage', 1, 2) end)",
      1, "a s b /", NULL },
    { "the killed can be read in on_death and in on.kill",
      "on.kill(function(e) say(e.x or 'gone') end)\n"
      "task.go(function() foe(30, { on_death = function(e) say(e.x) end }):kill() end)",
      1, "30.0 30.0 /", NULL },
    { "on_hit when it lives on, on_death when not",
      "enemy.def('wall', { sprite = 'dot', hit = { box = { 8, 8 } }, hp = 2, on_hit = function(e, p, n) say('hit' .. n "
      ".. e.hp) end,\n"
      "  on_death = function(e, p) say('death' .. (p and p.index or 0)) end })\n"
      "local p = join(1, 60)\n"
      "task.go(function() enemy.spawn { kind = 'wall', x = 50, y = 50 }\n"
      "  for i = 1, 3 do shot.fire { kind = 'bolt', x = 50, y = 50, speed = 0, from = nil, by = p } wait(1) end end)",
      3, "hit11 / death1 / /", NULL },
};

static void run(const struct order *o)
{
    static const char last[] = "\nfunction string.frame_end() say('/') end\n";
    static char text[1 << 14];
    const uint16_t none[MAX_PLAYERS] = { 0 };
    struct manifest m = rig_manifest();
    struct rig_game g;
    struct rig r;

    m.n_extends = 2;
    m.extends[0] = 1000;
    m.extends[1] = 50000;
    snprintf(text, sizeof text, "%s%s%s", game, o->code, last);
    rig_with_sys(&g, &m, text);
    rig_power_any(&r, &g, NULL);
    for (int f = 0; f < o->frames && !rig_fault(&r); f++) {
        board_tick(r.b, none);
        if (rig_fault(&r))
            break;
        lua_State *L = r.b->vm.L;
        lua_getglobal(L, "string");
        lua_getfield(L, -1, "frame_end");
        lua_call(L, 0, 0);
        lua_pop(L, 1);
    }
    const struct board_fault *fault = rig_fault(&r);
    if (o->fault ? !fault || !strstr(fault->message, o->fault) : fault != NULL)
        fail_msg("%s: %s", o->name, fault ? fault->message : "no fault");
    if (o->log && strcmp(rig_told(&r), o->log))
        fail_msg("%s:\n     got %s\nexpected %s", o->name, rig_told(&r), o->log);
    rig_free(&r);
    rig_game_free(&g);
}

TEST(order)
{
    for (size_t i = 0; i < sizeof orders / sizeof *orders; i++)
        run(&orders[i]);
}

TEST(load)
{
    static const struct {
        const char *code, *fault;
    } cases[] = {
        { "wait(1)", "task.go" },           { "wait_until(function() return true end)", "task.go" },
        { "undeclared = 1", "undeclared" }, { "require 'main'", "itself" },
        { "error 'plain'", "plain" },       { "by_difficulty { normal = 1 }", "during the game" },
    };

    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        struct rig_game g;
        struct rig r;
        rig_script(&g, NULL, cases[i].code);
        rig_power_any(&r, &g, NULL);
        if (!rig_fault(&r) || !strstr(rig_fault(&r)->message, cases[i].fault))
            fail_msg("%s: %s", cases[i].code, rig_fault(&r) ? rig_fault(&r)->message : "no fault");
        rig_free(&r);
        rig_game_free(&g);
    }
}

/* board.reset: as after power-on, but frames and nvram go on, and so does what the frame said. */
TEST(reset)
{
    static const char text[] =
        "print('load')\n"
        "local n = save.get('n', 0) save.set('n', n + 1)\n"
        "task.go(function() wait(3) if n == 0 then board.reset() print('last') end wait(forever) end)\n";
    const uint16_t none[MAX_PLAYERS] = { 0 };
    struct rig_game g;
    struct rig r;

    rig_script(&g, NULL, text);
    rig_power(&r, &g, NULL);
    assert_int_equal(board_last_output(r.b)->log_size, 5);
    assert_memory_equal(board_last_output(r.b)->log, "load\n", 5);
    for (int f = 0; f < 3; f++)
        rig_tick(&r, none);
    assert_int_equal(nvram_get(&r.b->nvram, "n").bits, 1);
    const struct board_out *out = board_tick(r.b, none);
    assert_null(out->fault);
    assert_int_equal(out->log_size, 10);
    assert_memory_equal(out->log, "last\nload\n", 10);
    assert_int_equal(board_frame(r.b), 4);
    assert_int_equal(r.b->core.clock, 0);
    assert_int_equal(nvram_get(&r.b->nvram, "n").bits, 2);
    uint32_t changed;
    size_t size;
    board_nvram(r.b, &size, &changed);
    assert_int_equal(changed, 2);
    rig_run(&r, 9);
    rig_free(&r);
    rig_game_free(&g);
}

RUN_TESTS(NULL, NULL)
