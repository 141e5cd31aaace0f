package robotran.programs

import kotlinx.coroutines.test.runTest
import robotran.language.Language
import robotran.language.ProgramLanguage
import robotran.lejoslinker.LejosImage
import robotran.tinyvm.config.LejosVersion
import kotlin.test.Test
import kotlin.test.assertContains
import kotlin.test.assertEquals
import kotlin.test.assertTrue
import kotlin.time.Duration.Companion.minutes

/** All programs of the tree fit a real brick. */
class EveryProgramLinksTest {
    private val compiler = ProgramCompiler(testTarget, language = Language.ENGLISH)

    @Test
    fun `every example and every solution becomes an image for both versions of leJOS`() =
        runTest(timeout = 5.minutes) {
            val programs =
                robolangExamples + lejosExamples +
                    solutions.filterKeys { !FOR_OTHERS.any(it::startsWith) && !it.endsWith(".nqc") }
            assertTrue(programs.size > 50, "${programs.size}")
            for (version in LejosVersion.entries) {
                val refused = programs.mapNotNull { (name, text) -> refusalOf(name, text, version) }
                assertEquals(
                    NOT_IN_2_1.takeIf {
                        version == LejosVersion.V2_1
                    }.orEmpty(),
                    refused.map { it.substringBefore(':') }.toSet(),
                    refused.joinToString("\n"),
                )
            }
        }

    @Test
    fun `every Robolang program of the tests becomes an image`() = runTest(timeout = 5.minutes) {
        val programs = robolangPrograms.filter { (name, text) -> robolangOf(name, text) != null }
        assertTrue(programs.size > 200, "${programs.size}")
        val refused = programs.mapNotNull { (name, text) -> refusalOf(name, text, LejosVersion.DEFAULT) }
        assertEquals("", refused.joinToString("\n"))
    }

    @Test
    fun `the sizes in the documentation are those of the largest examples`() = runTest(timeout = 5.minutes) {
        val programs = robolangExamples + lejosExamples
        val images = programs.map { (name, text) -> name to checkNotNull(imageOf(name, text)) }
        val mean = "The ${images.size} examples take ${images.sumOf {
            it.second.bytes.size
        } / images.size} bytes in the mean"
        assertContains(imageDocument.getValue("lejos-image.md"), mean)
        val rows = images.sortedByDescending { it.second.bytes.size }.take(ROWS).map { (name, image) ->
            "| `$name` | ${image.bytes.size} | ${image.bytesForObjects(LejosVersion.V3_0)} |"
        }
        val table = imageDocument.getValue("lejos-image.md").lines().filter { it.startsWith("| `") && it in rows }
        assertEquals(rows, table, "docs/lejos-image.md needs these rows:\n${rows.joinToString("\n")}")
    }

    private suspend fun imageOf(name: String, text: String): LejosImage? =
        (compiler.buildImage(listOf(sourceOf(name, text))) as? ImageBuildResult.Success)?.image

    private suspend fun refusalOf(name: String, text: String, version: LejosVersion): String? =
        when (val result = compiler.buildImage(listOf(sourceOf(name, text)), version)) {
            is ImageBuildResult.Success -> null

            is ImageBuildResult.Failure -> "$name: ${result.diagnostics.joinToString("; ") {
                "${it.range?.line} ${it.message}"
            }}"

            is ImageBuildResult.NotLoaded -> throw result.cause
        }

    private fun sourceOf(path: String, text: String): ProgramSource {
        val name = path.substringAfterLast('/')
        return if (name.endsWith(".robo")) {
            Program(name, ProgramLanguage.ROBOLANG, text)
        } else {
            Program(name, ProgramLanguage.JAVA, text)
        }
    }

    private companion object {
        /** How the names of worlds begin whose robots have another brick than an RCX. */
        val FOR_OTHERS = listOf("nxt-", "spike-", "buggy-")

        const val ROWS = 10

        /** Programs that use classes which leJOS 2.1 does not have. */
        val NOT_IN_2_1 = setOf<String>()
    }
}
