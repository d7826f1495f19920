/*
 * y4m.h - raw video as yuv4mpeg: 60 pictures a second, every pixel with brightness and both colours of its own (4:4:4).
 *
 * Colours are those of BT.601 in 16 to 235 (brightness) and 16 to 240, as readers take it that are told nothing else:
 *
 *     Y  =  16 + ( 16829 R + 33039 G +  6416 B) / 65536
 *     Cb = 128 + ( -9714 R - 19070 G + 28784 B) / 65536
 *     Cr = 128 + ( 28784 R - 24103 G -  4681 B) / 65536
 *
 * each rounded to the nearest, halves up. So each colour has one code, the same on every machine.
 */
#ifndef WORKBENCH_Y4M_H
#define WORKBENCH_Y4M_H

#include <stdint.h>
#include <stdio.h>

/* What was not written the stream remembers (ferror). */
void y4m_head(FILE *f, int w, int h);

/* pix: w x h palette indices, rows on end; colours are 0xRRGGBB. */
void y4m_picture(FILE *f, const uint8_t *pix, const uint32_t rgb[256], int w, int h);

#endif
