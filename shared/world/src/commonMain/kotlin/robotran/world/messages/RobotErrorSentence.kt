package robotran.world.messages

import robotran.json.writeDecimal
import robotran.language.Language
import robotran.world.robot.RobotError

/** The whole sentence for this error. */
fun RobotError.sentence(language: Language): String = with(RobotMessages.of(language)) {
    when (val error = this@sentence) {
        is RobotError.OutOfRange -> outOfRange(
            error.figure,
            writeDecimal(error.range.start),
            writeDecimal(error.range.endInclusive),
        )

        is RobotError.PortTaken -> portTaken(error.port)
        is RobotError.NoSuchPort -> noSuchPort(error.brick, error.port)
        is RobotError.NoSuchMotor -> noSuchMotor(error.brick, error.motor)
        is RobotError.UnreadableSensor -> unreadable(error.brick, error.kind)
        is RobotError.OneDriveMotor -> oneDriveMotor(error.motor)
        is RobotError.PenMotorTaken -> penMotorTaken(error.motor)
        RobotError.NoWheels -> noWheels()
        RobotError.WheelsTooClose -> wheelsTooClose()
        RobotError.TooFast -> tooFast()
        is RobotError.TipsOver -> tipsOver(error.backwards)
        RobotError.CasterOnAxle -> casterOnAxle()
        RobotError.OutlineCrosses -> outlineCrosses()
        RobotError.OutlineTooSmall -> outlineTooSmall()
        RobotError.OutlineTooLarge -> outlineTooLarge()
        RobotError.TooManyCorners -> tooManyCorners()
        RobotError.MassOutside -> massOutside()
        RobotError.MassBesideMiddle -> massBesideMiddle()
        is RobotError.BumperInside -> bumperInside()
        is RobotError.SensorInFloor -> sensorInFloor(error.kind, writeDecimal(error.lowest))
        is RobotError.SensorTooHigh -> sensorTooHigh(error.kind, writeDecimal(error.highest))
        is RobotError.CannotLookDown -> cannotLookDown(error.kind)
        is RobotError.LooksIntoRobot -> looksIntoRobot(error.kind)
        is RobotError.FarAway -> farAway(error.kind, error.centimetres)
        is RobotError.TurretMotorTaken -> turretMotorTaken(error.motor, error.byPen)
        is RobotError.NoTurret -> noTurret(error.brick)
    }
}

internal fun robotReason(sentence: RobotMessages.() -> String): (Language) -> String = {
    RobotMessages.of(it).sentence()
}
