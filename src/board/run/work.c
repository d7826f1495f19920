/*
 * work.c - work in C that a tick counts, so that no frame goes on without bound: the fault, and what a picture takes.
 *
 * A unit is worth about as much time as the dearest VM instruction, at most 10 ns, and all work has one sum and one
 * limit (vm.h). Loops over two pools count what they look at while they run. What is done once for each thing of a pool
 * is not counted: the manifest bounds it.
 */
#include <stdarg.h>
#include <stdio.h>
#include "../machine.h"
#include "../video.h"

void board_too_much(struct board *b, const char *format, ...)
{
    char text[320];
    va_list args;

    va_start(args, format);
    vsnprintf(text, sizeof text, format, args);
    va_end(args);
    vm_fault(b->vm.running, FAULT_LOOP, "%s", text);
}

void board_charge_picture(struct board *b)
{
    const struct vm *vm = &b->vm;
    struct video_work w;

    if (video_fits(b, vm->limit - vm->work, &w))
        board_work(b, w.work);
    else
        board_too_much(b, "drawing: too much work in one frame (mostly %s); %s or make them smaller", w.what,
                       w.instead);
}
