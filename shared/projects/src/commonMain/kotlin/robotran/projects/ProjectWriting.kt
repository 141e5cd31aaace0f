package robotran.projects

import kotlinx.serialization.json.JsonArray
import kotlinx.serialization.json.JsonObject
import kotlinx.serialization.json.JsonPrimitive
import robotran.brick.controls.BrickButton
import robotran.json.decimal
import robotran.json.jsonObject
import robotran.language.Language
import robotran.languagesupport.SourceFile
import robotran.programs.JavaSettings
import robotran.programs.support
import robotran.simulation.RecordedInput
import robotran.simulation.SessionInput
import robotran.world.World
import robotran.world.file.elementOf
import robotran.world.file.wordFor
import robotran.world.geometry.Pose

internal fun elementOf(project: Project): JsonObject = jsonObject(project.unknown.members) {
    text("format", PROJECT_FORMAT)
    number("version", PROJECT_VERSION)
    list("robots", project.robots, ::elementOf)
    put("settings", elementOf(project.settings).takeIf { it.isNotEmpty() })
    list("inputs", possibleInputs(project.inputs, project.world)) { elementOf(it, project.world) }
    put("handIn", project.handIn?.let(::elementOf))
    put("feedback", project.feedback?.let(::elementOf))
    put("tries", project.tries?.let { elementOf(it, project.world) })
    put("assignment", project.assignment?.let(::elementOf))
    put(WORLD, elementOf(project.world))
}

/** [project] without a world that is known to be that of its assignment. */
internal fun handInElementOf(project: Project): JsonObject {
    val whole = elementOf(project)
    return if (project.assignment?.mayChangeWorld == false) JsonObject(whole - WORLD) else whole
}

/** An input for a missing object does nothing, and a file cannot name the object. */
internal fun possibleInputs(inputs: List<RecordedInput>, world: World): List<RecordedInput> =
    inputs.repeatable().filter { isPossible(it.input, world) }

private fun elementOf(robot: ProjectRobot) = jsonObject(robot.unknown.members) {
    text("name", robot.name)
    list("programs", robot.programs, ::elementOf)
    number("firstProgram", robot.firstProgram + 1, default = 1)
    text("lightSensor", robot.lightFacing?.let(::wordFor))
    list("flash", robot.files, ::elementOf)
}

internal fun elementOf(program: ProjectProgram): JsonObject = jsonObject(program.unknown.members) {
    text("name", program.name)
    text("language", wordFor(program.language))
    text("view", program.view?.let(::wordFor))
    text(WORDS, wordsOf(program)?.tag)
    if (program.language.mayHaveFiles) {
        list("files", program.files, ::elementOf)
    } else {
        put(TEXT, linesOf(program.files.single().text))
    }
}

/** The language whose words the program has; null for English, which all languages of programs have. */
private fun wordsOf(program: ProjectProgram): Language? =
    program.language.support.wordsOf(program.files.first().text).takeIf { it != Language.ENGLISH }

private fun elementOf(file: SourceFile) = jsonObject {
    text("name", file.name)
    put(TEXT, linesOf(file.text))
}

/** Splits at line feeds; a carriage return stays with its line. */
internal fun linesOf(text: String) = JsonArray(text.split('\n').map(::JsonPrimitive))

private fun elementOf(settings: ProjectSettings) = jsonObject(settings.unknown.members) {
    number("seed", settings.seed)
    put("realism", settings.realism?.let(::decimal))
    put("java", elementOf(settings.java).takeIf { it.isNotEmpty() })
}

private fun elementOf(java: JavaSettings) = jsonObject {
    text("mode", wordFor(java.mode), default = wordFor(JavaSettings().mode))
    text("speed", wordFor(java.speed), default = wordFor(JavaSettings().speed))
}

/**
 * The inputs that a file can hold: those before the first program that was sent to run at once. What followed cannot be
 * repeated without it.
 */
fun List<RecordedInput>.repeatable(): List<RecordedInput> = takeWhile { it.input !is SessionInput.RunSnippet }

private fun isPossible(input: SessionInput, world: World): Boolean = when (input) {
    is SessionInput.Press -> input.robot in world.robots.indices
    is SessionInput.Release -> input.robot in world.robots.indices
    is SessionInput.PlaceRobot -> input.robot in world.robots.indices
    is SessionInput.TouchSensor -> input.port in 0..<inputPortsOf(input.robot, world)
    is SessionInput.PlaceBlock -> input.block in world.blocks.indices
    is SessionInput.MoveLamp -> input.lamp in world.lamps.indices
    is SessionInput.SwitchLamp -> input.lamp in world.lamps.indices
    is SessionInput.RunSnippet -> false
    is SessionInput.Stop, is SessionInput.ChangeAmbientLight, is SessionInput.ChangeTemperature -> true
}

/** The number of input ports of the robot with this number; 0 if there is none. */
private fun inputPortsOf(robot: Int, world: World): Int =
    world.robots.getOrNull(robot)?.description?.brick?.inputPorts ?: 0

/** An input that is [repeatable], as JSON; [world] must contain its object. */
fun elementOf(recorded: RecordedInput, world: World): JsonObject = jsonObject {
    fun robot(number: Int) = text("robot", world.robots[number].name, default = world.robots.first().name)

    fun pose(pose: Pose) {
        number("x", pose.x)
        number("y", pose.y)
        number("heading", pose.heading)
    }

    fun button(button: BrickButton) = text("button", BUTTONS.entries.single { it.value == button }.key)

    number("at", recorded.milliseconds)
    when (val input = recorded.input) {
        is SessionInput.Press -> {
            text("kind", InputKind.PRESS)
            button(input.button)
            robot(input.robot)
        }

        is SessionInput.Release -> {
            text("kind", InputKind.RELEASE)
            button(input.button)
            robot(input.robot)
        }

        is SessionInput.Stop -> text("kind", InputKind.STOP)
        is SessionInput.RunSnippet -> error("A file has no programs that were sent to run at once.")

        is SessionInput.PlaceRobot -> {
            text("kind", InputKind.PLACE_ROBOT)
            robot(input.robot)
            pose(input.pose)
        }

        is SessionInput.PlaceBlock -> {
            text("kind", InputKind.PLACE_BLOCK)
            number("block", input.block + 1)
            pose(input.pose)
        }

        is SessionInput.MoveLamp -> {
            text("kind", InputKind.MOVE_LAMP)
            number("lamp", input.lamp + 1)
            number("x", input.place.x)
            number("y", input.place.y)
        }

        is SessionInput.SwitchLamp -> {
            text("kind", InputKind.SWITCH_LAMP)
            number("lamp", input.lamp + 1)
            flag("on", input.on, default = null)
        }

        is SessionInput.ChangeAmbientLight -> {
            text("kind", InputKind.LIGHT)
            number("light", input.light)
        }

        is SessionInput.ChangeTemperature -> {
            text("kind", InputKind.TEMPERATURE)
            number("celsius", input.celsius)
        }

        is SessionInput.TouchSensor -> {
            text("kind", InputKind.TOUCH)
            robot(input.robot)
            number("port", input.port + 1)
            flag("pressed", input.pressed, default = null)
        }
    }
}

private const val WORLD = "world"
