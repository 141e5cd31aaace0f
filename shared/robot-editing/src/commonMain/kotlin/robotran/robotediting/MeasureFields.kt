package robotran.robotediting

import robotran.editing.Field
import robotran.editing.NumberSpec
import robotran.editing.RobotTexts
import robotran.world.RobotDescription

/**
 * What a real robot did on paper, from which its figures follow: of one whose motors count degrees wheels and track, of a
 * micro:bit buggy how fast it is, its track and by what its faster wheel is slowed down. It was driven by programs with the
 * figures of [driven]. Empty for other robots, whose motors run for a time.
 */
internal fun RobotDescription.measureFields(driven: RobotDescription): List<Field<RobotEdit>> = when {
    brick.hasMotorCounters -> countedFields(driven)
    buggy != null -> timedFields(driven)
    else -> emptyList()
}

/**
 * A motor that counts degrees turns as far as the program has reckoned, so a way and a turn are as much longer or shorter
 * as the figures are wrong.
 */
private fun RobotDescription.countedFields(driven: RobotDescription): List<Field<RobotEdit>> {
    val wheels = drive.wheelDiameter / driven.drive.wheelDiameter
    val turn = wheels / (drive.track / driven.drive.track)
    return listOf(
        Field.Heading(RobotTexts::measure),
        Field.Help { RobotTexts.measureHelp(it, WAY.toInt()) },
        wayField(WAY * wheels, WAYS) { way ->
            // The turn stays what was measured.
            val changed = way / (WAY * wheels)
            copy(drive = drive.copy(wheelDiameter = drive.wheelDiameter * changed, track = drive.track * changed))
        },
        turnField(TURN * turn, TURNS) { measured ->
            copy(drive = drive.copy(track = drive.track * TURN * turn / measured))
        },
    )
}

/** Each field keeps what the others say, so that their order does not matter. */
private fun RobotDescription.timedFields(driven: RobotDescription): List<Field<RobotEdit>> {
    val measured = TestDrives.of(this, driven)
    return listOf(
        Field.Heading(RobotTexts::measure),
        Field.Help { RobotTexts.measureBuggyHelp(it, WAY.toInt()) },
        wayField(measured.way, TIMED_WAYS) { measured.copy(way = it).applied(this, driven) },
        Field.Number("robot-measured-side", RobotTexts::measuredSide, shown(measured.side), SIDES) { side ->
            RobotEdit.Change(measured.copy(side = side).applied(this, driven), "measured side")
        },
        turnField(measured.turn, TIMED_TURNS) { measured.copy(turn = it).applied(this, driven) },
    )
}

private fun wayField(now: Double, spec: NumberSpec, with: (Double) -> RobotDescription): Field<RobotEdit> =
    Field.Number(
        "robot-measured-way",
        { RobotTexts.measuredWay(it, WAY.toInt()) },
        shown(now),
        spec,
    ) { RobotEdit.Change(with(it), "measured way") }

private fun turnField(now: Double, spec: NumberSpec, with: (Double) -> RobotDescription): Field<RobotEdit> =
    Field.Number("robot-measured-turn", RobotTexts::measuredTurn, shown(now), spec) {
        RobotEdit.Change(with(it), "measured turn")
    }

/** What the program asks for: centimetres, and degrees. */
internal const val WAY = 50.0
internal const val TURN = 360.0

// What is further off is another robot, or a slip of the pen.
private val WAYS = NumberSpec(30.0..80.0, step = 0.5, unit = "cm")
private val TURNS = NumberSpec(180.0..720.0, step = 1.0, unit = "°")

/** A buggy that nobody has measured may be twice as fast as we think, or half. */
private val TIMED_WAYS = NumberSpec(20.0..120.0, step = 0.5, unit = "cm")
private val TIMED_TURNS = NumberSpec(120.0..1080.0, step = 1.0, unit = "°")
private val SIDES = NumberSpec(-15.0..15.0, step = 0.5, unit = "cm")
