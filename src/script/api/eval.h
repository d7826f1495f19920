/*
 * eval.h - a line of Lua, run in a board between two frames.
 */
#ifndef SCRIPT_EVAL_H
#define SCRIPT_EVAL_H

#include <stdbool.h>
#include <stddef.h>

struct board;

enum {
    EVAL_LIMIT = 10000000, /* VM instructions a line may run, or work in C worth as many */
    EVAL_TEXT = 4200       /* bytes that hold all that a line can print */
};

/* Runs `line` as a script of the game would: its globals, its rules, nothing of @std's own. It is an expression list
 * ("player.get(1).x") or statements. The events it raises are applied at once, handlers included. Tasks it starts get
 * their first turn in the next frame; it cannot wait itself. Its requests to the cabinet (attract, quit) are dropped;
 * board.reset comes with the end of the next tick.
 *
 * out (size bytes, size >= 1) gets what it printed, then its values, lines ending in \n. False: it did not compile,
 * failed, or ran for too long; out is one sentence, and RAM can only be restored. On a board with a fault it always
 * fails. */
bool board_eval(struct board *b, const char *line, char *out, size_t size);

/* The same; its values go into v (values.h), and out gets a sentence only where it fails. What it prints is dropped. */
struct values;
bool board_eval_values(struct board *b, const char *line, struct values *v, char *out, size_t size);

#endif
