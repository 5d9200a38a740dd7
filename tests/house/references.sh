#!/usr/bin/env bash
# House rule: every file, folder and heading that a comment or a page names is in the repository.
# A file is named by its path from the root or from shaders, from the citing file's folder, or by the end of its path that no other has.
# SPDX-FileCopyrightText: The Relievo authors
# SPDX-License-Identifier: GPL-3.0-or-later
cd "${1:?the source folder}" || exit 2
files=$(mktemp)
trap 'rm -f "$files"' EXIT
git ls-files --cached --others --exclude-standard >"$files" 2>/dev/null
[ -s "$files" ] || find . -type f -not -path './build/*' -not -path '*/node_modules/*' | sed 's|^\./||' >"$files"
mapfile -t read < <(grep -E '\.(h|cpp|glsl|js|md|sh|cmake|py|yml)$|(^|/)CMakeLists\.txt$|^packaging/(run|test)$|^\.ci/run$' "$files" | sort)
awk -v list="$files" '
function folderOf(path) { return match(path, /.*\//) ? substr(path, 1, RLENGTH) : "" }
function normal(path) {
    while (match(path, /[^\/]+\/\.\.\//))
        path = substr(path, 1, RSTART - 1) substr(path, RSTART + RLENGTH)
    gsub(/\.\//, "", path)
    return path
}
# The path of the file or folder that `name` means, or "".
function found(name) {
    if (name in known)
        return name
    if (("shaders/" name) in known)
        return "shaders/" name
    if (normal(folderOf(FILENAME) name) in known)
        return normal(folderOf(FILENAME) name)
    return ends[name] == 1 ? whole[name] : ""
}
function complain(what) {
    printf "%s:%d: %s\n", FILENAME, FNR, what
    failed = 1
}
BEGIN {
    while ((getline path < list) > 0) {
        known[path] = 1
        for (rest = path; match(rest, /\//);) {
            rest = substr(rest, RSTART + 1)
            ends[rest]++
            whole[rest] = path
        }
        for (folder = path; match(folder, /\/[^\/]*$/);)
            known[folder = substr(folder, 1, RSTART - 1)] = 1
        if (path ~ /\.md$/)
            while ((getline line < path) > 0)
                if (sub(/^#+ +/, "", line))
                    heading[path, line] = 1
    }
}
FILENAME ~ /\.md$/ { text = $0 }
FILENAME ~ /\.(h|cpp|glsl|js)$/ { # after the first // that stands in no string
    text = match($0, /^([^"\/]|"([^"\\]|\\.)*"|\/[^\/])*\/\//) ? substr($0, RLENGTH + 1) : ""
}
FILENAME !~ /\.(md|h|cpp|glsl|js)$/ { text = match($0, /(^|[ \t])#/) ? substr($0, RSTART + RLENGTH) : "" }
text == "" { next }
{
    rest = text
    while (match(rest, /[A-Za-z0-9_.\/-]*[A-Za-z0-9_]\.(md|glsl|h|cpp|sh|cmake|py|js)/)) {
        name = substr(rest, RSTART, RLENGTH)
        before = substr(rest, 1, RSTART - 1)
        rest = substr(rest, RSTART + RLENGTH)
        if (rest ~ /^[A-Za-z0-9_]/ || name ~ /\/\// || before ~ /<$/) # .html, an address, <a header of the system>
            continue
        if (name ~ /^(NAME|KEY)\./ || name == "Babylon.js" || name == "three.js") # of any name, a program that is called so
            continue
        path = found(name)
        if (path == "")
            complain(name (ends[name] > 1 ? " could be several files: name its folder" : " is not in the repository"))
        else if (match(rest, /^, "[^"]+"/) && name ~ /\.md$/ && !((path, substr(rest, 4, RLENGTH - 4)) in heading))
            complain(path " has no heading " substr(rest, 3, RLENGTH - 2))
    }
    rest = " " text
    while (match(rest, /[^A-Za-z0-9_\/.-](app|core|render|shaders|resources|tests|packaging)\/[A-Za-z0-9_.\/-]*/)) {
        name = substr(rest, RSTART + 1, RLENGTH - 1)
        rest = substr(rest, RSTART + RLENGTH)
        sub(/[.\/-]+$/, "", name)
        if (!(name in known) && !((name ".h") in known) && found(name) == "" && name !~ /\.(md|glsl|h|cpp|sh|cmake|py|js)$/)
            complain(name " is not in the repository")
    }
}
FILENAME ~ /\.md$/ {
    rest = text
    while (match(rest, /\]\([^)#]+/)) {
        name = substr(rest, RSTART + 2, RLENGTH - 2)
        rest = substr(rest, RSTART + RLENGTH)
        if (name !~ /^https?:/ && !(normal(folderOf(FILENAME) name) in known))
            complain("the link to " name " leads nowhere")
    }
}
END { exit failed }
' "${read[@]}"
