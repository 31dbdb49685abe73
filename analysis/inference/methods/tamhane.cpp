#include "analysis/inference/method.hpp"

namespace ikbench::inference {

const Method tamhane_method{.name = "tamhane",
                            .title = "Welch's ANOVA with Tamhane's test",
                            .of_pair = "Tamhane's test",
                            .of_two = "Welch's test",
                            .interval = "Tamhane, separate variances",
                            .source = "Tamhane, JASA 74 (1979) 471",
                            .corrects_all_pairs = true,
                            .pairs = pairs_of_means<statistics::tamhane>,
                            .all = welch_of_all};

}  // namespace ikbench::inference
