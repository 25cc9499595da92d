#include "meshes.hpp"

#include <rollcon.h>

#include <array>
#include <map>
#include <utility>

namespace fuzz {

const std::int32_t element_types[11] = {ROLLCON_TRI3,    ROLLCON_TRI6, ROLLCON_QUAD4, ROLLCON_QUAD8,
                                        ROLLCON_QUAD9,   ROLLCON_TET4, ROLLCON_TET10, ROLLCON_WEDGE6,
                                        ROLLCON_WEDGE15, ROLLCON_HEX8, ROLLCON_HEX20};

int nodes_of_type(std::int32_t type) {
  static const int count[11] = {3, 6, 4, 8, 9, 4, 10, 6, 15, 8, 20};
  for (int i = 0; i < 11; ++i)
    if (element_types[i] == type) return count[i];
  return 0;
}

namespace {

using Point = std::array<int, 3>;  // twice the index of the cell's corner
using Edge = std::pair<int, int>;

const std::vector<Edge>& edges_of(std::int32_t type) {
  static const std::vector<Edge> triangle{{0, 1}, {1, 2}, {2, 0}}, quadrilateral{{0, 1}, {1, 2}, {2, 3}, {3, 0}},
      tetrahedron{{0, 1}, {1, 2}, {2, 0}, {0, 3}, {1, 3}, {2, 3}},
      wedge{{0, 1}, {1, 2}, {2, 0}, {3, 4}, {4, 5}, {5, 3}, {0, 3}, {1, 4}, {2, 5}},
      hexahedron{{0, 1}, {1, 2}, {2, 3}, {3, 0}, {4, 5}, {5, 6}, {6, 7}, {7, 4}, {0, 4}, {1, 5}, {2, 6}, {3, 7}}, none;
  switch (type) {
    case ROLLCON_TRI6:
      return triangle;
    case ROLLCON_QUAD8:
    case ROLLCON_QUAD9:
      return quadrilateral;
    case ROLLCON_TET10:
      return tetrahedron;
    case ROLLCON_WEDGE15:
      return wedge;
    case ROLLCON_HEX20:
      return hexahedron;
    default:
      return none;
  }
}

class Maker {
 public:
  Maker(std::int32_t type, const int (&n)[3], const double (&size)[3]) : n_(n), size_(size) {
    box.type = type;
    box.per_element = nodes_of_type(type);
  }

  /// Adds an element by its corners; nodes on edges and in the centre follow.
  void add(std::vector<Point> corner) {
    const auto middle = [&](int a, int b) {
      Point p{};
      for (std::size_t c = 0; c < 3; ++c)
        p[c] = (corner[static_cast<std::size_t>(a)][c] + corner[static_cast<std::size_t>(b)][c]) / 2;
      return p;
    };
    std::vector<Point> more;
    for (const Edge& edge : edges_of(box.type)) more.push_back(middle(edge.first, edge.second));
    if (box.type == ROLLCON_QUAD9) more.push_back(middle(0, 2));
    corner.insert(corner.end(), more.begin(), more.end());
    for (const Point& p : corner) box.element.push_back(node(p));
  }

  void volumes() {
    for (int k = 0; k < n_[2]; ++k)
      for (int j = 0; j < n_[1]; ++j)
        for (int i = 0; i < n_[0]; ++i) cell(i, j, k);
  }

  void surfaces() {
    for (std::size_t f = 0; f < 6; ++f) {
      const std::size_t axis = f / 2, p = (axis + 1) % 3, q = (axis + 2) % 3;
      for (int j = 0; j < n_[q]; ++j)
        for (int i = 0; i < n_[p]; ++i) {
          const auto at = [&](int a, int b) {
            Point point{};
            point[axis] = f % 2 == 1 ? 2 * n_[axis] : 0;
            point[p] = 2 * (i + a);
            point[q] = 2 * (j + b);
            return point;
          };
          const Point a = at(0, 0), b = f % 2 == 1 ? at(1, 0) : at(0, 1), c = at(1, 1),
                      d = f % 2 == 1 ? at(0, 1) : at(1, 0);
          const std::size_t before = box.element.size();
          if (box.type == ROLLCON_TRI3 || box.type == ROLLCON_TRI6) {
            add({a, b, c});
            add({a, c, d});
          } else {
            add({a, b, c, d});
          }
          const std::size_t added = (box.element.size() - before) / static_cast<std::size_t>(box.per_element);
          box.side.insert(box.side.end(), added, static_cast<std::int32_t>(f));
        }
    }
  }

  Box box;

 private:
  void cell(int i, int j, int k) {
    const auto at = [&](int a, int b, int c) { return Point{2 * (i + a), 2 * (j + b), 2 * (k + c)}; };
    const Point a = at(0, 0, 0), b = at(1, 0, 0), c = at(1, 1, 0), d = at(0, 1, 0), e = at(0, 0, 1), f = at(1, 0, 1),
                g = at(1, 1, 1), h = at(0, 1, 1);
    switch (box.type) {
      case ROLLCON_TET4:
      case ROLLCON_TET10:
        // Six tetrahedra lie around the diagonal from a to g.
        add({a, b, c, g});
        add({a, c, d, g});
        add({a, d, h, g});
        add({a, h, e, g});
        add({a, e, f, g});
        add({a, f, b, g});
        break;
      case ROLLCON_WEDGE6:
      case ROLLCON_WEDGE15:
        add({a, b, c, e, f, g});
        add({a, c, d, e, g, h});
        break;
      default:
        add({a, b, c, d, e, f, g, h});
    }
  }

  std::int32_t node(const Point& p) {
    const auto next = static_cast<std::int32_t>(known_.size());
    const auto [entry, fresh] = known_.emplace(p, next);
    if (fresh) {
      for (std::size_t c = 0; c < 3; ++c) box.x.push_back(size_[c] * p[c] / (2.0 * n_[c]));
      if (p[2] == 0) box.at_bottom.push_back(next);
      if (p[2] == 2 * n_[2]) box.at_top.push_back(next);
    }
    return entry->second;
  }

  const int (&n_)[3];
  const double (&size_)[3];
  std::map<Point, std::int32_t> known_;
};

}  // namespace

Box make_box(std::int32_t type, const int (&n)[3], const double (&size)[3]) {
  Maker maker(type, n, size);
  if (type >= ROLLCON_TET4)
    maker.volumes();
  else
    maker.surfaces();
  return std::move(maker.box);
}

}  // namespace fuzz
