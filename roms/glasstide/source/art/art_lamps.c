/*
 * art_lamps.c - the craft in other colours, for those who earned them: the same pictures in banks that no stage
 * changes, gilt in the title's, ember in the fire's.
 */
#include "art.h"

/* The shades of a craft's parts (art_palette.c: outline, 2..6 hull, 7..9 glass, 10..12 accent, 13..15 flame) there. */
static const uint8_t GILT[16] = { 0, 1, 10, 10, 11, 12, 14, 4, 6, 8, 3, 5, 7, 8, 9, 15 };
static const uint8_t EMBER[16] = { 0, 1, 2, 2, 3, 3, 4, 5, 8, 11, 5, 6, 7, 9, 12, 15 };

static struct sheet dyed(struct sheet s, int bank, const uint8_t shades[16])
{
    for (int i = 0; i < s.w * s.h; i++)
        s.px[i] = shades[s.px[i] & 15];
    s.bank = bank;
    return s;
}

struct sheet art_heron_gilt(void)
{
    return dyed(art_heron(), 15, GILT);
}

struct sheet art_petrel_gilt(void)
{
    return dyed(art_petrel(), 15, GILT);
}

struct sheet art_tern_gilt(void)
{
    return dyed(art_tern(), 15, GILT);
}

struct sheet art_heron_ember(void)
{
    return dyed(art_heron(), 14, EMBER);
}

struct sheet art_petrel_ember(void)
{
    return dyed(art_petrel(), 14, EMBER);
}

struct sheet art_tern_ember(void)
{
    return dyed(art_tern(), 14, EMBER);
}
