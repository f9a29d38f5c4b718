#!/usr/bin/env bash
# Configures a Release build folder for the other scripts.
# Usage: configure.sh <build folder> [cmake option...]
set -euo pipefail
root="$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)"
build="$1"
shift

options=(-DCMAKE_BUILD_TYPE=Release)
# Debian's VTK belongs to Debian's Python, whichever else comes first in PATH.
[ ! -x /usr/bin/python3 ] || options+=(-DPython3_EXECUTABLE=/usr/bin/python3)
if command -v ccache >/dev/null; then
    options+=(-DCMAKE_CXX_COMPILER_LAUNCHER=ccache -DCMAKE_C_COMPILER_LAUNCHER=ccache)
fi
[ -e "$build/CMakeCache.txt" ] || options+=(-G Ninja)

mkdir -p "$build"
log="$build/configure.log"
options+=(--no-warn-unused-cli) # modules that look for Python may be off
if ! cmake -S "$root" -B "$build" "${options[@]}" "$@" >"$log" 2>&1; then
    cat "$log"
    echo "Configuring failed; this was $log" >&2
    exit 1
fi
grep -A 8 -E '^CMake (Warning|Error|Deprecation)' "$log" || true
