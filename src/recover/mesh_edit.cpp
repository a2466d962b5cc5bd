// SPDX-License-Identifier: MIT
#include "recover/mesh_edit.h"

#include "delaunay/start.h"
#include "predicates/predicates.h"

#include <algorithm>
#include <numeric>
#include <utility>

namespace tessera
{

Departure depart(const Triangulation& mesh, std::uint32_t from, std::uint32_t to)
{
    const Vec2 origin = mesh.points[from];
    const Vec2 target = mesh.points[to];
    const auto side = [&](HalfEdge h) {
        return orient2d(origin, target, mesh.points[mesh.destination(h)]);
    };
    const auto ahead = [&](HalfEdge h) {
        return compareOnLine(origin, target, mesh.points[mesh.destination(h)], origin) > 0;
    };
    HalfEdge h = mesh.incident[from];
    if (mesh.destination(h) == Topology::kInfinite) {
        h = mesh.nextAround(h);
    }
    const HalfEdge first = h;
    int s = side(h);
    if (s == 0 && ahead(h)) {
        return {Departure::Kind::Along, h};
    }
    // Turn toward the ray: clockwise from its left, counter-clockwise from its right. At the hull
    // the finite triangles fill at most a half-plane, which the ray does not leave; only a start
    // exactly behind may turn the wrong way, across the ghosts, and then meets an edge ahead.
    const bool clockwise = s >= 0;
    bool finite = true;
    do {
        const HalfEdge before = h;
        h = clockwise ? mesh.prevAround(h) : mesh.nextAround(h);
        if (mesh.destination(h) == Topology::kInfinite) {
            finite = false;
            continue;
        }
        s = side(h);
        if (s == 0 && ahead(h)) {
            return {Departure::Kind::Along, h};
        }
        if (clockwise ? s < 0 : s > 0) {
            return {finite ? Departure::Kind::Across : Departure::Kind::None,
                    Topology::next(clockwise ? h : before)};
        }
        finite = true;
    } while (h != first);
    return {Departure::Kind::None, Topology::kDead};
}

HalfEdge edgeBetween(const Triangulation& mesh, std::uint32_t x, std::uint32_t y)
{
    const HalfEdge firstX = mesh.incident[x];
    const HalfEdge firstY = mesh.incident[y];
    HalfEdge i = firstX;
    HalfEdge j = firstY;
    do {
        if (mesh.destination(i) == y) {
            return i;
        }
        if (mesh.destination(j) == x) {
            return mesh.twin(j);
        }
        i = mesh.nextAround(i);
        j = mesh.prevAround(j);
    } while (i != firstX && j != firstY);
    return Topology::kDead;
}

bool MeshEdit::constrain(std::uint32_t x, std::uint32_t y)
{
    if (const HalfEdge edge = edgeBetween(mesh_, x, y); edge != Topology::kDead) {
        mesh_.setConstrained(edge, true);
        return true;
    }
    const Departure departure = depart(mesh_, x, y);
    if (departure.kind != Departure::Kind::Across || !walk(x, y, departure.edge)) {
        return false;
    }
    for (const std::uint32_t t : slots_) {
        mesh_.triangles[t].v[0] = Topology::kDead;
    }
    leftOpen_.clear();
    for (const Side& side : left_) {
        leftOpen_.push_back(openSide(side.inner, side.vertex));
    }
    rightOpen_.clear();
    for (std::size_t i = right_.size(); i-- > 0;) {
        rightOpen_.push_back(openSide(right_[i].inner, i > 0 ? right_[i - 1].vertex : x));
    }
    slits_.clear();
    nextSlot_ = 0;
    const HalfEdge leftBase = fill(x, leftOpen_);
    const HalfEdge rightBase = fill(y, rightOpen_);
    mesh_.join(leftBase, rightBase, true);
    restore();
    return true;
}

/// Collects the triangles that the segment crosses, and the sides of the polygons left and right of
/// it from x to y. False if something is in the way.
bool MeshEdit::walk(std::uint32_t x, std::uint32_t y, HalfEdge crossed)
{
    const Vec2 from = mesh_.points[x];
    const Vec2 to = mesh_.points[y];
    left_.clear();
    right_.clear();
    slots_.clear();
    slots_.push_back(Topology::triangleOf(crossed));
    left_.push_back({mesh_.destination(crossed), Topology::next(crossed)});
    right_.push_back({mesh_.origin(crossed), Topology::prev(crossed)});
    for (;;) {
        if (mesh_.isConstrained(crossed)) {
            return false;
        }
        const HalfEdge entered = mesh_.twin(crossed);
        const std::uint32_t apex = mesh_.apex(entered);
        if (apex == Topology::kInfinite) {
            return false;
        }
        slots_.push_back(Topology::triangleOf(entered));
        if (apex == y) {
            left_.push_back({y, Topology::prev(entered)});
            right_.push_back({y, Topology::next(entered)});
            return true;
        }
        const int s = orient2d(from, to, mesh_.points[apex]);
        if (s == 0) {
            return false;
        }
        if (s > 0) {
            left_.push_back({apex, Topology::prev(entered)});
            crossed = Topology::next(entered);
        }
        else {
            right_.push_back({apex, Topology::next(entered)});
            crossed = Topology::prev(entered);
        }
    }
}

/// To be called while the cavity's triangles are marked as dead.
MeshEdit::Open MeshEdit::openSide(HalfEdge inner, std::uint32_t vertex) const
{
    const HalfEdge outer = mesh_.twin(inner);
    const bool slit = mesh_.isDead(Topology::triangleOf(outer));
    return {vertex, inner, outer, slit ? SideKind::Slit : SideKind::Border,
            mesh_.isConstrained(inner)};
}

/// Triangulates the polygon that runs from start along the sides; the last one's vertex closes it
/// by the base edge back to start. Returns the base: the half-edge from start to the last vertex.
HalfEdge MeshEdit::fill(std::uint32_t start, const std::vector<Open>& sides)
{
    stack_.clear();
    stack_.push_back({start, Topology::kDead, Topology::kDead, SideKind::Border, false});
    for (Open side : sides) {
        while (stack_.size() >= 2) {
            const Open& top = stack_.back();
            const std::uint32_t below = stack_[stack_.size() - 2].vertex;
            if (orient2d(mesh_.points[side.vertex], mesh_.points[top.vertex], mesh_.points[below])
                <= 0) {
                break;
            }
            const std::uint32_t t = place(slots_[nextSlot_++], side.vertex, top.vertex, below);
            joinSide(Topology::halfEdge(t, 0), top);
            joinSide(Topology::halfEdge(t, 2), side);
            side = {side.vertex, Topology::kDead, Topology::halfEdge(t, 1), SideKind::Internal,
                    false};
            stack_.pop_back();
        }
        stack_.push_back(side);
    }
    return stack_.back().outer;
}

/// Writes a triangle into a slot; its links are the caller's to set.
std::uint32_t MeshEdit::place(std::uint32_t t, std::uint32_t a, std::uint32_t b, std::uint32_t c)
{
    auto& triangle = mesh_.triangles[t];
    triangle.v[0] = a;
    triangle.v[1] = b;
    triangle.v[2] = c;
    mesh_.incident[a] = Topology::halfEdge(t, 2);
    mesh_.incident[b] = Topology::halfEdge(t, 0);
    mesh_.incident[c] = Topology::halfEdge(t, 1);
    if (postponed_) {
        for (std::uint32_t i = 0; i < 3; ++i) {
            suspects_.push_back(Topology::halfEdge(t, i));
        }
    }
    return t;
}

void MeshEdit::joinSide(HalfEdge h, const Open& side)
{
    if (side.kind == SideKind::Border) {
        mesh_.join(h, side.outer, side.constrained);
        return;
    }
    if (side.kind == SideKind::Slit) {
        const auto partner = std::find_if(slits_.begin(), slits_.end(), [&](const Slit& slit) {
            return slit.inner == side.outer;
        });
        if (partner == slits_.end()) {
            slits_.push_back({side.inner, h});
            return;
        }
        mesh_.join(h, partner->placed, side.constrained);
    }
    else {
        mesh_.join(h, side.outer);
    }
    if (!postponed_) {
        suspects_.push_back(h);
    }
}

bool MeshEdit::splitsEdge(HalfEdge edge, Vec2 p) const
{
    const HalfEdge back = mesh_.twin(edge);
    const std::uint32_t left = mesh_.apex(edge);
    const std::uint32_t right = mesh_.apex(back);
    if (left == Topology::kInfinite || right == Topology::kInfinite) {
        return false;
    }
    const Vec2 u = mesh_.points[mesh_.origin(edge)];
    const Vec2 v = mesh_.points[mesh_.destination(edge)];
    const Vec2 l = mesh_.points[left];
    const Vec2 r = mesh_.points[right];
    return orient2d(p, l, u) > 0 && orient2d(p, v, l) > 0 && orient2d(p, r, v) > 0
        && orient2d(p, u, r) > 0;
}

std::uint32_t MeshEdit::splitEdge(HalfEdge edge, Vec2 p)
{
    const std::uint32_t vertex = takeVertex(p);
    if (!postponed_ && inBothCircles(edge, p)) {
        cavity_.insert(vertex, true, edge);
        return vertex;
    }
    const bool before = std::exchange(postponed_, true);
    splitOnly(edge, vertex);
    postpone(before);
    return vertex;
}

/// A point beside a constrained edge may be outside the circle of the triangle beyond. The conflict
/// region would then not be one, and its star not Delaunay.
bool MeshEdit::inBothCircles(HalfEdge edge, Vec2 p) const
{
    const Vec2 u = mesh_.points[mesh_.origin(edge)];
    const Vec2 v = mesh_.points[mesh_.destination(edge)];
    return incircle(u, v, mesh_.points[mesh_.apex(edge)], p) >= 0
        && incircle(v, u, mesh_.points[mesh_.apex(mesh_.twin(edge))], p) >= 0;
}

//            l                     l
//          /   \                 / | \            All four start with p, so that their edges 0 are
//         u --- v       ->      u- p -v           those of the quadrilateral.
//          \   /                 \ | /
//            r                     r
void MeshEdit::splitOnly(HalfEdge edge, std::uint32_t p)
{
    const HalfEdge back = mesh_.twin(edge);
    const std::uint32_t u = mesh_.origin(edge);
    const std::uint32_t v = mesh_.destination(edge);
    const std::uint32_t l = mesh_.apex(edge);
    const std::uint32_t r = mesh_.apex(back);
    const bool constrained = mesh_.isConstrained(edge);
    const Open sides[4] = {border(Topology::next(edge)), border(Topology::prev(edge)),
                           border(Topology::next(back)), border(Topology::prev(back))};
    const std::uint32_t third = mesh_.takeTriangle();
    const std::uint32_t fourth = mesh_.takeTriangle();
    // Around p: v -> l -> u -> r, counter-clockwise.
    const std::uint32_t t[4] = {place(Topology::triangleOf(edge), p, v, l), place(third, p, l, u),
                                place(Topology::triangleOf(back), p, u, r), place(fourth, p, r, v)};
    for (std::uint32_t i = 0; i < 4; ++i) {
        joinSide(Topology::halfEdge(t[i], 0), sides[i]);
        mesh_.join(Topology::halfEdge(t[i], 1), Topology::halfEdge(t[(i + 1) % 4], 2),
                   i % 2 == 1 && constrained);
    }
}

void MeshEdit::removeVertex(std::uint32_t vertex)
{
    slots_.clear();
    std::vector<Open>& polygon = leftOpen_;
    polygon.clear();
    mesh_.forEachAround(vertex, [&](HalfEdge h) {
        const HalfEdge side = Topology::next(h);
        polygon.push_back(border(side));
        slots_.push_back(Topology::triangleOf(h));
    });
    nextSlot_ = 0;
    while (polygon.size() > 3) {
        cutEar(polygon);
    }
    const std::uint32_t t
        = place(slots_[nextSlot_++], polygon[0].vertex, polygon[1].vertex, polygon[2].vertex);
    // Side i of the polygon ends at its vertex i.
    joinSide(Topology::halfEdge(t, 2), polygon[1]);
    joinSide(Topology::halfEdge(t, 0), polygon[2]);
    joinSide(Topology::halfEdge(t, 1), polygon[0]);
    for (; nextSlot_ < slots_.size(); ++nextSlot_) {
        mesh_.triangles[slots_[nextSlot_]].v[0] = Topology::kDead;
        mesh_.freeList.push_back(slots_[nextSlot_]);
    }
    mesh_.incident[vertex] = Topology::kDead;
    freeVertices_.push_back(vertex);
    restore();
}

/// Cuts a corner that is convex and whose triangle holds no other vertex of the simple polygon;
/// there always is one.
void MeshEdit::cutEar(std::vector<Open>& polygon)
{
    const std::size_t n = polygon.size();
    const auto at = [&](std::size_t i) { return mesh_.points[polygon[i % n].vertex]; };
    const auto isEar = [&](std::size_t i) {
        const Vec2 a = at(i + n - 1);
        const Vec2 b = at(i);
        const Vec2 c = at(i + 1);
        if (orient2d(a, b, c) <= 0) {
            return false;
        }
        for (std::size_t k = i + 2; k < i + n - 1; ++k) {
            const Vec2 d = at(k);
            if (orient2d(a, b, d) >= 0 && orient2d(b, c, d) >= 0 && orient2d(c, a, d) >= 0) {
                return false;
            }
        }
        return true;
    };
    std::size_t i = 0;
    while (i + 1 < n && !isEar(i)) {
        ++i;
    }
    const Open& before = polygon[i];
    Open& after = polygon[(i + 1) % n];
    const std::uint32_t a = polygon[(i + n - 1) % n].vertex;
    const std::uint32_t t = place(slots_[nextSlot_++], a, before.vertex, after.vertex);
    joinSide(Topology::halfEdge(t, 2), before);
    joinSide(Topology::halfEdge(t, 0), after);
    after = {after.vertex, Topology::kDead, Topology::halfEdge(t, 1), SideKind::Internal, false};
    polygon.erase(polygon.begin() + static_cast<std::ptrdiff_t>(i));
}

std::uint32_t MeshEdit::insert(Vec2 p, const Location& where)
{
    const std::uint32_t vertex = insertPointAt(mesh_, p, where);
    if (postponed_) {
        mesh_.forEachAround(vertex, [this](HalfEdge h) {
            suspects_.push_back(h);
            suspects_.push_back(Topology::next(h));
        });
    }
    return vertex;
}

void MeshEdit::release(HalfEdge edge)
{
    mesh_.setConstrained(edge, false);
    suspects_.push_back(edge);
    restore();
}

void MeshEdit::postpone(bool on)
{
    postponed_ = on;
    restore();
}

void MeshEdit::restore()
{
    if (postponed_) {
        return;
    }
    legalize(mesh_, suspects_);
}

MeshEdit::Open MeshEdit::border(HalfEdge inner) const
{
    return {mesh_.destination(inner), Topology::kDead, mesh_.twin(inner), SideKind::Border,
            mesh_.isConstrained(inner)};
}

std::vector<std::uint32_t> MeshEdit::closeGaps()
{
    std::vector<std::uint32_t> gaps = std::exchange(freeVertices_, {});
    if (gaps.empty()) {
        return {};
    }
    std::sort(gaps.begin(), gaps.end());
    std::vector<std::uint32_t> newName(mesh_.points.size());
    std::iota(newName.begin(), newName.end(), 0U);
    std::size_t next = 0;
    while (next < gaps.size()) {
        const auto last = static_cast<std::uint32_t>(mesh_.points.size() - 1);
        if (gaps.back() == last) {
            gaps.pop_back();
        }
        else {
            const std::uint32_t gap = gaps[next++];
            mesh_.forEachAround(last, [&](HalfEdge h) {
                mesh_.triangles[h >> 2].v[Topology::next3(h & 3U)] = gap;
            });
            mesh_.points[gap] = mesh_.points[last];
            mesh_.incident[gap] = mesh_.incident[last];
            newName[last] = gap;
        }
        mesh_.points.pop_back();
        mesh_.incident.pop_back();
    }
    return newName;
}

std::uint32_t MeshEdit::takeVertex(Vec2 p)
{
    if (!freeVertices_.empty()) {
        const std::uint32_t vertex = freeVertices_.back();
        freeVertices_.pop_back();
        mesh_.points[vertex] = p;
        return vertex;
    }
    return appendVertex(mesh_, p);
}

} // namespace tessera
