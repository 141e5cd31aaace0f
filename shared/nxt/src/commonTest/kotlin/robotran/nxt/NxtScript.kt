package robotran.nxt

import robotran.brick.controls.BrickButton
import robotran.brick.controls.MotorPort
import robotran.brick.log.LoggedCall
import robotran.brick.sound.SoundEvent
import robotran.brick.state.RunState
import robotran.language.Language
import robotran.nxt.bluetooth.BluetoothNetwork
import robotran.nxt.hardware.NxtColour
import robotran.nxt.hardware.SonarDevice
import robotran.nxt.messages.NxtMessages
import robotran.nxt.program.NxtCall
import robotran.nxt.program.NxtNative
import robotran.nxt.program.NxtProgram
import robotran.nxt.regulator.MotorRegulator

/**
 * Runs a script of `resources/scripts`, in the format of its README; [differences] lists deviations from the expected
 * behaviour.
 */
internal class NxtScript(private val path: String, private val text: String) {
    private val found = mutableListOf<String>()
    private var network = BluetoothNetwork()
    private val bricks =
        linkedMapOf("NXT" to TestBrick(NxtBrick(emptyList(), network, messages = NxtMessages.of(Language.ENGLISH))))
    private var bench = bricks.getValue("NXT")
    private val brick get() = bench.brick
    private var result = 0
    private var line = 0

    /** Each as `path:line expected and actual`; empty if there are none. */
    fun differences(): List<String> {
        text.lines().forEachIndexed { index, written ->
            line = index + 1
            val statement = written.substringBefore(" #").trim()
            if (statement.isNotEmpty() && !statement.startsWith('#')) perform(statement)
        }
        return found
    }

    private fun perform(statement: String) {
        val (word, rest) = (statement.split(' ', limit = 2) + "").take(2)
        when (word) {
            "at" -> {
                val (time, then) = (rest.split(' ', limit = 2) + "").take(2)
                advance(time.toLong() - brick.state.milliseconds)
                if (then.isNotEmpty()) perform(then)
            }

            "wait" -> advance(rest.toLong())
            in ACTIONS -> act(word, rest)
            else -> compare(statement, rest, seen(word, rest))
        }
    }

    private fun advance(milliseconds: Long) {
        require(milliseconds >= 0) { "$path:$line goes back in time" }
        repeat(milliseconds.toInt()) { bricks.values.forEach { it.tick() } }
    }

    private fun act(action: String, rest: String) {
        val words = rest.split(' ')
        when (action) {
            "programs" -> beginWith(words.map(::scriptedProgram))
            "robot" -> bricks[rest] =
                TestBrick(NxtBrick(emptyList(), network, rest, messages = NxtMessages.of(Language.ENGLISH)))
            "on" -> bench = bricks.getValue(rest)
            "press" -> brick.press(buttonOf(rest))
            "release" -> brick.release(buttonOf(rest))
            "push" -> brick.push(buttonOf(rest))
            "stop" -> brick.stopProgram()
            "run-now" -> brick.runSnippet(checkNotNull(scriptedProgram(rest)))
            "call" -> result = brick.nxt.call(callOf(rest), TEST_LINE)
            "library" -> result = brick.nxt.call(callOf(rest), sourceLine = 0)
            "measure" -> brick.setAnalog(words[0].toInt() - 1, words[1].toInt())

            "colour" -> words.map { it.toInt() }.let { (port, r, g, b, n) ->
                brick.setColour(port - 1, NxtColour(r, g, b, n))
            }

            "hub" -> brick.setHubDegrees(MotorPort.valueOf(words[0]), words[1].toInt())
            "motor" -> bench.motors += FreeMotor(MotorPort.valueOf(words[0]), words[1].toDouble())
            "battery" -> brick.setBattery(rest.toInt())
            "sonar" -> bench.plugSonar(words[0].toInt() - 1)
            "wall" -> bench.echoes = words.filter { it != "none" }.map { it.toDouble() }.toDoubleArray()
        }
    }

    private fun beginWith(programs: List<NxtProgram?>) {
        network = BluetoothNetwork()
        bricks.clear()
        bench = TestBrick(NxtBrick(programs, network, messages = NxtMessages.of(Language.ENGLISH)))
        bricks["NXT"] = bench
    }

    private fun seen(word: String, rest: String): String {
        val state = brick.state
        val number = rest.substringBefore(' ').toIntOrNull() ?: 0
        return when (word) {
            "result" -> "$result"
            "line" -> "$number \"${state.display.lines[number]}\""
            "texts" -> state.display.texts.joinToString(" / ").ifEmpty { "none" }
            "dots" -> if (state.display.toArt() == displayGoldens["$rest.txt"]) rest else "\n${state.display.toArt()}"
            "menu" -> state.menu?.run { "$title: ${entries.getOrElse(selected) { "nothing to choose" }}" } ?: "none"
            "power" -> if (state.poweredOn) "on" else "off"
            "program" -> wordFor(state.run)
            "slot" -> "${state.selectedSlot}"
            "sounds" -> bench.newSounds().joinToString(transform = ::wordsFor).ifEmpty { "none" }
            "sounding" -> "${state.sounding}"
            "volume" -> "${state.volume}"
            "sound-left" -> "${brick.nxt.soundMillisecondsLeft()}"
            "says" -> state.explanation ?: "nothing"

            "motors" -> {
                state.motors.joinToString {
                    "${it.mode.name.lowercase()} ${it.power}" + if (it.brakesInPauses) "" else " loose"
                }
            }

            "degrees" -> state.motorDegrees.joinToString(" ")

            "regulator" -> {
                val regulator = brick.nxt.regulator(number)
                "$number ${if (regulator.isMoving) "moving" else "still"}${if (regulator.isStalled) " stalled" else ""}"
            }

            "limit" -> "$number ${brick.nxt.regulator(number).limit}"
            "log" -> brick.log.entries.last().meaning
            "log-line" -> lastLog().text
            "group" -> lastLog().group.name.lowercase()
            "outcome" -> lastLog().outcome.name.lowercase().replace('_', ' ')
            "calls" -> "${brick.log.total}"
            "analog" -> "$number ${brick.nxt.analog(number)}"

            "pin" -> {
                rest.split(' ').let { (port, pin) ->
                    "$port $pin ${if (brick.nxt.pin(port.toInt(), pin.toInt())) 1 else 0}"
                }
            }

            "sensor" -> {
                state.sensorPorts[number - 1].run {
                    "$port ${if (isActive) "active" else "idle"} $raw $value${if (isPressed) " pressed" else ""}"
                }
            }

            "sees" -> "$number ${brick.nxt.colour(number)?.run { "$red $green $blue $background $kind" } ?: "none"}"
            "bus" -> "$number ${brick.nxt.i2cStatus(number)}"
            "answer" -> answer(number)
            "buttons" -> "${brick.nxt.buttons()}"
            "millivolts" -> "${brick.nxt.batteryStatus()}"
            "contrast" -> "${state.contrast}"
            "refreshed" -> "${brick.nxt.refreshCompleteTime()}"

            "expects" -> {
                brick.expectedSensors.joinToString { "${it.port} ${it.kind.name.lowercase()}" }.ifEmpty { "none" }
            }

            "exception" -> state.exception?.run { "${failure.exceptionNumber} from $firstRow" } ?: "none"
            "link" -> "$number ${brick.nxt.link(number)?.run { "${status.name.lowercase()} $partner" } ?: "none"}"

            "links" -> {
                state.bluetooth.joinToString {
                    "${it.number} ${it.partner} ${it.status.name.lowercase()}"
                }.ifEmpty { "none" }
            }

            "received" -> received(number)
            "sending" -> "${state.isSending}"
            "knows" -> if (brick.nxt.knowsRobot(rest)) rest else "nobody"
            else -> error("$path:$line says \"$word\", which is no word of scripts")
        }
    }

    private fun compare(statement: String, wanted: String, seen: String) {
        if (seen != wanted) found += "$path:$line should be: $statement\n    but is: $seen"
    }

    private fun lastLog(): LoggedCall = brick.log.entries.last()

    private fun answer(port: Int): String {
        val into = ByteArray(32)
        val count = brick.nxt.i2cComplete(port, into)
        return if (count < 0) "$port $count" else "$port ${hexadecimal(into, count)}"
    }

    private fun received(link: Int): String {
        val into = ByteArray(1_000)
        val count = checkNotNull(brick.nxt.link(link)).read(into)
        return if (count < 0) "$link $count" else "$link ${hexadecimal(into, count)}"
    }

    /** A brick with what is plugged into it. */
    private class TestBrick(val brick: NxtBrick) {
        val motors = mutableListOf<FreeMotor>()
        var echoes = DoubleArray(0)
        private var soundsHeard = 0L

        fun tick() {
            brick.tick()
            motors.forEach { it.tick(brick) }
        }

        fun plugSonar(port: Int) = brick.connect(port, SonarDevice({ echoes }, brick.clock))

        fun newSounds(): List<SoundEvent> = brick.sounds.since(soundsHeard).also { soundsHeard = brick.sounds.total }
    }

    companion object {
        private val ACTIONS = setOf(
            "programs",
            "robot",
            "on",
            "press",
            "release",
            "push",
            "stop",
            "run-now",
            "call",
            "library",
            "measure",
            "colour",
            "hub",
            "motor",
            "battery",
            "sonar",
            "wall",
        )

        private fun buttonOf(word: String): BrickButton = BrickButton.valueOf(word.uppercase().replace('-', '_'))

        private fun hexadecimal(bytes: ByteArray, count: Int): String = bytes.take(count).joinToString(" ") {
            (it.toInt() and 0xFF).toString(radix = 16).padStart(2, '0')
        }.ifEmpty { "nothing" }

        private fun wordFor(run: RunState): String = when (run) {
            RunState.Idle -> "idle"
            is RunState.Running -> "running"
            is RunState.Ended -> if (run.stopped) "stopped" else "ended"
            is RunState.Failed -> "failed"
        }

        private fun wordsFor(event: SoundEvent): String = when (event) {
            is SoundEvent.Tone -> {
                "${(event.hertz + 0.5).toInt()} Hz ${event.durationMilliseconds} ms ${event.volume} %" +
                    if (event.isFirmware) " by the brick" else ""
            }

            is SoundEvent.Cut -> "cut"
        }

        /** `drawString "Hello" 0 0 0`, `i2cStartById 3 2 1 [42]`: name, text, numbers, bytes. */
        fun callOf(written: String): NxtCall {
            val name = written.substringBefore(' ')
            val native = NxtNative.entries.first { it.nativeName == name }
            val quotes = Regex("\"(.*)\"").find(written)
            val brackets = Regex("\\[(.*)]").find(written)
            val numbers = written.substringAfter(' ', "").let {
                if (quotes == null) {
                    it
                } else {
                    it.replace(quotes.value, "")
                }
            }
                .substringBefore('[').split(' ').filter { it.isNotEmpty() }
            return NxtCall(
                native,
                IntArray(numbers.size) { number(numbers[it], isSpeed = it == native.speed) },
                quotes?.groupValues?.get(1)?.replace("\\n", "\n"),
                brackets?.groupValues?.get(1)?.let(::bytes),
            )
        }

        private fun number(word: String, isSpeed: Boolean): Int = when {
            isSpeed -> word.toFloat().toRawBits()
            word == "forward" -> MotorRegulator.FORWARD
            word == "backward" -> MotorRegulator.BACKWARD
            word.startsWith("0x") -> word.drop(2).toInt(radix = 16)
            else -> word.toInt()
        }

        /** `41 42`, or `300 times 5` for many of one. */
        private fun bytes(written: String): ByteArray {
            val words = written.split(' ').filter { it.isNotEmpty() }
            if ("times" in words) return ByteArray(words[0].toInt()) { words[2].toInt(radix = 16).toByte() }
            return ByteArray(words.size) { words[it].toInt(radix = 16).toByte() }
        }
    }
}

/** Presses and releases at once. */
internal fun NxtBrick.push(button: BrickButton) {
    press(button)
    release(button)
}

internal fun NxtBrick.tick(milliseconds: Int) = repeat(milliseconds) { tick() }
