#!/usr/bin/env bash
# Records the runs of all examples in Java and NQC again, in src/commonTest/resources/runs, nxj-runs and nqc-runs, for the
# tests of all targets.
set -euo pipefail
here=$(cd "$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")" && pwd)
root=$here/../..
resources=$here/src/commonTest/resources
longest_log=4000 # bytes, as in JavaExampleRunTest and NqcExampleRunTest: the report's trace hash covers longer logs
fresh=$(mktemp -d) # a file in the tree would make robotran build itself again
trap 'rm -rf "$fresh"' EXIT
mkdir "$fresh/runs" "$fresh/nxj-runs" "$fresh/nqc-runs"

for example in "$root"/examples/lejos/*.java; do
  name=$fresh/runs/$(basename "$example" .java)
  "$root/robotran" run "$example" --report "$name.report.json" --rom-log "$name.rom-log.txt"
done
find "$fresh/runs" -name '*.rom-log.txt' -size "+${longest_log}c" -delete

for example in "$root"/examples/nxj/*.java; do
  "$root/robotran" run "$example" --report "$fresh/nxj-runs/$(basename "$example" .java).report.json"
done

for example in "$root"/examples/nqc/*.nqc; do
  name=$fresh/nqc-runs/$(basename "$example" .nqc)
  "$root/robotran" run "$example" --report "$name.report.json" --rom-log "$name.rom-log.txt"
done
find "$fresh/nqc-runs" -name '*.rom-log.txt' -size "+${longest_log}c" -delete

for runs in runs nxj-runs nqc-runs; do
  mkdir -p "$resources/$runs"
  rm -f "$resources/$runs"/*
  cp "$fresh/$runs"/* "$resources/$runs"
done
