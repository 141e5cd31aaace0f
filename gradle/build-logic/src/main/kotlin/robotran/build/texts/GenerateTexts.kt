package robotran.build.texts

import org.gradle.api.DefaultTask
import org.gradle.api.file.ConfigurableFileTree
import org.gradle.api.file.DirectoryProperty
import org.gradle.api.provider.Property
import org.gradle.api.tasks.CacheableTask
import org.gradle.api.tasks.Input
import org.gradle.api.tasks.InputFiles
import org.gradle.api.tasks.Internal
import org.gradle.api.tasks.OutputDirectory
import org.gradle.api.tasks.PathSensitive
import org.gradle.api.tasks.PathSensitivity
import org.gradle.api.tasks.TaskAction

/** Writes text files into a Kotlin source as a `Map<String, String>` from path to content, since common Kotlin cannot read files. */
@CacheableTask
abstract class GenerateTexts : DefaultTask() {
    @get:Internal
    abstract val texts: Property<ConfigurableFileTree>

    @get:InputFiles
    @get:PathSensitive(PathSensitivity.RELATIVE)
    val files get() = texts.get()

    /** Package and name of the constant, such as `robotran.world.examples`. */
    @get:Input
    abstract val qualifiedName: Property<String>

    @get:OutputDirectory
    abstract val outputFolder: DirectoryProperty

    @TaskAction
    fun generate() {
        val packageName = qualifiedName.get().substringBeforeLast('.')
        val name = qualifiedName.get().substringAfterLast('.')
        val entries = sortedMapOf<String, String>()
        files.visit { if (!it.isDirectory) entries[it.path] = it.file.readText().replace("\r\n", "\n") }
        val source = buildString {
            appendLine("package $packageName").appendLine()
            appendLine("internal val $name: Map<String, String> = mapOf(")
            entries.forEach { (path, text) ->
                // Pieces, since a class file holds no constant beyond 65535 bytes.
                val pieces = text.chunked(PIECE).joinToString(", ") { "\"" + escape(it) + "\"" }
                appendLine("    \"${escape(path)}\" to listOf($pieces).joinToString(\"\"),")
            }
            appendLine(")")
        }
        outputFolder.get().asFile.resolve("$name.kt").apply { parentFile.mkdirs() }.writeText(source)
    }

    private fun escape(text: String): String = buildString {
        text.forEach { character ->
            when (character) {
                '\\', '"', '$' -> append('\\').append(character)
                in ' '..'~' -> append(character)
                else -> append("\\u").append(character.code.toString(HEXADECIMAL).padStart(UNICODE_DIGITS, '0'))
            }
        }
    }

    private companion object {
        const val PIECE = 8000
        const val HEXADECIMAL = 16
        const val UNICODE_DIGITS = 4
    }
}
