/*
 * cab_nvram.c - the saved nvram of the game (scores, records): when it is loaded, saved, or kept out of a run.
 */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "../../../platform/platform.h"
#include "../../common/files.h"
#include "../../machine/nvram.h"
#include "cab_parts.h"

enum { MAX_NVRAM_KEPT = 2 * MAX_NVRAM /* bytes that are kept of a damaged score file */ };

static void nvram_name(struct cab *cab, char name[CAB_NAME])
{
    snprintf(name, CAB_NAME, "user:%s.nv", cab_cart(cab)->manifest.id);
}

static bool keeps_nvram(struct cab *cab)
{
    const struct session *s = &cab->session;
    unsigned flags = s->now ? s->now->writer.demo.flags : 0;

    return !cab->no_scores && !s->rewound && !cab->options.demo && !cab->start.practice.section[0] &&
           !cab->options.start.nvram && !s->demo && (!cab->guest.demo || cab->guest.same) &&
           !(flags & (DEMO_BRANCHED | DEMO_TOUCHED | DEMO_ASSISTED));
}

/* Keeps scores that cannot be read beside the new ones, as NAME.damaged, or NAME.damaged-2 and so on. */
static void keep_damaged(struct cab *cab, const char *name, const uint8_t *image, size_t size)
{
    char beside[CAB_NAME + 32], shown[FILES_PATH_SIZE], shown_beside[FILES_PATH_SIZE];

    snprintf(beside, sizeof beside, "%s.damaged", name);
    for (int i = 2; plat_file_size(beside) >= 0; i++)
        snprintf(beside, sizeof beside, "%s.damaged-%d", name, i);
    bool kept = plat_save(beside, image, size);
    cab->no_scores = !kept; /* then the file is not written either */
    cab_say(cab,
            kept ? "curtain: %s is damaged; renamed to %s, and the score table starts empty"
                 : "curtain: %s is damaged and cannot be renamed to %s; scores are not saved",
            files_display_name(name, shown), files_display_name(beside, shown_beside));
}

uint8_t *cab_load_nvram(struct cab *cab, struct board_start *start)
{
    char name[CAB_NAME], shown[FILES_PATH_SIZE];
    size_t waits;
    nvram_name(cab, name);
    const uint8_t *newer = unsaved_bytes(cab->unsaved.files, name, &waits);
    long size = newer ? (long)waits : plat_file_size(name);
    if (start->nvram || start->practice.section[0] || cab->options.demo || size < 0)
        return NULL;
    size = size < MAX_NVRAM_KEPT ? size : MAX_NVRAM_KEPT;
    uint8_t *image = malloc((size_t)size + 1);
    if (image && newer)
        memcpy(image, newer, waits);
    if (!image || (!newer && plat_load(name, image, (size_t)size) != size)) {
        cab_say(cab, "curtain: %s: cannot be read; scores are not saved", files_display_name(name, shown));
        cab->no_scores = true;
    } else if (nvram_is_valid(image, (size_t)size)) {
        start->nvram = image;
        start->nvram_size = (size_t)size;
        return image;
    } else
        keep_damaged(cab, name, image, (size_t)size);
    free(image);
    return NULL;
}

void cab_save_nvram(struct cab *cab)
{
    char name[CAB_NAME];
    uint32_t changed;
    size_t size;
    const uint8_t *image = board_nvram(cab_live(cab), &size, &changed);
    if (changed == cab->nvram_saved || !keeps_nvram(cab))
        return;
    nvram_name(cab, name);
    cab->nvram_saved = changed; /* or it waits */
    cab_save(cab, name, image, size);
}

void cab_mark_assisted(struct cab *cab)
{
    cab_save_nvram(cab); /* what was reached so far; nothing more of this run */
    cab_check_recording(cab, session_mark_assisted(&cab->session));
}
