// Runs a loop on all cores and collects what it produces, in the order of the loop.
#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

#include "boolean/workspace.h"
#include "parallel/parallel.h"

namespace sectile {

/// Calls body(i, output) for i = 0 … count - 1; `output` is one Output for each block of the loop.
/// begin() is called before each block; what it throws ends the loop.
template <class Output, class Body, class Begin>
std::vector<Output> collect_blocks(std::size_t count, std::size_t block, const Body& body,
                                   const Begin& begin) {
  const std::size_t blocks = (count + block - 1) / block;
  std::vector<Output> outputs(blocks);
  const auto run = [&](std::size_t b) {
    begin();
    const std::size_t end = std::min(count, (b + 1) * block);
    for (std::size_t i = b * block; i < end; ++i) body(i, outputs[b]);
  };
  if (blocks <= 1) {
    if (blocks == 1) run(0);
  } else {
    parallel::loop(0, blocks, run);
  }
  return outputs;
}

template <class Output, class Body>
std::vector<Output> collect(std::size_t count, std::size_t block, const Body& body) {
  return collect_blocks<Output>(count, block, body, [] {});
}

/// The same; throws Cancelled within a block's time if that was asked for.
template <class Output, class Body>
std::vector<Output> collect(const Workspace& w, std::size_t count, std::size_t block,
                            const Body& body) {
  return collect_blocks<Output>(count, block, body, [&] { w.check_cancelled(); });
}

template <class T>
void append(std::vector<T>& to, const std::vector<T>& from) {
  to.insert(to.end(), from.begin(), from.end());
}

}  // namespace sectile
