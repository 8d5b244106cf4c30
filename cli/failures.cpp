#include "failures.h"

#include <iostream>
#include <new>

#include "interrupt.h"
#include "json.h"
#include "problem.h"
#include "sectile/rounding.h"

namespace sectile::cli {
namespace {

class Failures {
 public:
  Failures(const std::string& command, const Options& options)
      : command_(command), options_(options) {}

  ExitCode tell(ExitCode code, const char* kind, const char* message,
                const Json& more = Json::object()) const {
    std::cerr << "sectile: " << message << '\n';
    if (options_.json) {
      Json json{{"command", command_},
                {"exit_code", static_cast<int>(code)},
                {"error", {{"kind", kind}, {"message", message}}}};
      json["error"].update(more);
      std::cout << json.dump(-1, ' ', false, Json::error_handler_t::replace) << '\n';
    }
    return code;
  }

  ExitCode tell(const IllegalInput& error) const {
    Json more{{"file", error.file()}, {"problems", Json::array()}};
    for (const Problem& problem : error.problems()) more["problems"].push_back(to_json(problem));
    return tell(ExitCode::not_legal, "not_legal", error.what(), more);
  }

 private:
  const std::string& command_;
  const Options& options_;
};

}  // namespace

ExitCode run_and_tell(const std::string& command, const std::function<ExitCode()>& run,
                      const Options& options) {
  const Failures failures(command, options);
  const Interrupt interrupt;
  try {
    return run();
  } catch (const IllegalInput& error) {
    return failures.tell(error);
  } catch (const UsageError& error) {
    return failures.tell(ExitCode::wrong_usage, "wrong_usage", error.what());
  } catch (const RoundingFailed& error) {
    const Vec3& at = error.where();
    return failures.tell(ExitCode::file_failure, "rounding", error.what(),
                         {{"where", {at.x, at.y, at.z}}});
  } catch (const FileError& error) {
    return failures.tell(ExitCode::file_failure, "file", error.what());
  } catch (const Cancelled&) {
    std::cerr << "sectile: interrupted; nothing was written\n";
    end_by_signal();
  } catch (const std::bad_alloc&) {
    return failures.tell(ExitCode::internal_failure, "out_of_memory", "out of memory");
  } catch (const std::exception& error) {
    return failures.tell(ExitCode::internal_failure, "internal", error.what());
  }
}

}  // namespace sectile::cli
