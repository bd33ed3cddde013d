#pragma once
/// \file
/// holdfast-batch as its users run it, on a small mesh, with all that it leaves behind.

#include <string>
#include <vector>

#include <gtest/gtest.h>

#include <holdfast/mesh/mesh.h>

#include "support/child_process.h"
#include "support/temporary_folder.h"

namespace holdfast::test {

/// True if holdfast-batch was built with VTK.
#ifdef HOLDFAST_WITH_VTK
inline constexpr bool kHasVtk = true;
#else
inline constexpr bool kHasVtk = false;
#endif

[[nodiscard]] ProcessResult runBatch(const std::vector<std::string>& arguments, const ProcessOptions& options = {});

/// The mesh as an OBJ file.
[[nodiscard]] std::string objText(const Mesh& mesh);

/// A constraint file with the entries `constraints`, each the text of an object.
[[nodiscard]] std::string constraintText(const std::vector<std::string>& constraints);

/// Expects exit code `code`, nothing on standard output, and standard error with every part of `messages`.
void expectRefusal(const ProcessResult& result, int code, const std::vector<std::string>& messages);

/// A folder of inputs with a sphere and constraints that can be met, and an empty folder for outputs.
class BatchTest : public testing::Test {
 protected:
  BatchTest();

  [[nodiscard]] const std::string& mesh() const { return mesh_; }
  [[nodiscard]] const std::string& constraints() const { return constraints_; }
  [[nodiscard]] std::string output(const std::string& name) const { return (out_.path() / name).string(); }

  /// `deform` with all outputs but a picture: out.obj, report.json, fields.vtp.
  [[nodiscard]] std::vector<std::string> deform(const std::string& meshPath, const std::string& constraintPath,
                                                const std::vector<std::string>& more = {}) const;
  /// The names of those outputs, sorted.
  [[nodiscard]] static std::vector<std::string> allOutputs();

  /// Runs the command twice, without old outputs and with some: expects `expectRefusal` both times, that no file is
  /// made, and that the old ones keep their bytes. Leaves the folder of outputs empty.
  void expectRefusedWithoutTrace(const std::vector<std::string>& arguments, int code,
                                 const std::vector<std::string>& messages, const ProcessOptions& options = {}) const;

  /// Puts an old file under the name of every output.
  void putOldOutputs() const;
  /// Expects exactly those, with their bytes.
  void expectOldOutputs() const;

  TemporaryFolder in_;
  TemporaryFolder out_;

 private:
  std::string mesh_;
  std::string constraints_;
};

}  // namespace holdfast::test
