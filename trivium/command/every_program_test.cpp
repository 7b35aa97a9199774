/// Properties that all programs share: help, messages about misuse, exit codes, errors of writing.

#include "trivium/command/testing/run_program.hpp"

namespace trivium::test {
namespace {

TEST(EveryProgram, HasHelpAndVersion) {
  std::vector<std::string> programs = validations();
  programs.push_back("trivium");
  for (const std::string& program : programs)
    for (const std::string flag : {"--help", "--version"}) {
      const Outcome r = run(program + " " + flag);
      EXPECT_EQ(r.exit_code, 0) << program << flag;
      EXPECT_NE(r.out, "");
    }
  for (const std::string command : {"solve", "simulate", "check", "list", "generate"})
    for (const std::string flag : {" --help", " --version"})
      EXPECT_EQ(run("trivium " + command + flag).exit_code, 0) << command << flag;
}

// /dev/full acts as a full disk: short output fails when it is flushed, long output while it is printed
TEST(EveryProgram, DoesNotPassOverResultsThatCouldNotBeWritten) {
  std::vector<std::string> all{"trivium solve heavy_top", "trivium simulate heavy_top --t-end 0.1",
                               "trivium check n_four_bar_40 --json", "trivium generate chain 100",
                               "trivium --help"};
  for (const std::string& program : validations()) all.push_back(program + " simple_pendulum");
  for (const std::string& words : all) {
    const Outcome r = run(words + " >/dev/full");
    EXPECT_EQ(r.exit_code, 3) << words;
    EXPECT_EQ(r.err, "error: the results could not be written to stdout: No space left on device\n") << words;
  }
}

TEST(EveryProgram, SuggestsTheNearestNameOfTheCatalogue) {
  std::vector<std::string> all = validations();
  all.push_back("trivium solve");
  all.push_back("trivium simulate");
  for (const std::string& program : all)
    for (const std::string name : {"heavy_tpo", "heavy_tpo.json", "heavy_top.json"}) {
      const Outcome r = run(program + " " + name);
      EXPECT_EQ(r.exit_code, 2) << program;
      EXPECT_EQ(r.err,
                "error: " + name +
                    ": no such file, and no such scene in the catalogue; accepted: a path to a scene file, "
                    "or a name that trivium list prints (did you mean \"heavy_top\"?)\n");
    }
}

TEST(EveryProgram, FindsASceneBesideAFolderOfItsName) {
  const fs::path folder = temporary("folder");
  fs::create_directories(folder / "heavy_top");
  const Outcome r = run("trivium solve heavy_top", folder);
  EXPECT_EQ(r.exit_code, 0) << r.err;
  EXPECT_TRUE(r.out.starts_with("heavy_top: ")) << r.out;
}

TEST(Trivium, ListsItsSubcommandsToWhoeverNamesNone) {
  EXPECT_EQ(run("trivium").err,
            "error: no subcommand; accepted: solve, simulate, compare, check, list, generate; see trivium "
            "--help\n");
  EXPECT_EQ(run("trivium foo").err,
            "error: unknown subcommand \"foo\"; accepted: solve, simulate, compare, check, list, generate; "
            "see trivium --help\n");
  EXPECT_NE(run("trivium slove heavy_top").err.find("(did you mean \"solve\"?)"), std::string::npos);
  for (const std::string words : {"trivium", "trivium foo", "trivium slove heavy_top"})
    EXPECT_EQ(run(words).exit_code, 2) << words;
}

TEST(EveryProgram, AnswersMisuseWithExitCodeTwo) {
  for (const std::string words :
       {"trivium",
        "trivium solv heavy_top",
        "trivium solve",
        "trivium solve no_such_scene",
        "trivium solve heavy_top --scalar half",
        "trivium solve heavy_top --sequence 312x",
        "trivium solve heavy_top --t nan",
        "trivium check heavy_top --t inf",
        "trivium simulate heavy_top --integrator euler",
        "trivium simulate heavy_top --formulation r-q",
        "trivium simulate heavy_top --t-end -1",
        "trivium simulate heavy_top --step 0.3 --t-end 1",
        "trivium simulate heavy_top --step 0.1 --rtol 1e-3",
        "trivium simulate heavy_top --rtol 0",
        "trivium simulate heavy_top --integrator bulirsch-stoer --step 0.1 --t-end 1",
        "trivium simulate heavy_top --integrator rattle4 --t-end 1",
        "trivium simulate heavy_top --integrator generalized-alpha --step 0.01 --t-end 1 --no-projection",
        "trivium simulate heavy_top --integrator bdf --step 0.01 --t-end 1 --baumgarte 1 1",
        "trivium simulate heavy_top --integrator bdf --step 0.01 --t-end 1 --order 6",
        "trivium simulate heavy_top --integrator hht --step 0.01 --t-end 1 --rho 0.5",
        "trivium simulate heavy_top --integrator rattle --step 0.01 --t-end 1 --formulation r-p",
        "trivium simulate heavy_top --integrator dopri5 --full-newton",
        "trivium simulate heavy_top --baumgarte 1",
        "trivium simulate heavy_top --baumgarte nan 1",
        "trivium simulate heavy_top --rtol 1e-30 --atol 1e-30",
        "trivium simulate heavy_top --integrator hem4 --step 0.01 --t-end 1 --baumgarte 1 1",
        "convergence_order --method cvode-bdf",
        "trivium simulate heavy_top --plot motion.png",
        "trivium simulate heavy_top --out no_such_folder/motion.csv",
        "lambda_invariance no_such_scene",
        "precision_ladder --no-such-option"}) {
    const Outcome r = run(words);
    EXPECT_EQ(r.exit_code, 2) << words;
    EXPECT_NE(r.err, "") << words;
  }
}

}  // namespace
}  // namespace trivium::test
