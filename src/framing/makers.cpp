#include "framing/makers.hpp"

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <numbers>

#include "support/index.hpp"

namespace rollcon {
namespace {

constexpr double pi = std::numbers::pi;

/// Builds a mesh in the plane of the axes.
class Builder {
 public:
  explicit Builder(const Axes& axes) : axes_(axes) { mesh_.offset.push_back(0); }

  std::int32_t add_node(double x, double y) {
    const auto number = static_cast<std::int32_t>(mesh_.node.size());
    mesh_.node.push_back(axes_.origin + x * axes_.t1 + y * axes_.t2);
    return number;
  }
  void add_element(ElementType type, std::initializer_list<std::int32_t> node) {
    mesh_.type.push_back(type);
    mesh_.tag.push_back(0);
    mesh_.connectivity.insert(mesh_.connectivity.end(), node);
    mesh_.offset.push_back(static_cast<std::int64_t>(mesh_.connectivity.size()));
  }
  SurfaceMesh take() { return std::move(mesh_); }

 private:
  const Axes& axes_;
  SurfaceMesh mesh_;
};

// Returns fractions from 0 to 1; mirrored halves are equal to the last digit.
std::vector<double> graded(std::int64_t intervals) {
  std::vector<double> part(at(intervals) + 1);
  for (std::size_t i = 0; 2 * i <= at(intervals); ++i) {
    const double angle = pi * static_cast<double>(i) / static_cast<double>(intervals);
    const double before = std::sin(angle / 2) * std::sin(angle / 2);
    part[at(intervals) - i] = 1 - before;
    part[i] = before;
  }
  return part;
}

}  // namespace

static void add_strips(Builder& mesh, std::span<const Strip> strip, std::int64_t along) {
  const std::vector<double> part = graded(along);
  std::vector<std::int32_t> line, next;
  for (const Strip& s : strip) {
    next.clear();
    const bool point = !(s.to > s.from);
    for (std::size_t i = 0; i < (point ? 1 : part.size()); ++i)
      next.push_back(mesh.add_node(point ? s.from : s.from * (1 - part[i]) + s.to * part[i], s.y));
    for (std::size_t i = 0; !line.empty() && i + 1 < part.size(); ++i) {
      if (line.size() == 1)
        mesh.add_element(ElementType::tri3, {line[0], next[i + 1], next[i]});
      else if (next.size() == 1)
        mesh.add_element(ElementType::tri3, {line[i], line[i + 1], next[0]});
      else
        mesh.add_element(ElementType::quad4, {line[i], line[i + 1], next[i + 1], next[i]});
    }
    line.swap(next);
  }
}

SurfaceMesh strips_mesh(const Axes& axes, std::span<const Strip> strip, std::int64_t along) {
  Builder mesh(axes);
  add_strips(mesh, strip, along);
  return mesh.take();
}

SurfaceMesh strips_mesh(const Axes& axes, std::span<const std::vector<Strip>> patch, std::int64_t along) {
  Builder mesh(axes);
  for (const std::vector<Strip>& strip : patch) add_strips(mesh, strip, along);
  return mesh.take();
}

FramePlace place_of_disc(double semi1, double semi2, double angle) {
  // The ellipse is x^T S^-1 x = 1 with S = [xx xy; xy yy].
  const double c = std::cos(angle), s = std::sin(angle);
  const double yy = semi1 * semi1 * s * s + semi2 * semi2 * c * c, xy = (semi1 - semi2) * (semi1 + semi2) * c * s;
  const double width = std::sqrt(yy);
  // Rounding has to go where angles are at right angles to the rolling direction, as their cosines are no zeros.
  constexpr double rounding = 1e-15;
  const double shear = xy / width;
  return {semi1 * (semi2 / width), width, std::abs(shear) < rounding * std::max(semi1, semi2) ? 0 : shear};
}

std::vector<Strip> strips_of_ellipse(double semi1, double semi2, double angle, std::int64_t across) {
  const FramePlace place = place_of_disc(semi1, semi2, angle);
  std::vector<Strip> strip;
  for (const double p : graded(across)) {
    const double height = 2 * p - 1, middle = place.shear * height, reach = place.length * 2 * std::sqrt(p * (1 - p));
    strip.push_back({place.width * height, middle - reach, middle + reach});
  }
  return strip;
}

static void add_rectangle(Builder& mesh, ElementType type, const RectangleCells& cells) {
  const auto& [r, nx, ny] = cells;
  const std::int64_t step = is_quadratic(type) ? 2 : 1, lines = step * nx + 1, rows = step * ny + 1;
  std::vector<std::int32_t> number(at(lines * rows), -1);
  const auto place = [](double from, double to, std::int64_t i, std::int64_t n) {
    const double t = static_cast<double>(i) / static_cast<double>(n - 1);
    return from * (1 - t) + to * t;
  };
  for (std::int64_t j = 0; j < rows; ++j)
    for (std::int64_t i = 0; i < lines; ++i)
      if (type != ElementType::quad8 || i % 2 == 0 || j % 2 == 0)
        number[at(j * lines + i)] =
            mesh.add_node(place(r.x_least, r.x_greatest, i, lines), place(r.y_least, r.y_greatest, j, rows));
  for (std::int64_t j = 0; j < ny; ++j)
    for (std::int64_t i = 0; i < nx; ++i) {
      // Returns the node of this cell, in halves of a cell where there are some.
      const auto n = [&](int u, int v) { return number[at((step * j + v) * lines + step * i + u)]; };
      const int s = static_cast<int>(step);
      const bool rising = (i + j) % 2 == 0;
      switch (type) {
        case ElementType::quad4:
          mesh.add_element(type, {n(0, 0), n(1, 0), n(1, 1), n(0, 1)});
          break;
        case ElementType::quad8:
          mesh.add_element(type, {n(0, 0), n(2, 0), n(2, 2), n(0, 2), n(1, 0), n(2, 1), n(1, 2), n(0, 1)});
          break;
        case ElementType::quad9:
          mesh.add_element(type, {n(0, 0), n(2, 0), n(2, 2), n(0, 2), n(1, 0), n(2, 1), n(1, 2), n(0, 1), n(1, 1)});
          break;
        case ElementType::tri3:
          mesh.add_element(type, {n(0, 0), n(s, 0), rising ? n(s, s) : n(0, s)});
          mesh.add_element(type, {rising ? n(0, 0) : n(s, 0), n(s, s), n(0, s)});
          break;
        case ElementType::tri6:
          if (rising) {
            mesh.add_element(type, {n(0, 0), n(2, 0), n(2, 2), n(1, 0), n(2, 1), n(1, 1)});
            mesh.add_element(type, {n(0, 0), n(2, 2), n(0, 2), n(1, 1), n(1, 2), n(0, 1)});
          } else {
            mesh.add_element(type, {n(0, 0), n(2, 0), n(0, 2), n(1, 0), n(1, 1), n(0, 1)});
            mesh.add_element(type, {n(2, 0), n(2, 2), n(0, 2), n(2, 1), n(1, 2), n(1, 1)});
          }
      }
    }
}

SurfaceMesh rectangle_mesh(const Axes& axes, ElementType type, std::int64_t nx, std::int64_t ny, const Rectangle& r) {
  const RectangleCells cells{r, nx, ny};
  return rectangles_mesh(axes, type, {&cells, 1});
}

SurfaceMesh rectangles_mesh(const Axes& axes, ElementType type, std::span<const RectangleCells> rectangle) {
  Builder mesh(axes);
  for (const RectangleCells& cells : rectangle) add_rectangle(mesh, type, cells);
  return mesh.take();
}

}  // namespace rollcon
