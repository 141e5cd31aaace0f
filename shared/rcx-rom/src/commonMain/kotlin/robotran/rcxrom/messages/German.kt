package robotran.rcxrom.messages

import robotran.brick.controls.BrickButton
import robotran.brick.controls.MotorMode
import robotran.brick.controls.MotorPort
import robotran.brick.messages.GermanPlaceMessages
import robotran.brick.messages.PlaceMessages
import robotran.brick.messages.place
import robotran.brick.program.ProgramFailure
import robotran.rcxrom.call.RomCode
import robotran.rcxrom.call.RomGap
import robotran.rcxrom.display.LcdIcon
import robotran.rcxrom.display.SegmentIcons
import robotran.rcxrom.infrared.InfraredRange

/**
 * The messages in German. One term per concept: brick - Stein, display - Anzeige, thread - Thread, power - Leistung.
 */
object GermanBrickMessages : BrickMessages, PlaceMessages by GermanPlaceMessages {
    override fun failureShown(failure: ProgramFailure) =
        "Das Programm kann nicht weiter. ${placed(failure)} Drück auf On-Off, um zum Anfang zurückzukommen."

    override fun threadFailureShown(failure: ProgramFailure) =
        "Ein Thread des Programms kann nicht weiter. ${placed(failure)} Drück auf On-Off, damit die anderen " +
            "weitermachen."

    override fun motorsBrakedAtEnd() =
        "Das Programm ist zu Ende, also hat der Stein die Motoren angehalten, wie ein echter. " +
            "Wenn der Roboter weiterfahren soll, muss auch das Programm weitergehen: mit Warten oder mit einer " +
            "Schleife, die nie endet."

    override fun unknownRoutine() = "nichts passiert, hier ist keine Routine bekannt"

    override fun tooFewArguments(routine: String, needed: Int, given: Int) =
        "nichts passiert, $routine braucht $needed Argumente, nicht $given"

    override fun wrongCodeGroup(routine: String, group: Int) =
        "nichts passiert, $routine will einen Code, der mit 0x${group.toString(radix = 16)} beginnt"

    override fun unknownCode(code: Int) = "nichts passiert, hier gibt es keinen Code ${hexadecimal(code)}"

    override fun notModelled(routine: String, gap: RomGap) =
        "nichts passiert, $routine ist nicht nachgebaut: ${reason(gap)}"

    override fun messageNotModelled(received: String, gap: RomGap) = "$received, aber nichts passiert: ${reason(gap)}"

    override fun setUp(routine: String) = routine

    override fun motor(port: MotorPort, mode: MotorMode, power: Int, ignoredMode: Int?, countedPower: Int?) =
        buildString {
            append("Motor ${port.name} ${modeName(mode)} $power")
            if (ignoredMode != null) append(", die Betriebsart $ignoredMode zählt nicht")
            if (countedPower != null) append(", die Leistung $countedPower zählt als $power")
        }

    override fun readSensor(port: Int) = "Sensor $port lesen"

    override fun sensorPower(port: Int, active: Boolean) = "Sensor $port ${if (active) "mit Strom" else "ohne Strom"}"

    override fun sensorPowers(ports: List<Int>, active: Boolean) =
        if (ports.isEmpty()) "kein Sensor ändert sich" else ports.joinToString { sensorPower(it, active) }

    override fun buttons(held: List<BrickButton>) =
        "gedrückte Tasten: ${held.joinToString { it.label }.ifEmpty { "keine" }}"

    override fun onOffKey(held: Boolean) = "die Taste On-Off ist ${if (held) "gedrückt" else "losgelassen"}"

    override fun battery(raw: Int) = "die Batterie misst $raw"

    override fun clearDisplay() = "Anzeige löschen"

    override fun refreshDisplay() = "Anzeige auffrischen"

    override fun segment(code: Int, shown: Boolean) =
        "Anzeige: ${segmentName(code)} ${if (shown) "zeigen" else "verbergen"}"

    override fun icon(icon: LcdIcon) = when (icon) {
        LcdIcon.STANDING_MAN -> "stehendes Männchen"
        LcdIcon.WALKING_MAN -> "laufendes Männchen"
        LcdIcon.SENSOR_1_VIEW -> "Pfeil auf Sensor 1"
        LcdIcon.SENSOR_1_ACTIVE -> "Sensor 1 mit Strom"
        LcdIcon.SENSOR_2_VIEW -> "Pfeil auf Sensor 2"
        LcdIcon.SENSOR_2_ACTIVE -> "Sensor 2 mit Strom"
        LcdIcon.SENSOR_3_VIEW -> "Pfeil auf Sensor 3"
        LcdIcon.SENSOR_3_ACTIVE -> "Sensor 3 mit Strom"
        LcdIcon.MOTOR_A_VIEW -> "Pfeil auf Motor A"
        LcdIcon.MOTOR_A_BACKWARD -> "Motor A rückwärts"
        LcdIcon.MOTOR_A_FORWARD -> "Motor A vorwärts"
        LcdIcon.MOTOR_B_VIEW -> "Pfeil auf Motor B"
        LcdIcon.MOTOR_B_BACKWARD -> "Motor B rückwärts"
        LcdIcon.MOTOR_B_FORWARD -> "Motor B vorwärts"
        LcdIcon.MOTOR_C_VIEW -> "Pfeil auf Motor C"
        LcdIcon.MOTOR_C_BACKWARD -> "Motor C rückwärts"
        LcdIcon.MOTOR_C_FORWARD -> "Motor C vorwärts"
        LcdIcon.DATALOG_TOP_RIGHT -> "Viertelkreis oben rechts"
        LcdIcon.DATALOG_BOTTOM_RIGHT -> "Viertelkreis unten rechts"
        LcdIcon.DATALOG_BOTTOM_LEFT -> "Viertelkreis unten links"
        LcdIcon.DATALOG_TOP_LEFT -> "Viertelkreis oben links"
        LcdIcon.DOT_1 -> "Ladepunkt 1"
        LcdIcon.DOT_2 -> "Ladepunkt 2"
        LcdIcon.DOT_3 -> "Ladepunkt 3"
        LcdIcon.DOT_4 -> "Ladepunkt 4"
        LcdIcon.DOT_5 -> "Ladepunkt 5"
        LcdIcon.LOW_BATTERY -> "Batterie schwach"
        LcdIcon.INFRARED_SHORT -> "Infrarot kurz"
        LcdIcon.INFRARED_LONG -> "Infrarot weit"
        LcdIcon.MINUS -> "Minuszeichen"
        LcdIcon.POINT_1 -> "Dezimalpunkt 1"
        LcdIcon.POINT_2 -> "Dezimalpunkt 2"
        LcdIcon.POINT_3 -> "Dezimalpunkt 3"
    }

    override fun displayNumber(text: String, shortened: Int?, unknownPoint: Int?) = buildString {
        append("Anzeige: Zahl $text")
        if (shortened != null) append(", denn $shortened ist zu lang")
        if (unknownPoint != null) append(", ohne Punkt, denn es gibt keinen Code ${hexadecimal(unknownPoint)}")
    }

    override fun programDigit(digit: Int) = "Anzeige: Programmziffer $digit"

    override fun programDigitStays(number: Int) = "die Programmziffer bleibt, denn $number ist keine"

    override fun queued(sound: String) = "in die Schlange: $sound"

    override fun playedAtOnce(sound: String) = "sofort spielen: $sound"

    override fun dropped(sound: String) = "auslassen: $sound, denn die Schlange der Töne ist voll"

    override fun systemSound(number: Int, played: Int): String {
        val remark = if (played == number) "" else ", denn $number gibt es nicht"
        return "Systemton $played (${SYSTEM_SOUNDS[played]}$remark)"
    }

    override fun tone(hertz: Int, milliseconds: Int) = "Ton von $hertz Hz für $milliseconds ms"

    override fun pause(milliseconds: Int) = "Pause von $milliseconds ms"

    override fun soundPlaying(playing: Boolean) = if (playing) "gerade klingt ein Ton" else "gerade klingt kein Ton"

    override fun powerOff() = "schlafen, bis On-Off gedrückt wird"

    override fun startTimer() = "die Uhr starten, mit Motoren aus und Sensoren ohne Strom"

    override fun stopTimer() = "die Uhr anhalten, und mit ihr Motoren, Töne und Sensoren"

    override fun resetMinuteTimer() = "die Minutenuhr auf null stellen"

    override fun startInfrared() = "Infrarot einschalten, für kurze Entfernung"

    override fun stopInfrared() = "Infrarot ausschalten"

    override fun infraredRange(range: InfraredRange) =
        "Reichweite von Infrarot: ${if (range == InfraredRange.LONG) "weit" else "kurz"}"

    override fun transferPointer(address: Int) = if (address == 0) {
        "empfangene Daten werden nicht behalten"
    } else {
        "empfangene Daten kommen nach ${hexadecimal(address)}"
    }

    override fun dataWaiting(waiting: Boolean) = if (waiting) "eine Nachricht wartet" else "keine Nachricht wartet"

    override fun received(bytes: Int) = "${bytes(bytes)} empfangen"

    override fun sent(bytes: Int) = "${bytes(bytes)} senden"

    override fun stillSending() = "nichts wird gesendet, die Nachricht davor ist noch unterwegs"

    override fun infraredOff() = "nichts wird gesendet, Infrarot ist ausgeschaltet"

    override fun wrongMessageLength(bytes: Int, longest: Int) =
        "nichts wird gesendet, eine Nachricht hat 1 bis $longest Bytes, nicht $bytes"

    private fun placed(failure: ProgramFailure) = listOfNotNull(failure.place(this), failure.message).joinToString(": ")

    private fun reason(gap: RomGap) = when (gap) {
        RomGap.TIMER_TICK -> "der Stein tut das von selbst in jeder Millisekunde"
        RomGap.DOWNLOAD -> "in diesen Stein kommen Programme ohne Infrarot"
    }

    private fun modeName(mode: MotorMode) = when (mode) {
        MotorMode.FORWARD -> "vorwärts"
        MotorMode.BACKWARD -> "rückwärts"
        MotorMode.BRAKE -> "bremst"
        MotorMode.FLOAT -> "läuft aus"
    }

    private fun segmentName(code: Int): String = when (code) {
        RomCode.SEGMENT_DATALOG -> "Datenkreis"
        RomCode.SEGMENT_DOWNLOAD -> "Punkte fürs Laden"
        RomCode.SEGMENT_UPLOAD -> "Punkte fürs Senden"
        RomCode.SEGMENT_ALL -> "alles"
        else -> SegmentIcons.of(code)?.let(::icon) ?: hexadecimal(code)
    }

    private fun bytes(count: Int) = if (count == 1) "1 Byte" else "$count Bytes"

    private val SYSTEM_SOUNDS =
        listOf("Piep", "zweimal Piep", "Melodie abwärts", "Melodie aufwärts", "Brummen", "schnelle Melodie aufwärts")
}
