#!/usr/bin/env bash
# Makes what the page is built with for WebAssembly, in build/wasm32/root: a C library, libc++ with exceptions, the libraries
# that core and the panels link, and the headers of those that are headers alone; and the page's system and the licences of
# all of these. What is fetched has a fixed version and a checksum;
# the compiler and the headers are Debian's packages. Only this script fetches anything, and only when it has changed.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
. packaging/bare_debian.sh

# npm packages: name, version and SHA-256. The first holds a compiler, of which its C library is taken: Debian's has no
# <pthread.h>. The second is the system that a page gives to a program, the third shows the example of slides.
npm_packages=(
    "@yowasp/clang 22.0.0-git20542-10 6230ea1afa9691fa065935cf68c01642ff9b31c183fe8ac64cdfda025df06009"
    "@bjorn3/browser_wasi_shim 0.4.2 9c0281520d0e99f027ec7c1c79b4036c0f8168ed9bf98aba19db4737a1333782"
    "reveal.js 6.0.2 2f0c20bfb02447a198a1ebe8a8c097a5437d035caa38f2820bf4ba887a3eac91"
)
# Source packages of Debian 12, with the SHA-256 of their .dsc, which has those of the other files.
sources=(
    "freetype=2.12.1+dfsg-5+deb12u4 eead829b4bc79107e8e79c4da006110dffe264f9d48b3ba02f76cf7e84b64389"
    "giflib=5.2.1-2.5+deb12u1 5206a92fd4a057768f429033a3a80bc1e06453f6c60dfec243d8188fa6ade3f4"
    "imgui=1.86+ds-1 a8023a69501688316566ecd615fe98ecc53b11d305205a6636593f7066bdb7c3"
    "libdeflate=1.14-1 1f82791c5ac5623ed110e09cc991471deebfe4c419414392d1242e122c6f4c19"
    "libjpeg-turbo=1:2.1.5-2 d718ead0dfbcbc8523665c02a7f7152e31039ded641d022868722623bb3b486d"
    "libpng1.6=1.6.39-2+deb12u5 7b86211030a34deb6b0a2cd7e1d9db0fe92443fd30cab537fb89b1e7f7c9f188"
    "libsquish=1.15-3 4bb0642f92b18ec35ec596f638fe5887820041b16e4c27feefe5c6a374701645"
    "libwebp=1.2.4-0.2+deb12u1 d9ed0b59e2010f255c28d0869fd15b31f9b08aed757bfc91862d43aa9ec1aa99"
    "zlib=1:1.2.13.dfsg-1 3fa1e6b2fc525062aa88207dda52fed8e045373c809d362fe8a2bfbf7cf515a8"
)
# The C++ library, of the compiler's own source package: its version and the SHA-256 of its .orig.tar.xz. Debian's package of
# it has neither exceptions nor files. Later releases have the package, too, which may be gone from one of them.
llvm=(llvm-toolchain-22 22.1.8 b49b9277aef97616320b2da259e1f8174c65b0ce2fbe2e8629644a97693402fe)
header_packages=(libglm-dev libexpected-dev libfmt-dev nlohmann-json3-dev libstb-dev libxxhash-dev
    libtinyobjloader-dev)
copied_packages=(wasi-libc fonts-dejavu-core fonts-droid-fallback) # their licences: of the same C library, and of fonts

say() { printf 'web: %s\n' "$*" >&2; }

folder=$PWD/build/wasm32
root=$folder/root
include=$root/include/wasm32-wasip1
lib=$root/lib/wasm32-wasip1
toolchain=$PWD/cmake/WebAssembly.cmake
log=$folder/log
version=$(cat "${BASH_SOURCE[0]}" "$toolchain" | sha256sum)
if [ "$(cat "$folder/made" 2>/dev/null)" = "$version" ]; then exit 0; fi
mkdir -p "$folder"
exec 9>"$folder/lock"
flock -n 9 || { say "another call makes build/wasm32"; exit 1; }
say "making the C++ library and the others for WebAssembly, which takes some minutes; log: build/wasm32/log"
rm -rf "$root" "$folder/sources" "$folder/made"
mkdir -p "$root" "$folder/sources" "$folder/apt/lists/partial"
exec 3>&2 >"$log" 2>&1
trap '[ $? = 0 ] || { tail -5 "$log" >&3; say "build/wasm32 was not made; see build/wasm32/log" 2>&3; }' EXIT

check() { # check FILE SHA256
    [ "$(sha256sum <"$1")" = "$2  -" ] && return
    say "expected the SHA-256 $2 of ${1#"$PWD/"}, found $(sha256sum <"$1")" 2>&3
    exit 1
}

fetch() {
    local apt=(-o Dir::Etc::SourceList="$folder/apt/sources.list" -o Dir::Etc::SourceParts=/dev/null
        -o Dir::State::Lists="$folder/apt/lists" -o APT::Sandbox::User=root) source dsc_hash version
    printf 'deb-src %s main\n' "$(debian_mirror) bookworm" "$(debian_mirror) forky" \
        "$(debian_mirror bookworm-security) bookworm-security" >"$folder/apt/sources.list"
    apt-get "${apt[@]}" update
    cd "$folder/sources"
    for source in "${sources[@]}"; do
        read -r source dsc_hash <<<"$source"
        apt-get "${apt[@]}" source --download-only --only-source "$source"
        check "${source%%=*}_${source##*[=:]}.dsc" "$dsc_hash"
    done
    for version in $(apt-cache "${apt[@]}" showsrc "${llvm[0]}" | sed -n "s/^Version: \(.*:${llvm[1]}-.*\)/\1/p"); do
        ! apt-get "${apt[@]}" source --tar-only --only-source "${llvm[0]}=$version" || break
    done
    check "${llvm[0]}_${llvm[1]}.orig.tar.xz" "${llvm[2]}"
    local name number hash
    for name in "${npm_packages[@]}"; do
        read -r name number hash <<<"$name"
        npm pack --silent "$name@$number"
        name=${name#@}
        check "${name/\//-}-$number.tgz" "$hash"
    done
}

unpack() {
    local dsc
    for dsc in *.dsc; do dpkg-source --no-check -x "$dsc" "${dsc%%_*}"; done
    mkdir llvm # of a gigabyte, these
    tar -xf "${llvm[0]}"_*.orig.tar.xz -C llvm --strip-components=1 --wildcards --exclude='*/test/*' '*/libcxx/*' \
        '*/libcxxabi/*' '*/libunwind/*' '*/libc/*' '*/runtimes/*' '*/cmake/*' '*/llvm-lit/*'
    tar -xOf yowasp-clang-*.tgz package/gen/llvm-resources.tar | tar -x -C "$root" include/wasm32-wasip1 lib/wasm32-wasip1
    rm "$lib"/libc++*
    mkdir -p "$root/share/wasi" "$root/share/reveal"
    tar -xf bjorn3-browser_wasi_shim-*.tgz -C "$root/share/wasi" --strip-components=2 --wildcards 'package/dist/*.js'
    tar -xf reveal.js-*.tgz -C "$root/share/reveal" --transform='s|.*/||' \
        package/dist/{reveal.mjs,reset.css,reveal.css,theme/serif.css}
}

make_cmake() { # make_cmake NAME SOURCES OPTION…: built with CMake and installed into the root
    cmake -G Ninja -S "$2" -B "$1-build" -DCMAKE_BUILD_TYPE=Release -DCMAKE_TOOLCHAIN_FILE="$toolchain" \
        -DCMAKE_INSTALL_PREFIX="$root" -DCMAKE_C_COMPILER_LAUNCHER=ccache -DCMAKE_CXX_COMPILER_LAUNCHER=ccache "${@:3}"
    cmake --build "$1-build" --target install
}

compile() { # compile COMPILER FILE FLAG…: FILE.o, with the toolchain's flags
    ccache "$1" --target=wasm32-wasip1 --sysroot="$root" -DNDEBUG "${flags[@]}" "${@:3}" -c "$2" -o "$2.o"
}

make_library() { # make_library NAME COMPILER FLAG… -- FILE…: it fails if one of them is not compiled
    local name=$1 compiler=$2 options=() started=0 file
    shift 2
    while [ "$1" != -- ]; do options+=("$1") && shift; done
    shift
    for file in "$@"; do
        compile "$compiler" "$file" "${options[@]}" &
        ((++started % $(nproc))) || wait
    done
    wait
    llvm-ar-22 rcs "$lib/lib$name.a" "${@/%/.o}"
}

write_pc() { # write_pc NAME LIBRARY [FLAG]
    mkdir -p "$root/lib/pkgconfig"
    printf 'Name: %s\nDescription: %s\nVersion: 1\nLibs: -l%s\nCflags: %s\n' "$1" "$1" "$2" "${3:-}" \
        >"$root/lib/pkgconfig/$1.pc"
}

make_all() {
    local flags
    read -ra flags <<<"$(sed -n 's/^set(flags "\(.*\)").*/\1/p' "$toolchain")"
    # The runtime of exceptions: libunwind's file, and the tag that all exceptions of C++ share.
    printf '.globl __cpp_exception\n.tagtype __cpp_exception i32\n__cpp_exception:\n' >tag.s
    compile clang-22 tag.s -Wno-unused-command-line-argument
    compile clang-22 llvm/libunwind/src/Unwind-wasm.c -D_LIBUNWIND_HIDE_SYMBOLS -Illvm/libunwind/include
    # This C library is of musl's kind, but without copy_file_range.
    sed -i 's/ || _LIBCPP_HAS_MUSL_LIBC || defined(__FreeBSD__)//' llvm/libcxx/src/filesystem/operations.cpp
    make_cmake libcxx llvm/runtimes -DCMAKE_CXX_COMPILER_WORKS=ON -DUNIX=ON -DLLVM_INCLUDE_TESTS=OFF \
        '-DLLVM_ENABLE_RUNTIMES=libcxxabi;libcxx' -DLIBCXX_CXX_ABI=libcxxabi -DLIBCXXABI_USE_LLVM_UNWINDER=OFF \
        -DLIBCXX{,ABI}_ENABLE_SHARED=OFF -DLIBCXX_SHARED_OUTPUT_NAME=no -DLIBCXXABI_SHARED_OUTPUT_NAME=noabi -DLIBCXX{,ABI}_HAS_PTHREAD_API=ON -DLIBCXX{,ABI}_USE_COMPILER_RT=ON \
        -DLIBCXX{,ABI}_INSTALL_LIBRARY_DIR=lib/wasm32-wasip1 -DLIBCXX_HAS_MUSL_LIBC=ON \
        -DLIBCXX_INCLUDE_BENCHMARKS=OFF -DLIBCXX_INSTALL_MODULES=OFF
    llvm-ar-22 rs "$lib/libc++abi.a" tag.s.o llvm/libunwind/src/Unwind-wasm.c.o

    make_library z clang-22 -DHAVE_UNISTD_H -- zlib/*.c
    make_library deflate clang-22 -Ilibdeflate -- libdeflate/lib/*.c
    cp libpng1.6/scripts/pnglibconf.h.prebuilt libpng1.6/pnglibconf.h
    make_library png clang-22 -Izlib -- libpng1.6/png{,[!t]*,trans}.c
    make_library squish clang++-22 -- libsquish/*.cpp
    cp zlib/{zlib,zconf}.h libdeflate/libdeflate.h libpng1.6/{png,pngconf,pnglibconf}.h libsquish/squish.h "$include"
    make_cmake jpeg libjpeg-turbo -DENABLE_SHARED=OFF -DWITH_SIMD=OFF -DCMAKE_INSTALL_LIBDIR="$lib" \
        -DCMAKE_INSTALL_INCLUDEDIR="$include"
    make_library gif clang-22 -- giflib/{dgif_lib,egif_lib,gif_err,gif_hash,gifalloc,openbsd-reallocarray,quantize}.c
    make_library webp clang-22 -Ilibwebp -- libwebp/{sharpyuv,src/{dec,dsp,enc,utils}}/*.c
    make_library webpmux clang-22 -Ilibwebp -- libwebp/src/mux/*.c
    make_library imgui clang++-22 -- imgui/imgui{,_draw,_tables,_widgets}.cpp
    mkdir -p "$include/webp" "$root/include/imgui"
    cp giflib/gif_lib.h "$include"
    cp libwebp/src/webp/*.h "$include/webp"
    cp imgui/{imgui,imconfig,imgui_internal,imstb_textedit}.h "$root/include/imgui"
    make_cmake freetype-lib freetype -DFT_REQUIRE_ZLIB=ON -DFT_DISABLE_{BZIP2,PNG,HARFBUZZ,BROTLI}=ON -DCMAKE_INSTALL_LIBDIR="$lib" \
        -DCMAKE_INSTALL_INCLUDEDIR="$include"
    write_pc libdeflate deflate
    write_pc libwebp webp
    write_pc libwebpmux webpmux
    write_pc imgui imgui "-I$root/include/imgui"
    write_pc libturbojpeg turbojpeg

    dpkg -L "${header_packages[@]}" | grep -E '^/usr/(include|share/cmake)/' |
        tar -C / --no-recursion -T - -c | tar -x -C "$root" --strip-components=1
}

collect_licences() {
    local name
    mkdir -p "$root/share/licences"
    for name in *.dsc; do cp "${name%%_*}/debian/copyright" "$root/share/licences/${name%%_*}"; done
    cp llvm/libcxx/LICENSE.TXT "$root/share/licences/libc++"
    tar -xOf bjorn3-browser_wasi_shim-*.tgz package/LICENSE-MIT >"$root/share/licences/browser_wasi_shim"
    tar -xOf reveal.js-*.tgz package/LICENSE >"$root/share/licences/reveal.js"
    for name in "${header_packages[@]}" "${copied_packages[@]}"; do
        cp "/usr/share/doc/$name/copyright" "$root/share/licences/$name"
    done
}

fetch
unpack
make_all
collect_licences
rm -rf "$folder/sources" "$folder/apt"
printf '%s' "$version" >"$folder/made"
