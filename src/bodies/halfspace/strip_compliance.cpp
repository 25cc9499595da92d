#include "bodies/halfspace/strip_compliance.hpp"

#include <algorithm>
#include <atomic>
#include <mutex>
#include <vector>

#include "bodies/halfspace/strip_integrals.hpp"
#include "support/index.hpp"

namespace rollcon {
namespace {

using namespace strips;

/// Says which of StripIntegrals' kinds an entry is, and its sign: pressures there are normal tractions turned round.
struct Entry {
  int kind = -1;
  double sign = 1;
};
constexpr Entry entries[3][3] = {{{0, 1}, {1, 1}, {3, -1}}, {{1, 1}, {2, 1}, {4, -1}}, {{1, -1}, {2, -1}, {0, 1}}};

class StripCompliance final : public Compliance {
 public:
  StripCompliance(const Frame& frame, HalfspaceConstants c) : frame_(frame), bodies_{c.cn, c.cv, c.ck} {}

  std::int64_t nodes() const override { return frame_.nodes(); }
  bool couples() const override { return bodies_.ck != 0; }
  bool follow_frame() override { return true; }
  void set_threads(int) override {}
  std::int64_t kernel_evaluations() const override { return evaluations_.load(); }
  std::size_t bytes() const override { return sizeof *this; }
  std::string description() const override { return "half-spaces, by closed integrals over strips"; }

  void block(Points points, const ComplianceBlock& out) const override {
    for (const auto& row : out.a)
      for (double* const to : row)
        for (std::size_t p = 0; to && p < points.size(); ++p)
          std::fill_n(to + static_cast<std::ptrdiff_t>(p) * out.stride, frame_.nodes(), 0.0);
    each_row(
        points,
        [&](std::size_t p, int i, int j, double sign, const double* row) {
          double* const to = out.a[i][j] + static_cast<std::ptrdiff_t>(p) * out.stride;
          const std::vector<std::int32_t>& node = frame_.strips->node;
          for (std::size_t k = 0; k < node.size(); ++k) to[node[k]] = sign * row[k];
        },
        [&](int i, int j) { return out.a[i][j] != nullptr; });
  }

  void apply(Points points, const double* traction, double* displacement) const override {
    std::fill_n(displacement, 3 * points.size(), 0.0);
    each_row(
        points,
        [&](std::size_t p, int i, int j, double sign, const double* row) {
          const std::vector<std::int32_t>& node = frame_.strips->node;
          double sum = 0;
          for (std::size_t k = 0; k < node.size(); ++k) sum += row[k] * traction[3 * at(node[k]) + at(j)];
          displacement[3 * p + at(i)] += sign * sum;
        },
        [](int, int) { return true; });
  }

 private:
  /// Calls take(point, i, j, sign, row) for every entry wanted(i, j) that does not vanish; its row is of the strips'
  /// nodes inside.
  template <class Take, class Wanted>
  void each_row(Points points, Take take, Wanted wanted) const {
    const StripFrame& strips = *frame_.strips;
    const std::lock_guard lock(using_room_);  // solves allocate nothing
    StripIntegrals& integrals = integrals_;
    std::vector<double>& row = row_;
    integrals.lay(strips.layout, bodies_, strips.geometry.data());
    row.resize(at(strips.layout.nodes));
    const auto any = [&](int first, int last) {
      for (int i = first; i <= last; ++i)
        for (int j = 0; j < 3; ++j)
          if (wanted(i, j)) return true;
      return false;
    };
    const bool slip = any(0, 1), normal = any(2, 2);
    for (std::size_t p = 0; p < points.size(); ++p)
      for (const Displacement what : {Displacement::slip, Displacement::normal}) {
        if (!(what == Displacement::slip ? slip : normal)) continue;
        const Observation seen = integrals.observe(what, false, points.x[p], points.y[p], 0);
        evaluations_ += 3 * strips.layout.places;
        for (int i = what == Displacement::slip ? 0 : 2; i <= (what == Displacement::slip ? 1 : 2); ++i)
          for (int j = 0; j < 3; ++j) {
            const auto [kind, sign] = entries[i][j];
            if (kind >= integrals.kinds(what) || !wanted(i, j)) continue;
            std::fill(row.begin(), row.end(), 0.0);
            integrals.add_row(seen, kind, 1, row.data());
            take(p, i, j, sign, row.data());
          }
      }
  }

  const Frame& frame_;
  StripBodies bodies_;
  mutable std::atomic<std::int64_t> evaluations_{0};
  mutable std::mutex using_room_;
  mutable StripIntegrals integrals_;
  mutable std::vector<double> row_;
};

}  // namespace

std::unique_ptr<Compliance> make_strip_compliance(const Frame& frame, HalfspaceConstants c) {
  return std::make_unique<StripCompliance>(frame, c);
}

}  // namespace rollcon
