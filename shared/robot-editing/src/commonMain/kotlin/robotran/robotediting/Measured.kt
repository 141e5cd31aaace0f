package robotran.robotediting

import robotran.editing.Field
import robotran.editing.NumberSpec
import robotran.editing.RobotTexts
import robotran.world.Drive

/**
 * What a real robot of this kind did on paper: how far it drove when its program said [DRIVE] centimetres, and how far it
 * turned when the program said [TURN] degrees. Wheels and track follow from it, for the simulation and for programs alike.
 *
 * @property from the wheels that the program knew.
 */
data class Measured(val from: Drive, val drove: Double = DRIVE, val turned: Double = TURN) {
    /** The wheels with which the robot would have done what the program said. */
    val drive: Drive
        get() {
            val larger = drove / DRIVE
            return from.copy(wheelDiameter = from.wheelDiameter * larger, track = from.track * larger * TURN / turned)
        }

    companion object {
        const val DRIVE = 50.0
        const val TURN = 360.0
        internal val DROVE = NumberSpec(25.0..100.0, step = 0.5, unit = "cm")
        internal val TURNED = NumberSpec(180.0..720.0, step = 1.0, unit = "°")
    }
}

/** The fields of what was measured, for the wheels; none for anything else. */
fun RobotEditing.measuredFields(): List<Field<RobotEdit>> {
    if (chosen != RobotElement.Wheels) return emptyList()
    val now = measured ?: Measured(robot.drive)
    return listOf(
        Field.Heading(RobotTexts::measured),
        Field.Help(RobotTexts::measuredHelp),
        Field.Number("robot-drove", RobotTexts::measuredDrive, now.drove, Measured.DROVE) {
            RobotEdit.Measure(now.copy(drove = it))
        },
        Field.Number("robot-turned", RobotTexts::measuredTurn, now.turned, Measured.TURNED) {
            RobotEdit.Measure(now.copy(turned = it))
        },
    )
}
