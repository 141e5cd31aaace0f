package robotran.tinyvm.nxj

import kotlinx.coroutines.test.runTest
import robotran.brick.controls.BrickButton
import robotran.language.Language
import robotran.nxjlibrary.NxjLibrary
import robotran.nxt.NxtBrick
import robotran.nxt.messages.NxtMessages
import robotran.tinyvm.NxjProgram
import robotran.tinyvm.NxjResult
import robotran.tinyvm.checkHeap
import robotran.tinyvm.config.TinyVmSpeed
import robotran.tinyvm.linkNxj
import robotran.tinyvm.messages.TinyVmMessages
import robotran.tinyvm.mutated
import robotran.tinyvm.nxjPrograms
import kotlin.random.Random
import kotlin.test.Test
import kotlin.test.assertTrue

class NxjMutantsTest {
    @Test
    fun `mutants of all test programs never crash hang or confuse the machine`() = runTest {
        val library = NxjLibrary.load().classFiles
        val random = Random(7)
        val programs = nxjPrograms.keys.filter { it.substringBefore('/') in setOf("language", "threads") }.sorted()
        val run = programs.sumOf { path ->
            val mainClass = path.substringAfterLast('/').removeSuffix(".java")
            (1..MUTANTS_OF_EACH).count { runMutant(nxjClassFilesOf(path), library, mainClass, random) }
        }
        assertTrue(run > programs.size * MUTANTS_OF_EACH / 20, "only $run mutants were sound enough to run")
    }

    private fun runMutant(
        classes: Map<String, ByteArray>,
        library: Map<String, ByteArray>,
        mainClass: String,
        random: Random,
    ): Boolean {
        val name = classes.keys.random(random)
        val mutant = classes + (name to mutated(classes.getValue(name), random))
        val speed = if (random.nextBoolean()) TinyVmSpeed.UNLIMITED else TinyVmSpeed.BRICK
        val result = linkNxj("mutant", mutant, library, mainClass, TinyVmMessages.of(Language.ENGLISH), speed)
        if (result is NxjResult.Success) run(result.program)
        return result is NxjResult.Success
    }

    private fun run(program: NxjProgram) {
        val brick = NxtBrick(listOf(program), messages = NxtMessages.of(Language.ENGLISH))
        brick.press(BrickButton.ENTER)
        brick.release(BrickButton.ENTER)
        val run = brick.debuggableRun ?: return
        repeat(ROUNDS) { brick.tick() }
        for (thread in run.threads) {
            thread.callStack.indices.take(LOOKED_INTO).forEach { run.variablesOf(thread.number, it) }
        }
        checkHeap(run)
    }

    private companion object {
        const val MUTANTS_OF_EACH = 20
        const val ROUNDS = 40
        const val LOOKED_INTO = 3
    }
}
