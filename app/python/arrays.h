#pragma once

#include "core/image/image.h"
#include "core/sphere/parameterization.h"

#include <glm/glm.hpp>

#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>

#include <string>
#include <vector>

/// Pictures and directions as numpy arrays.
namespace mirrorball::python {

/// float32 [height, width, channels]. The array takes the picture over; nothing is copied.
pybind11::array_t<float> toArray(Image image);

/// The same for a picture that belongs to a Python object, which the array keeps alive and writes into.
pybind11::array_t<float> viewOf(Image& image, const pybind11::handle& owner);

/// A picture of 1, 3 or 4 channels from [height, width, channels] of any number type; copied once.
/// @throws InvalidArgument for another shape, naming `what`
Image toImage(const pybind11::array& array, const std::string& what);

/// Lists, numbers and arrays alike as an array. @throws InvalidArgument naming `what` for what is none
pybind11::array toNumbers(const pybind11::object& thing, const std::string& what);

/// [..., 3] as vectors. @throws InvalidArgument for another shape, naming `what`
std::vector<glm::dvec3> toVectors(const pybind11::array& array, const std::string& what);
/// As [..., 3] float64, in the shape of `like`, which has the same number of vectors.
pybind11::array_t<double> fromVectors(const std::vector<glm::dvec3>& vectors, const std::vector<pybind11::ssize_t>& shape);

/// The shape of an array of vectors. @throws InvalidArgument unless the last axis has 3 entries
std::vector<pybind11::ssize_t> shapeOfVectors(const pybind11::array& array, const std::string& what);

/// A layout from a KIND word. @throws InvalidArgument
MapLayout toLayout(const std::string& kind, int size, int border);
/// A KIND word. @throws InvalidArgument naming the parameter and the known words
Parameterization toKind(const std::string& word, const std::string& parameter);

} // namespace mirrorball::python
