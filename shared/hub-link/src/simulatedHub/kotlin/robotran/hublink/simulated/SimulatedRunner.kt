package robotran.hublink.simulated

import kotlinx.coroutines.CoroutineScope
import kotlinx.coroutines.Job
import kotlinx.coroutines.channels.Channel
import kotlinx.coroutines.launch

/** The program that runs on a simulated hub, or its REPL. */
internal class SimulatedRunner(
    private val scope: CoroutineScope,
    private val model: SimulatedModel,
    private val print: (ByteArray) -> Unit,
    private val changed: () -> Unit,
) {
    var isRunning = false
        private set

    /** The program that runs, or ran last. */
    var number = 0
        private set

    private var job: Job? = null
    private var input = Channel<Byte>(Channel.UNLIMITED)
    private var waiting = 0
    private var caughtText: String? = null
    private var isRepl = false
    private var isPasting = false

    fun start(program: SimulatedProgram, number: Int) {
        begin(number)
        isRepl = false
        job = scope.launch {
            program.run(Host())
            end()
        }
    }

    fun startRepl() {
        begin(REPL)
        enterRepl()
    }

    fun stop() {
        val caught = caughtText
        when {
            !isRunning -> Unit

            caught != null -> printText(caught)

            else -> {
                job?.cancel()
                printText(if (isRepl) "\r\nSystemExit: \r\n" else "The program was stopped (SystemExit).\r\n")
                end()
            }
        }
    }

    /** Takes [bytes] as the program's input. */
    fun input(bytes: ByteArray): Int {
        if (!isRunning) return SimulatedHub.OK
        if (waiting + bytes.size > model.inputBytes) return SimulatedHub.BUSY
        for (byte in bytes) if (isRepl) replInput(byte) else programInput(byte)
        return SimulatedHub.OK
    }

    private fun programInput(byte: Byte) {
        if (byte == INTERRUPT) {
            job?.cancel()
            printText("Traceback (most recent call last):\r\nKeyboardInterrupt: \r\n")
            enterRepl()
        } else {
            waiting++
            input.trySend(byte)
        }
    }

    private fun replInput(byte: Byte) {
        when {
            byte == PASTE -> isPasting = true
            byte == END && isPasting -> isPasting = false
            byte == END -> end()
        }
    }

    private fun begin(number: Int) {
        this.number = number
        isRunning = true
        input = Channel(Channel.UNLIMITED)
        waiting = 0
        caughtText = null
        // A program prints after the hub has told that it runs.
        changed()
    }

    private fun enterRepl() {
        isRepl = true
        isPasting = false
    }

    private fun end() {
        isRunning = false
        changed()
    }

    private fun printText(text: String) = print(text.encodeToByteArray())

    private inner class Host : SimulatedHost {
        private val ownInput = input

        override fun print(text: String) = printText(text)

        override suspend fun read(): Byte = ownInput.receive().also { waiting-- }

        override fun catchEverything(text: String) {
            caughtText = text
        }
    }

    private companion object {
        const val REPL = 0x80
        const val INTERRUPT: Byte = 3
        const val END: Byte = 4
        const val PASTE: Byte = 5
    }
}
