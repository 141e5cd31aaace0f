package robotran.programs

import kotlinx.coroutines.test.runTest
import robotran.brick.kind.BrickKind
import robotran.javacompiler.CompilationResult
import robotran.javacompiler.ecj.BrickTarget
import robotran.javacompiler.loadJavaCompiler
import robotran.javacompiler.messages.JavaMessages
import robotran.language.Language
import robotran.language.ProgramLanguage
import robotran.languagesupport.SourceFile
import robotran.nxjlibrary.NxjLibrary
import robotran.tinyvm.config.TinyVmMode
import kotlin.test.Test
import kotlin.test.assertContains
import kotlin.test.assertEquals
import kotlin.test.assertIs
import kotlin.test.assertTrue

/** True to the brick, a program for an NXT uses only what leJOS NXJ has; if forgiving, it may use more. */
class NxjModesTest {
    private val compilers = TinyVmMode.entries.associateWith {
        ProgramCompiler(testTarget, JavaSettings(it), language = Language.ENGLISH).forTarget(nxtTestTarget)
    }

    private val modern = """
        import java.util.LinkedList;
        import lejos.nxt.LCD;

        public class Modern {
            public static void main(String[] args) {
                LinkedList<Integer> list = new LinkedList<Integer>();
                list.addLast(3);
                LCD.drawInt(list.getFirst(), 0, 0);
            }
        }
    """.trimIndent()

    private fun java(name: String, text: String) = Program(name, ProgramLanguage.JAVA, text)

    @Test
    fun `what leJOS NXJ lacks is refused true to the brick, and accepted if forgiving`() = runTest {
        val refused = compilers.getValue(TinyVmMode.BRICK).compileOrThrow(java("Modern.java", modern))
        val errors = assertIs<ProgramResult.Failure>(refused).diagnostics
        assertEquals(listOf(7, 8), errors.map { it.range?.line })
        assertContains(errors.first().message, "Write list.add(element).")
        assertIs<ProgramResult.Success>(
            compilers.getValue(TinyVmMode.FORGIVING).compileOrThrow(java("Modern.java", modern)),
        )
    }

    @Test
    fun `it is refused in class files of another compiler, too`() = runTest {
        val library = NxjLibrary.load().classFiles
        val sources = listOf(SourceFile("Modern.java", modern))
        val compiled = loadJavaCompiler(
            messages = JavaMessages.of(Language.ENGLISH),
        ).compile(sources, library, target = BrickTarget.LEJOS_NXJ)
        val classes = assertIs<CompilationResult.Success>(compiled).classes
        val source = ProgramSource.CompiledClasses("Modern.class", classes)
        val refused = assertIs<ProgramResult.Failure>(
            compilers.getValue(TinyVmMode.BRICK).compileOrThrow(source),
        ).diagnostics
        assertEquals(listOf("Modern.main" to 7, "Modern.main" to 8), refused.map { it.file to it.range?.line })
        assertContains(refused.last().message, "\"LinkedList\" has no method \"getFirst\". Write list.get(0).")
        assertIs<ProgramResult.Success>(compilers.getValue(TinyVmMode.FORGIVING).compileOrThrow(source))
    }

    @Test
    fun `examples, solutions and documented programs compile in both modes`() = runTest {
        val programs = nxjExamples + solutions.filterKeys { it.endsWith(".java") } +
            documentedNxjPrograms.mapKeys { (place, _) -> "$place.java" }
        val forNxt = programs.map { (path, text) -> java(path.replace(':', '/'), text) }
            .filter { brickOf(it) != BrickKind.RCX }
        assertTrue(forNxt.size > 20, "${forNxt.size} programs")
        for ((mode, compiler) in compilers) {
            for (program in forNxt) {
                val named = java("${mainClassOf(program)}.java", program.files.single().text)
                assertIs<ProgramResult.Success>(compiler.compileOrThrow(named), "$mode ${program.name}")
            }
        }
    }

    private fun mainClassOf(program: Program) = checkNotNull(MAIN_CLASS.find(program.files.single().text)) {
        program.name
    }.groupValues.drop(1).first { it.isNotEmpty() }

    private companion object {
        val MAIN_CLASS = Regex("public (?:final )?class (\\w+)|class (\\w+)")
    }
}
