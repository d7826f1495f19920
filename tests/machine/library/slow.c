/*
 * slow.c - slow ROM FAULT: a game whose frames take long. Whatever the host does meanwhile, it has the same run and
 * ends in the fault that begins with FAULT, "" for none; its states and its demo are of that run, and load in another
 * board.
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

static void play(const struct curtain_config *how, struct run *r)
{
    const uint16_t none[CURTAIN_PADS] = { 0, 0 };
    void *at;
    struct curtain *c = open_board(how, &at);
    unsigned events = 0;

    watched = c;
    for (int f = 0; f < FRAMES && !(events & CURTAIN_FAULT); f++)
        events = curtain_frame(c, none);
    r->state = malloc(curtain_state_size(c));
    r->state_size = curtain_save(c, r->state, curtain_state_size(c), err, sizeof err);
    r->demo = curtain_demo(c, &r->demo_size, err, sizeof err);
    watched = NULL;
    snprintf(r->fault, sizeof r->fault, "%s", curtain_fault(c));
    r->hash = curtain_hash(c);
    free_board(c, at);
}

/* Another board comes to the same end from the state. */
static bool loads(struct curtain_config how, const struct run *r)
{
    void *at;
    struct curtain *c = open_board(&how, &at);
    const bool good = curtain_load(c, r->state, r->state_size, err, sizeof err) &&
                      strncmp(curtain_fault(c), r->fault, sizeof r->fault - 1) == 0 && curtain_hash(c) == r->hash;

    free_board(c, at);
    return good;
}

/* And from the demo. */
static bool replays(struct curtain_config how, const struct run *r)
{
    void *at;
    unsigned events = 0;

    how.demo = r->demo;
    how.demo_size = r->demo_size;
    struct curtain *c = r->demo ? open_board(&how, &at) : NULL;
    if (!c)
        return false;
    while (!(events & (CURTAIN_FAULT | CURTAIN_ENDED)))
        events = curtain_frame(c, NULL);
    const bool good = strncmp(curtain_fault(c), r->fault, sizeof r->fault - 1) == 0 && curtain_hash(c) == r->hash;
    free_board(c, at);
    return good;
}

static void drop(struct run *r)
{
    free(r->state);
    curtain_demo_free(r->demo);
}

int main(int argc, char **argv)
{
    struct curtain_config how = { .seed = 1 };
    const struct itimerval often = { { 0, 2000 }, { 0, 2000 } }, never = { { 0, 0 }, { 0, 0 } };
    int failed = 0;

    if (argc < 3)
        return 1;
    how.rom = read_file(argv[1], &how.rom_size);
    play(&how, &quiet);
    printf("# %.*s\n", (int)strcspn(quiet.fault, "\n"), quiet.fault);
    failed |= check("it ends as it must",
                    strncmp(quiet.fault, argv[2], strlen(argv[2])) == 0 && (argv[2][0] != 0 || quiet.fault[0] == 0));
    signal(SIGALRM, ring);
    setitimer(ITIMER_REAL, &often, NULL);
    how.alarm = true;
    play(&how, &rung);
    failed |= check("interrupted or not, it is the same run",
                    quiet.hash == rung.hash && strcmp(quiet.fault, rung.fault) == 0);
    failed |= check("it has the same state", quiet.state_size > 0 && quiet.state_size == rung.state_size &&
                                                 memcmp(quiet.state, rung.state, quiet.state_size) == 0);
    failed |= check("and the same demo", quiet.demo && rung.demo && quiet.demo_size == rung.demo_size &&
                                             memcmp(quiet.demo, rung.demo, quiet.demo_size) == 0);
    failed |= check("another board loads the state", loads(how, &rung));
    failed |= check("and plays the demo", replays(how, &rung));
    setitimer(ITIMER_REAL, &never, NULL);
    how.alarm = false;
    failed |= check("so does one without an alarm", loads(how, &rung) && replays(how, &rung));
    drop(&quiet);
    drop(&rung);
    free((void *)how.rom);
    return failed;
}
