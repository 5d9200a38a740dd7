"""What the target `packed` tells of an exported material, and the rays that such a relief is searched along."""
# SPDX-FileCopyrightText: The Relievo authors
# SPDX-License-Identifier: GPL-3.0-or-later
import dataclasses
import re

import numpy as np


@dataclasses.dataclass
class Promised:
    depth: float  # m, black to white
    tiling: float
    offset: np.ndarray
    turn: float  # degrees
    midlevel: float  # height that lies on the mesh

    def placed(self, uv):
        """Where the plane's own UVs lie in the texture."""
        return uv @ self.matrix().T + self.offset

    def matrix(self):
        c, s = np.cos(np.radians(self.turn)), np.sin(np.radians(self.turn))
        return self.tiling * np.array([[c, -s], [s, c]])

    def rays(self, uv, eye):
        """u, v, du, dv, cosView of each pixel: uv on a plane of 1 m, the unit vector to the eye in (+u, +v, normal)."""
        return np.concatenate([self.placed(uv), (-eye[:, :2] / eye[:, 2:] * self.depth) @ self.matrix().T, eye[:, 2:]], -1)


def promised(folder):
    """Of the material in `folder`: its neighbour `packed` has the text."""
    text = next((folder.parent / "packed").glob("*_depth.txt")).read_text()
    number = r"(-?[0-9.]+)"
    depth = float(re.search(rf"white: {number} mm", text).group(1)) / 1000
    tiling, u, v, turn = (float(x) for x in re.search(rf"Tiling {number}, offset {number} {number}, turned by {number} degrees", text).groups())
    return Promised(depth, tiling, np.array([u, v]), turn, float(re.search(rf"height {number} lies", text).group(1)))
