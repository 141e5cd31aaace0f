package robotran.javacompiler

import kotlinx.coroutines.test.runTest
import robotran.languagesupport.SourceFile
import kotlin.test.Test
import kotlin.test.assertIs

class LongSourcesTest {
    @Test
    fun `sources as long as they may be are compiled or told about`() = runTest {
        val texts = listOf(
            "int x = 0;\n" + "x = x + 1;\n".repeat(5_000),
            "int x = 0;\n" + "x = y1;\n".repeat(20_000),
            "wrng();\n".repeat(20_000),
            "%&$! ".repeat(30_000),
            "\\u0041 ".repeat(25_000),
            "String s = \"" + "x".repeat(150_000) + "\";",
            "/*" + "*".repeat(150_000),
            "\"" + "\\".repeat(150_000),
            "\"\n".repeat(60_000),
            "long a = 1;" + "a = a % a;\n".repeat(15_000),
        )
        texts.forEach { assertIs<CompilationResult>(compile(program(it))) }
        val files = List(100) {
            SourceFile(
                "Wrong$it.java",
                "class Wrong$it { " + "int f$it() { return lenght; } ".repeat(50) + "}",
            )
        }
        assertIs<CompilationResult.Failure>(compiler().compile(files, library))
    }
}
