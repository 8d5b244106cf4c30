// Writes results of Booleans of randomly placed meshes: rounding_pairs COUNT SEED FILE...
#include <cstdio>
#include <iostream>

#include "real/written_pairs.h"

int main(int argc, char** argv) {
  if (argc < 4) {
    std::cerr << "rounding_pairs COUNT SEED FILE...\n";
    return 2;
  }
  sectile::test::WrittenPairs pairs(static_cast<unsigned>(std::stoul(argv[2])));
  for (int i = 3; i < argc; ++i) pairs.add(argv[i]);
  pairs.run(std::stoi(argv[1]));
  std::cout << pairs.summary() << "\n";
  return pairs.illegal() + pairs.other_shape() + pairs.refused() > 0;
}
