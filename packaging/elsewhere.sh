#!/usr/bin/env bash
# Runs a command of ./dev in another release of Debian: in a root below build/elsewhere, with this checkout's sources.
#   elsewhere.sh RELEASE [COMMAND [ARG…]]      test unless given
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
. packaging/bare_debian.sh

say() { printf 'elsewhere: %s\n' "$*" >&2; }

release=${1:-}
if [[ ! $release =~ ^[a-z]+$ ]]; then
    say "expected the name of a Debian release, as in ./dev elsewhere trixie, found \"$release\""
    exit 2
fi
shift
[ $# -gt 0 ] || set -- test
if [ "$(id -u)" -ne 0 ]; then
    say "needs root, for debootstrap and chroot: sudo ./dev elsewhere $release $*"
    exit 1
fi

folder=$PWD/build/elsewhere
root=$folder/$release
mkdir -p "$folder"
if [ ! -e "$root/made" ]; then
    say "making a bare $release in ${root#"$PWD"/}"
    rm -rf --one-file-system "$root"
    make_bare_debian "$release" "$root" "$folder/debootstrap.log" || { say "debootstrap failed"; exit 1; }
    touch "$root/made"
fi
trap 'unmount_proc "$root" || say "$root/proc is still in use"' EXIT
trap 'exit 130' INT
trap 'exit 143' TERM
mount_proc "$root"

# The sources replace those of the last call; build results stay.
checkout=$root/home/texplorer
mkdir -p "$checkout"
find "$checkout" -mindepth 1 -maxdepth 1 ! -name build -exec rm -rf {} +
git ls-files -z --cached --others --exclude-standard | tar --null -T - --ignore-failed-read -c | tar -x -C "$checkout"
say "./dev $* in $release"
chroot "$root" env -i PATH=/usr/sbin:/usr/bin:/sbin:/bin HOME=/root LC_ALL=C.UTF-8 ${CI:+CI="$CI"} \
    TEXPLORER_PROOF_SEED="${TEXPLORER_PROOF_SEED:-1}" /home/texplorer/dev "$@"
