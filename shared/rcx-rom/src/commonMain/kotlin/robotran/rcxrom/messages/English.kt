package robotran.rcxrom.messages

import robotran.brick.controls.BrickButton
import robotran.brick.controls.MotorMode
import robotran.brick.controls.MotorPort
import robotran.brick.messages.EnglishPlaceMessages
import robotran.brick.messages.PlaceMessages
import robotran.brick.messages.place
import robotran.brick.program.ProgramFailure
import robotran.rcxrom.call.RomCode
import robotran.rcxrom.call.RomGap
import robotran.rcxrom.display.LcdIcon
import robotran.rcxrom.display.SegmentIcons
import robotran.rcxrom.infrared.InfraredRange

object EnglishBrickMessages : BrickMessages, PlaceMessages by EnglishPlaceMessages {
    override fun failureShown(failure: ProgramFailure) =
        "The program cannot go on. ${placed(failure)} Press On-Off to go back to the start."

    override fun threadFailureShown(failure: ProgramFailure) =
        "A thread of the program cannot go on. ${placed(failure)} Press On-Off to let the others go on."

    private fun placed(failure: ProgramFailure) = listOfNotNull(failure.place(this), failure.message).joinToString(": ")

    override fun motorsBrakedAtEnd() =
        "The program has come to its end, so the brick stopped the motors, as a real one does. " +
            "To let the robot drive on, let the program go on, too: with a wait, or with a loop that never ends."

    override fun unknownRoutine() = "nothing happens, no routine is known here"

    override fun tooFewArguments(routine: String, needed: Int, given: Int) =
        "nothing happens, $routine needs $needed arguments, not $given"

    override fun wrongCodeGroup(routine: String, group: Int) =
        "nothing happens, $routine wants a code that begins with 0x${group.toString(radix = 16)}"

    override fun unknownCode(code: Int) = "nothing happens, there is no code ${hexadecimal(code)} here"

    override fun notModelled(routine: String, gap: RomGap) = "nothing happens, $routine is not modelled: ${gap.reason}"

    override fun messageNotModelled(received: String, gap: RomGap) = "$received, but nothing happens: ${gap.reason}"

    override fun setUp(routine: String) = routine

    override fun motor(port: MotorPort, mode: MotorMode, power: Int, ignoredMode: Int?, countedPower: Int?) =
        buildString {
            append("motor ${port.name} ${mode.name.lowercase()} $power")
            if (ignoredMode != null) append(", mode $ignoredMode is ignored")
            if (countedPower != null) append(", power $countedPower counts as $power")
        }

    override fun readSensor(port: Int) = "read sensor $port"

    override fun sensorPower(port: Int, active: Boolean) = "sensor $port ${if (active) "active" else "passive"}"

    override fun sensorPowers(ports: List<Int>, active: Boolean) =
        if (ports.isEmpty()) "no sensor changes" else ports.joinToString { sensorPower(it, active) }

    override fun buttons(held: List<BrickButton>) =
        "buttons held down: ${held.joinToString { it.label }.ifEmpty { "none" }}"

    override fun onOffKey(held: Boolean) = "the On-Off key is ${if (held) "held down" else "up"}"

    override fun battery(raw: Int) = "the battery measures $raw"

    override fun clearDisplay() = "clear the LCD"

    override fun refreshDisplay() = "refresh the LCD"

    override fun segment(code: Int, shown: Boolean) = "LCD ${if (shown) "show" else "hide"} ${segmentName(code)}"

    override fun icon(icon: LcdIcon) = icon.words

    override fun displayNumber(text: String, shortened: Int?, unknownPoint: Int?) = buildString {
        append("LCD number $text")
        if (shortened != null) append(", for $shortened is too long")
        if (unknownPoint != null) append(", without a point, for there is no code ${hexadecimal(unknownPoint)}")
    }

    override fun programDigit(digit: Int) = "LCD program digit $digit"

    override fun programDigitStays(number: Int) = "LCD program digit stays, for $number is none"

    override fun queued(sound: String) = "queue $sound"

    override fun playedAtOnce(sound: String) = "play $sound at once"

    override fun dropped(sound: String) = "drop $sound, for the sound queue is full"

    override fun systemSound(number: Int, played: Int): String {
        val remark = if (played == number) "" else ", for there is no $number"
        return "system sound $played (${SYSTEM_SOUNDS[played]}$remark)"
    }

    override fun tone(hertz: Int, milliseconds: Int) = "tone of $hertz Hz for $milliseconds ms"

    override fun pause(milliseconds: Int) = "pause of $milliseconds ms"

    override fun soundPlaying(playing: Boolean) = if (playing) "a sound is playing" else "no sound is playing"

    override fun powerOff() = "sleep until On-Off is pressed"

    override fun startTimer() = "start the timer, with motors off and sensors passive"

    override fun stopTimer() = "stop the timer, and motors, sounds and sensors with it"

    override fun resetMinuteTimer() = "reset the minute timer"

    override fun startInfrared() = "start the infrared, at short range"

    override fun stopInfrared() = "stop the infrared"

    override fun infraredRange(range: InfraredRange) = "infrared range ${range.name.lowercase()}"

    override fun transferPointer(address: Int) =
        if (address == 0) "transferred data will not be kept" else "transferred data will go to ${hexadecimal(address)}"

    override fun dataWaiting(waiting: Boolean) = if (waiting) "a message waits" else "no message waits"

    override fun received(bytes: Int) = "receive ${bytes(bytes)}"

    override fun sent(bytes: Int) = "send ${bytes(bytes)}"

    override fun stillSending() = "nothing is sent, the message before is still on its way"

    override fun infraredOff() = "nothing is sent, the infrared is switched off"

    override fun wrongMessageLength(bytes: Int, longest: Int) =
        "nothing is sent, a message has 1 to $longest bytes, not $bytes"

    private fun segmentName(code: Int): String = when (code) {
        RomCode.SEGMENT_DATALOG -> "datalog circle"
        RomCode.SEGMENT_DOWNLOAD -> "download dots"
        RomCode.SEGMENT_UPLOAD -> "upload dots"
        RomCode.SEGMENT_ALL -> "everything"
        else -> SegmentIcons.of(code)?.words ?: hexadecimal(code)
    }

    private fun bytes(count: Int) = if (count == 1) "1 byte" else "$count bytes"

    private val SYSTEM_SOUNDS = listOf("beep", "two beeps", "melody down", "melody up", "buzz", "fast melody up")
}
