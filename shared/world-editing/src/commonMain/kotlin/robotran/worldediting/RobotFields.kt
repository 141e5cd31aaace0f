package robotran.worldediting

import robotran.brick.sensors.SensorKind
import robotran.editing.Field
import robotran.editing.NumberSpec
import robotran.editing.Option
import robotran.editing.READY_ROBOT_WORDS
import robotran.editing.RobotTexts
import robotran.editing.TextKind
import robotran.editing.TextSpec
import robotran.editing.Words
import robotran.editing.WorldEditorTexts
import robotran.editing.chips
import robotran.editing.making
import robotran.editing.menu
import robotran.editing.swatches
import robotran.language.Language
import robotran.world.LightFacing
import robotran.world.PortSensor
import robotran.world.ReadyRobots
import robotran.world.RobotColour
import robotran.world.RobotDescription
import robotran.world.RobotPlacement
import robotran.world.WorldLimits
import robotran.world.messages.sentence
import robotran.world.pluggedSensors
import robotran.world.robot.BrickBuild
import robotran.world.robot.robotErrors
import robotran.world.withPlugged

/** The fields of a robot; [pluggedWords] says what is on a port. */
internal fun WorldEditing.robotFields(
    ref: ElementRef,
    element: Element.OfRobot,
    pluggedWords: (String, SensorKind?) -> Words,
): List<Field<WorldEdit>> {
    val robot = element.robot
    val brick = robot.description.brick
    val change = { changed: RobotPlacement -> WorldEdit.Change(ref, Element.OfRobot(changed)) }
    val ports = if (BrickBuild.of(brick).hasShortForm) {
        shortForm(robot)
    } else {
        listOf(Field.Heading(WorldEditorTexts::ports)) + (1..brick.inputPorts).map { port ->
            val plugged = robot.description.parts.firstOrNull { it.port == port }
            Field.Help(pluggedWords(brick.inputLabel(port), plugged?.kind))
        }
    }
    return listOf(nameField(ref, element), colourField(robot).map(change)) + formFields(ref, element) +
        (listOfNotNull(kindField(robot), draftError(robot)) + ports + beaconField(robot)).making(change) +
        programFields(robot).making(change)
}

private fun colourField(robot: RobotPlacement): Field<RobotPlacement> {
    val colours = RobotColour.entries.map { Option(it, colourWord(it)) }
    return swatches("robot-colour", WorldEditorTexts::colour, colours, robot.colour) { robot.copy(colour = it) }
}

/** Ports are kept if the user touches what the robot already is. */
private fun kindField(robot: RobotPlacement): Field<RobotPlacement> {
    val kinds = ReadyRobots.all.map { (base, ready) ->
        Option<RobotDescription?>(ready, READY_ROBOT_WORDS.getValue(base))
    }
    val now = readyOf(robot.description)
    return chips("robot-kind", WorldEditorTexts::robotKind, kinds, now) { ready ->
        ready?.takeIf { it != now }?.let { robot.copy(description = it, draft = null) }
    }
}

/** The ready robot that [description] is, with whatever is on its ports; null for one that was built. */
private fun readyOf(description: RobotDescription): RobotDescription? = ReadyRobots.all[description.base]?.takeIf {
    it == description || it.withPlugged(description.pluggedSensors) == description
}

/** Why the robot that is being built does not drive. */
private fun draftError(robot: RobotPlacement): Field<RobotPlacement>? {
    val draft = robot.draft ?: return null
    val error = robotErrors(draft).firstOrNull() ?: return null
    return Field.Wrong { RobotTexts.impossible(it, draft.title, error.sentence(it)) }
}

/** The direction of light sensors, and what is on the ports. */
private fun shortForm(robot: RobotPlacement): List<Field<RobotPlacement>> = listOf(
    chips("facing", WorldEditorTexts::facing, FACINGS, robot.lightFacing) { robot.copy(lightFacing = it) },
    Field.Heading(WorldEditorTexts::ports),
) + robot.ports.indices.flatMap { port ->
    (0..minOf(robot.ports[port].size, WorldLimits.MAXIMUM_SENSORS_PER_PORT - 1)).map { portField(robot, port, it) }
}

/** Two sensors can share a port. */
private fun portField(robot: RobotPlacement, port: Int, place: Int): Field<RobotPlacement> {
    val sensors = robot.ports[port]
    val sensor = sensors.getOrNull(place)
    val title = { language: Language ->
        with(WorldEditorTexts) { if (place == 0) port(language, port + 1) else portSecond(language, port + 1) }
    }
    val free = SENSORS.filter { it.value == null || it.value == sensor || it.value !in sensors }
    return menu("port-${port + 1}-$place", title, free, sensor) { wanted ->
        val changed = if (place < sensors.size) {
            sensors.mapIndexed { at, old -> if (at == place) wanted else old }
        } else {
            sensors + wanted
        }
        robot.withPorts(robot.ports.mapIndexed { at, old -> if (at == port) changed.filterNotNull() else old })
    }
}

private fun beaconField(robot: RobotPlacement): Field<RobotPlacement> =
    Field.Number("field-beacon", WorldEditorTexts::beacon, robot.beacon, BEACON) { robot.copy(beacon = it) }

private fun WorldEditing.programFields(robot: RobotPlacement): List<Field<RobotPlacement>> = listOfNotNull(
    Field.Flag("field-has-program", WorldEditorTexts::ownProgram, robot.program != null) { wanted ->
        robot.copy(program = if (wanted) FIRST_PROGRAM else null)
    },
    robot.program?.let { program ->
        val isRefused = error is WorldEditError.InvalidText
        Field.Text("field-program", WorldEditorTexts::program, program, PROGRAM, isRefused = isRefused) {
            robot.copy(program = it)
        }
    },
)

private val FACINGS = listOf(
    Option(null, WorldEditorTexts::facingFree),
    Option(LightFacing.DOWN, WorldEditorTexts::facingDown),
    Option(LightFacing.FORWARD, WorldEditorTexts::facingForward),
)

private val SENSORS = listOf(
    Option(null, WorldEditorTexts::nothing),
    Option(PortSensor.LEFT_BUMPER, WorldEditorTexts::sensorLeftBumper),
    Option(PortSensor.RIGHT_BUMPER, WorldEditorTexts::sensorRightBumper),
    Option(PortSensor.TOUCH, WorldEditorTexts::sensorTouch),
    Option(PortSensor.LIGHT, WorldEditorTexts::sensorLight),
    Option(PortSensor.LEFT_ROTATION, WorldEditorTexts::sensorLeftRotation),
    Option(PortSensor.RIGHT_ROTATION, WorldEditorTexts::sensorRightRotation),
    Option(PortSensor.TEMPERATURE, WorldEditorTexts::sensorTemperature),
)
private val BEACON = NumberSpec(0.0..WorldLimits.MAXIMUM_BRIGHTNESS, step = 0.5, slider = 0.0..5.0)
private val PROGRAM = TextSpec(
    WorldLimits.MAXIMUM_PROGRAM_LINES * WorldLimits.MAXIMUM_PROGRAM_LINE_CHARACTERS,
    TextKind.PROGRAM,
)

/** A program with a visible effect. */
private const val FIRST_PROGRAM = "repeat forever\n  forward 10\n  turn left 90\nend"
