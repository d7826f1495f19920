/*
 * fuzz_args.c - libFuzzer: any words, each up to a NUL byte, as a command line; and the first as what --frames is
 * given. What is taken is in range and points at these words; what is refused says why in one sentence.
 */
#include "../../src/player/args/args.h"
#include "fuzz.h"

enum { WORDS = 64 };

static bool one_of(const char *s, char *const *words, int n)
{
    for (int i = 0; i < n; i++)
        if (s >= words[i] && s <= words[i] + strlen(words[i]))
            return true;
    return s == NULL;
}

static void frames(const struct args *a)
{
    uint32_t last = args_last_frame(a);

    need(a->n_spans >= 0 && a->n_spans <= ARGS_MAX_SPANS && last <= ARGS_MAX_FRAME);
    need(a->n_spans == 0 || args_has_frame(a, last));
    need(!args_has_frame(a, last + 1) && !args_has_frame(a, UINT32_MAX));
    for (int i = 0; i < a->n_spans; i++) {
        const struct span *s = &a->spans[i];
        need(s->step > 0 && s->first <= s->last && s->last <= ARGS_MAX_FRAME && args_has_frame(a, s->first));
    }
}

static void taken(const struct args *a, char *const *argv, int argc)
{
    const char *text[] = { a->record, a->demo, a->stage, a->difficulty, a->lang, a->out, a->sheet };

    need((unsigned)a->command < COMMANDS && a->n_words >= 0 && a->n_words < argc);
    for (int i = 0; i < a->n_words; i++)
        need(a->words[i] && one_of(a->words[i], argv, argc));
    for (size_t i = 0; i < sizeof text / sizeof *text; i++)
        need(one_of(text[i], argv, argc));
    need(a->n_dips >= 0 && a->n_dips <= ARGS_MAX_DIPS && a->n_registers >= 0 && a->n_registers <= ARGS_MAX_REGISTERS);
    for (int i = 0; i < a->n_dips; i++)
        need(strchr(a->dips[i], '='));
    for (int i = 0; i < a->n_registers; i++)
        need(strchr(a->registers[i], '='));
    for (int i = 0; i < a->n_traces; i++)
        need(one_of(a->traces[i], argv, argc));
    need(a->n_traces <= ARGS_MAX_TRACES && a->lives >= 0 && a->lives <= ARGS_MAX_LIVES);
    need(a->scale >= 0 && a->scale <= ARGS_MAX_SCALE && a->every > 0);
    frames(a);
}

static void sentence(const char *err, size_t size)
{
    need(memchr(err, 0, size) && err[0]);
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    static char program[] = "curtain";
    char *argv[WORDS + 1] = { program }, *given[WORDS + 1], err[512] = "";
    char *copy = fuzz_text(data, size);
    struct args a = { 0 };
    int argc = 1;

    for (size_t at = 0; at < size && argc < WORDS; at += strlen(copy + at) + 1)
        argv[argc++] = copy + at;
    argv[argc] = NULL;
    memcpy(given, argv, sizeof given);
    if (args_frames(&a, argc > 1 ? argv[1] : "", err, sizeof err))
        frames(&a);
    else
        sentence(err, sizeof err);
    err[0] = 0;
    if (args_parse(&a, argc, argv, err, sizeof err))
        taken(&a, given, argc);
    else
        sentence(err, sizeof err);
    free(copy);
    return 0;
}
