#!/usr/bin/env bash
# Packs what measures frames on a machine with a graphics card and nothing installed into one archive:
# SoftShadowsFrameCost with its libraries, VTK's among them, two models, and a script that runs it.
# Usage: gpu-bundle.sh [build folder] [archive]   (default: build/test, softshadows-gpu.tar.xz)
#
# On the other machine, x86-64 Linux whose C library is no older than this one's, with a screen that the card
# draws (DISPLAY; VTK on Debian 12 knows GLX alone, not EGL):
#     tar xf softshadows-gpu.tar.xz && softshadows-gpu/run.sh [frames]
# prints a table of all techniques that draw with OpenGL, of VTK's plain frame and of its own shadows, at
# 1920 x 1080 (SIZE="WIDTH HEIGHT" changes that), and leaves it in results.md and results.json. What belongs to
# the machine's driver and C library is not in the archive; what the driver may need in a newer version (libstdc++
# among them), X11 and the ways to the driver (libglvnd) are used only where they are missing.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/../.."
build="${1:-build/test}"
archive="$(realpath -m "${2:-softshadows-gpu.tar.xz}")"
program="$build/bin/SoftShadowsFrameCost"
[ -x "$program" ] || { echo "no such program: $program" >&2; exit 2; }

work="$(mktemp -d)"
trap 'rm -rf "$work"' EXIT
bundle="$work/softshadows-gpu"
mkdir -p "$bundle/bin" "$bundle/lib" "$bundle/lib-if-missing" "$bundle/models"
cp "$program" "$bundle/bin/"
cp Testing/Data/bunny.ply Testing/Data/dragon.ply "$bundle/models/"

while read -r name file; do
    case "$name" in
        libc.so.* | libm.so.* | libdl.so.* | librt.so.* | libpthread.so.* | ld-linux*) ;;
        libGLEW.so.*) cp -L "$file" "$bundle/lib/$name" ;;
        libstdc++.so.* | libgcc_s.so.* | libz.so.* | liblzma.so.* | \
            libGL*.so.* | libOpenGL.so.* | libX* | libxcb* | libICE* | libSM* | libbsd* | libmd.so.* | libuuid*)
            cp -L "$file" "$bundle/lib-if-missing/$name"
            ;;
        *) cp -L "$file" "$bundle/lib/$name" ;;
    esac
done < <(ldd "$program" | awk '$2 == "=>" && $3 ~ /^\// { print $1, $3 }')
strip --strip-unneeded "$bundle"/bin/* "$bundle"/lib/* "$bundle"/lib-if-missing/*

cat >"$bundle/run.sh" <<'RUN'
#!/bin/sh
# Usage: run.sh [frames]      Environment: DISPLAY, SIZE="WIDTH HEIGHT", MODELS
cd "$(dirname "$0")" || exit 1
[ -n "$DISPLAY" ] || { echo "DISPLAY names no screen" >&2; exit 2; }
libraries="$PWD/lib"
for file in lib-if-missing/*; do
    name="${file##*/}"
    found=
    for folder in /lib/x86_64-linux-gnu /usr/lib/x86_64-linux-gnu /usr/lib64 /lib64 /usr/lib; do
        [ ! -e "$folder/$name" ] || found=1
    done
    [ -n "$found" ] || { mkdir -p lib-used && cp "$file" lib-used/; }
done
[ ! -d lib-used ] || libraries="$libraries:$PWD/lib-used"
LD_LIBRARY_PATH="$libraries" bin/SoftShadowsFrameCost --techniques --size ${SIZE:-1920 1080} \
    --frames "${1:-15}" ${MODELS-models/bunny.ply models/dragon.ply} >results.md
status=$?
cat results.md
awk -F ' *[|] *' '
    /^OpenGL renderer/ { sub(/^[^:]*: */, ""); renderer = $0 }
    /^OpenGL version/ { sub(/^[^:]*: */, ""); version = $0 }
    / pixels$/ { pixels = $0 }
    /^[|]/ && $4 ~ /^[0-9.]+$/ {
        split($2, scene, ", ")
        rows = rows (rows == "" ? "" : ",") sprintf("\n    {\"scene\": \"%s\", \"moves\": \"%s\", \"frame\": \"%s\", \"median_milliseconds\": %s, \"ratio\": %s, \"steps_milliseconds\": %s}",
            scene[1], scene[2], $3, $4, $6, $7 == "" ? "null" : $7)
    }
    END { printf "{\n  \"driver\": \"%s\",\n  \"version\": \"%s\",\n  \"size\": \"%s\",\n  \"rows\": [%s\n  ]\n}\n", renderer, version, pixels, rows }
' results.md >results.json
exit $status
RUN
chmod +x "$bundle/run.sh"
tar -C "$work" -cJf "$archive" softshadows-gpu
echo "$archive: $(du -m "$archive" | cut -f 1) MiB"
