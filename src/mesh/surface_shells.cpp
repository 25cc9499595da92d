#include "mesh/surface_shells.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>

#include "mesh/box.hpp"
#include "mesh/mesh_errors.hpp"
#include "mesh/surface_geometry.hpp"

namespace rollcon {
namespace {

Names<SurfaceMesh> names_of(const SurfaceMesh& mesh) {
  return {mesh, mesh.index_base, "surface"};
}

/// Elements joined across edges, and whether each looks to the same side as its root.
class SignedForest {
 public:
  explicit SignedForest(std::size_t n) : parent_(n), sign_(n, 1) {
    std::iota(parent_.begin(), parent_.end(), std::size_t{0});
  }
  struct Root {
    std::size_t at;
    int sign;
  };
  Root root(std::size_t i) {
    Root r{i, 1};
    while (parent_[r.at] != r.at) r.sign *= sign_[r.at], r.at = parent_[r.at];
    // Compression shortens the next search.
    for (int s = r.sign; parent_[i] != i;) {
      const std::size_t next = parent_[i];
      const int own = sign_[i];
      parent_[i] = r.at;
      sign_[i] = s;
      s *= own;
      i = next;
    }
    return r;
  }
  void join(std::size_t i, std::size_t j, int sign) {
    const Root a = root(i), b = root(j);
    const auto [low, high] = std::minmax(a.at, b.at);
    if (low == high) return;
    parent_[high] = low;
    sign_[high] = a.sign * b.sign * sign;
  }

 private:
  std::vector<std::size_t> parent_;
  std::vector<int> sign_;
};

}  // namespace

void check_edges(const SurfaceMesh& mesh, std::span<const Side> sides) {
  const Names names = names_of(mesh);
  Tally crowded, differ;
  for_each_edge(sides, [&](const Side& s, std::size_t count) {
    const Side* all = &s;
    if (count > 2)
      crowded.add("edge %lld-%lld with %lld elements (%lld, %lld, %lld, ...)", names.node(s.low()),
                  names.node(s.high()), static_cast<long long>(count), names.element(all[0].cell),
                  names.element(all[1].cell), names.element(all[2].cell));
    else if (count == 2 && midside_node(mesh, all[0]) != midside_node(mesh, all[1]))
      differ.add("edge %lld-%lld of elements %lld (%s) and %lld (%s)", names.node(s.low()), names.node(s.high()),
                 names.element(all[0].cell), names.type(all[0].cell), names.element(all[1].cell),
                 names.type(all[1].cell));
  });
  names.refuse(crowded, "more than two elements share an edge");
  names.refuse(differ, "two elements share an edge but not its midside node");
}

void check_closed(const SurfaceMesh& mesh, std::span<const Side> sides) {
  const Names names = names_of(mesh);
  Tally open;
  for_each_edge(sides, [&](const Side& s, std::size_t count) {
    if (count == 1)
      open.add("edge %lld-%lld of element %lld (%s)", names.node(s.low()), names.node(s.high()), names.element(s.cell),
               names.type(s.cell));
  });
  names.refuse(open,
               "open edge: only one element has it, but a body's surface "
               "must be closed");
}

Shells find_shells(const SurfaceMesh& mesh, std::span<const Side> sides) {
  const auto n = static_cast<std::size_t>(mesh.elements());
  SignedForest forest(n);
  for_each_edge(sides, [&](const Side& a, std::size_t count) {
    const Side& b = *(&a + (count == 2 ? 1 : 0));
    forest.join(static_cast<std::size_t>(a.cell), static_cast<std::size_t>(b.cell), a.from == b.from ? -1 : 1);
  });
  Shells shells;
  shells.shell.resize(n);
  shells.sign.resize(n);
  for (std::size_t e = 0; e < n; ++e) {
    const auto root = forest.root(e);
    // Roots are the first elements of their shells.
    if (root.at == e) {
      shells.shell[e] = static_cast<std::int32_t>(shells.first.size());
      shells.first.push_back(static_cast<std::int64_t>(e));
    } else {
      shells.shell[e] = shells.shell[root.at];
    }
    shells.sign[e] = root.sign;
  }
  return shells;
}

void check_neighbours(const SurfaceMesh& mesh, const Shells& shells) {
  const Names names = names_of(mesh);
  std::vector<std::int64_t> balance(shells.size(), 0);
  for (std::size_t e = 0; e < shells.sign.size(); ++e)
    balance[static_cast<std::size_t>(shells.shell[e])] += shells.sign[e];
  Tally flipped;
  for (std::size_t e = 0; e < shells.sign.size(); ++e)
    if (shells.sign[e] != (balance[static_cast<std::size_t>(shells.shell[e])] < 0 ? -1 : 1))
      flipped.add("element %lld (%s)", names.element(static_cast<std::int64_t>(e)),
                  names.type(static_cast<std::int64_t>(e)));
  names.refuse(flipped,
               "flipped element: its normal is opposite to that of "
               "most elements it hangs together with; "
               "reverse the order of its nodes");
}

std::vector<double> shell_volumes(const SurfaceMesh& mesh, const Shells& shells) {
  const auto first_node = [&](std::int64_t e) { return mesh.node[static_cast<std::size_t>(mesh.element(e)[0])]; };
  std::vector<double> volume(shells.size(), 0), area(shells.size(), 0), far(shells.size(), 0);
  for (std::int64_t e = 0; e < mesh.elements(); ++e) {
    const auto s = static_cast<std::size_t>(shells.shell[static_cast<std::size_t>(e)]);
    volume[s] += shells.sign[static_cast<std::size_t>(e)] * cone_volume(mesh, e, first_node(shells.first[s]));
    area[s] += element_area(mesh, e);
    for (std::int32_t k : mesh.element(e))
      for (double c : mesh.node[static_cast<std::size_t>(k)]) far[s] = std::max(far[s], std::abs(c));
  }
  Tally flat;
  for (std::size_t s = 0; s < shells.size(); ++s) {
    const double noise = 16 * std::numeric_limits<double>::epsilon() * far[s];
    if (!(std::abs(volume[s]) > area[s] * std::max(1e-12 * std::sqrt(area[s]), noise)))
      flat.add("the one of element %lld", static_cast<long long>(shells.first[s]) + mesh.index_base);
  }
  flat.fail_if_any("a closed part encloses no volume", "surface", mesh.index_base);
  return volume;
}

void check_outward(const SurfaceMesh& mesh, const Shells& shells) {
  const Names names = names_of(mesh);
  const std::vector<double> volume = shell_volumes(mesh, shells);
  std::vector<Box> box(shells.size());
  std::vector<std::int64_t> balance(shells.size(), 0);  // elements that look outwards, less the others
  const auto looks_outward = [&](std::size_t e) {
    return volume[static_cast<std::size_t>(shells.shell[e])] * shells.sign[e] > 0;
  };
  for (std::size_t e = 0; e < shells.sign.size(); ++e) {
    const auto s = static_cast<std::size_t>(shells.shell[e]);
    box[s].add(box_of(mesh.node, mesh.element(static_cast<std::int64_t>(e))));
    balance[s] += looks_outward(e) ? 1 : -1;
  }
  // Shells within the box of the largest that look the other way bound cavities.
  const auto largest = static_cast<std::size_t>(
      std::max_element(volume.begin(), volume.end(), [](double a, double b) { return std::abs(a) < std::abs(b); }) -
      volume.begin());
  const Vec3 margin = 0.25 * box[largest].size();  // room for curved elements, which leave the box of their nodes
  const Box around{box[largest].low - margin, box[largest].high + margin};
  std::vector<char> cavity(shells.size(), 0);
  for (std::size_t s = 0; s < shells.size(); ++s) {
    cavity[s] = s != largest && (balance[s] > 0) != (balance[largest] > 0) && around.holds(box[s].low) &&
                around.holds(box[s].high);
    if (s == largest || cavity[s]) continue;
    fail(Status::err_mesh,
         "the surface encloses several bodies that do not hang together, as those of elements %lld and %lld (counting "
         "from %d): give each its own body; the elements of a cavity look into the cavity",
         names.element(shells.first[std::min(s, largest)]), names.element(shells.first[std::max(s, largest)]),
         mesh.index_base);
  }

  Tally inward;
  for (std::size_t e = 0; e < shells.sign.size(); ++e) {
    const bool wall = cavity[static_cast<std::size_t>(shells.shell[e])] != 0;
    if (looks_outward(e) == !wall) continue;
    inward.add("element %lld (%s)%s", names.element(static_cast<std::int64_t>(e)),
               names.type(static_cast<std::int64_t>(e)), wall ? " on the wall of a cavity" : "");
  }
  if (inward.count == mesh.elements())
    names.refuse(inward,
                 "the normals of all elements look into the body: "
                 "reverse the order of their nodes "
                 "(counter-clockwise seen from outside)");
  names.refuse(inward,
               "flipped element: its normal looks into the body; "
               "reverse the order of its nodes "
               "(counter-clockwise seen from outside)");
}

}  // namespace rollcon
