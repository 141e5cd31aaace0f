package robotran.hublink

// Numbers in a hub's messages: the low byte first.

/** The byte at [place], 0 to 255. */
internal fun ByteArray.u8(place: Int): Int = this[place].toInt() and 0xFF

/** The two bytes at [place]. */
internal fun ByteArray.u16(place: Int): Int = u8(place) or (u8(place + 1) shl 8)

/** The four bytes at [place], which may be more than an [Int] has. */
internal fun ByteArray.u32(place: Int): Long = u16(place).toLong() or (u16(place + 2).toLong() shl 16)

/** [number] in four bytes. */
internal fun fourBytes(number: Int): ByteArray = ByteArray(Int.SIZE_BYTES) { (number shr (it * 8)).toByte() }
