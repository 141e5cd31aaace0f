package robotran.ui.robot

import androidx.compose.runtime.Composable
import robotran.brick.sensors.SensorKind
import robotran.robotediting.RobotEditError
import robotran.robotediting.RobotEditing
import robotran.robotediting.RobotElement
import robotran.robotediting.RobotItem
import robotran.robotediting.elementOf
import robotran.robotediting.placeOf
import robotran.robotediting.portsOf
import robotran.ui.texts.RobotTexts
import robotran.uikit.*
import robotran.world.BumperPart
import robotran.world.Facing
import robotran.world.RobotDescription
import robotran.world.RobotPart
import robotran.world.SensorPart
import robotran.world.messages.sentence
import robotran.world.robot.things
import robotran.worldediting.written
import kotlin.math.abs

internal fun itemWord(item: RobotItem): Label = when (item) {
    RobotItem.BUMPER -> RobotTexts::itemBumper
    RobotItem.LIGHT -> RobotTexts::itemLight
    RobotItem.COLOUR -> RobotTexts::itemColour
    RobotItem.ULTRASONIC -> RobotTexts::itemUltrasonic
    RobotItem.SOUND -> RobotTexts::itemSound
    RobotItem.GYRO -> RobotTexts::itemGyro
    RobotItem.COMPASS -> RobotTexts::itemCompass
    RobotItem.ROTATION -> RobotTexts::itemRotation
    RobotItem.TEMPERATURE -> RobotTexts::itemTemperature
    RobotItem.HITECHNIC_COLOUR -> RobotTexts::itemHitechnicColour
    RobotItem.MINDSENSORS_COMPASS -> RobotTexts::itemMindsensorsCompass
    RobotItem.HITECHNIC_ACCELERATION -> RobotTexts::itemHitechnicAcceleration
    RobotItem.MINDSENSORS_ACCELERATION -> RobotTexts::itemMindsensorsAcceleration
    RobotItem.RCX_LIGHT -> RobotTexts::itemRcxLight
    RobotItem.RCX_LINK -> RobotTexts::itemRcxLink
    RobotItem.NXT_TEMPERATURE -> RobotTexts::itemNxtTemperature
    RobotItem.INFRARED_SEEKER -> RobotTexts::itemInfraredSeeker
    RobotItem.INFRARED_SEEKER_2 -> RobotTexts::itemInfraredSeeker2
    RobotItem.OPTICAL_DISTANCE -> RobotTexts::itemOpticalDistance
    RobotItem.FINGER_TOUCH -> RobotTexts::itemFingerTouch
    RobotItem.CASTER -> RobotTexts::caster
    RobotItem.PEN -> RobotTexts::pen
}

/** What a part is, without its port. */
internal fun partWord(part: RobotPart): Label = when (part.kind) {
    SensorKind.TOUCH -> if (part is BumperPart) RobotTexts::itemBumper else RobotTexts::itemFingerTouch
    SensorKind.LIGHT -> RobotTexts::itemLight
    SensorKind.COLOUR -> RobotTexts::itemColour
    SensorKind.ULTRASONIC -> RobotTexts::itemUltrasonic
    SensorKind.SOUND -> RobotTexts::itemSound
    SensorKind.GYRO -> RobotTexts::itemGyro
    SensorKind.COMPASS -> RobotTexts::itemCompass
    SensorKind.ROTATION -> RobotTexts::itemRotation
    SensorKind.TEMPERATURE -> RobotTexts::itemTemperature
    SensorKind.HITECHNIC_COLOUR -> RobotTexts::itemHitechnicColour
    SensorKind.MINDSENSORS_COMPASS -> RobotTexts::itemMindsensorsCompass
    SensorKind.HITECHNIC_ACCELERATION -> RobotTexts::itemHitechnicAcceleration
    SensorKind.MINDSENSORS_ACCELERATION -> RobotTexts::itemMindsensorsAcceleration
    SensorKind.RCX_LIGHT -> RobotTexts::itemRcxLight
    SensorKind.RCX_LINK -> RobotTexts::itemRcxLink
    SensorKind.NXT_TEMPERATURE -> RobotTexts::itemNxtTemperature
    SensorKind.INFRARED_SEEKER -> RobotTexts::itemInfraredSeeker
    SensorKind.INFRARED_SEEKER_2 -> RobotTexts::itemInfraredSeeker2
    SensorKind.OPTICAL_DISTANCE -> RobotTexts::itemOpticalDistance
}

/** An element, with its port. */
@Composable
internal fun robotElementText(robot: RobotDescription, element: RobotElement): String = when (element) {
    is RobotElement.Part -> robot.things.getOrNull(element.number)?.let { part ->
        val ports = robot.portsOf(element.number)
        val name = partWord(part)(spoken)
        if (ports.isEmpty()) {
            RobotTexts.unplugged(spoken, name)
        } else {
            RobotTexts.onPort(spoken, name, ports.joinToString())
        }
    }.orEmpty()

    is RobotElement.Caster -> RobotTexts.casterNumbered(spoken, element.number + 1)
    is RobotElement.Corner -> RobotTexts.cornerNumbered(spoken, element.number + 1)
    RobotElement.Wheels -> RobotTexts.wheels(spoken)
    RobotElement.Pen -> RobotTexts.pen(spoken)
    RobotElement.Brick -> RobotTexts.brick(spoken)
    RobotElement.Mass -> RobotTexts.mass(spoken)
    RobotElement.Chassis -> RobotTexts.chassis(spoken)
}

/** What is chosen, where it is, and what is wrong with it: what a screen reader says after each change. */
@Composable
internal fun chosenText(editing: RobotEditing): String {
    val element = editing.chosen ?: return RobotTexts.noneChosen(spoken)
    val language = LocalLanguage.current
    val place = editing.robot.placeOf(element)
    val errors = editing.errors.filter { editing.robot.elementOf(it) == element }.map { it.sentence(language) }
    val words = listOfNotNull(
        RobotTexts.chosen(spoken, robotElementText(editing.robot, element)),
        place?.let { RobotTexts.place(spoken, written(it.x), written(it.y)) },
        ((element as? RobotElement.Part)?.let { editing.robot.things.getOrNull(it.number) } as? SensorPart)
            ?.let { directionText(it) },
    )
    return (words + errors).joinToString(" ")
}

/** Where [part] looks; null if that depends on the program. */
@Composable
private fun directionText(part: SensorPart): String? = when (val facing = part.facing) {
    Facing.Free -> null
    Facing.Down -> RobotTexts.looksAtFloor(spoken)

    is Facing.Ahead -> when {
        facing.direction == 0.0 -> RobotTexts.looksStraight(spoken)
        abs(facing.direction) == BACK -> RobotTexts.looksBack(spoken)
        facing.direction > 0 -> RobotTexts.looksAt(spoken, written(facing.direction))
        else -> RobotTexts.looksAtRight(spoken, written(-facing.direction))
    }
}

private const val BACK = 180.0

internal fun robotEditErrorText(error: RobotEditError): Label = when (error) {
    RobotEditError.TOO_MANY_PARTS -> RobotTexts::refusalParts
    RobotEditError.TOO_MANY_CASTERS -> RobotTexts::refusalCasters
    RobotEditError.TOO_MANY_CORNERS -> RobotTexts::refusalCorners
    RobotEditError.TOO_FEW_CORNERS -> RobotTexts::refusalFewCorners
    RobotEditError.SAME_THING -> RobotTexts::refusalSame
    RobotEditError.NEEDED -> RobotTexts::refusalNeeded
}
