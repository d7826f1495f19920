/*
 * test_inspect.c - what a board shows of itself: known values of a known scene, and RAM that stays as it was.
 */
#include "rig.h"
#include "../../src/board/inspect.h"

/* The lines the tasks wait in are asked for below. */
static const char scene[] =
    "bullet.def('rice', { sprite = 'dot', hit = { circle = 2.5 } })\n"
    "bullet.def('brick', { sprite = 'dot', hit = { box = { 12, 6 } }, graze = false })\n"
    "bullet.def('mist', { sprite = 'dot', hit = 'none' })\n"
    "shot.def('bolt', { sprite = 'dot', hit = { circle = 3 } })\n"
    "enemy.def('wall', { sprite = 'dot', hp = 70, hit = { box = { 40, 20 } } })\n"
    "enemy.def('fly', { sprite = 'dot', hp = 5, hit = { circle = 8 }, touch = false })\n"
    "player.def('ship', { sprite = 'dot', hit = { circle = 2 }, graze = 16, safe = 0 })\n"
    "motion.def { name = 'swerve',\n"
    "  { wait = 5 }, { turn = 3, over = 30 }, { wait = 10 } }\n"
    "local function fires()\n"
    "  bullet.fire { kind = 'rice', x = 100.25, y = 50, dir = 90, speed = 0.5, tag = 'first', motion = 'swerve' }\n"
    "  shot.fire { kind = 'bolt', x = 30, y = 60, dir = 270, speed = 0, by = player.get(1) }\n"
    "  wait(1000)\n" /* 13 */
    "end\n"
    "task.go(function()\n"
    "  string.sys.join(1, 'ship')\n"
    "  player.get(1).x, player.get(1).y = 120, 200\n"
    "  local wall = enemy.spawn { kind = 'wall', x = 120, y = 40 }\n"
    "  enemy.spawn { kind = 'fly', x = 180, y = 40 }\n"
    "  bullet.fire { kind = 'brick', x = 60, y = 90, dir = 0, speed = 0 }\n"
    "  bullet.fire { kind = 'mist', x = 150, y = 90, dir = 0, speed = 0 }\n"
    "  bullet.fire { kind = 'rice', x = 125, y = 41, dir = 0, speed = 0 }\n"
    "  task.own(wall, fires)\n"
    "  task.scope()\n"
    "  for i = 1, 1000000 do rng.int(1, 6) wait(3) end\n" /* 25 */
    "end)\n"
    "task.go(function() wait(forever) end)\n" /* 27 */;

struct bed {
    struct rig_game g;
    struct rig r;
};

static int bed_open(void **state)
{
    struct bed *t = calloc(1, sizeof *t);
    struct manifest m = rig_manifest();

    m.field_x = 16;
    m.field_y = 8;
    m.field_w = m.screen_w - 32;
    m.field_h = m.screen_h - 16;
    rig_with_sys(&t->g, &m, scene);
    rig_power(&t->r, &t->g, NULL);
    *state = t;
    return 0;
}

static int bed_close(void **state)
{
    struct bed *t = *state;

    rig_free(&t->r);
    rig_game_free(&t->g);
    free(t);
    return 0;
}

struct list {
    struct inspect_body body[64];
    int n;
};

static void add(void *context, const struct inspect_body *body)
{
    struct list *l = context;

    assert_true(l->n < 64);
    l->body[l->n++] = *body;
}

#define PX(v) ((int32_t)((v)*65536))

TEST(shapes_are_those_of_the_tests)
{
    struct bed *t = *state;
    struct list l = { 0 };

    rig_run(&t->r, 1);
    inspect_bodies(t->r.b, add, &l);
    assert_int_equal(l.n, 8);
    /* a task that is started in its turn comes after those of before: fires() has slot 3 */
    const struct inspect_body *brick = &l.body[3], *mist = &l.body[4], *still = &l.body[5], *rice = &l.body[6];
    assert_true(brick->kind == INSPECT_BULLET && brick->shape == INSPECT_BOX && brick->is_dimmed);
    assert_true(brick->a == PX(6) && brick->b == PX(3) && brick->x == PX(76) && brick->y == PX(98));
    assert_true(mist->shape == INSPECT_NO_SHAPE && mist->a == 0);
    assert_true(still->shape == INSPECT_CIRCLE && still->a == PX(2.5) && !still->is_dimmed);
    assert_true(rice->x == PX(116.25) && rice->y == PX(58.5) && rice->slot == 3);
    assert_true(l.body[2].kind == INSPECT_SHOT && l.body[2].a == PX(3) && l.body[2].x == PX(46));
    assert_true(l.body[0].kind == INSPECT_ENEMY && l.body[0].shape == INSPECT_BOX && l.body[0].a == PX(20));
    assert_true(l.body[1].kind == INSPECT_ENEMY && l.body[1].shape == INSPECT_CIRCLE && l.body[1].is_dimmed);
    assert_false(l.body[0].is_dimmed);
    assert_true(l.body[7].kind == INSPECT_PLAYER && l.body[7].a == PX(2) && l.body[7].graze == PX(16));
    struct inspect_area f = inspect_field(t->r.b);
    assert_true(f.x == 16 && f.y == 8 && f.w == t->g.cart.manifest.field_w && f.h == t->g.cart.manifest.field_h);
}

/* A capsule lies along the bullet's dir; what is beside it is not under the mouse. */
TEST(capsules_lie_as_they_fly)
{
    struct inspect_entity thing;
    struct rig_game g;
    struct rig r;
    struct list l = { 0 };

    rig_script(&g, NULL,
               "bullet.def('pin', { sprite = 'dot', hit = { capsule = { 40, 3 } } })\n"
               "bullet.fire { kind = 'pin', x = 50, y = 60, dir = 0, speed = 0 }\n"
               "bullet.fire { kind = 'pin', x = 150, y = 60, dir = 90, speed = 0 }\n"
               "bullet.def('duo', { sprite = 'dot', hit = { circles = { { 0, 0, 1 }, { 10, 0, 3 } } },\n"
               "  turns = true })\n"
               "bullet.fire { kind = 'duo', x = 150, y = 150, dir = 90, speed = 0 }\n");
    rig_power(&r, &g, NULL);
    rig_run(&r, 1);
    inspect_bodies(r.b, add, &l);
    assert_int_equal(l.n, 3);
    assert_true(l.body[2].shape == INSPECT_CIRCLES && l.body[2].n == 2 && l.body[2].a == PX(3));
    assert_true(l.body[2].b == PX(13) && l.body[2].circle[1].y == PX(160) && l.body[2].circle[1].r == PX(3));
    assert_true(l.body[0].shape == INSPECT_CAPSULE && l.body[0].a == PX(3));
    assert_true(l.body[0].b == PX(20) && l.body[0].c == 0 && l.body[1].b == 0 && l.body[1].c == PX(20));
    assert_true(inspect_entity_at(r.b, 72, 60, 0, &thing) && thing.body.slot == 0);
    assert_true(inspect_entity_at(r.b, 150, 82, 0, &thing) && thing.body.slot == 1);
    assert_true(inspect_entity_at(r.b, 150, 161, 0, &thing) && thing.body.slot == 2);
    assert_false(inspect_entity_at(r.b, 50, 66, 0, &thing));
    rig_close(&r);
}

static const struct inspect_gauge *gauge(const struct inspect_gauge *g, int n, const char *name)
{
    for (int i = 0; i < n; i++)
        if (!strcmp(g[i].name, name))
            return &g[i];
    fail_msg("no gauge %s", name);
    return NULL;
}

TEST(gauges_show_how_full_it_is)
{
    struct bed *t = *state;
    struct inspect_gauge g[MAX_PARTS];
    size_t used, size;

    rig_run(&t->r, 1);
    int n = inspect_gauges(t->r.b, g);
    assert_int_equal(n, board_part_count(t->r.b));
    const struct inspect_gauge *bullets = gauge(g, n, "bullets"), *kinds = gauge(g, n, "bullet_kinds");
    assert_true(bullets->live == 4 && bullets->top == 64 && bullets->high == 64 && bullets->cap == 256);
    assert_true(bullets->refused == 0 && !bullets->is_fixed);
    assert_true(kinds->live == 3 && kinds->top == 3 && kinds->cap == 1024 && !kinds->is_fixed);
    assert_true(gauge(g, n, "pal")->is_fixed && gauge(g, n, "script")->is_fixed && !gauge(g, n, "tasks")->is_fixed);
    inspect_memory(t->r.b, &used, &size);
    assert_true(size == 1024 * 1024 && used > 20000 && used < size);
}

/* Every number a script takes counts, and going back takes them back. */
TEST(numbers_drawn_are_counted)
{
    struct bed *t = *state;

    assert_true(inspect_random_draws(t->r.b) == 0);
    rig_run(&t->r, 1);
    assert_true(inspect_random_draws(t->r.b) == 1);
    rig_run(&t->r, 2);
    assert_true(inspect_random_draws(t->r.b) == 1);
    rig_save(&t->r);
    rig_run(&t->r, 4);
    assert_true(inspect_random_draws(t->r.b) == 3);
    rig_restore(&t->r);
    assert_true(inspect_random_draws(t->r.b) == 1);
}

TEST(tasks_say_where_they_wait)
{
    struct bed *t = *state;
    struct inspect_task k[8];

    assert_int_equal(inspect_tasks(t->r.b, 0, k, 8), 2);
    assert_true(!k[0].has_begun && k[0].location[0] == 0 && k[0].serial == 1 && k[0].wait == 1);
    rig_run(&t->r, 1);
    assert_int_equal(inspect_tasks(t->r.b, 0, k, 8), 4);
    assert_string_equal(k[0].location, "main.lua:25");
    assert_true(k[0].has_begun && k[0].wait == 3 && !k[0].waits_forever && k[0].owner == OWNER_BOARD);
    assert_string_equal(k[1].location, "main.lua:27");
    assert_true(k[1].waits_forever);
    assert_string_equal(k[2].location, "main.lua:13");
    assert_true(k[2].owner == OWNER_ENEMY && k[2].owner_number == 0 && k[2].wait == 1000 && k[2].age == 1);
    assert_true(k[3].is_scope && k[3].location[0] == 0 && k[3].serial == 4 && k[3].owner == OWNER_BOARD);
    rig_run(&t->r, 1);
    assert_int_equal(inspect_tasks(t->r.b, 2, k, 1), 4);
    assert_true(k[0].serial == 3 && k[0].wait == 999 && k[0].age == 2 && !k[0].is_stopped && !k[0].is_frozen);
    assert_true(inspect_task(t->r.b, 4, k) && k[0].is_scope);
    assert_false(inspect_task(t->r.b, 5, k));
    assert_false(inspect_task(t->r.b, 0, k));
}

/* A pause freezes what is not of it. */
TEST(frozen_and_stopped_tasks)
{
    struct inspect_task k[4];
    struct rig_game game;
    struct rig r;

    rig_with_sys(&game, NULL,
                 "local t = task.go(function() wait(forever) end)\n"
                 "task.own(t, function() wait(forever) end)\n"
                 "task.go(function() wait(2) string.sys.freeze(task.scope()) wait(1) end)\n"
                 "on.kill(print)\n");
    rig_power(&r, &game, NULL);
    rig_run(&r, 3);
    assert_true(inspect_tasks(r.b, 0, k, 4) >= 3);
    assert_true(k[0].is_frozen && k[1].is_frozen && k[1].owner == OWNER_TASK && k[1].owner_number == k[0].serial);
    rig_close(&r);
}

TEST(what_is_under_a_point)
{
    struct bed *t = *state;
    struct inspect_entity at;

    rig_run(&t->r, 11); /* the rice turns: 6 frames went, of 30 */
    assert_true(inspect_entity_at(t->r.b, 116, 63, 6, &at));
    assert_true(at.body.kind == INSPECT_BULLET && at.body.slot == 3);
    assert_string_equal(at.name, "rice");
    assert_string_equal(at.tag, "first");
    assert_int_equal(at.age, 11);
    assert_true(at.x == at.body.x - PX(16) && at.y == at.body.y - PX(8) && at.speed == PX(0.5));
    assert_true(at.has_motion && at.step == 2 && at.step_count == 3 && at.frames_left == 30 - 6);
    assert_true(at.dir > 107.9 && at.dir < 108.1);
    assert_string_equal(at.motion, "swerve");
    assert_int_equal(at.owner_task, 3);

    assert_true(inspect_entity_at(t->r.b, 141, 49, 6, &at)); /* a bullet in front of a wall: the smaller of the two */
    assert_true(at.body.kind == INSPECT_BULLET && at.body.slot == 2 && !at.tag && !at.has_motion && at.owner_task == 1);
    assert_true(inspect_entity_at(t->r.b, 120, 50, 6, &at));
    assert_true(at.body.kind == INSPECT_ENEMY && at.hp == 70 && at.safe_left == 0 && at.owner_task == 1);
    assert_string_equal(at.name, "wall");
    assert_true(inspect_entity_at(t->r.b, 46, 68, 0, &at));
    assert_true(at.body.kind == INSPECT_SHOT && at.player == 1);
    assert_string_equal(at.name, "bolt");
    assert_true(inspect_entity_at(t->r.b, 136, 208, 0, &at));
    assert_true(at.body.kind == INSPECT_PLAYER);
    assert_string_equal(at.name, "ship");
    assert_true(inspect_entity_at(t->r.b, 166 + 4, 98, 6, &at)); /* a mist has no shape: near it is enough */
    assert_string_equal(at.name, "mist");
    assert_false(inspect_entity_at(t->r.b, 166 + 9, 98, 6, &at));
    assert_false(inspect_entity_at(t->r.b, 20, 280, 6, &at));
}

/* ---- nothing changes ---- */

static void ignore(void *context, const struct inspect_body *body)
{
    (void)context, (void)body;
}

static void ask_everything(const struct board *b)
{
    struct inspect_gauge g[MAX_PARTS];
    struct inspect_task tasks[64];
    struct inspect_entity thing;
    size_t used, size;

    inspect_bodies(b, ignore, NULL);
    inspect_gauges(b, g);
    inspect_memory(b, &used, &size);
    inspect_random_draws(b);
    uint32_t n = inspect_tasks(b, 0, tasks, 64);
    for (uint32_t i = 0; i < n && i < 64; i++)
        inspect_task(b, tasks[i].serial, &tasks[0]);
    for (int i = 0; i < 40; i++)
        if (inspect_entity_at(b, i * 53 % 240, i * 31 % 320, 8, &thing))
            inspect_task(b, thing.owner_task, &tasks[0]);
}

/* The torture game has every kind of thing and task. Two boards, one of which is asked all the time. */
TEST(a_board_that_is_asked_runs_on_alike)
{
    struct rig_game g;
    struct rig a, b;
    struct rng rng;
    uint16_t pads[MAX_PLAYERS] = { 0 };
    uint8_t *before;

    rig_folder(&g, "torture");
    rig_power(&a, &g, NULL);
    rig_power(&b, &g, NULL);
    before = malloc(b.ram_size);
    rng_seed(&rng, 4);
    for (int f = 0; f < 400; f++) {
        rig_pads(&rng, pads);
        rig_tick(&a, pads);
        rig_tick(&b, pads);
        memcpy(before, b.ram, b.ram_size);
        ask_everything(b.b);
        assert_memory_equal(before, b.ram, b.ram_size); /* all of it: what a snapshot leaves out, too */
        if (rig_differs(&a, &b))
            fail_msg("frame %d: part %s differs", f, rig_differs(&a, &b));
    }
    free(before);
    rig_free(&a);
    rig_close(&b);
}

/* Where the music is, as scripts see it, and voices by what they play; a voice that is alone is as loud as all. */
TEST(what_sounds)
{
    struct manifest m = rig_manifest();
    void *tables = malloc(board_sound_tables_size());
    int16_t sound[2 * BOARD_SOUND_FRAMES];
    struct inspect_voice v;
    struct inspect_music music;
    struct rig_game game;
    struct rig r;
    char want[64];
    int busy = 0, peak = 0;

    board_sound_init_tables(tables);
    m.has_sound = 1;
    rig_script(
        &game, &m,
        "function string.told() return ('%d %d %s'):format(music.bar(), music.beat(), music.marker() or '') end\n"
        "task.go(function() sound.play('hit', { pan = -1 }) wait(30) music.play('tide') end)");
    rig_sounds(&game);
    rig_power(&r, &game, NULL);
    rig_run(&r, 2);
    inspect_music(r.b, &music);
    assert_string_equal(music.name, "");
    board_mix_sound(r.b, tables, sound);
    for (int k = 0; k < 2 * BOARD_SOUND_FRAMES; k++)
        peak = abs(sound[k]) > peak ? abs(sound[k]) : peak;
    for (int i = 0; i < VOICES; i++) {
        inspect_voice(r.b, i, &v);
        if (!v.is_busy)
            continue;
        busy++;
        assert_true(!v.is_music && v.pan == -64);
        assert_string_equal(v.source, "hit");
        assert_string_equal(v.instrument_kind, "noise");
        assert_true(peak > 0 && inspect_voice_peak(r.b, i, tables) == peak);
    }
    assert_int_equal(busy, 1);
    rig_run(&r, 38);
    for (int f = 40; f < 400; f++) {
        rig_run(&r, 1);
        inspect_music(r.b, &music);
        assert_string_equal(music.name, "tide");
        snprintf(want, sizeof want, "%d %d %s", (int)music.bar, (int)music.bar * music.beats_per_bar + music.beat,
                 music.mark);
        assert_string_equal(rig_told(&r), want);
    }
    const uint64_t hash = board_hash(r.b);
    assert_true(inspect_voice_peak(r.b, 0, tables) != inspect_voice_peak(r.b, 1, tables));
    assert_true(board_hash(r.b) == hash);
    inspect_voice(r.b, 0, &v);
    assert_true(v.is_music && v.is_busy);
    assert_string_equal(v.source, "tide");
    assert_string_equal(v.instrument_kind, "fm");
    rig_close(&r);
    free(tables);
}

/* In which frames fire is the ship's: not before there is one, nor while a talk or a pause has the buttons. */
TEST(who_plays)
{
    static const char script[] = "player.def('ship', { sprite = 'dot', hit = { circle = 2 } })\n"
                                 "local sys = string.sys\n"
                                 "task.go(function()\n"
                                 "  wait(2) sys.join(1, 'ship') print 'in'\n"
                                 "  wait(2) sys.hold_players(1) print 'held'\n"
                                 "  wait(2) sys.hold_players(0) print 'free'\n"
                                 "  wait(2) sys.hold_players(2) print 'stands'\n"
                                 "  wait(2) sys.hold_players(0) print 'free'\n"
                                 "  wait(2) board.stop(2) print 'stopped'\n"
                                 "  wait(2) local menu = sys.scope()\n"
                                 "  task.own(menu, function() wait(3) sys.freeze() print 'back' end)\n"
                                 "  sys.freeze(menu) print 'frozen'\n"
                                 "  wait(forever)\n"
                                 "end)";
    static const struct {
        const char *said;
        struct inspect_controls has;
    } steps[] = { { "", { false, false } },        { "in\n", { true, true } },       { "held\n", { true, false } },
                  { "free\n", { true, true } },    { "stands\n", { false, false } }, { "free\n", { true, true } },
                  { "stopped\n", { true, true } }, { "frozen\n", { false, false } }, { "back\n", { true, true } } };
    enum { STEPS = sizeof steps / sizeof *steps };
    struct rig_game game;
    struct rig r;
    size_t step = 0;

    rig_with_sys(&game, NULL, script);
    rig_power(&r, &game, NULL);
    for (int frame = 0; frame < 40; frame++) {
        const struct inspect_controls one = inspect_player_controls(r.b, 0), two = inspect_player_controls(r.b, 1);
        assert_true(one.can_steer == steps[step].has.can_steer && one.can_fire == steps[step].has.can_fire);
        assert_false(two.can_steer || two.can_fire);
        rig_run(&r, 1);
        const struct board_out *out = board_last_output(r.b);
        if (step + 1 < STEPS && out->log_size && strncmp(out->log, steps[step + 1].said, out->log_size) == 0)
            step++;
    }
    assert_int_equal(step, STEPS - 1);
    rig_close(&r);
}

RUN_TESTS_EACH(bed_open, bed_close)
