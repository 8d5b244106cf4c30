// sectile-viewer: the modeller in a window, or pictures without one.
#include <exception>
#include <filesystem>
#include <iostream>
#include <memory>

#include "program/arguments.h"
#include "program/film.h"
#include "program/modeller.h"
#include "program/story_screenshot.h"
#include "program/tour_pictures.h"
#include "render/renderer.h"
#include "render/window.h"

namespace sectile::viewer {
namespace {

ExitCode draw_picture(const Arguments& arguments, const std::filesystem::path& path) {
  const Image image =
      arguments.is_story_picture() ? story_screenshot(arguments) : modeller_screenshot(arguments);
  write_png(path.string(), image);
  std::cout << std::filesystem::absolute(path).string() << '\n';
  return ExitCode::done;
}

// Null, and the reason told, if there is no display.
std::unique_ptr<Window> open_window(const Arguments& arguments) {
  try {
    return std::make_unique<Window>("Sectile", arguments.width, arguments.height, arguments.scale);
  } catch (const std::runtime_error& error) {
    std::cerr << "sectile-viewer: " << error.what() << '\n';
    return nullptr;
  }
}

ExitCode run(const Arguments& arguments) {
  if (arguments.film) {
    std::cout << std::filesystem::absolute(write_film(arguments)).string() << '\n';
    return ExitCode::done;
  }
  if (!arguments.tour.empty()) {
    std::cout << std::filesystem::absolute(write_tour(arguments.tour)).string() << '\n';
    return ExitCode::done;
  }
  if (!arguments.screenshot.empty()) return draw_picture(arguments, arguments.screenshot);
  const std::unique_ptr<Window> window = open_window(arguments);
  if (!window) return draw_picture(arguments, "sectile-viewer.png");
  run_in_window(arguments, *window);
  return ExitCode::done;
}

ExitCode run_safely(const Arguments& arguments) {
  const auto tell = [](ExitCode code, const std::exception& error) {
    std::cerr << "sectile-viewer: " << error.what() << '\n';
    return code;
  };
  try {
    return run(arguments);
  } catch (const InvalidSolid& error) {
    return tell(ExitCode::not_legal, error);
  } catch (const FileError& error) {
    return tell(ExitCode::file, error);
  } catch (const std::invalid_argument& error) {
    return tell(ExitCode::usage, error);
  } catch (const std::exception& error) {
    return tell(ExitCode::internal, error);
  }
}

}  // namespace
}  // namespace sectile::viewer

int main(int argc, char** argv) {
  using namespace sectile::viewer;
  const auto parsed = parse_arguments(argc, argv);
  const auto* arguments = std::get_if<Arguments>(&parsed);
  const ExitCode code = arguments ? run_safely(*arguments) : std::get<ExitCode>(parsed);
  return static_cast<int>(code);
}
