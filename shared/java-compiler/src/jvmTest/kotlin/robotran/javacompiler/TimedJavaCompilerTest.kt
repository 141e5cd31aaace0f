package robotran.javacompiler

import kotlinx.coroutines.runBlocking
import robotran.javacompiler.ecj.BrickTarget
import robotran.javacompiler.ecj.Ecj
import robotran.javacompiler.ecj.EcjCompilation
import robotran.javacompiler.messages.JavaMessages
import robotran.language.Language
import robotran.languagesupport.SourceFile
import java.util.concurrent.CountDownLatch
import kotlin.test.Test
import kotlin.test.assertEquals
import kotlin.test.assertFailsWith
import kotlin.test.assertIs
import kotlin.test.assertNull

class TimedJavaCompilerTest {
    private val forever = CountDownLatch(1)
    private val sources = listOf(SourceFile("A.java", "class A {}"))

    @Test
    fun `a compiler that never answers is given up, and the next program has another one`() = runBlocking {
        val compilers = ArrayDeque(listOf(FakeEcj { forever.await() }, FakeEcj { }))
        val compiler = compilerOf(ThreadedEcj(compilers::removeFirst, maxTime = 1))
        assertNull(compiler.compile(sources, emptyMap()))
        val patient = compilerOf(ThreadedEcj({ FakeEcj { } }))
        assertIs<CompilationResult.Success>(patient.compile(sources, emptyMap()))
        assertEquals(emptyList(), compilers, "the one that hangs is not used again")
    }

    @Test
    fun `a compiler that eats all memory is given up`() = runBlocking {
        assertNull(compilerOf(ThreadedEcj({ FakeEcj { throw OutOfMemoryError() } })).compile(sources, emptyMap()))
    }

    @Test
    fun `a bug of the compiler is not hidden`() {
        val compiler = compilerOf(ThreadedEcj({ FakeEcj { error("a bug") } }))
        assertFailsWith<IllegalStateException> { runBlocking { compiler.compile(sources, emptyMap()) } }
    }

    private fun compilerOf(ecj: ThreadedEcj) = TimedJavaCompiler(ecj, JavaMessages.of(Language.ENGLISH))

    private class FakeEcj(private val work: () -> Unit) : Ecj {
        override fun compile(
            sources: List<SourceFile>,
            library: Map<String, ByteArray>,
            gaps: Set<String>,
            target: BrickTarget,
        ): EcjCompilation {
            work()
            return EcjCompilation(emptyMap(), emptyList(), emptyList(), completed = true)
        }
    }
}
