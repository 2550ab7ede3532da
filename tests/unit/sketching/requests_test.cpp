#include "sketching/requests.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <set>

#include "builders.h"
#include "sketching/scratch_folder.h"

namespace partwise::sketching {
namespace {

using io::Json;

constexpr const char* kHost = "127.0.0.1:4000";
constexpr const char* kSketch =
    R"({"schema": "partwise/sketch-1", "parts": [{"name": "ball", "strokes": [{"vertices": [0]}]}]})";

class RequestsTest : public testing::Test {
 protected:
  RequestsTest() {
    std::vector<std::unique_ptr<SketchedModel>> models;
    models.push_back(std::make_unique<SketchedModel>(folder.path("ball.ply"), tests::sphere(2), path));
    requests = std::make_unique<Requests>("secret", "<html>", std::move(models), nullptr);
    requests->set_hosts({kHost, "localhost:4000"});
  }
  static Request get(const std::string& path) { return {"GET", path, kHost, "", "", true, ""}; }
  static Request put() {
    return {
        "PUT",  "/secret/models/0/sketch", kHost, std::string("http://") + kHost, "application/json", true,
        kSketch};
  }
  int status(const Request& request) const { return requests->answer(request).status; }
  /// Of a request that must be refused from its head, and change nothing.
  int refused(const Request& request) const {
    const auto refusal = requests->refusal(request);
    EXPECT_EQ(status(request), refusal ? refusal->status : 0);
    EXPECT_FALSE(refusal && Json::parse(refusal->body).at("error").get<std::string>().empty());
    EXPECT_FALSE(std::filesystem::exists(path));
    return refusal ? refusal->status : 0;
  }

  tests::ScratchFolder folder;
  std::string path = folder.path("ball.sketch.json");
  std::unique_ptr<Requests> requests;
};

TEST_F(RequestsTest, AnswersThePage) {
  EXPECT_FALSE(requests->refusal(get("/secret/")));
  EXPECT_EQ(requests->answer(get("/secret/")).body, "<html>");
  EXPECT_EQ(Json::parse(requests->answer(get("/secret/models")).body)["models"][0]["name"], "ball");
  EXPECT_EQ(requests->answer(get("/secret/models/0/hints")).body, R"({"concave":[],"proposed_cuts":[]})");
  EXPECT_EQ(status(put()), 200);
  EXPECT_TRUE(std::filesystem::exists(path));
  Request by_name = put();
  by_name.host = "localhost:4000";
  by_name.origin = "http://localhost:4000";
  by_name.content_type = "application/json; charset=utf-8";
  EXPECT_EQ(status(by_name), 200);
}

TEST_F(RequestsTest, RefusesOtherHosts) {
  for (const char* host : {"", "evil.example", "evil.example:4000", "127.0.0.1", "127.0.0.1:4001",
                           "127.0.0.1:4000.evil.example", "localhost"}) {
    Request request = put();
    request.host = host;
    request.origin = std::string("http://") + host;
    EXPECT_EQ(refused(request), 403) << host;
  }
}

TEST_F(RequestsTest, RefusesPathsWithoutTheToken) {
  for (const char* address : {"", "/", "secret/", "/secret", "//secret/", "/secre/", "/secrets/", "/Secret/",
                              "/models", "/../secret/", "/x/../secret/"}) {
    Request request = put();
    request.path = address;
    EXPECT_EQ(refused(request), 403) << address;
    EXPECT_EQ(refused(get(address)), 403) << address;
  }
}

TEST_F(RequestsTest, RefusesOtherPages) {
  for (const char* origin : {"http://evil.example", "null", "https://127.0.0.1:4000", "http://localhost:4000",
                             "http://127.0.0.1:4001", "http://127.0.0.1:4000.evil.example"}) {
    Request change = put(), reading = get("/secret/models/0/mesh");
    change.origin = reading.origin = origin;
    EXPECT_EQ(refused(change), 403) << origin;
    EXPECT_EQ(refused(reading), 403) << origin;
  }
  Request nameless = put();
  nameless.origin.clear();
  EXPECT_EQ(refused(nameless), 403);
}

TEST_F(RequestsTest, RefusesWhatAFormCouldPost) {
  for (const char* type : {"", "text/plain", "application/x-www-form-urlencoded", "multipart/form-data",
                           "application/jsonp", "text/plain; application/json"}) {
    Request request = put();
    request.content_type = type;
    EXPECT_EQ(refused(request), 415) << type;
  }
}

TEST_F(RequestsTest, RefusesBodiesOfUnknownSize) {
  Request request = put();
  request.is_plain = false;
  EXPECT_EQ(refused(request), 411);
}

TEST_F(RequestsTest, KnowsOnlyItsOwnPaths) {
  for (const char* address :
       {"/secret/x", "/secret/models/1/mesh", "/secret/models/-1/mesh", "/secret/models/0",
        "/secret/models/0/", "/secret/models/00/mesh", "/secret/models/0/../0/mesh", "/secret/../secret/",
        "/secret//", "/secret//etc/passwd", "/secret/models/0/mesh/../../../../etc/passwd", "/secret/run",
        "/secret/run/mesh"}) {
    EXPECT_EQ(status(get(address)), 404) << address;
  }
}

TEST_F(RequestsTest, KnowsOnlyItsOwnMethods) {
  for (const char* method : {"POST", "DELETE", "PATCH", "TRACE"}) {
    Request request = put();
    request.method = method;
    EXPECT_EQ(status(request), 405) << method;
    for (const char* address :
         {"/secret/", "/secret/models", "/secret/models/0/mesh", "/secret/models/0/hints"}) {
      request.path = address;
      EXPECT_EQ(status(request), 405) << method << ' ' << address;
    }
  }
  EXPECT_FALSE(std::filesystem::exists(path));
}

TEST_F(RequestsTest, MirrorsPlaces) {
  EXPECT_LT(Json::parse(requests->answer(get("/secret/models/0/mirror")).body)["error"], 1e-3);
  Request request = put();
  request.method = "POST";
  request.path = "/secret/models/0/mirror";
  for (const char* place : {R"({"face": 0, "barycentric": [0.2, 0.3, 0.5]})", R"({"vertex": 3})",
                            R"({"point": [0.7, 0, 0.7]})"}) {
    request.body = place;
    const Answer answer = requests->answer(request);
    EXPECT_EQ(answer.status, 200) << answer.body;
    const Json image = Json::parse(answer.body);
    EXPECT_TRUE(image.empty() || image["barycentric"].size() == 3) << answer.body;
  }
  for (const char* place : {"", "7", "[]", "{}", R"({"vertex": -1})", R"({"vertex": 1000000})",
                            R"({"face": 0, "barycentric": [2, 0, 0]})", R"({"point": [9, 9, 9]})"}) {
    request.body = place;
    EXPECT_EQ(status(request), 400) << place;
  }
  request.body = R"({"vertex": 3, "note": ")" + std::string(1000, 'x') + "\"}";
  EXPECT_EQ(status(request), 413);
  request.method = "DELETE";
  EXPECT_EQ(status(request), 405);
  EXPECT_FALSE(std::filesystem::exists(path));
}

TEST_F(RequestsTest, SaysWhatIsWrongWithASketch) {
  Request request = put();
  request.body = R"({"schema": "partwise/sketch-1", "parts": [{"name": ""}]})";
  const Answer answer = requests->answer(request);
  EXPECT_EQ(answer.status, 400);
  EXPECT_NE(Json::parse(answer.body)["error"].get<std::string>().find("name"), std::string::npos);
  EXPECT_FALSE(std::filesystem::exists(path));
}

TEST(RandomToken, IsLongAndNeverTheSame) {
  std::set<std::string> tokens;
  for (int i = 0; i < 100; ++i) tokens.insert(random_token(16));
  EXPECT_EQ(tokens.size(), 100U);
  EXPECT_EQ(tokens.begin()->size(), 32U);
  EXPECT_EQ(tokens.begin()->find_first_not_of("0123456789abcdef"), std::string::npos);
}

}  // namespace
}  // namespace partwise::sketching
