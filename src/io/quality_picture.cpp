// SPDX-License-Identifier: MIT
#include "io/quality_picture.h"

#include "io/drawing.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <numeric>
#include <span>
#include <vector>

namespace tessera
{

namespace
{

constexpr Color kWireColor {0.30, 0.36, 0.42};
constexpr Color kTextColor {0.10, 0.12, 0.16};
constexpr Color kRingColor {0.10, 0.10, 0.55};
constexpr Color kBarColor {0.45, 0.56, 0.70};
constexpr int kAngleBins = QualityReport::kAngleBins;
constexpr double kBinDegrees = 60.0 / kAngleBins;

/// Red over yellow to green.
Color colorOfBin(int bin)
{
    const double share = static_cast<double>(bin) / (kAngleBins - 1);
    return share < 0.5 ? Color {0.86, 0.18 + 1.24 * share, 0.16}
                       : Color {0.86 - 1.0 * (share - 0.5), 0.80, 0.16 + 0.5 * (share - 0.5)};
}

/// Bars beside the mesh, one below the other.
class Bars
{
public:
    Bars(Canvas& canvas, const Box2& panel, int rows)
        : canvas_(canvas)
        , panel_(panel)
        , height_((panel.max.y - panel.min.y) / rows)
    {}

    void title(const std::string& text) { canvas_.label(nextRow(), text, kTextColor); }

    void bar(const std::string& text, double share, Color color)
    {
        const Vec2 at = nextRow();
        const double width = panel_.max.x - panel_.min.x;
        const double left = panel_.min.x + 0.56 * width;
        const double right = left + 0.44 * width * share;
        canvas_.moveTo({left, at.y});
        canvas_.lineTo({right, at.y});
        canvas_.lineTo({right, at.y + 0.7 * height_});
        canvas_.lineTo({left, at.y + 0.7 * height_});
        canvas_.closePath();
        canvas_.fill(color);
        canvas_.label(at, text, kTextColor);
    }

private:
    Vec2 nextRow()
    {
        ++row_;
        return {panel_.min.x, panel_.max.y - row_ * height_};
    }

    Canvas& canvas_;
    Box2 panel_;
    double height_;
    int row_ = 0;
};

double largestShare(std::span<const std::size_t> counts, double all)
{
    return static_cast<double>(*std::max_element(counts.begin(), counts.end())) / all;
}

void drawHistograms(Canvas& canvas, const Box2& panel, const QualityReport& quality)
{
    const auto all = static_cast<double>(std::accumulate(
        quality.angleHistogram.begin(), quality.angleHistogram.end(), std::size_t {0}));
    constexpr int kQualityRows = QualityReport::kQualityBins / 2;
    Bars bars(canvas, panel, kAngleBins + kQualityRows + 2);
    bars.title("smallest angle");
    const double mostAngles = largestShare(quality.angleHistogram, all);
    for (int i = 0; i < kAngleBins; ++i) {
        const double share = static_cast<double>(quality.angleHistogram[i]) / all;
        bars.bar(fmt::format("{:.0f}..{:.0f}: {:.3g} %", kBinDegrees * i, kBinDegrees * (i + 1),
                             100.0 * share),
                 share / mostAngles, colorOfBin(i));
    }
    std::array<std::size_t, kQualityRows> merged {};
    for (int i = 0; i < QualityReport::kQualityBins; ++i) {
        merged[i / 2] += quality.qualityHistogram[i];
    }
    bars.title("quality");
    const double mostQualities = largestShare(merged, all);
    for (int i = 0; i < kQualityRows; ++i) {
        const double share = static_cast<double>(merged[i]) / all;
        bars.bar(fmt::format("{:.1f}..{:.1f}: {:.3g} %", 0.1 * i, 0.1 * (i + 1), 100.0 * share),
                 share / mostQualities, kBarColor);
    }
}

} // namespace

std::string drawQuality(const Mesh& mesh, const QualityReport& quality, PictureFormat format,
                        const std::string& caption)
{
    Box2 box;
    for (const auto& t : mesh.triangles) {
        for (const std::uint32_t v : t) {
            box.add(mesh.nodes[v]);
        }
    }
    const double extent = std::max(box.max.x - box.min.x, box.max.y - box.min.y);
    const double middle = 0.5 * (box.min.y + box.max.y);
    const Box2 panel {{box.max.x + 0.06 * extent, middle - 0.5 * extent},
                      {box.max.x + 0.56 * extent, middle + 0.5 * extent}};
    Box2 view = box;
    view.add(panel.min);
    view.add(panel.max);
    Canvas canvas(view, format, caption);

    DrawnTriangles triangles;
    triangles.points = mesh.nodes;
    triangles.corners = mesh.triangles;
    for (const auto& t : mesh.triangles) {
        const AngleRange angles
            = triangleAngles(mesh.nodes[t[0]], mesh.nodes[t[1]], mesh.nodes[t[2]]);
        const int bin = static_cast<int>(angles.smallest / kBinDegrees);
        triangles.classOf.push_back(static_cast<std::uint32_t>(std::clamp(bin, 0, kAngleBins - 1)));
    }
    std::vector<Color> colors;
    for (int i = 0; i < kAngleBins; ++i) {
        colors.push_back(colorOfBin(i));
    }
    const std::vector<DrawnEdge> sides = sidesOf(triangles);
    fillClasses(canvas, mesh.nodes, sides, colors);
    strokeEdges(canvas, mesh.nodes, sides, {kWireColor, 1.1, 14.0, 0.12});
    for (const QualityReport::Worst& worst : quality.worst) {
        canvas.ring(worst.place, 12.0, 3.0, kRingColor);
    }
    drawHistograms(canvas, panel, quality);
    return canvas.finish();
}

} // namespace tessera
