# Functions for tests in a Debian root of their own, made by debootstrap. Needs root rights. Source this file.
# shellcheck shell=bash

# debian_root SUITE FOLDER PACKAGE...: unpacks a fresh minimal root with these packages. A tar file in CACHE keeps it for the
# next test. The mirror is that of this machine's apt.
debian_root() {
    local suite=$1 folder=$2 cached mirror
    shift 2
    cached=$CACHE/$suite-$(printf '%s ' "$@" | md5sum | cut -c1-8).tar
    if [ ! -e "$cached" ]; then
        mirror=$(apt-get indextargets --format "\$(REPO_URI)" 'Created-By: Packages' 'Component: main' | head -n 1)
        mkdir -p "$CACHE"
        rm -rf "$folder"
        debootstrap --variant=minbase "$suite" "$folder" "$mirror" >"$CACHE/$suite.log" 2>&1 || { tail -n 20 "$CACHE/$suite.log"; return 1; }
        apt-config dump | grep '^Acquire::.*Proxy' >"$folder/etc/apt/apt.conf.d/proxy" || true
        cp -L /etc/resolv.conf "$folder/etc/resolv.conf"
        in_root "$folder" apt-get update -q >>"$CACHE/$suite.log" 2>&1
        in_root "$folder" apt-get install -y -q --no-install-recommends "$@" >>"$CACHE/$suite.log" 2>&1 || { tail -n 20 "$CACHE/$suite.log"; return 1; }
        in_root "$folder" apt-get clean
        tar -C "$folder" --one-file-system -cf "$cached.part" . && mv "$cached.part" "$cached"
    fi
    rm -rf "$folder"
    mkdir -p "$folder"
    tar -C "$folder" -xf "$cached"
}

# in_root FOLDER COMMAND...: runs a command in a root, with /proc and a private /dev/shm, and none of this environment.
in_root() {
    local folder=$1
    shift
    # shellcheck disable=SC2016
    unshare --mount --propagation private sh -c '
        mount -t proc proc "$0/proc" && mount -t tmpfs tmpfs "$0/dev/shm"
        exec env -i PATH=/usr/sbin:/usr/bin:/sbin:/bin HOME=/root LANG=C.UTF-8 DEBIAN_FRONTEND=noninteractive chroot "$0" "$@"' "$folder" "$@"
}

# check NAME COMMAND...: a command that has to succeed. Its output is shown if it fails.
check() {
    local name=$1 output
    shift
    if output=$("$@" 2>&1); then
        echo "ok: $name"
    else
        printf 'FAILED: %s\n%s\n' "$name" "$output"
        return 1
    fi
}
