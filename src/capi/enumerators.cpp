/// Generated from bindings/api.toml by bindings/generate.py; do not edit.
/// Asserts that the enumerators inside the library are those of the header; this file can only fail to compile.

#include "bodies/body.hpp"
#include "contact/contact.hpp"
#include "mesh/volume_type.hpp"
#include "rollcon.h"

namespace rollcon {

template <class E>
constexpr bool same(E inside, int outside) {
  return static_cast<int>(inside) == outside;
}

// clang-format off
static_assert(same(Status::ok, ROLLCON_OK));
static_assert(same(Status::not_converged, ROLLCON_NOT_CONVERGED));
static_assert(same(Status::no_contact, ROLLCON_NO_CONTACT));
static_assert(same(Status::cancelled, ROLLCON_CANCELLED));
static_assert(same(Status::rim_contact, ROLLCON_RIM_CONTACT));
static_assert(same(Status::coarse, ROLLCON_COARSE));
static_assert(same(Status::inaccurate, ROLLCON_INACCURATE));
static_assert(same(Status::too_deep, ROLLCON_TOO_DEEP));
static_assert(same(Status::derailed, ROLLCON_DERAILED));
static_assert(same(Status::err_argument, ROLLCON_ERR_ARGUMENT));
static_assert(same(Status::err_handle, ROLLCON_ERR_HANDLE));
static_assert(same(Status::err_nonfinite, ROLLCON_ERR_NONFINITE));
static_assert(same(Status::err_mesh, ROLLCON_ERR_MESH));
static_assert(same(Status::err_state, ROLLCON_ERR_STATE));
static_assert(same(Status::err_option, ROLLCON_ERR_OPTION));
static_assert(same(Status::err_capacity, ROLLCON_ERR_CAPACITY));
static_assert(same(Status::err_singular, ROLLCON_ERR_SINGULAR));
static_assert(same(Status::err_memory, ROLLCON_ERR_MEMORY));
static_assert(same(Status::err_unsupported, ROLLCON_ERR_UNSUPPORTED));
static_assert(same(Status::err_busy, ROLLCON_ERR_BUSY));
static_assert(same(Status::err_load, ROLLCON_ERR_LOAD));
static_assert(same(Status::err_io, ROLLCON_ERR_IO));
static_assert(same(Status::err_internal, ROLLCON_ERR_INTERNAL));
static_assert(same(BodyKind::fem, ROLLCON_BODY_FEM));
static_assert(same(BodyKind::bem, ROLLCON_BODY_BEM));
static_assert(same(BodyKind::halfspace, ROLLCON_BODY_HALFSPACE));
static_assert(same(BodyKind::rigid, ROLLCON_BODY_RIGID));
static_assert(same(BodyKind::section, ROLLCON_BODY_SECTION));
static_assert(same(BodyKind::condensed, ROLLCON_BODY_CONDENSED));
static_assert(same(ElementType::tri3, ROLLCON_TRI3));
static_assert(same(ElementType::tri6, ROLLCON_TRI6));
static_assert(same(ElementType::quad4, ROLLCON_QUAD4));
static_assert(same(ElementType::quad8, ROLLCON_QUAD8));
static_assert(same(ElementType::quad9, ROLLCON_QUAD9));
static_assert(same(VolumeType::tet4, ROLLCON_TET4));
static_assert(same(VolumeType::tet10, ROLLCON_TET10));
static_assert(same(VolumeType::wedge6, ROLLCON_WEDGE6));
static_assert(same(VolumeType::wedge15, ROLLCON_WEDGE15));
static_assert(same(VolumeType::hex8, ROLLCON_HEX8));
static_assert(same(VolumeType::hex20, ROLLCON_HEX20));
static_assert(same(Direction::longitudinal, ROLLCON_LONGITUDINAL));
static_assert(same(Direction::lateral, ROLLCON_LATERAL));
static_assert(same(Direction::normal, ROLLCON_NORMAL));
static_assert(same(Direction::spin, ROLLCON_SPIN));
static_assert(same(Direction::tilt1, ROLLCON_TILT_1));
static_assert(same(Direction::tilt2, ROLLCON_TILT_2));
static_assert(same(Parameter::longitudinal, ROLLCON_LONGITUDINAL));
static_assert(same(Parameter::lateral, ROLLCON_LATERAL));
static_assert(same(Parameter::normal, ROLLCON_NORMAL));
static_assert(same(Parameter::spin, ROLLCON_SPIN));
static_assert(same(Parameter::tilt1, ROLLCON_TILT_1));
static_assert(same(Parameter::tilt2, ROLLCON_TILT_2));
static_assert(same(Parameter::friction, ROLLCON_FRICTION));
static_assert(same(How::by_motion, ROLLCON_BY_MOTION));
static_assert(same(How::by_force, ROLLCON_BY_FORCE));
static_assert(same(InAxes::local, ROLLCON_LOCAL));
static_assert(same(InAxes::global, ROLLCON_GLOBAL));
static_assert(same(Field::point, ROLLCON_FIELD_POINT));
static_assert(same(Field::traction, ROLLCON_FIELD_TRACTION));
static_assert(same(Field::gap, ROLLCON_FIELD_GAP));
static_assert(same(Field::slip, ROLLCON_FIELD_SLIP));
static_assert(same(Field::displacement1, ROLLCON_FIELD_DISPLACEMENT1));
static_assert(same(Field::displacement2, ROLLCON_FIELD_DISPLACEMENT2));
static_assert(same(Field::area, ROLLCON_FIELD_AREA));
static_assert(same(Field::friction, ROLLCON_FIELD_FRICTION));
static_assert(same(Field::pressure, ROLLCON_FIELD_PRESSURE));
static_assert(same(Field::rigid_slip, ROLLCON_FIELD_RIGID_SLIP));
static_assert(same(Field::friction_power, ROLLCON_FIELD_FRICTION_POWER));
static_assert(same(Field::weight, ROLLCON_FIELD_WEIGHT));
static_assert(same(Field::temperature, ROLLCON_FIELD_TEMPERATURE));
static_assert(same(NodeStatus::open, ROLLCON_OPEN));
static_assert(same(NodeStatus::stick, ROLLCON_STICK));
static_assert(same(NodeStatus::slip, ROLLCON_SLIP));
static_assert(same(NodeStatus::excluded, ROLLCON_EXCLUDED));
static_assert(same(StepKind::steady, ROLLCON_STEADY));
static_assert(same(StepKind::rolling, ROLLCON_ROLLING_STEP));
static_assert(same(StepKind::shift, ROLLCON_SHIFT_STEP));
static_assert(same(LogLevel::error, ROLLCON_LOG_ERROR));
static_assert(same(LogLevel::warning, ROLLCON_LOG_WARNING));
static_assert(same(LogLevel::info, ROLLCON_LOG_INFO));
static_assert(same(LogLevel::debug, ROLLCON_LOG_DEBUG));
static_assert(same(SettingType::integer, ROLLCON_TYPE_INT));
static_assert(same(SettingType::real, ROLLCON_TYPE_REAL));
static_assert(same(SettingType::text, ROLLCON_TYPE_STR));
static_assert(same(Phase::compliance, ROLLCON_PHASE_COMPLIANCE));
static_assert(same(Phase::normal, ROLLCON_PHASE_NORMAL));
static_assert(same(Phase::tangential, ROLLCON_PHASE_TANGENTIAL));
static_assert(same(Phase::full, ROLLCON_PHASE_FULL));
static_assert(same(Phase::cases, ROLLCON_PHASE_CASES));
// clang-format on

}  // namespace rollcon
