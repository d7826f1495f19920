/* test_share.c - the mark of an exported program, and what of a program's file is loaded. */
#include "../test.h"
#include "../../platform/platform.h"
#include "../../src/board/board.h"
#include "../../src/workbench/export/image.h"
#include "../../src/player/game/mark.h"

/* This very program, as it is on the disk. */
static uint8_t *itself(size_t *size)
{
    char name[256];

    assert_true(plat_program_file(name, sizeof name));
    *size = (size_t)plat_file_size(name);
    uint8_t *file = malloc(2 * *size);
    assert_non_null(file);
    assert_int_equal(plat_load(name, file, *size), *size);
    return file;
}

TEST(one_mark_is_found)
{
    size_t size, at, again;
    uint8_t *file = itself(&size);
    const struct mark put = { MARK_KEYS, 0x12345678, 1ull << 33, 99, 0 };
    struct mark got = mark_own();

    assert_true(got.size == 0 && got.at == 0 && got.flags == 0 && got.core == CORE_VERSION);
    assert_true(mark_find(file, size, &at));
    assert_true(mark_find(file, at + MARK_BYTES, &again) && again == at);
    assert_false(mark_find(file, at + MARK_BYTES - 1, &again));
    assert_false(mark_find(file, 0, &again));
    mark_put(file + at, &put);
    mark_read(file + at, &got);
    assert_true(got.flags == put.flags && got.crc == put.crc && got.at == put.at && got.size == put.size);
    assert_int_equal(got.core, CORE_VERSION);
    assert_true(mark_find(file, size, &again) && again == at); /* one that was written over is one still */
    file[at + 32]++;                                           /* of another version */
    assert_false(mark_find(file, size, &again));
    file[at + 32]--;
    memcpy(file + size, file + at, MARK_BYTES); /* two of them */
    assert_false(mark_find(file, size + MARK_BYTES, &again));
    free(file);
}

/* What is behind the last piece goes; what is no whole program stays. */
TEST(what_is_loaded)
{
    uint8_t text[512] = "\177ELF and no more";
    size_t size, end, at;
    uint8_t *file = itself(&size);

    assert_int_equal(image_trim(text, sizeof text), sizeof text);
    assert_int_equal(image_trim(text, 3), 3);
    uint8_t *copy = malloc(size);
    assert_non_null(copy);
    memcpy(copy, file, size);
    assert_int_equal(image_trim(copy, 300), 300); /* its pieces are not all there */
    memcpy(copy, file, size);
    end = image_trim(copy, size);
    assert_true(end < size && end > size / 20);
    assert_true(mark_find(copy, end, &at));
    memcpy(copy, file, size);
    assert_int_equal(image_trim(copy, end), end);
    memcpy(copy, file, size);
    assert_int_equal(image_trim(copy, end - 1), end - 1);
    free(copy);
    free(file);
}

/* A file for a 32-bit, big-endian machine: its header, two segments, and the table of sections behind them. */
TEST(what_is_loaded_elsewhere)
{
    uint8_t file[512] = {
        0x7f, 'E', 'L', 'F', 1, 2, 1, [31] = 52, [34] = 1, [35] = 0x80, [43] = 32, [45] = 2, [49] = 3
    };

    file[52 + 7] = 52, file[52 + 19] = 64;  /* the headers */
    file[84 + 6] = 1, file[84 + 19] = 0x11; /* 17 bytes from 256 on */
    assert_int_equal(image_trim(file, sizeof file), 273);
    assert_true(file[34] == 0 && file[35] == 0 && file[49] == 0);
    assert_int_equal(image_trim(file, 272), 272); /* the second one is cut short */
    file[45] = 20;                                /* the table of segments is */
    assert_int_equal(image_trim(file, sizeof file), sizeof file);
    file[45] = 2, file[43] = 56;
    assert_int_equal(image_trim(file, sizeof file), sizeof file);
    file[43] = 32, file[4] = 3;
    assert_int_equal(image_trim(file, sizeof file), sizeof file);
}

RUN_TESTS(NULL, NULL)
