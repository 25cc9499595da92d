#pragma once
/// A snapshot of a patch: all that a later solve or result depends on.

#include "contact/solution.hpp"
#include "wheelrail/patch_contact.hpp"

namespace rollcon {

struct PatchContact::Kept {
  State state;
  Solution solution;
  strips::StripSolution strips;
};

}  // namespace rollcon
