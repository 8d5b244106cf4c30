// Where the time of Booleans goes.
#pragma once

#include <string>

namespace sectile::bench {

struct ProfileOptions {
  std::string name_part;    ///< only the cases whose name contains it
  std::string mesh_folder;  ///< also the pairs of real meshes there
  int repetitions = 3;      ///< the fastest counts; the first warms up search trees
  bool processor_time =
      false;  ///< instead of passed time: of all threads, other programs do not count
};

/// Prints a table: the milliseconds of each phase, summed over the operations of a case.
void print_profile(const ProfileOptions& options);

}  // namespace sectile::bench
