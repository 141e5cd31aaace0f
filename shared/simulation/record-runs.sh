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

# The same on an NXT, and some Java programs, for NxtRecordedRunsTest.
recorded=$here/src/commonTest/resources/nxt-runs
java=$here/src/commonTest/resources/nxj
penbot=(--robot-file "$root/worlds/nxt-penbot.robot.json")
rm "$fresh"/*
for example in "$root"/examples/*.robo; do
  name=$(basename "$example" .robo)
  # Not all examples are for an NXT.
  "$root/robotran" run "$example" "${penbot[@]}" --report "$fresh/$name.report.json" || true
done
"$root/robotran" run "$java/PilotSquare.java" --report "$fresh/PilotSquare.report.json"
"$root/robotran" run "$java/Rotations.java" --robot-file "$root/worlds/line-follower.robot.json" --realism 1 \
  --report "$fresh/Rotations.report.json"
"$root/robotran" run "$java/FollowLine.java" --world "$root/worlds/line-loop.world.json" "${penbot[@]}" --realism 1 \
  --for 60 --report "$fresh/FollowLine.report.json"
"$root/robotran" run "$java/Wanderer.java" --world "$root/worlds/obstacle-course.world.json" "${penbot[@]}" \
  --realism 1 --for 60 --report "$fresh/Wanderer.report.json"
rm -f "$recorded"/*
cp "$fresh"/* "$recorded"
