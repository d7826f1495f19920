/*
 * section.h - one section of a game at one difficulty: whether it can be survived, and how hard it is.
 */
#ifndef WORKBENCH_SECTION_H
#define WORKBENCH_SECTION_H

#include "measure.h"
#include "search.h"

struct section_run {
    struct simulation simulation;
    struct search search;
    struct forecast forecast; /* of the longest run, from the first frame in which the ship was steered */
    fx x, y;                  /* of the ship in that frame */
    struct measure measure;
    char err[1024];
};

/* Searches within search.effort and search.limit, and measures the result. Close it in either case. False: err is set.
 * *host: it is an error of the host. */
bool section_search(struct section_run *s, const struct rom *rom, const struct board_start *start, bool *host);

/* Lets bots play the section instead. In a stage, they play from its start or a mark to the next mark or a boss. */
bool section_play_bots(struct section_run *s, const struct rom *rom, const struct board_start *start, int bots,
                       bool *host);
void section_close(struct section_run *s);

/* Returns whether a run without a hit was found. */
static inline bool section_survived(const struct section_run *s)
{
    return s->search.verdict == SEARCH_SURVIVED || s->search.verdict == SEARCH_LASTED;
}

#endif
