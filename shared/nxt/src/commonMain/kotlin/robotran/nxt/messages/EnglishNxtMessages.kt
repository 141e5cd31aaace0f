package robotran.nxt.messages

import robotran.brick.controls.MotorMode
import robotran.brick.controls.MotorPort
import robotran.brick.messages.EnglishPlaceMessages
import robotran.brick.messages.PlaceMessages
import robotran.brick.messages.place
import robotran.brick.program.ProgramFailure
import robotran.language.listed
import robotran.nxt.hardware.I2cStatus
import robotran.nxt.hardware.SensorPower
import robotran.nxt.hardware.SensorType

object EnglishNxtMessages : NxtMessages, PlaceMessages by EnglishPlaceMessages {
    override fun failureShown(failure: ProgramFailure) =
        "The program cannot go on. ${placed(failure)} Press Escape to go back to the menu."

    override fun threadFailureShown(failure: ProgramFailure) =
        "A thread of the program cannot go on. ${placed(failure)} Press Escape to end the program."

    private fun placed(failure: ProgramFailure) = listOfNotNull(failure.place(this), failure.message).joinToString(": ")

    override fun motorsRollAtEnd() =
        "The program has come to its end, so the brick switched the motors off, as a real one does. " +
            "To let the robot drive on, let the program go on, too: with a wait, or with a loop that never ends."

    override fun wrongArguments() = "nothing happens, there is no such port or value"

    override fun motor(port: MotorPort, mode: MotorMode, power: Int, brakesInPauses: Boolean) = when (mode) {
        MotorMode.FORWARD, MotorMode.BACKWARD -> {
            "motor ${port.name} ${mode.name.lowercase()} $power" + if (brakesInPauses) "" else ", rolling in the pauses"
        }

        MotorMode.BRAKE -> "motor ${port.name} brakes"
        MotorMode.FLOAT -> "motor ${port.name} rolls"
    }

    override fun resetTachoCount(port: MotorPort) = "motor ${port.name} counts from 0"

    override fun turnOn(port: MotorPort, speed: String, isForward: Boolean) =
        "motor ${port.name} turns ${if (isForward) "forward" else "backward"} at $speed degrees a second"

    override fun turnTo(port: MotorPort, speed: String, limit: Int, isHeld: Boolean) =
        "motor ${port.name} turns to $limit at $speed degrees a second" + if (isHeld) "" else " and then rolls"

    override fun stopMotor(port: MotorPort, isHeld: Boolean) =
        "motor ${port.name} stops" + if (isHeld) " and is held" else " and then rolls"

    override fun motorSpeed(port: MotorPort, speed: String) = "motor ${port.name} goes on at $speed degrees a second"

    override fun motorAcceleration(port: MotorPort, acceleration: Int) =
        "motor ${port.name} accelerates by $acceleration degrees a second in each second"

    override fun rollMotor(port: MotorPort) = "let motor ${port.name} roll"

    override fun regulateNoMore(port: MotorPort) = "let motor ${port.name} roll, without regulation"

    override fun stallThreshold(port: MotorPort, degrees: Int, milliseconds: Int) =
        "motor ${port.name} is stalled when it is $degrees degrees behind for $milliseconds ms"

    override fun sensorPower(port: Int, power: Int) = "sensor $port " + when (power) {
        SensorPower.RCX -> "gets 9 volts, except while it is read"
        SensorPower.NINE_VOLTS -> "gets 9 volts"
        else -> "gets no power"
    }

    override fun pinMode(port: Int, pin: Int, mode: Int) = "sensor $port, pin $pin is " + when (mode) {
        PIN_INPUT -> "read"
        PIN_OUTPUT -> "set by the brick"
        PIN_MEASURES -> "measured"
        else -> "off"
    }

    override fun pin(port: Int, pin: Int, isHigh: Boolean) = "sensor $port, pin $pin ${if (isHigh) "on" else "off"}"

    override fun sensorType(port: Int, type: Int) = "port $port has " + when (type) {
        SensorType.NO_SENSOR -> "no sensor"
        SensorType.SWITCH -> "a touch sensor"
        SensorType.TEMPERATURE -> "a temperature sensor of an RCX"
        SensorType.REFLECTION -> "a light sensor of an RCX"
        SensorType.ANGLE -> "a rotation sensor of an RCX"
        SensorType.LIGHT_ACTIVE -> "a light sensor with its lamp on"
        SensorType.LIGHT_INACTIVE -> "a light sensor with its lamp off"
        SensorType.SOUND_DB, SensorType.SOUND_DBA -> "a sound sensor"
        SensorType.LOWSPEED, SensorType.LOWSPEED_9V, SensorType.HISPEED -> "a sensor that sends bytes"
        in SensorType.COLOUR_FULL..SensorType.COLOUR_NONE -> "a colour sensor"
        else -> "a sensor of another kind"
    }

    override fun i2cReady(port: Int) = "sensor $port gets ready to send bytes"

    override fun i2cOff(port: Int) = "sensor $port sends bytes no more"

    override fun i2cMessage(port: Int, bytes: Int, answer: Int) =
        "send ${bytes(bytes)} to sensor $port" + if (answer == 0) "" else " and ask for ${bytes(answer)}"

    override fun i2cRefused(port: Int, status: Int) = "nothing is sent to sensor $port, " + when (status) {
        I2cStatus.BUSY -> "it is still busy"
        I2cStatus.INVALID_LENGTH -> "the message is too long"
        else -> "it is not ready"
    }

    override fun drawText(text: String, column: Int, row: Int, isInverted: Boolean, gaps: List<String>) = buildString {
        append("draw $text at column $column, row $row")
        if (isInverted) append(", white on black")
        if (gaps.isNotEmpty()) append(", but the display has no ${listed(gaps, "or")}")
    }

    override fun clearDisplay() = "clear the display"

    override fun drawPicture(width: Int, height: Int, x: Int, y: Int) = "draw $width by $height dots at $x, $y"

    override fun refreshDisplay() = "show on the display what was drawn"

    override fun refreshEvery(period: Int) =
        if (period == 0) "show only on request what is drawn" else "show every $period ms what was drawn"

    override fun contrast(contrast: Int) = "display contrast $contrast"

    override fun tone(hertz: Int, milliseconds: Int, volume: Int) =
        "tone of $hertz Hz for $milliseconds ms at volume $volume"

    override fun samples(count: Int, perSecond: Int) = "play $count samples, $perSecond a second"

    override fun shutDown() = "switch the brick off"

    override fun connectTo(name: String) = "connect to robot $name"

    override fun noRobot(name: String) = "nothing is connected, there is no robot $name"

    override fun awaitConnection() = "wait for another robot to connect"

    override fun sent(bytes: Int, link: Int) = "send ${bytes(bytes)} on connection $link"

    override fun notSent(link: Int) = "nothing is sent, connection $link is not open"

    override fun closeLink(link: Int) = "close connection $link"

    override fun exit() = "end the program"

    override fun exception(number: Int) = "show exception $number"

    override fun writePage(page: Int) = "write page $page of the flash memory"

    override fun noPage(page: Int) = "nothing is written, the flash memory has no page $page"

    override fun console(text: String) = "log $text"

    private fun bytes(count: Int) = if (count == 1) "1 byte" else "$count bytes"
}

internal const val PIN_INPUT = 1
internal const val PIN_OUTPUT = 2
internal const val PIN_MEASURES = 3
