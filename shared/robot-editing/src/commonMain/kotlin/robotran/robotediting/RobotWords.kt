package robotran.robotediting

import robotran.brick.sensors.SensorKind
import robotran.editing.RobotTexts
import robotran.editing.Words
import robotran.world.BumperPart
import robotran.world.RobotDescription
import robotran.world.RobotPart
import robotran.world.robot.things

/** What a part is, without its port. */
fun partWord(part: RobotPart): Words = when (part.kind) {
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

/** What an element is, with its port. */
fun robotElementWords(robot: RobotDescription, element: RobotElement): Words = { language ->
    when (element) {
        is RobotElement.Part -> robot.things.getOrNull(element.number)?.let { part ->
            val ports = robot.portsOf(element.number)
            val name = partWord(part)(language)
            if (ports.isEmpty()) {
                RobotTexts.unplugged(language, name)
            } else {
                RobotTexts.onPort(language, name, ports.joinToString())
            }
        }.orEmpty()

        is RobotElement.Caster -> RobotTexts.casterNumbered(language, element.number + 1)
        is RobotElement.Corner -> RobotTexts.cornerNumbered(language, element.number + 1)
        RobotElement.Wheels -> RobotTexts.wheels(language)
        RobotElement.Pen -> RobotTexts.pen(language)
        RobotElement.Brick -> RobotTexts.brick(language)
        RobotElement.Mass -> RobotTexts.mass(language)
        RobotElement.Chassis -> RobotTexts.chassis(language)
    }
}
