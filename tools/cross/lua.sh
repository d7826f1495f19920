#!/usr/bin/env bash
# lua.sh - Lua's C sources as Debian has them, in build/cross/lua-SUITE/src.
#
#     tools/cross/lua.sh SUITE          bookworm, trixie ...
#
# Fetched once, by a private apt configuration: of the machine's own nothing is changed, its mirror is asked, and apt
# checks what comes against Debian's keys. DEBIAN=URI names another mirror.
set -eu
cd "$(dirname "$0")/../.."
suite=$1
to=build/cross/lua-$suite
keys=/usr/share/keyrings/debian-archive-keyring.gpg
[ ! -f "$to/src/lua.h" ] || exit 0

# What apt-get update would fetch shows the mirror, on a machine without package lists too.
mirror() {
    apt-get --print-uris update | sed -n "s,^'\([^' ]*\)/dists/[^/' ]*/InRelease' .*,\1,p" | grep -v security |
        head -n 1
}
uri=${DEBIAN:-$(mirror)}
[ -n "$uri" ] || { echo "tools/cross/lua.sh: this machine names no Debian mirror; DEBIAN=URI does" >&2; exit 3; }

scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
chmod 755 "$scratch"
mkdir -p "$scratch/lists/partial" "$scratch/cache/archives/partial" build/cross
echo "deb-src [signed-by=$keys] $uri $suite main" >"$scratch/sources.list"
private() {
    apt-get -qq -o Dir::Etc::SourceList="$scratch/sources.list" -o Dir::Etc::SourceParts=/dev/null \
        -o Dir::State::Lists="$scratch/lists" -o Dir::Cache="$scratch/cache" -o APT::Sandbox::User=root "$@"
}
(
    private update
    cd "$scratch"
    private source lua5.4 >said 2>&1 || { cat said >&2; exit 3; }
)
rm -rf "$to"
mv "$scratch"/lua5.4-*/ "$to"
