package robotran.simulation.hub

import robotran.brick.sensors.SensorKind
import robotran.hub.model.HubDeviceKind
import robotran.world.BumperPart
import robotran.world.FingerTouchPart
import robotran.world.RobotDescription
import robotran.world.RobotPart
import robotran.world.SensorPart

/** What is on the ports for sensors of a robot with a hub, by their numbers from 1. */
val RobotDescription.hubSensors: Map<Int, HubDeviceKind>
    get() = parts.mapNotNull { part ->
        val kind = deviceOf(part)
        part.port?.let { port -> kind?.let { port to it } }
    }.toMap()

/** What a program takes [part] for; null if no hub can read it. */
internal fun RobotDescription.deviceOf(part: RobotPart): HubDeviceKind? = when (part) {
    is BumperPart, is FingerTouchPart -> {
        if (brick.hasLetteredInputs) HubDeviceKind.FORCE_SENSOR else HubDeviceKind.TOUCH_SENSOR
    }

    is SensorPart -> when (part.sensor) {
        SensorKind.COLOUR -> HubDeviceKind.COLOR_SENSOR
        SensorKind.LIGHT -> HubDeviceKind.LIGHT_SENSOR
        SensorKind.ULTRASONIC -> HubDeviceKind.ULTRASONIC_SENSOR
        SensorKind.SOUND -> HubDeviceKind.SOUND_SENSOR
        else -> null
    }

    else -> null
}
