package robotran.build

import org.gradle.api.DefaultTask
import org.gradle.api.file.ConfigurableFileCollection
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

/**
 * Makes Kotlin of programs that are tests, so that they run where a test cannot read files: one list each of the programs in
 * files, of the example programs and of those in the fenced blocks of a document.
 */
@CacheableTask
abstract class GenerateTestPrograms : DefaultTask() {
    /** The package of what is generated, and of the class `TestProgram(path, text)` it needs, which the tests declare. */
    @get:Input
    abstract val packageName: Property<String>

    /** How the names of programs end, and what the fenced blocks that hold one are marked with. */
    @get:Input
    abstract val language: Property<ProgramLanguage>

    /** Programs with their expectations. */
    @get:InputFiles
    @get:PathSensitive(PathSensitivity.RELATIVE)
    abstract val programs: ConfigurableFileCollection

    /** Programs that people are shown. */
    @get:InputFiles
    @get:PathSensitive(PathSensitivity.RELATIVE)
    abstract val examples: ConfigurableFileCollection

    /** Markdown with programs in fenced blocks. */
    @get:InputFiles
    @get:PathSensitive(PathSensitivity.RELATIVE)
    abstract val documents: ConfigurableFileCollection

    /** What the programs' paths are relative to. */
    @get:Internal
    abstract val root: DirectoryProperty

    @get:OutputDirectory
    abstract val destination: DirectoryProperty

    @TaskAction
    fun generate() {
        val folder = destination.get().asFile
        folder.deleteRecursively()
        val sources = TestProgramSources(packageName.get())
        val extension = language.get().extension
        val files = sources.files("testPrograms", read(programs, extension)) +
            sources.files("examplePrograms", read(examples, extension)) +
            sources.files("documentedPrograms", read(documents, "md").flatMap { fencedPrograms(it, language.get().fence) })
        for ((name, text) in files) {
            folder.resolve(name).apply { parentFile.mkdirs() }.writeText(text)
        }
    }

    private fun read(files: ConfigurableFileCollection, extension: String): List<ProgramText> =
        files.files.filter { it.extension == extension }
            .map { ProgramText(it.relativeTo(root.get().asFile).invariantSeparatorsPath, it.readText()) }
            .sortedBy { it.path }
}
