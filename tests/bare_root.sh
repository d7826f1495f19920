#!/usr/bin/env bash
# bare_root.sh - the README's commands on a fresh machine: clones this repository's last commit into a bare Debian root
# (tools/chroot.sh, bookworm), installs git and make there as the README says, and runs .ci/run in it.
#
#     tests/bare_root.sh [COMMAND...]     another command in its place, in the clone: tests/bare_root.sh make play
#
# Needs root. Every run starts with a bare root. build/bare stays, to look at. The last line and the exit code are the
# command's.
set -eu
cd "$(dirname "$0")/.."
root=build/bare
[ $# -gt 0 ] || set -- .ci/run

tools/chroot.sh make bookworm $root git ca-certificates make
git clone -q --no-hardlinks . $root/curtain
echo "commit $(git -C $root/curtain log -1 --format='%h %s')"
exec tools/chroot.sh run $root sh -ec 'cd /curtain; exec "$@"' sh "$@"
