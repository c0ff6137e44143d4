#!/usr/bin/env bash
# Installs into a new prefix, moves it, and uses the programs and the library from there.
set -euo pipefail
build=$1 source=$2 compiler=$3 python=$4 version=$5
work=$build/installed # always the same path, for the compiler cache
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

# Each header can be included alone and needs nothing that is not installed.
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

# The consumer project, found by CMake and by pkg-config, must agree with Pillow.
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

# The C++ and CMake blocks of the documents, unchanged: one project, its programs, its tests.
mkdir -p "$work/documents/golden"
"$python" - "$source" "$work/documents" <<'EOF'
import re
import sys
from pathlib import Path

root, folder = Path(sys.argv[1]), Path(sys.argv[2])
files = [root / "README.md", root / "CONTRIBUTING.md", *(root / "docs").rglob("*.md")]
blocks = [each for file in files for each in re.findall(r"^ *```(cpp|cmake)\n(.*?)^ *```", file.read_text(), re.M | re.S)]


def block(language, word):
    [found] = [each for each in blocks if each[0] == language and word in each[1]]
    blocks.remove(found)
    return found[1]


(folder / "mine.cpp").write_text(block("cpp", "drawReference("))
(folder / "short.cpp").write_text(block("cpp", "auto brick"))
(folder / "start.cpp").write_text(block("cpp", "TEST("))
(folder / "framebuffer.cpp").write_text("""#include <GL/gl.h>
#include <cstdlib>
void glReadPixels(GLint, GLint, GLsizei width, GLsizei height, GLenum, GLenum, void* pixels) {
    const char* blue = std::getenv("BLUE");
    for (int i = 0; i < width * height; ++i)
        for (int c = 0; c < 4; ++c)
            static_cast<unsigned char*>(pixels)[4 * i + c] = c == 3 ? 255 : c == 2 && blue ? 90 : i % 200;
}
""")
(folder / "CMakeLists.txt").write_text("""cmake_minimum_required(VERSION 3.25)
project(documents CXX)
set(CMAKE_CXX_STANDARD 20)
enable_testing()
add_executable(mine mine.cpp)
""" + block("cmake", "target_link_libraries(mine") + """
add_executable(short short.cpp)
target_link_libraries(short PRIVATE texplorer::core)
find_package(GTest REQUIRED)
add_executable(start start.cpp framebuffer.cpp)
target_link_libraries(start PRIVATE texplorer::core GTest::gtest_main)
""" + block("cmake", "texplorer_add_screenshot_test"))
assert not blocks, f"a block that isn't tried: {blocks}"
EOF
cp "$work/in.dds" "$work/documents/brick.dds"
"$prefix/bin/texshot" scene --example cube -o "$work/documents/brick.json"
"$prefix/bin/texshot" shot "$work/documents/brick.json" --size 320x240 -o "$work/documents/golden/brick.png"
cmake -S "$work/documents" -B "$work/documents/build" -DCMAKE_PREFIX_PATH="$prefix" -DCMAKE_CXX_COMPILER="$compiler" >/dev/null
cmake --build "$work/documents/build" >/dev/null
ctest --test-dir "$work/documents/build" -R brick >"$work/said" || complain "docs/suites.md, screenshot test: $(cat "$work/said")"
grep -q '100% tests passed, 0 tests failed out of 1' "$work/said" || complain "docs/suites.md has no screenshot test"
flipped() { # LEVELS: flipped.dds has so many, and is brick.dds upside down
    "$python" - "$work/documents" "$1" <<'EOF'
import struct
import sys
from PIL import Image

folder, levels = sys.argv[1:]
brick = Image.open(f"{folder}/brick.dds").convert("RGB").transpose(Image.Transpose.FLIP_TOP_BOTTOM)
assert Image.open(f"{folder}/flipped.dds").convert("RGB").tobytes() == brick.tobytes(), "it isn't flipped"
with open(f"{folder}/flipped.dds", "rb") as file:
    assert max(1, struct.unpack_from("<I", file.read(), 28)[0]) == int(levels), "it has other mip levels"
EOF
}
(cd "$work/documents" && ./build/short) || complain "the program of README.md fails"
flipped 1 || complain "the program of README.md is wrong"
[ "$(cd "$work/documents" && ./build/mine 2>&1)" = "640 x 480" ] || complain "the program of docs/library.md says something else"
flipped 7 || complain "the program of docs/library.md is wrong"
start() { # STATUS, in an environment: the framebuffer's test of docs/suites.md
    local status=0
    (cd "$work/documents" && ./build/start) >"$work/said" 2>&1 || status=$?
    [ $status = "$1" ] || complain "the test of docs/suites.md ended with $status: $(cat "$work/said")"
}
start 1
TEXPLORER_UPDATE_GOLDENS=1 start 0
start 0
BLUE=1 start 1
for picture in actual expected difference; do
    [ -e "$work/documents/start-$picture.png" ] || complain "the test of docs/suites.md leaves no start-$picture.png"
done

# Its screenshot tests. One golden is right only with the mask, another shows another time, and one is missing.
goldens=$work/consumer/goldens
scene=$source/tests/end_to_end/consumer/scene.json
mkdir "$goldens"
"$prefix/bin/texshot" shot "$scene" --renderer shader --size 64x48 --time 0.5 --set view.azimuth=30 -o "$goldens/drawn.png"
"$prefix/bin/texshot" shot "$scene" --size 64x48 --time 0.5 -o "$goldens/different.png"
"$python" - "$goldens" <<'EOF'
import sys
from PIL import Image

golden = Image.open(f"{sys.argv[1]}/drawn.png").convert("RGB")
golden.paste((255, 0, 255), (0, 0, 10, 48))
golden.save(f"{sys.argv[1]}/alike.png")
mask = Image.new("L", golden.size, 255)
mask.paste(0, (0, 0, 10, 48))
mask.save(f"{sys.argv[1]}/mask.png")
EOF
screenshots() { # STATUS, of ctest
    local status=0
    ctest --test-dir "$work/consumer" -R '^screenshot' --output-on-failure &>"$work/said" || status=$?
    [ $status = "$1" ] || complain "ctest ended with $status: $(cat "$work/said")"
}
left() { find "$work/consumer" -name 'screenshot*.png' -printf '%P\n' | sort | tr '\n' ' '; }
screenshots 8
for said in 'screenshot.different (Failed)' 'screenshot.missing (Failed)' '50% tests passed, 2 tests failed out of 4' \
    ' of 3072 pixels (' "there is no golden $goldens/new/missing.png" \
    "TEXPLORER_UPDATE_GOLDENS=1 ctest --test-dir '$work/consumer' -R '^screenshot\.missing\$'" \
    "actual:  $work/consumer/screenshot.different-actual.png" \
    "difference:  $work/consumer/screenshot.different-difference.png"; do
    grep -qF "$said" "$work/said" || complain "ctest doesn't say \"$said\": $(cat "$work/said")"
done
[ "$(left)" = "screenshot.different-actual.png screenshot.different-difference.png screenshot.missing-actual.png " ] ||
    complain "these were left: $(left)"
[ ! -e "$goldens/new" ] || complain "a golden was written without a request"
cp "$goldens/alike.png" "$work/kept.png"
TEXPLORER_UPDATE_GOLDENS=1 screenshots 0
cmp "$goldens/alike.png" "$work/kept.png" || complain "a golden that is right was written"
"$prefix/bin/texshot" shot "$scene" --no-metadata -o "$work/missing.png"
cmp "$goldens/new/missing.png" "$work/missing.png" || complain "another golden was written"
TEXPLORER_UPDATE_GOLDENS=0 screenshots 0
[ -z "$(left)" ] || complain "these were left by tests that passed: $(left)"
[ "$(ctest --test-dir "$work/consumer" -N -L slow | grep -c 'Test *#')" = 1 ] || complain "a label is missing"

# A project without a compiler. A wrong word is reported before a golden is written; a golden that is not a picture is
# replaced.
mkdir "$work/none"
none() { # STATUS WORDS
    printf '%s\n' 'cmake_minimum_required(VERSION 3.25)' 'project(none NONE)' \
        'find_package(texplorer REQUIRED COMPONENTS programs)' 'enable_testing()' \
        "texplorer_add_screenshot_test(NAME none SCENE \"$scene\" GOLDEN golden.png SIZE 16x16 $2)" >"$work/none/CMakeLists.txt"
    cmake -S "$work/none" -B "$work/none/build" -DCMAKE_PREFIX_PATH="$prefix" >"$work/said" 2>&1 ||
        complain "CMake wants more than the programs: $(cat "$work/said")"
    local status=0
    ctest --test-dir "$work/none/build" --output-on-failure &>"$work/said" || status=$?
    [ $status = "$1" ] || complain "ctest ended with $status: $(cat "$work/said")"
}
export TEXPLORER_UPDATE_GOLDENS=1
none 8 "TOLERANCE many"
grep -q -e '--tolerance' "$work/said" || complain "the wrong tolerance isn't named: $(cat "$work/said")"
[ ! -e "$work/none/golden.png" ] || complain "a golden was written despite a wrong tolerance"
echo 'version https://git-lfs.github.com/spec/v1' >"$work/none/golden.png"
none 0 "METRIC flip PIXELS_PER_DEGREE 30"
export TEXPLORER_UPDATE_GOLDENS=0
none 0 "RGB SET view.azimuth=24"
none 8 "SET view.azimuth=90 view.elevation=50"
unset TEXPLORER_UPDATE_GOLDENS

# Its framebuffer; Pillow makes the golden: red increases to the right, green upwards.
"$python" - "$goldens/framebuffer.png" <<'EOF'
import sys
from PIL import Image

golden = Image.new("RGBA", (5, 4))
golden.putdata([(x * 50, y * 60, 7, 255) for y in (3, 2, 1, 0) for x in range(5)])
golden.save(sys.argv[1])
EOF
framebuffer() { # STATUS of its tests, which run in their build folder and write there
    local status=0
    (cd "$work/consumer" && ./framebuffer_test --gtest_filter='*.IsTheGolden') >"$work/said" || status=$?
    [ $status = "$1" ] || complain "the framebuffer's test ended with $status: $(cat "$work/said")"
}
ctest --test-dir "$work/consumer" -R '^framebuffer$' --output-on-failure >"$work/said" || complain "$(cat "$work/said")"
grep -q '100% tests passed, 0 tests failed out of 1' "$work/said" || complain "the framebuffer is not tested: $(cat "$work/said")"
mv "$goldens/framebuffer.png" "$work/framebuffer.png"
framebuffer 1
grep -q "there is no golden" "$work/said" || complain "a missing golden: $(cat "$work/said")"
TEXPLORER_UPDATE_GOLDENS=1 framebuffer 0
[ "$(identify -format '%#' "$goldens/framebuffer.png")" = "$(identify -format '%#' "$work/framebuffer.png")" ] ||
    complain "the framebuffer's golden is not as Pillow makes it"
convert "$goldens/framebuffer.png" -negate "PNG32:$goldens/framebuffer.png"
framebuffer 1
for picture in actual expected difference; do
    grep -qF "$picture: " "$work/said" || complain "no word of its $picture picture: $(cat "$work/said")"
    [ "$(identify -format '%wx%h' "$work/consumer/framebuffer-$picture.png")" = 5x4 ] || complain "there is no $picture picture"
done

# Wrong calls, and an installation without the program: CMake must report them.
refused() { # SENTENCE ARGUMENTS
    echo "include(\"$(echo "$prefix"/lib*/cmake/texplorer)/TexplorerScreenshotTest.cmake\")
texplorer_add_screenshot_test($2)" >"$work/wrong.cmake"
    ! cmake -P "$work/wrong.cmake" >"$work/said" 2>&1 || complain "CMake accepts $2"
    tr -s ' \n' ' ' <"$work/said" | grep -qF "$1" || complain "CMake says of $2: $(cat "$work/said")"
}
good="NAME a SCENE a.json GOLDEN a.png"
refused "(a): SCENE is missing" "NAME a GOLDEN a.png"
refused "(a): GOLDEN is missing" "NAME a SCENE a.json"
refused "(): NAME is missing" "SCENE a.json GOLDEN a.png"
refused 'or LABELS, found "THRESHOLD"' "$good THRESHOLD 3"
refused 'SET: expected path=value, found "azimuth"' "$good SET azimuth"
refused 'TIMEOUT: expected seconds, found "long"' "$good TIMEOUT long"
refused 'found "b.json"' "NAME a SCENE a.json b.json GOLDEN a.png"
refused "(a): SIZE has no value" "$good SIZE"
refused "NAME names files" "NAME ../a SCENE a.json GOLDEN a.png"
refused 'expected a file .png without braces in its name, found "a.jpg"' "NAME a SCENE a.json GOLDEN a.jpg"
refused 'expected a file .png without braces in its name, found "{time}.png"' "NAME a SCENE a.json GOLDEN {time}.png"
refused "has no texshot" "$good"
mv "$prefix/bin/texshot" "$work/texshot"
! cmake -S "$source/tests/end_to_end/consumer" -B "$work/without" -DCMAKE_PREFIX_PATH="$prefix" \
    -DCMAKE_CXX_COMPILER="$compiler" >"$work/said" 2>&1 || complain "CMake finds a texshot that is not installed"
grep -q "has no texshot" "$work/said" || complain "CMake says: $(cat "$work/said")"
mv "$work/texshot" "$prefix/bin/texshot"

# The generated files, where man, the shells and editors look for them.
for file in share/man/man1/{texplorer,texshot,texshot-shot}.1.gz share/bash-completion/completions/{texplorer,texshot} \
    share/zsh/site-functions/{_texplorer,_texshot} share/fish/vendor_completions.d/{texplorer,texshot}.fish \
    share/texplorer/{scene,suite}.schema.json share/texplorer/suites/textures.suite.json \
    share/doc/texplorer/examples/cluster/texshot-{array.sbatch,job.yaml} \
    share/doc/texplorer/{README,docs/texshot,docs/library}.md \
    share/doc/texplorer/examples/consumer/CMakeLists.txt share/mime/packages/texplorer.xml share/metainfo/org.texplorer.Texplorer.metainfo.xml; do
    [ -s "$prefix/$file" ] || complain "$file is not installed"
done
gzip -dc "$prefix/share/man/man1/texshot-shot.1.gz" | grep -q '^\.TH TEXSHOT' || complain "a manual page is none"
"$prefix/bin/texshot" schema | cmp - "$prefix/share/texplorer/scene.schema.json" || complain "another schema is installed"
"$prefix/bin/texshot" schema --suites | cmp - "$prefix/share/texplorer/suite.schema.json" ||
    complain "another schema of suites is installed"
"$prefix/bin/texshot" test --list "$prefix/share/texplorer/suites/textures.suite.json" >"$work/said" ||
    complain "the installed suite can't be read: $(cat "$work/said")"

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
