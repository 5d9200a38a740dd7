#!/usr/bin/env bash
# House rule: a function has at most 60 lines between its braces, a class with its members at most 300 in however many files, and a header
# with its source that hold one class alone at most 300. Tables are no classes. Braces stand where .clang-format puts them.
# SPDX-FileCopyrightText: The Relievo authors
# SPDX-License-Identifier: GPL-3.0-or-later
cd "${1:?the source folder}" || exit 2
# Headers first: a member belongs to the class of that name in its own file, else to the one in a header.
mapfile -t read < <(find app core render -name '*.h' | sort; find app core render -name '*.cpp' | sort)
awk '
function complain(where, what) {
    print where ": " what
    failed = 1
}
function keyOf(name) { return (FILENAME ":" name) in lines ? FILENAME ":" name : name in lines ? name : "" }
function count(class) {
    lines[class]++
    if (!((class, FILENAME) in isIn)) {
        isIn[class, FILENAME] = 1
        files[class] = files[class] " " FILENAME
        classes[FILENAME]++
    }
}
FNR == 1 {
    current = ""
    split("", opened)
}
{ whole[FILENAME]++ }

# A function opens with a brace alone on its line, and closes with the next one that stands as far in.
/^ *[{]$/ { opened[index($0, "{")] = FNR }
/^ *[}]$/ {
    column = index($0, "}")
    if (column in opened && FNR - opened[column] - 1 > 60)
        complain(FILENAME ":" opened[column], "a function of " FNR - opened[column] - 1 " lines, 60 are the most")
    delete opened[column]
}

current == "" && /^(template <[^>]*> )?(class|struct) [A-Za-z0-9_:]+[^;]*$/ {
    name = $0
    sub(/^.*(class|struct) /, "", name)
    match(name, /^[A-Za-z0-9_]+/)
    outer = substr(name, RSTART, RLENGTH)
    current = name ~ /^[A-Za-z0-9_]+::/ ? keyOf(outer) : FILENAME ~ /[.]h$/ ? outer : FILENAME ":" outer
    end = "^[}];"
}
current == "" && /^[A-Za-z]/ && match($0, /([A-Za-z0-9_]+::)+(~?[A-Za-z0-9_]+|operator[^(]+)[(]/) { # a member outside of its class
    n = split(substr($0, RSTART, RLENGTH), names, "::")
    for (i = 1; i < n && current == ""; ++i)
        current = keyOf(names[i])
    end = "^[}]|^[^ ].*;$|^ .*[)];$" # the last two: there is no body
}
current != "" {
    count(current)
    if ($0 == "{")
        end = "^[}]"
    if ($0 ~ end)
        current = ""
}

END {
    for (class in lines) {
        if (lines[class] > 300)
            complain(class, "a class of " lines[class] " lines in" files[class] ", 300 are the most")
        n = split(files[class], list, " ")
        total = alone = 0
        for (i = 1; i <= n; ++i) {
            total += whole[list[i]]
            alone += classes[list[i]] == 1
        }
        if (class !~ /:/ && alone == n && total > 300)
            complain(class, "has" files[class] " alone with " total " lines, 300 are the most")
    }
    exit failed
}
' "${read[@]}"
