package robotran.hublink.simulated

import kotlinx.coroutines.CoroutineScope
import kotlinx.coroutines.Job
import kotlinx.coroutines.delay
import kotlinx.coroutines.launch
import robotran.hublink.HubVersion
import kotlin.time.Duration.Companion.seconds

/**
 * A hub with Pybricks behind its connections, as its firmware answers. Its time is that of the coroutines in [scope]: virtual
 * in tests.
 *
 * @param programs what a program does, by its container.
 */
class SimulatedHub(
    private val scope: CoroutineScope,
    val model: SimulatedModel = SimulatedModel(),
    private val programs: (ByteArray) -> SimulatedProgram = { SimulatedProgram.printing("hello\r\n") },
) {
    /** The program in the chosen slot; null if that is empty. */
    var slot: ByteArray? = null

    /** Whether somebody wants events. */
    var isSubscribed = false
        private set

    /** Hears events, without anything in front. */
    var listener: (ByteArray) -> Unit = {}

    val isProgramRunning: Boolean get() = run.isRunning

    private val run = SimulatedRunner(scope, model, print = ::print, changed = ::tellStatus)
    private var download: ByteArray? = null
    private var closing: Job? = null
    private var told: List<Byte>? = null

    /** Gives [command] to the hub. Returns its answer: 0, or the error. */
    fun command(command: ByteArray): Int = when (command.firstOrNull()?.toInt()) {
        0 -> OK.also { run.stop() }
        1 -> start(command.drop(1))
        2 -> if (model.profile < HubVersion(1, 4)) startRepl() else INVALID
        3 -> if (command.size == 5) size(numberAt(command, 1)) else NOT_ALLOWED
        4 -> if (command.size >= 5) bytes(numberAt(command, 1), command.copyOfRange(5, command.size)) else NOT_ALLOWED
        6 -> run.input(command.copyOfRange(1, command.size))
        7 -> if (command.size >= 3) OK else NOT_ALLOWED
        else -> INVALID
    }

    /** Switches the events on, which tells the status, or off. */
    fun subscribe(isOn: Boolean) {
        isSubscribed = isOn
        told = null
        if (isOn) tellStatus()
    }

    /** Somebody presses the button that starts and stops the program. */
    fun pressButton() {
        if (run.isRunning) run.stop() else start(emptyList())
    }

    private fun start(arguments: List<Byte>): Int {
        val program = slot
        val slotOrProgram = arguments.firstOrNull()?.let { it.toInt() and 0xFF } ?: 0
        return when {
            arguments.size > 1 -> NOT_ALLOWED
            run.isRunning -> BUSY
            slotOrProgram == REPL && model.hasRepl -> startRepl()
            slotOrProgram >= maxOf(model.slots, 1) -> INVALID
            program == null || program.size > model.programBytes -> INVALID
            !isLoadable(program) -> NOT_ALLOWED
            else -> OK.also { run.start(programs(program), number = slotOrProgram) }
        }
    }

    private fun startRepl(): Int = OK.also { run.startRepl() }

    private fun size(size: Long): Int {
        val bytes = download
        return when {
            run.isRunning -> BUSY

            size == 0L -> if (bytes != null) DOWNLOAD_STATE else OK.also { open() }

            bytes == null -> DOWNLOAD_STATE

            else -> {
                // What was not sent is whatever the memory holds.
                slot = bytes.copyOf(minOf(size, MOST).toInt())
                close()
                OK
            }
        }
    }

    private fun bytes(offset: Long, bytes: ByteArray): Int {
        val before = download
        val end = offset + bytes.size
        return when {
            run.isRunning -> BUSY

            before == null -> DOWNLOAD_STATE

            end > minOf(model.programBytes, MOST) -> NOT_ALLOWED

            else -> {
                download = before.copyOf(maxOf(before.size, end.toInt())).also { bytes.copyInto(it, offset.toInt()) }
                closeLater()
                OK
            }
        }
    }

    private fun open() {
        slot = null
        download = ByteArray(0)
        closeLater()
        tellStatus()
    }

    private fun close() {
        closing?.cancel()
        download = null
        tellStatus()
    }

    private fun closeLater() {
        closing?.cancel()
        closing = scope.launch {
            delay(1.seconds)
            download = null
            tellStatus()
        }
    }

    /** Only the header of the first module is looked at. */
    private fun isLoadable(program: ByteArray): Boolean {
        val name = (4 until program.size).firstOrNull { program[it] == 0.toByte() } ?: return false
        val mpy = program.drop(name + 1)
        return mpy.size >= 4 && mpy[0] == 'M'.code.toByte() && mpy[1] == 6.toByte() && mpy[3] <= 31
    }

    private fun print(text: ByteArray) {
        if (isSubscribed) listener(byteArrayOf(1) + text)
    }

    /** Tells the status if it has changed. */
    private fun tellStatus() {
        val flags =
            (if (run.isRunning) 1L shl 6 else 0L) or (if (download != null && hasDownloadFlag) 1L shl 13 else 0L)
        val status = byteArrayOf(0) + numberBytes(flags, 4) + run.number.toByte() + 0
        val size = when {
            model.profile < HubVersion(1, 4) -> 5
            model.profile < HubVersion(1, 5) -> 6
            else -> 7
        }
        val event = status.copyOf(size)
        if (!isSubscribed || event.toList() == told) return
        told = event.toList()
        listener(event)
    }

    private val hasDownloadFlag get() = model.profile >= HubVersion(1, 5)

    internal companion object {
        const val OK = 0
        const val DOWNLOAD_STATE = 0x0E
        const val NOT_ALLOWED = 0x13
        const val INVALID = 0x80
        const val BUSY = 0x81
        private const val REPL = 0x80
        private const val MOST = 1_000_000L
    }
}
