/*
 * abi.h - version 1 of the libretro interface: the numbers, types and functions that this core uses. Source: the
 * documentation of libretro.h at docs.libretro.com.
 */
#ifndef PORTS_LIBRETRO_ABI_H
#define PORTS_LIBRETRO_ABI_H

#include <stdarg.h>
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#if defined _WIN32
#define RETRO_API __declspec(dllexport)
#else
#define RETRO_API __attribute__((visibility("default")))
#endif

enum {
    RETRO_API_VERSION = 1,
    RETRO_REGION_NTSC = 0,
    RETRO_DEVICE_JOYPAD = 1,
    RETRO_MEMORY_SAVE_RAM = 0,
    RETRO_PIXEL_FORMAT_XRGB8888 = 1
};

/* Buttons of a pad, named as on a Super Nintendo controller. */
enum {
    RETRO_B,
    RETRO_Y,
    RETRO_SELECT,
    RETRO_START,
    RETRO_UP,
    RETRO_DOWN,
    RETRO_LEFT,
    RETRO_RIGHT,
    RETRO_A,
    RETRO_X,
    RETRO_L,
    RETRO_R,
    RETRO_BUTTONS
};

/* Commands of the environment callback, each with the type of its data argument. */
enum {
    RETRO_SHUTDOWN = 7,             /* NULL */
    RETRO_SET_PIXEL_FORMAT = 10,    /* const int *: RETRO_PIXEL_FORMAT_XRGB8888 */
    RETRO_SET_INPUTS = 11,          /* const struct retro_input *: an array that ends with an all-zero entry */
    RETRO_GET_VARIABLE = 15,        /* struct retro_variable *: fills in the value */
    RETRO_SET_SUPPORT_NO_GAME = 18, /* const bool *: whether the core runs without content */
    RETRO_SET_VARIABLES = 16,       /* const struct retro_variable *: an array that ends with an all-NULL entry */
    RETRO_GET_VARIABLE_UPDATE = 17, /* bool *: set to whether an option changed since options were last read */
    RETRO_GET_LOG = 27,             /* struct retro_log * */
    RETRO_GET_SAVE_DIRECTORY = 31,  /* const char ** */
    RETRO_SET_MESSAGE = 6           /* const struct retro_message * */
};

struct retro_variable {
    const char *key, *value; /* for RETRO_SET_VARIABLES: "Description; first|second"; the first value is the default */
};
struct retro_input {
    unsigned port, device, index, id;
    const char *description;
};
struct retro_message {
    const char *text;
    unsigned frames;
};
enum retro_level { RETRO_DEBUG, RETRO_INFO, RETRO_WARN, RETRO_ERROR };
struct retro_log {
    void (*print)(enum retro_level level, const char *format, ...);
};

struct retro_system_info {
    const char *name, *version, *extensions; /* "rom" */
    bool need_fullpath, block_extract;
};
struct retro_geometry {
    unsigned width, height, max_width, max_height;
    float aspect;
};
struct retro_timing {
    double frames, samples; /* per second */
};
struct retro_av_info {
    struct retro_geometry geometry;
    struct retro_timing timing;
};
struct retro_game {
    const char *path;
    const void *data;
    size_t size;
    const char *meta;
};

typedef bool retro_environment(unsigned command, void *data);
typedef void retro_video(const void *pixels, unsigned w, unsigned h, size_t pitch); /* pixels NULL: no change */
typedef size_t retro_audio(const int16_t *lr, size_t frames);
typedef void retro_sample(int16_t left, int16_t right);
typedef void retro_poll(void);
typedef int16_t retro_input_state(unsigned port, unsigned device, unsigned index, unsigned id);

RETRO_API void retro_set_environment(retro_environment *f);
RETRO_API void retro_set_video_refresh(retro_video *f);
RETRO_API void retro_set_audio_sample(retro_sample *f);
RETRO_API void retro_set_audio_sample_batch(retro_audio *f);
RETRO_API void retro_set_input_poll(retro_poll *f);
RETRO_API void retro_set_input_state(retro_input_state *f);
RETRO_API void retro_init(void);
RETRO_API void retro_deinit(void);
RETRO_API unsigned retro_api_version(void);
RETRO_API void retro_get_system_info(struct retro_system_info *info);
RETRO_API void retro_get_system_av_info(struct retro_av_info *info);
RETRO_API void retro_set_controller_port_device(unsigned port, unsigned device);
RETRO_API void retro_reset(void);
RETRO_API void retro_run(void);
RETRO_API size_t retro_serialize_size(void);
RETRO_API bool retro_serialize(void *data, size_t size);
RETRO_API bool retro_unserialize(const void *data, size_t size);
RETRO_API void retro_cheat_reset(void);
RETRO_API void retro_cheat_set(unsigned index, bool on, const char *code);
RETRO_API bool retro_load_game(const struct retro_game *game);
RETRO_API bool retro_load_game_special(unsigned type, const struct retro_game *games, size_t n);
RETRO_API void retro_unload_game(void);
RETRO_API unsigned retro_get_region(void);
RETRO_API void *retro_get_memory_data(unsigned id);
RETRO_API size_t retro_get_memory_size(unsigned id);

#endif
