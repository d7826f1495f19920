#!/usr/bin/env bash
# bare_root.sh - the README's commands on a fresh machine: clones this repository's last commit into a bare Debian root
# (debootstrap, bookworm), installs git and make there as the README says, and runs .ci/run in it.
#
#     tests/bare_root.sh [COMMAND...]     another command in its place, in the clone: tests/bare_root.sh make play
#
# Needs root. The root as debootstrap made it is saved as build/bare/bookworm.tar, and what apt-get fetched in
# build/bare/archives, so a second run starts sooner; every run starts with that bare root. Mirrors, proxies and other
# settings of apt-get are those of this machine. Mounts and processes are in namespaces of their own and go with them.
# build/bare/root stays, to look at. The last line and the exit code are the command's.
set -eu
cd "$(dirname "$0")/.."
suite=bookworm
dir=$PWD/build/bare
root=$dir/root

[ "$(id -u)" = 0 ] || { echo "tests/bare_root.sh: run it as root: it makes a Debian root and mounts" >&2; exit 2; }
[ $# -gt 0 ] || set -- .ci/run

# The machine's own mirrors of the suite, its updates and its security, or Debian's.
sources() {
    local found
    found=$(apt-cache policy | sort -u |
        sed -nE "s#^ *[0-9-]+ ([a-z+]*://[^ ]*) ($suite(-updates|-security)?)/([^ ]*) .*#deb \1 \2 \4#p")
    echo "${found:-deb http://deb.debian.org/debian $suite main}"
}
settings() { apt-config dump | grep -E '^Acquire::(http|https|Check|Retries|ForceIPv)[^ ]* "[^"]'; }
proxies() { env | grep -iE '^(http|https|ftp|no)_proxy=' || true; }

mkdir -p "$dir/archives/partial"
if [ ! -f "$dir/$suite.tar" ]; then
    echo "debootstrap $suite"
    rm -rf "$dir/new"
    mirror=$(sources | sed -n "s/^deb \([^ ]*\) $suite main\$/\1/p" | head -n 1)
    log=$dir/debootstrap.log
    debootstrap --variant=minbase "$suite" "$dir/new" "${mirror:-http://deb.debian.org/debian}" >"$log" ||
        { tail -n 20 "$log"; exit 1; }
    tar -C "$dir/new" --one-file-system -cf "$dir/$suite.tar.new" .
    mv "$dir/$suite.tar.new" "$dir/$suite.tar"
    rm -rf "$dir/new"
fi

rm -rf "$root"
mkdir "$root"
tar -C "$root" -xf "$dir/$suite.tar"
sources >"$root/etc/apt/sources.list"
settings >"$root/etc/apt/apt.conf.d/99host" || true
cp /etc/resolv.conf /etc/hosts "$root/etc/"
git clone -q --no-hardlinks . "$root/curtain"
echo "commit $(git -C "$root/curtain" log -1 --format='%h %s')"

# In the namespaces: $1 is the root, $2 the saved archives, the rest the command.
# shellcheck disable=SC2016
inside='
root=$1 archives=$2
shift 2
mount -t proc proc "$root/proc"
mount --rbind /dev "$root/dev"
mount --bind "$archives" "$root/var/cache/apt/archives"
cd /
exec chroot "$root" sh -ec "
    apt-get update -qq
    DEBIAN_FRONTEND=noninteractive apt-get install -y -qq --no-install-recommends git ca-certificates make >/dev/null
    cd /curtain
    exec \"\$@\"" sh "$@"
'
mapfile -t proxy < <(proxies)
exec env -i HOME=/root TERM=dumb PATH=/usr/local/sbin:/usr/local/bin:/usr/sbin:/usr/bin:/sbin:/bin "${proxy[@]}" \
    unshare --mount --pid --fork --kill-child sh -ec "$inside" sh "$root" "$dir/archives" "$@"
