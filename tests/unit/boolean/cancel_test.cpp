// An operation that is cancelled stops within a phase, not only after it.
#include <gtest/gtest.h>

#include "sectile/sectile.h"

namespace sectile {
namespace {

struct Phases : Observer {
  void phase_done(Phase phase, const std::vector<TraceEvent>&) override { done.push_back(phase); }
  std::vector<Phase> done;
};

// The phases that report although the operation was cancelled as soon as it had come so far.
std::vector<Phase> phases_when_cancelled_at(double progress) {
  Phases phases;
  std::atomic<bool> cancel{false};
  BooleanOptions options;
  options.observer = &phases;
  options.cancel = &cancel;
  options.progress = [&](double done) { cancel = done >= progress; };
  const Solid a = sphere(1, 24, 12), b = block({0, 0, 0}, {2, 2, 2});
  EXPECT_THROW(boolean(a, b, Operation::unite, options), Cancelled);
  return phases.done;
}

TEST(Cancel, StopsWithinTheReduction) {
  EXPECT_TRUE(phases_when_cancelled_at(0.1).empty());
}

TEST(Cancel, StopsWithinTheNeighborhoods) {
  EXPECT_EQ(phases_when_cancelled_at(0.4), (std::vector<Phase>{Phase::reduction}));
}

TEST(Cancel, StopsWithinTheJoining) {
  const std::vector<Phase> phases = phases_when_cancelled_at(0.5);
  ASSERT_FALSE(phases.empty());
  EXPECT_EQ(phases.back(), Phase::null_edges);
}

// Everything that takes time ends soon after it was asked to: here, when it first tells how far it
// is.
template <class Options, class Work>
void expect_cancelled(Options options, const Work& work) {
  std::atomic<bool> cancel{false};
  double last = 0;
  bool ascends = true;
  const auto tell = [&](double done) {
    ascends = ascends && done >= last;
    last = done;
  };
  options.cancel = &cancel;
  options.progress = tell;
  EXPECT_NO_THROW(work(options));
  EXPECT_TRUE(ascends);
  EXPECT_GT(last, 0.5);
  options.progress = [&](double) { cancel = true; };
  EXPECT_THROW(work(options), Cancelled);
}

TEST(Cancel, StopsTheComparisonOfOperandsThatAreTheSame) {
  const Solid a = sphere(1, 24, 12), b = sphere(1, 24, 12);
  const std::atomic<bool> cancel{true};
  BooleanOptions options;
  EXPECT_NO_THROW(boolean(a, b, Operation::unite, options));
  options.cancel = &cancel;
  EXPECT_THROW(boolean(a, b, Operation::unite, options), Cancelled);
}

TEST(Cancel, StopsClassifications) {
  const Solid a = sphere(1, 24, 12), b = block({0, 0, 0}, {2, 2, 2});
  expect_cancelled(BooleanOptions{}, [&](const BooleanOptions& o) { classify(a, b, o); });
  expect_cancelled(BooleanOptions{},
                   [&](const BooleanOptions& o) { classify(a, b, Operation::subtract, o); });
}

TEST(Cancel, StopsSections) {
  const Solid a = sphere(1, 24, 12);
  expect_cancelled(BooleanOptions{}, [&](const BooleanOptions& o) {
    section(a, {1, 2, 3, 0.5}, o);
  });
}

TEST(Cancel, StopsValidation) {
  const Solid a = sphere(1, 24, 12);
  expect_cancelled(ValidationOptions{}, [&](const ValidationOptions& o) { validate(a, o); });
}

TEST(Cancel, StopsImports) {
  const PolygonMesh mesh = sphere(1, 24, 12).to_mesh();
  for (const bool trusted : {false, true}) {
    ImportOptions options;
    options.trusted = trusted;
    expect_cancelled(options, [&](const ImportOptions& o) { Solid::from_mesh(mesh, o); });
  }
}

// What is told of the progress rises, and ends at 1.
template <class Options, class Work>
void expect_progress_to_end(Options options, const Work& work) {
  double last = 0;
  options.progress = [&](double done) {
    EXPECT_GE(done, last);
    last = done;
  };
  work(options);
  EXPECT_EQ(last, 1);
}

TEST(Progress, OfASplitRisesWhileBothPartsAreMade) {
  const HalfSpace half_space{1, 0.3, 0.2, 0.1};
  expect_progress_to_end(BooleanOptions{}, [&](const BooleanOptions& options) {
    split(block({-1, -1, -1}, {1, 1, 1}), half_space, options);
  });
}

TEST(Progress, EndsAtOneWhereNothingIsLeftToDo) {
  const Solid none, a = block({0, 0, 0}, {1, 1, 1}), far = block({5, 5, 5}, {6, 6, 6});
  for (const Operation operation : {Operation::unite, Operation::intersect, Operation::subtract})
    for (const auto& pair : {std::pair(none, a), std::pair(a, none), std::pair(a, a)})
      expect_progress_to_end(BooleanOptions{}, [&](const BooleanOptions& options) {
        boolean(pair.first, pair.second, operation, options);
      });
  expect_progress_to_end(BooleanOptions{},
                         [&](const BooleanOptions& options) { split(none, {}, options); });
  const Solid solids[] = {a, none}, others[] = {far};
  expect_progress_to_end(ArrangementOptions{}, [&](const ArrangementOptions& options) {
    unite(std::span(&none, 1), options);
  });
  expect_progress_to_end(ArrangementOptions{},
                         [&](const ArrangementOptions& options) { intersect(solids, options); });
  for (const Solid& from : {none, a})
    expect_progress_to_end(ArrangementOptions{}, [&](const ArrangementOptions& options) {
      EXPECT_EQ(subtract(from, others, options), from);
    });
  expect_progress_to_end(ValidationOptions{},
                         [&](const ValidationOptions& options) { validate(none, options); });
  expect_progress_to_end(Rounding{}, [&](const Rounding& options) { rounded_mesh(none, options); });
  expect_progress_to_end(RepairOptions{}, [&](const RepairOptions& options) {
    repair(PolygonMesh{{{0, 0, 0}, {1, 0, 0}, {2, 0, 0}}, {3}, {0, 1, 2}}, options);
  });
}

}  // namespace
}  // namespace sectile
