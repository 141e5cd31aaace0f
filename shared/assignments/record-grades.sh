#!/usr/bin/env bash
# Records the grades of the class in src/commonTest/resources/grades anew: the JVM and the page are held against them.
set -euo pipefail
here=$(cd "$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")" && pwd)
grades=$here/src/commonTest/resources/grades
"$here/../../robotran" grade "$grades/parking.robotran" "$grades/class" --csv "$grades/grades.csv"
