package robotran.hublink.simulated

import robotran.hublink.HubVersion

/** What a simulated hub is. */
data class SimulatedModel(
    val name: String = "Pybricks Hub",
    val firmware: String = "4.0.1",
    val profile: HubVersion = HubVersion(1, 5),
    val pnpKind: Int = 0x81,
    val pnpVariant: Int = 0,
    val flags: Int = 0x2B,
    val messageBytes: Int = 512,
    val programBytes: Long = 52_300,
    val slots: Int = 5,
    val inputBytes: Int = 63,
    val hasRepl: Boolean = true,
) {
    /** The value of its capabilities. */
    val capabilities: ByteArray
        get() {
            val all = numberBytes(messageBytes.toLong(), 2) + numberBytes(flags.toLong(), 4) +
                numberBytes(programBytes, 4) + slots.toByte()
            return if (profile < HubVersion(1, 5)) all.copyOf(10) else all
        }

    /** The value of its PnP id. */
    val pnpId: ByteArray
        get() = byteArrayOf(1) + numberBytes(0x0397, 2) + numberBytes(pnpKind.toLong(), 2) +
            numberBytes(pnpVariant.toLong(), 2)
}

/** [number] in [size] bytes, the low one first. */
internal fun numberBytes(number: Long, size: Int): ByteArray = ByteArray(size) { (number shr (it * 8)).toByte() }

/** The four bytes at [place], the low one first. */
internal fun numberAt(bytes: ByteArray, place: Int): Long =
    (0 until 4).sumOf { (bytes[place + it].toLong() and 0xFF) shl (it * 8) }
