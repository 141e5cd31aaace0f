package robotran.projects

import robotran.robolang.robot.Calibration
import robotran.world.Penbot
import robotran.world.RobotDescription
import robotran.world.robot.RobotFigures

/** The calibration of this robot for the compiler. */
val RobotDescription.calibration: Calibration
    get() = RobotFigures.of(this).let { Calibration(it.millisecondsPerCentimetre, it.millisecondsPerDegree) }

/** The calibration of the penbot for the compiler. */
val PENBOT_CALIBRATION = Calibration(Penbot.MILLISECONDS_PER_CENTIMETRE, Penbot.MILLISECONDS_PER_DEGREE)
