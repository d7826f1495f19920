/*
 * test_mml.c - MML: what it compiles to, what is refused and in which words.
 */
#include "../test.h"
#include "../../src/base/bytes.h"
#include "../../src/workbench/mml/mml.h"
#include "../../src/sound/tune.h"

static const struct mml_settings settings = { .volume = 200, .priority = 3, .limit = 5, .title = "" };

/* ---- what it compiles to ---- */

/* The events of track A, at a tempo at which a tick is a sample; or the error. */
static const char *events(const char *text)
{
    static const char names[] = ".nso/ivp";
    static char list[4096];
    char err[256];
    uint8_t *bytes;
    size_t size, n = 0;
    struct tune_played_event e;

    if (!mml_compile(text, strlen(text), "x.mml", &settings, &bytes, &size, err, sizeof err))
        return strcpy(list, err);
    assert_true(tune_validate(bytes, size, err, sizeof err));
    const struct tune t = tune_of(bytes);
    struct track_cursor c = tune_track_start(&t, 0);
    list[0] = '\0';
    for (long long at = 0; at < 6000 && c.cursor; at += 1000) {
        struct tune_run run = { &t, 0, c, TUNE_TICK, 0, 1000, 0 };
        while (tune_next_event(&run, &e)) {
            n += (size_t)snprintf(list + n, sizeof list - n, "%lld%c", at + e.sample, names[e.event]);
            if (e.event == TUNE_NOTE || e.event == TUNE_SLUR || e.event == TUNE_GLIDE)
                n += (size_t)snprintf(list + n, sizeof list - n, "%g", e.value / 256.0);
            else if (e.event >= TUNE_INST)
                n += (size_t)snprintf(list + n, sizeof list - n, "%d", e.value);
            n += (size_t)snprintf(list + n, sizeof list - n, " ");
        }
        c = run.cursor;
    }
    free(bytes);
    return list;
}

#define EVENTS(text, list) assert_string_equal(events(text), "0v100 " list)

TEST(commands)
{
    EVENTS("c4", "0i0 0n60 480o 480. ");
    EVENTS("l8 c d+ e-4. f=", "0i0 0n60 240o 240n63 480o 480n63 1200o 1200n65 1440o 1440. ");
    EVENTS("o5 c8 <b8 > >c8", "0i0 0n72 240o 240n71 480o 480n84 720o 720. ");
    EVENTS("c4&8", "0i0 0n60 720o 720. ");
    EVENTS("c4 & d4", "0i0 0n60 480s62 960o 960. ");
    EVENTS("c%7 x%9", "0i0 0n60 7o 7n60 16o 16. ");
    EVENTS("[c16 / d16]3", "0i0 0n60 120o 120n62 240o 240n60 360o 360n62 480o 480n60 600o 600. ");
    EVENTS("{c>g}4,8 c", "0i0 0n60 240/79 480o 480n72 960o 960. ");
    EVENTS("{{cde}}4 & c", "0i0 0n60 160o 160n62 320o 320n64 480s60 960o 960. ");
    EVENTS("c & {{ d e }}4. & c", "0i0 0n60 480s62 840o 840n64 1200s60 1680o 1680. ");
    EVENTS("{{cd}}4&4 {{ef}}4&", "0i0 0n60 480o 480n62 960o 960n64 1200o 1200n65 1440o 1440. ");
    EVENTS("Q4 c4 Q8 q60 c4", "0i0 0n60 240o 480n60 900o 960. ");
    EVENTS("v15 c8 V40 ( c8 p100 D50 c8 D0 K2 c8",
           "0v127 0i0 0n60 240o 240v40 240v32 240n60 480o 480p100 480n60.5 720o 720n62 960o 960. ");
    EVENTS("_{+fc} c8 f8 c=8 _{=} f8", "0i0 0n61 240o 240n66 480o 480n60 720o 720n65 960o 960. ");
    EVENTS("@sine c8 @saw c8 @sine M20,5,0 c8", "0i0 0n60 240o 240i1 240n60 480o 480i2 480n60 720o 720. ");
    EVENTS("c1 L d1 e1", "0i0 0n60 1920o 1920o 1920i0 1920v100 1920p64 1920n62 3840o 3840n64 5760o 5760i0 5760v100 "
                         "5760p64 5760n62 ");
    EVENTS("!a c8\n!b d8\nA !a !b !a", "0i0 0n60 240o 240n62 480o 480n60 720o 720. ");
    EVENTS("A c8 ; the first\nB e8\nA d8", "0i0 0n60 240o 240n62 480o 480. ");
}

/* Those beside the notes themselves: slides, strokes, grace notes, swing. */
TEST(ornaments)
{
    EVENTS("l8 c G16 d e G0 f", "0i0 0n60 240o 240n60 240/62 480o 480n62 480/64 720o 720n65 960o 960. ");
    EVENTS("S2,16 c4 S0 d8", "0i0 0n58 0/60 480o 480n62 720o 720. ");
    EVENTS("v8 W16,-2 c8. W0 d16", "0v67 0i0 0n60 120v51 120n60 240v35 240n60 360v67 360o 360n62 480o 480. ");
    EVENTS("~c16 d4 ~e~f4 g2", "0i0 0n60 120o 120n62 480o 480n64 540o 540n65 1020o 1020n67 1440o 1440. ");
    EVENTS("D20 DD5 c8 _3 __-1 c8 D0 _0 c8", "0i0 0n60.25 240o 240n62.25 480o 480n60 720o 720. ");
    EVENTS("MA30,5,0 c8 MA0 MP20,5,0 c8 M0 c8", "0i0 0n60 240o 240i1 240n60 480o 480i2 480n60 720o 720. ");
    EVENTS("#swing 16,60\nA c16 d16 e8 {f>f}8", "0i0 0n60 144o 144n62 240o 240n64 480o 480n65 480/77 720o 720. ");
    EVENTS("@E up 2:0,100\n@M bent 1:0,100|0\n@P round 9:-64,64\nA Eup c8 Mbent Pround c8 E- M- P- c8",
           "0i0 0n60 240o 240i1 240n60 480o 480i2 480n60 720o 720. ");
}

TEST(header)
{
    static const char text[] = "#title The  tide\n#bar 3\n@b fm ratio=3.5 depth=2 attack=2 vibrato=20,5.5,200\n"
                               "A t99.5 @b c4 \"up\" c4 t120 c4 \"down\" c4 \"up\"\nC c4\n#echo B=A,8,-3\n";
    char err[256];
    uint8_t *bytes;
    size_t size;

    assert_true(mml_compile(text, sizeof text - 1, "x.mml", &settings, &bytes, &size, err, sizeof err));
    const struct tune t = tune_of(bytes);
    assert_string_equal(tune_title(&t), "The  tide");
    assert_int_equal(t.beats_per_bar, 3);
    assert_int_equal(t.tempo, 9950);
    assert_int_equal(t.n_tracks, 3);
    assert_int_equal(t.n_markers, 2);
    assert_string_equal(tune_marker_name(&t, 1), "down");
    assert_true(t.volume == 200 && t.priority == 3 && t.limit == 5);
    const struct inst i = inst_read(tune_inst(&t, 0));
    const struct op o = inst_read_op(tune_inst(&t, 0), 0);
    assert_true(i.kind == INST_FM && o.ratio == 896 && o.level == 1304 && i.env.attack == 96);
    assert_true(i.vibrato.depth == 51 && i.vibrato.delay == 9600);
    free(bytes);
}

/* An echo has the pans of its track, or one pan. */
TEST(echo)
{
    assert_string_equal(events("#echo A=B,8,-3\nB l8 p20 v8 c p30 d\n"),
                        "240v76 240p20 240v43 240i0 240n60 480o 480p30 480n62 720o 720. ");
    assert_string_equal(events("#echo A=B,8,-3,100\nB l8 p20 v8 c p30 d\n"),
                        "0p100 240v76 240v43 240i0 240n60 480o 480n62 720o 720. ");
}

/* ---- what is refused ---- */

TEST(mistakes)
{
    static const char *const list[][2] = {
        { "c7", "x.mml:1:2: a length of 1/7 is not a whole number of ticks (1920 per whole note); {{ }} divides by any "
                "number" },
        { "c4\nd", "x.mml:1:1: expected a track (A to P and a space), @instrument, !macro, # or ;" },
        { "A c4\nA  h", "x.mml:2:4: unknown command \"h\"" },
        { "A @bel c\n@bell fm", "x.mml:1:3: unknown instrument \"bel\" (did you mean \"bell\"?)" },
        { "@b fm atack=3\nA c", "x.mml:1:7: unknown setting \"atack\" (did you mean \"attack\"?)" },
        { "@b horn\nA c", "x.mml:1:4: expected pulse, triangle, saw, sine, fm, fm4, wave, noise, sample, or an "
                          "instrument defined above, got \"horn\"" },
        { "[c4", "x.mml:1:1: [ without ]" },
        { "v16", "x.mml:1:2: expected a volume, a number from 0 to 15, got 16" },
        { "t600.5 c", "x.mml:1:2: expected quarter notes per minute from 10 to 600, got 600.5" },
        { "v c", "x.mml:1:2: expected a volume, a number from 0 to 15, got nothing" },
        { "c4 \"up\" c%6 \"down\"",
          "x.mml:1:13: marker \"down\" is within one frame (1/60 s) of \"up\", so scripts would never see it" },
        { "c4 & r4 & d", "x.mml:1:9: expected a note before \"&\"" },
        { "c \xFF", "x.mml:1:3: unknown command \"?\"" },
        { "{{cr}}4 & c", "x.mml:1:9: expected a note before \"&\"" },
        { "c}} d", "x.mml:1:2: } without {" },
        { "[c : d]2", "x.mml:1:4: unknown command \":\" (\"/\" leaves a loop)" },
        { "_M2 c", "x.mml:1:1: unknown command \"_M\" (\"K\" transposes)" },
        { "o9 c+4 b+", "x.mml:1:8: the note is too high" },
        { "x4", "x.mml:1:1: x repeats the previous note, but there is none" },
        { "{cd}4,2 {c}4", "x.mml:1:1: the slide ends after its note" },
        { "{{c[d]2}}4", "x.mml:1:4: {{ }} can only contain notes, rests and octaves" },
        { "c L", "x.mml:1:3: nothing to repeat after L" },
        { "A c4 L c4\nB L c2", "x.mml:2:3: track B loops every 960 ticks, track A every 480 (480 per quarter note): "
                               "they would drift apart" },
        { "!a !a\nA !a", "x.mml:1:4: macros nested deeper than 8 (does \"a\" contain itself?)" },
        { "A E5,5 c", "x.mml:1:7: expected E attack,decay,sustain,release: milliseconds, and percent for sustain" },
        { "A ~r c", "x.mml:1:3: expected a note after ~, as in ~c16 d4" },
        { "A ~c4 d4", "x.mml:1:7: the grace notes leave no time for the note itself" },
        { "A c4 ~d", "x.mml:1:8: grace note without a note after it" },
        { "A S2 c", "x.mml:1:5: expected S semitones,length, as in S2,16, or S0" },
        { "A Eup c", "x.mml:1:3: unknown curve \"up\": expected a line @E up FRAMES:VALUE,VALUE..." },
        { "@E Up 2:0\nA c", "x.mml:1:4: expected a name that starts with a lower-case letter, got \"Up\"" },
        { "@E up 2;0\nA c",
          "x.mml:1:7: expected FRAMES:VALUE,VALUE...; | before a value marks the loop start, as in 2:100,60|50,40" },
        { "#swing 16\nA c",
          "x.mml:1:1: expected #swing 16,60: the first of every two 16th notes gets 60 percent of their time" },
        { "#swing 16,60\nA L c16",
          "x.mml:2:3: with #swing, the part that L repeats must be a multiple of 240 ticks, got 120 ticks" },
        { "#mark up 3\nA c1", "x.mml:1:1: bar 3 is after the end" },
        { "@w wave decay=3\nA c", "x.mml:1:1: expected harmonics= or points=: a wave needs a waveform" },
        { "@w wave harmonics=0,0\nA c", "x.mml:1:19: expected at least one harmonic above 0" },
        { "@w wave points=1,1,1,1\nA c", "x.mml:1:16: expected 4 to 64 points per cycle, not all equal" },
        { "@b saw harmonics=1\nA c", "x.mml:1:8: only wave instruments have harmonics" },
        { "@b fm op3=1\nA c", "x.mml:1:7: this instrument has 2 operators" },
        { "@b fm4 op1=2 algorithm=1\nA c",
          "x.mml:1:24: expected the algorithm before the operators: it decides which of them are audible" },
        { "@b fm4 op1=1,101\nA c",
          "x.mml:1:14: expected percent (for an audible operator) from 0 to 100, got \"101\"" },
        { "@b saw arpeggio=2\nA c",
          "x.mml:1:8: expected arpeggio=FRAMES:SEMITONES,SEMITONES..., as in arpeggio=2:0,4,7" },
        { "@b saw decay=2x\nA c", "x.mml:1:15: expected a space after decay, got \"x\"" },
        { "; nothing\n", "x.mml:1:1: no track (a line that starts with A and a space)" },
        { "#tempo 120\nA c", "x.mml:1:1: expected #title, #bar, #echo, #swing or #mark" },
        { "#echo B:A\nA c",
          "x.mml:1:8: expected #echo B=A,8,-3: track B is track A an eighth note later and 3 steps softer" },
        { "#echo B=A,8,-3,129\nA c", "x.mml:1:16: expected a pan from 0 to 128, got \"129\"" },
        { "[[[[[[[[[c]2", "x.mml:1:9: loops nested deeper than 8" },
        { "[[[[[c%1]255]255]255]255]255", "x.mml:1:6: more than 262144 notes and settings (with loops expanded)" },
    };

    for (size_t i = 0; i < sizeof list / sizeof *list; i++)
        assert_string_equal(events(list[i][0]), list[i][1]);
}

/* ---- warnings ---- */

static void keep_warning(void *context, const char *sentence)
{
    strcat(strcat(context, sentence), "|");
}

static const char *warnings(const char *text)
{
    static char said[1024];
    const struct mml_settings heard = { .limit = 1, .title = "", .warn = keep_warning, .context = said };
    char err[256];
    uint8_t *bytes;
    size_t size;

    said[0] = '\0';
    assert_true(mml_compile(text, strlen(text), "x.mml", &heard, &bytes, &size, err, sizeof err));
    free(bytes);
    return said;
}

/* At 120 a frame is 16 ticks. What is near the first note of a track takes nothing away. */
TEST(warnings)
{
    assert_string_equal(warnings("A c4 d%16 e4"), "");
    assert_string_equal(warnings("A c%15 d4"), "");
    assert_string_equal(warnings("A c4\nA [d%15 e4]3"), "x.mml:2:9: this note starts within one frame (1/60 s) of the "
                                                        "previous note in its track and cuts that note off|");
    assert_string_equal(warnings("A c4 t60 d%15 e4"), "");
}

RUN_TESTS(NULL, NULL)
