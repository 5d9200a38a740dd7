#!/usr/bin/env bash
# House rule: everything is formatted by .clang-format, and each file tells its license on a line of its own.
# SPDX-FileCopyrightText: The Relievo authors
# SPDX-License-Identifier: GPL-3.0-or-later
cd "${1:?the source folder}" || exit 2
find app core render tests -name '*.h' -o -name '*.cpp' | xargs clang-format --dry-run --Werror || exit
! find app core render shaders tests -name '*.h' -o -name '*.cpp' -o -name '*.glsl' | xargs grep -L '^// SPDX-License-Identifier: ' | grep .
