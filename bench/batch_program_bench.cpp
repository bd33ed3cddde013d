// What the batch program needs as a whole, from file to file: seconds, and memory at its peak.

#include <filesystem>
#include <fstream>
#include <stdexcept>
#include <string>

#include <fcntl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <holdfast/constraint_files/constraint_file.h>
#include <holdfast/io/mesh_file.h>

#include "bench/benchmarks.h"
#include "bench/measure.h"
#include "bench/samples.h"
#include "bench/scenes.h"

namespace holdfast::bench {
namespace {

/// A folder of our own for files, gone with this.
class Folder {
 public:
  Folder()
  {
    std::string name = (std::filesystem::temp_directory_path() / "holdfast_bench_XXXXXX").string();
    if (::mkdtemp(name.data()) == nullptr) throw std::runtime_error("no folder for files of the benchmark");
    path_ = name;
  }
  ~Folder() { std::filesystem::remove_all(path_); }
  Folder(const Folder&) = delete;
  Folder& operator=(const Folder&) = delete;

  [[nodiscard]] std::string file(const char* name) const { return path_ / name; }

 private:
  std::filesystem::path path_;
};

/// Resident bytes of the batch program at its peak.
double peakOfBatch(const Folder& folder, const std::string& backend)
{
  startPeak();  // what is resident here when it starts is counted as its own
  const pid_t child = ::fork();
  if (child == 0) {
    ::execl(HOLDFAST_BATCH, HOLDFAST_BATCH, "deform", folder.file("mesh.ply").c_str(), "--constraints",
            folder.file("scene.json").c_str(), "--out", folder.file("out.ply").c_str(), "--quiet", "--backend",
            backend.c_str(), nullptr);
    ::_exit(127);
  }
  int status = 0;
  rusage usage{};
  if (::wait4(child, &status, 0, &usage) != child || status != 0) throw std::runtime_error("holdfast-batch failed");
  return 1024.0 * static_cast<double>(usage.ru_maxrss);
}

}  // namespace

void batchProgram(benchmark::State& state, const Mesh& mesh)
{
  const Folder folder;
  writeMesh(folder.file("mesh.ply"), {mesh, nullptr}, mesh.positions);
  std::ofstream(folder.file("scene.json")) << constraintsToJson(scene(mesh));
  Samples samples;
  for ([[maybe_unused]] auto turn : state)
    for (const char* backend : {"holdfast", "cholmod"}) {
      double bytes = 0;
      samples.add(backend, "s", secondsOf([&] { bytes = peakOfBatch(folder, backend); }));
      samples.add(backend, "KB a vertex", bytes / 1000 / static_cast<double>(mesh.vertexCount()));
    }
  for (const char* column : {"s", "KB a vertex"})
    samples.addRatios(std::string("= ") + column, {"holdfast", column}, {"cholmod", column});
  samples.report(state);
}

}  // namespace holdfast::bench
