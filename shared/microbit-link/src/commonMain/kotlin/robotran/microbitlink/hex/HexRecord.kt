package robotran.microbitlink.hex

import robotran.microbitlink.u16BigEndian
import robotran.microbitlink.u8

/** A line of an Intel hex. */
internal class HexRecord(val address: Int, val type: Int, val data: ByteArray) {
    /** The line, without its end. */
    val text: String = buildString(HEAD_DIGITS + data.size * 2) {
        append(':')
        var sum = 0

        fun byte(value: Int) {
            sum += value
            append(DIGITS[(value shr 4) and 0xF]).append(DIGITS[value and 0xF])
        }
        byte(data.size)
        byte((address shr 8) and 0xFF)
        byte(address and 0xFF)
        byte(type)
        for (place in data.indices) byte(data.u8(place))
        byte(-sum and 0xFF)
    }

    companion object {
        const val DATA = 0
        const val END = 1
        const val SEGMENT = 2
        const val UPPER_ADDRESS = 4

        // The types that the micro:bit adds.
        const val BLOCK_START = 0x0A
        const val BLOCK_END = 0x0B
        const val PADDING = 0x0C
        const val OTHER_DATA = 0x0D

        val FILE_END = HexRecord(0, END, ByteArray(0))

        /** The record that moves the following ones to [address]. */
        fun upperAddress(address: Int): HexRecord =
            HexRecord(0, UPPER_ADDRESS, byteArrayOf((address shr 24).toByte(), (address shr 16).toByte()))

        /** Reads [line], which has no blanks around it; null if it is no sound record. */
        fun read(line: String): HexRecord? {
            if (line.length < HEAD_DIGITS || line.length % 2 == 0 || line[0] != ':') return null
            val bytes = ByteArray(line.length / 2)
            var sum = 0
            for (place in bytes.indices) {
                val high = digit(line[1 + place * 2])
                val low = digit(line[2 + place * 2])
                if (high < 0 || low < 0) return null
                bytes[place] = ((high shl 4) or low).toByte()
                sum += (high shl 4) or low
            }
            val isSound = bytes.u8(0) + FRAME == bytes.size && sum and 0xFF == 0
            return if (!isSound) {
                null
            } else {
                HexRecord(bytes.u16BigEndian(1), bytes.u8(TYPE), bytes.copyOfRange(TYPE + 1, bytes.size - 1))
            }
        }

        private fun digit(letter: Char): Int = when (letter) {
            in '0'..'9' -> letter - '0'
            in 'A'..'F' -> letter - 'A' + DECIMAL_DIGITS
            in 'a'..'f' -> letter - 'a' + DECIMAL_DIGITS
            else -> -1
        }

        private const val DIGITS = "0123456789ABCDEF"
        private const val DECIMAL_DIGITS = 10
        private const val TYPE = 3

        /** The bytes around the data: length, address, type and checksum. */
        private const val FRAME = 5
        private const val HEAD_DIGITS = 1 + FRAME * 2
    }
}
