package robotran.nxt.messages

import robotran.brick.controls.MotorMode
import robotran.brick.controls.MotorPort
import robotran.brick.messages.GermanPlaceMessages
import robotran.brick.messages.PlaceMessages
import robotran.brick.messages.place
import robotran.brick.program.ProgramFailure
import robotran.language.listed
import robotran.nxt.hardware.I2cStatus
import robotran.nxt.hardware.SensorPower
import robotran.nxt.hardware.SensorType

/**
 * The messages in German. One term per concept: brick - Stein, display - Anzeige, thread - Thread, power - Leistung,
 * to roll - ausrollen.
 */
object GermanNxtMessages : NxtMessages, PlaceMessages by GermanPlaceMessages {
    override fun failureShown(failure: ProgramFailure) =
        "Das Programm kann nicht weiter. ${placed(failure)} Drück auf Escape, um zum Menü zurückzukommen."

    override fun threadFailureShown(failure: ProgramFailure) =
        "Ein Thread des Programms kann nicht weiter. ${placed(failure)} Drück auf Escape, um das Programm zu beenden."

    private fun placed(failure: ProgramFailure) = listOfNotNull(failure.place(this), failure.message).joinToString(": ")

    override fun motorsRollAtEnd() =
        "Das Programm ist zu Ende, also hat der Stein die Motoren ausgeschaltet, wie ein echter. " +
            "Wenn der Roboter weiterfahren soll, muss auch das Programm weitergehen: mit Warten oder mit einer " +
            "Schleife, die nie endet."

    override fun wrongArguments() = "nichts passiert, einen solchen Anschluss oder Wert gibt es nicht"

    override fun motor(port: MotorPort, mode: MotorMode, power: Int, brakesInPauses: Boolean) = when (mode) {
        MotorMode.FORWARD, MotorMode.BACKWARD -> {
            val way = if (mode == MotorMode.FORWARD) "vorwärts" else "rückwärts"
            "Motor ${port.name} $way $power" + if (brakesInPauses) "" else ", rollt in den Pausen"
        }

        MotorMode.BRAKE -> "Motor ${port.name} bremst"
        MotorMode.FLOAT -> "Motor ${port.name} rollt aus"
    }

    override fun resetTachoCount(port: MotorPort) = "Motor ${port.name} zählt ab 0"

    override fun turnOn(port: MotorPort, speed: String, isForward: Boolean) =
        "Motor ${port.name} dreht ${if (isForward) "vorwärts" else "rückwärts"} mit $speed Grad pro Sekunde"

    override fun turnTo(port: MotorPort, speed: String, limit: Int, isHeld: Boolean) =
        "Motor ${port.name} dreht bis $limit mit $speed Grad pro Sekunde" + if (isHeld) "" else " und rollt dann aus"

    override fun stopMotor(port: MotorPort, isHeld: Boolean) =
        "Motor ${port.name} hält an" + if (isHeld) " und wird festgehalten" else " und rollt dann aus"

    override fun motorSpeed(port: MotorPort, speed: String) = "Motor ${port.name} weiter mit $speed Grad pro Sekunde"

    override fun motorAcceleration(port: MotorPort, acceleration: Int) =
        "Motor ${port.name} wird in jeder Sekunde um $acceleration Grad pro Sekunde schneller"

    override fun rollMotor(port: MotorPort) = "Motor ${port.name} ausrollen lassen"

    override fun regulateNoMore(port: MotorPort) = "Motor ${port.name} ausrollen lassen, ohne Regelung"

    override fun stallThreshold(port: MotorPort, degrees: Int, milliseconds: Int) =
        "Motor ${port.name} steckt fest, wenn er $milliseconds ms lang $degrees Grad zurückliegt"

    override fun sensorPower(port: Int, power: Int) = "Sensor $port bekommt " + when (power) {
        SensorPower.RCX -> "9 Volt, außer während er misst"
        SensorPower.NINE_VOLTS -> "9 Volt"
        else -> "keinen Strom"
    }

    override fun pinMode(port: Int, pin: Int, mode: Int) = "Sensor $port, Leitung $pin wird " + when (mode) {
        PIN_INPUT -> "gelesen"
        PIN_OUTPUT -> "vom Stein gesetzt"
        PIN_MEASURES -> "gemessen"
        else -> "nicht benutzt"
    }

    override fun pin(port: Int, pin: Int, isHigh: Boolean) = "Sensor $port, Leitung $pin ${if (isHigh) "an" else "aus"}"

    override fun sensorType(port: Int, type: Int) = "Anschluss $port hat " + when (type) {
        SensorType.NO_SENSOR -> "keinen Sensor"
        SensorType.SWITCH -> "einen Tastsensor"
        SensorType.TEMPERATURE -> "einen Temperatursensor eines RCX"
        SensorType.REFLECTION -> "einen Lichtsensor eines RCX"
        SensorType.ANGLE -> "einen Drehsensor eines RCX"
        SensorType.LIGHT_ACTIVE -> "einen Lichtsensor mit Lampe an"
        SensorType.LIGHT_INACTIVE -> "einen Lichtsensor mit Lampe aus"
        SensorType.SOUND_DB, SensorType.SOUND_DBA -> "einen Geräuschsensor"
        SensorType.LOWSPEED, SensorType.LOWSPEED_9V, SensorType.HISPEED -> "einen Sensor, der Bytes sendet"
        in SensorType.COLOUR_FULL..SensorType.COLOUR_NONE -> "einen Farbsensor"
        else -> "einen Sensor anderer Art"
    }

    override fun i2cReady(port: Int) = "Sensor $port macht sich bereit, Bytes zu senden"

    override fun i2cOff(port: Int) = "Sensor $port sendet keine Bytes mehr"

    override fun i2cMessage(port: Int, bytes: Int, answer: Int) =
        "${bytes(bytes)} an Sensor $port senden" + if (answer == 0) "" else " und ${bytes(answer)} erfragen"

    override fun i2cRefused(port: Int, status: Int) = "nichts wird an Sensor $port gesendet, " + when (status) {
        I2cStatus.BUSY -> "er ist noch beschäftigt"
        I2cStatus.INVALID_LENGTH -> "die Nachricht ist zu lang"
        else -> "er ist nicht bereit"
    }

    override fun drawText(text: String, column: Int, row: Int, isInverted: Boolean, gaps: List<String>) = buildString {
        append("$text zeichnen in Spalte $column, Zeile $row")
        if (isInverted) append(", weiß auf schwarz")
        if (gaps.isNotEmpty()) append(", aber die Anzeige hat kein ${listed(gaps, "und kein")}")
    }

    override fun clearDisplay() = "Anzeige löschen"

    override fun drawPicture(width: Int, height: Int, x: Int, y: Int) = "$width mal $height Punkte zeichnen bei $x, $y"

    override fun refreshDisplay() = "auf der Anzeige zeigen, was gezeichnet ist"

    override fun refreshEvery(period: Int) =
        if (period == 0) "Gezeichnetes nur auf Wunsch zeigen" else "alle $period ms zeigen, was gezeichnet ist"

    override fun contrast(contrast: Int) = "Kontrast der Anzeige $contrast"

    override fun tone(hertz: Int, milliseconds: Int, volume: Int) =
        "Ton von $hertz Hz für $milliseconds ms mit Lautstärke $volume"

    override fun samples(count: Int, perSecond: Int) = "$count Messwerte als Klang spielen, $perSecond pro Sekunde"

    override fun shutDown() = "den Stein ausschalten"

    override fun connectTo(name: String) = "mit dem Roboter $name verbinden"

    override fun noRobot(name: String) = "nichts wird verbunden, es gibt keinen Roboter $name"

    override fun awaitConnection() = "warten, dass sich ein anderer Roboter verbindet"

    override fun sent(bytes: Int, link: Int) = "${bytes(bytes)} über die Verbindung $link senden"

    override fun notSent(link: Int) = "nichts wird gesendet, die Verbindung $link ist nicht offen"

    override fun closeLink(link: Int) = "die Verbindung $link schließen"

    override fun exit() = "das Programm beenden"

    override fun exception(number: Int) = "die Exception $number zeigen"

    override fun writePage(page: Int) = "Seite $page des Flash-Speichers schreiben"

    override fun noPage(page: Int) = "nichts wird geschrieben, der Flash-Speicher hat keine Seite $page"

    override fun console(text: String) = "notieren: $text"

    private fun bytes(count: Int) = if (count == 1) "1 Byte" else "$count Bytes"
}
