package robotran.projects

import robotran.json.JsonCursor
import robotran.json.messages.JsonMessages
import robotran.projects.messages.reason
import robotran.simulation.RecordedInput
import robotran.simulation.SessionInput
import robotran.world.World
import robotran.world.geometry.Point
import robotran.world.geometry.Pose

/** Reads the recorded inputs of a session in [world]. */
internal class InputReader(private val world: World) {
    fun read(cursor: JsonCursor): List<RecordedInput> {
        val places = cursor.items(0..ProjectLimits.MAXIMUM_INPUTS)
        val inputs = places.map {
            RecordedInput(it.member("at").longNumber(0..ProjectLimits.MAXIMUM_MILLISECONDS), inputIn(it))
        }
        inputs.indices.drop(1).firstOrNull { inputs[it].milliseconds < inputs[it - 1].milliseconds }?.let {
            places[it].member("at").refuse(reason { beforeInputAbove() })
        }
        return inputs
    }

    private fun inputIn(cursor: JsonCursor): SessionInput {
        // An input is a record of the past, so it must not have extra fields.
        val kind = cursor.member("kind").textOrNull()
        val fields =
            InputKind.FIELDS[kind]
                ?: cursor.member("kind").refuse { JsonMessages.of(it).mustBeOneOf(InputKind.FIELDS.keys) }
        (cursor.names - fields - InputKind.COMMON).firstOrNull()?.let { field ->
            cursor.refuse(reason { mustNotHave(field) })
        }
        return when (kind) {
            InputKind.PRESS -> SessionInput.Press(cursor.member("button").choice(BUTTONS), robot(cursor))
            InputKind.RELEASE -> SessionInput.Release(cursor.member("button").choice(BUTTONS), robot(cursor))
            InputKind.STOP -> SessionInput.Stop
            InputKind.PLACE_ROBOT -> SessionInput.PlaceRobot(robot(cursor), pose(cursor))
            InputKind.PLACE_BLOCK -> SessionInput.PlaceBlock(block(cursor), pose(cursor))
            InputKind.MOVE_LAMP -> SessionInput.MoveLamp(lamp(cursor), Point(number(cursor, "x"), number(cursor, "y")))
            InputKind.SWITCH_LAMP -> SessionInput.SwitchLamp(lamp(cursor), cursor.member("on").flag())
            InputKind.LIGHT -> SessionInput.ChangeAmbientLight(number(cursor, "light"))
            InputKind.TEMPERATURE -> SessionInput.ChangeTemperature(number(cursor, "celsius"))
            else -> SessionInput.TouchSensor(robot(cursor), port(cursor), cursor.member("pressed").flag())
        }
    }

    private fun robot(cursor: JsonCursor): Int {
        val name = cursor.optional("robot") ?: return 0
        val number = world.robots.indexOfFirst { it.name == name.textOrNull() }
        if (number < 0) name.refuse(reason { mustNameRobotOfWorld() })
        return number
    }

    private fun lamp(cursor: JsonCursor): Int {
        val lamp = cursor.member("lamp")
        if (world.lamps.isEmpty()) lamp.refuse(reason { noLamp() })
        return lamp.wholeNumber(1..world.lamps.size) - 1
    }

    private fun block(cursor: JsonCursor): Int {
        val block = cursor.member("block")
        if (world.blocks.isEmpty()) block.refuse(reason { noBlock() })
        return block.wholeNumber(1..world.blocks.size) - 1
    }

    private fun pose(cursor: JsonCursor) = Pose(number(cursor, "x"), number(cursor, "y"), number(cursor, "heading"))

    private fun port(cursor: JsonCursor): Int {
        val brick = world.robots[robot(cursor)].description.brick
        return cursor.member("port").wholeNumber(1..brick.inputPorts) - 1
    }

    private fun number(cursor: JsonCursor, name: String): Double =
        cursor.member(name).number(-ProjectLimits.MAXIMUM_INPUT_NUMBER..ProjectLimits.MAXIMUM_INPUT_NUMBER)
}
