#include <unistd.h>

#include <chrono>
#include <csignal>
#include <iostream>
#include <nlohmann/json.hpp>
#include <sstream>

#include "exit_codes.h"
#include "inputs.h"
#include "summary.h"

namespace sectile::cli {
namespace {

std::atomic<bool> interrupted{false};

void interrupt(int) {
  interrupted = true;
}

// Shows progress on a terminal once the work has taken over a second.
class Progress {
 public:
  explicit Progress(const Options& options)
      : shown_(!options.quiet && isatty(STDERR_FILENO)), start_(std::chrono::steady_clock::now()) {}
  ~Progress() {
    if (printed_) std::cerr << "\r\x1b[K" << std::flush;
  }
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  void operator()(double done) {
    const std::chrono::duration<double> passed = std::chrono::steady_clock::now() - start_;
    if (!shown_ || passed.count() < 1) return;
    std::cerr << "\r" << static_cast<int>(100 * done) << " %" << std::flush;
    printed_ = true;
  }

 private:
  bool shown_, printed_ = false;
  std::chrono::steady_clock::time_point start_;
};

BooleanOptions boolean_options(const Options& options, Progress& progress) {
  std::signal(SIGINT, interrupt);
  BooleanOptions result;
  result.validate = options.validate;
  result.cancel = &interrupted;
  result.progress = [&progress](double done) { progress(done); };
  return result;
}

void tell(const Options& options, const std::string& name, const Summary& summary) {
  // Standard output may carry the result itself.
  bool taken = false;
  for (const std::string& output : options.outputs) taken = taken || output == "-";
  std::ostream& out = taken ? std::cerr : std::cout;
  if (options.json)
    out << in_json(name, summary);
  else if (!options.quiet)
    out << in_words(name, summary);
}

int save_and_tell(const Options& options, const std::vector<Solid>& solids) {
  std::vector<PolygonMesh> meshes;
  for (const Solid& solid : solids) meshes.push_back(solid.to_mesh());
  save_all(options, meshes);
  for (std::size_t i = 0; i < solids.size(); ++i)
    tell(options, options.outputs[i], summarize(solids[i], meshes[i]));
  return done;
}

}  // namespace

int run_boolean(const Options& options, Operation operation) {
  std::vector<Solid> operands;
  for (const std::string& name : options.inputs) operands.push_back(load_solid(options, name));
  Progress progress(options);
  const BooleanOptions how = boolean_options(options, progress);
  Solid result = operands[0];
  for (std::size_t i = 1; i < operands.size(); ++i)
    result = boolean(result, operands[i], operation, how);
  return save_and_tell(options, {result});
}

int run_split(const Options& options) {
  const Solid solid = load_solid(options, options.inputs[0]);
  Progress progress(options);
  const auto& [a, b, c, d] = options.plane;
  const auto [above, below] =
      split(solid, HalfSpace{a, b, c, d}, boolean_options(options, progress));
  return save_and_tell(options, {above, below});
}

int run_check(const Options& options) {
  const std::string& name = options.inputs[0];
  const Solid solid = load_solid(options, name);
  const std::vector<Violation> violations = validate(solid);
  if (options.json) {
    nlohmann::ordered_json json{{"name", name}, {"legal", violations.empty()}};
    for (const Violation& v : violations)
      json["violations"].push_back(
          {{"what", v.what}, {"where", {v.where.x, v.where.y, v.where.z}}});
    std::cout << json.dump() << '\n';
  }
  for (const Violation& v : violations)
    std::cerr << name << ": " << v.what << " near (" << v.where.x << ", " << v.where.y << ", "
              << v.where.z << ")\n";
  if (!violations.empty()) return not_a_solid;
  if (!options.json && !options.quiet)
    std::cout << name << ": legal\n" << in_words(name, summarize(solid, solid.to_mesh()));
  return done;
}

int run_info(const Options& options) {
  const std::string& name = options.inputs[0];
  const Solid solid = load_solid(options, name);
  const Summary summary = summarize(solid, solid.to_mesh());
  std::cout << (options.json ? in_json(name, summary) : in_words(name, summary));
  return done;
}

int run_convert(const Options& options) {
  const PolygonMesh mesh = load_mesh(options, options.inputs[0]);
  save_all(options, {mesh});
  if (!options.quiet && options.outputs[0] != "-")
    std::cout << options.outputs[0] << ": " << mesh.positions.size() << " vertices, "
              << mesh.face_sizes.size() << " faces\n";
  return done;
}

int run_trace(const Options& options) {
  const Solid a = load_solid(options, options.inputs[0]),
              b = load_solid(options, options.inputs[1]);
  const Operation operation = options.operation == "union"       ? Operation::unite
                              : options.operation == "intersect" ? Operation::intersect
                                                                 : Operation::subtract;
  std::ostringstream text;
  write_trace(text, a, b, operation);
  save_text(options.outputs[0], text.str());
  if (!options.quiet && options.outputs[0] != "-")
    std::cout << options.outputs[0] << ": trace of " << options.operation << '\n';
  return done;
}

}  // namespace sectile::cli
