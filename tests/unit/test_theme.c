/* test_theme.c - theme.h and a canvas with a theme: defaults made of the game, the lump, contrast, the game's glyphs,
 * and the frame. */
#include "../test.h"
#include "../../src/base/bytes.h"
#include "../../src/player/overlay/canvas.h"
#include "../../src/rom/theme.h"

enum {
    W = 120,
    H = 64,
    GLYPHS = 80, /* of text cells: up to 'o' */
    SIDE = 9,    /* px of the frame's picture */
    PITCH = 16,
    TALL = 20, /* px, the height of the font "tall" */
    FACE_SIZE = FACE_HEADER_SIZE + FACE_GLYPH_SIZE + 8 * 12,
    INK = 0xE0E8FF,
    AMBER = 0xF8D838,
    PAPER = 0x101830
};

static struct game {
    struct manifest m;
    uint8_t manifest[MANIFEST_BYTES], palette[CART_PALETTE_SIZE], font[GLYPHS * CART_GLYPH_SIZE], face[FACE_SIZE],
        frame[CART_GFX_HEADER_SIZE + PITCH * SIDE], theme[THEME_SIZE];
    struct art_theme settings;
    bool has_font, has_theme;
    uint32_t theme_size;
} game;

static struct {
    void *block;
    struct rom rom;
    struct cart cart;
    struct theme theme;
    char err[256];
} opened;

static void set_colour(int i, uint32_t rgb)
{
    game.palette[3 * i] = (uint8_t)(rgb >> 16);
    game.palette[3 * i + 1] = (uint8_t)(rgb >> 8);
    game.palette[3 * i + 2] = (uint8_t)rgb;
}

/* Sets shades 2 to 15 of a bank to a colour, and shade 1 to another. */
static void set_bank(int bank, uint32_t rgb, uint32_t dark)
{
    set_colour(16 * bank + 1, dark);
    for (int i = 2; i < 16; i++)
        set_colour(16 * bank + i, rgb);
}

/* 'H' of the cells: a bar of shade 12 in rows 1 to 6, with a shadow in row 7. */
static void draw_cells(void)
{
    uint8_t *h = game.font + ('H' - CART_FIRST_CHAR) * CART_GLYPH_SIZE;

    memset(h + 8, 12, 6 * 8);
    memset(h + 56, 1, 8);
}

/* The font "tall" has an H of 8 x 12 px, 5 px below the line's top. */
static void draw_face(void)
{
    uint8_t *g = game.face + FACE_HEADER_SIZE;

    bytes_put16(game.face, TALL);
    bytes_put32(game.face + 4, 1);
    bytes_put32(g, 'H');
    bytes_put32(g + 4, FACE_HEADER_SIZE + FACE_GLYPH_SIZE);
    g[8] = 8;
    g[9] = 12;
    g[11] = 5;
    g[12] = 9;
    memset(g + FACE_GLYPH_SIZE, 15, 8 * 12);
}

/* The frame: its nine thirds have shades 1 to 9 of bank 6. */
static void draw_frame(void)
{
    bytes_put16(game.frame, SIDE);
    bytes_put16(game.frame + 2, SIDE);
    bytes_put16(game.frame + 4, PITCH);
    bytes_put16(game.frame + 10, 1);
    bytes_put16(game.frame + 12, 1);
    bytes_put16(game.frame + 14, 1);
    bytes_put16(game.frame + 16, 6);
    for (int i = 0; i < SIDE * SIDE; i++)
        game.frame[CART_GFX_HEADER_SIZE + i / SIDE * PITCH + i % SIDE] =
            (uint8_t)(6 * 16 + 1 + i / SIDE / 3 * 3 + i % SIDE / 3);
}

static int setup(void **state)
{
    (void)state;
    memset(&game, 0, sizeof game);
    manifest_set_defaults(&game.m);
    for (int bank = 0; bank < 16; bank++)
        set_bank(bank, 0x300000 + (uint32_t)bank, 0x200000);
    set_bank(0, INK, PAPER);
    set_bank(3, AMBER, 0x000008);
    set_bank(5, 0x40C0FF, 0x001020);
    for (int i = 1; i < 10; i++)
        set_colour(6 * 16 + i, 0x600000 + (uint32_t)i);
    draw_cells();
    draw_face();
    draw_frame();
    game.settings = (struct art_theme){
        .ink = THEME_DEFAULT, .accent = THEME_DEFAULT, .rule = THEME_DEFAULT, .paper = THEME_DEFAULT
    };
    game.has_font = true;
    game.theme_size = THEME_SIZE;
    return 0;
}

static int teardown(void **state)
{
    (void)state;
    free(opened.block);
    opened.block = NULL;
    return 0;
}

static bool open_cart(void)
{
    struct lump lumps[7];
    int n = 0;

    if (game.has_font)
        lumps[n++] = (struct lump){ "font", game.font, sizeof game.font };
    if (game.has_font)
        lumps[n++] = (struct lump){ "fonts/tall", game.face, sizeof game.face };
    lumps[n++] = (struct lump){ "gfx/panel", game.frame, sizeof game.frame };
    lumps[n++] = (struct lump){ "manifest", game.manifest, manifest_pack(&game.m, game.manifest) };
    lumps[n++] = (struct lump){ "palette/main", game.palette, sizeof game.palette };
    lumps[n++] = (struct lump){ "script/main.lua", (const uint8_t *)"return 1", 8 };
    if (game.has_theme)
        lumps[n++] = (struct lump){ THEME_LUMP, game.theme, game.theme_size };
    free(opened.block);
    opened.block = malloc(rom_write_size(lumps, n));
    assert_non_null(opened.block);
    rom_write(opened.block, lumps, n);
    assert_true(rom_open(&opened.rom, opened.block, rom_write_size(lumps, n), opened.err, sizeof opened.err));
    return cart_open(&opened.cart, &opened.rom, opened.err, sizeof opened.err);
}

/* Opens the game with its settings as a lump, if they are set. */
static const struct theme *open_theme(void)
{
    if (game.has_theme)
        theme_pack(&game.settings, game.theme);
    assert_true(open_cart());
    theme_open(&opened.theme, &opened.cart);
    return &opened.theme;
}

/* ---- the theme ---- */

/* Figures from https://www.w3.org/TR/WCAG22/#dfn-contrast-ratio, rounded down. */
TEST(contrast_is_that_of_wcag)
{
    assert_int_equal(theme_contrast(0, 0xFFFFFF), 2100);
    assert_int_equal(theme_contrast(0x123456, 0x123456), 100);
    assert_in_range(theme_contrast(0x777777, 0xFFFFFF), 446, 448);
    assert_in_range(theme_contrast(0x767676, 0xFFFFFF), 453, 455);
    assert_in_range(theme_contrast(0xFFFFFF, 0x0000FF), 858, 860);
    assert_in_range(theme_contrast(0xFF0000, 0x000000), 524, 526);
    assert_in_range(theme_contrast(0x00FF00, 0x000000), 1528, 1531);
    assert_in_range(theme_contrast(0x282828, 0x000000), 141, 143);
    assert_in_range(theme_contrast(0x0A0A0A, 0x000000), 105, 107);
}

TEST(defaults_are_made_of_the_game)
{
    const struct theme *t = open_theme();

    assert_int_equal(t->ink, 0);
    assert_int_equal(t->accent, 3);
    assert_int_equal(t->rule, 0);
    assert_int_equal(t->paper, 1);
    assert_int_equal(theme_text_colour(t, 0), INK);
    assert_false(t->has_frame);
    assert_int_equal(t->cursor, '>');
    for (int i = 0; i < THEME_SOUNDS; i++)
        assert_null(t->sounds[i]);
}

/* The paper is in another bank if the ink's has no dark colour; the accent is the ink if nothing else can be read. */
TEST(defaults_can_be_read)
{
    set_bank(0, INK, INK);
    assert_int_equal(open_theme()->paper, 3 * 16 + 1);
    set_bank(3, 0x605000, 0x605000); /* nearer to yellow than the ink, but dark */
    set_bank(5, 0x201800, 0x201800);
    set_bank(0, 0x8080FF, PAPER);
    assert_int_equal(open_theme()->accent, 0);
}

TEST(settings_are_used)
{
    game.has_theme = true;
    game.settings = (struct art_theme){
        .ink = 5, .accent = 0, .rule = 3, .paper = 49, .cursor = 0x2605, .font = "tall", .frame = "panel"
    };
    const struct theme *t = open_theme();
    assert_int_equal(t->ink, 5);
    assert_int_equal(t->accent, 0);
    assert_int_equal(t->rule, 3);
    assert_int_equal(t->paper, 49);
    assert_int_equal(t->cursor, 0x2605);
    assert_int_equal(t->height, TALL);
    assert_int_equal(t->capital_top, 5);
    assert_int_equal(t->capital_height, 12);
    assert_true(t->has_frame);
    assert_int_equal(t->frame.bank, 6);
}

static void refuse(const char *sentence)
{
    theme_pack(&game.settings, game.theme);
    assert_false(open_cart());
    assert_string_equal(opened.err, sentence);
    setup(NULL);
    game.has_theme = true;
}

TEST(wrong_lumps_are_refused)
{
    game.has_theme = true;
    game.theme_size--;
    refuse("lump \"ui/theme\": 211 bytes long, expected 212");
    game.settings.ink = 16;
    refuse("lump \"ui/theme\": a number is out of range");
    game.settings.accent = -2;
    refuse("lump \"ui/theme\": a number is out of range");
    game.settings.rule = 16;
    refuse("lump \"ui/theme\": a number is out of range");
    game.settings.paper = 256;
    refuse("lump \"ui/theme\": a number is out of range");
    game.settings.cursor = 0x110000;
    refuse("lump \"ui/theme\": a number is out of range");
    strcpy(game.settings.font, "short");
    refuse("lump \"ui/theme\": the font does not exist");
    memset(game.settings.font, 'x', sizeof game.settings.font);
    refuse("lump \"ui/theme\": the font does not exist");
    strcpy(game.settings.frame, "orb");
    refuse("lump \"ui/theme\": the frame's sprite does not exist");
    strcpy(game.settings.sounds[THEME_BACK], "clack");
    refuse("lump \"ui/theme\": a sound does not exist");
}

/* ---- a canvas with a theme ---- */

static struct {
    struct fb fb;
    uint32_t rgb[256];
    struct canvas canvas;
    uint8_t memory[1 << 16];
} shown;

/* Opens a canvas over a picture with all entries, which is faded to white. */
static const struct canvas *open_canvas(void)
{
    assert_true(fb_size(W, H) <= sizeof shown.memory);
    fb_init(&shown.fb, shown.memory, W, H);
    for (int i = 0; i < W * H; i++)
        shown.fb.pix[i / W * shown.fb.pitch + i % W] = (uint8_t)i;
    memset(shown.rgb, 255, sizeof shown.rgb);
    canvas_open_theme(&shown.canvas, &shown.fb, shown.rgb, open_theme());
    return &shown.canvas;
}

static uint32_t colour_at(int x, int y)
{
    return shown.rgb[shown.fb.pix[y * shown.fb.pitch + x]];
}

TEST(colours_do_not_fade)
{
    const struct canvas *canvas = open_canvas();

    assert_true(colour_at(0, 0) < 0xFFFFFF); /* the picture is darker */
    canvas_rect(canvas, 0, 0, W, H, CANVAS_DARK);
    assert_int_equal(colour_at(5, 5), PAPER);
    canvas_rect(canvas, 0, 0, W, H, CANVAS_WHITE);
    assert_int_equal(colour_at(5, 5), INK);
    canvas_rect(canvas, 0, 0, W, H, CANVAS_YELLOW);
    assert_int_equal(colour_at(5, 5), AMBER);
    canvas_rect(canvas, 0, 0, W, H, CANVAS_GREY);
    assert_true(colour_at(5, 5) > PAPER && colour_at(5, 5) < INK);
    game.has_theme = true;
    game.settings.rule = 5;
    canvas = open_canvas();
    canvas_rect(canvas, 0, 0, W, H, CANVAS_CYAN);
    assert_int_equal(colour_at(5, 5), 0x40C0FF);
}

/* A plate is a dark shade of its rim's colour, or paper if text can't be read on that. */
TEST(plates_can_be_read)
{
    const struct canvas *canvas = open_canvas();

    canvas_plate(canvas, 0, 0, 20, 10, CANVAS_YELLOW);
    assert_int_equal(colour_at(10, 5), 0x000008);
    set_bank(3, AMBER, AMBER);
    canvas = open_canvas();
    canvas_plate(canvas, 0, 0, 20, 10, CANVAS_YELLOW);
    assert_int_equal(colour_at(10, 5), PAPER);
}

/* Hints on buttons have the same colours and letters with and without a theme; the font lacks no character that the
 * game's has. */
TEST(plain_canvas)
{
    const struct canvas plain = canvas_plain(open_canvas());

    canvas_rect(&plain, 0, 0, W, H, CANVAS_GREEN);
    assert_int_equal(colour_at(5, 5), 0x58E070);
    assert_int_equal(canvas_large_text(&plain, 10, 20, CANVAS_WHITE, "H"), 10 + 5 + 1);
    assert_int_equal(colour_at(10, 20), 0xFFFFFF);
    assert_int_equal(plain.capital_height, 7);
}

/* H is the game's, 8 px wide, with its capital's top at y; i is the program's, on the same baseline. */
TEST(glyphs_are_the_games_where_it_has_them)
{
    const struct canvas *canvas = open_canvas();
    int lowest = -1;

    canvas_rect(canvas, 0, 0, W, H, CANVAS_DARK);
    assert_int_equal(canvas_large_text(canvas, 10, 20, CANVAS_WHITE, "Hi"), 10 + 8 + 1 + 1);
    assert_int_equal(colour_at(10, 19), PAPER);
    for (int y = 20; y < 26; y++)
        assert_int_equal(colour_at(17, y), INK);
    for (int y = 0; y < H; y++)
        lowest = colour_at(18, y) == INK ? y : lowest;
    assert_int_equal(lowest, 25);
    assert_int_equal(canvas_line_height(canvas), 3 + 6 + 2);
    assert_int_equal(canvas_glyph(canvas, 'H', '?'), 'H');
    assert_int_equal(canvas_glyph(canvas, 'i', '?'), '?');
}

TEST(rows_are_as_high_as_the_font)
{
    game.has_theme = true;
    strcpy(game.settings.font, "tall");
    const struct canvas *canvas = open_canvas();
    assert_int_equal(canvas_line_height(canvas), TALL);
    assert_int_equal(canvas->ascent, 5);
    assert_int_equal(canvas_large_text_width(canvas, "HH"), 17);
}

/* A plain canvas takes the hiragana a from the game, in its own colour: 8 x 12 px, 5 px below the line's top. Its last
 * row is a shadow. */
TEST(letters_that_the_program_lacks_are_the_games)
{
    const struct theme *theme = &opened.theme;
    struct canvas canvas;
    int lowest = -1, count = 0;

    game.has_theme = true;
    strcpy(game.settings.font, "tall");
    bytes_put32(game.face + FACE_HEADER_SIZE, 0x3042);
    memset(game.face + sizeof game.face - 8, 1, 8);
    open_canvas();
    canvas_open(&canvas, &shown.fb, shown.rgb);
    canvas_rect(&canvas, 0, 0, W, H, CANVAS_DARK);
    canvas_add_font(&canvas, theme);
    assert_int_equal(canvas_large_text(&canvas, 10, 20, CANVAS_GREEN, "\u3042"), 10 + 9);
    for (int i = 0; i < W * H; i++)
        if (shown.fb.pix[i / W * shown.fb.pitch + i % W] == canvas.colour[CANVAS_GREEN]) {
            lowest = i / W;
            count++;
        }
    assert_int_equal(count, 8 * 11);
    assert_int_equal(lowest + 1, 20 + canvas.capital_height - theme->capital_height - theme->capital_top + 5 + 11);
    assert_true(canvas_line_height(&canvas) > CANVAS_LARGE_LINE_HEIGHT);
}

TEST(a_game_without_a_font_has_the_programs)
{
    game.has_font = false;
    const struct canvas *canvas = open_canvas();
    assert_int_equal(canvas_line_height(canvas), CANVAS_LARGE_LINE_HEIGHT);
    canvas_large_text(canvas, 10, 20, CANVAS_WHITE, "H");
    assert_int_equal(colour_at(10, 20), INK);
}

/* Corners stay, sides and the middle are repeated. */
TEST(a_frame_has_nine_parts)
{
    game.has_theme = true;
    strcpy(game.settings.frame, "panel");
    const struct canvas *canvas = open_canvas();
    const int x = 10, y = 8, w = 50, h = 31;

    canvas_frame(canvas, x, y, w, h);
    for (int v = 0; v < h; v++)
        for (int u = 0; u < w; u++) {
            const uint32_t col = u < 3 ? 0 : u < w - 3 ? 1 : 2, row = v < 3 ? 0 : v < h - 3 ? 1 : 2;
            assert_int_equal(colour_at(x + u, y + v), 0x600001 + 3 * row + col);
        }
    assert_int_equal(canvas_frame_width(canvas), 3);
    assert_true(colour_at(x - 1, y) != 0x600001 && colour_at(x + w, y) != 0x600003);
}

/* A picture's colours leave the canvas's own alone, also those that are not on the picture yet. */
TEST(pictures_add_their_colours)
{
    const struct canvas *canvas = open_canvas();
    uint32_t added[256];
    uint8_t entries[256];

    canvas_frame(canvas, 0, 0, W, H);
    for (int i = 0; i < 256; i++)
        added[i] = 0x004000 + (uint32_t)i;
    canvas_add_colours(canvas, added, 168, entries);
    for (int i = 0; i < 168; i++)
        assert_int_equal(shown.rgb[entries[i]], added[i]);
    assert_int_equal(colour_at(W / 2, H / 2), PAPER);
    canvas_add_colours(canvas, added, 256, entries); /* more than there is room for */
    for (int i = 0; i < 256; i++)
        assert_in_range(shown.rgb[entries[i]], 0x004000, 0x0040FF);
    assert_int_equal(colour_at(W / 2, H / 2), PAPER);
    canvas_rect(canvas, 0, 0, W, H, CANVAS_YELLOW);
    assert_int_equal(colour_at(5, 5), AMBER);
}

RUN_TESTS_EACH(setup, teardown)
