#!/usr/bin/env bash
# Starts the build. Uses Gradle's distribution if reachable, otherwise jars of Maven Central (see gradle/bootstrap/README.md).
# The choice is stored. ROBOTRAN_GRADLE=distribution or =embedded overrides it.
set -euo pipefail
root=$(cd "$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")" && pwd)
cache=${XDG_CACHE_HOME:-$HOME/.cache}/robotran
remembered=$cache/gradle-route
java=${JAVA_HOME:+$JAVA_HOME/bin/}java

command -v "$java" > /dev/null || { echo "Robotran's build needs a JDK 17: no java was found." >&2; exit 1; }
release=$("$java" -XshowSettings:properties -version 2>&1 | sed -n 's/ *java.specification.version = //p')
if [ "${release%%.*}" -lt 17 ] || [ "${release%%.*}" -gt 23 ]; then
  echo "Robotran's build needs a JDK 17 (up to 23), not $release: set JAVA_HOME to one." >&2
  exit 1
fi

# Whether the host of Gradle's distribution responds within a second.
distribution_answers() {
  local url host
  url=$(sed -n 's/^distributionUrl=//p' "$root/gradle/wrapper/gradle-wrapper.properties" | tr -d '\\')
  host=${url#*://}
  host=${host%%/*}
  if command -v curl > /dev/null; then
    curl --silent --fail --head --location --max-time 1 --output /dev/null "$url"
  else
    timeout 1 bash -c "exec 3<> /dev/tcp/$host/443" 2> /dev/null
  fi
}

route=${ROBOTRAN_GRADLE:-$(cat "$remembered" 2> /dev/null || true)}
case "$route" in
  distribution | embedded) ;;
  *)
    if distribution_answers; then
      route=distribution
      echo "Robotran: Gradle comes from its distribution (remembered in $remembered)"
    else
      route=embedded
      echo "Robotran: Gradle's distribution does not answer, so Gradle comes from Maven Central (remembered in $remembered)"
    fi
    mkdir -p "$cache"
    echo "$route" > "$remembered"
    ;;
esac

targets=$("$root/gradle/bootstrap/targets.sh" "$@")
set -- "-Drobotran.targets=$targets" "$@"
if [[ $targets == *android* ]]; then
  . "$root/gradle/bootstrap/android-sdk/environment.sh"
fi

# A build for the JVM alone is too short for Java's optimising compiler (C2) to pay off; without it, the build takes two thirds
# of the time. Compiling for wasm takes long enough.
setting() { sed -n "s/^$1=//p" "$root/gradle.properties"; }
if [[ $targets != *wasm* && $targets != *android* ]]; then
  quick=-XX:TieredStopAtLevel=1
  set -- "-Pkotlin.daemon.jvmargs=$(setting kotlin.daemon.jvmargs) $quick" "$@"
  if [ "$route" = distribution ]; then
    set -- "-Dorg.gradle.jvmargs=$(setting org.gradle.jvmargs) $quick" "$@"
  else
    export GRADLE_OPTS="$quick ${GRADLE_OPTS:-}"
  fi
fi

if [ "$route" = distribution ]; then
  exec "$java" -Xmx64m -Dorg.gradle.appname=gradlew \
    -classpath "$root/gradle/wrapper/gradle-wrapper.jar" org.gradle.wrapper.GradleWrapperMain "$@"
fi
version=$(cd "$root/gradle/bootstrap/gradle" && find . -type f -print0 | LC_ALL=C sort -z | xargs -0 sha256sum | sha256sum | cut -c1-12)
embedded=$cache/gradle-embedded-$version
"$root/gradle/bootstrap/gradle/install.sh" "$embedded"
exec "$embedded/bin/gradle" "$@"
