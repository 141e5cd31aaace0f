package robotran.ui.robot

import androidx.compose.runtime.Composable
import robotran.editing.RobotTexts
import robotran.editing.written
import robotran.robotediting.RobotEditError
import robotran.robotediting.RobotEditing
import robotran.robotediting.RobotElement
import robotran.robotediting.RobotItem
import robotran.robotediting.elementOf
import robotran.robotediting.placeOf
import robotran.robotediting.robotElementWords
import robotran.uikit.*
import robotran.world.Facing
import robotran.world.RobotDescription
import robotran.world.SensorPart
import robotran.world.messages.sentence
import robotran.world.robot.things
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

/** An element, with its port. */
@Composable
internal fun robotElementText(robot: RobotDescription, element: RobotElement): String =
    robotElementWords(robot, element)(spoken)

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
