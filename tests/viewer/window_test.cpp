// A real window with real mouse and keys; to be run under a display, see render.cmake.
#include <gtest/gtest.h>

#include <chrono>
#include <cstdlib>
#include <deque>
#include <thread>

#include "demo_pictures.h"
#include "events/background.h"
#include "render/image_difference.h"
#include "render/renderer.h"
#include "render/window.h"

namespace sectile::viewer {
namespace {

// The events of a window one after another, with patience.
class Events {
 public:
  explicit Events(Window& window) : window_(window) {}

  /// Skips events until one fits; after ten seconds without, that is a failure.
  template <typename Fits>
  Event next(const char* what, const Fits& fits) {
    const auto start = std::chrono::steady_clock::now();
    while (std::chrono::steady_clock::now() - start < std::chrono::seconds(10)) {
      while (!waiting_.empty()) {
        const Event event = waiting_.front();
        waiting_.pop_front();
        if (fits(event)) return event;
      }
      window_.wait(0.05);
      for (const Event& event : window_.take_input().events) waiting_.push_back(event);
    }
    ADD_FAILURE() << "never came: " << what;
    return {};
  }

  Event next(const char* what, Event::Kind kind) {
    return next(what, [&](const Event& event) { return event.kind == kind; });
  }

 private:
  Window& window_;
  std::deque<Event> waiting_;
};

void act(const std::string& what) {
  const std::string command = "xdotool " + what;
  ASSERT_EQ(std::system(command.c_str()), 0) << command;
}

TEST(Window, ShowsTheSameAsMemory) {
  const Picture picture = demo_pictures().front().picture;
  Window window("Sectile", 640, 480, 1);
  ASSERT_EQ(window.width(), 640);
  const auto memory = make_offscreen_context(640, 480);
  Renderer on_screen(window), off_screen(*memory);
  const auto draw = [&](Renderer& renderer) {
    renderer.begin_frame();
    renderer.draw(picture, {0, 0, 640, 480});
    return renderer.read_frame();
  };
  const Image shown = draw(on_screen);
  window.present();
  const Image kept = draw(off_screen);
  EXPECT_LT(compare_images(shown, kept).share, 0.001);
  EXPECT_EQ(draw(on_screen).rgba, shown.rgba);
}

TEST(Window, CollectsMouseAndKeys) {
  Window window("Sectile", 640, 480, 2);  // two pixels for each unit
  Events events(window);
  window.wait(0.2);
  act("search --sync --name Sectile mousemove --window %1 300 200");
  const glm::dvec2 place(150, 100);
  events.next("a move to the place", [&](const Event& event) {
    return event.kind == Event::Kind::mouse_move && event.position == place;
  });

  act("click 1");
  const Event pressed = events.next("a press", Event::Kind::mouse_down);
  EXPECT_EQ(pressed.button, MouseButton::left);
  EXPECT_EQ(pressed.position, place);
  EXPECT_EQ(events.next("a release", Event::Kind::mouse_up).button, MouseButton::left);
  act("click 3");
  EXPECT_EQ(events.next("a press", Event::Kind::mouse_down).button, MouseButton::right);
  act("click 4");
  EXPECT_EQ(events.next("a turn of the wheel", Event::Kind::scroll).scroll.y, 1);

  act("search --name Sectile windowfocus --sync");
  act("keydown shift key a keyup shift");
  const Event key = events.next("the key A", [](const Event& event) {
    return event.kind == Event::Kind::key_down && event.key == static_cast<Key>('A');
  });
  EXPECT_TRUE(key.shift);
  EXPECT_FALSE(key.control);
  EXPECT_EQ(events.next("a text", Event::Kind::text).text, "A");
  act("key F5");
  EXPECT_EQ(events.next("a key", Event::Kind::key_down).key, Key::f5);
}

TEST(Window, FinishedWorkEndsItsWait) {
  Window window("Sectile", 640, 480, 1);
  window.wait(0.2);
  window.take_input();
  Background<int, int> worker([](int n, WorkState&) {
    std::this_thread::sleep_for(std::chrono::milliseconds(300));
    return std::optional(n);
  });
  worker.request(1);
  // Other events may come of themselves, but hardly for a minute.
  const auto start = std::chrono::steady_clock::now();
  while (worker.is_working()) window.wait(60), window.take_input();
  EXPECT_LT(std::chrono::steady_clock::now() - start, std::chrono::seconds(30));
}

TEST(Window, OpensAgainAfterItWasClosed) {
  for (int i = 0; i < 2; ++i) {
    Window window("Sectile", 640, 400, 1);
    window.make_current();
    window.present();
  }
}

}  // namespace
}  // namespace sectile::viewer
