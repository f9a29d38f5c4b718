#!/usr/bin/env bash
# Compiles every shader program that the library makes, VTK's with our parts included, as plain GLSL 1.50
# with Khronos' reference compiler, which forgives less than drivers do; and makes sure that no line of a
# shader was left out.
# Usage: check-shaders.sh [build folder]      (default: build/test; needs the tool and the tests)
#
# Mesa writes down the programs that it links (MESA_SHADER_CAPTURE_PATH) while techniques and tests run, with
# all extensions and as OpenGL 3.2. Every line of every .glsl file must be in one of them, behind all #if.
set -uo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/../.." || exit 1
. Utilities/Scripts/driver-settings.sh
build="$(realpath "${1:-build/test}")"
tool="$build/bin/softshadow"
command -v glslangValidator >/dev/null || { echo "glslangValidator is missing (Debian: glslang-tools)" >&2; exit 2; }
[ -x "$tool" ] || { echo "no such program: $tool" >&2; exit 2; }
[ -n "${DISPLAY:-}" ] || exec Utilities/Scripts/offscreen.sh "${BASH_SOURCE[0]}" "$build"

work="${SHADERS:-$(mktemp -d)}"
[ -n "${SHADERS:-}" ] || trap 'rm -rf "$work"' EXIT
export MESA_SHADER_CACHE_DISABLE=1 # what is read from a cache is not linked
failed=0
tests='Kinds/Strokes.*:FlatStrokes.*:DrawnDepth.*:MapperMarks.*:ShadowConservative.*:ShadowMapperCasters.*'

# capture <driver> <command> [argument...]: what a command links goes to a folder of its own.
runs=0
capture() {
    runs=$((runs + 1))
    export MESA_SHADER_CAPTURE_PATH="$work/$runs-$1"
    mkdir -p "$MESA_SHADER_CAPTURE_PATH"
    if ! with_driver "$@" >"$work/log" 2>&1; then
        echo "FAILED: $*"
        tail -n 20 "$work/log"
        failed=$((failed + 1))
    fi
}
render() { # <driver> <technique> [option...]
    local driver="$1" technique="$2"
    shift 2
    capture "$driver" "$tool" render Testing/Data/Scenes/drivers.json --technique "$technique" "$@" \
        --width 32 --height 24 -o "$work/picture.png"
}

for driver in llvmpipe-256 gl32; do
    for technique in $("$tool" --list-techniques | grep -oE '^[a-z][a-z0-9_-]*'); do
        case "$technique" in
            traced) render "$driver" traced ;;
            *) render "$driver" "$technique" --option map_size=64 ;;
        esac
    done
    render "$driver" cascaded --option filter=fixed --option tint=on --option map_size=64
    render "$driver" cascaded --option adaptive=on --option map_size=64
done
render llvmpipe-256 sbfs --option filter=full --option map_size=64
render llvmpipe-256 pcss --option smooth_terminator=on --option map_size=64 --converge 0.9 --converge-frames 200

# Strokes, imposters, moved depths, what no scene file has: the tests that draw them.
for program in vtkRenderingSoftShadowsBakingUnitTests SoftShadowsTechniqueTests; do
    if [ -x "$build/bin/$program" ]; then
        capture llvmpipe-256 "$build/bin/$program" --gtest_brief=1 "--gtest_filter=$tests"
    fi
done

Utilities/Scripts/validate-shaders.py "$work" || failed=$((failed + 1))
[ "$failed" -eq 0 ]
