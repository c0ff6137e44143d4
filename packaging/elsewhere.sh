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
exec 9>"$folder/$release.lock"
flock -n 9 || { say "another call uses ${root#"$PWD"/}"; exit 1; }
sources=$folder/$release.sources
if ! git ls-files -z --cached --others --exclude-standard >"$sources"; then
    say "expected a git checkout, whose files are copied; see git's message above"
    exit 1
fi

trap 'unmount_proc "$root" || say "$root/proc is still in use"' EXIT
trap 'exit 130' INT
trap 'exit 143' TERM
if [ ! -e "$root/made" ]; then
    say "making a bare $release in ${root#"$PWD"/}"
    unmount_proc "$root" # of a call that was killed
    rm -rf --one-file-system "$root"
    make_bare_debian "$release" "$root" "$folder/debootstrap.log" || { say "the root was not made: ${folder#"$PWD"/}/debootstrap.log"; exit 1; }
    touch "$root/made"
fi
mount_proc "$root"
copy_network "$root"
chroot "$root" dpkg --configure -a >"$folder/dpkg.log" 2>&1 || # after a call that was killed
    { say "the root's packages are damaged: remove ${root#"$PWD"/} to start again; see ${folder#"$PWD"/}/dpkg.log"; exit 1; }

# The sources replace those of the last call; what was built from them stays. What has changed is newer than that.
checkout=$root/home/texplorer
copy=$root/home/sources
rm -rf "$copy"
mkdir -p "$checkout" "$copy"
tar --null -T "$sources" --ignore-failed-read -c | tar -x -C "$copy"
rsync -rlp --checksum --delete --exclude=/build "$copy/" "$checkout/"
rm -rf "$copy"
say "./dev $* in $release"
environment=()
for name in http_proxy https_proxy no_proxy CI; do
    if [ -n "${!name:-}" ]; then environment+=("$name=${!name}"); fi
done
chroot "$root" env -i PATH=/usr/sbin:/usr/bin:/sbin:/bin HOME=/root LC_ALL=C.UTF-8 "${environment[@]}" \
    TEXPLORER_PROOF_SEED="${TEXPLORER_PROOF_SEED:-$(git rev-parse --short HEAD)}" /home/texplorer/dev "$@"
