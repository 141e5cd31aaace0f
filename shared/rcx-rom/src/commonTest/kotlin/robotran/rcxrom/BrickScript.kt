package robotran.rcxrom

import robotran.brick.controls.BrickButton
import robotran.brick.program.ProgramFailure
import robotran.brick.program.ProgramStatus
import robotran.brick.sound.SoundEvent
import robotran.brick.state.RunState
import robotran.language.Language
import robotran.rcxrom.call.RomAddress
import robotran.rcxrom.call.RomCall
import robotran.rcxrom.infrared.InfraredAir
import robotran.rcxrom.messages.BrickMessages
import robotran.rcxrom.program.RcxProgram
import robotran.rcxrom.sensors.SensorField

/**
 * Runs a script of `resources/scripts`, in the format of its README; [differences] lists deviations from the expected
 * behaviour.
 */
internal class BrickScript(private val path: String, private val text: String) {
    private val found = mutableListOf<String>()
    private val air = InfraredAir()
    private var brick = RcxBrick(emptyList(), air, messages = BrickMessages.of(Language.ENGLISH))
    private val tower = air.placeTower()
    private var soundsHeard = 0L
    private var line = 0

    /** Each as `path:line expected and actual`; empty if there are none. */
    fun differences(): List<String> {
        text.lines().forEachIndexed { index, written ->
            line = index + 1
            val statement = written.substringBefore('#').trim()
            if (statement.isNotEmpty()) perform(statement)
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
            "programs" ->
                brick =
                    RcxBrick(
                        rest.split(' ').map(::scriptedProgram),
                        InfraredAir(),
                        messages = BrickMessages.of(Language.ENGLISH),
                    )
            in ACTIONS -> act(word, rest)
            else -> compare(statement, rest, seen(word, rest))
        }
    }

    private fun advance(milliseconds: Long) {
        require(milliseconds >= 0) { "$path:$line goes back in time" }
        repeat(milliseconds.toInt()) {
            brick.tick()
            tower.tick()
        }
    }

    private fun act(action: String, rest: String) {
        val words = rest.split(' ')
        when (action) {
            "press" -> brick.press(buttonOf(rest))
            "release" -> brick.release(buttonOf(rest))
            "push" -> brick.push(buttonOf(rest))
            "stop" -> brick.stopProgram()

            "call" -> brick.hardware.rom.call(
                RomCall(
                    numberOf(words.first()),
                    words.drop(1).map {
                        numberOf(it) and
                            0xFFFF
                    },
                ),
                TEST_LINE,
            )

            "write" -> rest.substringAfter("= ").split(' ').forEachIndexed { place, byte ->
                brick.hardware.memory.writeByte(numberOf(words.first()) + place, byte.toInt(radix = 16))
            }

            "measure" -> brick.setRawSensorValue(words[0].toInt() - 1, words[1].toInt())
            "battery" -> brick.setBattery(rest.toInt())
            "mode" -> brick.hardware.rom.setSensorTypeAndMode(words[0].toInt() - 1, 0, numberOf(words[1]))
            "value" -> brick.hardware.rom.setSensorValue(words[0].toInt() - 1, words[1].toInt(), SensorField.VALUE)

            "tower-sends" -> check(
                tower.send(
                    words.map { it.toInt(radix = 16) },
                ),
            ) { "$path:$line the tower still sends" }
        }
    }

    private fun seen(word: String, rest: String): String = when (word) {
        "lcd" -> "\"${brick.state.glass.text}\""
        "icons" -> brick.state.glass.iconsBesideText.joinToString { it.words }.ifEmpty { "none" }
        "power" -> if (brick.state.poweredOn) "on" else "off"
        "program" -> wordFor(brick.state.run)
        "slot" -> brick.state.selectedSlot.toString()
        "sounds" -> newSounds().joinToString(transform = ::wordsFor).ifEmpty { "none" }
        "says" -> brick.state.explanation ?: "nothing"
        "motors" -> brick.state.motors.joinToString { "${it.mode.name.lowercase()} ${it.power}" }
        "outputs" -> brick.kind.motorPorts.joinToString { brick.motorOutput(it).name.lowercase() }
        "active" -> brick.state.sensors.filter { it.active }.joinToString { it.port.toString() }.ifEmpty { "none" }
        "log" -> brick.log.entries.last().meaning
        "outcome" -> brick.log.entries.last().outcome.name.lowercase().replace('_', ' ')
        "memory" -> memoryLike(rest)
        "sensor" -> brick.state.sensors[rest.first() - '1'].run { "$port = $raw $value ${if (boolean) 1 else 0}" }
        "infrared" -> brick.state.infrared.run { "${range.name.lowercase()} ${if (sending) "sending" else "idle"}" }

        "tower-heard" -> tower.heard.lastOrNull().orEmpty().joinToString(" ", transform = ::byteText).ifEmpty {
            "nothing"
        }

        else -> error("$path:$line says \"$word\", which is no word of scripts")
    }

    private fun compare(statement: String, wanted: String, seen: String) {
        if (seen != wanted) found += "$path:$line should be: $statement\n    but is: $seen"
    }

    private fun newSounds(): List<SoundEvent> = brick.sounds.since(soundsHeard).also {
        soundsHeard = brick.sounds.total
    }

    private fun memoryLike(rest: String): String {
        val (address, bytes) = rest.split(" = ")
        val snapshot = brick.memory()
        return "$address = " +
            bytes.split(' ').indices.joinToString(" ") { byteText(snapshot.byte(numberOf(address) + it)) }
    }

    private companion object {
        val ACTIONS =
            setOf(
                "press",
                "release",
                "push",
                "stop",
                "call",
                "write",
                "measure",
                "battery",
                "mode",
                "value",
                "tower-sends",
            )

        fun numberOf(word: String): Int = if (word.startsWith("0x")) word.drop(2).toInt(radix = 16) else word.toInt()

        fun buttonOf(word: String): BrickButton = BrickButton.valueOf(word.uppercase().replace('-', '_'))

        fun byteText(byte: Int): String = byte.toString(radix = 16).padStart(2, '0')

        fun wordFor(run: RunState): String = when (run) {
            RunState.Idle -> "idle"
            is RunState.Running -> "running"
            is RunState.Ended -> if (run.stopped) "stopped" else "ended"
            is RunState.Failed -> "failed"
        }

        fun wordsFor(event: SoundEvent): String = when (event) {
            is SoundEvent.Tone -> "${(event.hertz + 0.5).toInt()} Hz ${event.durationMilliseconds} ms"
            is SoundEvent.Cut -> "cut"
        }
    }
}

/** The programs that a script can load, by their names in the script. */
private fun scriptedProgram(name: String): RcxProgram = when (name) {
    "endless" -> endlessProgram()
    "short" -> ScriptedProgram(listOf(waiting(100)))

    "driving" -> ScriptedProgram(
        listOf(calling(RomAddress.CONTROL_MOTOR, 0x2000, 1, 7)),
        statusAtEnd = ProgramStatus.Running,
    )

    "failing" -> failing(ProgramFailure("There is nothing to divide by.", sourceLine = 7))

    "throwing" -> failing(
        ProgramFailure("The list has no place 5.", sourceLine = 12, methodNumber = 300, exceptionNumber = 24),
    )

    else -> error("There is no program $name for scripts.")
}

private fun failing(failure: ProgramFailure) = ScriptedProgram(
    listOf(calling(RomAddress.CONTROL_MOTOR, 0x2000, 1, 7), waiting(100)),
    statusAtEnd = ProgramStatus.Failed(failure),
)
