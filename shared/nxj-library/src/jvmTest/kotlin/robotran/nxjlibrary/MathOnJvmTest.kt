package robotran.nxjlibrary

import kotlin.random.Random
import kotlin.test.Test
import kotlin.test.assertEquals
import kotlin.test.assertTrue

/** The library's mathematics, held against the JVM's. */
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
    fun `roots and roundings are exactly Java's`() {
        for (x in numbers(3000)) {
            assertSame(StrictMath.sqrt(x), ours.call("sqrt", x), "sqrt($x)")
            assertSame(Math.floor(x), ours.call("floor", x), "floor($x)")
            assertSame(Math.ceil(x), ours.call("ceil", x), "ceil($x)")
            assertSame(Math.rint(x), ours.call("rint", x), "rint($x)")
            assertEquals(Math.round(x), ours.call("round", x), "round($x)")
            assertEquals(Math.round(x.toFloat()), ours.call("round", x.toFloat()), "round(${x}f)")
            assertSame(Math.signum(x), ours.call("signum", x), "signum($x)")
            assertSame(Math.abs(x), ours.call("abs", x), "abs($x)")
            assertSame(Math.nextUp(x), ours.call("nextUp", x), "nextUp($x)")
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
    fun `functions of one number are within two units in the last place of Java's`() {
        val functions = mapOf<String, (Double) -> Double>(
            "sin" to StrictMath::sin,
            "cos" to StrictMath::cos,
            "tan" to StrictMath::tan,
            "asin" to StrictMath::asin,
            "acos" to StrictMath::acos,
            "atan" to StrictMath::atan,
            "exp" to StrictMath::exp,
            "log" to StrictMath::log,
        )
        for (x in numbers(1500)) {
            for ((name, function) in functions) assertNear(function(x), ours.call(name, x), "$name($x)")
        }
    }

    @Test
    fun `functions of two numbers are within two units in the last place of Java's`() {
        for (x in numbers(120)) {
            for (y in special + List(60) { (random.nextDouble() - 0.5) * 20 }) {
                assertNear(StrictMath.pow(x, y), ours.call("pow", x, y), "pow($x, $y)")
                assertNear(StrictMath.atan2(x, y), ours.call("atan2", x, y), "atan2($x, $y)")
            }
        }
    }

    @Test
    fun `degrees and radians are within a unit of Java's`() {
        for (x in numbers(1000)) {
            assertNear(Math.toRadians(x), ours.call("toRadians", x), "toRadians($x)")
            assertNear(Math.toDegrees(x), ours.call("toDegrees", x), "toDegrees($x)")
        }
    }

    private fun assertSame(expected: Double, found: Any?, where: String) =
        assertEquals(expected.toBits(), (found as Double).toBits(), "$where: $expected, not $found")

    private fun assertNear(expected: Double, found: Any?, where: String) {
        val value = found as Double
        val isSame = expected == value || (expected.isNaN() && value.isNaN())
        assertTrue(isSame || Math.abs(expected - value) <= 2 * Math.ulp(expected), "$where: $expected, not $found")
    }
}
