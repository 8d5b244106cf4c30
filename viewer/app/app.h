// The modeller: state, user interface and picture of one session. Knows neither window nor OpenGL
// context; driven frame by frame with the input that arrived.
#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "app/recording.h"
#include "events/input.h"
#include "picture/picture.h"
#include "render/renderer.h"
#include "scene/mesh_parts.h"
#include "scene/scene.h"

namespace sectile::viewer {

class Session;
class Widgets;

struct AppOptions {
  std::filesystem::path data_folder;  ///< settings and recovery; empty: none are kept
  bool dark = false;
  bool show_interface = true;     ///< false: the picture alone
  bool fast_pictures = false;     ///< all of them with the care of those in a drag
  bool draw_on_request = false;   ///< nobody sees the frames but those that draw() is called for
  bool wait_for_results = false;  ///< tests and screenshots: frame() waits for the evaluator
};

class App {
 public:
  App(GraphicsContext& context, const AppOptions& options);
  ~App();
  App(const App&) = delete;
  App& operator=(const App&) = delete;

  /// Handles the input, makes one frame and draws it. `seconds` since the last frame.
  void frame(const Input& input, double seconds);
  bool wants_to_close() const;
  bool needs_frame() const;  ///< something moves or is being computed
  /// How many seconds the next frame may wait while no event arrives. What is computed wakes the
  /// window when it is done.
  double time_to_next_frame() const;
  void draw();         ///< the last frame, unless it is drawn
  Image screenshot();  ///< of the last frame, drawn if it was not
  const DrawnWork& drawn() const;
  /// Pictures or a film without the interface; written when needs_frame() is false again.
  void record(const RecordingPlan& plan);
  std::vector<Image> film(const RecordingPlan& plan);  ///< the same at once

  // What tests and the command line drive and look at.
  void open(const std::filesystem::path& path);  ///< a scene or a mesh; errors appear in the window
  void open_sample(const std::string& name);
  void start(Scene scene, const std::filesystem::path& path);  ///< as it was read from a file
  void add(const std::filesystem::path& path, const std::vector<MeshPart>& parts);
  const Scene& scene() const;
  const Camera& camera() const;
  void set_camera(const Camera& camera);
  void show_step(Phase phase, std::size_t step);  ///< of the story of the selected operation
  /// The rectangle (UI units: x, y, width, height) of a named widget in the last frame; throws if
  /// it was not there.
  glm::vec4 widget(const std::string& name) const;
  bool has_widget(const std::string& name) const;
  /// Where a point of the world is in the window, in UI units.
  glm::dvec2 on_screen(const glm::dvec3& point) const;
  std::string last_message() const;
  std::string title() const;       ///< of the window
  const Widgets& widgets() const;  ///< all of the last frame
  const Session& session() const;

 private:
  class Implementation;
  std::unique_ptr<Implementation> implementation_;
};

}  // namespace sectile::viewer
