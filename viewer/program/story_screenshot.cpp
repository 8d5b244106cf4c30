#include "program/story_screenshot.h"

#include <optional>

#include "picture/surface_mesh.h"
#include "picture/theme.h"
#include "program/phase_picture.h"
#include "program/solid_file.h"
#include "render/renderer.h"
#include "samples/samples.h"

namespace sectile::viewer {
namespace {

StoryOperands operands_of(const Arguments& arguments) {
  StoryOperands operands;
  if (!arguments.sample.empty()) {
    operands = sample_operands(arguments.sample);
  } else {
    operands.a = solid_of_file(arguments.files[0], read_mesh(arguments.files[0]));
    operands.b = solid_of_file(arguments.files[1], read_mesh(arguments.files[1]));
  }
  if (arguments.operation && !operands.split) operands.operation = *arguments.operation;
  return operands;
}

Picture picture_of_step(const Arguments& arguments, double aspect) {
  const StoryOperands operands = operands_of(arguments);
  const Story story = tell(operands);
  const StoryView view{arguments.eight_way, arguments.exploded, false, arguments.dark};
  return phase_picture(story, *arguments.phase,
                       arguments.step == 0 ? last_step : arguments.step - 1, view, aspect);
}

void add(Picture& picture, const Solid& solid, const Colour& colour, bool translucent) {
  if (solid.is_empty()) return;
  Surface surface;
  surface.mesh = surface_mesh(solid);
  surface.colour = colour;
  surface.translucent = translucent;
  picture.surfaces.push_back(std::move(surface));
}

Picture picture_of_operands(const Arguments& arguments, double aspect) {
  const Theme& colours = theme(arguments.dark);
  Picture picture;
  const auto plane = arguments.sample.empty() ? std::nullopt : samples::get(arguments.sample).plane;
  if (plane) {
    const auto [above, below] = split(operands_of(arguments).a, *plane);
    add(picture, above, colours.a_out_b, false);
    add(picture, below, colours.b_out_a, false);
  } else {
    const StoryOperands operands = operands_of(arguments);
    add(picture, operands.a, colours.a, true);
    add(picture, operands.b, colours.b, true);
  }
  picture.surroundings = colours.surroundings;
  picture.camera.look_at(picture.bounds(), aspect);
  return picture;
}

}  // namespace

Image story_screenshot(const Arguments& arguments) {
  const double aspect = static_cast<double>(arguments.width) / arguments.height;
  Picture picture =
      arguments.phase ? picture_of_step(arguments, aspect) : picture_of_operands(arguments, aspect);
  picture.quality = Quality::full;
  if (arguments.camera)
    picture.camera = arguments.camera->applied_to(picture.camera, picture.bounds(), aspect);

  const float scale = arguments.scale > 0 ? arguments.scale : 1;
  const auto context = make_offscreen_context(arguments.width, arguments.height, scale);
  Renderer renderer(*context);
  renderer.begin_frame();
  renderer.draw(picture, {0, 0, arguments.width, arguments.height});
  return renderer.read_frame();
}

}  // namespace sectile::viewer
