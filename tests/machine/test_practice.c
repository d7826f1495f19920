/*
 * test_practice.c - practice starts: their lives, registers and invincibility, what a board tells of them, the list of
 * all sections of a game; and the program's menu of them.
 */
#include "rig.h"
#include "../../src/player/play/practice.h"

/* ---- a game that has a section of every sort ---- */

/* Bullets fly across the ship at once; the queen breaks by herself, the knight does not. */
static const char game_text[] =
    "bullet.def('dot', { sprite = 'dot', hit = { circle = 4 } })\n"
    "enemy.def('e', { sprite = 'dot', hit = { box = { 4, 4 } } })\n"
    "player.def('ship', { sprite = 'dot', hit = { circle = 2 }, graze = 20, lives = 3, safe = 10,\n"
    "  registers = { power = 7, bombs = 2 }, run = function(p) board.note(p.lives) board.note(p.power) end })\n"
    "player.def('other', { sprite = 'dot', hit = { circle = 2 } })\n"
    "on.hit(function() print 'hit' end)\n"
    "on.graze(function() print 'graze' end)\n"
    "local function rain()\n"
    "  while true do\n"
    "    local p = player.get(1)\n"
    "    if p.alive then bullet.fire { kind = 'dot', x = p.x, y = p.y - 30, speed = 3 } end\n"
    "    wait(7)\n"
    "  end\n"
    "end\n"
    "local function weak(e) wait(20) e:hurt(5) end\n"
    "local function strong(e) rain() end\n"
    "boss.def('queen', { title = 'The Queen', kind = 'e', x = 32, y = 20, phases = {\n"
    "  { id = 'first', hp = 5, time = 60, run = weak },\n"
    "  { id = 'second', hp = 5, time = 60, spell = 'Sign of Rain', run = weak } } })\n"
    "boss.def('knight', { title = 'Knight', kind = 'e', x = 32, y = 20, phases = {\n"
    "  { id = 'stand', hp = 500, time = 40, run = strong } } })\n"
    "stage.def('one', function()\n"
    "  stage.at(30) stage.mark 'guard' boss.fight 'queen'\n"
    "  stage.at(50) stage.mark 'end' stage.mark 'end' wait(5)\n"
    "end)\n"
    "stage.def('rain', function() rain() end)\n"
    "stage.def('crash', function()\n"
    "  local p = player.get(1)\n"
    "  enemy.spawn { kind = 'e', x = p.x, y = p.y }.safe = forever\n"
    "  wait(100)\n"
    "end)\n"
    "stage.def('ever', function()\n"
    "  stage.mark 'before' stage.mark 'x/y'\n"
    "  while enemy.count() == 0 do wait(1) end\n"
    "  stage.mark 'after'\n"
    "end)\n"
    "stage.def('waits', function() while true do stage.clear() boss.fight 'queen' stage.mark 'round' end end)\n"
    "stage.def('a/b', function() end) stage.def('c:d', function() end) stage.def('\\u{e4}', function() end)\n"
    "boss.def('q/r', { title = 'R', kind = 'e', x = 0, y = 0, phases = { { id = 'p', hp = 1, time = 1, run = weak } } "
    "})\n"
    "boot.run { stages = { 'one', 'rain' }, players = { 'ship', 'other' } }\n";

static struct rig_game game;

static int open_game(void **state)
{
    (void)state;
    rig_script(&game, NULL, game_text);
    return 0;
}

static int close_game(void **state)
{
    (void)state;
    rig_game_free(&game);
    return 0;
}

static struct board_start start_at(const char *mark)
{
    struct board_start s = { .seed = 1, .difficulty = -1 };

    snprintf(s.practice.section, sizeof s.practice.section, "%s", mark);
    return s;
}

static void add_register(struct board_start *s, const char *name, int32_t value)
{
    struct practice *p = &s->practice;

    snprintf(p->reg[p->register_count].name, sizeof p->reg[0].name, "%s", name);
    p->reg[p->register_count++].value = value;
}

/* So often was a line said in the log of the last tick. */
static int said(const struct rig *r, const char *what)
{
    const struct board_out *out = board_last_output(r->b);
    int n = 0;

    for (size_t i = 0; i + strlen(what) <= out->log_size; i++)
        n += memcmp(out->log + i, what, strlen(what)) == 0;
    return n;
}

/* So many marks of a kind, and of that name if one is given, did the last tick tell. */
static int told(const struct rig *r, enum board_marker_kind kind, const char *name)
{
    const struct board_out *out = board_last_output(r->b);
    int n = 0;

    for (int i = 0; i < out->marker_count; i++)
        n += out->marker[i].kind == kind && (!name || !strcmp(out->marker[i].name, name));
    return n;
}

/* ---- lives and registers ---- */

/* Runs until the section has begun for the n-th time. */
static void until_round(struct rig *r, int n)
{
    for (int f = 0; n > 0; f++) {
        assert_true(f < 20000);
        rig_run(r, 1);
        n -= told(r, MARKER_START, NULL);
    }
}

TEST(lives)
{
    static const int32_t lives[] = { 0, 1, 2, 7, 99 };

    for (size_t i = 0; i < sizeof lives / sizeof *lives; i++)
        for (int round = 1; round <= 2; round++) {
            struct board_start start = start_at(round == 1 ? "rain" : "knight/stand");
            struct rig r;
            start.practice.lives = lives[i];
            rig_power(&r, &game, &start);
            until_round(&r, lives[i] > 7 ? 1 : round);
            assert_int_equal(r.b->player.lives[0], lives[i] ? lives[i] - 1 : 2);
            rig_free(&r);
        }
}

/* With one life it is over at the first hit, with two at the second. */
static int deaths_in_round(int32_t lives)
{
    struct board_start start = start_at("rain");
    struct rig r;
    int deaths = 0;

    start.practice.lives = lives;
    rig_power(&r, &game, &start);
    until_round(&r, 1);
    do {
        rig_run(&r, 1);
        deaths += told(&r, MARKER_DEATH, "1");
    } while (!told(&r, MARKER_START, NULL));
    rig_free(&r);
    return deaths;
}

TEST(deaths)
{
    assert_int_equal(deaths_in_round(0), 3);
    assert_int_equal(deaths_in_round(1), 1);
    assert_int_equal(deaths_in_round(5), 5);
}

/* bombs is register 0, power 1: in byte order. */
TEST(registers)
{
    struct board_start start = start_at("rain");
    struct rig r;

    rig_power(&r, &game, &start);
    rig_run(&r, 2);
    assert_int_equal(board_get_register(r.b, 0, 0), 2);
    assert_int_equal(board_get_register(r.b, 0, 1), 7);
    rig_free(&r);
    add_register(&start, "power", 2000000000);
    rig_power(&r, &game, &start);
    for (int round = 1; round <= 2; round++) {
        until_round(&r, 1);
        assert_int_equal(board_get_register(r.b, 0, 0), 2);
        assert_int_equal(board_get_register(r.b, 0, 1), 2000000000);
    }
    rig_free(&r);
    start.practice.reg[0].value = -5; /* as an old demo may ask */
    rig_power(&r, &game, &start);
    rig_run(&r, 2);
    assert_int_equal(board_get_register(r.b, 0, 1), 0);
    rig_free(&r);
}

static void expect_fault(const struct board_start *start, const char *message)
{
    struct rig r;

    rig_power_any(&r, &game, start);
    assert_non_null(rig_fault(&r));
    assert_string_equal(rig_fault(&r)->message, message);
    rig_free(&r);
}

TEST(unknown_registers)
{
    struct board_start near = start_at("rain"), far = start_at(PRACTICE_LIST);

    add_register(&near, "power", 1);
    add_register(&near, "bomb", 1);
    expect_fault(&near, "main.lua:40: --register: ship \"ship\" has no register \"bomb\" (did you mean \"bombs\"?)");
    add_register(&far, "speed", 1);
    expect_fault(&far, "main.lua:40: --register: ship \"ship\" has no register \"speed\" (known: bombs, power)");
}

static void expect_refusal(const struct board_start *start, const char *message)
{
    char err[256] = "";
    size_t size;

    assert_true(board_size(&game.image.rom, &size, err, sizeof err));
    void *ram = malloc(size);
    assert_null(board_power_on(ram, size, &game.image.rom, start, err, sizeof err));
    assert_string_equal(err, message);
    free(ram);
}

TEST(ranges)
{
    struct board_start start = start_at("one");

    start.practice.lives = -1;
    expect_refusal(&start, "practice start: lives: expected 0 to 99, got -1");
    start.practice.lives = 100;
    expect_refusal(&start, "practice start: lives: expected 0 to 99, got 100");
    start.practice.lives = 0;
    start.practice.register_count = 17;
    expect_refusal(&start, "practice start: expected at most 16 registers, got 17");
    start.practice.register_count = -1;
    expect_refusal(&start, "practice start: expected at most 16 registers, got -1");
    start.practice.register_count = 0;
    start.practice.section[0] = 0;
    start.practice.invincible = true;
    expect_refusal(&start, "lives, registers and invincibility require a practice start");
}

/* ---- invincible ---- */

struct hits {
    int hits, grazes, deaths, lived;
};

/* A hundred frames of a stage that would kill, with or without p.safe for that. */
static struct hits suffer(const char *mark, bool invincible)
{
    struct board_start start = start_at(mark);
    struct hits h = { 0 };
    struct rig r;

    start.practice.invincible = invincible;
    rig_power(&r, &game, &start);
    for (int f = 0; f < 100; f++) {
        rig_run(&r, 1);
        h.hits += said(&r, "hit");
        h.grazes += said(&r, "graze");
        h.deaths += told(&r, MARKER_DEATH, NULL);
        h.lived += r.b->player.in_game[0] && !r.b->player.safe_left[0];
    }
    h.grazes = (int)r.b->player.grazes[0] == h.grazes ? h.grazes : -1;
    rig_free(&r);
    return h;
}

TEST(invincible)
{
    static const char *const marks[] = { "rain", "crash" };

    for (int i = 0; i < 2; i++) {
        struct hits mortal = suffer(marks[i], false), god = suffer(marks[i], true);
        assert_true(mortal.hits > 0 && mortal.deaths > 0);
        assert_int_equal(god.hits, 0);
        assert_int_equal(god.deaths, 0);
        assert_int_equal(god.lived, 90); /* safe is what the kind says, ten frames, and then nothing */
        assert_int_equal(god.grazes > 0, i == 0);
    }
}

/* The second player, whom a game's own start brings in, is spared too. */
TEST(both_invincible)
{
    static const char text[] = "local sys = ...\n"
                               "return { run = function()\n"
                               "  sys.practice() sys.join(1, 'ship') sys.join(2, 'ship')\n"
                               "  task.go(function() while true do\n"
                               "    player.each(function(p) bullet.fire { kind = 'dot', from = p, speed = 0 } end)\n"
                               "    wait(5)\n"
                               "  end end)\n"
                               "end }\n";
    const struct rig_script scripts[] = { { "main", game_text }, { "@std/boot", text } };
    struct board_start start = start_at("one");
    struct rig_game own;
    struct rig r;

    rig_scripts(&own, NULL, scripts, 2);
    for (int god = 0; god < 2; god++) {
        start.practice.invincible = god;
        rig_power(&r, &own, &start);
        rig_run(&r, 100);
        assert_int_equal(r.b->player.in_game[0], god);
        assert_int_equal(r.b->player.in_game[1], god);
        rig_free(&r);
    }
    rig_game_free(&own);
}

/* ---- games ---- */

/* Plays with pads until a game is told to be over and its score has been entered, or frames are up: the markers of
 * games and rows, "kind name value" a line. */
static void tell_games(const char *text, const uint16_t pads[4], uint32_t frames, char *out, size_t size)
{
    struct board_start start = { .seed = 1, .difficulty = -1 };
    struct rig_game g;
    struct rig r;
    size_t n = 0;

    rig_script(&g, NULL, text);
    rig_power(&r, &g, &start);
    out[0] = 0;
    for (uint32_t f = 0; f < frames; f++) {
        const uint16_t held[MAX_PLAYERS] = { f % 20 < 2 ? pads[f / 20 % 4] : 0, 0 };
        rig_tick(&r, held);
        const struct board_out *o = board_last_output(r.b);
        for (int i = 0; i < o->marker_count; i++)
            if (o->marker[i].kind > MARKER_LISTED)
                n += (size_t)snprintf(out + n, size - n, "%d %s %d\n", (int)o->marker[i].kind - MARKER_GAME,
                                      o->marker[i].name, (int)o->marker[i].value);
    }
    rig_free(&r);
    rig_game_free(&g);
}

/* Stage "two" comes to its end, or a player who stands still dies there and has no life left. */
static const char a_game[] =
    "bullet.def('orb', { sprite = 'dot', hit = { circle = 3 } })\n"
    "player.def('ship', { sprite = 'dot', hit = { circle = 2 }, lives = 1 })\n"
    "stage.def('one', function() wait(10) score.add(500) end)\n"
    "stage.def('two', function() wait(10) end)\n"
    "stage.def('end', function() while true do bullet.fire { kind = 'orb', x = 120, y = 0, aim = true, speed = 4 } "
    "wait(5) end end)\n";

/* The beginning and the end of a game, and its row in the table. */
TEST(games)
{
    static const struct {
        const char *stages, *want;
        uint16_t pads[4];
    } games[] = {
        { "'one', 'two'", "0 ship 1\n1 clear 2\n2 normal 1\n", { PAD_FIRE, PAD_FIRE, PAD_FIRE, PAD_FIRE } },
        { "'one', 'end'", "0 ship 1\n1 over 1\n2 normal 1\n", { PAD_FIRE, PAD_FIRE, PAD_FIRE, PAD_FIRE } },
        { "'end'", "0 ship 2\n1 quit 0\n0 ship 1\n", { PAD_FIRE, PAD_START, PAD_UP, PAD_FIRE } },
    };
    char text[1024], out[1024];

    for (size_t i = 0; i < sizeof games / sizeof *games; i++) {
        snprintf(text, sizeof text, "%sboot.run { stages = { %s }, players = { 'ship' } }", a_game, games[i].stages);
        tell_games(text, games[i].pads, 4000, out, sizeof out);
        if (strncmp(out, games[i].want, strlen(games[i].want)))
            fail_msg("%s: told:\n%s", games[i].stages, out);
    }
}

/* ---- markers ---- */

/* The marks of a run, "kind name of" a line, but for the waves; a blank line a round. */
static void tell(const char *mark, int frames, char *out, size_t size)
{
    static const char *const kinds[MARKER_KINDS] = { "stage",  "point", "wave", "boss",  "phase", "death",
                                                     "clear",  "won",   "lost", "start", "ship",  "register",
                                                     "listed", "game",  "over", "row" };
    struct board_start start = start_at(mark);
    struct rig r;
    size_t n = 0;

    start.practice.invincible = true;
    rig_power(&r, &game, &start);
    out[0] = 0;
    for (int f = 0; f < frames; f++) {
        rig_run(&r, 1);
        const struct board_out *now = board_last_output(r.b);
        for (int i = 0; i < now->marker_count; i++) {
            const struct board_marker *m = &now->marker[i];
            n += (size_t)snprintf(out + n, size - n, "%s %s%s%s%s%s%s\n", kinds[m->kind], m->name,
                                  m->parent[0] ? " of " : "", m->parent, m->title[0] ? " \"" : "", m->title,
                                  m->title[0] ? "\"" : "");
        }
    }
    rig_free(&r);
}

TEST(marks)
{
    char all[4096];

    tell("one", 270, all, sizeof all);
    assert_string_equal(all, "start \nstage one\npoint guard of one\nboss queen \"The Queen\"\nphase first of queen\n"
                             "won first of queen\nphase second of queen \"Sign of Rain\"\nwon second of queen\n"
                             "point end of one\npoint end of one\nclear one\n"
                             "start \nstage one\npoint guard of one\nboss queen \"The Queen\"\n");
    tell("one:end", 14, all, sizeof all);
    assert_string_equal(all, "stage one\npoint end of one\nstart \npoint end of one\nclear one\n"
                             "stage one\npoint end of one\nstart \npoint end of one\nclear one\n"
                             "stage one\npoint end of one\nstart \npoint end of one\n");
    tell("queen/second", 90, all, sizeof all);
    assert_string_equal(all, "start \nboss queen \"The Queen\"\nphase second of queen \"Sign of Rain\"\n"
                             "won second of queen\nstart \nboss queen \"The Queen\"\n");
    tell("knight/stand", 110, all, sizeof all);
    assert_string_equal(all, "start \nboss knight \"Knight\"\nphase stand of knight\nlost stand of knight\n");
}

/* ---- the list ---- */

/* A line a section; frames: how many it took. */
static char other_ships[256]; /* of the last list, behind the first one */

static void list(const struct rig_game *g, char *out, size_t size, int *frames)
{
    struct board_start start = start_at(PRACTICE_LIST);
    struct rig r;
    size_t n = 0;
    bool done = false, ship = false;

    other_ships[0] = 0;
    for (int i = 0; i < g->cart.manifest.n_dips; i++)
        start.dip[i] = g->cart.manifest.dips[i].default_value;
    rig_power(&r, g, &start);
    out[0] = 0;
    for (*frames = 0; !done; ++*frames) {
        assert_true(*frames < 1000);
        rig_run(&r, 1);
        const struct board_out *now = board_last_output(r.b);
        assert_true(now->marker_count < MAX_TICK_MARKERS); /* or some may not have been told */
        for (int i = 0; i < now->marker_count; i++) {
            const struct board_marker *m = &now->marker[i];
            done |= m->kind == MARKER_LISTED;
            if (m->kind == MARKER_SHIP && ship) {
                strcat(strcat(other_ships, m->name), " ");
                continue;
            }
            ship |= m->kind == MARKER_SHIP;
            if (m->kind == MARKER_SHIP || m->kind == MARKER_REGISTER)
                n += (size_t)snprintf(out + n, size - n, "%s=%d\n", m->name, (int)m->value);
            else if (m->kind == MARKER_MARK || m->kind == MARKER_PHASE)
                n += (size_t)snprintf(out + n, size - n, "%s%s%s %s\n", m->parent, m->kind == MARKER_MARK ? ":" : "/",
                                      m->name, m->title);
            else if (m->kind != MARKER_LISTED)
                n += (size_t)snprintf(out + n, size - n, "%s %s\n", m->name, m->title);
        }
    }
    rig_run(&r, 5); /* and then nothing */
    assert_int_equal(board_last_output(r.b)->marker_count, 0);
    rig_free(&r);
}

TEST(list)
{
    char all[4096];
    int frames;

    list(&game, all, sizeof all, &frames);
    assert_string_equal(other_ships, "other ");
    assert_string_equal(all, "ship=3\nbombs=2\npower=7\n"
                             "one \nrain \ncrash \never \nwaits \n"
                             "queen The Queen\nqueen/first \nqueen/second Sign of Rain\nknight Knight\nknight/stand \n"
                             "one:guard \none:end \never:before \nwaits:round \n");
}

static void list_of_folder(const char *path, const char *expected)
{
    struct rig_game g;
    char all[4096], err[512];
    int frames;

    if (!pack_load_game(path, false, &g.image, err, sizeof err) || !cart_open(&g.cart, &g.image.rom, err, sizeof err))
        fail_msg("%s", err);
    list(&g, all, sizeof all, &frames);
    assert_string_equal(all, expected);
    rig_game_free(&g);
}

TEST(lists_of_games)
{
    list_of_folder("roms/glasstide", "heron=3\n"
                                     "bombs=3\n"
                                     "chain=0\n"
                                     "gauge=0\n"
                                     "shards=100\n"
                                     "rank=20\n"
                                     "one \n"
                                     "two \n"
                                     "three \n"
                                     "moon \n"
                                     "rush \n"
                                     "caravan \n"
                                     "nautilus Lantern Nautilus\n"
                                     "nautilus/lantern \n"
                                     "nautilus/chambers Spiral Sign: Chambered Lamp\n"
                                     "crab Chandelier Crab\n"
                                     "crab/pincers \n"
                                     "crab/grotto Echo Sign: Grotto of Rings\n"
                                     "crab/lamplight Light Sign: Waltz of Lamps\n"
                                     "crab/chandelier Shell Sign: Falling Chandelier\n"
                                     "crab/harbour Last Sign: Harbour Lights\n"
                                     "bellows The Bellows\n"
                                     "bellows/breath \n"
                                     "bellows/draught Breath Sign: Held Draught\n"
                                     "bellows/wheels Gear Sign: Meshing Wheels\n"
                                     "eels Cinder and Quench\n"
                                     "eels/both \n"
                                     "eels/furnace Furnace Sign: Poured Glass\n"
                                     "eels/panes Temper Sign: Panes in Rows\n"
                                     "eels/crossing Alloy Sign: Thrown Back\n"
                                     "eels/press Last Sign: The Press\n"
                                     "angler Anglerlamp\n"
                                     "angler/bait \n"
                                     "angler/match Lamp Sign: Struck Match\n"
                                     "angler/teeth Jaw Sign: Closing Teeth\n"
                                     "queen Queen of the Glass Tide\n"
                                     "queen/wheels \n"
                                     "queen/held Glass Sign: Held Breath\n"
                                     "queen/ebb Moon Sign: Ebb and Flow\n"
                                     "queen/window Pane Sign: Rose Window\n"
                                     "queen/flower Last Sign: Fathomless Flower\n"
                                     "undertow Queen of the Glass Tide\n"
                                     "undertow/again The Tide Returns\n"
                                     "moon The Drowned Moon\n"
                                     "moon/gibbous \n"
                                     "moon/half Half Sign: Two Waters\n"
                                     "moon/crescent Crescent Sign: Reaping Tide\n"
                                     "moon/new New Sign: A Way Through Rings\n"
                                     "moon/full Full Sign: Nearest of Nights\n"
                                     "moon/eclipse Last Sign: The Sea Falls In\n"
                                     "one:wreck \n"
                                     "one:nautilus \n"
                                     "one:deep \n"
                                     "one:crab \n"
                                     "two:street \n"
                                     "two:bellows \n"
                                     "two:halls \n"
                                     "two:eels \n"
                                     "three:trench \n"
                                     "three:angler \n"
                                     "three:deep \n"
                                     "three:queen \n"
                                     "moon:moon \n"
                                     "rush:nautilus \n"
                                     "rush:crab \n"
                                     "rush:bellows \n"
                                     "rush:eels \n"
                                     "rush:angler \n"
                                     "rush:queen \n"
                                     "rush:moon \n");
    list_of_folder("roms/torture", "fast=3\nbombs=1\npower=0\nrank=40\nfirst \nsecond \n"
                                   "twin Twin\ntwin/one \ntwin/two Sign of Two\ntwin/end \npair Iris and "
                                   "Opal\npair/shared \npair/own Both\npair/any \nfirst:boss \n");
    list_of_folder("examples/first", "ship=3\none \n");
    list_of_folder(
        "examples/sandbox",
        "ship=3\nbombs=3\npower=1\ntry \nglow \nlooks \nmoves \ntreasure \nwords \nscenes \nlasers \nduel "
        "\nheard \nsisters Iris and Opal\nsisters/both \nsisters/mirror Mirror Sign: Two Rivers\nsisters/dusk Last "
        "Sign: The Longest Dusk\n");
}

/* What a game without boot.run says. */
TEST(list_of_none)
{
    struct board_start start = start_at(PRACTICE_LIST);
    struct rig_game g;
    struct rig r;

    rig_script(&g, NULL, "task.go(function() end)");
    rig_power_any(&r, &g, &start);
    assert_string_equal(rig_fault(&r)->message,
                        "practice: no sections to choose from, because main.lua does not call boot.run");
    rig_free(&r);
    rig_game_free(&g);
}

/* Every section that is told can be started. */
TEST(list_starts)
{
    char all[4096], *line = all;
    int frames, sections = 0;

    list(&game, all, sizeof all, &frames);
    for (int i = 0; i < 3; i++) /* the ship and its registers */
        line = strchr(line, '\n') + 1;
    for (char *next; *line; line = next) {
        struct rig r;
        next = strchr(line, '\n') + 1;
        *strchr(line, ' ') = 0;
        if (!strcmp(line, "queen") || !strcmp(line, "knight") || !strcmp(line, "waits"))
            continue; /* bosses are headings; a stage that passes no time never ends a frame */
        struct board_start start = start_at(line);
        rig_power(&r, &game, &start);
        until_round(&r, 1);
        rig_free(&r);
        sections++;
    }
    assert_int_equal(sections, 4 + 3 + 4);
}

/* ---- what is skipped for ever ---- */

TEST(endless)
{
    static const char *const marks[] = { "ever:after", "waits:none" };
    static const char *const faults[] = {
        "main.lua:34: wait: more than 100000 waits while skipping to a mark (waiting for something that is skipped?)",
        "main.lua:37: wait: more than 100000 waits while skipping to a mark (waiting for something that is skipped?)"
    };
    const uint16_t none[MAX_PLAYERS] = { 0 };

    for (int i = 0; i < 2; i++) {
        struct board_start start = start_at(marks[i]);
        struct rig r;
        rig_power(&r, &game, &start);
        board_tick(r.b, none);
        assert_non_null(rig_fault(&r));
        assert_string_equal(rig_fault(&r)->message, faults[i]);
        rig_free(&r);
    }
}

TEST(endless_in_list)
{
    struct board_start start = start_at(PRACTICE_LIST);
    struct rig r;
    int ever = 0, waits = 0, one = 0;

    rig_power(&r, &game, &start);
    for (bool done = false; !done; done = told(&r, MARKER_LISTED, NULL)) {
        rig_run(&r, 1);
        one += said(&r, "stage \"one\"");
        ever += said(&r, "stage \"ever\" waits for ever when it is skipped: marks after that are not known");
        waits += said(&r, "stage \"waits\" waits for ever when it is skipped");
    }
    assert_int_equal(ever, 1);
    assert_int_equal(waits, 1);
    assert_int_equal(one, 0);
    rig_free(&r);
}

/* ---- the same on every board ---- */

/* A practice run of torture with all that can be asked for, played by hands; b is spoilt after every frame. */
static void run_twice(const char *mark, bool invincible, uint32_t frames)
{
    struct board_start start = start_at(mark);
    struct rig_game torture;
    struct rng hands;
    struct rig a, b;
    uint16_t pads[MAX_PLAYERS] = { 0 };

    start.practice.lives = 2;
    start.practice.invincible = invincible;
    add_register(&start, "bombs", 9);
    add_register(&start, "power", 3);
    rig_folder(&torture, "torture");
    rig_power(&a, &torture, &start);
    rig_power(&b, &torture, &start);
    rng_seed(&hands, 5);
    for (uint32_t f = 0; f < frames; f++) {
        rig_pads(&hands, pads);
        rig_tick(&a, pads);
        rig_tick(&b, pads);
        rig_spoil(&b);
        if (rig_differs(&a, &b))
            fail_msg("%s: frame %u: %s differs", mark, f + 1, rig_differs(&a, &b));
    }
    rig_free(&a);
    rig_free(&b);
    rig_game_free(&torture);
}

TEST(same)
{
    run_twice("first:boss", true, 900);
    run_twice("twin/two", false, 600);
    run_twice(PRACTICE_LIST, false, 30);
}

/* After board.reset it is the same practice. */
TEST(reset)
{
    static const char more[] = "task.go(function() wait(50) board.reset() end)\n";
    char text[sizeof game_text + sizeof more];
    struct board_start start = start_at("rain");
    struct rig_game g;
    struct rig r;

    snprintf(text, sizeof text, "%s%s", game_text, more);
    rig_script(&g, NULL, text);
    start.practice.lives = 1;
    start.practice.invincible = true;
    rig_power(&r, &g, &start);
    rig_run(&r, 100);
    assert_int_equal(r.b->player.lives[0], 0);
    assert_int_equal(r.b->player.in_game[0], 1);
    rig_free(&r);
    rig_game_free(&g);
}

/* ---- the program's list and menu ---- */

static void expect_section(const struct sections *p, int i, enum section_kind kind, const char *mark, const char *title)
{
    assert_true(i < p->n);
    assert_int_equal(p->section[i].kind, kind);
    assert_string_equal(p->section[i].id, mark);
    assert_string_equal(p->section[i].title, title);
}

TEST(sections)
{
    static struct sections p;
    struct board_start start = start_at("");

    sections_list(&p, &game.image.rom, &start, true);
    assert_string_equal(p.why, "");
    assert_string_equal(p.ship, "ship");
    assert_int_equal(p.lives, 3);
    assert_int_equal(p.registers, 2);
    assert_string_equal(p.reg[1].name, "power");
    assert_int_equal(p.reg[1].value, 7);
    assert_int_equal(p.n, 14);
    expect_section(&p, 0, SECTION_STAGE, "one", "");
    expect_section(&p, 1, SECTION_MARK, "one:guard", "");
    expect_section(&p, 2, SECTION_MARK, "one:end", "");
    expect_section(&p, 3, SECTION_STAGE, "rain", "");
    expect_section(&p, 5, SECTION_STAGE, "ever", "");
    expect_section(&p, 6, SECTION_MARK, "ever:before", "");
    expect_section(&p, 8, SECTION_MARK, "waits:round", "");
    expect_section(&p, 9, SECTION_BOSS, "queen", "The Queen");
    expect_section(&p, 10, SECTION_PHASE, "queen/first", "");
    expect_section(&p, 11, SECTION_PHASE, "queen/second", "Sign of Rain");
    expect_section(&p, 13, SECTION_PHASE, "knight/stand", "");
}

/* A stage that faults when it is run through: what was told before is kept. */
TEST(sections_of_the_wrong)
{
    static struct sections p;
    static const char wrong[] = "player.def('ship', { sprite = 'dot', hit = { circle = 2 } })\n"
                                "stage.def('good', function() stage.mark 'a' end)\n"
                                "stage.def('bad', function() stage.mark 'b' error 'boo' end)\n"
                                "boot.run { stages = { 'good', 'bad' }, players = { 'ship' } }\n";
    struct board_start start = start_at("good");
    struct rig_game g;

    rig_script(&g, NULL, wrong);
    sections_list(&p, &g.image.rom, &start, true);
    assert_string_equal(p.why, "main.lua:3: boo");
    assert_int_equal(p.n, 3);
    expect_section(&p, 1, SECTION_MARK, "good:a", "");
    expect_section(&p, 2, SECTION_STAGE, "bad", "");
    rig_game_free(&g);
    rig_script(&g, NULL, "task.go(function() end)");
    sections_list(&p, &g.image.rom, &start, true);
    assert_string_equal(p.why, "practice: no sections to choose from, because main.lua does not call boot.run");
    assert_int_equal(p.n, 0);
    rig_game_free(&g);
}

static struct practice_menu menu;
static struct screens screens;

/* A frame of the menu with these buttons held; is it still open? */
static bool held(uint16_t pad)
{
    const struct plat_input in = { .mouse_x = -1, .mouse_y = -1 };
    const struct keys_state k = { .pads = { pad } };

    screens_poll(&screens, &in, &k);
    return screens_are_open(&screens);
}

static int row_now(void)
{
    return screens.place[0].row;
}

static void begin_menu(const struct board_start *start, int slow)
{
    practice_start_run(&menu, start);
    practice_open(&menu, &screens, slow);
}

static void open_menu(const struct board_start *start)
{
    screens = (struct screens){ 0 };
    menu = (struct practice_menu){ .cart = &game.cart, .home = *start, .slow = 1 };
    memset(&menu.home.practice, 0, sizeof menu.home.practice);
    begin_menu(start, 1);
    held(0);
}

enum answer { STAYS, BACK, STARTS };

/* A tap each; what the last one came to. */
static enum answer tap(const uint16_t *pads, int n)
{
    for (int i = 0; i < n; i++)
        if (held(pads[i]))
            held(pads[i] & PAD_FOCUS);
    return screens_are_open(&screens) ? STAYS : menu.start_chosen ? STARTS : BACK;
}

#define TAP(...) tap((const uint16_t[]){ __VA_ARGS__ }, sizeof((const uint16_t[]){ __VA_ARGS__ }) / 2)

TEST(menu)
{
    struct board_start start = start_at(""), got;
    const uint16_t up = PAD_UP, down = PAD_DOWN, left = PAD_LEFT, right = PAD_RIGHT, fire = PAD_FIRE;

    start.seed = 77;
    open_menu(&start); /* on the first section */
    assert_int_equal(TAP(down, fire), STARTS);
    practice_chosen(&menu, &got);
    assert_string_equal(got.practice.section, "one:guard");
    assert_int_equal(got.practice.lives, 0);
    assert_int_equal(got.practice.register_count, 0);
    assert_false(got.practice.invincible);
    assert_int_equal(got.seed, 77);
    begin_menu(&got, 2);
    held(0);
    assert_int_equal(menu.slow, 2);
    /* Over the line between, from the section that was played: speed, hitbox, invincible, power, bombs, lives. */
    assert_int_equal(TAP(up, up, right, up, fire, up, left, up, right, up, (uint16_t)(left | PAD_FOCUS)), STAYS);
    assert_int_equal(TAP(up, (uint16_t)(right | PAD_FOCUS), right, up, right, fire), STAYS);
    assert_int_equal(menu.slow, 4);
    assert_true(menu.hitbox);
    assert_int_equal(TAP(up, up, up, fire), STARTS); /* the title, round the end: the knight's heading is passed over */
    practice_chosen(&menu, &got);
    assert_string_equal(got.practice.section, "queen/second");
    assert_int_equal(got.practice.lives, 11);
    assert_true(got.practice.invincible);
    assert_int_equal(got.practice.register_count, 2);
    assert_string_equal(got.practice.reg[0].name, "bombs");
    assert_int_equal(got.practice.reg[0].value, 0); /* it stops there */
    assert_string_equal(got.practice.reg[1].name, "power");
    assert_int_equal(got.practice.reg[1].value, 8);
    begin_menu(&got, 1);
    held(0);
    assert_int_equal(TAP((uint16_t)PAD_BOMB), BACK);
    begin_menu(&got, 1);
    screens_choose(&screens, 0);
    held(0);
    assert_int_equal(TAP(fire), STARTS);
    practice_chosen(&menu, &got);
    assert_memory_equal(&got.practice, &start.practice, sizeof got.practice);
}

/* Held buttons: nothing of before the menu; then again after a while. */
TEST(menu_held)
{
    struct board_start start = start_at("one");
    int row;

    screens = (struct screens){ 0 };
    menu = (struct practice_menu){ .cart = &game.cart, .home = start, .slow = 1 };
    begin_menu(&start, 1);
    row = row_now();
    assert_true(held(PAD_FIRE | PAD_DOWN));
    assert_int_equal(row_now(), row);
    held(0);
    for (int f = 0; f < 21; f++)
        held(PAD_DOWN);
    assert_int_equal(row_now(), row + 2);
    for (int f = 0; f < 6; f++)
        held(PAD_DOWN);
    assert_int_equal(row_now(), row + 4);
}

/* On pictures of any size: nothing is drawn outside, the chosen row is shown, whatever it is. */
TEST(menu_pictures)
{
    static const int sizes[][2] = { { 240, 320 }, { 320, 240 }, { 64, 64 }, { 64, 320 }, { 320, 64 }, { 160, 160 } };
    struct board_start start = start_at("");

    for (size_t s = 0; s < sizeof sizes / sizeof *sizes; s++) {
        int w = sizes[s][0], h = sizes[s][1];
        void *mem = malloc(fb_size(w, h));
        uint64_t last = 0;
        struct fb fb;
        open_menu(&start);
        if (s % 2)
            snprintf(menu.sections.why, sizeof menu.sections.why, "%s",
                     "one sentence about what went wrong in a stage of this game");
        for (int i = 0; i < 30; i++) {
            struct canvas canvas;
            uint32_t rgb[256] = { 0 };
            uint64_t hash = HASH_START;
            bool white = false;
            fb_init(&fb, mem, w, h);
            canvas_open(&canvas, &fb, rgb);
            screens_draw(&screens, &canvas, "");
            for (int y = 0; y < h; y++) {
                hash = hash_bytes(hash, fb.pix + (ptrdiff_t)y * fb.pitch, (size_t)w);
                white |= fb.pix[(ptrdiff_t)y * fb.pitch + w / 2] == canvas.colour[CANVAS_WHITE];
            }
            assert_true(white && hash != last); /* the chosen row's bar; it has moved */
            assert_in_range(row_now(), screens.place[0].top, screens.place[0].top + screens.shown - 1);
            last = hash;
            TAP((uint16_t)PAD_DOWN);
        }
        free(mem);
    }
}

/* What counts, and what does not; the marks are made up. */
static void told_now(enum board_marker_kind kind, const char *name, const char *of)
{
    static struct board_out out;

    out = (struct board_out){ .marker_count = 1, .marker[0] = { .kind = kind } };
    snprintf(out.marker[0].name, sizeof out.marker[0].name, "%s", name);
    snprintf(out.marker[0].parent, sizeof out.marker[0].parent, "%s", of);
    practice_after_tick(&menu, &out);
}

static void expect_record(const char *mark, int captures, int attempts)
{
    const struct record *r = records_find(&menu.records, mark, "normal");

    assert_int_equal(r ? r->captures : 0, captures);
    assert_int_equal(r ? r->attempts : 0, attempts);
}

TEST(counting)
{
    struct board_start phase = start_at("queen/second"), stage = start_at("one:guard"), none = start_at("");

    menu = (struct practice_menu){ .cart = &game.cart };
    practice_start_run(&menu, &phase);
    told_now(MARKER_WON, "second", "queen"); /* before it began */
    told_now(MARKER_START, "", "");
    told_now(MARKER_WON, "first", "queen");
    told_now(MARKER_WON, "second", "knight");
    told_now(MARKER_CLEAR, "queen/second", "");
    told_now(MARKER_LOST, "second", "queen");
    expect_record("queen/second", 0, 1);
    told_now(MARKER_WON, "second", "queen");
    told_now(MARKER_WON, "second", "queen");
    expect_record("queen/second", 1, 1);
    told_now(MARKER_START, "", "");
    told_now(MARKER_DEATH, "1", "");
    told_now(MARKER_WON, "second", "queen");
    expect_record("queen/second", 1, 2);
    told_now(MARKER_START, "", "");
    practice_stop_counting(&menu);
    told_now(MARKER_WON, "second", "queen");
    told_now(MARKER_START, "", "");
    expect_record("queen/second", 1, 3);
    practice_start_run(&menu, &stage);
    told_now(MARKER_START, "", "");
    told_now(MARKER_WON, "guard", "one");
    told_now(MARKER_CLEAR, "on", "");
    told_now(MARKER_CLEAR, "one:guard", "");
    expect_record("one:guard", 0, 1);
    told_now(MARKER_CLEAR, "one", "");
    expect_record("one:guard", 1, 1);
    stage.practice.invincible = true;
    practice_start_run(&menu, &stage);
    told_now(MARKER_START, "", "");
    practice_start_run(&menu, &none);
    told_now(MARKER_START, "", "");
    told_now(MARKER_CLEAR, "one", "");
    expect_record("one:guard", 1, 1);
    assert_int_equal(menu.records.n, 2);
    records_free(&menu.records);
}

RUN_TESTS(open_game, close_game)
