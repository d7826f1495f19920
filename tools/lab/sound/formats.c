/*
 * formats.c - the page's last section: how sound lies in a ROM.
 */
#include "../../../src/sound/adpcm.h"
#include "ear.h"

void section_formats(void)
{
    report_section("Formats");
    report_text("In a ROM, `tune/NAME` and `sound/NAME` are tunes (`src/sound/tune.h`). A tune consists of a header, "
                "instruments of %d\n"
                "bytes (`src/sound/inst.h`), markers, waves and curves, and tracks of events. The audio data "
                "(`src/sound/adpcm.h`) of a sound\n"
                "follows its tune; the audio data of music is in `wave/NAME`. All tunes are validated when a ROM is "
                "opened. [The\n"
                "guide](../guide/25-sound.md) lists the audio files that can be used as samples.",
                (int)INST_BYTES);
    report_text("Music is part of the game hash because scripts can follow the beat. A demo recorded with different "
                "music therefore\n"
                "belongs to a different game. Sounds and samples are not part of the game hash. Cues and voices are "
                "not part of the\n"
                "board's hash.");
}
