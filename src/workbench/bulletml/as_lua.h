/*
 * as_lua.h - a BulletML document as a script of Lua that does the same, for authors who move over.
 */
#ifndef WORKBENCH_AS_LUA_H
#define WORKBENCH_AS_LUA_H

#include "document.h"

/* The script (malloc, ends with a 0) of a document that document_read has taken. NULL: out of memory. What cannot be
 * said stands in its comments. */
char *as_lua(const struct document *d, const char *file);

#endif
