/*
 * args_table.c - the tables of commands and options (args_parts.h).
 */
#include "args_parts.h"

#include "../../demo/demo.h"
#include "../settings/views.h"

const struct command_row args_commands[COMMANDS] = {
    [COMMAND_PLAY] = { "play", "[ROM]", 0, 1,
                       "play a game, from a folder or a .rom file, or a demo; without a ROM, the built-in game" },
    [COMMAND_RENDER] = { "render", "[ROM]", 0, 1,
                         "run without a window and write frames as DIR/000600.png; frame 0 is the board at power-on" },
    [COMMAND_CAPTURE] = { "capture", "[ROM]", 0, 1,
                          "run without a window and write a clip: GIF, y4m, WAV, or MP4 and WebM with "
                          "ffmpeg" },
    [COMMAND_HASH] = { "hash", "[ROM]", 0, 1, "run without a window and print the state hash of every frame: N HASH" },
    [COMMAND_VERIFY] = { "verify", "ROM DEMO...", 2, 1 << 20,
                         "replay demos and compare hashes; report the first frame and the parts that differ. If DEMO "
                         "is -, read names from standard input, one per line" },
    [COMMAND_TEST] = { "test", "DIR [NAME...]", 1, 1 << 20,
                       "run a game's demos in demos/ and scripts in tests/, or only the named ones, and report which "
                       "pass" },
    [COMMAND_PACK] = { "pack", "DIR", 1, 1, "make a .rom file from a game's folder" },
    [COMMAND_LIST] = { "list", "ROM", 1, 1, "list the contents of a ROM" },
    [COMMAND_UNPACK] = { "unpack", "ROM DIR", 2, 2, "write every lump of a ROM to a file in DIR" },
    [COMMAND_NEW] = { "new", "DIR", 1, 1, "create a folder with a complete game that you can change" },
    [COMMAND_EXPORT] = { "export", "ROM", 1, 1,
                         "turn a game into a standalone program for this system; options choose another system, a web "
                         "page or a RetroArch core" },
    [COMMAND_REGISTER] = { "register", "", 0, 0,
                           "open .rom files and replays with this program when you double-click them" },
    [COMMAND_CHECK] = { "check", "DIR", 1, 1,
                        "find mistakes in a game's folder: scripts, art, missing and unused files, Lua memory" },
    [COMMAND_BENCH] = { "bench", "ROM", 1, 1,
                        "play a game's demos and sections and print the cost of its frames, its most expensive lines "
                        "of Lua, and how much of each capacity it uses" },
    [COMMAND_SURVIVE] = { "survive", "[ROM]", 0, 1,
                          "search for a run without a hit and write it as a demo, or write a picture of where the "
                          "search failed; measure the difficulty" },
    [COMMAND_SOUND] = { "sound", "ROM [NAME]", 1, 2,
                        "list a game's sounds and music with their lengths and loudness; or measure, play or write one "
                        "of them" },
    [COMMAND_ART] = { "art", "ROM", 1, 1,
                      "list a game's sprites: size, bank, origin, frames and hitboxes; or draw them all in one "
                      "picture" },
    [COMMAND_PALETTE] = { "palette", "FILE", 1, 1,
                          "copy the colours of a .hex or .gpl file into a bank of the palette that -o names; or export "
                          "a bank to a .hex or .gpl file" },
    [COMMAND_BULLETML] = { "bulletml", "FILE...", 1, 1 << 20,
                           "check BulletML documents and describe them; or convert one to Lua" },
    [COMMAND_HELP] = { "help", "[COMMAND | config | lang | lua [NAME]]", 0, 2,
                       "print this help; or help for a command, for the settings and their file, the text of the "
                       "program's screens "
                       "as lines of a language file, help for the Lua API, or "
                       "for the API names that contain a word" },
    [COMMAND_VERSION] = { "version", "", 0, 0,
                          "print release, core version, Lua release, compiler and flags (also --version)" },
    [COMMAND_LICENCES] = { "licences", "", 0, 0, "print the authors and licences of the software in this program" },
};

/* The offset of a field of struct args; a field of another type doesn't compile. */
#define FIELD(type, field) (offsetof(struct args, field) + 0 * _Generic(&((struct args *)0)->field, type * : 1))

#define SWITCH(field)                                                                                                  \
    {                                                                                                                  \
        .kind = STORE_SWITCH, .at = FIELD(bool, field)                                                                 \
    }
#define CHOICE(field, value)                                                                                           \
    {                                                                                                                  \
        .kind = STORE_CHOICE, .at = FIELD(int, field), .min = value                                                    \
    }
#define TEXT(field)                                                                                                    \
    {                                                                                                                  \
        .kind = STORE_TEXT, .at = FIELD(const char *, field)                                                           \
    }
#define WORD(field, list)                                                                                              \
    {                                                                                                                  \
        .kind = STORE_WORD, .at = FIELD(int, field), .words = list                                                     \
    }
#define NUMBER(field, low, high)                                                                                       \
    {                                                                                                                  \
        .kind = STORE_NUMBER, .at = offsetof(struct args, field), .size = sizeof((struct args *)0)->field, .min = low, \
        .max = high                                                                                                    \
    }
#define LIST(how, field, n)                                                                                            \
    {                                                                                                                  \
        .kind = how, .at = FIELD(const char *, field[0]), .count = FIELD(int, n),                                      \
        .max = sizeof((struct args *)0)->field / sizeof(char *)                                                        \
    }
#define SETTINGS(field, n) LIST(STORE_SETTING, field, n)
#define NAMES(field, n)    LIST(STORE_NAME, field, n)
#define READ(function)                                                                                                 \
    {                                                                                                                  \
        .kind = STORE_READ, .read = function                                                                           \
    }

const struct option_row args_options[OPTIONS] = {
    [OPTION_RECORD] = { "--record", "F", FOR_RUN, TEXT(record), "record the run as demo F" },
    [OPTION_PRINTS] = { "--prints", "WORD", FOR_HEADLESS | FOR_VERIFY | FOR_SURVIVE,
                        WORD(prints, demo_checksum_rate_names),
                        "checksums in the demo: every (one per frame), seconds (one per second; a much smaller file), "
                        "or auto (\"every\" for demos of up to a minute, \"seconds\" for longer ones)" },
    [OPTION_DEMO] = { "--demo", "F", FOR_RUN | FOR_BENCH, TEXT(demo),
                      "play demo F; no buttons are held after its end" },
    [OPTION_SEED] = { "--seed", "N", FOR_START, NUMBER(seed, 0, UINT64_MAX),
                      "seed of the random streams, 0 to 2^64 - 1 (default: taken from the clock for play, otherwise "
                      "0)" },
    [OPTION_DIP] = { "--dip", "NAME=VALUE", FOR_START, SETTINGS(dips, n_dips),
                     "set one of the game's DIP switches; repeatable" },
    [OPTION_STAGE] = { "--stage", "S", FOR_START, TEXT(stage),
                       "start at NAME, NAME:MARK or BOSS/PHASE; append @SHIP to choose the ship" },
    [OPTION_LIVES] = { "--lives", "N", FOR_RUN, NUMBER(lives, 1, ARGS_MAX_LIVES),
                       "with --stage: number of lives, 1 to 99" },
    [OPTION_REGISTER] = { "--register", "NAME=VALUE", FOR_RUN | FOR_SURVIVE, SETTINGS(registers, n_registers),
                          "with --stage: starting value of one of the ship's registers; repeatable" },
    [OPTION_INVINCIBLE] = { "--invincible", NULL, FOR_RUN, SWITCH(invincible),
                            "with --stage: the player cannot be hit" },
    [OPTION_DIFFICULTY] = { "--difficulty", "D", FOR_START, TEXT(difficulty), "starting difficulty" },
    [OPTION_LANG] = { "--lang", "NAME", FOR_START, TEXT(lang), "the game's language, from lang/NAME.txt" },
    [OPTION_LARGE_HUD] = { "--large-hud", NULL, FOR_START, SWITCH(large_hud),
                           "show scores, lives and bombs in larger letters" },
    [OPTION_SCALE] = { "--scale", "N", FOR_PLAY | FOR_CAPTURE, NUMBER(scale, 1, ARGS_MAX_SCALE),
                       "screen or clip pixels per game pixel, 1 to 16" },
    [OPTION_SPEED] = { "--speed", "N", FOR_CAPTURE, READ(args_speed),
                       "clip speed: 1 to 16, or 1/2 to 1/16 for slow motion" },
    [OPTION_FORMAT] = { "--format", "WORD", FOR_CAPTURE, TEXT(format),
                        "gif, y4m, wav, mp4 or webm (default: from the file extension of -o)" },
    [OPTION_SLOWER] = { "--slower", "N", FOR_BENCH, NUMBER(machine, 1, ARGS_MAX_SLOWER),
                        "show times for a machine N times slower, 1 to 1000" },
    [OPTION_FULLSCREEN] = { "--fullscreen", NULL, FOR_PLAY, SWITCH(fullscreen), "fill the screen" },
    [OPTION_MUTE] = { "--mute", NULL, FOR_PLAY, SWITCH(mute), "turn sound off" },
    [OPTION_DIALOG] = { "--dialog", NULL, FOR_PLAY, SWITCH(dialog),
                        "also show errors in a window, for programs started without a terminal" },
    [OPTION_PRESS] = { "--press", "LIST", FOR_HEADLESS, READ(args_presses),
                       "buttons that player 1 holds, e.g. fire or fire,focus; to hold them only in some frames: "
                       "bomb@200, "
                       "left@60:90 or fire@0:600:8; for player 2: 2.fire" },
    [OPTION_FRAMES] = { "--frames", "LIST", FOR_HEADLESS | FOR_SURVIVE, READ(args_frames),
                        "render: frames to write, e.g. 600, or 1,60,600, or 0:600:60 (both ends included); capture: a "
                        "range, e.g. 60:600 or 60-600; hash: N, the number of frames to run, or, with --trace, the "
                        "frames to print; survive: N, the maximum number of frames to search (default 7200)" },
    [OPTION_EVERY] = { "--every", "N", FOR_HASH, NUMBER(every, 1, ARGS_MAX_FRAME), "print only every Nth frame" },
    [OPTION_PARTS] = { "--parts", NULL, FOR_HASH, SWITCH(parts), "also print the hash of each part" },
    [OPTION_TRACE] = { "--trace", "PARTS", FOR_HASH, NAMES(traces, n_traces),
                       "print the contents of these parts, one line per slot; PARTS is a list such as "
                       "bullets,player, or the word all; repeatable" },
    [OPTION_DIM] = { "--dim", "WORD", FOR_VIEW, WORD(dim, views_dim),
                     "darken backgrounds: none, quarter, half, most (three quarters)" },
    [OPTION_FLASHES] = { "--flashes", "WORD", FOR_VIEW, WORD(flashes, views_flashes),
                         "full, or soft: flashes at quarter strength" },
    [OPTION_COLOURS] = { "--colours", "WORD", FOR_VIEW, WORD(colours, views_colours),
                         "colour-blind mode: normal, protan, deutan, tritan" },
    [OPTION_SHEET] = { "--sheet", "F.png", FOR_RENDER, TEXT(sheet),
                       "put all frames in one picture, each with its number" },
    [OPTION_WAV] = { "--wav", "F.wav", FOR_RENDER | FOR_SOUND, TEXT(wav),
                     "render: write the sound of all frames up to the last one in --frames; sound: same as -o" },
    [OPTION_NOTES] = { "--notes", NULL, FOR_SOUND, SWITCH(notes),
                       "print the notes and settings of NAME, one per line (docs/measured/music.md)" },
    [OPTION_PLAY] = { "--play", NULL, FOR_SOUND, SWITCH(play),
                      "play NAME in a window that shows the mixer; Escape quits" },
    [OPTION_ATLAS] = { "--atlas", "F.png", FOR_ART, TEXT(atlas),
                       "draw all sprites at three times their size, with names, banks, origins and hitboxes" },
    [OPTION_BANK] = { "--bank", "N", FOR_PALETTE, NUMBER(bank, 0, 15), "bank in the palette, 0 to 15" },
    [OPTION_OUT] = { "-o", "PATH", FOR_VIEW | FOR_PACK | FOR_EXPORT | FOR_SURVIVE | FOR_SOUND | FOR_PALETTE, TEXT(out),
                     "output. render: folder (default: the current one); capture: clip, or - for standard output; "
                     "pack: ROM file; export: file, or, with --all, folder; survive: demo (the picture gets the "
                     "extension .png), or, with "
                     "--all, a folder for both; sound: WAV file; palette: a palette (.png) or one bank (.gpl, .hex)" },
    [OPTION_MAP] = { "--map", "F.png", FOR_SURVIVE, TEXT(map), "draw where the ship can be, frame by frame" },
    [OPTION_ALL] = { "--all", NULL, FOR_SURVIVE | FOR_EXPORT, SWITCH(all),
                     "export: write a zip file for each of --linux, --windows, --web and --libretro to the folder "
                     "ID-exports, each with the licences and a README for players; survive: search every stage and "
                     "boss phase at every difficulty (or those that --stage and --difficulty choose), print a line for "
                     "each, and report those that are harder at a lower difficulty" },
    [OPTION_EFFORT] = { "--effort", "N", FOR_SURVIVE, NUMBER(effort, 1, ARGS_MAX_EFFORT),
                        "maximum number of plans, in hundreds, 1 to 1000 (default 4)" },
    [OPTION_BOTS] = { "--bots", "N", FOR_SURVIVE, NUMBER(bots, 1, ARGS_MAX_BOTS),
                      "instead of searching, run N simple bots that continue after each hit, and report hits per "
                      "minute; with --all, split stages at their marks" },
    [OPTION_RESUME] = { "--resume", NULL, FOR_PLAY, SWITCH(resume), "resume the unfinished run without asking" },
    [OPTION_NO_RESUME] = { "--no-resume", NULL, FOR_PLAY, SWITCH(no_resume),
                           "start at the title without asking; the unfinished run stays saved until you start "
                           "another" },
    [OPTION_NEAREST] = { "--nearest", NULL, FOR_GAMES, SWITCH(nearest),
                         "when packing a folder: replace each colour that is not in the bank with the bank's nearest "
                         "colour" },
    [OPTION_PLAIN] = { "--plain", NULL, FOR_PACK, SWITCH(plain),
                       "do not compress, for machines that read the ROM in place; the game is the same" },
    [OPTION_FROM] = { "--from", "NAME", FOR_NEW, TEXT(from),
                      "the game to start from: shooter (ship, stage, boss, music; the default), first (30 lines), "
                      "pattern (to try patterns), bulletml (a gallery of documents)" },
    [OPTION_BISECT] = { "--bisect", NULL, FOR_VERIFY, SWITCH(bisect),
                        "verify --bisect A B: compare what hash --parts or --trace printed for two runs, and report "
                        "the first frame, part, slot and column that differ. Write - for standard input" },
    [OPTION_RESTAMP] = { "--restamp", NULL, FOR_VERIFY, SWITCH(restamp),
                         "rewrite passing demos in the newest format, for this ROM" },
    [OPTION_RERECORD] = { "--rerecord", NULL, FOR_VERIFY, SWITCH(rerecord),
                          "for demos from a different core version or build: replay their buttons to the end and "
                          "rewrite them for this build; report changes in checksums, score, markers and length. Exit "
                          "code 0: score, markers and length are known to be unchanged; 1: they changed or are "
                          "unknown; 2: nothing was written" },
    [OPTION_JSON] = { "--json", NULL, FOR_VERIFY | FOR_LIST | FOR_BENCH | FOR_SURVIVE, SWITCH(json),
                      "print JSON. verify: one object per demo, one per line: verdict, score, ship, difficulty, flags, "
                      "length, moments, hashes (docs/reference/demo-format.md); list --replays: one object per replay; "
                      "bench: one object; survive: one object per section" },
    [OPTION_REPLAYS] = { "--replays", NULL, FOR_LIST, SWITCH(replays),
                         "print the game's saved runs: file, date, length, ship, difficulty, points, how they ended" },
    [OPTION_NULL] = { "--null", NULL, FOR_VERIFY, SWITCH(null),
                      "verify ROM -: each name on standard input ends in a NUL byte (also -0)" },
    [OPTION_UPDATE] = { "--update", NULL, FOR_TEST, SWITCH(update),
                        "save the current pictures and hashes in tests/golden; check the pictures first" },
    [OPTION_TAP] = { "--tap", NULL, FOR_TEST, SWITCH(tap),
                     "print TAP, the Test Anything Protocol, instead of plain text" },
    [OPTION_JUNIT] = { "--junit", "FILE", FOR_TEST, TEXT(junit), "also write a JUnit file for CI services" },
    [OPTION_JOBS] = { "--jobs", "N", FOR_TEST, NUMBER(jobs, 1, ARGS_MAX_JOBS),
                      "tests to run at the same time, 1 to 64 (default: the number of processors)" },
    [OPTION_ANNOTATIONS] = { "--annotations", NULL, FOR_HELP, SWITCH(annotations),
                             "help lua, help test: print the API as definitions for the Lua language server (LuaLS)" },
    [OPTION_LUACHECK] = { "--luacheck", NULL, FOR_HELP, SWITCH(luacheck),
                          "help lua: print the API's names as a .luacheckrc, the settings file of luacheck" },
    [OPTION_KEYS] = { "--keys", NULL, FOR_EXPORT, SWITCH(keys),
                      "include the developer keys (rewind, frame advance, console, panels) and the developer commands "
                      "(such as verify and render)" },
    [OPTION_DESKTOP] = { "--desktop", NULL, FOR_EXPORT, SWITCH(desktop),
                         "also write a desktop menu entry, FILE.desktop, and its icon, FILE.png" },
    [OPTION_LINUX] = { "--linux", NULL, FOR_EXPORT, CHOICE(export, EXPORT_LINUX),
                       "write ID, a program for x86-64 Linux" },
    [OPTION_WINDOWS] = { "--windows", NULL, FOR_EXPORT, CHOICE(export, EXPORT_WINDOWS),
                         "write ID.exe, a program for 64-bit Windows" },
    [OPTION_WEB] = { "--web", NULL, FOR_EXPORT, CHOICE(export, EXPORT_WEB),
                     "write ID.html, a page that plays the game in a browser" },
    [OPTION_LIBRETRO] = { "--libretro", NULL, FOR_EXPORT, CHOICE(export, EXPORT_LIBRETRO),
                          "write ID_libretro.so, a core for RetroArch and other libretro front ends, and "
                          "ID_libretro.info, its description" },
    [OPTION_FULL] = { "--full", NULL, FOR_LICENCES, SWITCH(full),
                      "also print the licence texts, which must accompany the program" },
    [OPTION_LUA] = { "--lua", NULL, FOR_BULLETML, SWITCH(lua),
                     "print an equivalent Lua script with motion programs and tasks" },
    [OPTION_REMOVE] = { "--remove", NULL, FOR_REGISTER, SWITCH(remove),
                        "undo: remove what curtain register has set up" },
    [OPTION_VERBOSE] = { "--verbose", NULL, FOR_RUN | FOR_VERIFY, SWITCH(verbose),
                         "also print the Lua traceback of a script error; play: also print sound latency; verify: also "
                         "print where in the game a demo differs, the hashes there, and the buttons held (also -v, "
                         "--traceback)" },
    [OPTION_HELP] = { "--help", NULL, FOR_ALL, { .kind = STORE_NOTHING }, "print help for the command (also -h)" },
    [OPTION_VERSION] = { "--version", NULL, FOR_ALL, { .kind = STORE_NOTHING }, "print the version and build" },
};
