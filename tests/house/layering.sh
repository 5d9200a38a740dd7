#!/usr/bin/env bash
# House rule: app -> render -> core; no Qt or OpenGL in core, no Qt in render, OpenImageIO only in core/imageio.
# SPDX-FileCopyrightText: The Relievo authors
# SPDX-License-Identifier: GPL-3.0-or-later
cd "${1:?the source folder}" || exit 2
failed=0
forbid() { # WHY, PATTERN, FOLDERS and options of grep
    local why=$1 pattern=$2
    shift 2
    if found=$(grep -rnE "$pattern" "$@" --include='*.h' --include='*.cpp'); then
        printf '%s:\n%s\n' "$why" "$found"
        failed=1
    fi
}
forbid 'core uses no Qt' '#include *[<"]Q' core
forbid 'core uses no OpenGL' '#include *[<"](epoxy|GL|EGL)/' core
forbid 'core knows neither render nor app' '#include *"(render|app)/' core
forbid 'render uses no Qt' '#include *[<"]Q' render
forbid 'render does not know app' '#include *"app/' render
forbid 'the command line uses no Qt' '#include *[<"]Q' app/cli
forbid 'core starts no threads of its own' 'std::(j?thread|async)\b' core --exclude-dir=imageio
forbid 'core does not exit or print' '\b(std::exit|std::cout|std::cerr|std::puts|std::printf)\b' core --exclude-dir=imageio

# The storeys of core, ground first: a file includes its own storey and those below it. The image helper stands beside them.
storeys='ground state gltf image mesh maps shader_text trace object scene analysis exporters'
for folder in core/*/; do
    grep -qw "$(basename "$folder")" <<< "$storeys imageio" || { echo "$folder is no storey of core"; failed=1; }
done
above=$storeys
for storey in $storeys; do
    above=${above#"$storey"}
    above=${above# }
    [ -z "$above" ] || forbid "core/$storey knows nothing above it" "#include *\"core/(${above// /|})/" "core/$storey"
done
forbid 'the image helper knows ground and image only' '#include *"core/(state|gltf|mesh|maps|shader_text|trace|object|scene|analysis|exporters)/' core/imageio
if found=$(find core -maxdepth 1 -type f) && [ -n "$found" ]; then
    printf 'every file of core lies in a storey:\n%s\n' "$found"
    failed=1
fi
# A unit is a source with its header; folders show what belongs together.
while read -r folder; do
    [ "$folder" != shaders/techniques ] || continue # one file a row of the table
    units=$(find "$folder" -maxdepth 1 -type f | sed 's/\.[a-z]*$//' | sort -u | wc -l)
    if [ "$units" -gt 16 ]; then
        echo "$folder holds $units units: subfolders would show what belongs together"
        failed=1
    fi
done < <(find core app render shaders tests -type d)
if found=$(grep -rln 'OpenImageIO/' app render core --include='*.h' --include='*.cpp' | grep -v '^core/imageio/'); then
    printf 'only core/imageio uses OpenImageIO:\n%s\n' "$found"
    failed=1
fi
if found=$(grep -rnE '^[[:space:]]*uniform ' shaders); then
    printf 'shaders declare no uniforms by hand:\n%s\n' "$found"
    failed=1
fi
for room in app/window/main_window.cpp app/window/viewport/viewport.cpp app/window/document/document.cpp render/renderer.cpp; do
    if [ "$(wc -l < "$room")" -gt 300 ]; then
        echo "$room is over 300 lines: a table or a value is missing"
        failed=1
    fi
done
pages='README.md ARCHITECTURE.md CONTRIBUTING.md CHANGELOG.md LICENSE'
for name in $(git ls-files 2>/dev/null | grep -v '^\.' | cut -d/ -f1 | sort -u); do
    if ! grep -qw -- "$name" <<< "$pages CMakeLists.txt CMakePresets.json app core packaging render resources shaders tests"; then
        echo "the top level holds what it should not: $name"
        failed=1
    fi
done
exit $failed
