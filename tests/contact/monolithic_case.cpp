#include "contact/monolithic_case.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "bodies/body.hpp"
#include "bodies/pair.hpp"
#include "contact/operators/dense_operators.hpp"
#include "linalg/lu.hpp"
#include "support/frames.hpp"

namespace rollcon::monolithic_test {
namespace {

std::size_t at(std::int64_t i) {
  return static_cast<std::size_t>(i);
}

}  // namespace

std::shared_ptr<const Frame> square_frame(int n, double length) {
  const auto lines = frames::uniform_lines(-length, length, n);
  return std::make_shared<Frame>(
      build_frame(frames::perturb(frames::rectangle(ElementType::quad4, lines, lines), 0.1, 5), Axes{}));
}

Case make_case(std::string name, std::shared_ptr<const Frame> frame, std::shared_ptr<const Compliance> compliance,
               Scheme scheme, const Motions& motions, double length, double stress, bool dense) {
  Case c;
  c.name = std::move(name);
  c.frame = std::move(frame);
  c.compliance = std::move(compliance);
  c.keep = {c.frame, c.compliance};
  Problem& p = c.problem;
  take_frame(p, *c.frame);
  p.convection = make_convection(*c.frame, scheme, false, 1.0);
  p.stiffness = stress;
  const auto n = at(p.nodes);
  const auto op = std::make_shared<DenseOperators>();
  p.op = op;
  if (dense) {
    assemble_operators(*c.frame, *c.compliance, p.convection, true, *op);
    set_scales(p);
  } else {  // half-spaces with square cells, roughly
    p.rn.resize(n);
    for (std::size_t k = 0; k < n; ++k) p.rn[k] = stress / std::sqrt(p.cell_area[k]);
    p.rt.assign(n, stress);
  }
  frames::Random random(3);
  p.mu.assign(n, 0.3);
  p.gap.resize(n);
  p.slip1.resize(n);
  p.slip2.resize(n);
  for (std::size_t k = 0; k < n; ++k) {
    const double x = c.frame->x[k] / length, y = c.frame->y[k] / length;
    p.gap[k] = length * (0.01 * (x * x + y * y) + 1e-4 * random());
    p.slip1[k] = 1e-4 * random();
    p.slip2[k] = 1e-4 * random();
  }
  c.step.given.value = {1e-3, -5e-4, 0.01 * length, 2e-4 / length};
  c.traction = 0.01 * stress;
  const double force = 1e-3 * stress * length * length;
  if (motions.approach_by_force) c.step.given.by_force[approach] = true, c.step.given.value[approach] = force;
  if (motions.creep_by_force) {
    c.step.given.by_force[xi1] = c.step.given.by_force[xi2] = c.step.given.by_force[spin] = true;
    c.step.given.value[xi1] = 0.1 * force;
    c.step.given.value[xi2] = -0.05 * force;
    c.step.given.value[spin] = 0.02 * force * length;
  }
  c.step.state.assign(n, PairState::open);
  c.step.law.resize(n);
  c.z.motion = {2e-3, 1e-3, 0.008 * length, 1e-4 / length};
  for (auto& v : c.z.lambda) v.assign(n, 0.0);
  for (std::size_t k = 0; k < n; ++k) {
    const double x = c.frame->x[k] / length, y = c.frame->y[k] / length;
    if (!p.used[k]) c.step.state[k] = PairState::unused;
    if (!p.used[k] || std::hypot(x, y) > 0.8) continue;
    for (int i = 0; i < 3; ++i) c.z.lambda[i][k] = c.traction * random();
    c.z.lambda[2][k] -= c.traction;
    const bool slips = x < -0.1 || random() > 0.8;
    c.step.state[k] = slips ? PairState::slip : PairState::stick;
    const double bound = 0.3 * c.traction * (1 + 0.2 * random());
    const double size = slips ? bound * 1.3 : 0.5 * bound, angle = 3 + random();
    c.step.law[k] = coulomb().linearise({0.3, bound / 0.3, size * std::cos(angle), size * std::sin(angle)}, true);
  }
  return c;
}

Case halfspaces(int n, double poisson1, double poisson2, Scheme scheme, const Motions& motions, double length,
                double stress) {
  auto context = std::make_shared<Context>();
  const auto body = [&](double poisson) {
    const bool rigid = poisson < -1;
    auto made =
        std::make_shared<Body>(context, static_cast<std::int32_t>(rigid ? BodyKind::rigid : BodyKind::halfspace));
    if (!rigid) made->set_elastic(0, stress, poisson);
    made->prepare();
    return made;
  };
  const auto one = body(poisson1), two = body(poisson2);
  const auto frame = square_frame(n, length);
  PairOfBodies pair;
  pair.body = {one.get(), two.get()};
  std::shared_ptr<const Compliance> compliance = make_pair_compliance(*frame, pair, 1e-6, 1);
  Case c = make_case(poisson2 < -1 ? "half-space on rigid" : "two half-spaces", frame, compliance, scheme, motions,
                     length, stress);
  c.keep.insert(c.keep.end(), {context, one, two});
  return c;
}

void make_frictionless(Case& c) {
  c.tangential = Tangential::none;
  for (auto m : {xi1, xi2, spin}) c.step.given.by_force[at(m)] = false;
  c.step.given.value = {0, 0, c.step.given.value[approach], 0};
  for (int i = 0; i < 2; ++i) std::fill(c.z.lambda[i].begin(), c.z.lambda[i].end(), 0.0);
}

void make_reduced(Case& c) {
  c.tangential = Tangential::shift;
  frames::Random random(17);
  const std::size_t n = c.step.state.size();
  const double unit = 1e-3 * c.problem.length;
  for (auto& v : c.step.target) v.assign(n, 0.0);
  c.step.reach.assign(n, 0.0);
  for (std::size_t k = 0; k < n; ++k) {
    if (c.step.state[k] == PairState::stick) {
      for (auto& v : c.step.target) v[k] = unit * random();
      c.step.reach[k] = 0.1 * c.problem.length * (1 + 0.5 * random());
      c.step.law[k] = stick_law();
    } else if (c.step.state[k] == PairState::slip) {
      const double angle = 3 + random();
      TangentialLaw law{};
      law.sliding = true;
      law.own[0][0] = law.own[1][1] = 1;
      law.own[0][2] = 0.3 * std::cos(angle);
      law.own[1][2] = 0.3 * std::sin(angle);
      c.step.law[k] = law;
    }
  }
}

Problem written_out(const Case& c) {
  Problem p = c.problem;
  const auto none = std::make_shared<DenseOperators>();
  none->coupled = p.op->coupled;
  none->tangential = p.op->tangential;
  p.op = none;
  return p;
}

namespace {

/// Computes tangential displacements at the nodes.
void tangential_rows(const Case& c, RowMatrix<double> (&a)[2][3]) {
  const std::int64_t n = c.problem.nodes;
  ComplianceBlock out;
  out.stride = n;
  for (int r = 0; r < 2; ++r)
    for (int j = 0; j < 3; ++j) {
      a[r][j].resize(n, n);
      std::fill_n(a[r][j].data(), at(n * n), 0.0);
      if (j < 2 || c.compliance->couples()) out.a[r][j] = a[r][j].data();
    }
  c.compliance->block({c.frame->x, c.frame->y}, out);
}

}  // namespace

Point image_of(const Case& c, Point z) {
  const std::int64_t n = c.problem.nodes;
  RowMatrix<double> a[2][3];
  tangential_rows(c, a);
  const auto product = [&](const RowMatrix<double>(&row)[3], std::vector<double>& to) {
    to.assign(at(n), 0.0);
    for (int j = 0; j < 3; ++j)
      if (!row[j].empty()) multiply(row[j].data(), n, n, z.lambda[j].data(), 1, to.data());
  };
  const auto& op = dynamic_cast<const DenseOperators&>(*c.problem.op);
  product(op.block[2], z.depth);
  for (int r = 0; r < 2; ++r) {
    product(op.block[r], z.slip[r]);
    product(a[r], z.shift[r]);
  }
  return z;
}

void shift_states(Case& c) {
  int flips = 0;
  for (std::size_t k = 0; k < c.step.state.size() && flips < 4; ++k) {
    PairState& state = c.step.state[k];
    if (state == PairState::slip && k % 3 == 0) {
      state = PairState::open;
      ++flips;
    } else if (state == PairState::stick && k % 2 == 0) {
      state = PairState::slip;
      c.step.law[k] = coulomb().linearise({0.3, 0.8 / 0.3, -1, 0.2}, true);
      if (c.tangential == Tangential::shift) {
        c.step.law[k] = TangentialLaw{};
        c.step.law[k].own[0][0] = c.step.law[k].own[1][1] = 1;
        c.step.law[k].own[0][2] = -0.3;
      }
      ++flips;
    }
  }
}

Point condensed_step(const Case& c) {
  const Problem& p = c.problem;
  const std::int64_t n = p.nodes;
  RowMatrix<double> a[2][3];
  tangential_rows(c, a);
  std::vector<int> motion;
  for (int m = 0; m < 4; ++m)
    if (c.step.given.by_force[at(m)] && (m == approach || c.tangential != Tangential::none)) motion.push_back(m);
  MotionValues known{};
  for (std::size_t m = 0; m < 4; ++m) known[m] = c.step.given.by_force[m] ? 0 : c.step.given.value[m];
  // Motions count in units that keep the matrix's entries within a few orders of magnitude.
  const double rate = c.traction * p.length / std::abs(p.rn[at(n / 2)] * p.length);
  const auto unit = [&](int m) {
    return m == approach ? rate : m == spin ? rate / p.length / p.length : rate / p.length;
  };
  const std::int64_t size = 3 * n + static_cast<std::int64_t>(motion.size());
  Lu<double> lu;
  double* matrix = lu.prepare(size);
  std::fill_n(matrix, at(size * size), 0.0);
  std::vector<double> b(at(size));
  const auto operator_row = [&](int r, std::int64_t k, double factor, double* row) {
    for (int j = 0; j < 3; ++j)
      if (const double* from = p.op->row(r, j, at(k)))
        for (std::int64_t i = 0; i < n; ++i) row[3 * i + j] += factor * from[i];
  };
  for (std::int64_t k = 0; k < n; ++k) {
    const PairState state = c.step.state[at(k)];
    const bool touching = state == PairState::stick || state == PairState::slip;
    for (int r = 0; r < 3; ++r) {
      double* row = matrix + (3 * k + r) * size;
      double& right = b[at(3 * k + r)];
      if (!touching || (r < 2 && c.tangential == Tangential::none)) {
        row[3 * k + r] = 1;
        continue;
      }
      if (r == 2) {
        operator_row(2, k, p.rn[at(k)], row);
        right = p.rn[at(k)] * p.rigid_gap(at(k), known);
        for (std::size_t m = 0; m < motion.size(); ++m)
          if (motion[m] == approach)
            row[3 * n + static_cast<std::int64_t>(m)] = p.rn[at(k)] * p.closing(at(k)) * unit(approach);
        continue;
      }
      if (c.tangential == Tangential::shift && state == PairState::stick) {
        for (int j = 0; j < 3; ++j)
          for (std::int64_t i = 0; i < n; ++i) row[3 * i + j] += p.rn[at(k)] * a[r][j].row(k)[i];
        right = p.rn[at(k)] * c.step.target[r][at(k)];
        for (std::size_t m = 0; m < motion.size(); ++m)
          row[3 * n + static_cast<std::int64_t>(m)] =
              p.rn[at(k)] * c.step.reach[at(k)] * p.slip_column(motion[m], at(k))[at(r)] * unit(motion[m]);
        continue;
      }
      const TangentialLaw& law = c.step.law[at(k)];
      for (int j = 0; j < 3; ++j) row[3 * k + j] += law.own[r][j];
      right = law.constant[r];
      for (int s = 0; s < 2; ++s) {
        const double factor = law.slip[r][s] * p.rt[at(k)];
        operator_row(s, k, factor, row);
        right -= factor * (s == 0 ? p.rigid_slip1(k, known) : p.rigid_slip2(k, known));
        for (std::size_t m = 0; m < motion.size(); ++m)
          row[3 * n + static_cast<std::int64_t>(m)] +=
              factor * p.slip_column(motion[m], at(k))[at(s)] * unit(motion[m]);
      }
    }
  }
  for (std::size_t m = 0; m < motion.size(); ++m) {
    double* row = matrix + (3 * n + static_cast<std::int64_t>(m)) * size;
    const double scale = 1 / (p.length * p.length * (motion[m] == spin ? p.length : 1));
    for (std::int64_t k = 0; k < n; ++k)
      for (int j = c.tangential == Tangential::none ? 2 : 0; j < 3; ++j)
        row[3 * k + j] = scale * p.load_row(motion[m], at(k))[at(j)];
    b[at(3 * n) + m] = scale * c.step.given.value[at(motion[m])];
  }
  std::vector<double> copy(matrix, matrix + size * size), x(b), rest(b);
  EXPECT_TRUE(lu.factor());
  lu.solve(x.data());
  for (int refine = 0; refine < 2; ++refine) {
    multiply(copy.data(), size, size, x.data(), 0, rest.data());
    for (std::size_t i = 0; i < b.size(); ++i) rest[i] = b[i] - rest[i];
    lu.solve(rest.data());
    for (std::size_t i = 0; i < b.size(); ++i) x[i] += rest[i];
  }
  Point next = c.z;
  next.motion = known;
  for (std::size_t m = 0; m < motion.size(); ++m) next.motion[at(motion[m])] = x[at(3 * n) + m] * unit(motion[m]);
  for (int j = 0; j < 3; ++j)
    for (std::int64_t k = 0; k < n; ++k) next.lambda[j][at(k)] = x[at(3 * k + j)];
  return image_of(c, next);
}

double difference(const Case& c, const Point& a, const Point& b) {
  double worst = 0;
  const auto compare = [&](const std::vector<double>& u, const std::vector<double>& v, double scale) {
    EXPECT_EQ(u.size(), v.size());
    for (std::size_t k = 0; k < v.size(); ++k) worst = std::max(worst, std::abs(u[k] - v[k]) / scale);
  };
  const auto largest = [](std::initializer_list<const std::vector<double>*> fields) {
    double m = 1e-300;
    for (const auto* f : fields)
      for (const double v : *f) m = std::max(m, std::abs(v));
    return m;
  };
  const double traction = largest({&b.lambda[0], &b.lambda[1], &b.lambda[2]});
  for (int i = 0; i < 3; ++i) compare(a.lambda[i], b.lambda[i], traction);
  if (c.tangential != Tangential::none) {
    const double slip = largest({&b.slip[0], &b.slip[1]});
    for (int i = 0; i < 2; ++i) compare(a.slip[i], b.slip[i], slip);
  }
  compare(a.depth, b.depth, largest({&b.depth}));
  if (c.tangential == Tangential::shift)
    for (int i = 0; i < 2; ++i) compare(a.shift[i], b.shift[i], largest({&b.shift[0], &b.shift[1]}));
  for (const int m : {xi1, xi2, approach, spin}) {
    double scale = std::abs(b.motion[at(m)]);
    if (m == xi1 || m == xi2) scale = std::max(std::abs(b.motion[xi1]), std::abs(b.motion[xi2]));
    if (scale > 0) worst = std::max(worst, std::abs(a.motion[at(m)] - b.motion[at(m)]) / scale);
  }
  return worst;
}

}  // namespace rollcon::monolithic_test
