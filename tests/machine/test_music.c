/*
 * test_music.c - which piece plays when: what is put aside and goes on, switches at a bar, bosses, stages, screens,
 * pauses and ways to a mark; and the sounds that play by themselves. The pieces are those of rig_sounds: "tide" never
 * ends, "deep" does. tests/scripts/music.lua has what is refused.
 */
#include "rig.h"

static struct rig_game game;
static struct rig rig;

static const char ship[] = "player.def('ship', { sprite = 'dot', hit = { circle = 1 }, lives = 1 })\n"
                           "enemy.def('e', { sprite = 'dot', hit = { box = { 8, 8 } }, touch = false, hp = 5 })\n"
                           "local sys = string.sys\n"
                           "local function down(n) return function(e) wait(n) e.hp = 0 end end\n"
                           "local function phase(id, n, t) local p = { id = id, hp = 9, time = 900, rest = 40,\n"
                           "  run = down(n) } for k, v in pairs(t or {}) do p[k] = v end return p end\n"
                           "local function one(t, ...) t.title, t.kind, t.x, t.y = 'B', 'e', 90, 40\n"
                           "  t.phases = { ... } boss.def('b', t) end\n";

static void power_from(const char *script, const char *section)
{
    struct manifest m = rig_manifest();
    struct board_start start = { .seed = 1, .difficulty = -1 };
    static char text[1 << 13];

    m.has_sound = 1;
    snprintf(start.practice.section, sizeof start.practice.section, "%s", section);
    snprintf(text, sizeof text, "%s%s", ship, script);
    rig_with_sys(&game, &m, text);
    rig_sounds(&game);
    rig_power(&rig, &game, &start);
}

static void power(const char *script)
{
    power_from(script, "");
}

static uint64_t heard(const struct board *b)
{
    int16_t sound[2 * BOARD_SOUND_FRAMES];

    board_mix_sound(b, &rig_sound_tables, sound);
    return hash_bytes(HASH_START, sound, sizeof sound);
}

/* What a game sounds like, frame by frame. */
static void listen(const char *script, uint64_t *out, int frames)
{
    power(script);
    for (int f = 0; f < frames; f++) {
        rig_run(&rig, 1);
        out[f] = heard(rig.b);
    }
    rig_close(&rig);
}

/* ---- what plays ---- */

static const char *name_now(void)
{
    const uint16_t tune = rig.b->music.tune;

    return tune ? cart_name(&rig.b->cart, CART_TUNES, tune - 1) : "-";
}

/* Every change in so many frames: in which frame what plays from then on, and at which hundredth of a beat. Good until
 * the next call. */
static const char *changes(int frames)
{
    static char said[4096];
    uint16_t was = 0;
    uint64_t pos = 0;
    size_t n = 0;

    said[0] = 0;
    for (int f = 0; f < frames; f++) {
        rig_run(&rig, 1);
        const struct seq *s = &rig.b->music;
        if (s->tune != was || s->pos < pos)
            n += (size_t)snprintf(said + n, sizeof said - n, "%s%d %s %d", n ? ", " : "", f, name_now(),
                                  (int)(s->pos * 100 / ((uint64_t)TUNE_QUARTER * TUNE_TICK)));
        was = s->tune;
        pos = s->pos;
    }
    return said;
}

static const struct story {
    const char *script, *changes;
    int frames;
} stories[] = {
    { "music.play('deep')", "0 deep 2, 161 - 0", 400 },
    { "music.play('tide') task.go(function() wait(20) music.play('deep', { fade = 10 }) end)",
      "0 tide 3, 30 deep 2, 191 - 0", 300 },
    { "music.play('tide') task.go(function() wait(20) music.play('deep', { back = true }) end)",
      "0 tide 3, 20 deep 2, 181 tide 77", 300 },
    { "music.play('tide') task.go(function() wait(20) music.play('deep', { back = true }) wait(30) music.play('tide') "
      "end)",
      "0 tide 3, 20 deep 2, 50 tide 77", 300 },
    { "music.play('tide') task.go(function() wait(20) music.play('deep', { back = true }) wait(30)\n"
      "music.play('tide', { again = true }) end)",
      "0 tide 3, 20 deep 2, 50 tide 3", 300 },
    { "music.play('tide') task.go(function() wait(20) music.play('deep', { back = true }) wait(30)\n"
      "music.stop { fade = 20 } end)",
      "0 tide 3, 20 deep 2, 70 - 0", 300 },
    /* a fade that is forgotten in its first frame; one that another takes over */
    { "music.play('tide') task.go(function() wait(20) music.stop { fade = 60 } music.play('tide') end)", "0 tide 3",
      200 },
    { "music.play('tide') task.go(function() wait(20) music.stop { fade = 60 } wait(1) music.play('tide') end)",
      "0 tide 3, 21 tide 3", 200 },
    { "music.play('tide') task.go(function() wait(20) music.stop { fade = 60 } wait(30)\n"
      "music.play('deep', { fade = 60 }) end)",
      "0 tide 3, 80 deep 2", 200 },
    { "music.play('tide') task.go(function() wait(20) music.stop { fade = 600 } wait(30)\n"
      "music.play('deep', { fade = 6 }) end)",
      "0 tide 3, 56 deep 2", 200 },
    /* on the next beat, which comes in frame 27; and the second bar, at 97 from beat 1.5 on */
    { "music.play('tide') task.go(function() wait(20) music.play('deep', { at = 'beat' }) end)", "0 tide 3, 27 deep 2",
      100 },
    { "music.play('tide') task.go(function() wait(20) music.play('deep', { at = 'bar' }) end)", "0 tide 3, 133 deep 1",
      200 },
    { "music.play('tide') task.go(function() wait(20) music.play('deep', { at = 'bar' }) wait(9) music.play('tide') "
      "end)",
      "0 tide 3", 200 },
    /* three deep, and one more, which loses what it covers */
    { "music.play('tide') task.go(function() for _ = 1, 4 do wait(10) music.play('deep', { back = true, again = true "
      "}) "
      "end end)",
      "0 tide 3, 10 deep 2, 20 deep 2, 30 deep 2, 40 deep 2, 201 deep 27, 352 deep 27, 503 tide 40", 600 },
    /* a boss's, and a phase's over it: the ways in and out are 60 frames */
    { "music.play('tide') one({ music = 'deep' }, phase('a', 20)) task.go(function() wait(20) boss.fight('b') end)",
      "0 tide 3, 50 deep 2, 161 tide 178", 400 },
    { "music.play('tide') one({ music = 'deep', warning = 50 }, phase('a', 20))\n"
      "task.go(function() wait(20) boss.fight('b') end)",
      "0 tide 3, 70 deep 2, 211 tide 232", 400 },
    { "music.play('tide') one({}, phase('a', 80, { music = 'deep' }), phase('b', 80, { music = 'deep' }), phase('c', "
      "9))\n"
      "task.go(function() wait(20) boss.fight('b') end)",
      "0 tide 3, 110 deep 2", 260 },
    { "music.play('deep') one({ music = 'tide' }, phase('a', 40, { music = 'deep' }), phase('c', 99))\n"
      "task.go(function() wait(20) boss.fight('b') end)",
      "0 deep 2, 50 tide 3, 110 deep 2, 181 tide 205, 321 deep 127, 432 - 0", 500 },
    /* the fight is cut short, in a phase with music */
    { "music.play('tide') one({ music = 'deep' }, phase('a', 400, { music = 'deep' }))\n"
      "local t = task.go(function() wait(20) boss.fight('b') end) task.go(function() wait(150) task.stop(t) end)",
      "0 tide 3, 50 deep 2, 211 tide 178", 400 },
};

static int tell(const struct story *list, size_t n)
{
    int failed = 0;

    for (size_t i = 0; i < n; i++) {
        power(list[i].script);
        const char *said = changes(list[i].frames);
        if (strcmp(said, list[i].changes) != 0) {
            print_error("%s\n     got %s\nexpected %s\n", list[i].script, said, list[i].changes);
            failed++;
        }
        rig_close(&rig);
    }
    return failed;
}

TEST(stories)
{
    assert_int_equal(tell(stories, sizeof stories / sizeof *stories), 0);
}

/* With RAM spoilt after each frame, and put back twice from ten frames before, it sounds the same. */
TEST(restored)
{
    static uint64_t straight[300], hashes[300];

    for (size_t i = 0; i < sizeof stories / sizeof *stories; i += 3) {
        power(stories[i].script);
        for (int f = 0; f < 300; f++) {
            rig_run(&rig, 1);
            straight[f] = heard(rig.b);
            hashes[f] = board_hash(rig.b);
        }
        rig_close(&rig);
        power(stories[i].script);
        for (int k = 0; k < 300; k += 10) {
            rig_spoil(&rig);
            for (int f = k; f < k + 20; f++) {
                if (f == k + 10)
                    rig_restore(&rig);
                rig_run(&rig, 1);
                const int at = f < k + 10 ? f : f - 10;
                if (heard(rig.b) != straight[at] || board_hash(rig.b) != hashes[at])
                    fail_msg("%s: frame %d is another", stories[i].script, at);
            }
        }
        rig_close(&rig);
    }
}

/* A piece that comes back sounds as if nothing had been between, but for its first frame. */
static void goes_on(const char *before)
{
    static uint64_t straight[400], interrupted[400];

    listen(before, straight, 400);
    for (int at = 35; at < 60; at += 6) { /* in notes and between them */
        char text[300];
        snprintf(text, sizeof text,
                 "%s task.go(function() wait(%d) music.play('deep', { back = true }) wait(50)\n"
                 "  music.play('tide') end)",
                 before, at);
        listen(text, interrupted, 400);
        for (int f = 0; f < 400; f++)
            if ((f < at || f > at + 50) && interrupted[f] != straight[f < at ? f : f - 50])
                fail_msg("put aside in frame %d: frame %d sounds otherwise", at, f);
    }
}

TEST(goes_on)
{
    goes_on("music.play('tide')");
    goes_on("music.play('deep') music.play('tide', { back = true })");
}

/* ---- screens ---- */

#define GAME                                                                                                           \
    "stage.def('s', function() wait(200) end, { music = 'deep' })\n"                                                   \
    "local function stands(n, ...) local t = { ... } return function() wait(n) return table.unpack(t) end end\n"       \
    "local function run(music, t) t.title = t.title or stands(30, 'start', 1) t.results = stands(150)\n"               \
    "  t.again = function() end\n"                                                                                     \
    "  t.ending, t.staff, t.name, t.scores = stands(50), stands(50), stands(50, { 'A' }), stands(50)\n"                \
    "  boot.run { stages = { 's' }, players = { 'ship' }, music = music, screens = t, staff = {} } end\n"

static const struct story screens[] = {
    /* the title's goes on until the game begins */
    { GAME "run({ title = 'tide' }, {})", "0 tide 3, 30 deep 2, 191 - 0, 661 tide 3, 691 deep 2", 750 },
    /* results end when the last words begin, and both have the same */
    { GAME "run({ title = 'tide', results = 'tide', over = 'deep', clear = 'tide' }, {})",
      "0 tide 3, 30 deep 2, 191 - 0, 231 tide 3, 621 - 0, 661 tide 3", 690 },
    { GAME "run({ ending = 'deep', staff = 'tide' }, { ending = stands(50) })",
      "30 deep 2, 191 - 0, 561 deep 2, 641 tide 3", 690 },
    /* an ending of its own music */
    { GAME "local t = { ending = 'deep', staff = 'tide' }\n"
           "boot.run { stages = { 's' }, players = { 'ship' }, music = t, staff = {}, ending = {\n"
           "  { when = { ship = 'x' }, show = stands(9) }, { show = stands(50), music = 'tide' } },\n"
           "  screens = { title = stands(30, 'start', 1), results = stands(150), staff = stands(50) } }",
      "30 deep 2, 191 - 0, 561 tide 3", 640 },
    /* the last life goes in frame 130 */
    { GAME "bullet.def('o', { sprite = 'dot', hit = { circle = 3 } })\n"
           "on.stage(function() task.go(function() wait(99) local p = player.get(1) p.safe = 0\n"
           "  bullet.fire { kind = 'o', from = p, speed = 0 } score.add(9) end) end)\n"
           "run({ over = 'tide', name = 'deep' }, {})",
      "30 deep 2, 161 tide 3, 341 deep 2, 391 - 0", 420 },
};

TEST(screens)
{
    assert_int_equal(tell(screens, sizeof screens / sizeof *screens), 0);
}

/* ---- ways to a mark ---- */

/* Runs until the game prints something; false: it does not in so many frames. */
static bool until_told(int frames)
{
    const uint16_t none[MAX_PLAYERS] = { 0 };

    for (int f = 0; f < frames; f++) {
        rig_tick(&rig, none);
        if (board_last_output(rig.b)->log_size > 0)
            return true;
    }
    return false;
}

enum { AFTER = 240 };

/* From a mark of the stage: what plays, where, and each frame's samples. */
static void run_from(const char *script, const char *section, uint64_t out[AFTER])
{
    static char text[4096];

    snprintf(text, sizeof text, "%s boot.run { stages = { 's' }, players = { 'ship' } }", script);
    power_from(text, section);
    assert_true(until_told(4000));
    for (int f = 0; f < AFTER; f++) {
        const struct seq *s = &rig.b->music;
        out[f] = hash_fold(hash_fold(heard(rig.b), s->pos), s->tune + 100u * s->marker + 10000u * s->suspended_count);
        rig_run(&rig, 1);
    }
    rig_close(&rig);
}

/* A stage that waits and whose clock is waited for, in a practice start of the stage and of its mark. */
TEST(marks)
{
    static const char *const ways[] = {
        "music.play('tide') stage.at(200)",
        "music.play('tide') stage.at(150) music.play('deep', { fade = 40 }) stage.at(170)",
        "music.play('tide') stage.at(150) music.play('deep', { fade = 40 }) wait(39) music.stop { fade = 20 } wait(10)",
        "music.play('tide') wait(31) music.play('deep', { back = true }) stage.at(350)",
        "music.play('tide') stage.at(20) music.play('deep', { at = 'bar' }) stage.at(140)",
        "music.play('tide') music.wait(5) stage.at(190) music.wait('drop')",
        "music.play('tide') music.volume(0.25, 90) stage.at(60)",
        "music.play('tide') stage.at(90) boss.fight('b') stage.at(190)",
        "music.play('tide') stage.at(90) boss.fight('c') wait(70)",
        "stage.at(90) music.play('deep') boss.fight('d') music.play('tide', { fade = 60 }) stage.at(160)",
    };
    static uint64_t whole[AFTER], part[AFTER];

    for (size_t i = 0; i < sizeof ways / sizeof *ways; i++) {
        char text[2048];
        snprintf(text, sizeof text,
                 "one({ music = 'deep' }, phase('a', 60))\n"
                 "local function more(name, t, ...) t.title, t.kind, t.x, t.y, t.phases = 'B', 'e', 9, 9, { ... }\n"
                 "  boss.def(name, t) end\n"
                 "more('c', { music = 'deep', warning = 80 }, phase('a', 60)) more('d', {}, phase('a', 60))\n"
                 "stage.def('s', function() %s stage.mark('here') print('here') wait(forever) end)\n",
                 ways[i]);
        run_from(text, "s", whole);
        run_from(text, "s:here", part);
        for (int f = 0; f < AFTER; f++)
            if (whole[f] != part[f])
                fail_msg("%s: differs %d frames behind the mark", ways[i], f);
    }
}

/* A phase that is practised has its own music, or the boss's, from its first frame on, which follows the frame that
 * looks for the boss in the stages; what the phase before had too plays while the boss flies in. */
TEST(phases)
{
    static const struct {
        const char *script, *section, *changes;
    } tries[] = {
        { "one({ music = 'tide' }, phase('a', 90, { music = 'deep' }))", "b/a", "0 tide 3, 61 deep 2" },
        { "one({ music = 'tide' }, phase('a', 90, { music = 'deep' }), phase('c', 90, { music = 'deep' }))", "b/c",
          "0 tide 3, 1 deep 2" },
        { "one({ music = 'tide' }, phase('a', 90), phase('c', 90, { music = 'deep' }))", "b/c", "0 tide 3, 61 deep 2" },
        { "one({ music = 'tide' }, phase('a', 90, { music = 'deep' }), phase('c', 90))", "b/c", "0 tide 3" },
        { "one({ music = 'deep' }, phase('a', 90))", "s", "0 tide 3, 30 deep 2" },
    };

    for (size_t i = 0; i < sizeof tries / sizeof *tries; i++) {
        char text[1024];
        snprintf(text, sizeof text,
                 "%s stage.def('s', function() boss.fight('b') end, { music = 'tide' })\n"
                 "boot.run { stages = { 's' }, players = { 'ship' } }",
                 tries[i].script);
        power_from(text, tries[i].section);
        assert_string_equal(changes(140), tries[i].changes);
        rig_close(&rig);
    }
}

/* ---- pause and stop ---- */

/* After a pause every frame sounds as without it, but for the first, in which the music comes back. */
TEST(pause)
{
    enum { AT = 50, LENGTH = 20 };
    static uint64_t straight[200], paused[200];

    listen("music.play('tide')", straight, 200);
    listen("music.play('tide') local scope = task.scope()\n"
           "task.own(scope, function() wait(50) sys.freeze(scope) wait(20) sys.freeze() end)",
           paused, 200);
    for (int f = 0; f < 200 - LENGTH; f++)
        if (f != AT && straight[f] != paused[f < AT ? f : f + LENGTH])
            fail_msg("frame %d sounds otherwise", f);
}

/* In a pause what is asked for waits, and cues sound. */
TEST(cue_in_pause)
{
    power(
        "music.play('tide') local scope = task.scope() task.own(scope, function() wait(9) sys.freeze(scope) wait(20)\n"
        "sound.play('hit') music.play('deep') wait(20) sys.freeze() end)");
    rig_run(&rig, 29);
    assert_int_equal(rig_loudest(rig.b), 0);
    rig_run(&rig, 1);
    assert_true(rig_loudest(rig.b) > 300);
    assert_string_equal(name_now(), "deep");
    assert_true(rig.b->music.pos == 0);
    rig_run(&rig, 20);
    assert_true(rig.b->music.pos > 0);
    rig_close(&rig);
}

/* Through a hit-stop it runs on. */
TEST(stop)
{
    static uint64_t straight[100], stopped[100];

    listen("music.play('tide')", straight, 100);
    listen("music.play('tide') task.go(function() wait(20) board.stop(30) end)", stopped, 100);
    assert_memory_equal(straight, stopped, sizeof straight);
}

/* ---- the music room ---- */

static void press(uint16_t button)
{
    const uint16_t down[MAX_PLAYERS] = { button, 0 };

    rig_tick(&rig, down);
    rig_run(&rig, 3);
}

/* A game at its title, which the music room is opened from. */
static void open_room(const char *music)
{
    char text[400];

    snprintf(text, sizeof text,
             "stage.def('s', function() end) unlock.def('tired', { when = { heard = 'tide' } })\n"
             "boot.run { stages = { 's' }, players = { 'ship' }, music = %s }",
             music);
    power(text);
    rig_run(&rig, 5);
    press(PAD_START);
    for (int i = 0; i < 5; i++)
        press(PAD_DOWN); /* past "2 Players", "Practice", "Replays" and "Scores" */
    press(PAD_FIRE);
    rig_run(&rig, 20);
}

/* Each piece plays over the title's, which comes back at the end. */
TEST(room)
{
    open_room("{ title = 'tide', room = true }");
    press(PAD_FIRE); /* "deep" comes first, as in rom.lua */
    assert_string_equal(name_now(), "deep");
    assert_int_equal(rig.b->music.suspended_count, 1);
    press(PAD_DOWN);
    press(PAD_FIRE);
    assert_string_equal(name_now(), "tide");
    assert_int_equal(rig.b->music.suspended_count, 0);
    press(PAD_UP);
    press(PAD_FIRE);
    assert_string_equal(name_now(), "deep");
    press(PAD_BOMB);
    rig_run(&rig, 40);
    assert_string_equal(name_now(), "tide");
    rig_close(&rig);
}

/* A piece that is not unlocked does not play. */
TEST(closed_room)
{
    open_room("{ { name = 'tide', text = 'First' }, { name = 'deep', title = 'Down', needs = 'tired' } }");
    press(PAD_DOWN);
    press(PAD_FIRE);
    assert_string_equal(name_now(), "-");
    press(PAD_UP);
    press(PAD_FIRE);
    assert_string_equal(name_now(), "tide");
    rig_close(&rig);
}

/* ---- sounds that play by themselves ---- */

static const char scene[] = "bullet.def('orb', { sprite = 'dot', hit = { circle = 3 } })\n"
                            "shot.def('dart', { sprite = 'dot', hit = { circle = 4 }, damage = 5 })\n"
                            "item.def('coin', { sprite = 'dot', radius = 4, gives = { score = 10 } })\n"
                            "bomb.def('wave', { over = 20, run = function() end })\n"
                            "player.def('pilot', { sprite = 'dot', hit = { circle = 2 }, bomb = 'wave', lives = 9, "
                            "registers = { bombs = 3 } })\n"
                            "sys.join(1, 'pilot')\n"
                            "local p = player.get(1)\n"
                            "local function at(n, f) task.go(function() wait(n) p.safe = 0 f() end) end\n"
                            "local e = enemy.spawn { kind = 'e', x = 100, y = 50 }\n"
                            "one({ warning = 20 }, phase('a', 30, { spell = 'Spell', time = 300, bonus = 9 }))\n";

#define BOOTED                                                                                                         \
    "sys.leave(1) stage.def('s', function() wait(forever) end)\n"                                                      \
    "boot.run { stages = { 's' }, players = { 'pilot' }, screens = { title = function() return 'start', 1 end } }"

#define MISSION(goal)                                                                                                  \
    "sys.leave(1) stage.def('s', function() wait(forever) end)\n"                                                      \
    "mission.def('m', { title = 'M', stage = 's', goal = function() return " goal " end, limit = 9 })\n"               \
    "boot.run { stages = { 's' }, players = { 'pilot' }, screens = {\n"                                                \
    "  title = function() return 'missions' end, missions = function() return 'm' end } }"

static const struct {
    const char *name, *script;
} deeds[CART_CUES] = {
    { "shot", "at(5, function() shot.fire { kind = 'dart', from = p, dy = -8, speed = 4 } end)" },
    { "hit", "at(5, function() bullet.fire { kind = 'orb', from = p, speed = 0 } end)" },
    { "graze", "at(5, function() bullet.fire { kind = 'orb', from = p, dx = 12, speed = 0 } end)" },
    { "kill", "at(5, function() shot.fire { kind = 'dart', x = 100, y = 50, speed = 0 } end)" },
    { "item", "at(5, function() item.drop { kind = 'coin', from = p } end)" },
    { "bomb", "at(5, function() p:bomb() end)" },
    { "warning", "at(5, function() boss.fight('b') end)" },
    { "menu", "task.go(function() menu.choose { items = { 'A', 'B' }, row = 3 } end)" },
    { "extend", "at(5, function() score.add(900, p) end)" },
    { "spell", "at(5, function() boss.fight('b') end)" },
    { "bonus", "at(5, function() boss.fight('b') end)" },
    { "time", "hud.start(task.scope(), 1) at(5, function() boss.fight('b') end)" },
    { "select", "task.go(function() menu.choose { items = { 'A', 'B' }, row = 3 } end)" },
    { "back", "task.go(function() while true do menu.choose { items = { 'A' }, row = 3, back = 1 } end end)" },
    { "wrong", "task.go(function() sys.read('menu/page').list { items = { 'A' }, row = 3, closed = { true } } end)" },
    { "pause", NULL }, /* not of the board: for the program's pause menu */
    { "continue", "sys.leave(1) player.def('solo', { sprite = 'dot', hit = { circle = 2 }, lives = 1 })\n"
                  "stage.def('s', function() while true do player.each(function(q) q.safe = 0\n"
                  "  bullet.fire { kind = 'orb', from = q, speed = 0 } end) wait(5) end end)\n"
                  "boot.run { stages = { 's' }, players = { 'solo' }, continues = 3, screens = {\n"
                  "  title = function() return 'start', 1 end, continue = function() return true end } }" },
    { "mission", MISSION("true") },
    { "failed", MISSION("false") },
};

/* A game with one sound, of that name. */
static void power_sound(const char *name, const char *script)
{
    const struct mml_settings settings = { .volume = 255, .priority = 4, .limit = 2, .title = "" };
    struct manifest m = rig_manifest();
    static char text[1 << 13], lump[64], err[256];
    uint8_t *made;
    size_t size;

    m.has_sound = 1;
    m.items = 8;
    m.extends[0] = 500;
    m.n_extends = 1;
    snprintf(text, sizeof text, "%s%s%s", ship, scene, script);
    snprintf(lump, sizeof lump, "sound/%s", name);
    rig_with_sys(&game, &m, text);
    assert_true(mml_compile("t200 @noise o6 c8", 17, name, &settings, &made, &size, err, sizeof err));
    rig_lump(&game, lump, made, size);
    free(made);
    rig_power(&rig, &game, NULL);
}

/* How often a sound began in so many frames, in which first DOWN is pressed, then FIRE, BOMB and START. */
static int begun(int frames, bool presses_any)
{
    int n = 0;

    for (int f = 0; f < frames; f++) {
        static const uint16_t presses[] = { PAD_DOWN, PAD_FIRE, PAD_BOMB, PAD_START };
        const uint16_t pads[MAX_PLAYERS] = { f % 2 && presses_any ? presses[f / 4 % 4] : 0, 0 };
        rig_tick(&rig, pads);
        for (int i = 0; i < CUE_SLOTS; i++)
            n += rig.b->cues.tune[i] && rig.b->cues.start_frame[i] + 1 == rig.b->core.frame;
    }
    return n;
}

/* Each plays in a game that names it, alone; in a game of another sound none does. */
TEST(cues)
{
    for (int i = 0; i < CART_CUES; i++) {
        assert_string_equal(deeds[i].name, cart_cue_names[i]);
        if (!deeds[i].script)
            continue;
        power_sound(deeds[i].name, deeds[i].script);
        for (int k = 0; k < CART_CUES; k++)
            assert_true((rig.b->cart.cue_offset[k] != 0) == (k == i));
        const int n = begun(200, true);
        if (n == 0)
            fail_msg("no sound of \"%s\"", deeds[i].name);
        rig_close(&rig);
        power_sound("other", deeds[i].script);
        if (begun(200, true) != 0)
            fail_msg("a sound that is not \"%s\"", deeds[i].name);
        rig_close(&rig);
    }
}

/* Grazes in every frame are heard in every fourth. */
TEST(apart)
{
    power_sound("graze", "task.go(function() while true do p.safe = 0\n"
                         "bullet.fire { kind = 'orb', from = p, dx = 12, speed = 0 } wait(1) end end)");
    assert_int_equal(begun(41, false), 11);
    assert_true(rig.b->player.grazes[0] > 30);
    rig_close(&rig);
}

/* One in the very first frames is heard, though none was before. */
TEST(first)
{
    power_sound("graze", "");
    rig.b->core.frame = 2;
    sound_play_cue(rig.b, CUE_GRAZE, 0);
    assert_true(rig.b->cues.tune[0] != 0);
    rig_close(&rig);
}

/* A slot tells what plays in it, which frame is its last, and nothing of what is no sound. */
TEST(slots)
{
    struct board_cue cue = { 0 };
    int lasts = 0, frames = 0;

    power("sound.play('hit')");
    for (; rig_run(&rig, 1), board_get_cue(rig.b, 0, &cue) && cue.name; frames++) {
        assert_string_equal(cue.name, "hit");
        assert_int_equal(lasts, 0);
        lasts += cue.ends_next_frame;
    }
    assert_true(frames > 1 && lasts == 1);
    rig.b->cues.tune[0] = 1; /* no sound begins there */
    assert_true(board_get_cue(rig.b, 0, &cue) && cue.name == NULL);
    rig_close(&rig);
}

/* Of two fades, both as long as a warning may be, the second goes on from where the first was. */
TEST(long_fades)
{
    power("music.play('tide')");
    rig_run(&rig, 2);
    sound_stop_music(rig.b, 65535);
    rig.b->music.fade_frames_left = 50000;
    sound_start_music(rig.b, cart_find(&rig.b->cart, CART_TUNES, "deep"), &(struct music_options){ .fade = 40000 });
    assert_int_equal(rig.b->music.fade_frames_left, 40000);
    assert_int_equal(rig.b->music.fade_length, 52428);
    rig_close(&rig);
}

/* ---- voices of a talk ---- */

static int voices_of(const char *line, int frames)
{
    char text[512];
    int n;

    snprintf(text, sizeof text,
             "talk.def('iri', { name = 'IRI', voice = 'hit' }) talk.def('sen', { name = 'SEN', side = 'right' })\n"
             "task.go(function() wait(2) %s end)",
             line);
    power(text);
    n = begun(frames, false);
    rig_close(&rig);
    return n;
}

TEST(voices)
{
    assert_int_equal(voices_of("say('sen', 'ABCDEFGH')", 60), 0);
    assert_int_equal(voices_of("say('iri', 'ABCDEFGH', { letter = 4 })", 60), 8);
    assert_int_equal(voices_of("say('iri', 'ABCD EFGH')", 60), 4);
    assert_int_equal(voices_of("say('iri', 'ABCDEFGH', { letter = 0 })", 60), 1);
    assert_int_equal(voices_of("say('sen', 'ABCDEFGH', { voice = 'bell' })", 60), 1);
}

RUN_TESTS(rig_make_sound_tables, NULL)
