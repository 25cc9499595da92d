#pragma once
/// Solves a wheel on its rail: profiles, position and velocity in, patches and forces out (docs/wheelrail.md).

#include <array>
#include <atomic>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "contact/laws/wear_law.hpp"
#include "geometry/vec2.hpp"
#include "support/statistic_info.hpp"
#include "wheelrail/contact_search.hpp"
#include "wheelrail/patch_contact.hpp"
#include "wheelrail/rail_place.hpp"
#include "wheelrail/wheel_options.hpp"

namespace rollcon {

/// Holds a wheelset's position or velocity: along x forward, y right, z down; about x, z, y (roll, yaw, pitch).
struct WheelsetState {
  double x = 0, y = 0, z = 0, roll = 0, yaw = 0, pitch = 0;
  bool roll_outside = false;  ///< position is rolled about the track's x after the yaw; else yawed after the roll
};
/// Holds the deviation of a rail from its place in the track.
struct RailDeviation {
  double y = 0, z = 0, roll = 0;
  bool about_origin = false;  ///< position is rolled about the profile's origin; else about where the gauge is measured
};

class WheelRail {
 public:
  /// Takes bodies with profiles, half-spaces or rigid, or by a section, which is prepared; where those profiles lie is
  /// no matter. err_argument.
  WheelRail(std::shared_ptr<Context> context, std::shared_ptr<Body> wheel, std::shared_ptr<Body> rail,
            std::int32_t side);

  void set_track(double gauge, double gauge_height, double cant);  ///< cant: radian, inwards
  /// Places the rail by its profile's origin, y from the middle of the track to the rail's side.
  void place_by_origin(double y, double z, double cant);
  void set_wheelset(double back_to_back, double flange_back, double radius);
  /// Makes the rail a roller that turns at this rate about an axis along y. The radius is measured at the top of the
  /// rail, or at its origin if the rail is placed by that. Radius 0: a rail at rest. The position's x then counts from
  /// the place above the axis.
  void set_roller(double radius, double rate);
  /// Takes the radius of the wheelset where the wheel's profile has this y.
  void set_tape_circle(double y);
  /// Displaces the wheel in the wheelset's axes: x, y, z, roll, yaw, pitch, and their rates.
  void set_flexibility(const double* displacement, const double* rate);
  /// Puts the rail on springs along y and z, 0: rigid, with forces on the rail beside the wheel's.
  void set_rail_springs(const double* stiffness, const double* force);
  void set_rail_deviation(const double* deviation, const double* rate);  ///< y, z, roll
  void set_position(const double* position);                             ///< x, y, z, roll, yaw, pitch
  void set_velocity(const double* velocity);                             ///< rates of x, y, z, roll, yaw, pitch
  /// Prescribes z of the position (how: by motion), or the vertical force on the rail (how: by force).
  void prescribe_vertical(std::int32_t how, double force);
  /// Prescribes the pitch rate of the velocity (how: by motion), or the force on the wheel along the wheelset's x.
  void prescribe_longitudinal(std::int32_t how, double force);
  /// Sets a law as a contact has it, or "by_angle", pairs (inclination of the rail, mu) of Coulomb's law.
  void set_friction(const char* law, std::int32_t n, const double* parameters);
  /// Sets a law whose parameters are linear between inclinations of the rail: for each point the angle and these.
  void set_law_by_angle(const char* law, std::int32_t points, std::int32_t n, const double* parameters);
  // Setters follow that contacts have too, with the wheel as body 1 and the rail as body 2.
  void set_friction_memory(double length, double least_speed);
  void set_layer(double flexibility, double stress, double hardening);
  void set_heat(std::int32_t which, double conductivity, double capacity, double temperature);
  void set_friction(double mu) { set_friction("coulomb", 1, &mu); }
  /// Looks forces along the surfaces up in this table from now on, for what it has; null: in none. err_state: it is not
  /// made.
  void set_table(std::shared_ptr<const ForceTable> table);
  // Options by name follow: wheel_option_table().
  void set_int(const char* name, std::int64_t value);
  void set_real(const char* name, double value) { wheel_option_table().set_real(in_.options, name, value); }
  std::int64_t get_int(const char* name) const { return wheel_option_table().get_int(in_.options, name); }
  double get_real(const char* name) const { return wheel_option_table().get_real(in_.options, name); }
  /// Throws err_state where a table gives the forces: it has no tractions and no slip for what is `wanted`.
  void require_solved_friction(const char* wanted) const;

  /// Makes every solve a step of dt (StepKind's numbers); dt counts for nothing where it is steady.
  void set_step(std::int32_t kind, double dt);
  /// Makes the next step start from where the last one did. err_state: that did not succeed, or there was none.
  void repeat_step();
  /// Returns what the next step starts from, with a header and a checksum. err_state: no step was made.
  std::vector<double> past_numbers() const;
  /// Restores what past_numbers() returned. err_argument: numbers of another kind or wheel, and then nothing changes.
  void past_set(std::int64_t n, const double* past);
  /// Throws err_unsupported where solves are steps in time.
  void refuse_lists() const;

  /// Returns ok or the first of cancelled, not_converged, derailed, too_deep, rim_contact, coarse, no_contact.
  Status solve();
  /// Forgets warm starts.
  void reset();

  static constexpr std::int32_t places = 16;
  /// Keeps what was set and the last solution at a place, 0 to places - 1. Allocates nothing where as much was kept
  /// before.
  void snapshot(std::int32_t place);
  /// Goes back to a snapshot, as if nothing had been done in between. err_state: nothing is there, or other dimensions
  /// have been set since.
  void rollback(std::int32_t place);
  /// Makes a wheel of its own with the same inputs and last solution; context: null: that of this wheel.
  std::unique_ptr<WheelRail> copy(const std::shared_ptr<Context>& context = nullptr) const;
  /// Stops the solve that is running, if one is, before its next patch or height. Any thread may call it.
  void request_cancel() noexcept { cancel_.store(true); }
  void forget_cancel() noexcept { cancel_.store(false); }
  bool cancelled() const noexcept { return cancel_.load(); }
  Context& context() const { return *context_; }
  /// Throws err_state for what is missing before a solve but position and velocity.
  void require_ready_for_positions();

  /// Tells where the rigid wheel touches the rigid rail, in the track.
  struct Touch {
    double height = 0;  ///< z of the wheelset then; infinite: the wheel is beside its rail, and nothing else is known
    double x = 0, y = 0, z = 0, angle = 0, wheel_y = 0, rolling_radius = 0;
  };
  /// Finds the point of touch without yaw; from track, wheelset and deviation of the rail alone.
  Touch touch(double shift, double roll);
  /// Throws err_state where track or wheelset are not set.
  void require_dimensions() const;
  double side() const { return side_; }  ///< -1: left, 1: right
  double radius() const { return radius_; }

  // Results of the last solve; err_state before one.
  std::int64_t patches() const;
  /// Returns the contact of a patch; which one that is changes with the next solve.
  std::shared_ptr<Contact> contact(std::int64_t i) const;
  /// Returns force on the wheel, in axes of the track or the wheelset, and moment about the wheelset's centre.
  void resultant(bool of_wheelset, double* force, double* moment) const;
  /// Returns the axes of a patch's contact, in the track; a left wheel's are a mirror image.
  Axes patch_axes(std::int64_t patch) const;
  /// Returns y and z in the track of the point at this fraction of the length of the wheel's (1) or the rail's profile,
  /// as last solved.
  std::array<double, 2> profile_point(std::int32_t body, double share) const;
  /// Holds derivatives of totals of the last solve by entry i of its position (0 to 5) or velocity (6 to 11), in the
  /// track, and of z. err_state: it did not converge; err_singular: patches begin or end there.
  struct Derivative {
    Vec3 force{}, moment{};
    double z = 0;
  };
  Derivative derivative(std::int32_t i);
  /// Returns y and z of n points at equal arc lengths along the whole profile of body 1 (the wheel) or 2 (the rail).
  std::vector<Vec2> profile_points(std::int32_t body, std::int64_t n) const;
  /// Adds weight times what the last solve takes off body 1 or 2 at these points of its profile, in volume per length
  /// rolled: see rollcon::add_wear. Returns the whole volume (without the weight).
  double add_wear(const WearLaw& law, std::int32_t body, const std::vector<Vec2>& point, double weight,
                  double* volume) const;
  double stat(const char* name) const;                        ///< err_option: unknown name
  static const StatisticInfo* stat_info(std::int64_t i);      ///< null beyond the last
  double patch_stat(std::int64_t i, const char* name) const;  ///< err_option: unknown name
  static const StatisticInfo* patch_stat_info(std::int64_t i);

 private:
  struct Slot {
    PatchContact contact;
    double wheel_y = 0;
    bool taken = false;
    double give_way = 0;
    bool unfit = false;  ///< strips were sought from all starts before and not found
  };
  /// Holds a patch's load, and by how much it gives way in this round and in the next one.
  struct Way {
    double load, before, now;
    bool moved = false;  ///< has to be solved again
  };
  /// Holds inputs and outcome of the last solve; what is set later does not change its results.
  struct Solved {
    WheelsetState position, velocity;
    RailDeviation deviation, rate;
    WheelsetState bend, bend_rate;
    bool by_force = false, by_pull = false;
    std::array<double, 2> stiffness{}, deflection{};
    double z = 0;
    Status status = Status::ok;
  };
  /// Holds parameters of a law by the inclination of the rail, row by row, and the greatest coefficient of each row.
  struct FrictionByAngle {
    std::string law;
    std::vector<double> angle, parameter, mu;
    bool coulomb = false;  ///< parameters are coefficients
  };
  /// Holds what may change between two solves.
  struct Inputs {
    WheelsetState position, velocity;
    RailDeviation deviation, rate;
    WheelsetState bend, bend_rate;  ///< displacement of the wheel in the wheelset's axes
    bool bent = false;
    bool position_given = false, velocity_given = false, friction_given = false, by_force = false, by_pull = false;
    double pull = 0;                                  ///< force on the wheel along the wheelset's x
    std::array<double, 2> stiffness{}, rail_force{};  ///< springs of the rail along y and z
    double roller_rate = 0;
    StepKind step = StepKind::steady;
    double dt = 0;
    WheelOptions options;
    double load = 0;
    std::shared_ptr<const ForceTable> table;
    std::shared_ptr<const FrictionGiven> friction = std::make_shared<FrictionGiven>();
    std::shared_ptr<const FrictionByAngle> by_angle;  ///< null: the same everywhere
  };
  struct Kept;
  struct Stat;
  struct PatchStat;
  static const Stat stats[];
  static const PatchStat patch_stats[];

  void prepare();
  void prepare_search();
  void require_friction() const;
  template <class Set>
  void change_friction(Set set);
  /// Takes profiles and materials that the bodies were given since; what was solved with others is gone then.
  void follow_bodies();
  void set_place(const TrackGauge& track);
  void take_wheel_profile(std::shared_ptr<const ProfileCurve> curve, double nominal, const std::optional<double>& tape);
  Vec3 rail_pivot(const RailDeviation& deviation) const;
  /// Returns the speed at which the contact moves on over the rail's material.
  double onward(const Inputs& in) const { return in.velocity.x + roller_ * in.roller_rate; }
  Vec3 centre_at(double y, double z) const { return {0, y, z - nominal_radius_}; }
  /// Returns the wheel's pose in the track; bend: its displacement in the wheelset.
  Pose wheel_pose(const WheelsetState& position, double z, const WheelsetState& bend) const;
  WheelMotion motion_at(double z) const { return motion_at(z, in_); }
  WheelMotion motion_at(double z, const Inputs& in) const;
  /// Throws err_argument where the surfaces run backwards through a patch, or hardly run at all.
  void require_onward(const OverlapPatch& patch, const WheelMotion& motion) const;
  Status solve_at(double z);
  void solve_patch(Slot& slot, const OverlapPatch& patch, const WheelMotion& motion);
  static MergeRule merge_rule(const Inputs& in) {
    return {in.options.conformal == 0, in.options.merge_distance, in.options.merge_angle};
  }
  void place_profiles(Body& wheel, Body& rail) const;
  void prepare_map();
  double along_profile(double y) const;
  std::optional<double> sink_for_map(double y, double wheel_y, double depth);
  CreepMap::Node map_node(const CreepMap::Place& place);
  void calibrate(const OverlapPatch& patch, double give_way, PatchFriction& friction);
  PatchFriction friction_of(const OverlapPatch& patch) const;
  std::shared_ptr<const FrictionGiven> law_at(double angle) const;
  void begin_step();
  void end_step(Status status);
  double mark_of_past() const;
  Status meet_force();
  void seek_strips();  ///< lets strips be sought from all starts again
  Status find_height();
  Status find_height_of_half_spaces();
  bool has_sections() const { return given_wheel_->traits().section || given_rail_->traits().section; }
  WholeBodies whole_bodies() const;
  void refuse_for_sections() const;
  /// Holds what the forces of each patch, over its normal force, move each patch apart beyond its half-spaces:
  /// apart[i * slots + j] is patch i under patch j.
  struct Flexibility {
    std::vector<Slot*> slot;
    std::vector<double> apart;
  };
  /// Holds changes of the half-spaces' depths, and how much lower than these the wheelset is then.
  struct DepthStep {
    bool solved = false;
    std::vector<double> deeper;
    double down = 0, largest = 0;
  };
  std::vector<Slot*> pressed() const;
  Status find_height_of_sections();
  Status solve_sections(Flexibility& found);
  DepthStep step_of_depths(const Flexibility& flexibility) const;
  double take(const DepthStep& step, const Flexibility& flexibility) const;
  Status find_pitch_rate();
  Status find_deflection();
  void tell(Status status) const;
  double first_sink(double touch);
  double vertical_force() const;
  bool foresee_ways();
  double give_way_per_load(const OverlapPatch& here, const OverlapPatch& there, double modulus) const;
  static constexpr std::size_t entries = 12;  ///< entries of position and velocity
  static constexpr std::size_t shifts = 2;    ///< entries behind them: deviations y and z of the rail
  /// Holds the totals at one place.
  struct Totals {
    Vec3 force{}, moment{};
    double vertical = 0;
    double pull = 0;  ///< along the wheelset's x
    double z = 0;     ///< among rates: that of the wheelset's height
  };
  Totals totals(const WheelsetState& position, double z, const RailDeviation& deviation) const;
  void differentiate(const Inputs& in, std::size_t entry, double step, Totals& rate);
  void differentiate_by_solves(const Inputs& in, std::size_t entry, double step, Totals& rate);
  static double& entry_of(Inputs& in, std::size_t entry);
  void hold_what_is_given(std::array<Totals, entries + shifts>& rate) const;
  Inputs solved_inputs() const;
  Slot& slot_for(const OverlapPatch& patch);
  void require_solved() const;
  static Pose attitude_of(const WheelsetState& position);
  Pose rail_pose(const RailDeviation& deviation) const;
  Slot& add_slot();
  const Slot& active(std::int64_t i) const;
  void keep(Kept& kept) const;
  std::shared_ptr<Kept> keep_here() const;
  void return_to(const Kept& kept);

  std::shared_ptr<Context> context_;
  std::shared_ptr<Body> given_wheel_, given_rail_, wheel_, rail_;
  std::shared_ptr<const ProfileCurve> wheel_curve_;  ///< profile that was taken; the rail's is in rail_shape_
  std::size_t wheel_varies_ = 0, rail_varies_ = 0;   ///< numbers of their variations that were taken
  double side_;                                      ///< -1: everything is solved in a mirror
  std::optional<TrackGauge> track_;
  double roller_ = 0;  ///< radius of the roller; 0: a rail
  double back_to_back_ = 0, flange_back_ = 0, nominal_radius_ = 0;
  double radius_ = 0;           ///< radius where the wheel's profile has z = 0
  std::optional<double> tape_;  ///< y where the nominal radius counts; none: where z is 0
  bool wheelset_given_ = false;
  std::int64_t dimensions_ = 0;  ///< counts how often they were set
  Inputs in_;

  // Members made from these follow.
  std::optional<ContactSearch> search_;
  RailShape rail_shape_;
  std::vector<OverlapPatch> found_;
  std::vector<std::unique_ptr<Slot>> slot_;
  std::vector<std::unique_ptr<Slot>> spare_;  ///< slots made after a state that was gone back to
  std::vector<Slot*> active_;
  double z_ = 0;
  double sink_ = 0;           ///< way beyond first touch in the last solve with a force; 0: none
  std::vector<Way> way_;      ///< storage of foresee_ways()
  bool on_lattices_ = false;  ///< patches are solved on lattices alone
  bool hasty_ = false;        ///< strips were not found for a patch, and not sought from all starts
  std::int64_t solves_ = 0;
  std::optional<Solved> solved_;
  std::shared_ptr<const WheelPast> past_;   ///< start of the next step in time; null: the last solve was steady
  std::shared_ptr<const WheelPast> start_;  ///< start of the last step
  bool can_repeat_ = false;
  bool derived_ = false;  ///< derivative_ belongs to the last solve
  std::array<Derivative, entries> derivative_{};
  std::atomic<bool> cancel_{false};
  // Members that the table's map for these profiles is made with follow.
  std::shared_ptr<CreepMap> map_;
  std::shared_ptr<const ForceTable> map_table_;
  std::int64_t map_dimensions_ = 0;
  std::unique_ptr<PatchContact> map_contact_;
  struct AlongProfile {
    double y, s, by_y;
  };
  std::vector<AlongProfile> map_along_;  ///< arc length over y of the wheel's profile
  Inputs map_in_;
  WheelMotion map_motion_;
  std::vector<OverlapPatch> map_found_;
  OverlapPatch map_patch_;
  std::vector<std::shared_ptr<Kept>> kept_;  ///< saved states by place
};

}  // namespace rollcon
