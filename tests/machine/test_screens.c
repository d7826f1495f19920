/*
 * test_screens.c - the screens around a game: the way through all of them by buttons, with one player and two, on
 * fields of several sizes. tests/scripts/boot.lua has screens that a game puts in their place, and what is refused.
 */
#include "../../src/board/inspect.h"
#include "pages.h"

/* A game of two modes, difficulties, stages and ships, with all that boot.run can show. Every thing that dies or clears
 * stands in the pads. */
static const char kinds[] =
    "bullet.def('orb', { sprite = 'dot', hit = { circle = 3 } })\n"
    "player.def('heron', { sprite = 'dot', hit = { circle = 2 }, lives = 2, speed = 4, focus = 2,\n"
    "  registers = { bombs = { start = 3, max = 6, show = 'icons' } } })\n"
    "player.def('tern', { sprite = 'wink', hit = { circle = 2 }, lives = 5, speed = 2, focus = 1 })\n"
    "stage.def('one', function() wait(20) score.add(500) end)\n"
    "stage.def('two', function() wait(20) score.add(70, player.get(2)) end)\n"
    "stage.def('end', function() while true do player.each(function(p) p.safe = 0\n"
    "  bullet.fire { kind = 'orb', x = p.x, y = p.y, dir = 0, speed = 0 } end) wait(5) end end)\n";

static bool widens;        /* the cells of the next game hold any character */
static int lines_of_board; /* of the next game */

static void open_sized(const char *text, int w, int h, int field_w, int players)
{
    static char full[1 << 14];
    struct manifest m = rig_manifest();

    m.screen_w = (int16_t)w;
    m.screen_h = (int16_t)h;
    m.field_w = (int16_t)field_w;
    m.field_h = (int16_t)h;
    m.players = (uint8_t)players;
    m.n_difficulties = 2;
    m.has_wide_text = widens;
    m.lines = lines_of_board;
    memcpy(m.difficulties[0], "calm\0\0", 7);
    memcpy(m.difficulties[1], "wild", 5);
    snprintf(full, sizeof full, "%s%s", kinds, text);
    rig_script(&g, &m, full);
    rig_power_any(&r, &g, NULL);
}

/* 240 x 320, one player; it may fault. */
static void open_game(const char *text)
{
    open_sized(text, 240, 320, 240, 1);
}

static void gone(const char *text)
{
    if (at(text) >= 0)
        fail_msg("frame %u: \"%s\" is still there", board_frame(r.b), text);
}

static const char run_all[] =
    "boot.run { players = { 'heron', 'tern' }, continues = 1,\n"
    "  modes = { { name = 'story', stages = { 'one', 'two' }, text = 'Both stages.' },\n"
    "            { name = 'doom', stages = { 'end' }, text = 'The end.' } },\n"
    "  difficulties = { calm = 'For a calm dive.' },\n"
    "  ships = { heron = { text = 'Fast.' }, tern = { title = 'GREY TERN', figures = { { 'Range', 4 } } } },\n"
    "  staff = { { 'ART', 'A. Heron', 'B. Tern' }, { 'THE END' } } }\n";

/* ---- the way through ---- */

/* Opens the main menu, and from there the page start. */
static void open_start(int players)
{
    soon("Press Start", 60);
    assert_true(board_last_output(r.b)->key_hint_count > 0);
    press(PAD_START, 0);
    soon(players > 1 ? "2 Players" : "Settings", 20);
    if (players > 1)
        press(PAD_DOWN, 0);
    press(PAD_FIRE, 0);
    soon("Mode", 20);
    gone("Press Start");
    assert_true(board_last_output(r.b)->key_hint_count > 0);
}

/* Starts the first or the second mode on `wild`; player 2 takes the other ship. */
static void start(int players, bool doom)
{
    open_start(players);
    soon("Both stages.", 20);
    if (doom)
        press(0, PAD_RIGHT); /* a row that the players share answers to both */
    soon(doom ? "The end." : "Both stages.", 10);
    press(PAD_DOWN, 0);
    soon("For a calm dive.", 10);
    press(PAD_RIGHT, 0);
    soon("Wild", 5);
    gone("For a calm dive.");
    press(PAD_DOWN, 0);
    soon("Fast.", 5);
    press(0, players > 1 ? PAD_RIGHT : 0);
    soon(players > 1 ? "GREY TERN" : "Heron", 5);
    assert_true(players == 1 ? at("Lives") >= 0 : at("2P") >= 0 && at("Range") >= 0);
    press(PAD_FIRE, 0);
    soon("STAGE", 60);
    assert_false(board_last_output(r.b)->key_hint_count > 0);
}

static void through_all(int w, int h, int field_w, int players)
{
    open_sized(run_all, w, h, field_w, players);
    start(players, false);
    soon("Stage One Clear", 300);
    assert_true(at("Stage One Clear") % 1000 < field_w / 8);
    frames(100);
    assert_true(at("500") >= 0 && at("Graze") >= 0);
    assert_true(players == 1 || at("Player 2") >= 0);
    press(PAD_FIRE, 0);
    soon("Stage Two Clear", 500);
    frames(100);
    press(PAD_FIRE, 0);
    soon("CCLLEEAARR", 60); /* large letters */
    soon("Congratulations!", 300);
    frames(100);
    press(PAD_FIRE, 0);
    soon("A. Heron", 300);
    press(PAD_START, 0);
    soon("Enter Your Name", 60);
    frames(20);
    press(PAD_UP, PAD_FIRE);
    press(PAD_FIRE, PAD_FIRE);
    press(PAD_FIRE, PAD_FIRE);
    assert_true(at("Time: ") >= 0);
    press(PAD_START, PAD_START);
    soon("Scores", 60);
    soon("Wild", 5);
    soon("500", 30);
    assert_true(players == 1 || (at("AAAA") >= 0 && at(" 70") >= 0));
    assert_int_equal(r.b->player.in_game[0], 0);
    assert_true(r.b->sprites.s.live <= 1); /* the plate behind the table */
    frames(30);
    press(PAD_FIRE, 0);
    soon("Restart", 60);
    assert_true(at("All Clear") >= 0);
    soon("Quit to Title", 10);
    press(PAD_DOWN, 0);
    press(PAD_FIRE, 0);
    soon("Scores", 400); /* in the title's menu */
    close_game();
}

TEST(all)
{
    through_all(240, 320, 240, 1);
    through_all(240, 320, 240, 2);
    through_all(320, 240, 208, 2);
    through_all(640, 448, 384, 2);
}

/* Retry after a game plays it again with the same choices; back leads to the title's menu. */
TEST(retry)
{
    open_sized(run_all, 240, 320, 240, 1);
    start(1, true);
    soon("Restart", 2000);
    assert_true(at("Game Over") >= 0 && board_last_output(r.b)->key_hint_count > 0);
    frames(10);
    press(PAD_FIRE, 0);
    soon("STAGE END", 20);
    assert_int_equal(board_current_difficulty(r.b), 1);
    soon("Restart", 2000);
    frames(10);
    press(PAD_BOMB, 0);
    soon("Settings", 20); /* in the title's menu */
    close_game();
}

/* START on the title, START in the menu and START on the page with the choices of last time: a run begins. */
TEST(three_presses)
{
    open_sized(run_all, 240, 320, 240, 1);
    start(1, true);
    soon("Restart", 2000);
    frames(10);
    press(PAD_BOMB, 0);
    soon("Settings", 20);
    frames(20);
    press(PAD_BOMB, 0);
    soon("Press Start", 60);
    press(PAD_START, 0);
    frames(20);
    press(PAD_START, 0);
    frames(20);
    press(PAD_START, 0);
    soon("STAGE END", 10);
    assert_int_equal(board_current_difficulty(r.b), 1);
    close_game();
}

/* Checks what the last tick told the program about the buttons: "fire Select, bomb Back". */
static void expect_keys(const char *expected)
{
    static const char *const names[] = PAD_BUTTON_NAMES;
    const struct board_out *out = board_last_output(r.b);
    char got[256] = "";

    for (int i = 0; i < out->key_hint_count; i++)
        snprintf(got + strlen(got), sizeof got - strlen(got), "%s%s %s", i ? ", " : "", names[out->key_hint[i].button],
                 out->key_hint[i].meaning);
    assert_string_equal(got, expected);
}

/* The title tells the keys of the game, a page and the menu what they do there. A page also writes that, 4 px above the
 * lower edge. */
TEST(keys)
{
    open_sized(run_all, 320, 240, 320, 1);
    open_start(1);
    expect_keys("fire Start, bomb Back");
    assert_int_equal(at("Fire: Start  Bomb: Back") / 1000, 240 / 8 - 2);
    press(PAD_BOMB, 0);
    soon("Settings", 20);
    expect_keys("fire Select, bomb Back");
    press(PAD_BOMB, 0);
    soon("Press Start", 30);
    expect_keys("start Start");
    press(PAD_START, 0);
    soon("Settings", 30);
    press(PAD_UP, 0);
    press(PAD_UP, 0);
    press(PAD_FIRE, 0);
    soon("< Move >", 10);
    expect_keys("right Next, left Previous, bomb Back");
    press(PAD_RIGHT, 0);
    soon("< Fire >", 10);
    expect_keys("right Next, left Previous, fire Fire, bomb Back");
    press(PAD_RIGHT, 0);
    soon("< Focus >", 10);
    expect_keys("right Next, left Previous, focus Focus, bomb Back");
    assert_true(at("Right: Next  Left: Previous") >= 0 && at("Focus: Focus") < 0);
    close_game();
}

/* Bomb goes back one page at a time, to the entry that led there; a page that nobody answers gives up. */
TEST(back)
{
    open_sized(run_all, 240, 320, 240, 2);
    open_start(2);
    frames(30);
    press(0, PAD_BOMB);
    soon("2 Players", 30);
    frames(10);
    press(PAD_FIRE, 0);
    soon("2P", 30);
    press(PAD_BOMB, 0);
    soon("2 Players", 30);
    press(PAD_BOMB, 0);
    soon("Press Start", 30);
    frames(10);
    assert_int_equal(screen_get_dim(&r.b->screen, r.b->core.frame), 0);
    press(PAD_START, 0);
    soon("2 Players", 30);
    frames(1801);
    soon("Scores", 60); /* attract mode: the scores, then the title */
    soon("Press Start", 500);
    close_game();
}

/* A locked mode shows its hint and can't be started; its row goes back to an open one when the cursor leaves it. */
TEST(locked)
{
    open_game("unlock.def('deep', { hint = 'Clear stage one', when = { clear = 'one' } })\n"
              "boot.run { players = { 'heron' }, modes = { { name = 'story', stages = { 'one' } },\n"
              "  { name = 'doom', stages = { 'end' }, needs = 'deep' } } }");
    open_start(1);
    press(PAD_RIGHT, 0);
    soon("? ? ?", 5);
    expect_keys("bomb Back");
    soon("Clear stage one", 5);
    press(PAD_FIRE, 0);
    frames(60);
    assert_true(at("? ? ?") >= 0);
    press(PAD_DOWN, 0); /* the row goes back to what is open */
    frames(5);
    gone("Clear stage one");
    gone("? ? ?");
    expect_keys("fire Start, bomb Back");
    press(PAD_FIRE, 0);
    soon("STAGE ONE", 10);
    close_game();
}

/* A game with one mode, difficulty and ship starts at once. */
TEST(one_option)
{
    struct manifest m = rig_manifest();
    static char text[1 << 12];

    snprintf(text, sizeof text, "%sboot.run { players = { 'heron' }, stages = { 'one' } }", kinds);
    rig_script(&g, &m, text);
    rig_power_any(&r, &g, NULL);
    soon("Press Start", 60);
    press(PAD_START, 0);
    soon("How to Play", 20);
    press(PAD_START, 0);
    soon("STAGE ONE", 10);
    close_game();
}

/* The ship on the page start fires its shots, the buttons of a player don't move it, and it leaves with the page. */
TEST(preview)
{
    static const char own[] =
        "shot.def('dart', { sprite = 'dot', hit = { circle = 2 } })\n"
        "player.def('gun', { sprite = 'dot', hit = { circle = 2 }, speed = 4, run = function(p)\n"
        "  while true do if pad.down('fire', p) then shot.fire { kind = 'dart', from = p, speed = 5 } end wait(8) end\n"
        "end })\n"
        "boot.run { players = { 'gun', 'heron' }, stages = { 'one' } }";
    static const uint16_t left[MAX_PLAYERS] = { PAD_LEFT };

    open_game(own);
    soon("Press Start", 60);
    press(PAD_START, 0);
    frames(10);
    press(PAD_START, 0);
    soon("Ship", 10);
    frames(40);
    assert_true(r.b->shots.s.live > 2);
    const fx x = r.b->player.x[0];
    rig_tick(&r, left);
    assert_int_equal(r.b->player.x[0], x);
    press(PAD_BOMB, 0);
    soon("Settings", 10);
    assert_false(r.b->player.in_game[0]);
    assert_int_equal(r.b->shots.s.live, 0);
    close_game();
}

/* How to Play shows its pages in order, each with a ship that plays by itself; bomb goes back to the menu. */
TEST(how_to_play)
{
    open_sized("bomb.def('b', { over = 60, run = function() wait(60) end })\n"
               "player.def('gun', { sprite = 'dot', hit = { circle = 2 }, graze = 9, bomb = 'b', registers = { bombs = "
               "3 } })\n"
               "boot.run { players = { 'gun' }, stages = { 'one' },\n"
               "  how_to_play = { 'move', { title = 'OWN', text = 'Mine.' }, 'bomb' } }",
               240, 320, 240, 1);
    soon("Press Start", 60);
    press(PAD_START, 0);
    soon("How to Play", 20);
    press(PAD_UP, 0);
    press(PAD_UP, 0);
    press(PAD_FIRE, 0);
    soon("< Move >", 10);
    const fx x = r.b->player.x[0];
    frames(45);
    assert_true(r.b->player.x[0] < x);
    press(PAD_START, 0);
    soon("Mine.", 10);
    assert_false(r.b->player.in_game[0]);
    press(PAD_FIRE, 0); /* turns no page */
    frames(20);
    assert_true(at("2/3") >= 0);
    press(PAD_RIGHT, 0);
    soon("3/3", 10);
    frames(60);
    assert_true(r.b->player.bomb_left[0] > 0);
    expect_keys("right Done, left Previous, bomb Bomb");
    press(PAD_BOMB, 0); /* the button that the page is about leaves no page */
    frames(20);
    assert_true(at("3/3") >= 0 && r.b->player.in_game[0]);
    press(PAD_LEFT, 0);
    soon("Mine.", 10);
    assert_int_equal(r.b->bullets.s.live + r.b->shots.s.live, 0);
    press(PAD_BOMB, 0);
    soon("Settings", 10);
    assert_false(r.b->player.in_game[0]);
    close_game();
}

/* Sends a code, as the program does: in one frame. */
static void send(unsigned code)
{
    rig_tick(&r, (const uint16_t[MAX_PLAYERS]){ (uint16_t)(code << PAD_CODE_SHIFT) });
    frames(1);
}

/* A restart starts the same game again, quitting leaves it without a name; also between stages and while the board is
 * frozen. START means nothing to a game that is played. */
TEST(leaving)
{
    open_game(run_all);
    assert_false(inspect_pause(r.b).is_listening);
    start(1, false);
    assert_true(inspect_pause(r.b).is_listening && inspect_pause(r.b).in_play[0] && !inspect_pause(r.b).in_play[1]);
    press(PAD_START, 0);
    soon("Stage One Clear", 300);
    send(CODE_RESTART);
    gone("Stage One Clear");
    soon("STAGE ONE", 60);
    assert_int_equal(r.b->player.score[0], 0);
    send(CODE_QUIT);
    assert_false(inspect_pause(r.b).is_listening);
    soon("Settings", 60);
    assert_int_equal(r.b->player.in_game[0], 0);
    send(CODE_RESTART); /* nobody listens */
    press(0, 0);
    gone("STAGE ONE");
    close_game();

    open_game(run_all);
    start(1, true);
    soon("Continue?", 600);
    assert_false(inspect_pause(r.b).in_play[0]);
    send(CODE_RESTART);
    gone("Continue?");
    assert_int_equal(r.b->core.frozen, 0);
    assert_int_equal(r.b->player.in_game[0], 1);
    soon("Continue?", 600);
    send(CODE_QUIT);
    soon("Settings", 60);
    close_game();
}

/* The game's own entries in the pause menu: a hit-stop only delays them, each is chosen once, and they run in a task of
 * the game. */
TEST(own_entries)
{
    open_game(
        "stage.def('long', function() wait(900) end)\n"
        "local n = 0\n"
        "local function count() n = n + 1 hud.put(2, 20, 'N' .. n) wait(30) hud.put(2, 21, 'LATER') end\n"
        "boot.run { players = { 'heron' }, stages = { 'long' },\n"
        "  pause = { { 'Stop', function() board.stop(10) end }, { 'Count the shells on the beach \u30a2', count } },\n"
        "  screens = { title = function() wait(1) return 'start' end, start = function() return { difficulty = 'calm' "
        "} "
        "end } }");
    frames(60);
    const struct inspect_pause pause = inspect_pause(r.b);
    assert_int_equal(pause.entry_count, 2);
    assert_string_equal(pause.entries[0], "Stop");
    assert_string_equal(pause.entries[1], "Count the shells on the beach "); /* cut before a character of 3 bytes */
    send(CODE_ENTRY);
    send(CODE_ENTRY + 1);
    gone("N1");
    soon("N1", 15);
    soon("LATER", 40);
    gone("N2");
    send(CODE_ENTRY + 2);
    send(CODE_QUIT);
    frames(5);
    gone("LATER");
    close_game();
}

/* However fast fire is pressed, by hand or by a turbo button: the choices lead into the game. */
TEST(mashed)
{
    static const uint16_t down[MAX_PLAYERS] = { PAD_FIRE };

    for (int every = 2; every <= 12; every++) {
        open_game(run_all);
        soon("Press Start", 60);
        for (int f = 0; f < 60 * every && !r.b->player.in_game[0]; f++)
            rig_tick(&r, f % every < every / 2 ? down : (const uint16_t[MAX_PLAYERS]){ 0 });
        if (!r.b->player.in_game[0])
            fail_msg("fire every %d frames: no game has begun", every);
        close_game();
    }
}

/* Right that is held fills a name, and does not end it. */
TEST(held_in_a_name)
{
    static const uint16_t right[MAX_PLAYERS] = { PAD_RIGHT };

    open_game(
        "boot.run { players = { 'heron' }, stages = { 'one' }, screens = { results = function() end,\n"
        "  title = function() wait(1) return 'start' end, start = function() return { difficulty = 'calm' } end,\n"
        "  ending = function() end } }");
    soon("Enter Your Name", 600);
    for (int f = 0; f < 200; f++)
        rig_tick(&r, right);
    assert_true(at("A A A A A A A A") >= 0 && at("Enter Your Name") >= 0);
    gone("Ready");
    press(PAD_FIRE, 0);
    soon("Scores", 30);
    close_game();
}

/* Presses START in this frame; the list of the title is there then, without another press. */
static void start_leads_to_the_list(void)
{
    const uint16_t down[MAX_PLAYERS] = { PAD_START };

    rig_tick(&r, down);
    for (int f = 0; f < 20; f++) {
        frames(1);
        gone("Press Start");
    }
    gone("ONCE");
    gone("No scores yet.");
    soon("Settings", 1);
    press(PAD_BOMB, 0);
    soon("Press Start", 60);
}

static void until_attract(const char *name)
{
    for (int f = 0; board_last_output(r.b)->request != REQUEST_ATTRACT; f++) {
        assert_true(f < 700);
        frames(1);
    }
    assert_string_equal(board_last_output(r.b)->attract, name);
}

/* START leads to the title's list from each part that is shown while nobody comes: the opening, a demo (which the
 * program ends by that press) and the scores. */
TEST(attract)
{
    open_game("boot.run { players = { 'heron' }, stages = { 'one' }, demos = { 'a', 'b' },\n"
              "  opening = function() hud.centre(3, 'ONCE') wait(600) end }");
    soon("ONCE", 5);
    start_leads_to_the_list();
    until_attract("a");
    start_leads_to_the_list();
    until_attract("b");
    soon("No scores yet.", 10);
    start_leads_to_the_list();
    until_attract("a");
    soon("No scores yet.", 10);
    soon("ONCE", 400);
    start_leads_to_the_list();
    until_attract("b");
    soon("ONCE", 400); /* and when nobody comes, all of it */
    soon("Press Start", 700);
    close_game();
}

/* What is asked for in this frame; HOST_SCREENS: nothing. */
static enum board_host_screen asked(void)
{
    const struct board_out *out = board_last_output(r.b);

    return out->request == REQUEST_HOST_SCREEN ? out->host_screen : HOST_SCREENS;
}

/* Presses until that frame asks, if it does. */
static enum board_host_screen press_asked(uint16_t button)
{
    const uint16_t down[MAX_PLAYERS] = { button };

    for (int i = 0; i < 4; i++) {
        rig_tick(&r, i < 2 ? down : (const uint16_t[MAX_PLAYERS]){ 0 });
        if (asked() != HOST_SCREENS)
            return asked();
    }
    return HOST_SCREENS;
}

/* PRACTICE, REPLAYS, SETTINGS and QUIT are the host's: the game asks once, and the menu stays on the same entry. */
TEST(asks)
{
    open_game(run_all);
    soon("Press Start", 60);
    press(PAD_START, 0);
    soon("Quit Game", 20);
    press(PAD_UP, 0);
    assert_int_equal(press_asked(PAD_FIRE), HOST_SCREEN_QUIT);
    soon("Quit Game", 20);
    press(PAD_UP, 0);
    press(PAD_UP, 0);
    for (int i = 0; i < 3; i++) {
        assert_int_equal(press_asked(PAD_FIRE), HOST_SCREEN_SETTINGS);
        frames(1);
        assert_int_equal(asked(), HOST_SCREENS);
        soon("Settings", 20);
    }
    press(PAD_UP, 0);
    press(PAD_UP, 0);
    assert_int_equal(press_asked(PAD_START), HOST_SCREEN_REPLAYS);
    soon("Replays", 20);
    press(PAD_UP, 0);
    assert_int_equal(press_asked(PAD_START), HOST_SCREEN_PRACTICE);
    soon("Practice", 20);
    assert_int_equal(r.b->player.in_game[0], 0);
    close_game();
}

/* Removes the ship, until the board is frozen; *before: the cells in the frame before that. */
static void until_continue(uint8_t *before, const uint8_t *cells, size_t n)
{
    player_leave(&r.b->player, 0);
    for (int f = 0; at("Continue?") < 0; f++) {
        assert_true(f < 9);
        memcpy(before, cells, n);
        frames(1);
    }
}

/* A screen over a frozen board puts back the text that it covered, every property of it, and the light. */
TEST(puts_back)
{
    static const char own[] =
        "on.start(function() screen.dim { share = 0.25, over = 0 }\n"
        "  for row = 5, 36 do text.put { col = 9, row = row, text = '\u30a2HERE' .. row, bank = 7,\n"
        "    size = row == 21 and 2 or 1, rim = row > 20 } end end)\n"
        "stage.def('long', function() wait(900) end) boot.run { players = { 'heron' }, stages = { 'long' }, continues "
        "= 1,\n"
        "  screens = { title = function() wait(1) return 'start' end, start = function() return {"
        "difficulty = 'calm' } end } }";
    static const size_t first = 5 * 30, n = 30 * 30; /* the rows between those of the HUD */
    static uint8_t before[4][40 * 30];

    for (int c = 0; c < 4; c++) {
        widens = true;
        open_game(own);
        widens = false;
        const struct fix *f = &r.b->fix;
        const uint8_t *const columns[] = { (const uint8_t *)f->code, (const uint8_t *)f->style, f->font,
                                           (const uint8_t *)f->page };
        frames(200);
        until_continue(before[c], columns[c], sizeof before[c]);
        gone("HERE20");
        press(PAD_START, 0);
        assert_memory_equal(before[c] + first, columns[c] + first, n);
        frames(10);
        assert_int_equal(screen_get_dim(&r.b->screen, r.b->core.frame), FX_ONE / 4);
        close_game();
    }
}

/* Plates, sprites of the layer over and lines that are seen. */
static int over_all(void)
{
    int n = 0;

    EACH_LIVE (i, &r.b->sprites.s)
        n += r.b->sprites.layer[i] >= LAYER_OVER && !(r.b->sprites.flags[i] & SPRITE_HIDDEN);
    EACH_LIVE (i, &r.b->lines.s)
        n += !(r.b->lines.flags[i] & LINE_HIDDEN);
    return n;
}

/* Nothing of the game is drawn over a window, or bright beside it: a portrait, a plate with its words and a line are
 * away while it is there. What stands beside the field stays. */
TEST(nothing_over)
{
    static const char own[] = "talk.def('sen', { name = 'SEN', faces = { calm = 'wink' } })\n"
                              "stage.def('long', function()\n"
                              "  text.line { x = 60, y = 160, text = 'A LINE' }\n"
                              "  sprite.put { sprite = 'dot', x = 240, y = 9, layer = 'over', screen = true }\n"
                              "  sprite.plate { x = 216, y = 40, w = 80, h = 40, front = true }\n"
                              "  text.put { col = 28, row = 6, text = 'PANEL' }\n"
                              "  say('sen', 'WORDS', { letter = 0 })\n"
                              "end)\n"
                              "boot.run { players = { 'heron' }, stages = { 'long' }, continues = 1,\n"
                              "  screens = { title = function() wait(1) return 'start' end, start = function() return {"
                              "difficulty = 'calm' } end } }";
    static uint8_t before[40 * 40];
    const int panel = 2, window = 1, talk = 3; /* a dot and a plate; a plate; a portrait, a plate and the line */

    lines_of_board = 8;
    open_sized(own, 320, 320, 208, 1);
    lines_of_board = 0;
    soon("WORDS", 60);
    frames(60);
    const int over = over_all();
    assert_true(over >= panel + talk);
    until_continue(before, r.b->fix.code, sizeof before);
    frames(20);
    gone("WORDS");
    assert_true(at("PANEL") >= 0);
    assert_int_equal(over_all(), panel + window);
    press(PAD_START, 0);
    assert_int_equal(over_all(), over);
    assert_memory_equal(before + 3 * 40, r.b->fix.code + 3 * 40, sizeof before - 6 * 40); /* without the HUD's rows */
    close_game();
}

/* How far plates and the screen's sprites reach to the right in some frames, px; except those in a panel. */
static int reach_right(int n)
{
    const struct sprites *s = &r.b->sprites;
    int most = 0;

    for (; n > 0; n--) {
        frames(1);
        EACH_LIVE (i, &s->s) {
            const int w = s->layer[i] >= LAYER_PLATE ? s->sprite[i] : r.b->sprite_images[s->sprite[i]].w;
            const bool in_panel = fx_floor(s->x[i]) >= r.b->cart.manifest.field_w && s->layer[i] == LAYER_PLATE;
            if (s->flags[i] & SPRITE_SCREEN && !in_panel && fx_floor(s->x[i]) + w > most)
                most = fx_floor(s->x[i]) + w;
        }
    }
    return most;
}

/* A warning stays in the field when there is a panel next to it; otherwise its bars have no ends. A talk uses the whole
 * screen. */
TEST(beside_a_panel)
{
    static const char own[] = "enemy.def('e', { sprite = 'dot', hit = { circle = 3 } })\n"
                              "boss.def('b', { title = 'B', kind = 'e', x = 90, y = 60, warning = 90, phases = {\n"
                              "  { id = 'p', hp = 9, time = 9, run = function() end } } })\n"
                              "talk.def('sen', { name = 'SEN', faces = { calm = 'wink' }, side = 'right' })\n"
                              "stage.def('s', function() boss.fight 'b' say('sen', 'WORDS') end)\n"
                              "boot.run { players = { 'heron' }, stages = { 's' },\n"
                              "  screens = { title = function() wait(1) return 'start' end, start = function() return "
                              "{ difficulty = 'calm' } end } }";

    for (int panel = 0; panel < 2; panel++) {
        open_sized(own, 320, 320, panel ? 208 : 320, 1);
        soon("WARNING", 120);
        const int warned = reach_right(40);
        assert_int_equal(warned, panel ? 208 : 328);
        soon("WORDS", 600);
        assert_in_range(reach_right(1), 209, 320);
        close_game();
    }
}

/* The window counts down, faster with bomb; START goes on, and without a continue the game is over. */
TEST(continue)
{
    open_game(run_all);
    start(1, true);
    soon("Continue?", 600);
    assert_true(at("Continues Left: 1") >= 0 && at("9") >= 0);
    uint32_t clock = r.b->core.clock;
    press(PAD_BOMB, 0);
    frames(30);
    assert_true(at("8") >= 0);
    assert_int_equal(r.b->core.clock, clock);
    press(PAD_START, 0);
    frames(5);
    gone("Continue?");
    soon("GGAAMMEE", 900); /* large letters */
    gone("Continue?");
    soon("Enter Your Name", 300); /* it is worth a point, so that tables tell */
    close_game();
}

/* ---- pages of the game's own, and grades ---- */

/* The message is longer than a line of tests/scripts. */
TEST(wrong_answer)
{
    open_game("boot.run { stages = { 'one' }, players = { 'heron' },\n"
              "  screens = { title = function() wait(1) return 'strat' end } }");
    frames(20);
    assert_non_null(rig_fault(&r));
    assert_string_equal(rig_fault(&r)->message, "main.lua:9: boot.run: screen title: expected one of start, practice, "
                                                "replays, scores, settings, how_to_play, quit, or nil, got "
                                                "\"strat\" (did you mean \"start\"?)");
    rig_close(&r);
}

/* The row of a text. */
static int row_of(const char *text)
{
    return at(text) < 0 ? -1 : at(text) / 1000;
}

/* A list that is too long for the title has its rows 12 px apart, and scrolls. */
TEST(long_title)
{
    static const char own[] = "local pages = {} for i = 1, 16 do pages[i] = { name = 'page_' .. string.char(64 + i),\n"
                              "  show = function() wait(forever) end } end\n"
                              "boot.run { stages = { 'one' }, players = { 'heron' }, pages = pages }";

    open_sized(own, 320, 240, 320, 1);
    soon("Press Start", 5);
    press(PAD_START, 0);
    soon("Page B", 20);
    assert_in_range(row_of("Page B") - row_of("Page A"), 1, 2);
    gone("Settings");
    press(PAD_UP, 0); /* the last one */
    soon("Quit Game", 20);
    assert_int_equal(row_of("Quit Game") - row_of("Settings"), 3);
    assert_in_range(row_of("Quit Game"), 1, 240 / 8 - 3);
    gone("Page A");
    press(PAD_DOWN, 0);
    soon("Page A", 20);
    close_game();
}

static const char with_pages[] =
    "boot.run { stages = { 'one', 'two' }, players = { 'heron' },\n"
    "  pages = { { name = 'tips', show = function(row, rows)\n"
    "    sprite.put { sprite = 'dot', x = 9, y = 9 } text.put { col = 3, row = row, text = 'INSIDE ' .. rows }\n"
    "    while true do wait(1) end end } },\n"
    "  grades = function(stage, p) return p.lives and stage == 'one' and 'S' or 'B' end }\n";

/* The list has the page by its name; what it puts goes with it. A grade stands large below the values. */
TEST(pages)
{
    open_sized(with_pages, 240, 320, 240, 1);
    soon("Press Start", 5);
    press(PAD_START, 0);
    soon("Tips", 20);
    for (int i = 0; i < 4; i++)
        press(PAD_DOWN, 0);
    press(PAD_FIRE, 0);
    soon("INSIDE 29", 20);
    assert_int_equal(at("INSIDE 29") % 1000, 3);
    soon("Bomb: Back", 40);
    assert_int_equal(r.b->sprites.s.live, 2); /* its frame, and the dot */
    press(PAD_BOMB, 0);
    soon("Tips", 20);
    gone("INSIDE");
    for (int i = 0; i < 4; i++)
        press(PAD_UP, 0);
    press(PAD_FIRE, 0);
    soon("Difficulty", 20);
    press(PAD_FIRE, 0);
    soon("Stage One Clear", 200);
    gone("Grade");
    soon("Grade", 120);
    soon("SS", 5); /* a letter of two cells by two */
    press(PAD_FIRE, 0);
    soon("Stage Two Clear", 200);
    soon("BB", 200);
    close_game();
}

/* ---- any frame of any screen can be taken back ---- */

TEST(snapshots)
{
    static const uint16_t pads[] = { PAD_START, PAD_FIRE, PAD_DOWN, PAD_FIRE, PAD_RIGHT, PAD_FIRE, PAD_UP, PAD_BOMB };
    struct rng rng;
    struct rig b;

    open_sized(run_all, 240, 320, 240, 2);
    rig_power(&b, &g, NULL);
    rng_seed(&rng, 3);
    for (int f = 0; f < 6000; f++) {
        uint16_t now[MAX_PLAYERS] = { 0 };
        for (int p = 0; p < MAX_PLAYERS; p++)
            if (f % 16 < 2)
                now[p] = pads[(f / 16 * 7 + p * 3) % 8];
        rig_tick(&r, now);
        if (f % 3 == 0)
            rig_spoil(&b);
        rig_tick(&b, now);
        if (rig_fault(&r))
            fail_msg("%s", rig_fault(&r)->message);
        if (f % 3 == 0 && rig_differs(&r, &b))
            fail_msg("frame %d: %s differs after snapshot and restore", f + 1, rig_differs(&r, &b));
    }
    rig_free(&b);
    close_game();
}

RUN_TESTS(NULL, NULL)
