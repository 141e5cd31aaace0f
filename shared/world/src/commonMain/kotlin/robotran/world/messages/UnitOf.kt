package robotran.world.messages

import robotran.brick.controls.MotorPort
import robotran.brick.kind.BrickKind
import robotran.brick.sensors.SensorKind
import robotran.json.messages.alternatives
import robotran.world.robot.RobotFigure

/** Behind a number, with a blank; empty for a mere number. */
internal fun unitOf(figure: RobotFigure, degrees: String): String = when (figure) {
    RobotFigure.MASS -> " kg"
    RobotFigure.ANGLE -> " $degrees"
    RobotFigure.CORNERS, RobotFigure.GEAR, RobotFigure.TYRE_FRICTION, RobotFigure.CASTERS, RobotFigure.PARTS -> ""
    RobotFigure.COORDINATE, RobotFigure.HEIGHT, RobotFigure.WHEEL_WIDTH, RobotFigure.TRACK, RobotFigure.BUMPER_WIDTH,
    RobotFigure.BUMPER_DEPTH, RobotFigure.SENSOR_HEIGHT,
    -> " cm"
}
