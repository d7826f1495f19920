/*
 * test_sound.c - music, sounds and voices of whole boards: what scripts see, what plays by itself, and that hearing it
 * changes nothing, whichever frames are heard.
 */
#include "rig.h"

static struct rig_game game;
static struct rig rig;

static void power_with(void (*write)(struct rig_game *, const struct manifest *, const char *), const char *script)
{
    struct manifest m = rig_manifest();

    m.has_sound = 1;
    write(&game, &m, script);
    rig_sounds(&game);
    rig_power(&rig, &game, NULL);
}

static void power(const char *script)
{
    power_with(rig_script, script);
}

static uint64_t heard(uint64_t h, const struct board *b)
{
    int16_t sound[2 * BOARD_SOUND_FRAMES];

    board_mix_sound(b, &rig_sound_tables, sound);
    for (int i = 0; i < 2 * BOARD_SOUND_FRAMES; i++)
        h = hash_fold(h, (uint16_t)sound[i]);
    return h;
}

static const char much[] =
    "music.play('tide')\n"
    "task.go(function()\n"
    "  for i = 1, 30 do\n"
    "    wait(7)\n"
    "    sound.play(i % 3 == 0 and 'bell' or i % 2 == 0 and 'boom' or 'hit', { pan = i / 15 - 1, pitch = i % 5 })\n"
    "    if i == 20 then music.play('deep', { fade = 10 }) end\n"
    "  end\n"
    "end)\n";

enum { LONG = 300 };

/* Every frame heard, every third, backwards from snapshots, or none: the same samples, the same hashes. */
TEST(heard_or_not)
{
    static uint64_t sums[LONG], hashes[LONG];
    void *saved[LONG / 50];

    power(much);
    for (int f = 0; f < LONG; f++) {
        if (f % 50 == 0) {
            saved[f / 50] = malloc(board_snapshot_size(rig.b));
            board_save(rig.b, saved[f / 50]);
        }
        rig_run(&rig, 1);
        sums[f] = heard(0, rig.b);
        hashes[f] = board_hash(rig.b);
    }
    assert_true(sums[100] != sums[101]);
    for (int k = LONG / 50 - 1; k >= 0; k--) {
        memset(rig.ram, 0xa5, rig.ram_size);
        board_restore(rig.b, saved[k]);
        for (int f = 50 * k; f < 50 * k + 50; f++) {
            rig_run(&rig, 1);
            if (f % 3 == 0)
                assert_true(heard(0, rig.b) == sums[f]);
            assert_true(board_hash(rig.b) == hashes[f]);
        }
        free(saved[k]);
    }
    rig_close(&rig);
}

/* What a script comes to when it is heard so loud: a digest of the samples, and of the hashes. */
static uint64_t heard_at(const char *script, int music, int sounds, uint64_t *hashes, int *most)
{
    uint64_t h = 0;

    power(script);
    board_sound_set_levels(&rig_sound_tables, music, sounds);
    *most = 0;
    for (int f = 0; f < LONG; f++) {
        rig_run(&rig, 1);
        h = heard(h, rig.b);
        *hashes = hash_fold(*hashes, board_hash(rig.b));
        const int now = rig_loudest(rig.b);
        *most = now > *most ? now : *most;
    }
    board_sound_set_levels(&rig_sound_tables, 100, 100);
    rig_close(&rig);
    return h;
}

/* Who listens without music hears the sounds alone, to the bit, and the other way round; no hash knows of it. */
TEST(levels)
{
    static const char sounds[] = "task.go(function() for i = 1, 30 do wait(7)\n"
                                 "sound.play(i % 3 == 0 and 'bell' or i % 2 == 0 and 'boom' or 'hit',\n"
                                 "{ pan = i / 15 - 1, pitch = i % 5 }) end end)",
                      music[] = "music.play('tide')\n"
                                "task.go(function() wait(140) music.play('deep', { fade = 10 }) end)";
    uint64_t whole = 0, quiet = 0, none = 0;
    int full, half, silent, alone;

    const uint64_t all = heard_at(much, 100, 100, &whole, &full);
    if (all != 0x092b30cc153670afu) /* on every machine, with every compiler */
        fail_msg("the digest of the samples is 0x%016llx", (unsigned long long)all);
    assert_true(heard_at(much, 0, 100, &none, &alone) == heard_at(sounds, 100, 100, &quiet, &half));
    assert_true(none == whole && alone == half && alone > 0);
    assert_true(heard_at(much, 100, 0, &none, &alone) == heard_at(music, 100, 100, &quiet, &half));
    assert_true(alone == half && alone > 0);
    assert_true(heard_at(much, 50, 50, &none, &half) != all);
    assert_in_range(half, full * 2 / 5, full * 3 / 5);
    heard_at(much, 0, 0, &none, &silent);
    assert_int_equal(silent, 0);
    quiet = 0;
    heard_at(much, 30, 70, &quiet, &half);
    assert_true(quiet == whole);
}

/* What a script prints in 400 frames. */
static const char *said(const char *script)
{
    struct manifest m = rig_manifest();

    m.has_sound = 1;
    rig_script(&game, &m, script);
    rig_sounds(&game);
    const char *all = rig_said(&game, 400, false);
    rig_game_free(&game);
    return all;
}

TEST(script)
{
    assert_string_equal(said("task.go(function()\n"
                             "  print(music.name(), music.marker(), music.beat(), music.frames(4))\n"
                             "  music.play('tide')\n"
                             "  print(music.name(), music.frames(4))\n"
                             "  print(music.wait('drop'), music.marker(), board.frame())\n"
                             "  print(music.wait('back'), music.marker())\n"
                             "  print(music.wait(2))\n"
                             "  music.stop() print(music.name(), music.wait(), music.wait('none'))\n"
                             "end)\n"),
                        "nil\tnil\t0\t120\ntide\t108\n1\tdrop\t41\n4\tback\n6\nnil\t0\t0\n");
}

TEST(mistakes)
{
    static const char *const of[][2] = {
        { "sound.play('bom')", "sound.play: unknown sound \"bom\" (did you mean \"boom\"?)" },
        { "sound.play('boom', { volume = 2 })", "sound.play: volume: expected a number from 0 to 1, got 2" },
        { "music.stop(30)", "music.stop: expected a table of named arguments, got 30" },
        { "music.wait(1)", "music.wait: only a task can wait; start one with task.go" },
        { "music.play('tide') music.wait('drob')",
          "music.wait: \"tide\" has no marker \"drob\" (did you mean \"drop\"?)" },
        { "music.wait(0.5)", "music.wait: n: expected a whole number from 1 to 65536 beats, got 0.5" },
    };

    for (size_t i = 0; i < sizeof of / sizeof *of; i++)
        assert_string_equal(said(of[i][0]), of[i][1]);
}

static void play_hit(uint16_t volume)
{
    const struct cart *c = &rig.b->cart;

    sound_play(rig.b,
               &(struct cue){ cart_tune_offset(c, CART_SOUNDS, cart_find(c, CART_SOUNDS, "hit")), volume, 0, 0 });
}

static int cues_playing(void)
{
    int n = 0;

    for (int i = 0; i < CUE_SLOTS; i++)
        n += rig.b->cues.tune[i] != 0;
    return n;
}

/* A sound that is played several times in a frame sounds once, as loud as the loudest; at most as many as its limit
 * sound together. */
TEST(cues)
{
    power("");
    for (int i = 0; i < 3; i++)
        play_hit((uint16_t)(100 + i));
    assert_int_equal(cues_playing(), 1);
    assert_int_equal(rig.b->cues.cue_volume[0], 102);
    for (int i = 0; i < 3; i++) {
        rig_run(&rig, 1);
        play_hit(256);
    }
    assert_int_equal(cues_playing(), 2);
    rig_run(&rig, 200);
    assert_int_equal(cues_playing(), 0);
    for (int i = 0; i < VOICE_SLOTS; i++)
        assert_false(voices_is_busy(&rig.b->voices, i));
    assert_int_equal(rig_loudest(rig.b), 0);
    rig_close(&rig);
}

/* On the way to a mark nothing is waited for, and no sound is heard; what was asked last plays there. */
TEST(skipped)
{
    struct manifest m = rig_manifest();
    struct board_start start = { .seed = 1, .difficulty = -1, .practice.section = "s:here" };

    m.has_sound = 1;
    rig_script(&game, &m,
               "player.def('ship', { sprite = 'dot', hit = { circle = 1 } })\n"
               "stage.def('s', function()\n"
               "  music.play('deep')\n"
               "  sound.play('boom')\n"
               "  print(music.wait(8), music.wait())\n"
               "  music.play('tide')\n"
               "  stage.mark('here')\n"
               "  print(music.name(), music.beat())\n"
               "  wait(forever)\n"
               "end)\n"
               "boot.run { stages = { 's' }, players = { 'ship' } }");
    rig_sounds(&game);
    rig_power(&rig, &game, &start);
    for (int f = 0; f < 3; f++) {
        rig_run(&rig, 1);
        assert_int_equal(cues_playing(), 0);
    }
    assert_int_equal(rig.b->music.tune, cart_find(&rig.b->cart, CART_TUNES, "tide") + 1);
    rig_close(&rig);
}

/* A pause holds the music, where it is and how it sounds, and fades it within a frame; sounds go on. */
TEST(pause)
{
    power_with(rig_with_sys, "music.play('tide')\n"
                             "local sys, scope = string.sys, task.scope()\n"
                             "task.own(scope, function() wait(20) sys.freeze(scope) wait(30) sys.freeze() end)\n");
    rig_run(&rig, 20);
    assert_true(rig_loudest(rig.b) > 500);
    rig_run(&rig, 2);
    const uint64_t pos = rig.b->music.pos, phase = rig.b->voices.phase[1];
    assert_int_equal(rig_loudest(rig.b), 0);
    rig_run(&rig, 20);
    assert_true(rig.b->music.pos == pos && rig.b->voices.phase[1] == phase);
    assert_int_equal(rig_loudest(rig.b), 0);
    rig_run(&rig, 15);
    assert_true(rig.b->music.pos > pos && rig_loudest(rig.b) > 500);
    rig_close(&rig);
}

/* While a sound that ducks plays, music is half as loud; before and behind it as loud as ever, without a jump. */
TEST(duck)
{
    power("music.play('tide') task.go(function() wait(60) sound.play('siren') end)");
    rig_run(&rig, 60);
    assert_int_equal(rig.b->voices.gain1, VOICE_FULL_GAIN);
    for (int f = 0; f < 400; f++) {
        rig_run(&rig, 1);
        const int32_t gain = rig.b->voices.gain1, was = rig.b->voices.gain0;
        assert_true(abs(gain - was) <= VOICE_FULL_GAIN / 7 && (f < 239 ? gain <= was : gain >= was));
        if (f > 40 && f < 239)
            assert_int_equal(gain, VOICE_FULL_GAIN - VOICE_FULL_GAIN * 128 / 255);
    }
    assert_int_equal(rig.b->voices.gain1, VOICE_FULL_GAIN);
    rig_close(&rig);
}

TEST(fade)
{
    int before;

    power("music.play('tide') task.go(function() wait(60) music.stop { fade = 30 } end)");
    rig_run(&rig, 60);
    before = rig_loudest(rig.b);
    rig_run(&rig, 29);
    assert_true(rig_loudest(rig.b) < before / 4 && rig.b->music.tune);
    rig_run(&rig, 5);
    assert_int_equal(rig_loudest(rig.b), 0);
    assert_int_equal(rig.b->music.tune, 0);
    rig_close(&rig);
}

/* A game that declares none has none of it. */
TEST(none)
{
    rig_script(&game, NULL, "");
    rig_power(&rig, &game, NULL);
    rig_run(&rig, 3);
    assert_false(board_has_sound(rig.b));
    assert_int_equal(rig_loudest(rig.b), 0);
    for (int i = 0; i < PART_COUNT; i++)
        if (machine_parts[i].chip == &seq_chip || machine_parts[i].chip == &cues_chip ||
            machine_parts[i].chip == &voices_chip)
            assert_true(board_part_hash(rig.b, i) == 0);
    rig_close(&rig);
}

RUN_TESTS(rig_make_sound_tables, NULL)
