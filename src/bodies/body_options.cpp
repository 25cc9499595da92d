#include "bodies/body_options.hpp"

namespace rollcon {

const SettingTable<BodyOptions>& body_option_table() {
  static const SettingTable<BodyOptions> table{
      {"accuracy", &BodyOptions::accuracy, 1e-12, 1e-2,
       "Relative accuracy of the boundary integrals."},
      {"edge_angle", &BodyOptions::edge_angle, 1, 180,
       "Degrees between the normals of neighbouring faces beyond which their common edge is sharp: "
       "tractions may jump there."},
      {"keep_factors", &BodyOptions::keep_factors, 0, 1,
       "1: keeps the factorised matrix for further frames; 0: frees it once a frame has its "
       "compliance."},
  };
  return table;
}

}  // namespace rollcon
