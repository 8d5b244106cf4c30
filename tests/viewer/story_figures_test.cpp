// The figures' stories against what was found by hand: how many contacts, neighborhoods, null edges
// and cuts there are, which rules settle them, and where break points stop.
#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include "samples/samples.h"
#include "story/story.h"

namespace sectile::viewer {
namespace {

Story story_of(const std::string& name) {
  const samples::Sample sample = samples::get(name);
  return Story::tell(sample.a, sample.b, sample.operation.value());
}

std::size_t steps_in(const Story& story, Phase phase) {
  const auto [first, last] = story.range(phase);
  return last - first;
}

std::size_t steps_of_kind(const Story& story, const std::string& kind) {
  std::size_t count = 0;
  for (std::size_t i = 0; i < story.steps().size(); ++i) count += story.step(i).kind == kind;
  return count;
}

struct Expected {
  const char* sample;
  std::size_t contacts, vertex_face, vertex_vertex, null_edges, cuts;
};

// Every cut of A runs beside one of B, except where one of them loses or keeps both its sides; in
// these figures such segments are not cut at all. Each end of a loop of cuts is a null edge of A
// and one of B, and fig22 has two more of each in the vertex where four cuts meet.
constexpr Expected expected[] = {
    // Contacts: 6 vertices on vertices, 6 vertices on edges, 6 vertices in faces, 4 edges on edges,
    // 2 edges through faces. One loop of 12 cuts: down both ends of the notch, through the step.
    {"fig01", 24, 2, 30, 24, 24},
    {"fig11", 6, 6, 0, 12, 12},
    // The leg's outline in front is not cut: A keeps both sides, B loses both.
    {"fig12", 8, 3, 7, 12, 12},
    {"fig13", 3, 3, 0, 6, 6},
    {"fig18", 6, 2, 5, 8, 8},
    {"fig19a", 6, 3, 3, 12, 12},
    {"fig19b", 2, 0, 1, 0, 0},
    {"fig20a-identical", 8, 0, 11, 12, 12},
    {"fig20a-opposite", 6, 0, 7, 12, 12},
    {"fig20b", 6, 0, 8, 12, 12},
    {"fig20c", 8, 3, 6, 12, 12},
    {"fig20d", 4, 0, 4, 8, 8},
    {"fig20e", 8, 3, 6, 16, 16},
    {"fig21", 4, 2, 2, 8, 8},
    {"fig22", 5, 2, 4, 14, 12},
    {"fig23", 4, 4, 0, 8, 8},
    {"fig23-touching", 1, 0, 0, 0, 0},
};

TEST(StoryFigures, HaveTheStepsFoundByHand) {
  for (const Expected& e : expected) {
    SCOPED_TRACE(e.sample);
    const Story story = story_of(e.sample);
    EXPECT_EQ(steps_of_kind(story, "contact"), e.contacts);
    EXPECT_EQ(steps_in(story, Phase::vertex_face), e.vertex_face);
    EXPECT_EQ(steps_in(story, Phase::vertex_vertex), e.vertex_vertex);
    EXPECT_EQ(steps_in(story, Phase::null_edges), e.null_edges);
    EXPECT_EQ(steps_in(story, Phase::joining), e.cuts);
    EXPECT_EQ(steps_in(story, Phase::components), 4u);
    EXPECT_EQ(steps_in(story, Phase::cleanup), 1u);
  }
}

// Each segment of the loops is cut in both solids, and one wedge is glued along it.
TEST(StoryFigures, GlueOneWedgeForEachTwoCuts) {
  for (const Expected& e : expected) {
    SCOPED_TRACE(e.sample);
    const Story story = story_of(e.sample);
    EXPECT_EQ(steps_in(story, Phase::gluing), e.cuts / 2);
  }
}

// Words of the neighborhood of A's edge (in the middle of B's top, or on B's edge).
std::string words_around(const Story& story, char letter_of_b) {
  for (const Phase phase : {Phase::vertex_face, Phase::vertex_vertex})
    for (auto [i, last] = story.range(phase); i < last; ++i) {
      const Step step = story.step(i);
      const bool whole =
          step.places.size() == 2 && std::abs(step.places[1].y - step.places[0].y) == 4;
      if (whole && step.a[0] == 'e' && step.b[0] == letter_of_b &&
          (letter_of_b == 'e' || step.places[0].x == 4))
        return step.words;
    }
  return "";
}

TEST(StoryFigures, NameTheRowOfTableTwo) {
  for (int row = 1; row <= 9; ++row) {
    const Story story = story_of("table2-row" + std::to_string(row));
    const std::string words = words_around(story, 'f'), number = std::to_string(row);
    EXPECT_TRUE(words.find("Table II, row " + number) != std::string::npos ||
                words.find("(row " + number + " from the other end)") != std::string::npos)
        << row << ": " << words;
    const bool rule = row == 2 || row == 3 || row == 4 || row == 7;
    EXPECT_EQ(words.find("Table III") != std::string::npos, rule) << row << ": " << words;
  }
}

TEST(StoryFigures, NameTheTiesOfFigures19And20) {
  for (const std::string figure : {"19a", "19b", "20b", "20c", "20d", "20e"})
    EXPECT_NE(words_around(story_of("fig" + figure), 'e').find("Figure " + figure + ":"),
              std::string::npos)
        << figure;
  for (const std::string sample : {"fig20a-identical", "fig20a-opposite"})
    EXPECT_NE(words_around(story_of(sample), 'e').find("Figure 20a:"), std::string::npos);
}

TEST(StoryFigures, StopAtSpecialCases) {
  // Two bricks have none.
  const Story bricks = story_of("fig11");
  for (const StepRecord& step : bricks.steps()) EXPECT_FALSE(step.special);
  EXPECT_EQ(bricks.next_special(0, false), 0u);
  EXPECT_EQ(bricks.next_special(9, true), 9u);

  // The apex in the face is one among three contacts, and so are the two null edges there.
  const Story apex = story_of("fig13");
  std::vector<std::string> titles;
  for (std::size_t i = 0; i < apex.steps().size(); ++i)
    if (apex.steps()[i].special) titles.push_back(apex.step(i).title);
  ASSERT_EQ(titles.size(), 3u);
  EXPECT_EQ(titles[0], "face f4 of A under vertex v3 of B");
  EXPECT_TRUE(titles[1].starts_with("null edge") && titles[1].ends_with("of A")) << titles[1];
  EXPECT_TRUE(titles[2].starts_with("null edge") && titles[2].ends_with("of B")) << titles[2];
  const auto [first, last] = apex.range(Phase::null_edges);
  const std::size_t found = apex.next_special(first - 1, false);
  EXPECT_EQ(apex.step(found).title, titles[1]);
  EXPECT_EQ(apex.next_special(apex.next_special(found, false), true), found);
  EXPECT_EQ(apex.next_special(last, true), apex.next_special(found, false));
}

TEST(StoryFigures, StopAtBreakPoints) {
  const Story story = story_of("fig22");
  const std::size_t contact = story.next_of_kind(0, "vertex on vertex");
  const Step apex = contact == 0 ? story.step(0) : story.step(contact);
  EXPECT_TRUE(apex.title.starts_with("vertex ")) << apex.title;
  EXPECT_EQ(story.step(story.next_of_kind(0, "null edge")).kind, "null edge");
  EXPECT_EQ(story.next_of_kind(0, "null edge"), story.range(Phase::null_edges).first);
  EXPECT_EQ(story.next_of_kind(0, "cut"), story.range(Phase::joining).first);
  // In either order.
  const std::size_t crossing = story.next_of_kind(0, "edge on face");
  EXPECT_NE(crossing, 0u);
  EXPECT_EQ(crossing, story.next_of_kind(0, "face on edge"));
  // By entity: the vertex is met again where its neighborhood is split.
  const std::size_t split = story.next_of_kind(1, "A v3");
  EXPECT_EQ(story.steps()[split].phase, Phase::null_edges);
  EXPECT_EQ(story.next_of_kind(1, "v3"), split);
  EXPECT_EQ(story.next_of_kind(0, "v999"), 0u);
  EXPECT_EQ(story.next_of_kind(0, "no such kind"), 0u);
  const std::size_t pair = story.next_of_kind(0, "f4 on f2");
  EXPECT_EQ(story.step(pair).a, "f4");
  EXPECT_EQ(story.step(pair).b, "f2");
}

// A vertex in a face: its sphere has all of the face, divided in two, and the three sectors of the
// tetrahedron, of which two are divided.
TEST(StoryFigures, ShowTheSphereOfFigure13) {
  const Story story = story_of("fig13");
  const Step step = story.step(story.next_special(story.range(Phase::null_edges).first, false));
  std::size_t count[2] = {0, 0};
  for (const SpherePicture::Arc& arc : step.sphere.arcs) {
    ++count[arc.solid];
    EXPECT_TRUE(arc.cls == TraceClass::in || arc.cls == TraceClass::out) << arc.label;
    if (arc.solid == 0) {
      EXPECT_EQ(arc.label, "A f4");
    }
  }
  EXPECT_EQ(count[0], 2u);
  EXPECT_EQ(count[1], 5u);
  EXPECT_EQ(std::count_if(step.sphere.marks.begin(), step.sphere.marks.end(),
                          [](const auto& mark) { return mark.solid == -1 && mark.cut; }),
            2);
}

TEST(StoryFigures, PullThePartsApart) {
  const Story story = story_of("fig11");
  const auto [first, last] = story.range(Phase::components);
  StoryView view;
  EXPECT_EQ(story.picture(first, view).surfaces.size(), 4u);
  const double whole = story.picture(first, view).bounds().radius();
  view.exploded = 1;
  EXPECT_GT(story.picture(first, view).bounds().radius(), 1.5 * whole);
  for (std::size_t i = first; i < last; ++i) {
    const Picture picture = story.picture(i, view);
    EXPECT_EQ(std::count_if(picture.surfaces.begin(), picture.surfaces.end(),
                            [](const Surface& s) { return s.highlighted; }),
              1);
  }
  // Figure 12 has all eight parts; with ∪ those on the other boundary that face away go inside.
  const Story eight = story_of("fig12");
  view.eight_way = true;
  const Picture picture = eight.picture(eight.range(Phase::components).first, view);
  EXPECT_EQ(picture.surfaces.size(), 8u);
  EXPECT_EQ(std::count_if(picture.surfaces.begin(), picture.surfaces.end(),
                          [](const Surface& s) { return s.highlighted; }),
            2);
}

// The gluing brings the kept parts together; the last wedge closes the gap.
TEST(StoryFigures, MoveTheKeptPartsTogether) {
  const Story story = story_of("fig11");
  const auto [first, last] = story.range(Phase::gluing);
  const StoryView view;
  double before = 1e300;
  for (std::size_t i = first; i < last; ++i) {
    const Picture picture = story.picture(i, view);
    double apart = 0;
    for (const Surface& s : picture.surfaces)
      apart = std::max(apart, glm::length(s.model[3] - glm::dvec4(0, 0, 0, 1)));
    EXPECT_LT(apart, before);
    before = apart;
  }
  EXPECT_EQ(before, 0);
}

}  // namespace
}  // namespace sectile::viewer
