// Whatever takes long ends soon after it was asked to, wherever in the work that is.
#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <ctime>
#include <functional>
#include <thread>

#include "sectile/sectile.h"

namespace sectile {
namespace {

// Of the whole program, in milliseconds: other programs do not count.
double processor_time() {
  timespec time;
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &time);
  return double(time.tv_sec) * 1e3 + double(time.tv_nsec) * 1e-6;
}

using Cancel = const std::atomic<bool>*;
using Tell = std::function<void(double)>;
using Work = std::function<void(Cancel, Tell)>;

// On two cores twice the time of one, and twice that on a machine that others keep busy.
constexpr double allowed = 200;

// Cancels after each tenth of the time, and when each tenth is told.
void expect_to_end_soon(const Work& work) {
  double last = 0;
  bool rises = true;
  const double start = processor_time();
  work(nullptr, [&](double done) {
    rises = rises && done >= last;
    last = done;
  });
  const double first = processor_time() - start;
  work(nullptr, {});  // what is done once, and busy neighbours, make the first one take longer
  const double whole = std::min(first, processor_time() - start - first);
  EXPECT_TRUE(rises);
  EXPECT_EQ(last, 1);
  int cancelled = 0;
  for (int tenth = 1; tenth < 10; ++tenth) {
    std::atomic<bool> cancel{false}, over{false};
    double asked = 0;
    const double begin = processor_time();
    std::thread other([&] {
      while (!over && processor_time() - begin < whole * tenth / 10)
        std::this_thread::sleep_for(std::chrono::microseconds(200));
      asked = processor_time();
      cancel = true;
    });
    double ended = 0;
    try {
      work(&cancel, {});
    } catch (const Cancelled&) {
      ended = processor_time();
    }
    over = true;
    other.join();
    if (ended == 0) continue;
    ++cancelled;
    EXPECT_LE(ended - asked, allowed) << "tenth " << tenth << " of " << whole << " ms";
  }
  EXPECT_GE(cancelled, 3) << "most of it cannot be cancelled";
  for (int tenth = 1; tenth < 10; ++tenth) {
    std::atomic<bool> cancel{false};
    bool finished = false;
    try {
      // When all is done there is nothing left to cancel.
      work(&cancel, [&](double done) { cancel = cancel || (done >= 0.1 * tenth && done < 1); });
      finished = true;
    } catch (const Cancelled&) {
    }
    EXPECT_NE(finished, cancel.load()) << "tenth " << tenth;
  }
}

PolygonMesh side_by_side(PolygonMesh a, const PolygonMesh& b) {
  const auto first = static_cast<std::uint32_t>(a.positions.size());
  a.positions.insert(a.positions.end(), b.positions.begin(), b.positions.end());
  a.face_sizes.insert(a.face_sizes.end(), b.face_sizes.begin(), b.face_sizes.end());
  for (const std::uint32_t i : b.indices) a.indices.push_back(first + i);
  return a;
}

struct TwoSpheres {
  Solid a, b;
  PolygonMesh mesh;
  explicit TwoSpheres(std::uint32_t rings = 80) : a(sphere(1, 2 * rings, rings)) {
    b = Solid::from_mesh(transformed(a, Transform::translation({0.7, 0.31, 0.13})).to_mesh());
    mesh = side_by_side(a.to_mesh(), b.to_mesh());
  }
};

TEST(CancelAtEachTenth, Import) {
  const PolygonMesh mesh = sphere(1, 240, 120).to_mesh();
  expect_to_end_soon([&](Cancel cancel, const Tell& tell) {
    ImportOptions options;
    options.cancel = cancel;
    options.progress = tell;
    Solid::from_mesh(mesh, options);
  });
}

TEST(CancelAtEachTenth, Repair) {
  const TwoSpheres spheres;
  expect_to_end_soon([&](Cancel cancel, const Tell& tell) {
    RepairOptions options;
    options.cancel = cancel;
    options.progress = tell;
    repair(spheres.mesh, options);
  });
}

TEST(CancelAtEachTenth, Arrangement) {
  const TwoSpheres spheres;
  const std::vector<Solid> both{spheres.a, spheres.b};
  expect_to_end_soon([&](Cancel cancel, const Tell& tell) {
    ArrangementOptions options;
    options.cancel = cancel;
    options.progress = tell;
    unite(both, options);
  });
  expect_to_end_soon([&](Cancel cancel, const Tell& tell) {
    ArrangementOptions options;
    options.cancel = cancel;
    options.progress = tell;
    cells(both, options);
  });
}

// Of a solid so large that it takes many times as long as the other thread sleeps.
TEST(CancelAtEachTenth, Export) {
  const TwoSpheres spheres(300);
  const Solid both = boolean(spheres.a, spheres.b, Operation::unite);
  expect_to_end_soon([&](Cancel cancel, const Tell& tell) {
    Rounding options;
    options.cancel = cancel;
    options.progress = tell;
    rounded_mesh(both, options);
  });
}

// Where much has to be mended, and corners go to a coarser grid.
TEST(CancelAtEachTenth, ExportOfSlivers) {
  const Solid ball = sphere(1, 24, 12);
  const Solid slivers =
      boolean(ball, transformed(ball, Transform::rotation_degrees({1, 0.3, 0.7}, 1e-7)),
              Operation::subtract);
  expect_to_end_soon([&](Cancel cancel, const Tell& tell) {
    Rounding options;
    options.numbers = Rounding::Numbers::floats;
    options.cancel = cancel;
    options.progress = tell;
    rounded_mesh(slivers, options);
  });
}

}  // namespace
}  // namespace sectile
