// The key of stored solves: it changes with everything that decides numbers, and with nothing else.
#include "tests/experiments/samples.hpp"

namespace {

std::string key_of(const Study& study) { return series_key(study, study.solvers.front()); }

// Returns the small study with one change.
template <class Change>
Study changed(Change&& change) {
  Study study = small_study();
  change(study);
  return study;
}

// A visitor that changes the field at one place of a list.
class Changer final : public Fields {
 public:
  explicit Changer(int place) : left_(place) {}

  std::string changed;  // its name, or empty if there are fewer fields
  InKey in_key = InKey::by_name;

 private:
  void on_text(Name name, std::string& field) override {
    if (is_at(name)) field = "planar_3";
  }
  void on_texts(Name name, std::vector<std::string>& field) override {
    if (is_at(name)) field.emplace_back("further");
  }
  void on_choice(Name name, std::size_t& chosen, const std::vector<std::string>& choices) override {
    if (is_at(name)) chosen = (chosen + 1) % choices.size();
  }
  void on_whole(Name name, std::int64_t& field, std::pair<std::int64_t, std::int64_t>) override {
    if (is_at(name)) ++field;
  }
  void on_number(Name name, double& field, double unit, std::pair<double, double>) override {
    if (is_at(name)) field += unit;
  }
  void on_numbers(Name name, std::vector<double>& field, double unit, int) override {
    if (is_at(name)) field[0] += unit;
  }
  void on_poses(Name name, const std::any& field) override {
    if (is_at(name)) std::any_cast<std::vector<Pose>*>(field)->push_back(Pose::Identity());
  }

  bool is_at(Name name) {
    if (left_-- != 0) return false;
    changed = name.key;
    in_key = name.in_key;
    return true;
  }

  int left_;
};

std::vector<std::string> all_keys_of(const Study& study) {
  std::vector<std::string> keys;
  for (const SolverEntry& entry : study.solvers) keys.push_back(configuration_key(study, entry));
  return keys;
}

}  // namespace

TEST_CASE("each field of a study decides the series, unless the list of fields says that it decides no number",
          "[series]") {
  const Study plain = small_study();
  std::set<std::string> without_numbers;
  int fields = 0;
  for (;; ++fields) {
    Study study = plain;
    Changer changer(fields);
    list_fields(changer, study);
    list_fields(changer, study.stop);
    if (changer.changed.empty()) break;
    INFO(changer.changed);
    CHECK((all_keys_of(study) == all_keys_of(plain)) == (changer.in_key == InKey::no));
    if (changer.in_key == InKey::no) without_numbers.insert(changer.changed);
  }
  CHECK(fields >= 18);
  for (int field = 0;; ++field) {  // how it is judged and drawn
    Study study = plain;
    Changer changer(field);
    list_fields(changer, study.plan);
    list_fields(changer, study.figures);
    if (changer.changed.empty()) break;
    INFO(changer.changed);
    CHECK(all_keys_of(study) == all_keys_of(plain));
  }
  CHECK(without_numbers == std::set<std::string>{"name", "title", "published", "rounds", "runs"});
}

TEST_CASE("each field of each kind of path decides the series", "[series][path]") {
  for (std::size_t kind = 0; kind < target_sets().size(); ++kind) {
    if (target_sets()[kind]->name() == "grid") continue;  // its fields decide which poses are laid out (grid.test.cpp)
    for (int field = 0;; ++field) {
      Study study = small_study();
      study.path = target_sets()[kind];
      const std::vector<std::string> plain = all_keys_of(study);
      Changer changer(field);
      study.path->list_fields(changer);
      if (changer.changed.empty()) {
        CHECK(field > 0);
        break;
      }
      INFO(study.path->name() << "." << changer.changed);
      CHECK((all_keys_of(study) == plain) == (changer.in_key == InKey::no));
    }
  }
}

TEST_CASE("targets are the same whatever kind of path they are of", "[series][path]") {
  Study study = small_study();
  study.path = path_through(targets_of_run(study, 1));
  CHECK(all_keys_of(study) == all_keys_of(small_study()));
}

TEST_CASE("the paper's studies keep their configurations, so that older stores are recognized", "[series][paper]") {
  std::istringstream known(text_in("tests/data/configurations.txt"));
  int studies = 0;
  for (std::string line; std::getline(known, line); ++studies) {
    std::string found = line.substr(0, line.find(' '));
    for (const std::string& key : all_keys_of(load_study(found))) found += ' ' + key;
    CHECK(found == line);
  }
  CHECK(studies == 6);
}

TEST_CASE("every option of every solver decides the series", "[series]") {
  for (const SolverInfo& info : all_solvers()) {
    const Study plain = changed([&](Study& study) { study.solvers = {{"A", info.name, {}}}; });
    info.describe([&](const OptionList& list) {
      for (const Option& option : list.options()) {
        INFO(info.name << "." << option.name);
        std::set<std::string> keys;
        for (const Setting& value : option.extremes) {
          Study study = plain;
          study.solvers[0].options[option.name] = value;
          keys.insert(key_of(study));
          CHECK((key_of(study) == key_of(plain)) == (value == option.get()));
        }
        CHECK(keys.size() >= 2);
      }
    });
  }
}

TEST_CASE("a default that is written down is the same series", "[series]") {
  const Study written = changed([](Study& study) { study.solvers[0].options["alpha"] = 0.97; });  // Table 1
  CHECK(key_of(written) == key_of(small_study()));
  CHECK(key_of(changed([](Study& study) { study.solvers[0].population = study.population; })) == key_of(small_study()));
  // A solver's own default of bounds counts, too.
  CHECK(key_of(changed([](Study& study) { study.bounds = BoundsPolicy::initial; })) == key_of(small_study()));
}

TEST_CASE("a solver's label, name and population decide the series, and the other solvers do not", "[series]") {
  const std::string key = key_of(small_study());
  CHECK(key != key_of(changed([](Study& study) { study.solvers[0].label = "IK-BA 2"; })));
  CHECK(key != key_of(changed([](Study& study) { study.solvers[0].solver = "bat"; })));
  CHECK(key != key_of(changed([](Study& study) { study.solvers[0].population = 8; })));
  CHECK(key == key_of(changed([](Study& study) { study.solvers.resize(1); })));
  CHECK(key == key_of(changed([](Study& study) { study.solvers.front().colour = "#8D1804"; })));
}

TEST_CASE("the study's population decides no series of a solver that has its own", "[series]") {
  Study study = changed([](Study& plain) { plain.solvers[0].population = 8; });
  const std::string key = key_of(study), other = series_key(study, study.solvers[1]);
  study.population = 9;
  CHECK(key_of(study) == key);
  CHECK(series_key(study, study.solvers[1]) != other);
}

TEST_CASE("a series is the configuration and the source, each of 16 hexadecimal digits", "[series]") {
  const Study study = small_study();
  const std::string configuration = configuration_key(study, study.solvers.front()), key = key_of(study);
  CHECK(configuration_part(key) == configuration);
  CHECK(configuration.size() == 16);
  CHECK(key.size() == 33);
  CHECK((configuration + key.substr(17)).find_first_not_of("0123456789abcdef") == std::string::npos);
}

TEST_CASE("every solver has a source of its own, and a series says whose it is", "[series]") {
  std::set<std::string> digests{shared_source_digest()}, sources;
  for (const SolverInfo& info : all_solvers()) {
    INFO(info.name);
    CHECK(digests.insert(solver_source_digest(info.name)).second);
    const std::string key = key_of(changed([&](Study& study) { study.solvers = {{"A", info.name, {}}}; }));
    CHECK(sources.insert(key.substr(key.find('@'))).second);
  }
  // The label, the options and the rest of the study are the configuration's.
  CHECK(key_of(changed([](Study& study) { study.solvers[0].label = "Another"; })).substr(16) ==
        key_of(changed([](Study& study) { study.seed = 2; })).substr(16));
}

TEST_CASE("the study's bounds reach every solver that has bounds, and trouble none that has not", "[series]") {
  Study study = small_study();
  for (const auto& [bounds, name] : {std::pair{BoundsPolicy::clamp, "clamp"}, {BoundsPolicy::initial, "initial"}}) {
    study.bounds = bounds;
    for (const SolverInfo& info : all_solvers()) {
      INFO(info.name);
      const Settings options = effective_options(study, {"A", info.name, {}});
      if (options.contains("bounds")) CHECK(text_of(options.at("bounds")) == name);
      CHECK(options.size() == info.options({}).size());
    }
  }
  study.bounds = BoundsPolicy::per_solver;
  study.limits = LimitPolicy::enforced;
  for (const SolverInfo& info : all_solvers()) {
    const Settings options = effective_options(study, {"A", info.name, {}});
    if (options.contains("bounds")) CHECK(text_of(options.at("bounds")) != "initial");  // it would end outside
  }
  CHECK(text_of(effective_options(study, {"A", "differential_evolution", {{"bounds", "reflect"}}}).at("bounds")) ==
        "reflect");
}

TEST_CASE("a store has the settings that are used, the population among them", "[series]") {
  const auto options = [](const std::string& by) {
    const Study study = load_study("slim2023", {"PSO.coefficients=" + by});
    return nlohmann::json::parse(series_of(study)[3].options);
  };
  const auto are = [](const nlohmann::json& of, double inertia, double cognitive, double social) {
    CHECK(of["inertia"] == inertia);
    CHECK(of["cognitive"] == cognitive);
    CHECK(of["social"] == social);
    CHECK_FALSE(of.contains("coefficients"));
  };
  are(options("permuted"), 0.53514, 1.1312, 2.0149);
  are(options("exchanged"), 0.53514, 2.0149, 1.1312);
  are(options("as_printed"), 1.1312, 2.0149, 0.53514);
  CHECK(options("exchanged")["population"] == 20);
  const auto of_de = nlohmann::json::parse(series_of(load_study("slim2023"))[2].options);
  CHECK_FALSE(of_de.contains("weight"));  // F is drawn
  CHECK(nlohmann::json::parse(series_of(load_study("slim2023-50"))[2].options)["weight"] == 0.6);
  CHECK_FALSE(nlohmann::json::parse(series_of(load_study("haviland2023"))[0].options).contains("population"));
}
