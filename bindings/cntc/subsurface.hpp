#pragma once
#include <rollcon.h>

#include <string>

#include "problem.hpp"

namespace cntc {

/// Finds the coordinates of the points of a block, in ascending order.
void lay_points(const BlockInput& input, const Grid& grid, std::vector<double>& x, std::vector<double>& y,
                std::vector<double>& z);

/// Fills a block with displacements and stresses of a solved contact; throws Failure.
void fill_block(rollcon_contact* contact, const ContactResult& result, double mirror, SubsurfaceBlock& block);

/// Calculates the blocks of a patch, or of all patches with icp -1; returns an error code.
int calculate_blocks(Problem& p, int icp, std::string& why);

}  // namespace cntc
