package robotran.robolang.run

import io.kotest.common.ExperimentalKotest
import io.kotest.core.spec.style.StringSpec
import io.kotest.matchers.doubles.plusOrMinus
import io.kotest.matchers.shouldBe
import io.kotest.property.Arb
import io.kotest.property.PropTestConfig
import io.kotest.property.arbitrary.int
import io.kotest.property.arbitrary.numericFloat
import io.kotest.property.checkAll
import robotran.language.fuzz.Fuzzing
import kotlin.math.abs
import kotlin.math.atan2
import kotlin.math.ceil
import kotlin.math.cos
import kotlin.math.floor
import kotlin.math.pow
import kotlin.math.sin

@OptIn(ExperimentalKotest::class)
class DecimalMathPropertyTest :
    StringSpec({
        val config = PropTestConfig(iterations = Fuzzing.share(20_000))
        val angles = Arb.numericFloat(-100_000f, 100_000f)

        "sine and cosine are right to 3e-7" {
            checkAll(config, angles) { angle ->
                DecimalMath.sine(angle).toDouble() shouldBe (sin(Math.toRadians(angle.toDouble())) plusOrMinus 3e-7)
                DecimalMath.cosine(angle).toDouble() shouldBe (cos(Math.toRadians(angle.toDouble())) plusOrMinus 3e-7)
            }
        }

        "the direction of a point is right to 3e-5 degrees" {
            checkAll(config, Arb.numericFloat(-1_000f, 1_000f), Arb.numericFloat(-1_000f, 1_000f)) { y, x ->
                if (x != 0f || y != 0f) {
                    val expected = Math.toDegrees(atan2(y.toDouble(), x.toDouble()))
                    val difference = abs(DecimalMath.direction(y, x) - expected)
                    minOf(difference, abs(difference - 360)) shouldBe (0.0 plusOrMinus 3e-5)
                }
            }
        }

        "a power is right to 2e-5 of its value" {
            checkAll(config, Arb.numericFloat(0.001f, 1_000f), Arb.numericFloat(-3f, 3f)) { base, exponent ->
                val expected = base.toDouble().pow(exponent.toDouble())
                DecimalMath.power(base, exponent) / expected shouldBe (1.0 plusOrMinus 2e-5)
            }
        }

        "a whole power is right to 2e-5 of its value" {
            checkAll(config, Arb.numericFloat(-20f, 20f), Arb.int(-6, 6)) { base, exponent ->
                if (abs(base) > 0.1f) {
                    val expected = base.toDouble().pow(exponent)
                    DecimalMath.power(base, exponent.toFloat()) / expected shouldBe (1.0 plusOrMinus 2e-5)
                }
            }
        }

        "numbers are rounded as Java does" {
            checkAll(config, Arb.numericFloat(-100_000f, 100_000f)) { value ->
                roundToWhole(value) shouldBe Math.round(value)
                floorToWhole(value) shouldBe floor(value.toDouble()).toInt()
                ceilToWhole(value) shouldBe ceil(value.toDouble()).toInt()
            }
        }

        "the text of a decimal number is that number to seven digits" {
            checkAll(config, Arb.numericFloat(-1e30f, 1e30f)) { value ->
                if (value != 0f) decimalText(value).toDouble() / value shouldBe (1.0 plusOrMinus 1e-6)
            }
            checkAll(config, Arb.numericFloat(-1_000f, 1_000f)) { value ->
                if (abs(value) > 1e-30f) decimalText(value).toDouble() / value shouldBe (1.0 plusOrMinus 1e-6)
            }
        }
    })
