package robotran.nxjlibrary

import kotlin.random.Random
import kotlin.test.Test
import kotlin.test.assertEquals
import kotlin.test.assertTrue

/** The library's mathematics, which is that of leJOS NXJ, held against the JVM's. */
class MathOnJvmTest {
    private val ours = LibraryOnJvm.type("java.lang.Math")
    private val random = Random(26)

    private val special = listOf(
        0.0,
        -0.0,
        0.5,
        -0.5,
        1.0,
        -1.0,
        1.5,
        -1.5,
        2.5,
        1e-300,
        4.9e-324,
        -4.9e-324,
        1e300,
        Double.MAX_VALUE,
        Double.NaN,
        Double.POSITIVE_INFINITY,
        Double.NEGATIVE_INFINITY,
        4503599627370495.5,
        9007199254740993.0,
        2147483647.5,
        -2147483648.5,
        9.3e18,
        Math.PI,
        Math.PI / 2,
        0.49999999999999994,
    )

    /** Numbers of all sizes, and of those that programs have. */
    private fun numbers(count: Int) = special + List(count) { Double.fromBits(random.nextLong()) } +
        List(count) { (random.nextDouble() - 0.5) * 2000 } + List(count) { random.nextDouble() * 2 - 1 }

    @Test
    fun `floor, ceil, signs and the next number are exactly Java's`() {
        for (x in numbers(3000)) {
            assertSame(Math.floor(x), ours.call("floor", x), "floor($x)")
            assertSame(Math.ceil(x), ours.call("ceil", x), "ceil($x)")
            assertEquals(Math.round(x.toFloat()), ours.call("round", x.toFloat()), "round(${x}f)")
            assertSame(Math.signum(x), ours.call("signum", x), "signum($x)")
            assertSame(Math.abs(x), ours.call("abs", x), "abs($x)")
            assertSame(Math.nextUp(x), ours.call("nextUp", x), "nextUp($x)")
        }
    }

    @Test
    fun `round adds a half and cuts off, and rint goes away from 0 with a half`() {
        for (x in numbers(3000)) {
            val rounded = if (Math.abs(x) > LARGE) x.toLong() else Math.floor(x + 0.5).toLong()
            assertEquals(rounded, ours.call("round", x), "round($x)")
            val nearest = if (Math.abs(x) > LARGE) x else (if (x < 0) x - 0.5 else x + 0.5).toLong().toDouble()
            assertSame(nearest, ours.call("rint", x), "rint($x)")
        }
    }

    @Test
    fun `minimum and maximum are exactly Java's`() {
        val numbers = numbers(60)
        for (x in numbers) {
            for (y in numbers) {
                assertSame(Math.min(x, y), ours.call("min", x, y), "min($x, $y)")
                assertSame(Math.max(x, y), ours.call("max", x, y), "max($x, $y)")
            }
        }
    }

    @Test
    fun `roots are within a unit in the last place of Java's`() {
        for (x in numbers(3000)) assertNear(StrictMath.sqrt(x), ours.call("sqrt", x), 2.3e-16, "sqrt($x)")
    }

    @Test
    fun `sines and cosines of some turns are right to 13 digits behind the point`() {
        for (x in moderate(3000)) {
            assertEquals(StrictMath.sin(x), ours.call("sin", x) as Double, 1e-13, "sin($x)")
            assertEquals(StrictMath.cos(x), ours.call("cos", x) as Double, 1e-13, "cos($x)")
        }
        val angles = List(3000) { random.nextDouble() * 3 - 1.5 }
        for (x in angles) assertNear(StrictMath.tan(x), ours.call("tan", x), 1e-14, "tan($x)")
    }

    @Test
    fun `angles of sines, cosines and tangents are right to 14 digits`() {
        for (x in numbers(1000)) {
            assertNear(StrictMath.atan(x), ours.call("atan", x), 1e-15, "atan($x)")
            for (y in List(3) { (random.nextDouble() - 0.5) * 20 }) {
                if (x != 0.0) assertNear(StrictMath.atan2(x, y), ours.call("atan2", x, y), 1e-15, "atan2($x, $y)")
            }
        }
        for (x in List(3000) { random.nextDouble() * 2 - 1 }) {
            assertEquals(StrictMath.asin(x), ours.call("asin", x) as Double, 1e-14, "asin($x)")
            assertEquals(StrictMath.acos(x), ours.call("acos", x) as Double, 1e-14, "acos($x)")
        }
    }

    @Test
    fun `logarithms are right to 14 digits, and powers lose as many as the exponent has`() {
        for (x in numbers(2000).filter { it > 0 }) {
            val logarithm = StrictMath.log(x)
            if (logarithm.isInfinite()) continue
            assertEquals(logarithm, ours.call("log", x) as Double, 1e-15 * maxOf(1.0, Math.abs(logarithm)), "log($x)")
        }
        for (x in List(3000) { random.nextDouble() * 40 - 20 }) {
            assertNear(StrictMath.exp(x), ours.call("exp", x), 1e-14, "exp($x)")
            val base = random.nextDouble() * 10
            assertNear(StrictMath.pow(base, x), ours.call("pow", base, x), 1e-12, "pow($base, $x)")
        }
    }

    @Test
    fun `degrees and radians are within a unit of Java's`() {
        for (x in moderate(1000)) {
            assertNear(Math.toRadians(x), ours.call("toRadians", x), 3e-16, "toRadians($x)")
            assertNear(Math.toDegrees(x), ours.call("toDegrees", x), 3e-16, "toDegrees($x)")
        }
    }

    private fun moderate(count: Int) = List(count) { (random.nextDouble() - 0.5) * 2000 }

    private fun assertSame(expected: Double, found: Any?, where: String) =
        assertEquals(expected.toBits(), (found as Double).toBits(), "$where: $expected, not $found")

    /** Asserts that the values are equal but for [error] times their size, where they have all their bits. */
    private fun assertNear(expected: Double, found: Any?, error: Double, where: String) {
        val value = found as Double
        val isSame = expected == value || (expected.isNaN() && value.isNaN())
        val isNear = Math.abs(expected - value) <= error * maxOf(Math.abs(expected), SMALLEST)
        assertTrue(isSame || isNear, "$where: $expected, not $found")
    }

    private companion object {
        /** From here on, a half cannot be added to a number that a long can hold. */
        const val LARGE = 4611686018427387904.0

        /** Numbers below this may lack bits. */
        const val SMALLEST = 1e-292
    }
}
