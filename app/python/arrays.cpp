#include "arrays.h"

#include "core/base/error.h"

#include <algorithm>
#include <memory>

namespace py = pybind11;

namespace mirrorball::python {

namespace {

std::string shapeText(const py::array& array)
{
    std::string text = "[";
    for (py::ssize_t axis = 0; axis < array.ndim(); ++axis)
        text += (axis == 0 ? "" : ", ") + std::to_string(array.shape(axis));
    return text + "]";
}

} // namespace

py::array_t<float> viewOf(Image& image, const py::handle& owner)
{
    return py::array_t<float>({image.height, image.width, image.channels}, image.texels.data(), owner);
}

py::array_t<float> toArray(Image image)
{
    auto kept = std::make_unique<Image>(std::move(image));
    const py::capsule owner(kept.get(), [](void* pointer) { delete static_cast<Image*>(pointer); });
    return viewOf(*kept.release(), owner);
}

Image toImage(const py::array& array, const std::string& what)
{
    const bool isPicture = array.ndim() == 3 && (array.shape(2) == 1 || array.shape(2) == 3 || array.shape(2) == 4);
    if (!isPicture || array.shape(0) < 1 || array.shape(1) < 1 || array.shape(0) > (1 << 17) || array.shape(1) > (1 << 17))
        throw InvalidArgument(what + ": must be an array [height, width, channels] with 1, 3 or 4 channels; its shape is " +
                              shapeText(array));
    const auto texels = py::array_t<float, py::array::c_style | py::array::forcecast>::ensure(array);
    if (!texels)
        throw py::error_already_set();
    Image image(static_cast<int>(array.shape(1)), static_cast<int>(array.shape(0)), static_cast<int>(array.shape(2)));
    std::copy_n(texels.data(), texels.size(), image.texels.begin());
    return image;
}

py::array toNumbers(const py::object& thing, const std::string& what)
{
    py::array array = py::array::ensure(thing);
    if (!array) {
        PyErr_Clear();
        throw InvalidArgument(what + ": must be an array of numbers");
    }
    if (array.dtype().kind() != 'f' && array.dtype().kind() != 'i' && array.dtype().kind() != 'u' && array.dtype().kind() != 'b')
        throw InvalidArgument(what + ": must be an array of numbers; its type is " + py::str(array.dtype()).cast<std::string>());
    return array;
}

std::vector<py::ssize_t> shapeOfVectors(const py::array& array, const std::string& what)
{
    if (array.ndim() < 1 || array.shape(array.ndim() - 1) != 3)
        throw InvalidArgument(what + ": must be an array [..., 3]; its shape is " + shapeText(array));
    return {array.shape(), array.shape() + array.ndim()};
}

std::vector<glm::dvec3> toVectors(const py::array& array, const std::string& what)
{
    shapeOfVectors(array, what);
    const auto values = py::array_t<double, py::array::c_style | py::array::forcecast>::ensure(array);
    if (!values)
        throw py::error_already_set();
    std::vector<glm::dvec3> vectors(static_cast<size_t>(values.size() / 3));
    for (size_t i = 0; i < vectors.size(); ++i)
        vectors[i] = {values.data()[3 * i], values.data()[3 * i + 1], values.data()[3 * i + 2]};
    return vectors;
}

py::array_t<double> fromVectors(const std::vector<glm::dvec3>& vectors, const std::vector<py::ssize_t>& shape)
{
    py::array_t<double> array(shape);
    double* out = array.mutable_data();
    for (const glm::dvec3& v : vectors)
        for (int c = 0; c < 3; ++c)
            *out++ = v[c];
    return array;
}

Parameterization toKind(const std::string& word, const std::string& parameter)
{
    if (const auto kind = parameterizationFromName(word))
        return *kind;
    std::string known;
    for (const Parameterization p : allParameterizations)
        known += (known.empty() ? "" : ", ") + std::string(name(p));
    throw InvalidArgument(parameter + ": '" + word + "' is no parameterization; choose one of " + known);
}

MapLayout toLayout(const std::string& kind, int size, int border)
{
    const MapLayout layout{.kind = toKind(kind, "kind"), .size = size, .border = border};
    validate(layout);
    return layout;
}

} // namespace mirrorball::python
