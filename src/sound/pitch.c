/*
 * pitch.c - see pitch.h. A power of two is a product with one factor each for the semitones, the 16ths of a semitone,
 * the 256ths of a semitone, and the remainder, which is so small that a linear approximation is enough. A test checks
 * the results against exp2l.
 */
#include "pitch.h"

#include "../base/fx.h"
#include "../base/int.h"

/* 2^(i / 12), 2^(i / 192), 2^(i / 3072) in Q63. */
static const uint64_t semitone_factors[12] = { 9223372036854775808u,  9771822278593156702u,  10352885068807405238u,
                                               10968499650544839023u, 11620720580245083921u, 12311724584631201765u,
                                               13043817825332782212u, 13819443595486002999u, 14641190473997345814u,
                                               15511800964685064948u, 16434180649130740277u, 17411407883787705789u };
static const uint64_t sixteenth_factors[16] = { 9223372036854775808u, 9256729892679504545u, 9290208392726408976u,
                                                9323807973325342579u, 9357529072384218170u, 9391372129394715211u,
                                                9425337585438007767u, 9459425883190513181u, 9493637466929661531u,
                                                9527972782539685958u, 9562432277517433942u, 9597016400978199581u,
                                                9631725603661576981u, 9666560337937334797u, 9701521057811312039u,
                                                9736608218931335184u };
static const uint64_t fine_factors[16] = { 9223372036854775808u, 9225453376579012720u, 9227535185976925418u,
                                           9229617465154500136u, 9231700214217747027u, 9233783433272700166u,
                                           9235867122425417553u, 9237951281781981124u, 9240035911448496752u,
                                           9242121011531094253u, 9244206582135927395u, 9246292623369173897u,
                                           9248379135337035441u, 9250466118145737672u, 9252553571901530207u,
                                           9254641496710686640u };
static const uint64_t ln2_per_unit = 16258632208764u;       /* ln 2 / (12 * 65536), Q64 */
static const uint64_t note_120_step = 3217426564159819447u; /* step of note 120, 8372 Hz, in 2^-64 turns per sample */
static const uint32_t exp2_neg_16ths[16] = { 1073741824, 1028218693, 984625594, 942880699, 902905651, 864625413,
                                             827968132,  792865000,  759250125, 727060411, 696235434, 666717336,
                                             638450708,  611382493,  585461881, 560640218 };
static const uint32_t exp2_neg_256ths[16] = { 1073741824, 1070838486, 1067942999, 1065055341, 1062175491, 1059303428,
                                              1056439131, 1053582579, 1050733751, 1047892626, 1045059183, 1042233401,
                                              1039415261, 1036604740, 1033801819, 1031006477 };
static const uint64_t ln2 = 2977044472u; /* Q32 */

enum { OCTAVE = 12 * PITCH_ONE };

/* Returns 2^(r / OCTAVE) in Q63, for 0 <= r < OCTAVE. */
static uint64_t exp2_octave_fraction(uint32_t r)
{
    uint64_t v = semitone_factors[r >> 16];

    v = fx_mul_high(v, sixteenth_factors[r >> 12 & 15]) << 1;
    v = fx_mul_high(v, fine_factors[r >> 8 & 15]) << 1;
    return v + fx_mul_high(v, (r & 255) * ln2_per_unit);
}

uint64_t pitch_step(int32_t pitch)
{
    const uint32_t p = (uint32_t)int_clamp(pitch, 0, PITCH_MAX);

    return fx_mul_high(exp2_octave_fraction(p % OCTAVE), note_120_step) << 1 >> (10 - p / OCTAVE) >> 8;
}

uint64_t pitch_ratio(int32_t pitch)
{
    const uint32_t p = (uint32_t)(int_clamp(pitch, -8 * OCTAVE, 4 * OCTAVE) + 8 * OCTAVE);

    return exp2_octave_fraction(p % OCTAVE) >> (39 - p / OCTAVE);
}

uint32_t pitch_exp2_neg(uint64_t x)
{
    const uint32_t whole = (uint32_t)(x >> 32), part = (uint32_t)x;
    uint64_t v;

    if (x >> 32 >= 30)
        return 0;
    v = (uint64_t)exp2_neg_16ths[part >> 28] * exp2_neg_256ths[part >> 24 & 15] >> 30;
    v -= v * ((part & 0xffffff) * ln2 >> 32) >> 32;
    return (uint32_t)(v >> whole);
}
