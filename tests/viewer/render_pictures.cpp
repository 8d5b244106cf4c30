// render_pictures FOLDER [WIDTH HEIGHT SCALE]: writes the demo pictures and says how long they
// take.
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <string>

#include "demo_pictures.h"
#include "render/renderer.h"

namespace {

using namespace sectile::viewer;

// Milliseconds for each frame of an orbit.
double orbit(Renderer& renderer, Picture picture, const Viewport& viewport, int frames) {
  const auto draw = [&] {
    picture.camera.orbit(0.03, 0);
    renderer.begin_frame();
    renderer.draw(picture, viewport);
    renderer.read_frame();
  };
  draw();
  const auto start = std::chrono::steady_clock::now();
  for (int i = 0; i < frames; ++i) draw();
  const std::chrono::duration<double, std::milli> time = std::chrono::steady_clock::now() - start;
  return time.count() / frames;
}

void draw_all(const std::string& folder, int width, int height, float scale) {
  const auto context = make_offscreen_context(width, height, scale);
  Renderer renderer(*context);
  const Viewport viewport{0, 0, width, height};
  for (DemoPicture& demo : demo_pictures()) {
    for (const Quality quality : {Quality::full, Quality::fast}) {
      const std::string name = demo.name + (quality == Quality::fast ? "-fast" : "");
      demo.picture.quality = quality;
      renderer.begin_frame();
      renderer.draw(demo.picture, viewport);
      write_png(folder + "/" + name + ".png", renderer.read_frame());
      std::printf("%-30s %6.1f ms\n", name.c_str(), orbit(renderer, demo.picture, viewport, 5));
    }
  }
  for (const bool translucent : {false, true}) {
    for (const Quality quality : {Quality::full, Quality::fast}) {
      const std::string name = std::string("dense") + (translucent ? "-translucent" : "") +
                               (quality == Quality::fast ? "-fast" : "");
      const Picture picture = dense_picture(100000, translucent, quality);
      renderer.begin_frame();
      renderer.draw(picture, viewport);
      write_png(folder + "/" + name + ".png", renderer.read_frame());
      std::printf("%-30s %6.1f ms, %zu triangles\n", name.c_str(),
                  orbit(renderer, picture, viewport, 8), picture.surfaces[0].mesh->faces.size());
    }
  }
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 2 && argc != 5) {
    std::fputs("usage: render_pictures FOLDER [WIDTH HEIGHT SCALE]\n", stderr);
    return 2;
  }
  try {
    const bool sized = argc == 5;
    draw_all(argv[1], sized ? std::atoi(argv[2]) : 1280, sized ? std::atoi(argv[3]) : 800,
             sized ? std::strtof(argv[4], nullptr) : 1);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 1;
  }
}
