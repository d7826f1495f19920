/*
 * std.h - the modules of the standard library (@std): their order, and which of them a script names.
 *
 * A ROM has the modules that its scripts name, and those that these name; what is not in the ROM is not loaded. Below
 * cab nobody has their texts: they are lumps "script/@std/NAME.lua".
 *
 * What a module seldom needs stands in pieces of its own, "screens/title": they come into the ROM with their module,
 * are not run when the machine starts, and are read each time sys.read asks for one. They may name what their module
 * names (or the game, where it asked for them), for they bring no module along.
 */
#ifndef SCRIPT_STD_H
#define SCRIPT_STD_H

#include <stddef.h>
#include <stdint.h>

enum { STD_MODULES = 19 };

/* Said of a module's global in a game whose scripts do not name it: in a line typed into the console. */
#define STD_NOT_HERE "not packed in this ROM; a library module is packed if a script names it"

/* Module i, in the order in which they are loaded: "pattern". The first is the prelude, which all others need. */
const char *std_module(int i);

/* The module whose piece "boss/cast" is: that of the folder's name, of "screens" it is boot. -1: no piece. */
int std_piece_of(const char *name);

/* The module that binds the global of that name, or -1. */
int std_of(const char *name);

/* The table, there without it, to which module i adds fields, or NULL; and the module that adds this one, or -1. */
const char *std_adds_to(int i);
int std_of_field(const char *table, const char *field);

/* Modules of which a script with this text may read a global or a field: bit i for module i. What can compute names
 * (_G, _ENV, load) names them all. */
uint64_t std_named(const char *text, size_t n);

/* The same of module i's own text, which may name its table without needing what others add to it. */
uint64_t std_needed(int i, const char *text, size_t n);

#endif
