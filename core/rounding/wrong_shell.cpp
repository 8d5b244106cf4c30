#include "rounding/wrong_shell.h"

#include "import/soup.h"
#include "sectile/errors.h"

namespace sectile {

std::optional<std::uint32_t> face_of_wrong_shell(const PolygonMesh& mesh,
                                                 const std::atomic<bool>* cancel) {
  try {
    ImportOptions how;
    how.trusted = true;
    how.cancel = cancel;
    import_mesh(mesh, how);
    return {};
  } catch (const InvalidSolid& error) {
    return error.face() == no_element ? 0 : error.face();
  }
}

}  // namespace sectile
