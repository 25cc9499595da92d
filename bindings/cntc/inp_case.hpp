#pragma once
#include <string>

#include "inp_reader.hpp"
#include "problem.hpp"

namespace cntc {

/// Reads one case of an input file; values that the case leaves out stay as they were.
class InpCase {
 public:
  InpCase(InpReader& reader, Problem& problem, std::string folder, bool first)
      : in_(reader), p_(problem), v_(problem.in), folder_(std::move(folder)), first_(first) {}

  void read_wheel();
  void read_gap();
  /// Reads a case of SIMPACK's users, which has no positions and velocities and keeps some digits.
  void read_simpack();

 private:
  void read_last_control();
  void check_digits(int heat_step);
  void read_solver();
  void read_friction();
  void read_friction_line(int law, bool with_place);
  void read_material(bool wheel);
  void read_profile(ProfileInput& profile, bool wheel);
  void read_plane_grid();
  void read_track(int z);
  void read_wheelset(int e, bool motion);
  void read_potential();
  void read_gap_shape();
  void read_extra_slip();
  void read_subsurface();

  InpReader& in_;
  Problem& p_;
  Inputs& v_;
  std::string folder_;
  bool first_;
  int subs_ = 0, v_digit_ = 0;
};

}  // namespace cntc
