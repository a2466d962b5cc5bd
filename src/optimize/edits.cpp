// SPDX-License-Identifier: MIT

#include "optimize/edits.h"

#include "predicates/predicates.h"

namespace tessera
{

bool isValidCenter(const Star& star, Vec2 p)
{
    for (int i = 0; i < star.count(); ++i) {
        if (orient2d(p, star.ring(i), star.ring(star.after(i))) <= 0) {
            return false;
        }
    }
    return true;
}

bool isValidCollapse(const Star& star, int target)
{
    for (int i = star.after(target); star.after(i) != target; i = star.after(i)) {
        if (orient2d(star.ring(target), star.ring(i), star.ring(star.after(i))) <= 0) {
            return false;
        }
    }
    return true;
}

void collapse(Triangulation& t, const Star& star, int target)
{
    const std::uint32_t kept = star.vertex(target);
    const HalfEdge spoke = star.edge(target); // center -> kept
    const HalfEdge back = t.twin(spoke);      // kept -> center
    // Left triangle: center, kept, left. Right triangle: kept, center, right.
    const HalfEdge leftOuter = Topology::next(spoke);  // kept -> left
    const HalfEdge leftInner = Topology::prev(spoke);  // left -> center
    const HalfEdge rightInner = Topology::next(back);  // center -> right
    const HalfEdge rightOuter = Topology::prev(back);  // right -> kept
    const HalfEdge leftFar = t.twin(leftOuter);        // left -> kept
    const HalfEdge leftNear = t.twin(leftInner);       // center -> left, becomes kept -> left
    const HalfEdge rightNear = t.twin(rightInner);     // right -> center, becomes right -> kept
    const HalfEdge rightFar = t.twin(rightOuter);      // kept -> right
    const std::uint32_t left = t.origin(leftFar);
    const std::uint32_t right = t.origin(rightNear);
    const bool leftConstrained = t.isConstrained(leftOuter);
    const bool rightConstrained = t.isConstrained(rightOuter);

    for (int i = 0; i < star.count(); ++i) {
        const std::uint32_t triangle = Topology::triangleOf(star.edge(i));
        for (std::uint32_t& v : t.triangles[triangle].v) {
            v = v == star.center() ? kept : v;
        }
    }
    t.join(leftFar, leftNear, leftConstrained);
    t.join(rightFar, rightNear, rightConstrained);
    for (const std::uint32_t dead : {Topology::triangleOf(spoke), Topology::triangleOf(back)}) {
        t.triangles[dead].v[0] = Topology::kDead;
        t.freeList.push_back(dead);
    }
    t.incident[star.center()] = Topology::kDead;
    t.incident[kept] = leftNear;
    t.incident[left] = leftFar;
    t.incident[right] = rightNear;
}

} // namespace tessera
