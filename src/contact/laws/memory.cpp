/// Implements friction that follows the slip speed after a length of slip: d mu/dt = -max(s, s0)/dc (mu - mu_s(s)) for
/// a particle of the surface, mu_s being what the law without memory gives (docs/friction.md). Where surfaces come into
/// contact mu is that at rest.

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <utility>

#include "contact/laws/coulomb_given.hpp"
#include "contact/laws/field_law.hpp"
#include "support/index.hpp"

namespace rollcon {
namespace {

class Remembering final : public CoulombGiven, public FieldLaw {
 public:
  Remembering(std::shared_ptr<const FrictionLaw> law, FrictionMemory memory, double speed)
      : law_(std::move(law)), memory_(memory), speed_(speed) {}

  const FieldLaw* of_field() const override { return this; }
  void ratios(const FrictionField& field, std::span<double> ratio) const override;

  std::shared_ptr<const FrictionLaw> at_speed(double speed) const override {
    return std::make_shared<Remembering>(law_->at_speed(speed), memory_, speed);
  }
  std::string description() const override {
    char text[120];
    std::snprintf(text, sizeof text, ", after a length of slip of %g (slip speeds of at least %g)", memory_.length,
                  memory_.least_speed);
    return law_->description() + text;
  }

 private:
  double without_memory(double slip_speed) const { return law_->coefficient({1, 0, 0, 0, slip_speed / speed_}); }

  std::shared_ptr<const FrictionLaw> law_;
  FrictionMemory memory_;
  double speed_;
};

// Integrates along each line from where its surfaces touch first, over a piece exactly for its mean speed and a
// coefficient without memory that varies linearly: of second order and stable for any length.
void Remembering::ratios(const FrictionField& field, std::span<double> ratio) const {
  constexpr double at_end = 1e-6;  // fraction of a piece
  std::vector<LinePiece> pieces;
  std::fill(ratio.begin(), ratio.end(), 1.0);
  for (std::size_t i = 0; i < field.lines.size(); ++i) {
    field.lines.cut(field.lines.y(i), pieces);
    const auto nodes = field.lines.nodes(i);
    std::size_t next = 0;
    double r = 1;
    for (const LinePiece& piece : pieces) {
      const double end = at_end * piece.length();
      while (next < nodes.size() && field.lines.x(nodes[next]) > piece.upstream.x - end) ++next;
      const bool before = piece.upstream.value(field.pressure.data()) > 0;
      const bool after = piece.downstream.value(field.pressure.data()) > 0;
      if (!before) r = 1;
      if (!before && !after) continue;
      const double s1 = piece.upstream.value(field.slip_speed.data());
      const double s0 = piece.downstream.value(field.slip_speed.data());
      // An edge between two nodes is taken in the middle between them.
      const double time = (before && after ? 1 : 0.5) * piece.length() / field.speed;
      const double lengths = std::max(0.5 * (s0 + s1), memory_.least_speed) * time / memory_.length;
      const double kept = std::exp(-lengths), mean = lengths > 1e-8 ? -std::expm1(-lengths) / lengths : 1;
      r = kept * r + (mean - kept) * without_memory(s1) + (1 - mean) * without_memory(s0);
      for (; next < nodes.size() && field.lines.x(nodes[next]) > piece.downstream.x - end; ++next)
        if (after) ratio[at(nodes[next])] = r;
    }
  }
}

}  // namespace

std::shared_ptr<const FrictionLaw> with_memory(std::shared_ptr<const FrictionLaw> law, FrictionMemory memory) {
  return std::make_shared<Remembering>(std::move(law), memory, 1.0);
}

}  // namespace rollcon
