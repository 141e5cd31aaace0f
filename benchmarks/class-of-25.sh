#!/usr/bin/env bash
# Writes the hand-ins of a class of 25 for worlds/maze.world.json into a folder, as a learning platform would: 20 honest ones in
# both languages and 5 hostile ones. To measure how long grading takes:
#   benchmarks/class-of-25.sh build/class && time ./robotran grade worlds/maze.world.json build/class --seeds 1..20
set -euo pipefail
[ $# -eq 1 ] || { echo "usage: $0 FOLDER" >&2; exit 2; }
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
maze=$root/learning/worlds/maze
number=1000

# folder PUPIL: makes the pupil's folder and prints its name.
folder() {
  mkdir -p "$1"
  echo "$1"
}

# pupil NAME: the folder of the next pupil.
pupil() {
  number=$((number + 1))
  inside=$(folder "$class/$1_${number}_assignsubmission_file_")
}

# java CLASS STATEMENTS [MEMBERS]: a leJOS program of the pupil.
java() {
  printf 'import josx.platform.rcx.*;\n\npublic class %s {\n%s    public static void main(String[] args) throws Exception {\n%s    }\n}\n' \
    "$1" "${3:-}" "$2" > "$inside/$1.java"
}

# follow CURVE TURN: statements that keep a wall to the right.
follow() {
  cat << JAVA
        Sensor.S1.setTypeAndMode(1, 0x20);
        Sensor.S3.setTypeAndMode(1, 0x20);
        while (true) {
            Motor.A.setPower(7);
            Motor.C.setPower($1);
            Motor.A.forward();
            Motor.C.forward();
            while (Sensor.S1.readValue() == 0 && Sensor.S3.readValue() == 0) { Thread.sleep(5); }
            boolean ahead = Sensor.S1.readValue() == 1;
            Motor.A.setPower(4);
            Motor.C.setPower(4);
            Motor.A.backward();
            Motor.C.backward();
            Thread.sleep(ahead ? 400 : 250);
            Motor.C.forward();
            Thread.sleep(ahead ? $((2 * $2)) : $2);
        }
JAVA
}

class=$1
mkdir -p "$class"

for name in Anna Ben Cem Dora Emil Fay Gus Hana; do
  pupil "$name Solved"
  # Each goes round corners in a way of its own.
  sed "s/turn left 25/turn left $((18 + 2 * (number % 8)))/" "$maze/solution.robo" > "$inside/maze.robo"
done
for try in curve-to-the-left given no-small-turn only-once straight-on; do
  pupil "Ida $try"
  cp "$maze/wrong/$try.robo" "$inside/maze.robo"
done
for name in Jana Kim Lea Max; do
  pupil "$name Java"
  java Follow "$(follow $((number % 3)) $((150 + 20 * (number % 4))))"$'\n'
done
pupil "Nora Java"
cp "$root/examples/lejos/WallBouncer.java" "$inside/"
pupil "Otto Java"
cp "$root/examples/lejos/Spiral.java" "$inside/"
pupil "Pia Java"
java Straight $'        Motor.A.forward();\n        Motor.C.forward();\n        Thread.sleep(20000);\n'

pupil "Quin Endless"
printf 'var n = 0\nrepeat forever\n  n = n + 1\nend\n' > "$inside/endless.robo"
pupil "Rob Hog"
java Hog $'        Object[] all = new Object[1000];\n        while (true) { for (int i = 0; i < 1000; i++) { all[i] = new int[100]; } }\n'
pupil "Sam Threads"
java Many $'        while (true) { new Many().start(); }\n' $'    public void run() { while (true) { } }\n\n'
sed -i 's/class Many/class Many extends Thread/' "$inside/Many.java"
pupil "Tim Fails"
java Fails $'        int[] none = null;\n        none[3] = 1;\n'
pupil "Una Deep"
java Deep $'        deep(1);\n' $'    static int deep(int n) { return deep(n + 1) + 1; }\n\n'
