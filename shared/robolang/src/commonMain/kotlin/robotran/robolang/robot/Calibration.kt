package robotran.robolang.robot

/**
 * The two figures of a robot that turn a distance and an angle into time. They belong to the robot, not to the
 * language.
 *
 * @property millisecondsPerCentimetre how long both motors drive for one centimetre.
 * @property millisecondsPerDegree how long they drive against each other for one degree.
 */
data class Calibration(val millisecondsPerCentimetre: Double, val millisecondsPerDegree: Double)
