/*
 * template.c - the port to copy: it compiles, links and does nothing.
 *
 * Write these six functions for your host; platform.h has the contract of each. Games are playable once plat_show and
 * plat_poll work. Then, if the defaults in stdio.c do not suit, add any of plat_convert_to_rgb, plat_fit_window,
 * plat_get_window, plat_paint, plat_set_icon, plat_take_dropped_file, plat_key_label, plat_get_controller,
 * plat_queue_sound, plat_path, plat_file_size, plat_load, plat_open_stream, plat_is_same_file, plat_save, plat_append,
 * plat_remove, plat_list, plat_set_name, plat_program_file, plat_program_path, plat_alert, plat_installed_file,
 * plat_make_executable, plat_describe_build, plat_describe_system and plat_log to your file: the linker prefers yours.
 *
 * src/workbench/main.c is the main loop. If the host has the main loop, leave that file out of the link, and call
 * program_open, program_run_frame and program_close from here.
 */
#pragma GCC diagnostic ignored "-Wunused-parameter" /* remove this line when the functions use their parameters */

#include <string.h>
#include "platform.h"

static uint64_t now;

/* Open the window or the screen. Open the speaker if config->sound_rate is not 0, and continue without it if there is
 * none. If the port is already open, apply the settings that differ from the last call, such as fullscreen. */
bool plat_open(const struct plat_config *config)
{
    return true;
}

/* Undo plat_open. May be called twice, or without a plat_open. */
void plat_close(void)
{
}

/* Set a bit of in->keys for each held key, by its USB HID usage. Use two bitmaps, `down` for held keys and `seen` for
 * presses: report down | seen, then clear `seen`. Hosts with other key numbers need one table here that converts them
 * to HID usages. This function asks to quit, so that the program ends. */
void plat_poll(struct plat_input *in)
{
    memset(in, 0, sizeof *in);
    in->has_focus = true;
    in->mouse_x = in->mouse_y = -1;
    in->quit = true;
}

/* Write rgb[pix[y * pitch + x]] to the screen. Scale every pixel by the same whole number, centre the picture, and make
 * the rest black. For a screen with 32 bits per pixel, plat_convert_to_rgb converts a picture to colours. Hardware with
 * a palette of 256 colours takes pix and rgb directly. The function may wait for the vertical blank. */
void plat_show(const uint8_t *pix, int pitch, int w, int h, const uint32_t rgb[256])
{
}

/* Read a timer. This clock advances only in plat_wait, so everything runs as fast as possible. */
uint64_t plat_usec(void)
{
    return now;
}

/* Sleep until plat_usec() reaches `deadline`, accurate to a millisecond or better. */
void plat_wait(uint64_t deadline)
{
    if (deadline > now)
        now = deadline;
}
