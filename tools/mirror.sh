#!/bin/sh
# mirror.sh - prints the URI of the Debian mirror that this machine uses. DEBIAN=URI names another.
#
# What apt-get update would fetch shows it, on a machine without package lists too.
set -eu
uri=${DEBIAN:-$(apt-get --print-uris update |
    sed -n "s,^'\([^ ]*\)/dists/[^/' ]*/InRelease' .*,\1,p" | grep -v security | head -n 1)}
[ -n "$uri" ] || { echo "tools/mirror.sh: this machine names no Debian mirror; set DEBIAN=URI" >&2; exit 3; }
echo "$uri"
