#include "program/film.h"

#include <stdexcept>

#include "app/app.h"
#include "app/session.h"
#include "program/modeller.h"

namespace sectile::viewer {

std::filesystem::path write_film(const Arguments& arguments) {
  RecordingPlan plan = *arguments.film;
  plan.width = static_cast<std::uint32_t>(arguments.width);
  plan.height = static_cast<std::uint32_t>(arguments.height);
  Arguments shown = arguments;
  shown.interface = false;
  // The steps of the operation are told before the film begins.
  if (plan.kind == RecordingPlan::Kind::steps && !shown.phase) {
    shown.phase = Phase::reduction;
    shown.step = 1;
  }
  std::vector<Image> images;
  with_still_modeller(shown, [&](App& app) {
    if (const std::string problem = problem_of(plan, app.session().results); !problem.empty())
      throw std::invalid_argument(problem);
    images = app.film(plan);
  });
  write_recording(plan, images);
  const bool is_numbered = plan.path.extension() != ".gif";
  return is_numbered ? numbered(plan.path, 0, images.size()) : plan.path;
}

}  // namespace sectile::viewer
