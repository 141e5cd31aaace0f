package robotran.build.site

import org.gradle.api.DefaultTask
import org.gradle.api.GradleException
import org.gradle.api.file.ConfigurableFileCollection
import org.gradle.api.file.DirectoryProperty
import org.gradle.api.tasks.CacheableTask
import org.gradle.api.tasks.InputDirectory
import org.gradle.api.tasks.InputFiles
import org.gradle.api.tasks.OutputDirectory
import org.gradle.api.tasks.PathSensitive
import org.gradle.api.tasks.PathSensitivity
import org.gradle.api.tasks.TaskAction
import java.io.File

/**
 * Copies webpack's output with other [modules]. The name of a module, which contains a hash of it, is replaced in the
 * scripts. A module that webpack does not know is added.
 */
@CacheableTask
abstract class ReplaceWasm : DefaultTask() {
    @get:InputDirectory
    @get:PathSensitive(PathSensitivity.RELATIVE)
    abstract val app: DirectoryProperty

    /** WebAssembly modules, such as `robotran.wasm`, or folders of them. */
    @get:InputFiles
    @get:PathSensitive(PathSensitivity.RELATIVE)
    abstract val modules: ConfigurableFileCollection

    @get:OutputDirectory
    abstract val replaced: DirectoryProperty

    @TaskAction
    fun replace() {
        val output = replaced.get().asFile
        output.deleteRecursively()
        app.get().asFile.copyRecursively(output)
        for (module in modules.asFileTree.files.sorted()) replace(output, module)
    }

    private fun replace(output: File, module: File) {
        val stem = module.nameWithoutExtension
        val name = "$stem.${hexOf(sha256(module.readBytes())).take(DIGITS)}.wasm"
        val named = Regex("""${Regex.escape(stem)}\.[0-9a-f]{$DIGITS}\.wasm""")
        val old = output.listFiles().orEmpty().firstOrNull { named.matches(it.name) }
        old?.delete()
        module.copyTo(output.resolve(name))
        if (old != null) rename(output, old.name, name)
    }

    private fun rename(output: File, old: String, new: String) {
        val scripts = output.listFiles().orEmpty().filter { it.extension == "js" && old in it.readText() }
        if (scripts.isEmpty()) throw GradleException("No script of the app loads $old.")
        for (script in scripts) script.writeText(script.readText().replace(old, new))
    }

    private companion object {
        const val DIGITS = 16
    }
}
