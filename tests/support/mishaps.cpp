#include "tests/support/mishaps.h"

namespace arris::test {

using control::Fault;
using control::Inputs;

std::vector<Mishap> mishaps() {
  const auto of = [](Fault fault, auto set) {
    return Mishap{fault, [set](Bench& b) { set(b.ideal->inputs, true); },
                  [set](Bench& b) { set(b.ideal->inputs, false); }};
  };
  return {
      of(Fault::EmergencyStop, [](Inputs& in, bool on) { in.emergencyStop = on; }),
      of(Fault::EncoderLost, [](Inputs& in, bool on) { in.encoderLost[1] = on; }),
      of(Fault::DriveFault, [](Inputs& in, bool on) { in.driveFault[0] = on; }),
      of(Fault::LimitSwitch, [](Inputs& in, bool on) { in.limitHigh[1] = on; }),
      of(Fault::VacuumLost, [](Inputs& in, bool on) { in.vacuumHolds = !on; }),
      {Fault::SpindleLost, [](Bench& b) { b.ideal->spindleWorks = false; },
       [](Bench& b) { b.ideal->spindleWorks = true; }},
      {Fault::CoolantLost, [](Bench& b) { b.ideal->coolantWorks = false; },
       [](Bench& b) { b.ideal->coolantWorks = true; }},
      {Fault::OperatorLost, [](Bench& b) { b.operatorLives = false; }, [](Bench& b) { b.operatorLives = true; }},
      {Fault::FeedbackLost, [](Bench& b) { b.ideal->answers = false; }, [](Bench& b) { b.ideal->answers = true; }},
      {Fault::DriveNotReady, [](Bench& b) { b.ideal->drivesWork = false; },
       [](Bench& b) { b.ideal->drivesWork = true; }},
      {Fault::SetPointLate, [](Bench& b) { b.ideal->underruns += 3; }, [](Bench&) {}},
  };
}

} // namespace arris::test
