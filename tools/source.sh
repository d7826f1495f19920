#!/usr/bin/env bash
# source.sh - fetches the source of a Debian package into a folder, once.
#
#     tools/source.sh PACKAGE SUITE DIR          libsdl2 bookworm build/windows/sdl2
#
# A private apt configuration is used: the machine's own is not changed, its mirror is asked, and apt checks the files
# against Debian's keys. DEBIAN=URI names another mirror. DIR appears when the source is complete.
set -eu
package=$1 suite=$2 to=$3
keys=/usr/share/keyrings/debian-archive-keyring.gpg
[ ! -d "$to" ] || exit 0

uri=$("$(dirname "$0")/mirror.sh")
mkdir -p "$(dirname "$to")"
scratch=$(mktemp -d "$(dirname "$to")/source.XXXXXX")
scratch=$(cd "$scratch" && pwd)
trap 'rm -rf "$scratch"' EXIT
chmod 755 "$scratch"
mkdir -p "$scratch/lists/partial" "$scratch/cache/archives/partial"
echo "deb-src [signed-by=$keys] $uri $suite main" >"$scratch/sources.list"
private() {
    apt-get -qq -o Dir::Etc::SourceList="$scratch/sources.list" -o Dir::Etc::SourceParts=/dev/null \
        -o Dir::State::Lists="$scratch/lists" -o Dir::Cache="$scratch/cache" -o APT::Sandbox::User=root "$@"
}
(
    private update
    cd "$scratch"
    private source "$package" >log 2>&1 || { cat log >&2; exit 3; }
)
for folder in "$scratch"/*-*/; do
    [ ! -d "$folder" ] || mv "$folder" "$to"
done
[ -d "$to" ] || { echo "tools/source.sh: no source folder in the package $package" >&2; exit 3; }
