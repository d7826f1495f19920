/*
 * test_png_frame.c - a PNG holds exactly the framebuffer: its indices and its 256 colours, as a reader that shares
 * nothing with the engine (tests/cli/png_read.py) finds them; and `curtain render` writes that very file.
 */
#include "rig.h"

#include <unistd.h>
#include "../../src/player/picture/png.h"

static char dir[] = "/tmp/png_frame.XXXXXX";

static void save(const char *path, const void *data, size_t size)
{
    FILE *f = fopen(path, "wb");

    assert_non_null(f);
    assert_int_equal(fwrite(data, 1, size, f), size);
    assert_int_equal(fclose(f), 0);
}

/* What the reader says of the file must be this picture. */
static void assert_read_back(const char *path, const struct fb *fb, const uint32_t rgb[256])
{
    enum { ROOM = 1 << 21 };
    char command[256], head[32];
    uint8_t *got = malloc(ROOM), *want = malloc(ROOM), *p = want;

    snprintf(command, sizeof command, "python3 tests/cli/png_read.py %s", path);
    FILE *reader = popen(command, "r");
    assert_non_null(reader);
    size_t n = fread(got, 1, ROOM, reader);
    assert_int_equal(pclose(reader), 0);
    p += snprintf(head, sizeof head, "%d %d 3\n", fb->w, fb->h);
    memcpy(want, head, (size_t)(p - want));
    for (int i = 0; i < 256; i++) {
        *p++ = (uint8_t)(rgb[i] >> 16);
        *p++ = (uint8_t)(rgb[i] >> 8);
        *p++ = (uint8_t)rgb[i];
    }
    for (int y = 0; y < fb->h; y++, p += fb->w)
        memcpy(p, fb->pix + (ptrdiff_t)y * fb->pitch, (size_t)fb->w);
    assert_int_equal(n, p - want);
    assert_memory_equal(got, want, n);
    free(got);
    free(want);
}

/* The program's own file of the same frame has the same bytes. */
static void assert_rendered(const char *game, uint32_t frame, const uint8_t *png, size_t size)
{
    const char *out = getenv("OUT");
    char command[512], path[128];
    uint8_t *got = malloc(size + 2);

    snprintf(command, sizeof command, "%s/curtain-null render roms/%s --seed 1 --frames %u -o %s 2>/dev/null",
             out ? out : "build/release", game, (unsigned)frame, dir);
    assert_int_equal(system(command), 0);
    snprintf(path, sizeof path, "%s/%06u.png", dir, (unsigned)frame);
    FILE *f = fopen(path, "rb");
    assert_non_null(f);
    assert_int_equal(fread(got, 1, size + 2, f), size);
    fclose(f);
    assert_memory_equal(got, png, size);
    remove(path);
    free(got);
}

static void check_frame(struct rig *r, const char *game)
{
    char path[128];
    uint32_t rgb[256];
    uint8_t *png;
    size_t size;

    board_draw(r->b, NULL, &r->fb, rgb, r->scratch);
    assert_true(png_write(r->fb.pix, r->fb.pitch, r->fb.w, r->fb.h, rgb, &png, &size));
    snprintf(path, sizeof path, "%s/frame.png", dir);
    save(path, png, size);
    assert_read_back(path, &r->fb, rgb);
    assert_rendered(game, board_frame(r->b), png, size);
    remove(path);
    free(png);
}

TEST(game)
{
    struct rig_game game;
    struct rig r;

    rig_folder(&game, "testcard");
    rig_power(&r, &game, NULL);
    check_frame(&r, "testcard");
    rig_run(&r, 200);
    check_frame(&r, "testcard");
    rig_close(&r);
}

/* Every index, every pixel different from its neighbours, a width that is no multiple of anything. */
TEST(all_indices)
{
    enum { W = 67, H = 41 };
    uint8_t *mem = malloc(fb_size(W, H)), *png;
    char path[128];
    uint32_t rgb[256];
    struct fb fb;
    struct rng rng;
    size_t size;

    fb_init(&fb, mem, W, H);
    rng_seed(&rng, 3);
    for (int i = 0; i < 256; i++)
        rgb[i] = (uint32_t)rng_next(&rng) & 0xffffff;
    for (int i = 0; i < W * H; i++)
        fb.pix[i / W * fb.pitch + i % W] = (uint8_t)(i * 167 + i / 256);
    assert_true(png_write(fb.pix, fb.pitch, W, H, rgb, &png, &size));
    snprintf(path, sizeof path, "%s/all.png", dir);
    save(path, png, size);
    assert_read_back(path, &fb, rgb);
    remove(path);
    free(png);
    free(mem);
}

static int make_folder(void **state)
{
    (void)state;
    return mkdtemp(dir) ? 0 : -1;
}

static int drop_folder(void **state)
{
    char command[64];

    (void)state;
    snprintf(command, sizeof command, "rm -rf %s", dir);
    return system(command);
}

RUN_TESTS(make_folder, drop_folder)
