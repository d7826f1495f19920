/*
 * page.h - what failed, as one HTML file with its pictures in it.
 */
#ifndef WORKBENCH_PAGE_H
#define WORKBENCH_PAGE_H

#include "reporter.h"

/* Writes the page's text. dir: the game's folder, where tests/failed has the pictures. */
void page_write(FILE *out, const char *dir, const char *title, const struct test *tests, const struct sums *s);

#endif
