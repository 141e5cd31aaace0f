#!/usr/bin/env bash
# Prints the path of a Chromium for the browser tests: CHROME_BIN if it is set, else one on the PATH, else Debian's, installed now.
set -euo pipefail

find_browser() {
  local name
  for name in "${CHROME_BIN:-}" chromium chromium-browser google-chrome; do
    if [ -n "$name" ] && command -v "$name"; then
      return 0
    fi
  done
  return 1
}

if find_browser; then
  exit 0
fi
as_root=()
[ "$(id -u)" = 0 ] || as_root=(sudo -n)
if ! command -v apt-get > /dev/null; then
  echo "The browser tests need Chromium: install it, or name one by CHROME_BIN." >&2
  exit 1
fi
echo "Robotran: installing Chromium from Debian's packages for the browser tests, once" >&2
log=$(mktemp)
trap 'rm -f "$log"' EXIT
if ! { "${as_root[@]}" apt-get update && DEBIAN_FRONTEND=noninteractive "${as_root[@]}" apt-get install -y --no-install-recommends chromium fonts-dejavu-core; } > "$log" 2>&1; then
  tail -n 20 "$log" >&2
  echo "Chromium could not be installed: install it by hand, or name one by CHROME_BIN." >&2
  exit 1
fi
find_browser
