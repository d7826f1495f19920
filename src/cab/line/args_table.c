/*
 * args_table.c - see args_parts.h: what there is on the command line, a row each.
 */
#include "args_parts.h"

#include "../demo/demo.h"
#include "../host/views.h"

const struct command_row args_commands[COMMANDS] = {
    [COMMAND_PLAY] = { "play", "[ROM]", 0, 1, "play a game: a folder or a .rom file; without one, the built-in game" },
    [COMMAND_RENDER] = { "render", "[ROM]", 0, 1,
                         "run without a window and write frames as DIR/000600.png; frame 0 is the board just powered "
                         "on" },
    [COMMAND_CAPTURE] = { "capture", "[ROM]", 0, 1,
                          "run without a window and write a film of it: GIF, animated PNG, y4m, WAV, or MP4 and WebM "
                          "through ffmpeg" },
    [COMMAND_HASH] = { "hash", "[ROM]", 0, 1, "run without a window and print the state hash of every frame: N HASH" },
    [COMMAND_VERIFY] = { "verify", "ROM DEMO...", 2, 1 << 20,
                         "replay demos and compare hashes; names the first frame and the parts that differ. For DEMO, "
                         "- reads names from standard input, a line each" },
    [COMMAND_TEST] = { "test", "DIR [NAME...]", 1, 1 << 20,
                       "run every demo of a game's demos/ and every script of its tests/, or those of these names, and "
                       "say which hold" },
    [COMMAND_PACK] = { "pack", "DIR", 1, 1, "make a .rom file of a game's folder" },
    [COMMAND_LIST] = { "list", "ROM", 1, 1, "print what is in a ROM" },
    [COMMAND_UNPACK] = { "unpack", "ROM DIR", 2, 2, "write every lump of a ROM as a file below DIR" },
    [COMMAND_NEW] = { "new", "DIR", 1, 1, "make a folder with a game to begin with: whole, and yours to change" },
    [COMMAND_EXPORT] = { "export", "ROM", 1, 1,
                         "make one file of a game that runs by itself, under its own name: this program and the game "
                         "in it" },
    [COMMAND_CHECK] = { "check", "DIR", 1, 1,
                        "look for mistakes in a game's folder: scripts, art, missing and unused files, Lua RAM" },
    [COMMAND_BENCH] = { "bench", "ROM", 1, 1,
                        "play the demos and sections of a game and print what its frames cost, its dearest lines of "
                        "Lua, and what of its capacities it uses" },
    [COMMAND_SURVIVE] = { "survive", "[ROM]", 0, 1,
                          "look for a run without a hit, by trying: writes a demo of it, or a picture of where no way "
                          "was found; and measure how hard it is" },
    [COMMAND_SOUND] = { "sound", "ROM [NAME]", 1, 2,
                        "list the sounds and the music of a game, how long and how loud they are; or measure, hear or "
                        "write one" },
    [COMMAND_ART] = { "art", "ROM", 1, 1,
                      "list the sprites of a game: size, bank, origin, frames and what hits; or show them all on one "
                      "picture" },
    [COMMAND_PALETTE] = { "palette", "FILE", 1, 1,
                          "put the colours of a .hex or .gpl into a bank of the palette -o; or a bank of a palette "
                          "into such a file" },
    [COMMAND_BULLETML] = { "bulletml", "FILE...", 1, 1 << 20,
                           "read BulletML documents and say what is in them and what is wrong; or print one as Lua" },
    [COMMAND_HELP] = { "help", "[COMMAND | config | lua [NAME | WORD]]", 0, 2,
                       "this; of a command; of the settings and their file; of the Lua API, and what has a word in "
                       "it" },
    [COMMAND_VERSION] = { "version", "", 0, 0,
                          "release, core version, Lua release, compiler and flags (also --version)" },
    [COMMAND_LICENCES] = { "licences", "", 0, 0, "whose work is in this program, and under which licence" },
};

/* Where a field of struct args stands; one of another type does not compile. */
#define FIELD(type, field) (offsetof(struct args, field) + 0 * _Generic(&((struct args *)0)->field, type * : 1))

#define SWITCH(field)                                                                                                  \
    {                                                                                                                  \
        .kind = KEEP_SWITCH, .at = FIELD(bool, field)                                                                  \
    }
#define TEXT(field)                                                                                                    \
    {                                                                                                                  \
        .kind = KEEP_TEXT, .at = FIELD(const char *, field)                                                            \
    }
#define WORD(field, list)                                                                                              \
    {                                                                                                                  \
        .kind = KEEP_WORD, .at = FIELD(int, field), .words = list                                                      \
    }
#define NUMBER(field, low, high)                                                                                       \
    {                                                                                                                  \
        .kind = KEEP_NUMBER, .at = offsetof(struct args, field), .size = sizeof((struct args *)0)->field,              \
        .least = low, .most = high                                                                                     \
    }
#define LIST(how, field, n)                                                                                            \
    {                                                                                                                  \
        .kind = how, .at = FIELD(const char *, field[0]), .count = FIELD(int, n),                                      \
        .most = sizeof((struct args *)0)->field / sizeof(char *)                                                       \
    }
#define SETTINGS(field, n) LIST(KEEP_SETTING, field, n)
#define NAMES(field, n)    LIST(KEEP_NAME, field, n)
#define READ(function)                                                                                                 \
    {                                                                                                                  \
        .kind = KEEP_READ, .read = function                                                                            \
    }

const struct option_row args_options[OPTIONS] = {
    [OPTION_RECORD] = { "--record", "F", FOR_RUN, TEXT(record), "record the run as demo F" },
    [OPTION_PRINTS] = { "--prints", "WORD", FOR_HEADLESS | FOR_VERIFY | FOR_SURVIVE, WORD(prints, demo_prints_words),
                        "of a demo that is written: checksums of every frame; of seconds, a tenth of the size; or "
                        "auto: of every frame up to a minute" },
    [OPTION_DEMO] = { "--demo", "F", FOR_RUN | FOR_BENCH, TEXT(demo), "play demo F; afterwards nothing is pressed" },
    [OPTION_SEED] = { "--seed", "N", FOR_START, NUMBER(seed, 0, UINT64_MAX),
                      "seed of the random streams, 0 to 2^64 - 1 (play: the clock's; else 0)" },
    [OPTION_DIP] = { "--dip", "NAME=VALUE", FOR_START, SETTINGS(dips, n_dips),
                     "set a DIP switch of the game; may be given several times" },
    [OPTION_STAGE] = { "--stage", "S", FOR_START, TEXT(stage),
                       "start at NAME, NAME:MARK or BOSS/PHASE; @SHIP behind it: with that ship" },
    [OPTION_LIVES] = { "--lives", "N", FOR_RUN, NUMBER(lives, 1, ARGS_MAX_LIVES),
                       "with --stage: so many lives in all, 1 to 99" },
    [OPTION_REGISTER] = { "--register", "NAME=VALUE", FOR_RUN | FOR_SURVIVE, SETTINGS(registers, n_registers),
                          "with --stage: a register of the ship starts so; may be given several times" },
    [OPTION_INVINCIBLE] = { "--invincible", NULL, FOR_RUN, SWITCH(invincible),
                            "with --stage: nothing hits the player" },
    [OPTION_DIFFICULTY] = { "--difficulty", "D", FOR_START, TEXT(difficulty), "start at this difficulty" },
    [OPTION_LANG] = { "--lang", "NAME", FOR_START, TEXT(lang), "start in this language of the game, lang/NAME.txt" },
    [OPTION_SCALE] = { "--scale", "N", FOR_PLAY | FOR_CAPTURE, NUMBER(scale, 1, ARGS_MAX_SCALE),
                       "pixels of the window, or of the film, a picture pixel, 1 to 16" },
    [OPTION_SPEED] = { "--speed", "N", FOR_CAPTURE, READ(args_speed),
                       "a film of 1 to 16 times the speed; or slower: 1/2 to 1/16" },
    [OPTION_FORMAT] = { "--format", "WORD", FOR_CAPTURE, TEXT(format),
                        "gif, apng, y4m, wav, mp4 or webm; without it the end of -o's name says it" },
    [OPTION_SLOWER] = { "--slower", "N", FOR_BENCH, NUMBER(machine, 1, ARGS_MAX_SLOWER),
                        "shares of a frame on a machine N times slower, 1 to 1000" },
    [OPTION_FULLSCREEN] = { "--fullscreen", NULL, FOR_PLAY, SWITCH(fullscreen), "fill the screen" },
    [OPTION_MUTE] = { "--mute", NULL, FOR_PLAY, SWITCH(mute), "no sound" },
    [OPTION_PRESS] = { "--press", "LIST", FOR_HEADLESS, READ(args_presses),
                       "buttons that player 1 holds: fire, or fire,focus, or bomb@200, left@60:90, fire@0:600:8 for "
                       "frames of the run; player 2: 2.fire" },
    [OPTION_FRAMES] = { "--frames", "LIST", FOR_HEADLESS | FOR_SURVIVE, READ(args_frames),
                        "render: 600, or 1,60,600, or 0:600:60 (both ends included); capture: 60:600 or 60-600; hash: "
                        "run N frames; with --trace, these frames; survive: so many at most, else 7200" },
    [OPTION_EVERY] = { "--every", "N", FOR_HASH, NUMBER(every, 1, ARGS_MAX_FRAME), "print every Nth frame only" },
    [OPTION_PARTS] = { "--parts", NULL, FOR_HASH, SWITCH(parts), "print the hash of each part as well" },
    [OPTION_TRACE] = { "--trace", "PARTS", FOR_HASH, NAMES(traces, n_traces),
                       "print all that these parts hold, a line a slot: bullets,player or all; may be given several "
                       "times" },
    [OPTION_DIM] = { "--dim", "WORD", FOR_VIEW, WORD(dim, views_dim),
                     "backgrounds darker: none, quarter, half, most (by three quarters)" },
    [OPTION_FLASHES] = { "--flashes", "WORD", FOR_VIEW, WORD(flashes, views_flashes),
                         "full, soft: flashes of the screen at a quarter" },
    [OPTION_COLOURS] = { "--colours", "WORD", FOR_VIEW, WORD(colours, views_colours),
                         "for eyes that tell fewer apart: normal, protan, deutan, tritan" },
    [OPTION_SHEET] = { "--sheet", "F.png", FOR_RENDER, TEXT(sheet),
                       "put all frames on one picture, each with its number" },
    [OPTION_WAV] = { "--wav", "F.wav", FOR_RENDER | FOR_SOUND, TEXT(wav),
                     "render: write the sound of all frames up to the last of --frames; sound: of NAME, as -o" },
    [OPTION_NOTES] = { "--notes", NULL, FOR_SOUND, SWITCH(notes),
                       "print the notes and settings of one, a line each (docs/measured/music.md)" },
    [OPTION_PLAY] = { "--play", NULL, FOR_SOUND, SWITCH(play),
                      "hear NAME, in a window that shows the mixer; Escape ends" },
    [OPTION_ATLAS] = { "--atlas", "F.png", FOR_ART, TEXT(atlas),
                       "all sprites, three times as large, with names, banks, origins and hit shapes" },
    [OPTION_BANK] = { "--bank", "N", FOR_PALETTE, NUMBER(bank, 0, 15), "the bank, 0 to 15" },
    [OPTION_OUT] = { "-o", "PATH", FOR_VIEW | FOR_PACK | FOR_EXPORT | FOR_SURVIVE | FOR_SOUND | FOR_PALETTE, TEXT(out),
                     "where to write: render: folder (else the current one); capture: the film, - is standard output; "
                     "pack: ROM file; export: the file; survive: demo, or with .png in place of its ending the "
                     "picture, with --all "
                     "their folder; sound: WAV file; palette: a palette (.png), or a bank of one (.gpl, .hex)" },
    [OPTION_MAP] = { "--map", "F.png", FOR_SURVIVE, TEXT(map), "draw where the ship could be, frame by frame" },
    [OPTION_ALL] = { "--all", NULL, FOR_SURVIVE, SWITCH(all),
                     "every stage and every phase of a boss at every difficulty, a line each, and what is harder where "
                     "it should be easier; with --stage or --difficulty, those of it" },
    [OPTION_EFFORT] = { "--effort", "N", FOR_SURVIVE, NUMBER(effort, 1, ARGS_MAX_EFFORT),
                        "plans to be made at most, in hundreds, 1 to 1000 (4)" },
    [OPTION_BOTS] = { "--bots", "N", FOR_SURVIVE, NUMBER(bots, 1, ARGS_MAX_BOTS),
                      "look for no way: let so many simple bots fly on when they are hit, and tell hits a minute; with "
                      "--all, stages from mark to mark" },
    [OPTION_RESUME] = { "--resume", NULL, FOR_PLAY, SWITCH(resume),
                        "go on with the run that was left, without asking" },
    [OPTION_NO_RESUME] = { "--no-resume", NULL, FOR_PLAY, SWITCH(no_resume),
                           "begin at the title without asking; a run that was left is kept until another begins" },
    [OPTION_NEAREST] = { "--nearest", NULL, FOR_GAMES, SWITCH(nearest),
                         "packing a folder: take the nearest colour of the bank for one that is not in it" },
    [OPTION_PLAIN] = { "--plain", NULL, FOR_PACK, SWITCH(plain),
                       "pack: do not compress, for machines that read the ROM where it is; it is the same game" },
    [OPTION_FROM] = { "--from", "NAME", FOR_NEW, TEXT(from),
                      "which game: shooter (ship, stage, boss, music; without --from), first (30 lines), pattern (a "
                      "place to try patterns), bulletml (a gallery of documents)" },
    [OPTION_BISECT] = { "--bisect", NULL, FOR_VERIFY, SWITCH(bisect),
                        "verify --bisect A B: compare what hash printed of two runs (--parts or --trace); names the "
                        "first frame, part, slot and column that differ. - is standard input" },
    [OPTION_RESTAMP] = { "--restamp", NULL, FOR_VERIFY, SWITCH(restamp),
                         "write demos that hold anew, in the newest format and as of this ROM" },
    [OPTION_RERECORD] = { "--rerecord", NULL, FOR_VERIFY, SWITCH(rerecord),
                          "play the pads of demos of another core version or build to their end and write them anew, "
                          "as of this one; says what became of prints, score, moments and length. Exit code 0: score, "
                          "moments and length are known to be the same; 1: not; 2: not written" },
    [OPTION_JSON] = { "--json", NULL, FOR_VERIFY | FOR_LIST | FOR_BENCH | FOR_SURVIVE, SWITCH(json),
                      "verify: print a JSON object a demo, on a line: verdict, score, ship, difficulty, flags, length, "
                      "moments, hashes (docs/reference/demo-format.md); list --replays: a JSON object a replay; "
                      "bench: one of all; "
                      "survive: one a section" },
    [OPTION_REPLAYS] = { "--replays", NULL, FOR_LIST, SWITCH(replays),
                         "print the runs of the game that are kept: file, date, length, ship, difficulty, points, "
                         "end" },
    [OPTION_NULL] = { "--null", NULL, FOR_VERIFY, SWITCH(null),
                      "verify ROM -: each name ends in a NUL byte (also -0)" },
    [OPTION_UPDATE] = { "--update", NULL, FOR_TEST, SWITCH(update),
                        "keep the pictures and hashes as they are now: tests/golden; look at the pictures first" },
    [OPTION_TAP] = { "--tap", NULL, FOR_TEST, SWITCH(tap),
                     "print TAP, the Test Anything Protocol, in place of lines for people" },
    [OPTION_JUNIT] = { "--junit", "FILE", FOR_TEST, TEXT(junit), "also write a JUnit file, which CI services read" },
    [OPTION_PAGE] = { "--page", "FILE", FOR_TEST, TEXT(page),
                      "write the page of what failed here, one HTML file with its pictures (else, if a test fails, "
                      "tests/failed/failed.html)" },
    [OPTION_JOBS] = { "--jobs", "N", FOR_TEST, NUMBER(jobs, 1, ARGS_MAX_JOBS),
                      "tests at a time, 1 to 64 (else as many as there are processors)" },
    [OPTION_ANNOTATIONS] = { "--annotations", NULL, FOR_HELP, SWITCH(annotations),
                             "help lua, help test: print the API as definitions for editors (LuaLS, the Lua language "
                             "server)" },
    [OPTION_LUACHECK] = { "--luacheck", NULL, FOR_HELP, SWITCH(luacheck),
                          "help lua: print the API's names as a .luacheckrc, the settings of luacheck" },
    [OPTION_KEYS] = { "--keys", NULL, FOR_EXPORT, SWITCH(keys),
                      "the program keeps the keys and commands of those who make games: rewind, steps, console, "
                      "panels; verify, render" },
    [OPTION_DESKTOP] = { "--desktop", NULL, FOR_EXPORT, SWITCH(desktop),
                         "also write FILE.desktop and FILE.png, an entry for the desktop's menu" },
    [OPTION_WEB] = { "--web", NULL, FOR_EXPORT, SWITCH(web),
                     "not a program: one HTML file that plays the game in browsers, ID.html" },
    [OPTION_LIBRETRO] = { "--libretro", NULL, FOR_EXPORT, SWITCH(libretro),
                          "not a program: a core for RetroArch and its like with the game in it, ID_libretro.so, and "
                          "beside it ID_libretro.info" },
    [OPTION_FULL] = { "--full", NULL, FOR_LICENCES, SWITCH(full), "also the texts of the licences, to be given along" },
    [OPTION_LUA] = { "--lua", NULL, FOR_BULLETML, SWITCH(lua),
                     "print the script that does the same with motion programs and tasks" },
    [OPTION_VERBOSE] = { "--verbose", NULL, FOR_RUN | FOR_VERIFY, SWITCH(verbose),
                         "also print the Lua traceback of a script fault; play: how late sound was; verify: hashes, "
                         "moment and buttons of a difference too (also -v, --traceback)" },
    [OPTION_HELP] = { "--help", NULL, FOR_ALL, { .kind = KEEP_NOTHING }, "help of the command (also -h)" },
    [OPTION_VERSION] = { "--version", NULL, FOR_ALL, { .kind = KEEP_NOTHING }, "what this program is" },
};
