# Sourced by the scripts that find browsers and a display. Installs Debian packages if apt is available.

packages_updated=

# install_packages NAME PACKAGE..: announces NAME and installs it. On failure prints apt's last line.
install_packages() {
  local name=$1 log as_root=()
  shift
  command -v apt-get > /dev/null || return 1
  # If one package lookup failed, the others would, too.
  [ "$packages_updated" != failed ] || return 1
  [ "$(id -u)" = 0 ] || as_root=(sudo -n)
  echo "Robotran: installing $name from Debian's packages for the tests, once" >&2
  log=$(mktemp)
  if [ -z "$packages_updated" ]; then
    if "${as_root[@]}" apt-get update > "$log" 2>&1; then packages_updated=yes; else packages_updated=failed; fi
  fi
  if [ "$packages_updated" = yes ] \
    && "${as_root[@]}" env DEBIAN_FRONTEND=noninteractive apt-get install -y --no-install-recommends "$@" > "$log" 2>&1; then
    rm -f "$log"
    return 0
  fi
  echo "Robotran: $name cannot be installed: $(tail -n 1 "$log")" >&2
  rm -f "$log"
  return 1
}
