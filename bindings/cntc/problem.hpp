#pragma once
#include <map>
#include <memory>
#include <mutex>

#include "inputs.hpp"
#include "result.hpp"

namespace cntc {

class ContactSolver;
class WheelSolver;

struct SubsurfaceBlock {
  BlockInput input;
  int nx = 0, ny = 0, nz = 0;
  std::vector<double> columns;  // 21 values for each point, point by point; empty: not calculated
};

/// Holds a contact problem: a contact (ire, icp) of module 3, or a whole wheel (ire, -1) of module 1 with its patches.
struct Problem {
  Problem(int ire, int icp, int module);
  ~Problem();

  int ire, icp, module;
  std::mutex mutex;
  Inputs in;
  std::vector<ContactResult> patches;                  // module 3: always one
  std::map<int, std::vector<SubsurfaceBlock>> blocks;  // by patch; -1: all patches
  HertzContact hertz;
  double cpu = 0, wall = 0;
  double fn_before = 0, fx_before = 0, fy_before = 0;  // elastic forces of the last case
  bool has_before = false;
  std::unique_ptr<ContactSolver> contact;
  std::unique_ptr<WheelSolver> wheel;
};

}  // namespace cntc
