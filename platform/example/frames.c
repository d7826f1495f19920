/*
 * frames.c - plays a recorded run and writes a picture of it every N frames: frames GAME.rom RUN.demo N
 *
 *     cc frames.c $(pkg-config --cflags --libs curtain) -lm -o frames
 */
#include <curtain.h>
#include <stdio.h>
#include <stdlib.h>

#define STB_IMAGE_WRITE_IMPLEMENTATION
#include <stb/stb_image_write.h>

static void *read_file(const char *name, size_t *size)
{
    FILE *f = fopen(name, "rb");
    void *bytes = f && !fseek(f, 0, SEEK_END) ? malloc(*size = (size_t)ftell(f)) : NULL;

    if (!bytes || (rewind(f), fread(bytes, 1, *size, f) != *size))
        exit((perror(name), 1));
    fclose(f);
    return bytes;
}

static void write_picture(struct curtain *c)
{
    int n = curtain_width(c) * curtain_height(c);
    const unsigned char *pixels = curtain_picture(c);
    unsigned char *rgb = malloc(3 * (size_t)n);
    char name[32];

    for (int i = 0; i < 3 * n; i++)
        rgb[i] = (unsigned char)(curtain_palette(c)[pixels[i / 3]] >> (16 - 8 * (i % 3)));
    snprintf(name, sizeof name, "%06u.png", (unsigned)curtain_frames(c));
    stbi_write_png(name, curtain_width(c), curtain_height(c), 3, rgb, 0);
    free(rgb);
}

int main(int argc, char **argv)
{
    struct curtain_config config = { 0 };
    char err[256];

    if (argc != 4)
        return fprintf(stderr, "usage: frames GAME.rom RUN.demo N\n"), 2;
    config.rom = read_file(argv[1], &config.rom_size);
    config.demo = read_file(argv[2], &config.demo_size);
    size_t size = curtain_memory(&config, err, sizeof err);
    struct curtain *c = size ? curtain_open(&config, malloc(size), size, err, sizeof err) : NULL;
    if (!c)
        return fprintf(stderr, "frames: %s\n", err), 1;
    while (!(curtain_frame(c, NULL) & (CURTAIN_ENDED | CURTAIN_FAULT)))
        if (curtain_frames(c) % (unsigned)atoi(argv[3]) == 0)
            write_picture(c);
    printf("%u frames, %016llx\n", (unsigned)curtain_frames(c), (unsigned long long)curtain_hash(c));
    curtain_close(c);
    return 0;
}
