/*
 * test_store.c - replays: cards and pictures, whatever their bytes are; the folder of a game, and how it repairs
 * itself; which go and which stay; kept ROMs.
 */
#define _POSIX_C_SOURCE 200809L /* mkdtemp, setenv */
#include "../test.h"
#include "../../platform/platform.h"
#include "../../src/base/bytes.h"
#include "../../src/base/hash.h"
#include "../../src/player/replays/replays.h"
#include "../../src/player/replays/roms.h"
#include "../temp.h"

enum { DATE = 1790000000 };

static char dir[256], err[512];
static struct unsaved *unsaved; /* none is: the disk takes all */

static void shell(const char *format)
{
    char command[1024];

    snprintf(command, sizeof command, "cd '%s' && %s", dir, format);
    assert_int_equal(system(command), 0);
}

static int open_folder(void **state)
{
    (void)state;
    assert_true(temp_folder(dir, sizeof dir, "curtain-store"));
    return setenv("XDG_DATA_HOME", dir, 1);
}

static int close_folder(void **state)
{
    (void)state;
    shell("rm -rf curtain");
    return remove(dir);
}

/* ---- cards ---- */

static struct replay_meta a_card(int i)
{
    struct replay_meta c = { .date = DATE + i,
                             .rom = 0x1234567890abcdef + (uint64_t)i,
                             .game = 77,
                             .seed = UINT64_MAX - (uint64_t)i,
                             .core = 8,
                             .flags = DEMO_RESUMED,
                             .first = 145,
                             .last = 17091,
                             .end = REPLAY_CLEAR,
                             .players = 2,
                             .stages = 5,
                             .id = "lanterns",
                             .ship = "heron",
                             .difficulty = "hard",
                             .points = { 999999999999, i },
                             .rows = 2 };

    for (int r = 0; r < c.rows; r++) {
        c.row[r].row = (struct nv_row){ .name = "AB.!", .ship = "heron", .score = 1000 * i + r, .stage = 15 };
        snprintf(c.row[r].table, sizeof c.row[r].table, "hard");
    }
    return c;
}

static void same_card(const struct replay_meta *a, const struct replay_meta *b)
{
    uint8_t bytes_a[REPLAY_META_BYTES], bytes_b[REPLAY_META_BYTES];
    const struct thumb none = { 0 };
    const size_t n = replay_meta_write(a, &none, bytes_a);

    assert_int_equal(replay_meta_write(b, &none, bytes_b), n);
    assert_memory_equal(bytes_a, bytes_b, n);
    assert_string_equal(a->id, b->id);
    assert_string_equal(a->ship, b->ship);
    assert_string_equal(a->difficulty, b->difficulty);
    assert_string_equal(a->name, b->name);
    assert_true(a->rom == b->rom && a->seed == b->seed && a->end == b->end && a->rows == b->rows);
    assert_memory_equal(a->points, b->points, sizeof a->points);
    for (int i = 0; i < a->rows; i++) {
        assert_string_equal(a->row[i].table, b->row[i].table);
        assert_string_equal(a->row[i].row.name, b->row[i].row.name);
        assert_true(a->row[i].row.score == b->row[i].row.score);
    }
}

static struct thumb a_thumb(int w, int h)
{
    struct thumb t = { .w = w, .h = h };

    for (int i = 0; i < w * h; i++)
        t.pix[i] = (uint8_t)(i % THUMB_COLOURS);
    return t;
}

TEST(card)
{
    uint8_t bytes[REPLAY_META_BYTES];
    struct replay_meta c = a_card(3), back;
    struct thumb t, seen;

    replay_meta_take_name(&c, "caf\xc3\xa9 \xe3\x82\xab");
    for (int side = 0; side <= THUMB_SIDE; side += THUMB_SIDE / 2) {
        t = a_thumb(side, side);
        const size_t n = replay_meta_write(&c, &t, bytes);
        assert_in_range(n, 100, REPLAY_META_BYTES);
        assert_true(replay_meta_read(&back, bytes, n < REPLAY_META_HEAD ? n : REPLAY_META_HEAD)); /* as lists do */
        same_card(&c, &back);
        for (size_t cut = 0; cut < 100; cut++)
            assert_false(replay_meta_read(&back, bytes, cut));
        assert_int_equal(replay_meta_read_thumb(&seen, bytes, n), side > 0);
        assert_int_equal(seen.w, side);
        assert_memory_equal(seen.pix, t.pix, (size_t)(side * side));
        bytes[20] ^= 1;
        assert_false(replay_meta_read(&back, bytes, n));
    }
}

/* Metadata of format 1, which older versions wrote, has neither favourite mark nor stage nor mission. */
TEST(old_card)
{
    enum { BEFORE = 12 };
    uint8_t bytes[REPLAY_META_BYTES];
    struct replay_meta c = a_card(3), back;
    const struct thumb none = { 0 };

    c.rows = 0;
    replay_meta_write(&c, &none, bytes);
    const size_t n = bytes_get32(bytes + 8) - 3; /* without the flag and two empty strings before the number of rows */
    bytes_put32(bytes + 4, 1);
    bytes_put32(bytes + 8, (uint32_t)n);
    bytes[BEFORE + n - 1] = 0;
    bytes_put32(bytes + BEFORE + n, hash_crc32(bytes, BEFORE + n));
    assert_true(replay_meta_read(&back, bytes, BEFORE + n + 4));
    same_card(&c, &back);
}

/* The longest card is still within what lists read. */
TEST(longest)
{
    uint8_t bytes[REPLAY_META_BYTES];
    struct replay_meta c = a_card(1), back;
    struct thumb t = { 0 };

    memset(c.id, 'i', sizeof c.id - 1);
    memset(c.ship, 's', sizeof c.ship - 1);
    memset(c.difficulty, 'd', sizeof c.difficulty - 1);
    memset(c.name, 'n', sizeof c.name - 1);
    memset(c.stage, 'g', sizeof c.stage - 1);
    memset(c.mission, 'm', sizeof c.mission - 1);
    c.rows = REPLAY_MAX_ROWS;
    for (int i = 0; i < REPLAY_MAX_ROWS; i++) {
        memset(c.row[i].table, 't', sizeof c.row[i].table - 1);
        memset(c.row[i].row.name, 'r', sizeof c.row[i].row.name - 1);
        memset(c.row[i].row.ship, 'p', sizeof c.row[i].row.ship - 1);
    }
    const size_t n = replay_meta_write(&c, &t, bytes);
    assert_in_range(n, 400, REPLAY_META_HEAD);
    assert_true(replay_meta_read(&back, bytes, n));
    same_card(&c, &back);
}

/* One row more than a card has is refused, though it is whole and its CRC is right. */
TEST(too_many)
{
    enum { BEFORE = 12 };
    uint8_t bytes[REPLAY_META_BYTES];
    struct replay_meta c = a_card(1), back;
    const struct thumb t = { 0 };

    c.rows = 0;
    replay_meta_write(&c, &t, bytes);
    const size_t rows = BEFORE + bytes_get32(bytes + 8) - 1; /* their number is the last byte before them */
    c.rows = REPLAY_MAX_ROWS;
    memset(c.row, 0, sizeof c.row);
    replay_meta_write(&c, &t, bytes);
    const size_t n = BEFORE + bytes_get32(bytes + 8), row = (n - rows - 1) / REPLAY_MAX_ROWS;
    memcpy(bytes + n, bytes + n - row, row);
    bytes[rows]++;
    bytes_put32(bytes + 8, (uint32_t)(n + row - BEFORE));
    bytes_put32(bytes + n + row, hash_crc32(bytes, n + row));
    assert_false(replay_meta_read(&back, bytes, n + row + 4));
}

static void name_becomes(const char *want, const char *name)
{
    struct replay_meta c = { .rows = 0 };

    replay_meta_take_name(&c, name);
    assert_string_equal(c.name, want);
}

TEST(names)
{
    struct replay_meta c = { .rows = 0 };

    name_becomes("", " \t ");
    name_becomes("my best", "  my best ");
    name_becomes("a b", "a\nb\033");
    name_becomes("?", "\xff");
    replay_meta_take_name(&c, "1234567890123456789012345678901234567890123456\xc3\xa9"); /* no half of a letter */
    assert_int_equal(strlen(c.name), 46);
}

/* ---- what a demo tells ---- */

TEST(of_demo)
{
    struct demo_marker markers[] = {
        { 10, { .kind = MARKER_GAME, .name = "tern", .value = 1 } },
        { 400, { .kind = MARKER_OVER, .name = "quit", .value = 1 } },
        { 500, { .kind = MARKER_GAME, .name = "heron", .value = 2 } },
        { 600, { .kind = MARKER_STAGE, .name = "one" } },
        { 900, { .kind = MARKER_OVER, .name = "over", .value = 3 } },
        { 950, { .kind = MARKER_LISTED, .name = "points 1 120" } },
        { 950, { .kind = MARKER_LISTED, .name = "points 2 7" } },
    };
    struct demo d = { .id = "x", .frames = 950, .n_markers = 7, .markers = markers, .complete = true, .flags = 1 };
    struct replay_meta c;

    assert_true(replay_meta_of_demo(&c, &d));
    assert_string_equal(c.ship, "heron");
    assert_true(c.first == 500 && c.last == 950 && c.end == REPLAY_OVER && c.players == 2 && c.stages == 3);
    assert_true(c.points[0] == 120 && c.points[1] == 7 && c.flags == 1);
    d.n_markers = 4;
    assert_true(replay_meta_of_demo(&c, &d) && c.end == REPLAY_LEFT && c.stages == 0);
    d.fault = FAULT_SCRIPT;
    assert_true(replay_meta_of_demo(&c, &d) && c.end == REPLAY_FAULT);
    d.fault = FAULT_NONE;
    d.n_markers = 2;
    assert_true(replay_meta_of_demo(&c, &d) && c.end == REPLAY_QUIT && c.first == 10);
    d.n_markers = 0;
    assert_false(replay_meta_of_demo(&c, &d));
}

/* ---- pictures ---- */

TEST(thumb)
{
    static uint8_t memory[1 << 20];
    static const int sizes[][4] = { { 240, 320, 72, 96 }, { 384, 448, 82, 96 }, { 64, 40, 64, 40 }, { 480, 1, 96, 1 } };
    uint32_t rgb[256] = { 0, 0xffffff, 0xff0000, 0x0000ff };
    struct thumb t;
    struct fb fb;

    for (size_t i = 0; i < sizeof sizes / sizeof *sizes; i++) {
        fb_init(&fb, memory, sizes[i][0], sizes[i][1]);
        for (uint8_t colour = 0; colour < 4; colour++) {
            fb_fill(&fb, colour);
            thumb_make(&t, &fb, rgb);
            assert_int_equal(t.w, sizes[i][2]);
            assert_int_equal(t.h, sizes[i][3]);
            for (int k = 0; k < t.w * t.h; k++) /* the palette has these four exactly */
                assert_int_equal(thumb_colour(t.pix[k]), rgb[colour]);
        }
    }
    fb_init(&fb, memory, 192, 192);
    for (int i = 0; i < 192 * 192; i++)
        fb.pix[i / 192 * fb.pitch + i % 192] = (uint8_t)(i % 2); /* grey of black and white */
    thumb_make(&t, &fb, rgb);
    uint32_t sum = 0;
    for (int k = 0; k < t.w * t.h; k++)
        sum += thumb_colour(t.pix[k]) & 255;
    assert_in_range(sum / (uint32_t)(t.w * t.h), 118, 138);
}

/* ---- the folder ---- */

/* Any bytes do as a demo for what never reads it. */
static void add(struct replays *r, int i)
{
    const struct replay_meta c = a_card(i);
    const struct thumb t = a_thumb(72, 96);
    uint8_t bytes[64];

    memset(bytes, i & 255, sizeof bytes);
    if (!replays_add(r, bytes, sizeof bytes, &c, &t, err, sizeof err))
        fail_msg("%s", err);
}

/* Opens a folder of that many replays. */
static void open_new(struct replays *r, int n)
{
    shell("rm -rf curtain");
    assert_true(replays_open(r, "lanterns"));
    for (int i = 0; i < n; i++)
        add(r, i);
}

static void listed(struct replays *r, int n)
{
    replays_close(r);
    assert_true(replays_open(r, "lanterns"));
    assert_int_equal(r->n, n);
}

TEST(folder)
{
    struct replays r;
    struct thumb t;

    open_new(&r, 5);
    add(&r, 4); /* in the same second */
    listed(&r, 6);
    assert_string_equal(r.list[0].stem, "20260921-141324-002");
    assert_string_equal(r.list[1].stem, "20260921-141324");
    assert_int_equal(r.list[5].meta.points[1], 0); /* the oldest comes last */
    assert_true(r.list[0].meta.hash != 0 && r.list[0].meta.bytes == 64);
    assert_true(replays_thumb(&r, 3, &t) && t.w == 72);
    assert_true(replays_name(&r, 3, " kept ", err, sizeof err));
    assert_true(replays_delete(&r, 0, err, sizeof err));
    listed(&r, 5);
    assert_string_equal(r.list[2].meta.name, "kept");
    assert_true(replays_thumb(&r, 2, &t) && t.w == 72); /* a name leaves the picture */
    replays_close(&r);
    assert_true(replays_open(&r, "other")); /* each game has a folder of its own */
    assert_int_equal(r.n, 0);
    replays_close(&r);
}

static bool stands(void *of, const struct replay_meta_row *row)
{
    return row->row.score == *(int64_t *)of;
}

/* The oldest go; a name, and a row that stands, keep. */
TEST(prune)
{
    struct replays r;
    int64_t best = 1000; /* of replay 1 */
    uint64_t kept = 0;

    open_new(&r, 20);
    assert_true(replays_name(&r, 19 - 4, "four", err, sizeof err));
    assert_true(replays_set_favourite(&r, 19 - 2, true, err, sizeof err));
    replays_prune(&r, 5, stands, &best);
    listed(&r, 8);
    for (int i = 0; i < r.n; i++)
        kept |= (uint64_t)1 << r.list[i].meta.points[1];
    assert_int_equal(kept, 0x1f << 15 | 1 << 4 | 1 << 2 | 1 << 1);
    replays_prune(&r, 0, NULL, NULL);
    listed(&r, 2);
    assert_string_equal(r.list[0].meta.name, "four");
    assert_true(replays_set_favourite(&r, 1, false, err, sizeof err));
    replays_prune(&r, 0, NULL, NULL);
    listed(&r, 1);
    replays_close(&r);
}

TEST(rows)
{
    struct replays r;
    struct replay_meta_row row = { .table = "hard",
                                   .row = { .name = "XYZ", .ship = "tern", .score = 7, .continues = 2 } };

    open_new(&r, 5);
    assert_true(replays_add_row(&r, 2, &row, &unsaved, err, sizeof err));
    listed(&r, 5);
    assert_int_equal(replays_of_row(&r, "hard", &row.row), 2);
    assert_int_equal(replays_of_row(&r, "easy", &row.row), -1);
    assert_int_equal(replays_of_row(&r, "hard", &r.list[4].meta.row[1].row), 4);
    row.row.continues = 1;
    assert_int_equal(replays_of_row(&r, "hard", &row.row), -1);
    for (int i = 0; i < 5; i++) { /* more than there is room for: the last one counts */
        row.row.score = 100 + i;
        assert_true(replays_add_row(&r, 1, &row, &unsaved, err, sizeof err));
    }
    assert_int_equal(r.list[1].meta.rows, REPLAY_MAX_ROWS);
    assert_int_equal(replays_of_row(&r, "hard", &row.row), 1);
    replays_close(&r);
}

/* What a crash or a hand leaves: the list is right, and the folder after it. */
TEST(repair)
{
    struct replays r;
    const char *demo = "tests/demos/whole8-run.demo";
    static uint8_t bytes[1 << 21];
    struct replay_meta c = { .rows = 0 };

    shell("rm -rf curtain");
    const long n = plat_load(demo, bytes, sizeof bytes);
    assert_in_range(n, 1000, sizeof bytes - 1);
    struct demo d;
    assert_true(demo_read(&d, bytes, (size_t)n, err, sizeof err));
    assert_true(replay_meta_of_demo(&c, &d));
    demo_free(&d);
    assert_true(replays_open(&r, c.id));
    for (int i = 0; i < 5; i++) {
        c.date = DATE + i;
        assert_true(replays_add(&r, bytes, (size_t)n, &c, NULL, err, sizeof err));
    }
    char folder[64];
    snprintf(folder, sizeof folder, "cd curtain/replays/%s && ", r.id);
#define IN(command) (snprintf(line, sizeof line, "%s%s", folder, command), shell(line))
    char line[300];
    IN("rm 20260921-141320.card");                                         /* killed between demo and card */
    IN("head -c 50 20260921-141321.card >x && mv x 20260921-141321.card"); /* damaged */
    IN("rm 20260921-141322.demo");                                         /* killed between demo and card, going */
    IN("echo rubbish >20260921-141324.demo");                              /* not what its card is about */
    IN("echo rubbish >notes.txt && echo rubbish >bad.demo && echo x >bad.card && mkdir folder.demo");
    IN("touch -d 2020-01-01 y.demo.77.tmp");
    replays_close(&r);
    assert_true(replays_open(&r, c.id));
    assert_int_equal(r.n, 3);
    assert_string_equal(r.list[1].meta.name, "recovered"); /* it may have had a name: it does not go by itself */
    assert_string_equal(r.list[2].meta.name, "");
    assert_true(r.list[2].meta.date == DATE && r.list[2].meta.hash == r.list[0].meta.hash);
    assert_true(r.list[2].meta.first == c.first && r.list[2].meta.points[0] == c.points[0]);
    replays_close(&r);
    assert_true(replays_open(&r, c.id)); /* and now nothing is left to do: three cards, and the demos that are none */
    assert_int_equal(r.n, 3);
    assert_in_range(r.loaded, 1, 5 * REPLAY_META_HEAD);
    IN("test ! -e 20260921-141322.card && test ! -e y.demo.77.tmp && test -e notes.txt && test -e bad.demo");
    replays_close(&r);
#undef IN
}

/* ---- ROMs ---- */

TEST(roms)
{
    static uint8_t bytes[256], data[1];
    const struct lump lump = { "x", data, 1 };
    struct replay_meta c = a_card(1);
    struct replays r;
    struct rom rom;
    uint64_t hash[3];

    open_new(&r, 0);
    for (int i = 0; i < 3; i++) {
        data[0] = (uint8_t)i;
        rom_write(bytes, &lump, 1);
        assert_true(rom_open(&rom, bytes, rom_write_size(&lump, 1), err, sizeof err));
        hash[i] = rom_hash(&rom);
        assert_true(roms_store(&unsaved, "lanterns", &rom, err, sizeof err));
        assert_true(roms_store(&unsaved, "lanterns", &rom, err, sizeof err)); /* it is there */
        assert_true(roms_has("lanterns", hash[i]));
    }
    assert_true(roms_store(&unsaved, "lantern", &rom, err, sizeof err)); /* another game */
    c.rom = hash[1];
    assert_true(replays_add(&r, bytes, sizeof bytes, &c, NULL, err, sizeof err));
    replays_collect_roms(&r, hash[2]);
    assert_false(roms_has("lanterns", hash[0]));
    assert_true(roms_has("lanterns", hash[1]) && roms_has("lanterns", hash[2]));
    assert_true(replays_delete(&r, 0, err, sizeof err));
    replays_collect_roms(&r, 0);
    assert_false(roms_has("lanterns", hash[1]) || roms_has("lanterns", hash[2]));
    assert_true(roms_has("lantern", hash[2]));
    replays_close(&r);
}

/* ---- importing ---- */

static void expect_refusal(struct replays *r, const char *path, const struct rom *rom, const char *why)
{
    assert_false(replays_import(r, path, rom, err, sizeof err));
    if (!strstr(err, why))
        fail_msg("%s: %s", path, err);
}

TEST(imports)
{
    static const char demo[] = "tests/demos/whole8-run.demo";
    static uint8_t bytes[256], data[1];
    const struct lump lump = { "x", data, 1 };
    char path[ROMS_PATH], command[128];
    struct replays r;
    struct demo d;
    struct rom rom;

    shell("rm -rf curtain");
    rom_write(bytes, &lump, 1);
    assert_true(rom_open(&rom, bytes, rom_write_size(&lump, 1), err, sizeof err));
    assert_true(demo_load(&d, demo, err, sizeof err));
    assert_true(replays_open(&r, "other"));
    expect_refusal(&r, demo, &rom, "it was recorded in another game");
    replays_close(&r);
    assert_true(replays_open(&r, d.id));
    expect_refusal(&r, demo, &rom, "it was recorded in another version of this game, which is not stored here");
    expect_refusal(&r, "tests/machine/nvram-1.nv", &rom, "not a demo");
    shell("mkdir -p curtain/roms");
    roms_path(path, d.id, d.rom_hash);
    snprintf(command, sizeof command, "echo x >curtain/%s", path + strlen("user:"));
    shell(command);
    assert_true(replays_import(&r, demo, &rom, err, sizeof err));
    assert_true(r.n == 1 && r.list[0].meta.is_favourite == 1);
    expect_refusal(&r, demo, &rom, "it is in the list already");
    replays_close(&r);
    assert_true(replays_open(&r, d.id));
    assert_int_equal(r.n, 1);
    replays_close(&r);
    demo_free(&d);
}

RUN_TESTS(open_folder, close_folder)
