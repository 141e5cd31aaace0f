package robotran.ui.robot

import androidx.compose.runtime.Composable
import org.jetbrains.compose.resources.StringResource
import org.jetbrains.compose.resources.stringResource
import robotran.brick.sensors.SensorKind
import robotran.robotediting.RobotEditError
import robotran.robotediting.RobotEditing
import robotran.robotediting.RobotElement
import robotran.robotediting.RobotItem
import robotran.robotediting.elementOf
import robotran.robotediting.placeOf
import robotran.robotediting.portsOf
import robotran.ui.language.LocalLanguage
import robotran.ui.resources.*
import robotran.world.BumperPart
import robotran.world.Facing
import robotran.world.RobotDescription
import robotran.world.RobotPart
import robotran.world.SensorPart
import robotran.world.messages.sentence
import robotran.world.robot.things
import robotran.worldediting.written
import kotlin.math.abs

internal fun itemWord(item: RobotItem): StringResource = when (item) {
    RobotItem.BUMPER -> Res.string.robot_item_bumper
    RobotItem.LIGHT -> Res.string.robot_item_light
    RobotItem.COLOUR -> Res.string.robot_item_colour
    RobotItem.ULTRASONIC -> Res.string.robot_item_ultrasonic
    RobotItem.SOUND -> Res.string.robot_item_sound
    RobotItem.GYRO -> Res.string.robot_item_gyro
    RobotItem.COMPASS -> Res.string.robot_item_compass
    RobotItem.ROTATION -> Res.string.robot_item_rotation
    RobotItem.TEMPERATURE -> Res.string.robot_item_temperature
    RobotItem.HITECHNIC_COLOUR -> Res.string.robot_item_hitechnic_colour
    RobotItem.MINDSENSORS_COMPASS -> Res.string.robot_item_mindsensors_compass
    RobotItem.HITECHNIC_ACCELERATION -> Res.string.robot_item_hitechnic_acceleration
    RobotItem.MINDSENSORS_ACCELERATION -> Res.string.robot_item_mindsensors_acceleration
    RobotItem.RCX_LIGHT -> Res.string.robot_item_rcx_light
    RobotItem.RCX_LINK -> Res.string.robot_item_rcx_link
    RobotItem.NXT_TEMPERATURE -> Res.string.robot_item_nxt_temperature
    RobotItem.INFRARED_SEEKER -> Res.string.robot_item_infrared_seeker
    RobotItem.INFRARED_SEEKER_2 -> Res.string.robot_item_infrared_seeker_2
    RobotItem.OPTICAL_DISTANCE -> Res.string.robot_item_optical_distance
    RobotItem.FINGER_TOUCH -> Res.string.robot_item_finger_touch
    RobotItem.CASTER -> Res.string.robot_caster
    RobotItem.PEN -> Res.string.robot_pen
}

/** What a part is, without its port. */
internal fun partWord(part: RobotPart): StringResource = when (part.kind) {
    SensorKind.TOUCH -> if (part is BumperPart) Res.string.robot_item_bumper else Res.string.robot_item_finger_touch
    SensorKind.LIGHT -> Res.string.robot_item_light
    SensorKind.COLOUR -> Res.string.robot_item_colour
    SensorKind.ULTRASONIC -> Res.string.robot_item_ultrasonic
    SensorKind.SOUND -> Res.string.robot_item_sound
    SensorKind.GYRO -> Res.string.robot_item_gyro
    SensorKind.COMPASS -> Res.string.robot_item_compass
    SensorKind.ROTATION -> Res.string.robot_item_rotation
    SensorKind.TEMPERATURE -> Res.string.robot_item_temperature
    SensorKind.HITECHNIC_COLOUR -> Res.string.robot_item_hitechnic_colour
    SensorKind.MINDSENSORS_COMPASS -> Res.string.robot_item_mindsensors_compass
    SensorKind.HITECHNIC_ACCELERATION -> Res.string.robot_item_hitechnic_acceleration
    SensorKind.MINDSENSORS_ACCELERATION -> Res.string.robot_item_mindsensors_acceleration
    SensorKind.RCX_LIGHT -> Res.string.robot_item_rcx_light
    SensorKind.RCX_LINK -> Res.string.robot_item_rcx_link
    SensorKind.NXT_TEMPERATURE -> Res.string.robot_item_nxt_temperature
    SensorKind.INFRARED_SEEKER -> Res.string.robot_item_infrared_seeker
    SensorKind.INFRARED_SEEKER_2 -> Res.string.robot_item_infrared_seeker_2
    SensorKind.OPTICAL_DISTANCE -> Res.string.robot_item_optical_distance
}

/** An element, with its port. */
@Composable
internal fun robotElementText(robot: RobotDescription, element: RobotElement): String = when (element) {
    is RobotElement.Part -> robot.things.getOrNull(element.number)?.let { part ->
        val ports = robot.portsOf(element.number)
        val name = stringResource(partWord(part))
        if (ports.isEmpty()) {
            stringResource(Res.string.robot_unplugged, name)
        } else {
            stringResource(Res.string.robot_on_port, name, ports.joinToString())
        }
    }.orEmpty()

    is RobotElement.Caster -> stringResource(Res.string.robot_caster_numbered, element.number + 1)
    is RobotElement.Corner -> stringResource(Res.string.robot_corner_numbered, element.number + 1)
    RobotElement.Wheels -> stringResource(Res.string.robot_wheels)
    RobotElement.Pen -> stringResource(Res.string.robot_pen)
    RobotElement.Brick -> stringResource(Res.string.robot_brick)
    RobotElement.Mass -> stringResource(Res.string.robot_mass)
    RobotElement.Chassis -> stringResource(Res.string.robot_chassis)
}

/** What is chosen, where it is, and what is wrong with it: what a screen reader says after each change. */
@Composable
internal fun chosenText(editing: RobotEditing): String {
    val element = editing.chosen ?: return stringResource(Res.string.robot_none_chosen)
    val language = LocalLanguage.current
    val place = editing.robot.placeOf(element)
    val errors = editing.errors.filter { editing.robot.elementOf(it) == element }.map { it.sentence(language) }
    val words = listOfNotNull(
        stringResource(Res.string.robot_chosen, robotElementText(editing.robot, element)),
        place?.let { stringResource(Res.string.robot_place, written(it.x), written(it.y)) },
        ((element as? RobotElement.Part)?.let { editing.robot.things.getOrNull(it.number) } as? SensorPart)
            ?.let { directionText(it) },
    )
    return (words + errors).joinToString(" ")
}

/** Where [part] looks; null if that depends on the program. */
@Composable
private fun directionText(part: SensorPart): String? = when (val facing = part.facing) {
    Facing.Free -> null
    Facing.Down -> stringResource(Res.string.robot_looks_at_floor)

    is Facing.Ahead -> when {
        facing.direction == 0.0 -> stringResource(Res.string.robot_looks_straight)
        abs(facing.direction) == BACK -> stringResource(Res.string.robot_looks_back)
        facing.direction > 0 -> stringResource(Res.string.robot_looks_at, written(facing.direction))
        else -> stringResource(Res.string.robot_looks_at_right, written(-facing.direction))
    }
}

private const val BACK = 180.0

internal fun robotEditErrorText(error: RobotEditError): StringResource = when (error) {
    RobotEditError.TOO_MANY_PARTS -> Res.string.robot_refusal_parts
    RobotEditError.TOO_MANY_CASTERS -> Res.string.robot_refusal_casters
    RobotEditError.TOO_MANY_CORNERS -> Res.string.robot_refusal_corners
    RobotEditError.TOO_FEW_CORNERS -> Res.string.robot_refusal_few_corners
    RobotEditError.SAME_THING -> Res.string.robot_refusal_same
    RobotEditError.NEEDED -> Res.string.robot_refusal_needed
}
