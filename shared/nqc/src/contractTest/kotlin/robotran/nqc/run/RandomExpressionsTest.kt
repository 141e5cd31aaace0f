package robotran.nqc.run

import robotran.legofirmware.image.FirmwareTarget
import kotlin.random.Random
import kotlin.test.Test
import kotlin.test.assertEquals

/** Expressions have the same value on a brick as in theory. */
class RandomExpressionsTest {
    @Test
    fun `expressions are computed right on firmware 2`() = check(FirmwareTarget.RCX2, seed = 1)

    @Test
    fun `expressions are computed right on firmware 1`() = check(FirmwareTarget.RCX, seed = 2)

    private fun check(target: FirmwareTarget, seed: Int) {
        val random = Random(seed)
        repeat(PROGRAMS) {
            val values = listOf("a", "b", "c", "d").associateWith { valueOf(random) }
            val expressions = RandomExpressions(random, values.keys.toList())
            val results = List(RESULTS) { expressions.next(DEPTH) }
            val assignments = results.mapIndexed { index, result -> "    r$index = ${result.text};" }
            val declarations = values.map { "int ${it.key} = ${it.value};" } + results.indices.map { "int r$it;" }
            val source = declarations.joinToString("\n") + "\ntask main()\n{\n${assignments.joinToString("\n")}\n}\n"
            val found = variablesAfter(source, target)
            for ((index, result) in results.withIndex()) {
                assertEquals(result.valueIn(values), found["r$index"], "r$index in $source")
            }
        }
    }

    private fun valueOf(random: Random): Int =
        if (random.nextInt(4) == 0) random.nextInt(-32768, 32768) else random.nextInt(-20, 20)

    private companion object {
        const val PROGRAMS = 150
        const val RESULTS = 6
        const val DEPTH = 4
    }
}
