/*
 * leaving.h - what a bullet touches in the frame in which it leaves the field: a part of section 2.
 */
#ifndef LAB_LEAVING_H
#define LAB_LEAVING_H

void leaving_report(void);

#endif
