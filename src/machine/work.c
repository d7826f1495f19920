/*
 * work.c - limiting the work done in C, so that every frame is bounded: raising the fault, and the work of drawing a
 * picture.
 *
 * A unit of work takes about as long as the slowest VM instruction, at most 10 ns; VM instructions and work in C add to
 * the same total and have one limit (vm.h). Loops over two pools count the entities they examine. Work done once per
 * entity of a pool is not counted, because the manifest bounds it.
 */
#include <stdarg.h>
#include <stdio.h>
#include "machine.h"
#include "video/video.h"

void board_raise_fault(struct board *b, enum board_fault_kind kind, const char *format, ...)
{
    char message[320];
    va_list args;

    va_start(args, format);
    vsnprintf(message, sizeof message, format, args);
    va_end(args);
    b->calls->fault(b, kind, message);
}

void board_charge_picture(struct board *b)
{
    const struct vm *vm = &b->vm;
    struct video_work w;

    if (video_fits(b, vm->limit - vm->work, &w))
        board_charge_work(b, w.work);
    else
        board_raise_overload(b, "drawing: too much work in one frame (mostly %s); %s or make them smaller",
                             w.largest_name, w.advice);
}
