package robotran.robotediting

import robotran.editing.Field
import robotran.editing.NumberSpec
import robotran.editing.RobotTexts
import robotran.world.RobotDescription

/**
 * What a real robot did on paper, from which its wheels and track follow. A motor that counts degrees turns as far as the
 * program has reckoned with the figures of [driven], so a way and a turn are as much longer or shorter as the figures are
 * wrong. Empty for robots whose motors run for a time.
 */
internal fun RobotDescription.measureFields(driven: RobotDescription): List<Field<RobotEdit>> {
    if (!brick.hasMotorCounters) return emptyList()
    val wheels = drive.wheelDiameter / driven.drive.wheelDiameter
    val turn = wheels / (drive.track / driven.drive.track)
    return listOf(
        Field.Heading(RobotTexts::measure),
        Field.Help { RobotTexts.measureHelp(it, WAY.toInt()) },
        Field.Number("robot-measured-way", {
            RobotTexts.measuredWay(it, WAY.toInt())
        }, shown(WAY * wheels), WAYS) { way ->
            // The turn stays what was measured.
            val changed = way / (WAY * wheels)
            val newDrive = drive.copy(wheelDiameter = drive.wheelDiameter * changed, track = drive.track * changed)
            RobotEdit.Change(copy(drive = newDrive), "measured way")
        },
        Field.Number("robot-measured-turn", RobotTexts::measuredTurn, shown(TURN * turn), TURNS) { measured ->
            val newDrive = drive.copy(track = drive.track * TURN * turn / measured)
            RobotEdit.Change(copy(drive = newDrive), "measured turn")
        },
    )
}

/** What the program asks for: centimetres, and degrees. */
private const val WAY = 50.0
private const val TURN = 360.0

// What is further off is another robot, or a slip of the pen.
private val WAYS = NumberSpec(30.0..80.0, step = 0.5, unit = "cm")
private val TURNS = NumberSpec(180.0..720.0, step = 1.0, unit = "°")
