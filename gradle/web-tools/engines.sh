#!/usr/bin/env bash
# Prints where the other engines are that the page is tested in, as lines for an environment: FIREFOX=, WEBKIT= and WEBKIT_DRIVER=. What is missing is
# installed from Debian's packages; where that cannot be, it is said in a sentence, and the tests leave that engine out.
set -euo pipefail
. "$(dirname "${BASH_SOURCE[0]}")/debian-packages.sh"

find_firefox() { command -v firefox-esr || command -v firefox; }
find_webkit() { find /usr/lib /usr/libexec -path '*webkit2gtk-4*/MiniBrowser' -type f 2> /dev/null | sort | tail -n 1 | grep .; }
find_driver() { command -v WebKitWebDriver; }

missing=()
command -v Xvfb > /dev/null || missing+=(xvfb)
find_firefox > /dev/null || missing+=(firefox-esr)
{ find_driver && find_webkit; } > /dev/null || missing+=(webkit2gtk-driver)
if [ ${#missing[@]} -gt 0 ]; then
  install_packages "${missing[*]}" "${missing[@]}" fonts-dejavu-core || true
fi

if ! command -v Xvfb > /dev/null; then
  echo "The page is tested in Chromium alone: without Xvfb, which is not here and could not be installed, Firefox and WebKit have nothing to draw on." >&2
  exit 0
fi
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
