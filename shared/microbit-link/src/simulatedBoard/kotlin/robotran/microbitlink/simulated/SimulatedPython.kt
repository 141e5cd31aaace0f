package robotran.microbitlink.simulated

import robotran.microbitlink.ImageResult
import robotran.microbitlink.files.MAIN_FILE
import robotran.microbitlink.hex.HexMemory
import robotran.microbitlink.image.MicroPythonImage

/**
 * A MicroPython that understands what the app says to it: its two prompts, and the lines that write and read a file.
 *
 * @param memory what the flash holds, where files and MicroPython itself are.
 * @param keep puts a changed flash back.
 */
class SimulatedPython(memory: HexMemory, private val keep: (HexMemory) -> Unit) {
    private enum class Mode { RUNNING, FRIENDLY, RAW }

    private var image = MicroPythonImage.of(memory)
    private var mode = Mode.RUNNING
    private val input = mutableListOf<Byte>()
    private val output = ArrayDeque<Byte>()
    private val file = SimulatedFile { write(it) }

    /** Whether the program that runs lets itself be interrupted. */
    var isInterruptible = true

    /** Whether a program runs, and not a prompt. */
    val isRunning: Boolean get() = mode == Mode.RUNNING

    /** The files of the board. */
    val files: Map<String, ByteArray>
        get() = (image?.files() as? ImageResult.Success)?.value.orEmpty()

    /** Starts with what the flash holds. */
    fun start(memory: HexMemory) {
        image = MicroPythonImage.of(memory)
        mode = Mode.RUNNING
        input.clear()
        output.clear()
    }

    /** The program prints [text]. What does not fit into the buffer is lost. */
    fun print(text: String) {
        output.addAll(text.encodeToByteArray().take(BUFFER - output.size))
    }

    /** At most [count] bytes of what was printed. */
    fun take(count: Int): ByteArray = ByteArray(minOf(count, output.size)) { output.removeFirst() }

    fun hear(byte: Byte) {
        if (image == null) return
        when (mode) {
            Mode.RUNNING -> if (byte == INTERRUPT && isInterruptible) {
                mode = Mode.FRIENDLY
                print(
                    "Traceback (most recent call last):\r\n  File \"main.py\", line 3, in <module>\r\nKeyboardInterrupt: \r\n",
                )
                print(FRIENDLY_BANNER)
            }

            Mode.FRIENDLY -> hearFriendly(byte)

            Mode.RAW -> hearRaw(byte)
        }
    }

    private fun hearFriendly(byte: Byte) {
        when (byte) {
            RAW -> enterRaw()

            END -> {
                print("MPY: soft reboot\r\n")
                mode = Mode.RUNNING
            }

            FRIENDLY -> print(FRIENDLY_BANNER)
            RETURN, INTERRUPT -> print("\r\n>>> ")
        }
    }

    private fun hearRaw(byte: Byte) {
        when (byte) {
            RAW -> enterRaw()

            FRIENDLY -> {
                mode = Mode.FRIENDLY
                print(FRIENDLY_BANNER)
            }

            INTERRUPT -> input.clear()
            END -> run()
            else -> input += byte
        }
    }

    private fun enterRaw() {
        mode = Mode.RAW
        input.clear()
        print("raw REPL; CTRL-B to exit\r\n>")
    }

    private fun run() {
        val lines = input.toByteArray().decodeToString()
        input.clear()
        if (lines.isEmpty()) {
            print("OK\r\nMPY: soft reboot\r\n")
            file.forget()
            enterRaw()
            return
        }
        val (said, error) = file.run(lines.trim(), files)
        print("OK$said\u0004$error\u0004>")
    }

    /** Writes [changed] to the flash; false if there is no room. */
    private fun write(changed: Map<String, ByteArray>): Boolean {
        val whole = changed.filterValues { it.isNotEmpty() }
        val old = image ?: return false
        val filled = if (whole.isEmpty()) {
            old.clean
        } else {
            (old.withFiles(whole) as? ImageResult.Success)?.value
                ?: return false
        }
        image = filled
        keep(filled.memory)
        return true
    }

    /** What [MAIN_FILE] holds; null if there is none. */
    val main: String? get() = files[MAIN_FILE]?.decodeToString()

    private companion object {
        const val RAW: Byte = 0x01
        const val FRIENDLY: Byte = 0x02
        const val INTERRUPT: Byte = 0x03
        const val END: Byte = 0x04
        const val RETURN: Byte = 0x0D
        const val BUFFER = 512
        const val FRIENDLY_BANNER = "MicroPython v1.18; micro:bit with nRF52833\r\n>>> "
    }
}
