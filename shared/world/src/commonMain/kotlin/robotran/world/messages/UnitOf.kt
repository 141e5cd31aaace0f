package robotran.world.messages

import robotran.world.robot.RobotParameter

/** Behind a number, with a blank; empty for a mere number. */
internal fun unitOf(figure: RobotParameter, degrees: String): String = when (figure) {
    RobotParameter.MASS -> " kg"
    RobotParameter.ANGLE -> " $degrees"
    RobotParameter.CORNERS, RobotParameter.GEAR, RobotParameter.TYRE_FRICTION, RobotParameter.CASTERS,
    RobotParameter.PARTS,
    -> ""

    RobotParameter.COORDINATE, RobotParameter.HEIGHT, RobotParameter.WHEEL_WIDTH, RobotParameter.TRACK,
    RobotParameter.BUMPER_WIDTH, RobotParameter.BUMPER_DEPTH, RobotParameter.SENSOR_HEIGHT,
    -> " cm"
}
