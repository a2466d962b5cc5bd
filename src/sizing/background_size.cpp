// SPDX-License-Identifier: MIT
#include "sizing/background_size.h"

#include "arrange/box_tree.h"
#include "base/error.h"
#include "base/number_text.h"
#include "predicates/predicates.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>

namespace tessera
{

namespace
{

[[noreturn]] void refuse(const BackgroundMesh& mesh, const std::string& what,
                         std::vector<ErrorPlace> places = {})
{
    throw Error(ErrorKind::InvalidOption, mesh.name + ": " + what, std::move(places));
}

void requireValid(const BackgroundMesh& mesh)
{
    if (mesh.triangles.empty()) {
        refuse(mesh, "there are no triangles to take sizes from.");
    }
    if (mesh.sizes.size() != mesh.nodes.size()) {
        refuse(mesh, "there are " + std::to_string(mesh.sizes.size()) + " sizes for "
                   + std::to_string(mesh.nodes.size()) + " nodes; give one for each node.");
    }
    for (const auto& triangle : mesh.triangles) {
        for (const std::uint32_t node : triangle) {
            if (node >= mesh.nodes.size()) {
                refuse(mesh, "a triangle has a node " + std::to_string(node) + "; there are "
                           + std::to_string(mesh.nodes.size()) + ", counted from 0.");
            }
        }
    }
    for (std::size_t i = 0; i < mesh.nodes.size(); ++i) {
        const Vec2 p = mesh.nodes[i];
        const double h = mesh.sizes[i];
        if (!isFinite(p) || !(h > 0.0) || !std::isfinite(h)) {
            refuse(mesh,
                   "the size at node " + std::to_string(i) + ", at " + placeText(p) + ", is "
                       + numberText(h) + "; it must be a number above 0.",
                   {{p}});
        }
    }
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
        const auto& v = mesh.triangles[t];
        const Vec2 p = mesh.nodes[v[0]];
        if (orient2d(p, mesh.nodes[v[1]], mesh.nodes[v[2]]) == 0) {
            refuse(mesh,
                   "triangle " + std::to_string(t) + ", counted from 0, at " + placeText(p)
                       + " has no area; leave it out.",
                   {{p}});
        }
    }
}

class Interpolation
{
public:
    explicit Interpolation(BackgroundMesh mesh)
        : mesh_(std::move(mesh))
        , tree_(boxes())
    {}

    double operator()(Vec2 p) const
    {
        double nearest = std::numeric_limits<double>::infinity();
        double size = 0.0;
        tree_.searchNearest(p, [&](std::uint32_t t) {
            const Place place = nearestIn(mesh_.triangles[t], p);
            if (place.squaredDistance < nearest) {
                nearest = place.squaredDistance;
                size = place.size;
            }
            return nearest;
        });
        return size;
    }

    std::vector<AreaSource::Detail> details() const
    {
        std::vector<double> shortest(mesh_.nodes.size(), std::numeric_limits<double>::infinity());
        for (const auto& v : mesh_.triangles) {
            for (std::size_t i = 0; i < 3; ++i) {
                const std::uint32_t a = v[i];
                const std::uint32_t b = v[(i + 1) % 3];
                const double length = distance(mesh_.nodes[a], mesh_.nodes[b]);
                if (length > 0.0) {
                    shortest[a] = std::min(shortest[a], length);
                    shortest[b] = std::min(shortest[b], length);
                }
            }
        }
        std::vector<AreaSource::Detail> details;
        for (std::size_t i = 0; i < shortest.size(); ++i) {
            if (std::isfinite(shortest[i])) {
                details.push_back({mesh_.nodes[i], shortest[i]});
            }
        }
        return details;
    }

private:
    struct Place
    {
        double squaredDistance;
        double size;
    };

    std::vector<Box2> boxes() const
    {
        std::vector<Box2> boxes;
        boxes.reserve(mesh_.triangles.size());
        for (const auto& triangle : mesh_.triangles) {
            Box2 box;
            for (const std::uint32_t v : triangle) {
                box.add(mesh_.nodes[v]);
            }
            boxes.push_back(box);
        }
        return boxes;
    }

    Place nearestIn(const std::array<std::uint32_t, 3>& v, Vec2 p) const
    {
        const Vec2 a = mesh_.nodes[v[0]];
        const Vec2 b = mesh_.nodes[v[1]];
        const Vec2 c = mesh_.nodes[v[2]];
        const double area = cross(b - a, c - a);
        if (area != 0.0) {
            const double u = cross(b - p, c - p) / area;
            const double w = cross(c - p, a - p) / area;
            const double z = 1.0 - u - w;
            if (u >= 0.0 && w >= 0.0 && z >= 0.0) {
                return {0.0, u * mesh_.sizes[v[0]] + w * mesh_.sizes[v[1]] + z * mesh_.sizes[v[2]]};
            }
        }
        Place best = nearestOn(v[0], v[1], p);
        for (std::size_t i = 1; i < 3; ++i) {
            const Place other = nearestOn(v[i], v[(i + 1) % 3], p);
            best = other.squaredDistance < best.squaredDistance ? other : best;
        }
        return best;
    }

    Place nearestOn(std::uint32_t i, std::uint32_t j, Vec2 p) const
    {
        const Vec2 a = mesh_.nodes[i];
        const Vec2 along = mesh_.nodes[j] - a;
        const double square = squaredLength(along);
        const double s = square > 0.0 ? std::clamp(dot(p - a, along) / square, 0.0, 1.0) : 0.0;
        return {squaredLength(p - a - s * along),
                (1.0 - s) * mesh_.sizes[i] + s * mesh_.sizes[j]};
    }

    BackgroundMesh mesh_;
    BoxTree tree_;
};

} // namespace

AreaSource backgroundSource(BackgroundMesh mesh)
{
    requireValid(mesh);
    const std::string name = "The size in " + mesh.name;
    const auto interpolation = std::make_shared<const Interpolation>(std::move(mesh));
    return {name, [interpolation](Vec2 p) { return (*interpolation)(p); }, true,
            interpolation->details()};
}

} // namespace tessera
