#!/bin/sh
# Compares the public API of our class library for an NXT with that of a jar, or a folder, of leJOS NXJ's own classes:
#
#     shared/nxj-library/compare-api.sh CLASSES.jar            # a table by package, and all that is missing here or more
#     shared/nxj-library/compare-api.sh --table CLASSES.jar    # the table alone
#
# It compiles our library first. CompareApi.java compares any two jars or folders.
set -e
here=$(cd "$(dirname "$0")" && pwd)
if [ $# -eq 0 ]; then
  sed -n 's/^# \{0,1\}//p' "$0" | sed 1d
  exit 2
fi
"$here/../../gradlew" -q -p "$here/../.." :shared:nxj-library:compileForBrick >&2
exec java "$here/CompareApi.java" "$@" "$here/build/brick/library/classes"
