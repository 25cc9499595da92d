#pragma once
#include <array>
#include <string>

#include "bodies.hpp"
#include "inp_reader.hpp"
#include "problem.hpp"

namespace cntc {

/// Reads one case of an input file; values that the case leaves out stay as they were. What is read is set by the
/// functions of the library.
class InpCase {
 public:
  InpCase(InpReader& reader, Problem& problem, std::string folder, bool first)
      : in_(reader), p_(problem), v_(problem.in), folder_(std::move(folder)), first_(first) {}

  void read_wheel();
  void read_gap();
  /// Reads a case of SIMPACK's users, which has no positions and velocities and keeps some digits.
  void read_simpack();

 private:
  /// Calls a setter, whose refusal is a mistake of the file.
  template <class... T, class... A>
  void set(void (*setter)(Call&, T...), A... values) {
    std::string refusal;
    Call call{"", p_, p_.icp, &refusal};
    setter(call, values...);
    if (!refusal.empty()) in_.fail(refusal);
  }
  void give(void (*setter)(Call&, int, int, const double*), int method, const std::vector<double>& q) {
    set(setter, method, int(q.size()), q.data());
  }

  /// Reads the control word V-L-D-C3-M-Z-E; `allowed` has the values of V, D, C3, Z and E. Keeps M and M2.
  std::vector<int> read_second_control(std::array<const char*, 5> allowed);
  void read_last_control();
  void check_case(int law, int grid) const;
  void read_solver();
  void read_friction(int variation, int law);
  void read_material(int coefficients);
  void read_profile(bool wheel);
  /// Reads what the second control word of a wheel announces.
  void read_wheel_data(const std::vector<int>& control, bool motion);
  void read_plane_grid();
  void read_track(int z);
  void read_wheelset(int e, bool motion);
  void read_potential();
  void read_gap_shape();
  void read_extra_slip();
  void read_subsurface(int stresses);

  InpReader& in_;
  Problem& p_;
  Inputs& v_;
  std::string folder_;
  bool first_;
  int heat_ = 0;  // digit H, whose 1 keeps what was set
};

}  // namespace cntc
