#include "io/document.h"

#include <gtest/gtest.h>
#include <sys/stat.h>

#include <filesystem>
#include <fstream>
#include <future>
#include <iterator>

#include "builders.h"
#include "error.h"
#include "io/metadata.h"
#include "io/pending_file.h"
#include "io/sha256.h"
#include "io/stage_documents.h"

namespace partwise::io {
namespace {

namespace fs = std::filesystem;

/// A folder of its own for every test.
class Documents : public testing::Test {
 protected:
  void SetUp() override {
    const auto* test = testing::UnitTest::GetInstance()->current_test_info();
    folder =
        fs::temp_directory_path() / (std::string("partwise-") + test->name() + std::to_string(::getpid()));
    fs::create_directories(folder);
  }
  void TearDown() override { fs::remove_all(folder); }

  std::string path(const std::string& name) const { return (folder / name).string(); }
  std::string bytes(const std::string& name) const {
    std::ifstream in(path(name), std::ios::binary);
    return {std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
  }
  void put(const std::string& name, const std::string& text) const {
    std::ofstream(path(name), std::ios::binary) << text;
  }
  std::size_t file_count() const {
    return static_cast<std::size_t>(std::distance(fs::directory_iterator(folder), fs::directory_iterator()));
  }
  std::string fault(const std::string& name) const {
    try {
      read_document(path(name));
    } catch (const InputError& error) {
      return error.what();
    }
    return "";
  }

  fs::path folder;
};

Document example() {
  Document document = to_document(tests::cube(2));
  document.metadata["names"] = {"head", "t\u00eate \u5934", "tail  with  spaces ", std::string(3000, 'x')};
  document.metadata["number"] = 0.1;
  document.metadata["metrics"] = {{"convert-mesh", {{"facets", 48}}}};
  document.tables.comments = {"a comment of the user's"};
  return document;
}

void expect_same(const Document& a, const Document& b) {
  EXPECT_EQ(a.metadata, b.metadata);
  EXPECT_EQ(tables_sha256(a.tables), tables_sha256(b.tables));
  EXPECT_EQ(a.tables.comments, b.tables.comments);
  EXPECT_EQ(digest(a), digest(b));
}

/// Writes into a FIFO and reads it again at the other end.
Document through_pipe(const std::string& fifo, const Document& document) {
  EXPECT_EQ(::mkfifo(fifo.c_str(), 0600), 0);
  auto writer = std::async(std::launch::async, [&] { write_document(fifo, document, false); });
  Document back = read_document(fifo);
  writer.get();
  return back;
}

TEST_F(Documents, FilePairKeepsEverything) {
  write_document(path("a.ply"), example(), false);
  EXPECT_TRUE(fs::exists(path("a.json")));
  EXPECT_EQ(file_count(), 2U);
  const Document back = read_document(path("a.ply"));
  EXPECT_EQ(back.kind(), "mesh");
  EXPECT_EQ(back.metadata["names"], example().metadata["names"]);
  Document written = example();
  written.metadata = complete_metadata(written);
  expect_same(written, back);
}

TEST_F(Documents, PipeAndFilePairAreTheSameDocument) {
  write_document(path("a.ply"), example(), false);
  const Document from_pipe = through_pipe(path("fifo"), example());
  expect_same(read_document(path("a.ply")), from_pipe);
  EXPECT_EQ(digest(example()), digest(from_pipe));
  write_document(path("b.ply"), from_pipe, false);
  EXPECT_EQ(bytes("a.ply"), bytes("b.ply"));
  EXPECT_EQ(bytes("a.json"), bytes("b.json"));
}

TEST_F(Documents, NothingInTheFilesNamesTheHost) {
  write_document(path("a.ply"), example(), false);
  EXPECT_EQ(bytes("a.json").find(folder.string()), std::string::npos);
  EXPECT_EQ(bytes("a.ply").find(folder.string()), std::string::npos);
}

TEST_F(Documents, EmbeddedLinesAreShortAscii) {
  for (const std::string& comment : embedding_comments(complete_metadata(example()))) {
    EXPECT_LE(("comment " + comment + "\n").size(), 1000U);
    for (const char c : comment) EXPECT_TRUE(c >= ' ' && c < 127);
    EXPECT_NE(comment.back(), ' ');
  }
}

TEST_F(Documents, DamagedEmbeddedMetadataIsRefused) {
  std::vector<std::string> comments = embedding_comments(complete_metadata(example()));
  ASSERT_GT(comments.size(), 3U);
  const auto damaged = [&](auto&& change) {
    std::vector<std::string> copy = comments;
    change(copy);
    EXPECT_THROW(parse_comments(copy), InputError);
  };
  EXPECT_TRUE(parse_comments(comments).embedded);
  damaged([](auto& c) { c.pop_back(); });
  damaged([](auto& c) { c.erase(c.begin()); });
  damaged([](auto& c) { std::swap(c[1], c[2]); });
  damaged([](auto& c) { c[1].back() ^= 1; });
  damaged([](auto& c) { c.push_back("partwise future thing"); });
}

TEST_F(Documents, MismatchedPairIsRefused) {
  write_document(path("a.ply"), example(), false);
  Document other = example();
  other.metadata["number"] = 0.2;
  write_document(path("b.ply"), other, false);
  fs::copy_file(path("b.json"), path("a.json"), fs::copy_options::overwrite_existing);
  EXPECT_NE(fault("a.ply").find("a.json belongs to another PLY"), std::string::npos) << fault("a.ply");
  EXPECT_EQ(fault("a.ply").rfind(path("a.ply") + ": ", 0), 0U);
}

TEST_F(Documents, ChangedTablesAreRefused) {
  write_document(path("a.ply"), example(), false);
  std::string ply = bytes("a.ply");
  ply[ply.size() - 500] ^= 1;
  put("a.ply", ply);
  EXPECT_NE(fault("a.ply").find("tables"), std::string::npos) << fault("a.ply");
}

TEST_F(Documents, MissingSidecarIsAnError) {
  write_document(path("a.ply"), example(), false);
  fs::remove(path("a.json"));
  EXPECT_NE(fault("a.ply").find("a.json is missing"), std::string::npos);
}

TEST_F(Documents, ForeignPlyIsAMeshWhateverLiesBeside) {
  put("a.ply",
      "ply\nformat ascii 1.0\ncomment made by hand\nelement vertex 1\nproperty float x\nend_header\n0\n");
  put("a.json", "{\"schema\": \"partwise/hull-1\"}");
  const Document document = read_document(path("a.ply"));
  EXPECT_EQ(document.kind(), "mesh");
  EXPECT_EQ(document.tables.comments, std::vector<std::string>{"made by hand"});
}

TEST_F(Documents, UnknownSchemasSayWhatToDo) {
  const auto fault_of = [&](const Json& schema) {
    Document document = example();
    document.metadata["schema"] = schema;
    write_document(path("a.ply"), document, true);
    return fault("a.ply");
  };
  EXPECT_NE(fault_of("partwise/hull-2").find("anew with hull"), std::string::npos);
  EXPECT_NE(fault_of("partwise/ghost-1").find("newer partwise"), std::string::npos);
  EXPECT_NE(fault_of("somebody/else").find("none of partwise"), std::string::npos);
  EXPECT_NE(fault_of(7).find("no schema"), std::string::npos);
  EXPECT_NE(fault_of("partwise/hull-1").find("'parts'"), std::string::npos);
  EXPECT_EQ(fault_of("partwise/mesh-1"), "");
}

TEST_F(Documents, MissingFilesAndFoldersAreIoErrors) {
  EXPECT_THROW(read_document(path("none.ply")), IoError);
  EXPECT_THROW(read_document(folder.string()), IoError);
  EXPECT_THROW(write_document(path("none/a.ply"), example(), false), IoError);
}

TEST_F(Documents, ReplacesOnlyByForce) {
  write_document(path("a.ply"), example(), false);
  EXPECT_THROW(write_document(path("a.ply"), example(), false), IoError);
  write_document(path("a.ply"), example(), true);
  EXPECT_EQ(file_count(), 2U);
}

TEST_F(Documents, NeverReplacesAFileThatIsNoSidecar) {
  put("a.json", "{\"parts\": []}");
  EXPECT_THROW(write_document(path("a.ply"), example(), true), IoError);
  EXPECT_EQ(bytes("a.json"), "{\"parts\": []}");
  EXPECT_THROW(write_document(path("a.obj"), example(), true), UsageError);
}

TEST_F(Documents, FailedWriteLeavesNothing) {
  Document broken = example();
  broken.tables.elements[0].size += 1;
  EXPECT_THROW(write_document(path("a.ply"), broken, false), std::invalid_argument);
  EXPECT_THROW(write_file(path("b.txt"), false,
                          [](std::ostream& out) {
                            out << "half";
                            throw ComputationError("stopped");
                          }),
               ComputationError);
  EXPECT_EQ(file_count(), 0U);
}

TEST_F(Documents, FullDiskIsAnIoError) {
  if (!fs::exists("/dev/full")) GTEST_SKIP() << "no /dev/full here";
  EXPECT_THROW(write_document("/dev/full", example(), true), IoError);
}

TEST(Sha256, KnownValues) {
  EXPECT_EQ(sha256(""), "e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855");
  EXPECT_EQ(sha256("abc"), "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
}

}  // namespace
}  // namespace partwise::io
