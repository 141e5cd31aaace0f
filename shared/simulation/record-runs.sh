#!/usr/bin/env bash
# Records the runs of all examples anew, in src/commonTest/resources/runs and nxt-runs: the tests of all targets are held
# against them.
set -euo pipefail
here=$(cd "$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")" && pwd)
root=$here/../..
resources=$here/src/commonTest/resources
longest_log=4000 # bytes, as in ExampleRunTest: the report's trace hash tells as much as a longer log
fresh=$(mktemp -d) # a file in the tree would make robotran build itself again
trap 'rm -rf "$fresh"' EXIT
rcx=$fresh/runs nxt=$fresh/nxt-runs
mkdir "$rcx" "$nxt"

for example in "$root"/examples/*.robo; do
  name=$(basename "$example" .robo)
  "$root/robotran" run "$example" --report "$rcx/$name.report.json" --rom-log "$rcx/$name.rom-log.txt"
done
find "$rcx" -name '*.rom-log.txt' -size "+${longest_log}c" -delete

# The same on an NXT, and some Java programs, for NxtRecordedRunsTest.
java=$resources/nxj
penbot=(--robot-file "$root/worlds/nxt-penbot.robot.json")
for example in "$root"/examples/*.robo; do
  name=$(basename "$example" .robo)
  # Not all examples are for an NXT.
  "$root/robotran" run "$example" "${penbot[@]}" --report "$nxt/$name.report.json" || true
done
"$root/robotran" run "$java/PilotSquare.java" --report "$nxt/PilotSquare.report.json"
"$root/robotran" run "$java/Rotations.java" --robot-file "$root/worlds/line-follower.robot.json" --realism 1 \
  --report "$nxt/Rotations.report.json"
"$root/robotran" run "$java/FollowLine.java" --world "$root/worlds/line-loop.world.json" "${penbot[@]}" --realism 1 \
  --for 60 --report "$nxt/FollowLine.report.json"
"$root/robotran" run "$java/Wanderer.java" --world "$root/worlds/obstacle-course.world.json" "${penbot[@]}" \
  --realism 1 --for 60 --report "$nxt/Wanderer.report.json"

for runs in runs nxt-runs; do
  rm -f "$resources/$runs"/*
  cp "$fresh/$runs"/* "$resources/$runs"
done
