#!/usr/bin/env bash
# Records the grades of the class in src/commonTest/resources/grades anew: the JVM and the page are held against them.
set -euo pipefail
here=$(cd "$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")" && pwd)
grades=$here/src/commonTest/resources/grades
recorded=$(mktemp -d)
trap 'rm -rf "$recorded"' EXIT
# Its status says that not all hand-ins are solved and not all can be used, as it should be in this class.
"$here/../../robotran" grade "$grades/parking.robotran" "$grades/class" --language en --csv "$recorded/grades.csv" || [ $? -eq 2 ]
cp "$recorded/grades.csv" "$grades/grades.csv"
