#!/usr/bin/env bash
# Builds a Gradle that runs in one JVM in the folder DEST, from jars of Maven Central and the sources here.
# usage: install.sh DEST
set -euo pipefail
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
destination=$1

if [ -e "$destination/complete" ]; then
  exit 0
fi
for tool in mvn javac jar; do
  command -v "$tool" > /dev/null || { echo "Robotran's build needs $tool: install Maven and a JDK 17." >&2; exit 1; }
done
echo "Robotran: putting Gradle together from Maven Central, once (195 MB, about 20 s) in $destination"
mkdir -p "$(dirname "$destination")"
fresh=$(mktemp -d "$destination.XXXXXX")
trap 'rm -rf "$fresh"' EXIT
lib=$fresh/lib
mkdir -p "$lib/plugins" "$fresh/bin" "$fresh/classes" # Gradle takes a 'lib' with a 'plugins' beside its jar for its home
if ! mvn -q -B -f "$here/pom.xml" dependency:copy-dependencies -DoutputDirectory="$lib" > "$fresh/maven.log" 2>&1; then
  cat "$fresh/maven.log" >&2
  echo "Robotran could not fetch Gradle's jars: see Maven's words above." >&2
  exit 1
fi
find "$here/src" -name '*.java' -print0 \
  | xargs -0 javac -source 17 -target 17 -proc:none -nowarn -Xlint:-options -cp "$lib/*" -d "$fresh/classes" 2> "$fresh/javac.log" \
  || { cat "$fresh/javac.log" >&2; exit 1; }
cp -r "$here/resources/." "$fresh/classes"
for rewriter in LambdaDescriptorRelocator TestFrameworkUnshader; do
  java -cp "$fresh/classes:$lib/*" "embedded.$rewriter" "$lib"/gradle-api-*.jar "$fresh/classes"
done
jar --create --file "$lib/gradle-embedded-1.jar" -C "$fresh/classes" .
rm -r "$fresh/classes"
install -m 755 "$here/gradle" "$fresh/bin/gradle"
touch "$fresh/complete"
rm -rf "$destination"
mv "$fresh" "$destination"
