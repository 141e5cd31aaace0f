package robotran.ui.worldedit

import androidx.compose.foundation.layout.fillMaxWidth
import androidx.compose.foundation.layout.padding
import androidx.compose.runtime.Composable
import androidx.compose.ui.Modifier
import androidx.compose.ui.unit.dp
import robotran.ui.brick.nxt.words
import robotran.ui.parts.readyRobotName
import robotran.ui.sheet.RobotColours
import robotran.ui.texts.NxtTexts
import robotran.ui.texts.RobotTexts
import robotran.ui.texts.ScreenTexts
import robotran.ui.texts.WorldEditorTexts
import robotran.uikit.*
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
import robotran.worldediting.Element
import robotran.worldediting.ElementRef
import robotran.worldediting.WorldEditError

/** All properties of a robot. */
@Composable
internal fun RobotFields(editor: EditorScope, ref: ElementRef, piece: Element.OfRobot) {
    val robot = piece.robot
    val atOnce = { changed: RobotPlacement -> editor.changeAtOnce(ref, Element.OfRobot(changed)) }
    if (ref.number == 0) HelpText(WorldEditorTexts.ownRobot(spoken))
    WordButton(
        RobotTexts.build(spoken),
        "build-robot",
        { editor.build(ref.number) },
        Modifier.fillMaxWidth().padding(top = 8.dp),
    )
    NameField(editor, ref, piece)
    val swatches = RobotColour.entries.map { Swatch(it, RobotColours.brick(it), colourWord(it)(spoken)) }
    Swatches(WorldEditorTexts.colour(spoken), swatches, robot.colour, "robot-colour") {
        atOnce(robot.copy(colour = it))
    }
    FormFields(editor, ref, piece)
    val kinds = ReadyRobots.all.map { (name, ready) -> ready to readyRobotName(name) }
    ChipRow(NxtTexts.worldeditRobotKind(spoken), kinds, readyOf(robot.description), "robot-kind") { ready ->
        // Its ports are kept if the pupil touches what it already is.
        if (ready != null && ready != readyOf(robot.description)) atOnce(robot.copy(description = ready, draft = null))
    }
    robot.draft?.let { draft ->
        for (error in robotErrors(draft).take(1)) {
            Wrong(RobotTexts.impossible(spoken, draft.title, error.sentence(LocalLanguage.current)))
        }
    }
    if (BrickBuild.of(robot.description.brick).hasShortForm) {
        ShortForm(robot, atOnce)
    } else {
        Parts(robot.description)
    }
    NumberRow(
        WorldEditorTexts.beacon(spoken),
        robot.beacon,
        0.0..WorldLimits.MAXIMUM_BRIGHTNESS,
        "field-beacon",
        { editor.change(ref, Element.OfRobot(robot.copy(beacon = it))) },
        editor::settle,
        step = 0.5,
        slider = 0f..5f,
    )
    ProgramFields(editor, ref, robot)
}

/** The direction of light sensors, and what is on the ports. */
@Composable
private fun ShortForm(robot: RobotPlacement, atOnce: (RobotPlacement) -> Unit) {
    val facings = listOf(
        null to WorldEditorTexts.facingFree(spoken),
        LightFacing.DOWN to WorldEditorTexts.facingDown(spoken),
        LightFacing.FORWARD to WorldEditorTexts.facingForward(spoken),
    )
    ChipRow(WorldEditorTexts.facing(spoken), facings, robot.lightFacing, "facing") {
        atOnce(robot.copy(lightFacing = it))
    }
    PortFields(robot) { atOnce(robot.withPorts(it)) }
}

/** What is on the ports, which a program has to name. */
@Composable
private fun Parts(description: RobotDescription) {
    RowHeading(WorldEditorTexts.ports(spoken))
    for (port in 1..description.brick.inputPorts) {
        val word = description.parts.firstOrNull { it.port == port }?.kind?.words ?: WorldEditorTexts::nothing
        HelpText(ScreenTexts.sensor(spoken, port, word(spoken)))
    }
}

/** The ready robot that [description] is, with whatever is on its ports; null for one that was built. */
private fun readyOf(description: RobotDescription): RobotDescription? = ReadyRobots.all[description.base]?.takeIf {
    it == description || it.withPlugged(description.pluggedSensors) == description
}

/** Two sensors can share a port. */
@Composable
private fun PortFields(robot: RobotPlacement, onChange: (List<List<PortSensor>>) -> Unit) {
    RowHeading(WorldEditorTexts.ports(spoken))
    val choices: List<Pair<PortSensor?, String>> =
        listOf<Pair<PortSensor?, String>>(null to WorldEditorTexts.nothing(spoken)) +
            PortSensor.entries.map { it to sensorWord(it)(spoken) }
    robot.ports.forEachIndexed { port, sensors ->
        for (place in 0..minOf(sensors.size, WorldLimits.MAXIMUM_SENSORS_PER_PORT - 1)) {
            val sensor = sensors.getOrNull(place)
            val title = if (place == 0) {
                WorldEditorTexts.port(spoken, port + 1)
            } else {
                WorldEditorTexts.portSecond(spoken, port + 1)
            }
            val free = choices.filter { (other, _) -> other == null || other == sensor || other !in sensors }
            MenuRow(title, free, choices.first { it.first == sensor }.second, "port-${port + 1}-$place") { wanted ->
                val changed = if (place < sensors.size) {
                    sensors.mapIndexed { at, old -> if (at == place) wanted else old }
                } else {
                    sensors + wanted
                }
                onChange(robot.ports.mapIndexed { at, old -> if (at == port) changed.filterNotNull() else old })
            }
        }
    }
}

@Composable
private fun ProgramFields(editor: EditorScope, ref: ElementRef, robot: RobotPlacement) {
    SwitchRow(WorldEditorTexts.ownProgram(spoken), robot.program != null, "field-has-program") { wanted ->
        editor.changeAtOnce(ref, Element.OfRobot(robot.copy(program = if (wanted) FIRST_PROGRAM else null)))
    }
    val program = robot.program ?: return
    val error = (editor.editing.error as? WorldEditError.InvalidText)?.let { editErrorText(it) }
    TextRow(
        WorldEditorTexts.program(spoken),
        program,
        WorldLimits.MAXIMUM_PROGRAM_LINES * WorldLimits.MAXIMUM_PROGRAM_LINE_CHARACTERS,
        "field-program",
        { editor.change(ref, Element.OfRobot(robot.copy(program = it))) },
        editor::settle,
        tall = true,
        error = error,
    )
}

private fun sensorWord(sensor: PortSensor): Label = when (sensor) {
    PortSensor.LEFT_BUMPER -> WorldEditorTexts::sensorLeftBumper
    PortSensor.RIGHT_BUMPER -> WorldEditorTexts::sensorRightBumper
    PortSensor.TOUCH -> WorldEditorTexts::sensorTouch
    PortSensor.LIGHT -> WorldEditorTexts::sensorLight
    PortSensor.LEFT_ROTATION -> WorldEditorTexts::sensorLeftRotation
    PortSensor.RIGHT_ROTATION -> WorldEditorTexts::sensorRightRotation
    PortSensor.TEMPERATURE -> WorldEditorTexts::sensorTemperature
}

/** A program with a visible effect. */
private const val FIRST_PROGRAM = "repeat forever\n  forward 10\n  turn left 90\nend"
