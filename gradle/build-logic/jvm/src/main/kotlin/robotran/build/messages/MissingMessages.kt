package robotran.build.messages

import org.gradle.api.DefaultTask
import org.gradle.api.file.ConfigurableFileCollection
import org.gradle.api.file.RegularFileProperty
import org.gradle.api.provider.Property
import org.gradle.api.tasks.InputFile
import org.gradle.api.tasks.InputFiles
import org.gradle.api.tasks.Internal
import org.gradle.api.tasks.PathSensitive
import org.gradle.api.tasks.PathSensitivity
import org.gradle.api.tasks.TaskAction
import org.gradle.work.DisableCachingByDefault
import java.io.File

/** Prints the messages and texts that are said in English because another language lacks them. */
@DisableCachingByDefault(because = "it only prints")
abstract class MissingMessages : DefaultTask() {
    /** The catalogues of all modules. */
    @get:InputFiles
    @get:PathSensitive(PathSensitivity.RELATIVE)
    abstract val catalogues: ConfigurableFileCollection

    /** Lessons, tasks of worlds, help on words. */
    @get:InputFiles
    @get:PathSensitive(PathSensitivity.RELATIVE)
    abstract val texts: ConfigurableFileCollection

    /** The folder of the project, before which paths are not printed. */
    @get:Internal
    abstract val root: Property<String>

    /** The table of languages. */
    @get:InputFile
    @get:PathSensitive(PathSensitivity.NONE)
    abstract val languages: RegularFileProperty

    @TaskAction
    fun print() {
        val tables = catalogues.files.sorted().flatMap { readCatalogue(it.path, it.readText()).tables }
        for (language in readLanguages(languages.get().asFile.path, languages.get().asFile.readText())) {
            val missing = tables.flatMap { table -> missingIn(table, language).map { "${table.name}.$it" } }
            logger.lifecycle("${language.ownName}: ${missing.size} of ${tables.sumOf { it.messages.size }} are missing")
            missing.forEach { logger.lifecycle("  $it") }
            val files = texts.files.associate {
                it.relativeTo(File(root.get())).invariantSeparatorsPath to it.readText()
            }
            missingTexts(files, language.tag).forEach { logger.lifecycle("  $it") }
        }
    }
}

/**
 * What the texts in [files], by their paths, lack in the language [tag]: whole files, and sentences of files that have
 * all languages of a sentence beside each other.
 */
fun missingTexts(files: Map<String, String>, tag: String): List<String> {
    val whole = files.keys.filter { it.endsWith(".$ENGLISH.md") }.map { it.removeSuffix("$ENGLISH.md") + "$tag.md" }
    val sentences = files.mapNotNull { (path, text) ->
        val lacks = count(text, ENGLISH) - count(text, tag)
        if (lacks > 0) "$path: $lacks sentences" else null
    }
    return whole.filter { it !in files } + sentences
}

private fun count(text: String, tag: String): Int =
    Regex("^( \\* )?- $tag: ", RegexOption.MULTILINE).findAll(text).count()

/** The names of the messages of [table] that [language] lacks. Terms are as each language needs them. */
fun missingIn(table: MessageTable, language: SpokenLanguage): List<String> =
    table.messages.filter { !it.isTerm && language.tag !in it.patterns }.map { it.name }
