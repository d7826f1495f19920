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
        "In a ROM, `tune/NAME` and `sound/NAME` are tunes (`src/snd/tune.h`): a header, instruments of %d bytes\n"
        "(`src/snd/inst.h`), markers, waves and curves, and tracks of events. The audio data (`src/snd/adpcm.h`) of a "
        "sound\n"
        "follows its tune; the audio data of music is in `wave/NAME`. All tunes are validated when a ROM is opened. "
        "[The\n"
        "guide](../guide/25-sound.md) lists the files that become samples.",
        (int)INST_BYTES);
    report_text(
        "Music is part of the game hash, because scripts follow the beat: a demo recorded with different music belongs "
        "to a\n"
        "different game. Sounds and samples are not part of it. Cues and voices are not part of the board's hash.");
}
