#!/usr/bin/env python3
"""music.py - checks the music of a game against what is declared beside it, and how music and sounds are mixed.

    music.py [--curtain PROGRAM] GAME [NAME...]           notes: key, chords, form (docs/measured/music.md)
    music.py [--curtain PROGRAM] --levels GAME [NAME...]  loudness, peaks, loops
    music.py [--curtain PROGRAM] --sounds GAME [NAME...]  the sounds: length, peak, level
    music.py [--curtain PROGRAM] --fights GAME [DEMO...]  the sound of boss fights in demos
    music.py [--curtain PROGRAM] --page GAME              docs/measured/music.md

Prints a line of figures for each piece, and a sentence for each fault; exit code 1: there was one. Notes come from
`curtain sound GAME NAME --notes`, which is the packed tune as the board reads it, so MML is not read here: of a file
only the lines that begin with `;=`.
"""
import array, cmath, concurrent.futures, functools, itertools, json, math, os, re, shutil, statistics, subprocess
import sys, tempfile, wave

# What is asked for. Shares are of 1.
IN_SCALE, BASS_FITS, ROOTS, HARMONY_FITS = 0.85, 0.85, 0.75, 0.85
STRONG_FITS, CLASHES, STEPS = 0.60, 0.04, 0.35
REPEATED, SECTIONS, SINGS, RESTS = 0.5, 3, 0.45, 2.0
LONG, SHORT = 60.0, (8.0, 20.0)
SPREAD, PEAK, ROUND, DC = 2.0, -1.0, 0.01, 1e-3
SIDE, RISE, COVER, TONE, BURST = -8.0, 6.0, -3.0, 0.3, 0.02
SOUND_PEAK, SOUND_LEVEL, SOUND_LONG = (-34.0, -3.0), (-40.0, -9.0), 6.0

STEP = {"C": 0, "D": 2, "E": 4, "F": 5, "G": 7, "A": 9, "B": 11}
SCALES = {
    "major": (0, 2, 4, 5, 7, 9, 11), "minor": (0, 2, 3, 5, 7, 8, 10), "harmonic minor": (0, 2, 3, 5, 7, 8, 11),
    "dorian": (0, 2, 3, 5, 7, 9, 10), "phrygian": (0, 1, 3, 5, 7, 8, 10), "lydian": (0, 2, 4, 6, 7, 9, 11),
    "mixolydian": (0, 2, 4, 5, 7, 9, 10), "melodic minor": (0, 2, 3, 5, 7, 9, 11),
}
CHORDS = {
    "": (0, 4, 7), "m": (0, 3, 7), "5": (0, 7), "7": (0, 4, 7, 10), "m7": (0, 3, 7, 10), "maj7": (0, 4, 7, 11),
    "6": (0, 4, 7, 9), "m6": (0, 3, 7, 9), "9": (0, 2, 4, 7, 10), "m9": (0, 2, 3, 7, 10), "maj9": (0, 2, 4, 7, 11),
    "add9": (0, 2, 4, 7), "madd9": (0, 2, 3, 7), "sus2": (0, 2, 7), "sus4": (0, 5, 7), "7sus4": (0, 5, 7, 10),
    "dim": (0, 3, 6), "dim7": (0, 3, 6, 9), "m7b5": (0, 3, 6, 10), "aug": (0, 4, 8), "11": (0, 2, 5, 7, 10),
    "mmaj7": (0, 3, 7, 11), "7b9": (0, 1, 4, 7, 10), "m11": (0, 2, 3, 5, 7, 10), "6/9": (0, 2, 4, 7, 9),
}
ROLES = ("melody", "second", "harmony", "bass", "drums")


class Bad(Exception):
    pass


def pitch_class(name):
    return (STEP[name[0]] + {"": 0, "#": 1, "b": -1}[name[1:]]) % 12


def chord(word, where):
    """The pitch classes of a chord's name, and its bass."""
    m = re.fullmatch(r"([A-G][#b]?)(.*?)(?:/([A-G][#b]?))?", word)
    if not m or m.group(2) not in CHORDS:
        raise Bad(f'{where}: expected a chord like Am7 or C/E, got "{word}"')
    root = pitch_class(m.group(1))
    tones = {(root + s) % 12 for s in CHORDS[m.group(2)]}
    bass = pitch_class(m.group(3)) if m.group(3) else root
    return tones | {bass}, bass


ROMS = {}  # of a game that is asked for often: what it is packed to


# ---- what is declared ----

class Declared:
    """The lines `;=` of a file: key, form, tracks, and a line of chords for each section."""

    def __init__(self, path):
        self.key = self.tempo = None
        self.form, self.roles, self.bars = [], {}, {}
        if not os.path.exists(path):
            raise Bad(f"there is no {path}")
        with open(path, encoding="utf-8") as f:
            lines = f.readlines()
        for n, line in enumerate(lines, 1):
            if line.startswith(";="):
                self.read(line[2:].split(), f"{path}:{n}")
        for what, got in (("key", self.key), ("tempo", self.tempo), ("form", self.form), ("tracks", self.roles)):
            if not got:
                raise Bad(f'{path}: expected a line ";= {what}" (docs/measured/music.md)')
        for name in self.form:
            if self.section(name) is None:
                raise Bad(f'{path}: the form has {name}, and there is no line ";= {name}" of chords')

    def read(self, words, where):
        what = words[0] if words else ""
        rest = " ".join(words[1:])
        if what == "key":
            m = re.fullmatch(r"([A-G][#b]?) (.*)", rest)
            if not m or m.group(2) not in SCALES:
                raise Bad(f'{where}: expected ";= key D minor", got "{rest}"')
            self.key = rest
            self.scale = {(pitch_class(m.group(1)) + s) % 12 for s in SCALES[m.group(2)]}
        elif what == "tempo":
            self.tempo = float(rest)
        elif what == "form":
            self.form = words[1:]
        elif what == "tracks":
            for part in rest.split(","):
                role, *letters = part.split()
                if role not in ROLES or not letters:
                    raise Bad(f'{where}: expected one of {", ".join(ROLES)} and its tracks, got "{part.strip()}"')
                self.roles[role] = letters
        else:
            self.bars.setdefault(what, [])
            for bar in filter(str.strip, rest.split("|")):
                if bar.strip() == "%":
                    self.bars[what].append(self.bars[what][-1])
                else:
                    self.bars[what].append([chord(w, where) for w in bar.split()])

    def section(self, name):
        return self.bars.get(name) or self.bars.get(name.rstrip("'"))


# ---- what is played ----

class Tune:
    """Notes of tracks: (from, to, pitch) in ticks, as curtain prints them; up to the end of the first pass."""

    def __init__(self, curtain, game, name):
        self.notes, self.ends, self.loops, self.tempos = {}, {}, {}, []
        for line in run(curtain, "sound", ROMS.get(game, game), name, "--notes").splitlines():
            w = line.split()
            if w[0] == "tune":
                self.quarter, self.beats = int(w[2]), int(w[3])
            elif w[2] == "loop":
                self.ends[w[0]], self.loops[w[0]] = int(w[1]), int(w[3])
            elif w[2] == "end":
                self.ends.setdefault(w[0], int(w[1]))
            elif w[2] == "tempo":
                self.tempos.append((int(w[1]), float(w[3])))
            elif w[0] != "-":
                self.event(w[0], int(w[1]), w[2], w[3:])
        for track, notes in self.notes.items():
            end = self.ends[track]
            self.notes[track] = [(a, min(end if b is None else b, end), p) for a, b, p in notes if a < end]
        own = {t: e for t, e in self.ends.items() if t != "-"}
        self.loop = min((v for t, v in self.loops.items() if t != "-"), default=None)
        self.end = max(own.values()) if self.loop is None else min(e for t, e in own.items() if t in self.loops)

    def event(self, track, tick, what, values):
        notes = self.notes.setdefault(track, [])
        if what in ("note", "slur", "off") and notes and notes[-1][1] is None:
            notes[-1][1] = tick
        if what in ("note", "slur"):
            notes.append([tick, None, round(float(values[0]))])
        if what == "glide":
            notes[-1][2] = round(float(values[0]))

    def seconds(self, tick):
        at, t, tempo = 0, 0.0, 120.0
        for when, value in sorted(x for x in self.tempos if x[0] < tick):
            t += (when - at) * 60 / tempo / self.quarter
            at, tempo = when, value
        return t + (tick - at) * 60 / tempo / self.quarter


def run(*command):
    done = subprocess.run(command, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True, check=False)
    if done.returncode:
        raise Bad(f'{" ".join(command)}: {(done.stderr or done.stdout).strip()}')
    return done.stdout


# ---- notes against what is declared ----

def percent(x):
    return f"{100 * x:.0f} %"


def share(part, of):
    return part / of if of else 0.0


class Piece:
    def __init__(self, name, d, t):
        self.name, self.d, self.t, self.faults, self.row = name, d, t, [], []
        self.bar = t.beats * t.quarter
        self.sections, self.spans, at = [], [], 0
        for section in d.form:
            bars = d.section(section)
            self.sections.append((section, at, at + len(bars)))
            for bar in bars:
                for i, (tones, bass) in enumerate(bar):
                    a = at * self.bar + i * self.bar // len(bar)
                    self.spans.append((a, at * self.bar + (i + 1) * self.bar // len(bar), tones, bass))
                at += 1
        self.n_bars = at

    def fault(self, text):
        self.faults.append(f"{self.name}: {text}")

    def at_least(self, what, got, least, more=""):
        if got < least:
            self.fault(f"expected at least {100 * least:.0f} % of {what}, got {100 * got:.1f} %{more}")

    def of(self, role):
        return sorted(n for track in self.d.roles.get(role, ()) for n in self.t.notes.get(track, ()))

    def span(self, tick):
        return next((s for s in self.spans if s[0] <= tick < s[1]), self.spans[-1])

    def fits(self, notes):
        """The share of the notes' time in which they are tones of the chord."""
        good = every = 0
        for a, b, p in notes:
            for s0, s1, tones, _ in self.spans:
                time = min(b, s1) - max(a, s0)
                if time > 0:
                    every += time
                    good += time if p % 12 in tones else 0
        return share(good, every)

    def length(self):
        t, end = self.t, self.n_bars * self.bar
        tail = self.bar if t.loop is None else 0  # an echo may ring on behind a piece that ends
        if not end <= t.end <= end + tail:
            self.fault(f"expected {self.n_bars} bars, as the form says, got {t.end / self.bar:g}")
        if t.loop is not None and t.loop not in [a * self.bar for _, a, _ in self.sections]:
            self.fault(f"expected its loop to begin with a section, got bar {t.loop / self.bar + 1:g}")
        s = t.seconds(t.end)
        if t.loop is not None and s < LONG:
            self.fault(f"expected {LONG:g} seconds before it repeats, got {s:.1f}")
        if t.loop is None and not SHORT[0] <= s <= SHORT[1]:
            self.fault(f"expected a piece without a loop to last {SHORT[0]:g} to {SHORT[1]:g} seconds, got {s:.1f}")
        if not t.tempos or abs(t.tempos[0][1] - self.d.tempo) > 0.005:
            self.fault(f"expected tempo {self.d.tempo:g}, got {t.tempos[0][1] if t.tempos else 120:g}")
        return s

    def scale(self):
        notes = [n for role in ROLES[:4] for n in self.of(role)]
        got = share(sum(p % 12 in self.d.scale for _, _, p in notes), len(notes))
        self.at_least(f"the notes in {self.d.key}", got, IN_SCALE)
        return got

    def roots(self):
        """The share of chords whose first note of the bass is the chord's root, or what stands behind its slash."""
        bass, good, every = self.of("bass"), 0, 0
        for a, b, _, root in self.spans:
            p = next((p for x, y, p in bass if x < b and y > a), None)
            if p is not None:
                every += 1
                good += p % 12 == root
        return share(good, every)

    def strong(self):
        """The share of melody notes on the first and the middle beat that are tones of the chord."""
        half = self.bar // 2 if self.t.beats % 2 == 0 else self.bar
        notes = [(a, p) for a, _, p in self.of("melody") if a % half == 0]
        return share(sum(p % 12 in self.span(a)[2] for a, p in notes), len(notes))

    def clashes(self):
        """The share of the melody's time a semitone above a tone of the chord, without being one, in notes of a beat
        or more."""
        bad = every = 0
        for a, b, p in self.of("melody"):
            tones = self.span(a)[2]
            every += b - a
            if b - a >= self.t.quarter and p % 12 not in tones and (p - 1) % 12 in tones:
                bad += b - a
        return share(bad, every)

    def rub(self):
        """Where melody, second part and harmony stand a semitone apart, in one octave, for a beat."""
        parts = [self.of(role) for role in ROLES[:3]]
        for i, j in ((0, 1), (0, 2), (1, 2)):
            for a, b, p in parts[i]:
                for c, d, q in parts[j]:
                    if abs(p - q) == 1 and 10 * (min(b, d) - max(a, c)) >= 9 * self.t.quarter:
                        at = max(a, c) / self.bar + 1
                        self.fault(f"{ROLES[i]} and {ROLES[j]} are a semitone apart for a beat in bar {int(at)}")
                        return

    def line(self):
        """Of the melody: the share of steps up to a whole tone among moves, the widest leap, its range."""
        p = [n[2] for n in self.of("melody")]
        moves = [abs(y - x) for x, y in zip(p, p[1:]) if x != y]
        return share(sum(m <= 2 for m in moves), len(moves)), max(moves, default=0), max(p) - min(p)

    def sings(self):
        """The longest rest of the melody in bars, once it has begun; the share of bars in which it sounds."""
        m = self.of("melody")
        at, rest = m[0][1], 0
        for a, b, _ in m:
            rest, at = max(rest, a - at), max(at, b)
        bars = {k for a, b, _ in m for k in range(a // self.bar, (b - 1) // self.bar + 1)}
        return rest / self.bar, share(len(bars), self.n_bars)

    def prints(self, roles):
        """What is played in each bar."""
        bars = [[] for _ in range(self.n_bars)]
        for role in roles:
            for a, b, p in self.of(role):
                if a // self.bar < self.n_bars:
                    bars[a // self.bar].append((role, a % self.bar, b - a, p))
        return [tuple(sorted(b)) for b in bars]

    def again(self, roles):
        """The share of bars that are equal to an earlier one."""
        bars, first = self.prints(roles), {}
        return sum(first.setdefault(b, k) != k for k, b in enumerate(bars)) / len(bars)

    def repeats(self):
        """The share of bars that are equal to an earlier one, of all parts or of the melody alone; sections."""
        bars = self.prints(ROLES[:4])
        return max(self.again(ROLES[:4]), self.again(ROLES[:1])), len({tuple(bars[a:b]) for _, a, b in self.sections})

    def check(self):
        d = self.d
        for role in ROLES:
            if not self.of(role):
                self.fault(f"expected a {role}: no note of its tracks {' '.join(d.roles.get(role, [])) or '(none)'}")
        if self.faults:
            return
        seconds, scale = self.length(), self.scale()
        bass, roots, harmony = self.fits(self.of("bass")), self.roots(), self.fits(self.of("harmony"))
        self.at_least("the bass's time on the chords", bass, BASS_FITS)
        self.at_least("chords begun by the bass's root", roots, ROOTS)
        self.at_least("the harmony's time on the chords", harmony, HARMONY_FITS)
        strong, clashes, (steps, leap, wide) = self.strong(), self.clashes(), self.line()
        self.at_least("the melody's strong beats on the chords", strong, STRONG_FITS)
        self.at_least("the melody's moves in steps", steps, STEPS)
        if clashes > CLASHES:
            self.fault(f"the melody rubs against the chord in {100 * clashes:.1f} % of its time, {100 * CLASHES:g} % "
                       "at most")
        self.rub()
        rest, sings = self.sings()
        if rest > RESTS:
            self.fault(f"the melody rests for {rest:.1f} bars, {RESTS:g} at most")
        self.at_least("the bars with a melody", sings, SINGS)
        again, sections = self.repeats()
        if again > REPEATED:
            self.fault(f"{100 * again:.0f} % of the bars are as an earlier one, {100 * REPEATED:.0f} % at most")
        if sections < SECTIONS:
            self.fault(f"expected {SECTIONS} sections that differ, got {sections}")
        self.row = [("key", d.key), ("tempo", f"{d.tempo:g}"), ("bars", str(self.n_bars)),
                    ("seconds", f"{seconds:.1f}"),
                    ("in the scale", percent(scale)), ("bass on chords", percent(bass)), ("on roots", percent(roots)),
                    ("harmony", percent(harmony)), ("melody", percent(strong)), ("clashes", percent(clashes)),
                    ("steps", percent(steps)), ("leap", str(leap)), ("range", str(wide)), ("rests", f"{rest:.1f}"),
                    ("sounding", percent(sings)), ("repeated", percent(again)), ("sections", str(sections))]

    def likeness(self):
        chords = tuple((frozenset(t), b) for _, _, t, b in self.spans)
        return self.d.key, self.d.tempo, chords


def check_notes(curtain, game, names):
    rows, faults, like = {}, [], {}
    for name in names:
        piece = Piece(name, Declared(os.path.join(game, "music", name + ".mml")), Tune(curtain, game, name))
        piece.check()
        faults += piece.faults
        rows[name] = piece.row
        other = like.setdefault(piece.likeness(), name)
        if other != name:
            faults.append(f"{name}: key, tempo and chords are those of {other}")
    return rows, faults


# ---- levels ----

def decibels(x):
    return 20 * math.log10(x / 32768) if x > 0 else -120.0


def render(curtain, game, name, folder):
    """The samples, and how loud curtain finds them (LUFS)."""
    path = os.path.join(folder, name + ".wav")
    said = run(curtain, "sound", ROMS.get(game, game), name, "-o", path)
    with wave.open(path) as w:
        samples = array.array("h", w.readframes(w.getnframes()))
    if sys.byteorder == "big":
        samples.byteswap()
    return samples, float(re.search(r"(\S+) LUFS", said).group(1))


def undrummed(curtain, game, name, drums, folder):
    """The samples of a piece without its drums, in which a click cannot hide."""
    with open(os.path.join(game, "music", name + ".mml"), encoding="utf-8") as f:
        lines = [x for x in f if not re.match(rf"[{''.join(drums)}] ", x)]
    os.mkdir(os.path.join(folder, "music"))
    for path, text in (("music/" + name + ".mml", "".join(lines)), ("main.lua", ""),
                       ("rom.lua", f'return {{ title = "-", music = {{ {name} = {{ file = "music/{name}.mml" }}}}}}')):
        with open(os.path.join(folder, path), "w", encoding="utf-8") as f:
            f.write(text)
    return render(curtain, folder, name, folder)[0]


def click(samples, at):
    """The largest second differences within a hundredth of a second of frame `at`, and in four seconds around it."""
    return bend(samples, at - 480, at + 480), max(bend(samples, at - 192000, at - 480),
                                                  bend(samples, at + 480, at + 192000))


def bend(samples, frm, to):
    """The largest second difference in frames frm to to, of either side."""
    most = 0
    for side in (0, 1):
        x = samples[2 * max(frm, 0) + side:2 * to + side:2]
        most = max(most, max((abs(a - 2 * b + c) for a, b, c in zip(x, x[1:], x[2:])), default=0))
    return most


def measure(samples, limit=16384, block=4096):
    """The peak, the mean of the side that is further off, and the share beyond limit."""
    n, peak, over = len(samples) or 1, 0, 0
    for i in range(0, len(samples), block):
        part = samples[i:i + block]
        most = max(max(part), -min(part))
        peak, over = max(peak, most), over + (sum(abs(s) > limit for s in part) if most > limit else 0)
    left, right = sum(samples[0::2]) * 2 / n / 32768, sum(samples[1::2]) * 2 / n / 32768
    return peak, max(abs(left), abs(right)), over / n


def spread(loud):
    """A fault if the loudest and the quietest are further apart."""
    low, high = min(loud, key=loud.get), max(loud, key=loud.get)
    if loud[high] - loud[low] <= SPREAD:
        return []
    return [f"{high} is {loud[high] - loud[low]:.1f} LU louder than {low}, {SPREAD:g} at most"]


def flaws(name, samples):
    """Peak, mean and what is bent, and faults."""
    peak, dc, curve = measure(samples)
    faults = []
    if decibels(peak) > PEAK:
        faults.append(f"{name}: its peak is {decibels(peak):.1f} dB, {PEAK:g} at most")
    if curve > ROUND:
        faults.append(f"{name}: {100 * curve:.1f} % of it is in the limiter's curve, {100 * ROUND:g} % at most")
    if dc > DC:
        faults.append(f"{name}: its mean is {dc:.4f}, {DC:g} at most")
    return [("peak, dB", f"{decibels(peak):.1f}"), ("in limiter curve", f"{100 * curve:.2f} %"),
            ("mean", f"{dc:.6f}")], faults


def check_loop(curtain, game, name, tune):
    at = round(48000 * tune.seconds(tune.end))
    with tempfile.TemporaryDirectory() as folder:
        drums = Declared(os.path.join(game, "music", name + ".mml")).roles.get("drums", [])
        samples = undrummed(curtain, game, name, drums, folder)
    if 2 * at + 2 * 192000 > len(samples):
        return [], [f"{name}: expected its loop within 116 seconds, got {at / 48000:.1f}"]
    here, near = click(samples, at)
    return [("second difference at the loop", f"{here} of {near}")], [
        f"{name}: a click where it repeats: second difference {here}, {near} around it"] if here > near else []


def level(curtain, game, name):
    """Of one piece: its row, its faults, how loud it is."""
    tune = Tune(curtain, game, name)
    with tempfile.TemporaryDirectory() as folder:
        samples, loud = render(curtain, game, name, folder)
    flat, faults = flaws(name, samples)
    wide = side(samples)
    faults += narrow(name, wide)
    looped, clicks = check_loop(curtain, game, name, tune) if tune.loop is not None else ([], [])
    row = [("LUFS", f"{loud:.1f}"), ("side, dB", f"{wide:.1f}")] + flat
    row += looped or [("second difference at the loop", "-")]
    return row, faults + clicks, loud


def side(samples, every=8):
    """The side channel's level relative to the mid channel's, in dB, from one frame in `every`."""
    left, right = samples[0::2 * every], samples[1::2 * every]
    mid = sum((a + b) ** 2 for a, b in zip(left, right))
    return 10 * math.log10((sum((a - b) ** 2 for a, b in zip(left, right)) or 1) / (mid or 1))


def narrow(name, wide):
    if wide >= SIDE:
        return []
    return [f"{name}: its side channel is {-wide:.1f} dB below the mid channel, {-SIDE:g} at most"]


def check_levels(curtain, game, names):
    with concurrent.futures.ProcessPoolExecutor() as pool:
        found = dict(zip(names, pool.map(functools.partial(level, curtain, game), names)))
    faults = [fault for _, bad, _ in found.values() for fault in bad]
    return ({name: row for name, (row, _, _) in found.items()},
            faults + spread({name: loud for name, (_, _, loud) in found.items()}))


def loudest(samples, frames=2400):
    """The root mean square of the loudest stretch of a twentieth of a second."""
    squares = [0]
    squares += itertools.accumulate(a * a + b * b for a, b in zip(samples[0::2], samples[1::2]))
    if len(squares) <= frames:
        return (squares[-1] / 2 / frames) ** 0.5
    return (max(y - x for x, y in zip(squares, squares[frames:])) / 2 / frames) ** 0.5


def heard(samples):
    """Frames until it stays below -60 dB."""
    return next((i // 2 + 1 for i in range(len(samples) - 1, -1, -1) if abs(samples[i]) > 32), 0)


def check_sounds(curtain, game, names):
    rows, faults = {}, []
    for name in names:
        with tempfile.TemporaryDirectory() as folder:
            samples, _ = render(curtain, game, name, folder)
        (peak, dc, curve), long = measure(samples), heard(samples) / 48000
        level = decibels(loudest(samples))
        dc *= min(1, len(samples) / 96000)
        rows[name] = [("seconds", f"{long:.2f}"), ("peak, dB", f"{decibels(peak):.1f}"),
                      ("loudest, dB", f"{level:.1f}")]
        for what, got, (low, high) in (("peak", decibels(peak), SOUND_PEAK), ("loudest twentieth of a second", level,
                                                                             SOUND_LEVEL)):
            if not low <= got <= high:
                faults.append(f"{name}: expected its {what} from {low:g} to {high:g} dB, got {got:.1f}")
        if long > SOUND_LONG:
            faults.append(f"{name}: expected {SOUND_LONG:g} seconds at most, got {long:.1f}")
        if dc > DC or curve > ROUND:
            faults.append(f"{name}: its mean is {dc:.4f} ({DC:g} at most), {100 * curve:.1f} % in the limiter's curve")
    return rows, faults


# ---- boss fights ----

DEMOS = [os.path.join(os.path.dirname(os.path.abspath(__file__)), "../../../tests/demos/glasstide/clear-normal.demo")]
SECOND, FFT = 48000, 1024
TURNS = {n: [cmath.exp(-2j * cmath.pi * k / n) for k in range(n // 2)] for n in (2 ** i for i in range(1, 11))}


def fights(moments):
    """The boss, the first frame and the frame of the death, for each boss that is shot down."""
    boss, start, won = None, 0, None
    for m in moments + [{"kind": "over", "frame": 0, "name": ""}]:
        if m["kind"] in ("mark", "clear", "over", "boss"):
            if won:
                yield boss, start, won
            boss, start, won = (m["name"], m["frame"], None) if m["kind"] == "boss" else (None, 0, None)
        elif m["kind"] in ("won", "lost"):
            won = m["frame"] if m["kind"] == "won" else None


def fft(x):
    if len(x) == 1:
        return x
    even = fft(x[0::2])
    odd = [r * y for r, y in zip(TURNS[len(x)], fft(x[1::2]))]
    return [a + b for a, b in zip(even, odd)] + [a - b for a, b in zip(even, odd)]


def tone(samples, windows=300):
    """The strongest three bins' share of the power above 1500 Hz, in windows spread over the samples."""
    hann = [0.5 - 0.5 * math.cos(2 * math.pi * i / FFT) for i in range(FFT)]
    power = [0.0] * (FFT // 2)
    step = (len(samples) // 2 - FFT) // windows
    for i in range(0, windows, 2):  # two windows at a time, as the real and the imaginary part
        a, b = (samples[2 * k * step:2 * (k * step + FFT):2] for k in (i, i + 1))
        z = fft([complex(x * h, y * h) for x, y, h in zip(a, b, hann)])
        for k in range(1, FFT // 2):
            power[k] += abs(z[k]) ** 2 + abs(z[-k]) ** 2
    high = power[1500 * FFT // SECOND:]
    return max(map(sum, zip(high, high[1:], high[2:]))) / (sum(high) or 1)


def power(samples):
    return sum(x * x for x in samples) / (len(samples) or 1)


def median_second(samples):
    """The median of the power of each second, from one sample in 61."""
    return statistics.median(power(samples[i:i + 2 * SECOND:61]) for i in range(0, len(samples), 2 * SECOND))


def stretch(w, frm, to):
    """The samples of a WAV from a frame of the game to another."""
    w.setpos(min(max(frm, 0) * SECOND // 60, w.getnframes()))
    samples = array.array("h", w.readframes((to - max(frm, 0)) * SECOND // 60))
    if sys.byteorder == "big":
        samples.byteswap()
    return samples


def fight(name, mix, sounds, start, death):
    """The row and the faults of a fight: mix is the WAV of the run, sounds the WAV without its music."""
    all_of_it, effects = stretch(mix, start, death), stretch(sounds, start, death)
    end = stretch(mix, death, death + 240)
    before = power(stretch(mix, death - 300, death)) ** 0.5
    loud, (_, _, curve), wide, strongest = loudest(end, SECOND), measure(end), side(all_of_it, 32), tone(effects)
    whole, part = median_second(all_of_it), median_second(effects)
    cover = 10 * math.log10((part or 1) / max(whole - part, 1))
    rise = decibels(loud) - decibels(before)
    faults = narrow(name, wide)
    for what, got, good, limit in (
            ("the rise at its death", f"{rise:.1f} dB", rise >= RISE, f"at least {RISE:g} dB"),
            ("its death in the limiter's curve", f"{100 * curve:.1f} %", curve <= BURST, f"at most {100 * BURST:g} %"),
            ("the level of sounds over music", f"{cover:.1f} dB", cover <= COVER, f"at most {COVER:g} dB"),
            ("the strongest tone of its sounds", percent(strongest), strongest <= TONE, f"at most {percent(TONE)}")):
        if not good:
            faults.append(f"{name}: expected {what} to be {limit}, got {got}")
    return [("seconds", f"{(death - start) / 60:.0f}"), ("before, dB", f"{decibels(before):.1f}"),
            ("death, dB", f"{decibels(loud):.1f}"), ("rise, dB", f"{rise:.1f}"),
            ("in limiter curve", f"{100 * curve:.2f} %"), ("side, dB", f"{wide:.1f}"),
            ("sounds over music, dB", f"{cover:.1f}"), ("strongest tone", percent(strongest))], faults


def silenced(game, folder):
    """A copy of the game with silent music."""
    shutil.copytree(game, folder)
    path = os.path.join(folder, "rom.lua")
    with open(path, encoding="utf-8") as f:
        head, mark, music = f.read().partition("\n  music = {")
    with open(path, "w", encoding="utf-8") as f:
        f.write(head + mark + re.sub(r"volume = [\d.]+", "volume = 0", music))
    return folder


def check_fights(curtain, game, demos):
    rows, faults = {}, []
    for demo in demos:
        with tempfile.TemporaryDirectory() as folder, concurrent.futures.ThreadPoolExecutor() as pool:
            ran = pool.submit(subprocess.run, [curtain, "verify", "--json", game, demo], capture_output=True)
            wavs = [os.path.join(folder, name) for name in ("mix.wav", "sounds.wav")]
            told = json.loads(ran.result().stdout or "{}")
            if told.get("verdict") != "holds":
                raise Bad(f"{demo}: expected a demo that holds")
            list(pool.map(lambda at: run(curtain, "render", at[0], "--demo", demo, "--frames", str(told["frames"]),
                                         "--wav", at[1], "-o", folder),
                          zip((game, silenced(game, os.path.join(folder, "game"))), wavs)))
            with wave.open(wavs[0]) as mix, wave.open(wavs[1]) as sounds:
                for boss, start, death in fights(told["moments"]):
                    rows[boss], bad = fight(boss, mix, sounds, start, death)
                    faults += bad
    return rows, faults if rows else ["no boss is shot down in " + " ".join(demos)]


# ---- the page ----

MEASURED = os.path.join(os.path.dirname(os.path.abspath(__file__)), "../../../tools/docs/measured.sh")

PAGE = """# The music of Glass Tide

`roms/glasstide/source/music.py --page roms/glasstide >docs/measured/music.md` writes this page;
[music.sh](../../tests/cli/music.sh) checks it.

The game has {count} pieces and {sounds} sounds, all written in MML, in [music](../../{game}/music) and
[sfx](../../{game}/sfx). All pieces share a motif of scale degrees, 1 5 4 | 5 2 3. The motif is like a wave: it
rises, falls back, and then rises less than before.

{measured}

The column *form and bars* lists the sections of each piece, each with its number of bars.

| piece | title | used for | key | tempo | form and bars | seconds |
|---|---|---|---|---|---|---|
{pieces}

## Declarations and checks

Comments in each piece declare its key, tempo, form, tracks and chords:

```
;= key D minor
;= tempo 132
;= form intro A A' B turn
;= tracks melody A, second C, harmony E F G, bass I, drums J K L M
;= intro  Dm | Dm/F | Bbmaj7 | A7sus4 A7
;= A      Dm9 | Fmaj7/A | Bbmaj7 | C
```

`form` lists the sections. For each section, a line that starts with the section's name lists the chords: `|` separates
bars, two chords in a bar last half a bar each, and `%` repeats the previous bar. If `A'` has no line, it uses the
chords of `A`. A key can be major, minor, harmonic minor, melodic minor, dorian, phrygian, lydian or mixolydian.

`music.py GAME` reads the notes from the packer (`curtain sound GAME NAME --notes`) and checks them against these
rules:

| | required |
|---|---|
{rules}

A looping piece lasts at least {long:g} seconds before it loops, and the loop starts at the beginning of a section. A
piece that does not loop lasts {short[0]:g} to {short[1]:g} seconds. No two pieces have the same key, tempo and chords.

The table shows the results. *Leap* is the melody's widest interval, and *range* is the distance from its
lowest to its highest note, both in semitones. *Rests* is the melody's longest rest in bars, and *sections* is the
number of different sections.

{notes}

## Levels

`curtain sound` prints the loudness of a piece, measured as in ITU-R BS.1770. These limits apply:

* Any two pieces differ in loudness by at most {spread:g} LU.
* The peak of a piece is at most {peak:g} dB.
* At most {round:g} % of the samples of a piece are in the curved part of the limiter.
* The side channel (left minus right) of a piece is at most {side:g} dB below the mid channel (left plus right). Parts
  are only panned, so mono output has all of them, at most 3 dB softer.
* The mean of the samples is at most {dc:g} of full scale.
* There is no click where the piece loops. For this test, the piece is rendered without drums. The *second difference*
  is the change in slope from sample to sample. Within 10 ms of the loop point, the second difference must not exceed
  its maximum in the rest of the eight seconds around the loop point.

{levels}

## Sounds

Each sound is measured until it stays below -60 dB. *Loudest* is the root mean square of its loudest 50 ms.

{heard}

## Boss fights

`music.py --fights` plays the demo [clear-normal](../../tests/demos/glasstide/clear-normal.demo) twice, once without
music, and measures the sound of each fight:

| | measured | required |
|---|---|---|
| before | root mean square of the last 5 seconds of the fight | |
| death | root mean square of the loudest second of the 4 seconds after the boss's death | |
| rise | death over before | at least {rise:g} dB |
| in limiter curve | samples of these 4 seconds in the curved part of the limiter | at most {burst:g} % |
| side | side channel of the fight, relative to the mid channel | at least {low:g} dB |
| sounds over music | median level of the sounds in a second, relative to that of the music | at most {cover:g} dB |
| strongest tone | share of the strongest tone, 140 Hz wide, in the power of the sounds above 1500 Hz | at most {tone} |

{fights}

## Cost

{cost}
"""

RULES = (
    ("notes of melody, second part, harmony and bass that are in the scale", IN_SCALE),
    ("time in which the bass plays chord tones", BASS_FITS),
    ("chords on which the bass starts with the root or the note after `/`", ROOTS),
    ("time in which the harmony plays chord tones", HARMONY_FITS),
    ("melody notes on strong beats that are chord tones", STRONG_FITS),
    ("melody moves of at most a whole tone", STEPS), ("bars in which the melody sounds", SINGS),
)
LIMITS = (
    ("time in which the melody plays long notes a semitone above a chord tone", "at most " + percent(CLASHES)),
    ("bars that repeat an earlier bar, in all parts or in the melody alone", "at most " + percent(REPEATED)),
    ("the melody's longest rest", f"at most {RESTS:g} bars"),
    ("longest clash of a semitone between melody, second part and harmony", "less than a beat"),
)


def table(rows):
    head = [label for label, _ in next(iter(rows.values()))]
    return "\n".join(["| | " + " | ".join(head) + " |", "|---" * (len(head) + 1) + "|"] +
                     [f"| {name} | " + " | ".join(text for _, text in row) + " |" for name, row in rows.items()])


def about(game, name, where):
    """A line of the first table."""
    d = Declared(os.path.join(game, "music", name + ".mml"))
    with open(os.path.join(game, "music", name + ".mml"), encoding="utf-8") as f:
        title = re.search(r"^#title (.*)$", f.read(), re.M).group(1)
    form = " ".join(f"{s} {len(d.section(s))}" for s in d.form)
    return f"| `{name}` | {title} | {where} | {d.key} | {d.tempo:g} | {form} |"


WHERE = {"title": "title", "opening": "the prologue", "tide": "stage one", "works": "stage two",
         "abyss": "stage three", "caravan": "the caravan", "lantern": "midbosses", "claws": "the Chandelier Crab",
         "furnace": "Cinder and Quench", "queen": "the Queen", "moon": "the Drowned Moon", "clear": "game won",
         "over": "game over", "ending": "endings", "true_ending": "the true ending", "staff": "the staff roll",
         "scores": "scores"}


def page(curtain, game):
    pieces, sounds = listed(curtain, game, "music"), listed(curtain, game, "sound")
    (notes, bad), (levels, worse) = check_notes(curtain, game, pieces), check_levels(curtain, game, pieces)
    heard_rows, worst = check_sounds(curtain, game, sounds)
    fought, worse_still = check_fights(curtain, game, DEMOS)
    seconds = {name: dict(row).get("seconds", "-") for name, row in notes.items()}
    rules = [f"| {what} | at least {percent(least)} |" for what, least in RULES]
    rules += [f"| {what} | {most} |" for what, most in LIMITS]
    sizes = dict(re.findall(r"^\w+ (\w+): (?:.*, )?([\d,]+) bytes", listing(curtain, game), re.M))
    print(PAGE.format(
        measured=run(MEASURED).strip(),
        count=len(pieces), sounds=len(sounds), game=game, notes=table(notes), levels=table(levels),
        heard=table(heard_rows), long=LONG, short=SHORT, spread=SPREAD, peak=PEAK, round=100 * ROUND, dc=DC,
        side=-SIDE, low=SIDE, rise=RISE, burst=100 * BURST, cover=COVER, tone=percent(TONE), fights=table(fought),
        pieces="\n".join(f"{about(game, n, WHERE.get(n, ''))} {seconds[n]} |" for n in pieces),
        rules="\n".join(rules),
        cost=COST.format(music=sum(int(sizes[n]) for n in pieces), sounds=sum(int(sizes[n]) for n in sounds))), end="")
    return bad + worse + worst + worse_still


COST = """The ROM has {music:,} bytes of music and {sounds:,} bytes of sounds.

Rendering the sound for one frame takes:

* on the title screen: 0.68 million instructions
* in a stage while the ship fires: 1.35 million instructions
* in the queen's last phase: 1.42 million instructions

On the machine named in [speed.md](speed.md), 1.42 million instructions take 70 microseconds, 0.4 % of a frame.

Callgrind counted the instructions for frames 600 to 1200, with and without `--wav`; the numbers are the differences.
The command for the stage is `curtain render roms/glasstide --press fire --invincible --stage one`. The command for the
queen uses `--stage queen/flower`. The command for the title screen has none of the options `--press`, `--invincible`
and `--stage`.

Sound is not part of the game state: a run has the same hashes with and without it."""

# ---- the command ----

@functools.lru_cache
def listing(curtain, game):
    return run(curtain, "sound", ROMS.get(game, game))


def listed(curtain, game, what):
    return [m.group(1) for m in re.finditer(rf"^{what} (\w+):", listing(curtain, game), re.M)]


CHECKS = {"--levels": (check_levels, "music"), "--sounds": (check_sounds, "sound"), "--notes": (check_notes, "music"),
          "--fights": (check_fights, "demo")}


def main(args):
    curtain, option = "build/curtain-null", "--notes"
    while args and args[0].startswith("--"):
        option = args.pop(0)
        if option == "--curtain" and args:
            curtain, option = args.pop(0), "--notes"
        elif option != "--page" and option not in CHECKS:
            raise Bad(__doc__.strip())
    if not args:
        raise Bad(__doc__.strip())
    game, names = args[0], args[1:]
    with tempfile.TemporaryDirectory() as folder:
        ROMS[game] = os.path.join(folder, "game.rom")
        run(curtain, "pack", game, "-o", ROMS[game])
        return told(curtain, option, game, names)


def told(curtain, option, game, names):
    if option == "--page":
        faults = page(curtain, game)
    else:
        check, what = CHECKS[option]
        rows, faults = check(curtain, game, names or (DEMOS if what == "demo" else listed(curtain, game, what)))
        for name, row in rows.items():
            print(f"{name}: " + ", ".join(f"{label} {text}" for label, text in row))
    for fault in faults:
        print(fault, file=sys.stderr)
    return 1 if faults else 0


if __name__ == "__main__":
    try:
        sys.exit(main(sys.argv[1:]))
    except Bad as bad:
        sys.exit(str(bad))
