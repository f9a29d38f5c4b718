#!/usr/bin/env bash
# Builds everything in Release with warnings as errors and runs every test. On Debian 12 it first
# installs the packages that are missing (with sudo, unless run by root).
# Usage: Utilities/test.sh [ctest option that selects tests...]
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
    -DSOFTSHADOWS_WRAP_PYTHON=$python -DSOFTSHADOWS_UNITE_TESTS=ON
cmake --build "$build" -j "$jobs"

exec Utilities/Scripts/offscreen.sh Utilities/Scripts/run-tests.py -j "$jobs" "$build" "$@"
