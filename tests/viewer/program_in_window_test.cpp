// The program itself in a window, with a real mouse and real keys. What it does is read from the
// scene that it saves; where its handles are is told by a modeller of the same size in memory that
// is given the same input. To be run under a display.
#include <gtest/gtest.h>
#include <unistd.h>

#include <cmath>
#include <thread>

#include "app/samples_menu.h"
#include "scene/recovery.h"
#include "scene/scene_file.h"
#include "viewer/app_driver.h"
#include "viewer/real_window.h"

namespace sectile::viewer {
namespace {

namespace fs = std::filesystem;

constexpr int width = 1000, height = 700;

class ProgramInWindow : public testing::Test {
 protected:
  void SetUp() override {
    folder_ = fs::path(testing::TempDir()) / ("sectile_program_" + std::to_string(getpid()));
    fs::create_directories(folder_);
    file_ = folder_ / "two.sectile";
  }
  void TearDown() override { fs::remove_all(folder_); }

  /// The operands of a sample, without their operation.
  void write_operands(const std::string& sample) {
    Scene scene = sample_scene(sample);
    const NodeId operation = scene.roots().front();
    operands_ = scene.at(operation).children;
    for (const NodeId id : operands_) scene.move(id, 0);
    scene.remove(operation);
    write_scene(file_, {scene, {}});
  }

  bool open_window() {
    const std::string search = "xdotool search --onlyvisible --name 'Sectile$' 2>/dev/null";
    if (!wait_for([&] { return !(window_ = found_by(search)).empty(); })) return false;
    return wait_for([&] { return found_by("xdotool getwindowfocus") == window_; },
                    [&] { act("windowfocus " + window_); });
  }

  std::string place(glm::dvec2 p) const {
    return " mousemove --window " + window_ + " " + std::to_string(std::lround(p.x)) + " " +
           std::to_string(std::lround(p.y));
  }

  /// Ctrl+S, and what is in the file then: all that was done before is in it. Before the scene is
  /// read, Ctrl+S asks for a name: Esc closes that.
  Scene saved() {
    const auto before = fs::last_write_time(file_);
    EXPECT_TRUE(wait_for([&] { return fs::last_write_time(file_) != before; },
                         [] { act("key Escape key ctrl+s"); }))
        << "nothing was saved; the focus has " << found_by("xdotool getwindowfocus") << ", not "
        << window_;
    return read_scene(file_).scene;
  }

  fs::path folder_, file_;
  std::string window_;
  std::vector<NodeId> operands_;
};

/// Everything in view from the front, and nothing selected.
void look_from_the_front(AppDriver& twin) {
  twin.key(Key::escape);
  twin.key('1');
  twin.key(Key::home);
}

glm::dvec2 rounded(glm::dvec2 p) {
  return {std::round(p.x), std::round(p.y)};
}

/// A place where a click selects this solid and no other.
glm::dvec2 place_on(AppDriver& twin, NodeId solid) {
  const Bounds bounds = twin.session().bounds_of(solid);
  for (const double down : {0.5, 0.8, 0.2})
    for (const double along : {0.15, 0.85, 0.5, 0.3, 0.7}) {
      const glm::dvec3 part(along, 0.5, down);
      const glm::dvec2 p =
          rounded(twin.app().on_screen(bounds.low + part * (bounds.high - bounds.low)));
      twin.key(Key::escape);
      twin.click(p);
      if (twin.session().selected() == solid) return p;
    }
  throw std::runtime_error("The solid cannot be clicked.");
}

TEST_F(ProgramInWindow, ClicksDragsUnitesUndoesAndSaves) {
  write_operands("fig01");
  const Scene before = read_scene(file_).scene;
  AppDriver twin(width, height);
  twin.app().open(file_);
  twin.settle();
  look_from_the_front(twin);
  const NodeId solid = operands_[1];
  const glm::dvec2 clicked = place_on(twin, solid);
  const glm::dvec2 from = rounded(twin.middle("handle.x")), to = from + glm::dvec2(90, 0);
  twin.drag(from, to);
  const Vec3 wanted = twin.scene().at(solid).placement.position;
  ASSERT_NE(wanted, before.at(solid).placement.position);

  Program program(file_, folder_ / "data", width, height);
  ASSERT_TRUE(open_window());
  ASSERT_EQ(saved(), before);
  // Until the solids are computed a click meets nothing, and the drag turns the view.
  Scene moved;
  for (int attempt = 0; attempt < 20 && program.is_running(); ++attempt) {
    ASSERT_TRUE(act("key Escape key 1 key Home" + place(clicked) + " click 1"));
    ASSERT_TRUE(act(place(from).substr(1) + " mousedown 1" + place((from + to) * 0.5) + place(to) +
                    " mouseup 1"));
    moved = saved();
    if (moved != before) break;
  }
  EXPECT_EQ(moved.at(solid).placement.position, wanted);
  EXPECT_EQ(moved.at(operands_[0]), before.at(operands_[0]));

  ASSERT_TRUE(act("key ctrl+a key u"));
  const Scene united = saved();
  ASSERT_EQ(united.roots().size(), 1u);
  const Node& result = united.at(united.roots().front());
  ASSERT_TRUE(std::holds_alternative<BooleanNode>(result.what));
  EXPECT_EQ(std::get<BooleanNode>(result.what).operation, Operation::unite);
  EXPECT_EQ(result.children, operands_);
  const Evaluation evaluation = evaluate(united);
  EXPECT_EQ(evaluation.find(result.id)->error, "");
  EXPECT_GT(evaluation.find(result.id)->solid.volume(), 0);

  ASSERT_TRUE(act("key ctrl+z"));
  EXPECT_EQ(saved(), moved);
  ASSERT_TRUE(act("key ctrl+z"));
  EXPECT_EQ(saved(), before);
  // Nothing is unsaved: it ends without a question.
  EXPECT_TRUE(wait_for([&] { return !program.is_running(); }, [] { act("key ctrl+q"); }));
  EXPECT_EQ(program.exit_code(), 0);
}

TEST_F(ProgramInWindow, MovesByKeysAndTypedNumbersCopiesAndPastes) {
  write_operands("fig01");
  const Scene before = read_scene(file_).scene;
  AppDriver twin(width, height);
  twin.app().open(file_);
  twin.settle();
  look_from_the_front(twin);
  const NodeId solid = operands_[1];
  const glm::dvec2 clicked = place_on(twin, solid);

  Program program(file_, folder_ / "data", width, height);
  ASSERT_TRUE(open_window());
  ASSERT_EQ(saved(), before);
  // Until the solids are computed a click meets nothing, and the keys do nothing.
  Scene moved;
  for (int attempt = 0; attempt < 20 && program.is_running(); ++attempt) {
    ASSERT_TRUE(act("key Escape key Escape key 1 key Home" + place(clicked) + " click 1"));
    ASSERT_TRUE(act("key g key x key 2 key period key 5"));
    ASSERT_TRUE(act(place(clicked + glm::dvec2(40, 30)).substr(1) + " key Return"));
    moved = saved();
    if (moved != before) break;
  }
  Vec3 wanted = before.at(solid).placement.position;
  wanted.x += 2.5;
  EXPECT_EQ(moved.at(solid).placement.position, wanted) << "the number counts, not the mouse";
  EXPECT_EQ(moved.at(operands_[0]), before.at(operands_[0]));

  // Saving let go of the selection.
  twin.app().open(file_);
  twin.settle();
  look_from_the_front(twin);
  const std::string select =
      "key Escape key Escape key 1 key Home" + place(place_on(twin, solid)) + " click 1";
  ASSERT_TRUE(act(select + " key ctrl+c key ctrl+v"));
  const Scene pasted = saved();
  ASSERT_EQ(pasted.size(), 3u);
  EXPECT_EQ(pasted.at(pasted.roots().back()).placement.position, wanted);
  // Given back by Esc: nothing changes.
  ASSERT_TRUE(act(select + " key g" + place(clicked + glm::dvec2(90, 0)) + " key Escape"));
  EXPECT_EQ(saved(), pasted);
  EXPECT_TRUE(wait_for([&] { return !program.is_running(); }, [] { act("key ctrl+q"); }));
}

TEST_F(ProgramInWindow, KilledItKeepsWhatWasDone) {
  write_operands("fig01");
  Program program(file_, folder_ / "data", width, height);
  ASSERT_TRUE(open_window());
  const Scene before = saved();
  ASSERT_TRUE(act("key ctrl+a key u"));
  // Two seconds are the promise, the rest is for the display.
  std::this_thread::sleep_for(std::chrono::seconds(4));
  program.kill_at_once();
  const std::vector<LostWork> lost = Recovery::find(folder_ / "data" / "sectile");
  ASSERT_EQ(lost.size(), 1u);
  EXPECT_EQ(lost.front().title, "two.sectile");
  const Scene back = Recovery::read(lost.front()).scene;
  ASSERT_EQ(back.roots().size(), 1u);
  EXPECT_EQ(back.at(back.roots().front()).children, operands_);
  EXPECT_EQ(read_scene(file_).scene, before) << "the file is not touched";
}

}  // namespace
}  // namespace sectile::viewer
