// What the stored values of the acceleration map are multiplied by, at the level that is searched.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: MIT
vec4 boundScale()
{
    return boundScales[searchLevel()];
}
