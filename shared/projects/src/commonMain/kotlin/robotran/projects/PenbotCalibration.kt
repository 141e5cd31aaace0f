package robotran.projects

import robotran.robolang.robot.Calibration
import robotran.world.Penbot

/** The figures of the robot that stands on the paper, as a language wants them. */
val PENBOT_CALIBRATION = Calibration(Penbot.MILLISECONDS_PER_CENTIMETRE, Penbot.MILLISECONDS_PER_DEGREE)
