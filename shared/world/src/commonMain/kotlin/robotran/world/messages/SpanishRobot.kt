package robotran.world.messages

import robotran.brick.controls.MotorPort
import robotran.brick.kind.BrickKind
import robotran.brick.sensors.SensorKind
import robotran.json.messages.alternatives
import robotran.world.robot.RobotFigure

internal object SpanishRobotMessages : RobotMessages {
    override fun notARobot(format: String) =
        "Esto no es un robot de Robotran: un archivo de robot dice \"format\": \"$format\"."

    override fun newerRobot(version: Int, known: Int) =
        "Este robot se hizo con un Robotran más nuevo (tiene la versión $version, y este Robotran lee hasta la $known)."

    override fun noReadyRobot(name: String, known: List<String>) =
        "No hay ningún robot listo que se llame \"$name\", solo ${alternatives(known, "y")}."

    override fun robotAndPorts() =
        "Un robot tiene \"robot\" o \"ports\": lo que está conectado a un robot está en sus propias piezas."

    override fun outOfRange(figure: RobotFigure, lowest: String, highest: String) =
        "${subject(figure)} de ${comma(lowest)} a ${comma(highest)}${unitOf(figure, degrees = "grados")}."

    override fun portTaken(port: Int) = "Hay dos cosas conectadas al puerto $port."

    override fun noSuchPort(brick: BrickKind, port: Int) = "Un ${brick.name} no tiene puerto $port."

    override fun unreadable(brick: BrickKind, kind: SensorKind) =
        "Un ${brick.name} no puede leer ${if (kind in FEMININE) "una" else "un"} ${name(kind)}."

    override fun oneDriveMotor(motor: MotorPort) =
        "Para conducir hacen falta dos motores, pero el izquierdo y el derecho son los dos el motor ${motor.name}."

    override fun penMotorTaken(motor: MotorPort) =
        "El motor ${motor.name} mueve una rueda, así que no puede levantar el lápiz."

    override fun noWheels() = "Un robot necesita dos ruedas: dales un diámetro de 2 a 10 cm."

    override fun wheelsTooClose() =
        "Las ruedas están una dentro de otra: la distancia entre ellas tiene que ser mayor que el ancho de una."

    override fun tooFast() = "Con estos engranajes el robot va a más de 60 cm por segundo."

    override fun tipsOver(backwards: Boolean) = if (backwards) {
        "El robot se cae: su peso está detrás de las ruedas y allí no lo sujeta ninguna rueda loca."
    } else {
        "El robot se cae: su peso está delante de las ruedas y allí no lo sujeta ninguna rueda loca."
    }

    override fun casterOnAxle() = "Una rueda loca tiene que estar al menos 1 cm delante o detrás del eje."

    override fun outlineCrosses() = "El contorno se cruza o se toca a sí mismo."

    override fun outlineTooSmall() =
        "El contorno es demasiado pequeño: tiene que medir al menos 4 cm de largo y de ancho."

    override fun outlineTooLarge() =
        "El contorno es demasiado grande: puede medir como mucho 60 cm de largo y de ancho."

    override fun tooManyCorners() = "El contorno tiene demasiadas esquinas para tantos parachoques."

    override fun massOutside() = "El centro de masa está fuera del contorno."

    override fun massBesideMiddle() = "El centro de masa tiene que estar en la línea del medio, en y 0."

    override fun bumperInside() = "El parachoques está dentro del robot."

    override fun sensorInFloor(kind: SensorKind, lowest: String) =
        "${the(kind)} está dentro del suelo: ponlo al menos a ${comma(lowest)} cm de altura."

    override fun sensorTooHigh(kind: SensorKind, highest: String) =
        "${the(kind)} mira al suelo desde demasiado alto: como mucho ${comma(highest)} cm."

    override fun cannotLookDown(kind: SensorKind) =
        "${the(kind)} tiene que tener una dirección y no puede mirar hacia abajo."

    override fun looksIntoRobot(kind: SensorKind) = "${the(kind)} mira hacia dentro del propio robot."

    override fun farAway(kind: SensorKind, centimetres: Int) =
        "${the(kind)} está a $centimetres cm del robot: como mucho 15 cm."

    override fun turretMotorTaken(motor: MotorPort, byPen: Boolean) = if (byPen) {
        "El motor ${motor.name} gira un sensor y levanta el lápiz."
    } else {
        "El motor ${motor.name} gira un sensor y mueve una rueda."
    }

    override fun noTurret(brick: BrickKind) = "Los motores de un ${brick.name} no pueden girar un sensor: no cuentan."

    private fun the(kind: SensorKind) = "${if (kind in FEMININE) "La" else "El"} ${name(kind)}"

    private fun name(kind: SensorKind) = when (kind) {
        SensorKind.TOUCH -> "parachoques"
        SensorKind.TEMPERATURE -> "sensor de temperatura"
        SensorKind.LIGHT -> "sensor de luz"
        SensorKind.ROTATION -> "sensor de giro"
        SensorKind.ULTRASONIC -> "sensor de ultrasonidos"
        SensorKind.SOUND -> "sensor de sonido"
        SensorKind.COLOUR -> "sensor de color"
        SensorKind.COMPASS -> "brújula"
        SensorKind.GYRO -> "giroscopio"
        SensorKind.HITECHNIC_COLOUR -> "sensor de color de HiTechnic"
        SensorKind.MINDSENSORS_COMPASS -> "brújula de mindsensors"
        SensorKind.HITECHNIC_ACCELERATION -> "acelerómetro de HiTechnic"
        SensorKind.MINDSENSORS_ACCELERATION -> "acelerómetro de mindsensors"
        SensorKind.RCX_LIGHT -> "sensor de luz del RCX"
        SensorKind.RCX_LINK -> "enlace RCX"
        SensorKind.OPTICAL_DISTANCE -> "sensor óptico de distancia"
        SensorKind.NXT_TEMPERATURE -> "sensor de temperatura del NXT"
        SensorKind.INFRARED_SEEKER -> "buscador de infrarrojos"
        SensorKind.INFRARED_SEEKER_2 -> "buscador de infrarrojos V2"
    }

    private fun subject(figure: RobotFigure) = when (figure) {
        RobotFigure.COORDINATE -> "Un lugar del robot tiene que estar"
        RobotFigure.CORNERS -> "El número de esquinas tiene que ser"
        RobotFigure.HEIGHT -> "La altura tiene que ser"
        RobotFigure.MASS -> "La masa tiene que ser"
        RobotFigure.WHEEL_WIDTH -> "El ancho de una rueda tiene que ser"
        RobotFigure.TRACK -> "La distancia entre las ruedas tiene que ser"
        RobotFigure.GEAR -> "La relación de los engranajes tiene que ser"
        RobotFigure.TYRE_FRICTION -> "El agarre de las ruedas tiene que ser"
        RobotFigure.CASTERS -> "El número de ruedas locas tiene que ser"
        RobotFigure.PARTS -> "El número de piezas tiene que ser"
        RobotFigure.BUMPER_WIDTH -> "El ancho de un parachoques tiene que ser"
        RobotFigure.BUMPER_DEPTH -> "El fondo de un parachoques tiene que ser"
        RobotFigure.SENSOR_HEIGHT -> "La altura de un sensor tiene que ser"
        RobotFigure.ANGLE -> "Una dirección tiene que ser"
    }

    private fun comma(number: String) = number.replace('.', ',')

    private val FEMININE = setOf(SensorKind.COMPASS, SensorKind.MINDSENSORS_COMPASS)
}
