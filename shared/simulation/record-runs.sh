#!/usr/bin/env bash
# Records the runs of all examples anew, in src/commonTest/resources/runs: the tests of all targets are held against them.
set -euo pipefail
here=$(cd "$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")" && pwd)
root=$here/../..
recorded=$here/src/commonTest/resources/runs
longest_log=4000 # bytes, as in ExampleRunTest: the report's trace hash tells as much as a longer log
fresh=$(mktemp -d) # a file in the tree would make robotran build itself again
trap 'rm -rf "$fresh"' EXIT

for example in "$root"/examples/*.robo; do
  name=$(basename "$example" .robo)
  "$root/robotran" run "$example" --report "$fresh/$name.report.json" --rom-log "$fresh/$name.rom-log.txt"
done
find "$fresh" -name '*.rom-log.txt' -size "+${longest_log}c" -delete
rm -f "$recorded"/*
cp "$fresh"/* "$recorded"
