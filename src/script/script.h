/*
 * script.h - scans a script's text, before it runs, for forbidden names and operators and for the globals it reads.
 */
#ifndef SCRIPT_H
#define SCRIPT_H

#include <stdbool.h>
#include <stddef.h>

/* Returns false if the text uses the operator ^, or __gc or __mode as a name or as a whole string; it then sets *line
 * to the line number and *message to the reason. Skips comments. Text that is not Lua passes, because the compiler
 * rejects it. Allocates nothing. */
bool script_scan(const char *text, size_t n, int *line, const char **message);

/* Like script_scan, but starts at *place. When it returns false, it has moved *place past the match, so that the next
 * call continues there. */
struct script_position {
    size_t at;
    int line; /* line of byte `at`; a scan starts at { 0, 1 } */
};
bool script_scan_from(const char *text, size_t n, struct script_position *place, int *line, const char **message);

/* Finds the next name at or after *at that may be a global being read, and moves *at past it. Returns false if there
 * is none. Fields (after . or :), assigned names (before =), comments and strings are skipped. No global that a Lua
 * text reads is missed; a local variable, a label or a reserved word may be returned too. */
bool script_next_global(const char *text, size_t n, size_t *at, const char **name, size_t *size);

/* Returns the field read from the name that ends at `at`, i.e. the name after the dot, and sets *size to its bytes;
 * or NULL if no dot and name follow, so that any field may be read. */
const char *script_find_field(const char *text, size_t n, size_t at, size_t *size);

/* Returns whether the n bytes at `word` are one of the words of `list`, which are separated by single spaces. */
bool script_list_has(const char *list, const char *word, size_t n);

/* Converts `name` to the form `require` expects: "a.b", "a\\b", "./a/b" and "a/b.lua" become "a/b". Returns false if
 * it already has that form or is too long. */
enum { SCRIPT_NAME_BYTES = 128 };
bool script_normalize_name(const char *name, char out[SCRIPT_NAME_BYTES]);

/* Like script_check, but checks only the syntax. Compiled Lua is an error. */
bool script_compile(const char *text, size_t n, const char *chunk, void *scratch, size_t scratch_size, char *err,
                    size_t err_size);

/* Runs script_scan, then checks the syntax with the Lua compiler. chunk: e.g. "@stages/one.lua". scratch: scratch_size
 * bytes, 16-byte aligned, at least HEAP_MIN. Returns false on an error, including too little scratch, and writes
 * "stages/one.lua:42: what" to err. */
bool script_check(const char *text, size_t n, const char *chunk, void *scratch, size_t scratch_size, char *err,
                  size_t err_size);

#endif
