// A collection of studies by its files: NAME/collection.toml and, of a paper, claims.toml and audit.toml beside it.
#pragma once

#include <span>
#include <vector>

#include "analysis/report/paper.hpp"
#include "numerics/embedded_file.hpp"

namespace ikbench::claims {

// All that have a collection.toml, by name. Whatever is missing, unknown or twice is std::invalid_argument with the
// file and the line; items of an audit are looked at when it is asked for.
std::vector<report::Collection> read_collections(std::span<const numerics::EmbeddedFile> files);

}  // namespace ikbench::claims
