/*
 * command_help.c - the commands `help` and `version` (command.h).
 */
#include "command.h"

#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "../board/board.h"
#include "../../platform/platform.h"
#include "settings/config.h"
#include "input/keys.h"
#include "../common/report.h"
#include "game/version.h"
#include "game/embedded_rom.h"

#ifndef CURTAIN_CFLAGS
#define CURTAIN_CFLAGS "unknown"
#endif

#ifdef __clang__
#define COMPILER __VERSION__ /* includes the name */
#elif defined(__GNUC__)
#define COMPILER "gcc " __VERSION__
#else
#define COMPILER "unknown"
#endif

static void print_line(const char *line)
{
    puts(line);
}

/* Prints only the options in the help for play. */
static void print_option(const char *line)
{
    if (strncmp(line, "  -", 3) == 0)
        print_line(line);
}

static void help_own(void)
{
    embedded_rom_help(print_line);
    args_help(COMMAND_PLAY, true, print_option);
}

static enum result help_unknown(const char *topic)
{
    const char *meant = args_near_command(topic);

    if (meant)
        return report_line(RESULT_REFUSED, "help: unknown command \"%s\" (did you mean %s?)", topic, meant);
    return report_line(RESULT_REFUSED, "help: unknown command \"%s\" (see curtain help)", topic);
}

static void help_controls(void)
{
    print_line("");
    print_line("Keys and buttons, by the names to use in key bindings:");
    keys_print_help(embedded_rom_sealed() ? KEYS_FOR_AUTHORS : 0, print_line);
    print_line("");
    print_line("Controllers: player 1 gets the first one used; press START on another one to join as player 2.");
    print_line("pad. is the player's own controller; pad1. to pad4. are specific controllers.");
    print_line("south is the bottom face button and east is the right one, whatever is printed on them.");
    print_line("");
    print_line("Settings:");
    config_help(print_line);
}

/* command: -1 for all commands. */
static enum result help_command(int command, bool is_player)
{
    if (embedded_rom_sealed())
        help_own();
    else
        args_help(command, is_player, print_line);
    if (command == COMMAND_PLAY || embedded_rom_sealed())
        help_controls();
    return report_stdout(RESULT_DONE);
}

enum result command_help(const struct args *a)
{
    const char *topic = a->n_words ? a->words[0] : NULL;
    const int command = topic ? args_command(topic) : -1;
    const bool config = topic && strcmp(topic, "config") == 0;

    if (topic && command < 0 && !config)
        return help_unknown(topic);
    if (a->n_words > 1)
        return report_line(RESULT_REFUSED, "help: unexpected argument \"%s\"", a->words[1]);
    if (!config)
        return help_command(command, !a->workbench);
    config_guide(print_line);
    return report_stdout(RESULT_DONE);
}

static const char *byte_order(void)
{
    const uint16_t one = 1;

    return *(const uint8_t *)&one ? "little" : "big";
}

enum result command_version(void)
{
    char platform[192];

    if (embedded_rom_game()->rom)
        report_print("%s %d (%s)\n", embedded_rom_game()->m.title, (int)embedded_rom_game()->m.version,
                     embedded_rom_game()->m.id);
    report_print("curtain %s (core %d, Lua %s)\n", CURTAIN_VERSION, CORE_VERSION, board_lua_release());
    report_print("compiler %s\n", COMPILER);
    report_print("flags %s\n", CURTAIN_CFLAGS);
    report_print("machine %d-bit %s-endian\n", (int)sizeof(void *) * 8, byte_order());
    plat_describe_build(platform, sizeof platform);
    platform[strcspn(platform, ",")] = '\0';
    report_print("platform %s\n", platform);
    return report_stdout(RESULT_DONE);
}
