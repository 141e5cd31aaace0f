package robotran.javacompiler

import kotlinx.coroutines.test.runTest
import kotlin.test.Test
import kotlin.test.assertContains
import kotlin.test.assertTrue

/**
 * The compiler computes the same constants on every platform. The numbers here are those that platforms often get
 * wrong.
 */
class ConstantsTest {
    private suspend fun robot(type: String, value: String): ByteArray =
        compiled("class Robot { static $type value = $value; }").classes.getValue("Robot")

    /** Asserts that the class file contains a constant of kind [tag] with [bits], both in hexadecimal. */
    private suspend fun assertBits(type: String, value: String, tag: Int, bits: String) {
        val bytes = robot(type, value).joinToString("") { it.toUByte().toString(16).padStart(2, '0') }
        assertTrue("0$tag$bits" in bytes, "$value is not $bits")
    }

    private suspend fun assertText(expression: String, text: String) =
        assertContains(robot("String", "\"<\" + ($expression) + \">\"").decodeToString(), "<$text>")

    @Test
    fun `floats are the nearest there are`() = runTest {
        val bits = mapOf(
            "0.1f" to "3dcccccd",
            "1.17549435E-38f" to "00800000",
            "3.4028235e38f" to "7f7fffff",
            "1.4e-45f" to "00000001",
            "8388609.5f" to "4b000002",
            "2.5e-40f" to "0002b8e6",
            "1.00000017881393421514957253748434595763683319091796875001f" to "3f800001",
            "5.5f % 0.3f" to "3dccccb0",
        )
        bits.forEach { (value, expected) -> assertBits("float", value, FLOAT, expected) }
    }

    @Test
    fun `doubles are the nearest there are`() = runTest {
        val bits = mapOf(
            "4.9e-324" to "0000000000000001",
            "1.7976931348623157e308" to "7fefffffffffffff",
            "2.2250738585072012e-308" to "0010000000000000",
            "9007199254740993.0" to "4340000000000000",
            "1e23" to "44b52d02c7e14af6",
            "8.41e21" to "447c7e83209e90b2",
            "1.1e-310" to "0000143fcc95c9fc",
            "123456789.123456789" to "419d6f34547e6b75",
            "1e300 % 0.7" to "3fd842746bf971d4",
        )
        bits.forEach { (value, expected) -> assertBits("double", value, DOUBLE, expected) }
    }

    @Test
    fun `numbers become texts with the digits that Java had up to version 18`() = runTest {
        val texts = mapOf(
            "1.0 / 3" to "0.3333333333333333",
            "1.0f / 3" to "0.33333334",
            // Java 19 writes 2.1474836E9, 1.0E23 and 1.2345679E8.
            "2147483647f" to "2.14748365E9",
            "1e23" to "9.999999999999999E22",
            "(float) 123456789L" to "1.23456792E8",
            "4.9e-324" to "4.9E-324",
            "1e7" to "1.0E7",
            "9999999.0" to "9999999.0",
            "0.001f" to "0.001",
            "9.999e-4" to "9.999E-4",
            "0.1 + 0.2" to "0.30000000000000004",
            "-2.5" to "-2.5",
            "-0.0" to "-0.0",
            "1 / 0.0" to "Infinity",
            "0 / 0.0" to "NaN",
            "-2147483648" to "-2147483648",
            "9223372036854775807L" to "9223372036854775807",
            "(int) 1e30" to "2147483647",
            "(long) -1e30f" to "-9223372036854775808",
            "(int) (0 / 0.0)" to "0",
            "(byte) 300.7" to "44",
            "1 << 40" to "256",
            "-5 >>> 28" to "15",
            "-7.5 % 2" to "-1.5",
            "5.5f % 0" to "NaN",
            "5.5 % 0.0" to "NaN",
            "(1 / 0.0) % 2" to "NaN",
            "2.5 % (-1 / 0.0)" to "2.5",
            "-0.0 % 3" to "-0.0",
        )
        texts.forEach { (expression, text) -> assertText(expression, text) }
    }

    private companion object {
        const val FLOAT = 4
        const val DOUBLE = 6
    }
}
