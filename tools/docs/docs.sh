#!/bin/sh
# docs.sh - runs docs.py with a Python that has the libraries of Debian's packages python3-markdown-it and
# python3-pygments. Where another Python comes first, those packages are the system's.
set -eu
for python in python3 /usr/bin/python3; do
    if "$python" -c 'import markdown_it, pygments' 2>/dev/null; then
        exec "$python" "$(dirname "$0")/docs.py" "$@"
    fi
done
echo "tools/docs/docs.sh: python3-markdown-it and python3-pygments are missing; tools/deps.sh docs installs them" >&2
exit 3
