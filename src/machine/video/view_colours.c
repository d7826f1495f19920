/*
 * view_colours.c - colours for the colour-blind modes.
 *
 * A colour as a colour-blind eye sees it is simulated by a matrix applied to its red, green and blue in linear light.
 * The matrices are those of G. M. Machado, M. M. Oliveira and L. A. F. Fernandes, "A Physiologically-based Model for
 * Simulation of Color Vision Deficiency", IEEE Transactions on Visualization and Computer Graphics 15 (2009), for a
 * missing cone (severity 1.0):
 *
 *     protanopia    0.152286  1.052583 -0.204868    deuteranopia  0.367322  0.860646 -0.227968
 *                   0.114503  0.786281  0.099216                  0.280085  0.672501  0.047413
 *                  -0.003882 -0.048116  1.051998                 -0.011820  0.042940  0.968881
 *     tritanopia    1.255528 -0.076749 -0.178779
 *                  -0.078411  0.930809  0.147602
 *                   0.004733  0.691367  0.303900
 *
 * The colour minus the simulated colour is what the eye loses. Half of the lost red and blue is added to a channel that
 * the eye does see and that contributes little to brightness: blue, and for tritanopia red, where half of the lost blue
 * is also subtracted from green. So red and green differ along the blue-yellow axis, blue and yellow along the
 * red-green axis, and light colours stay light: the contrast of bullets with backgrounds hardly changes. Adding all of
 * the lost colour instead of half would hardly separate the confused colours further, and would make more pairs of
 * distinct colours look alike. Each row of `added` holds the amounts added to one channel. Their sum is 0, so greys do
 * not change.
 */
#include "view.h"

enum { LEVELS = 256, ONE = 65536 };

/* Linear light of each level of sRGB (IEC 61966-2-1), in 65535ths, rounded to the nearest. */
static const uint16_t linear_light[LEVELS] = {
    0,     20,    40,    60,    80,    99,    119,   139,   159,   179,   199,   219,   241,   264,   288,   313,
    340,   367,   396,   427,   458,   491,   526,   562,   599,   637,   677,   718,   761,   805,   851,   898,
    947,   997,   1048,  1101,  1156,  1212,  1270,  1330,  1391,  1453,  1517,  1583,  1651,  1720,  1790,  1863,
    1937,  2013,  2090,  2170,  2250,  2333,  2418,  2504,  2592,  2681,  2773,  2866,  2961,  3058,  3157,  3258,
    3360,  3464,  3570,  3678,  3788,  3900,  4014,  4129,  4247,  4366,  4488,  4611,  4736,  4864,  4993,  5124,
    5257,  5392,  5530,  5669,  5810,  5953,  6099,  6246,  6395,  6547,  6700,  6856,  7014,  7174,  7335,  7500,
    7666,  7834,  8004,  8177,  8352,  8528,  8708,  8889,  9072,  9258,  9445,  9635,  9828,  10022, 10219, 10417,
    10619, 10822, 11028, 11235, 11446, 11658, 11873, 12090, 12309, 12530, 12754, 12980, 13209, 13440, 13673, 13909,
    14146, 14387, 14629, 14874, 15122, 15371, 15623, 15878, 16135, 16394, 16656, 16920, 17187, 17456, 17727, 18001,
    18277, 18556, 18837, 19121, 19407, 19696, 19987, 20281, 20577, 20876, 21177, 21481, 21787, 22096, 22407, 22721,
    23038, 23357, 23678, 24002, 24329, 24658, 24990, 25325, 25662, 26001, 26344, 26688, 27036, 27386, 27739, 28094,
    28452, 28813, 29176, 29542, 29911, 30282, 30656, 31033, 31412, 31794, 32179, 32567, 32957, 33350, 33745, 34143,
    34544, 34948, 35355, 35764, 36176, 36591, 37008, 37429, 37852, 38278, 38706, 39138, 39572, 40009, 40449, 40891,
    41337, 41785, 42236, 42690, 43147, 43606, 44069, 44534, 45002, 45473, 45947, 46423, 46903, 47385, 47871, 48359,
    48850, 49344, 49841, 50341, 50844, 51349, 51858, 52369, 52884, 53401, 53921, 54445, 54971, 55500, 56032, 56567,
    57105, 57646, 58190, 58737, 59287, 59840, 60396, 60955, 61517, 62082, 62650, 63221, 63795, 64372, 64952, 65535
};

/* The amounts added to red, green and blue (rows), in 65536ths of red, green and blue (columns). */
static const int32_t channel_corrections[COLOUR_BLIND_MODES][3][3] = {
    [COLOUR_BLIND_PROTAN] = { [2] = { 27905, -32914, 5009 } },
    [COLOUR_BLIND_DEUTAN] = { [2] = { 21119, -29609, 8490 } },
    [COLOUR_BLIND_TRITAN] = { { -8528, -20140, 28668 }, { 155, 22655, -22810 } },
};

/* Returns the sRGB level nearest to a linear light; of two equally near levels, the darker. For a light out of range,
 * returns 0 or LEVELS - 1. */
static uint32_t level_of(int32_t light)
{
    int lo = 0, hi = LEVELS - 1;

    while (hi - lo > 1) { /* linear[lo] <= light < linear[hi], where it is in range */
        int middle = (lo + hi) / 2;
        *(light < linear_light[middle] ? &hi : &lo) = middle;
    }
    return (uint32_t)(light - linear_light[lo] > linear_light[hi] - light ? hi : lo);
}

static int64_t round_scaled(int64_t v)
{
    return (v < 0 ? v - ONE / 2 : v + ONE / 2) / ONE;
}

uint32_t view_adjust_colour(enum colour_blind_mode mode, uint32_t rgb)
{
    const int64_t light[3] = { linear_light[rgb >> 16 & 255], linear_light[rgb >> 8 & 255], linear_light[rgb & 255] };
    uint32_t out = 0;

    if (mode == COLOUR_BLIND_OFF)
        return rgb;
    for (int c = 0; c < 3; c++) {
        const int32_t *weight = channel_corrections[mode][c];
        int64_t correction = round_scaled(weight[0] * light[0] + weight[1] * light[1] + weight[2] * light[2]);
        out = out << 8 | level_of((int32_t)(light[c] + correction));
    }
    return out;
}
