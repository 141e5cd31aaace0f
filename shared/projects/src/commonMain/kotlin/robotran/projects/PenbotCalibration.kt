package robotran.projects

import robotran.robolang.robot.RobotTarget
import robotran.world.Penbot

/** The calibration of the penbot for the compiler. */
val PENBOT_CALIBRATION = RobotTarget.Rcx(Penbot.MILLISECONDS_PER_CENTIMETRE, Penbot.MILLISECONDS_PER_DEGREE)
