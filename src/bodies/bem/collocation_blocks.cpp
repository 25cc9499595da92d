#include "bodies/bem/collocation_blocks.hpp"

#include <algorithm>
#include <array>
#include <numeric>

#include "mesh/shape.hpp"
#include "support/index.hpp"
#include "support/parallel.hpp"

namespace rollcon::bem {
namespace {

constexpr std::size_t block_size = 9 * lanes;

}  // namespace

template <class Item>
void CollocationBlocks::Lists<Item>::build(std::size_t lists, const std::vector<std::pair<std::int32_t, Item>>& from) {
  start.assign(lists + 1, 0);
  for (const auto& [k, what] : from) ++start[at(k) + 1];
  std::partial_sum(start.begin(), start.end(), start.begin());
  std::vector<std::int64_t> next(start.begin(), start.end() - 1);
  item.resize(from.size());
  for (const auto& [k, what] : from) item[at(next[at(k)]++)] = what;
}

/// Holds columns as sums of parts of blocks of integrals.
struct CollocationBlocks::Gathered {
  struct Piece {
    std::int64_t column;
    std::size_t entry;  ///< place of the block's entry of component 0, lane 0
    bool traction;
    double factor;
  };
  std::vector<Piece> piece;
  std::vector<std::int32_t> element, node, entry;  ///< in the order of their columns
};

CollocationBlocks::CollocationBlocks(const BodyMesh& mesh, const TractionNodes& fans, const LiftedSurface& lifted,
                                     const BoundaryIntegrals& integrals, const Unknowns& unknowns,
                                     const std::vector<double>& fan_size, int threads)
    : lifted_(lifted), integrals_(integrals), unknowns_(unknowns), threads_(threads) {
  row_point_.assign(at(unknowns.columns), 0);
  for (std::size_t k = 0; k < unknowns.row.size(); ++k)
    if (unknowns.row[k] >= 0) row_point_[at(unknowns.row[k])] = static_cast<std::int32_t>(k);

  std::vector<std::pair<std::int32_t, Term>> terms;
  for (std::size_t k = 0; k < unknowns.displacement.size(); ++k)
    if (unknowns.displacement[k] >= 0)
      terms.push_back(
          {unknowns.displacement[k], {static_cast<std::int32_t>(k / 3), static_cast<int>(k % 3), false, 1}});
  // Tractions times size over G are the unknowns, so that all entries are of order one.
  for (std::size_t k = 0; k < unknowns.traction.size(); ++k)
    if (unknowns.traction[k] >= 0)
      terms.push_back({unknowns.traction[k],
                       {static_cast<std::int32_t>(k / 3), static_cast<int>(k % 3), true, -1 / fan_size[k / 3]}});
  for (const SpreadReaction& spread : unknowns.spread)
    for (const auto& [f, part] : spread.others)
      terms.push_back({unknowns.traction[3 * at(spread.fan) + at(spread.component)],
                       {f, spread.component, true, -part / fan_size[at(spread.fan)]}});
  terms_.build(at(unknowns.columns), terms);

  std::vector<std::pair<std::int32_t, Part>> moved, tractions;
  const std::int64_t nodes = lifted.mesh.nodes();
  for (std::int32_t k = 0; k < nodes; ++k) {
    if (k < lifted.nodes) {
      moved.push_back({k, {k, 1}});
      continue;
    }
    for (const Part& part : lifted.parts_of(k)) moved.push_back({part.of, {k, part.value}});
  }
  lifted_of_.build(at(lifted.nodes), moved);

  std::vector<std::pair<std::int32_t, std::int32_t>> around;
  element_.resize(lifted.mesh.connectivity.size());
  for (std::int32_t e = 0; e < lifted.mesh.elements(); ++e) {
    const std::span<const std::int32_t> own = mesh.surface.element(e), all = lifted.mesh.element(e);
    const std::int32_t* fan = fans.of.data() + mesh.surface.offset[at(e)];
    const auto first = static_cast<std::int32_t>(lifted.mesh.offset[at(e)]);
    for (std::size_t k = 0; k < all.size(); ++k) {
      const auto entry = first + static_cast<std::int32_t>(k);
      element_[at(entry)] = e;
      around.push_back({all[k], e});
      if (k < own.size()) {
        tractions.push_back({fan[k], {entry, 1}});
        continue;
      }
      for (const std::size_t end : {k - own.size(), (k - own.size() + 1) % own.size()})
        tractions.push_back({fan[end], {entry, 0.5}});
    }
  }
  entries_.build(at(fans.size()), tractions);
  elements_.build(at(nodes), around);
  h_column_.assign(at(nodes), -1);
  g_column_.assign(element_.size(), -1);
  slot_.assign(unknowns.point.size(), -1);
  taken_.assign(at(lifted.mesh.elements()), 0);
}

void CollocationBlocks::gather(std::span<const Term> terms, std::int64_t column, Gathered& to) const {
  const auto add = [&](std::vector<std::int32_t>& columns, std::vector<std::int32_t>& column_of, std::int32_t what,
                       const Term& term, double part) {
    if (column_of[at(what)] < 0) {
      column_of[at(what)] = static_cast<std::int32_t>(columns.size());
      columns.push_back(what);
    }
    const std::size_t entry = at(column_of[at(what)]) * block_size + at(term.component) * 3 * lanes;
    to.piece.push_back({column, entry, term.traction, term.factor * part});
  };
  const auto take = [&](std::int32_t e) {
    if (!std::exchange(taken_[at(e)], std::uint8_t{1})) to.element.push_back(e);
  };
  for (const Term& term : terms) {
    for (const Part& part : term.traction ? entries_[term.of] : lifted_of_[term.of]) {
      if (term.traction) {
        take(element_[at(part.of)]);
        add(to.entry, g_column_, part.of, term, part.value);
      } else {
        for (const std::int32_t e : elements_[part.of]) take(e);
        add(to.node, h_column_, part.of, term, part.value);
      }
    }
  }
}

void CollocationBlocks::find_totals() const {
  const std::vector<CollocationPoint>& point = unknowns_.point;
  std::vector<double> total(9 * point.size());
  parallel_for(static_cast<std::int64_t>((point.size() + lanes - 1) / lanes), 4, threads_, [&](std::int64_t pack, int) {
    const std::size_t first = at(pack) * lanes, count = std::min<std::size_t>(lanes, point.size() - first);
    double sum[block_size];
    integrals_.sums({point.data() + first, count}, sum);
    for (std::size_t p = 0; p < count; ++p)
      for (std::size_t i = 0; i < 9; ++i) total[9 * (first + p) + i] = sum[i * lanes + p];
  });
  total_ = std::move(total);
}

void CollocationBlocks::evaluate(std::span<const std::int32_t> rows, Gathered& columns, double* to) const {
  struct Target {
    std::int32_t point;
    std::array<std::int64_t, 3> row{-1, -1, -1};
  };
  std::vector<Target> target;
  for (std::size_t r = 0; r < rows.size(); ++r) {
    const std::int32_t point = row_point_[at(rows[r])] / 3, component = row_point_[at(rows[r])] % 3;
    if (slot_[at(point)] < 0) {
      slot_[at(point)] = static_cast<std::int32_t>(target.size());
      target.push_back({point});
    }
    target[at(slot_[at(point)])].row[at(component)] = static_cast<std::int64_t>(r);
  }
  for (const Target& t : target) slot_[at(t.point)] = -1;
  std::sort(columns.element.begin(), columns.element.end());
  const BoundaryIntegrals::Columns over{columns.element, h_column_.data(),
                                        static_cast<std::int64_t>(columns.node.size()), g_column_.data(),
                                        static_cast<std::int64_t>(columns.entry.size())};
  struct Buffers {
    std::vector<double> h, g;
  };
  std::vector<Buffers> own(at(std::max(threads_, 1)));
  const auto work = [&](std::int64_t pack, int thread) {
    std::vector<double>&h = own[at(thread)].h, &g = own[at(thread)].g;
    h.resize(columns.node.size() * block_size);
    g.resize(columns.entry.size() * block_size);
    const std::size_t first = at(pack) * lanes, count = std::min<std::size_t>(lanes, target.size() - first);
    CollocationPoint point[lanes];
    for (std::size_t p = 0; p < count; ++p) point[p] = unknowns_.point[at(target[first + p].point)];
    integrals_.rows_over({point, count}, over, h.empty() ? nullptr : h.data(), g.empty() ? nullptr : g.data());
    for (std::size_t p = 0; p < count && !h.empty(); ++p) {
      const double* total = total_.data() + 9 * at(target[first + p].point);
      const auto subtract = [&](std::int32_t node, double part) {
        if (const std::int32_t column = h_column_[at(node)]; column >= 0)
          for (std::size_t i = 0; i < 9; ++i) h[at(column) * block_size + i * lanes + p] -= part * total[i];
      };
      if (point[p].node >= 0) {
        subtract(point[p].node, 1);
        continue;
      }
      Shape shape;
      evaluate_shape(lifted_.mesh.type[at(point[p].element)], point[p].xi, point[p].eta, shape);
      const auto nodes = lifted_.mesh.element(point[p].element);
      for (std::size_t k = 0; k < nodes.size(); ++k) subtract(nodes[k], shape.value[k]);
    }
    for (const Gathered::Piece& piece : columns.piece) {
      const double* from = (piece.traction ? g : h).data() + piece.entry;
      double* column = to + at(piece.column) * rows.size();
      for (std::size_t p = 0; p < count; ++p)
        for (std::size_t i = 0; i < 3; ++i)
          if (const std::int64_t r = target[first + p].row[i]; r >= 0) column[r] += piece.factor * from[i * lanes + p];
    }
  };
  if (!columns.node.empty() && total_.empty()) find_totals();
  std::fill_n(to, rows.size() * at(columns.piece.empty() ? 0 : columns.piece.back().column + 1), 0.0);
  parallel_for(static_cast<std::int64_t>((target.size() + lanes - 1) / lanes), 4, threads_, work);
  for (const std::int32_t k : columns.node) h_column_[at(k)] = -1;
  for (const std::int32_t k : columns.entry) g_column_[at(k)] = -1;
  for (const std::int32_t e : columns.element) taken_[at(e)] = 0;
}

void CollocationBlocks::block(std::span<const std::int32_t> rows, std::span<const std::int32_t> columns,
                              double* to) const {
  Gathered gathered;
  for (std::size_t j = 0; j < columns.size(); ++j) gather(terms_[columns[j]], static_cast<std::int64_t>(j), gathered);
  evaluate(rows, gathered, to);
}

std::vector<double> CollocationBlocks::column(std::span<const Term> terms) const {
  std::vector<double> result(row_point_.size(), 0.0);
  std::vector<std::int32_t> rows(row_point_.size());
  std::iota(rows.begin(), rows.end(), 0);
  Gathered gathered;
  gather(terms, 0, gathered);
  if (!terms.empty()) evaluate(rows, gathered, result.data());
  return result;
}

}  // namespace rollcon::bem
