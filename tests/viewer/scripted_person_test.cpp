// A person who makes a part with the real program in a real window: every click, key and number
// goes to the window, and to a modeller of the same size in memory, which tells where things are
// and what is to come of it. To be run under a display. No number is computed in the head: fields
// take what it comes from ("40 - 2*5"), the rest is placed by faces and boxes.
#include <gtest/gtest.h>

#include <unistd.h>

#include <cmath>
#include <cstdlib>
#include <utility>

#include "render/gif.h"
#include "scene/scene_file.h"
#include "viewer/app_driver.h"
#include "viewer/real_window.h"

namespace sectile::viewer {
namespace {

namespace fs = std::filesystem;

constexpr int width = 1280, height = 800;

/// Does everything twice: in memory and, if there is one, in the window.
class Person {
 public:
  Person(AppDriver& twin, RealWindow* window) : twin_(twin), window_(window) {}

  AppDriver& twin() { return twin_; }
  const Session& session() const { return twin_.session(); }
  NodeId selected() const { return session().selected(); }

  void press(const std::string& widget, bool shift = false) { click(twin_.middle(widget), shift); }
  void menu(const std::string& name, const std::string& item) {
    unseen([&] { press(name); });
    press("menu:" + item);
  }
  void menu(const std::string& name, const std::string& submenu, const std::string& item) {
    unseen([&] { press(name); });
    press("submenu." + submenu);
    press("menu:" + item);
  }
  void click(glm::dvec2 at, bool shift = false) {
    const glm::dvec2 p(std::round(at.x), std::round(at.y));
    twin_.move(p);
    twin_.settle(2);
    twin_.click(p, shift);
    if (window_) window_->click(p, shift);
    film();
  }
  /// On a place of the world, which must be in view.
  void click_on(const glm::dvec3& place) { click(twin_.app().on_screen(place)); }
  void hover(glm::dvec2 at) {
    const glm::dvec2 p(std::round(at.x), std::round(at.y));
    twin_.move(p);
    twin_.settle(2);
    if (window_) window_->move(p);
  }
  void key(const std::string& name, Key key, bool control = false, bool shift = false) {
    twin_.key(key, control, shift);
    if (window_) window_->key((control ? "ctrl+" : "") + std::string(shift ? "shift+" : "") + name);
    film();
  }
  void letter(char c, bool control = false, bool shift = false) {
    key(std::string(1, static_cast<char>(std::tolower(c))), static_cast<Key>(c), control, shift);
  }
  void type(const std::string& text) {
    twin_.type(text);
    if (window_) window_->type(text);
  }
  void enter(const std::string& field, const std::string& text) {
    const glm::dvec2 at = twin_.middle(field);
    const glm::dvec2 p(std::round(at.x), std::round(at.y));
    twin_.double_click(p);
    if (window_) window_->double_click(p);
    type(text);
    key("Return", Key::enter);
  }
  void look(char from, bool other_side = false) {
    unseen([&] { letter(from, other_side); });
    key("Home", Key::home);
    if (window_) window_->rest();
  }

  /// Into a file of the twin's and one of the window's.
  void export_to(const fs::path& of_twin, const fs::path& of_window) {
    letter('E', true);
    press("browser.name");
    letter('A', true);
    twin_.type(of_twin.string());
    if (window_) window_->type(of_window.string());
    key("Return", Key::enter);
    twin_.settle(5);
  }

  /// Both have the same scene now; the window is asked by saving.
  bool agrees() { return !window_ || window_->has_scene(twin_.scene()); }

  /// What was made, from some sides.
  void show_around() {
    for (const double azimuth : {-1.9, -1.0}) {
      twin_.key(Key::home);
      Camera camera = twin_.app().camera();
      camera.azimuth = azimuth, camera.elevation = 0.6;
      twin_.app().set_camera(camera);
      twin_.settle();
      film();
    }
  }
  /// Not in the film.
  template <class Do>
  void unseen(const Do& act) {
    const bool filmed = std::exchange(films, false);
    act();
    films = filmed;
  }
  const std::vector<Image>& frames() const { return frames_; }
  bool films = false;

 private:
  void film() {
    if (films) frames_.push_back(twin_.app().screenshot());
  }
  AppDriver& twin_;
  RealWindow* window_;
  std::vector<Image> frames_;
};

/// The part, step by step. After each both modellers must agree.
class Part {
 public:
  explicit Part(Person& person) : p_(person) {}

  void make() {
    step("plate", [&] { plate(); });
    step("drill", [&] { drill(); });
    step("holes", [&] { holes(); });
    step("boss", [&] { boss(); });
    step("rib", [&] { rib(); });
    step("chamfer", [&] { chamfer(); });
    step("mirror", [&] { mirror(); });
    step("a hole moved", [&] { move_hole(); });
  }

 private:
  template <class Do>
  void step(const char* name, const Do& act) {
    if (testing::Test::HasFatalFailure()) return;
    SCOPED_TRACE(name);
    act();
    ASSERT_TRUE(p_.agrees()) << "the window made something else of: " << name;
  }

  NodeId add(const char* shape, std::initializer_list<std::pair<const char*, const char*>> fields) {
    p_.unseen([&] { p_.press("tool.add"); });
    p_.press(std::string("menu:add.") + shape);
    for (const auto& [field, text] : fields) p_.enter(std::string("properties.") + field, text);
    return p_.selected();
  }
  std::string row(NodeId id) const { return "tree:" + std::to_string(id); }
  /// The second one stays where it is, or comes first in a difference.
  void select(NodeId first, NodeId second) {
    p_.unseen([&] { p_.press(row(first)); });
    p_.press(row(second), true);
  }
  void align(NodeId moved, NodeId to, std::initializer_list<const char*> how) {
    select(moved, to);
    for (const char* which : how) p_.menu("menu.place", "Align", std::string("place.") + which);
  }

  void plate() {
    plate_ = add("block", {{"size.x", "40"}, {"size.y", "30"}, {"size.z", "5"}});
    p_.key("End", Key::end);
  }

  void drill() {
    const NodeId hole = add("cylinder", {{"radius", "4.5/2"}, {"height", "12"}});
    const NodeId sink =
        add("cone", {{"radius", "4.5/2"}, {"top_radius", "7/2"}, {"height", "(7 - 4.5)/2"}});
    align(sink, hole, {"middle_x", "middle_y"});
    align(hole, plate_, {"middle_z"});
    align(sink, plate_, {"top"});
    select(hole, sink);
    p_.letter('U');
    drill_ = p_.selected();
  }

  /// Five from each side of the plate.
  void holes() {
    p_.menu("menu.repeat", "repeat.linear");
    p_.enter("properties.count", "2");
    p_.enter("properties.step.x", "40 - 2*5");
    p_.menu("menu.repeat", "repeat.linear");
    p_.enter("properties.count", "2");
    p_.enter("properties.step.x", "0");
    p_.enter("properties.step.y", "30 - 2*5");
    const NodeId all = p_.selected();
    align(all, plate_, {"middle_x", "middle_y"});
    select(plate_, all);
    p_.letter('D');
    drilled_ = p_.selected();
  }

  /// Its underside is seen from below, the plate's top from above.
  void boss() {
    boss_ = add("cylinder", {{"radius", "6"}, {"height", "6"}});
    p_.menu("menu.place", "place.face_centred");
    put_on_top();
  }

  void put_on_top() {
    const Bounds moved = p_.session().bounds_of(p_.selected());
    p_.look('7', true);
    p_.click_on({moved.centre().x - 1, moved.centre().y, moved.low.z});
    p_.look('7');
    p_.click_on({-8, 8, 5});
    p_.key("Return", Key::enter);
  }

  void rib() {
    rib_ = add("wedge", {{"size.x", "40/2"}, {"size.y", "2"}, {"size.z", "6"}});
    p_.menu("menu.place", "place.face_on_face");
    put_on_top();
    align(rib_, drilled_, {"right", "middle_y"});
    p_.press(row(drilled_));
    p_.press(row(boss_), true);
    p_.press(row(rib_), true);
    p_.letter('U');
  }

  void chamfer() {
    p_.look('1');
    p_.letter('B', true);
    const glm::dvec2 edge = p_.twin().app().on_screen({-8, -15, 5});
    p_.click(edge + glm::dvec2(0, 2));
    p_.type("1");
    p_.key("Return", Key::enter);
  }

  void mirror() {
    p_.letter('M', true);
    p_.look('3', true);
    p_.click_on({-20, 4, 2.5});
    p_.look('1');
  }

  void move_hole() {
    p_.press(row(drill_));
    p_.hover(p_.twin().middle("picture"));
    p_.letter('G');
    p_.letter('X');
    p_.type("1");
    p_.key("Return", Key::enter);
    p_.key("Escape", Key::escape);
  }

  Person& p_;
  NodeId plate_ = 0, drill_ = 0, drilled_ = 0, boss_ = 0, rib_ = 0;
};

/// The volume by formulas. Round things have 32 sides.
double volume_by_hand() {
  const double k = 16 * std::sin(2 * M_PI / 32);
  const double hole =
      k * 2.25 * 2.25 * (5 - 1.25) + k * 1.25 / 3 * (2.25 * 2.25 + 2.25 * 3.5 + 3.5 * 3.5);
  const double boss = k * 36 * 6, chamfer = 0.5 * 40;
  // Where the rib is in the boss, whose sides beside the x axis lean by s.
  const double a = 2 * M_PI / 32, s = (1 - std::cos(a)) / std::sin(a);
  const double common = 2 * (36 - 3 * s - 0.15 * (36 - 6 * s + s * s / 3));
  const double rib = 0.5 * 20 * 6 * 2 - common;
  return 2 * (40 * 30 * 5 - chamfer - 4 * hole + boss + rib);
}

void check(const fs::path& file) {
  const PolygonMesh mesh = read_mesh(file);
  Bounds bounds;
  for (const Vec3& p : mesh.positions) bounds.add(glm::dvec3(p.x, p.y, p.z));
  EXPECT_EQ(bounds.low, glm::dvec3(-60, -15, 0));
  EXPECT_EQ(bounds.high, glm::dvec3(20, 15, 11));
  const Solid solid = Solid::from_mesh(mesh);
  EXPECT_NEAR(solid.volume(), volume_by_hand(), 1e-6 * volume_by_hand()) << "but for floats";
  EXPECT_EQ(solid.counts().shells, 1u);
  EXPECT_EQ(solid.counts().genus, 8) << "four holes, twice";
}

class ScriptedPerson : public testing::Test {
 protected:
  void SetUp() override {
    folder_ = fs::path(testing::TempDir()) / ("sectile_person_" + std::to_string(getpid()));
    fs::create_directories(folder_);
    write_scene(folder_ / "part.sectile", {Scene(), {}});
  }
  void TearDown() override { fs::remove_all(folder_); }
  fs::path folder_;
};

/// With SECTILE_FILM the window's pictures become an animated GIF of that name.
TEST_F(ScriptedPerson, MakesThePartInMemory) {
  const char* film = std::getenv("SECTILE_FILM");
  const AppOptions options = AppDriver::waiting();
  AppDriver twin(options, film ? 1000 : width, film ? 740 : height);
  Person person(twin, nullptr);
  // Lines that move all over the picture would fill the film.
  if (film) person.menu("menu.view", "view.grid");
  person.films = film != nullptr;
  Part(person).make();
  ASSERT_FALSE(HasFatalFailure());
  const Solid* made = twin.session().results.solid(twin.scene().roots().front());
  ASSERT_TRUE(made);
  EXPECT_NEAR(made->volume(), volume_by_hand(), 1e-12 * volume_by_hand());
  if (film) person.show_around();
  person.films = false;
  person.export_to(folder_ / "part.3mf", {});
  check(folder_ / "part.3mf");
  if (film) write_gif(film, person.frames(), 0.3);
}

TEST_F(ScriptedPerson, MakesThePartInARealWindow) {
  if (!std::getenv("DISPLAY")) GTEST_SKIP() << "there is no display";
  AppDriver twin(width, height);
  twin.app().open(folder_ / "part.sectile");
  twin.settle();
  RealWindow window(folder_ / "part.sectile", folder_ / "data", width, height);
  ASSERT_TRUE(window.open());
  Person person(twin, &window);
  ASSERT_TRUE(person.agrees());
  Part(person).make();
  ASSERT_FALSE(HasFatalFailure());
  const fs::path mine = folder_ / "twin.3mf", theirs = folder_ / "window.3mf";
  person.export_to(mine, theirs);
  ASSERT_TRUE(wait_for([&] { return fs::exists(theirs); }, {}, std::chrono::seconds(30)));
  check(theirs);
  const PolygonMesh a = read_mesh(mine), b = read_mesh(theirs);
  EXPECT_EQ(a.positions, b.positions);
  EXPECT_EQ(a.indices, b.indices);
}

}  // namespace
}  // namespace sectile::viewer
