#include "program/arguments.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <map>
#include <numbers>

#include "samples/samples.h"

namespace sectile::viewer {
namespace {

constexpr std::array all_phases = {Phase::reduction,  Phase::vertex_face, Phase::vertex_vertex,
                                   Phase::null_edges, Phase::joining,     Phase::components,
                                   Phase::gluing,     Phase::cleanup};

constexpr const char* examples = R"(Examples:
  sectile-viewer                                     the modeller
  sectile-viewer bracket.obj bolt.stl                with two solids
  sectile-viewer --sample fig13                      with a figure of the paper
  sectile-viewer --sample fig13 --screenshot window.png --size 1280x800
  sectile-viewer --sample fig13 --phase joining --step 2 --exploded 0.5 \
      --no-interface --screenshot step.png
  sectile-viewer --sample fig13 --turntable around.gif --frames 48 --size 640x480
  sectile-viewer --sample fig13 --film-steps step.png     numbered frames of the steps
Without a display a picture is drawn into sectile-viewer.png.
Exit codes: 0 done, 1 an input is not a legal solid, 2 wrong usage,
  3 a file cannot be read or written, 4 internal error.)";

const std::map<std::string, Operation> operations = {{"union", Operation::unite},
                                                     {"intersect", Operation::intersect},
                                                     {"subtract", Operation::subtract}};

Phase phase_named(std::string name) {
  std::replace(name.begin(), name.end(), '-', '_');
  std::string known;
  for (std::size_t i = 0; i < all_phases.size(); ++i) {
    const std::string_view candidate = name_of(all_phases[i]);
    if (name == candidate || name == std::to_string(i + 1)) return all_phases[i];
    known += (known.empty() ? "" : ", ") + std::string(candidate);
  }
  throw CLI::ValidationError("--phase", "there is no phase " + name + "; phases are " + known);
}

std::vector<double> numbers_in(const std::string& option, const std::string& text, char separator) {
  std::vector<double> values;
  for (const std::string& part : CLI::detail::split(text, separator)) {
    double value = 0;
    if (!CLI::detail::lexical_cast(part, value) || !std::isfinite(value))
      throw CLI::ValidationError(option, "'" + part + "' is not a number");
    values.push_back(value);
  }
  return values;
}

CameraWish camera_from(const std::string& text) {
  const std::vector<double> v = numbers_in("--camera", text, ',');
  if (v.size() != 3 && v.size() != 6)
    throw CLI::ValidationError("--camera", "azimuth,elevation,distance or these and x,y,z");
  if (v[2] < 0) throw CLI::ValidationError("--camera", "the distance is negative");
  CameraWish wish{v[0], v[1], v[2], std::nullopt};
  if (v.size() == 6) wish.target = glm::dvec3(v[3], v[4], v[5]);
  return wish;
}

void set_size(Arguments& arguments, const std::string& text) {
  const std::vector<double> v = numbers_in("--size", text, 'x');
  if (v.size() != 2 || v[0] < 16 || v[1] < 16 || v[0] > 16384 || v[1] > 16384)
    throw CLI::ValidationError("--size", "WIDTHxHEIGHT, each 16 to 16384");
  arguments.width = static_cast<int>(v[0]);
  arguments.height = static_cast<int>(v[1]);
}

// What is written is a PNG, so its name must not say something else.
void check_picture_name(const std::filesystem::path& path) {
  std::string extension = path.extension().string();
  std::transform(extension.begin(), extension.end(), extension.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  if (!path.empty() && extension != ".png")
    throw CLI::ValidationError(
        "--screenshot", "'" + path.string() + "' must end in .png: pictures are written as PNG");
}

RecordingPlan film_plan(RecordingPlan::Kind kind, const std::string& path, double seconds) {
  RecordingPlan plan;
  plan.kind = kind;
  plan.path = path;
  const std::string extension = plan.path.extension().string();
  if (extension != ".gif" && extension != ".png")
    throw CLI::ValidationError(path, "a film's name ends in .gif, or in .png for numbered frames");
  const bool steps = kind == RecordingPlan::Kind::steps;
  plan.seconds_per_frame = seconds > 0 ? seconds : steps ? 0.8 : 0.08;
  return plan;
}

void check_sample(const std::string& name) {
  std::string known;
  for (const samples::Sample& sample : samples::all()) {
    if (sample.name == name) return;
    known += (known.empty() ? "" : ", ") + sample.name;
  }
  throw CLI::ValidationError("--sample", "there is no sample " + name + "; samples are " + known);
}

}  // namespace

Camera CameraWish::applied_to(Camera camera, const Bounds& all, double aspect) const {
  constexpr double degree = std::numbers::pi / 180;
  camera.azimuth = azimuth * degree;
  camera.elevation = elevation * degree;
  camera.look_at(all, aspect);
  if (distance > 0) camera.distance = distance;
  if (target) camera.target = *target;
  return camera;
}

bool Arguments::is_story_picture() const {
  return !interface && scene.empty() && (!sample.empty() || files.size() == 2);
}

std::variant<Arguments, ExitCode> parse_arguments(int argc, char** argv) {
  Arguments arguments;
  std::string phase, camera, size;
  bool no_interface = false;
  CLI::App program("Places solids, shows exact Booleans of them and how they come about",
                   "sectile-viewer");
  program.footer(examples);
  program.set_version_flag("--version", "sectile-viewer " SECTILE_VERSION, "print the version");
  program.set_help_flag("-h,--help", "print this help");
  program.add_option("files", arguments.files, "solids to place: OBJ, STL, OFF, PLY, 3MF")
      ->type_name("FILE...");
  program.add_option("--scene", arguments.scene, "a scene to open");
  auto* sample = program.add_option("--sample", arguments.sample, "a figure of the paper to open");
  program.add_option("--screenshot", arguments.screenshot, "write a picture and exit")
      ->type_name("OUT.png");
  program.add_option("--tour", arguments.tour, "write the tour of the paper as a page and exit")
      ->type_name("DIR");
  std::string turntable, film_steps;
  double seconds = 0;
  std::uint32_t frames = 48;
  auto* turns = program.add_option("--turntable", turntable, "write a film once around and exit")
                    ->type_name("OUT.gif|OUT.png");
  auto* steps_film =
      program.add_option("--film-steps", film_steps, "write a film of the steps and exit")
          ->type_name("OUT.gif|OUT.png")
          ->excludes(turns);
  program.add_option("--frames", frames, "of a turntable")->check(CLI::Range(1, 720))->needs(turns);
  program.add_option("--seconds", seconds, "for each frame of a film")
      ->check(CLI::Range(0.02, 60.0));
  program.add_option("--size", size, "of the picture or window")->type_name("WIDTHxHEIGHT");
  program.add_option("--scale", arguments.scale, "pixels for each unit of the interface")
      ->check(CLI::Range(0.5, 8.0));
  program.add_flag("--dark", arguments.dark, "the dark theme");
  program.add_flag("--no-interface", no_interface, "the picture alone");
  program.add_option("--camera", camera, "degrees, degrees, length (0: all in view), place")
      ->type_name("AZIMUTH,ELEVATION,DISTANCE[,X,Y,Z]");
  auto* phase_option = program.add_option("--phase", phase, "show this phase of the algorithm");
  program.add_option("--step", arguments.step, "of the phase, from 1; its last if not given")
      ->needs(phase_option);
  std::string operation;
  auto* alone = program.add_option("--operation", operation, "union, intersect or subtract")
                    ->check(CLI::IsMember(operations));
  auto* exploded = program.add_option("--exploded", arguments.exploded, "pull the parts apart")
                       ->check(CLI::Range(0.0, 1.0));
  auto* eight_way = program.add_flag("--eight-way", arguments.eight_way, "colours of eight parts");
  try {
    program.parse(argc, argv);
    arguments.interface = !no_interface;
    check_picture_name(arguments.screenshot);
    if (*turns) {
      arguments.film = film_plan(RecordingPlan::Kind::turntable, turntable, seconds);
      arguments.film->frames = frames;
    }
    if (*steps_film) arguments.film = film_plan(RecordingPlan::Kind::steps, film_steps, seconds);
    if (!phase.empty()) arguments.phase = phase_named(phase);
    if (!camera.empty()) arguments.camera = camera_from(camera);
    if (!size.empty()) set_size(arguments, size);
    if (*sample) check_sample(arguments.sample);
    if (!operation.empty()) arguments.operation = operations.at(operation);
    const bool is_of_story = *alone || *exploded || *eight_way;
    if (is_of_story && (!arguments.is_story_picture() || arguments.screenshot.empty())) {
      throw CLI::ValidationError(
          "--operation, --exploded and --eight-way",
          "go with --screenshot, --no-interface and either --sample or two files");
    }
  } catch (const CLI::ParseError& error) {
    const int code = program.exit(error);
    return code == 0 ? ExitCode::done : ExitCode::usage;
  }
  return arguments;
}

}  // namespace sectile::viewer
