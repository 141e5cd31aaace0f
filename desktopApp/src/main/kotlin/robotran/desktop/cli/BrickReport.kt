package robotran.desktop.cli

import robotran.rom.LcdGlass
import robotran.rom.LcdIcon
import robotran.rom.RunState
import robotran.rom.SoundEvent
import robotran.world.Session
import robotran.world.SessionInput

/**
 * The brick at the end of a run, as JSON: `poweredOn`, `program` (the number on the display), `state` (`idle`, `running`, `ended`,
 * `stopped`, `failed`), `line`, `lcd` with the `text` a reader would see and the `icons` that are lit, the `explanation` beside it,
 * `motors`, `sensors`, `batteryMillivolts`, the `sounds` it has played with their milliseconds, at most the newest kept, and the
 * `inputs` that make the same run again.
 */
internal fun brickReport(session: Session): String {
    val brick = session.state.brick
    val motors = brick.motors.map { "\"${it.port.name}\": {\"mode\": ${quoted(it.mode.name.lowercase())}, \"power\": ${it.power}}" }
    val sensors = brick.sensors.map { "{\"port\": ${it.port}, \"raw\": ${it.raw}, \"value\": ${it.value}, \"active\": ${it.active}}" }
    return objectOf(
        "poweredOn" to "${brick.poweredOn}",
        "program" to "${brick.selectedSlot}",
        "state" to quoted(stateName(brick.run)),
        "line" to "${lineOf(brick.run)}",
        "lcd" to lcd(brick.glass),
        "explanation" to (brick.explanation?.let(::quoted) ?: "null"),
        "motors" to motors.joinToString(", ", "{", "}"),
        "sensors" to sensors.joinToString(", ", "[", "]"),
        "batteryMillivolts" to "${brick.batteryMillivolts}",
        "sounds" to lines(session.sounds.since(0).map(::sound)),
        "inputs" to lines(session.inputs.map { "{\"milliseconds\": ${it.milliseconds}, ${input(it.input)}}" }),
    )
}

private fun objectOf(vararg fields: Pair<String, String>): String =
    fields.joinToString(",\n", "{\n", "\n}") { (name, value) -> "    \"$name\": $value" }

private fun lines(items: List<String>): String =
    if (items.isEmpty()) "[]" else items.joinToString(",\n", "[\n", "\n    ]") { "        $it" }

private fun stateName(run: RunState): String = when (run) {
    RunState.Idle -> "idle"
    is RunState.Running -> "running"
    is RunState.Ended -> if (run.stopped) "stopped" else "ended"
    is RunState.Failed -> "failed"
}

private fun lineOf(run: RunState): Int = when (run) {
    RunState.Idle, is RunState.Ended -> 0
    is RunState.Running -> run.sourceLine
    is RunState.Failed -> run.failure.sourceLine
}

private fun lcd(glass: LcdGlass): String {
    val icons = (glass.litIcons - PARTS_OF_THE_TEXT).map { quoted(it.words) }
    return "{\"text\": ${quoted(glass.text)}, \"icons\": ${icons.joinToString(", ", "[", "]")}}"
}

private fun sound(event: SoundEvent): String = when (event) {
    is SoundEvent.Tone -> {
        "{\"milliseconds\": ${event.milliseconds}, \"hertz\": ${event.hertz}, \"duration\": ${event.durationMilliseconds}}"
    }

    is SoundEvent.Cut -> {
        "{\"milliseconds\": ${event.milliseconds}, \"cut\": true}"
    }
}

private fun input(input: SessionInput): String = when (input) {
    is SessionInput.Press -> "\"press\": ${quoted(buttonName(input.button))}"
    is SessionInput.Release -> "\"release\": ${quoted(buttonName(input.button))}"
    SessionInput.Stop -> "\"stop\": true"
}

/** What [LcdGlass.text] tells already. */
private val PARTS_OF_THE_TEXT = setOf(LcdIcon.MINUS, LcdIcon.POINT_1, LcdIcon.POINT_2, LcdIcon.POINT_3)
