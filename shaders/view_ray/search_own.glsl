// In prisms the technique searches.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: MIT
Hit searchInPrism(Ray ray)
{
    return trace(ray);
}
