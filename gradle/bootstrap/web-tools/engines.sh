#!/usr/bin/env bash
# Prints the other browser engines as environment variables: FIREFOX=, WEBKIT= and WEBKIT_DRIVER=. Installs missing ones
# from Debian packages. If that fails, prints a message; tests of that engine are skipped.
set -euo pipefail
here=$(dirname "${BASH_SOURCE[0]}")
. "$here/debian-packages.sh"

find_firefox() { command -v firefox-esr || command -v firefox; }
find_webkit() { find /usr/lib /usr/libexec -path '*webkit2gtk-4*/MiniBrowser' -type f 2> /dev/null | sort | tail -n 1 | grep .; }
find_driver() { command -v WebKitWebDriver; }

if [ -z "$("$here/display.sh")" ]; then
  echo "The page is tested in Chromium alone: Firefox and WebKit have nothing to draw on." >&2
  exit 0
fi
find_firefox > /dev/null || install_packages Firefox firefox-esr fonts-dejavu-core || true
{ find_driver && find_webkit; } > /dev/null || install_packages WebKitGTK webkit2gtk-driver fonts-dejavu-core || true

if firefox=$(find_firefox); then
  echo "FIREFOX=$firefox"
else
  echo "The page is not tested in Firefox, which is not here and could not be installed." >&2
fi
if driver=$(find_driver) && webkit=$(find_webkit); then
  echo "WEBKIT=$webkit"
  echo "WEBKIT_DRIVER=$driver"
else
  echo "The page is not tested in WebKit, since WebKitGTK's MiniBrowser and WebKitWebDriver are not here and could not be installed." >&2
fi
