/// The program under test.
#pragma once

#include <string>

/// From the text of an instance file to the text of a triangulation file.
std::string my_triangulation(const std::string& instance_text);
