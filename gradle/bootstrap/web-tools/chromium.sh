#!/usr/bin/env bash
# Prints the path of a Chromium for the browser tests: CHROME_BIN if set, else one on the PATH, else installs Debian's.
# The headless shell is the same engine without Chromium's own window. It is half the download and takes a fifth less
# processor time for a visit.
set -euo pipefail
. "$(dirname "${BASH_SOURCE[0]}")/debian-packages.sh"

find_browser() {
  local name
  for name in "${CHROME_BIN:-}" chromium-headless-shell chromium chromium-browser google-chrome; do
    if [ -n "$name" ] && command -v "$name"; then
      return 0
    fi
  done
  return 1
}

if ! find_browser \
  && ! { install_packages "Chromium's headless shell" chromium-headless-shell fonts-dejavu-core && find_browser; } \
  && ! { install_packages Chromium chromium fonts-dejavu-core && find_browser; }; then
  echo "The browser tests need Chromium: install it, or name one by CHROME_BIN." >&2
  exit 1
fi
