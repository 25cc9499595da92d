/// Finds derivatives of the totals of a wheel on its rail by position and velocity.

#include <algorithm>
#include <cmath>

#include "linalg/lu.hpp"
#include "support/error.hpp"
#include "wheelrail/wheel_rail.hpp"

namespace rollcon {

WheelRail::Inputs WheelRail::solved_inputs() const {
  Inputs in = in_;
  in.position = solved_->position;
  in.velocity = solved_->velocity;
  in.deviation = solved_->deviation;
  in.rate = solved_->rate;
  in.bend = solved_->bend;
  in.bend_rate = solved_->bend_rate;
  in.by_force = in.by_pull = false;
  in.stiffness = {};
  in.position.z = solved_->z;
  return in;
}

namespace {

double& entry_of(WheelsetState& state, std::size_t i) {
  double* const all[] = {&state.x, &state.y, &state.z, &state.roll, &state.yaw, &state.pitch};
  return *all[i];
}

}  // namespace

// Counts deviations of the rail behind position and velocity.
double& WheelRail::entry_of(Inputs& in, std::size_t entry) {
  if (entry >= entries) return entry == entries ? in.deviation.y : in.deviation.z;
  return rollcon::entry_of(entry < 6 ? in.position : in.velocity, entry % 6);
}

// Changes patches by Newton's systems at their solutions, and by how much they give way under each other.
void WheelRail::differentiate(const Inputs& in, std::size_t entry, double step, Totals& rate) {
  struct Side {
    Inputs in;
    WheelMotion motion;
    Vec3 centre{}, along{};
    Pose rail;
    std::vector<OverlapPatch> found;
  };
  Side side[2];
  for (std::size_t s = 0; s < 2; ++s) {
    side[s].in = in;
    entry_of(side[s].in, entry) += s == 0 ? -step : step;
    const double z = side[s].in.position.z;
    side[s].motion = motion_at(z, side[s].in);
    side[s].centre = centre_at(side[s].in.position.y, z);
    side[s].along = attitude_of(side[s].in.position).turn({1, 0, 0});
    side[s].rail = rail_pose(side[s].in.deviation);
    search_->find(side[s].motion.pose, side[s].found, merge_rule(in), side[s].motion.along);
    if (side[s].found.size() != active_.size())
      fail(Status::err_singular, "a patch begins or ends here: the totals have no derivative by entry %d",
           static_cast<int>(entry));
  }
  const std::size_t n = active_.size();
  const double distance = 2 * step;
  const double modulus = n > 0 ? active_.front()->contact.modulus() : 1;
  std::vector<PatchContact::Rate> own(n), yield(n);
  std::vector<double> settled(n, 0.0), given(n, 0.0);
  for (std::size_t i = 0; i < n; ++i) {
    PatchContact::Nearby near[2];
    for (std::size_t s = 0; s < 2; ++s) near[s] = {side[s].found[i], side[s].motion, friction_of(side[s].found[i])};
    own[i] = active_[i]->contact.rate(near[0], near[1], distance);
    if (n > 1 && active_[i]->give_way > 0) yield[i] = active_[i]->contact.rate_of_giving_way();
  }
  const auto pressing = [&](std::size_t k) {
    const PatchContact& p = active_[k]->contact;
    return dot(p.force(), p.overlap().normal);
  };
  const auto pressing_rate = [&](std::size_t k) {
    const PatchContact& p = active_[k]->contact;
    const Vec3 turned = side[1].found[k].normal - side[0].found[k].normal;
    return dot(own[k].force + settled[k] * yield[k].force, p.overlap().normal) + dot(p.force(), turned) / distance;
  };
  constexpr int most_rounds = 60;
  for (int round = 0; n > 1 && round < most_rounds; ++round) {
    for (std::size_t i = 0; i < n; ++i) {
      given[i] = 0;
      if (active_[i]->give_way <= 0) continue;
      const OverlapPatch& here = active_[i]->contact.overlap();
      for (std::size_t k = 0; k < n; ++k) {
        if (k == i) continue;
        const double change = give_way_per_load(side[1].found[i], side[1].found[k], modulus) -
                              give_way_per_load(side[0].found[i], side[0].found[k], modulus);
        given[i] += change / distance * pressing(k) +
                    give_way_per_load(here, active_[k]->contact.overlap(), modulus) * pressing_rate(k);
      }
    }
    settled = given;
  }
  const Pose rail = rail_pose(in.deviation);
  rate = {};
  Vec3 all{};
  for (std::size_t i = 0; i < n; ++i) {
    const PatchContact& p = active_[i]->contact;
    const Vec3 force = rail.turn(p.force()), moment = rail.turn(p.moment());
    const Vec3 force_rate = rail.turn(own[i].force + settled[i] * yield[i].force),
               moment_rate = rail.turn(own[i].moment + settled[i] * yield[i].moment);
    const auto arm = [&](std::size_t s) { return side[s].rail.place(side[s].found[i].reference) - side[s].centre; };
    const Vec3 middle = 0.5 * (arm(0) + arm(1)), moved = (1 / distance) * (arm(1) - arm(0));
    const double share = p.overlap().share, grown = (side[1].found[i].share - side[0].found[i].share) / distance;
    all = all + share * force;
    rate.force = rate.force + share * force_rate + grown * force;
    rate.moment = rate.moment + share * (moment_rate + cross(middle, force_rate) + cross(moved, force)) +
                  grown * (moment + cross(middle, force));
    rate.vertical -= share * (own[i].force + settled[i] * yield[i].force)[2] + grown * p.force()[2];
  }
  rate.pull =
      dot(rate.force, attitude_of(in.position).turn({1, 0, 0})) + dot(all, side[1].along - side[0].along) / distance;
}

// Takes differences of solves, for tables and conformal contacts.
void WheelRail::differentiate_by_solves(const Inputs& in, std::size_t entry, double step, Totals& rate) {
  Totals at[2];
  for (std::size_t s = 0; s < 2; ++s) {
    in_ = in;
    entry_of(in_, entry) += s == 0 ? -step : step;
    seek_strips();
    solve_at(in_.position.z);
    at[s] = totals(in_.position, in_.position.z, in_.deviation);
  }
  const double inverse = 0.5 / step;
  rate = {inverse * (at[1].force - at[0].force), inverse * (at[1].moment - at[0].moment),
          inverse * (at[1].vertical - at[0].vertical), inverse * (at[1].pull - at[0].pull)};
}

// Lets what the solve found follow: height, pitch rate and deflections keep the forces that were given for them.
void WheelRail::hold_what_is_given(std::array<Totals, entries + shifts>& rate) const {
  constexpr std::size_t z = 2, pitch = 11;
  struct Found {
    std::size_t entry;
    bool is;
  };
  const double ky = solved_->stiffness[0], kz = solved_->stiffness[1];
  const Found all[] = {{z, rate[z].vertical != 0 && solved_->by_force},
                       {pitch, solved_->by_pull},
                       {entries, ky > 0},
                       {entries + 1, kz > 0}};
  // Where a height carries nothing, nothing follows.
  if (solved_->by_force && rate[z].vertical == 0)
    rate[z] = {};
  else
    rate[z].z = 1;
  std::vector<std::size_t> found;
  for (const Found& f : all)
    if (f.is && !active_.empty()) found.push_back(f.entry);
  if (found.empty()) return;
  // What has to stay 0, by an entry.
  const auto off = [&](std::size_t of, std::size_t by) {
    const Totals& r = rate[by];
    if (of == z) return r.vertical;
    if (of == pitch) return r.pull;
    return of == entries ? r.force[1] + (by == of ? ky : 0) : r.force[2] + (by == of ? kz : 0);
  };
  const std::size_t n = found.size();
  Lu<double> lu;
  double* a = lu.prepare(static_cast<std::int64_t>(n));
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t j = 0; j < n; ++j) a[n * i + j] = off(found[i], found[j]);
  if (!lu.factor())
    fail(Status::err_singular,
         "a force that is given has no derivative by what was found for it: it has no answer nearby");
  const std::array<Totals, entries + shifts> free = rate;
  std::vector<double> follow(n);
  for (std::size_t k = 0; k < entries; ++k) {
    if (std::find(found.begin(), found.end(), k) != found.end()) {
      rate[k] = {};
      continue;
    }
    for (std::size_t i = 0; i < n; ++i) follow[i] = -off(found[i], k);
    lu.solve(follow.data());
    for (std::size_t i = 0; i < n; ++i) {
      const Totals& by = free[found[i]];
      rate[k].force = rate[k].force + follow[i] * by.force;
      rate[k].moment = rate[k].moment + follow[i] * by.moment;
      rate[k].z += follow[i] * by.z;
    }
  }
}

WheelRail::Derivative WheelRail::derivative(std::int32_t i) {
  require_solved();
  prepare_search();
  require_solved();  // bodies may have changed since
  if (i < 0 || i >= static_cast<std::int32_t>(entries))
    fail(Status::err_argument, "entry is %d; allowed: 0 to 5 of the position, 6 to 11 of the velocity", i);
  if (solved_->status == Status::not_converged || solved_->status == Status::cancelled)
    fail(Status::err_state, "the last solve did not converge: only a converged solution has derivatives");
  if (has_sections())
    fail(Status::err_unsupported, "the wheel or the rail is a section: solutions have no derivatives then");
  if (derived_) return derivative_[static_cast<std::size_t>(i)];
  const Inputs in = solved_inputs();
  const bool by_solves =
      in.options.conformal || in.step != StepKind::steady || !in.friction->coulomb_alone() ||
      std::any_of(active_.begin(), active_.end(), [](const Slot* slot) { return slot->contact.by_table(); });
  std::array<Totals, entries + shifts> rate{};
  const std::shared_ptr<Kept> here = by_solves ? keep_here() : nullptr;
  const double speed = std::abs(onward(in));
  // Gaps and slip are smooth to rounding; what is solved again is smooth to less.
  const double small = by_solves ? 2e-6 : 1e-7;
  const bool springs = solved_->stiffness != std::array<double, 2>{};
  for (std::size_t k = 0; k < (springs ? entries + shifts : entries) && !active_.empty(); ++k) {
    const std::size_t of = k < entries ? k % 6 : 0;
    if (k == 0 ? rail_varies_ == 0 && roller_ == 0 : k == 5 && wheel_varies_ == 0) continue;
    const double unit = of < 3 ? radius_ : 1;
    const double step = k < 6 || k >= entries ? small * unit : 1e-5 * speed * (of < 3 ? 1 : 1 / radius_);
    if (!by_solves) {
      differentiate(in, k, step, rate[k]);
      continue;
    }
    try {
      differentiate_by_solves(in, k, step, rate[k]);
    } catch (...) {
      return_to(*here);
      throw;
    }
  }
  if (by_solves) return_to(*here);
  hold_what_is_given(rate);
  for (std::size_t k = 0; k < entries; ++k) {
    const Totals& r = rate[k];
    const double height = r.z;
    // The mirror turns y, roll and yaw round.
    const double own = k % 6 == 1 || k % 6 == 3 || k % 6 == 4 ? side_ : 1;
    derivative_[k] = {{own * r.force[0], own * side_ * r.force[1], own * r.force[2]},
                      {own * side_ * r.moment[0], own * r.moment[1], own * side_ * r.moment[2]},
                      own * height};
  }
  derived_ = true;
  return derivative_[static_cast<std::size_t>(i)];
}

}  // namespace rollcon
