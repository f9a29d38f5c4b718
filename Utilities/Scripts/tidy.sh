#!/usr/bin/env bash
# clang-tidy over the project's sources, or those whose path below the root matches a pattern.
# Usage: tidy.sh [build folder [regular expression]]
#   tidy.sh build/test 'Modules/Core/.*'
# The build folder (default: build/test) must be built, for the generated headers.
set -euo pipefail
root="$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)"
build="$(realpath "${1:-$root/build/test}")"
pattern="${2:-(Modules|Testing|Utilities|Examples)/.*}"
if [ ! -e "$build/compile_commands.json" ]; then
    echo "$build has no compile_commands.json: configure it first" >&2
    exit 1
fi
log="$build/tidy.log"
status=0
# Also tests that are compiled several at once (SOFTSHADOWS_UNITE_TESTS).
files="^($root/$pattern|$build/$pattern/Unity/.*)"
run-clang-tidy -quiet -p "$build" -j "$(nproc)" "$files" >"$log" 2>&1 || status=$?
sed -i 's/\x1b\[[0-9;]*m//g' "$log" # colours
grep -E -A 4 '(warning|error):' "$log" || true
count="$(grep -c '^clang-tidy' "$log" || true)"
if [ "$count" -eq 0 ]; then
    echo "tidy: no file matches"
    exit 1
fi
if [ "$status" -ne 0 ]; then
    echo "tidy: $count files, with complaints; all output is in $log"
    exit 1
fi
echo "tidy: $count files, clean"
