// SPDX-License-Identifier: MIT
#pragma once

#include "curve/curve.h"
#include "recover/recover.h"
#include "refine/refine.h"
#include "sizing/size_field.h"

#include <cmath>
#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace tessera::test
{

struct UniformSize: SizeField
{
    explicit UniformSize(double h)
        : h_(h)
    {}
    double size(Vec2) const override { return h_; }
    double uniformSize() const override { return h_; }
    double gradientBound() const override { return 0.0; }

private:
    double h_;
};

/// h = h0 + g × distance to the segment a-b, at most hMax.
struct SegmentSize: SizeField
{
    SegmentSize(Vec2 a, Vec2 b, double h0, double g, double hMax)
        : a_(a)
        , b_(b)
        , h0_(h0)
        , g_(g)
        , hMax_(hMax)
    {}
    double size(Vec2 p) const override
    {
        const Vec2 along = b_ - a_;
        const double l2 = squaredLength(along);
        const double s = l2 > 0.0 ? std::clamp(dot(p - a_, along) / l2, 0.0, 1.0) : 0.0;
        return std::min(hMax_, h0_ + g_ * std::sqrt(squaredLength(p - a_ - s * along)));
    }
    double gradientBound() const override { return g_; }

private:
    Vec2 a_, b_;
    double h0_, g_, hMax_;
};

struct CircleCurve: Curve
{
    CircleCurve(Vec2 center, double radius)
        : center_(center)
        , radius_(radius)
    {}
    double first() const override { return 0.0; }
    double last() const override { return 2.0 * M_PI; }
    Vec2 point(double t) const override
    {
        return center_ + Vec2 {radius_ * std::cos(t), radius_ * std::sin(t)};
    }
    Vec2 derivative(double t) const override
    {
        return {-radius_ * std::sin(t), radius_ * std::cos(t)};
    }
    Vec2 secondDerivative(double t) const override
    {
        return {-radius_ * std::cos(t), -radius_ * std::sin(t)};
    }
    double radius() const { return radius_; }
    Vec2 center() const { return center_; }

private:
    Vec2 center_;
    double radius_;
};

/// A domain under construction: sampled boundary loops (even-odd) and constraint lines.
class Domain
{
public:
    struct Edge
    {
        std::uint32_t a, b;
        const Curve* geometry;
        double ta, tb;
        bool boundary;
    };

    std::vector<Vec2> points;
    std::vector<Edge> edges;
    std::vector<std::shared_ptr<const Curve>> curves;

    /// Straight loop, each side divided by the size field; nullptr: not divided.
    void addPolygon(const std::vector<Vec2>& corners, const SizeField* size);
    void addLine(Vec2 a, Vec2 b, const SizeField* size);
    void addCircle(Vec2 center, double radius, const SizeField& size);
    void addCircle(Vec2 center, double radius, int pieces);

    /// Unit square with five round holes and four inner lines.
    static Domain plate(const SizeField& size);
    /// Star polygon with holes and lines, reproducible from the seed. No holes touch.
    static Domain randomStar(unsigned seed, const SizeField& size);

    WorkingMesh build() const;

private:
    void addChain(std::uint32_t a, std::uint32_t b, const SizeField* size, bool boundary);
    std::uint32_t addPoint(Vec2 p);
};

struct Figures
{
    std::size_t triangles = 0;
    double area = 0.0;
    double minAngle = 180.0;
    double angleP01 = 0.0;
    double meanQuality = 0.0;
    double minQuality = 1.0;
    double p05 = 0.0, p95 = 0.0; ///< edge length / size
};

Figures measure(const WorkingMesh& mesh, const SizeField& size);

/// Everything that has to hold of a WorkingMesh beside verify(): records and bits agree, every
/// record of an original edge is a chain from its start to its end with monotone parameters, split
/// vertices lie on their curves, no vertex at infinity is kept. One sentence a problem.
std::vector<std::string> checkWorkingMesh(const WorkingMesh& mesh, const WorkingMesh& original);

} // namespace tessera::test
