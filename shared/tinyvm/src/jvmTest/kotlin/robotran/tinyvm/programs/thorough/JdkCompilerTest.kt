package robotran.tinyvm.programs.thorough

import robotran.tinyvm.JavaCompiler
import robotran.tinyvm.TinyVmResult
import robotran.tinyvm.programs.Expectations
import robotran.tinyvm.programs.RecordingBrick
import robotran.tinyvm.programs.classFilesOf
import robotran.tinyvm.programs.link
import robotran.tinyvm.testPrograms
import kotlin.test.Test
import kotlin.test.assertEquals
import kotlin.test.assertIs
import kotlin.test.assertTrue

/** Compares Java 8 class files of the JDK's compiler with Java 1.1 class files of ECJ. */
class JdkCompilerTest {
    @Test
    fun `class files of both compilers run alike`() {
        val compared = testPrograms.filterValues(::isForBoth).mapNotNull { (path, source) ->
            compiledByJdk(path, source)?.let { path to compare(path, it, Expectations.ofRuns(source)) }
        }
        assertEquals("", compared.flatMap { it.second }.joinToString("\n"))
        assertTrue(compared.size >= MIN_COMPARED, "only ${compared.size} programs were compared")
    }

    /** Whether neither the compiler nor the machine rejects the program. */
    private fun isForBoth(source: String) = Expectations.ofRuns(source).none { it.hasErrors || it.refused.isNotEmpty() }

    /** Null if the class files need a class of newer Java versions, as some null checks do. */
    private fun compiledByJdk(path: String, source: String): Map<String, ByteArray>? {
        val compilation = JavaCompiler.tryToCompile(mapOf(path.substringAfterLast('/').removeSuffix(".java") to source))
        assertEquals(emptyList(), compilation.errors.filter { "java.util.Objects" !in it }, path)
        return compilation.classes.takeIf { compilation.errors.isEmpty() }
    }

    private fun compare(path: String, byJdk: Map<String, ByteArray>, runs: List<Expectations>): List<String> =
        runs.mapNotNull { expected ->
            val ecj = log(path, classFilesOf(path), expected)
            val jdk = log(path, byJdk, expected)
            val different = ecj.zip(jdk).firstOrNull { it.first != it.second }
            if (ecj == jdk) null else "$path, ${expected.mode}: ${different ?: "${ecj.size} calls and ${jdk.size}"}"
        }

    private fun log(path: String, classes: Map<String, ByteArray>, expected: Expectations): List<String> {
        val program = assertIs<TinyVmResult.Success>(link(path, classes, expected.mode), path).program
        return RecordingBrick(program, expected.events).apply {
            run(expected.runsOnAfter ?: LONGEST)
        }.log.map(::withoutNumbersOfMethods)
    }

    /** Removes method numbers of failures, because they depend on the other content of a class file. */
    private fun withoutNumbersOfMethods(call: String): String =
        if (call.endsWith("firmware")) call.substringBefore(' ') else call

    private companion object {
        const val LONGEST = 60_000L
        const val MIN_COMPARED = 100
    }
}
