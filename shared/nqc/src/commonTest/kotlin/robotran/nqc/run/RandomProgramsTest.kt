package robotran.nqc.run

import robotran.legofirmware.image.FirmwareTarget
import kotlin.random.Random
import kotlin.test.Test
import kotlin.test.assertEquals
import kotlin.test.assertTrue

/** Programs do the same on a brick as in theory. */
class RandomProgramsTest {
    @Test
    fun `programs end with the right values on firmware 2`() = check(FirmwareTarget.RCX2, seed = 5)

    @Test
    fun `programs end with the right values on firmware 1`() = check(FirmwareTarget.RCX, seed = 6)

    private fun check(target: FirmwareTarget, seed: Int) {
        val random = Random(seed)
        val names = listOf("a", "b", "c", "d")
        var changed = 0
        repeat(PROGRAMS) {
            val programs = RandomPrograms(random, names)
            val values = names.associateWith { random.nextInt(-9, 10) }.toMutableMap()
            val declarations = values.map { "int ${it.key} = ${it.value};" }
            val body = programs.block(DEPTH)
            if (programs.counters.size <= MOST_COUNTERS) {
                val before = values.toMap()
                val counters = programs.counters.map { "int $it;" }
                val source = (declarations + counters).joinToString("\n") + "\ntask main()\n${body.text}\n"
                body.run(values)
                val found = variablesAfter(source, target)
                for (name in names) assertEquals(values.getValue(name), found[name], "$name in $source")
                if (before != values) changed++
            }
        }
        assertTrue(changed > PROGRAMS / 2, "$changed programs did something")
    }

    private companion object {
        const val PROGRAMS = 150
        const val DEPTH = 3

        /** So that firmware 1.0 has variables left to compute with. */
        const val MOST_COUNTERS = 15
    }
}
