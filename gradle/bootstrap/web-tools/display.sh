#!/usr/bin/env bash
# Prints the path of Xvfb, a virtual display for tests. Installs it from Debian packages if it is missing. If that
# fails, prints nothing but a message to standard error; tests that need a display are skipped.
set -euo pipefail
. "$(dirname "${BASH_SOURCE[0]}")/debian-packages.sh"

if ! command -v Xvfb && ! { install_packages Xvfb xvfb > /dev/null && command -v Xvfb; }; then
  echo "What needs a display is tested only where there is one: Xvfb is not here and could not be installed." >&2
fi
