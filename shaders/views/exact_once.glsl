// The exact answer of a pixel, searched once however often it is asked for.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: MIT
Exact exactAnswer = Exact(false, 0.0f);
bool isExactKnown = false;

Exact exactOf(Surface surface)
{
    if (!isExactKnown)
        exactAnswer = exactAlong(surface);
    isExactKnown = true;
    return exactAnswer;
}
