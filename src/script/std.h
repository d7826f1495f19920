/*
 * std.h - the modules of the standard library (@std): their load order, and which modules a script uses.
 *
 * A ROM contains only the modules that its scripts name and, in turn, the modules that these modules name. Only cab has
 * the source of the modules; at run time they are the ROM's lumps "script/@std/NAME.lua".
 *
 * Code that a module rarely needs is in separate pieces such as "screens/title". A piece is packed with its module, is
 * not run at power-on, and is loaded on each call of sys.read. A piece may use only modules that its own module or the
 * game that requested the piece names, because a piece adds no module to the ROM.
 */
#ifndef SCRIPT_STD_H
#define SCRIPT_STD_H

#include <stddef.h>
#include <stdint.h>

enum { STD_MODULE_COUNT = 20 };

/* The hint in the error for using (in the console) the global of a module that no script of the game names. */
#define STD_NOT_PACKED "not packed in this ROM; a library module is packed if a script names it"

/* The modules in load order. Module 0 is the prelude, which all others need. `globals` lists the global variables
 * through which scripts use the module: its table or, for the prelude, each of its functions. A module that extends
 * another module's table has no global of its own: it adds `fields` to `extended_table`, which is then its only
 * entry in `globals`. */
struct std_module {
    const char *name, *globals, *fields, *extended_table;
};
extern const struct std_module std_modules[STD_MODULE_COUNT];

/* Returns the module that a piece such as "boss/cast" belongs to: the module with the name of the piece's folder, or
 * boot for "screens". Returns -1 if `name` is not a piece. */
int std_module_of_file(const char *name);

/* Returns the module that binds the global `name`, or -1. */
int std_module_of_global(const char *name);

/* Returns the module that adds `field` to `table`, or -1. */
int std_module_of_field(const char *table, const char *field);

/* Returns the modules whose globals or fields a script with this text may read: bit i for module i. A text that can
 * compute names (_G, _ENV, load) needs them all. */
uint64_t std_find_used_modules(const char *text, size_t n);

/* Like std_find_used_modules, for the text of module i itself: omits the modules that add fields to i's own table, and
 * game, which no module needs. */
uint64_t std_find_needed_modules(int i, const char *text, size_t n);

#endif
