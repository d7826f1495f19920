/*
 * script.h - what a script must not contain, and the names in it, found in its text before it runs.
 */
#ifndef SCRIPT_H
#define SCRIPT_H

#include <stdbool.h>
#include <stddef.h>

/* False when the text uses the operator ^, or the names __gc or __mode as a name or as a whole string: *line is where,
 * *what a sentence. Comments are skipped. Text that is not Lua is let through: the compiler refuses it. Allocates
 * nothing. */
bool script_scan(const char *text, size_t n, int *line, const char **what);

/* script_scan from a place on, which moves behind what is found, so that the next call finds the next. */
struct script_place {
    size_t at;
    int line; /* of the byte at; the text starts at { 0, 1 } */
};
bool script_scan_on(const char *text, size_t n, struct script_place *place, int *line, const char **what);

/* The next name from *at on that may be a global which is read: any but a field's (behind . or :) and one that is
 * assigned (before =). Comments and strings are skipped. *at moves behind it. False: there is none. Of a Lua text no
 * global that is read is missed; a local variable, a label or a reserved word may be given. */
bool script_next_read(const char *text, size_t n, size_t *at, const char **name, size_t *size);

/* The field that is read of the name which ends at `at`: what stands behind a point, of *size bytes. NULL: there is
 * none, so all that the name stands for may be read. */
const char *script_field(const char *text, size_t n, size_t at, size_t *size);

/* How `require` names the script that somebody may mean by `name`: "a.b", "a\\b", "./a/b" and "a/b.lua" become "a/b".
 * False: the name is written so already, or too long. */
enum { SCRIPT_NAME = 128 };
bool script_name(const char *name, char out[SCRIPT_NAME]);

/* The syntax check alone; compiled Lua is refused too. As script_check. */
bool script_compile(const char *text, size_t n, const char *chunk, void *work, size_t work_size, char *err,
                    size_t err_size);

/* script_scan, then a syntax check by the Lua compiler. chunk is "@stages/one.lua"; work is work_size bytes
 * of scratch, 16-byte aligned, at least HEAP_MIN; too few are an error. err gets "stages/one.lua:42: what". */
bool script_check(const char *text, size_t n, const char *chunk, void *work, size_t work_size, char *err,
                  size_t err_size);

#endif
