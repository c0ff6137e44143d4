# shellcheck shell=bash
# What ./dev package, elsewhere and web share: the mirror, and a minimal Debian in a folder, which needs root. To be sourced.

# debian_mirror [ARCHIVE]: where this machine gets the packages of its release, or of an archive such as bookworm-security.
# Other releases, of another name, are there too.
debian_mirror() {
    local mirror archive
    archive=${1:-$(. /etc/os-release && echo "$VERSION_CODENAME")}
    mirror=$(apt-get indextargets --format '$(CODENAME) $(COMPONENT) $(CREATED_BY) $(REPO_URI)' |
        sed -n "s/^$archive main Packages //p" | head -1)
    if [ -z "$mirror" ]; then
        echo "apt has no mirror of main packages of $archive" >&2
        return 1
    fi
    echo "$mirror"
}

# make_bare_debian RELEASE FOLDER LOG: debootstrap from this machine's mirror; 1 and the end of LOG on stderr if it fails.
make_bare_debian() {
    local release=$1 root=$2 log=$3 mirror
    mirror=$(debian_mirror) || return
    if ! debootstrap --variant=minbase "$release" "$root" "$mirror" >"$log" 2>&1; then
        tail -5 "$log" >&2
        return 1
    fi
    copy_network "$root"
}

# copy_network FOLDER: names of hosts and proxies as this machine has them now.
copy_network() {
    cp /etc/hosts /etc/resolv.conf "$1/etc/"
    cp /etc/apt/apt.conf.d/*proxy* "$1/etc/apt/apt.conf.d/" 2>/dev/null || true
}

mount_proc() { mountpoint -q "$1/proc" || mount -t proc proc "$1/proc"; }

# unmount_proc FOLDER: returns 1 if it is still in use.
unmount_proc() { ! mountpoint -q "$1/proc" || umount "$1/proc"; }
