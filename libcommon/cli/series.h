#pragma once

#include <optional>
#include <string>
#include <vector>

#include "cli/command.h"
#include "mesh/texture_corners.h"
#include "mesh/tri_mesh.h"

namespace partwise::cli {

/// A mesh that came with an input, and the document it came in (none for OBJ, OFF and STL).
struct ModelInput {
  TriMesh mesh;
  std::optional<io::Document> document;
  std::optional<TextureCorners> texture;  ///< OBJ's

  /// All that is known besides the geometry: `vertex` and `face` with their properties.
  io::PlyTables tables() const;
};

/// Reads the mesh of any document or mesh file. \throws InputError naming the file
ModelInput read_model(Command& command, const std::string& path);

/// Positions of a mesh that must have the connectivity of `first` (from the file `first_path`).
/// \throws InputError naming both files and the first difference
void require_same_connectivity(const TriMesh& mesh, const std::string& path, const TriMesh& first,
                               const std::string& first_path);

/// Shapes of one connectivity, of which a tool makes several at a time.
struct Series {
  std::string name;
  TriMesh mesh;                    ///< the connectivity
  std::vector<Points> shapes;      ///< per shape
  std::vector<std::string> names;  ///< per shape: file name without ending
  std::vector<io::Json> metrics;   ///< per shape
  /// Whose columns of `vertex` and `face` the shapes get, if any.
  const io::Document* looks = nullptr;
};

/// Where a series goes: FOLDER/ (NAME.ply and NAME.json for each), X.glb (one animation), or one X.ply or -.
class SeriesOutput {
 public:
  /// Declares -o, --force, and what an animation needs.
  explicit SeriesOutput(Command& command);

  bool is_animation() const;
  bool is_folder() const;

  /// To be called before long work. \throws UsageError, IoError when `names` cannot be written there
  void require_writable(const std::vector<std::string>& names) const;

  /// `inputs` are for the history. \pre require_writable
  void write(const Series& series, const std::vector<const io::Document*>& inputs) const;

 private:
  std::string path_of(const std::string& name) const;
  void write_animation(const Series& series) const;

  Command& command_;
  const std::string& output_;
  double seconds_ = 4;
  std::string up_ = "y";
};

}  // namespace partwise::cli
