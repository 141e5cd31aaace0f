#!/usr/bin/env bash
# Runs a build and shows its progress in one line on standard error: what it does, how far it is, and how long it will
# take, as remembered from the builds before. Where standard error is no terminal, it prints a line each minute.
# usage: progress.sh WHAT SECONDS COMMAND..   WHAT is built; SECONDS it takes on a machine that has never built it
set -euo pipefail
what=$1 typical=$2
shift 2
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
memory=${XDG_CACHE_HOME:-$HOME/.cache}/robotran/build-times/$what
times=$root/build/reports/task-times.tsv # written by TaskTimes in gradle/build-logic
libraries=("${GRADLE_USER_HOME:-$HOME/.gradle}/caches/modules-2/files-2.1" "$HOME/.m2/repository")
log=$(mktemp)
trap 'rm -f "$log"' EXIT
mkdir -p "$(dirname "$memory")"
touch "$memory"
rm -f "$times"
[ -t 2 ] && watched=true || watched=false

megabytes() { { du -sck "${libraries[@]}" 2> /dev/null || true; } | awk 'END { print int($1 / 1024) }'; }

# in_words SECONDS: as a person would say it.
in_words() {
  if [ "$1" -gt 90 ]; then
    echo "about $((($1 + 30) / 60)) minutes left"
  elif [ "$1" -gt 45 ]; then
    echo "about a minute left"
  else
    echo "less than a minute left"
  fi
}

# Prints the number of finished tasks, the number of all, the seconds that are left, and the task that was finished last.
# A line of $memory is a task and its seconds; tasks at once and cores faster or slower than then are allowed for.
estimate() {
  awk -F '\t' -v elapsed="$1" -v typical="$typical" '
    FILENAME == ARGV[1] { known[$1] = $2; all++; next }
    { done++; if (!($1 in known)) extra++; else { finished[$1]; passed += known[$1] }; last = $1 }
    END {
      for (task in known) { total += known[task]; if (!(task in finished)) left += known[task] }
      if (all == 0) { print done + 0, 0, (typical > elapsed ? typical - elapsed : 0), last; exit }
      print done + 0, all + extra, int(left), last
    }' "$memory" <([ -e "$times" ] && cat "$times" || true)
}

fetched_before=$(megabytes)
SECONDS=0
"$@" < /dev/null > "$log" 2>&1 &
build=$!
# Ctrl C does not reach a command in the background by itself.
trap 'kill "$build" 2> /dev/null; printf "\n" >&2; exit 130' INT TERM
said=0 # lines of the log that were shown
minute=0
while kill -0 "$build" 2> /dev/null; do
  lines=$(wc -l < "$log")
  news=$(sed -n "$((said + 1)),${lines}p" "$log" | grep '^Robotran:' || true)
  said=$lines
  if [ -n "$news" ]; then
    if $watched; then printf '\r\033[K' >&2; fi
    echo "$news" >&2
  fi
  if $watched || [ $((SECONDS / 60)) -gt "$minute" ]; then
    minute=$((SECONDS / 60))
    read -r finished all left last <<< "$(estimate "$SECONDS")"
    fetched=$(($(megabytes) - fetched_before))
    line="Robotran: building $what"
    if [ "$finished" = 0 ]; then
      line+=", preparing"
    elif [ "$all" = 0 ]; then
      line+=", $finished tasks done"
    else
      line+=", $finished of $all tasks done"
    fi
    line+=", $(in_words "$left")"
    if [ "$fetched" -gt 0 ]; then line+=", $fetched MB fetched"; fi
    if [ -n "$last" ]; then line+=" (${last#:})"; fi
    if $watched; then printf '\r\033[K%s' "${line:0:$(($(tput cols 2> /dev/null || echo 80) - 1))}" >&2; else echo "$line" >&2; fi
  fi
  sleep 1
done
status=0
wait "$build" || status=$?
if $watched; then printf '\r\033[K' >&2; fi
sed -n "$((said + 1)),\$p" "$log" | grep '^Robotran:' >&2 || true
if [ "$status" != 0 ]; then
  tail -n 40 "$log" >&2
  exit "$status"
fi
# Remember what each task took when it was last executed.
if [ -e "$times" ]; then
  awk -F '\t' '
    FILENAME == ARGV[1] { known[$1] = $2; next }
    { seconds = ($3 - $2) / 1000; print $1 "\t" ($4 == "executed" || !($1 in known) ? seconds : known[$1]) }
  ' "$memory" "$times" > "$memory.new"
  mv "$memory.new" "$memory"
fi
