// Every sample at every phase, beside the pictures that were looked at and kept. New ones are
// accepted by cmake/accept_screenshots.sh.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <set>
#include <span>

#include "program/phase_picture.h"
#include "render/image_difference.h"
#include "render/renderer.h"
#include "samples/samples.h"
#include "viewer/reference_pictures.h"

namespace sectile::viewer {
namespace {

constexpr std::array all_phases = {Phase::reduction,  Phase::vertex_face, Phase::vertex_vertex,
                                   Phase::null_edges, Phase::joining,     Phase::components,
                                   Phase::gluing,     Phase::cleanup};
constexpr int width = 320, height = 240;

// Draws one picture after another in one context.
class Easel {
 public:
  Image draw(const Picture& picture) {
    renderer_.begin_frame();
    renderer_.draw(picture, {0, 0, width, height});
    return renderer_.read_frame();
  }

 private:
  std::unique_ptr<GraphicsContext> context_ = make_offscreen_context(width, height, 1);
  Renderer renderer_{*context_};
};

Story story_of(const std::string& sample) {
  return tell(sample_operands(sample));
}

// Parts are pulled apart, so that those inside are seen.
Picture picture_of(const Story& story, Phase phase) {
  StoryView view;
  view.exploded = phase == Phase::components ? 0.4 : 0;
  Picture picture = phase_picture(story, phase, last_step, view, double{width} / height);
  // Its fine lines would make most of the file; the pictures of the interface show it.
  picture.surroundings.show_grid = false;
  return picture;
}

std::string name_of_picture(const std::string& sample, Phase phase) {
  return sample + "-" + std::string(name_of(phase));
}

TEST(ReferencePictures, EverySampleAtEveryPhase) {
  Easel easel;
  for (const samples::Sample& sample : samples::all()) {
    const Story story = story_of(sample.name);
    for (const Phase phase : all_phases)
      EXPECT_EQ(difference_from_reference(name_of_picture(sample.name, phase),
                                          easel.draw(picture_of(story, phase))),
                "");
  }
}

TEST(ReferencePictures, NoneIsLeftOver) {
  std::set<std::string> known{"interface-empty", "interface-fig01", "interface-operands",
                              "interface-fig13-null_edges"};
  for (const samples::Sample& sample : samples::all())
    for (const Phase phase : all_phases) known.insert(name_of_picture(sample.name, phase));
  for (const std::string& name : reference_names())
    EXPECT_TRUE(known.contains(name)) << "no test makes " << name << ".png";
}

// What the comparison must notice, and what not.
class Comparison : public testing::Test {
 protected:
  Picture picture(const std::string& sample, Phase phase) const {
    return picture_of(story_of(sample), phase);
  }
  double difference(const Picture& a, const Picture& b) {
    return compare_locally(easel_.draw(a), easel_.draw(b)).worst;
  }
  Easel easel_;
};

// Without what is at these places in each list: marks and lines of A and of B may lie on each
// other.
template <class Lists>
void erase_all(Lists& lists, std::vector<glm::vec3> Lists::value_type::*places,
               std::span<const glm::vec3> what) {
  for (auto& list : lists) {
    std::vector<glm::vec3>& all = list.*places;
    for (auto found = all.begin();
         (found = std::search(found, all.end(), what.begin(), what.end())) != all.end();)
      found = all.erase(found, found + static_cast<std::ptrdiff_t>(what.size()));
  }
}

TEST_F(Comparison, NoticesAMissingMark) {
  for (const Phase phase : {Phase::reduction, Phase::null_edges, Phase::joining}) {
    const Picture whole = picture("fig13", phase);
    for (const Points& points : whole.points) {
      for (const glm::vec3& place : points.places) {
        Picture less = whole;
        erase_all(less.points, &Points::places, {&place, 1});
        EXPECT_GT(difference(whole, less), tolerated_difference)
            << name_of(phase) << ' ' << place.x << ' ' << place.y << ' ' << place.z;
      }
    }
  }
}

TEST_F(Comparison, NoticesAMissingLine) {
  const Picture whole = picture("fig11", Phase::joining);
  ASSERT_FALSE(whole.lines.empty());
  for (const Lines& lines : whole.lines) {
    for (std::size_t i = 0; i < lines.ends.size(); i += 2) {
      Picture less = whole;
      const glm::vec3 from = lines.ends[i], to = lines.ends[i + 1];
      erase_all(less.lines, &Lines::ends, std::array{from, to});
      erase_all(less.lines, &Lines::ends, std::array{to, from});
      EXPECT_GT(difference(whole, less), tolerated_difference) << "line " << i / 2;
    }
  }
}

TEST_F(Comparison, NoticesAPartInAnotherColour) {
  const Picture whole = picture("fig11", Phase::components);
  ASSERT_EQ(whole.surfaces.size(), 4u);
  for (std::size_t i = 0; i < whole.surfaces.size(); ++i) {
    Picture other = whole;
    other.surfaces[i].colour = whole.surfaces[(i + 1) % 4].colour;
    EXPECT_GT(difference(whole, other), tolerated_difference) << "part " << i;
    // A shade of the same colour, too.
    other.surfaces[i].colour = glm::mix(whole.surfaces[i].colour, Colour(1), 0.2f);
    EXPECT_GT(difference(whole, other), tolerated_difference) << "part " << i;
  }
}

// Another version of Mesa may decide otherwise which pixels belong to an edge.
TEST_F(Comparison, ToleratesEdgesAFractionOfAPixelAside) {
  for (const char* sample : {"fig01", "fig13", "fig22"}) {
    const Story story = story_of(sample);
    for (const Phase phase : all_phases) {
      const Picture here = picture_of(story, phase);
      Picture aside = here;
      aside.camera.pan({0.12, 0.1}, {width, height});
      EXPECT_LT(difference(here, aside), tolerated_difference) << sample << ' ' << name_of(phase);
    }
  }
}

}  // namespace
}  // namespace sectile::viewer
