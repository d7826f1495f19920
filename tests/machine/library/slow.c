/*
 * slow.c - slow ROM: a host with an alarm. A frame that takes long is looked at and goes on; one that never ends is
 * found.
 */
#include <signal.h>
#include <sys/time.h>
#include "common.h"

static struct curtain *volatile watched;

/* All the time: late, early, twice in a frame. */
static void ring(int number)
{
    (void)number;
    if (watched)
        curtain_interrupt(watched);
}

static uint64_t play(const struct curtain_config *how, char *fault, size_t size)
{
    const uint16_t none[CURTAIN_PADS] = { 0, 0 };
    void *at;
    struct curtain *c = open_board(how, &at);
    unsigned events = 0;

    if (how->alarm)
        watched = c;
    for (int f = 0; f < 60 && !(events & CURTAIN_FAULT); f++)
        events = curtain_frame(c, none);
    watched = NULL;
    snprintf(fault, size, "%s", curtain_fault(c));
    const uint64_t hash = curtain_hash(c);
    free_board(c, at);
    return hash;
}

int main(int argc, char **argv)
{
    struct curtain_config how = { .seed = 1 };
    char plain[600], alarmed[600];
    const struct itimerval often = { { 0, 2000 }, { 0, 2000 } };
    int failed = 0;

    if (argc < 2)
        return 1;
    how.rom = read_file(argv[1], &how.rom_size);
    const uint64_t hash = play(&how, plain, sizeof plain);
    signal(SIGALRM, ring);
    setitimer(ITIMER_REAL, &often, NULL);
    how.alarm = true;
    const uint64_t again = play(&how, alarmed, sizeof alarmed);
    failed |= check("interrupted or not, it is the same run", hash == again && strcmp(plain, alarmed) == 0);
    printf("# %.60s\n", plain);
    free((void *)how.rom);
    return failed;
}
