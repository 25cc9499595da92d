/// Implements a layer between the bodies that flows along the surface under a traction of tc = tc0 + k up, up being how
/// far it has flowed since the surfaces came into contact (docs/friction.md). Flow and slip together are the slip of
/// the contact; whichever takes less traction bounds it.

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>
#include <utility>
#include <vector>

#include "contact/laws/coulomb_given.hpp"
#include "contact/laws/field_law.hpp"
#include "support/index.hpp"

namespace rollcon {
namespace {

class Yielding final : public CoulombGiven, public FieldLaw {
 public:
  /// Takes a law; null: Coulomb's.
  Yielding(std::shared_ptr<const FrictionLaw> law, LayerYield yield) : law_(std::move(law)), yield_(yield) {}

  const FieldLaw* of_field() const override { return this; }
  bool wants_temperature() const override { return inner() && inner()->wants_temperature(); }
  void ratios(const FrictionField& field, std::span<double> ratio) const override;

  std::shared_ptr<const FrictionLaw> at_speed(double speed) const override {
    auto bound = law_ ? law_->at_speed(speed) : nullptr;
    return bound ? std::make_shared<Yielding>(std::move(bound), yield_) : nullptr;
  }
  std::string description() const override {
    char text[120];
    std::snprintf(text, sizeof text, "the layer between the bodies flows under %g, and %g more for a unit of length",
                  yield_.stress, yield_.hardening);
    return (law_ ? law_->description() + "; " : std::string()) + text;
  }

 private:
  double critical(double flowed) const { return std::max(0.0, yield_.stress + yield_.hardening * flowed); }
  /// Returns the flow after which tc is the bound.
  double until(double bound) const {
    return yield_.hardening > 0 ? (bound - yield_.stress) / yield_.hardening : std::numeric_limits<double>::infinity();
  }
  const FieldLaw* inner() const { return law_ ? law_->of_field() : nullptr; }

  std::shared_ptr<const FrictionLaw> law_;
  LayerYield yield_;
};

// Integrates along each line: the slip of a piece is flow where tc is the lesser bound at its end.
void Yielding::ratios(const FrictionField& field, std::span<double> ratio) const {
  if (inner())
    inner()->ratios(field, ratio);
  else
    std::fill(ratio.begin(), ratio.end(), 1.0);
  constexpr double at_end = 1e-6;  // fraction of a piece
  const std::vector<double> friction(ratio.begin(), ratio.end());
  std::vector<LinePiece> pieces;
  for (std::size_t i = 0; i < field.lines.size(); ++i) {
    field.lines.cut(field.lines.y(i), pieces);
    const auto nodes = field.lines.nodes(i);
    std::size_t next = 0;
    double flowed = 0;
    for (const LinePiece& piece : pieces) {
      const double end = at_end * piece.length();
      while (next < nodes.size() && field.lines.x(nodes[next]) > piece.upstream.x - end) ++next;
      const bool before = piece.upstream.value(field.pressure.data()) > 0;
      const bool after = piece.downstream.value(field.pressure.data()) > 0;
      if (!before) flowed = 0;
      if (!after) continue;
      const auto bound_at = [&](const LinePiece::End& e) {
        const auto own = [&](std::int32_t k) { return friction[at(k)] * field.mu[at(k)] * field.pressure[at(k)]; };
        return (1 - e.part) * own(e.node[0]) + e.part * own(e.node[1]);
      };
      // The slip at the end of a piece counts for the way to it.
      const double slip = piece.downstream.value(field.slip_speed.data());
      const double further = flowed + slip * piece.length() / field.speed;
      const double bound = bound_at(piece.downstream);
      if (critical(flowed) < bound) flowed = std::max(flowed, std::min(further, until(bound)));
      for (; next < nodes.size() && field.lines.x(nodes[next]) > piece.downstream.x - end; ++next) {
        const std::size_t k = at(nodes[next]);
        const double most = field.mu[k] * field.pressure[k];
        if (most > 0) ratio[k] = std::min(friction[k], critical(flowed) / most);
      }
    }
  }
}

}  // namespace

std::shared_ptr<const FrictionLaw> with_yield(std::shared_ptr<const FrictionLaw> law, LayerYield yield) {
  return std::make_shared<Yielding>(std::move(law), yield);
}

}  // namespace rollcon
