package robotran.world.messages

import robotran.brick.controls.MotorPort
import robotran.brick.kind.BrickKind
import robotran.brick.sensors.SensorKind
import robotran.json.messages.alternatives
import robotran.world.robot.RobotFigure

internal object GermanRobotMessages : RobotMessages {
    override fun notARobot(format: String) =
        "Das ist kein Roboter von Robotran: In einer Roboterdatei steht \"format\": \"$format\"."

    override fun newerRobot(version: Int, known: Int) =
        "Dieser Roboter wurde mit einem neueren Robotran gemacht (er hat Version $version, dieses Robotran liest bis " +
            "$known)."

    override fun noReadyRobot(name: String, known: List<String>) =
        "Es gibt keinen fertigen Roboter \"$name\", nur ${alternatives(known, "und")}."

    override fun robotAndPorts() =
        "Ein Roboter hat entweder \"robot\" oder \"ports\": Was an einem Roboter steckt, steht in seinen eigenen Teilen."

    override fun outOfRange(figure: RobotFigure, lowest: String, highest: String) =
        "${subject(figure)} von ${comma(lowest)} bis ${comma(highest)}${unitOf(figure, degrees = "Grad")} sein."

    override fun portTaken(port: Int) = "An Anschluss $port stecken zwei Dinge."

    override fun noSuchPort(brick: BrickKind, port: Int) = "Ein ${brick.name} hat keinen Anschluss $port."

    override fun unreadable(brick: BrickKind, kind: SensorKind) = "Ein ${brick.name} kann keinen ${name(kind)} lesen."

    override fun oneDriveMotor(motor: MotorPort) =
        "Zum Fahren braucht man zwei Motoren, aber links und rechts ist beides Motor ${motor.name}."

    override fun penMotorTaken(motor: MotorPort) =
        "Motor ${motor.name} treibt ein Rad an, also kann er den Stift nicht heben."

    override fun noWheels() = "Ein Roboter braucht zwei Räder: Gib ihnen einen Durchmesser von 2 bis 10 cm."

    override fun wheelsTooClose() =
        "Die Räder stecken ineinander: Die Spurweite muss größer sein, als ein Reifen breit ist."

    override fun tooFast() = "Mit diesem Getriebe ist der Roboter schneller als 60 cm in der Sekunde."

    override fun tipsOver(backwards: Boolean) = if (backwards) {
        "Der Roboter kippt um: Sein Gewicht liegt hinter den Rädern, und dort stützt ihn keine Rolle."
    } else {
        "Der Roboter kippt um: Sein Gewicht liegt vor den Rädern, und dort stützt ihn keine Rolle."
    }

    override fun casterOnAxle() = "Eine Rolle muss mindestens 1 cm vor oder hinter der Achse sein."

    override fun outlineCrosses() = "Der Umriss kreuzt oder berührt sich selbst."

    override fun outlineTooSmall() = "Der Umriss ist zu klein: Er muss mindestens 4 cm lang und breit sein."

    override fun outlineTooLarge() = "Der Umriss ist zu groß: Er darf höchstens 60 cm lang und breit sein."

    override fun tooManyCorners() = "Der Umriss hat zu viele Ecken für so viele Stoßfühler."

    override fun massOutside() = "Der Schwerpunkt liegt außerhalb des Umrisses."

    override fun massBesideMiddle() = "Der Schwerpunkt muss auf der Mittellinie liegen, bei y 0."

    override fun bumperInside() = "Der Stoßfühler ist im Roboter drin."

    override fun sensorInFloor(kind: SensorKind, lowest: String) =
        "Der ${name(kind)} steckt im Boden: Setze ihn mindestens ${comma(lowest)} cm hoch."

    override fun sensorTooHigh(kind: SensorKind, highest: String) =
        "Der ${name(kind)} schaut aus zu großer Höhe auf den Boden: höchstens ${comma(highest)} cm."

    override fun cannotLookDown(kind: SensorKind) =
        "Der ${name(kind)} muss eine Richtung haben und kann nicht nach unten schauen."

    override fun looksIntoRobot(kind: SensorKind) = "Der ${name(kind)} schaut in den Roboter selbst hinein."

    override fun farAway(kind: SensorKind, centimetres: Int) =
        "Der ${name(kind)} ist $centimetres cm vom Roboter entfernt: höchstens 15 cm."

    override fun turretMotorTaken(motor: MotorPort, byPen: Boolean) = if (byPen) {
        "Motor ${motor.name} dreht einen Sensor und hebt den Stift."
    } else {
        "Motor ${motor.name} dreht einen Sensor und treibt ein Rad an."
    }

    override fun noTurret(brick: BrickKind) =
        "Die Motoren eines ${brick.name} können keinen Sensor drehen: Sie zählen nicht."

    private fun name(kind: SensorKind) = when (kind) {
        SensorKind.TOUCH -> "Stoßfühler"
        SensorKind.TEMPERATURE -> "Temperatursensor"
        SensorKind.LIGHT -> "Lichtsensor"
        SensorKind.ROTATION -> "Drehsensor"
        SensorKind.ULTRASONIC -> "Ultraschallsensor"
        SensorKind.SOUND -> "Geräuschsensor"
        SensorKind.COLOUR -> "Farbsensor"
        SensorKind.COMPASS -> "Kompass"
        SensorKind.GYRO -> "Kreiselsensor"
        SensorKind.HITECHNIC_COLOUR -> "Farbsensor von HiTechnic"
        SensorKind.MINDSENSORS_COMPASS -> "Kompass von mindsensors"
        SensorKind.HITECHNIC_ACCELERATION -> "Beschleunigungssensor von HiTechnic"
        SensorKind.MINDSENSORS_ACCELERATION -> "Beschleunigungssensor von mindsensors"
        SensorKind.RCX_LIGHT -> "RCX-Lichtsensor"
        SensorKind.RCX_LINK -> "RCX-Sender"
        SensorKind.OPTICAL_DISTANCE -> "Infrarot-Abstandssensor"
        SensorKind.NXT_TEMPERATURE -> "NXT-Temperatursensor"
        SensorKind.INFRARED_SEEKER -> "Infrarotsucher"
        SensorKind.INFRARED_SEEKER_2 -> "Infrarotsucher V2"
    }

    private fun subject(figure: RobotFigure) = when (figure) {
        RobotFigure.COORDINATE -> "Ein Punkt am Roboter muss"
        RobotFigure.CORNERS -> "Die Zahl der Ecken muss"
        RobotFigure.HEIGHT -> "Die Höhe muss"
        RobotFigure.MASS -> "Das Gewicht muss"
        RobotFigure.WHEEL_WIDTH -> "Die Breite eines Reifens muss"
        RobotFigure.TRACK -> "Die Spurweite muss"
        RobotFigure.GEAR -> "Das Getriebe muss"
        RobotFigure.TYRE_FRICTION -> "Die Haftung der Reifen muss"
        RobotFigure.CASTERS -> "Die Zahl der Rollen muss"
        RobotFigure.PARTS -> "Die Zahl der Teile muss"
        RobotFigure.BUMPER_WIDTH -> "Die Breite eines Stoßfühlers muss"
        RobotFigure.BUMPER_DEPTH -> "Die Tiefe eines Stoßfühlers muss"
        RobotFigure.SENSOR_HEIGHT -> "Die Höhe eines Sensors muss"
        RobotFigure.ANGLE -> "Eine Richtung muss"
    }

    private fun comma(number: String) = number.replace('.', ',')
}
