#include "caustics/light_ledger.hpp"

#include <cmath>

namespace waterlight {

namespace {

double scattered_part(const WaterOptics& optics) {
    const double extinction = optics.extinction_per_m();
    return extinction > 0 ? optics.scattering_per_m / extinction : 0;
}

}  // namespace

double LightLedger::closure() const {
    const double in = incident_w + entered_w;
    const double out = reflected_w + absorbed_w + scattered_w + floor_w + walls_w + outside_w + objects_w + lost_w;
    return in == 0 && out == 0 ? 0 : std::abs(in - out) / in;
}

LightLedger& LightLedger::operator+=(const LightLedger& other) {
    incident_w += other.incident_w;
    entered_w += other.entered_w;
    reflected_w += other.reflected_w;
    absorbed_w += other.absorbed_w;
    scattered_w += other.scattered_w;
    floor_w += other.floor_w;
    walls_w += other.walls_w;
    outside_w += other.outside_w;
    objects_w += other.objects_w;
    lost_w += other.lost_w;
    return *this;
}

FloorLedger& operator+=(FloorLedger& to, const FloorLedger& from) {
    to.incident_w += from.incident_w;
    to.reflected_w += from.reflected_w;
    to.extinguished_w += from.extinguished_w;
    to.floor_w += from.floor_w;
    to.outside_w += from.outside_w;
    to.lost_w += from.lost_w;
    to.objects_w += from.objects_w;
    to.entered_w += from.entered_w;
    return to;
}

LightLedger LightLedger::scaled(double by) const {
    return {incident_w * by, entered_w * by, reflected_w * by, absorbed_w * by, scattered_w * by,
            floor_w * by,    walls_w * by,   outside_w * by,   objects_w * by,  lost_w * by};
}

LightLedger light_ledger(const FloorLedger& l, const WaterOptics& optics) {
    const double scattered = l.extinguished_w * scattered_part(optics);
    return {.incident_w = l.incident_w,
            .entered_w = l.entered_w,
            .reflected_w = l.reflected_w,
            .absorbed_w = l.extinguished_w - scattered,
            .scattered_w = scattered,
            .floor_w = l.floor_w,
            .outside_w = l.outside_w,
            .objects_w = l.objects_w,
            .lost_w = l.lost_w};
}

LightLedger light_ledger(const BeamLedger& l, const WaterOptics& optics) {
    const double scattered = l.extinguished_w * scattered_part(optics);
    return {.incident_w = l.incident_w,
            .reflected_w = l.reflected_w,
            .absorbed_w = l.extinguished_w - scattered,
            .scattered_w = scattered,
            .floor_w = l.floor_w,
            .outside_w = l.outside_w + l.dry_w,
            .objects_w = l.objects_w,
            .lost_w = l.discarded_w};
}

}  // namespace waterlight
