#include "contact/operators/lattice/lattice_operator.hpp"

#include <algorithm>
#include <cmath>
#include <mutex>

#include "contact/operators/lattice/convolution.hpp"
#include "contact/operators/lattice/cut_hats.hpp"
#include "support/error.hpp"

namespace rollcon {

namespace {

/// Describes a term of a node's slip: a displacement (or the characteristic scheme's own slip) this far off.
struct Term {
  std::int64_t i, j;
  double factor;
};

/// Returns the place with all cells that is nearest to the middle.
std::int64_t inner_place(const Lattice& lattice) {
  const std::int64_t nx = lattice.nx;
  std::int64_t best = -1, least = 0;
  for (std::int64_t at = 0; at < nx * lattice.ny; ++at) {
    if (lattice.cells[static_cast<std::size_t>(at)] != Lattice::all) continue;
    const std::int64_t i = at % nx - nx / 2, j = at / nx - lattice.ny / 2, far = i * i + j * j;
    if (best < 0 || far < least) best = at, least = far;
  }
  return best;
}

std::vector<Term> interior_stencil(const Lattice& lattice, const SparseRows& convection) {
  const std::int64_t nx = lattice.nx, middle = inner_place(lattice);
  std::vector<std::int64_t> place(static_cast<std::size_t>(lattice.frame_nodes()), -1);
  for (std::size_t at = 0; at < lattice.node.size(); ++at)
    if (lattice.node[at] >= 0) place[static_cast<std::size_t>(lattice.node[at])] = static_cast<std::int64_t>(at);
  const auto row = static_cast<std::size_t>(lattice.node[static_cast<std::size_t>(middle)]);
  std::vector<Term> terms;
  for (auto k = static_cast<std::size_t>(convection.start[row]);
       k < static_cast<std::size_t>(convection.start[row + 1]); ++k) {
    const std::int64_t at = place[static_cast<std::size_t>(convection.column[k])];
    terms.push_back({at % nx - middle % nx, at / nx - middle / nx, convection.value[k]});
  }
  return terms;
}

/// Returns the largest offset of any term along either axis.
std::int64_t margin_of(const std::vector<Term>& terms) {
  std::int64_t margin = 0;
  for (const Term& t : terms) margin = std::max({margin, std::abs(t.i), std::abs(t.j)});
  return margin;
}

}  // namespace

struct LatticeOperator::Shared {
  Lattice lattice;
  std::shared_ptr<const TranslationKernel> kernel;
  double delta;
  SparseRows convection;
  std::vector<Term> slip;  ///< terms of the slip of a node in the middle
  LatticeEntries entries;
  Convolution convolution;
  CutHats cut;
  LatticeInfluence influence;

  Shared(Lattice&& grid, std::shared_ptr<const TranslationKernel>&& bodies, double step, SparseRows&& rows,
         bool displacements)
      : lattice(std::move(grid)),
        kernel(std::move(bodies)),
        delta(step),
        convection(std::move(rows)),
        slip(delta != 0 ? std::vector<Term>{{0, 0, 1.0}} : interior_stencil(lattice, convection)),
        entries(lattice, *kernel, delta, Hat::whole, Hat::whole, margin_of(slip)),
        convolution(lattice, entries, hat_pieces(lattice).front()),
        cut(lattice, *kernel, delta),
        influence{lattice, *kernel, displacements} {
    LatticeEntries::Workspace w;
    double* normal_row[3][3] = {};
    for (int k = 0; k < 3; ++k) normal_row[2][k] = &entry_[2][k];
    entries.row(0, 0, 1, normal_row, w);
  }
  double own(int r, int c) const {
    if (r < 2) std::call_once(measured_, [this] { measure_slip(); });
    return entry_[r][c];
  }
  double slip_norm(int r) const {
    std::call_once(measured_, [this] { measure_slip(); });
    return norm_[r];
  }

 private:
  void measure_slip() const;
  mutable std::once_flag measured_;  ///< rows of slip are measured when they are first needed
  mutable double entry_[3][3] = {}, norm_[2] = {};
};

struct LatticeOperator::Workspace {
  Convolution::Workspace convolution;
  CutHats::Workspace cut;
  std::vector<double> displacement[2];  ///< displacements at all nodes, upwind schemes only

  explicit Workspace(const Shared& shared) : convolution(shared.convolution) {
    if (shared.delta == 0)
      for (auto& w : displacement) w.resize(static_cast<std::size_t>(shared.lattice.frame_nodes()));
  }
  std::size_t bytes() const {
    return convolution.bytes() + (cut ? cut->bytes() : 0) +
           (displacement[0].size() + displacement[1].size()) * sizeof(double);
  }
};

/// Measures own entries and norms of the rows of slip of a node in the middle.
void LatticeOperator::Shared::measure_slip() const {
  const std::int64_t margin = margin_of(slip);
  // Offsets reach from the middle node to all others, and by the margin around them.
  const std::int64_t low_x = lattice.nx / 2 - (lattice.nx - 1), low_y = lattice.ny / 2 - (lattice.ny - 1);
  const std::int64_t width = lattice.nx + 2 * margin, height = lattice.ny + 2 * margin;
  std::vector<double> ring[3][3];
  double sum[2] = {};
  const std::int64_t lines = 2 * margin + 1;  // lines held at a time
  for (int r = 0; r < 2; ++r)
    for (int k = 0; k < 3; ++k) ring[r][k].resize(static_cast<std::size_t>(width * lines));
  LatticeEntries::Workspace w;
  for (std::int64_t line = 0; line < height; ++line) {
    double* entry_row[3][3] = {};
    for (int r = 0; r < 2; ++r)
      for (int k = 0; k < 3; ++k) entry_row[r][k] = ring[r][k].data() + (line % lines) * width;
    entries.row(low_y - margin + line, low_x - margin, width, entry_row, w);
    if (line < 2 * margin) continue;
    const std::int64_t j = low_y + line - 2 * margin;  // line that has its margins by now
    for (std::int64_t i = low_x; i < low_x + lattice.nx; ++i)
      for (int r = 0; r < 2; ++r)
        for (int k = 0; k < 3; ++k) {
          double value = 0;
          for (const Term& t : slip) {
            const std::int64_t at = (line - margin + t.j) % lines;
            value += t.factor * ring[r][k][static_cast<std::size_t>(at * width + i + t.i - low_x + margin)];
          }
          if (k < 2) sum[r] += value * value;
          if (i == 0 && j == 0) entry_[r][k] = value;
        }
  }
  for (int r = 0; r < 2; ++r) norm_[r] = std::sqrt(sum[r]);
}

LatticeOperator::LatticeOperator(Lattice lattice, std::shared_ptr<const TranslationKernel> kernel, double delta,
                                 SparseRows convection, bool displacements) {
  if (!lattice.has_inner_node())
    fail(Status::err_internal, "a lattice of %lld x %lld nodes has no inner node", static_cast<long long>(lattice.nx),
         static_cast<long long>(lattice.ny));
  nodes = lattice.frame_nodes();
  coupled = kernel->couples();
  normal = tangential = true;
  shared_ =
      std::make_unique<Shared>(std::move(lattice), std::move(kernel), delta, std::move(convection), displacements);
  idle_.push_back(std::make_unique<Workspace>(*shared_));
}

LatticeOperator::~LatticeOperator() = default;

std::unique_ptr<LatticeOperator::Workspace> LatticeOperator::take_workspace() const {
  {
    const std::lock_guard lock(idle_lock_);
    if (!idle_.empty()) {
      std::unique_ptr<Workspace> work = std::move(idle_.back());
      idle_.pop_back();
      return work;
    }
  }
  return std::make_unique<Workspace>(*shared_);
}

void LatticeOperator::give_back(std::unique_ptr<Workspace> work) const {
  const std::lock_guard lock(idle_lock_);
  idle_.push_back(std::move(work));
}

void LatticeOperator::apply(const double* const (&lambda)[3], double* const (&image)[3]) const {
  ++applications_;
  std::unique_ptr<Workspace> work = take_workspace();
  double* target[3] = {image[0], image[1], image[2]};
  const bool upwind = shared_->delta == 0;
  for (int r = 0; r < 2; ++r)
    if (upwind && image[r] != nullptr) target[r] = work->displacement[r].data();
  shared_->convolution.apply(lambda, target, work->convolution);
  shared_->cut.add(lambda, target, work->cut);
  for (double* values : target)
    if (values != nullptr)
      for (const std::int32_t k : shared_->lattice.loose) values[k] = 0;
  const SparseRows& rows = shared_->convection;
  for (int r = 0; r < 2; ++r) {
    if (!upwind || image[r] == nullptr) continue;
    const double* displacement = work->displacement[r].data();
    for (std::size_t k = 0; k + 1 < rows.start.size(); ++k) {
      double sum = 0;
      for (auto m = static_cast<std::size_t>(rows.start[k]); m < static_cast<std::size_t>(rows.start[k + 1]); ++m)
        sum += rows.value[m] * displacement[rows.column[m]];
      image[r][k] = sum;
    }
  }
  give_back(std::move(work));
}

void LatticeOperator::images(Components wanted, Components columns, std::span<const std::int32_t> /*at*/,
                             const std::vector<double> (&lambda)[3], std::vector<double> (&image)[3]) const {
  const double* from[3] = {};
  double* to[3] = {};
  for (int c = columns.first; c <= columns.last; ++c)
    if (coupled || (c == 2 ? wanted.normal() : wanted.slip())) from[c] = lambda[c].data();
  for (int r = wanted.first; r <= wanted.last; ++r) to[r] = image[r].data();
  apply({from[0], from[1], from[2]}, {to[0], to[1], to[2]});
}

double LatticeOperator::own(int r, int c, std::size_t /*k*/) const {
  return shared_->own(r, c);
}
double LatticeOperator::slip_norm(int r, std::size_t /*k*/) const {
  return shared_->slip_norm(r);
}
const LatticeInfluence& LatticeOperator::influence() const {
  return shared_->influence;
}

std::size_t LatticeOperator::bytes() const {
  const SparseRows& rows = shared_->convection;
  std::size_t work = 0;
  {
    const std::lock_guard lock(idle_lock_);
    for (const auto& w : idle_) work += w->bytes();
  }
  return shared_->convolution.bytes() + shared_->cut.bytes() + work +
         shared_->lattice.node.size() * (sizeof(std::int32_t) + 1) +
         rows.value.size() * (sizeof(double) + sizeof(std::int32_t));
}

}  // namespace rollcon
