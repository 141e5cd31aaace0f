#!/bin/sh
# Compiles @CLASS@ for the brick and sends it there with leJOS's own tools.
set -e
cd "$(dirname "$0")"
PATH="${LEJOS_HOME:+$LEJOS_HOME/bin:}$PATH"
if command -v lejosc > /dev/null; then
    compiler=lejosc
elif command -v lejosjc > /dev/null; then
    compiler=lejosjc
else
    echo "leJOS is not there: set LEJOS_HOME to its folder. README.txt says more." >&2
    exit 1
fi
$compiler @OPTIONS@ @QUOTED_SOURCES@
lejos @QUOTED_MAIN_CLASS@
