// How many samples a linear search takes: more for grazing views, which cross more of the map (Policarpo, Oliveira, Comba 2005, section 3).
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: MIT

// Where sample i of so many lies. Not a running sum, and the last without a division: either might miss the floor.
float stepAt(Ray ray, int i, int steps)
{
    return i < steps ? ray.end * (float(i) / float(steps)) : ray.end;
}

// Written so that equal limits give exactly that many.
int stepsFor(Ray ray)
{
    return int(ceil(float(maxSteps) + float(minSteps - maxSteps) * ray.cosView));
}
