package robotran.javacompiler

import kotlinx.coroutines.test.runTest
import robotran.language.source.SourceRange
import robotran.languagesupport.SourceFile
import kotlin.test.Test
import kotlin.test.assertEquals

class RangeTest {
    private suspend fun place(text: String) = diagnostics(text).first().let { it.range to it.text }

    @Test
    fun `a tab is one column`() = runTest {
        assertEquals(SourceRange(2, 2, 5) to "Foo", place("class Robot {\n\tFoo foo;\n}"))
    }

    @Test
    fun `every kind of line end ends one line`() = runTest {
        assertEquals(SourceRange(4, 1, 4) to "Foo", place("class Robot {\r\n\r\n\r\nFoo foo;\r\n}"))
        assertEquals(SourceRange(4, 1, 4) to "Foo", place("class Robot {\r\r\rFoo foo;\r}"))
        assertEquals(SourceRange(3, 1, 4) to "Foo", place("class Robot {\n\r\nFoo foo;\n}"))
    }

    @Test
    fun `columns count UTF-16 characters`() = runTest {
        assertEquals(SourceRange(2, 9, 12) to "Foo", place("class Robot {\n/*\uD83D\uDE00*/  Foo foo;\n}"))
    }

    @Test
    fun `mistakes come in the order of the sources`() = runTest {
        val other = SourceFile("Other.java", "class Other {\nA a;\n}")
        val found = diagnostics("class Robot {\nC c;\nB b;\n}", other)
        assertEquals(
            listOf("Robot.java" to 2, "Robot.java" to 3, "Other.java" to 2),
            found.map {
                it.file to
                    it.range?.line
            },
        )
    }
}
