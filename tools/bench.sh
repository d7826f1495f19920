#!/bin/sh
# Prints the machine and how fast the bench runs on it. Figures depend on the machine and on what else it does.
set -eu
cd "$(dirname "$0")/.."
echo "machine: $(sed -n 's/^model name[^:]*: //p' /proc/cpuinfo 2>/dev/null | head -n 1), load $(cut -d' ' -f1 /proc/loadavg)"
build/curtain-null --version | sed -n '2,3p'
taskset -c 0 "${OUT:-build/release}/bench" roms/bench "$@"
