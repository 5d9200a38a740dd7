// The technique reads no heights.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: MIT
void startSearch(float footprint)
{
}
