/*
 * demo_test.h - a demo as a test: its playback must match its recording, as for curtain verify.
 */
#ifndef WORKBENCH_DEMO_TEST_H
#define WORKBENCH_DEMO_TEST_H

#include <stdio.h>
#include "testing.h"

/* Plays the demo `name` ("demos/run.demo") of the game, and writes its outcome (outcome.h) to out. */
void demo_test_run(const struct testing *t, const char *name, FILE *out);

#endif
