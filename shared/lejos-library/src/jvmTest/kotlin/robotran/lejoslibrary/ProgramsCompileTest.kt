package robotran.lejoslibrary

import org.apache.bcel.classfile.ClassParser
import kotlin.test.Test
import kotlin.test.assertEquals

class ProgramsCompileTest {
    private val programs = testPrograms + examplePrograms.mapKeys { "examples/${it.key}" }
    private val compilation = BrickCompiler.compile(programs)

    @Test
    fun `the compiler finds the mistakes that the programs name and no others`() {
        val expected = programs.mapValues { linesAfter("// error ", it.value) }.filterValues { it.isNotEmpty() }
        assertEquals(expected, compilation.diagnostics)
    }

    @Test
    fun `a TinyVM refuses the lines that the programs name and no others`() {
        val refused = compilation.classes.filterKeys { !it.contains('/') }.flatMap { (name, bytes) ->
            refusedInstructions(ClassParser(bytes.inputStream(), name).parse()).map { (line, instruction) ->
                "$name $line $instruction"
            }
        }
        val expected = programs.values.flatMap { text ->
            text.lines().mapIndexedNotNull { index, line ->
                Regex("// refused: (\\w+)").find(line)?.let { "${classOf(text)} ${index + 1} ${it.groupValues[1]}" }
            }
        }
        val (withLine, _) = refused.partition { it.substringBefore(' ') !in namedAsAWhole() }
        assertEquals(expected.sorted(), withLine.sorted())
    }

    @Test
    fun `a TinyVM refuses the programs that are too large`() {
        for ((name, instruction) in namedAsAWhole()) {
            val javaClass = ClassParser(compilation.classes.getValue(name).inputStream(), name).parse()
            assertEquals(setOf(instruction), refusedInstructions(javaClass).map { it.second }.toSet(), name)
        }
    }

    private fun namedAsAWhole(): Map<String, String> = programs.values.mapNotNull { text ->
        Regex("// refused (\\w+)").find(text)?.let { classOf(text) to it.groupValues[1] }
    }.toMap()

    private fun classOf(text: String): String = Regex("public class (\\w+)").find(text)!!.groupValues[1]

    private fun linesAfter(mark: String, text: String): Set<Int> =
        text.lines().filter { it.startsWith(mark) }.map { it.removePrefix(mark).trim().toInt() }.toSet()
}
