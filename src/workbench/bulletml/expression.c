/*
 * expression.c - see expression.h. A recursive descent parser with a function for each rule of the grammar. It writes
 * operands before their operators.
 *
 * A decimal is converted to the nearest Q31.32 without doubles: the digits after the point are doubled 32 times, and
 * each carry is a bit of the result.
 */
#include "expression.h"

#include <stdio.h>
#include <string.h>

enum { DIGITS = 40 /* after the point; more digits are less than half a unit */, MAX_WHOLE = INT32_MAX };

struct parser {
    const char *text;
    size_t n, at;
    struct expression_op *ops;
    int count, nest;
    bool large, failed;
    struct expression_error *error;
};

static void fail_expected(struct parser *p, const char *what)
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

static void fail_with(struct parser *p, const char *what)
{
    if (!p->failed)
        snprintf(p->error->text, sizeof p->error->text, "%s", what);
    if (!p->failed)
        p->error->at = p->at;
    p->failed = true;
}

static void add_op(struct parser *p, enum expression_kind kind, int64_t number)
{
    if (p->failed)
        return;
    if (p->count == EXPRESSION_OPS) {
        char why[64];
        snprintf(why, sizeof why, "more than %d numbers and operators", (int)EXPRESSION_OPS);
        fail_with(p, why);
        return;
    }
    p->ops[p->count++] = (struct expression_op){ kind, number };
}

static void skip_blanks(struct parser *p)
{
    while (p->at < p->n && strchr(" \t\r\n", p->text[p->at]) && p->text[p->at] != '\0')
        p->at++;
}

/* Skips blanks and returns the next character; 0: the end. */
static char peek(struct parser *p)
{
    skip_blanks(p);
    return p->at < p->n ? p->text[p->at] : '\0';
}

static bool at_digit(const struct parser *p)
{
    return p->at < p->n && p->text[p->at] >= '0' && p->text[p->at] <= '9';
}

/* ---- decimals ---- */

/* Returns 0.d[0]d[1].. in units of 2^-32, rounded to nearest; at most 2^32. */
static int64_t to_fraction(uint8_t d[DIGITS], int n)
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

    for (; at_digit(p); p->at++, digits++)
        whole = whole > MAX_WHOLE ? whole : whole * 10 + (p->text[p->at] - '0');
    if (p->at < p->n && p->text[p->at] == '.')
        for (p->at++; at_digit(p); p->at++, digits++)
            if (n < DIGITS)
                d[n++] = (uint8_t)(p->text[p->at] - '0');
    if (digits == 0) {
        fail_expected(p, "a digit after \".\"");
        return;
    }
    if (whole > MAX_WHOLE) {
        p->large = true;
        add_op(p, EXPRESSION_NUMBER, INT64_MAX);
        return;
    }
    /* the largest fraction may round up to 1, which overflows */
    number = (int64_t)((uint64_t)whole * ((uint64_t)1 << 32) + (uint64_t)to_fraction(d, n));
    add_op(p, EXPRESSION_NUMBER, number < 0 ? INT64_MAX : number);
}

/* ---- the grammar ---- */

/* Parses $ and a word, or $ and a digit. */
static void read_variable(struct parser *p)
{
    const char *word = p->text + p->at + 1;
    const size_t left = p->n - p->at - 1;
    size_t n = 0;

    while (n < left && word[n] >= 'a' && word[n] <= 'z')
        n++;
    if (n == 4 && memcmp(word, "rank", 4) == 0) {
        add_op(p, EXPRESSION_RANK, 0);
    } else if (n == 4 && memcmp(word, "rand", 4) == 0) {
        add_op(p, EXPRESSION_RAND, 0);
    } else if (left > 0 && word[0] >= '0' && word[0] <= '9') {
        add_op(p, EXPRESSION_PARAM, word[0] - '0');
        n = 1;
    } else {
        p->at++;
        fail_expected(p, "rand, rank or 1 to 9 after \"$\"");
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
        fail_with(p, "parentheses or signs nested too deeply");
    } else if (c == '-') {
        p->at++;
        read_factor(p);
        add_op(p, EXPRESSION_NEGATE, 0);
    } else if (c == '(') {
        p->at++;
        read_sum(p);
        if (peek(p) == ')')
            p->at++;
        else
            fail_expected(p, "+ - * / or )");
    } else if (c == '$') {
        read_variable(p);
    } else if (at_digit(p) || c == '.') {
        read_number(p);
    } else {
        fail_expected(p, "a number, $rand, $rank, $1 to $9, - or (");
    }
    p->nest--;
}

static void read_product(struct parser *p)
{
    read_factor(p);
    for (char c; !p->failed && ((c = peek(p)) == '*' || c == '/');) {
        p->at++;
        read_factor(p);
        add_op(p, c == '*' ? EXPRESSION_MULTIPLY : EXPRESSION_DIVIDE, 0);
    }
}

static void read_sum(struct parser *p)
{
    read_product(p);
    for (char c; !p->failed && ((c = peek(p)) == '+' || c == '-');) {
        p->at++;
        read_product(p);
        add_op(p, c == '+' ? EXPRESSION_ADD : EXPRESSION_SUBTRACT, 0);
    }
}

int expression_read(const char *text, size_t n, struct expression_op *ops, bool *large, struct expression_error *error)
{
    struct parser p = { .text = text, .n = n, .ops = ops, .error = error };

    read_sum(&p);
    skip_blanks(&p);
    if (!p.failed && p.at < p.n)
        fail_expected(&p, "+ - * / or the end");
    if (!p.failed && expression_depth(ops, p.count) > EXPRESSION_STACK) {
        p.at = 0;
        fail_with(&p, "expression too complex; use fewer parentheses");
    }
    *large = p.large;
    return p.failed ? 0 : p.count;
}

/* ---- properties ---- */

static int operand_count(enum expression_kind kind)
{
    return kind <= EXPRESSION_PARAM ? 0 : kind == EXPRESSION_NEGATE ? 1 : 2;
}

int expression_depth(const struct expression_op *ops, int n)
{
    int depth = 0, max = 1;

    for (int i = 0; i < n; i++) {
        depth += 1 - operand_count(ops[i].kind);
        max = depth > max ? depth : max;
    }
    return max;
}

static bool apply(enum expression_kind kind, double *a, double b)
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
        else if (operand_count(ops[i].kind) == 0)
            return false;
        else if (ops[i].kind == EXPRESSION_NEGATE)
            stack[top - 1] = -stack[top - 1];
        else if (!apply(ops[i].kind, &stack[top - 2], stack[top - 1]))
            return false;
        else
            top--;
    }
    *value = stack[0];
    return n > 0;
}
