/*
 * palette_run.c - see art_run.h: `curtain palette`. A palette is saved as an indexed PNG with the game's palette, entry
 * for entry, so that an editor shows every bank.
 */
#include <stdio.h>
#include <stdlib.h>
#include "../../../platform/platform.h"
#include "../../common/files.h"
#include "../../common/report.h"
#include "../pack/art.h"
#include "../../player/picture/png.h"
#include "../../common/tree.h"
#include "art_run.h"
#include "swatch.h"

static bool is_swatch_file(const char *path)
{
    return files_has_suffix(path, ".hex") || files_has_suffix(path, ".gpl");
}

/* Reads the palette from a PNG. On failure, err is one sentence. */
static bool load_palette(const char *path, uint8_t rgb[CART_PALETTE_SIZE], char *err, size_t err_size)
{
    struct art_picture picture = { 0 };
    uint8_t *data;
    size_t n;
    char why[256];

    if (!files_read(path, path, TREE_FILE, &data, &n, err, err_size))
        return false;
    bool good = png_read(data, n, &picture.rgba, &picture.w, &picture.h, why, sizeof why) &&
                art_make_palette(&picture, rgb, why, sizeof why);
    free(data);
    art_picture_free(&picture);
    if (!good)
        snprintf(err, err_size, "%s: %s", path, why);
    return good;
}

static enum result save_palette(const char *path, const uint8_t rgb[CART_PALETTE_SIZE])
{
    uint8_t pix[256], *png;
    uint32_t colours[256];
    size_t size;

    for (int i = 0; i < 256; i++) {
        pix[i] = (uint8_t)i;
        colours[i] = (uint32_t)rgb[3 * i] << 16 | (uint32_t)rgb[3 * i + 1] << 8 | rgb[3 * i + 2];
    }
    png_write(pix, 16, 16, 16, colours, &png, &size);
    return report_save_png(path, png, size);
}

/* Imports a list into a palette. Other banks of an existing palette don't change. */
static enum result import_swatch(const char *from, int bank, const char *out)
{
    uint8_t rgb[CART_PALETTE_SIZE], *text;
    struct swatch s;
    char err[FILES_ERR_SIZE];
    size_t n;

    if (!files_read_text(from, from, SWATCH_MAX_FILE, &text, &n, err, sizeof err))
        return report_error(err);
    const bool good = swatch_read(&s, (const char *)text, n, from, files_has_suffix(from, ".gpl"), err, sizeof err);
    free(text);
    if (!good)
        return report_line(RESULT_REFUSED, "%s", err);
    if (files_size(out) < 0)
        art_default_palette(rgb);
    else if (!load_palette(out, rgb, err, sizeof err))
        return report_error(err);
    const int last = swatch_put(&s, bank, rgb);
    if (last > 15)
        return report_line(RESULT_REFUSED,
                           "%s: %d colours starting in bank %d would end in bank %d; the last bank is 15", from, s.n,
                           bank, last);
    const enum result result = save_palette(out, rgb);
    if (result != RESULT_DONE)
        return result;
    report_print(last > bank ? "%s: %d colour%s in banks %d to %d\n" : "%s: %d colour%s in bank %d\n", out, s.n,
                 s.n == 1 ? "" : "s", bank, last);
    return report_stdout(RESULT_DONE);
}

/* Exports a bank of a palette as a list. */
static enum result export_swatch(const char *from, int bank, const char *out)
{
    uint8_t rgb[CART_PALETTE_SIZE];
    char text[SWATCH_TEXT], err[FILES_ERR_SIZE];

    if (!load_palette(from, rgb, err, sizeof err))
        return report_error(err);
    const size_t n = swatch_write(rgb, bank, files_has_suffix(out, ".gpl"), text);
    return files_save(out, text, n, err, sizeof err) ? RESULT_DONE : report_line(RESULT_HOST_FAILED, "%s", err);
}

enum result art_run_palette(const char *from, int bank, const char *out)
{
    if (!out)
        return report_line(RESULT_REFUSED, "palette: expected -o FILE.png to change a palette, or -o FILE.gpl or "
                                           "-o FILE.hex to export one of its banks");
    if (bank < 0)
        return report_line(RESULT_REFUSED, "palette: expected --bank N, 0 to 15");
    if (is_swatch_file(from) && files_has_suffix(out, ".png"))
        return import_swatch(from, bank, out);
    if (files_has_suffix(from, ".png") && is_swatch_file(out))
        return export_swatch(from, bank, out);
    return report_line(RESULT_REFUSED, "palette: expected a .hex or .gpl file and -o FILE.png, or a .png file and "
                                       "-o FILE.gpl or -o FILE.hex");
}
