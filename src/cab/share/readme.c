/*
 * readme.c - see readme.h. In these texts @ is the game's id. Keys are those of keys.h, which the web page has too.
 */
#include "readme.h"

#include <stdio.h>
#include <string.h>
#include "../host/clean.h"
#include "../host/keys.h"
#include "../host/version.h"

static const struct {
    const char *start, *saves, *remove;
    bool keys, window; /* with the players' keys; and with the window's */
} texts[] = {
    [EXPORT_LINUX] = { "Double-click the file @, or run ./@ in a terminal in this folder. If it does not start, make "
                       "it\n"
                       "executable: chmod +x @\n"
                       "\n"
                       "It needs Linux on x86-64 and the library SDL 2, which many systems already have. To install "
                       "it:\n"
                       "\n"
                       "  Debian, Ubuntu, Mint    sudo apt install libsdl2-2.0-0\n"
                       "  Fedora                  sudo dnf install SDL2\n"
                       "  Arch                    sudo pacman -S sdl2\n"
                       "  openSUSE                sudo zypper install libSDL2-2_0-0\n",
                       "They are in the folder ~/.local/share/curtain-@. Screenshots and clips are in the folder @ in "
                       "your\n"
                       "pictures folder.\n",
                       "Delete the file @ and the folder ~/.local/share/curtain-@.\n", true, true },
    [EXPORT_WINDOWS] = { "Double-click @.exe. It needs Windows 10 or 11 with 64 bits, and installs nothing.\n"
                         "\n"
                         "The first time, Windows may show \"Windows protected your PC\", because it does not know "
                         "the\n"
                         "program yet. Click \"More info\", then \"Run anyway\".\n",
                         "They are in the folder %APPDATA%\\curtain-@; Explorer opens it when you paste this into its "
                         "address\n"
                         "bar. Screenshots and clips are in the folder @ in your pictures folder.\n",
                         "Delete @.exe and the folder %APPDATA%\\curtain-@.\n", true, true },
    [EXPORT_WEB] = { "Open index.html in a browser: Chrome, Edge, Firefox or Safari from 2023 or later. It needs no "
                     "server\n"
                     "and no connection. On a phone, drag a finger to move. \"More\" on the page lists all keys.\n",
                     "The browser stores scores and settings of the page. To save a recording of a run, choose "
                     "\"More\" and\n"
                     "\"Save Recording\".\n",
                     "Delete the files. The browser's settings for stored data of sites delete scores and settings.\n",
                     true, false },
    [EXPORT_LIBRETRO] = { "This is a core for RetroArch on Linux, x86-64. Copy @_libretro.so into RetroArch's cores "
                          "folder and\n"
                          "@_libretro.info into its core info folder (Settings > Directory shows where they are). Then "
                          "choose\n"
                          "Load Core, the game, and Start Core. RetroArch's menu Controls lists the buttons.\n",
                          "RetroArch stores scores and states in its folders for save files and save states.\n",
                          "Delete the two files, and the save files and states with the game's name.\n", false, false },
};

static void put_text(struct reel *out, const char *text, const char *id)
{
    for (; *text; text++)
        if (*text == '@')
            reel_print(out, "%s", id);
        else
            reel_byte(out, (uint8_t)*text);
}

/* Adds an action's keys to a list, without the buttons of controllers, which F1 shows. */
static void add_keys(char *list, size_t size, const struct keys *k, int action)
{
    char text[128];

    keys_text(k, keys_action(action), text, sizeof text);
    for (char *word = strtok(text, " "); word; word = strtok(NULL, " ")) {
        const size_t n = strlen(list);
        if (strncmp(word, "pad", 3) != 0)
            snprintf(list + n, size - n, "%s%s", n ? ", " : "", word);
    }
}

/* A line for each of n actions from the first on; those that follow one another and mean the same share one. */
static void put_keys(struct reel *out, const struct keys *k, int first, int n)
{
    const int player = PAD_BUTTONS; /* the actions of the first explain those of the others */

    for (int i = 0, last; i < n; i = last) {
        char list[128] = "";
        const char *meaning = keys_meaning(first < player * PADS ? i : first + i);
        for (last = i; last < n; last++) {
            if (strcmp(meaning, keys_meaning(first < player * PADS ? last : first + last)) != 0)
                break;
            add_keys(list, sizeof list, k, first + last);
        }
        reel_print(out, "  %-24s%s\n", list, meaning);
    }
}

static void put_all_keys(struct reel *out, const struct manifest *m, bool window)
{
    static const enum cab_key shown[] = { CAB_PAUSE, CAB_MENU, CAB_HELP, CAB_FULLSCREEN, CAB_SCREENSHOT, CAB_QUIT };
    struct keys k;

    keys_defaults(&k);
    reel_print(out, "KEYS\n\n");
    for (int p = 0; p < m->players && p < PADS; p++) {
        if (p > 0)
            reel_print(out, "\nPlayer %d:\n\n", p + 1);
        put_keys(out, &k, p * PAD_BUTTONS, PAD_BUTTONS);
    }
    reel_print(out, "\n");
    for (size_t i = 0; window && i < sizeof shown / sizeof *shown; i++)
        put_keys(out, &k, PADS * PAD_BUTTONS + (int)shown[i], 1);
    reel_print(out, "%sControllers work too.%s\n\n", window ? "\n" : "",
               window ? " The settings change keys and buttons." : "");
}

void readme_write(struct reel *out, enum export_kind kind, const struct manifest *m)
{
    char title[sizeof m->title], author[sizeof m->author];

    snprintf(title, sizeof title, "%s", m->title);
    snprintf(author, sizeof author, "%s", m->author);
    clean_line(title);
    clean_line(author);
    reel_print(out, "%s\n", title);
    if (author[0])
        reel_print(out, "by %s\n", author);
    reel_print(out, "\nSTART\n\n");
    put_text(out, texts[kind].start, m->id);
    reel_print(out, "\n");
    if (texts[kind].keys)
        put_all_keys(out, m, texts[kind].window);
    reel_print(out, "SCORES, REPLAYS AND SETTINGS\n\n");
    put_text(out, texts[kind].saves, m->id);
    reel_print(out, "\nREMOVE\n\n");
    put_text(out, texts[kind].remove, m->id);
    reel_print(out, "\nMade with Curtain %s. licences.txt has the licences of the software in it.\n", CURTAIN_VERSION);
}
