/*
 * platform.h - the platform API: everything that Curtain needs from the host it runs on. A port is one C file that
 * defines these functions.
 *
 * To write a port, copy template.c and write its six functions. The other functions have defaults in stdio.c and in the
 * host's files (posix.c, win.c, iso.c and others; see host.h). The defaults are weak symbols (gcc and clang, ELF and
 * Mach-O), so a port overrides one by defining the same function. If there are no weak symbols, as on Windows, compile
 * the files with the defaults with one -DPLAT_OWN_... for each override, such as -DPLAT_OWN_QUEUE_SOUND.
 *
 * A port has no logic and no table of key bindings: it reports keys and buttons by number, and src/player maps them. It
 * includes this header and no other header of Curtain. All functions are called from one thread.
 *
 * On a host that has the main loop, the port calls the three program_ functions below. On other hosts,
 * src/workbench/main.c is the loop.
 */
#ifndef PLATFORM_PLATFORM_H
#define PLATFORM_PLATFORM_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>

enum {
    PLAT_KEYS = 256, /* keys of a keyboard: USB HID usages of page 7 (4 is A, 40 is Enter, 225 is left Shift) */
    PLAT_MAX_CONTROLLERS = 4,
    PLAT_TEXT_SIZE = 64
};

/* Buttons of a controller, named by position, as bit numbers. A stick or trigger pushed more than halfway counts as a
 * button. */
enum plat_button {
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
    PLAT_LEFT_STICK_PRESS, /* the left stick pressed in */
    PLAT_RIGHT_STICK_PRESS,
    PLAT_LEFT_STICK_UP, /* the left stick's directions */
    PLAT_LEFT_STICK_DOWN,
    PLAT_LEFT_STICK_LEFT,
    PLAT_LEFT_STICK_RIGHT,
    PLAT_RIGHT_STICK_UP,
    PLAT_RIGHT_STICK_DOWN,
    PLAT_RIGHT_STICK_LEFT,
    PLAT_RIGHT_STICK_RIGHT,
    PLAT_BUTTONS
};

/* The labels of a controller's buttons. A button's position does not depend on its label: Nintendo's A is PLAT_EAST. */
enum plat_controller_kind {
    PLAT_UNKNOWN_CONTROLLER,
    PLAT_XBOX,     /* A at the bottom, B on the right, Menu, View; also other controllers with this lettering */
    PLAT_XBOX_360, /* like PLAT_XBOX, with Start and Back */
    PLAT_PS3,
    PLAT_PS4,
    PLAT_PS5,
    PLAT_NINTENDO, /* B at the bottom, A on the right */
    PLAT_CONTROLLER_KINDS
};

struct plat_controller {
    uint32_t id; /* a different number each time a controller is plugged in */
    enum plat_controller_kind kind;
    char name[64]; /* the host's name for the controller; "": unknown */
};

struct plat_config {
    int w, h;        /* size of the picture in pixels */
    int scale;       /* window pixels per picture pixel; 0: the largest scale that fits the screen */
    bool fractional; /* with scale 0: allow a scale that is not a whole number */
    bool fullscreen;
    bool vsync;        /* wait for vertical sync, if the port supports it and knows the refresh rate */
    bool text_input;   /* fill in plat_input.text; false: keep input methods off */
    const char *title; /* title of the window; NULL: none */
    int sound_rate;    /* sound frames per second; 0: no sound, and no sound device is opened */
};

/* "Held" means down now or pressed since the last poll, so that no tap is lost however rare the polls are. */
struct plat_input {
    uint8_t keys[PLAT_KEYS / 8]; /* held keys: usage u is bit u & 7 of byte u >> 3 */
    /* Held buttons: bit n is value n of enum plat_button; 0: not connected. */
    uint32_t controllers[PLAT_MAX_CONTROLLERS];
    bool quit;                 /* the host asks the program to quit; once set, stays set */
    bool has_focus;            /* the window has keyboard focus; true if the host cannot tell */
    bool hidden;               /* the window is minimised or hidden; false if the host cannot tell */
    int mouse_x, mouse_y;      /* position in pixels of the last picture shown; -1, -1: outside it */
    uint8_t mouse_buttons;     /* held buttons: bit 0 left, 1 right, 2 middle */
    int wheel;                 /* notches since the last poll; up is positive */
    char text[PLAT_TEXT_SIZE]; /* text typed since the last poll: UTF-8, whole characters, NUL-terminated */
};

static inline bool plat_is_key_held(const struct plat_input *in, unsigned usage)
{
    return in->keys[usage >> 3 & 31] >> (usage & 7) & 1;
}

/* ---- the program, for ports whose host has the main loop ---- */

/* Starts the program with the arguments of main: "curtain", "play", a game, and so on. A command that needs no window
 * is finished when program_open returns. argv may be rearranged, and must stay valid until program_close. Several
 * programs may be open at once, also with different games; each calls the port only during its own program_ calls.
 * Returns NULL when out of memory. */
struct program;
struct program *program_open(int argc, char **argv);

/* Does the work that is due at plat_usec(), and shows a picture if a frame was due. Call it at each refresh of the
 * screen, or more often. Returns false when the program is over; then call program_close. */
bool program_run_frame(struct program *program);

/* Ends the program, also in the middle of a run, and frees everything it allocated, so that a host that plays one game
 * after another does not grow. Returns the exit code. */
int program_close(struct program *program);

/* ---- the six functions of a port ---- */

/* Opens the window, or changes the open window to `config`: a different picture size, scale, title, or fullscreen. On
 * failure, logs the reason with plat_log and returns false. A missing sound card is not a failure. */
bool plat_open(const struct plat_config *config);

/* Closes the window and releases everything. Does nothing when no window is open. */
void plat_close(void);

/* Fills in *in. Never blocks. */
void plat_poll(struct plat_input *in);

/* Shows a picture of palette indices; colours are 0xRRGGBB. The picture is scaled by a whole number, and the rest of
 * the window is black. */
void plat_show(const uint8_t *pix, int pitch, int w, int h, const uint32_t rgb[256]);

/* Returns microseconds since an arbitrary moment. Monotonic where the host has a monotonic clock. May be called before
 * plat_open. stdio.c has defaults for this and plat_wait. */
uint64_t plat_usec(void);

/* Returns when plat_usec() has reached `deadline`, or immediately if the host has the main loop. */
void plat_wait(uint64_t deadline);

/* ---- functions with defaults ---- */

/* Converts palette indices to colours, for plat_show of a port whose screen has no palette: out[y * out_pitch + x] =
 * rgb[pix[y * pitch + x]]. out_pitch is in pixels. The port chooses the format of the colours in rgb: it may set more
 * bits than 0xRRGGBB, or use a different order. */
void plat_convert_to_rgb(uint32_t *out, int out_pitch, const uint8_t *pix, int pitch, int w, int h,
                         const uint32_t rgb[256]);

/* Computes the window's size for `config`, for plat_open of a port with windows. max_w, max_h: pixels available for the
 * window's content, without borders and title. With config->scale 0, takes the largest scale that fits: a whole number
 * or, with config->fractional, a multiple of a quarter; at least 1. */
void plat_fit_window(const struct plat_config *config, int max_w, int max_h, int *w, int *h);

/* Facts about the open window. plat_get_window gets them, and returns false if none are known. */
struct plat_window {
    int w, h;         /* size in pixels of the area that plat_paint fills */
    int refresh_rate; /* refresh rate of the window's screen in thousandths of a Hz; 0: unknown */
    bool vsync;       /* showing a picture waits for vertical sync */
};
bool plat_get_window(struct plat_window *out);

/* Shows a picture of colours, 0xRRGGBB, over the whole window, stretched if the sizes differ. pitch is in pixels.
 * Returns false if the picture cannot be shown, or the port only has plat_show. Called if plat_get_window succeeds and
 * the player uses a feature that plat_show lacks: rotation, smooth scaling, a CRT filter, a border, or panels next to
 * the picture. */
bool plat_paint(const uint32_t *rgb, int pitch, int w, int h);

/* Sets the open window's icon: 4 bytes R, G, B, A per pixel, row by row. */
void plat_set_icon(const uint8_t *rgba, int w, int h);

/* Gets the path of a file or folder that was dropped on the window since the last call; of several, the last one.
 * Returns false if none was. */
bool plat_take_dropped_file(char *path, size_t size);

/* Describes controller i of plat_input.controllers, counted from 0. Returns false if there is none. A controller keeps
 * its number while it is plugged in. The default reports that all are plugged in at all times, with unknown kinds and
 * no names. */
bool plat_get_controller(int i, struct plat_controller *controller);

/* Writes a key's label in the current keyboard layout, in UTF-8: "w" or "W" for usage 29 on a French keyboard. Returns
 * false if the label is unknown or the key prints no character; the key is then named as on a US keyboard. The default
 * returns false. */
bool plat_key_label(unsigned usage, char *text, size_t size);

/* Queues all of these stereo frames, or drops all of them if far too many are waiting. Returns how many were waiting
 * before the call, including frames that the card has taken but not played, if known; 0: none; -1: there is no speaker
 * at present. With frames 0, only returns the number. */
int plat_queue_sound(const int16_t *lr, int frames);

/* Files. A name is a path as the user typed it, with / between folders, in UTF-8. `user:NAME` is NAME in the user's
 * folder for Curtain (desktop: $XDG_DATA_HOME/curtain or ~/.local/share/curtain; Windows: %APPDATA%\curtain).
 * `pictures:NAME` is NAME in the folder Curtain of the user's pictures folder (desktop: XDG_PICTURES_DIR from the
 * environment or user-dirs.dirs, or ~/Pictures; without a home, the current folder). Saving creates the folders in a
 * name. */

/* Replaces the host's other path separator with /: \ on Windows, none elsewhere. Call it for every path that comes from
 * the user or the host. */
void plat_normalize_slashes(char *path);

/* Sets the program's name: 1 to 63 characters of a-z 0-9 _. From then on, user: is the folder curtain-NAME instead of
 * curtain, pictures: is the folder NAME instead of Curtain, and NAME replaces curtain in log lines that start with
 * "curtain: ". */
void plat_set_name(const char *name);

/* Shows a message box and waits until the user closes it. Works before plat_open and after plat_close. The default does
 * nothing. */
void plat_alert(const char *text);

/* Writes a name under which the program's own file can be read, if possible even after the file was renamed. Returns
 * false if the host does not know the name. */
bool plat_program_file(char *name, size_t size);

/* Writes the name of a file that was installed with the program, given its path from the program's folder, such as
 * "../share/curtain/player.html". The file may not exist. Returns false if the host does not know where the program
 * is. */
bool plat_installed_file(const char *path, char *name, size_t size);

/* Writes the absolute path of the program's own file, on POSIX with links resolved. Returns false if the host does not
 * know it. */
bool plat_program_path(char *path, size_t size);

/* Makes a file executable for everyone who can read it; does nothing on hosts without such a permission. Returns false
 * on failure. */
bool plat_make_executable(const char *name);

/* Writes the path under which the user finds a file, absolute if the host can tell. Returns false if there is no such
 * path or it does not fit. */
bool plat_path(const char *name, char *path, size_t size);

/* Returns the size of a file in bytes, or -1 if there is no such file (a folder is not a file). The size of a pipe or
 * device is 0. */
long plat_file_size(const char *name);

/* Reads at most cap bytes from the start of a file. Returns the number of bytes read, or -1 if the file cannot be
 * read. */
long plat_load(const char *name, void *buf, size_t cap);

/* Opens a file for reading, or for writing, which empties it: for pipes, and for files that need not be replaced
 * atomically. Returns NULL on failure; errno may have the reason. */
FILE *plat_open_stream(const char *name, bool for_writing);

/* Returns whether two names refer to the same file on a disk. If neither exists, returns whether they would, with links
 * followed and the case of letters ignored. A port that cannot tell compares the names. */
bool plat_is_same_file(const char *a, const char *b);

/* Replaces a whole file. Afterwards the file holds the new data, or its old data if this returns false. A symbolic link
 * stays, and its target is replaced. A device or a pipe is written to. If this or plat_append returns false, errno may
 * have the reason. */
bool plat_save(const char *name, const void *buf, size_t len);

/* Appends to a file, and hands the data to the host before returning, without waiting for the disk. */
bool plat_append(const char *name, const void *buf, size_t len);

/* Removes a file. Returns false if the file cannot be removed or did not exist. */
bool plat_remove(const char *name);

struct plat_folder_entry {
    const char *name; /* the file's name without its folder */
    bool is_folder;
    int64_t time; /* time of the last change, in host-dependent units; good only for comparisons */
};

/* Calls `visit` for every entry of a folder except . and .., in any order. Returns the number of entries, or -1 if the
 * folder cannot be read. */
int plat_list(const char *dir, void (*visit)(void *user, const struct plat_folder_entry *file), void *user);

/* Write, for reports, what the port is built with, such as "SDL 2.28.5, x11", or "no window" if it cannot play games;
 * and what it runs on, such as "Linux 6.1.0 x86_64". */
void plat_describe_build(char *text, size_t size);
void plat_describe_system(char *text, size_t size);

/* Logs one line, given without its newline (desktop: to stderr). */
void plat_log(const char *line);

/* ---- the host: defined in the host's files (host.h); without support they report failure ---- */

/* For ports. With `on`, closing the terminal or ending the session no longer ends the program immediately;
 * plat_has_hung_up reports it, and the port must set plat_input.quit. */
void plat_catch_hangup(bool on);
bool plat_has_hung_up(void);

/* Returns whether standard error is a terminal on which a line can be overwritten. */
bool plat_has_terminal(void);

/* Sets the text that is written to standard error when Ctrl+C or SIGTERM ends the program. The text must stay valid.
 * NULL: none. */
void plat_set_exit_text(const char *text);

/* A file type that this program opens on a double click: files that end in .ENDING. */
struct plat_file_type {
    const char *extension; /* "rom" */
    const char *name;      /* the type's name in the registry: "Curtain.Game" */
    const char *title;     /* the name shown to users: "Curtain game" */
};

enum plat_register_result {
    PLAT_NO_REGISTRY,    /* not supported: this host stores file types in another way */
    PLAT_NOT_REGISTERED, /* failed; errno has the reason */
    PLAT_NOT_DEFAULT,    /* registered, but another program remains the default; users can choose this one */
    PLAT_REGISTERED      /* registered; with on = false, removed */
};

/* Registers a file type for the current user, on hosts with a registry of file types (Windows). With `on`, a double
 * click on such a file runs this program as `play FILE`, unless another program is the default. Without `on`, removes
 * what registering wrote. */
enum plat_register_result plat_register_type(const struct plat_file_type *type, bool on);

/* Returns whether a program of that name can be run. name: letters, digits and dashes. */
bool plat_has_command(const char *name);

/* Starts the program args[0] with the arguments args, which end with NULL, and returns a stream to its standard input.
 * Only one program can run at a time. Until plat_command_close, writing to a pipe that nobody reads is an error, not a
 * signal. Returns NULL on failure; errno may have the reason. */
FILE *plat_command_open(const char *const args[]);

/* Closes the stream and waits for the program to end. Returns whether everything was written and the program ended with
 * exit code 0. */
bool plat_command_close(FILE *f);

/* Shared libraries. Opens a library for the rest of the process: "sndfile" of version 1 is libsndfile.so.1 or
 * libsndfile-1.dll. Returns NULL if the library is not found. */
void *plat_open_library(const char *name, int version);

/* Writes how to install the library, such as "Debian package: libsndfile1". Returns false if the host cannot load
 * libraries. */
bool plat_library_hint(const char *name, int version, char *text, size_t size);

/* Finds a function in a library; `function` points to the function pointer to set. Returns false if the library does
 * not have the function. */
bool plat_find_symbol(void *library, const char *name, void *function);

enum { PLAT_MAX_JOBS = 64 };

/* Returns the number of processors, 1 to PLAT_MAX_JOBS. */
int plat_processor_count(void);

/* The callbacks of n jobs, 0 to n - 1, of which up to `max_jobs` run at a time. On hosts with fork, each job runs in a
 * separate process, so that its changes to memory and its crashes affect nothing else. On other hosts, the jobs run one
 * after another in this process. */
struct plat_job_callbacks {
    void *context;
    void (*run)(void *context, int i, FILE *write);
    void (*on_done)(void *context, int i, const char *text, size_t n,
                    int signal);    /* text: the job's output; signal: 0 if it succeeded */
    void (*on_wait)(void *context); /* called a few times a second, or after each job */
};

/* Runs all jobs, and returns when they are done. `on_done` is called in any order. Returns false if a process cannot be
 * started or memory runs out; some jobs are then not run. */
bool plat_run_jobs(int n, int max_jobs, const struct plat_job_callbacks *w);

#endif
