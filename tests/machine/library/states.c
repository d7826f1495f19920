/*
 * states.c - states ROM [SECTION]: two boards go back and forth between states that either saved, and come to the same
 * frames; what is played from there is the same too; what is no state is refused, and nothing is changed by it.
 */
#include "common.h"

enum { STATES = 40, APART = 37, JUMPS = 150, ON = 45 };

struct kept {
    void *bytes;
    size_t size;
    uint64_t hash, then; /* of its frame; of that after ON more frames without pads */
    uint32_t frames;
} kept[STATES];

static uint64_t play_on(struct curtain *c)
{
    const uint16_t none[CURTAIN_PADS] = { 0, 0 };

    for (int i = 0; i < ON; i++)
        curtain_frame(c, none);
    return curtain_hash(c);
}

static bool save(struct curtain *c, struct kept *k)
{
    k->bytes = malloc(curtain_state_size(c));
    k->size = curtain_save(c, k->bytes, curtain_state_size(c), err, sizeof err);
    k->hash = curtain_hash(c);
    k->frames = curtain_frames(c);
    return k->size > 0;
}

static bool load(struct curtain *c, const struct kept *k)
{
    if (!curtain_load(c, k->bytes, k->size, err, sizeof err))
        return printf("# %s\n", err), false;
    return curtain_hash(c) == k->hash && curtain_frames(c) == k->frames;
}

static bool record(struct curtain *c)
{
    uint16_t pads[CURTAIN_PADS] = { 0, 0 };
    bool good = true;

    for (int i = 0; i < STATES; i++) {
        for (int f = 0; f < APART; f++, any_pads(pads))
            curtain_frame(c, pads);
        good = good && save(c, &kept[i]);
    }
    for (int i = 0; i < STATES; i++)
        good = good && load(c, &kept[i]) && (kept[i].then = play_on(c)) != 0;
    return good;
}

static bool jump(struct curtain *a, struct curtain *b)
{
    bool good = true;

    for (int i = 0; i < JUMPS && good; i++) {
        struct curtain *c = chance(2) ? a : b;
        const struct kept *k = &kept[chance(STATES)];
        good = load(c, k);
        if (chance(3) == 0)
            good = good && play_on(c) == k->then;
    }
    return good;
}

static bool refuses(struct curtain *c, const void *bytes, size_t size)
{
    const uint64_t hash = curtain_hash(c);

    return !curtain_load(c, bytes, size, err, sizeof err) && err[0] && curtain_hash(c) == hash;
}

static bool refuses_others(struct curtain *c)
{
    const struct kept *k = &kept[STATES - 1];
    bool good = refuses(c, "", 0) && refuses(c, "CURTAINS", 8);

    for (size_t n = 0; n < k->size; n += 1 + n / 8)
        good = good && refuses(c, k->bytes, n);
    return good && load(c, k) && play_on(c) == k->then;
}

int main(int argc, char **argv)
{
    struct curtain_config how = { .seed = 7, .section = argc > 2 ? argv[2] : NULL }, small;
    void *at[3];
    int failed = 0;

    how.rom = read_file(argv[1], &how.rom_size);
    small = how;
    small.snapshots = 1;
    small.state_room = 64;
    struct curtain *a = open_board(&how, &at[0]), *b = open_board(&how, &at[1]), *c = open_board(&small, &at[2]);
    if (!a || !b || !c)
        return 1;
    failed |= check("states are saved and loaded where they were saved", record(a));
    failed |= check("and by another board, in any order", jump(a, b));
    failed |= check("what is no state is refused, and nothing has happened", refuses_others(b));
    failed |= check("a longer run than there is room for is refused",
                    refuses(c, kept[STATES - 1].bytes, kept[STATES - 1].size) && strstr(err, "too long"));
    failed |= check("a short one is not", load(c, &kept[0]));
    uint16_t pads[CURTAIN_PADS] = { 0, 0 };
    for (int f = 0; f < 100; f++, pads[0] ^= CURTAIN_FIRE)
        curtain_frame(c, pads);
    uint8_t state[4096];
    failed |= check("nor is such a run saved", curtain_save(c, state, sizeof state, err, sizeof err) == 0 &&
                                                   strstr(err, "too many input changes"));
    for (int i = 0; i < STATES; i++)
        free(kept[i].bytes);
    free_board(a, at[0]);
    free_board(b, at[1]);
    free_board(c, at[2]);
    free((void *)how.rom);
    return failed;
}
