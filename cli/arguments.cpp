#include "arguments.h"

#include <CLI/CLI.hpp>
#include <limits>
#include <map>

namespace sectile::cli {
namespace {

const std::map<std::string, Operation>& operations() {
  static const std::map<std::string, Operation> names{{"union", Operation::unite},
                                                      {"intersect", Operation::intersect},
                                                      {"subtract", Operation::subtract}};
  return names;
}

const std::map<std::string, Rule>& rules() {
  static const std::map<std::string, Rule> names{
      {"positive", Rule::positive}, {"nonzero", Rule::nonzero}, {"odd", Rule::odd}};
  return names;
}

}  // namespace

CLI::App* add_command(CLI::App& program, const std::string& name, const std::string& description) {
  return program.add_subcommand(name, description);
}

void add_text(CLI::App& command, const std::string& name, std::string& text,
              const std::string& help, const std::string& placeholder) {
  command.add_option(name, text, help)->required()->type_name(placeholder);
}

void add_optional_text(CLI::App& command, const std::string& name, std::string& text,
                       const std::string& help, const std::string& placeholder) {
  command.add_option(name, text, help)->type_name(placeholder);
}

void add_length(CLI::App& command, const std::string& name, double& length, const std::string& help,
                const std::string& placeholder) {
  command.add_option(name, length, help)
      ->check(CLI::Range(0.0, std::numeric_limits<double>::max()))
      ->type_name(placeholder);
}

void add_texts(CLI::App& command, const std::string& name, std::vector<std::string>& texts,
               int least, int most, const std::string& help, const std::string& placeholder) {
  command.add_option(name, texts, help)->required()->expected(least, most)->type_name(placeholder);
}

void add_switch(CLI::App& command, const std::string& name, bool& on, const std::string& help) {
  command.add_flag(name, on, help);
}

void add_operation(CLI::App& command, const std::string& name, Operation& operation,
                   const std::string& help) {
  command.add_option(name, operation, help)
      ->required()
      ->transform(CLI::Transformer(operations()))
      ->type_name("OPERATION");
}

void add_rule(CLI::App& command, const std::string& name, Rule& rule, const std::string& help) {
  command.add_option(name, rule, help)
      ->transform(CLI::Transformer(rules()))
      ->type_name("positive|nonzero|odd");
}

}  // namespace sectile::cli
