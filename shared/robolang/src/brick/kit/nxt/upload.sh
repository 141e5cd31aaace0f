#!/bin/sh
# Compiles @CLASS@ for the brick and sends it there with leJOS NXJ's own tools.
set -e
cd "$(dirname "$0")"
PATH="${NXJ_HOME:+$NXJ_HOME/bin:}$PATH"
if ! command -v nxjc > /dev/null; then
    echo "leJOS NXJ is not there: set NXJ_HOME to its folder. README.txt says more." >&2
    exit 1
fi
nxjc -encoding UTF-8 -d . @SOURCES@
nxjlink -o @CLASS@.nxj @MAIN_CLASS@
nxjupload -r @CLASS@.nxj
