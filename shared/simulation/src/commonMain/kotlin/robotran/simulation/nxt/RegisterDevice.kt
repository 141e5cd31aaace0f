package robotran.simulation.nxt

import robotran.nxt.hardware.I2cDevice

/**
 * A device of 256 registers, which a program reads and writes one after the other.
 *
 * @param version of its firmware, at most 8 letters, as is what follows.
 */
internal abstract class RegisterDevice(version: String, vendor: String, product: String) : I2cDevice {
    private val registers = IntArray(REGISTERS)

    /** From where a program reads. */
    protected var register = 0
        private set

    init {
        put(VERSION, version)
        put(VENDOR, vendor)
        put(PRODUCT, product)
    }

    override val address: Int get() = ADDRESS

    override fun write(data: ByteArray) {
        register = data[0].toInt() and BYTE
        for (index in 1..<data.size) store((register + index - 1) and BYTE, data[index].toInt() and BYTE)
    }

    override fun read(count: Int): ByteArray {
        measure()
        return ByteArray(count) { registers[(register + it) and BYTE].toByte() }
    }

    /** Puts what the device measures into its registers, since a program reads them. */
    protected open fun measure() = Unit

    /** A program writes [value], 0..255, into a register. */
    protected open fun store(register: Int, value: Int) = put(register, value)

    /** The lower eight bits of [value]. */
    protected fun put(register: Int, value: Int) {
        registers[register] = value and BYTE
    }

    /** Sixteen bits, the lower ones first. */
    protected fun putLow(register: Int, value: Int) {
        put(register, value)
        put(register + 1, value shr Byte.SIZE_BITS)
    }

    /** Sixteen bits, the upper ones first. */
    protected fun putHigh(register: Int, value: Int) {
        put(register, value shr Byte.SIZE_BITS)
        put(register + 1, value)
    }

    private fun put(register: Int, text: String) = text.forEachIndexed { index, letter ->
        put(register + index, letter.code)
    }

    companion object {
        const val ADDRESS = 0x02

        /** Where a command goes, or the mode is. */
        const val COMMAND = 0x41

        /** Where most devices have what they measure. */
        const val DATA = 0x42
        const val BYTE = 0xFF
        private const val REGISTERS = 256
        private const val VERSION = 0x00
        private const val VENDOR = 0x08
        private const val PRODUCT = 0x10
    }
}
