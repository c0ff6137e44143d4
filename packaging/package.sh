#!/usr/bin/env bash
# Makes the Debian packages and tries them: lintian, and, as root, a bare Debian in which they are installed, used and
# removed. ./dev package calls it.
#   package.sh [--twice] [--no-root]
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
. packaging/bare_debian.sh
source=$PWD
work=$(mktemp -d)
root=$work/root
chmod 755 "$work" # the users of the bare Debian pass through it
umask 022         # packages keep its permissions

say() { printf 'package: %s\n' "$*" >&2; }
complain() {
    say "$*"
    exit 1
}

clean() {
    if ! unmount_proc "$root"; then
        say "$root/proc can't be unmounted, so $work stays"
        return
    fi
    rm -rf --one-file-system "$work"
}
trap clean EXIT
trap 'exit 130' INT
trap 'exit 143' TERM

twice=no
bare=yes
for argument in "$@"; do
    case $argument in
        --twice) twice=yes ;;
        --no-root) bare=no ;;
        *) say "package takes --twice and --no-root, not \"$argument\""; exit 2 ;;
    esac
done

SOURCE_DATE_EPOCH=$(sed -n 's/^set(TEXPLORER_RELEASED \([0-9]*\)).*/\1/p' CMakeLists.txt)
version=$(sed -n 's/^project(texplorer VERSION \([0-9.]*\) .*/\1/p' CMakeLists.txt)
architecture=$(dpkg --print-architecture)
export SOURCE_DATE_EPOCH

# make FOLDER: builds the packages of the sources there into build/package/packages.
make() (
    cd "$1"
    cmake --preset package >/dev/null
    cmake --build --preset package >&2
    rm -rf build/package/packages
    cd build/package
    cpack -B "$PWD/packages" >"$PWD/cpack.log" 2>&1 || { cat "$PWD/cpack.log" >&2; complain "cpack failed"; }
    rm -rf packages/_CPack_Packages
)

make "$source"
packages=$source/build/package/packages
programs=$packages/texplorer_${version}_$architecture.deb
library=$packages/libtexplorer-dev_${version}_$architecture.deb
for package in "$programs" "$library"; do
    [ -f "$package" ] || complain "cpack made no $package"
done

say "lintian"
lintian --allow-root --fail-on error,warning "$programs" "$library" || complain "lintian finds something"

# Files that a package must not have.
dpkg-deb -x "$programs" "$work/unpacked"
dpkg-deb -x "$library" "$work/unpacked"
find "$work/unpacked" -type f -exec file {} + | sed -n 's/: *ELF .*//p' >"$work/elf"
[ -s "$work/elf" ] || complain "there is no program in the packages"
while read -r file; do
    if readelf -d "$file" | grep -qE 'R(UN)?PATH'; then complain "$file has an rpath"; fi
    if readelf -S "$file" | grep -qE '\.(debug_info|symtab)'; then complain "$file is not stripped"; fi
done <"$work/elf"
if grep -rlF "$source" "$work/unpacked"; then complain "these name the folder in which they were built"; fi

if [ $twice = yes ]; then
    say "the same once more, in another folder, time zone and language, without a compiler cache"
    again=$work/again/of/another/length
    mkdir -p "$again"
    git ls-files -z --cached --others --exclude-standard | tar --null -T - --ignore-failed-read -c | tar -x -C "$again"
    (
        export TZ=Asia/Tokyo LC_ALL=C.UTF-8 CCACHE_DISABLE=1
        make "$again"
    )
    for package in "$programs" "$library"; do
        cmp "$package" "$again/build/package/packages/${package##*/}" || complain "another build makes another ${package##*/}"
    done
    say "both builds have the same bytes"
fi

say "made $programs and ${library##*/}"
[ $bare = yes ] || exit 0
if [ "$(id -u)" -ne 0 ]; then
    say "not tried in a bare Debian: that needs root, for debootstrap and chroot (sudo ./dev package; --no-root does without)"
    exit 3
fi

release=$(. /etc/os-release && echo "$VERSION_CODENAME")
say "a bare $release"
make_bare_debian "$release" "$root" "$work/log" || complain "no bare Debian was made"
mount_proc "$root"

# inside COMMAND…: runs in the bare Debian, as an unprivileged user.
inside() { chroot --userspec=65534:65534 "$root" env -i PATH=/usr/bin:/bin HOME=/tmp/home LC_ALL=C.UTF-8 "$@"; }
apt_inside() {
    chroot "$root" env DEBIAN_FRONTEND=noninteractive LC_ALL=C.UTF-8 apt-get -qq -y \
        -o APT::Install-Recommends=false -o Dpkg::Use-Pty=0 "$@" >"$work/log" 2>&1 || { tail -20 "$work/log" >&2; return 1; }
}
listed() { # lists files, except caches and logs
    find "$root" -xdev -path "$root/proc" -prune -o -path "$root/tmp" -prune -o -path "$root/var/cache" -prune -o \
        -path "$root/var/log" -prune -o -path "$root/var/lib/dpkg" -prune -o -path "$root/var/lib/apt" -prune -o -print | sort
}

# First their dependencies and the tools of the library's users: then only the packages make a difference.
depends=$(for package in "$programs" "$library"; do dpkg-deb -f "$package" Depends; done | paste -sd,)
apt_inside update || complain "the bare Debian can't read its lists of packages"
apt_inside satisfy "$depends" || complain "their dependencies can't be installed: $depends"
apt_inside install cmake make g++ || complain "no compiler can be installed"
mkdir -p "$root/tmp/packages" "$root/tmp/home"
cp "$programs" "$library" "$root/tmp/packages"
cp -r tests/end_to_end/consumer "$root/tmp/consumer"
chmod -R a+rX "$root/tmp/packages" "$root/tmp/consumer"
chmod 1777 "$root/tmp" "$root/tmp/home"
listed >"$work/before"
apt_inside install "/tmp/packages/${programs##*/}" "/tmp/packages/${library##*/}" || complain "they can't be installed"
[ "$(chroot "$root" dpkg-query -W -f='${db:Status-Status}' texplorer)" = installed ] || complain "texplorer is not installed"

say "using them"
[ "$(inside texshot --version)" = "texshot $version" ] || complain "texshot says another version"
[ "$(inside texplorer --version)" = "texplorer $version" ] || complain "texplorer says another version"
for renderer in fixed shader reference; do
    inside texshot shot --renderer $renderer --size 64x64 -o "/tmp/home/$renderer.png" || complain "$renderer draws nothing"
done
inside texshot shot --ui --size 1280x800 -o /tmp/home/window.png || complain "the window can't be drawn"
if inside texshot --help | grep -q '^  drivers'; then
    inside texshot drivers >/dev/null || complain "texshot drivers fails"
fi
inside texshot check /usr/share/texplorer/scenes/teapot.json || complain "an installed scene is not in order"
inside texshot schema | cmp - "$root/usr/share/texplorer/scene.schema.json" || complain "another schema is installed"
inside bash -c '. /usr/share/bash-completion/completions/texshot
    COMP_WORDS=(texshot sho) COMP_CWORD=1; _texshot; [ "${COMPREPLY[*]}" = shot ]' || complain "bash completes nothing"
python3 - "$root/tmp/home" <<'EOF_PYTHON' || complain "the pictures are wrong"
import struct
import sys

for name, size in (("fixed", (64, 64)), ("shader", (64, 64)), ("reference", (64, 64)), ("window", (1280, 800))):
    with open(f"{sys.argv[1]}/{name}.png", "rb") as file:
        head = file.read(24)
    assert head[:8] == b"\x89PNG\r\n\x1a\n" and struct.unpack(">II", head[16:]) == size, name
EOF_PYTHON
inside cmake -S /tmp/consumer -B /tmp/home/consumer >"$work/log" 2>&1 || { cat "$work/log" >&2; complain "CMake doesn't find the library"; }
inside cmake --build /tmp/home/consumer >"$work/log" 2>&1 || { tail -20 "$work/log" >&2; complain "its user can't be built"; }
inside texshot compress /tmp/home/fixed.png /tmp/home/in.dds --format dxt1 --mips none
inside /tmp/home/consumer/consumer /tmp/home/in.dds /tmp/home/out.dds /tmp/home/out.png >"$work/log" || complain "its user fails"
grep -q "^$version, " "$work/log" || complain "its user says: $(cat "$work/log")"
inside sh -c 'c++ -std=c++20 /tmp/consumer/main.cpp -o /tmp/home/by_pkg_config $(pkg-config --static --cflags --libs texplorer)' ||
    complain "pkg-config doesn't lead to the library"

say "removing them"
apt_inside purge texplorer libtexplorer-dev || complain "they can't be removed"
listed >"$work/after"
diff "$work/before" "$work/after" >&2 || complain "that is not what was there before"
say "all is well: $packages"
