/*
 * testing_command.c - see testing.h: the words of the command line, as what testing_run takes; and those of scripts,
 * which start runs and press buttons as the command line does.
 */
#include "testing.h"

#include <stdlib.h>
#include <string.h>
#include "../../../platform/platform.h"
#include "../../base/err.h"
#include "../../common/report.h"
#include "../../player/game/game.h"

struct tested {
    const struct args *a;
    struct game game;
    struct args held[TRIAL_RUNS]; /* the buttons of each run: the presses alone */
};

/* A sentence of the command line, in a script: what it says of --stage is of stage. */
static bool without_dashes(char *err)
{
    if (strncmp(err, "--", 2) == 0)
        memmove(err, err + 2, strlen(err + 2) + 1);
    return false;
}

static bool test_start(void *user, const struct trial_start *want, struct board_start *start, char *err,
                       size_t err_size)
{
    struct tested *t = user;
    struct args a = { .seed = want->seed,
                      .stage = want->stage,
                      .difficulty = want->difficulty,
                      .lang = want->lang,
                      .lives = want->lives,
                      .invincible = want->invincible,
                      .n_dips = want->n_dips,
                      .n_registers = want->n_registers };

    memcpy(a.dips, want->dips, sizeof want->dips);
    memcpy(a.registers, want->registers, sizeof want->registers);
    if (!game_start(&t->game, &a, err, err_size))
        return without_dashes(err);
    *start = t->game.start;
    return true;
}

static bool test_press(void *user, int run, const char *list, char *err, size_t err_size)
{
    struct args *a = &((struct tested *)user)->held[run];

    char why[512];

    a->n_presses = 0;
    if (!list[0] || args_presses(a, list, why, sizeof why))
        return true;
    return err_set(err, err_size, "pads%s", strchr(why, ':')); /* "--press: ..." */
}

static void test_pressed(void *user, int run, uint32_t frame, uint16_t pads[MAX_PLAYERS])
{
    args_pressed(&((struct tested *)user)->held[run], frame, pads);
}

static enum result test_game(struct tested *t)
{
    const struct args *a = t->a;
    const struct testing testing = { .dir = a->words[0],
                                     .cart = &t->game.cart,
                                     .names = a->words + 1,
                                     .n_names = a->n_words - 1,
                                     .update = a->update,
                                     .tap = a->tap,
                                     .junit = a->junit,
                                     .page = a->page,
                                     .jobs = a->jobs,
                                     .user = t,
                                     .start = test_start,
                                     .press = test_press,
                                     .pressed = test_pressed };
    char err[1024];

    if (plat_file_size(a->words[0]) >= 0)
        return report_line(RESULT_REFUSED, "%s: expected a game's folder, got a file", a->words[0]);
    if (!game_open(&t->game, a->words[0], a, err, sizeof err))
        return report_error(err);
    const enum result result = testing_run(&testing);
    game_close(&t->game);
    return result;
}

enum result testing_command(const struct args *a)
{
    struct tested *t = calloc(1, sizeof *t);

    if (!t)
        return report_line(RESULT_HOST_FAILED, "out of memory");
    t->a = a;
    const enum result result = test_game(t);
    free(t);
    return result;
}
