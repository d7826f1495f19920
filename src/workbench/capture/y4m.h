/*
 * y4m.h - writes raw video as yuv4mpeg: 60 pictures a second, 4:4:4.
 *
 * Colours are BT.601 with luma from 16 to 235 and chroma from 16 to 240, the default of readers:
 *
 *     Y  =  16 + ( 16829 R + 33039 G +  6416 B) / 65536
 *     Cb = 128 + ( -9714 R - 19070 G + 28784 B) / 65536
 *     Cr = 128 + ( 28784 R - 24103 G -  4681 B) / 65536
 *
 * each rounded to nearest, halves up, so the bytes are the same on every machine.
 */
#ifndef WORKBENCH_Y4M_H
#define WORKBENCH_Y4M_H

#include <stdint.h>
#include <stdio.h>

/* The caller checks ferror. */
void y4m_write_header(FILE *f, int w, int h);

/* pix: w x h palette indices, row by row; rgb: 0xRRGGBB. */
void y4m_write_picture(FILE *f, const uint8_t *pix, const uint32_t rgb[256], int w, int h);

#endif
