/*
 * survive_command.c - see survive.h: the words of the command line, as what survive_run takes.
 */
#include "survive.h"

#include <stdlib.h>
#include "../../common/report.h"
#include "../../player/game/game.h"

enum result survive_command(const struct args *a)
{
    const bool one_frame = a->n_spans == 1 && a->spans[0].first == a->spans[0].last && a->spans[0].last > 0;
    struct game *g = calloc(1, sizeof *g);
    char err[1024];

    if (!g)
        return report_line(RESULT_HOST_FAILED, "out of memory");
    if ((a->n_spans && !one_frame) || !game_open(g, a->n_words ? a->words[0] : NULL, a, err, sizeof err)) {
        free(g);
        if (a->n_spans && !one_frame)
            return report_line(RESULT_REFUSED, "--frames: survive takes one number, the number of frames to search");
        return report_error(err);
    }
    const struct survive_options o = { .path = g->path ? g->path : "the built-in game",
                                       .rom = &g->rom,
                                       .cart = &g->cart,
                                       .start = g->start,
                                       .all = a->all,
                                       .difficulty = a->difficulty,
                                       .stage = a->stage,
                                       .out = a->out,
                                       .map = a->map,
                                       .frames = a->n_spans ? a->spans[0].last : SURVIVE_FRAMES,
                                       .effort = a->effort ? a->effort : SURVIVE_EFFORT,
                                       .bots = a->bots,
                                       .prints = a->prints,
                                       .json = a->json,
                                       .verbose = a->verbose };
    const enum result result = survive_run(&o);
    game_close(g);
    free(g);
    return result;
}
