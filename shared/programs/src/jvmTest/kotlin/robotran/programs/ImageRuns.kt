package robotran.programs

import robotran.brick.controls.BrickButton
import robotran.javacompiler.CompilationResult
import robotran.javacompiler.loadJavaCompiler
import robotran.javacompiler.messages.JavaMessages
import robotran.language.Language
import robotran.languagesupport.SourceFile
import robotran.programs.image.ImageComparison
import robotran.rcxrom.RcxBrick
import kotlin.test.assertEquals
import kotlin.test.assertTrue

/**
 * The virtual machine in the mode true to the brick does what the brick's image does: class files are linked to an image,
 * class files with made-up names are made of the image again, and both runs make the same ROM calls at the same times.
 */
internal class ImageRuns {
    private val comparison = ImageComparison(BrickLibrary.classFilesOfBrick)

    suspend fun compare(programs: Map<String, String>, min: Int) {
        val compiler = loadJavaCompiler(messages = JavaMessages.of(Language.ENGLISH))
        val differences = programs.mapNotNull { (path, text) ->
            val name = path.substringAfterLast('/')
            val compiled = compiler.compile(listOf(SourceFile(name, text)), BrickLibrary.classFilesOfBrick)
            val classes = (compiled as? CompilationResult.Success)?.classes ?: return@mapNotNull null
            val main = name.removeSuffix(".java")
            if (main !in compiled.mainClasses) return@mapNotNull null
            comparison.differenceOf(classes, main, happen = eventsIn(text))?.let { "$path: $it" }
        }
        assertEquals("", differences.joinToString("\n"))
        assertTrue(comparison.compared >= min, "only ${comparison.compared} programs were compared")
    }

    private fun eventsIn(text: String): (RcxBrick, Long) -> Unit {
        val sensors = sensorsIn(text).groupBy { it.milliseconds }
        val buttons = BUTTON.findAll(text).map { it.destructured }.groupBy { it.component2().toLong() }
        return { brick, time ->
            sensors[time]?.forEach { brick.setRawSensorValue(it.port - 1, it.raw) }
            buttons[time]?.forEach { (name, _, action) ->
                val button = BrickButton.valueOf(name)
                if (action == "pressed") brick.press(button) else brick.release(button)
            }
        }
    }

    private companion object {
        val BUTTON = Regex("""button (\w+) at (\d+): (\w+)""")
    }
}
