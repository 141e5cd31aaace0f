#!/usr/bin/env bash
# Prints where Xvfb is, which gives tests a display that nobody sees. Where it is missing it is installed from Debian's packages; where that cannot be, it is
# said in a sentence, nothing is printed, and the tests that need it are skipped.
set -euo pipefail
. "$(dirname "${BASH_SOURCE[0]}")/debian-packages.sh"

if ! command -v Xvfb && ! { install_packages Xvfb xvfb > /dev/null && command -v Xvfb; }; then
  echo "What needs a display is tested only where there is one: Xvfb is not here and could not be installed." >&2
fi
