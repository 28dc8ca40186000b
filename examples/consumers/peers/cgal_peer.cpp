// CGAL's visibility polygons (Debian: libcgal-dev) under test, asked by `through.py`; all numbers are
// exact. CGAL's visibility package is under the GPL, which whoever compiles and hands on this program
// has to follow; nothing of CGAL is part of this repository.
//
//   c++ -std=c++17 -O2 -o cgal_peer cgal_peer.cpp -lgmp -lmpfr
//   ./cgal_peer [--sweep]     by triangular expansion, or by rotational sweep

#include <CGAL/Arr_naive_point_location.h>
#include <CGAL/Arr_segment_traits_2.h>
#include <CGAL/Arrangement_2.h>
#include <CGAL/Boolean_set_operations_2.h>
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Polygon_2.h>
#include <CGAL/Rotational_sweep_visibility_2.h>
#include <CGAL/Triangular_expansion_visibility_2.h>

#include <iostream>
#include <sstream>
#include <string>
#include <vector>

using Kernel = CGAL::Exact_predicates_exact_constructions_kernel;
using Point = Kernel::Point_2;
using Segment = Kernel::Segment_2;
using Polygon = CGAL::Polygon_2<Kernel>;
using Arrangement = CGAL::Arrangement_2<CGAL::Arr_segment_traits_2<Kernel>>;
// Regularized: without the needles of what is seen between two walls that touch.
using Expansion = CGAL::Triangular_expansion_visibility_2<Arrangement, CGAL::Tag_true>;
using Sweep = CGAL::Rotational_sweep_visibility_2<Arrangement, CGAL::Tag_true>;

Point read_point(std::istream& in) {
    std::string x, y;
    in >> x >> y;
    return {Kernel::FT(Kernel::Exact_kernel::FT(x)), Kernel::FT(Kernel::Exact_kernel::FT(y))};
}

Polygon read_polygon(std::istream& in) {
    size_t count = 0;
    in >> count;
    Polygon polygon;
    while (count--) polygon.push_back(read_point(in));
    return polygon;
}

// The outer boundary of what a point sees.
template <class Visibility>
Polygon seen_from(const Point& point, const Arrangement& walls, const Visibility& visibility) {
    const auto place = CGAL::Arr_naive_point_location<Arrangement>(walls).locate(point);
    const auto* face = boost::get<Arrangement::Face_const_handle>(&place);
    if (!face) throw std::runtime_error("a view point on a wall");
    Arrangement seen;
    const auto region = visibility.compute_visibility(point, *face, seen);
    Polygon polygon;
    const auto first = region->outer_ccb();
    auto edge = first;
    do polygon.push_back(edge->target()->point());
    while (++edge != first);
    return polygon;
}

template <class Visibility>
std::string answer(std::istream& in) {
    const Point low = read_point(in), high = read_point(in);
    const Point right(high.x(), low.y()), left(low.x(), high.y());
    std::vector<Segment> segments{{low, right}, {right, high}, {high, left}, {left, low}};
    size_t walls = 0, count = 0;
    for (in >> walls; walls--;) {
        const Point end = read_point(in);
        segments.emplace_back(end, read_point(in));
    }
    Arrangement arrangement;
    CGAL::insert(arrangement, segments.begin(), segments.end());
    const Visibility visibility(arrangement);
    std::vector<Polygon> targets;
    for (in >> count; count--;) targets.push_back(read_polygon(in));
    std::string seen(targets.size(), '0');
    for (in >> count; count-- && seen.find('0') != std::string::npos;) {
        const Polygon region = seen_from(read_point(in), arrangement, visibility);
        for (size_t i = 0; i < targets.size(); ++i)
            if (seen[i] == '0' && CGAL::do_intersect(region, targets[i])) seen[i] = '1';
    }
    return seen;
}

int main(int count, char** arguments) {
    const bool sweep = count > 1 && std::string(arguments[1]) == "--sweep";
    for (std::string line; std::getline(std::cin, line);) {
        std::istringstream in(line);
        for (char mark : sweep ? answer<Sweep>(in) : answer<Expansion>(in)) std::cout << mark << ' ';
        std::cout << std::endl;
    }
}
