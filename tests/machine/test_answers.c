/*
 * test_answers.c - the documents of tests/bulletml on a board, beside what libbulletml makes of them, which is written
 * down in NAME.out (tools/lab/bulletml/answer.c): every bullet in every frame, within 1/16 px, made and removed in the
 * same.
 */
#include <dirent.h>
#include <math.h>
#include "../../tools/lab/bulletml/compare.h"
#include "rig.h"

enum { MOST = 512, ROOM = 64 };

static const char FOLDER[] = "tests/bulletml";

/* What is otherwise here, and meant to be. */
static const char *const otherwise[] = {
    "minus_twice",         /* the sign is a flag there, set twice */
    "ref_to_inner_action", /* an action in line that a bullet has begun once never leads back there */
};
enum { OTHERWISE = sizeof otherwise / sizeof *otherwise };

static bool is_otherwise(const char *name)
{
    for (int i = 0; i < OTHERWISE; i++)
        if (!strcmp(otherwise[i], name))
            return true;
    return false;
}

/* The lines of NAME.out, as they are used up. */
struct answers {
    FILE *f;
    int frame; /* of `next`; -1: there are no more */
    struct side_bullet next;
};

static void advance(struct answers *a)
{
    char line[256];
    struct side_bullet *b = &a->next;

    a->frame = -1;
    if (fgets(line, sizeof line, a->f) &&
        sscanf(line, "%d %d %lf %lf %lf %lf", &a->frame, &b->id, &b->x, &b->y, &b->dir, &b->speed) != 6)
        a->frame = -1;
}

static bool beyond(const struct side_bullet *b)
{
    return !(fabs(b->x) <= COMPARE_X && fabs(b->y) <= COMPARE_Y);
}

/* One frame of both; false: they differ, and `why` says how. */
static bool frame_alike(struct answers *a, struct side *s, int f, char *why, size_t size)
{
    const struct side_bullet *b;
    const int32_t n = s->frame(s, side_player_x(f), side_player_y(f), &b);
    int32_t i = 0;

    if (n < 0) {
        snprintf(why, size, "frame %d: %s", f, s->error);
        return false;
    }
    for (; a->frame == f; advance(a)) {
        const struct side_bullet *want = &a->next;
        const bool there = i < n && b[i].id == want->id, far = beyond(want);
        if ((!there && !far) || (there && !far && !(hypot(b[i].x - want->x, b[i].y - want->y) <= COMPARE_MOST))) {
            snprintf(why, size, "frame %d: bullet %d should be at %.3f, %.3f; there is bullet %d at %.3f, %.3f", f,
                     want->id, want->x, want->y, i < n ? b[i].id : 0, i < n ? b[i].x : 0, i < n ? b[i].y : 0);
            return false;
        }
        i += there;
    }
    if (i < n)
        snprintf(why, size, "frame %d: bullet %d is one too many", f, b[i].id);
    return i == n;
}

/* All frames; the side is closed. */
static bool alike(struct answers *a, struct side *s, int frames, char *why, size_t size)
{
    bool same = true;

    advance(a);
    for (int f = 0; f < frames && same; f++)
        same = frame_alike(a, s, f, why, size);
    s->close(s);
    return same;
}

static void test_document(void **state)
{
    const char *name = *state;
    char document[512], path[512], first[64] = "", why[256] = "";
    struct answers a = { 0 };
    struct side s;

    snprintf(document, sizeof document, "%s/%s.xml", FOLDER, name);
    snprintf(path, sizeof path, "%s/%s.out", FOLDER, name);
    a.f = fopen(path, "r");
    if (!a.f || !fgets(first, sizeof first, a.f) || atoi(first) < 1)
        fail_msg("%s: expected \"FRAMES frames\"", path);
    const struct side_setup setup = { document, 0.5, 305419896, strstr(first, "looped") };
    const bool runs = side_board(&s, &setup);
    if (!runs)
        fail_msg("%s", s.error);
    const bool same = alike(&a, &s, atoi(first), why, sizeof why);
    if (same == is_otherwise(name))
        fail_msg("%s", same ? "is no other than libbulletml" : why);
    fclose(a.f);
}

int main(void)
{
    static struct CMUnitTest tests[MOST];
    static char names[MOST][ROOM];
    struct dirent *e;
    int n = 0;
    DIR *dir = opendir(FOLDER);

    while (dir && n < MOST && (e = readdir(dir))) {
        const char *end = strstr(e->d_name, ".xml");
        if (!end || end[4] || end - e->d_name >= ROOM)
            continue;
        memcpy(names[n], e->d_name, (size_t)(end - e->d_name));
        tests[n] = (struct CMUnitTest){ names[n], test_document, NULL, NULL, names[n] };
        n++;
    }
    if (dir)
        closedir(dir);
    if (!n) {
        fprintf(stderr, "%s: no documents\n", FOLDER);
        return 1;
    }
    return _cmocka_run_group_tests("answers", tests, (size_t)n, NULL, NULL);
}
