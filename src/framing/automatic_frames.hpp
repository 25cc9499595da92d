#pragma once
/// Makes frames for contacts whose caller gave none: found from gap and load, fitted to the contact's edge, two of a
/// family, and finer ones until the accuracy asked for is met (docs/theory.md, section 4).

#include <memory>

#include "contact/contact.hpp"

namespace rollcon {

std::unique_ptr<FrameMaker> make_frame_maker();  ///< for Contact

}  // namespace rollcon
