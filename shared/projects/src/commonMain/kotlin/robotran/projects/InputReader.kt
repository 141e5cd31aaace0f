package robotran.projects

import robotran.json.JsonCursor
import robotran.json.messages.JsonMessages
import robotran.projects.messages.told
import robotran.simulation.RecordedInput
import robotran.simulation.SessionInput
import robotran.world.World
import robotran.world.geometry.Point
import robotran.world.geometry.Pose

/** Reads the recorded inputs of a session in [world]. */
internal class InputReader(private val world: World) {
    fun read(place: JsonCursor): List<RecordedInput> {
        val places = place.items(0..ProjectLimits.MAXIMUM_INPUTS)
        val inputs = places.map {
            RecordedInput(it.member("at").longNumber(0..ProjectLimits.MAXIMUM_MILLISECONDS), inputIn(it))
        }
        inputs.indices.drop(1).firstOrNull { inputs[it].milliseconds < inputs[it - 1].milliseconds }?.let {
            places[it].member("at").refuse(told { beforeInputAbove() })
        }
        return inputs
    }

    private fun inputIn(place: JsonCursor): SessionInput {
        // An input is a record of the past, so it must not have extra fields.
        val kind = place.member("kind").textOrNull()
        val fields =
            InputKind.FIELDS[kind]
                ?: place.member("kind").refuse { JsonMessages.of(it).mustBeOneOf(InputKind.FIELDS.keys) }
        (place.names - fields - InputKind.COMMON).firstOrNull()?.let { field ->
            place.refuse(told { mustNotHave(field) })
        }
        return when (kind) {
            InputKind.PRESS -> SessionInput.Press(place.member("button").choice(BUTTONS), robot(place))
            InputKind.RELEASE -> SessionInput.Release(place.member("button").choice(BUTTONS), robot(place))
            InputKind.STOP -> SessionInput.Stop
            InputKind.PLACE_ROBOT -> SessionInput.PlaceRobot(robot(place), pose(place))
            InputKind.PLACE_BLOCK -> SessionInput.PlaceBlock(block(place), pose(place))
            InputKind.MOVE_LAMP -> SessionInput.MoveLamp(lamp(place), Point(number(place, "x"), number(place, "y")))
            InputKind.SWITCH_LAMP -> SessionInput.SwitchLamp(lamp(place), place.member("on").flag())
            InputKind.LIGHT -> SessionInput.ChangeAmbientLight(number(place, "light"))
            InputKind.TEMPERATURE -> SessionInput.ChangeTemperature(number(place, "celsius"))
            else -> SessionInput.TouchSensor(robot(place), port(place), place.member("pressed").flag())
        }
    }

    private fun robot(place: JsonCursor): Int {
        val name = place.optional("robot") ?: return 0
        val number = world.robots.indexOfFirst { it.name == name.textOrNull() }
        if (number < 0) name.refuse(told { mustNameRobotOfWorld() })
        return number
    }

    private fun lamp(place: JsonCursor): Int {
        val lamp = place.member("lamp")
        if (world.lamps.isEmpty()) lamp.refuse(told { noLamp() })
        return lamp.wholeNumber(1..world.lamps.size) - 1
    }

    private fun block(place: JsonCursor): Int {
        val block = place.member("block")
        if (world.blocks.isEmpty()) block.refuse(told { noBlock() })
        return block.wholeNumber(1..world.blocks.size) - 1
    }

    private fun pose(place: JsonCursor) = Pose(number(place, "x"), number(place, "y"), number(place, "heading"))

    private fun port(place: JsonCursor): Int {
        val brick = world.robots[robot(place)].description.brick
        return place.member("port").wholeNumber(1..brick.inputPorts) - 1
    }

    private fun number(place: JsonCursor, name: String): Double =
        place.member(name).number(-ProjectLimits.MAXIMUM_INPUT_NUMBER..ProjectLimits.MAXIMUM_INPUT_NUMBER)
}
