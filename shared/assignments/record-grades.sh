#!/usr/bin/env bash
# Records the grades of the classes in src/commonTest/resources/grades anew: the JVM and the page are held against them.
set -euo pipefail
here=$(cd "$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")" && pwd)
grades=$here/src/commonTest/resources/grades
recorded=$(mktemp -d)
trap 'rm -rf "$recorded"' EXIT

# record FOLDER ASSIGNMENT: grades its class. The status says that not all hand-ins are solved and not all can be used, as
# it should be in these classes.
record() {
  "$here/../../robotran" grade "$1/$2" "$1/class" --language en --csv "$recorded/grades.csv" || [ $? -eq 2 ]
  cp "$recorded/grades.csv" "$1/grades.csv"
}
record "$grades" parking.robotran
record "$grades/nxt" wall.robotran
