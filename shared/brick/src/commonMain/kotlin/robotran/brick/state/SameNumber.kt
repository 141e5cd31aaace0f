package robotran.brick.state

/** Whether both texts are numbers and equal, apart from extra zeros. */
fun isSameNumber(one: String, other: String): Boolean =
    isNumber(one) && isNumber(other) && withoutIdleZeros(one) == withoutIdleZeros(other)

private fun withoutIdleZeros(number: String): String {
    val minus = if (number.startsWith('-')) "-" else ""
    val whole = number.removePrefix("-").substringBefore('.').trimStart('0').ifEmpty { "0" }
    val decimals = number.substringAfter('.', "").trimEnd('0')
    return minus + whole + if (decimals.isEmpty()) "" else ".$decimals"
}

/** Whether [text] is a number as a display shows it: with a point and a minus, if any. */
fun isNumber(text: String): Boolean = text.matches(NUMBER)

private val NUMBER = Regex("-?[0-9]+(\\.[0-9]+)?")
