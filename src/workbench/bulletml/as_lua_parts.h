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
    int indent;      /* in units of two spaces */
    int depth;       /* of nested functions */
    char suffix[12]; /* suffix of s and shot at this depth: "", "2" */
};

/* Writes a number as a Lua expression, with the constant `add` added. tight: in parentheses if it has operators. */
void as_lua_value(struct byte_buffer *t, const struct document_node *node, double add, bool tight);

/* Writes a number as an integer number of frames or times, at least `least`. */
void as_lua_count(struct byte_buffer *t, const struct document_node *node, int least);

/* Writes a number in its shortest form. */
void as_lua_number(struct byte_buffer *t, double v);

/* Returns whether the number is the same for all bullets of a run: it uses neither $rand nor parameters. */
bool as_lua_is_fixed(const struct document_node *node);

/* Returns the degrees to add to an absolute direction of a document, whose 0 is up, or left in a horizontal
 * document. */
double as_lua_up(const struct document *d);

/* Appends the steps of a motion program for a bullet's actions, "{ wait = 30 }, { speed = 2 }". False: a motion program
 * cannot express them, and nothing was appended. */
bool as_lua_motion(struct byte_buffer *t, const struct document *d, int32_t bullet);

/* Appends the helper functions that the text calls, directly or indirectly. */
void as_lua_helpers(struct byte_buffer *t, const char *body);

/* Appends the first lines of a script. body: the rest of the script. */
void as_lua_head(struct byte_buffer *t, const struct document *d, const char *file, const char *body);

#endif
