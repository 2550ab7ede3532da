#include "cli/command.h"

#include <gtest/gtest.h>

#include <new>

#include "builders.h"
#include "cli/arguments.h"
#include "cli/forwarding.h"
#include "error.h"
#include "io/stage_documents.h"

namespace partwise::cli {
namespace {

using io::Json;

struct Outcome {
  int code = 0;
  std::string message;
};

/// Runs a command with an input and a few options.
Outcome run(std::vector<std::string> words, const std::function<void()>& body) {
  Command command("tool", "Does something.", "tool a.ply -o b.ply");
  command.input("model", "a model");
  double weight = 0.3;
  command.options().add_option("--weight", weight, "a weight");
  command.output_file("somewhere");
  words.insert(words.begin(), "tool");
  std::vector<char*> argv;
  for (std::string& word : words) argv.push_back(word.data());
  testing::internal::CaptureStderr();
  Outcome outcome;
  outcome.code = command.run(static_cast<int>(argv.size()), argv.data(), body);
  outcome.message = testing::internal::GetCapturedStderr();
  return outcome;
}

template <class Exception>
std::function<void()> thrower(const Exception& exception) {
  return [exception] { throw exception; };
}

TEST(Command, ExitCodesAndMessages) {
  EXPECT_EQ(run({}, [] {}).code, 0);
  EXPECT_EQ(run({}, [] {}).message, "");
  EXPECT_EQ(run({}, thrower(ComputationError("no"))).code, 1);
  EXPECT_EQ(run({}, thrower(std::runtime_error("no"))).code, 1);
  EXPECT_EQ(run({}, thrower(std::bad_alloc())).code, 1);
  EXPECT_EQ(run({}, thrower(UsageError("no"))).code, 2);
  EXPECT_EQ(run({}, thrower(InputError("no"))).code, 3);
  EXPECT_EQ(run({}, thrower(IoError("no"))).code, 4);
  EXPECT_EQ(run({}, thrower(InputError("a.ply: bad"))).message, "tool: a.ply: bad\n");
  const Outcome pipe = run({}, thrower(BrokenPipe("gone")));
  EXPECT_EQ(pipe.code, 4);
  EXPECT_EQ(pipe.message, "");
}

TEST(Command, ParseErrorsAreUsage) {
  for (const std::vector<std::string>& words :
       {std::vector<std::string>{"--no-such-option"}, {"--weight", "heavy"}, {"a", "b"}, {"--weight"}}) {
    const Outcome outcome = run(words, [] { FAIL() << "must not run"; });
    EXPECT_EQ(outcome.code, 2);
    EXPECT_EQ(outcome.message.rfind("tool: ", 0), 0U) << outcome.message;
    EXPECT_NE(outcome.message.find("tool --help"), std::string::npos);
  }
}

TEST(Command, HelpAndVersionGoToStandardOutput) {
  testing::internal::CaptureStdout();
  EXPECT_EQ(run({"--help"}, [] { FAIL(); }).code, 0);
  const std::string help = testing::internal::GetCapturedStdout();
  for (const char* text :
       {"Does something.", "tool a.ply -o b.ply", "--weight", "0.3", "Exit codes", "--force"}) {
    EXPECT_NE(help.find(text), std::string::npos) << text << " is missing in:\n" << help;
  }
  testing::internal::CaptureStdout();
  EXPECT_EQ(run({"--version"}, [] { FAIL(); }).code, 0);
  EXPECT_NE(testing::internal::GetCapturedStdout().find("tool (partwise) 0."), std::string::npos);
}

TEST(Command, ArgumentsForTheHistory) {
  const auto arguments = [](const std::string& line) {
    CLI::App app;
    app.option_defaults()->always_capture_default();
    double weight = 0.3;
    bool flag = false;
    std::string method = "exact", file, input;
    std::vector<int> seeds;
    app.add_option("input", input);
    app.add_option("-w,--weight", weight);
    app.add_option("--method", method);
    app.add_option("--seeds", seeds);
    app.add_option("--sketch", file)->check(CLI::Validator().description("FILE"));
    app.add_option("--other", file)->type_name("PATH");
    app.add_flag("--flag", flag);
    app.add_flag("--quiet")->group("Common");
    app.parse(line);
    return given_arguments(app);
  };
  EXPECT_EQ(arguments(""), Json::object());
  EXPECT_EQ(arguments("in.ply --sketch /home/me/s.json --other /x --quiet"), Json::object());
  EXPECT_EQ(arguments("--weight 0.30"), Json::object()) << "defaults are left out";
  EXPECT_EQ(arguments("-w 0.50"), arguments("--weight 0.5"));
  EXPECT_EQ(arguments("-w 0.5 --flag --method growth --seeds 1 2"),
            (Json{{"weight", 0.5}, {"flag", true}, {"method", "growth"}, {"seeds", {1, 2}}}));
}

io::Document with(const Json& fields) {
  io::Document document = io::to_document(tests::tetrahedron());
  document.metadata.update(fields);
  return document;
}

TEST(Forwarding, KeepsUnknownFieldsAndMetricsOfOneInput) {
  const io::Document input = with(
      {{"licence", "CC0"}, {"note", "old"}, {"parts", {1, 2}}, {"metrics", {{"segment", {{"parts", 7}}}}}});
  Json metadata = {{"schema", "partwise/hull-1"}, {"note", "new"}};
  forward_metadata(metadata, {&input}, "hull", {{"hulls", 7}});
  EXPECT_EQ(metadata, (Json{{"schema", "partwise/hull-1"},
                            {"note", "new"},
                            {"licence", "CC0"},
                            {"metrics", {{"segment", {{"parts", 7}}}, {"hull", {{"hulls", 7}}}}}}));
}

TEST(Forwarding, KeepsTwoInputsApart) {
  const io::Document source = with({{"licence", "CC0"}, {"by", "a"}, {"metrics", {{"hull", 1}}}});
  const io::Document target = with({{"licence", "CC0"}, {"by", "b"}, {"metrics", {{"hull", 2}}}});
  Json metadata = Json::object();
  forward_metadata(metadata, {&source, &target}, "hull-to-hull", {{"rounds", 3}});
  EXPECT_EQ(metadata["licence"], "CC0");
  EXPECT_EQ(metadata["inputs"], (Json{{"source", {{"by", "a"}}}, {"target", {{"by", "b"}}}}));
  EXPECT_EQ(metadata["metrics"],
            (Json{{"source", {{"hull", 1}}}, {"target", {{"hull", 2}}}, {"hull-to-hull", {{"rounds", 3}}}}));
}

}  // namespace
}  // namespace partwise::cli
