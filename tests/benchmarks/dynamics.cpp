// Times of a scene's functions beside Pinocchio's, called one state at a time.
//
//   dynamics ROBOT.urdf free|fixed SCENE.so NAME NQ NV
//
// Prints a line "function,whose,ns", the time of a call, for each in every round; all cycle through
// 64 random states.
#include <pinocchio/fwd.hpp>  // first: it sets limits of Boost

#include <dlfcn.h>

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

struct Timed {
  std::string function, whose;
  std::function<void(int)> call;
};

// In every round each of them, once through all states untimed and then four times; the first moves
// on from round to round.
void report(const std::vector<Timed> &all) {
  for (int round = 0; round < rounds; ++round) {
    for (size_t turn = 0; turn < all.size(); ++turn) {
      const Timed &timed = all[(round + turn) % all.size()];
      std::chrono::steady_clock::time_point start;
      for (int repeat = -1; repeat < 4; ++repeat) {
        if (repeat == 0) {
          start = std::chrono::steady_clock::now();
        }
        for (int state = 0; state < states; ++state) {
          timed.call(state);
        }
      }
      const std::chrono::duration<double, std::nano> taken =
          std::chrono::steady_clock::now() - start;
      std::printf("%s,%s,%.2f\n", timed.function.c_str(), timed.whose.c_str(),
          taken.count() / (4 * states));
    }
  }
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

  std::vector<Timed> all;
  const auto add = [&](const char *function, const char *whose, std::function<void(int)> call) {
    all.push_back({function, whose, std::move(call)});
  };
  const auto own3 = [&](const char *function) {
    const auto call = symbol<Real3>(library, name + "_" + function);
    add(function, "double", [&, call](int i) {
      call(own_q[i].data(), own_v[i].data(), own_a[i].data(), result.data());
      sink = result[0];
    });
    const auto single = symbol<Single3>(library, name + "_" + function + "f");
    add(function, "single", [&, single](int i) {
      single(single_q[i].data(), single_v[i].data(), single_a[i].data(), short_result.data());
      sink = static_cast<double>(short_result[0]);
    });
  };
  own3("inverse_dynamics");
  add("inverse_dynamics", "pinocchio", [&](int i) {
    sink = pinocchio::rnea(model, data, q[i], v[i], a[i])[0];
  });
  own3("forward_dynamics");
  add("forward_dynamics", "pinocchio", [&](int i) {
    sink = pinocchio::aba(model, data, q[i], v[i], a[i])[0];
  });
  const auto masses = symbol<Real1>(library, name + "_mass_matrix");
  add("mass_matrix", "double", [&](int i) {
    masses(own_q[i].data(), result.data());
    sink = result[0];
  });
  add("mass_matrix", "pinocchio", [&](int i) { sink = pinocchio::crba(model, data, q[i])(0, 0); });
  report(all);
  (void)sink;
  return 0;
}
