#!/usr/bin/env bash
# Packages a built tree with cpack and proves the packages: each is unpacked into a folder that knows
# nothing of the build, and a consumer project is configured, built and run against it. Then the same
# with static libraries.
# Usage: check-package.sh [built folder]      (default: build/release)
# The packages stay in the folder packages of the build.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/../.."
build="$(realpath "${1:-build/release}")"
jobs="${JOBS:-$(nproc)}"
scripts="$PWD/Utilities/Scripts"
consumer="$PWD/Testing/Install/Consumer"
work="$(mktemp -d)"
trap 'rm -rf "$work"' EXIT

# Configures, builds and runs the consumer against the package below a prefix.
consume() {
    local name="$1" prefix="$2"
    cmake -S "$consumer" -B "$work/$name-consumer" -G Ninja -DCMAKE_BUILD_TYPE=Release \
        -DPython3_EXECUTABLE=/usr/bin/python3 -DCMAKE_PREFIX_PATH="$prefix" >"$work/log" 2>&1 ||
        { cat "$work/log"; return 1; }
    if ! grep -q "^SoftShadows_DIR:PATH=$prefix/" "$work/$name-consumer/CMakeCache.txt"; then
        echo "$name: another SoftShadows than the package's was found" >&2
        return 1
    fi
    cmake --build "$work/$name-consumer" -j "$jobs"
    "$scripts/offscreen.sh" "$work/$name-consumer/consumer"
    echo "$name: a consumer was built and run"
}

packages="$build/packages"
rm -rf "$packages"
cpack --config "$build/CPackConfig.cmake" -B "$packages" >"$work/cpack.log" ||
    { cat "$work/cpack.log"; exit 1; }
rm -rf "$packages/_CPack_Packages"

mkdir "$work/archive" "$work/deb"
tar -xzf "$packages"/softshadows-*.tar.gz -C "$work/archive" --strip-components=1
consume archive "$work/archive"
"$work/archive/bin/softshadow" --version

deb="$(echo "$packages"/softshadows_*.deb)"
dpkg-deb -f "$deb" Package Version Depends
dpkg-deb -f "$deb" Depends | grep -q libvtk9
dpkg-deb -x "$deb" "$work/deb"
consume deb "$work/deb/usr"
python="$(find "$work/deb/usr" -type d -name vtksoftshadows -path '*-packages/*')"
if [ -n "$python" ]; then
    dpkg-deb -f "$deb" Recommends | grep -q python3-vtk9
    (cd "$work" && PYTHONPATH="$(dirname "$python")" /usr/bin/python3 -c 'import vtksoftshadows')
    echo "deb: vtksoftshadows was imported"
fi

"$scripts/configure.sh" "$work/static" -DBUILD_SHARED_LIBS=OFF -DBUILD_TESTING=OFF \
    -DSOFTSHADOWS_BUILD_UTILITIES=OFF -DCMAKE_CXX_FLAGS_RELEASE="-O0 -DNDEBUG" >"$work/log" ||
    { cat "$work/log"; exit 1; }
cmake --build "$work/static" -j "$jobs" >"$work/log" || { cat "$work/log"; exit 1; }
cmake --install "$work/static" --prefix "$work/static-prefix" >/dev/null
consume static "$work/static-prefix"
