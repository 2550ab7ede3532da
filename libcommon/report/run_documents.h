#pragma once

#include <optional>
#include <string>
#include <vector>

#include "io/document.h"
#include "mapping/domains.h"
#include "remeshing/compatible_mesh.h"

namespace partwise::report {

/// Where the documents of one pair lie.
struct RunPlaces {
  std::string folder;  ///< crossmap.ply, reconstructed.ply, critical.ply, compatible.ply, measure.json
  std::string source;  ///< path of the source's documents, without ".segment.ply" and so on
  std::string target;
};

/// The places of a pair that cross-parameterize.mk or batch.mk made in `folder`: the models are FOLDER/source
/// and FOLDER/target, or, where these are missing and FOLDER is called SOURCE-TARGET, ../models/SOURCE and so
/// on.
RunPlaces run_places(const std::string& folder);

/// Whether `folder` has, or was to have, the documents of a pair.
bool is_run_folder(const std::string& folder);

/// What became of one stage.
struct StageState {
  std::string title;    ///< for people: "segment (source)"
  std::string file;     ///< name of its document, without folders
  std::string trouble;  ///< why there is nothing to show of it; empty when there is
  bool missing = false;
  io::Json metadata;   ///< of its document; an empty object when in trouble
  std::string digest;  ///< of its document
};

/// One model as far as its own stages came; later members are empty when their stage is.
struct ModelStages {
  std::optional<SegmentedModel> model;
  std::vector<Part> parts;
  std::vector<ConvexHull> hulls;
  std::vector<Points> images;  ///< per part: of its local vertices on its hull
};

/// All documents of one pair, as far as they are there and can be read.
struct RunDocuments {
  std::string name;
  std::vector<StageState> stages;  ///< in the order of the pipeline
  ModelStages source;
  ModelStages target;
  std::optional<CrossMap> cross_map;
  std::optional<CompatibleMesh> reconstructed;
  std::optional<CompatibleMesh> critical;
  std::optional<CompatibleMesh> compatible;
  io::Json measure;  ///< null when it is not there

  /// Metadata of the last stage that there is; an empty object when there is none.
  const io::Json& last_metadata() const;
};

enum class RunDepth {
  everything,
  /// Of a finished pair only the compatible mesh and its figures; the other stages are just seen to be there.
  result
};

/// Reads what there is. Documents that are missing, cannot be read or belong to other meshes than the last
/// stage's are noted in `stages` and left out.
/// \throws IoError when there is no such folder, InputError when it has no document that can be read
RunDocuments read_run(const RunPlaces& places, RunDepth depth = RunDepth::everything);

}  // namespace partwise::report
