#include "app/batch.h"

#include <sstream>

#include <gmock/gmock.h>

#include "support/meshes.h"

namespace holdfast::test {
namespace {

using testing::ElementsAreArray;
using testing::HasSubstr;

constexpr const char* kOld = "an old file";

constexpr const char* kLow =
    R"({"type": "fixed", "name": "low", "select": {"halfspace": {"point": [0, 0, -0.8], "normal": [0, 0, -1]}}})";
constexpr const char* kHigh =
    R"({"type": "handle", "name": "high", "select": {"halfspace": {"point": [0, 0, 0.8], "normal": [0, 0, 1]}},
        "rotate": {"axis": [0, 0, 1], "degrees": 20}, "translate": [0, 0, 0.5]})";
constexpr const char* kPoint = R"({"type": "point", "name": "P", "at": {"near": [1, 0, 0]}, "move": [0.1, 0, 0]})";

}  // namespace

ProcessResult runBatch(const std::vector<std::string>& arguments, const ProcessOptions& options)
{
  std::vector<std::string> command{HOLDFAST_BATCH_PROGRAM};
  command.insert(command.end(), arguments.begin(), arguments.end());
  return runProcess(command, options);
}

std::string objText(const Mesh& mesh)
{
  std::ostringstream text;
  text.precision(17);
  for (const auto& p : mesh.positions.rowwise()) text << "v " << p.x() << ' ' << p.y() << ' ' << p.z() << '\n';
  for (Index f = 0; f < mesh.faces.size(); ++f) {
    text << 'f';
    for (const Index v : mesh.faces[f]) text << ' ' << v + 1;
    text << '\n';
  }
  return text.str();
}

std::string constraintText(const std::vector<std::string>& constraints)
{
  std::string text = R"({"format": "holdfast-constraints", "version": 1, "units": "mm", "constraints": [)";
  for (std::size_t k = 0; k < constraints.size(); ++k) text += (k == 0 ? "\n" : ",\n") + constraints[k];
  return text + "\n]}\n";
}

void expectRefusal(const ProcessResult& result, int code, const std::vector<std::string>& messages)
{
  EXPECT_EQ(result.exitCode, code) << "signal " << result.signal << ", time-out " << result.isTimedOut << "\n"
                                   << result.err;
  EXPECT_EQ(result.out, "");
  EXPECT_THAT(result.err, HasSubstr("holdfast-batch: "));
  for (const std::string& message : messages) EXPECT_THAT(result.err, HasSubstr(message));
}

BatchTest::BatchTest()
    : mesh_(in_.file("sphere.obj", objText(icosphere(2))).string()),
      constraints_(in_.file("constraints.json", constraintText({kLow, kHigh, kPoint})).string())
{
}

std::vector<std::string> BatchTest::deform(const std::string& meshPath, const std::string& constraintPath,
                                           const std::vector<std::string>& more) const
{
  std::vector<std::string> arguments{
      "deform",          meshPath,   "--constraints",       constraintPath, "--out",
      output("out.obj"), "--report", output("report.json"), "--fields",     output("fields.vtp")};
  arguments.insert(arguments.end(), more.begin(), more.end());
  return arguments;
}

std::vector<std::string> BatchTest::allOutputs()
{
  return {"fields.vtp", "out.obj", "report.json"};
}

void BatchTest::expectRefusedWithoutTrace(const std::vector<std::string>& arguments, int code,
                                          const std::vector<std::string>& messages, const ProcessOptions& options) const
{
  expectRefusal(runBatch(arguments, options), code, messages);
  EXPECT_THAT(out_.names(), testing::IsEmpty());
  putOldOutputs();
  expectRefusal(runBatch(arguments, options), code, messages);
  expectOldOutputs();
  for (const std::string& name : allOutputs()) std::filesystem::remove(output(name));
}

void BatchTest::putOldOutputs() const
{
  for (const std::string& name : allOutputs()) static_cast<void>(out_.file(name, kOld));
}

void BatchTest::expectOldOutputs() const
{
  EXPECT_THAT(out_.names(), ElementsAreArray(allOutputs()));
  for (const std::string& name : allOutputs()) EXPECT_TRUE(bytesOf(out_.path() / name) == kOld) << name;
}

}  // namespace holdfast::test
