/*
 * test_bench.c - the crowd that `make bench` measures: the engine and the programs it is compared with agree.
 */
#include "../test.h"
#include "../../src/board/board.h"
#include "../../src/machine/machine.h"
#include "../../src/workbench/pack/pack.h"
#include "../../tools/lab/bench/crowd.h"

static const struct reference *const references[] = { &reference_array, &reference_columns, &reference_least };
enum { REFERENCES = sizeof references / sizeof *references };

struct match {
    struct rom_image image;
    struct scene scene;
    struct crowd crowd;
    void *data[REFERENCES];
    struct crowd_counts board, counts[REFERENCES];
};

static void open_match(struct match *m, int n, uint64_t seed)
{
    char err[256];
    const struct scene_want want = { .does = "crowd", .n = n, .bullets = n, .seed = seed };

    memset(m, 0, sizeof *m);
    assert_true(pack_load_game("roms/bench", false, &m->image, err, sizeof err));
    assert_true(scene_open(&m->scene, &m->image.rom, &want, err, sizeof err));
    assert_true(crowd_take(&m->crowd, &m->scene));
    assert_int_equal(m->crowd.n, n);
    for (int i = 0; i < REFERENCES; i++)
        assert_non_null(m->data[i] = references[i]->open(&m->crowd));
}

static void close_match(struct match *m)
{
    for (int i = 0; i < REFERENCES; i++)
        references[i]->close(m->data[i]);
    free((void *)(uintptr_t)m->crowd.bullets);
    scene_close(&m->scene);
    rom_image_free(&m->image);
}

static void play_match(struct match *m)
{
    assert_true(scene_tick(&m->scene));
    scene_draw(&m->scene);
    crowd_count(&m->board, &m->scene, true);
    const struct crowd_player p = crowd_player(&m->scene);
    for (int i = 0; i < REFERENCES; i++) {
        references[i]->tick(m->data[i], &p, &m->counts[i]);
        references[i]->draw(m->data[i], &m->counts[i]);
    }
}

/* Each frame the four agree, in counts, places and pixels: more than a way and back, and past a change of the pace. */
TEST(crowd)
{
    static const int sizes[] = { 1, 63, 64, 1000, 3001 };
    static struct match m;

    for (size_t k = 0; k < sizeof sizes / sizeof *sizes; k++) {
        open_match(&m, sizes[k], 77 + k);
        for (int f = 0; f < 600; f++) {
            play_match(&m);
            for (int i = 0; i < REFERENCES; i++) {
                if (references[i] == &reference_least) /* it asks for no more */
                    m.counts[i].tested = m.board.tested, m.counts[i].grazed = m.board.grazed;
                assert_memory_equal(&m.board, &m.counts[i], sizeof m.board);
                assert_null(crowd_differs(&m.crowd, &m.scene, references[i], m.data[i]));
            }
            if (f % 30 == 0)
                assert_null(crowd_misdrawn(&m.crowd, &m.scene));
        }
        assert_int_equal(m.board.moved, 600 * sizes[k]);
        assert_int_equal(m.board.drawn, 600 * (sizes[k] + 1));
        assert_true(sizes[k] < 3001 || (m.board.tested > 10000 && m.board.hit > 1000 && m.board.grazed > 300));
        close_match(&m);
    }
}

/* Those who compare can tell: one bullet an ulp away, one pixel a shade off. */
TEST(crowd_spoilt)
{
    static struct match m;

    open_match(&m, 1000, 5);
    for (int f = 0; f < 70; f++)
        play_match(&m);
    struct board *b = m.scene.b;
    uint8_t *pixel = m.scene.fb.pix + 120 * m.scene.fb.pitch + 160;
    for (int i = 0; i < REFERENCES; i++) {
        b->bullets.x[999]++;
        assert_non_null(crowd_differs(&m.crowd, &m.scene, references[i], m.data[i]));
        b->bullets.x[999]--;
        *pixel ^= 1;
        assert_non_null(crowd_differs(&m.crowd, &m.scene, references[i], m.data[i]));
        *pixel ^= 1;
        assert_null(crowd_differs(&m.crowd, &m.scene, references[i], m.data[i]));
    }
    *pixel ^= 1;
    assert_non_null(crowd_misdrawn(&m.crowd, &m.scene));
    *pixel ^= 1;
    assert_null(crowd_misdrawn(&m.crowd, &m.scene));
    close_match(&m);
}

/* The pictures of two runs differ, and have as many opaque pixels as the disc. */
TEST(crowd_shuffled)
{
    static struct match m[2];

    open_match(&m[0], 64, 1);
    open_match(&m[1], 64, 2);
    for (int k = 0; k < CROWD_KINDS; k++) {
        const uint8_t *pix = m[0].crowd.pix[k];
        int opaque = 0, of_disc = 0;
        for (int i = 0; i < CROWD_SIDE * CROWD_SIDE; i++) {
            opaque += pix[i] != 0;
            of_disc += m[0].crowd.ship[i] != 0;
        }
        assert_int_equal(opaque, of_disc);
        assert_memory_not_equal(pix, m[1].crowd.pix[k], sizeof m[0].crowd.pix[k]);
    }
    close_match(&m[0]);
    close_match(&m[1]);
}

RUN_TESTS(NULL, NULL)
