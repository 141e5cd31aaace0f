package robotran.build.texts

import org.gradle.api.DefaultTask
import org.gradle.api.file.ConfigurableFileTree
import org.gradle.api.file.DirectoryProperty
import org.gradle.api.provider.Property
import org.gradle.api.tasks.CacheableTask
import org.gradle.api.tasks.Input
import org.gradle.api.tasks.InputFiles
import org.gradle.api.tasks.Internal
import org.gradle.api.tasks.Optional
import org.gradle.api.tasks.OutputDirectory
import org.gradle.api.tasks.PathSensitive
import org.gradle.api.tasks.PathSensitivity
import org.gradle.api.tasks.TaskAction

/** Generates a Kotlin constant from text files or their fenced blocks, since common Kotlin cannot read files. */
@CacheableTask
abstract class GenerateTexts : DefaultTask() {
    @get:Internal
    abstract val texts: Property<ConfigurableFileTree>

    @get:InputFiles
    @get:PathSensitive(PathSensitivity.RELATIVE)
    val files get() = texts.get()

    /** The package and name of the constant, a `Map<String, String>` from path to text. */
    @get:Input
    abstract val qualifiedName: Property<String>

    /** The mark of the fenced blocks to extract; absent for whole files. */
    @get:Input
    @get:Optional
    abstract val fence: Property<String>

    /** Whether the texts are packed, and unpacked when one of them is first read. */
    @get:Input
    abstract val packed: Property<Boolean>

    @get:OutputDirectory
    abstract val outputFolder: DirectoryProperty

    init {
        packed.convention(false)
    }

    @TaskAction
    fun generate() {
        val found = mutableMapOf<String, String>()
        files.visit { if (!it.isDirectory) found += textsIn(it.path, it.file.readText()) }
        val folder = outputFolder.get().asFile
        folder.deleteRecursively()
        val name = qualifiedName.get()
        val sources = if (packed.get()) PackedTextSources(name).files(found) else TextSources(name).files(found)
        for ((name, source) in sources) {
            folder.resolve(name).apply { parentFile.mkdirs() }.writeText(source)
        }
    }

    private fun textsIn(path: String, text: String): Map<String, String> =
        if (fence.isPresent) fencedBlocks(path, text, fence.get()) else mapOf(path to text)
}
