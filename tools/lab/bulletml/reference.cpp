/*
 * reference.cpp - see reference.h. What a host of libbulletml has to bring: places, a list, and the numbers that the
 * library asks for. All arithmetic of documents is the library's own.
 */
#include "reference.h"
#include <bulletmlparser.h>
#include <bulletmlrunner.h>

#include <bulletmlparser-tinyxml.h> /* needs the one before */

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <exception>
#include <memory>
#include <stdexcept>
#include <vector>

namespace {

/* Numbers that a document may have worked out in one frame, and bullets it may have asked for. */
const long ASKED_MOST = 20000000;
const double TURN = 360, RADIAN = M_PI / 180;

class Runner;

struct Bullet {
    double x, y, dir, speed, add_x, add_y;
    double go_x, go_y; /* a frame, by direction and speed */
    std::unique_ptr<Runner> runner;
    int32_t id;
    bool gone, root;

    Bullet(int32_t number, double at_x, double at_y, double way, double pace);
    ~Bullet();
    void steer()
    {
        go_x = std::sin(dir * RADIAN) * speed;
        go_y = -std::cos(dir * RADIAN) * speed;
    }
};

double in_turn(double degrees)
{
    if (!std::isfinite(degrees))
        return 0;
    degrees = std::fmod(degrees, TURN);
    degrees = degrees < 0 ? degrees + TURN : degrees;
    return degrees >= TURN ? 0 : degrees;
}

} // namespace

struct reference {
    reference_setup setup;
    std::unique_ptr<BulletMLParser> parser;
    std::vector<std::unique_ptr<Bullet>> alive, born;
    std::vector<reference_bullet> seen;
    reference_counts counts;
    double player_x, player_y;
    int32_t next;
    int turn;
    long asked;

    Bullet *add(double x, double y, double dir, double speed);
    void ask();
    bool step(Bullet &b);
    void frame();
};

namespace {

class Runner : public BulletMLRunner {
public:
    Runner(BulletMLParser *parser, reference &r, Bullet &b) : BulletMLRunner(parser), r_(r), b_(b) {}
    Runner(BulletMLState *state, reference &r, Bullet &b) : BulletMLRunner(state), r_(r), b_(b) {}

    double getBulletDirection() override { return b_.dir; }
    double getBulletSpeed() override { return b_.speed; }
    double getDefaultSpeed() override { return 1; }
    double getBulletSpeedX() override { return b_.add_x; }
    double getBulletSpeedY() override { return b_.add_y; }
    int getTurn() override { return r_.turn; }
    void doVanish() override { b_.gone = true; }
    void doChangeDirection(double dir) override
    {
        b_.dir = in_turn(dir);
        b_.steer();
    }
    void doChangeSpeed(double speed) override
    {
        b_.speed = speed;
        b_.steer();
    }
    void doAccelX(double add) override { b_.add_x = add; }
    void doAccelY(double add) override { b_.add_y = add; }

    double getAimDirection() override
    {
        const double x = r_.player_x - b_.x, y = r_.player_y - b_.y;

        return x == 0 && y == 0 ? 0 : in_turn(std::atan2(x, -y) / RADIAN);
    }

    /* Every expression asks for the rank, whether it names it or not. */
    double getRank() override
    {
        r_.counts.expressions++;
        r_.ask();
        return r_.setup.rank;
    }

    double getRand() override
    {
        r_.counts.draws++;
        return r_.setup.random.next(r_.setup.random.context);
    }

    void createSimpleBullet(double dir, double speed) override { r_.add(b_.x, b_.y, dir, speed); }

    void createBullet(BulletMLState *state, double dir, double speed) override
    {
        Bullet *child = r_.add(b_.x, b_.y, dir, speed);

        if (child)
            child->runner.reset(new Runner(state, r_, *child)); /* which owns the state now */
        else
            delete state;
    }

private:
    reference &r_;
    Bullet &b_;
};

Bullet::Bullet(int32_t number, double at_x, double at_y, double way, double pace)
    : x(at_x), y(at_y), dir(way), speed(pace), add_x(0), add_y(0), id(number), gone(false), root(false)
{
    steer();
}

Bullet::~Bullet() {}

} // namespace

void reference::ask()
{
    if (++asked > ASKED_MOST)
        throw std::runtime_error("a frame had no end");
}

/* NULL: there was no room. */
Bullet *reference::add(double x, double y, double dir, double speed)
{
    ask();
    if ((int64_t)(alive.size() + born.size()) >= setup.most) {
        counts.dropped++;
        return NULL;
    }
    born.emplace_back(new Bullet(next++, x, y, in_turn(dir), speed));
    counts.made++;
    return born.back().get();
}

/* False: it has vanished, or left. */
bool reference::step(Bullet &b)
{
    counts.moved++;
    if (b.runner) {
        counts.ran++;
        if (b.root && setup.loop && b.runner->isEnd())
            b.runner.reset(new Runner(parser.get(), *this, b));
        b.runner->run();
        if (b.gone)
            return false;
        if (!b.root && b.runner->isEnd())
            b.runner.reset(); /* as a host would that wants to be fast */
    }
    if (setup.plain)
        b.steer();
    b.x += b.go_x + b.add_x;
    b.y += b.go_y + b.add_y;
    return b.root || !(std::fabs(b.x) > setup.box_x || std::fabs(b.y) > setup.box_y);
}

void reference::frame()
{
    size_t kept = 0;

    asked = 0;
    for (size_t i = 0; i < alive.size(); i++)
        if (step(*alive[i])) {
            if (kept != i)
                alive[kept] = std::move(alive[i]);
            kept++;
        }
    alive.resize(kept);
    for (auto &b : born)
        alive.push_back(std::move(b));
    born.clear();
    turn++;
}

extern "C" void reference_root(struct reference *r, double x, double y)
{
    r->born.emplace_back(new Bullet(r->next++, x, y, TURN / 2, 0));
    Bullet &root = *r->born.back();
    root.root = true;
    root.runner.reset(new Runner(r->parser.get(), *r, root));
    r->alive.push_back(std::move(r->born.back()));
    r->born.pop_back();
}

extern "C" struct reference *reference_open(const struct reference_setup *setup, char *err, size_t err_size)
{
    std::unique_ptr<reference> r(new reference());

    r->setup = *setup;
    try {
        r->parser.reset(new BulletMLParserTinyXML(setup->file));
        r->parser->build();
        reference_root(r.get(), setup->root_x, setup->root_y);
    } catch (const std::exception &e) {
        snprintf(err, err_size, "%s", e.what());
        return NULL;
    }
    return r.release();
}

extern "C" void reference_close(struct reference *r)
{
    delete r;
}

extern "C" bool reference_frame(struct reference *r, double player_x, double player_y, char *err, size_t err_size)
{
    r->player_x = player_x;
    r->player_y = player_y;
    try {
        r->frame();
    } catch (const std::exception &e) {
        snprintf(err, err_size, "%s", e.what());
        return false;
    }
    return true;
}

extern "C" int32_t reference_bullets(struct reference *r, const struct reference_bullet **out)
{
    r->seen.clear();
    for (const auto &b : r->alive)
        r->seen.push_back(reference_bullet{ b->id, b->x, b->y, b->dir, b->speed });
    *out = r->seen.data();
    return (int32_t)r->seen.size();
}

extern "C" void reference_remove(struct reference *r, int32_t id)
{
    auto at = std::lower_bound(r->alive.begin(), r->alive.end(), id,
                               [](const std::unique_ptr<Bullet> &b, int32_t wanted) { return b->id < wanted; });

    if (at != r->alive.end() && (*at)->id == id)
        r->alive.erase(at);
}

extern "C" void reference_count(const struct reference *r, struct reference_counts *out)
{
    *out = r->counts;
}
