package robotran.build.site

import org.gradle.api.DefaultTask
import org.gradle.api.GradleException
import org.gradle.api.file.DirectoryProperty
import org.gradle.api.provider.ListProperty
import org.gradle.api.provider.Property
import org.gradle.api.tasks.CacheableTask
import org.gradle.api.tasks.Input
import org.gradle.api.tasks.InputDirectory
import org.gradle.api.tasks.Internal
import org.gradle.api.tasks.OutputDirectory
import org.gradle.api.tasks.PathSensitive
import org.gradle.api.tasks.PathSensitivity
import org.gradle.api.tasks.TaskAction
import org.gradle.process.ExecOperations
import robotran.build.WebTools
import java.io.File
import javax.inject.Inject

/**
 * Copies webpack's output and replaces the app's wasm by a smaller and faster one, which takes binaryen minutes. The
 * name of the wasm, which contains a hash of it, is replaced in the script.
 */
@CacheableTask
abstract class OptimizeApp
    @Inject
    constructor(private val processes: ExecOperations) : DefaultTask() {
        @get:InputDirectory
        @get:PathSensitive(PathSensitivity.RELATIVE)
        abstract val app: DirectoryProperty

        /** The arguments of `wasm-opt` without files. */
        @get:Input
        abstract val arguments: ListProperty<String>

        @get:OutputDirectory
        abstract val optimizedApp: DirectoryProperty

        @get:Internal
        abstract val wasmOpt: Property<String>

        init {
            dependsOn(":${WebTools.SET_UP_TASK}")
            wasmOpt.set(WebTools.wasmOpt(project).path)
        }

        @TaskAction
        fun optimize() {
            val output = optimizedApp.get().asFile
            output.deleteRecursively()
            app.get().asFile.copyRecursively(output)
            val wasm = output.listFiles().orEmpty().single { NAME.matches(it.name) }
            val optimized = temporaryDir.resolve("optimized.wasm")
            processes.exec { it.commandLine(listOf(wasmOpt.get(), wasm.path, "-o", optimized.path) + arguments.get()) }
            val name = "robotran.${hexOf(sha256(optimized.readBytes())).take(DIGITS)}.wasm"
            optimized.copyTo(output.resolve(name))
            rename(output.resolve("robotran.js"), wasm.name, name)
            wasm.delete()
        }

        private fun rename(script: File, old: String, new: String) {
            val text = script.readText()
            if (old !in text) throw GradleException("${script.name} does not load $old.")
            script.writeText(text.replace(old, new))
        }

        private companion object {
            val NAME = Regex("""robotran\.[0-9a-f]{16}\.wasm""")
            const val DIGITS = 16
        }
    }
