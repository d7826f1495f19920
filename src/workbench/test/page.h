/*
 * page.h - the outcomes of all tests as an HTML page that contains its pictures.
 */
#ifndef WORKBENCH_PAGE_H
#define WORKBENCH_PAGE_H

#include "reporter.h"

/* Writes the page. dir: the game's folder; its tests/failed has the pictures. */
void page_write(FILE *out, const char *dir, const char *title, const struct test *tests, const struct sums *s);

#endif
