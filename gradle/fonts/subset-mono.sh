#!/usr/bin/env bash
# Makes shared/uikit/src/commonMain/composeResources/font/jetbrains_mono_regular.ttf of JetBrains Mono's own file
# (docs/third-party.md says from where): letters, marks and signs stay; instructions for screens with few pixels, signs of
# terminals and names of glyphs go. Needs fontTools 4.
# usage: subset-mono.sh JetBrainsMono-Regular.ttf jetbrains_mono_regular.ttf
set -euo pipefail
letters=U+0020-007E,U+00A0-024F,U+0259,U+02BC,U+02C6-02DD,U+0300-036F,U+0370-03FF,U+0400-045F,U+0490-0491,U+1E00-1EFF
signs=U+2000-2BFF,U+FFFD
pyftsubset "$1" --unicodes="$letters,$signs" --layout-features='*' --no-hinting --output-file="$2"
