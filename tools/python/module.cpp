// SPDX-License-Identifier: GPL-3.0-or-later
// parison._core: scenes, runs and states for Python; the package beside this file is what a user sees.
#include <fmt/format.h>
#include <pybind11/functional.h>
#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include <memory>
#include <system_error>
#include <utility>

#include "core/case/case_error.hpp"
#include "core/mesh/mesh.hpp"
#include "core/process/run_error.hpp"
#include "forming/run/checkpoint.hpp"
#include "forming/run/folder_run.hpp"
#include "forming/run/stage.hpp"
#include "forming/scene/accuracy.hpp"
#include "forming/scene/describe/dimensionless_numbers.hpp"
#include "tools/program/blas_threads.hpp"
#include "tools/program/kept_memory.hpp"

namespace py = pybind11;

namespace parison::python {
namespace {

using core::Index;
using forming::RunOutcome;
using forming::Scene;
using forming::State;

/// A state that does not change any more. Arrays of it share its memory and keep it alive.
struct Snapshot {
  std::shared_ptr<const Scene> scene;
  std::shared_ptr<const State> state;
};

/// A body of a snapshot: the glass, or a tool in its own frame.
struct BodyView {
  std::shared_ptr<const Scene> scene;
  std::shared_ptr<const State> state;
  Index number;  ///< as forming::mesh_of takes it

  const core::Mesh& mesh() const { return forming::mesh_of(*state, number); }
};

/// An array over memory of a state, which it keeps alive; it cannot be written to.
template <typename Number>
py::array view(const std::shared_ptr<const State>& owner, const Number* data, std::vector<py::ssize_t> shape) {
  using Keeper = std::shared_ptr<const State>;
  const py::capsule keeper(new Keeper(owner), [](void* kept) { delete static_cast<Keeper*>(kept); });
  py::array_t<Number> array(std::move(shape), data, keeper);
  array.attr("setflags")(py::arg("write") = false);
  return array;
}

py::array nodes(const BodyView& body) {
  static_assert(sizeof(core::Point) == core::dim * sizeof(double), "points lie one behind the other");
  const auto& points = body.mesh().nodes;
  return view(body.state, points.empty() ? nullptr : points.front().data(),
              {static_cast<py::ssize_t>(points.size()), core::dim});
}

py::array cells(const BodyView& body) {
  const auto& cells = body.mesh().cells();
  return view(body.state, cells.empty() ? nullptr : cells.front().data(), {static_cast<py::ssize_t>(cells.size()), 6});
}

py::list boundary(const BodyView& body) {
  py::list edges;
  for (const auto& edge : body.mesh().boundary_edges())
    edges.append(
        py::make_tuple(edge.nodes[0], edge.nodes[1], edge.nodes[2], body.mesh().boundaries()[edge.boundary_id].name));
  return edges;
}

template <typename Values>
py::array field_view(const BodyView& body, const Values& values, int components) {
  const auto places = static_cast<py::ssize_t>(values.size()) / components;
  return view(body.state, values.data(),
              components == 1 ? std::vector<py::ssize_t>{places} : std::vector<py::ssize_t>{places, components});
}

/// Fields by name; those of the glass from their registry.
py::dict fields(const BodyView& body) {
  py::dict found;
  if (body.number != forming::glass_body) {
    const auto& temperature = forming::temperature_of(*body.state, body.number);
    if (temperature.size() > 0) found["temperature"] = field_view(body, temperature, 1);
    return found;
  }
  forming::for_each_glass_field([&](const auto& field) {
    const auto& values = body.state->glass.*(field.values);
    if (values.size() > 0) found[field.name] = field_view(body, values, field.components);
  });
  return found;
}

py::dict units(const BodyView& body) {
  py::dict found;
  if (body.number != forming::glass_body)
    found["temperature"] = "K";
  else
    forming::for_each_glass_field([&](const auto& field) { found[field.name] = field.unit; });
  return found;
}

/// Calls a Python function after each step and passes a keyboard interrupt on as a request to stop.
class Callback : public forming::RunObserver {
 public:
  Callback(std::shared_ptr<const Scene> scene, py::object function)
      : scene_(std::move(scene)), function_(std::move(function)) {}

  void step_taken(const forming::RunView& run, const State&, const forming::StepReport&) override {
    if (function_.is_none() || stop_) return;
    const py::gil_scoped_acquire python;
    try {
      const py::object answer = function_(Snapshot{scene_, std::make_shared<State>(run.state)});
      const int truth = PyObject_IsTrue(answer.ptr());  // also of numpy's own True
      if (truth < 0) throw py::error_already_set();
      stop_ = truth == 1;
    } catch (py::error_already_set& error) {
      raised_ = std::make_unique<py::error_already_set>(error);
      stop_ = true;
    }
  }

  bool stops() {
    const py::gil_scoped_acquire python;
    if (PyErr_CheckSignals() != 0) {
      raised_ = std::make_unique<py::error_already_set>();
      stop_ = true;
    }
    return stop_;
  }

  /// What the function raised, or the interrupt; called with the interpreter's lock.
  void raise_what_was_raised() const {
    if (raised_) throw *raised_;
  }

 private:
  std::shared_ptr<const Scene> scene_;
  py::object function_;
  std::unique_ptr<py::error_already_set> raised_;
  bool stop_ = false;
};

py::dict facts(const RunOutcome& outcome) {
  py::dict found;
  found["completed"] = outcome.facts.completed;
  found["stopped"] = outcome.facts.stopped;
  found["reason"] = outcome.facts.reason;
  return found;
}

std::pair<Snapshot, py::dict> run(const std::shared_ptr<Scene>& scene, const std::string& directory,
                                  const py::object& function, bool again) {
  Callback callback(scene, function);
  RunOutcome outcome;
  {
    const py::gil_scoped_release others;
    const tools::OneBlasThread one_thread;
    const tools::KeptMemory kept_memory;
    const auto stop = [&] { return callback.stops(); };
    if (again) forming::require_unchanged_copy(directory, *scene);
    outcome = again ? forming::resume_in_folder(*scene, directory, {&callback}, stop)
                    : forming::run_in_folder(*scene, directory, {&callback}, stop);
    forming::write_summary(directory, *scene, outcome);
  }
  callback.raise_what_was_raised();
  const py::dict how = facts(outcome);
  return {Snapshot{scene, std::make_shared<State>(std::move(outcome.state))}, how};
}

std::shared_ptr<Scene> read(const std::string& path, const std::string& accuracy,
                            const std::vector<std::string>& overrides) {
  if (forming::read_accuracy(accuracy).target)
    throw core::CaseError(
        "accuracy: an error asked for was found, allowed here are draft, standard, fine and "
        "\"draft coarser 1.5\"; `parison run --accuracy 0.5%` asks for an error");
  return std::make_shared<Scene>(forming::read_scene(path, accuracy, overrides));
}

std::string tool_name(const BodyView& body) {
  return body.number == forming::glass_body ? "glass" : body.scene->tools[body.number - 1].name;
}

double offset(const BodyView& body) {
  return body.number == forming::glass_body ? 0 : body.state->tools[body.number - 1].offset;
}

void define_states(py::module_& module) {
  py::class_<BodyView>(module, "Body")
      .def_property_readonly("name", &tool_name)
      .def_property_readonly("nodes", &nodes)
      .def_property_readonly("cells", &cells)
      .def_property_readonly("boundary", &boundary)
      .def_property_readonly("fields", &fields)
      .def_property_readonly("units", &units)
      .def_property_readonly("offset", &offset)
      .def_property_readonly("volume",
                             [](const BodyView& body) { return core::volume(body.mesh(), body.scene->geometry); });
  py::class_<Snapshot>(module, "State")
      .def_property_readonly("time", [](const Snapshot& now) { return now.state->time; })
      .def_property_readonly("step", [](const Snapshot& now) { return now.state->totals.steps; })
      .def_property_readonly("stage", [](const Snapshot& now) { return now.scene->stages[now.state->stage].name; })
      .def_property_readonly("remeshes", [](const Snapshot& now) { return forming::remeshes(*now.state); })
      .def_property_readonly("glass",
                             [](const Snapshot& now) {
                               return BodyView{now.scene, now.state, 0};
                             })
      .def_property_readonly("tools", [](const Snapshot& now) {
        py::dict tools;
        for (Index tool = 0; tool < static_cast<Index>(now.state->tools.size()); ++tool)
          tools[now.scene->tools[tool].name.c_str()] = BodyView{now.scene, now.state, forming::body_of_tool(tool)};
        return tools;
      });
}

/// parison.CaseError(message, file, line, key) and parison.Error(message) are classes of the package itself.
void define_errors(py::module_&) {
  py::register_exception_translator([](std::exception_ptr thrown) {
    try {
      if (thrown) std::rethrow_exception(thrown);
    } catch (const core::CaseError& error) {
      const py::object type = py::module_::import("parison.errors").attr("CaseError");
      PyErr_SetObject(type.ptr(), type(error.what(), error.file, error.line, error.key).ptr());
    } catch (const core::RunError& error) {
      const py::object type = py::module_::import("parison.errors").attr("RunError");
      PyErr_SetObject(type.ptr(), type(error.what()).ptr());
    } catch (const std::system_error& error) {  // of std::filesystem
      const py::object type = py::module_::import("parison.errors").attr("Error");
      PyErr_SetObject(type.ptr(), type(error.what()).ptr());
    }
  });
}

}  // namespace

PYBIND11_MODULE(_core, module) {
  define_errors(module);
  define_states(module);
  py::class_<Scene, std::shared_ptr<Scene>>(module, "Scene")
      .def_readonly("name", &Scene::name)
      .def_readonly("accuracy", &Scene::accuracy_name)
      .def_property_readonly("text", [](const Scene& scene) { return scene.files->front().content; })
      .def("describe", [](const Scene& scene) { return forming::describe_scene(scene); })
      .def("first_stage_failure", [](const Scene& scene) { return forming::first_stage_failure(scene); });
  module.def("read", &read, py::arg("path"), py::arg("accuracy"), py::arg("overrides"));
  module.def("run", &run, py::arg("scene"), py::arg("directory"), py::arg("callback"), py::arg("resume"));
}

}  // namespace parison::python
