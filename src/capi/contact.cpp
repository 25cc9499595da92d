/// Implements the calls that make contacts and describe their scenes.

#include "contact/contact.hpp"

#include "build_info.hpp"
#include "capi/guard.hpp"
#include "framing/automatic_frames.hpp"
#include "procedures/published.hpp"
#include "support/input_checks.hpp"

using namespace rollcon;
using namespace rollcon::capi;

namespace {

#if ROLLCON_BUILD_PROCEDURES
constexpr MakePublished published = make_published;
#else
constexpr MakePublished published = nullptr;
#endif

}  // namespace

rollcon_status rollcon_contact_create(rollcon_context* context, rollcon_body* body1, rollcon_body* body2,
                                      rollcon_contact** contact) {
  if (contact) *contact = nullptr;
  return with_object(__func__, Kind::context, context, [&](Object& parent) {
    std::shared_ptr<Body> first = body_of(body1, "body1");
    std::shared_ptr<Body> second = body_of(body2, "body2");
    require_pointer(contact, "contact");
    auto object = std::make_shared<Object>();
    object->context = parent.context;
    object->contact =
        std::make_shared<Contact>(parent.context, std::move(first), std::move(second), published, make_frame_maker);
    *contact = static_cast<rollcon_contact*>(const_cast<void*>(handles().insert(Kind::contact, std::move(object))));
  });
}
