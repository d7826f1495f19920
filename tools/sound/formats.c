/*
 * formats.c - the page's last section: how sound lies in a ROM.
 * floor: tools
 */
#include "../../src/snd/adpcm.h"
#include "ear.h"

void section_formats(void)
{
    report_section("Formats");
    report_text(
        "In a ROM `music/NAME` and `sound/NAME` are tunes (`src/snd/tune.h`): a header, instruments of %d bytes\n"
        "(`src/snd/inst.h`), markers, waves and curves, tracks of events, and behind a recording's tune its sample as\n"
        "IMA ADPCM in blocks of %d samples (`src/snd/adpcm.h`). A ROM's tunes are checked whole when it is opened.",
        (int)INST_BYTES, (int)ADPCM_SAMPLES);
    report_text(
        "WAV files: PCM of 8, 16, 24 or 32 bits, one channel or two, which become one, 4,000 to 48,000 frames a\n"
        "second, kept at their own rate. The first loop of the chunk `smpl` is kept.");
    report_text(
        "A piece of music is in the game hash: a demo of other music is another game's, for scripts follow the beat.\n"
        "Sounds and their recordings are not, and neither are cues and voices in the board's hash.");
}
