package robotran.legofirmware.model

/** The number as 16 bits with a sign: what a variable holds. */
internal fun wrapped(number: Int): Int = number.toShort().toInt()

/** abs(-32768) is 32767, as on a brick. */
internal fun absolute(number: Int): Int = if (number < 0) minOf(-number, Short.MAX_VALUE.toInt()) else number
