// Frames of the whole modeller (scene and interface, drawn by Mesa's software renderer) each
// second: while a scene of 100,000 triangles is turned, and while B (1,000 triangles) is dragged
// through A (100,000) by a handle; then also how many new results are seen each second.
//   viewer_bench [SECONDS] [WIDTHxHEIGHT] [turn | turn-result | drag]
#include <ctime>

#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <filesystem>
#include <set>
#include <string>

#include "app/app.h"
#include "app/session.h"
#include "app/widgets.h"
#include "ball.h"
#include "scene/scene_file.h"

namespace {

using namespace sectile;
using namespace sectile::viewer;
using bench::ball;

struct BenchScene {
  Scene scene;
  NodeId a = 0, b = 0, result = 0;
};

BenchScene bench_scene(bool combined) {
  BenchScene made;
  made.a = made.scene.add(ball("A", 320, 157, 2));  // 99,840 triangles
  if (!combined) return made;
  made.b = made.scene.add(ball("B", 32, 17, 0.6));  // 1,024
  made.scene.edit(made.b).placement.position = {1.2, -1.2, 1.1};
  made.result = made.scene.combine({made.a, made.b}, Operation::subtract);
  return made;
}

// The modeller without a window, as a person would use it.
class Bench {
 public:
  Bench(int width, int height, const Scene& scene)
      : context_(make_offscreen_context(width, height)), app_(*context_, {}) {
    const auto path = std::filesystem::temp_directory_path() / "sectile_viewer_bench.sectile";
    write_scene(path, {scene, {}});
    app_.open(path);
    do frame({});
    while (app_.needs_frame() || app_.scene().size() < scene.size());
    std::filesystem::remove(path);
  }

  App& app() { return app_; }

  void frame(std::vector<Event> events) {
    const auto now = Clock::now();
    app_.frame(Input{std::move(events)}, std::chrono::duration<double>(now - last_).count());
    last_ = now;
  }
  void mouse(Event::Kind kind, glm::dvec2 at) {
    Event event;
    event.kind = kind;
    event.position = at;
    frame({event});
  }
  void press(glm::dvec2 at) {
    mouse(Event::Kind::mouse_move, at);
    mouse(Event::Kind::mouse_down, at);
  }
  void release(glm::dvec2 at) { mouse(Event::Kind::mouse_up, at); }
  void click(const std::string& widget) {
    press(middle(widget));
    release(middle(widget));
    for (int i = 0; i < 3; ++i) frame({});
  }
  glm::dvec2 middle(const std::string& widget) const {
    const glm::vec4 r = app_.widget(widget);
    return {r.x + r.z / 2, r.y + r.w / 2};
  }

 private:
  using Clock = std::chrono::steady_clock;
  std::unique_ptr<GraphicsContext> context_;
  App app_;
  Clock::time_point last_ = Clock::now();
};

// Moves the pressed mouse to and fro for so long, and counts; it stays pressed.
struct Counts {
  double seconds = 0, processor_seconds = 0;
  int frames = 0, results = 0;

  void print(const char* what) const {
    std::printf("%-38s %7.1f frames/s %8.1f ms of processor time each", what, frames / seconds,
                1000 * processor_seconds / frames);
    if (results > 0) std::printf(" %7.1f results/s", results / seconds);
    std::printf("\n");
    std::fflush(stdout);
  }
};

Counts move_mouse(Bench& bench, glm::dvec2 from, double reach, double seconds) {
  bench.press(from);
  Counts counts;
  const Evaluation* seen = bench.app().session().results.evaluation();
  std::uint64_t request = seen ? seen->request : 0;
  const auto start = std::chrono::steady_clock::now();
  const std::clock_t started = std::clock();
  while (counts.seconds < seconds) {
    const int turn = counts.frames % 80;
    const double along = (turn < 40 ? turn : 80 - turn) / 40.0;
    bench.mouse(Event::Kind::mouse_move, from + glm::dvec2(along * reach, along * reach * 0.1));
    ++counts.frames;
    const Evaluation* now = bench.app().session().results.evaluation();
    if (now && now->request != request) {
      request = now->request;
      ++counts.results;
    }
    const std::chrono::duration<double> passed = std::chrono::steady_clock::now() - start;
    counts.seconds = passed.count();
  }
  counts.processor_seconds = static_cast<double>(std::clock() - started) / CLOCKS_PER_SEC;
  return counts;
}

// How long it takes, once the mouse is let go, until the picture is there with all its care.
void tell_rest(Bench& bench, glm::dvec2 at) {
  const auto start = std::chrono::steady_clock::now();
  const std::clock_t started = std::clock();
  bench.release(at);
  while (bench.app().needs_frame()) bench.frame({});
  const std::chrono::duration<double> passed = std::chrono::steady_clock::now() - start;
  std::printf("%-38s %7.2f s          %8.1f ms of processor time\n",
              "  at rest, in full quality after", passed.count(),
              1000.0 * static_cast<double>(std::clock() - started) / CLOCKS_PER_SEC);
}

void orbit(int width, int height, double seconds, bool combined, const char* what) {
  const BenchScene scene = bench_scene(combined);
  Bench bench(width, height, scene.scene);
  if (combined) bench.click("tree:" + std::to_string(scene.result));
  const glm::vec4 picture = bench.app().widget("picture");
  const Camera before = bench.app().camera();
  const glm::dvec2 beside(picture.x + picture.z - 130, picture.y + picture.w / 2);
  const Counts counts = move_mouse(bench, beside, 100, seconds);
  if (counts.frames > 20 && bench.app().camera().azimuth == before.azimuth)
    throw std::runtime_error("nothing turned");
  counts.print(what);
  tell_rest(bench, beside);
}

void drag(int width, int height, double seconds) {
  const BenchScene scene = bench_scene(true);
  Bench bench(width, height, scene.scene);
  bench.click("tree:" + std::to_string(scene.b));
  const Counts counts = move_mouse(bench, bench.middle("handle.x"), 40, seconds);
  bench.release(bench.middle("handle.x"));
  if (counts.results == 0) throw std::runtime_error("the drag gave no results");
  counts.print("dragging B in A \\ B by a handle");
}

}  // namespace

int main(int argc, char** argv) {
  const double seconds = argc > 1 ? std::atof(argv[1]) : 5;
  const std::string only = argc > 3 ? argv[3] : "";
  int width = 1280, height = 800;
  if (argc > 4 || seconds <= 0 ||
      (argc > 2 && std::sscanf(argv[2], "%dx%d", &width, &height) != 2)) {
    std::fputs("usage: viewer_bench [SECONDS] [WIDTHxHEIGHT] [turn | turn-result | drag]\n",
               stderr);
    return 2;
  }
  try {
    if (only.empty() || only == "turn")
      orbit(width, height, seconds, false, "turning 100,000 triangles");
    if (only.empty() || only == "turn-result")
      orbit(width, height, seconds, true, "turning A \\ B and both operands");
    if (only.empty() || only == "drag") drag(width, height, seconds);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "viewer_bench: %s\n", error.what());
    return 1;
  }
}
