/*
 * play_nvram.c - the score file: loading it, saving it, and setting a damaged one aside.
 */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "../../../platform/platform.h"
#include "../../common/files.h"
#include "../../machine/nvram.h"
#include "play_state.h"

enum { MAX_BACKUP = 2 * MAX_NVRAM /* bytes of a damaged score file that are backed up */ };

static void nvram_name(struct play *play, char name[PLAY_NAME_SIZE])
{
    snprintf(name, PLAY_NAME_SIZE, "user:%s.nv", play_cart(play)->manifest.id);
}

static bool saves_nvram(struct play *play)
{
    const struct session *s = &play->session;
    unsigned flags = s->now ? s->now->writer.demo.flags : 0;

    return !play->nvram.disabled && !s->rewound && !play->options.demo && !play->start.practice.section[0] &&
           !play->options.start.nvram && !s->demo && (!play->replay.demo || play->replay.same) &&
           !(flags & (DEMO_BRANCHED | DEMO_TOUCHED | DEMO_ASSISTED));
}

/* Copies a damaged score file to NAME.damaged, or NAME.damaged-2 and so on. */
static void back_up(struct play *play, const char *name, const uint8_t *image, size_t size)
{
    char backup[PLAY_NAME_SIZE + 32], shown[FILES_PATH_SIZE], shown_backup[FILES_PATH_SIZE];

    snprintf(backup, sizeof backup, "%s.damaged", name);
    for (int i = 2; plat_file_size(backup) >= 0; i++)
        snprintf(backup, sizeof backup, "%s.damaged-%d", name, i);
    bool saved = plat_save(backup, image, size);
    play->nvram.disabled = !saved; /* so the damaged file is not overwritten */
    play_log(play,
             saved ? "curtain: %s is damaged; renamed to %s, and the score table starts empty"
                   : "curtain: %s is damaged and cannot be renamed to %s; scores are not saved",
             files_display_name(name, shown), files_display_name(backup, shown_backup));
}

uint8_t *play_load_nvram(struct play *play, struct board_start *start)
{
    char name[PLAY_NAME_SIZE], shown[FILES_PATH_SIZE];
    size_t unsaved;

    nvram_name(play, name);
    const uint8_t *newer = unsaved_bytes(play->unsaved.files, name, &unsaved);
    long size = newer ? (long)unsaved : plat_file_size(name);
    if (start->nvram || start->practice.section[0] || play->options.demo || size < 0)
        return NULL;
    size = size < MAX_BACKUP ? size : MAX_BACKUP;
    uint8_t *image = malloc((size_t)size + 1);
    if (image && newer)
        memcpy(image, newer, unsaved);
    if (!image || (!newer && plat_load(name, image, (size_t)size) != size)) {
        play_log(play, "curtain: %s: cannot be read; scores are not saved", files_display_name(name, shown));
        play->nvram.disabled = true;
    } else if (nvram_is_valid(image, (size_t)size)) {
        start->nvram = image;
        start->nvram_size = (size_t)size;
        return image;
    } else
        back_up(play, name, image, (size_t)size);
    free(image);
    return NULL;
}

void play_save_nvram(struct play *play)
{
    char name[PLAY_NAME_SIZE];
    uint32_t changed;
    size_t size;
    const uint8_t *image = board_nvram(play_board(play), &size, &changed);

    if (changed == play->nvram.saved_count || !saves_nvram(play))
        return;
    nvram_name(play, name);
    play->nvram.saved_count = changed; /* also if it can't be written yet */
    play_save(play, name, image, size);
}

void play_mark_assisted(struct play *play)
{
    play_save_nvram(play);
    play_check_recording(play, session_mark_assisted(&play->session));
}
