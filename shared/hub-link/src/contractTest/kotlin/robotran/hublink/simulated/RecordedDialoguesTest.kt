package robotran.hublink.simulated

import kotlinx.coroutines.ExperimentalCoroutinesApi
import kotlinx.coroutines.awaitCancellation
import kotlinx.coroutines.delay
import kotlinx.coroutines.launch
import kotlinx.coroutines.test.TestScope
import kotlinx.coroutines.test.currentTime
import kotlinx.coroutines.test.runTest
import robotran.hublink.HubVersion
import robotran.hublink.bytesOf
import robotran.hublink.frame.Cobs
import robotran.hublink.frame.FrameReader
import robotran.hublink.hexOf
import robotran.hublink.recordedDialogues
import kotlin.test.Test
import kotlin.test.assertEquals
import kotlin.time.Duration
import kotlin.time.Duration.Companion.milliseconds
import kotlin.time.Duration.Companion.seconds

/**
 * The simulated hub answers as the firmware did when these dialogues were recorded: the same answers, the same changes of its
 * status, and what a program prints, as far as it is no text of the REPL.
 */
class RecordedDialoguesTest {
    @Test
    fun `the simulated hub answers as the firmware does`() {
        assertEquals(19, recordedDialogues.size)
        for ((name, text) in recordedDialogues) {
            val lines = text.lines().filter { it.isNotBlank() }.map { it.trim().split(Regex(" +")) }
            runTest { replay(name.removeSuffix(".txt"), lines) }
        }
    }

    @OptIn(ExperimentalCoroutinesApi::class)
    private suspend fun TestScope.replay(name: String, lines: List<List<String>>) {
        val model = SimulatedModel(profile = HubVersion(1, 6), inputBytes = 20)
        val runs = ArrayDeque(PROGRAMS[name].orEmpty())
        val hub = SimulatedHub(backgroundScope, model) { runs.removeFirstOrNull() ?: SimulatedProgram.printing("") }
        val port = SimulatedSerialPort(backgroundScope, hub, WireFaults(longestDelay = Duration.ZERO))
        val heard = mutableListOf<String>()
        backgroundScope.launch {
            val reader = FrameReader()
            while (true) heard += reader.add(port.receive() ?: break).map(::hexOf)
        }
        for ((time, direction, message) in lines) {
            delay(time.toLong() - currentTime)
            if (direction == ">") port.send(Cobs.encode(bytesOf(message)))
            if (direction == "raw>") port.send(bytesOf(message))
        }
        delay(1.milliseconds)
        val recorded = lines.filter { it[1] == "<" }.map { it[2] }
        assertEquals(recorded.filter(::isAnswer), heard.filter(::isAnswer), "$name: answers")
        val statuses = recorded.filter(::isStatus)
        assertEquals(statuses, heard.filter(::isStatus).take(statuses.size), "$name: status")
        if (name in TEXTS_OF_REPL) return
        val printed = textOf(recorded)
        assertEquals(printed, textOf(heard).take(printed.length), "$name: printed")
    }

    private fun isAnswer(message: String) = message.startsWith("01")

    private fun isStatus(message: String) = message.startsWith("0200")

    private fun textOf(messages: List<String>) = messages.filter { it.startsWith("0201") }
        .map { bytesOf(it.drop(4)) }.fold(ByteArray(0), ByteArray::plus).decodeToString()

    private companion object {
        val TEXTS_OF_REPL = setOf("repl-paste", "ctrl-c")

        val START_WAIT_END = SimulatedProgram { host ->
            host.print("start\r\n")
            delay(3.seconds)
            host.print("end\r\n")
        }
        val DRIVE = SimulatedProgram { delay(5.seconds) }

        fun traceback(line: Int, error: String, file: String = "prog.py") =
            "Traceback (most recent call last):\r\n  File \"$file\", line $line, in <module>\r\n$error\r\n"

        /** What the programs of the dialogues do, one for each start that the hub accepts. */
        val PROGRAMS: Map<String, List<SimulatedProgram>> = mapOf(
            "busy-and-stop" to listOf(START_WAIT_END),
            "ctrl-c" to listOf(START_WAIT_END),
            "rubbish" to listOf(
                SimulatedProgram.printing(traceback(2, "TypeError: 'function' object isn't subscriptable")),
            ),
            "error-in-program" to listOf(
                SimulatedProgram.printing("one\r\n" + traceback(2, "ZeroDivisionError: divide by zero")),
            ),
            "stop-endless-loop" to listOf(SimulatedProgram { awaitCancellation() }),
            "program-that-catches-everything" to listOf(
                SimulatedProgram { host ->
                    host.catchEverything("caught\r\n")
                    awaitCancellation()
                },
            ),
            "much-output" to listOf(
                SimulatedProgram.printing((0 until 12).joinToString("") { "line $it with some text\r\n" }),
            ),
            "stdin" to listOf(SimulatedProgram(::echo)),
            "stdin-full-and-interrupt" to listOf(SimulatedProgram { delay(2.seconds) }),
            "unsubscribed" to listOf(SimulatedProgram.printing("one\r\n")),
            "run-again" to listOf(DRIVE, DRIVE, DRIVE),
            "two-modules" to listOf(SimulatedProgram.printing("side 20\r\n".repeat(4))),
            "module-missing" to listOf(
                SimulatedProgram.printing(traceback(1, "ImportError: no module named 'shapes'", "uses_shapes.py")),
            ),
        )

        /** Reads letters until a q, then a line, which the hub echoes. */
        suspend fun echo(host: SimulatedHost) {
            while (true) {
                val letter = host.read().toInt().toChar()
                if (letter == 'q') break
                host.print("got $letter\r\n")
            }
            var line = ""
            while (!line.endsWith('\r')) line += host.read().toInt().toChar()
            host.print("${line.dropLast(1)}\r\nline: ${line.dropLast(1)}\r\n")
        }
    }
}
