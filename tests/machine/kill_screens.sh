#!/usr/bin/env bash
# kill_screens.sh - settings, replays, what was left and the records of practice are old or new, whenever the program is
# killed with -9 while one of the program's screens is worked: after every poll of a way through each. (That a file is
# whole when it is killed while writing is kill_store.sh's.)
. "$(dirname "$0")/../kept.sh"
kept_game <<'LUA'
stage.def("one", function() wait(30) stage.mark "late" wait(forever) end)
LUA
mkdir -p data/curtain
printf '# mine\nvolume = 70 # not loud\n' >data/curtain/curtain.conf
{ begin; keys 200 $Z; keys 60 $C; keys 120; } | ./player play g >/dev/null 2>err # a replay
{ begin; keys 200 $Z; } | ./player play g --no-resume >/dev/null 2>err           # and what is left
same 'a run is kept, one was left' '2 1' "$("$curtain" list g --replays | wc -l) $(ls data/curtain/resume | wc -l)"
cp -R data "$scratch/was"

cat >ways.py <<'END'
"""Goes the ways, killed after each poll; prints a line for what is wrong, and at last how many kills there were."""
import os, shutil, signal, subprocess, sys
curtain, every = sys.argv[1], int(sys.argv[2])
UP, DOWN, RIGHT, LEFT, ENTER, ESC, DEL, F1, F2, Y = 82, 81, 79, 80, 40, 41, 76, 58, 59, 28

def press(*keys):
    return [line for key in keys for line in (b"%d\n" % key, b"\n")]

menu = press(ESC) + [b"\n"]
ways = {
    "menu": menu + press(DOWN, DOWN, UP, ESC),
    "settings": menu + press(DOWN, DOWN, ENTER, DOWN, DOWN, RIGHT, DOWN, RIGHT, ESC, ESC),
    "keys": press(F1) + [b"\n"] + press(DOWN, DOWN, DOWN, DOWN, ENTER, Y) + [b"\n"] * 3 + press(DEL, DOWN, DEL, ESC),
    "controllers": menu + press(DOWN, DOWN, DOWN, DOWN, ENTER, RIGHT, ESC, ESC),
    "replays, one deleted": menu + press(DOWN, ENTER, DEL, DOWN, ENTER, ESC, ESC),
    "replays, one watched": menu + press(DOWN, ENTER, ENTER, ENTER) + [b"\n"] * 10,
    "practice": press(F2) + [b"\n"] + press(DOWN, ENTER) + [b"\n"] * 40 + press(F2, ESC),
}
asked = {
    "what was left, gone on with": press(ENTER) + [b"\n"] * 20,
    "what was left, dropped": press(DOWN, ENTER) + [b"\n"] * 9,
}

changes = {"settings": "settings", "keys": "settings", "replays, one deleted": "replays", "practice": "practice"}

def run(lines, kill, *options):
    """Plays so many lines from the data as they were. kill: then with -9, else to the end."""
    shutil.rmtree("data")
    shutil.copytree("was", "data")
    game = subprocess.Popen(["./player", "play", "g", *options], stdin=subprocess.PIPE, stdout=subprocess.PIPE,
                            stderr=subprocess.DEVNULL, bufsize=0)
    game.stdin.write(b"".join(lines))
    shown, chunk = 0, b"-"
    while kill and chunk and shown < len(lines):
        chunk = os.read(game.stdout.fileno(), 65536)
        shown += chunk.count(b"\n")
    if kill:
        game.send_signal(signal.SIGKILL)
    game.stdin.close()
    game.stdout.read()
    return game.wait()

def state():
    def text(name):
        path = "data/curtain/" + name
        return open(path, "rb").read() if os.path.exists(path) else None
    said = subprocess.run([curtain, "list", "g", "--replays"], capture_output=True)
    return {"settings": text("curtain.conf"), "practice": text("probe.practice"),
            "replays": (said.returncode, said.stdout.count(b"\n"), said.stderr)}

def holds():
    demos = [os.path.join(d, f) for d, _, files in os.walk("data/curtain") for f in files if f.endswith(".demo")]
    said = subprocess.run([curtain, "verify", "g", *demos], capture_output=True)
    return [line for line in said.stdout.decode().splitlines() if ": holds, " not in line and "truncated" not in line]

kills = 0
for name, way, options in [(n, w, ["--no-resume"]) for n, w in ways.items()] + [(n, w, []) for n, w in asked.items()]:
    run([], False, *options)
    old = state()
    run(way, False, *options)
    new = state()
    if name in changes and old[changes[name]] == new[changes[name]]:
        print("%s: changes nothing" % name)
    for n in range(1, len(way) + 1, every):
        if run(way[:n], True, *options) != -signal.SIGKILL:
            print("%s, poll %d: it had ended before" % (name, n))
        kills += 1
        now = state()
        for what in now:
            if now[what] not in (old[what], new[what]):
                print("%s, poll %d: %s: %r is neither %r nor %r" % (name, n, what, now[what], old[what], new[what]))
        for line in holds():
            print("%s, poll %d: %s" % (name, n, line))
print(kills, "kills")
END
every=2 # polls; each of them with CURTAIN_LONG=1
[ "${CURTAIN_LONG:-0}" = 0 ] || every=1
python3 ways.py "$curtain" "$every" >told
same 'killed in each screen, poll by poll: all is old or new' '' "$(grep -v ' kills$' told)"
finish
