# Sourced by run and test: installs the Debian packages that are missing, and builds a preset.
# SPDX-FileCopyrightText: The Relievo authors
# SPDX-License-Identifier: GPL-3.0-or-later

install_missing() {
    local missing=()
    for package in "$@"; do
        dpkg-query -W -f '${Status}' "$package" 2>/dev/null | grep -q 'ok installed' || missing+=("$package")
    done
    [ ${#missing[@]} -eq 0 ] && return
    local root=()
    [ "$(id -u)" -eq 0 ] || root=(sudo)
    echo "Installing: ${missing[*]}" >&2
    "${root[@]}" apt-get update -qq >&2
    DEBIAN_FRONTEND=noninteractive "${root[@]}" apt-get install -y -qq --no-install-recommends "${missing[@]}" >&2 && return
    echo "relievo: the packages above could not be installed. Install them by hand and start again." >&2
    exit 1
}

# build PRESET [TARGET...]: everything when no target is named; quiet unless something is wrong.
# Both commands configure alike, so that the second one compiles only what the first one did not.
build() {
    local preset=$1 log
    log=$(mktemp)
    shift
    echo "Building ($preset) ..." >&2
    if ! { cmake --preset "$preset" && cmake --build --preset "$preset" ${@:+--target "$@"}; } >"$log" 2>&1; then
        tail -n 60 "$log" >&2
        echo "relievo: the build failed; the whole log is $log" >&2
        exit 1
    fi
    rm -f "$log"
}
