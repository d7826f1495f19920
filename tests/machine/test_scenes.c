/*
 * test_scenes.c - what a boss's phase spawned and put goes with it, however it ends, and nothing else does: no score,
 * no spark, no event. Every case is a script that writes a log; with RAM spoilt after every frame it writes the same.
 *
 * The log: FRAME:IMPS/WHELPS/GUESTS/SPRITES whenever one of these has changed, and words.
 */
#include "rig.h"

static const char game[] =
    "bullet.def('dot', { sprite = 'dot', hit = 'none' })\n"
    "shot.def('bolt', { sprite = 'dot', hit = { box = { 4, 4 } } })\n"
    "spark.def('bang', { sprite = 'dot', life = 9 })\n"
    "player.def('ship', { sprite = 'dot', hit = { circle = 1 } })\n"
    "local foe = { sprite = 'dot', hit = { box = { 8, 8 } }, touch = false, score = 100, spark = 'bang', hp = 5 }\n"
    "for _, name in ipairs { 'queen', 'imp', 'whelp', 'guest' } do enemy.def(name, foe) end\n"
    "local sys, log, seen = string.sys, {}, '0/0/0/0'\n"
    "local function say(s) log[#log + 1] = tostring(s) end\n"
    "function string.told() return table.concat(log, ' ') end\n"
    "function string.frame_end()\n"
    "  local s = ('%d/%d/%d/%d'):format(enemy.count 'imp', enemy.count 'whelp', enemy.count 'guest', board.live "
    "'sprites')\n"
    "  if s ~= seen then say(board.frame() .. ':' .. s) end\n"
    "  seen = s\n"
    "end\n"
    "on.kill(function(e) say('kill ' .. e.kind) end)\n"
    "on.leave(function(e) say('leave ' .. e.kind) end)\n"
    "on.phase(function(_, id, won) say(id .. (won and ' won' or ' lost')) end)\n"
    "sys.join(1, 'ship')\n"
    "local function spawn(kind, more)\n"
    "  local a = { kind = kind, tag = kind, x = 50, y = 50 }\n"
    "  for k, v in pairs(more or {}) do a[k] = v end\n"
    "  return enemy.spawn(a)\n"
    "end\n"
    "local function put(more)\n"
    "  local a = { sprite = 'dot', x = 9, y = 9 }\n"
    "  for k, v in pairs(more or {}) do a[k] = v end\n"
    "  return sprite.put(a)\n"
    "end\n"
    "local function fire() while true do bullet.fire { kind = 'dot', x = 9, y = 9, speed = 0 } wait(1) end end\n"
    "local function brood(e)\n" /* an imp that spawns a whelp that puts a sprite and fires, and a sprite */
    "  spawn('imp', { run = function() spawn('whelp', { run = function() put() fire() end }) wait(forever) end })\n"
    "  put()\n"
    "end\n"
    "local function guest(e)\n" /* a guest who spawns another who puts a sprite: nobody's, all of them */
    "  spawn('guest', { stay = true, run = function() spawn('guest', { run = function() put() end }) wait(forever) end "
    "})\n"
    "  put { stay = true }\n"
    "end\n"
    "local function fight(one, two, more)\n"
    "  local first = { id = 'one', hp = 10, time = 5, rest = 3, run = one }\n"
    "  for k, v in pairs(more or {}) do first[k] = v end\n"
    "  local second = { id = 'two', hp = 10, time = 5, run = two or function() end }\n"
    "  boss.def('b', { title = 'B', kind = 'queen', x = 50, y = 40, phases = { first, second } })\n"
    "end\n"
    "local function alone() task.go(function() boss.fight 'b' say('over') end) end\n"
    "local function result() say(player.get(1).score) say(board.live 'sparks') say(board.live 'bullets') end\n";

struct scene {
    const char *name, *code;
    int frames;
    const char *log;
};

static const struct scene scenes[] = {
    { "a phase whose time is up", "fight(brood, function() result() end) alone()", 140,
      "61:1/1/0/2 one lost 66:0/0/0/0 0 0 0 two lost over" },
    { "a phase that is beaten",
      "fight(function(e) brood(e) wait(2) e.hp = 0 end, function() result() end, { bonus = 7 }) alone()", 140,
      "61:1/1/0/2 one won 64:0/0/0/0 7 0 0 two lost over" },
    { "a phase outlasted", "fight(brood, function() result() end, { survive = true }) alone()", 140,
      "61:1/1/0/2 one won 66:0/0/0/0 0 0 0 two lost over" },
    { "what stays stays, with what it spawns", "fight(function(e) brood(e) guest(e) end) alone()", 140,
      "61:1/1/2/4 one lost 66:0/0/2/2 two lost over" },
    { "what comes of what stays stays, whoever kills it",
      "enemy.def('late', { sprite = 'dot', hit = { circle = 4 }, hp = 1, on_death = function()\n"
      "  task.go(function() wait(40) say('late') end) end })\n"
      "fight(function(e) local m = enemy.spawn { kind = 'late', x = 9, y = 99, stay = true } wait(1) m:kill() end) "
      "alone()",
      140, "kill late one lost two lost late over" },
    { "a boss that a script kills", "fight(function(e) brood(e) guest(e) wait(2) e:kill() end) alone()", 140,
      "61:1/1/2/4 kill queen one lost 64:0/0/2/2 over" },
    { "a boss that a script removes in a handler",
      "local queen\n"
      "fight(function(e) queen = e brood(e) spawn('imp', { stay = true, x = 400 }) end)\n"
      "on.leave(function() queen:remove() end) alone()",
      75, "leave imp 61:1/1/0/2 one lost 62:0/0/0/0 over" },
    { "a fight whose task is stopped",
      "fight(function(e) brood(e) guest(e) end)\n"
      "local t = task.go(function() boss.fight 'b' end)\n"
      "task.go(function() wait(62) task.stop(t) wait(2) say(enemy.count()) result() end)",
      75, "61:1/1/2/4 64:0/0/2/2 2 0 0 3" },
    { "a stage that ends during a fight",
      "fight(function(e) brood(e) guest(e) end)\n"
      "stage.def('s', function() task.go(boss.fight, 'b') wait(62) end)\n"
      "task.go(function() local s = stage.play('s', sys.scope()) wait_for(s) wait(1) say(enemy.count()) result() end)",
      75, "61:1/1/2/4 63:0/0/2/2 2 0 0 2" },
    { "a scope that ends during a fight in it",
      "fight(function(e) brood(e) end)\n"
      "local scope = sys.scope()\n"
      "task.own(scope, function() boss.fight 'b' end)\n"
      "task.go(function() wait(62) task.stop(scope) wait(2) say(enemy.count()) end)",
      75, "61:1/1/0/2 64:0/0/0/0 0" },
    { "the stage's clock goes on when a fight is cut short",
      "fight(function() end)\n"
      "stage.def('s', function()\n"
      "  local t = task.go(boss.fight, 'b') wait(30) task.stop(t) wait(1) stage.at(10) say('at ' .. board.frame())\n"
      "end)\n"
      "task.go(function() stage.play('s', sys.scope()) end)",
      75, "at 40" },
    { "a move that the phase began",
      "local queen\n"
      "fight(function(e) queen = e e:move { x = 150, y = 40, over = 10 } end, function(e) say(e.x) wait(1) say(e.x) "
      "end, "
      "{ rest = 0 }) alone()",
      75, "100.0 one lost 100.0 two lost" },
    { "practice: a phase alone",
      "fight(function(e) brood(e) guest(e) end)\n"
      "task.go(boss.practice('x', 'b', 'one'))",
      75, "61:1/1/2/4 one lost 66:0/0/2/2" },
    { "tasks and scopes of a phase, and those of its sprites and bullets",
      "fight(function(e)\n"
      "  task.go(function() wait(1) spawn('imp') end)\n"
      "  task.own(task.scope(), function() spawn('imp') task.own(task.scope(), function() spawn('imp') end) end)\n"
      "  task.own(put(), function() spawn('whelp') end)\n"
      "  task.own(bullet.fire { kind = 'dot', x = 9, y = 9, speed = 0 }, function() spawn('whelp') task.go(spawn, "
      "'whelp') end)\n"
      "end) alone()",
      75, "61:2/3/0/1 62:3/3/0/1 one lost 66:0/0/0/0 two lost" },
    { "what a phase has others do is theirs",
      "local mate\n"
      "task.go(function() mate = spawn('guest') end)\n"
      "fight(function(e)\n"
      "  task.own(player.get(1), function() spawn('guest') end)\n"
      "  task.own(mate, function() spawn('guest') wait(forever) end)\n"
      "  task.own(e, function() spawn('guest') wait(forever) end)\n"
      "end) alone()",
      75, "1:0/0/1/0 61:0/0/4/0 one lost two lost" },
    { "a wave",
      "local way = path.def { { x = 9, y = 9 }, { wait = 100 } }\n"
      "fight(function(e)\n"
      "  stage.wave { kind = 'queen', n = 9, every = 3, path = way, run = function() spawn('imp') end }\n"
      "  stage.wave { kind = 'queen', n = 9, every = 3, path = way, stay = true, run = function() spawn('guest') end "
      "}\n"
      "end) alone()",
      75, "61:1/0/1/0 64:2/0/2/0 one lost 66:0/0/2/0 two lost" },
    { "on_death and on_hit are in their enemy's phase",
      "fight(function(e)\n"
      "  local function split(me) spawn('whelp') put() task.go(function() wait(1) spawn('whelp') fire() end) end\n"
      "  local function hit(x) shot.fire { kind = 'bolt', x = x, y = 50, speed = 0 } end\n"
      "  spawn('imp', { on_death = split }):kill()\n"
      "  spawn('imp', { hp = 1, x = 100, on_death = split }) hit(100)\n"
      "  spawn('imp', { hp = 1, x = 150, stay = true, on_death = function() spawn('guest') end }) hit(150)\n"
      "  wait(2) spawn('imp', { stay = true, on_death = function() spawn('guest') end }):kill()\n"
      "end) alone()",
      75, "kill imp kill imp kill imp 61:0/2/1/2 62:0/3/1/2 kill imp 63:0/4/2/2 one lost 66:0/0/2/0 two lost" },
    { "handlers are nobody's",
      "on.kill(function(e) if e.kind == 'imp' then spawn('guest') task.go(spawn, 'guest') end end)\n"
      "fight(function(e) spawn('imp'):kill() end) alone()",
      75, "kill imp 61:0/0/1/0 62:0/0/2/0 one lost two lost" },
    { "an error caught on its way out of on_death",
      "local function bad() spawn('whelp') error('x') end\n"
      "fight(function(e)\n"
      "  spawn('imp')\n"
      "  local g = spawn('guest', { stay = true, on_death = bad })\n"
      "  pcall(g.kill, g) spawn('imp')\n"
      "  pcall(function() wait(1) spawn('guest', { stay = true, on_death = bad }):kill() end) spawn('imp')\n"
      "end) alone()",
      75, "kill guest 61:2/1/0/0 kill guest 62:3/2/0/0 one lost 66:0/2/0/0 two lost" },
    { "an error caught in on_death leaves it where it was",
      "local function bad() error('x') end\n"
      "fight(function(e)\n"
      "  local imp = spawn('imp', { on_death = bad })\n"
      "  spawn('guest', { stay = true, on_death = function() pcall(imp.kill, imp) spawn('guest') end }):kill()\n"
      "  spawn('imp')\n"
      "end) alone()",
      75, "kill guest kill imp 61:1/0/1/0 one lost 66:0/0/1/0 two lost" },
    { "an error caught in a __close",
      "local function bad() error('x') end\n"
      "local t\n"
      "local function close() local g = spawn('guest', { stay = true, on_death = bad }) say(pcall(g.kill, g) and 'no' "
      "or 'caught') spawn('imp') end\n"
      "fight(function(e)\n"
      "  t = task.go(function() local k <close> = setmetatable({}, { __close = close }) wait(forever) end)\n"
      "  wait(1) task.stop(t)\n"
      "end) alone()",
      75, "caught kill guest 62:1/0/0/0 one lost 66:0/0/0/0 two lost" },
    { "who dies in the phase's last frame is told of, and scores",
      "local imp\n"
      "fight(function(e) imp = spawn('imp', { on_death = function() spawn('whelp') end }) end,\n"
      "  function() result() end)\n"
      "task.go(function() wait_until(function() return imp end) wait(4) imp:kill() end) alone()",
      75, "61:1/0/0/0 kill imp one lost 66:0/0/0/0 100 12 0 two lost" },
    { "nothing comes into a phase that is over",
      "local function farewell() spawn('imp') put() task.go(function() spawn('imp') put() end) spawn('guest', { stay = "
      "true }) end\n"
      "fight(function(e) local k <close> = setmetatable({}, { __close = farewell }) wait(forever) end) alone()",
      75, "one lost 66:0/0/1/0 two lost" },
    { "what is not of the phase stays",
      "task.go(function() brood() wait(64) spawn('imp') put() end) fight(function() put() end) alone()", 140,
      "1:1/1/0/2 61:1/1/0/3 65:2/1/0/4 one lost 66:2/1/0/3 two lost over" },
};

static void frame(struct rig *r, bool spoil)
{
    const uint16_t none[MAX_PLAYERS] = { 0 };

    rig_tick(r, none);
    lua_State *L = r->b->vm.L;
    lua_getglobal(L, "string");
    lua_getfield(L, -1, "frame_end");
    lua_call(L, 0, 0);
    lua_settop(L, 0);
    if (spoil)
        rig_spoil(r);
}

/* Runs it plainly and with RAM spoilt after every frame; the hashes are the same all along. */
static void run(const struct scene *s)
{
    static char text[1 << 14];
    struct rig_game g;
    struct rig a, b;

    snprintf(text, sizeof text, "%s%s", game, s->code);
    rig_with_sys(&g, NULL, text);
    rig_power(&a, &g, NULL);
    rig_power(&b, &g, NULL);
    for (int f = 0; f < s->frames; f++) {
        frame(&a, false);
        frame(&b, true);
        if (rig_differs(&a, &b))
            fail_msg("%s: frame %d: %s differs after snapshot and restore", s->name, f + 1, rig_differs(&a, &b));
    }
    if (strcmp(rig_told(&a), s->log))
        fail_msg("%s:\n     got %s\nexpected %s", s->name, rig_told(&a), s->log);
    rig_free(&a);
    rig_free(&b);
    rig_game_free(&g);
}

/* A game from its title, where start is pressed in the 8th and the 11th frame, and again after so many. */
static void play(struct rig *r, struct rig_game *g, const char *code, int again, int frames)
{
    static const char last[] = "boot.run { stages = { 's' }, players = { 'ship' } }\n";
    const uint16_t start[MAX_PLAYERS] = { PAD_START };
    struct manifest m = rig_manifest();
    static char text[1 << 14];

    m.players = 1;
    snprintf(text, sizeof text, "%s%s%s", game, code, last);
    rig_with_sys(g, &m, text);
    rig_power(r, g, NULL);
    for (int f = 0; f < frames; f++) {
        if (f == 7 || f == 10 || f == 10 + again)
            rig_tick(r, start);
        frame(r, false);
    }
}

/* A stage that is over fires no more while its results are shown. */
TEST(results)
{
    struct rig_game g;
    struct rig r;

    play(&r, &g, "stage.def('s', function() brood() guest() put() wait(20) say('end') end)\n", 0, 90);
    assert_int_equal(r.b->sprites.s.live, 6); /* what is behind the results stays; their plate */
    assert_int_equal(r.b->bullets.s.live, 0);
    assert_string_equal(rig_told(&r), "9:0/0/0/1 13:1/1/2/5 end 33:0/0/0/6"); /* the title's bar first */
    rig_free(&r);
    rig_game_free(&g);
}

/* The pause takes a scope and a task: without room for both it does not come, and the game goes on. */
TEST(pause)
{
    for (int room = 0; room <= 2; room++) {
        char code[256];
        struct rig_game g;
        struct rig r;
        snprintf(code, sizeof code,
                 "stage.def('s', function()\n"
                 "  local all = {}\n"
                 "  repeat all[#all + 1] = task.go(wait, forever) until not all[#all].alive\n"
                 "  for i = 1, %d do task.stop(all[#all - i]) end\n"
                 "  wait(forever)\n"
                 "end)\n",
                 room);
        play(&r, &g, code, 50, 90);
        assert_int_equal(r.b->core.frozen != 0, room == 2);
        assert_int_equal(r.b->core.clock < r.b->core.frame, room == 2);
        rig_free(&r);
        rig_game_free(&g);
    }
}

TEST(scenes)
{
    for (size_t i = 0; i < sizeof scenes / sizeof *scenes; i++)
        run(&scenes[i]);
}

RUN_TESTS(NULL, NULL)
