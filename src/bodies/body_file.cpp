/// Prepared bodies to and from files. Sections: "body", what was given; "numbers", those of the nodes in the mesh's
/// file; of bodies with equations "response", numbers about them and the displacements under the body's own loads;
/// "factors", the factorised matrix (boundary elements: all of it; finite elements: what is condensed); "kept", the
/// responses to frames. Whatever else a body has is found again from the mesh.

#include <utility>

#include "bodies/body.hpp"
#include "bodies/model/archive.hpp"
#include "build_info.hpp"
#include "io/section_file.hpp"
#include "rollcon.h"
#include "support/error.hpp"

namespace rollcon {
namespace {

/// Version, raised whenever a section or the order of unknowns and equations changes.
constexpr std::uint32_t body_format = 5;

constexpr FileKind body_file{{0x89, 'R', 'C', 'B', '\r', '\n', 0x1a, '\n'},
                             "a saved body of rollcon",
                             body_format,
                             ROLLCON_ABI,
                             ROLLCON_VERSION_TEXT};

}  // namespace

void Body::save(const std::string& path) {
  prepare();
  SectionWriter file(path, body_file);
  write_content(*model_, file);
  if (!number_.empty()) {
    file.begin("numbers");
    OutArchive ar(file);
    ar(number_);
  }
  if (response() && response()->saved()) response()->saved()->save(file, own());
  file.commit();
}

std::shared_ptr<Body> Body::load(std::shared_ptr<Context> context, const std::string& path) {
  SectionReader file(path, body_file);
  auto model = std::make_shared<BodyModel>();
  read_content(file, *model);
  auto body = std::make_shared<Body>(std::move(context), static_cast<std::int32_t>(model->kind));
  body->options_ = model->options;
  body->model_ = std::move(model);
  body->loaded_ = true;
  try {
    body->prepare(&file);
  } catch (const Error& e) {
    // A body that could be saved is sound.
    const bool unsound = e.status() == Status::err_mesh || e.status() == Status::err_state ||
                         e.status() == Status::err_argument || e.status() == Status::err_singular;
    if (!unsound) throw;
    file.fail_here(e.what());
  }
  if (file.has("numbers")) {
    file.begin("numbers");
    InArchive ar(file);
    ar(body->number_);
    file.end();
    if (std::ssize(body->number_) != body->size().first) file.fail_here("counts of nodes and numbers do not match");
  }
  file.verify_rest();
  return body;
}

}  // namespace rollcon
