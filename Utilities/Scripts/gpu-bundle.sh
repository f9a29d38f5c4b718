#!/usr/bin/env bash
# Packs what checks a machine with a graphics card and nothing installed into one archive: a program that
# times and judges every technique in the benchmark's scenes, the modules' unit tests, all their libraries,
# references by ray tracing, and a script that runs them.
# Usage: gpu-bundle.sh [build folder] [archive]   (default: build/test, softshadows-gpu.tar.xz; for a machine
# without xz name it .tar.gz, which is half again as large)
# Environment: SIZE ("1920 1080"), SAMPLES (rays per light and pixel of the references, 256), SCENES (names
# with blanks between; all). References of all scenes take a quarter of an hour on two cores.
#
# On the other machine, x86-64 Linux:
#     tar xf softshadows-gpu.tar.xz && softshadows-gpu/run.sh
# takes less than eight minutes, prints tables, and leaves results.json, results.md and tests.log where it
# was called. VTK of Debian 12 draws through GLX alone and needs a screen that the card draws (DISPLAY);
# from VTK 9.4 (Debian testing: pack there) it draws through EGL, and no screen is needed. What belongs to the
# machine's driver is not in the archive; its C library and what the driver may need in a newer version (libstdc++
# among them), X11 and the ways to the driver (libglvnd) are used only where the machine's are missing or older.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/../.."
build="${1:-build/test}"
archive="$(realpath -m "${2:-softshadows-gpu.tar.xz}")"
program="$build/bin/SoftShadowsCardCheck"
read -ra size <<<"${SIZE:-1920 1080}"
read -ra scenes <<<"${SCENES:-}"
[ -x "$program" ] || { echo "no such program: $program" >&2; exit 2; }

work="$(mktemp -d)"
trap 'rm -rf "$work"' EXIT
bundle="$work/softshadows-gpu"
mkdir -p "$bundle"/{bin,lib,lib-if-missing,libc,Scenes,Models}
cp "$program" "$bundle/bin/"
for file in "$build"/bin/vtkRenderingSoftShadows*UnitTests; do
    # Those that read pictures need an image library, and with it three hundred others.
    case "$(ldd "$file")" in
        *libOpenImageIO*) ;;
        *) cp "$file" "$bundle/bin/" ;;
    esac
done
cp Testing/Data/bunny.ply Testing/Data/dragon.ply "$bundle/Models/"
for file in "$build"/Utilities/Benchmark/Scenes/*.json; do
    name="$(basename "$file" .json)"
    [ ${#scenes[@]} -gt 0 ] && [[ " ${scenes[*]} " != *" $name "* ]] || cp "$file" "$bundle/Scenes/"
done
"$program" "$bundle" --references --size "${size[@]}" --samples "${SAMPLES:-256}" --output "$work/traced"

# Ways to the driver that VTK opens by name are in no program's list.
{
    for file in "$bundle"/bin/*; do ldd "$file"; done
    for name in libEGL.so.1 libGL.so.1 libGLX.so.0 libOpenGL.so.0 libGLdispatch.so.0; do
        echo "$name => /usr/lib/x86_64-linux-gnu/$name"
    done
} | awk '$2 == "=>" && $3 ~ /^\// && !seen[$1]++ { print $1, $3 }' >"$work/libraries"
while read -r name file; do
    case "$name" in
        libc.so.* | libm.so.* | libdl.so.* | librt.so.* | libpthread.so.*) folder=libc ;;
        libGLEW.so.*) folder=lib ;;
        libstdc++.so.* | libgcc_s.so.* | libz.so.* | liblzma.so.* | \
            libGL*.so.* | libEGL.so.* | libOpenGL.so.* | libX* | libxcb* | libICE* | libSM* | \
            libbsd* | libmd.so.* | libuuid* | libexpat.so.* | libzstd.so.* | libffi.so.* | libdrm* | \
            libwayland*) folder=lib-if-missing ;;
        *) folder=lib ;;
    esac
    [ ! -e "$file" ] || cp -L "$file" "$bundle/$folder/$name"
done <"$work/libraries"
cp -L /lib64/ld-linux-x86-64.so.2 "$bundle/libc/"
strip --strip-unneeded "$bundle"/bin/* "$bundle"/lib/* "$bundle"/lib-if-missing/*

# From 9.4 on, VTK finds EGL by itself.
screen=needed
case "$(echo "$bundle"/lib/libvtkRenderingOpenGL2-9.*)" in
    *OpenGL2-9.[0-3].*) ;;
    *) screen= ;;
esac
sed -e "s/@SIZE@/${size[*]}/" -e "s/@SCREEN@/$screen/" Utilities/CardCheck/run.sh.in >"$bundle/run.sh"
chmod +x "$bundle/run.sh"
tar -C "$work" -caf "$archive" softshadows-gpu
echo "$archive: $(du -m "$archive" | cut -f 1) MiB"
