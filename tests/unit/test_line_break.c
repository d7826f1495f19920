/*
 * test_line_break.c - Japanese lines end between phrases (fb/line_break.h). tests/scripts/wrap.lua breaks the same
 * sentences.
 */
#include "../test.h"
#include "../../fb/line_break.h"

static int one(const void *font, uint32_t code)
{
    (void)font, (void)code;
    return 1;
}

/* Writes the lines of a text with | between them. */
static const char *lines_of(const char *text, int width)
{
    static char out[400];
    size_t n = strlen(text), fitting, length = 0;

    for (; n > 0; text += fitting, n -= fitting) {
        const size_t at = line_break_find(text, n, width, one, NULL, &fitting);
        fitting = at ? at : fitting;
        if (length)
            out[length++] = '|';
        memcpy(out + length, text, fitting);
        length += fitting;
    }
    out[length] = '\0';
    return out;
}

TEST(phrases)
{
    static const struct {
        int width;
        const char *text, *lines;
    } rows[] = {
        { 12, "背景を暗くして弾を見やすくします。", "背景を暗くして弾を|見やすくします。" },
        { 20, "低速でゆっくり飛びます。当たるのは真ん中だけです。",
          "低速でゆっくり飛びます。当たるのは真ん|中だけです。" },
        { 18, "プリズムを取ると倍率が上がります。", "プリズムを取ると倍率が上がります。" },
        { 20, "この機体の名前は長すぎて、ここでは練習できません。",
          "この機体の名前は長すぎて、ここでは|練習できません。" },
        { 16, "ガラスが満タンです。お金を落とします。", "ガラスが満タンです。お金を|落とします。" },
        { 10, "速さを半分にします。", "速さを半分にします。" },
        { 12, "「低速」で「輪」を破る。", "「低速」で「輪」を破る。" },
        { 8, "弾幕弾幕弾幕弾幕弾", "弾幕弾幕弾幕|弾幕弾" },
    };

    for (size_t i = 0; i < sizeof rows / sizeof *rows; i++)
        assert_string_equal(lines_of(rows[i].text, rows[i].width), rows[i].lines);
}

/* A line that has no place to end takes what fits, at least a character. */
TEST(no_place)
{
    size_t fitting;

    assert_int_equal(line_break_find("Escape", 6, 4, one, NULL, &fitting), 0);
    assert_int_equal(fitting, 4);
    assert_int_equal(line_break_find("a", 1, 0, one, NULL, &fitting), 0);
    assert_int_equal(fitting, 1);
}

RUN_TESTS(NULL, NULL)
