#!/usr/bin/env bash
# Tries the project on another Debian suite, whose VTK, compiler, CMake and Mesa are other versions: in a
# root of its own (debootstrap) it runs quickstart and all tests, Python's among them, and compares the
# visibility that its tool makes with that of the tool built here.
# Usage: check-vtk.sh SUITE [step...]      (suites: trixie, forky; needs root)
#   root        makes the root, once, and installs the packages
#   source      copies the committed sources into it
#   quickstart  Utilities/quickstart.sh
#   tests       Utilities/test.sh
#   python      the Python package alone and its tests, those of PyVista among them
#   pictures    every technique in every bundled scene, against the tool built here: RMSE < 1e-4
#   row         prints a row for the README's table of what was run
# Without a step, all of them. The root is kept, so that a second run starts at its builds.
# Environment: ROOTS (default /var/cache/softshadows), MIRROR (http://deb.debian.org/debian),
# TOOL (the tool built here, default build/release/bin/softshadow).
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/../.."
[ $# -gt 0 ] || { sed -n '2,15p' "${BASH_SOURCE[0]}"; exit 1; }
suite="$1"
shift
[ $# -gt 0 ] || set -- root source quickstart tests pictures row
root="${ROOTS:-/var/cache/softshadows}/$suite"
mirror="${MIRROR:-http://deb.debian.org/debian}"
tool="${TOOL:-build/release/bin/softshadow}"
limit=1e-4

# In the root, in the folder of the sources.
within() {
    chroot "$root" env -u DISPLAY DEBIAN_FRONTEND=noninteractive LC_ALL=C.UTF-8 HOME=/root \
        bash -c 'cd /softshadows && "$@"' bash "$@"
}

mount_once() { mountpoint -q "$root/$1" || mount --bind "/$1" "$root/$1"; }

prepare() {
    mkdir -p "$root/softshadows"
    for folder in proc dev sys; do mount_once "$folder"; done
    trap 'for folder in proc dev sys; do umount -l "$root/$folder" 2>/dev/null || true; done' EXIT
}

make_root() {
    if [ ! -e "$root/etc/debian_version" ]; then
        # A newer suite has no script of its own here, and its keys are not known.
        local scripts=/usr/share/debootstrap/scripts script=sid
        [ ! -e "$scripts/$suite" ] || script="$suite"
        debootstrap --variant=minbase --no-check-gpg "$suite" "$root" "$mirror" "$scripts/$script"
        rm -f "$root"/etc/apt/sources.list.d/*
        echo "deb [trusted=yes] $mirror $suite main" >"$root/etc/apt/sources.list"
        # A mirror that stands still is good enough.
        printf '%s\n' 'Acquire::Check-Valid-Until "false";' 'Acquire::AllowInsecureRepositories "true";' \
            'APT::Get::AllowUnauthenticated "true";' >"$root/etc/apt/apt.conf.d/99softshadows"
    fi
    copy_source
    prepare
    within Utilities/Scripts/install-packages.sh build run
    within apt-get install -y -q --no-install-recommends libegl1 python3-pyvista
}

copy_source() {
    mkdir -p "$root/softshadows"
    git archive HEAD | tar -x -C "$root/softshadows"
}

# The visibility of a scene by a technique; a tool that cannot make it has said why.
render_all() {
    local folder="$1" run="$2" scene technique name
    for scene in Testing/Data/Scenes/*.json Utilities/Benchmark/Scenes/*.json; do
        for technique in $($run --list-techniques | grep -oE '^[a-z][a-z0-9_-]*'); do
            name="$folder/$(basename "$scene" .json)-$technique"
            $run render "$scene" --width 160 --height 120 --technique "$technique" \
                --visibility "$name.exr" -o "$name.png" || return 1
        done
    done
}

compare_all() {
    local here there file number failed=0 count=0
    here="$(mktemp -d)"
    there="$root/softshadows/build/visibility"
    mkdir -p "$there"
    render_all "$here" "$tool"
    within bash -c "$(declare -f render_all); render_all build/visibility build/quickstart/bin/softshadow"
    for file in "$here"/*.exr; do
        number="$("$tool" compare "$file" "$there/$(basename "$file")" |
            sed -n 's/^ *rmse *\([^ ]*\).*/\1/p' | sort -g | tail -n 1)"
        count=$((count + 1))
        if [ -z "$number" ] || ! awk "BEGIN { exit !($number < $limit) }"; then
            echo "$(basename "$file" .exr): RMSE ${number:-none}"
            failed=$((failed + 1))
        fi
    done
    rm -rf "$here"
    echo "$((count - failed)) of $count pictures within $limit" | tee "$root/softshadows/build/pictures.log"
    [ "$failed" -eq 0 ]
}

version() { within dpkg-query -W -f '${Version}' "$1" 2>/dev/null | sed 's/^[0-9]*://; s/[+~-].*//'; }

print_row() {
    local tests pictures
    tests="$(tail -n 1 "$root/softshadows/build/tests.log" 2>/dev/null || echo 'not run')"
    pictures="$(cat "$root/softshadows/build/pictures.log" 2>/dev/null || echo 'not run')"
    echo "| Debian $suite | $(version libvtk9-dev) | g++ $(version g++) | CMake $(version cmake) |" \
        "Mesa $(version libgl1-mesa-dri) | $tests | $pictures |"
}

status=0
for step in "$@"; do
    echo "== $suite: $step"
    case "$step" in
        root) make_root ;;
        source) copy_source ;;
        quickstart) prepare; within Utilities/quickstart.sh || status=1 ;;
        tests)
            prepare
            mkdir -p "$root/softshadows/build"
            within env BUILD_DIR=build/test Utilities/test.sh 2>&1 |
                tee "$root/softshadows/build/tests.log" || status=1
            ;;
        python)
            prepare
            within Utilities/Scripts/configure.sh build/python -DSOFTSHADOWS_WRAP_PYTHON=ON
            within cmake --build build/python -j "$(nproc)" --target python-package
            within Utilities/Scripts/offscreen.sh \
                ctest --test-dir build/python -L Python --output-on-failure || status=1
            ;;
        pictures) prepare; compare_all || status=1 ;;
        row) prepare; print_row ;;
        *) echo "check-vtk.sh: there is no step '$step'" >&2; exit 1 ;;
    esac
done
exit "$status"
