#!/usr/bin/env bash
# Records the runs of all Java examples again, in src/commonTest/resources/runs and nxj-runs, for the tests of all targets.
set -euo pipefail
here=$(cd "$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")" && pwd)
root=$here/../..
recorded=$here/src/commonTest/resources/runs
longest_log=4000 # bytes, as in JavaExampleRunTest: the report's trace hash covers longer logs
fresh=$(mktemp -d) # a file in the tree would make robotran build itself again
trap 'rm -rf "$fresh"' EXIT

for example in "$root"/examples/lejos/*.java; do
  name=$(basename "$example" .java)
  "$root/robotran" run "$example" --report "$fresh/$name.report.json" --rom-log "$fresh/$name.rom-log.txt"
done
find "$fresh" -name '*.rom-log.txt' -size "+${longest_log}c" -delete
mkdir -p "$recorded"
rm -f "$recorded"/*
cp "$fresh"/* "$recorded"

recorded=$here/src/commonTest/resources/nxj-runs
mkdir -p "$recorded"
rm -f "$recorded"/*
for example in "$root"/examples/nxj/*.java; do
  "$root/robotran" run "$example" --report "$recorded/$(basename "$example" .java).report.json"
done
