/*
 * test_overlay.c - the overlay over pictures of a known scene: every line of every panel can be read, wherever the
 * mouse is; the times add up; the console types, answers, undoes and keeps.
 */
#include "rig.h"
#include "../../src/board/inspect.h"
#include "../../src/player/overlay/console.h"
#include "../../src/player/overlay/overlay.h"
#include "words.h"

static const char scene[] = "bullet.def('rice', { sprite = 'dot', hit = { circle = 4 } })\n"
                            "enemy.def('fly', { sprite = 'dot', hp = 5, hit = { box = { 30, 20 } } })\n"
                            "player.def('ship', { sprite = 'dot', hit = { circle = 2 }, graze = 20, safe = 0 })\n"
                            "motion.def { name = 'swerve', { wait = 500 }, { turn = 1, over = 30 } }\n"
                            "task.go(function()\n"
                            "  string.sys.join(1, 'ship')\n"
                            "  player.get(1).x, player.get(1).y = 100, 150\n"
                            "  enemy.spawn { kind = 'fly', x = 60, y = 30, tag = 'flies' }\n"
                            "  bullet.fire { kind = 'rice', x = 180, y = 200, dir = 90, speed = 0, tag = 'lone',\n"
                            "                motion = 'swerve' }\n"
                            "  for i = 1, 200 do rng.int(1, 6) wait(1) end\n"
                            "end)\n"
                            "for i = 1, 9 do task.go(function() wait(100 + i) end) end\n";

struct bed {
    struct rig_game g;
    struct rig r;
    uint32_t rgb[256];
    struct canvas canvas;
    struct overlay o;
    struct console c;
};

static void bed_power(struct bed *t, int w, int h)
{
    struct manifest m = rig_manifest();

    m.screen_w = m.field_w = w;
    m.screen_h = m.field_h = h;
    rig_with_sys(&t->g, &m, scene);
    rig_power(&t->r, &t->g, NULL);
    rig_run(&t->r, 10);
}

static int bed_open(void **state)
{
    struct bed *t = calloc(1, sizeof *t);

    bed_power(t, 240, 320);
    *state = t;
    return 0;
}

static void bed_drop(struct bed *t)
{
    rig_free(&t->r);
    rig_game_free(&t->g);
}

static int bed_close(void **state)
{
    struct bed *t = *state;

    console_close(&t->c);
    bed_drop(t);
    free(t);
    return 0;
}

static void draw(struct bed *t, int y0, int y1, int mouse_x, int mouse_y)
{
    board_draw(t->r.b, NULL, &t->r.fb, t->rgb, t->r.scratch);
    canvas_open(&t->canvas, &t->r.fb, t->rgb);
    const struct overlay_target at = { &t->canvas, NULL, y0, y1 };
    overlay_draw(&t->o, &at, t->r.b, mouse_x, mouse_y);
}

static bool sees(const struct bed *t, const char *text)
{
    return words_seen(&t->canvas, text, NULL, NULL);
}

static void must_see(const struct bed *t, const char *text)
{
    if (!sees(t, text))
        fail_msg("\"%s\" is not on the picture", text);
}

static void all_on(struct bed *t)
{
    overlay_toggle(&t->o, 1u << HOTKEY_HITBOXES | 1u << HOTKEY_GAUGES | 1u << HOTKEY_FRAME_TIMES | 1u << HOTKEY_TASKS);
}

/* ---- panels ---- */

static int inked(const struct bed *t)
{
    int n = 0;

    for (int i = 0; i < t->r.fb.w * t->r.fb.h; i++)
        for (int c = 0; c < CANVAS_COLOURS; c++)
            n += t->r.fb.pix[i / t->r.fb.w * t->r.fb.pitch + i % t->r.fb.w] == t->canvas.colour[c];
    return n;
}

static void see_gauges(const struct bed *t)
{
    must_see(t, "part          live   top   cap refused");
    must_see(t, "tasks           10    64    64       0");
    must_see(t, "bullets          1    64   256       0");
    must_see(t, "bullet_kinds     1     1  1024       0");
    must_see(t, "sparks           0     0   128       0");
    assert_false(sees(t, "nvram"));
}

static void check_thing(struct bed *t, int mouse_x, int mouse_y, const char *const *lines)
{
    draw(t, 0, t->r.fb.h, mouse_x, mouse_y);
    for (; *lines; lines++)
        must_see(t, *lines);
}

TEST(the_thing_under_the_mouse_is_told)
{
    static const char *const bullet[] = { "bullet 0",
                                          "kind   rice",
                                          "tag    lone",
                                          "at     180.00, 200.00",
                                          "age    10",
                                          "speed  0.000 dir 90.00",
                                          "motion swerve step 1/2, 490 left",
                                          "by     task 1 main.lua:11",
                                          NULL };
    static const char *const enemy[] = { "enemy 0", "kind   fly", "tag    flies", "hp     5", NULL };
    static const char *const player[] = { "player 1", "kind   ship", "lives  2", NULL };
    struct bed *t = *state;

    t->o.on[OVERLAY_HITBOXES] = true;
    check_thing(t, 181, 201, bullet);
    check_thing(t, 70, 35, enemy);
    check_thing(t, 100, 150, player);
    rig_run(&t->r, 250);
    static const char *const orphan[] = { "by     task 1, ended", NULL };
    check_thing(t, 181, 201, orphan);
    draw(t, 0, 320, 120, 270);
    assert_false(sees(t, "kind"));
    draw(t, 0, 320, -1, -1);
    assert_false(sees(t, "kind"));
}

/* With everything on and the mouse anywhere, whatever could be read without the mouse still can. */
TEST(panels_do_not_hide_each_other)
{
    static const int sizes[][2] = { { 240, 320 }, { 320, 240 } };
    struct bed *t = *state;

    bed_drop(t);
    all_on(t);
    for (int s = 0; s < 2; s++) {
        bed_power(t, sizes[s][0], sizes[s][1]);
        for (int i = 0; i < 60; i++) {
            draw(t, 8, t->r.fb.h, i * 67 % t->r.fb.w, i * 41 % t->r.fb.h);
            see_gauges(t);
            must_see(t, "scripts     0     0");
            must_see(t, "frame       0     0");
            must_see(t, "frame 10  random numbers 10  tasks 10");
            must_see(t, "     1     1 -           main.lua:11");
        }
        if (s == 0)
            bed_drop(t);
    }
}

/* A bullet's circle of radius 4 is a ring of pixels whose middles are inside, none of whose neighbours outwards is. */
TEST(shapes_lie_where_they_hit)
{
    struct bed *t = *state;

    t->o.on[OVERLAY_HITBOXES] = true;
    draw(t, 0, 320, -1, -1);
#define COLOUR(x, y) t->r.fb.pix[(y)*t->r.fb.pitch + (x)]
    assert_int_equal(COLOUR(176, 200), t->canvas.colour[CANVAS_RED]);
    assert_int_equal(COLOUR(183, 199), t->canvas.colour[CANVAS_RED]);
    assert_int_equal(COLOUR(175, 200), t->canvas.colour[CANVAS_DARK]);
    assert_int_equal(COLOUR(45, 20), t->canvas.colour[CANVAS_YELLOW]);
    assert_int_equal(COLOUR(74, 39), t->canvas.colour[CANVAS_YELLOW]);
    assert_int_equal(COLOUR(80, 150), t->canvas.colour[CANVAS_WHITE]);
    assert_int_equal(COLOUR(98, 150), t->canvas.colour[CANVAS_GREEN]);
    draw(t, 0, 320, 181, 201);
    assert_int_equal(COLOUR(176, 200), t->canvas.colour[CANVAS_WHITE]);
    draw(t, 21, 320, -1, -1); /* nothing over what is not its own */
    assert_true(COLOUR(60, 20) != t->canvas.colour[CANVAS_YELLOW]);
    assert_int_equal(COLOUR(60, 39), t->canvas.colour[CANVAS_YELLOW]);
}

/* A ship's hit shape is white to the pixel, in a red ring in a dark one; of a second player in a cyan one. What is not
 * seen has none; a shake takes it along. */
TEST(ships_show_where_they_are_hit)
{
    struct bed *t = *state;
    struct player *p = &t->r.b->player;

    draw(t, 0, 320, -1, -1);
    overlay_draw_hitboxes(&t->canvas, t->r.b);
    assert_int_equal(COLOUR(99, 149), t->canvas.colour[CANVAS_WHITE]); /* at 100, 150, of 2 px */
    assert_int_equal(COLOUR(101, 150), t->canvas.colour[CANVAS_WHITE]);
    assert_int_equal(COLOUR(102, 150), t->canvas.colour[CANVAS_RED]);
    assert_int_equal(COLOUR(100, 147), t->canvas.colour[CANVAS_RED]);
    assert_int_equal(COLOUR(103, 150), t->canvas.colour[CANVAS_DARK]);
    assert_int_equal(inked(t), 12 + 20 + 20);
    t->r.b->screen = (struct screen){ .s = t->r.b->screen.s, .shake = 8, .shake_frames = 1, .shake_aimed = 1 };
    t->r.b->screen.shake_start = t->r.b->core.clock - 1; /* its first frame: 8 px to the right */
    draw(t, 0, 320, -1, -1);
    overlay_draw_hitboxes(&t->canvas, t->r.b);
    assert_int_equal(COLOUR(107, 149), t->canvas.colour[CANVAS_WHITE]);
    assert_true(COLOUR(99, 149) != t->canvas.colour[CANVAS_WHITE]);
    screen_reset(&t->r.b->screen);
    p->in_game[1] = p->in_game[0];
    p->x[1] = 30 << 16;
    p->y[1] = -(1 << 16); /* half of it beyond the field */
    draw(t, 0, 320, -1, -1);
    overlay_draw_hitboxes(&t->canvas, t->r.b);
    assert_int_equal(COLOUR(30, 1), t->canvas.colour[CANVAS_CYAN]);
    assert_int_equal(COLOUR(30, 0), t->canvas.colour[CANVAS_WHITE]);
    p->flags[0] |= PLAYER_HIDDEN;
    p->in_game[1] = 0;
    draw(t, 0, 320, -1, -1);
    overlay_draw_hitboxes(&t->canvas, t->r.b);
    assert_int_equal(inked(t), 0);
}

/* What a frame took is the sum of its steps, and a guard counts only while times are shown. */
TEST(frame_times_add_up)
{
    const uint16_t none[MAX_PLAYERS] = { 0 };
    struct bed *t = *state;
    const struct frame_times *s = &t->o.frame_times;
    struct guard a;
    struct board_start start = { .seed = 3, .difficulty = -1 };
    char err[256];
    uint64_t sum = 0;

    all_on(t);
    assert_true(guard_power(&a, &t->g.image.rom, &start, err, sizeof err));
    for (int f = 0; f < 3 * FRAME_TIMES_WINDOW; f++) {
        overlay_begin_frame(&t->o, &a);
        guard_tick(&a, none);
        for (int step = STEP_PROGRAM; step < STEPS; step++)
            overlay_add_time(&t->o, step);
        overlay_end_frame(&t->o);
    }
    for (int i = 0; i < STEPS; i++) {
        assert_true(s->shown_max[i] >= s->shown_mean[i]);
        sum += s->shown_mean[i];
    }
    assert_true(s->shown_frame_mean == sum && s->shown_frame_max >= s->shown_frame_mean);
    overlay_toggle(&t->o, 1u << HOTKEY_FRAME_TIMES);
    overlay_begin_frame(&t->o, &a);
    assert_null(a.before);
    guard_close(&a);
}

/* ---- the console ---- */

enum { ENTER = 40, ESCAPE = 41, BACKSPACE = 42, HOME = 74, DELETE = 76, END = 77, RIGHT = 79, LEFT = 80, DOWN, UP };

static struct keys_state polled(struct bed *t, unsigned key, const char *text, uint32_t pressed)
{
    struct plat_input in = { .has_focus = true };
    struct keys_state k = { .pressed = pressed, .held = pressed, .pads = { 16 } };

    if (key)
        in.keys[key >> 3] = (uint8_t)(1u << (key & 7));
    snprintf(in.text, sizeof in.text, "%s", text);
    console_poll(&t->c, &in, &k, t->r.b, true);
    return k;
}

static void press(struct bed *t, unsigned key)
{
    polled(t, key, "", 0);
    polled(t, 0, "", 0);
}

static void type(struct bed *t, const char *text)
{
    for (; *text; text++) {
        const char one[2] = { *text, 0 };
        polled(t, 0, one, 0);
    }
}

static void enter(struct bed *t, const char *line)
{
    type(t, line);
    press(t, ENTER);
}

static void toggle(struct bed *t)
{
    polled(t, 53, "`", 1u << HOTKEY_CONSOLE);
    polled(t, 0, "", 0);
}

static int draw_console(struct bed *t)
{
    board_draw(t->r.b, NULL, &t->r.fb, t->rgb, t->r.scratch);
    canvas_open(&t->canvas, &t->r.fb, t->rgb);
    return console_draw(&t->c, &t->canvas);
}

TEST(it_opens_types_and_answers)
{
    struct bed *t = *state;

    toggle(t);
    struct keys_state k = polled(t, 0, "", 1u << HOTKEY_PAUSE);
    assert_true(k.pressed == 0 && k.pads[0] == 0);
    enter(t, "nonsense(");
    enter(t, "20 + 3, 'a'");
    type(t, "and so on");
    assert_true(draw_console(t) < 320);
    must_see(t, "unexpected symbol near <eof>");
    must_see(t, "> 20 + 3, 'a'");
    must_see(t, "23  a");
    must_see(t, "> and so on");
    press(t, ESCAPE);
    assert_false(t->c.open);
    k = polled(t, 0, "x", 0);
    assert_int_equal(k.pads[0], 16);
    toggle(t);
    assert_string_equal(t->c.line, "and so on");
    console_poll(&t->c, &(struct plat_input){ .has_focus = true }, &k, NULL, true); /* no board any more */
    assert_false(t->c.open);
}

TEST(keys_edit_the_line)
{
    struct bed *t = *state;

    toggle(t);
    type(t, "abcd");
    press(t, BACKSPACE);
    press(t, LEFT);
    type(t, "x");
    assert_string_equal(t->c.line, "abxc");
    press(t, HOME);
    press(t, DELETE);
    press(t, LEFT);
    type(t, "(\xC3\xA9\t)");
    assert_string_equal(t->c.line, "()bxc");
    press(t, END);
    press(t, RIGHT);
    press(t, DELETE);
    type(t, "!");
    assert_string_equal(t->c.line, "()bxc!");
    for (int i = 0; i < 200; i++) /* held: again and again */
        polled(t, BACKSPACE, "", 0);
    assert_string_equal(t->c.line, "");
    for (int i = 0; i < 2 * CONSOLE_LINE_SIZE; i++)
        type(t, "y");
    assert_int_equal(strlen(t->c.line), CONSOLE_LINE_SIZE - 1);
    draw_console(t);
}

TEST(lines_come_back)
{
    char line[16];
    struct bed *t = *state;

    toggle(t);
    press(t, UP);
    assert_string_equal(t->c.line, "");
    enter(t, "1");
    enter(t, "2");
    enter(t, "2"); /* once */
    press(t, UP);
    press(t, UP);
    press(t, UP);
    assert_string_equal(t->c.line, "1");
    press(t, DOWN);
    assert_string_equal(t->c.line, "2");
    press(t, DOWN);
    assert_string_equal(t->c.line, "");
    for (int i = 0; i < 3 * CONSOLE_HISTORY; i++) {
        snprintf(line, sizeof line, "%d", i);
        enter(t, line);
    }
    for (int i = 0; i < 2 * CONSOLE_HISTORY; i++)
        press(t, UP);
    snprintf(line, sizeof line, "%d", 2 * CONSOLE_HISTORY);
    assert_string_equal(t->c.line, line);
}

TEST(a_line_is_undone_unless_it_is_kept)
{
    struct bed *t = *state;
    uint64_t hash = board_hash(t->r.b);

    toggle(t);
    enter(t, "player.get(1).x = 33");
    enter(t, "while true do end");
    enter(t, "keep player.get(1).x = 33 error('no')");
    enter(t, "keep player.get(1).x = 33 nonsense");
    assert_false(console_take_kept(&t->c));
    assert_true(board_hash(t->r.b) == hash);
    enter(t, "keep player.get(1).x = 33");
    assert_true(console_take_kept(&t->c));
    assert_false(console_take_kept(&t->c));
    assert_true(board_hash(t->r.b) != hash);
    enter(t, "player.get(1).x");
    draw_console(t);
    must_see(t, "33.0");
    rig_run(&t->r, 20);
}

/* Long answers and many of them, on pictures of any size. */
TEST(whatever_is_said_is_drawn)
{
    struct bed *t = *state;

    toggle(t);
    enter(t, "string.rep('word ', 900)");
    enter(t, "string.rep('x', 4000)");
    enter(t, "for i = 1, 400 do print(i) end");
    draw_console(t);
    must_see(t, "400");
    bed_drop(t);
    bed_power(t, 64, 64);
    draw_console(t);
    all_on(t);
    draw(t, 0, 64, 20, 20);
    draw(t, 60, 20, 20, 20);
}

RUN_TESTS_EACH(bed_open, bed_close)
