#!/usr/bin/env bash
# Installs into a fresh prefix, builds the consumer against it and runs what was installed.
set -euo pipefail
build=$1 source=$2 compiler=$3
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

cmake --install "$build" --prefix "$work/prefix" >/dev/null

cmake -S "$source/tests/end_to_end/consumer" -B "$work/consumer" -DCMAKE_PREFIX_PATH="$work/prefix" \
    -DCMAKE_CXX_COMPILER="$compiler" >/dev/null
cmake --build "$work/consumer" >/dev/null
found=$("$work/consumer/consumer")
[ "$found" = "GL_NEAREST 2" ] || { echo "the consumer printed \"$found\", expected \"GL_NEAREST 2\""; exit 1; }

"$work/prefix/bin/texshot" shot --size 64x64 -o "$work/shot.png"
[ "$(identify -format '%wx%h' "$work/shot.png")" = 64x64 ] || { echo "the installed texshot drew no 64x64 PNG"; exit 1; }
"$work/prefix/bin/texplorer" --version | grep -q '^texplorer [0-9]' || { echo "the installed texplorer says no version"; exit 1; }
