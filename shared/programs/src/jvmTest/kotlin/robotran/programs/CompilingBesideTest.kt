package robotran.programs

import kotlinx.coroutines.CoroutineStart
import kotlinx.coroutines.async
import kotlinx.coroutines.runBlocking
import robotran.language.Language
import robotran.language.ProgramLanguage
import kotlin.test.Test
import kotlin.test.assertTrue

/** Who waits for Java to be compiled can go on meanwhile, for as long as it takes. */
class CompilingBesideTest {
    private val compiler = ProgramCompiler(testTarget, language = Language.ENGLISH)
    private val robolang = Program("square.robo", ProgramLanguage.ROBOLANG, "forward 10\n")
    private val java = Program(
        "Hello.java",
        ProgramLanguage.JAVA,
        "class Hello { public static void main(String[] args) { } }",
    )

    /** A caller that the machine keeps from going on may find the program compiled, so it may try again. */
    private fun leavesTheCallerFree(compile: suspend () -> Any) =
        assertTrue((1..TRIES).any { goesOnMeanwhile(compile) }, "The caller has waited each time.")

    private fun goesOnMeanwhile(compile: suspend () -> Any): Boolean = runBlocking {
        var isCompiled = false
        val compiling = async(start = CoroutineStart.UNDISPATCHED) { compile().also { isCompiled = true } }
        val goesOn = !isCompiled
        compiling.await()
        goesOn
    }

    @Test
    fun `images of Java and of the Java that Robolang becomes`() {
        leavesTheCallerFree { compiler.buildImage(listOf(java)) }
        leavesTheCallerFree { compiler.buildImage(listOf(robolang)) }
    }

    @Test
    fun `programs, and what the Java of a Robolang program would be`() {
        leavesTheCallerFree { compiler.compile(java) }
        leavesTheCallerFree { compiler.compileTranslation(robolang) }
    }

    private companion object {
        const val TRIES = 20
    }
}
