package robotran.simulation.nxt

import robotran.rcxrom.infrared.InfraredAdapter
import robotran.rcxrom.infrared.InfraredRange

/**
 * The link of mindsensors from an NXT to RCXs. It sends messages that are in its memory, called macros: those of the
 * maker, and those that a program writes there. It also sends single bytes, and keeps those that it hears.
 */
internal class RcxLinkDevice(private val adapter: InfraredAdapter) : RegisterDevice("V1.40", "mndsnsrs", "NRLink") {
    private var isRaw = false
    private var toSend = listOf<Int>()

    /** Each begins with its length; the first ones are not where a program reads the name of the device. */
    private val macros = IntArray(MACROS)

    init {
        MAKERS.flatMap { listOf(it.size) + it }.forEachIndexed { place, byte -> macros[FIRST_MACRO + place] = byte }
    }

    override fun write(data: ByteArray) {
        val isRun = data.size > 2 && (data[0].toInt() and BYTE) == COMMAND && data[1].toInt() == RUN
        if (isRun) run(data[2].toInt() and BYTE) else super.write(data)
    }

    override fun read(count: Int): ByteArray {
        val bytes = super.read(count)
        if (register in RECEIVED..<FIRST_OF_PROGRAM) adapter.drop(count)
        return bytes
    }

    override fun tick() = adapter.tick()

    override fun measure() {
        put(LENGTH, adapter.available)
        put(COMMAND, if (adapter.isSending) 1 else 0)
        for (place in 0 until FIRST_OF_PROGRAM - RECEIVED) put(RECEIVED + place, adapter.peek(place) ?: 0)
    }

    override fun store(register: Int, value: Int) {
        when (register) {
            COMMAND -> command(value)

            LENGTH -> {
                adapter.send(toSend.take(value))
                toSend = emptyList()
            }

            in RECEIVED..<FIRST_OF_PROGRAM -> toSend = toSend.take(register - RECEIVED) + value

            in FIRST_OF_PROGRAM..BYTE -> {
                macros[register] = value
                super.store(register, value)
            }
        }
    }

    override fun switchOff() {
        isRaw = false
        adapter.range = InfraredRange.SHORT
        adapter.drop(adapter.available)
    }

    private fun command(value: Int) {
        when (value) {
            FLUSH -> adapter.drop(adapter.available)
            LONG_RANGE -> adapter.range = InfraredRange.LONG
            SHORT_RANGE -> adapter.range = InfraredRange.SHORT
            RAW -> isRaw = true
            ASSEMBLED -> isRaw = false
        }
    }

    private fun run(macro: Int) {
        val bytes = (1..macros[macro]).map { macros[(macro + it) and BYTE] }
        if (isRaw) {
            adapter.send(bytes)
        } else if (bytes.isNotEmpty()) {
            adapter.sendMessage(bytes)
        }
    }

    private companion object {
        // Registers and commands. Source: mindsensors, NRLink-Nx, as leJOS NXJ uses them.
        const val LENGTH = 0x40
        const val RECEIVED = 0x42
        const val MACROS = 256
        const val FIRST_MACRO = 0x01
        const val FIRST_OF_PROGRAM = 0x52
        const val ASSEMBLED = 0x58
        const val FLUSH = 0x46
        const val LONG_RANGE = 0x4C
        const val RUN = 0x52
        const val SHORT_RANGE = 0x53
        const val RAW = 0x55

        const val SET_RANGE = 0x31
        const val POWER_OFF = 0x60
        const val REMOTE = 0xD2

        /** The bits of a remote control for what the macros of the maker do, in their order. */
        val REMOTE_BITS = listOf(
            0x0200,
            0x0400,
            0x0800,
            0x1000,
            0x2000,
            0x4000,
            0x0008,
            0x0040,
            0x0010,
            0x0080,
            0x0020,
            0x0100,
            0x8000,
        )

        /** The range of the RCX, switching it off, then what a remote control has. */
        val MAKERS = listOf(listOf(SET_RANGE, 0), listOf(SET_RANGE, 1), listOf(POWER_OFF)) +
            REMOTE_BITS.map { listOf(REMOTE, it shr Byte.SIZE_BITS, it and BYTE) }
    }
}
