// The C interface: building an instance and a triangulation.
#include "c_objects.hpp"

namespace checker = flatdt::checker;

namespace {

/// Calls `change` on the builder of an object.
template <class Object, class Change>
flatdt_error changed(Object* object, const Change& change) noexcept {
  if (object == nullptr) return FLATDT_INVALID_ARGUMENT;
  return checker::guarded([&] { change(object->builder); });
}

template <class Object>
flatdt_error give_text(Object* object, const char** text) noexcept {
  if (text == nullptr) return FLATDT_INVALID_ARGUMENT;
  *text = nullptr;
  if (object == nullptr) return FLATDT_INVALID_ARGUMENT;
  return checker::guarded([&] {
    object->text = object->builder.text();
    *text = object->text.c_str();
  });
}

}  // namespace

extern "C" {

flatdt_error flatdt_instance_new(int dimension, const char* manifold, flatdt_instance** instance) {
  return checker::give(instance, [&] {
    return std::unique_ptr<flatdt_instance>(
        new flatdt_instance{checker::InstanceBuilder(dimension, manifold), {}});
  });
}

flatdt_error flatdt_instance_add_generator(flatdt_instance* instance, const char* const* entries,
                                           size_t count) {
  return changed(instance, [&](auto& builder) { builder.add_generator(checker::span_of(entries, count)); });
}

flatdt_error flatdt_instance_set_metric(flatdt_instance* instance, const char* const* entries, size_t count) {
  return changed(instance, [&](auto& builder) { builder.set_metric(checker::span_of(entries, count)); });
}

flatdt_error flatdt_instance_add_point(flatdt_instance* instance, const char* const* coordinates,
                                       size_t count) {
  return changed(instance, [&](auto& builder) { builder.add_point(checker::span_of(coordinates, count)); });
}

flatdt_error flatdt_instance_add_point_doubles(flatdt_instance* instance, const double* coordinates,
                                               size_t count) {
  return changed(instance, [&](auto& builder) { builder.add_point(checker::span_of(coordinates, count)); });
}

flatdt_error flatdt_instance_text(flatdt_instance* instance, const char** text) {
  return give_text(instance, text);
}

void flatdt_instance_free(flatdt_instance* instance) {
  delete instance;
}

flatdt_error flatdt_triangulation_new(int dimension, flatdt_triangulation** triangulation) {
  return checker::give(triangulation, [&] {
    return std::unique_ptr<flatdt_triangulation>(
        new flatdt_triangulation{checker::TriangulationBuilder(dimension), {}});
  });
}

flatdt_error flatdt_triangulation_add_subgroup_generator(flatdt_triangulation* triangulation,
                                                         const char* const* entries, size_t count) {
  return changed(triangulation,
                 [&](auto& builder) { builder.add_subgroup_generator(checker::span_of(entries, count)); });
}

flatdt_error flatdt_triangulation_add_element(flatdt_triangulation* triangulation, const char* const* entries,
                                              size_t count) {
  return changed(triangulation,
                 [&](auto& builder) { builder.add_element(checker::span_of(entries, count)); });
}

flatdt_error flatdt_triangulation_add_cell(flatdt_triangulation* triangulation, const uint32_t* pairs,
                                           size_t count) {
  return changed(triangulation, [&](auto& builder) { builder.add_cell(checker::span_of(pairs, count)); });
}

flatdt_error flatdt_triangulation_text(flatdt_triangulation* triangulation, const char** text) {
  return give_text(triangulation, text);
}

void flatdt_triangulation_free(flatdt_triangulation* triangulation) {
  delete triangulation;
}

}  // extern "C"
