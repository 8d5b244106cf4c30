// What the command line says.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "sectile/sectile.h"

namespace sectile::cli {

struct Options {
  std::vector<std::string> inputs, outputs;
  std::string format = "obj";  ///< of standard input and output
  std::string operation = "union";
  std::array<double, 4> plane{0, 0, 1, 0};
  bool json = false, quiet = false, validate = false;
  int threads = 0;
};

int run_boolean(const Options& options, Operation operation);
int run_split(const Options& options);
int run_check(const Options& options);
int run_info(const Options& options);
int run_convert(const Options& options);
int run_trace(const Options& options);

}  // namespace sectile::cli
