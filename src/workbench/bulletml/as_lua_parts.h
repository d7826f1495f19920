/*
 * as_lua_parts.h - shared by the files of `curtain bulletml --lua`: as_lua.c (elements), as_lua_value.c (numbers),
 * as_lua_motion.c (motion programs), as_lua_head.c (the first lines), as_lua_helpers.c (functions that scripts need).
 */
#ifndef WORKBENCH_AS_LUA_PARTS_H
#define WORKBENCH_AS_LUA_PARTS_H

#include "../../common/byte_buffer.h"
#include "document.h"

struct lua_writer {
    const struct document *d;
    struct byte_buffer body;
    int indent;   /* steps of two blanks */
    int depth;    /* of functions inside functions */
    char own[12]; /* suffix of s and shot at that depth: "", "2" */
};

/* A number as an expression of Lua; `add` is added to it. tight: in parentheses, if it is more than one word. */
void as_lua_value(struct byte_buffer *t, const struct document_node *node, double add, bool tight);

/* The same as a whole number of frames or times, at least `least`. */
void as_lua_count(struct byte_buffer *t, const struct document_node *node, int least);

/* The shortest text of a number. */
void as_lua_number(struct byte_buffer *t, double v);

/* Is it the same for all bullets of a run: neither drawn by chance nor a parameter? */
bool as_lua_fixed(const struct document_node *node);

/* Degrees to add to an absolute direction of a document, whose 0 is up, or left in a horizontal document. */
double as_lua_up(const struct document *d);

/* Adds the steps of a motion program for a bullet's actions, "{ wait = 30 }, { speed = 2 }". False, and adds nothing:
 * a motion program cannot express them. */
bool as_lua_motion(struct byte_buffer *t, const struct document *d, int32_t bullet);

/* Adds the helper functions that the text calls, and those that they call. */
void as_lua_helpers(struct byte_buffer *t, const char *body);

/* The first lines of a script with that body. */
void as_lua_head(struct byte_buffer *t, const struct document *d, const char *file, const char *body);

#endif
