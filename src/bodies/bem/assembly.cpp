/// Makes matrix and right sides of boundary elements from the integrals' rows.

#include <algorithm>
#include <optional>

#include "bodies/bem/system.hpp"
#include "support/index.hpp"
#include "support/parallel.hpp"

namespace rollcon::bem {
namespace {

/// Calls work(first point, count, thread's buffers) for packs of points, in parallel.
template <class Work>
void for_packs(std::int64_t points, int threads, Work work) {
  struct Buffers {
    std::vector<double> h, g;
  };
  std::vector<Buffers> own(at(std::max(threads, 1)));
  parallel_for((points + lanes - 1) / lanes, 4, threads, [&](std::int64_t pack, int thread) {
    const std::int64_t first = pack * lanes;
    auto& [h, g] = own[static_cast<std::size_t>(thread)];
    work(first, std::min<std::int64_t>(lanes, points - first), h, g);
  });
}

}  // namespace

// Returns the traction over G that the caller prescribed, by traction node and component.
std::vector<double> System::given_tractions(const BodyMesh& loaded) const {
  std::vector<double> given;
  const SurfaceMesh& surface = mesh_.surface;
  for (const FaceLoad& load : loaded.load) {
    const std::vector<Vec3> by_node = load.by_node(surface.node.size());
    for (std::int64_t e = 0; e < surface.elements(); ++e) {
      if (load.tag != surface.tag[at(e)]) continue;
      if (given.empty()) given.assign(3 * at(fans_.size()), 0.0);
      for (std::int64_t k = surface.offset[at(e)]; k < surface.offset[at(e) + 1]; ++k) {
        const auto f = at(fans_.of[at(k)]);
        Vec3 t = load.traction - load.pressure * fans_.normal[f];
        if (!by_node.empty()) t = t + load.turned(by_node[at(surface.connectivity[at(k)])], fans_.normal[f]);
        for (std::size_t c = 0; c < 3; ++c) given[3 * f + c] = t[c] / shear_;
      }
    }
  }
  return given;
}

// Returns the column of G of each traction node with unknown tractions; -1 for the other nodes.
std::vector<std::int32_t> System::needed_fans(std::int32_t& columns) const {
  std::vector<std::int32_t> column(at(fans_.size()), -1);
  columns = 0;
  for (std::size_t f = 0; f < column.size(); ++f) {
    const auto unknown = std::span(unknowns_.traction).subspan(3 * f, 3);
    if (std::any_of(unknown.begin(), unknown.end(), [](std::int32_t k) { return k >= 0; })) column[f] = columns++;
  }
  for (const SpreadReaction& spread : unknowns_.spread)
    for (const auto& [f, part] : spread.others)
      if (column[at(f)] < 0) column[at(f)] = columns++;
  return column;
}

/// Holds the places that the rows of a pack of points go to, column by column.
struct System::PackTarget {
  const std::int32_t* row;  ///< row of (point, component), -1: none
  std::int64_t count;       ///< count of points
  double* matrix;
  std::int64_t n;

  template <class Entry>
  void for_rows(const double* block, Entry entry) const {
    for (std::int64_t i = 0; i < 3; ++i)
      for (std::int64_t p = 0; p < count; ++p)
        if (const std::int32_t r = row[3 * p + i]; r >= 0) entry(r, block[i * lanes + p]);
  }
  void set(const double* block, double factor, std::int64_t column) const {
    for_rows(block, [&](std::int32_t r, double v) { matrix[r + column * n] = factor * v; });
  }
  void add(const double* block, double factor, std::int64_t column) const {
    for_rows(block, [&](std::int32_t r, double v) { matrix[r + column * n] += factor * v; });
  }
};

void System::place(const double* h, const double* g, const std::vector<std::int32_t>& column_of_fan,
                   const PackTarget& to) const {
  for (std::size_t k = 0; k < unknowns_.displacement.size(); ++k)
    if (const std::int32_t column = unknowns_.displacement[k]; column >= 0) to.set(h + k * 3 * lanes, 1, column);
  const auto block_of = [&](std::int32_t fan, int c) {
    return g + (3 * at(column_of_fan[at(fan)]) + at(c)) * 3 * lanes;
  };
  for (std::int32_t f = 0; f < fans_.size(); ++f) {
    if (column_of_fan[at(f)] < 0) continue;
    for (int c = 0; c < 3; ++c) {
      const std::size_t k = 3 * at(f) + at(c);
      // Unknown: traction times size over G, so that all entries are of order one.
      if (const std::int32_t column = unknowns_.traction[k]; column >= 0)
        to.set(block_of(f, c), -1 / fan_size_[at(f)], column);
    }
  }
  for (const SpreadReaction& spread : unknowns_.spread) {
    const std::size_t own = 3 * at(spread.fan) + at(spread.component);
    for (const auto& [f, part] : spread.others)
      to.add(block_of(f, spread.component), -part / fan_size_[at(spread.fan)], unknowns_.traction[own]);
  }
}

std::vector<double> System::own_load(const BodyMesh& loaded, const std::vector<double>& given,
                                     const CollocationBlocks& blocks) const {
  std::vector<CollocationBlocks::Term> terms;
  const auto add = [&](std::size_t k, bool traction, double factor) {
    if (factor != 0) terms.push_back({static_cast<std::int32_t>(k / 3), static_cast<int>(k % 3), traction, factor});
  };
  for (std::size_t k = 0; k < unknowns_.displacement.size(); ++k)
    if (unknowns_.displacement[k] < 0) add(k, false, -loaded.held_value[k / 3][k % 3]);
  for (std::size_t k = 0; k < given.size(); ++k)
    if (unknowns_.traction[k] < 0) add(k, true, given[k]);
  // The reaction of a node held alone comes on top of what is given there.
  for (const SpreadReaction& spread : unknowns_.spread)
    if (const std::size_t k = 3 * at(spread.fan) + at(spread.component); !given.empty()) add(k, true, given[k]);
  return blocks.column(terms);
}

void System::assemble(int threads, double* matrix) {
  const SurfaceMesh& surface = mesh_.surface;
  std::int32_t own_columns = 0;
  const std::vector<std::int32_t> column_of_fan = needed_fans(own_columns);
  std::vector<std::int32_t> g_column(fans_.of.size());
  for (std::size_t k = 0; k < g_column.size(); ++k) g_column[k] = column_of_fan[at(fans_.of[k])];
  const LiftedColumns g_columns = lift_columns(surface, lifted_, g_column, own_columns);

  const std::int64_t n = unknowns_.columns;
  const auto points = static_cast<std::int64_t>(unknowns_.point.size());
  for_packs(points, threads,
            [&](std::int64_t first, std::int64_t count, std::vector<double>& h, std::vector<double>& g) {
              h.resize(at(lifted_.mesh.nodes()) * 9 * lanes);
              g.resize(at(g_columns.size()) * 9 * lanes);
              integrals_.rows({unknowns_.point.data() + first, at(count)}, h.data(), g_columns.of.data(),
                              g_columns.size(), g_columns.size() > 0 ? g.data() : nullptr);
              fold_displacements(lifted_, h.data());
              fold_tractions(g_columns, g.data());
              place(h.data(), g.data(), column_of_fan, {unknowns_.row.data() + 3 * first, count, matrix, n});
            });
}

std::vector<double> System::right_sides(const LoadedSurface& surface, const SurfaceOutline& outline, int threads) {
  const bool on_the_mesh = surface.of_faces();
  std::optional<BoundaryIntegrals> of_layer;  // its tractions are taken as they are, not lifted
  if (!on_the_mesh) of_layer.emplace(surface.layer, poisson_, options_.accuracy);
  const BoundaryIntegrals& integrals = on_the_mesh ? integrals_ : *of_layer;
  const LiftedColumns g_columns =
      on_the_mesh ? columns_of_faces(surface.face, outline) : columns_of_layer(surface.layer);
  const std::int64_t n = unknowns_.columns, columns = g_columns.own;
  std::vector<double> b(at(n * 3 * columns), 0.0);
  const auto points = static_cast<std::int64_t>(unknowns_.point.size());
  for_packs(points, threads, [&](std::int64_t first, std::int64_t count, std::vector<double>&, std::vector<double>& g) {
    g.resize(at(g_columns.size()) * 9 * lanes);
    CollocationPoint pack[lanes];
    for (std::int64_t p = 0; p < count; ++p) {
      pack[p] = unknowns_.point[at(first + p)];
      if (!on_the_mesh) pack[p].node = pack[p].element = -1;
    }
    integrals.rows({pack, at(count)}, nullptr, g_columns.of.data(), g_columns.size(), g.data());
    fold_tractions(g_columns, g.data());
    const std::int32_t* row = unknowns_.row.data() + 3 * first;
    for (std::int64_t k = 0; k < 3 * columns; ++k)
      for (std::int64_t i = 0; i < 3; ++i)
        for (std::int64_t p = 0; p < count; ++p)
          if (row[3 * p + i] >= 0) b[at(row[3 * p + i] + k * n)] = g[at((3 * k + i) * lanes + p)] / shear_;
  });
  if (of_layer) statistics_.kernel_evaluations += of_layer->kernel_evaluations();
  return b;
}

LiftedColumns System::columns_of_faces(std::span<const std::int64_t> face, const SurfaceOutline& outline) const {
  std::vector<std::int32_t> column_of_node(at(surface_.nodes()), -1);
  for (std::size_t k = 0; k < outline.column.size(); ++k)
    column_of_node[at(outline.column[k])] = static_cast<std::int32_t>(k);
  std::vector<std::int32_t> g_column(surface_.connectivity.size(), -1);
  for (const std::int64_t e : face)
    for (std::int64_t k = surface_.offset[at(e)]; k < surface_.offset[at(e) + 1]; ++k)
      g_column[at(k)] = column_of_node[at(surface_.connectivity[at(k)])];
  return lift_columns(surface_, lifted_, g_column, static_cast<std::int64_t>(outline.column.size()));
}

}  // namespace rollcon::bem
