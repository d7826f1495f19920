/*
 * lua_example.h - the example and the guide's page that `curtain help lua NAME` prints below an entry. They are in
 * share/help/TABLE.md, which the tests run.
 */
#ifndef WORKBENCH_LUA_EXAMPLE_H
#define WORKBENCH_LUA_EXAMPLE_H

/* Prints both; nothing for a name without an example. */
void lua_example_print(const char *name);

#endif
