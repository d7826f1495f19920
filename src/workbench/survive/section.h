/*
 * section.h - one section of a game at one difficulty: is there a way, and how hard is it?
 */
#ifndef WORKBENCH_SECTION_H
#define WORKBENCH_SECTION_H

#include "measure.h"
#include "seek.h"

struct section_run {
    struct trial trial;
    struct seek seek;
    struct forecast course; /* what happened in the run that came furthest, from when it was steered */
    fx x, y;                /* where the ship was then */
    struct measure measure;
    char err[1024];
};

/* Looks, within effort and limit; measures what was survived, if that is wanted. Close it either way. False: err says
 * why, and `host` whether the host is to blame. */
bool section_look(struct section_run *s, const struct rom *rom, const struct board_start *start, bool measured,
                  bool *host);
/* Lets so many bots fly it, and looks for no way. Of a stage a part: from its start or a mark to the next one or to a
 * boss. */
bool section_fly(struct section_run *s, const struct rom *rom, const struct board_start *start, int bots, bool *host);
void section_close(struct section_run *s);

/* Is there a run without a hit? */
static inline bool section_survived(const struct section_run *s)
{
    return s->seek.verdict == SEEK_SURVIVED || s->seek.verdict == SEEK_LASTED;
}

#endif
