package robotran.robolang.python.microbit.thorough

import robotran.robolang.examplePrograms
import robotran.robolang.lessonPrograms
import robotran.robolang.python.MicroPython
import robotran.robolang.python.microbit.MicrobitRunTest
import robotran.robolang.python.microbit.allBuggies
import robotran.robolang.python.microbit.runOnBuggy
import kotlin.test.Test
import kotlin.test.assertTrue

/** All examples and solutions on all buggies, in a real MicroPython. */
class EveryBuggyRunTest {
    @Test
    fun `examples and solutions make the calls of the interpreter on each buggy`() {
        if (!MicroPython.isHere) return println("MicroPython is not on this machine: not run.")
        val runs = allBuggies.keys.sumOf {
            runOnBuggy(it, examplePrograms + lessonPrograms, MicrobitRunTest.KNOWN.keys)
        }
        println("$runs programs on ${allBuggies.size} buggies")
        assertTrue(runs > allBuggies.size * 10, "only $runs")
    }
}
