/*
 * test_music.c - which piece plays when: what is put aside and goes on, switches at a bar, bosses, stages, screens,
 * pauses and ways to a mark; and the sounds that play by themselves. The pieces are those of rig_sounds: "tide" never
 * ends, "deep" does.
 */
#include "rig.h"
#include "../../src/board/sound.h"

static struct snd_tables tables;
static struct rig_game game;
static struct rig rig;

static int make_tables(void **state)
{
    (void)state;
    board_sound_open(&tables);
    return 0;
}

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

    m.sound = 1;
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

static void done(void)
{
    rig_free(&rig);
    rig_game_free(&game);
}

static uint64_t heard(const struct board *b)
{
    int16_t sound[2 * BOARD_SOUND];

    board_sound(b, &tables, sound);
    return hash_bytes(HASH_START, sound, sizeof sound);
}

static int loudest(const struct board *b)
{
    int16_t sound[2 * BOARD_SOUND];
    int most = 0;

    board_sound(b, &tables, sound);
    for (int i = 0; i < 2 * BOARD_SOUND; i++)
        most = abs(sound[i]) > most ? abs(sound[i]) : most;
    return most;
}

/* ---- what plays ---- */

static const char *name_now(void)
{
    const uint16_t tune = rig.b->music.tune;

    return tune ? cart_tune_name(&rig.b->cart, tune - 1) : "-";
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
    { "music.play('tide')", "0 tide 3", 99 },
    { "music.play('tide') music.play('deep')", "0 deep 2", 40 },
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
      "music.stop() end)",
      "0 tide 3, 20 deep 2, 50 - 0", 300 },
    { "music.play('tide') task.go(function() wait(20) music.play('deep', { back = true }) wait(30)\n"
      "music.stop { fade = 20 } end)",
      "0 tide 3, 20 deep 2, 70 - 0", 300 },
    /* a fade that is forgotten in its first frame; one that another takes over */
    { "music.play('tide') task.go(function() wait(20) music.stop { fade = 60 } music.play('tide') end)", "0 tide 3", 200 },
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
    { "music.play('tide') task.go(function() wait(20) music.play('deep', { at = 'bar' }) wait(9) music.play('tide') end)",
      "0 tide 3", 200 },
    { "music.play('deep', { at = 'bar' })", "0 deep 2", 40 },
    /* three deep, and one more, which loses what it covers */
    { "music.play('tide') task.go(function() for _ = 1, 4 do wait(10) music.play('deep', { back = true, again = true }) "
      "end end)",
      "0 tide 3, 10 deep 2, 20 deep 2, 30 deep 2, 40 deep 2, 201 deep 27, 352 deep 27, 503 tide 40", 600 },
    /* a boss's, and a phase's over it: the ways in and out are 60 frames */
    { "music.play('tide') one({ music = 'deep' }, phase('a', 20)) task.go(function() wait(20) boss.fight('b') end)",
      "0 tide 3, 50 deep 2, 161 tide 178", 400 },
    { "music.play('tide') one({ music = 'deep', warning = 50 }, phase('a', 20))\n"
      "task.go(function() wait(20) boss.fight('b') end)",
      "0 tide 3, 70 deep 2, 211 tide 232", 400 },
    { "music.play('tide') one({ music = 'tide' }, phase('a', 20)) task.go(function() wait(20) boss.fight('b') end)",
      "0 tide 3", 300 },
    { "music.play('tide') one({}, phase('a', 80, { music = 'deep' }), phase('b', 80, { music = 'deep' }), phase('c', 9))\n"
      "task.go(function() wait(20) boss.fight('b') end)",
      "0 tide 3, 110 deep 2", 260 },
    { "music.play('tide') one({}, phase('a', 80, { music = 'deep' }), phase('c', 99))\n"
      "task.go(function() wait(20) boss.fight('b') end)",
      "0 tide 3, 110 deep 2, 221 tide 339", 400 },
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
        done();
    }
    return failed;
}

static void test_stories(void **state)
{
    (void)state;
    assert_int_equal(tell(stories, sizeof stories / sizeof *stories), 0);
}

/* With RAM spoilt after each frame, and put back twice from ten frames before, it sounds the same. */
static void test_restored(void **state)
{
    static uint64_t straight[300], hashes[300];

    (void)state;
    for (size_t i = 0; i < sizeof stories / sizeof *stories; i += 3) {
        power(stories[i].script);
        for (int f = 0; f < 300; f++) {
            rig_run(&rig, 1);
            straight[f] = heard(rig.b);
            hashes[f] = board_hash(rig.b);
        }
        done();
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
        done();
    }
}

/* ---- screens ---- */

#define GAME                                                                                                           \
    "stage.def('s', function() wait(200) end, { music = 'deep' })\n"                                                   \
    "local function stands(n, ...) local t = { ... } return function() wait(n) return table.unpack(t) end end\n"       \
    "local function run(music, t) t.title = t.title or stands(30, 'start', 1) t.results = stands(150)\n"               \
    "  t.ending, t.staff, t.name, t.scores = stands(50), stands(50), stands(50, { 'A' }), stands(50)\n"                \
    "  boot.run { stages = { 's' }, players = { 'ship' }, music = music, screens = t, staff = {} } end\n"

static const struct story screens[] = {
    { GAME "run(nil, {})", "30 deep 2, 191 - 0, 691 deep 2", 750 },
    /* the title's goes on until the game begins */
    { GAME "run({ title = 'tide' }, {})", "0 tide 3, 30 deep 2, 191 - 0, 661 tide 3, 691 deep 2", 750 },
    /* results end when the last words begin, and both have the same */
    { GAME "run({ title = 'tide', results = 'tide', over = 'deep', clear = 'tide' }, {})",
      "0 tide 3, 30 deep 2, 191 - 0, 231 tide 3, 621 - 0, 661 tide 3", 690 },
    { GAME "run({ ending = 'deep', staff = 'deep' }, {})", "30 deep 2, 191 - 0, 561 deep 2", 690 },
    { GAME "run({ ending = 'deep', staff = 'tide' }, { ending = stands(50) })",
      "30 deep 2, 191 - 0, 561 deep 2, 641 tide 3", 690 },
    /* the last life goes in frame 130 */
    { GAME "bullet.def('o', { sprite = 'dot', hit = { circle = 3 } })\n"
           "on.stage(function() task.go(function() wait(99) local p = player.get(1) p.safe = 0\n"
           "  bullet.fire { kind = 'o', from = p, speed = 0 } score.add(9) end) end)\n"
           "run({ over = 'tide', name = 'deep' }, {})",
      "30 deep 2, 161 tide 3, 341 deep 2, 391 - 0", 420 },
};

static void test_screens(void **state)
{
    (void)state;
    assert_int_equal(tell(screens, sizeof screens / sizeof *screens), 0);
}

/* ---- ways to a mark ---- */

/* Runs until the game prints something; false: it does not in so many frames. */
static bool until_told(int frames)
{
    const uint16_t none[PADS] = { 0 };

    for (int f = 0; f < frames; f++) {
        rig_tick(&rig, none);
        if (board_last(rig.b)->log_size > 0)
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
        out[f] = hash_fold(hash_fold(heard(rig.b), s->pos), s->tune + 100u * s->mark + 10000u * s->aside);
        rig_run(&rig, 1);
    }
    done();
}

/* A stage that waits and whose clock is waited for, in a practice start of the stage and of its mark. */
static void test_marks(void **state)
{
    static const char *const ways[] = {
        "music.play('tide') stage.at(200)",
        "wait(30) music.play('tide') wait(25) stage.at(100) wait(7)",
        "music.play('tide') stage.at(150) music.play('deep', { fade = 40 }) stage.at(170)",
        "music.play('tide') stage.at(150) music.play('deep', { fade = 40 }) wait(39) music.stop { fade = 20 } wait(10)",
        "music.play('tide') wait(31) music.play('deep', { back = true }) stage.at(350)",
        "music.play('tide') stage.at(20) music.play('deep', { at = 'bar' }) stage.at(140)",
        "music.play('tide') music.wait(5) stage.at(190) music.wait('drop')",
        "music.play('tide') music.volume(0.25, 90) stage.at(60)",
        "music.wait(3) music.play('tide') stage.at(100)",
        "music.play('tide') stage.at(90) boss.fight('b') stage.at(151)",
        "music.play('tide') stage.at(90) boss.fight('b') stage.at(190)",
        "music.play('tide') stage.at(90) boss.fight('c') wait(70)",
        "stage.at(90) music.play('deep') boss.fight('d') music.play('tide', { fade = 60 }) stage.at(160)",
    };
    static uint64_t whole[AFTER], part[AFTER];

    (void)state;
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

/* ---- pause and stop ---- */

/* After a pause every frame sounds as without it, but for the first, in which the music comes back. */
static void test_pause(void **state)
{
    static uint64_t straight[200], paused[200];
    static const char held[] = "music.play('tide') local scope = task.scope()\n"
                               "task.own(scope, function() wait(50) sys.freeze(scope) wait(%d) sys.freeze() end)\n";

    (void)state;
    power("music.play('tide')");
    for (int f = 0; f < 200; f++) {
        rig_run(&rig, 1);
        straight[f] = heard(rig.b);
    }
    done();
    for (int n = 1; n < 40; n += 19) {
        char text[256];
        snprintf(text, sizeof text, held, n);
        power(text);
        for (int f = 0; f < 200; f++) {
            rig_run(&rig, 1);
            paused[f] = heard(rig.b);
            if (f > 50 && f < 50 + n)
                assert_int_equal(loudest(rig.b), 0);
        }
        for (int f = 0; f < 200 - n; f++)
            if (straight[f] != paused[f < 50 ? f : f + n] && f != 50)
                fail_msg("a pause of %d frames: frame %d sounds otherwise", n, f);
        done();
    }
}

/* In a pause what is asked for waits, and cues sound. */
static void test_cue_in_pause(void **state)
{
    (void)state;
    power("music.play('tide') local scope = task.scope() task.own(scope, function() wait(9) sys.freeze(scope) wait(20)\n"
          "sound.play('hit') music.play('deep') wait(20) sys.freeze() end)");
    rig_run(&rig, 29);
    assert_int_equal(loudest(rig.b), 0);
    rig_run(&rig, 1);
    assert_true(loudest(rig.b) > 300);
    assert_string_equal(name_now(), "deep");
    assert_true(rig.b->music.pos == 0);
    rig_run(&rig, 20);
    assert_true(rig.b->music.pos > 0);
    done();
}

/* Through a hit-stop it runs on. */
static void test_stop(void **state)
{
    static uint64_t straight[100];

    (void)state;
    power("music.play('tide')");
    for (int f = 0; f < 100; f++) {
        rig_run(&rig, 1);
        straight[f] = heard(rig.b);
    }
    done();
    power("music.play('tide') task.go(function() wait(20) board.stop(30) end)");
    for (int f = 0; f < 100; f++) {
        rig_run(&rig, 1);
        assert_true(heard(rig.b) == straight[f]);
    }
    done();
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_stories),
        cmocka_unit_test(test_restored),
        cmocka_unit_test(test_screens),
        cmocka_unit_test(test_marks),
        cmocka_unit_test(test_pause),
        cmocka_unit_test(test_cue_in_pause),
        cmocka_unit_test(test_stop),
    };

    return cmocka_run_group_tests(tests, make_tables, NULL);
}
