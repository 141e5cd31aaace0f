package robotran.tinyvm.programs

import robotran.tinyvm.TinyVmResult
import robotran.tinyvm.runMutant
import robotran.tinyvm.testPrograms
import kotlin.random.Random
import kotlin.test.Test
import kotlin.test.assertTrue

class MutatedProgramsTest {
    @Test
    fun `mutants of all test programs never crash hang or confuse the machine`() {
        val random = Random(6)
        val programs = testPrograms.filterValues {
            Expectations.ofRuns(it).none { run -> run.hasErrors }
        }.keys.sorted().filter { link(it) is TinyVmResult.Success }
        val run = programs.sumOf { path ->
            val mainClass = path.substringAfterLast('/').removeSuffix(".java")
            (1..MUTANTS_OF_EACH).count { runMutant(classFilesOf(path), mainClass, random) }
        }
        assertTrue(run > programs.size * MUTANTS_OF_EACH / 20, "only $run mutants were sound enough to run")
    }

    private companion object {
        const val MUTANTS_OF_EACH = 10
    }
}
