# What the scripts of tests/clients share: sourced. Each function ends the script with 77 (skipped) when something is not there and cannot be installed.
# SPDX-FileCopyrightText: The Relievo authors
# SPDX-License-Identifier: GPL-3.0-or-later

# needs COMMAND_OR_PYTHON_MODULE... -- PACKAGE...: programs (or python:MODULE) that Debian's packages bring.
needs() {
  local missing=() thing
  while [ "$1" != -- ]; do
    thing=$1
    shift
    case $thing in
      python:*) /usr/bin/python3 -c "import ${thing#python:}" 2>/dev/null || missing+=("$thing") ;;
      *) command -v "$thing" >/dev/null || missing+=("$thing") ;;
    esac
  done
  shift
  [ ${#missing[@]} = 0 ] && return
  if [ "$(id -u)" != 0 ] || ! command -v apt-get >/dev/null || ! DEBIAN_FRONTEND=noninteractive apt-get install -y -qq --no-install-recommends "$@" >/dev/null 2>&1; then
    echo "skipped: ${missing[*]} not there, and $* could not be installed"
    exit 77
  fi
}

# npm_packages FOLDER PACKAGE@VERSION...: in FOLDER/node_modules, once.
npm_packages() {
  local folder=$1 package missing=
  shift
  if ! command -v npm >/dev/null || ! command -v node >/dev/null; then
    echo "skipped: npm is not installed"
    exit 77
  fi
  for package in "$@"; do
    [ -d "$folder/node_modules/${package%@*}" ] || missing=1
  done
  [ -z "$missing" ] && return
  mkdir -p "$folder"
  [ -f "$folder/package.json" ] || echo '{"private":true}' >"$folder/package.json"
  # No install scripts, and no peer dependencies (React).
  if ! (cd "$folder" && timeout 240 npm install --ignore-scripts --legacy-peer-deps --no-audit --no-fund --silent "$@") >"$folder/install.log" 2>&1; then
    echo "skipped: $* could not be installed, see $folder/install.log"
    exit 77
  fi
}
