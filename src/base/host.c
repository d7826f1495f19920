/*
 * host.c - see host.h.
 *
 * The process's locale is left alone, for other threads use it. glibc and musl have the C locale as a constant, which
 * newlocale hands out and freelocale takes back without a word to anybody.
 */
#include "host.h"

#ifdef HOST_LOCALES
static void words_aside(struct host *h)
{
    h->own = newlocale(LC_ALL_MASK, "C", (locale_t)0);
    h->words = uselocale(h->own);
}

static void words_back(const struct host *h)
{
    uselocale(h->words);
    if (h->own)
        freelocale(h->own);
}
#else
static void words_aside(struct host *h)
{
    (void)h;
}

static void words_back(const struct host *h)
{
    (void)h;
}
#endif

/* fesetenv leaves alone what glibc knows no use for: on arm64 the bit by which all NaNs are one. */
static void control_aside(struct host *h)
{
#ifdef HOST_FPCR
    __asm__ volatile("mrs %0, fpcr" : "=r"(h->control));
    __asm__ volatile("msr fpcr, xzr");
#else
    (void)h;
#endif
}

static void control_back(const struct host *h)
{
#ifdef HOST_FPCR
    __asm__ volatile("msr fpcr, %0" : : "r"(h->control));
#else
    (void)h;
#endif
}

void host_enter(struct host *h)
{
    fegetenv(&h->numbers);
    control_aside(h);
    fesetenv(FE_DFL_ENV);
    words_aside(h);
}

void host_leave(const struct host *h)
{
    words_back(h);
    fesetenv(&h->numbers);
    control_back(h);
}
