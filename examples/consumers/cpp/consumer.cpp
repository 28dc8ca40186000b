// A consumer of the test vectors in C++17, in one file: reads stabline-vectors/1 with a small JSON
// reader and judges a sequence test in doubles, to be replaced by your own.
//
//   c++ -std=c++17 -O2 -o consumer consumer.cpp
//   ./consumer ../../../vectors/sequences_3d.json          judges every case; fails on a hole
//   stabline vectors run --stream -- ./consumer --stream   answers one case a line instead
//
// The test: a line through two vertices that has all edges weakly on its right side, up to 1e-9.
// (Where only lines that touch four edges and no vertex remain, it finds none.)

#include <array>
#include <cmath>
#include <fstream>
#include <iostream>
#include <iterator>
#include <map>
#include <memory>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

// A JSON value; numbers keep their text, since floats may round them.
struct Json {
    enum Kind { Null, Bool, Number, String, Array, Object } kind = Null;
    std::string text;
    std::vector<Json> items;
    std::map<std::string, Json> fields;
    const Json* find(const std::string& key) const {
        auto at = fields.find(key);
        return at == fields.end() ? nullptr : &at->second;
    }
    const Json& operator[](const std::string& key) const {
        const Json* found = find(key);
        if (!found) throw std::runtime_error("no field " + key);
        return *found;
    }
};

struct Reader {
    const std::string& text;
    size_t at = 0;
    [[noreturn]] void fail() { throw std::runtime_error("JSON broken at byte " + std::to_string(at)); }
    char peek() {
        while (at < text.size() && std::isspace(static_cast<unsigned char>(text[at]))) ++at;
        return at < text.size() ? text[at] : '\0';
    }
    void take(char wanted) {
        if (peek() != wanted) fail();
        ++at;
    }
    bool comma(char end) {
        if (peek() == ',') { ++at; return true; }
        take(end);
        return false;
    }
    std::string string() {
        take('"');
        std::string out;
        while (at < text.size() && text[at] != '"') {
            if (text[at] == '\\') {
                if (++at >= text.size()) fail();
                // Names and numbers need no other escapes; what they stand for is not asked.
                out += text[at] == 'n' ? '\n' : text[at];
            } else {
                out += text[at];
            }
            ++at;
        }
        take('"');
        return out;
    }
    Json value() {
        Json json;
        char next = peek();
        if (next == '{') {
            json.kind = Json::Object;
            take('{');
            if (peek() == '}') { ++at; return json; }
            do {
                std::string key = (peek(), string());
                take(':');
                json.fields[key] = value();
            } while (comma('}'));
        } else if (next == '[') {
            json.kind = Json::Array;
            take('[');
            if (peek() == ']') { ++at; return json; }
            do json.items.push_back(value()); while (comma(']'));
        } else if (next == '"') {
            json.kind = Json::String;
            json.text = string();
        } else {
            size_t start = at;
            while (at < text.size() && (std::isalnum(static_cast<unsigned char>(text[at])) || text[at] == '-' || text[at] == '+' || text[at] == '.')) ++at;
            if (at == start) fail();
            json.text = text.substr(start, at - start);
            json.kind = json.text == "null" ? Json::Null : std::isalpha(static_cast<unsigned char>(json.text[0])) ? Json::Bool : Json::Number;
        }
        return json;
    }
};

using Point = std::array<double, 3>;
using Polygon = std::vector<Point>;

// An integer, or a string such as "7/3".
double number(const Json& json) {
    size_t slash = json.text.find('/');
    double top = std::stod(json.text.substr(0, slash));
    return slash == std::string::npos ? top : top / std::stod(json.text.substr(slash + 1));
}

Point minus(const Point& a, const Point& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }
Point cross(const Point& a, const Point& b) {
    return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
double dot(const Point& a, const Point& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

// Whether the line from p to q touches or passes every polygon in its direction.
bool passes(const std::vector<Polygon>& portals, const Point& p, const Point& q) {
    Point d = minus(q, p);
    if (dot(d, d) == 0) return false;
    for (const Polygon& polygon : portals)
        for (size_t i = 0; i < polygon.size(); ++i) {
            const Point &a = polygon[i], &b = polygon[(i + 1) % polygon.size()];
            if (dot(cross(minus(a, p), minus(b, p)), d) < -1e-9) return false;
        }
    return true;
}

bool seen(const std::vector<Polygon>& portals) {
    if (portals.size() == 1) return true;
    for (const Polygon& first : portals)
        for (const Polygon& second : portals)
            for (const Point& p : first)
                for (const Point& q : second)
                    if (passes(portals, p, q)) return true;
    return false;
}

// The answer to a sequence in space: 1, 0, or -1 for what is none.
int answer(const std::string& kind, const Json* input) {
    if (kind != "sequence" || !input) return -1;
    std::vector<Polygon> portals;
    for (const Json& polygon : (*input)["portals"].items) {
        portals.emplace_back();
        for (const Json& point : polygon.items) {
            if (point.items.size() != 3) return -1;
            portals.back().push_back({number(point.items[0]), number(point.items[1]), number(point.items[2])});
        }
    }
    return seen(portals);
}

int main(int count, char** arguments) try {
    if (count != 2) {
        std::cerr << "usage: consumer VECTORS.json | --stream\n";
        return 2;
    }
    std::string argument = arguments[1];
    if (argument == "--stream") {
        for (std::string line; std::getline(std::cin, line);) {
            Json json = Reader{line}.value();
            int said = answer(json["kind"].text, json.find("input"));
            std::cout << (said < 0 ? "{\"skip\": \"sequences in space only\"}" : said ? "{\"class\": \"open\"}" : "{\"class\": \"blocked\"}") << std::endl;
        }
        return 0;
    }
    std::ifstream file(argument);
    std::string text{std::istreambuf_iterator<char>(file), {}};
    Json vectors = Reader{text}.value();
    if (vectors["format"].text != "stabline-vectors/1") throw std::runtime_error("not stabline-vectors/1");
    std::map<std::string, int> marks;
    for (const Json& group : vectors["groups"].items)
        for (const Json& test : group["tests"].items) {
            int said = answer(group["kind"].text, test.find("input"));
            if (said < 0) { ++marks["skipped"]; continue; }
            const std::string& truth = test["class"].text;
            std::string mark = truth == "grazing" ? "allowed" : (truth == "open") == (said == 1) ? "exact" : said ? "waste" : "hole";
            ++marks[mark];
            if (mark == "hole") std::cout << "hole " << test["tcId"].text << ": " << test["comment"].text << "\n";
        }
    for (const auto& [mark, times] : marks) std::cout << mark << " " << times << "\n";
    return marks["hole"] == 0 ? 0 : 1;
} catch (const std::exception& error) {
    std::cerr << error.what() << "\n";
    return 2;
}
