/*
 * art_palette.c - the 256 colours. A row is a bank of 16; column 0 is never drawn (it is the colour of the empty
 * screen).
 *
 * In every bank 1 is the darkest and 15 the lightest, so text can be drawn in any of them. Banks 0..7 are eight times
 * the same ramp (rim, body, bright, core) for whatever is recoloured by adding a bank: bullets, sparks, text.
 */
#include "art.h"

#include <stddef.h>

struct key {
    int at;
    uint32_t rgb;
};

#define RAMP(rim, dark, body, bright, pale)                                                                            \
    {                                                                                                                  \
        { 1, rim }, { 4, dark }, { 8, body }, { 11, bright }, { 13, pale }, { 15, 0xffffff },                          \
    }

/* Colours between two keys are mixed. */
static const struct key KEYS[16][12] = {
    RAMP(0x10162e, 0x3c4c88, 0x86a2e6, 0xbdd4ff, 0xe4efff), /* 0 pearl */
    RAMP(0x2c0410, 0x8e0d2c, 0xf2283e, 0xff6e62, 0xffc6b8), /* 1 ruby */
    RAMP(0x2c0e04, 0x943604, 0xf87c10, 0xffb044, 0xffe2b0), /* 2 amber */
    RAMP(0x241a02, 0x846806, 0xeac818, 0xffe858, 0xfff6bc), /* 3 gold */
    RAMP(0x042210, 0x0a6c36, 0x22d05c, 0x76f482, 0xceffc8), /* 4 green */
    RAMP(0x032028, 0x06667e, 0x14c0dc, 0x64ecf4, 0xcafcff), /* 5 cyan */
    RAMP(0x0c0c3e, 0x2832b0, 0x4c6cff, 0x88aaff, 0xd2deff), /* 6 indigo */
    RAMP(0x26062e, 0x801486, 0xe840e2, 0xff8af0, 0xffd4fa), /* 7 magenta */
    /* 8 heron: 2..6 hull, 7..9 glass, 10..12 accent, 13..14 flame */
    { { 1, 0x0b1022 },
      { 2, 0x2b3556 },
      { 4, 0x8796ba },
      { 6, 0xf0f6ff },
      { 7, 0x0c5266 },
      { 8, 0x22aab4 },
      { 9, 0x90f4e6 },
      { 10, 0x921f40 },
      { 11, 0xec4c54 },
      { 12, 0xffa488 },
      { 13, 0xffb648 },
      { 15, 0xffffff } },
    /* 9 petrel: the same parts */
    { { 1, 0x10101a },
      { 2, 0x26344a },
      { 4, 0x7ea8a6 },
      { 6, 0xe6fff0 },
      { 7, 0x7a3a08 },
      { 8, 0xe09020 },
      { 9, 0xffe48c },
      { 10, 0x43247e },
      { 11, 0x8458e0 },
      { 12, 0xc8aaff },
      { 13, 0x58d8ff },
      { 15, 0xffffff } },
    /* 10 cold glass: 2..9 glass, 10..13 what is inside */
    { { 1, 0x050c1c },
      { 2, 0x123458 },
      { 4, 0x257092 },
      { 7, 0x5ccad0 },
      { 9, 0xb8fff0 },
      { 10, 0x86204e },
      { 11, 0xdc4678 },
      { 12, 0xff8c98 },
      { 13, 0xffd2c2 },
      { 14, 0xd2fff6 },
      { 15, 0xffffff } },
    /* 11 warm glass: the same parts */
    { { 1, 0x120618 },
      { 2, 0x381858 },
      { 4, 0x74369a },
      { 7, 0xcc76d4 },
      { 9, 0xffc4f4 },
      { 10, 0x8c5810 },
      { 11, 0xe2a022 },
      { 12, 0xffd85e },
      { 13, 0xfff0b4 },
      { 14, 0xffe4fb },
      { 15, 0xffffff } },
    /* 12 bosses: 2..8 glass, 9..11 gold, 12..13 heart */
    { { 1, 0x080a20 },
      { 2, 0x1c2058 },
      { 4, 0x4048a4 },
      { 6, 0x7c98ea },
      { 8, 0xc4eaff },
      { 9, 0x8a5214 },
      { 10, 0xe0a232 },
      { 11, 0xffe38a },
      { 12, 0xc8265e },
      { 13, 0xff7c9c },
      { 14, 0xe6f8ff },
      { 15, 0xffffff } },
    /* 13 the deep: 1..12 slate, 13..15 what glimmers in it */
    { { 1, 0x060914 },
      { 4, 0x0f1829 },
      { 8, 0x213248 },
      { 12, 0x43586c },
      { 13, 0x28606c },
      { 14, 0x468a92 },
      { 15, 0x9ab6bc } },
    /* 14 fire */
    { { 1, 0x1a0a22 },
      { 2, 0x3a1040 },
      { 4, 0xa2244c },
      { 6, 0xf46036 },
      { 8, 0xffb042 },
      { 10, 0xffe682 },
      { 13, 0xfff8d8 },
      { 15, 0xffffff } },
    /* 15 the title: 2..9 water, 10..14 gold */
    { { 1, 0x040a1e },
      { 2, 0x0a2048 },
      { 4, 0x145684 },
      { 6, 0x2aa0c0 },
      { 8, 0x84e6e6 },
      { 9, 0xd2fff8 },
      { 10, 0x7c4a12 },
      { 11, 0xc88a24 },
      { 12, 0xf2c444 },
      { 14, 0xfff2c0 },
      { 15, 0xffffff } },
};

/* Banks 8 to 15 of the night. */
static const struct key NIGHT[8][12] = {
    /* 8 the kite: 2..6 paper, 7..9 red dye, 10..12 wood and gold, 13..15 its lamp */
    { { 1, 0x140c1c },
      { 2, 0x54486a },
      { 4, 0xb8a8b8 },
      { 6, 0xfff8ec },
      { 7, 0x7c1428 },
      { 8, 0xd82c38 },
      { 9, 0xff7a68 },
      { 10, 0x5c3818 },
      { 11, 0xb88032 },
      { 12, 0xf0c868 },
      { 13, 0xffb040 },
      { 15, 0xffffff } },
    /* 9 iron, for whatever a game has of its own */
    { { 1, 0x0c0e14 }, { 4, 0x3a4250 }, { 8, 0x76869a }, { 12, 0xb8c8d8 }, { 15, 0xffffff } },
    /* 10 warm paper: 2..9 lit paper, 10..12 wood, 13..15 flame */
    { { 1, 0x1c0610 },
      { 2, 0x480c1c },
      { 4, 0xa41c24 },
      { 6, 0xea4c28 },
      { 8, 0xff9a3c },
      { 9, 0xffcc62 },
      { 10, 0x2c1a22 },
      { 11, 0x5e3a30 },
      { 12, 0xa2764c },
      { 13, 0xffe07a },
      { 14, 0xfff4c4 },
      { 15, 0xffffff } },
    /* 11 moonlit paper: the same parts */
    { { 1, 0x0a0a20 },
      { 2, 0x221c54 },
      { 4, 0x4c40a0 },
      { 6, 0x8478dc },
      { 8, 0xbcb4fc },
      { 9, 0xe2dcff },
      { 10, 0x241c38 },
      { 11, 0x564878 },
      { 12, 0x9a88c0 },
      { 13, 0x8af0e0 },
      { 14, 0xd0fff4 },
      { 15, 0xffffff } },
    /* 12 the keeper: 2..8 wings, 9..11 gold, 12..13 ember, 14..15 light */
    { { 1, 0x0e0618 },
      { 2, 0x2a0e3c },
      { 4, 0x6a2468 },
      { 6, 0xbc4a86 },
      { 8, 0xffb0b4 },
      { 9, 0x7a4a18 },
      { 10, 0xd29a34 },
      { 11, 0xffe68e },
      { 12, 0xe0481c },
      { 13, 0xff9c34 },
      { 14, 0xffe88c },
      { 15, 0xffffff } },
    /* 13 the night: 1..6 sky and water, 7..10 hills and fields, 13..15 what glimmers */
    { { 1, 0x080a1c },
      { 2, 0x0c1028 },
      { 3, 0x121838 },
      { 4, 0x1c2148 },
      { 5, 0x2c2a58 },
      { 6, 0x443462 },
      { 7, 0x080d16 },
      { 8, 0x101824 },
      { 9, 0x18242c },
      { 10, 0x2c3a4c },
      { 11, 0x3c4a60 },
      { 15, 0xe8ecff } },
    /* 14 fire */
    { { 1, 0x1a0a22 },
      { 2, 0x3a1040 },
      { 4, 0xa2244c },
      { 6, 0xf46036 },
      { 8, 0xffb042 },
      { 10, 0xffe682 },
      { 13, 0xfff8d8 },
      { 15, 0xffffff } },
    /* 15 the moon */
    { { 1, 0x10122c }, { 2, 0x2a2850 }, { 6, 0x8c86a8 }, { 10, 0xd8cfc4 }, { 13, 0xfff6dc }, { 15, 0xffffff } },
};

/* The scenery of stage one below the wreck, where less light comes. */
static const struct key DEEP[12] = {
    { 1, 0x02040c },  { 4, 0x060f22 },  { 8, 0x0d2442 },  { 12, 0x1b3c58 },
    { 13, 0x123250 }, { 14, 0x1a4458 }, { 15, 0x28505c },
};

/* Banks 10 to 13 of the stages of Glass Tide: creatures, darker ones, bosses, and the scenery. */
static const struct key ONE[4][12] = {
    /* 10 blue glass: 2..9 glass, 10..13 what is inside */
    { { 1, 0x050a1e },
      { 2, 0x102a5e },
      { 4, 0x2060a4 },
      { 7, 0x58aeea },
      { 9, 0xbcecff },
      { 10, 0x0c5a74 },
      { 11, 0x1ea6ba },
      { 12, 0x6ce6e6 },
      { 13, 0xd0fff8 },
      { 14, 0xdcf6ff },
      { 15, 0xffffff } },
    /* 11 indigo glass: the same parts */
    { { 1, 0x0a0a22 },
      { 2, 0x1e1e60 },
      { 4, 0x3c42a8 },
      { 7, 0x7e8cec },
      { 9, 0xd2daff },
      { 10, 0x104a8c },
      { 11, 0x2a8ed8 },
      { 12, 0x7cd4ff },
      { 13, 0xdcf6ff },
      { 14, 0xe4eaff },
      { 15, 0xffffff } },
    /* 12 bosses: 2..8 glass, 9..11 silver, 12..13 cold light */
    { { 1, 0x060a20 },
      { 2, 0x18205a },
      { 4, 0x3450ac },
      { 6, 0x6c9cec },
      { 8, 0xc2ecff },
      { 9, 0x2c4a66 },
      { 10, 0x7ea6bc },
      { 11, 0xdcf4f8 },
      { 12, 0x0e7c9c },
      { 13, 0x6ee6ec },
      { 14, 0xe6fcff },
      { 15, 0xffffff } },
    /* 13 the shallows: 1..12 blue slate, 13..15 light on it */
    { { 1, 0x030812 },
      { 4, 0x0a1a2e },
      { 8, 0x163a54 },
      { 12, 0x2a5866 },
      { 13, 0x1c4e60 },
      { 14, 0x266066 },
      { 15, 0x3c6666 } },
};
static const struct key TWO[4][12] = {
    /* 10 copper: 2..9 metal, 10..13 what burns inside */
    { { 1, 0x140806 },
      { 2, 0x3c1c10 },
      { 4, 0x843f1e },
      { 7, 0xd0803c },
      { 9, 0xffd49c },
      { 10, 0x8a1c08 },
      { 11, 0xe2541a },
      { 12, 0xff9a3c },
      { 13, 0xffe09a },
      { 15, 0xffffff } },
    /* 11 steel: the same parts, with brass inside */
    { { 1, 0x0c0b0c },
      { 2, 0x2c2a2c },
      { 4, 0x5e5c5c },
      { 7, 0xa8a49c },
      { 9, 0xeee8d8 },
      { 10, 0x5c3a14 },
      { 11, 0xa4762c },
      { 12, 0xe0b45c },
      { 13, 0xfae8b4 },
      { 15, 0xffffff } },
    /* 12 what the furnace made: 2..8 hot iron, 9..11 brass, 12..13 fire */
    { { 1, 0x100806 },
      { 2, 0x2e1812 },
      { 4, 0x6c3822 },
      { 6, 0xbc6c38 },
      { 8, 0xffcc90 },
      { 9, 0x7a4210 },
      { 10, 0xd8902c },
      { 11, 0xffdc86 },
      { 12, 0xd83a10 },
      { 13, 0xff8a3c },
      { 14, 0xffeccc },
      { 15, 0xffffff } },
    /* 13 the drowned works: 1..12 rust and soot, 13..15 embers */
    { { 1, 0x0a0708 },
      { 4, 0x1e1614 },
      { 8, 0x402c22 },
      { 12, 0x664736 },
      { 13, 0x6e2a12 },
      { 14, 0xa4501e },
      { 15, 0xd0965c } },
};
static const struct key THREE[4][12] = {
    /* 10 violet glass: 2..9 glass, 10..13 what is inside */
    { { 1, 0x0c0618 },
      { 2, 0x261448 },
      { 4, 0x5e36a2 },
      { 7, 0xa678e6 },
      { 9, 0xdcc4ff },
      { 10, 0x5a1464 },
      { 11, 0xa83cb4 },
      { 12, 0xe48ae4 },
      { 13, 0xffd8fa },
      { 15, 0xffffff } },
    /* 11 rose glass: the same parts */
    { { 1, 0x14060f },
      { 2, 0x3e1238 },
      { 4, 0x8c327e },
      { 7, 0xc868b4 },
      { 9, 0xffc8f0 },
      { 10, 0x3c1c78 },
      { 11, 0x7048c8 },
      { 12, 0xa890f4 },
      { 13, 0xe4d8ff },
      { 15, 0xffffff } },
    /* 12 the queen: 2..8 glass, 9..11 silver, 12..13 heart */
    { { 1, 0x0c0820 },
      { 2, 0x241a54 },
      { 4, 0x52389c },
      { 6, 0x9a78e4 },
      { 8, 0xe0ccff },
      { 9, 0x5a5474 },
      { 10, 0xa49cc4 },
      { 11, 0xe8e4ff },
      { 12, 0xa01c78 },
      { 13, 0xf070c0 },
      { 14, 0xf0e6ff },
      { 15, 0xffffff } },
    /* 13 the abyss: 1..12 indigo slate, 13..15 what glimmers in it */
    { { 1, 0x06081c },
      { 4, 0x121a40 },
      { 8, 0x26386a },
      { 12, 0x486092 },
      { 13, 0x345088 },
      { 14, 0x5878b4 },
      { 15, 0xa8c4ec } },
};
static const struct key MOON[4][12] = {
    /* 10 silver: 2..9 metal, 10..13 what is inside */
    { { 1, 0x0a0c12 },
      { 2, 0x262c38 },
      { 4, 0x566070 },
      { 7, 0xa0acb8 },
      { 9, 0xeaf2f6 },
      { 10, 0x3c4450 },
      { 11, 0x78828e },
      { 12, 0xb8c0c8 },
      { 13, 0xf0f2f4 },
      { 15, 0xffffff } },
    /* 11 pearl: the same parts */
    { { 1, 0x100e0e },
      { 2, 0x322e30 },
      { 4, 0x6c6664 },
      { 7, 0xb4aea8 },
      { 9, 0xf6f0e6 },
      { 10, 0x44403c },
      { 11, 0x868078 },
      { 12, 0xc4bcb0 },
      { 13, 0xf8f4ea },
      { 15, 0xffffff } },
    /* 12 the moon: 2..8 stone, 9..11 light, 12..13 its eye */
    { { 1, 0x080a10 },
      { 2, 0x222834 },
      { 4, 0x4e586a },
      { 6, 0x9aa6b6 },
      { 8, 0xe6eef4 },
      { 9, 0x6c6a60 },
      { 10, 0xb8b29c },
      { 11, 0xf6f0d6 },
      { 12, 0x28303c },
      { 13, 0x8494a4 },
      { 14, 0xf4f8fa },
      { 15, 0xffffff } },
    /* 13 black water: 1..12, 13..15 moonlight on it */
    { { 1, 0x070c18 },
      { 4, 0x142032 },
      { 8, 0x2c4256 },
      { 12, 0x4c6072 },
      { 13, 0x3c4e60 },
      { 14, 0x6c8090 },
      { 15, 0xb4c2ca } },
};

/* The story's pictures, banks 8 to 15: 1..7 what is far, 8..11 what is near, 12..15 what shines. Those of text stay. */
#define LAMPS                                                                                                          \
    { 12, 0x9c5a1c }, { 13, 0xf0b040 }, { 14, 0xffdc8c },                                                              \
    {                                                                                                                  \
        15, 0xfff6dc                                                                                                   \
    }
#define STORY_PICTURE(dark, deep, mid, pale, near, lit, ...)                                                           \
    {                                                                                                                  \
        { 1, dark }, { 3, deep }, { 5, mid }, { 7, pale }, { 8, near }, { 11, lit }, __VA_ARGS__                       \
    }
static const struct key STORY[8][12] = {
    /* 8 the dry harbour */
    STORY_PICTURE(0x1c1630, 0x4c2c4c, 0xa4585a, 0xf0b078, 0x160e18, 0x745044, { 12, 0x8c6a58 }, { 13, 0xd8b898 },
                  { 14, 0xf4dcc0 }, { 15, 0xfff6e6 }),
    /* 9 the brink */
    STORY_PICTURE(0x060818, 0x101a3c, 0x22325e, 0x48608c, 0x05060e, 0x3a4462, LAMPS),
    /* 10 the wave of glass */
    STORY_PICTURE(0x050c1c, 0x0c3450, 0x2c7c9c, 0x8ce4e0, 0x14405c, 0xb8fff0, { 12, 0x86204e }, { 13, 0xdc4678 },
                  { 14, 0xffc0b0 }, { 15, 0xffffff }),
    /* 11 the dive */
    STORY_PICTURE(0x03060f, 0x08203a, 0x14506c, 0x4aa0ae, 0x10182a, 0xdce8f4, LAMPS),
    /* 12 the harbour at dawn */
    STORY_PICTURE(0x1e2450, 0x584478, 0xc8707c, 0xffdca4, 0x16142a, 0x7c6478, LAMPS),
    /* 13 of no picture: slate, for faint text */
    { { 1, 0x060914 }, { 8, 0x2c3c54 }, { 15, 0x9ab6bc } },
    /* 14 the moon at home */
    STORY_PICTURE(0x060a1c, 0x0e1c40, 0x263e70, 0x6c8cb8, 0x04060e, 0x3c4a6c, { 12, 0x8c8468 }, { 13, 0xd8cfa8 },
                  { 14, 0xf6eccc }, { 15, 0xfffdf0 }),
    { { 1, 0x040a1e }, { 15, 0xffffff } },
};

static uint32_t mix(uint32_t a, uint32_t b, int i, int n)
{
    uint32_t out = 0;
    for (int shift = 0; shift < 24; shift += 8) {
        int ca = (int)(a >> shift & 255), cb = (int)(b >> shift & 255);
        out |= (uint32_t)((ca * (n - i) + cb * i + n / 2) / n) << shift;
    }
    return out;
}

static void fill(uint32_t rgb[16], const struct key *k)
{
    rgb[0] = 0x04060e;
    for (; k[0].at < 15; k++) {
        for (int i = k[0].at; i <= k[1].at; i++)
            rgb[i] = mix(k[0].rgb, k[1].rgb, i - k[0].at, k[1].at - k[0].at);
    }
}

void art_palette(uint32_t rgb[256])
{
    for (int bank = 0; bank < 16; bank++)
        fill(&rgb[bank * 16], KEYS[bank]);
}

/* Where no lamp shines: glass is a shape and no more, but teeth, eyes and lights stay to be seen. */
static void darken(uint32_t rgb[256])
{
    for (int bank = 10; bank < 14; bank++) {
        for (int i = 1; i < 16; i++) {
            bool light = bank < 12 ? i == 13 || i == 15 : bank == 12 && (i == 11 || i == 13 || i == 15);
            uint32_t *c = &rgb[bank * 16 + i];
            *c = mix(*c, rgb[0], light ? 3 : bank == 13 ? 6 : 7, 10);
        }
    }
}

void art_stage_palette(enum art_stage stage, uint32_t rgb[256])
{
    const bool one = stage == ART_ONE || stage == ART_DEEP;
    const struct key(*banks)[12] = one ? ONE : stage == ART_TWO ? TWO : stage == ART_MOON ? MOON : THREE;

    art_palette(rgb);
    for (int bank = 10; stage != ART_MAIN && stage != ART_STORY && bank < 14; bank++)
        fill(&rgb[bank * 16], banks[bank - 10]);
    if (stage == ART_DEEP)
        fill(&rgb[13 * 16], DEEP);
    if (stage == ART_DARK)
        darken(rgb);
    for (int bank = 8; stage == ART_STORY && bank < 15; bank++)
        fill(&rgb[bank * 16], STORY[bank - 8]);
}

void art_night_palette(uint32_t rgb[256])
{
    art_palette(rgb);
    for (int bank = 8; bank < 16; bank++)
        fill(&rgb[bank * 16], NIGHT[bank - 8]);
    rgb[13 * 16 + 13] = 0xffae4c; /* a lamp far away */
    rgb[13 * 16 + 14] = 0x5c6496; /* a glint, a faint star */
}
