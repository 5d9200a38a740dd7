"""The engines' formulas in numpy.  uv: v down.  V: unit vector to the eye in the frame
(+u, +v, surface normal).  o: the options of webengine.py.  (Names of the engines' own
files in each function; their texts are not copied here.)"""
# SPDX-FileCopyrightText: The Relievo authors
# SPDX-License-Identifier: GPL-3.0-or-later
import numpy as np


def geometry(shot, o):
    """Per pixel: uv on the plane, V, inside."""
    p, y = np.radians(shot["pitch"]), np.radians(shot["yaw"])
    eye = o.distance * np.array([np.cos(p) * np.sin(y), np.sin(p), np.cos(p) * np.cos(y)])
    back = eye / np.linalg.norm(eye)
    right = np.cross([0, 1, 0], back)
    right /= np.linalg.norm(right)
    basis = np.stack([right, np.cross(back, right), back], -1)
    n = o.size
    x = ((np.arange(n) + 0.5) / n * 2 - 1) * np.tan(np.radians(o.fov) / 2)
    ray = np.stack([np.broadcast_to(x, (n, n)), np.broadcast_to(-x[:, None], (n, n)), np.full((n, n), -1.0)], -1) @ basis.T
    with np.errstate(divide="ignore", invalid="ignore"):
        s = -eye[1] / ray[..., 1]
    hit = eye + s[..., None] * ray
    uv = hit[..., [0, 2]] + 0.5
    v = eye - hit
    v /= np.linalg.norm(v, axis=-1, keepdims=True)
    inside = (s > 0) & np.all((uv > 0) & (uv < 1), -1)
    return uv, np.stack([v[..., 0], v[..., 2], v[..., 1]], -1), inside


def sampler(data):
    """Bilinear, repeating."""
    h, w = data.shape

    def sample(uv):
        x, y = uv[..., 0] * w - 0.5, uv[..., 1] * h - 0.5
        i, j = np.floor(x).astype(int), np.floor(y).astype(int)
        a, b = x - i, y - j
        i0, i1, j0, j1 = i % w, (i + 1) % w, j % h, (j + 1) % h
        return ((data[j0, i0] * (1 - a) + data[j0, i1] * a) * (1 - b)
                + (data[j1, i0] * (1 - a) + data[j1, i1] * a) * b)
    return sample


def mip_sampler(data, lod):
    """Trilinear at a given level per pixel (box-filtered levels)."""
    levels = [data]
    while min(levels[-1].shape) > 1:
        d = levels[-1]
        # Each level is kept as 8 bits.
        levels.append(np.round((d[::2, ::2] + d[1::2, ::2] + d[::2, 1::2] + d[1::2, 1::2]) / 4 * 255) / 255)
    at = [sampler(d) for d in levels]
    lod = np.clip(lod, 0, len(levels) - 1)
    low = np.floor(lod).astype(int)
    used = sorted(set(low.ravel()) | set(np.minimum(low.ravel() + 1, len(levels) - 1)))

    def sample(uv):
        out = np.zeros(uv.shape[:2])
        for k in used:
            w = np.maximum(1 - np.abs(lod - k), 0)
            if w.any():
                out += w * at[k](uv)
        return out
    return sample


def babylon_offset(uv, v, height, scale):
    """bumpFragmentFunctions: parallaxOffset.  Nothing is divided by V.z; h = 0 stays."""
    return uv + scale * v[..., :2] * height(uv)[..., None]


def babylon_occlusion(uv, v, height, scale, level):
    """bumpFragmentFunctions: parallaxOcclusion.  The code's dot(view, normal) is negative, so
    that n = 15 + 11 cos; the loop has 15 turns, so that the ray ends at 15 / n of the depth.
    level: the frame's normal is divided by bumpTexture.level in StandardMaterial."""
    z = v[..., 2] / level
    span = -v[..., :2] / z[..., None] * scale
    n = 15 + 11 * z / level
    at = np.zeros(uv.shape)
    last = at.copy()
    ray, last_h, going = np.ones(n.shape), np.ones(n.shape), np.ones(n.shape, bool)
    for _ in range(15):
        h = height(uv + at)
        hit = going & (h > ray)
        d1, d2 = h - ray, ray + 1 / n - last_h
        with np.errstate(divide="ignore", invalid="ignore"):
            r = (d1 / (d1 + d2))[..., None]
        at_hit = r * last + (1 - r) * at
        going &= ~hit
        last = np.where(going[..., None], at, last)
        at = np.where(hit[..., None], at_hit, np.where(going[..., None], at + span / n[..., None], at))
        ray = np.where(going, ray - 1 / n, ray)
        last_h = np.where(going, h, last_h)
    return uv + at


def playcanvas_offset(uv, v, height, scale, base):
    """chunks/standard/frag/parallax.js.  Nothing is divided by V.z."""
    return uv + (height(uv) - base)[..., None] * scale * v[..., :2]


def quad(x, axis):
    """dFdx (axis 1), dFdy (axis 0): differences within 2 x 2 pixels."""
    a = np.moveaxis(x, axis, 0)
    return np.moveaxis(np.repeat(a[1::2] - a[::2], 2, 0), 0, axis)


def playcanvas_occlusion(uv, v, data, scale, base, samples, mips):
    """chunks/standard/frag/parallax.js."""
    march = -scale * v[..., :2] / np.maximum(v[..., 2], 1e-4)[..., None]
    length = np.linalg.norm(march, axis=-1)
    span = march * np.minimum(1, 5 * scale / np.maximum(length, 1e-12))[..., None]
    size = np.array(data.shape[::-1])
    texels = uv * size
    dx, dy = quad(texels, 1), quad(texels, 0)
    rho = np.maximum((dx * dx).sum(-1), (dy * dy).sum(-1))
    lod = np.maximum(0, 0.5 * np.log2(np.maximum(rho, 1e-30)))
    height = mip_sampler(data, lod) if mips else sampler(data)
    walked = np.linalg.norm(span * size, axis=-1) / 2 ** lod
    fade = np.clip((walked - 1) / 2, 0, 1)
    steps = np.clip(walked / 2, 1, samples)
    entry = uv - span * (1 - base)
    ray = np.zeros(steps.shape)
    surface = 1 - height(entry)
    before = ray.copy()
    for i in range(int(np.ceil(samples))):
        go = (i < steps) & (ray < surface)
        if not go.any():
            break
        before = np.where(go, ray, before)
        ray = np.where(go, ray + 1 / steps, ray)
        surface = np.where(go, 1 - height(entry + span * ray[..., None]), surface)
    found = ray >= surface
    half = (ray - before) / 2
    hit = np.where(found, ray - half, ray)
    for _ in range(5):
        half = half / 2
        d = 1 - height(entry + span * hit[..., None])
        hit = np.where(found, hit + np.where(hit >= d, -half, half), hit)
    return uv + span * ((np.clip(hit, 0, 1) - (1 - base)) * fade)[..., None]


def three_relief(uv, v, height, depth):
    """three.mjs: RELIEF."""
    span = -depth * v[..., :2] / np.maximum(v[..., 2], 1e-4)[..., None]
    low, high, going = np.zeros(uv.shape[:2]), np.ones(uv.shape[:2]), np.ones(uv.shape[:2], bool)
    for i in range(1, 33):
        d = i / 32
        hit = going & (d >= 1 - height(uv + span * d))
        high = np.where(hit, d, high)
        going &= ~hit
        low = np.where(going, d, low)
    for _ in range(6):
        d = 0.5 * (low + high)
        hit = d >= 1 - height(uv + span * d[..., None])
        high, low = np.where(hit, d, high), np.where(hit, low, d)
    return uv + span * high[..., None]


def emulate(o, data, uv, v):
    if o.mode == "off":
        return uv
    at = sampler(data)
    if o.engine == "babylon":
        if o.mode == "offset":
            return babylon_offset(uv, v, at, o.scale)
        # The frame of tangents, and PBRMaterial's, do not hold the level.
        framed = o.material == "pbr" or (o.tangents and not o.unlit)
        return babylon_occlusion(uv, v, at, o.scale, 1 if framed else o.level)
    if o.engine == "playcanvas":
        if o.mode == "offset":
            return playcanvas_offset(uv, v, at, o.scale, o.base)
        return playcanvas_occlusion(uv, v, data, o.scale, o.base, o.samples, o.mips)
    return three_relief(uv, v, at, o.scale)


def displacement(picture, data, o):
    """three.js: the displaced positions on a grid against map.r * scale + bias along +Y."""
    n = o.segments
    g = np.arange(n + 1) / n
    uv = np.stack(np.broadcast_arrays(g[None, :], g[:, None]), -1)
    meant = sampler(data)(uv) * o.scale + o.bias
    inner = (slice(1, -1), slice(1, -1))
    seen = picture[inner][..., 3] > 0.5
    dy = np.abs(picture[..., 1] - meant)[inner][seen]
    dxz = np.abs(picture[..., [0, 2]] - (uv - 0.5))[inner][seen]
    return {"vertices": int(seen.sum()), "dy_median": float(np.median(dy)), "dy_p99": float(np.percentile(dy, 99)),
            "dy_max": float(dy.max()), "dxz_max": float(dxz.max()), "range": [float(picture[inner][seen][..., 1].min()), float(picture[inner][seen][..., 1].max())]}
