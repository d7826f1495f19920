/* test_stdio.c - the defaults of the platform seam: files, folders. Works in a folder of its own under TMPDIR. */
#define _XOPEN_SOURCE 700
#include <fcntl.h>
#include <signal.h>
#include <sys/stat.h>
#include <sys/sysmacros.h>
#include <sys/wait.h>
#include <unistd.h>
#include "../test.h"
#include "../../platform/platform.h"
#include "../../src/base/rng.h"
#include "../temp.h"

static char home[512], name[1024];

static int into_folder(void **state)
{
    (void)state;
    return temp_folder(home, sizeof home, "curtain-test") && chdir(home) == 0 && setenv("XDG_DATA_HOME", home, 1) == 0
               ? 0
               : -1;
}

static int out_of_folder(void **state)
{
    (void)state;
    snprintf(name, sizeof name, "rm -rf '%s'", home);
    return chdir("/") == 0 && system(name) == 0 ? 0 : -1;
}

static void fits(int picture_w, int picture_h, int scale, bool any, int room_w, int room_h, int want_w, int want_h)
{
    const struct plat_config want = { .w = picture_w, .h = picture_h, .scale = scale, .fractional = any };
    int w, h;

    plat_fit_window(&want, room_w, room_h, &w, &h);
    assert_int_equal(w, want_w);
    assert_int_equal(h, want_h);
}

/* The largest size that fits, and no larger one does; never less than the picture. */
TEST(windows_fit)
{
    struct rng r;

    fits(240, 320, 0, false, 1916, 1010, 720, 960);
    fits(240, 320, 2, false, 1916, 1010, 480, 640);
    fits(240, 320, 9, true, 1916, 1010, 2160, 2880); /* what was asked for is given */
    fits(480, 640, 0, true, 1916, 1010, 720, 960);
    fits(64, 64, 0, true, 0, -10, 64, 64);
    rng_seed(&r, 6);
    for (int i = 0; i < 10000; i++) {
        const struct plat_config want = { .w = 64 + 8 * (int)rng_below(&r, 120),
                                          .h = 64 + 8 * (int)rng_below(&r, 120),
                                          .fractional = i % 2 };
        const int room_w = 200 + (int)rng_below(&r, 4200), room_h = room_w * 9 / 16;
        int w, h;
        plat_fit_window(&want, room_w, room_h, &w, &h);
        assert_true((w <= room_w && h <= room_h) || (w == want.w && h == want.h));
        assert_true(want.fractional || (w % want.w == 0 && h % want.h == 0));
        const int quarters = 4 * w / want.w + (want.fractional ? 1 : 4); /* the next size does not fit */
        assert_true(want.w * quarters > 4 * room_w || want.h * quarters > 4 * room_h);
    }
}

TEST(save_load_append)
{
    char buf[16] = { 0 };
    assert_int_equal(plat_file_size("a"), -1);
    assert_int_equal(plat_load("a", buf, sizeof buf), -1);
    assert_true(plat_save("a", "hello", 5));
    assert_int_equal(plat_load("a", buf, 3), 3);
    assert_int_equal(plat_load("a", buf, sizeof buf), 5);
    assert_memory_equal(buf, "hello", 5);
    assert_true(plat_append("a", "!!", 2) && plat_append("b", "new", 3));
    assert_int_equal(plat_file_size("a"), 7);
    assert_int_equal(plat_file_size("b"), 3);
    assert_true(plat_save("a", "", 0));
    assert_int_equal(plat_file_size("a"), 0);
}

/* What is no regular file is written to and stays what it is; reading one is refused, not waited for. */
TEST(devices_and_pipes)
{
    struct stat st;
    char buf[16];
    /* root can make devices, and would lose the host's own to a save that replaces them; nobody else can */
    const char *null = mknod("null", S_IFCHR | 0600, makedev(1, 3)) == 0 ? "null" : "/dev/null";
    const char *full = mknod("full", S_IFCHR | 0600, makedev(1, 7)) == 0 ? "full" : "/dev/full";
    assert_true(plat_save(null, "gone", 4));
    assert_true(stat(null, &st) == 0 && S_ISCHR(st.st_mode));
    assert_int_equal(plat_load(null, buf, sizeof buf), -1);
    assert_false(plat_save(full, "no room", 7));
    assert_int_equal(mkfifo("fifo", 0600), 0);
    assert_int_equal(plat_file_size("fifo"), 0);
    assert_int_equal(plat_load("fifo", buf, sizeof buf), -1);
    int reader = open("fifo", O_RDONLY | O_NONBLOCK);
    assert_true(plat_save("fifo", "piped", 5));
    assert_int_equal(read(reader, buf, sizeof buf), 5);
    close(reader);
    assert_true(stat("fifo", &st) == 0 && S_ISFIFO(st.st_mode));
    assert_int_equal(mkdir("folder", 0777), 0);
    assert_false(plat_save("folder", "x", 1));
    assert_int_equal(plat_file_size("folder"), -1);
}

static bool is_link(const char *path)
{
    struct stat st;
    return lstat(path, &st) == 0 && S_ISLNK(st.st_mode);
}

TEST(links_stay)
{
    char far[700], buf[8];
    struct stat st;
    assert_true(plat_save("d/real", "old", 3));
    assert_int_equal(chmod("d/real", 0640), 0);
    assert_int_equal(symlink("real", "d/near"), 0);
    assert_int_equal(symlink("d/near", "chain"), 0);
    assert_true(plat_save("chain", "newer", 5));
    assert_true(is_link("chain") && is_link("d/near") && !is_link("d/real"));
    assert_int_equal(plat_load("d/real", buf, sizeof buf), 5);
    assert_int_equal(stat("d/real", &st), 0);
    assert_int_equal(st.st_mode & 0777, 0640);
    snprintf(far, sizeof far, "%s/e/there", home);
    assert_int_equal(symlink(far, "dangling"), 0);
    assert_true(plat_save("dangling", "made", 4));
    assert_true(is_link("dangling"));
    assert_int_equal(plat_file_size("e/there"), 4);
    assert_int_equal(symlink("loop", "loop"), 0);
    assert_false(plat_save("loop", "x", 1));
    assert_true(is_link("loop"));
}

TEST(folders_are_made)
{
    assert_true(plat_save("x/y/z", "1", 1));
    assert_int_equal(plat_file_size("x/y/z"), 1);
    assert_int_equal(plat_file_size("x/y"), -1);
    assert_int_equal(plat_load("x/y", name, 1), -1);
    assert_true(plat_save("user:game.nv", "12", 2));
    assert_int_equal(plat_file_size("curtain/game.nv"), 2);
}

static void is_below(const char *below, const char *file)
{
    char want[4096], path[4096];
    snprintf(want, sizeof want, "%s%s", home, below);
    assert_true(plat_path(file, path, sizeof path));
    assert_string_equal(path, want);
}

/* The program's own file is there under the name it says; a file that could be read can be run. */
TEST(programs)
{
    char own[256];
    struct stat st;

    assert_true(plat_program_file(own, sizeof own) && plat_file_size(own) > 1000);
    assert_false(plat_program_file(own, 3));
    assert_true(plat_save("tool", "x", 1) && chmod("tool", 0640) == 0);
    assert_true(plat_make_executable("tool") && stat("tool", &st) == 0);
    assert_int_equal(st.st_mode & 0777, 0750);
    assert_false(plat_make_executable("none"));
}

/* The file that a save goes by way of is a new one: another's of that name stays. */
TEST(temporary_files_are_new)
{
    char temp[64], read[8];
    snprintf(temp, sizeof temp, "saved.%ld.tmp", (long)getpid());
    assert_true(plat_save(temp, "mine", 4) && plat_save("saved", "new", 3));
    assert_int_equal(plat_load(temp, read, sizeof read), 4);
    assert_int_equal(plat_load("saved", read, sizeof read), 3);
}

/* The environment, then user-dirs.dirs, then ~/Pictures; without a home the current folder. */
TEST(the_users_pictures)
{
    static const char *const dirs[][2] = {
        { "# written by xdg-user-dirs-update\nXDG_MUSIC_DIR=\"$HOME/Music\"\nXDG_PICTURES_DIR=\"$HOME/My \\\"B\\\"\"\n",
          "/My \"B\"/Curtain/a.png" },
        { "XDG_PICTURES_DIR=\"$HOME/pictures\"\nXDG_PICTURES_DIRS=\"/x\"\n", "/pictures/Curtain/a.png" },
        { "XDG_PICTURES_DIR=\"relative\"\n", "/Pictures/Curtain/a.png" },
        { "XDG_PICTURES_DIR=\"/unclosed", "/Pictures/Curtain/a.png" },
    };
    unsetenv("XDG_PICTURES_DIR");
    unsetenv("HOME");
    is_below("/a.png", "pictures:a.png");
    setenv("HOME", home, 1);
    is_below("/Pictures/Curtain/a.png", "pictures:a.png");
    for (size_t i = 0; i < sizeof dirs / sizeof *dirs; i++) {
        assert_true(plat_save(".config/user-dirs.dirs", dirs[i][0], strlen(dirs[i][0])));
        is_below(dirs[i][1], "pictures:a.png");
    }
    setenv("XDG_PICTURES_DIR", home, 1);
    is_below("/Curtain/a.png", "pictures:a.png");
    plat_set_name("lanterns");
    is_below("/lanterns/a.png", "pictures:a.png");
    is_below("/curtain-lanterns/a.nv", "user:a.nv");
    plat_set_name("");
    unsetenv("XDG_PICTURES_DIR");
}

TEST(the_users_folder)
{
    char path[4096];
    is_below("/some/file.lua", "some/file.lua");
    is_below("/curtain/game.nv", "user:game.nv");
    assert_true(plat_path("/abc", path, 5));
    assert_false(plat_path("/abc", path, 4));
    setenv("XDG_DATA_HOME", "relative", 1);
    is_below("/.local/share/curtain/h", "user:h");
    unsetenv("HOME");
    assert_false(plat_path("user:h", path, sizeof path));
    assert_false(plat_save("user:h", "123", 3));
    setenv("XDG_DATA_HOME", home, 1);
}

/* From the program's own folder, upwards too; further than the root there is nothing. */
TEST(what_is_beside)
{
    char program[512], path[512], up[600], tight[8];
    const ssize_t n = readlink("/proc/self/exe", program, sizeof program - 1);
    assert_true(n > 0);
    program[n] = 0;
    char *const file = strrchr(program, '/') + 1;
    assert_true(plat_installed_file(file, path, sizeof path));
    assert_string_equal(path, program);
    file[-1] = 0;
    *strrchr(program, '/') = 0;
    snprintf(up, sizeof up, "%s/share/curtain/a.html", program);
    assert_true(plat_installed_file("../share/curtain/a.html", path, sizeof path));
    assert_string_equal(path, up);
    assert_false(plat_installed_file("a file", tight, sizeof tight));
    assert_false(plat_installed_file("../../../../../../../../../../../../../../../../../../../../../../../a", path,
                                     sizeof path));
}

static void count(void *user, const struct plat_folder_entry *file)
{
    int *seen = user;
    assert_true(file->time > 0);
    seen[0] += strcmp(file->name, "one") == 0 && !file->is_folder;
    seen[1] += strcmp(file->name, "sub") == 0 && file->is_folder;
}

/* A link to a folder is not listed, nor a broken one. */
TEST(listing)
{
    int seen[2] = { 0 };
    assert_true(plat_save("list/one", "1", 1));
    assert_true(plat_save("list/sub/two", "1", 1));
    assert_int_equal(symlink("sub", "list/folder"), 0);
    assert_int_equal(symlink("nowhere", "list/broken"), 0);
    assert_int_equal(plat_list("list", count, seen), 2);
    assert_int_equal(seen[0], 1);
    assert_int_equal(seen[1], 1);
    assert_int_equal(plat_list("list/none", count, seen), -1);
    assert_true(plat_remove("list/one"));
    assert_false(plat_remove("list/one"));
}

/* What cannot be replaced stays, and no half file is left beside it. */
TEST(a_failed_save_leaves_all)
{
    int seen[2] = { 0 };
    assert_true(plat_save("dir/taken/file", "1", 1));
    assert_false(plat_save("dir/taken", "22", 2)); /* a folder is in the way */
    assert_int_equal(plat_file_size("dir/taken/file"), 1);
    assert_int_equal(plat_list("dir", count, seen), 1);
}

/* Sizes, pitches and places of any kind: as pixel by pixel, and nothing between the rows. */
TEST(pictures_become_colours)
{
    enum { SIZE = 4096, NONE = 0x12345678 };
    static uint8_t pix[SIZE];
    static uint32_t out[SIZE];
    uint32_t rgb[256];
    struct rng r;

    rng_seed(&r, 5);
    for (int i = 0; i < SIZE; i++)
        pix[i] = (uint8_t)rng_next(&r);
    for (int i = 0; i < 256; i++)
        rgb[i] = (uint32_t)rng_next(&r) | 1;
    for (int k = 0; k < 3000; k++) {
        int w = (int)rng_below(&r, 41), h = (int)rng_below(&r, 21), pitch = w + (int)rng_below(&r, 20);
        int out_pitch = w + (int)rng_below(&r, 20), from = (int)rng_below(&r, 16), to = (int)rng_below(&r, 16);
        for (int i = 0; i < SIZE; i++)
            out[i] = NONE;
        plat_convert_to_rgb(out + to, out_pitch, pix + from, pitch, w, h, rgb);
        for (int i = 0; i < SIZE; i++) {
            int x = out_pitch ? (i - to) % out_pitch : 0, y = out_pitch ? (i - to) / out_pitch : h;
            bool in = i >= to && x < w && y < h;
            assert_int_equal(out[i], in ? rgb[pix[from + y * pitch + x]] : NONE);
        }
    }
}

RUN_TESTS(into_folder, out_of_folder)
