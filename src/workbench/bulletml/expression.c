/*
 * expression.c - see expression.h. A recursive descent parser with a function for each rule of the grammar. It writes
 * operands before their operators.
 *
 * A decimal becomes the nearest Q31.32 without a double: the digits after the point are doubled 32 times, and each
 * carry is a bit.
 */
#include "expression.h"

#include <stdio.h>
#include <string.h>

enum { DIGITS = 40 /* after the point; further ones are less than half a unit */, WHOLE_MOST = INT32_MAX };

struct parser {
    const char *text;
    size_t n, at;
    struct expression_op *ops;
    int count, nest;
    bool large, failed;
    struct expression_error *error;
};

static void fail(struct parser *p, const char *what)
{
    char got[16] = "the end";

    if (p->failed)
        return;
    p->failed = true;
    p->error->at = p->at;
    if (p->at < p->n && (uint8_t)p->text[p->at] <= ' ') {
        snprintf(got, sizeof got, "a blank");
    } else if (p->at < p->n) {
        size_t n = 1; /* a whole character */
        while (n < 4 && p->at + n < p->n && ((uint8_t)p->text[p->at + n] & 0xc0) == 0x80)
            n++;
        snprintf(got, sizeof got, "\"%.*s\"", (int)n, p->text + p->at);
    }
    snprintf(p->error->text, sizeof p->error->text, "expected %s, got %s", what, got);
}

static void fail_plain(struct parser *p, const char *what)
{
    if (!p->failed)
        snprintf(p->error->text, sizeof p->error->text, "%s", what);
    if (!p->failed)
        p->error->at = p->at;
    p->failed = true;
}

static void put(struct parser *p, enum expression_kind kind, int64_t number)
{
    if (p->failed)
        return;
    if (p->count == EXPRESSION_OPS) {
        char why[64];
        snprintf(why, sizeof why, "more than %d numbers and operators", (int)EXPRESSION_OPS);
        fail_plain(p, why);
        return;
    }
    p->ops[p->count++] = (struct expression_op){ kind, number };
}

static void pass_blanks(struct parser *p)
{
    while (p->at < p->n && strchr(" \t\r\n", p->text[p->at]) && p->text[p->at] != '\0')
        p->at++;
}

/* The next character after blanks; 0: the end. */
static char peek(struct parser *p)
{
    pass_blanks(p);
    return p->at < p->n ? p->text[p->at] : '\0';
}

static bool digit(const struct parser *p)
{
    return p->at < p->n && p->text[p->at] >= '0' && p->text[p->at] <= '9';
}

/* ---- decimals ---- */

/* 0.d[0]d[1].. in units of 2^-32, to the nearest; up to 2^32. */
static int64_t fraction_of(uint8_t d[DIGITS], int n)
{
    int64_t bits = 0;

    for (int bit = 0; bit < 32; bit++) {
        int carry = 0;
        for (int i = n - 1; i >= 0; i--) {
            const int v = d[i] * 2 + carry;
            carry = v >= 10;
            d[i] = (uint8_t)(v - 10 * carry);
        }
        bits = bits << 1 | carry;
    }
    return bits + (n > 0 && d[0] >= 5);
}

static void read_number(struct parser *p)
{
    uint8_t d[DIGITS];
    int64_t whole = 0, number;
    int n = 0, digits = 0;

    for (; digit(p); p->at++, digits++)
        whole = whole > WHOLE_MOST ? whole : whole * 10 + (p->text[p->at] - '0');
    if (p->at < p->n && p->text[p->at] == '.')
        for (p->at++; digit(p); p->at++, digits++)
            if (n < DIGITS)
                d[n++] = (uint8_t)(p->text[p->at] - '0');
    if (digits == 0) {
        fail(p, "a digit after \".\"");
        return;
    }
    if (whole > WHOLE_MOST) {
        p->large = true;
        put(p, EXPRESSION_NUMBER, INT64_MAX);
        return;
    }
    /* The largest fraction may round up to a whole, beyond the greatest number. */
    number = (int64_t)((uint64_t)whole * ((uint64_t)1 << 32) + (uint64_t)fraction_of(d, n));
    put(p, EXPRESSION_NUMBER, number < 0 ? INT64_MAX : number);
}

/* ---- the grammar ---- */

/* $ and a word of letters, or a digit. */
static void read_variable(struct parser *p)
{
    const char *word = p->text + p->at + 1;
    const size_t left = p->n - p->at - 1;
    size_t n = 0;

    while (n < left && word[n] >= 'a' && word[n] <= 'z')
        n++;
    if (n == 4 && memcmp(word, "rank", 4) == 0) {
        put(p, EXPRESSION_RANK, 0);
    } else if (n == 4 && memcmp(word, "rand", 4) == 0) {
        put(p, EXPRESSION_RAND, 0);
    } else if (left > 0 && word[0] >= '0' && word[0] <= '9') {
        put(p, EXPRESSION_PARAM, word[0] - '0');
        n = 1;
    } else {
        p->at++;
        fail(p, "rand, rank or 1 to 9 after \"$\"");
        return;
    }
    p->at += 1 + n;
}

static void read_sum(struct parser *p);

static void read_factor(struct parser *p)
{
    const char c = peek(p);

    if (p->failed)
        return;
    if (++p->nest > EXPRESSION_NEST) {
        fail_plain(p, "parentheses or signs nested too deeply");
    } else if (c == '-') {
        p->at++;
        read_factor(p);
        put(p, EXPRESSION_NEGATE, 0);
    } else if (c == '(') {
        p->at++;
        read_sum(p);
        if (peek(p) == ')')
            p->at++;
        else
            fail(p, "+ - * / or )");
    } else if (c == '$') {
        read_variable(p);
    } else if (digit(p) || c == '.') {
        read_number(p);
    } else {
        fail(p, "a number, $rand, $rank, $1 to $9, - or (");
    }
    p->nest--;
}

static void read_product(struct parser *p)
{
    read_factor(p);
    for (char c; !p->failed && ((c = peek(p)) == '*' || c == '/');) {
        p->at++;
        read_factor(p);
        put(p, c == '*' ? EXPRESSION_MULTIPLY : EXPRESSION_DIVIDE, 0);
    }
}

static void read_sum(struct parser *p)
{
    read_product(p);
    for (char c; !p->failed && ((c = peek(p)) == '+' || c == '-');) {
        p->at++;
        read_product(p);
        put(p, c == '+' ? EXPRESSION_ADD : EXPRESSION_SUBTRACT, 0);
    }
}

int expression_read(const char *text, size_t n, struct expression_op *ops, bool *large, struct expression_error *error)
{
    struct parser p = { .text = text, .n = n, .ops = ops, .error = error };

    read_sum(&p);
    pass_blanks(&p);
    if (!p.failed && p.at < p.n)
        fail(&p, "+ - * / or the end");
    if (!p.failed && expression_depth(ops, p.count) > EXPRESSION_STACK) {
        p.at = 0;
        fail_plain(&p, "expression too complex; use fewer parentheses");
    }
    *large = p.large;
    return p.failed ? 0 : p.count;
}

/* ---- properties ---- */

static int taken(enum expression_kind kind)
{
    return kind <= EXPRESSION_PARAM ? 0 : kind == EXPRESSION_NEGATE ? 1 : 2;
}

int expression_depth(const struct expression_op *ops, int n)
{
    int now = 0, most = 1;

    for (int i = 0; i < n; i++) {
        now += 1 - taken(ops[i].kind);
        most = now > most ? now : most;
    }
    return most;
}

static bool do_one(enum expression_kind kind, double *a, double b)
{
    if (kind == EXPRESSION_ADD)
        *a += b;
    else if (kind == EXPRESSION_SUBTRACT)
        *a -= b;
    else if (kind == EXPRESSION_MULTIPLY)
        *a *= b;
    else
        *a = b == 0 ? 0 : *a / b;
    return kind != EXPRESSION_DIVIDE || b != 0;
}

bool expression_constant(const struct expression_op *ops, int n, double *value)
{
    double stack[EXPRESSION_STACK] = { 0 };
    int top = 0;

    for (int i = 0; i < n; i++) {
        if (ops[i].kind == EXPRESSION_NUMBER)
            stack[top++] = (double)ops[i].number / 4294967296.0;
        else if (taken(ops[i].kind) == 0)
            return false;
        else if (ops[i].kind == EXPRESSION_NEGATE)
            stack[top - 1] = -stack[top - 1];
        else if (!do_one(ops[i].kind, &stack[top - 2], stack[top - 1]))
            return false;
        else
            top--;
    }
    *value = stack[0];
    return n > 0;
}
