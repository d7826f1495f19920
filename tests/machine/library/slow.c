/*
 * slow.c - slow ROM FAULT: a game whose frames take long. Whatever the host does meanwhile, it has the same run and
 * ends in the fault that begins with FAULT, "" for none; its state and its demo are of that run.
 */
#include <signal.h>
#include <sys/time.h>
#include "common.h"

enum { FRAMES = 60 };

static struct curtain *volatile watched;

/* All the time: late, early, twice in a frame. */
static void ring(int number)
{
    (void)number;
    if (watched)
        curtain_interrupt(watched);
}

static struct run {
    uint64_t hash;
    char fault[600];
    void *state;
    size_t state_size;
    void *demo;
    size_t demo_size;
} quiet, rung;

static void play(const struct curtain_config *config, struct run *r)
{
    void *memory;
    struct curtain *c = open_board(config, &memory);
    unsigned events = 0;

    watched = c;
    for (int f = 0; f < FRAMES && !(events & CURTAIN_FAULT); f++)
        events = run_frames(c, 1);
    r->state = malloc(curtain_state_size(c));
    r->state_size = curtain_save(c, r->state, curtain_state_size(c), err, sizeof err);
    r->demo = curtain_demo(c, &r->demo_size, err, sizeof err);
    watched = NULL;
    snprintf(r->fault, sizeof r->fault, "%s", curtain_fault(c));
    r->hash = curtain_hash(c);
    free_board(c, memory);
}

/* Another board comes to the same end from the state. */
static bool loads(const struct curtain_config *config, const struct run *r)
{
    void *memory;
    struct curtain *c = open_board(config, &memory);
    const bool good = curtain_load(c, r->state, r->state_size, err, sizeof err) &&
                      strncmp(curtain_fault(c), r->fault, sizeof r->fault - 1) == 0 && curtain_hash(c) == r->hash;

    free_board(c, memory);
    return good;
}

int main(int argc, char **argv)
{
    struct curtain_config config = { .seed = 1 };
    const struct itimerval often = { { 0, 2000 }, { 0, 2000 } };
    int failed = 0;

    if (argc < 3)
        return 1;
    config.rom = read_file(argv[1], &config.rom_size);
    play(&config, &quiet);
    failed |= check("it ends as it must",
                    strncmp(quiet.fault, argv[2], strlen(argv[2])) == 0 && (argv[2][0] != 0 || quiet.fault[0] == 0));
    signal(SIGALRM, ring);
    setitimer(ITIMER_REAL, &often, NULL);
    config.alarm = true;
    play(&config, &rung);
    failed |= check("interrupted or not, it is the same run",
                    quiet.hash == rung.hash && strcmp(quiet.fault, rung.fault) == 0);
    failed |= check("it has the same state", quiet.state_size > 0 && quiet.state_size == rung.state_size &&
                                                 memcmp(quiet.state, rung.state, quiet.state_size) == 0);
    failed |= check("and the same demo", quiet.demo && rung.demo && quiet.demo_size == rung.demo_size &&
                                             memcmp(quiet.demo, rung.demo, quiet.demo_size) == 0);
    failed |= check("another board loads the state", loads(&config, &rung));
    free(quiet.state);
    free(rung.state);
    curtain_demo_free(quiet.demo);
    curtain_demo_free(rung.demo);
    free((void *)config.rom);
    return failed;
}
