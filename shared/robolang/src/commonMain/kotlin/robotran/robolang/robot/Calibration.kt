package robotran.robolang.robot

/**
 * The two figures of a robot that convert distances and angles to times. They belong to the robot, not to the language.
 *
 * @property millisecondsPerCentimetre how long both motors run per centimetre.
 * @property millisecondsPerDegree how long they run in opposite directions per degree.
 */
data class Calibration(val millisecondsPerCentimetre: Double, val millisecondsPerDegree: Double)
