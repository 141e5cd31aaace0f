package robotran.projects

import robotran.robolang.robot.Calibration
import robotran.world.Penbot

/** The calibration of the penbot for the compiler. */
val PENBOT_CALIBRATION = Calibration(Penbot.MILLISECONDS_PER_CENTIMETRE, Penbot.MILLISECONDS_PER_DEGREE)
