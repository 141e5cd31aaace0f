# Sourced by the scripts that find browsers: installs Debian's packages where apt is at hand.

# install_packages NAME PACKAGE..: says so in one line that names what is installed as NAME; where it cannot be done, tells apt's last words and fails.
install_packages() {
  local name=$1 log as_root=()
  shift
  command -v apt-get > /dev/null || return 1
  [ "$(id -u)" = 0 ] || as_root=(sudo -n)
  echo "Robotran: installing $name from Debian's packages for the browser tests, once" >&2
  log=$(mktemp)
  if { "${as_root[@]}" apt-get update && "${as_root[@]}" env DEBIAN_FRONTEND=noninteractive apt-get install -y --no-install-recommends "$@"; } > "$log" 2>&1; then
    rm -f "$log"
    return 0
  fi
  tail -n 20 "$log" >&2
  rm -f "$log"
  return 1
}
