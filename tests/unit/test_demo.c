/*
 * test_demo.c - demo.h: recordings of a small game, written, read, cut, damaged and gone back in. The game faults when
 * select is down; its script acts in every frame in which start is.
 */
#define _POSIX_C_SOURCE 200809L /* mkdtemp */
#include <unistd.h>
#include "../test.h"
#include "../../platform/platform.h"
#include "../../src/base/bytes.h"
#include "../../src/base/hash.h"
#include "../../src/base/rng.h"
#include "../../src/machine/machine.h"
#include "../../src/demo/demo.h"
#include "../../src/workbench/pack/pack.h"
#include "../repair.h"
#include "../temp.h"

enum { MAX_LUMPS = 128, MOST = 1 << 20 };

static char dir[256], path[300], err[512];
static uint8_t rom_bytes[1 << 20];
static struct rom rom;
static struct cart cart;
static void *ram_block, *ram;
static size_t ram_size;

/* ---- a game ---- */

static int by_name(const void *a, const void *b)
{
    return strcmp(((const struct lump *)a)->name, ((const struct lump *)b)->name);
}

static void make_rom(void)
{
    static const char script[] = "task.go(function()\n"
                                 "  while true do\n"
                                 "    if pad.down(\"select\") then error(\"select\") end\n"
                                 "    if pad.down(\"start\") then board.note(1) end\n"
                                 "    wait(1)\n"
                                 "  end\n"
                                 "end)\n";
    static uint8_t manifest[MANIFEST_BYTES], palette[CART_PALETTE_SIZE];
    static char names[MAX_LUMPS][64];
    struct lump lumps[MAX_LUMPS];
    struct manifest m;
    int n = 0;

    manifest_set_defaults(&m);
    m.n_dips = 2;
    m.dips[0] = (struct dip){ .name = "coins", .hi = 1, .n_values = 2, .value_name = { "free", "one" } };
    m.dips[1] = (struct dip){ .name = "lives", .is_number = true, .lo = 0, .hi = 9 };
    const uint32_t manifest_size = manifest_pack(&m, manifest);
    lumps[n++] = (struct lump){ "manifest", manifest, manifest_size };
    lumps[n++] = (struct lump){ "palette/main", palette, sizeof palette };
    lumps[n++] = (struct lump){ "script/main.lua", (const uint8_t *)script, sizeof script - 1 };
    static const char *const langs[] = { "lang/d", "lang/deutsch", "lang/123456789_abcde" };
    for (int i = 0; i < 3; i++)
        lumps[n++] = (struct lump){ langs[i], (const uint8_t *)"\0\0\0", 4 }; /* of no texts */
    for (int i = 0; i < std_script_count; i++, n++) {
        snprintf(names[n], sizeof names[n], "script/@std/%s.lua", std_scripts[i].name);
        lumps[n] = (struct lump){ names[n], std_scripts[i].data, (uint32_t)std_scripts[i].size };
    }
    qsort(lumps, (size_t)n, sizeof lumps[0], by_name);
    assert_true(rom_write_size(lumps, n) <= sizeof rom_bytes);
    rom_write(rom_bytes, lumps, n);
    if (!rom_open(&rom, rom_bytes, rom_write_size(lumps, n), err, sizeof err) ||
        !cart_open(&cart, &rom, err, sizeof err) || !board_size(&rom, &ram_size, err, sizeof err))
        fail_msg("%s", err);
    ram_block = malloc(ram_size + 16);
    ram = (uint8_t *)ram_block + (16 - (uintptr_t)ram_block % 16) % 16;
}

static int setup(void **state)
{
    (void)state;
    if (!temp_folder(dir, sizeof dir, "Demo"))
        return -1;
    snprintf(path, sizeof path, "%s/a.demo", dir);
    make_rom();
    return 0;
}

static int teardown(void **state)
{
    (void)state;
    remove(path);
    rmdir(dir);
    free(ram_block);
    return 0;
}

static struct board *power(const struct board_start *start)
{
    struct board *b = board_power_on(ram, ram_size, &rom, start, err, sizeof err);

    if (b == NULL || board_last_output(b)->fault != NULL)
        fail_msg("%s", b ? board_last_output(b)->fault->message : err);
    return b;
}

/* Any pads but select, held for some frames as by hands. */
static void next_pads(struct rng *r, uint16_t pads[MAX_PLAYERS])
{
    for (int i = 0; i < MAX_PLAYERS; i++) {
        if (rng_below(r, 8) == 0)
            pads[i] = (uint16_t)(rng_below(r, PAD_ALL + 1) & ~(uint64_t)PAD_SELECT);
    }
}

/* Ticks and records n frames. */
static void play(struct demo_writer *w, struct board *b, struct rng *r, uint32_t n)
{
    uint16_t pads[MAX_PLAYERS] = { 0 };

    for (uint32_t i = 0; i < n; i++) {
        next_pads(r, pads);
        board_tick(b, pads);
        assert_true(demo_record_frame(w, b, pads));
    }
}

/* ---- comparing ---- */

static void same(const struct demo *a, const struct demo *b)
{
    assert_int_equal(a->core_version, b->core_version);
    assert_true(a->game_hash == b->game_hash && a->rom_hash == b->rom_hash);
    assert_string_equal(a->id, b->id);
    assert_string_equal(a->lua_release, b->lua_release);
    assert_true(a->start.seed == b->start.seed);
    assert_memory_equal(a->start.dip, b->start.dip, sizeof a->start.dip);
    assert_int_equal(a->start.difficulty, b->start.difficulty);
    assert_memory_equal(&a->start.practice, &b->start.practice, sizeof a->start.practice);
    assert_string_equal(a->start.lang, b->start.lang);
    assert_int_equal(a->start.nvram_size, b->start.nvram_size);
    assert_memory_equal(a->nvram, b->nvram, a->start.nvram_size);
    assert_int_equal(a->flags, b->flags);
    assert_int_equal(a->n_parts, b->n_parts);
    for (int i = 0; i < a->n_parts; i++)
        assert_string_equal(a->part_name[i], b->part_name[i]);
    assert_int_equal(a->frames, b->frames);
    if (a->frames)
        assert_memory_equal(a->pads, b->pads, a->frames * sizeof a->pads[0]);
    assert_true(a->checksum_parts == b->checksum_parts);
    assert_int_equal(a->checksum_frames, b->checksum_frames);
    if (a->checksum_frames)
        assert_memory_equal(a->checksums, b->checksums,
                            a->checksum_frames * (size_t)a->n_parts * sizeof a->checksums[0]);
    assert_int_equal(a->n_markers, b->n_markers);
    for (uint32_t i = 0; i < a->n_markers; i++) {
        assert_int_equal(a->markers[i].frame, b->markers[i].frame);
        assert_int_equal(a->markers[i].marker.kind, b->markers[i].marker.kind);
        assert_string_equal(a->markers[i].marker.name, b->markers[i].marker.name);
        assert_int_equal(a->markers[i].marker.value, b->markers[i].marker.value);
    }
    assert_int_equal(a->n_rows, b->n_rows);
    if (a->n_rows)
        assert_memory_equal(a->rows, b->rows, a->n_rows * (size_t)a->n_parts * sizeof a->rows[0]);
    assert_int_equal(a->complete, b->complete);
    assert_int_equal(a->fault, b->fault);
}

static void loads(struct demo *d)
{
    if (!demo_load(d, path, err, sizeof err))
        fail_msg("%s", err);
}

/* Records n frames into the file; the writer holds them too. */
static void record(struct demo_writer *w, const struct board_start *start, uint32_t n)
{
    struct rng r;
    struct board *b = power(start);

    rng_seed(&r, n);
    assert_true(demo_begin(w, path, &cart, b, start, 0));
    play(w, b, &r, n);
    assert_true(demo_end(w, b));
}

static uint8_t file[MOST];

static size_t file_bytes(void)
{
    long n = plat_load(path, file, sizeof file);

    assert_true(n > 0 && n < MOST);
    return (size_t)n;
}

/* ---- tests ---- */

TEST(round_trip)
{
    static const uint32_t lengths[] = { 0, 1, 59, 60, 61, 119, 120, 200, 1000 };
    struct board_start start = { .seed = 0xfedcba9876543210u, .difficulty = -1 };
    struct demo_writer w = { .recording = false };
    struct demo d;

    for (size_t i = 0; i < sizeof lengths / sizeof lengths[0]; i++) {
        record(&w, &start, lengths[i]);
        loads(&d);
        same(&d, &w.demo);
        assert_true(d.complete);
        assert_int_equal(d.frames, lengths[i]);
        assert_int_equal(d.checksum_frames, lengths[i]);
        assert_int_equal(d.n_rows, 1 + (lengths[i] + 59) / 60);
        assert_int_equal(demo_row_frame(&d, d.n_rows - 1), lengths[i]);
        demo_free(&d);
        demo_free(&w.demo);
    }
}

/* The track holds what the board said at those frames, the checksums what each part said at each. */
TEST(track)
{
    struct board_start start = { .seed = 5, .difficulty = -1 };
    struct demo_writer w = { .recording = false };
    uint64_t hashes[MAX_PARTS];
    uint16_t pads[MAX_PLAYERS];
    struct demo d;

    record(&w, &start, 130);
    loads(&d);
    struct board *b = power(&d.start);
    for (uint32_t f = 0, row = 0; f <= 130; f++) {
        board_hashes(b, hashes);
        if (f == demo_row_frame(&d, row)) {
            assert_memory_equal(hashes, d.rows + row * (uint32_t)d.n_parts, sizeof hashes[0] * (size_t)d.n_parts);
            row++;
        }
        assert_int_equal(demo_differing_parts(&d, f, hashes), 0);
        for (int i = 0; i < d.n_parts; i++) {
            assert_true(f == 0 || d.checksums[(f - 1) * (uint32_t)d.n_parts + (uint32_t)i] == (uint16_t)hashes[i]);
            hashes[i] ^= 0x8000;
            assert_int_equal(demo_differing_parts(&d, f, hashes), (uint64_t)1 << i);
            hashes[i] ^= 0x10000 | 0x8000; /* beyond the checksum: only rows know */
            assert_int_equal(demo_differing_parts(&d, f, hashes), f % 60 == 0 || f == 130 ? (uint64_t)1 << i : 0);
            hashes[i] ^= 0x10000;
        }
        demo_pads(&d, f, pads);
        board_tick(b, pads);
    }
    memset(hashes, 0, sizeof hashes);
    assert_true(demo_differing_parts(&d, 131, hashes) == 0 && demo_differing_parts(&d, UINT32_MAX, hashes) == 0);
    demo_pads(&d, 130, pads);
    assert_true(pads[0] == 0 && pads[1] == 0);
    demo_free(&d);
    demo_free(&w.demo);
}

/* The first frame in which a replay that presses start for that frame only, or does not, disagrees. */
static uint32_t disagrees(const struct demo *d, uint32_t frame)
{
    struct board *b = power(&d->start);
    uint64_t hashes[MAX_PARTS];
    uint16_t pads[MAX_PLAYERS];

    for (uint32_t f = 0; f <= d->frames; f++) {
        board_hashes(b, hashes);
        if (demo_differing_parts(d, f, hashes))
            return f;
        demo_pads(d, f, pads);
        pads[0] ^= f + 1 == frame ? PAD_START : 0;
        board_tick(b, pads);
    }
    return UINT32_MAX;
}

/* What a script does differently shows in that frame, wherever in its second that is. */
TEST(divergence)
{
    static const uint32_t at[] = { 1, 2, 59, 60, 61, 75, 119, 120, 121, 180, 181, 199, 200 };
    struct board_start start = { .seed = 2, .difficulty = -1 };
    struct demo_writer w = { .recording = false };
    struct demo d;

    record(&w, &start, 200);
    loads(&d);
    assert_int_equal(disagrees(&d, 0), UINT32_MAX);
    for (size_t i = 0; i < sizeof at / sizeof at[0]; i++) {
        assert_int_equal(disagrees(&d, at[i]), at[i]);
        assert_int_equal(disagrees(&w.demo, at[i]), at[i]);
    }
    demo_free(&d);
    demo_free(&w.demo);
}

static void fill_nvram(uint8_t *p, size_t n, int kind)
{
    struct rng r;

    rng_seed(&r, (uint64_t)kind);
    for (size_t i = 0; i < n; i++)
        p[i] = kind == 0 ? 0 : kind == 1 ? (uint8_t)rng_next(&r) : kind == 2 ? (uint8_t)(i / 2) : (uint8_t)(i / 131);
}

TEST(start)
{
    static const size_t sizes[] = { 1, 2, 3, 127, 128, 129, 130, 131, 257, 32768, MAX_NVRAM };
    static uint8_t nvram[MAX_NVRAM];
    struct board_start start = { .seed = 1, .difficulty = 0, .nvram = nvram };
    struct demo_writer w = { .recording = false };
    struct demo d;

    for (int i = 0; i < MAX_DIPS; i++)
        start.dip[i] = i < cart.manifest.n_dips ? 0 : -i * 100000000;
    for (size_t i = 0; i < sizeof sizes / sizeof sizes[0]; i++) {
        for (int kind = 0; kind < 4; kind++) {
            struct board *b = power(&(struct board_start){ .seed = 1, .difficulty = -1 });
            start.nvram_size = sizes[i];
            fill_nvram(nvram, sizes[i], kind);
            assert_true(demo_begin(&w, path, &cart, b, &start, DEMO_ASSISTED));
            assert_true(demo_end(&w, b));
            loads(&d);
            same(&d, &w.demo);
            assert_memory_equal(d.start.nvram, nvram, sizes[i]);
            assert_int_equal(d.flags, DEMO_ASSISTED);
            demo_free(&d);
            demo_free(&w.demo);
        }
    }
}

/* A crash: the file holds all but the second that was going on. */
TEST(crash)
{
    struct board_start start = { .difficulty = -1 };
    struct board *b = power(&start);
    struct demo_writer w = { .recording = false };
    struct rng r;
    struct demo d;

    rng_seed(&r, 1);
    assert_true(demo_begin(&w, path, &cart, b, &start, 0));
    for (uint32_t f = 0; f < 250; f++) {
        loads(&d);
        assert_false(d.complete);
        assert_int_equal(d.frames, f / 60 * 60);
        assert_int_equal(d.n_rows, f / 60 + 1);
        if (d.frames)
            assert_memory_equal(d.pads, w.demo.pads, d.frames * sizeof d.pads[0]);
        demo_free(&d);
        play(&w, b, &r, 1);
    }
    demo_writer_free(&w);
}

TEST(cut)
{
    struct board_start start = { .difficulty = -1 };
    struct demo_writer w = { .recording = false };
    struct demo d;
    uint32_t frames = 0;

    record(&w, &start, 200);
    size_t n = file_bytes();
    for (size_t i = 0; i < n; i++) {
        uint8_t *part = malloc(i + 1); /* so that a sanitizer sees a byte too far */
        memcpy(part, file, i);
        bool ok = demo_read(&d, part, i, err, sizeof err);
        free(part);
        if (!ok) {
            assert_int_equal(frames, 0);
            continue;
        }
        assert_false(d.complete);
        assert_true(d.frames >= frames && (d.frames % 60 == 0 || d.frames == 200));
        frames = d.frames;
        demo_free(&d);
    }
    assert_int_equal(frames, 200);
    demo_free(&w.demo);
}

TEST(flips)
{
    struct board_start start = { .difficulty = -1 };
    struct demo_writer w = { .recording = false };
    struct demo d;

    record(&w, &start, 100);
    size_t n = file_bytes();
    for (size_t i = 0; i < n * 8; i++) {
        file[i / 8] ^= (uint8_t)(1 << i % 8);
        if (demo_read(&d, file, n, err, sizeof err)) {
            assert_false(d.complete); /* a length: it looks cut */
            demo_free(&d);
        }
        file[i / 8] ^= (uint8_t)(1 << i % 8);
    }
    demo_free(&w.demo);
}

/* ---- records by hand ---- */

static size_t record_at(int i)
{
    size_t at = 8;

    while (i-- > 0)
        at += 12 + bytes_get32(file + at + 4);
    return at;
}

static void refused(size_t n, const char *part)
{
    struct demo d;

    err[0] = 0;
    assert_false(demo_read(&d, file, n, err, sizeof err));
    assert_null(d.pads);
    assert_null(d.checksums);
    assert_null(d.rows);
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

TEST(order)
{
    struct board_start start = { .difficulty = -1 };
    struct demo_writer w = { .recording = false };

    record(&w, &start, 300);
    size_t n = file_bytes(), from = record_at(3), to = record_at(4);
    memmove(file + from, file + to, n - to); /* a lost second: each record alone is good */
    refused(n - (to - from), "CRC");
    n = file_bytes();
    file[n] = 0;
    refused(n + 1, "1 extra bytes after its end");
    demo_free(&w.demo);
}

TEST(nonsense)
{
    struct board_start start = { .difficulty = -1 };
    struct demo_writer w = { .recording = false };

    record(&w, &start, 100);
    size_t n = file_bytes(), head = record_at(0) + 8, first = record_at(1) + 8, second = record_at(2) + 8;
    size_t end = record_at(4 + MAX_PLAYERS) + 8; /* behind the points */
    refused(0, "not a demo");
    refused(7, "not a demo");
    refused(8, "truncated header");
    refused_with(n, 0, 'X', "not a demo");
    refused_with(n, 4, 9, "demo format 9; this build reads 2");
    refused_with(n, record_at(0), 'S', "(no header)");
    refused_with(n, record_at(1), 'X', "(kind or size)");
    refused_with(n, record_at(2), 'H', "(second header)");
    refused_with(n, head + 21, 'A', "(header)"); /* the game's id */
    refused_with(n, head + 21, 27, "(header)");
    refused_with(n, head + 20, 200, "damaged");
    refused_with(n, first + 4, 1, "(number of frames)");
    refused_with(n, first + 6, 0, "(number of frames)");
    refused_with(n, second, 1, "(frames out of order)");
    refused_with(n, second + 4, 61, "(number of frames)");
    refused_with(n, second + 4, 59, "(pads)");
    refused_with(n, second + 5, 0, "(pads)");
    refused_with(n, second + 6, 2, "(frames out of order)");
    refused_with(n, second + 6, 0, "(size)");
    refused_with(n, second + 8, 0, "(pads)");
    refused_with(n, second + 9, 0xff, "(pads)");  /* a run far longer than the second */
    refused_with(n, second + 11, 0x80, "(pads)"); /* a button that is none */
    refused_with(n, end, 99, "(end mark)");
    refused_with(n, end + 4, FAULT_LOOP + 1, "(end mark)");
    refused_with(n, end + 4, FAULT_SCRIPT, "the end mark does not match the frames");
    demo_free(&w.demo);
}

static size_t find(const char *what)
{
    size_t at = 0;

    while (memcmp(file + at, what, strlen(what)) != 0)
        at++;
    return at;
}

/* Makes the payload of record i longer by that many bytes, which stand at its end, or shorter; returns the file's
 * size. */
static size_t resize(int i, int by)
{
    size_t n = file_bytes(), at = record_at(i), size = bytes_get32(file + at + 4), end = at + 8 + size;

    memmove(file + end + by, file + end, n - end);
    bytes_put32(file + at + 4, (uint32_t)((int)size + by));
    n = (size_t)((long)n + by);
    repair_demo(file, n);
    return n;
}

/* Prints there are too many or too few of, of parts that are none, and no part script. */
TEST(checksum_lies)
{
    static const int by[] = { -2, -1, 1, 2 };
    struct board_start start = { .difficulty = -1 };
    struct demo_writer w = { .recording = false };

    record(&w, &start, 100);
    for (int i = 1; i <= 3; i++)
        for (size_t k = 0; k < sizeof by / sizeof by[0]; k++)
            refused(resize(i, by[k]), "(size)");
    size_t n = file_bytes();
    refused_with(n, find("script"), 'S', "(no script part)");
    refused_with(n, find("script") - 1, 5, "damaged");
    demo_free(&w.demo);
}

/* Where the practice start's fields stand: behind its mark. */
static size_t practice_at(void)
{
    size_t at = record_at(0) + 8 + 20;

    at += 1 + (size_t)file[at]; /* game */
    at += 1 + (size_t)file[at]; /* Lua */
    at += 8 + 4 * MAX_DIPS + 4;
    return at + 1 + file[at];
}

/* A practice start with everything in it; and what it may not say. */
TEST(practice)
{
    struct board_start start = { .seed = 9, .difficulty = -1 };
    struct practice *p = &start.practice;
    struct demo_writer w = { .recording = false };
    struct demo d;

    struct board *b = power(&start);
    snprintf(p->section, sizeof p->section, "%063d", 0);
    p->lives = 99;
    p->invincible = true;
    p->register_count = PRACTICE_MAX_REGISTERS;
    for (int i = 0; i < PRACTICE_MAX_REGISTERS; i++) {
        snprintf(p->reg[i].name, sizeof p->reg[i].name, "%0*d", 1 + 2 * i, i);
        p->reg[i].value = i % 2 ? INT32_MIN + i : INT32_MAX - i;
    }
    assert_true(demo_begin(&w, path, &cart, b, &start, 0) && demo_end(&w, b));
    loads(&d);
    same(&d, &w.demo);
    assert_memory_equal(&d.start.practice, p, sizeof *p);
    size_t n = file_bytes(), at = practice_at();
    assert_int_equal(file[at], 99);
    assert_int_equal(file[at + 5], PRACTICE_MAX_REGISTERS);
    refused_with(n, at, 100, "(header)");
    refused_with(n, at + 3, 0x80, "(header)");
    refused_with(n, at + 4, 2, "(header)");
    refused_with(n, at + 5, PRACTICE_MAX_REGISTERS + 1, "damaged");
    refused_with(n, at + 5, PRACTICE_MAX_REGISTERS - 1, "damaged");
    refused_with(n, at + 7, 31, "(header)"); /* a register's name */
    refused_with(n, at + 6, 32, "damaged");
    demo_free(&d);
    demo_free(&w.demo);
}

/* The kinds in turn, at every 7th frame; every 21st has two, with names of all lengths. */
static void mark_frames(struct demo_writer *w, struct board *b, uint32_t n)
{
    static const uint16_t none[MAX_PLAYERS];
    static const char name[] = "0123456789abcdefghijklmnopqrstuvwxyz";

    for (uint32_t i = 0; i < n; i++) {
        board_tick(b, none);
        uint32_t f = board_frame(b);
        if (f % 7 == 0)
            board_add_marker(b, (enum board_marker_kind)(f / 7 % MARKER_KINDS), name + f / 7 % sizeof name, "", "",
                             f % 14 == 0 ? (int32_t)(f * 0x1234567u) : 0);
        if (f % 21 == 0)
            board_add_marker(b, MARKER_DEATH, "2", "", "", 0);
        assert_true(demo_record_frame(w, b, none));
    }
}

TEST(markers)
{
    struct board_start start = { .difficulty = -1 };
    struct demo_writer w = { .recording = false };
    struct board *b = power(&start);
    struct demo d;

    assert_true(demo_begin(&w, path, &cart, b, &start, 0));
    mark_frames(&w, b, 300);
    assert_int_equal(w.demo.n_markers, 300 / 7 + 300 / 21);
    loads(&d); /* not ended yet */
    assert_int_equal(d.n_markers, w.demo.n_markers);
    demo_free(&d);
    mark_frames(&w, b, 43); /* the last frame has one */
    assert_true(demo_end(&w, b));
    loads(&d);
    same(&d, &w.demo);
    assert_int_equal(d.n_markers, 343 / 7 + 343 / 21 + MAX_PLAYERS); /* and the points */
    assert_int_equal(d.markers[0].frame, 7);
    assert_int_equal(d.markers[3].frame, 21);
    assert_int_equal(strlen(d.markers[0].marker.name), sizeof d.markers[0].marker.name - 1); /* cut to fit */
    demo_free(&d);
    demo_free(&w.demo);
    static const uint32_t back[] = { 0, 60, 63, 120, 126, 169 };
    for (size_t i = 0; i < sizeof back / sizeof back[0]; i++) { /* going back forgets those that came after */
        uint32_t to = back[i];
        b = power(&start);
        assert_true(demo_begin(&w, path, &cart, b, &start, 0));
        mark_frames(&w, b, 170);
        b = power(&start);
        for (uint32_t f = 0; f < to; f++)
            board_tick(b, w.demo.pads[f]);
        assert_true(demo_rewind(&w, to));
        assert_int_equal(w.demo.n_markers, to / 7 + to / 21);
        mark_frames(&w, b, 100);
        assert_true(demo_end(&w, b));
        loads(&d);
        same(&d, &w.demo);
        assert_int_equal(d.n_markers, (to + 100) / 7 + (to + 100) / 21 + MAX_PLAYERS);
        demo_free(&d);
        demo_free(&w.demo);
    }
}

/* A recording ends with what everybody had. */
TEST(points)
{
    static const int64_t points[][MAX_PLAYERS] = { { 0, 0 }, { 120300, 0 }, { 7, 999999999999 } };
    static const uint32_t frames[] = { 0, 60, 61 };
    struct board_start start = { .difficulty = -1 };
    struct demo_writer w = { .recording = false };
    struct demo d;
    struct rng r;
    int64_t got;

    for (size_t i = 0; i < sizeof points / sizeof points[0]; i++) {
        struct board *b = power(&start);
        memcpy(b->player.score, points[i], sizeof points[i]);
        rng_seed(&r, 1);
        assert_true(demo_begin(&w, path, &cart, b, &start, 0));
        play(&w, b, &r, frames[i]);
        loads(&d);
        assert_false(demo_points(&d, 0, &got)); /* not ended yet */
        demo_free(&d);
        assert_true(demo_end(&w, b));
        loads(&d);
        same(&d, &w.demo);
        for (int p = 0; p < MAX_PLAYERS; p++)
            assert_true(demo_points(&d, p, &got) && got == points[i][p]);
        demo_free(&d);
        demo_free(&w.demo);
    }
}

TEST(points_lies)
{
    static const char *const texts[] = { "",
                                         "points",
                                         "points 1",
                                         "points 1 ",
                                         "points 1 x",
                                         "points 1 -5",
                                         "points 1 05",
                                         "points 2 5",
                                         "points 1 5 ",
                                         "points 1 1234567890123",
                                         "Points 1 5" };
    struct demo_marker list[3] = { 0 };
    struct demo d = { .markers = list, .n_markers = 2, .frames = 9, .complete = true };
    int64_t got;

    list[0] = (struct demo_marker){ 8, { .kind = MARKER_LISTED, .name = "points 1 5" } };
    for (size_t i = 0; i < sizeof texts / sizeof texts[0]; i++) {
        list[1] = (struct demo_marker){ 9, { .kind = MARKER_LISTED } };
        snprintf(list[1].marker.name, sizeof list[1].marker.name, "%s", texts[i]);
        if (demo_points(&d, 0, &got))
            fail_msg("\"%s\" is taken for points", texts[i]);
    }
    list[1] = list[0];
    assert_false(demo_points(&d, 0, &got)); /* not of the last frame */
    list[1].frame = 9;
    list[1].marker.kind = MARKER_REGISTER;
    assert_false(demo_points(&d, 0, &got));
    list[1].marker.kind = MARKER_LISTED;
    assert_true(demo_points(&d, 0, &got) && got == 5);
    list[2] = (struct demo_marker){ 9, { .kind = MARKER_WAVE, .name = "wisp" } };
    d.n_markers = 3;
    assert_true(demo_points(&d, 0, &got) && got == 5);
    d.complete = false;
    assert_false(demo_points(&d, 0, &got));
}

TEST(marker_lies)
{
    struct board_start start = { .difficulty = -1 };
    struct demo_writer w = { .recording = false };
    struct board *b = power(&start);
    int at = 0;

    assert_true(demo_begin(&w, path, &cart, b, &start, 0));
    mark_frames(&w, b, 100);
    assert_true(demo_end(&w, b));
    size_t n = file_bytes();
    while (file[record_at(at)] != 'M')
        at++;
    assert_int_equal(file[record_at(at + 1)], 'M');
    size_t first = record_at(at) + 8, second = record_at(at + 1) + 8;
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
    demo_free(&w.demo);
}

/* Values of moments: any but 0, which is not written. */
TEST(values)
{
    static const int32_t values[] = { 1, 10, -1, INT32_MIN, INT32_MAX };
    struct board_start start = { .difficulty = -1 };
    struct demo_writer w = { .recording = false };
    struct board *b = power(&start);
    struct demo d;

    assert_true(demo_begin(&w, path, &cart, b, &start, 0));
    static const uint16_t none[MAX_PLAYERS];
    for (int i = 0; i < 5; i++) {
        board_tick(b, none);
        board_add_marker(b, MARKER_ROW, "normal", "", "", values[i]);
        board_add_marker(b, MARKER_GAME, "heron", "", "", 0);
        assert_true(demo_record_frame(&w, b, none));
    }
    assert_true(demo_end(&w, b));
    loads(&d);
    same(&d, &w.demo);
    for (uint32_t i = 0; i < 10; i++) {
        assert_int_equal(d.markers[i].marker.kind, i % 2 ? MARKER_GAME : MARKER_ROW);
        assert_int_equal(d.markers[i].marker.value, i % 2 ? 0 : values[i / 2]);
    }
    size_t n = file_bytes(), value = record_at(3) + 8 + 4 + 1 + 1 + strlen("normal");
    assert_int_equal(bytes_get32(file + value), 1);
    refused_with(n, value, 0, "(marker)");
    refused(resize(3, -1), "damaged");
    refused(resize(4, 1), "damaged");
    demo_free(&d);
    demo_free(&w.demo);
}

/* The language of a start, of any length there is room for. */
TEST(lang)
{
    static const char *const langs[] = { "", "d", "deutsch", "123456789_abcde" };
    struct board_start start = { .difficulty = -1 };
    struct demo_writer w = { .recording = false };
    struct demo d;

    for (size_t i = 0; i < sizeof langs / sizeof *langs; i++) {
        snprintf(start.lang, sizeof start.lang, "%s", langs[i]);
        record(&w, &start, 10);
        loads(&d);
        same(&d, &w.demo);
        assert_string_equal(d.start.lang, langs[i]);
        demo_free(&d);
        demo_free(&w.demo);
    }
    size_t n = file_bytes(), at = find(langs[3]);
    refused_with(n, at, 31, "(header)");
    refused_with(n, at + 14, 127, "(header)");
    refused_with(n, at - 1, 16, "damaged");
    static const char bad[] = { '\n', 127, (char)0xe9 };
    for (size_t i = 0; i < sizeof bad; i++) {
        start.lang[1] = bad[i];
        assert_null(board_power_on(ram, ram_size, &rom, &start, err, sizeof err));
        assert_non_null(strstr(err, "language: expected printable ASCII"));
    }
}

/* As many parts as there may be, and sets of them of 1 to 8 bytes. */
TEST(many_parts)
{
    static const int counts[] = { 1, 7, 8, 9, 31, 32, 33, 56, 57, 63, 64 };
    static uint64_t track[2 * 64];
    static uint16_t checksums[59 * 64];
    static struct demo d, again;
    uint16_t pads[59][MAX_PLAYERS] = { { 0 } };
    struct rng r;

    rng_seed(&r, 64);
    for (size_t k = 0; k < sizeof counts / sizeof *counts; k++) {
        int parts = counts[k];
        d = (struct demo){
            .core_version = 9, .id = "many", .lua_release = "5.4", .n_parts = parts, .complete = true, .frames = 59
        };
        d.start.difficulty = -1;
        d.checksum_parts = UINT64_MAX;
        d.checksum_frames = 59;
        d.n_rows = 2;
        d.pads = pads;
        d.rows = track;
        d.checksums = checksums;
        for (int i = 0; i < parts; i++)
            snprintf(d.part_name[i], sizeof d.part_name[i], i ? "part%d" : "script", i);
        for (int i = 0; i < 2 * parts; i++)
            track[i] = rng_next(&r);
        for (int i = 0; i < 58 * parts; i++) /* some as in the frame before */
            checksums[i] = i < parts || rng_below(&r, 2) ? (uint16_t)rng_next(&r) : checksums[i - parts];
        for (int i = 0; i < parts; i++)
            checksums[58 * parts + i] = (uint16_t)track[parts + i];
        assert_true(demo_save(&d, path, err, sizeof err));
        loads(&again);
        same(&again, &d);
        uint64_t hashes[MAX_PARTS];
        memcpy(hashes, track + parts, sizeof hashes[0] * (size_t)parts);
        hashes[parts - 1] ^= 1;
        assert_true(demo_differing_parts(&again, 59, hashes) == (uint64_t)1 << (parts - 1));
        demo_free(&again);
        size_t n = file_bytes(), mask = record_at(2) + 8 + 8 + 6, bytes = (size_t)(parts + 7) / 8;
        if (parts % 8)
            refused_with(n, mask + bytes - 1, file[mask + bytes - 1] | 0x80, "damaged");
        refused_with(n, find("script") - 1 - 1, 65, "(the number of parts)");
    }
}

/* A demo of format 3 says the same in the newest, in no more bytes. */
TEST(format_3)
{
    struct demo was, is;

    if (!demo_load(&was, "tests/demos/frozen-3.demo", err, sizeof err))
        fail_msg("%s", err);
    assert_int_equal(was.format, 3);
    assert_true(was.complete && was.frames == 905 && was.n_rows == 17 && was.checksum_parts == UINT64_MAX);
    assert_true(demo_save(&was, path, err, sizeof err));
    loads(&is);
    assert_int_equal(is.format, DEMO_FORMAT);
    same(&is, &was);
    long old = plat_file_size("tests/demos/frozen-3.demo");
    size_t now = file_bytes();
    print_message("# format 3: %ld bytes, format %d: %zu\n", old, (int)DEMO_FORMAT, now);
    assert_int_equal(now, (size_t)old + 2 -
                              (905 - 16)); /* no language, dense; a byte less in each frame that is in no row */
    demo_free(&was);
    demo_free(&is);
}

/* A demo of format 2, written by the program of its time. */
TEST(old_format)
{
    uint64_t hashes[MAX_PARTS];
    struct demo d;

    if (!demo_load(&d, "tests/demos/frozen-2.demo", err, sizeof err))
        fail_msg("%s", err);
    assert_int_equal(d.format, 2);
    assert_true(d.complete && d.frames == 905 && d.checksum_frames == 905 && d.n_rows == 17 && d.n_markers == 0);
    assert_int_equal(d.checksum_parts, 1u << 0); /* script, the first */
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
    demo_free(&d);
}

/* demo_save writes what was read, byte for byte: whole, cut short, and with a fault. */
TEST(save)
{
    static const uint16_t select[MAX_PLAYERS] = { PAD_SELECT, 0 };
    static uint8_t was[MOST];
    struct board_start start = { .seed = 4, .difficulty = -1 };
    struct demo_writer w = { .recording = false };
    struct demo d;
    struct rng r;

    for (int kind = 0; kind < 4; kind++) {
        struct board *b = power(&start);
        rng_seed(&r, (uint64_t)kind);
        assert_true(demo_begin(&w, path, &cart, b, &start, DEMO_ASSISTED));
        play(&w, b, &r, kind < 2 ? 100 : 119 + (uint32_t)kind);
        mark_frames(&w, b, 30);
        if (kind == 1 || kind == 3) {
            board_tick(b, select);
            assert_true(demo_record_frame(&w, b, select));
        }
        assert_true(kind == 2 || demo_end(&w, b));
        size_t n = file_bytes();
        memcpy(was, file, n);
        loads(&d);
        if (!demo_save(&d, path, err, sizeof err))
            fail_msg("%s", err);
        assert_int_equal(file_bytes(), n);
        assert_memory_equal(file, was, n);
        demo_free(&d);
        demo_writer_free(&w);
    }
}

/* An nvram that would unpack to more than there is room for, or to less than it says. */
TEST(nvram_lies)
{
    static uint8_t nvram[1000];
    struct board_start start = { .difficulty = -1, .nvram = nvram, .nvram_size = sizeof nvram };
    struct board *b = power(&(struct board_start){ .difficulty = -1 });
    struct demo_writer w = { .recording = false };

    assert_true(demo_begin(&w, path, &cart, b, &start, 0));
    assert_true(demo_end(&w, b));
    size_t n = file_bytes(), coded = record_at(1) - 4 - 16, size = coded - 4; /* 8 runs, 2 bytes each */
    assert_int_equal(bytes_get32(file + size), 1000);
    refused_with(n, size, 0xe7, "(nvram)");
    refused_with(n, size, 0xe9, "(nvram)");
    refused_with(n, size + 2, 1, "(nvram)");
    refused_with(n, coded, 200, "(nvram)");
    refused_with(n, coded + 14, 127, "(nvram)");
    demo_free(&w.demo);
}

/* ---- going back, ends ---- */

TEST(rewind)
{
    static const uint32_t to[] = { 0, 1, 59, 60, 61, 120, 149, 150 };
    struct board_start start = { .seed = 3, .difficulty = -1 };
    struct demo_writer w = { .recording = false };
    struct demo d;

    for (size_t i = 0; i < sizeof to / sizeof to[0]; i++) {
        struct board *b = power(&start);
        struct rng r;
        rng_seed(&r, i);
        assert_true(demo_begin(&w, path, &cart, b, &start, 0));
        play(&w, b, &r, 150);
        b = power(&start); /* go back: the same frames again */
        for (uint32_t f = 0; f < to[i]; f++)
            board_tick(b, w.demo.pads[f]);
        assert_true(demo_rewind(&w, to[i]));
        assert_int_equal(w.demo.checksum_frames, to[i]);
        play(&w, b, &r, 75);
        assert_true(demo_end(&w, b));
        loads(&d);
        same(&d, &w.demo);
        assert_int_equal(d.frames, to[i] + 75);
        assert_int_equal(d.n_rows, 1 + (d.frames + 59) / 60);
        assert_int_equal(d.flags, DEMO_BRANCHED);
        demo_free(&d);
        demo_free(&w.demo);
    }
}

/* ---- sparse ones ---- */

/* Records n frames with checksums of seconds alone. */
static struct board *record_sparse(struct demo_writer *w, uint32_t n)
{
    struct board_start start = { .seed = 9, .difficulty = -1 };
    struct board *b = power(&start);
    struct rng r;

    rng_seed(&r, n);
    assert_true(demo_begin(w, path, &cart, b, &start, 0));
    assert_true(demo_set_checksum_rate(w, DEMO_CHECKSUMS_EVERY_SECOND));
    play(w, b, &r, n);
    assert_true(demo_end(w, b));
    return b;
}

/* It is read as it was written, and written as it was read; its last row is whole wherever it ends, and one a minute
 * is. */
TEST(sparse)
{
    static const uint32_t lengths[] = { 0, 1, 59, 60, 61, 120, 3599, 3600, 3601, 3660, 3700 };
    struct demo_writer w = { .recording = false };
    struct demo d, again;

    for (size_t i = 0; i < sizeof lengths / sizeof lengths[0]; i++) {
        record_sparse(&w, lengths[i]);
        loads(&d);
        assert_true(d.complete && d.sparse && !d.checksums && d.frames == lengths[i]);
        assert_int_equal(d.n_rows, w.demo.n_rows);
        assert_memory_equal(d.pads, w.demo.pads, d.frames * sizeof d.pads[0]);
        for (uint32_t row = 0; row < d.n_rows; row++) {
            const bool whole = row % 60 == 0 || row + 1 == d.n_rows;
            assert_int_equal(demo_row_is_full(&d, row), whole);
            for (uint32_t k = row * (uint32_t)d.n_parts; k < (row + 1) * (uint32_t)d.n_parts; k++)
                assert_true(d.rows[k] == (whole ? w.demo.rows[k] : (uint16_t)w.demo.rows[k]));
        }
        const size_t bytes = file_bytes();
        assert_true(demo_save(&d, path, err, sizeof err));
        assert_int_equal(file_bytes(), bytes);
        loads(&again);
        assert_memory_equal(again.rows, d.rows, d.n_rows * (size_t)d.n_parts * sizeof d.rows[0]);
        demo_free(&again);
        demo_free(&d);
        demo_free(&w.demo);
    }
}

/* A difference is found in the second that it is in, by part, as far as 16 bits tell; a whole row knows all. */
TEST(sparse_differs)
{
    struct demo_writer w = { .recording = false };
    uint64_t hashes[MAX_PARTS];
    uint16_t pads[MAX_PLAYERS], print;
    struct demo d;

    record_sparse(&w, 130);
    loads(&d);
    struct board *b = power(&d.start);
    for (uint32_t f = 0; f <= 130; f++) {
        const bool told = f % 60 == 0 || f == 130, whole = f == 0 || f == 130;
        board_hashes(b, hashes);
        assert_int_equal(demo_has_checksums(&d, f), told);
        assert_int_equal(demo_hashes(&d, f) != NULL, whole);
        assert_null(demo_checksums(&d, f));
        assert_int_equal(demo_differing_parts(&d, f, hashes), 0);
        for (int i = 0; i < d.n_parts; i++) {
            assert_int_equal(demo_get_checksum(&d, f, i, &print), told);
            hashes[i] ^= 0x8000;
            assert_int_equal(demo_differing_parts(&d, f, hashes), told ? (uint64_t)1 << i : 0);
            hashes[i] ^= 0x10000 | 0x8000;
            assert_int_equal(demo_differing_parts(&d, f, hashes), whole ? (uint64_t)1 << i : 0);
            hashes[i] ^= 0x10000;
        }
        demo_pads(&d, f, pads);
        board_tick(b, pads);
    }
    demo_free(&d);
    demo_free(&w.demo);
}

/* What nobody chose for is dense while it is short; a second beyond that the file is written anew. Gone back in, it
 * stays as it is. */
TEST(grows_long)
{
    struct board_start start = { .seed = 3, .difficulty = -1 };
    struct demo_writer w = { .recording = false };
    struct board *b = power(&start);
    struct rng r;
    struct demo d;

    rng_seed(&r, 1);
    assert_true(demo_begin(&w, path, &cart, b, &start, 0));
    play(&w, b, &r, DEMO_DENSE_FRAMES);
    loads(&d);
    assert_true(!d.sparse && d.frames == DEMO_DENSE_FRAMES);
    demo_free(&d);
    const size_t dense = file_bytes();
    play(&w, b, &r, 59);
    assert_false(w.demo.sparse);
    play(&w, b, &r, 1);
    assert_true(w.demo.sparse && file_bytes() < dense / 2);
    loads(&d);
    assert_true(d.sparse && d.frames == DEMO_DENSE_FRAMES + 60 && !d.complete);
    demo_free(&d);
    b = power(&start);
    for (uint32_t f = 0; f < 90; f++)
        board_tick(b, w.demo.pads[f]);
    assert_true(demo_rewind(&w, 90));
    play(&w, b, &r, 50);
    assert_true(demo_end(&w, b));
    loads(&d);
    assert_true(d.sparse && d.complete && d.frames == 140 && d.n_rows == 4);
    assert_true(demo_row_is_full(&d, 3) && !demo_row_is_full(&d, 2));
    demo_free(&d);
    demo_free(&w.demo);
}

/* Any byte that is another is refused, or the demo still hangs together; checksums of records are made good. */
TEST(sparse_lies)
{
    static uint8_t good[1 << 16], bad[1 << 16];
    struct demo_writer w = { .recording = false };
    struct demo d;
    FILE *f;

    record_sparse(&w, 120);
    f = fopen(path, "rb");
    assert_non_null(f);
    const size_t n = fread(good, 1, sizeof good, f);
    fclose(f);
    int refused = 0;
    for (size_t i = 8; i < n; i++) {
        memcpy(bad, good, n);
        bad[i] ^= 0x41;
        repair_demo(bad, n);
        if (!demo_read(&d, bad, n, err, sizeof err)) {
            refused++;
            continue;
        }
        assert_true(d.frames <= 120 && d.n_rows <= 3);
        demo_free(&d);
    }
    assert_in_range(refused, 100, n - 100);
    demo_free(&w.demo);
}

TEST(flags)
{
    struct board_start start = { .difficulty = -1 };
    struct board *b = power(&start);
    struct demo_writer w = { .recording = false };
    struct rng r;
    struct demo d;

    rng_seed(&r, 1);
    assert_true(demo_begin(&w, path, &cart, b, &start, 0));
    play(&w, b, &r, 70);
    assert_true(demo_add_flags(&w, DEMO_ASSISTED));
    loads(&d);
    assert_int_equal(d.flags, DEMO_ASSISTED); /* at once, not at the end */
    demo_free(&d);
    assert_true(demo_add_flags(&w, DEMO_TOUCHED));
    play(&w, b, &r, 70);
    assert_true(demo_end(&w, b));
    loads(&d);
    assert_int_equal(d.flags, DEMO_ASSISTED | DEMO_TOUCHED);
    same(&d, &w.demo);
    demo_free(&d);
    demo_free(&w.demo);
}

/* A run that ends in a fault holds the tick that faulted, and no hash after it. */
TEST(fault)
{
    static const uint32_t at[] = { 0, 30, 59, 60, 119 };
    static const uint16_t select[MAX_PLAYERS] = { PAD_SELECT, 0 };
    struct board_start start = { .difficulty = -1 };
    struct demo_writer w = { .recording = false };
    struct demo d;

    for (size_t i = 0; i < sizeof at / sizeof at[0]; i++) {
        struct board *b = power(&start);
        struct rng r;
        rng_seed(&r, i);
        assert_true(demo_begin(&w, path, &cart, b, &start, 0));
        play(&w, b, &r, at[i]);
        uint64_t hashes[MAX_PARTS], none[MAX_PARTS] = { 0 };
        board_hashes(b, hashes);
        board_tick(b, select);
        assert_non_null(board_last_output(b)->fault);
        assert_true(demo_record_frame(&w, b, select));
        assert_true(demo_end(&w, b));
        loads(&d);
        same(&d, &w.demo);
        assert_true(d.complete);
        assert_int_equal(d.fault, FAULT_SCRIPT);
        assert_int_equal(d.frames, at[i] + 1);
        assert_int_equal(d.checksum_frames, at[i]);
        assert_int_equal(d.n_rows, 1 + at[i] / 60);
        assert_int_equal(demo_differing_parts(&d, at[i], hashes), 0);
        assert_int_not_equal(demo_differing_parts(&d, at[i], none), 0); /* the last good frame has its checksums */
        assert_int_equal(demo_differing_parts(&d, at[i] + 1, none), 0);
        assert_int_equal(d.pads[at[i]][0], PAD_SELECT);
        demo_free(&d);
        demo_free(&w.demo);
    }
}

/* Only the last second has no hashes. */
TEST(after_fault)
{
    static const uint16_t select[MAX_PLAYERS] = { PAD_SELECT, 0 };
    struct board_start start = { .difficulty = -1 };
    struct board *b = power(&start);
    struct demo_writer w = { .recording = false };
    struct rng r;

    rng_seed(&r, 1);
    assert_true(demo_begin(&w, path, &cart, b, &start, 0));
    play(&w, b, &r, 59);
    board_tick(b, select);
    assert_true(demo_record_frame(&w, b, select) && demo_end(&w, b));
    size_t n = file_bytes(), end = record_at(3 + MAX_PLAYERS);
    assert_int_equal(file[end], 'E');
    assert_int_equal(n, end + 20);
    end = record_at(3);                                           /* in place of the points */
    memmove(file + end, file + record_at(2), end - record_at(2)); /* the second once more, as the next one */
    n = end + (end - record_at(2));
    file[end + 8] = 60;
    repair_demo(file, n);
    refused(n, "frames out of order");
    demo_free(&w.demo);
}

static void misfits(struct demo *d, const char *part)
{
    assert_false(demo_check_cart(d, &cart, err, sizeof err));
    if (strstr(err, part) == NULL)
        fail_msg("\"%s\" does not say \"%s\"", err, part);
}

/* A start from another build, or made up, never reaches a board that does not know it. */
TEST(foreign_start)
{
    static const struct {
        int dip;
        int32_t good, bad;
    } rows[] = { { 0, 1, 2 }, { 0, 0, -1 }, { 0, 1, INT32_MAX }, { 1, 9, 10 }, { 1, 0, INT32_MIN } };
    struct board_start start = { .difficulty = -1 };
    struct demo_writer w = { .recording = false };
    struct demo d;

    record(&w, &start, 1);
    loads(&d);
    for (size_t i = 0; i < sizeof rows / sizeof rows[0]; i++) {
        d.start.dip[rows[i].dip] = rows[i].bad;
        misfits(&d, "DIP switch");
        d.start.dip[rows[i].dip] = rows[i].good;
        assert_true(demo_check_cart(&d, &cart, err, sizeof err));
    }
    d.start.difficulty = 1;
    misfits(&d, "difficulty");
    demo_free(&d);
    demo_free(&w.demo);
}

/* Where nothing can be written the recording continues in memory, and says so at once and at its end. */
TEST(no_file)
{
    struct board_start start = { .difficulty = -1 };
    struct board *b = power(&start);
    struct demo_writer w = { .recording = false };
    struct rng r;

    rng_seed(&r, 1);
    assert_false(demo_begin(&w, dir, &cart, b, &start, 0)); /* a folder has that name */
    assert_non_null(strstr(w.err, "cannot be written"));
    assert_non_null(strstr(w.err, dir));
    play(&w, b, &r, 130);
    assert_int_equal(w.demo.frames, 130);
    w.err[0] = '\0';
    assert_false(demo_end(&w, b));
    assert_non_null(strstr(w.err, "cannot be written"));
    demo_free(&w.demo);
}

TEST(idle_writer)
{
    struct board_start start = { .difficulty = -1 };
    struct board *b = power(&start);
    struct demo_writer w = { .recording = false };
    uint16_t pads[MAX_PLAYERS] = { 0 };

    assert_true(demo_record_frame(&w, b, pads) && demo_add_flags(&w, 1) && demo_rewind(&w, 0) && demo_end(&w, b));
    assert_int_equal(w.demo.frames, 0);
    assert_true(demo_begin(&w, NULL, &cart, b, &start, 0));
    assert_true(demo_end(&w, b) && demo_end(&w, b));
    demo_free(&w.demo);
}

TEST(fits)
{
    struct board_start start = { .difficulty = -1 };
    struct demo_writer w = { .recording = false };
    struct demo d;
    char buf[128];

    record(&w, &start, 1);
    loads(&d);
    assert_true(demo_check_cart(&d, &cart, err, sizeof err));
    assert_null(demo_replay_warning(&d, &cart, buf, sizeof buf));
    d.game_hash++;
    assert_string_equal(demo_replay_warning(&d, &cart, buf, sizeof buf), "recorded with another game version");
    d.core_version += 6;
    assert_non_null(strstr(demo_replay_warning(&d, &cart, buf, sizeof buf), "recorded with core version"));
    d.id[0] = 'z';
    assert_false(demo_check_cart(&d, &cart, err, sizeof err));
    assert_non_null(strstr(err, "another game"));
    demo_free(&d);
    assert_false(demo_load(&d, dir, err, sizeof err));
    assert_non_null(strstr(err, dir));
    demo_free(&w.demo);
}

RUN_TESTS(setup, teardown)
