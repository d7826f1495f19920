#!/bin/sh
# pictures.sh - makes the pictures of the pages, docs/images, anew: pictures.sh [CURTAIN]
set -eu
cd "$(dirname "$0")/.."
curtain=${1:-build/curtain-null}
at=$(mktemp -d)
trap 'rm -rf "$at"' EXIT
mkdir -p docs/images
"$curtain" render roms/glasstide --demo roms/glasstide/demos/run.demo --frames 2600,8000,12800 -o "$at/play"
python3 tools/pictures.py 2 docs/images/glasstide.png "$at"/play/*.png
"$curtain" render roms/testcard --frames 120 -o "$at/card"
python3 tools/pictures.py 2 docs/images/testcard.png "$at"/card/*.png
