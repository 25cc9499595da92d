#pragma once
#include <array>
#include <string>
#include <vector>

#include "rollcon_cntc.h"

namespace cntc {

/// Holds factors from the caller's units to mm, s and N, and the sign of forces (SIMPACK takes those on body 2).
struct Units {
  int code = CNTC_un_cntc;
  double length = 1;
  double sign = 1;

  double area() const { return length * length; }
  double stress() const { return 1 / area(); }
};

inline Units units_of(int code) {
  const double length = code == CNTC_un_cntc ? 1 : 1000;
  return {code, length, code == CNTC_un_spck ? -1.0 : 1.0};
}

/// Holds control digits and flags; flags.cpp has their codes and ranges.
struct Digits {
  int config = 1, pvtime = 2, bound = 0, tang = 3, norm = 0, force = 0, frclaw = 0, discns = 2, inflcf = 2, mater = 0;
  int exrhs = 0, xflow = 0, heat = 0, iestim = 0, output = 0, flow = 1, ret = 1, matfil = 0, sens = 1;
  int ifmeth = 0, ifvari = 4, sbsout = 0, sbsfil = 0, npomax = 20000;
  int idebug = 0, licdbg = 0, wrtinp = 0, openmp = 1, timers = 0, ncase = 0, frames = 0;
  int gausei = 0, damping = 0;

  bool left() const { return config == 0 || config == 4; }
  bool roller() const { return config >= 4; }
};

/// Holds solver settings for getters and files; rollcon's Newton iteration uses only the count and the tolerance.
struct SolverSettings {
  int maxgs = 999, maxin = 20, maxnr = 25, maxout = 1, extra = 0;
  std::array<double, 8> reals{1e-5, .9, 1, .5, 0, 0, 0, 0};
};

/// Says how many numbers a solver (digit G) has on its own line of an input file, and which of them, from 0, is whole.
struct SolverLine {
  int numbers, whole;
};
inline constexpr SolverLine solver_lines[] = {{0, 0}, {0, 0}, {4, 2}, {4, 2}, {2, 0}, {8, 2}, {0, 0}};
/// Numbers of parameters of materials (digit M) and of laws of friction (digit L), memory apart.
inline constexpr int material_parameters[] = {4, 8, 8, 7, 8, 7, 4, 4};
inline constexpr int friction_parameters[] = {2, 0, 5, 5, 5, 3, 4};

/// Holds the material: values behind the elastic constants depend on the digit M and have the order of
/// cntc_setmaterialparameters.
struct Material {
  std::array<double, 2> nu{.28, .28}, g{1, 1};
  std::array<double, 4> more{};
  double cdampn = 0, cdampt = 0, dfnmax = 0, dftmax = 0;
};

struct Heat {
  double background = 0, capacity = 0, conductivity = 0, density = 0;
};

/// Holds one set of friction parameters, at an inclination (V = 1), at a position (V = 2), or everywhere.
struct FrictionRow {
  double place = 0;
  std::array<double, 5> p{};

  bool operator==(const FrictionRow&) const = default;
};

struct Friction {
  int variation = 0, law = 0;
  std::vector<FrictionRow> rows{FrictionRow{0, {.3, .3, 0, 0, 0}}};
  double memdst = 0, mem_s0 = 0;

  bool operator==(const Friction&) const = default;
};

/// Holds a grid of elements: the first centre, and the steps.
struct Grid {
  int mx = 0, my = 0;
  double xc = 0, yc = 0, dx = 0, dy = 0;

  long size() const { return long(mx) * my; }
  double x(int i) const { return xc + i * dx; }
  double y(int j) const { return yc + j * dy; }
  bool operator==(const Grid&) const = default;
};

struct HertzInput {
  int ipotcn = 0;  // 0: none
  int mx = 0, my = 0;
  double first = 0, second = 0, third = 0, scale = 1;
};

/// Holds the values of cntc_gethertzcontact.
struct HertzContact {
  double a1 = 0, b1 = 0, aa = 0, bb = 0, scale = 1, bneg = 0, bpos = 0;
};

struct PlaneGrid {
  int ipotcn = 0;
  double dx = .5, ds = .5, a_sep = 3.141592653589793, d_sep = 8, d_comb = 4, d_turn = 12, g_miss = -1;
};

/// Holds options of a profile in the order of cntc_setprofileinputfname: type, unused, mirrors in y and z, handling of
/// errors, kind of smoothing; factor, length of smoothing, share of points left out, angles of zig-zags and kinks,
/// width of kinks.
struct ProfileOptions {
  std::array<int, 6> ints{0, 0, 0, 0, 1, 0};
  std::array<double, 7> reals{0, 0, .5, 2.6179938779914944, .5235987755982988, .10471975511965977, 2};
};

/// Holds a profile as the caller gave it: a file, or points.
struct ProfileInput {
  bool given = false;
  bool wheel = false;
  std::string path;
  std::vector<double> points;
  ProfileOptions options;
  unsigned number = 0;  // counts changes
};

struct Track {
  int kind = 0;  // digit Z of the last call
  double gaught = 14, gaugsq = 0, gaugwd = 1435, raily0 = 0, railz0 = 0, cant = 0, nomrad = 0, curv = 0;
  std::array<double, 3> deviation{}, rate{};
  double ky = 0, fy = 0, kz = 0, fz = 0, dystep = 1;
};

struct Wheelset {
  double fbdist = 1360, fbpos = -70, nomrad = 460, ytape = 1000;
  std::array<double, 6> position{}, velocity{};
  std::array<double, 12> flexibility{};
};

/// Holds lists of x, y and z, in mm.
using Lists = std::array<std::vector<double>, 3>;

/// Holds a block of points inside the bodies, as it was given.
struct BlockInput {
  int isubs = 0;
  Lists lists;

  /// Returns 1: all elements, 2: a range of them, 3: a list of them, 9: places.
  int kind() const { return isubs == 9 ? 9 : (isubs - 1) % 4 + 1; }
};

/// Holds how the bodies of a contact meet and move.
struct Motion {
  double chi = 0, veloc = 1, dt = 1, dq = 1;
  double pen = 0, fn = 0, cksi = 0, ceta = 0, cphi = 0, spinxo = 0, spinyo = 0;
  double fx = 0, fy = 0;  // module 3: over fstat times fn
  std::vector<double> wx, wy;
};

/// Holds all that setters keep, in mm, s, N and rad; forces are those on body 1.
struct Inputs : Motion {
  Digits digits;
  Units units;
  SolverSettings solver;
  Material material;
  std::array<Heat, 2> heat;
  double betapl = 0;
  Friction friction;
  // Inputs of module 3.
  Grid grid;
  HertzInput hertz;
  int ibase = 1, iplan = 1;
  std::vector<double> gap{std::vector<double>(6)};
  std::array<double, 8> plan{};
  // Inputs of module 1.
  double fz = 0;
  PlaneGrid plane;
  ProfileInput rail, wheel;
  Track track;
  Wheelset wheelset;
  std::array<double, 9> metadata{};

  /// Tells whether there is a layer that yields.
  bool yields() const { return digits.mater == 4 && material.more[2] > 1e-10 && material.more[2] < 1e10; }
};

}  // namespace cntc
