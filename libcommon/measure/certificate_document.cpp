#include "measure/certificate_document.h"

namespace partwise {
namespace {

using io::Json;

Json side_json(const SphereCertificate& side) {
  return {{"faces", side.facets},
          {"folds", side.folds},
          {"euler_characteristic", side.euler_characteristic},
          {"degree", side.degree}};
}

std::string side_text(const SphereCertificate& side) {
  return std::to_string(side.facets) + " facets, " + std::to_string(side.folds) + " folded, Euler " +
         std::to_string(side.euler_characteristic) + ", degree " + std::to_string(side.degree);
}

}  // namespace

Json certificate_json(const Certificate& certificate) {
  Json pieces = Json::array();
  for (const PieceCertificate& piece : certificate.pieces) {
    Json entry{{"name", piece.name},
               {"one_to_one", piece.one_to_one()},
               {"source", side_json(piece.source)},
               {"target", side_json(piece.target)}};
    if (!piece.one_to_one()) entry["reason"] = piece.reason();
    pieces.push_back(std::move(entry));
  }
  Json result{{"one_to_one", certificate.one_to_one()}, {"pieces", std::move(pieces)}};
  if (!certificate.one_to_one()) result["reason"] = certificate.first_reason();
  return result;
}

std::string certificate_text(const std::string& name, const Certificate& certificate) {
  std::string text =
      name + ": " +
      (certificate.one_to_one() ? "certified one-to-one" : "not certified: " + certificate.first_reason()) +
      "\n";
  for (const PieceCertificate& piece : certificate.pieces) {
    text += "  " + std::string(piece.one_to_one() ? "yes" : "no ") + "  " + piece.name + "\n";
    text += "       source: " + side_text(piece.source) + "\n";
    text += "       target: " + side_text(piece.target) + "\n";
    if (!piece.one_to_one()) text += "       " + piece.reason() + "\n";
  }
  return text;
}

}  // namespace partwise
