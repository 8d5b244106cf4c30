// What the commands declare about their command lines. Only these functions, options.cpp and main
// see the parser, which takes long to compile.
#pragma once

#include <string>
#include <vector>

#include "sectile/boolean.h"

namespace CLI {
class App;
}

namespace sectile::cli {

CLI::App* add_command(CLI::App& program, const std::string& name, const std::string& description);

/// A name or value that must be given. `placeholder` stands for it in the help.
void add_text(CLI::App& command, const std::string& name, std::string& text,
              const std::string& help, const std::string& placeholder);

/// From `least` to `most` names that must be given; `most` may be `any_number`.
inline constexpr int any_number = -1;
void add_texts(CLI::App& command, const std::string& name, std::vector<std::string>& texts,
               int least, int most, const std::string& help, const std::string& placeholder);

void add_switch(CLI::App& command, const std::string& name, bool& on, const std::string& help);

/// union, intersect or subtract, which must be given.
void add_operation(CLI::App& command, const std::string& name, Operation& operation,
                   const std::string& help);

}  // namespace sectile::cli
