#!/usr/bin/env bash
# Prints the Android SDK folder to build with: the installed SDK, or one made by make-sdk.sh.
set -euo pipefail

here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
local_properties=$here/../../../local.properties

named=${ANDROID_HOME:-${ANDROID_SDK_ROOT:-}}
if [ -z "$named" ] && [ -f "$local_properties" ]; then
  # A properties file escapes colons and backslashes with a backslash.
  named=$(sed -n 's/^[[:space:]]*sdk\.dir[[:space:]]*=[[:space:]]*//p' "$local_properties" | tail -n 1 | tr -d '\r' | sed 's/\\\(.\)/\1/g')
fi

if [ -n "$named" ]; then
  echo "$named"
else
  exec "$here/make-sdk.sh"
fi
