/*
 * expression.h - the numbers of a BulletML document: text to operations for a stack.
 *
 *     sum     := product (("+" | "-") product)*
 *     product := factor (("*" | "/") factor)*
 *     factor  := "-" factor | "(" sum ")" | NUMBER | "$rand" | "$rank" | "$" DIGIT
 *
 * Operations are in the order of evaluation, left operand first, so that $rand is drawn in reading order. Blanks, tabs
 * and new lines are ignored.
 */
#ifndef WORKBENCH_EXPRESSION_H
#define WORKBENCH_EXPRESSION_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

enum {
    EXPRESSION_OPS = 250,  /* of one number of a document */
    EXPRESSION_STACK = 16, /* values on the stack */
    EXPRESSION_NEST = 64   /* nested parentheses and signs */
};

enum expression_kind {
    EXPRESSION_NUMBER, /* put `number` on the stack */
    EXPRESSION_RAND,   /* put a draw from 0 up to 1 on it */
    EXPRESSION_RANK,
    EXPRESSION_PARAM, /* $1 to $9, and $0, which some documents use: `number` is the digit */
    EXPRESSION_ADD,   /* take two, put one: the one below is the left operand */
    EXPRESSION_SUBTRACT,
    EXPRESSION_MULTIPLY,
    EXPRESSION_DIVIDE,
    EXPRESSION_NEGATE /* take one, put one */
};

struct expression_op {
    enum expression_kind kind;
    int64_t number; /* Q31.32, nearest to the decimal; INT64_MAX if too large */
};

/* An error, and its byte in the text. */
struct expression_error {
    size_t at;
    char text[128];
};

/* Reads n bytes into ops, at most EXPRESSION_OPS; returns their number, 0: error. *large: a number was clamped to the
 * largest of Q31.32. */
int expression_read(const char *text, size_t n, struct expression_op *ops, bool *large, struct expression_error *error);

/* The largest size of the stack during evaluation; at least 1. */
int expression_depth(const struct expression_op *ops, int n);

/* True if the number doesn't depend on $rand, rank or parameters. *value is for messages; the board calculates as in
 * bulletml.h. Division by 0 is not constant. */
bool expression_constant(const struct expression_op *ops, int n, double *value);

#endif
