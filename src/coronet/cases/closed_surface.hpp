// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// A closed surface of triangles: how far any point is from it, on which side, and where. The nearest triangle is found
// in a tree of boxes. On which side a point is, is what the sign of n . (x - nearest) says, with n the normal of what
// the nearest point lies on: of the triangle, of an edge the sum of both, of a corner the sum weighted by the angles
// (Baerentzen and Aanaes, IEEE Trans. Vis. Comput. Graph. 11 (2005) 243): exact for any closed surface whose pieces do
// not meet, and no ray can graze anything.

#include <array>
#include <string>
#include <vector>

#include "coronet/io/triangles.hpp"

namespace coronet {

class ClosedSurface {
public:
    using Point = Vector<double, 3>;

    /// Triangles and a length of their unit [m]. Equal corners are one. Throws CaseError, saying which triangle, if one
    /// has no area, an edge belongs to another number of triangles than two, or two neighbours are of opposite sense.
    ClosedSurface(Triangles const& triangles, double unit, std::string const& file);

    struct Nearest {
        double distance;  ///< to the surface, below 0 inside [m]
        Point normal;     ///< out of the body: the direction away from the nearest point
    };
    Nearest nearest(Point const& x) const;

    Point const& low() const { return low_; }  ///< of the box that holds it [m]
    Point const& high() const { return high_; }
    double volume() const { return volume_; }  ///< [m^3]
    std::string const& file() const { return file_; }

private:
    struct Node {
        Point low, high;
        int first, count;  // triangles; count 0: children at first and first + 1
    };
    struct Foot {
        double distance2 = 1e300;
        Point from;  // to x
        int triangle = 0;
        int part = 0;  // 0: inside; 1, 2, 3: edge behind corner 0, 1, 2; 4, 5, 6: corner
    };
    void weld(Triangles const& triangles, double unit, std::string const& file);
    void find_normals(Triangles const& triangles, std::string const& file);
    void grow(int node);
    Foot foot_on(int triangle, Point const& x) const;
    void descend(int node, Point const& x, Foot& best) const;

    std::vector<Point> corners_;
    std::vector<std::array<int, 3>> triangles_;
    std::vector<Point> triangle_normals_, corner_normals_;
    std::vector<std::array<Point, 3>> edge_normals_;  // of the edge behind each corner
    std::vector<int> order_;                          // triangles as the leaves have them
    std::vector<Node> nodes_;
    Point low_, high_;
    double volume_ = 0;
    std::string file_;
};

}  // namespace coronet
