/*
 * test_demo.c - demo.h: recordings of a small game, written, read, cut, damaged and gone back in. The game faults when
 * select is down; its script acts in every frame in which start is.
 */
#define _POSIX_C_SOURCE 200809L /* mkdtemp */
#include <unistd.h>
#include "../machine/rig.h"
#include "../../platform/platform.h"
#include "../repair.h"
#include "../temp.h"

enum { MOST = 2 << 20 };

static char dir[256], path[300], err[512];
static struct rig_game game;
static struct rig rig;

/* A recording: its board, what the writer holds, and what is read back. */
static const struct board_start plain = { .seed = 1, .difficulty = -1 };
static const uint16_t no_pads[MAX_PLAYERS], select_pads[MAX_PLAYERS] = { PAD_SELECT };
static struct board *b;
static struct demo_writer w;
static struct demo d;
static struct rng rng;
static uint8_t file[MOST];

static int setup(void **state)
{
    static const char script[] = "task.go(function()\n"
                                 "  while true do\n"
                                 "    if pad.down(\"select\") then error(\"select\") end\n"
                                 "    if pad.down(\"start\") then board.note(1) end\n"
                                 "    wait(1)\n"
                                 "  end\n"
                                 "end)\n";
    static const char *const langs[] = { "lang/d", "lang/123456789_abcde" };
    struct manifest m = rig_manifest();

    (void)state;
    if (!temp_folder(dir, sizeof dir, "Demo"))
        return -1;
    snprintf(path, sizeof path, "%s/a.demo", dir);
    m.n_dips = 2;
    m.dips[0] = (struct dip){ .name = "coins", .hi = 1, .n_values = 2, .value_name = { "free", "one" } };
    m.dips[1] = (struct dip){ .name = "lives", .is_number = true, .lo = 0, .hi = 9 };
    rig_script(&game, &m, script);
    for (int i = 0; i < 2; i++)
        rig_lump(&game, langs[i], (const uint8_t *)"\0\0\0", 4); /* of no texts */
    return 0;
}

static int teardown(void **state)
{
    (void)state;
    remove(path);
    rmdir(dir);
    rig_close(&rig);
    return 0;
}

/* ---- recording and reading ---- */

static void power(const struct board_start *start)
{
    rig_free(&rig);
    rig_power(&rig, &game, start);
    b = rig.b;
}

static void begin(const struct board_start *start, unsigned flags)
{
    power(start);
    rng_seed(&rng, 1);
    assert_true(demo_begin(&w, path, &game.cart, b, start, flags));
}

/* Ticks and records n frames of any pads and codes but select, held for some frames as by hands. */
static void play(uint32_t n)
{
    uint16_t pads[MAX_PLAYERS] = { 0 };

    for (uint32_t f = 0; f < n; f++) {
        for (int i = 0; i < MAX_PLAYERS; i++)
            if (rng_below(&rng, 8) == 0)
                pads[i] = (uint16_t)((rng_below(&rng, PAD_ALL + 1) & ~(uint64_t)PAD_SELECT) | rng_below(&rng, CODE_END)
                                                                                                  << PAD_CODE_SHIFT);
        board_tick(b, pads);
        assert_true(demo_record_frame(&w, b, pads));
    }
}

static void play_fault(void)
{
    board_tick(b, select_pads);
    assert_non_null(board_last_output(b)->fault);
    assert_true(demo_record_frame(&w, b, select_pads));
}

/* Frames with markers: the kinds in turn, at every 7th frame; every 21st has two, with names of all lengths. */
static void play_markers(uint32_t n)
{
    static const char name[] = "0123456789abcdefghijklmnopqrstuvwxyz";

    for (uint32_t i = 0; i < n; i++) {
        board_tick(b, no_pads);
        uint32_t f = board_frame(b);
        if (f % 7 == 0)
            board_add_marker(b, (enum board_marker_kind)(f / 7 % MARKER_KINDS), name + f / 7 % sizeof name, "", "",
                             f % 14 == 0 ? (int32_t)(f * 0x1234567u) : 0);
        if (f % 21 == 0)
            board_add_marker(b, MARKER_DEATH, "2", "", "", 0);
        assert_true(demo_record_frame(&w, b, no_pads));
    }
}

static void go_back(uint32_t frame)
{
    power(&plain);
    for (uint32_t f = 0; f < frame; f++)
        board_tick(b, w.demo.pads[f]);
    assert_true(demo_rewind(&w, frame));
}

static size_t read_bytes(void)
{
    long n = plat_load(path, file, sizeof file);

    assert_true(n > 0 && n < MOST);
    return (size_t)n;
}

static void read_demo(void)
{
    if (!demo_load(&d, path, err, sizeof err))
        fail_msg("%s", err);
}

static void free_demos(void)
{
    demo_free(&d);
    demo_writer_free(&w);
}

static void assert_same(const struct demo *x, const struct demo *y)
{
    const size_t parts = (size_t)x->n_parts;

    assert_int_equal(x->core_version, y->core_version);
    assert_true(x->game_hash == y->game_hash && x->rom_hash == y->rom_hash && x->start.seed == y->start.seed);
    assert_string_equal(x->id, y->id);
    assert_string_equal(x->lua_release, y->lua_release);
    assert_string_equal(x->start.lang, y->start.lang);
    assert_memory_equal(x->start.dip, y->start.dip, sizeof x->start.dip);
    assert_int_equal(x->start.difficulty, y->start.difficulty);
    assert_memory_equal(&x->start.practice, &y->start.practice, sizeof x->start.practice);
    assert_int_equal(x->start.nvram_size, y->start.nvram_size);
    assert_memory_equal(x->nvram, y->nvram, x->start.nvram_size);
    assert_int_equal(x->flags, y->flags);
    assert_int_equal(x->n_parts, y->n_parts);
    for (int i = 0; i < x->n_parts; i++)
        assert_string_equal(x->part_name[i], y->part_name[i]);
    assert_true(x->frames == y->frames && x->n_rows == y->n_rows && x->n_markers == y->n_markers);
    assert_true(x->checksum_parts == y->checksum_parts && x->checksum_frames == y->checksum_frames);
    if (x->frames)
        assert_memory_equal(x->pads, y->pads, x->frames * sizeof x->pads[0]);
    if (x->checksum_frames)
        assert_memory_equal(x->checksums, y->checksums, x->checksum_frames * parts * sizeof x->checksums[0]);
    assert_memory_equal(x->rows, y->rows, x->n_rows * parts * sizeof x->rows[0]);
    for (uint32_t i = 0; i < x->n_markers; i++) {
        const struct demo_marker *m = &x->markers[i], *o = &y->markers[i];
        assert_true(m->frame == o->frame && m->marker.kind == o->marker.kind && m->marker.value == o->marker.value);
        assert_string_equal(m->marker.name, o->marker.name);
    }
    assert_int_equal(x->complete, y->complete);
    assert_int_equal(x->fault, y->fault);
}

/* Reads the file; demo_save writes it again, byte for byte. */
static void read_and_save(void)
{
    static uint8_t before[MOST];
    const size_t n = read_bytes();

    memcpy(before, file, n);
    read_demo();
    if (!demo_save(&d, path, err, sizeof err))
        fail_msg("%s", err);
    assert_int_equal(read_bytes(), n);
    assert_memory_equal(file, before, n);
}

/* Ends the recording; the file says what the writer holds. */
static void end(void)
{
    assert_true(demo_end(&w, b));
    read_and_save();
    assert_same(&d, &w.demo);
    assert_true(d.complete);
}

/* A recording of n frames in `file`; returns its size. */
static size_t record(uint32_t n)
{
    begin(&plain, 0);
    play(n);
    end();
    return read_bytes();
}

/* ---- what is recorded is read ---- */

TEST(round_trip)
{
    static const uint32_t lengths[] = { 0, 1, 59, 60, 61, 200 };

    for (size_t i = 0; i < sizeof lengths / sizeof lengths[0]; i++) {
        record(lengths[i]);
        assert_int_equal(d.frames, lengths[i]);
        assert_int_equal(d.checksum_frames, lengths[i]);
        assert_int_equal(demo_row_frame(&d, d.n_rows - 1), lengths[i]);
        free_demos();
    }
}

/* Replays d on a board: a hash that differs is found in its part, every so many frames and after the last: by checksums
 * as far as 16 bits tell, by full rows to the last bit. */
static void check_hashes(uint32_t checksum_interval, uint32_t row_interval)
{
    uint64_t hashes[MAX_PARTS];
    uint16_t pads[MAX_PLAYERS], checksum;

    power(&d.start);
    for (uint32_t f = 0; f <= d.frames; f++) {
        const bool told = f % checksum_interval == 0 || f == d.frames, full = f % row_interval == 0 || f == d.frames;
        board_hashes(b, hashes);
        assert_int_equal(demo_has_checksums(&d, f), told);
        assert_int_equal(demo_hashes(&d, f) != NULL, full);
        assert_int_equal(demo_differing_parts(&d, f, hashes), 0);
        for (int i = 0; i < d.n_parts; i++) {
            assert_int_equal(demo_get_checksum(&d, f, i, &checksum), told);
            assert_true(!told || checksum == (uint16_t)hashes[i]);
            hashes[i] ^= 0x8000;
            assert_int_equal(demo_differing_parts(&d, f, hashes), told ? (uint64_t)1 << i : 0);
            hashes[i] ^= 0x10000 | 0x8000;
            assert_int_equal(demo_differing_parts(&d, f, hashes), full ? (uint64_t)1 << i : 0);
            hashes[i] ^= 0x10000;
        }
        demo_pads(&d, f, pads);
        board_tick(b, pads);
    }
    assert_true(pads[0] == 0 && pads[1] == 0);
    assert_true(demo_differing_parts(&d, d.frames + 1, hashes) == 0);
}

TEST(hashes)
{
    record(130);
    check_hashes(1, 60);
    free_demos();
}

static void fill_nvram(uint8_t *p, size_t n, int kind)
{
    for (size_t i = 0; i < n; i++)
        p[i] = kind == 0 ? (uint8_t)rng_next(&rng) : kind == 1 ? (uint8_t)(i / 2) : (uint8_t)(i / 131);
}

TEST(start)
{
    static const size_t sizes[] = { 1, 127, 128, 129, 130, 131, MAX_NVRAM };
    static const char *const langs[] = { "", "d", "123456789_abcde" };
    static uint8_t nvram[MAX_NVRAM];
    struct board_start start = { .seed = 0xfedcba9876543210u, .difficulty = 0, .nvram = nvram };

    for (int i = 0; i < MAX_DIPS; i++)
        start.dip[i] = i < game.cart.manifest.n_dips ? 0 : -i * 100000000;
    for (size_t i = 0; i < sizeof sizes / sizeof sizes[0]; i++)
        for (int kind = 0; kind < 3; kind++) {
            power(&plain);
            start.nvram_size = sizes[i];
            fill_nvram(nvram, sizes[i], kind);
            snprintf(start.lang, sizeof start.lang, "%s", langs[kind]);
            start.large_hud = kind == 1;
            assert_true(demo_begin(&w, path, &game.cart, b, &start, DEMO_ASSISTED));
            end();
            assert_memory_equal(d.start.nvram, nvram, sizes[i]);
            assert_string_equal(d.start.lang, langs[kind]);
            assert_int_equal(d.start.large_hud, kind == 1);
            assert_false(d.sparse);
            assert_int_equal(d.flags, DEMO_ASSISTED);
            free_demos();
        }
    start.lang[1] = (char)0xe9;
    assert_null(board_power_on(rig.ram, rig.ram_size, &game.image.rom, &start, err, sizeof err));
    assert_non_null(strstr(err, "language: expected printable ASCII"));
}

/* After a crash the file holds all but the second that was going on. */
TEST(crash)
{
    begin(&plain, 0);
    for (uint32_t f = 0; f < 130; f++) {
        read_demo();
        assert_false(d.complete);
        assert_int_equal(d.frames, f / 60 * 60);
        assert_int_equal(d.n_rows, f / 60 + 1);
        if (d.frames)
            assert_memory_equal(d.pads, w.demo.pads, d.frames * sizeof d.pads[0]);
        demo_free(&d);
        play(1);
    }
    read_and_save();
    free_demos();
}

TEST(cut)
{
    const size_t n = record(200);
    uint32_t frames = 0;

    free_demos();
    for (size_t i = 0; i < n; i++) {
        uint8_t *part = malloc(i + 1); /* so that a sanitizer sees a byte too far */
        memcpy(part, file, i);
        const bool good = demo_read(&d, part, i, err, sizeof err);
        free(part);
        assert_true(good || frames == 0);
        if (!good)
            continue;
        assert_false(d.complete);
        assert_true(d.frames >= frames && (d.frames % 60 == 0 || d.frames == 200));
        frames = d.frames;
        demo_free(&d);
    }
    assert_int_equal(frames, 200);
}

TEST(flips)
{
    const size_t n = record(100);

    free_demos();
    for (size_t i = 0; i < n * 8; i++) {
        file[i / 8] ^= (uint8_t)(1 << i % 8);
        if (demo_read(&d, file, n, err, sizeof err)) {
            assert_false(d.complete); /* a length: it looks cut */
            demo_free(&d);
        }
        file[i / 8] ^= (uint8_t)(1 << i % 8);
    }
}

/* ---- records by hand ---- */

static size_t record_at(int i)
{
    size_t at = 8;

    while (i-- > 0)
        at += 12 + bytes_get32(file + at + 4);
    return at;
}

static size_t find(const char *what)
{
    size_t at = 0;

    while (memcmp(file + at, what, strlen(what)) != 0)
        at++;
    return at;
}

static void refused(size_t n, const char *part)
{
    struct demo bad;

    err[0] = 0;
    assert_false(demo_read(&bad, file, n, err, sizeof err));
    assert_true(!bad.pads && !bad.checksums && !bad.rows);
    if (strstr(err, part) == NULL)
        fail_msg("\"%s\" does not say \"%s\"", err, part);
}

/* Changes a byte, makes the CRCs good, and expects a refusal. */
static void refused_with(size_t n, size_t at, int value, const char *part)
{
    uint8_t old = file[at];

    file[at] = (uint8_t)value;
    repair_demo(file, n);
    refused(n, part);
    file[at] = old;
    repair_demo(file, n);
}

/* Makes the payload of record i longer by that many bytes, which stand at its end, or shorter; returns the file's
 * size. */
static size_t resize(int i, int by)
{
    size_t n = read_bytes(), at = record_at(i), size = bytes_get32(file + at + 4), tail = at + 8 + size;

    memmove(file + tail + by, file + tail, n - tail);
    bytes_put32(file + at + 4, (uint32_t)((int)size + by));
    n = (size_t)((long)n + by);
    repair_demo(file, n);
    return n;
}

TEST(bad_records)
{
    size_t n = record(300), from = record_at(3), to = record_at(4);

    free_demos();
    memmove(file + from, file + to, n - to); /* a lost second: each record alone is good */
    refused(n - (to - from), "CRC");
    n = read_bytes();
    file[n] = 0;
    refused(n + 1, "1 extra bytes after its end");
    n = record(100);
    free_demos();
    const size_t head = record_at(0) + 8, first = record_at(1) + 8, second = record_at(2) + 8;
    const size_t mark = record_at(4 + MAX_PLAYERS) + 8; /* behind the points */
    refused(7, "not a demo");
    refused(8, "truncated header");
    refused_with(n, 0, 'X', "not a demo");
    refused_with(n, 4, 9, "demo format 9; this build reads 2");
    refused_with(n, record_at(0), 'S', "(no header)");
    refused_with(n, record_at(1), 'X', "(kind or size)");
    refused_with(n, record_at(2), 'H', "(second header)");
    refused_with(n, head + 21, 'A', "(header)"); /* the game's id */
    refused_with(n, head + 20, 200, "damaged");
    refused_with(n, find("script"), 'S', "(no script part)");
    refused_with(n, find("script") - 2, 65, "(the number of parts)");
    refused_with(n, first + 4, 1, "(number of frames)");
    refused_with(n, second, 1, "(frames out of order)");
    refused_with(n, second + 4, 61, "(number of frames)");
    refused_with(n, second + 4, 59, "(pads)");
    refused_with(n, second + 5, 0, "(pads)");
    refused_with(n, second + 6, 2, "(frames out of order)");
    refused_with(n, second + 6, 0, "(size)");
    refused_with(n, second + 8, 0, "(pads)");
    refused_with(n, second + 9, 0xff, "(pads)");           /* a run far longer than the second */
    refused_with(n, second + 11, CODE_END << 2, "(pads)"); /* a code that is none */
    refused_with(n, mark, 99, "(end mark)");
    refused_with(n, mark + 4, FAULT_LOOP + 1, "(end mark)");
    refused_with(n, mark + 4, FAULT_SCRIPT, "the end mark does not match the frames");
    for (int i = 1; i <= 3; i++) {
        refused(resize(i, -1), "(size)");
        refused(resize(i, 1), "(size)");
    }
}

/* Only the last second may have no hashes. */
TEST(bad_second_after_fault)
{
    begin(&plain, 0);
    play(59);
    play_fault();
    end();
    free_demos();
    size_t n = read_bytes(), tail = record_at(3), second = record_at(2);
    memmove(file + tail, file + second, tail - second); /* the second once more, as the next one */
    n = tail + (tail - second);
    file[tail + 8] = 60;
    repair_demo(file, n);
    refused(n, "frames out of order");
}

/* An nvram that would unpack to more than there is room for, or to less than it says. */
TEST(bad_nvram)
{
    static uint8_t nvram[1000];
    const struct board_start start = { .difficulty = -1, .nvram = nvram, .nvram_size = sizeof nvram };

    power(&plain);
    assert_true(demo_begin(&w, path, &game.cart, b, &start, 0));
    end();
    free_demos();
    size_t n = read_bytes(), coded = record_at(1) - 4 - 16, size = coded - 4; /* 8 runs, 2 bytes each */
    assert_int_equal(bytes_get32(file + size), 1000);
    refused_with(n, size, 0xe7, "(nvram)");
    refused_with(n, size, 0xe9, "(nvram)");
    refused_with(n, size + 2, 1, "(nvram)");
    refused_with(n, coded, 200, "(nvram)");
    refused_with(n, coded + 14, 127, "(nvram)");
}

/* A practice start with everything in it; and what it may not say. */
TEST(practice)
{
    struct board_start start = plain;
    struct practice *p = &start.practice;

    power(&plain);
    snprintf(p->section, sizeof p->section, "%063d", 0);
    p->lives = 99;
    p->invincible = true;
    p->register_count = PRACTICE_MAX_REGISTERS;
    for (int i = 0; i < PRACTICE_MAX_REGISTERS; i++) {
        snprintf(p->reg[i].name, sizeof p->reg[i].name, "%0*d", 1 + 2 * i, i);
        p->reg[i].value = i % 2 ? INT32_MIN + i : INT32_MAX - i;
    }
    assert_true(demo_begin(&w, path, &game.cart, b, &start, 0));
    end();
    assert_memory_equal(&d.start.practice, p, sizeof *p);
    free_demos();
    size_t n = read_bytes(), at = find(p->section) + strlen(p->section); /* its fields: behind the section */
    assert_int_equal(file[at], 99);
    refused_with(n, at, 100, "(header)");
    refused_with(n, at + 3, 0x80, "(header)");
    refused_with(n, at + 4, 2, "(header)");
    refused_with(n, at + 5, PRACTICE_MAX_REGISTERS + 1, "damaged");
    refused_with(n, at + 5, PRACTICE_MAX_REGISTERS - 1, "damaged");
    refused_with(n, at + 7, 31, "(header)"); /* a register's name */
    refused_with(n, at + 6, 32, "damaged");
}

/* ---- markers and points ---- */

TEST(markers)
{
    static const uint32_t back[] = { 0, 60, 63, 126, 169 };

    begin(&plain, 0);
    play_markers(300);
    assert_int_equal(w.demo.n_markers, 300 / 7 + 300 / 21);
    read_demo(); /* not ended yet */
    assert_int_equal(d.n_markers, w.demo.n_markers);
    demo_free(&d);
    play_markers(43); /* the last frame has one */
    end();
    assert_int_equal(d.n_markers, 343 / 7 + 343 / 21 + MAX_PLAYERS); /* and the points */
    assert_int_equal(d.markers[0].frame, 7);
    assert_int_equal(strlen(d.markers[0].marker.name), sizeof d.markers[0].marker.name - 1); /* cut to fit */
    free_demos();
    for (size_t i = 0; i < sizeof back / sizeof back[0]; i++) { /* going back forgets those that came after */
        const uint32_t to = back[i];
        begin(&plain, 0);
        play_markers(170);
        go_back(to);
        assert_int_equal(w.demo.n_markers, to / 7 + to / 21);
        play_markers(100);
        end();
        assert_int_equal(d.n_markers, (to + 100) / 7 + (to + 100) / 21 + MAX_PLAYERS);
        free_demos();
    }
}

TEST(bad_markers)
{
    int at = 0;

    begin(&plain, 0);
    play_markers(100);
    end();
    free_demos();
    const size_t n = read_bytes();
    while (file[record_at(at)] != 'M')
        at++;
    assert_int_equal(file[record_at(at + 1)], 'M'); /* the 14th frame's, which has a value */
    const size_t value = record_at(at + 2) - 4 - 4;
    assert_int_equal(bytes_get32(file + value), 14 * 0x1234567u);
    bytes_put32(file + value, 0);
    repair_demo(file, n);
    refused(n, "(marker)"); /* a value of 0 is not written */
    assert_int_equal(read_bytes(), n);
    const size_t first = record_at(at) + 8, second = record_at(at + 1) + 8;
    refused_with(n, first, 15, "(marker)");  /* later than the next */
    refused_with(n, second, 6, "(marker)");  /* earlier than the one before */
    refused_with(n, second, 61, "(marker)"); /* before its frame is there */
    refused_with(n, second + 4, MARKER_KINDS, "(marker)");
    refused_with(n, second + 5, 32, "damaged");
    refused_with(n, second + 6, 31, "(size)");
    refused_with(n, record_at(1), 'M', "damaged"); /* before the first second */
    file[4] = 2;
    refused(n, "damaged");
    file[4] = 3; /* has no sets of parts of three bytes, either */
    refused(n, "damaged");
    refused(resize(at + 1, -1), "damaged");
    refused(resize(at, 1), "damaged");
}

/* A recording ends with what everybody had. */
TEST(points)
{
    static const int64_t points[][MAX_PLAYERS] = { { 0, 0 }, { 7, 999999999999 } };
    int64_t got;

    for (size_t i = 0; i < sizeof points / sizeof points[0]; i++) {
        begin(&plain, 0);
        memcpy(b->player.score, points[i], sizeof points[i]);
        play(60);
        read_demo();
        assert_false(demo_points(&d, 0, &got)); /* not ended yet */
        demo_free(&d);
        end();
        for (int p = 0; p < MAX_PLAYERS; p++)
            assert_true(demo_points(&d, p, &got) && got == points[i][p]);
        free_demos();
    }
}

TEST(bad_points)
{
    static const char *const texts[] = {
        "", "points", "points 1 ", "points 1 x", "points 1 05", "points 2 5", "points 1 5 ", "points 1 1234567890123"
    };
    struct demo_marker list[2] = { 0 };
    struct demo hand = { .markers = list, .n_markers = 1, .frames = 9, .complete = true };
    int64_t got;

    for (size_t i = 0; i < sizeof texts / sizeof texts[0]; i++) {
        list[0] = (struct demo_marker){ 9, { .kind = MARKER_LISTED } };
        snprintf(list[0].marker.name, sizeof list[0].marker.name, "%s", texts[i]);
        if (demo_points(&hand, 0, &got))
            fail_msg("\"%s\" is taken for points", texts[i]);
    }
    list[0] = (struct demo_marker){ 8, { .kind = MARKER_LISTED, .name = "points 1 5" } };
    assert_false(demo_points(&hand, 0, &got)); /* not of the last frame */
    list[0].frame = 9;
    list[0].marker.kind = MARKER_REGISTER;
    assert_false(demo_points(&hand, 0, &got));
    list[0].marker.kind = MARKER_LISTED;
    list[1] = (struct demo_marker){ 9, { .kind = MARKER_WAVE, .name = "wisp" } };
    hand.n_markers = 2;
    assert_true(demo_points(&hand, 0, &got) && got == 5);
    hand.complete = false;
    assert_false(demo_points(&hand, 0, &got));
}

/* ---- formats ---- */

/* As many parts as there may be, and sets of them of 1 to 8 bytes. */
TEST(many_parts)
{
    static const int counts[] = { 1, 7, 8, 9, 56, 57, 64 };
    static uint64_t track[2 * 64];
    static uint16_t checksums[59 * 64], pads[59][MAX_PLAYERS];
    static struct demo many;

    rng_seed(&rng, 64);
    for (size_t k = 0; k < sizeof counts / sizeof *counts; k++) {
        const int parts = counts[k];
        many = (struct demo){ .core_version = 9,
                              .id = "many",
                              .lua_release = "5.4",
                              .start.difficulty = -1,
                              .n_parts = parts,
                              .checksum_parts = UINT64_MAX,
                              .frames = 59,
                              .checksum_frames = 59,
                              .n_rows = 2,
                              .pads = pads,
                              .rows = track,
                              .checksums = checksums,
                              .complete = true };
        for (int i = 0; i < parts; i++)
            snprintf(many.part_name[i], sizeof many.part_name[i], i ? "part%d" : "script", i);
        for (int i = 0; i < 2 * parts; i++)
            track[i] = rng_next(&rng);
        for (int i = 0; i < 58 * parts; i++) /* some as in the frame before */
            checksums[i] = i < parts || rng_below(&rng, 2) ? (uint16_t)rng_next(&rng) : checksums[i - parts];
        for (int i = 0; i < parts; i++)
            checksums[58 * parts + i] = (uint16_t)track[parts + i];
        assert_true(demo_save(&many, path, err, sizeof err));
        read_demo();
        assert_same(&d, &many);
        demo_free(&d);
        const size_t n = read_bytes(), mask = record_at(2) + 8 + 8 + 6, bytes = (size_t)(parts + 7) / 8;
        if (parts % 8)
            refused_with(n, mask + bytes - 1, file[mask + bytes - 1] | 0x80, "damaged");
    }
}

/* A demo of format 3 says the same in the newest. */
TEST(format_3)
{
    struct demo old;

    if (!demo_load(&old, "tests/demos/frozen-3.demo", err, sizeof err))
        fail_msg("%s", err);
    assert_int_equal(old.format, 3);
    assert_true(old.complete && old.frames == 905 && old.n_rows == 17 && old.checksum_parts == UINT64_MAX);
    assert_true(demo_save(&old, path, err, sizeof err));
    read_demo();
    assert_int_equal(d.format, DEMO_FORMAT);
    assert_same(&d, &old);
    demo_free(&old);
    free_demos();
}

/* A demo of format 2, written by the program of its time, has checksums of the part script alone. */
TEST(format_2)
{
    uint64_t hashes[MAX_PARTS];

    if (!demo_load(&d, "tests/demos/frozen-2.demo", err, sizeof err))
        fail_msg("%s", err);
    assert_int_equal(d.format, 2);
    assert_true(d.complete && d.frames == 905 && d.checksum_frames == 905 && d.n_rows == 17 && d.n_markers == 0);
    assert_int_equal(d.checksum_parts, 1u << 0);
    assert_string_equal(d.part_name[0], "script");
    assert_true(d.start.practice.lives == 0 && !d.start.practice.invincible && d.start.practice.register_count == 0);
    for (uint32_t f = 0; f <= d.frames; f++) {
        const uint64_t *row = demo_hashes(&d, f);
        assert_int_equal(row != NULL, f % 60 == 0 || f == d.frames);
        memset(hashes, 0, sizeof hashes);
        hashes[0] = f ? demo_checksums(&d, f)[0] : row[0];
        assert_int_equal(demo_differing_parts(&d, f, hashes), row ? (f ? 0xfffff : 0xffffe) : 0);
        hashes[0] ^= 1;
        assert_int_equal(demo_differing_parts(&d, f, hashes) & 1, 1);
    }
    assert_false(demo_save(&d, path, err, sizeof err)); /* it says too little for the newest format */
    assert_non_null(strstr(err, "no per-part checksums"));
    free_demos();
}

/* ---- sparse ones ---- */

/* Checksums of seconds alone; the last row is full wherever it ends, and one a minute is. */
static void record_sparse(uint32_t n)
{
    begin(&plain, 0);
    assert_true(demo_set_checksum_rate(&w, DEMO_CHECKSUMS_EVERY_SECOND));
    play(n);
    assert_true(demo_end(&w, b));
}

TEST(sparse)
{
    static const uint32_t lengths[] = { 0, 1, 60, 61, 3599, 3600, 3601, 3660 };

    for (size_t i = 0; i < sizeof lengths / sizeof lengths[0]; i++) {
        record_sparse(lengths[i]);
        read_and_save();
        assert_true(d.complete && d.sparse && !d.checksums && d.frames == lengths[i]);
        assert_int_equal(d.n_rows, w.demo.n_rows);
        assert_memory_equal(d.pads, w.demo.pads, d.frames * sizeof d.pads[0]);
        for (uint32_t row = 0; row < d.n_rows; row++) {
            const bool full = row % 60 == 0 || row + 1 == d.n_rows;
            assert_int_equal(demo_row_is_full(&d, row), full);
            for (uint32_t k = row * (uint32_t)d.n_parts; k < (row + 1) * (uint32_t)d.n_parts; k++)
                assert_true(d.rows[k] == (full ? w.demo.rows[k] : (uint16_t)w.demo.rows[k]));
        }
        free_demos();
    }
    record_sparse(130);
    read_demo();
    assert_null(demo_checksums(&d, 60));
    check_hashes(60, 3600);
    free_demos();
}

/* What nobody chose for is dense while it is short; a second beyond that the file is written anew. Gone back in, it
 * stays as it is. */
TEST(grows_long)
{
    begin(&plain, 0);
    play(DEMO_DENSE_FRAMES + 59);
    read_demo();
    assert_true(!d.sparse && d.frames == DEMO_DENSE_FRAMES);
    demo_free(&d);
    const size_t dense = read_bytes();
    play(1);
    assert_true(w.demo.sparse && read_bytes() < dense / 2);
    read_demo();
    assert_true(d.sparse && d.frames == DEMO_DENSE_FRAMES + 60 && !d.complete);
    demo_free(&d);
    go_back(90);
    play(50);
    assert_true(demo_end(&w, b));
    read_demo();
    assert_true(d.sparse && d.complete && d.frames == 140 && d.n_rows == 4);
    assert_true(demo_row_is_full(&d, 3) && !demo_row_is_full(&d, 2));
    free_demos();
}

/* ---- going back, flags, faults ---- */

TEST(rewind)
{
    static const uint32_t to[] = { 0, 1, 59, 60, 61, 150 };

    for (size_t i = 0; i < sizeof to / sizeof to[0]; i++) {
        begin(&plain, 0);
        play(150);
        go_back(to[i]);
        assert_int_equal(w.demo.checksum_frames, to[i]);
        play(75);
        end();
        assert_int_equal(d.frames, to[i] + 75);
        assert_int_equal(d.n_rows, 1 + (d.frames + 59) / 60);
        assert_int_equal(d.flags, DEMO_BRANCHED);
        free_demos();
    }
}

TEST(flags)
{
    begin(&plain, 0);
    play(70);
    assert_true(demo_add_flags(&w, DEMO_ASSISTED));
    read_demo();
    assert_int_equal(d.flags, DEMO_ASSISTED); /* at once, not at the end */
    demo_free(&d);
    assert_true(demo_add_flags(&w, DEMO_TOUCHED));
    assert_true(demo_end(&w, b));
    read_demo();
    assert_int_equal(d.flags, DEMO_ASSISTED | DEMO_TOUCHED);
    free_demos();
}

/* A run that ends in a fault holds the tick that faulted, and no hash after it. */
TEST(fault)
{
    static const uint32_t at[] = { 0, 30, 59, 60 };

    for (size_t i = 0; i < sizeof at / sizeof at[0]; i++) {
        uint64_t hashes[MAX_PARTS], none[MAX_PARTS] = { 0 };
        begin(&plain, 0);
        play(at[i]);
        board_hashes(b, hashes);
        play_fault();
        end();
        assert_int_equal(d.fault, FAULT_SCRIPT);
        assert_int_equal(d.frames, at[i] + 1);
        assert_int_equal(d.checksum_frames, at[i]);
        assert_int_equal(d.n_rows, 1 + at[i] / 60);
        assert_int_equal(demo_differing_parts(&d, at[i], hashes), 0);
        assert_int_not_equal(demo_differing_parts(&d, at[i], none), 0); /* the last good frame has its checksums */
        assert_int_equal(demo_differing_parts(&d, at[i] + 1, none), 0);
        assert_int_equal(d.pads[at[i]][0], PAD_SELECT);
        free_demos();
    }
}

/* ---- other games, no file ---- */

static void misfits(const char *part)
{
    assert_false(demo_check_cart(&d, &game.cart, err, sizeof err));
    if (strstr(err, part) == NULL)
        fail_msg("\"%s\" does not say \"%s\"", err, part);
}

/* A start from another build, or made up, never reaches a board that does not know it. */
TEST(foreign)
{
    static const struct {
        int dip;
        int32_t good, bad;
    } rows[] = { { 0, 1, 2 }, { 0, 0, -1 }, { 1, 9, 10 }, { 1, 0, INT32_MIN } };
    char warning[128];

    record(1);
    for (size_t i = 0; i < sizeof rows / sizeof rows[0]; i++) {
        d.start.dip[rows[i].dip] = rows[i].bad;
        misfits("DIP switch");
        d.start.dip[rows[i].dip] = rows[i].good;
        assert_true(demo_check_cart(&d, &game.cart, err, sizeof err));
    }
    assert_null(demo_replay_warning(&d, &game.cart, warning, sizeof warning));
    d.start.difficulty = 1;
    misfits("difficulty");
    d.game_hash++;
    assert_string_equal(demo_replay_warning(&d, &game.cart, warning, sizeof warning),
                        "recorded with another game version");
    d.core_version += 6;
    assert_non_null(strstr(demo_replay_warning(&d, &game.cart, warning, sizeof warning), "recorded with core version"));
    d.id[0] = 'z';
    misfits("another game");
    free_demos();
}

/* Where nothing can be written the recording continues in memory, and says so at once and at its end. */
TEST(no_file)
{
    assert_false(demo_load(&d, dir, err, sizeof err)); /* a folder has that name */
    assert_non_null(strstr(err, dir));
    power(&plain);
    assert_false(demo_begin(&w, dir, &game.cart, b, &plain, 0));
    assert_non_null(strstr(w.err, "cannot be written"));
    assert_non_null(strstr(w.err, dir));
    play(130);
    assert_int_equal(w.demo.frames, 130);
    w.err[0] = '\0';
    assert_false(demo_end(&w, b));
    assert_non_null(strstr(w.err, "cannot be written"));
    demo_writer_free(&w);
}

TEST(idle_writer)
{
    power(&plain);
    assert_true(demo_record_frame(&w, b, no_pads) && demo_add_flags(&w, 1) && demo_rewind(&w, 0) && demo_end(&w, b));
    assert_int_equal(w.demo.frames, 0);
    assert_true(demo_begin(&w, NULL, &game.cart, b, &plain, 0));
    assert_true(demo_end(&w, b) && demo_end(&w, b));
    demo_writer_free(&w);
}

RUN_TESTS(setup, teardown)
