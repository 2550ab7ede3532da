#pragma once

#include <memory>
#include <mutex>
#include <string>

#include "io/document.h"
#include "segmentation/segmenter.h"
#include "sketching/mirror.h"

/// What the tool `sketch` does for a page on which a person draws strokes and picks markers.
namespace partwise::sketching {

/// A mesh and the file of its sketch, which is saved and cut into parts again after every change.
class SketchedModel {
 public:
  /// \param mesh_path what the mesh was read from; its name is the model's
  /// \param sketch_path X.sketch.json: read when it exists, written by put()
  /// \throws InputError, IoError naming `sketch_path` when there is such a file but no sketch for this mesh
  SketchedModel(std::string mesh_path, const TriMesh& mesh, std::string sketch_path);

  const std::string& name() const { return name_; }
  const std::string& mesh_path() const { return mesh_path_; }
  const std::string& sketch_path() const { return sketch_path_; }
  bool has_saved_sketch() const;

  /// Name, files, counts, `center` and `diagonal` of the bounding box.
  io::Json facts() const;

  /// Little-endian octets: three 32-bit floats per vertex, (p - center) / diagonal, then three unsigned
  /// 32-bit integers per facet.
  std::string geometry() const;

  /// Points of any number near this model in the same form, floats only.
  std::string normalized(const Points& points) const;

  /// The sketch document as it stands.
  const io::Json& sketch() const { return sketch_; }

  /// Checks a sketch document, saves it (the file as it was before the first change stays beside it as
  /// X.sketch.json~), cuts the mesh into its parts.
  /// \throws InputError when it is no sketch for this mesh, IoError: then nothing has changed
  void put(const std::string& text);

  /// What the sketch makes of the mesh: parts, labels, boundaries, warnings. While it does not suffice,
  /// `problem`, a sentence; beside it what the strokes alone make of the mesh when they suffice. Parts
  /// without strokes are left out, and anchors at them.
  const io::Json& result() const { return result_; }

  /// The parts; nothing while there is a problem.
  std::shared_ptr<const SegmentedModel> segmented() const { return segmented_; }

  /// The model's symmetry, looked for when it is first asked for (about a second). Unlike all else here,
  /// threads may ask for it at once, and while another thread changes the sketch.
  const Mirror& mirror();

  /// Where the mirror image of a place lies: `face` and `barycentric`; an empty object when that is the place
  /// itself. Threads may ask as for mirror(). \param place a marker's as in a sketch document, by `vertex`,
  /// `face` or `point` \throws InputError when it is none, or the model is not symmetric
  io::Json mirrored(const std::string& place);

 private:
  void save(const io::Json& document);
  void segment(const Sketch& sketch);
  io::Json facts_of_strokes(const Sketch& sketch);

  std::string name_;
  std::string mesh_path_;
  std::string sketch_path_;
  Vec3 center_;
  double diagonal_;  // of the bounding box: the mesh computes it anew each time
  Segmenter segmenter_;
  io::Json sketch_;
  io::Json result_;
  std::shared_ptr<const SegmentedModel> segmented_;
  bool changed_ = false;
  std::once_flag mirror_made_;
  std::unique_ptr<const Mirror> mirror_;
};

/// Which parts are far from convex: `concave`, an array of `part`, `concavity` and `deepest` vertex; and
/// where to cut them (propose_cuts): `proposed_cuts`, an array of `part` and `curves`. Takes as long again as
/// the segmentation, or some times as long where parts are not drawn yet.
io::Json hints(const SegmentedModel& model);

/// Whether the parts of two models correspond (compare_segmentations): `differences` and `misplaced` markers,
/// a sentence each; or `problem`.
io::Json compare(const SketchedModel& a, const SketchedModel& b);

}  // namespace partwise::sketching
