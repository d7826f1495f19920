/* test_manifest.c - manifest.h: rom.lua as text, each of its errors as a whole line, and the binary form. */
#include "../test.h"
#include "../../src/base/bytes.h"
#include "../../src/base/int.h"
#include "../../src/rom/manifest.h"

struct result {
    struct manifest m;
    struct art art;
    char err[512];
};

/* Reads into the result that the next call overwrites. */
static struct result *read_text(const char *text, size_t n, bool want)
{
    static struct result r;
    static _Alignas(16) uint8_t work[MANIFEST_SCRATCH_SIZE];

    memset(&r, 0, sizeof r);
    bool good = manifest_read(text, n, "rom.lua", "Glass-Tide", &r.m, &r.art, work, r.err, sizeof r.err);
    if (good != want)
        print_message("%s\n", r.err);
    assert_int_equal(good, want);
    return &r;
}

static struct result *read_good(const char *text)
{
    return read_text(text, strlen(text), true);
}

static void refused(const char *text, const char *line)
{
    assert_string_equal(read_text(text, strlen(text), false)->err, line);
}

/* Refused with the line "rom.lua: " + line, as `return { text }`. */
static void entry_refused(const char *text, const char *line)
{
    char whole[2048], want[512];

    snprintf(whole, sizeof whole, "return { %s }", text);
    snprintf(want, sizeof want, "rom.lua: %s", line);
    refused(whole, want);
}

TEST(defaults)
{
    struct result *r = read_good("return {}");

    assert_string_equal(r->m.id, "glass_tide");
    assert_string_equal(r->m.title, "glass_tide");
    assert_string_equal(r->m.author, "");
    assert_string_equal(r->m.entry, "main");
    assert_int_equal(r->m.version, 1);
    assert_int_equal(r->m.screen_w, 240);
    assert_int_equal(r->m.screen_h, 320);
    assert_int_equal(r->m.bullets, 8192);
    assert_int_equal(r->m.n_extends, 0);
    assert_int_equal(r->m.n_difficulties, 1);
    assert_string_equal(r->m.difficulties[0], "normal");
    assert_int_equal(r->m.n_dips, 0);
    assert_int_equal(r->art.n_sheets + r->art.n_sprites + r->art.n_palettes, 0);
}

TEST(sizes)
{
    static const struct {
        const char *name;
        int percent, frames;
    } want[] = {
        { "orb", 100, 2 }, { "orb_1000", 1000, 2 }, { "orb_200", 200, 2 }, { "orb_3", 100, 1 }, { "orb_50", 50, 2 }
    };
    struct result *r = read_good("return { sheets = { s = { file = 'a.png' } }, sprites = {\n"
                                 "  orb = { sheet = 's', w = 8, h = 6, frames = 2, sizes = { 200, 50, 1000 } },\n"
                                 "  orb_3 = { sheet = 's', w = 1, h = 1, sizes = {} } } }");

    assert_int_equal(r->art.n_sprites, 5);
    for (int i = 0; i < 5; i++) {
        assert_string_equal(r->art.sprites[i].name, want[i].name);
        assert_int_equal(r->art.sprites[i].scale_percent, want[i].percent);
        assert_int_equal(r->art.sprites[i].frames, want[i].frames);
    }
}

static const char lanterns[] =
    "return { title = 'Paper Lanterns', author = 'You', version = 3, entry = 'boot/main', id = 'lanterns',\n"
    "  screen = { w = 320, h = 240 }, field = { x = 8, y = 4, w = 208, h = 224, margin = 32 },\n"
    "  board = { bullets = 100, shots = 0, enemies = 5, sparks = 0, sprites = 7, motions = 0, tasks = 9,\n"
    "            lua_kib = 512.0, nvram = 3 },\n"
    "  palette = 'art/palette.png', font = 'art/font.png', palettes = { dusk = 'art/dusk.png' },\n"
    "  blends = { haze = { mix = 99 }, glow = 'add', ghost = { mix = 1 } },\n"
    "  sheets = { small = { file = 'art/small.png', bank = 4 }, big = { file = 'art/big.png' } },\n"
    "  sprites = { wisp = { sheet = 'small', y = 16, w = 24, h = 20, frames = 4, every = 5 },\n"
    "              rice = { sheet = 'small', x = 16, w = 13, h = 12, rotations = 32 },\n"
    "              queen = { sheet = 'big', w = 48, h = 56, origin = { 24, -30 } } },\n"
    "  difficulties = { 'easy', 'normal', 'hard' }, difficulty = 'hard', players = 2,\n"
    "  dip = { rate = { min = -1, max = 10, default = 3 }, coins = { 'free', 'one' }, n = { min = 2, max = 2 } },\n"
    "  extends = { 100000, 9007199254740992 } }\n";

TEST(all)
{
    struct result *r = read_good(lanterns);
    const struct manifest *m = &r->m;

    assert_string_equal(m->id, "lanterns");
    assert_string_equal(m->title, "Paper Lanterns");
    assert_string_equal(m->author, "You");
    assert_string_equal(m->entry, "boot/main");
    assert_int_equal(m->screen_w, 320);
    assert_int_equal(m->field_y, 4);
    assert_int_equal(m->margin, 32);
    assert_int_equal(m->shots, 0);
    assert_int_equal(m->tasks, 9);
    assert_int_equal(m->lua_kib, 512);
    assert_int_equal(m->players, 2);
    assert_int_equal(m->n_extends, 2);
    assert_true(m->extends[1] == INT64_C(9007199254740992));
    assert_int_equal(m->n_difficulties, 3);
    assert_int_equal(m->difficulty, 2);
}

TEST(dips)
{
    struct result *r = read_good(lanterns);
    const struct dip *d = r->m.dips;

    assert_int_equal(r->m.n_dips, 3);
    assert_string_equal(d[0].name, "coins");
    assert_false(d[0].is_number);
    assert_int_equal(d[0].n_values, 2);
    assert_int_equal(d[0].default_value, 0);
    assert_string_equal(d[0].value_name[1], "one");
    assert_int_equal(d[1].default_value, 2); /* its smallest value */
    assert_string_equal(d[2].name, "rate");
    assert_true(d[2].is_number);
    assert_int_equal(d[2].lo, -1);
    assert_int_equal(d[2].hi, 10);
    assert_int_equal(d[2].default_value, 3);
}

TEST(art)
{
    struct result *r = read_good(lanterns);
    const struct art *a = &r->art;

    assert_string_equal(a->palette, "art/palette.png");
    assert_string_equal(a->font, "art/font.png");
    assert_string_equal(a->palettes[0].name, "dusk");
    assert_string_equal(a->palettes[0].file, "art/dusk.png");
    assert_int_equal(a->n_blends, 3);
    assert_string_equal(a->blends[0].name, "ghost");
    assert_int_equal(a->blends[0].mix, 1);
    assert_int_equal(a->blends[1].mix, 0);
    assert_int_equal(a->n_sheets, 2);
    assert_string_equal(a->sheets[0].name, "big");
    assert_int_equal(a->sheets[0].bank, 0);
    assert_int_equal(a->sheets[1].bank, 4);
    assert_int_equal(a->n_sprites, 3);
    assert_string_equal(a->sprites[0].name, "queen");
    assert_int_equal(a->sprites[0].ox, 24);
    assert_int_equal(a->sprites[0].oy, -30);
    assert_int_equal(a->sprites[1].x, 16);
    assert_int_equal(a->sprites[1].ox, 6); /* its centre */
    assert_int_equal(a->sprites[1].rotations, 32);
    assert_int_equal(a->sprites[1].frames, 1);
    assert_int_equal(a->sprites[1].frame_ticks, 6);
    assert_int_equal(a->sprites[2].sheet, 1);
    assert_int_equal(a->sprites[2].frames, 4);
    assert_int_equal(a->sprites[2].frame_ticks, 5);
}

/* Fields that are not set follow from those that are. */
TEST(derived)
{
    struct result *r = read_good("return { id = 'x', screen = { w = 400 }, field = { x = 100, h = 50 },"
                                 "  difficulties = { 'a', 'normal' } }");

    assert_string_equal(r->m.title, "x");
    assert_int_equal(r->m.field_w, 300);
    assert_int_equal(r->m.field_h, 50);
    assert_int_equal(r->m.difficulty, 1);
}

TEST(unknown_names)
{
    entry_refused("board = { bulets = 1 }", "board.bulets: unknown key (did you mean \"bullets\"?)");
    entry_refused("zebra = 1, muzak = 2", "muzak: unknown key");
    entry_refused("sheets = { s = { file = 'a' } }, sprites = { orb = { sheet = 's', w = 1, h = 1, frame = 2 } }",
                  "sprites.orb.frame: unknown key (did you mean \"frames\"?)");
    entry_refused("1", "manifest: expected only names as keys, got 1");
    entry_refused("board = { [7.5] = 1, [true] = 1, [6.5] = 1, [2.5] = 1, [5.5] = 1, [4.5] = 1, [3.5] = 1 }",
                  "board: expected only names as keys, got 2.5");
    entry_refused("sheets = { ['c/'] = {}, ['b/'] = {}, ['a/'] = {} }",
                  "sheets: \"a/\": expected a name of letters, digits, _ - . and /");
}

TEST(sounds)
{
    struct result *r = read_good(
        "return { sounds = { b = { file = 'b.wav', volume = 0.5, limit = 3, duck = 0.4 }, a = { mml = 'c' } },"
        " music = { t = { file = 'm/t.mml', title = 'T' } } }");

    assert_true(r->m.has_sound == 1 && r->art.n_sounds == 2 && r->art.n_tunes == 1);
    assert_string_equal(r->art.sounds[0].mml, "c");
    assert_true(r->art.sounds[1].volume == 128 && r->art.sounds[1].limit == 3 && r->art.sounds[1].duck == 102 &&
                r->art.sounds[1].priority == 4);
    assert_string_equal(r->art.tunes[0].title, "T");
    r = read_good("return {}");
    assert_int_equal(r->m.has_sound, 0);
    entry_refused("sounds = { a = {} }", "sounds.a: expected either file=\"sfx/NAME.wav\" (or .ogg, .flac, .mml) or "
                                         "mml=\"...\"");
    entry_refused("sounds = { a = { mml = 'c', volume = 2 } }",
                  "sounds.a.volume: expected a number from 0 to 1, got 2");
    entry_refused("sounds = { a = { mml = 'c', limit = 9 } }",
                  "sounds.a.limit: expected a whole number from 1 to 8, got 9");
    entry_refused("music = { a = { file = 'a.mp3' } }",
                  "music.a: expected file=\"music/NAME.mml\" (or .ogg, .flac, .wav)");
}

TEST(recordings)
{
    struct result *r = read_good("return { sounds = { b = { file = 'b.ogg', exact = true, stereo = true } },"
                                 " music = { s = { file = 's.flac', stereo = false, loop = false },"
                                 " t = { file = 't.xm', tempo = 97.25, bar = 3, offset = 0.5, loop = { start = 1.5,"
                                 " length = 2, unit = 'seconds' }, markers = { drop = 8.5, back = 0 } } } }");
    const struct art_sound *b = &r->art.sounds[0], *s = &r->art.tunes[0], *t = &r->art.tunes[1];

    assert_true(b->exact && b->stereo && b->loop.kind == LOOP_FROM_FILE);
    assert_true(!s->exact && !s->stereo && s->loop.kind == LOOP_NONE && s->tempo == 0 && s->beats_per_bar == 4);
    assert_true(t->stereo && t->tempo == 9725 && t->beats_per_bar == 3 && t->offset == 0.5 && t->n_markers == 2);
    assert_true(t->loop.kind == LOOP_RANGE && t->loop.in_seconds && t->loop.start == 1.5 && t->loop.length == 2);
    assert_string_equal(r->art.markers[t->first_marker].name, "back");
    assert_true(r->art.markers[t->first_marker + 1].beat == 8.5);
    entry_refused("music = { a = { file = 'a.mml', tempo = 100 } }",
                  "music.a: tempo: only for samples (.wav, .ogg, .flac); MML has its own commands for it");
    entry_refused("music = { a = { file = 'a.ogg', loop = 5 } }", "music.a.loop: expected a table, got 5");
    entry_refused("music = { a = { file = 'a.ogg', loop = { start = 1.5 } } }",
                  "music.a.loop: expected whole numbers of frames (or unit=\"seconds\")");
    entry_refused("music = { a = { file = 'a.ogg', loop = { start = 1, unit = 'beats' } } }",
                  "music.a.loop: unit: expected \"frames\" or \"seconds\", got \"beats\"");
    entry_refused("music = { a = { file = 'a.ogg', markers = { up = -1 } } }",
                  "music.a.markers.up: expected a number from 0 to 1048576, got -1");
}

/* "a.b.c" as "a = { b = { c = v } }". */
static void spell_out(char *text, size_t size, const char *name, long long v)
{
    int depth = 0;
    size_t n = 0;

    for (; *name != '\0'; name++)
        if (*name == '.')
            n += (size_t)snprintf(text + n, size - n, " = { "), depth++;
        else
            text[n++] = *name;
    n += (size_t)snprintf(text + n, size - n, " = %lld", v);
    while (depth-- > 0)
        n += (size_t)snprintf(text + n, size - n, " }");
}

TEST(numbers)
{
    for (int i = 0; i < MANIFEST_NUMBERS; i++) {
        const struct manifest_number *f = &manifest_numbers[i];
        char text[128], want[128];
        for (int k = 0; k < 2 && !f->is_flag; k++) {
            long long v = k == 0 ? f->lo - 1LL : f->hi + 1LL;
            spell_out(text, sizeof text, f->name, v);
            snprintf(want, sizeof want, "%s: expected a whole number from %d to %d, got %lld", f->name, f->lo, f->hi,
                     v);
            entry_refused(text, want);
        }
    }
    entry_refused("version = 9223372036854775807",
                  "version: expected a whole number from 0 to 1000000000, got 9223372036854775807");
    entry_refused("board = { hp = 2 }", "board.hp: expected true or false, got 2");
    entry_refused("sheets = { s = { file = 'a' } }, sprites = { a_7 = { sheet = 's', w = 1, h = 1 },\n"
                  "  a = { sheet = 's', w = 1, h = 1, sizes = { 7 } } }",
                  "sprites: two sprites are named a_7; one of them gets this name from `sizes`");
    entry_refused("players = 1.5", "players: expected a whole number from 1 to 2, got 1.5");
    entry_refused("players = '2'", "players: expected a whole number from 1 to 2, got \"2\"");
    entry_refused("board = 3", "board: expected a table, got 3");
    entry_refused("screen = { w = 100 }", "screen.w: expected a multiple of 8, got 100");
    entry_refused("field = { x = 9, w = 240 }",
                  "field: 240x320 at 9,0 is not inside the 240x320 screen; to show a part of it, add view = { w = .., "
                  "h = .. } to field");
    entry_refused("field = { x = 230 }", "field.w: expected a whole number from 16 to 1024, got 10");
}

TEST(texts)
{
    entry_refused("id = 'A b'", "id: expected 1 to 31 of the characters a-z 0-9 _");
    entry_refused("id = 5", "id: expected a name, got 5");
    entry_refused("title = 'a\\0b'", "title: expected a line of at most 63 bytes, got \"a\"");
    entry_refused("title = '0123456789012345678901234567890123456789012345678901234567890123'",
                  "title: expected a line of at most 63 bytes, got \"0123456789012345678901234567890123456789\"");
    entry_refused("title = 'a\\u{9b}b'", "title: expected a line of 1 to 63 bytes");   /* a terminal's escape */
    entry_refused("title = 'a\\u{202e}b'", "title: expected a line of 1 to 63 bytes"); /* reverses text */
    entry_refused("author = 'a\\127'", "author: expected a line of at most 63 bytes");
    entry_refused("entry = '../main'", "entry: expected a script's path without .lua, at most 63 bytes");
}

TEST(lists)
{
    entry_refused("extends = { 0 }", "extends[1]: expected a whole number from 1 to 9007199254740992, got 0");
    entry_refused("extends = { 5, 5 }", "extends[2]: expected a whole number from 6 to 9007199254740992, got 5");
    entry_refused("extends = { 1, 2, 3, 4, 5, 6, 7, 8, 9 }", "extends: expected at most 8 entries, got 9");
    entry_refused("extends = { 1, x = 2 }", "extends: expected a list");
    entry_refused("difficulties = {}", "difficulties: expected at least one word");
    entry_refused("difficulties = { 'a', 'a' }", "difficulties[2]: duplicate \"a\"");
    entry_refused("difficulties = { 'a b' }",
                  "difficulties[1]: expected a word of letters, digits, _ and -, got \"a b\"");
    entry_refused("difficulties = { 'easy' }, difficulty = 'hard'",
                  "difficulty: \"hard\" is not listed in difficulties");
}

TEST(dip_errors)
{
    entry_refused("dip = { ['a.b'] = { 'x' } }", "dip.a.b: expected a name of letters, digits, _ and -");
    entry_refused("dip = { n = 3 }", "dip.n: expected a table, got 3");
    entry_refused("dip = { n = {} }", "dip.n.min: expected a whole number from -2147483648 to 2147483647, got nil");
    entry_refused("dip = { n = { min = 3, max = 2 } }",
                  "dip.n.max: expected a whole number from 3 to 2147483647, got 2");
    entry_refused("dip = { n = { min = -2147483648, max = 2147483647 } }",
                  "dip.n: expected at most 65536 numbers from min to max, got -2147483648 to 2147483647");
    entry_refused("dip = { n = { min = -1, max = 65535 } }",
                  "dip.n: expected at most 65536 numbers from min to max, got -1 to 65535");
    entry_refused("dip = { n = { min = 1, max = 2, default = 3 } }",
                  "dip.n.default: expected a whole number from 1 to 2, got 3");
    entry_refused("dip = { a={'x'},b={'x'},c={'x'},d={'x'},e={'x'},f={'x'},g={'x'},h={'x'},i={'x'},j={'x'},"
                  "k={'x'},l={'x'},m={'x'},n={'x'},o={'x'},p={'x'},q={'x'} }",
                  "dip: expected at most 16 entries");
}

TEST(art_errors)
{
    entry_refused("palette = 3", "palette: expected a file, got 3");
    entry_refused("font = '/etc/font.png'",
                  "font: expected a file inside the folder (letters, digits, _ - . /), got \"/etc/font.png\"");
    entry_refused("icon = 'ship'", "icon: expected a .png file or the name of a sprite, got \"ship\"");
    entry_refused("practice = 'none'", "practice: expected \"all\" or \"reached\", got \"none\"");
    entry_refused("palettes = { main = 'a.png' }", "palettes.main: this name is already used by `palette`");
    entry_refused("blends = { a = 'add', b = 'add', c = 'add', d = 'add' }", "blends: expected at most 3 entries");
    entry_refused("blends = { a = 'mix' }",
                  "blends.a: expected \"add\", { mix = percent } or { ramp = rule }, got \"mix\"");
    entry_refused("blends = { a = { ramp = 'glow' } }",
                  "blends.a.ramp: expected \"add\", \"half\" or \"max\", got \"glow\"");
    entry_refused("blends = { a = { ramp = 'add', mix = 5 } }", "blends.a: expected mix or ramp, got both");
    entry_refused("blends = { a = { mix = 0 } }", "blends.a.mix: expected a whole number from 1 to 99, got 0");
    entry_refused("blends = { a = { mix = 100 } }", "blends.a.mix: expected a whole number from 1 to 99, got 100");
    entry_refused("sheets = { a = {} }", "sheets.a: expected file=\"art/NAME.png\" (or .ase, .aseprite)");
    entry_refused("sheets = { a = { file = 'x.png', bank = 16 } }",
                  "sheets.a.bank: expected a whole number from 0 to 15, got 16");
    entry_refused("sprites = { a = { sheet = 'b', w = 1, h = 1 } }", "sprites.a.sheet: \"b\" is not listed in sheets");
    entry_refused("sheets = { s = { file = 'x.png' } }, sprites = { a = { sheet = 's', h = 1 } }",
                  "sprites.a.w: expected a whole number from 1 to 1024, got nil");
    entry_refused(
        "sheets = { s = { file = 'x.png' } }, sprites = { a = { sheet = 's', w = 1, h = 1, origin = { 1 } } }",
        "sprites.a.origin: expected { x, y }");
}

TEST(theme)
{
    const struct art_theme *t = &read_good("return {}")->art.theme;

    assert_false(t->is_set);
    assert_int_equal(t->ink, THEME_DEFAULT);
    t = &read_good("return { fonts = { body = { file = 'b.bdf' } }, sounds = { tick = { mml = 'c' } },"
                   "sheets = { s = { file = 's.png' } }, sprites = { panel = { sheet = 's', w = 9, h = 9 } },"
                   "theme = { font = 'body', frame = 'panel', cursor = '\\u{2605}', ink = 2, accent = 15, rule = 7,"
                   "sounds = { back = 'tick' } } }")
             ->art.theme;
    assert_true(t->is_set);
    assert_int_equal(t->ink, 2);
    assert_int_equal(t->accent, 15);
    assert_int_equal(t->rule, 7);
    assert_int_equal(t->paper, THEME_DEFAULT);
    assert_int_equal(t->cursor, 0x2605);
    assert_string_equal(t->font, "body");
    assert_string_equal(t->frame, "panel");
    assert_string_equal(t->sounds[THEME_BACK], "tick");
    assert_string_equal(t->sounds[THEME_MOVE], "");
    assert_int_equal(read_good("return { theme = { cursor = '\\u{8c}' } }")->art.theme.cursor, 140);
    entry_refused("theme = 5", "theme: expected a table, got 5");
    entry_refused("theme = { inc = 5 }", "theme.inc: unknown key (did you mean \"ink\"?)");
    entry_refused("theme = { ink = 16 }", "theme.ink: expected a whole number from 0 to 15, got 16");
    entry_refused("theme = { accent = -1 }", "theme.accent: expected a whole number from 0 to 15, got -1");
    entry_refused("theme = { paper = 256 }", "theme.paper: expected a whole number from 0 to 255, got 256");
    entry_refused("theme = { font = 'body' }", "theme.font: \"body\" is not listed in fonts");
    entry_refused("theme = { frame = 'panel' }", "theme.frame: \"panel\" is not listed in sprites");
    entry_refused("theme = { cursor = '' }", "theme.cursor: expected one character, got \"\"");
    entry_refused("theme = { cursor = '>>' }", "theme.cursor: expected one character, got \">>\"");
    entry_refused("theme = { sounds = { open = 'tick' } }", "theme.sounds.open: \"tick\" is not listed in sounds");
    entry_refused("theme = { sounds = { close = 'tick' } }", "theme.sounds.close: unknown key");
}

/* By index: said of one, of all, of all but one. And what a sprite of an .ase leaves to its file. */
TEST(index_and_tags)
{
    struct result *r = read_good(
        "return { match = 'index', sheets = { a = { file = 'a.ase' }, b = { file = 'b.png', match = 'colour' } },"
        "fonts = { f = { file = 'f.png', cell = { 4, 4 }, chars = 'x' } },"
        "maps = { m = { tiles = 't.png', rows = { { 1 } } } },"
        "sprites = { s = { sheet = 'a', tag = 'fly', sizes = { 50 } }, t = { sheet = 'b', w = 3, h = 4 } } }");

    assert_true(r->art.by_index && r->art.sheets[0].by_index && r->art.fonts[0].by_index && r->art.maps[0].by_index);
    assert_false(r->art.sheets[1].by_index);
    const struct art_sprite *s = &r->art.sprites[1], *cut = &r->art.sprites[2];
    assert_string_equal(s->name, "s_50");
    assert_string_equal(s->tag, "fly");
    assert_true(s->w == 0 && s->h == 0 && s->frames == 0 && s->frame_ticks == 0 && s->scale_percent == 50);
    assert_true(cut->w == 3 && cut->h == 4 && cut->frames == 1 && cut->frame_ticks == 6 && cut->tag[0] == '\0');
    r = read_good("return { sheets = { a = { file = 'a.aseprite', match = 'index' } },"
                  "maps = { m = { tiles = 't.png', match = 'index', rows = { { 1 } } } } }");
    assert_true(r->art.sheets[0].by_index && r->art.maps[0].by_index && !r->art.by_index);
    entry_refused("maps = { m = { tiles = 't.png', match = 'color', rows = { { 1 } } } }",
                  "maps.m.match: expected \"colour\" or \"index\", got \"color\"");
    entry_refused("sheets = { a = { file = 'a.ase' } }, sprites = { s = { sheet = 'a', tag = 3 } }",
                  "sprites.s.tag: expected a tag's name, got 3");
}

/* A sheet, or a map, that is drawn in another palette than the first. */
TEST(palette_of_a_sheet)
{
    struct result *r = read_good("return { palettes = { dusk = 'd.png' }, maps = { m = { tiles = 't.png',"
                                 "palette = 'dusk', rows = { { 1 } } } },"
                                 "sheets = { a = { file = 'a.png', palette = 'dusk' }, b = { file = 'b.png' },"
                                 "c = { file = 'c.png', palette = 'main' } } }");

    assert_string_equal(r->art.sheets[0].palette, "dusk");
    assert_string_equal(r->art.sheets[1].palette, "");
    assert_string_equal(r->art.sheets[2].palette, "");
    assert_string_equal(r->art.maps[0].palette, "dusk");
    entry_refused("palettes = { dusk = 'd.png' }, sheets = { a = { file = 'a.png', palette = 'dawn' } }",
                  "sheets.a.palette: \"dawn\" is not listed in palettes");
}

TEST(not_a_manifest)
{
    refused("", "rom.lua: expected `return { ... }`, got nil");
    refused("return {\n  title = = 3 }", "rom.lua:2: unexpected symbol near '='");
    refused("\n\nprint('x')", "rom.lua:3: attempt to call a nil value (global 'print')");
    refused("x = 1 [[a\nb]]", "rom.lua:2: unexpected symbol near '[[a b]]'");
    refused("\x1bLua", "rom.lua: attempt to load a binary chunk (mode is 't')");
}

/* Neither endless loops nor memory without limit. */
TEST(bombs)
{
    char *text;

    refused("while true do end", "rom.lua:1: takes too long (an endless loop?)");
    refused("local function f() return f() end\nreturn f()", "rom.lua:1: takes too long (an endless loop?)");
    refused("local s = 'x' while true do s = s .. s end", "rom.lua:1: needs too much memory");
    refused("local t = {} for i = 1, 1e6 do t[i] = { i } end return t", "rom.lua:1: needs too much memory");
    refused("local function f() return 1 + f() end f()", "rom.lua:1: needs too much memory");
    text = malloc((1 << 20) + 1);
    memset(text, ' ', (1 << 20) + 1);
    assert_string_equal(read_text(text, (1 << 20) + 1, false)->err, "rom.lua: longer than 1048576 bytes");
    memset(text, '{', 1 << 20);
    read_text(text, 1 << 20, false);
    free(text);
}

TEST(many_sprites)
{
    struct result *r = read_good(
        "return { sheets = { s = { file = 's.png' } }, sprites = (function() local t = {} for i = 1, 4096 do\n"
        "t['s' .. i] = { sheet = 's', w = 1, h = 1, origin = { 3, 4 } } end return t end)() }");

    assert_int_equal(r->art.n_sprites, MAX_ART_SPRITES);
    entry_refused("sprites = (function() local t = {} for i = 1, 4097 do t['s' .. i] = {} end return t end)()",
                  "sprites: expected at most 4096 entries");
}

/* ---- the binary form ---- */

TEST(pack)
{
    struct result *r = read_good(lanterns);
    uint8_t bytes[MANIFEST_BYTES];
    struct manifest m;
    char err[256] = "";

    const uint32_t size = manifest_pack(&r->m, bytes);
    assert_true(manifest_unpack(bytes, size, &m, err, sizeof err));
    assert_memory_equal(&m, &r->m, sizeof m);
    assert_false(manifest_unpack(bytes, size - 1, &m, err, sizeof err));
    assert_string_equal(err, "5251 bytes long, expected 5276");
    static const char *const wrong[] = { "of format 5, though format 4 has all of its fields",
                                         "of format 6, though format 4 has all of its fields",
                                         "of format 7, though format 4 has all of its fields" };
    static const uint32_t sizes[] = { 5256, 5272, 5276 };
    memset(bytes + size, 0, 24);
    bytes_put32(bytes + size + 12, 1); /* the defaults of zoom and full_width */
    bytes_put32(bytes + size + 20, 8);
    for (int i = 0; i < 3; i++) {
        bytes[0] = (uint8_t)(5 + i);
        assert_false(manifest_unpack(bytes, sizes[i], &m, err, sizeof err));
        assert_string_equal(err, wrong[i]);
    }
    r->m.bulletml_runners = 300;
    assert_int_equal(manifest_pack(&r->m, bytes), size + 4);
    assert_true(manifest_unpack(bytes, size + 4, &m, err, sizeof err));
    assert_int_equal(m.bulletml_runners, 300);
    assert_true(m.zoom == 1 && m.full_width == 8);
    r->m.bulletml_runners = 0;
    r->m.has_transforms = 1;
    assert_int_equal(manifest_pack(&r->m, bytes), 5272);
    assert_true(manifest_unpack(bytes, 5272, &m, err, sizeof err));
    assert_true(m.has_transforms && !m.bulletml_runners && m.zoom == 1);
    r->m.view_w = 100;
    r->m.view_h = 50;
    r->m.zoom = 2;
    assert_int_equal(manifest_pack(&r->m, bytes), 5272);
    assert_true(manifest_unpack(bytes, 5272, &m, err, sizeof err));
    assert_memory_equal(&m, &r->m, sizeof m);
    r->m.full_width = 12;
    assert_int_equal(manifest_pack(&r->m, bytes), sizeof bytes);
    assert_true(manifest_unpack(bytes, sizeof bytes, &m, err, sizeof err));
    assert_memory_equal(&m, &r->m, sizeof m);
    bytes_put32(bytes + size + 4, (uint32_t)r->m.field_w); /* the whole field has another form */
    bytes_put32(bytes + size + 8, (uint32_t)r->m.field_h);
    bytes_put32(bytes + size + 12, 1);
    assert_false(manifest_unpack(bytes, sizeof bytes, &m, err, sizeof err));
    assert_string_equal(err, "field.view: the whole field is stored as 0x0");
}

TEST(view)
{
    static const struct {
        const char *entry;
        int32_t field_w, field_h, view_w, view_h, zoom;
    } cases[] = {
        { "field = { w = 480, view = { w = 240 } }", 480, 320, 240, 320, 1 },
        { "field = { w = 480, h = 400, view = { w = 240, h = 320 } }", 480, 400, 240, 320, 1 },
        { "field = { w = 240, h = 400, view = { h = 320 } }", 240, 400, 240, 320, 1 },
        { "field = { w = 240, h = 320, view = { w = 240, h = 320 } }", 240, 320, 0, 0, 1 },
        { "field = { view = { } }", 240, 320, 0, 0, 1 },
        { "field = { x = 40, view = { w = 100 } }", 200, 320, 100, 320, 1 },
        { "screen = { zoom = 2 }", 120, 160, 0, 0, 2 },
        { "screen = { w = 400, zoom = 3 }, field = { x = 37, y = 2 }", 121, 106, 0, 0, 3 },
        { "screen = { w = 480, h = 640, zoom = 2 }, field = { w = 300, view = { w = 240 } }", 300, 320, 240, 320, 2 },
        { "screen = { zoom = 4 }, field = { w = 1024, h = 1024, view = { w = 60, h = 80 } }", 1024, 1024, 60, 80, 4 },
    };

    for (size_t i = 0; i < COUNT(cases); i++) {
        char text[200];
        snprintf(text, sizeof text, "return { id = 'x', %s }", cases[i].entry);
        const struct manifest *m = &read_good(text)->m;
        assert_int_equal(m->field_w, cases[i].field_w);
        assert_int_equal(m->field_h, cases[i].field_h);
        assert_int_equal(m->view_w, cases[i].view_w);
        assert_int_equal(m->view_h, cases[i].view_h);
        assert_int_equal(m->zoom, cases[i].zoom);
    }
    entry_refused("field = { w = 300, view = { w = 301 } }", "field.view: 301x320 is larger than the 300x320 field");
    entry_refused("field = { w = 300, view = { w = 15 } }",
                  "field.view: expected a width and a height of at least 16 px");
    entry_refused("field = { w = 300, view = { w = 250 } }",
                  "field.view: 250x320 at 0,0 is not inside the 240x320 screen");
    entry_refused("screen = { zoom = 2 }, field = { w = 300, h = 300, view = { w = 121, h = 160 } }",
                  "field.view: 242x320 at 0,0 is not inside the 240x320 screen");
    entry_refused("screen = { zoom = 2 }, field = { w = 121 }",
                  "field: 242x320 at 0,0 is not inside the 240x320 screen; to show a part of it, add view = { w = .., "
                  "h = .. } to field");
    entry_refused("screen = { zoom = 0 }", "screen.zoom: expected a whole number from 1 to 4, got 0");
    entry_refused("screen = { zoom = 1.5 }", "screen.zoom: expected a whole number from 1 to 4, got 1.5");
    entry_refused("field = { view = 3 }", "field.view: expected a table, got 3");
    entry_refused("field = { view = { x = 3 } }", "field.view.x: unknown key");
    entry_refused("field = { vew = { w = 3 } }", "field.vew: unknown key (did you mean \"view\"?)");
    entry_refused("field = { view = { w = 'a' } }", "field.view.w: expected a whole number from 0 to 1024, got \"a\"");
}

/* A lump of an older format is shorter by the numbers that came later, which then have their defaults. */
TEST(unpack_old)
{
    static const int numbers[] = { 0, 17, 24, 31, 36 };
    uint8_t bytes[MANIFEST_BYTES];
    char err[256] = "";

    for (int format = 1; format <= 4; format++) {
        const size_t size = MANIFEST_BYTES - 4 * (size_t)(MANIFEST_NUMBERS - numbers[format]);
        struct manifest m, want;
        manifest_set_defaults(&m);
        m.tasks = 7;
        m.nvram_kib = 3;
        m.items = 9;
        m.options = 5;
        manifest_pack(&m, bytes);
        manifest_set_defaults(&want);
        want.tasks = 7;
        want.nvram_kib = format < 2 ? 32 : 3;
        want.items = format < 3 ? 0 : 9;
        want.registers = format < 4 ? 1024 : 64; /* ships could have 1024 then */
        want.options = format < 4 ? 0 : 5;
        for (int other = 0; other < 8; other++) {
            bytes[0] = (uint8_t)other;
            assert_int_equal(manifest_unpack(bytes, size, &m, err, sizeof err), other == format);
            if (other == format)
                assert_memory_equal(&m, &want, sizeof m);
            else
                assert_string_equal(err, "unknown format");
        }
    }
}

/* Maps switch backgrounds on; their rows stand one after the other. */
TEST(maps)
{
    static const char *const bad[][2] = {
        { "sea = {}", "rom.lua: maps.sea: expected tiles=\"art/NAME.png\"" },
        { "sea = { tiles = 'a.png' }",
          "rom.lua: maps.sea: expected either file=\"maps/NAME.tmx\" (or .csv) or rows={ { 1, 2, .. }, .. }" },
        { "sea = { tiles = 'a.png', file = 'b.txt' }",
          "rom.lua: maps.sea: file: expected a .csv or .tmx file, got \"b.txt\"" },
        { "sea = { tiles = 'a.png', file = 'b.csv', layer = 'x' }",
          "rom.lua: maps.sea: layer: only a .tmx map has layers" },
        { "sea = { tiles = 'a.png', size = 12, rows = { { 1 } } }",
          "rom.lua: maps.sea.size: expected 8, 16 or 32, got 12" },
        { "sea = { tiles = 'a.png', rows = {} }", "rom.lua: maps.sea.rows: expected at least one row" },
        { "sea = { tiles = 'a.png', rows = { { 1, 2 }, { 3 } } }",
          "rom.lua: maps.sea.rows[2]: expected 2 tiles, as in the first row, got 1" },
        { "sea = { tiles = 'a.png', rows = { { 1, -1 } } }",
          "rom.lua: maps.sea.rows[1][2]: expected a whole number from 0 to 65534, got -1" },
    };
    char text[256];

    struct result *r =
        read_good("return { maps = { b = { tiles = 't.png', size = 8, first = 0, rows = { { -1, 0, 5 } } },"
                  " a = { tiles = 't.png', bank = 3, rows = { { 7 }, { 0 } } },"
                  " c = { tiles = 't.png', file = 'm.tmx', layer = 'x' } } }");
    assert_int_equal(r->m.has_backgrounds, 1);
    assert_int_equal(r->art.n_maps, 3);
    const struct art_map *a = &r->art.maps[0], *b = &r->art.maps[1], *c = &r->art.maps[2];
    assert_int_equal(a->cols * 10 + a->rows, 12);
    assert_int_equal(a->tile_size * 100 + a->bank, 1603);
    assert_int_equal(r->art.cells[a->first_cell], 7);
    assert_int_equal(r->art.cells[a->first_cell + 1], 0);
    assert_int_equal(b->cols * 10 + b->rows, 31);
    assert_int_equal(r->art.cells[b->first_cell], 0);
    assert_int_equal(r->art.cells[b->first_cell + 1], 1);
    assert_int_equal(r->art.cells[b->first_cell + 2], 6);
    assert_int_equal(c->tile_size, 0);
    assert_string_equal(c->layer, "x");
    for (size_t i = 0; i < sizeof bad / sizeof *bad; i++) {
        snprintf(text, sizeof text, "return { maps = { %s } }", bad[i][0]);
        refused(text, bad[i][1]);
    }
}

/* Refused, packed and unpacked, with this line. */
static void unpack_refused(const struct manifest *m, const char *line)
{
    uint8_t bytes[MANIFEST_BYTES];
    struct manifest back;
    char err[256] = "";

    const uint32_t size = manifest_pack(m, bytes);
    assert_false(manifest_unpack(bytes, size, &back, err, sizeof err));
    assert_string_equal(err, line);
}

#define SPOILED(statement, line)                                                                                       \
    do {                                                                                                               \
        struct manifest m = r->m;                                                                                      \
        statement;                                                                                                     \
        unpack_refused(&m, line);                                                                                      \
    } while (0)

TEST(check)
{
    static const char words[] = "difficulties: expected 1 to 8 different words of at most 15 letters";
    static const char coins[] = "dip.coins: expected 1 to 16 different words of at most 15 letters";
    static const char either[] = "dip.coins: expected either a range or 1 to 16 values";
    struct result *r = read_good(lanterns);

    SPOILED(m.id[20] = 'x', "id: expected 1 to 31 of the characters a-z 0-9 _");
    SPOILED(m.nvram_kib = 1025, "board.nvram: expected a whole number from 1 to 1024, got 1025");
    SPOILED(m.n_extends = 9, "extends: expected at most 8 scores");
    SPOILED(m.n_extends = -1, "extends: expected at most 8 scores");
    SPOILED(m.extends[2] = 1, "extends: expected at most 8 scores");
    SPOILED(m.extends[1] = 100000, "extends: expected ascending scores from 1 to 9007199254740992, got 100000");
    SPOILED(m.extends[1]++, "extends: expected ascending scores from 1 to 9007199254740992, got 9007199254740993");
    SPOILED(m.n_difficulties = 0, words);
    SPOILED(m.n_difficulties = 9, words);
    SPOILED(m.n_difficulties = 4, words);
    SPOILED(m.n_difficulties = 2, words);
    SPOILED(memcpy(m.difficulties[1], m.difficulties[0], MAX_SETTING_NAME), words);
    SPOILED(m.difficulty = 3, "difficulty: not listed in difficulties");
    SPOILED(m.difficulty = -1, "difficulty: not listed in difficulties");
    SPOILED(m.n_dips = 17, "dip: expected at most 16 switches");
    SPOILED(m.n_dips = -1, "dip: expected at most 16 switches");
    SPOILED(m.n_dips = 4, "dip: expected names of 1 to 15 letters, digits, _ or -");
    SPOILED(m.n_dips = 2, "dip: unused switches are not zero");
    SPOILED(m.dips[0].name[0] = 'x', "dip.n: not in alphabetical order");
    SPOILED(m.dips[0].n_values = 17, coins);
    SPOILED(m.dips[0].n_values = -1, coins);
    SPOILED(m.dips[0].n_values = 1, coins);
    SPOILED(m.dips[0].hi = 2, either);
    SPOILED(m.dips[0].is_number = true, either);
    SPOILED(m.dips[0].default_value = 2, "dip.coins: expected min <= default <= max, got 0, 2, 1");
    SPOILED(m.dips[2].default_value = -2, "dip.rate: expected min <= default <= max, got -1, -2, 10");
}

TEST(paths)
{
    static const char *const good[] = { "a", "a/b", "stages/one.lua", "A-b_c.9/x..y" };
    static const char *const bad[] = { "", "/a", "a/", "a//b", "..", "a/.b", "a b", "a\\b", "\xc3" };

    for (size_t i = 0; i < sizeof good / sizeof good[0]; i++)
        assert_true(manifest_path_ok(good[i]));
    for (size_t i = 0; i < sizeof bad / sizeof bad[0]; i++)
        assert_false(manifest_path_ok(bad[i]));
}

RUN_TESTS(NULL, NULL)
