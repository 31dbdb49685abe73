// Papers by their files: NAME/paper.toml and claims.toml beside it.
#pragma once

#include <span>
#include <vector>

#include "analysis/report/paper.hpp"
#include "numerics/embedded_file.hpp"

namespace ikbench::claims {

// Reads all papers, by name. Throws std::invalid_argument with the file and the line for anything missing, unknown
// or repeated.
std::vector<report::Paper> read_papers(std::span<const numerics::EmbeddedFile> files);

}  // namespace ikbench::claims
