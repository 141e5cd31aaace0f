#!/usr/bin/env bash
# Installs the web tools (Node 24, webpack, binaryen, Playwright's driver) of package-lock.json into the folder DEST.
# usage: set-up.sh DEST
set -euo pipefail
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
destination=$1

if [ -e "$destination/complete" ]; then
  exit 0
fi
command -v npm > /dev/null || { echo "Robotran needs npm for its web tools: install Node.js with npm." >&2; exit 1; }
echo "Robotran: installing its web tools from the npm registry, once (about 30 s) into $destination"
mkdir -p "$(dirname "$destination")"
fresh=$(mktemp -d "$destination.XXXXXX")
trap 'rm -rf "$fresh"' EXIT
cp "$here/package.json" "$here/package-lock.json" "$fresh"
if ! (cd "$fresh" && npm ci --ignore-scripts --no-audit --no-fund --loglevel=error > npm.log 2>&1); then
  cat "$fresh/npm.log" >&2
  echo "Robotran could not install its web tools: see npm's words above." >&2
  exit 1
fi
touch "$fresh/complete"
rm -rf "$destination"
mv "$fresh" "$destination"
