#include "io/document_summary.h"

#include <gtest/gtest.h>

#include "error.h"
#include "io/stage_documents.h"
#include "stage_samples.h"

namespace partwise::io {
namespace {

TEST(DocumentSummary, SaysKindElementsFactsAndHistory) {
  Document document = to_document(tests::sample_segmented_model());
  document.metadata["metrics"]["segment"] = {{"iterations", 12}};
  document.metadata["history"] = extend_history({&document}, {"segment", {{"--sharpness", 2}}, {}});
  const std::string text = summary(document);
  for (const std::string line :
       {"kind              segment (partwise/segment-1)\n",
        "  vertex            66: x y z (double), red green blue (uint8)\n",
        "  face              128: vertex_indices (lists of int32), part (int32), red green blue (uint8)\n",
        "markers           2: nose, chin\n", "    iterations        12\n", "  0  segment "}) {
    EXPECT_NE(text.find(line), std::string::npos) << line << text;
  }
  EXPECT_NE(text.find(" --sharpness 2\n       from partwise/segment-1 "), std::string::npos) << text;
}

TEST(DocumentSummary, BarePlyIsAMesh) {
  Document document = to_document(tests::sample_segmented_model());
  document.metadata = Json::object();
  EXPECT_EQ(summary(document).rfind("kind              mesh (bare PLY)\n", 0), 0U);
  EXPECT_NO_THROW(check_document(document));
}

TEST(DocumentCheck, PassesEveryKindAndFindsDamage) {
  std::vector<Document> documents{to_document(tests::sample_segmented_model().mesh),
                                  to_document(tests::sample_segmented_model()),
                                  to_document(tests::sample_hulled_model()),
                                  to_document(tests::sample_hull_map()),
                                  to_document(tests::sample_cross_map()),
                                  to_document(tests::sample_compatible_mesh())};
  for (Document& document : documents) {
    EXPECT_NO_THROW(check_document(document)) << document.kind();
    document.tables.elements.pop_back();
    EXPECT_THROW(check_document(document), InputError) << document.kind();
  }
}

}  // namespace
}  // namespace partwise::io
