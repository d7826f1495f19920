/* names.h - for rows.c and weigh.c, built with a commit that has older names: those for the ones of today. */
#ifndef TOOLS_COMPARE_NAMES_H
#define TOOLS_COMPARE_NAMES_H

#ifdef OLDER_NAMES
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
