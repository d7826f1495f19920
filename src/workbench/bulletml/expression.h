/*
 * expression.h - parses the numbers of a BulletML document into operations for a stack machine.
 *
 *     sum     := product (("+" | "-") product)*
 *     product := factor (("*" | "/") factor)*
 *     factor  := "-" factor | "(" sum ")" | NUMBER | "$rand" | "$rank" | "$" DIGIT
 *
 * Operations are in evaluation order, left operand first, so that $rand is drawn in reading order. Whitespace is
 * ignored.
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
    EXPRESSION_NUMBER, /* push `number` */
    EXPRESSION_RAND,   /* push a random number from 0 to less than 1 */
    EXPRESSION_RANK,
    EXPRESSION_PARAM, /* $1 to $9, and $0, which some documents use: `number` is the digit */
    EXPRESSION_ADD,   /* pop two, push one: the lower one is the left operand */
    EXPRESSION_SUBTRACT,
    EXPRESSION_MULTIPLY,
    EXPRESSION_DIVIDE,
    EXPRESSION_NEGATE /* pop one, push one */
};

struct expression_op {
    enum expression_kind kind;
    int64_t number; /* Q31.32, nearest to the decimal; INT64_MAX if too large */
};

/* An error, and its offset in the text. */
struct expression_error {
    size_t at;
    char text[128];
};

/* Parses n bytes into ops, at most EXPRESSION_OPS; returns their number, 0: error. *large: a number was clamped to the
 * maximum of Q31.32. */
int expression_read(const char *text, size_t n, struct expression_op *ops, bool *large, struct expression_error *error);

/* Returns the maximum size of the stack during evaluation, at least 1. */
int expression_depth(const struct expression_op *ops, int n);

/* Returns whether the number doesn't depend on $rand, rank or parameters. *value is for messages, because the board
 * calculates as in bulletml.h. A division by 0 is not constant. */
bool expression_constant(const struct expression_op *ops, int n, double *value);

#endif
