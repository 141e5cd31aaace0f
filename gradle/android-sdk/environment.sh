# Sourced by gradlew, which has set $root: names the Android SDK to build with.
ANDROID_HOME=$("$root/gradle/android-sdk/find-sdk.sh")
export ANDROID_HOME
if [ -f "$ANDROID_HOME/made-by-robotran" ]; then
  # The Android plugin would fetch an aapt2 from Google's repository, which not every machine reaches.
  set -- "-Pandroid.aapt2FromMavenOverride=$(echo "$ANDROID_HOME"/build-tools/*/aapt2)" "$@"
fi
