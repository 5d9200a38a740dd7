#!/usr/bin/env bash
# House rule: app -> render -> core; no Qt or OpenGL in core, no Qt in render, OpenImageIO only in core/imageio.
# SPDX-FileCopyrightText: The Relievo authors
# SPDX-License-Identifier: GPL-3.0-or-later
cd "${1:?the source folder}" || exit 2
failed=0
forbid() { # WHY, PATTERN, FOLDERS...
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
forbid 'core starts no threads of its own' 'std::(j?thread|async)\b' core/state core/image core/maps core/mesh core/shader_text core/trace core/analysis core/exporters
forbid 'core does not exit or print' '\b(std::exit|std::cout|std::cerr|std::puts|std::printf)\b' core/state core/image core/maps core/mesh core/shader_text core/trace core/analysis core/exporters
if found=$(grep -rln 'OpenImageIO/' app render core --include='*.h' --include='*.cpp' | grep -v '^core/imageio/'); then
    printf 'only core/imageio uses OpenImageIO:\n%s\n' "$found"
    failed=1
fi
if found=$(grep -rnE '^[[:space:]]*uniform ' shaders); then
    printf 'shaders declare no uniforms by hand:\n%s\n' "$found"
    failed=1
fi
for room in app/window/main_window.cpp app/window/viewport.cpp app/window/document.cpp render/renderer.cpp; do
    if [ "$(wc -l < "$room")" -gt 300 ]; then
        echo "$room is over 300 lines: a table or a value is missing"
        failed=1
    fi
done
wanted='CHANGELOG.md CMakeLists.txt CMakePresets.json LICENSE README.md app core packaging render resources shaders tests'
top=$(git ls-files 2>/dev/null | grep -v '^\.' | cut -d/ -f1 | sort -u | tr '\n' ' ' | sed 's/ $//')
if [ -n "$top" ] && [ "$top" != "$wanted" ]; then
    echo "the top level holds other things than it should: $top"
    failed=1
fi
exit $failed
