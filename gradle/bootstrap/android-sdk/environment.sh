# Sourced by gradlew, which sets $root. Sets the Android SDK to build with.
ANDROID_HOME=$("$root/gradle/bootstrap/android-sdk/find-sdk.sh")
export ANDROID_HOME
if [ -f "$ANDROID_HOME/made-by-robotran" ]; then
  # The Android plugin would download aapt2 from Google's repository, which some machines cannot reach.
  set -- "-Pandroid.aapt2FromMavenOverride=$(echo "$ANDROID_HOME"/build-tools/*/aapt2)" "$@"
fi
