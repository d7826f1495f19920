/*
 * bench_command.c - see bench.h: the words of the command line, as what bench_run takes.
 */
#include "bench.h"

#include <stdlib.h>
#include "../../common/report.h"
#include "../../player/game/game.h"

enum result bench_command(const struct args *a)
{
    struct game *g = calloc(1, sizeof *g);
    char err[1024];

    if (!g)
        return report_line(RESULT_HOST_FAILED, "out of memory");
    enum result result = RESULT_DONE;
    if (!game_open(g, a->words[0], a, err, sizeof err)) {
        result = report_error(err);
    } else {
        const struct bench b = { .path = a->words[0],
                                 .cart = &g->cart,
                                 .start = g->start,
                                 .demo = g->has_demo ? &g->demo : NULL,
                                 .demo_name = a->demo,
                                 .own_start = a->seeded || a->n_dips || a->difficulty || a->lang,
                                 .slower = a->machine,
                                 .json = a->json };
        result = bench_run(&b);
        game_close(g);
    }
    free(g);
    return result;
}
