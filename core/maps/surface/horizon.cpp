// Horizons by upper hulls along scan lines.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/maps/surface/horizon.h"
#include "core/maps/float_image.h"
#include <algorithm>
#include <atomic>
#include <cmath>
#include <numbers>
#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

namespace relievo {

namespace {

// Scan lines of one azimuth. They run along the axis whose texel lines the direction crosses oftener; `k` counts texels along it, in the
// direction, and line `l` reaches the other coordinate l + k * shear there.
struct Scan {
    const HeightField& field;
    bool alongU, backward;
    double shear; // texels across per texel along
    double step; // tiles per texel along
    int length, width; // texels along and across
    // How far across every line has come at `k`: whole texels, and the share of one beyond, 0 where lines pass through texel centres.
    // Rounded once for all lines, so that each texel lies between the same two lines for whoever asks.
    struct Shift {
        int whole;
        float share; // in [0, 1]
    };
    std::vector<Shift> shifts; // of each k in [0, 2 length)

    Scan(const HeightField& f, double angle) : field(f)
    {
        const auto clean = [](double x) { return std::abs(x) < 1e-12 ? 0. : x; };
        const double u = clean(std::cos(angle)) * f.width(), v = clean(std::sin(angle)) * f.height(); // texels per tile
        alongU = std::abs(u) >= std::abs(v) * (1. - 1e-9);
        backward = (alongU ? u : v) < 0.;
        const double along = std::abs(alongU ? u : v);
        shear = (alongU ? v : u) / along;
        step = 1. / along;
        length = alongU ? f.width() : f.height();
        width = alongU ? f.height() : f.width();
        for (int k = 0; k < 2 * length; ++k)
            shifts.push_back(shiftOf(double(k) * shear));
    }
    static Shift shiftOf(double shift)
    {
        const double whole = std::floor(shift), share = shift - whole;
        if (share > 1. - 1e-9)
            return {int(whole) + 1, 0.f};
        return {int(whole), share < 1e-9 ? 0.f : float(share)};
    }
    float texel(int k, int across) const
    {
        const int along = backward ? length - 1 - k : k;
        return alongU ? field.texel(along, across) : field.texel(across, along);
    }
    std::size_t index(int k, int across) const
    {
        const int along = backward ? length - 1 - k : k;
        return alongU ? std::size_t(across) * std::size_t(field.width()) + std::size_t(along)
                      : std::size_t(along) * std::size_t(field.width()) + std::size_t(across);
    }
    bool repeats() const { return field.wrap() == Wrap::Repeat; }
    // Lines [first, last) pass by every texel. Those of a repeating field come back on the other side.
    int firstLine() const { return repeats() ? 0 : int(std::floor(std::min(0., -shear * length))) - 1; }
    int lastLine() const { return repeats() ? width : int(std::ceil(std::max(0., -shear * length))) + width + 1; }
    // Height of the surface where the line crosses the texels of `k`.
    float heightAt(int line, int k) const
    {
        const auto [whole, share] = shifts[std::size_t(k)];
        const float below = texel(k, line + whole);
        return share == 0.f ? below : below + share * (texel(k, line + whole + 1) - below);
    }
};

// The part of a scan line not yet passed, as its upper hull; nearest point last.
class Hull {
public:
    void clear() { m_points.clear(); }
    void push(double s, float h)
    {
        while (m_points.size() >= 2 && below(m_points[m_points.size() - 1], m_points[m_points.size() - 2], s, h))
            m_points.pop_back();
        m_points.push_back({s, double(h)});
    }
    // The greatest slope from (s, h) to the hull, which lies beyond s.
    double steepest(double s, double h) const
    {
        // Slopes from (s, h) rise and then fall along the hull: the tangent point is where they turn.
        std::size_t low = 0, high = m_points.size() - 1;
        while (low < high) {
            const std::size_t middle = (low + high) / 2;
            if (slope(m_points[middle], s, h) >= slope(m_points[middle + 1], s, h))
                high = middle;
            else
                low = middle + 1;
        }
        return slope(m_points[low], s, h);
    }

private:
    struct Point {
        double s, h;
    };
    static double slope(const Point& p, double s, double h) { return (p.h - h) / (p.s - s); }
    // Whether `middle`, between the new point and `far`, lies on or below their line.
    static bool below(const Point& middle, const Point& far, double s, float h)
    {
        return (middle.h - double(h)) * (far.s - s) <= (far.h - double(h)) * (middle.s - s);
    }
    std::vector<Point> m_points;
};

// Slopes (height per texel along) towards the horizon, of the scan lines just below and just above each texel where they pass it.
struct Slopes {
    std::vector<float> below, above;
};

void sweep(const Scan& scan, int line, Hull& hull, Slopes& slopes)
{
    hull.clear();
    for (int k = 2 * scan.length - 1; k >= 0; --k) {
        const float height = scan.heightAt(line, k);
        if (k < scan.length) {
            const float slope = float(hull.steepest(double(k), double(height)));
            const auto put = [&](int across, std::vector<float>& to) {
                const int texel = scan.repeats() ? wrapIndex(across, scan.width, Wrap::Repeat) : across;
                if (texel >= 0 && texel < scan.width)
                    to[scan.index(k, texel)] = slope;
            };
            const auto [whole, share] = scan.shifts[std::size_t(k)];
            put(line + whole + (share > 0.f ? 1 : 0), slopes.below);
            put(line + whole, slopes.above);
        }
        hull.push(double(k), height);
    }
}

} // namespace

std::vector<float> horizonSlopes(const HeightField& field, int index, int count, const Progress& progress)
{
    const Scan scan(field, 2. * std::numbers::pi * index / count);
    Slopes slopes{std::vector<float>(field.texels().size()), std::vector<float>(field.texels().size())};
    tbb::parallel_for(tbb::blocked_range<int>(scan.firstLine(), scan.lastLine(), 8), [&](const tbb::blocked_range<int>& lines) {
        Hull hull;
        for (int line = lines.begin(); line < lines.end() && !progress.cancelled(); ++line)
            sweep(scan, line, hull, slopes);
    });
    tbb::parallel_for(0, scan.width, [&](int across) {
        if (progress.cancelled())
            return;
        for (int k = 0; k < scan.length; ++k) {
            const float beyond = scan.shifts[std::size_t(k)].share; // of the line above the texel
            const float share = beyond > 0.f ? 1.f - beyond : 0.f; // of the texel beyond the line below it
            float& below = slopes.below[scan.index(k, across)];
            const float slope = below + share * (slopes.above[scan.index(k, across)] - below);
            below = std::max(0.f, slope / float(scan.step));
        }
    });
    return std::move(slopes.below);
}

namespace {
float sineOf(float tangent)
{
    return tangent / std::sqrt(1.f + tangent * tangent);
}

// stored: what is kept of a slope.
template <class Stored> BakedMap horizons(const HeightField& field, int count, const Progress& progress, const Stored& stored)
{
    BakedMap map = oneLevel(floatImage(field.width(), field.height() * count / 4, 4), count / 4);
    for (int index = 0; index < count && !progress.cancelled(); ++index) {
        const std::vector<float> slopes = horizonSlopes(field, index, count, progress);
        float* out = floats(map.levels[0]).data() + std::size_t(index / 4) * slopes.size() * 4 + std::size_t(index % 4);
        for (std::size_t i = 0; i < slopes.size(); ++i)
            out[4 * i] = stored(slopes[i]);
        progress.at(float(index + 1) / float(count));
    }
    return map;
}
BakedMap sines(const HeightField& field, float depth, int count, const Progress& progress)
{
    return horizons(field, count, progress, [depth](float slope) { return sineOf(depth * slope); });
}
BakedMap slopes(const HeightField& field, int count, const Progress& progress)
{
    return horizons(field, count, progress, [](float slope) { return slope / (slope + kHalfSlope); });
}
} // namespace

std::vector<float> horizonSines(const HeightField& field, float depthInTiles, int index, int count, const Progress& progress)
{
    std::vector<float> values = horizonSlopes(field, index, count, progress);
    for (float& value : values)
        value = sineOf(depthInTiles * value);
    return values;
}

BakedMap bakeHorizon8(const HeightField& field, const Parameters& parameters, const Progress& progress)
{
    return sines(field, parameters.depth, 8, progress);
}
BakedMap bakeHorizon16(const HeightField& field, const Parameters& parameters, const Progress& progress)
{
    return sines(field, parameters.depth, 16, progress);
}
BakedMap bakeHorizonSlopes8(const HeightField& field, const Parameters&, const Progress& progress)
{
    return slopes(field, 8, progress);
}
BakedMap bakeHorizonSlopes16(const HeightField& field, const Parameters&, const Progress& progress)
{
    return slopes(field, 16, progress);
}

BakedMap bakeAo(const HeightField& field, const Parameters& parameters, const Progress& progress)
{
    constexpr int kAzimuths = 16;
    BakedMap map = oneLevel(floatImage(field.width(), field.height(), 1));
    const auto out = floats(map.levels[0]);
    std::ranges::fill(out, 1.f);
    for (int index = 0; index < kAzimuths && !progress.cancelled(); ++index) {
        const std::vector<float> sines = horizonSines(field, parameters.depth, index, kAzimuths, progress);
        for (std::size_t i = 0; i < sines.size(); ++i)
            out[i] -= sines[i] * sines[i] / float(kAzimuths);
        progress.at(float(index + 1) / float(kAzimuths));
    }
    for (float& open : out)
        open = std::clamp(open, 0.f, 1.f);
    return map;
}

} // namespace relievo
