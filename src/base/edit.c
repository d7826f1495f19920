/*
 * edit.c - see edit.h. Computes the optimal string alignment distance. Stores the distances between all prefixes, as
 * the words are short.
 */
#include "edit.h"
#include <string.h>

int edit_count(const char *a, const char *b)
{
    enum { MAX_LENGTH = 32 };
    size_t n = strlen(a), m = strlen(b);
    int d[MAX_LENGTH + 1][MAX_LENGTH + 1];

    if (n > MAX_LENGTH || m > MAX_LENGTH)
        return EDIT_TOO_FAR;
    for (size_t i = 0; i <= n; i++)
        for (size_t j = 0; j <= m; j++) {
            if (!i || !j) {
                d[i][j] = (int)(i + j);
                continue;
            }
            int best = d[i - 1][j - 1] + (a[i - 1] != b[j - 1]);
            best = d[i - 1][j] + 1 < best ? d[i - 1][j] + 1 : best;
            best = d[i][j - 1] + 1 < best ? d[i][j - 1] + 1 : best;
            if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1] && d[i - 2][j - 2] + 1 < best)
                best = d[i - 2][j - 2] + 1;
            d[i][j] = best;
        }
    return d[n][m];
}

int edit_distance(const char *a, const char *b)
{
    const int d = edit_count(a, b);
    const size_t n = strlen(a);

    return (d <= 1 && (n > 1 || strlen(b) > 1)) || d == 0 || (d <= 2 && n > 3) || (d <= 3 && n > 7) ? d : EDIT_TOO_FAR;
}

void edit_consider(struct edit_nearest *n, const char *candidate)
{
    const int distance = edit_distance(n->word, candidate);

    if (distance < (n->found ? n->distance : EDIT_TOO_FAR)) {
        n->found = candidate;
        n->distance = distance;
    }
}
