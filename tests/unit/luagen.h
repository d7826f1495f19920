/*
 * luagen.h - random arguments for calls of Lua's library, written as Lua source: ordinary, extreme and wrong ones.
 *
 * A kind of argument is a letter; luagen_args writes a list of them:
 *   s text        S short text, for patterns    p pattern    r replacement of gsub    N text of a number
 *   u UTF-8, also bad    i position    n number    c count    C byte    U code    B base    l flag    t table
 *   m metatable    o function    O comparator
 *   k chunk    K its name    M its mode    f format with its arguments    a anything    * more of the same or none
 *   T odd table    w word
 */
#ifndef TESTS_LUAGEN_H
#define TESTS_LUAGEN_H

#include <stdarg.h>
#include <stdbool.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "../../src/base/rng.h"

/* A text that grows. */
struct out {
    char *s;
    size_t n, room;
};

static void say_bytes(struct out *o, const char *s, size_t n)
{
    if (o->n + n + 1 > o->room) {
        o->room = 2 * (o->n + n + 1);
        o->s = realloc(o->s, o->room);
        assert_non_null(o->s);
    }
    memcpy(o->s + o->n, s, n);
    o->n += n;
    o->s[o->n] = '\0';
}

static void say(struct out *o, const char *format, ...)
{
    char text[256];
    va_list args;

    va_start(args, format);
    int n = vsnprintf(text, sizeof text, format, args);
    va_end(args);
    assert_in_range(n, 0, sizeof text - 1);
    say_bytes(o, text, (size_t)n);
}

/* Bytes as a Lua literal writes them. */
static void say_escaped(struct out *o, const char *s, size_t n)
{
    for (size_t i = 0; i < n; i++)
        if (s[i] >= ' ' && s[i] < 127 && s[i] != '"' && s[i] != '\\')
            say_bytes(o, s + i, 1);
        else
            say(o, "\\%03d", (unsigned char)s[i]);
}

static void say_quoted(struct out *o, const char *s, size_t n)
{
    say(o, "\"");
    say_escaped(o, s, n);
    say(o, "\"");
}

/* One of the choices, which are separated by |. */
static void say_one_of(struct rng *r, struct out *o, const char *choices)
{
    uint64_t n = 1;

    for (const char *s = choices; *s; s++)
        n += *s == '|';
    for (n = rng_below(r, n); n > 0; n--)
        choices = strchr(choices, '|') + 1;
    say_bytes(o, choices, strcspn(choices, "|"));
}

static bool once_in(struct rng *r, uint64_t n)
{
    return rng_below(r, n) == 0;
}

/* ---- numbers ---- */

static void gen_integer(struct rng *r, struct out *o)
{
    uint64_t power = (uint64_t)1 << rng_below(r, 64);

    switch (rng_below(r, 8)) {
    case 0:
        say(o, "%s", once_in(r, 2) ? "math.mininteger" : "math.maxinteger");
        break;
    case 1:
        say(o, "0x%llx", (unsigned long long)(power + rng_below(r, 3) - 1));
        break;
    case 2:
        say(o, "-0x%llx", (unsigned long long)(power + rng_below(r, 3) - 1));
        break;
    case 3:
        say(o, "0x%llx", (unsigned long long)rng_next(r));
        break;
    default:
        say(o, "%d", (int)rng_below(r, 40) - 15);
    }
}

static void gen_float(struct rng *r, struct out *o)
{
    if (once_in(r, 2))
        say_one_of(r, o,
                   "1/0|-1/0|nan|minus_nan|-0.0|0.5|5e-324|1e308|1e15|1e16|0x1p53|0x1p63|-0x1p63|3.0|1e100|0.1|1e14");
    else if (once_in(r, 2))
        say(o, "%.17g * 0x1p%d", (double)(int64_t)rng_next(r), (int)rng_below(r, 140) - 110);
    else
        say(o, "%.17g / 16", (double)((int)rng_below(r, 4000) - 2000));
}

static void gen_number(struct rng *r, struct out *o)
{
    if (once_in(r, 2))
        gen_integer(r, o);
    else
        gen_float(r, o);
}

static void gen_position(struct rng *r, struct out *o)
{
    if (once_in(r, 8))
        gen_number(r, o);
    else
        say(o, "%d", (int)rng_below(r, 30) - 12);
}

/* ---- texts ---- */

static void gen_short_text(struct rng *r, struct out *o)
{
    static const char letters[] = "aaabbbcx01 (){}[].%-^$Z\n";
    char s[24];
    size_t n = rng_below(r, sizeof s);

    for (size_t i = 0; i < n; i++)
        s[i] = once_in(r, 12) ? (char)rng_below(r, 256) : letters[rng_below(r, sizeof letters - 1)];
    say_quoted(o, s, n);
}

static void gen_utf8(struct rng *r, struct out *o)
{
    static const char *const kinds[] = {
        "a|z|\xc2\x80|\u07ff|\u20ac|\uffff|\U0001f3ae|\U0010ffff",
        /* of lax alone */
        "\xed\xa0\x80|\xf4\x90\x80\x80|\xf8\x88\x80\x80\x80|\xfd\xbf\xbf\xbf\xbf\xbf",
        /* of neither */
        "\xc0\x80|\xff|\xfe\x80\x80\x80\x80\x80\x80|\x80|\xe2\x82|\xe0\x80\x80|\xf0\x80\x80\x80|\xf8\x80\x80\x80\x80",
    };
    const uint64_t n_kinds = 1 + rng_below(r, 3);
    struct out text = { 0 };

    for (uint64_t i = rng_below(r, 9); i > 0; i--)
        if (once_in(r, 20))
            say_bytes(&text, "\0", 1);
        else
            say_one_of(r, &text, kinds[rng_below(r, n_kinds)]);
    say_quoted(o, text.s, text.n);
    free(text.s);
}

/* ---- patterns ---- */

static void add_set(struct rng *r, struct out *o)
{
    say_one_of(r, o, "[|[|[^|[]|[^]");
    for (uint64_t i = rng_below(r, 3); i < 3; i++)
        say_one_of(r, o, "a|b|c|0|-|^|a-c|0-9|%a|%D|%s|%]|%%|%-|.|\n|%w|(|c-a|x-|\x80-\xff");
    if (!once_in(r, 30))
        say(o, "]");
}

static void add_item(struct rng *r, struct out *o)
{
    if (once_in(r, 5)) {
        say_one_of(r, o, "%b()|%b{}|%baa|%bab|%f[%w]|%f[^ab]|%f[%z]|%f[%a]|()|(|)|%1|%2|%0|%b|%f");
        return;
    }
    if (once_in(r, 4))
        add_set(r, o);
    else
        say_one_of(r, o,
                   "a|b|c|x|.|%a|%d|%s|%w|%p|%u|%l|%g|%x|%c|%z|%A|%D|%S|%W|%P|%L|%X|%.|%%|%(|%y|%]|]|{|^|$| |0|1");
    say_one_of(r, o, "||||*|+|-|?");
}

/* Mostly well formed: what is opened is closed. */
static void gen_pattern(struct rng *r, struct out *o)
{
    struct out p = { 0 };
    int open = 0;

    say(&p, once_in(r, 5) ? "^" : "");
    for (uint64_t items = rng_below(r, 6); items > 0; items--) {
        if (once_in(r, 4))
            say(&p, "("), open++;
        add_item(r, &p);
        if (open && once_in(r, 2))
            say(&p, ")"), open--;
    }
    for (; open && !once_in(r, 30); open--)
        say(&p, ")");
    say(&p, once_in(r, 5) ? "$" : "");
    if (p.n && once_in(r, 15)) /* a byte anywhere becomes another */
        p.s[rng_below(r, p.n)] = (char)rng_below(r, 256);
    if (once_in(r, 200))
        say(o, "(\"a-\"):rep(250)");
    else
        say_quoted(o, p.s, p.n);
    free(p.s);
}

/* ---- tables and functions ---- */

static void gen_arg(struct rng *r, struct out *o, char kind);

static void add_list(struct rng *r, struct out *o)
{
    uint64_t kind = rng_below(r, 5);

    say(o, "{");
    for (uint64_t n = rng_below(r, once_in(r, 6) ? 70 : 8); n > 0; n--) {
        if (kind == 0)
            gen_arg(r, o, once_in(r, 3) ? 'a' : 'c');
        else if (kind == 1)
            gen_short_text(r, o);
        else if (kind == 2)
            say(o, once_in(r, 6) ? "nil" : "%d", (int)rng_below(r, 9));
        else if (kind == 3)
            say(o, "%d.5", (int)rng_below(r, 100) - 50);
        else
            say(o, "%d", (int)rng_below(r, 100));
        say(o, ", ");
    }
    say(o, "}");
}

static void gen_table(struct rng *r, struct out *o)
{
    if (once_in(r, 4))
        gen_arg(r, o, 'T');
    else
        add_list(r, o);
}

static void gen_text(struct rng *r, struct out *o)
{
    const uint64_t kind = rng_below(r, 8);

    if (kind == 0) {
        say(o, "(");
        gen_short_text(r, o);
        say(o, "):rep(%d)", (int)rng_below(r, 60));
    } else {
        gen_arg(r, o, kind == 1 ? 'N' : kind == 2 ? 'n' : 'S');
    }
}

static void gen_any(struct rng *r, struct out *o)
{
    static const char kinds[] = "nSNtwwwwwwww";

    gen_arg(r, o, kinds[rng_below(r, sizeof kinds - 1)]);
}

/* ---- formats ---- */

static void gen_format_arg(struct rng *r, struct out *o, char letter)
{
    if (once_in(r, 10))
        gen_any(r, o);
    else if (letter && strchr("diuoxXc", letter))
        gen_integer(r, o);
    else if ((letter && strchr("eEfgGaAF", letter)) || (letter == 'q' && once_in(r, 3)))
        gen_number(r, o);
    else
        gen_arg(r, o, letter == 's' && once_in(r, 4) ? 't' : 's');
}

/* Returns its letter, which is chance for once in 20. */
static char add_conversion(struct rng *r, struct out *o)
{
    static const char letters[] = "ddiuoxXcccssssqqqeEfffgG", odd[] = "aApF%yn.l\0z";
    char letter = once_in(r, 20) ? odd[rng_below(r, sizeof odd - 1)] : letters[rng_below(r, sizeof letters - 1)];
    bool plain = once_in(r, 3) || (letter == 'q' && !once_in(r, 10));

    say(o, "%%");
    if (!plain) {
        uint64_t many = once_in(r, 60) ? 24 : 3;
        for (uint64_t n = rng_below(r, many); n > 0; n--)
            say_one_of(r, o, "-|-|-|-|+|+| |#|0");
        if (once_in(r, 2))
            say(o, "%d", (int)rng_below(r, once_in(r, 30) ? 200 : 30));
        if (once_in(r, 3))
            say(o, once_in(r, 5) ? "." : ".%d", (int)rng_below(r, once_in(r, 30) ? 200 : 20));
    }
    say_bytes(o, &letter, 1);
    return letter;
}

#define BETWEEN "|| |,|%%|x\n|100"

static void gen_format(struct rng *r, struct out *o)
{
    struct out format = { 0 }, args = { 0 };

    for (uint64_t n = rng_below(r, once_in(r, 8) ? 9 : 3); n < 3; n++) {
        say_one_of(r, &format, BETWEEN);
        char letter = add_conversion(r, &format);
        if (letter == '%' || once_in(r, 40))
            continue;
        say(&args, ", ");
        gen_format_arg(r, &args, letter);
    }
    say_one_of(r, &format, BETWEEN);
    if (once_in(r, 60))
        say(&format, "%%");
    say_quoted(o, format.s, format.n);
    say_bytes(o, args.s ? args.s : "", args.n);
    free(format.s);
    free(args.s);
}

/* ---- lists of arguments ---- */

static void gen_count(struct rng *r, struct out *o)
{
    if (once_in(r, 8))
        gen_number(r, o);
    else
        say(o, "%d", (int)rng_below(r, 40) - 3);
}

static void gen_byte(struct rng *r, struct out *o)
{
    say(o, "%d", (int)rng_below(r, 260) - 1);
}

static void gen_code(struct rng *r, struct out *o)
{
    say(o, "0x%llx", (unsigned long long)rng_next(r) >> (31 + rng_below(r, 33)));
}

static void gen_arg(struct rng *r, struct out *o, char kind)
{
    static const char *const choices[128] = {
        ['w'] = "nil|nil|true|false|{}|tostring|''",
        ['l'] = "true|true|false|nil|1",
        ['K'] = "'=chunk'|'@file.lua'|'text'|nil|''",
        ['M'] = "'t'|'bt'|'b'|nil|''",
        ['m'] =
            "{}|nil|{__index = {a = 1}}|{__gc = function() end}|{__mode = 'k'}|{__call = {}}|{__call = function() end}",
        ['N'] = "'10'|'-7'|' 5 '|'0x10'|'0xA.8p1'|'1e2'|'1e'|''|'0x'|'nan'|'.5'|'zz'|'-ff'|'7fffffffffffffff'|"
                "'9223372036854775808'|'-9223372036854775808'|'1\\0'|'\\t8\\n'|'--1'",
        ['o'] = "function(a, b) return a < b end|function() end|function(...) return select('#', ...), ... end|"
                "function() error('no', 0) end|function() error({5}) end|function() local x = nil + 1 end|"
                "string.rep|error|assert|pcall|nil",
        ['O'] = "function(a, b) return a < b end|function(a, b) return a > b end|nil|"
                "function(a, b) return type(a) < type(b) end|function(a, b) return a // 2 < b // 2 end|"
                "function(a, b) return true end|function(a) error('no', 0) end|"
                "function(a, b) if a == 5 or b == 5 then error({5}) end return a < b end",
        ['r'] = "'<%0>'|'%2-%1'|'%%'|'%'|'%a'|'x\\0y'|1.5|true|minus_nan|{a = 'A', b = 1, c = false, [''] = 2.0}|"
                "{a = {}, b = minus_nan}|setmetatable({}, {__index = function(_, k) return k end})|"
                "function(...) return ... end|function(a, b) return b end|function() return {} end|"
                "function(a) if a == 'b' then error('no', 0) end end",
        ['T'] = "{a = 1, b = 2, 10, 20}|{[1] = 1, [2] = 2, [4] = 4}|{[math.maxinteger] = 1, [math.mininteger] = 2}|"
                "{[1.5] = 1, x = 2}|{[true] = 1, [{}] = 2}|"
                "setmetatable({1, 2, 3}, {__len = function() return 5 end, __index = function(_, k) return k % 7 end})|"
                "setmetatable({}, {__len = function() return 'x' end})|"
                "setmetatable({1, 2}, {__newindex = function(t, k, v) rawset(t, k, {v}) end})|"
                "setmetatable({}, {__tostring = function() return 'me' end})|"
                "setmetatable({}, {__tostring = function() return {} end})|setmetatable({}, {__name = 'thing'})|"
                "setmetatable({}, {__metatable = 'locked'})|"
                "setmetatable({}, {__pairs = function() return function() end end})|"
                "setmetatable({}, {__eq = function() return true end, __lt = function() return false end})|"
                "setmetatable({7}, {__len = function() return -3 end})",
        ['k'] = "'return ...'|'x ='|'return 2 ^ 3'|'return {__gc = 1}'|'local t = {__mode = \"k\"} return t'|'\\27Lua'|"
                "'# no\\nreturn 3'|'local a <const> = 1 a = 2'|'return \"\\\\xff\\\\u{7fffffff}\\\\z  x\"'|"
                "'return 0x7fffffffffffffffff, 1e999, 3 // 0.0'|function() end|function() return {} end|"
                "(function() local n = 0 return function() n = n + 1 return ({'return ', 4, '2'})[n] end end)()|"
                "function() error('reader', 0) end|5",
    };
    static void (*const write[128])(struct rng *, struct out *) = {
        ['s'] = gen_text,   ['S'] = gen_short_text, ['p'] = gen_pattern, ['u'] = gen_utf8, ['i'] = gen_position,
        ['n'] = gen_number, ['c'] = gen_count,      ['C'] = gen_byte,    ['U'] = gen_code, ['B'] = gen_count,
        ['t'] = gen_table,  ['f'] = gen_format,     ['a'] = gen_any,
    };

    if (choices[(unsigned char)kind])
        say_one_of(r, o, choices[(unsigned char)kind]);
    else
        write[(unsigned char)kind](r, o);
}

/* Mostly of these kinds; now and then too few, too many, or others. */
static void luagen_args(struct rng *r, struct out *o, const char *kinds)
{
    bool first = true;

    for (const char *k = kinds; *k && !once_in(r, 24); k++) {
        uint64_t n = 1;
        char kind = *k;
        if (kind == '*')
            kind = k[-1], n = rng_below(r, 5);
        for (; n > 0; n--, first = false) {
            say(o, first ? "" : ", ");
            gen_arg(r, o, once_in(r, 16) && kind != 'f' ? 'a' : kind);
        }
    }
    if (once_in(r, 24)) {
        say(o, first ? "" : ", ");
        gen_any(r, o);
    }
}

#endif
