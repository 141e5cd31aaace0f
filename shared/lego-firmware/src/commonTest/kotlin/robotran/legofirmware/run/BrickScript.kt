package robotran.legofirmware.run

import robotran.brick.controls.BrickButton
import robotran.brick.controls.MotorPort
import robotran.brick.sound.SoundEvent
import robotran.brick.state.RunState
import robotran.language.Language
import robotran.legofirmware.FirmwareProgram
import robotran.legofirmware.assembly.AssemblyResult
import robotran.legofirmware.assembly.assemble
import robotran.legofirmware.image.FirmwareTarget
import robotran.rcxrom.RcxBrick
import robotran.rcxrom.display.LcdIcon
import robotran.rcxrom.infrared.InfraredAir
import robotran.rcxrom.messages.BrickMessages
import kotlin.test.assertEquals
import kotlin.test.assertTrue

/**
 * A program with what happens around it, and what must come of it, in comments such as `; at 10: var 1 = 5`. Run is
 * pressed at millisecond 0, and the first instruction is executed in millisecond 1. At the end, the remarks of the run
 * must be those of all lines `; remark 7: part of the sentence`.
 */
internal class BrickScript(private val name: String, private val source: String) {
    private val air = InfraredAir()
    private val tower = air.placeTower()
    private val target = if ("; target rcx\n" in source) FirmwareTarget.RCX else FirmwareTarget.RCX2
    private val program = assembled()
    private val brick = RcxBrick(listOf(program), air, messages = BrickMessages.of(Language.ENGLISH))
    private var milliseconds = 0
    private var tones = emptyList<SoundEvent.Tone>()

    fun run() {
        brick.press(BrickButton.RUN)
        brick.release(BrickButton.RUN)
        val lines = source.lines().filter { it.startsWith("; at ") }
        assertTrue(lines.any { '=' in it || "over" in it || "runs" in it || "lit" in it }, "$name expects nothing")
        for (line in lines) {
            tickUntil(line.removePrefix("; at ").substringBefore(':').toInt())
            val words = line.substringAfter(": ").split(' ')
            if ('=' in line) check(words, line) else act(words, line)
        }
        val warnings = brick.warnings.map { "${it.sourceLine}: ${it.message}" }
        val expected = source.lines().filter { it.startsWith("; remark ") }.map { it.removePrefix("; remark ") }
        assertEquals(expected.size, warnings.size, "$name: $warnings")
        for (part in expected) {
            val (place, text) = part.split(": ", limit = 2)
            assertTrue(warnings.any { it.startsWith("$place: ") && text in it }, "$name: $part in $warnings")
        }
    }

    private fun assembled(): FirmwareProgram {
        val result = assemble(source, target = target, language = Language.ENGLISH)
        assertTrue(result is AssemblyResult.Success, "$name: ${(result as? AssemblyResult.Failure)?.diagnostics}")
        return FirmwareProgram(name, result.image, result.lines, language = Language.ENGLISH)
    }

    private fun tickUntil(moment: Int) {
        assertTrue(moment >= milliseconds, "$name: $moment is over")
        while (milliseconds < moment) {
            brick.tick()
            tower.tick()
            milliseconds++
        }
    }

    private fun act(words: List<String>, line: String) {
        when (words[0]) {
            "press" -> {
                val button = BrickButton.entries.first { it.label == words[1] }
                brick.press(button)
                brick.release(button)
            }

            "sensor" -> brick.setRawSensorValue(words[1].toInt() - 1, words[2].toInt())
            "battery" -> brick.setBattery(words[1].toInt())
            "hear" -> assertTrue(tower.send(words.drop(1).map { it.toInt(16) }), line)
            "runs" -> assertTrue(brick.state.run is RunState.Running, "$name: $line")
            "over" -> assertEquals<RunState>(RunState.Ended(stopped = false), brick.state.run, "$name: $line")
            "stopped" -> assertEquals<RunState>(RunState.Ended(stopped = true), brick.state.run, "$name: $line")
            "off" -> assertTrue(!brick.state.poweredOn, "$name: $line")
            "lit" -> assertTrue(brick.state.glass.isLit(LcdIcon.valueOf(words[1])), "$name: $line")
            "dark" -> assertTrue(!brick.state.glass.isLit(LcdIcon.valueOf(words[1])), "$name: $line")
            else -> error(line)
        }
    }

    private fun check(words: List<String>, line: String) {
        val state = brick.firmwareState as FirmwareState
        val actual = when (words[0]) {
            "var" -> "${state.variables[words[1].toInt()]}"
            "motor" -> brick.motor(MotorPort.valueOf(words[1])).let { "${it.mode.name.lowercase()} ${it.power}" }
            "display" -> brick.state.screen.text
            "slot" -> "${state.slot}"
            "message" -> "${state.message}"
            "watch" -> "${state.watchMinutes}"
            "tasks" -> state.tasks.joinToString(" ") { "${it.number}" }
            "line" -> "${(brick.state.run as RunState.Running).sourceLine}"
            "datalog" -> state.datalog.joinToString(" ") { it.type.toString(HEX) + ":" + it.value }

            "sensor" -> brick.state.sensors[words[1].toInt() - 1].let {
                "${it.mode} ${it.value} ${if (it.isActive) "powered" else "unpowered"}"
            }

            "tones" -> tonesSoFar()

            "heard" -> tower.heard.joinToString(" ") { packet ->
                packet.joinToString("") { it.toString(16).padStart(2, '0') }
            }

            "range" -> brick.state.infrared.range.name
            "calls" -> brick.log.entries.filter { it.sourceLine == words[1].toInt() }.size.toString()
            else -> error(line)
        }
        assertEquals(line.substringAfter("= "), actual, "$name: $line")
    }

    private fun tonesSoFar(): String {
        tones = brick.sounds.since(0).filterIsInstance<SoundEvent.Tone>().filter { !it.isFirmware }
        return tones.joinToString(" ") { "${(it.hertz + HALF).toInt()}/${it.durationMilliseconds}" }
    }

    private companion object {
        const val HALF = 0.5
        const val HEX = 16
    }
}
