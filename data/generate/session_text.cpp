#include "session_text.h"

#include <holdfast/constraints/constraint_file.h>
#include <holdfast/document/session_mesh.h>

namespace holdfast::generate {

std::string sessionText(const File& mesh, const std::string& constraints)
{
  SessionFile session;
  session.mesh = {mesh.name, "", checksumOfBytes(mesh.bytes)};
  session.document.list = parseConstraintsJson(constraints, mesh.name);
  session.view.colorBy = "displacement";
  return sessionToJson(session);
}

}  // namespace holdfast::generate
