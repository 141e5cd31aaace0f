package robotran.build.messages

import org.gradle.api.DefaultTask
import org.gradle.api.GradleException
import org.gradle.api.file.ConfigurableFileCollection
import org.gradle.api.file.DirectoryProperty
import org.gradle.api.file.RegularFileProperty
import org.gradle.api.tasks.CacheableTask
import org.gradle.api.tasks.InputFile
import org.gradle.api.tasks.InputFiles
import org.gradle.api.tasks.OutputDirectory
import org.gradle.api.tasks.PathSensitive
import org.gradle.api.tasks.PathSensitivity
import org.gradle.api.tasks.TaskAction

/** Generates the Kotlin of a module's catalogues of messages. */
@CacheableTask
abstract class GenerateMessages : DefaultTask() {
    @get:InputFiles
    @get:PathSensitive(PathSensitivity.NAME_ONLY)
    abstract val catalogues: ConfigurableFileCollection

    /** The table of languages. */
    @get:InputFile
    @get:PathSensitive(PathSensitivity.NONE)
    abstract val languages: RegularFileProperty

    @get:OutputDirectory
    abstract val outputFolder: DirectoryProperty

    @TaskAction
    fun generate() {
        val folder = outputFolder.get().asFile
        folder.deleteRecursively()
        try {
            val all = readLanguages(languages.get().asFile.name, languages.get().asFile.readText())
            for (file in catalogues.files.sorted()) {
                write(file.name, file.readText(), all).forEach { (name, code) ->
                    folder.resolve(name).apply { parentFile.mkdirs() }.writeText(code)
                }
            }
        } catch (mistake: CatalogueException) {
            throw GradleException(mistake.message.orEmpty(), mistake)
        }
    }

    private fun write(name: String, text: String, languages: List<SpokenLanguage>): Map<String, String> =
        MessagesWriter(readCatalogue(name, text), languages).files()
}
