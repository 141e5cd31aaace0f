package robotran.learning

import robotran.brick.sensors.SensorKind
import robotran.language.Language
import robotran.world.RobotDescription

/** The words in [language] by which somebody looks for a robot: its brick and what people call its sensors. */
internal fun robotWords(robot: RobotDescription, language: Language): String {
    val sensors = robot.parts.filter { it.port != null }.map { it.kind }.distinct()
    return (listOf(robot.brick.label) + sensors.mapNotNull { SENSOR_WORDS[it]?.getValue(language) }).joinToString(" ")
}

private val SENSOR_WORDS: Map<SensorKind, Map<Language, String>> = mapOf(
    SensorKind.TOUCH to words(
        "touch sensor bumper",
        "Berührungssensor Tastsensor Stoßfühler",
        "sensor de contacto parachoques",
    ),
    SensorKind.LIGHT to words("light sensor", "Lichtsensor", "sensor de luz"),
    SensorKind.ROTATION to words("rotation sensor", "Drehsensor Rotationssensor", "sensor de rotación giro"),
    SensorKind.ULTRASONIC to words(
        "ultrasonic sensor ultrasound sonar radar distance",
        "Ultraschallsensor Sonar Radar Abstand Entfernung Abstandssensor",
        "sensor de ultrasonidos sonar radar distancia",
    ),
    SensorKind.SOUND to words(
        "sound sensor microphone loudness noise",
        "Geräuschsensor Schallsensor Mikrofon Lautstärke",
        "sensor de sonido micrófono ruido volumen",
    ),
    SensorKind.COLOUR to words("colour sensor color sensor", "Farbsensor Farbe", "sensor de color"),
    SensorKind.COMPASS to words("compass", "Kompass", "brújula"),
    SensorKind.GYRO to words("gyro sensor", "Gyrosensor Kreisel", "giroscopio"),
    SensorKind.TEMPERATURE to words("temperature", "Temperatur", "temperatura"),
    SensorKind.HITECHNIC_COLOUR to words(
        "HiTechnic colour sensor color sensor",
        "Farbsensor Farbe HiTechnic",
        "sensor de color HiTechnic",
    ),
    SensorKind.MINDSENSORS_COMPASS to words("mindsensors compass", "Kompass mindsensors", "brújula mindsensors"),
    SensorKind.HITECHNIC_ACCELERATION to words(
        "HiTechnic acceleration sensor accelerometer",
        "Beschleunigungssensor HiTechnic",
        "acelerómetro aceleración HiTechnic",
    ),
    SensorKind.MINDSENSORS_ACCELERATION to words(
        "mindsensors acceleration sensor accelerometer tilt",
        "Beschleunigungssensor Neigungssensor mindsensors",
        "acelerómetro aceleración mindsensors",
    ),
    SensorKind.RCX_LIGHT to words("RCX light sensor", "Lichtsensor RCX", "sensor de luz RCX"),
    SensorKind.RCX_LINK to words(
        "RCX link infrared message",
        "RCX-Sender Infrarot Nachricht",
        "enlace RCX infrarrojos mensaje",
    ),
    SensorKind.NXT_TEMPERATURE to words("temperature", "Temperatur", "temperatura"),
    SensorKind.INFRARED_SEEKER to words("infrared seeker", "Infrarotsucher", "buscador de infrarrojos"),
    SensorKind.INFRARED_SEEKER_2 to words("infrared seeker", "Infrarotsucher", "buscador de infrarrojos"),
    SensorKind.OPTICAL_DISTANCE to words(
        "optical distance sensor infrared",
        "Abstandssensor Infrarot Entfernung",
        "sensor de distancia infrarrojos",
    ),
)

private fun words(english: String, german: String, spanish: String) =
    mapOf(Language.ENGLISH to english, Language.GERMAN to german, Language.SPANISH to spanish)
