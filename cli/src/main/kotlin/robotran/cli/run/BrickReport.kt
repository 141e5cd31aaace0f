package robotran.cli.run

import kotlinx.serialization.json.JsonArray
import kotlinx.serialization.json.JsonObject
import kotlinx.serialization.json.JsonPrimitive
import kotlinx.serialization.json.buildJsonObject
import kotlinx.serialization.json.put
import robotran.brick.controls.MotorState
import robotran.brick.sound.SoundEvent
import robotran.brick.state.InputReading
import robotran.brick.state.RunState
import robotran.cli.console.jsonOutput
import robotran.legofirmware.run.FirmwareState
import robotran.nxt.hardware.SensorPortState
import robotran.projects.elementOf
import robotran.rcxrom.display.LcdGlass
import robotran.rcxrom.sensors.SensorState
import robotran.rcxrom.state.RcxState
import robotran.simulation.Session

/**
 * The brick at the end of a run, as JSON: `poweredOn`, `program` (the number on the display), `state` (`idle`,
 * `running`, `ended`, `stopped`, `failed`), `line`, `lcd` with the displayed `text` and the lit `icons`, its
 * `explanation`, `motors`, `sensors`, `batteryMillivolts`, the latest `sounds` with their times in milliseconds, and
 * the `inputs` that reproduce the run, in the format of project files. An NXT has the lines of its `screen`, after the end as
 * the program left them, instead of `lcd`, and the `degrees` of its motors; a sound has a `volume` if it is not full. LEGO's
 * own `firmware` tells its 32 `variables`, `timers` in tenths of a second, the last `message` and the `datalog`.
 */
internal fun brickReport(session: Session): String {
    val brick = session.state.brick
    val report =
        buildJsonObject {
            put("poweredOn", brick.poweredOn)
            put("program", brick.selectedSlot)
            put("state", stateName(brick.run))
            put("line", lineOf(brick.run))
            when (brick) {
                is RcxState -> put("lcd", json(brick.glass))
                else -> put("screen", JsonArray((brick.leftByProgram ?: brick.screen).lines.map(::JsonPrimitive)))
            }
            put("explanation", brick.explanation)
            put(
                "motors",
                JsonObject(
                    brick.motors.associate { it.port.name to json(it, brick.motorDegrees.getOrNull(it.port.ordinal)) },
                ),
            )
            put("sensors", JsonArray(brick.inputs.map(::json)))
            put("batteryMillivolts", brick.batteryMillivolts)
            (session.firmwareState() as? FirmwareState)?.let { put("firmware", json(it)) }
            put("sounds", JsonArray(session.sounds.since(0).map(::json)))
            put("inputs", JsonArray(session.inputs.map { elementOf(it, session.world) }))
        }
    return jsonOutput.encodeToString(JsonObject.serializer(), report)
}

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

private fun json(glass: LcdGlass): JsonObject = buildJsonObject {
    put("text", glass.text)
    put("icons", JsonArray(glass.iconsBesideText.map { JsonPrimitive(it.words) }))
}

/** @param degrees what the motor's counter says; null if it has none. */
private fun json(motor: MotorState, degrees: Int?): JsonObject = buildJsonObject {
    put("mode", motor.mode.name.lowercase())
    put("power", motor.power)
    degrees?.let { put("degrees", it) }
}

private fun json(input: InputReading): JsonObject = buildJsonObject {
    put("port", input.port)
    when (input) {
        is SensorState -> put("raw", input.raw)
        is SensorPortState -> put("raw", input.raw)
    }
    put("value", input.value)
    put("active", input.isActive)
}

private fun json(firmware: FirmwareState): JsonObject = buildJsonObject {
    put("variables", JsonArray(firmware.variables.map(::JsonPrimitive)))
    put("timers", JsonArray(firmware.timers.map { JsonPrimitive(it / HUNDREDTHS_IN_A_TENTH) }))
    put("message", firmware.message)
    put("datalog", JsonArray(firmware.datalog.map { JsonPrimitive(it.value) }))
}

private fun json(event: SoundEvent): JsonObject = buildJsonObject {
    put("milliseconds", event.milliseconds)
    when (event) {
        is SoundEvent.Tone -> {
            put("hertz", event.hertz)
            put("duration", event.durationMilliseconds)
            if (event.volume != FULL_VOLUME) put("volume", event.volume)
        }

        is SoundEvent.Cut -> put("cut", true)
    }
}

private const val FULL_VOLUME = 100
private const val HUNDREDTHS_IN_A_TENTH = 10
