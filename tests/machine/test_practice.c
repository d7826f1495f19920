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
    "player.def('other', { sprite = 'dot', hit = { circle = 2 }, registers = {\n"
    "  fuel = { show = 'number', label = 'Fuel' } } })\n"
    "player.def('wide', { sprite = 'dot', hit = { circle = 2 } })\n"
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
    "mission.def('rain', { title = 'Into the Rain', stage = 'rain', clear = true })\n"
    "boot.run { stages = { 'one', 'rain' }, players = { 'ship', 'other' }, ships = {\n"
    "  other = { forms = { { kind = 'other', title = 'THIN' }, { kind = 'wide', title = 'WIDE' } } } } }\n";

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

    start.practice.lives = 100;
    expect_refusal(&start, "practice start: lives: expected 0 to 99, got 100");
    start.practice.lives = 0;
    start.practice.register_count = 17;
    expect_refusal(&start, "practice start: expected at most 16 registers, got 17");
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

/* ---- markers ---- */

/* The marks of a run, "kind name of" a line, but for the waves; a blank line a round. */
static void tell(const char *mark, int frames, char *out, size_t size)
{
    static const char *const kinds[MARKER_KINDS] = { "stage",  "point", "wave", "boss",  "phase",      "death",
                                                     "clear",  "won",   "lost", "start", "ship",       "register",
                                                     "listed", "game",  "over", "row",   "difficulty", "mission" };
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

    tell("one", 350, all, sizeof all);
    assert_string_equal(all, "start \nstage one\npoint guard of one\nboss queen \"The Queen\"\nphase first of queen\n"
                             "won first of queen\nphase second of queen \"Sign of Rain\"\nwon second of queen\n"
                             "point end of one\npoint end of one\nclear one\n"
                             "start \nstage one\npoint guard of one\nboss queen \"The Queen\"\n");
    tell("one:end", 84, all, sizeof all);
    assert_string_equal(all, "stage one\npoint end of one\nstart \npoint end of one\nclear one\n"
                             "stage one\npoint end of one\nstart \npoint end of one\n");
    tell("queen/second", 170, all, sizeof all);
    assert_string_equal(all, "start \nboss queen \"The Queen\"\nphase second of queen \"Sign of Rain\"\n"
                             "won second of queen\nstart \nboss queen \"The Queen\"\n");
    tell("knight/stand", 110, all, sizeof all);
    assert_string_equal(all, "start \nboss knight \"Knight\"\nphase stand of knight\nlost stand of knight\n");
}

/* ---- what is skipped for ever ---- */

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
TEST(same)
{
    struct board_start start = start_at("first:boss");
    struct rig_game torture;
    struct rng hands;
    struct rig a, b;
    uint16_t pads[MAX_PLAYERS] = { 0 };

    start.practice.lives = 2;
    start.practice.invincible = true;
    add_register(&start, "bombs", 9);
    add_register(&start, "power", 3);
    rig_folder(&torture, "torture");
    rig_power(&a, &torture, &start);
    rig_power(&b, &torture, &start);
    rng_seed(&hands, 5);
    for (uint32_t f = 0; f < 900; f++) {
        rig_pads(&hands, pads);
        rig_tick(&a, pads);
        rig_tick(&b, pads);
        rig_spoil(&b);
        if (rig_differs(&a, &b))
            fail_msg("frame %u: %s differs", f + 1, rig_differs(&a, &b));
    }
    rig_free(&a);
    rig_close(&b);
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
    rig_close(&r);
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
    assert_int_equal(p.ships, 3);
    assert_string_equal(p.ship[0].name, "ship");
    assert_string_equal(p.ship[0].title, "Ship");
    assert_string_equal(p.ship[0].sprite, "dot");
    assert_int_equal(p.ship[0].lives, 3);
    assert_string_equal(p.ship[2].title, "Other WIDE");
    assert_int_equal(p.registers, 3);
    assert_string_equal(p.reg[1].name, "power");
    assert_string_equal(p.reg[1].title, "Power");
    assert_int_equal(p.reg[1].value, 7);
    assert_int_equal(p.reg[2].ship, 1);
    assert_string_equal(p.reg[2].title, "Fuel");
    assert_int_equal(p.n, 14);
    expect_section(&p, 0, SECTION_STAGE, "one", "Stage One");
    expect_section(&p, 1, SECTION_MARK, "one:guard", "Guard");
    expect_section(&p, 2, SECTION_MARK, "one:end", "End");
    expect_section(&p, 3, SECTION_STAGE, "rain", "Stage Rain");
    expect_section(&p, 5, SECTION_STAGE, "ever", "Stage Ever");
    expect_section(&p, 6, SECTION_MARK, "ever:before", "Before");
    expect_section(&p, 8, SECTION_MARK, "waits:round", "Round");
    expect_section(&p, 9, SECTION_BOSS, "queen", "The Queen");
    assert_string_equal(p.section[9].portrait, "dot");
    expect_section(&p, 10, SECTION_PHASE, "queen/first", "First");
    expect_section(&p, 11, SECTION_PHASE, "queen/second", "Sign of Rain");
    expect_section(&p, 13, SECTION_PHASE, "knight/stand", "Stand");
    assert_string_equal(sections_title(&p, MARKER_STAGE, "rain"), "Stage Rain");
    assert_string_equal(sections_title(&p, MARKER_SHIP, "other"), "Other THIN");
    assert_string_equal(sections_title(&p, MARKER_DIFFICULTY, "normal"), "Normal");
    assert_string_equal(sections_title(&p, MARKER_MISSION, "rain"), "Into the Rain");
    assert_string_equal(sections_title(&p, MARKER_MISSION, "gone"), "gone");
}

/* A title is cut to whole characters. */
TEST(long_title)
{
    static struct sections p;
    struct board_start start = start_at("");
    struct rig_game g;
    static const char text[] = "enemy.def('e', { sprite = 'dot', hit = { box = { 4, 4 } } })\n"
                               "player.def('ship', { sprite = 'dot', hit = { circle = 2 } })\n"
                               "boss.def('sea', { title = ('\\u{6d77}'):rep(20), kind = 'e', x = 0, y = 0, phases = {\n"
                               "  { id = 'a', hp = 5, time = 60, run = function() end } } })\n"
                               "stage.def('deep', function() end)\n"
                               "boot.run { stages = { 'deep' }, players = { 'ship' } }\n";

    rig_script(&g, NULL, text);
    sections_list(&p, &g.image.rom, &start, true);
    assert_string_equal(p.why, "");
    assert_int_equal(strlen(p.section[1].title), 45); /* 15 characters of 3 bytes */
    rig_game_free(&g);
}

/* Each section can be started, but for a stage that waits forever. */
TEST(sections_start)
{
    static struct sections p;
    struct board_start list = start_at("");

    sections_list(&p, &game.image.rom, &list, true);
    for (int i = 0; i < p.n; i++) {
        struct board_start start = start_at(p.section[i].id);
        struct rig r;
        if (p.section[i].kind == SECTION_BOSS || !strcmp(p.section[i].id, "waits"))
            continue;
        rig_power(&r, &game, &start);
        until_round(&r, 1);
        rig_free(&r);
    }
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
    expect_section(&p, 1, SECTION_MARK, "good:a", "A");
    expect_section(&p, 2, SECTION_STAGE, "bad", "Stage Bad");
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

static void begin_menu(const struct board_start *start, int slow)
{
    practice_start_run(&menu, start);
    practice_open(&menu, &screens, slow);
}

static void open_menu(const struct board_start *start)
{
    screens = (struct screens){ 0 };
    menu = (struct practice_menu){ .cart = &game.cart, .home = *start, .speed = 100 };
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
    open_menu(&start); /* with the first section */
    assert_int_equal(TAP(down, fire, down, fire, fire), STARTS);
    practice_chosen(&menu, &got);
    assert_string_equal(got.practice.section, "one:guard");
    assert_int_equal(got.practice.lives, 0);
    assert_int_equal(got.practice.register_count, 0);
    assert_false(got.practice.invincible);
    assert_int_equal(got.seed, 77);
    begin_menu(&got, 50);
    held(0);
    assert_int_equal(menu.speed, 50);
    /* From Start round the end: speed, hitbox, invincible, power, bombs, lives, over the heading to the ship. */
    assert_int_equal(TAP(up, right, up, fire, up, left, up, right, up, (uint16_t)(left | PAD_FOCUS)), STAYS);
    assert_int_equal(TAP(up, (uint16_t)(right | PAD_FOCUS), right, up, right, right, fire), STAYS);
    assert_int_equal(menu.speed, 55);
    assert_true(menu.hitbox);
    /* the list of sections, round the end: the knight's heading is passed over */
    assert_int_equal(TAP(up, fire, up, up, up, fire, fire), STARTS);
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
}

/* A sprite knows the palette of its sheet, so a portrait has the right colours on a screen. */
TEST(portrait_palette)
{
    struct rig_game g;
    struct sprite s;

    rig_folder(&g, "glasstide");
    cart_sprite(&g.cart, cart_find(&g.cart, CART_SPRITES, "crab_face"), &s);
    assert_ptr_equal(cart_palette_at(&g.cart, s.palette - 1), cart_palette(&g.cart, "one"));
    cart_sprite(&g.cart, cart_find(&g.cart, CART_SPRITES, "heron"), &s);
    assert_int_equal(s.palette, 0);
    rig_game_free(&g);
}

/* Another ship has its own registers, and is part of the section's id. */
TEST(menu_ship)
{
    struct board_start start = start_at(""), got;

    open_menu(&start);
    screens_choose(&screens, 2);
    held(0);
    assert_int_equal(TAP((uint16_t)PAD_RIGHT), STAYS);
    assert_string_equal(screen_place_row(&screens.place[0], 1).value, "Stage One");
    assert_string_equal(screen_place_row(&screens.place[0], 2).value, "Other THIN");
    assert_string_equal(screen_place_row(&screens.place[0], 5).label, "Fuel");
    screens_choose(&screens, 0);
    assert_int_equal(TAP((uint16_t)PAD_FIRE), STARTS);
    practice_chosen(&menu, &got);
    assert_string_equal(got.practice.section, "one@other");
    begin_menu(&got, 1);
    assert_int_equal(menu.ship, 1);
    assert_string_equal(menu.section, "one");
}

/* Sections are locked until a game reaches them, and a boss's title is hidden until one of its phases is reached. */
TEST(locks)
{
    struct board_start start = start_at("");
    const struct board_marker stage = { .kind = MARKER_STAGE, .name = "one" };
    const struct board_marker phase = { .kind = MARKER_PHASE, .name = "second", .parent = "queen" };
    struct screen_row row;

    open_menu(&start);
    menu.locks = true;
    assert_false(screen_place_row(&screens.place[0], 0).disabled); /* Start, at the first stage, which is always open */
    assert_int_equal(TAP((uint16_t)PAD_DOWN, (uint16_t)PAD_FIRE), STAYS); /* the list */
    assert_string_equal(screen_place_row(&screens.place[1], 1).label, "Stage One");
    assert_false(screen_place_row(&screens.place[1], 1).disabled);
    row = screen_place_row(&screens.place[1], 2);
    assert_true(row.disabled);
    assert_string_equal(row.help, "Not reached yet. Reach it in a game to practise it.");
    assert_string_equal(screen_place_row(&screens.place[1], 10).label, "? ? ?");
    assert_int_equal(TAP((uint16_t)PAD_DOWN, (uint16_t)PAD_FIRE), STAYS); /* what is locked is not chosen */
    assert_int_equal(screens.depth, 2);
    assert_int_equal(TAP((uint16_t)PAD_UP), STAYS);
    practice_reach(&menu, &stage);
    practice_reach(&menu, &phase);
    row = screen_place_row(&screens.place[1], 1);
    assert_false(row.disabled);
    assert_string_equal(row.value, "0/0");
    assert_string_equal(row.help, "Practise this section.");
    assert_true(screen_place_row(&screens.place[1], 2).disabled);
    assert_string_equal(screen_place_row(&screens.place[1], 10).label, "The Queen");
    assert_string_equal(screen_place_row(&screens.place[1], 11).label, "  ? ? ?");
    assert_string_equal(screen_place_row(&screens.place[1], 12).label, "  Sign of Rain");
    assert_int_equal(TAP((uint16_t)PAD_FIRE), STAYS);
    assert_int_equal(TAP((uint16_t)PAD_FIRE), STARTS);
    records_free(&menu.records);
}

/* A boss is practised in the scene of the stage that has its fight. */
TEST(boss_scene)
{
    static const char text[] =
        "enemy.def('e', { sprite = 'dot', hit = { box = { 4, 4 } } })\n"
        "player.def('ship', { sprite = 'dot', hit = { circle = 2 } })\n"
        "local scene = 'none'\n"
        "boss.def('queen', { title = 'Q', kind = 'e', x = 32, y = 20, phases = {\n"
        "  { id = 'a', hp = 5, time = 60, run = function() print(scene) end } } })\n"
        "stage.def('first', function() scene = 'first' wait(500) end)\n"
        "stage.def('ever', function() scene = 'ever' while true do wait(1) end end)\n"
        "stage.def('last', function()\n"
        "  wait(99) scene = 'last' boss.fight('queen') scene = 'after'\n"
        "end)\n"
        "boot.run { modes = { { name = 'a', stages = { 'first', 'ever' } }, { name = 'b', stages = { 'last' } } },\n"
        "  players = { 'ship' } }\n";
    struct board_start start = start_at("queen/a");
    struct rig_game g;
    struct rig r;
    int last = 0, other = 0;

    rig_script(&g, NULL, text);
    rig_power(&r, &g, &start);
    until_round(&r, 1);
    for (int f = 0; f < 100; f++) {
        rig_run(&r, 1);
        last += said(&r, "last");
        other += said(&r, "after") + said(&r, "first") + said(&r, "ever");
    }
    assert_int_equal(last, 1);
    assert_int_equal(other, 0);
    rig_close(&r);
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
    told_now(MARKER_WON, "first", "queen"); /* another phase, another boss, another section */
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
