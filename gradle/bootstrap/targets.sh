#!/usr/bin/env bash
# Prints what a build of the given Gradle arguments has to configure, for the system property robotran.targets
# (see Targets in gradle/build-logic): nothing more than the requested tasks need. Arguments whose tasks belong to no
# single module, such as checkAll, need everything; check and quick leave Android out.
set -euo pipefail

everything=jvm,wasm,android,compose
needed=

# need TARGET..: adds each of them once.
need() {
  local target
  for target in "$@"; do
    [[ ,$needed, == *,$target,* ]] || needed=$needed${needed:+,}$target
  done
}

while [ $# -gt 0 ]; do
  case "$1" in
    -Drobotran.targets=*) echo "${1#*=}"; exit ;;
    --tests | -x | --exclude-task | -g | --gradle-user-home | -p | --project-dir | -I | --init-script | --args) shift ;;
    -*) ;;
    check | quick) need jvm wasm compose ;;
    :cli:* | :siteServer:* | :shared:physics:test | :shared:ecj:test) need jvm ;;
    :desktopApp:* | :shared:workshop:*[jJ]vm* | :shared:ui*:*[jJ]vm* | :shared:ui*:thoroughTest) need jvm compose ;;
    :shared:*:*[jJ]vm* | :shared:*:fuzzTest | :shared:*:thoroughTest) need jvm ;;
    :wasmTests:* | :allWasmTests:* | :webApp:*) need wasm compose ;;
    :shared:workshop:*[wW]asm* | :shared:ui*:*[wW]asm*) need wasm compose ;;
    :shared:*:*[wW]asm*) need wasm ;;
    :androidApp:*) need jvm android compose ;;
    *) needed=; break ;;
  esac
  shift
done
[ $# = 0 ] && [ -n "$needed" ] || needed=$everything
echo "$needed"
