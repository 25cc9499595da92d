#pragma once
/// Writes forces on nodes for programs of finite elements.

#include <cstdint>
#include <span>
#include <string>

#include "mesh/vec3.hpp"

namespace rollcon {

/// Returns lines that begin with a mark.
std::string commented(const std::string& title, const char* mark);

/// Writes *CLOAD cards of Abaqus and CalculiX where the name ends in .inp, of the components that are not zero; where
/// it ends in .mtx a MatrixMarket vector of x, y, z of each node. number: the nodes' numbers; empty: they count from 1.
/// title: told in the file, lines apart by \n. err_argument: another ending; err_io.
void write_loads(const std::string& path, std::span<const Vec3> force, std::span<const std::int64_t> number,
                 const std::string& title);

}  // namespace rollcon
