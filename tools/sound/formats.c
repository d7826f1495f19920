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
        "In a ROM `tune/NAME` and `sound/NAME` are tunes (`src/snd/tune.h`): a header, instruments of %d bytes\n"
        "(`src/snd/inst.h`), markers, waves and curves, tracks of events, and behind a recording's tune its\n"
        "samples (`src/snd/adpcm.h`), those of music in `wave/NAME`. A ROM's tunes are checked whole when it is\n"
        "opened; [the guide](../guide/25-sound.md) says which files become samples.",
        (int)INST_BYTES);
    report_text(
        "A piece of music is in the game hash: a demo of other music is another game's, for scripts follow the\n"
        "beat. Sounds and recordings are not, and neither are cues and voices in the board's hash.");
}
