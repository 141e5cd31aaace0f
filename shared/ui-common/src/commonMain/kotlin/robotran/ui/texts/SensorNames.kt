package robotran.ui.texts

import robotran.brick.sensors.SensorKind
import robotran.uikit.*

/** The name of a sensor. */
val SensorKind.words: Label
    get() = when (this) {
        SensorKind.TOUCH -> NxtTexts::bumper
        SensorKind.TEMPERATURE -> CommonTexts::sensorTemperature
        SensorKind.LIGHT -> CommonTexts::lightSensor
        SensorKind.ROTATION -> CommonTexts::sensorRotation
        SensorKind.ULTRASONIC -> NxtTexts::ultrasonicSensor
        SensorKind.SOUND -> NxtTexts::soundSensor
        SensorKind.COLOUR -> NxtTexts::colourSensor
        SensorKind.COMPASS -> NxtTexts::compass
        SensorKind.GYRO -> NxtTexts::gyro
        SensorKind.HITECHNIC_COLOUR -> NxtTexts::hitechnicColour
        SensorKind.MINDSENSORS_COMPASS -> NxtTexts::mindsensorsCompass
        SensorKind.HITECHNIC_ACCELERATION -> NxtTexts::hitechnicAcceleration
        SensorKind.MINDSENSORS_ACCELERATION -> NxtTexts::mindsensorsAcceleration
        SensorKind.RCX_LIGHT -> NxtTexts::rcxLight
        SensorKind.RCX_LINK -> NxtTexts::rcxLink
        SensorKind.NXT_TEMPERATURE -> NxtTexts::nxtTemperature
        SensorKind.INFRARED_SEEKER -> NxtTexts::infraredSeeker
        SensorKind.INFRARED_SEEKER_2 -> NxtTexts::infraredSeeker2
        SensorKind.OPTICAL_DISTANCE -> NxtTexts::opticalDistance
    }
