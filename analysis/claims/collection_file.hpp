// Collections of studies by their files: NAME/collection.toml and, for a paper, claims.toml beside it.
#pragma once

#include <span>
#include <vector>

#include "analysis/report/paper.hpp"
#include "numerics/embedded_file.hpp"

namespace ikbench::claims {

// Reads all collections, by name. Throws std::invalid_argument with the file and the line for anything missing, unknown
// or repeated.
std::vector<report::Collection> read_collections(std::span<const numerics::EmbeddedFile> files);

}  // namespace ikbench::claims
