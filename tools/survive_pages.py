#!/usr/bin/env python3
"""Writes docs/measured/survive.md and docs/measured/game.md with its curves, docs/images/game-*.svg, of what
tools/survive.sh left in a folder: `survive_pages.py FOLDER`."""
import glob
import json
import os
import subprocess
import sys

CURTAIN = os.environ.get("CURTAIN", "build/curtain-null")
COLOURS = ["#3a9d5d", "#2f7fc1", "#d08a1d", "#c23b4e"]  # of difficulties, the easiest first
MEASURED = subprocess.check_output("tools/docs/measured.sh", text=True).strip()
BOTS = 16  # of survive without --bots
APART = ("caravan", "rush")  # games of their own


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


def length(one):
    return (one["frames"] - one["begin"]) / 60


VERDICTS = {"lasted": "survived so far", "cannot": "proved unavoidable", "not found": "no way found"}


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
    """Why a section at one difficulty is harder than at the next one; as measure_compare of src/workbench/survive."""
    good = [one["verdict"] in ("survived", "lasted") for one in (easier, more)]
    if not all(good):
        return "no way was found, unlike at the next difficulty" if good[1] else ""
    live, live_then, frames, frames_then = lived(easier), lived(more), easier["bots"]["frames"], more["bots"]["frames"]
    a, b = easier["tenths"], more["tenths"]
    if live + 2 < live_then:
        return "%d of %d bots live, compared with %d" % (live, BOTS, live_then)
    if live <= live_then and frames + frames // 5 + 60 < frames_then:
        return "bots last %.1f s, compared with %.1f s" % (frames / 60, frames_then / 60)
    if a["rate"] > b["rate"] * 1.1 + 10 and live <= live_then:
        return "%d bullets a second, compared with %d" % (a["rate"] // 10, b["rate"] // 10)
    if 0 < a["gap"] < b["gap"] - 20 and live <= live_then:
        return "the narrowest gap is %.1f px, compared with %.1f px" % (a["gap"] / 10, b["gap"] / 10)
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
    return "%d demos verified." % text.count(": holds,")


def survive_page(folder):
    yield """# Clearable sections

`make survive` writes this page. It lists the results of `curtain survive` for every stage and boss phase in *Glass
Tide* at every difficulty, and for every page of the cookbook. Each run that the command finds is saved as a demo that
passes `curtain verify`; the demos for phases are in `tests/demos/phases`. [game.md](game.md) shows the difficulty as
curves.

""" + MEASURED + """

[The guide](../guide/28-survive.md) explains the columns and their limits. In short:

* `seconds`: the length of the run
* `bots`: how many of sixteen simple bots survive
* `last`: how many seconds the bots survive on average
* `gap px`: the width in pixels of the widest ship that still gets through; widths up to 36 are tested
* `bullets`: bullets and lasers fired per second
* `reaction`: one in ten bullets on course for the ship arrives within this number of frames after it is fired

## Glass Tide
"""
    told, sections, difficulties = read(folder, "glasstide")
    yield from table(told, sections, difficulties)
    yield "\n%s\n" % holding(folder, "glasstide")
    yield "These sections are harder at a lower difficulty than at a higher one:\n"
    worse = ["* `%s` is harder on %s than on %s: %s" % (section, a, b, why) for section, a, b, one, two in
             pairs(told, sections, difficulties) for why in [harder(one, two)] if why]
    yield from worse or ["None."]
    yield "\n## The cookbook\n"
    yield from table(*read(folder, "cookbook"))
    yield "\n" + holding(folder, "cookbook")


# ---- the curves ----

KINDS = ("stand", "wander", "dodge")


def flights(folder):
    """What bots met that fly on: {section: {difficulty: bots}}, of stages their parts. A part of less than two seconds
    is none, for a boss flies in, and so is one in which nothing flies."""
    told = {}
    for path in glob.glob(folder + "/bots-*.json"):
        for line in open(path):
            one = json.loads(line)
            if sum(one["bots"][k].get("flown", 0) for k in KINDS) >= 120 * sum(one["bots"][k]["of"] for k in KINDS):
                told.setdefault(one["section"], {})[one["difficulty"]] = one["bots"]
    return {s: by for s, by in told.items() if any(rate(bots) > 0 for bots in by.values())}


def rate(bots, kinds=KINDS):
    """Hits a minute."""
    return 3600 * sum(bots[k]["hits"] for k in kinds) / max(1, sum(bots[k]["flown"] for k in kinds))


def in_order(sections):
    """The sections as a game meets them, {section: its stage}, of the whole game that came through most; what no demo
    meets comes last."""
    best = {}
    for demo in glob.glob("tests/demos/glasstide/clear-*.demo"):
        said = subprocess.run([CURTAIN, "verify", "--json", "roms/glasstide", demo], capture_output=True, text=True)
        met, boss, stage = {}, "", ""
        for m in json.loads(said.stdout or "{}").get("moments", []):
            boss = m["name"] if m["kind"] == "boss" else boss
            stage = m["name"] if m["kind"] == "stage" else stage
            name = {"stage": m["name"], "mark": "%s:%s" % (stage, m["name"]),
                    "phase": "%s/%s" % (boss, m["name"])}.get(m["kind"])
            if name in sections:
                met.setdefault(name, stage)
        best = met if len(met) > len(best) else best
    return best | {s: group(s) for s in sections if s not in best}


def ceiling(v):
    return next(step for step in (5, 10, 15, 20, 30, 40, 60, 80, 100, 120, 150, 200, 1e9) if step >= v)


def is_part(section):
    """Of a stage, not of a boss."""
    return "/" not in section


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
        if is_part(s) and ":" not in s:
            yield '<path d="M%.1f %dV%d" stroke="#bbb" stroke-dasharray="3 3"/>' % (x(i), top, below)
        yield '<text transform="translate(%.1f %d) rotate(-60)" text-anchor="end">%s</text>' % (x(i) + 4, below + 14, s)
    for d, colour in zip(difficulties, COLOURS):
        for kind, look in ((False, ""), (True, ' stroke-dasharray="2 4"')):
            at = [(x(i), y(rate(told[s][d]))) for i, s in enumerate(sections) if is_part(s) == kind and d in told[s]]
            way = "L".join("%.1f %.1f" % p for p in at)
            yield '<path fill="none" stroke="%s" stroke-width="2"%s d="M%s"/>' % (colour, look, way)
            yield from ('<circle cx="%.1f" cy="%.1f" r="2.5" fill="%s"/>' % (*p, colour) for p in at)
    for i, (d, colour) in enumerate(zip(difficulties, COLOURS)):
        yield '<text x="%d" y="%d" fill="%s" font-weight="bold">%s</text>' % (left + 8 + 62 * i, top + 10, colour, d)
    yield "</svg>"


def group(section):
    """Those of a stage, or of a boss: within it each is to be harder than the one before."""
    return section.split("/")[0] if "/" in section else section.split(":")[0]


def mean(told, sections, difficulty):
    of = [rate(told[s][difficulty]) for s in sections if difficulty in told[s]]
    return sum(of) / len(of) if of else 0


def lower(told, difficulty, sections, groups, group_of, compared):
    means = [(g, mean(told, [s for s in sections if group_of(s) == g], difficulty)) for g in groups]
    for (g, v), (h, w) in zip(means, means[1:]):
        if w <= v and compared(g, h):
            yield "%s: `%s` has %.1f on average, then `%s` %.1f." % (difficulty, g, v, h, w)


def falls(told, order, difficulties):
    """Where it does not rise: from a difficulty to the next; within a stage from part to part, and from phase to phase
    of a boss; in a stage from boss to boss, and from stage to stage, by their means. order: {section: its stage}."""
    for s in order:
        for a, b in zip(difficulties, difficulties[1:]):
            if rate(told[s][b]) <= rate(told[s][a]):
                yield "`%s`: %s has %.1f, but %s has %.1f." % (s, a, rate(told[s][a]), b, rate(told[s][b]))
    for parts in (True, False):
        of = [s for s in order if is_part(s) == parts and group(s) not in APART]
        groups, stages = list(dict.fromkeys(group(s) for s in of)), list(dict.fromkeys(order[s] for s in of))
        stage_of = {group(s): order[s] for s in of}
        for d in difficulties:
            for s, t in zip(of, of[1:]):
                if group(s) == group(t) and rate(told[t][d]) <= rate(told[s][d]):
                    yield "on %s, %.1f in `%s`, but only %.1f in the next section, `%s`" % (
                        d, rate(told[s][d]), s, rate(told[t][d]), t)
            yield from lower(told, d, of, groups, group, lambda g, h: stage_of[g] == stage_of[h])
            yield from lower(told, d, of, stages, order.get, lambda a, b: True)


def write(path, lines):
    with open(path, "w") as f:
        f.write("\n".join(line.rstrip(" ") for line in lines) + "\n")


def game_page(folder):
    told, difficulties = flights(folder), read(folder, "glasstide")[2]
    order = {s: stage for s, stage in in_order(sorted(told)).items() if len(told[s]) == len(difficulties)}
    whole = [s for s in order if group(s) not in APART]
    write("docs/images/game-curve.svg", curve(told, whole, difficulties))
    yield """# Difficulty of Glass Tide

`make survive` writes this page together with [survive.md](survive.md). The picture shows the sections of *Glass Tide*
in the order of play, with one curve per difficulty. Dots on solid lines are boss phases; dots on dotted lines are the
stage sections between them.

""" + MEASURED + """

![Hits per minute over the sections of the game, one curve per difficulty](../images/game-curve.svg)

**The numbers are hits per minute**, averaged over the 32 simple bots of `curtain survive --bots 32`. The bots fly each
section to its end. Eight bots stand still, twelve wander, and twelve dodge with a reaction time of a fifth of a second.
A bot flies on after a hit, and hits in the next 90 frames are ignored. Numbers in parentheses are for the dodging bots
alone. `one:wreck` is a section of stage one; `crab/pincers` is a phase of the boss `crab`.

The numbers show how much of the field is dangerous, and how often. The numbers are stable because each averages
hundreds of hits. The other measures in [survive.md](survive.md) show less:

* The sixteen bots in survive.md stop at their first hit, so they test only the first seconds of a section.
* The narrowest gap shows how exact a path must be, but not how often it must be that exact.
* The number of bullets per second does not show where the bullets fly.

Bots don't have to read a pattern, so a pattern that is hard to read is easier for them than for you. Bots don't learn a
pattern either.
"""
    yield "| section |%s" % "".join(" %s |" % d for d in difficulties)
    yield "|---|%s" % ("---:|" * len(difficulties))
    for s in order:
        yield "| %s |%s" % (s, "".join(" %.1f (%.1f) |" % (rate(told[s][d]), rate(told[s][d], ["dodge"]))
                                       for d in difficulties))
    yield """
Hits per minute follow three rules, with the exceptions below:

* In each section, hits per minute rise from one difficulty to the next.
* Within a stage, hits per minute rise from section to section; within a boss fight, from phase to phase.
* On average, hits per minute rise from a stage's first boss to its last boss, and from stage to stage.

A stage can start easier than the previous stage ended. The caravan and the boss rush are separate from the stages, so
only the first rule applies to them.

**Exceptions, in hits per minute:**
"""
    yield from ["* " + line for line in falls(told, order, difficulties)] or ["None."]


if __name__ == "__main__":
    write("docs/measured/survive.md", survive_page(sys.argv[1]))
    write("docs/measured/game.md", game_page(sys.argv[1]))
