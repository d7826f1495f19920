/*
 * report.h - pages that a program writes with what it measured: text, tables and plots, as Markdown and SVG.
 *
 * A page is collected and written at the end, because its conclusions stand before what they follow from.
 */
#ifndef REPORT_REPORT_H
#define REPORT_REPORT_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#ifdef __GNUC__
#define REPORT_PRINTF(n) __attribute__((format(printf, n, n + 1)))
#else
#define REPORT_PRINTF(n)
#endif

/* ---- the page ---- */

/* FOLDER/PAGE.md, its plots FOLDER/PAGE/NAME.svg. */
struct report {
    const char *program; /* for messages */
    const char *folder;  /* NULL: nothing is written */
    const char *page;
    bool exact; /* no times are taken: plots of times are not written, and the page names no machine */
    bool echo;  /* what is collected is printed as well */
};

void report_begin(const struct report *report);

/* Writes the page: intro, the commit and the machine (tools/docs/measured.sh), then (if there are any) conclusions and
 * the rows of report_conclude, then the body. */
void report_finish(const char *intro, const char *conclusions);

/* A row of the table that opens the page; the second cell is bold. */
void report_conclude(const char *const *cells, int n);

/* "PROGRAM: WHAT" and exit code 2. */
#ifdef __GNUC__
__attribute__((noreturn))
#endif
void report_fail(const char *what);

/* ---- the command line: [--exact] [--out FOLDER] [SECTION...] ---- */

enum { REPORT_PARTS = 16 };

/* A section: its name on the command line, and what measures it. */
struct report_part {
    const char *name;
    void (*run)(void);
};

struct report_options {
    const char *usage;  /* in: "PROGRAM [--out FOLDER]", without the sections */
    bool takes_exact;   /* in: is --exact an option? */
    bool exact;         /* --exact was given */
    const char *folder; /* --out; NULL: not given */
    bool all;           /* no section was named: all are to run */
    bool chosen[REPORT_PARTS];
};

/* Reads the command line of a program with n sections. False: it is wrong, and the usage went to stderr. */
bool report_options(struct report_options *o, int argc, char **argv, const struct report_part *parts, int n);

/* Runs the sections that were chosen, in the order of the list. */
void report_run(const struct report_options *o, const struct report_part *parts, int n);

/* ---- text ---- */

/* "## TITLE"; it begins a section. */
void report_section(const char *title);

/* Markdown as it stands, followed by an empty line. */
void report_text(const char *format, ...) REPORT_PRINTF(1);

/* A string that stays good for the next 64 calls. */
const char *report_string(const char *format, ...) REPORT_PRINTF(1);

/* A figure with 2 or 3 significant digits: "0", "0.00012", "3.4", "120", "1,200,000"; "1.5e-9" below 10^-5. */
const char *report_figure(double v);

/* A whole number with thousands: "65,536". */
const char *report_count(int64_t n);

/* A share of one as "12.3 %". "0" is exactly none; "<0.01 %" is a little. */
const char *report_percent(double share);

/* ---- tables ---- */

/* Columns are separated by '|'; one that ends in '>' is set to the right. title may be NULL. */
void report_table(const char *title, const char *columns);

/* A row: each cell a string, the last followed by NULL. A standard one is set bold and marked; a column whose name
 * begins with "who" never is. */
void report_row(int standard, ...);

/* A row of n cells from an array. */
void report_cells(int standard, const char *const *cells, int n);
void report_table_end(void);

/* ---- plots, shown where report_plot_end is called ---- */

struct report_plot {
    const char *file, *title;
    const char *x_name, *y_name;
    bool x_linear, y_linear; /* else logarithmic */
    bool x_percent, y_percent;
    bool timed;            /* some coordinate is a time: not written when the report is exact */
    const char *described; /* the alternative text: what the reader is to see in it */
};

void report_plot(const struct report_plot *plot);

/* A labelled point. y = 0 on a logarithmic axis stands on a line of its own, "0". */
void report_plot_point(const char *label, bool standard, double x, double y);

/* A line with its label at its end. */
void report_plot_line(const char *label, bool standard, const double *x, const double *y, int n);
void report_plot_end(void);

/* ---- for plot.c ---- */

/* Opens FILE.svg in the folder for the page's plots; NULL: it is not to be written. */
void *report_plot_file(const char *file, bool timed);

/* The page's name. */
const char *report_page(void);

/* The same bits everywhere; good to about 2^-50. */
double report_log10(double x);

#endif
