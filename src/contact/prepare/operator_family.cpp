#include "contact/prepare/operator_family.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace rollcon {
namespace {

// Shapes lie at length/width = exp(spacing * step). Cubics between four of them are right to 1e-5.
constexpr double spacing = 0.15;
constexpr std::size_t most_entries = 40;
constexpr double same = 1e-13;

bool equal(double a, double b) {
  return std::abs(a - b) <= same * std::max(std::abs(a), std::abs(b));
}

// Returns the weights of four neighbours, at -1, 0, 1, 2, for a point between the second and the third.
std::array<double, 4> cubic(double t) {
  return {-t * (t - 1) * (t - 2) / 6, (t + 1) * (t - 1) * (t - 2) / 2, -(t + 1) * t * (t - 2) / 2,
          (t + 1) * t * (t - 1) / 6};
}

void like(const DenseOperators& from, DenseOperators& op) {
  op.nodes = from.nodes;
  op.coupled = from.coupled;
  op.coupling_vanished = from.coupling_vanished;
  op.normal = from.normal;
  op.tangential = from.tangential;
  for (std::size_t r = 0; r < 3; ++r)
    for (std::size_t c = 0; c < 3; ++c)
      if (!from.block[r][c].empty() && op.block[r][c].empty()) op.block[r][c].resize_untouched(op.nodes, op.nodes);
}

// Returns the factor on rows of width 1: displacements grow with what is loaded, slip per unit speed does not.
double row_factor(std::size_t r, bool displacements, double width) {
  return r == 2 || displacements ? width : 1;
}

}  // namespace

void OperatorFamily::belong_to(std::int64_t version, bool tangential) {
  if (version_ == version && tangential_ == tangential) return;
  version_ = version;
  tangential_ = tangential;
  last_length_ = 0;
  entry_.clear();
}

std::size_t OperatorFamily::bytes() const {
  std::size_t sum = 0;
  for (const auto& e : entry_) sum += e->op.bytes();
  return sum;
}

const OperatorFamily::Entry* OperatorFamily::beside_grid(double length, double shear) const {
  for (const auto& e : entry_)
    if (e->step == none && equal(e->length, length) && equal(e->shear, shear)) return e.get();
  return nullptr;
}

void OperatorFamily::forget_farthest(double length) {
  const auto distance = [&](const std::unique_ptr<Entry>& e) { return std::abs(std::log(e->length / length)); };
  entry_.erase(std::max_element(entry_.begin(), entry_.end(),
                                [&](const auto& a, const auto& b) { return distance(a) < distance(b); }));
}

// Forgets the oldest shapes beside the grid when they take too much memory; they may come back, so small ones stay.
void OperatorFamily::forget_oldest_beside_grid() {
  constexpr std::size_t most_bytes = std::size_t{1} << 26;
  std::size_t sum = 0;
  for (const auto& e : entry_) sum += e->step == none ? e->op.bytes() : 0;
  const std::size_t next = entry_.empty() ? 0 : entry_.back()->op.bytes();
  std::erase_if(entry_, [&](const auto& e) {
    const bool forgotten = e->step == none && sum + next > most_bytes;
    if (forgotten) sum -= e->op.bytes();
    return forgotten;
  });
}

OperatorFamily::Entry& OperatorFamily::add(double length, double shear, std::int64_t step, const Assemble& assemble) {
  auto e = std::make_unique<Entry>();
  e->length = length;
  e->shear = shear;
  e->step = step;
  assemble({length, 1, shear}, e->op);
  ++assemblies_;
  if (entry_.size() == most_entries) forget_farthest(length);
  return *entry_.emplace_back(std::move(e));
}

const OperatorFamily::Entry& OperatorFamily::on_grid(std::int64_t step, const Assemble& assemble) {
  for (const auto& e : entry_)
    if (e->step == step) return *e;
  return add(std::exp(spacing * static_cast<double>(step)), 0, step, assemble);
}

std::int64_t OperatorFamily::fill(const FramePlace& place, bool displacements, const Assemble& assemble,
                                  DenseOperators& op) {
  const double length = place.length / place.width, shear = place.shear / place.width;
  const double before = last_length_;
  assemblies_ = 0;
  last_length_ = length;
  std::array<const Entry*, 4> part{};
  std::array<double, 4> share{1, 0, 0, 0};
  std::size_t parts = 1;
  part[0] = beside_grid(length, shear);
  if (!part[0]) {
    // A shape that changes little by little will come back; others are assembled as they are, one at a time.
    const bool following = before > 0 && std::abs(std::log(length / before)) < 2 * spacing && std::abs(shear) < same;
    if (following) {
      const double place_on_grid = std::log(length) / spacing, floor = std::floor(place_on_grid);
      share = cubic(place_on_grid - floor);
      parts = 4;
      for (std::size_t i = 0; i < 4; ++i)
        part[i] = &on_grid(static_cast<std::int64_t>(floor) - 1 + static_cast<std::int64_t>(i), assemble);
    } else {
      forget_oldest_beside_grid();
      part[0] = &add(length, shear, none, assemble);
    }
  }
  like(part[0]->op, op);
  const std::int64_t size = op.nodes * op.nodes;
  for (std::size_t r = 0; r < 3; ++r)
    for (std::size_t c = 0; c < 3; ++c) {
      if (part[0]->op.block[r][c].empty()) continue;
      double* const to = op.block[r][c].data();
      const double factor = row_factor(r, displacements, place.width);
      if (parts == 1) {
        const double* const from = part[0]->op.block[r][c].data();
        for (std::int64_t i = 0; i < size; ++i) to[i] = factor * from[i];
        continue;
      }
      const double *p0 = part[0]->op.block[r][c].data(), *p1 = part[1]->op.block[r][c].data(),
                   *p2 = part[2]->op.block[r][c].data(), *p3 = part[3]->op.block[r][c].data();
      const double s0 = factor * share[0], s1 = factor * share[1], s2 = factor * share[2], s3 = factor * share[3];
      for (std::int64_t i = 0; i < size; ++i) to[i] = s0 * p0[i] + s1 * p1[i] + s2 * p2[i] + s3 * p3[i];
    }
  return assemblies_;
}

}  // namespace rollcon
