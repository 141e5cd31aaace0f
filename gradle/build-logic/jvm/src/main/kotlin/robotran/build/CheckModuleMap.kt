package robotran.build

import org.gradle.api.DefaultTask
import org.gradle.api.GradleException
import org.gradle.api.file.ConfigurableFileCollection
import org.gradle.api.file.DirectoryProperty
import org.gradle.api.file.RegularFileProperty
import org.gradle.api.tasks.CacheableTask
import org.gradle.api.tasks.InputFile
import org.gradle.api.tasks.InputFiles
import org.gradle.api.tasks.Internal
import org.gradle.api.tasks.OutputFile
import org.gradle.api.tasks.PathSensitive
import org.gradle.api.tasks.PathSensitivity
import org.gradle.api.tasks.TaskAction
import robotran.build.messages.readCatalogue
import java.io.File

/**
 * Fails if a module has an import that the module map in `docs/modules.md` does not allow, is missing on the map,
 * has cyclic package dependencies, or names a constant that only registries may name.
 */
@CacheableTask
abstract class CheckModuleMap : DefaultTask() {
    @get:InputFile
    @get:PathSensitive(PathSensitivity.RELATIVE)
    abstract val map: RegularFileProperty

    /** All Kotlin and Java files and catalogues of messages of all modules. */
    @get:InputFiles
    @get:PathSensitive(PathSensitivity.RELATIVE)
    abstract val sources: ConfigurableFileCollection

    @get:Internal
    abstract val root: DirectoryProperty

    @get:OutputFile
    abstract val report: RegularFileProperty

    @TaskAction
    fun check() {
        val map = ModuleMap.parse(map.get().asFile.readText())
        val rootFolder = root.get().asFile
        val files = sources.files.map { SourceFile(it.relativeTo(rootFolder).invariantSeparatorsPath, codeOf(it)) }
        val violations =
            files.flatMap { file ->
                val module = map.modules.find { file.path.startsWith(it.folder + "/") }
                if (module == null) {
                    listOf("${file.path}: its module is not on the map")
                } else {
                    map.violations(module, file)
                }
            } + PackageGraph(files).cycles()
        report.get().asFile.writeText(
            violations.ifEmpty {
                listOf("${files.size} files keep to the module map")
            }.joinToString("\n", postfix = "\n"),
        )
        if (violations.isNotEmpty()) {
            throw GradleException(
                violations.joinToString("\n", prefix = "Against the module map of docs/modules.md:\n"),
            )
        }
    }

    /** The package and the imports of the Kotlin that a catalogue of messages becomes; other files are code. */
    private fun codeOf(file: File): String {
        if (file.extension != "md") return file.readText()
        val catalogue = readCatalogue(file.path, file.readText())
        return "package ${catalogue.packageName}\n" + catalogue.imports.joinToString("") { "import $it\n" }
    }
}
