package robotran.build.messages

import org.gradle.api.DefaultTask
import org.gradle.api.file.ConfigurableFileCollection
import org.gradle.api.file.RegularFileProperty
import org.gradle.api.tasks.InputFile
import org.gradle.api.tasks.InputFiles
import org.gradle.api.tasks.PathSensitive
import org.gradle.api.tasks.PathSensitivity
import org.gradle.api.tasks.TaskAction
import org.gradle.work.DisableCachingByDefault

/** Prints the messages that are said in English because another language lacks them. */
@DisableCachingByDefault(because = "it only prints")
abstract class MissingMessages : DefaultTask() {
    /** The catalogues of all modules. */
    @get:InputFiles
    @get:PathSensitive(PathSensitivity.RELATIVE)
    abstract val catalogues: ConfigurableFileCollection

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
        }
    }
}

/** The names of the messages of [table] that [language] lacks. Terms are as each language needs them. */
fun missingIn(table: MessageTable, language: SpokenLanguage): List<String> =
    table.messages.filter { !it.isTerm && language.tag !in it.patterns }.map { it.name }
