#pragma once
/// Settings of a body by name.

#include "bodies/model/body_mesh.hpp"
#include "support/setting_table.hpp"

namespace rollcon {

const SettingTable<BodyOptions>& body_option_table();

}  // namespace rollcon
