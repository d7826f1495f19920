/*
 * headless_run.c - see headless_run.h.
 */
#include "headless_run.h"

#include <string.h>
#include "../../common/report.h"

/* Reports the outcome of a power-on or tick. */
static enum result report_outcome(struct headless_run *r)
{
    const struct board_out *out = board_last_output(r->guard.board);

    if (r->outcomes++ < r->reported)
        return out->fault ? RESULT_REFUSED : RESULT_DONE;
    report_log(out, "");
    return out->fault ? report_fault(out->fault, r->a->verbose) : RESULT_DONE;
}

static enum result open_run(struct headless_run *r, const struct args *a, uint32_t reported)
{
    const char *path = a->n_words > 0 ? a->words[0] : NULL;
    char err[1024];

    memset(r, 0, sizeof *r);
    r->a = a;
    r->reported = reported;
    if (!game_open(&r->game, path, a, err, sizeof err))
        return report_error(err);
    if (!guard_power(&r->guard, &r->game.rom, &r->game.start, err, sizeof err))
        return report_line(RESULT_REFUSED, "%s: %s", path ? path : "the built-in game", err);
    if (a->record && !demo_begin(&r->writer, a->record, &r->game.cart, r->guard.board, &r->game.start, 0))
        return report_line(RESULT_HOST_FAILED, "%s", r->writer.err);
    if (a->record && !demo_set_checksum_rate(&r->writer, (enum demo_checksum_rate)a->prints))
        return report_line(RESULT_HOST_FAILED, "%s", r->writer.err);
    return report_outcome(r);
}

enum result headless_run_open(struct headless_run *r, const struct args *a)
{
    return open_run(r, a, 0);
}

enum result headless_run_repeat(struct headless_run *r, const struct args *a)
{
    return open_run(r, a, r->outcomes);
}

enum result headless_run_tick(struct headless_run *r)
{
    uint16_t pads[MAX_PLAYERS];

    args_held_pads(r->a, board_frame(r->guard.board), pads);
    if (r->game.has_demo)
        demo_pads(&r->game.demo, board_frame(r->guard.board), pads);
    guard_tick(&r->guard, pads);
    if (!demo_record_frame(&r->writer, r->guard.board, pads))
        return report_line(RESULT_HOST_FAILED, "%s", r->writer.err);
    return report_outcome(r);
}

enum result headless_run_close(struct headless_run *r, enum result result)
{
    if (r->guard.board && !demo_end(&r->writer, r->guard.board) && result == RESULT_DONE)
        result = report_line(RESULT_HOST_FAILED, "%s", r->writer.err);
    demo_free(&r->writer.demo);
    guard_close(&r->guard);
    game_close(&r->game);
    return result;
}
