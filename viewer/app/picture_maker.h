// The picture of a session: the solids of the scene, or the present step of the story.
#pragma once

#include <memory>

#include "app/session.h"
#include "picture/picture.h"

namespace sectile::viewer {

class PictureMaker {
 public:
  Picture make(const Session& session);

 private:
  Picture model(const Session& session) const;
  void outline_section(Picture& picture);
  const Picture& steps(const Session& session);

  // The last picture of the story, and what it was made for.
  std::shared_ptr<const Story> story_;
  std::size_t step_ = 0;
  Phase phase_ = Phase::reduction;
  StoryView view_;
  Picture picture_;
  // The outlines of the last section, and what they were made for.
  std::vector<Surface> cut_;
  glm::dvec4 plane_{0};
  std::vector<glm::vec3> outlines_;
};

/// What is drawn of a node in the model.
struct Shape {
  NodeId node = 0;
  Surface surface;
  bool is_operand = false;  ///< shown together with the result it is part of
};
/// Everything that is drawn in the model; also what can be clicked.
std::vector<Shape> visible_shapes(const Session& session);

}  // namespace sectile::viewer
