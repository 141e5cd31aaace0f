#!/usr/bin/env bash
# Records the runs of the projects in src/commonTest/resources/runs anew: the tests of all targets are held against them.
set -euo pipefail
here=$(cd "$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")" && pwd)
recorded=$here/src/commonTest/resources/runs
fresh=$(mktemp -d) # a file in the tree would make robotran build itself again
trap 'rm -rf "$fresh"' EXIT

for project in "$recorded"/*.robotran; do
  "$here/../../robotran" run "$project" --report "$fresh/$(basename "$project" .robotran).report.json"
done
cp "$fresh"/* "$recorded"
