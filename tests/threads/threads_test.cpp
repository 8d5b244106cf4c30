// What may run side by side does: operations on shared solids from many threads, and what solids
// make when it is first asked for. Run under ThreadSanitizer, this shows where they race; without
// it, that nothing hangs and that all threads get the same.
#include <gtest/gtest.h>
#include <tbb/global_control.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <barrier>
#include <thread>
#include <vector>

#include "sectile/sectile.h"
#include "threads/workers.h"

namespace sectile {
namespace {

constexpr int thread_count = 4;

Solid fine_sphere() {
  return sphere(1, 40, 20);
}

Solid moved_by(const Solid& solid, double x, double y, double z) {
  return transformed(solid, Transform::translation({x, y, z}));
}

// All threads start together.
template <class Work>
void in_threads(const Work& work) {
  std::barrier start(thread_count);
  std::vector<std::thread> threads;
  for (int t = 0; t < thread_count; ++t)
    threads.emplace_back([&, t] {
      start.arrive_and_wait();
      work(t);
    });
  for (std::thread& thread : threads) thread.join();
}

TEST(Threads, OneBooleanOverManyThreads) {
  const Solid a = fine_sphere(), b = moved_by(a, 0.3, 0.2, 0.1);
  Solid one, many;
  tbb::task_arena(1).execute([&] { one = boolean(a, b, Operation::unite); });
  tbb::task_arena(8).execute([&] { many = boolean(a, b, Operation::unite); });
  EXPECT_EQ(one.to_mesh().positions, many.to_mesh().positions);
  EXPECT_EQ(one.to_mesh().indices, many.to_mesh().indices);
}

// So many contacts that each phase is divided.
TEST(Threads, NearlyEqualSolidsOverManyThreads) {
  const Solid a = sphere(1, 80, 40),
              b = transformed(a, Transform::rotation_degrees({1, 2, 3}, 0.06));
  for (const Operation operation : {Operation::unite, Operation::subtract}) {
    Solid one, many;
    tbb::task_arena(1).execute([&] { one = boolean(a, b, operation); });
    tbb::task_arena(8).execute([&] { many = boolean(a, b, operation); });
    EXPECT_EQ(one.to_mesh().positions, many.to_mesh().positions);
    EXPECT_EQ(one.to_mesh().indices, many.to_mesh().indices);
  }
}

TEST(Threads, OneImportOverManyThreads) {
  const PolygonMesh mesh = fine_sphere().to_mesh();
  tbb::task_arena(8).execute(
      [&] { EXPECT_EQ(Solid::from_mesh(mesh).to_mesh().indices.size(), mesh.indices.size()); });
}

// In doubles only what was cut has moved, in floats everything.
TEST(Threads, OneExportOverManyThreads) {
  const Solid a = sphere(1, 80, 40), b = moved_by(a, 0.3, 0.2, 0.1);
  const Solid both = boolean(a, b, Operation::unite);
  for (const auto numbers : {Rounding::Numbers::doubles, Rounding::Numbers::floats}) {
    Rounding rounding;
    rounding.numbers = numbers;
    RoundedMesh one, many;
    tbb::task_arena(1).execute([&] { one = rounded_mesh(both, rounding); });
    tbb::task_arena(8).execute([&] { many = rounded_mesh(both, rounding); });
    EXPECT_EQ(one.mesh.positions, many.mesh.positions);
    EXPECT_EQ(one.mesh.indices, many.mesh.indices);
    EXPECT_EQ(one.report.moved, many.report.moved);
  }
}

// Its blocks are triangles until a thread asks for more.
TEST(Threads, OneFreshImportAndItsImage) {
  const PolygonMesh mesh = sphere(1, 80, 40).to_mesh();
  const Solid tool = moved_by(sphere(0.3, 12, 8), 1, 0, 0);
  const double wanted = boolean(Solid::from_mesh(mesh), tool, Operation::subtract).volume();
  for (int i = 0; i < rounds; ++i) {
    const Solid ball = Solid::from_mesh(mesh), image = moved_by(ball, 2, 0, 0);
    in_threads([&](int t) {
      const Solid cut = t % 2 == 0 ? boolean(ball, tool, Operation::subtract)
                                   : boolean(image, moved_by(tool, 2, 0, 0), Operation::subtract);
      EXPECT_NEAR(cut.volume(), wanted, 1e-12);
    });
  }
}

TEST(Threads, ProgressOfAnImportRises) {
  const tbb::global_control more(tbb::global_control::max_allowed_parallelism, 8);
  const PolygonMesh mesh = sphere(1, 80, 40).to_mesh();
  ImportOptions options;
  for (int i = 0; i < rounds; ++i) {
    double last = 0;
    options.progress = [&](double done) {
      EXPECT_GE(done, last);
      last = done;
    };
    tbb::task_arena(8).execute([&] { Solid::from_mesh(mesh, options); });
    EXPECT_EQ(last, 1);
  }
}

// Whoever comes first makes the tool's trees and its complement; the others wait, or take tasks of
// the loop meanwhile, which ask for the same.
TEST(Threads, AFreshToolWithinAParallelLoop) {
  SECTILE_NEEDS_WORKERS;
  for (const Operation operation : {Operation::subtract, Operation::unite}) {
    const Solid tool = moved_by(fine_sphere(), 0.1, 0.1, 0.1);
    std::vector<Solid> results(16);
    tbb::task_arena(8).execute([&] {
      tbb::parallel_for(std::size_t(0), results.size(), [&](std::size_t i) {
        const double x = 0.1 * static_cast<double>(i);
        results[i] = boolean(block({x, 0, 0}, {x + 2, 2, 2}), tool, operation);
      });
    });
    for (std::size_t i = 0; i < results.size(); ++i) {
      const double x = 0.1 * static_cast<double>(i);
      EXPECT_EQ(results[i].volume(),
                boolean(block({x, 0, 0}, {x + 2, 2, 2}), tool, operation).volume());
    }
  }
}

TEST(Threads, AFreshToolFromManyThreads) {
  const Solid tool = moved_by(fine_sphere(), 0.1, 0.1, 0.1), body = block({0, 0, 0}, {2, 2, 2});
  std::vector<Solid> results(thread_count);
  in_threads([&](int t) {
    results[static_cast<std::size_t>(t)] =
        boolean(body, tool, t % 2 == 0 ? Operation::subtract : Operation::intersect);
  });
  EXPECT_EQ(results[0].volume(), results[2].volume());
  EXPECT_EQ(results[1].volume(), results[3].volume());
}

// A result's blocks are shared with the operands; the whole is made when it is asked for.
TEST(Threads, QueriesOfOneFreshResult) {
  const Solid a = fine_sphere();
  const Solid result =
      moved_by(boolean(a, moved_by(a, 0.3, 0.2, 0.1), Operation::subtract), 1, 2, 3);
  std::vector<double> volumes(thread_count);
  std::vector<std::size_t> triangles(thread_count);
  in_threads([&](int t) {
    const auto i = static_cast<std::size_t>(t);
    if (t % 2 == 0) {
      volumes[i] = result.volume();
      triangles[i] = result.to_mesh().face_sizes.size();
    } else {
      triangles[i] = result.to_mesh().face_sizes.size();
      volumes[i] = result.volume();
    }
    EXPECT_EQ(result.counts().shells, 1u);
    EXPECT_TRUE(validate(result).empty());
  });
  for (int t = 1; t < thread_count; ++t) {
    EXPECT_EQ(volumes[static_cast<std::size_t>(t)], volumes[0]);
    EXPECT_EQ(triangles[static_cast<std::size_t>(t)], triangles[0]);
  }
}

TEST(Threads, BooleansOfSolidsThatShareBlocks) {
  const Solid a = fine_sphere(),
              notched = boolean(a, block({0.5, -1, -1}, {2, 1, 1}), Operation::subtract);
  std::vector<Solid> results(thread_count);
  in_threads([&](int t) {
    const Solid tool = block({-2, -0.2, -0.2}, {2, 0.3, 0.1 + 0.1 * t});
    Solid mine = boolean(notched, tool, Operation::subtract);
    results[static_cast<std::size_t>(t)] = boolean(mine, a, Operation::intersect);
  });
  for (std::size_t t = 1; t < results.size(); ++t)
    EXPECT_LT(results[t].volume(), results[t - 1].volume());
}

TEST(Threads, MovesOfMovedSolids) {
  const Solid original = sphere(1, 12, 6);
  const Transform turn = Transform::rotation_degrees({1, 2, 3}, 17);
  std::vector<Solid> moved(thread_count);
  in_threads([&](int t) {
    Solid& mine = moved[static_cast<std::size_t>(t)];
    mine = transformed(transformed(original, turn), turn);
    mine = boolean(mine, original, Operation::intersect);
  });
  for (const Solid& solid : moved) EXPECT_EQ(solid.volume(), moved[0].volume());
}

}  // namespace
}  // namespace sectile
