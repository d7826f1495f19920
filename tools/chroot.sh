#!/usr/bin/env bash
# chroot.sh - makes bare Debian roots, and runs commands in them.
#
#     tools/chroot.sh releases                              Debian's releases on this machine's mirror, oldest first
#     tools/chroot.sh make RELEASE ROOT [PACKAGE...]        replaces the folder ROOT: a minimal Debian, these packages
#     tools/chroot.sh install ROOT PACKAGE...
#     tools/chroot.sh run ROOT [--bind DIR]... COMMAND...   in the first DIR, or in /; DIR has the same path as here
#
# Needs root, except for releases. A root as debootstrap made it is saved as build/chroot/RELEASE.tar, and what apt-get
# fetched in build/chroot/archives, so the next one takes seconds. ROOT appears when it is complete. Mirrors, proxies
# and other settings of apt-get are those of this machine. Mounts and processes end with the command, because they are
# in namespaces of their own.
set -eu
repo=$(cd "$(dirname "$0")/.." && pwd)
saved=$repo/build/chroot
names=/usr/share/distro-info/debian.csv # package distro-info-data

fetch() { /usr/lib/apt/apt-helper -qq download-file "$@"; } # URI FILE
releases() {
    local name uri
    uri=$("$repo/tools/mirror.sh")
    scratch=$(mktemp -d)
    trap 'rm -rf "$scratch"' EXIT
    [ -r $names ] || { echo "tools/chroot.sh: there is no $names; install distro-info-data" >&2; exit 3; }
    # Released, or in development: those whose work has begun.
    awk -F, -v today="$(date +%F)" 'NR > 1 && $4 <= today && $3 != "experimental" { print $3 }' $names |
        while read -r name; do
            ! fetch "$uri/dists/$name/InRelease" "$scratch/$name" >"$scratch/log" 2>&1 </dev/null || echo "$name"
        done
}

need_root() {
    [ "$(id -u)" = 0 ] || { echo "tools/chroot.sh: run it as root: it makes a Debian root and mounts" >&2; exit 2; }
}

# The machine's own mirrors of the release, its updates and its security; or the release alone.
sources() { # RELEASE
    local found
    found=$(apt-cache policy | sort -u |
        sed -nE "s#^ *[0-9-]+ ([a-z+]*://[^ ]*) ($1(-updates|-security)?)/([^ ]*) .*#deb \1 \2 \4#p")
    echo "${found:-deb $("$repo/tools/mirror.sh") $1 main}"
}
settings() { apt-config dump | grep -E '^Acquire::(http|https|Check|Retries|ForceIPv)[^ ]* "[^"]'; }
proxies() { env | grep -iE '^(http|https|ftp|no)_proxy=' || true; }

# debootstrap knows releases by scripts; a newer one than itself is made like sid.
bootstrap() { # RELEASE
    local script=sid log=$saved/debootstrap.log
    [ ! -e "/usr/share/debootstrap/scripts/$1" ] || script=$1
    echo "debootstrap $1" >&2
    rm -rf "$saved/new"
    debootstrap --variant=minbase "$1" "$saved/new" "$("$repo/tools/mirror.sh")" "$script" >"$log" 2>&1 ||
        { tail -n 20 "$log" >&2; exit 1; }
    tar -C "$saved/new" --one-file-system -cf "$saved/$1.tar.new" .
    mv "$saved/$1.tar.new" "$saved/$1.tar"
    rm -rf "$saved/new"
}

make_root() { # RELEASE ROOT [PACKAGE...]
    local release=$1 root=$2
    shift 2
    mkdir -p "$saved"
    [ -f "$saved/$release.tar" ] || bootstrap "$release"
    rm -rf "$root" "$root.new"
    mkdir -p "$root.new"
    tar -C "$root.new" -xf "$saved/$release.tar"
    sources "$release" >"$root.new/etc/apt/sources.list"
    settings >"$root.new/etc/apt/apt.conf.d/99host" || true
    cp /etc/resolv.conf /etc/hosts "$root.new/etc/"
    [ $# = 0 ] || install_packages "$root.new" "$@"
    mv "$root.new" "$root"
}

install_packages() { # ROOT PACKAGE...
    local root=$1
    shift
    # shellcheck disable=SC2016
    run "$root" sh -ec '
        apt-get update -qq
        DEBIAN_FRONTEND=noninteractive apt-get install -y -qq --no-install-recommends "$@" >/root/apt.log 2>&1 ||
            { tail -n 20 /root/apt.log >&2; exit 1; }' sh "$@"
}

# In the namespaces: $1 is the root, $2 the saved archives, then directories, --, the command.
# shellcheck disable=SC2016
inside='
root=$1 archives=$2 dir=/
shift 2
mount -t proc proc "$root/proc"
mount --rbind /dev "$root/dev"
mount --bind "$archives" "$root/var/cache/apt/archives"
[ "$1" = -- ] || dir=$1
while [ "$1" != -- ]; do
    mkdir -p "$root$1"
    mount --bind "$1" "$root$1"
    shift
done
shift
exec chroot "$root" sh -ec "cd \"\$1\"; shift; exec \"\$@\"" sh "$dir" "$@"
'
run() { # ROOT [--bind DIR]... COMMAND...
    local root binds=() proxy
    root=$(cd "$1" && pwd)
    shift
    while [ "${1:-}" = --bind ]; do
        binds+=("$(cd "$2" && pwd)")
        shift 2
    done
    mkdir -p "$saved/archives/partial"
    mapfile -t proxy < <(proxies)
    env -i HOME=/root TERM=dumb PATH=/usr/local/sbin:/usr/local/bin:/usr/sbin:/usr/bin:/sbin:/bin "${proxy[@]}" \
        unshare --mount --pid --fork --kill-child sh -ec "$inside" sh "$root" "$saved/archives" "${binds[@]}" -- "$@"
}

what=${1:-}
[ $# = 0 ] || shift
case $what:$# in
releases:0) releases ;;
make:0 | make:1 | install:[01] | run:[01]) what= ;;
make:*) need_root && make_root "$@" ;;
install:*) need_root && install_packages "$@" ;;
run:*) need_root && run "$@" ;;
*) what= ;;
esac
[ -n "$what" ] || { sed -n 's/^#     //p' "$0" >&2; exit 2; }
