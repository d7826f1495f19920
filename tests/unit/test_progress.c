/* test_progress.c - how far something is, as a line of a terminal. */
#include <signal.h>
#include "../test.h"
#include "../../platform/platform.h"
#include "../../src/common/progress.h"

enum { SECOND = 1000000 };

static const char *said(const char *what, uint64_t usec, uint64_t done, uint64_t of)
{
    static char line[PROGRESS_LINE];

    progress_line(line, what, usec, done, of);
    return line;
}

/* What is left takes as long for its size as what is done took; a second that has begun is one. */
TEST(time_left)
{
    assert_string_equal(said("frame 100 of 400", SECOND, 100, 400), "frame 100 of 400, 0:04 left");
    assert_string_equal(said("frame 1", 2 * SECOND, 1, 31), "frame 1, 1:01 left");
    assert_string_equal(said("frame 1", 1999999, 1, 2), "frame 1, 0:02 left");
}

/* More may turn out to be done than was thought to be there, and of nothing no pace is known. */
TEST(odd_shares)
{
    assert_string_equal(said("begun", 5 * SECOND, 0, 100), "begun");
    assert_string_equal(said("late", 5 * SECOND, 120, 100), "late, 0:01 left");
    assert_string_equal(said("slow", (uint64_t)1 << 60, 1, UINT64_MAX), "slow, 9999:59 left");
}

/* A line that is too wide would not be overwritten, so the text gives way: never the time, and never half a letter. */
TEST(long_text)
{
    char what[200];

    memset(what, 'x', sizeof what - 1);
    what[sizeof what - 1] = 0;
    const char *line = said(what, SECOND, 1, 2);
    assert_int_equal(strlen(line), PROGRESS_LINE - 1);
    assert_string_equal(strstr(line, "..."), "..., 0:02 left");
    for (size_t first = 0; first < 3; first++) { /* of characters of three bytes each */
        memset(what, 'x', first);
        for (size_t i = first; i + 3 < sizeof what; i += 3)
            memcpy(what + i, "\xe2\x82\xac", 4);
        line = said(what, SECOND, 1, 2);
        const size_t kept = (size_t)(strstr(line, "...") - line);
        assert_int_equal((kept - first) % 3, 0);
        assert_in_range(kept, PROGRESS_LINE - 1 - strlen("..., 0:02 left") - 2,
                        PROGRESS_LINE - 1 - strlen("..., 0:02 left"));
    }
}

static volatile sig_atomic_t heard;

static void host_hears(int sig)
{
    heard = sig;
}

/* A host that runs the program has handlers of its own: they hear the signal, then and afterwards. */
TEST(hosts_handlers)
{
    static const int signals[] = { SIGINT, SIGTERM };

    for (size_t i = 0; i < sizeof signals / sizeof *signals; i++) {
        signal(signals[i], host_hears);
        plat_set_exit_text("");
        plat_set_exit_text("");
        heard = 0;
        raise(signals[i]);
        assert_int_equal(heard, signals[i]);
        plat_set_exit_text("");
        plat_set_exit_text(NULL);
        assert_true(signal(signals[i], SIG_IGN) == host_hears);
        plat_set_exit_text("");
        plat_set_exit_text(NULL);
        assert_true(signal(signals[i], SIG_DFL) == SIG_IGN);
    }
    signal(SIGPIPE, host_hears);
    FILE *f = plat_command_open((const char *const[]){ "sh", "-c", "exec cat >/dev/null", NULL });
    assert_non_null(f);
    assert_true(plat_command_close(f));
    assert_true(signal(SIGPIPE, SIG_DFL) == host_hears);
}

RUN_TESTS(NULL, NULL)
