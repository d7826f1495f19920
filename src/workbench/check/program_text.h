/*
 * program_text.h - the text of the program's screens, which a game's language files can translate.
 */
#ifndef WORKBENCH_PROGRAM_TEXT_H
#define WORKBENCH_PROGRAM_TEXT_H

/* Returns text i, from 0, in byte order; NULL after the last. Numbers are %d; text with %s is a format. */
const char *program_text(int i);

/* Prints all texts as the lines of a language file without translations. */
void program_text_print(void (*line)(const char *));

#endif
