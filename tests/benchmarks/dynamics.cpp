// Times of a scene's functions beside Pinocchio's, called one state at a time.
//
//   dynamics ROBOT.urdf free|fixed SCENE.so NAME NQ NV
//
// Prints lines "function,whose,minimum,median" in ns per call; both cycle through 64 random states.
#include <pinocchio/fwd.hpp>  // first: it sets limits of Boost

#include <dlfcn.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <functional>
#include <string>
#include <vector>

#include <pinocchio/algorithm/aba.hpp>
#include <pinocchio/algorithm/crba.hpp>
#include <pinocchio/algorithm/joint-configuration.hpp>
#include <pinocchio/algorithm/rnea.hpp>
#include <pinocchio/parsers/urdf.hpp>

namespace {

constexpr int states = 64, rounds = 200;

using Real3 = void (*)(const double *, const double *, const double *, double *);
using Real1 = void (*)(const double *, double *);
using Single3 = void (*)(const float *, const float *, const float *, float *);

void report(const std::string &function, const char *whose, const std::function<void(int)> &call) {
  std::vector<double> times;
  for (int round = 0; round < rounds; ++round) {
    const auto start = std::chrono::steady_clock::now();
    for (int repeat = 0; repeat < 4; ++repeat) {
      for (int state = 0; state < states; ++state) {
        call(state);
      }
    }
    const std::chrono::duration<double, std::nano> taken = std::chrono::steady_clock::now() - start;
    times.push_back(taken.count() / (4 * states));
  }
  std::sort(times.begin(), times.end());
  std::printf("%s,%s,%.1f,%.1f\n", function.c_str(), whose, times.front(), times[rounds / 2]);
}

template <typename Function>
Function symbol(void *library, const std::string &name) {
  void *const found = dlsym(library, name.c_str());
  if (!found) {
    std::fprintf(stderr, "%s\n", dlerror());
    std::exit(1);
  }
  return reinterpret_cast<Function>(found);
}

}  // namespace

int main(int count, char **arguments) {
  if (count != 7) {
    return 2;
  }
  pinocchio::Model model;
  if (std::string(arguments[2]) == "free") {
    pinocchio::urdf::buildModel(arguments[1], pinocchio::JointModelFreeFlyer(), model);
  } else {
    pinocchio::urdf::buildModel(arguments[1], model);
  }
  pinocchio::Data data(model);
  void *const library = dlopen(arguments[3], RTLD_NOW);
  if (!library) {
    std::fprintf(stderr, "%s\n", dlerror());
    return 1;
  }
  const std::string name = arguments[4];
  const int nq = std::atoi(arguments[5]), nv = std::atoi(arguments[6]);

  std::vector<Eigen::VectorXd> q, v, a;
  std::vector<std::vector<double>> own_q(states), own_v(states), own_a(states);
  std::vector<std::vector<float>> single_q(states), single_v(states), single_a(states);
  for (int state = 0; state < states; ++state) {
    const Eigen::VectorXd low = Eigen::VectorXd::Constant(model.nq, -1.0);
    q.push_back(pinocchio::randomConfiguration(model, low, -low));
    v.push_back(Eigen::VectorXd::Random(model.nv));
    a.push_back(Eigen::VectorXd::Random(model.nv));
    const Eigen::VectorXd x = Eigen::VectorXd::Random(nq).array() + 0.1;
    own_q[state].assign(x.data(), x.data() + nq);
    own_v[state].assign(v[state].data(), v[state].data() + nv);
    own_a[state].assign(a[state].data(), a[state].data() + nv);
    single_q[state].assign(own_q[state].begin(), own_q[state].end());
    single_v[state].assign(own_v[state].begin(), own_v[state].end());
    single_a[state].assign(own_a[state].begin(), own_a[state].end());
  }
  std::vector<double> result(static_cast<size_t>(nv) * nv);
  std::vector<float> short_result(static_cast<size_t>(nv) * nv);
  volatile double sink = 0;

  const auto own3 = [&](const char *function) {
    const auto call = symbol<Real3>(library, name + "_" + function);
    report(function, "double", [&, call](int i) {
      call(own_q[i].data(), own_v[i].data(), own_a[i].data(), result.data());
      sink = result[0];
    });
    const auto single = symbol<Single3>(library, name + "_" + function + "f");
    report(function, "single", [&, single](int i) {
      single(single_q[i].data(), single_v[i].data(), single_a[i].data(), short_result.data());
      sink = static_cast<double>(short_result[0]);
    });
  };
  own3("inverse_dynamics");
  report("inverse_dynamics", "pinocchio", [&](int i) {
    sink = pinocchio::rnea(model, data, q[i], v[i], a[i])[0];
  });
  own3("forward_dynamics");
  report("forward_dynamics", "pinocchio", [&](int i) {
    sink = pinocchio::aba(model, data, q[i], v[i], a[i])[0];
  });
  const auto masses = symbol<Real1>(library, name + "_mass_matrix");
  report("mass_matrix", "double", [&](int i) {
    masses(own_q[i].data(), result.data());
    sink = result[0];
  });
  report("mass_matrix", "pinocchio", [&](int i) { sink = pinocchio::crba(model, data, q[i])(0, 0); });
  (void)sink;
  return 0;
}
