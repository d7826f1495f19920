/*
 * args.c - see args.h.
 *
 * An option has the same shape with every command, so options may stand before the command; which go with it is looked
 * at when all is read.
 */
#include "args.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "../base/err.h"
#include "../base/int.h"
#include "../base/pads.h"
#include "host/views.h"

enum {
    FOR_PLAY = 1 << COMMAND_PLAY,
    FOR_RENDER = 1 << COMMAND_RENDER,
    FOR_CAPTURE = 1 << COMMAND_CAPTURE,
    FOR_VIEW = FOR_RENDER | FOR_CAPTURE,
    FOR_HASH = 1 << COMMAND_HASH,
    FOR_VERIFY = 1 << COMMAND_VERIFY,
    FOR_TEST = 1 << COMMAND_TEST,
    FOR_PACK = 1 << COMMAND_PACK,
    FOR_LIST = 1 << COMMAND_LIST,
    FOR_EXPORT = 1 << COMMAND_EXPORT,
    FOR_ROM = FOR_PACK | FOR_LIST | 1 << COMMAND_UNPACK | FOR_EXPORT,
    FOR_HEADLESS = FOR_VIEW | FOR_HASH,
    FOR_RUN = FOR_PLAY | FOR_HEADLESS,
    FOR_NEW = 1 << COMMAND_NEW,
    FOR_CHECK = 1 << COMMAND_CHECK,
    FOR_BENCH = 1 << COMMAND_BENCH,
    FOR_SURVIVE = 1 << COMMAND_SURVIVE,
    FOR_START = FOR_RUN | FOR_BENCH | FOR_SURVIVE,
    FOR_SOUND = 1 << COMMAND_SOUND,
    FOR_ART = 1 << COMMAND_ART,
    FOR_PALETTE = 1 << COMMAND_PALETTE,
    FOR_HELP = 1 << COMMAND_HELP,
    FOR_LICENCES = 1 << COMMAND_LICENCES,
    FOR_GAMES = FOR_RUN | FOR_VERIFY | FOR_TEST | FOR_ROM | FOR_CHECK | FOR_BENCH | FOR_SURVIVE | FOR_SOUND | FOR_ART,
    FOR_ALL = FOR_GAMES | FOR_PALETTE
};

static const struct {
    const char *name, *words;
    int least, most; /* words */
    const char *help;
} commands[COMMANDS] = {
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
                         "- "
                         "reads names from standard input, a line each" },
    [COMMAND_TEST] = { "test", "DIR [NAME...]", 1, 1 << 20,
                       "run every demo of a game's demos/ and every script of its tests/, or those of these names, and "
                       "say which hold" },
    [COMMAND_PACK] = { "pack", "DIR", 1, 1, "make a .rom file of a game's folder" },
    [COMMAND_LIST] = { "list", "ROM", 1, 1, "print what is in a ROM" },
    [COMMAND_UNPACK] = { "unpack", "ROM DIR", 2, 2, "write every lump of a ROM as a file below DIR" },
    [COMMAND_NEW] = { "new", "DIR", 1, 1, "make a folder with a game to begin with: whole, and yours to change" },
    [COMMAND_EXPORT] = { "export", "ROM", 1, 1,
                         "make one file of a game that runs by itself, under its own name: this program and the game "
                         "in "
                         "it" },
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
    [COMMAND_HELP] = { "help", "[COMMAND | config | lua [NAME | WORD]]", 0, 2,
                       "this; of a command; of the settings and their file; of the Lua API, and what has a word in "
                       "it" },
    [COMMAND_VERSION] = { "version", "", 0, 0,
                          "release, core version, Lua release, compiler and flags (also --version)" },
    [COMMAND_LICENCES] = { "licences", "", 0, 0, "whose work is in this program, and under which licence" },
};

enum option {
    OPTION_RECORD,
    OPTION_DEMO,
    OPTION_SEED,
    OPTION_DIP,
    OPTION_STAGE,
    OPTION_LIVES,
    OPTION_REGISTER,
    OPTION_INVINCIBLE,
    OPTION_DIFFICULTY,
    OPTION_LANG,
    OPTION_SCALE,
    OPTION_SPEED,
    OPTION_FORMAT,
    OPTION_SLOWER,
    OPTION_FULLSCREEN,
    OPTION_MUTE,
    OPTION_PRESS,
    OPTION_FRAMES,
    OPTION_EVERY,
    OPTION_PARTS,
    OPTION_TRACE,
    OPTION_DIM,
    OPTION_FLASHES,
    OPTION_COLOURS,
    OPTION_SHEET,
    OPTION_WAV,
    OPTION_NOTES,
    OPTION_PLAY,
    OPTION_ATLAS,
    OPTION_BANK,
    OPTION_OUT,
    OPTION_MAP,
    OPTION_ALL,
    OPTION_EFFORT,
    OPTION_RESUME,
    OPTION_NO_RESUME,
    OPTION_NEAREST,
    OPTION_FROM,
    OPTION_BISECT,
    OPTION_RESTAMP,
    OPTION_RERECORD,
    OPTION_JSON,
    OPTION_REPLAYS,
    OPTION_NULL,
    OPTION_UPDATE,
    OPTION_TAP,
    OPTION_JUNIT,
    OPTION_PAGE,
    OPTION_JOBS,
    OPTION_ANNOTATIONS,
    OPTION_LUACHECK,
    OPTION_KEYS,
    OPTION_DESKTOP,
    OPTION_FULL,
    OPTION_VERBOSE,
    OPTION_HELP,
    OPTION_VERSION,
    OPTIONS
};

static const struct {
    const char *name, *value; /* value NULL: a switch */
    unsigned commands;
    const char *help;
} options[OPTIONS] = {
    [OPTION_RECORD] = { "--record", "F", FOR_RUN, "record the run as demo F" },
    [OPTION_DEMO] = { "--demo", "F", FOR_RUN | FOR_BENCH, "play demo F; afterwards nothing is pressed" },
    [OPTION_SEED] = { "--seed", "N", FOR_START,
                      "seed of the random streams, 0 to 2^64 - 1 (play: the clock's; else 0)" },
    [OPTION_DIP] = { "--dip", "NAME=VALUE", FOR_START, "set a DIP switch of the game; may be given several times" },
    [OPTION_STAGE] = { "--stage", "S", FOR_START, "start at NAME, NAME:MARK or BOSS/PHASE" },
    [OPTION_LIVES] = { "--lives", "N", FOR_RUN, "with --stage: so many lives in all, 1 to 99" },
    [OPTION_REGISTER] = { "--register", "NAME=VALUE", FOR_RUN | FOR_SURVIVE,
                          "with --stage: a register of the ship starts so; may be given several times" },
    [OPTION_INVINCIBLE] = { "--invincible", NULL, FOR_RUN, "with --stage: nothing hits the player" },
    [OPTION_DIFFICULTY] = { "--difficulty", "D", FOR_START, "start at this difficulty" },
    [OPTION_LANG] = { "--lang", "NAME", FOR_START, "start in this language of the game, lang/NAME.txt" },
    [OPTION_SCALE] = { "--scale", "N", FOR_PLAY | FOR_CAPTURE,
                       "pixels of the window, or of the film, a picture pixel, 1 to 16" },
    [OPTION_SPEED] = { "--speed", "N", FOR_CAPTURE, "a film of 1 to 16 times the speed; or slower: 1/2 to 1/16" },
    [OPTION_FORMAT] = { "--format", "WORD", FOR_CAPTURE,
                        "gif, apng, y4m, wav, mp4 or webm; without it the end of -o's name says it" },
    [OPTION_SLOWER] = { "--slower", "N", FOR_BENCH, "shares of a frame on a machine N times slower, 1 to 1000" },
    [OPTION_FULLSCREEN] = { "--fullscreen", NULL, FOR_PLAY, "fill the screen" },
    [OPTION_MUTE] = { "--mute", NULL, FOR_PLAY, "no sound" },
    [OPTION_PRESS] = { "--press", "LIST", FOR_HEADLESS,
                       "buttons that player 1 holds: fire, or fire,focus, or bomb@200, left@60:90, fire@0:600:8 for "
                       "frames of the run; player 2: 2.fire" },
    [OPTION_FRAMES] = { "--frames", "LIST", FOR_HEADLESS | FOR_SURVIVE,
                        "render: 600, or 1,60,600, or 0:600:60 (both ends included); capture: 60:600 or 60-600; hash: "
                        "run N frames; with --trace, these frames; survive: so many at most, else 7200" },
    [OPTION_EVERY] = { "--every", "N", FOR_HASH, "print every Nth frame only" },
    [OPTION_PARTS] = { "--parts", NULL, FOR_HASH, "print the hash of each part as well" },
    [OPTION_TRACE] = { "--trace", "PARTS", FOR_HASH,
                       "print all that these parts hold, a line a slot: bullets,player or all; may be given several "
                       "times" },
    [OPTION_DIM] = { "--dim", "WORD", FOR_VIEW, "backgrounds darker: none, quarter, half, most (by three quarters)" },
    [OPTION_FLASHES] = { "--flashes", "WORD", FOR_VIEW, "full, soft: flashes of the screen at a quarter" },
    [OPTION_COLOURS] = { "--colours", "WORD", FOR_VIEW,
                         "for eyes that tell fewer apart: normal, protan, deutan, tritan" },
    [OPTION_SHEET] = { "--sheet", "F.png", FOR_RENDER, "put all frames on one picture, each with its number" },
    [OPTION_WAV] = { "--wav", "F.wav", FOR_RENDER | FOR_SOUND,
                     "render: write the sound of all frames up to the last of --frames; sound: of NAME, as -o" },
    [OPTION_NOTES] = { "--notes", NULL, FOR_SOUND, "print the notes and settings of one, a line each (docs/music.md)" },
    [OPTION_PLAY] = { "--play", NULL, FOR_SOUND, "hear NAME, in a window that shows the mixer; Escape ends" },
    [OPTION_ATLAS] = { "--atlas", "F.png", FOR_ART,
                       "all sprites, three times as large, with names, banks, origins and hit shapes" },
    [OPTION_BANK] = { "--bank", "N", FOR_PALETTE, "the bank, 0 to 15" },
    [OPTION_OUT] = { "-o", "PATH", FOR_VIEW | FOR_PACK | FOR_EXPORT | FOR_SURVIVE | FOR_SOUND | FOR_PALETTE,
                     "where to write: render: folder (else the current one); capture: the film, - is standard output; "
                     "pack: ROM file; export: the program; survive: demo, or with .png in place of its ending the "
                     "picture, with --all "
                     "their folder; sound: WAV file; palette: a palette (.png), or a bank of one (.gpl, .hex)" },
    [OPTION_MAP] = { "--map", "F.png", FOR_SURVIVE, "draw where the ship could be, frame by frame" },
    [OPTION_ALL] = { "--all", NULL, FOR_SURVIVE,
                     "every stage and every phase of a boss at every difficulty, a line each, and what is harder where "
                     "it should be easier; with --stage or --difficulty, those of it" },
    [OPTION_EFFORT] = { "--effort", "N", FOR_SURVIVE, "plans to be made at most, in hundreds, 1 to 1000 (4)" },
    [OPTION_RESUME] = { "--resume", NULL, FOR_PLAY, "go on with the run that was left, without asking" },
    [OPTION_NO_RESUME] = { "--no-resume", NULL, FOR_PLAY,
                           "begin at the title without asking; a run that was left is kept until another begins" },
    [OPTION_NEAREST] = { "--nearest", NULL, FOR_GAMES,
                         "packing a folder: take the nearest colour of the bank for one that is not in it" },
    [OPTION_FROM] = { "--from", "NAME", FOR_NEW,
                      "which game: shooter (ship, stage, boss, music; without --from), first (30 lines), pattern (a "
                      "place to try patterns)" },
    [OPTION_BISECT] = { "--bisect", NULL, FOR_VERIFY,
                        "verify --bisect A B: compare what hash printed of two runs (--parts or --trace); names the "
                        "first frame, part, slot and column that differ. - is standard input" },
    [OPTION_RESTAMP] = { "--restamp", NULL, FOR_VERIFY,
                         "write demos that hold anew, in the newest format and as of this ROM" },
    [OPTION_RERECORD] = { "--rerecord", NULL, FOR_VERIFY,
                          "play the pads of demos of another core version or build to their end and write them anew, "
                          "as "
                          "of this one; says what became of prints, score, moments and length. Exit code 0: score, "
                          "moments "
                          "and length are known to be the same; 1: not; 2: not written" },
    [OPTION_JSON] = { "--json", NULL, FOR_VERIFY | FOR_LIST | FOR_BENCH | FOR_SURVIVE,
                      "verify: print a JSON object a demo, on a line: verdict, score, ship, difficulty, flags, length, "
                      "moments, hashes (docs/demos.md); list --replays: a JSON object a replay; bench: one of all; "
                      "survive: one a section" },
    [OPTION_REPLAYS] = { "--replays", NULL, FOR_LIST,
                         "print the runs of the game that are kept: file, date, length, ship, difficulty, points, "
                         "end" },
    [OPTION_NULL] = { "--null", NULL, FOR_VERIFY, "verify ROM -: each name ends in a NUL byte (also -0)" },
    [OPTION_UPDATE] = { "--update", NULL, FOR_TEST,
                        "keep the pictures and hashes as they are now: tests/golden; look at the pictures first" },
    [OPTION_TAP] = { "--tap", NULL, FOR_TEST, "print TAP, the Test Anything Protocol, in place of lines for people" },
    [OPTION_JUNIT] = { "--junit", "FILE", FOR_TEST, "also write a JUnit file, which CI services read" },
    [OPTION_PAGE] = { "--page", "FILE", FOR_TEST,
                      "write the page of what failed here, one HTML file with its pictures (else, if a test fails, "
                      "tests/failed/failed.html)" },
    [OPTION_JOBS] = { "--jobs", "N", FOR_TEST, "tests at a time, 1 to 64 (else as many as there are processors)" },
    [OPTION_ANNOTATIONS] = { "--annotations", NULL, FOR_HELP,
                             "help lua, help test: print the API as definitions for editors (LuaLS, the Lua language "
                             "server)" },
    [OPTION_LUACHECK] = { "--luacheck", NULL, FOR_HELP,
                          "help lua: print the API's names as a .luacheckrc, the settings of luacheck" },
    [OPTION_KEYS] = { "--keys", NULL, FOR_EXPORT,
                      "the program keeps the keys and commands of those who make games: rewind, steps, console, "
                      "panels; "
                      "verify, render" },
    [OPTION_DESKTOP] = { "--desktop", NULL, FOR_EXPORT,
                         "also write FILE.desktop and FILE.png, an entry for the desktop's menu" },
    [OPTION_FULL] = { "--full", NULL, FOR_LICENCES, "also the texts of the licences, to be given along" },
    [OPTION_VERBOSE] = { "--verbose", NULL, FOR_RUN | FOR_VERIFY,
                         "also print the Lua traceback of a script fault; play: how late sound was; verify: hashes, "
                         "moment and buttons of a difference too (also -v, --traceback)" },
    [OPTION_HELP] = { "--help", NULL, FOR_ALL, "help of the command (also -h)" },
    [OPTION_VERSION] = { "--version", NULL, FOR_ALL, "what this program is" },
};

/* ---- near words ---- */

enum { NEAR_MOST = 31 };

/* Edits (a letter more, less or another, or two swapped) from a to b. */
static int edits(const char *a, const char *b)
{
    int d[NEAR_MOST + 1][NEAR_MOST + 1];
    int n = (int)strlen(a), m = (int)strlen(b);

    if (n > NEAR_MOST || m > NEAR_MOST)
        return NEAR_MOST;
    for (int i = 0; i <= n; i++) {
        for (int j = 0; j <= m; j++) {
            if (i == 0 || j == 0) {
                d[i][j] = i + j;
                continue;
            }
            d[i][j] = int_min(d[i - 1][j - 1] + (a[i - 1] != b[j - 1]), int_min(d[i - 1][j], d[i][j - 1]) + 1);
            if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1])
                d[i][j] = int_min(d[i][j], d[i - 2][j - 2] + 1);
        }
    }
    return d[n][m];
}

const char *args_near(const char *word, const char *const *list, int n)
{
    const char *best = NULL;
    int limit = strlen(word) < 3 ? -1 : 1 + (int)strlen(word) / 4;

    for (int i = 0; i < n; i++) {
        int e = edits(word, list[i]);
        if (e > limit || e >= (int)strlen(list[i]))
            continue;
        best = list[i];
        limit = e - 1; /* only a nearer one is better */
    }
    return best;
}

const char *args_near_command(const char *word)
{
    const char *names[COMMANDS];

    for (int i = 0; i < COMMANDS; i++)
        names[i] = commands[i].name;
    return args_near(word, names, COMMANDS);
}

int args_command(const char *name)
{
    for (int i = 0; i < COMMANDS; i++) {
        if (strcmp(name, commands[i].name) == 0)
            return i;
    }
    return -1;
}

const char *args_name(enum command command)
{
    return commands[command].name;
}

/* ---- values ---- */

/* Decimal, or 0x and hexadecimal: all of the text up to `end` and no more than most. */
static bool number(const char *text, const char *end, uint64_t most, uint64_t *out)
{
    bool hex = text[0] == '0' && (text[1] == 'x' || text[1] == 'X') && end - text > 2;
    uint64_t base = hex ? 16 : 10, v = 0;
    const char *p = hex ? text + 2 : text;

    if (p == end)
        return false;
    for (; p < end; p++) {
        static const char digits[] = "0123456789abcdef0123456789ABCDEF";
        const char *at = *p ? strchr(digits, *p) : NULL;
        uint64_t digit = at ? (uint64_t)(at - digits) % 16 : 16;
        if (digit >= base || v > (most - digit) / base)
            return false;
        v = v * base + digit;
    }
    *out = v;
    return true;
}

static bool number_from(const char *option, const char *text, uint64_t low, uint64_t most, uint64_t *out, char *err,
                        size_t err_size)
{
    if (number(text, text + strlen(text), most, out) && *out >= low)
        return true;
    return err_set(err, err_size, "%s: expected a whole number from %llu to %llu, got \"%s\"", option,
                   (unsigned long long)low, (unsigned long long)most, text);
}

static bool read_span(struct span *s, const char *p, const char *end)
{
    uint64_t v[3];
    int n = 0;

    for (bool more = true; more; n++) {
        const char *stop = memchr(p, ':', (size_t)(end - p));
        if (!stop && n == 0) /* as FIRST-LAST */
            stop = memchr(p, '-', (size_t)(end - p));
        more = stop != NULL;
        if (n == 3 || !number(p, more ? stop : end, ARGS_MAX_FRAME, &v[n]))
            return false;
        p = more ? stop + 1 : end;
    }
    s->first = (uint32_t)v[0];
    s->last = (uint32_t)v[n > 1 ? 1 : 0];
    s->step = n > 2 ? (uint32_t)v[2] : 1;
    return s->step > 0;
}

bool args_frames(struct args *a, const char *text, char *err, size_t err_size)
{
    const char *p = text;

    a->n_spans = 0;
    for (bool more = true; more;) {
        size_t n = strcspn(p, ",");
        struct span s;
        if (!read_span(&s, p, p + n))
            return err_set(err, err_size,
                           "--frames: expected frames from 0 to %d like 600 or 1,60,600 or 0:600:60, got \"%s\"",
                           ARGS_MAX_FRAME, text);
        if (s.last < s.first)
            return err_set(err, err_size, "--frames: %u:%u ends before it starts", (unsigned)s.first, (unsigned)s.last);
        if (a->n_spans == ARGS_MAX_SPANS)
            return err_set(err, err_size, "--frames: more than %d parts", ARGS_MAX_SPANS);
        a->spans[a->n_spans++] = s;
        more = p[n] == ',';
        p += n + 1;
    }
    return true;
}

static bool in_span(const struct span *s, uint32_t frame)
{
    return frame >= s->first && frame <= s->last && (frame - s->first) % s->step == 0;
}

static const char *const buttons[PAD_BUTTONS] = PAD_NAMES;

/* BUTTON or BUTTON@FRAMES, of player 2: 2.BUTTON. */
static bool read_press(struct press *out, const char *p, const char *end)
{
    const bool second = end - p > 2 && p[0] == '2' && p[1] == '.';

    p += second ? 2 : 0;
    const char *at = memchr(p, '@', (size_t)(end - p));
    const size_t n = (size_t)((at ? at : end) - p);
    *out = (struct press){ .player = second, .when = { 0, ARGS_MAX_FRAME, 1 } };
    for (int i = 0; i < PAD_BUTTONS; i++)
        if (strlen(buttons[i]) == n && memcmp(buttons[i], p, n) == 0)
            out->pad = (uint16_t)(1 << i);
    return out->pad && (!at || read_span(&out->when, at + 1, end));
}

bool args_presses(struct args *a, const char *text, char *err, size_t err_size)
{
    const char *p = text;

    for (bool more = true; more;) {
        const size_t n = strcspn(p, ",");
        if (a->n_presses == ARGS_MAX_PRESSES)
            return err_set(err, err_size, "--press: more than %d parts", ARGS_MAX_PRESSES);
        if (!read_press(&a->presses[a->n_presses++], p, p + n))
            return err_set(err, err_size,
                           "--press: expected buttons like fire or fire,focus or bomb@200 or left@60:90, got \"%s\" "
                           "(there are up down left right fire bomb focus special start select)",
                           text);
        more = p[n] == ',';
        p += n + 1;
    }
    return true;
}

void args_pressed(const struct args *a, uint32_t frame, uint16_t pads[PADS])
{
    memset(pads, 0, PADS * sizeof *pads);
    for (int i = 0; i < a->n_presses; i++)
        if (in_span(&a->presses[i].when, frame))
            pads[a->presses[i].player] |= a->presses[i].pad;
}

bool args_wants(const struct args *a, uint32_t frame)
{
    for (int i = 0; i < a->n_spans; i++)
        if (in_span(&a->spans[i], frame))
            return true;
    return false;
}

uint32_t args_last_frame(const struct args *a)
{
    uint32_t last = 0;

    for (int i = 0; i < a->n_spans; i++) {
        const struct span *s = &a->spans[i];
        uint32_t end = s->last - (s->last - s->first) % s->step;
        last = end > last ? end : last;
    }
    return last;
}

/* ---- parsing ---- */

/* One more NAME=VALUE of a list of at most `most`. */
static bool add_setting(const char **list, int *n, int most, enum option o, const char *value, char *err,
                        size_t err_size)
{
    const char *equals = strchr(value, '=');

    if (!equals || equals == value || !equals[1])
        return err_set(err, err_size, "%s: expected NAME=VALUE, got \"%s\"", options[o].name, value);
    if (*n == most)
        return err_set(err, err_size, "%s: more than %d", options[o].name, most);
    list[(*n)++] = value;
    return true;
}

static bool set_trace(struct args *a, const char *value, char *err, size_t err_size)
{
    if (a->n_traces == ARGS_MAX_TRACES)
        return err_set(err, err_size, "--trace: more than %d", ARGS_MAX_TRACES);
    a->traces[a->n_traces++] = value;
    return true;
}

static bool set_number(struct args *a, enum option o, const char *value, char *err, size_t err_size)
{
    uint64_t v = 0, low = o == OPTION_SEED ? 0 : 1;
    uint64_t most = o == OPTION_SEED     ? UINT64_MAX
                    : o == OPTION_SCALE  ? ARGS_MAX_SCALE
                    : o == OPTION_LIVES  ? ARGS_MAX_LIVES
                    : o == OPTION_SLOWER ? ARGS_MAX_SLOWER
                    : o == OPTION_JOBS   ? ARGS_MAX_JOBS
                    : o == OPTION_EFFORT ? ARGS_MAX_EFFORT
                                         : ARGS_MAX_FRAME;

    if (!number_from(options[o].name, value, low, most, &v, err, err_size))
        return false;
    if (o == OPTION_SCALE)
        a->scale = (int)v;
    else if (o == OPTION_LIVES)
        a->lives = (int)v;
    else if (o == OPTION_SLOWER)
        a->machine = (int)v;
    else if (o == OPTION_JOBS)
        a->jobs = (int)v;
    else if (o == OPTION_EVERY)
        a->every = (uint32_t)v;
    else if (o == OPTION_EFFORT)
        a->effort = (uint32_t)v;
    else
        a->seed = v;
    return true;
}

/* N or 1/N. */
static bool set_speed(struct args *a, const char *value, char *err, size_t err_size)
{
    const bool slower = strncmp(value, "1/", 2) == 0;
    const char *text = value + (slower ? 2 : 0);
    uint64_t v;

    if (!number(text, text + strlen(text), ARGS_MAX_SPEED, &v) || v == 0)
        return err_set(err, err_size, "--speed: expected a whole number from 1 to %d, or 1/2 to 1/%d, got \"%s\"",
                       ARGS_MAX_SPEED, ARGS_MAX_SPEED, value);
    a->faster = slower ? 1 : (int)v;
    a->slower = slower ? (int)v : 1;
    return true;
}

static bool set_string(const char **to, enum option o, const char *value, char *err, size_t err_size)
{
    if (!value[0])
        return err_set(err, err_size, "%s: expected %s, got nothing", options[o].name, options[o].value);
    *to = value;
    return true;
}

static bool set_word(int *to, enum option o, const char *const *words, const char *value, char *err, size_t err_size)
{
    char list[128];

    *to = views_find(words, value);
    if (*to >= 0)
        return true;
    views_list(words, list, sizeof list);
    return err_set(err, err_size, "%s: expected %s, got \"%s\"", options[o].name, list, value);
}

static bool set_bank(struct args *a, const char *value, char *err, size_t err_size)
{
    uint64_t bank;

    if (!number_from("--bank", value, 0, 15, &bank, err, err_size))
        return false;
    a->bank = (int)bank;
    return true;
}

static bool set_switch(bool *to)
{
    *to = true;
    return true;
}

static bool set(struct args *a, enum option o, const char *value, char *err, size_t err_size)
{
    switch (o) {
    case OPTION_RECORD:
        return set_string(&a->record, o, value, err, err_size);
    case OPTION_DEMO:
        return set_string(&a->demo, o, value, err, err_size);
    case OPTION_STAGE:
        return set_string(&a->stage, o, value, err, err_size);
    case OPTION_DIFFICULTY:
        return set_string(&a->difficulty, o, value, err, err_size);
    case OPTION_LANG:
        return set_string(&a->lang, o, value, err, err_size);
    case OPTION_SHEET:
        return set_string(&a->sheet, o, value, err, err_size);
    case OPTION_WAV:
        return set_string(&a->wav, o, value, err, err_size);
    case OPTION_ATLAS:
        return set_string(&a->atlas, o, value, err, err_size);
    case OPTION_BANK:
        return set_bank(a, value, err, err_size);
    case OPTION_FORMAT:
        return set_string(&a->format, o, value, err, err_size);
    case OPTION_FROM:
        return set_string(&a->from, o, value, err, err_size);
    case OPTION_SPEED:
        return set_speed(a, value, err, err_size);
    case OPTION_OUT:
        return set_string(&a->out, o, value, err, err_size);
    case OPTION_DIP:
        return add_setting(a->dips, &a->n_dips, ARGS_MAX_DIPS, o, value, err, err_size);
    case OPTION_REGISTER:
        return add_setting(a->registers, &a->n_registers, ARGS_MAX_REGISTERS, o, value, err, err_size);
    case OPTION_TRACE:
        return set_trace(a, value, err, err_size);
    case OPTION_PRESS:
        return args_presses(a, value, err, err_size);
    case OPTION_FRAMES:
        return args_frames(a, value, err, err_size);
    case OPTION_DIM:
        return set_word(&a->dim, o, views_dim, value, err, err_size);
    case OPTION_FLASHES:
        return set_word(&a->flashes, o, views_flashes, value, err, err_size);
    case OPTION_COLOURS:
        return set_word(&a->colours, o, views_colours, value, err, err_size);
    case OPTION_SEED:
        a->seeded = true;
        return set_number(a, o, value, err, err_size);
    case OPTION_SCALE:
    case OPTION_LIVES:
    case OPTION_SLOWER:
    case OPTION_EVERY:
    case OPTION_JOBS:
    case OPTION_EFFORT:
        return set_number(a, o, value, err, err_size);
    case OPTION_MAP:
        return set_string(&a->map, o, value, err, err_size);
    case OPTION_ALL:
        return set_switch(&a->all);
    case OPTION_INVINCIBLE:
        return set_switch(&a->invincible);
    case OPTION_FULLSCREEN:
        return set_switch(&a->fullscreen);
    case OPTION_MUTE:
        return set_switch(&a->mute);
    case OPTION_PLAY:
        return set_switch(&a->play);
    case OPTION_PARTS:
        return set_switch(&a->parts);
    case OPTION_NEAREST:
        return set_switch(&a->nearest);
    case OPTION_NOTES:
        return set_switch(&a->notes);
    case OPTION_BISECT:
        return set_switch(&a->bisect);
    case OPTION_RESTAMP:
        return set_switch(&a->restamp);
    case OPTION_RERECORD:
        return set_switch(&a->rerecord);
    case OPTION_REPLAYS:
        return set_switch(&a->replays);
    case OPTION_JSON:
        return set_switch(&a->json);
    case OPTION_RESUME:
        return set_switch(&a->resume);
    case OPTION_NO_RESUME:
        return set_switch(&a->no_resume);
    case OPTION_NULL:
        return set_switch(&a->null);
    case OPTION_UPDATE:
        return set_switch(&a->update);
    case OPTION_TAP:
        return set_switch(&a->tap);
    case OPTION_JUNIT:
        return set_string(&a->junit, o, value, err, err_size);
    case OPTION_PAGE:
        return set_string(&a->page, o, value, err, err_size);
    case OPTION_ANNOTATIONS:
        return set_switch(&a->annotations);
    case OPTION_LUACHECK:
        return set_switch(&a->luacheck);
    case OPTION_KEYS:
        return set_switch(&a->keys);
    case OPTION_DESKTOP:
        return set_switch(&a->desktop);
    case OPTION_FULL:
        return set_switch(&a->full);
    case OPTION_VERBOSE:
        return set_switch(&a->verbose);
    default:
        return true;
    }
}

/* The option named by the n bytes at name, or OPTIONS. */
static enum option find_option(const char *name, size_t n)
{
    static const struct {
        const char *name;
        enum option is;
    } shorts[] = { { "-h", OPTION_HELP },
                   { "-v", OPTION_VERBOSE },
                   { "--traceback", OPTION_VERBOSE },
                   { "-0", OPTION_NULL },
                   { "--out", OPTION_OUT } };

    for (int i = 0; i < OPTIONS; i++) {
        if (strlen(options[i].name) == n && memcmp(options[i].name, name, n) == 0)
            return (enum option)i;
    }
    for (size_t i = 0; i < sizeof shorts / sizeof shorts[0]; i++) {
        if (strlen(shorts[i].name) == n && memcmp(shorts[i].name, name, n) == 0)
            return shorts[i].is;
    }
    return OPTIONS;
}

static bool unknown_option(const char *word, size_t n, char *err, size_t err_size)
{
    const char *names[OPTIONS];
    char name[64];

    for (int i = 0; i < OPTIONS; i++)
        names[i] = options[i].name;
    snprintf(name, sizeof name, "%.*s", (int)(n < sizeof name ? n : sizeof name - 1), word);
    const char *meant = n < sizeof name ? args_near(name, names, OPTIONS) : NULL;
    if (meant)
        return err_set(err, err_size, "unknown option %s (did you mean %s?)", name, meant);
    return err_set(err, err_size, "unknown option %s (curtain help lists them)", name);
}

static uint64_t bit(enum option o)
{
    return (uint64_t)1 << o;
}

/* Reads the option argv[*i], and its value if it has one; adds its bit to *seen. */
static bool read_option(struct args *a, int argc, char **argv, int *i, uint64_t *seen, char *err, size_t err_size)
{
    const char *word = argv[*i], *equals = strchr(word, '='), *value = NULL;
    size_t n = equals ? (size_t)(equals - word) : strlen(word);
    enum option o = find_option(word, n);

    if (o == OPTIONS)
        return unknown_option(word, n, err, err_size);
    if (!options[o].value && equals)
        return err_set(err, err_size, "%s takes no value, got \"%s\"", options[o].name, equals + 1);
    if (options[o].value) {
        if (!equals && *i + 1 >= argc)
            return err_set(err, err_size, "%s: expected %s, got nothing", options[o].name, options[o].value);
        value = equals ? equals + 1 : argv[++*i];
    }
    if (*seen >> o & 1 && o != OPTION_DIP && o != OPTION_REGISTER && o != OPTION_TRACE)
        return err_set(err, err_size, "%s is given twice", options[o].name);
    *seen |= bit(o);
    return set(a, o, value, err, err_size);
}

static void goes_with(unsigned set_of, char *out, size_t size)
{
    size_t n = 0;

    out[0] = 0;
    for (int i = 0; i < COMMANDS && n < size; i++) {
        if (set_of >> i & 1)
            n += (size_t)snprintf(out + n, size - n, "%s%s", n ? ", " : "", commands[i].name);
    }
}

/* Each of these makes another command of verify. */
static bool check_verify(uint64_t seen, char *err, size_t err_size)
{
    static const enum option ways[] = { OPTION_BISECT, OPTION_RESTAMP, OPTION_RERECORD, OPTION_JSON };
    const char *first = NULL;

    for (size_t i = 0; i < sizeof ways / sizeof ways[0]; i++) {
        if (!(seen >> ways[i] & 1))
            continue;
        if (first)
            return err_set(err, err_size, "%s does not go with %s", options[ways[i]].name, first);
        first = options[ways[i]].name;
    }
    return true;
}

/* A run that was left is gone on with as it was begun; JSON is of replays. */
static bool check_pairs(const struct args *a, uint64_t seen, char *err, size_t err_size)
{
    static const enum option others[] = { OPTION_NO_RESUME, OPTION_DEMO,       OPTION_SEED, OPTION_DIP,
                                          OPTION_STAGE,     OPTION_DIFFICULTY, OPTION_LANG };

    for (size_t i = 0; a->resume && i < sizeof others / sizeof others[0]; i++)
        if (seen & bit(others[i]))
            return err_set(err, err_size, "--resume does not go with %s", options[others[i]].name);
    if (a->command == COMMAND_SURVIVE && a->all && a->map)
        return err_set(err, err_size, "--all does not go with --map, which is of one section");
    if (a->command == COMMAND_LIST && a->json && !a->replays)
        return err_set(err, err_size, "list: --json needs --replays");
    return true;
}

/* What is done with one sound needs its name, and there is one way to do it. */
static bool check_sound(const struct args *a, char *err, size_t err_size)
{
    const char *first = a->out ? "-o" : a->wav ? "--wav" : a->play ? "--play" : "--notes";

    if (a->command != COMMAND_SOUND || !(a->out || a->wav || a->play || a->notes))
        return true;
    if (a->n_words < 2)
        return err_set(err, err_size, "%s needs the name of a sound or a piece of music (curtain help sound)", first);
    if (a->wav && a->out)
        return err_set(err, err_size, "--wav does not go with -o, which says the same");
    if (a->play && (a->out || a->wav))
        return err_set(err, err_size, "--play does not go with %s", first);
    if (a->notes && (a->out || a->wav || a->play))
        return err_set(err, err_size, "--notes does not go with %s", first);
    return true;
}

/* Both are of the whole API; test scripts have one of their own. */
static bool check_help(const struct args *a, char *err, size_t err_size)
{
    const char *option = a->annotations ? "--annotations" : "--luacheck";

    if (!a->annotations && !a->luacheck)
        return true;
    if (a->annotations && a->luacheck)
        return err_set(err, err_size, "--luacheck does not go with --annotations");
    if (a->n_words == 1 && a->annotations && strcmp(a->words[0], "test") == 0)
        return true;
    if (a->n_words != 1 || strcmp(a->words[0], "lua") != 0)
        return err_set(err, err_size, "%s: expected curtain help lua %s", option, option);
    return true;
}

static bool check_options(const struct args *a, uint64_t seen, char *err, size_t err_size)
{
    char with[160];
    const uint64_t practice = bit(OPTION_LIVES) | bit(OPTION_REGISTER) | bit(OPTION_INVINCIBLE);
    const uint64_t fixed = practice | bit(OPTION_SEED) | bit(OPTION_DIP) | bit(OPTION_STAGE) | bit(OPTION_DIFFICULTY) |
                           bit(OPTION_LANG) | bit(OPTION_PRESS);

    for (int o = 0; o < OPTIONS; o++) {
        if (!(seen >> o & 1))
            continue;
        if (!(options[o].commands >> a->command & 1)) {
            goes_with(options[o].commands, with, sizeof with);
            return err_set(err, err_size, "%s does not go with %s (it goes with %s)", options[o].name,
                           commands[a->command].name, with);
        }
        if (a->demo && fixed >> o & 1)
            return err_set(err, err_size, "%s does not go with --demo, which holds its own", options[o].name);
        if (!a->stage && practice >> o & 1)
            return err_set(err, err_size, "%s needs --stage: it is for a practice start", options[o].name);
    }
    return check_verify(seen, err, err_size) && check_pairs(a, seen, err, err_size);
}

/* A first word that is no command is play's ROM, unless the rest shows that it was meant to be one. */
static bool check_command(const struct args *a, uint64_t seen, char *err, size_t err_size)
{
    const char *word = a->words[0], *meant = args_near_command(word);
    bool fits = a->n_words == 1;

    for (int o = 0; o < OPTIONS; o++)
        fits = fits && (!(seen >> o & 1) || options[o].commands & FOR_PLAY);
    if (fits || (!meant && a->n_words == 1))
        return true;
    if (meant)
        return err_set(err, err_size, "unknown command \"%s\" (did you mean %s?)", word, meant);
    return err_set(err, err_size, "unknown command \"%s\" (curtain help lists them)", word);
}

static bool check_words(const struct args *a, char *err, size_t err_size)
{
    const char *name = commands[a->command].name;

    if (a->n_words < commands[a->command].least)
        return err_set(err, err_size, "%s: expected %s (curtain help %s)", name, commands[a->command].words, name);
    if (a->n_words && !a->words[0][0] && FOR_GAMES >> a->command & 1)
        return err_set(err, err_size, "%s: expected %s, got \"\" (curtain help %s)", name, commands[a->command].words,
                       name);
    if (a->n_words > commands[a->command].most)
        return err_set(err, err_size, "%s: \"%s\" is one argument too many (curtain help %s)", name,
                       a->words[commands[a->command].most], name);
    return true;
}

/* help and version take over whatever else was said. */
static bool take_over(struct args *a, enum command command)
{
    if (command == COMMAND_HELP) {
        bool named = a->n_words > 0 && args_command(a->words[0]) >= 0;
        a->n_words = named ? 1 : 0;
    } else {
        a->n_words = 0;
    }
    a->command = command;
    return true;
}

/* What is longer would push the reason out of the sentences that name it. */
static bool short_enough(int argc, char **argv, char *err, size_t err_size)
{
    for (int i = 1; i < argc; i++)
        if (strlen(argv[i]) > ARGS_MAX_WORD)
            return err_set(err, err_size, "an argument is longer than %d characters: \"%.32s...\"", ARGS_MAX_WORD,
                           argv[i]);
    return true;
}

bool args_parse(struct args *a, int argc, char **argv, char *err, size_t err_size)
{
    uint64_t seen = 0;
    bool only_words = false;

    *a = (struct args){ .words = argv, .every = 1, .bank = -1, .machine = 1 };
    if (!short_enough(argc, argv, err, err_size))
        return false;
    for (int i = 1; i < argc; i++) {
        if (!only_words && strcmp(argv[i], "--") == 0)
            only_words = true;
        else if (only_words || argv[i][0] != '-' || !argv[i][1])
            argv[a->n_words++] = argv[i];
        else if (!read_option(a, argc, argv, &i, &seen, err, err_size))
            return false;
    }
    if (seen >> OPTION_VERSION & 1)
        return take_over(a, COMMAND_VERSION);
    if (seen >> OPTION_HELP & 1)
        return take_over(a, COMMAND_HELP);
    int command = a->n_words ? args_command(a->words[0]) : -1;
    if (command >= 0) {
        a->command = (enum command)command;
        a->words++;
        a->n_words--;
    } else if (a->n_words && !check_command(a, seen, err, err_size)) {
        return false;
    }
    return check_options(a, seen, err, err_size) && check_words(a, err, err_size) && check_sound(a, err, err_size) &&
           check_help(a, err, err_size);
}

/* ---- help ---- */

static void help_options(unsigned set_of, void (*line)(const char *))
{
    char text[320], name[48];

    for (int o = 0; o < OPTIONS; o++) {
        if (!(options[o].commands & set_of))
            continue;
        snprintf(name, sizeof name, "%s%s%s", options[o].name, options[o].value ? " " : "",
                 options[o].value ? options[o].value : "");
        snprintf(text, sizeof text, "  %-21s %s", name, options[o].help);
        line(text);
    }
}

static void help_all(void (*line)(const char *))
{
    char text[320], name[48];

    line("curtain plays bullet-hell games. A ROM is a game's folder or a .rom file.");
    line("");
    for (int i = 0; i < COMMANDS; i++) {
        snprintf(name, sizeof name, "%s %s", commands[i].name, commands[i].words);
        snprintf(text, sizeof text, "  curtain %-28s %s", name, commands[i].help);
        line(text);
    }
    line("");
    line("The word play may be left out. Options, each explained by curtain help COMMAND:");
    help_options(FOR_ALL | FOR_NEW, line);
    line("");
    line("Exit codes: 0 done, 1 a demo does not hold or check found something, 2 bad input or a script fault, 3 the "
         "host failed.");
}

void args_help(int command, void (*line)(const char *))
{
    char text[320];

    if (command < 0) {
        help_all(line);
        return;
    }
    snprintf(text, sizeof text, "curtain %s %s%s", commands[command].name, commands[command].words,
             FOR_ALL >> command & 1 ? " [OPTIONS]" : "");
    line(text);
    snprintf(text, sizeof text, "  %s", commands[command].help);
    line(text);
    if (!((FOR_ALL | FOR_HELP | FOR_NEW | FOR_LICENCES) >> command & 1))
        return;
    line("");
    help_options(1u << command, line);
}
