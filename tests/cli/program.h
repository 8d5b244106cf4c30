// Drives the real program in a folder of its own.
#pragma once

#include <gtest/gtest.h>

#include <filesystem>
#include <functional>
#include <set>
#include <string>
#include <vector>

namespace sectile::test {

/// How a run of the program ended.
struct Ended {
  int code = -1;   ///< or -1 if a signal ended it
  int signal = 0;  ///< or 0
  std::string out, err;
};

/// A folder that the test fills and in which the program runs; removed afterwards.
class ProgramTest : public ::testing::Test {
 protected:
  ProgramTest();
  ~ProgramTest() override;

  Ended run(const std::vector<std::string>& arguments, const std::string& input = "") const;
  /// The same; `meanwhile` gets the process's id as soon as it runs.
  Ended run(const std::vector<std::string>& arguments, const std::string& input,
            const std::function<void(int)>& meanwhile) const;
  /// Runs from now on get no more addresses than this.
  void limit_memory(std::size_t bytes) { most_memory_ = bytes; }

  void write(const std::string& name, const std::string& content) const;
  std::string read(const std::string& name) const;
  bool exists(const std::string& name) const;
  /// The names of all files in the folder.
  std::set<std::string> files() const;
  std::filesystem::path path(const std::string& name) const { return work_ / name; }

 private:
  std::filesystem::path folder_, work_;
  std::size_t most_memory_ = 0;  // 0: no limit
};

}  // namespace sectile::test
