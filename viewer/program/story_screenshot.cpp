#include "program/story_screenshot.h"

#include <stdexcept>

#include "picture/surface_mesh.h"
#include "picture/theme.h"
#include "render/renderer.h"
#include "samples/samples.h"
#include "story/story.h"

namespace sectile::viewer {
namespace {

struct Operands {
  Solid a, b;
  Operation operation = Operation::unite;
  std::optional<HalfSpace> plane;  // instead of b, for samples of splitting
};

Operands operands_of(const Arguments& arguments) {
  Operands operands;
  if (!arguments.sample.empty()) {
    const samples::Sample sample = samples::get(arguments.sample);
    operands = {sample.a, sample.b, sample.operation.value_or(Operation::unite), sample.plane};
  } else {
    operands.a = Solid::from_mesh(read_mesh(arguments.files.at(0)));
    operands.b = Solid::from_mesh(read_mesh(arguments.files.at(1)));
  }
  if (arguments.operation) operands.operation = *arguments.operation;
  return operands;
}

Picture picture_of_step(const Arguments& arguments, const Operands& operands) {
  if (operands.plane)
    throw std::invalid_argument("sample " + arguments.sample + " is split by a plane: no phases");
  const Story story = Story::tell(operands.a, operands.b, operands.operation);
  const StoryView view{arguments.eight_way, arguments.exploded, false, arguments.dark};
  const auto [first, end] = story.range(*arguments.phase);
  if (first == end && arguments.step == 0) return story.picture(*arguments.phase, view);
  if (arguments.step > end - first) {
    throw std::invalid_argument("phase " + std::string(name_of(*arguments.phase)) + " has only " +
                                std::to_string(end - first) + " steps");
  }
  return story.picture(arguments.step == 0 ? end - 1 : first + arguments.step - 1, view);
}

void add(Picture& picture, const Solid& solid, const Colour& colour, bool translucent) {
  if (solid.is_empty()) return;
  Surface surface;
  surface.mesh = surface_mesh(solid);
  surface.colour = colour;
  surface.translucent = translucent;
  picture.surfaces.push_back(std::move(surface));
}

Picture picture_of_operands(const Operands& operands, const Theme& colours) {
  Picture picture;
  if (operands.plane) {
    const auto [above, below] = split(operands.a, *operands.plane);
    add(picture, above, colours.a_out_b, false);
    add(picture, below, colours.b_out_a, false);
    return picture;
  }
  add(picture, operands.a, colours.a, true);
  add(picture, operands.b, colours.b, true);
  return picture;
}

}  // namespace

Image story_screenshot(const Arguments& arguments) {
  const Theme& colours = theme(arguments.dark);
  const Operands operands = operands_of(arguments);
  Picture picture = arguments.phase ? picture_of_step(arguments, operands)
                                    : picture_of_operands(operands, colours);
  picture.surroundings = colours.surroundings;
  picture.quality = Quality::full;
  const double aspect = static_cast<double>(arguments.width) / arguments.height;
  const Bounds all = picture.bounds();
  picture.camera.look_at(all, aspect);
  if (arguments.camera) picture.camera = arguments.camera->applied_to(picture.camera, all, aspect);

  const float scale = arguments.scale > 0 ? arguments.scale : 1;
  const auto context = make_osmesa_context(arguments.width, arguments.height, scale);
  Renderer renderer(*context);
  renderer.begin_frame();
  renderer.draw(picture, {0, 0, arguments.width, arguments.height});
  return renderer.read_frame();
}

}  // namespace sectile::viewer
