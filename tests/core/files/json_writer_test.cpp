#include "core/files/json_writer.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <array>
#include <bit>
#include <cmath>
#include <limits>
#include <random>
#include <vector>

namespace arris::files {
namespace {

std::string memberAlone(const auto& value) {
  JsonWriter json;
  json.openObject();
  json.member("key", value);
  json.close();
  return json.take();
}

TEST(JsonWriter, PutsMembersBelowEachOtherAndNumbersOnOneLine) {
  JsonWriter json;
  json.openObject();
  json.member("whole", 3);
  json.member("number", 0.13);
  json.member("flag", true);
  json.member("text", "°");
  json.member("point", Eigen::Vector2d(1, -2.5));
  json.openObject("empty");
  json.close();
  json.openArray("list");
  json.openObject();
  json.member("a", std::string_view("b"));
  json.close();
  json.openObject();
  json.close();
  json.close();
  const std::array<std::string, 2> names{"x", "y"};
  json.member("names", std::span<const std::string>(names));
  json.close();
  EXPECT_EQ(json.take(), R"({
  "whole": 3,
  "number": 0.13,
  "flag": true,
  "text": "°",
  "point": [1, -2.5],
  "empty": {},
  "list": [
    {
      "a": "b"
    },
    {}
  ],
  "names": ["x", "y"]
}
)");
}

TEST(JsonWriter, EveryTextIsValidJsonAndReadsBackTheSame) {
  for (const char* text : {"", "plain", "\"quoted\" and \\ back", "\n\t\r\x01\x1f\x7f", "玻璃 außen °"}) {
    EXPECT_EQ(nlohmann::json::parse(memberAlone(text))["key"], text);
  }
  EXPECT_EQ(nlohmann::json::parse(memberAlone("a\xff"
                                              "b\xc3"))["key"],
            "a\xef\xbf\xbd"
            "b\xef\xbf\xbd");
  std::mt19937 random(5);
  for (int i = 0; i < 2000; ++i) {
    std::string bytes;
    for (int k = 0; k < 12; ++k) {
      bytes += static_cast<char>(random() % 256);
    }
    EXPECT_TRUE(nlohmann::json::accept(memberAlone(bytes)));
  }
}

TEST(JsonWriter, EveryNumberReadsBackToTheLastBit) {
  std::mt19937_64 random(17);
  for (int i = 0; i < 20000; ++i) {
    const auto value = std::bit_cast<double>(random());
    if (std::isfinite(value)) {
      ASSERT_EQ(nlohmann::json::parse(memberAlone(value))["key"].get<double>(), value);
    }
  }
  EXPECT_EQ(memberAlone(-0.0), memberAlone(0.0));
}

TEST(JsonWriter, WhatIsNoNumberIsNull) {
  for (const double value : {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity(),
                             -std::numeric_limits<double>::infinity()}) {
    EXPECT_TRUE(nlohmann::json::parse(memberAlone(value))["key"].is_null());
  }
}

} // namespace
} // namespace arris::files
