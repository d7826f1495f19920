#!/usr/bin/env python3
"""Writes docs/survive.md and docs/game.md with its curves, docs/images/game-*.svg, of what tools/survive.sh left in a
folder: `survive_pages.py FOLDER`. The order of the game is that of the whole game in tests/demos/glasstide that came
through most of it."""
import glob
import json
import os
import subprocess
import sys

CURTAIN = os.environ.get("CURTAIN", "build/curtain-null")
COLOURS = ["#3a9d5d", "#2f7fc1", "#d08a1d", "#c23b4e"]  # of difficulties, the easiest first
BOTS = 16


def read(folder, game):
    """The sections of a game, as survive told them: {section: {difficulty: told}}, and both in their order."""
    told, sections, difficulties = {}, [], []
    for line in open(folder + "/list"):
        rom, section, difficulty = line.split()
        if os.path.basename(rom) != game:
            continue
        sections += [section] if section not in sections else []
        difficulties += [difficulty] if difficulty not in difficulties else []
        name = "%s-%s-%s" % (game, section.replace("/", "-").replace(":", "-"), difficulty)
        path = "%s/%s.json" % (folder, name)
        text = open(path).read().strip() if os.path.exists(path) else ""
        if text:
            told.setdefault(section, {})[difficulty] = json.loads(text.splitlines()[0])
    return told, sections, difficulties


def lived(one):
    return sum(kind["lived"] for name, kind in one["bots"].items() if name != "frames")


def last(one):
    return one["bots"]["frames"] / 60


def rate(one):
    """Hits a minute: how often the bots were hit, by the time that they flew. One that lives was not hit."""
    flown = BOTS * last(one)
    return 60 * (BOTS - lived(one)) / flown if flown else 0


def length(one):
    return (one["frames"] - one["begin"]) / 60


VERDICTS = {"lasted": "survived so far", "cannot": "cannot be survived", "not found": "no way found"}


def row(one):
    """As `survive --all` prints it."""
    good = one["verdict"] in ("survived", "lasted")
    gap = ">= %d.%d" % divmod(one["tenths"]["gap"], 10) if good else ""
    bullets = "%d.%d/s" % divmod(one["tenths"]["rate"], 10) if good else ""
    reaction = str(one["reaction"]) if good and one["aimed"] else ""
    return "%-24s %-10s %-18s %7.1f %5s %6.1f %9s %8s %8s" % (
        one["section"], one["difficulty"], VERDICTS.get(one["verdict"], one["verdict"]), length(one),
        "%d/%d" % (lived(one), BOTS), last(one), gap, bullets, reaction)


HEAD = "%-24s %-10s %-18s %7s %5s %6s %9s %8s %8s" % (
    "section", "difficulty", "verdict", "seconds", "bots", "last", "gap px", "bullets", "reaction")


def harder(easier, more):
    """Why a section at one difficulty is harder than at the next one; as measure_compare of src/cab/survive."""
    good = [one["verdict"] in ("survived", "lasted") for one in (easier, more)]
    if not all(good):
        return "no way was found there, and one then" if good[1] else ""
    live, live_then, frames, frames_then = lived(easier), lived(more), easier["bots"]["frames"], more["bots"]["frames"]
    a, b = easier["tenths"], more["tenths"]
    if live + 2 < live_then:
        return "%d of %d bots live, and %d then" % (live, BOTS, live_then)
    if live <= live_then and frames + frames // 5 + 60 < frames_then:
        return "bots last %.1f s, and %.1f then" % (frames / 60, frames_then / 60)
    if a["rate"] > b["rate"] * 1.1 + 10 and live <= live_then:
        return "%d bullets a second, and %d then" % (a["rate"] // 10, b["rate"] // 10)
    if 0 < a["gap"] < b["gap"] - 20 and live <= live_then:
        return "a narrowest gap of %.1f px, and %.1f then" % (a["gap"] / 10, b["gap"] / 10)
    return ""


def pairs(told, sections, difficulties):
    for section in sections:
        for a, b in zip(difficulties, difficulties[1:]):
            one, two = told.get(section, {}).get(a), told.get(section, {}).get(b)
            if one and two:
                yield section, a, b, one, two


def table(told, sections, difficulties):
    yield "```text"
    yield HEAD
    for section in sections:
        yield from (row(told[section][d]) for d in difficulties if d in told.get(section, {}))
    yield "```"


def holding(folder, game):
    text = open("%s/%s.verified" % (folder, game)).read()
    return "%d demos hold." % text.count(": holds,")


def survive_page(folder):
    yield """# What can be survived

Written by `make survive`: what `curtain survive` finds in every stage and every phase of a boss of *Glass Tide*, at
every difficulty, and on every page of the cookbook. [Chapter 29 of the manual](manual.md#29-can-it-be-survived) says
what the columns mean, and what they cannot say. Each run that was found is a demo that `curtain verify` was given;
those of phases are in `tests/demos/phases`. [game.md](game.md) has the curves.

`gap px` is the width of a ship that could still fly through, as far as that was tried (36 px); `last` is how many
seconds sixteen simple bots last, on average; `reaction` is in frames.

## Glass Tide
"""
    told, sections, difficulties = read(folder, "glasstide")
    yield from table(told, sections, difficulties)
    yield "\n%s\n\nWhat is harder where it should be easier:\n" % holding(folder, "glasstide")
    worse = ["* %s: %s is harder than %s: %s" % (section, a, b, why) for section, a, b, one, two in
             pairs(told, sections, difficulties) for why in [harder(one, two)] if why]
    yield from worse or ["Nothing."]
    yield "\n## The cookbook\n"
    yield from table(*read(folder, "cookbook"))
    yield "\n" + holding(folder, "cookbook")


# ---- the curves ----

def in_order(sections):
    """The sections as a game meets them; what no demo meets stands where survive lists it, at the end."""
    best = []
    for demo in glob.glob("tests/demos/glasstide/clear-*.demo"):
        said = subprocess.run([CURTAIN, "verify", "--json", "roms/glasstide", demo], capture_output=True, text=True)
        met, boss = [], ""
        for m in json.loads(said.stdout or "{}").get("moments", []):
            boss = m["name"] if m["kind"] == "boss" else boss
            name = {"stage": m["name"], "phase": "%s/%s" % (boss, m["name"])}.get(m["kind"])
            if name in sections and name not in met:
                met.append(name)
        best = met if len(met) > len(best) else best
    return best + [s for s in sections if s not in best]


def ceiling(v):
    return next(step for step in (5, 10, 15, 20, 30, 40, 60, 80, 100, 150, 200, 1e9) if step >= v)


def curve(told, sections, difficulties):
    step, left, top, height = 28, 44, 14, 220
    most = ceiling(max(rate(one) for s in sections for one in told.get(s, {}).values()))
    width, below = left + step * len(sections) + 12, top + height
    y = lambda v: below - height * v / most
    x = lambda i: left + step * i + step / 2
    yield '<svg xmlns="http://www.w3.org/2000/svg" width="%d" height="%d" font-family="sans-serif" font-size="11">' % (
        width, below + 118)
    yield '<rect width="100%" height="100%" fill="#fff"/>'
    for k in range(6):
        at = y(most * k / 5)
        yield '<path d="M%d %.1fH%d" stroke="#ddd"/><text x="%d" y="%.1f" text-anchor="end">%g</text>' % (
            left, at, width - 12, left - 6, at + 4, most * k / 5)
    for i, s in enumerate(sections):
        if "/" not in s:
            yield '<path d="M%.1f %dV%d" stroke="#bbb" stroke-dasharray="3 3"/>' % (x(i), top, below)
        yield '<text transform="translate(%.1f %d) rotate(-60)" text-anchor="end">%s</text>' % (x(i) + 4, below + 14, s)
    for d, colour in zip(difficulties, COLOURS):
        at = [(x(i), y(rate(told[s][d]))) for i, s in enumerate(sections) if d in told.get(s, {})]
        way = "L".join("%.1f %.1f" % p for p in at)
        yield '<path fill="none" stroke="%s" stroke-width="2" d="M%s"/>' % (colour, way)
        yield from ('<circle cx="%.1f" cy="%.1f" r="2.5" fill="%s"/>' % (*p, colour) for p in at)
    for i, (d, colour) in enumerate(zip(difficulties, COLOURS)):
        yield '<text x="%d" y="%d" fill="%s" font-weight="bold">%s</text>' % (left + 8 + 62 * i, top + 10, colour, d)
    yield "</svg>"


def falls(told, order, difficulties):
    """Where it does not rise: from a difficulty to the next, and from a boss's phase to its next one."""
    for section, a, b, one, two in pairs(told, order, difficulties):
        if rate(two) < 0.95 * rate(one):
            yield "* `%s`: %s hits less often than %s does, %.1f times a minute and %.1f." % (
                section, b, a, rate(two), rate(one))
    for s, t in zip(order, order[1:]):
        if "/" not in s or s.split("/")[0] != t.split("/")[0]:
            continue
        less = [d for d in difficulties if d in told.get(s, {}) and d in told.get(t, {}) and
                rate(told[t][d]) < 0.8 * rate(told[s][d])]
        if less:
            yield "* `%s` after `%s` is a rest on %s: %s hits a minute." % (
                t, s, " and ".join(filter(None, [", ".join(less[:-1]), less[-1]])),
                ", ".join("%.1f instead of %.1f" % (rate(told[t][d]), rate(told[s][d])) for d in less))


def bosses(order):
    names = []
    for s in order:
        if s.split("/")[0] not in names:
            names.append(s.split("/")[0])
    return names


def write(path, lines):
    with open(path, "w") as f:
        f.write("\n".join(line.rstrip(" ") for line in lines) + "\n")


def game_page(folder):
    told, sections, difficulties = read(folder, "glasstide")
    order = [s for s in in_order(sections) if s in told]
    write("docs/images/game-curve.svg", curve(told, order, difficulties))
    yield """# How hard the game is

Written by `make survive`, with [survive.md](survive.md): stages and bosses' phases of *Glass Tide* in the order in
which a game meets them, a curve a difficulty.

![Hits a minute, a curve for each difficulty, over the sections of the game](images/game-curve.svg)

**The measure is hits a minute:** sixteen simple bots (four stand, six wander, six dodge with a reaction of a fifth of a
second) fly each section until they are hit, and the hits are divided by the time that all of them flew. A bot that
comes through flew, and was not hit. Of what `survive` measures it is the one that a player feels. The narrowest gap
says how exact a way must be, but nothing of how often, and is not known beyond 36 px. Bullets a second say nothing of
where they fly: a phase of nine aimed ones a second hits sooner than a slow curtain of fifty. The seconds that bots last
are the same as hits a minute in a long section, but end where a short one ends. What the bots cannot say: they neither
learn a pattern nor fear it, so what is hard to read is easier for them than for you.

Of stages the first two minutes were looked at. A section counts from where the ship can be steered.
"""
    yield "| section |%s" % "".join(" %s |" % d for d in difficulties)
    yield "|---|%s" % ("---:|" * len(difficulties))
    for s in order:
        yield "| %s |%s" % (s, "".join(" %.1f |" % rate(told[s][d]) if d in told[s] else " |" for d in difficulties))
    yield "\n**Where it does not rise:**\n"
    yield from list(falls(told, order, difficulties)) or ["Nowhere."]


if __name__ == "__main__":
    write("docs/survive.md", survive_page(sys.argv[1]))
    write("docs/game.md", game_page(sys.argv[1]))
