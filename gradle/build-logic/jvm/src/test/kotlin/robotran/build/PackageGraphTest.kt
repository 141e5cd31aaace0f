package robotran.build

import kotlin.test.Test
import kotlin.test.assertEquals
import kotlin.test.assertTrue

class PackageGraphTest {
    private fun cycles(vararg files: Pair<String, String>) = PackageGraph(
        files.map { (name, imports) ->
            val folder = if ("Test" in name) "src/commonTest/kotlin" else "src/commonMain/kotlin"
            val text =
                "package ${name.substringBeforeLast('.')}\n\n" +
                    imports.split(" ").joinToString("") { "import $it\n" }
            SourceFile("shared/a/$folder/${name.substringAfterLast('.')}.kt", text)
        },
    ).cycles()

    @Test
    fun `packages that use each other over a third are a cycle`() {
        val edges = arrayOf(
            "a.One" to "a.b.Two",
            "a.b.Two" to "a.c.three",
            "a.c.Three" to "a.One.Inner",
            "a.d.Four" to "a.One a.b.Two",
        )
        val cycle = cycles(*edges).single()
        assertTrue(cycle.startsWith("packages in a cycle: a, a.b, a.c\n"), cycle)
        assertTrue("a.c imports a in shared/a/src/commonMain/kotlin/Three.kt" in cycle, cycle)
    }

    @Test
    fun `packages in one direction are no cycle, nor are generated ones and tests`() {
        assertEquals(
            emptyList(),
            cycles(
                "a.One" to "a.b.Two a.resources.Res a.strings.*",
                "a.b.Two" to "kotlin.math.sqrt",
                "a.b.TwoTest" to "a.One",
            ),
        )
    }
}
