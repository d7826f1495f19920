/*
 * eval.h - runs a line of Lua in a board between two frames.
 */
#ifndef SCRIPT_EVAL_H
#define SCRIPT_EVAL_H

#include <stdbool.h>
#include <stddef.h>

struct board;

enum {
    EVAL_LIMIT = 10000000, /* VM instructions a line may run, or the equivalent work in C */
    EVAL_TEXT_SIZE = 4200  /* buffer size in bytes for everything a line can print */
};

/* Runs `line` with the globals and rules of a game script, and no access to @std internals. The line is an expression
 * list ("player.get(1).x") or statements. Events it raises are applied at once, handlers included. Tasks it starts
 * first run in the next frame; the line itself cannot wait. Its requests to the program (attract, quit) are dropped;
 * board.reset takes effect at the end of the next tick.
 *
 * out (size bytes, size >= 1) receives the printed text, then the values, in lines ending in \n. Returns false if the
 * line did not compile, failed, or ran for too long: out then holds a one-sentence error, and the caller must restore
 * RAM. Always returns false on a board with a fault. */
bool board_eval(struct board *b, const char *line, char *out, size_t size);

/* Like board_eval, but stores the values in v (values.h). Sets out only on failure and discards printed text. */
struct values;
bool board_eval_values(struct board *b, const char *line, struct values *v, char *out, size_t size);

#endif
