/*
 * host.c - see host.h.
 *
 * The process's locale is not changed because other threads use it. In glibc and musl the C locale is a constant:
 * newlocale returns it without allocating, and freelocale ignores it.
 */
#include "host.h"

/* Saves all of the thread's arithmetic settings and sets the defaults. fesetenv does not set all bits: with glibc on
 * arm64 it does not change the bit that makes every NaN the default NaN. */
static void set_arithmetic(struct host *h)
{
    fegetenv(&h->arithmetic);
#ifdef HOST_FPCR
    __asm__ volatile("mrs %0, fpcr" : "=r"(h->control));
    __asm__ volatile("msr fpcr, xzr");
#endif
    fesetenv(FE_DFL_ENV);
}

static void restore_arithmetic(const struct host *h)
{
    fesetenv(&h->arithmetic);
#ifdef HOST_FPCR
    __asm__ volatile("msr fpcr, %0" : : "r"(h->control));
#endif
}

#ifdef HOST_SSE
/* There are two floating-point units. Saving and loading the older one, the 387, takes most of the time, yet hardly any
 * program changes its settings. So the 387 is saved and loaded only if its settings are not the defaults or it has
 * raised a flag. */
enum { SSE_DEFAULT = 0x1f80, DEFAULT_387 = 0x37f, FLAGS_387 = 0x3f };

static unsigned flags_387(void)
{
    uint16_t status;

    __asm__ volatile("fnstsw %0" : "=a"(status));
    return status & FLAGS_387;
}

static bool is_387_default(void)
{
    uint16_t control;

    __asm__ volatile("fnstcw %0" : "=m"(control));
    return control == DEFAULT_387 && !flags_387();
}

static void set_sse(uint32_t word)
{
    __asm__ volatile("ldmxcsr %0" : : "m"(word));
}
#endif

void host_enter(struct host *h)
{
#ifdef HOST_SSE
    h->has_default_387 = is_387_default();
    if (h->has_default_387) {
        __asm__ volatile("stmxcsr %0" : "=m"(h->sse));
        set_sse(SSE_DEFAULT);
    } else
        set_arithmetic(h);
#else
    set_arithmetic(h);
#endif
#ifdef HOST_LOCALES
    h->c_locale = newlocale(LC_ALL_MASK, "C", (locale_t)0);
    h->locale = uselocale(h->c_locale);
#endif
}

void host_leave(const struct host *h)
{
#ifdef HOST_LOCALES
    uselocale(h->locale);
    if (h->c_locale)
        freelocale(h->c_locale);
#endif
#ifdef HOST_SSE
    if (!h->has_default_387) {
        restore_arithmetic(h);
        return;
    }
    if (flags_387())
        __asm__ volatile("fnclex");
    set_sse(h->sse);
#else
    restore_arithmetic(h);
#endif
}
