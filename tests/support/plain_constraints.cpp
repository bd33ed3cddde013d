#include "support/plain_constraints.h"

#include <sstream>
#include <string>
#include <vector>

#include "support/temporary_folder.h"

namespace holdfast::test {
namespace {

using Json = nlohmann::json;

Json fromCsv(const std::string& text)
{
  Json list = Json::array();
  std::istringstream file(text);
  std::string line;
  std::getline(file, line);
  while (std::getline(file, line)) {
    std::istringstream fields(line);
    std::string name;
    std::getline(fields, name, ',');
    std::vector<double> numbers;
    for (std::string field; std::getline(fields, field, ',');) numbers.push_back(std::strtod(field.c_str(), nullptr));
    list.push_back({{"name", name},
                    {"type", "point"},
                    {"at", {{"near", {numbers.at(0), numbers.at(1), numbers.at(2)}}}},
                    {"target", {numbers.at(3), numbers.at(4), numbers.at(5)}}});
  }
  return list;
}

}  // namespace

nlohmann::json readPlainConstraints(const std::filesystem::path& path)
{
  const std::string text = bytesOf(path);
  Json list = path.extension() == ".csv" ? fromCsv(text) : Json::parse(text).at("constraints");
  for (std::size_t k = 0; k < list.size(); ++k)
    if (list[k].value("name", "").empty())
      list[k]["name"] = list[k].at("type").get<std::string>() + " " + std::to_string(k + 1);
  return list;
}

}  // namespace holdfast::test
