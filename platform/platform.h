/*
 * platform.h - the seam: all the cabinet asks of the machine it stands in. A port is one file that defines these
 * functions.
 *
 * To port: copy template.c, write its six functions. The others have defaults in stdio.c and in the host's two files
 * (posix.c, win.c, iso.c: see host.h). These are weak symbols (gcc and clang, ELF and Mach-O): to define one of them is
 * enough to override it. Where there are none, as on Windows, build these files with one -DPLAT_OWN_... for each
 * override, as -DPLAT_OWN_SOUND.
 *
 * A port has no logic and no table of keys: switches are raw numbers, the cabinet maps them. It includes this header
 * and nothing else of ours. Everything is called from one thread.
 *
 * What a port calls itself are the three functions of the program, below, and that only where the host has the loop:
 * elsewhere src/cab/main.c is the loop.
 */
#ifndef PLATFORM_PLATFORM_H
#define PLATFORM_PLATFORM_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>

enum {
    PLAT_KEYS = 256, /* keyboard switches: USB HID usages of page 7 (4 is A, 40 is Enter, 225 is left Shift) */
    PLAT_CONTROLLERS = 4,
    PLAT_TEXT = 64
};

/* Switches of a controller, named by where they are, as bit numbers. A stick or trigger pushed over halfway is a
 * switch. */
enum plat_switch {
    PLAT_DPAD_UP,
    PLAT_DPAD_DOWN,
    PLAT_DPAD_LEFT,
    PLAT_DPAD_RIGHT,
    PLAT_SOUTH,
    PLAT_EAST,
    PLAT_WEST,
    PLAT_NORTH,
    PLAT_SHOULDER_LEFT,
    PLAT_SHOULDER_RIGHT,
    PLAT_TRIGGER_LEFT,
    PLAT_TRIGGER_RIGHT,
    PLAT_START,
    PLAT_SELECT,
    PLAT_GUIDE,
    PLAT_STICK_LEFT, /* pressed in */
    PLAT_STICK_RIGHT,
    PLAT_LEFT_UP, /* the left stick's directions */
    PLAT_LEFT_DOWN,
    PLAT_LEFT_LEFT,
    PLAT_LEFT_RIGHT,
    PLAT_RIGHT_UP,
    PLAT_RIGHT_DOWN,
    PLAT_RIGHT_LEFT,
    PLAT_RIGHT_RIGHT,
    PLAT_SWITCHES
};

/* What is printed on a controller's buttons. Where they are does not depend on it: Nintendo's A is PLAT_EAST. */
enum plat_kind {
    PLAT_UNKNOWN,
    PLAT_XBOX,     /* A below, B on the right; Menu, View; and all that are lettered so */
    PLAT_XBOX_360, /* the same, with Start and Back */
    PLAT_PS3,
    PLAT_PS4,
    PLAT_PS5,
    PLAT_NINTENDO, /* B below, A on the right */
    PLAT_KINDS
};

struct plat_controller {
    uint32_t id; /* another one each time that one is plugged in */
    enum plat_kind kind;
    char name[64]; /* as the host calls it; "": not known */
};

struct plat_want {
    int w, h;  /* the picture */
    int scale; /* window pixels a picture pixel; 0: the largest that is comfortable on this screen */
    bool any;  /* with scale 0: it need be no whole number */
    bool fullscreen;
    bool vsync;        /* showing a picture is to wait until the screen takes it, if the port can and knows its rate */
    bool text;         /* plat_input.text is wanted; else input methods stay out of the way */
    const char *title; /* NULL: none */
    int rate;          /* sound frames a second; 0: no sound: no speaker is touched */
};

/* "Held" means down now, or pressed since the last poll, so that no tap is lost however slow the poll. */
struct plat_input {
    uint8_t keys[PLAT_KEYS / 8];            /* held: usage u is bit u & 7 of byte u >> 3 */
    uint32_t controllers[PLAT_CONTROLLERS]; /* held: bit numbers of enum plat_switch; 0 when there is none */
    bool quit;                              /* the host wants us gone: stays set */
    bool focus;                             /* keys reach us; a host that cannot tell says so always */
    bool hidden;                            /* nobody sees the window: it is minimised; false if that is not known */
    int mouse_x, mouse_y;                   /* pixels of what was shown last; -1, -1: not on it */
    uint8_t mouse;                          /* held: bit 0 left, 1 right, 2 middle */
    int wheel;                              /* notches since the last poll, up is positive */
    char text[PLAT_TEXT]; /* what was typed since the last poll: UTF-8, whole characters, ends in NUL */
};

static inline bool plat_key(const struct plat_input *in, unsigned usage)
{
    return in->keys[usage >> 3 & 31] >> (usage & 7) & 1;
}

/* ---- what a port calls, where the host has the loop ---- */

/* The program, with its arguments as those of main: "curtain", "play", a game, and so on. What has no window is done
 * when program_open returns. argv may be rearranged, and must last until program_close. Several may be open at once,
 * also of different games: what one of them asks of the port, it asks in these calls of its own. NULL: no memory. */
struct program;
struct program *program_open(int argc, char **argv);

/* Does what is due by plat_usec, and shows a picture if a frame was: to be called at each refresh of the screen, or
 * more often. False: it is over; close it. */
bool program_frame(struct program *program);

/* Ends it, in the middle as well, and gives back all that it took: a host that plays one game after another does not
 * grow. Returns the exit code. */
int program_close(struct program *program);

/* ---- the six of a port ---- */

/* Opens the window, or changes the open one to `want`: another picture, scale, title, or fullscreen. False after a
 * plat_log that says why. A missing sound card is not a failure. */
bool plat_open(const struct plat_want *want);

/* Gives everything back. Harmless when nothing is open. */
void plat_close(void);

/* Fills *in. Never blocks. */
void plat_poll(struct plat_input *in);

/* Shows a picture of palette indices; colours are 0xRRGGBB. Scaled by a whole number, the rest of the window black. */
void plat_show(const uint8_t *pix, int pitch, int w, int h, const uint32_t rgb[256]);

/* Microseconds from any fixed moment, never going back. Works before plat_open. Hosts with clock_gettime have defaults
 * for this and plat_wait. */
uint64_t plat_usec(void);

/* Returns when plat_usec() has reached `until`, or at once where the host has the loop. */
void plat_wait(uint64_t until);

/* ---- those with defaults ---- */

/* For plat_show of a port whose screen has no palette: out[y * out_pitch + x] = rgb[pix[y * pitch + x]]. out_pitch is
 * in pixels. What rgb holds is the port's: bits of its own beside 0xRRGGBB, or another order. */
void plat_rgb(uint32_t *out, int out_pitch, const uint8_t *pix, int pitch, int w, int h, const uint32_t rgb[256]);

/* For plat_open of a port with windows, and want->scale 0 or not: the window's size for want where there is room for so
 * many pixels, borders and title deducted. Scale 0 is the largest one that fits, a whole number or, with `any`, a
 * multiple of a quarter, and never less than 1. */
void plat_fit(const struct plat_want *want, int room_w, int room_h, int *w, int *h);

/* What is known of the open window; false: nothing. */
struct plat_window {
    int w, h;    /* pixels of what plat_paint fills */
    int refresh; /* of the screen it is on, in thousandths of a Hz; 0: unknown */
    bool waits;  /* showing a picture returns when the screen takes it, at a refresh */
};
bool plat_window(struct plat_window *out);

/* Shows a picture of full colours, 0xRRGGBB, over the whole window, stretched if it is not as large. pitch is in
 * pixels. False: the port only has plat_show. The cabinet asks for it where plat_window is known and there is more to
 * show than plat_show can: a picture turned, smooth, with lines, a border, or panels beside it. */
bool plat_paint(const uint32_t *rgb, int pitch, int w, int h);

/* Gives the open window an icon: bytes R G B A a pixel, a row after another. */
void plat_icon(const uint8_t *rgba, int w, int h);

/* The path of a file or folder that was dropped on the window since the last call; of several, the last. False: none
 * was. */
bool plat_dropped(char *path, size_t size);

/* Says what is plugged in as number i of plat_input.controllers, from 0. False: nothing. A number stays a controller's
 * while it is plugged in. The default knows of none: each is there, unknown, without a name, and never goes. */
bool plat_controller(int i, struct plat_controller *controller);

/* Writes what is printed on a key, in UTF-8, in the keyboard layout in use: "w" on the key of usage 29 of a French
 * keyboard. False, the default: not known, or a key that prints no character, and it is called as on a US keyboard. */
bool plat_key_label(unsigned usage, char *text, size_t size);

/* Queues stereo frames, all of them, or drops all when far too many wait. Returns how many were waiting before, those
 * that the card has taken and not played yet included, as far as that is known; 0: nothing was. -1: no speaker now.
 * With 0 frames it only says so. */
int plat_sound(const int16_t *lr, int frames);

/* Files. A name is a path as the user typed it, with / between folders, in UTF-8; `user:NAME` is NAME in the user's own
 * folder for Curtain (desktop: $XDG_DATA_HOME/curtain or ~/.local/share/curtain; Windows: %APPDATA%\curtain);
 * `pictures:NAME` is NAME in the folder Curtain of where the user keeps pictures (desktop: XDG_PICTURES_DIR, as the
 * environment or user-dirs.dirs says, or ~/Pictures; without a home, the current folder). Saving makes the folders a
 * name asks for. */

/* Replaces the host's other path separator by /: \ on Windows, nothing elsewhere. Call it for every path that comes
 * from the user or the host. */
void plat_slashes(char *path);

/* From now on the program is called so, 1 to 63 of a-z 0-9 _: user: is the folder curtain-NAME instead of curtain,
 * pictures: the folder NAME instead of Curtain, and a line of the log that would begin with "curtain: " begins with
 * "NAME: ". */
void plat_name(const char *name);

/* Shows a sentence in a window and waits until the user closes it; works before plat_open and after plat_close. The
 * default does nothing. */
void plat_alert(const char *text);

/* Writes a name by which the program's own file can be read, whatever it is called by now. False: the host does not
 * say. */
bool plat_program(char *name, size_t size);

/* Writes the name of a file that came with the program, by its path from the program's own folder, as
 * "../share/curtain/player.html"; whether it is there is another question. False: the host does not say where the
 * program is. */
bool plat_beside(const char *path, char *name, size_t size);

/* Writes the path of the program's own file, from the root, links followed. False: the host does not say. */
bool plat_program_path(char *path, size_t size);

/* Lets those who can read a file run it as a program; where there is no such thing, nothing. False: it cannot be. */
bool plat_runnable(const char *name);

/* Writes the path by which the user finds the file of a name, from the root where that can be told. False: there is
 * none, or it does not fit. */
bool plat_path(const char *name, char *path, size_t size);

/* Bytes of a file; -1: no such file (a folder is none). Of what is no file on a disk, such as a pipe: 0. */
long plat_size(const char *name);

/* Reads at most cap bytes from the start; returns how many, -1: cannot be read. */
long plat_load(const char *name, void *buf, size_t cap);

/* Opens a file for reading, or for writing, which empties it: for pipes, and for files that need not be replaced
 * atomically. NULL: errno may say why. */
FILE *plat_stream(const char *name, bool write);

/* Do two names lead to one file on a disk? Of two that are not there yet: would they, links followed, and the case of
 * letters left aside? A port that cannot tell compares the names. */
bool plat_same(const char *a, const char *b);

/* Replaces a whole file: afterwards it holds either this or, with false, what it held before. A symbolic link stays
 * one: what it leads to is replaced. A device or a pipe is written to. With false, errno may say why; so it may of
 * plat_append. */
bool plat_save(const char *name, const void *buf, size_t len);

/* Adds to a file's end, on its way to the disk when this returns. */
bool plat_append(const char *name, const void *buf, size_t len);

/* Removes a file; false: it is still there, or never was. */
bool plat_remove(const char *name);

struct plat_file {
    const char *name; /* without the folder */
    bool folder;
    int64_t time; /* of the last change; only good to compare */
};

/* Calls each for every entry of a folder, in any order, but . and .. ; returns how many, -1: cannot be read. */
int plat_list(const char *dir, void (*each)(void *user, const struct plat_file *file), void *user);

/* From now on, when the program is about to die of a fault of its own (POSIX: SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGABRT;
 * Windows: an exception that nothing handles, and abort), fn is called with context and what it was, as "SIGSEGV" or
 * "access violation", and may write a file by handing out its bytes: STEM-N.txt, with the first N from 1 on that is
 * free. Then a line says where that is, and the program dies as it would have. fn runs in a signal handler: it may read
 * memory and call `out`, and nothing else. stem is a name as that of a file; fn NULL: no more. The last call holds.
 * False: the host has nothing like it. */
bool plat_crash(const char *stem, void (*fn)(void *context, const char *what, void (*out)(const void *bytes, size_t n)),
                void *context);

/* For reports: what the port is made with, as "SDL 2.28.5, x11", or "no window" if nothing can be played in it; and
 * what it runs on, as "Linux 6.1.0 x86_64". */
void plat_about(char *text, size_t size);
void plat_system(char *text, size_t size);

/* One line, without its end, for whoever reads logs (desktop: stderr). */
void plat_log(const char *line);

/* ---- the host: its two files define these; without support they report failure ---- */

/* For ports: with true, closing the terminal or ending the session no longer ends the program immediately;
 * plat_hung_up reports it, and the port must set plat_input.quit. */
void plat_heed_hangup(bool on);
bool plat_hung_up(void);

/* True if standard error is a terminal on which a line can be overwritten. */
bool plat_terminal(void);

/* Writes `last` to standard error before the program ends by Ctrl+C or SIGTERM. NULL: nothing. */
void plat_last_word(const char *last);

/* A type of file that a double click opens with this program: files that end in .ENDING. */
struct plat_file_type {
    const char *ending; /* "rom" */
    const char *name;   /* the type's own name in the registry: "Curtain.Game" */
    const char *title;  /* for the user: "Curtain game" */
};

enum plat_registered {
    PLAT_NO_REGISTRY,    /* this host stores file types in another way */
    PLAT_NOT_REGISTERED, /* it failed; errno says why */
    PLAT_SECOND,         /* another program stays the default; this one can be chosen */
    PLAT_REGISTERED      /* or, with on = false, removed */
};

/* For the current user, and hosts with a registry of file types (Windows): with `on`, a double click on such a file
 * runs this program as `play FILE`, unless another program is the default; else removes what that call wrote. */
enum plat_registered plat_register(const struct plat_file_type *type, bool on);

/* True if a program of that name can be run. name: letters, digits and dashes. */
bool plat_has_command(const char *name);

/* Starts the program words[0] with these words, which end with NULL, and returns its standard input. One at a time.
 * From then on, writing to a pipe that nobody reads is an error, not a signal. NULL: it failed; errno may say why. */
FILE *plat_command_open(const char *const words[]);

/* True: everything was written and the program ended with exit code 0. */
bool plat_command_close(FILE *f);

/* A private temporary file, deleted by fclose. NULL: the host has none. */
FILE *plat_scratch(void);

/* Shared libraries. Opens a library for the rest of the process: "expat" of version 1 is libexpat.so.1 or
 * libexpat-1.dll. NULL: there is none. */
void *plat_library(const char *name, int version);

/* Writes where to get it, such as "Debian package: libexpat1". False: the host loads no libraries. */
bool plat_library_hint(const char *name, int version, char *text, size_t size);

/* Finds a function; `function` points to a function pointer. False: the library lacks it. */
bool plat_symbol(void *library, const char *name, void *function);

enum { PLAT_JOBS = 64 };

/* The number of processors, 1 to PLAT_JOBS. */
int plat_cores(void);

/* Work in pieces, from 0 to n - 1, up to `jobs` of them at a time: each in a process of its own where the host can copy
 * one, so that what it does to memory, and how it ends, is nobody else's; elsewhere one after another. */
struct plat_work {
    void *context;
    void (*work)(void *context, int i, FILE *out);
    void (*done)(void *context, int i, const char *text, size_t n,
                 int signal);     /* what it wrote; 0: it has ended well */
    void (*waits)(void *context); /* called a few times a second */
};

/* Returns when all is done. done is called in any order. False: no process, or no memory; some pieces are not done. */
bool plat_each(int n, int jobs, const struct plat_work *w);

#endif
