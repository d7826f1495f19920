/* names.h - lets rows.c and weigh.c, which use today's names, build with a commit that has older ones. */
#ifndef TOOLS_COMPARE_NAMES_H
#define TOOLS_COMPARE_NAMES_H

#ifdef HAS_PADS
#define MAX_PLAYERS PADS
#endif

#ifdef HAS_BOARD_POWER
#define manifest           m
#define n_values           values
#define default_value      value
#define board_power_on     board_power
#define board_screen_size  board_screen
#define board_scratch_size board_scratch
#define board_last_output  board_last
#define board_live_count   board_live
#endif

#endif
