// Dragging B (1,000 triangles) through the side of A (100,000 triangles): what one result costs,
// from the changed scene to the surfaces to draw, and what its parts cost.
#include <benchmark/benchmark.h>

#include "ball.h"
#include "evaluation/evaluator.h"
#include "evaluation/scene_computation.h"
#include "picture/surface_mesh.h"

namespace {

using namespace sectile;
using namespace sectile::viewer;
using bench::ball;

struct Drag {
  Scene scene;
  NodeId dragged = 0;
  int step = 0;

  explicit Drag(Operation operation) {
    const NodeId a = scene.add(ball("A", 320, 157, 2));  // 99,840 triangles
    dragged = scene.add(ball("B", 32, 17, 0.6));         // 1,024
    scene.combine({a, dragged}, operation);
  }
  void move() {
    scene.edit(dragged).placement.position = {1.7 + 0.0013 * (step % 200), 0.0031 * (step % 70),
                                              0.1};
    ++step;
  }
};

void whole_result(benchmark::State& state) {
  Drag drag(static_cast<Operation>(state.range(0)));
  SceneComputation computation;
  drag.move();
  computation.run(drag.scene, nullptr, {});
  for (auto _ : state) {
    drag.move();
    benchmark::DoNotOptimize(computation.run(drag.scene, nullptr, {}));
  }
}

void operation_alone(benchmark::State& state) {
  Drag drag(static_cast<Operation>(state.range(0)));
  const Evaluation made = evaluate(drag.scene);
  const Solid a = made.nodes.begin()->second.solid, b = made.find(drag.dragged)->solid;
  for (auto _ : state) {
    state.PauseTiming();
    drag.move();
    const Solid moved =
        transformed(b, Transform::translation(drag.scene.at(drag.dragged).placement.position));
    state.ResumeTiming();
    benchmark::DoNotOptimize(boolean(a, moved, static_cast<Operation>(state.range(0))));
  }
}

void surface_of_result(benchmark::State& state) {
  Drag drag(Operation::unite);
  drag.move();
  const Evaluation made = evaluate(drag.scene);
  const Solid solid = made.find(drag.scene.roots().front())->solid;
  for (auto _ : state) benchmark::DoNotOptimize(surface_mesh(solid));
}

void mesh_of_result(benchmark::State& state) {
  Drag drag(Operation::unite);
  drag.move();
  const Evaluation made = evaluate(drag.scene);
  const Solid solid = made.find(drag.scene.roots().front())->solid;
  for (auto _ : state) benchmark::DoNotOptimize(solid.to_mesh());
}

BENCHMARK(whole_result)->Arg(0)->Arg(1)->Arg(2)->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK(operation_alone)->Arg(0)->Arg(2)->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK(surface_of_result)->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK(mesh_of_result)->Unit(benchmark::kMillisecond)->UseRealTime();

}  // namespace

BENCHMARK_MAIN();
