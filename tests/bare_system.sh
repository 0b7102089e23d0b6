# Makes a bare Debian 12 in a folder (debootstrap) and works in it (chroot). Sourced by scripts that test what needs a fresh
# machine; they are in the project's root then. `included`: packages besides the bare system, comma separated.
# shellcheck shell=bash

say() { printf '\033[1m==> %s\033[0m\n' "$*"; }
die() { printf '%s: %s\n' "${0##*/}" "$*" >&2; exit 1; }

[ "$(id -u)" = 0 ] || die "needs root: it makes a Debian system in a folder and works in it (debootstrap, chroot)"
# Mounts are made in a name space of their own, with which they go, however this ends.
if [ "${1:-}" != --in-own-mounts ]; then exec unshare --mount --propagation private "$(readlink -f "$0")" --in-own-mounts; fi

place=$PWD
folder=${NETPOCKET_FRESH_DIR:-/var/tmp}
mkdir -p "$folder"
work=$(mktemp -d "$folder/netpocket-fresh-XXXXXX")
root=$work/system
mkdir "$root"
chmod 755 "$work" "$root"
mounted=()

clean_up() {
  local i
  for ((i = ${#mounted[@]} - 1; i >= 0; --i)); do umount --recursive --lazy "${mounted[i]}" || true; done
  if [ "${NETPOCKET_FRESH_KEEP:-0}" = 1 ]; then say "kept: $root"; else rm -rf --one-file-system "$work"; fi
}
trap clean_up EXIT
trap 'exit 130' INT
trap 'exit 143' TERM HUP

bring_in() {  # mount options, what, where in the new system
  mkdir -p "$root$3"
  # shellcheck disable=SC2086
  mount $1 "$2" "$root$3"
  mounted+=("$root$3")
}

inside() {  # KEY=VALUE... -- shell command
  local environment=()
  while [ "$1" != -- ]; do environment+=("$1"); shift; done
  shift
  chroot "$root" /usr/bin/env -i HOME=/root PATH=/usr/local/sbin:/usr/local/bin:/usr/sbin:/usr/bin:/sbin:/bin \
    TERM="${TERM:-dumb}" JOBS="${JOBS:-$(nproc)}" "${passed_on[@]}" "${environment[@]}" \
    bash -c "cd '$place' && $1"
}

# Packages come from where this machine has its own.
mirror=${NETPOCKET_FRESH_MIRROR:-$(apt-get indextargets --format '$(SITE) $(CODENAME) $(COMPONENT)' \
  'Created-By: Packages' | awk '$2 == "bookworm" && $3 == "main" { print $1; exit }')}
[ -n "$mirror" ] || die "this machine's apt has no source of Debian 12 (bookworm); name one: NETPOCKET_FRESH_MIRROR=URL"

passed_on=()
for name in http_proxy https_proxy no_proxy NETPOCKET_WERROR; do
  [ -z "${!name:-}" ] || passed_on+=("$name=${!name}")
done

say "making a bare Debian 12 in $root"
debootstrap --variant=minbase --include="${included:-ca-certificates}" bookworm "$root" "$mirror" >"$work/debootstrap.log" 2>&1 ||
  { tail -n 20 "$work/debootstrap.log" >&2; die "debootstrap failed"; }
if [ -z "${NETPOCKET_FRESH_MIRROR:-}" ]; then
  rm -f "$root/etc/apt/sources.list"
  for name in sources.list sources.list.d apt.conf.d auth.conf.d preferences.d trusted.gpg.d; do
    [ ! -e "/etc/apt/$name" ] || cp -a "/etc/apt/$name" "$root/etc/apt/"
  done
  [ ! -d /usr/share/keyrings ] || cp -a /usr/share/keyrings/. "$root/usr/share/keyrings/"
fi
cp -L /etc/resolv.conf /etc/hosts "$root/etc/"
bring_in "-t proc" proc /proc
bring_in "--rbind --make-rslave" /dev /dev
bring_in "-t tmpfs -o mode=1777" tmpfs /dev/shm
