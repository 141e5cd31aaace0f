#!/usr/bin/env bash
# Prints the path of a Chromium for the browser tests: CHROME_BIN if set, else one on the PATH, else installs Debian's.
set -euo pipefail
. "$(dirname "${BASH_SOURCE[0]}")/debian-packages.sh"

find_browser() {
  local name
  for name in "${CHROME_BIN:-}" chromium chromium-browser google-chrome; do
    if [ -n "$name" ] && command -v "$name"; then
      return 0
    fi
  done
  return 1
}

if ! find_browser && ! { install_packages Chromium chromium fonts-dejavu-core && find_browser; }; then
  echo "The browser tests need Chromium: install it, or name one by CHROME_BIN." >&2
  exit 1
fi
