#include "io/load_file.hpp"

#include <cstdio>

#include "io/profile_lines.hpp"
#include "io/whole_file.hpp"
#include "support/error.hpp"

namespace rollcon {
namespace {

/// CalculiX reads no more than 20 letters of a number.
std::string digits(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.13e", value);
  return text;
}

}  // namespace

std::string commented(const std::string& title, const char* mark) {
  std::string text = mark;
  for (const char c : title) {
    text += c;
    if (c == '\n') text += mark;
  }
  return text += '\n';
}

void write_loads(const std::string& path, std::span<const Vec3> force, std::span<const std::int64_t> number,
                 const std::string& title) {
  const std::string name = in_lower_case(path);
  std::string text;
  if (name.ends_with(".inp")) {
    text = commented(title, "** ") + "*CLOAD\n";
    for (std::size_t k = 0; k < force.size(); ++k)
      for (std::size_t c = 0; c < 3; ++c)
        if (force[k][c] != 0)
          text += std::to_string(number.empty() ? static_cast<std::int64_t>(k) + 1 : number[k]) + "," +
                  std::to_string(c + 1) + "," + digits(force[k][c]) + "\n";
  } else if (name.ends_with(".mtx")) {
    text = "%%MatrixMarket matrix array real general\n" + commented(title, "% ") + std::to_string(3 * force.size()) +
           " 1\n";
    for (const Vec3& f : force)
      for (const double x : f) text += digits(x) + "\n";
  } else {
    fail(Status::err_argument, "path '%s' ends in neither .inp (*CLOAD cards) nor .mtx (a MatrixMarket vector)",
         path.c_str());
  }
  write_whole_file(path, text);
}

}  // namespace rollcon
