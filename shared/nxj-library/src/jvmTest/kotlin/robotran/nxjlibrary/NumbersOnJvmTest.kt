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
    fun `decimal numbers are written as the shortest text that Java reads as the same number`() {
        for (number in decimals) {
            val text = double.call("toString", number) as String
            assertEquals(number.toBits(), text.toDouble().toBits(), text)
            assertTrue(text.length <= number.toString().length, "$text is longer than $number")
            assertEquals(text.contains('E'), number.toString().contains('E'), text)
            val single = number.toFloat()
            val short = float.call("toString", single) as String
            assertEquals(single.toBits(), short.toFloat().toBits(), short)
            assertTrue(short.length <= single.toString().length, "$short is longer than $single")
        }
    }

    @Test
    fun `decimal numbers are read as in Java`() {
        val texts = decimals.map { it.toString() } + List(5000) { randomDecimal() } +
            listOf(
                "1",
                "1.",
                ".5",
                "+1e5",
                "-1E-5",
                "1e400",
                "1e-400",
                "0.1f",
                "3d",
                "  2.5 ",
                "NaN",
                "Infinity",
                "-Infinity",
            )
        for (text in texts) {
            assertEquals(text.toDouble().toBits(), (double.call("parseDouble", text) as Double).toBits(), text)
            assertEquals(text.toFloat().toBits(), (float.call("parseFloat", text) as Float).toBits(), text)
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

    private fun randomDecimal(): String {
        val digits = List(1 + random.nextInt(25)) { random.nextInt(10) }.joinToString("")
        val point = random.nextInt(digits.length + 1)
        return "${digits.take(point)}.${digits.drop(point)}e${random.nextInt(-330, 310)}".let {
            if (it[0] ==
                '.'
            ) {
                "0$it"
            } else {
                it
            }
        }
    }
}
