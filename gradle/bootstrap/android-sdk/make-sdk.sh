#!/usr/bin/env bash
# Creates an Android SDK folder that can build Robotran (and nothing else) from packages of Maven Central.
# Prints the folder and does nothing else if it exists.
# Usage: make-sdk.sh [DEST]
set -euo pipefail

here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
api=35
build_tools=35.0.0

fail() {
  echo "No Android SDK could be made: $1" >&2
  exit 1
}

hash_of_inputs() {
  local sum=(sha256sum)
  command -v sha256sum >/dev/null || sum=(shasum -a 256)
  cat "$here/make-sdk.sh" "$here/pom.xml" "$here"/package-xml/*.xml "$here"/src/robotran/sdk/*.java | "${sum[@]}" | cut -c 1-16
}

hash=$(hash_of_inputs)
dest=${1:-${XDG_CACHE_HOME:-$HOME/.cache}/robotran/android-sdk-$hash}
is_made() { [ "$(cat "$dest/made-by-robotran" 2>/dev/null)" = "$hash" ]; }

if is_made; then
  echo "$dest"
  exit
fi

echo "Robotran: no Android SDK on this machine: making one that can build it, once (200 MB, about 20 s), in $dest" >&2

java_bin=${JAVA_HOME:+$JAVA_HOME/bin/}
command -v "${java_bin}javac" >/dev/null || fail "there is no javac (install JDK 17)"
command -v mvn >/dev/null || fail "there is no mvn (install Maven, or an Android SDK and name it by ANDROID_HOME)"
case $(uname -s)-$(uname -m) in
  Linux-x86_64) aapt2=prebuilt/linux/aapt2 ;;
  Darwin-*) aapt2=prebuilt/macosx/aapt2 ;;
  *) fail "there is no aapt2 for $(uname -sm) (install an Android SDK and name it by ANDROID_HOME)" ;;
esac

# Build in a temporary folder next to the target and rename it at the end, so that the target is always complete.
mkdir -p "$(dirname "$dest")" || fail "$(dirname "$dest") cannot be made"
work=$(mktemp -d "$dest.XXXXXX")
trap 'rm -rf "$work"' EXIT
sdk=$work/sdk
jars=$work/jars
platform=$sdk/platforms/android-$api
tools=$sdk/build-tools/$build_tools
mkdir -p "$platform" "$tools" "$sdk/platform-tools" "$work/classes" "$work/empty"

if ! mvn -q -B -f "$here/pom.xml" dependency:copy-dependencies -DoutputDirectory="$jars" >"$work/maven.log" 2>&1; then
  cat "$work/maven.log" >&2
  fail "Maven could not fetch its parts (is there a network? the lines above say more)"
fi

"${java_bin}javac" -cp "$jars/*" -d "$work/classes" "$here"/src/robotran/sdk/*.java ||
  fail "its Java sources do not compile"
"${java_bin}java" -cp "$work/classes:$jars/*" robotran.sdk.MakeAndroidJar "$jars"/android-all-*.jar "$platform" ||
  fail "android.jar could not be written"
(cd "$tools" && "${java_bin}jar" --extract --file "$jars"/apktool-lib-*.jar "$aapt2" && mv "$aapt2" aapt2 && rm -r prebuilt) ||
  fail "aapt2 is not where it should be in apktool-lib"
chmod 755 "$tools/aapt2"

# The Android plugin requires these tools to exist, but this build runs none of them.
for tool in aapt aidl dexdump zipalign split-select lld; do
  printf '#!/bin/sh\necho "%s is not in this build-only SDK" >&2\nexit 1\n' "$tool" >"$tools/$tool"
  chmod 755 "$tools/$tool"
done
"${java_bin}jar" --create --file "$tools/core-lambda-stubs.jar" -C "$work/empty" .
touch "$platform/framework.aidl"

cp "$here/package-xml/platform.xml" "$platform/package.xml"
cp "$here/package-xml/build-tools.xml" "$tools/package.xml"
cp "$here/package-xml/platform-tools.xml" "$sdk/platform-tools/package.xml"
printf 'ro.build.version.sdk=%s\nro.build.version.release=15\nro.build.version.codename=REL\n' "$api" >"$platform/build.prop"
printf 'AndroidVersion.ApiLevel=%s\nPlatform.Version=15\nPkg.Revision=2\nLayoutlib.Api=15\n' "$api" >"$platform/source.properties"
printf 'Pkg.Revision=%s\n' "$build_tools" >"$tools/source.properties"
echo "$hash" >"$sdk/made-by-robotran"

if [ -e "$dest" ]; then
  is_made || mv "$dest" "$work/old"
fi
is_made || mv "$sdk" "$dest" || is_made || fail "$dest cannot be written"
echo "$dest"
