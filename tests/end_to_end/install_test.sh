#!/usr/bin/env bash
# Installs into a fresh prefix, moves it, and uses it from there: the programs, and the library as other projects do.
set -euo pipefail
build=$1 source=$2 compiler=$3 python=$4 version=$5
work=$build/installed # always the same, so that a compiler cache knows what was compiled before
rm -rf "$work"
mkdir "$work"
trap 'rm -rf "$work"' EXIT

complain() {
    echo "$*"
    exit 1
}

cmake --install "$build" --prefix "$work/prefix" --strip >/dev/null
mv "$work/prefix" "$work/moved"
prefix=$work/moved
if grep -rlF -e "$source" -e "$build" "$prefix"/lib*/cmake "$prefix"/lib*/pkgconfig "$prefix/include"; then
    complain "these name the place where they were built or installed"
fi
! objdump -h "$prefix"/lib*/*.a "$prefix/bin/texshot" | grep -q debug_info || complain "--strip left debugging information"

# The headers: each can be included alone, and needs nothing that isn't installed.
include=$prefix/include
(cd "$include" && find texplorer -name '*.h' | sort) >"$work/headers"
! grep -rn '"core/' "$include" || complain "these lines are for inside the project"
! grep -rn '<fmt/' "$include" || complain "these lines need a library of which users know nothing"
while read -r header; do
    mkdir -p "$work/alone/$(dirname "$header")"
    echo "#include <$header>" >"$work/alone/$header.cpp"
done <"$work/headers"
[ "$(find "$work/alone" -name '*.cpp' | wc -l)" -ge 50 ] || complain "there are too few headers"
cache=$(command -v ccache || true)
find "$work/alone" -name '*.cpp' -print0 |
    xargs -0 -P 2 -I SOURCE $cache "$compiler" -std=c++20 -O0 -Wall -Wextra -Werror -I "$include" -c SOURCE -o SOURCE.o

# The consumer, found by CMake and by pkg-config, does what Pillow says that it does.
cmake -S "$source/tests/end_to_end/consumer" -B "$work/consumer" -DCMAKE_PREFIX_PATH="$prefix" \
    -DCMAKE_CXX_COMPILER="$compiler" >/dev/null
cmake --build "$work/consumer" >/dev/null
export PKG_CONFIG_PATH=$(dirname "$(find "$prefix" -name texplorer.pc)")
[ "$(pkg-config --modversion texplorer)" = "$version" ] || complain "pkg-config knows another version"
# shellcheck disable=SC2046 # words of a command line
"$compiler" -std=c++20 "$source/tests/end_to_end/consumer/main.cpp" -o "$work/by_pkg_config" \
    $(pkg-config --static --cflags --libs texplorer)

"$prefix/bin/texshot" shot --size 64x64 -o "$work/shot.png"
"$prefix/bin/texshot" compress "$work/shot.png" "$work/in.dds" --format dxt1 --mips none
for consumer in "$work/consumer/consumer" "$work/by_pkg_config"; do
    "$consumer" "$work/in.dds" "$work/out.dds" "$work/out.png" >"$work/said"
    "$python" - "$work" "$version" <<'EOF' || complain "$consumer is wrong"
import struct
import sys
from PIL import Image

work, version = sys.argv[1:]
flipped = Image.open(f"{work}/in.dds").convert("RGB").transpose(Image.Transpose.FLIP_TOP_BOTTOM)
assert Image.open(f"{work}/out.dds").convert("RGB").tobytes() == flipped.tobytes(), "the blocks are not turned around"
assert Image.open(f"{work}/out.png").convert("RGB").tobytes() == flipped.tobytes(), "the reference draws something else"
with open(f"{work}/out.dds", "rb") as file:
    levels = struct.unpack_from("<I", file.read(), 28)[0]
corner = "%d %d %d" % flipped.getpixel((0, 63))
with open(f"{work}/said") as file:
    said = file.read()
expected = f"{version}, levels {levels}, sample {corner}, probe {corner}\n"
assert levels == 7 and said == expected, f"expected {expected!r}, found {said!r}"
EOF
    rm "$work/out.dds" "$work/out.png"
done
if "$work/consumer/consumer" "$work/nowhere.dds" "$work/out.dds" "$work/out.png" 2>"$work/said"; then
    complain "a file that isn't there was read"
fi
grep -q "consumer: $work/nowhere.dds: " "$work/said" || complain "the error names no file: $(cat "$work/said")"

# What they write of themselves, where man, the shells and editors look for it.
for file in share/man/man1/{texplorer,texshot,texshot-shot}.1.gz share/bash-completion/completions/{texplorer,texshot} \
    share/zsh/site-functions/{_texplorer,_texshot} share/fish/vendor_completions.d/{texplorer,texshot}.fish \
    share/texplorer/scene.schema.json share/mime/packages/texplorer.xml share/metainfo/texplorer.metainfo.xml; do
    [ -s "$prefix/$file" ] || complain "$file is not installed"
done
gzip -dc "$prefix/share/man/man1/texshot-shot.1.gz" | grep -q '^\.TH TEXSHOT' || complain "a manual page is none"
"$prefix/bin/texshot" schema | cmp - "$prefix/share/texplorer/scene.schema.json" || complain "another schema is installed"

# The programs.
[ "$(identify -format '%wx%h' "$work/shot.png")" = 64x64 ] || complain "the installed texshot drew no 64x64 PNG"
for module in "$prefix"/lib/texplorer/texshot_*.so; do # one for each library of contexts
    context=$(basename "${module#*texshot_}" .so)
    "$prefix/bin/texshot" shot --context "$context" --size 64x64 -o "$work/$context.png"
    [ "$(identify -format '%#' "$work/$context.png")" = "$(identify -format '%#' "$work/shot.png")" ] ||
        complain "the installed texshot draws something else by $context"
done
"$prefix/bin/texplorer" --version | grep -qx "texplorer $version" || complain "the installed texplorer says another version"
shaders=$prefix/share/texplorer/shaders
"$prefix/bin/texshot" shot --renderer shader --size 64x64 -o "$work/built_in.png"
"$prefix/bin/texshot" shot --renderer shader --shaders "$shaders" --size 64x64 -o "$work/from_folder.png"
cmp "$work/built_in.png" "$work/from_folder.png" || complain "the installed shaders are not those that are built in"
