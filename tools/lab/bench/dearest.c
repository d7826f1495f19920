/*
 * dearest.c - see dearest.h.
 *
 * Where two pools are tested against each other all of both lie where every pair has to be looked at and none touches:
 * then nothing ends a search early.
 */
#include "dearest.h"

#define MILLION "1000000"

/* fill(f, n, args): f with n = 60,000 until n were made. */
#define FILL "local function fill(n, t) while n > 0 do t.n = math.min(n, 60000) n = n - t.n pattern.ring(t) end end "
#define TARGET                                                                                                         \
    "player.def('target', { sprite = 'd8', hit = { circle = 2 }, graze = 12, safe = 0, lives = 99 }) "                 \
    "on.hit(function(p) p.safe = 1 end) "
#define GO(body) "task.go(function() " body " end) boot.run()"

/* Circles that reach far from their middle and leave it free. */
#define WIDE               "{ circles = { { -60, 0, 1 }, { 60, 0, 1 }, { 0, 60, 1 }, { 0, -60, 1 } } }"
#define WIDE_ENEMIES(more) "enemy.def('wall', { sprite = 'd8', hit = " WIDE ", touch = false, hp = 1000000" more " }) "
#define SPAWN              "for i = 1, 4096 do enemy.spawn { kind = 'wall', x = 100, y = 100 } end "

static void wide_pools(struct manifest *m)
{
    m->shots = 65536;
    m->enemies = 4096;
    m->lasers = 4096;
    m->curve_points = 4096 * 32;
    m->has_pierce = 1;
    m->lua_kib = 65536;
}

static void meets(struct manifest *m)
{
    m->bullets_can_meet = 1;
}

static void documents(struct manifest *m)
{
    m->bulletml_runners = 8192;
}

static void shown(struct manifest *m)
{
    wide_pools(m);
    m->sprites = 65536;
    m->lines = 4096;
    m->items = 65536;
}

static void many_tasks(struct manifest *m)
{
    m->tasks = 65536;
    m->lua_kib = 262144;
}

#define TENTH  "$rand/$rand/$rand/$rand/$rand/$rand/$rand/$rand/$rand/$rand/"
#define VALUE  TENTH TENTH TENTH TENTH TENTH TENTH TENTH TENTH TENTH TENTH "1"
#define SPEEDS "<changeSpeed><speed>" VALUE "</speed><term>1</term></changeSpeed>"

static const char DOCUMENT[] =
    "<?xml version=\"1.0\"?><bulletml><action label=\"top\"><repeat><times>4000</times><action><fire><bulletRef "
    "label=\"b\"/></fire></action></repeat></action><bullet label=\"b\"><speed>0.01</speed><action><repeat>"
    "<times>40000</times><action>" SPEEDS "</action></repeat></action></bullet></bulletml>";

const struct dearest DEAREST[] = {
    { "`bullet.meet`: 60,000 bullets and 60,000 at one point",
      "bullet.meet: too much work in one frame (60000 bullets",
      2,
      WORK_LIMIT,
      { .bullets = 120000,
        .manifest = meets,
        .script = FILL TARGET
        "bullet.def('orb', { sprite = 'd8', hit = { circle = 3 } }) bullet.meet('a', 'b', { on_meet = function() end "
        "}) " GO("fill(60000, { x = 120, y = 160, kind = 'orb', speed = 0.0001, tag = 'a' }) "
                 "fill(60000, { x = 120, y = 160, kind = 'orb', speed = 0.0001, tag = 'b' })") } },
    { "`bullet.meet`: a million bullets of four circles each that reach past each other",
      "bullet.meet: too much work in one frame (500000 bullets",
      2,
      WORK_LIMIT,
      { .bullets = 1000000,
        .manifest = meets,
        .script = FILL TARGET "bullet.def('orb', { sprite = 'd8', hit = " WIDE
                              " }) bullet.meet('a', 'b', { on_meet = function() end }) " GO(
                                  "fill(500000, { x = 120, y = 160, kind = 'orb', speed = 0.0001, tag = 'a' }) "
                                  "fill(500000, { x = 150, y = 160, kind = 'orb', speed = 0.0001, tag = 'b' })") } },
    { "65,536 shots that cancel, and a million bullets",
      "shots that hit bullets: too much work in one frame (65536 shots, 1000000 bullets)",
      2,
      WORK_LIMIT,
      { .bullets = 1000000,
        .manifest = wide_pools,
        .script = FILL TARGET "bullet.def('orb', { sprite = 'd8', hit = { circle = 3 } }) "
                              "shot.def('axe', { sprite = 'd8', hit = { circle = 3 }, cancels = true }) " GO(
                                  "fill(" MILLION ", { x = 20, y = 20, kind = 'orb', speed = 0.0001 }) "
                                  "fill(65536, { x = 300, y = 200, kind = 'axe', speed = 0.0001, fire = 'shot' })") } },
    { "65,536 shots that cancel, each among a million bullets of four circles",
      "shots that hit bullets: too much work in one frame (65536 shots, 1000000 bullets)",
      2,
      WORK_LIMIT,
      { .bullets = 1000000,
        .manifest = wide_pools,
        .script = FILL TARGET "bullet.def('orb', { sprite = 'd8', hit = " WIDE " }) "
                              "shot.def('axe', { sprite = 'd8', hit = " WIDE ", cancels = true }) " GO(
                                  "fill(" MILLION ", { x = 100, y = 100, kind = 'orb', speed = 0.0001 }) "
                                  "fill(65536, { x = 130, y = 100, kind = 'axe', speed = 0.0001, fire = 'shot' })") } },
    { "4,096 enemies that block, and a million bullets",
      "enemies that block bullets: too much work in one frame (4096 enemies, 1000000 bullets)",
      2,
      WORK_LIMIT,
      { .bullets = 1000000,
        .manifest = wide_pools,
        .script = FILL TARGET "bullet.def('orb', { sprite = 'd8', hit = { circle = 3 } }) " WIDE_ENEMIES(
            ", blocks = true") GO(SPAWN "fill(" MILLION ", { x = 120, y = 100, kind = 'orb', speed = 0.0001 })") } },
    { "65,536 shots, and 4,096 enemies of four circles",
      "shots that hit enemies: too much work in one frame (65536 shots, 4096 enemies)",
      2,
      WORK_LIMIT,
      { .manifest = wide_pools,
        .script = FILL TARGET "shot.def('axe', { sprite = 'd8', hit = " WIDE " }) " WIDE_ENEMIES("")
            GO(SPAWN "fill(65536, { x = 130, y = 100, kind = 'axe', speed = 0.0001, fire = 'shot' })") } },
    { "65,536 shots that pierce everything, and 4,096 enemies",
      "shots that hit enemies: too much work in one frame (65536 shots, 4096 enemies)",
      2,
      WORK_LIMIT,
      { .manifest = wide_pools,
        .script =
            FILL TARGET "shot.def('axe', { sprite = 'd8', hit = { circle = 3 }, pierce = forever }) "
                        "enemy.def('wall', { sprite = 'd8', hit = { circle = 9 }, touch = false, hp = 1000000 }) " GO(
                            SPAWN "fill(65536, { x = 102, y = 100, kind = 'axe', speed = 0.0001, fire = 'shot' })") } },
    { "4,096 lasers of players, and 4,096 enemies",
      "laser hits: too much work in one frame (4096 lasers, 4096 enemies)",
      2,
      WORK_LIMIT,
      { .manifest = wide_pools,
        .script = TARGET
        "laser.def('ray', { strip = 'ray', width = 4, hit = { share = 1 }, damage = 1 }) " WIDE_ENEMIES("")
            GO(SPAWN "for i = 1, 4096 do laser.beam { kind = 'ray', x = 115, y = 115, dir = 45, length = 20, warn = 0, "
                     "grow = 0, hold = forever } end") } },
    { "a million bullets, each with a motion program of named steps",
      "motions: ",
      2,
      WORK_LIMIT,
      { .bullets = 1000000,
        .groups = true,
        .script =
            FILL TARGET "value.def('v') bullet.def('orb', { sprite = 'd8', hit = { circle = 3 } }) "
                        "local m = motion.def { { loop = 400, { turn = 'v' }, { turn = 'v' } } } " GO(
                            "fill(" MILLION ", { x = 20, y = 20, kind = 'orb', speed = 0.0001, motion = m })") } },
    { "65,536 shots that aim at the nearest of 4,096 enemies 400 times",
      "motions: ",
      2,
      WORK_LIMIT,
      { .manifest = wide_pools,
        .script = FILL TARGET "shot.def('axe', { sprite = 'd8', hit = { circle = 1 } }) " WIDE_ENEMIES(
            "") "local m = motion.def { { loop = 400, { aim = true } } } " GO(SPAWN
                                                                              "fill(65536, { x = 130, y = 130, kind "
                                                                              "= 'axe', speed = 0.0001, fire = "
                                                                              "'shot', motion = m })") } },
    { "4,096 bullets that each emit 60,000",
      NULL,
      3,
      20000000,
      { .bullets = 1000000,
        .script = FILL TARGET
        "bullet.def('orb', { sprite = 'd8', hit = { circle = 3 } }) "
        "local m = motion.def { { emit = { pattern = 'ring', n = 60000, kind = 'orb', speed = 0.01 } } } " GO(
            "fill(4096, { x = 20, y = 20, kind = 'orb', speed = 0.0001, motion = m })") } },
    { "300,000 grazes, each reported to 100 handlers",
      "events: ",
      2,
      WORK_LIMIT,
      { .bullets = 300000,
        .script = FILL TARGET "bullet.def('orb', { sprite = 'd8', hit = { circle = 3 } }) "
                              "for i = 1, 100 do on.graze(function() end) end " GO(
                                  "wait(1) local p = player.nearest(0, 0) "
                                  "fill(300000, { x = p.x + 11, y = p.y, kind = 'orb', speed = 0.0001 })") } },
    { "4,000 BulletML runners with values of 100 numbers",
      "bulletml/doc.xml:1: ",
      3,
      WORK_LIMIT,
      { .bullets = 8192,
        .manifest = documents,
        .document = DOCUMENT,
        .script = TARGET "bullet.def('orb', { sprite = 'd8', hit = { circle = 3 } }) " GO(
            "bullet.ml { name = 'doc', kind = 'orb', x = 120, y = 100, rank = 0.5 }") } },
    { "tasks that start each other",
      "infinite loop",
      2,
      WORK_LIMIT,
      { .bullets = 64,
        .manifest = many_tasks,
        .script = TARGET "local function again() task.go(again) end " GO("again()") } },
    { "65,536 tasks that wait for the next frame",
      NULL,
      3,
      6000000,
      { .bullets = 64,
        .manifest = many_tasks,
        .script = TARGET
        "local function stay() while true do wait(1) end end " GO("for i = 1, 65530 do task.go(stay) end") } },
    { "a loop of `aim` of 65,536 shots with 4,096 enemies",
      "infinite loop",
      2,
      WORK_LIMIT,
      { .manifest = wide_pools,
        .script = FILL TARGET "shot.def('axe', { sprite = 'd8', hit = { circle = 1 } }) " WIDE_ENEMIES("")
            GO(SPAWN "fill(65536, { x = 130, y = 130, kind = 'axe', speed = 0.0001, fire = 'shot' }) "
                     "while true do shot.group():aim() end") } },
    { "a loop of `query.near` of 200,000 bullets",
      "infinite loop",
      2,
      WORK_LIMIT,
      { .bullets = 200000,
        .manifest = wide_pools,
        .script = FILL TARGET "bullet.def('orb', { sprite = 'd8', hit = { circle = 3 } }) " GO(
            "fill(200000, { x = 20, y = 20, kind = 'orb', speed = 0.0001 }) "
            "while true do query.near { what = 'bullet', x = 20, y = 20, radius = 100 } end") } },
    { "a loop of `spark.burst` of 60,000",
      "infinite loop",
      2,
      WORK_LIMIT,
      { .bullets = 64,
        .sparks = 60000,
        .script = TARGET "spark.def('dust', { sprite = 'd8', life = 1000 }) " GO(
            "while true do spark.burst { kind = 'dust', x = 9, y = 9, n = 60000 } end") } },
    { "the picture: 26,000 bullets of 240 px, blended",
      NULL,
      2,
      180000000,
      { .bullets = 65536,
        .side = 240,
        .script = FILL TARGET "bullet.def('disc', { sprite = 'kind1', hit = 'none', blend = 'glow' }) " GO(
            "fill(26000, { x = 160, y = 120, kind = 'disc', speed = 0.0001 })") } },
    { "the picture: 65,536 bullets of 240 px, blended",
      "drawing: too much work in one frame (mostly bullets and shots)",
      2,
      1000000,
      { .bullets = 65536,
        .side = 240,
        .script = FILL TARGET "bullet.def('disc', { sprite = 'kind1', hit = 'none', blend = 'glow' }) " GO(
            "fill(65536, { x = 160, y = 120, kind = 'disc', speed = 0.0001 })") } },
    { "the picture: 65,536 sprites of 240 px, opaque",
      NULL,
      2,
      59000000,
      { .bullets = 64,
        .side = 240,
        .manifest = shown,
        .script = TARGET GO("for i = 1, 65536 do sprite.put { sprite = 'kind1', x = 160, y = 120 } end") } },
    { "the picture: a million sparks of 24 px, blended",
      NULL,
      2,
      70000000,
      { .bullets = 64,
        .sparks = 1000000,
        .script = TARGET "spark.def('dust', { sprite = 'd24', life = 1000, blend = 'glow' }) " GO(
            "for i = 1, 20 do spark.burst { kind = 'dust', x = 160, y = 120, n = 50000, speed = 1 } end") } },
    { "the picture: 1,200 beams of 300 px, 200 px wide",
      NULL,
      2,
      100000000,
      { .bullets = 64,
        .manifest = wide_pools,
        .script = TARGET "laser.def('ray', { strip = 'd16', width = 200, hit = 'none', blend = 'glow' }) " GO(
            "for i = 1, 1200 do laser.beam { kind = 'ray', x = 10, y = 120, dir = 0.3, length = 300, warn = 0, grow = "
            "0, "
            "hold = forever } end") } },
    { "the picture: 4,096 lines of 240 letters, in boxes",
      NULL,
      2,
      0,
      { .bullets = 64,
        .manifest = shown,
        .script =
            TARGET GO("local t = ('a b'):rep(80) for i = 1, 4096 do text.line { x = 20, y = 20, text = t, width = 200, "
                      "box = true } end") } },
};
const int DEAREST_COUNT = sizeof DEAREST / sizeof *DEAREST;
