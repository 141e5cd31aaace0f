package robotran.microbitlink

/** The byte at [place], 0 to 255. */
internal fun ByteArray.u8(place: Int): Int = this[place].toInt() and 0xFF

/** The two bytes at [place], the low one first. */
internal fun ByteArray.u16(place: Int): Int = u8(place) or (u8(place + 1) shl 8)

/** The four bytes at [place], the low one first. */
internal fun ByteArray.u32(place: Int): Long = u16(place).toLong() or (u16(place + 2).toLong() shl 16)

/** The two bytes at [place], the high one first. */
internal fun ByteArray.u16BigEndian(place: Int): Int = (u8(place) shl 8) or u8(place + 1)

/** [number] in two bytes, the high one first. */
internal fun twoBytesBigEndian(number: Int): ByteArray = byteArrayOf((number shr 8).toByte(), number.toByte())

/** [number] in four bytes, the low one first. */
internal fun fourBytes(number: Int): ByteArray = ByteArray(Int.SIZE_BYTES) { (number shr (it * 8)).toByte() }
