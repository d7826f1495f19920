/*
 * as_lua.h - converts a BulletML document to a Lua script, for authors who move to Lua.
 */
#ifndef WORKBENCH_AS_LUA_H
#define WORKBENCH_AS_LUA_H

#include "document.h"

/* Returns the script (malloc, NUL-terminated) for a document that document_read has accepted. NULL: out of memory.
 * Differences from the document are listed in the script's comments. */
char *as_lua(const struct document *d, const char *file);

#endif
