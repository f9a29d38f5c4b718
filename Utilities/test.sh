#!/usr/bin/env bash
# Builds everything in Release with warnings as errors and runs every test. On Debian 12 it first
# installs the packages that are missing (with sudo, unless run by root).
# Usage: Utilities/test.sh [ctest option...]
# Environment: BUILD_DIR (default build/test), JOBS (default: number of cores).
# The last line says how many tests passed and failed; the exit code is 0 only if none failed.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
build="${BUILD_DIR:-build/test}"
jobs="${JOBS:-$(nproc)}"

Utilities/Scripts/install-packages.sh build run
python=OFF # without VTK's Python modules the package vtksoftshadows is neither built nor tested
! /usr/bin/python3 -c 'import vtkmodules' 2>/dev/null || python=ON
echo "Configuring and building in $build"
Utilities/Scripts/configure.sh "$build" -DBUILD_TESTING=ON -DCMAKE_COMPILE_WARNING_AS_ERROR=ON \
    -DSOFTSHADOWS_WRAP_PYTHON=$python
cmake --build "$build" -j "$jobs"

log="$build/ctest.log"
status=0
Utilities/Scripts/offscreen.sh \
    ctest --test-dir "$build" --output-on-failure --no-tests=error -j "$jobs" "$@" 2>&1 |
    tee "$log" || status=$?

summary="$(sed -nE 's/^[0-9]+% tests passed, ([0-9]+) tests failed out of ([0-9]+)$/\1 \2/p' "$log")"
read -r failed total <<<"${summary:-1 1}"
echo "$((total - failed)) passed, $failed failed"
[ "$status" -eq 0 ] && [ "$failed" -eq 0 ]
