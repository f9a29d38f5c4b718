#!/usr/bin/env bash
# Makes the reference of the classes (HTML, by Doxygen); a warning is an error.
# Usage: api-docs.sh [folder]      (default: build/api-docs; the start page is html/index.html in it)
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/../.."
export SOFTSHADOWS_OUTPUT="${1:-build/api-docs}"
SOFTSHADOWS_VERSION="$(sed -nE 's/^#define SOFTSHADOWS_VERSION "(.*)"$/\1/p' Modules/Core/vtkSoftShadowsVersion.h)"
export SOFTSHADOWS_VERSION

mkdir -p "$SOFTSHADOWS_OUTPUT"
doxygen Documentation/Doxyfile
echo "$SOFTSHADOWS_OUTPUT/html/index.html"
