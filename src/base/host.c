/*
 * host.c - see host.h.
 *
 * The process's locale is left alone, for other threads use it. In glibc and musl the C locale is a constant: newlocale
 * returns it without allocating, and freelocale does nothing with it.
 */
#include "host.h"

#ifdef HOST_LOCALES
static void set_locale(struct host *h)
{
    h->c_locale = newlocale(LC_ALL_MASK, "C", (locale_t)0);
    h->locale = uselocale(h->c_locale);
}

static void restore_locale(const struct host *h)
{
    uselocale(h->locale);
    if (h->c_locale)
        freelocale(h->c_locale);
}
#else
static void set_locale(struct host *h)
{
    (void)h;
}

static void restore_locale(const struct host *h)
{
    (void)h;
}
#endif

/* fesetenv does not set all bits: with glibc on arm64, not the one by which all NaNs are the default NaN. */
static void set_control(struct host *h)
{
#ifdef HOST_FPCR
    __asm__ volatile("mrs %0, fpcr" : "=r"(h->control));
    __asm__ volatile("msr fpcr, xzr");
#else
    (void)h;
#endif
}

static void restore_control(const struct host *h)
{
#ifdef HOST_FPCR
    __asm__ volatile("msr fpcr, %0" : : "r"(h->control));
#else
    (void)h;
#endif
}

void host_enter(struct host *h)
{
    fegetenv(&h->arithmetic);
    set_control(h);
    fesetenv(FE_DFL_ENV);
    set_locale(h);
}

void host_leave(const struct host *h)
{
    restore_locale(h);
    fesetenv(&h->arithmetic);
    restore_control(h);
}
