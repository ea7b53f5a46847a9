# shellcheck shell=bash
# Shared by the commands `run` and `test`, which source it from the repository root: install what is missing, build.
# Everything said here goes to stderr, so that stdout stays with the caller.

say() { printf '\n== %s\n' "$*" >&2; }

stop() {
  local code=$1
  shift
  printf '%s\n' "$*" >&2
  exit "$code"
}

# The packages named in the lists that dpkg does not know as installed.
missing_packages() {
  local wanted installed
  wanted=$(grep -hv '^#' "$@" | sort -u)
  # shellcheck disable=SC2086  # one word per package is meant
  installed=$(dpkg-query -W -f='${Package} ${db:Status-Status}\n' $wanted 2>/dev/null |
    awk '$2 == "installed" { print $1 }' | sort -u)
  comm -23 <(printf '%s\n' "$wanted") <(printf '%s\n' "$installed")
}

# install_packages MAY_SUDO LIST...: as root by apt; else by sudo where allowed; else says the one line and stops with 3.
install_packages() {
  local may_sudo=$1 missing as_root=""
  shift
  missing=$(missing_packages "$@" | tr '\n' ' ')
  [ -n "$missing" ] || return 0
  if [ "$(id -u)" -ne 0 ]; then
    [ "$may_sudo" = yes ] || stop 3 "Some packages are missing. Install them, or repeat with --install to use sudo:
  sudo apt-get install --no-install-recommends $missing"
    as_root=sudo
  fi
  say "Installing: $missing"
  {
    $as_root apt-get update
    # shellcheck disable=SC2086  # one word per package is meant
    $as_root env DEBIAN_FRONTEND=noninteractive apt-get install -y --no-install-recommends $missing
  } >&2 || stop 3 "apt-get could not install: $missing"
}

# Configures the folder of a preset where it is new or the presets or sources are. HALLUX_TESTS=OFF leaves out the tests, which need
# packages of their own; a release folder that has them keeps them.
configure() {
  local preset=$1 folder="build/$1" options=()
  if [ "$preset" = release ]; then
    local tests=${HALLUX_TESTS:-ON}
    ! grep -qs '^HALLUX_TESTS:BOOL=ON$' "$folder/CMakeCache.txt" || tests=ON
    options=("-DHALLUX_TESTS=$tests")
    grep -qs "^HALLUX_TESTS:BOOL=$tests\$" "$folder/CMakeCache.txt" || rm -f "$folder/build.ninja"
  fi
  if [ ! -f "$folder/build.ninja" ] || [ CMakePresets.json -nt "$folder/build.ninja" ]; then
    cmake --preset "$preset" "${options[@]}"
  elif [ -n "$(find simulator scenarios database assessment ui tests -name '*.cpp' -newer "$folder/build.ninja" -print -quit)" ]; then
    cmake "$folder"  # groups of sources are chosen anew
  fi
}

# build PRESET [TARGET...]: configures where needed and builds, one build of a folder at a time.
build() {
  local preset=$1 folder="build/$1"
  shift
  mkdir -p "$folder"
  say "Building $preset${*:+: $*}"
  (
    flock 9
    configure "$preset"
    cmake --build --preset "$preset" --parallel "$(nproc)" ${1:+--target "$@"}
  ) 9>"$folder/.lock" >&2
}
