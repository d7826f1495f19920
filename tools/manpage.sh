#!/bin/sh
# manpage.sh - writes curtain(1) from the tables behind `curtain help`: commands, options and what they go with, keys,
# settings, exit codes. Only the text around them is here.
#
#     tools/manpage.sh "CURTAIN" >curtain.1      CURTAIN: the program, after what runs it if it is another machine's
set -eu
curtain=$1
date=2026-11-23 # of the text below

# Text made safe for roff: no escapes, hyphens that can be copied, no line that is a request.
roff() {
    sed -e 's/\\/\\e/g' -e 's/-/\\-/g' -e 's/\^/\\(ha/g' -e 's/~/\\(ti/g' -e 's/`/\\(ga/g' -e "s/^[.']/\\\\\&&/"
}
# Standard input's lines "NAME<tab>VALUE<tab>WHAT" as entries; VALUE in italics. Lines of at most 78 letters.
entries() {
    roff | awk -F '\t' '
        function line(s) { print s ~ /^[.\x27]/ ? "\\&" s : s }
        {
            print ".TP"
            print $2 == "" ? ".B \"" $1 "\"" : ".BI \"" $1 " \" \"" $2 "\""
            what = $3 == "" ? what : $3 # the same as above
            n = split(what, word, / /)
            text = word[1]
            for (i = 2; i <= n; i++) {
                if (length(text) + 1 + length(word[i]) > 77) {
                    line(text)
                    text = word[i]
                } else
                    text = text " " word[i]
            }
            line(text)
        }'
}
# Three kinds of table of the help, as such lines. Columns are two blanks apart; an option and its value are one.
tab=$(printf '\t') # the sed of macOS knows no \t
commands() {
    sed -nE "s/^  curtain ([a-z]+) ([^ ]+( [^ ]+)*)?  +([^ ].*)\$/curtain \1$tab\2$tab\4/p"
}
options() {
    sed -nE -e "s/^  (-[^ ]+) ([^ ]+) +([^ ].*)\$/\1$tab\2$tab\3/p" -e t -e "s/^  (-[^ ]+)  +(.*)\$/\1$tab$tab\2/p"
}
columns() {
    sed -nE "s/^  ([^ ]+) +([^ ]+( [^ ]+)*)(  +(.*))?\$/\1$tab\2$tab\5/p"
}
# The commands that an option goes with.
goes_with() { # OPTION
    for command in $names; do
        $curtain help "$command" | grep -q "^  $1 " && printf '%s\n' "$command"
    done | paste -s -d , - | sed 's/,/, /g'
}
part() { # FROM [TO]: lines of `help play` after one that begins so, up to an empty one
    $curtain help play | sed -n "/^$1/,/^\$/p" | sed 1d
}

names=$($curtain help | commands | sed -E 's/^curtain ([a-z]+).*/\1/')
release=$($curtain version | sed -nE 's/^curtain ([^ ]+) .*/\1/p')

cat <<END
.\\" Made by tools/manpage.sh from what curtain help says.
.TH CURTAIN 1 $date "Curtain $release" "Games"
.SH NAME
curtain, curtain\\-null \\- play, record and verify bullet\\-hell games
.SH SYNOPSIS
END
$curtain help | commands | roff |
    awk -F '\t' '{ if (NR > 1) print ".br"; print $2 == "" ? ".B " $1 : ".BI \"" $1 " \" \"" $2 "\"" }'
cat <<'END'
.SH DESCRIPTION
.B curtain
runs bullet\-hell games: folders of Lua scripts and PNG pictures, or
.I .rom
files packed from such folders.
The same game with the same buttons gives the same run on every machine,
so a run can be recorded as a
.IR demo ,
replayed, verified, and rendered without a window.
.B play
is the default command; without arguments, curtain plays the built\-in game.
.PP
.B curtain\-null
is the same program without a window.
.SH COMMANDS
END
$curtain help | commands | entries
cat <<'END'
.SH OPTIONS
The commands that accept an option are in brackets.
END
$curtain help | options | while IFS= read -r line; do
    option=$(printf '%s\n' "$line" | cut -f 1)
    with=$(goes_with "$option")
    case $option in --help | --version) with=all ;; esac
    printf '%s [%s]\n' "$line" "$with"
done | entries
cat <<'END'
.SH KEYS
Keys of a player, such as
.BR p1.fire ,
and of the program.
Each name is followed by its default keys and buttons:
keys are named by their position on a US keyboard,
and controller buttons, such as
.BR pad.south ,
by their position on the controller.
Player 1 gets the first controller used;
press START on another one to join as player 2.
END
part 'Keys' | columns | entries
cat <<'END'
.SH SETTINGS
Lines
.IB "name " = " value"
of the file
.IR curtain.conf ;
the value of a key is a list of keys and buttons.
Each name is followed by its default and its allowed values.
END
part 'Settings' | columns | entries
cat <<'END'
.SH FILES
.TP
.I $XDG_DATA_HOME/curtain/curtain.conf
The settings.
Without
.BR XDG_DATA_HOME ,
the folder is
.IR $HOME/.local/share/curtain .
.B curtain help config
prints the path of the file and all settings.
.TP
.I $XDG_DATA_HOME/curtain/GAME.nv
A game's score tables and saves.
.TP
.I $XDG_DATA_HOME/curtain/GAME.practice
Attempts and captures in practice.
.TP
.I $XDG_DATA_HOME/curtain/replays/GAME/DATE.demo
The most recent runs of a game and those saved with a name, each with a
.I .card
that holds its entry in the list of replays.
.TP
.I $XDG_DATA_HOME/curtain/resume/GAME.demo
The current or unfinished run.
.TP
.I $XDG_DATA_HOME/curtain/roms/GAME\-HASH.rom
Older versions of a game that replays still need.
.TP
.I $XDG_DATA_HOME/curtain/reports/GAME-DATE-N.txt
.TQ
.I $XDG_DATA_HOME/curtain/reports/GAME-DATE-N.demo
The report of a script error, and a demo of the run up to it.
The last twenty are stored.
.TP
.I $XDG_PICTURES_DIR/Curtain/GAME-N.png
Screenshots, taken with F12, and as
.I .gif
clips of the last seconds, taken with F6.
Without
.BR XDG_PICTURES_DIR ,
the folder is the one that
.I user-dirs.dirs
of the desktop sets, or
.IR $HOME/Pictures .
.SH EXIT STATUS
END
$curtain help | sed -n 's/^Exit codes: //p' | tr , '\n' | sed -E "s/^ *([0-9]) ([^.]*)\.?\$/\1$tab$tab\2/" | entries
cat <<'END'
.SH EXAMPLES
Create a game in a new folder:
.PP
.nf
.RS
curtain new mine
.RE
.fi
.PP
Play a game and record it, then verify the recording:
.PP
.nf
.RS
curtain play mygame \-\-record my.demo
curtain verify mygame my.demo
.RE
.fi
.PP
Render four frames of a stage onto one sheet, without a window:
.PP
.nf
.RS
curtain render mygame \-\-stage one \-\-frames 60:240:60 \-\-sheet one.png
.RE
.fi
.PP
Write API definitions for the Lua language server into the folder of a game:
.PP
.nf
.RS
curtain help lua \-\-annotations >.curtain.lua
.RE
.fi
.PP
Make a clip of a recording, and one of ten seconds of a stage:
.PP
.nf
.RS
curtain capture mygame \-\-demo my.demo \-o my.gif
curtain capture mygame \-\-stage one \-\-frames 0:600 \-o one.gif
.RE
.fi
.PP
Draw all sprites on one picture; copy the colours of a palette file into a bank:
.PP
.nf
.RS
curtain art mygame \-\-atlas atlas.png
curtain palette warm.hex \-\-bank 3 \-o mygame/art/palette.png
.RE
.fi
.PP
Print the cost of its frames and its most expensive lines:
.PP
.nf
.RS
curtain bench mygame
.RE
.fi
.PP
Search for a run without a hit:
.PP
.nf
.RS
curtain survive mygame \-\-stage one \-\-frames 300 \-o best.demo
.RE
.fi
.SH SEE ALSO
The guide, the Lua reference and the file formats are in
.IR share/doc/curtain/docs ;
.B curtain help lua
lists the functions.
END
