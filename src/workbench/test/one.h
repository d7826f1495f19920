/*
 * one.h - one test of a game.
 */
#ifndef WORKBENCH_ONE_H
#define WORKBENCH_ONE_H

#include "outcome.h"
#include "testing.h"

/* Runs it, and says (outcome.h) on out what came of it. */
void one_demo(const struct testing *t, const char *name, FILE *out);
void one_script(const struct testing *t, const char *name, FILE *out);

#endif
