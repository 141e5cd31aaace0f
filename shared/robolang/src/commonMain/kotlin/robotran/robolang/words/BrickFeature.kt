package robotran.robolang.words

import robotran.brick.controls.BrickButton
import robotran.brick.kind.BrickKind
import robotran.brick.sensors.SensorKind

/** What not every brick has, but some words of the language need. */
internal enum class BrickFeature(val isOn: (BrickKind) -> Boolean) {
    MOTOR_COUNTERS({ it.hasMotorCounters }),
    SONAR({ SensorKind.ULTRASONIC in it.sensors }),
    COLOUR_SENSOR({ SensorKind.COLOUR in it.sensors }),
    SOUND_SENSOR({ SensorKind.SOUND in it.sensors + it.ownSensors }),
    BATTERY({ it.measuresBattery }),
    ENTER_BUTTON({ BrickButton.ENTER in it.buttons }),
    ESCAPE_BUTTON({ BrickButton.ESCAPE in it.buttons }),
}
