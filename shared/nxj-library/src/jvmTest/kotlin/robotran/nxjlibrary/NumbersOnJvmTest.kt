package robotran.nxjlibrary

import kotlin.random.Random
import kotlin.test.Test
import kotlin.test.assertEquals
import kotlin.test.assertFailsWith
import kotlin.test.assertTrue

/** Numbers as text and text as numbers, held against the JVM's. */
class NumbersOnJvmTest {
    private val random = Random(27)
    private val integer = LibraryOnJvm.type("java.lang.Integer")
    private val long = LibraryOnJvm.type("java.lang.Long")
    private val float = LibraryOnJvm.type("java.lang.Float")
    private val double = LibraryOnJvm.type("java.lang.Double")

    private val wholes = listOf(0L, 1L, -1L, 9L, 10L, Long.MAX_VALUE, Long.MIN_VALUE, 0x7FFFFFFFL, -0x80000000L) +
        List(2000) { random.nextLong() shr random.nextInt(64) }

    private val decimals = listOf(
        0.0,
        -0.0,
        1.0,
        0.1,
        100.0,
        1e7,
        9999999.0,
        1e-3,
        9.999e-4,
        1e21,
        4.9e-324,
        2.2250738585072014e-308,
        1.0 / 3,
        Double.MAX_VALUE,
        Double.NaN,
        Double.POSITIVE_INFINITY,
        Double.NEGATIVE_INFINITY,
        2e23,
        9007199254740993.0,
    ) + List(6000) { Double.fromBits(random.nextLong()) } +
        List(6000) { (random.nextInt(2_000_000) - 1_000_000) / 1000.0 }

    @Test
    fun `whole numbers are written and read as in Java`() {
        for (number in wholes) {
            val small = number.toInt()
            assertEquals(small.toString(), integer.call("toString", small))
            assertEquals(Integer.toHexString(small), integer.call("toHexString", small))
            assertEquals(Integer.toBinaryString(small), integer.call("toBinaryString", small))
            assertEquals(small, integer.call("parseInt", small.toString()))
            assertEquals(number.toString(), long.call("toString", number))
            assertEquals(java.lang.Long.toHexString(number), long.call("toHexString", number))
            assertEquals(number, long.call("parseLong", number.toString()))
            for (radix in listOf(2, 7, 16, 36)) {
                assertEquals(Integer.toString(small, radix), integer.call("toString", small, radix))
                assertEquals(small, integer.call("parseInt", Integer.toString(small, radix), radix))
            }
        }
    }

    @Test
    fun `what is no whole number is refused`() {
        for (text in listOf("", "-", "+", "12a", " 1", "1 ", "2147483648", "-2147483649", "1.5", "0x10", "--1")) {
            assertFailsWith<NumberFormatException>(text) { text.toInt() }
            val thrown =
                assertFailsWith<java.lang.reflect.InvocationTargetException>(text) { integer.call("parseInt", text) }
            assertTrue(thrown.targetException is NumberFormatException, text)
        }
    }

    @Test
    fun `decimal numbers are written with at most 15 digits, or 7 of a float, near to the number`() {
        for (number in decimals) {
            val text = double.call("toString", number) as String
            assertDigits(text, 15)
            assertNear(number, text.toDouble(), text)
            assertEquals(number.toString().contains('E'), text.contains('E'), text)
            val single = number.toFloat()
            val short = float.call("toString", single) as String
            assertDigits(short, 7)
            assertNear(single, short.toFloat(), short)
            val hasExponent = single.isFinite() && single != 0f && Math.abs(short.toDouble()) !in 0.001..999999.99
            assertEquals(hasExponent, short.contains('E'), short)
        }
    }

    @Test
    fun `a double with few digits is written as Java writes it`() {
        repeat(5000) {
            val number = random.nextInt(-99_999, 100_000) / 1000.0
            assertEquals(number.toString(), double.call("toString", number))
        }
    }

    @Test
    fun `decimal numbers are read nearly as in Java, and those that were written to nearly the same`() {
        val texts = decimals.map { double.call("toString", it) as String } + List(5000) { randomDecimal() } +
            listOf("1", "1.", ".5", "+1e5", "-1E-5", "1e400", "1e-400", "NaN", "Infinity", "-Infinity")
        for (text in texts) {
            assertNear(text.toDouble(), double.call("parseDouble", text) as Double, text)
            assertNear(text.toFloat(), float.call("parseFloat", text) as Float, text)
        }
    }

    @Test
    fun `what Java reads as a decimal number and leJOS NXJ does not is refused`() {
        for (text in listOf("0.1f", "3d", " 2.5", "2.5 ", "0x1p3", "\t1")) {
            text.toDouble()
            for (type in listOf(double to "parseDouble", float to "parseFloat")) {
                val thrown = assertFailsWith<java.lang.reflect.InvocationTargetException>(text) {
                    type.first.call(type.second, text)
                }
                assertTrue(thrown.targetException is NumberFormatException, text)
            }
        }
    }

    @Test
    fun `decimal numbers are compared and have codes as in Java`() {
        val some = decimals.take(60)
        for (a in some) {
            for (b in some) {
                assertEquals(a.compareTo(b), double.call("compare", a, b), "$a and $b")
                assertEquals(a.toFloat().compareTo(b.toFloat()), float.call("compare", a.toFloat(), b.toFloat()))
            }
            assertEquals(a.hashCode(), LibraryOnJvm.make<Any>("java.lang.Double", a).hashCode(), "$a")
        }
    }

    /** Asserts that [text] has not more than [most] digits that count. */
    private fun assertDigits(text: String, most: Int) {
        val digits = text.substringBefore('E').filter { it.isDigit() }.trimStart('0')
        assertTrue(digits.length <= most, text)
    }

    private fun assertNear(expected: Double, found: Double, text: String) =
        assertNear(expected, found, 2e-14, 1e-300, 1.79769e308, text)

    private fun assertNear(expected: Float, found: Float, text: String) =
        assertNear(expected.toDouble(), found.toDouble(), 2e-6, 1e-37, 3.4e38, text)

    /**
     * Asserts that [found] differs from [expected] by not more than [error] of it, where it has all its bits, and is not
     * so near to the [largest] number that it may be infinite.
     */
    private fun assertNear(
        expected: Double,
        found: Double,
        error: Double,
        smallest: Double,
        largest: Double,
        text: String,
    ) {
        val isSame = expected == found || (expected.isNaN() && found.isNaN())
        val sizes = listOf(Math.abs(expected), Math.abs(found))
        val isAtAnEnd = sizes.all { it < smallest } || sizes.all { it > largest }
        assertTrue(isSame || isAtAnEnd || Math.abs(expected - found) <= error * Math.abs(expected), "$text: $found")
    }

    private fun randomDecimal(): String {
        val first = random.nextInt(1, 10)
        val digits = first.toString() + List(random.nextInt(25)) { random.nextInt(10) }.joinToString("")
        val point = random.nextInt(digits.length + 1)
        return "${digits.take(point)}.${digits.drop(point)}e${random.nextInt(-330, 310)}".let {
            if (it[0] == '.') {
                "0$it"
            } else {
                it
            }
        }
    }
}
