// What the commands declare about their command lines. Only these functions, options.cpp and main
// see the parser, which takes long to compile.
#pragma once

#include <string>
#include <vector>

#include "sectile/boolean.h"
#include "sectile/repair.h"

namespace CLI {
class App;
}

namespace sectile::cli {

CLI::App* add_command(CLI::App& program, const std::string& name, const std::string& description);

/// A name or value that must be given. `placeholder` stands for it in the help.
void add_text(CLI::App& command, const std::string& name, std::string& text,
              const std::string& help, const std::string& placeholder);

void add_optional_text(CLI::App& command, const std::string& name, std::string& text,
                       const std::string& help, const std::string& placeholder);

/// A finite number that is not negative.
void add_length(CLI::App& command, const std::string& name, double& length, const std::string& help,
                const std::string& placeholder);

/// From `least` to `most` names that must be given; `most` may be `any_number`.
inline constexpr int any_number = -1;
void add_texts(CLI::App& command, const std::string& name, std::vector<std::string>& texts,
               int least, int most, const std::string& help, const std::string& placeholder);

void add_switch(CLI::App& command, const std::string& name, bool& on, const std::string& help);

/// union, intersect or subtract, which must be given.
void add_operation(CLI::App& command, const std::string& name, Operation& operation,
                   const std::string& help);

/// positive, nonzero or odd.
void add_rule(CLI::App& command, const std::string& name, Rule& rule, const std::string& help);

}  // namespace sectile::cli
