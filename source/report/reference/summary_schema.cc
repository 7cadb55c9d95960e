// SPDX-License-Identifier: LGPL-2.1-or-later
#include <abut/report/json.h>
#include <abut/report/reference/summary_keys.h>
#include <abut/report/reference/summary_schema.h>

#include <deal.II/base/exceptions.h>

namespace abut
{
  namespace
  {
    const std::string or_null = " or null", one_of = "one of: ";

    bool ends_with(const std::string &text, const std::string &end)
    {
      return text.size() >= end.size() && text.compare(text.size() - end.size(), end.size(), end) == 0;
    }

    Json empty_object()
    {
      return {{"type", "object"},
              {"properties", Json::object()},
              {"required", Json::array()},
              {"additionalProperties", false}};
    }

    Json words_in(std::string text)
    {
      Json words = Json::array();
      const std::string separator = " | ";
      for (auto end = text.find(separator); end != std::string::npos; end = text.find(separator))
      {
        words.push_back(text.substr(0, end));
        text.erase(0, end + separator.size());
      }
      words.push_back(text);
      return words;
    }

    /// Of a type's name without ` or null`.
    Json schema_of(const std::string &type)
    {
      if (type.compare(0, one_of.size(), one_of) == 0)
        return {{"type", "string"}, {"enum", words_in(type.substr(one_of.size()))}};
      if (type == "text")
        return {{"type", "string"}};
      if (type == "texts")
        return {{"type", "array"}, {"items", {{"type", "string"}}}};
      if (type == "true or false")
        return {{"type", "boolean"}};
      if (type == "count")
        return {{"type", "integer"}, {"minimum", 0}};
      if (type == "number")
        return {{"type", "number"}};
      if (type == "vector")
        return {{"type", "array"}, {"items", {{"type", "number"}}}, {"minItems", 2}, {"maxItems", 2}};
      if (type == "list")
        return {{"type", "array"}, {"items", empty_object()}};
      AssertThrow(type == "object", dealii::ExcMessage("a type of keys that is none: " + type));
      return empty_object();
    }

    Json schema_of(const SummaryKey &key)
    {
      const bool may_be_null = ends_with(key.type, or_null);
      Json schema = {{"description", key.meaning}};
      if (!key.unit.empty())
        schema["unit"] = key.unit;
      schema.update(schema_of(key.type.substr(0, key.type.size() - (may_be_null ? or_null.size() : 0))));
      if (may_be_null)
      {
        schema["type"] = {schema["type"], "null"};
        if (schema.contains("enum"))
          schema["enum"].push_back(nullptr);
      }
      return schema;
    }

    /// The place of a key below an object's schema; `path`: the rest of it.
    Json &place_of(const std::string &path, Json &object)
    {
      const auto dot = path.find('.');
      std::string name = path.substr(0, dot);
      const bool is_list = ends_with(name, "[]");
      if (is_list)
        name.erase(name.size() - 2);
      const bool is_any = name.front() == '<';
      if (dot == std::string::npos && !is_any)
        object["required"].push_back(name);
      Json &place = is_any ? object["additionalProperties"] : object["properties"][name];
      if (dot == std::string::npos)
        return place;
      return place_of(path.substr(dot + 1), is_list ? place["items"] : place);
    }
  } // namespace

  std::string summary_schema()
  {
    Json schema = {{"$schema", "https://json-schema.org/draft/2020-12/schema"},
                   {"title", "summary.json of abut"},
                   {"description", "What a run has found. Printed by `abut --reference schema`."}};
    schema.update(empty_object());
    for (const SummaryKey &key : summary_keys())
      place_of(key.path, schema) = schema_of(key);
    return schema.dump(2) + '\n';
  }
} // namespace abut
