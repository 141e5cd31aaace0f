package robotran.ui.robot

import androidx.compose.runtime.Composable
import robotran.brick.controls.MotorPort
import robotran.brick.sensors.SensorKind
import robotran.robotediting.RobotEdit
import robotran.robotediting.RobotElement
import robotran.robotediting.RobotSnapping
import robotran.robotediting.portsOf
import robotran.robotediting.thingsOn
import robotran.ui.texts.RobotTexts
import robotran.ui.worldedit.NumberRow
import robotran.uikit.*
import robotran.world.BumperPart
import robotran.world.BumperSide
import robotran.world.Facing
import robotran.world.RobotLimits
import robotran.world.RotationPart
import robotran.world.SensorPart
import robotran.world.robot.BrickBuild
import robotran.world.robot.things

/** The figures of a bumper or a sensor. */
@Composable
internal fun PartFields(scope: RobotScope, number: Int) {
    val part = scope.robot.things.getOrNull(number) ?: return
    PortChips(scope, number)
    when (part) {
        is BumperPart -> {
            Direction(scope, number, part.direction)
            PlaceRows(scope, RobotElement.Part(number))
            Centimetres(
                scope,
                RobotTexts::bumperWidth,
                part.width,
                RobotLimits.BUMPER_WIDTHS,
                "robot-bumper-width",
            ) {
                scope.changePart(number, "width") { old -> (old as BumperPart).copy(width = it) }
            }
            Centimetres(
                scope,
                RobotTexts::bumperDepth,
                part.depth,
                RobotLimits.BUMPER_DEPTHS,
                "robot-bumper-depth",
            ) {
                scope.changePart(number, "depth") { old -> (old as BumperPart).copy(depth = it) }
            }
            val sides =
                listOf<Pair<BumperSide?, String>>(null to RobotTexts.noName(spoken)) + sideWords()
            ChipRow(RobotTexts.side(spoken), sides, part.side, "robot-side") {
                scope.changePart(number, null) { old -> (old as BumperPart).copy(side = it) }
            }
        }

        is SensorPart -> SensorFields(scope, number, part)

        is RotationPart -> {
            ChipRow(RobotTexts.wheel(spoken), sideWords(), part.wheel, "robot-wheel") {
                scope.changePart(number, null) { old -> (old as RotationPart).copy(wheel = it) }
            }
        }

        else -> {
            // Nothing more to set.
        }
    }
}

/** Ports that something else is on say so, also the chosen one: on an RCX two things may share one. */
@Composable
private fun PortChips(scope: RobotScope, number: Int) {
    val ports = scope.robot.portsOf(number)
    val choices = listOf<Pair<Int?, String>>(null to RobotTexts.portNone(spoken)) +
        (1..scope.robot.brick.inputPorts).map { port ->
            val other = scope.robot.thingsOn(port).firstOrNull { it != number }?.let { scope.robot.things[it] }
            port to if (other == null) {
                "$port"
            } else {
                RobotTexts.portTaken(spoken, port, partWord(other)(spoken))
            }
        }
    ChipRow(RobotTexts.port(spoken), choices, ports.firstOrNull(), "robot-port") {
        scope.make(RobotEdit.SetPort(it))
    }
}

@Composable
private fun SensorFields(scope: RobotScope, number: Int, part: SensorPart) {
    val change = { what: String?, changed: (SensorPart) -> SensorPart ->
        scope.changePart(number, what) { old -> changed(old as SensorPart) }
    }
    if (part.sensor.seesSurfaces) {
        val words = listOfNotNull(
            Facing.Down to RobotTexts.looksDown(spoken),
            Facing.Ahead((part.facing as? Facing.Ahead)?.direction ?: 0.0) to
                RobotTexts.looksAhead(spoken),
            (Facing.Free to RobotTexts.looksFree(spoken)).takeIf {
                part.facing == Facing.Free ||
                    (part.sensor == SensorKind.LIGHT && BrickBuild.of(scope.robot.brick).hasShortForm)
            },
        )
        ChipRow(RobotTexts.looks(spoken), words, part.facing, "robot-looks") { facing ->
            val height = if (facing is Facing.Ahead) {
                maxOf(
                    part.height,
                    AHEAD_HEIGHT,
                )
            } else {
                minOf(part.height, DOWN_HEIGHT)
            }
            change(null) { it.copy(facing = facing, height = height) }
        }
    }
    (part.facing as? Facing.Ahead)?.let { Direction(scope, number, it.direction) }
    PlaceRows(scope, RobotElement.Part(number))
    Centimetres(scope, RobotTexts::eyeHeight, part.height, RobotLimits.SENSOR_HEIGHTS, "robot-eye-height") {
        change("height") { old -> old.copy(height = it) }
    }
    if (scope.robot.brick.hasMotorCounters || part.turret != null) {
        val motors = listOf<Pair<MotorPort?, String>>(null to RobotTexts.fixed(spoken)) +
            MotorPort.entries.map { it to it.name }
        ChipRow(RobotTexts.turret(spoken), motors, part.turret, "robot-turret") {
            change(null) { old -> old.copy(turret = it) }
        }
    }
}

@Composable
private fun Direction(scope: RobotScope, number: Int, direction: Double) = NumberRow(
    RobotTexts.direction(spoken),
    direction,
    -180.0..180.0,
    "robot-direction",
    { wanted ->
        scope.changePart(number, "direction") { old ->
            when (old) {
                is BumperPart -> old.copy(direction = wanted)
                is SensorPart -> old.copy(facing = Facing.Ahead(wanted))
                else -> old
            }
        }
    },
    scope::settle,
    step = RobotSnapping.DEGREES,
    unit = "°",
)

@Composable
private fun sideWords(): List<Pair<BumperSide, String>> = listOf(
    BumperSide.LEFT to RobotTexts.sideLeft(spoken),
    BumperSide.RIGHT to RobotTexts.sideRight(spoken),
)

/** In centimetres, where a sensor looks over the floor, and into it. */
private const val AHEAD_HEIGHT = 6.0
private const val DOWN_HEIGHT = 1.0
