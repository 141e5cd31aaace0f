package robotran.robolang

import robotran.brick.program.ProgramFailure
import robotran.brick.program.ProgramStatus
import robotran.nxt.FakeNxt
import robotran.nxt.hardware.NxtColour
import robotran.nxt.program.NxtNative
import robotran.nxt.program.NxtProgram

/** The differences of a run on an NXT from what a test program expects. */
internal fun differencesOnNxt(expected: Expectations, program: NxtProgram): List<String> = buildList {
    val nxt = FakeNxt()
    val failure = runOn(nxt, program, expected)?.let { "${it.sourceLine} ${it.message}" }
    if (failure != expected.failure) add("should fail with ${expected.failure} but does with $failure")
    val calls = nxt.lines.zip(nxt.calls).groupBy({ it.first }, { it.second })
    for ((line, wanted) in expected.nxtCalls) {
        val made = calls[line].orEmpty().map { it.toString() }
        if (made != wanted) add("line $line should call $wanted but calls $made")
    }
    for ((line, texts) in expected.shown) {
        val shown = calls[line].orEmpty().filter { it.native == NxtNative.DRAW_STRING }.map { it.text }
        if (shown != texts) add("line $line should show $texts but shows $shown")
    }
    val end = expected.end
    if (end != null && end != nxt.milliseconds) add("should end at $end but ends at ${nxt.milliseconds}")
}

/** Runs [program] on [nxt] to its end, while its sensors measure what the test program says. */
internal fun runOn(nxt: FakeNxt, program: NxtProgram, expected: Expectations): ProgramFailure? {
    Senses(expected).apply(nxt)
    val run = program.start(nxt)
    repeat(MAX_RESUMES) {
        when (val status = run.resume(STEPS)) {
            ProgramStatus.Running -> Unit
            is ProgramStatus.Paused, is ProgramStatus.ThreadFailed -> throw AssertionError("A pause or a thread.")
            ProgramStatus.Ended -> return null
            is ProgramStatus.Failed -> return status.failure

            is ProgramStatus.Waiting -> while (nxt.milliseconds < status.untilMilliseconds) {
                nxt.advance(1)
                Senses(expected).apply(nxt)
            }
        }
    }
    throw AssertionError("${program.name} does not come to an end")
}

/** What the sensors measure now. */
internal class Senses(private val expected: Expectations) {
    fun apply(nxt: FakeNxt) {
        if (expected.sensors.isEmpty() && expected.senses.isEmpty()) return
        expected.sensors.filter { it.milliseconds <= nxt.milliseconds }.forEach { nxt.analog[it.port - 1] = it.raw }
        nxt.held = 0
        for (sense in expected.senses.filter { it.milliseconds <= nxt.milliseconds }) {
            when (sense.what) {
                "distance" -> for (port in sense.port?.let { listOf(it - 1) } ?: nxt.answers.indices.toList()) {
                    nxt.answers[port] = { message ->
                        if (message.size == 1) byteArrayOf(sense.value.toInt().toByte()) else ByteArray(0)
                    }
                }

                "colour" -> for (port in sense.port?.let { listOf(it - 1) } ?: nxt.colours.indices.toList()) {
                    nxt.colours[port] = COLOURS.getValue(sense.value)
                }

                else -> nxt.held = BUTTONS.getValue(sense.value)
            }
        }
    }

    private companion object {
        val COLOURS = mapOf(
            "red" to NxtColour(red = 900, green = 200, blue = 200, background = 0),
            "white" to NxtColour(red = 900, green = 900, blue = 900, background = 0),
            "black" to NxtColour(red = 50, green = 50, blue = 50, background = 0),
        )
        val BUTTONS = mapOf("none" to 0, "enter" to 1, "left" to 2, "right" to 4, "escape" to 8)
    }
}

private const val STEPS = 1000
private const val MAX_RESUMES = 200_000
