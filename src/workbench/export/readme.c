/*
 * readme.c - see readme.h. In the texts, @ is the game's id. The keys are the defaults of keys.h, also on the web page.
 */
#include "readme.h"

#include <stdio.h>
#include <string.h>
#include "../../common/clean.h"
#include "../../player/input/keys.h"
#include "../../player/game/version.h"

static const struct {
    const char *start, *saves, *remove;
    bool keys, window; /* list the players' keys, list the window's keys */
} texts[] = {
    [EXPORT_LINUX] = {
        "Double-click the file \"@\", or run ./@ in a terminal in this folder. If the game does not start,\n"
        "make the file executable: chmod +x @\n"
        "\n"
        "The game needs Linux on x86-64 and the SDL 2 library, which many systems already have. To install SDL 2:\n"
        "\n"
        "  Debian, Ubuntu, Mint    sudo apt install libsdl2-2.0-0\n"
        "  Fedora                  sudo dnf install SDL2\n"
        "  Arch                    sudo pacman -S sdl2\n"
        "  openSUSE                sudo zypper install libSDL2-2_0-0\n",
        "Scores, replays and settings are in the folder ~/.local/share/curtain-@.\n"
        "Screenshots and clips are in the folder \"@\" inside your pictures folder.\n",
        "Delete the file \"@\" and the folder ~/.local/share/curtain-@.\n",
        true, true,
    },
    [EXPORT_WINDOWS] = {
        "Double-click @.exe. The game needs 64-bit Windows 10 or 11. It does not install anything.\n"
        "\n"
        "When you start the game for the first time, Windows may show \"Windows protected your PC\", because it\n"
        "does not know the program yet. Click \"More info\", then \"Run anyway\".\n",
        "Scores, replays and settings are in the folder %APPDATA%\\curtain-@.\n"
        "To open this folder, paste its path into the address bar of Explorer.\n"
        "Screenshots and clips are in the folder \"@\" inside your pictures folder.\n",
        "Delete @.exe and the folder %APPDATA%\\curtain-@.\n",
        true, true,
    },
    [EXPORT_WEB] = {
        "Open index.html in Chrome, Edge, Firefox or Safari. The browser's version must be from 2023 or later.\n"
        "The game needs no server and no internet connection. On a phone, drag a finger to move. To list all keys,\n"
        "choose \"More\" on the page.\n",
        "The browser stores the scores and settings. To save a recording of a run, choose \"More\", then\n"
        "\"Save Recording\".\n",
        "Delete the files. To delete the scores and settings too, delete this page's data in the browser's settings.\n",
        true, false,
    },
    [EXPORT_LIBRETRO] = {
        "This is a core for RetroArch on Linux (x86-64). Copy @_libretro.so into RetroArch's cores folder\n"
        "and @_libretro.info into its core info folder. Settings > Directory shows where these folders are.\n"
        "Then choose Load Core, select the game, and choose Start Core. RetroArch's Controls menu lists the buttons.\n",
        "RetroArch stores scores in its folder for save files, and save states in its folder for save states.\n",
        "Delete the two files, and the save files and save states that are named after the game.\n",
        false, false,
    },
};

static void put_text(struct byte_buffer *out, const char *text, const char *id)
{
    for (; *text; text++)
        if (*text == '@')
            byte_buffer_print(out, "%s", id);
        else
            byte_buffer_byte(out, (uint8_t)*text);
}

/* Appends an action's keys to a list, without controller buttons, which F1 shows. */
static void add_keys(char *list, size_t size, const struct keys *k, int action)
{
    char text[128];

    keys_write_list(k, keys_action_name(action), text, sizeof text);
    for (char *word = strtok(text, " "); word; word = strtok(NULL, " ")) {
        const size_t n = strlen(list);
        if (strncmp(word, "pad", 3) != 0)
            snprintf(list + n, size - n, "%s%s", n ? ", " : "", word);
    }
}

/* Writes a line for each of n actions; consecutive actions with the same meaning share a line. */
static void put_keys(struct byte_buffer *out, const struct keys *k, int first, int n)
{
    const int player = PAD_BUTTON_COUNT; /* the meanings are those of player 1 */

    for (int i = 0, last; i < n; i = last) {
        char list[128] = "";
        const char *meaning = keys_action_help(first < player * MAX_PLAYERS ? i : first + i);
        for (last = i; last < n; last++) {
            if (strcmp(meaning, keys_action_help(first < player * MAX_PLAYERS ? last : first + last)) != 0)
                break;
            add_keys(list, sizeof list, k, first + last);
        }
        byte_buffer_print(out, "  %-24s%s\n", list, meaning);
    }
}

static void put_all_keys(struct byte_buffer *out, const struct manifest *m, bool window)
{
    static const enum hotkey shown[] = { HOTKEY_PAUSE,      HOTKEY_MENU,       HOTKEY_HELP,
                                         HOTKEY_FULLSCREEN, HOTKEY_SCREENSHOT, HOTKEY_QUIT };
    struct keys k;

    keys_set_defaults(&k);
    byte_buffer_print(out, "KEYS\n\n");
    for (int p = 0; p < m->players && p < MAX_PLAYERS; p++) {
        if (p > 0)
            byte_buffer_print(out, "\nPlayer %d:\n\n", p + 1);
        put_keys(out, &k, p * PAD_BUTTON_COUNT, PAD_BUTTON_COUNT);
    }
    byte_buffer_print(out, "\n");
    for (size_t i = 0; window && i < sizeof shown / sizeof *shown; i++)
        put_keys(out, &k, MAX_PLAYERS * PAD_BUTTON_COUNT + (int)shown[i], 1);
    byte_buffer_print(out, "%sControllers work too.%s\n\n", window ? "\n" : "",
                      window ? " You can change keys and buttons in the settings." : "");
}

void readme_write(struct byte_buffer *out, enum export_kind kind, const struct manifest *m)
{
    char title[sizeof m->title], author[sizeof m->author];

    snprintf(title, sizeof title, "%s", m->title);
    snprintf(author, sizeof author, "%s", m->author);
    clean_line(title);
    clean_line(author);
    byte_buffer_print(out, "%s\n", title);
    if (author[0])
        byte_buffer_print(out, "by %s\n", author);
    byte_buffer_print(out, "\nSTART\n\n");
    put_text(out, texts[kind].start, m->id);
    byte_buffer_print(out, "\n");
    if (texts[kind].keys)
        put_all_keys(out, m, texts[kind].window);
    byte_buffer_print(out, "SCORES, REPLAYS AND SETTINGS\n\n");
    put_text(out, texts[kind].saves, m->id);
    byte_buffer_print(out, "\nREMOVE\n\n");
    put_text(out, texts[kind].remove, m->id);
    byte_buffer_print(out, "\nMade with Curtain %s. licences.txt contains the licences of the included software.\n",
                      CURTAIN_VERSION);
}
