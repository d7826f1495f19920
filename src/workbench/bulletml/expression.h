/*
 * expression.h - the numbers of a BulletML document: text to operations for a stack.
 *
 *     sum     := product (("+" | "-") product)*
 *     product := factor (("*" | "/") factor)*
 *     factor  := "-" factor | "(" sum ")" | NUMBER | "$rand" | "$rank" | "$" DIGIT
 *
 * The operations stand in the order in which they are done, left operand first, so that $rand is drawn in reading
 * order. Blanks, tabs and new lines between the words do not count.
 */
#ifndef WORKBENCH_EXPRESSION_H
#define WORKBENCH_EXPRESSION_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

enum {
    EXPRESSION_OPS = 250,  /* of one number of a document */
    EXPRESSION_STACK = 16, /* values that are held at once */
    EXPRESSION_NEST = 64   /* parentheses and signs in one another */
};

enum expression_kind {
    EXPRESSION_NUMBER, /* put `number` on the stack */
    EXPRESSION_RAND,   /* put a draw from 0 up to 1 on it */
    EXPRESSION_RANK,
    EXPRESSION_PARAM, /* $1 to $9; and $0, which some write: `number` is the digit, as a plain whole number */
    EXPRESSION_ADD,   /* take two, put one: the one below is the left operand */
    EXPRESSION_SUBTRACT,
    EXPRESSION_MULTIPLY,
    EXPRESSION_DIVIDE,
    EXPRESSION_NEGATE /* take one, put one */
};

struct expression_op {
    enum expression_kind kind;
    int64_t number; /* Q31.32, the nearest to the decimal; the greatest there is for what is too large */
};

/* What is wrong, and at which byte of the text. */
struct expression_error {
    size_t at;
    char text[128];
};

/* Reads n bytes into ops, EXPRESSION_OPS of them; how many, and 0 for an error. *large: a number was too large for
 * Q31.32 and stands as the greatest. */
int expression_read(const char *text, size_t n, struct expression_op *ops, bool *large, struct expression_error *error);

/* The values that are on the stack at most while they are done; at least 1. */
int expression_depth(const struct expression_op *ops, int n);

/* Is the number the same each time, whatever is drawn, and rank and parameters are? *value is it, for messages: the
 * board's own arithmetic is bulletml.h's. Division by 0 is not the same. */
bool expression_constant(const struct expression_op *ops, int n, double *value);

#endif
