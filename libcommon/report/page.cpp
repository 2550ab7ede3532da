#include "report/page.h"

#include <stdexcept>
#include <vector>

#include "error.h"
#include "report/embedded_pages.h"

namespace partwise::report {

namespace {

const char* embedded(const std::string& name) {
  const auto file = embedded_pages().find(name);
  if (file != embedded_pages().end()) return file->second;
  throw ComputationError(
      "this build has no pages, since npm could not bundle them when it was built: install npm (Debian: "
      "apt-get install npm), make sure that it reaches its registry, and build again");
}

std::string escaped_text(const std::string& text) {
  std::string result;
  for (const char c : text) {
    if (c == '&') {
      result += "&amp;";
    } else if (c == '<') {
      result += "&lt;";
    } else {
      result += c;
    }
  }
  return result;
}

// JSON inside a script element, which "</script" or "<!--" would end.
std::string escaped_json(const io::Json& facts) {
  std::string result;
  for (const char c : facts.dump(-1, ' ', true, io::Json::error_handler_t::replace)) {
    if (c == '<') {
      result += "\\u003c";
    } else {
      result += c;
    }
  }
  return result;
}

}  // namespace

struct Sources {
  std::string name;                 // of body and script, and class of the body
  std::vector<std::string> styles;  // later ones may overrule earlier ones
  std::string policy;               // what the page may do beyond showing itself
};

Sources sources_of(Page page) {
  switch (page) {
    case Page::run:
      return {"run", {"page.css"}, ""};
    case Page::batch:
      return {"batch", {"page.css"}, ""};
    case Page::sketch:
      return {"sketch", {"page.css", "sketch.css"}, "; connect-src 'self'"};
  }
  throw std::logic_error("no such page");
}

std::string embedded_style(const Sources& sources) {
  std::string result;
  for (const std::string& style : sources.styles) result += embedded(style);
  return result;
}

std::string html_page(Page page, const std::string& title, const io::Json& facts, const PageArrays& arrays) {
  const Sources sources = sources_of(page);
  const std::pair<std::string, std::string> places[] = {{"policy", sources.policy},
                                                        {"title", escaped_text(title)},
                                                        {"style", embedded_style(sources)},
                                                        {"class", sources.name},
                                                        {"body", embedded(sources.name + ".html")},
                                                        {"facts", escaped_json(facts)},
                                                        {"arrays", base64(arrays.bytes())},
                                                        {"script", embedded(sources.name + ".js")}};
  const std::string text = embedded("page.html");
  std::string result;
  std::size_t from = 0;
  for (const auto& [place, value] : places) {  // in this order in the template
    const std::string mark = "{{" + place + "}}";
    const std::size_t at = text.find(mark, from);
    result.append(text, from, at - from);
    result += value;
    from = at + mark.size();
  }
  return result + text.substr(from);
}

}  // namespace partwise::report
