# check.sh - sourced by the test scripts: TAP for shell. The current folder is the repository's.
#
#     check "name" command...     passes when the command succeeds; what it says is shown when it does not
#     refuse "name" "words" command...    passes when the command fails and says the words: a planted fault is found
#     done_testing                the plan; the last line of a script
set -u
cd "$(dirname "${BASH_SOURCE[0]}")/.." || exit 2
OUT=${OUT:-build/release}
tap_n=0 tap_failed=0
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT

result() { # good? name, output in $scratch/said
    tap_n=$((tap_n + 1))
    if [ "$1" = 0 ]; then
        echo "ok $tap_n - $2"
    else
        sed 's/^/# /' "$scratch/said"
        echo "not ok $tap_n - $2"
        tap_failed=1
    fi
}
check() {
    local name=$1
    shift
    "$@" >"$scratch/said" 2>&1
    result $? "$name"
}
refuse() {
    local name=$1 words=$2
    shift 2
    if "$@" >"$scratch/said" 2>&1; then result 1 "$name"; else
        grep -qF -- "$words" "$scratch/said"
        result $? "$name"
    fi
}
done_testing() {
    echo "1..$tap_n"
    exit $tap_failed
}
# The files of the repository as they are now: new ones too, removed ones not.
tree() {
    git ls-files -co --exclude-standard -- "$@" | while read -r f; do
        [ ! -f "$f" ] || echo "$f"
    done
}
