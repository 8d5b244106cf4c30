#include "arguments.h"

#include <CLI/CLI.hpp>
#include <map>

namespace sectile::cli {
namespace {

const std::map<std::string, Operation>& operations() {
  static const std::map<std::string, Operation> names{{"union", Operation::unite},
                                                      {"intersect", Operation::intersect},
                                                      {"subtract", Operation::subtract}};
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

}  // namespace sectile::cli
