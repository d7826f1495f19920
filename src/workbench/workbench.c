/*
 * workbench.c - the program curtain: the player and the workbench.
 */
#include "../player/game/workbench.h"

#include <stdio.h>
#include <string.h>
#include "../../platform/platform.h"
#include "../common/report.h"
#include "../player/cli.h"
#include "../player/command.h"
#include "../player/game/embedded_rom.h"
#include "art/art_run.h"
#include "bench/bench.h"
#include "bulletml/command.h"
#include "capture/capture.h"
#include "check/check.h"
#include "export/export.h"
#include "help/help.h"
#include "new/new.h"
#include "../common/library.h"
#include "pack/pack.h"
#include "pack/pack_commands.h"
#include "register/register.h"
#include "render/headless.h"
#include "sound/sound_command.h"
#include "survive/survive.h"
#include "test/testing.h"
#include "verify/bisect.h"

/* Also names the libraries that packing opens; an exported game packs nothing. */
static enum result version(void)
{
    char text[192];
    const enum result result = command_version();

    for (enum library l = 0; l < LIBRARIES && !embedded_rom_sealed(); l++) {
        library_about(l, text, sizeof text);
        puts(text);
    }
    return result == RESULT_DONE ? report_stdout(result) : result;
}

static bool run(const struct args *a, struct frame_command *running, enum result *result)
{
    switch (a->command) {
    case COMMAND_RENDER:
        *result = headless_render(a);
        break;
    case COMMAND_CAPTURE:
        *result = capture_run(a);
        break;
    case COMMAND_HASH:
        *result = headless_hash(a);
        break;
    case COMMAND_TEST:
        *result = testing_command(a);
        break;
    case COMMAND_PACK:
        *result = pack_command(a);
        break;
    case COMMAND_LIST:
        *result = pack_command_list(a);
        break;
    case COMMAND_UNPACK:
        *result = pack_command_unpack(a);
        break;
    case COMMAND_NEW:
        *result = new_game(a->words[0], a->from);
        break;
    case COMMAND_EXPORT:
        *result = export_command(a);
        break;
    case COMMAND_REGISTER:
        *result = register_command(a->remove);
        break;
    case COMMAND_CHECK:
        *result = check_game(a->words[0], a->nearest);
        break;
    case COMMAND_BENCH:
        *result = bench_command(a);
        break;
    case COMMAND_SURVIVE:
        *result = survive_command(a);
        break;
    case COMMAND_SOUND:
        *result = sound_command(a, running);
        break;
    case COMMAND_ART:
        *result = art_run(a->words[0], a->nearest, a->atlas);
        break;
    case COMMAND_PALETTE:
        *result = art_run_palette(a->words[0], a->bank, a->out);
        break;
    case COMMAND_BULLETML:
        *result = bulletml_command(a->words, a->n_words, a->lua);
        break;
    case COMMAND_HELP:
        *result = help_command(a);
        break;
    case COMMAND_VERSION:
        *result = version();
        break;
    case COMMAND_VERIFY:
        if (!a->bisect)
            return false;
        *result = bisect_command(a);
        break;
    default:
        return false;
    }
    return true;
}

static const struct workbench workbench = { run, pack_load_game };

struct program *program_open(int argc, char **argv)
{
    return cli_open(argc, argv, &workbench);
}
