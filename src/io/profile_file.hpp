#pragma once
/// Reads and writes profiles of wheels and rails in files: columns, Simpack's .prr and .prw, Miniprof's .ban, .whl and
/// .mpt, told apart by the end of the name; docs/profiles.md describes them.

#include <array>
#include <cstdint>
#include <string>
#include <vector>

namespace rollcon {

struct ProfileFile {
  std::vector<std::array<double, 2>> point;  ///< y, z; in mm from Simpack and Miniprof
  std::vector<std::int64_t> line;            ///< line of each point, from 1
  std::string told;                          ///< what was passed over and might be missed; empty: nothing
};

/// Throws err_io naming the file, and the line where there is one.
ProfileFile read_profile_file(const std::string& path);

/// Writes Simpack's form (in mm, so that units.len.f is 1000) for names that end in .prr or .prw, else two columns. The
/// file appears whole or not at all. Throws err_io.
void write_profile_file(const std::string& path, const std::vector<std::array<double, 2>>& point);

}  // namespace rollcon
