#!/usr/bin/env bash
# House rule: everything is formatted by .clang-format.
# SPDX-FileCopyrightText: The Relievo authors
# SPDX-License-Identifier: GPL-3.0-or-later
cd "${1:?the source folder}" || exit 2
find app core render tests -name '*.h' -o -name '*.cpp' | xargs clang-format --dry-run --Werror
