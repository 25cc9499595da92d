#include "procedures/contact_equations.hpp"

#include <algorithm>
#include <cmath>

#include "support/index.hpp"

namespace rollcon {

void ContactEquations::take(const Step& step) {
  given_ = step.given;
  unknown_.clear();
  node_.clear();
  first_.assign(1, 0);
  for (std::int64_t k = 0; k < problem_.nodes; ++k) {
    if (step.state[at(k)] < PairState::stick) continue;
    add(step, k);
    node_.push_back(k);
    first_.push_back(unknown_.size());
  }
  take_motions();
  contact_matrix(images_.blocks(), contact_);
}

namespace {

// Says whether the row along the slip has the node's own tractions alone, so that it gives the one along the slip.
bool along_is_given(const TangentialLaw& law) {
  constexpr double rounding = 1e-12;
  const double* e = law.direction;
  double rest = 0;
  for (int c = 0; c < 2; ++c) {
    rest = std::max(rest, std::abs(e[0] * law.slip[0][c] + e[1] * law.slip[1][c]));
    rest = std::max(rest, std::abs(e[0] * law.own[0][c] + e[1] * law.own[1][c] - e[c]));
  }
  return rest <= rounding && std::hypot(e[0], e[1]) > 0.5;
}

}  // namespace

// Adds a component of the traction, and that component of the law's rows.
void ContactEquations::add_row(std::int64_t k, double q0, double q1, const TangentialLaw& law) {
  Unknown& row = unknown_.emplace_back();
  row.node = k;
  row.direction = row.traction = {q0, q1, 0};
  for (std::size_t c = 0; c < 2; ++c) row.image[c] = problem_.rt[at(k)] * (q0 * law.slip[0][c] + q1 * law.slip[1][c]);
  for (std::size_t c = 0; c < 3; ++c) row.own[c] = q0 * law.own[0][c] + q1 * law.own[1][c];
}

void ContactEquations::add(const Step& step, std::int64_t k) {
  const double rn = problem_.rn[at(k)];
  const TangentialLaw& law = step.law[at(k)];
  const bool slides = step.state[at(k)] == PairState::slip;
  const bool slip_counts = law.slip[0][0] != 0 || law.slip[0][1] != 0 || law.slip[1][1] != 0;
  Unknown normal{.node = k, .direction = {0, 0, 1}, .traction = {0, 0, 1}, .image = {0, 0, rn}};
  if (images_.kind() == Tangential::none) {
    unknown_.push_back(normal);
    return;
  }
  if (!slides && images_.kind() == Tangential::shift) {
    for (std::size_t c = 0; c < 2; ++c) {
      Unknown& stick = unknown_.emplace_back();
      stick.node = k;
      stick.direction[c] = stick.traction[c] = 1;
      stick.image[c] = rn;
      stick.reach = step.reach[at(k)];
    }
  } else if (slides && !slip_counts) {
    for (std::size_t c = 0; c < 2; ++c) normal.traction[c] = -law.own[c][2];
  } else if (slides && along_is_given(law)) {
    const double e0 = law.direction[0], e1 = law.direction[1];
    const double along = e0 * law.own[0][2] + e1 * law.own[1][2];
    add_row(k, -e1, e0, law);
    normal.traction[0] = -along * e0;
    normal.traction[1] = -along * e1;
  } else {
    add_row(k, 1, 0, law);
    add_row(k, 0, 1, law);
  }
  unknown_.push_back(normal);
}

// Takes motions as the tractions that they cause at a pair, and loads as their means over the pairs.
void ContactEquations::take_motions() {
  const Problem& p = problem_;
  double rn = 0, rt = 0, area = 0;
  for (const std::int64_t k : node_) {
    rn += p.rn[at(k)];
    rt += p.rt[at(k)];
    area += std::abs(p.weight[at(k)]);
  }
  const double count = std::max<double>(1, static_cast<double>(node_.size()));
  motion_.clear();
  for (const int m : {xi1, xi2, spin, tilt1, tilt2, approach}) {
    if (!given_.by_force[at(m)] || (!changes_gap(m) && images_.kind() == Tangential::none)) continue;
    const double unit = m >= spin ? p.length : 1;
    motion_.push_back({m, (changes_gap(m) ? rn : rt) / count * unit, 1 / (area * unit)});
  }
}

double ContactEquations::motion_entry(const Unknown& row, const Motion& motion) const {
  const std::size_t k = at(row.node);
  if (row.direction[2] != 0) return row.image[2] * problem_.closing(motion.which, k) / motion.scale;
  const auto slip = problem_.slip_column(motion.which, k);
  const double sum = row.image[0] * slip[0] + row.image[1] * slip[1];
  return (images_.kind() == Tangential::shift ? row.reach : 1) * sum / motion.scale;
}

double ContactEquations::load_entry(const Motion& motion, const Unknown& column) const {
  const auto load = problem_.load_row(motion.which, at(column.node));
  double sum = 0;
  for (std::size_t c = 0; c < 3; ++c) sum += load[c] * column.traction[c];
  return motion.per_load * sum;
}

void ContactEquations::contact_matrix(const Blocks& blocks, RowMatrix<double>& out) const {
  const std::size_t na = node_.size(), nu = unknown_.size(), n = at(contact_size());
  out.resize(contact_size(), contact_size());
  std::vector<std::size_t> pair(nu);
  std::vector<double> image(na), traction[3];
  for (std::size_t i = 0; i < na; ++i) std::fill(&pair[first_[i]], pair.data() + first_[i + 1], i);
  for (std::size_t c = 0; c < 3; ++c)
    for (const Unknown& unknown : unknown_) traction[c].push_back(unknown.traction[c]);
  for (std::size_t a = 0; a < nu; ++a) {
    const Unknown& row = unknown_[a];
    double* to = out.row(static_cast<std::int64_t>(a));
    std::fill(to, to + n, 0.0);
    for (std::size_t c = 0; c < 3; ++c) {
      bool any = false;
      for (std::size_t r = 0; r < 3; ++r) {
        if (row.image[r] == 0 || !blocks[r][c]) continue;
        const double *from = blocks[r][c] + row.node * problem_.nodes, w = row.image[r];
        for (std::size_t i = 0; i < na; ++i) image[i] = w * from[node_[i]] + (any ? image[i] : 0);
        any = true;
      }
      for (std::size_t b = 0; b < nu && any; ++b) to[b] += traction[c][b] * image[pair[b]];
    }
    for (std::size_t b = first_[pair[a]]; b < first_[pair[a] + 1]; ++b)
      for (std::size_t c = 0; c < 3; ++c) to[b] += row.own[c] * unknown_[b].traction[c];
    for (std::size_t m = 0; m < motion_.size(); ++m) to[nu + m] = motion_entry(row, motion_[m]);
  }
  for (std::size_t m = 0; m < motion_.size(); ++m) {
    double* to = out.row(static_cast<std::int64_t>(nu + m));
    std::fill(to, to + n, 0.0);
    for (std::size_t b = 0; b < nu; ++b) to[b] = load_entry(motion_[m], unknown_[b]);
  }
}

void ContactEquations::right_side(const Step& step, std::vector<double>& b) const {
  const Problem& p = problem_;
  b.assign(at(size()), 0.0);
  MotionValues known{};
  for (std::size_t m = 0; m < motion_count; ++m) known[m] = given_.by_force[m] ? 0 : given_.value[m];
  const bool shift = images_.kind() == Tangential::shift;
  double* right = b.data() + inner();
  for (const Unknown& row : unknown_) {
    const std::size_t k = at(row.node);
    const double given[2] = {shift ? step.target[0][k] : -p.rigid_slip1(row.node, known),
                             shift ? step.target[1][k] : -p.rigid_slip2(row.node, known)};
    *right++ = row.direction[2] != 0 ? row.image[2] * p.rigid_gap(k, known)
                                     : row.image[0] * given[0] + row.image[1] * given[1];
  }
  for (const Motion& motion : motion_) *right++ = motion.per_load * given_.value[at(motion.which)];
}

void ContactEquations::start(const Point& z, std::vector<double>& x) const {
  x.assign(z.inner.begin(), z.inner.end());
  for (const Unknown& unknown : unknown_) {
    double sum = 0;
    for (std::size_t c = 0; c < 3; ++c) sum += unknown.direction[c] * z.lambda[c][at(unknown.node)];
    x.push_back(sum);
  }
  for (const Motion& motion : motion_) x.push_back(z.motion[at(motion.which)] * motion.scale);
}

void ContactEquations::tractions(const double* c, std::vector<double>& t) const {
  t.assign(at(3 * problem_.nodes), 0.0);
  for (const Unknown& unknown : unknown_) {
    for (std::size_t i = 0; i < 3; ++i) t[3 * at(unknown.node) + i] += unknown.traction[i] * *c;
    ++c;
  }
}

void ContactEquations::scatter(const std::vector<double>& x, Point& next) const {
  std::vector<double> t;
  tractions(x.data() + inner(), t);
  for (std::size_t c = 0; c < 3; ++c)
    for (std::size_t k = 0; k < at(problem_.nodes); ++k) next.lambda[c][k] = t[3 * k + c];
  for (std::size_t m = 0; m < motion_count; ++m)
    if (!given_.by_force[m]) next.motion[m] = given_.value[m];
  for (std::size_t m = 0; m < motion_.size(); ++m)
    next.motion[at(motion_[m].which)] = x[at(inner()) + unknown_.size() + m] / motion_[m].scale;
  next.inner.assign(x.begin(), x.begin() + inner());
  images_.apply(next);
}

void ContactEquations::apply(const double* x, double* y) {
  const double* c = x + inner();
  double* out = y + inner();
  multiply(contact_.data(), contact_size(), contact_size(), c, 0, out);
  if (inner() == 0) return;
  tractions(c, t_);
  bodies_.balance(x, t_.data(), y);
  for (const Unknown& row : unknown_) {
    double sum = 0;
    for (int r = 0; r < 3; ++r)
      if (const double w = row.image[at(r)]; w != 0)
        images_.per_unknown(row.node, r, [&](std::int64_t i, double v) { sum += w * v * x[i]; });
    *out++ += sum;
  }
}

std::size_t ContactEquations::bytes() const {
  return contact_.bytes() + unknown_.capacity() * sizeof(Unknown) + t_.capacity() * sizeof(double);
}

}  // namespace rollcon
