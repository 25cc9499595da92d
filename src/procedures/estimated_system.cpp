#include "procedures/estimated_system.hpp"

#include <algorithm>
#include <cmath>

#include "support/index.hpp"

namespace rollcon {
namespace {

constexpr int krylov_space = 60, plain_krylov_space = 200, plain_iterations = 1000;
constexpr int stale = 30;  // iterations beyond which the next system is factorised again

struct Scaling final : LinearOperator {
  const std::vector<double>* factor = nullptr;  ///< null: the identity
  std::size_t n = 0;
  void apply(const double* x, double* y) override {
    for (std::size_t i = 0; i < n; ++i) y[i] = factor ? (*factor)[i] * x[i] : x[i];
  }
};

}  // namespace

EstimatedSystem::EstimatedSystem(const Problem& problem, const Frame& frame,
                                 const Compliance& compliance)
    : problem_(problem), frame_(frame), compliance_(compliance) {}

// Tangential rows of the compliance; the normal ones are in the operators already.
void EstimatedSystem::assemble() {
  if (!shift_[0][0].empty()) return;
  const std::int64_t n = problem_.nodes;
  ComplianceBlock out;
  out.stride = n;
  for (int r = 0; r < 2; ++r)
    for (int c = 0; c < (problem_.op.coupled ? 3 : 2); ++c) {
      shift_[r][c].resize(n, n);
      out.a[r][c] = shift_[r][c].data();
    }
  compliance_.block({frame_.x, frame_.y}, out);
  rs_.assign(at(n), 0.0);
  double mean = 0;
  std::int64_t counted = 0;
  for (std::int64_t k = 0; k < n; ++k) {
    const double own = std::abs(shift_[0][0].row(k)[k]) + std::abs(shift_[1][1].row(k)[k]);
    if (!problem_.used[at(k)] || !(own > 0)) continue;
    rs_[at(k)] = 2 / own;
    mean += rs_[at(k)];
    ++counted;
  }
  mean = counted > 0 ? mean / static_cast<double>(counted) : 1;
  for (double& r : rs_)
    if (r == 0) r = mean;
}

// Friction of a sliding pair follows its pressure: its column is that of the pressure, and of the
// friction that goes with it.
double EstimatedSystem::row_entry(const Step& step, const double* const (&row)[3],
                                  std::int32_t node, int component) const {
  const auto value = [&](int c) { return row[c] ? row[c][node] : 0.0; };
  if (component < 2 || step.state[at(node)] == PairState::stick) return value(component);
  const TangentialLaw& law = step.law[at(node)];
  return value(2) - law.own[0][2] * value(0) - law.own[1][2] * value(1);
}

void EstimatedSystem::gather(const Step& step, std::span<const std::int32_t> active) {
  assemble();
  const Problem& p = problem_;
  unknown_.clear();
  key_.clear();
  double rs = 0, rn = 0, area = 0;
  for (const std::int32_t k : active) {
    for (std::int32_t c = step.state[at(k)] == PairState::stick ? 0 : 2; c < 3; ++c) {
      unknown_.push_back({k, c});
      key_.push_back(3 * static_cast<std::int64_t>(k) + c);
    }
    rs += p.rt[at(k)];
    rn += p.rn[at(k)];
    area += std::abs(p.weight[at(k)]);
  }
  const double count = std::max<double>(1, static_cast<double>(active.size()));
  motion_.clear();
  for (const int m : {xi1, xi2, spin, approach}) {
    if (!p.by_force[at(m)]) continue;
    const double unit = m == spin ? p.length : 1;
    motion_.push_back({m, (m == approach ? rn : rs) / count * unit, 1 / (area * unit)});
    key_.push_back(-1 - m);
  }
  const std::int64_t nu = static_cast<std::int64_t>(unknown_.size());
  const std::int64_t n = nu + static_cast<std::int64_t>(motion_.size());
  matrix_.resize(n, n);
  for (std::int64_t i = 0; i < nu; ++i) {
    const std::int32_t k = unknown_[at(i)].node;
    const int r = unknown_[at(i)].component;
    const double scale = r == 2 ? p.rn[at(k)] : rs_[at(k)];
    const double* row[3];
    for (int c = 0; c < 3; ++c) {
      const RowMatrix<double>& block = r == 2 ? p.op.block[2][c] : shift_[r][c];
      row[c] = block.empty() ? nullptr : block.row(k);
    }
    double* out = matrix_.row(i);
    for (std::int64_t j = 0; j < nu; ++j)
      out[j] = scale * row_entry(step, row, unknown_[at(j)].node, unknown_[at(j)].component);
    for (std::size_t m = 0; m < motion_.size(); ++m) {
      double column = 0;
      if (r == 2)
        column = motion_[m].which == approach ? p.closing(at(k)) : 0;
      else
        column = step.reach[at(k)] * p.slip_column(motion_[m].which, at(k))[at(r)];
      out[nu + static_cast<std::int64_t>(m)] = scale * column / motion_[m].scale;
    }
  }
  for (std::size_t m = 0; m < motion_.size(); ++m) {
    double* out = matrix_.row(nu + static_cast<std::int64_t>(m));
    std::fill(out, out + n, 0.0);
    for (std::int64_t j = 0; j < nu; ++j) {
      const std::int32_t k = unknown_[at(j)].node;
      const std::array<double, 3> load = p.load_row(motion_[m].which, at(k));
      double entry = load[at(unknown_[at(j)].component)];
      if (step.state[at(k)] == PairState::slip)
        entry -= step.law[at(k)].own[0][2] * load[0] + step.law[at(k)].own[1][2] * load[1];
      out[j] = motion_[m].per_load * entry;
    }
  }
}

void EstimatedSystem::right_side(const Step& step, const Point& z, std::vector<double>& b) const {
  const Problem& p = problem_;
  b.resize(at(size()));
  const double delta = p.by_force[approach] ? 0 : z.motion[approach];
  for (std::size_t i = 0; i < unknown_.size(); ++i) {
    const auto k = at(unknown_[i].node);
    const int r = unknown_[i].component;
    b[i] = r == 2 ? p.rn[k] * p.rigid_gap(k, delta) : rs_[k] * step.target[r][k];
  }
  for (std::size_t m = 0; m < motion_.size(); ++m)
    b[unknown_.size() + m] = motion_[m].per_load * p.value[at(motion_[m].which)];
}

void EstimatedSystem::start(const Point& z, std::vector<double>& x) const {
  x.resize(at(size()));
  for (std::size_t i = 0; i < unknown_.size(); ++i)
    x[i] = z.lambda[unknown_[i].component][at(unknown_[i].node)];
  for (std::size_t m = 0; m < motion_.size(); ++m)
    x[unknown_.size() + m] = z.motion[at(motion_[m].which)] * motion_[m].scale;
}

void EstimatedSystem::apply(const double* x, double* y) {
  multiply(matrix_.data(), matrix_.rows(), matrix_.rows(), x, 0, y);
}

bool EstimatedSystem::solve(const std::vector<double>& b, double eta, const LinearSolver& choice,
                            std::vector<double>& x) {
  const std::int64_t n = size();
  x.resize(at(n));
  const bool direct = choice.method == LinearMethod::lu ||
                      (choice.method == LinearMethod::automatic && n <= LinearSolver::direct_limit);
  if (!direct) {
    const bool plain = choice.preconditioner == Preconditioner::none ||
                       choice.preconditioner == Preconditioner::diagonal;
    Scaling scaling;
    scaling.n = at(n);
    if (choice.preconditioner == Preconditioner::diagonal) {
      diagonal_.resize(at(n));
      for (std::int64_t i = 0; i < n; ++i) {
        const double own = matrix_.row(i)[i];
        diagonal_[at(i)] = own != 0 ? 1 / own : 1;
      }
      scaling.factor = &diagonal_;
    }
    const int space =
        plain ? static_cast<int>(std::min<std::int64_t>(n, plain_krylov_space)) : krylov_space;
    gmres_.reserve(n + n / 10, space);
    for (int attempt = 0; attempt < 2; ++attempt) {
      const bool fresh = !plain && (attempt == 1 || !kept_.valid());
      if (fresh) {
        ++factorizations;
        if (!kept_.factor(key_, matrix_.data())) break;
      }
      if (!plain) kept_.match(key_);
      LinearOperator& precondition = plain ? static_cast<LinearOperator&>(scaling) : kept_;
      const GmresReport report = gmres_.solve(n, *this, precondition, b.data(), x.data(), eta,
                                              plain ? plain_iterations : krylov_space);
      iterations += report.iterations;
      if (report.iterations > stale) kept_.forget();
      if (report.converged) return true;
      if (plain || fresh) break;
    }
  }
  std::copy(matrix_.data(), matrix_.data() + n * n, lu_.prepare(n));
  ++factorizations;
  if (!lu_.factor()) return false;
  std::copy(b.begin(), b.begin() + n, x.begin());
  lu_.solve(x.data());
  return std::all_of(x.begin(), x.end(), [](double v) { return std::isfinite(v); });
}

void EstimatedSystem::scatter(const Step& step, const std::vector<double>& x, Point& next) const {
  for (std::size_t i = 0; i < unknown_.size(); ++i) {
    const auto k = at(unknown_[i].node);
    next.lambda[unknown_[i].component][k] = x[i];
    if (step.state[k] != PairState::slip) continue;
    for (int c = 0; c < 2; ++c) next.lambda[c][k] = -step.law[k].own[c][2] * x[i];
  }
  for (std::size_t m = 0; m < motion_.size(); ++m)
    next.motion[at(motion_[m].which)] = x[unknown_.size() + m] / motion_[m].scale;
}

void EstimatedSystem::shift(Point& z) {
  assemble();
  const std::int64_t n = problem_.nodes;
  for (int r = 0; r < 2; ++r) {
    z.shift[r].assign(at(n), 0.0);
    for (int c = 0; c < 3; ++c)
      if (!shift_[r][c].empty())
        multiply(shift_[r][c].data(), n, n, z.lambda[c].data(), 1, z.shift[r].data());
  }
}

std::size_t EstimatedSystem::bytes() const {
  std::size_t sum = matrix_.bytes() + lu_.bytes() + kept_.bytes() + gmres_.bytes();
  for (const auto& row : shift_)
    for (const auto& block : row) sum += block.bytes();
  return sum;
}

}  // namespace rollcon
