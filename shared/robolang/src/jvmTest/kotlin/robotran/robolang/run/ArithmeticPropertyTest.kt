package robotran.robolang.run

import io.kotest.common.ExperimentalKotest
import io.kotest.core.spec.style.StringSpec
import io.kotest.matchers.shouldBe
import io.kotest.property.Arb
import io.kotest.property.PropTestConfig
import io.kotest.property.arbitrary.arbitrary
import io.kotest.property.arbitrary.int
import io.kotest.property.checkAll
import robotran.language.fuzz.Fuzzing
import robotran.robolang.RecordedCall
import robotran.robolang.RecordingRom
import robotran.robolang.SensorEvent
import robotran.robolang.errorsOf
import robotran.robolang.programOf
import robotran.robolang.runOn
import kotlin.random.Random

@OptIn(ExperimentalKotest::class)
class ArithmeticPropertyTest :
    StringSpec({
        val config = PropTestConfig(iterations = Fuzzing.share(2_000, atLeast = 200))

        "arithmetic is Java's" {
            checkAll(config, expression()) { (text, value) ->
                val rom = RecordingRom()
                val failure =
                    runOn(rom, programOf("var zero = 0\nvar result = $text\nif result == ${value ?: 0}\n  beep\nend"))
                if (value == null) {
                    (failure != null) shouldBe true
                } else {
                    failure shouldBe null
                    rom.calls.size shouldBe 1
                }
            }
        }

        "a small budget does the same at the same times as a large one" {
            checkAll(
                PropTestConfig(iterations = Fuzzing.share(300, atLeast = 30)),
                Arb.int(1, 7),
                Arb.int(0, 400),
                Arb.int(0, 400),
            ) {
                steps,
                left,
                right,
                ->
                errorsOf(BUSY_PROGRAM) shouldBe emptyList()
                val sensors = listOf(
                    SensorEvent(port = 1, milliseconds = left.toLong(), raw = 20),
                    SensorEvent(port = 1, milliseconds = left + 90L, raw = 900),
                    SensorEvent(port = 3, milliseconds = right.toLong(), raw = 20),
                    SensorEvent(port = 3, milliseconds = right + 90L, raw = 900),
                )
                callsOf(sensors, steps) shouldBe callsOf(sensors, 1_000)
            }
        }
    })

private fun callsOf(sensors: List<SensorEvent>, steps: Int): List<RecordedCall> =
    RecordingRom(sensors).also { runOn(it, programOf(BUSY_PROGRAM), steps) }.calls

/** Combines loops, functions that wait, and behaviours. */
private val BUSY_PROGRAM = """
    function pause(n)
      wait n * 10 milliseconds
      return n
    end
    function isHit()
      return right bumper
    end
    var total = 0
    whenever left bumper
      backward 1
      total = total + 100
      show total
    end
    whenever isHit()
      turn left 10
      total = total + pause(3)
    end
    for i from 1 to 6
      forward pause(i)
      total = total + i
      show total
    end
    halt
""".trimIndent()

/** A Robolang expression and its value in Java; null if it divides by zero. */
private fun expression(): Arb<Pair<String, Int?>> = arbitrary { source -> expression(source.random, depth = 4) }

private fun expression(random: Random, depth: Int): Pair<String, Int?> {
    if (depth == 0 || random.nextInt(6) == 0) return number(random)
    val (left, leftValue) = expression(random, depth - 1)
    val (right, rightValue) = expression(random, depth - 1)
    val operator = listOf("+", "-", "*", "/", "mod")[random.nextInt(5)]
    val value = if (leftValue == null || rightValue == null) null else java(operator, leftValue, rightValue)
    return "($left $operator $right)" to value
}

private fun java(operator: String, left: Int, right: Int): Int? = when (operator) {
    "+" -> left + right
    "-" -> left - right
    "*" -> left * right
    "/" -> if (right == 0) null else left / right
    else -> if (right == 0) null else left % right
}

/** Zero is a variable, because a division by a literal 0 does not compile. */
private fun number(random: Random): Pair<String, Int?> {
    val value = if (random.nextBoolean()) random.nextInt(-9, 10) else random.nextInt(-1_000_000_000, 1_000_000_000)
    return (if (value == 0) "zero" else "($value)") to value
}
